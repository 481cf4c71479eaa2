"""express_in(pose, frame): both given in one parent, the pose as seen from the frame. Notes 001, section 2."""

import cmath

import numpy as np

from autograder.draws import pose, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import Tolerance


def reference(pose, frame):
    """Return the arrow from the frame's origin to the pose, measured along the frame's axes, and the angle between the two."""
    arrow = (complex(pose[0], pose[1]) - complex(frame[0], frame[1])) / cmath.rect(1.0, frame[2])
    return arrow.real, arrow.imag, pose[2] - frame[2]


def cases(rng):
    """Draw pairs of poses; the main groups hold headings in the third and the second quadrant, where arctan, arcsin or arccos fail."""

    def pair(side, turns=0, backwards=0):
        def draw():
            seen, frame = pose(rng), pose(rng)
            frame[2] = side * (abs(frame[2]) + 2 * np.pi * turns)
            if backwards:
                seen[2] = side * np.pi + backwards * rng.uniform(0.3, 1.2) + frame[2]
            return seen, frame

        return until(draw, clear_of_zero)

    def turned(side):
        return [pair(side, backwards=1), pair(side, backwards=-1), pair(side)]

    def whole():
        return rng.integers(1, 6, 3) * rng.choice([-1, 1], 3), rng.integers(1, 6, 3) * rng.choice([-1, 1], 3)

    far = [pair(side, turns=1, backwards=1) for side in rng.permutation([1, -1])]
    listed = until(lambda: (pose(rng).tolist(), pose(rng).tolist()), clear_of_zero)
    observer = until(lambda: (np.zeros(3), pose(rng)), clear_of_zero)
    return [
        Group(Text("frames turned to the left", "左に回った座標系"), 3, turned(1)),
        Group(Text("frames turned to the right", "右に回った座標系"), 3, turned(-1)),
        Group(Text("headings beyond one turn", "1 回転を超える方位"), 2, far),
        Group(Text("lists and whole numbers", "リストや整数の入力"), 1, [until(whole, clear_of_zero), listed]),
        Group(
            Text("one of the two is (0, 0, 0)", "一方が (0, 0, 0) のとき"),
            1,
            [(pose(rng), np.zeros(3)), observer],
        ),
    ]


