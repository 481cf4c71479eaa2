"""q1_symbolic(x1, y1, theta1, u, v, phi): question 1 with a sensor-frame displacement, slides overview 3-4, on numbers and symbols."""

import math

import numpy as np
import sympy as sp

from autograder.draws import magnitudes, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(x1, y1, theta1, u, v, phi):
    """Return the start plus u steps ahead and v to the left, and theta1 + phi."""
    functions = sp if isinstance(theta1, sp.Basic) else math
    ahead = functions.cos(theta1), functions.sin(theta1)
    left = -ahead[1], ahead[0]
    return x1 + u * ahead[0] + v * left[0], y1 + u * ahead[1] + v * left[1], theta1 + phi


def cases(rng):
    """Draw displacements with a sideways part of either sign; u and v differ in size, so that they are not taken for each other.

    Headings are between 0 and pi, before and after the step, where no group is about them.
    """

    def moved(forward, left, turns=0):
        def draw():
            heading = (rng.integers(0, 4) + rng.uniform(0.26, 0.74)) * np.pi / 4
            start = magnitudes(rng, 0.5, 3.0), magnitudes(rng, 0.5, 3.0), heading + 2 * np.pi * turns
            return *start, forward * rng.uniform(0.9, 1.6), left * rng.uniform(0.3, 0.7), magnitudes(rng, 0.2, 0.9)

        return until(draw, lambda *inputs: clear_of_zero(*inputs) and 0.1 < inputs[2] + inputs[5] - 2 * np.pi * turns < 3.0)

    def across_pi(side):
        start = magnitudes(rng, 0.5, 3.0), magnitudes(rng, 0.5, 3.0), side * (np.pi - rng.uniform(0.2, 0.4))
        return *start, -side * rng.uniform(0.9, 1.6), side * rng.uniform(0.3, 0.7), side * rng.uniform(0.5, 0.9)

    def whole():
        start = int(rng.choice([-4, -3, 3, 4])), int(rng.choice([-4, -3, 3, 4])), 2
        return *start, int(rng.choice([5, 6])), int(rng.choice([-2, -1])), int(rng.choice([-1, 1]))

    across = [until(lambda side=side: across_pi(side), clear_of_zero) for side in (-1, 1)]
    return [
        Group(Text("numbers, forward", "数値、前進"), 3, [moved(1, left) for left in (1, -1, 1)]),
        Group(Text("numbers, reversing", "数値、後退"), 1, [moved(-1, 1), moved(-1, -1)]),
        Group(Text("headings beyond half a turn", "半回転を超える方位"), 1, [moved(1, 1, rng.choice([-2, -1, 1, 2])), *across]),
        Group(Text("whole numbers", "整数の入力"), 1, [until(whole, clear_of_zero)]),
        Group(Text("SymPy symbols", "SymPy の記号"), 3, [moved(1, -1), moved(-1, 1)], symbols=True),
    ]


