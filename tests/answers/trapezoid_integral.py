"""Answers to trapezoid_integral(f, a, b, n): right ones in honest styles, wrong ones as students write them."""

import math
import warnings
from functools import reduce
from itertools import pairwise

import numpy as np


def slide_mended(f, a, b, n):
    S = 0
    h = (b - a) / n
    for i in range(n):
        S += h * (f(h * i + a) + f(h * (i + 1) + a)) / 2
    return S


def trapezoid_of_numpy(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    return np.trapezoid(f(x), x)


def weights(f, a, b, n):
    w = np.ones(n + 1)
    w[[0, -1]] /= 2
    return w @ f(np.linspace(a, b, n + 1)) * (b - a) / n


def ends_apart(f, a, b, n):
    h = (b - a) / n
    return h * ((f(a) + f(b)) / 2 + math.fsum(f(a + i * h) for i in range(1, n)))


def both_eulers(f, a, b, n):
    y = f(np.linspace(a, b, n + 1))
    print(y[0], y[-1])
    return (y[1:].sum() + y[:-1].sum()) / 2 * (b - a) / n


def remembered(f, a, b, n):
    h, total = (b - a) / n, 0.0
    last = f(a)
    for i in range(1, n + 1):
        new = f(a + i * h)
        total, last = total + (last + new) / 2 * h, new
    return total


def complex_points(f, a, b, n):
    z = [complex(a + (b - a) * i / n, f(a + (b - a) * i / n)) for i in range(n + 1)]
    return sum((q - p).real * (p.imag + q.imag) / 2 for p, q in pairwise(z))


def folded(f, a, b, n):
    h = (b - a) / n
    return reduce(lambda total, i: total + h * (f(a + i * h) + f(a + (i + 1) * h)) / 2, range(n), 0.0)


def halves(f, a, b, n):
    if n == 1:
        return (b - a) * (f(a) + f(b)) / 2
    k = n // 2
    middle = a + (b - a) * k / n
    return halves(f, a, middle, k) + halves(f, middle, b, n - k)


def float32(f, a, b, n):
    warnings.warn("in single precision", stacklevel=2)
    y = f(np.linspace(a, b, n + 1)).astype(np.float32)
    return np.float32((b - a) / n) * (y[1:-1].sum(dtype=np.float32) + (y[0] + y[-1]) / 2)


def turned_round(f, a, b, n):
    return slide_mended(f, a, b, n) if a <= b else -slide_mended(f, b, a, n)


class Trapezoids:
    def __call__(self, f, a, b, n):
        edges = np.linspace(a, b, n + 1)
        heights = np.array([f(x) for x in edges])
        return np.convolve(heights, [0.5, 0.5], "valid") @ np.diff(edges)


RIGHT = {
    "slide's loop, mended": slide_mended,
    "np.trapezoid": trapezoid_of_numpy,
    "weights": weights,
    "ends apart, fsum": ends_apart,
    "mean of both Euler sums, prints": both_eulers,
    "last value remembered": remembered,
    "complex points": complex_points,
    "reduce": folded,
    "recursion in halves": halves,
    "float32, warns": float32,
    "turned round": turned_round,
    "object, convolution": Trapezoids(),
}


def slide(f, a, b, n):
    S = 0
    h = (b - a) / n
    for i in range(n - 1):
        S += h * (f(h * i + a) + f(h * (i + 1) + a)) / 2
    return S


def no_half(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    y = f(x)
    return np.sum((y[1:] + y[:-1]) * np.diff(x))


def all_points(f, a, b, n):
    return np.sum(f(np.linspace(a, b, n + 1))) * (b - a) / n


def inner_points(f, a, b, n):
    return np.sum(f(np.linspace(a, b, n + 1)[1:-1])) * (b - a) / n


def euler(f, a, b, n):
    return np.sum(f(np.linspace(a, b, n + 1)[:-1])) * (b - a) / n


def midpoint(f, a, b, n):
    h = (b - a) / n
    return h * sum(f((a + i * h + a + (i + 1) * h) / 2) for i in range(n))


def geometric_mean(f, a, b, n):
    y = f(np.linspace(a, b, n + 1))
    return np.sum(np.sign(y[1:]) * np.sqrt(np.abs(y[1:] * y[:-1]))) * (b - a) / n


def higher_of_both(f, a, b, n):
    y = f(np.linspace(a, b, n + 1))
    return np.sum(np.maximum(y[1:], y[:-1])) * (b - a) / n


def n_points(f, a, b, n):
    x = np.linspace(a, b, n)
    return np.trapezoid(f(x), x)


def n_points_dx(f, a, b, n):
    return np.trapezoid(f(np.linspace(a, b, n)), dx=(b - a) / n)


def dx_forgotten(f, a, b, n):
    return np.trapezoid(f(np.linspace(a, b, n + 1)))


def exchanged_arguments(f, a, b, n):
    x = np.linspace(a, b, n + 1)
    return np.trapezoid(x, f(x))


def half_of_the_last_only(f, a, b, n):
    h = (b - a) / n
    return sum(h * f(a + i * h) + f(a + (i + 1) * h) / 2 for i in range(n))


def brackets(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * i + 1 + a)) / 2 for i in range(n))


