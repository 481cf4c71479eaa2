"""displacement(velocity, yaw_rate, dt): (u, v, phi) of the slides, overview 3-4: what a wheeled robot moves in one step."""

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS


def reference(velocity, yaw_rate, dt):
    """Return (V dt, 0, omega dt)."""
    return np.multiply((velocity, 0.0, yaw_rate), dt)


def cases(rng):
    """Draw speeds and yaw rates of all signs; dt from a few milliseconds to a second."""

    def motion(sign, turn_sign):
        return sign * rng.uniform(0.3, 1.5), turn_sign * rng.uniform(1.7, 2.9)

    def step():
        return rng.uniform(0.02, 0.2)

    speed, rate = rng.choice([2, 3, 4]), rng.choice([5, 6, 7])
    straight, spot = (-rng.uniform(0.3, 1.5), 0.0, step()), (0.0, -rng.uniform(1.7, 2.9), step())
    return [
        Group(Text("forward, turning left", "前進しながら左旋回"), 3, [(*motion(1, 1), step()) for _ in range(3)]),
        Group(Text("forward, turning right", "前進しながら右旋回"), 1, [(*motion(1, -1), step()) for _ in range(2)]),
        Group(Text("reversing", "後退"), 2, [(*motion(-1, 1), step()), (*motion(-1, -1), step())]),
        Group(Text("long steps", "長い周期"), 1, [(*motion(sign, -sign), rng.uniform(0.4, 0.9)) for sign in (-1, 1)]),
        Group(
            Text("short steps", "短い周期"),
            1,
            [(sign * 0.7, sign * rng.uniform(0.5, 1.2), rng.uniform(0.006, 0.009)) for sign in (-1, 1)],
        ),
        Group(Text("whole numbers", "整数の入力"), 1, [(-speed, rate, 3), (speed, -rate, step())]),
        Group(Text("straight, on the spot, at rest", "直進・その場旋回・停止"), 1, [straight, spot, (0, 0, step())]),
    ]


def dt_forgotten(velocity, yaw_rate, dt):
    return np.array([velocity, 0.0, yaw_rate])


def dt_forgotten_in_phi(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, yaw_rate])


def dt_forgotten_in_u(velocity, yaw_rate, dt):
    return np.array([velocity, 0.0, yaw_rate * dt])


def divided_by_dt(velocity, yaw_rate, dt):
    return np.array([velocity / dt, 0.0, yaw_rate / dt])


def dt_squared(velocity, yaw_rate, dt):
    return np.array([velocity * dt**2, 0.0, yaw_rate * dt**2])


def half_dt_squared(velocity, yaw_rate, dt):
    return np.array([velocity * dt**2 / 2, 0.0, yaw_rate * dt**2 / 2])


def dt_added(velocity, yaw_rate, dt):
    return np.array([velocity + dt, 0.0, yaw_rate + dt])


def half_a_step(velocity, yaw_rate, dt):
    return np.array([velocity * dt / 2, 0.0, yaw_rate * dt / 2])


def half_the_turn(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, yaw_rate * dt / 2])


def dt_in_milliseconds(velocity, yaw_rate, dt):
    return np.array([velocity * dt * 1000, 0.0, yaw_rate * dt * 1000])


def dt_taken_for_milliseconds(velocity, yaw_rate, dt):
    return np.array([velocity * dt / 1000, 0.0, yaw_rate * dt / 1000])


def always_10_milliseconds(velocity, yaw_rate, dt):
    return np.array([velocity * 0.01, 0.0, yaw_rate * 0.01])


def always_5_milliseconds(velocity, yaw_rate, dt):
    return np.array([velocity * 0.005, 0.0, yaw_rate * 0.005])


def u_and_phi_exchanged(velocity, yaw_rate, dt):
    return np.array([yaw_rate * dt, 0.0, velocity * dt])


def turn_in_the_second_place(velocity, yaw_rate, dt):
    return np.array([velocity * dt, yaw_rate * dt, 0.0])


def never_backwards(velocity, yaw_rate, dt):
    return np.array([max(velocity * dt, 0), 0.0, yaw_rate * dt])


def forward_in_the_second_place(velocity, yaw_rate, dt):
    return np.array([0.0, velocity * dt, yaw_rate * dt])


