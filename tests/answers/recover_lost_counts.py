"""Answers to recover_lost_counts(time, counts, period): right ones in honest styles, wrong ones as students write them."""

import warnings
from decimal import Decimal
from itertools import pairwise

import numpy as np


def loop(time, counts, period):
    out = [counts[0]]
    for k in range(1, len(time)):
        n = round((time[k] - time[k - 1]) / period)
        out.append(counts[k] * n if n > 1 else counts[k])
    return out


def vectors(time, counts, period):
    n = np.rint(np.diff(time) / period)
    n[n < 1] = 1
    return np.asarray(counts, float) * np.concatenate([[1], n])


def prepended(time, counts, period):
    print("period", period)
    dt = np.diff(np.asarray(time, float), prepend=time[0] - period)
    return np.array(counts) * np.clip(np.round(dt / period), 1, None).astype(int)


def decimals(time, counts, period):
    stamps = [Decimal(float(stamp)) for stamp in time]
    cycles = [1] + [max(1, round((b - a) / Decimal(period))) for a, b in pairwise(stamps)]
    return tuple(float(c) * n for c, n in zip(counts, cycles, strict=True))


def recursive(time, counts, period):
    if len(time) == 1:
        return [float(counts[0])]
    last = max(1, int(np.floor((time[-1] - time[-2]) / period + 0.5)))
    return [*recursive(time[:-1], counts[:-1], period), float(counts[-1] * last)]


class Cycles:
    def __init__(self, kind):
        self.kind = kind

    def __call__(self, time, counts, period):
        before, out = None, []
        for t, c in zip(time, counts, strict=True):
            cycles = 1 if before is None else max(round((t - before) / period), 1)
            out.append(cycles * c)
            before = t
        warnings.warn("gaps", stacklevel=1)
        return np.array(out, self.kind)


RIGHT = {
    "loop, list": loop,
    "vectors": vectors,
    "prepended, whole numbers, prints": prepended,
    "decimals, tuple": decimals,
    "recursive": recursive,
    "object, float32, warns": Cycles(np.float32),
}


def steps(time):
    return np.diff(np.asarray(time, float))


def cut_off(time, counts, period):
    return np.asarray(counts, float) * np.maximum(np.append(1, (steps(time) / period).astype(int)), 1)


def floor_division(time, counts, period):
    return [counts[0], *[c * max(1, dt // period) for c, dt in zip(counts[1:], steps(time), strict=True)]]


def rounded_up(time, counts, period):
    return np.asarray(counts, float) * np.append(1, np.ceil(steps(time) / period))


def ratio(time, counts, period):
    return np.asarray(counts, float) * np.append(1, steps(time) / period)


def zero_for_close_rows(time, counts, period):
    return np.asarray(counts, float) * np.append(1, np.rint(steps(time) / period))


def doubled(time, counts, period):
    return np.asarray(counts, float) * np.append(1, np.where(steps(time) > 1.5 * period, 2, 1))


def at_most_three(time, counts, period):
    return np.asarray(counts, float) * np.append(1, np.clip(np.rint(steps(time) / period), 1, 3))


def gap_without_own_cycle(time, counts, period):
    n = np.maximum(np.rint(steps(time) / period), 1)
    return np.asarray(counts, float) * np.append(1, np.where(n > 1, n - 1, 1))


def row_before_the_gap(time, counts, period):
    return np.asarray(counts, float) * np.append(np.maximum(np.rint(steps(time) / period), 1), 1)


def means_of_both_sides(time, counts, period):
    c = np.asarray(counts, float)
    n = np.append(1, np.maximum(np.rint(steps(time) / period), 1))
    return c + (n - 1) * (c + np.append(c[0], c)[:-1]) / 2


def rounded_stamps(time, counts, period):
    return np.asarray(counts, float) * np.append(1, np.maximum(np.diff(np.round(np.asarray(time, float), 2)) // period, 1))


def from_the_grid(time, counts, period):
    grid = np.rint((np.asarray(time, float) - time[0]) / period)
    return np.asarray(counts, float) * np.append(1, np.maximum(np.diff(grid), 1))


def median_period(time, counts, period):
    typical = np.median(steps(time)) if len(time) > 1 else period
    return np.asarray(counts, float) * np.append(1, np.maximum(np.rint(steps(time) / typical), 1))


def float32_stamps(time, counts, period):
    return np.asarray(counts, float) * np.append(1, np.maximum(np.rint(np.diff(np.float32(time)) / period), 1))


def first_row_dropped(time, counts, period):
    return vectors(time, counts, period)[1:]


def first_row_zero(time, counts, period):
    out = vectors(time, counts, period)
    out[0] = 0
    return out


def divided(time, counts, period):
    return np.asarray(counts, float) / np.append(1, np.maximum(np.rint(steps(time) / period), 1))


def numbers_of_cycles(time, counts, period):
    return np.append(1, np.maximum(np.rint(steps(time) / period), 1))


def speeds(time, counts, period):
    return np.append(0, np.asarray(counts, float)[1:] / steps(time))


def total(time, counts, period):
    return vectors(time, counts, period).sum()


def time_and_counts(time, counts, period):
    return time, vectors(time, counts, period)


def in_place(time, counts, period):
    for k in range(1, len(time)):
        counts[k] = counts[k] * max(1, round((time[k] - time[k - 1]) / period))
    return counts


WRONG = {
    "cut off": (cut_off, "astype(int) of 1.9", "plain"),
    "//": (floor_division, "floor", "plain"),
    "rounded up": (rounded_up, "ceil", "plain"),
    "ratio": (ratio, "not rounded", "plain"),
    "zero": (zero_for_close_rows, "0 cycles", "plain"),
    "doubled": (doubled, "two cycles for any gap", "plain"),
    "at most three": (at_most_three, "long gaps cut", "subtle"),
    "own cycle left out": (gap_without_own_cycle, "n - 1 after a gap", "subtle"),
    "row before the gap": (row_before_the_gap, "shifted", "plain"),
    "means of both sides": (means_of_both_sides, "interpolated, not multiplied", "subtle"),
    "rounded stamps": (rounded_stamps, "10 ms", "subtle"),
    "from the grid": (from_the_grid, "rounded from the start, not step by step", "subtle"),
    "median": (median_period, "for period", "plain"),
    "float32": (float32_stamps, "Unix time", "subtle"),
    "first row dropped": (first_row_dropped, "N - 1", "plain"),
    "first row zero": (first_row_zero, "0", "plain"),
    "divided": (divided, "smaller instead of larger", "plain"),
    "cycles": (numbers_of_cycles, "not multiplied", "plain"),
    "speeds": (speeds, "counts per second", "subtle"),
    "total": (total, "one number", "plain"),
    "pair": (time_and_counts, "time too", "plain"),
    "in place": (in_place, "writes into counts", "plain"),
}
