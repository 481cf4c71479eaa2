"""dead_reckoning(velocity, yaw_rate, dt, pose0): all poses of a drive by Euler's rule, notes 001 eq. (6)."""

import numpy as np

from autograder.draws import magnitudes, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(velocity, yaw_rate, dt, pose0):
    """Return the poses, (N + 1, 3), by sums over complex steps: each along the heading at its beginning."""
    x, y, theta = pose0
    turns, ways = np.multiply(yaw_rate, dt), np.multiply(velocity, dt)
    headings = np.cumsum([theta, *turns])
    positions = np.cumsum([complex(x, y), *ways * np.exp(1j * headings[:-1])])
    return np.column_stack([positions.real, positions.imag, headings])


def cases(rng):
    """Draw drives of 1 to 6 steps; turns are large enough to tell the rules apart, and no two steps are alike.

    Headings are between 0 and pi where no group is about them.
    """

    def drive(count, forward, left, dt_array):
        dt = rng.permuted(np.linspace(0.2, 0.6, count)) + rng.uniform(-0.02, 0.02, count) if dt_array else rng.uniform(0.3, 0.5)
        velocity = forward * rng.uniform(0.5, 1.5, count)
        yaw_rate = np.resize(left, count) * rng.uniform(0.6, 1.4, count)
        x, y = magnitudes(rng, 0.5, 3.0, 2)
        return velocity, yaw_rate, dt, np.array([x, y, rng.uniform(0.3, 2.8)])

    def between_0_and_pi(velocity, yaw_rate, dt, pose0):
        headings = pose0[2] + np.cumsum(yaw_rate * dt)
        return min(headings) > 0.1 and max(headings) < 3.0

    def path(count, forward, left, dt_array):
        return until(lambda: drive(count, forward, left, dt_array), between_0_and_pi)

    def across_pi(side):
        velocity, yaw_rate, dt, pose0 = drive(4, 1, side, True)
        pose0[2] = side * (np.pi - rng.uniform(0.2, 0.5))
        return velocity, yaw_rate, dt, pose0

    velocity, yaw_rate, dt, pose0 = path(rng.choice([3, 5]), 1, [1, -1], True)
    whole = rng.permutation([3, -2, 1, 2]), rng.permutation([-2, 1, 2, 1]), 1, np.array([*rng.choice([-4, -3, 3, 4], 2), 2])
    return [
        Group(Text("dt a number", "dt が数値"), 3, [path(count, 1, [1, -1, 1], False) for count in (4, 6)]),
        Group(Text("dt an array", "dt が配列"), 3, [path(count, 1, [1, 1, -1], True) for count in (4, 5)]),
        Group(Text("one step or two", "1 歩または 2 歩"), 1, [path(1, 1, 1, False), path(1, 1, -1, True), path(2, 1, 1, True)]),
        Group(Text("reversing, turning right", "後退と右旋回"), 1, [path(5, [-1, -1, 1, 1, -1], -1, True)]),
        Group(Text("headings beyond half a turn", "半回転を超える方位"), 1, [across_pi(side) for side in (-1, 1)]),
        Group(Text("lists", "リストの入力"), 1, [tuple(part.tolist() for part in (velocity, yaw_rate, dt, pose0))]),
        Group(Text("whole numbers", "整数の入力"), 1, [whole]),
    ]


def yaw_wrapped(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, (theta + np.pi) % (2 * np.pi) - np.pi])


def yaw_wrapped_to_positive(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta % (2 * np.pi)])


def dt_forgotten_in_yaw(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def dt_forgotten_in_position(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1])))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1])))
    return np.column_stack([x, y, theta])


def dt_forgotten(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1])))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1])))
    return np.column_stack([x, y, theta])


def heading_kept(velocity, yaw_rate, dt, pose0):
    v = np.array(velocity, dtype=float)
    theta = pose0[2] + np.zeros(len(v) + 1)
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def heading_kept_for_moving(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(pose0[2]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(pose0[2]) * dt))
    return np.column_stack([x, y, theta])


def heading_ignored(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * dt))
    y = pose0[1] + np.zeros(len(v) + 1)
    return np.column_stack([x, y, theta])


def heading_one_step_late(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    used = np.append(pose0[2], theta[:-1])[: len(v)]
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(used) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(used) * dt))
    return np.column_stack([x, y, theta])


