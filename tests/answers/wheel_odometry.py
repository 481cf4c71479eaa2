"""Answers to wheel_odometry(log, robot): right ones in honest styles, wrong ones as students write them."""

import math
import warnings

import numpy as np

KEYS = ("time", "x", "y", "theta", "velocity", "yaw_rate")


def state_by_state(log, robot):
    m = 2 * math.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    first, second = log["counter1"], log["counter2"]
    x = y = th = 0.0
    rows = [(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)]
    for k in range(1, len(log["time"])):
        dt = log["time"][k] - log["time"][k - 1]
        right, left = (first[k], second[k]) if robot.right_counter == 1 else (second[k], first[k])
        v_r, v_l = robot.sign_right * right * m / dt, robot.sign_left * left * m / dt
        v, w = (v_r + v_l) / 2, (v_r - v_l) / robot.tread
        x, y, th = x + v * dt * math.cos(th), y + v * dt * math.sin(th), th + w * dt
        rows.append((log["time"][k] - log["time"][0], x, y, th, v, w))
    return {key: [row[i] for row in rows] for i, key in enumerate(KEYS)}


def wheels(log, robot):
    """Ways of the right and the left wheel in each interval [m], (N - 1,) each."""
    counters = [np.asarray(log[f"counter{robot.right_counter}"], float), np.asarray(log[f"counter{robot.left_counter}"], float)]
    signs = robot.sign_right, robot.sign_left
    scale = math.tau * robot.radius / robot.gear / robot.counts_per_rev
    return [sign * scale * counter[1:] for sign, counter in zip(signs, counters, strict=True)]


def record(log, x, y, theta, way, turn):
    t = np.asarray(log["time"], float)
    dt = np.diff(t)
    speeds = {"velocity": np.concatenate([[0], way / dt]), "yaw_rate": np.concatenate([[0], turn / dt])}
    return {"time": t - t[0], "x": x, "y": y, "theta": theta, **speeds}


def summed(steps):
    return np.concatenate([[0.0], np.cumsum(steps)])


def midpoint_vectors(log, robot):
    right, left = wheels(log, robot)
    way, turn = (right + left) / 2, (right - left) / robot.tread
    theta = summed(turn)
    middle = theta[:-1] + turn / 2
    return record(log, summed(way * np.cos(middle)), summed(way * np.sin(middle)), theta, way, turn)


def mean_cosines_with_more_keys(log, robot):
    right, left = wheels(log, robot)
    way, turn = (right + left) / 2, (right - left) / robot.tread
    theta = summed(turn)
    c, s = np.cos(theta), np.sin(theta)
    out = record(log, summed(way * (c[1:] + c[:-1]) / 2), summed(way * (s[1:] + s[:-1]) / 2), theta, way, turn)
    print("closed?", np.hypot(out["x"][-1], out["y"][-1]))
    return {**out, "way": summed(way), "robot": robot.name}


def circles(log, robot):
    """Circles about a centre where the robot turns, else straight on; NaN as the unknown first speeds."""
    right, left = wheels(log, robot)
    poses = [(0.0, 0.0, 0.0)]
    for way, turn in zip((right + left) / 2, (right - left) / robot.tread, strict=True):
        x, y, th = poses[-1]
        if abs(turn) < 1e-9:
            poses.append((x + way * math.cos(th), y + way * math.sin(th), th + turn))
        else:
            radius = way / turn
            poses.append(
                (x + radius * (math.sin(th + turn) - math.sin(th)), y - radius * (math.cos(th + turn) - math.cos(th)), th + turn)
            )
    x, y, theta = np.array(poses).T
    out = record(log, x, y, theta, (right + left) / 2, (right - left) / robot.tread)
    out["velocity"][0] = out["yaw_rate"][0] = np.nan
    return out


def matrices(log, robot):
    right, left = wheels(log, robot)
    pose, poses = np.eye(3), [np.eye(3)]
    total = [0.0]
    for way, turn in zip((right + left) / 2, (right - left) / robot.tread, strict=True):
        c, s = math.cos(turn), math.sin(turn)
        pose = pose @ np.array([[c, -s, way], [s, c, 0], [0, 0, 1]])
        poses.append(pose)
        total.append(total[-1] + turn)
    warnings.warn(f"{len(poses)} poses", stacklevel=1)
    return record(
        log,
        np.array([p[0, 2] for p in poses]),
        np.array([p[1, 2] for p in poses]),
        np.array(total),
        (right + left) / 2,
        (right - left) / robot.tread,
    )


