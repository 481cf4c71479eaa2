"""Answers to wrap_angle(theta): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def modulo(theta):
    return (np.asarray(theta) + np.pi) % (2 * np.pi) - np.pi


def remainder(theta):
    return np.remainder(np.add(theta, np.pi), 2 * np.pi) - np.pi


def arctan2_mended(theta):
    wrapped = np.arctan2(np.sin(theta), np.cos(theta))
    return np.where(wrapped >= np.pi, -np.pi, wrapped)


def floor(theta):
    theta = np.array(theta, dtype=float)
    return theta - 2 * np.pi * np.floor((theta + np.pi) / (2 * np.pi))


def recursive(theta):
    if np.ndim(theta):
        return [recursive(part) for part in theta]
    while theta >= math.pi:
        theta -= 2 * math.pi
    while theta < -math.pi:
        theta += 2 * math.pi
    return theta


def vectorised_loop(theta):
    print("wrapping", np.shape(theta))
    warnings.warn("slow", stacklevel=1)
    theta = np.array(theta, dtype=float)
    while np.any(theta >= np.pi) or np.any(theta < -np.pi):
        theta = np.where(theta >= np.pi, theta - 2 * np.pi, theta)
        theta = np.where(theta < -np.pi, theta + 2 * np.pi, theta)
    return theta


def complex_angle(theta):
    angle = np.angle(np.exp(1j * np.asarray(theta)))
    return np.where(np.isclose(angle, np.pi, rtol=0, atol=1e-12), -np.pi, angle)


def one_at_a_time(theta):
    """Fill a flat copy, then give it its shape back."""

    def wrapped(angle):
        angle = cmath.phase(cmath.rect(1, angle))
        return angle if angle < math.pi else angle - math.tau

    if isinstance(theta, int | float):
        return wrapped(theta)
    flat = [wrapped(angle) for angle in np.ravel(theta)]
    return np.array(flat).reshape(np.shape(theta))


def single_precision(theta):
    angles = np.asarray(theta, dtype=np.float64)
    return np.float32((angles + np.pi) % (2 * np.pi) - np.pi)


RIGHT = {
    "modulo": modulo,
    "np.remainder": remainder,
    "arctan2, pi mended": arctan2_mended,
    "floor": floor,
    "recursive with while, lists": recursive,
    "where in a loop, prints and warns": vectorised_loop,
    "np.angle, pi mended": complex_angle,
    "one at a time": one_at_a_time,
    "float32": single_precision,
    "np.vectorize": np.vectorize(recursive, otypes=[float]),
}


def arctan2(theta):
    return np.arctan2(np.sin(theta), np.cos(theta))


def angle_of_exp(theta):
    return np.angle(np.exp(1j * np.asarray(theta)))


def rounded_turns(theta):
    return np.asarray(theta) - 2 * np.pi * np.round(np.asarray(theta) / (2 * np.pi))


def open_at_minus_pi(theta):
    return -((np.pi - np.asarray(theta)) % (2 * np.pi) - np.pi)


def ieee_remainder(theta):
    wrapped = [math.remainder(angle, 2 * math.pi) for angle in np.ravel(theta)]
    return np.reshape(wrapped, np.shape(theta))


def positive(theta):
    return np.mod(theta, 2 * np.pi)


def positive_then_shifted(theta):
    wrapped = np.mod(theta, 2 * np.pi)
    return np.where(wrapped > np.pi, wrapped - 2 * np.pi, wrapped)


def once(theta):
    theta = np.array(theta, dtype=float)
    theta = np.where(theta >= np.pi, theta - 2 * np.pi, theta)
    return np.where(theta < -np.pi, theta + 2 * np.pi, theta)


def fmod(theta):
    return np.fmod(np.add(theta, np.pi), 2 * np.pi) - np.pi


def int_turns(theta):
    theta = np.asarray(theta, dtype=float)
    return theta - 2 * np.pi * (theta / (2 * np.pi)).astype(int)


def in_place(theta):
    if np.ndim(theta) == 0:
        return modulo(theta)
    flat = theta if isinstance(theta, np.ndarray) else np.array(theta)
    flat -= 2 * np.pi * np.floor((flat + np.pi) / (2 * np.pi))
    return flat


def only_numbers(theta):
    while theta >= np.pi:
        theta -= 2 * np.pi
    while theta < -np.pi:
        theta += 2 * np.pi
    return theta


def only_flat(theta):
    return modulo(theta) if np.ndim(theta) == 0 else np.array([only_numbers(angle) for angle in theta])


def only_arrays(theta):
    wrapped = np.zeros(len(theta))
    for k, angle in enumerate(theta):
        wrapped[k] = modulo(angle)
    return wrapped


def always_array(theta):
    return modulo(np.atleast_1d(theta))


def always_list(theta):
    return [modulo(angle) for angle in np.ravel(theta)]


def zeros_like(theta):
    wrapped = np.zeros_like(theta)
    wrapped[...] = modulo(theta)
    return wrapped


def unwrapped(theta):
    return np.unwrap(np.atleast_1d(theta))


def tangent(theta):
    return np.arctan(np.tan(theta))


def half_tangent(theta):
    return 2 * np.arctan(np.tan(np.asarray(theta) / 2))


def degrees(theta):
    return np.degrees(modulo(theta))


def in_turns(theta):
    return (np.asarray(theta) + 0.5) % 1 - 0.5


def no_brackets(theta):
    return (np.asarray(theta) + np.pi) % 2 * np.pi - np.pi


def rough(theta):
    return (np.asarray(theta) + 3.1416) % 6.2832 - 3.1416


def squeezed(theta):
    return np.squeeze(modulo(theta))


def columns_lost(theta):
    return modulo(theta) if np.ndim(theta) < 2 else modulo(np.asarray(theta)[:, 0])


WRONG = {
    "arctan2": (arctan2, "pi kept", "plain"),
    "np.angle": (angle_of_exp, "pi kept", "plain"),
    "round": (rounded_turns, "pi kept", "plain"),
    "(-pi, pi]": (open_at_minus_pi, "pi kept", "plain"),
    "math.remainder": (ieee_remainder, "pi kept", "plain"),
    "[0, 2 pi)": (positive, "other range", "plain"),
    "> for >=": (positive_then_shifted, "pi kept", "plain"),
    "once": (once, "one turn only", "plain"),
    "fmod": (fmod, "negative angles wrong", "plain"),
    "int turns": (int_turns, "-2 pi to 2 pi", "plain"),
    "in place": (in_place, "array overwritten", "plain"),
    "only numbers": (only_numbers, "if and while on arrays", "plain"),
    "only flat": (only_flat, "(N,) only", "plain"),
    "only arrays": (only_arrays, "len of a number", "plain"),
    "always an array": (always_array, "number becomes (1,)", "plain"),
    "always a list": (always_list, "flattened", "plain"),
    "zeros_like": (zeros_like, "whole numbers cut off", "plain"),
    "unwrap": (unwrapped, "the opposite", "subtle"),
    "arctan(tan)": (tangent, "half turns lost", "plain"),
    "2 arctan(tan(theta/2))": (half_tangent, "pi kept", "plain"),
    "degrees": (degrees, "degrees out", "plain"),
    "turns": (in_turns, "taken for turns", "subtle"),
    "brackets": (no_brackets, "% 2 * np.pi", "subtle"),
    "rough pi": (rough, "3.1416", "subtle"),
    "squeezed": (squeezed, "(1,) becomes a number", "plain"),
    "first column": (columns_lost, "columns lost", "plain"),
}
