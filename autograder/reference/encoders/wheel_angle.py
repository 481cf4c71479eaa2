"""wheel_angle(counts, gear, counts_per_rev): counts of the encoder (motor) shaft to the angle of the wheel, slides 000, overview 6."""

import numpy as np

from autograder.draws import until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(counts, gear, counts_per_rev):
    """Return the wheel's turns, counts over counts per turn of the wheel, in rad."""
    if np.ndim(counts) > 0:
        return [reference(count, gear, counts_per_rev) for count in counts]
    counts_per_wheel_turn = float(gear) * float(counts_per_rev)
    return float(counts) / counts_per_wheel_turn * 2 * np.pi


def cases(rng):
    """Draw counts of less than half a turn of the wheel, and some of more; the gear is a whole number except in one group."""

    def encoder():
        return int(rng.integers(20, 140)), int(rng.choice([128, 500, 512, 1000, 1024, 2000]))

    def counts(gear, counts_per_rev, size, low=0.02, high=0.45):
        return np.floor(rng.uniform(low, high, size) * gear * counts_per_rev)

    def number(low=0.02, high=0.45):
        def draw():
            gear, counts_per_rev = encoder()
            return int(counts(gear, counts_per_rev, None, low, high)), gear, counts_per_rev

        return until(draw, no_whole_turns)

    def array(size):
        gear, counts_per_rev = encoder()
        return counts(gear, counts_per_rev, size), gear, counts_per_rev

    def geared(fraction, size=None):
        gear, counts_per_rev = encoder()
        gear = gear + fraction
        drawn = counts(gear, counts_per_rev, size)
        return (int(drawn) if size is None else drawn), float(gear), counts_per_rev

    back = number()
    both = array(int(rng.integers(5, 9)))
    both[0][::2] *= -1
    whole, single, listed = array(int(rng.integers(4, 8))), array(1), array(int(rng.integers(4, 8)))
    turns = number(1.55, 1.9), number(2.1, 2.4)
    return [
        Group(Text("numbers", "数値"), 2, [number(), number(), (float(back[0]), float(back[1]), back[2])]),
        Group(Text("arrays", "配列"), 3, [array(int(rng.integers(4, 7))), array(int(rng.integers(7, 11)))]),
        Group(Text("turning backwards", "逆転"), 2, [(-back[0], *back[1:]), both]),
        Group(
            Text("whole numbers in arrays and lists, a single entry", "整数の配列・リスト、要素 1 つの配列"),
            1,
            [(whole[0].astype(int), *whole[1:]), (listed[0].astype(int).tolist(), *listed[1:]), single],
        ),
        Group(
            Text("a gear ratio that is no whole number", "整数でないギア比"),
            1,
            [geared(rng.uniform(0.2, 0.45)), geared(rng.uniform(0.55, 0.8), int(rng.integers(4, 7)))],
        ),
        Group(Text("more than one turn of the wheel", "タイヤが 1 回転以上"), 1, [turns[0], (-turns[1][0], *turns[1][1:])]),
    ]


def no_whole_turns(counts, gear, counts_per_rev):
    """Tell whether an integer division would lose something, whatever the counts are divided by."""
    return all(0.05 < counts / part % 1 < 0.95 for part in (gear, counts_per_rev, gear * counts_per_rev))


