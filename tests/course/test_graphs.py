"""Labels in many styles, and graphs by their structure; whole graphs are in tests/answers and tests/autograder."""

import re

import matplotlib as mpl
import numpy as np
import pytest

from course.figures import axes_summary, is_summary
from course.graphs import ANY_GRAPH, FAULTS, QUANTITIES, Structure, graph_fault, structure_fault, unit_and_name
from course.verdict import RUNGS

mpl.use("Agg")
import matplotlib.pyplot as plt

T = np.linspace(0, 12, 60) + 0.01 * np.sin(np.arange(60))
DRIVE = {
    "time": T - T[0],
    "x": 0.3 * T * np.cos(T),
    "y": 0.3 * T * np.sin(T),
    "theta": -0.8 * T,
    "velocity": 0.5 * np.cos(T),
    "yaw_rate": -0.8 + 0.1 * np.sin(2 * T),
}
PATH = Structure(x="x", y="y", equal_aspect=True)
YAW = Structure(x="time", y="theta")
SPEED = Structure(x="time", y="velocity")
ORDERS = Structure(scales=("log", "log"), lines=2, legend=True)
LABELS = {"x": "x [m]", "y": "y [m]", "time": "t [s]", "theta": "yaw [rad]", "velocity": "v [m/s]"}

GOOD_LABELS = {
    "x": "x [m]|x (m)|x / m|$x$ [m]|X[m]|x, m|x［m］|x（m）|位置x [m]|x座標[m]|x 【m】|$x\\,[\\mathrm{m}]$|x in m|x m|位置 [m]|x (メートル)"
    "|x [meters]|Position x (metre)|x_odo [m]|x方向 [m]|forward [m]|x: m|x<m>|x/m|$x / \\mathrm{m}$|x [m] (odometry)|x(t) [m]|ｘ［ｍ］"
    "|x-position (in m)|進行方向 x [m]|x [単位: m]",
    "time": "t [s]|時刻 [s]|時間 (s)|Time (sec)|time [sec.]|経過時間 [秒]|t/s|t / s|$t$ [s]|時刻t[s]|elapsed time, s|time in seconds"
    "|時間（秒）|t s|T [s]|時間[sec]|$t\\,/\\,\\mathrm{s}$|time since start (s)",
    "theta": "yaw [rad]|θ [rad]|$\\theta$ [rad]|ヨー角 [rad]|heading (deg)|方位[°]|方位角 [度]|yaw angle, degrees|ψ / deg|θ(t) [rad]"
    "|$\\psi\\ (\\mathrm{rad})$|heading in radians|向き (ラジアン)|$\\theta\\ [^\\circ]$|orientation [º]|yaw °|yaw (unwrapped) [rad]",
    "velocity": "v [m/s]|velocity (m/s)|速度 [m/s]|speed, m/s|v / (m/s)|v / m/s|$v$ [m s$^{-1}$]|$v\\,[\\mathrm{m/s}]$|v(t) in m/s"
    "|速さ [m/s]|speed (m s⁻¹)|speed [m·s⁻¹]|v [m/sec]|速度（m/秒）|$V$ [$\\frac{m}{s}$]|v m/s|v/m/s|速度 [メートル毎秒]|v [㎧]",
}
BAD_LABELS = {
    "x": {
        "label_missing": "| ",
        "unit_missing": "x|x []|x (odometry)|前後方向",
        "quantity_missing": "[m]|m|$[m]$|(メートル)",
        "another_unit": "x [cm]|x [rad]|x / mm|x (s)|x [px]",
        "another_quantity_named": "y [m]|time [m]|t [s]|yaw [m]|速度 [m/s]",
    },
    "time": {
        "unit_missing": "t|時刻|time",
        "quantity_missing": "[s]|s|秒",
        "another_unit": "t [ms]|time [min]|時間 (分)|t [m]",
        "another_quantity_named": "x [s]|v [s]",
    },
    "theta": {
        "unit_missing": "yaw|ヨー角|θ(t)",
        "quantity_missing": "[rad]|°|deg",
        "another_unit": "yaw [m]|yaw [rad/s]|ヨー角 [s]",
        "another_quantity_named": "t [rad]|角速度 [rad]|yaw rate [rad]|v [rad]",
    },
    "velocity": {
        "unit_missing": "v|速度|speed (signed)",
        "quantity_missing": "m/s|[m/s]|(m/s)",
        "another_unit": "v [m]|v [km/h]|speed [cm/s]|v (m/s^2)|速度 [rad/s]",
        "another_quantity_named": "角速度 [m/s]|x [m/s]|yaw [m/s]|angular velocity [m/s]",
    },
}


@pytest.fixture
def ax():
    yield plt.figure().add_subplot()
    plt.close("all")


def labelled(ax, structure, **changes):
    ax.set_xlabel(changes.get("x", LABELS[structure.x]))
    ax.set_ylabel(changes.get("y", LABELS[structure.y]))
    ax.set_aspect("equal" if structure.equal_aspect else "auto")
    return axes_summary(ax)


