"""Drawings of the notebook on the pose and its update."""

from typing import TYPE_CHECKING, Any

import numpy as np

from course.drawings.robot import FORWARD, GLOBAL_FRAME, SENSOR_FRAME, figure_of, stand
from course.language import Text
from course.plotting import Colour, arrow, dot, frame, line, new_sketch, note, pictured, turn, unit_vector, write

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray


@pictured(
    Text(
        "A robot with two wheels seen from above in the global frame. The middle of its axle is at x and y; its heading "
        "theta is counted counter-clockwise from the direction of the x axis.",
        "グローバル座標系の中の二輪ロボットを上から見た図。車軸の中点の位置が(x, y)で、x軸の方向から反時計回りに測った向きがθである。",
    )
)
def robot_pose() -> "Figure":
    """Draw the robot from above and its pose (x, y, theta) in the global frame."""
    axes = new_sketch((-0.8, 6.2), (-0.7, 3.7))
    at, heading = 3 + 1.6j, 35
    frame(axes, 0, 0, (5.4, 3.2), ("$x$", "$y$"), Colour.GLOBAL_FRAME)
    write(axes, 0.2 + 2.9j, GLOBAL_FRAME, ha="left")
    line(axes, at.real, at, at.imag * 1j)
    write(axes, at.real - 0.3j, "$x$", Colour.PATH, 16)
    write(axes, at.imag * 1j - 0.3, "$y$", Colour.PATH, 16)
    stand(axes, at, heading)
    line(axes, at, at + 2)
    arrow(axes, at, at + 1.9 * unit_vector(heading), Colour.HEADING)
    turn(axes, at, 1.3, 0, heading, Colour.HEADING)
    write(axes, at + 1.55 * unit_vector(heading / 2), r"$\theta$", Colour.HEADING, 16)
    note(axes, Text("middle of the axle", "車軸の中点"), at - 0.8 - 1.05j, at, ha="right")
    note(axes, Text("wheel", "車輪"), at - 0.4 + 1.25j, at + 0.5j * unit_vector(heading))
    return figure_of(axes)


@pictured(
    Text(
        "A robot moves from pose p1 to pose p2: it drives the distance D and turns by delta theta. At p1 its heading is "
        "theta 1; D and delta theta are known, p2 is asked for.",
        "ロボットが姿勢p1から距離Dだけ進み、Δθだけ向きを変えて姿勢p2になる図。p1での向きはθ1である。DとΔθが分かっているとき、p2を求めたい。",
    )
)
def one_step() -> "Figure":
    """Draw one step from p1 to p2: distance D, heading theta1, turn dtheta (slides 000, overview 1 and 2)."""
    axes = new_sketch((-0.6, 6.6), (-0.5, 4.3))
    first, heading, dtheta = 1.3 + 1.15j, 25, 40
    forward = unit_vector(heading)
    second = first + 3.2 * forward
    frame(axes, 0, 0, (6, 3.7), ("$x$", "$y$"), Colour.GLOBAL_FRAME)
    write(axes, 0.2 + 3.5j, GLOBAL_FRAME, ha="left")
    stand(axes, first, heading)
    stand(axes, second, heading + dtheta)
    line(axes, first, first + 1.7)
    turn(axes, first, 1.4, 0, heading, Colour.HEADING)
    write(axes, first + 1.7 * unit_vector(heading / 2), r"$\theta_1$", Colour.HEADING, 16)
    arrow(axes, first, second, Colour.PATH, 2.5)
    write(axes, first + 1.7 * forward + 0.25j * forward, "$D$", Colour.PATH, 16)
    line(axes, second, second + 1.7 * forward)
    arrow(axes, second, second + 1.5 * unit_vector(heading + dtheta), Colour.HEADING)
    turn(axes, second, 1.1, heading, heading + dtheta, Colour.HEADING)
    write(axes, second + 1.45 * unit_vector(heading + dtheta / 2), r"$\Delta\theta$", Colour.HEADING, 16)
    write(axes, first + 0.1 - 0.8j, r"$p_1 = (x_1, y_1, \theta_1)$", size=15)
    write(axes, second + 0.9 - 0.9j, r"$p_2 = (x_2, y_2, \theta_2)$", size=15)
    return figure_of(axes)


