"""Answers to q1_symbolic(x1, y1, theta1, u, v, phi): right ones in honest styles, wrong ones as students write them."""

import math
import warnings

import numpy as np
import sympy as sp


def by_hand(x1, y1, theta1, u, v, phi):
    x2 = sp.cos(theta1) * u - sp.sin(theta1) * v + x1
    y2 = sp.sin(theta1) * u + sp.cos(theta1) * v + y1
    return x2, y2, theta1 + phi


def column(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return sp.Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]]) * sp.Matrix([u, v, phi]) + sp.Matrix([x1, y1, theta1])


def axis_angle(x1, y1, theta1, u, v, phi):
    turned = sp.rot_axis3(-theta1) * sp.ImmutableMatrix([u, v, 0])
    print(turned)
    return [x1 + turned[0], y1 + turned[1], theta1 + phi]


def either_module(x1, y1, theta1, u, v, phi):
    m = math if all(isinstance(value, int | float) for value in (x1, y1, theta1, u, v, phi)) else sp
    c, s = m.cos(theta1), m.sin(theta1)
    return np.array([x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi])


def lambdified(x1, y1, theta1, u, v, phi):
    symbols = sp.symbols("a:f")
    x, y, theta, forward, left, turn = symbols
    rule = (x + sp.cos(theta) * forward - sp.sin(theta) * left, y + sp.sin(theta) * forward + sp.cos(theta) * left, theta + turn)
    return tuple(part.subs(dict(zip(symbols, (x1, y1, theta1, u, v, phi), strict=True))) for part in rule)


def expanded_sum_of_angles(x1, y1, theta1, u, v, phi):
    """The displacement in polar form."""
    warnings.warn("polar form", stacklevel=2)
    length, direction = sp.sqrt(u**2 + v**2), sp.atan2(v, u)
    return sp.expand_trig(x1 + length * sp.cos(theta1 + direction)), y1 + length * sp.sin(theta1 + direction), phi + theta1


class Question:
    def __init__(self, functions):
        self.cos, self.sin = functions.cos, functions.sin

    def __call__(self, x1, y1, theta1, u, v, phi):
        forward = (self.cos(theta1), self.sin(theta1))
        left = (self.cos(theta1 + sp.pi / 2), self.sin(theta1 + sp.pi / 2))
        return [start + u * a + v * b for start, a, b in zip((x1, y1), forward, left, strict=True)] + [theta1 + phi]


def object_array(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    matrix = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]], dtype=object)
    return list(matrix @ np.array([u, v, phi], dtype=object) + np.array([x1, y1, theta1], dtype=object))


RIGHT = {
    "by hand": by_hand,
    "SymPy column": column,
    "rot_axis3, list": axis_angle,
    "math or SymPy": either_module,
    "own symbols, then subs": lambdified,
    "polar form, warns": expanded_sum_of_angles,
    "object that is called": Question(sp),
    "array of objects": object_array,
    "simplified": lambda x1, y1, theta1, u, v, phi: tuple(map(sp.sympify, by_hand(x1, y1, theta1, u, v, phi))),
}


def numpy_functions(x1, y1, theta1, u, v, phi):
    c, s = np.cos(theta1), np.sin(theta1)
    return np.array([x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi])


def array_of_floats(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return np.array([x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi], dtype=float)


def complex_numbers(x1, y1, theta1, u, v, phi):
    end = complex(x1, y1) + complex(u, v) * np.exp(1j * theta1)
    return end.real, end.imag, theta1 + phi


def numbers_and_wrong(x1, y1, theta1, u, v, phi):
    c, s = math.cos(theta1), math.sin(theta1)
    return x1 + c * u + s * v, y1 - s * u + c * v, theta1 + phi


def numbers_and_no_turn(x1, y1, theta1, u, v, phi):
    c, s = math.cos(theta1), math.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1


def overview_two(x1, y1, theta1, u, v, phi):
    return x1 + u * sp.cos(theta1), y1 + u * sp.sin(theta1), theta1 + phi


def row_vector(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    row = sp.Matrix([[u, v, phi]]) * sp.Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    return tuple(row + sp.Matrix([[x1, y1, theta1]]))


def row_returned(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return sp.Matrix([[x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi]])


def rot_axis3_as_it_is(x1, y1, theta1, u, v, phi):
    turned = sp.rot_axis3(theta1) * sp.Matrix([u, v, phi])
    return turned + sp.Matrix([x1, y1, theta1])


def exact_pi_lost(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, (theta1 + phi) % 3.14


def series_of_sine(x1, y1, theta1, u, v, phi):
    c, s = 1 - theta1**2 / 2, theta1 - theta1**3 / 6
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def sideways_by_new_heading(x1, y1, theta1, u, v, phi):
    new = theta1 + phi
    return x1 + sp.cos(theta1) * u - sp.sin(new) * v, y1 + sp.sin(theta1) * u + sp.cos(new) * v, new


def brackets(x1, y1, theta1, u, v, phi):
    return x1 + sp.cos(theta1 * u) - sp.sin(theta1 * v), y1 + sp.sin(theta1 * u) + sp.cos(theta1 * v), theta1 + phi


def tangent(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.tan(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def positive_sideways(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * sp.Abs(v), y1 + s * u + c * sp.Abs(v), theta1 + phi


def text(x1, y1, theta1, u, v, phi):
    return sp.latex(x1 + sp.cos(theta1) * u), sp.latex(y1 + sp.sin(theta1) * u), sp.latex(theta1 + phi)


def x_and_y_only_in_a_matrix(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return sp.Matrix([[c, -s], [s, c]]) * sp.Matrix([u, v]) + sp.Matrix([x1, y1])


def whole_numbers_only(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return sp.floor(x1 + c * u - s * v), sp.floor(y1 + s * u + c * v), theta1 + phi


def heading_in_degrees(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, sp.deg(theta1 + phi)


WRONG = {
    "np.cos": (numpy_functions, "NumPy cannot take symbols", "plain"),
    "dtype=float": (array_of_floats, "symbols do not fit into an array of floats", "plain"),
    "complex()": (complex_numbers, "complex() needs numbers", "plain"),
    "math, transposed": (numbers_and_wrong, "wrong sign and numbers only", "plain"),
    "math, heading kept": (numbers_and_no_turn, "no phi and numbers only", "plain"),
    "overview 2": (overview_two, "v left out", "plain"),
    "row times matrix": (row_vector, "the transpose", "plain"),
    "row": (row_returned, "(1, 3)", "plain"),
    "rot_axis3": (rot_axis3_as_it_is, "SymPy's rot_axis3 turns the other way", "plain"),
    "modulo 3.14": (exact_pi_lost, "heading wrapped with a rounded pi", "subtle"),
    "series": (series_of_sine, "sine and cosine cut off", "subtle"),
    "two headings": (sideways_by_new_heading, "v turned by the new heading", "subtle"),
    "brackets": (brackets, "cos(theta u)", "subtle"),
    "tan": (tangent, "tan for sin", "subtle"),
    "positive v": (positive_sideways, "abs(v)", "subtle"),
    "LaTeX": (text, "text instead of expressions", "plain"),
    "two by two": (x_and_y_only_in_a_matrix, "the heading is missing", "plain"),
    "floor": (whole_numbers_only, "whole metres", "subtle"),
    "degrees out": (heading_in_degrees, "theta2 in degrees", "plain"),
}
