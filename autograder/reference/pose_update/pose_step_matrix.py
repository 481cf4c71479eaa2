"""pose_step_matrix(pose, displacement): slides, overview 4. A displacement (u, v, phi) in the sensor's axes, v not zero."""

import cmath

import numpy as np

from autograder.draws import magnitudes, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(pose, displacement):
    """Return the pose moved by (u, v) turned by its heading, and turned by phi."""
    x, y, theta = pose
    u, v, phi = displacement
    end = complex(x, y) + complex(u, v) * cmath.rect(1, theta)
    return end.real, end.imag, theta + phi


def cases(rng):
    """Draw displacements with a sideways part of either sign; u and v differ in size, so that they are not taken for each other.

    Headings are between 0 and pi, before and after the step, where no group is about them.
    """

    def start(turns=0):
        heading = (rng.integers(0, 4) + rng.uniform(0.26, 0.74)) * np.pi / 4
        return np.array([magnitudes(rng, 0.5, 3.0), magnitudes(rng, 0.5, 3.0), heading + 2 * np.pi * turns])

    def displacement(forward, left):
        return np.array([forward * rng.uniform(0.9, 1.6), left * rng.uniform(0.3, 0.7), magnitudes(rng, 0.2, 0.9)])

    def step(forward, left, turns=0):
        return until(lambda: (start(turns), displacement(forward, left)), lambda *step: telling(*step, turns))

    def telling(pose, displacement, turns=0):
        return clear_of_zero(pose, displacement) and 0.1 < pose[2] + displacement[2] - 2 * np.pi * turns < 3.0

    def across_pi(side):
        pose, motion = start(), displacement(-side, side)
        pose[2], motion[2] = side * (np.pi - rng.uniform(0.2, 0.4)), side * rng.uniform(0.5, 0.9)
        return pose, motion

    def sideways(left):
        return until(lambda: (start(), displacement(0, left)), telling)

    def whole():
        motion = np.array([rng.choice([5, 6]), rng.choice([-2, -1]), rng.choice([-1, 1])])
        return np.array([rng.choice([-4, -3, 3, 4]), rng.choice([-4, -3, 3, 4]), 2]), motion

    across = [until(lambda side=side: across_pi(side), clear_of_zero) for side in (-1, 1)]
    return [
        Group(Text("forward and sideways", "前進と横移動"), 4, [step(1, left) for left in (1, -1, 1, -1)]),
        Group(Text("reversing", "後退"), 1, [step(-1, 1), step(-1, -1)]),
        Group(Text("sideways only", "横移動だけ"), 1, [sideways(1), sideways(-1)]),
        Group(Text("headings beyond half a turn", "半回転を超える方位"), 1, [step(1, 1, rng.choice([-2, -1, 1, 2])), *across]),
        Group(Text("whole numbers", "整数の入力"), 1, [until(whole, clear_of_zero)]),
        Group(Text("lists", "リストの入力"), 1, [tuple(part.tolist() for part in step(1, -1))]),
    ]


