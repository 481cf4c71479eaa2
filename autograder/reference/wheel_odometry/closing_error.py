"""closing_error(trajectory): how far apart the ends of a drive are, and by how much the heading differs (a check after the practical)."""

import numpy as np

from autograder.draws import heading, magnitudes, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import Tolerance


def reference(trajectory):
    """Return distance and turn between the first pose and the last, by complex numbers."""
    (x0, y0, theta0), (x1, y1, theta1) = trajectory[0], trajectory[-1]
    return abs(complex(x1, y1) - complex(x0, y0)), theta1 - theta0


def cases(rng):
    """Draw drives that begin away from the origin, at any heading, and end anywhere; turns are clear of 0 and of half a turn."""

    def drive(rows, turns=0, bit=None, at=None):
        """Return `rows` poses that end `turns` whole turns, and a bit (about `bit` rad), from where they began."""
        bit = rng.choice([-1, 1]) if bit is None else bit
        way = np.column_stack(
            [magnitudes(rng, 0.3, 1.5, rows), magnitudes(rng, 0.3, 1.5, rows), rng.uniform(-0.9, 0.9, rows)]
        ).cumsum(axis=0)
        way[:, 2] += np.linspace(0, turns * 2 * np.pi + bit * rng.uniform(0.9, 1.4) - way[-1, 2] + way[0, 2], rows)
        begin = [magnitudes(rng, 1.1, 3.0), magnitudes(rng, 1.1, 3.0), heading(rng)] if at is None else at
        return (way - way[0] + begin,)

    def telling(trajectory):
        """Is the distance unlike what other distances would be?"""
        x, y, _ = trajectory[-1] - trajectory[0]
        farthest = np.hypot(*(trajectory - trajectory[0])[:, :2].T).max()
        return min(abs(x), abs(y)) > 0.2 and np.hypot(x, y) < 0.9 * farthest and abs(np.hypot(x, y) - 1) > 0.1

    def some(rows, *how):
        return until(lambda: drive(rows, *how), telling)

    def two(rows=2):
        return until(lambda: drive(rows), lambda trajectory: min(abs(trajectory[1] - trajectory[0])) > 0.2)

    side = rng.choice([-1, 1])
    begin = rng.integers(2, 5, 3)
    whole = np.array(
        [
            begin,
            begin + np.array([4, 9, 1]),
            begin + np.array([1, 7, 2]),
            begin + np.array([*rng.choice([2, 3, 4], 2), rng.choice([-1, 2])]),
        ]
    )
    return [
        Group(Text("less than a turn", "一周未満"), 3, [some(6, 0, side), some(9, 0, -2 * side)]),
        Group(Text("more than a turn", "一周を超える経路"), 2, [some(7, side, -side), some(8, -2 * side, -side)]),
        Group(Text("from the origin", "原点からの出発"), 1, [some(6, 0, None, np.zeros(3))]),
        Group(Text("two poses", "姿勢が二つ"), 1, [two()]),
        Group(Text("one pose", "姿勢が一つ"), 1, [drive(1)]),
        Group(Text("lists", "リスト"), 1, [(some(5)[0].tolist(),)]),
        Group(Text("whole numbers", "整数の入力"), 1, [(whole,)]),
    ]


EXAMPLE = (np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 1.5], [2.0, 2.0, 3.0], [0.3, -0.4, 6.0]]),)
EXAMPLE_ELSEWHERE = (np.array([[5.0, 1.0, 1.0], [5.0, 2.0, 2.0], [5.0, 1.5, 1.25]]),)


def measured_from_the_origin(trajectory):
    p = np.array(trajectory, dtype=float)
    return np.hypot(p[-1, 0], p[-1, 1]), p[-1, 2] - p[0, 2]


def measured_from_the_zero_pose(trajectory):
    p = np.array(trajectory, dtype=float)
    return np.hypot(p[-1, 0], p[-1, 1]), p[-1, 2]


