"""Answers to integrate_poses_trapezoid(t, velocity, yaw_rate, pose0): right ones, and wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def area(values, t):
    values = np.array(values, dtype=float)
    return np.append(0, np.cumsum((values[1:] + values[:-1]) / 2 * np.diff(t)))


def sums(t, velocity, yaw_rate, pose0):
    theta = pose0[2] + area(yaw_rate, t)
    return np.c_[pose0[0] + area(velocity * np.cos(theta), t), pose0[1] + area(velocity * np.sin(theta), t), theta]


def loop(t, velocity, yaw_rate, pose0):
    poses = np.zeros((len(t), 3))
    poses[0] = pose0
    for k in range(1, len(t)):
        dt = t[k] - t[k - 1]
        old = poses[k - 1, 2]
        new = old + (yaw_rate[k - 1] + yaw_rate[k]) / 2 * dt
        poses[k, 0] = poses[k - 1, 0] + (velocity[k - 1] * np.cos(old) + velocity[k] * np.cos(new)) / 2 * dt
        poses[k, 1] = poses[k - 1, 1] + (velocity[k - 1] * np.sin(old) + velocity[k] * np.sin(new)) / 2 * dt
        poses[k, 2] = new
    return poses


def prefixes(t, velocity, yaw_rate, pose0):
    theta = [pose0[2] + np.trapezoid(yaw_rate[: k + 1], t[: k + 1]) for k in range(len(t))]
    vx, vy = np.multiply(velocity, np.cos(theta)), np.multiply(velocity, np.sin(theta))
    x = [pose0[0] + np.trapezoid(vx[: k + 1], t[: k + 1]) for k in range(len(t))]
    y = [pose0[1] + np.trapezoid(vy[: k + 1], t[: k + 1]) for k in range(len(t))]
    return list(zip(x, y, theta, strict=True))


def complex_numbers(t, velocity, yaw_rate, pose0):
    print("N =", len(t))
    z, theta = complex(pose0[0], pose0[1]), float(pose0[2])
    path, speed = [(z.real, z.imag, theta)], cmath.rect(1, theta) * velocity[0]
    for k in range(1, len(t)):
        half = (t[k] - t[k - 1]) / 2
        theta += half * (yaw_rate[k] + yaw_rate[k - 1])
        before, speed = speed, cmath.rect(1, theta) * velocity[k]
        z += half * (before + speed)
        path.append((z.real, z.imag, theta))
    return path


def both_eulers(t, velocity, yaw_rate, pose0):
    def left(values):
        return np.append(0, np.cumsum(np.array(values, dtype=float)[:-1] * np.diff(t)))

    def right(values):
        return np.append(0, np.cumsum(np.array(values, dtype=float)[1:] * np.diff(t)))

    theta = pose0[2] + (left(yaw_rate) + right(yaw_rate)) / 2
    ways = [np.array(velocity) * np.cos(theta), np.array(velocity) * np.sin(theta)]
    return np.array([*(start + (left(w) + right(w)) / 2 for start, w in zip(pose0, ways, strict=False)), theta]).T


def weights(t, velocity, yaw_rate, pose0):
    n, h = len(t), np.diff(t) / 2
    W = np.tri(n, n - 1, -1) @ (np.diag(h) @ (np.eye(n - 1, n) + np.eye(n - 1, n, 1)))
    theta = W @ yaw_rate + pose0[2]
    return np.column_stack([W @ (velocity * np.cos(theta)) + pose0[0], W @ (velocity * np.sin(theta)) + pose0[1], theta])


def single(t, velocity, yaw_rate, pose0):
    warnings.warn("in single precision", stacklevel=2)
    return np.float32(sums(t, velocity, yaw_rate, pose0))


class Walk:
    def __call__(self, *log):
        return [tuple(map(float, row)) for row in loop(*log)]


RIGHT = {
    "sums": sums,
    "loop": loop,
    "prefixes, lists": prefixes,
    "complex, prints": complex_numbers,
    "mean of both Euler sums": both_eulers,
    "matrix of weights": weights,
    "float32, warns": single,
    "object": Walk(),
}


def euler(t, velocity, yaw_rate, pose0):
    dt = np.diff(t)
    theta = pose0[2] + np.append(0, np.cumsum(np.array(yaw_rate)[:-1] * dt))
    steps = np.array(velocity)[:-1] * dt
    x = pose0[0] + np.append(0, np.cumsum(steps * np.cos(theta[:-1])))
    return np.c_[x, pose0[1] + np.append(0, np.cumsum(steps * np.sin(theta[:-1]))), theta]


def averages_first(t, velocity, yaw_rate, pose0):
    """Neighbours averaged, then Euler's steps."""
    v, w = (np.array(values, dtype=float) for values in (velocity, yaw_rate))
    v, w = np.append((v[1:] + v[:-1]) / 2, 0), np.append((w[1:] + w[:-1]) / 2, 0)
    return euler(t, v, w, pose0)


