"""Answers to to_compass(x, y, theta): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def quarter_minus(x, y, theta):
    return np.array([x, y, np.pi / 2 - theta])


def arctan2_from_y(x, y, theta):
    return x, y, math.atan2(math.cos(theta), math.sin(theta))


def bearing(x, y, theta):
    """Degrees from north as on a compass card, then rad again."""
    card = (90 - math.degrees(theta)) % 360
    return [x, y, math.radians(card)]


def pointer(x, y, theta):
    warnings.warn("complex", stacklevel=1)
    return x, y, -cmath.phase(cmath.exp(1j * theta) / 1j)


def small_loop(x, y, theta):
    heading = math.pi / 2 - theta
    while heading < 0:
        heading += math.tau
    while heading >= math.tau:
        heading -= math.tau
    print("heading", heading)
    return x, y, heading


def single_precision(x, y, theta):
    x, y, theta = np.array([x, y, theta], dtype=np.float32)
    return np.array([x, y, np.float32(np.pi / 2) - theta], dtype=np.float32)


class ToCompass:
    def __call__(self, x, y, theta):
        return {0: (x, y, math.pi / 2 - theta)}[0]


RIGHT = {
    "pi/2 - theta": quarter_minus,
    "arctan2": arctan2_from_y,
    "compass card": bearing,
    "complex, warns": pointer,
    "wrapped by loops, prints": small_loop,
    "float32": single_precision,
    "object": ToCompass(),
    "lambda": lambda x, y, theta: (x, y, np.subtract(np.pi / 2, theta)),
}


def not_inverted(x, y, theta):
    return x, y, theta + np.pi / 2


def minus_quarter(x, y, theta):
    return x, y, theta - np.pi / 2


def negated(x, y, theta):
    return np.array([x, y, -theta])


def swapped(x, y, theta):
    return np.array([y, x, theta])


def swapped_too(x, y, theta):
    return np.array([y, x, np.pi / 2 - theta])


def south(x, y, theta):
    return x, y, -theta - np.pi / 2


def in_degrees(x, y, theta):
    return x, y, (90 - np.degrees(theta)) % 360


def from_degrees(x, y, theta):
    return x, y, np.radians(90 - theta)


def direction_of_the_place(x, y, theta):
    return x, y, np.arctan2(x, y)


def direction_of_the_place_from_theta(x, y, theta):
    return x, y, np.arctan2(y, x) - theta


def first_quadrant(x, y, theta):
    return x, y, (np.pi / 2 - theta) % (np.pi / 2)


def wrapped_by_pi(x, y, theta):
    return x, y, (np.pi / 2 - theta) % np.pi


def fourth_quadrant_wrong(x, y, theta):
    heading = np.pi / 2 - theta
    return x, y, heading + np.pi if heading < 0 else heading


def y_down(x, y, theta):
    return x, -y, np.pi / 2 - theta


def polar(x, y, theta):
    return np.hypot(x, y), np.arctan2(x, y), np.pi / 2 - theta


def complement_by_arcsin(x, y, theta):
    return x, y, np.arcsin(np.cos(theta))


def column(x, y, theta):
    return np.array([[x], [y], [np.pi / 2 - theta]])


def nothing(x, y, theta):
    theta = np.pi / 2 - theta
    print(x, y, theta)


def two_decimals(x, y, theta):
    return round(x, 2), round(y, 2), round(np.pi / 2 - theta, 2)


WRONG = {
    "pi/2 + theta": (not_inverted, "sense of rotation kept", "plain"),
    "theta - pi/2": (minus_quarter, "sign", "plain"),
    "-theta": (negated, "no offset", "plain"),
    "axes exchanged": (swapped, "x and y exchanged, heading kept", "plain"),
    "axes exchanged too": (swapped_too, "x and y exchanged as well", "plain"),
    "from -y": (south, "opposite", "plain"),
    "degrees": (in_degrees, "degrees from 0 to 360", "plain"),
    "from degrees": (from_degrees, "theta taken for degrees", "plain"),
    "place": (direction_of_the_place, "bearing of the position", "plain"),
    "place less theta": (direction_of_the_place_from_theta, "bearing of the position, relative", "subtle"),
    "quarter turns": (first_quadrant, "modulo pi/2", "subtle"),
    "half turns": (wrapped_by_pi, "modulo pi", "plain"),
    "pi added below 0": (fourth_quadrant_wrong, "opposite when negative", "subtle"),
    "y down": (y_down, "sign of y", "plain"),
    "polar": (polar, "distance and bearing for x and y", "subtle"),
    "arcsin": (complement_by_arcsin, "rear half folded", "plain"),
    "column": (column, "(3, 1)", "plain"),
    "no return": (nothing, "no return", "plain"),
    "two decimals": (two_decimals, "rounded", "subtle"),
}
