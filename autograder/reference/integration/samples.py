"""What the two cumulative integrals are tried with: samples at uneven times, on which no two rules give the same."""

import numpy as np

from autograder.draws import magnitudes
from autograder.exercise import Group
from course.language import Text


def sample_groups(rng):
    """Return the groups of cases (y, t) and (y, t, initial) of both cumulative integrals."""

    def samples(count, start=None):
        """Draw values of both signs, no two alike, and times with steps of different lengths."""
        y = rng.permuted(np.linspace(0.6, 2.4, count) + rng.uniform(-0.1, 0.1, count)) * np.resize([1, -1, 1, 1], count)
        steps = rng.permuted(np.linspace(0.2, 0.6, count) + rng.uniform(-0.02, 0.02, count))
        return y, np.cumsum(steps) + (magnitudes(rng, 1.0, 3.0) if start is None else start)

    def whole(count):
        y = rng.permutation([3, -2, 4, 1, 5, -3, 2])[:count]
        return y, rng.choice([-2, 3]) + np.cumsum([0, *rng.permutation([1, 2, 3, 1, 2, 3])[: count - 1]])

    def initial():
        return magnitudes(rng, 0.5, 2.0)

    y, t = samples(rng.choice([4, 6]))
    start = int(rng.choice([-2, 3]))
    stamps = 1.6e9 + rng.uniform(0, 1e6)
    return [
        Group(Text("initial left out", "initial を省略"), 3, [samples(5), samples(7)]),
        Group(Text("initial given", "initial を指定"), 3, [(*samples(4), initial()), (*samples(6), initial())]),
        Group(Text("one sample or two", "1 点または 2 点"), 1, [(*samples(1), initial()), samples(1), (*samples(2), initial())]),
        Group(Text("Unix time stamps", "Unix 時刻"), 1, [(*samples(5, stamps), initial())]),
        Group(Text("lists", "リストの入力"), 1, [(y.tolist(), t.tolist(), initial())]),
        Group(Text("whole numbers", "整数の入力"), 1, [(*whole(6), start), (whole(7)[0], samples(7)[1], start)]),
    ]
