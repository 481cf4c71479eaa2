"""points_to_parent(points, frame): points (N, 2), measured in the frame, as the frame's parent measures them. Notes 001, section 2."""

import cmath

import numpy as np

from autograder.draws import magnitudes, pose, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(points, frame):
    """Return the frame's origin plus each point as an arrow, turned with the frame."""
    turn, origin = cmath.rect(1.0, frame[2]), complex(frame[0], frame[1])
    ends = [origin + complex(x, y) * turn for x, y in points]
    return [(end.real, end.imag) for end in ends]


def cases(rng):
    """Draw frames turned to either side; the numbers of points differ, with two points (where (N, 2) hides a transposition) and one."""

    def cloud(count, side, turns=0):
        def draw():
            frame = pose(rng)
            frame[2] = side * (abs(frame[2]) + 2 * np.pi * turns)
            points = np.column_stack([magnitudes(rng, 0.5, 3.0, count), magnitudes(rng, 0.5, 3.0, count)])
            return points, frame

        return until(draw, clear_of_zero)

    def many():
        return int(rng.integers(4, 8))

    side = rng.permutation([1, -1])
    still = cloud(many(), 1)
    whole = until(
        lambda: (rng.integers(1, 6, (4, 2)) * rng.choice([-1, 1], (4, 2)), rng.integers(1, 6, 3) * rng.choice([-1, 1], 3)),
        clear_of_zero,
    )
    listed = cloud(many(), side[0])
    return [
        Group(Text("a frame turned to the left", "左に回った座標系"), 3, [cloud(many(), 1), cloud(3, 1)]),
        Group(Text("a frame turned to the right", "右に回った座標系"), 3, [cloud(many(), -1), cloud(3, -1)]),
        Group(Text("two points", "2 点"), 1, [cloud(2, side[0]), cloud(2, side[1])]),
        Group(Text("a single point, shape (1, 2)", "1 点だけ(形状 (1, 2))"), 1, [cloud(1, side[0]), cloud(1, side[1])]),
        Group(
            Text("lists and whole numbers", "リストや整数の入力"),
            1,
            [whole, (listed[0].tolist(), listed[1].tolist())],
        ),
        Group(
            Text("headings beyond one turn, and a frame that is not turned", "1 回転を超える方位と、回転していない座標系"),
            1,
            [cloud(many(), side[0], 1), (still[0], np.array([*still[1][:2], 0.0]))],
        ),
    ]


def clear_of_zero(points, frame):
    """Is every coordinate of the points in the parent far enough from zero that rounding does not matter?"""
    return np.abs(reference(points, frame)).max(axis=0).min() > 0.6


