"""Graphs of motion: does a drawn graph show the data that it should, so that they can be seen, with its axes labelled?

All that is looked at is the summary of an Axes (course.figures). What can be said without the data is a `Structure`; it is asked
of a graph wherever it is checked, the data only where they are known.
"""

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from course.explaining import shown
from course.language import Text
from course.plain import Plain

DEGREES = 180 / np.pi
#: how far apart drawn and right values may be: the rules of integration that are right differ by millimetres
TOLERANCES = {"time": 1e-4, "x": 0.02, "y": 0.02, "theta": 2e-3, "velocity": 2e-3, "yaw_rate": 2e-3}
#: a line of fewer points is a marker or a reference, not data
A_LINE = 3
#: the part of the data's extent that may lie outside the limits: less than the width of a line
SLIVER = 0.005


class GraphFault(NamedTuple):
    """What is wrong with a graph.

    The rung, the slug of the fault (one of the exercise's misconceptions, or None), what remains of the score, and what to say.
    """

    rung: str
    slug: str | None
    score: float
    text: Text


class Shown(NamedTuple):
    """How a quantity goes by in a label: a pattern of its names, and its units with their size in SI units' place."""

    names: re.Pattern[str]
    units: Mapping[str, float]


def _words(letters: str, words: str) -> re.Pattern[str]:
    """Return a pattern of single letters or Greek names that stand alone, and of words that may be part of a compound."""
    return re.compile(rf"(?<![a-z])(?:{letters})(?![a-z])|{words}")


QUANTITIES = {
    "time": Shown(_words("t", "time|elapsed|時刻|時間|経過|秒数|タイム"), {"s": 1.0}),
    "x": Shown(_words("x", "x[ -]?(?:axis|position|coordinate)"), {"m": 1.0}),
    "y": Shown(_words("y", "y[ -]?(?:axis|position|coordinate)"), {"m": 1.0}),
    "theta": Shown(
        _words(
            "theta|psi|phi|θ|ψ|φ",
            r"yaw(?![ _-]*rate)|heading|orientation|azimuth|bearing|(?<!rect)angle|attitude|ヨー(?!レート)|方位|向き|姿勢|角(?!速度|加速度)",
        ),
        {"rad": 1.0, "deg": DEGREES},
    ),
    "velocity": Shown(_words("v", r"(?<!angular )(?:velocity|speed)|(?<!角)速度|速さ|車速|スピード"), {"m/s": 1.0}),
    "yaw_rate": Shown(
        _words("w|omega|ω", r"yaw[ _-]*rate|angular (?:velocity|speed|rate)|turn(?:ing)? rate|角速度|ヨーレート"),
        {"rad/s": 1.0, "deg/s": DEGREES},
    ),
}

_UNITS = {
    unit: re.compile(pattern)
    for unit, pattern in {
        "m": "m|meters?|metres?|メートル|メーター",
        "s": "s|secs?|seconds?|秒",
        "rad": "rads?|radians?|ラジアン",
        "deg": r"degs?|degrees?|°|度|\^?circ",
        "m/s": r"(?:m|meters?|metres?|メートル)(?:/|per|毎)(?:s|secs?|seconds?|秒)|ms\^?-1|mps|毎秒メートル",
        "rad/s": r"(?:rads?|radians?|ラジアン)(?:/|per|毎)(?:s|secs?|seconds?|秒)|rads\^?-1|rps",
        "deg/s": r"(?:degs?|degrees?|°|度)(?:/|per|毎)(?:s|secs?|seconds?|秒)|degs\^?-1|dps|°s\^?-1",
        "other": r"[μmnu]s|msecs?|ミリ秒|μ?seconds|mins?|minutes?|分|h|hours?|時|ns|[cmkμ]m|センチ|ミリ|km/h|kmh|kph|[cmk]m/s(?:ec)?|"
        r"mrads?|g|hz|counts?|カウント|samples?|rows?|行|steps?|pixels?|px|%|-|m/s\^?2|inch(?:es)?|feet|ft|rev|rpm",
    }.items()
}


