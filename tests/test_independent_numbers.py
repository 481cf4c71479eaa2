"""The course's numbers agree with independent ones: SciPy, the closed form of an arc, and YP-Spur's published rules, written out here."""

import math

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid, solve_ivp, trapezoid
from scipy.spatial.transform import Rotation

from autograder.reference import exercise_named
from course.given import Integrand
from course.logs import data_path, read_encoder_log
from course.robots import BEEGO, ICART, Robot

DRAWS = range(20)


def ours(name, *arguments):
    return np.asarray(exercise_named(name).reference(*arguments), dtype=float)


def drawn(seed, count=9):
    """Return (stamps with uneven gaps, velocity, yaw rate, a pose to begin with)."""
    rng = np.random.default_rng(seed)
    time = 1.6e9 * (seed % 2) + np.cumsum(rng.uniform(0.05, 0.4, count))
    return time, rng.uniform(-1, 1, count), rng.uniform(-2, 2, count), rng.uniform(-3, 3, 3)


def rotation(theta):
    return Rotation.from_euler("z", theta).as_matrix()[:2, :2]


def yp_spur(velocity, yaw_rate, dt, pose):
    """YP-Spur's odometry: x and y along the heading of before, then the heading, once for each control cycle."""
    x, y, theta = pose
    path = [(x, y, theta)]
    for v, w, step in zip(velocity, yaw_rate, dt, strict=True):
        x += v * math.cos(theta) * step
        y += v * math.sin(theta) * step
        theta += w * step
        path.append((x, y, theta))
    return np.array(path)


def yp_spur_wheels(log, robot: Robot):
    """V and omega of each cycle from the two motors' speeds, as YP-Spur has them: each radius with the sign of its motor."""
    count = {1: log["counter1"][1:], 2: log["counter2"][1:]}
    dt = np.diff(log["time"])
    radius = {robot.right_counter: robot.sign_right * robot.radius, robot.left_counter: robot.sign_left * robot.radius}
    speed = {motor: 2 * math.pi * count[motor] / (robot.gear * robot.counts_per_rev) / dt for motor in (1, 2)}
    right, left = (radius[motor] * speed[motor] for motor in (robot.right_counter, robot.left_counter))
    return (right + left) / 2, (right - left) / robot.tread, dt


def moved(poses, frame):
    """Place poses that are given in a frame into its parent, with SciPy's rotation."""
    x, y, theta = poses
    return np.array([*(rotation(frame[2]) @ [x, y] + frame[:2]), theta + frame[2]])


def seen_from(pose, frame):
    return np.array([*(rotation(frame[2]).T @ (np.subtract(pose, frame)[:2])), pose[2] - frame[2]])


def same_pose(one, other):
    """Are two poses the same, the heading but for whole turns?"""
    gap = np.subtract(one, other)
    gap[2] = math.remainder(gap[2], 2 * math.pi)
    return np.abs(gap).max() < 1e-9


