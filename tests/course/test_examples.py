"""What a student's bundle answers from: the public examples, and no more."""

import json
import math
import warnings

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from course import examples
from course.answers import Interview, Missing, Reply, interview
from course.examples import restored, shown_value, stored, stored_tolerance, verdict_from_examples
from course.plain import Built, Refusal, as_given, identical
from course.tolerances import LAST_AXIS, ONE_QUANTITY

ENTRIES = {
    "double": {
        "parameters": ["values"],
        "tolerance": stored_tolerance(LAST_AXIS),
        "quantities": ["a", "b"],
        "warnings_are_faults": False,
        "gear": None,
        "examples": [
            {"args": [stored(np.array([1.0, -0.5]))], "result": stored(np.array([2.0, -1.0]))},
            {"args": [[3, 0.25]], "result": stored(np.array([6.0, 0.5]))},
        ],
    },
    "span": {
        "parameters": ["log", "gear"],
        "tolerance": stored_tolerance(ONE_QUANTITY),
        "quantities": [],
        "warnings_are_faults": True,
        "gear": 1,
        "examples": [
            {"args": [stored({"time": np.array([0.5, 2.0])}), 4], "result": 0.375},
            {"args": [stored({"time": np.array([0.0, 10.0, 70.0])}), 7], "result": 10.0},
        ],
    },
}


@pytest.fixture(autouse=True)
def public_examples(tmp_path, monkeypatch):
    path = tmp_path / "examples.json"
    path.write_text(json.dumps(ENTRIES), encoding="utf-8")
    monkeypatch.setattr(examples, "FILE", path)
    examples._entries.cache_clear()
    yield path
    examples._entries.cache_clear()


def judged(name, answer):
    return verdict_from_examples(name, lambda questions: interview(answer, questions, 0.1 if answer is endless else 20.0))


def double(values):
    return [2 * value for value in values]


def span(log, gear):
    return (log["time"][-1] - log["time"][0]) / gear


def test_right_examples_pass_and_say_what_that_means():
    for name, answer in (("double", double), ("span", span)):
        verdict = judged(name, answer)
        assert verdict.passed
        assert verdict.public
        assert verdict.state == "examples"
        assert verdict.message("en").startswith(
            "2 public examples are right. The work that you hand in is checked with many more"
        )
        assert "公開例 2 個" in verdict.message("ja")
        assert "採点では、ほかの入力でも" in verdict.message("ja")


def spoil(values):
    values[0] = 0
    return double(values)


def warns(log, gear):
    warnings.warn("careful", stacklevel=1)
    return span(log, gear)


def endless(values):
    while True:
        pass


WRONG = [
    ("double", lambda values: values, "value", "double([ 1. , -0.5]) gives [ 1. , -0.5]; the example says [ 2., -1.]."),
    ("double", lambda values: [2 * values[0], 7.0], "value", "gives [2., 7.]; the example says [ 2., -1.]"),
    ("double", lambda values: 2.0, "shape", "This happens in the example double([ 1. , -0.5])"),
    ("double", lambda values: 2 * values, "shape", "This happens in the example double([3, 0.25])"),
    ("double", lambda values: np.zeros(2) if isinstance(values, np.ndarray) else None, "value", "the example says [ 2., -1.]"),
    ("double", lambda values: np.zeros(2) if isinstance(values, np.ndarray) else [1.0], "value", "the example says [ 2., -1.]"),
    ("double", lambda values: np.zeros(2) if isinstance(values, np.ndarray) else [np.nan] * 2, "value", "the example says"),
    ("double", spoil, "inputs", "This happens in the example double([ 1. , -0.5])"),
    ("double", lambda values: values.shape, "shape", "double([ 1. , -0.5])"),
    ("double", endless, "runs", "double([ 1. , -0.5])"),
    ("double", lambda: 0, "callable", "values"),
    ("double", 3.0, "callable", "where a function is asked for"),
    ("span", lambda log, gear: span(log, gear) * gear, "value", "span({'time': [0.5, 2. ]}, 4) gives 1.5;"),
    ("span", warns, "runs", "warns: UserWarning: careful"),
]