@dataclass(frozen=True)
class Structure:
    """What a graph must be like, whatever its data.

    `x` and `y` name the quantities along the axes (keys of QUANTITIES); None: nothing is asked of that label. `scales` are those
    of both axes; at least `lines` lines or scatters are visible; `legend`: they are named in a legend.
    """

    x: str | None = None
    y: str | None = None
    equal_aspect: bool = False
    scales: tuple[str, str] = ("linear", "linear")
    lines: int = 1
    legend: bool = False


#: something is drawn, and that is all that is asked
ANY_GRAPH = Structure()


class _Finding(NamedTuple):
    """One fault: its slug in FAULTS, and where it was seen."""

    slug: str
    where: Text = Text("", "")


#: faults that are not told or charged beside another one, of which they are the natural consequence
_WHAT_FOLLOWS = {
    "another_scale": ("another_unit",),
    "time_in_another_unit": ("another_unit",),
    "axes_exchanged": ("another_unit", "another_quantity_named"),
    "another_quantity_drawn": ("another_unit", "another_quantity_named"),
    "other_scale": ("cut_off",),
}


class _Fault(NamedTuple):
    """A kind of fault: the rung that it breaks, the part of the score that it costs, and what to say."""

    rung: str
    cost: float
    text: Text


def structure_fault(structure: Structure, figure: Mapping[str, Plain]) -> GraphFault | None:
    """Return what is wrong with a graph as far as it can be told without the data, or None."""
    return _fault([*_drawing_findings(structure, figure), *_frame_findings(structure, figure)])


def graph_fault(
    structure: Structure, figure: Mapping[str, Plain], data: Mapping[str, Plain], tolerances: Mapping[str, float] = TOLERANCES
) -> GraphFault | None:
    """Return what is wrong with the graph of data[structure.y] over data[structure.x], or None.

    The data are arrays (N,); a line or a scatter through all samples must be visible. The first speed is not compared: before row
    0 there is no interval. Where a quantity has several units the label says which one is drawn.
    """
    assert structure.x is not None
    assert structure.y is not None
    wanted = _Wanted(structure.x, structure.y, data, tolerances)
    drawing = _drawing_findings(structure, figure) or _data_findings(wanted, figure)
    findings = [*drawing, *_frame_findings(structure, figure)]
    follow = {slug for finding in findings for slug in _WHAT_FOLLOWS.get(finding.slug, ())}
    return _fault([finding for finding in findings if finding.slug not in follow])


def _fault(findings: Sequence[_Finding]) -> GraphFault | None:
    """Return all findings as one fault: the first is told, and each costs."""
    if not findings:
        return None
    slug, where = findings[0]
    score = max(0.0, 1.0 - sum(FAULTS[finding.slug].cost for finding in findings))
    # data that are wrong in a way that nobody foresaw have no name
    return GraphFault(FAULTS[slug].rung, None if slug == "data_wrong" else slug, round(score, 2), FAULTS[slug].text + where)


def _drawing_findings(structure: Structure, figure: Mapping[str, Plain]) -> list[_Finding]:
    visible = [series for series in _all_series(figure) if series["visible"]]
    if len([series for series in visible if _finite(series["xy"]).sum() >= A_LINE]) >= structure.lines:
        return []
    hidden = any(len(series["xy"]) >= A_LINE and not series["visible"] for series in _all_series(figure))
    return [_Finding("line_hidden" if hidden else "nothing_drawn")]


def _frame_findings(structure: Structure, figure: Mapping[str, Plain]) -> Iterator[_Finding]:
    """Yield what is wrong with scales, directions, aspect, labels and legend."""
    if figure["scales"] != list(structure.scales):
        yield _Finding("other_scale")
    # errors may be drawn over steps that become smaller to the right
    if structure.x is not None and figure["limits"][0] > figure["limits"][1]:
        yield _Finding("x_axis_turned_round")
    if structure.equal_aspect and abs(figure["aspect"] - 1) > 0.01:
        yield _Finding("aspect_not_equal")
    for side, quantity, label in zip(_SIDES, (structure.x, structure.y), figure["labels"], strict=True):
        slug = None if quantity is None else _label_fault(quantity, label)
        if slug:
            yield _Finding(slug, (_LABEL if label.strip() else _NO_LABEL).format(side=side, label=shown(label.strip())))
    if structure.legend and len(figure["legend"]) < structure.lines:
        yield _Finding("legend_missing")


