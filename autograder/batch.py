"""One run over a class: find what is new, grade it, write it down, and say how far it is.

A submission is done when its receipt is written; that comes last. So a run that was ended at any moment goes on where it stopped.
"""

import contextlib
import fcntl
import os
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, field, replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from autograder.engine import ClusterError, Options, dask_pool, graded, local_pool
from autograder.exercise import check_cell
from autograder.grading import GradedNotebook, OtherVersionError, Result, Work, result_from_row, result_row
from autograder.late import LatePenaltyError
from autograder.receipts import (
    CannotWriteError,
    Receipt,
    exercises_hash,
    read_receipt,
    receipts_folder,
    release_hash,
    write_receipt,
)
from autograder.reference import NOTEBOOKS
from autograder.seeds import SecretError, course_secret, exercise_seed
from autograder.standing import standing_scores
from autograder.submissions import MissingReleaseError, hashes, release_notebooks, students_with, submitted_notebooks
from autograder.warm_server import NoSandboxError, sandbox_problem
from course.language import Text

if TYPE_CHECKING:
    from autograder.gradebook import GradebookWriter


class BatchError(RuntimeError):
    """The class cannot be graded; the message says why and what to do."""


OnProgress = Callable[[int, int, str], None]


def grade_class(
    root: Path, assignment: str, options: Options | None = None, on_progress: OnProgress = lambda done, count, student: None
) -> list[Result]:
    """Grade a class and return all results, by student. `on_progress` is told (done, of how many, who was last).

    Submissions that have not changed since they were graded are not graded again, unless the options say so. Raises BatchError where
    grading cannot begin or go on; what was graded until then is in the gradebook.
    """
    options = options or Options()
    problem = sandbox_problem() if options.sandbox and not options.scheduler else None
    if problem is not None:
        raise BatchError(problem)
    try:
        release = release_notebooks(root, assignment)
    except (KeyError, MissingReleaseError) as error:
        raise BatchError(str(error.args[0])) from error
    students = students_with(root, assignment, options.student)
    if options.only is not None:
        students = {student: folder for student, folder in students.items() if student in options.only}
    if not students:
        where = root / "submitted" / options.student / assignment
        raise BatchError(f"nobody handed in {assignment!r}: there is no folder that fits {where}")
    try:
        with _only_grader(root), _Batch(root, assignment, options, release) as batch:
            return batch.results(students, on_progress)
    except (NoSandboxError, OtherVersionError, ClusterError, SecretError, CannotWriteError, LatePenaltyError) as error:
        raise BatchError(str(error)) from error
    except OSError as error:
        raise BatchError(f"{error}. What was graded so far is kept; type the same command again for the rest.") from error


@dataclass
class _Begun:
    """A submission that is being graded: its bytes, what its receipt will say, and what was graded before."""

    work: Work
    receipt: Receipt
    #: results of notebooks that have used up their attempts
    kept: tuple[Result, ...] = ()
    #: notebooks that were the same when the submission was graded before
    unchanged: frozenset[str] = frozenset()
    started: float = field(default_factory=time.monotonic)


