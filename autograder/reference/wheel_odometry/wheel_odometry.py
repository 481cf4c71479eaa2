"""wheel_odometry(log, robot): pose and speeds after every row of an encoder log (slides 000, overview 5-6 and practical training)."""

import numpy as np

from autograder.draws import until
from autograder.exercise import Exercise, Group, Mistake
from course.given import built_robot
from course.language import Text
from course.robots import BEEGO, ICART, Robot
from course.tolerances import ONE_QUANTITY, STAMPS, RecordTolerance, Tolerance


def reference(log, robot):
    """Return the record of a drive by Euler's rule: each step goes along the heading before it."""
    return _record(log, robot, lambda before, turn: np.exp(1j * before))


def midpoint(log, robot):
    """Return the record of a drive, each step along the heading in the middle of its turn."""
    return _record(log, robot, lambda before, turn: np.exp(1j * (before + turn / 2)))


def mean_of_the_cosines(log, robot):
    """Return the record of a drive, each step along the mean of the directions before and after it."""
    return _record(log, robot, lambda before, turn: (np.exp(1j * before) + np.exp(1j * (before + turn))) / 2)


def arc(log, robot):
    """Return the record of a drive in arcs: the chord is shorter than the arc by sin(a/2)/(a/2)."""
    return _record(log, robot, lambda before, turn: np.exp(1j * (before + turn / 2)) * np.sinc(turn / (2 * np.pi)))


def _record(log, robot, direction):
    """Return the six sequences; `direction` gives a step per metre, complex, from the headings before it and the turns."""
    time = np.asarray(log["time"], dtype=float)
    turns_of_wheel = np.array([log["counter1"], log["counter2"]], dtype=float) / robot.counts_per_rev / robot.gear
    turns_of_wheel[:, 0] = 0
    rims = turns_of_wheel * 2 * np.pi * robot.radius
    right = rims[robot.right_counter - 1] * robot.sign_right
    left = rims[robot.left_counter - 1] * robot.sign_left
    distance, turn = (right + left) / 2, (right - left) / robot.tread
    heading = turn.cumsum()
    position = (distance * direction(heading - turn, turn)).cumsum()
    # the first row has no interval before it; its increments are out already
    interval = np.ediff1d(time, to_begin=1.0)
    return {
        "time": time - time[0],
        "x": position.real,
        "y": position.imag,
        "theta": heading,
        "velocity": distance / interval,
        "yaw_rate": turn / interval,
    }


def cases(rng):
    """Draw logs of one to nine rows with steps so large that the rules differ; none is repeated, none is about to stand still."""

    def some(right_counter, signs, side, gear):
        return Robot(
            "robot",
            rng.uniform(0.05, 0.2),
            side * rng.uniform(0.25, 0.5),
            gear,
            rng.choice([400, 500, 1024]),
            right_counter,
            *signs,
        )

    def pair(side):
        """Return a turn each way by two robots whose motors are mounted as mirror images; either counter may be the right one."""
        counter, sign = rng.permutation([1, 2]).tolist(), rng.choice([-1, 1])
        robots = [
            some(number, (s, -s), side, round(rng.uniform(30, 160)) + 0.5137)
            for number, s in zip(counter, (sign, -sign), strict=True)
        ]
        return [
            (drive(rng, robot, 9, way), built_robot(robot)) for robot, way in zip(robots, rng.permutation([-1, 1]), strict=True)
        ]

    whole = rng.integers(30, 160, 4).tolist()
    counters, sides = rng.permutation([1, 2]).tolist(), rng.permutation([-1, 1])
    alike = [some(counters[i], (s, s), sides[i], whole[i]) for i, s in enumerate((1, -1))]
    unix = some(rng.choice([1, 2]), (1, -1), rng.choice([-1, 1]), whole[2])
    short = [some(2, (-1, 1), sides[0], whole[3]), some(1, (1, -1), sides[1], whole[3])]
    listed = drive(rng, BEEGO, 5, 1)
    return [
        Group(Text("a positive tread", "トレッドが正"), 3, pair(1)),
        Group(Text("a negative tread", "トレッドが負"), 3, pair(-1)),
        Group(
            Text("i-Cart and Beego", "i-CartとBeego"),
            2,
            [(drive(rng, robot, 6, 1), built_robot(robot)) for robot in (ICART, BEEGO)],
        ),
        Group(
            Text("both counters of one sign, whole counts", "左右の符号が同じ、整数の増分"),
            1,
            [(whole_counts(drive(rng, robot, 5, way)), built_robot(robot)) for robot, way in zip(alike, (1, -1), strict=True)],
        ),
        Group(Text("Unix time", "Unix時間"), 1, [(drive(rng, unix, 6, -1, start=rng.uniform(1.6e9, 1.8e9)), built_robot(unix))]),
        Group(
            Text("one row or two", "1行または2行"),
            1,
            [(drive(rng, r, n, 1), built_robot(r)) for r, n in zip(short, (1, 2), strict=True)],
        ),
        Group(Text("lists", "リスト"), 1, [({key: values.tolist() for key, values in listed.items()}, built_robot(BEEGO))]),
    ]


