"""Drawings of the notebook on the practical with wheel odometry."""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import FancyBboxPatch

from course.drawings.robot import figure_of
from course.language import Text
from course.plotting import (
    Colour,
    arrow,
    dimension,
    dot,
    in_chosen_language,
    line,
    new_figure,
    new_sketch,
    note,
    pictured,
    write,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@pictured(
    Text(
        "The program of the practical, from left to right: five columns of the log file, the distances of the right and the "
        "left wheel, the motion of the body, the pose. Below, the three graphs to hand in: x-y and t-yaw from the pose, t-v "
        "from the motion of the body and the time column.",
        "実習のプログラムを左から右へ表した図。ログファイルの5列、左右の車輪の移動距離、車体の動き、姿勢の順に計算する。"
        "下は提出する3つのグラフ。x-yとt-yawは姿勢から、t-vは車体の動きと時刻の列から描く。",
    )
)
def practical() -> "Figure":
    """Draw the program from the log file to the three graphs (slides 000, practical training)."""
    axes = new_sketch((0, 12.4), (0, 6.2), width=8)
    log, wheels, body, pose = 1.5 + 4.7j, 5.0 + 4.7j, 8.0 + 4.7j, 10.9 + 4.7j
    _draw_box(axes, log, 2.6, 1.9)
    rows = ("0.000,  0,   0, 0, 0", "0.005, 12, −11, 9,−8", "0.010, 14, −12, 9,−9")
    for row, numbers in enumerate(rows):
        write(axes, log + 0.5j - 0.5j * row, numbers, size=8.5, family="monospace", bbox=None)
    for at, symbols in (
        (wheels, "$v_r\\,dt$\n$v_l\\,dt$"),
        (body, "$V\\,dt$\n$\\omega\\,dt$"),
        (pose, "$(x,\\ y,\\ \\theta)$"),
    ):
        _draw_box(axes, at, 1.9, 1.6)
        write(axes, at, symbols, Colour.PATH, 16, bbox=None)
    names = (
        (log, Text("log file", "ログファイル")),
        (wheels, Text("wheels", "車輪")),
        (body, Text("body", "車体")),
        (pose, Text("pose", "姿勢")),
    )
    for at, name in names:
        write(axes, at + 1.2j, name, size=13, bbox=None)
    steps = (
        (2.85, 4.0, Text("signs\nradius\ngear", "符号\n半径\nギア比")),
        (6.0, 7.0, Text("tread", "トレッド")),
        (9.0, 9.9, Text("sum", "累積")),
    )
    for start, end, text in steps:
        arrow(axes, start + 4.7j, end + 4.7j, Colour.INK)
        write(axes, (start + end) / 2 - 0.02 + 4.15j, text, Colour.HEADING, 10.5, va="top", bbox=None)
    _draw_small_graphs(axes)
    return figure_of(axes)


def _draw_box(axes: "Axes", centre: complex, width: float, height: float) -> None:
    corner = (centre.real - width / 2, centre.imag - height / 2)
    axes.add_patch(
        FancyBboxPatch(corner, width, height, "round,pad=0,rounding_size=0.12", facecolor=Colour.SHADE, edgecolor=Colour.QUIET)
    )


def _draw_small_graphs(axes: "Axes") -> None:
    """Draw the three graphs below the flow, each beneath what it is made from, and the arrows that lead there."""
    share = np.linspace(0, 1, 80)
    speed = 1.0 * np.interp(share, (0, 0.08, 0.55, 0.65, 0.9, 1), (0, 1, 1, -0.5, -0.5, 0))
    yaw = np.cumsum(np.where((share > 0.2) & (share < 0.8), 1.0, 0.0))
    path = np.cumsum(speed * np.exp(4.5j * yaw / yaw[-1]))
    path = 0.9 * (path - path.real.min()) / np.ptp(path.real)
    graphs = (
        (6.3, share * 1.9, 0.5 + 0.5 * speed, ("$t$", "$v$")),
        (9.0, share * 1.9, 0.1 + 1.1 * yaw / yaw[-1], ("$t$", "yaw")),
        (11.4, 0.25 + path.real, path.imag - path.imag.min() + 0.15, ("$x$", "$y$")),
    )
    floor = 0.75
    for centre, x, y, (across, up) in graphs:
        width = 2.0 if across == "$t$" else 1.4
        origin = complex(centre - width / 2, floor)
        arrow(axes, origin, origin + width + 0.1, Colour.QUIET, 1.2)
        arrow(axes, origin, origin + 1.55j, Colour.QUIET, 1.2)
        axes.plot(origin.real + x, floor + y, color=Colour.PATH, linewidth=2)
        write(axes, origin + width + 0.1 - 0.3j, across, size=12, bbox=None)
        write(axes, origin - 0.1 + 1.5j, up, size=12, ha="right", bbox=None)
    arrow(axes, 7.6 + 3.85j, 6.6 + 2.6j, Colour.QUIET, 1.2)
    arrow(axes, 10.6 + 3.85j, 9.4 + 2.6j, Colour.QUIET, 1.2)
    arrow(axes, 11.1 + 3.85j, 11.4 + 2.6j, Colour.QUIET, 1.2)
    line(axes, complex(5.3, floor + 0.5), complex(7.3, floor + 0.5), width=0.8)
    line(axes, 1.5 + 3.7j, 1.5 + 1.5j, 4.6 + 1.5j, width=1.2, linestyle="-")
    arrow(axes, 4.6 + 1.5j, 4.95 + 1.5j, Colour.QUIET, 1.2)
    write(axes, 3.1 + 1.5j, Text("time column", "時刻の列"), Colour.QUIET, 11)


@pictured(
    Text(
        "A time line with the stamps of rows 0 to 4, at slightly unequal distances. The counts of row k lie between stamp k-1 "
        "and stamp k, so those of row 0 lie before the log. The pose of row 0 is (0, 0, 0), that of row 4 stands at the last stamp.",
        "0行目から4行目までの時刻を、少し不揃いな間隔で並べた時間軸。k行目のカウントは時刻k-1と時刻kの間のもので、0行目のカウントはログが始まる前のものである。"
        "0行目の姿勢は(0, 0, 0)で、4行目の姿勢は最後の時刻のものである。",
    )
)
def log_rows() -> "Figure":
    """Draw which stretch of time the counts of each row belong to, and why row 0 is not used."""
    axes = new_sketch((-1.5, 9.6), (-1.9, 2.2), width=7.8)
    stamps = np.array([1.2, 3.1, 4.9, 7.0, 8.8])
    axes.axvspan(-1.5, stamps[0], color=Colour.SHADE, zorder=0)
    arrow(axes, -1.4, 9.5, Colour.INK, 1.5)
    for row, stamp in enumerate(stamps):
        line(axes, stamp - 0.2j, stamp + 0.2j, colour=Colour.INK, width=2, linestyle="-")
        write(axes, stamp - 0.5j, f"$t_{row}$", size=15, bbox=None)
        write(axes, stamp - 1.1j, f"$p_{row}$", Colour.PATH, 15, bbox=None)
    write(axes, stamps[0] - 1.6j, "$(0, 0, 0)$", Colour.PATH, 12, bbox=None)
    for row, (start, end) in enumerate(pairwise(stamps), 1):
        arrow(axes, start + 0.05 + 0.5j, end - 0.05 + 0.5j, Colour.RIGHT_WAY, 2)
        write(axes, (start + end) / 2 + 1.0j, f"$dE[{row}]$", Colour.RIGHT_WAY, 14, bbox=None)
    arrow(axes, -1.4 + 0.5j, stamps[0] - 0.05 + 0.5j, Colour.WRONG_WAY, 2, linestyle="--")
    write(axes, -0.1 + 1.0j, "$dE[0]$", Colour.WRONG_WAY, 14, bbox=None)
    write(axes, -0.1 + 1.75j, Text("before the log", "ログより前"), Colour.WRONG_WAY, 12, bbox=None)
    write(axes, 5.2 + 1.75j, Text("what the rows hold", "各行に入っているもの"), Colour.RIGHT_WAY, 12, bbox=None)
    return figure_of(axes)


@pictured(
    Text(
        "A time line with cycles of 5 ms. Two rows in the middle never reached the file, and the counts that they held are gone. "
        "The next row that did arrive has a dt of 15 ms, but counts of its own last 5 ms only: times 3 they stand for the whole gap.",
        "5 ms周期の時間軸。途中の2行はファイルに届かず、その行のカウントは失われた。次に届いた行のdtは15 msだが、カウントは最後の5 msの分しかない。"
        "それを3倍すれば、すき間全体の代わりになる。",
    )
)
def lost_cycles() -> "Figure":
    """Draw two cycles that are missing from a log, and what is left to guess their counts from."""
    axes = new_sketch((-0.6, 9.6), (-1.7, 2.3), width=7.6)
    stamps = 0.6 + 1.35 * np.arange(7)
    lost = (3, 4)
    arrow(axes, -0.5, 9.5, Colour.INK, 1.5)
    for row, stamp in enumerate(stamps):
        missing = row in lost
        style = {"linestyle": (0, (2, 2))} if missing else {"linestyle": "-"}
        line(axes, stamp - 0.2j, stamp + 0.2j, colour=Colour.QUIET if missing else Colour.INK, width=2, **style)
        write(axes, stamp - 0.5j, f"{5 * row}", Colour.QUIET if missing else Colour.INK, 12, bbox=None)
    write(axes, 9.25 - 0.5j, "[ms]", Colour.QUIET, 11, bbox=None)
    for row in range(1, 7):
        start, end = stamps[row - 1] + 0.05 + 0.45j, stamps[row] - 0.05 + 0.45j
        middle = (start + end) / 2 + 0.4j
        if row in lost:
            arrow(axes, start, end, Colour.WRONG_WAY, 1.6, linestyle="--")
            write(axes, middle, Text("lost", "消失"), Colour.WRONG_WAY, 12, bbox=None)
        else:
            arrow(axes, start, end, Colour.RIGHT_WAY, 2)
            write(axes, middle, ("20", "21", "", "", "22", "21")[row - 1], Colour.RIGHT_WAY, 13, bbox=None)
    dimension(axes, stamps[2] - 1.05j, stamps[5] - 1.05j, "$dt = 15$ ms", Colour.INK)
    write(axes, stamps[3] + 0.68 + 1.7j, r"$3 \times 22$", Colour.PATH, 15, bbox=None)
    line(axes, stamps[2] + 1.15j, stamps[2] + 1.35j, stamps[5] + 1.35j, stamps[5] + 1.15j, colour=Colour.PATH, linestyle="-")
    return figure_of(axes)


@pictured(
    Text(
        "Three graphs of one drive with mistakes in them. x-y: a circle that looks like a flat ellipse, axes without units. t-yaw: "
        "jumps from 180 to -180 degrees, and stamps of 1700000000 s on the time axis. t-v: a speed that never falls below "
        "zero although the robot reverses, no labels at all.",
        "ある走行の、間違いのある3つのグラフ。x-yでは円がつぶれた楕円に見え、軸に単位がない。t-yawでは180度から-180度へ飛び、時間軸は1700000000 s台の時刻である。"
        "t-vでは後退しているのに速度が負にならず、軸に名前もない。",
    )
)
def poor_graphs() -> "Figure":
    """Draw the three graphs as they should not be handed in (slides 000, practical training)."""
    figure = new_figure(8.0, 3.0)
    time = np.linspace(0, 12, 241)
    speed = np.where(time < 8, 0.5, -0.3) * np.minimum(1, np.minimum(abs(time - 8), 12 - time) / 0.4)
    yaw = 2 * np.pi / 8 * time
    path = np.cumsum(speed * np.exp(1j * yaw)) * 0.05
    left, middle, right = (figure.add_axes((start, 0.22, 0.235, 0.66)) for start in (0.085, 0.42, 0.75))
    left.plot(path.real, path.imag)
    left.set(xlabel="x", ylabel="y", ylim=(-1.0, 2.4))
    middle.plot(1.7e9 + time, np.angle(np.exp(1j * yaw), deg=True))
    middle.set(
        xlabel=in_chosen_language(Text("time [s]", "時刻 [s]")), ylabel=in_chosen_language(Text("yaw [deg]", "ヨー角 [deg]"))
    )
    middle.set_xticks((1.7e9, 1.7e9 + 10), ("1700000000", "1700000010"))
    right.plot(time, abs(speed))
    for axes, title in ((left, "x-y"), (middle, "t-yaw"), (right, "t-v")):
        axes.tick_params(labelsize=9)
        axes.set_title(title, fontsize=12)
    return figure


@pictured(
    Text(
        "The path on the floor of a robot that believes it drives an exact square, once counter-clockwise and once clockwise. "
        "Left: the true tread is smaller than the assumed one, so it turns too far at every corner, and the two paths are mirror images. "
        "Right: the right wheel is larger than the left, so every side bends to the left: too much turn one way round, too little the other.",
        "正方形を走ったつもりのロボットが、床の上で実際に描く経路。反時計回りと時計回りの2回。左：実際のトレッドが仮定より小さいと、どの角でも曲がりすぎ、"
        "2つの経路は互いに鏡映しになる。右：右車輪が左車輪より大きいと、どの辺も左へ曲がり、一方の回りでは回りすぎ、もう一方では回り足りなくなる。",
    )
)
def umbmark_squares() -> "Figure":
    """Draw how a wrong tread and unequal wheels move the end of a square, both ways round (Borenstein and Feng 1996)."""
    figure = new_figure(8.0, 4.6)
    panels = (
        (Text("wrong tread", "トレッドの誤差"), (1.0, 0.94)),
        (Text("unequal wheels", "左右の半径の差"), (1.012, 1.0)),
    )
    for place, (title, (wheel_ratio, tread_ratio)) in zip((0.01, 0.51), panels, strict=True):
        axes = figure.add_axes((place, 0.02, 0.48, 0.96), aspect="equal")
        axes.axis("off")
        axes.set(xlim=(-1.15, 5.2), ylim=(-5.2, 5.9))
        write(axes, 2 + 5.45j, title, size=14, bbox=None)
        for way, colour, name in (
            (1, Colour.LEFT, Text("ccw", "反時計回り")),
            (-1, Colour.RIGHT, Text("cw", "時計回り")),
        ):
            path = _driven_square(way, wheel_ratio, tread_ratio)
            line(axes, 0, 4, 4 + 4j * way, 4j * way, 0, width=1)
            line(axes, *path, colour=colour, width=2.2, linestyle="-", zorder=5)
            arrow(axes, path[140], path[150], colour, 2.2)
            dot(axes, path[-1], colour, 9)
            write(axes, 2 + 2j * way, name, colour, 13, bbox=None)
        dot(axes, 0, Colour.INK, 9)
        note(axes, Text("start", "出発点"), -0.7 + 0.9j, -0.08 + 0.1j)
    return figure


def _driven_square(way: int, wheel_ratio: float, tread_ratio: float, side: float = 4.0, tread: float = 0.5) -> "list[complex]":
    """Return the points of the path on the floor; both ratios are true over assumed, of right over left wheel and of the tread.

    The robot's counts are those of an exact square with turns on the spot, `way` 1 counter-clockwise and -1 clockwise.
    """
    straight = np.tile([[side / 200, side / 200]], (200, 1))
    corner = np.tile([[tread, -tread]], (20, 1)) * way * np.pi / 4 / 20
    right, left = np.vstack([straight, corner] * 4).T
    # the mean radius is right, so only the ratio of the two shows
    right, left = right * 2 * wheel_ratio / (1 + wheel_ratio), left * 2 / (1 + wheel_ratio)
    heading = np.cumsum((right - left) / (tread * tread_ratio))
    return [0j, *np.cumsum((right + left) / 2 * np.exp(1j * heading))]
