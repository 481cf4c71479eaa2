"""Answers to wheel_angle(counts, gear, counts_per_rev): right ones in honest styles, wrong ones as students write them."""

import math
import warnings

import numpy as np


def slides(counts, gear, counts_per_rev):
    d_c = np.asarray(counts) / gear
    return 2 * np.pi * d_c / counts_per_rev


def factor_first(counts, gear, counts_per_rev):
    per_count = math.tau / gear / counts_per_rev
    return np.multiply(counts, per_count)


def loop(counts, gear, counts_per_rev):
    try:
        return [2 * math.pi * c / (gear * counts_per_rev) for c in counts]
    except TypeError:
        return 2 * math.pi * counts / (gear * counts_per_rev)


def degrees_and_back(counts, gear, counts_per_rev):
    degrees = np.true_divide(counts, counts_per_rev) * 360.0 / gear
    print("degrees:", degrees)
    return np.radians(degrees)


def single_precision(counts, gear, counts_per_rev):
    return (np.float32(2 * np.pi) / np.float32(gear * counts_per_rev)) * np.array(counts, dtype=np.float32)


def complex_logarithm(counts, gear, counts_per_rev):
    """The exponent of a turning pointer."""
    pointer = 2j * np.pi * np.asarray(counts) / (gear * counts_per_rev)
    return pointer.imag


def dot_product(counts, gear, counts_per_rev):
    warnings.warn("slow", stacklevel=1)
    column = np.reshape(np.array(counts, dtype=float), (-1, 1))
    angle = column @ np.array([[2 * np.pi / (gear * counts_per_rev)]])
    return float(angle[0, 0]) if np.ndim(counts) == 0 else tuple(angle[:, 0])


class Encoder:
    """Turns counts into turns, and turns into rad."""

    def turns(self, counts, counts_per_turn):
        return np.array(counts, dtype=float) / counts_per_turn

    def __call__(self, counts, gear, counts_per_rev):
        return self.turns(counts, counts_per_rev * gear) * 2 * np.pi


RIGHT = {
    "as on the slides": slides,
    "factor first": factor_first,
    "loop, list": loop,
    "degrees and back, prints": degrees_and_back,
    "float32": single_precision,
    "complex": complex_logarithm,
    "matrix product, tuple, warns": dot_product,
    "object with __call__": Encoder(),
}


def motor_shaft(counts, gear, counts_per_rev):
    return math.tau * np.array(counts, float) / counts_per_rev


def faster_than_the_motor(counts, gear, counts_per_rev):
    return math.tau * np.array(counts, float) * gear / counts_per_rev


def precedence(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / counts_per_rev * gear


def precedence_of_counts(counts, gear, counts_per_rev):
    return np.asarray(counts) / gear * counts_per_rev * 2 * np.pi


def turns_only(counts, gear, counts_per_rev):
    return np.asarray(counts) / counts_per_rev / gear


def in_degrees(counts, gear, counts_per_rev):
    return np.degrees(slides(counts, gear, counts_per_rev))


def half_turn(counts, gear, counts_per_rev):
    return math.pi * np.asarray(counts) / counts_per_rev / gear


def pulses(counts, gear, counts_per_rev):
    return slides(np.asarray(counts) / 4, gear, counts_per_rev)


def quadrupled(counts, gear, counts_per_rev):
    return slides(np.asarray(counts) * 4, gear, counts_per_rev)


def floor_of_gear(counts, gear, counts_per_rev):
    return 2 * np.pi * np.floor(np.asarray(counts) / gear) / counts_per_rev


def truncated_motor_counts(counts, gear, counts_per_rev):
    return 2 * np.pi * np.trunc(np.asarray(counts) / gear) / counts_per_rev


def always_i_cart(counts, gear=150, counts_per_rev=400):
    gear, counts_per_rev = 150, 400
    return 2 * np.pi * np.asarray(counts) / gear / counts_per_rev


def wrapped(counts, gear, counts_per_rev):
    angle = slides(counts, gear, counts_per_rev)
    return np.arctan2(np.sin(angle), np.cos(angle))


def unsigned(counts, gear, counts_per_rev):
    angle = slides(counts, gear, counts_per_rev)
    return np.sqrt(angle**2)


def rounded_gear(counts, gear, counts_per_rev):
    return slides(counts, round(gear), counts_per_rev)


def four_places(counts, gear, counts_per_rev):
    return np.round(slides(counts, gear, counts_per_rev), 4)


def cumulative(counts, gear, counts_per_rev):
    return slides(np.cumsum(counts), gear, counts_per_rev)


def arrays_only(counts, gear, counts_per_rev):
    return np.array([2 * np.pi * c / gear / counts_per_rev for c in counts])


def numbers_only(counts, gear, counts_per_rev):
    return 2 * math.pi * float(counts) / gear / counts_per_rev


def in_place(counts, gear, counts_per_rev):
    counts = np.asarray(counts, dtype=float)
    counts /= gear * counts_per_rev
    return counts * 2 * np.pi


def column(counts, gear, counts_per_rev):
    angle = slides(counts, gear, counts_per_rev)
    return angle[:, None] if np.ndim(angle) else angle


def sorted_out(counts, gear, counts_per_rev):
    return np.sort(slides(counts, gear, counts_per_rev)) if np.ndim(counts) else slides(counts, gear, counts_per_rev)


def text(counts, gear, counts_per_rev):
    return f"{slides(counts, gear, counts_per_rev)} rad"


def nothing(counts, gear, counts_per_rev):
    print(slides(counts, gear, counts_per_rev))


WRONG = {
    "motor shaft": (motor_shaft, "no gear", "plain"),
    "faster than the motor": (faster_than_the_motor, "gear multiplied", "plain"),
    "precedence": (precedence, "/ counts_per_rev * gear", "plain"),
    "precedence of counts": (precedence_of_counts, "/ gear * counts_per_rev", "plain"),
    "turns": (turns_only, "no 2 pi", "plain"),
    "degrees": (in_degrees, "180/pi too large", "plain"),
    "half a turn": (half_turn, "pi for 2 pi", "plain"),
    "pulses": (pulses, "a quarter", "plain"),
    "quadrupled": (quadrupled, "4x decoding done twice", "plain"),
    "floor": (floor_of_gear, "rounded down to whole dC", "subtle"),
    "trunc": (truncated_motor_counts, "rounded to zero to whole dC", "subtle"),
    "always the i-Cart": (always_i_cart, "arguments overwritten", "plain"),
    "wrapped": (wrapped, "beyond half a turn", "subtle"),
    "unsigned": (unsigned, "sign lost", "subtle"),
    "rounded gear": (rounded_gear, "54.0699 -> 54", "subtle"),
    "four places": (four_places, "rounded", "subtle"),
    "cumulative": (cumulative, "sums; (1,) for a number", "subtle"),
    "arrays only": (arrays_only, "TypeError for a number", "plain"),
    "numbers only": (numbers_only, "TypeError for an array", "plain"),
    "in place": (in_place, "changes a float array", "subtle"),
    "column": (column, "(N, 1)", "plain"),
    "sorted": (sorted_out, "order lost", "subtle"),
    "text": (text, "a sentence", "plain"),
    "nothing": (nothing, "prints instead of returning", "plain"),
}
