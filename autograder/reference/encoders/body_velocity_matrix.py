"""body_velocity_matrix(radius_right, radius_left, tread): the matrix of notes 001, eq. (5), wheel rates to (V, omega)."""

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(radius_right, radius_left, tread):
    """Return the matrix column by column: a wheel that turns alone makes the robot pivot about the other one."""
    pivot_about_left = radius_right / tread
    pivot_about_right = -radius_left / tread
    return np.array([[pivot_about_left * tread / 2, -pivot_about_right * tread / 2], [pivot_about_left, pivot_about_right]])


def cases(rng):
    """Draw treads of both signs in every group; no two entries of a matrix are alike unless the radii are equal."""

    def tread(sign):
        return float(sign * rng.uniform(0.2, 0.7))

    def different():
        small, large = rng.uniform(0.05, 0.12), rng.uniform(0.14, 0.25)
        return [float(radius) for radius in rng.permutation([small, large])]

    def nearly_equal():
        radius = rng.uniform(0.05, 0.25)
        return float(radius), float(radius * (1 + rng.uniform(0.002, 0.01) * rng.choice([-1.0, 1.0])))

    equal = float(rng.uniform(0.05, 0.25))
    right, left = rng.permutation([1, 3, 5, 7])[:2].tolist()
    return [
        Group(
            Text("wheels of different radii", "左右の半径が違うロボット"),
            3,
            [(*different(), tread(sign)) for sign in (1, -1, 1, -1)],
        ),
        Group(
            Text("radii that differ a little", "半径がわずかに違うロボット"),
            2,
            [(*nearly_equal(), tread(sign)) for sign in (-1, 1)],
        ),
        Group(Text("equal radii", "左右の半径が等しいロボット"), 1, [(equal, equal, tread(sign)) for sign in (1, -1)]),
        Group(Text("whole numbers", "整数の入力"), 1, [(right, left, -4), (left, right, 6)]),
    ]


def radius_right_for_both(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_right / 2], [radius_right / tread, -radius_right / tread]])


def radius_left_for_both(radius_right, radius_left, tread):
    return np.array([[radius_left / 2, radius_left / 2], [radius_left / tread, -radius_left / tread]])


def mean_radius_for_both(radius_right, radius_left, tread):
    radius = (radius_right + radius_left) / 2
    return np.array([[radius / 2, radius / 2], [radius / tread, -radius / tread]])


def radii_exchanged(radius_right, radius_left, tread):
    return np.array([[radius_left / 2, radius_right / 2], [radius_left / tread, -radius_right / tread]])


def columns_exchanged(radius_right, radius_left, tread):
    return np.array([[radius_left / 2, radius_right / 2], [-radius_left / tread, radius_right / tread]])


def radii_exchanged_in_first_row(radius_right, radius_left, tread):
    return np.array([[radius_left / 2, radius_right / 2], [radius_right / tread, -radius_left / tread]])


def radii_exchanged_in_second_row(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_left / tread, -radius_right / tread]])


def rows_exchanged(radius_right, radius_left, tread):
    return np.array([[radius_right / tread, -radius_left / tread], [radius_right / 2, radius_left / 2]])


def transposed(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_right / tread], [radius_left / 2, -radius_left / tread]])


def inverted(radius_right, radius_left, tread):
    return np.linalg.inv(np.array([[radius_right / 2, radius_left / 2], [radius_right / tread, -radius_left / tread]]))


def minus_missing(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right / tread, radius_left / tread]])


def left_minus_right(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [-radius_right / tread, radius_left / tread]])


def minus_in_first_row(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, -radius_left / 2], [radius_right / tread, radius_left / tread]])


def minus_in_both_rows(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, -radius_left / 2], [radius_right / tread, -radius_left / tread]])


def both_negative_in_second_row(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [-radius_right / tread, -radius_left / tread]])


def sign_of_tread_lost(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right / abs(tread), -radius_left / abs(tread)]])


def halves_missing(radius_right, radius_left, tread):
    return np.array([[radius_right, radius_left], [radius_right / tread, -radius_left / tread]])


def quarters_for_halves(radius_right, radius_left, tread):
    return np.array([[radius_right / 4, radius_left / 4], [radius_right / tread, -radius_left / tread]])


