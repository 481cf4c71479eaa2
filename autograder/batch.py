"""One run over a class: grade what was handed in, write it into the gradebook, and say how far it is."""

from collections.abc import Callable
from pathlib import Path

from autograder.engine import MissingReleaseError, Options, graded, release_notebooks, students_with
from autograder.gradebook import GradebookWriter
from autograder.grading import Result
from autograder.registering import RegistrationError
from autograder.session import NoSandboxError, sandbox_problem


class BatchError(RuntimeError):
    """The class cannot be graded; the message says why and what to do."""


def grade_class(
    root: Path,
    assignment: str,
    options: Options | None = None,
    on_progress: Callable[[int, int, str], None] = lambda done, count, student: None,
) -> list[Result]:
    """Grade a class and return all results, by student. `on_progress` is told (done, of how many, who was last).

    Raises BatchError where grading cannot begin or go on. What was graded until then is in the gradebook.
    """
    options = options or Options()
    problem = sandbox_problem() if options.sandbox else None
    if problem is not None:
        raise BatchError(problem)
    try:
        release_notebooks(root, assignment)
        students = students_with(root, assignment, options.student)
        if not students:
            where = root / "submitted" / options.student / assignment
            raise BatchError(f"nobody handed in {assignment!r}: there is no folder that fits {where}")
        results: dict[str, list[Result]] = {}
        with GradebookWriter(root, assignment) as gradebook:
            on_progress(0, len(students), "")
            for student, notebooks in graded(root, assignment, options):
                gradebook.write(student, notebooks)
                results[student] = [result for notebook in notebooks for result in notebook.results]
                on_progress(len(results), len(students), student)
    except (KeyError, MissingReleaseError, NoSandboxError, RegistrationError) as error:
        raise BatchError(str(error.args[0])) from error
    return [result for student in students for result in results[student]]
