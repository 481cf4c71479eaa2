"""The course's one plotting style: colours by role, glyphs for both languages, labelled axes, arrows and pictures.

Importing this module makes the style Matplotlib's own, so that students' graphs look like ours and show Japanese.
In drawings a point of the plane is a complex number, x + y*1j, so that turning a shape is a multiplication.
"""

import base64
import html
import io
import logging
import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import StrEnum
from functools import cached_property, wraps
from typing import TYPE_CHECKING, Any, NamedTuple

import matplotlib as mpl
import numpy as np
from cycler import cycler
from matplotlib.patches import FancyArrowPatch
from matplotlib.path import Path

from course.language import Text, chosen_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PIXELS_PER_INCH = 100
PIXEL_RATIO = 2  # stored pixels per pixel of the page: crisp on dense screens and in print


class Colour(StrEnum):
    """Roles and their colours, after Okabe and Ito: told apart with every common colour vision."""

    INK = "#222222"
    QUIET = "#6B6B6B"
    PAPER = "#FFFFFF"
    SHADE = "#EEF2F5"
    METAL = "#C9D1D9"
    BODY = "#CFE6F5"
    WHEEL = "#3A4048"
    HEADING = "#00795A"
    GLOBAL_FRAME = "#222222"
    SENSOR_FRAME = "#D55E00"
    RIGHT = "#D55E00"
    LEFT = "#0072B2"
    EULER = "#D55E00"
    MIDPOINT = "#00795A"
    ARC = "#0072B2"
    PATH = "#0072B2"
    RIGHT_WAY = "#00795A"
    WRONG_WAY = "#D55E00"


LINE_COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#222222")


class Quantity(NamedTuple):
    """What an axis shows: the name of the quantity and its unit ("" for a plain number)."""

    name: Text | str
    unit: str = ""


def in_chosen_language(text: Text | str) -> str:
    """Return the text in the reader's language; a plain string stays as it is."""
    return text.to(chosen_language()) if isinstance(text, Text) else text


def _register_japanese_font() -> str:
    """Make the font that matplotlib-fontja ships known to Matplotlib and return its name."""
    # On a new computer Matplotlib first looks through all fonts and says so on stderr, which would alarm a beginner.
    log = logging.getLogger("matplotlib.font_manager")
    level = log.level
    log.setLevel(logging.ERROR)
    try:
        from matplotlib_fontja.matplotlib_fontja import FONT_NAME
    finally:
        log.setLevel(level)
    return str(FONT_NAME)


_JAPANESE_FONT = _register_japanese_font()
_LATIN_FONT = "DejaVu Sans"  # comes with Matplotlib


def course_style() -> dict[Any, Any]:
    """Return the style as rcParams; a text with a formula in it is set in the first font, hence the order by language."""
    fonts = [_JAPANESE_FONT, _LATIN_FONT] if chosen_language() == "ja" else [_LATIN_FONT, _JAPANESE_FONT]
    return {
        "font.family": fonts,
        "font.size": 12,
        "mathtext.fontset": "cm",
        "text.color": Colour.INK,
        "axes.edgecolor": Colour.QUIET,
        "axes.labelcolor": Colour.INK,
        "axes.prop_cycle": cycler(color=LINE_COLOURS),
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.color": "#DDDDDD",
        "lines.linewidth": 2,
        "legend.frameon": False,
        "figure.facecolor": Colour.PAPER,
        "figure.subplot.left": 0.13,
        "figure.subplot.right": 0.96,
        "figure.subplot.bottom": 0.15,
        "figure.subplot.top": 0.93,
    }


def use_course_style() -> None:
    """Make the course's style Matplotlib's own from now on."""
    mpl.rcParams.update(course_style())


use_course_style()


@contextmanager
def styled() -> Iterator[None]:
    """Draw in the course's style, whatever the reader has done to rcParams, and leave those as they were."""
    with mpl.rc_context():
        mpl.rcdefaults()
        use_course_style()
        yield