def drive(rng, robot, rows, way, start=None):
    """Return a log that turns mostly to the side `way`, more than half round if it is long, and reverses on the way."""

    def steps():
        count = rows - 1
        turn = way * rng.uniform(0.5, 0.9, count) * np.where(np.arange(count) % 5 == 3, -0.6, 1)
        distance = rng.uniform(0.2, 0.6, count) * np.where(np.arange(count) % 4 == 1, -1, 1)
        return np.append(rng.uniform(0.2, 0.4), distance), np.append(rng.uniform(0.2, 0.4), turn)

    def far_round(distance, turn):
        return rows < 9 or np.abs(turn[1:].cumsum()).max() > 3.5

    distance, turn = until(steps, far_round)
    metres = 2 * np.pi * robot.radius / robot.gear / robot.counts_per_rev
    right = np.rint(robot.sign_right * (distance + turn * robot.tread / 2) / metres)
    left = np.rint(robot.sign_left * (distance - turn * robot.tread / 2) / metres)
    first, second = (right, left) if robot.right_counter == 1 else (left, right)
    start = rng.uniform(3, 50) if start is None else start
    dt = rng.permuted(np.linspace(0.3, 0.8, rows)) + rng.uniform(-0.02, 0.02, rows)
    pwm = rng.integers(20, 100, (2, rows)).astype(float)
    # whole microseconds, as a file has them
    return {"time": np.round(start + dt.cumsum(), 6), "counter1": first, "counter2": second, "pwm1": pwm[0], "pwm2": pwm[1]}


def whole_counts(log):
    """Return the log with counters of integers."""
    return {key: values.astype(int) if key.startswith("counter") else values for key, values in log.items()}


EXAMPLE_ICART = {
    "time": np.array([0.0, 0.1, 0.2, 0.35]),
    "counter1": np.array([0.0, 3000.0, 4000.0, 4000.0]),
    "counter2": np.array([0.0, -3000.0, -2000.0, -2000.0]),
    "pwm1": np.array([0.0, 20.0, 20.0, 20.0]),
    "pwm2": np.array([0.0, -20.0, -15.0, -15.0]),
}
EXAMPLE_BEEGO = {
    "time": np.array([1713147300.25, 1713147300.5, 1713147300.75]),
    "counter1": np.array([7000.0, 30000.0, 30000.0]),
    "counter2": np.array([-6000.0, -30000.0, 25000.0]),
    "pwm1": np.array([0.0, -10.0, -10.0]),
    "pwm2": np.array([0.0, -10.0, 10.0]),
}