class Float32Arc:
    """Complex chords, single precision in the end; time stays double."""

    def __call__(self, log, robot):
        right, left = wheels(log, robot)
        way, turn = (right + left) / 2, (right - left) / robot.tread
        theta = summed(turn)
        z = summed(way * np.sinc(turn / math.tau) * np.exp(1j * (theta[:-1] + theta[1:]) / 2))
        out = record(log, z.real, z.imag, theta, way, turn)
        return {key: value if key == "time" else value.astype(np.float32) for key, value in out.items()}


RIGHT = {
    "Euler, state by state, lists": state_by_state,
    "midpoint, vectors": midpoint_vectors,
    "mean of the cosines, more keys, prints": mean_cosines_with_more_keys,
    "circles about a centre, NaN in row 0": circles,
    "matrices, warns": matrices,
    "complex arc, float32": Float32Arc(),
}


def mean_way(right, left):
    return (right + left) / 2


def turn_of(right, left, tread):
    return (right - left) / tread


def variant(log, robot, *, right=None, left=None, scale=1.0, way=mean_way, turn=turn_of, heading=None):
    """Return midpoint odometry with one thing changed."""
    right_way, left_way = wheels(log, robot)
    right_way = scale * (right_way if right is None else right)
    left_way = scale * (left_way if left is None else left)
    ways, turns = way(right_way, left_way), turn(right_way, left_way, robot.tread)
    theta = summed(turns)
    used = theta[:-1] + turns / 2 if heading is None else heading(theta, turns)
    return record(log, summed(ways * np.cos(used)), summed(ways * np.sin(used)), theta, ways, turns)


def right_wheel_negated(log, robot):
    right, left = wheels(log, robot)
    return variant(log, robot, right=-right, left=left)


def counters_in_file_order(log, robot):
    scale = math.tau * robot.radius / robot.gear / robot.counts_per_rev
    one, two = (np.asarray(log[key], float)[1:] * scale for key in ("counter1", "counter2"))
    return variant(log, robot, right=one * robot.sign_right, left=two * robot.sign_left)


def magnitudes_of_the_counts(log, robot):
    right, left = wheels(log, robot)
    return variant(log, robot, right=abs(right), left=abs(left))


def gear_forgotten(log, robot):
    return variant(log, robot, scale=robot.gear)


def radius_in_centimetres(log, robot):
    return variant(log, robot, scale=100)


def counts_per_rev_quartered(log, robot):
    return variant(log, robot, scale=4)


def tread_squared(log, robot):
    return variant(log, robot, turn=lambda right, left, tread: (right - left) / tread**2)


def tread_made_positive(log, robot):
    return variant(log, robot, turn=lambda right, left, tread: (right - left) / abs(tread))


def tread_made_negative(log, robot):
    return variant(log, robot, turn=lambda right, left, tread: (right - left) / -abs(tread))


def tread_multiplied(log, robot):
    return variant(log, robot, turn=lambda right, left, tread: (right - left) * tread)


def sum_for_mean(log, robot):
    return variant(log, robot, way=lambda right, left: right + left)


def right_wheel_for_the_body(log, robot):
    return variant(log, robot, way=lambda right, left: right)


def half_tread(log, robot):
    return variant(log, robot, turn=lambda right, left, tread: 2 * (right - left) / tread)


def heading_after_the_step(log, robot):
    return variant(log, robot, heading=lambda theta, a: theta[1:])


def three_quarters_of_the_turn(log, robot):
    return variant(log, robot, heading=lambda theta, a: theta[:-1] + 0.75 * a)


def wrapped_sum(log, robot):
    out = midpoint_vectors(log, robot)
    return {**out, "theta": np.angle(np.exp(1j * out["theta"]))}


def time_untouched(log, robot):
    return {**midpoint_vectors(log, robot), "time": np.asarray(log["time"], float)}


def milliseconds(log, robot):
    out = midpoint_vectors(log, robot)
    return {**out, "time": 1000 * out["time"]}


def time_from_row_1(log, robot):
    out = midpoint_vectors(log, robot)
    return {**out, "time": out["time"] - (out["time"][1] if len(out["time"]) > 1 else 0)}


def median_dt(log, robot):
    out = midpoint_vectors(log, robot)
    dt = np.diff(out["time"], prepend=-1.0)
    typical = np.median(dt[1:]) if len(dt) > 1 else 1.0
    return {**out, "velocity": out["velocity"] * dt / typical, "yaw_rate": out["yaw_rate"] * dt / typical}


