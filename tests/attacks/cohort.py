"""Hostile notebooks handed in beside honest ones: each test says what its student hands in, and a module's are graded as one class."""

import re
import secrets
import sqlite3
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from textwrap import dedent

import pytest

from autograder.grading import Result
from autograder.reference import NOTEBOOKS
from autograder.session import Limits
from tests.classroom import ROOT, Classroom, code_cell, graded_cell, solved, untouched

EXERCISES = NOTEBOOKS["odometry/pose_update"]
POINTS, FULL = 5, 40
HONEST = ("AAA-honest", "zzz-honest")
#: processes and files of these attacks carry it, so that what is left of them is recognised
MARK = f"left{secrets.token_hex(4)}"


@dataclass(frozen=True)
class Submission:
    """A hostile notebook, and the points that its honest answers deserve: at least, at most."""

    notebook: dict
    least: float
    most: float


def attack(
    cell: str = "",
    *,
    right: tuple[str, ...] = ("displacement",),
    answers: Mapping[str, str] | None = None,
    late: bool = False,
    lost: bool | None = False,
) -> Submission:
    """Return a notebook with only what matters: the import, the right answers, the hostile cell, all other answers and checks.

    What is judged comes after the hostile cell, or before it if `late`. `lost`: the attack takes its own right answers with it; None: it
    may or may not. In the sources @ROOT@ is the folder that is graded, @REPO@ the repository and @MARK@ a text that is found again.
    """
    full, done, answers = untouched(), solved(), dict(answers or {})
    for name in right:
        answers.setdefault(name, graded_cell(done, name)["source"])
    of_notebook = [item for item in full["cells"] if "nbgrader" in item["metadata"] and item["cell_type"] == "code"]
    for item in of_notebook:
        name = item["metadata"]["nbgrader"]["grade_id"]
        item["source"] = dedent(answers.get(name, item["source"]))
    first = [item for item in of_notebook if item["metadata"]["nbgrader"]["grade_id"] in right]
    rest = [item for item in of_notebook if item not in first]
    hostile = [code_cell(dedent(cell).strip())]
    cells = [full["cells"][1], *first, *rest, *hostile] if late else [full["cells"][1], *first, *hostile, *rest]
    points = float(POINTS * len(right))
    return Submission(full | {"cells": cells}, 0.0 if lost or lost is None else points, 0.0 if lost else points)


def hands_in(submission: Submission | None = None, **variants: Submission) -> Callable:
    """Decorate a test with what its students hand in; it runs once for each and gets its `fate`."""
    named = variants if submission is None else {"": submission, **variants}

    def decorated(test: Callable) -> Callable:
        number = test.__name__.removeprefix("test_").replace("_", "-")[:60]
        students = {f"{number}-{name}".rstrip("-"): notebook for name, notebook in named.items()}
        cases = [pytest.param((student, made), id=student) for student, made in students.items()]
        return pytest.mark.parametrize("fate", cases, indirect=True)(test)

    return decorated