def gear_forgotten(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / counts_per_rev


def gear_multiplied(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) * gear / counts_per_rev


def gear_divided_twice(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / gear / (gear * counts_per_rev)


def gear_added(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (gear + counts_per_rev)


def two_pi_forgotten(counts, gear, counts_per_rev):
    return np.asarray(counts) / (gear * counts_per_rev)


def pi_for_two_pi(counts, gear, counts_per_rev):
    return np.pi * np.asarray(counts) / (gear * counts_per_rev)


def two_pi_divided(counts, gear, counts_per_rev):
    return np.asarray(counts) / (gear * counts_per_rev * 2 * np.pi)


def pi_shortened(counts, gear, counts_per_rev):
    return 2 * 3.14 * np.asarray(counts) / (gear * counts_per_rev)


def angle_in_degrees(counts, gear, counts_per_rev):
    return 360 * np.asarray(counts) / (gear * counts_per_rev)


def converted_from_degrees(counts, gear, counts_per_rev):
    return np.deg2rad(2 * np.pi * np.asarray(counts) / (gear * counts_per_rev))


def counts_per_rev_forgotten(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / gear


def counts_per_rev_multiplied(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / gear * counts_per_rev


def pulses_times_four(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (gear * 4 * counts_per_rev)


def counts_taken_for_pulses(counts, gear, counts_per_rev):
    return 2 * np.pi * 4 * np.asarray(counts) / (gear * counts_per_rev)


def ratio_inverted(counts, gear, counts_per_rev):
    return 2 * np.pi * gear * counts_per_rev / np.asarray(counts)


def integer_division_by_gear(counts, gear, counts_per_rev):
    return 2 * np.pi * (np.asarray(counts) // gear) / counts_per_rev


def whole_counts_on_the_axle(counts, gear, counts_per_rev):
    return 2 * np.pi * np.trunc(np.asarray(counts) / gear) / counts_per_rev


def integer_division_by_counts_per_rev(counts, gear, counts_per_rev):
    return 2 * np.pi * (np.asarray(counts) // counts_per_rev) / gear


def integer_division_by_both(counts, gear, counts_per_rev):
    return 2 * np.pi * (np.asarray(counts) // (gear * counts_per_rev))


def gear_rounded_down(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (int(gear) * counts_per_rev)


def gear_rounded(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (round(gear) * counts_per_rev)


def gear_of_the_slides(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (150 * counts_per_rev)


def numbers_of_the_slides(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (150 * 400)


def counts_per_rev_of_the_slides(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (gear * 400)


def direction_lost(counts, gear, counts_per_rev):
    return 2 * np.pi * np.abs(counts) / (gear * counts_per_rev)


def direction_reversed(counts, gear, counts_per_rev):
    return -2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)


def wrapped_to_one_turn(counts, gear, counts_per_rev):
    return (2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)) % (2 * np.pi)


def wrapped_to_half_a_turn(counts, gear, counts_per_rev):
    return (2 * np.pi * np.asarray(counts) / (gear * counts_per_rev) + np.pi) % (2 * np.pi) - np.pi


def whole_turns_dropped(counts, gear, counts_per_rev):
    return np.fmod(2 * np.pi * np.asarray(counts) / (gear * counts_per_rev), 2 * np.pi)


def whole_turns_of_motor_dropped(counts, gear, counts_per_rev):
    return 2 * np.pi * (np.asarray(counts) % counts_per_rev) / (gear * counts_per_rev)


def increments_added_up(counts, gear, counts_per_rev):
    angle = 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)
    return np.cumsum(angle) if np.ndim(angle) else angle


def increments_differenced(counts, gear, counts_per_rev):
    angle = 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)
    return np.diff(angle) if np.ndim(angle) else angle


def increments_differenced_from_zero(counts, gear, counts_per_rev):
    angle = 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)
    return np.diff(angle, prepend=0) if np.ndim(angle) else angle


def only_the_total(counts, gear, counts_per_rev):
    return 2 * np.pi * np.sum(counts) / (gear * counts_per_rev)


def only_the_first(counts, gear, counts_per_rev):
    return 2 * np.pi * np.ravel(counts)[0] / (gear * counts_per_rev)


def only_the_last(counts, gear, counts_per_rev):
    return 2 * np.pi * np.ravel(counts)[-1] / (gear * counts_per_rev)


def number_becomes_array(counts, gear, counts_per_rev):
    return 2 * np.pi * np.atleast_1d(counts) / (gear * counts_per_rev)


def single_entry_becomes_number(counts, gear, counts_per_rev):
    return np.squeeze(2 * np.pi * np.asarray(counts) / (gear * counts_per_rev))


def decimals_cut_off(counts, gear, counts_per_rev):
    angle = np.zeros_like(counts)
    angle[...] = 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)
    return angle


def made_whole(counts, gear, counts_per_rev):
    return (2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)).astype(int)


def rounded(counts, gear, counts_per_rev):
    return np.round(2 * np.pi * np.asarray(counts) / (gear * counts_per_rev), 3)


def rounded_coarsely(counts, gear, counts_per_rev):
    return np.round(2 * np.pi * np.asarray(counts) / (gear * counts_per_rev), 2)


def divided_by_the_sampling_period(counts, gear, counts_per_rev):
    return 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev) / 0.005


def radius_of_the_slides(counts, gear, counts_per_rev):
    return 0.14457758 * 2 * np.pi * np.asarray(counts) / (gear * counts_per_rev)


def counts_returned(counts, gear, counts_per_rev):
    return np.asarray(counts) / gear


EXERCISE = Exercise(
    name="wheel_angle",
    notebook="odometry/encoders",
    points=5,
    parameters=("counts", "gear", "counts_per_rev"),
    gear=1,
    reference=reference,
    cases=cases,
    examples=(
        (60000, 150, 400),
        (np.array([133.0, -57.0, 0.0, 4000.0]), 54.0699, 2048),
    ),
    mistakes=(
        Mistake(
            gear_forgotten,
            Text(
                "The gear ratio is missing: this is the angle of the motor shaft. The encoder sits on the motor, which turns "
                "gear times "
                "while the wheel turns once.",
                "ギア比が抜けていて、モータ軸の角度になっています。エンコーダはモータ側に付いています。"
                "タイヤが 1 回転する間に、モータは gear 回転します。",
            ),
        ),
        Mistake(
            gear_multiplied,
            Text(
                "The gear ratio is multiplied, so the wheel turns faster than the motor. gear is the number of motor turns for "
                "one turn of "
                "the wheel: is the wheel's angle larger or smaller than the motor's?",
                "ギア比を掛けているため、タイヤがモータより速く回ることになっています。"
                "gear はタイヤ 1 回転あたりのモータの回転数です。"
                "タイヤの角度はモータの角度より大きいでしょうか、小さいでしょうか。",
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
            two_pi_forgotten,
            Text("These are turns of the wheel. One turn is 2π rad.", "これはタイヤの回転数です。1 回転は 2π rad です。"),
        ),
        Mistake(
            pi_for_two_pi,
            Text(
                "The angle is half of what it should be: as if one turn were π. One full turn is 2π rad.",
                "角度が半分になっています。1 回転を π として計算した値です。1 回転は 2π rad です。",
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
            pi_shortened,
            Text(
                "π is shortened to 3.14; the error adds up over a drive. Use np.pi.",
                "π を 3.14 としています。走行するうちに誤差が積み重なります。np.pi を使いましょう。",
            ),
        ),
        Mistake(
            angle_in_degrees,
            Text(
                "The angle is in degrees: one turn is 360. Asked for is rad, as everywhere in the course.",
                "角度が度になっています(1 回転 360)。この講義ではすべて rad です。",
            ),
        ),
        Mistake(
            converted_from_degrees,
            Text(
                "The angle is converted from degrees to rad although it is in rad already: 2π per turn makes rad.",
                "すでに rad の角度を、度から rad へもう一度変換しています。1 回転を 2π とした時点で rad です。",
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
            pulses_times_four,
            Text(
                "The result is a quarter of what it should be: either counts_per_rev is taken for pulses (it is in counts, 4x "
                "decoding included), "
                "or a 2 that belongs above the fraction line stands below it.",
                "結果が 1/4 になっています。counts_per_rev をパルス数とみなしているか(実際は 4 逓倍した後のカウント数です)、"
                "分子にあるべき 2 が分母に入っています。",
            ),
        ),
        Mistake(
            counts_taken_for_pulses,
            Text(
                "The result is four times what it should be: pulses and counts are mixed up. counts and counts_per_rev are both "
                "counts, "
                "4x decoding included.",
                "結果が 4 倍になっています。パルスとカウントを混同しています。"
                "counts も counts_per_rev も 4 逓倍した後のカウントです。",
            ),
        ),
        Mistake(
            ratio_inverted,
            Text(
                "The ratio is upside down: more counts give a smaller angle. Divide the counts by the counts of one turn of the "
                "wheel.",
                "比が逆で、カウントが多いほど角度が小さくなっています。カウントを、タイヤ 1 回転分のカウントで割りましょう。",
            ),
        ),
        Mistake(
            integer_division_by_gear,
            Text(
                "// drops the fraction: fewer counts than gear become 0. Divide with /.",
                "// は小数部分を切り捨てるので、gear より少ないカウントは 0 になります。/ で割りましょう。",
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
            integer_division_by_counts_per_rev,
            Text(
                "Only whole turns of the motor shaft count, the rest is dropped by //. Divide with /.",
                "// のため、モータ軸の 1 回転に満たない分が捨てられています。/ で割りましょう。",
            ),
        ),
        Mistake(
            integer_division_by_both,
            Text(
                "Only whole turns of the wheel count: // drops the fraction, and less than one turn becomes 0. Divide with /.",
                "// のため、タイヤの 1 回転に満たない分が捨てられています。/ で割りましょう。",
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
            gear_of_the_slides,
            Text(
                "The gear ratio is always 150, that of the i-Cart in the slides. Use the argument gear: robots differ.",
                "ギア比がいつも 150(スライドの i-Cart の値)になっています。ロボットによって違うので、引数 gear を使いましょう。",
            ),
        ),
        Mistake(
            numbers_of_the_slides,
            Text(
                "The numbers of the i-Cart, 150 and 400, are used whatever the arguments say. Use gear and counts_per_rev.",
                "引数に関係なく i-Cart の値 150 と 400 を使っています。引数 gear と counts_per_rev を使いましょう。",
            ),
        ),
        Mistake(
            counts_per_rev_of_the_slides,
            Text(
                "counts_per_rev is always 400, that of the i-Cart in the slides. Use the argument: encoders differ.",
                "counts_per_rev がいつも 400(スライドの i-Cart の値)になっています。エンコーダによって違うので、引数を使いましょう。",
            ),
        ),
        Mistake(
            direction_lost,
            Text(
                "A wheel that turns backwards gets a positive angle: the sign is lost. Leave out abs().",
                "逆転しているタイヤの角度が正になっています。符号が失われています。abs() は使いません。",
            ),
        ),
        Mistake(
            direction_reversed,
            Text(
                "The angle has the wrong sign. Here positive counts give a positive angle; which way a wheel is mounted is "
                "dealt with later.",
                "角度の符号が逆です。ここでは正のカウントは正の角度になります。モータの取り付けの向きは、あとの課題で扱います。",
            ),
        ),
        Mistake(
            wrapped_to_one_turn,
            Text(
                "The angle is wrapped to 0..2π. It is how far the wheel has turned: beyond one turn it goes on, backwards it is "
                "negative. No modulo.",
                "角度が 0〜2π に折り返されています。これはタイヤが回った量なので、1 回転を超えても続き、逆転なら負です。"
                "剰余はとりません。",
            ),
        ),
        Mistake(
            wrapped_to_half_a_turn,
            Text(
                "The angle is wrapped to -π..π. It is how far the wheel has turned, and beyond half a turn it goes on. No modulo.",
                "角度が -π〜π に折り返されています。これはタイヤが回った量なので、半回転を超えてもそのまま続きます。"
                "剰余はとりません。",
            ),
        ),
        Mistake(
            whole_turns_dropped,
            Text(
                "Whole turns of the wheel are dropped. The angle is how far it has turned, however often. No modulo.",
                "タイヤの整数回転分が捨てられています。角度はタイヤが回った量で、何回転しても足し続けます。剰余はとりません。",
            ),
        ),
        Mistake(
            whole_turns_of_motor_dropped,
            Text(
                "Whole turns of the motor shaft are dropped: counts goes through a modulo. Every count turns the wheel a little "
                "further.",
                "counts の剰余をとっているため、モータ軸の整数回転分が捨てられています。1 カウントごとにタイヤは少しずつ回ります。",
            ),
        ),
        Mistake(
            increments_added_up,
            Text(
                "The angles are added up. Asked for is the angle of each increment by itself; leave out cumsum.",
                "角度を累積しています。求めるのは増分それぞれの角度です。cumsum は不要です。",
            ),
        ),
        Mistake(
            increments_differenced,
            Text(
                "Neighbouring counts are subtracted. These counts are increments already: leave out np.diff.",
                "隣どうしのカウントの差をとっています。このカウントはすでに増分なので、np.diff は不要です。",
            ),
        ),
        Mistake(
            increments_differenced_from_zero,
            Text(
                "From each count the one before is subtracted. These counts are increments already: take them as they are.",
                "各カウントから 1 つ前のカウントを引いています。このカウントはすでに増分なので、そのまま使います。",
            ),
        ),
        Mistake(
            only_the_total,
            Text(
                "From an array comes a single number, the sum. Each increment has an angle of its own: as many out as in.",
                "配列を渡しても合計の数値 1 つが返っています。増分ごとに角度があるので、入力と同じ個数を返しましょう。",
            ),
        ),
        Mistake(
            only_the_first,
            Text(
                "From an array only the angle of the first entry comes back. Is there a return inside a loop?",
                "配列を渡しても最初の要素の角度だけが返っています。return がループの中に入っていませんか。",
            ),
        ),
        Mistake(
            only_the_last,
            Text(
                "From an array only the angle of the last entry comes back. Is the result overwritten in a loop?",
                "配列を渡しても最後の要素の角度だけが返っています。ループの中で結果を上書きしていませんか。",
            ),
        ),
        Mistake(
            number_becomes_array,
            Text(
                "For a single number an array comes back. A number in, a number out: np.asarray leaves a number without a shape, "
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
            made_whole,
            Text(
                "The angles are cut to whole numbers. Leave out int.",
                "角度の小数部分が切り捨てられています。int への変換は不要です。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The angle is rounded to 3 decimals. Thousands of increments are added up later, and so are their rounding "
                "errors: round only for display.",
                "角度が小数第 3 位までに丸められています。あとで何千個も足すと丸め誤差も積み重なります。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            rounded_coarsely,
            Text(
                "The angle is rounded to 2 decimals. Thousands of increments are added up later, and so are their rounding "
                "errors: round only for display.",
                "角度が小数第 2 位までに丸められています。あとで何千個も足すと丸め誤差も積み重なります。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            divided_by_the_sampling_period,
            Text(
                "The result is divided by 0.005 s: that is a rate. Asked for is the angle alone.",
                "0.005 s で割っていて、角速度になっています。求めるのは角度です。",
            ),
        ),
        Mistake(
            radius_of_the_slides,
            Text(
                "The angle is multiplied by the i-Cart's wheel radius: that is a distance. Asked for is the angle in rad.",
                "角度に i-Cart の車輪半径を掛けていて、距離になっています。求めるのは角度 [rad] です。",
            ),
        ),
        Mistake(
            counts_returned,
            Text(
                "These are counts referred to the wheel axle, dC in the slides. The next line of overview 6 turns them into an "
                "angle.",
                "これは車輪軸上のカウント(スライドの dC)です。概要 #6 の次の行で角度に変換します。",
            ),
        ),
    ),
)
