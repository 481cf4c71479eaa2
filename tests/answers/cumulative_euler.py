"""Answers to cumulative_euler(y, t, initial=0.0): right ones in honest styles, wrong ones as students write them."""

import warnings
from functools import reduce
from itertools import accumulate, pairwise

import numpy as np


def area(y, t, k):
    """Return what step k, from sample k to k + 1, adds."""
    return y[k] * (t[k + 1] - t[k])


def arrays(y, t):
    return np.array(y, dtype=float), np.array(t, dtype=float)


def sums(y, t, initial=0.0):
    y, t = arrays(y, t)
    return initial + np.concatenate([[0.0], np.cumsum(y[:-1] * np.diff(t))])


def loop(y, t, initial=0.0):
    out = [initial]
    for k in range(len(t) - 1):
        out.append(out[-1] + area(y, t, k))
    return out


def filled(y, t, initial=0.0):
    out = np.empty(len(t))
    out[0] = initial
    for k in range(1, len(t)):
        out[k] = out[k - 1] + area(y, t, k - 1)
    return out


def prefixes(y, t, initial=0.0):
    return tuple(initial + sum(area(y, t, k) for k in range(end)) for end in range(len(t)))


def triangular(y, t, initial=0.0):
    y, t = arrays(y, t)
    return np.tri(len(t), len(t) - 1, -1) @ (y[:-1] * np.diff(t)) + initial


def accumulated(y, t, initial=0.0):
    print(len(t), "samples")
    return np.array(list(accumulate((area(y, t, k) for k in range(len(t) - 1)), initial=initial)))


def recursion(y, t, initial=0.0):
    if len(t) == 1:
        return [initial]
    return [initial, *recursion(y[1:], t[1:], initial + area(y, t, 0))]


def folded(y, t, initial=0.0):
    warnings.warn("slow", stacklevel=2)
    return reduce(lambda out, k: np.append(out, out[-1] + area(y, t, k)), range(len(t) - 1), np.array([initial], dtype=float))


def single(y, t, initial=0.0):
    return np.array(loop(y, t, initial), dtype=np.float32)


def from_zero(y, t, initial=0.0):
    return sums(y, np.array(t) - t[0], initial)


class Integral:
    def __call__(self, y, t, initial=0.0):
        self.value = initial
        return np.array([initial, *(self.step(y, t, k) for k, _ in enumerate(pairwise(t)))])

    def step(self, y, t, k):
        self.value += area(y, t, k)
        return self.value


RIGHT = {
    "sums": sums,
    "loop, list": loop,
    "filled": filled,
    "prefixes, tuple": prefixes,
    "triangular matrix": triangular,
    "accumulate, prints": accumulated,
    "recursion": recursion,
    "reduce, warns": folded,
    "float32": single,
    "time from zero": from_zero,
    "object": Integral(),
}


def other_rule(y, t, initial=0.0):
    y, t = arrays(y, t)
    return initial + np.append(0, np.cumsum((y[1:] + y[:-1]) / 2 * np.diff(t)))


def ends(y, t, initial=0.0):
    y, t = arrays(y, t)
    return initial + np.append(0, np.cumsum(np.diff(t) * y[1:]))


def lower(y, t, initial=0.0):
    y, t = arrays(y, t)
    return initial + np.append(0, np.cumsum(np.diff(t) * np.minimum(y[1:], y[:-1])))


def fixed_rate(y, t, initial=0.0):
    y, t = arrays(y, t)
    return initial + np.append(0, np.cumsum(y[:-1])) * 0.005


def mean_step(y, t, initial=0.0):
    y, t = arrays(y, t)
    h = np.diff(t).mean() if len(t) > 1 else 0.0
    return initial + np.append(0, np.cumsum(y[:-1] * h))


def median_step(y, t, initial=0.0):
    y, t = arrays(y, t)
    h = np.median(np.diff(t)) if len(t) > 1 else 0.0
    return initial + np.append(0, np.cumsum(y[:-1] * h))


def first_step(y, t, initial=0.0):
    y, t = arrays(y, t)
    return initial + np.append(0, np.cumsum(y[:-1] * (t[1] - t[0] if t.size > 1 else 0)))


def all_values(y, t, initial=0.0):
    dt = np.diff(t)
    return initial + np.cumsum(np.array(y, dtype=float) * np.append(dt, 0.0))


def gradient_of_time(y, t, initial=0.0):
    y, t = arrays(y, t)
    dt = np.gradient(t) if len(t) > 1 else np.zeros(1)
    return initial + np.append(0, np.cumsum(y[:-1] * dt[:-1]))