def clear_of_zero(x1, y1, theta1, u, v, phi):
    """Is every part of the new pose far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(x1, y1, theta1, u, v, phi))) > 0.3


def numbers_only(x1, y1, theta1, u, v, phi):
    c, s = math.cos(theta1), math.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def own_symbols(x1, y1, theta1, u, v, phi):
    x1, y1, theta1, u, v, phi = sp.symbols("x1 y1 theta1 u v phi")
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def equations_returned(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    left = sp.symbols("x2 y2 theta2")
    return sp.Eq(left[0], x1 + c * u - s * v), sp.Eq(left[1], y1 + s * u + c * v), sp.Eq(left[2], theta1 + phi)


def yaw_kept(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1


def yaw_replaced(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, phi


def turn_subtracted(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 - phi


def turn_in_degrees(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi * 180 / sp.pi


def yaw_wrapped(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, (theta1 + phi + math.pi) % (2 * math.pi) - math.pi


def yaw_wrapped_to_positive(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, (theta1 + phi) % (2 * math.pi)


def plus_in_x(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u + s * v, y1 + s * u + c * v, theta1 + phi


def minus_in_y(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u - c * v, theta1 + phi


def sideways_made_positive(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    v = abs(v)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def reversing_made_forward(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    u = abs(u)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def left_taken_for_right(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u + s * v, y1 + s * u - c * v, theta1 + phi


def rotated_backwards(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u + s * v, y1 - s * u + c * v, theta1 + phi


def sideways_ignored(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u, y1 + s * u, theta1 + phi


def sideways_left_out_of_x(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u, y1 + s * u + c * v, theta1 + phi


def sideways_left_out_of_y(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u, theta1 + phi


def only_along_own_axis(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u, y1 + s * v, theta1 + phi


def sideways_added_without_turning(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u, y1 + s * u + v, theta1 + phi


def sideways_along_the_heading(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * (u + v), y1 + s * (u + v), theta1 + phi


def length_along_the_heading(x1, y1, theta1, u, v, phi):
    c, s, length = sp.cos(theta1), sp.sin(theta1), sp.sqrt(u**2 + v**2)
    return x1 + c * length, y1 + s * length, theta1 + phi


def sin_cos_exchanged(x1, y1, theta1, u, v, phi):
    c, s = sp.sin(theta1), sp.cos(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def x_and_y_exchanged(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + s * u + c * v, y1 + c * u - s * v, theta1 + phi


def u_and_v_exchanged(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * v - s * u, y1 + s * v + c * u, theta1 + phi


def not_turned(x1, y1, theta1, u, v, phi):
    return x1 + u, y1 + v, theta1 + phi


def turned_by_phi(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(phi), sp.sin(phi)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def turned_by_new_heading(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1 + phi), sp.sin(theta1 + phi)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def turned_by_middle_heading(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1 + phi / 2), sp.sin(theta1 + phi / 2)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def heading_overwritten_before_y(x1, y1, theta1, u, v, phi):
    x1 = x1 + sp.cos(theta1) * u - sp.sin(theta1) * v
    theta1 = theta1 + phi
    return x1, y1 + sp.sin(theta1) * u + sp.cos(theta1) * v, theta1


def degrees_in_cos(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1 * sp.pi / 180), sp.sin(theta1 * sp.pi / 180)
    return x1 + c * u - s * v, y1 + s * u + c * v, theta1 + phi


def start_forgotten(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return c * u - s * v, s * u + c * v, phi


def position_forgotten(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return c * u - s * v, s * u + c * v, theta1 + phi


def displacement_subtracted(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 - c * u + s * v, y1 - s * u - c * v, theta1 + phi


def start_turned_too(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return c * (x1 + u) - s * (y1 + v), s * (x1 + u) + c * (y1 + v), theta1 + phi


def start_turned_instead(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return c * x1 - s * y1 + u, s * x1 + c * y1 + v, theta1 + phi


def rounded(x1, y1, theta1, u, v, phi):
    c, s = math.cos(theta1), math.sin(theta1)
    return round(x1 + c * u - s * v, 3), round(y1 + s * u + c * v, 3), round(theta1 + phi, 3)


def yaw_left_out(x1, y1, theta1, u, v, phi):
    c, s = sp.cos(theta1), sp.sin(theta1)
    return x1 + c * u - s * v, y1 + s * u + c * v


EXERCISE = Exercise(
    name="q1_symbolic",
    notebook="odometry/pose_update",
    points=5,
    parameters=("x1", "y1", "theta1", "u", "v", "phi"),
    quantities=("x2", "y2", "theta2"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (1.0, 2.0, np.pi / 6, 0.5, 0.2, 0.1),
        (0.0, 0.0, np.pi / 2, 1.0, 0.25, -0.3),
    ),
    mistakes=(
        Mistake(
            numbers_only,
            Text(
                "With SymPy symbols the function stops with a TypeError: something in it needs a number, such as a function "
                "of math or NumPy, float() or a comparison with <. SymPy brings its own cos and sin, which take symbols as "
                "well as numbers.",
                "SymPy の記号を入れると TypeError で止まります。math や NumPy の関数、float()、大小の比較など、"
                "数値でなければ計算できないものが使われているようです。"
                "SymPy にも cos と sin があり、記号にも数値にも使えます。",
            ),
        ),
        Mistake(
            own_symbols,
            Text(
                "Symbols are left in the result even when the function is called with numbers. Are the symbols made inside "
                "the function, so that its arguments are not used? Compute with the arguments x1, y1, theta1, u, v, phi "
                "themselves.",
                "数値を渡しても、結果に記号が残っています。関数の中で記号を作り直していて、"
                "引数を使っていないのではありませんか。引数の x1, y1, theta1, u, v, phi をそのまま使って計算しましょう。",
            ),
        ),
        Mistake(
            equations_returned,
            Text(
                "What comes back are three objects that are neither numbers nor expressions; equations such as Eq(x2, ...) "
                "look like that. Return the right-hand sides alone.",
                "数値でも式でもないものが 3 つ返っています。Eq(x2, ...) のような等式を返していませんか。"
                "返すのは右辺の式だけです。",
            ),
        ),
        Mistake(
            yaw_kept,
            Text(
                "The heading stays as it was. The sensor turns by phi during the step: which line of overview 4 says so?",
                "方位が元のままです。この移動のあいだに、向きは phi だけ変わります。概要 #4 の 3 行目を見てみましょう。",
            ),
        ),
        Mistake(
            yaw_replaced,
            Text(
                "The new heading is phi alone. phi is the change of heading; where does the old heading come in?",
                "新しい方位が phi だけになっています。phi は方位の変化量です。元の方位はどこに入りますか。",
            ),
        ),
        Mistake(
            turn_subtracted,
            Text(
                "phi is subtracted from the heading. The sign of phi already says to which side it turns.",
                "方位から phi を引いています。どちらへ回るかは phi の符号がすでに表しています。",
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
                "The heading is wrapped to -pi..pi. Here it goes on counting beyond half a turn: leave the sum as it is.",
                "方位が -π〜π に折り返されています。ここでは半回転を超えてもそのまま数え続けます。"
                "和に手を加える必要はありません。",
            ),
        ),
        Mistake(
            yaw_wrapped_to_positive,
            Text(
                "The heading is wrapped to 0..2 pi. Here it may be negative or beyond one turn: leave the sum as it is.",
                "方位が 0〜2π に折り返されています。ここでは負になっても 1 回転を超えてもかまいません。"
                "和に手を加える必要はありません。",
            ),
        ),
        Mistake(
            plus_in_x,
            Text(
                "In x the sideways part v has the wrong sign. Take a heading of 90 deg (pi/2): the sensor's left then points "
                "to which side of the x axis?",
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
            rotated_backwards,
            Text(
                "The displacement is turned the wrong way round: this is the matrix from global to sensor coordinates (the "
                "transpose). Which entry of the matrix in overview 4 carries the minus sign?",
                "移動量を逆向きに回転しています。これはグローバル座標からセンサ座標へ移す行列(転置)です。"
                "概要 #4 の行列で、マイナスが付いているのはどの成分でしょうか。",
            ),
        ),
        Mistake(
            sideways_ignored,
            Text(
                "v has no effect. For a wheeled robot it is 0, but here the displacement has a sideways part too, and it "
                "shows in x and in y.",
                "v が結果に入っていません。車輪型ロボットなら 0 ですが、ここでは横方向にも動きます。"
                "v は x にも y にも効いてきます。",
            ),
        ),
        Mistake(
            sideways_left_out_of_x,
            Text(
                "x takes no notice of v. Once the sensor is turned, a sideways step changes x as well.",
                "x の式に v が入っていません。センサが傾いた向きにあれば、横方向の移動は x も変えます。",
            ),
        ),
        Mistake(
            sideways_left_out_of_y,
            Text(
                "y takes no notice of v. Draw the sensor's two axes at a small heading: along which global axis does v mostly "
                "point?",
                "y の式に v が入っていません。方位が小さいときのセンサの 2 つの軸を描いてみましょう。"
                "v はほぼどちらの軸に沿っていますか。",
            ),
        ),
        Mistake(
            only_along_own_axis,
            Text(
                "x uses u alone and y uses v alone. Both u and v have a part along x and a part along y: write out both rows "
                "of the matrix product.",
                "x には u だけ、y には v だけが使われています。u も v も、x 方向と y 方向の両方に成分を持ちます。"
                "行列の積を 2 行とも書き下してみましょう。",
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
                "v is added to u, as if both pointed along the heading. v is perpendicular to u.",
                "v を u に足していて、どちらも前向きの移動になっています。v は u と直角の向きです。",
            ),
        ),
        Mistake(
            length_along_the_heading,
            Text(
                "The whole length sqrt(u^2 + v^2) is taken along the heading. Its direction is lost that way, and reversing "
                "too: turn u and v each by the heading.",
                "長さ √(u²+v²) をまるごと方位の向きに進めています。これでは移動の向きも、後退の符号も失われます。"
                "u と v をそれぞれ方位に合わせて回転しましょう。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged. At heading 0 nothing is to be turned: what must the factor of u in x be there?",
                "sin と cos が入れ替わっています。方位 0 では回転しないはずです。"
                "そのとき x の式で u に掛かる係数はいくつになるべきでしょうか。",
            ),
        ),
        Mistake(
            x_and_y_exchanged,
            Text(
                "What belongs to x is added to y, and the other way round. A heading of 0 looks along +x, so u must go to x "
                "there.",
                "x に足す移動量と y に足す移動量が入れ替わっています。"
                "方位 0 は +x の向きですから、そのとき u は x に入るはずです。",
            ),
        ),
        Mistake(
            u_and_v_exchanged,
            Text(
                "u and v are exchanged. u is the part forward, v the part to the left; look at their order among the arguments.",
                "u と v が入れ替わっています。u が前方向、v が左方向の移動量です。引数の順序を確かめましょう。",
            ),
        ),
        Mistake(
            not_turned,
            Text(
                "u and v are added to x and y without being turned. They are given in the sensor's axes; x and y belong to "
                "the global ones.",
                "u と v を、回転させずにそのまま x と y に足しています。u と v はセンサ座標、x と y はグローバル座標の量です。",
            ),
        ),
        Mistake(
            turned_by_phi,
            Text(
                "The displacement is turned by phi, the change of heading. The sensor's axes are turned against the global "
                "ones by the heading itself.",
                "移動量を、方位の変化量 phi だけ回転しています。センサ座標とグローバル座標の傾きの差は、方位そのものです。",
            ),
        ),
        Mistake(
            turned_by_new_heading,
            Text(
                "The displacement is turned by the heading after the step. In overview 4 it is given in the axes before the "
                "step.",
                "移動量を、動いた後の方位で回転しています。概要 #4 では、移動量は動く前のセンサ座標で測ったものです。",
            ),
        ),
        Mistake(
            turned_by_middle_heading,
            Text(
                "The displacement is turned by theta1 + phi/2. That is the midpoint rule, an exercise of its own; overview 4 "
                "uses the heading before the step.",
                "移動量を theta1 + phi/2 だけ回転しています。これは中点則で、別の課題で扱います。"
                "概要 #4 の式は動く前の方位を使います。",
            ),
        ),
        Mistake(
            heading_overwritten_before_y,
            Text(
                "x uses the old heading but y the new one: theta1 is overwritten between the two lines. Work out the heading "
                "last.",
                "x は古い方位、y は新しい方位で計算されています。2 つの行の間で theta1 が上書きされています。"
                "方位の計算は最後にしましょう。",
            ),
        ),
        Mistake(
            degrees_in_cos,
            Text(
                "theta1 is converted as if it were in degrees. It is in rad, and cos and sin of SymPy, NumPy and math all "
                "take rad.",
                "theta1 を度とみなして変換しています。theta1 は rad です。"
                "SymPy、NumPy、math のどの cos, sin も rad を受け取ります。",
            ),
        ),
        Mistake(
            start_forgotten,
            Text(
                "This is the displacement alone, turned into the global axes. Where did the start x1, y1, theta1 go?",
                "グローバル座標に直した移動量だけが返っています。出発点の x1, y1, theta1 はどこで足しますか。",
            ),
        ),
        Mistake(
            position_forgotten,
            Text(
                "x1 and y1 of the start are missing: the turned displacement is added to the old position.",
                "出発点の x1, y1 が足されていません。回転した移動量は元の位置に足します。",
            ),
        ),
        Mistake(
            displacement_subtracted,
            Text(
                "The displacement is subtracted, so the sensor moves the opposite way. A positive u is a step forward.",
                "移動量を引いているため、反対向きに動いています。u が正なら前進です。",
            ),
        ),
        Mistake(
            start_turned_too,
            Text(
                "The start x1, y1 is turned as well. It is in global coordinates already; only the displacement is in the "
                "sensor's: mind the brackets.",
                "出発点の x1, y1 まで回転しています。出発点はもともとグローバル座標です。"
                "回転が必要なのは移動量だけですから、かっこの位置を見直しましょう。",
            ),
        ),
        Mistake(
            start_turned_instead,
            Text(
                "The start is turned and the displacement is not. It should be the other way round: which of the two is in "
                "the sensor's axes?",
                "出発点の方を回転し、移動量はそのまま足しています。センサ座標で表されているのはどちらでしょうか。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded. A formula is to be exact, and symbols cannot be rounded at all: round only for display.",
                "結果が丸められています。式は厳密でなければなりませんし、記号は丸めることができません。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            yaw_left_out,
            Text(
                "Only x2 and y2 come back. A pose is (x, y, theta): return all three.",
                "x2 と y2 だけが返っています。姿勢は (x, y, theta) の 3 つ組です。3 つとも返しましょう。",
            ),
        ),
    ),
)
