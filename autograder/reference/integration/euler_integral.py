"""euler_integral(f, a, b, n): the sum of n rectangles as high as f at their beginnings, Euler's rule for an integral (slides 003)."""

import math

import numpy as np

from autograder.exercise import Exercise, Mistake
from autograder.reference.integration.integrands import integral_groups
from course.given import built_integrand
from course.language import Text


def reference(f, a, b, n):
    """Return h (f(a) + f(a + h) + ... + f(b - h)), h = (b - a)/n."""
    return (b - a) * math.fsum(f(a + (b - a) * k / n) for k in range(n)) / n


def lower_ends(f, a, b, n):
    """Return the same with 'left' read on the x axis: for b < a, minus the left rectangles from b to a."""
    return reference(f, a, b, n) if a <= b else -reference(f, b, a, n)


def cases(rng):
    """Draw functions and intervals on which no two rules give the same."""
    return integral_groups(rng)


def last_rectangle_left_out(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(n - 1))


def first_rectangle_left_out(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(1, n))


def one_rectangle_too_many(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(n + 1))


def right_rectangles(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * (i + 1)) for i in range(n))


def midpoint_rectangles(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * (i + 0.5)) for i in range(n))


def trapezoids(f, a, b, n):
    h = (b - a) / n
    return h * sum((f(a + h * i) + f(a + h * (i + 1))) / 2 for i in range(n))


def simpsons_rule(f, a, b, n):
    h = (b - a) / n
    return h / 6 * sum(f(a + h * i) + 4 * f(a + h * (i + 0.5)) + f(a + h * (i + 1)) for i in range(n))


def exact_integral(f, a, b, n):
    x, weights = np.polynomial.legendre.leggauss(40)
    return (b - a) / 2 * sum(w * f((a + b) / 2 + (b - a) / 2 * p) for p, w in zip(x, weights, strict=True))


def width_forgotten(f, a, b, n):
    h = (b - a) / n
    return sum(f(a + h * i) for i in range(n))


def mean_height(f, a, b, n):
    h = (b - a) / n
    return sum(f(a + h * i) for i in range(n)) / n


def width_of_the_whole_interval(f, a, b, n):
    h = (b - a) / n
    return (b - a) * sum(f(a + h * i) for i in range(n))


def width_squared(f, a, b, n):
    h = (b - a) / n
    return h * h * sum(f(a + h * i) for i in range(n))


def halved(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) / 2 for i in range(n))


def start_ignored(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(h * i) for i in range(n))


def f_of_the_index(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(i) for i in range(n))


def f_of_start_plus_index(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + i) for i in range(n))


def started_at_b(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(b + h * i) for i in range(n))


def sign_turned_round(f, a, b, n):
    h = (a - b) / n
    return h * sum(f(a - h * i) for i in range(n))


def limits_exchanged(f, a, b, n):
    h = (a - b) / n
    return h * sum(f(b + h * i) for i in range(n))


def step_away_from_b(f, a, b, n):
    h = (a - b) / n
    return h * sum(f(a + h * i) for i in range(n))


def limits_added(f, a, b, n):
    h = (a + b) / n
    return h * sum(f(a + h * i) for i in range(n))


def brackets_forgotten_in_h(f, a, b, n):
    h = b - a / n
    return h * sum(f(a + h * i) for i in range(n))


def step_made_positive(f, a, b, n):
    h = abs(b - a) / n
    return h * sum(f(a + h * i) for i in range(n))


def width_made_positive(f, a, b, n):
    h = (b - a) / n
    return abs(h) * sum(f(a + h * i) for i in range(n))


def limits_sorted(f, a, b, n):
    a, b = min(a, b), max(a, b)
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(n))


def nothing_for_b_below_a(f, a, b, n):
    h = (b - a) / n
    return h * sum(f(a + h * i) for i in range(n)) if a < b else 0.0


def heights_made_positive(f, a, b, n):
    h = (b - a) / n
    return h * sum(abs(f(a + h * i)) for i in range(n))


def total_made_positive(f, a, b, n):
    h = (b - a) / n
    return abs(h * sum(f(a + h * i) for i in range(n)))


def step_for_n_points(f, a, b, n):
    h = (b - a) / (n - 1)
    return h * sum(f(a + h * i) for i in range(n))


def one_rectangle_too_few(f, a, b, n):
    x = np.linspace(a, b, n)
    return np.sum(f(x[:-1]) * np.diff(x))


def one_rectangle_too_few_by_h(f, a, b, n):
    x = np.linspace(a, b, n)
    return (x[1] - x[0]) * np.sum(f(x[:-1]))


