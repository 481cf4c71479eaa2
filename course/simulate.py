"""A differential-drive robot that leaves an encoder log and knows where it really went.

**Which way is left?** A motion is described physically: a positive yaw rate of a segment turns the robot to the left,
counter-clockwise as seen from above, whichever robot it is. The truth is written in the convention of the robot's
tread: with a positive tread theta counts counter-clockwise and y points to the left of x; with a negative tread theta
counts clockwise and y points to the right. So V = (v_r + v_l) / 2 and omega = (v_r - v_l) / tread, with the tread's
sign kept, integrate to the truth of every robot.
"""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from course.logs import FloatArray, Log
from course.robots import Robot

ENCODER_HEADER = "# Time [s], Encoder Counter1 (incremental difference), Encoder Counter2 (incremental difference), PWM1, PWM2"
TRUTH_HEADER = "# Time [s], x [m], y [m], theta [rad], velocity [m/s], yaw rate [rad/s]"

SUBSTEPS = 10
"""Exact arcs in one sampling period; at 5 ms and 0.4 s of ramp ten of them leave errors far below a micrometre."""

LARGEST_JITTER = 0.4
"""No stamp strays by more than this part of a period, so stamps always increase."""

LOST_AT_MOST = 0.3
"""No larger part of the cycles can be lost in gaps of one or two: each gap needs a slot of four rows for itself."""

PWM_PER_SPEED = 40.0
PWM_NOISE = 2


class Segment(NamedTuple):
    """A stretch of motion: forward velocity [m/s], yaw rate [rad/s, positive to the left], duration [s]."""

    velocity: float
    yaw_rate: float
    duration: float


class Slip(NamedTuple):
    """A moment in which wheels turn on the floor: start and duration [s], and what each rim gains on the floor [m].

    The counters see the gain, the robot does not move by it; a negative gain is a wheel that is dragged along.
    """

    start: float
    duration: float
    right: float = 0.0
    left: float = 0.0


@dataclass(frozen=True)
class Conditions:
    """How a run is carried out and recorded.

    - `period`: nominal sampling period [s]
    - `jitter`: standard deviation of the sampling instants [s]; counts and stamp are taken at the same instant
    - `start`: stamp of the first row [s], such as Unix time
    - `ramp`: time [s] that a change of speed takes at the beginning of a segment
    - `radius_right`, `radius_left`: true radii of the wheels [m] where they differ from the robot's nominal one
    - `tread`: true distance [m, a length without sign] between the wheels where it differs from the nominal one
    - `slip`: a moment in which wheels slip
    - `lost`: part of the cycles that are lost in gaps of one and two cycles, as many gaps of one as of two; what the
      wheels did in a lost cycle is in no row
    - `long_gap`: how many cycles are lost at once, on top of these, in the middle of the drive

    Raises ValueError if period, ramp, a radius, the tread or the duration of a slip is not positive, if jitter or
    long_gap is negative, or if more is lost than `LOST_AT_MOST`.
    """

    period: float = 0.005
    jitter: float = 0.0
    start: float = 0.0
    ramp: float = 0.4
    radius_right: float | None = None
    radius_left: float | None = None
    tread: float | None = None
    slip: Slip | None = None
    lost: float = 0.0
    long_gap: int = 0

    def __post_init__(self) -> None:
        """Refuse what cannot be recorded."""
        for name in ("period", "ramp", "radius_right", "radius_left", "tread"):
            value = getattr(self, name)
            if value is not None and not 0 < value < np.inf:
                raise ValueError(f"{name} must be positive and finite, not {value!r}")
        for name, most in (("jitter", np.inf), ("lost", LOST_AT_MOST), ("long_gap", np.inf)):
            value = getattr(self, name)
            if not 0 <= value <= most or np.isinf(value):
                raise ValueError(f"{name} must be finite, not negative and at most {most}, not {value!r}")
        if self.slip and not (np.isfinite(self.slip).all() and self.slip.duration > 0):
            raise ValueError(f"slip must be finite and last a positive time, not {self.slip!r}")

    @property
    def faithful(self) -> bool:
        """Whether odometry with the nominal robot follows the truth, but for the rounding to whole counts."""
        true_sizes = (self.radius_right, self.radius_left, self.tread)
        return all(size is None for size in true_sizes) and self.slip is None and not self.lost and not self.long_gap


NOMINAL = Conditions()


@dataclass(frozen=True)
class EncoderRun:
    """What a drive leaves behind: the log as `read_encoder_log` gives it, the truth as `read_truth` gives it."""

    log: Log
    truth: Log


