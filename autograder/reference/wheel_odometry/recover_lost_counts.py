"""recover_lost_counts(time, counts, period): a row after a gap stands for the cycles that are missing before it (real robots' logs)."""

from itertools import pairwise

import numpy as np

from autograder.draws import until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(time, counts, period):
    """Return each row's counts times its cycles: those from the start, rounded step by step, never fewer than one."""
    cycles = [1]
    for before, now in pairwise(time):
        cycles.append(max(1, int(np.floor((now - before) / period + 0.5))))
    return np.array([count * times for count, times in zip(counts, cycles, strict=True)], dtype=float)


def cases(rng):
    """Draw logs with gaps of one to thirty cycles; no step comes within a tenth of a cycle of being halfway between two numbers."""

    def log(cycles, period=None, start=None):
        """Return a log whose rows are `cycles` apart, the first at any time, stamps straying by up to 0.4 cycles."""
        period = rng.choice([0.005, 0.01, 0.02]) if period is None else period
        stray = rng.uniform(0.1, 0.38, len(cycles)) * rng.choice([-1, 1], len(cycles))
        start = rng.uniform(3, 60) if start is None else start
        time = start + period * np.append(0, np.cumsum(cycles + stray))
        return time, counts(len(time)), float(period)

    def unlike_a_grid(time, _, period):
        """Are cycles that are counted from the start unlike those that are counted step by step?"""
        steps = np.diff(time) / period
        return np.any(np.rint(steps) != np.diff(np.rint((time - time[0]) / period)))

    def counts(rows):
        return rng.integers(20, 200, rows) * rng.choice([-1.0, 1.0], rows)

    def gaps(rows):
        """Return as many steps: half of them of one cycle, the rest larger, in any order."""
        large = rng.choice([2, 2, 3, 4], rows // 2)
        return rng.permutation(np.append(np.ones(rows - rows // 2, int), large))

    def early():
        """Return a log with stamps that follow the one before within less than half a cycle."""
        time, _, period = log(gaps(6))
        late = rng.uniform(0.1, 0.35, 2) * period
        time = np.concatenate([time[:3], [time[2] + late[0]], time[3:], [time[-1] + late[1]]])
        return time, counts(len(time)), period

    mostly = log(rng.permutation([2, 2, 3, 2, 1, 2]))
    whole = np.cumsum([rng.integers(50, 90), *(rng.permutation([1, 2, 3, 1]) * 10)]), rng.integers(20, 200, 5), 10
    listed = log(gaps(5))
    return [
        Group(Text("gaps of a few cycles", "数周期の抜け"), 3, [until(lambda: log(gaps(8)), unlike_a_grid), log(gaps(7))]),
        Group(Text("most cycles lost", "ほとんどの周期が抜けたログ"), 1, [mostly]),
        Group(Text("a long gap", "長い抜け"), 1, [log(rng.permutation([1, 1, 2, rng.integers(20, 34), 1]))]),
        Group(Text("rows less than half a cycle apart", "間隔が周期の半分に満たない行"), 1, [early()]),
        Group(Text("Unix time", "Unix時間"), 1, [log(gaps(6), start=rng.uniform(1.6e9, 1.8e9))]),
        Group(Text("one row or two", "1行または2行"), 1, [log(np.array([], int)), log(np.array([rng.integers(2, 5)]))]),
        Group(Text("lists", "リスト"), 1, [(listed[0].tolist(), listed[1].tolist(), listed[2])]),
        Group(Text("whole numbers", "整数の入力"), 1, [whole]),
    ]


EXAMPLE = (np.array([0.0, 0.005, 0.0148, 0.0201]), np.array([30.0, 31.0, 29.0, 30.0]), 0.005)
EXAMPLE_ONE_ROW = (np.array([12.5]), np.array([-40.0]), 0.01)


def counts_left_alone(time, counts, period):
    return np.asarray(counts, dtype=float)


def cycles_rounded_down(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.maximum(np.append(1, np.floor(np.diff(t) / period)), 1)


def cycles_rounded_up(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.ceil(np.diff(t) / period))


def cycles_not_rounded(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.diff(t) / period)


def cycles_not_rounded_at_least_one(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.maximum(np.diff(t) / period, 1))


def fewer_than_one_cycle(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.rint(np.diff(t) / period))


def only_lost_cycles_counted(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.maximum(np.rint(np.diff(t) / period) - 1, 0))


def one_cycle_too_many(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.maximum(np.rint(np.diff(t) / period), 1) + 1)


def a_gap_taken_for_two_cycles(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.where(np.rint(np.diff(t) / period) > 1, 2, 1))


def long_gaps_left_alone(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    n = np.rint(np.diff(t) / period)
    return c * np.append(1, np.where((n > 1) & (n < 10), n, 1))


def first_row_without_counts(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(0, np.maximum(np.rint(np.diff(t) / period), 1))


def first_row_left_out(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c[1:] * np.maximum(np.rint(np.diff(t) / period), 1)


def cycles_of_the_next_gap(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(np.maximum(np.rint(np.diff(t) / period), 1), 1)


def cycles_of_the_first_step_for_the_first_row(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    n = np.maximum(np.rint(np.diff(t) / period), 1)
    return c * np.append(n[0], n)


def counts_divided_by_the_cycles(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c / np.append(1, np.maximum(np.rint(np.diff(t) / period), 1))


def lost_cycles_added(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c + np.append(1, np.maximum(np.rint(np.diff(t) / period), 1)) - 1


def median_step_taken_for_period(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    p = np.median(np.diff(t)) if len(t) > 1 else period
    return c * np.append(1, np.maximum(np.rint(np.diff(t) / p), 1))


def stamps_in_float32(time, counts, period):
    t, c = np.asarray(time, dtype=np.float32), np.asarray(counts, dtype=float)
    return c * np.append(1, np.maximum(np.rint(np.diff(t) / period), 1))


def mean_step_taken_for_period(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    p = np.mean(np.diff(t)) if len(t) > 1 else period
    return c * np.append(1, np.maximum(np.rint(np.diff(t) / p), 1))


def shortest_step_taken_for_period(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    p = np.min(np.diff(t)) if len(t) > 1 else period
    return c * np.append(1, np.maximum(np.rint(np.diff(t) / p), 1))


def period_of_5_ms_assumed(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.maximum(np.rint(np.diff(t) / 0.005), 1))


def all_counts_scaled_alike(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    n = np.rint((t[-1] - t[0]) / period)
    return c * (n / (len(t) - 1) if len(t) > 1 else 1)


def cycles_returned(time, counts, period):
    t = np.asarray(time, dtype=float)
    return np.append(1, np.maximum(np.rint(np.diff(t) / period), 1))


def rates_returned(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c / np.append(period, np.diff(t))


def counts_summed_up(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return np.cumsum(c * np.append(1, np.maximum(np.rint(np.diff(t) / period), 1)))


def rows_inserted(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    n = np.append(1, np.maximum(np.rint(np.diff(t) / period), 1)).astype(int)
    return np.repeat(c, n)


def sign_lost(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return np.abs(c) * np.append(1, np.maximum(np.rint(np.diff(t) / period), 1))


def arrays_only(time, counts, period):
    return counts * np.append(1, np.maximum(np.rint((time[1:] - time[:-1]) / period), 1))


def period_multiplied(time, counts, period):
    t, c = np.asarray(time, dtype=float), np.asarray(counts, dtype=float)
    return c * np.append(1, np.maximum(np.rint(np.diff(t) * period), 1))


EXERCISE = Exercise(
    name="recover_lost_counts",
    notebook="odometry/wheel_odometry",
    points=5,
    parameters=("time", "counts", "period"),
    reference=reference,
    cases=cases,
    examples=(EXAMPLE, EXAMPLE_ONE_ROW),
    mistakes=(
        Mistake(
            counts_left_alone,
            Text(
                "The counts come back as they were. A row after a gap stands for all the cycles that are missing before it: multiply it by their number.",
                "カウントがそのまま返っています。抜けの後の行は、抜けた周期の分も代表しています。周期の数を掛けましょう。",
            ),
        ),
        Mistake(
            cycles_rounded_down,
            Text(
                "The number of cycles is cut off, not rounded: int(), floor and // make 1 of 1.9. Stamps stray a little, so take the nearest whole number.",
                "周期の数を四捨五入せず切り捨てています。int()、floor、//では1.9が1になります。時刻は少しばらつくので、最も近い整数にしましょう。",
            ),
        ),
        Mistake(
            cycles_rounded_up,
            Text(
                "The number of cycles is rounded up: 1.1 becomes 2. Take the nearest whole number.",
                "周期の数を切り上げています。1.1が2になってしまいます。最も近い整数にしましょう。",
            ),
        ),
        Mistake(
            cycles_not_rounded,
            Text(
                "The number of cycles is not rounded. The jitter of the stamps then goes into the way; cycles are whole.",
                "周期の数を丸めていません。時刻のばらつきがそのまま距離に入ります。周期の数は整数です。",
            ),
        ),
        Mistake(
            cycles_not_rounded_at_least_one,
            Text(
                "The number of cycles is kept at 1 or more, but not rounded. The jitter of the stamps then goes into the way; cycles are whole.",
                "周期の数は1以上になっていますが、丸めていません。時刻のばらつきがそのまま距離に入ります。周期の数は整数です。",
            ),
        ),
        Mistake(
            fewer_than_one_cycle,
            Text(
                "A row that follows close upon the one before gets 0 cycles, and its counts vanish. They were counted: at least 1.",
                "直前の行との間隔が短い行で周期の数が0になり、カウントが消えています。実際に数えた値なので、少なくとも1にしましょう。",
            ),
        ),
        Mistake(
            only_lost_cycles_counted,
            Text(
                "The counts are multiplied by the number of lost cycles alone. The row's own cycle counts too.",
                "失われた周期の数だけを掛けています。その行自身の周期も含めましょう。",
            ),
        ),
        Mistake(
            one_cycle_too_many,
            Text(
                "The counts are multiplied by one cycle too many. A step of one period is one cycle: nothing is missing there.",
                "掛ける周期の数が1つ多くなっています。間隔がちょうど1周期なら抜けはなく、周期の数は1です。",
            ),
        ),
        Mistake(
            a_gap_taken_for_two_cycles,
            Text(
                "Every gap is taken for one lost cycle. A gap may be longer: compute how many cycles it spans.",
                "抜けをすべて1周期分とみなしています。もっと長い抜けもあるので、何周期分かを計算しましょう。",
            ),
        ),
        Mistake(
            long_gaps_left_alone,
            Text(
                "Long gaps are left as they are. However long a gap is, its row stands for all of its cycles.",
                "長い抜けがそのままになっています。どれほど長くても、その行は抜けたすべての周期を代表しています。",
            ),
        ),
        Mistake(
            first_row_without_counts,
            Text(
                "The first row is set to 0. No gap is known before it: it counts for 1 cycle.",
                "最初の行が0になっています。それより前の抜けは分からないので、1周期として扱いましょう。",
            ),
        ),
        Mistake(
            first_row_left_out,
            Text(
                "The first row is missing. There are as many values as rows; the first counts for 1 cycle.",
                "最初の行がありません。行と同じ数の値を返し、最初の行は1周期として扱いましょう。",
            ),
        ),
        Mistake(
            cycles_of_the_next_gap,
            Text(
                "Each row is multiplied by the cycles after it. A row holds what was counted before its stamp: its gap is the one before it.",
                "各行に、その後の間隔の周期数を掛けています。各行は直前の区間を数えたものなので、前の間隔を使いましょう。",
            ),
        ),
        Mistake(
            cycles_of_the_first_step_for_the_first_row,
            Text(
                "The first row is multiplied by the cycles of the second. Nothing is known of the time before it, so it counts for 1; a log of one row has no second.",
                "最初の行に2行目の周期数を掛けています。最初の行より前のことは分からないので1とします。1行だけのログには2行目がありません。",
            ),
        ),
        Mistake(
            counts_divided_by_the_cycles,
            Text(
                "The counts are divided by the number of cycles. The increments of the lost cycles are missing from the file, so the row must grow: multiply.",
                "カウントを周期の数で割っています。抜けた周期の増分はファイルにないので、その分を増やす必要があります。掛けましょう。",
            ),
        ),
        Mistake(
            lost_cycles_added,
            Text(
                "The number of lost cycles is added to the counts. Each lost cycle had about as many counts as this row: multiply.",
                "抜けた周期の数を足しています。抜けた周期でも1周期あたり同じくらいカウントされたはずなので、掛けましょう。",
            ),
        ),
        Mistake(
            median_step_taken_for_period,
            Text(
                "The cycles are counted with the median of the steps. Where most cycles are lost that is no single cycle: use period.",
                "間隔の中央値を周期とみなしています。抜けが多いログでは中央値は1周期になりません。引数periodを使いましょう。",
            ),
        ),
        Mistake(
            stamps_in_float32,
            Text(
                "The stamps are kept in float32, which has seven digits: in Unix seconds no gap can be seen any more. Keep time in float64.",
                "時刻をfloat32で扱っています。有効桁数が7桁なので、Unix時間では抜けが見えなくなります。時刻はfloat64のままにしましょう。",
            ),
        ),
        Mistake(
            mean_step_taken_for_period,
            Text(
                "The cycles are counted with the mean of the steps, which the gaps have made too long: use period.",
                "間隔の平均を周期とみなしています。平均は抜けの分だけ長くなるので、引数periodを使いましょう。",
            ),
        ),
        Mistake(
            shortest_step_taken_for_period,
            Text(
                "The cycles are counted with the shortest of the steps. Jitter makes that one too short: use period.",
                "最短の間隔を周期とみなしています。ばらつきのため短すぎることがあるので、引数periodを使いましょう。",
            ),
        ),
        Mistake(
            period_of_5_ms_assumed,
            Text(
                "The cycles are counted with 5 ms, whatever period says. Robots differ: use period.",
                "periodによらず5 msで周期を数えています。周期はロボットごとに違うので、引数を使いましょう。",
            ),
        ),
        Mistake(
            all_counts_scaled_alike,
            Text(
                "All counts are multiplied by one factor. Only the rows after a gap lack something.",
                "すべての行に同じ倍率を掛けています。足りないのは抜けの直後の行だけです。",
            ),
        ),
        Mistake(
            cycles_returned,
            Text(
                "The numbers of cycles come back. Multiply each row's counts by them.",
                "周期の数が返っています。各行のカウントに掛けましょう。",
            ),
        ),
        Mistake(
            rates_returned,
            Text(
                "Counts per second come back. Asked for are counts: each row's times the number of its cycles.",
                "1秒あたりのカウントが返っています。求めるのはカウントで、各行の値に周期の数を掛けたものです。",
            ),
        ),
        Mistake(
            counts_summed_up,
            Text(
                "The counts are summed up. Each row keeps its own increment.",
                "カウントを累積しています。各行の増分のまま返しましょう。",
            ),
        ),
        Mistake(
            rows_inserted,
            Text(
                "Rows are inserted for the lost cycles. The log keeps its rows: the one after a gap is multiplied instead.",
                "抜けた周期の行を挿入しています。行数は変えず、抜けの直後の行に周期の数を掛けましょう。",
            ),
        ),
        Mistake(
            sign_lost,
            Text(
                "The sign of the counts is lost. A wheel that turns back has negative counts.",
                "カウントの符号が失われています。逆転する車輪のカウントは負です。",
            ),
        ),
        Mistake(
            arrays_only,
            Text(
                "Lists end in an error: lists cannot be subtracted. np.diff takes both, np.asarray makes an array of a list.",
                "リストの場合にエラーになります。リストどうしは引き算できません。np.diffならどちらも扱え、np.asarrayでリストを配列にできます。",
            ),
        ),
        Mistake(
            period_multiplied,
            Text(
                "dt is multiplied by the period. How often the period fits into dt is a quotient.",
                "dtに周期を掛けています。dtに周期がいくつ入るかは、割り算で求めます。",
            ),
        ),
    ),
)
