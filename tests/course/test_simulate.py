"""The simulator: its log, integrated by a rule of our own, reaches its truth; no count is lost; left is left."""

from dataclasses import replace

import numpy as np
import pytest

from course.logs import read_encoder_log, read_truth
from course.robots import BEEGO, ICART
from course.simulate import (
    Conditions,
    Segment,
    Slip,
    encoder_log_text,
    encoder_run,
    steered_by_odometry,
    truth_text,
    write_encoder_log,
    write_truth,
)
from tests.odometry import allowed_by_quantisation, metres_per_count, midpoint_odometry, wheel_counts

REST = Segment(0.0, 0.0, 1.0)
WINDING = (REST, Segment(0.5, 0.8, 3.0), Segment(-0.3, 0.4, 2.0), Segment(0.0, -1.5, 2.5), Segment(0.6, -0.7, 3.0), REST)
LEFT = (Segment(0.4, 0.0, 3.0), Segment(0.4, 0.5, 3.0), REST)
SWAPPED = replace(BEEGO, name="swapped", right_counter=2, sign_right=1, sign_left=1, tread=-0.2765)
ROBOTS = pytest.mark.parametrize("robot", [ICART, BEEGO, SWAPPED], ids=lambda robot: robot.name)


def truth_poses(run):
    return np.column_stack([run.truth["x"], run.truth["y"], run.truth["theta"]])


@ROBOTS
@pytest.mark.parametrize("conditions", [Conditions(), Conditions(jitter=0.001, start=1.7e9)], ids=["nominal", "jitter"])
def test_integrating_the_log_reaches_the_truth_within_quantisation(robot, conditions):
    run = encoder_run(robot, WINDING, seed=0, conditions=conditions)
    error = np.abs(midpoint_odometry(run.log, robot) - truth_poses(run)).max(axis=0)
    position, heading = allowed_by_quantisation(run.log, robot)
    assert error[2] <= heading
    assert (error[:2] <= position).all()


@ROBOTS
def test_the_truth_turns_as_the_tread_says(robot):
    """The robot physically turns left; only a robot of positive tread calls that positive."""
    run = encoder_run(robot, LEFT, seed=0)
    sign = 1 if robot.tread > 0 else -1
    assert run.truth["theta"][-1] == pytest.approx(sign * 1.5)
    assert run.truth["y"][-1] * sign > 0.4
    assert run.truth["yaw_rate"][800] == pytest.approx(sign * 0.5)


@ROBOTS
def test_wheels_count_forward_and_the_right_one_is_faster_to_the_left(robot):
    right, left = wheel_counts(encoder_run(robot, LEFT, seed=0).log, robot)
    assert (right[200:500] > 0).all()
    np.testing.assert_array_equal(right[:500], left[:500])
    assert (right[700:1100] > left[700:1100] + 10).all()


def test_counters_of_the_two_robots_run_against_each_other():
    for robot, counter in ((ICART, "counter1"), (BEEGO, "counter2")):
        log = encoder_run(robot, LEFT, seed=0).log
        assert log[counter].sum() > 0
        assert log["counter1"][300] == -log["counter2"][300] != 0


@pytest.mark.parametrize(("speed", "duration"), [(0.0007, 20.0), (0.0007, 20.005), (0.00123, 30.0)])
def test_no_fraction_of_a_count_is_lost_at_a_crawl(speed, duration):
    """At these speeds most rows hold no count or one, so rounding each row would lose or double the travel."""
    log = encoder_run(ICART, (Segment(speed, 0.0, duration), REST), seed=0).log
    assert np.abs(log["counter1"]).max() <= 1
    assert log["counter1"].sum() == round(speed * duration / metres_per_count(ICART))
    assert (log["counter1"] == log["counter1"].astype(int)).all()


@ROBOTS
def test_at_rest_at_the_end_the_drive_is_as_long_as_its_segments_say(robot):
    run = encoder_run(robot, WINDING, seed=0)
    right, left = wheel_counts(run.log, robot)
    assert (right + left).sum() / 2 * metres_per_count(robot) == pytest.approx(2.7, abs=metres_per_count(robot))
    assert abs(run.truth["theta"][-1]) == pytest.approx(abs(3 * 0.8 + 2 * 0.4 - 2.5 * 1.5 - 3 * 0.7))
    assert run.truth["velocity"][-1] == run.truth["yaw_rate"][-1] == 0


