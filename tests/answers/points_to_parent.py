"""Answers to points_to_parent(points, frame): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def rotation(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s], [s, c]])


def rows(points, frame):
    return np.asarray(points) @ rotation(frame[2]).T + np.asarray(frame)[:2]


def columns(points, frame):
    return (rotation(frame[2]) @ np.transpose(points) + np.reshape(frame[:2], (2, 1))).T


def loop(points, frame):
    moved = []
    for x, y in points:
        moved.append(
            (
                frame[0] + x * math.cos(frame[2]) - y * math.sin(frame[2]),
                frame[1] + x * math.sin(frame[2]) + y * math.cos(frame[2]),
            )
        )
    return moved


def complex_plane(points, frame):
    points = np.array(points, dtype=float)
    z = complex(frame[0], frame[1]) + (points[:, 0] + 1j * points[:, 1]) * cmath.exp(1j * frame[2])
    return np.column_stack([z.real, z.imag])


def homogeneous(points, frame):
    transform = np.eye(3)
    transform[:2, :2] = rotation(frame[2])
    transform[:2, 2] = frame[:2]
    ones = np.ones((len(points), 1))
    return (transform @ np.hstack([points, ones]).T)[:2].T


def single_precision(points, frame):
    points, frame = np.array(points, np.float32), np.array(frame, np.float32)
    return points @ rotation(frame[2]).T.astype(np.float32) + frame[:2]


def filled_in(points, frame):
    print(len(points), "points")
    warnings.warn("slow", stacklevel=1)
    moved = np.zeros((len(points), 2))
    for k, point in enumerate(points):
        moved[k] = rotation(frame[2]) @ point
        moved[k] += frame[:2]
    return moved


class Frame:
    def __call__(self, points, frame):
        return np.einsum("ij,kj->ki", rotation(frame[2]), np.asarray(points)) + np.asarray(frame)[None, :2]


RIGHT = {
    "rows": rows,
    "columns": columns,
    "loop, list of tuples": loop,
    "complex": complex_plane,
    "homogeneous": homogeneous,
    "float32": single_precision,
    "filled in, prints and warns": filled_in,
    "einsum": Frame(),
}


def at_r(points, frame):
    return np.asarray(points) @ rotation(frame[2]) + np.asarray(frame)[:2]


def r_at(points, frame):
    return rotation(frame[2]) @ np.asarray(points) + np.asarray(frame)[:2]


def transposed_out(points, frame):
    return columns(points, frame).T


def reshaped_instead_of_transposed(points, frame):
    return (rotation(frame[2]) @ np.reshape(points, (2, -1)) + np.reshape(frame[:2], (2, 1))).reshape(-1, 2)


def reshaped_at_the_end(points, frame):
    return (rotation(frame[2]) @ np.transpose(points) + np.reshape(frame[:2], (2, 1))).reshape(-1, 2)


def in_place(points, frame):
    for k in range(len(points)):
        x, y = points[k]
        points[k] = [
            frame[0] + x * np.cos(frame[2]) - y * np.sin(frame[2]),
            frame[1] + x * np.sin(frame[2]) + y * np.cos(frame[2]),
        ]
    return points


def seen_from_the_frame(points, frame):
    return (np.asarray(points) - np.asarray(frame)[:2]) @ rotation(frame[2])


def only_arrays(points, frame):
    return points.dot(rotation(frame[2]).T) + frame[:2]


def centre_of_the_points(points, frame):
    points = np.asarray(points, float)
    centre = points.mean(axis=0)
    return (points - centre) @ rotation(frame[2]).T + centre + np.asarray(frame)[:2]


def shifted_twice(points, frame):
    return rows(points, frame) + np.asarray(frame)[:2]


def origin_prepended(points, frame):
    return np.vstack([frame[:2], rows(points, frame)])


def mean_point(points, frame):
    return rows(points, frame).mean(axis=0)


def first_three(points, frame):
    return rows(points, frame)[:3]


def heading_turned_too_far(points, frame):
    return rows(points, [frame[0], frame[1], frame[2] + np.pi / 2])


def sorted_points(points, frame):
    return np.sort(rows(points, frame), axis=0)


def zeros_like(points, frame):
    moved = np.zeros_like(points)
    moved[:] = rows(points, frame)
    return moved


def appended_flat(points, frame):
    moved = []
    for x, y in rows(points, frame):
        moved += [x, y]
    return moved


def y_shift_from_heading(points, frame):
    return np.asarray(points) @ rotation(frame[2]).T + np.asarray(frame)[1:]


def nothing_for_one(points, frame):
    return rows(points, frame) if len(points) > 1 else np.asarray(points)


WRONG = {
    "points @ R": (at_r, "transposed rotation", "plain"),
    "R @ points": (r_at, "columns for vectors", "plain"),
    "(2, N)": (transposed_out, "not turned back to rows", "plain"),
    "reshape for transpose": (reshaped_instead_of_transposed, "coordinates mixed up", "subtle"),
    "reshape at the end": (reshaped_at_the_end, "coordinates mixed up", "subtle"),
    "in place": (in_place, "points overwritten", "plain"),
    "parent to frame": (seen_from_the_frame, "the way back", "plain"),
    "only arrays": (only_arrays, "a list has no dot", "plain"),
    "about the centre": (centre_of_the_points, "turned about the points' mean", "subtle"),
    "shifted twice": (shifted_twice, "origin added twice", "subtle"),
    "origin prepended": (origin_prepended, "one row too many", "plain"),
    "mean": (mean_point, "one point", "plain"),
    "three at most": (first_three, "written for three points", "plain"),
    "a quarter turn too far": (heading_turned_too_far, "theta from +y", "subtle"),
    "sorted": (sorted_points, "columns sorted", "subtle"),
    "zeros_like": (zeros_like, "whole numbers cut off", "plain"),
    "flat": (appended_flat, "one row of numbers", "plain"),
    "frame[1:]": (y_shift_from_heading, "shifted by (y, theta)", "subtle"),
    "one point forgotten": (nothing_for_one, "N = 1 left as it is", "subtle"),
}
