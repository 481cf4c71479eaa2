"""pose_step_midpoint(pose, distance, dtheta): the step along the heading half-way through the turn, theta + dtheta/2."""

import cmath

import numpy as np

from autograder.draws import magnitudes, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(pose, distance, dtheta):
    """Return the pose after a straight step along theta + dtheta/2."""
    x, y, theta = pose
    end = complex(x, y) + cmath.rect(1, theta) * cmath.rect(distance, dtheta / 2)
    return end.real, end.imag, theta + dtheta


def cases(rng):
    """Draw steps whose turns are large enough to tell the rules apart.

    Headings are between 0 and pi, before and after the step, where no group is about them.
    """

    def start(turns=0):
        heading = (rng.integers(0, 4) + rng.uniform(0.26, 0.74)) * np.pi / 4
        return np.array([magnitudes(rng, 0.5, 3.0), magnitudes(rng, 0.5, 3.0), heading + 2 * np.pi * turns])

    def step(forward, left, turns=0):
        def draw():
            return start(turns), forward * rng.uniform(0.6, 1.6), left * rng.uniform(0.35, 0.9)

        return until(draw, lambda *step: clear_of_zero(*step) and 0.1 < step[0][2] + step[2] - 2 * np.pi * turns < 3.0)

    def across_pi(side):
        pose = start()
        pose[2] = side * (np.pi - rng.uniform(0.1, 0.3))
        return pose, -side * rng.uniform(0.6, 1.6), side * rng.uniform(0.5, 0.9)

    def wide_turn(left):
        return start(), -left * rng.uniform(0.6, 1.6), left * rng.uniform(3.6, 5.5)

    def whole():
        return np.array([rng.choice([-4, -3, 3, 4]), rng.choice([-4, -3, 3, 4]), 3]), rng.choice([-3, -2]), rng.choice([-2, -1])

    across = [until(lambda side=side: across_pi(side), clear_of_zero) for side in (-1, 1)]
    wide = [until(lambda side=side: wide_turn(side), clear_of_zero) for side in (-1, 1)]
    pose, distance, dtheta = step(1, 1)
    return [
        Group(Text("forward, turning left", "前進しながら左旋回"), 3, [step(1, 1), step(1, 1), step(1, 0.3)]),
        Group(Text("forward, turning right", "前進しながら右旋回"), 1, [step(1, -1), step(1, -0.01)]),
        Group(Text("reversing", "後退"), 2, [step(-1, -1), step(-1, 1)]),
        Group(Text("turning on the spot", "その場旋回"), 1, [step(0, -1)]),
        Group(Text("headings beyond half a turn", "半回転を超える方位"), 1, [step(1, 1, rng.choice([-2, -1, 1, 2])), *across]),
        Group(Text("turns by more than half a turn", "半回転を超える旋回"), 1, wide),
        Group(
            Text("lists and whole numbers", "リストや整数の入力"),
            1,
            [until(whole, clear_of_zero), (pose.tolist(), distance, dtheta)],
        ),
    ]


