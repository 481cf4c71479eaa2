"""Answers to umbmark(cw_errors, ccw_errors, side, tread): right ones in honest styles, wrong ones as students write them."""

import math
import statistics
import warnings
from fractions import Fraction

import numpy as np


def as_written(cw_errors, ccw_errors, side, tread):
    x_cw = np.mean(np.asarray(cw_errors, float)[:, 0])
    x_ccw = np.mean(np.asarray(ccw_errors, float)[:, 0])
    alpha = (x_cw + x_ccw) / (-4 * side)
    beta = (x_cw - x_ccw) / (-4 * side)
    if beta == 0:
        E_d = 1.0
    else:
        R = (side / 2) / np.sin(beta / 2)
        E_d = (R + tread / 2) / (R - tread / 2)
    return E_d, (np.pi / 2) / (np.pi / 2 - alpha)


def loops(cw_errors, ccw_errors, side, tread):
    centres = []
    for runs in (cw_errors, ccw_errors):
        total = 0.0
        for x, _ in runs:
            total += x
        centres.append(total / len(runs))
    alpha, beta = (centres[0] + centres[1]) / (-4 * side), (centres[0] - centres[1]) / (-4 * side)
    # the radius times the sine: no division by zero
    sine = math.sin(beta / 2)
    print("alpha", alpha, "beta", beta)
    return [(side + tread * sine) / (side - tread * sine), 90 / (90 - math.degrees(alpha))]


def ignoring_the_division(cw_errors, ccw_errors, side, tread):
    (x_cw, _), (x_ccw, _) = np.mean(cw_errors, axis=0), np.mean(ccw_errors, axis=0)
    with np.errstate(all="ignore"):
        radius = np.float64(side) / 2 / np.sin((x_cw - x_ccw) / (-8 * side))
        wheels = np.nan_to_num((radius + tread / 2) / (radius - tread / 2), nan=1.0)
    return np.array([wheels, np.pi / (np.pi + (x_cw + x_ccw) / (2 * side))])


def statistics_and_fractions(cw_errors, ccw_errors, side, tread):
    x_cw, x_ccw = (statistics.fmean(float(row[0]) for row in runs) for runs in (cw_errors, ccw_errors))
    beta = float((Fraction(x_cw) - Fraction(x_ccw)) / (-4 * Fraction(side)))
    alpha = -(x_cw + x_ccw) / 4 / side
    half = tread / 2
    curvature = 2 * math.sin(beta / 2) / side
    return (1 + half * curvature) / (1 - half * curvature), 1 / (1 - alpha * 2 / math.pi)


class Calibration:
    def __call__(self, cw_errors, ccw_errors, side, tread):
        table = [np.array(runs, np.float64).T[0].mean() for runs in (cw_errors, ccw_errors)]
        alpha, beta = np.array([[1, 1], [1, -1]]) @ table / (-4.0 * side)
        warnings.warn("calibrated", stacklevel=1)
        return self.wheels(beta, side, tread), np.float32(math.pi / 2 / (math.pi / 2 - alpha))

    def wheels(self, beta, side, tread):
        try:
            radius = side / 2 / math.sin(beta / 2)
        except ZeroDivisionError:
            return 1
        return np.float32((radius + tread / 2) / (radius - tread / 2))


RIGHT = {
    "as written": as_written,
    "loops, no division by zero, prints": loops,
    "NaN made 1": ignoring_the_division,
    "statistics and fractions": statistics_and_fractions,
    "object, matrix, float32, warns": Calibration(),
}


def variant(cw_errors, ccw_errors, side, tread, *, centre=None, alpha=None, beta=None, radius=None, result=None):
    """Return the answer with one thing changed."""
    centre = centre or (lambda runs: float(np.mean(np.asarray(runs, float)[:, 0])))
    x_cw, x_ccw = centre(cw_errors), centre(ccw_errors)
    a = alpha(x_cw, x_ccw, side) if alpha else (x_cw + x_ccw) / (-4 * side)
    b = beta(x_cw, x_ccw, side) if beta else (x_cw - x_ccw) / (-4 * side)
    r = (radius(b, side) if radius else side / 2 / np.sin(b / 2)) if b else math.inf
    wheels = (r + tread / 2) / (r - tread / 2) if b else 1.0
    base = (math.pi / 2) / (math.pi / 2 - a)
    return result(wheels, base, a, b) if result else (wheels, base)


def wrong(**changes):
    return lambda cw_errors, ccw_errors, side, tread: variant(cw_errors, ccw_errors, side, tread, **changes)