def averages_and_middle(t, velocity, yaw_rate, pose0):
    theta, v = sums(t, velocity, yaw_rate, pose0)[:, 2], np.array(velocity, dtype=float)
    way = (v[1:] + v[:-1]) / 2 * np.diff(t)
    middle = (theta[1:] + theta[:-1]) / 2
    x = pose0[0] + np.append(0, np.cumsum(way * np.cos(middle)))
    return np.c_[x, pose0[1] + np.append(0, np.cumsum(way * np.sin(middle))), theta]


def averages_and_arc(t, velocity, yaw_rate, pose0):
    theta, v = sums(t, velocity, yaw_rate, pose0)[:, 2], np.array(velocity, dtype=float)
    turn = np.diff(theta)
    way, middle = (v[1:] + v[:-1]) / 2 * np.diff(t) * np.sinc(turn / 2 / np.pi), (theta[1:] + theta[:-1]) / 2
    x = pose0[0] + np.append(0, np.cumsum(way * np.cos(middle)))
    return np.c_[x, pose0[1] + np.append(0, np.cumsum(way * np.sin(middle))), theta]


def averages_and_mean_cosine(t, velocity, yaw_rate, pose0):
    theta, v = sums(t, velocity, yaw_rate, pose0)[:, 2], np.array(velocity, dtype=float)
    way = (v[1:] + v[:-1]) / 2 * np.diff(t)
    c, s = np.cos(theta), np.sin(theta)
    x = pose0[0] + np.append(0, np.cumsum(way * (c[1:] + c[:-1]) / 2))
    return np.c_[x, pose0[1] + np.append(0, np.cumsum(way * (s[1:] + s[:-1]) / 2)), theta]


def euler_heading(t, velocity, yaw_rate, pose0):
    theta = euler(t, velocity, yaw_rate, pose0)[:, 2]
    return np.c_[pose0[0] + area(velocity * np.cos(theta), t), pose0[1] + area(velocity * np.sin(theta), t), theta]


def euler_position(t, velocity, yaw_rate, pose0):
    theta, v, dt = sums(t, velocity, yaw_rate, pose0)[:, 2], np.array(velocity), np.diff(t)
    x = pose0[0] + np.append(0, np.cumsum(v[:-1] * np.cos(theta[:-1]) * dt))
    return np.c_[x, pose0[1] + np.append(0, np.cumsum(v[:-1] * np.sin(theta[:-1]) * dt)), theta]


def simpson_position(t, velocity, yaw_rate, pose0):
    theta, v, dt = sums(t, velocity, yaw_rate, pose0)[:, 2], np.array(velocity, dtype=float), np.diff(t)
    m, h = (v[1:] + v[:-1]) / 2, (theta[1:] + theta[:-1]) / 2

    def way(f):
        return np.append(0, np.cumsum((v[1:] * f(theta[1:]) + 4 * m * f(h) + v[:-1] * f(theta[:-1])) / 6 * dt))

    return np.c_[pose0[0] + way(np.cos), pose0[1] + way(np.sin), theta]


def mean_dt(t, velocity, yaw_rate, pose0):
    return sums(np.linspace(t[0], t[-1], len(t)), velocity, yaw_rate, pose0)


def next_dt(t, velocity, yaw_rate, pose0):
    dt = np.diff(t)
    return sums(np.append(0, np.cumsum(np.append(dt[1:], dt[-1:]))), velocity, yaw_rate, pose0)


def nominal_dt(t, velocity, yaw_rate, pose0):
    return sums(np.arange(len(t)) * 0.01, velocity, yaw_rate, pose0)


def no_half(t, velocity, yaw_rate, pose0):
    return sums(2 * np.array(t), velocity, yaw_rate, pose0)


def no_start(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, yaw_rate, (0, 0, 0))


def start_added(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, yaw_rate, (0, 0, 0)) + pose0


