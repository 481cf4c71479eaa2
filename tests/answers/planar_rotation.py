"""Answers to planar_rotation(theta): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np
import sympy as sp


def slide(theta):
    return np.array([[np.cos(theta), -np.sin(theta), 0], [np.sin(theta), np.cos(theta), 0], [0, 0, 1]])


def lists(theta):
    c, s = math.cos(theta), math.sin(theta)
    return [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]


def tuples_of_pointer(theta):
    pointer = cmath.exp(1j * theta)
    return (pointer.real, -pointer.imag, 0), (pointer.imag, pointer.real, 0), (0, 0, 1)


def filled_in(theta):
    matrix = np.eye(3)
    matrix[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
    print(matrix)
    return matrix


def halved_again_and_again(theta):
    """Squaring the rotation by a tiny angle."""
    small = theta / 2**20
    matrix = np.array([[1 - small**2 / 2, -small, 0], [small, 1 - small**2 / 2, 0], [0, 0, 1]])
    for _ in range(20):
        matrix = matrix @ matrix
    return matrix


def rodrigues(theta):
    cross = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 0]])
    return np.eye(3) + np.sin(theta) * cross + (1 - np.cos(theta)) * cross @ cross


def single_precision(theta):
    warnings.warn("float32", stacklevel=2)
    return slide(theta).astype(np.float32)


def recursion(theta):
    if abs(theta) > 1:
        half = np.array(recursion(theta / 2))
        return half @ half
    return lists(theta)


class Rotation:
    def __call__(self, theta):
        return np.column_stack([self.image(theta), self.image(theta + math.pi / 2), [0, 0, 1]])

    def image(self, angle):
        return [math.cos(angle), math.sin(angle), 0]


RIGHT = {
    "as on the slide": slide,
    "lists": lists,
    "complex pointer, tuples": tuples_of_pointer,
    "filled in, prints": filled_in,
    "squared twenty times": halved_again_and_again,
    "Rodrigues": rodrigues,
    "float32, warns": single_precision,
    "recursion": recursion,
    "object that is called": Rotation(),
    "SymPy": lambda theta: sp.rot_axis3(-theta),
}


def sympy_as_it_is(theta):
    return sp.rot_axis3(theta)


def shifted_quarter(theta):
    return slide(theta + np.pi / 2)


def all_four_the_same(theta):
    c = np.cos(theta)
    return np.array([[c, -c, 0], [c, c, 0], [0, 0, 1]])


def identity(theta):
    return np.eye(3)


def wrapped_to_half(theta):
    return slide(theta % np.pi)


def clipped(theta):
    return slide(min(max(theta, -np.pi), np.pi))


def only_left(theta):
    return slide(max(theta, 0))


def cosine_by_right_triangle(theta):
    t = np.tan(theta)
    c = 1 / np.sqrt(1 + t * t)
    return np.array([[c, -t * c, 0], [t * c, c, 0], [0, 0, 1]])


def four_decimals(theta):
    return np.round(slide(theta), 4)


def homogeneous_with_heading(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, theta], [s, c, theta], [0, 0, 1]])


def product_of_two(theta):
    return slide(theta) @ slide(theta).T


def inverse_matrix(theta):
    return np.linalg.inv(slide(theta))


def last_row_missing(theta):
    return slide(theta)[:2]


def stacked(theta):
    return slide(theta)[None]


def determinant(theta):
    return float(np.linalg.det(slide(theta)))


def prints_only(theta):
    print(slide(theta))


def angle_in_degrees_by_hand(theta):
    return slide(theta * 180 / 3.14)


def rough_pi(theta):
    return slide(theta * 3.14 / np.pi)


def skew(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[1, -s, 0], [s, 1, 0], [0, 0, 1]]) * c


def wrong_corner(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def whole_at_whole(theta):
    matrix = np.array([[theta] * 3] * 3)
    matrix[:] = slide(theta)
    return matrix


def outer_brackets(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([c, -s, 0], [s, c, 0], [0, 0, 1])


WRONG = {
    "rot_axis3": (sympy_as_it_is, "SymPy's rot_axis3 turns the other way", "plain"),
    "quarter turn too far": (shifted_quarter, "theta + pi/2", "subtle"),
    "cosines everywhere": (all_four_the_same, "no sine", "subtle"),
    "identity": (identity, "theta not used", "subtle"),
    "modulo pi": (wrapped_to_half, "wrapped to half a turn", "subtle"),
    "clipped": (clipped, "headings beyond half a turn cut off", "subtle"),
    "only left": (only_left, "negative headings become 0", "subtle"),
    "by the tangent": (cosine_by_right_triangle, "cosine always positive", "subtle"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "heading in the column": (homogeneous_with_heading, "theta in the last column", "subtle"),
    "times its transpose": (product_of_two, "the identity", "subtle"),
    "inverse": (inverse_matrix, "global to sensor", "plain"),
    "two rows": (last_row_missing, "(2, 3)", "plain"),
    "stacked": (stacked, "(1, 3, 3)", "plain"),
    "determinant": (determinant, "one number", "plain"),
    "prints": (prints_only, "no return", "plain"),
    "degrees with 3.14": (angle_in_degrees_by_hand, "converted with a rough pi", "subtle"),
    "rough pi": (rough_pi, "0.05 % off in the angle", "subtle"),
    "skew": (skew, "cosine as a common factor", "subtle"),
    "about x": (wrong_corner, "the block stands in the wrong corner", "plain"),
    "integer heading": (whole_at_whole, "dtype of theta", "plain"),
    "brackets": (outer_brackets, "np.array(row, row, row)", "plain"),
}
