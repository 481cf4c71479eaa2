"""Robots of the course: the numbers and signs that turn encoder counts into motion."""

import math
from dataclasses import dataclass
from numbers import Real

from course.language import Text

NOT_A_SIZE = Text(
    "{name} must be a finite number other than zero, not {value!r}.",
    "{name}は0でない有限の数でなければなりません。{value!r}は使えません。",
)
NOT_POSITIVE = Text(
    "{name} must be positive, not {value!r}: a wheel that counts backwards is given by its sign.",
    "{name}は正でなければなりません。{value!r}は使えません。逆向きに数える車輪は符号で表します。",
)
NOT_A_CHOICE = Text(
    "{name} must be {choices}, not {value!r}.",
    "{name}は{choices}のどちらかです。{value!r}は使えません。",
)


@dataclass(frozen=True)
class Robot:
    """A differential-drive robot as its odometry sees it.

    - `name`: what the robot is called
    - `radius`: wheel radius [m]
    - `tread`: distance between the wheels' points of contact [m], **with the sign of the yaw**, see below
    - `gear`: turns of the encoder (motor) shaft for one turn of the wheel
    - `counts_per_rev`: counts for one turn of the encoder shaft, after 4x decoding
    - `right_counter`: which counter belongs to the right wheel, 1 or 2; the other one is the left wheel's
    - `sign_right`, `sign_left`: +1 if that wheel's counter counts up while the robot drives forward, else -1.
      The two differ, because the motors are mounted as mirror images of each other.

    The yaw rate is (v_r - v_l) / tread. With a positive tread it is positive to the left, that is counter-clockwise
    as seen from above (x forward, y left, z up). A negative tread is no slip of the pen: it makes the same formula
    count clockwise (x forward, y right, z down), as the IMU of the slides does, so that wheels and gyro agree in
    sign. Leaving the sign out mirrors the path against the IMU's.

    Raises ValueError if a size is zero, not finite or not a number, if radius, gear or counts_per_rev is negative,
    if right_counter is neither 1 nor 2, or if a sign is neither +1 nor -1.

    Source: slides 000, overview of wheel odometry 5 and 6 (formulas) and the practical training (parameters).
    """

    name: str
    radius: float
    tread: float
    gear: float
    counts_per_rev: float
    right_counter: int
    sign_right: int
    sign_left: int

    def __post_init__(self) -> None:
        """Refuse numbers that no robot can have."""
        for size in ("radius", "tread", "gear", "counts_per_rev"):
            _check_size(size, getattr(self, size), signed=size == "tread")
        _check_choice("right_counter", self.right_counter, (1, 2))
        _check_choice("sign_right", self.sign_right, (1, -1))
        _check_choice("sign_left", self.sign_left, (1, -1))

    @property
    def left_counter(self) -> int:
        """Which counter belongs to the left wheel: the one that is not the right wheel's."""
        return 3 - self.right_counter


def _check_size(name: str, value: object, *, signed: bool) -> None:
    if not isinstance(value, Real) or not math.isfinite(value) or value == 0:
        raise _refusal(NOT_A_SIZE, name=name, value=value)
    if not signed and value < 0:
        raise _refusal(NOT_POSITIVE, name=name, value=value)


def _check_choice(name: str, value: object, choices: tuple[int, int]) -> None:
    if not isinstance(value, Real) or value not in choices:
        either = Text(f"{choices[0]} or {choices[1]}", f"{choices[0]}か{choices[1]}")
        raise _refusal(NOT_A_CHOICE, name=name, value=value, choices=either)


def _refusal(problem: Text, **values: object) -> ValueError:
    message = problem.format(**values)
    return ValueError(f"{message.en}\n{message.ja}")


ICART = Robot(
    name="i-Cart",
    radius=0.14457758,
    tread=-0.3045,
    gear=150,
    counts_per_rev=400,
    right_counter=1,
    sign_right=1,
    sign_left=-1,
)
"""The robot whose parameters the slides print: right wheel = +counter 1, left wheel = -counter 2.

Its tread is negative: its yaw counts clockwise as seen from above (z down). Slides 000, practical training.
"""

BEEGO = Robot(
    name="Beego",
    radius=0.0406,
    tread=0.2765,
    gear=54.0699,
    counts_per_rev=2048,
    right_counter=1,
    sign_right=-1,
    sign_left=1,
)
"""The robot that the slides picture: right wheel = -counter 1, left wheel = +counter 2.

Its tread is positive: its yaw counts counter-clockwise as seen from above (z up).
"""

ROBOTS = {robot.name: robot for robot in (ICART, BEEGO)}
"""The course's robots by name: "i-Cart" and "Beego"."""