class _Batch:
    """The state of one run."""

    def __init__(self, root: Path, assignment: str, options: Options, release: Mapping[tuple[str, str], bytes]) -> None:
        self._root, self._assignment, self._options, self._release = root, assignment, options, release
        self._secret = course_secret(receipts_folder(root))
        self._standing = {} if options.regrade else standing_scores(root, assignment)
        self._against = release_hash(release), exercises_hash()
        self._results: dict[str, list[Result]] = {}
        self._begun: dict[str, _Begun] = {}
        self._gradebook: GradebookWriter | None = None

    def __enter__(self) -> "_Batch":
        return self

    def __exit__(self, *_: object) -> None:
        if self._gradebook is not None:
            self._gradebook.__exit__(None, None, None)

    def results(self, students: Mapping[str, str], on_progress: OnProgress) -> list[Result]:
        """Grade what is new, take the rest from the receipts, and return everything by student."""
        on_progress(0, len(students), "")
        todo = self._to_grade(students, on_progress)
        first = next(todo, None)
        if first is not None:
            todo = _joined(first, todo)
            with contextlib.closing(graded(todo, self._open_pool(len(students)))) as done:
                for work, notebooks in done:
                    self._write(self._begun.pop(work.student), notebooks)
                    on_progress(len(self._results), len(students), work.student)
        return [result for student in students for result in self._results[student]]

    def _to_grade(self, students: Mapping[str, str], on_progress: OnProgress) -> Iterator[Work]:
        """Yield the submissions that have to be graded; the results of the others are put down meanwhile."""
        for slot, (student, folder) in enumerate(students.items()):
            notebooks = submitted_notebooks(self._root, folder, self._assignment)
            before = read_receipt(self._root, self._assignment, student)
            begun = self._begin(student, notebooks, before, slot % 10_000)
            if before is not None and before.same_work(begun.receipt) and self._stands(before):
                self._results[student] = [result_from_row(row) for row in before.results]
                on_progress(len(self._results), len(students), student)
                continue
            self._begun[student] = begun
            yield begun.work
            # while the first is on its way: what is wrong with the gradebook is said before the others are
            self._opened_gradebook()

    def _begin(self, student: str, notebooks: Mapping[str, bytes | Text], before: Receipt | None, slot: int) -> _Begun:
        given = hashes(notebooks)
        attempts = {name: list(tried) for name, tried in (before.attempts if before is not None else {}).items()}
        used_up = []
        for name, content in notebooks.items():
            tried = attempts.setdefault(name, [])
            if not isinstance(content, bytes) or given[name] in tried:
                continue
            if len(tried) < self._options.attempts:
                tried.append(given[name])
            else:
                used_up.append(name)
        seeds = {
            exercise: self._seed(student, exercise, attempts[name].index(given[name]) + 1)
            for name in notebooks
            if given[name] in attempts[name]
            for exercise in NOTEBOOKS[f"{self._assignment}/{name}"]
        }
        kept = [result_from_row(row) for row in (before.results if before is not None else ()) if row["notebook"] in used_up]
        work = Work(
            student,
            self._assignment,
            {name: content for name, content in notebooks.items() if name not in used_up},
            self._release,
            self._options.sandbox,
            slot,
            self._options.limits,
            seeds,
        )
        receipt = Receipt(
            student=student,
            assignment=self._assignment,
            notebooks=given,
            attempts=attempts,
            release=self._against[0],
            exercises=self._against[1],
            sandbox=self._options.sandbox,
            limits=asdict(self._options.limits),
            languages=before.languages if before is not None else {},
            results=(),
            begun=datetime.now(UTC).isoformat(timespec="seconds"),
        )
        known = before.notebooks if before is not None else {}
        return _Begun(
            work,
            receipt,
            tuple(self._used_up(result, receipt.languages[result.notebook]) for result in kept),
            frozenset(name for name, content in given.items() if known.get(name) == content),
        )

    def _seed(self, student: str, exercise: str, attempt: int) -> int:
        return exercise_seed(self._secret, student, self._assignment, exercise, attempt)

    def _used_up(self, result: Result, language: str) -> Result:
        """Return a result of the last version that counted, with the reason why a newer one does not."""
        if result.status == "attempts":
            return result
        reason = _NO_ATTEMPTS.format(count=self._options.attempts).to(language)
        return replace(result, status="attempts", message=f"{result.message}\n{reason}".lstrip())

    def _stands(self, receipt: Receipt) -> bool:
        """Return whether the gradebook still says what the receipt says, and the executed notebooks are there."""
        standing = self._standing.get(receipt.student)
        folder = self._root / "autograded" / receipt.student / self._assignment
        return (
            standing is not None
            and all(standing.get(_graded_cell(row), _ABSENT) == row.score for row in map(result_from_row, receipt.results))
            and all(_is_whole(folder / f"{name}.ipynb") for name in receipt.notebooks)
        )

    def _write(self, begun: _Begun, notebooks: list[GradedNotebook]) -> None:
        """Write a graded submission into the gradebook and autograded/, and then its receipt."""
        student = begun.work.student
        self._opened_gradebook().write(student, notebooks, begun.kept, begun.unchanged)
        results = [*begun.kept, *(result for notebook in notebooks for result in notebook.results)]
        receipt = replace(
            begun.receipt,
            languages={**begun.receipt.languages, **{notebook.notebook: notebook.language for notebook in notebooks}},
            results=[result_row(result) for result in results],
            seconds=round(time.monotonic() - begun.started, 3),
        )
        handed_in = {name: content for name, content in begun.work.notebooks.items() if isinstance(content, bytes)}
        replies = {exercise: reply for notebook in notebooks for exercise, reply in notebook.replies.items()}
        write_receipt(self._root, receipt, handed_in, replies)
        self._results[student] = results

    def _opened_gradebook(self) -> "GradebookWriter":
        if self._gradebook is None:
            # imported here: nbgrader takes seconds, and a run that finds nothing new does not need it
            from autograder.gradebook import GradebookWriter

            self._gradebook = GradebookWriter(self._root, self._assignment).__enter__()
        return self._gradebook

    def _open_pool(self, submissions: int) -> Callable[[], contextlib.AbstractContextManager]:
        if self._options.scheduler:
            return partial(dask_pool, self._options.scheduler)
        return partial(local_pool, min(self._options.workers or _processors(), submissions))


def _is_whole(path: Path) -> bool:
    """Return whether a notebook is there to its end, at which stands a brace: a disk that lost power may have lost it."""
    try:
        with path.open("rb") as file:
            file.seek(-16, os.SEEK_END)
            return file.read().rstrip().endswith(b"}")
    except OSError:
        return False


def _graded_cell(result: Result) -> str:
    """Return the name of the cell on which the points of a result hang."""
    written = result.exercise not in NOTEBOOKS[f"{result.assignment}/{result.notebook}"]
    return result.exercise if written else check_cell(result.exercise)


def _joined(first: Work, rest: Iterator[Work]) -> Iterator[Work]:
    yield first
    yield from rest


def _processors() -> int:
    """Return how many processors this process may use."""
    return len(os.sched_getaffinity(0))


@contextlib.contextmanager
def _only_grader(root: Path) -> Iterator[None]:
    """Hold the course's lock: two graders at a time would write over one another."""
    with open(receipts_folder(root) / "lock", "w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise BatchError(
                "another grader is at work in this course. Wait until it is done, then type the command again."
            ) from None
        yield


_ABSENT = object()
_NO_ATTEMPTS = Text(
    "All {count} attempts at this notebook are used up: the last one that was graded counts.",
    "このノートブックの提出回数の上限({count}回)に達しました。最後に採点した提出の結果をそのまま使います。",
)
