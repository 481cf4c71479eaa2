"""Drawings of the notebook on numerical integration."""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from course.language import Text
from course.plotting import Colour, arrow, dimension, dot, line, new_figure, pictured, write

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


@pictured(
    Text(
        "The area under a rising curve, cut into three pieces of width h. Left: rectangles as high as the curve at the left "
        "edge of each piece; triangles below the curve stay empty. Right: trapezoids A, B and C, whose upper side joins two "
        "points of the curve; hardly anything stays empty.",
        "右上がりの曲線の下の面積を、幅hの3つの区間に分けた図。左は各区間の左端の高さをもつ長方形で、曲線の下に三角形のすき間が残る。"
        "右は曲線上の2点を結ぶ台形A、B、Cで、すき間はほとんどない。",
    )
)
def pieces_of_area() -> "Figure":
    """Draw the three pieces of slides 003, figure 4.12: as Euler's rectangles and as the trapezoids A, B and C."""
    left, right = _two_panels()
    stamps = (0, 1, 2, 3)
    for axes, slope, colour in ((left, 0.0, Colour.EULER), (right, 1.0, Colour.ARC)):
        line(axes, *map(_point, np.linspace(0, 3.15, 200)), colour=Colour.INK, width=2.2, linestyle="-", zorder=5)
        for start in stamps[:-1]:
            _draw_piece(axes, _point(start), start + 1 + 1j * _point(start + slope).imag, colour)
        for stamp in stamps:
            dot(axes, _point(stamp))
        dimension(axes, 1 + 0.2j, 2 + 0.2j, "$h$")
        axes.set(xlim=(-0.25, 3.5), ylim=(0, 3.3), xticks=stamps, yticks=())
        axes.set_xticklabels(["$t_0 = a$", "$t_1$", "$t_2$", "$t_3 = b$"], fontsize=14)
    write(left, 1.5 + 3.1j, Text("left rectangles (Euler)", "左端の長方形（オイラー法）"), Colour.EULER, 12.5)
    write(right, 1.5 + 3.1j, Text("trapezoids", "台形"), Colour.ARC, 12.5)
    write(left, _point(1) - 0.08 + 0.3j, "$f(t_1)$", size=14, ha="right")
    for at, name in ((0.5, "A"), (1.5, "B"), (2.5, "C")):
        write(right, at + 0.5j, name, Colour.ARC, 17, bbox=None)
    for stamp, name in ((1, "$f(t_1)$"), (2, "$f(t_2)$")):
        write(right, _point(stamp) - 0.08 + 0.3j, name, size=14, ha="right")
    return left.figure  # type: ignore[return-value]


def _two_panels() -> "tuple[Axes, Axes]":
    figure = new_figure(7.6, 3.5)
    left, right = figure.subplots(1, 2)
    figure.subplots_adjust(left=0.03, right=0.98, top=0.97, bottom=0.14, wspace=0.08)
    for axes in (left, right):
        axes.grid(visible=False)
        axes.spines["left"].set_visible(False)
        axes.tick_params(axis="x", length=0)
    return left, right


def _point(t: float) -> complex:
    """Return the point at t of the curve that stands for a speed in these drawings."""
    return complex(t, 0.7 + 0.25 * t + 0.15 * t**2)


def _draw_piece(axes: "Axes", start: complex, end: complex, colour: str) -> None:
    """Fill the piece of area below the straight line from `start` to `end`."""
    axes.fill_between([start.real, end.real], [start.imag, end.imag], facecolor=colour, alpha=0.2, linewidth=0, zorder=1)
    line(axes, start.real, start, end, end.real, colour=colour, width=1.6, linestyle="-", zorder=3)


@pictured(
    Text(
        "Five trapezoids under a curve from a to b, numbered i = 0 to 4. The loop i < n - 1 adds those from 0 to 3; the last "
        "one, i = 4, is hatched and never added.",
        "aからbまでの曲線の下に、i = 0から4までの番号をつけた5つの台形がある図。i < n - 1のループが足すのは0から3までで、斜線を引いた最後のi = 4は足されない。",
    )
)
def last_trapezoid() -> "Figure":
    """Draw what the loop of slides 003, i < n - 1, adds up for n = 5, and what it leaves out."""
    figure = new_figure(6.4, 3.4)
    axes = figure.add_axes((0.03, 0.15, 0.94, 0.83))
    axes.grid(visible=False)
    axes.spines["left"].set_visible(False)
    corners = [_point(t) for t in np.linspace(0, 3, 6)]
    line(axes, *corners, colour=Colour.INK, width=2.2, linestyle="-", zorder=5)
    for i, (start, end) in enumerate(pairwise(corners)):
        colour = Colour.WRONG_WAY if end == corners[-1] else Colour.ARC
        _draw_piece(axes, start, end, colour)
        middle = (start + end).real / 2
        write(axes, middle + 0.35j, f"$i = {i}$", colour, 14)
    hatched = axes.fill_between([start.real, end.real], [start.imag, end.imag], facecolor="none", hatch="//", linewidth=0)
    hatched.set_edgecolor(Colour.WRONG_WAY)
    write(axes, 1.2 + 2.2j, Text("added by the loop", "ループが足す台形"), Colour.ARC)
    write(axes, 2.35 + 2.75j, Text("left out", "足されない台形"), Colour.WRONG_WAY, ha="right")
    arrow(axes, 2.38 + 2.7j, 2.62 + 2.2j, Colour.WRONG_WAY, 1.4)
    axes.set(xlim=(-0.1, 3.15), ylim=(0, 3.1), xticks=(0, 3), yticks=())
    axes.set_xticklabels(["$a$", "$b$"], fontsize=15)
    return figure