def ignored(y, t, initial=0.0):
    return sums(y, t)


def in_front(y, t, initial=0.0):
    return np.append(initial, sums(y, t)[1:])


def every_step(y, t, initial=0.0):
    out = sums(y, t)
    return out + initial * np.arange(1, len(out) + 1)


def short(y, t, initial=0.0):
    return sums(y, t, initial)[1:]


def too_long(y, t, initial=0.0):
    out = sums(y, t, initial)
    return np.append(out, out[-1])


def last(y, t, initial=0.0):
    return sums(y, t, initial)[-1]


def loop_to_n_minus_1(y, t, initial=0.0):
    out = np.zeros(len(t))
    out[0] = initial
    for k in range(1, len(t) - 1):
        out[k] = out[k - 1] + area(y, t, k - 1)
    return out


def whole(y, t, initial=0.0):
    out = np.full(len(y), initial)
    for k in range(1, len(y)):
        out[k] = out[k - 1] + area(y, t, k - 1)
    return out


def written_over(y, t, initial=0.0):
    areas = [area(y, t, k) for k in range(len(t) - 1)]
    y[0] = initial
    for k, step in enumerate(areas):
        y[k + 1] = y[k] + step
    return y


def written_over_time(y, t, initial=0.0):
    start = t[0]
    for k in range(len(t)):
        t[k] -= start
    return sums(y, t, initial)


def column(y, t, initial=0.0):
    return sums(y, t, initial)[:, np.newaxis]


def beside_time(y, t, initial=0.0):
    return t, sums(y, t, initial)


def backwards(y, t, initial=0.0):
    return sums(y[::-1], t[::-1], initial)[::-1]


def sorted_values(y, t, initial=0.0):
    return sums(np.sort(y), t, initial)


def float32_time(y, t, initial=0.0):
    return sums(y, np.array(t, dtype=np.float32), initial)


def only_arrays(y, t, initial=0.0):
    return initial + np.append(0, np.cumsum(y[:-1] * (t[1:] - t[:-1])))


def negative_cut(y, t, initial=0.0):
    return sums(np.maximum(y, 0), t, initial)


def no_sums(y, t, initial=0.0):
    return np.append(initial, np.diff(sums(y, t)) + initial)


def minus(y, t, initial=0.0):
    return initial - sums(y, t)


def printed(y, t, initial=0.0):
    for value in sums(y, t, initial):
        print(value)


def four_decimals(y, t, initial=0.0):
    return sums(y, t, initial).round(3)


def starts_at_the_first_value(y, t, initial=0.0):
    return sums(y, t, initial) + y[0]


WRONG = {
    "the other rule": (other_rule, "trapezoids", "plain"),
    "values at the ends": (ends, "right rectangles", "plain"),
    "lower of both": (lower, "lower sums", "subtle"),
    "5 ms": (fixed_rate, "nominal dt", "subtle"),
    "mean step": (mean_step, "mean(dt)", "plain"),
    "median step": (median_step, "median(dt)", "subtle"),
    "first step": (first_step, "t[1] - t[0]", "plain"),
    "every sample": (all_values, "no first value", "subtle"),
    "np.gradient(t)": (gradient_of_time, "central steps", "subtle"),
    "initial ignored": (ignored, "0", "plain"),
    "initial in front": (in_front, "first only", "plain"),
    "initial every step": (every_step, "again and again", "plain"),
    "N - 1 values": (short, "first missing", "plain"),
    "N + 1 values": (too_long, "last twice", "plain"),
    "total": (last, "a number", "plain"),
    "loop to N - 1": (loop_to_n_minus_1, "last 0", "plain"),
    "whole numbers": (whole, "np.full of an int", "subtle"),
    "y written over": (written_over, "changes its input", "plain"),
    "t written over": (written_over_time, "changes its input", "plain"),
    "column": (column, "(N, 1)", "plain"),
    "with the time": (beside_time, "a pair", "plain"),
    "backwards": (backwards, "from the end", "subtle"),
    "sorted": (sorted_values, "order lost", "subtle"),
    "float32 time": (float32_time, "Unix seconds", "subtle"),
    "arrays only": (only_arrays, "lists fail", "plain"),
    "no negative values": (negative_cut, "cut at 0", "subtle"),
    "no sums": (no_sums, "steps", "plain"),
    "minus": (minus, "sign", "plain"),
    "printed": (printed, "None", "plain"),
    "three decimals": (four_decimals, "rounded", "subtle"),
    "from y[0]": (starts_at_the_first_value, "y[0] added", "subtle"),
}
