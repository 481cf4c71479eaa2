"""wheel_signs(log): which counter is the right wheel's, and which way each counts; the motors are mirror images (slides 000)."""

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(log):
    """Return (sign_right, sign_left, right_counter): signs from the first quarter in motion, the right wheel from the last."""
    counters = np.array([log["counter1"], log["counter2"]], dtype=float)
    moving = np.flatnonzero(counters.any(axis=0))
    quarter = counters.shape[1] // 4
    signs = np.sign(counters[:, moving[0] : moving[0] + quarter].sum(axis=1)).astype(int)
    in_the_turn = signs * counters[:, moving[-1] + 1 - quarter : moving[-1] + 1].sum(axis=1)
    right = int(np.argmax(in_the_turn))
    return int(signs[right]), int(signs[1 - right]), right + 1


def cases(rng):
    """Draw logs with all sign pairs for each kind of turn, both counters, and now the one, now the other wheel a little ahead."""

    def logs(turn, rests=((False, False), (False, False))):
        """Return a log for each sign pair; both counters occur with like and with unlike signs, and so does either wheel ahead."""
        like, unlike = rng.permutation([1, 2]).tolist(), rng.permutation([1, 2]).tolist()
        return [
            *[(drive(rng, (sign, sign, right), turn, rests[0], right == 1),) for sign, right in zip((1, -1), like, strict=True)],
            *[
                (drive(rng, (sign, -sign, right), turn, rests[1], right == 2),)
                for sign, right in zip((1, -1), unlike, strict=True)
            ],
        ]

    listed = drive(rng, (-1, 1, 2), "gentle", (False, False), right_ahead=True)
    return [
        Group(Text("a gentle turn to the left", "緩やかな左旋回"), 3, logs("gentle")),
        Group(Text("a turn about the left wheel", "左車輪を中心とする旋回"), 2, logs("pivot")),
        Group(Text("a turn on the spot", "その場旋回"), 2, logs("spot")),
        Group(
            Text("rest at the beginning and the end", "最初と最後に静止している"),
            2,
            logs(rng.choice(["gentle", "pivot"]), ((True, True), (True, False))),
        ),
        Group(Text("lists", "リスト"), 1, [({key: values.tolist() for key, values in listed.items()},)]),
    ]


def drive(rng, robot, turn, rests, right_ahead):
    """Return the log of a robot (sign_right, sign_left, right_counter) that drives straight, then turns left.

    Where both wheels should run alike the right one is a few counts ahead if `right_ahead`, else the left one. `rests` says
    whether the log begins and ends at rest.
    """
    straight, turning, *resting = rng.integers([30, 30, 8, 8], [42, 42, 15, 15])
    speed, faster = rng.uniform(18, 40), 1.0
    if turn == "spot":  # so long and fast that the left wheel is behind its start soon after the straight part
        straight, turning, faster = straight - 5, (straight - 5) * 13 // 5, rng.uniform(1.6, 1.9)
    share = {"gentle": rng.uniform(0.3, 0.6), "pivot": 0.0, "spot": -1.0}[turn]
    in_turn = alike(rng, speed * faster, turning, right_ahead)[:, ::-1]
    in_turn = np.rint(in_turn * [[1.0], [share]])
    before, after = (np.zeros((2, rows if rest else 0)) for rows, rest in zip(resting, rests, strict=True))
    wheels = np.concatenate([before, alike(rng, speed, straight, right_ahead), in_turn, after], axis=1)
    wheels = wheels * [[robot[0]], [robot[1]]] + 0.0  # no negative zeros
    first, second = wheels if robot[2] == 1 else wheels[::-1]
    count = len(first)
    pwm = rng.integers(-100, 101, (2, count)).astype(float)
    time = 1.6e9 + rng.uniform(0.004, 0.006, count).cumsum()
    return {"time": time, "counter1": first, "counter2": second, "pwm1": pwm[0], "pwm2": pwm[1]}


