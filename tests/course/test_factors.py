"""An answer that is right up to a constant factor is told which."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from course.answers import Question
from course.factors import factor_message
from course.ladder import Answered
from course.tolerances import FIRST_AXIS, LAST_AXIS, ONE_QUANTITY, Tolerance

G = 9.80665
POSES = [np.array([1.0, -2.0, 0.5]), np.array([3.0, 0.7, -1.5]), np.array([-4.0, 5.0, 2.5])]
NUMBERS = [np.array(1.5), np.array(-0.7), np.array(20.0)]


def told(given_, expected, tolerance=ONE_QUANTITY, questions=None, **more):
    answered = Answered("f", ("a", "gear"), tolerance, **more)
    asked = questions or [Question((1.0, 10.0))] * len(expected)
    return factor_message(answered, asked, [np.asarray(one) for one in given_], [np.asarray(one) for one in expected])


#: what the numbers were multiplied by, and a word of the message in each language
FACTORS = [
    (180 / np.pi, "degrees", "度"),
    (np.pi / 180, "converted once more", "もう一度変換"),
    (2 * np.pi, "turns taken for rad", "取り違え"),
    (1 / (2 * np.pi), "these are turns", "回転数のまま"),
    (np.pi, "π and 2π", "π と 2π"),
    (1 / np.pi, "1/π", "1/π 倍"),
    (G, "already converted", "二重"),
    (1 / G, "in g instead of m/s^2", "g のまま"),
    (-G, "direction of z", "z 軸"),
    (1000.0, "milli", "ミリ"),
    (1e-3, "1/1000", "1/1000"),
    (1e6, "used twice", "二重"),
    (60.0, "minutes", "分と秒"),
    (1 / 60, "1/60", "1/60"),
    (3.6, "km/h", "km/h"),
    (-1.0, "turned round", "向きが逆"),
    (2.0, "half missing", "1/2 が抜けて"),
    (0.5, "half too much", "1/2 が余分"),
    (-2.0, "missing half", "1/2 を見直"),
    (-0.5, "half too much", "余分な 1/2"),
    (4.0, "pulses and counts", "パルスとカウント"),
    (0.25, "1/4", "1/4"),
]


@pytest.mark.parametrize(("factor", "english", "japanese"), FACTORS)
def test_a_known_factor_is_named(factor, english, japanese):
    text = told([factor * number for number in NUMBERS], NUMBERS)
    assert english in text.en
    assert japanese in text.ja
    assert text.en.startswith("The result is right up to a constant factor in every case")


@given(st.sampled_from([factor for factor, _, _ in FACTORS]), st.lists(st.floats(-1e3, 1e3), min_size=2, max_size=5))
def test_the_factor_is_found_whatever_the_numbers(factor, numbers):
    assume(sum(abs(number) > 1e-3 for number in numbers) >= 2)
    expected = list(map(np.asarray, numbers))
    given_ = [factor * number for number in expected]
    text = told(given_, expected)
    right = all(ONE_QUANTITY.quantities_right(g, e).all() for g, e in zip(map(np.asarray, given_), expected, strict=True))
    assert (text is None) == right


#: where no factor must be told
NO_FACTOR = [
    ("right", NUMBERS, NUMBERS),
    ("no known factor", [1.7 * number for number in NUMBERS], NUMBERS),
    ("another factor in each case", [2 * NUMBERS[0], 3 * NUMBERS[1], 2 * NUMBERS[2]], NUMBERS),
    ("wrong in one case only", [2 * NUMBERS[0], NUMBERS[1], NUMBERS[2]], NUMBERS),
    ("nearly the factor", [60.01 * number for number in NUMBERS], NUMBERS),
    ("all zero", [0 * number for number in NUMBERS], NUMBERS),
    ("one telling case", [2 * NUMBERS[0], np.array(0.0)], [NUMBERS[0], np.array(0.0)]),
    ("an offset", [2 * number + 1e-3 for number in NUMBERS], NUMBERS),
    ("reversed", [np.array([3.0, 2.0, 1.0])] * 2, [np.array([1.0, 2.0, 3.0])] * 2),
]


@pytest.mark.parametrize(("given_", "expected"), [row[1:] for row in NO_FACTOR], ids=[row[0] for row in NO_FACTOR])
def test_what_is_no_constant_factor_is_not_called_one(given_, expected):
    assert told(given_, expected) is None


def scaled(poses, *factors):
    return [pose * np.array(factors) for pose in poses]


def test_a_quantity_alone_is_named():
    text = told(scaled(POSES, 1, 1, 180 / np.pi), POSES, LAST_AXIS, quantities=("x", "y", "theta"))
    assert text.en.startswith("theta is right up to a constant factor in every case: 180/π")
    assert " theta が正しい値の定数倍" in text.ja


def test_of_two_quantities_with_factors_the_first_is_told():
    text = told(scaled(POSES, 1, -1, 180 / np.pi), POSES, LAST_AXIS, quantities=("x", "y", "theta"))
    assert text.en.startswith("y is right up to a constant factor")
    assert "180" not in text.en


def test_a_quantity_without_a_factor_keeps_the_others_from_being_told():
    assert told(scaled(POSES, 1, 1.7, 2), POSES, LAST_AXIS, quantities=("x", "y", "theta")) is None


def test_angles_modulo_a_turn_have_no_factor():
    wrapped = Tolerance(axis=-1, angles=(2,))
    assert told(scaled(POSES, 1, 1, 2), POSES, wrapped, quantities=("x", "y", "theta")) is None
    assert told(scaled(POSES, 2, 1, 1), POSES, wrapped, quantities=("x", "y", "theta")) is not None


def test_pairs_of_arrays_go_by_their_first_axis():
    pairs = [np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]), np.array([[2.0, 2.0], [-1.0, 0.5]])]
    given_ = [pair * np.array([[1.0], [-1.0]]) for pair in pairs]
    assert told(given_, pairs, FIRST_AXIS, quantities=("V", "omega")).en.startswith("omega is right up to a constant factor")


GEARS = [(7.0,), (20.0,), (33.0,)]
GEAR = [
    (1, "the gear ratio:", "ギア比の分だけ大きく"),
    (2, "squared", "2 乗"),
    (-1, "one over the gear ratio", "ギア比の分だけ小さく"),
]


@pytest.mark.parametrize(("power", "english", "japanese"), GEAR)
def test_the_gear_is_a_factor_of_its_own_in_each_case(power, english, japanese):
    questions = [Question((1.0, *gear)) for gear in GEARS]
    given_ = [number * gear[0] ** power for number, gear in zip(NUMBERS, GEARS, strict=True)]
    text = told(given_, NUMBERS, questions=questions, gear=1)
    assert english in text.en
    assert japanese in text.ja
    assert told(given_, NUMBERS, questions=questions) is None


def test_whole_numbers_may_be_gears():
    questions = [Question((1.0, gear)) for gear in (7, 20, 33)]
    given_ = [number / question.args[1] for number, question in zip(NUMBERS, questions, strict=True)]
    assert "one over the gear" in told(given_, NUMBERS, questions=questions, gear=1).en


def test_no_factor_shows_a_hidden_number():
    numbers = [np.array(1.2345), np.array(-0.9876)]
    for factor, _, _ in FACTORS:
        text = told([factor * number for number in numbers], numbers)
        assert not any(shown in text.en + text.ja for shown in ("1.2345", "0.9876", f"{factor * 1.2345:.4g}"))


def test_counts_and_truth_values_are_scaled_as_numbers():
    assert "turned round" in told([np.array([-3, 5]), np.array([-7, 1])], [np.array([3, -5]), np.array([7, -1])]).en
    masks = [np.array([True, False, True]), np.array([False, True, True])]
    assert told([~mask for mask in masks], masks) is None