def test_a_circle_at_constant_speed_is_the_circle_of_geometry():
    run = encoder_run(BEEGO, (Segment(0.5, 0.25, 25.0), REST), seed=0)
    assert np.hypot(run.truth["x"], run.truth["y"] - 2.0) == pytest.approx(2.0, abs=1e-9)


def test_positions_do_not_hang_on_the_sampling_period():
    """Exact arcs: ten times finer steps move the truth by less than the truth file can show."""
    coarse = truth_poses(encoder_run(BEEGO, WINDING, seed=0))
    fine = truth_poses(encoder_run(BEEGO, WINDING, seed=0, conditions=Conditions(period=0.0005)))
    np.testing.assert_allclose(coarse, fine[::10], rtol=0, atol=1e-7)


def test_speeds_are_the_rates_of_the_poses_and_change_smoothly():
    truth = encoder_run(BEEGO, WINDING, seed=0).truth
    forward = np.diff(truth["x"]) * np.cos(truth["theta"][:-1]) + np.diff(truth["y"]) * np.sin(truth["theta"][:-1])
    assert np.diff(truth["theta"]) / 0.005 == pytest.approx((truth["yaw_rate"][1:] + truth["yaw_rate"][:-1]) / 2, abs=1e-3)
    assert forward / 0.005 == pytest.approx((truth["velocity"][1:] + truth["velocity"][:-1]) / 2, abs=1e-3)
    assert np.abs(np.diff(truth["velocity"])).max() <= 1.5 * 0.8 / 0.4 * 0.005 + 1e-9


def test_stamps():
    nominal = encoder_run(ICART, LEFT, seed=3).log["time"]
    np.testing.assert_allclose(nominal, np.arange(1401) * 0.005, rtol=0, atol=1e-9)
    run = encoder_run(ICART, LEFT, seed=3, conditions=Conditions(jitter=0.002, start=1.7e9, period=0.01))
    steps = np.diff(run.log["time"])
    assert run.log["time"][0] == 1.7e9
    assert steps.min() > 0
    assert steps.std() > 0.001
    assert steps.mean() == pytest.approx(0.01, rel=1e-2)
    np.testing.assert_array_equal(run.log["time"], run.truth["time"])


def test_row_0_is_the_pose_at_the_first_stamp():
    run = encoder_run(ICART, LEFT, seed=0, conditions=Conditions(start=1.7e9, jitter=0.001))
    assert {name: column[0] for name, column in run.truth.items() if name != "time"} == dict.fromkeys(
        ["x", "y", "theta", "velocity", "yaw_rate"], 0
    )
    assert run.log["counter1"][0] == run.log["counter2"][0] == 0


@pytest.mark.parametrize(("radius_right", "radius_left"), [(0.14533, None), (None, 0.14533), (0.15, 0.15)])
def test_true_radii_change_the_counts_and_not_the_truth(radius_right, radius_left):
    nominal = encoder_run(ICART, LEFT, seed=0)
    run = encoder_run(ICART, LEFT, seed=0, conditions=Conditions(radius_right=radius_right, radius_left=radius_left))
    np.testing.assert_array_equal(truth_poses(run), truth_poses(nominal))
    ratios = [
        new.sum() / old.sum() for new, old in zip(wheel_counts(run.log, ICART), wheel_counts(nominal.log, ICART), strict=True)
    ]
    expected = [ICART.radius / (radius or ICART.radius) for radius in (radius_right, radius_left)]
    assert ratios == pytest.approx(expected, abs=2e-5)


@ROBOTS
def test_a_true_tread_changes_the_difference_of_the_counts_and_not_the_truth(robot):
    nominal = encoder_run(robot, LEFT, seed=0)
    run = encoder_run(robot, LEFT, seed=0, conditions=Conditions(tread=1.02 * abs(robot.tread)))
    np.testing.assert_array_equal(truth_poses(run), truth_poses(nominal))
    (right, left), (old_right, old_left) = (wheel_counts(log, robot) for log in (run.log, nominal.log))
    assert (right + left).sum() == pytest.approx((old_right + old_left).sum(), abs=2)
    assert (right - left).sum() == pytest.approx(1.02 * (old_right - old_left).sum(), abs=2)


