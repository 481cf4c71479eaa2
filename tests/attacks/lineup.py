"""Hostile and odd submissions in one class with an honest student: each test names what it hands in and looks at what came of it."""

import copy
import math
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import pytest

from autograder.reference import NOTEBOOKS, exercise_named
from autograder.submissions import students_with
from tests.classroom import ASSIGNMENT, Classroom, graded_cell, solved, untouched

#: sorted after all others, so that whatever ends the batch leaves this one without a score
HONEST = "zz-honest"
#: what each exercise of the notebook is worth
POINTS = 5.0

Maker = Callable[[], dict | bytes]
Layer = Callable[[Path], object]


def bare(notebook: dict) -> dict:
    """Return the notebook with its imports and graded cells only: what lies between takes time and earns nothing."""
    made = copy.deepcopy(notebook)
    imports = next(cell for cell in made["cells"] if cell["cell_type"] == "code")
    made["cells"] = [imports, *[cell for cell in made["cells"] if "nbgrader" in cell["metadata"]]]
    return made


def answered(*exercises: str, language: str = "en") -> dict:
    """Return a bare notebook in which only these exercises are answered, and rightly."""
    right, made = solved(language), bare(untouched(language))
    for name in exercises:
        graded_cell(made, name)["source"] = graded_cell(right, name)["source"]
    return made


def grade_id(cell: dict) -> str:
    """Return the grade id of a cell, empty if it has none."""
    return str(cell["metadata"].get("nbgrader", {}).get("grade_id", ""))


def checks(notebook: dict) -> list[dict]:
    """Return the check cells of a notebook."""
    return [cell for cell in notebook["cells"] if grade_id(cell).startswith("check_")]


def answers(notebook: dict) -> list[dict]:
    """Return the answer cells of a notebook."""
    return [cell for cell in notebook["cells"] if grade_id(cell) in NOTEBOOKS[f"{ASSIGNMENT}/pose_update"]]


def all_cells(notebook: dict) -> list[dict]:
    """Return all cells of a notebook."""
    return list(notebook["cells"])


@dataclass
class Graded:
    """A class after grading, and what then stands in its gradebook."""

    room: Classroom
    students: frozenset[str]

    def id_of(self, folder: str) -> str:
        """The id under which a folder in submitted/ is graded: its name, but where no database takes that."""
        return self._ids.get(folder, folder)

    @cached_property
    def _ids(self) -> dict[str, str]:
        return {folder: student for student, folder in students_with(self.room.root, ASSIGNMENT).items()}

    @cached_property
    def book(self) -> dict[tuple[str, str], tuple[float | None, float]]:
        """(points, most points) by student and exercise, written answers included."""
        return {
            (submission.student.id, grade.name.removeprefix("check_")): (grade.auto_score, grade.max_score)
            for submission, notebook in self._rows
            for grade in notebook.grades
        }

    @cached_property
    def comments(self) -> dict[tuple[str, str], str | None]:
        """What the gradebook tells a student of an exercise, as Markdown."""
        return {
            (submission.student.id, comment.name): comment.comment
            for submission, notebook in self._rows
            for comment in notebook.comments
        }

    @cached_property
    def times(self) -> dict[str, Any]:
        """When each student handed in, as the gradebook has it."""
        return {submission.student.id: submission.timestamp for submission, _ in self._rows}

    @cached_property
    def _rows(self) -> list[tuple[Any, Any]]:
        from nbgrader.api import Gradebook

        # left open for as long as the rows are looked at
        self._gradebook = Gradebook(f"sqlite:///{self.room.root}/gradebook.db", "dead-reckoning")
        submissions = self._gradebook.assignment_submissions(ASSIGNMENT)
        return [(submission, notebook) for submission in submissions for notebook in submission.notebooks]


