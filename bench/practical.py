"""How exact the solution of the practical is: a table for the teaching assistants, as Markdown.

    python bench/practical.py [en|ja]

Runs the solution cells of `source/odometry/wheel_odometry.md` on every clean log, takes the lines that its three graphs show and
compares them with the simulator's truth. The table stands behind the rubric of `odometry_discussion`.
"""

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import jupytext
import matplotlib as mpl
import numpy as np

from course.datasets import RECIPES, Recipe
from course.language import LANGUAGES, Text
from course.logs import data_path, read_truth

SOURCE = Path(__file__).parents[1] / "source/odometry/wheel_odometry.md"
PROGRAM = ("read_encoder_log", "wheel_odometry")
GRAPHS = ("xy_axes", "yaw_axes", "speed_axes")

HEAD = Text(
    "| log | path [m] | end error [mm] | RMS [mm] | bound [mm] | yaw RMS [mdeg] | bound [mdeg] |",
    "| ログ | 経路長 [m] | 終点の誤差 [mm] | RMS [mm] | 上限 [mm] | ヨー角のRMS [mdeg] | 上限 [mdeg] |",
)


class Accuracy(NamedTuple):
    """How far the graphs of one log are from the truth; lengths in m, angles in rad.

    Every wheel's travel is known to half a count, so a distance to half a count and the heading to one count over the tread. A
    wrong heading moves all that follows sideways, and half a count is lost once more with the direction in which it was driven.
    """

    log: str
    path: float
    end: float
    rms: float
    bound: float
    yaw_rms: float
    yaw_bound: float

    @property
    def row(self) -> str:
        """Return the row of the table."""
        lengths = f"{self.path:.2f} | {self.end * 1e3:.3f} | {self.rms * 1e3:.3f} | {self.bound * 1e3:.3f}"
        return f"| `{self.log}` | {lengths} | {np.degrees(self.yaw_rms) * 1e3:.2f} | {np.degrees(self.yaw_bound) * 1e3:.2f} |"


def accuracies() -> Iterator[Accuracy]:
    """Yield the accuracy of the solution on each log whose robot is as the parameters say and whose rows are all there."""
    mpl.use("agg")
    cells = {cell.metadata.get("exercise"): cell.source for cell in jupytext.read(SOURCE).cells if cell.cell_type == "code"}
    for recipe in RECIPES:
        if _is_clean(recipe):
            yield _accuracy(recipe, *_graphs(recipe, cells))


def _is_clean(recipe: Recipe) -> bool:
    conditions = recipe.conditions
    nominal = conditions.radius_right is None and conditions.radius_left is None
    return nominal and conditions.slip is None and not conditions.lost and not conditions.long_gap


def _graphs(recipe: Recipe, cells: dict[str, str]) -> tuple[np.ndarray, ...]:
    """Return what the three graphs show, (N, 2) each: x and y [m], time [s] and yaw [rad], time and speed [m/s]."""
    from matplotlib import pyplot as plt

    names: dict[str, Any] = {"np": np, "plt": plt, "re": re}
    for name in PROGRAM:
        exec(cells[name], names)
    log = names["read_encoder_log"](data_path(f"{recipe.name}.dat"))
    names["estimate"] = names["wheel_odometry"](log, recipe.robot)
    for name in GRAPHS:
        exec(cells[name], names)
    lines = [names[name].get_lines()[0].get_xydata() for name in GRAPHS]
    plt.close("all")
    lines[1] = lines[1] * [1, np.pi / 180]
    return tuple(lines)


def _accuracy(recipe: Recipe, path: np.ndarray, yaw: np.ndarray, speed: np.ndarray) -> Accuracy:
    robot, truth = recipe.robot, read_truth(data_path(f"{recipe.name}.truth.csv"))
    for graph in (yaw, speed):
        np.testing.assert_allclose(graph[:, 0], truth["time"] - truth["time"][0], atol=1e-6)
    count = 2 * np.pi * robot.radius / (robot.gear * robot.counts_per_rev)
    length = np.abs(speed[1:, 1] * np.diff(speed[:, 0])).sum()
    yaw_bound = count / abs(robot.tread)
    off = np.hypot(path[:, 0] - truth["x"], path[:, 1] - truth["y"])
    turned = np.abs(np.diff(truth["theta"])).sum()
    return Accuracy(
        recipe.name,
        float(length),
        float(off[-1]),
        float(np.sqrt(np.mean(off**2))),
        float(count / 2 * (1 + turned) + length * yaw_bound),
        float(np.sqrt(np.mean((yaw[:, 1] - truth["theta"]) ** 2))),
        float(yaw_bound),
    )


def table(language: str) -> str:
    """Return the table in a language, "en" or "ja"."""
    rule = "|---|" + "---:|" * 6
    return "\n".join([HEAD.to(language), rule, *(accuracy.row for accuracy in accuracies())])


if __name__ == "__main__":
    languages = sys.argv[1:] or LANGUAGES
    print("\n\n".join(table(language) for language in languages))
