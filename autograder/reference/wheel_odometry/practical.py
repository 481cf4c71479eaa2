"""What the three graphs of the practical must show: the odometry of the log that the notebook loads (slides 000)."""

from functools import cache

import numpy as np

from autograder.reference.wheel_odometry.wheel_odometry import reference
from course.logs import REPOSITORY_DATA, read_encoder_log
from course.robots import ICART

LOG = "encoder_practical.dat"


def practical_odometry() -> dict[str, np.ndarray]:
    """Return time, x, y, theta, velocity and yaw_rate of the practical's drive, copies of one computation."""
    return {key: values.copy() for key, values in _odometry().items()}


@cache
def _odometry() -> dict[str, np.ndarray]:
    record: dict[str, np.ndarray] = reference(read_encoder_log(REPOSITORY_DATA / LOG), ICART)
    return record