@dataclass(frozen=True)
class Outcome:
    """What came of one submission."""

    graded: Graded
    student: str

    @property
    def earned(self) -> dict[str, float | None]:
        """The points by exercise, those without points left out."""
        return {name: points for name, points in self.graded.room.scores(self.student).items() if points != 0.0}

    @property
    def messages(self) -> list[str]:
        return self.graded.room.messages(self.student)

    @property
    def executed(self) -> dict:
        """The notebook in autograded/."""
        return self.graded.room.executed(self.student)

    @property
    def comments(self) -> list[str]:
        """The comments in the gradebook, exercise by exercise."""
        return [self.graded.comments[self.student, name] or "" for name in NOTEBOOKS[f"{ASSIGNMENT}/pose_update"]]

    @property
    def outputs(self) -> list[dict]:
        """All outputs in the executed notebook."""
        return [output for cell in self.executed["cells"] for output in cell.get("outputs", [])]

    @property
    def shown(self) -> str:
        """All that a person may get to see of it, as one text."""
        return "\n".join([*self.messages, *self.comments, *map(str, self.outputs), *sources(self.executed)])

    def assert_earns(self, *exercises: str, points: float = POINTS) -> None:
        """Assert that just these exercises have full points, and that all is well with the rest of the class."""
        assert self.earned == dict.fromkeys(exercises, points)
        self._assert_no_harm()

    def assert_earns_at_most(self, *exercises: str) -> None:
        """Assert the same where it is not for us to say whether such a file should be read at all."""
        assert self.earned.items() <= dict.fromkeys(exercises, POINTS).items()
        self._assert_no_harm()

    def _assert_no_harm(self) -> None:
        assert_definite(self.graded, self.student)
        assert self.graded.room.total(HONEST) == 8 * POINTS
        assert_definite(self.graded, HONEST)


def sources(notebook: dict) -> list[str]:
    """Return the sources of a notebook's cells."""
    return ["".join(cell["source"]) for cell in notebook["cells"]]


def assert_definite(graded: Graded, student: str) -> None:
    """Assert that every exercise of this student has a score with a reason, and that the gradebook has the same."""
    for notebook in ("pose_update", "encoders"):
        for name, points in graded.room.scores(student, notebook).items():
            assert points is not None
            assert math.isfinite(points)
            most = float(exercise_named(name).points)
            assert 0.0 <= points <= most
            assert graded.book[student, name] == (points, most)
        assert all(message.strip() for message in graded.room.messages(student, notebook))


@dataclass
class Lineup:
    """The submissions of a test module, by student; the module calls it LINEUP, and a fixture grades all of them at once."""

    layers: dict[str, Layer] = field(default_factory=dict)

    def hands_in(self, submissions: Maker | Mapping[str, Maker]) -> Callable:
        """Mark a test that looks at what comes of a notebook, or of each of several by name. It gets them as `outcome`."""
        makers = submissions if isinstance(submissions, Mapping) else {"": submissions}
        return self.lays({variant: _written(maker) for variant, maker in makers.items()})

    def lays(self, submissions: Layer | Mapping[str, Layer]) -> Callable:
        """Mark a test in the same way; what is given lays something at the path of the student's notebook."""
        layers = submissions if isinstance(submissions, Mapping) else {"": submissions}

        def marked(test: Callable) -> Callable:
            students = [_student(test.__name__, variant) for variant in layers]
            assert not self.layers.keys() & set(students), students
            self.layers.update(zip(students, layers.values(), strict=True))
            return pytest.mark.parametrize("outcome", students, ids=[variant or "it" for variant in layers], indirect=True)(test)

        return marked

    def called(self, submissions: Mapping[str, Maker]) -> Callable:
        """Mark a test in the same way; each notebook is handed in under the student's name that is given with it."""
        self.layers.update({student: _written(maker) for student, maker in submissions.items()})
        ids = [ascii(student)[1:60] for student in submissions]
        return pytest.mark.parametrize("outcome", list(submissions), ids=ids, indirect=True)

    def graded(self, folder: Path, chosen: Collection[str]) -> Graded:
        """Have these students and the honest one hand in, and grade the class."""
        room = Classroom(folder)
        for student in chosen:
            self.layers[student](room.folder(student) / "pose_update.ipynb")
        room.hand_in(HONEST, solved())
        room.grade()
        return Graded(room, frozenset([*chosen, HONEST]))


def tampered(which: Callable[[dict], Collection[dict]], *exercises: str, **changes: Any) -> Maker:
    """Return a maker of a notebook with these exercises answered, in which the chosen cells are changed."""

    def made() -> dict:
        notebook = answered(*exercises)
        for cell in which(notebook):
            cell.update(copy.deepcopy(changes))
        return notebook

    return made


def relabelled(which: Callable[[dict], Collection[dict]], *exercises: str, **changes: Any) -> Maker:
    """Return a maker of a notebook with these exercises answered, in which nbgrader's labels of the chosen cells are changed."""

    def made() -> dict:
        notebook = answered(*exercises)
        for cell in which(notebook):
            cell["metadata"]["nbgrader"].update(copy.deepcopy(changes))
        return notebook

    return made


def _written(maker: Maker) -> Layer:
    def lay(path: Path) -> None:
        Classroom.write(path, maker())

    return lay


def _student(test: str, variant: str) -> str:
    return re.sub(r"\W+", "-", f"{test.removeprefix('test_')[:60]} {variant}".strip())[:120]