def mirrored_sign_ignored(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = metres * right[1:], metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def left_sign_forgotten(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def right_sign_forgotten(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def left_wheel_always_negated(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = metres * right[1:], -metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def signs_exchanged(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_left * metres * right[1:], robot.sign_right * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def counter_1_taken_for_right(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = c1, c2
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def counter_2_taken_for_right(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = c2, c1
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def counters_exchanged(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c2, c1) if robot.right_counter == 1 else (c1, c2)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def tread_without_sign(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / abs(robot.tread), np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def yaw_reversed(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (left - right) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def half_tread_used(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / (robot.tread / 2), np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def yaw_halved(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / 2 / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speed_not_halved(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = right + left, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speed_not_halved_and_yaw_halved(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = right + left, (right - left) / 2 / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speed_and_yaw_from_the_other_formula(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right - left) / 2, (right + left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def yaw_from_the_sum(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right + left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def tread_forgotten(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, right - left, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def gear_forgotten(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / robot.counts_per_rev
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def gear_multiplied(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius * robot.gear / robot.counts_per_rev
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def gear_cut_to_a_whole_number(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (int(robot.gear) * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def counts_per_rev_forgotten(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / robot.gear
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def two_pi_forgotten(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def radius_taken_for_diameter(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def radius_doubled(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * (2 * robot.radius) / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def counts_decoded_again(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * 4 * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def icart_parameters_in_the_code(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * 0.14457758 / (150 * 400)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / -0.3045, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def icart_written_out(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * 0.14457758 / (150 * 400)
    right, left = c1, c2
    right, left = metres * right[1:], -metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / -0.3045, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def whole_number_division(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / robot.counts_per_rev
    right, left = (c1 // robot.gear, c2 // robot.gear) if robot.right_counter == 1 else (c2 // robot.gear, c1 // robot.gear)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def pwm_read_for_counts(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["pwm1"], dtype=float), np.array(log["pwm2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def increments_differenced_again(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * np.diff(right), robot.sign_left * metres * np.diff(left)
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def increments_summed_first(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = np.cumsum(robot.sign_right * metres * right[1:]), np.cumsum(robot.sign_left * metres * left[1:])
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def first_row_moves_the_robot(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right, robot.sign_left * metres * left
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.append(1.0, np.diff(t))
    theta = np.cumsum(turn)
    x = np.cumsum(distance * np.cos(theta - turn))
    y = np.cumsum(distance * np.sin(theta - turn))
    velocity, yaw_rate = distance / dt, turn / dt
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def increments_one_row_late(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[:-1], robot.sign_left * metres * left[:-1]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def nominal_dt(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn = (right + left) / 2, (right - left) / robot.tread
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / 0.005), np.append(0, turn / 0.005)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def mean_dt(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, (t[-1] - t[0]) / max(len(t) - 1, 1)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def first_dt_for_all(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt[:1]), np.append(0, turn / dt[:1])
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def dt_of_the_next_interval(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / np.append(dt[1:], dt[-1:])), np.append(0, turn / np.append(dt[1:], dt[-1:]))
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speeds_not_divided_by_dt(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn = (right + left) / 2, (right - left) / robot.tread
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance), np.append(0, turn)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speeds_multiplied_by_dt(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance * dt), np.append(0, turn * dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speeds_since_the_start(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn = (right + left) / 2, (right - left) / robot.tread
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity = np.append(0, np.cumsum(distance) / (t[1:] - t[0]))
    yaw_rate = np.append(0, theta[1:] / (t[1:] - t[0]))
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speeds_divided_by_the_stamp(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn = (right + left) / 2, (right - left) / robot.tread
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / t[1:]), np.append(0, turn / t[1:])
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speeds_one_row_early(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(distance / dt, 0), np.append(turn / dt, 0)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speeds_summed_up(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, np.cumsum(distance / dt)), np.append(0, np.cumsum(turn / dt))
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def wheel_speeds_for_body_speeds(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, right / dt), np.append(0, left / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speed_without_sign(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, np.abs(distance) / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def speed_along_x(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, np.diff(x) / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def time_as_in_the_log(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t, "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def time_steps_for_time(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": np.append(0, dt), "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def row_number_for_time(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": np.arange(len(t)), "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def stamps_in_float32(log, robot):
    t = np.array(log["time"], dtype=np.float32)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def yaw_wrapped(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    wrapped = (theta + np.pi) % (2 * np.pi) - np.pi
    return {"time": t - t[0], "x": x, "y": y, "theta": wrapped, "velocity": velocity, "yaw_rate": yaw_rate}


def yaw_wrapped_to_positive(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta % (2 * np.pi), "velocity": velocity, "yaw_rate": yaw_rate}


def yaw_in_degrees(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": np.rad2deg(theta), "velocity": velocity, "yaw_rate": np.rad2deg(yaw_rate)}


def only_theta_in_degrees(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": np.rad2deg(theta), "velocity": velocity, "yaw_rate": yaw_rate}


def cosine_of_degrees(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(np.rad2deg(theta[:-1]))))
    y = np.append(0, np.cumsum(distance * np.sin(np.rad2deg(theta[:-1]))))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def sin_and_cos_exchanged(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def sin_and_cos_exchanged_midpoint(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.sin(theta[:-1] + turn / 2)))
    y = np.append(0, np.cumsum(distance * np.cos(theta[:-1] + turn / 2)))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def y_reversed(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, -np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def new_heading_moves_the_robot(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[1:])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[1:])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def heading_overwritten_before_y(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[1:])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def x_and_y_by_different_rules(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1] + turn / 2)))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def heading_one_step_late(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    old = np.append(0, theta[:-1])[: len(distance)]
    x = np.append(0, np.cumsum(distance * np.cos(old)))
    y = np.append(0, np.cumsum(distance * np.sin(old)))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def turn_alone_used(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(turn)))
    y = np.append(0, np.cumsum(distance * np.sin(turn)))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def heading_ignored(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance))
    y = np.zeros(len(t))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def last_heading_for_all(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def means_of_neighbouring_speeds(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    distance, turn = (distance + np.append(0, distance)[:-1]) / 2, (turn + np.append(0, turn)[:-1]) / 2
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def steps_not_added_up(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, distance * np.cos(theta[:-1]))
    y = np.append(0, distance * np.sin(theta[:-1]))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": np.append(0, turn), "velocity": velocity, "yaw_rate": yaw_rate}


def positions_not_added_up(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, distance * np.cos(theta[:-1]))
    y = np.append(0, distance * np.sin(theta[:-1]))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def start_row_left_out(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    return {"time": t[1:] - t[0], "x": x[1:], "y": y[1:], "theta": theta[1:], "velocity": distance / dt, "yaw_rate": turn / dt}


def speeds_without_row_0(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = distance / dt, turn / dt
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def start_row_added(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right, robot.sign_left * metres * left
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.append(1.0, np.diff(t))
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": np.append(0, t - t[0]), "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def only_the_last_pose(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t[-1] - t[0], "x": x[-1], "y": y[-1], "theta": theta[-1], "velocity": velocity[-1], "yaw_rate": yaw_rate[-1]}


def table_for_dict(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return np.column_stack([t - t[0], x, y, theta, velocity, yaw_rate])


def tuple_for_dict(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return t - t[0], x, y, theta, velocity, yaw_rate


def one_row_not_thought_of(log, robot):
    t = np.array(log["time"], dtype=float)
    c1, c2 = np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = distance / dt, turn / dt
    velocity, yaw_rate = np.append(velocity[0], velocity), np.append(yaw_rate[0], yaw_rate)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


def arrays_only(log, robot):
    t = log["time"] - log["time"][0]
    c1, c2 = log["counter1"], log["counter2"]
    metres = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    right, left = (c1, c2) if robot.right_counter == 1 else (c2, c1)
    right, left = robot.sign_right * metres * right[1:], robot.sign_left * metres * left[1:]
    distance, turn, dt = (right + left) / 2, (right - left) / robot.tread, np.diff(t)
    theta = np.append(0, np.cumsum(turn))
    x = np.append(0, np.cumsum(distance * np.cos(theta[:-1])))
    y = np.append(0, np.cumsum(distance * np.sin(theta[:-1])))
    velocity, yaw_rate = np.append(0, distance / dt), np.append(0, turn / dt)
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, "velocity": velocity, "yaw_rate": yaw_rate}


EXERCISE = Exercise(
    name="wheel_odometry",
    notebook="odometry/wheel_odometry",
    points=10,
    parameters=("log", "robot"),
    reference=reference,
    also_right=(midpoint, mean_of_the_cosines, arc),
    cases=cases,
    examples=((EXAMPLE_ICART, built_robot(ICART)), (EXAMPLE_BEEGO, built_robot(BEEGO))),
    tolerance=RecordTolerance(
        (
            ("time", STAMPS),
            ("x", ONE_QUANTITY),
            ("y", ONE_QUANTITY),
            ("theta", ONE_QUANTITY),
            ("velocity", Tolerance(skip=1)),
            ("yaw_rate", Tolerance(skip=1)),
        )
    ),
    quantities=("time", "x", "y", "theta", "velocity", "yaw_rate"),
    mistakes=(
        Mistake(
            mirrored_sign_ignored,
            Text(
                "The signs of the robot are not used. The motors are mounted as mirror images, so one counter counts down while the robot drives forward: sign_right and sign_left turn both wheels forward. Without them a straight drive looks like a spin.",
                "ロボットの符号が使われていません。左右のモータは鏡像に取り付けてあるので、前進中に一方のカウンタは減っていきます。sign_rightとsign_leftを掛けて、両輪とも前進を正にしましょう。掛けないと直進がその場旋回に見えます。",
            ),
        ),
        Mistake(
            left_sign_forgotten,
            Text(
                "Only the right wheel is multiplied by its sign. sign_left belongs to the left wheel's counter in the same way.",
                "符号を掛けているのが右車輪だけです。左車輪のカウンタにもsign_leftを掛ける必要があります。",
            ),
        ),
        Mistake(
            right_sign_forgotten,
            Text(
                "Only the left wheel is multiplied by its sign. sign_right belongs to the right wheel's counter in the same way.",
                "符号を掛けているのが左車輪だけです。右車輪のカウンタにもsign_rightを掛ける必要があります。",
            ),
        ),
        Mistake(
            left_wheel_always_negated,
            Text(
                "The left wheel's counter is always negated, as for the i-Cart. Other robots have other signs: take sign_right and sign_left from the robot.",
                "左車輪のカウンタの符号を必ず反転しています。これはi-Cartの場合です。符号はロボットごとに違うので、sign_rightとsign_leftを使いましょう。",
            ),
        ),
        Mistake(
            signs_exchanged,
            Text(
                "The signs are exchanged: the right wheel gets sign_left and the left wheel sign_right.",
                "符号が左右入れ替わっています。右車輪にsign_left、左車輪にsign_rightを掛けていませんか。",
            ),
        ),
        Mistake(
            counter_1_taken_for_right,
            Text(
                "Counter 1 is taken for the right wheel whatever the robot says. right_counter tells which of the two counters is the right wheel's.",
                "どのロボットでもカウンタ1を右車輪としています。どちらが右車輪かはright_counterに書かれています。",
            ),
        ),
        Mistake(
            counter_2_taken_for_right,
            Text(
                "Counter 2 is taken for the right wheel whatever the robot says. right_counter tells which of the two counters is the right wheel's.",
                "どのロボットでもカウンタ2を右車輪としています。どちらが右車輪かはright_counterに書かれています。",
            ),
        ),
        Mistake(
            counters_exchanged,
            Text(
                "The counters are exchanged: what is taken for the right wheel is the left one. right_counter is the number of the right wheel's counter, 1 or 2; as an index into a list it is one less.",
                "左右のカウンタが入れ替わっています。right_counterは右車輪のカウンタの番号で、1か2です。リストの添字にするときは1を引きます。",
            ),
        ),
        Mistake(
            tread_without_sign,
            Text(
                "The sign of the tread is dropped. A negative tread is no mistake: it says that this robot's yaw counts clockwise, as its IMU does. With abs() its path is a mirror image.",
                "トレッドの符号が落ちています。負のトレッドは間違いではなく、IMUと同じく時計回りを正とすることを表します。abs()を取ると経路が鏡像になります。",
            ),
        ),
        Mistake(
            yaw_reversed,
            Text(
                "The yaw has the opposite sign. The yaw rate is right minus left over the tread, and the tread keeps its sign.",
                "ヨー角の符号が逆です。角速度は(右−左)をトレッドで割ったもので、トレッドの符号はそのまま使います。",
            ),
        ),
        Mistake(
            half_tread_used,
            Text(
                "The yaw is twice what it should be. The difference of the wheels is divided by the whole tread: the distance between the wheels, not from the centre to a wheel.",
                "ヨー角が2倍です。左右の差を割るのはトレッド全体(車輪間の距離)で、中心から車輪までの距離ではありません。",
            ),
        ),
        Mistake(
            yaw_halved,
            Text(
                "The yaw is half of what it should be. The 1/2 belongs to the mean of both wheels, the speed; the yaw rate is the difference over the tread.",
                "ヨー角が半分です。1/2が付くのは両輪の平均である速度だけで、角速度は差をトレッドで割ったものです。",
            ),
        ),
        Mistake(
            speed_not_halved,
            Text(
                "The distance is the sum of both wheels. If both wheels run 0.3 m the robot runs 0.3 m: the mean is asked for.",
                "進んだ距離が左右の和になっています。両輪が0.3 m進めばロボットも0.3 m進むので、平均を取りましょう。",
            ),
        ),
        Mistake(
            speed_not_halved_and_yaw_halved,
            Text(
                "The 1/2 is on the wrong line: the distance is the sum of both wheels, and the yaw is halved. The mean belongs to the distance, the whole difference over the tread to the yaw.",
                "1/2を付ける式が逆です。距離が左右の和に、ヨー角が半分になっています。平均を取るのは距離で、ヨー角は差をそのままトレッドで割ります。",
            ),
        ),
        Mistake(
            speed_and_yaw_from_the_other_formula,
            Text(
                "Sum and difference are exchanged: the distance comes from the difference of the wheels and the yaw from their sum. Both wheels at one speed must give no yaw.",
                "和と差が逆です。距離を左右の差から、ヨー角を和から求めています。両輪が同じ速さなら、ヨー角は変わらないはずです。",
            ),
        ),
        Mistake(
            yaw_from_the_sum,
            Text(
                "The yaw comes from the sum of the wheels. Both wheels at one speed must give no yaw: it is their difference that turns the robot.",
                "ヨー角を左右の和から求めています。両輪が同じ速さならヨー角は変わらないはずです。ロボットを回すのは差です。",
            ),
        ),
        Mistake(
            tread_forgotten,
            Text(
                "The yaw is the difference of the wheels in metres; it is not divided by the tread.",
                "ヨー角が左右の差(m)のままです。トレッドで割っていません。",
            ),
        ),
        Mistake(
            gear_forgotten,
            Text(
                "The gear is missing. The encoder sits on the motor's shaft, which turns gear times for one turn of the wheel.",
                "ギア比を使っていません。エンコーダはモータ軸にあり、タイヤが1回転する間にモータ軸はgear回転します。",
            ),
        ),
        Mistake(
            gear_multiplied,
            Text(
                "The gear multiplies. The motor turns gear times while the wheel turns once, so the wheel's angle is the smaller one: divide.",
                "ギア比を掛けています。タイヤが1回転する間にモータはgear回転するので、タイヤの角度のほうが小さくなります。割りましょう。",
            ),
        ),
        Mistake(
            gear_cut_to_a_whole_number,
            Text(
                "The gear is cut to a whole number. A gear may have decimals, and odometry needs them: use robot.gear as it is.",
                "ギア比を整数に切り捨てています。ギア比は小数になることもあるので、robot.gearをそのまま使いましょう。",
            ),
        ),
        Mistake(
            counts_per_rev_forgotten,
            Text(
                "counts_per_rev is missing: counts are taken for turns of the encoder. One turn gives counts_per_rev counts.",
                "counts_per_revを使っておらず、カウントを回転数とみなしています。1回転でcounts_per_revカウント進みます。",
            ),
        ),
        Mistake(
            two_pi_forgotten,
            Text(
                "2 pi is missing: counts over counts_per_rev are turns, and a wheel rolls 2 pi times its radius in one turn.",
                "2πが抜けています。カウントをcounts_per_revで割ると回転数です。タイヤは1回転で半径の2π倍進みます。",
            ),
        ),
        Mistake(
            radius_taken_for_diameter,
            Text(
                "All ways are half of what they should be: pi times the radius. The robot gives the radius; one turn is 2 pi times that.",
                "距離がすべて半分です。半径にπを掛けていませんか。与えられているのは半径で、1周は2π×半径です。",
            ),
        ),
        Mistake(
            radius_doubled,
            Text(
                "All ways are twice what they should be, as if the radius were doubled. One turn of the wheel is 2 pi times the radius, pi times the diameter.",
                "距離がすべて2倍です。半径を2倍していませんか。タイヤ1回転で進むのは2π×半径、つまりπ×直径です。",
            ),
        ),
        Mistake(
            counts_decoded_again,
            Text(
                "All ways are four times too small: counts_per_rev seems to be multiplied by 4. It is given after the 4x decoding already.",
                "距離がすべて4分の1です。counts_per_revを4倍していませんか。counts_per_revはすでに4逓倍後の値です。",
            ),
        ),
        Mistake(
            icart_parameters_in_the_code,
            Text(
                "The i-Cart's sizes stand in the code. The function gets another robot each time: take radius, tread, gear and counts_per_rev from it.",
                "i-Cartの値が式に直接書かれています。ロボットは呼び出しごとに変わるので、radius、tread、gear、counts_per_revを引数から取りましょう。",
            ),
        ),
        Mistake(
            icart_written_out,
            Text(
                "The i-Cart is written into the code, with its sizes, its counters and its signs. The function gets another robot each time: take all of that from robot.",
                "寸法もカウンタも符号も、i-Cartのものが直接書かれています。ロボットは呼び出しごとに変わるので、すべてrobotから取りましょう。",
            ),
        ),
        Mistake(
            whole_number_division,
            Text(
                "Decimals are lost: // divides and drops the rest. Use / for the gear.",
                "小数部分が失われています。//は余りを切り捨てる割り算です。ギア比では/で割りましょう。",
            ),
        ),
        Mistake(
            pwm_read_for_counts,
            Text(
                "The columns pwm1 and pwm2 are integrated. They say how hard the motors are driven; the ways are in counter1 and counter2.",
                "pwm1とpwm2を積分しています。PWMはモータへの指令で、車輪の動きはcounter1とcounter2にあります。",
            ),
        ),
        Mistake(
            increments_differenced_again,
            Text(
                "Differences are taken of the counter columns. This log holds increments already, what was counted since the row before.",
                "カウンタの列の差をさらに取っています。このログに入っているのはすでに増分(前の行から数えた分)です。",
            ),
        ),
        Mistake(
            increments_summed_first,
            Text(
                "The counts are summed up before they are used as steps, so that every step holds all ways before it. A row's increment is one step.",
                "増分を先に累積してから1歩分として使っています。各行の増分がそのまま1歩分です。",
            ),
        ),
        Mistake(
            first_row_moves_the_robot,
            Text(
                "The increments of row 0 move the robot. They were counted before the log begins: row 0 is the pose (0, 0, 0), and row k holds what happened between stamps k-1 and k.",
                "0行目の増分でロボットを動かしています。それはログが始まる前に数えた分です。0行目の姿勢は(0, 0, 0)で、k行目は時刻k-1からkまでの動きです。",
            ),
        ),
        Mistake(
            increments_one_row_late,
            Text(
                "Each row's increments are used for the step after its stamp, with row 0 as the first step and the last row left out. Row k holds what happened between stamps k-1 and k.",
                "各行の増分を、その時刻より後の1歩に使っています(0行目が最初の1歩で、最後の行は未使用)。k行目は時刻k-1からkまでの動きです。",
            ),
        ),
        Mistake(
            nominal_dt,
            Text(
                "The speeds are computed with 5 ms for every row. Stamps jitter and rows get lost: take each row's dt from the time column. (In the pose dt cancels, so only the speeds show it.)",
                "速度と角速度を、どの行でも5 msとして計算しています。時刻はばらつき、行が抜けることもあるので、dtは時刻の列から求めましょう。(姿勢ではdtが約分されるので、速度にだけ現れます。)",
            ),
        ),
        Mistake(
            mean_dt,
            Text(
                "The speeds are computed with the mean dt for every row. Each row has a dt of its own, time[k] - time[k-1]. (In the pose dt cancels, so only the speeds show it.)",
                "速度と角速度を、dtの平均値で計算しています。dtは行ごとに違い、time[k] - time[k-1]です。(姿勢ではdtが約分されるので、速度にだけ現れます。)",
            ),
        ),
        Mistake(
            first_dt_for_all,
            Text(
                "The speeds are computed with the first dt for every row. Each row has a dt of its own, time[k] - time[k-1].",
                "速度と角速度を、最初のdtだけで計算しています。dtは行ごとに違い、time[k] - time[k-1]です。",
            ),
        ),
        Mistake(
            dt_of_the_next_interval,
            Text(
                "The speeds are divided by the dt after the stamp. Row k holds what happened before its stamp: its dt is time[k] - time[k-1].",
                "速度を、その時刻より後のdtで割っています。k行目は時刻kまでの動きなので、dtはtime[k] - time[k-1]です。",
            ),
        ),
        Mistake(
            speeds_not_divided_by_dt,
            Text(
                "velocity and yaw_rate are metres and radians per row. Divided by the row's dt they become m/s and rad/s.",
                "velocityとyaw_rateが1行あたりの距離と角度のままです。各行のdtで割るとm/sとrad/sになります。",
            ),
        ),
        Mistake(
            speeds_multiplied_by_dt,
            Text(
                "velocity and yaw_rate are multiplied by dt. A way divided by the time it took is a speed.",
                "velocityとyaw_rateにdtを掛けています。速度は進んだ距離をかかった時間で割ったものです。",
            ),
        ),
        Mistake(
            speeds_since_the_start,
            Text(
                "velocity and yaw_rate are means since the start: all the way over all the time. Each row's increments over each row's dt are asked for.",
                "velocityとyaw_rateが開始からの平均になっています。各行の増分を各行のdtで割りましょう。",
            ),
        ),
        Mistake(
            speeds_divided_by_the_stamp,
            Text(
                "The speeds are divided by the stamp itself instead of the time since the row before: dt = time[k] - time[k-1].",
                "前の行からの時間ではなく、時刻そのもので割っています。dtはtime[k] - time[k-1]です。",
            ),
        ),
        Mistake(
            speeds_one_row_early,
            Text(
                "velocity and yaw_rate are shifted by one row: row k holds the interval after its stamp. Row k belongs to the interval before it, and row 0 is rest.",
                "velocityとyaw_rateが1行ずれ、k行目に次の区間の値が入っています。k行目はその時刻までの区間の値で、0行目は静止です。",
            ),
        ),
        Mistake(
            speeds_summed_up,
            Text(
                "velocity and yaw_rate grow from row to row: they are summed up, as the pose is. A speed belongs to one interval.",
                "velocityとyaw_rateが姿勢のように累積されています。速度は1区間ごとの値です。",
            ),
        ),
        Mistake(
            wheel_speeds_for_body_speeds,
            Text(
                "velocity and yaw_rate hold the speeds of the right and the left wheel. The body's speed is their mean, its yaw rate their difference over the tread.",
                "velocityとyaw_rateに左右の車輪の速度が入っています。車体の速度は両輪の平均、角速度は差をトレッドで割ったものです。",
            ),
        ),
        Mistake(
            speed_without_sign,
            Text(
                "velocity has lost its sign: where the robot reverses it must be negative. A speed computed from x and y by hypot, or with abs(), is never negative; take it from the wheels.",
                "velocityの符号が失われています。後退では負になります。xとyからhypotで求めたりabs()を取ったりせず、車輪の速度から求めましょう。",
            ),
        ),
        Mistake(
            speed_along_x,
            Text(
                "velocity is the change of x over dt. That is only the part along the x axis: the speed of the robot is the mean of its wheels.",
                "velocityがxの変化をdtで割ったものになっています。それはx方向の成分です。ロボットの速度は両輪の平均から求めましょう。",
            ),
        ),
        Mistake(
            time_as_in_the_log,
            Text(
                "time still holds the stamps of the log. Seconds from the start are asked for: subtract the first stamp.",
                "timeがログの時刻のままです。開始からの秒数にするため、最初の時刻を引きましょう。",
            ),
        ),
        Mistake(
            time_steps_for_time,
            Text(
                "time holds the steps between the rows. Seconds from the start are asked for: each stamp less the first one.",
                "timeに行の間隔dtが入っています。開始からの秒数、つまり各時刻から最初の時刻を引いたものにしましょう。",
            ),
        ),
        Mistake(
            row_number_for_time,
            Text(
                "time holds the number of the row. Seconds from the start are asked for: each stamp less the first one.",
                "timeに行番号が入っています。開始からの秒数、つまり各時刻から最初の時刻を引いたものにしましょう。",
            ),
        ),
        Mistake(
            stamps_in_float32,
            Text(
                "The stamps are kept in float32, which has seven digits: Unix seconds are off by a minute, and dt becomes 0. Keep time in float64.",
                "時刻をfloat32で扱っています。有効桁数が7桁なのでUnix時間では1分もずれ、dtが0になります。時刻はfloat64のままにしましょう。",
            ),
        ),
        Mistake(
            yaw_wrapped,
            Text(
                "theta jumps by a whole turn: it is wrapped to half a turn either side. A yaw that can be drawn and compared goes on counting: leave it unwrapped.",
                "thetaが1回転分跳んでいます。±πに折り返していませんか。グラフや比較のため、折り返さずに足し続けましょう。",
            ),
        ),
        Mistake(
            yaw_wrapped_to_positive,
            Text(
                "theta is wrapped to between 0 and a whole turn. A yaw that can be drawn and compared goes on counting, below zero too: leave it unwrapped.",
                "thetaを0から2πの範囲に折り返しています。グラフや比較のため、負の値も含めて折り返さずに足し続けましょう。",
            ),
        ),
        Mistake(
            yaw_in_degrees,
            Text(
                "theta and yaw_rate are in degrees. Angles are in rad here, rates in rad/s.",
                "thetaとyaw_rateが度になっています。角度はrad、角速度はrad/sです。",
            ),
        ),
        Mistake(
            only_theta_in_degrees,
            Text(
                "theta is in degrees. Angles are in rad here.",
                "thetaが度になっています。角度はradです。",
            ),
        ),
        Mistake(
            cosine_of_degrees,
            Text(
                "cos and sin get the heading in degrees. np.cos and np.sin take rad.",
                "cosとsinに度の値を渡しています。np.cosとnp.sinの引数はradです。",
            ),
        ),
        Mistake(
            sin_and_cos_exchanged,
            Text(
                "sin and cos are exchanged: at heading 0 the robot moves along y. Here theta counts from the x axis, so x takes the cosine. (Slide 003 has it the other way round.)",
                "sinとcosが逆で、方位0のときy方向に進んでいます。thetaはx軸から測るので、xにはcosを使います(003のスライドは逆になっています)。",
            ),
        ),
        Mistake(
            sin_and_cos_exchanged_midpoint,
            Text(
                "sin and cos are exchanged, with the heading in the middle of each step. Here theta counts from the x axis, so x takes the cosine.",
                "sinとcosが逆です(1歩の中間の方位を使った場合)。thetaはx軸から測るので、xにはcosを使います。",
            ),
        ),
        Mistake(
            y_reversed,
            Text(
                "y has the opposite sign, while theta and x are right. Each step adds distance times sin theta.",
                "thetaとxは合っていますが、yの符号が逆です。1歩ごとに距離×sinθを足します。",
            ),
        ),
        Mistake(
            new_heading_moves_the_robot,
            Text(
                "The heading after the step moves the robot. Euler's rule takes the one before it, the midpoint rule the one halfway; the heading after it is half a step ahead.",
                "1歩進んだ後の方位で動かしています。オイラー法では進む前の方位、中点法では中間の方位を使います。後の方位では半歩先に進みすぎます。",
            ),
        ),
        Mistake(
            heading_overwritten_before_y,
            Text(
                "x uses the heading before the step and y the one after it: theta seems to be updated between the two lines. Both need the same heading.",
                "xは進む前、yは進んだ後の方位で計算されています。2行の間でthetaを更新していませんか。両方に同じ方位を使いましょう。",
            ),
        ),
        Mistake(
            x_and_y_by_different_rules,
            Text(
                "x is computed with the heading before the step and y with the one in its middle. Any of the rules will do, but the same for both.",
                "xは進む前の方位、yは中間の方位で計算されています。どの規則でもかまいませんが、両方同じにしましょう。",
            ),
        ),
        Mistake(
            heading_one_step_late,
            Text(
                "Each step uses a heading that is one step too old. Step k goes along the heading in which step k-1 ended.",
                "各ステップで1つ古い方位を使っています。k歩目は、k-1歩目が終わったときの方位に進みます。",
            ),
        ),
        Mistake(
            turn_alone_used,
            Text(
                "Each step goes along the turn of that step alone. What counts is the heading: the sum of all turns up to there.",
                "各ステップをその1歩の回転角の方向に進めています。使うのは方位、つまりそれまでの回転角の和です。",
            ),
        ),
        Mistake(
            heading_ignored,
            Text(
                "The robot always moves along x, whatever its heading. Each step goes along the heading: cos theta of it to x, sin theta to y.",
                "方位によらず常にx方向に進んでいます。1歩ごとに、xにcosθ、yにsinθを掛けた分だけ進みます。",
            ),
        ),
        Mistake(
            last_heading_for_all,
            Text(
                "All steps go along one heading, the last one. Each step has a heading of its own.",
                "すべてのステップが最後の方位に進んでいます。方位はステップごとに違います。",
            ),
        ),
        Mistake(
            means_of_neighbouring_speeds,
            Text(
                "Neighbouring increments are averaged before they are added up, as in a trapezoid. An increment is the whole way of its interval already: averaging brings in the neighbour's motion.",
                "隣り合う増分を台形則のように平均してから足しています。増分はすでに区間全体の移動量なので、平均すると隣の区間の動きが混ざります。",
            ),
        ),
        Mistake(
            steps_not_added_up,
            Text(
                "x, y and theta hold single steps. The pose is the sum of all steps so far.",
                "x、y、thetaに1歩ごとの変化が入っています。姿勢はそれまでの変化をすべて足したものです。",
            ),
        ),
        Mistake(
            positions_not_added_up,
            Text(
                "x and y hold single steps, while theta is summed up. The position is the sum of all steps so far too.",
                "thetaは累積されていますが、xとyは1歩ごとの変化のままです。位置もそれまでの変化をすべて足したものです。",
            ),
        ),
        Mistake(
            start_row_left_out,
            Text(
                "There is one row too few: the start is missing. All entries have as many rows as the log, and row 0 is the pose (0, 0, 0).",
                "行が1つ足りません。出発点がないようです。どの項目もログと同じ行数で、0行目の姿勢は(0, 0, 0)です。",
            ),
        ),
        Mistake(
            speeds_without_row_0,
            Text(
                "velocity and yaw_rate have one row fewer than the log. Row 0 is rest: put a 0 in front.",
                "velocityとyaw_rateがログより1行少なくなっています。0行目は静止なので、先頭に0を置きましょう。",
            ),
        ),
        Mistake(
            start_row_added,
            Text(
                "There is one row too many: a start was put in front of row 0. Row 0 itself is the start, and its increments are not used.",
                "行が1つ多くなっています。0行目の前に出発点を加えていませんか。0行目そのものが出発点で、その増分は使いません。",
            ),
        ),
        Mistake(
            only_the_last_pose,
            Text(
                "Only the end of the drive comes back. Asked for are arrays with a value for each row of the log.",
                "最後の値だけが返っています。ログの各行に対応する配列を返しましょう。",
            ),
        ),
        Mistake(
            table_for_dict,
            Text(
                "A table comes back, with a column for each quantity. Asked for is a dict, so that the columns have names: time, x, y, theta, velocity, yaw_rate.",
                "列を並べた表が返っています。time、x、y、theta、velocity、yaw_rateという名前の付いたdictを返しましょう。",
            ),
        ),
        Mistake(
            tuple_for_dict,
            Text(
                "The arrays come back in a tuple. Asked for is a dict, so that they have names: time, x, y, theta, velocity, yaw_rate.",
                "配列がタプルで返っています。time、x、y、theta、velocity、yaw_rateという名前の付いたdictを返しましょう。",
            ),
        ),
        Mistake(
            one_row_not_thought_of,
            Text(
                "A log of a single row ends in an error: there is no row 1 to take a speed from. Row 0 is rest, so its speeds need no neighbour.",
                "1行だけのログでエラーになります。速度を取るための1行目がありません。0行目は静止なので、隣の行は必要ありません。",
            ),
        ),
        Mistake(
            arrays_only,
            Text(
                "Lists end in an error: the entries of the log may be lists too. np.asarray(log[...], dtype=float) turns them into arrays first.",
                "リストの場合にエラーになります。ログの項目はリストのこともあるので、先にnp.asarray(log[...], dtype=float)で配列にしましょう。",
            ),
        ),
    ),
)
