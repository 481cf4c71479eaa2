"""from_compass(x, y, theta): a compass heading, clockwise from +y as the equations of slides 003 must be read, as a heading from +x."""

import cmath

import numpy as np

from autograder.draws import magnitudes
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import Tolerance


def reference(x, y, theta):
    """Return the position as it is, and the direction of the arrow (sin, cos), which is the slides' way of moving."""
    arrow = 1j * cmath.rect(1.0, theta).conjugate()
    return x, y, cmath.phase(arrow)


def cases(rng):
    """Draw headings in all four quadrants, of both signs, away from the axes and diagonals; the easy ones apart."""

    def at(theta):
        return magnitudes(rng, 0.5, 3.0), magnitudes(rng, 0.5, 3.0), float(theta)

    def eighth(number):
        return (number + rng.uniform(0.26, 0.74)) * np.pi / 4

    quadrants = np.array([0, 2, 4, 6]) + rng.integers(0, 2, 4)
    far = [eighth(quadrants[1]) + 2 * np.pi, eighth(quadrants[2]) - 4 * np.pi]
    whole = [
        (int(rng.integers(1, 6)), -int(rng.integers(1, 6)), int(theta)) for theta in (rng.choice([1, 2]), rng.choice([-4, -1, 4]))
    ]
    axes = [0.0, np.pi / 2, np.pi, -np.pi / 2]
    return [
        Group(Text("positive headings", "正の方位"), 3, [at(eighth(number)) for number in quadrants]),
        Group(Text("negative headings", "負の方位"), 3, [at(eighth(number) - 2 * np.pi) for number in quadrants]),
        Group(Text("headings beyond one turn", "1 回転を超える方位"), 1, [at(theta) for theta in far]),
        Group(Text("headings along an axis", "軸の向きの方位"), 1, [at(theta) for theta in axes]),
        Group(Text("whole numbers", "整数の入力"), 1, whole),
    ]


def heading_unchanged(x, y, theta):
    return x, y, theta


def only_the_side_changed(x, y, theta):
    return x, y, -theta


def quarter_turn_added(x, y, theta):
    return x, y, theta + np.pi / 2


def quarter_turn_subtracted(x, y, theta):
    return x, y, theta - np.pi / 2


def opposite_direction(x, y, theta):
    return x, y, -np.pi / 2 - theta


def half_turn_instead_of_quarter(x, y, theta):
    return x, y, np.pi - theta


def half_turn_added(x, y, theta):
    return x, y, theta + np.pi


def eighth_turn_instead_of_quarter(x, y, theta):
    return x, y, np.pi / 4 - theta


def multiplied_by_a_quarter_turn(x, y, theta):
    return x, y, np.pi / 2 * theta


def degrees_subtracted(x, y, theta):
    return x, y, 90 - theta


def all_in_degrees(x, y, theta):
    return x, y, 90 - np.rad2deg(theta)


def degrees_of_the_compass_card(x, y, theta):
    return x, y, (90 - np.rad2deg(theta)) % 360


def taken_for_degrees(x, y, theta):
    return x, y, np.pi / 2 - np.deg2rad(theta)


def pi_divided_without_remainder(x, y, theta):
    return x, y, np.pi // 2 - theta


def pi_shortened(x, y, theta):
    return x, y, 3.14 / 2 - theta


def modulo_half_a_turn(x, y, theta):
    return x, y, (np.pi / 2 - theta) % np.pi


def sign_lost(x, y, theta):
    return x, y, abs(np.pi / 2 - theta)


def taken_positive_first(x, y, theta):
    return x, y, np.pi / 2 - abs(theta)


def by_arccos(x, y, theta):
    return x, y, np.arccos(np.sin(theta))


def by_arcsin(x, y, theta):
    return x, y, np.arcsin(np.cos(theta))


def clipped(x, y, theta):
    return x, y, np.clip(np.pi / 2 - theta, -np.pi, np.pi)


def axes_exchanged(x, y, theta):
    return y, x, theta


