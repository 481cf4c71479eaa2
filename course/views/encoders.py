"""Views of the notebook on encoders."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.patches import Circle

from course.drawings.encoders import draw_code_disc, quadrature_bits
from course.drawings.robot import draw_robot
from course.language import Text
from course.plotting import Colour, Picture, in_chosen_language, line, new_figure, styled, unit_vector, write
from course.views.drive import BEEGO_TREAD
from course.views.film import FRAMES, Film
from course.views.view import Slider, View, plane, report

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray


LIGHT = "#F0E442"

NOT_A_TREAD = Text(
    "tread must be a positive length in m, not {tread!r}: this view has z up and counts yaw counter-clockwise.",
    "treadは正の長さ[m]でなければなりません。{tread!r}は使えません。この図ではz軸は上向きで、ヨー角は反時計回りが正です。",
)


def wheels_view(tread: float = BEEGO_TREAD, seconds: float = 4.0) -> View:
    """Show how a robot of this tread [m] drives for some seconds at any two wheel speeds, with V, omega and turning centre.

    Raises ValueError if the tread is not a positive length.
    """
    if not 0 < tread < math.inf:
        raise ValueError(in_chosen_language(NOT_A_TREAD.format(tread=tread)))

    def draw(right: float, left: float) -> Picture:
        return _picture_of_drive(right, left, tread, seconds)

    return View(
        draw,
        Slider(Text("right wheel v_r [m/s]", "右車輪 v_r [m/s]"), -0.3, 0.3, 0.02, 0.26),
        Slider(Text("left wheel v_l [m/s]", "左車輪 v_l [m/s]"), -0.3, 0.3, 0.02, 0.16),
    )


def _picture_of_drive(right: float, left: float, tread: float, seconds: float) -> Picture:
    # Speed is a straight line along the axle: its slope to the right is omega, its value in the middle is V.
    yaw_rate, velocity = np.polyfit((-tread / 2, tread / 2), (left, right), 1).round(12)
    instants = np.linspace(0, seconds, 1001)
    directions = np.exp(1j * yaw_rate * instants)
    between = np.exp(1j * yaw_rate * (instants[1:] - seconds / 2000))
    middle = np.append(0, np.cumsum(velocity * seconds / 1000 * between))
    with styled():
        figure, axes = plane(0.3 * seconds + tread)
        for side, colour in ((0.5, Colour.LEFT), (-0.5, Colour.RIGHT)):
            line(axes, *(middle + side * tread * 1j * directions), colour=colour, width=1.3, linestyle="-")
        line(axes, *middle, colour=Colour.INK, width=2, linestyle="-")
        draw_robot(axes, (0, 0, 0), tread=tread, faint=True)
        draw_robot(axes, (middle[-1].real, middle[-1].imag, yaw_rate * seconds), tread=tread)
        turning_centre = _turning_centre(axes, velocity, yaw_rate)
        numbers = {"right": right, "left": left, "velocity": velocity, "yaw_rate": yaw_rate}
        numbers = {name: round(value, 2) + 0.0 for name, value in numbers.items()} | {"time": seconds}
        lines = [(text.format(**numbers), colour) for text, colour in DRIVE_LINES]
        report(figure, [*lines, (turning_centre, Colour.QUIET)])
        return Picture(figure, DRIVE_ALT.format(**numbers, turning_centre=turning_centre))


DRIVE_LINES: list[tuple[Text | str, Colour]] = [
    ("$v_r = {right:.2f}$ m/s", Colour.RIGHT),
    ("$v_l = {left:.2f}$ m/s", Colour.LEFT),
    ("$V = {velocity:.2f}$ m/s", Colour.INK),
    ("$\\omega = {yaw_rate:.2f}$ rad/s", Colour.INK),
    (Text("{time:g} s of driving", "{time:g} 秒間の走行"), Colour.INK),
    (Text("turning centre (×):", "旋回中心（×）："), Colour.QUIET),
]
DRIVE_ALT = Text(
    "Path of a robot from above in {time:g} s: right wheel {right:.2f} m/s, left wheel {left:.2f} m/s, V = {velocity:.2f} m/s, "
    "omega = {yaw_rate:.2f} rad/s; turning centre: {turning_centre}.",
    "上から見た{time:g}秒間のロボットの経路。右車輪{right:.2f} m/s、左車輪{left:.2f} m/s、V = {velocity:.2f} m/s、ω = {yaw_rate:.2f} rad/s。旋回中心：{turning_centre}。",
)


def _turning_centre(axes: "Axes", velocity: float, yaw_rate: float) -> Text:
    """Mark the turning centre of a robot that starts at the origin along x, and say where it is."""
    if yaw_rate == 0:
        return Text("none", "なし")
    to_the_left = velocity / yaw_rate
    axes.plot(0, to_the_left, "x", color=Colour.QUIET, markersize=10, markeredgewidth=2.5, scalex=False, scaley=False)
    where = Text("{distance:.2f} m to the left", "左へ{distance:.2f} m")
    if to_the_left < 0:
        where = Text("{distance:.2f} m to the right", "右へ{distance:.2f} m")
    return where.format(distance=abs(to_the_left))


def encoder_animation() -> Film:
    """Return a film of a code disc that turns forward and back, its two sensors, their signals and the count."""
    with styled():
        figure = new_figure(7.2, 3.3)
        disc = figure.add_axes((0.0, 0.02, 0.42, 0.96), aspect="equal", xlim=(-1.35, 1.35), ylim=(-1.35, 1.35))
        disc.axis("off")
        signals = figure.add_axes((0.5, 0.12, 0.48, 0.84))
        draw_disc, draw_signals = _turning_disc(disc), _growing_signals(signals)

        def draw(frame: int) -> None:
            draw_disc(_position(frame))
            draw_signals(frame)

        return Film(figure, draw, FRAMES, 8.0, ENCODER_ALT)


ENCODER_ALT = Text(
    "A code disc with slits turns forward and then back past two sensors A and B, a quarter of the slits' pitch apart. Forward "
    "A changes first and the count rises; backwards B changes first and the count falls.",
    "スリットのある円板が前へ、次に後ろへ回り、スリットの間隔の4分の1だけずれた二つのセンサA、Bの前を通る。前進ではAが先に変わってカウントが増え、後退ではBが先に変わって減る。",
)
SLITS = 8
PITCH = 360 / SLITS  # [deg], four counts


def _position(frame: "float | NDArray[Any]") -> Any:
    """Return how far the disc has turned [count] at a frame: forward in the first half of the film, then back."""
    return 7.7 - 7.2 * np.abs(2 * np.asarray(frame) / (FRAMES - 1) - 1)


def _turning_disc(axes: "Axes") -> Callable[[float], None]:
    """Draw disc and sensors; return the function that turns the disc to a position [count] and lights the sensors."""
    at_a = 65.0
    at_b = at_a + PITCH + PITCH / 4  # a quarter of a pitch on, and one slit more to keep the two apart
    first_slit = at_a + PITCH / 4
    slits = draw_code_disc(axes, 0, 1.0, SLITS)
    sensors = []
    for name, place in (("A", at_a), ("B", at_b)):
        at = 0.77 * unit_vector(place)
        sensors.append(Circle((at.real, at.imag), 0.08, edgecolor=Colour.INK, linewidth=1.5, zorder=8))
        axes.add_patch(sensors[-1])
        write(axes, 1.18 * unit_vector(place), name, size=15)

    def turn_to(position: float) -> None:
        for slit, start in zip(slits, first_slit + PITCH * (np.arange(SLITS) + position / 4), strict=True):
            slit.set(theta1=start, theta2=start + PITCH / 2)
        for sensor, lit in zip(sensors, quadrature_bits(np.floor(position)), strict=True):
            sensor.set_facecolor(LIGHT if lit else Colour.INK)

    return turn_to


def _growing_signals(axes: "Axes") -> Callable[[int], None]:
    """Draw empty traces of A, B and the count; return the function that draws them up to a frame."""
    instants = np.linspace(0, FRAMES - 1, 20 * (FRAMES - 1) + 1)
    count = np.floor(_position(instants))
    a, b = quadrature_bits(count)
    levels = [11.5 + 1.5 * a, 9 + 1.5 * b, count]
    traces = [axes.plot([], [], color=Colour.INK)[0] for _ in levels]
    axes.set(xlim=(0, FRAMES - 1), ylim=(-0.6, 13.6), xticks=(), yticks=())
    axes.axvspan((FRAMES - 1) / 2, FRAMES - 1, color=Colour.SHADE, zorder=0)
    axes.set_xlabel(in_chosen_language(Text("time", "時間")))
    names: tuple[tuple[float, Text | str], ...] = ((12.2, "A"), (9.7, "B"), (3.5, Text("count", "カウント")))
    for height, name in names:
        write(axes, -0.7 + 1j * height, name, ha="right")
    number = axes.text(0.5, 6.8, "", fontsize=20, color=Colour.PATH)

    def grow_to(frame: int) -> None:
        known = 20 * frame + 1
        for trace, level in zip(traces, levels, strict=True):
            trace.set_data(instants[:known], level[:known])
        number.set_text(f"{count[known - 1]:.0f}")

    return grow_to