def slug(fault):
    return None if fault is None else fault.slug


@pytest.mark.parametrize(("quantity", "label"), [(key, one) for key, labels in GOOD_LABELS.items() for one in labels.split("|")])
def test_labels_in_many_styles_are_understood(quantity, label, ax):
    structure = Structure(x=quantity)
    ax.plot(T, T)
    ax.set_xlabel(label)
    assert slug(structure_fault(structure, axes_summary(ax))) is None


@pytest.mark.parametrize(
    ("quantity", "fault", "label"),
    [(key, fault, one) for key, faults in BAD_LABELS.items() for fault, labels in faults.items() for one in labels.split("|")],
)
def test_labels_that_lack_something_are_told_what(quantity, fault, label, ax):
    structure = Structure(y=quantity)
    ax.plot(T, T)
    ax.set_ylabel(label)
    found = structure_fault(structure, axes_summary(ax))
    assert slug(found) == fault
    assert 0 < found.score < 1
    assert "vertical" in found.text.en
    assert "縦軸" in found.text.ja


def test_every_unit_of_a_quantity_is_known():
    for quantity in QUANTITIES.values():
        for unit in quantity.units:
            assert unit_and_name(f"q [{unit}]") == (unit, "q")


def test_every_fault_says_something_in_both_languages():
    for fault in FAULTS.values():
        assert fault.rung in RUNGS
        assert 0 < fault.cost <= 1
        assert re.search("[ぁ-ん]", fault.text.ja)
        assert not re.search("[ぁ-ん]", fault.text.en)


RIGHT = [(PATH, "x", "y"), (YAW, "time", "theta"), (SPEED, "time", "velocity")]


@pytest.mark.parametrize(("structure", "x", "y"), RIGHT)
def test_the_data_with_labels_are_right(structure, x, y, ax):
    ax.plot(DRIVE[x], DRIVE[y])
    assert graph_fault(structure, labelled(ax, structure), DRIVE) is None


@pytest.mark.parametrize(("structure", "x", "y"), RIGHT)
@pytest.mark.parametrize("pieces", [2, 5, 12])
def test_the_data_in_pieces_are_right(structure, x, y, pieces, ax):
    for some in np.array_split(np.arange(len(T)), pieces):
        ax.plot(DRIVE[x][some], DRIVE[y][some])
    assert graph_fault(structure, labelled(ax, structure), DRIVE) is None


@pytest.mark.parametrize("missing", [slice(3, 4), slice(0, 20), slice(59, 60)])
def test_pieces_that_leave_something_out_are_not(missing, ax):
    keep = np.delete(np.arange(len(T)), missing)
    for some in np.array_split(keep, 3):
        ax.plot(DRIVE["x"][some], DRIVE["y"][some])
    assert slug(graph_fault(PATH, labelled(ax, PATH), DRIVE)) == "samples_missing"


def test_the_same_half_twice_is_not_the_whole(ax):
    for _ in range(2):
        ax.plot(DRIVE["time"][:30], DRIVE["theta"][:30])
    assert slug(graph_fault(YAW, labelled(ax, YAW), DRIVE)) == "samples_missing"


def test_a_right_line_is_found_among_others(ax):
    for shift in (-1.0, 0.0, 1.0):
        ax.plot(DRIVE["time"], DRIVE["theta"] + shift)
    assert graph_fault(YAW, labelled(ax, YAW), DRIVE) is None


def test_degrees_without_a_unit_lack_only_the_unit(ax):
    ax.plot(DRIVE["time"], np.degrees(DRIVE["theta"]))
    fault = graph_fault(YAW, labelled(ax, YAW, y="yaw"), DRIVE)
    assert slug(fault) == "unit_missing"


def test_what_follows_from_another_fault_costs_nothing(ax):
    ax.plot(1000 * DRIVE["time"], DRIVE["theta"])
    once, twice = (graph_fault(YAW, labelled(ax, YAW, x=label), DRIVE) for label in ("t [s]", "t [ms]"))
    assert once == twice
    assert once.slug == "time_in_another_unit"


def test_faults_add_up_and_the_data_are_told_first(ax):
    ax.plot(DRIVE["time"], -DRIVE["theta"])
    fault = graph_fault(YAW, labelled(ax, YAW, x="", y="yaw"), DRIVE)
    assert fault.slug == "sign_reversed"
    assert fault.score == pytest.approx(0.0)


def test_a_scatter_may_be_in_any_order(ax):
    order = np.random.default_rng(1).permutation(len(T))
    ax.scatter(DRIVE["x"][order], DRIVE["y"][order])
    assert graph_fault(PATH, labelled(ax, PATH), DRIVE) is None
    ax.clear()
    ax.plot(DRIVE["x"][order], DRIVE["y"][order])
    assert slug(graph_fault(PATH, labelled(ax, PATH), DRIVE)) == "points_in_another_order"


