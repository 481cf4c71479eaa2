"""observed_order(steps, errors): the least-squares slope of log(errors) over log(steps), which says how fast a rule gets better."""

import numpy as np

from autograder.draws import until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text


def reference(steps, errors):
    """Return the slope by the normal equations of a straight line."""
    x, y = np.log(np.asarray(steps, dtype=float)), np.log(np.asarray(errors, dtype=float))
    x = x - x.mean()
    return float(x @ y / (x @ x))


def cases(rng):
    """Draw errors near a power of the step; no two neighbouring points have the slope of them all."""

    def points(count, order, largest=0.7, spread=0.5):
        """Draw steps of uneven ratios, from the largest to the smallest, with the order given roughly."""
        steps = largest * np.exp(-np.cumsum(rng.uniform(0.3, 1.1, count)))
        return steps, rng.uniform(0.3, 3.0) * steps**order * np.exp(rng.uniform(-spread, spread, count))

    def shuffled(count, order):
        steps, errors = points(count, order, spread=1.2)
        mixed = rng.permutation(count)
        return steps[mixed], errors[mixed]

    def not_falling(steps, errors):
        """Tell whether sorting changes which error belongs to which step, even if both are sorted."""
        rank = np.argsort(np.argsort(steps))
        return (rank != np.argsort(np.argsort(errors))).any() and (np.diff(rank) < 0).any() and telling(steps, errors)

    def whole(count):
        steps = rng.permutation([2, 3, 5, 8, 13])[:count]
        return steps, steps ** int(rng.choice([1, 2])) * 3 + rng.integers(1, 4, count)

    def order():
        return rng.uniform(1, 3)

    listed = until(lambda: points(5, order()), telling)
    return [
        Group(
            Text("steps from large to small", "大きい順に並んだ刻み幅"),
            3,
            [until(lambda count=count: points(count, order()), telling) for count in (4, 6)],
        ),
        Group(
            Text("steps in any order", "順序のばらばらな刻み幅"),
            2,
            [until(lambda count=count: shuffled(count, order()), not_falling) for count in (5, 7)],
        ),
        Group(Text("two steps", "刻み幅が 2 つ"), 1, [until(lambda: points(2, order()), clear_of_whole)]),
        Group(Text("steps above 1", "1 より大きい刻み幅"), 1, [until(lambda: points(5, order(), 40.0), telling)]),
        Group(Text("errors that grow again", "再び増える誤差"), 1, [until(lambda: points(5, -rng.uniform(0.7, 2)), telling)]),
        Group(Text("lists", "リストの入力"), 1, [tuple(part.tolist() for part in listed)]),
        Group(Text("whole numbers", "整数の入力"), 1, [until(lambda: whole(4), telling)]),
    ]


def clear_of_whole(steps, errors):
    """Tell whether the slope lies well beside a whole number and its own reciprocal."""
    slope = reference(steps, errors)
    return abs(slope - round(slope)) > 0.03 and abs(slope) > 0.3 and abs(abs(slope) - 1) > 0.03


def telling(steps, errors):
    """Tell whether every shortcut gives another slope than all points together, by far more than rounding."""
    x, y, slope = np.log(steps), np.log(errors), reference(steps, errors)
    pairs = np.diff(y) / np.diff(x)
    ends = (y[-1] - y[0]) / (x[-1] - x[0])
    large, small = np.argmax(x), np.argmin(x)
    shortcuts = [*pairs, ends, (y[large] - y[small]) / (x[large] - x[small]), pairs.mean(), np.median(pairs)]
    through_origin, exchanged = x @ y / (x @ x), y.var() / x.var() / slope
    others = np.array([*shortcuts, through_origin, exchanged, (y / x).mean(), y.mean() / x.mean()])
    return np.abs(others - slope).min() > 0.003 and clear_of_whole(steps, errors)


