"""Answers to express_in(pose, frame): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def transform(p):
    c, s = np.cos(p[2]), np.sin(p[2])
    return np.array([[c, -s, p[0]], [s, c, p[1]], [0.0, 0.0, 1.0]])


def composed(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def inverted(a):
    c, s = math.cos(a[2]), math.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]])


def formula(pose, frame):
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([c * dx + s * dy, -s * dx + c * dy, pose[2] - frame[2]])


def by_compose(pose, frame):
    return composed(inverted(frame), pose)


def solved(pose, frame):
    m = np.linalg.solve(transform(frame), transform(pose))
    return m[0, 2], m[1, 2], math.atan2(m[1, 0], m[0, 0])


def quotient(pose, frame):
    z = (complex(pose[0], pose[1]) - complex(frame[0], frame[1])) / cmath.exp(1j * frame[2])
    return [z.real, z.imag, (pose[2] - frame[2]) % math.tau]


def rows(pose, frame):
    difference = np.subtract(pose, frame, dtype=float)
    difference[:2] = difference[:2] @ transform(frame)[:2, :2]
    return difference


def single_precision(pose, frame):
    return formula(np.array(pose, np.float32), np.array(frame, np.float32)).astype(np.float32)


def range_and_bearing(pose, frame):
    print("seen from", frame)
    warnings.warn("slow", stacklevel=1)
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    distance, bearing = math.hypot(dx, dy), math.atan2(dy, dx) - frame[2]
    return distance * math.cos(bearing), distance * math.sin(bearing), pose[2] - frame[2]


class Observer:
    def __call__(self, pose, frame):
        ahead = (math.cos(frame[2]), math.sin(frame[2]))
        left = (-ahead[1], ahead[0])
        arrow = (pose[0] - frame[0], pose[1] - frame[1])
        return (*(sum(map(float.__mul__, axis, map(float, arrow))) for axis in (ahead, left)), pose[2] - frame[2])


RIGHT = {
    "formula": formula,
    "invert and compose": by_compose,
    "solved, atan2, tuple": solved,
    "complex quotient, list, 0 to 2 pi": quotient,
    "rows": rows,
    "float32": single_precision,
    "range and bearing, prints and warns": range_and_bearing,
    "projections": Observer(),
}


def forward(pose, frame):
    return composed(frame, pose)


def inverse_behind(pose, frame):
    return composed(pose, inverted(frame))


def inverse_of_the_pose(pose, frame):
    return composed(inverted(pose), frame)


def negated_frame(pose, frame):
    return composed(-np.asarray(frame), pose)


def difference_turned_forward(pose, frame):
    difference = np.subtract(pose, frame, dtype=float)
    difference[:2] = transform(frame)[:2, :2] @ difference[:2]
    return difference


def difference_only(pose, frame):
    return [p - f for p, f in zip(pose, frame, strict=True)]


def projected_on_the_other_side(pose, frame):
    x, y, theta = formula(pose, frame)
    return x, -y, theta


def distances(pose, frame):
    x, y, theta = formula(pose, frame)
    return abs(x), abs(y), theta


def bearing_as_heading(pose, frame):
    x, y, _ = formula(pose, frame)
    return x, y, math.atan2(y, x)


def rotated_to_the_pose(pose, frame):
    return formula(pose, [frame[0], frame[1], pose[2]])


def heading_added(pose, frame):
    x, y, _ = formula(pose, frame)
    return np.array([x, y, pose[2] + frame[2]])


def heading_kept(pose, frame):
    x, y, _ = formula(pose, frame)
    return np.array([x, y, pose[2]])


def changes_the_pose(pose, frame):
    new = formula(pose, frame)
    pose[0], pose[1], pose[2] = new
    return pose


def overwritten(pose, frame):
    x, y, theta = pose
    x = (x - frame[0]) * math.cos(frame[2]) + (y - frame[1]) * math.sin(frame[2])
    y = -(x - frame[0]) * math.sin(frame[2]) + (y - frame[1]) * math.cos(frame[2])
    return x, y, theta - frame[2]


def shift_forgotten(pose, frame):
    return formula(pose, [0, 0, frame[2]])


def matrix(pose, frame):
    return np.linalg.solve(transform(frame), transform(pose))


def unit_vectors(pose, frame):
    x, y, theta = formula(pose, frame)
    return np.array([x, y]) / np.hypot(x, y), theta


def arguments_exchanged(pose, frame):
    return formula(frame, pose)


WRONG = {
    "compose": (forward, "frame o pose", "plain"),
    "inverse behind": (inverse_behind, "pose o frame^-1", "plain"),
    "pose inverted": (inverse_of_the_pose, "the frame seen from the pose", "plain"),
    "frame negated": (negated_frame, "-frame for its inverse", "plain"),
    "turned forward": (difference_turned_forward, "R in place of its transpose", "plain"),
    "difference": (difference_only, "component by component", "plain"),
    "mirrored": (projected_on_the_other_side, "y to the right", "plain"),
    "distances": (distances, "signs lost", "subtle"),
    "bearing": (bearing_as_heading, "direction of the position for the heading", "subtle"),
    "turned to the pose": (rotated_to_the_pose, "pose's heading in the rotation; heading 0", "subtle"),
    "heading added": (heading_added, "sum of the headings", "plain"),
    "heading kept": (heading_kept, "pose's own heading", "plain"),
    "changes the pose": (changes_the_pose, "in place", "plain"),
    "overwritten": (overwritten, "y from the new x", "subtle"),
    "shift forgotten": (shift_forgotten, "frame's origin not subtracted", "plain"),
    "matrix": (matrix, "(3, 3)", "plain"),
    "unit vector": (unit_vectors, "a pair of unequal parts", "plain"),
    "arguments exchanged": (arguments_exchanged, "express_in(frame, pose)", "plain"),
}