def test_what_is_not_finite_breaks_nothing(ax):
    for bad in (np.nan, np.inf):
        ax.plot(DRIVE["time"], np.where(T > 5, bad, DRIVE["theta"]))
    assert slug(graph_fault(YAW, labelled(ax, YAW), DRIVE)) == "samples_missing"
    ax.clear()
    ax.plot(T * np.nan, T)
    assert slug(graph_fault(YAW, labelled(ax, YAW), DRIVE)) == "nothing_drawn"


def test_a_still_drive_breaks_nothing(ax):
    still = {key: np.zeros(5) if key != "time" else np.arange(5.0) for key in DRIVE}
    ax.plot(np.arange(5.0), np.ones(5))
    for structure in (SPEED, YAW):
        fault = graph_fault(structure, labelled(ax, structure), still)
        assert (fault.slug, fault.score) == (None, 0.0)


def test_structure_of_a_log_log_graph(ax):
    ax.loglog(T[1:], T[1:], label="Euler")
    assert slug(structure_fault(ORDERS, axes_summary(ax))) == "nothing_drawn"
    ax.loglog(T[1:], T[1:] ** 2, label="trapezoid")
    assert slug(structure_fault(ORDERS, axes_summary(ax))) == "legend_missing"
    ax.legend()
    assert structure_fault(ORDERS, axes_summary(ax)) is None
    ax.set_yscale("linear")
    assert slug(structure_fault(ORDERS, axes_summary(ax))) == "other_scale"


def test_any_graph_needs_a_line(ax):
    assert slug(structure_fault(ANY_GRAPH, axes_summary(ax))) == "nothing_drawn"
    ax.plot([0, 1], [0, 1])
    assert slug(structure_fault(ANY_GRAPH, axes_summary(ax))) == "nothing_drawn"
    ax.plot(T, T)
    assert structure_fault(ANY_GRAPH, axes_summary(ax)) is None


UNSEEN = [
    {"visible": False},
    {"alpha": 0},
    {"color": "none"},
    {"linewidth": 0},
    {"linestyle": "None"},
    {"ls": "", "marker": "o", "ms": 0},
]


@pytest.mark.parametrize("style", UNSEEN, ids=str)
def test_lines_that_leave_no_mark_are_hidden(style, ax):
    ax.plot(DRIVE["time"], DRIVE["theta"], **style)
    assert slug(graph_fault(YAW, labelled(ax, YAW), DRIVE)) == "line_hidden"


def test_axes_that_are_not_shown_hide_their_lines(ax):
    ax.plot(DRIVE["time"], DRIVE["theta"])
    ax.set_visible(False)
    assert slug(graph_fault(YAW, labelled(ax, YAW), DRIVE)) == "line_hidden"


def test_a_label_counts_where_it_is_seen():
    figure, (upper, lower) = plt.subplots(2, 1, sharex=True)
    for one in (upper, lower):
        one.plot(DRIVE["time"], DRIVE["theta"])
        one.set_ylabel("yaw [rad]")
    assert slug(graph_fault(YAW, axes_summary(upper), DRIVE)) == "label_missing"
    lower.set_xlabel("t [s]")
    assert graph_fault(YAW, axes_summary(upper), DRIVE) is None
    lower.axis("off")
    assert slug(graph_fault(YAW, axes_summary(upper), DRIVE)) == "label_missing"
    plt.close(figure)


def test_a_line_that_changes_colour_is_a_line(ax):
    points = np.column_stack([DRIVE["x"], DRIVE["y"]])
    pieces = mpl.collections.LineCollection(np.stack([points[:-1], points[1:]], axis=1), array=T[1:])
    ax.add_collection(pieces)
    ax.autoscale()
    summary = labelled(ax, PATH)
    assert is_summary(summary)
    assert graph_fault(PATH, summary, DRIVE) is None
    ax.vlines([1, 2], 0, 1)
    assert len(axes_summary(ax)["lines"]) == 1


@pytest.mark.parametrize(
    ("limits", "fault"),
    [((-1, 20), None), ((0, T[-1] - T[0]), None), ((0, 6), "cut_off"), ((1, 20), "cut_off"), ((20, -1), "x_axis_turned_round")],
)
def test_limits(limits, fault, ax):
    ax.plot(DRIVE["time"], DRIVE["theta"])
    ax.set_xlim(limits)
    assert slug(graph_fault(YAW, labelled(ax, YAW), DRIVE)) == fault


def test_a_box_may_make_the_aspect(ax):
    ax.plot(DRIVE["x"], DRIVE["y"])
    ax.set(xlim=(-8, 8), ylim=(-4, 4))
    ax.set_box_aspect(0.5)
    summary = axes_summary(ax)
    assert summary["aspect"] == pytest.approx(1.0)
    ax.set_box_aspect(1.0)
    assert axes_summary(ax)["aspect"] == pytest.approx(2.0)