def heading_at_the_end_returned(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, _ = p[-1] - p[0]
    return np.hypot(dx, dy), p[-1, 2]


def angle_reversed(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return np.hypot(dx, dy), -turn


def angle_without_sign(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return np.hypot(dx, dy), np.abs(turn)


def wrapped_angle_without_sign(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return np.hypot(dx, dy), np.abs((turn + np.pi) % (2 * np.pi) - np.pi)


def angle_in_degrees(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return np.hypot(dx, dy), np.rad2deg(turn)


def direction_of_the_gap_returned(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, _ = p[-1] - p[0]
    return np.hypot(dx, dy), np.arctan2(dy, dx)


def length_of_the_path_returned(trajectory):
    p = np.array(trajectory, dtype=float)
    _, _, turn = p[-1] - p[0]
    return np.hypot(np.diff(p[:, 0]), np.diff(p[:, 1])).sum(), turn


def farthest_distance_returned(trajectory):
    p = np.array(trajectory, dtype=float)
    _, _, turn = p[-1] - p[0]
    return np.hypot(p[:, 0] - p[0, 0], p[:, 1] - p[0, 1]).max(), turn


def mean_distance_returned(trajectory):
    p = np.array(trajectory, dtype=float)
    _, _, turn = p[-1] - p[0]
    return np.hypot(p[:, 0] - p[0, 0], p[:, 1] - p[0, 1]).mean(), turn


def square_of_the_distance(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return dx**2 + dy**2, turn


def sum_of_both_axes(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return dx + dy, turn


def sum_of_both_magnitudes(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return np.abs(dx) + np.abs(dy), turn


def only_x_looked_at(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, _, turn = p[-1] - p[0]
    return np.abs(dx), turn


def only_y_looked_at(trajectory):
    p = np.array(trajectory, dtype=float)
    _, dy, turn = p[-1] - p[0]
    return np.abs(dy), turn


def angle_counted_as_length(trajectory):
    p = np.array(trajectory, dtype=float)
    _, _, turn = p[-1] - p[0]
    return np.linalg.norm(p[-1] - p[0]), turn


def distances_of_the_ends_subtracted(trajectory):
    p = np.array(trajectory, dtype=float)
    _, _, turn = p[-1] - p[0]
    return np.abs(np.hypot(p[-1, 0], p[-1, 1]) - np.hypot(p[0, 0], p[0, 1])), turn


def last_step_returned(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[max(len(p) - 2, 0)]
    return np.hypot(dx, dy), turn


def last_pose_left_out(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[max(len(p) - 2, 0)] - p[0]
    return np.hypot(dx, dy), turn


def angle_first(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return turn, np.hypot(dx, dy)


def distance_alone(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, _ = p[-1] - p[0]
    return np.hypot(dx, dy)


def difference_of_the_poses_returned(trajectory):
    p = np.array(trajectory, dtype=float)
    return p[-1] - p[0]


def distance_of_the_loop_in_percent(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, turn = p[-1] - p[0]
    return 100 * np.hypot(dx, dy) / max(np.hypot(np.diff(p[:, 0]), np.diff(p[:, 1])).sum(), 1e-12), turn


def turns_added_without_sign(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy, _ = p[-1] - p[0]
    return np.hypot(dx, dy), np.abs(np.diff(p[:, 2])).sum()


def arrays_only(trajectory):
    dx, dy, turn = trajectory[-1] - trajectory[0]
    return np.hypot(dx, dy), turn


def distance_from_the_mean(trajectory):
    p = np.array(trajectory, dtype=float)
    dx, dy = p[-1, :2] - p[:, :2].mean(axis=0)
    return np.hypot(dx, dy), p[-1, 2] - p[0, 2]


EXERCISE = Exercise(
    name="closing_error",
    notebook="odometry/wheel_odometry",
    points=5,
    parameters=("trajectory",),
    reference=reference,
    cases=cases,
    examples=(EXAMPLE, EXAMPLE_ELSEWHERE),
    tolerance=Tolerance(axis=-1, angles=(1,)),
    quantities=("distance", "angle"),
    mistakes=(
        Mistake(
            measured_from_the_origin,
            Text(
                "The distance is measured from the origin. A drive may begin anywhere: measure from its first pose.",
                "距離を原点から測っています。出発点は原点とは限らないので、最初の姿勢から測りましょう。",
            ),
        ),
        Mistake(
            measured_from_the_zero_pose,
            Text(
                "Distance and angle are those of the last pose alone. A drive may begin anywhere: take the first pose off both.",
                "距離も角度も最後の姿勢だけで計算しています。出発点は原点とは限らないので、どちらも最初の姿勢との差にしましょう。",
            ),
        ),
        Mistake(
            heading_at_the_end_returned,
            Text(
                "The angle is the heading at the end. Subtract the heading at the start.",
                "角度が最後の方位そのものです。最初の方位を引きましょう。",
            ),
        ),
        Mistake(
            angle_reversed,
            Text(
                "The angle is start minus end. Asked for is end minus start.",
                "角度が最初から最後を引いたものになっています。最後から最初を引きましょう。",
            ),
        ),
        Mistake(
            angle_without_sign,
            Text(
                "The angle has lost its sign. It tells to which side the heading is off.",
                "角度の符号が失われています。符号は方位がどちらへずれたかを表します。",
            ),
        ),
        Mistake(
            wrapped_angle_without_sign,
            Text(
                "The angle has lost its sign, after it was wrapped. It tells to which side the heading is off.",
                "折り返した後の角度の符号が失われています。符号は方位がどちらへずれたかを表します。",
            ),
        ),
        Mistake(
            angle_in_degrees,
            Text(
                "The angle is in degrees. Angles are in rad here.",
                "角度が度になっています。単位はradです。",
            ),
        ),
        Mistake(
            direction_of_the_gap_returned,
            Text(
                "The angle is the direction from start to end. Asked for is by how much the heading has changed: the third column.",
                "角度が始点から終点への向きになっています。求めるのは方位の変化で、3列目から計算します。",
            ),
        ),
        Mistake(
            length_of_the_path_returned,
            Text(
                "The distance is the length of the path. Asked for is how far the last pose is from the first, in a straight line.",
                "距離が経路の長さになっています。求めるのは最初の姿勢から最後の姿勢までの直線距離です。",
            ),
        ),
        Mistake(
            farthest_distance_returned,
            Text(
                "The distance is the largest on the way. Asked for is the one at the end.",
                "距離が途中の最大値になっています。求めるのは最後の姿勢での値です。",
            ),
        ),
        Mistake(
            mean_distance_returned,
            Text(
                "The distance is the mean over the way. Asked for is the one at the end.",
                "距離が経路上の平均になっています。求めるのは最後の姿勢での値です。",
            ),
        ),
        Mistake(
            square_of_the_distance,
            Text(
                "The root is missing: the distance is still squared.",
                "平方根を取っておらず、距離の2乗になっています。",
            ),
        ),
        Mistake(
            sum_of_both_axes,
            Text(
                "The differences along x and y are added. Distance is the root of the sum of their squares.",
                "xとyの差を足しています。距離は2乗の和の平方根です。",
            ),
        ),
        Mistake(
            sum_of_both_magnitudes,
            Text(
                "The magnitudes along x and y are added: the way along the axes. Distance is the root of the sum of squares.",
                "xとyの差の絶対値を足しています。距離は2乗の和の平方根です。",
            ),
        ),
        Mistake(
            only_x_looked_at,
            Text(
                "Only the difference along x is looked at. y counts too.",
                "x方向の差しか見ていません。yも必要です。",
            ),
        ),
        Mistake(
            only_y_looked_at,
            Text(
                "Only the difference along y is looked at. x counts too.",
                "y方向の差しか見ていません。xも必要です。",
            ),
        ),
        Mistake(
            angle_counted_as_length,
            Text(
                "The heading is counted into the distance: the norm is taken of all three columns. Only x and y are lengths.",
                "3列すべてのノルムを取り、方位まで距離に含めています。長さなのはxとyだけです。",
            ),
        ),
        Mistake(
            distances_of_the_ends_subtracted,
            Text(
                "Two distances from the origin are subtracted. Subtract the positions first, then take the length of the difference.",
                "原点からの距離どうしを引いています。先に位置の差を取り、その長さを求めましょう。",
            ),
        ),
        Mistake(
            last_step_returned,
            Text(
                "The last pose is compared with the one before it. Compare it with the first.",
                "最後の姿勢を1つ前の姿勢と比べています。最初の姿勢と比べましょう。",
            ),
        ),
        Mistake(
            last_pose_left_out,
            Text(
                "The last pose but one is compared with the first. The last one has the index -1, or N-1.",
                "最後から2番目の姿勢を比べています。最後の添字は-1、つまりN-1です。",
            ),
        ),
        Mistake(
            angle_first,
            Text(
                "The order is exchanged: the distance comes first, then the angle.",
                "順序が逆です。距離、角度の順に返しましょう。",
            ),
        ),
        Mistake(
            distance_alone,
            Text(
                "Only the distance comes back. The angle is asked for too: (distance, angle).",
                "距離だけが返っています。角度も含めて(distance, angle)を返しましょう。",
            ),
        ),
        Mistake(
            difference_of_the_poses_returned,
            Text(
                "The difference of the two poses comes back. Asked for are two numbers: its length in x and y, and its angle.",
                "2つの姿勢の差がそのまま返っています。求めるのはxとyの差の長さと角度の2つです。",
            ),
        ),
        Mistake(
            distance_of_the_loop_in_percent,
            Text(
                "The distance is in percent of the path. Asked for are metres.",
                "距離が経路長に対する百分率になっています。求めるのはmです。",
            ),
        ),
        Mistake(
            turns_added_without_sign,
            Text(
                "The angle adds up all turns on the way without their signs. Asked for is end minus start.",
                "途中の回転角の絶対値をすべて足しています。求めるのは最後の方位から最初の方位を引いたものです。",
            ),
        ),
        Mistake(
            arrays_only,
            Text(
                "Lists end in an error: rows of a list cannot be subtracted. np.asarray(trajectory, dtype=float) makes an array first.",
                "リストの場合にエラーになります。リストの行どうしは引き算できません。先にnp.asarray(trajectory, dtype=float)で配列にしましょう。",
            ),
        ),
        Mistake(
            distance_from_the_mean,
            Text(
                "The distance is measured from the middle of all poses. Measure from the first.",
                "距離を全姿勢の中心から測っています。最初の姿勢から測りましょう。",
            ),
        ),
    ),
)
