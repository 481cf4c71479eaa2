"""Where right ends and wrong begins."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from course.tolerances import ABSOLUTE, ANGLE, FIRST_AXIS, LAST_AXIS, ONE_QUANTITY, RELATIVE, Tolerance

magnitudes = st.floats(1e-12, 1e12)
signs = st.sampled_from([-1.0, 1.0])


def right(tolerance, given_, expected):
    return tolerance.quantities_right(np.asarray(given_), np.asarray(expected)).tolist()


@given(magnitudes, signs, signs)
def test_the_edge_of_a_number(magnitude, sign, side):
    expected = sign * magnitude
    limit = ABSOLUTE + RELATIVE * magnitude
    assert right(ONE_QUANTITY, expected + side * limit * 0.999, expected) == [True]
    assert right(ONE_QUANTITY, expected + side * limit * 1.001, expected) == [False]


SHAPES = [
    (ONE_QUANTITY, (), [1]),
    (ONE_QUANTITY, (4,), [4]),
    (ONE_QUANTITY, (2, 3), [6]),
    (LAST_AXIS, (), [1]),
    (LAST_AXIS, (3,), [1, 1, 1]),
    (LAST_AXIS, (5, 3), [5, 5, 5]),
    (LAST_AXIS, (5, 2, 3), [10, 10, 10]),
    (LAST_AXIS, (0, 3), [0, 0, 0]),
    (FIRST_AXIS, (2,), [1, 1]),
    (FIRST_AXIS, (2, 5), [5, 5]),
    (FIRST_AXIS, (2, 0), [0, 0]),
]


@pytest.mark.parametrize(("tolerance", "shape", "sizes"), SHAPES, ids=str)
def test_quantities_lie_along_the_axis(tolerance, shape, sizes):
    rows = tolerance.by_quantity(np.arange(np.prod(shape)).reshape(shape))
    assert [len(row) for row in rows] == sizes
    assert rows.dtype == np.float64


def test_rows_hold_one_quantity_each():
    trajectory = np.array([[1, 20, 300], [2, 30, 400]])
    assert LAST_AXIS.by_quantity(trajectory).tolist() == [[1, 2], [20, 30], [300, 400]]
    assert FIRST_AXIS.by_quantity(trajectory).tolist() == [[1, 20, 300], [2, 30, 400]]


#: (tolerance, expected, where the error is, the error, which quantities are right)
BY_QUANTITY = [
    (ONE_QUANTITY, [1000.0, 0.1, 0.0], 2, 9e-3, [True]),
    (LAST_AXIS, [1000.0, 0.1, 0.0], 2, 9e-10, [True, True, True]),
    (LAST_AXIS, [1000.0, 0.1, 0.0], 2, 2e-9, [True, True, False]),
    (LAST_AXIS, [1000.0, 0.1, 0.0], 1, 2e-6, [True, False, True]),
    (LAST_AXIS, [[1.0, 100.0], [2.0, 0.0]], (1, 1), 9e-4, [True, True]),
    (LAST_AXIS, [[1.0, 100.0], [2.0, 0.0]], (1, 0), 9e-4, [False, True]),
    (FIRST_AXIS, [[1.0, 100.0], [2.0, 0.0]], (1, 1), 9e-4, [True, False]),
    (FIRST_AXIS, [[1.0, 100.0], [2.0, 0.0]], (0, 0), 9e-4, [True, True]),
]


@pytest.mark.parametrize(("tolerance", "expected", "where", "error", "outcome"), BY_QUANTITY, ids=str)
def test_each_quantity_has_a_magnitude_of_its_own(tolerance, expected, where, error, outcome):
    answer = np.array(expected)
    answer[where] += error
    assert right(tolerance, answer, expected) == outcome


trajectories = hnp.arrays(float, hnp.array_shapes(min_dims=2, max_dims=2, max_side=6), elements=st.floats(-1e6, 1e6))


@given(trajectories, st.sampled_from([ONE_QUANTITY, LAST_AXIS, FIRST_AXIS]))
def test_rounding_to_float32_is_right(values, tolerance):
    assert all(right(tolerance, values.astype(np.float32), values))


@pytest.mark.parametrize("value", [0.1, 1 / 3, 2 / 3])
def test_rounding_to_float16_is_wrong(value):
    assert right(ONE_QUANTITY, np.float16(value), value) == [False]


@given(st.floats(-1e3, 1e3), st.integers(-1000, 1000), signs)
def test_a_wrapped_angle_is_right_up_to_whole_turns(angle, turns, side):
    wrapped = Tolerance(axis=-1, angles=(1,))
    for error, outcome in [(0.0, True), (0.99 * ANGLE, True), (1.01 * ANGLE, False), (np.pi, False)]:
        given_ = [5.0, angle + 2 * np.pi * turns + side * error]
        assert right(wrapped, given_, [5.0, angle]) == [True, outcome]


def test_only_the_named_angles_are_wrapped():
    turn = 2 * np.pi
    assert right(Tolerance(axis=-1, angles=(2,)), [turn, turn, turn], [0.0, 0.0, 0.0]) == [False, False, True]
    assert right(Tolerance(angles=(0,)), [0.1, 0.2 + turn], [0.1, 0.2]) == [True]
    assert right(LAST_AXIS, [0.0, 0.0, turn], [0.0, 0.0, 0.0]) == [True, True, False]


def test_two_answers_that_leave_out_the_angle_can_be_compared():
    assert right(Tolerance(axis=-1, angles=(2,)), [1.0, 2.0], [1.0, 2.5]) == [True, False]
    assert right(Tolerance(axis=-1, angles=(2,)), 1.0, 1.0) == [True]


def test_two_empty_answers_can_be_compared():
    assert right(LAST_AXIS, [], []) == []


@pytest.mark.parametrize("tolerance", [ONE_QUANTITY, LAST_AXIS, FIRST_AXIS, Tolerance(angles=(0,))], ids=str)
def test_nan_is_never_right(tolerance):
    expected = np.array([1.0, 2.0])
    for row in range(2):
        answer = expected.copy()
        answer[row] = np.nan
        assert not all(right(tolerance, answer, expected))
        assert not all(right(tolerance, answer, answer))


@pytest.mark.parametrize("value", [np.inf, -np.inf, 1.7e308, -1.7e308])
def test_the_boundless_is_never_right(value):
    assert right(ONE_QUANTITY, [1.0, value], [1.0, 2.0]) == [False]


def test_entries_are_told_apart():
    entries = LAST_AXIS.entries_right(np.array([[1.0, 5.0], [2.5, 6.0]]), np.array([[1.0, 5.0], [2.0, 6.0]]))
    assert entries.tolist() == [[True, False], [True, True]]


def test_whole_numbers_and_truth_values_are_compared_as_numbers():
    assert right(ONE_QUANTITY, np.array([1, 0]), np.array([True, False])) == [True]
    assert right(ONE_QUANTITY, np.array([2, 0]), np.array([True, False])) == [False]
    # unsigned numbers must not run round
    assert right(ONE_QUANTITY, np.array([3], dtype=np.uint8), np.array([4], dtype=np.uint8)) == [False]
    assert right(ONE_QUANTITY, np.array([255], dtype=np.uint8), np.array([-1])) == [False]


def test_nothing_given_is_compared_without_being_changed():
    answer, expected = np.array([1.0, 7.0]), np.array([1.0, 7.0 + 2 * np.pi])
    Tolerance(axis=-1, angles=(1,)).entries_right(answer, expected)
    assert answer.tolist() == [1.0, 7.0]
    assert expected.tolist() == [1.0, 7.0 + 2 * np.pi]