def _label_fault(quantity: str, label: str) -> str | None:
    """Return the slug of what is wrong with a label, or None."""
    if not label.strip():
        return "label_missing"
    unit, name = unit_and_name(label)
    if not re.search(r"[^\W\d_]", name):
        return "quantity_missing"
    named = [key for key, one in QUANTITIES.items() if one.names.search(name)]
    if named and quantity not in named:
        return "another_quantity_named"
    if unit is None:
        return "unit_missing"
    return None if unit in QUANTITIES[quantity].units else "another_unit"


_BRACKETED = re.compile(r"[\[(<]([^\[\]()<>]*)[\])>]")
_SEPARATED = [
    re.compile(pattern)
    for pattern in (r"^(.*)\bin\b(.+)$", r"^(.*)[,:;、](.+)$", r"^(.*)\s(\S+)$", r"^(.*?)/(.+)$", r"^(.+)(°)$")
]


def unit_and_name(label: str) -> tuple[str | None, str]:
    """Return (unit, name of the quantity) of an axis label; the unit is one that the course knows, "other", or None.

    >>> unit_and_name("$x$ [m]"), unit_and_name("時刻(秒)"), unit_and_name("v / m/s"), unit_and_name("[rad]")
    (('m', 'x'), ('s', '時刻'), ('m/s', 'v'), ('rad', ''))
    """
    text = _plain_label(label)
    for match in reversed(list(_BRACKETED.finditer(text))):
        unit = _unit(match[1])
        if unit:
            return unit, f"{text[: match.start()]} {text[match.end() :]}".strip(" /")
    unit = _unit(text)
    if unit and unit != "other":
        return unit, ""
    for pattern in _SEPARATED:
        parts = pattern.match(text)
        if parts and (unit := _unit(parts[2])):
            return unit, parts[1].strip(" /")
    return None, text


def _plain_label(label: str) -> str:
    """Return a label in small letters of normal width, without the marks of LaTeX."""
    # before the compatibility form makes letters of these
    text = re.sub("[º˚]", "°", label)
    text = unicodedata.normalize("NFKC", text).lower().translate(str.maketrans("【】〔〕「」〈〉《》−⋅·∕⁄", "[][][][][]-..//"))
    text = re.sub(r"\\d?frac *\{([^{}]*)\} *\{([^{}]*)\}", r"\1/\2", text)
    text = re.sub(r"\\(?:mathrm|mathit|mathbf|mathsf|textrm|text|rm|it|bf|left|right|quad|[,;:! ])", " ", text)
    return re.sub(r"\s+", " ", text.replace("\\", " ").translate(str.maketrans("", "", "${}"))).strip()


def _unit(text: str) -> str | None:
    bare = re.sub(r"^(?:in|unit:?|単位:?)\s|[\s.*]", "", text.strip())
    return next((unit for unit, pattern in _UNITS.items() if pattern.fullmatch(bare)), None)


class _Wanted(NamedTuple):
    """The data that a graph must show."""

    x: str
    y: str
    data: Mapping[str, Plain]
    tolerances: Mapping[str, float]

    @property
    def skip(self) -> int:
        """Return how many rows need not be right."""
        return 1 if self.y in ("velocity", "yaw_rate") else 0

    def rows(self, scale: float = 1.0) -> np.ndarray:
        """Return the points of the graph, (N, 2), the quantity along y in a unit of another size."""
        return np.column_stack([self.data[self.x], np.multiply(self.data[self.y], scale)]).astype(float)

    def limits(self, scale: float = 1.0) -> np.ndarray:
        """Return how far from them a drawn point may be, (2,)."""
        return np.array([self.tolerances[self.x], self.tolerances[self.y] * scale])


