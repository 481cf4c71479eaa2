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

    `lines` and `points` are lists of {"xy": (N, 2), "label": text, "visible": bool}, where something that leaves no mark on the
    page is not visible; `limits` is (x0, x1, y0, y1); `scales` and `labels` are (x, y) pairs, labels as they are seen; `aspect`
    is the ratio of a unit of y to a unit of x on the page, 0.0 when it is free.
    """
    collections = sys.modules["matplotlib.collections"]
    shown = bool(axes.get_visible())
    lines = [_series(line.get_xydata(), line, shown and _leaves_a_mark(line)) for line in axes.get_lines()[:MAX_LINES]]
    # filled areas and error bars are collections too, but of no points
    points = []
    for group in axes.collections[:MAX_LINES]:
        if isinstance(group, collections.PathCollection):
            points.append(_series(group.get_offsets(), group, shown and _is_coloured(group)))
        elif isinstance(group, collections.LineCollection):
            chain = _chain(group.get_segments())
            lines += [] if chain is None else [_series(chain, group, shown and _is_coloured(group))]
    legend = axes.get_legend()
    return {
        "lines": [line for line in lines if line is not None],
        "points": [group for group in points if group is not None],
        "labels": [_seen_label(axes, "x"), _seen_label(axes, "y")],
        "title": plain_text(axes.get_title()),
        "scales": [plain_text(axes.get_xscale()), plain_text(axes.get_yscale())],
        "limits": np.array([*axes.get_xlim(), *axes.get_ylim()], dtype=float),
        "aspect": _aspect(axes),
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


def _series(xy: Any, artist: Any, visible: bool) -> dict[str, Plain] | None:
    # masked points are not drawn, as NaN are not
    values: np.ndarray = np.ma.filled(np.ma.asarray(xy, dtype=float), np.nan)
    if values.shape[0] > MAX_POINTS:
        return None
    return {
        "xy": np.array(values, dtype=np.float64),
        "label": plain_text(artist.get_label()),
        "visible": visible and bool(artist.get_visible()) and artist.get_alpha() != 0,
    }


def _leaves_a_mark(line: Any) -> bool:
    """Is a line drawn at all, or its markers?"""
    none = ("None", "none", "", " ", None)
    coloured = sys.modules["matplotlib.colors"].to_rgba(line.get_color())[3] > 0
    joined = line.get_linestyle() not in none and line.get_linewidth() > 0 and coloured
    return joined or (line.get_marker() not in none and line.get_markersize() > 0)


def _is_coloured(group: Any) -> bool:
    """Has a collection any colour that is not transparent? One that is coloured by values has."""
    colours = [group.get_facecolor(), group.get_edgecolor()]
    return group.get_array() is not None or any(len(part) and (part[:, 3] > 0).any() for part in colours)


def _chain(segments: Any) -> np.ndarray | None:
    """Return pieces of which each begins where the one before ends as one line, (N, 2); a line that changes colour is made so."""
    if not 0 < len(segments) <= MAX_POINTS or any(np.shape(piece) != (2, 2) for piece in segments):
        return None
    ends = np.array(segments, dtype=float)
    return np.concatenate([ends[:, 0], ends[-1:, 1]]) if np.array_equal(ends[1:, 0], ends[:-1, 1]) else None


def _seen_label(axes: Any, direction: str) -> str:
    """Return the label of the x or y axis as it is seen; Axes that share the axis may have it among them."""
    siblings = getattr(axes, f"get_shared_{direction}_axes")().get_siblings(axes)
    for one in [axes, *siblings]:
        axis = getattr(one, f"{direction}axis", None)
        if axis is None or not (one.axison and axis.get_visible() and axis.label.get_visible()):
            continue
        label = plain_text(axis.label.get_text())
        if label.strip():
            return label
    return ""


def _aspect(axes: Any) -> float:
    aspect = axes.get_aspect()
    if aspect != "auto":
        return float(aspect)
    box = axes.get_box_aspect()
    if box is None or not np.isscalar(box):  # three numbers in a 3D plot
        return 0.0
    width, height = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
    return float(box * width / height)
