"""speed_resolution(radius, gear, counts_per_rev, dt): the speed that one count per sample means, slides 000, overview 6."""

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(radius, gear, counts_per_rev, dt):
    """Return the rim's speed when the encoder shaft makes one count in each sampling period."""
    motor_turns_per_second = 1 / (float(counts_per_rev) * dt)
    return motor_turns_per_second / gear * np.pi * (radius + radius)


def cases(rng):
    """Draw robots with and without a gearbox, and sampling periods from 4 to 90 ms, or whole seconds."""

    def robot(gear):
        return float(rng.uniform(0.06, 0.25)), gear, int(rng.choice([100, 128, 200, 360, 512])), float(rng.uniform(0.006, 0.09))

    def gearbox():
        return robot(int(rng.integers(12, 60)))

    def odd_gearbox(fraction):
        return robot(float(rng.integers(5, 30) + fraction))

    return [
        Group(Text("a motor with a gearbox", "ギア付きのモータ"), 4, [gearbox() for _ in range(4)]),
        Group(
            Text("a gear ratio that is no whole number", "整数でないギア比"),
            2,
            [odd_gearbox(rng.uniform(0.2, 0.45)), odd_gearbox(rng.uniform(0.55, 0.8))],
        ),
        Group(Text("an encoder on the wheel itself", "車輪に直接付いたエンコーダ"), 1, [robot(1), robot(1.0)]),
        Group(
            Text("whole numbers", "整数の入力"),
            1,
            [(int(rng.integers(2, 6)), *gearbox()[1:3], 2), (3, int(rng.integers(2, 9)), 1000, int(rng.integers(3, 6)))],
        ),
    ]


def time_forgotten(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev)


def time_multiplied(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) * dt


def time_divided_twice(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) / dt**2


def period_of_5_ms(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) / 0.005


def time_in_milliseconds(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) / (dt / 1000)


def milliseconds_divided_by(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) / (dt * 1000)


def speed_in_kilometres_per_hour(radius, gear, counts_per_rev, dt):
    return 3.6 * 2 * np.pi * radius / (gear * counts_per_rev) / dt


def samples_per_second(radius, gear, counts_per_rev, dt):
    return 1 / dt


def standard_deviation(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) / dt / np.sqrt(12)


def standard_deviation_of_difference(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev) / dt / np.sqrt(6)


def radius_forgotten(radius, gear, counts_per_rev, dt):
    return 2 * np.pi / (gear * counts_per_rev) / dt


def turns_for_one_count(radius, gear, counts_per_rev, dt):
    return 1 / (gear * counts_per_rev) / dt


def radius_divided(radius, gear, counts_per_rev, dt):
    return 2 * np.pi / (gear * counts_per_rev) / radius / dt


def area_of_the_wheel(radius, gear, counts_per_rev, dt):
    return np.pi * radius**2 / (gear * counts_per_rev) / dt


