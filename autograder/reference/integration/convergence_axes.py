"""convergence_axes: error over step of Euler and of the trapezoid rule, both axes logarithmic; the slopes are the orders 1 and 2."""

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, permutations
from typing import NamedTuple

import numpy as np

from autograder.exercise import GraphExercise, GraphFault, Mistake
from course.graphs import Structure
from course.language import Text
from course.plain import Plain

#: how far a fitted slope may be from the order of its rule
SLOPE_TOLERANCE = 0.2
#: fewer points say nothing about a slope
FEWEST_POINTS = 3
#: errors of integrals of about 1 that are rounding rather than the rule's
ROUNDING = 1e-13
#: lines that depend so little on the step are no errors
FLAT = 0.3

_ORDERS = {"euler": 1.0, "trapezoid": 2.0}
_NAMES = {
    "euler": re.compile("euler|オイラ|left|rectang|矩形|長方形|区分求積|左"),
    "trapezoid": re.compile("trap|台形"),
}
#: rules that are neither, though some have Euler's name in theirs
_OTHER_RULES = re.compile(
    "mid[- ]?p|中点|simpson|シンプソン|gauss|ガウス|heun|ホイン|improved|modified|改良|修正|runge|ルンゲ|romberg"
)
_REFERENCES = re.compile(r"slope|傾|order|次|h\s*(?:\^|\*\*|²)|o\(|∝|propto|guide|reference|参考|目安|\bref\b")


