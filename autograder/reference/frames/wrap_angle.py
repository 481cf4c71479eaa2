"""wrap_angle(theta) to [-pi, pi), for numbers and arrays of any shape; pi becomes -pi. Misconception C21: wrap only for display."""

import math

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(theta):
    """Return each angle less a whole number of turns, counted one angle at a time."""
    angles = np.asarray(theta, dtype=float)
    wrapped = [angle - 2 * math.pi * math.floor(angle / (2 * math.pi) + 0.5) for angle in angles.ravel().tolist()]
    return np.reshape(wrapped, angles.shape) if angles.ndim else wrapped[0]


def cases(rng):
    """Draw angles by the turn they lie in; none is near an odd multiple of pi but pi itself, none comes out near zero."""

    def angle(turns):
        """Return an angle of that many turns (0: within half a turn), in the front or the rear half plane, to either side."""
        return 2 * np.pi * turns + rng.choice([-1.0, 1.0]) * rng.choice([rng.uniform(0.5, 1.4), rng.uniform(1.7, 3.0)])

    def in_both_halves(turns):
        return [2 * np.pi * turns + side * rng.uniform(*half) for side in (-1.0, 1.0) for half in ((0.5, 1.4), (1.7, 3.0))]

    def array(turns, *shape):
        """Return angles of turns in turn, in an order of their own."""
        return np.reshape(rng.permutation([angle(turns[k % len(turns)]) for k in range(math.prod(shape))]), shape)

    mixed = array([0, 1, -1, 2, -2], int(rng.integers(6, 10)))
    # none of these is within 0.1 of a multiple of pi
    whole = int(rng.choice([-14, -11, -8, -5, -4, 4, 5, 8, 10, 14]))
    listed = rng.choice([-14, -8, -4, -2, 1, 2, 4, 5, 10, 14], int(rng.integers(4, 7)))
    return [
        Group(
            Text("angles within half a turn already", "はじめから ±π の範囲にある角度"),
            1,
            [(angle(0),), (np.array(in_both_halves(0)),)],
        ),
        Group(Text("one turn too many", "1 回転多い角度"), 2, [(a,) for a in (*in_both_halves(1)[:2], *in_both_halves(-1)[2:])]),
        Group(Text("several turns", "何回転もした角度"), 2, [(angle(3),), (angle(-3),), (array([2, -2, 3, -3], 5),)]),
        Group(
            Text("arrays of any shape", "いろいろな形の配列"),
            2,
            [(mixed,), (array([-1, 2, 0, 1, -2], 2, 3),), (array([1, -1, 2], int(rng.integers(4, 6)), 1),), (array([-1], 1),)],
        ),
        Group(
            Text("whole numbers and lists", "整数やリスト"),
            1,
            [(whole,), (listed,), (array([1, -2, 0], 4).tolist(),)],
        ),
        Group(Text("exactly pi", "ちょうど π"), 1, [(math.pi,), (np.array([angle(0), math.pi, angle(1)]),)]),
    ]


def not_wrapped(theta):
    return np.asarray(theta, dtype=float)


def pi_kept(theta):
    return np.arctan2(np.sin(theta), np.cos(theta))


def zero_to_one_turn(theta):
    return np.asarray(theta) % (2 * np.pi)


def wrapped_only_once(theta):
    theta = np.asarray(theta, dtype=float)
    return np.where(theta >= np.pi, theta - 2 * np.pi, np.where(theta < -np.pi, theta + 2 * np.pi, theta))


def wrapped_once_without_pi(theta):
    theta = np.asarray(theta, dtype=float)
    return np.where(theta > np.pi, theta - 2 * np.pi, np.where(theta < -np.pi, theta + 2 * np.pi, theta))


def wrapped_at_most_twice(theta):
    theta = np.asarray(theta, dtype=float)
    for _ in range(2):
        theta = np.where(theta >= np.pi, theta - 2 * np.pi, np.where(theta < -np.pi, theta + 2 * np.pi, theta))
    return theta


def only_large_angles_wrapped(theta):
    theta = np.asarray(theta, dtype=float)
    return np.where(theta >= np.pi, (theta + np.pi) % (2 * np.pi) - np.pi, theta)


def only_negative_angles_wrapped(theta):
    theta = np.asarray(theta, dtype=float)
    return np.where(theta < -np.pi, (theta + np.pi) % (2 * np.pi) - np.pi, theta)


def half_turn_taken_off_without_adding(theta):
    return np.asarray(theta) % (2 * np.pi) - np.pi


def half_turn_not_taken_off(theta):
    return (np.asarray(theta) + np.pi) % (2 * np.pi)


def half_turn_added_twice(theta):
    return (np.asarray(theta) + np.pi) % (2 * np.pi) + np.pi


def modulo_half_a_turn(theta):
    return np.asarray(theta) % np.pi


