"""Views of the notebook on frames."""

import cmath
import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from course.drawings.robot import draw_robot
from course.language import Text
from course.plotting import (
    Colour,
    Picture,
    arrow,
    dot,
    frame,
    in_chosen_language,
    line,
    make_xy,
    new_figure,
    styled,
    unit_vector,
    write,
)
from course.views.drive import BEEGO_TREAD
from course.views.film import FRAMES, Film
from course.views.view import Slider, View, plane, report

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

POST = 1.2 + 0.8j  # [m], nailed to the floor


def point_view() -> View:
    """Show the coordinates of one post on the floor in the global frame and in a frame that the sliders place and turn."""
    return View(
        _picture_of_post,
        Slider(Text("frame: x [m]", "座標系の x [m]"), -1.5, 1.5, 0.1, 0.5),
        Slider(Text("frame: y [m]", "座標系の y [m]"), -1.5, 1.5, 0.1, -0.4),
        Slider(Text("frame: θ [deg]", "座標系の θ [deg]"), -180, 180, 5, 30),
    )


def _picture_of_post(x: float, y: float, heading: float) -> Picture:
    origin, forward = complex(x, y), unit_vector(heading)
    seen = (POST - origin) / forward
    with styled():
        figure, axes = plane(1.9)
        draw_robot(axes, (x, y, math.radians(heading)), tread=0.4, faint=True)
        frame(axes, 0, 0, (0.8, 0.8), ("", ""), Colour.GLOBAL_FRAME)
        frame(axes, origin, heading, (0.8, 0.8), ("", ""), Colour.SENSOR_FRAME)
        line(axes, POST.real, POST, POST.imag * 1j)
        line(axes, origin, origin + seen.real * forward, POST, colour=Colour.SENSOR_FRAME, width=1.6)
        dot(axes, POST, Colour.PATH, 11)
        numbers = {"x": x, "y": y, "heading": heading, "u": seen.real, "v": seen.imag, "x_P": POST.real, "y_P": POST.imag}
        numbers = {name: round(value, 2) + 0.0 for name, value in numbers.items()}
        report(figure, [(text.format(**numbers), colour) for text, colour in POST_LINES])
        return Picture(figure, POST_ALT.format(**numbers))


POST_LINES: list[tuple[Text, Colour]] = [
    (Text("the frame", "座標系"), Colour.SENSOR_FRAME),
    (Text("$x$ = {x:.2f} m", "$x$ = {x:.2f} m"), Colour.SENSOR_FRAME),
    (Text("$y$ = {y:.2f} m", "$y$ = {y:.2f} m"), Colour.SENSOR_FRAME),
    (Text("$\\theta$ = {heading:.0f}°", "$\\theta$ = {heading:.0f}°"), Colour.SENSOR_FRAME),
    (Text("the post, globally", "グローバル座標系での柱"), Colour.INK),
    (Text("$x_P$ = {x_P:.2f} m", "$x_P$ = {x_P:.2f} m"), Colour.INK),
    (Text("$y_P$ = {y_P:.2f} m", "$y_P$ = {y_P:.2f} m"), Colour.INK),
    (Text("the post, in the frame", "この座標系での柱"), Colour.PATH),
    (Text("$u$ = {u:.2f} m", "$u$ = {u:.2f} m"), Colour.PATH),
    (Text("$v$ = {v:.2f} m", "$v$ = {v:.2f} m"), Colour.PATH),
]
POST_ALT = Text(
    "A post on the floor at x = {x_P:.2f} m, y = {y_P:.2f} m, and a frame at x = {x:.2f} m, y = {y:.2f} m, turned by {heading:.0f} "
    "degrees. In the frame the post is at u = {u:.2f} m, v = {v:.2f} m.",
    "床の上の柱（x = {x_P:.2f} m、y = {y_P:.2f} m）と、x = {x:.2f} m、y = {y:.2f} mに{heading:.0f}度回して置いた座標系。この座標系では柱はu = {u:.2f} m、v = {v:.2f} mにある。",
)


class Place(NamedTuple):
    """Where a frame lies in BS: its origin, and the direction of its x axis as a complex number of length 1."""

    origin: complex
    forward: complex


#: GL and SP until the call, and what the call makes of those that it moves
BEFORE = Place(0j, 1 + 0j)
CALLED_WITH = (2.0, 0.5, math.radians(12))
CALL_AFTER = 13  # frames
START = -0.275  # [m], so that the robot is 2 m along the line when the call comes
SPEED, STEP, STEPS_PER_FRAME = 0.5, 0.05, 7  # [m/s], [s]