class Picture:
    """A figure as the output of a notebook cell: a crisp PNG with alt text, never wider than the page."""

    def __init__(self, figure: "Figure", alt: Text | str) -> None:
        """Take over the figure and close it, so that Jupyter does not show it once more by itself."""
        from matplotlib import pyplot as plt

        plt.close(figure)
        self.figure = figure
        self.alt = in_chosen_language(alt)

    @cached_property
    def png(self) -> bytes:
        """The bytes of the PNG, with PIXEL_RATIO stored pixels per pixel shown."""
        file = io.BytesIO()
        with styled():
            self.figure.savefig(file, dpi=PIXELS_PER_INCH * PIXEL_RATIO, metadata={"Software": None})
        return file.getvalue()

    @property
    def width(self) -> int:
        """The width in pixels of the page."""
        return round(self.figure.get_figwidth() * PIXELS_PER_INCH)

    @property
    def html(self) -> str:
        """The picture as one <img> element that needs no other file."""
        return (
            f'<img alt="{html.escape(self.alt)}" width="{self.width}" style="max-width:100%;height:auto" '
            f'src="data:image/png;base64,{base64.b64encode(self.png).decode()}">'
        )

    def _repr_mimebundle_(self, **_: object) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.alt}

    def __repr__(self) -> str:
        return self.alt


def pictured(alt: Text) -> Callable[[Callable[[], "Figure"]], Callable[[], Picture]]:
    """Turn a function that draws a figure into one that returns it as a Picture with this alt text."""

    def decorate(draw: Callable[[], "Figure"]) -> Callable[[], Picture]:
        @wraps(draw)
        def picture() -> Picture:
            with styled():
                return Picture(draw(), alt)

        return picture

    return decorate


def new_axes(size: tuple[float, float] = (6.4, 4.0)) -> "Axes":
    """Return empty axes of a new pyplot figure of this size [inch], in the course's style."""
    from matplotlib import pyplot as plt

    use_course_style()
    return plt.subplots(figsize=size)[1]


def new_xy_axes(size: tuple[float, float] = (6.0, 5.2)) -> "Axes":
    """Return empty axes for a path seen from above: x and y in m, one metre as long to the right as upwards."""
    axes = new_axes(size)
    make_xy(axes)
    axes.set_aspect("equal", adjustable="datalim")
    return axes


def make_xy(axes: "Axes") -> None:
    """Label the axes x [m] and y [m] and give both the same scale."""
    label_axes(axes, Quantity("x", "m"), Quantity("y", "m"))
    axes.set_aspect("equal")


def label_axes(axes: "Axes", x: Quantity | tuple[Text | str, str], y: Quantity | tuple[Text | str, str]) -> None:
    """Write quantity and unit at both axes.

    >>> label_axes(new_axes(), ("time", "s"), ("yaw", "rad"))
    """
    axes.set_xlabel(_with_unit(*x))
    axes.set_ylabel(_with_unit(*y))


def _with_unit(name: Text | str, unit: str = "") -> str:
    return f"{in_chosen_language(name)} [{unit}]" if unit else in_chosen_language(name)