def _data_findings(wanted: _Wanted, figure: Mapping[str, Plain]) -> list[_Finding]:
    """Return what is wrong with the data that are drawn, and whether all of them are within the limits."""
    units = QUANTITIES[wanted.y].units
    label, _ = unit_and_name(figure["labels"][1])
    visible = [series["xy"] for series in _all_series(figure) if series["visible"] and len(series["xy"]) >= A_LINE]
    # first the unit that the label names; without one, any
    for unit, scale in sorted(units.items(), key=lambda item: item[0] != label):
        if not any(_goes_through(xy, wanted, scale) for xy in visible) and not _together_cover(figure, wanted, scale):
            continue
        if label in units and unit != label:
            return [_Finding(f"{unit}_labelled_as_{label}")]
        return [_Finding("cut_off")] if _is_cut_off(figure["limits"], wanted.rows(scale)[wanted.skip :]) else []
    if any(_goes_through(series["xy"], wanted, scale) for series in _all_series(figure) for scale in units.values()):
        return [_Finding("line_hidden")]
    # a line that shows a known mistake says most, and the longest line more than others
    slugs = (_mistake(xy, wanted) for xy in sorted(visible, key=len, reverse=True))
    return [_Finding(next(filter(None, slugs), "data_wrong"))]


def _all_series(figure: Mapping[str, Plain]) -> list[dict[str, Plain]]:
    return [*figure["lines"], *figure["points"]]


def _finite(xy: np.ndarray) -> np.ndarray:
    return np.isfinite(xy).all(axis=1)


def _goes_through(xy: np.ndarray, wanted: _Wanted, scale: float) -> bool:
    """Return whether a line goes through all samples, in their order or the other way round."""
    rows, skip, limits = wanted.rows(scale), wanted.skip, wanted.limits(scale)
    for drawn in (xy, xy[::-1]):
        if len(drawn) == len(rows) and _near(drawn[skip:], rows[skip:], limits):
            return True
        if len(drawn) == len(rows) - skip and _near(drawn, rows[skip:], limits):
            return True
    return False


def _near(values: np.ndarray, right: np.ndarray, limits: np.ndarray | float) -> bool:
    return values.shape == right.shape and bool(np.all(np.abs(values - right) <= limits))


