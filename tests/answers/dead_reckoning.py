"""Answers to dead_reckoning(velocity, yaw_rate, dt, pose0): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings
from functools import reduce

import numpy as np


def steps(velocity, dt):
    return np.ones(len(velocity)) * dt


def loop(velocity, yaw_rate, dt, pose0):
    h = steps(velocity, dt)
    poses = np.zeros((len(velocity) + 1, 3))
    poses[0] = pose0
    for k in range(len(velocity)):
        theta = poses[k, 2]
        poses[k + 1] = poses[k] + np.array([velocity[k] * np.cos(theta), velocity[k] * np.sin(theta), yaw_rate[k]]) * h[k]
    return poses


def sums(velocity, yaw_rate, dt, pose0):
    theta = np.cumsum(np.concatenate(([pose0[2]], np.multiply(yaw_rate, dt))))
    way = np.multiply(velocity, dt)
    x = np.cumsum(np.concatenate(([pose0[0]], way * np.cos(theta[:-1]))))
    y = np.cumsum(np.concatenate(([pose0[1]], way * np.sin(theta[:-1]))))
    return np.vstack((x, y, theta)).T


def triangular_matrix(velocity, yaw_rate, dt, pose0):
    h, n = steps(velocity, dt), len(velocity)
    add = np.tri(n + 1, n, -1)
    theta = pose0[2] + add @ (np.array(yaw_rate) * h)
    way = np.array(velocity) * h
    return np.c_[pose0[0] + add @ (way * np.cos(theta[:-1])), pose0[1] + add @ (way * np.sin(theta[:-1])), theta]


def plain_python(velocity, yaw_rate, dt, pose0):
    try:
        periods = list(dt)
    except TypeError:
        periods = [dt] * len(velocity)
    path = [list(map(float, pose0))]
    for v, w, h in zip(velocity, yaw_rate, periods, strict=True):
        x, y, theta = path[-1]
        path.append([x + v * h * math.cos(theta), y + v * h * math.sin(theta), theta + w * h])
    return path


def generator(velocity, yaw_rate, dt, pose0):
    def walk():
        z, theta = complex(pose0[0], pose0[1]), pose0[2]
        yield z.real, z.imag, theta
        for v, w, h in zip(velocity, yaw_rate, steps(velocity, dt), strict=True):
            z, theta = z + cmath.rect(1, theta) * v * h, theta + w * h
            yield z.real, z.imag, theta

    print("walking")
    return tuple(walk())


def recursion(velocity, yaw_rate, dt, pose0):
    if len(velocity) == 0:
        return [list(pose0)]
    h = steps(velocity, dt)
    x, y, theta = pose0
    following = [x + velocity[0] * math.cos(theta) * h[0], y + velocity[0] * math.sin(theta) * h[0], theta + yaw_rate[0] * h[0]]
    return [list(pose0), *recursion(velocity[1:], yaw_rate[1:], h[1:], following)]


def reduced(velocity, yaw_rate, dt, pose0):
    def append(path, step):
        v, w, h = step
        return [*path, path[-1] + h * np.array([v * np.cos(path[-1][2]), v * np.sin(path[-1][2]), w])]

    warnings.warn("slow", stacklevel=2)
    rows = np.broadcast_arrays(velocity, yaw_rate, dt)
    return np.array(reduce(append, np.transpose(rows), [np.array(pose0, dtype=float)]), dtype=np.float32)


class Robot:
    def __init__(self):
        self.path = []

    def __call__(self, velocity, yaw_rate, dt, pose0):
        self.path = [tuple(pose0)]
        for v, w, h in np.broadcast(velocity, yaw_rate, dt):
            self.step(v, w, h)
        return np.array(self.path)

    def step(self, v, w, h):
        x, y, theta = self.path[-1]
        self.path.append((x + v * np.cos(theta) * h, y + v * np.sin(theta) * h, theta + w * h))


RIGHT = {
    "loop": loop,
    "sums": sums,
    "triangular matrix": triangular_matrix,
    "plain Python, lists": plain_python,
    "generator, complex, prints": generator,
    "recursion": recursion,
    "reduce, float32, warns": reduced,
    "robot object": Robot(),
}


def midpoint(velocity, yaw_rate, dt, pose0):
    h, path = steps(velocity, dt), [np.array(pose0, dtype=float)]
    for v, w, t in zip(velocity, yaw_rate, h, strict=True):
        way = path[-1][2] + w * t / 2
        path.append(path[-1] + t * np.array([v * np.cos(way), v * np.sin(way), w]))
    return np.array(path)


def heading_halved_in_time(velocity, yaw_rate, dt, pose0):
    poses = sums(velocity, yaw_rate, dt, pose0)
    return np.c_[poses[:, :2], (poses[:, 2] + pose0[2]) / 2]


def start_twice(velocity, yaw_rate, dt, pose0):
    poses = sums(velocity, yaw_rate, dt, pose0)
    return np.vstack([pose0, poses[:-1]])


def backwards_in_time(velocity, yaw_rate, dt, pose0):
    return sums(velocity[::-1], yaw_rate[::-1], dt, pose0)


def rows_reversed(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, dt, pose0)[::-1]


def dt_of_the_next_step(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, np.roll(steps(velocity, dt), -1), pose0)


def dt_of_the_step_before(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, np.roll(steps(velocity, dt), 1), pose0)


def differences_of_dt(velocity, yaw_rate, dt, pose0):
    h = steps(velocity, dt)
    return sums(velocity, yaw_rate, np.diff(h, prepend=0), pose0)


def total_time_in_every_step(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, np.sum(dt), pose0)


def sorted_steps(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, np.sort(steps(velocity, dt)), pose0)


def speed_one_late(velocity, yaw_rate, dt, pose0):
    late = np.concatenate(([0], np.array(velocity)[:-1]))
    return sums(late, yaw_rate, dt, pose0)


def yaw_rate_one_late(velocity, yaw_rate, dt, pose0):
    late = np.concatenate(([0], np.array(yaw_rate)[:-1]))
    return sums(velocity, late, dt, pose0)


def drops_rests(velocity, yaw_rate, dt, pose0):
    v = np.where(np.array(velocity) > 0, velocity, 0)
    return sums(v, yaw_rate, dt, pose0)


def mean_speed(velocity, yaw_rate, dt, pose0):
    return sums(np.full(len(velocity), np.mean(velocity)), yaw_rate, dt, pose0)


def wrapped_when_used(velocity, yaw_rate, dt, pose0):
    poses = sums(velocity, yaw_rate, dt, pose0)
    poses[:, 2] = np.arctan2(np.sin(poses[:, 2]), np.cos(poses[:, 2]))
    return poses


def unwrapped_from_wrapped_start(velocity, yaw_rate, dt, pose0):
    poses = sums(velocity, yaw_rate, dt, pose0)
    start = math.atan2(math.sin(pose0[2]), math.cos(pose0[2]))
    poses[:, 2] = np.unwrap(np.arctan2(np.sin(poses[:, 2]), np.cos(poses[:, 2])) + 0 * start) % (2 * np.pi)
    return poses


def start_changed(velocity, yaw_rate, dt, pose0):
    path = [np.array(pose0, dtype=float)]
    for v, w, h in zip(velocity, yaw_rate, steps(velocity, dt), strict=True):
        pose0[2] += w * h
        path.append(np.array([path[-1][0] + v * np.cos(path[-1][2]) * h, path[-1][1] + v * np.sin(path[-1][2]) * h, pose0[2]]))
    return np.array(path)


def speeds_changed(velocity, yaw_rate, dt, pose0):
    velocity *= np.array(dt)
    return sums(velocity, np.multiply(yaw_rate, dt), 1.0, pose0)


def views_kept(velocity, yaw_rate, dt, pose0):
    poses = [np.array(pose0, dtype=float)]
    for v, w, h in zip(velocity, yaw_rate, steps(velocity, dt), strict=True):
        here = poses[-1]
        here += h * np.array([v * np.cos(here[2]), v * np.sin(here[2]), w])
        poses.append(here)
    return np.array(poses)


def end_and_start(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, dt, pose0)[[0, -1]]


def flat(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, dt, pose0).ravel()


def one_too_many(velocity, yaw_rate, dt, pose0):
    poses = sums(velocity, yaw_rate, dt, pose0)
    return np.vstack([poses, poses[-1]])


def mapping(velocity, yaw_rate, dt, pose0):
    x, y, theta = sums(velocity, yaw_rate, dt, pose0).T
    return {"x": x, "y": y, "theta": theta}


def four_decimals(velocity, yaw_rate, dt, pose0):
    return np.round(sums(velocity, yaw_rate, dt, pose0), 4)


def lists_multiplied(velocity, yaw_rate, dt, pose0):
    poses = [pose0]
    for k in range(velocity.shape[0]):
        x, y, theta = poses[-1]
        h = dt if np.ndim(dt) == 0 else dt[k]
        poses.append([x + velocity[k] * np.cos(theta) * h, y + velocity[k] * np.sin(theta) * h, theta + yaw_rate[k] * h])
    return np.array(poses)


def only_arrays_of_dt(velocity, yaw_rate, dt, pose0):
    return sums(velocity, yaw_rate, [dt[k] for k in range(len(velocity))], pose0)


def trapezoid(velocity, yaw_rate, dt, pose0):
    poses = sums(velocity, yaw_rate, dt, pose0)
    way, theta = np.multiply(velocity, dt), poses[:, 2]
    for column, function in enumerate((np.cos, np.sin)):
        poses[1:, column] = pose0[column] + np.cumsum(way * (function(theta[1:]) + function(theta[:-1])) / 2)
    return poses


def quarter_turn_missing(velocity, yaw_rate, dt, pose0):
    x, y, theta = pose0
    poses = sums(velocity, yaw_rate, dt, (x, y, theta - np.pi / 2))
    poses[:, 2] += np.pi / 2
    return poses


WRONG = {
    "midpoint": (midpoint, "theta + omega dt/2", "plain"),
    "headings halved": (heading_halved_in_time, "mean of first and present heading", "subtle"),
    "start twice": (start_twice, "the last pose is missing", "subtle"),
    "samples reversed": (backwards_in_time, "last sample first", "subtle"),
    "rows reversed": (rows_reversed, "end first", "subtle"),
    "next dt": (dt_of_the_next_step, "dt_(k+1)", "subtle"),
    "dt before": (dt_of_the_step_before, "dt_(k-1)", "subtle"),
    "diff of dt": (differences_of_dt, "dt taken for time stamps", "subtle"),
    "whole time": (total_time_in_every_step, "sum of dt in every step", "subtle"),
    "sorted dt": (sorted_steps, "order of dt lost", "subtle"),
    "speed one late": (speed_one_late, "v_(k-1), 0 first", "subtle"),
    "yaw rate one late": (yaw_rate_one_late, "omega_(k-1), 0 first", "subtle"),
    "no reversing": (drops_rests, "negative speeds become 0", "subtle"),
    "mean speed": (mean_speed, "one speed for all steps", "subtle"),
    "wrapped": (wrapped_when_used, "theta within +-pi", "plain"),
    "modulo after unwrap": (unwrapped_from_wrapped_start, "theta within one turn", "plain"),
    "changes pose0": (start_changed, "+= on the argument", "plain"),
    "changes velocity": (speeds_changed, "*= on the argument", "plain"),
    "the same array": (views_kept, "all rows the last", "plain"),
    "start and end": (end_and_start, "(2, 3)", "plain"),
    "flat": (flat, "(3 N + 3,)", "plain"),
    "one row too many": (one_too_many, "N + 2 rows", "plain"),
    "dict": (mapping, "a dict", "plain"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "shape of a list": (lists_multiplied, "a list has no shape", "plain"),
    "dt without index": (only_arrays_of_dt, "a number has no index", "plain"),
    "trapezoid": (trapezoid, "mean of the cosines", "plain"),
    "quarter turn": (quarter_turn_missing, "heading from +y", "subtle"),
}
