"""A drawn graph as plain data: lines, points, labels, scales. It crosses the sandbox, and is all that a judge sees of a figure."""

import sys
from typing import Any

import numpy as np

from course.plain import Plain, plain_text

MAX_LINES = 50
MAX_POINTS = 200_000


def is_axes(value: object) -> bool:
    """Is `value` a Matplotlib Axes?"""
    axes = sys.modules.get("matplotlib.axes")
    # of the type, not isinstance: a value may lie about its class
    return axes is not None and issubclass(type(value), axes.Axes)


def axes_summary(axes: Any) -> dict[str, Plain]:
    """Return what an Axes shows, as plain data.

    `lines` and `points` are lists of {"xy": (N, 2), "label": text, "visible": bool}; `limits` is (x0, x1, y0, y1); `scales` and
    `labels` are (x, y) pairs; `aspect` is the ratio of a unit of y to a unit of x on the page, 0.0 when it is free.
    """
    lines = [_series(line.get_xydata(), line) for line in axes.get_lines()[:MAX_LINES]]
    # filled areas and error bars are collections too, but of no points
    scatter = sys.modules["matplotlib.collections"].PathCollection
    points = [_series(group.get_offsets(), group) for group in axes.collections[:MAX_LINES] if isinstance(group, scatter)]
    legend = axes.get_legend()
    aspect = axes.get_aspect()
    return {
        "lines": [line for line in lines if line is not None],
        "points": [group for group in points if group is not None],
        "labels": [plain_text(axes.get_xlabel()), plain_text(axes.get_ylabel())],
        "title": plain_text(axes.get_title()),
        "scales": [plain_text(axes.get_xscale()), plain_text(axes.get_yscale())],
        "limits": np.array([*axes.get_xlim(), *axes.get_ylim()], dtype=float),
        "aspect": 0.0 if aspect == "auto" else float(aspect),
        "legend": [] if legend is None else [plain_text(text.get_text()) for text in legend.get_texts()[:MAX_LINES]],
    }


def is_summary(figure: Plain) -> bool:
    """Is `figure` made like what `axes_summary` returns? What comes out of a sandbox may be anything."""
    match figure:
        case {
            "lines": [*lines],
            "points": [*points],
            "labels": [str(), str()],
            "title": str(),
            "scales": [str(), str()],
            "limits": np.ndarray(shape=(4,)),
            "aspect": float(),
            "legend": [*legend],
        }:
            return all(map(_is_series, [*lines, *points])) and all(type(entry) is str for entry in legend)
    return False


def _is_series(series: Plain) -> bool:
    match series:
        case {"xy": np.ndarray(shape=(_, 2)), "label": str(), "visible": bool()}:
            return True
    return False


def _series(xy: Any, artist: Any) -> dict[str, Plain] | None:
    # masked points are not drawn, as NaN are not
    values: np.ndarray = np.ma.filled(np.ma.asarray(xy, dtype=float), np.nan)
    if values.shape[0] > MAX_POINTS:
        return None
    return {
        "xy": np.array(values, dtype=np.float64),
        "label": plain_text(artist.get_label()),
        "visible": bool(artist.get_visible()),
    }
