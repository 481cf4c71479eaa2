"""pose_step(pose, distance, dtheta): question 1 of the slides, overview 1-2. The heading before the step moves the robot."""

import math

import numpy as np

from autograder.draws import heading, magnitudes, pose, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(pose, distance, dtheta):
    """Return (x + D cos theta, y + D sin theta, theta + dtheta)."""
    x, y, theta = pose
    return x + distance * math.cos(theta), y + distance * math.sin(theta), theta + dtheta


def cases(rng):
    """Draw steps of every kind; turns are large enough to tell the rules apart, positions keep clear of zero."""

    def step(sign, turn_sign=0.0):
        def draw():
            turn = abs(magnitudes(rng, 0.2, 0.9)) * turn_sign if turn_sign else magnitudes(rng, 0.2, 0.9)
            return pose(rng), sign * rng.uniform(0.3, 1.5), turn

        return until(draw, clear_of_zero)

    def far_turned():
        start = pose(rng)
        start[2] += magnitudes(rng, 3, 5) // 1 * 2 * np.pi
        return start, magnitudes(rng, 0.3, 1.5), magnitudes(rng, 0.2, 0.9)

    def across_pi():
        side = rng.choice([-1.0, 1.0])
        start = pose(rng)
        start[2] = side * (np.pi - rng.uniform(0.1, 0.4))
        return start, magnitudes(rng, 0.3, 1.5), side * rng.uniform(0.5, 0.9)

    whole = until(
        lambda: (rng.integers(1, 5, 3) * rng.choice([-1, 1], 3), int(rng.integers(1, 4)), int(rng.choice([-2, -1, 1, 2]))),
        clear_of_zero,
    )
    as_list = until(lambda: (list(map(float, pose(rng))), 1, heading(rng)), clear_of_zero)
    still = pose(rng), 0.0, magnitudes(rng, 0.2, 0.9)
    return [
        Group(Text("forward, turning left", "前進しながら左旋回"), 2, [step(1, 1) for _ in range(3)]),
        Group(Text("forward, turning right", "前進しながら右旋回"), 1, [step(1, -1) for _ in range(3)]),
        Group(Text("reversing", "後退"), 2, [step(-1) for _ in range(3)]),
        Group(Text("turning on the spot", "その場旋回"), 1, [still]),
        Group(
            Text("headings beyond one turn", "1 回転を超える方位"),
            2,
            [until(draw, clear_of_zero) for draw in (far_turned, across_pi)],
        ),
        Group(Text("lists and whole numbers", "リストや整数の入力"), 1, [whole, as_list]),
    ]


