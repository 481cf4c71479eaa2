"""An appeal: the cases of a recorded verdict again, with what was expected and what the answer gave."""

import io
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from autograder.exercise import GraphExercise, trial
from autograder.grading import Result, result_from_row
from autograder.judging import case_faults, graph_verdict, verdict
from autograder.receipts import REPLY, Receipt, exercises_hash, read_receipt, submission_folder
from autograder.reference import exercise_named
from autograder.sandbox.wire import WireError, receive, unpacked_interview
from autograder.submissions import hashes
from course.answers import Interview, Reply
from course.given import shown_built
from course.language import Text
from course.plain import Built, Plain


class AppealError(RuntimeError):
    """There is no verdict to explain; the message says why."""


@dataclass(frozen=True)
class Case:
    """One call: the kind of input that it stands for, inputs, expected and given value as text, and whether it was right."""

    group: Text
    inputs: str
    expected: str
    given: str
    right: bool


@dataclass(frozen=True)
class Appeal:
    """A recorded verdict and its cases.

    `attempt` is its number; `unchanged` says whether exercise and judge are still those of that day; `agrees` whether the judge of
    today says the same of the recorded replies (None: the answer was right, and its replies were not kept).
    """

    result: Result
    receipt: Receipt
    attempt: int
    cases: tuple[Case, ...]
    unchanged: bool
    agrees: bool | None


def appeal(root: Path, student: str, assignment: str, exercise: str, full: bool = False) -> Appeal:
    """Return the recorded verdict on one exercise with its cases; long arrays are shortened unless `full`.

    Raises AppealError if nothing was recorded.
    """
    receipt = read_receipt(root, assignment, student)
    if receipt is None:
        raise AppealError(
            f"nothing is recorded of {student} in {assignment}. Type: autograder grade {assignment} --student '{student}'"
        )
    rows = {row["exercise"]: result_from_row(row) for row in receipt.results}
    if exercise not in rows:
        raise AppealError(f"{assignment} has no exercise {exercise!r}; there are: {', '.join(rows)}")
    result = rows[exercise]
    if result.seed is None:
        raise AppealError(f"{exercise} was not judged by cases: {result.message or 'a person grades it'}")
    folder = submission_folder(root, assignment, student)
    talk = _recorded(folder / f"{exercise}{REPLY}")
    return Appeal(
        result,
        receipt,
        _attempt(folder, receipt, result.notebook),
        () if isinstance(exercise_named(exercise), GraphExercise) else _cases(exercise, result.seed, talk, full),
        receipt.exercises == exercises_hash(),
        None if talk is None else _today(exercise, result.seed, talk) == (result.score, result.misconception),
    )


def _attempt(folder: Path, receipt: Receipt, notebook: str) -> int:
    """Return which attempt it was that counts: an earlier version may have been handed in again, or one that came too late."""
    tried = list(receipt.attempts.get(notebook, ()))
    try:
        return tried.index(hashes({notebook: (folder / f"{notebook}.ipynb").read_bytes()})[notebook]) + 1
    except (OSError, ValueError) as error:
        raise AppealError(f"the notebook that was graded is not the one in {folder} any more: {error}") from None


def _recorded(path: Path) -> Interview | None:
    """Return what the answer replied then; None if it was right, and nothing was kept."""
    try:
        kept = io.BytesIO(path.read_bytes())
        return unpacked_interview(receive(partial(_exactly, kept)))
    except FileNotFoundError:
        return None
    except (OSError, WireError) as error:
        raise AppealError(f"{path} cannot be read any more: {error}") from None


def _exactly(kept: io.BytesIO, count: int) -> bytes:
    data = kept.read(count)
    if len(data) != count:
        raise WireError("it is cut off")
    return data


def _today(name: str, seed: int, talk: Interview) -> tuple[float, str | None]:
    exercise = exercise_named(name)
    judged = (
        graph_verdict(exercise, talk) if isinstance(exercise, GraphExercise) else verdict(exercise, trial(exercise, seed), talk)
    )
    return round(judged.score * exercise.points, 4), judged.misconception


def _cases(name: str, seed: int, talk: Interview | None, full: bool) -> tuple[Case, ...]:
    exercise = exercise_named(name)
    assert not isinstance(exercise, GraphExercise)
    drawn = trial(exercise, seed)
    expected, faults = case_faults(exercise, drawn, talk)
    replies: list[Reply | None] = [None] * len(faults) if talk is None else [*talk.replies_to(drawn.questions)]
    with np.printoptions(precision=6, suppress=True, threshold=100_000 if full else 12, edgeitems=3, linewidth=60):
        return tuple(
            Case(drawn.groups[group].name, _arguments(question.args), str(right), _given(reply), fault is None)
            for group, question, right, reply, fault in zip(
                drawn.group_of, drawn.questions, expected, replies, faults, strict=True
            )
        )


def _arguments(args: tuple[Plain, ...]) -> str:
    return "\n".join(shown_built(arg) if isinstance(arg, Built) else str(arg) for arg in args)


def _given(reply: Reply | None) -> str:
    if reply is None:
        return "the same"
    if reply.trouble is not None:
        return f"{reply.trouble.type}: {reply.trouble.message}"
    return str(reply.value)
