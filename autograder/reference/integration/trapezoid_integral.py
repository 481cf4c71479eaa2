"""trapezoid_integral(f, a, b, n): the trapezoid rule, eq. (4.34) of slides 003; the loop printed there leaves out the last one."""

import math

import numpy as np

from autograder.exercise import Exercise, Mistake
from autograder.reference.integration.integrands import integral_groups
from course.given import built_integrand
from course.language import Text


def reference(f, a, b, n):
    """Return h (f(a)/2 + f(a + h) + ... + f(b - h) + f(b)/2), h = (b - a)/n."""
    inner = math.fsum(f(a + (b - a) * k / n) for k in range(1, n))
    return (b - a) * (inner + (f(a) + f(b)) / 2) / n


def cases(rng):
    """Draw functions and intervals on which no two rules give the same."""
    return integral_groups(rng)


def last_trapezoid_left_out(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n - 1))


def first_trapezoid_left_out(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(1, n))


def one_trapezoid_too_many(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n + 1))


def half_forgotten(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) for i in range(n))


def half_forgotten_and_last_left_out(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) for i in range(n - 1))


def half_taken_twice(f, a, b, n):
    h = (b - a) / n
    return sum(h / 2 * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def only_the_second_halved(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a) / 2) for i in range(n))


def h_times_the_first_only(f, a, b, n):
    h = (b - a) / n
    return sum((h * f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def brackets_in_the_next_point(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * i + 1 + a)) / 2 for i in range(n))


def one_added_to_the_value(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * i + a) + 1) / 2 for i in range(n))


def sides_subtracted(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * (i + 1) + a) - f(h * i + a)) / 2 for i in range(n))


def sides_multiplied(f, a, b, n):
    h = (b - a) / n
    return sum(h * f(h * i + a) * f(h * (i + 1) + a) / 2 for i in range(n))


def ends_with_full_weight(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(n + 1))


def ends_left_out(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(1, n))


def inner_points_halved(f, a, b, n):
    h = (b - a) / n
    return h / 2 * sum(f(a + h * i) for i in range(n + 1))


def only_the_last_end_halved(f, a, b, n):
    h = (b - a) / n
    return h * (sum(f(a + h * i) for i in range(n)) + f(b) / 2)


def only_the_first_end_halved(f, a, b, n):
    h = (b - a) / n
    return h * (f(a) / 2 + sum(f(a + h * i) for i in range(1, n + 1)))


def ends_added_to_all(f, a, b, n):
    h = (b - a) / n
    return h * ((f(a) + f(b)) / 2 + sum(f(a + h * i) for i in range(n + 1)))


def inner_points_from_zero(f, a, b, n):
    h = (b - a) / n
    return h * ((f(a) + f(b)) / 2 + sum(f(a + h * i) for i in range(n)))


def last_inner_point_left_out(f, a, b, n):
    h = (b - a) / n
    return h * ((f(a) + f(b)) / 2 + sum(f(a + h * i) for i in range(1, n - 1)))


def left_rectangles(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(n))


def right_rectangles(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * (i + 1)) for i in range(n))


def midpoint_rectangles(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * (i + 0.5)) for i in range(n))


def simpsons_rule(f, a, b, n):
    h = (b - a) / n
    return h / 6 * sum(f(a + h * i) + 4 * f(a + h * (i + 0.5)) + f(a + h * (i + 1)) for i in range(n))


def exact_integral(f, a, b, n):
    x, weights = np.polynomial.legendre.leggauss(40)
    return (b - a) / 2 * sum(w * f((a + b) / 2 + (b - a) / 2 * p) for p, w in zip(x, weights, strict=True))


def width_forgotten(f, a, b, n):
    h = (b - a) / n
    return sum((f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def mean_height(f, a, b, n):
    h = (b - a) / n
    return sum((f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n)) / n


def width_of_the_whole_interval(f, a, b, n):
    h = (b - a) / n
    return sum((b - a) * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def width_squared(f, a, b, n):
    h = (b - a) / n
    return h * sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def start_ignored(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i) + f(h * (i + 1))) / 2 for i in range(n))


def start_ignored_at_the_second(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1))) / 2 for i in range(n))


def f_of_the_index(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(i) + f(i + 1)) / 2 for i in range(n))


def f_of_start_plus_index(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(a + i) + f(a + i + 1)) / 2 for i in range(n))


