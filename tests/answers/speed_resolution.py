"""Answers to speed_resolution(radius, gear, counts_per_rev, dt): right ones in honest styles, wrong ones as students write them."""

import math
import warnings
from fractions import Fraction

import numpy as np


def formula(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) / dt


def wheel_speed_of_one_count(radius, gear, counts_per_rev, dt):
    def wheel_speed(counts):
        return radius * (2 * math.pi * counts / gear / counts_per_rev) / dt

    return wheel_speed(8) - wheel_speed(7)


def frequency(radius, gear, counts_per_rev, dt):
    rate = 1.0 / dt
    print("samples per second", rate)
    return math.tau * radius * rate / gear / counts_per_rev


def exact_fraction(radius, gear, counts_per_rev, dt):
    turns_per_second = 1 / (Fraction(gear) * Fraction(counts_per_rev) * Fraction(dt))
    return math.pi * (2 * radius) * float(turns_per_second)


def single_precision(radius, gear, counts_per_rev, dt):
    per_count = np.float32(2 * np.pi * radius) / np.float32(gear * counts_per_rev)
    return np.float32(per_count / np.float32(dt))


def logarithms(radius, gear, counts_per_rev, dt):
    warnings.warn("slide rule", stacklevel=1)
    return math.exp(math.log(math.tau) + math.log(radius) - math.log(gear) - math.log(counts_per_rev) - math.log(dt))


class Resolution:
    """The smallest step of the speed."""

    def __call__(self, radius, gear, counts_per_rev, dt):
        speeds = np.arange(3) * 2 * np.pi * radius / np.prod([gear, counts_per_rev, dt], dtype=float)
        return np.diff(speeds).mean()


RIGHT = {
    "formula": formula,
    "difference of two speeds": wheel_speed_of_one_count,
    "frequency, prints": frequency,
    "fractions": exact_fraction,
    "float32": single_precision,
    "logarithms, warns": logarithms,
    "object with __call__": Resolution(),
}


def no_dt(radius, gear, counts_per_rev, dt):
    return math.tau * radius / (gear * counts_per_rev)


def dt_on_top(radius, gear, counts_per_rev, dt):
    return math.tau * radius / (gear * counts_per_rev) * dt


def dt_twice(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev, dt) / dt


def five_milliseconds(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev, 0.005)


def one_second(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev, 1.0)


def milliseconds(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev, dt * 1e-3)


def millimetres_per_second(radius, gear, counts_per_rev, dt):
    return formula(radius * 1000, gear, counts_per_rev, dt)


def no_gear(radius, gear, counts_per_rev, dt):
    return formula(radius, 1, counts_per_rev, dt)


def gear_on_top(radius, gear, counts_per_rev, dt):
    return formula(radius, 1 / gear, counts_per_rev, dt)


def radians_per_second(radius, gear, counts_per_rev, dt):
    return formula(1, gear, counts_per_rev, dt)


def no_two_pi(radius, gear, counts_per_rev, dt):
    return radius / gear / counts_per_rev / dt


def radius_as_diameter(radius, gear, counts_per_rev, dt):
    return math.pi * radius / gear / counts_per_rev / dt


def robot_velocity(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev, dt) / 2


def diameter(radius, gear, counts_per_rev, dt):
    return formula(2 * radius, gear, counts_per_rev, dt)


def pulses(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev * 4, dt)


def degrees(radius, gear, counts_per_rev, dt):
    return radius * 360 / (gear * counts_per_rev) / dt


def brackets_lost(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / gear * counts_per_rev / dt


def brackets_lost_at_dt(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / gear / counts_per_rev * dt


def noise(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev, dt) / math.sqrt(12)


def inverse(radius, gear, counts_per_rev, dt):
    return 1 / formula(radius, gear, counts_per_rev, dt)


def three_millimetres(radius, gear, counts_per_rev, dt):
    return 0.00303


def two_significant(radius, gear, counts_per_rev, dt):
    return float(f"{formula(radius, gear, counts_per_rev, dt):.2g}")


def four_places(radius, gear, counts_per_rev, dt):
    return round(formula(radius, gear, counts_per_rev, dt), 4)


def whole_gear(radius, gear, counts_per_rev, dt):
    return formula(radius, round(gear), counts_per_rev, dt)


def arguments_in_other_order(radius, gear, dt, counts_per_rev):
    return 2 * np.pi * radius / gear / dt**2 / counts_per_rev


def three_arguments(radius, gear, counts_per_rev):
    return 2 * np.pi * radius / (gear * counts_per_rev) / 0.005


def kilometres_per_hour(radius, gear, counts_per_rev, dt):
    return formula(radius, gear, counts_per_rev, dt) * 3.6


def both_wheels(radius, gear, counts_per_rev, dt):
    v = formula(radius, gear, counts_per_rev, dt)
    return v, v


WRONG = {
    "no dt": (no_dt, "metres", "plain"),
    "dt on top": (dt_on_top, "multiplied", "plain"),
    "dt twice": (dt_twice, "m/s^2", "plain"),
    "5 ms": (five_milliseconds, "fixed period", "plain"),
    "1 s": (one_second, "metres again", "plain"),
    "milliseconds": (milliseconds, "1000 times", "plain"),
    "mm/s": (millimetres_per_second, "1000 times", "plain"),
    "no gear": (no_gear, "motor shaft", "plain"),
    "gear on top": (gear_on_top, "multiplied", "plain"),
    "rad/s": (radians_per_second, "no radius", "plain"),
    "no 2 pi": (no_two_pi, "turns times radius", "plain"),
    "radius as diameter": (radius_as_diameter, "half", "plain"),
    "robot's velocity": (robot_velocity, "half, as V averages two wheels", "plain"),
    "diameter": (diameter, "twice", "plain"),
    "pulses": (pulses, "a quarter", "plain"),
    "degrees": (degrees, "360", "plain"),
    "brackets lost": (brackets_lost, "counts_per_rev on top", "plain"),
    "brackets lost at dt": (brackets_lost_at_dt, "dt on top", "plain"),
    "noise": (noise, "standard deviation", "subtle"),
    "inverse": (inverse, "upside down", "plain"),
    "3 mm/s": (three_millimetres, "constant of the i-Cart, rounded", "subtle"),
    "two significant": (two_significant, "rounded", "subtle"),
    "four places": (four_places, "rounded", "plain"),
    "whole gear": (whole_gear, "rounded", "subtle"),
    "another order": (arguments_in_other_order, "dt and counts_per_rev exchanged, squared", "subtle"),
    "three arguments": (three_arguments, "dt not taken", "plain"),
    "km/h": (kilometres_per_hour, "3.6 times", "plain"),
    "both wheels": (both_wheels, "(2,)", "plain"),
}
