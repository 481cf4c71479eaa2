"""Graphs for xy_axes: right ones in honest styles, wrong ones as students draw them. RESULT is set to what must be shown."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

RESULT = {}


def plain():
    _, ax = plt.subplots()
    ax.plot(RESULT["x"], RESULT["y"])
    ax.set_xlabel("x [m]")
    ax.set_ylabel("y [m]")
    ax.set_aspect("equal")
    return ax


def pyplot_only():
    plt.figure(figsize=(9, 3))
    plt.plot(RESULT["x"].tolist(), RESULT["y"].tolist(), "r--", lw=0.7, label="odometry")
    plt.plot([0], [0], "ko", label="start")
    plt.axis("equal")
    plt.xlabel("x (m)")
    plt.ylabel("y (m)")
    plt.title("Trajectory")
    plt.legend()
    plt.grid()
    return plt.gca()


def scatter_in_japanese():
    ax = plt.figure().add_axes((0.1, 0.1, 0.8, 0.8))
    dots = ax.scatter(RESULT["x"], RESULT["y"], s=2, c=RESULT["time"])
    plt.colorbar(dots, ax=ax, label="時刻 [s]")
    ax.set(xlabel="前方の位置 x［m］", ylabel="横方向の位置 y［m］", aspect=1, title="走行経路")
    return ax


def coloured_by_speed():
    points = np.column_stack([RESULT["x"], RESULT["y"]])
    lines = LineCollection(np.stack([points[:-1], points[1:]], axis=1), cmap="viridis")
    lines.set_array(RESULT["velocity"][1:])
    _, ax = plt.subplots()
    ax.add_collection(lines)
    ax.autoscale()
    ax.set_aspect("equal", adjustable="datalim")
    ax.set_xlabel(r"$x$ / m")
    ax.set_ylabel(r"$y$ / m")
    return ax


def forward_and_reverse_apart():
    _, ax = plt.subplots()
    back = RESULT["velocity"] < 0
    for chosen, colour in ((back, "tab:red"), (~back, "tab:blue")):
        ax.plot(np.where(chosen, RESULT["x"], np.nan), np.where(chosen, RESULT["y"], np.nan), color=colour)
    ax.axis("scaled")
    ax.set(xlabel="X position, m", ylabel="Y position, m")
    return ax


def upper_left_of_four():
    _, axes = plt.subplots(2, 2)
    axes[0, 0].plot(RESULT["x"], RESULT["y"], "k.", ms=1)
    axes[0, 0].set_aspect("equal", "box")
    axes[0, 0].set_xlabel("$x\\ [\\mathrm{m}]$")
    axes[0, 0].set_ylabel("$y\\ [\\mathrm{m}]$")
    axes[0, 1].plot(RESULT["time"], RESULT["theta"])
    return axes[0, 0]


def with_references_drawn_first():
    ax = plt.subplot()
    ax.axhline(0, color="gray")
    ax.axvline(0, color="gray")
    ax.plot(RESULT["x"] + 0.5, RESULT["y"] - 0.3, "g:", label="truth")
    ax.plot(np.float32(RESULT["x"]), np.float32(RESULT["y"]), marker=".", label="wheels")
    ax.quiver(RESULT["x"][::50], RESULT["y"][::50], np.cos(RESULT["theta"][::50]), np.sin(RESULT["theta"][::50]))
    ax.invert_yaxis()  # y of this robot points to the right
    ax.set(xlabel="x[m]", ylabel="y[m]", xlim=(-20, 20), ylim=(20, -20))
    ax.set_aspect("equal")
    return ax


def square_box_by_hand():
    _, ax = plt.subplots()
    ax.plot(RESULT["x"][::-1], RESULT["y"][::-1])
    ax.set(xlim=(-15, 15), ylim=(-15, 15), xlabel="位置 x (メートル)", ylabel="位置 y (メートル)")
    ax.set_box_aspect(1)
    return ax


RIGHT = {
    "plain": plain,
    "pyplot, start marker": pyplot_only,
    "scatter, Japanese": scatter_in_japanese,
    "LineCollection coloured by speed": coloured_by_speed,
    "forward and reverse in two colours": forward_and_reverse_apart,
    "one of four, dots": upper_left_of_four,
    "references, arrows, y downwards": with_references_drawn_first,
    "backwards, box aspect, Japanese": square_box_by_hand,
}


def finished(ax, xlabel="x [m]", ylabel="y [m]", aspect="equal"):
    ax.set(xlabel=xlabel, ylabel=ylabel, aspect=aspect)
    return ax


def graph(x, y, *style, **how):
    _, ax = plt.subplots()
    ax.plot(x, y, *style, **how)
    return ax


def no_labels():
    ax = graph(RESULT["x"], RESULT["y"])
    ax.set_aspect("equal")
    return ax


def labels_without_units():
    return finished(graph(RESULT["x"], RESULT["y"]), "x", "y")


def labels_exchanged():
    return finished(graph(RESULT["x"], RESULT["y"]), "y [m]", "x [m]")


def x_upwards():
    return finished(graph(RESULT["y"], RESULT["x"]), "y [m]", "x [m]")


def free_aspect():
    return finished(graph(RESULT["x"], RESULT["y"]), aspect="auto")


def stretched():
    return finished(graph(RESULT["x"], RESULT["y"]), aspect=2)


def first_half():
    half = len(RESULT["x"]) // 2
    return finished(graph(RESULT["x"][:half], RESULT["y"][:half]))


def every_other():
    return finished(graph(RESULT["x"][::2], RESULT["y"][::2]))


def last_sample_missing():
    return finished(graph(RESULT["x"][:-1], RESULT["y"][:-1]))


def end_points_only():
    return finished(graph(RESULT["x"][[0, -1]], RESULT["y"][[0, -1]], "o"))


def centimetres_said_to_be_metres():
    return finished(graph(100 * RESULT["x"], 100 * RESULT["y"]))


def centimetres():
    return finished(graph(100 * RESULT["x"], 100 * RESULT["y"]), "x [cm]", "y [cm]")


def mirrored():
    return finished(graph(RESULT["x"], -RESULT["y"]))


def over_time():
    return finished(graph(RESULT["time"], RESULT["x"]))


def sorted_by_x():
    order = np.argsort(RESULT["x"])
    return finished(graph(RESULT["x"][order], RESULT["y"][order]))


def rotated():
    turned = (RESULT["x"] + 1j * RESULT["y"]) * np.exp(0.3j)
    return finished(graph(turned.real, turned.imag))


def heading_read_in_degrees():
    steps = RESULT["velocity"][1:] * np.diff(RESULT["time"])
    heading = np.rad2deg(RESULT["theta"][:-1])
    return finished(graph(np.append(0, np.cumsum(steps * np.cos(heading))), np.append(0, np.cumsum(steps * np.sin(heading)))))


def transparent():
    return finished(graph(RESULT["x"], RESULT["y"], alpha=0.0))


def without_style():
    return finished(graph(RESULT["x"], RESULT["y"], linestyle="none"))


def zoomed():
    ax = finished(graph(RESULT["x"], RESULT["y"]))
    ax.set_xlim(0, 1)
    return ax


def turned_round():
    ax = finished(graph(RESULT["x"], RESULT["y"]))
    ax.invert_xaxis()
    return ax


def logarithmic():
    ax = finished(graph(RESULT["x"], RESULT["y"]))
    ax.set_yscale("symlog")
    return ax


def closed_too_early():
    plain()
    plt.close()
    return plt.gca()


def labels_taken_off_with_the_axes():
    ax = plain()
    ax.axis("off")
    return ax


def the_empty_neighbour():
    _, (one, other) = plt.subplots(1, 2)
    finished(one).plot(RESULT["x"], RESULT["y"])
    return finished(other)


def only_an_area():
    _, ax = plt.subplots()
    ax.fill(RESULT["x"], RESULT["y"])
    return finished(ax)


WRONG = {
    "no labels": (no_labels, "quantity and unit asked for", "plain"),
    "no units": (labels_without_units, "units missing", "plain"),
    "labels exchanged": (labels_exchanged, "y where x is", "plain"),
    "x upwards": (x_upwards, "x is to the right", "plain"),
    "free aspect": (free_aspect, "a circle looks like an ellipse", "plain"),
    "stretched": (stretched, "aspect of 2", "plain"),
    "first half": (first_half, "part of the drive", "plain"),
    "every other sample": (every_other, "all samples asked for", "subtle"),
    "last sample missing": (last_sample_missing, "slice too short", "subtle"),
    "end points": (end_points_only, "no path", "plain"),
    "cm, labelled m": (centimetres_said_to_be_metres, "times 100", "plain"),
    "cm": (centimetres, "m asked for", "plain"),
    "mirrored": (mirrored, "abs(tread)", "plain"),
    "x over time": (over_time, "another graph", "plain"),
    "sorted": (sorted_by_x, "criss-cross", "subtle"),
    "rotated": (rotated, "another frame", "subtle"),
    "heading in degrees": (heading_read_in_degrees, "cos of degrees", "subtle"),
    "transparent": (transparent, "alpha 0", "subtle"),
    "no line style": (without_style, "neither line nor markers", "subtle"),
    "zoomed": (zoomed, "most of the path cut off", "plain"),
    "x axis turned round": (turned_round, "x to the left", "subtle"),
    "logarithmic": (logarithmic, "symlog y axis", "subtle"),
    "closed": (closed_too_early, "gca() after close()", "plain"),
    "axis off": (labels_taken_off_with_the_axes, "labels not seen", "subtle"),
    "the empty neighbour": (the_empty_neighbour, "drawn into the other Axes", "plain"),
    "filled": (only_an_area, "fill instead of plot", "plain"),
}
