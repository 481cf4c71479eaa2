"""to_compass(x, y, theta): a heading from +x as a compass heading, clockwise from +y, as the equations of slides 003 must be read.

The map is its own inverse, so cases and mistakes are those of from_compass; what a student is told is not.
"""

import math

from autograder.exercise import Exercise, Mistake
from autograder.reference.frames import from_compass as back
from course.language import Text
from course.tolerances import Tolerance


def reference(x, y, theta):
    """Return the position as it is, and how far the looking direction lies to the right of +y, between -pi and pi."""
    return x, y, math.atan2(math.cos(theta), math.sin(theta))


EXERCISE = Exercise(
    name="to_compass",
    notebook="odometry/frames",
    points=5,
    parameters=("x", "y", "theta"),
    quantities=("x", "y", "heading"),
    reference=reference,
    cases=back.cases,
    tolerance=Tolerance(axis=-1, angles=(2,)),
    examples=((1.0, 2.0, 0.0), (3.0, -1.0, 2.0), (-2.0, 0.5, -math.pi / 6)),
    mistakes=(
        Mistake(
            back.heading_unchanged,
            Text(
                "The heading comes back as it was. The course counts from +x, a compass from +y: what does the compass show of a robot that "
                "looks along +x?",
                "方位がそのまま返っています。この講義の方位は +x から、コンパスの方位は +y から測ります。"
                "+x を向いたロボットのコンパスの方位はいくつでしょうか。",
            ),
        ),
        Mistake(
            back.only_the_side_changed,
            Text(
                "The sense of rotation is changed, but both headings are counted from the same axis. A robot that looks along +y shows 0 on a compass.",
                "回る向きは変えていますが、どちらも同じ軸から測っています。+y を向いたロボットのコンパスの方位は 0 です。",
            ),
        ),
        Mistake(
            back.quarter_turn_added,
            Text(
                "The starting axis is moved, but the sense of rotation is not changed: a robot that turns to the left must show less and less on "
                "the compass.",
                "測り始める軸は動かしていますが、回る向きが元のままです。ロボットが左に回ると、コンパスの方位は減っていくはずです。",
            ),
        ),
        Mistake(
            back.quarter_turn_subtracted,
            Text(
                "The sense of rotation is not changed (or the difference is taken the wrong way round): a robot that turns to the left must show less "
                "and less on the compass.",
                "回る向きが元のままです(または引き算の順序が逆です)。ロボットが左に回ると、コンパスの方位は減っていくはずです。",
            ),
        ),
        Mistake(
            back.opposite_direction,
            Text(
                "The compass shows the opposite direction: half a turn is added. A robot that looks along +y shows 0, not pi.",
                "半回転ずれて、反対の向きになっています。+y を向いたロボットのコンパスの方位は、π ではなく 0 です。",
            ),
        ),
        Mistake(
            back.half_turn_instead_of_quarter,
            Text(
                "The sense of rotation is right, but the offset is half a turn. How far apart are +x and +y?",
                "回る向きは合っていますが、ずらす角度が半回転(π)になっています。+x と +y はどれだけ離れていますか。",
            ),
        ),
        Mistake(
            back.half_turn_added,
            Text(
                "Half a turn is added: the robot only looks backwards. The two headings differ in their starting axis and in their sense of rotation.",
                "半回転(π)を足していて、後ろを向くだけになっています。2 つの方位は、測り始める軸と回る向きの両方が違います。",
            ),
        ),
        Mistake(
            back.eighth_turn_instead_of_quarter,
            Text(
                "The sense of rotation is right, but the offset is pi/4. How far apart are +x and +y?",
                "回る向きは合っていますが、ずらす角度が π/4 になっています。+x と +y はどれだけ離れていますか。",
            ),
        ),
        Mistake(
            back.multiplied_by_a_quarter_turn,
            Text(
                "The heading is multiplied by pi/2. The starting axis lies a quarter turn away: is that a factor or an offset?",
                "方位に π/2 を掛けています。測り始める軸が 1/4 回転ずれているのは、倍率でしょうか、それとも足し引きでしょうか。",
            ),
        ),
        Mistake(
            back.degrees_subtracted,
            Text(
                "90 is an angle in degrees, theta is in rad. Write the quarter turn in rad.",
                "90 は度の値で、theta は rad です。1/4 回転を rad で書きましょう。",
            ),
        ),
        Mistake(
            back.all_in_degrees,
            Text(
                "The compass heading comes back in degrees, as on a real compass. The course computes in rad throughout.",
                "コンパスの方位が、本物のコンパスのように度で返っています。この講義では角度をすべて rad で扱います。",
            ),
        ),
        Mistake(
            back.degrees_of_the_compass_card,
            Text(
                "The compass heading comes back in degrees from 0 to 360, as a compass card shows it. The course computes in "
                "rad throughout.",
                "コンパスの方位が、方位盤のように 0〜360 の度で返っています。この講義では角度をすべて rad で扱います。",
            ),
        ),
        Mistake(
            back.taken_for_degrees,
            Text(
                "theta is converted as if it were in degrees (or the difference from 90 is). It is in rad already.",
                "theta(または 90 との差)を度とみなして変換しています。theta はすでに rad です。",
            ),
        ),
        Mistake(
            back.pi_divided_without_remainder,
            Text(
                "// drops the fraction: np.pi // 2 is 1. Use / for a quarter turn.",
                "// は小数部分を切り捨てるので、np.pi // 2 は 1 になります。1/4 回転には / を使いましょう。",
            ),
        ),
        Mistake(
            back.pi_shortened,
            Text(
                "The quarter turn is a little off: pi was written as 3.14. Use np.pi.",
                "1/4 回転が少しずれています。π を 3.14 と書いていませんか。np.pi を使いましょう。",
            ),
        ),
        Mistake(
            back.modulo_half_a_turn,
            Text(
                "The compass heading is taken modulo pi, half a turn: it then often shows the opposite direction. A full turn is 2 pi, and no modulo "
                "is needed here.",
                "コンパスの方位を半回転(π)で割った余りにしているため、反対の向きになることがあります。1 回転は 2π です。ここでは剰余をとる必要もありません。",
            ),
        ),
        Mistake(
            back.sign_lost,
            Text(
                "The result is made positive (abs). A negative compass heading is right as it is: it looks to the left of +y. Who wants none "
                "adds a full turn.",
                "結果が(abs で)正に直されています。負のコンパス方位はそのままで正しく、+y より左を向いていることを表します。"
                "負にしたくなければ 1 回転を足します。",
            ),
        ),
        Mistake(
            back.taken_positive_first,
            Text(
                "The sign of theta is lost before the conversion: headings to the left and to the right of +x come out the same.",
                "変換の前に theta の符号が失われています。+x の左側と右側の方位が同じ値になってしまいます。",
            ),
        ),
        Mistake(
            back.by_arccos,
            Text(
                "The compass heading comes from arccos, which is never negative, so east and west are not told apart. No inverse function is "
                "needed, or use arctan2.",
                "コンパスの方位を arccos で求めています。arccos は負にならないので、東と西を区別できません。逆三角関数は不要です。使うなら arctan2 にしましょう。",
            ),
        ),
        Mistake(
            back.by_arcsin,
            Text(
                "The compass heading comes from arcsin, which stays within a quarter turn of 0: southern directions are folded to the north. "
                "No inverse function is needed, or use arctan2.",
                "コンパスの方位を arcsin で求めています。arcsin は ±π/2 の範囲しか返さないので、南向きの方位が北側に折り返されます。"
                "逆三角関数は不要です。使うなら arctan2 にしましょう。",
            ),
        ),
        Mistake(
            back.clipped,
            Text(
                "Headings beyond half a turn are cut off at pi (clip). A heading that goes on counting is right as it is.",
                "半回転を超える方位が(clip で)±π に切られています。±π を超えた方位も、そのままで正しい向きを表します。",
            ),
        ),
        Mistake(
            back.axes_exchanged,
            Text(
                "x and y are exchanged and the heading is kept. Here the axes stay the same in both descriptions; only the heading is counted in "
                "another way.",
                "x と y を入れ替えて、方位はそのままにしています。ここでは座標軸はどちらの表し方でも同じで、方位の測り方だけが違います。",
            ),
        ),
        Mistake(
            back.axes_exchanged_too,
            Text(
                "The heading is right, but x and y are exchanged as well. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、x と y まで入れ替わっています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            back.y_turned_round,
            Text(
                "y and the heading have their signs changed. That mirrors the world; here the axes stay the same, and the heading is counted from "
                "another one of them.",
                "y と方位の符号を変えています。それは鏡映しです。ここでは座標軸は同じで、方位を測り始める軸と回る向きが違います。",
            ),
        ),
        Mistake(
            back.y_turned_round_too,
            Text(
                "The heading is right, but the sign of y is changed as well. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、y の符号まで変わっています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            back.position_turned_left_too,
            Text(
                "The heading is right, but the position is turned by a quarter turn to the left. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、位置まで左へ 1/4 回転しています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            back.position_turned_right_too,
            Text(
                "The heading is right, but the position is turned by a quarter turn to the right. The axes stay the same: the robot has not moved.",
                "方位は合っていますが、位置まで右へ 1/4 回転しています。座標軸は同じで、ロボットも動いていません。",
            ),
        ),
        Mistake(
            back.heading_of_the_position,
            Text(
                "The heading is computed from x and y. Where the robot stands says nothing about where it looks: use theta.",
                "方位を x と y から計算しています。どこにいるかと、どちらを向いているかは別のことです。theta を使いましょう。",
            ),
        ),
        Mistake(
            back.bearing_of_the_position,
            Text(
                "The heading is computed from x and y: it is the bearing of the place where the robot stands. Where it looks is another matter: use theta.",
                "方位を x と y から計算していて、ロボットのいる場所の方角になっています。どちらを向いているかは別のことです。theta を使いましょう。",
            ),
        ),
        Mistake(
            back.position_lost,
            Text(
                "The heading is right, but x and y come back as 0. They are the same in both descriptions.",
                "方位は合っていますが、x と y が 0 になっています。位置はどちらの表し方でも同じです。",
            ),
        ),
        Mistake(
            back.heading_alone,
            Text(
                "The heading is right, but it comes back alone. Return x, y and the heading.",
                "方位は合っていますが、方位だけが返っています。x, y と方位の 3 つを返しましょう。",
            ),
        ),
        Mistake(
            back.position_alone,
            Text(
                "Only x and y come back. Return x, y and the heading.",
                "x と y だけが返っています。x, y と方位の 3 つを返しましょう。",
            ),
        ),
        Mistake(
            back.heading_first,
            Text(
                "The numbers are right, but the heading comes first. The order is (x, y, heading).",
                "値は合っていますが、方位が最初に来ています。順序は (x, y, 方位) です。",
            ),
        ),
        Mistake(
            back.direction_returned,
            Text(
                "Four numbers come back, with the cos and sin of the heading you were given. One heading in rad is asked for.",
                "4 つの数が返っていて、受け取った方位の cos と sin が入っています。求めるのは 1 つの方位 [rad] です。",
            ),
        ),
        Mistake(
            back.rounded,
            Text(
                "The heading is rounded. Converted back it is no longer the same: round only for display.",
                "方位が丸められています。逆に変換しても元に戻りません。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            back.position_cut_off,
            Text(
                "The heading is right, but x and y are cut to whole numbers. Leave out int.",
                "方位は合っていますが、x と y の小数部分が切り捨てられています。int への変換は不要です。",
            ),
        ),
    ),
)
