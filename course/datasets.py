"""The logs in `data/`: a table of recipes, and `python -m course.datasets [FOLDER]`, which makes them all anew.

The files are a product: the same recipes always give the same bytes. To add a log, add a recipe.
"""

import argparse
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from course.language import LANGUAGES, Text
from course.logs import REPOSITORY_DATA
from course.robots import BEEGO, ICART, Robot
from course.simulate import NOMINAL, Conditions, EncoderRun, Segment, encoder_log_text, encoder_run, truth_text

CIRCLE = 2 * math.pi
QUARTER = math.pi / 2


@dataclass(frozen=True)
class Recipe:
    """How one log is made: `data/NAME.dat` and, beside it, `data/NAME.truth.csv`."""

    name: str
    robot: Robot
    seed: int
    segments: tuple[Segment, ...]
    purpose: Text
    conditions: Conditions = NOMINAL


def rest(duration: float) -> Segment:
    """Return a segment of standing still for `duration` [s]."""
    return Segment(0.0, 0.0, duration)


RECIPES = (
    Recipe(
        name="encoder_straight_5m",
        robot=ICART,
        seed=1,
        segments=(rest(1.0), Segment(0.5, 0.0, 10.0), rest(1.0)),
        purpose=Text(
            "5 m straight ahead at 0.5 m/s, at rest before and after: is the scale right, and do both wheels count forward?",
            "前後に静止をはさみ、0.5 m/sで5 m直進。換算は正しいか、両輪とも前向きに数えるか。",
        ),
    ),
    Recipe(
        name="encoder_straight_left",
        robot=ICART,
        seed=2,
        segments=(rest(1.0), Segment(0.4, 0.0, 4.0), Segment(0.4, 0.5, 4.0), rest(1.0)),
        purpose=Text(
            "Straight ahead, then a gentle turn to the left of 2 rad: which counter is which wheel, and with which sign?",
            "直進してから緩やかに2 rad左折。どのカウンタがどちらの車輪で、符号は何か。",
        ),
    ),
    Recipe(
        name="encoder_beego_straight_left",
        robot=BEEGO,
        seed=3,
        segments=(rest(1.0), Segment(0.3, 0.0, 4.0), Segment(0.0, 0.8, 4.0), rest(1.0)),
        purpose=Text(
            "Straight ahead, then a turn to the left on the spot of 3.2 rad: the same question for another robot.",
            "直進してから、その場で3.2 rad左回転。別のロボットで同じ問いを考える。",
        ),
    ),
    Recipe(
        name="encoder_quarter_turn",
        robot=ICART,
        seed=4,
        segments=(rest(0.5), Segment(0.5, 0.0, 3.0), Segment(0.4, QUARTER / 3.0, 3.0), Segment(0.5, 0.0, 2.5), rest(0.5)),
        purpose=Text(
            "Straight, a quarter turn to the left along an arc, straight: theta ends at -pi/2, as i-Cart counts clockwise.",
            "直進、円弧で左へ90度、直進。i-Cartは時計回りを正とするのでthetaは最後に-pi/2となる。",
        ),
    ),
    Recipe(
        name="encoder_figure_eight",
        robot=BEEGO,
        seed=5,
        segments=(rest(0.5), Segment(0.6, 1.2, CIRCLE / 1.2), Segment(0.6, -1.2, CIRCLE / 1.2), rest(0.5)),
        purpose=Text(
            "A circle to the left, then one to the right: theta turns past pi and comes back to 0, near the start.",
            "左回りの円、続いて右回りの円。thetaはpiを超えて0に戻り、出発点の近くで終わる。",
        ),
    ),
)

README_HEAD = """\
# Logs / ログ

Made by `python -m course.datasets`; do not edit by hand. Simulated robots, so the truth is known.

`python -m course.datasets`で生成したファイルです。手で編集しないでください。シミュレーションなので真値が分かります。
"""

TITLES = Text("## The logs", "## ログの一覧")
COLUMNS = Text(
    "| log | robot | rate [Hz] | rows | seed | what it is for |", "| ログ | ロボット | 周波数 [Hz] | 行数 | 乱数の種 | 用途 |"
)