def mean_radius_of_curvature(cw_errors, ccw_errors, side, tread):
    """E_d by the approximation for small angles."""
    _, base = as_written(cw_errors, ccw_errors, side, tread)
    x_cw, x_ccw = np.mean(cw_errors, axis=0)[0], np.mean(ccw_errors, axis=0)[0]
    return 1 - tread * (x_cw - x_ccw) / (4 * side**2), base


def division_by_zero(cw_errors, ccw_errors, side, tread):
    x_cw, x_ccw = (sum(float(row[0]) for row in runs) / len(runs) for runs in (cw_errors, ccw_errors))
    r = side / 2 / math.sin((x_cw - x_ccw) / (-8 * side))
    return (r + tread / 2) / (r - tread / 2), (math.pi / 2) / (math.pi / 2 + (x_cw + x_ccw) / (4 * side))


def arrays_only(cw_errors, ccw_errors, side, tread):
    cw_errors[:, 0], ccw_errors[:, 0]
    return as_written(cw_errors, ccw_errors, side, tread)


WRONG = {
    "y": (wrong(centre=lambda runs: float(np.mean(np.asarray(runs, float)[:, 1]))), "second column", "plain"),
    "both columns": (wrong(centre=lambda runs: float(np.mean(runs))), "mean over all", "plain"),
    "distance": (wrong(centre=lambda runs: float(np.hypot(*np.mean(runs, axis=0)))), "no sign", "plain"),
    "mean of distances": (wrong(centre=lambda runs: float(np.mean(np.hypot(*np.transpose(runs))))), "no sign", "subtle"),
    "largest": (wrong(centre=lambda runs: max((float(row[0]) for row in runs), key=abs)), "worst run", "subtle"),
    "first run": (wrong(centre=lambda runs: float(runs[0][0])), "one run", "plain"),
    "sum": (wrong(centre=lambda runs: sum(float(row[0]) for row in runs)), "not the mean", "plain"),
    "divided by five": (wrong(centre=lambda runs: sum(float(row[0]) for row in runs) / 5), "five runs assumed", "subtle"),
    "4 for -4": (wrong(alpha=lambda p, q, L: (p + q) / (4 * L), beta=lambda p, q, L: (p - q) / (4 * L)), "sign", "plain"),
    "2 for 4": (wrong(alpha=lambda p, q, L: (p + q) / (-2 * L), beta=lambda p, q, L: (p - q) / (-2 * L)), "factor", "plain"),
    "alpha without the side": (wrong(alpha=lambda p, q, L: (p + q) / -4), "side missing", "subtle"),
    "beta reversed": (wrong(beta=lambda p, q, L: (q - p) / (-4 * L)), "ccw minus cw", "plain"),
    "exchanged": (
        wrong(alpha=lambda p, q, L: (p - q) / (-4 * L), beta=lambda p, q, L: (p + q) / (-4 * L)),
        "alpha, beta",
        "plain",
    ),
    "beta in degrees": (wrong(beta=lambda p, q, L: math.degrees((p - q) / (-4 * L))), "sin of degrees", "subtle"),
    "sin(beta)": (wrong(radius=lambda b, L: L / 2 / math.sin(b)), "whole angle", "plain"),
    "whole side": (wrong(radius=lambda b, L: L / math.sin(b / 2)), "not halved", "plain"),
    "arc": (wrong(radius=lambda b, L: L / b), "arc for chord", "plain"),
    "small angles": (mean_radius_of_curvature, "first order", "subtle"),
    "inverted": (wrong(result=lambda d, b, *_: (1 / d, 1 / b)), "both", "plain"),
    "E_b inverted": (wrong(result=lambda d, b, *_: (d, 1 / b)), "E_b", "plain"),
    "order": (wrong(result=lambda d, b, *_: (b, d)), "E_b first", "plain"),
    "errors": (wrong(result=lambda d, b, *_: (d - 1, b - 1)), "less 1", "subtle"),
    "per cent": (wrong(result=lambda d, b, *_: (100 * d, 100 * b)), "times 100", "subtle"),
    "corrections": (wrong(result=lambda d, b, *_: (2 / (d + 1), 2 / (1 / d + 1))), "c_l and c_r", "subtle"),
    "angles": (wrong(result=lambda d, b, alpha, beta: (alpha, beta)), "alpha and beta", "plain"),
    "E_d only": (wrong(result=lambda d, *_: d), "one number", "plain"),
    "division by zero": (division_by_zero, "beta = 0", "plain"),
    "arrays only": (arrays_only, "lists fail", "plain"),
}
