"""Views to play with: sliders that redraw a picture, and films of a turning encoder and of a driving robot.

Where sliders cannot work (no running kernel, a page exported as HTML) the same view is shown as a still picture.
"""

import importlib.util
import math
import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from IPython import get_ipython
from matplotlib.animation import FuncAnimation
from matplotlib.patches import Circle

from course.drawings import RULES, draw_code_disc, draw_robot, quadrature_bits, step_paths
from course.language import Text
from course.plotting import (
    Colour,
    Picture,
    arrow,
    dot,
    in_chosen_language,
    line,
    make_xy,
    new_figure,
    styled,
    unit_vector,
    write,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

BEEGO_TREAD = 0.2765  # [m]
FRAMES = 40
LIGHT = "#F0E442"

NOT_POSES = Text(
    "poses must hold one row (x, y, theta) of numbers per instant: shape (N, 3), N >= 1. This has shape {shape}.",
    "posesは各時刻の(x, y, theta)を1行ずつ並べた、形(N, 3)の数の配列（N >= 1）でなければなりません。渡された形は{shape}です。",
)
NO_ARRAY = Text("no array of numbers", "数の配列ではないもの")
NOT_FINITE = Text(
    "poses must be finite; row {row} is {values}. Look at what happens in that step.",
    "posesに有限でない値があります。行{row}は{values}です。そのステップで何が起きたか調べてみましょう。",
)
NOT_A_TREAD = Text(
    "tread must be a positive length in m, not {tread!r}: this view has z up and counts yaw counter-clockwise.",
    "treadは正の長さ[m]でなければなりません。{tread!r}は使えません。この図ではz軸は上向きで、ヨー角は反時計回りが正です。",
)


class Slider(NamedTuple):
    """A quantity that the reader can change: its name with symbol and unit, range, step and first value."""

    name: Text
    low: float
    high: float
    step: float
    start: float


class View:
    """A picture with sliders above it; a still picture where sliders cannot work."""

    def __init__(self, draw: Callable[..., Picture], *sliders: Slider) -> None:
        """`draw` takes the sliders' values, in their order."""
        self.picture = draw(*(slider.start for slider in sliders))
        self.controls = _controls(draw, sliders, self.picture) if sliders_work() else None

    def _repr_mimebundle_(self, **options: Any) -> dict[str, Any]:
        # A page without a running kernel takes the picture, because it finds no state of the sliders.
        live = self.controls._repr_mimebundle_(**options) if self.controls is not None else {}
        return live | self.picture._repr_mimebundle_()

    def __repr__(self) -> str:
        return repr(self.picture)


def sliders_work() -> bool:
    """Is there a Jupyter kernel that sliders could talk to?"""
    return getattr(get_ipython(), "kernel", None) is not None and importlib.util.find_spec("ipywidgets") is not None


def _controls(draw: Callable[..., Picture], sliders: tuple[Slider, ...], first: Picture) -> Any:
    """Return a box of sliders above an image that follows them."""
    import ipywidgets as widgets  # late, because it is slow to import

    # not an Image widget: it has no alternative text, and given a tooltip it fails in JupyterLab
    image = widgets.HTML(value=first.html)
    bars = [_bar(widgets, slider) for slider in sliders]

    def redraw(_: object) -> None:
        image.value = draw(*(bar.value for bar in bars)).html

    for bar in bars:
        bar.observe(redraw, names="value")
    return widgets.VBox([*bars, image])


def _bar(widgets: Any, slider: Slider) -> Any:
    # Drawing takes a tenth of a second and the page sends nothing new until it is done, so it may follow every move.
    return widgets.FloatSlider(
        value=slider.start,
        min=slider.low,
        max=slider.high,
        step=slider.step,
        description=in_chosen_language(slider.name),
        readout_format=".2f" if slider.step < 1 else ".0f",
        continuous_update=True,
        style={"description_width": "14em"},
        layout={"width": "34em", "max_width": "100%"},
    )


class Film:
    """A film that plays in the page, with buttons, without kernel and without network."""

    def __init__(self, figure: "Figure", draw: Callable[[int], None], frames: int, seconds: float, alt: Text) -> None:
        """`draw(k)` brings the figure to frame k; `seconds` is how long the film takes."""
        film = FuncAnimation(figure, draw, init_func=lambda: None, frames=frames, interval=1000 * seconds / frames)
        player = film.to_jshtml(default_mode="loop")
        self.still = Picture(figure, alt)
        self.html = _with_still(_without_network(player), self.still)

    def _repr_mimebundle_(self, **_: object) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.still.alt}

    def __repr__(self) -> str:
        return self.still.alt