@dataclass(frozen=True)
class _Line:
    """A visible line or scatter: its points (N, 2), and the name that the legend gives it, "" if none."""

    points: np.ndarray
    name: str

    @property
    def rule(self) -> str | None:
        """Return the rule that the name names: "euler", "trapezoid", "other", "reference", or None."""
        name = unicodedata.normalize("NFKC", self.name).lower()
        named = [rule for rule, pattern in _NAMES.items() if pattern.search(name)]
        if _OTHER_RULES.search(name):
            return "other"
        if named:
            # a name with both says nothing
            return named[0] if len(named) == 1 else None
        return "reference" if _REFERENCES.search(name) else None

    @cached_property
    def drawable(self) -> np.ndarray:
        """Return the points that logarithmic axes can show, from the smallest step to the largest."""
        points = self.points[(self.points > 0).all(axis=1)]
        return points[np.argsort(points[:, 0], kind="stable")]

    @property
    def is_rounding(self) -> bool:
        """Tell whether no error on the line is larger than rounding."""
        return bool((np.abs(self.points[:, 1]) < ROUNDING).all())

    @cached_property
    def slopes(self) -> list[float]:
        """Return the slopes that the line may be said to have.

        Of all points; of those above rounding; of the finer half of these: the steps may be too large for the order at first.
        """
        above = self.drawable[self.drawable[:, 1] > ROUNDING]
        parts = [self.drawable, above, above[: max((len(above) + 1) // 2, FEWEST_POINTS)]]
        return [slope for slope in map(_log_slope, parts) if slope is not None]

    def has_slope(self, order: float) -> bool:
        """Tell whether the line may be said to have the slope `order`."""
        return any(abs(slope - order) <= SLOPE_TOLERANCE for slope in self.slopes)


class _Kind(NamedTuple):
    """A kind of fault: the rung that it breaks, and the part of the score that it costs."""

    rung: str
    cost: float


def fault(figure: Mapping[str, Plain], data: Plain) -> GraphFault | None:
    """Return what is wrong with the summary of a graph, or None: the first finding is told, and each one costs."""
    found = list(_findings(figure))
    if not found:
        return None
    score = round(max(0.0, 1.0 - sum(_KINDS[slug].cost for slug in found)), 2)
    if found[0] == "slopes_wrong":
        return GraphFault("value", None, score, _SLOPES_WRONG + _slopes_seen(_lines(figure)))
    message = next(mistake.message for mistake in EXERCISE.mistakes if mistake.slug == found[0])
    return GraphFault(_KINDS[found[0]].rung, found[0], score, message)


def _findings(figure: Mapping[str, Plain]) -> Iterator[str]:
    """Yield the slugs of all that is wrong, worst first."""
    lines = _lines(figure)
    if not any(len(line.points) for line in lines):
        yield "empty_axes"
        return
    lines = [line for line in lines if len(np.unique(line.points[:, 0])) >= FEWEST_POINTS]
    if not lines:
        yield "too_few_points"
        return
    scales = tuple(scale == "log" for scale in figure["scales"])
    if not any(scales) and _are_logarithms(lines):
        yield "logarithms_on_linear_axes"
        return
    pair = _pair(lines)
    if pair is None:
        yield _wrong_lines(lines)
    if not all(scales):
        yield {(False, False): "linear_axes", (False, True): "step_axis_linear", (True, False): "error_axis_linear"}[scales]
    if pair is not None and not all(_is_within(line, figure["limits"]) for line in pair):
        yield "limits_hide_the_lines"
    needed = lines if pair is None else pair
    if not all(line.name for line in needed):
        yield "lines_not_labelled"
    elif not figure["legend"]:
        yield "no_legend"
    elif not {line.name for line in needed} <= {entry.strip() for entry in figure["legend"]}:
        yield "legend_incomplete"


def _lines(figure: Mapping[str, Plain]) -> list[_Line]:
    """Return the visible lines and scatters, by the names that the legend gives them."""
    series = [part for part in (*figure["lines"], *figure["points"]) if part["visible"]]
    names = [part["label"] if part["label"][:1] != "_" else "" for part in series]
    # ax.legend([...]) leaves the lines' own labels as they are, and names the lines in the order in which they were drawn
    if len(figure["legend"]) == len(series) and not any(name in figure["legend"] for name in names):
        names = list(figure["legend"])
    points = [part["xy"][np.isfinite(part["xy"]).all(axis=1)] for part in series]
    return [_Line(xy, name.strip()) for xy, name in zip(points, names, strict=True)]


def _pair(lines: Sequence[_Line]) -> tuple[_Line, _Line] | None:
    """Return the lines of Euler and of the trapezoid rule, or None if there are no such lines.

    Names are free, but one that names a rule must be on its line. Named lines are preferred to others.
    """
    candidates = _candidates(lines)
    for rule, order in _ORDERS.items():
        named = [line for line in candidates if line.rule == rule]
        if named and not any(line.has_slope(order) for line in named):
            return None
    fitting = [
        (euler, trapezoid)
        for euler, trapezoid in permutations(candidates, 2)
        if euler.rule != "trapezoid" and trapezoid.rule != "euler" and euler.has_slope(1.0) and trapezoid.has_slope(2.0)
    ]
    return max(fitting, key=lambda pair: sum(bool(line.name) + (line.rule in _ORDERS) for line in pair), default=None)


def _candidates(lines: Sequence[_Line]) -> list[_Line]:
    """Return the lines that may be Euler's or the trapezoid rule's: no other rules, and no slopes drawn for comparison."""
    of_rules = [line for line in lines if line.rule not in ("other", "reference")]
    # "first order" and "second order" may also be the names of the two rules
    return of_rules or [line for line in lines if line.rule != "other"]


def _wrong_lines(lines: Sequence[_Line]) -> str:
    """Return the slug of what is wrong with lines that are not those of the two rules."""
    candidates = _candidates(lines)
    named = {rule: [line for line in candidates if line.rule == rule] for rule in _ORDERS}
    if any((line.points[:, 1] < 0).any() and len(line.drawable) < FEWEST_POINTS for line in candidates):
        return "signed_errors"
    if any(line.is_rounding for line in candidates):
        return "rounding_only"
    if len(candidates) < 2:
        return "one_rule_only"
    if all(_all_within(line, 0.0, FLAT) for line in candidates):
        return "integrals_instead_of_errors"
    if _some_have(candidates, -1.0) and _some_have(candidates, -2.0):
        return "error_over_n"
    if _some_have(candidates, 1.0) and any(_all_within(line, 0.5, 0.1) for line in candidates):
        return "axes_exchanged"
    if _some_have(named["trapezoid"] or candidates, 4.0) and _some_have(named["euler"] or candidates, 2.0):
        return "squared_errors"
    if any(np.array_equal(one.points, other.points) for one, other in combinations(candidates, 2)):
        return "same_line_twice"
    if _some_have(named["euler"], 2.0) and _some_have(named["trapezoid"], 1.0):
        return "names_exchanged"
    if _some_have(named["trapezoid"], 1.0) or all(line.has_slope(1.0) for line in candidates):
        return "trapezoid_of_first_order"
    if _some_have(named["euler"], 2.0) or all(line.has_slope(2.0) for line in candidates):
        return "euler_of_second_order"
    return "slopes_wrong"


def _some_have(lines: Sequence[_Line], order: float) -> bool:
    return any(line.has_slope(order) for line in lines)


def _all_within(line: _Line, slope: float, tolerance: float) -> bool:
    return bool(line.slopes) and all(abs(one - slope) <= tolerance for one in line.slopes)


def _are_logarithms(lines: Sequence[_Line]) -> bool:
    """Are logarithms drawn, on axes that are linear? They are negative where the steps are small."""
    logarithms = [line.points for line in lines if (line.points < 0).any(axis=0).all()]
    slopes = [np.polyfit(points[:, 0], points[:, 1], 1)[0] for points in logarithms]
    return all(any(abs(slope - order) <= SLOPE_TOLERANCE for slope in slopes) for order in _ORDERS.values())


def _log_slope(points: np.ndarray) -> float | None:
    """Return the least-squares slope of log(y) over log(x), or None if there are too few points."""
    if len(np.unique(points[:, 0])) < FEWEST_POINTS:
        return None
    x, y = np.log(points).T
    x = x - x.mean()
    return float(x @ y / (x @ x))


def _is_within(line: _Line, limits: np.ndarray) -> bool:
    """Can enough points of a line be seen?"""
    low, high = limits.reshape(2, 2).min(axis=1), limits.reshape(2, 2).max(axis=1)
    return int(((line.points >= low) & (line.points <= high)).all(axis=1).sum()) >= FEWEST_POINTS


def _slopes_seen(lines: Sequence[_Line]) -> Text:
    """Return the slopes of the student's own lines, for the student to compare."""
    seen = ", ".join(f"{line.slopes[0]:.1f}" for line in lines if line.slopes)
    return _SEEN.format(slopes=seen) if seen else Text("", "")


_SLOPES_WRONG = Text(
    "The lines do not have the slopes of the two rules: 1 for Euler, 2 for trapezoids. Check with euler_integral and "
    "trapezoid_integral for one function that the error really is the distance from the exact integral.",
    "線の傾きが 2 つの規則の次数(オイラー法は 1、台形公式は 2)になっていません。euler_integral と trapezoid_integral を"
    "1 つの関数で確かめ、誤差が正確な積分との差になっているか調べましょう。",
)
_SEEN = Text(" The slopes of your lines: {slopes}.", "描かれた線の傾き: {slopes}。")

_KINDS = {
    "empty_axes": _Kind("shape", 1.0),
    "too_few_points": _Kind("shape", 0.8),
    "logarithms_on_linear_axes": _Kind("shape", 0.4),
    "linear_axes": _Kind("shape", 0.5),
    "step_axis_linear": _Kind("shape", 0.4),
    "error_axis_linear": _Kind("shape", 0.4),
    "signed_errors": _Kind("value", 0.5),
    "integrals_instead_of_errors": _Kind("value", 0.7),
    "error_over_n": _Kind("value", 0.5),
    "axes_exchanged": _Kind("value", 0.5),
    "squared_errors": _Kind("value", 0.5),
    "rounding_only": _Kind("value", 0.6),
    "one_rule_only": _Kind("shape", 0.5),
    "same_line_twice": _Kind("value", 0.5),
    "names_exchanged": _Kind("value", 0.4),
    "trapezoid_of_first_order": _Kind("value", 0.5),
    "euler_of_second_order": _Kind("value", 0.5),
    "limits_hide_the_lines": _Kind("shape", 0.4),
    "lines_not_labelled": _Kind("shape", 0.4),
    "no_legend": _Kind("shape", 0.3),
    "legend_incomplete": _Kind("shape", 0.3),
    "slopes_wrong": _Kind("value", 0.6),
}


def empty_axes(shown=None):
    import matplotlib.pyplot as plt

    plt.figure()
    plt.loglog([0.1, 0.2, 0.4], [0.1, 0.2, 0.4], label="Euler")
    plt.close()
    return plt.gca()


def too_few_points(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps[:2], left[:2], "o-", label="Euler")
    ax.loglog(steps[:2], both[:2], "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def logarithms_on_linear_axes(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.plot(np.log10(steps), np.log10(left), "o-", label="Euler")
    ax.plot(np.log10(steps), np.log10(both), "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def linear_axes(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.plot(steps, left, "o-", label="Euler")
    ax.plot(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def step_axis_linear(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.semilogy(steps, left, "o-", label="Euler")
    ax.semilogy(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def error_axis_linear(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.semilogx(steps, left, "o-", label="Euler")
    ax.semilogx(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def signed_errors(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(h * np.sum(y[:-1]) - np.e + 1)
        both.append(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1)
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def integrals_instead_of_errors(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(h * np.sum(y[:-1]))
        both.append(h * np.sum(y[1:] + y[:-1]) / 2)
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def error_over_n(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(1 / steps, left, "o-", label="Euler")
    ax.loglog(1 / steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def axes_exchanged(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(left, steps, "o-", label="Euler")
    ax.loglog(both, steps, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def squared_errors(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1) ** 2)
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1) ** 2)
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def rounding_only(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 2 * np.pi / np.array([5, 10, 20, 40, 80]), [], []
    for h in steps:
        y = 1 + np.sin(np.arange(round(2 * np.pi / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - 2 * np.pi) + 1e-16)
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - 2 * np.pi) + 1e-16)
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def one_rule_only(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def same_line_twice(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, left, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def names_exchanged(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="trapezoid")
    ax.loglog(steps, both, "s-", label="Euler")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def trapezoid_of_first_order(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:-1] + y[:-2]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def euler_of_second_order(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(np.exp((np.arange(len(y) - 1) + 0.5) * h)) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend()
    return ax


def limits_hide_the_lines(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error", xlim=(1, 10))
    ax.legend()
    return ax


def lines_not_labelled(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-")
    ax.loglog(steps, both, "s-")
    ax.set(xlabel="h", ylabel="error")
    return ax


def no_legend(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    return ax


def legend_incomplete(shown=None):
    import matplotlib.pyplot as plt

    steps, left, both = 1 / np.array([4, 8, 16, 32, 64]), [], []
    for h in steps:
        y = np.exp(np.arange(round(1 / h) + 1) * h)
        left.append(abs(h * np.sum(y[:-1]) - np.e + 1))
        both.append(abs(h * np.sum(y[1:] + y[:-1]) / 2 - np.e + 1))
    _, ax = plt.subplots()
    ax.loglog(steps, left, "o-", label="Euler")
    ax.loglog(steps, both, "s-", label="trapezoid")
    ax.set(xlabel="h", ylabel="error")
    ax.legend(["Euler"])
    return ax


def _nothing_shown() -> Plain:
    """Return the data that the graph must show: none, the function to integrate is free."""
    return None


EXERCISE = GraphExercise(
    name="convergence_axes",
    notebook="odometry/integration",
    points=5,
    structure=Structure(scales=("log", "log"), lines=2, legend=True),
    drawn_from=_nothing_shown,
    fault=fault,
    mistakes=(
        Mistake(
            empty_axes,
            Text(
                "Nothing is drawn on these Axes. If they come from plt.gca() after plt.show() or plt.close(), they are "
                "new, empty ones: begin with fig, ax = plt.subplots() and draw on ax.",
                "この Axes には何も描かれていません。plt.show() や plt.close() の後の plt.gca() は、新しい空の Axes を返します。"
                "最初に fig, ax = plt.subplots() として、ax に描きましょう。",
            ),
        ),
        Mistake(
            too_few_points,
            Text(
                "The lines have fewer than three points each. A slope can be trusted only where several steps lie on one "
                "line: halve the step a few times.",
                "線の点が 3 つ未満です。いくつもの刻み幅が一直線に並んではじめて傾きがわかります。刻み幅を何回か半分にしていきましょう。",
            ),
        ),
        Mistake(
            logarithms_on_linear_axes,
            Text(
                "The slopes are right, but the logarithms themselves are drawn on linear axes, where nobody can read off "
                "a step or an error. Draw step and error as they are, with ax.loglog.",
                "傾きは合っていますが、対数をとった値を普通の目盛に描いているため、刻み幅や誤差を直接読めません。"
                "刻み幅と誤差をそのまま ax.loglog で描きましょう。",
            ),
        ),
        Mistake(
            linear_axes,
            Text(
                "Both axes are linear, so that the small errors lie on top of each other at 0. A power law becomes a "
                "straight line when both axes are logarithmic.",
                "両軸とも普通の目盛なので、小さな誤差が 0 の近くに重なっています。両軸を対数目盛にすると、べき乗の関係が直線になります。",
            ),
        ),
        Mistake(
            step_axis_linear,
            Text(
                "Only the error axis is logarithmic. A power law becomes a straight line when the step axis is too.",
                "対数目盛になっているのは誤差の軸だけです。刻み幅の軸も対数目盛にすると、べき乗の関係が直線になります。",
            ),
        ),
        Mistake(
            error_axis_linear,
            Text(
                "Only the step axis is logarithmic. A power law becomes a straight line when the error axis is too.",
                "対数目盛になっているのは刻み幅の軸だけです。誤差の軸も対数目盛にすると、べき乗の関係が直線になります。",
            ),
        ),
        Mistake(
            signed_errors,
            Text(
                "A line has errors below zero. A logarithmic axis cannot show them, so that they vanish: how large an "
                "error is, is its absolute value.",
                "負の誤差をもつ線があります。対数目盛には負の値を描けないので、消えてしまいます。誤差の大きさは絶対値です。",
            ),
        ),
        Mistake(
            integrals_instead_of_errors,
            Text(
                "The lines hardly change with the step: are these the integrals themselves? What shrinks is their "
                "distance from the exact value.",
                "刻み幅を変えても線がほとんど変わりません。積分の値そのものを描いていませんか。小さくなっていくのは、"
                "正確な値との差です。",
            ),
        ),
        Mistake(
            error_over_n,
            Text(
                "The lines fall to the right: the number of intervals n lies along the x axis. Draw the error over the "
                "step h = (b - a)/n.",
                "線が右下がりになっています。横軸が分割数 n です。誤差は刻み幅 h = (b - a)/n に対して描きましょう。",
            ),
        ),
        Mistake(
            axes_exchanged,
            Text(
                "The axes are exchanged: the step lies along y, so the slopes are turned over (1 and 1/2). What depends "
                "on the step goes along y: the error.",
                "軸が逆です。刻み幅が縦軸にあるため、傾きが逆数(1 と 1/2)になっています。刻み幅によって変わる量、"
                "つまり誤差を縦軸にしましょう。",
            ),
        ),
        Mistake(
            squared_errors,
            Text(
                "The slopes are 2 and 4, twice those of the rules: are the errors squared? Take their absolute values.",
                "傾きが 2 と 4 で、規則の次数の 2 倍になっています。誤差を 2 乗していませんか。絶対値をとりましょう。",
            ),
        ),
        Mistake(
            rounding_only,
            Text(
                "There is nothing but rounding on a line: its errors are as small as the last digit at every step. The "
                "rule is exact for this function and interval (a whole period, a straight line); choose one for which it "
                "is not.",
                "丸め誤差しか見えない線があります。どの刻み幅でも誤差が最後の桁ほどしかありません。その関数と区間(1 周期分の正弦や 1 次式など)では規則の値が正確になるためです。"
                "誤差の出る関数を選びましょう。",
            ),
        ),
        Mistake(
            one_rule_only,
            Text(
                "Only one of the two rules is drawn. The graph compares them: Euler and trapezoid, each over the same steps.",
                "2 つの規則のうち 1 つしか描かれていません。オイラー法と台形公式の両方を、同じ刻み幅で描いて比べます。",
            ),
        ),
        Mistake(
            same_line_twice,
            Text(
                "The same errors are drawn twice, under two names. Look at which list goes into which line.",
                "同じ誤差が 2 つの名前で 2 回描かれています。どの線にどのリストを渡しているか確かめましょう。",
            ),
        ),
        Mistake(
            names_exchanged,
            Text(
                "The names are exchanged: the line called Euler falls with the square of the step, the one called "
                "trapezoid with the step itself. Which rule should be the better one?",
                "名前が入れ替わっています。オイラー法という名前の線が刻み幅の 2 乗で、台形公式という名前の線が刻み幅に比例して小さくなっています。"
                "精度がよいのはどちらのはずですか。",
            ),
        ),
        Mistake(
            trapezoid_of_first_order,
            Text(
                "The line of the trapezoid rule has a slope of about 1, no better than Euler's. The slide's loop, which "
                "leaves out the last trapezoid, does that: is it still in use?",
                "台形公式の線の傾きが 1 ほどで、オイラー法と変わりません。最後の台形が抜ける、スライドのままのループを使うとこうなります。"
                "そのループが残っていませんか。",
            ),
        ),
        Mistake(
            euler_of_second_order,
            Text(
                "The line of Euler's rule has a slope of about 2. Left rectangles are of first order: is the midpoint or "
                "the trapezoid rule on that line?",
                "オイラー法の線の傾きが 2 ほどになっています。左端の値を使う長方形は 1 次の精度です。その線は中点則や台形公式ではありませんか。",
            ),
        ),
        Mistake(
            limits_hide_the_lines,
            Text(
                "The limits of the axes leave the lines outside. Leave out set_xlim and set_ylim, or make them wide "
                "enough for all points.",
                "軸の範囲の外に線が出ています。set_xlim や set_ylim を使わないか、すべての点が入る範囲にしましょう。",
            ),
        ),
        Mistake(
            lines_not_labelled,
            Text(
                "The lines have no names, so that nobody can tell which rule is which. Give each a label=... where it is "
                "drawn, and call ax.legend() afterwards.",
                "線に名前がなく、どちらの規則かわかりません。描くときに label=… を付け、その後で ax.legend() を呼びましょう。",
            ),
        ),
        Mistake(
            no_legend,
            Text(
                "The lines are labelled, but no legend shows it. Call ax.legend() after drawing.",
                "線に label は付いていますが、凡例が表示されていません。描いた後に ax.legend() を呼びましょう。",
            ),
        ),
        Mistake(
            legend_incomplete,
            Text(
                "The legend does not name both lines. Call ax.legend() without a list, after everything is drawn: it "
                "then takes the labels of the lines.",
                "凡例に両方の線の名前がそろっていません。すべて描いた後に、リストを渡さずに ax.legend() を呼ぶと、"
                "各線の label が使われます。",
            ),
        ),
    ),
)