def alike(rng, speed, rows, right_ahead):
    """Return the counts of two wheels that run alike but for a jitter, one of which is ahead from the first row on, (2, rows)."""
    counts = np.rint(rng.uniform(speed - 2, speed + 2, (2, rows)))
    leads = (counts[0] - counts[1]).cumsum()
    if leads[-1] == 0:
        counts[0, 0] += 1
        leads += 1
    if leads[-1] < 0:
        counts, leads = counts[::-1], -leads
    # begun after the last row at which the lead is least, the lead never falls back to 0
    begin = rows - int(leads[::-1].argmin())
    counts = np.concatenate([counts[:, begin:], counts[:, :begin]], axis=1)
    return counts if right_ahead else counts[::-1]


EXAMPLE_GENTLE = {
    "time": np.array([0.0, 0.005, 0.010, 0.015, 0.020, 0.025, 0.030, 0.035, 0.040, 0.045]),
    "counter1": np.array([0.0, 20.0, 21.0, 20.0, 19.0, 20.0, 21.0, 20.0, 20.0, 0.0]),
    "counter2": np.array([0.0, -21.0, -20.0, -20.0, -20.0, -10.0, -9.0, -10.0, -11.0, 0.0]),
    "pwm1": np.zeros(10),
    "pwm2": np.zeros(10),
}
EXAMPLE_ON_THE_SPOT = {
    "time": np.array([0.0, 0.005, 0.010, 0.015, 0.020, 0.025, 0.030, 0.035]),
    "counter1": np.array([30.0, 31.0, 30.0, -30.0, -29.0, -30.0, -30.0, -31.0]),
    "counter2": np.array([30.0, 29.0, 30.0, 30.0, 31.0, 30.0, 29.0, 30.0]),
    "pwm1": np.zeros(8),
    "pwm2": np.zeros(8),
}


def faster_wheel_taken_for_left(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 1) if s1 * c1.sum() < s2 * c2.sum() else (s2, s1, 2)