def half_missing_for_left(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left], [radius_right / tread, -radius_left / tread]])


def half_missing_for_right(radius_right, radius_left, tread):
    return np.array([[radius_right, radius_left / 2], [radius_right / tread, -radius_left / tread]])


def halves_in_both_rows(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right / (2 * tread), -radius_left / (2 * tread)]])


def half_in_the_second_row_only(radius_right, radius_left, tread):
    return np.array([[radius_right, radius_left], [radius_right / (2 * tread), -radius_left / (2 * tread)]])


def half_tread(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right / (tread / 2), -radius_left / (tread / 2)]])


def twice_everything(radius_right, radius_left, tread):
    return np.array([[radius_right, radius_left], [2 * radius_right / tread, -2 * radius_left / tread]])


def half_everything(radius_right, radius_left, tread):
    return np.array([[radius_right / 4, radius_left / 4], [radius_right / 2 / tread, -radius_left / 2 / tread]])


def tread_missing(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right, -radius_left]])


def tread_missing_and_halved(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right / 2, -radius_left / 2]])


def tread_missing_for_right(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right, -radius_left / tread]])


def tread_missing_for_left(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right / tread, -radius_left]])


def tread_multiplied(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right * tread, -radius_left * tread]])


def ratio_inverted(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [tread / radius_right, -tread / radius_left]])


def tread_in_both_rows(radius_right, radius_left, tread):
    return np.array([[radius_right / tread, radius_left / tread], [radius_right / tread, -radius_left / tread]])


def radii_left_out(radius_right, radius_left, tread):
    return np.array([[1 / 2, 1 / 2], [1 / tread, -1 / tread]])


def radii_in_first_row_only(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [1 / tread, -1 / tread]])


def radii_in_second_row_only(radius_right, radius_left, tread):
    return np.array([[1 / 2, 1 / 2], [radius_right / tread, -radius_left / tread]])


def divided_by_radii(radius_right, radius_left, tread):
    return np.array([[1 / (2 * radius_right), 1 / (2 * radius_left)], [1 / (tread * radius_right), -1 / (tread * radius_left)]])


def second_row_in_degrees(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], np.rad2deg([radius_right / tread, -radius_left / tread])])


def circumference_for_radius(radius_right, radius_left, tread):
    right, left = 2 * np.pi * radius_right, 2 * np.pi * radius_left
    return np.array([[right / 2, left / 2], [right / tread, -left / tread]])


def tread_of_the_slides(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [radius_right / -0.3045, -radius_left / -0.3045]])


