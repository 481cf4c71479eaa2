"""Answers to pose_step(pose, distance, dtheta): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings
from dataclasses import astuple, dataclass

import numpy as np


def slide(pose, distance, dtheta):
    x1, y1, theta1 = pose
    return np.array([np.cos(theta1) * distance + x1, np.sin(theta1) * distance + y1, dtheta + theta1])


def item_by_item(pose, distance, dtheta):
    new = [0.0, 0.0, 0.0]
    for k, change in enumerate([distance * math.cos(pose[2]), distance * math.sin(pose[2]), dtheta]):
        new[k] = pose[k] + change
    return new


def homogeneous(pose, distance, dtheta):
    c, s = math.cos(pose[2]), math.sin(pose[2])
    here = np.array([[c, -s, pose[0]], [s, c, pose[1]], [0, 0, 1]])
    x, y, _ = here @ [distance, 0, 1]
    return x, y, pose[2] + dtheta


def polar(pose, distance, dtheta):
    way = cmath.rect(abs(distance), pose[2] + (math.pi if distance < 0 else 0))
    return pose[0] + way.real, pose[1] + way.imag, pose[2] + dtheta


def chatty(pose, distance, dtheta):
    print("step", distance, dtheta)
    if distance < 0:
        warnings.warn("reversing", stacklevel=2)
    moved = np.array(pose, dtype=float)
    moved += distance * np.array([np.cos(moved[2]), np.sin(moved[2]), 0])
    moved[2] += dtheta
    return moved


def single_precision(pose, distance, dtheta):
    x, y, theta = np.array(pose, dtype=np.float32)
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta], dtype=np.float32)


def recursive(pose, distance, dtheta, pieces=4):
    if pieces == 0:
        return [pose[0], pose[1], pose[2] + dtheta]
    x, y, theta = recursive(pose, distance, 0, pieces - 1)
    return [x + distance / 4 * math.cos(theta), y + distance / 4 * math.sin(theta), theta + dtheta]


@dataclass
class Pose:
    x: float
    y: float
    theta: float

    def __call__(self, pose, distance, dtheta):
        x, y, theta = pose
        moved = Pose(x + distance * math.cos(theta), y + distance * math.sin(theta), theta + dtheta)
        return astuple(moved)


RIGHT = {
    "as on the slide": slide,
    "list, item by item": item_by_item,
    "homogeneous matrix, tuple": homogeneous,
    "polar form": polar,
    "prints and warns": chatty,
    "float32": single_precision,
    "recursion in four pieces": recursive,
    "dataclass that is called": Pose(0, 0, 0),
    "lambda": lambda p, d, a: np.add(p, [d * np.cos(p[2]), d * np.sin(p[2]), a]),
}


def changes_the_list(pose, distance, dtheta):
    pose[0] += distance * math.cos(pose[2])
    pose[1] += distance * math.sin(pose[2])
    pose[2] += dtheta
    return pose


def half_the_distance(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance / 2 * np.cos(theta), y + distance / 2 * np.sin(theta), theta + dtheta])


def small_angles(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance, y + distance * theta, theta + dtheta])


def heading_of_the_position(pose, distance, dtheta):
    x, y, theta = pose
    way = math.atan2(y, x)
    return np.array([x + distance * np.cos(way), y + distance * np.sin(way), theta + dtheta])


def cosine_by_root(pose, distance, dtheta):
    x, y, theta = pose
    s = math.sin(theta)
    return np.array([x + distance * math.sqrt(1 - s * s), y + distance * s, theta + dtheta])


def bearing(pose, distance, dtheta):
    """Headings clockwise from +y."""
    x, y, theta = pose
    return np.array([x + distance * np.sin(theta), y + distance * np.cos(theta), theta - dtheta])


def pose_times_motion(pose, distance, dtheta):
    return np.array(pose) * np.array([distance * np.cos(pose[2]), distance * np.sin(pose[2]), dtheta])


def turn_times_distance(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + distance * dtheta])


def wrapped_by_one_subtraction(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    if new > np.pi:
        new -= 2 * np.pi
    elif new < -np.pi:
        new += 2 * np.pi
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), new])


def wrapped_by_atan2(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), math.atan2(math.sin(new), math.cos(new))])


def remainder_of_fmod(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), math.fmod(theta + dtheta, 2 * math.pi)])


def still_when_reversing(pose, distance, dtheta):
    x, y, theta = pose
    distance = max(distance, 0)
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])


def turn_only_when_moving(pose, distance, dtheta):
    x, y, theta = pose
    if distance == 0:
        return np.array([x, y, theta])
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])


def heading_given_in_turns(pose, distance, dtheta):
    x, y, theta = pose
    way = 2 * np.pi * theta
    return np.array([x + distance * np.cos(way), y + distance * np.sin(way), theta + dtheta])


def unpacked_in_the_wrong_order(pose, distance, dtheta):
    theta, x, y = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])


def nothing_comes_back(pose, distance, dtheta):
    x, y, theta = pose
    print(x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta)


def only_arrays(pose, distance, dtheta):
    moved = pose.astype(float)
    moved[:2] += distance * np.array([np.cos(pose[2]), np.sin(pose[2])])
    moved[2] += dtheta
    return moved


def four_decimals(pose, distance, dtheta):
    x, y, theta = pose
    return [float(f"{value:.4f}") for value in (x + distance * math.cos(theta), y + distance * math.sin(theta), theta + dtheta)]


def mirrored_when_turning_right(pose, distance, dtheta):
    x, y, theta = pose
    side = 1 if dtheta >= 0 else -1
    return np.array([x + distance * np.cos(theta), y + side * distance * np.sin(theta), theta + dtheta])


WRONG = {
    "changes its input": (changes_the_list, "+= on the argument", "plain"),
    "half the distance": (half_the_distance, "D/2", "subtle"),
    "small angles": (small_angles, "cos = 1 and sin = theta", "subtle"),
    "direction of the position": (heading_of_the_position, "atan2(y, x) taken for the heading", "subtle"),
    "cosine by a root": (cosine_by_root, "the sign of the cosine is lost", "subtle"),
    "compass": (bearing, "clockwise from +y", "plain"),
    "multiplied": (pose_times_motion, "pose * motion", "subtle"),
    "turn times distance": (turn_times_distance, "theta + D dtheta", "subtle"),
    "wrapped once": (wrapped_by_one_subtraction, "2 pi subtracted when beyond pi", "subtle"),
    "wrapped by atan2": (wrapped_by_atan2, "theta_2 within +-pi", "plain"),
    "fmod": (remainder_of_fmod, "theta_2 within +-2 pi", "subtle"),
    "no reversing": (still_when_reversing, "negative distance becomes 0", "subtle"),
    "no turning on the spot": (turn_only_when_moving, "distance 0 returns the start", "subtle"),
    "turns": (heading_given_in_turns, "theta taken for turns", "subtle"),
    "order of the pose": (unpacked_in_the_wrong_order, "theta, x, y = pose", "subtle"),
    "prints": (nothing_comes_back, "no return", "plain"),
    "only arrays": (only_arrays, "a list has no astype", "plain"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "right turns mirrored": (mirrored_when_turning_right, "sign of dtheta put on y", "subtle"),
}