def encoder_run(robot: Robot, segments: Sequence[Segment], seed: int, conditions: Conditions = NOMINAL) -> EncoderRun:
    """Return the log and the truth of `robot` driving `segments`, starting at rest at the pose (0, 0, 0).

    Speeds change smoothly at the beginning of each segment, as much being lost before as is won after: a drive that
    ends with a segment of rest covers the sum of velocity times duration and turns by the sum of yaw rate times
    duration. Rows are one period apart; row 0 is the first stamp, with no counts. The counters round the travel of
    the wheels, not each increment, so no fraction of a count is ever lost. Velocity and yaw rate of the truth are
    those at the stamp, not means over the row's interval.

    Only jitter, PWM and lost cycles are drawn from `seed`; rows 0 and -1 are never lost. Raises ValueError if there is no segment, if one is not finite, or if
    one is shorter than the ramp.
    """
    rng = np.random.default_rng(seed)
    plan = _plan(segments, conditions.ramp)
    elapsed = _sampling_instants(float(plan[:, 2].sum()), conditions, rng)
    speeds, travel = _motion(elapsed, plan, conditions.ramp)
    time = conditions.start + elapsed
    x, y = _positions(elapsed, plan, conditions.ramp).T
    turn = np.sign(robot.tread)
    truth = {
        "time": time,
        "x": x,
        "y": turn * y,
        "theta": turn * travel[:, 1],
        "velocity": speeds[:, 0],
        "yaw_rate": turn * speeds[:, 1],
    }
    wheels = _to_wheels(robot, conditions)
    rims = travel @ wheels + _slipped(elapsed, conditions.slip)
    log = {"time": time, **_counters(robot, speeds @ wheels, rims, conditions, rng)}
    kept = ~_lost_rows(len(elapsed), conditions, rng)
    return EncoderRun(_chosen_rows(log, kept), _chosen_rows(truth, kept))


def steered_by_odometry(robot: Robot, segments: Sequence[Segment], conditions: Conditions) -> tuple[Segment, ...]:
    """Return what the robot really drives when it steers by nominal numbers and believes that it drives `segments`.

    Its wheels turn as the nominal radius and tread ask for; true radii and tread make another motion of that. So the
    odometry of `encoder_run(robot, steered_by_odometry(robot, segments, conditions), seed, conditions)` is `segments`.
    """
    plan = np.array(segments, dtype=np.float64).reshape(-1, 3)
    rims = plan[:, :2] @ _to_wheels(robot, NOMINAL) * _true_radii(robot, conditions) / robot.radius
    driven = rims @ np.linalg.inv(_to_wheels(robot, conditions))
    return tuple(Segment(*row) for row in np.column_stack([driven, plan[:, 2]]).tolist())


def encoder_log_text(log: Log) -> str:
    """Return an encoder log as the text of its file, in the format and with the header of the slides.

    Stamps have microseconds, counters are integers. Source: slides 000, practical training with wheel odometry.
    """
    table = np.column_stack([log[name] for name in ("time", "counter1", "counter2", "pwm1", "pwm2")])
    return _csv_text(ENCODER_HEADER, "%.6f,%d,%d,%g,%g", table)


def truth_text(truth: Log) -> str:
    """Return a truth as the text of its file: a header comment, then six columns with six decimals."""
    table = np.column_stack([truth[name] for name in ("time", "x", "y", "theta", "velocity", "yaw_rate")])
    # Rounding first and adding zero turns -0.000000, whose sign hangs on the last bit, into 0.000000.
    return _csv_text(TRUTH_HEADER, ",".join(["%.6f"] * table.shape[1]), np.round(table, 6) + 0.0)


def write_encoder_log(path: str | os.PathLike[str], log: Log) -> None:
    """Write an encoder log in the format of the slides; see `encoder_log_text`."""
    Path(path).write_bytes(encoder_log_text(log).encode())


def write_truth(path: str | os.PathLike[str], truth: Log) -> None:
    """Write a truth file; see `truth_text`."""
    Path(path).write_bytes(truth_text(truth).encode())


def _csv_text(header: str, row_format: str, table: FloatArray) -> str:
    return "\n".join([header, *(row_format % tuple(row) for row in table.tolist()), ""])


def _plan(segments: Sequence[Segment], ramp: float) -> FloatArray:
    plan = np.array(segments, dtype=np.float64).reshape(-1, 3)
    if not len(plan) or not np.isfinite(plan).all():
        raise ValueError("a drive needs at least one segment, and finite velocities, yaw rates and durations")
    if (plan[:, 2] < ramp).any():
        raise ValueError(f"every segment must last at least as long as the ramp, {ramp} s")
    return plan


def _sampling_instants(duration: float, conditions: Conditions, rng: np.random.Generator) -> FloatArray:
    # A rounding error must not cost the last row, nor may an instant differ from what six decimals can say.
    nominal = conditions.period * np.arange(int(duration / conditions.period + 1e-6) + 1)
    limit = LARGEST_JITTER * conditions.period
    jitter = np.clip(rng.normal(0.0, conditions.jitter, len(nominal)), -limit, limit)
    jitter[0] = 0.0
    return np.round(nominal + jitter, 6)