def integer_division(radius_right, radius_left, tread):
    return np.array([[radius_right // 2, radius_left // 2], [radius_right // tread, -radius_left // tread]])


def decimals_cut_off(radius_right, radius_left, tread):
    matrix = np.array([[radius_right, radius_left], [radius_right, -radius_left]])
    matrix[0] = matrix[0] / 2
    matrix[1] = matrix[1] / tread
    return matrix


def rounded(radius_right, radius_left, tread):
    return np.round([[radius_right / 2, radius_left / 2], [radius_right / tread, -radius_left / tread]], 3)


def rounded_coarsely(radius_right, radius_left, tread):
    return np.round([[radius_right / 2, radius_left / 2], [radius_right / tread, -radius_left / tread]], 2)


def flat(radius_right, radius_left, tread):
    return np.array([radius_right / 2, radius_left / 2, radius_right / tread, -radius_left / tread])


def three_rows(radius_right, radius_left, tread):
    return np.array([[radius_right / 2, radius_left / 2], [0, 0], [radius_right / tread, -radius_left / tread]])


def rows_added_up(radius_right, radius_left, tread):
    return np.array([(radius_right + radius_left) / 2, (radius_right - radius_left) / tread])


EXERCISE = Exercise(
    name="body_velocity_matrix",
    notebook="odometry/encoders",
    points=5,
    parameters=("radius_right", "radius_left", "tread"),
    quantities=("M[:, 0]", "M[:, 1]"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=(
        (0.1, 0.2, 0.4),
        (0.14825, 0.14857, -0.3045),
    ),
    mistakes=(
        Mistake(
            radius_right_for_both,
            Text(
                "The right wheel's radius is used for both wheels. Eq. (5) has r_R and r_L: real wheels differ, and a small "
                "difference bends every straight run.",
                "左右どちらにも右車輪の半径を使っています。式 (5) には r_R と r_L があります。"
                "実際の車輪は半径が少し違い、わずかな差でも直進が曲がります。",
            ),
        ),
        Mistake(
            radius_left_for_both,
            Text(
                "The left wheel's radius is used for both wheels. Eq. (5) has r_R and r_L: real wheels differ, and a small "
                "difference bends every straight run.",
                "左右どちらにも左車輪の半径を使っています。式 (5) には r_R と r_L があります。"
                "実際の車輪は半径が少し違い、わずかな差でも直進が曲がります。",
            ),
        ),
        Mistake(
            mean_radius_for_both,
            Text(
                "The mean of the two radii is used for both wheels. Each wheel rolls on its own radius: eq. (5) has r_R and r_L.",
                "左右どちらにも半径の平均を使っています。車輪はそれぞれの半径で転がります。式 (5) には r_R と r_L があります。",
            ),
        ),
        Mistake(
            radii_exchanged,
            Text(
                "r_R and r_L are exchanged in both rows: the first column belongs to the right wheel. Look at the order of the "
                "arguments too.",
                "2 つの行とも r_R と r_L が入れ替わっています。1 列目は右車輪の列です。引数の順序も確かめましょう。",
            ),
        ),
        Mistake(
            columns_exchanged,
            Text(
                "The columns are exchanged: this matrix maps (omega_L, omega_R). The right wheel comes first in eq. (5).",
                "列が入れ替わっていて、(omega_L, omega_R) に掛ける行列になっています。式 (5) では右車輪が先です。",
            ),
        ),
        Mistake(
            radii_exchanged_in_first_row,
            Text(
                "r_R and r_L are exchanged in the first row. Each column belongs to one wheel.",
                "1 行目で r_R と r_L が入れ替わっています。列ごとに 1 つの車輪に対応します。",
            ),
        ),
        Mistake(
            radii_exchanged_in_second_row,
            Text(
                "r_R and r_L are exchanged in the second row. Each column belongs to one wheel.",
                "2 行目で r_R と r_L が入れ替わっています。列ごとに 1 つの車輪に対応します。",
            ),
        ),
        Mistake(
            rows_exchanged,
            Text(
                "The rows are exchanged: omega comes out first. Asked for is (V, omega).",
                "行が入れ替わっていて、omega が先に出てきます。結果は (V, omega) の順です。",
            ),
        ),
        Mistake(
            transposed,
            Text(
                "The matrix is transposed: rows and columns are exchanged. One row makes V from both wheels, the other omega.",
                "行列が転置されています。1 行目は両輪から V を、2 行目は両輪から omega を作ります。",
            ),
        ),
        Mistake(
            inverted,
            Text(
                "This is the inverse: it maps (V, omega) to the wheel rates, as a controller needs it. Odometry goes the other way.",
                "これは逆行列で、(V, omega) から車輪の角速度を求めるものです(制御で使います)。オドメトリはその逆方向です。",
            ),
        ),
        Mistake(
            minus_missing,
            Text(
                "The minus sign is missing in the second row: with both wheels alike the robot would turn. A left wheel that "
                "runs forward turns the robot "
                "the other way than the right one.",
                "2 行目のマイナスが抜けています。これでは両輪が等しくても旋回してしまいます。"
                "左車輪の前転は、右車輪とは逆向きの旋回を生みます。",
            ),
        ),
        Mistake(
            left_minus_right,
            Text(
                "The signs of the second row are turned round: left minus right. Eq. (5) has the plus at the right wheel, and "
                "the tread keeps its own sign.",
                "2 行目の符号が逆(左 - 右)です。式 (5) では右車輪の側がプラスです。トレッドの符号はそのまま使います。",
            ),
        ),
        Mistake(
            minus_in_first_row,
            Text(
                "The minus sign stands in the first row instead of the second. Both wheels forward: V adds up, omega is a "
                "difference.",
                "マイナスが 2 行目ではなく 1 行目に付いています。両輪が前転するとき、V は和、omega は差になります。",
            ),
        ),
        Mistake(
            minus_in_both_rows,
            Text(
                "The left wheel has a minus sign in the first row too. V is the mean of both wheels.",
                "1 行目の左車輪にもマイナスが付いています。V は両輪の平均です。",
            ),
        ),
        Mistake(
            both_negative_in_second_row,
            Text(
                "Both entries of the second row are turned negative. A wheel forward on the right and one on the left turn the "
                "robot in opposite ways.",
                "2 行目の両方の要素にマイナスが付いています。右車輪と左車輪の前転は、互いに逆向きの旋回を生みます。",
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
            halves_missing,
            Text(
                "The first row is twice what it should be. V is the mean of the two wheel speeds: where is the half?",
                "1 行目が 2 倍になっています。V は両輪の速度の平均です。1/2 はどこに入りますか。",
            ),
        ),
        Mistake(
            quarters_for_halves,
            Text(
                "The first row is half of what it should be: the half is used twice.",
                "1 行目が半分になっています。1/2 を 2 回掛けていませんか。",
            ),
        ),
        Mistake(
            half_missing_for_left,
            Text(
                "The entry of the left wheel in the first row lacks its half. The mean halves both.",
                "1 行目の左車輪の要素に 1/2 が抜けています。平均では両方が半分になります。",
            ),
        ),
        Mistake(
            half_missing_for_right,
            Text(
                "The entry of the right wheel in the first row lacks its half. The mean halves both.",
                "1 行目の右車輪の要素に 1/2 が抜けています。平均では両方が半分になります。",
            ),
        ),
        Mistake(
            half_in_the_second_row_only,
            Text(
                "The half stands in the second row instead of the first. V is a mean, omega a difference over the whole tread.",
                "1/2 が 1 行目ではなく 2 行目に入っています。V は平均、omega は差をトレッド全体で割ったものです。",
            ),
        ),
        Mistake(
            halves_in_both_rows,
            Text(
                "The second row is half of what it should be. The half belongs to V, a mean; omega is the difference over the "
                "whole tread.",
                "2 行目が半分になっています。1/2 が必要なのは平均である V だけです。omega は差をトレッド全体で割ったものです。",
            ),
        ),
        Mistake(
            half_tread,
            Text(
                "The second row is twice what it should be: half the tread is used. T is the whole distance between the wheels "
                "(the d of the slides on dead reckoning is half of it).",
                "2 行目が 2 倍になっています。トレッドの半分で割っています。"
                "T は車輪の間隔全体です(デッドレコニングのスライドの d はその半分です)。",
            ),
        ),
        Mistake(
            twice_everything,
            Text(
                "All entries are twice what they should be: are these diameters instead of radii, or is a half missing?",
                "すべての要素が 2 倍になっています。半径の代わりに直径を使っていませんか。1/2 が抜けていませんか。",
            ),
        ),
        Mistake(
            half_everything,
            Text(
                "All entries are half of what they should be: are the radii taken for diameters, or is a half too much?",
                "すべての要素が半分になっています。半径を直径とみなしていませんか。1/2 が余分に入っていませんか。",
            ),
        ),
        Mistake(
            tread_missing,
            Text(
                "The tread is missing in the second row. A wider robot turns more slowly: divide by it.",
                "2 行目にトレッドがありません。幅の広いロボットほどゆっくり回るので、トレッドで割ります。",
            ),
        ),
        Mistake(
            tread_missing_and_halved,
            Text(
                "The second row is halved like the first; it has no half, but the tread.",
                "2 行目も 1 行目と同じように 2 で割っています。2 行目で割るのは 2 ではなくトレッドです。",
            ),
        ),
        Mistake(
            tread_missing_for_right,
            Text(
                "In the second row only the left wheel's entry is divided by the tread. Both are.",
                "2 行目では左車輪の要素だけがトレッドで割られています。両方とも割ります。",
            ),
        ),
        Mistake(
            tread_missing_for_left,
            Text(
                "In the second row only the right wheel's entry is divided by the tread. Both are.",
                "2 行目では右車輪の要素だけがトレッドで割られています。両方とも割ります。",
            ),
        ),
        Mistake(
            tread_multiplied,
            Text(
                "The second row is multiplied by the tread. A wider robot turns more slowly: divide by it.",
                "2 行目にトレッドを掛けています。幅の広いロボットほどゆっくり回るので、割ります。",
            ),
        ),
        Mistake(
            ratio_inverted,
            Text(
                "The ratio in the second row is upside down. A larger wheel turns the robot faster, a wider tread slower.",
                "2 行目の比が逆です。車輪が大きいほど速く、トレッドが広いほどゆっくり回ります。",
            ),
        ),
        Mistake(
            tread_in_both_rows,
            Text(
                "The first row is divided by the tread instead of 2. V is the mean of the wheel speeds, however far apart they are.",
                "1 行目を 2 ではなくトレッドで割っています。V は車輪速度の平均で、車輪の間隔によりません。",
            ),
        ),
        Mistake(
            radii_left_out,
            Text(
                "The radii are missing: this matrix maps the speeds of the wheels' rims, v_R and v_L. Eq. (5) begins with their "
                "angular velocities.",
                "半径が抜けていて、周の速度 v_R, v_L に掛ける行列になっています。式 (5) は車輪の角速度から始まります。",
            ),
        ),
        Mistake(
            radii_in_first_row_only,
            Text(
                "The second row has no radii. omega comes from wheel speeds r·omega_R and r·omega_L too.",
                "2 行目に半径がありません。omega も車輪の速度(半径 × 角速度)から求まります。",
            ),
        ),
        Mistake(
            radii_in_second_row_only,
            Text(
                "The first row has no radii. V comes from wheel speeds r·omega_R and r·omega_L.",
                "1 行目に半径がありません。V は車輪の速度(半径 × 角速度)から求まります。",
            ),
        ),
        Mistake(
            divided_by_radii,
            Text(
                "The entries are divided by the radii. A larger wheel rolls further in one turn: multiply.",
                "半径で割っています。大きな車輪ほど 1 回転で長い距離を進むので、掛けます。",
            ),
        ),
        Mistake(
            second_row_in_degrees,
            Text(
                "The second row gives degrees per second. r / T maps rad/s to rad/s: leave it as it is.",
                "2 行目が度毎秒になっています。r / T だけで rad/s から rad/s への変換になるので、そのままにしましょう。",
            ),
        ),
        Mistake(
            circumference_for_radius,
            Text(
                "All entries carry 2π: the circumference instead of the radius. omega_R is in rad/s, and rad times radius is a "
                "length already.",
                "すべての要素に 2π が掛かっています。半径の代わりに円周を使っていませんか。"
                "omega_R は rad/s なので、半径を掛けるだけで速度になります。",
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
            integer_division,
            Text("// drops the fractions. Divide with /.", "// は小数部分を切り捨てます。/ で割りましょう。"),
        ),
        Mistake(
            decimals_cut_off,
            Text(
                "With whole numbers the decimals are cut off: an array made of integers holds integers only. Make it with "
                "dtype=float.",
                "整数が渡されると小数部分が切り捨てられます。整数から作った配列には整数しか入りません。"
                "dtype=float を指定しましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The entries are rounded to 3 decimals. A difference of the radii shows in the fourth: round only for display.",
                "要素が小数第 3 位までに丸められています。左右の半径の差は小数第 4 位に現れます。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            rounded_coarsely,
            Text(
                "The entries are rounded to 2 decimals. A difference of the radii shows in the fourth: round only for display.",
                "要素が小数第 2 位までに丸められています。左右の半径の差は小数第 4 位に現れます。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            flat,
            Text(
                "Four entries in one row come back. A matrix has rows: [[..., ...], [..., ...]].",
                "4 つの要素が 1 列に並んでいます。行列は [[..., ...], [..., ...]] のように行ごとに書きます。",
            ),
        ),
        Mistake(
            three_rows,
            Text(
                "There is a row for a sideways velocity, too. Eq. (5) has two rows: V and omega.",
                "横方向の速度の行が入っています。式 (5) の行列は V と omega の 2 行です。",
            ),
        ),
        Mistake(
            rows_added_up,
            Text(
                "Two values come back: the matrix is multiplied by (1, 1) already, or its rows are added up. Keep the four "
                "entries apart.",
                "値が 2 つだけ返っています。行ごとに要素を足し合わせています。4 つの要素を別々に並べましょう。",
            ),
        ),
    ),
)
