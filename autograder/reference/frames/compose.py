"""compose(a, b): pose b, given in frame a, in a's parent. Notes 001, section 2: a pose is a frame, and frames hang in frames."""

import cmath

import numpy as np

from autograder.draws import heading, pose, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import Tolerance


def reference(a, b):
    """Return the end of two arrows laid end to end, the second one turned with the frame; headings add."""
    end = complex(a[0], a[1]) + complex(b[0], b[1]) * cmath.rect(1.0, a[2])
    return end.real, end.imag, a[2] + b[2]


def cases(rng):
    """Draw pairs of poses; the main groups hold headings in the third and the second quadrant, where arctan, arcsin or arccos fail."""

    def pair(side, turns=0, backwards=0):
        def draw():
            a, b = pose(rng), pose(rng)
            a[2] = side * (abs(a[2]) + 2 * np.pi * turns)
            if backwards:
                b[2] = side * np.pi + backwards * rng.uniform(0.3, 1.2) - a[2]
            return a, b

        return until(draw, clear_of_zero)

    def turned(side):
        return [pair(side, backwards=1), pair(side, backwards=-1), pair(side)]

    def whole():
        return rng.integers(1, 6, 3) * rng.choice([-1, 1], 3), rng.integers(1, 6, 3) * rng.choice([-1, 1], 3)

    far = [pair(side, turns=1, backwards=1) for side in rng.permutation([1, -1])]
    listed = until(lambda: (pose(rng).tolist(), pose(rng).tolist()), clear_of_zero)
    start = pose(rng)
    return [
        Group(Text("frames turned to the left", "左に回った座標系"), 3, turned(1)),
        Group(Text("frames turned to the right", "右に回った座標系"), 3, turned(-1)),
        Group(Text("headings beyond one turn", "1 回転を超える方位"), 2, far),
        Group(Text("lists and whole numbers", "リストや整数の入力"), 1, [until(whole, clear_of_zero), listed]),
        Group(
            Text("one of the two is (0, 0, 0)", "一方が (0, 0, 0) のとき"),
            1,
            [(np.zeros(3), pose(rng)), (start, np.zeros(3)), (np.array([0.0, 0.0, heading(rng)]), np.zeros(3))],
        ),
    ]