class Cohort:
    """A class of hostile students and two honest ones, graded."""

    def __init__(self, folder: Path, submissions: Mapping[str, Submission], limits: Limits) -> None:
        self.planted = f"PLANTED{secrets.token_hex(8)}"
        self.room, self.submissions = Classroom(folder), submissions
        for student, language in zip(HONEST, ("en", "ja"), strict=True):
            notebook = solved(language)
            notebook["cells"].insert(2, code_cell(f"kept = '{self.planted}'"))
            self.room.hand_in(student, notebook)
        for student, submission in submissions.items():
            self.room.hand_in(student, self._told(submission.notebook))
        (folder / "solutions.txt").write_text(self.planted)
        before = self.course_files()
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("NBGRADER_TOKEN", self.planted)
            self.room.grade(limits)
        self.untouched = self.course_files() == before

    def _told(self, notebook: dict) -> dict:
        values = {"@ROOT@": str(self.room.root), "@REPO@": str(ROOT), "@MARK@": MARK}
        cells = [dict(cell) for cell in notebook["cells"]]
        for cell in cells:
            for name, value in values.items():
                cell["source"] = cell["source"].replace(name, value)
        return notebook | {"cells": cells}

    def course_files(self) -> dict[str, tuple[int, int]]:
        """Return size and time of change of every file that grading only reads: of what was handed in, all but the time of arrival."""
        folders = [self.room.root / "release", self.room.root / "submitted"]
        folders += [ROOT / name for name in ("course", "autograder", "data", "source")]
        files = [path for folder in folders for path in folder.rglob("*") if path.is_file()]
        files = [path for path in files if path.suffix != ".pyc" and path.name != "timestamp.txt"]
        files += [self.room.root / "nbgrader_config.py", self.room.root / "solutions.txt"]
        return {str(path): (path.stat().st_size, path.stat().st_mtime_ns) for path in files}

    def recorded(self, student: str) -> float:
        """Return what the gradebook has for this student's notebook."""
        query = """select sum(coalesce(g.manual_score, g.auto_score, 0) + coalesce(g.extra_credit, 0)) from grade g
            join submitted_notebook n on g.notebook_id = n.id join submitted_assignment a on n.assignment_id = a.id
            where a.student_id = ?"""
        database = sqlite3.connect(self.room.root / "gradebook.db")
        try:
            return float(database.execute(query, (student,)).fetchone()[0])
        finally:
            database.close()


class Fate:
    """What came of one hostile submission."""

    def __init__(self, cohort: Cohort, student: str) -> None:
        self.cohort, self.student = cohort, student
        self.submission = cohort.submissions[student]

    @property
    def results(self) -> dict[str, Result]:
        """Return the results by exercise, those of the notebook that was not handed in left out."""
        return {name: self.cohort.room.results[self.student, name] for name in EXERCISES}

    @property
    def total(self) -> float:
        return self.cohort.room.total(self.student)

    @property
    def messages(self) -> str:
        return "\n".join(result.message for result in self.results.values())

    @property
    def stopped(self) -> set[str]:
        """Return the exercises that were not asked any more."""
        return {name for name, result in self.results.items() if result.status == "stopped"}

    @property
    def outputs(self) -> list[dict]:
        executed = self.cohort.room.executed(self.student)
        return [output for cell in executed["cells"] for output in cell.get("outputs", [])]

    @property
    def printed(self) -> str:
        """Return what the notebook wrote, its errors included."""
        written = [output.get("text", "") for output in self.outputs]
        errors = [f"{output['ename']}: {output['evalue']}" for output in self.outputs if output["output_type"] == "error"]
        return "".join(written) + "\n".join(errors)

    def line(self, name: str) -> str:
        """Return what the hostile cell printed as `name: ...`."""
        found = re.search(rf"^{re.escape(name)}: (.*)$", self.printed, re.MULTILINE)
        assert found, f"the attack did not say {name!r}; it wrote: {self.printed[-2000:]}"
        return found.group(1)

    def check(self) -> None:
        """Assert what holds whatever was handed in."""
        room = self.cohort.room
        for name, result in self.results.items():
            assert type(result.score) is float, name
            assert 0 <= result.score <= result.max_score, name
            assert result.message.strip(), name
        assert self.submission.least <= self.total <= self.submission.most, self.messages
        assert self.cohort.recorded(self.student) == pytest.approx(self.total)
        for honest in HONEST:
            assert room.total(honest) == FULL, room.messages(honest)
            assert self.cohort.recorded(honest) == FULL
        assert {student for student, _ in room.results} == {*self.cohort.submissions, *HONEST}
        assert self.cohort.untouched, "a file that is only to be read has changed"
        shown = self.messages + self.printed
        assert self.cohort.planted not in shown
        found = re.findall("^LEAK.*$", self.printed, re.MULTILINE)
        assert not found, found[:20]


def left_behind() -> list[str]:
    """Return the processes on this machine that an attack has left behind."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            name = (folder / "comm").read_text() + (folder / "cmdline").read_text().replace("\0", " ")
        except OSError:  # it has just ended
            continue
        if MARK in name:
            found.append(name)
    return found
