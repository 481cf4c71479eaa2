"""The autograder: `judge` one answer, or list the `exercises`. Nothing is imported before it is asked for."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from autograder.exercise import Exercise, GraphExercise
    from course.verdict import Verdict

__all__ = ["exercises", "judge"]


def judge(name: str, answer: object, seed: int | None = None) -> "Verdict":
    """Judge `answer`, a function or (for graphs) a Matplotlib Axes, as the exercise `name`.

    Returns a verdict with `score` (0..1), `passed`, `misconception` (slug or None), `rung`, `message("en")` and `message("ja")`.
    The same `seed` draws the same cases; None draws afresh. Raises KeyError for an unknown exercise.
    """
    from autograder.judging import judge as judge_answer

    return judge_answer(name, answer, seed)


def exercises() -> "list[Exercise | GraphExercise]":
    """Return every graded exercise, in the order of the course."""
    from autograder.reference import all_exercises

    return all_exercises()