@pytest.mark.parametrize("seed", DRAWS)
def test_integrals_are_those_of_scipy_and_of_a_plain_sum(seed):
    rng = np.random.default_rng(seed)
    a, b = rng.uniform(-3, 3, 2)
    count = int(rng.integers(1, 12))
    f = Integrand(rng.uniform(-2, 2, 4), rng.uniform(0.5, 2, (1, 3)))
    at = np.linspace(a, b, count + 1)
    assert ours("trapezoid_integral", f, a, b, count) == pytest.approx(trapezoid(f(at), at), rel=1e-9, abs=1e-12)
    assert ours("euler_integral", f, a, b, count) == pytest.approx(f(at[:-1]).sum() * (b - a) / count, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("seed", DRAWS)
def test_cumulative_integrals_are_those_of_scipy(seed):
    time, values, _, (initial, *_) = drawn(seed)
    expected = initial + cumulative_trapezoid(values, time, initial=0)
    np.testing.assert_allclose(ours("cumulative_trapezoid", values, time, initial), expected, atol=1e-9)
    left = initial + np.concatenate([[0], np.cumsum(values[:-1] * np.diff(time))])
    np.testing.assert_allclose(ours("cumulative_euler", values, time, initial), left, atol=1e-9)


@pytest.mark.parametrize("seed", DRAWS)
def test_paths_by_the_trapezoid_rule_are_those_of_scipy(seed):
    time, velocity, yaw_rate, start = drawn(seed)
    theta = start[2] + cumulative_trapezoid(yaw_rate, time, initial=0)
    x = start[0] + cumulative_trapezoid(velocity * np.cos(theta), time, initial=0)
    y = start[1] + cumulative_trapezoid(velocity * np.sin(theta), time, initial=0)
    found = ours("integrate_poses_trapezoid", time, velocity, yaw_rate, start)
    np.testing.assert_allclose(found, np.column_stack([x, y, theta]), atol=1e-9)


@pytest.mark.parametrize("seed", DRAWS)
def test_paths_by_eulers_rule_are_those_of_yp_spur(seed):
    time, velocity, yaw_rate, start = drawn(seed)
    dt = np.diff(time)
    expected = yp_spur(velocity[:-1], yaw_rate[:-1], dt, start)
    np.testing.assert_allclose(ours("integrate_poses_euler", time, velocity, yaw_rate, start), expected, atol=1e-9)
    np.testing.assert_allclose(ours("dead_reckoning", velocity[:-1], yaw_rate[:-1], dt, start), expected, atol=1e-9)


@pytest.mark.parametrize("seed", DRAWS)
def test_the_arc_is_the_circle_in_closed_form_and_what_its_differential_equation_gives(seed):
    rng = np.random.default_rng(seed)
    distance, dtheta, start = rng.uniform(-2, 2), rng.uniform(0.1, 3) * rng.choice([-1, 1]), rng.uniform(-3, 3, 3)
    radius, (x, y, theta) = distance / dtheta, start
    circle = [
        x + radius * (math.sin(theta + dtheta) - math.sin(theta)),
        y - radius * (math.cos(theta + dtheta) - math.cos(theta)),
        theta + dtheta,
    ]
    np.testing.assert_allclose(ours("pose_step_arc", start, distance, dtheta), circle, atol=1e-10)
    driven = solve_ivp(
        lambda _, pose: [distance * math.cos(pose[2]), distance * math.sin(pose[2]), dtheta],
        (0, 1),
        start,
        rtol=1e-10,
        atol=1e-12,
    )
    np.testing.assert_allclose(driven.y[:, -1], circle, atol=1e-7)


@pytest.mark.parametrize("seed", DRAWS)
def test_many_midpoint_steps_come_to_the_end_of_the_arc(seed):
    rng = np.random.default_rng(seed)
    distance, dtheta, start = rng.uniform(-2, 2), rng.uniform(-3, 3), rng.uniform(-3, 3, 3)
    pieces = 4000
    path = ours("integrate_increments", np.full(pieces, distance / pieces), np.full(pieces, dtheta / pieces), start)
    np.testing.assert_allclose(path[-1], ours("pose_step_arc", start, distance, dtheta), atol=1e-6)


@pytest.mark.parametrize("seed", DRAWS)
def test_frames_are_rotated_as_by_scipy(seed):
    rng = np.random.default_rng(seed)
    a, b = rng.uniform(-3, 3, (2, 3))
    np.testing.assert_allclose(ours("planar_rotation", a[2])[:2, :2], rotation(a[2]), atol=1e-12)
    assert same_pose(ours("compose", a, b), moved(b, a))
    assert same_pose(moved(ours("invert", a), a), (0, 0, 0))
    assert same_pose(ours("express_in", b, a), seen_from(b, a))
    points = rng.uniform(-3, 3, (4, 2))
    np.testing.assert_allclose(ours("points_to_parent", points, a), points @ rotation(a[2]).T + a[:2], atol=1e-12)


@pytest.mark.parametrize("seed", DRAWS)
def test_set_and_adjust_do_what_yp_spur_does(seed):
    """Both put GL where FS appears at the wanted pose; adjust takes the line that is followed along, so that it stays in GL."""
    rng = np.random.default_rng(seed)
    frames = {name: rng.uniform(-3, 3, 3) for name in ("GL", "FS", "SP", "LC")}
    wanted = rng.uniform(-3, 3, 3)
    after_set = exercise_named("set_pos_gl").reference(frames, wanted)
    after_adjust = exercise_named("adjust_pos_gl").reference(frames, wanted)
    for after in (after_set, after_adjust):
        assert same_pose(seen_from(after["FS"], after["GL"]), wanted)
        assert same_pose(after["FS"], frames["FS"])
        assert same_pose(after["LC"], frames["LC"])
    assert same_pose(after_set["SP"], frames["SP"])
    assert same_pose(seen_from(after_adjust["SP"], after_adjust["GL"]), seen_from(frames["SP"], frames["GL"]))


@pytest.mark.parametrize(
    ("log", "robot"),
    [
        ("encoder_straight_left", ICART),
        ("encoder_figure_eight", BEEGO),
        ("encoder_practical", ICART),
        ("encoder_unix_time", None),
    ],
)
def test_the_program_of_the_practical_drives_as_yp_spur_does(log, robot):
    from course.datasets import RECIPES

    robot = robot or next(recipe.robot for recipe in RECIPES if recipe.name == log)
    columns = read_encoder_log(data_path(f"{log}.dat"))
    velocity, yaw_rate, dt = yp_spur_wheels(columns, robot)
    expected = yp_spur(velocity, yaw_rate, dt, (0.0, 0.0, 0.0))
    exercise = exercise_named("wheel_odometry")
    found = [rule(columns, robot) for rule in (exercise.reference, *exercise.also_right)]
    for result in found:
        np.testing.assert_allclose(result["velocity"][1:], velocity, atol=1e-9)
        np.testing.assert_allclose(result["yaw_rate"][1:], yaw_rate, atol=1e-9)
        np.testing.assert_allclose(result["theta"], expected[:, 2], atol=1e-9)
        # the rules part by half a step's turn
        np.testing.assert_allclose(np.column_stack([result["x"], result["y"]]), expected[:, :2], atol=0.02)
    eulers = [np.abs(np.column_stack([result["x"], result["y"]]) - expected[:, :2]).max() for result in found]
    assert min(eulers) < 1e-9


@pytest.mark.parametrize("seed", DRAWS)
def test_headings_are_wrapped_as_by_the_complex_plane(seed):
    theta = np.random.default_rng(seed).uniform(-20, 20, 7)
    np.testing.assert_allclose(ours("wrap_angle", theta), np.angle(np.exp(1j * theta)), atol=1e-12)