def n_points_up_to_b(f, a, b, n):
    return (b - a) / n * np.sum(f(np.linspace(a, b, n)))


def step_for_n_plus_1(f, a, b, n):
    h = (b - a) / (n + 1)
    return h * sum(f(a + h * i) for i in range(n))


def step_cut_to_an_integer(f, a, b, n):
    h = (b - a) // n
    return h * sum(f(a + h * i) for i in range(n))


def arange_up_to_b(f, a, b, n):
    h = (b - a) / n
    return h * np.sum(f(np.arange(a, b, h)))


def last_rectangle_only(f, a, b, n):
    h = (b - a) / n
    area = 0.0
    for i in range(n):
        area = h * f(a + h * i)
    return area


def first_rectangle_only(f, a, b, n):
    return (b - a) / n * f(a)


def one_rectangle_for_all(f, a, b, n):
    return (b - a) * f(a)


def one_trapezoid_for_all(f, a, b, n):
    return (b - a) * (f(a) + f(b)) / 2


def difference_of_f(f, a, b, n):
    return f(b) - f(a)


def rectangles_not_added(f, a, b, n):
    h = (b - a) / n
    return [h * f(a + h * i) for i in range(n)]


def running_sums(f, a, b, n):
    h = (b - a) / n
    return np.cumsum([h * f(a + h * i) for i in range(n)])


def running_sums_from_zero(f, a, b, n):
    h = (b - a) / n
    return np.cumsum([0.0] + [h * f(a + h * i) for i in range(n)])


def rounded(f, a, b, n):
    h = (b - a) / n
    return round(float(h * sum(f(a + h * i) for i in range(n))), 2)


def cut_to_an_integer(f, a, b, n):
    h = (b - a) / n
    return int(h * sum(f(a + h * i) for i in range(n)))


