"""A picture with sliders above it.

Where sliders cannot work (no running kernel, a page exported as HTML) the same view is shown as a still picture.
"""

import importlib.util
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from IPython import get_ipython

from course.language import Text
from course.plotting import Picture, in_chosen_language, make_xy, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


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


def plane(half_width: float) -> "tuple[Figure, Axes]":
    """Return a figure with axes x-y around the origin on its left, and room for numbers on its right."""
    figure = new_figure(7.6, 4.9)
    axes = figure.add_axes((0.1, 0.13, 0.55, 0.84))
    make_xy(axes)
    axes.set(xlim=(-half_width, half_width), ylim=(-half_width, half_width))
    return figure, axes


def report(figure: "Figure", lines: Sequence[tuple[Text | str, str]]) -> None:
    """Write lines of text on the right of the figure, each in its colour."""
    for row, (text, colour) in enumerate(lines):
        figure.text(0.69, 0.92 - 0.085 * row, in_chosen_language(text), color=colour, fontsize=12.5, va="center")