def _motion(elapsed: FloatArray, plan: FloatArray, ramp: float) -> tuple[FloatArray, FloatArray]:
    """Return speeds and travel at the instants, both (N, 2): forward [m/s, m] and to the left [rad/s, rad].

    A speed changes by 3 u^2 - 2 u^3, u running from 0 to 1 along the ramp; its integral u^3 - u^4 / 2 is exact.
    """
    levels = np.vstack([np.zeros(2), plan[:, :2]])
    before, change, durations = levels[:-1], np.diff(levels, axis=0), plan[:, 2:]
    gained = before * durations + change * (durations - ramp / 2)
    starts = np.cumsum(durations[:, 0]) - durations[:, 0]
    done = np.cumsum(gained, axis=0) - gained
    now = np.searchsorted(starts, elapsed, side="right") - 1
    into = (elapsed - starts[now])[:, np.newaxis]
    u = np.clip(into / ramp, 0.0, 1.0)
    speeds = before[now] + change[now] * (3 * u**2 - 2 * u**3)
    ramped = ramp * (u**3 - u**4 / 2) + np.maximum(into - ramp, 0.0)
    return speeds, done[now] + before[now] * into + change[now] * ramped


def _positions(elapsed: FloatArray, plan: FloatArray, ramp: float) -> FloatArray:
    """Return x and y at the instants, (N, 2), y to the left: a chain of exact arcs, `SUBSTEPS` to a row."""
    parts = np.diff(elapsed)[:, np.newaxis] * np.arange(SUBSTEPS) / SUBSTEPS
    fine = np.append((elapsed[:-1, np.newaxis] + parts).ravel(), elapsed[-1])
    _, travel = _motion(fine, plan, ramp)
    arc, turned = np.diff(travel, axis=0).T
    heading = travel[:-1, 1] + turned / 2
    chord = arc * np.sinc(turned / (2 * np.pi))
    steps = np.column_stack([chord * np.cos(heading), chord * np.sin(heading)])
    return np.vstack([np.zeros((1, 2)), np.cumsum(steps, axis=0)])[::SUBSTEPS]


def _to_wheels(robot: Robot, conditions: Conditions) -> FloatArray:
    """Return the (2, 2) matrix that turns (forward, to the left) into (right wheel, left wheel)."""
    tread = conditions.tread or abs(robot.tread)
    return np.array([[1.0, 1.0], [tread / 2, -tread / 2]])


def _true_radii(robot: Robot, conditions: Conditions) -> FloatArray:
    return np.array([conditions.radius_right or robot.radius, conditions.radius_left or robot.radius])


def _slipped(elapsed: FloatArray, slip: Slip | None) -> FloatArray:
    """Return what the right and the left rim have gained on the floor so far [m], (N, 2); it grows smoothly."""
    if slip is None:
        return np.zeros((len(elapsed), 2))
    u = np.clip((elapsed - slip.start) / slip.duration, 0.0, 1.0)
    return np.outer(3 * u**2 - 2 * u**3, [slip.right, slip.left])


def _counters(robot: Robot, speeds: FloatArray, rims: FloatArray, conditions: Conditions, rng: np.random.Generator) -> Log:
    """Return the four columns beside the time; speeds and travel of the rims are those of the right and left wheel."""
    signs = np.array([robot.sign_right, robot.sign_left])
    counts = rims / (2 * np.pi * _true_radii(robot, conditions)) * robot.gear * robot.counts_per_rev
    increments: FloatArray = signs * np.diff(np.rint(counts), axis=0, prepend=0.0)
    noise = rng.integers(-PWM_NOISE, PWM_NOISE, size=speeds.shape, endpoint=True)
    pwm: FloatArray = signs * np.rint(PWM_PER_SPEED * speeds) + noise
    first, second = (0, 1) if robot.right_counter == 1 else (1, 0)
    # Adding zero turns the -0.0 of a reversed counter at rest into 0.0.
    return {
        "counter1": increments[:, first] + 0.0,
        "counter2": increments[:, second] + 0.0,
        "pwm1": pwm[:, first] + 0.0,
        "pwm2": pwm[:, second] + 0.0,
    }


def _lost_rows(rows: int, conditions: Conditions, rng: np.random.Generator) -> npt.NDArray[np.bool_]:
    """Return which rows are lost: gaps of one or two in slots of four rows, of which the last one is always kept."""
    slots = (rows - 1) // 4
    gaps = min(slots, round(conditions.lost * rows / 1.5))
    firsts = 4 * rng.choice(slots, gaps, replace=False) + rng.integers(1, 3, gaps)
    lost = np.zeros(rows, dtype=bool)
    lost[firsts] = True
    lost[firsts[::2] + 1] = True
    lost[rows // 2 : rows // 2 + conditions.long_gap] = True
    lost[-1] = False
    return lost


def _chosen_rows(log: Log, rows: npt.NDArray[np.bool_]) -> Log:
    return {name: column[rows] for name, column in log.items()}