def forward_in_both_places(velocity, yaw_rate, dt):
    return np.array([velocity * dt, velocity * dt, yaw_rate * dt])


def turn_in_both_places(velocity, yaw_rate, dt):
    return np.array([velocity * dt, yaw_rate * dt, yaw_rate * dt])


def rotated_by_the_turn(velocity, yaw_rate, dt):
    return np.array([velocity * dt * np.cos(yaw_rate * dt), velocity * dt * np.sin(yaw_rate * dt), yaw_rate * dt])


def end_of_the_arc(velocity, yaw_rate, dt):
    turn = yaw_rate * dt
    chord = velocity * dt * np.sinc(turn / (2 * np.pi))
    return np.array([chord * np.cos(turn / 2), chord * np.sin(turn / 2), turn])


def chord_of_the_arc(velocity, yaw_rate, dt):
    return np.array([velocity * dt * np.sinc(yaw_rate * dt / (2 * np.pi)), 0.0, yaw_rate * dt])


def speed_times_yaw_rate(velocity, yaw_rate, dt):
    return np.array([velocity * dt, velocity * yaw_rate * dt, yaw_rate * dt])


def sideways_drift_of_a_small_turn(velocity, yaw_rate, dt):
    return np.array([velocity * dt, velocity * yaw_rate * dt**2, yaw_rate * dt])


def one_in_the_second_place(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 1.0, yaw_rate * dt])


def dt_in_the_second_place(velocity, yaw_rate, dt):
    return np.array([velocity * dt, dt, yaw_rate * dt])


def turn_in_degrees(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, np.rad2deg(yaw_rate * dt)])


def turn_taken_for_degrees(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, np.deg2rad(yaw_rate * dt)])


def still_without_speed(velocity, yaw_rate, dt):
    if velocity == 0:
        return np.zeros(3)
    return np.array([velocity * dt, 0.0, yaw_rate * dt])


def turn_from_speed(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, velocity * yaw_rate * dt])


def turn_by_speed_alone(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, velocity * dt])


def turn_subtracted(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, -yaw_rate * dt])


def backwards(velocity, yaw_rate, dt):
    return np.array([-velocity * dt, 0.0, yaw_rate * dt])


def always_forward(velocity, yaw_rate, dt):
    return np.array([abs(velocity) * dt, 0.0, yaw_rate * dt])


def always_to_the_left(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, abs(yaw_rate) * dt])


def turn_wrapped(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, (yaw_rate * dt + np.pi) % (2 * np.pi) - np.pi])


def turn_left_out(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0.0, 0.0])


def zero_left_out(velocity, yaw_rate, dt):
    return np.array([velocity * dt, yaw_rate * dt])


def u_alone(velocity, yaw_rate, dt):
    return velocity * dt


def decimals_cut_off(velocity, yaw_rate, dt):
    return np.array([velocity * dt, 0, yaw_rate * dt], dtype=int)


def whole_numbers_cut_off(velocity, yaw_rate, dt):
    motion = np.array([velocity, 0, yaw_rate])
    motion[0], motion[2] = velocity * dt, yaw_rate * dt
    return motion


def rounded(velocity, yaw_rate, dt):
    return np.round([velocity * dt, 0.0, yaw_rate * dt], 3)


def column_returned(velocity, yaw_rate, dt):
    return np.array([[velocity * dt], [0.0], [yaw_rate * dt]])


def row_in_a_table(velocity, yaw_rate, dt):
    return np.array([[velocity * dt, 0.0, yaw_rate * dt]])


