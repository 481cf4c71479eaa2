"""Each rung of the ladder breaks with a message of its own, in both languages, and the lowest is told."""

import re

import numpy as np
import pytest

from course.answers import Interview, Missing, Question, Reply, Trouble
from course.ladder import Answered, Fault, call_fault, entry_fault, names_of_wrong, shape_in_words, stands_for_truth
from course.language import Text
from course.plain import Odd
from course.tolerances import LAST_AXIS
from course.verdict import RUNGS

POSE = Answered("pose_step", ("pose", "distance"), LAST_AXIS, ("x", "y", "theta"))
JAPANESE = re.compile("[\u3040-\u30ff\u4e00-\u9fff]")
QUESTION = Question((np.array([1.0, 2.0, 0.5]), 3.0))
EXPECTED = np.array([1.25, -2.5, 3.0])


def assert_says(text, english, japanese):
    assert english in text.en
    assert japanese in text.ja
    assert not JAPANESE.search(text.en)
    assert JAPANESE.search(text.ja)


ENTRIES = [
    (Interview(missing=Missing("undefined")), "defined", "not defined yet", "まだ定義されていません"),
    (Interview(missing=Missing("similar", "posestep")), "defined", "similar name, posestep", "似た名前の posestep"),
    (Interview(missing=Missing("nested", "outer")), "defined", "inside outer", "outer の中で"),
    (Interview(missing=Missing("a new reason")), "defined", "not defined yet", "まだ定義されていません"),
    (Interview(kind="float"), "callable", "where a function is asked for", "関数ではなく"),
    (Interview(kind="axes"), "callable", "Axes of a graph", "Axes"),
    (Interview(mismatch=(2, "(pose)")), "callable", "pose, distance", "pose, distance"),
]


@pytest.mark.parametrize(("talk", "rung", "english", "japanese"), ENTRIES)
def test_what_cannot_be_called(talk, rung, english, japanese):
    fault = entry_fault(POSE, talk)
    assert fault.rung == rung
    assert_says(fault.text, english, japanese)


def test_what_can_be_called_has_no_entry_fault():
    assert entry_fault(POSE, Interview(replies=(Reply(1.0),))) is None


def replied(value=None, **more):
    return Reply(value, inputs=more.pop("inputs", QUESTION.args), **more)


CALLS = [
    (replied(trouble=Trouble("ValueError", "ValueError", "no")), "runs", "no", "no"),
    (replied(EXPECTED, inputs=(np.array([9.0, 2.0, 0.5]), 3.0)), "inputs", "changes its input (pose)", "引数(pose)を書き換え"),
    (replied(EXPECTED, inputs=([1.0, 2.0, 0.5], 3.0)), "inputs", "(pose)", "(pose)"),
    (replied(EXPECTED, inputs=(QUESTION.args[0], 4.0)), "inputs", "(distance)", "(distance)"),
    (replied(EXPECTED, inputs=(np.zeros(3), 4.0)), "inputs", "(pose, distance)", "(pose, distance)"),
    (replied(EXPECTED, inputs=()), "inputs", "changes its input", "書き換え"),
    (replied(None), "shape", "return", "return"),
    (replied(None, printed="\n 1.25\n"), "shape", "1.25", "1.25"),
    (replied("1.25"), "shape", "str", "文字列"),
    (replied(Odd("masked", "MaskedArray")), "shape", "masked", "マスク"),
    (replied({"x": 1.0}), "shape", "dict", "辞書"),
    (replied([1.0, "a"]), "shape", "text", "文字列"),
    (replied([1.0, None]), "shape", "None", "None"),
    (replied([EXPECTED, EXPECTED[:2]]), "shape", "different lengths", "長さがそろっていない"),
    (replied(True), "shape", "True or False where a number", "True / False"),
    (replied(EXPECTED > 0), "shape", "True or False where a number", "True / False"),
    (replied(1.25), "shape", "a single number, but shape (3,)", "数値1個になっています"),
    (replied(EXPECTED[:2]), "shape", "shape (2,), but shape (3,)", "形状 (3,)が必要"),
    (replied(EXPECTED[np.newaxis]), "shape", "shape (1, 3), but shape (3,)", "形状 (1, 3)になっています"),
    (replied(EXPECTED[:, np.newaxis]), "shape", "shape (3, 1), but shape (3,)", "形状 (3, 1)になっています"),
    (replied(np.zeros(0)), "shape", "shape (0,), but shape (3,)", "形状 (0,)になっています"),
    (replied(EXPECTED * np.nan), "shape", "contains NaN", "NaN が含まれます"),
    (replied(np.array([np.inf, 0, 0])), "shape", "contains inf", "inf が含まれます"),
    (replied(10**400), "shape", "a single number", "数値1個"),
    (replied(EXPECTED + np.array([0, 0, 1e-3])), "value", "", ""),
]


