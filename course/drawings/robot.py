"""The robot as all drawings show it, and the words that they share."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, cast

from matplotlib.patches import Circle, FancyBboxPatch, Patch, Polygon, Rectangle
from matplotlib.transforms import Affine2D

from course.language import Text
from course.plotting import Colour, Quantity, dot

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


GLOBAL_FRAME = Text("global frame", "グローバル座標系")
SENSOR_FRAME = Text("sensor frame", "センサ座標系")
FORWARD = Text("forward", "前")
LEFT_WHEEL = Text("left wheel", "左車輪")
RIGHT_WHEEL = Text("right wheel", "右車輪")
SAMPLE = Quantity(Text("sample", "サンプル番号"))


def draw_robot(axes: "Axes", pose: Sequence[float], *, tread: float = 1.0, faint: bool = False) -> list[Patch]:
    """Draw the robot from above: two wheels, `tread` apart, a nose that points forward and a caster behind.

    `pose` is (x, y, theta) of the middle of the axle, theta in rad, counter-clockwise from +x.
    Returns the patches, so that an animation can take them away again.
    """
    x, y, theta = pose
    place = Affine2D().scale(tread).rotate(theta).translate(x, y) + axes.transData
    patches = _robot_patches()
    for patch in patches:
        patch.set(transform=place, alpha=0.35 if faint else 1.0)
        axes.add_patch(patch)
    return patches


def _robot_patches() -> list[Patch]:
    """Return the parts of a robot of tread 1 that stands at the origin and looks along +x."""
    wheels: list[Patch] = [
        FancyBboxPatch((-0.25, side - 0.07), 0.5, 0.14, "round,pad=0,rounding_size=0.04", color=Colour.WHEEL, zorder=3)
        for side in (-0.5, 0.5)
    ]
    axle = Rectangle((-0.025, -0.45), 0.05, 0.9, color=Colour.WHEEL, zorder=3)
    body = FancyBboxPatch((-0.6, -0.36), 1.05, 0.72, "round,pad=0,rounding_size=0.18", zorder=4)
    body.set(facecolor=Colour.BODY, edgecolor=Colour.WHEEL, linewidth=1.2)
    caster = Circle((-0.45, 0), 0.06, color=Colour.WHEEL, zorder=5)
    nose = Polygon([(0.22, -0.13), (0.4, 0), (0.22, 0.13)], color=Colour.WHEEL, zorder=5)
    return [axle, *wheels, body, caster, nose]


def stand(axes: "Axes", at: complex, heading: float, faint: bool = False) -> None:
    """Draw the robot at a point, looking in the direction `heading` [deg]."""
    draw_robot(axes, (at.real, at.imag, math.radians(heading)), faint=faint)
    dot(axes, at)


def figure_of(axes: "Axes") -> "Figure":
    """Return the figure that the axes belong to."""
    return cast("Figure", axes.get_figure())
