"""Answers to integrate_poses_euler(t, velocity, yaw_rate, pose0): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings
from functools import reduce

import numpy as np


def loop(t, velocity, yaw_rate, pose0):
    poses = np.zeros((len(t), 3))
    poses[0] = pose0
    for k in range(len(t) - 1):
        dt = t[k + 1] - t[k]
        x, y, theta = poses[k]
        poses[k + 1] = x + velocity[k] * math.cos(theta) * dt, y + velocity[k] * math.sin(theta) * dt, theta + yaw_rate[k] * dt
    return poses


def cumulated(values, dt, start):
    return start + np.append(0.0, np.cumsum(np.asarray(values)[:-1] * dt))


def sums(t, velocity, yaw_rate, pose0):
    dt = np.diff(t)
    theta = cumulated(yaw_rate, dt, pose0[2])
    x = cumulated(velocity * np.cos(theta), dt, pose0[0])
    y = cumulated(velocity * np.sin(theta), dt, pose0[1])
    return np.c_[x, y, theta]


def lists(t, velocity, yaw_rate, pose0):
    x, y, theta = pose0
    path = [(x, y, theta)]
    for v, w, start, end in zip(velocity, yaw_rate, t, t[1:], strict=False):
        x += v * math.cos(theta) * (end - start)
        y += v * math.sin(theta) * (end - start)
        theta += w * (end - start)
        path.append((x, y, theta))
    return path


def matrix(t, velocity, yaw_rate, pose0):
    add = np.tri(len(t), len(t) - 1, -1) * np.diff(t)
    theta = pose0[2] + add @ yaw_rate[:-1]
    way = np.array(velocity)[:-1, None] * np.c_[np.cos(theta), np.sin(theta)][:-1]
    return np.hstack([pose0[:2] + add @ way, theta[:, None]])


def recursion(t, velocity, yaw_rate, pose0):
    if len(t) == 1:
        return [list(pose0)]
    *first, last = recursion(t[:-1], velocity[:-1], yaw_rate[:-1], pose0)
    dt, k = t[-1] - t[-2], len(t) - 2
    x, y, theta = last
    new = [x + velocity[k] * np.cos(theta) * dt, y + velocity[k] * np.sin(theta) * dt, theta + yaw_rate[k] * dt]
    return [*first, last, new]


def single(t, velocity, yaw_rate, pose0):
    warnings.warn("in single precision", stacklevel=2)
    return sums(t, np.array(velocity), yaw_rate, pose0).astype(np.float32)


def reduced(t, velocity, yaw_rate, pose0):
    def step(path, k):
        x, y, theta = path[-1]
        z = complex(x, y) + cmath.rect(velocity[k] * (t[k + 1] - t[k]), theta)
        return [*path, (z.real, z.imag, theta + yaw_rate[k] * (t[k + 1] - t[k]))]

    print("N =", len(t))
    return np.array(reduce(step, range(len(t) - 1), [tuple(pose0)]))


class Robot:
    def __call__(self, t, velocity, yaw_rate, pose0):
        self.pose, self.path = np.array(pose0, dtype=float), []
        for v, w, dt in zip(velocity, yaw_rate, [*np.diff(t), 0.0], strict=True):
            self.path.append(self.pose)
            self.pose = self.pose + dt * np.array([v * np.cos(self.pose[2]), v * np.sin(self.pose[2]), w])
        return np.array(self.path)


RIGHT = {
    "loop": loop,
    "sums": sums,
    "lists": lists,
    "triangular matrix": matrix,
    "recursion": recursion,
    "float32, warns": single,
    "reduce, complex, prints": reduced,
    "robot object": Robot(),
}


def shifted(t, velocity, yaw_rate, pose0):
    return sums(t, np.append(velocity[1:], 0), np.append(yaw_rate[1:], 0), pose0)


def new_heading(t, velocity, yaw_rate, pose0):
    poses = np.zeros((len(t), 3))
    poses[0] = pose0
    for k in range(len(t) - 1):
        dt = t[k + 1] - t[k]
        theta = poses[k, 2] + yaw_rate[k] * dt
        way = velocity[k] * dt
        poses[k + 1] = poses[k, 0] + way * np.cos(theta), poses[k, 1] + way * np.sin(theta), theta
    return poses


def x_first_then_heading_then_y(t, velocity, yaw_rate, pose0):
    x, y, theta = pose0
    path = [[x, y, theta]]
    for k in range(len(t) - 1):
        dt = t[k + 1] - t[k]
        x = x + velocity[k] * np.cos(theta) * dt
        theta = theta + yaw_rate[k] * dt
        y = y + velocity[k] * np.sin(theta) * dt
        path.append([x, y, theta])
    return path


def trapezoid(t, velocity, yaw_rate, pose0):
    def area(values):
        values = np.array(values, dtype=float)
        return np.append(0, np.cumsum((values[1:] + values[:-1]) / 2 * np.diff(t)))

    theta = pose0[2] + area(yaw_rate)
    return np.c_[pose0[0] + area(velocity * np.cos(theta)), pose0[1] + area(velocity * np.sin(theta)), theta]


def mixed(t, velocity, yaw_rate, pose0):
    poses = sums(t, velocity, yaw_rate, pose0)
    poses[:, 2] = trapezoid(t, velocity, yaw_rate, pose0)[:, 2]
    return poses


def dt_of_the_next(t, velocity, yaw_rate, pose0):
    h = np.diff(t, append=t[-1] + (t[-1] - t[-2] if len(t) > 1 else 0))
    times = t[0] + np.append(0, np.cumsum(h[1:]))
    return sums(times, velocity, yaw_rate, pose0)


def dt_prepended(t, velocity, yaw_rate, pose0):
    """The dt that ends at each sample, with the values of that sample."""
    h = np.diff(t, prepend=t[0])
    theta = pose0[2] + np.cumsum(yaw_rate * h)
    x = pose0[0] + np.cumsum(velocity * np.cos(theta) * h)
    y = pose0[1] + np.cumsum(velocity * np.sin(theta) * h)
    return np.c_[x, y, theta]


def mean_dt(t, velocity, yaw_rate, pose0):
    return sums(np.linspace(t[0], t[-1], len(t)), velocity, yaw_rate, pose0)


def median_dt(t, velocity, yaw_rate, pose0):
    return sums(np.arange(len(t)) * (np.median(np.diff(t)) if len(t) > 1 else 0), velocity, yaw_rate, pose0)


def first_dt(t, velocity, yaw_rate, pose0):
    return sums(np.arange(len(t)) * (t[1] - t[0] if len(t) > 1 else 0), velocity, yaw_rate, pose0)


def time_as_dt(t, velocity, yaw_rate, pose0):
    return loop(np.cumsum(t), velocity, yaw_rate, pose0)


def from_time_zero(t, velocity, yaw_rate, pose0):
    return sums(np.append(0, t), np.append(velocity[0], velocity), np.append(yaw_rate[0], yaw_rate), pose0)[1:]


def zeros_first(t, velocity, yaw_rate, pose0):
    poses = loop(t, velocity, yaw_rate, (0, 0, 0))
    return poses


def offset_afterwards(t, velocity, yaw_rate, pose0):
    return loop(t, velocity, yaw_rate, (0, 0, 0)) + np.array(pose0)


def exchanged(t, velocity, yaw_rate, pose0):
    poses = loop(t, velocity, yaw_rate, (pose0[1], pose0[0], pose0[2]))
    return poses[:, [1, 0, 2]]


def degrees(t, velocity, yaw_rate, pose0):
    return sums(t, velocity, np.deg2rad(yaw_rate), pose0)


def wrapped(t, velocity, yaw_rate, pose0):
    poses = loop(t, velocity, yaw_rate, pose0)
    poses[:, 2] = np.arctan2(np.sin(poses[:, 2]), np.cos(poses[:, 2]))
    return poses


def one_more(t, velocity, yaw_rate, pose0):
    h = np.append(np.diff(t), 0.0)
    return sums(np.append(0, np.cumsum(h)), np.append(velocity, 0), np.append(yaw_rate, 0), pose0)


def one_less(t, velocity, yaw_rate, pose0):
    return loop(t, velocity, yaw_rate, pose0)[1:]


def transposed(t, velocity, yaw_rate, pose0):
    return loop(t, velocity, yaw_rate, pose0).T


def same_row(t, velocity, yaw_rate, pose0):
    pose, path = np.array(pose0, dtype=float), []
    for k in range(len(t)):
        path.append(pose)
        if k + 1 < len(t):
            pose += (t[k + 1] - t[k]) * np.array([velocity[k] * np.cos(pose[2]), velocity[k] * np.sin(pose[2]), yaw_rate[k]])
    return np.array(path)


def start_changed(t, velocity, yaw_rate, pose0):
    path = [list(pose0)]
    for k in range(len(t) - 1):
        dt, theta = t[k + 1] - t[k], pose0[2]
        pose0[0] += velocity[k] * np.cos(theta) * dt
        pose0[1] += velocity[k] * np.sin(theta) * dt
        pose0[2] += yaw_rate[k] * dt
        path.append(list(pose0))
    return path


def whole(t, velocity, yaw_rate, pose0):
    poses = np.tile(np.array(pose0), (len(t), 1))
    for k in range(len(t) - 1):
        dt, (x, y, theta) = t[k + 1] - t[k], poses[k]
        poses[k + 1] = x + velocity[k] * np.cos(theta) * dt, y + velocity[k] * np.sin(theta) * dt, theta + yaw_rate[k] * dt
    return poses


def float32_time(t, velocity, yaw_rate, pose0):
    return sums(np.array(t, dtype=np.float32), velocity, yaw_rate, pose0)


def arrays_only(t, velocity, yaw_rate, pose0):
    dt = t[1:] - t[:-1]
    return sums(np.append(0, np.cumsum(dt)), velocity, yaw_rate, pose0)


def end(t, velocity, yaw_rate, pose0):
    return loop(t, velocity, yaw_rate, pose0)[-1]


def no_reversing(t, velocity, yaw_rate, pose0):
    return sums(t, np.abs(velocity), yaw_rate, pose0)


def three_decimals(t, velocity, yaw_rate, pose0):
    return loop(t, velocity, yaw_rate, pose0).round(4)


def printed(t, velocity, yaw_rate, pose0):
    print(loop(t, velocity, yaw_rate, pose0))


WRONG = {
    "next sample": (shifted, "values at k + 1", "plain"),
    "new heading": (new_heading, "theta first", "plain"),
    "x, theta, y": (x_first_then_heading_then_y, "theta between", "plain"),
    "trapezoid": (trapezoid, "next exercise", "plain"),
    "trapezoid yaw returned": (mixed, "Euler's x and y, trapezoids' theta", "subtle"),
    "next dt": (dt_of_the_next, "dt of the next step", "subtle"),
    "dt prepended": (dt_prepended, "all at k + 1", "plain"),
    "mean dt": (mean_dt, "linspace", "plain"),
    "median dt": (median_dt, "median", "subtle"),
    "first dt": (first_dt, "t[1] - t[0]", "plain"),
    "time as dt": (time_as_dt, "t[k + 1] for dt", "plain"),
    "from time 0": (from_time_zero, "a step before t[0]", "subtle"),
    "from zero": (zeros_first, "pose0 ignored", "plain"),
    "offset afterwards": (offset_afterwards, "path not turned by the first heading", "plain"),
    "x and y exchanged": (exchanged, "sin and cos", "plain"),
    "degrees": (degrees, "yaw rate taken for deg/s", "subtle"),
    "wrapped": (wrapped, "+-pi", "plain"),
    "N + 1 rows": (one_more, "one too many", "plain"),
    "N - 1 rows": (one_less, "first missing", "plain"),
    "transposed": (transposed, "(3, N)", "plain"),
    "same row": (same_row, "views", "plain"),
    "pose0 changed": (start_changed, "+= on the argument", "plain"),
    "whole": (whole, "array of whole numbers", "subtle"),
    "float32 time": (float32_time, "Unix seconds", "subtle"),
    "arrays only": (arrays_only, "lists fail", "plain"),
    "end": (end, "(3,)", "plain"),
    "abs": (no_reversing, "reversing lost", "plain"),
    "four decimals": (three_decimals, "rounded", "subtle"),
    "printed": (printed, "None", "plain"),
}