@pictured(
    Text(
        "The sensor frame sits on the robot at p1, turned by theta 1 against the global frame. In it the robot moves u "
        "forward and v to the left and turns by phi; so it comes to p2.",
        "p1にいるロボットに固定されたセンサ座標系は、グローバル座標系に対してθ1だけ回転している。ロボットはこの座標系で前へu、左へvだけ動き、φだけ回ってp2に着く。",
    )
)
def sensor_and_global_frames() -> "Figure":
    """Draw a displacement (u, v, phi) in the sensor frame against the global frame (slides 000, overview 3 and 4)."""
    axes = new_sketch((-0.6, 6.7), (-0.5, 4.5))
    first, heading, phi = 1.7 + 0.9j, 25, 35
    forward = unit_vector(heading)
    ahead, aside = first + 2.7 * forward, first + 1.25j * forward
    second = ahead + aside - first
    frame(axes, 0, 0, (6, 3.9), ("$x$", "$y$"), Colour.GLOBAL_FRAME)
    write(axes, 0.2 + 3.8j, GLOBAL_FRAME, ha="left")
    stand(axes, first, heading, faint=True)
    stand(axes, second, heading + phi)
    frame(axes, first, heading, (4.2, 2.0), (FORWARD, Text("left", "左")), Colour.SENSOR_FRAME)
    write(axes, first + (3.5 - 0.35j) * forward, SENSOR_FRAME, Colour.SENSOR_FRAME, ha="left")
    line(axes, aside, second, ahead)
    write(axes, first + (2.1 - 0.25j) * forward, "$u$", Colour.PATH, 17)
    write(axes, first + (-0.22 + 0.85j) * forward, "$v$", Colour.PATH, 17)
    arrow(axes, first, ahead, Colour.PATH, 3)
    arrow(axes, first, aside, Colour.PATH, 3)
    line(axes, first, first + 1.5)
    turn(axes, first, 1.1, 0, heading, Colour.SENSOR_FRAME)
    write(axes, first + 1.4 * unit_vector(heading / 2), r"$\theta_1$", Colour.SENSOR_FRAME, 16)
    line(axes, second, second + 1.6 * forward)
    arrow(axes, second, second + 1.3 * unit_vector(heading + phi), Colour.HEADING)
    turn(axes, second, 1.0, heading, heading + phi, Colour.HEADING)
    write(axes, second + 1.3 * unit_vector(heading + phi / 2), r"$\varphi$", Colour.HEADING, 17)
    write(axes, first - 0.9 - 0.1j, "$p_1$", size=16)
    write(axes, second - 0.75 + 0.1j, "$p_2$", size=16)
    return figure_of(axes)


def step_paths(distance: float, dtheta: float, heading: float) -> dict[str, "NDArray[Any]"]:
    """Return the paths from the origin of a step under the three rules, finely sampled; angles in deg.

    The rules differ only in how much of the turn is thought to be made when a piece of the way is driven.
    """
    pieces = 2000
    turned = (np.arange(pieces) + 0.5) / pieces
    rules = {"euler": np.zeros(pieces), "midpoint": np.full(pieces, 0.5), "arc": turned}
    return {
        rule: np.append(0, np.cumsum(np.exp(1j * np.radians(heading + dtheta * share)))) * distance / pieces
        for rule, share in rules.items()
    }


RULES = {
    "euler": (Text("Euler: heading before the step", "オイラー法：動く前の向き"), Colour.EULER),
    "midpoint": (Text("midpoint: heading half-way through", "中点法：半分だけ回った向き"), Colour.MIDPOINT),
    "arc": (Text("exact arc: heading turns steadily", "厳密な円弧：向きが一様に変わる"), Colour.ARC),
}


@pictured(
    Text(
        "One step with the same distance D and turn delta theta, drawn three times. Euler's rule drives straight along the "
        "heading before the step, the midpoint rule straight along the heading half-way, the exact path is an arc. The "
        "midpoint rule ends close to the arc, Euler's rule far away; all three end with the same heading.",
        "同じ距離Dと回転Δθの1ステップを三通りに描いた図。オイラー法は動く前の向きに直進し、中点法は途中の向きに直進し、厳密な経路は円弧になる。"
        "中点法の終点は円弧の終点に近いが、オイラー法の終点は離れている。最後の向きは三つとも同じである。",
    )
)
def heading_choices() -> "Figure":
    """Draw the same step under Euler's rule, the midpoint rule and as the exact arc."""
    axes = new_sketch((-0.9, 6.1), (-0.8, 3.9))
    distance, dtheta = 3.6, 100
    stand(axes, 0, 0)
    line(axes, 0, 5)
    write(axes, 2.9 + 0.28j, "$D$", Colour.EULER, 16)
    label_at = {"euler": 0.9 - 0.35j, "midpoint": 2.6 + 2.75j, "arc": 2.2 + 1.4j}
    for rule, path in step_paths(distance, dtheta, 0).items():
        text, colour = RULES[rule]
        line(axes, *path, colour=colour, width=3, linestyle="-", zorder=6)
        arrow(axes, path[-1], path[-1] + 0.8 * unit_vector(dtheta), colour, 1.5)
        dot(axes, path[-1], colour, 9)
        write(axes, label_at[rule], text, colour, ha="left")
    turn(axes, 0, 1.2, 0, dtheta / 2, Colour.QUIET)
    write(axes, 1.4 * unit_vector(66), r"$\Delta\theta/2$", Colour.QUIET, 15)
    return figure_of(axes)
