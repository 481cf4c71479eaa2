"""Drawings of the notebook on frames."""

from typing import TYPE_CHECKING

from course.drawings.robot import figure_of, stand
from course.language import Text
from course.plotting import (
    Colour,
    arrow,
    dimension,
    dot,
    frame,
    line,
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

FRAME_COLOURS = {
    "BS": Colour.QUIET,
    "GL": Colour.GLOBAL_FRAME,
    "LC": Colour.LEFT,
    "FS": Colour.HEADING,
    "SP": Colour.SENSOR_FRAME,
    "BL": Colour.QUIET,
}
POST = Text("post", "柱")


def _draw_frame(axes: "Axes", origin: complex, heading: float, name: str, name_at: complex = -0.3 - 0.3j) -> None:
    """Draw both axes of one of YP-Spur's frames in its colour; `name_at` is where its name stands, in the frame itself."""
    colour = FRAME_COLOURS[name]
    frame(axes, origin, heading, (1.2, 1.2), ("$x$", "$y$"), colour)
    dot(axes, origin, colour)
    write(axes, origin + name_at * unit_vector(heading), name, colour, 14)


@pictured(
    Text(
        "A post P in the global frame GL and in the frame FS of a robot that stands turned by theta. Dashed lines lead from the "
        "post to the axes of both: its coordinates are x_P and y_P in GL, u forward and v to the left in FS.",
        "グローバル座標系GLと、θだけ回って立つロボットの座標系FSの両方から見た柱P。柱から両方の座標軸へ破線が引かれている。座標はGLではx_Pとy_P、FSでは前方へu、左へvである。",
    )
)
def point_in_two_frames() -> "Figure":
    """Draw one point with its coordinates in the global frame and in the robot's (notes 001, section 2)."""
    axes = new_sketch((-0.9, 6.8), (-0.75, 4.6), width=7.2)
    at, heading, seen = 2.3 + 1.1j, 28, 2.9 + 0.9j
    forward = unit_vector(heading)
    post = at + seen * forward
    frame(axes, 0, 0, (6.2, 4.0), ("$x$", "$y$"), Colour.GLOBAL_FRAME)
    write(axes, -0.35 - 0.3j, "GL", Colour.GLOBAL_FRAME, 14)
    stand(axes, at, heading, faint=True)
    frame(axes, at, heading, (3.9, 1.9), ("", ""), Colour.SENSOR_FRAME)
    write(axes, at + (-0.45 - 0.55j) * forward, "FS", Colour.SENSOR_FRAME, 14)
    line(axes, post.real, post, post.imag * 1j)
    line(axes, at + seen.real * forward, post, at + 1j * seen.imag * forward, colour=Colour.SENSOR_FRAME)
    line(axes, at, at + 1.6)
    turn(axes, at, 1.35, 0, heading, Colour.SENSOR_FRAME)
    write(axes, at + 1.65 * unit_vector(heading / 2), r"$\theta$", Colour.SENSOR_FRAME, 16)
    write(axes, post.real - 0.35j, "$x_P$", size=16)
    write(axes, post.imag * 1j - 0.42, "$y_P$", size=16)
    write(axes, at + (seen.real - 0.05 - 0.28j) * forward, "$u$", Colour.SENSOR_FRAME, 17)
    write(axes, at + (-0.28 + 1j * seen.imag) * forward, "$v$", Colour.SENSOR_FRAME, 17)
    dot(axes, post, Colour.PATH, 11)
    write(axes, post + 0.1 + 0.42j, "$P$", Colour.PATH, 17)
    note(axes, POST, post + 1.1 + 0.35j, post)
    return figure_of(axes)


@pictured(
    Text(
        "Three frames: GL, frame a in GL, and frame b in a. One arrow leads from GL to a and one from a to b; the arrow straight "
        "from GL to b is a composed with b. The headings add up: theta a, then theta b.",
        "三つの座標系の図。GLと、GLから見た座標系aと、aから見た座標系b。GLからa、aからbへ矢印が引かれ、GLからbへ直接引いた矢印が、aとbの合成である。向きはθaとθbの和になる。",
    )
)
def chain_of_frames() -> "Figure":
    """Draw the composition of two poses: b is given in a, and asked for in a's parent."""
    axes = new_sketch((-0.8, 6.8), (-0.8, 4.2), width=7.2)
    first, heading, turned = 2.4 + 0.5j, 25, 40
    second = first + (2.5 + 0.9j) * unit_vector(heading)
    frame(axes, 0, 0, (1.2, 1.5), ("$x$", "$y$"), Colour.GLOBAL_FRAME)
    frame(axes, first, heading, (1.5, 1.5), ("", ""), Colour.SENSOR_FRAME)
    frame(axes, second, heading + turned, (1.3, 1.3), ("", ""), Colour.LEFT)
    write(axes, -0.35 - 0.3j, "GL", Colour.GLOBAL_FRAME, 14)
    write(axes, first + 0.25 - 0.4j, Text("frame $a$", "座標系 $a$"), Colour.SENSOR_FRAME)
    write(axes, second + 0.95 - 0.1j, Text("frame $b$", "座標系 $b$"), Colour.LEFT)
    arrow(axes, 0, first, Colour.SENSOR_FRAME, 2.8)
    arrow(axes, first, second, Colour.LEFT, 2.8)
    arrow(axes, 0, second, Colour.HEADING, 2.8, linestyle=(0, (4, 3)))
    write(axes, 0.8 * first - 0.3j, "$a$", Colour.SENSOR_FRAME, 18)
    write(axes, first + 0.68 * (second - first) - 0.3j, "$b$", Colour.LEFT, 18)
    write(axes, 0.62 * second + 0.35j, r"$a \circ b$", Colour.HEADING, 18)
    for at, start, by, name, colour in (
        (first, 0, heading, r"$\theta_a$", Colour.SENSOR_FRAME),
        (second, heading, turned, r"$\theta_b$", Colour.LEFT),
    ):
        line(axes, at, at + 1.3 * unit_vector(start))
        turn(axes, at, 0.9, start, start + by, colour)
        write(axes, at + 1.2 * unit_vector(start + by / 2), name, colour, 15)
    return figure_of(axes)


@pictured(
    Text(
        "Left: the frames of YP-Spur on the floor. BS is where the robot was switched on; GL, FS on the robot and SP with the "
        "line that it follows are placed in BS, LC in GL. Right: the same as a tree: below BS stand GL, FS, SP and BL, below GL "
        "stands LC.",
        "左は床の上に描いたYP-Spurの座標系。BSは電源を入れた場所で、GL、ロボットに付いたFS、追従する直線をもつSPはBSの上に、LCはGLの上に置かれている。"
        "右は同じ関係を表す木で、BSの下にGL、FS、SP、BLが、GLの下にLCがある。",
    )
)
def ypspur_frames() -> "Figure":
    """Draw the frames of YP-Spur, which of them lies in which, and the line that hangs on SP (notes 001, figure 2)."""
    axes = new_sketch((-0.9, 12.6), (-0.95, 5.0), width=8.0)
    _draw_frame(axes, 0, 0, "BS")
    _draw_frame(axes, 0.9 + 2.7j, 12, "GL")
    _draw_frame(axes, 4.2 + 3.2j, 60, "LC")
    start, heading = 3.0 + 0.1j, 10
    line(axes, start, start + 4.4 * unit_vector(heading), colour=Colour.SENSOR_FRAME, width=2)
    _draw_frame(axes, start, heading, "SP", 0.05 - 0.4j)
    write(axes, start + (3.3 - 0.42j) * unit_vector(heading), Text("line", "追従する直線"), Colour.SENSOR_FRAME, 12)
    robot = start + (2.3 + 0.5j) * unit_vector(heading)
    stand(axes, robot, 0, faint=True)
    _draw_frame(axes, robot, 0, "FS", -0.75 + 0.65j)
    _draw_tree(axes)
    return figure_of(axes)


def _draw_tree(axes: "Axes") -> None:
    """Draw which frame lies in which."""
    places = {"BS": 10.1 + 3.6j, "GL": 8.3 + 1.7j, "FS": 9.5 + 1.7j, "SP": 10.7 + 1.7j, "BL": 11.9 + 1.7j, "LC": 8.3 - 0.2j}
    parents = {"GL": "BS", "FS": "BS", "SP": "BS", "BL": "BS", "LC": "GL"}
    for child, parent in parents.items():
        arrow(axes, places[parent] - 0.35j, places[child] + 0.35j, Colour.QUIET, 1.3)
    for name, at in places.items():
        write(axes, at, name, FRAME_COLOURS[name], 15)
    write(axes, places["BS"] + 0.65j, Text("odometry starts here", "オドメトリの原点"), Colour.QUIET, 11.5)
    write(axes, places["FS"] - 0.6j, Text("robot", "ロボット"), FRAME_COLOURS["FS"], 11.5)
    write(axes, places["SP"] - 0.6j, Text("motion", "走行制御"), FRAME_COLOURS["SP"], 11.5)


@pictured(
    Text(
        "Slides 003 read in two ways, each for a robot with theta = 30 degrees. Left, theta counts from x: the robot looks 30 "
        "degrees from x but the equations move it 60 degrees from x, not along its nose. Right, theta counts from y towards x as "
        "on a compass: the robot moves along its nose, but with the right wheel faster it turns left while the equations let "
        "theta grow, to the right.",
        "スライド003の二通りの読み方（どちらもθ = 30度）。左はθをx軸から測る場合で、ロボットはxから30度の方向を向くのに、式ではxから60度の方向へ動き、前へ進まない。"
        "右は方位磁石のようにθをy軸からxへ向かって測る場合で、前へ進むが、右車輪が速いと左へ曲がるのに、式ではθが増えて右へ曲がってしまう。",
    )
)
def axes_of_slides_003() -> "Figure":
    """Draw why slides 003 fit neither a heading from x nor a compass heading."""
    axes = new_sketch((-0.7, 11.4), (-1.1, 4.3), width=8.0)
    _draw_reading(axes, 0, Text("θ from $x$ towards $y$", "θを $x$ から $y$ へ測る"), 30)
    _draw_reading(axes, 6.3, Text("θ from $y$ towards $x$ (compass)", "θを $y$ から $x$ へ測る（方位磁石）"), 60)
    left, right = 1.3 + 1.1j, 7.6 + 1.1j
    arrow(axes, left, left + 2.2 * unit_vector(60), Colour.WRONG_WAY, 2.8)
    write(axes, left + 2.2 * unit_vector(60) + 0.3j, Text("moves", "動く向き"), Colour.WRONG_WAY)
    write(axes, left + 2.4 * unit_vector(30) + 0.3j, Text("looks", "ロボットの向き"), Colour.RIGHT_WAY)
    line(axes, left, left + 1.9)
    turn(axes, left, 1.5, 0, 30, Colour.HEADING)
    write(axes, left + 1.8 * unit_vector(13), r"$\theta$", Colour.HEADING, 16)
    line(axes, right, right + 1.9j)
    turn(axes, right, 1.4, 90, 60, Colour.HEADING)
    write(axes, right + 1.7 * unit_vector(76), r"$\theta$", Colour.HEADING, 16)
    turn(axes, right, 2.25, 55, 20, Colour.WRONG_WAY, 2.2)
    turn(axes, right, 2.25, 65, 112, Colour.RIGHT_WAY, 2.2)
    write(axes, right + 2.5 + 1.9j, Text("003 turns\nthis way", "003では\nこちらへ"), Colour.WRONG_WAY, 11.5)
    write(axes, right - 0.4 + 2.75j, Text("the wheels turn it this way", "車輪はこちらへ曲げる"), Colour.RIGHT_WAY, 11.5)
    return figure_of(axes)


def _draw_reading(axes: "Axes", at: float, title: Text, heading: float) -> None:
    """Draw axes and a robot in them that looks in the direction `heading` [deg] from x, counter-clockwise."""
    frame(axes, at, 0, (4.2, 3.4), ("$x$", "$y$"), Colour.GLOBAL_FRAME)
    robot = at + 1.3 + 1.1j
    stand(axes, robot, heading)
    arrow(axes, robot, robot + 2.2 * unit_vector(heading), Colour.RIGHT_WAY, 2.8)
    write(axes, at + 2.1 - 0.7j, title)


@pictured(
    Text(
        "A robot from above between its two wheels. T is the distance from wheel to wheel, d the distance from the middle of the "
        "axle to one wheel: half of T.",
        "上から見たロボットの二つの車輪の間。Tは車輪から車輪までの距離、dは車軸の中点から片方の車輪までの距離で、Tの半分である。",
    )
)
def half_tread() -> "Figure":
    """Draw the tread T of slides 000 beside the d of slides 003."""
    axes = new_sketch((-2.6, 2.6), (-1.5, 1.25), width=5.2)
    stand(axes, 0, 90)
    line(axes, 0.62j, 1.05j, width=0.8, linestyle="-")
    line(axes, 0.5 + 0.3j, 0.5 + 1.05j, width=0.8, linestyle="-")
    for side in (-0.5, 0.5):
        line(axes, side - 0.3j, side - 1.3j, width=0.8, linestyle="-")
    dimension(axes, -0.5 - 1.1j, 0.5 - 1.1j, "$T$", Colour.RIGHT_WAY)
    dimension(axes, 0.9j, 0.5 + 0.9j, "$d$", Colour.WRONG_WAY)
    write(axes, 1.55 + 0.9j, Text("slides 003", "スライド003"), Colour.WRONG_WAY)
    write(axes, 1.55 - 1.1j, Text("slides 000", "スライド000"), Colour.RIGHT_WAY)
    write(axes, -1.7 + 0j, "$T = 2d$", size=17)
    return figure_of(axes)


@pictured(
    Text(
        "One robot, two ways to say where it looks: theta counts counter-clockwise from the x axis, the compass heading h "
        "clockwise from the y axis. Together they make the right angle between the axes.",
        "一台のロボットの向きを表す二通りの方法。θはx軸から反時計回りに、コンパス方位hはy軸から時計回りに測る。二つを合わせると座標軸の間の直角になる。",
    )
)
def compass_and_heading() -> "Figure":
    """Draw the heading theta beside the compass heading h = pi/2 - theta."""
    axes = new_sketch((-0.8, 4.9), (-0.7, 3.6), width=6.0)
    at, heading = 1.2 + 0.8j, 35
    frame(axes, 0, 0, (4.4, 3.1), ("$x$", "$y$"), Colour.GLOBAL_FRAME)
    stand(axes, at, heading)
    line(axes, at, at + 2.6)
    line(axes, at, at + 2.3j)
    arrow(axes, at, at + 2.5 * unit_vector(heading), Colour.INK, 2.5)
    turn(axes, at, 1.7, 0, heading, Colour.HEADING, 2.4)
    turn(axes, at, 1.7, 90, heading, Colour.SENSOR_FRAME, 2.4)
    write(axes, at + 2.0 * unit_vector(heading / 2), r"$\theta$", Colour.HEADING, 18)
    write(axes, at + 2.0 * unit_vector((90 + heading) / 2), "$h$", Colour.SENSOR_FRAME, 18)
    write(axes, 3.45 + 0.4j, Text("from $x$ towards $y$", "$x$ から $y$ へ"), Colour.HEADING)
    write(axes, 2.4 + 3.2j, Text("compass heading", "コンパス方位"), Colour.SENSOR_FRAME)
    write(axes, 3.9 + 2.75j, r"$h = \pi/2 - \theta$", size=17)
    return figure_of(axes)