def radius_squared(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius**2 / (gear * counts_per_rev) / dt


def half_of_it(radius, gear, counts_per_rev, dt):
    return np.pi * radius / (gear * counts_per_rev) / dt


def twice_of_it(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * 2 * radius / (gear * counts_per_rev) / dt


def two_pi_forgotten(radius, gear, counts_per_rev, dt):
    return radius / (gear * counts_per_rev) / dt


def two_pi_divided(radius, gear, counts_per_rev, dt):
    return radius / (gear * counts_per_rev * 2 * np.pi) / dt


def pi_forgotten(radius, gear, counts_per_rev, dt):
    return 2 * radius / (gear * counts_per_rev) / dt


def degrees_for_rad(radius, gear, counts_per_rev, dt):
    return 360 * radius / (gear * counts_per_rev) / dt


def pi_shortened(radius, gear, counts_per_rev, dt):
    return 2 * 3.14 * radius / (gear * counts_per_rev) / dt


def gear_forgotten(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / counts_per_rev / dt


def gear_multiplied(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius * gear / counts_per_rev / dt


def gear_divided_twice(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / gear / (gear * counts_per_rev) / dt


def gear_added(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear + counts_per_rev) / dt


def gear_rounded_down(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (int(gear) * counts_per_rev) / dt


def gear_rounded(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (round(gear) * counts_per_rev) / dt


def counts_per_rev_forgotten(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / gear / dt


def counts_per_rev_multiplied(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / gear * counts_per_rev / dt


def both_multiplied(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius * gear * counts_per_rev / dt


def counts_per_rev_taken_for_pulses(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * 4 * counts_per_rev) / dt


def count_taken_for_pulse(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * counts_per_rev / 4) / dt


def ratio_inverted(radius, gear, counts_per_rev, dt):
    return gear * counts_per_rev / (2 * np.pi * radius) * dt


def ratio_inverted_but_dt(radius, gear, counts_per_rev, dt):
    return gear * counts_per_rev / (2 * np.pi * radius) / dt


def numbers_of_the_slides(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * 0.14457758 / (150 * 400) / dt


def numbers_of_the_slides_and_5_ms(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * 0.14457758 / (150 * 400) / 0.005


def gear_of_the_slides(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (150 * counts_per_rev) / dt


def counts_per_rev_of_the_slides(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius / (gear * 400) / dt


def radius_of_the_slides(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * 0.14457758 / (gear * counts_per_rev) / dt


def integer_division(radius, gear, counts_per_rev, dt):
    return 2 * np.pi * radius // (gear * counts_per_rev) / dt


def rounded(radius, gear, counts_per_rev, dt):
    return round(2 * np.pi * radius / (gear * counts_per_rev) / dt, 4)


def rounded_coarsely(radius, gear, counts_per_rev, dt):
    return round(2 * np.pi * radius / (gear * counts_per_rev) / dt, 3)


def array_returned(radius, gear, counts_per_rev, dt):
    return np.array([2 * np.pi * radius / (gear * counts_per_rev) / dt])


EXERCISE = Exercise(
    name="speed_resolution",
    notebook="odometry/encoders",
    points=5,
    parameters=("radius", "gear", "counts_per_rev", "dt"),
    gear=1,
    reference=reference,
    cases=cases,
    examples=(
        (0.14457758, 150, 400, 0.005),
        (0.14457758, 150, 400, 0.02),
        (0.5, 1, 100, 0.1),
    ),
    mistakes=(
        Mistake(
            time_forgotten,
            Text(
                "dt is missing: this is the distance of one count in m. A speed is a distance over the time in which it is covered.",
                "dt が抜けていて、1 カウントの距離 [m] になっています。速度は距離を、それにかかった時間で割ったものです。",
            ),
        ),
        Mistake(
            time_multiplied,
            Text(
                "The distance of one count is multiplied by dt. The shorter the sample, the more speed one count means: divide.",
                "1 カウントの距離に dt を掛けています。サンプリング周期が短いほど、1 カウントの表す速度は大きくなります。"
                "割りましょう。",
            ),
        ),
        Mistake(
            time_divided_twice,
            Text(
                "dt is divided by twice: m/s^2 is an acceleration. Once is enough.",
                "dt で 2 回割っているため、単位が m/s^2(加速度)になっています。割るのは 1 回です。",
            ),
        ),
        Mistake(
            period_of_5_ms,
            Text(
                "The sampling period is always 0.005 s. Other boards have other periods: use the argument dt.",
                "サンプリング周期がいつも 0.005 s になっています。基板によって違うので、引数 dt を使いましょう。",
            ),
        ),
        Mistake(
            time_in_milliseconds,
            Text(
                "The result is 1000 times too large: dt taken for ms, or mm/s instead of m/s. dt is in s, the radius in m, the "
                "result in m/s.",
                "結果が 1000 倍になっています。dt を ms とみなしているか、mm/s になっています。dt は s、半径は m、結果は m/s です。",
            ),
        ),
        Mistake(
            milliseconds_divided_by,
            Text(
                "The result is 1000 times too small: dt is turned into ms before dividing, or m into km. Seconds and metres "
                "give m/s.",
                "結果が 1/1000 になっています。割る前に dt を ms に、または m を km に直していませんか。"
                "s と m のままで m/s になります。",
            ),
        ),
        Mistake(
            speed_in_kilometres_per_hour,
            Text(
                "The result is in km/h. Asked for is m/s.",
                "結果が km/h になっています。求めるのは m/s です。",
            ),
        ),
        Mistake(
            samples_per_second,
            Text(
                "This is 1/dt, counts per second. How far does the wheel roll for one count?",
                "これは 1/dt、つまり 1 秒あたりのカウント数です。1 カウントでタイヤはどれだけ進みますか。",
            ),
        ),
        Mistake(
            standard_deviation,
            Text(
                "The result is divided by √12: that is the standard deviation of rounding to one count. Asked for is the step "
                "itself.",
                "√12 で割っていて、1 カウントへの丸めの標準偏差になっています。求めるのは 1 段の大きさそのものです。",
            ),
        ),
        Mistake(
            standard_deviation_of_difference,
            Text(
                "The result is divided by √6: that is the standard deviation of a difference of two rounded readings. Asked for "
                "is the step itself.",
                "√6 で割っていて、丸めた読み 2 つの差の標準偏差になっています。求めるのは 1 段の大きさそのものです。",
            ),
        ),
        Mistake(
            radius_forgotten,
            Text(
                "The radius is missing: this is the angle of the wheel per second for one count. Rolling turns an angle into a "
                "distance: how?",
                "半径が抜けていて、1 カウントあたりのタイヤの角速度になっています。転がると角度はどのように距離になりますか。",
            ),
        ),
        Mistake(
            turns_for_one_count,
            Text(
                "These are turns of the wheel per second for one count. One turn rolls 2πr.",
                "これは 1 カウントあたりのタイヤの回転数(毎秒)です。1 回転で 2πr 進みます。",
            ),
        ),
        Mistake(
            radius_divided,
            Text(
                "The angle is divided by the radius. A larger wheel rolls further in one turn: multiply.",
                "角度を半径で割っています。大きなタイヤほど 1 回転で長い距離を進むので、掛けます。",
            ),
        ),
        Mistake(
            area_of_the_wheel,
            Text(
                "π r² is the area of the wheel. In one turn it rolls its circumference.",
                "π r² はタイヤの面積です。1 回転で進む距離は円周の長さです。",
            ),
        ),
        Mistake(
            radius_squared,
            Text(
                "The radius is in it squared. Distance is angle times radius, once.",
                "半径が 2 乗されています。距離は角度に半径を 1 回掛けたものです。",
            ),
        ),
        Mistake(
            half_of_it,
            Text(
                "The result is half of what it should be: π r instead of 2π r, as if the radius were the diameter, or the half "
                "of V = (v_r + v_l)/2, though this is about one wheel. One turn of the wheel is 2πr: 0.908 m for r = 0.1446 m.",
                "結果が半分になっています。2πr ではなく πr(半径を直径とみなした値)か、V = (v_r + v_l)/2 の 1/2 を掛けた値です。"
                "ここで考えるのは車輪 1 つです。1 回転は 2πr で、r = 0.1446 m なら 0.908 m です。",
            ),
        ),
        Mistake(
            twice_of_it,
            Text(
                "The result is twice what it should be: a diameter used as the radius, or a 2 counted twice. One turn of the "
                "wheel is 2πr: 0.908 m for r = 0.1446 m.",
                "結果が 2 倍になっています。半径の代わりに直径を使ったか、2 を余分に掛けています。"
                "1 回転は 2πr で、r = 0.1446 m なら 0.908 m です。",
            ),
        ),
        Mistake(
            two_pi_forgotten,
            Text(
                "2π is missing: one over counts per turn is a part of a turn, and one turn is 2π rad.",
                "2π が抜けています。1 を 1 回転分のカウントで割ると回転数になります。1 回転は 2π rad です。",
            ),
        ),
        Mistake(
            two_pi_divided,
            Text(
                "2π stands in the denominator. From turns to rad you multiply; look at the brackets too: x / a * b is not x / "
                "(a * b).",
                "2π が分母に入っています。回転数を rad にするには 2π を掛けます。括弧にも注意しましょう。"
                "x / a * b と x / (a * b) は違います。",
            ),
        ),
        Mistake(
            pi_forgotten,
            Text(
                "π is missing: 2r is the diameter. In one turn the wheel rolls its circumference.",
                "π が抜けています。2r は直径です。1 回転で進む距離は円周の長さです。",
            ),
        ),
        Mistake(
            degrees_for_rad,
            Text(
                "One turn is counted as 360: degrees. Angle times radius is a distance only if the angle is in rad.",
                "1 回転を 360 度としています。角度 × 半径が距離になるのは、角度が rad のときだけです。",
            ),
        ),
        Mistake(
            pi_shortened,
            Text(
                "π is shortened to 3.14; over thousands of counts the error adds up. Use np.pi.",
                "π を 3.14 としています。何千カウントも積み重なると誤差が目立ちます。np.pi を使いましょう。",
            ),
        ),
        Mistake(
            gear_forgotten,
            Text(
                "The gear ratio is missing. The encoder sits on the motor, which turns gear times while the wheel turns once.",
                "ギア比が抜けています。エンコーダはモータ側に付いています。タイヤが 1 回転する間に、モータは gear 回転します。",
            ),
        ),
        Mistake(
            gear_multiplied,
            Text(
                "The gear ratio is multiplied. With a higher gear there are more counts to one turn of the wheel: does one "
                "count then mean more or less?",
                "ギア比を掛けています。ギア比が大きいほど、タイヤ 1 回転のカウントは増えます。"
                "1 カウントの意味する量は増えますか、減りますか。",
            ),
        ),
        Mistake(
            gear_divided_twice,
            Text(
                "The gear ratio is divided by twice. Once takes you from the motor to the wheel.",
                "ギア比で 2 回割っています。モータからタイヤへの変換は 1 回だけです。",
            ),
        ),
        Mistake(
            gear_added,
            Text(
                "gear and counts_per_rev are added. In one turn of the wheel the motor makes gear turns of counts_per_rev "
                "counts each: how many counts is that?",
                "gear と counts_per_rev を足しています。"
                "タイヤが 1 回転する間にモータは gear 回転し、1 回転ごとに counts_per_rev カウント数えます。"
                "全部で何カウントでしょうか。",
            ),
        ),
        Mistake(
            gear_rounded_down,
            Text(
                "The decimals of the gear ratio are cut off. Leave out int(): the Beego's gear is 54.0699.",
                "ギア比の小数部分が切り捨てられています。int() は使いません。Beego のギア比は 54.0699 です。",
            ),
        ),
        Mistake(
            gear_rounded,
            Text(
                "The gear ratio is rounded to a whole number. Use it as given: the Beego's gear is 54.0699.",
                "ギア比が整数に丸められています。渡された値のまま使いましょう。Beego のギア比は 54.0699 です。",
            ),
        ),
        Mistake(
            counts_per_rev_forgotten,
            Text(
                "counts_per_rev is missing: this is the speed of one turn of the motor per sample. How many counts make one turn?",
                "counts_per_rev が抜けていて、1 サンプルにモータが 1 回転するときの速度になっています。"
                "1 回転は何カウントでしょうか。",
            ),
        ),
        Mistake(
            counts_per_rev_multiplied,
            Text(
                "counts_per_rev is multiplied. In Python a / b * c is (a / b) * c: put brackets around the denominator.",
                "counts_per_rev を掛けています。Python では a / b * c は (a / b) * c です。分母を括弧で囲みましょう。",
            ),
        ),
        Mistake(
            both_multiplied,
            Text(
                "gear and counts_per_rev are multiplied instead of divided by: one count would move the robot by kilometres. "
                "The more counts to a turn, the less one of them means.",
                "gear と counts_per_rev で割らずに掛けているため、1 カウントで何 km も進むことになります。"
                "1 回転のカウントが多いほど、1 カウントの意味する量は小さくなります。",
            ),
        ),
        Mistake(
            counts_per_rev_taken_for_pulses,
            Text(
                "The result is a quarter of what it should be: either counts_per_rev is taken for pulses (it is in counts, 4x "
                "decoding included), or a 2 that belongs above the fraction line stands below it.",
                "結果が 1/4 になっています。"
                "counts_per_rev をパルス数とみなしているか(実際は 4 逓倍した後のカウント数です)、"
                "分子にあるべき 2 が分母に入っています。",
            ),
        ),
        Mistake(
            count_taken_for_pulse,
            Text(
                "The result is four times what it should be: this is for one pulse. One count is a quarter of a pulse, and "
                "counts_per_rev is in counts already.",
                "結果が 4 倍で、1 パルス分になっています。1 カウントは 1/4 パルスで、counts_per_rev もすでにカウントの数です。",
            ),
        ),
        Mistake(
            ratio_inverted,
            Text(
                "The ratio is upside down: counts per sample at 1 m/s. Asked for is the speed at one count per sample.",
                "比が逆で、1 m/s のときの 1 サンプルのカウント数になっています。求めるのは 1 サンプル 1 カウントのときの速度です。",
            ),
        ),
        Mistake(
            ratio_inverted_but_dt,
            Text(
                "The distance of one count is upside down: counts per metre over dt. Asked for is the speed at one count per sample.",
                "1 カウントの距離が逆数(1 m あたりのカウント数)になっています。求めるのは 1 サンプル 1 カウントのときの速度です。",
            ),
        ),
        Mistake(
            numbers_of_the_slides,
            Text(
                "The numbers of the i-Cart in the slides are used whatever the arguments say. Use radius, gear and counts_per_rev.",
                "引数に関係なく、スライドの i-Cart の値を使っています。引数 radius, gear, counts_per_rev を使いましょう。",
            ),
        ),
        Mistake(
            numbers_of_the_slides_and_5_ms,
            Text(
                "The result is always the i-Cart's 3 mm/s, whatever the arguments say. Use radius, gear, counts_per_rev and dt.",
                "引数に関係なく、いつも i-Cart の 3 mm/s になっています。引数 radius, gear, counts_per_rev, dt を使いましょう。",
            ),
        ),
        Mistake(
            gear_of_the_slides,
            Text(
                "The gear ratio is always 150, that of the i-Cart in the slides. Use the argument gear: robots differ.",
                "ギア比がいつも 150(スライドの i-Cart の値)になっています。ロボットによって違うので、引数 gear を使いましょう。",
            ),
        ),
        Mistake(
            counts_per_rev_of_the_slides,
            Text(
                "counts_per_rev is always 400, that of the i-Cart in the slides. Use the argument: encoders differ.",
                "counts_per_rev がいつも 400(スライドの i-Cart の値)になっています。エンコーダによって違うので、引数を使いましょう。",
            ),
        ),
        Mistake(
            radius_of_the_slides,
            Text(
                "The radius is always that of the i-Cart in the slides. Use the argument radius: robots differ.",
                "半径がいつもスライドの i-Cart の値になっています。ロボットによって違うので、引数 radius を使いましょう。",
            ),
        ),
        Mistake(
            integer_division,
            Text(
                "The result is 0: // drops the fraction (so do int and rounding), and one count is far less than a metre. "
                "Divide with /.",
                "結果が 0 になっています。// は(int や丸めも)小数部分を捨てます。1 カウントは 1 m よりずっと小さい量です。"
                "/ で割りましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded to 4 decimals. It is small and is multiplied by thousands of counts later: round only "
                "for display.",
                "結果が小数第 4 位までに丸められています。小さな値で、あとで何千カウントも掛けます。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            rounded_coarsely,
            Text(
                "The result is rounded to 3 decimals. It is small and is multiplied by thousands of counts later: round only "
                "for display.",
                "結果が小数第 3 位までに丸められています。小さな値で、あとで何千カウントも掛けます。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            array_returned,
            Text(
                "An array with one entry comes back. Return the number itself.",
                "要素 1 つの配列が返っています。数値そのものを返しましょう。",
            ),
        ),
    ),
)