def clear_of_zero(pose, distance, dtheta):
    """Is every part of the new pose far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(pose, distance, dtheta))) > 0.3


def yaw_kept(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta])


def yaw_replaced(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), dtheta])


def middle_heading_returned(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), middle])


def turn_added_to_the_middle(pose, distance, dtheta):
    x, y, theta = pose
    theta = theta + dtheta / 2
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])


def turn_subtracted_at_the_end(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta - dtheta])


def turn_in_degrees(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + np.rad2deg(dtheta)])


def turn_wrapped(pose, distance, dtheta):
    x, y, theta = pose
    dtheta = (dtheta + np.pi) % (2 * np.pi) - np.pi
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def yaw_wrapped(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    wrapped = (theta + dtheta + np.pi) % (2 * np.pi) - np.pi
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), wrapped])


def yaw_wrapped_to_positive(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), (theta + dtheta) % (2 * np.pi)])


def old_heading_used(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])


def new_heading_used(pose, distance, dtheta):
    x, y, theta = pose
    theta = theta + dtheta
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta])


def middle_beyond_the_new_heading(pose, distance, dtheta):
    x, y, theta = pose
    theta = theta + dtheta
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta])


def middle_on_the_other_side(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta - dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def everything_halved(pose, distance, dtheta):
    x, y, theta = pose
    middle = (theta + dtheta) / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def heading_halved(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta / 2 + dtheta
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def turn_doubled(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + 2 * dtheta
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def quarter_of_the_turn(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 4
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def half_the_turn_alone(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(dtheta / 2), y + distance * np.sin(dtheta / 2), theta + dtheta])


def whole_division(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta // 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def half_a_radian_added(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + 1 / 2
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


def two_half_steps(pose, distance, dtheta):
    x, y, theta = pose
    for _ in range(2):
        x, y = x + distance / 2 * np.cos(theta), y + distance / 2 * np.sin(theta)
        theta = theta + dtheta / 2
    return np.array([x, y, theta])


def distance_halved(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance / 2 * np.cos(middle), y + distance / 2 * np.sin(middle), theta + dtheta])


def half_the_way_along_the_old_heading(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance / 2 * np.cos(theta), y + distance / 2 * np.sin(theta), theta + dtheta])


def middle_heading_for_x_only(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta + dtheta / 2), y + distance * np.sin(theta), theta + dtheta])


def middle_heading_for_y_only(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta + dtheta / 2), theta + dtheta])


def sin_cos_exchanged(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.sin(middle), y + distance * np.cos(middle), theta + dtheta])


def cos_in_both(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.cos(middle), theta + dtheta])


def sin_in_both(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.sin(middle), y + distance * np.sin(middle), theta + dtheta])


def y_mirrored(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y - distance * np.sin(middle), theta + dtheta])


def degrees_in_cos(pose, distance, dtheta):
    x, y, theta = pose
    middle = np.deg2rad(theta + dtheta / 2)
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def converted_to_degrees_for_cos(pose, distance, dtheta):
    x, y, theta = pose
    middle = np.rad2deg(theta + dtheta / 2)
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def start_forgotten(pose, distance, dtheta):
    middle = pose[2] + dtheta / 2
    return np.array([distance * np.cos(middle), distance * np.sin(middle), dtheta])


def position_forgotten(pose, distance, dtheta):
    middle = pose[2] + dtheta / 2
    return np.array([distance * np.cos(middle), distance * np.sin(middle), pose[2] + dtheta])


def distance_subtracted(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x - distance * np.cos(middle), y - distance * np.sin(middle), theta + dtheta])


def clockwise(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta - dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta - dtheta])


def stands_still_when_reversing(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    distance = max(distance, 0)
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def distance_made_positive(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + abs(distance) * np.cos(middle), y + abs(distance) * np.sin(middle), theta + dtheta])


def turn_made_positive(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + abs(dtheta) / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + abs(dtheta)])


def middle_by_direction(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    middle = np.arctan2(np.sin(theta) + np.sin(new), np.cos(theta) + np.cos(new))
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), new])


def middle_of_wrapped_headings(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    middle = ((theta + np.pi) % (2 * np.pi) + (new + np.pi) % (2 * np.pi)) / 2 - np.pi
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), new])


def whole_numbers_cut_off(pose, distance, dtheta):
    moved = np.array(pose)
    middle = pose[2] + dtheta / 2
    moved[0] = pose[0] + distance * np.cos(middle)
    moved[1] = pose[1] + distance * np.sin(middle)
    moved[2] = pose[2] + dtheta
    return moved


def rounded(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.round([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta], 3)


def yaw_left_out(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle)])


EXERCISE = Exercise(
    name="pose_step_midpoint",
    notebook="odometry/pose_update",
    points=5,
    parameters=("pose", "distance", "dtheta"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (np.array([1.0, 2.0, np.pi / 6]), 0.5, 0.2),
        (np.array([0.0, 0.0, np.pi / 2]), -1.0, -0.6),
    ),
    mistakes=(
        Mistake(
            yaw_kept,
            Text(
                "The heading stays as it was. After the step the robot has made its whole turn.",
                "方位が元のままです。1 歩のあと、ロボットは旋回を終えています。",
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
            middle_heading_returned,
            Text(
                "The heading that comes back is the one half-way. It serves to move the robot only; at the end of the step "
                "the whole turn is made.",
                "返している方位が途中(半分だけ回ったところ)のものです。"
                "これは移動の計算に使うだけで、1 歩の終わりには旋回をすべて終えています。",
            ),
        ),
        Mistake(
            turn_added_to_the_middle,
            Text(
                "The heading has turned too far, by half of dtheta: dtheta was added to the heading half-way. Keep the two "
                "headings under different names.",
                "方位が dtheta の半分だけ余計に回っています。途中の方位に dtheta を足しています。"
                "2 つの方位には別の名前を付けましょう。",
            ),
        ),
        Mistake(
            turn_subtracted_at_the_end,
            Text(
                "dtheta is subtracted from the heading. Its sign already says to which side the robot turns.",
                "方位から dtheta を引いています。回る向きは dtheta の符号が表しています。",
            ),
        ),
        Mistake(
            turn_in_degrees,
            Text(
                "dtheta is added in degrees to a heading in rad. Both are rad already.",
                "rad の方位に、度に変換した dtheta を足しています。どちらも初めから rad です。",
            ),
        ),
        Mistake(
            turn_wrapped,
            Text(
                "Turns by more than half a turn come out as others: dtheta is wrapped to -pi..pi first. Use it as it comes.",
                "半回転を超える旋回が別の旋回になっています。先に dtheta を -π〜π に折り返しています。"
                "dtheta はそのまま使いましょう。",
            ),
        ),
        Mistake(
            yaw_wrapped,
            Text(
                "The heading is wrapped to -pi..pi. Here it goes on counting: wrap only for display, or the middle of two "
                "headings will jump.",
                "方位が -π〜π に折り返されています。ここではそのまま数え続けます。"
                "折り返すのは表示のときだけにしないと、2 つの方位の真ん中が飛んでしまいます。",
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
            old_heading_used,
            Text(
                "The robot moves along the heading before the step. That is pose_step, the exercise before; here the heading "
                "half-way through the turn is to be used.",
                "動く前の方位の向きに進んでいます。それは前の課題の pose_step です。"
                "ここでは、旋回の途中(ちょうど半分)の方位を使います。",
            ),
        ),
        Mistake(
            new_heading_used,
            Text(
                "The robot moves along the heading after the step. The midpoint rule uses the one half-way between before and "
                "after.",
                "動いた後の方位の向きに進んでいます。中点則で使うのは、前と後のちょうど真ん中の方位です。",
            ),
        ),
        Mistake(
            middle_beyond_the_new_heading,
            Text(
                "The heading used is half a dtheta beyond the new one: theta was updated first, and the half added to it. "
                "Count from the old heading.",
                "新しい方位より、さらに dtheta の半分だけ先の向きに進んでいます。先に theta を更新してから半分を足しています。"
                "元の方位から数えましょう。",
            ),
        ),
        Mistake(
            middle_on_the_other_side,
            Text(
                "The half turn is taken to the wrong side, away from the new heading. The middle lies between the old heading "
                "and the new one.",
                "半分の旋回が逆向きになっています。真ん中の方位は、元の方位と新しい方位の間にあるはずです。",
            ),
        ),
        Mistake(
            everything_halved,
            Text(
                "The heading is halved together with dtheta. Mind the brackets: only the turn is to be cut in half.",
                "dtheta と一緒に、方位まで半分になっています。かっこの位置を見直しましょう。半分にするのは旋回量だけです。",
            ),
        ),
        Mistake(
            heading_halved,
            Text(
                "The old heading is halved instead of the turn. Which of the two is half-way made when the robot is half-way?",
                "旋回量ではなく、元の方位を半分にしています。1 歩の途中で「半分だけ」になっているのはどちらでしょうか。",
            ),
        ),
        Mistake(
            turn_doubled,
            Text(
                "dtheta is doubled where it should be cut in half.",
                "dtheta を半分にするところで、2 倍にしています。",
            ),
        ),
        Mistake(
            quarter_of_the_turn,
            Text(
                "Only a quarter of the turn is used: dtheta is halved twice.",
                "旋回量の 1/4 しか使われていません。dtheta を 2 回半分にしています。",
            ),
        ),
        Mistake(
            half_the_turn_alone,
            Text(
                "The step goes along dtheta/2 alone. The robot does not start with heading 0: where does theta come in?",
                "dtheta/2 だけの向きに進んでいます。ロボットの最初の方位は 0 とは限りません。theta はどこに入りますか。",
            ),
        ),
        Mistake(
            whole_division,
            Text(
                "dtheta // 2 drops the decimals and rounds down, so that a small turn becomes 0 or -1. Divide with a single /.",
                "dtheta // 2 では小数部分が切り捨てられ、小さな旋回が 0 や -1 になってしまいます。"
                "割り算は / を 1 つにしましょう。",
            ),
        ),
        Mistake(
            half_a_radian_added,
            Text(
                "Always half a radian is added to the heading, whatever dtheta is. Half of the turn is meant.",
                "dtheta に関係なく、いつも 0.5 rad を方位に足しています。足すのは旋回量の半分です。",
            ),
        ),
        Mistake(
            mean_of_both_headings,
            Text(
                "cos and sin of the headings before and after are averaged. That is another rule; the midpoint rule averages "
                "the headings first and takes cos and sin once.",
                "動く前と後の cos, sin を平均しています。これは別の規則です。"
                "中点則では、先に方位の真ん中を求め、cos と sin は 1 回だけ計算します。",
            ),
        ),
        Mistake(
            exact_arc,
            Text(
                "This is the exact circular arc, the next exercise. The midpoint rule goes straight on by the whole distance.",
                "これは円弧の厳密な式で、次の課題です。中点則では、距離をそのまま使ってまっすぐ進みます。",
            ),
        ),
        Mistake(
            two_half_steps,
            Text(
                "The step is split into two half steps, one along the old heading, one along the heading half-way. The "
                "midpoint rule makes one whole step along the latter.",
                "元の方位に半分、途中の方位に半分と、2 回に分けて進んでいます。中点則は、途中の方位の向きに 1 回で全部進みます。",
            ),
        ),
        Mistake(
            distance_halved,
            Text(
                "The distance is halved too. Half of the turn is used for the direction, but the robot makes the whole way.",
                "距離まで半分になっています。半分にするのは向きを決める旋回量だけで、距離は全部進みます。",
            ),
        ),
        Mistake(
            half_the_way_along_the_old_heading,
            Text(
                "The position is the one half-way, along the old heading. In the midpoint rule it is the turn that is halved, "
                "and the robot makes the whole way.",
                "元の方位に半分だけ進んだ位置になっています。中点則で半分にするのは距離ではなく旋回量です。",
            ),
        ),
        Mistake(
            middle_heading_for_x_only,
            Text(
                "x uses the heading half-way, but y still the old one. Both need the same heading.",
                "x は途中の方位、y は元の方位で計算されています。どちらも同じ方位を使います。",
            ),
        ),
        Mistake(
            middle_heading_for_y_only,
            Text(
                "y uses the heading half-way, but x still the old one. Both need the same heading.",
                "y は途中の方位、x は元の方位で計算されています。どちらも同じ方位を使います。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged. A heading of 0 looks along +x: which of the two must be 1 there?",
                "sin と cos が入れ替わっています。方位 0 は +x の向きです。そのとき 1 になるべきなのはどちらでしょうか。",
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
            y_mirrored,
            Text(
                "y has the wrong sign in its step: the path is mirrored. With a heading of 90 deg (pi/2), which way does y go?",
                "y の移動量の符号が逆で、経路が鏡映しになっています。方位が π/2 のとき、y は増えますか、減りますか。",
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
            start_forgotten,
            Text(
                "This is the motion alone. The new pose is the old pose plus the motion: where did x, y and theta of the "
                "start go?",
                "これは移動量だけです。新しい姿勢は「元の姿勢 + 移動量」です。出発点の x, y, theta はどこで足しますか。",
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
            distance_subtracted,
            Text(
                "The robot moves backwards: the step is subtracted. A positive distance is a step forward.",
                "ロボットが後ろへ進んでいます。移動量を引いています。distance が正なら前進です。",
            ),
        ),
        Mistake(
            clockwise,
            Text(
                "dtheta is subtracted everywhere, so that the robot turns to the wrong side. A positive dtheta makes the "
                "heading grow.",
                "どこでも dtheta を引いているため、逆向きに回っています。dtheta が正なら方位は増えます。",
            ),
        ),
        Mistake(
            stands_still_when_reversing,
            Text(
                "A robot that reverses stands still: negative distances are replaced by 0. A negative distance is a step "
                "backwards.",
                "後退のとき止まっています。負の距離が 0 に置き換えられています。distance が負なら後ろへ進みます。",
            ),
        ),
        Mistake(
            distance_made_positive,
            Text(
                "A robot that reverses is drawn driving forward: the sign of the distance is lost.",
                "後退しているのに前進として計算されています。距離の符号が失われています。",
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
            middle_by_direction,
            Text(
                "For turns by more than half a turn the robot moves the opposite way. The turn was wrapped, or the middle of "
                "two directions was taken (atan2): that one lies on the short way round. Take the headings as numbers.",
                "半回転を超える旋回で、反対向きに進んでいます。旋回量を折り返したか、"
                "atan2 などで「向きの真ん中」を求めていませんか。それは近い側の真ん中です。"
                "方位はそのまま数として扱いましょう。",
            ),
        ),
        Mistake(
            middle_of_wrapped_headings,
            Text(
                "When the turn passes pi, the robot moves the opposite way: the headings were wrapped before their middle was "
                "taken. The middle of 179 and -179 deg would be 0.",
                "旋回が π をまたぐと反対向きに進んでいます。方位を折り返してから平均しています。"
                "これでは 179° と -179° の真ん中が 0° になってしまいます。",
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
