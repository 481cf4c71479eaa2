"""planar_rotation(theta): the (3, 3) matrix of the slides, overview 4, that turns (u, v, phi) into global axes."""

import cmath

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(theta):
    """Return the images of forward, left and turn as columns."""
    forward = cmath.rect(1, theta)
    left = 1j * forward
    return np.column_stack([(forward.real, forward.imag, 0.0), (left.real, left.imag, 0.0), (0.0, 0.0, 1.0)])


def cases(rng):
    """Draw headings of both signs in all four quadrants, away from the axes and diagonals; the easy ones apart."""

    def eighth(number):
        return (number + rng.uniform(0.26, 0.74)) * np.pi / 4

    quadrants = np.array([0, 2, 4, 6]) + rng.integers(0, 2, 4)
    far = [eighth(4) + 2 * np.pi * rng.integers(1, 3), eighth(5) - 2 * np.pi * rng.integers(2, 4)]
    return [
        Group(Text("positive headings", "正の方位"), 3, [(eighth(number),) for number in quadrants]),
        Group(Text("negative headings", "負の方位"), 3, [(eighth(number) - 2 * np.pi,) for number in quadrants]),
        Group(Text("headings beyond one turn", "1 回転を超える方位"), 1, [(theta,) for theta in far]),
        Group(Text("small headings", "小さな方位"), 1, [(rng.uniform(0.06, 0.15),), (rng.uniform(-0.15, -0.06),)]),
        Group(Text("whole numbers", "整数の方位"), 1, [(rng.choice([4, 10]),), (rng.choice([-2, -9]),)]),
        Group(Text("heading 0", "方位 0"), 1, [(0.0,), (0,)]),
    ]


def identity_returned(theta):
    return np.eye(3)


def negative_headings_made_zero(theta):
    c, s = np.cos(max(theta, 0)), np.sin(max(theta, 0))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def half_turns_dropped(theta):
    c, s = np.cos(theta % np.pi), np.sin(theta % np.pi)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def cosine_positive_by_tangent(theta):
    t = np.tan(theta)
    c = 1 / np.sqrt(1 + t**2)
    s = t * c
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def quarter_turn_too_far(theta):
    c, s = np.cos(theta + np.pi / 2), np.sin(theta + np.pi / 2)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def transposed(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def no_minus_sign(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, s, 0], [s, c, 0], [0, 0, 1]])


def both_sines_negative(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0], [-s, c, 0], [0, 0, 1]])


def mirror_matrix(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, s, 0], [s, -c, 0], [0, 0, 1]])


def second_cosine_negative(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0], [s, -c, 0], [0, 0, 1]])


def first_cosine_negative(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[-c, -s, 0], [s, c, 0], [0, 0, 1]])


def sin_cos_exchanged(theta):
    c, s = np.sin(theta), np.cos(theta)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def columns_exchanged(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[-s, c, 0], [c, s, 0], [0, 0, 1]])


def rows_exchanged(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[s, c, 0], [c, -s, 0], [0, 0, 1]])


def sine_squared(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -(s**2), 0], [s**2, c, 0], [0, 0, 1]])


def tan_for_sin(theta):
    c, t = np.cos(theta), np.tan(theta)
    return np.array([[c, -t, 0], [t, c, 0], [0, 0, 1]])


def small_angle_matrix(theta):
    return np.array([[1.0, -theta, 0], [theta, 1.0, 0], [0, 0, 1]])


def sine_from_root(theta):
    c = np.cos(theta)
    s = np.sqrt(1 - c**2)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def cosine_from_root(theta):
    s = np.sin(theta)
    c = np.sqrt(1 - s**2)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def heading_made_positive(theta):
    c, s = np.cos(abs(theta)), np.sin(abs(theta))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def degrees_in_cos(theta):
    c, s = np.cos(np.deg2rad(theta)), np.sin(np.deg2rad(theta))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def converted_to_degrees_for_cos(theta):
    c, s = np.cos(np.rad2deg(theta)), np.sin(np.rad2deg(theta))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def turned_twice(theta):
    c, s = np.cos(2 * theta), np.sin(2 * theta)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def heading_in_the_corner(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, theta]])