def clear_of_zero(pose, displacement):
    """Is every part of the new pose far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(pose, displacement))) > 0.3


def yaw_kept(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 0]]) @ displacement + pose


def yaw_replaced(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + [pose[0], pose[1], 0]


def turn_subtracted(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, -1]]) @ displacement + pose


def turn_multiplied_by_heading(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, pose[2]]]) @ displacement + pose


def turn_in_degrees(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 180 / np.pi]]) @ displacement + pose


def yaw_wrapped(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    moved = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose
    return np.array([moved[0], moved[1], (moved[2] + np.pi) % (2 * np.pi) - np.pi])


def yaw_wrapped_to_positive(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    moved = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose
    return np.array([moved[0], moved[1], moved[2] % (2 * np.pi)])


def plus_in_x(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def minus_in_y(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, -c, 0], [0, 0, 1]]) @ displacement + pose


def rotated_backwards(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ displacement + pose


def sideways_made_positive(pose, displacement):
    u, v, phi = displacement
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ [u, abs(v), phi] + pose


def reversing_made_forward(pose, displacement):
    u, v, phi = displacement
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ [abs(u), v, phi] + pose


def left_taken_for_right(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, s, 0], [s, -c, 0], [0, 0, 1]]) @ displacement + pose


def sideways_ignored(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, 0, 0], [s, 0, 0], [0, 0, 1]]) @ displacement + pose


def sideways_left_out_of_x(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, 0, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def only_along_own_axis(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, 0, 0], [0, s, 0], [0, 0, 1]]) @ displacement + pose


def only_the_diagonal(pose, displacement):
    c = np.cos(pose[2])
    return np.array([[c, 0, 0], [0, c, 0], [0, 0, 1]]) @ displacement + pose


def sideways_added_without_turning(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, 0, 0], [s, 1, 0], [0, 0, 1]]) @ displacement + pose


def sideways_along_the_heading(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, c, 0], [s, s, 0], [0, 0, 1]]) @ displacement + pose


def length_along_the_heading(pose, displacement):
    c, s, length = np.cos(pose[2]), np.sin(pose[2]), np.hypot(displacement[0], displacement[1])
    return np.array([pose[0] + length * c, pose[1] + length * s, pose[2] + displacement[2]])


def sin_cos_exchanged(pose, displacement):
    c, s = np.sin(pose[2]), np.cos(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def x_and_y_exchanged(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[s, c, 0], [c, -s, 0], [0, 0, 1]]) @ displacement + pose


def u_and_v_exchanged(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[-s, c, 0], [c, s, 0], [0, 0, 1]]) @ displacement + pose


def not_turned(pose, displacement):
    return np.array(pose) + np.array(displacement)


def turned_by_phi(pose, displacement):
    c, s = np.cos(displacement[2]), np.sin(displacement[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def turned_by_new_heading(pose, displacement):
    heading = pose[2] + displacement[2]
    c, s = np.cos(heading), np.sin(heading)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def turned_by_middle_heading(pose, displacement):
    heading = pose[2] + displacement[2] / 2
    c, s = np.cos(heading), np.sin(heading)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def curved_path(pose, displacement):
    u, v, phi = displacement
    end = complex(u, v) * (np.exp(1j * phi) - 1) / (1j * phi) * np.exp(1j * pose[2])
    return np.array([pose[0] + end.real, pose[1] + end.imag, pose[2] + phi])


def degrees_in_cos(pose, displacement):
    c, s = np.cos(np.deg2rad(pose[2])), np.sin(np.deg2rad(pose[2]))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def converted_to_degrees_for_cos(pose, displacement):
    c, s = np.cos(np.rad2deg(pose[2])), np.sin(np.rad2deg(pose[2]))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose


def start_forgotten(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement


def position_forgotten(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + [0, 0, pose[2]]


def displacement_subtracted(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array(pose) - np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement


def start_turned_too(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ (np.array(displacement) + pose)


def start_turned_instead(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ pose + displacement


def pose_turned_by_phi(pose, displacement):
    c, s = np.cos(displacement[2]), np.sin(displacement[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ pose + displacement


def multiplied_elementwise(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) * displacement + pose


def column_returned(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    column = np.array(displacement).reshape(3, 1)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ column + np.array(pose).reshape(3, 1)


def column_plus_row(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    column = np.array(displacement).reshape(3, 1)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ column + np.array(pose)


def whole_numbers_cut_off(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    moved = np.array(pose)
    moved[:] = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose
    return moved


def rounded(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.round(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ displacement + pose, 3)


def yaw_left_out(pose, displacement):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([[c, -s], [s, c]]) @ displacement[:2] + pose[:2]


EXERCISE = Exercise(
    name="pose_step_matrix",
    notebook="odometry/pose_update",
    points=5,
    parameters=("pose", "displacement"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (np.array([1.0, 2.0, np.pi / 6]), np.array([0.5, 0.2, 0.1])),
        (np.array([0.0, 0.0, np.pi / 2]), np.array([-1.0, 0.25, -0.3])),
    ),
    mistakes=(
        Mistake(
            yaw_kept,
            Text(
                "The heading stays as it was. The third row of the matrix must hand phi on.",
                "方位が元のままです。行列の 3 行目は phi を受け渡す行です。",
            ),
        ),
        Mistake(
            yaw_replaced,
            Text(
                "The new heading is phi alone. phi is the change; it is added to the old heading.",
                "新しい方位が phi だけになっています。phi は変化量ですから、元の方位に足します。",
            ),
        ),
        Mistake(
            turn_subtracted,
            Text(
                "phi is subtracted from the heading. Its sign already says to which side the robot turns: look at the lower "
                "right corner of the matrix.",
                "方位から phi を引いています。回る向きは phi の符号が表しています。行列の右下の成分を見直しましょう。",
            ),
        ),
        Mistake(
            turn_multiplied_by_heading,
            Text(
                "phi is multiplied by theta before it is added. The lower right corner of the matrix must hand phi on unchanged.",
                "phi に theta を掛けてから足しています。行列の右下の成分は、phi をそのまま受け渡すためのものです。",
            ),
        ),
        Mistake(
            turn_in_degrees,
            Text(
                "phi is turned into degrees before it is added to a heading in rad. Both are in rad already.",
                "rad の方位に、度に変換した phi を足しています。どちらも初めから rad です。",
            ),
        ),
        Mistake(
            yaw_wrapped,
            Text(
                "The heading is wrapped to -pi..pi. Here it goes on counting beyond half a turn: wrap only for display.",
                "方位が -π〜π に折り返されています。ここでは半回転を超えてもそのまま数え続けます。"
                "折り返すのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            yaw_wrapped_to_positive,
            Text(
                "The heading is wrapped to 0..2 pi. Here it may be negative or beyond one turn: no modulo.",
                "方位が 0〜2π に折り返されています。ここでは負になっても 1 回転を超えてもかまいません。剰余はとりません。",
            ),
        ),
        Mistake(
            plus_in_x,
            Text(
                "In x the sideways part v has the wrong sign. With a heading of 90 deg (pi/2), to which side of the x axis "
                "does the sensor's left point?",
                "x の式で、横方向の移動量 v の符号が逆です。方位が π/2 のとき、センサの左側は x 軸の正と負、"
                "どちらを向いているでしょうか。",
            ),
        ),
        Mistake(
            minus_in_y,
            Text(
                "In y the sideways part v has the wrong sign. With a heading of 0 the sensor's axes and the global ones "
                "coincide: what must v do to y there?",
                "y の式で、横方向の移動量 v の符号が逆です。方位 0 ではセンサの軸と全体の軸が重なります。"
                "そのとき v だけ動くと y はどう変わるでしょうか。",
            ),
        ),
        Mistake(
            rotated_backwards,
            Text(
                "The displacement is turned the wrong way round. Either the matrix is the transpose (from global to sensor "
                "axes), or the vector stands to the left of the matrix. Which entry carries the minus sign in overview 4?",
                "移動量を逆向きに回転しています。行列が転置(グローバルからセンサへ)になっているか、"
                "ベクトルを行列の左から掛けていませんか。概要 #4 の行列で、マイナスが付いているのはどの成分でしょうか。",
            ),
        ),
        Mistake(
            sideways_made_positive,
            Text(
                "A step to the right comes out as a step to the left: the sign of v is lost.",
                "右への移動が左への移動になっています。v の符号が失われています。",
            ),
        ),
        Mistake(
            reversing_made_forward,
            Text(
                "A step backwards comes out as a step forward: the sign of u is lost.",
                "後退が前進になっています。u の符号が失われています。",
            ),
        ),
        Mistake(
            left_taken_for_right,
            Text(
                "v is taken to the right of the sensor, in x and in y. A positive v points to the left, 90 deg "
                "counter-clockwise from u.",
                "x でも y でも、v がセンサの右向きになっています。正の v は u から反時計回りに 90 度、つまり左向きです。",
            ),
        ),
        Mistake(
            sideways_ignored,
            Text(
                "v has no effect. For a wheeled robot it is 0, but here the displacement has a sideways part too: use the "
                "whole second column of the matrix.",
                "v が結果に入っていません。車輪型ロボットなら 0 ですが、ここでは横方向にも動きます。"
                "行列の 2 列目もすべて使いましょう。",
            ),
        ),
        Mistake(
            sideways_left_out_of_x,
            Text(
                "x takes no notice of v. Once the robot is turned, a sideways step changes x as well: look at the first row "
                "of the matrix.",
                "x の式に v が入っていません。ロボットが傾いた向きにあれば、横方向の移動は x も変えます。"
                "行列の 1 行目を見直しましょう。",
            ),
        ),
        Mistake(
            only_along_own_axis,
            Text(
                "x uses u alone and y uses v alone. Both u and v have a part along x and a part along y: all four corner "
                "entries of the matrix count.",
                "x には u だけ、y には v だけが使われています。u も v も、x 方向と y 方向の両方に成分を持ちます。"
                "回転の 4 つの成分がすべて必要です。",
            ),
        ),
        Mistake(
            only_the_diagonal,
            Text(
                "Only the cosines are used, the sines are missing. With a heading of pi/2 nothing would move at all.",
                "cos だけが使われていて、sin がありません。これでは方位 π/2 のとき、まったく動かないことになります。",
            ),
        ),
        Mistake(
            sideways_added_without_turning,
            Text(
                "u is turned by the heading, but v is added to y as it is. v belongs to the sensor's axes as well, so it must "
                "be turned too.",
                "u は方位に合わせて回転していますが、v はそのまま y に足されています。"
                "v もセンサ座標の量ですから、同じように回転が必要です。",
            ),
        ),
        Mistake(
            sideways_along_the_heading,
            Text(
                "v is added to u, as if both pointed along the heading. v is perpendicular to u: the second column of the "
                "matrix differs from the first.",
                "v を u に足していて、どちらも前向きの移動になっています。v は u と直角の向きです。"
                "行列の 2 列目は 1 列目とは違います。",
            ),
        ),
        Mistake(
            length_along_the_heading,
            Text(
                "The whole length sqrt(u^2 + v^2) is taken along the heading. Its direction is lost that way, and reversing too.",
                "長さ √(u²+v²) をまるごと方位の向きに進めています。これでは移動の向きも、後退の符号も失われます。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged in the matrix. At heading 0 it must change nothing: compute it there and look at "
                "the diagonal.",
                "行列の sin と cos が入れ替わっています。方位 0 では何も変わらないはずです。"
                "theta = 0 を入れて対角成分を見てみましょう。",
            ),
        ),
        Mistake(
            x_and_y_exchanged,
            Text(
                "What belongs to x is added to y, and the other way round: the first two rows of the matrix are exchanged. A "
                "heading of 0 looks along +x.",
                "x に足す移動量と y に足す移動量が入れ替わっています。行列の 1 行目と 2 行目が逆です。方位 0 は +x の向きです。",
            ),
        ),
        Mistake(
            u_and_v_exchanged,
            Text(
                "u and v are exchanged. The displacement is (u, v, phi): forward first, then to the left.",
                "u と v が入れ替わっています。移動量は (u, v, phi)、つまり前方向、左方向の順です。",
            ),
        ),
        Mistake(
            not_turned,
            Text(
                "The displacement is added to the pose without being turned. It is given in the sensor's axes, the pose in "
                "the global ones: what carries one into the other?",
                "移動量を、回転させずにそのまま姿勢に足しています。移動量はセンサ座標、姿勢はグローバル座標の量です。"
                "その間をつなぐのは何でしょうか。",
            ),
        ),
        Mistake(
            turned_by_phi,
            Text(
                "The displacement is turned by phi, the change of heading. The robot's axes are turned against the global "
                "ones by the heading theta itself.",
                "移動量を、方位の変化量 phi だけ回転しています。ロボットの座標軸は、方位 theta そのものだけ傾いています。",
            ),
        ),
        Mistake(
            turned_by_new_heading,
            Text(
                "The displacement is turned by the heading after the step. In overview 4 it is measured in the axes before "
                "the step: compute the matrix before theta changes.",
                "移動量を、動いた後の方位で回転しています。概要 #4 では、移動量は動く前の座標で測ったものです。"
                "theta を更新する前に行列を計算しましょう。",
            ),
        ),
        Mistake(
            turned_by_middle_heading,
            Text(
                "The displacement is turned by theta + phi/2. That is the midpoint rule, the next exercise but one; overview "
                "4 uses the heading before the step.",
                "移動量を theta + phi/2 だけ回転しています。これは中点則で、あとの課題で扱います。"
                "概要 #4 の式は動く前の方位を使います。",
            ),
        ),
        Mistake(
            curved_path,
            Text(
                "This follows a curved path on which the robot turns steadily. Overview 4 takes the displacement as a "
                "straight step in the axes before the step.",
                "一定の割合で回りながら進む曲線の式になっています。"
                "概要 #4 では、移動量を、動く前の座標でのまっすぐな 1 歩として扱います。",
            ),
        ),
        Mistake(
            degrees_in_cos,
            Text(
                "theta is converted as if it were in degrees. It is in rad already, and np.cos takes rad.",
                "theta を度とみなして変換しています。theta はすでに rad で、np.cos も rad を受け取ります。",
            ),
        ),
        Mistake(
            converted_to_degrees_for_cos,
            Text(
                "theta is turned into degrees before cos and sin. np.cos takes rad: leave theta as it is.",
                "cos, sin に渡す前に theta を度に変換しています。np.cos は rad を受け取るので、そのまま渡しましょう。",
            ),
        ),
        Mistake(
            start_forgotten,
            Text(
                "This is the turned displacement alone. Overview 4 has one more term: where did the start go?",
                "回転した移動量だけが返っています。概要 #4 の式にはもう 1 つ項があります。出発点はどこで足しますか。",
            ),
        ),
        Mistake(
            position_forgotten,
            Text(
                "x and y of the start are missing: the motion is added to the old position.",
                "出発点の x, y が足されていません。移動量は元の位置に足します。",
            ),
        ),
        Mistake(
            displacement_subtracted,
            Text(
                "The displacement is subtracted from the pose, so the robot moves and turns the opposite way.",
                "姿勢から移動量を引いているため、動く向きも回る向きも逆になっています。",
            ),
        ),
        Mistake(
            start_turned_too,
            Text(
                "The start is turned as well: the matrix multiplies the sum. The start is in global axes already; mind the "
                "brackets.",
                "出発点まで回転しています。足してから行列を掛けていませんか。出発点はもともとグローバル座標です。"
                "かっこの位置を見直しましょう。",
            ),
        ),
        Mistake(
            start_turned_instead,
            Text(
                "The matrix multiplies the start and leaves the displacement as it is. Which of the two is given in the "
                "sensor's axes?",
                "行列を出発点の方に掛け、移動量はそのまま足しています。センサ座標で表されているのはどちらでしょうか。",
            ),
        ),
        Mistake(
            pose_turned_by_phi,
            Text(
                "The start is turned by phi, and the displacement is added as it is. Both are mixed up: what is to be turned, "
                "and by which angle?",
                "出発点を phi だけ回転し、移動量はそのまま足しています。"
                "何を、どの角度だけ回転するのか、概要 #4 の式で確かめましょう。",
            ),
        ),
        Mistake(
            multiplied_elementwise,
            Text(
                "The matrix is multiplied entry by entry: * gives a (3, 3) array here. The product of a matrix and a vector "
                "is written @.",
                "行列を成分ごとに掛けています。* では (3, 3) の配列になります。行列とベクトルの積は @ で書きます。",
            ),
        ),
        Mistake(
            column_returned,
            Text(
                "The result is a column, shape (3, 1). A pose has shape (3,): three numbers in a row, without inner brackets. "
                ".ravel() flattens a column.",
                "結果が形状 (3, 1) の縦ベクトルになっています。姿勢の形状は (3,) です。.ravel() で 1 次元の配列になります。",
            ),
        ),
        Mistake(
            column_plus_row,
            Text(
                "A column (3, 1) and a row (3,) were added, and NumPy made a (3, 3) table of all sums. Let both have the "
                "shape (3,).",
                "縦ベクトル (3, 1) と (3,) の配列を足したため、NumPy がすべての組み合わせの和を (3, 3) に並べています。"
                "どちらも (3,) にそろえましょう。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With a pose of whole numbers the decimals are cut off: a copy of an integer array holds integers only. Make "
                "it np.array(pose, dtype=float).",
                "姿勢が整数で渡されると、小数部分が切り捨てられます。整数の配列をコピーすると整数しか入りません。"
                "np.array(pose, dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded. Thousands of steps follow one another, and so do their rounding errors: round only "
                "for display.",
                "結果が丸められています。何千歩も積み重なると丸め誤差も積み重なります。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            yaw_left_out,
            Text(
                "Only x and y come back. A pose is (x, y, theta): return all three.",
                "x と y だけが返っています。姿勢は (x, y, theta) の 3 つ組です。3 つとも返しましょう。",
            ),
        ),
    ),
)
