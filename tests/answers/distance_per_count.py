"""Answers to distance_per_count(radius, gear, counts_per_rev): right ones in honest styles, wrong ones as students write them."""

import math
import warnings
from fractions import Fraction

import numpy as np


def formula(radius, gear, counts_per_rev):
    return 2 * np.pi * radius / (gear * counts_per_rev)


def step_by_step(radius, gear, counts_per_rev):
    motor_angle = math.tau / counts_per_rev
    wheel_angle = motor_angle / gear
    return radius * wheel_angle


def diameter(radius, gear, counts_per_rev):
    d = 2 * radius
    print("circumference", math.pi * d)
    return math.pi * d / counts_per_rev / gear


def exact_fraction(radius, gear, counts_per_rev):
    part_of_a_turn = 1 / (Fraction(gear) * Fraction(counts_per_rev))
    return float(part_of_a_turn) * 2 * math.pi * radius


def single_precision(radius, gear, counts_per_rev):
    return np.float32(2 * np.pi) * np.float32(radius) / np.float32(gear) / np.float32(counts_per_rev)


def zero_dimensional(radius, gear, counts_per_rev):
    warnings.warn("0-d", stacklevel=1)
    return np.array(radius * np.deg2rad(360) / np.prod([gear, counts_per_rev]))


class Encoder:
    """An arc of one count on the rim."""

    def __call__(self, radius, gear, counts_per_rev):
        return abs(self.arc(radius, 1 / gear / counts_per_rev))

    def arc(self, radius, turns):
        return turns * math.pi * 2.0 * radius


RIGHT = {
    "formula": formula,
    "step by step": step_by_step,
    "diameter, prints": diameter,
    "fractions": exact_fraction,
    "float32": single_precision,
    "0-d array, warns": zero_dimensional,
    "object with __call__": Encoder(),
}


def no_gear(radius, gear, counts_per_rev):
    return math.tau * radius / counts_per_rev


def gear_on_top(radius, gear, counts_per_rev):
    return math.tau * radius / counts_per_rev * gear


def no_counts(radius, gear, counts_per_rev):
    return math.tau * radius / gear


def precedence(radius, gear, counts_per_rev):
    return math.tau * radius / gear * counts_per_rev


def half(radius, gear, counts_per_rev):
    return formula(radius / 2, gear, counts_per_rev)


def double(radius, gear, counts_per_rev):
    return formula(2 * radius, gear, counts_per_rev)


def no_pi(radius, gear, counts_per_rev):
    return radius / gear / counts_per_rev


def angle_only(radius, gear, counts_per_rev):
    return math.tau / (gear * counts_per_rev)


def in_degrees(radius, gear, counts_per_rev):
    return 360 / (gear * counts_per_rev) * radius


def counts_per_metre(radius, gear, counts_per_rev):
    return 1 / formula(radius, gear, counts_per_rev)


def pulses(radius, gear, counts_per_rev):
    return formula(radius, gear, 4 * counts_per_rev)


def one_pulse(radius, gear, counts_per_rev):
    return 4 * formula(radius, gear, counts_per_rev)


def disc(radius, gear, counts_per_rev):
    return math.pi * radius**2 / (gear * counts_per_rev)


def millimetres(radius, gear, counts_per_rev):
    return 1e3 * formula(radius, gear, counts_per_rev)


def whole_gear(radius, gear, counts_per_rev):
    return formula(radius, math.floor(gear), counts_per_rev)


def six_places(radius, gear, counts_per_rev):
    return round(formula(radius, gear, counts_per_rev), 6)


def three_significant(radius, gear, counts_per_rev):
    return float(f"{formula(radius, gear, counts_per_rev):.3g}")


def schoolbook_pi(radius, gear, counts_per_rev):
    return 2 * 3.14 * radius / (gear * counts_per_rev)


def pi_of_22_7(radius, gear, counts_per_rev):
    return 2 * 22 / 7 * radius / (gear * counts_per_rev)


def i_cart(radius, gear, counts_per_rev):
    return 1.514e-5


def gear_150(radius, gear, counts_per_rev):
    return formula(radius, 150, counts_per_rev)


def sum_of_both(radius, gear, counts_per_rev):
    return math.tau * radius / (gear + counts_per_rev)


def truncated(radius, gear, counts_per_rev):
    return int(formula(radius, gear, counts_per_rev))


def as_list(radius, gear, counts_per_rev):
    return [formula(radius, gear, counts_per_rev)]


def with_unit(radius, gear, counts_per_rev):
    return f"{formula(radius, gear, counts_per_rev)} m"


def chord(radius, gear, counts_per_rev):
    """The chord instead of the arc, and of the motor's step at that."""
    return 2 * radius * math.sin(math.pi / counts_per_rev) / gear


def speed_at_5_ms(radius, gear, counts_per_rev):
    return formula(radius, gear, counts_per_rev) / 5e-3


WRONG = {
    "no gear": (no_gear, "motor shaft", "plain"),
    "gear on top": (gear_on_top, "multiplied", "plain"),
    "no counts": (no_counts, "one motor turn", "plain"),
    "precedence": (precedence, "brackets", "plain"),
    "half": (half, "radius as diameter", "plain"),
    "double": (double, "diameter as radius", "plain"),
    "no 2 pi": (no_pi, "turns times radius", "plain"),
    "angle": (angle_only, "no radius", "plain"),
    "degrees": (in_degrees, "360", "plain"),
    "counts per metre": (counts_per_metre, "inverse", "plain"),
    "pulses": (pulses, "a quarter", "plain"),
    "one pulse": (one_pulse, "four times", "plain"),
    "disc": (disc, "area", "plain"),
    "millimetres": (millimetres, "1000 times", "plain"),
    "whole gear": (whole_gear, "rounded down", "subtle"),
    "six places": (six_places, "rounded", "plain"),
    "three significant": (three_significant, "rounded", "subtle"),
    "3.14": (schoolbook_pi, "pi shortened", "plain"),
    "22/7": (pi_of_22_7, "pi of the ancients", "subtle"),
    "i-Cart": (i_cart, "constant", "subtle"),
    "gear 150": (gear_150, "fixed gear", "plain"),
    "sum": (sum_of_both, "gear + counts_per_rev", "plain"),
    "truncated": (truncated, "int", "plain"),
    "list": (as_list, "(1,)", "plain"),
    "with unit": (with_unit, "text", "plain"),
    "chord": (chord, "almost the arc for fine encoders", "subtle"),
    "speed at 5 ms": (speed_at_5_ms, "divided by the period", "plain"),
}
