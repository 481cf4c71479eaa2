"""A class of six, graded once with nothing in the way, and everything that grading leaves behind: what a disturbed run is compared with."""

import json
import shutil
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from autograder import batch
from autograder.engine import GradedSubmission
from autograder.grading import GradedNotebook, Work
from autograder.settings import db_url
from tests.classroom import ROOT, Classroom, solved, untouched, with_answer
from tests.crash.program import LIMITS

_ALONG_X = "def pose_step(pose, D, dtheta):\n    x, y, theta = pose\n    return np.array([x + D, y, theta + dtheta])"
# not where the notebook itself calls it: that would take the time of a whole cell
_LOOPS = "def displacement(V, omega, dt):\n    while V < 0:\n        pass\n    return np.array([V * dt, 0.0, omega * dt])"

TOTALS = {"right": 40.0, "written": 40.0, "untouched": 0.0, "partly": 30.5555, "unreadable": 0.0, "loops": 37.0}


def submissions() -> dict[str, dict | bytes]:
    """Return what each student of the class hands in; `loops` is the first that is graded, and takes the longest."""
    right = solved("en")
    return {
        "loops": with_answer(right, "displacement", _LOOPS),
        "partly": with_answer(right, "pose_step", _ALONG_X),
        "right": right,
        "unreadable": b'{"cells": [',
        "untouched": untouched("ja"),
        "written": solved("ja"),
    }


def new_class(folder: Path, secret: bytes | None = None, students: Iterable[str] = TOTALS) -> Classroom:
    """Return a course where the class has handed in and nothing is graded yet. The same secret gives the same cases."""
    classroom = Classroom(folder)
    # a copy would take much of a small disk
    shutil.rmtree(folder / "release")
    (folder / "release").symlink_to(ROOT / "release")
    given = submissions()
    for student in students:
        classroom.hand_in(student, given[student])
    if secret is not None:
        put_secret(folder, secret)
    return classroom


def put_secret(root: Path, secret: bytes) -> None:
    (root / ".autograder").mkdir(mode=0o700, exist_ok=True)
    (root / ".autograder/secret").write_bytes(secret)


class State(NamedTuple):
    """What grading leaves behind, without ids and times: rows of the gradebook with how often each is there, files, receipts."""

    rows: Counter[tuple]
    files: dict[str, bytes]
    receipts: dict[str, object]

    def of(self, students: Iterable[str]) -> "State":
        """Return what is left of some students' submissions, and of the assignment itself."""
        names = {*students, None}
        return State(
            Counter({row: count for row, count in self.rows.items() if row[1] in names}),
            {path: content for path, content in self.files.items() if path.split("/")[1] in names},
            {path: content for path, content in self.receipts.items() if path.split("/")[3] in names},
        )


def differences(found: State, expected: State) -> list[str]:
    """Return in what two states differ, one line each, shortened: pytest would compare whole files for minutes."""
    lines = [f"missing row {row}" for row in (expected.rows - found.rows).elements()]
    lines += [f"row too many {row}" for row in (found.rows - expected.rows).elements()]
    for found_part, expected_part in ((found.files, expected.files), (found.receipts, expected.receipts)):
        for path in sorted({*found_part, *expected_part}):
            lines += _different(path, found_part.get(path, "no such file"), expected_part.get(path, "no such file"))
    return [line[:400] for line in lines]


def _different(path: str, found: object, expected: object) -> list[str]:
    if isinstance(found, dict) and isinstance(expected, dict):
        keys = sorted({*found, *expected})
        return [line for key in keys for line in _different(f"{path}: {key}", found.get(key), expected.get(key))]
    if found == expected:
        return []
    if isinstance(found, bytes) and isinstance(expected, bytes):
        pairs = zip(found.splitlines(), expected.splitlines(), strict=False)
        return [f"{path}: {next((pair for pair in pairs if pair[0] != pair[1]), 'one is longer')}"]
    return [f"{path}: {found!r:.150} instead of {expected!r:.150}"]