def signs_of_a_reversing_robot(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (-s1, -s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (-s2, -s1, 2)


def faster_wheel_taken_for_left_and_signs_reversed(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (-s1, -s2, 1) if s1 * c1.sum() < s2 * c2.sum() else (-s2, -s1, 2)


def signs_in_order_of_counters(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return s1, s2, 1 if s1 * c1.sum() > s2 * c2.sum() else 2


def signs_left_first(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s2, s1, 1) if s1 * c1.sum() > s2 * c2.sum() else (s1, s2, 2)


def left_counter_returned(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 2) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 1)


def counter_1_taken_for_right(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return s1, s2, 1


def counter_2_taken_for_right(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return s2, s1, 2


def icart_assumed(log):
    return 1, -1, 1


def beego_assumed(log):
    return -1, 1, 1


def no_mirror_assumed(log):
    return 1, 1, 1


def signs_always_plus(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    a, b = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (1, 1, 1) if a * c1.sum() > b * c2.sum() else (1, 1, 2)


def signs_always_opposite(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    s2 = -s1
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def signs_of_counter_1_for_both(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    s2 = s1
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def raw_counts_compared(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 1) if c1.sum() > c2.sum() else (s2, s1, 2)


def raw_counts_of_the_turn_compared(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    turn = moving[-(len(c1) // 5) :]
    return (s1, s2, 1) if c1[turn].sum() > c2[turn].sum() else (s2, s1, 2)


def straight_part_decides(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 1) if abs(c1[straight].sum()) > abs(c2[straight].sum()) else (s2, s1, 2)


def signs_of_the_whole_log(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = int(np.sign(c1.sum())), int(np.sign(c2.sum()))
    return (s1, s2, 1) if abs(c1.sum()) > abs(c2.sum()) else (s2, s1, 2)


def signs_of_the_whole_log_products(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = int(np.sign(c1.sum())), int(np.sign(c2.sum()))
    turn = np.flatnonzero((c1 != 0) | (c2 != 0))[-(len(c1) // 5) :]
    return (s1, s2, 1) if s1 * c1[turn].sum() > s2 * c2[turn].sum() else (s2, s1, 2)


def signs_of_the_turn(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    turn = moving[-(len(c1) // 5) :]
    s1, s2 = int(np.sign(c1[turn].sum())), int(np.sign(c2[turn].sum()))
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def sign_of_the_first_row(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = int(np.sign(c1[0])), int(np.sign(c2[0]))
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def first_row_without_zero(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = (1 if c1[0] > 0 else -1), (1 if c2[0] > 0 else -1)
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def first_row_zero_taken_for_plus(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = (1 if c1[0] >= 0 else -1), (1 if c2[0] >= 0 else -1)
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def sign_of_the_last_row(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = int(np.sign(c1[-1])), int(np.sign(c2[-1]))
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def last_row_decides(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 1) if s1 * c1[-1] > s2 * c2[-1] else (s2, s1, 2)


def way_without_direction_compared(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 1) if np.abs(c1).sum() > np.abs(c2).sum() else (s2, s1, 2)


def mean_of_the_signs(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = np.sign(c1).mean(), np.sign(c2).mean()
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def counts_for_signs(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    a, b = c1[straight].sum(), c2[straight].sum()
    return (a, b, 1) if s1 * c1.sum() > s2 * c2.sum() else (b, a, 2)


def truth_values_for_signs(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    a, b = s1 > 0, s2 > 0
    return (a, b, 1) if s1 * c1.sum() > s2 * c2.sum() else (b, a, 2)


def counters_numbered_from_zero(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 0) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 1)


def side_for_number(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, -1)


def name_for_number(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, "counter1") if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, "counter2")


def signs_nested(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return ((s1, s2), 1) if s1 * c1.sum() > s2 * c2.sum() else ((s2, s1), 2)


def signs_only(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1)


def number_first(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (1, s1, s2) if s1 * c1.sum() > s2 * c2.sum() else (2, s2, s1)


def left_counter_too(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(c1[straight].sum())), int(np.sign(c2[straight].sum()))
    return (s1, s2, 1, 2) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2, 1)


def pwm_taken_for_direction(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    s1, s2 = int(np.sign(np.sum(log["pwm1"]))), int(np.sign(np.sum(log["pwm2"])))
    return (s1, s2, 1) if s1 * c1.sum() > s2 * c2.sum() else (s2, s1, 2)


def running_counters_assumed(log):
    c1, c2 = np.asarray(log["counter1"], dtype=float), np.asarray(log["counter2"], dtype=float)
    d1, d2 = np.diff(c1), np.diff(c2)
    moving = np.flatnonzero((d1 != 0) | (d2 != 0))
    straight = moving[: len(c1) // 5]
    s1, s2 = int(np.sign(d1[straight].sum())), int(np.sign(d2[straight].sum()))
    return (s1, s2, 1) if s1 * d1.sum() > s2 * d2.sum() else (s2, s1, 2)


EXERCISE = Exercise(
    name="wheel_signs",
    notebook="odometry/encoders",
    points=10,
    parameters=("log",),
    quantities=("sign_right", "sign_left", "right_counter"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=((EXAMPLE_GENTLE,), (EXAMPLE_ON_THE_SPOT,)),
    mistakes=(
        Mistake(
            straight_part_decides,
            Text(
                "Right and left are told apart on the straight part, where both wheels run alike: a count or two decides. Only "
                "the turn shows which is the outer one.",
                "直進の部分で左右を判断しています。直進では両輪が同じように走るため、わずかな揺らぎで決まってしまいます。"
                "どちらが外側かは旋回の部分で分かります。",
            ),
        ),
        Mistake(
            signs_in_order_of_counters,
            Text(
                "The signs come back in the order counter 1, counter 2. Asked for are (sign_right, sign_left, right_counter): "
                "the right wheel's sign first, even if it is counter 2.",
                "符号がカウンタ 1、カウンタ 2 の順に返っています。求めるのは (sign_right, sign_left, right_counter) です。"
                "右車輪がカウンタ 2 のときも、右の符号が先です。",
            ),
        ),
        Mistake(
            counter_1_taken_for_right,
            Text(
                "Counter 1 is always taken for the right wheel. Find it from the turn: the outer wheel runs further.",
                "いつもカウンタ 1 を右車輪としています。旋回の部分から判断しましょう。外側の車輪の方が長く走ります。",
            ),
        ),
        Mistake(
            counter_2_taken_for_right,
            Text(
                "Counter 2 is always taken for the right wheel. Find it from the turn: the outer wheel runs further.",
                "いつもカウンタ 2 を右車輪としています。旋回の部分から判断しましょう。外側の車輪の方が長く走ります。",
            ),
        ),
        Mistake(
            icart_assumed,
            Text(
                "The answer is always the i-Cart's, whatever the log says. Read it from the counters: robots differ.",
                "ログに関係なく、いつも i-Cart の値を返しています。ロボットによって違うので、カウンタの値から判断しましょう。",
            ),
        ),
        Mistake(
            beego_assumed,
            Text(
                "The answer is always the Beego's, whatever the log says. Read it from the counters: robots differ.",
                "ログに関係なく、いつも Beego の値を返しています。ロボットによって違うので、カウンタの値から判断しましょう。",
            ),
        ),
        Mistake(
            no_mirror_assumed,
            Text(
                "The answer is always (1, 1, 1), whatever the log says. Read it from the counters: the motors are usually "
                "mounted as mirror images.",
                "ログに関係なく、いつも (1, 1, 1) を返しています。モータはふつう鏡向きに付いています。"
                "カウンタの値から判断しましょう。",
            ),
        ),
        Mistake(
            signs_always_plus,
            Text(
                "The right wheel is found, but both signs are always +1. Look whether each counter counts up or down on the "
                "straight part.",
                "右車輪は見つかっていますが、符号がいつも両方 +1 です。直進中に、それぞれのカウンタが増えるか減るかを調べましょう。",
            ),
        ),
        Mistake(
            signs_always_opposite,
            Text(
                "The two signs are always opposite to each other: one is found, the other assumed. Some robots have equal "
                "signs: look at each counter by itself.",
                "2 つの符号がいつも反対になっています。一方だけを調べ、もう一方は決めつけています。"
                "同じ符号のロボットもあるので、カウンタごとに調べましょう。",
            ),
        ),
        Mistake(
            signs_of_counter_1_for_both,
            Text(
                "Both wheels always get the same sign. The motors are mounted as mirror images on many robots: look at each "
                "counter by itself.",
                "両輪がいつも同じ符号になっています。多くのロボットではモータが鏡向きに付いています。カウンタごとに調べましょう。",
            ),
        ),
        Mistake(
            raw_counts_compared,
            Text(
                "The wheels are compared without their signs: a counter that counts down looks slow although its wheel is fast. "
                "Multiply by the signs first.",
                "符号を掛けずに左右を比べています。減る向きに数えるカウンタは、車輪が速くても遅く見えます。先に符号を掛けましょう。",
            ),
        ),
        Mistake(
            raw_counts_of_the_turn_compared,
            Text(
                "In the turn the wheels are compared without their signs: a counter that counts down looks slow although its "
                "wheel is fast. Multiply by the signs first.",
                "旋回の部分で、符号を掛けずに左右を比べています。減る向きに数えるカウンタは、車輪が速くても遅く見えます。"
                "先に符号を掛けましょう。",
            ),
        ),
        Mistake(
            signs_of_the_whole_log,
            Text(
                "The signs come from the sums over the whole log. In a long turn on the spot the left wheel runs further back "
                "than it ran forward: use the straight part alone.",
                "ログ全体の合計で符号を決めています。長いその場旋回では、左車輪は前進した分より多く後ろへ回ります。"
                "直進の部分だけを使いましょう。",
            ),
        ),
        Mistake(
            signs_of_the_whole_log_products,
            Text(
                "The signs come from the sums over the whole log, and so a long turn on the spot spoils them. Use the straight "
                "part alone for the signs.",
                "ログ全体の合計で符号を決めているため、その場旋回が長いと誤ります。符号は直進の部分だけで決めましょう。",
            ),
        ),
        Mistake(
            signs_of_the_turn,
            Text(
                "The signs come from the end of the drive, the turn. There the left wheel may stand still or run backwards: use "
                "the straight part at the beginning.",
                "走行の終わり、つまり旋回の部分で符号を決めています。旋回では左車輪が止まったり逆転したりします。"
                "最初の直進の部分を使いましょう。",
            ),
        ),
        Mistake(
            sign_of_the_first_row,
            Text(
                "The signs come from the first row. If the log begins at rest there is no count, and the sign becomes 0: look "
                "for the first rows in motion.",
                "最初の行で符号を決めています。静止から始まるログではカウントが 0 なので、符号も 0 になります。"
                "動き始めてからの行を使いましょう。",
            ),
        ),
        Mistake(
            first_row_without_zero,
            Text(
                "The signs come from the first row. If the log begins at rest there is no count, and 0 is taken for a negative "
                "one: look for the first rows in motion.",
                "最初の行で符号を決めています。静止から始まるログではカウントが 0 で、それを負とみなしています。"
                "動き始めてからの行を使いましょう。",
            ),
        ),
        Mistake(
            first_row_zero_taken_for_plus,
            Text(
                "The signs come from the first row. If the log begins at rest there is no count, and 0 is taken for a positive "
                "one: look for the first rows in motion.",
                "最初の行で符号を決めています。静止から始まるログではカウントが 0 で、それを正とみなしています。"
                "動き始めてからの行を使いましょう。",
            ),
        ),
        Mistake(
            sign_of_the_last_row,
            Text(
                "The signs come from the last row, in the turn or at rest. There the left wheel may run backwards or stand "
                "still: use the straight part.",
                "最後の行で符号を決めています。そこは旋回中か静止中で、左車輪は逆転していたり止まっていたりします。"
                "直進の部分を使いましょう。",
            ),
        ),
        Mistake(
            last_row_decides,
            Text(
                "Right and left are told apart by the last row alone. If the log ends at rest, nothing is counted there: "
                "compare the whole turn.",
                "最後の行だけで左右を判断しています。静止で終わるログではカウントがありません。旋回の部分全体を比べましょう。",
            ),
        ),
        Mistake(
            way_without_direction_compared,
            Text(
                "The wheels are compared by how much they turned, whichever way. On the spot both turn alike, one forward and "
                "one back: compare with the signs.",
                "回った向きを無視した量で左右を比べています。その場旋回では両輪が同じだけ回り、一方は前転、もう一方は逆転です。"
                "符号を付けて比べましょう。",
            ),
        ),
        Mistake(
            mean_of_the_signs,
            Text(
                "The signs are means over the log and are not +1 or -1 when a wheel stands still or turns back. Take the sign "
                "of a sum over the straight part.",
                "符号がログ全体の平均になっているため、車輪が止まったり逆転したりすると +1 や -1 になりません。"
                "直進の部分の合計の符号をとりましょう。",
            ),
        ),
        Mistake(
            counts_for_signs,
            Text(
                "The first two values are counts. Asked for are signs, +1 or -1: np.sign.",
                "最初の 2 つの値がカウントになっています。求めるのは符号(+1 か -1)です。np.sign を使いましょう。",
            ),
        ),
        Mistake(
            truth_values_for_signs,
            Text(
                "The signs are True and False, that is 1 and 0. Asked for are +1 and -1.",
                "符号が True / False、つまり 1 と 0 になっています。+1 か -1 を返しましょう。",
            ),
        ),
        Mistake(
            counters_numbered_from_zero,
            Text(
                "The counters are numbered 0 and 1. In the log they are called counter1 and counter2: answer 1 or 2.",
                "カウンタの番号が 0 と 1 になっています。ログでの名前は counter1 と counter2 です。1 か 2 で答えましょう。",
            ),
        ),
        Mistake(
            side_for_number,
            Text(
                "For counter 2 the third value is -1. It is the number of a counter, 1 or 2, not a sign.",
                "カウンタ 2 のとき、3 つ目の値が -1 になっています。これは符号ではなくカウンタの番号(1 か 2)です。",
            ),
        ),
        Mistake(
            name_for_number,
            Text(
                "The third value is a name. Asked for is the number of the right wheel's counter, 1 or 2.",
                "3 つ目の値が文字列です。右車輪のカウンタの番号を、数値の 1 か 2 で返しましょう。",
            ),
        ),
        Mistake(
            signs_nested,
            Text(
                "The signs come back as a pair within the tuple. Asked for are three values side by side: (sign_right, "
                "sign_left, right_counter).",
                "符号が組になって入れ子で返っています。(sign_right, sign_left, right_counter) の 3 つを並べて返しましょう。",
            ),
        ),
        Mistake(
            signs_only,
            Text(
                "Only the two signs come back. The third value is missing: which counter is the right wheel's?",
                "符号 2 つだけが返っています。3 つ目の値、右車輪のカウンタの番号が抜けています。",
            ),
        ),
        Mistake(
            number_first,
            Text(
                "The counter's number comes first. Asked for are (sign_right, sign_left, right_counter), in that order.",
                "カウンタの番号が先になっています。(sign_right, sign_left, right_counter) の順に返しましょう。",
            ),
        ),
        Mistake(
            left_counter_too,
            Text(
                "Four values come back. Asked for are three: (sign_right, sign_left, right_counter); the left counter is the "
                "other one.",
                "4 つの値が返っています。求めるのは (sign_right, sign_left, right_counter) の 3 つです。左のカウンタは残りの方です。",
            ),
        ),
        Mistake(
            pwm_taken_for_direction,
            Text(
                "The signs come from the PWM columns, which mean nothing here. Use the counters.",
                "PWM の列で符号を決めています。PWM の値はここでは意味を持ちません。カウンタを使いましょう。",
            ),
        ),
        Mistake(
            running_counters_assumed,
            Text(
                "Neighbouring counts are subtracted. The counters of this log are increments already: their signs tell the "
                "direction by themselves.",
                "隣どうしのカウントの差をとっています。このログのカウンタはすでに増分で、その符号がそのまま回転の向きを表します。",
            ),
        ),
        Mistake(
            faster_wheel_taken_for_left,
            Text(
                "Right and left come out exchanged: the wheel that runs further is called left. In a left turn, which wheel "
                "runs on the outer circle?",
                "左右が逆になっています。長く走った車輪が左とされています。左旋回で外側の円を走るのはどちらの車輪でしょうか。",
            ),
        ),
        Mistake(
            signs_of_a_reversing_robot,
            Text(
                "Both signs are turned round: multiplied by them, the counts of the straight drive are negative. Driving "
                "forward, both wheels must come out positive.",
                "符号が両方とも逆です。この符号を掛けると、直進中のカウントが負になります。"
                "前進では両輪とも正になるように決めましょう。",
            ),
        ),
        Mistake(
            faster_wheel_taken_for_left_and_signs_reversed,
            Text(
                "Both signs are turned round, and right and left are exchanged. Begin with the signs: driving forward, both "
                "wheels must come out positive.",
                "符号が両方とも逆で、左右も入れ替わっています。まず符号から直しましょう。前進では両輪とも正になるように決めます。",
            ),
        ),
        Mistake(
            left_counter_returned,
            Text(
                "The signs are right, but the third value is the left wheel's counter. Asked for is the right wheel's.",
                "符号は合っていますが、3 つ目の値が左車輪のカウンタになっています。右車輪のカウンタを返しましょう。",
            ),
        ),
        Mistake(
            signs_left_first,
            Text(
                "The two signs come back in the wrong order: left first. Asked for are (sign_right, sign_left, right_counter).",
                "2 つの符号の順序が逆で、左が先になっています。(sign_right, sign_left, right_counter) の順に返しましょう。",
            ),
        ),
    ),
)