@ROBOTS
@pytest.mark.parametrize("slip", [Slip(2.0, 0.3, right=0.03), Slip(2.0, 0.3, left=-0.02), Slip(4.0, 1.0, 0.01, 0.02)])
def test_a_slip_adds_counts_while_it_lasts_and_leaves_the_truth_alone(robot, slip):
    nominal, run = (encoder_run(robot, LEFT, seed=0, conditions=Conditions(slip=one)) for one in (None, slip))
    np.testing.assert_array_equal(truth_poses(run), truth_poses(nominal))
    outside = (run.log["time"] < slip.start) | (run.log["time"] > slip.start + slip.duration + 0.005)
    for slipping, gripping, gained in zip(
        wheel_counts(run.log, robot), wheel_counts(nominal.log, robot), (slip.right, slip.left), strict=True
    ):
        more = (slipping - gripping) * metres_per_count(robot)
        # The fraction of a count that the slip leaves behind may round any later count up or down, but never adds up.
        assert np.abs(more[outside]).max() <= 1.01 * metres_per_count(robot)
        assert more.sum() == pytest.approx(gained, abs=metres_per_count(robot))


def gaps(log, period=0.005):
    """Return how many cycles are lost before each row but row 0."""
    cycles = np.diff(log["time"]) / period
    assert np.abs(cycles - np.rint(cycles)).max() < 0.3
    return np.rint(cycles).astype(int) - 1


@pytest.mark.parametrize("part", [0.0, 0.06, 0.3])
def test_lost_cycles_leave_gaps_of_one_and_two_and_rows_as_they_were(part):
    whole = encoder_run(BEEGO, WINDING, seed=0, conditions=Conditions(jitter=0.0002))
    run = encoder_run(BEEGO, WINDING, seed=0, conditions=Conditions(jitter=0.0002, lost=part))
    lost = gaps(run.log)
    assert lost.sum() == pytest.approx(part * len(whole.log["time"]), abs=3)
    assert (lost == 1).sum() == pytest.approx((lost == 2).sum(), abs=1)
    assert lost.max(initial=0) == (2 if part else 0)
    left = np.isin(whole.log["time"], run.log["time"])
    assert left[[0, -1]].all()
    for name in run.log:
        np.testing.assert_array_equal(run.log[name], whole.log[name][left])
    for name in run.truth:
        np.testing.assert_array_equal(run.truth[name], whole.truth[name][left])


def test_a_long_gap_comes_once_and_in_the_middle():
    run = encoder_run(BEEGO, WINDING, seed=0, conditions=Conditions(long_gap=34))
    lost = gaps(run.log)
    assert sorted(set(lost)) == [0, 34]
    assert (lost == 34).sum() == 1
    assert run.log["time"][lost.argmax()] == pytest.approx(run.log["time"][-1] / 2, abs=0.01)


@pytest.mark.parametrize("duration", [0.4, 0.405, 0.41, 0.43, 0.445])
def test_short_drives_lose_cycles_too_but_never_their_ends(duration):
    for seed in range(20):
        conditions = Conditions(period=0.04, lost=0.3, long_gap=99)
        time = encoder_run(ICART, (Segment(0.1, 0.0, duration),), seed, conditions).log["time"]
        assert time[0] == 0
        assert time[-1] == pytest.approx(duration, abs=0.04)


@ROBOTS
def test_steered_by_odometry_the_log_is_the_drive_and_the_truth_another(robot):
    """The wheels turn as if the robot were nominal; so its odometry ends where it means to, and itself does not."""
    conditions = Conditions(radius_right=1.01 * robot.radius, radius_left=0.98 * robot.radius, tread=1.03 * abs(robot.tread))
    meant = encoder_run(robot, WINDING, seed=0)
    run = encoder_run(robot, steered_by_odometry(robot, WINDING, conditions), seed=0, conditions=conditions)
    for name in ("counter1", "counter2"):
        assert np.abs(np.cumsum(run.log[name] - meant.log[name])).max() <= 1
    right, left = (np.sum(counts) * metres_per_count(robot) for counts in wheel_counts(meant.log, robot))
    turned = (1.01 * right - 0.98 * left) / (1.03 * robot.tread)
    assert run.truth["theta"][-1] == pytest.approx(turned, abs=3 * metres_per_count(robot) / abs(robot.tread))
    assert np.hypot(*(truth_poses(run) - truth_poses(meant))[-1, :2]) > 0.02


