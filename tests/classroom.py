"""A class of a few students with the real course: hand in any notebook, grade, and look at what came of it."""

import copy
import json
import shutil
from functools import cache
from pathlib import Path

from autograder.batch import grade_class
from autograder.engine import Options
from autograder.grading import Result
from autograder.reference import NOTEBOOKS
from autograder.sample import solutions
from autograder.session import Limits

ROOT = Path(__file__).resolve().parent.parent
ASSIGNMENT = "odometry"
#: long enough for honest work on a slow machine, short enough that what never ends does not hold up the tests
LIMITS = Limits(cell=4.0, check=4.0, notebook=40.0, grace=2.0)


@cache
def _solved(language: str, notebook: str) -> str:
    answers = solutions(ROOT, f"{ASSIGNMENT}/{notebook}", language)
    made = json.loads((ROOT / f"release/{language}/{ASSIGNMENT}/{notebook}.ipynb").read_text(encoding="utf-8"))
    for cell in made["cells"]:
        cell["source"] = answers.get(cell["metadata"].get("nbgrader", {}).get("grade_id"), "".join(cell["source"]))
    return json.dumps(made, ensure_ascii=False)


def solved(language: str = "en", notebook: str = "pose_update") -> dict:
    """Return a released notebook with all answers right, as a dictionary to do with as one likes; sources are strings."""
    return json.loads(_solved(language, notebook))


def untouched(language: str = "en", notebook: str = "pose_update") -> dict:
    """Return a released notebook as it came, with no answer; sources are strings."""
    made = json.loads((ROOT / f"release/{language}/{ASSIGNMENT}/{notebook}.ipynb").read_text(encoding="utf-8"))
    for cell in made["cells"]:
        cell["source"] = "".join(cell["source"])
    return made


def code_cell(source: str) -> dict:
    """Return an ordinary code cell of a student."""
    return {"cell_type": "code", "id": "own", "metadata": {}, "source": source, "outputs": [], "execution_count": None}


def graded_cell(notebook: dict, grade_id: str) -> dict:
    """Return the cell of a notebook that has this grade id."""
    return next(cell for cell in notebook["cells"] if cell["metadata"].get("nbgrader", {}).get("grade_id") == grade_id)


def with_cell(notebook: dict, source: str, at: int = 1) -> dict:
    """Return the notebook with one more code cell, put in at this place (negative: counted from the end)."""
    made = copy.deepcopy(notebook)
    made["cells"].insert(at if at >= 0 else len(made["cells"]) + 1 + at, code_cell(source))
    return made


def with_answer(notebook: dict, exercise: str, source: str) -> dict:
    """Return the notebook with this source in the answer cell of the exercise."""
    made = copy.deepcopy(notebook)
    graded_cell(made, exercise)["source"] = source
    return made


class Classroom:
    """A course root of its own below `folder`."""

    def __init__(self, folder: Path) -> None:
        self.root = folder
        self.results: dict[tuple[str, str], Result] = {}
        folder.mkdir(parents=True, exist_ok=True)
        shutil.copytree(ROOT / "release", folder / "release")
        shutil.copy(ROOT / "nbgrader_config.py", folder)

    @classmethod
    def at(cls, folder: Path) -> "Classroom":
        """Return the class of a course root that is there already."""
        room = cls.__new__(cls)
        room.root, room.results = folder, {}
        return room

    def folder(self, student: str) -> Path:
        """Return the folder in which this student hands in, made if it is not there."""
        folder = self.root / "submitted" / student / ASSIGNMENT
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    def hand_in(self, student: str, content: dict | bytes, notebook: str = "pose_update") -> Path:
        """Put a notebook where the student hands it in and return its path."""
        path = self.folder(student) / f"{notebook}.ipynb"
        self.write(path, content)
        return path

    @staticmethod
    def write(path: Path, content: dict | bytes) -> None:
        """Write a notebook, or the bytes that are there in its place."""
        data = content if isinstance(content, bytes) else json.dumps(content, ensure_ascii=False).encode(errors="surrogatepass")
        path.write_bytes(data)

    def grade(self, limits: Limits = LIMITS, **options) -> None:
        """Grade the class into its gradebook; `results` holds what each exercise of each student got."""
        graded = grade_class(self.root, ASSIGNMENT, Options(limits=limits, **options))
        self.results = {(result.student, result.exercise): result for result in graded}

    def scores(self, student: str, notebook: str = "pose_update") -> dict[str, float | None]:
        """Return the points of one student's notebook by exercise, written answers left out."""
        return {name: self.results[student, name].score for name in NOTEBOOKS[f"{ASSIGNMENT}/{notebook}"]}

    def total(self, student: str, notebook: str = "pose_update") -> float:
        """Return the sum of the points of one student's notebook."""
        return sum(score or 0.0 for score in self.scores(student, notebook).values())

    def messages(self, student: str, notebook: str = "pose_update") -> list[str]:
        """Return what the student is told, exercise by exercise."""
        return [self.results[student, name].message for name in NOTEBOOKS[f"{ASSIGNMENT}/{notebook}"]]

    def executed(self, student: str, notebook: str = "pose_update") -> dict:
        """Return the executed notebook in autograded/."""
        return json.loads((self.root / f"autograded/{student}/{ASSIGNMENT}/{notebook}.ipynb").read_bytes())
