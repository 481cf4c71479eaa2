"""integrate_increments(distance, dtheta, pose0): the midpoint rule on encoder increments, which are means, not samples."""

import cmath

import numpy as np

from autograder.exercise import Exercise, Mistake
from autograder.reference.integration.drives import driven_increments
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(distance, dtheta, pose0):
    """Return the poses (N + 1, 3): each step along the heading halfway, as a complex number."""
    place, heading = complex(pose0[0], pose0[1]), float(pose0[2])
    poses = [[place.real, place.imag, heading]]
    for way, turn in zip(distance, dtheta, strict=True):
        place += way * cmath.rect(1.0, heading + 0.5 * turn)
        heading += turn
        poses.append([place.real, place.imag, heading])
    return np.array(poses)


def cases(rng):
    """Draw drives; turns are large enough to tell the rules apart, and no two steps are alike."""
    return driven_increments(rng)


def yaw_wrapped(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, (theta + np.pi) % (2 * np.pi) - np.pi])


def yaw_wrapped_to_positive(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta % (2 * np.pi)])


def euler_rule(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1]
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def new_heading_used(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[1:]
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def mean_of_both_headings(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    c, s = (np.cos(theta[1:]) + np.cos(theta[:-1])) / 2, (np.sin(theta[1:]) + np.sin(theta[:-1])) / 2
    dx, dy = d * c, d * s
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def exact_arc(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    c = np.sinc(turn / 2 / np.pi)
    dx, dy = c * d * np.cos(middle), c * d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_overwritten_before_y(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(theta[1:])
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def new_heading_plus_half(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[1:] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def half_subtracted(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] - turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def half_of_the_heading(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = (theta[:-1] + turn) / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def half_turn_only(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn / 2))
    middle = theta[1:]
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def neighbours_averaged(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    turn, d = (turn + np.append(0, turn[:-1])) / 2, (d + np.append(0, d[:-1])) / 2
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def neighbours_averaged_forward(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    turn, d = (turn + np.append(turn[1:], turn[-1])) / 2, (d + np.append(d[1:], d[-1])) / 2
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def trapezoids_of_increments(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum((turn[1:] + turn[:-1]) / 2))
    mx, my = d * np.cos(theta), d * np.sin(theta)
    x = pose0[0] + np.append(0, np.cumsum((mx[1:] + mx[:-1]) / 2))
    y = pose0[1] + np.append(0, np.cumsum((my[1:] + my[:-1]) / 2))
    return np.column_stack([x, y, theta])


def increments_taken_as_totals(distance, dtheta, pose0):
    turn, d = np.diff(np.append(0, dtheta)), np.diff(np.append(0, distance))
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def next_turn_used(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + np.append(turn[1:], 0) / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def turn_before_used(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + np.append(0, turn[:-1]) / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def distance_and_turn_exchanged(distance, dtheta, pose0):
    d, turn = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_kept(distance, dtheta, pose0):
    d = np.array(distance, dtype=float)
    theta = pose0[2] * np.ones(len(d) + 1)
    middle = theta[:-1]
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_kept_for_moving(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    c, s = np.cos(pose0[2]), np.sin(pose0[2])
    dx, dy = d * c, d * s
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_ignored(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = d, 0 * d
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def turn_alone_used(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = d * np.cos(turn), d * np.sin(turn)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def start_heading_ignored(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def start_heading_added_afterwards(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta + pose0[2]])


def start_position_ignored(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = np.append(0, np.cumsum(dx))
    y = np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def start_ignored(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = np.append(0, np.cumsum(dx))
    y = np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def zeros_in_the_first_row(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    poses = np.column_stack([x, y, theta])
    poses[0] = 0
    return poses


def zeros_in_the_last_row(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    poses = np.column_stack([x, y, theta])
    if len(poses) > 1:
        poses[-1] = 0
    return poses


def last_step_not_taken(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    poses = np.column_stack([x, y, theta])
    if len(poses) > 1:
        poses[-1] = poses[-2]
    return poses


def start_row_twice(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[[0, *range(len(d))]]


def start_row_dropped(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[1:]


def last_row_dropped(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[:-1]


def only_the_last_pose(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.array([x[-1], y[-1], theta[-1]])


def every_row_the_last_pose(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[[-1] * len(x)]


def every_row_the_initial_pose(distance, dtheta, pose0):
    return np.array([pose0] * (len(distance) + 1), dtype=float)


def steps_not_added_up(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, dx)
    y = pose0[1] + np.append(0, dy)
    return np.column_stack([x, y, theta])


def turns_not_added_up(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, turn)
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def motion_returned(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    return np.column_stack([dx, dy, np.diff(theta)])


def rows_and_columns_exchanged(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.array([x, y, theta])


def reshaped_instead_of_transposed(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.array([x, y, theta]).reshape(-1, 3)


def yaw_in_the_first_column(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([theta, x, y])


def yaw_left_out(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y])


def heading_counted_from_y(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.sin(middle), d * -np.cos(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def sin_cos_exchanged(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.sin(middle), d * np.cos(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def y_mirrored(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] - np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def cos_in_both(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.cos(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def sin_in_both(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.sin(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def degrees_in_cos(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(np.deg2rad(middle)), d * np.sin(np.deg2rad(middle))
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def converted_to_degrees_for_cos(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(np.rad2deg(middle)), d * np.sin(np.rad2deg(middle))
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def yaw_in_degrees(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, np.rad2deg(theta)])


def turn_subtracted(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] - np.append(0, np.cumsum(turn))
    middle = theta[:-1] - turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def distance_subtracted(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] - np.append(0, np.cumsum(dx))
    y = pose0[1] - np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def distance_made_positive(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    d = abs(d)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def turns_made_positive(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    turn = abs(turn)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def stands_still_when_reversing(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    d = np.maximum(d, 0)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def whole_numbers_cut_off(distance, dtheta, pose0):
    poses = np.array([pose0] * (len(distance) + 1))
    for k in range(len(distance)):
        middle = poses[k, 2] + dtheta[k] / 2
        poses[k + 1, 0] = poses[k, 0] + distance[k] * np.cos(middle)
        poses[k + 1, 1] = poses[k, 1] + distance[k] * np.sin(middle)
        poses[k + 1, 2] = poses[k, 2] + dtheta[k]
    return poses


def rounded(distance, dtheta, pose0):
    turn, d = np.array(dtheta, dtype=float), np.array(distance, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.round(np.column_stack([x, y, theta]), 3)


def arrays_only(distance, dtheta, pose0):
    turn, d = dtheta, distance
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    middle = theta[:-1] + turn / 2
    dx, dy = d * np.cos(middle), d * np.sin(middle)
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


EXERCISE = Exercise(
    name="integrate_increments",
    notebook="odometry/integration",
    points=5,
    parameters=("distance", "dtheta", "pose0"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (np.array([0.1, 0.2, 0.1]), np.array([0.0, 0.4, 0.2]), np.array([1.0, 2.0, np.pi / 6])),
        (np.array([1.0, -0.5]), np.array([-0.5, -1.0]), np.array([0.0, 0.0, np.pi / 2])),
    ),
    mistakes=(
        Mistake(
            yaw_wrapped,
            Text(
                "The headings are wrapped to -pi..pi. In a trajectory they go on counting: wrap only for display, or the "
                "curve of the yaw will jump.",
                "方位が -π〜π に折り返されています。軌跡の方位はそのまま数え続けます。折り返すのは表示のときだけにしないと、"
                "方位のグラフが飛びます。",
            ),
        ),
        Mistake(
            yaw_wrapped_to_positive,
            Text(
                "The headings are wrapped to 0..2 pi. In a trajectory they go on counting, and may be negative: no modulo.",
                "方位が 0〜2π に折り返されています。軌跡の方位は負になっても 1 回転を超えてもそのまま数え続けます。"
                "剰余はとりません。",
            ),
        ),
        Mistake(
            euler_rule,
            Text(
                "Each step goes along the heading at its beginning: Euler's rule. While the wheels count, the robot "
                "turns: which heading has it halfway?",
                "各歩が、歩の始まりの方位に進んでいます(オイラー法)。カウントがたまる間にもロボットは回っています。"
                "歩の途中、ちょうど半分のところの方位はいくつですか。",
            ),
        ),
        Mistake(
            new_heading_used,
            Text(
                "Each step goes along the heading at its end. The midpoint rule uses the one halfway, where half of "
                "dtheta is turned.",
                "各歩が、歩の終わりの方位に進んでいます。中点則では、dtheta の半分だけ回った中間の方位を使います。",
            ),
        ),
        Mistake(
            mean_of_both_headings,
            Text(
                "cos and sin are averaged over both ends of each step. The midpoint rule takes them once, at the heading "
                "halfway.",
                "cos, sin を歩の両端で平均しています。中点則では、中間の方位で 1 回だけ計算します。",
            ),
        ),
        Mistake(
            exact_arc,
            Text(
                "This is the exact circular arc. Asked for is the midpoint rule: the whole distance straight along the "
                "heading halfway.",
                "円弧の厳密な式になっています。求めるのは中点則、つまり中間の方位に距離の分だけまっすぐ進む式です。",
            ),
        ),
        Mistake(
            heading_overwritten_before_y,
            Text(
                "x goes along the heading halfway, y along the one at the end: the heading changes between the two lines.",
                "x は中間の方位、y は歩の終わりの方位で計算されています。2 つの行の間で方位が変わっています。",
            ),
        ),
        Mistake(
            new_heading_plus_half,
            Text(
                "Half of dtheta is added to the new heading: dtheta is counted one and a half times. Halfway lies "
                "between the old heading and the new one.",
                "新しい方位に dtheta の半分を足しているため、dtheta が 1.5 回分入っています。中間は古い方位と新しい方位の間です。",
            ),
        ),
        Mistake(
            half_subtracted,
            Text(
                "Half of dtheta is subtracted from the old heading. Halfway lies on the side to which the robot turns.",
                "古い方位から dtheta の半分を引いています。中間の方位は、ロボットが回る側にあります。",
            ),
        ),
        Mistake(
            half_of_the_heading,
            Text(
                "Brackets: the heading itself is halved as well. Only dtheta is.",
                "かっこの位置が違い、方位そのものまで半分になっています。半分にするのは dtheta だけです。",
            ),
        ),
        Mistake(
            half_turn_only,
            Text(
                "Only half of dtheta is added to the heading. The half is for moving; at the end of the step all of it "
                "is turned.",
                "方位に dtheta の半分しか足していません。半分を使うのは移動の向きだけで、歩の終わりには全部回っています。",
            ),
        ),
        Mistake(
            neighbours_averaged,
            Text(
                "Neighbouring increments are averaged, as if they were samples. An increment is already all that "
                "happened in its interval: use it as it is.",
                "増分をサンプル値のように隣どうしで平均しています。増分はすでにその区間の動きの全部ですから、そのまま使いましょう。",
            ),
        ),
        Mistake(
            neighbours_averaged_forward,
            Text(
                "Neighbouring increments are averaged, as if they were samples. An increment is already all that "
                "happened in its interval: use it as it is.",
                "増分をサンプル値のように隣どうしで平均しています。増分はすでにその区間の動きの全部ですから、そのまま使いましょう。",
            ),
        ),
        Mistake(
            trapezoids_of_increments,
            Text(
                "This is the trapezoid rule for samples: N increments became N rows, and the mean of two neighbours is "
                "used. Increments are whole intervals: N of them lead to N + 1 poses.",
                "これはサンプル値のための台形公式で、N 個の増分から N 行しかできず、隣どうしの平均を使っています。"
                "増分は区間ごとの値なので、N 個から N + 1 個の姿勢が得られます。",
            ),
        ),
        Mistake(
            increments_taken_as_totals,
            Text(
                "Differences of the increments are taken. They are increments already: add them up as they are.",
                "増分の差をとっています。すでに増分ですから、そのまま足し合わせます。",
            ),
        ),
        Mistake(
            next_turn_used,
            Text(
                "Half of the next interval's dtheta is used. Distance and dtheta with the same index belong to the same "
                "interval.",
                "次の区間の dtheta の半分を使っています。同じ番号の distance と dtheta が同じ区間のものです。",
            ),
        ),
        Mistake(
            turn_before_used,
            Text(
                "Half of the interval before is used. Distance and dtheta with the same index belong to the same interval.",
                "1 つ前の区間の dtheta の半分を使っています。同じ番号の distance と dtheta が同じ区間のものです。",
            ),
        ),
        Mistake(
            distance_and_turn_exchanged,
            Text(
                "distance and dtheta are exchanged. The order of the arguments is (distance, dtheta, pose0).",
                "distance と dtheta が入れ替わっています。引数の順序は (distance, dtheta, pose0) です。",
            ),
        ),
        Mistake(
            heading_kept,
            Text(
                "The heading stays at its initial value. The turns are to be added up.",
                "方位が初期値のままです。回転の分を累積しましょう。",
            ),
        ),
        Mistake(
            heading_kept_for_moving,
            Text(
                "The headings are right, but every step goes along the first of them.",
                "方位は合っていますが、どの歩も最初の方位に進んでいます。",
            ),
        ),
        Mistake(
            heading_ignored,
            Text(
                "The robot always moves along x, whatever its heading. The motion points along the robot: its parts "
                "along x and y follow from theta.",
                "方位に関係なく x 方向へ進んでいます。移動はロボットの向きに起こります。x 成分と y 成分は theta から求まります。",
            ),
        ),
        Mistake(
            turn_alone_used,
            Text(
                "Each step goes along the change of the heading in that step. The robot moves along the heading itself.",
                "各歩が、その歩での方位の変化量の向きに進んでいます。ロボットが進むのは方位そのものの向きです。",
            ),
        ),
        Mistake(
            start_heading_ignored,
            Text(
                "The initial heading is missing: the drive begins along +x.",
                "初期方位が使われておらず、+x の向きから始まっています。",
            ),
        ),
        Mistake(
            start_heading_added_afterwards,
            Text(
                "The headings are right, but the initial heading is added only after moving: the path begins along +x. "
                "cos and sin need it too.",
                "方位は合っていますが、初期方位を足したのが移動の計算の後で、経路が +x の向きから始まっています。"
                "cos, sin の中にも必要です。",
            ),
        ),
        Mistake(
            start_position_ignored,
            Text(
                "x and y begin at 0. They begin at the position in pose0.",
                "x, y が 0 から始まっています。pose0 の位置から始めましょう。",
            ),
        ),
        Mistake(
            start_ignored,
            Text(
                "pose0 has no effect: everything begins at 0.",
                "pose0 が使われておらず、すべて 0 から始まっています。",
            ),
        ),
        Mistake(
            zeros_in_the_first_row,
            Text(
                "The first row is 0. It is the initial pose.",
                "最初の行が 0 です。最初の行は初期姿勢 pose0 です。",
            ),
        ),
        Mistake(
            zeros_in_the_last_row,
            Text(
                "The last row has stayed 0: the loop ends one step too early.",
                "最後の行が 0 のままです。ループが 1 つ早く終わっています。",
            ),
        ),
        Mistake(
            last_step_not_taken,
            Text(
                "The last step is missing: the pose before it stands there twice. Where does the loop end?",
                "最後の 1 歩が抜けていて、その前の姿勢が 2 回並んでいます。ループの終わりを確かめましょう。",
            ),
        ),
        Mistake(
            start_row_twice,
            Text(
                "The poses come one row too late: the initial pose stands there twice, and the last is missing.",
                "姿勢が 1 行ずつ後ろにずれています。初期姿勢が 2 回並び、最後の姿勢がありません。",
            ),
        ),
        Mistake(
            start_row_dropped,
            Text(
                "The initial pose is missing in front: N increments lead to N + 1 poses.",
                "先頭に初期姿勢がありません。増分が N 個なら姿勢は N + 1 個です。",
            ),
        ),
        Mistake(
            last_row_dropped,
            Text(
                "The last pose is missing: N increments lead to N + 1 poses.",
                "最後の姿勢がありません。増分が N 個なら姿勢は N + 1 個です。",
            ),
        ),
        Mistake(
            only_the_last_pose,
            Text(
                "Only the last pose comes back. Asked for are all of them, one row each.",
                "最後の姿勢しか返っていません。求めるのはすべての姿勢で、1 行に 1 つずつです。",
            ),
        ),
        Mistake(
            every_row_the_last_pose,
            Text(
                "Every row is the last pose: the same array was put into the list again and again. Append a copy, or "
                "make a new array in every step.",
                "すべての行が最後の姿勢になっています。同じ配列を何度もリストに入れたためです。コピーを追加するか、"
                "毎回新しい配列を作りましょう。",
            ),
        ),
        Mistake(
            every_row_the_initial_pose,
            Text(
                "Every row is the initial pose. Each row begins with the one before it, and a step is added.",
                "すべての行が初期姿勢のままです。各行は、その前の行に 1 歩分を足したものです。",
            ),
        ),
        Mistake(
            steps_not_added_up,
            Text(
                "The headings are right, but x and y hold one step only, counted from the start. Each pose goes on from "
                "the one before it.",
                "方位は合っていますが、x, y には初期位置からの 1 歩分しか入っていません。各姿勢は 1 つ前の姿勢から続きます。",
            ),
        ),
        Mistake(
            turns_not_added_up,
            Text(
                "The headings hold one turn only, counted from the start. Each heading goes on from the one before it.",
                "方位に、初期方位からの 1 歩分の回転しか入っていません。各方位は 1 つ前の方位から続きます。",
            ),
        ),
        Mistake(
            motion_returned,
            Text(
                "The motions of the single steps come back. Add them up, from pose0 on.",
                "1 歩ごとの移動量が返っています。pose0 から順に足し合わせましょう。",
            ),
        ),
        Mistake(
            rows_and_columns_exchanged,
            Text(
                "Rows and columns are exchanged: each pose is to be a row (x, y, theta). np.column_stack puts columns "
                "side by side.",
                "行と列が入れ替わっています。1 つの姿勢 (x, y, theta) が 1 行になります。np.column_stack を使うと列を横に並べられます。",
            ),
        ),
        Mistake(
            reshaped_instead_of_transposed,
            Text(
                "The shape is right, but reshape has mixed x, y and theta: it does not turn rows into columns. Use .T or "
                "np.column_stack.",
                "形状は合っていますが、reshape によって x, y, theta が混ざっています。reshape は行と列を入れ替えません。"
                ".T か np.column_stack を使いましょう。",
            ),
        ),
        Mistake(
            yaw_in_the_first_column,
            Text(
                "theta stands in the first column. The order is x, y, theta.",
                "theta が最初の列にあります。順序は x, y, theta です。",
            ),
        ),
        Mistake(
            yaw_left_out,
            Text(
                "theta is missing: a pose has three parts.",
                "theta がありません。姿勢は 3 つの値からなります。",
            ),
        ),
        Mistake(
            heading_counted_from_y,
            Text(
                "The heading is counted from the y axis. Here 0 looks along +x, and pi/2 along +y.",
                "方位を y 軸から測っています。ここでは 0 が +x、π/2 が +y の向きです。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged, as on the slides on dead reckoning: the robot moves along y when its heading "
                "is 0. A heading of 0 looks along +x.",
                "sin と cos が入れ替わっています。デッドレコニングのスライドの式と同じ誤りで、方位 0 のときに y 方向へ進んでしまいます。"
                "方位 0 は +x の向きです。",
            ),
        ),
        Mistake(
            y_mirrored,
            Text(
                "The steps in y have the wrong sign: the path is mirrored. With a heading of pi/2, which way does y go?",
                "y の移動量の符号が逆で、経路が鏡映しになっています。方位が π/2 のとき、y は増えますか、減りますか。",
            ),
        ),
        Mistake(
            cos_in_both,
            Text(
                "cos is used for x and for y. Along the heading pi/2 the robot must move in y only.",
                "x にも y にも cos を使っています。方位 π/2 のとき、ロボットは y 方向だけに動くはずです。",
            ),
        ),
        Mistake(
            sin_in_both,
            Text(
                "sin is used for x and for y. Along the heading 0 the robot must move in x only.",
                "x にも y にも sin を使っています。方位 0 のとき、ロボットは x 方向だけに動くはずです。",
            ),
        ),
        Mistake(
            degrees_in_cos,
            Text(
                "The heading is converted as if it were in degrees. It is in rad already, and np.cos takes rad.",
                "方位を度とみなして変換しています。方位はすでに rad で、np.cos も rad を受け取ります。",
            ),
        ),
        Mistake(
            converted_to_degrees_for_cos,
            Text(
                "The heading is turned into degrees before cos and sin. np.cos takes rad: leave it as it is.",
                "cos, sin に渡す前に方位を度に変換しています。np.cos は rad を受け取るので、そのまま渡しましょう。",
            ),
        ),
        Mistake(
            yaw_in_degrees,
            Text(
                "theta comes back in degrees. The course computes in rad throughout.",
                "theta が度で返っています。この講義では一貫して rad で計算します。",
            ),
        ),
        Mistake(
            turn_subtracted,
            Text(
                "The turns are subtracted. Their sign already says to which side the robot turns: add them.",
                "回転の分を引いています。回る向きは符号が表しているので、足すだけです。",
            ),
        ),
        Mistake(
            distance_subtracted,
            Text(
                "The robot moves backwards: the steps are subtracted from x and y.",
                "ロボットが後ろへ進んでいます。x, y から移動量を引いています。",
            ),
        ),
        Mistake(
            distance_made_positive,
            Text(
                "A robot that reverses is drawn driving forward: the sign is lost.",
                "後退しているのに前進として計算されています。符号が失われています。",
            ),
        ),
        Mistake(
            turns_made_positive,
            Text(
                "Every turn becomes a turn to the left: the sign is lost.",
                "どの旋回も左旋回になっています。符号が失われています。",
            ),
        ),
        Mistake(
            stands_still_when_reversing,
            Text(
                "The robot stands still while it should reverse: negative values are cut off at 0.",
                "後退するはずのところで止まっています。負の値が 0 に切り詰められています。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With whole numbers the fractions are cut off: an array made of whole numbers holds nothing else. Make "
                "it with dtype=float.",
                "整数の入力で小数部分が切り捨てられています。整数から作った配列には整数しか入りません。dtype=float を指定して作りましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The poses are rounded to three decimals. Round only when you print.",
                "姿勢が小数第 3 位に丸められています。丸めるのは表示するときだけにしましょう。",
            ),
        ),
        Mistake(
            arrays_only,
            Text(
                "It works with arrays but not with lists: a list cannot be divided or multiplied by an array of cosines. "
                "Begin with np.array(..., dtype=float).",
                "配列では動きますが、リストでは動きません。リストのままでは割り算や掛け算ができません。最初に np.array(…, dtype=float) で配列にしましょう。",
            ),
        ),
    ),
)
