"""A graph as plain data."""

import matplotlib as mpl
import numpy as np
import pytest
from hostile import loop

from course import figures
from course.answers import interview
from course.figures import axes_summary, is_axes, is_summary
from course.plain import identical

mpl.use("Agg")
import matplotlib.pyplot as plt

T = np.linspace(0, 2, 5)


@pytest.fixture
def ax():
    _, axes = plt.subplots()
    yield axes
    plt.close("all")


def test_what_is_drawn_comes_back(ax):
    ax.plot(T, T**2, "o-", label="square")
    ax.plot(T, -T, visible=False)
    ax.scatter(T, 2 * T, label="samples")
    ax.set(xlabel="t [s]", ylabel="時刻", title="title", xlim=(0, 3), ylim=(-1, 5), yscale="symlog", aspect=2.0)
    ax.legend()
    summary = axes_summary(ax)
    assert is_summary(summary)
    square, hidden = summary["lines"]
    assert np.array_equal(square["xy"], np.column_stack([T, T**2]))
    assert (square["label"], square["visible"]) == ("square", True)
    assert not hidden["visible"]
    [samples] = summary["points"]
    assert np.array_equal(samples["xy"], np.column_stack([T, 2 * T]))
    assert summary["labels"] == ["t [s]", "時刻"]
    assert summary["title"] == "title"
    assert summary["scales"] == ["linear", "symlog"]
    assert summary["limits"].tolist() == [0, 3, -1, 5]
    assert summary["aspect"] == 2.0
    assert summary["legend"] == ["square", "samples"]


def test_an_empty_graph(ax):
    summary = axes_summary(ax)
    assert is_summary(summary)
    assert summary["lines"] == summary["points"] == summary["legend"] == []
    assert summary["aspect"] == 0.0


ASPECTS = [("auto", 0.0), ("equal", 1.0), (0.5, 0.5)]


@pytest.mark.parametrize(("set_to", "aspect"), ASPECTS)
def test_aspect(ax, set_to, aspect):
    ax.set_aspect(set_to)
    assert axes_summary(ax)["aspect"] == aspect


def test_filled_areas_and_bars_are_no_points(ax):
    ax.fill_between(T, T, T + 1)
    ax.errorbar(T, T, yerr=1, fmt="none")
    ax.vlines([1, 2], 0, 1)
    ax.quiver(T, T, T, T)
    assert axes_summary(ax)["points"] == []
    ax.scatter([0.0], [0.0])
    assert axes_summary(ax)["points"][0]["xy"].tolist() == [[0, 0]]


DATA = [
    ([1, 2], [3, 4], [[1, 3], [2, 4]]),
    ([1.0, np.nan], [3.0, 4.0], [[1, 3], [np.nan, 4]]),
    (np.ma.masked_array([1.0, 2.0], mask=[False, True]), [3.0, 4.0], [[1, 3], [np.nan, 4]]),
    (np.array([1, 2], dtype="timedelta64[s]").astype(int), np.float32([3, 4]), [[1, 3], [2, 4]]),
    (["a", "b"], [3, 4], [[0, 3], [1, 4]]),
    ([], [], np.zeros((0, 2))),
]


@pytest.mark.parametrize(("x", "y", "xy"), DATA, ids=lambda value: str(value)[:30])
def test_points_that_are_not_drawn_are_nan(ax, x, y, xy):
    ax.plot(x, y)
    [line] = axes_summary(ax)["lines"]
    assert line["xy"].dtype == np.float64
    assert np.array_equal(line["xy"], xy, equal_nan=True)
    assert type(line["xy"]) is np.ndarray


def test_a_flood_is_capped(ax, monkeypatch):
    monkeypatch.setattr(figures, "MAX_LINES", 3)
    monkeypatch.setattr(figures, "MAX_POINTS", 10)
    for _ in range(5):
        ax.plot(T, T, label="a" * 30_000)
    ax.lines[0].set_data(np.arange(11), np.arange(11))
    summary = axes_summary(ax)
    assert len(summary["lines"]) == 2
    assert len(summary["lines"][0]["label"]) == 20_000


@pytest.mark.parametrize("projection", ["polar", "3d", "aitoff"])
def test_axes_of_other_kinds_are_read_too(projection):
    axes = plt.figure().add_subplot(projection=projection)
    axes.plot(T, T) if projection != "3d" else axes.plot(T, T, T)
    assert is_summary(axes_summary(axes))
    plt.close("all")


def test_dates_are_numbers(ax):
    ax.plot(np.array(["2024-01-01", "2024-01-02"], dtype="datetime64[s]"), [0, 1])
    [line] = axes_summary(ax)["lines"]
    assert np.diff(line["xy"][:, 0]).tolist() == [1.0]


def test_only_axes_are_axes(ax):
    assert is_axes(ax)
    claims = type("Claims", (), {"__class__": property(lambda self: type(ax))})()
    for other in (ax.figure, [ax], np.array([ax]), (ax.figure, ax), ax.plot(T, T), None, "ax", type(ax), claims):
        assert not is_axes(other)


def summary_with(**changes):
    good = {"lines": [], "points": [], "labels": ["", ""], "title": "", "scales": ["", ""]}
    return good | {"limits": np.zeros(4), "aspect": 0.0, "legend": []} | changes


SERIES = {"xy": np.zeros((3, 2)), "label": "", "visible": True}

MALFORMED = [
    None,
    [],
    {},
    summary_with(lines=None),
    summary_with(lines=[1]),
    summary_with(lines=[SERIES | {"xy": np.zeros(3)}]),
    summary_with(lines=[SERIES | {"xy": [[0, 0]]}]),
    summary_with(points=[SERIES | {"label": None}]),
    summary_with(points=[SERIES | {"visible": 1}]),
    summary_with(labels=[""]),
    summary_with(labels=["", None]),
    summary_with(title=1),
    summary_with(limits=np.zeros(3)),
    summary_with(limits=[0, 1, 0, 1]),
    summary_with(aspect="auto"),
    summary_with(legend=[None]),
]


@pytest.mark.parametrize("summary", MALFORMED, ids=lambda value: str(value)[:60])
def test_what_is_no_summary_is_recognised(summary):
    assert is_summary(summary_with(lines=[SERIES], points=[SERIES], legend=["a"]))
    assert not is_summary(summary)


def raises(*_):
    raise SystemExit("no")


@pytest.mark.parametrize("broken", [raises, loop], ids=["raises", "loops"])
@pytest.mark.parametrize("method", ["get_lines", "get_aspect", "get_legend"])
def test_axes_of_a_students_own_making_break_nothing(method, broken):
    own = type("Own", (plt.Axes,), {method: broken})
    talk = interview(own(plt.figure(), (0, 0, 1, 1)), (), time_limit=0.05)
    assert talk.figure is None
    assert talk.kind == "Own" or talk.replies[0].trouble.type == "TimeUp"
    plt.close("all")


def test_the_summary_does_not_share_the_graphs_memory(ax):
    [line] = ax.plot(T, T)
    before = axes_summary(ax)
    line.set_ydata(2 * T)
    assert not identical(before["lines"][0]["xy"], axes_summary(ax)["lines"][0]["xy"])
    assert np.array_equal(before["lines"][0]["xy"][:, 1], T)
