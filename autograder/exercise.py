"""The exercise: data about one answer that a student gives. Everything else in the autograder is about exercises."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from course.answers import Question, Reply, reply_to, trouble_of
from course.given import handed_over
from course.graphs import ANY_GRAPH, Structure
from course.graphs import GraphFault as GraphFault  # noqa: PLC0414 - a part of what is declared here
from course.ladder import Answered
from course.language import Text
from course.plain import Built, Plain, Refusal, plain
from course.tolerances import ONE_QUANTITY, RecordTolerance, Tolerance


class Group(NamedTuple):
    """Cases of one kind: the phrase that names them to the student, their share of the score, and the arguments of each.

    `symbols`: the answer is called with SymPy symbols, and the arguments are put into what it returns.
    """

    name: Text
    weight: float
    cases: Sequence[tuple[Plain, ...]]
    symbols: bool = False


class Mistake(NamedTuple):
    """An executable misconception: a wrong answer that students really give, and what to tell them.

    `wrong` stands alone (NumPy as np, math, SymPy as sp), so that its source can be put into a notebook; its name is the slug.
    """

    wrong: Callable[..., Any]
    message: Text

    @property
    def slug(self) -> str:
        """Return the name by which results report this mistake."""
        return self.wrong.__name__


@dataclass(frozen=True, kw_only=True, eq=False)
class Exercise:
    """One graded exercise.

    `reference` is the right answer, written independently of the notebook's solution; `also_right` are further rules that the
    definition leaves open, each accepted as a whole. `cases(rng)` draws groups of inputs afresh. `examples` are the inputs that
    students may see with their results. `quantities` names what lies side by side in the answer; `gear` is the index of an
    argument that is a gear ratio; `warnings_are_faults` where the definition says so.

    Arguments may be built where the answer is called: see course.given. Where the answer is a dict, `tolerance` is a
    `RecordTolerance` and `quantities` are its keys. `refuses` are the built-in errors with which the reference refuses inputs: it
    raises them, and if its message is a number, such as that of a line, the student's message must name that number too.
    """

    name: str
    notebook: str
    points: int
    parameters: tuple[str, ...]
    reference: Callable[..., Any]
    cases: Callable[[np.random.Generator], Iterable[Group]]
    examples: tuple[tuple[Plain, ...], ...]
    mistakes: tuple[Mistake, ...]
    also_right: tuple[Callable[..., Any], ...] = ()
    tolerance: Tolerance | RecordTolerance = ONE_QUANTITY
    quantities: tuple[str, ...] = ()
    gear: int | None = None
    warnings_are_faults: bool = False
    refuses: tuple[type[Exception], ...] = ()

    @property
    def misconceptions(self) -> tuple[str, ...]:
        """Return the slugs of the mistakes that are recognised."""
        return tuple(mistake.slug for mistake in self.mistakes)

    @property
    def shown(self) -> Plain:
        """Return the plain data that a graph must show; None for exercises that are no graph."""
        return None

    @property
    def answered(self) -> Answered:
        """Return what the ladder needs to know."""
        return Answered(
            self.name,
            self.parameters,
            self.tolerance,
            self.quantities,
            warnings_are_faults=self.warnings_are_faults,
            gear=self.gear,
        )


@dataclass(frozen=True, kw_only=True)
class GraphExercise:
    """A graded graph: the student binds a Matplotlib Axes to its name.

    `drawn_from` computes the plain data that the graph must show; `fault` looks at the summary of the Axes (course.figures) and
    at that data, and returns None or a `GraphFault`. A mistake's function draws the wrong graph from the data and returns its Axes.
    `structure` is what can be said of the graph without the data; a student's bundle knows no more.
    """

    name: str
    notebook: str
    points: int
    drawn_from: Callable[[], Plain]
    fault: Callable[[Mapping[str, Plain], Plain], GraphFault | None]
    mistakes: tuple[Mistake, ...] = ()
    structure: Structure = ANY_GRAPH

    @property
    def misconceptions(self) -> tuple[str, ...]:
        """Return the slugs of the faults that are recognised."""
        return tuple(mistake.slug for mistake in self.mistakes)

    @property
    def shown(self) -> Plain:
        """Return the plain data that the graph must show."""
        return self.drawn_from()


@dataclass(frozen=True, eq=False)
class Trial:
    """One drawing of an exercise's cases: the groups, the questions in order, and the index of each question's group."""

    groups: tuple[Group, ...]
    questions: tuple[Question, ...]
    group_of: tuple[int, ...]

    @property
    def weights(self) -> np.ndarray:
        """Return the share of each group in the score; the shares sum to 1."""
        weights = np.array([group.weight for group in self.groups], dtype=float)
        return weights / weights.sum()


# a few are kept: whoever tries many answers with one seed draws once
@lru_cache(maxsize=8)
def trial(exercise: Exercise, seed: int) -> Trial:
    """Draw the cases of `exercise` from `seed`."""
    groups = tuple(exercise.cases(np.random.default_rng(seed)))
    questions = tuple(Question(tuple(map(_as_python, case)), group.symbols) for group in groups for case in group.cases)
    group_of = tuple(index for index, group in enumerate(groups) for _ in group.cases)
    return Trial(groups, questions, group_of)


def _as_python(arg: Plain) -> Plain:
    """Return NumPy's scalars, which draws leave behind, as Python's numbers, and tuples as lists: so they stay on every way."""
    if isinstance(arg, Built):
        return Built(arg.kind, _as_python(arg.data))
    if isinstance(arg, np.generic):
        return arg.item()
    if isinstance(arg, list | tuple):
        return list(map(_as_python, arg))
    if isinstance(arg, dict):
        return {key: _as_python(item) for key, item in arg.items()}
    return arg


def right_value(rule: Callable[..., Any], question: Question, refuses: tuple[type[Exception], ...] = ()) -> Plain:
    """Return what a right rule gives, as plain data; it works on numbers.

    An error of the kinds in `refuses` is a right answer too, as a `Refusal`; any other is a fault of ours and raises.
    """
    with handed_over(question.args) as given:
        try:
            return plain(rule(*given))
        except refuses as error:
            return Refusal(type(error).__name__, str(error) if str(error).isdecimal() else "")


@lru_cache(maxsize=32)
def right_values(rule: Callable[..., Any], drawn: Trial, refuses: tuple[type[Exception], ...] = ()) -> tuple[Plain, ...]:
    """Return what a right rule gives for each question of a trial."""
    return tuple(right_value(rule, question, refuses) for question in drawn.questions)


@lru_cache(maxsize=2048)
def wrong_reply(wrong: Callable[..., Any], drawn: Trial, index: int) -> Reply:
    """Return what a mistake replies to one question of a trial.

    It is our own code: nothing of what is done around a student's answer is needed, and dozens are tried for one verdict.
    """
    question = drawn.questions[index]
    if question.symbols:
        return reply_to(wrong, question)
    try:
        return Reply(right_value(wrong, question))
    except Exception as error:
        return Reply(trouble=trouble_of(error))


def check_cell(exercise: str) -> str:
    """Return the grade id of the locked cell that checks an exercise."""
    return f"check_{exercise}"


def checked_exercise(grade_id: str) -> str:
    """Return the exercise that a check cell checks."""
    return grade_id.removeprefix("check_")