# Matplotlib's player: the icons that it takes from a font on the network, and its texts.
SYMBOLS = {
    "minus": "−",
    "fast-backward": "|◀",
    "step-backward": "◁",
    "play fa-flip-horizontal": "◀",
    "pause": "❚❚",
    "play": "▶",
    "step-forward": "▷",
    "fast-forward": "▶|",
    "plus": "+",
}
BUTTONS = {
    text.en: text
    for text in (
        Text("Decrease speed", "遅くする"),
        Text("First frame", "最初のコマ"),
        Text("Previous frame", "前のコマ"),
        Text("Play backwards", "逆再生"),
        Text("Pause", "一時停止"),
        Text("Play", "再生"),
        Text("Next frame", "次のコマ"),
        Text("Last frame", "最後のコマ"),
        Text("Increase speed", "速くする"),
        Text("Repetition mode", "繰り返し方"),
        Text("Once", "1回"),
        Text("Loop", "繰り返し"),
        Text("Reflect", "往復"),
    )
}


def _without_network(player: str) -> str:
    """Return Matplotlib's player with plain symbols in place of the linked icon font, in the reader's language."""
    player = re.sub(r"<link\b[^>]*>", "", player)
    player = re.sub(r'<i class="fa fa-([\w -]+)"></i>', lambda icon: SYMBOLS[icon[1]], player)
    player = re.sub(r'(title|aria-label)="([^"]+)"', lambda found: f'{found[1]}="{_button(found[2])}"', player)
    return re.sub(r">(\w+)</label>", lambda found: f">{_button(found[1])}</label>", player)


def _button(english: str) -> str:
    return in_chosen_language(BUTTONS[english])


def _with_still(player: str, still: Picture) -> str:
    """Give the player's image an alt text, a width and a still that shows where scripts may not run."""
    return re.sub(r"<img (id=\"\w+\")>", lambda found: still.html.replace("<img ", f"<img {found[1]} "), player)


def _plane(half_width: float) -> "tuple[Figure, Axes]":
    """Return a figure with axes x-y around the origin on its left, and room for numbers on its right."""
    figure = new_figure(7.6, 4.9)
    axes = figure.add_axes((0.1, 0.13, 0.55, 0.84))
    make_xy(axes)
    axes.set(xlim=(-half_width, half_width), ylim=(-half_width, half_width))
    return figure, axes


def _report(figure: "Figure", lines: Sequence[tuple[Text | str, str]]) -> None:
    """Write lines of text on the right of the figure, each in its colour."""
    for row, (text, colour) in enumerate(lines):
        figure.text(0.69, 0.92 - 0.085 * row, in_chosen_language(text), color=colour, fontsize=12.5, va="center")


def step_view() -> View:
    """Show where one step ends under Euler's rule, the midpoint rule and on the exact arc, for any D and dtheta."""
    return View(
        _picture_of_step,
        Slider(Text("distance D [m]", "距離 D [m]"), -1, 1, 0.05, 0.9),
        Slider(Text("turn Δθ [deg]", "回転 Δθ [deg]"), -180, 180, 5, 60),
        Slider(Text("start heading θ₁ [deg]", "はじめの向き θ₁ [deg]"), -180, 180, 5, 0),
    )


def _picture_of_step(distance: float, dtheta: float, heading: float) -> Picture:
    with styled():
        figure, axes = _plane(1.2)
        draw_robot(axes, (0, 0, math.radians(heading)), tread=BEEGO_TREAD)
        paths = step_paths(distance, dtheta, heading)
        for rule, path in paths.items():
            colour = RULES[rule][1]
            line(axes, *path, colour=colour, width=2.5, linestyle="-", zorder=6)
            arrow(axes, path[-1], path[-1] + 0.17 * unit_vector(heading + dtheta), colour, 1.3)
            dot(axes, path[-1], colour, 8)
        gaps = {rule: f"{1000 * abs(path[-1] - paths['arc'][-1]):.1f}" for rule, path in paths.items()}
        _report(
            figure,
            [
                (Text("exact arc", "厳密な円弧"), Colour.ARC),
                (Text("", ""), Colour.INK),
                (Text("Euler", "オイラー法"), Colour.EULER),
                (Text("{mm} mm off the arc", "円弧との差 {mm} mm").format(mm=gaps["euler"]), Colour.EULER),
                (Text("", ""), Colour.INK),
                (Text("midpoint", "中点法"), Colour.MIDPOINT),
                (Text("{mm} mm off the arc", "円弧との差 {mm} mm").format(mm=gaps["midpoint"]), Colour.MIDPOINT),
            ],
        )
        alt = STEP_ALT.format(distance=distance, dtheta=dtheta, heading=heading, **gaps)
        return Picture(figure, alt)