def sine_first(t, velocity, yaw_rate, pose0):
    theta = pose0[2] + area(yaw_rate, t)
    return np.c_[pose0[0] + area(velocity * np.sin(theta), t), pose0[1] + area(velocity * np.cos(theta), t), theta]


def one_cosine(t, velocity, yaw_rate, pose0):
    theta = pose0[2] + area(yaw_rate, t)
    way = area(velocity, t)
    return np.c_[pose0[0] + way * np.cos(theta), pose0[1] + way * np.sin(theta), theta]


def wrapped(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, yaw_rate, pose0) % [np.inf, np.inf, 2 * np.pi]


def wrapped_heading(t, velocity, yaw_rate, pose0):
    poses = sums(t, velocity, yaw_rate, pose0)
    poses[:, 2] = (poses[:, 2] + np.pi) % (2 * np.pi) - np.pi
    return poses


def shorter(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, yaw_rate, pose0)[1:]


def last(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, yaw_rate, pose0)[-1]


def transposed(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, yaw_rate, pose0).T


def not_the_last(t, velocity, yaw_rate, pose0):
    poses = np.zeros((len(t), 3))
    poses[: max(len(t) - 1, 1)] = sums(t, velocity, yaw_rate, pose0)[: max(len(t) - 1, 1)]
    return poses


def whole(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, yaw_rate, pose0).astype(np.array(pose0).dtype)


def float32_time(t, velocity, yaw_rate, pose0):
    return sums(np.array(t, dtype=np.float32), velocity, yaw_rate, pose0)


def absolute(t, velocity, yaw_rate, pose0):
    return sums(t, np.abs(velocity), yaw_rate, pose0)


def scaled_in_place(t, velocity, yaw_rate, pose0):
    poses = sums(t, velocity, yaw_rate, pose0)
    for k in range(len(velocity)):
        velocity[k] *= math.cos(poses[k, 2])
    return poses


def arrays_only(t, velocity, yaw_rate, pose0):
    dt = t[1:] - t[:-1]
    return sums(np.append(0, dt.cumsum()), velocity, yaw_rate, pose0)


def degrees(t, velocity, yaw_rate, pose0):
    return np.c_[sums(t, velocity, yaw_rate, pose0)[:, :2], np.rad2deg(sums(t, velocity, yaw_rate, pose0)[:, 2])]


def printed(t, velocity, yaw_rate, pose0):
    print(sums(t, velocity, yaw_rate, pose0))


WRONG = {
    "Euler": (euler, "Euler's rule", "plain"),
    "averages, then Euler": (averages_first, "mean V and omega, one cosine", "plain"),
    "averages, middle heading": (averages_and_middle, "mean V, cosine of the mean heading", "plain"),
    "averages, arc": (averages_and_arc, "mean V on an arc", "subtle"),
    "averages, mean cosine": (averages_and_mean_cosine, "product of the means", "plain"),
    "Euler's heading": (euler_heading, "theta by Euler", "plain"),
    "Euler's position": (euler_position, "x and y by Euler", "plain"),
    "Simpson's position": (simpson_position, "middles as well", "subtle"),
    "mean dt": (mean_dt, "linspace", "plain"),
    "next dt": (next_dt, "dt of the next step", "plain"),
    "10 ms": (nominal_dt, "nominal dt", "subtle"),
    "no half": (no_half, "twice", "plain"),
    "no start": (no_start, "pose0 ignored", "plain"),
    "start added": (start_added, "path not turned", "plain"),
    "sine first": (sine_first, "sin and cos", "plain"),
    "one cosine": (one_cosine, "cosine outside of the integral", "subtle"),
    "wrapped to 2 pi": (wrapped_heading, "+-pi", "plain"),
    "modulo": (wrapped, "0..2 pi, x and y spoilt", "subtle"),
    "N - 1": (shorter, "first missing", "plain"),
    "last": (last, "(3,)", "plain"),
    "transposed": (transposed, "(3, N)", "plain"),
    "last row 0": (not_the_last, "loop too short", "plain"),
    "whole": (whole, "type of pose0", "subtle"),
    "float32 time": (float32_time, "Unix seconds", "subtle"),
    "abs": (absolute, "reversing lost", "plain"),
    "velocity changed": (scaled_in_place, "*= on the argument", "plain"),
    "arrays only": (arrays_only, "lists fail", "plain"),
    "degrees": (degrees, "theta in degrees", "plain"),
    "printed": (printed, "None", "plain"),
}
