"""Drawings of the notebook on encoders."""

import math
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Circle, FancyBboxPatch, Polygon, Rectangle, Wedge

from course.drawings.robot import FORWARD, LEFT_WHEEL, RIGHT_WHEEL, SAMPLE, draw_robot, figure_of, stand
from course.language import Text
from course.plotting import (
    Colour,
    arrow,
    dimension,
    dot,
    frame,
    in_chosen_language,
    label_axes,
    line,
    new_figure,
    new_sketch,
    note,
    pictured,
    turn,
    unit_vector,
    write,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


@pictured(
    Text(
        "From left to right on one line: the encoder disc on the motor shaft, the motor, a small gear that drives a large "
        "one, and the wheel. The counts dE and the counts per revolution CRev belong to the motor shaft, Gear to the "
        "gears, dC, the wheel angle d theta, the radius r and the speed v to the wheel.",
        "左から順に、モータ軸のエンコーダ円板、モータ、大小の歯車、車輪。カウントdEと1回転分のカウントCRevはモータ軸のもの、"
        "Gearは歯車のもの、dC、車輪の回転角dθ、半径r、速度vは車輪のものである。",
    )
)
def drive_train() -> "Figure":
    """Draw encoder, motor, gear and wheel, and where each quantity of slides 000, overview 6, lives."""
    axes = new_sketch((0, 10), (-0.3, 5.1), width=7.6)
    encoder, gear, wheel = 1.3 + 3.2j, 5.3 + 3.2j, 8.4 + 3.2j
    line(axes, encoder, wheel, colour=Colour.QUIET, width=5, linestyle="-", zorder=1)
    draw_code_disc(axes, encoder, 0.75)
    axes.add_patch(FancyBboxPatch((2.7, 2.75), 1.2, 0.9, "round,pad=0,rounding_size=0.1", color=Colour.METAL))
    _draw_gear(axes, gear - 0.38, 0.3, teeth=9)
    _draw_gear(axes, gear + 0.47, 0.65, teeth=21)
    axes.add_patch(Circle((wheel.real, wheel.imag), 0.95, color=Colour.WHEEL, zorder=3))
    axes.add_patch(Circle((wheel.real, wheel.imag), 0.72, color=Colour.METAL, zorder=3))
    arrow(axes, wheel, wheel + 0.95 * unit_vector(60), Colour.INK)
    axes.text(wheel.real + 0.02, wheel.imag + 0.42, "$r$", fontsize=16, ha="right", zorder=8)
    dot(axes, wheel)
    names = [(encoder, "encoder", "エンコーダ"), (3.3, "motor", "モータ"), (gear, "gear", "減速機"), (wheel, "wheel", "車輪")]
    for at, en, ja in names:
        write(axes, complex(at.real, 4.65), Text(en, ja), size=14, va="baseline")
    write(axes, encoder - 1.15j, Text("CRev counts per turn", "CRevカウント／回転"), Colour.HEADING, 11.5)
    write(axes, gear - 1.15j, Text("Gear turns in, 1 turn out", "入力Gear回転で出力1回転"), Colour.HEADING, 11.5)
    _draw_quantities(axes)
    return figure_of(axes)


def draw_code_disc(axes: "Axes", centre: complex, radius: float, slits: int = 12, turned: float = 0) -> list[Wedge]:
    """Draw a code disc and return its slits; `turned` [deg] is how far the disc has turned."""
    middle = (centre.real, centre.imag)
    axes.add_patch(Circle(middle, radius, facecolor=Colour.METAL, edgecolor=Colour.WHEEL, zorder=3))
    pitch = 360 / slits
    wedges = [
        Wedge(middle, 0.92 * radius, start, start + pitch / 2, width=0.3 * radius, color=Colour.PAPER, zorder=4)
        for start in turned + pitch * np.arange(slits)
    ]
    for wedge in wedges:
        axes.add_patch(wedge)
    dot(axes, centre)
    return wedges


def _draw_gear(axes: "Axes", centre: complex, radius: float, teeth: int) -> None:
    directions = np.exp(2j * np.pi * np.arange(4 * teeth) / (4 * teeth))
    outline = centre + radius * np.tile([1, 1, 1 - 0.09 / radius, 1 - 0.09 / radius], teeth) * directions
    corners = np.column_stack([outline.real, outline.imag])
    axes.add_patch(Polygon(corners, facecolor=Colour.METAL, edgecolor=Colour.WHEEL, zorder=3))
    dot(axes, centre, size=5)


def _draw_quantities(axes: "Axes") -> None:
    """Write the quantities below the part they belong to, and what leads from each to the next."""
    shaft, axle = Text("on the motor shaft", "モータ軸側"), Text("on the wheel axle", "車輪軸側")
    places = [1.3 + 1.1j, 5.0 + 1.1j, 7.0 + 1.1j, 9.0 + 1.1j]
    for at, symbol, unit in zip(
        places, ("$dE$", "$dC$", r"$d\theta$", "$v$"), ("[count]", "[count]", "[rad]", "[m/s]"), strict=True
    ):
        write(axes, at, symbol, Colour.PATH, 18)
        write(axes, at - 0.45j, unit, Colour.QUIET, 12)
    for start, end, means in zip(places, places[1:], ("Gear", "CRev", "$r,\\ dt$"), strict=False):
        arrow(axes, start + 0.55, end - 0.55, Colour.QUIET, 1.5)
        write(axes, (start + end) / 2 + 0.35j, means, Colour.HEADING, 13)
    for start, end, text in ((0.6, 2.0, shaft), (4.4, 9.6, axle)):
        line(axes, start + 0.3j, end + 0.3j, linestyle="-")
        write(axes, (start + end) / 2 + 0.05j, text, Colour.QUIET, 12)


@pictured(
    Text(
        "Channels A and B of an encoder over time, and the count below. Going forward A rises before B and every edge adds "
        "one: four counts for each slit. Going back B rises before A and every edge takes one away.",
        "エンコーダのA相とB相の時間変化と、その下にカウント。前進ではA相がB相より先に立ち上がり、エッジごとに1増える（スリット1本で4カウント）。"
        "後退ではB相が先になり、エッジごとに1減る。",
    )
)
def quadrature_signals() -> "Figure":
    """Draw channels A and B, forward then in reverse, and the count after 4x decoding."""
    figure = new_figure(7.4, 4.4)
    rows = figure.subplots(3, sharex=True, height_ratios=(1, 1, 2.2))
    figure.subplots_adjust(left=0.12, right=0.98, top=0.9, bottom=0.11, hspace=0.12)
    edges = np.arange(20)
    count = np.minimum(edges, 18 - edges)[:-1]
    a, b = quadrature_bits(count)
    names: tuple[Text | str, ...] = ("A", "B", Text("count", "カウント"))
    for axes, levels, name in zip(rows, (a, b, count), names, strict=True):
        axes.stairs(levels, edges, baseline=None, color=Colour.INK, linewidth=2.2)
        axes.axvspan(9.5, 19, color=Colour.SHADE, zorder=0)
        axes.set(xlim=(0, 19), ylim=(-0.25, 1.25), xticks=edges, yticks=())
        axes.tick_params(axis="x", length=0, labelbottom=False)
        axes.grid(visible=True, axis="x", linestyle=(0, (1, 2)))
        write(axes, -0.25 + 0.5j * levels.max(), name, size=14, ha="right")
    rows[2].set_ylim(-1.4, 10.4)
    rows[2].set_xlabel(in_chosen_language(Text("time", "時間")))
    write(rows[0], 4.75 + 1.6j, Text("forward: A leads B", "前進：A相がB相に先行"))
    write(rows[0], 14.25 + 1.6j, Text("reverse: B leads A", "後退：B相がA相に先行"))
    write(rows[2], -0.25 - 0.65j, "AB", Colour.QUIET, 12, ha="right")
    for place, level, bit_a, bit_b in zip(edges, count, a, b, strict=False):
        write(rows[2], place + 0.5 + 1j * (level + 0.7), f"{level}", size=12, bbox=None)
        write(rows[2], place + 0.5 - 0.65j, f"{bit_a:d}{bit_b:d}", Colour.QUIET, 11, bbox=None)
    return figure


def quadrature_bits(count: "NDArray[np.int64]") -> "tuple[NDArray[np.bool_], NDArray[np.bool_]]":
    """Return the channels A and B for counts of an encoder that starts with both dark and counts up when A leads."""
    quarter = count % 4
    return np.isin(quarter, (1, 2)), np.isin(quarter, (2, 3))


@pictured(
    Text(
        "A robot with two wheels seen from above turns to the left about a point on the line of its axle. The arrows v_l, V "
        "and v_r of the left wheel, the middle and the right wheel grow with the distance from that turning centre. The "
        "wheels are the tread T apart.",
        "上から見た二輪ロボットが、車軸の延長線上の点を中心に左へ旋回する図。左車輪の速度v_l、中点の速度V、右車輪の速度v_rの矢印は旋回中心からの距離に比例して長くなる。"
        "左右の車輪の間隔がトレッドTである。",
    )
)
def two_wheels() -> "Figure":
    """Draw wheel speeds, V, omega, the tread T and the turning centre (slides 000, overview 5)."""
    axes = new_sketch((-3.6, 2.1), (-1.3, 2.1))
    centre, per_tread = -2.7 + 0j, 0.55
    line(axes, centre, 1)
    line(axes, centre, centre + 3.5 * (1 + 1j * per_tread), width=0.9)
    stand(axes, 0, 90)
    speeds = ((-0.5, "$v_l$", Colour.LEFT), (0, "$V$", Colour.HEADING), (0.5, "$v_r$", Colour.RIGHT))
    for place, name, colour in speeds:
        tip = place + 1j * per_tread * (place - centre.real)
        arrow(axes, place, tip, colour, 2.6)
        write(axes, place + 0.1 + 0.75 * (tip - place), name, colour, 17, ha="left")
    turn(axes, centre, 0.8, -35, 50, Colour.HEADING)
    write(axes, centre + 1.1 * unit_vector(54), r"$\omega$", Colour.HEADING, 18)
    dot(axes, centre, Colour.INK, 8)
    write(axes, centre - 0.35j, Text("turning centre", "旋回中心"), ha="center")
    for side in (-0.5, 0.5):
        line(axes, side - 0.3j, side - 1.15j, width=0.8, linestyle="-")
    dimension(axes, -0.5 - 1.0j, 0.5 - 1.0j, "$T$")
    note(axes, LEFT_WHEEL, -1.2 - 0.55j, -0.5 - 0.15j)
    note(axes, RIGHT_WHEEL, 1.35 - 0.55j, 0.5 - 0.15j)
    return figure_of(axes)


@pictured(
    Text(
        "Three views of a robot that drives straight ahead. From above: two identical motors back to back, shafts pointing "
        "outwards. Seen from the left the left wheel turns counter-clockwise and its counter goes up; seen from the right the "
        "right wheel turns clockwise and its counter goes down.",
        "直進するロボットを三方向から見た図。上から見ると、同じモータ二つが背中合わせで、軸がそれぞれ外を向いている。左から見ると左車輪は反時計回りでカウンタは増え、"
        "右から見ると右車輪は時計回りでカウンタは減る。",
    )
)
def mirrored_motors() -> "Figure":
    """Draw why one counter runs backwards when the robot drives straight ahead."""
    axes = new_sketch((-5.95, 5.95), (-2.5, 2.7), width=8)
    _draw_motors_from_above(axes)
    _draw_wheel_from_outside(axes, -3.7, 1, Text("left wheel,\nseen from the left", "左車輪\n（左から見る）"))
    _draw_wheel_from_outside(axes, 3.7, -1, Text("right wheel,\nseen from the right", "右車輪\n（右から見る）"))
    return figure_of(axes)


def _draw_motors_from_above(axes: "Axes") -> None:
    draw_robot(axes, (0, 0, math.pi / 2), tread=2.0, faint=True)
    for side in (-1, 1):
        line(axes, side * 0.2, side * 1.0, colour=Colour.WHEEL, width=4, linestyle="-", zorder=6)
        left = min(side * 0.1, side * 0.68)
        axes.add_patch(Rectangle((left, -0.22), 0.58, 0.44, facecolor=Colour.METAL, edgecolor=Colour.WHEEL, zorder=7))
    arrow(axes, 1.05j, 1.9j, Colour.HEADING, 2.5)
    write(axes, 2.15j, FORWARD, Colour.HEADING)
    write(axes, -1.75j, Text("the same motor twice,\nback to back", "同じモータを\n背中合わせに取り付け"), size=12)


def _draw_wheel_from_outside(axes: "Axes", at: float, way: int, title: Text) -> None:
    """Draw a wheel that rolls forward as seen from its own side, `way` 1 turning counter-clockwise and -1 clockwise."""
    colour = Colour.RIGHT_WAY if way > 0 else Colour.WRONG_WAY
    axes.add_patch(Circle((at, 0), 0.8, color=Colour.WHEEL, zorder=3))
    axes.add_patch(Circle((at, 0), 0.55, color=Colour.METAL, zorder=3))
    dot(axes, at)
    line(axes, at - 1.3 - 0.82j, at + 1.3 - 0.82j, linestyle="-")
    turn(axes, at, 1.0, 90 - 60 * way, 90 + 60 * way, colour, 2.6)
    arrow(axes, at - 0.9 * way, at - 1.5 * way, Colour.HEADING, 2.5)
    write(axes, at - 1.55 * way - 0.35j, FORWARD, Colour.HEADING, 11)
    counts = Text("counter goes up", "カウンタは増える") if way > 0 else Text("counter goes down", "カウンタは減る")
    write(axes, at + 2.1j, title, size=12)
    write(axes, at - 1.35j, counts, colour)


@pictured(
    Text(
        "A 16-bit counter rises to 32767 and jumps to -32768, while the true count goes on rising. Below, the true "
        "increments stay near 12000 per sample, but the plain difference at the jump is far below zero.",
        "16ビットカウンタが32767まで増えて-32768に飛ぶ一方、真のカウントは増え続ける。下の図では、真の増分は1サンプル約12000のままなのに、"
        "飛んだところの単純な差は大きな負の値になる。",
    )
)
def counter_wrap() -> "Figure":
    """Draw an int16 counter that runs over, and the true increments beside the plain differences."""
    figure = new_figure(7.2, 5.4)
    above, below = figure.subplots(2, sharex=True, height_ratios=(1.5, 1))
    figure.subplots_adjust(left=0.15, right=0.97, top=0.97, bottom=0.11, hspace=0.12)
    true_count = np.cumsum([3000, 10000, 12500, 12000, 11000, 12500, 11500])
    reading = (true_count + 2**15) % 2**16 - 2**15
    sample = np.arange(true_count.size)
    above.axhspan(-(2**15), 2**15 - 1, color=Colour.SHADE, zorder=0)
    above.plot(sample, true_count, "--o", color=Colour.RIGHT_WAY, markerfacecolor=Colour.PAPER)
    above.plot(sample, reading, "o", color=Colour.WRONG_WAY, markersize=8)
    above.set(yticks=(-(2**15), 0, 2**15 - 1), ylim=(-38000, 80000))
    write(above, 4.1 + 68000j, Text("true count", "真のカウント"), Colour.RIGHT_WAY, ha="right")
    write(above, 4.3 - 25500j, Text("reading (int16)", "読み値（int16）"), Colour.WRONG_WAY, ha="left", bbox=None)
    arrow(above, 3.0 + 37500j, 3.0 - 26000j, Colour.WRONG_WAY, 1.2)
    label_axes(above, ("", ""), (Text("counter", "カウンタ"), "count"))
    below.bar(sample[1:] - 0.17, np.diff(true_count), 0.3, color=Colour.RIGHT_WAY)
    below.bar(sample[1:] + 0.17, np.diff(reading), 0.3, color=Colour.WRONG_WAY, hatch="//", edgecolor=Colour.PAPER)
    below.set(ylim=(-62000, 36000), yticks=(-53536, 0, 12000))
    write(below, 1.5 + 26000j, Text("true increment", "真の増分"), Colour.RIGHT_WAY)
    write(below, 3.5 - 40000j, Text("plain difference of readings", "読み値の単純な差"), Colour.WRONG_WAY, ha="left")
    label_axes(below, SAMPLE, (Text("increment", "増分"), "count"))
    return figure


@pictured(
    Text(
        "The same left turn described twice, seen from above. Left: z points up, y to the left, yaw counts "
        "counter-clockwise; the tread T is positive and omega comes out positive. Right: z points down, y to the right, yaw "
        "counts clockwise; T is negative and omega comes out negative. Both agree.",
        "同じ左旋回を二通りに表した図（上から見る）。左はz軸が上、y軸が左、ヨー角は反時計回りが正で、T>0、ωは正になる。右はz軸が下、y軸が右、ヨー角は時計回りが正で、"
        "T<0、ωは負になる。どちらも同じ動きを正しく表す。",
    )
)
def signed_tread() -> "Figure":
    """Draw why the slides' tread is negative: with z down, yaw counts clockwise."""
    axes = new_sketch((-4.9, 4.9), (-2.7, 3.1), width=7.8)
    _draw_convention(axes, -2.4, 1, Text("z up", "z軸が上向き"), r"$T > 0,\quad \omega = (v_r - v_l)/T > 0$")
    _draw_convention(
        axes, 2.4, -1, Text("z down (slides)", "z軸が下向き（スライド）"), r"$T < 0,\quad \omega = (v_r - v_l)/T < 0$"
    )
    write(axes, 0.3j, Text("the same\nleft turn", "同じ\n左旋回"), Colour.QUIET)
    return figure_of(axes)


def _draw_convention(axes: "Axes", at: float, y_side: int, title: Text, sign: str) -> None:
    """Draw a robot that turns left, with the axes and the sense of yaw of one convention; `y_side` 1 is z up."""
    draw_robot(axes, (at, 0, math.pi / 2), tread=1.4)
    write(axes, at + 2.75j, title, size=14)
    frame(axes, at, 90, (1.75, 1.5), ("$x$", "$y$"), Colour.INK, y_side)
    for side, length, name, colour in ((-0.7, 0.7, "$v_l$", Colour.LEFT), (0.7, 1.3, "$v_r$", Colour.RIGHT)):
        arrow(axes, at + side, at + side + length * 1j, colour, 2.6)
        write(axes, at + side * 1.35 + length * 0.9j, name, colour, 16)
    _draw_axis_out_of_page(axes, at, towards_reader=y_side > 0)
    turn(axes, at, 1.2, -90 - 50 * y_side, -90 + 50 * y_side, Colour.HEADING)
    write(axes, at - 1.5j, Text("yaw +", "ヨー角 +"), Colour.HEADING)
    write(axes, at - 2.2j, sign, size=15)


def _draw_axis_out_of_page(axes: "Axes", at: float, towards_reader: bool) -> None:
    """Mark the z axis: a dot is the tip of an arrow towards the reader, a cross the feathers of one that goes away."""
    axes.add_patch(Circle((at, 0), 0.17, facecolor=Colour.PAPER, edgecolor=Colour.INK, linewidth=2, zorder=8))
    axes.plot(at, 0, "o" if towards_reader else "x", color=Colour.INK, markersize=6, markeredgewidth=2, zorder=9)
    axes.text(at + 0.28, -0.3, "$z$", color=Colour.INK, fontsize=15, ha="center", va="center", zorder=9)
