"""Answers to from_compass(x, y, theta): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def quarter_minus(x, y, theta):
    return x, y, np.pi / 2 - theta


def arctan2_of_the_slide(x, y, theta):
    """The slide moves by sin theta along x and cos theta along y."""
    return np.array([x, y, np.arctan2(np.cos(theta), np.sin(theta))])


def pointer(x, y, theta):
    return [x, y, cmath.phase(cmath.rect(1, math.pi / 2) / cmath.rect(1, theta))]


def zero_to_two_pi(x, y, theta):
    print("compass", theta)
    warnings.warn("wrapped", stacklevel=1)
    return x, y, (math.pi / 2 - theta) % math.tau


def in_degrees_and_back(x, y, theta):
    return [x, y, np.radians(90.0 - np.degrees(theta))]


def single_precision(x, y, theta):
    return np.array([x, y, np.float32(np.pi / 2) - np.float32(theta)], dtype=np.float32)


def matrix(x, y, theta):
    return np.diag([1.0, 1.0, -1.0]) @ [x, y, theta] + np.array([0, 0, np.pi / 2])


class Compass:
    north = 5 * math.pi / 2

    def __call__(self, x, y, theta):
        return x, y, self.north - theta


RIGHT = {
    "pi/2 - theta": quarter_minus,
    "arctan2": arctan2_of_the_slide,
    "complex": pointer,
    "0 to 2 pi, prints and warns": zero_to_two_pi,
    "degrees and back": in_degrees_and_back,
    "float32": single_precision,
    "matrix": matrix,
    "object, one turn more": Compass(),
}


def minus_quarter(x, y, theta):
    return x, y, theta - np.pi / 2


def arctan2_as_usual(x, y, theta):
    return x, y, np.arctan2(np.sin(theta), np.cos(theta))


def arctan_of_the_quotient(x, y, theta):
    return x, y, math.atan(math.cos(theta) / math.sin(theta)) if math.sin(theta) else math.pi / 2


def ned_to_enu(x, y, theta):
    return y, x, np.pi / 2 - theta


def ninety(x, y, theta):
    return x, y, 90 - theta


def degrees_out(x, y, theta):
    return x, y, 90 - np.degrees(theta)


def mathematical(x, y, theta):
    return x, y, 2 * np.pi - theta


def north_up(x, y, theta):
    return x, y, np.pi / 2 + theta


def opposite(x, y, theta):
    return x, y, 3 * np.pi / 2 - theta


def rotated(x, y, theta):
    c, s = np.cos(np.pi / 2), np.sin(np.pi / 2)
    return c * x - s * y, s * x + c * y, np.pi / 2 - theta


def moved(x, y, theta):
    return x + np.sin(theta), y + np.cos(theta), np.pi / 2 - theta


def positive_only(x, y, theta):
    heading = np.pi / 2 - theta
    return x, y, heading if heading >= 0 else -heading


def half_range(x, y, theta):
    heading = np.pi / 2 - theta
    return x, y, heading + np.pi if heading < -np.pi else heading


def two_values(x, y, theta):
    return np.array([x, y]), np.pi / 2 - theta


def only_heading(x, y, theta):
    return np.pi / 2 - theta


def rough(x, y, theta):
    return x, y, 1.57 - theta


def whole(x, y, theta):
    return np.array([x, y, np.pi / 2 - theta], dtype=int)


def complex_pair(x, y, theta):
    return complex(x, y), cmath.exp(1j * (math.pi / 2 - theta))


def text(x, y, theta):
    return f"{x}, {y}, {np.pi / 2 - theta}"


WRONG = {
    "theta - pi/2": (minus_quarter, "sign", "plain"),
    "arctan2(sin, cos)": (arctan2_as_usual, "heading unchanged", "plain"),
    "atan": (arctan_of_the_quotient, "quadrant lost", "subtle"),
    "NED to ENU": (ned_to_enu, "axes exchanged as well", "plain"),
    "90 - theta": (ninety, "degrees and rad mixed", "plain"),
    "degrees": (degrees_out, "degrees out", "plain"),
    "2 pi - theta": (mathematical, "no offset", "plain"),
    "pi/2 + theta": (north_up, "sense of rotation kept", "plain"),
    "3 pi/2 - theta": (opposite, "opposite", "plain"),
    "position rotated": (rotated, "position turned as well", "plain"),
    "moved by one": (moved, "moves as on the slide", "subtle"),
    "positive only": (positive_only, "sign lost", "plain"),
    "half a turn added": (half_range, "pi in place of 2 pi", "subtle"),
    "two values": (two_values, "a pair of unequal parts", "plain"),
    "heading only": (only_heading, "one number", "plain"),
    "1.57": (rough, "quarter turn rounded", "subtle"),
    "whole numbers": (whole, "cut off", "subtle"),
    "complex": (complex_pair, "complex numbers", "plain"),
    "text": (text, "a text", "plain"),
}