def half_turn_range(theta):
    return (np.asarray(theta) + np.pi / 2) % np.pi - np.pi / 2


def half_turn_period(theta):
    return (np.asarray(theta) + np.pi) % np.pi - np.pi


def two_turn_period(theta):
    return (np.asarray(theta) + 2 * np.pi) % (4 * np.pi) - 2 * np.pi


def remainder_with_the_sign_of_the_angle(theta):
    return np.fmod(theta, 2 * np.pi)


def shifted_remainder_with_the_sign_of_the_angle(theta):
    return np.fmod(np.asarray(theta) + np.pi, 2 * np.pi) - np.pi


def turns_added(theta):
    theta = np.asarray(theta, dtype=float)
    return theta + 2 * np.pi * np.floor((theta + np.pi) / (2 * np.pi))


def turns_taken_off_without_two_pi(theta):
    theta = np.asarray(theta, dtype=float)
    return theta - np.floor((theta + np.pi) / (2 * np.pi))


def half_turns_taken_off(theta):
    theta = np.asarray(theta, dtype=float)
    return theta - np.pi * np.floor((theta + np.pi) / (2 * np.pi))


def clipped(theta):
    return np.clip(np.asarray(theta, dtype=float), -np.pi, np.pi)


def folded_by_arcsin(theta):
    return np.arcsin(np.sin(theta))


def sign_lost(theta):
    return np.abs((np.asarray(theta) + np.pi) % (2 * np.pi) - np.pi)


def sign_turned_round(theta):
    return -((np.asarray(theta) + np.pi) % (2 * np.pi) - np.pi)


def returned_in_degrees(theta):
    return np.rad2deg((np.asarray(theta) + np.pi) % (2 * np.pi) - np.pi)


def taken_for_degrees(theta):
    return (np.deg2rad(theta) + np.pi) % (2 * np.pi) - np.pi


def pi_shortened(theta):
    return (np.asarray(theta) + 3.14) % 6.28 - 3.14


def turns_of_the_first_angle(theta):
    theta = np.asarray(theta, dtype=float)
    turns = np.floor((theta.ravel()[0] + np.pi) / (2 * np.pi))
    return theta - 2 * np.pi * turns


def only_the_first_angle(theta):
    return (np.ravel(theta)[0] + np.pi) % (2 * np.pi) - np.pi


def flattened(theta):
    wrapped = (np.asarray(theta) + np.pi) % (2 * np.pi) - np.pi
    return wrapped if np.ndim(theta) == 0 else wrapped.ravel()


def numbers_become_arrays(theta):
    return (np.atleast_1d(theta) + np.pi) % (2 * np.pi) - np.pi


def single_entries_become_numbers(theta):
    return np.squeeze((np.asarray(theta) + np.pi) % (2 * np.pi) - np.pi)


def unwrapped_instead(theta):
    return np.unwrap(theta)


def whole_numbers_cut_off(theta):
    wrapped = np.array(theta)
    wrapped[...] = (wrapped + np.pi) % (2 * np.pi) - np.pi
    return wrapped


def rounded(theta):
    return np.round((np.asarray(theta) + np.pi) % (2 * np.pi) - np.pi, 3)