def simpson(f, a, b, n):
    x, h = np.linspace(a, b, n + 1, retstep=True)
    return h / 6 * np.sum(f(x[:-1]) + 4 * f(x[:-1] + h / 2) + f(x[1:]))


def twice_as_fine(f, a, b, n):
    return slide_mended(f, a, b, 2 * n)


def always_1000(f, a, b, n):
    return trapezoid_of_numpy(f, a, b, 1000)


def from_zero(f, a, b, n):
    return slide_mended(f, 0, b - a, n)


def absolute(f, a, b, n):
    return abs(slide_mended(f, a, b, n))


def absolute_step(f, a, b, n):
    h = abs((b - a) / n)
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def sorted_limits(f, a, b, n):
    return slide_mended(f, min(a, b), max(a, b), n)


def arange(f, a, b, n):
    h = (b - a) / n
    x = np.arange(a, b + h, h)
    return np.trapezoid(f(x), x)


def while_below_b(f, a, b, n):
    h, x, total = (b - a) / n, a, 0.0
    while (b - x) * h > 0:
        total += h * (f(x) + f(x + h)) / 2
        x += h
    return total


def floor_half(f, a, b, n):
    h = (b - a) / n
    return sum(h * ((f(h * i + a) + f(h * (i + 1) + a)) // 2) for i in range(n))


def floor_step(f, a, b, n):
    h = (b - a) // n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def replaced(f, a, b, n):
    h = (b - a) / n
    for i in range(n):
        S = h * (f(h * i + a) + f(h * (i + 1) + a)) / 2
    return S


def early_return(f, a, b, n):
    h, S = (b - a) / n, 0
    for i in range(n):
        S += h * (f(h * i + a) + f(h * (i + 1) + a)) / 2
        return S


def even_n_only(f, a, b, n):
    return slide_mended(f, a, b, n - n % 2 or 1)


def lists(f, a, b, n):
    return sum([f(x) for x in np.linspace(a, b, n + 1)]) - f(a) / 2 - f(b) / 2


def printed(f, a, b, n):
    print("S =", slide_mended(f, a, b, n))


def text(f, a, b, n):
    return f"{slide_mended(f, a, b, n):.6f}"


def each(f, a, b, n):
    y = f(np.linspace(a, b, n + 1))
    return (y[1:] + y[:-1]) / 2 * (b - a) / n


def cumulated(f, a, b, n):
    return np.cumsum(each(f, a, b, n))


def three_decimals(f, a, b, n):
    return round(float(slide_mended(f, a, b, n)), 3)


WRONG = {
    "slide's loop": (slide, "range(n - 1)", "plain"),
    "no half": (no_half, "without / 2", "plain"),
    "all points": (all_points, "ends with full weight", "plain"),
    "inner points": (inner_points, "ends missing", "plain"),
    "Euler": (euler, "left rectangles", "plain"),
    "midpoint": (midpoint, "mean of the places", "plain"),
    "geometric mean": (geometric_mean, "sqrt of the product", "subtle"),
    "upper sums": (higher_of_both, "the higher of both ends", "subtle"),
    "n points": (n_points, "linspace(a, b, n)", "plain"),
    "n points, dx": (n_points_dx, "n points beside h", "plain"),
    "dx forgotten": (dx_forgotten, "dx = 1", "plain"),
    "x and y exchanged": (exchanged_arguments, "np.trapezoid(x, y)", "subtle"),
    "half of the second": (half_of_the_last_only, "h f0 + f1/2", "subtle"),
    "h i + 1": (brackets, "brackets", "plain"),
    "Simpson": (simpson, "better than asked for", "plain"),
    "2n": (twice_as_fine, "twice as many", "subtle"),
    "1000": (always_1000, "n ignored", "subtle"),
    "from 0": (from_zero, "a subtracted from both limits", "plain"),
    "abs": (absolute, "always positive", "plain"),
    "abs of h": (absolute_step, "wrong way for b < a", "plain"),
    "sorted limits": (sorted_limits, "sign lost", "plain"),
    "arange": (arange, "a point too many sometimes", "subtle"),
    "while": (while_below_b, "a step too many sometimes", "subtle"),
    "// 2": (floor_half, "mean height cut", "subtle"),
    "// n": (floor_step, "step cut", "plain"),
    "=": (replaced, "last only", "plain"),
    "return in the loop": (early_return, "first only", "plain"),
    "even n": (even_n_only, "odd n rounded down", "subtle"),
    "no width": (lists, "h forgotten", "plain"),
    "printed": (printed, "None", "plain"),
    "text": (text, "a string", "plain"),
    "areas": (each, "not added", "plain"),
    "running": (cumulated, "cumsum", "plain"),
    "three decimals": (three_decimals, "rounded", "subtle"),
}
