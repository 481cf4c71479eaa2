"""wheel_speed(counts, dt, radius, gear, counts_per_rev): count increments to the speed of the wheel's rim, slides 000, overview 6."""

import numpy as np

from autograder.draws import until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(counts, dt, radius, gear, counts_per_rev):
    """Return the distance of each increment, a share of the circumference, over its time step."""
    if np.ndim(counts) > 0:
        steps = np.broadcast_to(np.asarray(dt, dtype=float), np.shape(counts))
        return [reference(count, step, radius, gear, counts_per_rev) for count, step in zip(counts, steps, strict=True)]
    circumference = 2 * np.pi * radius
    return float(count_share(counts, gear, counts_per_rev) * circumference / dt)


def count_share(counts, gear, counts_per_rev):
    """Return which part of a turn of the wheel these counts are."""
    return float(counts) / (float(gear) * float(counts_per_rev))


def cases(rng):
    """Draw speeds of 0.2 to 1.5 m/s; steps of time are never alike in an array, and the gear is whole except in one group."""

    def robot():
        return float(rng.uniform(0.04, 0.2)), int(rng.integers(20, 140)), int(rng.choice([128, 500, 512, 1000, 1024, 2000]))

    def counts(step, radius, gear, counts_per_rev):
        speed = rng.uniform(0.2, 1.5, np.shape(step))
        return np.floor(speed * step / (2 * np.pi * radius) * gear * counts_per_rev) + 3.0

    def number():
        def draw():
            step, size = float(rng.uniform(0.01, 0.08)), robot()
            return int(counts(step, *size)), step, *size

        return until(draw, no_whole_turns)

    def even(size):
        step, robots = float(rng.uniform(0.01, 0.08)), robot()
        return counts(np.full(size, step), *robots), step, *robots

    def uneven(size):
        steps, robots = rng.uniform(0.01, 0.03, size) * rng.choice([1.0, 2.0, 3.0], size), robot()
        return counts(steps, *robots), steps, *robots

    def geared(fraction, step):
        radius, gear, counts_per_rev = robot()
        robots = radius, float(gear + fraction), counts_per_rev
        return counts(step, *robots), step, *robots

    back, both = number(), uneven(int(rng.integers(5, 9)))
    both[0][::2] *= -1
    whole, single = uneven(int(rng.integers(4, 8))), uneven(1)
    listed = rng.integers(3000, 9000, int(rng.integers(4, 8))).tolist()
    seconds = rng.integers(2, 5, len(listed)).tolist()
    return [
        Group(Text("numbers", "数値"), 2, [number(), number()]),
        Group(
            Text("arrays with even steps of time", "等間隔の配列"),
            2,
            [even(int(rng.integers(4, 7))), even(int(rng.integers(7, 11)))],
        ),
        Group(
            Text("arrays with uneven steps of time", "時間間隔が不ぞろいの配列"),
            3,
            [uneven(int(rng.integers(4, 7))), uneven(int(rng.integers(7, 11)))],
        ),
        Group(Text("turning backwards", "逆転"), 2, [(-back[0], *back[1:]), both]),
        Group(
            Text("whole numbers in arrays and lists, a single entry", "整数の配列・リスト、要素 1 つの配列"),
            1,
            [(whole[0].astype(int), *whole[1:]), (listed, seconds, 1, *robot()[1:]), single],
        ),
        Group(
            Text("a gear ratio that is no whole number", "整数でないギア比"),
            1,
            [
                geared(rng.uniform(0.2, 0.45), float(rng.uniform(0.01, 0.08))),
                geared(rng.uniform(0.55, 0.8), rng.uniform(0.01, 0.08, 5)),
            ],
        ),
    ]


def no_whole_turns(counts, dt, radius, gear, counts_per_rev):
    """Tell whether an integer division would lose something, whatever the counts are divided by."""
    return all(0.05 < counts / part % 1 < 0.95 for part in (gear, counts_per_rev, gear * counts_per_rev))


def time_forgotten(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev)


