"""The hidden module: right answers, cases and misconceptions, one file for each exercise. No student ever gets it.

`NOTEBOOKS` is the table of contents; the exercise `pose_step` of `odometry/pose_update` is `EXERCISE` in
`autograder/reference/pose_update/pose_step.py`.
"""

from functools import cache
from importlib import import_module

from autograder.exercise import Exercise, GraphExercise

NOTEBOOKS: dict[str, tuple[str, ...]] = {
    "odometry/pose_update": (
        "pose_step",
        "q1_symbolic",
        "planar_rotation",
        "pose_step_matrix",
        "displacement",
        "pose_step_midpoint",
        "pose_step_arc",
        "dead_reckoning",
    ),
    "odometry/encoders": (
        "quadrature_count",
        "wheel_angle",
        "wheel_speed",
        "body_velocity",
        "body_velocity_matrix",
        "count_increments",
        "distance_per_count",
        "speed_resolution",
        "wheel_signs",
    ),
    "odometry/integration": (
        "euler_integral",
        "trapezoid_integral",
        "cumulative_euler",
        "cumulative_trapezoid",
        "observed_order",
        "convergence_axes",
        "integrate_poses_euler",
        "integrate_poses_trapezoid",
        "integrate_increments",
    ),
    "odometry/frames": (
        "compose",
        "invert",
        "express_in",
        "points_to_parent",
        "set_pos_gl",
        "adjust_pos_gl",
        "line_command_changes",
        "from_compass",
        "to_compass",
        "wrap_angle",
    ),
    "odometry/wheel_odometry": (
        "read_encoder_log",
        "wheel_odometry",
        "xy_axes",
        "yaw_axes",
        "speed_axes",
        "recover_lost_counts",
        "closing_error",
        "umbmark",
    ),
}

#: written answers, graded by hand with the rubric in the notebook's source
WRITTEN: dict[str, tuple[str, ...]] = {
    "odometry/pose_update": ("q1_derivation",),
    "odometry/wheel_odometry": ("odometry_discussion",),
}


@cache
def exercise_named(name: str) -> Exercise | GraphExercise:
    """Return the exercise `name`; KeyError, with the names there are, if it does not exist."""
    for notebook, names in NOTEBOOKS.items():
        if name in names:
            exercise: Exercise | GraphExercise = import_module(_module(notebook, name)).EXERCISE
            return exercise
    known = ", ".join(name for names in NOTEBOOKS.values() for name in names)
    raise KeyError(f"no exercise is called {name!r}; there are: {known}")


def exercise_modules() -> list[str]:
    """Return the names of the modules of all exercises."""
    return [_module(notebook, name) for notebook, names in NOTEBOOKS.items() for name in names]


def _module(notebook: str, name: str) -> str:
    return f"{__name__}.{notebook.rpartition('/')[2]}.{name}"


def all_exercises() -> list[Exercise | GraphExercise]:
    """Return every exercise in the order of the course."""
    return [exercise_named(name) for names in NOTEBOOKS.values() for name in names]