@pytest.mark.parametrize(("name", "answer", "rung", "english"), WRONG)
def test_wrong_answers_are_shown_the_example_that_they_break(name, answer, rung, english):
    verdict = judged(name, answer)
    assert verdict.rung == rung
    assert (verdict.score, verdict.public, verdict.state) == (0.0, True, "failed")
    assert english in verdict.message("en")


def test_a_factor_is_told_before_the_example():
    message = judged("double", lambda values: [4.0 * value for value in values]).message("en")
    assert message.startswith("a is right up to a constant factor in every case: 2:")
    assert message.endswith("the example says [ 2., -1.].")
    assert "the gear ratio:" in judged("span", lambda log, gear: span(log, gear) * gear).message("en")


def test_an_answer_right_in_the_first_example_only_fails_at_the_second():
    verdict = judged("double", lambda values: np.array([2.0, -1.0]))
    assert "double([3, 0.25]) gives [ 2., -1.]; the example says [6. , 0.5]." in verdict.message("en")
    assert "公開例では" in verdict.message("ja")


def test_a_missing_answer():
    verdict = verdict_from_examples("double", lambda _: Interview(missing=Missing("undefined")))
    assert (verdict.rung, verdict.public) == ("defined", True)


def test_an_unknown_name_is_answered_with_the_known_ones():
    with pytest.raises(KeyError, match="no exercise is called 'tripple'; there are: double, span"):
        judged("tripple", double)


def test_a_strict_notebook_gets_the_same_verdict():
    before = np.seterr(all="raise")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        strict = judged("double", double), judged("double", lambda values: [1e-320, 1.7e308])
    np.seterr(**before)
    assert strict == (judged("double", double), judged("double", lambda values: [1e-320, 1.7e308]))


def test_fewer_replies_than_examples_do_not_pass():
    assert not verdict_from_examples("double", lambda _: Interview(replies=())).passed
    one = Interview(replies=(Reply(np.array([2.0, -1.0]), inputs=(np.array([1.0, -0.5]),)),))
    assert not verdict_from_examples("double", lambda _: one).passed


SHOWN = [
    (0.1 + 0.2, "0.3"),
    (3, "3"),
    (True, "True"),
    (np.array([1.0, 2.5]), "[1. , 2.5]"),
    (np.array([[1.0, 2.0], [3.0, 4.0]]), "[[1., 2.], [3., 4.]]"),
    ([1, "a", None], "[1, 'a', None]"),
    ({"t": [0.5], "n": 2}, "{'t': [0.5], 'n': 2}"),
    ("a" * 300, "'" + "a" * 199),
    (Built("integrand", {"powers": np.array([1.0, 0.5]), "waves": np.zeros((0, 3))}), "f(x) = 1 + 0.5 x"),
    (Refusal("ValueError", "7"), "ValueError"),
    (None, "None"),
]


@pytest.mark.parametrize(("value", "text"), SHOWN)
def test_values_are_shown_short(value, text):
    assert shown_value(value) == text


def test_long_arrays_are_shown_with_a_gap():
    assert "..." in shown_value(np.arange(1000.0))
    assert len(shown_value(np.arange(1000.0))) < 100


scalars = st.none() | st.booleans() | st.integers(-(2**62), 2**62) | st.floats(allow_nan=False, allow_infinity=False) | st.text()
arrays = hnp.arrays(
    st.sampled_from([float, np.float32, np.int64, np.int16, bool]),
    hnp.array_shapes(min_dims=0),
    elements={"allow_nan": False, "allow_infinity": False},
    fill=st.nothing(),
).filter(lambda array: array.dtype.kind != "f" or np.isfinite(array).all())
values = st.recursive(
    scalars | arrays,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=5) | st.sampled_from(["array", "dict"]), inner),
    max_leaves=10,
)


@given(values)
def test_what_is_stored_comes_back_the_same(value):
    text = json.dumps(stored(value), allow_nan=False)
    assert identical(as_given(restored(json.loads(text))), as_given(value))


def test_nan_cannot_be_stored_unnoticed():
    with pytest.raises(ValueError, match="not JSON compliant"):
        json.dumps(stored({"a": math.nan}), allow_nan=False)
