"""body_velocity(v_right, v_left, tread): wheel speeds to the velocity of the robot, slides 000, overview 5. The tread keeps its sign."""

import numpy as np

from autograder.draws import until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import FIRST_AXIS


def reference(v_right, v_left, tread):
    """Return (V, omega): the wheels stand half a tread to either side of the middle, and the whole axle turns as one."""
    right, left = np.asarray(v_right, dtype=float), np.asarray(v_left, dtype=float)
    yaw_rate = (right - left) / tread
    return right - yaw_rate * tread / 2, yaw_rate


def cases(rng):
    """Draw motions of every kind, with treads of both signs in each group; neither V nor omega is close to zero unless it is 0."""
    sides = rng.permutation([1.0, -1.0])

    def tread(k):
        return float(sides[k % 2] * rng.uniform(0.2, 0.6))

    def speeds(kind, size=None):
        slow, fast = rng.uniform(0.15, 0.4, size), rng.uniform(0.6, 1.2, size)
        return {
            "left": (fast, slow),
            "right": (slow, fast),
            "backwards": (-fast, -slow),
            "backwards the other way": (-slow, -fast),
            "left wheel back": (fast, -slow),
            "right wheel back": (-slow, fast),
        }[kind]

    def numbers(kind, k):
        right, left = speeds(kind)
        return float(right), float(left), tread(k)

    def mixed(size):
        """Return motions of all kinds; where there are several, one of them is nearly straight."""
        kinds = rng.permutation(["left", "right", "backwards", "left wheel back", "right wheel back", "backwards the other way"])
        right, left = np.transpose([speeds(kind) for kind in kinds[:size]])
        if size > 1:
            left[-1] = right[-1] + rng.choice([-1.0, 1.0]) * rng.uniform(0.01, 0.03)
        return right, left

    def whole():
        right, left = rng.integers(-6, 7, 2).tolist()
        return right, left, int(rng.choice([-4, -3, 3]))

    straight = float(rng.uniform(0.3, 1.2))
    forward = rng.uniform(0.3, 1.2, int(rng.integers(4, 7)))
    listed = rng.integers(2, 9, int(rng.integers(4, 7)))
    behind = (listed + rng.choice([1, 3, 5], len(listed))).tolist()
    return [
        Group(Text("turning left", "左旋回"), 2, [numbers("left", 0), numbers("left", 1)]),
        Group(Text("turning right", "右旋回"), 2, [numbers("right", 0), numbers("right", 1)]),
        Group(Text("straight", "直進"), 1, [(straight, straight, tread(0)), (forward, forward.copy(), tread(1))]),
        Group(Text("backwards", "後退"), 1, [numbers("backwards", 0), numbers("backwards the other way", 1)]),
        Group(
            Text("one wheel backwards, as in a turn on the spot", "片輪が逆転(その場旋回など)"),
            1,
            [numbers("left wheel back", 0), numbers("right wheel back", 1), (-straight, straight, tread(0))],
        ),
        Group(Text("arrays", "配列"), 2, [(*mixed(int(rng.integers(4, 7))), tread(0)), (*mixed(2), tread(1))]),
        Group(
            Text("whole numbers, lists, a single entry", "整数、リスト、要素 1 つの配列"),
            1,
            [until(whole, divides_with_remainder), (behind, listed.tolist(), -3), (*mixed(1), tread(0))],
        ),
    ]


def divides_with_remainder(v_right, v_left, tread):
    """Tell whether an integer division would lose something, in V and in omega."""
    return (v_right + v_left) % 2 == 1 and (v_right - v_left) % tread != 0 and v_right != 0 and v_left != 0


