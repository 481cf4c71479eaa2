"""nbgrader's own commands run this grader: `nbgrader autograde`, and the Autograde button of formgrader.

Both make nbgrader's converter `Autograde`, which makes its exporter after it has looked which submissions there are and before it
touches any. nbgrader_config.py names ours as that exporter: it grades the whole selection in one run and leaves the converter
nothing to do, so that nothing that a student handed in is copied, read or believed by the stock grader.

What differs from the stock command: without --force, what has not changed since it was graded is left as it is (timestamps have no
say in it); a submission is always graded whole (--notebook only selects students), it is always run
(--no-execute is refused), every exercise gets a score whatever was handed in, and what hooks and preprocessors the configuration
names for autograding are not called. nbgrader selects students who handed in at least one *.ipynb, whatever its name; a folder
without any is seen by `autograder grade` alone.
"""

import os
import traceback
from collections import defaultdict
from collections.abc import Sequence
from itertools import groupby
from operator import attrgetter
from pathlib import Path
from typing import Any

from nbconvert.exporters import NotebookExporter
from nbgrader.converters import Autograde, NbGraderException
from nbgrader.preprocessors import Execute

from autograder.batch import BatchError, grade_class
from autograder.engine import Options
from autograder.gradebook import open_gradebook
from autograder.grading import Result
from autograder.settings import configured_db_url, course_id
from autograder.submissions import students_with

#: where the grader looks and writes; nbgrader could be told to do so elsewhere
_FOLDERS = {
    "directory_structure": os.path.join("{nbgrader_step}", "{student_id}", "{assignment_id}"),
    "submitted_directory": "submitted",
    "autograded_directory": "autograded",
}
_OTHER_NBGRADER = "This version of nbgrader does not work with autograder.plugin; install one that pyproject.toml names."


class GradingExporter(NotebookExporter):
    """An exporter that has graded everything by the time it is made, and exports nothing."""

    def __init__(self, parent: Any = None, **kwargs: Any) -> None:
        super().__init__(parent=parent, **kwargs)
        if not isinstance(parent, Autograde):
            raise NbGraderException(f"{type(self).__name__} is for c.Autograde.exporter_class in nbgrader_config.py only")
        try:
            _grade(parent)
        except NbGraderException as error:
            # nbgrader's command ends without a word of its own
            parent.log.error(str(error))
            raise
        except KeyboardInterrupt:
            parent.log.error("Stopped. What was graded so far is in the gradebook; do the same again for the rest.")
            raise
        except Exception as error:
            parent.log.error(traceback.format_exc())
            message = f"The grader failed ({type(error).__name__}: {error}). What was graded so far is in the gradebook."
            parent.log.error(message)
            raise NbGraderException(message) from error
        finally:
            parent.assignments = {}

    def from_notebook_node(self, *_: Any, **__: Any) -> Any:
        """Refuse: that anything comes here means that nbgrader works otherwise than this module takes for granted."""
        raise NbGraderException(_OTHER_NBGRADER)

    from_file = from_filename = from_notebook_node


def _grade(converter: Autograde) -> None:
    root = Path(converter.coursedir.root)
    _check_configuration(converter, root)
    problems = []
    for assignment, folders in _selected(converter).items():
        students = {student for student, folder in students_with(root, assignment).items() if folder in folders}
        strangers = set() if converter.create_student else students - _known(root)
        if students - strangers:
            _grade_assignment(converter, root, assignment, frozenset(students - strangers))
        if len(students) < len(folders):
            links = sorted(folders.difference(students_with(root, assignment).values()))
            problems.append(f"Not graded, because what was handed in is reached through a link: {', '.join(links)}")
        if strangers:
            problems.append(f"Not graded, because the gradebook has no such student: {', '.join(sorted(strangers))}")
    if problems:
        raise NbGraderException(". ".join(problems))


def _check_configuration(converter: Autograde, root: Path) -> None:
    """Raise NbGraderException where nbgrader was told something that the grader cannot follow."""
    course = converter.coursedir
    if not converter.assignments:
        raise NbGraderException(_OTHER_NBGRADER)
    if not Execute(parent=converter).enabled:
        raise NbGraderException("--no-execute: the outputs that students hand in are never believed. Leave this option out.")
    for name, usual in _FOLDERS.items():
        if getattr(course, name) != usual:
            raise NbGraderException(f"c.CourseDirectory.{name} must be {usual!r}; it is {getattr(course, name)!r}")
    ours = {"db_url": _without_query(configured_db_url(root)), "course_id": course_id(root)}
    for name, value in ours.items():
        theirs = _without_query(getattr(course, name))
        if theirs != value:
            raise NbGraderException(
                f"c.CourseDirectory.{name} is {theirs!r} here, but {value!r} in {root / 'nbgrader_config.py'}: write it there, "
                "and leave it out of the command line and of other configuration files."
            )
    if course.notebook_id != "*":
        converter.log.warning("Submissions are graded whole, not only the notebooks %r.", course.notebook_id)


def _without_query(address: str) -> str:
    return address.partition("?")[0]


def _selected(converter: Autograde) -> dict[str, frozenset[str]]:
    """Return the folders of the students that nbgrader has selected, by assignment."""
    excluded = set(converter.coursedir.student_id_exclude.split(","))
    selected: dict[str, set[str]] = defaultdict(set)
    for folder in converter.assignments:
        student, assignment = Path(folder).parts[-2:]
        if student not in excluded:
            selected[assignment].add(student)
    return {assignment: frozenset(students) for assignment, students in sorted(selected.items())}


def _known(root: Path) -> set[str]:
    """Return the students in the gradebook."""
    with open_gradebook(root) as gradebook:
        return {student.id for student in gradebook.students}


def _grade_assignment(converter: Autograde, root: Path, assignment: str, students: frozenset[str]) -> None:
    log = converter.log

    def tell(done: int, count: int, student: str) -> None:
        if student:
            log.info("Graded %s of %s: %s", done, count, student)

    try:
        results = grade_class(root, assignment, Options(only=students, regrade=converter.force), tell)
    except BatchError as error:
        raise NbGraderException(str(error)) from error
    for student, own in groupby(results, key=attrgetter("student")):
        log.info("%s: %s", student, points([*own]))


def points(results: Sequence[Result]) -> str:
    """Return one student's points in a line: the sum, and what is odd about a notebook or waits for a person."""
    graded = [result for result in results if result.score is not None]
    line = f"{sum(result.score or 0.0 for result in graded):g} / {sum(result.max_score for result in graded):g}"
    waiting = len(results) - len(graded)
    odd = dict.fromkeys(f"{result.notebook} {result.status}" for result in graded if result.status != "graded")
    return ", ".join([line, *([f"{waiting} by hand"] if waiting else []), *odd])
