"""Answers to wheel_speed(counts, dt, radius, gear, counts_per_rev): right ones in honest styles, wrong ones as students write them."""

import math
import warnings

import numpy as np


def slides(counts, dt, radius, gear, counts_per_rev):
    d_theta = 2 * np.pi * np.asarray(counts) / gear / counts_per_rev
    omega = d_theta / np.asarray(dt)
    return radius * omega


def circumference(counts, dt, radius, gear, counts_per_rev):
    metres = math.tau * radius * np.divide(counts, gear * counts_per_rev)
    return np.divide(metres, dt)


def comprehension(counts, dt, radius, gear, counts_per_rev):
    k = 2 * math.pi * radius / (gear * counts_per_rev)
    if isinstance(counts, int | float):
        return k * counts / dt
    steps = dt if isinstance(dt, list | tuple | np.ndarray) else [dt] * len(counts)
    return tuple(k * c / h for c, h in zip(counts, steps, strict=True))


def rates_first(counts, dt, radius, gear, counts_per_rev):
    rate = np.array(counts, dtype=float) / np.array(dt, dtype=float)
    print("counts per second:", rate)
    return (rate / counts_per_rev / gear * 2 * np.pi * radius).tolist()


def single_precision(counts, dt, radius, gear, counts_per_rev):
    rate = np.asarray(counts, np.float32) / np.asarray(dt, np.float32)
    return rate * np.float32(2 * np.pi * radius / (gear * counts_per_rev))


def broadcast(counts, dt, radius, gear, counts_per_rev):
    warnings.warn("broadcasting", stacklevel=1)
    counts, dt = np.broadcast_arrays(np.asarray(counts, float), np.asarray(dt, float))
    return np.einsum("...,...->...", counts, 1 / dt) * (2 * np.pi * radius / gear / counts_per_rev)


class Wheel:
    """A wheel that knows how far it rolls for one count."""

    def __call__(self, counts, dt, radius, gear, counts_per_rev):
        self.metres_per_count = 2 * np.pi * radius / (gear * counts_per_rev)
        return np.vectorize(self.speed, otypes=[float])(counts, dt)[()]

    def speed(self, count, step):
        return count * self.metres_per_count / step


RIGHT = {
    "as on the slides": slides,
    "share of the circumference": circumference,
    "comprehension, tuple": comprehension,
    "rates first, list, prints": rates_first,
    "float32": single_precision,
    "broadcast, einsum, warns": broadcast,
    "object with __call__, np.vectorize": Wheel(),
}


def metres(counts, dt, radius, gear, counts_per_rev):
    return circumference(counts, 1.0, radius, gear, counts_per_rev)


def rim_of_the_motor(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, dt, radius, 1, counts_per_rev)


def gear_wrong_way(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, dt, radius, 1 / gear, counts_per_rev)


def diameter(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, dt, 2 * radius, gear, counts_per_rev)


def half_the_rim(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, dt, radius / 2, gear, counts_per_rev)


def angular(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, dt, 1.0, gear, counts_per_rev)


def revolutions(counts, dt, radius, gear, counts_per_rev):
    return np.divide(counts, dt) / (gear * counts_per_rev) * radius


def dt_on_top(counts, dt, radius, gear, counts_per_rev):
    return circumference(counts, 1 / np.asarray(dt, float), radius, gear, counts_per_rev)


def dt_of_the_board(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, 0.005, radius, gear, counts_per_rev)


def dt_of_20_ms(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, 0.02, radius, gear, counts_per_rev)


def nominal_dt(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, np.min(dt), radius, gear, counts_per_rev)


def average_dt(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, np.mean(dt), radius, gear, counts_per_rev)


def shifted_dt(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, np.roll(dt, 1) if np.ndim(dt) else dt, radius, gear, counts_per_rev)


def dt_as_stamps(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, np.gradient(dt) if np.size(dt) > 1 else dt, radius, gear, counts_per_rev)