@pictured(
    Text(
        "The same four samples of a straight line, drawn twice. Left, at their own stamps 0, 0.1, 0.2 and 1 s: the trapezoids "
        "fill the area 0.50. Right, at equal distances as mean(dt) pretends: the line is bent, and the area is 0.27.",
        "直線上の同じ4つのサンプルを二通りに描いた図。左は実際の時刻0、0.1、0.2、1 sに置いたもので、台形の面積は0.50になる。"
        "右はmean(dt)を使うのと同じく等間隔に置いたもので、直線が折れ曲がり、面積は0.27になる。",
    )
)
def uneven_stamps() -> "Figure":
    """Draw the area under uneven samples with their own stamps, and with the mean of the steps."""
    left, right = _two_panels()
    values = np.array([0.0, 0.1, 0.2, 1.0])
    panels = (
        (left, values, Colour.RIGHT_WAY, Text("own stamps", "実際の時刻"), 0.72 + 0.2j),
        (right, np.linspace(0, 1, 4), Colour.WRONG_WAY, Text("mean(dt)", "mean(dt)を使うと"), 0.42 + 0.42j),
    )
    for axes, stamps, colour, title, place in panels:
        points = [complex(stamp, value) for stamp, value in zip(stamps, values, strict=True)]
        for start, end in pairwise(points):
            _draw_piece(axes, start, end, colour)
        for point in points:
            dot(axes, point)
        write(axes, 0.35 + 1.02j, title, colour)
        area = Text("area {size:.2f}", "面積 {size:.2f}").format(size=np.trapezoid(values, stamps))
        write(axes, place, area, colour, bbox=None)
        axes.set(xlim=(-0.08, 1.1), ylim=(0, 1.12), xticks=stamps, yticks=())
        axes.set_xticklabels(["$t_0$", "$t_1$", "$t_2$", "$t_3$"], fontsize=14)
    return left.figure  # type: ignore[return-value]


@pictured(
    Text(
        "A speed that grows with time. Left: samples, each the value at one instant, lie on the curve. Right: an encoder knows "
        "the mean over each interval only, a horizontal bar. Put at the end of its interval, as if it were a sample, each mean "
        "is half an interval late.",
        "時間とともに増える速度。左のサンプルは、ある瞬間の値で、曲線の上にある。右のエンコーダから分かるのは各区間の平均で、水平な棒で表される。"
        "これを区間の終わりの時刻のサンプルとみなすと、半区間だけ遅れた線になる。",
    )
)
def samples_and_means() -> "Figure":
    """Draw the difference between samples of a speed and its means over intervals."""
    left, right = _two_panels()
    stamps = np.arange(5.0)
    fine = np.linspace(0, 4, 200)
    for axes in (left, right):
        axes.plot(fine, _speed(fine), color=Colour.INK, linewidth=2.2, zorder=4)
        axes.vlines(stamps, 0, 3.2, color=Colour.METAL, linewidth=1)
        axes.set(xlim=(-0.2, 4.3), ylim=(0, 3.6), xticks=stamps, yticks=())
        axes.set_xticklabels([f"$t_{k}$" for k in range(5)], fontsize=14)
    left.plot(stamps, _speed(stamps), "o", color=Colour.ARC, markersize=9, zorder=6)
    write(left, 2 + 3.4j, Text("samples: values at an instant", "サンプル：ある瞬間の値"), Colour.ARC, 12)
    means = (_distance(stamps[1:]) - _distance(stamps[:-1])) / np.diff(stamps)
    right.hlines(means, stamps[:-1], stamps[1:], color=Colour.RIGHT_WAY, linewidth=4, zorder=6)
    right.plot(stamps[1:], means, "s--", color=Colour.WRONG_WAY, markersize=8, linewidth=1.5, zorder=7)
    write(right, 1.85 + 3.4j, Text("means over an interval", "区間の平均"), Colour.RIGHT_WAY, 12)
    dot(right, 2.5 + 1j * means[2], Colour.INK, 8)
    arrow(right, 2.56 + 1j * means[2], 2.93 + 1j * means[2], Colour.WRONG_WAY, 2, zorder=9)
    write(
        right,
        3.2 + 0.62j,
        Text("taken for samples:\nhalf an interval late", "サンプルとみなすと\n半区間遅れる"),
        Colour.WRONG_WAY,
        12,
    )
    return left.figure  # type: ignore[return-value]


def _speed(t: "NDArray[np.float64]") -> "NDArray[np.float64]":
    return 0.5 + 0.6 * t


def _distance(t: "NDArray[np.float64]") -> "NDArray[np.float64]":
    """Return the integral of `_speed` from 0."""
    return 0.5 * t + 0.3 * t**2