FORMATS = Text(
    """\
## Formats

All files are UTF-8 text with one row per line; lines that begin with `#` are comments. A robot whose tread is negative
counts its yaw clockwise as seen from above, and its y points to the right; with a positive tread yaw counts
counter-clockwise and y points to the left. `course.robots` holds the robots' parameters.

- `NAME.dat`, encoder log: time [s]; increments of counter 1 and of counter 2 since the row before [counts], after 4x
  decoding; PWM of motor 1 and of motor 2, not used in the course. Row 0 holds no motion. Read it with
  `course.logs.read_encoder_log`.
- `NAME.truth.csv`, truth at the same stamps: time [s], x [m], y [m], theta [rad, not wrapped], velocity [m/s],
  yaw rate [rad/s]. Row 0 is the pose (0, 0, 0). Read it with `course.logs.read_truth`.
""",
    """\
## 形式

どのファイルもUTF-8のテキストで、1行が1サンプルです。`#`で始まる行はコメントです。トレッドが負のロボットは、
上から見て時計回りをヨー角の正とし、yは右を向きます。トレッドが正なら反時計回りが正で、yは左を向きます。
ロボットのパラメータは`course.robots`にあります。

- `NAME.dat` エンコーダのログ: 時刻 [s]、前の行からのカウンタ1とカウンタ2の増分 [カウント] (4逓倍後)、
  モータ1とモータ2のPWM (この講義では使いません)。0行目に動きはありません。`course.logs.read_encoder_log`で読みます。
- `NAME.truth.csv` 同じ時刻の真値: 時刻 [s]、x [m]、y [m]、theta [rad、折り返しなし]、速度 [m/s]、
  角速度 [rad/s]。0行目の姿勢は(0, 0, 0)です。`course.logs.read_truth`で読みます。
""",
)


def run(recipe: Recipe) -> EncoderRun:
    """Return the log and the truth that `recipe` describes."""
    return encoder_run(recipe.robot, recipe.segments, recipe.seed, recipe.conditions)


def data_files() -> dict[str, bytes]:
    """Return everything that this module keeps in `data/`: the content of each file by its name."""
    runs = {recipe.name: run(recipe) for recipe in RECIPES}
    logs = {f"{name}.dat": encoder_log_text(made.log) for name, made in runs.items()}
    truths = {f"{name}.truth.csv": truth_text(made.truth) for name, made in runs.items()}
    rows = {name: len(made.log["time"]) for name, made in runs.items()}
    return {name: text.encode() for name, text in {**logs, **truths, "README.md": _readme(rows)}.items()}


def _readme(rows: dict[str, int]) -> str:
    tables = ["\n".join([TITLES.to(language), "", *_table(rows, language)]) for language in LANGUAGES[::-1]]
    return "\n".join([README_HEAD, tables[0], "", FORMATS.en, tables[1], "", FORMATS.ja])


def _table(rows: dict[str, int], language: str) -> list[str]:
    head = [COLUMNS.to(language), "|---|---|---:|---:|---:|---|"]
    return head + [
        f"| `{recipe.name}` | {recipe.robot.name} | {1 / recipe.conditions.period:g} | {rows[recipe.name]} "
        f"| {recipe.seed} | {recipe.purpose.to(language)} |"
        for recipe in RECIPES
    ]


def main(arguments: Sequence[str] | None = None) -> None:
    """Write all files of `data_files` into the folder named on the command line; others there are left alone."""
    parser = argparse.ArgumentParser(prog="python -m course.datasets", description="Make the logs in data/ anew.")
    parser.add_argument("folder", nargs="?", type=Path, default=REPOSITORY_DATA, help="where to (default: %(default)s)")
    folder = parser.parse_args(arguments).folder
    folder.mkdir(parents=True, exist_ok=True)
    files = data_files()
    for name, content in files.items():
        (folder / name).write_bytes(content)
    print(f"{len(files)} files written to {folder}")


if __name__ == "__main__":
    main()