def started_at_b(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + b) + f(h * (i + 1) + b)) / 2 for i in range(n))


def sign_turned_round(f, a, b, n):
    h = (b - a) / n
    return -sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def step_away_from_b(f, a, b, n):
    h = (a - b) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def limits_added(f, a, b, n):
    h = (a + b) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def brackets_forgotten_in_h(f, a, b, n):
    h = b - a / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def step_made_positive(f, a, b, n):
    h = abs(b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def sign_lost_for_b_below_a(f, a, b, n):
    h = (b - a) / n
    return sum(abs(h) * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def nothing_for_b_below_a(f, a, b, n):
    h = (b - a) / n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n)) if a < b else 0.0


def heights_made_positive(f, a, b, n):
    h = (b - a) / n
    return sum(h * (abs(f(h * i + a)) + abs(f(h * (i + 1) + a))) / 2 for i in range(n))


def total_made_positive(f, a, b, n):
    h = (b - a) / n
    return abs(sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n)))


def step_for_n_points(f, a, b, n):
    h = (b - a) / (n - 1)
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def one_trapezoid_too_few(f, a, b, n):
    x = np.linspace(a, b, n)
    y = f(x)
    return np.sum((y[1:] + y[:-1]) / 2 * np.diff(x))


def one_trapezoid_too_few_by_h(f, a, b, n):
    x = np.linspace(a, b, n)
    y = f(x)
    return (x[1] - x[0]) * (np.sum(y) - (y[0] + y[-1]) / 2)


def points_and_step_unlike(f, a, b, n):
    h = (b - a) / n
    y = f(np.linspace(a, b, n))
    return h * np.sum((y[1:] + y[:-1]) / 2)


def step_for_n_plus_1(f, a, b, n):
    h = (b - a) / (n + 1)
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def step_cut_to_an_integer(f, a, b, n):
    h = (b - a) // n
    return sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))


def arange_up_to_b(f, a, b, n):
    h = (b - a) / n
    y = f(np.arange(a, b + h, h))
    return h * np.sum((y[1:] + y[:-1]) / 2)


def last_trapezoid_only(f, a, b, n):
    h = (b - a) / n
    area = 0.0
    for i in range(n):
        area = h * (f(h * i + a) + f(h * (i + 1) + a)) / 2
    return area


def first_trapezoid_only(f, a, b, n):
    h = (b - a) / n
    return h * (f(a) + f(a + h)) / 2


def one_trapezoid_for_all(f, a, b, n):
    return (b - a) * (f(a) + f(b)) / 2


def difference_of_f(f, a, b, n):
    return f(b) - f(a)


def trapezoids_not_added(f, a, b, n):
    h = (b - a) / n
    return [h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n)]


def running_sums(f, a, b, n):
    h = (b - a) / n
    return np.cumsum([h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n)])


def running_sums_from_zero(f, a, b, n):
    h = (b - a) / n
    return np.cumsum([0.0] + [h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n)])


def rounded(f, a, b, n):
    h = (b - a) / n
    return round(float(sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n))), 2)


def cut_to_an_integer(f, a, b, n):
    h = (b - a) / n
    return int(sum(h * (f(h * i + a) + f(h * (i + 1) + a)) / 2 for i in range(n)))


