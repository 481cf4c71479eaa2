"""invert(a): the parent as seen from frame a, so that compose(a, invert(a)) is (0, 0, 0). Notes 001, section 2."""

import cmath

import numpy as np

from autograder.draws import heading, magnitudes, pose, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import Tolerance


def reference(a):
    """Return the way from a's origin back to the parent's, measured along a's axes."""
    back = -complex(a[0], a[1]) * cmath.rect(1.0, -a[2])
    return back.real, back.imag, -a[2]


def cases(rng):
    """Draw poses turned to either side; in the main groups the inverse looks backwards to both sides, where arctan, arcsin or arccos fail."""

    def turned(side, turns=0, backwards=0):
        def draw():
            a = pose(rng)
            a[2] = side * (abs(a[2]) + 2 * np.pi * turns)
            if backwards:
                a[2] = side * np.pi - backwards * rng.uniform(0.3, 1.2) + 2 * np.pi * side * turns
            return (a,)

        return until(draw, clear_of_zero)

    def whole():
        return (rng.integers(1, 6, 3) * rng.choice([-1, 1], 3),)

    return [
        Group(
            Text("frames turned to the left", "左に回った座標系"), 3, [turned(1, backwards=1), turned(1, backwards=-1), turned(1)]
        ),
        Group(
            Text("frames turned to the right", "右に回った座標系"),
            3,
            [turned(-1, backwards=1), turned(-1, backwards=-1), turned(-1)],
        ),
        Group(
            Text("headings beyond one turn", "1 回転を超える方位"),
            1,
            [turned(side, 1, backwards=1) for side in rng.permutation([1, -1])],
        ),
        Group(
            Text("only shifted, or only turned", "平行移動だけ、または回転だけ"),
            1,
            [
                (np.array([magnitudes(rng, 0.5, 3.0), magnitudes(rng, 0.5, 3.0), 0.0]),),
                (np.array([0.0, 0.0, heading(rng)]),),
            ],
        ),
        Group(
            Text("lists and whole numbers", "リストや整数の入力"),
            1,
            [until(whole, clear_of_zero), until(lambda: (pose(rng).tolist(),), clear_of_zero)],
        ),
    ]


