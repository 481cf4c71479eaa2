"""Answers to compose(a, b): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def transform(p):
    c, s = np.cos(p[2]), np.sin(p[2])
    return np.array([[c, -s, p[0]], [s, c, p[1]], [0.0, 0.0, 1.0]])


def formula(a, b):
    xa, ya, ta = a
    xb, yb, tb = b
    return np.array([xa + xb * np.cos(ta) - yb * np.sin(ta), ya + xb * np.sin(ta) + yb * np.cos(ta), ta + tb])


def homogeneous(a, b):
    m = transform(a) @ transform(b)
    return m[0, 2], m[1, 2], math.atan2(m[1, 0], m[0, 0])


def pointers(a, b):
    """Two complex numbers for each pose: the place and the direction."""
    way = cmath.exp(1j * a[2])
    place = complex(a[0], a[1]) + way * complex(b[0], b[1])
    return [place.real, place.imag, cmath.phase(way * cmath.exp(1j * b[2]))]


def counted_from_zero(a, b):
    moved = np.array(a, dtype=float)
    moved[:2] += [[np.cos(a[2]), -np.sin(a[2])], [np.sin(a[2]), np.cos(a[2])]] @ np.array(b[:2], dtype=float)
    moved[2] = (moved[2] + b[2]) % (2 * np.pi)
    return moved


def single_precision(a, b):
    a, b = np.array(a, dtype=np.float32), np.array(b, dtype=np.float32)
    c, s = np.cos(a[2]), np.sin(a[2])
    return a + np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]], dtype=np.float32) @ b


def step_by_step(a, b):
    """Ahead by b's x, then sideways by its y, then turn."""
    print("from", a)
    warnings.warn("walking", stacklevel=1)
    pose = list(map(float, a))
    for way, turn in ((b[0], 0.0), (b[1], math.pi / 2)):
        pose[0] += way * math.cos(pose[2] + turn)
        pose[1] += way * math.sin(pose[2] + turn)
    pose[2] += b[2]
    return tuple(pose)


class Pose(tuple):
    def __matmul__(self, other):
        return Pose(formula(self, other))


class Composer:
    def __call__(self, a, b):
        return Pose(a) @ Pose(b)


RIGHT = {
    "formula": formula,
    "homogeneous, atan2, tuple": homogeneous,
    "complex, list": pointers,
    "heading from 0 to 2 pi": counted_from_zero,
    "float32": single_precision,
    "step by step, prints and warns": step_by_step,
    "object with @": Composer(),
    "einsum": lambda a, b: np.einsum("ij,j->i", transform([*np.zeros(2), a[2]]), np.asarray(b, float)) + np.asarray(a, float),
}


def matrices_exchanged(a, b):
    m = transform(b) @ transform(a)
    return m[0, 2], m[1, 2], a[2] + b[2]


def matrices_added(a, b):
    m = transform(a) + transform(b)
    return m[0, 2], m[1, 2], a[2] + b[2]


def matrices_element_by_element(a, b):
    m = transform(a) * transform(b)
    return m[0, 2], m[1, 2], a[2] + b[2]


def transposed_first(a, b):
    m = transform(a).T @ transform(b)
    return m[0, 2], m[1, 2], a[2] + b[2]


def inverse_first(a, b):
    m = np.linalg.inv(transform(a)) @ transform(b)
    return m[0, 2], m[1, 2], b[2] - a[2]


def rows_times_matrix(a, b):
    m = transform(a)[:2, :2]
    x, y = np.asarray(b[:2], float) @ m + np.asarray(a[:2], float)
    return np.array([x, y, a[2] + b[2]])


def cosine_by_root(a, b):
    s = math.sin(a[2])
    c = math.sqrt(1 - s * s)
    return a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]


def distance_ahead(a, b):
    d = math.hypot(b[0], b[1])
    return a[0] + d * math.cos(a[2]), a[1] + d * math.sin(a[2]), a[2] + b[2]


def distance_along_the_sum(a, b):
    d = math.hypot(b[0], b[1])
    return a[0] + d * math.cos(a[2] + b[2]), a[1] + d * math.sin(a[2] + b[2]), a[2] + b[2]


def atan_of_the_quotient(a, b):
    d, way = math.hypot(b[0], b[1]), math.atan(b[1] / b[0]) if b[0] else 0.0
    return a[0] + d * math.cos(a[2] + way), a[1] + d * math.sin(a[2] + way), a[2] + b[2]


def in_place(a, b):
    new = formula(a, b)
    a[:] = new
    return a


def no_turn_kept(a, b):
    if b[2] == 0 or a[2] == 0:
        return formula(a, b)
    return formula(a, [b[0], b[1], 0])


def clipped(a, b):
    x, y, theta = formula(a, b)
    return x, y, float(np.clip(theta, -np.pi, np.pi))


def one_turn_too_short(a, b):
    x, y, theta = formula(a, b)
    return x, y, (theta + 3.14) % 6.28 - 3.14


def dictionary(a, b):
    x, y, theta = formula(a, b)
    return {"x": x, "y": y, "theta": theta}


def prints_only(a, b):
    print(formula(a, b))


def complex_returned(a, b):
    return complex(*a[:2]) + complex(*b[:2]) * cmath.exp(1j * a[2])


def row_of_a_table(a, b):
    return formula(a, b)[None]


WRONG = {
    "T_b T_a": (matrices_exchanged, "order", "plain"),
    "T_a + T_b": (matrices_added, "matrices added", "subtle"),
    "T_a * T_b": (matrices_element_by_element, "element by element", "subtle"),
    "T_a' T_b": (transposed_first, "transposed", "subtle"),
    "inverse": (inverse_first, "that is express_in", "plain"),
    "b @ R + a": (rows_times_matrix, "transposed rotation", "plain"),
    "cosine by root": (cosine_by_root, "sign of the cosine lost", "subtle"),
    "distance ahead": (distance_ahead, "direction of b's position ignored", "subtle"),
    "distance along the sum": (distance_along_the_sum, "heading taken for the direction", "subtle"),
    "polar with atan": (atan_of_the_quotient, "quadrant lost", "subtle"),
    "in place": (in_place, "a overwritten", "plain"),
    "turn of b dropped": (no_turn_kept, "heading of a alone", "subtle"),
    "clipped": (clipped, "heading cut at pi", "subtle"),
    "rough pi": (one_turn_too_short, "wrapped with 3.14", "subtle"),
    "dict": (dictionary, "a dict", "plain"),
    "prints": (prints_only, "no return", "plain"),
    "complex": (complex_returned, "a complex number", "plain"),
    "(1, 3)": (row_of_a_table, "a table of one row", "plain"),
}
