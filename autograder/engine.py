"""The engine: find the submissions of a class, grade them in an executor, and hand the results on one by one.

It speaks `concurrent.futures.Executor`, so that the workers may be processes here or elsewhere; only the caller writes anything.
"""

import multiprocessing
import os
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, wait
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from itertools import islice
from pathlib import Path

from autograder.grading import GradedNotebook, Work, graded_submission, notebook_names
from autograder.intake import UnreadableError, submitted_bytes
from autograder.session import Limits
from course.language import LANGUAGES, Text


@dataclass(frozen=True)
class Options:
    """How a class is graded: which students (a shell pattern), how many workers, in the sandbox or not, and the limits."""

    student: str = "*"
    workers: int = 0
    sandbox: bool = True
    limits: Limits = field(default_factory=Limits)


class MissingReleaseError(RuntimeError):
    """There are no released notebooks to grade against."""


def students_with(root: Path, assignment: str, pattern: str = "*") -> list[str]:
    """Return the students in submitted/ who handed in the assignment, sorted; links and files are no students."""
    folder = root / "submitted"
    if not folder.is_dir():
        return []
    names = [entry.name for entry in os.scandir(folder) if entry.is_dir(follow_symlinks=False)]
    with_work = [
        name for name in names if (folder / name / assignment).is_dir() and not (folder / name / assignment).is_symlink()
    ]
    return sorted(name for name in with_work if fnmatchcase(name, pattern))


def release_notebooks(root: Path, assignment: str) -> dict[tuple[str, str], bytes]:
    """Return our own notebooks by (language, name). Raises MissingReleaseError if some are not built yet."""
    paths = {
        (language, name): root / "release" / language / assignment / f"{name}.ipynb"
        for language in LANGUAGES
        for name in notebook_names(assignment)
    }
    missing = [str(path.relative_to(root)) for path in paths.values() if not path.is_file()]
    if missing:
        raise MissingReleaseError(f"not built yet: {', '.join(missing)}. Type: autograder build")
    return {key: path.read_bytes() for key, path in paths.items()}


def submitted_notebooks(root: Path, student: str, assignment: str) -> dict[str, bytes | Text]:
    """Return what a student handed in, by notebook name: the bytes, or the reason why there are none."""
    folder = root / "submitted" / student / assignment
    return {name: _bytes_or_reason(folder / f"{name}.ipynb") for name in notebook_names(assignment)}


def graded(
    root: Path, assignment: str, options: Options, executor: Executor | None = None
) -> Iterator[tuple[str, list[GradedNotebook]]]:
    """Grade the class and yield (student, graded notebooks) as they are done. Only so many submissions are in memory at a time.

    `executor` runs the submissions; None: processes on this machine, for the time that it takes.
    """
    release = release_notebooks(root, assignment)
    students = students_with(root, assignment, options.student)
    workers = min(options.workers or os.cpu_count() or 1, max(len(students), 1))
    works = (
        Work(
            student,
            assignment,
            submitted_notebooks(root, student, assignment),
            release,
            options.sandbox,
            number % 10_000,
            options.limits,
        )
        for number, student in enumerate(students)
    )
    if executor is not None:
        yield from _streamed(executor, works, 2 * workers)
        return
    # spawned, not forked: a progress bar has threads
    with ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn")) as pool:
        yield from _streamed(pool, works, 2 * workers)


def _streamed(pool: Executor, works: Iterator[Work], ahead: int) -> Iterator[tuple[str, list[GradedNotebook]]]:
    """Keep `ahead` submissions under way and yield each as it is done."""
    under_way: dict[Future[list[GradedNotebook]], str] = {}
    try:
        while True:
            for work in islice(works, ahead - len(under_way)):
                under_way[pool.submit(graded_submission, work)] = work.student
            if not under_way:
                return
            done, _ = wait(under_way, return_when=FIRST_COMPLETED)
            for future in done:
                yield under_way.pop(future), future.result()
    finally:
        for future in under_way:
            future.cancel()


def _bytes_or_reason(path: Path) -> bytes | Text:
    try:
        return submitted_bytes(path)
    except UnreadableError as error:
        return error.reason