def zero_in_the_corner(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 0]])


def ones_in_the_last_column(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 1], [s, c, 1], [0, 0, 1]])


def ones_in_the_last_row(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0], [s, c, 0], [1, 1, 1]])


def turned_about_x(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def turned_about_y(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def rounded(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.round([[c, -s, 0], [s, c, 0], [0, 0, 1]], 3)


def whole_numbers_cut_off(theta):
    matrix = np.eye(3, dtype=int)
    matrix[0, 0] = matrix[1, 1] = np.cos(theta)
    matrix[0, 1], matrix[1, 0] = -np.sin(theta), np.sin(theta)
    return matrix


def copied_from_an_integer_heading(theta):
    matrix = np.eye(3, dtype=np.asarray(theta).dtype)
    matrix[0, 0] = matrix[1, 1] = np.cos(theta)
    matrix[0, 1], matrix[1, 0] = -np.sin(theta), np.sin(theta)
    return matrix


def only_two_by_two(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s], [s, c]])


def nine_in_a_row(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([c, -s, 0, s, c, 0, 0, 0, 1])


def four_by_four(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


EXERCISE = Exercise(
    name="planar_rotation",
    notebook="odometry/pose_update",
    points=5,
    parameters=("theta",),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=((np.pi / 6,), (-np.pi / 2,)),
    mistakes=(
        Mistake(
            identity_returned,
            Text(
                "This is the identity: nothing is turned, whatever theta is. Where does theta come in?",
                "単位行列が返っています。theta が何であっても回転しません。theta はどこに入りますか。",
            ),
        ),
        Mistake(
            negative_headings_made_zero,
            Text(
                "Negative headings are treated as 0. A robot that has turned to the right has a negative heading, and its "
                "matrix turns to the right.",
                "負の方位が 0 として扱われています。右に回ったロボットの方位は負で、行列も右へ回転します。",
            ),
        ),
        Mistake(
            half_turns_dropped,
            Text(
                "Half turns are dropped from theta (modulo pi), which turns the robot round. cos and sin take any heading as "
                "it is.",
                "theta から半回転(π)の倍数が落とされ、前後が逆になることがあります。"
                "cos と sin にはどんな方位もそのまま渡せます。",
            ),
        ),
        Mistake(
            cosine_positive_by_tangent,
            Text(
                "The cosine always comes out positive. A tangent cannot tell a heading from the opposite one; use cos and sin "
                "themselves.",
                "cos がいつも正になっています。tan では、ある方位とその反対の方位を区別できません。"
                "cos と sin をそのまま使いましょう。",
            ),
        ),
        Mistake(
            quarter_turn_too_far,
            Text(
                "The matrix turns by a quarter turn too far. theta is counted from the x axis, so that at heading 0 nothing "
                "changes.",
                "1/4 回転だけ余計に回っています。theta は x 軸から測るので、方位 0 では何も変わらないはずです。",
            ),
        ),
        Mistake(
            transposed,
            Text(
                "This matrix turns the other way: it is the transpose, from global to sensor axes. Multiply it by (1, 0, 0) "
                "at a small positive heading: the result must point a little to the left, towards +y.",
                "回転の向きが逆です。これは転置した行列で、グローバル座標からセンサ座標へ移すものです。"
                "小さな正の方位で (1, 0, 0) に掛けてみましょう。結果は少し左、+y の側を向くはずです。",
            ),
        ),
        Mistake(
            no_minus_sign,
            Text(
                "Both sines have the same sign, plus. A rotation keeps forward and left at right angles: is the product of "
                "the first two columns 0?",
                "2 つの sin がどちらもプラスです。回転しても前方向と左方向は直角のままです。"
                "1 列目と 2 列目の内積は 0 になっていますか。",
            ),
        ),
        Mistake(
            both_sines_negative,
            Text(
                "Both sines have the same sign, minus. A rotation keeps forward and left at right angles: is the product of "
                "the first two columns 0?",
                "2 つの sin がどちらもマイナスです。回転しても前方向と左方向は直角のままです。"
                "1 列目と 2 列目の内積は 0 になっていますか。",
            ),
        ),
        Mistake(
            mirror_matrix,
            Text(
                "This matrix mirrors instead of turning: its determinant is -1. At heading 0 nothing may change: what does "
                "the second row do to v there?",
                "これは回転ではなく鏡映の行列で、行列式が -1 です。方位 0 では何も変わらないはずです。"
                "そのとき 2 行目は v をどう変えていますか。",
            ),
        ),
        Mistake(
            second_cosine_negative,
            Text(
                "The cosine in the second row has a minus sign. At heading 0 the matrix must change nothing: v there would "
                "become -v.",
                "2 行目の cos にマイナスが付いています。方位 0 では何も変わらないはずですが、"
                "これでは v が -v になってしまいます。",
            ),
        ),
        Mistake(
            first_cosine_negative,
            Text(
                "The cosine in the first row has a minus sign. At heading 0 the matrix must change nothing: u there would "
                "become -u.",
                "1 行目の cos にマイナスが付いています。方位 0 では何も変わらないはずですが、"
                "これでは u が -u になってしまいます。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged. At heading 0 the matrix must change nothing; compute it there and look at the "
                "diagonal.",
                "sin と cos が入れ替わっています。方位 0 では何も変わらないはずです。"
                "theta = 0 を入れて対角成分を見てみましょう。",
            ),
        ),
        Mistake(
            columns_exchanged,
            Text(
                "The first two columns are exchanged. The first column says where forward (1, 0, 0) goes, the second where "
                "left (0, 1, 0) goes.",
                "1 列目と 2 列目が入れ替わっています。1 列目は前方向 (1, 0, 0) の行き先、2 列目は左方向 (0, 1, 0) の行き先です。",
            ),
        ),
        Mistake(
            rows_exchanged,
            Text(
                "The first two rows are exchanged. The first row gives the part along x, the second the part along y.",
                "1 行目と 2 行目が入れ替わっています。1 行目が x 成分、2 行目が y 成分を与えます。",
            ),
        ),
        Mistake(
            sine_squared,
            Text(
                "The sines are squared. Each entry of the matrix is the sine or cosine itself.",
                "sin が 2 乗されています。行列の成分は sin や cos そのものです。",
            ),
        ),
        Mistake(
            tan_for_sin,
            Text(
                "tan stands where a sine belongs. A displacement keeps its length when it is turned: is each of the first two "
                "columns of length 1?",
                "sin であるべきところに tan が使われています。回転しても移動量の長さは変わりません。"
                "1 列目と 2 列目の長さは 1 になっていますか。",
            ),
        ),
        Mistake(
            small_angle_matrix,
            Text(
                "cos theta is replaced by 1 and sin theta by theta. That holds for tiny angles only; here any heading may come.",
                "cos theta を 1、sin theta を theta で置き換えています。これはごく小さな角度だけの近似です。"
                "ここではどんな方位も渡されます。",
            ),
        ),
        Mistake(
            sine_from_root,
            Text(
                "The sine always comes out positive, as a square root does. Its sign depends on the heading; use the sine "
                "itself.",
                "sin がいつも正になっています。平方根で求めると符号が失われます。sin をそのまま使いましょう。",
            ),
        ),
        Mistake(
            cosine_from_root,
            Text(
                "The cosine always comes out positive, as a square root does. Beyond a quarter turn it must be negative; use "
                "the cosine itself.",
                "cos がいつも正になっています。平方根で求めると符号が失われます。1/4 回転を超えると cos は負です。"
                "cos をそのまま使いましょう。",
            ),
        ),
        Mistake(
            heading_made_positive,
            Text(
                "A negative heading is treated like a positive one: the sign of theta is lost.",
                "負の方位が正の方位と同じ行列になっています。theta の符号が失われています。",
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
            turned_twice,
            Text(
                "The matrix turns by twice the heading. Is theta added to itself, or the matrix multiplied by itself?",
                "方位の 2 倍だけ回転する行列になっています。theta を 2 回足したり、行列を 2 回掛けたりしていませんか。",
            ),
        ),
        Mistake(
            heading_in_the_corner,
            Text(
                "theta stands in the lower right corner. The third row takes phi over as it is; the old heading is added "
                "later, outside the matrix.",
                "右下の成分が theta になっています。3 行目は phi をそのまま受け渡す行です。"
                "元の方位は、行列の外であとから足します。",
            ),
        ),
        Mistake(
            zero_in_the_corner,
            Text(
                "The lower right corner is 0, so that the turn phi is lost. The third row must hand phi on unchanged.",
                "右下の成分が 0 なので、回転量 phi が消えてしまいます。3 行目は phi をそのまま受け渡すための行です。",
            ),
        ),
        Mistake(
            ones_in_the_last_column,
            Text(
                "There are ones above the lower right corner: they would add phi, an angle, to x and y. The matrix of "
                "overview 4 has zeros there.",
                "3 列目の上の 2 つの成分が 1 です。これでは角度 phi が x と y に足されてしまいます。"
                "概要 #4 の行列を見直しましょう。",
            ),
        ),
        Mistake(
            ones_in_the_last_row,
            Text(
                "There are ones left of the lower right corner: they would add lengths to an angle. The matrix of overview 4 "
                "has zeros there.",
                "3 行目の左の 2 つの成分が 1 です。これでは長さが角度に足されてしまいます。概要 #4 の行列を見直しましょう。",
            ),
        ),
        Mistake(
            turned_about_x,
            Text(
                "This turns about the x axis. A robot on the floor turns about the vertical axis: the third row and column "
                "are the ones that stay.",
                "x 軸まわりの回転になっています。床の上のロボットは鉛直軸まわりに回ります。変わらないのは 3 行目と 3 列目です。",
            ),
        ),
        Mistake(
            turned_about_y,
            Text(
                "This turns about the y axis. A robot on the floor turns about the vertical axis: the third row and column "
                "are the ones that stay.",
                "y 軸まわりの回転になっています。床の上のロボットは鉛直軸まわりに回ります。変わらないのは 3 行目と 3 列目です。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The entries are rounded. After many steps such errors add up: round only for display.",
                "成分が丸められています。何歩も積み重ねると誤差が大きくなります。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "The decimals are cut off: an array of integers holds integers only. Look at the dtype with which the matrix "
                "is made.",
                "小数部分が切り捨てられています。整数の配列には整数しか入りません。行列を作るときの dtype を確かめましょう。",
            ),
        ),
        Mistake(
            copied_from_an_integer_heading,
            Text(
                "When theta is a whole number the decimals of the matrix are cut off: its dtype follows that of theta. Make "
                "the matrix of floats.",
                "theta が整数のとき、行列の小数部分が切り捨てられます。行列の dtype が theta と同じ整数になっています。"
                "浮動小数点数の行列を作りましょう。",
            ),
        ),
        Mistake(
            only_two_by_two,
            Text(
                "This is the rotation of x and y alone, (2, 2). The matrix of overview 4 acts on (u, v, phi): it has a third "
                "row and column.",
                "x と y だけを回転する 2×2 の行列です。概要 #4 の行列は (u, v, phi) に掛けるので、3 行目と 3 列目があります。",
            ),
        ),
        Mistake(
            nine_in_a_row,
            Text(
                "The nine numbers come in one row. Group them in three rows, with a bracket around each.",
                "9 つの数が 1 列に並んでいます。1 行ごとに角かっこで囲み、3 行にまとめましょう。",
            ),
        ),
        Mistake(
            four_by_four,
            Text(
                "This is a (4, 4) matrix of three-dimensional geometry. A pose in the plane has three entries (x, y, theta), "
                "so (3, 3) is asked for.",
                "3 次元用の 4×4 の行列です。平面上の姿勢は (x, y, theta) の 3 つですから、3×3 の行列を返しましょう。",
            ),
        ),
    ),
)
