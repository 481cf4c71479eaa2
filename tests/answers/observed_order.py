"""Answers to observed_order(steps, errors): right ones in honest styles, wrong ones as students write them."""

import math
import warnings

import numpy as np


def polyfit(steps, errors):
    return np.polyfit(np.log(steps), np.log(errors), 1)[0]


def base_10(steps, errors):
    slope, _ = np.polyfit(np.log10(steps), np.log10(errors), 1)
    return slope


def sums(steps, errors):
    n = len(steps)
    x, y = [math.log(s) for s in steps], [math.log(e) for e in errors]
    sx, sy, sxx, sxy = sum(x), sum(y), sum(a * a for a in x), sum(a * b for a, b in zip(x, y, strict=True))
    return (n * sxy - sx * sy) / (n * sxx - sx**2)


def least_squares(steps, errors):
    A = np.column_stack([np.log2(steps), np.ones(len(steps))])
    return np.linalg.lstsq(A, np.log2(errors), rcond=None)[0][0]


def covariance(steps, errors):
    c = np.cov(np.log(steps), np.log(errors))
    print(c)
    return c[0, 1] / c[0, 0]


def polynomial_class(steps, errors):
    return np.polynomial.Polynomial.fit(np.log(steps), np.log(errors), 1).convert().coef[1]


def single(steps, errors):
    warnings.warn("in single precision", stacklevel=2)
    return np.float32(polyfit(np.array(steps, dtype=float), np.array(errors, dtype=float)))


def all_pairs(steps, errors):
    x, y = np.log(steps), np.log(errors)
    dx, dy = np.subtract.outer(x, x), np.subtract.outer(y, y)
    return float((dx * dy).sum() / (dx * dx).sum())


def sorted_together(steps, errors):
    order = np.argsort(steps)[::-1]
    return polyfit(np.array(steps)[order], np.array(errors)[order])


class Order:
    def __call__(self, steps, errors):
        Q, R = np.linalg.qr(np.vander(np.log(steps), 2))
        return np.linalg.solve(R, Q.T @ np.log(errors))[0]


RIGHT = {
    "polyfit": polyfit,
    "base 10": base_10,
    "sums": sums,
    "lstsq, base 2": least_squares,
    "covariance, prints": covariance,
    "Polynomial.fit": polynomial_class,
    "float32, warns": single,
    "all pairs": all_pairs,
    "sorted together": sorted_together,
    "object, QR": Order(),
}


def exchanged(steps, errors):
    return np.polyfit(np.log(errors), np.log(steps), 1)[0]


def inverse(steps, errors):
    return 1 / polyfit(steps, errors)


def negative(steps, errors):
    return polyfit(1 / np.array(steps, dtype=float), errors)


def no_logs(steps, errors):
    return np.polyfit(steps, errors, 1)[0]


def semilog(steps, errors):
    return np.polyfit(steps, np.log(errors), 1)[0]


def mixed_logs(steps, errors):
    return np.polyfit(np.log10(steps), np.log(errors), 1)[0]


def coefficients(steps, errors):
    return np.polyfit(np.log(steps), np.log(errors), 1)


def constant(steps, errors):
    return np.polyfit(np.log(steps), np.log(errors), 1)[-1]


def first_pair(steps, errors):
    return math.log(errors[0] / errors[1]) / math.log(steps[0] / steps[1])


def last_pair(steps, errors):
    return math.log(errors[-1] / errors[-2]) / math.log(steps[-1] / steps[-2])


def ends(steps, errors):
    return math.log(errors[-1] / errors[0]) / math.log(steps[-1] / steps[0])


def halved(steps, errors):
    errors = np.array(errors, dtype=float)
    return np.mean(np.log2(errors[:-1] / errors[1:]))


def mean_of_pairs(steps, errors):
    return np.mean(np.diff(np.log(errors)) / np.diff(np.log(steps)))


def median_of_pairs(steps, errors):
    return np.median(np.diff(np.log(errors)) / np.diff(np.log(steps)))


