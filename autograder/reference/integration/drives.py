"""What the integrations of poses are tried with: drives with uneven times, on which no two rules give the same."""

import numpy as np

from autograder.draws import magnitudes, until
from autograder.exercise import Group
from course.language import Text


def sampled_drives(rng):
    """Return the groups of cases (t, velocity, yaw_rate, pose0)."""

    def drive(count, forward, left, start=None):
        """Draw a drive; no two samples and no two steps are alike."""
        steps = rng.permuted(np.linspace(0.25, 0.6, count)) + rng.uniform(-0.02, 0.02, count)
        t = np.cumsum(steps) + (magnitudes(rng, 1.0, 3.0) if start is None else start)
        velocity = np.resize(forward, count) * rng.permuted(np.linspace(0.5, 1.6, count) + rng.uniform(-0.05, 0.05, count))
        yaw_rate = np.resize(left, count) * rng.permuted(np.linspace(0.5, 1.4, count) + rng.uniform(-0.05, 0.05, count))
        x, y = magnitudes(rng, 0.5, 3.0, 2)
        return t, velocity, yaw_rate, np.array([x, y, rng.uniform(0.3, 2.8)])

    def between_0_and_pi(t, velocity, yaw_rate, pose0):
        """Tell whether no rule leaves the headings that wrapping does not change."""
        dt, w = np.diff(t), yaw_rate
        headings = [pose0[2] + np.append(0, np.cumsum(rate * dt)) for rate in (w[:-1], w[1:], (w[:-1] + w[1:]) / 2)]
        return np.min(headings) > 0.1 and np.max(headings) < 3.0

    def path(count, forward=1, left=(1, 1, -1, -1), start=None):
        return until(lambda: drive(count, forward, left, start), between_0_and_pi)

    def across_pi(side):
        t, velocity, yaw_rate, pose0 = drive(5, 1, side)
        pose0[2] = side * (np.pi - rng.uniform(0.2, 0.5))
        return t, velocity, yaw_rate, pose0

    def whole():
        velocity, yaw_rate = rng.permutation([3, -2, 1, 2, 4]), rng.permutation([-2, 1, 2, 1, -1])
        t = rng.choice([-2, 3]) + np.cumsum([0, *rng.permutation([1, 2, 1, 3])])
        return t, velocity, yaw_rate, np.array([*rng.choice([-4, -3, 3, 4], 2), 2])

    listed = path(rng.choice([4, 6]))
    stamps = 1.6e9 + rng.uniform(0, 1e6)
    return [
        Group(Text("uneven times", "間隔の一定でない時刻"), 4, [path(count) for count in (5, 7)]),
        Group(Text("one sample or two", "1 点または 2 点"), 1, [path(1), path(2, left=1), path(2, left=-1)]),
        Group(
            Text("reversing, turning right", "後退と右旋回"),
            1,
            [until(lambda: drive(5, [-1, -1, 1, -1, 1], -1), between_0_and_pi)],
        ),
        Group(Text("headings beyond half a turn", "半回転を超える方位"), 1, [across_pi(side) for side in (-1, 1)]),
        Group(Text("Unix time stamps", "Unix 時刻"), 1, [path(5, start=stamps)]),
        Group(Text("lists", "リストの入力"), 1, [tuple(part.tolist() for part in listed)]),
        Group(Text("whole numbers", "整数の入力"), 1, [whole()]),
    ]


def driven_increments(rng):
    """Return the groups of cases (distance, dtheta, pose0)."""

    def drive(count, forward, left):
        """Draw a drive; no two increments are alike."""
        distance = np.resize(forward, count) * rng.permuted(np.linspace(0.3, 1.0, count) + rng.uniform(-0.03, 0.03, count))
        dtheta = np.resize(left, count) * rng.permuted(np.linspace(0.25, 0.7, count) + rng.uniform(-0.03, 0.03, count))
        x, y = magnitudes(rng, 0.5, 3.0, 2)
        return distance, dtheta, np.array([x, y, rng.uniform(0.3, 2.8)])

    def between_0_and_pi(distance, dtheta, pose0):
        headings = pose0[2] + np.append(0, np.cumsum(dtheta))
        return headings.min() > 0.1 and headings.max() < 3.0

    def path(count, forward=1, left=(1, 1, -1, -1)):
        return until(lambda: drive(count, forward, left), between_0_and_pi)

    def across_pi(side):
        distance, dtheta, pose0 = drive(5, 1, side)
        pose0[2] = side * (np.pi - rng.uniform(0.2, 0.5))
        return distance, dtheta, pose0

    whole = rng.permutation([3, -2, 1, 2]), rng.permutation([-2, 1, 2, 1]), np.array([*rng.choice([-4, -3, 3, 4], 2), 2])
    listed = path(rng.choice([4, 6]))
    return [
        Group(Text("gentle and sharp turns", "緩急さまざまな旋回"), 4, [path(count) for count in (4, 6)]),
        Group(Text("one increment or two", "増分が 1 つまたは 2 つ"), 1, [path(1, left=1), path(1, left=-1), path(2, left=1)]),
        Group(Text("reversing, turning right", "後退と右旋回"), 1, [path(5, [-1, -1, 1, -1, 1], -1)]),
        Group(Text("headings beyond half a turn", "半回転を超える方位"), 1, [across_pi(side) for side in (-1, 1)]),
        Group(Text("lists", "リストの入力"), 1, [tuple(part.tolist() for part in listed)]),
        Group(Text("whole numbers", "整数の入力"), 1, [whole]),
    ]