EXERCISE = Exercise(
    name="euler_integral",
    notebook="odometry/integration",
    points=5,
    parameters=("f", "a", "b", "n"),
    reference=reference,
    also_right=(lower_ends,),
    cases=cases,
    examples=(
        (built_integrand([0.0, 0.0, 1.0]), 1.0, 3.0, 4),
        (built_integrand([2.0, -1.0], [(1.0, 2.0, 0.5)]), 1.5, 0.0, 3),
        (built_integrand([3.0]), -1.0, 4.0, 1),
    ),
    mistakes=(
        Mistake(
            last_rectangle_left_out,
            Text(
                "One rectangle is missing at the end: the loop stops at n - 2. n rectangles have the numbers 0 to n - 1, and range(n) "
                "already leaves out n. (The loop printed on the slide has the same error.)",
                "最後の長方形が 1 つ足りません。ループが n - 2 で終わっています。n 個の長方形の番号は 0 から n - 1 までで、range(n) は n を"
                "含みません。(スライドに載っているループにも同じ誤りがあります。)",
            ),
        ),
        Mistake(
            first_rectangle_left_out,
            Text(
                "The first rectangle, the one that begins at a, is missing. Does the loop begin at 1, or is f taken at the ends of the "
                "rectangles in a loop that stops one too early? The rectangles have the numbers 0 to n - 1.",
                "a から始まる最初の長方形が抜けています。ループが 1 から始まっているか、長方形の終わりの点で f を計算するループが"
                "1 つ早く終わっていませんか。長方形の番号は 0 から n - 1 までです。",
            ),
        ),
        Mistake(
            one_rectangle_too_many,
            Text(
                "There is a rectangle too many: one that begins at b and sticks out of the interval. n intervals have n + 1 borders, but "
                "Euler's rule uses only those where a rectangle begins.",
                "長方形が 1 つ多く、b から始まるものが区間の外にはみ出しています。n 個の小区間には境界が n + 1 個ありますが、"
                "オイラー法で使うのは各長方形の始まりの点だけです。",
            ),
        ),
        Mistake(
            right_rectangles,
            Text(
                "Every rectangle is as high as f at its end. Euler's rule takes the value at the beginning, which is known when the step "
                "begins: where does the first rectangle begin?",
                "各長方形の高さに、終わりの点での f を使っています。オイラー法では、その区間に入るときにわかっている始まりの点の値を使います。"
                "最初の長方形はどこから始まりますか。",
            ),
        ),
        Mistake(
            midpoint_rectangles,
            Text(
                "Every rectangle is as high as f in the middle of its interval. That is the midpoint rule, a better one; here Euler's rule is "
                "asked for, with the value at the beginning.",
                "各長方形の高さに、小区間の中央での f を使っています。これは中点則という、より精度のよい規則です。"
                "ここではオイラー法、つまり始まりの点の値を使ってください。",
            ),
        ),
        Mistake(
            trapezoids,
            Text(
                "This is the trapezoid rule, the next exercise: both ends of each interval are averaged. Euler's rule uses the value at the "
                "beginning alone.",
                "これは次の課題の台形公式で、小区間の両端の値を平均しています。オイラー法で使うのは始まりの点の値だけです。",
            ),
        ),
        Mistake(
            simpsons_rule,
            Text(
                "This is Simpson's rule: it also uses the middle of each interval. Euler's rule uses the value at the beginning alone.",
                "これはシンプソンの公式で、小区間の中央の値も使っています。オイラー法で使うのは始まりの点の値だけです。",
            ),
        ),
        Mistake(
            exact_integral,
            Text(
                "This is the integral itself, whatever n is. Asked for is Euler's approximation with exactly n rectangles; its error is what "
                "the notebook looks at.",
                "n に関係なく、積分そのものの値になっています。求めるのは、ちょうど n 個の長方形によるオイラー法の近似値です。"
                "その誤差をこのノートブックで調べます。",
            ),
        ),
        Mistake(
            width_forgotten,
            Text(
                "The heights are added, but not multiplied by the width h. A rectangle's area is its height times its width.",
                "高さを足しただけで、幅 h が掛けられていません。長方形の面積は「高さ × 幅」です。",
            ),
        ),
        Mistake(
            mean_height,
            Text(
                "This is the mean of the heights: as if the interval were 1 wide. The width of a rectangle is h = (b - a)/n, not 1/n.",
                "高さの平均になっています。区間の幅を 1 とみなした値です。長方形の幅は 1/n ではなく h = (b - a)/n です。",
            ),
        ),
        Mistake(
            width_of_the_whole_interval,
            Text(
                "Every rectangle is as wide as the whole interval. n of them share it: how wide is one?",
                "どの長方形の幅も区間全体の幅になっています。区間を n 個で分けるとき、1 つの幅はいくらですか。",
            ),
        ),
        Mistake(
            width_squared,
            Text(
                "The width h is multiplied twice, once in the sum and once after it. Check the unit: metres from m/s need one time.",
                "幅 h が 2 回掛けられています(和の中と外など)。単位で確かめましょう。m/s から m になるには、時間を 1 回だけ掛けます。",
            ),
        ),
        Mistake(
            halved,
            Text(
                "This is half of it: a 1/2 from the trapezoid rule is left over. A rectangle has one height, nothing to be averaged.",
                "半分の値になっています。台形公式の 1/2 が残っていませんか。長方形の高さは 1 つで、平均するものはありません。",
            ),
        ),
        Mistake(
            start_ignored,
            Text(
                "f is taken at 0, h, 2h, ..., as if the interval began at 0. The first rectangle begins at a.",
                "f を 0, h, 2h, … で計算していて、区間が 0 から始まることになっています。最初の長方形は a から始まります。",
            ),
        ),
        Mistake(
            f_of_the_index,
            Text(
                "f is called with the number of the rectangle, i. It needs the place where that rectangle begins: how far from a is it?",
                "f に長方形の番号 i をそのまま渡しています。渡すのは、その長方形が始まる場所です。それは a からどれだけ離れていますか。",
            ),
        ),
        Mistake(
            f_of_start_plus_index,
            Text(
                "f is called with a + i, as if the rectangles were 1 wide. They are h wide.",
                "f に a + i を渡していて、幅が 1 の長方形になっています。長方形の幅は h です。",
            ),
        ),
        Mistake(
            started_at_b,
            Text(
                "The rectangles begin at b and go on beyond it. The first one begins at a.",
                "長方形が b から始まって、その先へ並んでいます。最初の長方形は a から始まります。",
            ),
        ),
        Mistake(
            sign_turned_round,
            Text(
                "The sign is turned round: h must be positive when b lies above a. Look at the order of the subtraction.",
                "符号が逆です。b が a より大きいとき、h は正のはずです。引き算の順序を確かめましょう。",
            ),
        ),
        Mistake(
            limits_exchanged,
            Text(
                "a and b are exchanged: this goes from b to a. The first rectangle begins at a, and h is positive when b lies above a.",
                "a と b が入れ替わり、b から a へ積分しています。最初の長方形は a から始まり、b が a より大きければ h は正です。",
            ),
        ),
        Mistake(
            step_away_from_b,
            Text(
                "h has the wrong sign, so that the rectangles lead away from b. From a, h must point towards b.",
                "h の符号が逆で、長方形が b から離れる向きに並んでいます。h は a から b へ向かう符号になるはずです。",
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
                "With b < a the rectangles go the wrong way: h is made positive. Without abs() the signs come out by themselves.",
                "b < a のとき、長方形が逆の向きに並んでいます。h を正にしているためです。abs() を使わなければ、符号は自然に決まります。",
            ),
        ),
        Mistake(
            width_made_positive,
            Text(
                "With b < a the sign is lost: the width is made positive. An integral that runs backwards has a negative h.",
                "b < a のとき符号が失われています。幅を正にしているためです。逆向きの積分では h は負になります。",
            ),
        ),
        Mistake(
            limits_sorted,
            Text(
                "With b < a the limits are put in order first, so that the sign is lost. Leave them as they are given: h is then negative.",
                "b < a のとき、a と b を大きさの順に並べ替えているため、符号が失われています。そのまま使えば h が負になります。",
            ),
        ),
        Mistake(
            nothing_for_b_below_a,
            Text(
                "With b < a the result is 0, so that no rectangle is added: look at the condition of the loop. Counting n rectangles works for either "
                "order of the limits.",
                "b < a のとき結果が 0 で、長方形が 1 つも足されていません。ループの条件を確かめましょう。n 個と数えて足せば、"
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
            one_rectangle_too_few,
            Text(
                "np.linspace(a, b, n) gives n points, and between n points there are n - 1 rectangles. How many points do n rectangles need?",
                "np.linspace(a, b, n) は n 個の点を作り、その間の長方形は n - 1 個です。長方形が n 個になるには、点はいくつ必要ですか。",
            ),
        ),
        Mistake(
            one_rectangle_too_few_by_h,
            Text(
                "np.linspace(a, b, n) gives n points, and between n points there are n - 1 rectangles; with n = 1 there is no second point. "
                "How many points do n rectangles need?",
                "np.linspace(a, b, n) は n 個の点を作り、その間の長方形は n - 1 個です(n = 1 では 2 個目の点がありません)。"
                "長方形が n 個になるには、点はいくつ必要ですか。",
            ),
        ),
        Mistake(
            n_points_up_to_b,
            Text(
                "The n points go from a to b inclusive, so they are farther apart than h. The last rectangle begins one h before b.",
                "n 個の点が a から b まで(b も含めて)並んでいるため、間隔が h より広くなっています。最後の長方形は b より h だけ手前から始まります。",
            ),
        ),
        Mistake(
            step_for_n_plus_1,
            Text(
                "The interval is divided into n + 1 parts. There are n + 1 borders, but n rectangles.",
                "区間を n + 1 個に分けています。境界は n + 1 個ですが、長方形は n 個です。",
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
                "For some steps there is a rectangle too many: h is rounded, so np.arange(a, b, h) sometimes ends one point later. Count the "
                "rectangles instead: there are n, whatever h is.",
                "刻み幅によっては長方形が 1 つ多くなります。h には丸め誤差があるため、np.arange(a, b, h) の点が 1 つ増えることがあります。"
                "h によらず n 個になるように、個数で数えましょう。",
            ),
        ),
        Mistake(
            last_rectangle_only,
            Text(
                "Only the last rectangle is left: each one replaces the one before. In the loop, is it = or +=?",
                "最後の長方形だけが残っています。毎回、前の値が置き換えられています。ループの中は = ですか、+= ですか。",
            ),
        ),
        Mistake(
            first_rectangle_only,
            Text(
                "Only the first rectangle is counted. Is the return inside the loop?",
                "最初の長方形しか足されていません。return がループの中に入っていませんか。",
            ),
        ),
        Mistake(
            one_rectangle_for_all,
            Text(
                "This is one rectangle over the whole interval: n has no effect. Divide the interval into n parts, and take f anew in each.",
                "区間全体を 1 つの長方形にしていて、n が使われていません。区間を n 個に分け、それぞれで f を計算しましょう。",
            ),
        ),
        Mistake(
            one_trapezoid_for_all,
            Text(
                "This is one trapezoid over the whole interval. Asked for are n rectangles, each as high as f where it begins.",
                "区間全体を 1 つの台形にしています。求めるのは n 個の長方形の和で、高さはそれぞれの始まりの点での f です。",
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
            rectangles_not_added,
            Text(
                "The n rectangles come back one by one. Asked for is one number, their sum.",
                "n 個の長方形の面積がそのまま返っています。求めるのは、それらの和 1 つです。",
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
