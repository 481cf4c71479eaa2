"""Answers to body_velocity_matrix(radius_right, radius_left, tread): right ones in honest styles, wrong ones as students write them."""

import warnings

import numpy as np


def nested_list(radius_right, radius_left, tread):
    return [[radius_right / 2, radius_left / 2], [radius_right / tread, -radius_left / tread]]


def product(radius_right, radius_left, tread):
    return np.array([[0.5, 0.5], [1 / tread, -1 / tread]]) @ np.diag([radius_right, radius_left])


def inverse_of_control(radius_right, radius_left, tread):
    control = np.array([[1 / radius_right, tread / 2 / radius_right], [1 / radius_left, -tread / 2 / radius_left]])
    return np.linalg.inv(control)


def column_by_column(radius_right, radius_left, tread):
    def velocity(omega_right, omega_left):
        right, left = radius_right * omega_right, radius_left * omega_left
        return (right + left) / 2, (right - left) / tread

    return np.column_stack([velocity(1, 0), velocity(0, 1)])


def filled(radius_right, radius_left, tread):
    warnings.warn("filling", stacklevel=1)
    m = np.zeros((2, 2), dtype=np.float32)
    for j, (radius, sign) in enumerate([(radius_right, 1), (radius_left, -1)]):
        m[0, j], m[1, j] = radius / 2, sign * radius / tread
    return m


def tuples(radius_right, radius_left, tread):
    print("tread", tread)
    return (radius_right * 0.5, radius_left * 0.5), (radius_right / tread, radius_left / -tread)


class Matrix:
    """The outer product of what the wheels have in common, then the signs."""

    def __call__(self, radius_right, radius_left, tread):
        return np.outer([1 / 2, 1 / tread], [radius_right, radius_left]) * [[1, 1], [1, -1]]


RIGHT = {
    "nested list": nested_list,
    "product with a diagonal": product,
    "inverse of control": inverse_of_control,
    "column by column": column_by_column,
    "filled, float32, warns": filled,
    "tuples, prints": tuples,
    "object with __call__": Matrix(),
}


def one_radius(radius_right, radius_left, tread):
    r = radius_right
    return r * np.array([[1 / 2, 1 / 2], [1 / tread, -1 / tread]])


def average_radius(radius_right, radius_left, tread):
    return nested_list(*[np.mean([radius_right, radius_left])] * 2, tread)


def left_first(radius_left, radius_right, tread):
    return nested_list(radius_right, radius_left, tread)


def left_column_first(radius_right, radius_left, tread):
    return np.array(nested_list(radius_right, radius_left, tread))[:, ::-1]


def omega_row_first(radius_right, radius_left, tread):
    return np.flipud(nested_list(radius_right, radius_left, tread))


def turned_round(radius_right, radius_left, tread):
    return np.transpose(nested_list(radius_right, radius_left, tread))


def no_minus(radius_right, radius_left, tread):
    return np.abs(nested_list(radius_right, radius_left, tread)) * [[1, 1], [np.sign(tread)] * 2]


def left_positive(radius_right, radius_left, tread):
    return np.array(nested_list(radius_right, radius_left, tread)) * [[1], [-1]]


def length_of_tread(radius_right, radius_left, tread):
    return nested_list(radius_right, radius_left, max(tread, -tread))


def no_half(radius_right, radius_left, tread):
    return np.array(nested_list(radius_right, radius_left, tread)) * [[2], [1]]


def d_of_notes_003(radius_right, radius_left, tread):
    return nested_list(radius_right, radius_left, tread / 2)


def r_over_2d(radius_right, radius_left, tread):
    return nested_list(radius_right, radius_left, 2 * tread)


def diameters(radius_right, radius_left, tread):
    return nested_list(2 * radius_right, 2 * radius_left, tread)


def for_wheel_speeds(radius_right, radius_left, tread):
    return nested_list(1, 1, tread)


def inverse_returned(radius_right, radius_left, tread):
    return inverse_of_control(radius_right, radius_left, tread) @ np.linalg.matrix_power(
        np.linalg.inv(nested_list(radius_right, radius_left, tread)), 2
    )


def tread_on_top(radius_right, radius_left, tread):
    return nested_list(radius_right, radius_left, 1 / tread)


def only_one_divided(radius_right, radius_left, tread):
    return [[radius_right / 2, radius_left / 2], [radius_right / tread, -radius_left]]


def lower_radii_exchanged(radius_right, radius_left, tread):
    m = np.array(nested_list(radius_right, radius_left, tread))
    m[1] = -m[1, ::-1]
    return m


def integers(radius_right, radius_left, tread):
    m = np.array([[radius_right, radius_left], [radius_right, -radius_left]])
    m[0] = m[0] / 2
    m[1] = m[1] / tread
    return m


def flattened(radius_right, radius_left, tread):
    return np.ravel(nested_list(radius_right, radius_left, tread))


def applied(radius_right, radius_left, tread):
    return np.array(nested_list(radius_right, radius_left, tread)) @ [1, 1]


def three_places(radius_right, radius_left, tread):
    return np.around(nested_list(radius_right, radius_left, tread), 3)


def i_cart(radius_right, radius_left, tread):
    return nested_list(0.14825, 0.14857, -0.3045)


def with_pose_rows(radius_right, radius_left, tread):
    m = nested_list(radius_right, radius_left, tread)
    return [m[0], [0.0, 0.0], m[1]]


def one_entry_sign(radius_right, radius_left, tread):
    m = np.array(nested_list(radius_right, radius_left, tread))
    m[0, 1] *= np.sign(tread)
    return m


WRONG = {
    "one radius": (one_radius, "right one for both", "plain"),
    "average radius": (average_radius, "for both", "plain"),
    "left argument first": (left_first, "radii exchanged", "plain"),
    "left column first": (left_column_first, "columns exchanged", "plain"),
    "omega row first": (omega_row_first, "rows exchanged", "plain"),
    "transposed": (turned_round, "rows and columns", "plain"),
    "no minus": (no_minus, "omega from the sum", "plain"),
    "left positive": (left_positive, "omega reversed", "plain"),
    "length of the tread": (length_of_tread, "sign lost", "plain"),
    "no half": (no_half, "V twice", "plain"),
    "half tread": (d_of_notes_003, "omega twice", "plain"),
    "r / 2T": (r_over_2d, "omega half", "plain"),
    "diameters": (diameters, "all twice", "plain"),
    "for wheel speeds": (for_wheel_speeds, "no radii", "plain"),
    "inverse": (inverse_returned, "control, not odometry", "plain"),
    "tread on top": (tread_on_top, "multiplied", "plain"),
    "one divided": (only_one_divided, "no tread in the last entry", "subtle"),
    "radii exchanged below": (lower_radii_exchanged, "second row", "plain"),
    "integers": (integers, "whole numbers cut off", "subtle"),
    "flattened": (flattened, "(4,)", "plain"),
    "applied": (applied, "(2,)", "plain"),
    "three places": (three_places, "rounded", "subtle"),
    "i-Cart": (i_cart, "arguments unused", "subtle"),
    "with a row for y": (with_pose_rows, "(3, 2)", "plain"),
    "sign of one entry": (one_entry_sign, "sign of the tread in V", "subtle"),
}
