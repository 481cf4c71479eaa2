"""Views of the notebook on numerical integration."""

from functools import cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from matplotlib.ticker import NullFormatter

from course.drawings.robot import draw_robot
from course.language import Text
from course.plotting import Colour, Picture, Quantity, in_chosen_language, label_axes, line, make_xy, new_figure, styled
from course.views.drive import BEEGO_TREAD
from course.views.view import Slider, View

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray


class Rule(NamedTuple):
    """A rule of integration: its name, colour and marker, and the instants that it looks at with their weights.

    An instant is a share of the step, 0 its beginning and 1 its end.
    """

    name: Text
    colour: Colour
    marker: str
    instants: tuple[float, ...]
    weights: tuple[float, ...]


RULES = {
    "euler": Rule(Text("Euler", "オイラー法"), Colour.EULER, "o", (0.0,), (1.0,)),
    "trapezoid": Rule(Text("trapezoid", "台形公式"), Colour.ARC, "s", (0.0, 1.0), (0.5, 0.5)),
    "midpoint": Rule(Text("midpoint", "中点法"), Colour.MIDPOINT, "^", (0.5,), (1.0,)),
}
SECONDS = 4.0
SHORTEST, LONGEST, STEP = 0.05, 1.0, 0.05
MARKED_STEPS = 30  # more markers than this hide the path


def step_size_view() -> View:
    """Show the path that each rule computes for a drive of 4 s, and its error over the step size, for any step size."""
    return View(_picture_of_steps, Slider(Text("step size Δt [s]", "ステップサイズ Δt [s]"), SHORTEST, LONGEST, STEP, 0.5))


def speeds(t: "NDArray[np.float64]") -> "tuple[NDArray[np.float64], NDArray[np.float64]]":
    """Return V [m/s] and omega [rad/s] at the instants t [s]: a robot that speeds up in a bend that tightens."""
    return 0.4 + 0.1 * t, 0.2 + 0.3 * t


def stamps(step: float) -> "NDArray[np.float64]":
    """Return the instants [s] from 0 to the end of the drive; the last step is shorter where the others leave less."""
    return np.append(np.arange(0, SECONDS - 1e-9, step), SECONDS)


def computed_path(rule: Rule, t: "NDArray[np.float64]") -> "NDArray[np.complex128]":
    """Return the path x + iy [m] at the stamps t that a rule computes from V and omega where it looks at them.

    The heading at an instant inside a step comes from the same rule, used on the part of the step before it.
    """
    steps = np.diff(t)
    omega_parts = [weight * speeds(t[:-1] + at * steps)[1] for at, weight in zip(rule.instants, rule.weights, strict=True)]
    headings = np.append(0, np.cumsum(sum(omega_parts) * steps))
    velocity = np.zeros(len(steps), dtype=complex)
    for at, weight in zip(rule.instants, rule.weights, strict=True):
        turned = headings[:-1] + at * np.diff(headings)
        velocity += weight * speeds(t[:-1] + at * steps)[0] * np.exp(1j * turned)
    return np.append(0, np.cumsum(velocity * steps))


@cache
def _true_path() -> "NDArray[np.complex128]":
    return computed_path(RULES["midpoint"], stamps(0.0005))


@cache
def errors_at_the_end(step: float) -> dict[str, float]:
    """Return the distance [m] from the true end of the drive to the end that each rule computes with this step size [s]."""
    return {name: float(abs(computed_path(rule, stamps(step))[-1] - _true_path()[-1])) for name, rule in RULES.items()}


def _picture_of_steps(step: float) -> Picture:
    with styled():
        figure = new_figure(7.8, 4.4)
        _draw_paths(figure.add_axes((0.09, 0.14, 0.43, 0.84)), step)
        _draw_errors(figure.add_axes((0.64, 0.14, 0.34, 0.84)), step)
        gaps = {name: f"{1000 * gap:.1f}" for name, gap in errors_at_the_end(step).items()}
        return Picture(figure, STEPS_ALT.format(step=step, **gaps))


def _draw_paths(axes: "Axes", step: float) -> None:
    truth = _true_path()
    line(axes, *truth, colour=Colour.QUIET, width=5, linestyle="-", alpha=0.4, label=in_chosen_language(Text("true", "真の経路")))
    for name, rule in RULES.items():
        path = computed_path(rule, stamps(step))
        gap = 1000 * errors_at_the_end(step)[name]
        label = f"{in_chosen_language(rule.name)}: {gap:.1f} mm"
        size = 5 if len(path) <= MARKED_STEPS else 0
        axes.plot(path.real, path.imag, f"{rule.marker}-", color=rule.colour, markersize=size, linewidth=1.6, label=label)
    draw_robot(axes, (0, 0, 0), tread=BEEGO_TREAD, faint=True)
    make_xy(axes)
    axes.set(xlim=(-0.3, 2.1), ylim=(-0.3, 2.5))
    axes.legend(loc="upper left", fontsize=11)


def _draw_errors(axes: "Axes", step: float) -> None:
    sizes = np.round(np.arange(SHORTEST, LONGEST + STEP / 2, STEP), 6)
    for name, rule in RULES.items():
        axes.loglog(sizes, [errors_at_the_end(float(size))[name] for size in sizes], color=rule.colour, linewidth=1.6)
        axes.loglog(step, errors_at_the_end(step)[name], rule.marker, color=rule.colour, markersize=9)
    axes.axvline(step, color=Colour.QUIET, linestyle=":", linewidth=1.2, zorder=0)
    axes.set_xticks([0.05, 0.1, 0.2, 0.5, 1.0], ["0.05", "0.1", "0.2", "0.5", "1"])
    axes.xaxis.set_minor_formatter(NullFormatter())
    label_axes(axes, Quantity(r"$\Delta t$", "s"), Quantity(Text("error at the end", "終点の誤差"), "m"))


STEPS_ALT = Text(
    "Left: a path that bends more and more, as it is and as three rules compute it with steps of {step:.2f} s. Right: the "
    "error at the end over the step size, both axes logarithmic, this step size marked. Euler's rule ends {euler} mm from "
    "the truth, the trapezoid rule {trapezoid} mm, the midpoint rule {midpoint} mm.",
    "左：曲がりがしだいにきつくなる経路と、{step:.2f} sのステップで三つの規則が計算した経路。右：ステップサイズに対する終点の誤差（両対数）で、"
    "このステップサイズに印がある。終点の誤差は、オイラー法が{euler} mm、台形公式が{trapezoid} mm、中点法が{midpoint} mm。",
)