@pytest.mark.parametrize(("reply", "rung", "english", "japanese"), CALLS)
def test_how_a_call_breaks(reply, rung, english, japanese):
    fault = call_fault(POSE, QUESTION, EXPECTED, reply)
    assert fault.rung == rung
    if english:
        assert_says(fault.text, english, japanese)


@pytest.mark.parametrize("reply", [row[0] for row in CALLS])
def test_no_message_shows_what_was_expected(reply):
    told = "".join(call_fault(POSE, QUESTION, EXPECTED, reply).text)
    assert "-2.5" not in told
    assert "1.25" not in told.replace("1.25", "", reply.printed.count("1.25") * 2)


RIGHT = [
    (EXPECTED, EXPECTED),
    (EXPECTED, EXPECTED.astype(np.float32)),
    (np.array([1, 2]), np.array([1.0, 2.0])),
    (2.0, 2),
    (2, np.array(2.0)),
    (True, np.array(1)),
    (True, 1.0),
    (np.array([True, False]), np.array([1, 0])),
    (np.zeros(0), np.zeros(0)),
]


@pytest.mark.parametrize(("expected", "value"), RIGHT)
def test_right_replies_have_no_fault(expected, value):
    assert call_fault(Answered("f", ("a", "b")), QUESTION, expected, replied(value)) is None


def test_the_wrong_quantities_come_with_the_fault():
    fault = call_fault(POSE, QUESTION, EXPECTED, replied(EXPECTED + np.array([0, 0, 1e-3])))
    assert fault.wrong.tolist() == [False, False, True]


def test_warnings_are_a_fault_only_where_the_exercise_says_so():
    strict = Answered("arc", ("pose", "distance"), LAST_AXIS, warnings_are_faults=True)
    reply = replied(EXPECTED, warned=("RuntimeWarning: \u202edivide\n by zero", "b"))
    assert call_fault(POSE, QUESTION, EXPECTED, reply) is None
    fault = call_fault(strict, QUESTION, EXPECTED, reply)
    assert fault.rung == "runs"
    assert_says(fault.text, "warns: RuntimeWarning: <U+202E>divide  by zero", "警告が出ました")
    # wrong form comes first: its numbers do not count yet
    assert call_fault(strict, QUESTION, EXPECTED, replied(1.0, warned=("a",))).rung == "shape"


ORDER = [
    (replied(None, trouble=Trouble("KeyError", "KeyError", "a"), inputs=()), "runs"),
    (replied(None, inputs=()), "inputs"),
    (replied(EXPECTED[:2] * np.nan), "shape"),
    (replied(np.array([np.nan, 0.0, 0.0])), "shape"),
]


@pytest.mark.parametrize(("reply", "rung"), ORDER)
def test_the_lowest_rung_that_breaks_is_told(reply, rung):
    assert call_fault(POSE, QUESTION, EXPECTED, reply).rung == rung


def test_heights_follow_the_rungs():
    assert [Fault(rung, Text("", "")).height for rung in RUNGS] == list(range(7))


SHAPES = [((), "a single number"), ((1,), "shape (1,)"), ((3,), "shape (3,)"), ((4, 3), "shape (4, 3)")]


@pytest.mark.parametrize(("shape", "words"), SHAPES)
def test_shapes_in_words(shape, words):
    assert shape_in_words(shape).en == words


@pytest.mark.parametrize(
    ("expected", "truth"), [(True, True), (np.array([True]), True), (1, False), (np.array([1]), False), (None, False)]
)
def test_truth_values_are_told_from_numbers(expected, truth):
    assert stands_for_truth(expected) == truth


def wrong(*mask):
    return Fault("value", Text("", ""), np.array(mask))


NAMES = [
    ([wrong(True, False, False)], (["x"], ["y", "theta"])),
    ([wrong(True, False, False), wrong(False, False, True)], (["x", "theta"], ["y"])),
    ([wrong(True, True, True)], (["x", "y", "theta"], [])),
    ([wrong(True)], ([], [])),
    ([Fault("shape", Text("", ""))], ([], [])),
    ([], ([], [])),
]


@pytest.mark.parametrize(("faults", "names"), NAMES)
def test_wrong_quantities_are_named(faults, names):
    assert names_of_wrong(POSE, faults) == names


def test_a_changed_dict_is_to_be_copied_as_a_dict():
    log = {"time": np.array([1.0, 2.0])}
    reply = Reply(1.0, inputs=({"time": np.array([1.0, 3.0])},))
    fault = call_fault(Answered("mean_speed", ("log",)), Question((log,)), 1.0, reply)
    assert fault.rung == "inputs"
    assert "dict(log)" in fault.text.en
    assert "dict(log)" in fault.text.ja