def speed_by_hypot(log, robot):
    out = midpoint_vectors(log, robot)
    speed = np.hypot(np.diff(out["x"]), np.diff(out["y"])) / np.diff(out["time"])
    return {**out, "velocity": np.append(0, speed)}


def speed_smoothed(log, robot):
    out = midpoint_vectors(log, robot)
    v = out["velocity"]
    return {**out, "velocity": np.append(v[:1], (v[1:] + v[:-1]) / 2)}


def yaw_rate_in_degrees(log, robot):
    out = midpoint_vectors(log, robot)
    return {**out, "yaw_rate": np.degrees(out["yaw_rate"])}


def gradient_for_the_yaw_rate(log, robot):
    out = midpoint_vectors(log, robot)
    return out if len(out["time"]) < 2 else {**out, "yaw_rate": np.gradient(out["theta"], out["time"])}


def row_0_used(log, robot):
    right, left = (
        sign * math.tau * robot.radius / robot.gear / robot.counts_per_rev * np.asarray(log[f"counter{number}"], float)
        for sign, number in ((robot.sign_right, robot.right_counter), (robot.sign_left, robot.left_counter))
    )
    way, turn = (right + left) / 2, (right - left) / robot.tread
    theta = np.cumsum(turn)
    out = record(log, np.cumsum(way * np.cos(theta - turn)), np.cumsum(way * np.sin(theta - turn)), theta, way[1:], turn[1:])
    return {key: out[key] for key in KEYS}


def heading_kept_in_float16(log, robot):
    out = midpoint_vectors(log, robot)
    return {**out, "theta": out["theta"].astype(np.float16)}


def key_misspelt(log, robot):
    out = midpoint_vectors(log, robot)
    return {**{key: out[key] for key in KEYS[:-1]}, "yawrate": out["yaw_rate"]}


def columns_in_a_table(log, robot):
    out = midpoint_vectors(log, robot)
    return np.column_stack([out[key] for key in KEYS])


def log_changed(log, robot):
    out = midpoint_vectors(log, robot)
    log["time"] = out["time"]
    return out


def three_rows_needed(log, robot):
    out = midpoint_vectors(log, robot)
    out["velocity"][0] = out["velocity"][1]
    return out


WRONG = {
    "right wheel negated": (right_wheel_negated, "spins instead of driving", "subtle"),
    "counters in file order": (counters_in_file_order, "right_counter ignored", "plain"),
    "magnitudes": (magnitudes_of_the_counts, "never reverses", "subtle"),
    "gear forgotten": (gear_forgotten, "no gear", "plain"),
    "radius in cm": (radius_in_centimetres, "times 100", "subtle"),
    "decoded again": (counts_per_rev_quartered, "counts_per_rev / 4", "subtle"),
    "tread squared": (tread_squared, "T**2", "subtle"),
    "|tread|": (tread_made_positive, "mirrored", "plain"),
    "-|tread|": (tread_made_negative, "i-Cart assumed", "subtle"),
    "tread multiplied": (tread_multiplied, "times T", "subtle"),
    "sum": (sum_for_mean, "not halved", "plain"),
    "right wheel only": (right_wheel_for_the_body, "left wheel left out of the way", "subtle"),
    "half tread": (half_tread, "yaw doubled", "plain"),
    "new heading": (heading_after_the_step, "heading after the step", "plain"),
    "three quarters": (three_quarters_of_the_turn, "no rule", "subtle"),
    "wrapped": (wrapped_sum, "theta wrapped", "plain"),
    "time untouched": (time_untouched, "stamps", "plain"),
    "milliseconds": (milliseconds, "time in ms", "plain"),
    "time from row 1": (time_from_row_1, "begins below zero", "subtle"),
    "median dt": (median_dt, "one dt for all rows", "subtle"),
    "hypot": (speed_by_hypot, "no sign, and the chord", "subtle"),
    "smoothed": (speed_smoothed, "mean with the row before", "subtle"),
    "yaw rate in deg/s": (yaw_rate_in_degrees, "degrees", "plain"),
    "gradient": (gradient_for_the_yaw_rate, "central differences", "subtle"),
    "row 0 used": (row_0_used, "increments before the log", "plain"),
    "float16": (heading_kept_in_float16, "three digits", "subtle"),
    "key misspelt": (key_misspelt, "yawrate", "plain"),
    "table": (columns_in_a_table, "no dict", "plain"),
    "log changed": (log_changed, "writes into the log", "plain"),
    "one row": (three_rows_needed, "IndexError for one row", "plain"),
}