def new_heading_used(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[1:]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[1:]) * dt))
    return np.column_stack([x, y, theta])


def heading_overwritten_before_y(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[1:]) * dt))
    return np.column_stack([x, y, theta])


def midpoint_rule(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos((theta[:-1] + theta[1:]) / 2) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin((theta[:-1] + theta[1:]) / 2) * dt))
    return np.column_stack([x, y, theta])


def mean_of_both_headings(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * (np.cos(theta[:-1]) + np.cos(theta[1:])) / 2 * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * (np.sin(theta[:-1]) + np.sin(theta[1:])) / 2 * dt))
    return np.column_stack([x, y, theta])


def exact_arc(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    chord, middle = v * dt * np.sinc(w * dt / (2 * np.pi)), (theta[:-1] + theta[1:]) / 2
    x = pose0[0] + np.append(0, np.cumsum(chord * np.cos(middle)))
    y = pose0[1] + np.append(0, np.cumsum(chord * np.sin(middle)))
    return np.column_stack([x, y, theta])


def turn_alone_used(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(w * dt) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(w * dt) * dt))
    return np.column_stack([x, y, theta])


def start_heading_ignored(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def start_heading_added_afterwards(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta + pose0[2]])


def start_position_ignored(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def start_ignored(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = np.append(0, np.cumsum(w * dt))
    x = np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def zeros_in_the_first_row(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    poses = np.column_stack([x, y, theta])
    poses[0] = 0
    return poses


def last_step_not_taken(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    poses = np.column_stack([x, y, theta])
    poses[-1] = poses[-2]
    return poses


def zeros_in_the_last_row(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    poses = np.column_stack([x, y, theta])
    poses[-1] = 0
    return poses


def start_row_twice(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])[[0, *range(len(v))]]


def last_pose_first(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])[::-1]


def start_row_dropped(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])[1:]


def last_row_dropped(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])[:-1]


def only_the_last_pose(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.array([x[-1], y[-1], theta[-1]])


def every_row_the_last_pose(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])[[-1] * (len(v) + 1)]


def every_row_the_initial_pose(velocity, yaw_rate, dt, pose0):
    return np.array([pose0] * (len(velocity) + 1), dtype=float)


def steps_not_added_up(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, v * np.cos(theta[:-1]) * dt)
    y = pose0[1] + np.append(0, v * np.sin(theta[:-1]) * dt)
    return np.column_stack([x, y, theta])


def every_step_from_the_start(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, w * dt)
    x = pose0[0] + np.append(0, v * np.cos(pose0[2]) * dt)
    y = pose0[1] + np.append(0, v * np.sin(pose0[2]) * dt)
    return np.column_stack([x, y, theta])


def turns_not_added_up(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, w * dt)
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def motion_returned(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    return np.column_stack([v * dt * np.cos(theta[:-1]), v * dt * np.sin(theta[:-1]), w * dt])


def motion_returned_below_the_start(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    return np.vstack([pose0, np.column_stack([v * dt * np.cos(theta[:-1]), v * dt * np.sin(theta[:-1]), w * dt])])


def rows_and_columns_exchanged(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.array([x, y, theta])


def reshaped_instead_of_transposed(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.array([x, y, theta]).reshape(-1, 3)


def yaw_in_the_first_column(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([theta, x, y])


def yaw_left_out(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y])


def time_in_the_first_column(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([np.append(0, np.cumsum(np.ones(len(v)) * dt)), x, y, theta])


def heading_counted_from_y(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(-v * np.cos(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def sin_cos_exchanged(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def y_mirrored(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] - np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def cos_in_both(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def sin_in_both(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def degrees_in_cos(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(np.deg2rad(theta[:-1])) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(np.deg2rad(theta[:-1])) * dt))
    return np.column_stack([x, y, theta])


def converted_to_degrees_for_cos(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(np.rad2deg(theta[:-1])) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(np.rad2deg(theta[:-1])) * dt))
    return np.column_stack([x, y, theta])


def yaw_in_degrees(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, np.rad2deg(theta)])


def turn_subtracted(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] - np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def distance_subtracted(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] - np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] - np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def stands_still_when_reversing(velocity, yaw_rate, dt, pose0):
    v, w = np.maximum(velocity, 0), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def speed_made_positive(velocity, yaw_rate, dt, pose0):
    v, w = abs(np.array(velocity, dtype=float)), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def turns_made_positive(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), abs(np.array(yaw_rate, dtype=float))
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def next_dt_used(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.roll(np.ones(len(v)) * dt, -1)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def dt_before_used(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.roll(np.ones(len(v)) * dt, 1)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def mean_dt(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.mean(dt)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def first_dt_for_all(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.ravel(dt)[0]
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def time_for_dt(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = np.cumsum(np.ones(len(v)) * dt)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def always_10_milliseconds(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = 0.01
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def always_5_milliseconds(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    dt = 0.005
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def first_step_at_rest(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    v, w = np.append(0, v[:-1]), np.append(0, w[:-1])
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def next_sample_used(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    v, w = np.append(v[1:], v[-1]), np.append(w[1:], w[-1])
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def sample_before_used(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    v, w = np.append(v[0], v[:-1]), np.append(w[0], w[:-1])
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def first_sample_for_all(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    v, w = v[0] * np.ones(len(v)), w[0] * np.ones(len(w))
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def neighbours_averaged(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    v = (v + np.append(v[1:], v[-1])) / 2
    w = (w + np.append(w[1:], w[-1])) / 2
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.column_stack([x, y, theta])


def whole_numbers_cut_off(velocity, yaw_rate, dt, pose0):
    poses = np.array([pose0] * (len(velocity) + 1))
    for k in range(len(velocity)):
        way = velocity[k] * np.resize(dt, len(velocity))[k]
        poses[k + 1, 0] = poses[k, 0] + way * np.cos(poses[k, 2])
        poses[k + 1, 1] = poses[k, 1] + way * np.sin(poses[k, 2])
        poses[k + 1, 2] = poses[k, 2] + yaw_rate[k] * np.resize(dt, len(velocity))[k]
    return poses


def rounded(velocity, yaw_rate, dt, pose0):
    v, w = np.array(velocity, dtype=float), np.array(yaw_rate, dtype=float)
    theta = pose0[2] + np.append(0, np.cumsum(w * dt))
    x = pose0[0] + np.append(0, np.cumsum(v * np.cos(theta[:-1]) * dt))
    y = pose0[1] + np.append(0, np.cumsum(v * np.sin(theta[:-1]) * dt))
    return np.round(np.column_stack([x, y, theta]), 3)


def arrays_only(velocity, yaw_rate, dt, pose0):
    turns, ways = yaw_rate * np.ones(len(yaw_rate)) * dt, np.multiply(velocity * dt, 1.0)
    theta = pose0[2] + np.append(0, np.cumsum(turns))
    x = pose0[0] + np.append(0, np.cumsum(ways * np.cos(theta[:-1])))
    y = pose0[1] + np.append(0, np.cumsum(ways * np.sin(theta[:-1])))
    return np.column_stack([x, y, theta])


def attributes_of_arrays_only(velocity, yaw_rate, dt, pose0):
    n = velocity.size
    turns, ways = np.multiply(yaw_rate, dt), np.multiply(velocity, dt)
    theta = pose0[2] + np.append(0, np.cumsum(turns[:n]))
    x = pose0[0] + np.append(0, np.cumsum(ways * np.cos(theta[:-1])))
    y = pose0[1] + np.append(0, np.cumsum(ways * np.sin(theta[:-1])))
    return np.column_stack([x, y, theta])


def dt_must_be_an_array(velocity, yaw_rate, dt, pose0):
    poses = [np.array(pose0, dtype=float)]
    for v, w, h in zip(velocity, yaw_rate, dt, strict=True):
        x, y, theta = poses[-1]
        poses.append(np.array([x + v * h * np.cos(theta), y + v * h * np.sin(theta), theta + w * h]))
    return np.array(poses)


def dt_must_be_a_number(velocity, yaw_rate, dt, pose0):
    poses = [np.array(pose0, dtype=float)]
    for v, w in zip(velocity, yaw_rate, strict=True):
        x, y, theta = poses[-1]
        h = float(dt)
        poses.append(np.array([x + v * h * np.cos(theta), y + v * h * np.sin(theta), theta + w * h]))
    return np.array(poses)


def whole_dt_in_every_step(velocity, yaw_rate, dt, pose0):
    poses = np.zeros((len(velocity) + 1, 3))
    poses[0] = pose0
    for k in range(len(velocity)):
        poses[k + 1, 0] = poses[k, 0] + velocity[k] * np.multiply(dt, np.cos(poses[k, 2]))
        poses[k + 1, 1] = poses[k, 1] + velocity[k] * np.multiply(dt, np.sin(poses[k, 2]))
        poses[k + 1, 2] = poses[k, 2] + yaw_rate[k] * np.multiply(dt, 1.0)
    return poses


EXERCISE = Exercise(
    name="dead_reckoning",
    notebook="odometry/pose_update",
    points=5,
    parameters=("velocity", "yaw_rate", "dt", "pose0"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (np.array([0.5, 0.5, 0.5]), np.array([0.0, 1.0, 0.5]), 0.2, np.array([1.0, 2.0, np.pi / 6])),
        (np.array([1.0, -0.5]), np.array([-0.5, -1.0]), np.array([0.1, 0.3]), np.array([0.0, 0.0, np.pi / 2])),
    ),
    mistakes=(
        Mistake(
            yaw_wrapped,
            Text(
                "The headings are wrapped to -pi..pi. In a trajectory they go on counting: wrap only for display, or the "
                "curve of the yaw will jump.",
                "方位が -π〜π に折り返されています。軌跡の方位はそのまま数え続けます。"
                "折り返すのは表示のときだけにしないと、方位のグラフが飛びます。",
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
            dt_forgotten_in_yaw,
            Text(
                "The yaw rate is added to the heading as it is, without dt. rad/s is a rate: what makes an angle of it?",
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
            dt_forgotten,
            Text(
                "dt has no effect: speed and yaw rate are added as they are. In eq. (6) the whole bracket is multiplied by "
                "the sampling period.",
                "dt が使われていません。速度と角速度をそのまま足しています。"
                "式 (6) では、かっこ全体にサンプリング周期を掛けます。",
            ),
        ),
        Mistake(
            heading_kept,
            Text(
                "The heading never changes, so the path is a straight line. The third line of eq. (6) is missing, or its "
                "result is not kept for the next step.",
                "方位がずっと変わらず、経路がまっすぐになっています。"
                "式 (6) の 3 行目が抜けているか、計算した方位が次の歩に使われていません。",
            ),
        ),
        Mistake(
            heading_kept_for_moving,
            Text(
                "x and y always move along the first one. Each step goes along the heading of its own time.",
                "x と y はずっと最初の方位の向きに進んでいます。それぞれの歩は、その時点の方位の向きに進みます。",
            ),
        ),
        Mistake(
            heading_ignored,
            Text(
                "The robot always moves along x, whatever its heading. The parts of the speed along x and y follow from theta.",
                "方位に関係なく x 方向へ進んでいます。速度の x 成分と y 成分は theta から求まります。",
            ),
        ),
        Mistake(
            heading_one_step_late,
            Text(
                "Each step moves along the heading of one step earlier. Check the index of theta in the lines for x and y.",
                "各歩がひとつ前の方位の向きに進んでいます。x, y の式で theta の添字を確かめましょう。",
            ),
        ),
        Mistake(
            new_heading_used,
            Text(
                "Each step moves along the heading after it, theta_(k+1). Eq. (6) has theta_k on the right-hand side: compute "
                "x and y before the heading changes.",
                "各歩が動いた後の方位 theta_(k+1) の向きに進んでいます。式 (6) の右辺は theta_k です。"
                "方位を更新する前に x と y を計算しましょう。",
            ),
        ),
        Mistake(
            heading_overwritten_before_y,
            Text(
                "x moves along the old heading but y along the new one: the heading is overwritten between the two lines. "
                "Update theta last.",
                "x は古い方位、y は新しい方位で計算されています。2 つの行の間で theta が上書きされています。"
                "theta の更新は最後にしましょう。",
            ),
        ),
        Mistake(
            midpoint_rule,
            Text(
                "Each step moves along the heading half-way through its turn. That is the midpoint rule, more exact, but eq. "
                "(6) is Euler's: theta_k itself.",
                "各歩が旋回の途中(半分)の方位の向きに進んでいます。"
                "これは中点則で、より精度がよいのですが、式 (6) はオイラー法です。theta_k をそのまま使います。",
            ),
        ),
        Mistake(
            mean_of_both_headings,
            Text(
                "cos and sin of the headings before and after each step are averaged. That is a trapezoid rule; eq. (6) is "
                "Euler's and uses theta_k alone.",
                "各歩の前と後の cos, sin を平均しています。これは台形則です。式 (6) はオイラー法で、theta_k だけを使います。",
            ),
        ),
        Mistake(
            exact_arc,
            Text(
                "Each step is an exact arc. Here the simpler Euler rule of eq. (6) is asked for: straight along theta_k.",
                "各歩が厳密な円弧になっています。ここでは式 (6) のオイラー法、"
                "つまり theta_k の向きにまっすぐ進む式を書きましょう。",
            ),
        ),
        Mistake(
            turn_alone_used,
            Text(
                "Each step moves along its own small turn omega dt. The robot moves along the heading itself.",
                "各歩がその歩の旋回量 omega dt の向きに進んでいます。進む向きは方位そのものです。",
            ),
        ),
        Mistake(
            start_heading_ignored,
            Text(
                "The drive starts with heading 0 instead of the heading in pose0.",
                "最初の方位が pose0 の値ではなく 0 になっています。",
            ),
        ),
        Mistake(
            start_heading_added_afterwards,
            Text(
                "x and y were computed as if the drive began with heading 0, and pose0 was added afterwards. A path that "
                "starts with another heading is turned as a whole, not only shifted.",
                "x, y は最初の方位を 0 として計算し、あとから pose0 を足しています。"
                "最初の方位が違えば、経路は平行移動するだけでなく、全体が回転します。",
            ),
        ),
        Mistake(
            start_position_ignored,
            Text(
                "The path begins at the origin instead of x and y of pose0.",
                "経路が pose0 の x, y ではなく原点から始まっています。",
            ),
        ),
        Mistake(
            start_ignored,
            Text(
                "The trajectory starts at (0, 0, 0). x0, y0 and theta0 come in as pose0: use it as the first row.",
                "軌跡が (0, 0, 0) から始まっています。x0, y0, theta0 は pose0 として渡されます。最初の行に使いましょう。",
            ),
        ),
        Mistake(
            zeros_in_the_first_row,
            Text(
                "The first row is left at zero. Row 0 is the initial pose.",
                "最初の行が 0 のままです。0 行目は初期姿勢です。",
            ),
        ),
        Mistake(
            last_step_not_taken,
            Text(
                "The last row repeats the one before: the last step is not taken. How far must the loop run for N steps?",
                "最後の行が 1 つ前の行と同じで、最後の 1 歩が計算されていません。"
                "N 歩進むには、ループをどこまで回せばよいですか。",
            ),
        ),
        Mistake(
            zeros_in_the_last_row,
            Text(
                "The last row is left at zero: the loop ends one step too early.",
                "最後の行が 0 のままです。ループが 1 歩早く終わっています。",
            ),
        ),
        Mistake(
            start_row_twice,
            Text(
                "The initial pose stands in two rows, and the last step is missing: all poses come one row too late.",
                "初期姿勢が 2 行続き、最後の 1 歩がありません。姿勢が 1 行ずつ遅れています。",
            ),
        ),
        Mistake(
            last_pose_first,
            Text(
                "The rows are in the opposite order: the last pose comes first.",
                "行の順序が逆で、最後の姿勢から並んでいます。",
            ),
        ),
        Mistake(
            start_row_dropped,
            Text(
                "The initial pose is missing: there are N rows, and the first is the pose after one step already. N steps "
                "lead to N + 1 poses.",
                "初期姿勢の行がありません。N 行しかなく、最初の行がすでに 1 歩進んだ姿勢です。"
                "N 歩進むと姿勢は N + 1 個になります。",
            ),
        ),
        Mistake(
            last_row_dropped,
            Text(
                "The last pose is missing: there are N rows, from the initial pose on. N steps lead to N + 1 poses.",
                "最後の姿勢の行がありません。初期姿勢から N 行しか返っていません。N 歩進むと姿勢は N + 1 個になります。",
            ),
        ),
        Mistake(
            only_the_last_pose,
            Text(
                "Only the last pose comes back. All of them are asked for, one row each: collect them on the way.",
                "最後の姿勢だけが返っています。途中の姿勢もすべて、1 行ずつ必要です。ループの中で集めていきましょう。",
            ),
        ),
        Mistake(
            every_row_the_last_pose,
            Text(
                "All rows are the last pose. The same array was appended again and again, and changed afterwards: append a "
                "copy at each step.",
                "どの行も最後の姿勢になっています。同じ配列を何度も追加して、あとから中身を書き換えています。"
                "各歩で .copy() を追加しましょう。",
            ),
        ),
        Mistake(
            every_row_the_initial_pose,
            Text(
                "All rows are the initial pose. The new pose is computed but not kept, or the loop is never entered.",
                "どの行も初期姿勢のままです。新しい姿勢が次の歩に引き継がれていないか、ループが実行されていません。",
            ),
        ),
        Mistake(
            steps_not_added_up,
            Text(
                "The headings are added up, but x and y are not: each row holds the start plus one step alone. Each step "
                "continues from the pose before.",
                "方位は積み重なっていますが、x と y は「出発点 + その 1 歩」だけになっています。"
                "それぞれの歩は、1 つ前の姿勢から続きます。",
            ),
        ),
        Mistake(
            every_step_from_the_start,
            Text(
                "Each row is pose0 plus one step: every step starts from the initial pose again. It must start from the pose "
                "before it.",
                "どの行も「pose0 + 1 歩」になっていて、毎回初期姿勢からやり直しています。1 つ前の姿勢から続けましょう。",
            ),
        ),
        Mistake(
            turns_not_added_up,
            Text(
                "The turns are not added up: each heading is the first one plus a single turn. The heading goes on from the "
                "one before.",
                "旋回量が積み重なっていません。どの方位も「最初の方位 + その歩の旋回量」です。方位は 1 つ前の値から続きます。",
            ),
        ),
        Mistake(
            motion_returned,
            Text(
                "These are the steps, not the poses: N rows of changes. Start with pose0 and add the steps up.",
                "姿勢ではなく、各歩の変化量が N 行返っています。pose0 から始めて積み重ねていきましょう。",
            ),
        ),
        Mistake(
            motion_returned_below_the_start,
            Text(
                "Below the initial pose there are the steps, not the poses. Add the steps up, row by row.",
                "初期姿勢の下に、姿勢ではなく各歩の変化量が並んでいます。1 行ずつ積み重ねていきましょう。",
            ),
        ),
        Mistake(
            rows_and_columns_exchanged,
            Text(
                "The result lies on its side: x, y and theta are rows, shape (3, N + 1). Each pose is to be one row.",
                "結果の行と列が逆です。x, y, theta が行になり、形状が (3, N + 1) です。姿勢 1 つを 1 行にしましょう。",
            ),
        ),
        Mistake(
            reshaped_instead_of_transposed,
            Text(
                "The shape is right, but the numbers stand in the wrong places: reshape cuts the row of numbers anew, it does "
                "not turn the table. A transpose (.T) does.",
                "形状は合っていますが、数の並びが違います。reshape は数の列を切り直すだけで、行と列は入れ替わりません。"
                "入れ替えるのは転置(.T)です。",
            ),
        ),
        Mistake(
            yaw_in_the_first_column,
            Text(
                "The columns are in the order theta, x, y. A pose is (x, y, theta).",
                "列が theta, x, y の順になっています。姿勢は (x, y, theta) の順です。",
            ),
        ),
        Mistake(
            yaw_left_out,
            Text(
                "Only x and y come back, two columns. A pose is (x, y, theta).",
                "x と y の 2 列だけが返っています。姿勢は (x, y, theta) の 3 つ組です。",
            ),
        ),
        Mistake(
            time_in_the_first_column,
            Text(
                "There is a column of time as well. Only the poses (x, y, theta) are asked for, three columns.",
                "時刻の列も入っています。求めるのは姿勢 (x, y, theta) の 3 列だけです。",
            ),
        ),
        Mistake(
            heading_counted_from_y,
            Text(
                "The path is turned clockwise by a quarter turn: the heading is counted from another axis. A heading of 0 "
                "looks along +x.",
                "経路が時計回りに 1/4 回転しています。方位を測る軸が違います。方位 0 は +x の向きです。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged: the path is reflected. A heading of 0 looks along +x. (The slides on dead "
                "reckoning have the same exchange in their axes.)",
                "sin と cos が入れ替わっていて、経路が鏡映しになっています。方位 0 は +x の向きです。"
                "(デッドレコニングのスライドの式にも同じ入れ替わりがあります。)",
            ),
        ),
        Mistake(
            y_mirrored,
            Text(
                "y has the wrong sign in every step: the path is mirrored. With a heading of 90 deg (pi/2), which way does y go?",
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
                "theta is converted as if it were in degrees. It is in rad already, and np.cos takes rad.",
                "theta を度とみなして変換しています。theta はすでに rad で、np.cos も rad を受け取ります。",
            ),
        ),
        Mistake(
            converted_to_degrees_for_cos,
            Text(
                "theta is turned into degrees before cos and sin. np.cos takes rad: leave theta as it is.",
                "cos, sin に渡す前に theta を度に変換しています。np.cos は rad を受け取るので、そのまま渡しましょう。",
            ),
        ),
        Mistake(
            yaw_in_degrees,
            Text(
                "The headings come back in degrees. The course computes in rad.",
                "方位が度で返っています。この講義では rad で計算します。",
            ),
        ),
        Mistake(
            turn_subtracted,
            Text(
                "The robot turns to the wrong side: omega dt is subtracted. A positive yaw rate makes the heading grow.",
                "逆向きに回っています。omega dt を引いています。角速度が正なら方位は増えます。",
            ),
        ),
        Mistake(
            distance_subtracted,
            Text(
                "The robot moves backwards: the steps are subtracted from x and y. A positive speed is forward.",
                "ロボットが後ろへ進んでいます。x, y から移動量を引いています。速度が正なら前進です。",
            ),
        ),
        Mistake(
            stands_still_when_reversing,
            Text(
                "A robot that reverses stands still: negative speeds are replaced by 0. A negative speed is a motion backwards.",
                "後退のとき止まっています。負の速度が 0 に置き換えられています。速度が負なら後ろへ進みます。",
            ),
        ),
        Mistake(
            speed_made_positive,
            Text(
                "A robot that reverses is drawn driving forward: the sign of the speed is lost.",
                "後退しているのに前進として計算されています。速度の符号が失われています。",
            ),
        ),
        Mistake(
            turns_made_positive,
            Text(
                "Every turn becomes a turn to the left: the sign of the yaw rate is lost.",
                "どちらに回っても左旋回になっています。角速度の符号が失われています。",
            ),
        ),
        Mistake(
            next_dt_used,
            Text(
                "With an array of dt, step k is multiplied by the dt of step k + 1. Check the index of dt.",
                "dt が配列のとき、k 番目の歩に k + 1 番目の dt を掛けています。dt の添字を確かめましょう。",
            ),
        ),
        Mistake(
            dt_before_used,
            Text(
                "With an array of dt, step k is multiplied by the dt of step k - 1. Check the index of dt.",
                "dt が配列のとき、k 番目の歩に k - 1 番目の dt を掛けています。dt の添字を確かめましょう。",
            ),
        ),
        Mistake(
            mean_dt,
            Text(
                "With an array of dt its mean is used for all steps. Each step lasts its own dt_k.",
                "dt が配列のとき、すべての歩にその平均を使っています。それぞれの歩の長さは dt_k です。",
            ),
        ),
        Mistake(
            first_dt_for_all,
            Text(
                "With an array of dt its first value is used for all steps. Each step lasts its own dt_k.",
                "dt が配列のとき、すべての歩に最初の値を使っています。それぞれの歩の長さは dt_k です。",
            ),
        ),
        Mistake(
            time_for_dt,
            Text(
                "Each step is multiplied by the time since the start instead of its own dt. The steps are added up anyway.",
                "各歩に、その歩の dt ではなく出発からの時間を掛けています。積み重ねるのは移動量の方です。",
            ),
        ),
        Mistake(
            always_10_milliseconds,
            Text(
                "The result is the same whatever dt is: 0.01 s is written into the function. Use the argument dt.",
                "dt を変えても結果が変わりません。関数の中に 0.01 秒と書き込まれています。引数の dt を使いましょう。",
            ),
        ),
        Mistake(
            always_5_milliseconds,
            Text(
                "The result is the same whatever dt is: 0.005 s is written into the function. Use the argument dt.",
                "dt を変えても結果が変わりません。関数の中に 0.005 秒と書き込まれています。引数の dt を使いましょう。",
            ),
        ),
        Mistake(
            first_step_at_rest,
            Text(
                "Nothing happens in the first step, and each later step uses the sample before it: the samples come one step "
                "too late. Eq. (6) uses sample k in step k.",
                "最初の歩で動かず、その後も 1 つ前の値を使っています。速度と角速度が 1 歩ずつ遅れています。"
                "式 (6) では k 番目の歩に k 番目の値を使います。",
            ),
        ),
        Mistake(
            next_sample_used,
            Text(
                "Step k uses the speed and yaw rate of sample k + 1. Eq. (6) uses those of sample k.",
                "k 番目の歩に、k + 1 番目の速度と角速度を使っています。式 (6) では k 番目の値を使います。",
            ),
        ),
        Mistake(
            sample_before_used,
            Text(
                "Step k uses the speed and yaw rate of sample k - 1. Eq. (6) uses those of sample k.",
                "k 番目の歩に、k - 1 番目の速度と角速度を使っています。式 (6) では k 番目の値を使います。",
            ),
        ),
        Mistake(
            first_sample_for_all,
            Text(
                "All steps use the first speed and yaw rate. Look at the index of velocity and yaw_rate in the loop.",
                "すべての歩に最初の速度と角速度を使っています。ループの中で velocity と yaw_rate の添字を確かめましょう。",
            ),
        ),
        Mistake(
            neighbours_averaged,
            Text(
                "Neighbouring samples are averaged. That is a trapezoid rule; eq. (6) uses the values of sample k alone.",
                "隣り合う値を平均しています。これは台形則です。式 (6) では k 番目の値だけを使います。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With a pose0 of whole numbers the decimals are cut off in every step: the result takes the dtype of pose0. "
                "Make the array with dtype=float.",
                "pose0 が整数で渡されると、毎回小数部分が切り捨てられます。結果の配列が pose0 と同じ整数になっています。"
                "dtype=float の配列を作りましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded. Thousands of steps follow one another: round only for display.",
                "結果が丸められています。何千歩も積み重ねるので、丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            arrays_only,
            Text(
                "With lists the function stops with a TypeError: a list cannot be computed with as an array can. Turn the "
                "inputs into arrays first, np.asarray(..., dtype=float).",
                "リストを渡すと TypeError で止まります。リストは配列のようには計算できません。"
                "最初に np.asarray(..., dtype=float) で配列にしましょう。",
            ),
        ),
        Mistake(
            attributes_of_arrays_only,
            Text(
                "With lists the function stops with an AttributeError: a list has no .size, .shape or .copy as an array has. "
                "Use len(...), or turn the inputs into arrays first.",
                "リストを渡すと AttributeError で止まります。リストには配列のような .size や .shape がありません。"
                "len(...) を使うか、最初に配列に変換しましょう。",
            ),
        ),
        Mistake(
            dt_must_be_an_array,
            Text(
                "Where dt is a single number the function stops with a TypeError: a number has no entries and no length. "
                "np.ones(N) * dt makes an array of either.",
                "dt が数値 1 個のとき、TypeError で止まります。数値には要素も長さもありません。"
                "np.ones(N) * dt とすれば、どちらでも配列になります。",
            ),
        ),
        Mistake(
            dt_must_be_a_number,
            Text(
                "Where dt is an array the function stops. Each step has its own dt then: take the entry that belongs to the "
                "step.",
                "dt が配列のとき、途中で止まります。そのときは各歩に自分の dt があります。その歩の要素を取り出しましょう。",
            ),
        ),
        Mistake(
            whole_dt_in_every_step,
            Text(
                "Where dt is an array the function stops: the whole array dt was used in one step. Each step has its own dt "
                "then: take the entry that belongs to the step.",
                "dt が配列のとき、途中で止まります。1 歩の計算に dt の配列全体を使っています。その歩の要素を取り出しましょう。",
            ),
        ),
    ),
)