def without_the_first(steps, errors):
    return polyfit(steps[1:], errors[1:]) if len(steps) > 2 else polyfit(steps, errors)


def without_the_smallest(steps, errors):
    keep = np.array(steps) > min(steps) if len(steps) > 2 else np.full(len(steps), True)
    return polyfit(np.array(steps)[keep], np.array(errors)[keep])


def weighted(steps, errors):
    return np.polyfit(np.log(steps), np.log(errors), 1, w=np.sqrt(steps))[0]


def through_one(steps, errors):
    x, y = np.log(steps), np.log(errors)
    return x @ y / (x @ x)


def through_the_first(steps, errors):
    x, y = np.log(steps) - np.log(steps[0]), np.log(errors) - np.log(errors[0])
    return x @ y / (x @ x)


def whole(steps, errors):
    return round(float(polyfit(steps, errors)))


def one_decimal(steps, errors):
    return np.round(polyfit(steps, errors), 1)


def sorted_apart(steps, errors):
    return polyfit(sorted(steps), sorted(errors))


def absolute(steps, errors):
    return abs(polyfit(steps, errors))


def correlation(steps, errors):
    return np.corrcoef(np.log(steps), np.log(errors))[0][1]


def ddof(steps, errors):
    x, y = np.log(steps), np.log(errors)
    return np.mean((x - x.mean()) * (y - y.mean())) / np.var(x, ddof=1)


def in_place(steps, errors):
    for k in range(len(steps)):
        steps[k] = math.log(steps[k])
    return np.polyfit(steps, np.log(errors), 1)[0]


def fraction(steps, errors):
    return f"{polyfit(steps, errors):.3f}"


def nearest_order(steps, errors):
    return min([1, 2, 3, 4], key=lambda p: abs(p - polyfit(steps, errors)))


def printed(steps, errors):
    print(polyfit(steps, errors))


def total_least_squares(steps, errors):
    x, y = np.log(steps), np.log(errors)
    _, _, v = np.linalg.svd(np.column_stack([x - x.mean(), y - y.mean()]))
    return v[0, 1] / v[0, 0]


WRONG = {
    "exchanged": (exchanged, "steps over errors", "plain"),
    "inverse": (inverse, "1 / slope", "plain"),
    "over n": (negative, "slope over 1 / h", "plain"),
    "no logarithms": (no_logs, "linear", "plain"),
    "semilogarithmic": (semilog, "log of the errors only", "plain"),
    "two bases": (mixed_logs, "log10 and log", "plain"),
    "both coefficients": (coefficients, "(2,)", "plain"),
    "intercept": (constant, "[1]", "plain"),
    "first pair": (first_pair, "first two", "plain"),
    "last pair": (last_pair, "last two", "plain"),
    "ends": (ends, "first and last", "plain"),
    "log2 of ratios": (halved, "halved steps assumed", "plain"),
    "mean of pairs": (mean_of_pairs, "mean slope", "plain"),
    "median of pairs": (median_of_pairs, "median slope", "subtle"),
    "without the first": (without_the_first, "one point dropped", "subtle"),
    "without the smallest": (without_the_smallest, "one point dropped", "subtle"),
    "weighted": (weighted, "w = sqrt(h)", "subtle"),
    "through 1": (through_one, "no intercept", "plain"),
    "through the first": (through_the_first, "line through the first point", "subtle"),
    "whole": (whole, "round()", "plain"),
    "one decimal": (one_decimal, "rounded", "subtle"),
    "sorted apart": (sorted_apart, "pairs torn apart", "subtle"),
    "abs": (absolute, "sign lost", "plain"),
    "correlation": (correlation, "r", "plain"),
    "ddof": (ddof, "(N - 1)/N", "subtle"),
    "in place": (in_place, "changes steps", "plain"),
    "text": (fraction, "a string", "plain"),
    "nearest order": (nearest_order, "1, 2, 3 or 4", "subtle"),
    "printed": (printed, "None", "plain"),
    "perpendicular": (total_least_squares, "total least squares", "subtle"),
}
