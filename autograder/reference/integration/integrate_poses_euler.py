"""integrate_poses_euler(t, velocity, yaw_rate, pose0): Euler's rule for samples at uneven times, notes 001 eq. (6)."""

import cmath

import numpy as np

from autograder.exercise import Exercise, Mistake
from autograder.reference.integration.drives import sampled_drives
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(t, velocity, yaw_rate, pose0):
    """Return the poses (N, 3): each step along the heading at its beginning, as a complex number."""
    place, heading = complex(pose0[0], pose0[1]), float(pose0[2])
    poses = [[place.real, place.imag, heading]]
    for k in range(1, len(t)):
        step = float(t[k]) - float(t[k - 1])
        place += cmath.rect(1.0, heading) * velocity[k - 1] * step
        heading += yaw_rate[k - 1] * step
        poses.append([place.real, place.imag, heading])
    return np.array(poses)


def cases(rng):
    """Draw drives; turns are large enough to tell the rules apart, and no two steps are alike."""
    return sampled_drives(rng)


def yaw_wrapped(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, (theta + np.pi) % (2 * np.pi) - np.pi])


def yaw_wrapped_to_positive(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta % (2 * np.pi)])


def trapezoid_rule(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    theta = pose0[2] + np.append(0, np.cumsum((w[1:] + w[:-1]) / 2 * dt))
    vx, vy = v * np.cos(theta), v * np.sin(theta)
    x = pose0[0] + np.append(0, np.cumsum((vx[1:] + vx[:-1]) / 2 * dt))
    y = pose0[1] + np.append(0, np.cumsum((vy[1:] + vy[:-1]) / 2 * dt))
    return np.column_stack([x, y, theta])


def yaw_by_trapezoids(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = (w[1:] + w[:-1]) / 2 * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def position_by_trapezoids(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    vx, vy = v * np.cos(theta), v * np.sin(theta)
    dx, dy = (vx[1:] + vx[:-1]) / 2 * dt, (vy[1:] + vy[:-1]) / 2 * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def next_sample_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[1:] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[1:] * np.cos(theta[:-1]) * dt, v[1:] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def next_sample_and_heading_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[1:] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[1:] * np.cos(theta[1:]) * dt, v[1:] * np.sin(theta[1:]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def next_speed_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[1:] * np.cos(theta[:-1]) * dt, v[1:] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def next_yaw_rate_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[1:] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def new_heading_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[1:]) * dt, v[:-1] * np.sin(theta[1:]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_overwritten_before_y(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[1:]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def midpoint_rule(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    m = (theta[1:] + theta[:-1]) / 2
    dx, dy = v[:-1] * np.cos(m) * dt, v[:-1] * np.sin(m) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def mean_of_both_headings(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    c, s = (np.cos(theta[1:]) + np.cos(theta[:-1])) / 2, (np.sin(theta[1:]) + np.sin(theta[:-1])) / 2
    dx, dy = v[:-1] * c * dt, v[:-1] * s * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def exact_arc(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    m, c = (theta[1:] + theta[:-1]) / 2, np.sinc(turn / 2 / np.pi)
    dx, dy = v[:-1] * c * np.cos(m) * dt, v[:-1] * c * np.sin(m) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def neighbours_averaged(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    v, w = (v[1:] + v[:-1]) / 2, (w[1:] + w[:-1]) / 2
    turn = w * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v * np.cos(theta[:-1]) * dt, v * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_kept(t, velocity, yaw_rate, pose0):
    v = np.array(velocity, dtype=float)
    dt = np.diff(t)
    theta = pose0[2] * np.ones(len(v))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_kept_for_moving(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    c, s = np.cos(pose0[2]), np.sin(pose0[2])
    dx, dy = v[:-1] * c * dt, v[:-1] * s * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def heading_ignored(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * dt, 0 * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def turn_alone_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(turn) * dt, v[:-1] * np.sin(turn) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def start_heading_ignored(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def start_heading_added_afterwards(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta + pose0[2]])


def start_position_ignored(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = np.append(0, np.cumsum(dx))
    y = np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def start_ignored(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = np.append(0, np.cumsum(dx))
    y = np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def zeros_in_the_first_row(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    poses = np.column_stack([x, y, theta])
    poses[0] = 0
    return poses


def zeros_in_the_last_row(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    poses = np.column_stack([x, y, theta])
    if len(poses) > 1:
        poses[-1] = 0
    return poses


def last_step_not_taken(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    poses = np.column_stack([x, y, theta])
    if len(poses) > 1:
        poses[-1] = poses[-2]
    return poses


def start_row_twice(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[[0, *range(len(v) - 1)]]


def start_row_dropped(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[1:]


def last_row_dropped(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[:-1]


def one_row_too_many(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    poses = np.column_stack([x, y, theta])
    return np.vstack([poses, poses[-1]])


def step_beyond_the_last_sample(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.append(np.diff(t), np.diff(t)[-1:] if len(t) > 1 else 0.0)
    turn = w * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v * np.cos(theta[:-1]) * dt, v * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def only_the_last_pose(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.array([x[-1], y[-1], theta[-1]])


def every_row_the_last_pose(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])[[-1] * len(x)]


def every_row_the_initial_pose(t, velocity, yaw_rate, pose0):
    return np.array([pose0] * len(t), dtype=float)


def steps_not_added_up(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, dx)
    y = pose0[1] + np.append(0, dy)
    return np.column_stack([x, y, theta])


def turns_not_added_up(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, turn)
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def motion_returned(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    return np.column_stack([dx, dy, np.diff(theta)])


def rows_and_columns_exchanged(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.array([x, y, theta])


def reshaped_instead_of_transposed(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.array([x, y, theta]).reshape(-1, 3)


def yaw_in_the_first_column(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([theta, x, y])


def yaw_left_out(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y])


def time_in_the_first_column(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([t, x, y, theta])


def heading_counted_from_y(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.sin(theta[:-1]) * dt, v[:-1] * -np.cos(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def sin_cos_exchanged(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.sin(theta[:-1]) * dt, v[:-1] * np.cos(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def y_mirrored(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] - np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def cos_in_both(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.cos(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def sin_in_both(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.sin(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def degrees_in_cos(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(np.deg2rad(theta)[:-1]) * dt, v[:-1] * np.sin(np.deg2rad(theta)[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def converted_to_degrees_for_cos(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(np.rad2deg(theta)[:-1]) * dt, v[:-1] * np.sin(np.rad2deg(theta)[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def yaw_in_degrees(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, np.rad2deg(theta)])


def turn_subtracted(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] - np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def distance_subtracted(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] - np.append(0, np.cumsum(dx))
    y = pose0[1] - np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def speed_made_positive(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    v = abs(v)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def turns_made_positive(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    w = abs(w)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def stands_still_when_reversing(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    v = np.maximum(v, 0)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def mean_dt(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.full(len(t) - 1, (t[-1] - t[0]) / max(len(t) - 1, 1))
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def first_dt_for_all(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.resize(np.diff(t)[:1], len(t) - 1)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def first_dt_for_all_fails_for_one_sample(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.full(len(t) - 1, t[1] - t[0])
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def next_dt_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.append(np.diff(t)[1:], np.diff(t)[-1:])
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def dt_before_used(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.append(np.diff(t)[:1], np.diff(t)[:-1])
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def dt_before_used_zero_first(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.append(np.zeros(len(t) > 1), np.diff(t)[:-1])
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def time_for_dt(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.array(t, dtype=float)[1:]
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def time_since_the_start_for_dt(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.array(t, dtype=float)[1:] - t[0]
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def dt_forgotten(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.ones(len(t) - 1)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def dt_forgotten_in_yaw(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1]
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def dt_forgotten_in_position(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]), v[:-1] * np.sin(theta[:-1])
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def always_5_milliseconds(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.full(len(t) - 1, 0.005)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def stamps_in_single_precision(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(np.array(t, dtype=np.float32)).astype(float)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def speed_and_yaw_rate_exchanged(t, velocity, yaw_rate, pose0):
    w, v = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


def whole_numbers_cut_off(t, velocity, yaw_rate, pose0):
    poses = np.array([pose0] * len(t))
    for k in range(len(t) - 1):
        h = t[k + 1] - t[k]
        c, s = np.cos(poses[k, 2]), np.sin(poses[k, 2])
        poses[k + 1, 0] = poses[k, 0] + velocity[k] * c * h
        poses[k + 1, 1] = poses[k, 1] + velocity[k] * s * h
        poses[k + 1, 2] = poses[k, 2] + yaw_rate[k] * h
    return poses


def rounded(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.diff(t)
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.round(np.column_stack([x, y, theta]), 3)


def arrays_only(t, velocity, yaw_rate, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = t[1:] - t[:-1]
    turn = w[:-1] * dt
    theta = pose0[2] + np.append(0, np.cumsum(turn))
    dx, dy = v[:-1] * np.cos(theta[:-1]) * dt, v[:-1] * np.sin(theta[:-1]) * dt
    x = pose0[0] + np.append(0, np.cumsum(dx))
    y = pose0[1] + np.append(0, np.cumsum(dy))
    return np.column_stack([x, y, theta])


EXERCISE = Exercise(
    name="integrate_poses_euler",
    notebook="odometry/integration",
    points=5,
    parameters=("t", "velocity", "yaw_rate", "pose0"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (
            np.array([0.0, 0.2, 0.5, 0.6]),
            np.array([0.5, 0.5, 1.0, 1.0]),
            np.array([0.0, 1.0, 0.5, 0.5]),
            np.array([1.0, 2.0, np.pi / 6]),
        ),
        (np.array([10.0, 10.1, 10.4]), np.array([1.0, -0.5, -0.5]), np.array([-0.5, -1.0, 0.0]), np.array([0.0, 0.0, np.pi / 2])),
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
            trapezoid_rule,
            Text(
                "This is the trapezoid rule, the next exercise. Euler's rule makes row k+1 from the values at sample k alone.",
                "これは次の課題の台形公式です。オイラー法では、k+1 行目をサンプル k の値だけから計算します。",
            ),
        ),
        Mistake(
            yaw_by_trapezoids,
            Text(
                "The heading is integrated by trapezoids, x and y by Euler's rule. Here all three take the values at sample k.",
                "方位は台形公式、x, y はオイラー法で積分されています。この課題では 3 つともサンプル k の値を使います。",
            ),
        ),
        Mistake(
            position_by_trapezoids,
            Text(
                "x and y are integrated by trapezoids, the heading by Euler's rule. Here all three take the values at sample k.",
                "x, y は台形公式、方位はオイラー法で積分されています。この課題では 3 つともサンプル k の値を使います。",
            ),
        ),
        Mistake(
            next_sample_used,
            Text(
                "Speed and yaw rate are those at the end of each step. Row k+1 comes from the values at sample k.",
                "速度と角速度に、各歩の終わりの値を使っています。k+1 行目はサンプル k の値から計算します。",
            ),
        ),
        Mistake(
            next_sample_and_heading_used,
            Text(
                "Speed, yaw rate and heading are those at the end of each step. Row k+1 comes from the values at sample k.",
                "速度、角速度、方位のすべてに、各歩の終わりの値を使っています。k+1 行目はサンプル k の値から計算します。",
            ),
        ),
        Mistake(
            next_speed_used,
            Text(
                "The speed is the one at the end of each step, the yaw rate the one at its beginning. Both belong to sample k.",
                "角速度は歩の始まり、速度は歩の終わりの値になっています。どちらもサンプル k の値です。",
            ),
        ),
        Mistake(
            next_yaw_rate_used,
            Text(
                "The yaw rate is the one at the end of each step, the speed the one at its beginning. Both belong to sample k.",
                "速度は歩の始まり、角速度は歩の終わりの値になっています。どちらもサンプル k の値です。",
            ),
        ),
        Mistake(
            new_heading_used,
            Text(
                "Each step goes along the heading at its end: theta was updated first. Euler's rule uses theta_k, the "
                "heading when the step begins.",
                "各歩が、その歩の終わりの方位に進んでいます。theta を先に更新しているためです。オイラー法では、"
                "歩の始まりの方位 theta_k を使います。",
            ),
        ),
        Mistake(
            heading_overwritten_before_y,
            Text(
                "x moves along the old heading but y along the new one: theta is overwritten between the two lines.",
                "x は古い方位、y は新しい方位で計算されています。2 つの行の間で theta が上書きされています。",
            ),
        ),
        Mistake(
            midpoint_rule,
            Text(
                "Each step goes along the heading in its middle. That is the midpoint rule; Euler's rule uses the "
                "heading when the step begins.",
                "各歩が、歩の中間の方位に進んでいます。これは中点則です。オイラー法では、歩の始まりの方位を使います。",
            ),
        ),
        Mistake(
            mean_of_both_headings,
            Text(
                "cos and sin are averaged over both ends of each step. Euler's rule uses the heading when the step "
                "begins, alone.",
                "cos, sin を歩の両端で平均しています。オイラー法で使うのは、歩の始まりの方位だけです。",
            ),
        ),
        Mistake(
            exact_arc,
            Text(
                "Each step is an exact circular arc. Here Euler's straight steps are asked for, along the heading when "
                "the step begins.",
                "各歩を円弧の厳密な式で計算しています。ここで求めるのは、歩の始まりの方位にまっすぐ進むオイラー法です。",
            ),
        ),
        Mistake(
            neighbours_averaged,
            Text(
                "Speed and yaw rate are averaged over both ends of each step. Euler's rule uses the values at sample k.",
                "速度と角速度を歩の両端で平均しています。オイラー法ではサンプル k の値をそのまま使います。",
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
                "The initial pose is missing in front.",
                "先頭に初期姿勢がありません。",
            ),
        ),
        Mistake(
            last_row_dropped,
            Text(
                "The last pose is missing: N samples give N rows.",
                "最後の姿勢がありません。サンプルが N 個なら N 行になります。",
            ),
        ),
        Mistake(
            one_row_too_many,
            Text(
                "There is a row too many: the last pose stands there twice. N samples have N - 1 steps between them, "
                "which makes N poses.",
                "行が 1 つ多く、最後の姿勢が 2 回並んでいます。N 個のサンプルの間の歩は N - 1 個なので、姿勢は N 個です。",
            ),
        ),
        Mistake(
            step_beyond_the_last_sample,
            Text(
                "There is a row too many: a step beyond the last sample, for which no time is known. N samples have N - "
                "1 steps between them.",
                "行が 1 つ多く、最後のサンプルより先へ 1 歩進んでいます。その時間は記録にありません。N 個のサンプルの間の歩は N - 1 個です。",
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
            time_in_the_first_column,
            Text(
                "The times stand in a column of their own. A row is a pose: x, y, theta.",
                "時刻の列が入っています。1 行は姿勢 x, y, theta です。",
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
            speed_made_positive,
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
            mean_dt,
            Text(
                "Every step takes the mean time. The times are uneven, as in a real log: each step has its own dt.",
                "どの歩にも時間間隔の平均を使っています。実際のログと同じく間隔は一定ではありません。歩ごとの dt を使いましょう。",
            ),
        ),
        Mistake(
            first_dt_for_all,
            Text(
                "Every step takes as long as the first. The times are uneven, as in a real log: each step has its own dt.",
                "どの歩にも最初の時間間隔を使っています。実際のログと同じく間隔は一定ではありません。歩ごとの dt を使いましょう。",
            ),
        ),
        Mistake(
            first_dt_for_all_fails_for_one_sample,
            Text(
                "Every step takes as long as the first, t[1] - t[0]. The times are uneven: each step has its own dt (and "
                "a single sample has no t[1]).",
                "どの歩にも最初の時間間隔 t[1] - t[0] を使っています。間隔は一定ではないので、歩ごとの dt を使いましょう。"
                "(サンプルが 1 つのときは t[1] がありません。)",
            ),
        ),
        Mistake(
            next_dt_used,
            Text(
                "Each step has the dt of the one after it. Step k goes from t[k] to t[k+1].",
                "1 つ後の歩の dt を使っています。歩 k は t[k] から t[k+1] までです。",
            ),
        ),
        Mistake(
            dt_before_used,
            Text(
                "Each step has the dt of the one before it. Step k goes from t[k] to t[k+1].",
                "1 つ前の歩の dt を使っています。歩 k は t[k] から t[k+1] までです。",
            ),
        ),
        Mistake(
            dt_before_used_zero_first,
            Text(
                "Each step has the dt of the one before it, and the first has none. Step k goes from t[k] to t[k+1].",
                "1 つ前の歩の dt を使っていて、最初の歩の dt は 0 になっています。歩 k は t[k] から t[k+1] までです。",
            ),
        ),
        Mistake(
            time_for_dt,
            Text(
                "The time itself stands where dt belongs. What is needed is how long the step takes: the difference of "
                "two neighbouring times.",
                "dt のところに時刻そのものを使っています。必要なのは 1 歩にかかる時間、つまり隣り合う時刻の差です。",
            ),
        ),
        Mistake(
            time_since_the_start_for_dt,
            Text(
                "The time since the start stands where dt belongs. What is needed is how long that one step takes.",
                "dt のところに最初からの経過時間を使っています。必要なのは、その 1 歩にかかる時間です。",
            ),
        ),
        Mistake(
            dt_forgotten,
            Text(
                "Time has no effect: speed and yaw rate are added as they are. m/s and rad/s are rates: what makes a "
                "length and an angle of them?",
                "時間が使われておらず、速度と角速度をそのまま足しています。m/s や rad/s は 1 秒あたりの値です。"
                "長さや角度にするには何が必要ですか。",
            ),
        ),
        Mistake(
            dt_forgotten_in_yaw,
            Text(
                "The yaw rate is added to the heading without dt. rad/s is a rate: what makes an angle of it?",
                "角速度に dt を掛けずに方位へ足しています。rad/s は 1 秒あたりの値です。角度にするには何が必要ですか。",
            ),
        ),
        Mistake(
            dt_forgotten_in_position,
            Text(
                "The speed is added to x and y without dt. m/s is a rate: what makes a length of it?",
                "速度に dt を掛けずに x, y へ足しています。m/s は 1 秒あたりの値です。長さにするには何が必要ですか。",
            ),
        ),
        Mistake(
            always_5_milliseconds,
            Text(
                "Every step takes 5 ms, whatever the times say. Take dt from the column of times.",
                "時刻に関係なく、どの歩も 5 ms になっています。dt は時刻の列から求めましょう。",
            ),
        ),
        Mistake(
            stamps_in_single_precision,
            Text(
                "Time stamps lose their digits in float32: Unix seconds are kept to two minutes only. Leave t in float64.",
                "時刻を float32 にしたため桁が失われています。Unix 秒では 2 分ほどの精度しか残りません。t は float64 のままにしましょう。",
            ),
        ),
        Mistake(
            speed_and_yaw_rate_exchanged,
            Text(
                "Speed and yaw rate are exchanged. The order of the arguments is (t, velocity, yaw_rate, pose0).",
                "速度と角速度が入れ替わっています。引数の順序は (t, velocity, yaw_rate, pose0) です。",
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
                "It works with arrays but not with lists: lists cannot be subtracted from each other. Use np.diff, or "
                "np.array(..., dtype=float) at the beginning.",
                "配列では動きますが、リストでは動きません。リストどうしの引き算はできないからです。np.diff を使うか、"
                "最初に np.array(…, dtype=float) で配列にしましょう。",
            ),
        ),
    ),
)