#: the second column is the student, or nobody
_TABLES = {
    "version": "SELECT NULL, version_num FROM alembic_version",
    "course": "SELECT NULL, id FROM course",
    "assignment": "SELECT NULL, name, course_id FROM assignment",
    "cell": """SELECT NULL, notebook.name, base_cell.name, base_cell.type, grade_cells.max_score FROM base_cell
               JOIN notebook ON notebook.id = base_cell.notebook_id LEFT JOIN grade_cells ON grade_cells.id = base_cell.id""",
    "source": """SELECT NULL, notebook.name, source_cell.name, source_cell.checksum FROM source_cell
                 JOIN notebook ON notebook.id = source_cell.notebook_id""",
    "student": "SELECT id FROM student",
    "submission": "SELECT student_id, CASE WHEN timestamp IS NULL THEN 'no time' ELSE 'a time' END FROM submitted_assignment",
    "notebook": """SELECT submitted_assignment.student_id, notebook.name, submitted_notebook.late_submission_penalty
                   FROM submitted_notebook JOIN notebook ON notebook.id = submitted_notebook.notebook_id
                   JOIN submitted_assignment ON submitted_assignment.id = submitted_notebook.assignment_id""",
} | {
    table: f"""SELECT submitted_assignment.student_id, notebook.name, base_cell.name, {columns} FROM {table}
               JOIN base_cell ON base_cell.id = {table}.cell_id
               JOIN submitted_notebook ON submitted_notebook.id = {table}.notebook_id
               JOIN notebook ON notebook.id = submitted_notebook.notebook_id
               JOIN submitted_assignment ON submitted_assignment.id = submitted_notebook.assignment_id"""
    for table, columns in {
        "grade": "grade.auto_score, grade.manual_score, grade.extra_credit, grade.needs_manual_grade",
        "comment": "comment.auto_comment, comment.manual_comment",
    }.items()
}


def state(root: Path) -> State:
    """Return what grading has left in a course. Files that a killed run left unfinished do not count: nothing reads them."""
    paths = [path for path in root.glob("autograded/**/*") if path.is_file() and not path.name.startswith(".new-")]
    kept = [path for path in root.glob(".autograder/receipts/**/*") if path.is_file() and not path.name.startswith(".new-")]
    return State(
        gradebook_rows(db_url(root)),
        {path.relative_to(root).as_posix(): path.read_bytes() for path in paths},
        {path.relative_to(root).as_posix(): _timeless(path) for path in kept},
    )


def gradebook_rows(url: str) -> Counter[tuple]:
    from sqlalchemy import create_engine, text

    engine = create_engine(url)
    try:
        with engine.connect() as connection:
            return Counter((table, *row) for table, query in _TABLES.items() for row in connection.execute(text(query)))
    finally:
        engine.dispose()


def _timeless(path: Path) -> object:
    if path.suffix != ".json":
        return path.read_bytes()
    return {name: value for name, value in json.loads(path.read_bytes()).items() if name not in ("begun", "seconds", "digest")}


class Undisturbed(NamedTuple):
    """A class that was graded with nothing in the way: where, with which secret, what it left, and what came from the workers."""

    root: Path
    secret: bytes
    state: State
    graded: dict[str, list[GradedNotebook]]
    messages: dict[tuple[str, str], str]
    seconds: float

    def replayed(self, works: Iterable[Work], open_pool: object) -> Iterator[GradedSubmission]:
        """Stand in for autograder.engine.graded: hand on what the workers said then, if they are asked the same."""
        for work in works:
            notebooks = self.graded[work.student]
            seeds = {result.exercise: result.seed for notebook in notebooks for result in notebook.results if result.seed}
            assert seeds.items() <= work.seeds.items(), "other cases than in the undisturbed run"
            yield work, notebooks


def graded_undisturbed(folder: Path) -> Undisturbed:
    """Grade the class once."""
    classroom, recorded, graded = new_class(folder), {}, batch.graded

    def recording(works: Iterable[Work], open_pool: object) -> Iterator[GradedSubmission]:
        for work, notebooks in graded(works, open_pool):
            recorded[work.student] = notebooks
            yield work, notebooks

    began = time.monotonic()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(batch, "graded", recording)
        classroom.grade(limits=LIMITS, workers=2)
    seconds = time.monotonic() - began
    messages = {key: result.message for key, result in classroom.results.items()}
    assert {student: round(classroom.total(student), 4) for student in TOTALS} == TOTALS
    secret = (folder / ".autograder/secret").read_bytes()
    return Undisturbed(folder, secret, state(folder), recorded, messages, seconds)
