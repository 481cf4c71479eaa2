"""Robots: the parameters of the slides, and what is refused."""

import subprocess
import sys
from dataclasses import FrozenInstanceError, asdict, replace

import numpy as np
import pytest

from course.robots import BEEGO, ICART, ROBOTS, Robot


@pytest.mark.parametrize(
    ("robot", "expected"),
    [
        (ICART, ("i-Cart", 0.14457758, -0.3045, 150, 400, 1, 1, -1)),
        (BEEGO, ("Beego", 0.0406, 0.2765, 54.0699, 2048, 1, -1, 1)),
    ],
)
def test_named_robots(robot, expected):
    assert tuple(asdict(robot).values()) == expected
    assert ROBOTS[robot.name] is robot


@pytest.mark.parametrize(("robot", "expected"), [(ICART, 1.514e-5), (BEEGO, 2.304e-6)])
def test_metres_per_count_are_those_of_the_real_robots(robot, expected):
    assert 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev) == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("name", ["radius", "tread", "gear", "counts_per_rev"])
@pytest.mark.parametrize("value", [0, 0.0, np.nan, np.inf, -np.inf, "0.1", None])
def test_impossible_sizes_are_refused_by_name(name, value):
    with pytest.raises(ValueError, match=f"^{name} must be a finite number"):
        replace(ICART, **{name: value})


@pytest.mark.parametrize("name", ["radius", "gear", "counts_per_rev"])
def test_only_the_tread_may_be_negative(name):
    with pytest.raises(ValueError, match=f"^{name} must be positive"):
        replace(ICART, **{name: -1.0})
    assert replace(BEEGO, tread=-0.2765).tread == -0.2765


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("right_counter", 0),
        ("right_counter", 3),
        ("right_counter", "1"),
        ("sign_right", 0),
        ("sign_left", 2),
        ("sign_left", None),
    ],
)
def test_counters_and_signs_are_choices(name, value):
    with pytest.raises(ValueError, match=f"^{name} must be -?1 or -?[12], not"):
        replace(ICART, **{name: value})


def test_refusals_come_in_both_languages():
    with pytest.raises(ValueError, match="tread") as refusal:
        replace(ICART, tread=0)
    english, japanese = str(refusal.value).split("\n")
    assert "other than zero" in english
    assert "なければなりません" in japanese


def test_numbers_of_numpy_are_numbers():
    sizes = {"radius": np.float32(0.05), "gear": np.int64(30), "right_counter": np.int64(2), "sign_left": np.float64(-1)}
    assert replace(BEEGO, **sizes).gear == 30


@pytest.mark.parametrize(("right", "left"), [(1, 2), (2, 1)])
def test_the_left_counter_is_the_other_one(right, left):
    assert replace(BEEGO, right_counter=right).left_counter == left


def test_a_robot_is_a_value():
    assert Robot(**asdict(ICART)) == ICART
    with pytest.raises(FrozenInstanceError):
        ICART.tread = 0.3045


def test_importing_the_data_side_of_the_course_draws_in_neither_matplotlib_nor_scipy():
    code = "import sys, course.datasets; print(*{'matplotlib', 'scipy', 'pandas', 'IPython'}.intersection(sys.modules))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == ""