def axes_exchanged_too(x, y, theta):
    return y, x, np.pi / 2 - theta


def y_turned_round(x, y, theta):
    return x, -y, -theta


def y_turned_round_too(x, y, theta):
    return x, -y, np.pi / 2 - theta


def position_turned_left_too(x, y, theta):
    return -y, x, np.pi / 2 - theta


def position_turned_right_too(x, y, theta):
    return y, -x, np.pi / 2 - theta


def heading_of_the_position(x, y, theta):
    return x, y, np.arctan2(y, x)


def bearing_of_the_position(x, y, theta):
    return x, y, np.arctan2(x, y)


def position_lost(x, y, theta):
    return 0.0, 0.0, np.pi / 2 - theta


def heading_alone(x, y, theta):
    return np.pi / 2 - theta


def position_alone(x, y, theta):
    return x, y


def heading_first(x, y, theta):
    return np.pi / 2 - theta, x, y


def direction_returned(x, y, theta):
    return x, y, np.cos(theta), np.sin(theta)


def rounded(x, y, theta):
    return x, y, round(np.pi / 2 - theta, 3)


def position_cut_off(x, y, theta):
    return int(x), int(y), np.pi / 2 - theta


EXERCISE = Exercise(
    name="from_compass",
    notebook="odometry/frames",
    points=5,
    parameters=("x", "y", "theta"),
    quantities=("x", "y", "heading"),
    reference=reference,
    cases=cases,
    tolerance=Tolerance(axis=-1, angles=(2,)),
    examples=((1.0, 2.0, 0.0), (3.0, -1.0, np.pi / 6), (-2.0, 0.5, -2.0)),
    mistakes=(
        Mistake(
            heading_unchanged,
            Text(
                "The heading comes back as it was. A compass counts from +y, the course from +x: a robot that looks along +x has heading 0 "
                "here, but not on the compass.",
                "方位がそのまま返っています。コンパスの方位は +y から、この講義の方位は +x から測ります。"
                "+x を向いたロボットの方位はここでは 0 ですが、コンパスでは 0 ではありません。",
            ),
        ),
        Mistake(
            only_the_side_changed,
            Text(
                "The sense of rotation is changed, but both headings are counted from the same axis. A compass heading of 0 looks along +y: "
                "which heading is that here?",
                "回る向きは変えていますが、どちらも同じ軸から測っています。コンパスの方位 0 は +y の向きです。この講義の方位ではいくつでしょうか。",
            ),
        ),
        Mistake(
            quarter_turn_added,
            Text(
                "The starting axis is moved, but the sense of rotation is not changed: the compass counts clockwise. Try a compass heading a little "
                "above 0: does the robot look to the right or to the left of +y?",
                "測り始める軸は直していますが、回る向きが元のままです。コンパスは時計回りに測ります。"
                "コンパスの方位が 0 より少し大きいとき、ロボットは +y より右と左のどちらを向きますか。",
            ),
        ),
        Mistake(
            quarter_turn_subtracted,
            Text(
                "The sense of rotation is not changed (or the difference is taken the wrong way round): the compass counts clockwise, so where one "
                "heading grows the other must fall.",
                "回る向きが元のままです(または引き算の順序が逆です)。コンパスは時計回りに測るので、一方の方位が増えるともう一方は減るはずです。",
            ),
        ),
        Mistake(
            opposite_direction,
            Text(
                "The robot looks the opposite way: half a turn is added. A compass heading of 0 looks along +y, not along -y.",
                "半回転ずれて、反対の向きになっています。コンパスの方位 0 は -y ではなく +y の向きです。",
            ),
        ),
        Mistake(
            half_turn_instead_of_quarter,
            Text(
                "The sense of rotation is right, but the offset is half a turn. How far apart are +x and +y?",
                "回る向きは合っていますが、ずらす角度が半回転(π)になっています。+x と +y はどれだけ離れていますか。",
            ),
        ),
        Mistake(
            half_turn_added,
            Text(
                "Half a turn is added: the robot only looks backwards. The two headings differ in their starting axis and in their sense of rotation.",
                "半回転(π)を足していて、後ろを向くだけになっています。2 つの方位は、測り始める軸と回る向きの両方が違います。",
            ),
        ),
        Mistake(
            eighth_turn_instead_of_quarter,
            Text(
                "The sense of rotation is right, but the offset is pi/4. How far apart are +x and +y?",
                "回る向きは合っていますが、ずらす角度が π/4 になっています。+x と +y はどれだけ離れていますか。",
            ),
        ),
        Mistake(
            multiplied_by_a_quarter_turn,
            Text(
                "The heading is multiplied by pi/2. The starting axis lies a quarter turn away: is that a factor or an offset?",
                "方位に π/2 を掛けています。測り始める軸が 1/4 回転ずれているのは、倍率でしょうか、それとも足し引きでしょうか。",
            ),
        ),
        Mistake(
            degrees_subtracted,
            Text(
                "90 is an angle in degrees, theta is in rad. Write the quarter turn in rad.",
                "90 は度の値で、theta は rad です。1/4 回転を rad で書きましょう。",
            ),
        ),
        Mistake(
            all_in_degrees,
            Text(
                "The heading comes back in degrees. The course computes in rad throughout.",
                "方位が度で返っています。この講義では角度をすべて rad で扱います。",
            ),
        ),
        Mistake(
            degrees_of_the_compass_card,
            Text(
                "The heading comes back in degrees from 0 to 360, as a compass card shows it. The course computes in rad "
                "throughout.",
                "方位が 0〜360 の度で返っています。この講義では角度をすべて rad で扱います。",
            ),
        ),
        Mistake(
            taken_for_degrees,
            Text(
                "theta is converted as if it were in degrees (or the difference from 90 is). It is in rad already.",
                "theta(または 90 との差)を度とみなして変換しています。theta はすでに rad です。",
            ),
        ),
        Mistake(
            pi_divided_without_remainder,
            Text(
                "// drops the fraction: np.pi // 2 is 1. Use / for a quarter turn.",
                "// は小数部分を切り捨てるので、np.pi // 2 は 1 になります。1/4 回転には / を使いましょう。",
            ),
        ),
        Mistake(
            pi_shortened,
            Text(
                "The quarter turn is a little off: pi was written as 3.14. Use np.pi.",
                "1/4 回転が少しずれています。π を 3.14 と書いていませんか。np.pi を使いましょう。",
            ),
        ),
        Mistake(
            modulo_half_a_turn,
            Text(
                "The heading is taken modulo pi, half a turn: the robot then often looks the opposite way. A full turn is 2 pi, and no modulo "
                "is needed here.",
                "方位を半回転(π)で割った余りにしているため、反対を向くことがあります。1 回転は 2π です。ここでは剰余をとる必要もありません。",
            ),
        ),
        Mistake(
            sign_lost,
            Text(
                "The result is made positive (abs). A negative heading is right as it is: it looks to the right of +x.",
                "結果が(abs で)正に直されています。負の方位はそのままで正しく、+x より右を向いていることを表します。",
            ),
        ),
        Mistake(
            taken_positive_first,
            Text(
                "The sign of theta is lost before the conversion: headings to the two sides of the starting axis come out the same.",
                "変換の前に theta の符号が失われています。測り始める軸の右側と左側の方位が、同じ値になってしまいます。",
            ),
        ),
        Mistake(
            by_arccos,
            Text(
                "The heading comes from arccos, which is never negative, so the side of the x axis is lost. No inverse function is needed, or use "
                "arctan2.",
                "方位を arccos で求めています。arccos は負にならないので、x 軸のどちら側かが失われます。逆三角関数は不要です。使うなら arctan2 にしましょう。",
            ),
        ),
        Mistake(
            by_arcsin,
            Text(
                "The heading comes from arcsin, which stays within a quarter turn of 0: headings that look backwards are folded to the front. "
                "No inverse function is needed, or use arctan2.",
                "方位を arcsin で求めています。arcsin は ±π/2 の範囲しか返さないので、後ろ向きの方位が前向きに折り返されます。"
                "逆三角関数は不要です。使うなら arctan2 にしましょう。",
            ),
        ),
        Mistake(
            clipped,
            Text(
                "Headings beyond half a turn are cut off at pi (clip). A heading that goes on counting is right as it is.",
                "半回転を超える方位が(clip で)±π に切られています。±π を超えた方位も、そのままで正しい向きを表します。",
            ),
        ),
        Mistake(
            axes_exchanged,
            Text(
                "x and y are exchanged and the heading is kept. Here the axes stay the same in both descriptions; only the heading is counted in "
                "another way.",
                "x と y を入れ替えて、方位はそのままにしています。ここでは座標軸はどちらの表し方でも同じで、方位の測り方だけが違います。",
            ),
        ),
        Mistake(
            axes_exchanged_too,
            Text(
                "The heading is right, but x and y are exchanged as well. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、x と y まで入れ替わっています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            y_turned_round,
            Text(
                "y and the heading have their signs changed. That mirrors the world; here the axes stay the same, and the heading is counted from "
                "another one of them.",
                "y と方位の符号を変えています。それは鏡映しです。ここでは座標軸は同じで、方位を測り始める軸と回る向きが違います。",
            ),
        ),
        Mistake(
            y_turned_round_too,
            Text(
                "The heading is right, but the sign of y is changed as well. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、y の符号まで変わっています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            position_turned_left_too,
            Text(
                "The heading is right, but the position is turned by a quarter turn to the left. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、位置まで左へ 1/4 回転しています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            position_turned_right_too,
            Text(
                "The heading is right, but the position is turned by a quarter turn to the right. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、位置まで右へ 1/4 回転しています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            heading_of_the_position,
            Text(
                "The heading is computed from x and y. Where the robot stands says nothing about where it looks: use theta.",
                "方位を x と y から計算しています。どこにいるかと、どちらを向いているかは別のことです。theta を使いましょう。",
            ),
        ),
        Mistake(
            bearing_of_the_position,
            Text(
                "The heading is computed from x and y, by atan2(x, y). Where the robot stands says nothing about where it looks: use theta.",
                "方位を x と y から atan2(x, y) で計算しています。どこにいるかと、どちらを向いているかは別のことです。theta を使いましょう。",
            ),
        ),
        Mistake(
            position_lost,
            Text(
                "The heading is right, but x and y come back as 0. They are the same in both descriptions.",
                "方位は合っていますが、x と y が 0 になっています。位置はどちらの表し方でも同じです。",
            ),
        ),
        Mistake(
            heading_alone,
            Text(
                "The heading is right, but it comes back alone. Return x, y and the heading.",
                "方位は合っていますが、方位だけが返っています。x, y と方位の 3 つを返しましょう。",
            ),
        ),
        Mistake(
            position_alone,
            Text(
                "Only x and y come back. Return x, y and the heading.",
                "x と y だけが返っています。x, y と方位の 3 つを返しましょう。",
            ),
        ),
        Mistake(
            heading_first,
            Text(
                "The numbers are right, but the heading comes first. The order is (x, y, heading).",
                "値は合っていますが、方位が最初に来ています。順序は (x, y, 方位) です。",
            ),
        ),
        Mistake(
            direction_returned,
            Text(
                "Four numbers come back, with the cos and sin of the heading you were given. One heading in rad is asked for.",
                "4 つの数が返っていて、受け取った方位の cos と sin が入っています。求めるのは 1 つの方位 [rad] です。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The heading is rounded. Converted back it is no longer the same: round only for display.",
                "方位が丸められています。逆に変換しても元に戻りません。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            position_cut_off,
            Text(
                "The heading is right, but x and y are cut to whole numbers. Leave out int.",
                "方位は合っていますが、x と y の小数部分が切り捨てられています。int への変換は不要です。",
            ),
        ),
    ),
)
