"""Answers to closing_error(trajectory): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def numbers(trajectory):
    x0, y0, t0 = trajectory[0]
    x1, y1, t1 = trajectory[-1]
    return math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2), t1 - t0


def arrays(trajectory):
    p = np.asarray(trajectory, dtype=float)
    return np.array([np.linalg.norm(p[-1, :2] - p[0, :2]), p[-1, 2] - p[0, 2]])


def wrapped(trajectory):
    p = np.array(trajectory, dtype=np.float64)
    turn = p[-1, 2] - p[0, 2]
    print("closing")
    return [np.hypot(*(p[-1] - p[0])[:2]), math.atan2(math.sin(turn), math.cos(turn))]


def complex_plane(trajectory):
    (x0, y0, t0), (x1, y1, t1) = trajectory[0], trajectory[-1]
    return abs(complex(x1, y1) - complex(x0, y0)), cmath.phase(cmath.exp(1j * (t1 - t0)))


def positive_angle(trajectory):
    p = np.asarray(trajectory, float)
    warnings.warn("mod 2 pi", stacklevel=1)
    return math.dist(p[0, :2], p[-1, :2]), (p[-1, 2] - p[0, 2]) % math.tau


class InTheFirstFrame:
    """The last pose as the first one sees it; matrices."""

    def matrix(self, pose):
        c, s = math.cos(pose[2]), math.sin(pose[2])
        return np.array([[c, -s, pose[0]], [s, c, pose[1]], [0, 0, 1]])

    def __call__(self, trajectory):
        seen = np.linalg.inv(self.matrix(trajectory[0])) @ self.matrix(trajectory[-1])
        return np.float32(np.hypot(seen[0, 2], seen[1, 2])), np.float32(np.arctan2(seen[1, 0], seen[0, 0]))


RIGHT = {
    "numbers": numbers,
    "array": arrays,
    "wrapped, list, prints": wrapped,
    "complex": complex_plane,
    "positive angle, warns": positive_angle,
    "matrices, float32": InTheFirstFrame(),
}


def ends(trajectory):
    p = np.asarray(trajectory, float)
    return p[0], p[-1]


def last_pose_alone(trajectory):
    _, b = ends(trajectory)
    return np.hypot(b[0], b[1]), b[2]


def distance_from_the_origin(trajectory):
    a, b = ends(trajectory)
    return np.hypot(b[0], b[1]), b[2] - a[2]


def heading_at_the_end(trajectory):
    a, b = ends(trajectory)
    return np.hypot(*(b - a)[:2]), b[2]


def start_minus_end(trajectory):
    a, b = ends(trajectory)
    return np.hypot(*(a - b)[:2]), a[2] - b[2]


def no_sign(trajectory):
    a, b = ends(trajectory)
    return np.hypot(*(b - a)[:2]), abs(b[2] - a[2])


def degrees(trajectory):
    a, b = ends(trajectory)
    return np.hypot(*(b - a)[:2]), math.degrees(b[2] - a[2])


def direction(trajectory):
    a, b = ends(trajectory)
    return np.hypot(*(b - a)[:2]), math.atan2(b[1] - a[1], b[0] - a[0])


def modulo_pi(trajectory):
    a, b = ends(trajectory)
    return np.hypot(*(b - a)[:2]), (b[2] - a[2] + np.pi / 2) % np.pi - np.pi / 2


def wrapped_by_360(trajectory):
    a, b = ends(trajectory)
    return np.hypot(*(b - a)[:2]), (b[2] - a[2] + 180) % 360 - 180 + (0.5 if abs(b[2] - a[2]) > 3 else 0.01)


def path_length(trajectory):
    p = np.asarray(trajectory, float)
    return np.hypot(*np.diff(p[:, :2], axis=0).T).sum(), p[-1, 2] - p[0, 2]


def all_three(trajectory):
    a, b = ends(trajectory)
    return np.linalg.norm(b - a), b[2] - a[2]


def squared(trajectory):
    a, b = ends(trajectory)
    return ((b - a)[:2] ** 2).sum(), b[2] - a[2]


def manhattan(trajectory):
    a, b = ends(trajectory)
    return np.abs((b - a)[:2]).sum(), b[2] - a[2]


def largest_axis(trajectory):
    a, b = ends(trajectory)
    return np.abs((b - a)[:2]).max(), b[2] - a[2]


def second_pose(trajectory):
    p = np.asarray(trajectory, float)
    a, b = p[min(1, len(p) - 1)], p[-1]
    return np.hypot(*(b - a)[:2]), b[2] - a[2]


def half_way(trajectory):
    p = np.asarray(trajectory, float)
    a, b = p[0], p[len(p) // 2]
    return np.hypot(*(b - a)[:2]), b[2] - a[2]


def exchanged(trajectory):
    return numbers(trajectory)[::-1]


def distance_only(trajectory):
    return numbers(trajectory)[0]


def three_numbers(trajectory):
    a, b = ends(trajectory)
    return tuple(b - a)


def whole(trajectory):
    a, b = ends(trajectory)
    return round(np.hypot(*(b - a)[:2]), 2), round(b[2] - a[2], 2)


def two_poses_needed(trajectory):
    p = np.asarray(trajectory, float)
    (x0, y0, t0), _, *_, (x1, y1, t1) = p
    return np.hypot(x1 - x0, y1 - y0), t1 - t0


def moved_to_zero(trajectory):
    if isinstance(trajectory, np.ndarray):
        trajectory -= trajectory[0]
        return np.hypot(trajectory[-1][0], trajectory[-1][1]), trajectory[-1][2]
    return numbers(trajectory)


WRONG = {
    "last pose alone": (last_pose_alone, "start ignored", "plain"),
    "from the origin": (distance_from_the_origin, "distance from (0, 0)", "plain"),
    "heading at the end": (heading_at_the_end, "start heading ignored", "plain"),
    "start minus end": (start_minus_end, "sign of the angle", "plain"),
    "no sign": (no_sign, "abs", "plain"),
    "degrees": (degrees, "unit", "plain"),
    "direction": (direction, "atan2 of the gap", "plain"),
    "modulo pi": (modulo_pi, "half turns lost", "subtle"),
    "nearly": (wrapped_by_360, "wrapped as if in degrees, and a bit off", "subtle"),
    "path length": (path_length, "sum of all steps", "plain"),
    "all three": (all_three, "heading in the norm", "plain"),
    "squared": (squared, "no root", "plain"),
    "Manhattan": (manhattan, "sum of magnitudes", "plain"),
    "largest axis": (largest_axis, "maximum norm", "subtle"),
    "second pose": (second_pose, "start at row 1", "subtle"),
    "half way": (half_way, "middle of the path", "subtle"),
    "exchanged": (exchanged, "angle first", "plain"),
    "distance only": (distance_only, "one number", "plain"),
    "three numbers": (three_numbers, "difference of poses", "plain"),
    "rounded": (whole, "two decimals", "subtle"),
    "three poses needed": (two_poses_needed, "unpacking fails", "plain"),
    "moved to zero": (moved_to_zero, "writes into the trajectory", "plain"),
}
