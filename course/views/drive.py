"""A film of a robot that drives along a trajectory."""

import math
from typing import TYPE_CHECKING

import numpy as np

from course.drawings.robot import draw_robot
from course.language import Text
from course.plotting import Colour, in_chosen_language, make_xy, new_figure, styled
from course.views.film import FRAMES, Film

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

BEEGO_TREAD = 0.2765  # [m]

NOT_POSES = Text(
    "poses must hold one row (x, y, theta) of numbers per instant: shape (N, 3), N >= 1. This has shape {shape}.",
    "posesは各時刻の(x, y, theta)を1行ずつ並べた、形(N, 3)の数の配列（N >= 1）でなければなりません。渡された形は{shape}です。",
)
NO_ARRAY = Text("no array of numbers", "数の配列ではないもの")
NOT_FINITE = Text(
    "poses must be finite; row {row} is {values}. Look at what happens in that step.",
    "posesに有限でない値があります。行{row}は{values}です。そのステップで何が起きたか調べてみましょう。",
)


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
            # z: no minus sign before a zero
            numbers = f"x = {pose[0]:z.2f} m,  y = {pose[1]:z.2f} m,  θ = {math.degrees(pose[2]):z.0f}°"
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