def step_and_error_exchanged(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(y, x, 1)[0]


def reciprocal_of_the_slope(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return 1 / np.polyfit(x, y, 1)[0]


def exchanged_fit_turned_back(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return 1 / np.polyfit(y, x, 1)[0]


def sign_turned_round(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return -np.polyfit(x, y, 1)[0]


def slope_made_positive(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return abs(np.polyfit(x, y, 1)[0])


def intercept(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(x, y, 1)[1]


def slope_and_intercept(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(x, y, 1)


def logarithm_forgotten(steps, errors):
    return np.polyfit(np.array(steps, dtype=float), np.array(errors, dtype=float), 1)[0]


def logarithm_of_errors_only(steps, errors):
    return np.polyfit(np.array(steps, dtype=float), np.log(np.array(errors, dtype=float)), 1)[0]


def logarithm_of_steps_only(steps, errors):
    return np.polyfit(np.log(np.array(steps, dtype=float)), np.array(errors, dtype=float), 1)[0]


def errors_to_base_10(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(x, y / np.log(10), 1)[0]


def steps_to_base_10(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(x / np.log(10), y, 1)[0]


def first_two_only(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return (y[1] - y[0]) / (x[1] - x[0])


def last_two_only(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return (y[-1] - y[-2]) / (x[-1] - x[-2])


def first_and_last_only(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return (y[-1] - y[0]) / (x[-1] - x[0])


def largest_and_smallest_step_only(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    i, j = np.argmin(x), np.argmax(x)
    return (y[j] - y[i]) / (x[j] - x[i])


def two_finest_only(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    i, j = np.argsort(x)[:2]
    return (y[j] - y[i]) / (x[j] - x[i])


def mean_of_slopes(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.mean(np.diff(y) / np.diff(x))


def median_of_slopes(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.median(np.diff(y) / np.diff(x))


def all_slopes(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.diff(y) / np.diff(x)


def halved_steps_assumed(steps, errors):
    return np.mean(np.diff(np.log(np.array(errors, dtype=float))) / np.log(0.5))


def first_ratio_to_base_2(steps, errors):
    return np.log2(errors[0] / errors[1])


def ratio_without_logarithm(steps, errors):
    return errors[0] / errors[1]


def line_through_the_origin(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.sum(x * y) / np.sum(x * x)


def mean_of_quotients(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.mean(y / x)


def quotient_of_means(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.mean(y) / np.mean(x)


def steps_sorted_alone(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(np.sort(x), y, 1)[0]


def both_sorted_apart(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(np.sort(x), np.sort(y), 1)[0]


def rounded_to_a_whole_number(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.round(np.polyfit(x, y, 1)[0])


def cut_to_a_whole_number(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return int(np.polyfit(x, y, 1)[0])


def rounded(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.round(np.polyfit(x, y, 1)[0], 2)


def correlation(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.corrcoef(x, y)[0, 1]


def covariance_and_variance_unlike(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.cov(x, y)[0, 1] / np.var(x)


def parabola(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    return np.polyfit(x, y, 2)[0] if len(x) > 2 else np.polyfit(x, y, 1)[0]


def relative_errors(steps, errors):
    x, y = np.log(np.array(steps, dtype=float)), np.log(np.array(errors, dtype=float))
    y = np.log(np.array(errors, dtype=float) / np.array(steps, dtype=float))
    return np.polyfit(x, y, 1)[0]


def one_added_before_the_logarithm(steps, errors):
    x, y = np.log1p(np.array(steps, dtype=float)), np.log1p(np.array(errors, dtype=float))
    return np.polyfit(x, y, 1)[0]


EXERCISE = Exercise(
    name="observed_order",
    notebook="odometry/integration",
    points=5,
    parameters=("steps", "errors"),
    reference=reference,
    cases=cases,
    examples=(
        (np.array([0.4, 0.2, 0.1, 0.05]), np.array([0.33, 0.075, 0.021, 0.0047])),
        ([0.1, 0.5], [0.02, 0.11]),
    ),
    mistakes=(
        Mistake(
            step_and_error_exchanged,
            Text(
                "The fit is made the other way round: log(step) over log(error). The error is what depends on the step: "
                "np.polyfit(x, y, 1) takes the steps first.",
                "log(刻み幅) を log(誤差) の関数として当てはめていて、逆になっています。刻み幅によって変わるのが誤差です。"
                "np.polyfit(x, y, 1) には刻み幅のほうを先に渡します。",
            ),
        ),
        Mistake(
            reciprocal_of_the_slope,
            Text(
                "This is one over the slope. Halving the step divides an error of order 2 by four: the difference of "
                "log(errors) is divided by that of log(steps).",
                "傾きの逆数になっています。次数 2 の誤差は刻み幅を半分にすると 1/4 になります。log(誤差) の差を log(刻み幅) の差で割ります。",
            ),
        ),
        Mistake(
            exchanged_fit_turned_back,
            Text(
                "The line is fitted to log(step) over log(error) and its slope inverted. That least-squares line is "
                "another one unless all points lie on a line: fit log(errors) over log(steps).",
                "log(刻み幅) を log(誤差) に当てはめてから、傾きの逆数をとっています。点が一直線上にないと、これは別の直線になります。"
                "log(誤差) を log(刻み幅) に当てはめましょう。",
            ),
        ),
        Mistake(
            sign_turned_round,
            Text(
                "The sign is turned round: the error falls with the step, so both go the same way. A minus belongs to "
                "the number of intervals n, not to the step.",
                "符号が逆です。刻み幅が小さいほど誤差も小さいので、両者は同じ向きに変わります。負号が付くのは、"
                "横軸が刻み幅ではなく分割数 n のときです。",
            ),
        ),
        Mistake(
            slope_made_positive,
            Text(
                "The sign of the slope is lost. Where rounding makes the error grow as the step shrinks, the observed "
                "order is negative: leave out abs().",
                "傾きの符号が失われています。丸め誤差のために刻み幅を小さくすると誤差が増えるところでは、次数は負になります。"
                "abs() は使いません。",
            ),
        ),
        Mistake(
            intercept,
            Text(
                "This is the intercept of the line. np.polyfit(x, y, 1) gives the highest power first: which of the two "
                "numbers is the slope?",
                "直線の切片が返っています。np.polyfit(x, y, 1) は次数の高い係数から順に返します。傾きは 2 つの数のどちらでしょうか。",
            ),
        ),
        Mistake(
            slope_and_intercept,
            Text(
                "Slope and intercept come back together. Asked for is the slope alone.",
                "傾きと切片の両方が返っています。求めるのは傾きだけです。",
            ),
        ),
        Mistake(
            logarithm_forgotten,
            Text(
                "The line is fitted to the errors themselves. A power h^p is a straight line only in logarithms: take "
                "the logarithm of both.",
                "誤差そのものに直線を当てはめています。べき h^p が直線になるのは対数をとったときです。両方の対数をとりましょう。",
            ),
        ),
        Mistake(
            logarithm_of_errors_only,
            Text(
                "Only the errors are put into logarithms. A power h^p becomes a straight line when the steps are as well.",
                "対数をとったのは誤差だけです。べき h^p は、刻み幅の対数もとると直線になります。",
            ),
        ),
        Mistake(
            logarithm_of_steps_only,
            Text(
                "Only the steps are put into logarithms. A power h^p becomes a straight line when the errors are as well.",
                "対数をとったのは刻み幅だけです。べき h^p は、誤差の対数もとると直線になります。",
            ),
        ),
        Mistake(
            errors_to_base_10,
            Text(
                "Two different logarithms: base 10 for the errors, e for the steps. Any base will do, but the same for both.",
                "対数の底がそろっていません(誤差は 10、刻み幅は e)。底は何でもかまいませんが、両方で同じにします。",
            ),
        ),
        Mistake(
            steps_to_base_10,
            Text(
                "Two different logarithms: base 10 for the steps, e for the errors. Any base will do, but the same for both.",
                "対数の底がそろっていません(刻み幅は 10、誤差は e)。底は何でもかまいませんが、両方で同じにします。",
            ),
        ),
        Mistake(
            first_two_only,
            Text(
                "Only the first two points are used. The least-squares slope takes all of them.",
                "最初の 2 点しか使っていません。最小二乗の傾きでは、すべての点を使います。",
            ),
        ),
        Mistake(
            last_two_only,
            Text(
                "Only the last two points are used. The least-squares slope takes all of them.",
                "最後の 2 点しか使っていません。最小二乗の傾きでは、すべての点を使います。",
            ),
        ),
        Mistake(
            first_and_last_only,
            Text(
                "Only the first and the last point are used. The least-squares slope takes all of them.",
                "最初と最後の 2 点しか使っていません。最小二乗の傾きでは、すべての点を使います。",
            ),
        ),
        Mistake(
            largest_and_smallest_step_only,
            Text(
                "Only the largest and the smallest step are used. The least-squares slope takes all points.",
                "最大と最小の刻み幅の 2 点しか使っていません。最小二乗の傾きでは、すべての点を使います。",
            ),
        ),
        Mistake(
            two_finest_only,
            Text(
                "Only the two smallest steps are used. The least-squares slope takes all points.",
                "最も小さい 2 つの刻み幅しか使っていません。最小二乗の傾きでは、すべての点を使います。",
            ),
        ),
        Mistake(
            mean_of_slopes,
            Text(
                "This is the mean of the slopes from point to point. The least-squares slope is another mean, in which "
                "far-apart points count more: fit one line to all.",
                "隣り合う点の間の傾きを平均しています。最小二乗の傾きとは異なります(離れた点ほど重く数えられます)。"
                "全部の点に 1 本の直線を当てはめましょう。",
            ),
        ),
        Mistake(
            median_of_slopes,
            Text(
                "This is the median of the slopes from point to point. Asked for is the slope of the least-squares line "
                "through all points.",
                "隣り合う点の間の傾きの中央値になっています。求めるのは、全部の点に最小二乗で当てはめた直線の傾きです。",
            ),
        ),
        Mistake(
            all_slopes,
            Text(
                "A slope for each two neighbouring points comes back. Asked for is one number, the slope of the line "
                "through all points.",
                "隣り合う 2 点ごとの傾きが返っています。求めるのは、全部の点に当てはめた直線の傾き 1 つです。",
            ),
        ),
        Mistake(
            halved_steps_assumed,
            Text(
                "It is assumed that each step is half of the one before. The steps are given: any ratio and any order may come.",
                "刻み幅が毎回半分になると仮定しています。刻み幅は引数で与えられ、比も順序も自由です。",
            ),
        ),
        Mistake(
            first_ratio_to_base_2,
            Text(
                "It is assumed that the second step is half of the first, and the other points have no effect. Use the "
                "steps that are given, all of them.",
                "2 番目の刻み幅が最初の半分だと仮定していて、残りの点も使われていません。与えられた刻み幅をすべて使いましょう。",
            ),
        ),
        Mistake(
            ratio_without_logarithm,
            Text(
                "This is how many times smaller the error became, not the order. Which power of the steps' ratio is it? "
                "And all points count.",
                "誤差が何分の 1 になったかという比で、次数ではありません。それは刻み幅の比の何乗でしょうか。また、"
                "すべての点を使います。",
            ),
        ),
        Mistake(
            line_through_the_origin,
            Text(
                "The line is forced through the origin: the constant in front of the power is taken to be 1. Fit a line "
                "with an intercept.",
                "原点を通る直線を当てはめています。べきの前の定数が 1 だと仮定したことになります。切片のある直線を当てはめましょう。",
            ),
        ),
        Mistake(
            mean_of_quotients,
            Text(
                "This is the mean of log(error)/log(step), as if the constant in front of the power were 1. A slope is a "
                "quotient of differences.",
                "log(誤差)/log(刻み幅) の平均になっていて、べきの前の定数を 1 とみなしています。傾きは差の比です。",
            ),
        ),
        Mistake(
            quotient_of_means,
            Text(
                "This divides the mean of one logarithm by the mean of the other. A slope is a quotient of differences.",
                "対数の平均どうしを割っています。傾きは差の比です。",
            ),
        ),
        Mistake(
            steps_sorted_alone,
            Text(
                "The steps are sorted, but the errors stay where they were, so that they no longer belong together. The "
                "order does not matter to a fit: leave it.",
                "刻み幅だけを並べ替えているため、誤差との対応が崩れています。当てはめには順序は関係ないので、並べ替えは不要です。",
            ),
        ),
        Mistake(
            both_sorted_apart,
            Text(
                "Steps and errors are sorted each for itself: where an error grows although the step shrinks, pairs are "
                "torn apart. The order does not matter to a fit: leave it.",
                "刻み幅と誤差を別々に並べ替えています。刻み幅が小さいのに誤差が大きい点があると、対応が崩れます。"
                "当てはめには順序は関係ないので、並べ替えは不要です。",
            ),
        ),
        Mistake(
            rounded_to_a_whole_number,
            Text(
                "The slope is rounded to a whole number. What is observed lies beside it, and by how much is worth seeing.",
                "傾きを整数に丸めています。観測される次数は整数からずれるもので、どれだけずれるかも大切な情報です。",
            ),
        ),
        Mistake(
            cut_to_a_whole_number,
            Text(
                "The slope is cut to a whole number. What is observed lies beside it: leave out int().",
                "傾きを整数に切り捨てています。観測される次数は整数からずれます。int() は使いません。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The slope is rounded to two decimals. Round only when you print.",
                "傾きが小数第 2 位に丸められています。丸めるのは表示するときだけにしましょう。",
            ),
        ),
        Mistake(
            correlation,
            Text(
                "This is the correlation of the logarithms: it says how well a line fits, not how steep it is.",
                "対数の相関係数になっています。これは直線への当てはまりのよさで、傾きではありません。",
            ),
        ),
        Mistake(
            covariance_and_variance_unlike,
            Text(
                "np.cov divides by N - 1 and np.var by N, so that their quotient is too large by N/(N - 1). Take both in "
                "the same way (ddof).",
                "np.cov は N - 1 で、np.var は N で割るため、商が N/(N - 1) 倍になっています。両方を同じ定義(ddof)でそろえましょう。",
            ),
        ),
        Mistake(
            parabola,
            Text(
                "A parabola is fitted, and its highest coefficient comes back. The order is the slope of a straight "
                "line: degree 1.",
                "2 次式を当てはめて、その最高次の係数を返しています。次数は直線の傾きですから、当てはめは 1 次式です。",
            ),
        ),
        Mistake(
            relative_errors,
            Text(
                "The errors are divided by the steps first, which takes 1 away from the order. The errors are used as they are.",
                "先に誤差を刻み幅で割っているため、次数が 1 小さくなっています。誤差はそのまま使います。",
            ),
        ),
        Mistake(
            one_added_before_the_logarithm,
            Text(
                "np.log1p(x) is log(1 + x): 1 is added to every step and error. Take np.log.",
                "np.log1p(x) は log(1 + x) なので、刻み幅にも誤差にも 1 が足されています。np.log を使いましょう。",
            ),
        ),
    ),
)
