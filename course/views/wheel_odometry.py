"""Views of the notebook on the practical with wheel odometry."""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from course.language import Text
from course.plotting import Colour, Picture, dot, in_chosen_language, line, make_xy, new_figure, styled
from course.robots import Robot
from course.views.view import Slider, View, report

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

Columns = Mapping[str, "ArrayLike"]
Odometry = Callable[[dict[str, "NDArray[np.float64]"], Robot], Columns]

MOST_POINTS = 600  # of a drawn path: more are not seen at this size, and would slow the sliders down

NO_PATH = Text(
    "The program must return a dict with x, y and theta, one finite number each for every row of the log.",
    "プログラムはx、y、thetaを含むdictを返し、それぞれログの行数と同じ個数の有限の数をもたなければなりません。",
)


def calibration_view(odometry: Odometry, log: Columns, truth: Columns, robot: Robot) -> View:
    """Show how wrong parameters bend the path that `odometry(log, robot)` computes, against the truth.

    `odometry` is the reader's own program and returns a dict with x [m], y [m] and theta [rad]; `truth` holds the same at the
    log's rows. The sliders make the robot's parameters wrong: the radius of both wheels, that of the right wheel alone, the tread.

    Raises ValueError if the program returns anything else.
    """
    rows = np.size(log["time"])
    true_path = _poses(truth, rows)
    limits = _limits(true_path)

    def draw(radius: float, right: float, tread: float) -> Picture:
        assumed = replace(robot, radius=robot.radius * (1 + radius / 100), tread=robot.tread * (1 + tread / 100))
        # only the ratio r / (Gear CRev) enters the odometry, so a larger wheel and more counts are the same
        counter = f"counter{robot.right_counter}"
        # a copy for every call: the reader's program may change what it is given
        columns = {name: np.array(values, dtype=np.float64) for name, values in log.items()}
        columns[counter] *= 1 + right / 100
        path = _poses(odometry(columns, assumed), rows)
        return _picture_of_paths(true_path, path, limits, (radius, right, tread))

    return View(
        draw,
        Slider(Text("radius of both wheels [%]", "両輪の半径 [%]"), -5, 5, 0.25, 0),
        Slider(Text("radius of right wheel [%]", "右車輪だけの半径 [%]"), -1, 1, 0.05, 0),
        Slider(Text("tread [%]", "トレッド [%]"), -5, 5, 0.25, 0),
    )


def _poses(columns: Columns, rows: int) -> "NDArray[np.float64]":
    """Return x, y, theta as (rows, 3), or say what a program has to return."""
    try:
        poses = np.column_stack([np.asarray(columns[name], dtype=np.float64) for name in ("x", "y", "theta")])
    except (TypeError, ValueError, KeyError, IndexError):
        raise ValueError(in_chosen_language(NO_PATH)) from None
    if poses.shape != (rows, 3) or not np.isfinite(poses).all():
        raise ValueError(in_chosen_language(NO_PATH))
    return poses


def _limits(path: "NDArray[np.float64]") -> tuple[float, float, float, float]:
    """Return x and y limits with room around the path for the wrong ones, in the proportions of the axes."""
    low, high = path[:, :2].min(axis=0), path[:, :2].max(axis=0)
    half = 0.75 * max(float((high - low).max()), 0.5)
    x, y = (low + high) / 2
    return x - half, x + half, y - half, y + half


def _picture_of_paths(
    truth: "NDArray[np.float64]",
    path: "NDArray[np.float64]",
    limits: tuple[float, float, float, float],
    errors: tuple[float, float, float],
) -> Picture:
    with styled():
        figure, axes = _plane(limits)
        shown = np.linspace(0, len(path) - 1, min(len(path), MOST_POINTS)).round().astype(int)
        for poses, colour, style in ((path, Colour.PATH, {"width": 2.2, "linestyle": "-"}), (truth, Colour.INK, {"width": 1.6})):
            points = poses[shown, 0] + 1j * poses[shown, 1]
            line(axes, *points, colour=colour, zorder=5, **style)
            dot(axes, points[-1], colour, 8)
        end, turned = path[-1] - truth[-1], math.degrees(path[-1, 2] - truth[-1, 2])
        gap = path[-1] - path[0]
        numbers = {"end": math.hypot(end[0], end[1]), "turned": round(turned, 1) + 0.0, "closing": math.hypot(gap[0], gap[1])}
        report(figure, [(text.format(**numbers), colour) for text, colour in REPORT])
        named = dict(zip(("radius", "right", "tread"), errors, strict=True))
        return Picture(figure, PATHS_ALT.format(**numbers, **named))


REPORT: list[tuple[Text, Colour]] = [
    (Text("truth", "真値"), Colour.INK),
    (Text("your program", "あなたのプログラム"), Colour.PATH),
    (Text("", ""), Colour.INK),
    (Text("end off by", "終点のずれ"), Colour.INK),
    (Text("{end:.2f} m, {turned:+.1f}°", "{end:.2f} m、{turned:+.1f}°"), Colour.INK),
    (Text("", ""), Colour.INK),
    (Text("from start to end", "始点から終点まで"), Colour.QUIET),
    (Text("{closing:.2f} m", "{closing:.2f} m"), Colour.QUIET),
]
PATHS_ALT = Text(
    "Path of the log with the radius of both wheels off by {radius:g} %, that of the right wheel by another {right:g} %, and the "
    "tread by {tread:g} %: it ends {end:.2f} m and {turned:+.1f} degrees from the truth, {closing:.2f} m from its own start.",
    "両輪の半径を{radius:g} %、さらに右車輪だけを{right:g} %、トレッドを{tread:g} %ずらして計算した経路。終点は真値から{end:.2f} m、{turned:+.1f}度ずれ、"
    "自身の始点から{closing:.2f} m離れている。",
)


def _plane(limits: tuple[float, float, float, float]) -> "tuple[Figure, Axes]":
    figure = new_figure(7.6, 4.9)
    axes = figure.add_axes((0.1, 0.13, 0.55, 0.84))
    make_xy(axes)
    axes.set(xlim=limits[:2], ylim=limits[2:])
    return figure, axes
