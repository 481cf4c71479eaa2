"""Answers to pose_step_midpoint(pose, distance, dtheta): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def half_way(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def mean_heading(pose, distance, dtheta):
    before, after = pose[2], pose[2] + dtheta
    way = 0.5 * (before + after)
    return [pose[0] + distance * math.cos(way), pose[1] + distance * math.sin(way), after]


def turn_move_turn(pose, distance, dtheta):
    state = list(map(float, pose))
    state[2] += dtheta / 2
    state[0] += distance * math.cos(state[2])
    state[1] += distance * math.sin(state[2])
    state[2] += dtheta / 2
    return tuple(state)


def complex_plane(pose, distance, dtheta):
    end = complex(pose[0], pose[1]) + distance * cmath.exp(1j * (pose[2] + dtheta / 2))
    print(end)
    return end.real, end.imag, pose[2] + dtheta


def sum_formulas(pose, distance, dtheta):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    u, v = distance * np.cos(dtheta / 2), distance * np.sin(dtheta / 2)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ [u, v, dtheta] + pose


def in_single_precision(pose, distance, dtheta):
    warnings.warn("float32", stacklevel=2)
    return half_way(pose, distance, dtheta).astype(np.float32)


def runge_kutta(pose, distance, dtheta):
    def rate(state):
        return np.array([distance * np.cos(state[2]), distance * np.sin(state[2]), dtheta])

    start = np.array(pose, dtype=float)
    return start + rate(start + rate(start) / 2)


class Robot:
    def __call__(self, pose, distance, dtheta):
        self.x, self.y, self.theta = pose
        self.turn(dtheta / 2)
        self.go(distance)
        self.turn(dtheta / 2)
        return [self.x, self.y, self.theta]

    def turn(self, angle):
        self.theta = self.theta + angle

    def go(self, way):
        self.x, self.y = self.x + way * math.cos(self.theta), self.y + way * math.sin(self.theta)


RIGHT = {
    "heading half-way": half_way,
    "mean of the headings, list": mean_heading,
    "turn, move, turn, tuple": turn_move_turn,
    "complex plane, prints": complex_plane,
    "rotation matrix": sum_formulas,
    "float32, warns": in_single_precision,
    "Runge-Kutta of second order": runge_kutta,
    "robot object": Robot(),
    "lambda": lambda p, d, a: np.add(p, [d * np.cos(p[2] + a / 2), d * np.sin(p[2] + a / 2), a]),
}


def geometric_mean(pose, distance, dtheta):
    x, y, theta = pose
    middle = math.copysign(math.sqrt(abs(theta * (theta + dtheta))), theta)
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def third_of_the_turn(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 3
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def half_of_the_position(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([(x + distance * np.cos(middle)) / 2, (y + distance * np.sin(middle)) / 2, theta + dtheta])


def half_in_the_wrong_unit(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + np.degrees(dtheta) / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def cosine_halved(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta + dtheta) / 2, y + distance * np.sin(theta + dtheta) / 2, theta + dtheta])


def mean_position_of_both_steps(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    first = np.array([x + distance * np.cos(theta), y + distance * np.sin(theta)])
    second = np.array([x + distance * np.cos(new), y + distance * np.sin(new)])
    return np.array([*(first + second) / 2, new])


def two_midpoint_steps(pose, distance, dtheta):
    return half_way(half_way(pose, distance / 2, dtheta / 2), distance / 2, dtheta / 2)


def small_angle(pose, distance, dtheta):
    x, y, theta = pose
    c, s = np.cos(theta), np.sin(theta)
    return np.array([x + distance * (c - s * dtheta / 2), y + distance * (s + c * dtheta / 2), theta + dtheta])


def sign_of_the_correction(pose, distance, dtheta):
    x, y, theta = pose
    c, s, h = np.cos(theta), np.sin(theta), dtheta / 2
    return np.array(
        [x + distance * (c * np.cos(h) + s * np.sin(h)), y + distance * (s * np.cos(h) + c * np.sin(h)), theta + dtheta]
    )


def turn_wrapped(pose, distance, dtheta):
    turn = (dtheta + np.pi) % (2 * np.pi) - np.pi
    moved = half_way(pose, distance, turn)
    moved[2] = pose[2] + dtheta
    return moved


def turn_and_heading_wrapped(pose, distance, dtheta):
    turn = (dtheta + np.pi) % (2 * np.pi) - np.pi
    return half_way(pose, distance, turn)


def changes_pose(pose, distance, dtheta):
    pose[2] += dtheta / 2
    x = pose[0] + distance * np.cos(pose[2])
    y = pose[1] + distance * np.sin(pose[2])
    return np.array([x, y, pose[2] + dtheta / 2])


def integer_half(pose, distance, dtheta):
    half = int(dtheta / 2)
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta + half), y + distance * np.sin(theta + half), theta + dtheta])


def compass(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.sin(middle), y + distance * np.cos(middle), theta + dtheta])


def no_reversing(pose, distance, dtheta):
    return half_way(pose, max(distance, 0), dtheta)


def wrapped_by_atan2(pose, distance, dtheta):
    x, y, theta = half_way(pose, distance, dtheta)
    return x, y, math.atan2(math.sin(theta), math.cos(theta))


def column(pose, distance, dtheta):
    return half_way(pose, distance, dtheta).reshape(3, 1)


def two_poses(pose, distance, dtheta):
    return np.array([pose, half_way(pose, distance, dtheta)])


def half_way_pose(pose, distance, dtheta):
    moved = half_way(pose, distance / 2, dtheta)
    moved[2] -= dtheta / 2
    return moved


def four_decimals(pose, distance, dtheta):
    return half_way(pose, distance, dtheta).round(4)


def exchanged_arguments(pose, dtheta, distance):
    return half_way(pose, distance, dtheta)


def euler_for_small_turns(pose, distance, dtheta):
    if abs(dtheta) < 0.5:
        return half_way(pose, distance, 0) + np.array([0, 0, dtheta])
    return half_way(pose, distance, dtheta)


WRONG = {
    "geometric mean": (geometric_mean, "sqrt(theta_1 theta_2)", "subtle"),
    "third": (third_of_the_turn, "theta + dtheta/3", "subtle"),
    "position halved": (half_of_the_position, "(x + ...)/2", "subtle"),
    "degrees in the half": (half_in_the_wrong_unit, "dtheta in degrees", "subtle"),
    "cosine halved": (cosine_halved, "cos(theta_2)/2", "subtle"),
    "mean of both ends": (mean_position_of_both_steps, "the trapezoid rule", "plain"),
    "two midpoint steps": (two_midpoint_steps, "closer to the arc", "subtle"),
    "small angle": (small_angle, "cos(dtheta/2) = 1", "subtle"),
    "sign in the sum formula": (sign_of_the_correction, "cos(a - b) for x", "subtle"),
    "turn wrapped": (turn_wrapped, "wide turns become others", "subtle"),
    "turn and heading wrapped": (turn_and_heading_wrapped, "wide turns become others, in the heading too", "subtle"),
    "changes the pose": (changes_pose, "+= on the argument", "plain"),
    "whole half": (integer_half, "int(dtheta / 2)", "subtle"),
    "compass": (compass, "sin for x", "plain"),
    "no reversing": (no_reversing, "negative distances become 0", "subtle"),
    "wrapped by atan2": (wrapped_by_atan2, "theta within +-pi", "plain"),
    "column": (column, "(3, 1)", "plain"),
    "two poses": (two_poses, "(2, 3)", "plain"),
    "pose half-way": (half_way_pose, "half of everything", "plain"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "arguments exchanged": (exchanged_arguments, "dtheta before distance", "subtle"),
    "Euler below 0.5 rad": (euler_for_small_turns, "small turns by the old heading", "subtle"),
}