def line_animation() -> Film:
    """Return a film of two robots that follow a line on the floor; at one moment one calls set, the other adjust."""
    with styled():
        figure = new_figure(7.4, 6.2)
        rows = [
            _Row(figure.add_axes((0.115, bottom, 0.87, 0.38)), call, moves_line)
            for bottom, call, moves_line in ((0.555, "set", False), (0.085, "adjust", True))
        ]
        figure.axes[0].set_xlabel("")

        def draw(frame_number: int) -> None:
            for row in rows:
                row.draw(frame_number)

        return Film(figure, draw, FRAMES, 9.0, LINE_ALT)


LINE_ALT = Text(
    "Two robots follow the line of SP; halfway both are told a new pose in GL. After set GL jumps, the line stays and the robot "
    "keeps on it. After adjust GL and SP jump together, the line with them, and the robot swerves to the line where it is now.",
    "SPの直線に沿って走る二台のロボット。途中でどちらもGLでの新しい姿勢を知らされる。setではGLだけが飛び、直線は動かず、ロボットはその上を走り続ける。"
    "adjustではGLとSPが一緒に飛んで直線も移り、ロボットは新しい位置の直線へ曲がっていく。",
)
CALLING = Text("at the dot Spur_{call}_pos_GL was called", "黒丸の位置でSpur_{call}_pos_GLを呼んだ")
DRIVING = Text("following the line of SP", "SPの直線に追従中")


class _Row:
    """One of the two robots of the film, in axes of its own."""

    def __init__(self, axes: "Axes", call: str, moves_line: bool) -> None:
        self.axes = axes
        make_xy(axes)
        axes.set(xlim=(-0.8, 6.8), ylim=(-1.75, 0.95))
        self.call = call
        self.path, self.moved = driven(moves_line)
        self.moves_line = moves_line
        self.trail = axes.plot([], [], color=Colour.PATH, linewidth=2.5, zorder=3)[0]
        self.title = axes.text(0.01, 1.04, "", transform=axes.transAxes, fontsize=12.5, va="bottom")
        self.drawn: list[Any] = []

    def draw(self, frame_number: int) -> None:
        while self.drawn:
            self.drawn.pop().remove()
        called = frame_number >= CALL_AFTER
        present = set(self.axes.get_children())
        global_frame = self.moved if called else BEFORE
        line_frame = self.moved if called and self.moves_line else BEFORE
        line(self.axes, line_frame.origin, line_frame.origin + 9 * line_frame.forward, colour=Colour.SENSOR_FRAME, width=2)
        for place, length, colour, name, name_at in (
            (global_frame, 0.75, Colour.GLOBAL_FRAME, "GL", -0.25 + 0.75j),
            (line_frame, 0.45, Colour.SENSOR_FRAME, "SP", -0.25 + 0.3j),
        ):
            for direction in (place.forward, 1j * place.forward):
                arrow(self.axes, place.origin, place.origin + length * direction, colour, 2.4)
            write(self.axes, place.origin + name_at * place.forward, name, colour, 12)
        at = frame_number * STEPS_PER_FRAME
        x, y, theta = self.path[at]
        draw_robot(self.axes, (x, y, theta), tread=BEEGO_TREAD)
        self.trail.set_data(*self.path[: at + 1, :2].T)
        if called:
            dot(self.axes, complex(*self.path[CALL_AFTER * STEPS_PER_FRAME, :2]), Colour.INK, 9)
        text = CALLING.format(call=self.call) if called else DRIVING
        self.title.set_text(f"{self.call}: {in_chosen_language(text)}")
        self.drawn = [artist for artist in self.axes.get_children() if artist not in present]


def driven(moves_line: bool) -> "tuple[NDArray[np.float64], Place]":
    """Return the robot's path in BS, a row (x, y, theta) for each step, and where the call puts GL.

    Before the call the line is the x axis of BS; the call moves it along with GL if `moves_line`.
    """
    goal, turned_to, moved, path = BEFORE, 0.0, BEFORE, []
    at, theta = START + 0j, 0.0
    for step in range(FRAMES * STEPS_PER_FRAME):
        if step == CALL_AFTER * STEPS_PER_FRAME:
            moved = seen_from_there(Place(at, cmath.exp(1j * theta)), CALLED_WITH)
            if moves_line:
                goal, turned_to = moved, cmath.phase(moved.forward)
        path.append((at.real, at.imag, theta))
        offset = ((at - goal.origin) / goal.forward).imag
        at += SPEED * STEP * cmath.exp(1j * theta)
        theta -= STEP * (1.5 * offset + 1.6 * (theta - turned_to))
    return np.array(path), moved


def seen_from_there(robot: Place, pose: tuple[float, float, float]) -> Place:
    """Return where a frame has to lie so that the robot appears in it at `pose`."""
    x, y, theta = pose
    forward = robot.forward / cmath.exp(1j * theta)
    return Place(robot.origin - complex(x, y) * forward, forward)