def milliseconds(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, np.asarray(dt) * 1e-3, radius, gear, counts_per_rev)


def kilometres_per_hour(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, dt, radius, gear, counts_per_rev) * 3600 / 1000


def speed_without_sign(counts, dt, radius, gear, counts_per_rev):
    return np.hypot(slides(counts, dt, radius, gear, counts_per_rev), 0)


def no_reversing(counts, dt, radius, gear, counts_per_rev):
    return np.maximum(slides(counts, dt, radius, gear, counts_per_rev), 0)


def whole_dc(counts, dt, radius, gear, counts_per_rev):
    d_c = np.asarray(np.asarray(counts) / gear).astype(int)
    return radius * 2 * np.pi * d_c / counts_per_rev / dt


def two_places(counts, dt, radius, gear, counts_per_rev):
    return np.round(slides(counts, dt, radius, gear, counts_per_rev), 2)


def total_counter(counts, dt, radius, gear, counts_per_rev):
    increments = np.diff(np.atleast_1d(counts), prepend=0)
    return (
        slides(increments, dt, radius, gear, counts_per_rev)
        if np.ndim(counts)
        else slides(counts, dt, radius, gear, counts_per_rev)
    )


def long_average(counts, dt, radius, gear, counts_per_rev):
    if np.ndim(counts) == 0:
        return slides(counts, dt, radius, gear, counts_per_rev)
    v = slides(counts, dt, radius, gear, counts_per_rev)
    return np.append(v[:1], (v[1:] + v[:-1]) / 2)


def even_steps_only(counts, dt, radius, gear, counts_per_rev):
    return slides(counts, float(np.asarray(dt).flat[0]), radius, gear, counts_per_rev)


def scales_its_input(counts, dt, radius, gear, counts_per_rev):
    if isinstance(counts, np.ndarray) and counts.dtype.kind == "f":
        counts *= 2 * np.pi / gear / counts_per_rev
        return counts * radius / dt
    return slides(counts, dt, radius, gear, counts_per_rev)


def loop_forgets_dt_array(counts, dt, radius, gear, counts_per_rev):
    return [2 * np.pi * radius * c / (gear * counts_per_rev) / dt for c in counts]


WRONG = {
    "metres": (metres, "not divided by dt", "plain"),
    "rim of the motor": (rim_of_the_motor, "no gear", "plain"),
    "gear the wrong way": (gear_wrong_way, "gear multiplied", "plain"),
    "diameter": (diameter, "twice", "plain"),
    "half the rim": (half_the_rim, "half", "plain"),
    "angular velocity": (angular, "no radius", "plain"),
    "revolutions": (revolutions, "no 2 pi", "plain"),
    "dt on top": (dt_on_top, "multiplied by dt", "plain"),
    "5 ms": (dt_of_the_board, "fixed period", "plain"),
    "20 ms": (dt_of_20_ms, "fixed period", "subtle"),
    "smallest dt": (nominal_dt, "as if no row were lost", "subtle"),
    "average dt": (average_dt, "one dt for all", "plain"),
    "shifted dt": (shifted_dt, "dt of the neighbour", "subtle"),
    "dt as stamps": (dt_as_stamps, "np.gradient of steps", "subtle"),
    "milliseconds": (milliseconds, "1000 times", "plain"),
    "km/h": (kilometres_per_hour, "3.6 times", "plain"),
    "no sign": (speed_without_sign, "hypot", "plain"),
    "no reversing": (no_reversing, "0 when turning backwards", "subtle"),
    "whole dC": (whole_dc, "int(dE / Gear)", "subtle"),
    "two places": (two_places, "rounded", "plain"),
    "total counter": (total_counter, "differences of increments", "plain"),
    "average of neighbours": (long_average, "half a sample late", "subtle"),
    "first dt": (even_steps_only, "even steps only", "plain"),
    "in place": (scales_its_input, "changes its counts", "subtle"),
    "loop with one dt": (loop_forgets_dt_array, "dt array in each step, and no numbers", "plain"),
}
