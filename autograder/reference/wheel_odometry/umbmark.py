"""umbmark(cw_errors, ccw_errors, side, tread): ratio of the wheels and correction of the tread (Borenstein and Feng 1996)."""

import math

import numpy as np

from autograder.draws import magnitudes, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(cw_errors, ccw_errors, side, tread):
    """Return (E_d, E_b); the curvature of a side is used instead of its radius, so that straight sides are no special case."""
    clockwise, counter = (math.fsum(row[0] for row in errors) / len(errors) for errors in (cw_errors, ccw_errors))
    alpha, beta = -(clockwise + counter) / (4 * side), -(clockwise - counter) / (4 * side)
    half = tread * math.sin(beta / 2) / side
    return (1 + half) / (1 - half), 1 / (1 - 2 * alpha / math.pi)


def cases(rng):
    """Draw return errors of a few runs each way, larger than those of a good robot, so that near misses show."""

    def sizes():
        return rng.uniform(1.2, 2.8), rng.uniform(0.3, 0.6)

    def runs(count, x):
        """Return `count` errors that scatter about x; those along y are of another size, on the other side of zero."""
        y = -np.sign(x) * rng.uniform(0.15, 0.3) - 0.1 * x
        return np.column_stack([rng.uniform(-0.08, 0.08, count) + x, rng.uniform(-0.08, 0.08, count) + y])

    def test(n, m, cw_sign, ccw_sign):
        def draw():
            side, tread = sizes()
            return cw_sign * rng.uniform(0.2, 1.2), ccw_sign * rng.uniform(0.2, 1.2), side, tread

        def telling(cw, ccw, side, tread):
            return min(abs(cw + ccw), abs(cw - ccw)) > 0.35 * side and abs(abs(cw) - abs(ccw)) > 0.15

        cw, ccw, side, tread = until(draw, telling)
        return runs(n, cw), runs(m, ccw), side, tread

    def straight_sides():
        """Return a test in which both directions end at the same x, to the bit."""
        side, tread = sizes()
        cw = runs(3, magnitudes(rng, 0.3, 0.9))
        ccw = cw.copy()
        ccw[:, 1] *= -0.7
        return cw, ccw, side, tread

    signs = rng.permutation([(1, 1), (-1, -1), (1, -1), (-1, 1)]).tolist()
    listed = test(3, 2, *signs[0])
    whole = rng.integers(4, 8, (2, 2)) * [[1, -1]], -rng.integers(1, 3, (3, 2)) * [[1, -1]], rng.integers(4, 7), 1
    return [
        Group(Text("five runs each way", "各方向5回"), 3, [test(5, 5, *pair) for pair in signs]),
        Group(
            Text("not as many one way as the other", "方向により回数が違う場合"),
            2,
            [test(4, 2, *signs[1]), test(3, 5, *signs[2])],
        ),
        Group(Text("one run each way", "各方向1回"), 1, [test(1, 1, *signs[3])]),
        Group(Text("no difference between the wheels", "左右の車輪に差がない場合"), 1, [straight_sides()]),
        Group(Text("lists", "リスト"), 1, [(listed[0].tolist(), listed[1].tolist(), *listed[2:])]),
        Group(Text("whole numbers", "整数の入力"), 1, [whole]),
    ]


EXAMPLE = (np.array([[0.10, -0.05], [0.14, -0.03]]), np.array([[-0.04, 0.06], [-0.08, 0.04], [-0.06, 0.02]]), 4.0, 0.3)
EXAMPLE_STRAIGHT = (np.array([[0.2, 0.1]]), np.array([[0.2, -0.1]]), 2.0, 0.25)


