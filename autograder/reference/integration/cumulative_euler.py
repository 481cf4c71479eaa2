"""cumulative_euler(y, t, initial=0.0): left rectangles of samples at uneven times (slides 003, and what logs need of it)."""

from itertools import accumulate

import numpy as np

from autograder.exercise import Exercise, Mistake
from autograder.reference.integration.samples import sample_groups
from course.language import Text


def reference(y, t, initial=0.0):
    """Return initial plus the sums of y[k] (t[k+1] - t[k])."""
    steps = [(later - earlier) * height for height, earlier, later in zip(y, t, t[1:], strict=False)]
    return np.array(list(accumulate(steps, initial=float(initial))))


def cases(rng):
    """Draw samples of both signs at uneven times."""
    return sample_groups(rng)


def right_rectangles(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.append(0, np.cumsum(y[1:] * np.diff(t)))


def trapezoids(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.append(0, np.cumsum((y[1:] + y[:-1]) / 2 * np.diff(t)))


def right_rectangles_and_initial_ignored(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return np.append(0, np.cumsum(y[1:] * np.diff(t)))


def first_sample_counted_at_once(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.cumsum(y * np.append(np.diff(t), np.diff(t)[-1:] if len(t) > 1 else 0.0))


def step_of_the_whole_time(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + y * (t - t[0])


def first_height_kept(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + y[0] * (t - t[0])


def initial_ignored(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def initial_in_the_first_place_only(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return np.append(initial, np.cumsum(y[:-1] * np.diff(t)))


def initial_missing_in_the_first_place(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    out = initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))
    out[0] = 0
    return out


def initial_added_at_every_step(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return np.cumsum(np.append(initial, initial + y[:-1] * np.diff(t)))


def initial_added_twice(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return 2 * initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def initial_subtracted(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return np.append(0, np.cumsum(y[:-1] * np.diff(t))) - initial


def initial_multiplied(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial * np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def first_value_left_out(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.cumsum(y[:-1] * np.diff(t))


def first_value_left_out_and_initial_ignored(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return np.cumsum(y[:-1] * np.diff(t))


def last_value_repeated(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    out = initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))
    if len(out) > 1:
        out[-1] = out[-2]
    return out


def last_value_zero(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    out = initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))
    if len(out) > 1:
        out[-1] = 0
    return out


def one_step_late(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    out = initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))
    return np.append(out[0], out[:-1])


def mean_step(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    h = (t[-1] - t[0]) / max(len(t) - 1, 1)
    return initial + np.append(0, np.cumsum(y[:-1] * h * np.ones(len(t) - 1)))


def first_step_for_all(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    h = t[1] - t[0] if len(t) > 1 else 0.0
    return initial + np.append(0, np.cumsum(y[:-1] * h * np.ones(len(t) - 1)))


def first_step_for_all_fails_for_one_sample(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    h = t[1] - t[0]
    return initial + np.append(0, np.cumsum(y[:-1] * h * np.ones(len(t) - 1)))


def last_step_for_all(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    h = t[-1] - t[-2] if len(t) > 1 else 0.0
    return initial + np.append(0, np.cumsum(y[:-1] * h * np.ones(len(t) - 1)))


def step_divided_by_n(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    h = (t[-1] - t[0]) / len(t)
    return initial + np.append(0, np.cumsum(y[:-1] * h * np.ones(len(t) - 1)))


def step_after_used(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    h = np.diff(t)
    return initial + np.append(0, np.cumsum(y[:-1] * np.append(h[1:], h[-1:])))


def step_before_used(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    h = np.diff(t)
    return initial + np.append(0, np.cumsum(y[:-1] * np.append(h[:1], h[:-1])))


def step_forgotten(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.append(0, np.cumsum(y[:-1] * 1.0 * np.ones(len(t) - 1)))


def time_used_as_step(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.append(0, np.cumsum(y[:-1] * t[1:]))


def time_since_the_start_used_as_step(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.append(0, np.cumsum(y[:-1] * (t[1:] - t[0])))


def steps_not_added_up(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.append(0, y[:-1] * np.diff(t))


def only_the_total(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.sum(y[:-1] * np.diff(t))


def total_everywhere(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.sum(y[:-1] * np.diff(t)) * np.ones(len(t))


def area_before_the_first_sample_added(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + y[0] * t[0] + np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def sign_turned_round(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial - np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def heights_made_positive(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    y = abs(y)
    return initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def times_and_values_exchanged(y, t, initial=0.0):
    t, y = np.array(y, dtype=float), np.array(t, dtype=float)
    return initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def derivative(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    out = np.zeros(len(y))
    out[1:] = np.diff(y) / np.diff(t)
    return initial + out


def whole_numbers_cut_off(y, t, initial=0.0):
    out = np.zeros_like(y)
    out[0] = initial
    for k in range(1, len(y)):
        out[k] = out[k - 1] + y[k - 1] * (t[k] - t[k - 1])
    return out


def stamps_in_single_precision(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=np.float32).astype(float)
    return initial + np.append(0, np.cumsum(y[:-1] * np.diff(t)))


def rounded(y, t, initial=0.0):
    y, t = np.array(y, dtype=float), np.array(t, dtype=float)
    return np.round(initial + np.append(0, np.cumsum(y[:-1] * np.diff(t))), 2)


def arrays_only(y, t, initial=0.0):
    return initial + np.append(0, np.cumsum(y[:-1] * (t[1:] - t[:-1])))


EXERCISE = Exercise(
    name="cumulative_euler",
    notebook="odometry/integration",
    points=5,
    parameters=("y", "t", "initial"),
    reference=reference,
    cases=cases,
    examples=(
        (np.array([2.0, 1.0, -1.0, 3.0]), np.array([0.0, 0.5, 0.75, 1.5])),
        (np.array([1.0, 0.5, 0.25]), np.array([10.0, 10.2, 10.6]), -1.0),
    ),
    mistakes=(
        Mistake(
            right_rectangles,
            Text(
                "Each step uses the value at its end. Euler's rule uses the value that is known when the step begins: "
                "y[k] from t[k] to t[k+1].",
                "各歩で終わりの値を使っています。オイラー法では歩の始まりでわかっている値、つまり t[k] から t[k+1] までは y[k] を使います。",
            ),
        ),
        Mistake(
            trapezoids,
            Text(
                "This is the trapezoid rule, the next exercise: it averages both ends of each step. Euler's rule uses "
                "the value at the beginning alone.",
                "これは次の課題の台形公式で、歩の両端の値を平均しています。オイラー法で使うのは始まりの値だけです。",
            ),
        ),
        Mistake(
            right_rectangles_and_initial_ignored,
            Text(
                "Two things at once: each step uses the value at its end instead of its beginning, and initial has no effect.",
                "誤りが 2 つあります。各歩で始まりではなく終わりの値を使っていることと、initial が使われていないことです。",
            ),
        ),
        Mistake(
            first_sample_counted_at_once,
            Text(
                "The first value already holds a step: nothing has been added up at the first sample, so the values "
                "stand one place too early.",
                "最初の値にすでに 1 歩分が入っています。最初のサンプルではまだ何も足していません。値が 1 つずつ前にずれています。",
            ),
        ),
        Mistake(
            step_of_the_whole_time,
            Text(
                "Each y is multiplied by the whole time since the start, as if y had been the same all along. Add up the "
                "steps one by one.",
                "y に最初からの経過時間をそのまま掛けています。y がずっと一定だったことになります。1 歩ずつ足し合わせましょう。",
            ),
        ),
        Mistake(
            first_height_kept,
            Text(
                "Every step has the height of the first sample. Each step uses the y at its own beginning.",
                "どの歩でも最初のサンプルの値を使っています。それぞれの歩では、その歩の始まりの y を使います。",
            ),
        ),
        Mistake(
            initial_ignored,
            Text(
                "initial has no effect. It is where the integral begins, such as the pose at the first stamp: it belongs "
                "to every value.",
                "initial が使われていません。initial は積分の出発点の値(最初の時刻での位置など)で、すべての値に加わります。",
            ),
        ),
        Mistake(
            initial_in_the_first_place_only,
            Text(
                "initial stands in the first place only. What comes later began there as well: it is added to every value.",
                "initial が先頭に入っているだけです。その後の値も同じところから始まっているので、すべての値に足します。",
            ),
        ),
        Mistake(
            initial_missing_in_the_first_place,
            Text(
                "The first value is 0. Nothing has been added up yet there: it is initial.",
                "最初の値が 0 になっています。まだ何も足していないところなので、値は initial そのものです。",
            ),
        ),
        Mistake(
            initial_added_at_every_step,
            Text(
                "initial is added again at every step. It comes in once, at the beginning.",
                "initial が 1 歩ごとに足されています。加えるのは最初の 1 回だけです。",
            ),
        ),
        Mistake(
            initial_added_twice,
            Text(
                "initial is added twice: as the first value and once more to all.",
                "initial が二重に足されています。先頭の値として入れたうえに、全体にもう一度足していませんか。",
            ),
        ),
        Mistake(
            initial_subtracted,
            Text(
                "initial is subtracted. The values begin at initial and go on from there: it is added.",
                "initial を引いています。値は initial から始まって変化していくので、足します。",
            ),
        ),
        Mistake(
            initial_multiplied,
            Text(
                "initial is multiplied with the integral. It is added: with nothing to integrate, the value stays at initial.",
                "initial を積分に掛けています。initial は足すものです。積分する量が 0 なら、値は initial のままです。",
            ),
        ),
        Mistake(
            first_value_left_out,
            Text(
                "The first value is missing: N samples have N - 1 steps between them, but N values are asked for. What "
                "is the value before the first step?",
                "最初の値がありません。N 個のサンプルの間隔は N - 1 個ですが、求める値は N 個です。1 歩目の前の値は何でしょうか。",
            ),
        ),
        Mistake(
            first_value_left_out_and_initial_ignored,
            Text(
                "The first value is missing, and initial has no effect: N values are asked for, and they begin at initial.",
                "最初の値がなく、initial も使われていません。求める値は N 個で、initial から始まります。",
            ),
        ),
        Mistake(
            last_value_repeated,
            Text(
                "The last step is missing: the value before it stands there twice. Where does the loop end?",
                "最後の 1 歩が抜けていて、その前の値が 2 回並んでいます。ループの終わりを確かめましょう。",
            ),
        ),
        Mistake(
            last_value_zero,
            Text(
                "The last value has stayed 0: the loop ends one step too early.",
                "最後の値が 0 のままです。ループが 1 つ早く終わっています。",
            ),
        ),
        Mistake(
            one_step_late,
            Text(
                "The values come one place too late: the first stands there twice and the last is missing. Value k holds "
                "all steps before sample k.",
                "値が 1 つずつ後ろにずれています。最初の値が 2 回並び、最後の値がありません。k 番目の値は、サンプル k までのすべての歩の和です。",
            ),
        ),
        Mistake(
            mean_step,
            Text(
                "Every step has the mean length. The times are uneven, as in a real log: each step has its own, np.diff(t).",
                "どの歩にも時間間隔の平均を使っています。実際のログと同じく、時刻の間隔は一定ではありません。間隔は歩ごとに np.diff(t) で求めます。",
            ),
        ),
        Mistake(
            first_step_for_all,
            Text(
                "Every step has the length of the first. The times are uneven, as in a real log: each step has its own.",
                "どの歩にも最初の時間間隔を使っています。実際のログと同じく、間隔は一定ではありません。歩ごとの間隔を使いましょう。",
            ),
        ),
        Mistake(
            first_step_for_all_fails_for_one_sample,
            Text(
                "Every step has the length of the first, t[1] - t[0]. The times are uneven, as in a real log: each step "
                "has its own (and a single sample has no t[1]).",
                "どの歩にも最初の時間間隔 t[1] - t[0] を使っています。実際のログでは間隔は一定ではないので、歩ごとの間隔を使いましょう。"
                "(サンプルが 1 つのときは t[1] がありません。)",
            ),
        ),
        Mistake(
            last_step_for_all,
            Text(
                "Every step has the length of the last. The times are uneven, as in a real log: each step has its own.",
                "どの歩にも最後の時間間隔を使っています。実際のログと同じく、間隔は一定ではありません。歩ごとの間隔を使いましょう。",
            ),
        ),
        Mistake(
            step_divided_by_n,
            Text(
                "Every step is the whole time divided by N. The times are uneven, each step has its own length; and "
                "between N samples there are N - 1 steps.",
                "どの歩の長さも、全体の時間を N で割ったものになっています。間隔は一定ではないので、歩ごとに求めます。"
                "また、N 個のサンプルの間の歩は N - 1 個です。",
            ),
        ),
        Mistake(
            step_after_used,
            Text(
                "Each step has the length of the one after it. Step k goes from t[k] to t[k+1].",
                "1 つ後の時間間隔を使っています。歩 k は t[k] から t[k+1] までです。",
            ),
        ),
        Mistake(
            step_before_used,
            Text(
                "Each step has the length of the one before it. Step k goes from t[k] to t[k+1].",
                "1 つ前の時間間隔を使っています。歩 k は t[k] から t[k+1] までです。",
            ),
        ),
        Mistake(
            step_forgotten,
            Text(
                "The heights are added without their widths: time has no effect. Check the unit: m/s becomes m only by s.",
                "高さを足しているだけで、時間の幅が掛けられていません。単位で確かめましょう。m/s は s を掛けてはじめて m になります。",
            ),
        ),
        Mistake(
            time_used_as_step,
            Text(
                "Each height is multiplied by the time itself. What is needed is how long the step takes: the difference "
                "of two neighbouring times.",
                "高さに時刻そのものを掛けています。必要なのは 1 歩にかかる時間、つまり隣り合う時刻の差です。",
            ),
        ),
        Mistake(
            time_since_the_start_used_as_step,
            Text(
                "Each height is multiplied by the time since the start. What is needed is how long that one step takes.",
                "高さに最初からの経過時間を掛けています。必要なのは、その 1 歩にかかる時間です。",
            ),
        ),
        Mistake(
            steps_not_added_up,
            Text(
                "Every value holds one step only: the steps are not added up. A value is the one before it plus the step.",
                "それぞれの値に 1 歩分しか入っておらず、累積されていません。値は「1 つ前の値 + その歩の分」です。",
            ),
        ),
        Mistake(
            only_the_total,
            Text(
                "One number comes back, the total. Asked for is the value at every sample, so N of them.",
                "合計の数値 1 つが返っています。求めるのは各サンプルでの値で、N 個あります。",
            ),
        ),
        Mistake(
            total_everywhere,
            Text(
                "Every value is the total. The value at sample k holds only the steps before it.",
                "すべての値が合計になっています。k 番目の値に入るのは、そのサンプルまでの歩だけです。",
            ),
        ),
        Mistake(
            area_before_the_first_sample_added,
            Text(
                "The first step is counted from t = 0: y[0]*t[0] is in every value. What happened before t[0] is not in "
                "the log; the values begin at initial.",
                "最初の歩が t = 0 から数えられていて、すべての値に y[0]*t[0] が入っています。t[0] より前のことはログにはありません。"
                "値は initial から始まります。",
            ),
        ),
        Mistake(
            sign_turned_round,
            Text(
                "The steps are subtracted, or the times are subtracted in the wrong order. While y is positive, the "
                "values must rise.",
                "歩の分を引いています(時刻の差の順序が逆の場合もあります)。y が正の間、値は増えるはずです。",
            ),
        ),
        Mistake(
            heights_made_positive,
            Text(
                "Negative values of y are counted as if positive. While y is negative, the values must fall: leave out abs().",
                "y の負の値が正として足されています。y が負の間、値は減るはずです。abs() は使いません。",
            ),
        ),
        Mistake(
            times_and_values_exchanged,
            Text(
                "y and t are exchanged: the times are integrated over the values. The order of the arguments is (y, t).",
                "y と t が入れ替わり、時刻を y で積分しています。引数の順序は (y, t) です。",
            ),
        ),
        Mistake(
            derivative,
            Text(
                "This divides differences of y by the steps: a derivative. Integrating goes the other way: areas are added up.",
                "y の差を時間間隔で割っていて、微分になっています。積分は逆に、面積を足し合わせます。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With whole numbers the fractions are cut off: an array made like y holds whole numbers only. Make it "
                "with dtype=float.",
                "整数の入力で小数部分が切り捨てられています。y と同じ型で作った配列には整数しか入りません。dtype=float を指定して作りましょう。",
            ),
        ),
        Mistake(
            stamps_in_single_precision,
            Text(
                "Time stamps lose their digits in float32: Unix seconds are kept to two minutes only. Leave t in float64.",
                "時刻を float32 にしたため桁が失われています。Unix 秒では 2 分ほどの精度しか残りません。t は float64 のままにしましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The values are rounded to two decimals. Round only when you print.",
                "値が小数第 2 位に丸められています。丸めるのは表示するときだけにしましょう。",
            ),
        ),
        Mistake(
            arrays_only,
            Text(
                "It works with arrays but not with lists: lists cannot be subtracted from each other, or multiplied with "
                "each other. Begin with np.array(..., dtype=float).",
                "配列では動きますが、リストでは動きません。リストどうしの引き算や掛け算はできません。最初に np.array(…, dtype=float) で配列にしましょう。",
            ),
        ),
    ),
)