EXERCISE = Exercise(
    name="trapezoid_integral",
    notebook="odometry/integration",
    points=5,
    parameters=("f", "a", "b", "n"),
    reference=reference,
    cases=cases,
    examples=(
        (built_integrand([0.0, 0.0, 1.0]), 1.0, 3.0, 4),
        (built_integrand([2.0, -1.0], [(1.0, 2.0, 0.5)]), 1.5, 0.0, 3),
        (built_integrand([1.0]), 0.0, 10.0, 10),
    ),
    mistakes=(
        Mistake(
            last_trapezoid_left_out,
            Text(
                "The last trapezoid is missing: the loop ends one too early, as the one printed on the slide does. Equation (4.34) adds up i = 0 "
                "to n - 1 inclusive. What does range(n - 1) leave out?",
                "最後の台形が足りません。スライドに載っているループと同じく、1 つ早く終わっています。式 (4.34) では i = 0 から n - 1 まで"
                "(n - 1 も含めて)足します。range(n - 1) では何が抜けるでしょうか。",
            ),
        ),
        Mistake(
            first_trapezoid_left_out,
            Text(
                "The first trapezoid, the one that begins at a, is missing: the loop begins at 1. It has the number 0.",
                "a から始まる最初の台形が抜けています。ループが 1 から始まっています。最初の台形は 0 番です。",
            ),
        ),
        Mistake(
            one_trapezoid_too_many,
            Text(
                "There is a trapezoid too many: the last one begins at b. n trapezoids have the numbers 0 to n - 1.",
                "台形が 1 つ多く、最後のものが b から始まっています。n 個の台形の番号は 0 から n - 1 までです。",
            ),
        ),
        Mistake(
            half_forgotten,
            Text(
                "This is twice as much: the sum of both sides is not halved. The area of a trapezoid is its width times the mean of both sides.",
                "2 倍の値になっています。両側の値の和を 2 で割っていません。台形の面積は「(上底 + 下底) × 高さ ÷ 2」です。",
            ),
        ),
        Mistake(
            half_forgotten_and_last_left_out,
            Text(
                "Two things at once: the sum of both sides is not halved, and the last trapezoid is missing (the loop ends one too early).",
                "誤りが 2 つあります。両側の値の和を 2 で割っていないことと、ループが 1 つ早く終わり、最後の台形が抜けていることです。",
            ),
        ),
        Mistake(
            half_taken_twice,
            Text(
                "This is half of it: the 1/2 is taken twice, once with h and once with the sides.",
                "半分の値になっています。h のところと両側の和のところで、1/2 を 2 回掛けています。",
            ),
        ),
        Mistake(
            only_the_second_halved,
            Text(
                "Only the second side is halved: Python divides before it adds. The sum of both sides needs brackets.",
                "2 つ目の値だけが 2 で割られています。Python は足し算より先に割り算をします。両側の和をかっこで囲みましょう。",
            ),
        ),
        Mistake(
            h_times_the_first_only,
            Text(
                "Only the first side is multiplied by h: Python multiplies before it adds. The sum of both sides needs brackets.",
                "1 つ目の値だけに h が掛けられています。Python は足し算より先に掛け算をします。両側の和をかっこで囲みましょう。",
            ),
        ),
        Mistake(
            brackets_in_the_next_point,
            Text(
                "The second side is taken at h*i + 1 + a, one second later. The next point is h farther: where do the brackets of (i + 1) go?",
                "2 つ目の値を h*i + 1 + a、つまり 1 だけ先で計算しています。次の点は h だけ先です。(i + 1) のかっこはどこに付きますか。",
            ),
        ),
        Mistake(
            one_added_to_the_value,
            Text(
                "1 is added to the value f(x_i). The second side is the value of f at the next point, f(x_(i+1)).",
                "f(x_i) の値に 1 を足しています。2 つ目の値は、次の点での f、つまり f(x_(i+1)) です。",
            ),
        ),
        Mistake(
            sides_subtracted,
            Text(
                "The two sides are subtracted. The mean height of a trapezoid comes from their sum.",
                "両側の値の差をとっています。台形の平均の高さは、両側の和から求まります。",
            ),
        ),
        Mistake(
            sides_multiplied,
            Text(
                "The two sides are multiplied with each other. The mean height of a trapezoid comes from their sum.",
                "両側の値を掛け合わせています。台形の平均の高さは、両側の和から求まります。",
            ),
        ),
        Mistake(
            ends_with_full_weight,
            Text(
                "All points have the same weight. Each inner point belongs to two trapezoids, f(a) and f(b) to one only: what weight "
                "do they have?",
                "すべての点が同じ重みになっています。内側の点は 2 つの台形に、f(a) と f(b) は 1 つの台形にしか含まれません。"
                "両端の重みはいくつになりますか。",
            ),
        ),
        Mistake(
            ends_left_out,
            Text(
                "f(a) and f(b) are missing. The first trapezoid begins at a, the last one ends at b.",
                "f(a) と f(b) が抜けています。最初の台形は a から始まり、最後の台形は b で終わります。",
            ),
        ),
        Mistake(
            inner_points_halved,
            Text(
                "Every point is halved. An inner point belongs to two trapezoids, so that two halves of it come together.",
                "すべての点に 1/2 が掛かっています。内側の点は 2 つの台形に含まれるので、1/2 が 2 回足されます。",
            ),
        ),
        Mistake(
            only_the_last_end_halved,
            Text(
                "f(a) has its full weight, though it belongs to one trapezoid only, like f(b).",
                "f(a) の重みが 1 のままです。f(b) と同じく、f(a) も 1 つの台形にしか含まれません。",
            ),
        ),
        Mistake(
            only_the_first_end_halved,
            Text(
                "f(b) has its full weight, though it belongs to one trapezoid only, like f(a).",
                "f(b) の重みが 1 のままです。f(a) と同じく、f(b) も 1 つの台形にしか含まれません。",
            ),
        ),
        Mistake(
            ends_added_to_all,
            Text(
                "The ends are counted in the sum over all points and once more beside it. The sum goes over the inner points only.",
                "両端が、全部の点の和の中と外で二重に足されています。和は内側の点だけについてとります。",
            ),
        ),
        Mistake(
            inner_points_from_zero,
            Text(
                "f(a) is counted in the sum over the inner points too: that sum begins at i = 1.",
                "f(a) が内側の点の和にも入っています。内側の点は i = 1 から始まります。",
            ),
        ),
        Mistake(
            last_inner_point_left_out,
            Text(
                "The inner point just before b is missing: range leaves out its own end. The inner points have the numbers 1 to n - 1.",
                "b の 1 つ手前の内側の点が抜けています。range は終わりの値を含みません。内側の点の番号は 1 から n - 1 までです。",
            ),
        ),
        Mistake(
            left_rectangles,
            Text(
                "These are Euler's rectangles, as high as f at the beginning. A trapezoid uses the value at its end as well.",
                "始まりの点の値を高さとする、オイラー法の長方形になっています。台形では終わりの点の値も使います。",
            ),
        ),
        Mistake(
            right_rectangles,
            Text(
                "These are rectangles as high as f at the end of each interval. A trapezoid uses the value at its beginning as well.",
                "小区間の終わりの点の値を高さとする長方形になっています。台形では始まりの点の値も使います。",
            ),
        ),
        Mistake(
            midpoint_rectangles,
            Text(
                "This takes f in the middle of each interval: the midpoint rule. A trapezoid averages the values of f at both ends; "
                "the mean of the points is not the mean of the values.",
                "小区間の中央で f を計算しています。これは中点則です。台形では両端での f の値を平均します。"
                "点の平均と値の平均は違います。",
            ),
        ),
        Mistake(
            simpsons_rule,
            Text(
                "This is Simpson's rule, a better one, which the end of the notebook mentions. A trapezoid uses the two ends only.",
                "これはシンプソンの公式で、より精度のよい規則です。台形公式で使うのは両端の値だけです。",
            ),
        ),
        Mistake(
            exact_integral,
            Text(
                "This is the integral itself, whatever n is. Asked for is the approximation with exactly n trapezoids; its error is what "
                "the notebook looks at.",
                "n に関係なく、積分そのものの値になっています。求めるのは、ちょうど n 個の台形による近似値です。"
                "その誤差をこのノートブックで調べます。",
            ),
        ),
        Mistake(
            width_forgotten,
            Text(
                "The mean heights are added, but not multiplied by the width h.",
                "平均の高さを足しただけで、幅 h が掛けられていません。",
            ),
        ),
        Mistake(
            mean_height,
            Text(
                "This is the mean of the heights: as if the interval were 1 wide. The width of a trapezoid is h = (b - a)/n, not 1/n.",
                "高さの平均になっています。区間の幅を 1 とみなした値です。台形の幅は 1/n ではなく h = (b - a)/n です。",
            ),
        ),
        Mistake(
            width_of_the_whole_interval,
            Text(
                "Every trapezoid is as wide as the whole interval. n of them share it: how wide is one?",
                "どの台形の幅も区間全体の幅になっています。区間を n 個で分けるとき、1 つの幅はいくらですか。",
            ),
        ),
        Mistake(
            width_squared,
            Text(
                "The width h is multiplied twice, once in the sum and once after it.",
                "幅 h が 2 回掛けられています。和の中と外の両方で掛けていませんか。",
            ),
        ),
        Mistake(
            start_ignored,
            Text(
                "f is taken at 0, h, 2h, ..., as if the interval began at 0. The first trapezoid begins at a.",
                "f を 0, h, 2h, … で計算していて、区間が 0 から始まることになっています。最初の台形は a から始まります。",
            ),
        ),
        Mistake(
            start_ignored_at_the_second,
            Text(
                "The first side of each trapezoid is right, but a is missing in the place of the second.",
                "各台形の 1 つ目の値は合っていますが、2 つ目の点の位置に a が足されていません。",
            ),
        ),
        Mistake(
            f_of_the_index,
            Text(
                "f is called with the numbers i and i + 1. It needs the places where that trapezoid begins and ends.",
                "f に番号 i, i + 1 をそのまま渡しています。渡すのは、その台形の始まりと終わりの場所です。",
            ),
        ),
        Mistake(
            f_of_start_plus_index,
            Text(
                "f is called with a + i and a + i + 1, as if the trapezoids were 1 wide. They are h wide.",
                "f に a + i と a + i + 1 を渡していて、幅が 1 の台形になっています。台形の幅は h です。",
            ),
        ),
        Mistake(
            started_at_b,
            Text(
                "The trapezoids begin at b and go on beyond it. The first one begins at a.",
                "台形が b から始まって、その先へ並んでいます。最初の台形は a から始まります。",
            ),
        ),
        Mistake(
            sign_turned_round,
            Text(
                "The sign is turned round, or a and b are exchanged: h must be positive when b lies above a.",
                "符号が逆です(a と b の取り違えも含みます)。b が a より大きいとき、h は正のはずです。",
            ),
        ),
        Mistake(
            step_away_from_b,
            Text(
                "h has the wrong sign, so that the trapezoids lead away from b. From a, h must point towards b.",
                "h の符号が逆で、台形が b から離れる向きに並んでいます。h は a から b へ向かう符号になるはずです。",
            ),
        ),
        Mistake(
            limits_added,
            Text(
                "h is computed from a + b. The length of the interval is a difference.",
                "h を a + b から計算しています。区間の長さは差です。",
            ),
        ),
        Mistake(
            brackets_forgotten_in_h,
            Text(
                "h is b - a/n: Python divides before it subtracts. Which part is to be divided by n?",
                "h が b - a/n になっています。Python は引き算より先に割り算をします。n で割るのはどの部分ですか。",
            ),
        ),
        Mistake(
            step_made_positive,
            Text(
                "With b < a the trapezoids go the wrong way: h is made positive. Without abs() the signs come out by themselves.",
                "b < a のとき、台形が逆の向きに並んでいます。h を正にしているためです。abs() を使わなければ、符号は自然に決まります。",
            ),
        ),
        Mistake(
            sign_lost_for_b_below_a,
            Text(
                "With b < a the sign is lost. Was the width made positive, or were the limits put in order? An integral that runs "
                "backwards has a negative h.",
                "b < a のとき符号が失われています。幅を正にしたか、a と b を大きさの順に並べ替えていませんか。"
                "逆向きの積分では h は負になります。",
            ),
        ),
        Mistake(
            nothing_for_b_below_a,
            Text(
                "With b < a the result is 0, so that no trapezoid is added: look at the condition of the loop. Counting n trapezoids works for "
                "either order of the limits.",
                "b < a のとき結果が 0 で、台形が 1 つも足されていません。ループの条件を確かめましょう。n 個と数えて足せば、"
                "どちらの順序でも動きます。",
            ),
        ),
        Mistake(
            heights_made_positive,
            Text(
                "Heights below zero are counted as if above it. Where f is negative, the integral falls: leave out abs().",
                "負の高さが正として足されています。f が負のところでは積分は減ります。abs() は使いません。",
            ),
        ),
        Mistake(
            total_made_positive,
            Text(
                "The sign of the result is lost. An integral may be negative: leave out abs().",
                "結果の符号が失われています。積分は負にもなります。abs() は使いません。",
            ),
        ),
        Mistake(
            step_for_n_points,
            Text(
                "h is (b - a)/(n - 1): that is for n points with both ends among them. n intervals share b - a: how wide is one of them? "
                "(With n = 1 this divides by zero.)",
                "h が (b - a)/(n - 1) になっています。これは両端を含む n 個の点の間隔です。b - a を n 個の小区間で分けるとき、"
                "1 つの幅はいくらですか。(n = 1 では 0 で割ってしまいます。)",
            ),
        ),
        Mistake(
            one_trapezoid_too_few,
            Text(
                "np.linspace(a, b, n) gives n points, and between n points there are n - 1 trapezoids. How many points do n trapezoids need?",
                "np.linspace(a, b, n) は n 個の点を作り、その間の台形は n - 1 個です。台形が n 個になるには、点はいくつ必要ですか。",
            ),
        ),
        Mistake(
            one_trapezoid_too_few_by_h,
            Text(
                "np.linspace(a, b, n) gives n points, and between n points there are n - 1 trapezoids; with n = 1 there is no second "
                "point. How many points do n trapezoids need?",
                "np.linspace(a, b, n) は n 個の点を作り、その間の台形は n - 1 個です(n = 1 では 2 個目の点がありません)。"
                "台形が n 個になるには、点はいくつ必要ですか。",
            ),
        ),
        Mistake(
            points_and_step_unlike,
            Text(
                "The points are too few for h: between n points there are n - 1 trapezoids, each wider than (b - a)/n.",
                "点の数と h が合っていません。n 個の点の間の台形は n - 1 個で、それぞれの幅は (b - a)/n より広くなります。",
            ),
        ),
        Mistake(
            step_for_n_plus_1,
            Text(
                "The interval is divided into n + 1 parts. There are n + 1 borders, but n trapezoids.",
                "区間を n + 1 個に分けています。境界は n + 1 個ですが、台形は n 個です。",
            ),
        ),
        Mistake(
            step_cut_to_an_integer,
            Text(
                "h is computed with //, which drops the fraction of the step. Use / for the division.",
                "h の計算に // を使っているため、刻み幅の小数部分が切り捨てられています。割り算には / を使いましょう。",
            ),
        ),
        Mistake(
            arange_up_to_b,
            Text(
                "For some steps there is a trapezoid too many: h is rounded, so np.arange(a, b + h, h) sometimes ends one point later. Count "
                "the trapezoids instead: there are n, whatever h is.",
                "刻み幅によっては台形が 1 つ多くなります。h には丸め誤差があるため、np.arange(a, b + h, h) の点が 1 つ増えることがあります。"
                "h によらず n 個になるように、個数で数えましょう。",
            ),
        ),
        Mistake(
            last_trapezoid_only,
            Text(
                "Only the last trapezoid is left: each one replaces the one before. In the loop, is it = or +=?",
                "最後の台形だけが残っています。毎回、前の値が置き換えられています。ループの中は = ですか、+= ですか。",
            ),
        ),
        Mistake(
            first_trapezoid_only,
            Text(
                "Only the first trapezoid is counted. Is the return inside the loop?",
                "最初の台形しか足されていません。return がループの中に入っていませんか。",
            ),
        ),
        Mistake(
            one_trapezoid_for_all,
            Text(
                "This is one trapezoid over the whole interval: n has no effect. Divide the interval into n parts, and take f anew in each.",
                "区間全体を 1 つの台形にしていて、n が使われていません。区間を n 個に分け、それぞれで f を計算しましょう。",
            ),
        ),
        Mistake(
            difference_of_f,
            Text(
                "This is f(b) - f(a). That would be the integral of the derivative of f; f itself is to be added up.",
                "f(b) - f(a) になっています。それは f の導関数の積分です。ここでは f そのものを足し合わせます。",
            ),
        ),
        Mistake(
            trapezoids_not_added,
            Text(
                "The n trapezoids come back one by one. Asked for is one number, their sum.",
                "n 個の台形の面積がそのまま返っています。求めるのは、それらの和 1 つです。",
            ),
        ),
        Mistake(
            running_sums,
            Text(
                "The running sums come back. Asked for is one number, the last of them; the running sums are an exercise of their own later.",
                "途中までの和がすべて返っています。求めるのは最後の値 1 つです。累積和はあとの課題で扱います。",
            ),
        ),
        Mistake(
            running_sums_from_zero,
            Text(
                "The running sums come back, with a 0 in front. Asked for is one number, the last of them.",
                "先頭に 0 の付いた途中までの和がすべて返っています。求めるのは最後の値 1 つです。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded to two decimals. Round only when you print; the error of the rule is to be seen later.",
                "結果が小数第 2 位に丸められています。丸めるのは表示するときだけにしましょう。あとで規則の誤差を調べるときに困ります。",
            ),
        ),
        Mistake(
            cut_to_an_integer,
            Text(
                "The result is cut to a whole number. Leave out int().",
                "結果が整数に切り捨てられています。int() は使いません。",
            ),
        ),
    ),
)