def y_errors_used(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[1]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[1]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def distances_used(cw_errors, ccw_errors, side, tread):
    cw = np.hypot(*np.mean(np.asarray(cw_errors, dtype=float), axis=0))
    ccw = np.hypot(*np.mean(np.asarray(ccw_errors, dtype=float), axis=0))
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def centres_in_both_columns(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float))
    ccw = np.mean(np.asarray(ccw_errors, dtype=float))
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def first_runs_only(cw_errors, ccw_errors, side, tread):
    cw = np.asarray(cw_errors, dtype=float)[0][0]
    ccw = np.asarray(ccw_errors, dtype=float)[0][0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def last_runs_only(cw_errors, ccw_errors, side, tread):
    cw = np.asarray(cw_errors, dtype=float)[-1][0]
    ccw = np.asarray(ccw_errors, dtype=float)[-1][0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def sums_for_means(cw_errors, ccw_errors, side, tread):
    cw = np.sum(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.sum(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def medians_for_means(cw_errors, ccw_errors, side, tread):
    cw = np.median(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.median(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def means_without_sign(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.abs(np.asarray(cw_errors, dtype=float)), axis=0)[0]
    ccw = np.mean(np.abs(np.asarray(ccw_errors, dtype=float)), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def directions_exchanged(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (ccw - cw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def wheels_inverted_and_base_inverted(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return 1 / wheels, 1 / base


def base_inverted(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2 - alpha) / (np.pi / 2)
    return wheels, base


def minus_forgotten(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (4 * side), (cw - ccw) / (4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def alpha_reversed(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def alpha_and_beta_exchanged(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    beta, alpha = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def two_sides_for_four(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-2 * side), (cw - ccw) / (-2 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def eight_sides_for_four(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-8 * side), (cw - ccw) / (-8 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def side_forgotten(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / -4, (cw - ccw) / -4
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def angles_in_degrees(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = np.rad2deg((cw + ccw) / (-4 * side)), np.rad2deg((cw - ccw) / (-4 * side))
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def ninety_and_radians_mixed(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = 90 / (90 - alpha)
    return wheels, base


def sine_forgotten(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / (beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def whole_beta_in_the_sine(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def whole_side_for_half(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def tangent_for_sine(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.tan(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def whole_tread_for_half(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread) / (radius - tread) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def order_exchanged(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return base, wheels


def angles_returned(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    return alpha, beta


def corrected_tread_returned(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base * tread


def straight_sides_not_thought_of(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2)
    wheels = (radius + tread / 2) / (radius - tread / 2)
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def straight_sides_give_zero(cw_errors, ccw_errors, side, tread):
    cw = np.mean(np.asarray(cw_errors, dtype=float), axis=0)[0]
    ccw = np.mean(np.asarray(ccw_errors, dtype=float), axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 0.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


def runs_pooled(cw_errors, ccw_errors, side, tread):
    both = np.concatenate([np.asarray(cw_errors, dtype=float), np.asarray(ccw_errors, dtype=float)])
    cw = ccw = np.mean(both, axis=0)[0]
    alpha, beta = (cw + ccw) / (-4 * side), (cw - ccw) / (-4 * side)
    radius = side / 2 / np.sin(beta / 2) if beta else np.inf
    wheels = (radius + tread / 2) / (radius - tread / 2) if beta else 1.0
    base = (np.pi / 2) / (np.pi / 2 - alpha)
    return wheels, base


EXERCISE = Exercise(
    name="umbmark",
    notebook="odometry/wheel_odometry",
    points=5,
    parameters=("cw_errors", "ccw_errors", "side", "tread"),
    reference=reference,
    cases=cases,
    examples=(EXAMPLE, EXAMPLE_STRAIGHT),
    tolerance=LAST_AXIS,
    quantities=("E_d", "E_b"),
    mistakes=(
        Mistake(
            y_errors_used,
            Text(
                "The errors along y are used. Borenstein and Feng's formulas here take those along x: the first column.",
                "y方向の誤差を使っています。この式で使うのはx方向の誤差、つまり1列目です。",
            ),
        ),
        Mistake(
            distances_used,
            Text(
                "The distances of the centres of gravity are used. Their sign is lost that way: take the x of each centre.",
                "重心の原点からの距離を使っています。それでは符号が失われます。重心のx座標を使いましょう。",
            ),
        ),
        Mistake(
            centres_in_both_columns,
            Text(
                "The mean is taken over both columns. The centre of gravity has an x of its own: mean along the runs, axis=0.",
                "2列をまとめて平均しています。重心のx座標は、走行について(axis=0で)平均したものです。",
            ),
        ),
        Mistake(
            first_runs_only,
            Text(
                "Only the first run of each direction is used. Take the mean of all runs, the centre of gravity.",
                "各方向の1回目の走行しか使っていません。全走行の平均、つまり重心を使いましょう。",
            ),
        ),
        Mistake(
            last_runs_only,
            Text(
                "Only the last run of each direction is used. Take the mean of all runs, the centre of gravity.",
                "各方向の最後の走行しか使っていません。全走行の平均、つまり重心を使いましょう。",
            ),
        ),
        Mistake(
            sums_for_means,
            Text(
                "The errors of the runs are summed up. The centre of gravity is their mean.",
                "走行の誤差を合計しています。重心は平均です。",
            ),
        ),
        Mistake(
            medians_for_means,
            Text(
                "The medians of the runs are used. The centre of gravity is their mean.",
                "走行の中央値を使っています。重心は平均です。",
            ),
        ),
        Mistake(
            means_without_sign,
            Text(
                "The signs of the errors are lost. Which of wheels and tread is wrong shows in the signs alone.",
                "誤差の符号が失われています。車輪とトレッドのどちらが違うのかは、符号から分かります。",
            ),
        ),
        Mistake(
            directions_exchanged,
            Text(
                "E_d is inverted. Either beta has the opposite sign (it is clockwise minus counter-clockwise), or the inner circle stands above the outer one.",
                "E_dが逆数になっています。betaの符号が逆か(時計回りから反時計回りを引きます)、内側の円を分子にしていませんか。",
            ),
        ),
        Mistake(
            wheels_inverted_and_base_inverted,
            Text(
                "Both results are inverted. E_d is the right wheel over the left one, E_b the true tread over the nominal one.",
                "2つの値がどちらも逆数です。E_dは右÷左、E_bは真のトレッド÷公称値です。",
            ),
        ),
        Mistake(
            base_inverted,
            Text(
                "E_b is inverted. A quarter turn stands above, the quarter turn less alpha below.",
                "E_bが逆数になっています。分子が90度、分母が90度からalphaを引いたものです。",
            ),
        ),
        Mistake(
            minus_forgotten,
            Text(
                "The minus sign of -4 side is missing, so that alpha and beta have the opposite sign.",
                "-4 sideのマイナスが抜けているため、alphaとbetaの符号が逆です。",
            ),
        ),
        Mistake(
            alpha_reversed,
            Text(
                "alpha has the opposite sign, so that E_b corrects the tread the wrong way. Both are divided by -4 side.",
                "alphaの符号が逆で、E_bがトレッドを逆向きに補正しています。alphaもbetaも-4 sideで割ります。",
            ),
        ),
        Mistake(
            alpha_and_beta_exchanged,
            Text(
                "alpha and beta are exchanged: the sum belongs to alpha (tread), the difference to beta (wheels).",
                "alphaとbetaが逆です。和がalpha(トレッド)、差がbeta(車輪)です。",
            ),
        ),
        Mistake(
            two_sides_for_four,
            Text(
                "alpha and beta are twice what they should be: the square has four sides, so divide by -4 side.",
                "alphaとbetaが2倍です。正方形には4辺あるので、-4 sideで割りましょう。",
            ),
        ),
        Mistake(
            eight_sides_for_four,
            Text(
                "alpha and beta are half of what they should be: sum and difference are not halved before they are divided by -4 side.",
                "alphaとbetaが半分です。和と差は、2で割らずに-4 sideで割ります。",
            ),
        ),
        Mistake(
            side_forgotten,
            Text(
                "The side of the square is missing in alpha and beta: metres over metres make an angle.",
                "alphaとbetaで正方形の辺の長さが抜けています。長さを長さで割って角度になります。",
            ),
        ),
        Mistake(
            angles_in_degrees,
            Text(
                "alpha and beta are turned into degrees, and then used where rad are needed.",
                "alphaとbetaを度に直した後、radが必要な式に使っています。",
            ),
        ),
        Mistake(
            ninety_and_radians_mixed,
            Text(
                "E_b mixes units: 90 is in degrees, alpha in rad. Use pi/2.",
                "E_bで単位が混ざっています。90は度、alphaはradです。π/2を使いましょう。",
            ),
        ),
        Mistake(
            sine_forgotten,
            Text(
                "The radius is computed without the sine. For angles that are not small sin(beta/2) differs from beta/2.",
                "半径の式にsinがありません。角度が小さくなければ、sin(beta/2)とbeta/2は違います。",
            ),
        ),
        Mistake(
            whole_beta_in_the_sine,
            Text(
                "The radius is computed with sin(beta). Half a side is seen under half the angle: sin(beta/2).",
                "半径の式でsin(beta)を使っています。辺の半分に対応するのは角度の半分、sin(beta/2)です。",
            ),
        ),
        Mistake(
            whole_side_for_half,
            Text(
                "The radius is computed with the whole side. Half a side stands over the sine of half the angle.",
                "半径の式で辺全体を使っています。sin(beta/2)で割るのは辺の半分です。",
            ),
        ),
        Mistake(
            tangent_for_sine,
            Text(
                "The radius is computed with the tangent. The radius is the long side of that triangle, so it is the sine.",
                "半径をtanで計算しています。半径はこの三角形の斜辺なので、sinを使います。",
            ),
        ),
        Mistake(
            whole_tread_for_half,
            Text(
                "The whole tread is added and subtracted. Each wheel runs half a tread off the middle.",
                "トレッド全体を足し引きしています。各車輪は中心からトレッドの半分だけ離れています。",
            ),
        ),
        Mistake(
            order_exchanged,
            Text(
                "The order is exchanged: E_d (wheels) first, then E_b (tread).",
                "順序が逆です。E_d(車輪)、E_b(トレッド)の順に返しましょう。",
            ),
        ),
        Mistake(
            angles_returned,
            Text(
                "alpha and beta come back. They are angles on the way to the result: E_d and E_b follow from them.",
                "alphaとbetaが返っています。これらは途中の角度で、ここからE_dとE_bを求めます。",
            ),
        ),
        Mistake(
            corrected_tread_returned,
            Text(
                "The second number is the corrected tread. Asked for is the factor E_b alone.",
                "2つ目の値が補正後のトレッドになっています。求めるのは係数E_bだけです。",
            ),
        ),
        Mistake(
            straight_sides_not_thought_of,
            Text(
                "With beta = 0 the radius is infinite, and infinity over infinity is no number. Straight sides mean equal wheels: E_d is 1.",
                "beta = 0では半径が無限大になり、無限大÷無限大は数になりません。辺がまっすぐなら左右の車輪は等しく、E_dは1です。",
            ),
        ),
        Mistake(
            straight_sides_give_zero,
            Text(
                "With beta = 0 the result is 0. E_d is a ratio: equal wheels give 1.",
                "beta = 0のとき0が返っています。E_dは比なので、左右が等しければ1です。",
            ),
        ),
        Mistake(
            runs_pooled,
            Text(
                "All runs are thrown together. One direction alone cannot tell the two faults apart: each has a centre of gravity of its own.",
                "両方向の走行をまとめて平均しています。方向ごとに別々に重心を求めないと、2種類の誤差を区別できません。",
            ),
        ),
    ),
)