def clear_of_zero(a):
    """Are x and y of the inverse far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(a)[:2])) > 0.5


def every_number_negated(a):
    return -np.asarray(a)


def rotated_the_wrong_way(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] + s * a[1], -s * a[0] - c * a[1], -a[2]])


def only_rotated_back(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([c * a[0] + s * a[1], c * a[1] - s * a[0], -a[2]])


def only_rotated_further(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([c * a[0] - s * a[1], s * a[0] + c * a[1], -a[2]])


def position_kept(a):
    return np.array([a[0], a[1], -a[2]])


def position_lost(a):
    return np.array([0.0, 0.0, -a[2]])


def heading_kept(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], a[2]])


def heading_zero(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], 0.0])


def turned_round(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], a[2] + np.pi])


def turned_round_and_back(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], np.pi - a[2]])


def x_not_negated(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([c * a[0] + s * a[1], s * a[0] - c * a[1], -a[2]])


def y_not_negated(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], c * a[1] - s * a[0], -a[2]])


def both_sines_negated(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], -s * a[0] - c * a[1], -a[2]])


def neither_sine_negated(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] + s * a[1], s * a[0] - c * a[1], -a[2]])


def sin_cos_exchanged(a):
    c, s = np.sin(a[2]), np.cos(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]])


def each_axis_by_itself(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0], s * a[1], -a[2]])


def x_and_y_exchanged(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([s * a[0] - c * a[1], -c * a[0] - s * a[1], -a[2]])


def y_from_the_new_x(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    x = -c * a[0] - s * a[1]
    y = s * x - c * a[1]
    return np.array([x, y, -a[2]])


def rotated_twice(a):
    c, s = np.cos(2 * a[2]), np.sin(2 * a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]])


def rotated_by_positive_angle_only(a):
    c, s = np.cos(abs(a[2])), np.sin(abs(a[2]))
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]])


def reciprocals(a):
    return np.array([1 / number if number else 0.0 for number in a])


def unchanged(a):
    return np.array(a, dtype=float)


def heading_by_arctan(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], np.arctan(-np.tan(a[2]))])


def heading_by_arccos(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], np.arccos(c)])


def heading_by_arcsin(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], np.arcsin(-s)])


def heading_modulo_pi(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2] % np.pi])


def heading_made_negative(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -abs(a[2])])


def heading_in_degrees(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -np.rad2deg(a[2])])


def degrees_in_cos(a):
    c, s = np.cos(np.deg2rad(a[2])), np.sin(np.deg2rad(a[2]))
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]])


def converted_to_degrees_for_cos(a):
    c, s = np.cos(np.rad2deg(a[2])), np.sin(np.rad2deg(a[2]))
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]])


def whole_numbers_cut_off(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    inverse = np.array(a)
    inverse[0] = -c * a[0] - s * a[1]
    inverse[1] = s * a[0] - c * a[1]
    inverse[2] = -a[2]
    return inverse


def rounded(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.round([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]], 3)


def matrix_returned(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.linalg.inv(np.array([[c, -s, a[0]], [s, c, a[1]], [0, 0, 1]]))


def transposed_matrix_returned(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([[c, -s, a[0]], [s, c, a[1]], [0, 0, 1]]).T


def last_column_of_the_matrix_returned(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], 1.0])


def column_returned(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([[-c * a[0] - s * a[1]], [s * a[0] - c * a[1]], [-a[2]]])


def heading_left_out(a):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1]])


EXERCISE = Exercise(
    name="invert",
    notebook="odometry/frames",
    points=5,
    parameters=("a",),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=Tolerance(axis=-1, angles=(2,)),
    examples=((np.array([2.0, 0.0, np.pi / 2]),), (np.array([1.0, -2.0, np.pi / 6]),)),
    mistakes=(
        Mistake(
            every_number_negated,
            Text(
                "Each number only has its sign changed. That is the inverse of a frame that is not turned. Composed with a, the result "
                "is not (0, 0, 0) where a is turned. The way back must be measured along a's turned axes.",
                "3 つの数の符号を変えただけになっています。それが正しいのは、座標系が回転していないときだけです。"
                "a が回転していると、合成しても (0, 0, 0) になりません。原点へ戻るベクトルは、回転した a の軸に沿って測ります。",
            ),
        ),
        Mistake(
            rotated_the_wrong_way,
            Text(
                "The signs outside are right, but the position is turned the wrong way: by a's heading instead of against it. "
                "The inverse goes from the parent's axes into a's.",
                "全体の符号は合っていますが、位置を a の方位の向きに回転させています。逆変換では親の軸から a の軸へ移るので、"
                "回転の向きは逆になります。",
            ),
        ),
        Mistake(
            only_rotated_back,
            Text(
                "The position is turned rightly, but it points from the parent's origin to a. Seen from a, one looks from a back to the "
                "parent's origin.",
                "位置の回転は合っていますが、親の原点から a へ向かうベクトルのままです。a から見るときは、a から親の原点へ向かうベクトルになります。",
            ),
        ),
        Mistake(
            only_rotated_further,
            Text(
                "The position is turned by a's heading and keeps its direction. For the inverse both are the other way round: turned against "
                "the heading, and pointing from a to the parent's origin.",
                "位置を a の方位の向きに回転させただけで、符号もそのままです。逆変換では、回転の向きもベクトルの向きもどちらも逆になります。",
            ),
        ),
        Mistake(
            position_kept,
            Text(
                "Only the heading is inverted; x and y are a's own. Where does the parent's origin lie, seen from a?",
                "方位だけが逆になっていて、x と y は a の値のままです。a から見ると、親の原点はどこにありますか。",
            ),
        ),
        Mistake(
            position_lost,
            Text(
                "The heading is right, but x and y are always 0. (The transpose inverts a rotation, not a matrix that shifts as well.)",
                "方位は合っていますが、x と y がいつも 0 です。(転置で逆になるのは回転行列だけで、平行移動を含む行列では逆行列になりません。)",
            ),
        ),
        Mistake(
            heading_kept,
            Text(
                "x and y are right, but the heading is a's own. If a is turned to the left as seen from the parent, to which side is the "
                "parent turned as seen from a?",
                "x, y は合っていますが、方位が a のままです。親から見て a が左に回っているとき、a から見た親はどちらに回っていますか。",
            ),
        ),
        Mistake(
            heading_zero,
            Text(
                "x and y are right, but the heading is always 0. Seen from a, the parent's axes are turned: by how much, and to which side?",
                "x, y は合っていますが、方位がいつも 0 です。a から見ると、親の座標系の軸はどちらへどれだけ回っていますか。",
            ),
        ),
        Mistake(
            turned_round,
            Text(
                "x and y are right, but the heading is a's plus half a turn. The inverse does not turn a round: it undoes a's rotation.",
                "x, y は合っていますが、方位が a の方位に半回転(π)を足したものになっています。反対を向くのではなく、a の回転を打ち消す角度を考えましょう。",
            ),
        ),
        Mistake(
            turned_round_and_back,
            Text(
                "x and y are right, and so is the sign of a's heading, but half a turn (pi) is added to it. For a = (0, 0, 0) nothing may be turned.",
                "x, y と方位の符号は合っていますが、方位に半回転(π)が余分に足されています。a = (0, 0, 0) なら何も回らないはずです。",
            ),
        ),
        Mistake(
            x_not_negated,
            Text(
                "y and the heading are right, but x has the wrong sign. Take a = (1, 0, 0): on which side of a does the parent's origin lie?",
                "y と方位は合っていますが、x の符号が逆です。a = (1, 0, 0) のとき、親の原点は a のどちら側にありますか。",
            ),
        ),
        Mistake(
            y_not_negated,
            Text(
                "x and the heading are right, but y has the wrong sign. Take a = (0, 1, 0): on which side of a does the parent's origin lie?",
                "x と方位は合っていますが、y の符号が逆です。a = (0, 1, 0) のとき、親の原点は a のどちら側にありますか。",
            ),
        ),
        Mistake(
            both_sines_negated,
            Text(
                "Both sines have the same sign, minus. In a rotation the two sines have opposite signs; look at the line for y.",
                "sin の項がどちらもマイナスです。回転では 2 つの sin の符号は互いに逆になります。y の式を見直しましょう。",
            ),
        ),
        Mistake(
            neither_sine_negated,
            Text(
                "Both sines have the same sign, plus. In a rotation the two sines have opposite signs; look at the line for x.",
                "sin の項がどちらもプラスです。回転では 2 つの sin の符号は互いに逆になります。x の式を見直しましょう。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged. For a heading of 0 the inverse is simply the shift back: which of the two must be 1 there?",
                "sin と cos が入れ替わっています。方位 0 なら逆変換は平行移動を戻すだけです。そのとき 1 になるべきなのはどちらでしょうか。",
            ),
        ),
        Mistake(
            each_axis_by_itself,
            Text(
                "x is made of a's x alone, and y of a's y alone. Along turned axes each of them has a part of both.",
                "x は a の x だけ、y は a の y だけから計算されています。回転した軸で測ると、どちらにも両方の成分が入ります。",
            ),
        ),
        Mistake(
            x_and_y_exchanged,
            Text(
                "x and y come back in each other's place. A pose is (x, y, theta).",
                "x と y が入れ替わって返っています。姿勢の順序は (x, y, theta) です。",
            ),
        ),
        Mistake(
            y_from_the_new_x,
            Text(
                "x is overwritten before y is computed, so the line for y uses the new x. Keep the old x under its own name.",
                "y を計算する前に x を上書きしているため、y の式に新しい x が使われています。元の x を別の名前で残しましょう。",
            ),
        ),
        Mistake(
            rotated_twice,
            Text(
                "The position is turned back by twice a's heading. Is the rotation applied two times?",
                "位置が a の方位の 2 倍だけ回転しています。回転を 2 回掛けていませんか。",
            ),
        ),
        Mistake(
            rotated_by_positive_angle_only,
            Text(
                "A frame turned to the right is treated as if it were turned to the left: the sign of the heading is lost in the rotation.",
                "右に回った座標系が、左に回ったものとして計算されています。回転に使う方位の符号が失われています。",
            ),
        ),
        Mistake(
            reciprocals,
            Text(
                "Each number is replaced by one over it. The inverse of a pose undoes its shift and its rotation; no number is divided.",
                "それぞれの数の逆数をとっています。姿勢の逆とは、平行移動と回転を元に戻す変換のことで、数の逆数ではありません。",
            ),
        ),
        Mistake(
            unchanged,
            Text(
                "The pose comes back as it was given. The inverse is the parent as seen from a.",
                "姿勢がそのまま返っています。求めるのは、a から見た親の座標系の姿勢です。",
            ),
        ),
        Mistake(
            heading_by_arctan,
            Text(
                "The heading comes from arctan, which cannot tell a direction from the opposite one. Use the heading you are given, or arctan2 "
                "with both arguments.",
                "方位を arctan で求めています。arctan では、ある向きとその反対の向きを区別できません。"
                "与えられた方位をそのまま使うか、引数が 2 つの arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_by_arccos,
            Text(
                "The heading comes from arccos, which is never negative, so the side is lost. Use the heading you are given, or arctan2.",
                "方位を arccos で求めています。arccos は負にならないので、左右の区別が失われます。"
                "与えられた方位をそのまま使うか、arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_by_arcsin,
            Text(
                "The heading comes from arcsin, which stays within a quarter turn of 0: headings that look backwards are folded to the front. "
                "Use the heading you are given, or arctan2.",
                "方位を arcsin で求めています。arcsin は ±π/2 の範囲しか返さないので、後ろ向きの方位が前向きに折り返されます。"
                "与えられた方位をそのまま使うか、arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_modulo_pi,
            Text(
                "The heading is taken modulo pi, half a turn: the frame then often looks the opposite way. A full turn is 2 pi; and here no "
                "modulo is needed at all.",
                "方位を半回転(π)で割った余りにしているため、反対を向くことがあります。1 回転は 2π です。そもそもここでは剰余をとる必要もありません。",
            ),
        ),
        Mistake(
            heading_made_negative,
            Text(
                "The heading of the result is always negative (abs): for a frame turned to the right it looks to the wrong side.",
                "結果の方位が(abs で)いつも負になっています。右に回った座標系では、向きが逆になってしまいます。",
            ),
        ),
        Mistake(
            heading_in_degrees,
            Text(
                "x and y are right, but the heading comes back in degrees. The course computes in rad throughout.",
                "x, y は合っていますが、方位が度で返っています。この講義では角度をすべて rad で扱います。",
            ),
        ),
        Mistake(
            degrees_in_cos,
            Text(
                "The heading is converted as if it were in degrees. It is in rad already, and np.cos takes rad.",
                "方位を度とみなして変換しています。方位はすでに rad で、np.cos も rad を受け取ります。",
            ),
        ),
        Mistake(
            converted_to_degrees_for_cos,
            Text(
                "The heading is turned into degrees before cos and sin. np.cos takes rad: leave it as it is.",
                "cos, sin に渡す前に方位を度に変換しています。np.cos は rad を受け取るので、そのまま渡しましょう。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With a pose of whole numbers the decimals are cut off: a copy of an integer array holds integers only. "
                "Make it np.array(a, dtype=float).",
                "姿勢が整数で渡されると、小数部分が切り捨てられます。整数の配列をコピーすると整数しか入りません。"
                "np.array(a, dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded. Composed with a it no longer gives (0, 0, 0): round only for display.",
                "結果が丸められています。a と合成しても (0, 0, 0) になりません。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            matrix_returned,
            Text(
                "The inverse of the (3, 3) matrix comes back. It holds the pose, but not as one: read x, y and the heading out of it "
                "and return (x, y, theta).",
                "(3, 3) の逆行列がそのまま返っています。姿勢の情報は入っていますが、求めるのは (x, y, theta) です。"
                "行列から x, y と方位を取り出して返しましょう。",
            ),
        ),
        Mistake(
            transposed_matrix_returned,
            Text(
                "The transpose of the (3, 3) matrix comes back. The transpose inverts a rotation, but not a matrix that shifts as well; and a "
                "pose (x, y, theta) is asked for.",
                "(3, 3) 行列の転置が返っています。転置で逆になるのは回転行列だけで、平行移動を含む行列では逆行列になりません。"
                "また、求めるのは姿勢 (x, y, theta) です。",
            ),
        ),
        Mistake(
            last_column_of_the_matrix_returned,
            Text(
                "x and y are right, but the third number is the 1 from the last row of a homogeneous matrix; it is no heading.",
                "x, y は合っていますが、3 番目の数は同次変換行列の最後の行の 1 で、方位ではありません。",
            ),
        ),
        Mistake(
            column_returned,
            Text(
                "The numbers are right, but they come back as a column, shape (3, 1). A pose is flat, shape (3,): try np.ravel.",
                "値は合っていますが、形状が (3, 1) の列ベクトルになっています。姿勢は形状 (3,) です。np.ravel を試してみましょう。",
            ),
        ),
        Mistake(
            heading_left_out,
            Text(
                "Only x and y come back. A pose is (x, y, theta): return all three.",
                "x と y だけが返っています。姿勢は (x, y, theta) の 3 つ組です。3 つとも返しましょう。",
            ),
        ),
    ),
)
