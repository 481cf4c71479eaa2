"""Views of the notebook on the pose and its update."""

import math

from course.drawings.pose_update import RULES, step_paths
from course.drawings.robot import draw_robot
from course.language import Text
from course.plotting import Colour, Picture, arrow, dot, line, styled, unit_vector
from course.views.drive import BEEGO_TREAD
from course.views.view import Slider, View, plane, report


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
        figure, axes = plane(1.2)
        draw_robot(axes, (0, 0, math.radians(heading)), tread=BEEGO_TREAD)
        paths = step_paths(distance, dtheta, heading)
        for rule, path in paths.items():
            colour = RULES[rule][1]
            line(axes, *path, colour=colour, width=2.5, linestyle="-", zorder=6)
            arrow(axes, path[-1], path[-1] + 0.17 * unit_vector(heading + dtheta), colour, 1.3)
            dot(axes, path[-1], colour, 8)
        gaps = {rule: f"{1000 * abs(path[-1] - paths['arc'][-1]):.1f}" for rule, path in paths.items()}
        report(
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
