"""Answers to euler_integral(f, a, b, n): right ones in honest styles, wrong ones as students write them."""

import math
import warnings

import numpy as np


def loop(f, a, b, n):
    h = (b - a) / n
    S = 0
    for i in range(n):
        S += h * f(h * i + a)
    return S


def array(f, a, b, n):
    h = (b - a) / n
    return h * np.sum(f(a + h * np.arange(n)))


def linspace_without_end(f, a, b, n):
    x, h = np.linspace(a, b, n, endpoint=False, retstep=True)
    return f(x).sum() * h


def borders(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    return np.dot(f(x[:-1]), np.diff(x))


def walking(f, a, b, n):
    h, x, total = (b - a) / n, a, 0.0
    for _ in range(n):
        total, x = total + f(x) * h, x + h
    return total


def fsum(f, a, b, n):
    print("n =", n)
    return math.fsum(map(f, (a + k * (b - a) / n for k in range(n)))) * (b - a) / n


def recursion(f, a, b, n):
    if n == 0:
        return 0.0
    h = (b - a) / n
    return f(a) * h + recursion(f, a + h, b, n - 1)


def float32(f, a, b, n):
    warnings.warn("in single precision", stacklevel=2)
    h = np.float32(b - a) / np.float32(n)
    return np.float32(h * np.sum(f(np.arange(n) * (b - a) / n + a)))


def vectorised(f, a, b, n):
    return np.vectorize(f)(np.linspace(a, b, n + 1)[:n]).mean() * (b - a)


def turned_round(f, a, b, n):
    return array(f, a, b, n) if a < b else -array(f, b, a, n)


def zero_dimensional(f, a, b, n):
    return np.array(loop(f, float(a), float(b), int(n)))


class Euler:
    def __call__(self, f, a, b, n):
        self.h = (b - a) / n
        return sum(self.area(f, a + i * self.h) for i in range(n))

    def area(self, f, left):
        return f(left) * self.h


RIGHT = {
    "loop": loop,
    "array": array,
    "linspace without its end": linspace_without_end,
    "borders, dot": borders,
    "walking along x": walking,
    "fsum, prints": fsum,
    "recursion": recursion,
    "float32, warns": float32,
    "np.vectorize, mean": vectorised,
    "left on the x axis": turned_round,
    "0-d array": zero_dimensional,
    "object": Euler(),
}


def two_short(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(n - 2))


def to_n_plus_one(f, a, b, n):
    return float(np.sum(f(np.linspace(a, b, n + 1))) * (b - a) / n)


def step_of_all_points(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    return float(np.sum(f(x)) * (b - a) / (n + 1))


def right(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    return np.sum(f(x[1:]) * np.diff(x))


def lower_of_both(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    y = f(x)
    return np.sum(np.minimum(y[1:], y[:-1]) * np.diff(x))


def middle(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    return np.sum(f((x[1:] + x[:-1]) / 2)) * (b - a) / n


def trapezoid(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    return np.trapezoid(f(x), x)


def n_points(f, a, b, n):
    x = np.linspace(a, b, n)
    return np.sum(f(x) * (b - a) / n)


def twice_as_fine(f, a, b, n):
    return array(f, a, b, 2 * n)


def always_100(f, a, b, n):
    return array(f, a, b, 100)


def always_10000(f, a, b, n):
    return array(f, a, b, 10**6 // 2)


def no_start(f, a, b, n):
    h = (b - a) / n
    return sum(f(i * h) * h for i in range(n))


def from_zero_to_b(f, a, b, n):
    return array(f, 0, b, n)


def no_width(f, a, b, n):
    return np.sum(f(np.linspace(a, b, n + 1)[:-1]))


def absolute(f, a, b, n):
    return abs(array(f, a, b, n))


def absolute_heights(f, a, b, n):
    return (b - a) / n * np.abs(f(np.linspace(a, b, n, endpoint=False))).sum()


def reversed_ignored(f, a, b, n):
    total, h, x = 0.0, (b - a) / n, a
    while x < b - h / 2:
        total, x = total + f(x) * h, x + h
    return total


def while_below_b(f, a, b, n):
    total, h, x = 0.0, (b - a) / n, a
    while (x < b) if h > 0 else (x > b):
        total, x = total + f(x) * h, x + h
    return total


def sorted_limits(f, a, b, n):
    return array(f, *sorted([a, b]), n)


def floor_step(f, a, b, n):
    h = (b - a) // n
    return sum(f(a + i * h) * h for i in range(n))


def integer_nodes(f, a, b, n):
    x = np.linspace(a, b, n, endpoint=False).astype(int)
    return np.sum(f(x)) * (b - a) / n


def integer_start(f, a, b, n):
    return array(f, int(a), b, n)


def replaced(f, a, b, n):
    h = (b - a) / n
    for i in range(n):
        S = h * f(a + i * h)
    return S


def early_return(f, a, b, n):
    S, h = 0, (b - a) / n
    for i in range(n):
        S += h * f(a + i * h)
        return S


def printed(f, a, b, n):
    print(loop(f, a, b, n))


def listed(f, a, b, n):
    return [loop(f, a, b, n)]


def areas(f, a, b, n):
    return (b - a) / n * f(np.linspace(a, b, n, endpoint=False))


def h_precedence(f, a, b, n):
    h = b - a / n
    return sum(f(a + i * h) * h for i in range(n))


def x_precedence(f, a, b, n):
    h = (b - a) / n
    return sum(f(a + h) * i * h for i in range(n))


def negative_step(f, a, b, n):
    return -array(f, a, b, n)


def two_decimals(f, a, b, n):
    return round(float(array(f, a, b, n)), 3)


WRONG = {
    "range(n - 2)": (two_short, "two rectangles missing", "subtle"),
    "n + 1 points": (to_n_plus_one, "one too many", "plain"),
    "n + 1 points, h for n + 1": (step_of_all_points, "mean of all borders", "subtle"),
    "right": (right, "ends", "plain"),
    "lower sums": (lower_of_both, "the lower of both ends", "subtle"),
    "midpoint": (middle, "middle", "plain"),
    "trapezoid": (trapezoid, "next exercise", "plain"),
    "n points": (n_points, "linspace(a, b, n)", "plain"),
    "2n": (twice_as_fine, "twice as many", "subtle"),
    "always 100": (always_100, "n ignored", "subtle"),
    "very fine": (always_10000, "n ignored: nearly exact", "subtle"),
    "f(ih)": (no_start, "a ignored", "plain"),
    "from 0": (from_zero_to_b, "0 to b", "subtle"),
    "no h": (no_width, "heights only", "plain"),
    "abs": (absolute, "always positive", "plain"),
    "abs of f": (absolute_heights, "heights positive", "plain"),
    "while x < b": (reversed_ignored, "0 for b < a", "plain"),
    "while beside b": (while_below_b, "rounding adds a rectangle", "subtle"),
    "sorted limits": (sorted_limits, "sign lost", "plain"),
    "// n": (floor_step, "step cut", "plain"),
    "integer nodes": (integer_nodes, "nodes cut to whole numbers", "subtle"),
    "int(a)": (integer_start, "start cut", "subtle"),
    "=": (replaced, "last only", "plain"),
    "return in the loop": (early_return, "first only", "plain"),
    "printed": (printed, "None", "plain"),
    "list": (listed, "a list of one", "plain"),
    "areas": (areas, "not added", "plain"),
    "b - a/n": (h_precedence, "brackets", "plain"),
    "f(a + h) i": (x_precedence, "i outside", "subtle"),
    "minus": (negative_step, "sign", "plain"),
    "three decimals": (two_decimals, "rounded", "subtle"),
}
