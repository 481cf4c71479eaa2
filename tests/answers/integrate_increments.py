"""Answers to integrate_increments(distance, dtheta, pose0): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings
from functools import reduce

import numpy as np


def loop(distance, dtheta, pose0):
    poses = np.zeros((len(distance) + 1, 3))
    poses[0] = pose0
    for k in range(len(distance)):
        x, y, theta = poses[k]
        middle = theta + dtheta[k] / 2
        poses[k + 1] = x + distance[k] * math.cos(middle), y + distance[k] * math.sin(middle), theta + dtheta[k]
    return poses


def sums(distance, dtheta, pose0, part=0.5):
    turns, ways = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = np.cumsum(np.append(pose0[2], turns))
    along = theta[:-1] + part * turns
    x = np.cumsum(np.append(pose0[0], ways * np.cos(along)))
    y = np.cumsum(np.append(pose0[1], ways * np.sin(along)))
    return np.column_stack([x, y, theta])


def mean_heading(distance, dtheta, pose0):
    theta = pose0[2] + np.concatenate([[0], np.cumsum(dtheta)])
    middle = (theta[1:] + theta[:-1]) / 2
    steps = np.c_[distance * np.cos(middle), distance * np.sin(middle)]
    return np.c_[np.vstack([pose0[:2], pose0[:2] + np.cumsum(steps, axis=0)]), theta]


def lists(distance, dtheta, pose0):
    x, y, theta = pose0
    path = [[x, y, theta]]
    for way, turn in zip(distance, dtheta, strict=True):
        theta += turn / 2
        x, y = x + way * math.cos(theta), y + way * math.sin(theta)
        theta += turn / 2
        path.append([x, y, theta])
    return path


def complex_numbers(distance, dtheta, pose0):
    print(len(distance), "increments")
    z, theta = [complex(*pose0[:2])], [pose0[2]]
    for way, turn in zip(distance, dtheta, strict=True):
        z.append(z[-1] + way * cmath.exp(1j * (theta[-1] + turn / 2)))
        theta.append(theta[-1] + turn)
    return np.array([np.real(z), np.imag(z), theta]).T


def recursion(distance, dtheta, pose0):
    if len(distance) == 0:
        return [tuple(pose0)]
    x, y, theta = pose0
    middle = theta + dtheta[0] / 2
    following = x + distance[0] * math.cos(middle), y + distance[0] * math.sin(middle), theta + dtheta[0]
    return [tuple(pose0), *recursion(distance[1:], dtheta[1:], following)]


def matrices(distance, dtheta, pose0):
    def pose(x, y, angle):
        return np.array([[np.cos(angle), -np.sin(angle), x], [np.sin(angle), np.cos(angle), y], [0, 0, 1]])

    frames = [pose(*pose0)]
    for way, turn in zip(distance, dtheta, strict=True):
        frames.append(frames[-1] @ pose(0, 0, turn / 2) @ pose(way, 0, turn / 2))
    theta = pose0[2] + np.append(0, np.cumsum(dtheta))
    return np.c_[[frame[:2, 2] for frame in frames], theta]


def reduced(distance, dtheta, pose0):
    warnings.warn("slow", stacklevel=2)

    def step(path, increment):
        (way, turn), (x, y, theta) = increment, path[-1]
        return [*path, (x + way * np.cos(theta + turn / 2), y + way * np.sin(theta + turn / 2), theta + turn)]

    return np.array(reduce(step, zip(distance, dtheta, strict=True), [tuple(pose0)]), dtype=np.float32)


class Odometer:
    def __call__(self, distance, dtheta, pose0):
        return sums(distance, dtheta, pose0)


RIGHT = {
    "loop": loop,
    "sums": sums,
    "mean of the headings": mean_heading,
    "two half turns, lists": lists,
    "complex, prints": complex_numbers,
    "recursion": recursion,
    "matrices": matrices,
    "reduce, float32, warns": reduced,
    "object": Odometer(),
}


def euler(distance, dtheta, pose0):
    return sums(distance, dtheta, pose0, 0)


def new_heading(distance, dtheta, pose0):
    return sums(distance, dtheta, pose0, 1)


def beyond(distance, dtheta, pose0):
    return sums(distance, dtheta, pose0, 1.5)


def third(distance, dtheta, pose0):
    return sums(distance, dtheta, pose0, 1 / 3)


def mean_of_cosines(distance, dtheta, pose0):
    before, after = euler(distance, dtheta, pose0), new_heading(distance, dtheta, pose0)
    return (before + after) / 2


def arc(distance, dtheta, pose0):
    chord = np.array(distance) * np.sinc(np.array(dtheta) / 2 / np.pi)
    return sums(chord, dtheta, pose0)


def averaged(distance, dtheta, pose0):
    d, w = np.array(distance, dtype=float), np.array(dtheta, dtype=float)
    return sums((d + np.append(0, d[:-1])) / 2, (w + np.append(0, w[:-1])) / 2, pose0)


def averaged_backwards(distance, dtheta, pose0):
    d, w = np.array(distance, dtype=float), np.array(dtheta, dtype=float)
    return sums((d + np.append(d[0], d[:-1])) / 2, (w + np.append(w[0], w[:-1])) / 2, pose0)


def as_samples(distance, dtheta, pose0):
    return loop(distance[:-1], dtheta[:-1], pose0)


def totals(distance, dtheta, pose0):
    return sums(np.diff(distance, prepend=0), np.diff(dtheta, prepend=0), pose0)


def cumulated_first(distance, dtheta, pose0):
    return sums(np.cumsum(distance), dtheta, pose0)


def half_of_all(distance, dtheta, pose0):
    return sums(distance, np.array(dtheta) / 2, pose0, 1)


def half_of_the_first_turn(distance, dtheta, pose0):
    turns = np.array(dtheta, dtype=float)
    poses = sums(distance, turns, pose0, 0)
    x = pose0[0] + np.append(0, np.cumsum(distance * np.cos(poses[:-1, 2] + turns[0] / 2)))
    y = pose0[1] + np.append(0, np.cumsum(distance * np.sin(poses[:-1, 2] + turns[0] / 2)))
    return np.c_[x, y, poses[:, 2]]


def no_start(distance, dtheta, pose0):
    return sums(distance, dtheta, (0.0, 0.0, 0.0))


def start_added(distance, dtheta, pose0):
    return no_start(distance, dtheta, pose0) + pose0


def sine_first(distance, dtheta, pose0):
    poses = sums(distance, dtheta, pose0)
    steps = np.diff(poses[:, :2], axis=0)[:, ::-1]
    return np.c_[np.vstack([pose0[:2], pose0[:2] + np.cumsum(steps, axis=0)]), poses[:, 2]]


def wrapped(distance, dtheta, pose0):
    poses = loop(distance, dtheta, pose0)
    poses[:, 2] = np.arctan2(np.sin(poses[:, 2]), np.cos(poses[:, 2]))
    return poses


def n_rows(distance, dtheta, pose0):
    return loop(distance, dtheta, pose0)[1:]


def without_the_last(distance, dtheta, pose0):
    return loop(distance, dtheta, pose0)[:-1]


def end(distance, dtheta, pose0):
    return loop(distance, dtheta, pose0)[-1]


def transposed(distance, dtheta, pose0):
    return loop(distance, dtheta, pose0).T


def reversing_lost(distance, dtheta, pose0):
    return sums(np.abs(distance), dtheta, pose0)


def clockwise(distance, dtheta, pose0):
    return sums(distance, -np.array(dtheta), pose0)


def whole(distance, dtheta, pose0):
    poses = np.array([pose0] * (len(distance) + 1))
    for k in range(len(distance)):
        x, y, theta = poses[k]
        m = theta + dtheta[k] / 2
        poses[k + 1] = [x + distance[k] * np.cos(m), y + distance[k] * np.sin(m), theta + dtheta[k]]
    return poses


def floor_half(distance, dtheta, pose0):
    theta = pose0[2] + np.append(0, np.cumsum(dtheta))
    m = theta[:-1] + np.array(dtheta) // 2
    x, y = np.cumsum(np.append(pose0[0], distance * np.cos(m))), np.cumsum(np.append(pose0[1], distance * np.sin(m)))
    return np.c_[x, y, theta]


def in_place(distance, dtheta, pose0):
    poses = loop(distance, dtheta, pose0)
    pose0[:] = poses[-1]
    return poses


def arrays_only(distance, dtheta, pose0):
    middle = pose0[2] + np.cumsum(dtheta) - dtheta / 2
    theta = np.append(pose0[2], pose0[2] + np.cumsum(dtheta))
    x = np.append(pose0[0], pose0[0] + np.cumsum(distance * np.cos(middle)))
    return np.c_[x, np.append(pose0[1], pose0[1] + np.cumsum(distance * np.sin(middle))), theta]


def degrees(distance, dtheta, pose0):
    return sums(distance, np.deg2rad(dtheta), pose0)


def printed(distance, dtheta, pose0):
    print(loop(distance, dtheta, pose0))


WRONG = {
    "Euler": (euler, "old heading", "plain"),
    "new heading": (new_heading, "theta + dtheta", "plain"),
    "one and a half": (beyond, "new heading + dtheta/2", "plain"),
    "a third": (third, "theta + dtheta/3", "subtle"),
    "mean of the cosines": (mean_of_cosines, "trapezoid", "plain"),
    "arc": (arc, "exact", "plain"),
    "averaged": (averaged, "neighbours, 0 first", "plain"),
    "averaged backwards": (averaged_backwards, "neighbours", "subtle"),
    "as samples": (as_samples, "N rows", "plain"),
    "totals": (totals, "differences again", "plain"),
    "cumulated": (cumulated_first, "distance since the start", "subtle"),
    "half of all": (half_of_all, "theta + dtheta/2 kept", "plain"),
    "first turn": (half_of_the_first_turn, "dtheta[0]/2 for all", "subtle"),
    "no start": (no_start, "pose0 ignored", "plain"),
    "start added": (start_added, "path not turned", "plain"),
    "sine first": (sine_first, "sin and cos", "plain"),
    "wrapped": (wrapped, "+-pi", "plain"),
    "N rows": (n_rows, "first missing", "plain"),
    "no last": (without_the_last, "last missing", "plain"),
    "end": (end, "(3,)", "plain"),
    "transposed": (transposed, "(3, N + 1)", "plain"),
    "abs": (reversing_lost, "reversing lost", "plain"),
    "clockwise": (clockwise, "turn subtracted", "plain"),
    "whole": (whole, "whole numbers", "subtle"),
    "// 2": (floor_half, "half turn cut", "subtle"),
    "pose0 changed": (in_place, "changes its input", "plain"),
    "arrays only": (arrays_only, "lists fail", "plain"),
    "degrees": (degrees, "dtheta taken for degrees", "subtle"),
    "printed": (printed, "None", "plain"),
}
