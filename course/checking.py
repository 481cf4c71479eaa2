"""`check("name")`: look at the reader's answer and say at once how it stands, in the reader's language.

Who judges depends on where it runs. In a full clone it is the judge of the autograder, in this process; where there is no
autograder (a student's bundle, the grader's sandbox) the public examples answer, and say so. When work is graded the check cells
are not run at all: the grader asks the answers itself.
"""

import inspect
import sys
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from typing import Any

from course.answers import Interview, Question, find, interview
from course.examples import verdict_from_examples
from course.language import chosen_language
from course.verdict import Verdict


class CheckFailed(AssertionError):  # noqa: N818 - a student reads this name
    """A check that did not pass. It shows as one line instead of a traceback through code that is not the student's."""

    def __init__(self, verdict: Verdict, language: str) -> None:
        super().__init__(verdict.plain_text(language))
        self.headline = verdict.headline(language)

    def _render_traceback_(self) -> list[str]:
        return [f"\x1b[31m{self.headline}\x1b[0m"]


class Result:
    """A passed check as a notebook shows it.

    It displays itself, so that the cell has no execute_result: nbgrader reads one as a number of points.
    """

    def __init__(self, verdict: Verdict) -> None:
        self.verdict = verdict

    def __repr__(self) -> str:
        return self.verdict.plain_text(chosen_language())

    def _ipython_display_(self) -> None:
        _show(self.verdict)


def check(name: str) -> Result:
    """Check the answer `name` that is defined in this notebook and show how it stands.

    Raises CheckFailed (an AssertionError) when it is not right yet, KeyError when there is no such exercise.
    """
    judged = _judge_in_reach()
    namespace, cells = _notebook(inspect.currentframe())

    def ask(questions: Sequence[Question]) -> Interview:
        answer, missing = find(name, namespace, cells)
        return Interview(missing=missing) if missing else interview(answer, questions)

    verdict = judged(name, ask)
    if verdict.passed:
        return Result(verdict)
    _show(verdict)
    raise CheckFailed(verdict, chosen_language())


def _judge_in_reach() -> Callable[[str, Callable[[Sequence[Question]], Interview]], Verdict]:
    try:
        found = find_spec("autograder.reference") is not None
    except ModuleNotFoundError:  # no autograder, or a student's file of that name
        found = False
    if not found:
        return verdict_from_examples
    # the one place where course looks at the autograder: in a full clone it is there, in a bundle it is not
    from autograder.judging import judged_by_name

    return judged_by_name


def _notebook(frame: Any) -> tuple[dict[str, object], list[str]]:
    """Return the namespace in which the answer lives, and the cells run so far."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    if shell is not None:
        cells = shell.user_ns.get("In")
        # a notebook may have used the name for something else
        return shell.user_ns, [cell for cell in cells if isinstance(cell, str)] if isinstance(cells, list) else []
    while frame is not None and frame.f_globals.get("__name__", "").startswith("course."):
        frame = frame.f_back
    return (frame.f_globals if frame is not None else {}), []


def _show(verdict: Verdict) -> None:
    """Display the verdict where there is a notebook; elsewhere the raised error or the returned result carries the text."""
    ipython = sys.modules.get("IPython")
    if ipython is not None and ipython.get_ipython() is not None:
        from IPython.display import display

        language = chosen_language()
        display({"text/plain": verdict.plain_text(language), "text/html": verdict.html(language)}, raw=True)