def clear_of_zero(a, b):
    """Are x and y of the result far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(a, b)[:2])) > 0.5


def added_component_by_component(a, b):
    return np.asarray(a) + np.asarray(b)


def plus_sign_on_lists(a, b):
    return a + b


def multiplied_component_by_component(a, b):
    return np.asarray(a) * np.asarray(b)


def order_exchanged(a, b):
    c, s = np.cos(b[2]), np.sin(b[2])
    return np.array([b[0] + c * a[0] - s * a[1], b[1] + s * a[0] + c * a[1], a[2] + b[2]])


def rotated_the_other_way(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] + s * b[1], a[1] - s * b[0] + c * b[1], a[2] + b[2]])


def rotated_by_the_heading_of_b(a, b):
    c, s = np.cos(b[2]), np.sin(b[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def rotated_by_both_headings(a, b):
    c, s = np.cos(a[2] + b[2]), np.sin(a[2] + b[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def rotated_by_the_difference(a, b):
    c, s = np.cos(a[2] - b[2]), np.sin(a[2] - b[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def rotated_by_positive_angle_only(a, b):
    c, s = np.cos(abs(a[2])), np.sin(abs(a[2]))
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def own_position_rotated_too(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    x, y = a[0] + b[0], a[1] + b[1]
    return np.array([c * x - s * y, s * x + c * y, a[2] + b[2]])


def only_a_rotated(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([c * a[0] - s * a[1] + b[0], s * a[0] + c * a[1] + b[1], a[2] + b[2]])


def position_of_a_forgotten(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([c * b[0] - s * b[1], s * b[0] + c * b[1], a[2] + b[2]])


def y_of_b_ignored(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0], a[1] + s * b[0], a[2] + b[2]])


def each_axis_by_itself(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0], a[1] + s * b[1], a[2] + b[2]])


def sin_cos_exchanged(a, b):
    c, s = np.sin(a[2]), np.cos(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def sin_cos_exchanged_in_y(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + c * b[0] + s * b[1], a[2] + b[2]])


def no_minus_sign(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] + s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def minus_sign_twice(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] - s * b[0] + c * b[1], a[2] + b[2]])


def mirrored(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] + s * b[1], a[1] + s * b[0] - c * b[1], a[2] + b[2]])


def y_from_the_new_x(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    x, y = b[0], b[1]
    x = c * x - s * y
    y = s * x + c * y
    return np.array([a[0] + x, a[1] + y, a[2] + b[2]])


def x_of_the_result_used_for_y(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    x = a[0] + c * b[0] - s * b[1]
    return np.array([x, a[1] + s * x + c * b[1], a[2] + b[2]])


def a_subtracted_from_the_rotated_b(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([c * b[0] - s * b[1] - a[0], s * b[0] + c * b[1] - a[1], a[2] + b[2]])


def b_subtracted_from_a(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] - c * b[0] + s * b[1], a[1] - s * b[0] - c * b[1], a[2] + b[2]])


def b_as_seen_from_a(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    dx, dy = b[0] - a[0], b[1] - a[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, b[2] - a[2]])


def heading_of_b_alone(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], b[2]])


def heading_of_a_alone(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2]])


def heading_b_minus_a(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], b[2] - a[2]])


def heading_a_minus_b(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] - b[2]])


def heading_towards_the_point(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + np.arctan2(b[1], b[0])])


def heading_by_arctan(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], np.arctan(np.tan(a[2] + b[2]))])


def heading_by_arccos(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], np.arccos(np.cos(a[2] + b[2]))])


def heading_by_arcsin(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], np.arcsin(np.sin(a[2] + b[2]))])


def heading_modulo_pi(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], (a[2] + b[2]) % np.pi])


def heading_made_positive(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], abs(a[2] + b[2])])


def heading_in_degrees(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], np.rad2deg(a[2] + b[2])])


def degrees_in_cos(a, b):
    c, s = np.cos(np.deg2rad(a[2])), np.sin(np.deg2rad(a[2]))
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def converted_to_degrees_for_cos(a, b):
    c, s = np.cos(np.rad2deg(a[2])), np.sin(np.rad2deg(a[2]))
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def small_angles(a, b):
    return np.array([a[0] + b[0] - a[2] * b[1], a[1] + a[2] * b[0] + b[1], a[2] + b[2]])


def whole_numbers_cut_off(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    moved = np.array(a)
    moved[0] = a[0] + c * b[0] - s * b[1]
    moved[1] = a[1] + s * b[0] + c * b[1]
    moved[2] = a[2] + b[2]
    return moved


def rounded(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.round([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]], 3)


def matrix_returned(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    frame = np.array([[c, -s, a[0]], [s, c, a[1]], [0, 0, 1]])
    c, s = np.cos(b[2]), np.sin(b[2])
    return frame @ np.array([[c, -s, b[0]], [s, c, b[1]], [0, 0, 1]])


def column_of_the_matrix_returned(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([[c, -s, a[0]], [s, c, a[1]], [0, 0, 1]]) @ np.array([b[0], b[1], 1])


def column_returned(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([[a[0] + c * b[0] - s * b[1]], [a[1] + s * b[0] + c * b[1]], [a[2] + b[2]]])


def heading_left_out(a, b):
    c, s = np.cos(a[2]), np.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1]])


EXERCISE = Exercise(
    name="compose",
    notebook="odometry/frames",
    points=5,
    parameters=("a", "b"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=Tolerance(axis=-1, angles=(2,)),
    examples=(
        (np.array([1.0, 2.0, np.pi / 2]), np.array([3.0, 0.0, 0.0])),
        (np.array([1.0, 2.0, -np.pi / 6]), np.array([2.0, 1.0, np.pi / 4])),
    ),
    mistakes=(
        Mistake(
            added_component_by_component,
            Text(
                "The two poses are added number by number. That holds only if frame a is not turned: x and y of b are measured along "
                "a's axes, so they must be turned by a's heading before they are added.",
                "2 つの姿勢を成分ごとに足しています。それで正しいのは座標系 a が回転していないときだけです。"
                "b の x, y は a の軸に沿って測った値なので、a の方位だけ回転させてから足します。",
            ),
        ),
        Mistake(
            plus_sign_on_lists,
            Text(
                "a + b: arrays are added number by number, and lists are even joined into one of six numbers. x and y of b are "
                "measured along a's axes, so they must be turned by a's heading before they are added, each by its index.",
                "a + b としています。配列なら成分ごとの和になり、リストなら 6 個の数をつないだリストになってしまいます。"
                "b の x, y は a の軸に沿って測った値なので、要素を取り出し、a の方位だけ回転させてから足します。",
            ),
        ),
        Mistake(
            multiplied_component_by_component,
            Text(
                "The two poses are multiplied number by number. The circle in a ∘ b is no product of numbers: it lays one frame into "
                "another.",
                "2 つの姿勢を成分ごとに掛けています。a ∘ b の ∘ は数の積ではなく、座標系の中に座標系を置く演算です。",
            ),
        ),
        Mistake(
            order_exchanged,
            Text(
                "a and b are exchanged: here a is seen from b. The order matters: which of the two frames carries the other, and whose "
                "heading must therefore turn the other's x and y?",
                "a と b の順序が逆で、b の中に a を置いています。合成は順序を変えると結果が変わります。"
                "どちらの座標系がもう一方を載せていて、どちらの方位で相手の x, y を回転させるのかを考えましょう。",
            ),
        ),
        Mistake(
            rotated_the_other_way,
            Text(
                "x and y of b are turned the wrong way: this rotation leads from the parent into frame a. Put a at heading pi/2 and b "
                "one metre in front of it: does y grow?",
                "b の x, y を逆向きに回転させています。これは親の座標系から座標系 a への回転です。"
                "a の方位を π/2、b をその 1 m 前方にしたとき、y が増えるかどうか確かめましょう。",
            ),
        ),
        Mistake(
            rotated_by_the_heading_of_b,
            Text(
                "x and y of b are turned by b's own heading. They are measured along the axes of the frame that b is given in: whose "
                "heading is that?",
                "b の x, y を b 自身の方位で回転させています。b の x, y はどの座標系の軸に沿って測った値でしょうか。"
                "その座標系の方位で回転させます。",
            ),
        ),
        Mistake(
            rotated_by_both_headings,
            Text(
                "x and y of b are turned by the sum of both headings. The sum is the heading of the result; how b itself is turned does not "
                "move its position.",
                "b の x, y を 2 つの方位の和で回転させています。和は結果の方位です。"
                "b 自身がどちらを向いているかは、b の位置には関係しません。",
            ),
        ),
        Mistake(
            rotated_by_the_difference,
            Text(
                "x and y of b are turned by the difference of the headings. How b itself is turned does not move its position: only the "
                "heading of the frame it is given in counts.",
                "b の x, y を方位の差で回転させています。b 自身の向きは位置には関係しません。"
                "関係するのは、b が表されている座標系の方位だけです。",
            ),
        ),
        Mistake(
            rotated_by_positive_angle_only,
            Text(
                "A frame turned to the right is treated as if it were turned to the left: the sign of a's heading is lost in the rotation.",
                "右に回った座標系が、左に回ったものとして計算されています。回転に使う a の方位の符号が失われています。",
            ),
        ),
        Mistake(
            own_position_rotated_too,
            Text(
                "a's own position is turned as well: x and y are added before the rotation. a's position is given in the parent's axes "
                "already; only b's has to be turned.",
                "足してから回転させているため、a 自身の位置まで回転しています。a の位置はすでに親の座標系の値です。"
                "回転させるのは b の x, y だけです。",
            ),
        ),
        Mistake(
            only_a_rotated,
            Text(
                "The rotation falls on a's position instead of b's. a's position is given in the parent already; which of the two positions "
                "is measured along a's axes?",
                "b ではなく a の位置を回転させています。a の位置はすでに親の座標系の値です。"
                "a の軸に沿って測られているのは、どちらの位置でしょうか。",
            ),
        ),
        Mistake(
            position_of_a_forgotten,
            Text(
                "b is turned rightly, but a's position is missing: where does frame a have its origin in the parent?",
                "b の回転は合っていますが、a の位置が足されていません。座標系 a の原点は、親の座標系のどこにありますか。",
            ),
        ),
        Mistake(
            y_of_b_ignored,
            Text(
                "The y of b is not used: that is enough for a step straight ahead, but b may lie to the left or right of frame a's x axis.",
                "b の y が使われていません。まっすぐ前に進むだけならそれで足りますが、b は座標系 a の x 軸から左右に外れていることもあります。",
            ),
        ),
        Mistake(
            each_axis_by_itself,
            Text(
                "x takes only b's x, and y only b's y. When an axis is turned it has a part along both axes of the parent: each line has two terms.",
                "x には b の x だけ、y には b の y だけを使っています。回転した軸は、親の座標系の両方の軸に成分を持ちます。"
                "それぞれの式に項が 2 つずつ必要です。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged. For a heading of 0 the frame is not turned: which of the two must be 1 there?",
                "sin と cos が入れ替わっています。方位 0 なら座標系は回転していません。そのとき 1 になるべきなのはどちらでしょうか。",
            ),
        ),
        Mistake(
            sin_cos_exchanged_in_y,
            Text(
                "x is right, but in the line for y sin and cos are exchanged. For a heading of 0 the y of b must come out unchanged.",
                "x は合っていますが、y の式で sin と cos が入れ替わっています。方位 0 のとき b の y がそのまま残るはずです。",
            ),
        ),
        Mistake(
            no_minus_sign,
            Text(
                "All four terms have a plus sign. A rotation has one minus: in a frame turned by pi/2, b's y axis points along the "
                "parent's -x.",
                "4 つの項がすべてプラスです。回転の式にはマイナスが 1 つあります。π/2 回った座標系の y 軸は、親の座標系の -x を向きます。",
            ),
        ),
        Mistake(
            minus_sign_twice,
            Text(
                "There is one minus sign too many: it stands before both sines. In a frame turned by pi/2, the x axis points along the "
                "parent's +y.",
                "マイナスが 1 つ多く、2 つの sin の両方に付いています。π/2 回った座標系の x 軸は、親の座標系の +y を向きます。",
            ),
        ),
        Mistake(
            mirrored,
            Text(
                "This matrix mirrors instead of turning: for a heading of 0 the y of b comes out with the opposite sign.",
                "回転ではなく鏡映になっています。方位 0 のとき、b の y の符号が逆になってしまいます。",
            ),
        ),
        Mistake(
            y_from_the_new_x,
            Text(
                "x of b is overwritten before y is computed, so y uses the turned x. Keep the old x under its own name, or compute both at once.",
                "y を計算する前に b の x を上書きしているため、y の式に回転後の x が使われています。"
                "元の x を別の名前で残すか、x と y を同時に計算しましょう。",
            ),
        ),
        Mistake(
            x_of_the_result_used_for_y,
            Text(
                "The line for y uses the x that was just computed instead of b's x. Give the result a name of its own.",
                "y の式に、b の x ではなく、いま計算したばかりの x を使っています。結果には別の変数名を付けましょう。",
            ),
        ),
        Mistake(
            a_subtracted_from_the_rotated_b,
            Text(
                "a's position is subtracted. From the parent's origin one goes to frame a first, and on from there to b: is that a sum or a difference?",
                "a の位置を引いています。親の原点からまず座標系 a の原点へ、そこから b へ進みます。これは和でしょうか、差でしょうか。",
            ),
        ),
        Mistake(
            b_subtracted_from_a,
            Text(
                "The turned x and y of b are subtracted from a's position, so b comes to lie behind frame a instead of in front of it.",
                "回転させた b の x, y を a の位置から引いています。これでは a の前方にある b が後方に来てしまいます。",
            ),
        ),
        Mistake(
            b_as_seen_from_a,
            Text(
                "This is the opposite task, express_in: it takes b as given in the parent and looks at it from a. Here b is given in a "
                "already, and the way leads out to the parent.",
                "これは逆向きの課題 express_in の計算で、親の座標系にある b を a から見た姿勢です。"
                "ここでは b はすでに a の中で与えられていて、親の座標系へ出ていく向きに計算します。",
            ),
        ),
        Mistake(
            heading_of_b_alone,
            Text(
                "x and y are right, but the heading is b's alone. b's heading is counted from a's x axis, which is turned itself.",
                "x, y は合っていますが、方位が b の方位だけになっています。b の方位は a の x 軸から測った角度で、その軸自身も回転しています。",
            ),
        ),
        Mistake(
            heading_of_a_alone,
            Text(
                "x and y are right, but the heading is a's alone: how b is turned within a is lost.",
                "x, y は合っていますが、方位が a の方位だけになっています。a の中で b がどちらを向いているかが失われています。",
            ),
        ),
        Mistake(
            heading_b_minus_a,
            Text(
                "The heading is the difference b minus a. That is the heading seen from a; here b's is counted from a's x axis and goes out to the parent.",
                "方位が b - a の差になっています。それは a から見た方位です。ここでは a の x 軸から測った方位を、親の座標系での方位に直します。",
            ),
        ),
        Mistake(
            heading_a_minus_b,
            Text(
                "b's heading is subtracted from a's. A b turned to the left within a must be turned further to the left in the parent.",
                "a の方位から b の方位を引いています。a の中で左を向いている b は、親の座標系では a よりさらに左を向くはずです。",
            ),
        ),
        Mistake(
            heading_towards_the_point,
            Text(
                "The heading is taken from the direction in which b's position lies, by atan2(y, x). Where something stands says nothing about where "
                "it looks: that is the third number of b.",
                "方位を、b の位置が見える方向 atan2(y, x) から求めています。どこにあるかと、どちらを向いているかは別のことです。"
                "向きは b の 3 番目の数です。",
            ),
        ),
        Mistake(
            heading_by_arctan,
            Text(
                "The heading comes from arctan, which cannot tell a direction from the opposite one. Add the headings, or use arctan2 with both "
                "arguments.",
                "方位を arctan で求めています。arctan では、ある向きとその反対の向きを区別できません。"
                "方位どうしを足すか、引数が 2 つの arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_by_arccos,
            Text(
                "The heading comes from arccos, which is never negative: headings to the right come out as headings to the left. Add the headings, "
                "or use arctan2.",
                "方位を arccos で求めています。arccos は負にならないので、右向きの方位が左向きになってしまいます。"
                "方位どうしを足すか、arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_by_arcsin,
            Text(
                "The heading comes from arcsin, which stays within a quarter turn of 0: headings that look backwards are folded to the front. "
                "Add the headings, or use arctan2.",
                "方位を arcsin で求めています。arcsin は ±π/2 の範囲しか返さないので、後ろ向きの方位が前向きに折り返されます。"
                "方位どうしを足すか、arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_modulo_pi,
            Text(
                "The heading is taken modulo pi, half a turn: the robot then often looks the opposite way. A full turn is 2 pi; and here no "
                "modulo is needed at all.",
                "方位を半回転(π)で割った余りにしているため、反対を向くことがあります。1 回転は 2π です。そもそもここでは剰余をとる必要もありません。",
            ),
        ),
        Mistake(
            heading_made_positive,
            Text(
                "The sign of the heading is lost (abs). A negative heading looks to the right; its positive twin looks to the left.",
                "方位の符号が(abs で)失われています。負の方位は右向き、同じ大きさの正の方位は左向きで、別の向きです。",
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
                "a's heading is converted as if it were in degrees. It is in rad already, and np.cos takes rad.",
                "a の方位を度とみなして変換しています。方位はすでに rad で、np.cos も rad を受け取ります。",
            ),
        ),
        Mistake(
            converted_to_degrees_for_cos,
            Text(
                "a's heading is turned into degrees before cos and sin. np.cos takes rad: leave it as it is.",
                "cos, sin に渡す前に a の方位を度に変換しています。np.cos は rad を受け取るので、そのまま渡しましょう。",
            ),
        ),
        Mistake(
            small_angles,
            Text(
                "cos is replaced by 1 and sin by the angle itself. That is good for tiny turns only; a frame may be turned by any angle.",
                "cos を 1、sin を角度そのもので置き換えています。それはごく小さな角度だけの近似です。座標系はどんな角度にも回転します。",
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
                "The result is rounded. Frames are composed again and again, and so are their rounding errors: round only for display.",
                "結果が丸められています。座標系の合成を繰り返すと、丸め誤差も積み重なります。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            matrix_returned,
            Text(
                "The product of the two (3, 3) matrices comes back. It holds the pose, but not as one: read x, y and the heading out of it "
                "and return (x, y, theta).",
                "2 つの (3, 3) 行列の積がそのまま返っています。姿勢の情報は入っていますが、求めるのは (x, y, theta) です。"
                "行列から x, y と方位を取り出して返しましょう。",
            ),
        ),
        Mistake(
            column_of_the_matrix_returned,
            Text(
                "x and y are right, but the third number is the 1 that a homogeneous matrix needs to shift a point; it is no heading. "
                "The heading must be computed beside it.",
                "x, y は合っていますが、3 番目の数は同次変換行列で平行移動を表すための 1 で、方位ではありません。方位は別に計算します。",
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