def clear_of_zero(pose, frame):
    """Are x and y of the result far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(pose, frame)[:2])) > 0.5


def subtracted_component_by_component(pose, frame):
    return np.asarray(pose) - np.asarray(frame)


def minus_sign_on_lists(pose, frame):
    return pose - frame


def rotated_the_wrong_way(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx - s * dy, s * dx + c * dy, pose[2] - frame[2]])


def pose_and_frame_exchanged(pose, frame):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    dx, dy = frame[0] - pose[0], frame[1] - pose[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, frame[2] - pose[2]])


def composed_instead(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([frame[0] + c * pose[0] - s * pose[1], frame[1] + s * pose[0] + c * pose[1], frame[2] + pose[2]])


def composed_in_the_other_order(pose, frame):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([pose[0] + c * frame[0] - s * frame[1], pose[1] + s * frame[0] + c * frame[1], frame[2] + pose[2]])


def inverse_on_the_right(pose, frame):
    turn = pose[2] - frame[2]
    c, s = np.cos(turn), np.sin(turn)
    return np.array([pose[0] - c * frame[0] + s * frame[1], pose[1] - s * frame[0] - c * frame[1], turn])


def pose_inverted_too(pose, frame):
    turn = -pose[2] - frame[2]
    dx, dy = -pose[0], -pose[1]
    c, s = np.cos(turn), np.sin(turn)
    x, y = c * dx - s * dy, s * dx + c * dy
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([x - c * frame[0] - s * frame[1], y + s * frame[0] - c * frame[1], turn])


def subtracted_after_the_rotation(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([c * pose[0] + s * pose[1] - frame[0], c * pose[1] - s * pose[0] - frame[1], pose[2] - frame[2]])


def only_the_frame_rotated(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([pose[0] - c * frame[0] - s * frame[1], pose[1] + s * frame[0] - c * frame[1], pose[2] - frame[2]])


def origin_not_subtracted(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([c * pose[0] + s * pose[1], c * pose[1] - s * pose[0], pose[2] - frame[2]])


def origin_added(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] + frame[0], pose[1] + frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def arrow_reversed(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = frame[0] - pose[0], frame[1] - pose[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def rotated_by_the_heading_of_the_pose(pose, frame):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def rotated_by_the_difference(pose, frame):
    turn = pose[2] - frame[2]
    c, s = np.cos(turn), np.sin(turn)
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx - s * dy, s * dx + c * dy, turn])


def rotated_back_by_the_difference(pose, frame):
    turn = pose[2] - frame[2]
    c, s = np.cos(turn), np.sin(turn)
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, turn])


def rotated_by_positive_angle_only(pose, frame):
    c, s = np.cos(abs(frame[2])), np.sin(abs(frame[2]))
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def distances_made_positive(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = abs(pose[0] - frame[0]), abs(pose[1] - frame[1])
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def sin_cos_exchanged(pose, frame):
    c, s = np.sin(frame[2]), np.cos(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def no_minus_sign(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, s * dx + c * dy, pose[2] - frame[2]])


def minus_sign_twice(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx - s * dy, c * dy - s * dx, pose[2] - frame[2]])


def mirrored(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, s * dx - c * dy, pose[2] - frame[2]])


def y_from_the_new_x(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    x, y = pose[0] - frame[0], pose[1] - frame[1]
    x = c * x + s * y
    y = c * y - s * x
    return np.array([x, y, pose[2] - frame[2]])


def distance_and_bearing(pose, frame):
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([np.hypot(dx, dy), np.arctan2(dy, dx) - frame[2], pose[2] - frame[2]])


def heading_of_the_pose(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2]])


def heading_of_the_frame(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, frame[2]])


def headings_added(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] + frame[2]])


def heading_subtracted_the_other_way(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, frame[2] - pose[2]])


def heading_towards_the_pose(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, np.arctan2(dy, dx) - frame[2]])


def heading_by_arctan(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, np.arctan(np.tan(pose[2] - frame[2]))])


def heading_by_arccos(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, np.arccos(np.cos(pose[2] - frame[2]))])


def heading_by_arcsin(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, np.arcsin(np.sin(pose[2] - frame[2]))])


def heading_modulo_pi(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, (pose[2] - frame[2]) % np.pi])


def heading_made_positive(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, abs(pose[2] - frame[2])])


def heading_in_degrees(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, np.rad2deg(pose[2] - frame[2])])


def degrees_in_cos(pose, frame):
    c, s = np.cos(np.deg2rad(frame[2])), np.sin(np.deg2rad(frame[2]))
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def converted_to_degrees_for_cos(pose, frame):
    c, s = np.cos(np.rad2deg(frame[2])), np.sin(np.rad2deg(frame[2]))
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]])


def whole_numbers_cut_off(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    seen = np.array(pose)
    seen[0] = c * dx + s * dy
    seen[1] = c * dy - s * dx
    seen[2] = pose[2] - frame[2]
    return seen


def rounded(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.round([c * dx + s * dy, c * dy - s * dx, pose[2] - frame[2]], 3)


def matrix_returned(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    inverse = np.linalg.inv(np.array([[c, -s, frame[0]], [s, c, frame[1]], [0, 0, 1]]))
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return inverse @ np.array([[c, -s, pose[0]], [s, c, pose[1]], [0, 0, 1]])


def column_of_the_matrix_returned(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx, 1.0])


def column_returned(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([[c * dx + s * dy], [c * dy - s * dx], [pose[2] - frame[2]]])


def heading_left_out(pose, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    dx, dy = pose[0] - frame[0], pose[1] - frame[1]
    return np.array([c * dx + s * dy, c * dy - s * dx])


EXERCISE = Exercise(
    name="express_in",
    notebook="odometry/frames",
    points=5,
    parameters=("pose", "frame"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=Tolerance(axis=-1, angles=(2,)),
    examples=(
        (np.array([1.0, 5.0, np.pi / 2]), np.array([1.0, 2.0, np.pi / 2])),
        (np.array([3.0, 1.0, -np.pi / 4]), np.array([1.0, 2.0, np.pi / 6])),
    ),
    mistakes=(
        Mistake(
            subtracted_component_by_component,
            Text(
                "The two poses are subtracted number by number. That is what an observer in the frame sees only if the frame is not turned: "
                "the arrow between the two must be measured along the frame's own axes.",
                "2 つの姿勢を成分ごとに引いています。それで正しいのは座標系 frame が回転していないときだけです。"
                "2 点を結ぶベクトルは、frame 自身の軸に沿って測る必要があります。",
            ),
        ),
        Mistake(
            minus_sign_on_lists,
            Text(
                "pose - frame subtracts arrays number by number and fails for lists. The difference is also measured along the parent's axes: "
                "it must be turned into the frame's own.",
                "pose - frame としています。配列なら成分ごとの差になり、リストではエラーになります。"
                "しかも差は親の軸に沿った値のままです。frame 自身の軸へ回転させる必要があります。",
            ),
        ),
        Mistake(
            rotated_the_wrong_way,
            Text(
                "The difference is right, but it is turned the wrong way: from the frame out to the parent. Put the frame at heading pi/2 and the pose "
                "one metre from it along the parent's y: it lies straight ahead, on the frame's x.",
                "差は合っていますが、回転の向きが逆(frame から親への向き)です。frame の方位が π/2 で、pose が親の y 方向に 1 m 離れていれば、"
                "frame からは真正面、つまり frame の x 軸上に見えるはずです。",
            ),
        ),
        Mistake(
            pose_and_frame_exchanged,
            Text(
                "pose and frame are exchanged: this is the frame as seen from the pose. Who looks, and who is looked at?",
                "pose と frame が逆で、pose から見た frame を計算しています。見る側と見られる側を確かめましょう。",
            ),
        ),
        Mistake(
            composed_instead,
            Text(
                "This composes the two: it takes the pose as given in the frame and leads out to the parent. Here both are given in the parent, "
                "and the way leads into the frame: it is the inverse of that.",
                "2 つを合成しています。それは frame の中で与えられた pose を親の座標系に直す計算です。"
                "ここではどちらも親の中で与えられていて、frame の中へ入る、逆向きの計算をします。",
            ),
        ),
        Mistake(
            composed_in_the_other_order,
            Text(
                "This composes the two, frame laid into pose. Here both are given in the parent, and what is asked for is the pose as seen from the frame.",
                "pose の中に frame を置く合成になっています。ここではどちらも親の中で与えられていて、求めるのは frame から見た pose です。",
            ),
        ),
        Mistake(
            inverse_on_the_right,
            Text(
                "The inverse of the frame stands on the wrong side: pose composed with the inverse of the frame. Composition is read from the observer "
                "outwards: frame to parent first, then parent to pose.",
                "frame の逆を右から合成しています。合成は見る側から順に並べます。まず frame から親へ、次に親から pose へ、の順です。",
            ),
        ),
        Mistake(
            pose_inverted_too,
            Text(
                "Both poses are inverted. Only the way from the parent into the frame runs backwards; the pose is given in the parent and stays as it is.",
                "2 つとも逆にしています。逆向きにたどるのは frame と親の間だけです。pose は親の中で与えられているので、そのまま使います。",
            ),
        ),
        Mistake(
            subtracted_after_the_rotation,
            Text(
                "The frame's origin is subtracted after the rotation (or the frame was 'inverted' by changing three signs). The origin is given in the "
                "parent's axes: it must be subtracted while the pose still is, too.",
                "回転させたあとで frame の原点を引いています(または frame の逆を、符号を変えただけで作っています)。"
                "原点は親の軸で表された値なので、pose も親の軸で表されているうちに引きます。",
            ),
        ),
        Mistake(
            only_the_frame_rotated,
            Text(
                "Only the frame's origin is turned, not the pose's x and y. Take the difference first, then turn all of it.",
                "frame の原点だけを回転させ、pose の x, y は回転させていません。先に差をとり、その全体を回転させましょう。",
            ),
        ),
        Mistake(
            origin_not_subtracted,
            Text(
                "The rotation is right, but the frame's position is not used: x and y are still counted from the parent's origin.",
                "回転は合っていますが、frame の位置が使われていません。x, y がまだ親の原点から測られています。",
            ),
        ),
        Mistake(
            origin_added,
            Text(
                "The frame's position is added to the pose's before the rotation. Seen from the frame's own origin: is the arrow to the pose a sum "
                "or a difference?",
                "回転の前に、frame の位置を pose に足しています。frame の原点から pose へ向かうベクトルは、和でしょうか、差でしょうか。",
            ),
        ),
        Mistake(
            arrow_reversed,
            Text(
                "The heading is right, but x and y point the opposite way: the difference is taken as frame minus pose. The arrow starts at the one who looks.",
                "方位は合っていますが、x, y が逆向きです。差が frame - pose になっています。ベクトルは見る側から出発します。",
            ),
        ),
        Mistake(
            rotated_by_the_heading_of_the_pose,
            Text(
                "The difference is turned by the heading of the pose. It is to be measured along the frame's axes: whose heading gives those?",
                "差を pose の方位で回転させています。測るのは frame の軸に沿ってです。それはどちらの方位で決まりますか。",
            ),
        ),
        Mistake(
            rotated_by_the_difference,
            Text(
                "The difference of the positions is turned by the difference of the headings. How the pose itself is turned does not move its position.",
                "位置の差を、方位の差で回転させています。pose 自身がどちらを向いているかは、位置には関係しません。",
            ),
        ),
        Mistake(
            rotated_back_by_the_difference,
            Text(
                "The difference of the positions is turned back by the difference of the headings. How the pose itself is turned does not move its position: "
                "the frame's heading alone counts.",
                "位置の差を、方位の差だけ逆に回転させています。pose 自身がどちらを向いているかは位置に関係しません。関係するのは frame の方位だけです。",
            ),
        ),
        Mistake(
            rotated_by_positive_angle_only,
            Text(
                "A frame turned to the right is treated as if it were turned to the left: the sign of its heading is lost in the rotation.",
                "右に回った座標系が、左に回ったものとして計算されています。回転に使う frame の方位の符号が失われています。",
            ),
        ),
        Mistake(
            distances_made_positive,
            Text(
                "The differences in x and y are made positive (abs). Their signs say whether the pose lies before or behind, left or right.",
                "x, y の差が(abs で)いつも正になっています。差の符号は、前か後ろか、左か右かを表しています。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged. For a frame of heading 0 the difference stays as it is: which of the two must be 1 there?",
                "sin と cos が入れ替わっています。frame の方位が 0 なら差はそのままです。そのとき 1 になるべきなのはどちらでしょうか。",
            ),
        ),
        Mistake(
            no_minus_sign,
            Text(
                "All four terms have a plus sign. A rotation has one minus. Put the frame at heading pi/2: what lies along the parent's +x is "
                "to the right of it.",
                "4 つの項がすべてプラスです。回転の式にはマイナスが 1 つあります。frame の方位が π/2 なら、親の +x 方向にあるものは frame の右側に見えます。",
            ),
        ),
        Mistake(
            minus_sign_twice,
            Text(
                "There is one minus sign too many: it stands before both sines. Put the frame at heading pi/2: what lies along the parent's +y is "
                "straight ahead of it.",
                "マイナスが 1 つ多く、2 つの sin の両方に付いています。frame の方位が π/2 なら、親の +y 方向にあるものは frame の正面に見えます。",
            ),
        ),
        Mistake(
            mirrored,
            Text(
                "y comes out with the opposite sign: left and right of the frame are exchanged.",
                "y の符号が逆で、frame から見た左右が入れ替わっています。",
            ),
        ),
        Mistake(
            y_from_the_new_x,
            Text(
                "x is overwritten before y is computed, so the line for y uses the new x. Keep the difference under a name of its own.",
                "y を計算する前に x を上書きしているため、y の式に新しい x が使われています。差には別の名前を付けておきましょう。",
            ),
        ),
        Mistake(
            distance_and_bearing,
            Text(
                "The first two numbers are the distance and the direction to the pose. Here x and y along the frame's axes are asked for.",
                "最初の 2 つが、pose までの距離と方向になっています。ここで求めるのは、frame の軸に沿った x と y です。",
            ),
        ),
        Mistake(
            heading_of_the_pose,
            Text(
                "x and y are right, but the heading is the one in the parent. Seen from the frame it is counted from the frame's own x axis.",
                "x, y は合っていますが、方位が親の座標系での値のままです。frame から見た方位は、frame の x 軸から測ります。",
            ),
        ),
        Mistake(
            heading_of_the_frame,
            Text(
                "x and y are right, but the heading is the frame's. How the pose is turned as seen from the frame is asked for.",
                "x, y は合っていますが、方位が frame の方位になっています。求めるのは、frame から見た pose の方位です。",
            ),
        ),
        Mistake(
            headings_added,
            Text(
                "x and y are right, but the headings are added. If pose and frame look the same way, which heading does the frame see?",
                "x, y は合っていますが、方位を足しています。pose と frame が同じ向きのとき、frame から見た方位はいくつでしょうか。",
            ),
        ),
        Mistake(
            heading_subtracted_the_other_way,
            Text(
                "x and y are right, but the difference of the headings has the wrong sign: whatever looks further to the left than the frame "
                "must have a positive heading in it.",
                "x, y は合っていますが、方位の差の符号が逆です。frame より左を向いているものは、frame から見た方位が正になるはずです。",
            ),
        ),
        Mistake(
            heading_towards_the_pose,
            Text(
                "The heading is the direction in which the pose is seen. Where something stands says nothing about where it looks: that is the "
                "third number of the pose.",
                "方位が、pose の見える方向になっています。どこにあるかと、どちらを向いているかは別のことです。向きは pose の 3 番目の数です。",
            ),
        ),
        Mistake(
            heading_by_arctan,
            Text(
                "The heading comes from arctan, which cannot tell a direction from the opposite one. Subtract the headings, or use arctan2 with both "
                "arguments.",
                "方位を arctan で求めています。arctan では、ある向きとその反対の向きを区別できません。"
                "方位どうしを引くか、引数が 2 つの arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_by_arccos,
            Text(
                "The heading comes from arccos, which is never negative, so the side is lost. Subtract the headings, or use arctan2.",
                "方位を arccos で求めています。arccos は負にならないので、左右の区別が失われます。方位どうしを引くか、arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_by_arcsin,
            Text(
                "The heading comes from arcsin, which stays within a quarter turn of 0: headings that look backwards are folded to the front. "
                "Subtract the headings, or use arctan2.",
                "方位を arcsin で求めています。arcsin は ±π/2 の範囲しか返さないので、後ろ向きの方位が前向きに折り返されます。"
                "方位どうしを引くか、arctan2 を使いましょう。",
            ),
        ),
        Mistake(
            heading_modulo_pi,
            Text(
                "The heading is taken modulo pi, half a turn: it then often looks the opposite way. A full turn is 2 pi; and here no "
                "modulo is needed at all.",
                "方位を半回転(π)で割った余りにしているため、反対を向くことがあります。1 回転は 2π です。そもそもここでは剰余をとる必要もありません。",
            ),
        ),
        Mistake(
            heading_made_positive,
            Text(
                "The sign of the heading is lost (abs): what looks to the right comes out as looking to the left.",
                "方位の符号が(abs で)失われています。右を向いているものが左向きになってしまいます。",
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
                "The frame's heading is converted as if it were in degrees. It is in rad already, and np.cos takes rad.",
                "frame の方位を度とみなして変換しています。方位はすでに rad で、np.cos も rad を受け取ります。",
            ),
        ),
        Mistake(
            converted_to_degrees_for_cos,
            Text(
                "The frame's heading is turned into degrees before cos and sin. np.cos takes rad: leave it as it is.",
                "cos, sin に渡す前に frame の方位を度に変換しています。np.cos は rad を受け取るので、そのまま渡しましょう。",
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
                "The result is rounded. Composed with the frame it no longer gives the pose back: round only for display.",
                "結果が丸められています。frame と合成しても元の pose に戻りません。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            matrix_returned,
            Text(
                "A (3, 3) matrix comes back. It holds the pose, but not as one: read x, y and the heading out of it and return (x, y, theta).",
                "(3, 3) の行列がそのまま返っています。姿勢の情報は入っていますが、求めるのは (x, y, theta) です。"
                "行列から x, y と方位を取り出して返しましょう。",
            ),
        ),
        Mistake(
            column_of_the_matrix_returned,
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