EXERCISE = Exercise(
    name="wrap_angle",
    notebook="odometry/frames",
    points=5,
    parameters=("theta",),
    reference=reference,
    cases=cases,
    examples=((4.0,), (math.pi,), (np.array([[-7.0, 0.5, 2.0], [12.0, -1.0, -4.0]]),)),
    mistakes=(
        Mistake(
            not_wrapped,
            Text(
                "The angles come back as they were: nothing is wrapped. (Is there a 180 or 360 in your code? The angles are in rad.)",
                "角度がそのまま返っていて、折り返されていません。(180 や 360 で折り返していませんか。角度は rad です。)",
            ),
        ),
        Mistake(
            pi_kept,
            Text(
                "Nearly: only pi itself is wrong. It stays pi, but the range asked for is [-pi, pi), with pi left out, so that each direction has one "
                "value only. arctan2, np.angle, rounding the number of turns, and > in place of >= all keep pi.",
                "あと一歩です。違うのは π のときだけで、π のまま残っています。範囲は [-π, π) で、π は含みません。"
                "1 つの向きに値が 1 つだけ対応するようにするためです。arctan2 や np.angle、回転数の四捨五入、>= のかわりの > などでは π が残ります。",
            ),
        ),
        Mistake(
            zero_to_one_turn,
            Text(
                "The angles come out between 0 and 2 pi. Asked for is -pi to pi: how can the range of the remainder be shifted, before and after?",
                "結果が 0〜2π の範囲になっています。求めるのは -π から π です。剰余をとる前と後で、範囲をどうずらせばよいでしょうか。",
            ),
        ),
        Mistake(
            wrapped_only_once,
            Text(
                "One turn at most is taken off or added. A robot that has turned round several times needs more: repeat it, or count the turns.",
                "足し引きしているのが 1 回転だけです。何回転もしたロボットではそれでは足りません。繰り返すか、回転数を数えましょう。",
            ),
        ),
        Mistake(
            wrapped_once_without_pi,
            Text(
                "One turn at most is taken off or added, and pi itself stays pi, which [-pi, pi) leaves out. After several turns more is needed: repeat "
                "it, or count the turns.",
                "足し引きしているのが 1 回転だけで、ちょうど π のときも π のままです(範囲 [-π, π) は π を含みません)。"
                "何回転もしたときには足りません。繰り返すか、回転数を数えましょう。",
            ),
        ),
        Mistake(
            wrapped_at_most_twice,
            Text(
                "Two turns at most are taken off or added. The number of turns has no limit: repeat until it fits, or count them.",
                "足し引きしているのが 2 回転までです。回転数に上限はありません。範囲に入るまで繰り返すか、回転数を数えましょう。",
            ),
        ),
        Mistake(
            only_large_angles_wrapped,
            Text(
                "Angles below -pi are left as they are: turns to the right are not wrapped.",
                "-π より小さい角度がそのまま残っています。右回りの回転が折り返されていません。",
            ),
        ),
        Mistake(
            only_negative_angles_wrapped,
            Text(
                "Angles of pi and more are left as they are: turns to the left are not wrapped.",
                "π 以上の角度がそのまま残っています。左回りの回転が折り返されていません。",
            ),
        ),
        Mistake(
            half_turn_taken_off_without_adding,
            Text(
                "The range is right, but every angle looks the opposite way: half a turn is taken off after the remainder, and nothing is added before it. "
                "What becomes of 0?",
                "範囲は合っていますが、どの角度も反対の向きになっています。剰余をとったあとで π を引いていますが、その前に何も足していません。"
                "0 を入れると何になりますか。",
            ),
        ),
        Mistake(
            half_turn_not_taken_off,
            Text(
                "Half a turn is added before the remainder and never taken off again. What becomes of 0?",
                "剰余をとる前に π を足したまま、あとで引いていません。0 を入れると何になりますか。",
            ),
        ),
        Mistake(
            half_turn_added_twice,
            Text(
                "Half a turn is added before the remainder and once more after it: the results lie between pi and 3 pi.",
                "剰余をとる前に π を足し、あとでもう一度足しているため、結果が π〜3π になっています。",
            ),
        ),
        Mistake(
            modulo_half_a_turn,
            Text(
                "The angles are taken modulo pi. Half a turn more is the opposite direction: a full turn is 2 pi.",
                "角度を π で割った余りにしています。半回転ずれると反対の向きになります。1 回転は 2π です。",
            ),
        ),
        Mistake(
            half_turn_range,
            Text(
                "The angles are wrapped to -pi/2 to pi/2, as by arctan: opposite directions come out the same. A full turn is 2 pi.",
                "角度が(arctan のように)-π/2〜π/2 に折り返され、反対の向きが同じ値になっています。1 回転は 2π です。",
            ),
        ),
        Mistake(
            half_turn_period,
            Text(
                "The remainder is taken by pi, so that opposite directions come out the same, all negative. A full turn is 2 pi; brackets round 2 * np.pi "
                "help.",
                "π で割った余りを使っているため、反対の向きが同じ値になり、しかもすべて負です。1 回転は 2π です。(2 * np.pi) のかっこも確かめましょう。",
            ),
        ),
        Mistake(
            two_turn_period,
            Text(
                "The angles are wrapped to -2 pi to 2 pi: that is two turns wide. One turn is 2 pi in all.",
                "-2π〜2π の、2 回転分の幅に折り返されています。幅は全体で 2π です。",
            ),
        ),
        Mistake(
            remainder_with_the_sign_of_the_angle,
            Text(
                "The results lie between -2 pi and 2 pi: the remainder (fmod, or int() of the number of turns) keeps the sign of the angle, and the "
                "range is not shifted.",
                "結果が -2π〜2π の範囲になっています。fmod(または回転数の int())では剰余が角度と同じ符号になり、範囲のずらしもありません。",
            ),
        ),
        Mistake(
            shifted_remainder_with_the_sign_of_the_angle,
            Text(
                "Positive angles are right, but those below -pi are not: fmod (or int() of the number of turns) rounds towards 0, not downwards. "
                "Compare np.fmod(-1, 3) with -1 % 3.",
                "正の角度は合っていますが、-π より小さい角度が違います。fmod(または回転数の int())は切り捨ての向きが 0 に近いほうです。"
                "np.fmod(-1, 3) と -1 % 3 を比べてみましょう。",
            ),
        ),
        Mistake(
            turns_added,
            Text(
                "The number of turns is counted rightly, but the turns are added instead of taken off: the angles grow.",
                "回転数は正しく数えていますが、引くかわりに足しているため、角度がかえって大きくなっています。",
            ),
        ),
        Mistake(
            turns_taken_off_without_two_pi,
            Text(
                "The number of turns itself is taken off the angle. Each turn is 2 pi rad.",
                "角度から回転数そのものを引いています。1 回転は 2π rad です。",
            ),
        ),
        Mistake(
            half_turns_taken_off,
            Text(
                "For each turn only pi is taken off. One turn is 2 pi.",
                "1 回転ごとに π しか引いていません。1 回転は 2π です。",
            ),
        ),
        Mistake(
            clipped,
            Text(
                "Angles outside are cut off at the ends of the range (clip). Wrapping keeps the direction: only whole turns may be taken off.",
                "範囲の外の角度が(clip で)端の値に切られています。折り返しでは向きが変わってはいけません。取り除けるのは整数回転分だけです。",
            ),
        ),
        Mistake(
            folded_by_arcsin,
            Text(
                "arcsin folds the rear half plane to the front: a sine alone does not tell a direction. Cosine is needed, too.",
                "arcsin を使うと、後ろ向きの角度が前向きに折り返されます。sin だけでは向きは決まりません。cos も必要です。",
            ),
        ),
        Mistake(
            sign_lost,
            Text(
                "The size is right, but the sign is lost (by abs or arccos): directions to the right come out to the left.",
                "大きさは合っていますが、(abs や arccos で)符号が失われ、右向きが左向きになっています。",
            ),
        ),
        Mistake(
            sign_turned_round,
            Text(
                "Every sign is turned round: left and right are exchanged. Is something subtracted the wrong way round?",
                "符号がすべて逆で、左右が入れ替わっています。引き算の順序が逆になっていませんか。",
            ),
        ),
        Mistake(
            returned_in_degrees,
            Text(
                "The angles are wrapped rightly, but come back in degrees.",
                "折り返しは合っていますが、結果が度になっています。rad で返しましょう。",
            ),
        ),
        Mistake(
            taken_for_degrees,
            Text(
                "The angles are converted as if they were in degrees. They are in rad already.",
                "角度を度とみなして rad に変換しています。角度はすでに rad です。",
            ),
        ),
        Mistake(
            pi_shortened,
            Text(
                "The results are a little off, more so after several turns: pi was written as 3.14. Use np.pi.",
                "値が少しずれていて、回転数が多いほどずれが大きくなります。π を 3.14 と書いていませんか。np.pi を使いましょう。",
            ),
        ),
        Mistake(
            turns_of_the_first_angle,
            Text(
                "In an array all angles are shifted by the same number of turns, that of the first one. Each angle has its own number of turns.",
                "配列のとき、すべての角度が最初の要素と同じ回転数だけずらされています。回転数は要素ごとに違います。",
            ),
        ),
        Mistake(
            only_the_first_angle,
            Text(
                "Of an array only the first angle comes back. Wrap each of them and keep the shape.",
                "配列の最初の角度だけが返っています。すべての要素を折り返し、形状はそのまま保ちましょう。",
            ),
        ),
        Mistake(
            flattened,
            Text(
                "The angles are right, but arrays come back in one row. Keep the shape: NumPy's arithmetic works on arrays of any shape, without a loop.",
                "値は合っていますが、配列が 1 列に並んで返っています。形状を保ちましょう。NumPy の演算は、ループなしでどんな形の配列にも使えます。",
            ),
        ),
        Mistake(
            numbers_become_arrays,
            Text(
                "The angles are right, but a single number comes back as an array of one. A number must come back as a number.",
                "値は合っていますが、数値 1 個を渡すと要素 1 つの配列が返っています。数値には数値を返しましょう。",
            ),
        ),
        Mistake(
            single_entries_become_numbers,
            Text(
                "The angles are right, but axes of length 1 are lost (squeeze): the shape must stay as it was.",
                "値は合っていますが、長さ 1 の軸が(squeeze で)消えています。形状は渡されたときのまま保ちましょう。",
            ),
        ),
        Mistake(
            unwrapped_instead,
            Text(
                "np.unwrap does the opposite: it takes the jumps out of a sequence. Here each angle is wrapped by itself.",
                "np.unwrap は逆に、角度の列から飛びを取り除く関数です。ここでは 1 つ 1 つの角度を折り返します。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With angles of whole numbers the decimals are cut off: an integer array holds integers only. "
                "Make it np.array(theta, dtype=float).",
                "角度が整数で渡されると、小数部分が切り捨てられます。整数の配列には整数しか入りません。"
                "np.array(theta, dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The angles are rounded. Round only for display.",
                "角度が丸められています。丸めるのは表示のときだけにしましょう。",
            ),
        ),
    ),
)