def rotated_the_other_way(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.asarray(points) @ np.array([[c, -s], [s, c]]) + np.asarray(frame)[:2]


def not_rotated(points, frame):
    return np.asarray(points) + np.asarray(frame)[:2]


def not_shifted(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.asarray(points) @ np.array([[c, s], [-s, c]])


def not_shifted_and_rotated_back(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.asarray(points) @ np.array([[c, -s], [s, c]])


def shifted_before_the_rotation(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return (np.asarray(points) + np.asarray(frame)[:2]) @ np.array([[c, s], [-s, c]])


def shifted_then_rotated_back(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return (np.asarray(points) + np.asarray(frame)[:2]) @ np.array([[c, -s], [s, c]])


def parent_to_frame(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return (np.asarray(points) - np.asarray(frame)[:2]) @ np.array([[c, -s], [s, c]])


def origin_subtracted(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.asarray(points) @ np.array([[c, s], [-s, c]]) - np.asarray(frame)[:2]


def origin_subtracted_before_the_rotation(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return (np.asarray(points) - np.asarray(frame)[:2]) @ np.array([[c, s], [-s, c]])


def matrix_times_rows(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([[c, -s], [s, c]]) @ np.asarray(points) + np.asarray(frame)[:2]


def points_as_columns(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([[c, -s], [s, c]]) @ np.asarray(points).T + np.asarray(frame)[:2].reshape(2, 1)


def origin_added_along_the_points(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return (np.array([[c, -s], [s, c]]) @ np.asarray(points).T + np.asarray(frame)[:2]).T


def whole_pose_added(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.asarray(points) @ np.array([[c, s], [-s, c]]) + np.asarray(frame)


def multiplied_element_by_element(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.asarray(points) * np.array([[c, -s], [s, c]]) + np.asarray(frame)[:2]


def each_axis_by_itself(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x, frame[1] + s * y) for x, y in points])


def y_ignored(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x, frame[1] + s * x) for x, y in points])


def sin_cos_exchanged(points, frame):
    c, s = np.sin(frame[2]), np.cos(frame[2])
    return np.array([(frame[0] + c * x - s * y, frame[1] + s * x + c * y) for x, y in points])


def no_minus_sign(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x + s * y, frame[1] + s * x + c * y) for x, y in points])


def minus_sign_twice(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x - s * y, frame[1] - s * x + c * y) for x, y in points])


def mirrored(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x + s * y, frame[1] + s * x - c * y) for x, y in points])


def x_and_y_exchanged(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[1] + s * x + c * y, frame[0] + c * x - s * y) for x, y in points])


def y_from_the_new_x(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    moved = np.array(points, dtype=float)
    moved[:, 0] = c * moved[:, 0] - s * moved[:, 1]
    moved[:, 1] = s * moved[:, 0] + c * moved[:, 1]
    return moved + np.asarray(frame)[:2]


def x_of_the_result_used_for_y(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    moved = np.array(points, dtype=float)
    moved[:, 0] = frame[0] + c * moved[:, 0] - s * moved[:, 1]
    moved[:, 1] = frame[1] + s * moved[:, 0] + c * moved[:, 1]
    return moved


def x_of_the_origin_for_both(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.asarray(points) @ np.array([[c, s], [-s, c]]) + frame[0]


def rotated_by_positive_angle_only(points, frame):
    c, s = np.cos(abs(frame[2])), np.sin(abs(frame[2]))
    return np.asarray(points) @ np.array([[c, s], [-s, c]]) + np.asarray(frame)[:2]


def degrees_in_cos(points, frame):
    c, s = np.cos(np.deg2rad(frame[2])), np.sin(np.deg2rad(frame[2]))
    return np.asarray(points) @ np.array([[c, s], [-s, c]]) + np.asarray(frame)[:2]


def converted_to_degrees_for_cos(points, frame):
    c, s = np.cos(np.rad2deg(frame[2])), np.sin(np.rad2deg(frame[2]))
    return np.asarray(points) @ np.array([[c, s], [-s, c]]) + np.asarray(frame)[:2]


def points_laid_end_to_end(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.cumsum(np.asarray(points) @ np.array([[c, s], [-s, c]]), axis=0) + np.asarray(frame)[:2]


def only_the_first_shifted(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    moved = np.asarray(points) @ np.array([[c, s], [-s, c]])
    moved[0] += np.asarray(frame)[:2]
    return moved


def only_the_first_point(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    x, y = points[0]
    return np.array([frame[0] + c * x - s * y, frame[1] + s * x + c * y])


def only_the_last_point(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    x, y = points[-1]
    return np.array([frame[0] + c * x - s * y, frame[1] + s * x + c * y])


def last_point_left_out(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x - s * y, frame[1] + s * x + c * y) for x, y in points[:-1]])


def headings_appended(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x - s * y, frame[1] + s * x + c * y, frame[2]) for x, y in points])


def homogeneous_ones_kept(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.array([(frame[0] + c * x - s * y, frame[1] + s * x + c * y, 1.0) for x, y in points])


def all_in_one_row(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.ravel([(frame[0] + c * x - s * y, frame[1] + s * x + c * y) for x, y in points])


def single_point_flattened(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.squeeze(np.asarray(points) @ np.array([[c, s], [-s, c]]) + np.asarray(frame)[:2])


def whole_numbers_cut_off(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    moved = np.array(points)
    for k, (x, y) in enumerate(points):
        moved[k] = frame[0] + c * x - s * y, frame[1] + s * x + c * y
    return moved


def rounded(points, frame):
    c, s = np.cos(frame[2]), np.sin(frame[2])
    return np.round(np.asarray(points) @ np.array([[c, s], [-s, c]]) + np.asarray(frame)[:2], 3)


EXERCISE = Exercise(
    name="points_to_parent",
    notebook="odometry/frames",
    points=5,
    parameters=("points", "frame"),
    quantities=("x", "y"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (np.array([[1.0, 0.0], [0.0, 1.0], [2.0, 1.0]]), np.array([3.0, 1.0, np.pi / 2])),
        (np.array([[2.0, -1.0]]), np.array([1.0, 2.0, -np.pi / 6])),
    ),
    mistakes=(
        Mistake(
            rotated_the_other_way,
            Text(
                "The points are turned the wrong way, from the parent into the frame. If the points stand in rows, points @ R multiplies by the "
                "rotation from the other side, and that is its transpose. Put the frame at heading pi/2: its x axis points along the parent's +y.",
                "点の回転が逆向き(親から frame への向き)です。点が行に並んでいるときの points @ R は、転置した行列を掛けるのと同じです。"
                "frame の方位が π/2 なら、その x 軸は親の +y を向くはずです。",
            ),
        ),
        Mistake(
            not_rotated,
            Text(
                "The points are shifted but not turned. Their coordinates are measured along the frame's axes, which have another direction "
                "than the parent's.",
                "点が平行移動しているだけで、回転していません。点の座標は frame の軸に沿って測られていて、その軸は親の軸とは向きが違います。",
            ),
        ),
        Mistake(
            not_shifted,
            Text(
                "The points are turned rightly, but still counted from the frame's origin. Where does that origin lie in the parent?",
                "回転は合っていますが、まだ frame の原点から測った座標です。その原点は親の座標系のどこにありますか。",
            ),
        ),
        Mistake(
            not_shifted_and_rotated_back,
            Text(
                "The points are turned the wrong way, and the frame's origin is not added. points @ R, with points in rows, is the transposed rotation.",
                "回転が逆向きで、frame の原点も足されていません。点が行に並んでいるときの points @ R は、転置した回転になります。",
            ),
        ),
        Mistake(
            shifted_before_the_rotation,
            Text(
                "The frame's origin is added before the rotation, so it is turned as well. It is given in the parent's axes already: "
                "turn the points first.",
                "frame の原点を足してから回転させているため、原点の位置まで回転しています。原点はすでに親の軸で表されています。先に点を回転させましょう。",
            ),
        ),
        Mistake(
            shifted_then_rotated_back,
            Text(
                "The frame's origin is added before the rotation, so it is turned as well, and the rotation itself goes the wrong way "
                "(points @ R, with points in rows, is the transposed one).",
                "frame の原点を足してから回転させているため原点まで回転し、回転の向きも逆です(点が行に並んでいるときの points @ R は転置した回転です)。",
            ),
        ),
        Mistake(
            parent_to_frame,
            Text(
                "This is the way back: from the parent into the frame. Here the points are given in the frame and lead out to the parent.",
                "これは親から frame へ入る、逆向きの変換です。ここでは frame の中の点を、親の座標系へ出します。",
            ),
        ),
        Mistake(
            origin_subtracted,
            Text(
                "The frame's origin is subtracted. What lies at (0, 0) in the frame lies at the frame's own x and y in the parent.",
                "frame の原点を引いています。frame の (0, 0) にある点は、親の座標系では frame の x, y の位置にあるはずです。",
            ),
        ),
        Mistake(
            origin_subtracted_before_the_rotation,
            Text(
                "The frame's origin is subtracted from the points before they are turned. The points are counted from that origin already; "
                "turn them, then say where the origin lies.",
                "回転させる前に、点から frame の原点を引いています。点はすでにその原点から測られています。"
                "まず回転させ、そのあとで原点の位置を考えましょう。",
            ),
        ),
        Mistake(
            matrix_times_rows,
            Text(
                "R @ points takes the columns of the array for vectors, but here each row is a point. For two points that gives wrong numbers without "
                "any error; for other numbers of points it stops.",
                "R @ points では配列の列がベクトルとして扱われますが、ここでは 1 行が 1 点です。"
                "2 点のときはエラーにならずに違う値になり、それ以外の点数ではエラーになります。",
            ),
        ),
        Mistake(
            points_as_columns,
            Text(
                "The points come back as columns, shape (2, N). They are asked for as rows, shape (N, 2), just as they came in.",
                "点が列に並び、形状が (2, N) になっています。受け取ったときと同じ、1 行に 1 点の形状 (N, 2) で返しましょう。",
            ),
        ),
        Mistake(
            origin_added_along_the_points,
            Text(
                "The points are turned rightly as columns, (2, N), but the origin (2,) is then added along the wrong axis: it only fits when there are two "
                "points, and is wrong even then. Turn back to rows first.",
                "点を列 (2, N) に並べて回転させるところまでは合っていますが、原点 (2,) を足す向きが違います。"
                "形が合うのは 2 点のときなどだけで、そのときも値は違います。先に行の並びへ戻しましょう。",
            ),
        ),
        Mistake(
            whole_pose_added,
            Text(
                "The whole frame is added, three numbers, to points of two. Only its position shifts them.",
                "3 つの数をもつ frame 全体を、2 つの数の点に足しています。平行移動に使うのは位置だけです。",
            ),
        ),
        Mistake(
            multiplied_element_by_element,
            Text(
                "* multiplies element by element; a matrix acts on vectors with @. For two points the shapes fit by accident.",
                "* は要素ごとの積です。行列をベクトルに作用させるには @ を使います。2 点のときは偶然形が合ってしまいます。",
            ),
        ),
        Mistake(
            each_axis_by_itself,
            Text(
                "x takes only the point's x, and y only its y. A turned axis has a part along both axes of the parent: each line has two terms.",
                "x には点の x だけ、y には点の y だけを使っています。回転した軸は親の両方の軸に成分を持ちます。それぞれの式に項が 2 つずつ必要です。",
            ),
        ),
        Mistake(
            y_ignored,
            Text(
                "The points' y is not used: all points are treated as if they lay on the frame's x axis.",
                "点の y が使われていません。どの点も frame の x 軸上にあるものとして計算されています。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged. In a frame of heading 0 the points are only shifted: which of the two must be 1 there?",
                "sin と cos が入れ替わっています。frame の方位が 0 なら平行移動だけです。そのとき 1 になるべきなのはどちらでしょうか。",
            ),
        ),
        Mistake(
            no_minus_sign,
            Text(
                "All four terms have a plus sign. A rotation has one minus: in a frame turned by pi/2, the y axis points along the parent's -x.",
                "4 つの項がすべてプラスです。回転の式にはマイナスが 1 つあります。π/2 回った座標系の y 軸は、親の -x を向きます。",
            ),
        ),
        Mistake(
            minus_sign_twice,
            Text(
                "There is one minus sign too many: it stands before both sines. In a frame turned by pi/2, the x axis points along the parent's +y.",
                "マイナスが 1 つ多く、2 つの sin の両方に付いています。π/2 回った座標系の x 軸は、親の +y を向きます。",
            ),
        ),
        Mistake(
            mirrored,
            Text(
                "The points come out mirrored: in a frame of heading 0 their y has the opposite sign.",
                "点が鏡映しになっています。frame の方位が 0 のとき、y の符号が逆になってしまいます。",
            ),
        ),
        Mistake(
            x_and_y_exchanged,
            Text(
                "x and y come back in each other's column. The first column is x.",
                "x と y の列が入れ替わっています。1 列目が x です。",
            ),
        ),
        Mistake(
            y_from_the_new_x,
            Text(
                "x is overwritten before y is computed, so y uses the turned x. Keep the old x under its own name, or turn both at once.",
                "y を計算する前に x を上書きしているため、y の式に回転後の x が使われています。"
                "元の x を別の名前で残すか、x と y を同時に計算しましょう。",
            ),
        ),
        Mistake(
            x_of_the_result_used_for_y,
            Text(
                "The line for y uses the finished x, turned and shifted, instead of the point's own. Give the result an array of its own.",
                "y の式に、点の x ではなく、回転と平行移動を終えた x を使っています。結果は別の配列に入れましょう。",
            ),
        ),
        Mistake(
            x_of_the_origin_for_both,
            Text(
                "The frame's x is added to both columns. The second column is shifted by its y.",
                "frame の x を両方の列に足しています。2 列目に足すのは frame の y です。",
            ),
        ),
        Mistake(
            rotated_by_positive_angle_only,
            Text(
                "A frame turned to the right is treated as if it were turned to the left: the sign of its heading is lost.",
                "右に回った座標系が、左に回ったものとして計算されています。方位の符号が失われています。",
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
            points_laid_end_to_end,
            Text(
                "The points are added up one after another. They are places in the frame, not steps: each is moved by itself.",
                "点が次々に足し合わされています。点は移動量ではなく frame の中の位置ですから、1 点ずつ別々に変換します。",
            ),
        ),
        Mistake(
            only_the_first_shifted,
            Text(
                "Only the first point is shifted. The frame's origin must be added to every row.",
                "最初の点だけが平行移動しています。frame の原点はすべての行に足します。",
            ),
        ),
        Mistake(
            only_the_first_point,
            Text(
                "Only the first point comes back. Look where return stands: after the loop, or in it?",
                "最初の点だけが返っています。return がループの中に入っていないか確かめましょう。",
            ),
        ),
        Mistake(
            only_the_last_point,
            Text(
                "Only the last point comes back. Is the result overwritten in each pass of the loop instead of collected?",
                "最後の点だけが返っています。ループのたびに結果を上書きしていませんか。",
            ),
        ),
        Mistake(
            last_point_left_out,
            Text(
                "The last point is missing. Where does the loop end?",
                "最後の点が抜けています。ループの終わりを確かめましょう。",
            ),
        ),
        Mistake(
            headings_appended,
            Text(
                "Each point comes back with the frame's heading as a third number. A point has no heading: shape (N, 2).",
                "それぞれの点に、3 番目の数として frame の方位が付いています。点に方位はありません。形状は (N, 2) です。",
            ),
        ),
        Mistake(
            homogeneous_ones_kept,
            Text(
                "The 1 of the homogeneous coordinates comes back with each point. Cut that column off: shape (N, 2).",
                "同次座標の 1 が、点に付いたまま返っています。その列を取り除いて、形状 (N, 2) にしましょう。",
            ),
        ),
        Mistake(
            all_in_one_row,
            Text(
                "The numbers are right, but they come back in one row, x and y in turn. Keep one row for each point, shape (N, 2).",
                "値は合っていますが、x と y が交互に 1 列に並んで返っています。1 行に 1 点の形状 (N, 2) にしましょう。",
            ),
        ),
        Mistake(
            single_point_flattened,
            Text(
                "A single point, shape (1, 2), comes back with shape (2,). Is there a squeeze? One row stays one row.",
                "1 点だけのとき、形状 (1, 2) が (2,) になって返っています。squeeze を使っていませんか。1 行の配列は 1 行のまま返します。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With points of whole numbers the decimals are cut off: a copy of an integer array holds integers only. "
                "Make it np.array(points, dtype=float).",
                "点が整数で渡されると、小数部分が切り捨てられます。整数の配列をコピーすると整数しか入りません。"
                "np.array(points, dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The points are rounded. Round only for display.",
                "点の座標が丸められています。丸めるのは表示のときだけにしましょう。",
            ),
        ),
    ),
)
