"""Answers to displacement(velocity, yaw_rate, dt): right ones in honest styles, wrong ones as students write them."""

import math
import warnings
from fractions import Fraction
from typing import NamedTuple

import numpy as np


class Motion(NamedTuple):
    u: float
    v: float
    phi: float

    def after(self, dt):
        return Motion(*(part * dt for part in self))


def slide(velocity, yaw_rate, dt):
    u = velocity * dt
    v = 0
    phi = yaw_rate * dt
    return np.array([u, v, phi])


def filled_in(velocity, yaw_rate, dt):
    out = np.zeros(3)
    out[0], out[2] = velocity, yaw_rate
    out *= dt
    return out


def matrix_form(velocity, yaw_rate, dt):
    return (np.array([[1, 0], [0, 0], [0, 1]]) @ np.array([[velocity], [yaw_rate]]) * dt).ravel()


def integrated_in_steps(velocity, yaw_rate, dt):
    """The sum of a thousand small steps, straight in the robot's own axes."""
    pieces = np.full((1000, 3), (velocity, 0.0, yaw_rate)) * (dt / 1000)
    print(pieces.shape)
    return pieces.sum(axis=0)


def single_precision(velocity, yaw_rate, dt):
    return np.array([velocity, 0, yaw_rate], dtype=np.float32) * np.float32(dt)


def exact_fractions(velocity, yaw_rate, dt):
    return [float(Fraction(rate) * Fraction(dt)) for rate in (velocity, 0, yaw_rate)]


def warning(velocity, yaw_rate, dt):
    if velocity < 0:
        warnings.warn("reversing", stacklevel=2)
    return math.fsum([velocity * dt]), 0.0, math.fsum([yaw_rate * dt])


RIGHT = {
    "as on the slide": slide,
    "filled in": filled_in,
    "matrix": matrix_form,
    "a thousand pieces, prints": integrated_in_steps,
    "float32": single_precision,
    "fractions, list": exact_fractions,
    "warns, tuple": warning,
    "named tuple": lambda velocity, yaw_rate, dt: Motion(velocity, 0, yaw_rate).after(dt),
    "outer product": lambda velocity, yaw_rate, dt: np.outer([dt], [velocity, 0, yaw_rate])[0],
}


def mean_of_speed_and_zero(velocity, yaw_rate, dt):
    return np.array([(0 + velocity) / 2 * dt, 0, yaw_rate * dt])


def circle_around(velocity, yaw_rate, dt):
    radius = velocity / yaw_rate if yaw_rate else 0
    return np.array([radius * math.sin(yaw_rate * dt), radius * (1 - math.cos(yaw_rate * dt)), yaw_rate * dt])


def sine_of_the_turn(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0, math.sin(yaw_rate * dt)])


def euler_with_heading(velocity, yaw_rate, dt):
    theta = yaw_rate
    return np.array([velocity * math.cos(theta) * dt, velocity * math.sin(theta) * dt, yaw_rate * dt])


def integer_division(velocity, yaw_rate, dt):
    return np.array([velocity // (1 / dt), 0, yaw_rate // (1 / dt)])


def at_200_hertz(velocity, yaw_rate, dt):
    return np.array([velocity / 200, 0, yaw_rate / 200])


def dt_of_one_hundredth(velocity, yaw_rate, dt):
    return np.array([velocity * 0.01, 0, yaw_rate * 0.01])


def ignores_standing_turns(velocity, yaw_rate, dt):
    if velocity == 0:
        return np.zeros(3)
    return np.array([velocity * dt, 0, yaw_rate * dt])


def wheels_added(velocity, yaw_rate, dt):
    return np.array([2 * velocity * dt, 0, yaw_rate * dt])


def degrees_per_step(velocity, yaw_rate, dt):
    return velocity * dt, 0, math.degrees(yaw_rate) * dt


def millimetres(velocity, yaw_rate, dt):
    return np.array([velocity * dt * 1000, 0, yaw_rate * dt])


def four_decimals(velocity, yaw_rate, dt):
    return [round(velocity * dt, 4), 0, round(yaw_rate * dt, 4)]


def integers_for_integers(velocity, yaw_rate, dt):
    kind = type(velocity)
    return [kind(velocity * dt), 0, kind(yaw_rate * dt)]


def mapping(velocity, yaw_rate, dt):
    return {"u": velocity * dt, "v": 0.0, "phi": yaw_rate * dt}


def nested(velocity, yaw_rate, dt):
    return [[velocity * dt, 0.0], yaw_rate * dt]


def none_for_zero(velocity, yaw_rate, dt):
    return [velocity * dt, None, yaw_rate * dt]


def prints(velocity, yaw_rate, dt):
    print(velocity * dt, 0, yaw_rate * dt)


def never_negative(velocity, yaw_rate, dt):
    return np.array([max(velocity * dt, 0), 0, yaw_rate * dt])


def arrays_expected(velocity, yaw_rate, dt):
    return np.array([velocity[0] * dt, 0, yaw_rate[0] * dt])


def turn_first(velocity, yaw_rate, dt):
    return np.array([yaw_rate * dt, velocity * dt, 0])


def length_kept(velocity, yaw_rate, dt):
    return np.array([np.hypot(velocity, yaw_rate) * dt, 0, yaw_rate * dt])


WRONG = {
    "mean with rest": (mean_of_speed_and_zero, "half of u", "plain"),
    "arc by the radius": (circle_around, "the end of the arc, nothing on the straight", "subtle"),
    "sine of the turn": (sine_of_the_turn, "sin(phi)", "subtle"),
    "yaw rate for heading": (euler_with_heading, "cos(omega)", "subtle"),
    "integer division": (integer_division, "// drops the decimals", "subtle"),
    "200 Hz": (at_200_hertz, "dt = 5 ms always", "plain"),
    "100 Hz": (dt_of_one_hundredth, "dt = 10 ms always", "subtle"),
    "turning on the spot": (ignores_standing_turns, "no turn without speed", "subtle"),
    "twice": (wheels_added, "2 V", "plain"),
    "degrees": (degrees_per_step, "phi in degrees", "plain"),
    "millimetres": (millimetres, "u in mm", "plain"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "integer type kept": (integers_for_integers, "cut off for whole numbers", "plain"),
    "dict": (mapping, "a dict", "plain"),
    "nested": (nested, "ragged lists", "plain"),
    "None": (none_for_zero, "None for v", "plain"),
    "prints": (prints, "no return", "plain"),
    "never backwards": (never_negative, "max(u, 0)", "subtle"),
    "arrays expected": (arrays_expected, "numbers have no index", "plain"),
    "turn first": (turn_first, "(phi, u, v)", "subtle"),
    "hypot": (length_kept, "hypot(V, omega)", "subtle"),
}