def clear_of_zero(pose, distance, dtheta):
    """Is every part of the new pose far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(pose, distance, dtheta))) > 0.3


def sin_cos_exchanged(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.sin(theta), y + distance * np.cos(theta), theta + dtheta])


def new_heading_used(pose, distance, dtheta):
    x, y, theta = pose
    theta = theta + dtheta
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta])


def heading_overwritten_before_y(pose, distance, dtheta):
    x, y, theta = pose
    x = x + distance * np.cos(theta)
    theta = theta + dtheta
    y = y + distance * np.sin(theta)
    return np.array([x, y, theta])


def midpoint_rule(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def mean_of_both_headings(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    forward, left = (np.cos(theta) + np.cos(new)) / 2, (np.sin(theta) + np.sin(new)) / 2
    return np.array([x + distance * forward, y + distance * left, new])


def exact_arc(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def heading_ignored(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance, y, theta + dtheta])


def moved_along_dtheta(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(dtheta), y + distance * np.sin(dtheta), theta + dtheta])


def degrees_in_cos(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(np.deg2rad(theta)), y + distance * np.sin(np.deg2rad(theta)), theta + dtheta])


def converted_to_degrees_for_cos(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(np.rad2deg(theta)), y + distance * np.sin(np.rad2deg(theta)), theta + dtheta])


def turn_in_degrees(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + np.rad2deg(dtheta)])


def start_forgotten(pose, distance, dtheta):
    return np.array([distance * np.cos(pose[2]), distance * np.sin(pose[2]), dtheta])


def position_forgotten(pose, distance, dtheta):
    return np.array([distance * np.cos(pose[2]), distance * np.sin(pose[2]), pose[2] + dtheta])


def yaw_replaced(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), dtheta])


def yaw_kept(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta])


def turn_subtracted(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta - dtheta])


def distance_subtracted(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x - distance * np.cos(theta), y - distance * np.sin(theta), theta + dtheta])


def y_mirrored(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y - distance * np.sin(theta), theta + dtheta])


def cos_in_both(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.cos(theta), theta + dtheta])


def sin_in_both(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.sin(theta), y + distance * np.sin(theta), theta + dtheta])


def tan_for_y(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.tan(theta), theta + dtheta])


def distance_made_positive(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + abs(distance) * np.cos(theta), y + abs(distance) * np.sin(theta), theta + dtheta])


def turn_made_positive(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + abs(dtheta)])


def yaw_wrapped(pose, distance, dtheta):
    x, y, theta = pose
    wrapped = (theta + dtheta + np.pi) % (2 * np.pi) - np.pi
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), wrapped])


def yaw_wrapped_to_positive(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), (theta + dtheta) % (2 * np.pi)])


def whole_numbers_cut_off(pose, distance, dtheta):
    moved = np.array(pose)
    moved[0] = pose[0] + distance * np.cos(pose[2])
    moved[1] = pose[1] + distance * np.sin(pose[2])
    moved[2] = pose[2] + dtheta
    return moved


def rounded(pose, distance, dtheta):
    x, y, theta = pose
    return np.round([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta], 3)


def yaw_left_out(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta)])


EXERCISE = Exercise(
    name="pose_step",
    notebook="odometry/pose_update",
    points=5,
    parameters=("pose", "distance", "dtheta"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (np.array([1.0, 2.0, np.pi / 6]), 0.5, 0.1),
        (np.array([0.0, 0.0, np.pi / 2]), -1.0, -0.3),
    ),
    mistakes=(
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged: the robot moves along y when its heading is 0. A heading of 0 looks along +x, so which of "
                "the two must be 1 there? (The slides on dead reckoning have the same exchange in their axes.)",
                "sin と cos が入れ替わっています。方位 0 のときにロボットが y 方向へ進んでしまいます。方位 0 は +x の向きですから、"
                "そのとき 1 になるべきなのはどちらでしょうか。(デッドレコニングのスライドの式にも同じ入れ替わりがあります。)",
            ),
        ),
        Mistake(
            new_heading_used,
            Text(
                "The heading was updated before the robot was moved, so the step goes along theta_2. In overview 2 the heading before the "
                "step, theta_1, moves the robot: compute x and y first, or keep the old heading under its own name.",
                "移動の前に方位を更新しているため、theta_2 の向きに進んでいます。概要 #2 の式では、動く前の方位 theta_1 の向きに進みます。"
                "x と y を先に計算するか、古い方位を別の名前で取っておきましょう。",
            ),
        ),
        Mistake(
            heading_overwritten_before_y,
            Text(
                "x moves along the old heading but y along the new one: the heading is overwritten between the two lines. "
                "Update theta last.",
                "x は古い方位、y は新しい方位で計算されています。2 つの行の間で theta が上書きされています。theta の更新は最後にしましょう。",
            ),
        ),
        Mistake(
            midpoint_rule,
            Text(
                "This moves the robot along theta + dtheta/2. That is the midpoint rule, a better one, and an exercise of its own later; "
                "here the formula of overview 2 with the heading before the step is asked for.",
                "theta + dtheta/2 の向きに進んでいます。これは中点則という、より精度のよい規則で、あとの課題で扱います。"
                "ここでは概要 #2 のとおり、動く前の方位を使ってください。",
            ),
        ),
        Mistake(
            mean_of_both_headings,
            Text(
                "This averages cos and sin of the headings before and after the step. Overview 2 asks for the heading before the step alone.",
                "動く前と後の方位で cos, sin を平均しています。概要 #2 の式で使うのは、動く前の方位だけです。",
            ),
        ),
        Mistake(
            exact_arc,
            Text(
                "This is the exact circular arc, an exercise of its own later. Here the straight step of overview 2 is asked for: "
                "D along the heading before the step.",
                "これは円弧の厳密な式で、あとの課題で扱います。ここでは概要 #2 のとおり、動く前の方位に D だけまっすぐ進む式を書いてください。",
            ),
        ),
        Mistake(
            heading_ignored,
            Text(
                "The robot always moves along x, whatever its heading. D points along the robot; its parts along x and y follow from theta.",
                "方位に関係なく x 方向へ進んでいます。D はロボットの向きに測った距離です。x 成分と y 成分は theta から求まります。",
            ),
        ),
        Mistake(
            moved_along_dtheta,
            Text(
                "The step goes along dtheta, the change of heading. The robot moves along the heading itself.",
                "方位の変化量 dtheta の向きに進んでいます。ロボットが進むのは方位 theta そのものの向きです。",
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
            turn_in_degrees,
            Text(
                "dtheta is added in degrees to a heading in rad. Both are rad: add them as they are.",
                "rad の方位に、度に変換した dtheta を足しています。どちらも rad ですから、そのまま足しましょう。",
            ),
        ),
        Mistake(
            start_forgotten,
            Text(
                "This is the motion alone. The new pose is the old pose plus the motion: where did x, y and theta of the start go?",
                "これは移動量だけです。新しい姿勢は「元の姿勢 + 移動量」です。出発点の x, y, theta はどこで足しますか。",
            ),
        ),
        Mistake(
            position_forgotten,
            Text(
                "The heading is right, but x and y of the start are missing: the step is added to the old position.",
                "方位は合っていますが、出発点の x, y が足されていません。移動量は元の位置に足します。",
            ),
        ),
        Mistake(
            yaw_replaced,
            Text(
                "The new heading is dtheta alone. dtheta is the change: it is added to the old heading.",
                "新しい方位が dtheta そのものになっています。dtheta は変化量ですから、元の方位に足します。",
            ),
        ),
        Mistake(
            yaw_kept,
            Text(
                "x and y are right, but the heading stays as it was. The third line of overview 2 is missing.",
                "x, y は合っていますが、方位が元のままです。概要 #2 の 3 行目の式が抜けています。",
            ),
        ),
        Mistake(
            turn_subtracted,
            Text(
                "dtheta is subtracted. Its sign already says to which side the robot turns: add it.",
                "dtheta を引いています。回る向きは dtheta の符号が表しているので、足すだけです。",
            ),
        ),
        Mistake(
            distance_subtracted,
            Text(
                "The robot moves backwards: the step is subtracted from x and y. A positive D is a step forward.",
                "ロボットが後ろへ進んでいます。x, y から移動量を引いています。D が正なら前進です。",
            ),
        ),
        Mistake(
            y_mirrored,
            Text(
                "y has the wrong sign in its step: the path is mirrored. With a heading of 90 deg (pi/2), which way does y go?",
                "y の移動量の符号が逆で、経路が鏡映しになっています。方位が π/2 のとき、y は増えますか、減りますか。",
            ),
        ),
        Mistake(
            cos_in_both,
            Text(
                "cos is used for x and for y. Along the heading pi/2 the robot must move in y only.",
                "x にも y にも cos を使っています。方位 π/2 のとき、ロボットは y 方向だけに動くはずです。",
            ),
        ),
        Mistake(
            sin_in_both,
            Text(
                "sin is used for x and for y. Along the heading 0 the robot must move in x only.",
                "x にも y にも sin を使っています。方位 0 のとき、ロボットは x 方向だけに動くはずです。",
            ),
        ),
        Mistake(
            tan_for_y,
            Text(
                "y uses tan. D is the hypotenuse of the triangle; its side along y is D times which function of theta?",
                "y に tan を使っています。D は直角三角形の斜辺です。y 方向の辺は D に theta の何を掛けたものでしょうか。",
            ),
        ),
        Mistake(
            distance_made_positive,
            Text(
                "A robot that reverses is drawn driving forward: the sign of the distance is lost. A negative D is a step backwards.",
                "後退しているのに前進として計算されています。距離の符号が失われています。D が負なら後ろへ進みます。",
            ),
        ),
        Mistake(
            turn_made_positive,
            Text(
                "Every turn becomes a turn to the left: the sign of dtheta is lost.",
                "どちらに回っても左旋回になっています。dtheta の符号が失われています。",
            ),
        ),
        Mistake(
            yaw_wrapped,
            Text(
                "The heading is wrapped to one turn. Here it goes on counting beyond pi: wrap only for display, or sums and "
                "differences of headings will jump.",
                "方位が 1 回転の範囲に折り返されています。ここでは π を超えてもそのまま数え続けます。"
                "折り返すのは表示のときだけにしないと、和や差をとったときに値が飛びます。",
            ),
        ),
        Mistake(
            yaw_wrapped_to_positive,
            Text(
                "The heading is wrapped to 0..2 pi. Here it goes on counting beyond one turn, and may be negative: no modulo.",
                "方位が 0〜2π に折り返されています。ここでは 1 回転を超えても負になってもそのまま数え続けます。剰余はとりません。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With a pose of whole numbers the decimals are cut off: a copy of an integer array holds integers only. "
                "Make it np.array(pose, dtype=float).",
                "姿勢が整数で渡されると、小数部分が切り捨てられます。整数の配列をコピーすると整数しか入りません。"
                "np.array(pose, dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded. Thousands of steps follow one another, and so do their rounding errors: round only for display.",
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
