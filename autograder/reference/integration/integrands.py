"""What the two integrals are tried with: functions and intervals on which no two rules give the same."""

import numpy as np

from autograder.draws import magnitudes, until
from autograder.exercise import Group
from course.given import Integrand, built_integrand
from course.language import Text

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(20)


def integral_groups(rng):
    """Return the groups of cases (f, a, b, n) of both integrals."""

    def polynomial(whole=False):
        return built_integrand(rng.choice([-3, -2, -1, 1, 2, 3], 3) if whole else magnitudes(rng, 0.4, 1.5, 5))

    def waves():
        rates = [(magnitudes(rng, 1.5, 3.0), rng.uniform(1.0, 2.0), rng.uniform(0, 6)) for _ in range(2)]
        return built_integrand([magnitudes(rng, 0.4, 1.5)], rates)

    def interval(counts, direction=1):
        a = magnitudes(rng, 0.4, 1.5)
        return a, a + direction * rng.uniform(1.5, 3.0), int(rng.choice(counts))

    def drawn(function, *limits):
        return lambda: (function(), *interval(*limits))

    def of_one_sign(f, a, b, n):
        values = _values(f, np.linspace(a, b, 4 * n + 1))
        return (values * values[0] > 0).all() and telling_rules(f, a, b, n)

    def signed(sign, draw, telling):
        """Draw a telling case, and turn the function over if its sum has not the sign that is wanted."""
        f, a, b, n = until(draw, telling)
        turned = sign * _values(f, np.linspace(a, b, n + 1)).sum() < 0
        return built_integrand(-f.data["powers"]) if turned else f, a, b, n

    def of_both_signs(f, a, b, n):
        values = _values(f, np.linspace(a, b, n + 1)[:-1])
        return values.min() < -0.3 and values.max() > 0.3 and values.sum() < 0 and telling_rules(f, a, b, n)

    def whole():
        n, a = int(rng.integers(2, 5)), int(rng.choice([-3, -2, 1, 2, 3]))
        return polynomial(whole=True), a, a + int(rng.choice([w for w in range(n + 1, 9) if w % n])), n

    def with_a_point_too_many():
        """Draw limits for which a + n h comes out beside b, so that np.arange has a point too many, up to b or to b + h."""
        a, n = magnitudes(rng, 0.4, 1.5, 1000), rng.integers(5, 40, 1000)
        b = a + rng.uniform(1.5, 3.0, 1000)
        h = (b - a) / n
        k = np.flatnonzero((np.ceil((b - a) / h) > n) & (np.ceil((b + h - a) / h) > n + 1))[0]
        return polynomial(), float(a[k]), float(b[k]), int(n[k])

    def walks_past(f, a, b, n):
        """Tell whether x += h, n times from a, ends below b, so that `while x < b` has a step too many."""
        return np.cumsum([a] + [(b - a) / n] * n)[-1] < b and telling_rules(f, a, b, n)

    # an odd and an even number of intervals, whatever is drawn
    upwards = [signed(sign, drawn(polynomial, counts), of_one_sign) for counts, sign in (([5, 7], 1), ([4, 6, 8], -1))]
    downwards = [signed(sign, drawn(polynomial, range(3, 8), -1), of_one_sign) for sign in (1, -1)]
    past_b = [(with_a_point_too_many, telling_rules), (drawn(polynomial, range(5, 13)), walks_past)]
    rounded = [signed(1, draw, telling) for draw, telling in past_b]
    return [
        Group(Text("a < b", "a < b の区間"), 4, upwards),
        Group(Text("b < a", "b < a の区間"), 2, downwards),
        Group(Text("a single interval", "分割数 1"), 1, [until(drawn(polynomial, [1]), telling_rules)]),
        Group(Text("functions of both signs", "符号の変わる関数"), 2, [until(drawn(waves, range(6, 12)), of_both_signs)]),
        Group(Text("constants", "定数関数"), 1, [(built_integrand([magnitudes(rng, 0.5, 3.0)]), *interval(range(3, 9)))]),
        Group(Text("whole numbers", "整数の入力"), 1, [until(whole, telling_rules)]),
        Group(Text("rounded steps", "丸め誤差のある刻み幅"), 1, rounded),
    ]


def telling_rules(f, a, b, n):
    """Tell whether the rules differ by far more than rounding and their sums are clear of zero."""
    h, x = (b - a) / n, np.linspace(a, b, n + 1)
    values = _values(f, np.concatenate([x, x[:-1] + h / 2, (a + b) / 2 + (b - a) / 2 * _NODES]))
    y, middle, exact = values[: n + 1], h * values[n + 1 : 2 * n + 1].sum(), (b - a) / 2 * _WEIGHTS @ values[2 * n + 1 :]
    left, right = h * y[:-1].sum(), h * y[1:].sum()
    rules = np.array([left, right, (left + right) / 2, middle, exact])
    scale = abs(h) * np.abs(y).sum()
    # Simpson's rule comes close to the integral where n is large
    simpson = abs((left + right) / 6 + 2 / 3 * middle - exact)
    apart = np.diff(np.sort(rules)).min() > 5e-4 * scale and (n > 1 or simpson > 1e-3 * scale)
    return apart and np.abs(rules).min() > 0.1 * scale and np.abs(y[[0, 1, -2, -1]]).min() > 0.1 * scale / abs(h) / (n + 1)


def _values(f, x):
    return Integrand(**f.data)(x)