def _together_cover(figure: Mapping[str, Plain], wanted: _Wanted, scale: float) -> bool:
    """Do several lines show all samples between them, such as one for driving forward and one for reversing?"""
    rows, limits = wanted.rows(scale), wanted.limits(scale)
    count, covered = 0, np.zeros(len(rows), dtype=bool)
    for kind in ("lines", "points"):
        for series in figure[kind]:
            xy = series["xy"][_finite(series["xy"])]
            if not series["visible"] or not 0 < len(xy) <= 2 * len(rows) or not _lie_on(xy[:: len(xy) // 20 + 1], rows, limits):
                continue
            nearest, inside = _nearest(xy, rows, limits)
            in_order = kind == "points" or np.abs(np.diff(nearest)).sum() <= 3 * len(rows)
            if inside.all() and in_order:
                count += len(xy)
                covered |= _nearest(rows, xy, limits)[1]
    return count >= len(rows) - wanted.skip and bool(covered[wanted.skip :].all())


def _lie_on(points: np.ndarray, rows: np.ndarray, limits: np.ndarray) -> bool:
    """Is each of the points near some sample?"""
    return bool(_nearest(points, rows, limits)[1].all())


def _nearest(points: np.ndarray, among: np.ndarray, limits: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return for each point the index of the nearest one `among` others, and whether that is within the limits."""
    index, inside = np.zeros(len(points), dtype=int), np.zeros(len(points), dtype=bool)
    # a few at a time: all distances at once take too much memory
    for start in range(0, len(points), 256):
        some = slice(start, start + 256)
        apart = np.abs(points[some, None, :] - among[None, :, :]) / limits
        farther = np.maximum(apart[..., 0], apart[..., 1])
        index[some] = farther.argmin(axis=1)
        inside[some] = farther.min(axis=1) <= 1
    return index, inside


def _mistake(xy: np.ndarray, wanted: _Wanted) -> str | None:
    """Return the slug of the mistake that a line shows, or None."""
    for part_of in _rows_of(len(xy), len(wanted.data[wanted.x])):
        part = {key: np.asarray(values, dtype=float)[part_of] for key, values in wanted.data.items()}
        slug = _mistake_by_column(xy, part, wanted)
        if slug:
            return slug
    on_the_way = xy[_finite(xy)][: 2 * len(wanted.rows())]
    for scale in QUANTITIES[wanted.y].units.values():
        rows, limits = wanted.rows(scale), wanted.limits(scale)
        few = on_the_way[:: len(on_the_way) // 20 + 1]
        if len(few) and _lie_on(few, rows, limits) and _lie_on(on_the_way, rows, limits):
            return "points_in_another_order" if len(on_the_way) >= len(rows) - wanted.skip else "samples_missing"
    return None


def _rows_of(drawn: int, count: int) -> list[slice]:
    """Return the rows that a line of that many points may show: all, or all but one at either end."""
    return {0: [slice(None)], 1: [slice(1, None), slice(None, -1)]}.get(count - drawn, [])


def _mistake_by_column(xy: np.ndarray, data: Mapping[str, np.ndarray], wanted: _Wanted) -> str | None:
    """Return what is wrong with the numbers along x, or else along y; row by row they belong to `data`."""
    skip = wanted.skip
    xy, data = xy[skip:], {key: values[skip:] for key, values in data.items()}
    along_x, along_y = xy.T
    for scale in QUANTITIES[wanted.y].units.values():
        limits = wanted.limits(scale)
        if _near(along_y, data[wanted.x], limits[0]) and _near(along_x, data[wanted.y] * scale, limits[1]):
            return "axes_exchanged"
    horizontal = _column_mistake(wanted.x, along_x, data, wanted.tolerances)
    vertical = _column_mistake(wanted.y, along_y, data, wanted.tolerances)
    if horizontal == vertical == "" and len(data[wanted.x]) < len(wanted.data[wanted.x]) - skip:
        return "samples_missing"
    return horizontal or vertical or None


def _column_mistake(
    quantity: str, values: np.ndarray, data: Mapping[str, np.ndarray], tolerances: Mapping[str, float]
) -> str | None:
    """Return the slug of what is wrong with the drawn numbers of one quantity: "" if nothing is, None if it has no name."""
    right, limit = data[quantity], tolerances[quantity]
    if any(_near(values, right * scale, limit * scale) for scale in QUANTITIES[quantity].units.values()):
        return ""
    slug = _OF_ITS_OWN.get(quantity, lambda *_: None)(values, data, limit)
    if slug is None and any(_near(values, other, tolerances[key]) for key, other in data.items() if key != quantity):
        return "another_quantity_drawn"
    return slug


def _time_mistake(values: np.ndarray, data: Mapping[str, np.ndarray], limit: float) -> str | None:
    right = data["time"]
    late, elapsed = values - right, values - values[0]
    if np.ptp(late) < limit or values[0] > 1e6 or _near(elapsed * 86400, right - right[0], 0.01):
        return "time_not_from_the_start"
    steps = np.diff(values)
    if np.all(steps == 1):
        return "row_numbers_for_time"
    factor = _factor(values, right)
    if _near(values, factor * right, limit * factor):
        return "time_in_another_unit"
    if np.ptp(steps) < limit and abs(elapsed[-1] - right[-1] + right[0]) < 0.1 * np.ptp(right):
        return "equal_time_steps"
    return None


def _yaw_mistake(values: np.ndarray, data: Mapping[str, np.ndarray], limit: float) -> str | None:
    right = data["theta"]
    for scale in QUANTITIES["theta"].units.values():
        yaw = values / scale
        turns = np.rint((yaw - right) / (2 * np.pi))
        if np.ptp(turns) and _near(yaw - 2 * np.pi * turns, right, limit):
            return "yaw_wrapped"
        if _near(yaw, -right, limit):
            return "sign_reversed"
    return None


def _speed_mistake(values: np.ndarray, data: Mapping[str, np.ndarray], limit: float) -> str | None:
    right = data["velocity"]
    if _near(np.abs(values), np.abs(right), limit):
        if np.all(values >= -limit):
            return "speed_without_sign"
        if _near(values, -right, limit):
            return "sign_reversed"
    dt = np.diff(data["time"])
    ways = right[1:] * dt
    factor = _factor(values[1:], ways)
    if abs(factor - 1) < 0.01:
        return "another_quantity_drawn"
    if _near(values[1:], factor * ways, abs(factor) * limit * np.median(dt)):
        return "speed_with_one_dt"
    return _scaled(values, right, limit)


def _position_mistake(axis: str, values: np.ndarray, data: Mapping[str, np.ndarray], limit: float) -> str | None:
    return "sign_reversed" if _near(values, -data[axis], limit) else _scaled(values, data[axis], limit)


def _scaled(values: np.ndarray, right: np.ndarray, limit: float) -> str | None:
    factor = _factor(values, right)
    return "another_scale" if factor and _near(values, factor * right, abs(factor) * limit) else None


def _factor(values: np.ndarray, right: np.ndarray) -> float:
    """Return the factor by which the right values come nearest to the drawn ones."""
    return float(values @ right / (right @ right)) if np.isfinite(values).all() and right.any() else 0.0


_OF_ITS_OWN = {
    "time": _time_mistake,
    "theta": _yaw_mistake,
    "velocity": _speed_mistake,
    "x": lambda *known: _position_mistake("x", *known),
    "y": lambda *known: _position_mistake("y", *known),
}


def _is_cut_off(limits: np.ndarray, rows: np.ndarray) -> bool:
    """Do samples lie outside the limits of the axes?"""
    ends = np.sort(limits.reshape(2, 2), axis=1)
    room = SLIVER * np.ptp(rows, axis=0)
    return bool(np.any(rows < ends[:, 0] - room) or np.any(rows > ends[:, 1] + room))


_SIDES = (Text("horizontal", "横"), Text("vertical", "縦"))
_LABEL = Text(" Look at the {side} axis: its label is {label!r}.", "{side}軸のラベルは{label!r}です。")
_NO_LABEL = Text(" Look at the {side} axis.", "{side}軸を確かめてください。")

#: every fault of a graph: where on the ladder it is, what it costs, what is said
FAULTS = {
    "nothing_drawn": _Fault(
        "shape",
        1.0,
        Text(
            "There is nothing to see in these Axes: no line and no scatter of some length. If the graph was drawn before, "
            "plt.show() or plt.close() may have finished it and plt.gca() has then made a new, empty one. Keep the Axes from "
            "fig, ax = plt.subplots() and draw with ax.plot(...).",
            "このAxesには線も散布図も描かれていません。plt.show()やplt.close()の後にplt.gca()を呼ぶと、新しい空のAxesになります。"
            "fig, ax = plt.subplots()のaxをとっておき、ax.plot(...)で描きましょう。",
        ),
    ),
    "line_hidden": _Fault(
        "shape",
        0.8,
        Text(
            "The line is there, but it cannot be seen: it is set invisible or transparent, or has neither a line style nor a marker.",
            "線はありますが見えません。visible=Falseや透明になっているか、線種もマーカーもない設定になっています。",
        ),
    ),
    "samples_missing": _Fault(
        "shape",
        0.7,
        Text(
            "What is drawn is right, but it is only a part of the samples. Draw the whole log: all rows, without slices or steps.",
            "描かれた点は正しいのですが、サンプルの一部だけです。スライスや間引きをせず、ログの全行を描きましょう。",
        ),
    ),
    "points_in_another_order": _Fault(
        "value",
        0.7,
        Text(
            "The points are right, but the line joins them in another order, so that it runs criss-cross. Leave them in the order of time.",
            "点は正しいのですが、つなぐ順序が違うため、線が行ったり来たりしています。時刻の順のまま描きましょう。",
        ),
    ),
    "axes_exchanged": _Fault(
        "value",
        0.7,
        Text(
            "The axes are exchanged: what belongs to the right runs upwards. plot takes the horizontal values first, then the vertical ones.",
            "縦軸と横軸が入れ替わっています。plotの引数は、横軸の値、縦軸の値の順です。",
        ),
    ),
    "another_quantity_drawn": _Fault(
        "value",
        0.9,
        Text(
            "Another quantity of the drive is drawn. Compare the key in the plot command with what the graph is to show.",
            "別の量が描かれています。plotに渡した項目の名前と、グラフに描くべき量を見比べてください。",
        ),
    ),
    "time_not_from_the_start": _Fault(
        "value",
        0.5,
        Text(
            "The time axis shows the stamps of the log, such as Unix time. Seconds from the start are asked for: subtract the first stamp.",
            "時間軸がUnix時間などログの時刻のままです。最初の時刻を引いて、開始からの秒数にしましょう。",
        ),
    ),
    "row_numbers_for_time": _Fault(
        "value",
        0.6,
        Text(
            "The horizontal axis counts rows. With one argument plot(y) numbers the values; give it the time first: plot(t, y).",
            "横軸が行番号になっています。plot(y)のように引数が1つだと番号が振られるので、plot(t, y)と時刻を先に渡しましょう。",
        ),
    ),
    "time_in_another_unit": _Fault(
        "unit",
        0.5,
        Text(
            "The time is right up to a factor: it is in another unit, such as milliseconds or minutes. Seconds are asked for.",
            "時間が定数倍になっています。ミリ秒や分などではなく、秒で描きましょう。",
        ),
    ),
    "equal_time_steps": _Fault(
        "value",
        0.5,
        Text(
            "The time axis has equal steps, as if every row came after the same dt. The stamps of this log jitter: take its time column.",
            "時間軸が等間隔です。すべての行の間隔が同じとみなしていませんか。このログの時刻はばらつくので、時刻の列を使いましょう。",
        ),
    ),
    "yaw_wrapped": _Fault(
        "value",
        0.6,
        Text(
            "The yaw jumps by a whole turn: it is wrapped. A graph of the yaw must show how often the robot has turned round; draw it unwrapped.",
            "ヨー角が1回転分跳んでいます。何周したか分かるように、折り返さずに描きましょう。",
        ),
    ),
    "rad_labelled_as_deg": _Fault(
        "unit",
        0.5,
        Text(
            "The yaw is drawn in rad, and the label says degrees. Either will do, but label and numbers must agree.",
            "ラベルは度なのに、radの値が描かれています。どちらでもかまいませんが、ラベルと数値をそろえましょう。",
        ),
    ),
    "deg_labelled_as_rad": _Fault(
        "unit",
        0.5,
        Text(
            "The yaw is drawn in degrees, and the label says rad. Either will do, but label and numbers must agree.",
            "ラベルはradなのに、度の値が描かれています。どちらでもかまいませんが、ラベルと数値をそろえましょう。",
        ),
    ),
    "speed_without_sign": _Fault(
        "value",
        0.6,
        Text(
            "The speed has no sign: where the robot reverses it must lie below zero. From x and y, by hypot or with abs(), it is never "
            "negative; take the mean of the wheels.",
            "速度に符号がありません。後退では0より下になります。xとyからhypotで求めたりabs()を取ったりすると負にならないので、"
            "両輪の平均を使いましょう。",
        ),
    ),
    "speed_with_one_dt": _Fault(
        "value",
        0.6,
        Text(
            "The speed is computed with one dt for all rows. The stamps jitter, and the increments with them: each row has a dt of its own.",
            "すべての行を同じdtで割っています。時刻はばらつき、増分もそれに応じて変わるので、行ごとのdtで割りましょう。",
        ),
    ),
    "sign_reversed": _Fault(
        "value",
        0.7,
        Text(
            "What is drawn has the opposite sign, a mirror image. Draw the values as they are, and keep the signs of the robot: those "
            "of its wheels and of its tread.",
            "符号が逆で、鏡像になっています。値をそのまま描き、ロボットの車輪とトレッドの符号もそのまま使いましょう。",
        ),
    ),
    "another_scale": _Fault(
        "unit",
        0.5,
        Text(
            "The numbers are right up to a factor: they are in another unit (cm, mm, km/h), or something is doubled or halved on the "
            "way. Draw metres, or metres per second.",
            "数値が定数倍になっています。cm、mm、km/hなど別の単位か、途中で2倍や半分にしていませんか。mまたはm/sで描きましょう。",
        ),
    ),
    "data_wrong": _Fault(
        "value",
        1.0,
        Text(
            "No line goes through the samples of this log. Is it the log that the notebook loads here, and the result of your own "
            "wheel_odometry? Then look whether that check passes.",
            "このログのサンプルを通る線がありません。ここで読み込むログを使い、自分の関数の結果を描いているか確かめてください。"
            "その関数の確認が正解になっているかも見てみましょう。",
        ),
    ),
    "cut_off": _Fault(
        "shape",
        0.5,
        Text(
            "A part of the data lies outside the limits of the axes. Leave xlim and ylim away, or choose them wide enough.",
            "データの一部が軸の範囲からはみ出しています。xlimとylimを指定しないか、十分広くしましょう。",
        ),
    ),
    "other_scale": _Fault(
        "shape",
        0.5,
        Text(
            "The axes have not the scales that are asked for. Logarithmic axes cannot show negative values; motion belongs on plain, "
            "linear axes, errors over steps on log-log axes.",
            "軸の目盛りの種類が違います。対数軸では負の値を表せません。動きのグラフは普通の線形軸に、刻み幅と誤差のグラフは両対数軸に描きます。",
        ),
    ),
    "x_axis_turned_round": _Fault(
        "shape",
        0.4,
        Text(
            "The horizontal axis runs from right to left. Let its numbers grow to the right.",
            "横軸の向きが逆で、左に行くほど大きくなっています。右に増えるようにしましょう。",
        ),
    ),
    "aspect_not_equal": _Fault(
        "shape",
        0.4,
        Text(
            'A metre to the right is not as long as a metre upwards, so that a circle looks like an ellipse. ax.set_aspect("equal") mends it.',
            '横の1 mと縦の1 mの長さが違い、円が楕円に見えてしまいます。ax.set_aspect("equal")でそろえましょう。',
        ),
    ),
    "label_missing": _Fault(
        "shape",
        0.3,
        Text(
            "An axis has no label. A reader needs quantity and unit on both axes.",
            "ラベルのない軸があります。読む人のために、両方の軸に量と単位を書きましょう。",
        ),
    ),
    "quantity_missing": _Fault(
        "shape",
        0.2,
        Text(
            "A label names no quantity, only a unit. Say what is drawn too.",
            "ラベルに単位しかありません。何を描いたのか、量の名前も書きましょう。",
        ),
    ),
    "another_quantity_named": _Fault(
        "shape",
        0.3,
        Text(
            "A label names another quantity than the one that belongs on its axis. Are the labels of both axes exchanged, or copied?",
            "ラベルの量が、その軸に描くべきものと違います。縦横のラベルを取り違えたり、別のグラフから写したりしていませんか。",
        ),
    ),
    "unit_missing": _Fault(
        "unit",
        0.2,
        Text(
            "A label names no unit that is known. Write it in brackets behind the quantity.",
            "ラベルに単位がありません(または読み取れません)。量の名前の後に括弧で書きましょう。",
        ),
    ),
    "another_unit": _Fault(
        "unit",
        0.3,
        Text(
            "A label names a unit that does not belong to its quantity here. Times are in s, ways in m, speeds in m/s, yaw in rad or deg.",
            "ラベルの単位が量に合っていません。時間はs、位置はm、速度はm/s、ヨー角はradまたはdegです。",
        ),
    ),
    "legend_missing": _Fault(
        "shape",
        0.3,
        Text(
            "The lines have no legend, so that nobody knows which is which. Give each a label and call ax.legend().",
            "凡例がないので、どの線が何か分かりません。各線にlabelを付けてax.legend()を呼びましょう。",
        ),
    ),
}