STEP_ALT = Text(
    "One step of {distance:.2f} m with a turn of {dtheta:.0f} degrees from a heading of {heading:.0f} degrees. Euler's rule "
    "ends {euler} mm from the end of the exact arc, the midpoint rule {midpoint} mm.",
    "向き{heading:.0f}度から{distance:.2f} m進む間に{dtheta:.0f}度回る1ステップ。厳密な円弧の終点との差は、オイラー法が{euler} mm、中点法が{midpoint} mm。",
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
        figure, axes = _plane(0.3 * seconds + tread)
        for side, colour in ((0.5, Colour.LEFT), (-0.5, Colour.RIGHT)):
            line(axes, *(middle + side * tread * 1j * directions), colour=colour, width=1.3, linestyle="-")
        line(axes, *middle, colour=Colour.INK, width=2, linestyle="-")
        draw_robot(axes, (0, 0, 0), tread=tread, faint=True)
        draw_robot(axes, (middle[-1].real, middle[-1].imag, yaw_rate * seconds), tread=tread)
        turning_centre = _turning_centre(axes, velocity, yaw_rate)
        numbers = {"right": right, "left": left, "velocity": velocity, "yaw_rate": yaw_rate}
        numbers = {name: round(value, 2) + 0.0 for name, value in numbers.items()} | {"time": seconds}
        lines = [(text.format(**numbers), colour) for text, colour in DRIVE_LINES]
        _report(figure, [*lines, (turning_centre, Colour.QUIET)])
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


def drive_animation(poses: "ArrayLike", *, tread: float = BEEGO_TREAD, seconds: float = 6.0) -> Film:
    """Return a film of a robot that drives along a trajectory, seen from above.

    `poses` has shape (N, 3): x [m], y [m], theta [rad]. However many there are, the film has at most 40 frames. On a long
    path the robot is drawn larger than its `tread` [m], so that it can be seen.

    Raises ValueError if `poses` has another shape, or holds values that are not finite numbers.
    """
    track = _checked_poses(poses)
    chosen = np.unique(np.linspace(0, len(track) - 1, FRAMES).round().astype(int))
    with styled():
        # on a long path a robot of true size would be a speck
        width = max(abs(tread), 0.06 * float(np.ptp(track[:, :2], axis=0).max()))
        figure, axes = _plane_around(track, margin=1.2 * width)
        trail = axes.plot([], [], color=Colour.PATH)[0]
        robot = draw_robot(axes, track[0], tread=width)
        # a plain text, because a title and formulas would double the time of a frame
        readout = figure.text(0.15, 0.95, "", va="center")

        def draw(frame: int) -> None:
            while robot:
                robot.pop().remove()
            pose = track[chosen[frame]]
            robot.extend(draw_robot(axes, pose, tread=width))
            trail.set_data(*track[: chosen[frame] + 1, :2].T)
            numbers = f"x = {pose[0]:.2f} m,  y = {pose[1]:.2f} m,  θ = {math.degrees(pose[2]):.0f}°"
            readout.set_text(numbers.replace("-", "−"))

        return Film(figure, draw, len(chosen), seconds, _alt_of_drive(track))


def _plane_around(track: "NDArray[np.float64]", margin: float) -> "tuple[Figure, Axes]":
    """Return a figure with the whole track in pale grey, in axes that fill the figure whatever the track's shape."""
    figure = new_figure(5.6, 4.7)
    axes = figure.add_axes((0.15, 0.13, 0.82, 0.78))
    make_xy(axes)
    low, high = track[:, :2].min(axis=0), track[:, :2].max(axis=0)
    half_height = ((high - low) / 2 + margin).max()
    half_width = half_height * axes.bbox.width / axes.bbox.height
    x, y = (low + high) / 2
    axes.set(xlim=(x - half_width, x + half_width), ylim=(y - half_height, y + half_height))
    axes.plot(*track[:, :2].T, color=Colour.METAL, linewidth=1.5)
    return figure, axes


def _alt_of_drive(track: "NDArray[np.float64]") -> Text:
    x, y, theta = track[-1]
    return Text(
        "A robot seen from above drives along the trajectory. It ends at x = {x:.2f} m, y = {y:.2f} m, theta = {degrees:.0f} degrees.",
        "軌跡に沿って走るロボットを上から見た動画。終点はx = {x:.2f} m、y = {y:.2f} m、θ = {degrees:.0f}度。",
    ).format(x=x, y=y, degrees=math.degrees(theta))


def _checked_poses(poses: "ArrayLike") -> "NDArray[np.float64]":
    """Return the poses as an array (N, 3), or say what is wrong with them."""
    try:
        track = np.asarray(poses, dtype=float)
    except (TypeError, ValueError):
        raise ValueError(in_chosen_language(NOT_POSES.format(shape=NO_ARRAY))) from None
    if track.ndim != 2 or track.shape[1] != 3 or not len(track):
        raise ValueError(in_chosen_language(NOT_POSES.format(shape=track.shape)))
    bad = np.flatnonzero(~np.isfinite(track).all(axis=1))
    if bad.size:
        raise ValueError(in_chosen_language(NOT_FINITE.format(row=bad[0], values=track[bad[0]].tolist())))
    return track