def test_a_nominal_robot_drives_what_it_means_to():
    driven = steered_by_odometry(ICART, WINDING, Conditions())
    np.testing.assert_allclose(driven, WINDING, rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    ("conditions", "faithful"),
    [
        ({}, True),
        ({"jitter": 0.001, "start": 1.7e9, "period": 0.01, "ramp": 0.2}, True),
        ({"radius_right": 0.14}, False),
        ({"radius_left": 0.14}, False),
        ({"tread": 0.3}, False),
        ({"slip": Slip(1.0, 1.0, 0.1)}, False),
        ({"lost": 0.01}, False),
        ({"long_gap": 1}, False),
    ],
)
def test_what_makes_odometry_miss_the_truth(conditions, faithful):
    assert Conditions(**conditions).faithful is faithful


def test_the_seed_decides():
    conditions = Conditions(jitter=0.0005)
    texts = [encoder_log_text(encoder_run(BEEGO, LEFT, seed, conditions).log) for seed in (1, 1, 2)]
    assert texts[0] == texts[1] != texts[2]


@ROBOTS
def test_files_read_back_as_they_were(robot, tmp_path):
    run = encoder_run(robot, WINDING, seed=0, conditions=Conditions(jitter=0.001, start=1.7e9))
    write_encoder_log(tmp_path / "a.dat", run.log)
    write_truth(tmp_path / "a.truth.csv", run.truth)
    log, truth = read_encoder_log(tmp_path / "a.dat"), read_truth(tmp_path / "a.truth.csv")
    assert list(log) == list(run.log)
    for name, column in log.items():
        np.testing.assert_allclose(column, run.log[name], rtol=0, atol=2.5e-7 if name == "time" else 0)
    assert list(truth) == list(run.truth)
    for name, column in truth.items():
        np.testing.assert_allclose(column, run.truth[name], rtol=0, atol=8e-7)


def test_the_file_is_in_the_format_of_the_slides():
    log = {"time": [0.0, 0.005], "counter1": [0.0, 165.0], "counter2": [0.0, -165.0], "pwm1": [0.0, 20.5], "pwm2": [0.0, -20.0]}
    assert encoder_log_text(log) == (
        "# Time [s], Encoder Counter1 (incremental difference), Encoder Counter2 (incremental difference), PWM1, PWM2\n"
        "0.000000,0,0,0,0\n"
        "0.005000,165,-165,20.5,-20\n"
    )


@ROBOTS
def test_there_is_no_minus_zero(robot):
    run = encoder_run(robot, LEFT, seed=0)
    for name in ("counter1", "counter2", "pwm1", "pwm2"):
        assert not (np.signbit(run.log[name]) & (run.log[name] == 0)).any(), name
    assert "-0.000000" not in truth_text(run.truth)


def test_stamps_increase_however_large_the_jitter():
    time = encoder_run(ICART, LEFT, seed=0, conditions=Conditions(jitter=1.0)).log["time"]
    assert np.diff(time).min() >= 0.2 * 0.005 - 1e-6


@pytest.mark.parametrize(
    ("segments", "reason"),
    [
        ((), "at least one segment"),
        ((Segment(np.nan, 0.0, 1.0),), "finite"),
        ((Segment(0.5, 0.0, np.inf),), "finite"),
        ((Segment(0.5, 0.0, 0.3), REST), "as long as the ramp"),
        ((Segment(0.5, 0.0, -1.0),), "as long as the ramp"),
    ],
)
def test_drives_that_cannot_be_driven(segments, reason):
    with pytest.raises(ValueError, match=reason):
        encoder_run(ICART, segments, seed=0)


@pytest.mark.parametrize(
    "conditions",
    [
        *({"period": 0}, {"ramp": -1.0}, {"radius_left": 0.0}, {"radius_right": np.nan}, {"tread": -0.3}),
        *({"jitter": -0.1}, {"jitter": np.nan}, {"jitter": np.inf}, {"lost": -0.1}, {"lost": 0.31}, {"long_gap": -1}),
        *({"slip": Slip(1.0, 0.0, 0.1)}, {"slip": Slip(1.0, 1.0, np.nan)}),
    ],
)
def test_conditions_that_cannot_be_recorded(conditions):
    with pytest.raises(ValueError, match=next(iter(conditions))):
        Conditions(**conditions)
