"""Answers to invert(a): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def transform(p):
    c, s = np.cos(p[2]), np.sin(p[2])
    return np.array([[c, -s, p[0]], [s, c, p[1]], [0.0, 0.0, 1.0]])


def formula(a):
    x, y, theta = a
    c, s = np.cos(theta), np.sin(theta)
    return np.array([-(c * x + s * y), s * x - c * y, -theta])


def inverse_matrix(a):
    m = np.linalg.inv(transform(a))
    return m[0, 2], m[1, 2], math.atan2(m[1, 0], m[0, 0])


def solved(a):
    x, y, _ = np.linalg.solve(transform(a), [0.0, 0.0, 1.0])
    return [x, y, (-a[2]) % math.tau]


def complex_way(a):
    z = -complex(a[0], a[1]) * cmath.rect(1, -a[2])
    return z.real, z.imag, -a[2]


def transposed_rotation(a):
    R = transform(a)[:2, :2]
    return np.append(-R.T @ np.array(a[:2], dtype=float), -a[2])


def single_precision(a):
    return formula(np.array(a, dtype=np.float32)).astype(np.float32)


def polar(a):
    print("inverse of", a)
    warnings.warn("polar", stacklevel=1)
    distance, direction = math.hypot(a[0], a[1]), math.atan2(a[1], a[0])
    return (distance * math.cos(direction - a[2] + math.pi), distance * math.sin(direction - a[2] + math.pi), 2 * math.pi - a[2])


class Inverter:
    def __call__(self, a):
        turned = transform([0, 0, -a[2]]) @ transform([-a[0], -a[1], 0])
        return [float(turned[0, 2]), float(turned[1, 2]), float(-a[2])]


RIGHT = {
    "formula": formula,
    "inverse matrix, atan2": inverse_matrix,
    "solved, 0 to 2 pi, list": solved,
    "complex": complex_way,
    "transposed rotation": transposed_rotation,
    "float32": single_precision,
    "polar, prints and warns": polar,
    "object, two matrices": Inverter(),
}


def matrix_elements_inverted(a):
    with np.errstate(all="ignore"):
        m = 1 / transform(a)
    return m[0, 2], m[1, 2], -a[2]


def transposed(a):
    m = transform(a).T
    return m[0, 2], m[1, 2], -a[2]


def bottom_row(a):
    m = transform(a).T
    return m[2, 0], m[2, 1], -a[2]


def minus_matrix(a):
    m = -transform(a)
    return m[0, 2], m[1, 2], -a[2]


def rows_times_matrix(a):
    x, y = -np.array(a[:2], float) @ transform(a)[:2, :2].T
    return x, y, -a[2]


def rotated_by_negated_twice(a):
    c, s = np.cos(-a[2]), np.sin(-a[2])
    return np.array([-(c * a[0] + s * a[1]), s * a[0] - c * a[1], -a[2]])


def turn_round(a):
    return np.array([a[0], a[1], a[2] + np.pi])


def mirrored(a):
    x, y, theta = formula(a)
    return x, -y, theta


def heading_only(a):
    return -a[2]


def in_place(a):
    a[0], a[1], a[2] = formula(a)
    return a


def overwritten(a):
    x, y, theta = a
    theta = -theta
    x = -x * math.cos(theta) + y * math.sin(theta)
    y = -x * math.sin(theta) - y * math.cos(theta)
    return x, y, theta


def cosine_by_root(a):
    s = math.sin(a[2])
    c = math.sqrt(1 - s * s)
    return -(c * a[0] + s * a[1]), s * a[0] - c * a[1], -a[2]


def right_near_zero(a):
    return np.array([-a[0] - a[2] * a[1], a[2] * a[0] - a[1], -a[2]])


def zero(a):
    return np.zeros(3)


def minus_of_a_list(a):
    return -a


def nothing(a):
    formula(a)


def four_decimals(a):
    return np.round(formula(a), 4)


def two_by_two(a):
    return transform(a)[:2, :2].T


WRONG = {
    "1 / T": (matrix_elements_inverted, "element by element", "plain"),
    "T'": (transposed, "transpose, last column", "plain"),
    "T' bottom": (bottom_row, "transpose, last row: (x, y, -theta)", "plain"),
    "-T": (minus_matrix, "every number negated", "plain"),
    "rows": (rows_times_matrix, "rotated the wrong way", "plain"),
    "negated twice": (rotated_by_negated_twice, "the minus in cos and sin and outside", "plain"),
    "turned round": (turn_round, "looks backwards, stays there", "subtle"),
    "mirrored": (mirrored, "y has the wrong sign", "plain"),
    "heading only": (heading_only, "one number", "plain"),
    "in place": (in_place, "a overwritten", "plain"),
    "overwritten": (overwritten, "y from the new x", "subtle"),
    "cosine by root": (cosine_by_root, "sign of the cosine lost", "subtle"),
    "small angles": (right_near_zero, "cos = 1, sin = theta", "subtle"),
    "zero": (zero, "what compose(a, invert(a)) must give", "subtle"),
    "-a": (minus_of_a_list, "negated; a list has no minus", "subtle"),
    "no return": (nothing, "no return", "plain"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "(2, 2)": (two_by_two, "only the rotation", "plain"),
}