def half_missing(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return right + left, (right - left) / tread


def half_twice(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 4, (right - left) / tread


def half_of_the_left_only(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return right + left / 2, (right - left) / tread


def half_of_the_right_only(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return right / 2 + left, (right - left) / tread


def velocity_from_difference(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right - left) / 2, (right - left) / tread


def velocity_over_tread(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / tread, (right - left) / tread


def velocity_of_the_right_wheel(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return right, (right - left) / tread


def velocity_of_the_left_wheel(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return left, (right - left) / tread


def velocity_of_the_faster_wheel(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.maximum(right, left), (right - left) / tread


def velocity_of_the_slower_wheel(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.minimum(right, left), (right - left) / tread


def velocity_made_positive(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.abs(right + left) / 2, (right - left) / tread


def mean_of_absolute_speeds(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (np.abs(right) + np.abs(left)) / 2, (right - left) / tread


def length_of_both_speeds(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.sqrt(right**2 + left**2), (right - left) / tread


def root_mean_square(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.sqrt((right**2 + left**2) / 2), (right - left) / tread


def geometric_mean(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.sqrt(np.abs(right * left)), (right - left) / tread


def velocity_reversed(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return -(right + left) / 2, (right - left) / tread


def left_minus_right(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (left - right) / tread


def sign_of_tread_lost(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / abs(tread)


def left_minus_right_over_absolute_tread(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (left - right) / abs(tread)


def half_tread(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / (tread / 2)


def difference_averaged(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / 2 / tread


def brackets_lost_at_half_tread(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / 2 * tread


def tread_forgotten(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, right - left


def tread_forgotten_and_averaged(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / 2


def tread_multiplied(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) * tread


def tread_squared(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / tread**2


def brackets_lost_in_difference(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, right - left / tread


def yaw_rate_from_sum(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right + left) / tread


def yaw_rate_from_velocity(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right + left) / 2 / tread


def yaw_rate_made_positive(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, np.abs((right - left) / tread)


def difference_made_positive(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, np.abs(right - left) / tread


def difference_of_absolute_speeds(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (np.abs(right) - np.abs(left)) / tread


def absolute_speeds(v_right, v_left, tread):
    right, left = np.abs(v_right), np.abs(v_left)
    return (right + left) / 2, (right - left) / tread


def yaw_rate_in_degrees(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, np.rad2deg((right - left) / tread)


def yaw_rate_over_circumference(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / (np.pi * tread)


def arctangent_taken(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, np.arctan((right - left) / tread)


def tread_of_the_slides(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / -0.3045


def tread_of_the_beego(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / 0.2765


def length_of_the_tread_of_the_slides(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, (right - left) / 0.3045


def order_exchanged(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right - left) / tread, (right + left) / 2


def integer_division(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) // 2, (right - left) / tread


def integer_division_in_both(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) // 2, (right - left) // tread


def decimals_cut_off(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    velocity, yaw_rate = np.zeros_like(right), np.zeros_like(right)
    velocity[...] = (right + left) / 2
    yaw_rate[...] = (right - left) / tread
    return velocity, yaw_rate


def rounded(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.round((right + left) / 2, 3), np.round((right - left) / tread, 3)


def rounded_coarsely(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.round((right + left) / 2, 2), np.round((right - left) / tread, 2)


def only_velocity(v_right, v_left, tread):
    return (np.asarray(v_right) + np.asarray(v_left)) / 2


def only_yaw_rate(v_right, v_left, tread):
    return (np.asarray(v_right) - np.asarray(v_left)) / tread


def side_by_side(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return np.stack([(right + left) / 2, (right - left) / tread], axis=-1)


def numbers_become_arrays(v_right, v_left, tread):
    right, left = np.atleast_1d(v_right), np.atleast_1d(v_left)
    return (right + left) / 2, (right - left) / tread


def single_entry_becomes_number(v_right, v_left, tread):
    right, left = np.squeeze(v_right), np.squeeze(v_left)
    return (right + left) / 2, (right - left) / tread


def means_over_the_drive(v_right, v_left, tread):
    right, left = np.mean(v_right), np.mean(v_left)
    return (right + left) / 2, (right - left) / tread


def vector_of_motion(v_right, v_left, tread):
    right, left = np.asarray(v_right), np.asarray(v_left)
    return (right + left) / 2, 0 * right, (right - left) / tread


EXERCISE = Exercise(
    name="body_velocity",
    notebook="odometry/encoders",
    points=5,
    parameters=("v_right", "v_left", "tread"),
    quantities=("V", "omega"),
    reference=reference,
    cases=cases,
    tolerance=FIRST_AXIS,
    examples=(
        (0.4, 0.2, 0.5),
        (0.4, 0.2, -0.5),
        (np.array([0.3, -0.3, 0.0]), np.array([0.3, 0.3, -0.6]), -0.3045),
    ),
    mistakes=(
        Mistake(
            order_exchanged,
            Text(
                "V and omega come back in the wrong order. Asked for is (V, omega).",
                "V と omega の順序が逆です。(V, omega) の順に返しましょう。",
            ),
        ),
        Mistake(
            half_missing,
            Text(
                "V is twice what it should be. If both wheels run at 0.3 m/s, how fast is the robot?",
                "V が 2 倍になっています。両輪が 0.3 m/s のとき、ロボットの速度はいくつでしょうか。",
            ),
        ),
        Mistake(
            half_twice,
            Text(
                "V is half of what it should be: the half is used twice. If both wheels run at 0.3 m/s, how fast is the robot?",
                "V が半分になっています。1/2 を 2 回掛けていませんか。両輪が 0.3 m/s のとき、ロボットの速度はいくつでしょうか。",
            ),
        ),
        Mistake(
            half_of_the_left_only,
            Text(
                "Only v_left is halved in V. Division comes before addition: put the sum into brackets.",
                "V の計算で v_left だけが半分になっています。割り算は足し算より先に計算されるので、和を括弧で囲みましょう。",
            ),
        ),
        Mistake(
            half_of_the_right_only,
            Text(
                "Only v_right is halved in V. Halve the whole sum.",
                "V の計算で v_right だけが半分になっています。和全体を半分にしましょう。",
            ),
        ),
        Mistake(
            velocity_from_difference,
            Text(
                "V is computed from the difference of the wheel speeds. Driving straight, when both are equal, it would be 0.",
                "V を車輪速度の差から計算しています。これでは両輪が等しい直進のときに 0 になってしまいます。",
            ),
        ),
        Mistake(
            velocity_over_tread,
            Text(
                "V is divided by the tread: that has the unit 1/s. The velocity of the middle does not depend on how far apart "
                "the wheels are.",
                "V をトレッドで割っていて、単位が 1/s になっています。中心の速度は車輪の間隔によりません。",
            ),
        ),
        Mistake(
            velocity_of_the_right_wheel,
            Text(
                "V is the speed of the right wheel alone. The robot's velocity is that of the middle of the axle.",
                "V が右車輪の速度そのものになっています。ロボットの速度は車軸の中央の速度です。",
            ),
        ),
        Mistake(
            velocity_of_the_left_wheel,
            Text(
                "V is the speed of the left wheel alone. The robot's velocity is that of the middle of the axle.",
                "V が左車輪の速度そのものになっています。ロボットの速度は車軸の中央の速度です。",
            ),
        ),
        Mistake(
            velocity_of_the_faster_wheel,
            Text(
                "V is the larger of the two wheel speeds. The middle of the axle moves at neither, but in between.",
                "V が 2 つの車輪速度の大きい方になっています。車軸の中央の速度は、その間の値です。",
            ),
        ),
        Mistake(
            velocity_of_the_slower_wheel,
            Text(
                "V is the smaller of the two wheel speeds. The middle of the axle moves at neither, but in between.",
                "V が 2 つの車輪速度の小さい方になっています。車軸の中央の速度は、その間の値です。",
            ),
        ),
        Mistake(
            absolute_speeds,
            Text(
                "The signs of the wheel speeds are lost before anything is computed: backwards counts as forwards. Leave out abs().",
                "計算の前に車輪速度の符号が失われていて、後退が前進として扱われています。abs() は使いません。",
            ),
        ),
        Mistake(
            velocity_made_positive,
            Text(
                "V is made positive. A robot that reverses has a negative velocity: leave out abs().",
                "V が正の値に直されています。後退しているロボットの速度は負です。abs() は使いません。",
            ),
        ),
        Mistake(
            mean_of_absolute_speeds,
            Text(
                "V is the mean of the absolute speeds. A wheel that runs backwards counts negative: on the spot, V is 0.",
                "V が速度の絶対値の平均になっています。逆転する車輪の速度は負です。その場旋回では V は 0 になります。",
            ),
        ),
        Mistake(
            length_of_both_speeds,
            Text(
                "V is the root of the sum of squares. The two wheel speeds are not at right angles to one another: both point "
                "forward.",
                "V を 2 乗和の平方根で計算しています。2 つの車輪の速度は直交していません。どちらも前方を向いています。",
            ),
        ),
        Mistake(
            root_mean_square,
            Text(
                "V is the root mean square of the wheel speeds. It is their plain mean, with signs.",
                "V が車輪速度の 2 乗平均平方根になっています。必要なのは、符号付きのふつうの平均です。",
            ),
        ),
        Mistake(
            geometric_mean,
            Text(
                "V is the root of a product of the wheel speeds. If one wheel stands still the middle of the axle still moves: "
                "take the plain mean.",
                "V を車輪速度の積の平方根で計算しています。片輪が止まっていても車軸の中央は動きます。ふつうの平均をとりましょう。",
            ),
        ),
        Mistake(
            velocity_reversed,
            Text(
                "V has the wrong sign: both wheels forward must move the robot forward.",
                "V の符号が逆です。両輪が前転すればロボットは前進します。",
            ),
        ),
        Mistake(
            left_minus_right,
            Text(
                "omega has the wrong sign: the right speed is subtracted from the left one, or right and left are exchanged. "
                "The formula of overview 5 starts with v_r, and the tread keeps its sign.",
                "omega の符号が逆です。左から右を引いているか、左右が入れ替わっています。"
                "概要 #5 の式は v_r から始まり、トレッドは符号付きのまま使います。",
            ),
        ),
        Mistake(
            sign_of_tread_lost,
            Text(
                "The tread is made positive. A negative tread is no slip: it says that yaw counts clockwise, as the IMU with z "
                "down does. Keep the sign.",
                "トレッドを正に直しています。"
                "負のトレッドは誤りではなく、z 軸が下向きの IMU と同じように、方位を時計回りに数えることを表します。"
                "符号はそのままにしましょう。",
            ),
        ),
        Mistake(
            left_minus_right_over_absolute_tread,
            Text(
                "omega is wrong where the tread is positive: left minus right, over the length of the tread. The formula is the "
                "same for both signs "
                "of the tread; the sign does its work by itself.",
                "トレッドが正のときの omega が正しくありません。左から右を引いて、トレッドの絶対値で割っています。"
                "式はトレッドの符号によらず同じです。符号の違いは割り算に自然に現れます。",
            ),
        ),
        Mistake(
            half_tread,
            Text(
                "omega is twice what it should be: half the tread is used. The T of overview 5 is the whole distance between "
                "the wheels "
                "(the d of the slides on dead reckoning is half of it).",
                "omega が 2 倍になっています。トレッドの半分で割っています。"
                "概要 #5 の T は車輪の間隔全体です(デッドレコニングのスライドの d はその半分です)。",
            ),
        ),
        Mistake(
            difference_averaged,
            Text(
                "omega is half of what it should be: a half as in V, or twice the tread. Think of a turn on the spot: each "
                "wheel runs on a circle of radius T/2.",
                "omega が半分になっています。V と同じように 1/2 を掛けたか、トレッドの 2 倍で割っています。"
                "その場旋回を考えましょう。各車輪は半径 T/2 の円の上を走ります。",
            ),
        ),
        Mistake(
            brackets_lost_at_half_tread,
            Text(
                "omega is (v_r - v_l) * T/2: multiplied by the tread and halved. The wider the robot, the slower it turns; "
                "and a / b * c is (a / b) * c.",
                "omega が (v_r - v_l) * T/2 になっています。幅の広いロボットほどゆっくり回るはずです。"
                "また、a / b * c は (a / b) * c です。",
            ),
        ),
        Mistake(
            tread_forgotten,
            Text(
                "omega is a difference of speeds in m/s: the tread is missing. A wider robot turns more slowly.",
                "omega が速度の差 [m/s] のままです。トレッドが抜けています。幅の広いロボットほどゆっくり回ります。",
            ),
        ),
        Mistake(
            tread_forgotten_and_averaged,
            Text(
                "omega is half the difference of the speeds, in m/s: where is the tread? And the half belongs to V only.",
                "omega が速度の差の半分 [m/s] になっています。トレッドはどこに入りますか。また、1/2 が必要なのは V だけです。",
            ),
        ),
        Mistake(
            tread_multiplied,
            Text(
                "omega is multiplied by the tread. A wider robot turns more slowly: divide.",
                "omega の計算でトレッドを掛けています。幅の広いロボットほどゆっくり回るので、割ります。",
            ),
        ),
        Mistake(
            tread_squared,
            Text(
                "omega is divided by the tread twice. Once gives 1/s.",
                "omega の計算でトレッドで 2 回割っています。1 回割れば単位は 1/s になります。",
            ),
        ),
        Mistake(
            brackets_lost_in_difference,
            Text(
                "Only v_left is divided by the tread. Put the difference into brackets.",
                "v_left だけがトレッドで割られています。差を括弧で囲みましょう。",
            ),
        ),
        Mistake(
            yaw_rate_from_sum,
            Text(
                "omega is computed from the sum of the wheel speeds: driving straight, the robot would turn. Equal speeds must "
                "give omega = 0.",
                "omega を車輪速度の和から計算しています。これでは直進していても旋回することになります。"
                "両輪が等しければ omega は 0 です。",
            ),
        ),
        Mistake(
            yaw_rate_from_velocity,
            Text(
                "omega is V over the tread: driving straight, the robot would turn. Equal speeds must give omega = 0.",
                "omega が V をトレッドで割ったものになっています。これでは直進していても旋回することになります。"
                "両輪が等しければ omega は 0 です。",
            ),
        ),
        Mistake(
            yaw_rate_made_positive,
            Text(
                "omega is made positive: every turn goes to the same side. Leave out abs().",
                "omega が正の値に直されていて、どちらに曲がっても同じ向きの旋回になっています。abs() は使いません。",
            ),
        ),
        Mistake(
            difference_made_positive,
            Text(
                "The sign of v_r - v_l is lost: left and right turns look alike. Leave out abs().",
                "v_r - v_l の符号が失われていて、左旋回と右旋回の区別がつきません。abs() は使いません。",
            ),
        ),
        Mistake(
            difference_of_absolute_speeds,
            Text(
                "omega is the difference of the absolute speeds. A wheel that runs backwards counts negative: on the spot the "
                "difference is largest.",
                "omega が速度の絶対値の差から計算されています。逆転する車輪の速度は負です。"
                "その場旋回では差が最も大きくなるはずです。",
            ),
        ),
        Mistake(
            yaw_rate_in_degrees,
            Text(
                "omega is in degrees per second. v / T is in rad/s already: leave it as it is.",
                "omega が度毎秒になっています。速度 ÷ 長さで rad/s になるので、そのまま返しましょう。",
            ),
        ),
        Mistake(
            yaw_rate_over_circumference,
            Text(
                "omega is divided by π besides: (v_r - v_l) / (π T) counts turns of a half circle. An angular velocity in rad/s "
                "is speed over distance, without π.",
                "omega がさらに π で割られています。角速度 [rad/s] は速度 ÷ 距離で、π は要りません。",
            ),
        ),
        Mistake(
            arctangent_taken,
            Text(
                "An arctangent is taken of omega. (v_r - v_l) / T is a rate already, exact for every size; there is no triangle "
                "here.",
                "omega に逆正接をとっています。(v_r - v_l) / T はそのまま角速度で、大きさによらず正確です。三角形は関係ありません。",
            ),
        ),
        Mistake(
            tread_of_the_slides,
            Text(
                "The tread is always -0.3045 m, that of the i-Cart in the slides. Use the argument tread: robots differ.",
                "トレッドがいつも -0.3045 m(スライドの i-Cart の値)になっています。"
                "ロボットによって違うので、引数 tread を使いましょう。",
            ),
        ),
        Mistake(
            tread_of_the_beego,
            Text(
                "The tread is always 0.2765 m, that of the Beego. Use the argument tread: robots differ.",
                "トレッドがいつも 0.2765 m(Beego の値)になっています。ロボットによって違うので、引数 tread を使いましょう。",
            ),
        ),
        Mistake(
            length_of_the_tread_of_the_slides,
            Text(
                "The tread is always 0.3045 m. Use the argument tread, with its sign: robots differ.",
                "トレッドがいつも 0.3045 m になっています。ロボットによって違うので、引数 tread を符号も含めてそのまま使いましょう。",
            ),
        ),
        Mistake(
            integer_division,
            Text(
                "With whole numbers the half is lost in V: // drops the fraction. Divide with /.",
                "整数のとき、V の 0.5 が失われています。// は小数部分を切り捨てます。/ で割りましょう。",
            ),
        ),
        Mistake(
            integer_division_in_both,
            Text(
                "// drops the fractions of V and omega. Divide with /.",
                "// のため、V と omega の小数部分が切り捨てられています。/ で割りましょう。",
            ),
        ),
        Mistake(
            decimals_cut_off,
            Text(
                "With whole numbers the decimals are cut off: an array made with zeros_like or empty_like from integers holds "
                "integers only. "
                "Make it with dtype=float.",
                "整数が渡されると小数部分が切り捨てられます。整数から zeros_like や empty_like で作った配列には整数しか入りません。"
                "dtype=float を指定しましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "V and omega are rounded to 3 decimals. They are integrated later, and so are the rounding errors: round only "
                "for display.",
                "V と omega が小数第 3 位までに丸められています。あとで積分すると丸め誤差も積み重なります。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            rounded_coarsely,
            Text(
                "V and omega are rounded to 2 decimals. They are integrated later, and so are the rounding errors: round only "
                "for display.",
                "V と omega が小数第 2 位までに丸められています。あとで積分すると丸め誤差も積み重なります。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            only_velocity,
            Text("Only V comes back. Return the pair (V, omega).", "V だけが返っています。(V, omega) の組を返しましょう。"),
        ),
        Mistake(
            only_yaw_rate,
            Text(
                "Only omega comes back. Return the pair (V, omega).", "omega だけが返っています。(V, omega) の組を返しましょう。"
            ),
        ),
        Mistake(
            side_by_side,
            Text(
                "For arrays one row (V, omega) for each sample comes back. Asked for is the pair of two arrays: all of V, then "
                "all of omega.",
                "配列を渡すと、サンプルごとの行 (V, omega) が返っています。V の配列と omega の配列の組を返しましょう。",
            ),
        ),
        Mistake(
            numbers_become_arrays,
            Text(
                "For single numbers arrays come back. Numbers in, numbers out: leave out np.atleast_1d and [v_right].",
                "数値を渡しても配列が返っています。数値には数値を返しましょう。np.atleast_1d や [v_right] は不要です。",
            ),
        ),
        Mistake(
            single_entry_becomes_number,
            Text(
                "Arrays with one entry come back as bare numbers. Arrays in, arrays out, whatever their length.",
                "要素 1 つの配列を渡すと、ただの数値が返っています。長さに関係なく、配列には配列を返しましょう。",
            ),
        ),
        Mistake(
            means_over_the_drive,
            Text(
                "From arrays come two numbers, means over all samples. Each sample has a V and an omega of its own.",
                "配列を渡すと、全サンプルの平均の数値が返っています。V と omega はサンプルごとに求めましょう。",
            ),
        ),
        Mistake(
            vector_of_motion,
            Text(
                "Three values come back, with the sideways velocity between. Asked for is the pair (V, omega).",
                "横方向の速度を含む 3 つの値が返っています。(V, omega) の 2 つを返しましょう。",
            ),
        ),
    ),
)