EXERCISE = Exercise(
    name="displacement",
    notebook="odometry/pose_update",
    points=5,
    parameters=("velocity", "yaw_rate", "dt"),
    quantities=("u", "v", "phi"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    examples=((0.5, 0.3, 0.1), (-0.4, 1.2, 0.005)),
    mistakes=(
        Mistake(
            dt_forgotten_in_phi,
            Text(
                "phi is the yaw rate itself, in rad/s. The turn in one step is an angle in rad: where does dt come in?",
                "phi が角速度 [rad/s] のままになっています。1 周期で回る角度 [rad] を求めるには、dt はどこに入りますか。",
            ),
        ),
        Mistake(
            dt_forgotten_in_u,
            Text(
                "u is the speed itself, in m/s. The way made in one step is a length in m: where does dt come in?",
                "u が速度 [m/s] のままになっています。1 周期で進む距離 [m] を求めるには、dt はどこに入りますか。",
            ),
        ),
        Mistake(
            dt_forgotten,
            Text(
                "These are the speed and the yaw rate themselves, per second. The displacement is what happens in one step: "
                "where does dt come in?",
                "速度と角速度がそのまま返っています。これらは 1 秒あたりの値です。求めるのは 1 周期の移動量です。"
                "dt はどこに入りますか。",
            ),
        ),
        Mistake(
            divided_by_dt,
            Text(
                "You divide by dt. Check the units: m/s divided by s is no length.",
                "dt で割っています。単位を確かめましょう。m/s を s で割っても長さにはなりません。",
            ),
        ),
        Mistake(
            dt_squared,
            Text(
                "dt is multiplied in twice. Check the units: m/s times s is a length already.",
                "dt を 2 回掛けています。単位を確かめましょう。m/s に s を 1 回掛ければ、もう長さになります。",
            ),
        ),
        Mistake(
            half_dt_squared,
            Text(
                "This is the formula for a constant acceleration, with dt^2/2. V and omega are speeds, not accelerations.",
                "dt²/2 を掛けるのは等加速度運動の式です。V と omega は加速度ではなく、速度と角速度です。",
            ),
        ),
        Mistake(
            dt_added,
            Text(
                "dt is added to the speeds. A time cannot be added to a speed: check the units.",
                "速度に dt を足しています。時間と速度は足し算できません。単位を確かめましょう。",
            ),
        ),
        Mistake(
            half_a_step,
            Text(
                "What comes out is half of what it should be. The whole step of length dt is asked for; the half belongs to "
                "the mean of two wheel speeds.",
                "値が半分になっています。ここで求めるのは 1 周期 dt の全体です。"
                "1/2 が出てくるのは、左右の車輪の速度を平均するときです。",
            ),
        ),
        Mistake(
            half_the_turn,
            Text(
                "phi is half of what it should be. The half of the midpoint rule comes later, where the heading is used; phi "
                "is the whole turn.",
                "phi が半分の値です。中点則の 1/2 は、あとで方位を使うときに出てきます。phi は 1 周期で回る角度の全体です。",
            ),
        ),
        Mistake(
            dt_in_milliseconds,
            Text(
                "The result is 1000 times too large. Was dt turned into milliseconds, or a length into millimetres? The "
                "course computes in s and m.",
                "結果が 1000 倍です。dt をミリ秒に、または長さを mm に直していませんか。この講義では s と m で計算します。",
            ),
        ),
        Mistake(
            dt_taken_for_milliseconds,
            Text(
                "The result is 1000 times too small. Was dt taken for milliseconds, or a speed for mm/s? They are in s and "
                "m/s already.",
                "結果が 1/1000 です。dt をミリ秒、または速度を mm/s とみなして割っていませんか。すでに s と m/s です。",
            ),
        ),
        Mistake(
            always_10_milliseconds,
            Text(
                "The result is the same whatever dt is: 0.01 s is written into the function. Use the argument dt.",
                "dt を変えても結果が変わりません。関数の中に 0.01 秒と書き込まれています。引数の dt を使いましょう。",
            ),
        ),
        Mistake(
            always_5_milliseconds,
            Text(
                "The result is the same whatever dt is: 0.005 s is written into the function. Use the argument dt.",
                "dt を変えても結果が変わりません。関数の中に 0.005 秒と書き込まれています。引数の dt を使いましょう。",
            ),
        ),
        Mistake(
            u_and_phi_exchanged,
            Text(
                "The turn stands where u belongs. The order is (u, v, phi): forward, sideways, turn.",
                "u のところに回転量が入っています。順序は (u, v, phi)、つまり前方向、横方向、回転です。",
            ),
        ),
        Mistake(
            turn_in_the_second_place,
            Text(
                "The turn stands in the second place. The order is (u, v, phi): which of the three is the sideways part, and "
                "what is it for a robot on wheels?",
                "2 番目に回転量が入っています。順序は (u, v, phi) です。"
                "横方向の移動量はどれで、車輪型ロボットではいくらになりますか。",
            ),
        ),
        Mistake(
            never_backwards,
            Text(
                "A robot that reverses stands still: negative speeds are replaced by 0. A negative u is a step backwards.",
                "後退のとき止まっています。負の速度が 0 に置き換えられています。u が負なら後退です。",
            ),
        ),
        Mistake(
            forward_in_the_second_place,
            Text(
                "The way forward stands in the second place. The order is (u, v, phi): u is forward, v sideways.",
                "2 番目に前方向の移動量が入っています。順序は (u, v, phi) で、u が前方向、v が横方向です。",
            ),
        ),
        Mistake(
            forward_in_both_places,
            Text(
                "v is as large as u. v is the way sideways: can a robot on two wheels slide to the side?",
                "v が u と同じ値になっています。v は横方向の移動量です。2 輪のロボットは真横に滑れるでしょうか。",
            ),
        ),
        Mistake(
            turn_in_both_places,
            Text(
                "v is as large as phi. v is the way sideways, a length: can a robot on two wheels slide to the side?",
                "v が phi と同じ値になっています。v は横方向の移動量(長さ)です。2 輪のロボットは真横に滑れるでしょうか。",
            ),
        ),
        Mistake(
            rotated_by_the_turn,
            Text(
                "The displacement was turned by phi already. In overview 3 u and v are measured in the robot's axes before "
                "the step; turning comes later, and by the heading.",
                "移動量をすでに phi だけ回転しています。概要 #3 の u と v は、動く前のロボットの座標で測ったものです。"
                "回転はあとで、方位を使って行います。",
            ),
        ),
        Mistake(
            end_of_the_arc,
            Text(
                "This is the end of a circular arc. Overview 3 has the simpler step straight ahead; the arc is an exercise of "
                "its own later.",
                "円弧の終点の式になっています。概要 #3 はもっと簡単な、まっすぐ前へ進む 1 歩です。円弧はあとの課題で扱います。",
            ),
        ),
        Mistake(
            chord_of_the_arc,
            Text(
                "u is the chord of a circular arc. Overview 3 takes the length of the way itself; the arc is an exercise of "
                "its own later.",
                "u が円弧の弦の長さになっています。概要 #3 の u は進んだ道のりそのものです。円弧はあとの課題で扱います。",
            ),
        ),
        Mistake(
            speed_times_yaw_rate,
            Text(
                "v contains V times omega. That is an acceleration, felt in a curve; it moves nothing to the side in the "
                "robot's own axes.",
                "v に V×omega が入っています。これはカーブで感じる加速度で、ロボット自身の座標で横へ動くわけではありません。",
            ),
        ),
        Mistake(
            sideways_drift_of_a_small_turn,
            Text(
                "v contains u times phi, the way sideways for a small turn. In overview 3 u and v are measured in the axes "
                "before the step, and the wheels do not slide sideways.",
                "v に u×phi(小さな旋回での横ずれ)が入っています。概要 #3 では動く前の座標で測り、車輪は横に滑らないとします。",
            ),
        ),
        Mistake(
            one_in_the_second_place,
            Text(
                "v is 1, so the robot would slide a metre sideways in every step. What is the sideways motion of a robot on "
                "wheels?",
                "v が 1 になっています。これでは 1 周期ごとに 1 m も横に滑ってしまいます。"
                "車輪型ロボットの横方向の移動量はいくらですか。",
            ),
        ),
        Mistake(
            dt_in_the_second_place,
            Text(
                "dt stands in the second place. The order is (u, v, phi), and v is a length: the way sideways.",
                "2 番目に dt が入っています。順序は (u, v, phi) で、v は横方向の移動量(長さ)です。",
            ),
        ),
        Mistake(
            turn_in_degrees,
            Text(
                "phi is in degrees. The course computes in rad; yaw_rate is in rad/s already.",
                "phi が度になっています。この講義では rad で計算します。yaw_rate はすでに rad/s です。",
            ),
        ),
        Mistake(
            turn_taken_for_degrees,
            Text(
                "phi is converted as if yaw_rate were in degrees per second. It is in rad/s already.",
                "yaw_rate を度毎秒とみなして変換しています。yaw_rate はすでに rad/s です。",
            ),
        ),
        Mistake(
            still_without_speed,
            Text(
                "With speed 0 nothing moves at all. A robot can turn on the spot: the turn does not depend on the speed.",
                "速度が 0 のとき、まったく動いていません。ロボットはその場でも回れます。旋回量は速度とは関係ありません。",
            ),
        ),
        Mistake(
            turn_from_speed,
            Text(
                "phi contains the speed as well. The turn in one step depends on the yaw rate and dt alone.",
                "phi に速度も掛けられています。1 周期で回る角度を決めるのは、角速度と dt だけです。",
            ),
        ),
        Mistake(
            turn_by_speed_alone,
            Text(
                "phi is computed from the speed instead of the yaw rate; both lines use the same variable.",
                "phi が角速度ではなく速度から計算されています。2 つの式に同じ変数を使っていませんか。",
            ),
        ),
        Mistake(
            turn_subtracted,
            Text(
                "phi has the wrong sign. A positive yaw rate makes the heading grow.",
                "phi の符号が逆です。角速度が正なら、方位は増えます。",
            ),
        ),
        Mistake(
            backwards,
            Text(
                "u has the wrong sign. A positive speed is a step forward.",
                "u の符号が逆です。速度が正なら前進です。",
            ),
        ),
        Mistake(
            always_forward,
            Text(
                "A robot that reverses gets a step forward: the sign of the speed is lost.",
                "後退しているのに前進になっています。速度の符号が失われています。",
            ),
        ),
        Mistake(
            always_to_the_left,
            Text(
                "Every turn becomes a turn to the left: the sign of the yaw rate is lost.",
                "どちらに回っても左旋回になっています。角速度の符号が失われています。",
            ),
        ),
        Mistake(
            turn_wrapped,
            Text(
                "phi is wrapped to -pi..pi. It is the change of heading, and a large one must stay large: no modulo.",
                "phi が -π〜π に折り返されています。phi は方位の変化量で、大きな値はそのまま残さなければなりません。"
                "剰余はとりません。",
            ),
        ),
        Mistake(
            turn_left_out,
            Text(
                "phi is always 0. The robot turns while it moves: what does the yaw rate do in one step?",
                "phi がいつも 0 です。ロボットは進みながら回ります。角速度は 1 周期で何を変えますか。",
            ),
        ),
        Mistake(
            zero_left_out,
            Text(
                "Only two numbers come back. The displacement has three, (u, v, phi); the one that does not change must be "
                "there too.",
                "数が 2 つしか返っていません。移動量は (u, v, phi) の 3 つです。動かない方向の成分も省かずに入れましょう。",
            ),
        ),
        Mistake(
            u_alone,
            Text(
                "Only the way forward comes back, one number. The displacement has three: (u, v, phi).",
                "前方向の移動量だけ、1 個の数値が返っています。移動量は (u, v, phi) の 3 つです。",
            ),
        ),
        Mistake(
            decimals_cut_off,
            Text(
                "The decimals are cut off. In one step a robot moves millimetres: an array of integers cannot hold them.",
                "小数部分が切り捨てられています。1 周期で動くのは数 mm です。整数の配列には入りません。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With whole numbers as speeds the decimals are cut off: the array was made from integers and holds integers "
                "only. Make it with dtype=float.",
                "速度が整数のとき、小数部分が切り捨てられます。整数から作った配列には整数しか入りません。"
                "dtype=float で作りましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded. A step is a few millimetres, and thousands of them are added up: round only for display.",
                "結果が丸められています。1 周期の移動は数 mm で、それを何千回も足し合わせます。"
                "丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            column_returned,
            Text(
                "The result is a column, shape (3, 1). Three numbers in a row are asked for, shape (3,): leave out the inner "
                "brackets.",
                "結果が形状 (3, 1) の縦ベクトルになっています。求める形状は (3,) です。内側のかっこを外しましょう。",
            ),
        ),
        Mistake(
            row_in_a_table,
            Text(
                "The result has one pair of brackets too many, shape (1, 3). Three numbers are asked for, shape (3,).",
                "かっこが 1 組多く、形状が (1, 3) になっています。求める形状は (3,) です。",
            ),
        ),
    ),
)