def time_multiplied(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) * np.asarray(dt)


def time_divided_twice(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt) ** 2


def period_of_5_ms(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / 0.005


def period_of_10_ms(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / 0.01


def period_of_20_ms(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / 0.02


def mean_time_step(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.mean(dt)


def median_time_step(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.median(dt)


def smallest_time_step(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.min(dt)


def first_time_step(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.ravel(dt)[0]


def neighbouring_time_step(counts, dt, radius, gear, counts_per_rev):
    steps = np.roll(dt, 1) if np.ndim(dt) else dt
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / steps


def last_time_step(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.ravel(dt)[-1]


def total_time(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.sum(dt)


def steps_taken_for_stamps(counts, dt, radius, gear, counts_per_rev):
    steps = np.diff(dt, prepend=0) if np.ndim(dt) else dt
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / steps


def time_in_milliseconds(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / (np.asarray(dt) / 1000)


def speed_in_millimetres(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / (np.asarray(dt) * 1000)


def speed_in_kilometres_per_hour(counts, dt, radius, gear, counts_per_rev):
    return 3.6 * 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def radius_forgotten(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def radius_divided(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt) / radius


def radius_squared(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius**2 * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def area_of_the_wheel(counts, dt, radius, gear, counts_per_rev):
    return np.pi * radius**2 * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def diameter_for_radius(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * 2 * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def radius_as_diameter(counts, dt, radius, gear, counts_per_rev):
    return np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def two_pi_forgotten(counts, dt, radius, gear, counts_per_rev):
    return radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def two_pi_divided(counts, dt, radius, gear, counts_per_rev):
    return radius * np.asarray(counts) / (gear * counts_per_rev * 2 * np.pi) / np.asarray(dt)


def degrees_for_rad(counts, dt, radius, gear, counts_per_rev):
    return radius * 360 * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def pi_shortened(counts, dt, radius, gear, counts_per_rev):
    return 2 * 3.14 * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def gear_forgotten(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / counts_per_rev / np.asarray(dt)


def gear_multiplied(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) * gear / counts_per_rev / np.asarray(dt)


def gear_divided_twice(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / gear**2 / counts_per_rev / np.asarray(dt)


def gear_added(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear + counts_per_rev) / np.asarray(dt)


def gear_rounded_down(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (int(gear) * counts_per_rev) / np.asarray(dt)


def gear_rounded(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (round(gear) * counts_per_rev) / np.asarray(dt)


def counts_per_rev_forgotten(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / gear / np.asarray(dt)


def counts_per_rev_multiplied(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / gear * counts_per_rev / np.asarray(dt)


def counts_taken_for_pulses(counts, dt, radius, gear, counts_per_rev):
    return 4 * 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def counts_per_rev_taken_for_pulses(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (gear * 4 * counts_per_rev) / np.asarray(dt)


def numbers_of_the_slides(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * 0.14457758 * np.asarray(counts) / (150 * 400) / np.asarray(dt)


def gear_of_the_slides(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.asarray(counts) / (150 * counts_per_rev) / np.asarray(dt)


def radius_of_the_slides(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * 0.14457758 * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def counts_per_second(counts, dt, radius, gear, counts_per_rev):
    return np.asarray(counts) / np.asarray(dt)


def turns_per_minute(counts, dt, radius, gear, counts_per_rev):
    return 60 * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def ratio_inverted(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * gear * counts_per_rev / np.asarray(counts) / np.asarray(dt)


def increments_differenced(counts, dt, radius, gear, counts_per_rev):
    increments = np.diff(counts, prepend=0) if np.ndim(counts) else counts
    return 2 * np.pi * radius * increments / (gear * counts_per_rev) / np.asarray(dt)


def increments_differenced_number_too(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.diff(np.atleast_1d(counts), prepend=0) / (gear * counts_per_rev) / np.asarray(dt)


def increments_differenced_from_the_first(counts, dt, radius, gear, counts_per_rev):
    increments = np.diff(counts, prepend=counts[0]) if np.ndim(counts) else counts
    return 2 * np.pi * radius * increments / (gear * counts_per_rev) / np.asarray(dt)


def increments_differenced_and_shorter(counts, dt, radius, gear, counts_per_rev):
    if np.ndim(counts) == 0:
        return 2 * np.pi * radius * counts / (gear * counts_per_rev) / dt
    steps = dt if np.ndim(dt) == 0 else np.asarray(dt)[1:]
    return 2 * np.pi * radius * np.diff(counts) / (gear * counts_per_rev) / steps


def increments_added_up(counts, dt, radius, gear, counts_per_rev):
    total = np.cumsum(counts) if np.ndim(counts) else counts
    return 2 * np.pi * radius * total / (gear * counts_per_rev) / np.asarray(dt)


def mean_speed_so_far(counts, dt, radius, gear, counts_per_rev):
    if np.ndim(counts) == 0:
        return 2 * np.pi * radius * counts / (gear * counts_per_rev) / dt
    steps = np.ones(len(counts)) * dt
    return 2 * np.pi * radius * np.cumsum(counts) / (gear * counts_per_rev) / np.cumsum(steps)


def one_mean_speed(counts, dt, radius, gear, counts_per_rev):
    steps = np.ones(np.shape(counts)) * dt
    return 2 * np.pi * radius * np.sum(counts) / (gear * counts_per_rev) / np.sum(steps)


def smoothed_over_three(counts, dt, radius, gear, counts_per_rev):
    speed = np.atleast_1d(2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt))
    return np.convolve(speed, np.ones(3) / 3, mode="same")


def direction_lost(counts, dt, radius, gear, counts_per_rev):
    return np.abs(2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt))


def backward_set_to_zero(counts, dt, radius, gear, counts_per_rev):
    return np.maximum(2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt), 0)


def direction_reversed(counts, dt, radius, gear, counts_per_rev):
    return -2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)


def integer_division_by_gear(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * (np.asarray(counts) // gear) / counts_per_rev / np.asarray(dt)


def whole_counts_on_the_axle(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.trunc(np.asarray(counts) / gear) / counts_per_rev / np.asarray(dt)


def integer_division_by_both(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * (np.asarray(counts) // (gear * counts_per_rev)) / np.asarray(dt)


def decimals_cut_off(counts, dt, radius, gear, counts_per_rev):
    speed = np.zeros_like(counts)
    speed[...] = 2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt)
    return speed


def rounded(counts, dt, radius, gear, counts_per_rev):
    return np.round(2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt), 3)


def rounded_coarsely(counts, dt, radius, gear, counts_per_rev):
    return np.round(2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt), 2)


def number_becomes_array(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.atleast_1d(counts) / (gear * counts_per_rev) / np.asarray(dt)


def single_entry_becomes_number(counts, dt, radius, gear, counts_per_rev):
    return np.squeeze(2 * np.pi * radius * np.asarray(counts) / (gear * counts_per_rev) / np.asarray(dt))


def only_the_first(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.ravel(counts)[0] / (gear * counts_per_rev) / np.ravel(dt)[0]


def only_the_last(counts, dt, radius, gear, counts_per_rev):
    return 2 * np.pi * radius * np.ravel(counts)[-1] / (gear * counts_per_rev) / np.ravel(dt)[-1]


EXERCISE = Exercise(
    name="wheel_speed",
    notebook="odometry/encoders",
    points=5,
    parameters=("counts", "dt", "radius", "gear", "counts_per_rev"),
    gear=3,
    reference=reference,
    cases=cases,
    examples=(
        (133, 0.005, 0.14457758, 150, 400),
        (np.array([133.0, 266.0, -133.0]), np.array([0.005, 0.010, 0.005]), 0.14457758, 150, 400),
        ([1200, -800], 0.02, 0.0406, 54.0699, 2048),
    ),
    mistakes=(
        Mistake(
            time_forgotten,
            Text(
                "dt is missing: this is the distance of each increment in m, not a speed. Distance over time is speed.",
                "dt が抜けていて、速度ではなく増分ごとの距離 [m] になっています。速度は距離を時間で割ったものです。",
            ),
        ),
        Mistake(
            time_multiplied,
            Text(
                "The distance is multiplied by dt. The unit m·s gives it away: divide.",
                "距離に dt を掛けています。単位が m·s になってしまいます。割りましょう。",
            ),
        ),
        Mistake(
            time_divided_twice,
            Text(
                "dt is divided by twice: m/s^2 is an acceleration. Once is enough.",
                "dt で 2 回割っているため、単位が m/s^2(加速度)になっています。割るのは 1 回です。",
            ),
        ),
        Mistake(
            period_of_5_ms,
            Text(
                "The time step is always 0.005 s. Real logs jitter and lose rows: use the argument dt.",
                "時間間隔がいつも 0.005 s になっています。実際のログでは間隔が揺れ、行が抜けることもあります。"
                "引数 dt を使いましょう。",
            ),
        ),
        Mistake(
            period_of_10_ms,
            Text(
                "The time step is always 0.01 s. Real logs jitter and lose rows: use the argument dt.",
                "時間間隔がいつも 0.01 s になっています。実際のログでは間隔が揺れ、行が抜けることもあります。"
                "引数 dt を使いましょう。",
            ),
        ),
        Mistake(
            period_of_20_ms,
            Text(
                "The time step is always 0.02 s. Real logs jitter and lose rows: use the argument dt.",
                "時間間隔がいつも 0.02 s になっています。実際のログでは間隔が揺れ、行が抜けることもあります。"
                "引数 dt を使いましょう。",
            ),
        ),
        Mistake(
            mean_time_step,
            Text(
                "All counts are divided by the mean of dt. Each increment has its own time step: where dt is long, more counts "
                "fit in.",
                "すべてのカウントを dt の平均で割っています。増分にはそれぞれの時間間隔があります。"
                "dt が長ければカウントも多くなります。",
            ),
        ),
        Mistake(
            median_time_step,
            Text(
                "All counts are divided by the median of dt. Each increment has its own time step: where dt is long, more "
                "counts fit in.",
                "すべてのカウントを dt の中央値で割っています。増分にはそれぞれの時間間隔があります。"
                "dt が長ければカウントも多くなります。",
            ),
        ),
        Mistake(
            smallest_time_step,
            Text(
                "All counts are divided by the smallest dt. Each increment has its own time step: where dt is long, more counts "
                "fit in.",
                "すべてのカウントを dt の最小値で割っています。増分にはそれぞれの時間間隔があります。"
                "dt が長ければカウントも多くなります。",
            ),
        ),
        Mistake(
            first_time_step,
            Text(
                "All counts are divided by the first time step. Each increment has its own: divide entry by entry.",
                "すべてのカウントを最初の時間間隔で割っています。増分にはそれぞれの時間間隔があるので、要素ごとに割りましょう。",
            ),
        ),
        Mistake(
            neighbouring_time_step,
            Text(
                "Each increment is divided by the time step of the row before. Counts and time steps of one row belong together.",
                "増分を 1 つ前の行の時間間隔で割っています。同じ行のカウントと時間間隔を組み合わせましょう。",
            ),
        ),
        Mistake(
            last_time_step,
            Text(
                "All counts are divided by the last time step. Each increment has its own: divide entry by entry.",
                "すべてのカウントを最後の時間間隔で割っています。増分にはそれぞれの時間間隔があるので、要素ごとに割りましょう。",
            ),
        ),
        Mistake(
            total_time,
            Text(
                "Every increment is divided by the sum of all time steps. Divide each by its own dt.",
                "どの増分も時間間隔の合計で割っています。それぞれの dt で割りましょう。",
            ),
        ),
        Mistake(
            steps_taken_for_stamps,
            Text(
                "Neighbouring entries of dt are subtracted as if they were time stamps. dt holds the time steps already.",
                "dt を時刻とみなして、隣どうしの差をとっています。dt はすでに時間間隔です。",
            ),
        ),
        Mistake(
            time_in_milliseconds,
            Text(
                "The speed is 1000 times too large: dt is treated as ms. It is in s.",
                "速度が 1000 倍になっています。dt を ms とみなしています。dt の単位は s です。",
            ),
        ),
        Mistake(
            speed_in_millimetres,
            Text(
                "The speed is 1000 times too small: a step in ms, or km instead of m? dt is in s, the radius in m, and the "
                "speed in m/s.",
                "速度が 1/1000 になっています。時間を ms、または距離を km にしていませんか。dt は s、半径は m、速度は m/s です。",
            ),
        ),
        Mistake(
            speed_in_kilometres_per_hour,
            Text("The speed is in km/h. Asked for is m/s.", "速度が km/h になっています。求めるのは m/s です。"),
        ),
        Mistake(
            radius_forgotten,
            Text(
                "The radius is missing: this is the angular velocity of the wheel in rad/s. The speed of its rim is the next "
                "line of overview 6.",
                "半径が抜けていて、タイヤの角速度 [rad/s] になっています。概要 #6 の次の行で、周の速度に変換します。",
            ),
        ),
        Mistake(
            radius_divided,
            Text(
                "The angular velocity is divided by the radius. A larger wheel rolls further in one turn.",
                "角速度を半径で割っています。大きなタイヤほど、1 回転で長い距離を進むはずです。",
            ),
        ),
        Mistake(
            radius_squared,
            Text(
                "The radius is in it squared. Distance is angle times radius, once.",
                "半径が 2 乗されています。距離は角度に半径を 1 回掛けたものです。",
            ),
        ),
        Mistake(
            area_of_the_wheel,
            Text(
                "π r² is the area of the wheel. In one turn it rolls its circumference.",
                "π r² はタイヤの面積です。1 回転で進む距離は円周の長さです。",
            ),
        ),
        Mistake(
            diameter_for_radius,
            Text(
                "The speed is twice what it should be, as if the radius were a diameter somewhere or a 2 counted twice. One "
                "turn of the wheel "
                "is 2πr: 0.908 m for r = 0.1446 m.",
                "速度が 2 倍になっています。半径の代わりに直径を使ったか、2 を余分に掛けています。"
                "1 回転は 2πr で、r = 0.1446 m なら 0.908 m です。",
            ),
        ),
        Mistake(
            radius_as_diameter,
            Text(
                "The speed is half of what it should be: π r instead of 2π r, as if the radius were the diameter. One turn of "
                "the wheel is 2πr: "
                "0.908 m for r = 0.1446 m.",
                "速度が半分になっています。2πr ではなく πr、つまり半径を直径とみなした値です。"
                "1 回転は 2πr で、r = 0.1446 m なら 0.908 m です。",
            ),
        ),
        Mistake(
            two_pi_forgotten,
            Text(
                "2π is missing: counts over counts per turn are turns, and one turn is 2π rad.",
                "2π が抜けています。カウントを 1 回転分のカウントで割ると回転数になります。1 回転は 2π rad です。",
            ),
        ),
        Mistake(
            two_pi_divided,
            Text(
                "2π stands in the denominator. From turns to rad you multiply; look at the brackets too: x / a * b is not x / "
                "(a * b).",
                "2π が分母に入っています。回転数を rad にするには 2π を掛けます。括弧にも注意しましょう。"
                "x / a * b と x / (a * b) は違います。",
            ),
        ),
        Mistake(
            degrees_for_rad,
            Text(
                "One turn is counted as 360: degrees. Angle times radius is a distance only if the angle is in rad.",
                "1 回転を 360 度としています。角度 × 半径が距離になるのは、角度が rad のときだけです。",
            ),
        ),
        Mistake(
            pi_shortened,
            Text(
                "π is shortened to 3.14; the error adds up over a drive. Use np.pi.",
                "π を 3.14 としています。走行するうちに誤差が積み重なります。np.pi を使いましょう。",
            ),
        ),
        Mistake(
            gear_forgotten,
            Text(
                "The gear ratio is missing: this is the speed of a wheel that sits on the motor shaft. The motor turns gear "
                "times while the wheel turns once.",
                "ギア比が抜けていて、モータ軸にタイヤを直接付けたときの速度になっています。"
                "タイヤが 1 回転する間に、モータは gear 回転します。",
            ),
        ),
        Mistake(
            gear_multiplied,
            Text(
                "The gear ratio is multiplied, so the wheel turns faster than the motor. gear is the number of motor turns for "
                "one turn of the wheel.",
                "ギア比を掛けているため、タイヤがモータより速く回ることになっています。"
                "gear はタイヤ 1 回転あたりのモータの回転数です。",
            ),
        ),
        Mistake(
            gear_divided_twice,
            Text(
                "The gear ratio is divided by twice. Once takes you from the motor to the wheel.",
                "ギア比で 2 回割っています。モータからタイヤへの変換は 1 回だけです。",
            ),
        ),
        Mistake(
            gear_added,
            Text(
                "gear and counts_per_rev are added. In one turn of the wheel the motor makes gear turns of counts_per_rev "
                "counts each: "
                "how many counts is that?",
                "gear と counts_per_rev を足しています。"
                "タイヤが 1 回転する間にモータは gear 回転し、1 回転ごとに counts_per_rev カウント数えます。"
                "全部で何カウントでしょうか。",
            ),
        ),
        Mistake(
            gear_rounded_down,
            Text(
                "The decimals of the gear ratio are cut off. Leave out int(): the Beego's gear is 54.0699.",
                "ギア比の小数部分が切り捨てられています。int() は使いません。Beego のギア比は 54.0699 です。",
            ),
        ),
        Mistake(
            gear_rounded,
            Text(
                "The gear ratio is rounded to a whole number. Use it as given: the Beego's gear is 54.0699.",
                "ギア比が整数に丸められています。渡された値のまま使いましょう。Beego のギア比は 54.0699 です。",
            ),
        ),
        Mistake(
            counts_per_rev_forgotten,
            Text(
                "counts_per_rev is missing: counts are treated like turns of the motor. How many counts make one turn?",
                "counts_per_rev が抜けていて、カウントをモータの回転数として扱っています。何カウントで 1 回転でしょうか。",
            ),
        ),
        Mistake(
            counts_per_rev_multiplied,
            Text(
                "counts_per_rev is multiplied. In Python a / b * c is (a / b) * c: put brackets around the denominator.",
                "counts_per_rev を掛けています。Python では a / b * c は (a / b) * c です。分母を括弧で囲みましょう。",
            ),
        ),
        Mistake(
            counts_taken_for_pulses,
            Text(
                "The speed is four times what it should be: pulses and counts are mixed up. counts and counts_per_rev are both "
                "counts, "
                "4x decoding included.",
                "速度が 4 倍になっています。パルスとカウントを混同しています。"
                "counts も counts_per_rev も 4 逓倍した後のカウントです。",
            ),
        ),
        Mistake(
            counts_per_rev_taken_for_pulses,
            Text(
                "The speed is a quarter of what it should be: either counts_per_rev is taken for pulses (it is in counts, 4x "
                "decoding included), "
                "or a 2 that belongs above the fraction line stands below it.",
                "速度が 1/4 になっています。counts_per_rev をパルス数とみなしているか(実際は 4 逓倍した後のカウント数です)、"
                "分子にあるべき 2 が分母に入っています。",
            ),
        ),
        Mistake(
            numbers_of_the_slides,
            Text(
                "The numbers of the i-Cart in the slides are used whatever the arguments say. Use radius, gear and counts_per_rev.",
                "引数に関係なく、スライドの i-Cart の値を使っています。引数 radius, gear, counts_per_rev を使いましょう。",
            ),
        ),
        Mistake(
            gear_of_the_slides,
            Text(
                "The gear ratio is always 150, that of the i-Cart in the slides. Use the argument gear: robots differ.",
                "ギア比がいつも 150(スライドの i-Cart の値)になっています。ロボットによって違うので、引数 gear を使いましょう。",
            ),
        ),
        Mistake(
            radius_of_the_slides,
            Text(
                "The radius is always that of the i-Cart in the slides. Use the argument radius: robots differ.",
                "半径がいつもスライドの i-Cart の値になっています。ロボットによって違うので、引数 radius を使いましょう。",
            ),
        ),
        Mistake(
            counts_per_second,
            Text(
                "These are counts per second. Counts become an angle of the motor, of the wheel, then a distance of its rim: "
                "overview 6, line by line.",
                "これは 1 秒あたりのカウント数です。"
                "カウント → モータの角度 → タイヤの角度 → 周の距離と、概要 #6 の順に変換しましょう。",
            ),
        ),
        Mistake(
            turns_per_minute,
            Text(
                "These are turns per minute. Asked for is the speed of the rim in m/s.",
                "これは毎分の回転数です。求めるのは周の速度 [m/s] です。",
            ),
        ),
        Mistake(
            ratio_inverted,
            Text(
                "The ratio is upside down: more counts give a lower speed. Divide the counts by the counts of one turn of the wheel.",
                "比が逆で、カウントが多いほど速度が小さくなっています。カウントを、タイヤ 1 回転分のカウントで割りましょう。",
            ),
        ),
        Mistake(
            increments_differenced,
            Text(
                "From each count the one before is subtracted, and the result looks like an acceleration. This log stores "
                "increments already: "
                "no np.diff. (Eq. (4) of the notes subtracts because it starts from a running counter.)",
                "各カウントから 1 つ前のカウントを引いていて、加速度のような値になっています。"
                "このログのカウントはすでに増分なので、np.diff は不要です。"
                "(ノートの式 (4) で引き算をするのは、累積カウントから始めているためです。)",
            ),
        ),
        Mistake(
            increments_differenced_number_too,
            Text(
                "From each count the one before is subtracted, and the result looks like an acceleration. This log stores "
                "increments already: "
                "no np.diff. (A single number comes back as an array, too.)",
                "各カウントから 1 つ前のカウントを引いていて、加速度のような値になっています。"
                "このログのカウントはすでに増分なので、np.diff は不要です。"
                "(数値を渡したときに配列が返る点も直しましょう。)",
            ),
        ),
        Mistake(
            increments_differenced_from_the_first,
            Text(
                "From each count the one before is subtracted, and the first speed is 0. This log stores increments already: no "
                "np.diff.",
                "各カウントから 1 つ前のカウントを引いていて、最初の速度は 0 になっています。"
                "このログのカウントはすでに増分なので、np.diff は不要です。",
            ),
        ),
        Mistake(
            increments_differenced_and_shorter,
            Text(
                "Neighbouring counts are subtracted, and one entry is lost. This log stores increments already: no np.diff.",
                "隣どうしのカウントの差をとっているため、要素が 1 つ減っています。"
                "このログのカウントはすでに増分なので、np.diff は不要です。",
            ),
        ),
        Mistake(
            increments_added_up,
            Text(
                "The counts are added up before dividing, so the speed grows and grows. Each increment over its own step is the "
                "speed there: no cumsum.",
                "カウントを累積してから割っているため、速度が増え続けます。増分をその時間間隔で割れば速度になります。"
                "cumsum は不要です。",
            ),
        ),
        Mistake(
            mean_speed_so_far,
            Text(
                "This is the mean speed since the start: total distance over total time. Asked for is the speed of each increment.",
                "これは出発してからの平均速度(総距離 ÷ 総時間)です。求めるのは増分ごとの速度です。",
            ),
        ),
        Mistake(
            one_mean_speed,
            Text(
                "From an array comes one number, the mean speed. Each increment has a speed of its own: as many out as in.",
                "配列を渡しても平均速度の数値 1 つが返っています。増分ごとに速度があるので、入力と同じ個数を返しましょう。",
            ),
        ),
        Mistake(
            smoothed_over_three,
            Text(
                "The speeds are smoothed over three samples. Return them as measured; the steps of one count that you see are "
                "no error.",
                "速度を 3 サンプルで平均しています。測ったままの値を返しましょう。1 カウント分の段差は誤りではありません。",
            ),
        ),
        Mistake(
            direction_lost,
            Text(
                "A wheel that turns backwards gets a positive speed: the sign is lost. Leave out abs().",
                "逆転しているタイヤの速度が正になっています。符号が失われています。abs() は使いません。",
            ),
        ),
        Mistake(
            backward_set_to_zero,
            Text(
                "A wheel that turns backwards gets the speed 0. Negative speeds are speeds too.",
                "逆転しているタイヤの速度が 0 になっています。負の速度もそのまま返しましょう。",
            ),
        ),
        Mistake(
            direction_reversed,
            Text(
                "The speed has the wrong sign. Here positive counts give a positive speed; which way a wheel is mounted is "
                "dealt with later.",
                "速度の符号が逆です。ここでは正のカウントは正の速度になります。モータの取り付けの向きは、あとの課題で扱います。",
            ),
        ),
        Mistake(
            integer_division_by_gear,
            Text(
                "// drops the fraction: 133 counts // 150 is 0. Divide with /.",
                "// は小数部分を切り捨てます。133 // 150 は 0 です。/ で割りましょう。",
            ),
        ),
        Mistake(
            whole_counts_on_the_axle,
            Text(
                "The counts on the wheel axle, dC, are cut to whole numbers. Most of a count gets lost there: leave out int.",
                "車輪軸上のカウント dC の小数部分が切り捨てられています。ここで多くが失われます。int への変換は不要です。",
            ),
        ),
        Mistake(
            integer_division_by_both,
            Text(
                "Only whole turns of the wheel count: // drops the fraction. Divide with /.",
                "// のため、タイヤの 1 回転に満たない分が捨てられています。/ で割りましょう。",
            ),
        ),
        Mistake(
            decimals_cut_off,
            Text(
                "With whole numbers the decimals are cut off: an array made with zeros_like or empty_like from integers holds "
                "integers only. "
                "Make it with dtype=float.",
                "整数が渡されると小数部分が切り捨てられます。整数から zeros_like や empty_like で作った配列には整数しか入りません。"
                "dtype=float を指定しましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The speed is rounded to 3 decimals. Distances are summed from it later, and so are the rounding errors: round "
                "only for display.",
                "速度が小数第 3 位までに丸められています。あとで距離を積算すると丸め誤差も積み重なります。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            rounded_coarsely,
            Text(
                "The speed is rounded to 2 decimals. Distances are summed from it later, and so are the rounding errors: round "
                "only for display.",
                "速度が小数第 2 位までに丸められています。あとで距離を積算すると丸め誤差も積み重なります。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            number_becomes_array,
            Text(
                "For single numbers an array comes back. A number in, a number out: np.asarray leaves a number without a shape, "
                "np.atleast_1d and [counts] do not.",
                "数値を渡しても配列が返っています。数値には数値を返しましょう。"
                "np.atleast_1d や [counts] ではなく np.asarray を使えば、数値は数値のままです。",
            ),
        ),
        Mistake(
            single_entry_becomes_number,
            Text(
                "An array with one entry comes back as a bare number. An array in, an array out, whatever its length: leave out "
                "squeeze and the like.",
                "要素 1 つの配列を渡すと、ただの数値が返っています。長さに関係なく、配列には配列を返しましょう。"
                "squeeze などは不要です。",
            ),
        ),
        Mistake(
            only_the_first,
            Text(
                "From an array only the first speed comes back. Is there a return inside a loop?",
                "配列を渡しても最初の速度だけが返っています。return がループの中に入っていませんか。",
            ),
        ),
        Mistake(
            only_the_last,
            Text(
                "From an array only the last speed comes back. Is the result overwritten in a loop?",
                "配列を渡しても最後の速度だけが返っています。ループの中で結果を上書きしていませんか。",
            ),
        ),
    ),
)
