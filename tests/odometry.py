"""Odometry of the tests' own: what is proved about the logs shall not hang on the code that the course proves with them."""

import numpy as np

from course.logs import FloatArray, Log
from course.robots import Robot


def metres_per_count(robot: Robot) -> float:
    """Return the travel of a rim for one count [m]."""
    return 2 * np.pi * robot.radius / robot.gear / robot.counts_per_rev


def wheel_counts(log: Log, robot: Robot) -> tuple[FloatArray, FloatArray]:
    """Return the increments of the right and of the left wheel, forward positive."""
    left_counter = {1: 2, 2: 1}[robot.right_counter]
    return robot.sign_right * log[f"counter{robot.right_counter}"], robot.sign_left * log[f"counter{left_counter}"]


def midpoint_odometry(log: Log, robot: Robot) -> FloatArray:
    """Return the poses (N, 3) by the midpoint rule; row 0 is the start."""
    right, left = (metres_per_count(robot) * counts[1:] for counts in wheel_counts(log, robot))
    turned = (right - left) / robot.tread
    heading = np.cumsum(turned) - turned / 2
    distance = (right + left) / 2
    steps = np.column_stack([distance * np.cos(heading), distance * np.sin(heading), turned])
    return np.vstack([np.zeros(3), np.cumsum(steps, axis=0)])


def allowed_by_quantisation(log: Log, robot: Robot) -> tuple[float, float]:
    """Return by how much position [m] and heading [rad] may be wrong although nothing but rounding is.

    Each wheel's travel is wrong by half a count at most: one count in the difference of two wheels turns the heading,
    which displaces what is driven after it. The midpoint rule takes each arc for its chord, too long by (turn)^2 / 24.
    """
    right, left = (metres_per_count(robot) * counts[1:] for counts in wheel_counts(log, robot))
    heading = metres_per_count(robot) / abs(robot.tread)
    distance = np.abs(right + left) / 2
    chords = ((right - left) / robot.tread) ** 2 / 24
    return metres_per_count(robot) + float(distance.sum() * heading + (distance * chords).sum()), heading
