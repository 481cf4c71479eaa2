"""An exercise as data, and the drawing of its cases."""

import numpy as np
import pytest

from autograder.exercise import (
    Exercise,
    GraphExercise,
    Group,
    Mistake,
    Trial,
    check_cell,
    checked_exercise,
    right_value,
    trial,
)
from course.answers import Question, reply_to
from course.ladder import Answered
from course.language import Text
from course.plain import identical
from course.tolerances import LAST_AXIS

NAME = Text("a", "あ")


def reference(values, factor):
    return [value * factor for value in values]


def halved(values, factor):
    return [value * factor / 2 for value in values]


def exercise_of(*groups, **more):
    fields = {
        "name": "scaled",
        "notebook": "odometry/pose_update",
        "points": 5,
        "parameters": ("values", "factor"),
        "reference": reference,
        "cases": lambda rng: groups,
        "examples": (([1.0], 2),),
        "mistakes": (Mistake(halved, Text("The half.", "半分です。")),),
    }
    return Exercise(**fields | more)


def test_an_exercise_tells_the_ladder_what_it_needs():
    exercise = exercise_of(tolerance=LAST_AXIS, quantities=("a", "b"), gear=1, warnings_are_faults=True)
    expected = Answered("scaled", ("values", "factor"), LAST_AXIS, ("a", "b"), warnings_are_faults=True, gear=1)
    assert exercise.answered == expected
    assert exercise.misconceptions == ("halved",)
    assert exercise.shown is None


def test_a_graph_exercise_shows_what_it_is_drawn_from():
    graph = GraphExercise(
        name="xy_axes",
        notebook="odometry/wheel_odometry",
        points=5,
        drawn_from=lambda: {"x": np.arange(3.0)},
        fault=lambda figure, shown: None,
        mistakes=(Mistake(halved, NAME),),
    )
    assert graph.shown["x"].tolist() == [0, 1, 2]
    assert graph.misconceptions == ("halved",)


def test_questions_follow_the_groups_in_order():
    first, second = Group(NAME, 3, [([1.0], 2), ([2.0], 2)]), Group(NAME, 1, [([3.0], 2)], symbols=True)
    drawn = trial(exercise_of(first, second), 1)
    assert drawn.group_of == (0, 0, 1)
    assert [question.args[0] for question in drawn.questions] == [[1.0], [2.0], [3.0]]
    assert [question.symbols for question in drawn.questions] == [False, False, True]
    assert drawn.weights.tolist() == [0.75, 0.25]


def test_cases_may_be_drawn_one_by_one():
    def cases(rng):
        yield Group(NAME, 1, [([rng.uniform()], 2)])

    assert len(trial(exercise_of(cases=cases), 1).questions) == 1


@pytest.mark.parametrize("weights", [(1,), (1, 2, 3), (0.1, 0.2, 0.7)])
def test_shares_sum_to_one(weights):
    groups = tuple(Group(NAME, weight, []) for weight in weights)
    assert Trial(groups, (), ()).weights.sum() == pytest.approx(1.0)


def test_a_seed_repeats_a_drawing():
    exercise = exercise_of(cases=lambda rng: [Group(NAME, 1, [([rng.uniform()], 2)])])
    assert trial(exercise, 5).questions == trial(exercise, 5).questions
    assert trial(exercise, 5).questions != trial(exercise, 6).questions


#: what draws leave behind, and what is handed to every answer, in this process and in the sandbox alike
ARGUMENTS = [
    (np.float64(0.5), 0.5),
    (np.int64(3), 3),
    (np.bool(True), True),
    ((1.0, np.float64(2.0)), [1.0, 2.0]),
    ([np.int8(1), (2, 3)], [1, [2, 3]]),
    ({"q": (np.float32(0.5), 1.0), "t": [np.float64(1.0)]}, {"q": [0.5, 1.0], "t": [1.0]}),
    (np.array([1, 2]), np.array([1, 2])),
    ("text", "text"),
    (None, None),
]


@pytest.mark.parametrize(("drawn", "asked"), ARGUMENTS, ids=repr)
def test_arguments_are_plain_data(drawn, asked):
    [question] = trial(exercise_of(Group(NAME, 1, [(drawn, 2)])), 1).questions
    assert identical(question.args[0], asked)


@pytest.mark.parametrize("drawn", [row[0] for row in ARGUMENTS], ids=repr)
def test_an_untouched_argument_counts_as_untouched(drawn):
    [question] = trial(exercise_of(Group(NAME, 1, [(drawn, 2)])), 1).questions
    reply = reply_to(lambda *_: 0, question)
    assert all(map(identical, question.args, reply.inputs))


def test_right_values_are_plain_data():
    assert right_value(reference, Question(([1.0, 2.0], 3))).tolist() == [3.0, 6.0]
    assert right_value(reference, Question(([1.0], 3), symbols=True)).tolist() == [3.0]


def test_a_right_rule_that_fails_is_a_fault_of_ours():
    with pytest.raises(TypeError, match="not iterable"):
        right_value(reference, Question((1.0, 3)))


def test_check_cells_are_named_after_their_exercise():
    assert check_cell("pose_step") == "check_pose_step"
    assert checked_exercise("check_pose_step") == "pose_step"
    assert checked_exercise(check_cell("check_check")) == "check_check"
