"""Answers to body_velocity(v_right, v_left, tread): right ones in honest styles, wrong ones as students write them."""

import warnings

import numpy as np


def slides(v_right, v_left, tread):
    r, l_ = np.asarray(v_right), np.asarray(v_left)
    return (r + l_) / 2, (r - l_) / tread


def matrix(v_right, v_left, tread):
    return np.array([[0.5, 0.5], [1 / tread, -1 / tread]]) @ np.array([v_right, v_left], dtype=float)


def solved(v_right, v_left, tread):
    """v_r = V + omega T/2 and v_l = V - omega T/2, solved."""
    A = np.array([[1, tread / 2], [1, -tread / 2]])
    wheels = np.array([v_right, v_left], float).reshape(2, -1)
    V, omega = np.linalg.solve(A, wheels)
    return (float(V[0]), float(omega[0])) if np.ndim(v_right) == 0 else (V, omega)


def loop(v_right, v_left, tread):
    if np.ndim(v_right) == 0:
        return [0.5 * (v_right + v_left), (v_right - v_left) / tread]
    pairs = [loop(r, s, tread) for r, s in zip(v_right, v_left, strict=True)]
    return [[p[0] for p in pairs], [p[1] for p in pairs]]


def mean_and_difference(v_right, v_left, tread):
    both = np.stack([v_right, v_left]).astype(float)
    print("wheels", both)
    return np.mean(both, axis=0), -np.diff(both, axis=0)[0] / tread


def complex_sum(v_right, v_left, tread):
    z = np.asarray(v_right) * (0.5 + 1j / tread) + np.asarray(v_left) * (0.5 - 1j / tread)
    return z.real, z.imag


def single_precision(v_right, v_left, tread):
    warnings.warn("float32", stacklevel=1)
    r, s = np.float32(v_right), np.float32(v_left)
    return np.array([(r + s) / 2, (r - s) / np.float32(tread)], dtype=np.float32)


class Robot:
    """Turns about the left wheel at omega; the middle of the axle is half a tread away from it."""

    def __call__(self, v_right, v_left, tread):
        omega = np.subtract(v_right, v_left) / tread
        return np.add(v_left, omega * tread / 2), omega


RIGHT = {
    "as on the slides": slides,
    "matrix": matrix,
    "solved": solved,
    "loop, lists": loop,
    "mean and diff, prints": mean_and_difference,
    "complex": complex_sum,
    "float32, one array, warns": single_precision,
    "object with __call__": Robot(),
}


def sum_for_velocity(v_right, v_left, tread):
    return np.add(v_right, v_left), np.subtract(v_right, v_left) / tread


def notes_003(v_right, v_left, tread):
    d = tread / 2
    return np.add(v_right, v_left) / 2, np.subtract(v_right, v_left) / d


def notes_003_with_tread(v_right, v_left, tread):
    return np.add(v_right, v_left) / 2, 0.5 * np.subtract(v_right, v_left) / tread


def arguments_swapped(v_left, v_right, tread):
    return slides(v_right, v_left, tread)


def repaired_tread(v_right, v_left, tread):
    return slides(v_right, v_left, np.sqrt(tread**2))


def sign_from_speeds(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return V, np.abs(omega) * np.sign(np.subtract(v_right, v_left))


def omega_first(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return omega, V


def straight_turns(v_right, v_left, tread):
    V, _ = slides(v_right, v_left, tread)
    return V, 2 * V / tread


def no_tread(v_right, v_left, tread):
    return np.add(v_right, v_left) / 2, np.subtract(v_right, v_left)


def tread_on_top(v_right, v_left, tread):
    return np.add(v_right, v_left) / 2, np.subtract(v_right, v_left) * tread


def precedence(v_right, v_left, tread):
    r, s = np.asarray(v_right), np.asarray(v_left)
    return r + s / 2, r - s / tread


def precedence_in_omega(v_right, v_left, tread):
    r, s = np.asarray(v_right), np.asarray(v_left)
    return (r + s) / 2, r - s / tread


def speed_not_velocity(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return np.sqrt(V**2), omega


def geometric_mean(v_right, v_left, tread):
    r, s = np.asarray(v_right, float), np.asarray(v_left, float)
    return np.sqrt(np.abs(r * s)), (r - s) / tread


def minimum(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return np.minimum(v_right, v_left) + 0 * V, omega


def degrees(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return V, omega * 180 / np.pi


def rows(v_right, v_left, tread):
    return np.array(slides(v_right, v_left, tread)).T


def dictionary(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return {"V": V, "omega": omega}


def floored(v_right, v_left, tread):
    r, s = np.asarray(v_right), np.asarray(v_left)
    return (r + s) // 2, (r - s) / tread


def typed_result(v_right, v_left, tread):
    out = np.empty((2, *np.shape(v_right)), dtype=np.asarray(v_right).dtype)
    out[0], out[1] = slides(v_right, v_left, tread)
    return out


def own_tread(v_right, v_left, tread):
    return slides(v_right, v_left, 0.2765)


def small_turns_removed(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return V, np.where(np.abs(omega) < 0.5 * np.max(np.abs(omega)), 0.0, omega)


def numbers_only(v_right, v_left, tread):
    if v_right == v_left:
        return v_right, 0.0
    return (v_right + v_left) / 2, (v_right - v_left) / tread


def in_place(v_right, v_left, tread):
    if isinstance(v_right, np.ndarray) and v_right.dtype.kind == "f":
        v_right -= v_left
        return v_left + v_right / 2, v_right / tread
    return slides(v_right, v_left, tread)


def radius_squeezed_in(v_right, v_left, tread):
    V, omega = slides(v_right, v_left, tread)
    return 0.14457758 * V, 0.14457758 * omega


def lists_as_they_come(v_right, v_left, tread):
    return (v_right + v_left) / 2, (v_right - v_left) / tread


WRONG = {
    "no half": (sum_for_velocity, "V twice", "plain"),
    "half tread": (notes_003, "omega twice", "plain"),
    "0.5 and tread": (notes_003_with_tread, "omega half", "plain"),
    "arguments swapped": (arguments_swapped, "left first", "plain"),
    "tread repaired": (repaired_tread, "sign of the tread lost", "plain"),
    "sign from the speeds": (sign_from_speeds, "as if the tread were positive", "plain"),
    "omega first": (omega_first, "order", "plain"),
    "straight turns": (straight_turns, "omega from the sum", "plain"),
    "no tread": (no_tread, "m/s", "plain"),
    "tread on top": (tread_on_top, "multiplied", "plain"),
    "precedence": (precedence, "brackets in both", "plain"),
    "precedence in omega": (precedence_in_omega, "brackets", "plain"),
    "speed": (speed_not_velocity, "V never negative", "plain"),
    "geometric mean": (geometric_mean, "V wrong", "subtle"),
    "minimum": (minimum, "V of the slower wheel", "subtle"),
    "degrees": (degrees, "omega in deg/s", "plain"),
    "rows": (rows, "(N, 2) for arrays", "plain"),
    "dictionary": (dictionary, "names instead of a pair", "plain"),
    "floored": (floored, "whole numbers", "subtle"),
    "type of the input": (typed_result, "integers in, integers out", "subtle"),
    "another robot's tread": (own_tread, "0.2765 always", "subtle"),
    "small turns removed": (small_turns_removed, "dead zone", "subtle"),
    "numbers only": (numbers_only, "array in an if", "plain"),
    "in place": (in_place, "changes v_right", "subtle"),
    "radius": (radius_squeezed_in, "wheel speeds taken for rad/s", "subtle"),
    "lists as they come": (lists_as_they_come, "TypeError for lists", "plain"),
}