def new_figure(width: float, height: float) -> "Figure":
    """Return an empty figure of this size [inch] that pyplot does not know and so never shows by itself."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), dpi=PIXELS_PER_INCH)


def new_sketch(x_range: tuple[float, float], y_range: tuple[float, float], width: float = 7.0) -> "Axes":
    """Return axes without ticks that fill a new figure `width` inches wide, with the same scale for x and y."""
    height = width * (y_range[1] - y_range[0]) / (x_range[1] - x_range[0])
    axes = new_figure(width, height).add_axes((0, 0, 1, 1))
    axes.set(xlim=x_range, ylim=y_range)
    axes.axis("off")
    return axes


def write(axes: "Axes", at: complex, text: Text | str, colour: str = Colour.INK, size: float = 13, **style: Any) -> None:
    """Write a text centred at a point, on a patch of paper that hides the lines below."""
    paper = {"facecolor": Colour.PAPER, "edgecolor": "none", "alpha": 0.85, "pad": 1.5}
    look: dict[str, Any] = {"ha": "center", "va": "center", "bbox": paper, "zorder": 8, "linespacing": 1.4}
    axes.text(at.real, at.imag, in_chosen_language(text), color=colour, fontsize=size, **look | style)


def line(axes: "Axes", *points: complex, colour: str = Colour.QUIET, width: float = 1.2, **style: Any) -> None:
    """Draw a line through the points, dashed unless told otherwise."""
    look: dict[str, Any] = {"color": colour, "linewidth": width, "linestyle": (0, (5, 4)), "zorder": 2}
    axes.plot(np.real(points), np.imag(points), **look | style)


def dot(axes: "Axes", at: complex, colour: str = Colour.INK, size: float = 6) -> None:
    """Mark a point."""
    axes.plot(at.real, at.imag, "o", color=colour, markersize=size, markeredgecolor=Colour.PAPER, zorder=7)


def arrow(axes: "Axes", start: complex, end: complex, colour: str = Colour.INK, width: float = 2, **style: Any) -> None:
    """Draw a straight arrow from point to point."""
    _add_arrow(axes, np.array([start, end]), colour, width, **style)


def turn(  # noqa: PLR0913
    axes: "Axes",
    centre: complex,
    radius: float,
    start: float,
    end: float,
    colour: str = Colour.INK,
    width: float = 1.8,
    **style: Any,
) -> None:
    """Draw a circular arrow about `centre` from the direction `start` to `end` [deg], counter-clockwise if it grows."""
    directions = np.radians(np.linspace(start, end, 60))
    _add_arrow(axes, centre + radius * np.exp(1j * directions), colour, width, **style)


def dimension(axes: "Axes", start: complex, end: complex, text: Text | str, colour: str = Colour.QUIET) -> None:
    """Draw a double arrow between two points, with its length written in the middle."""
    arrow(axes, start, end, colour, width=1.2, arrowstyle="<|-|>")
    write(axes, (start + end) / 2, text, colour)


def frame(  # noqa: PLR0913
    axes: "Axes",
    origin: complex,
    heading: float,
    lengths: tuple[float, float],
    names: tuple[Text | str, Text | str],
    colour: str,
    y_side: int = 1,
) -> None:
    """Draw the two axes of a frame turned by `heading` [deg]; its second axis points to the left, or right if y_side is -1."""
    forward = unit_vector(heading)
    for direction, length, name in zip((forward, forward * 1j * y_side), lengths, names, strict=True):
        arrow(axes, origin, origin + length * direction, colour)
        beyond = origin + (length + 0.02 * _span(axes)) * direction
        write(
            axes, beyond, name, colour, 14, ha=_side(direction.real, "right", "left"), va=_side(direction.imag, "top", "bottom")
        )


def _side(towards: float, before: str, after: str) -> str:
    """Return the alignment that makes a text grow away from an arrow which points this way."""
    return before if towards < -0.4 else after if towards > 0.4 else "center"


def note(axes: "Axes", text: Text | str, at: complex, about: complex, colour: str = Colour.QUIET, **style: Any) -> None:
    """Write a text beside what it is about and draw a thin line there."""
    line(axes, at, about, colour=colour, width=0.9, linestyle="-", zorder=7)
    write(axes, at, text, colour, 12, **style)


def unit_vector(degrees: float) -> complex:
    """Return the point at distance 1 from the origin in this direction, counter-clockwise from x."""
    return complex(math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))


def _span(axes: "Axes") -> float:
    low, high = axes.get_xlim()
    return high - low


def _add_arrow(axes: "Axes", points: Any, colour: str, width: float, **style: Any) -> None:
    path = Path(np.column_stack([points.real, points.imag]))
    look: dict[str, Any] = {"arrowstyle": "-|>", "mutation_scale": 9 + 4 * width, "shrinkA": 0, "shrinkB": 0, "zorder": 6}
    look |= {"color": colour, "linewidth": width, "joinstyle": "miter", "capstyle": "butt"}
    axes.add_patch(FancyArrowPatch(path=path, **look | style))
