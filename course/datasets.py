"""The logs in `data/`: a table of recipes, and `python -m course.datasets [FOLDER]`, which makes them all anew.

The files are a product: the same recipes always give the same bytes. To add a log, add a recipe. Beside the logs there
are the results of a UMBmark test, and in `data/dirty/` what `course.dirty_logs` makes of a short log.
"""

import argparse
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from course.dirty_logs import DIRTY_LOGS, DirtyLog
from course.language import LANGUAGES, Text
from course.logs import REPOSITORY_DATA, FloatArray
from course.robots import BEEGO, ICART, Robot
from course.simulate import (
    NOMINAL,
    Conditions,
    EncoderRun,
    Segment,
    Slip,
    encoder_log_text,
    encoder_run,
    steered_by_odometry,
    truth_text,
)

CIRCLE = 2 * math.pi
QUARTER = math.pi / 2
LEFT, RIGHT = 1, -1

AT_100_HZ = Conditions(period=0.01)
SPRING_2024 = 1713147300.28125
"""An instant in Unix time: 15 April 2024, 11:15 in Japan."""


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


def square(side: float, speed: float, turn: int) -> tuple[Segment, ...]:
    """Return a square with a stop before and after each corner, turned LEFT or RIGHT on the spot; all four corners."""
    corner = (rest(0.5), Segment(0.0, turn * QUARTER / 2.0, 2.0), rest(0.5))
    return (rest(0.5), *(4 * (Segment(speed, 0.0, side / speed), *corner)))


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
    Recipe(
        name="encoder_square_cw",
        robot=BEEGO,
        seed=6,
        segments=square(2.0, 0.5, RIGHT),
        conditions=AT_100_HZ,
        purpose=Text(
            "A square of side 2 m, clockwise, corners turned on the spot: it ends where it began, theta at -2 pi.",
            "一辺2 mの正方形を時計回りに一周し、角ではその場で回る。出発点に戻り、thetaは-2 piとなる。",
        ),
    ),
    Recipe(
        name="encoder_square_ccw",
        robot=BEEGO,
        seed=7,
        segments=square(2.0, 0.5, LEFT),
        conditions=AT_100_HZ,
        purpose=Text(
            "The same square counter-clockwise, theta ends at 2 pi: what does a small closing error prove, and what not?",
            "同じ正方形を反時計回りに一周し、thetaは2 piとなる。閉合誤差が小さいことから何が言え、何は言えないか。",
        ),
    ),
    Recipe(
        name="encoder_reversing",
        robot=ICART,
        seed=8,
        segments=(
            *(rest(0.5), Segment(0.5, 0.4, 4.0), rest(0.5), Segment(-0.4, 0.5, 4.0), rest(0.5)),
            *(Segment(0.5, -0.3, 3.0), rest(0.5)),
        ),
        conditions=AT_100_HZ,
        purpose=Text(
            "A curve to the left, a curve backwards, a curve to the right: speed has a sign, a turning point is a cusp.",
            "左へ曲がり、曲がりながら後退し、右へ曲がる。速度には符号があり、切り返しで経路はとがる。",
        ),
    ),
    Recipe(
        name="encoder_slip",
        robot=BEEGO,
        seed=9,
        segments=(rest(0.5), Segment(0.4, 0.0, 8.0), rest(0.5)),
        conditions=Conditions(period=0.01, slip=Slip(start=4.0, duration=0.4, right=0.05)),
        purpose=Text(
            "Straight ahead; from 4.0 s to 4.4 s the right wheel slips and counts 5 cm too many: the error stays for good.",
            "直進中、4.0 sから4.4 sまで右車輪が滑り、5 cm分多く数える。誤差はその後も消えない。",
        ),
    ),
    Recipe(
        name="encoder_wrong_radius",
        robot=BEEGO,
        seed=10,
        segments=(rest(0.5), Segment(0.5, 0.0, 8.0), Segment(0.4, 0.5, 6.0), Segment(0.5, 0.0, 6.0), rest(0.5)),
        conditions=Conditions(period=0.01, radius_right=1.007 * BEEGO.radius, radius_left=1.007 * BEEGO.radius),
        purpose=Text(
            "Both wheels are 0.7 % larger than the nominal radius: odometry falls short in distance and in angle.",
            "両輪の半径が公称値より0.7 %大きい。オドメトリでは距離も角度も不足する。",
        ),
    ),
    Recipe(
        name="encoder_jitter",
        robot=ICART,
        seed=11,
        segments=(rest(0.5), Segment(0.5, 0.0, 3.0), Segment(0.5, 0.6, 4.0), Segment(0.5, -0.6, 3.0), rest(0.5)),
        conditions=Conditions(jitter=0.001),
        purpose=Text(
            "Stamps stray by 1 ms (standard deviation) from the 5 ms grid: divided by 5 ms, speeds are noise; the path is not.",
            "時刻が5 ms間隔から標準偏差1 msでばらつく。一律5 msで割ると速度に雑音が乗るが、経路は変わらない。",
        ),
    ),
    Recipe(
        name="encoder_lost_cycles",
        robot=ICART,
        seed=12,
        segments=(
            *(rest(0.5), Segment(0.8, 0.0, 5.0), Segment(0.6, 0.6, 5.0)),
            *(Segment(0.8, 0.0, 2.5), Segment(0.6, -0.8, 3.0), rest(0.5)),
        ),
        conditions=Conditions(jitter=0.0002, start=SPRING_2024, lost=0.06, long_gap=34),
        purpose=Text(
            "7 % of the 5 ms cycles are missing, their counts too: gaps of one and two cycles, one of 34; the path is too short.",
            "5 ms周期の7 %が、増分ごと失われている(1周期か2周期、一度だけ34周期)。経路が短くなる。",
        ),
    ),
    Recipe(
        name="encoder_two_radii",
        robot=ICART,
        seed=13,
        segments=(rest(0.5), Segment(0.8, 0.0, 12.5), rest(0.5)),
        conditions=Conditions(radius_left=0.14533),
        purpose=Text(
            "10 m straight ahead with a left wheel 0.5 % larger than nominal (0.14533 m): odometry bends what was straight.",
            "左車輪の半径だけが公称値より0.5 %大きい(0.14533 m)まま10 m直進。まっすぐな経路がオドメトリでは曲がる。",
        ),
    ),
    Recipe(
        name="encoder_unix_time",
        robot=BEEGO,
        seed=14,
        segments=(rest(0.5), Segment(0.4, 0.3, 5.0), Segment(0.3, -0.5, 5.0), rest(0.5)),
        conditions=Conditions(period=0.01, start=SPRING_2024),
        purpose=Text(
            "Stamps in Unix time: float32 cannot tell two rows apart, and the first row has no dt.",
            "時刻がUnix時間。float32では隣り合う行を区別できない。最初の行にはdtがない。",
        ),
    ),
    Recipe(
        name="encoder_practical",
        robot=ICART,
        seed=15,
        segments=(
            *(rest(1.0), Segment(0.5, 0.0, 4.0), Segment(0.4, 0.7, 10.0), Segment(0.5, 0.0, 3.0), rest(0.5)),
            *(Segment(-0.3, -0.5, 4.0), Segment(0.0, -0.8, 3.0), Segment(0.5, 0.2, 3.5), rest(1.0)),
        ),
        conditions=Conditions(period=0.01, jitter=0.001, start=SPRING_2024 + 3600.0),
        purpose=Text(
            "For the three graphs of notebook 5: more than one turn, a stretch in reverse, Unix time, 10 ms with a jitter of 1 ms.",
            "ノートブック5の三つのグラフ用。一周を超える旋回、後退、Unix時間、周期10 ms(ジッタ1 ms)を含む。",
        ),
    ),
    Recipe(
        name="encoder_short",
        robot=ICART,
        seed=16,
        segments=(rest(0.5), Segment(0.4, 0.5, 1.0), rest(0.5)),
        conditions=Conditions(period=0.05),
        purpose=Text(
            "Short enough to read by eye; the logs in `dirty/` are made from it.",
            "目で追えるほど短いログ。`dirty/`のログの元でもある。",
        ),
    ),
)
CLEAN_LOG = "encoder_short"

UMBMARK_SIDE = 4.0
UMBMARK_RUNS = 5
UMBMARK_WHEELS = 1.001
"""Right wheel over left wheel; their mean is the nominal radius. Borenstein and Feng call it E_d."""
UMBMARK_TREAD = 1.003
"""True over nominal tread. Borenstein and Feng call it E_b."""
UMBMARK_SPREAD = 1e-4
"""How much the rolling radius of each wheel differs from run to run (standard deviation, relative): load, tyre, floor."""


@dataclass(frozen=True)
class Umbmark:
    """How one half of a UMBmark test is made: `data/NAME.csv`, one row per run round the square."""

    name: str
    seed: int
    turn: int
    purpose: Text


UMBMARKS = (
    Umbmark(
        name="umbmark_cw",
        seed=17,
        turn=RIGHT,
        purpose=Text(
            "Clockwise: how far are the two wheels and the tread from their nominal sizes?",
            "時計回り。左右の車輪とトレッドは、公称値からどれだけずれているか。",
        ),
    ),
    Umbmark(
        name="umbmark_ccw",
        seed=18,
        turn=LEFT,
        purpose=Text(
            "Counter-clockwise: one direction alone cannot tell unequal wheels from a wrong tread.",
            "反時計回り。片方向だけでは、車輪の違いとトレッドの誤りを区別できない。",
        ),
    ),
)
UMBMARK_HEADER = "# x [m], y [m]: true position after the square minus that of odometry"

README_HEAD = """\
# Logs / ログ

Made by `python -m course.datasets`; do not edit by hand. Simulated robots, so the truth is known.

`python -m course.datasets`で生成したファイルです。手で編集しないでください。シミュレーションなので真値が分かります。
"""

TITLES = Text("## The logs", "## ログの一覧")
COLUMNS = Text(
    "| log | robot | rate [Hz] | rows | seed | what it is for |", "| ログ | ロボット | 周波数 [Hz] | 行数 | 乱数の種 | 用途 |"
)

UMBMARK_COLUMNS = Text("| file | robot | runs | seed | what it is for |", "| ファイル | ロボット | 回数 | 乱数の種 | 用途 |")
UMBMARK = Text(
    """\
## UMBmark

A Beego that steers by its odometry drives round a square of side {side:g} m, {runs} times each way: from (0, 0) along x, a
turn on the spot at each of the four corners. It believes that it is back at (0, 0) and is not. Each row of
`NAME.csv` is one return, true position minus that of odometry: x [m], y [m]. Read it with
`np.loadtxt(path, delimiter=",")`. The truth: the right wheel is {wheels:g} times as large as the left one (their mean is the
nominal radius), the tread {tread:g} times the nominal one; from run to run each wheel varies by {spread:g} %.
Borenstein and Feng's formulas are of first order: they find the former within 0.0001, the latter within 0.0005.
""",
    """\
## UMBmark

オドメトリに従って走るBeegoが、一辺{side:g} mの正方形を両方向に{runs}回ずつ回った結果です。(0, 0)からx方向に出発し、
四つの角ではその場で回ります。ロボットは(0, 0)に戻ったつもりですが、実際にはずれています。`NAME.csv`の1行が1回分で、
終点の真の位置からオドメトリの位置を引いた値 x [m]、y [m] です。`np.loadtxt(path, delimiter=",")`で読みます。
真値: 右車輪の半径は左車輪の{wheels:g}倍(平均は公称値)、トレッドは公称値の{tread:g}倍です。
車輪の半径は走行ごとに{spread:g} %ばらつきます。BorensteinとFengの式は一次近似なので、
前者は0.0001以内、後者は0.0005以内で求まります。
""",
).format(side=UMBMARK_SIDE, runs=UMBMARK_RUNS, wheels=UMBMARK_WHEELS, tread=UMBMARK_TREAD, spread=100 * UMBMARK_SPREAD)

DIRTY_COLUMNS = Text("| log | what is odd | a good reader |", "| ログ | どこがおかしいか | よい読み込み関数の反応 |")
REFUSES = Text("refuses it: `{refusal}`", "エラーにします: `{refusal}`")
DIRTY = Text(
    """\
## Dirty logs

`dirty/NAME.dat`, for trying readers: each is `{clean}` with one change. Some are to be read, some are not. The messages
are those of `course.logs.read_encoder_log`.
""",
    """\
## 汚れたログ

`dirty/NAME.dat`は読み込み関数を試すためのログで、どれも`{clean}`を1か所だけ変えたものです。読めるべきものと、
エラーにすべきものがあります。メッセージは`course.logs.read_encoder_log`のものです。
""",
).format(clean=CLEAN_LOG)

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


def return_errors(half: Umbmark) -> FloatArray:
    """Return where each run of one half of the UMBmark test really ends, (UMBMARK_RUNS, 2) [m].

    These are true minus odometry's positions: by its odometry the robot is back at (0, 0).
    """
    return np.array([[made.truth["x"][-1], made.truth["y"][-1]] for made in umbmark_runs(half)])


def umbmark_runs(half: Umbmark) -> list[EncoderRun]:
    """Return the runs of one half of the UMBmark test: Borenstein and Feng 1996, section 3, with simulated robots."""
    rng = np.random.default_rng(half.seed)
    believed = square(UMBMARK_SIDE, 0.4, half.turn)
    runs = []
    for seed in range(UMBMARK_RUNS):
        conditions = _umbmark_conditions(rng)
        runs.append(encoder_run(BEEGO, steered_by_odometry(BEEGO, believed, conditions), seed, conditions))
    return runs


def _umbmark_conditions(rng: np.random.Generator) -> Conditions:
    left = BEEGO.radius * 2 / (1 + UMBMARK_WHEELS)
    of_today_right, of_today_left = rng.normal(1.0, UMBMARK_SPREAD, 2)
    return Conditions(
        period=0.02,
        radius_right=left * UMBMARK_WHEELS * of_today_right,
        radius_left=left * of_today_left,
        tread=UMBMARK_TREAD * abs(BEEGO.tread),
    )


def umbmark_text(errors: FloatArray) -> str:
    """Return the return errors as the text of their file: a header comment, then x and y in tenths of a millimetre."""
    return "\n".join([UMBMARK_HEADER, *(f"{x:.4f},{y:.4f}" for x, y in errors.tolist()), ""])


def data_files() -> dict[str, bytes]:
    """Return everything that this module keeps in `data/`: the content of each file by its path in there."""
    runs = {recipe.name: run(recipe) for recipe in RECIPES}
    logs = {f"{name}.dat": encoder_log_text(made.log) for name, made in runs.items()}
    truths = {f"{name}.truth.csv": truth_text(made.truth) for name, made in runs.items()}
    umbmarks = {f"{half.name}.csv": umbmark_text(return_errors(half)) for half in UMBMARKS}
    dirty = {f"dirty/{log.name}.dat": log.change(logs[f"{CLEAN_LOG}.dat"]) for log in DIRTY_LOGS}
    rows = {name: len(made.log["time"]) for name, made in runs.items()}
    return {name: text.encode() for name, text in {**logs, **truths, **umbmarks, **dirty, "README.md": _readme(rows)}.items()}


def _readme(rows: dict[str, int]) -> str:
    return "\n".join([README_HEAD, *(_edition(rows, language) for language in LANGUAGES[::-1])])


def _edition(rows: dict[str, int], language: str) -> str:
    logs = "\n".join([TITLES.to(language), "", *_logs_table(rows, language), ""])
    umbmark = "\n".join([UMBMARK.to(language), *_umbmark_table(language), ""])
    dirty = "\n".join([DIRTY.to(language), *_dirty_table(language), ""])
    return "\n".join([logs, FORMATS.to(language), umbmark, dirty])


def _logs_table(rows: dict[str, int], language: str) -> list[str]:
    head = [COLUMNS.to(language), "|---|---|---:|---:|---:|---|"]
    return head + [
        f"| `{recipe.name}` | {recipe.robot.name} | {1 / recipe.conditions.period:g} | {rows[recipe.name]} "
        f"| {recipe.seed} | {recipe.purpose.to(language)} |"
        for recipe in RECIPES
    ]


def _umbmark_table(language: str) -> list[str]:
    head = [UMBMARK_COLUMNS.to(language), "|---|---|---:|---:|---|"]
    return head + [
        f"| `{half.name}` | {BEEGO.name} | {UMBMARK_RUNS} | {half.seed} | {half.purpose.to(language)} |" for half in UMBMARKS
    ]


def _dirty_table(language: str) -> list[str]:
    return [DIRTY_COLUMNS.to(language), "|---|---|---|"] + [
        f"| `{log.name}` | {log.oddity.to(language)} | {_reaction(log).to(language)} |" for log in DIRTY_LOGS
    ]


def _reaction(log: DirtyLog) -> Text:
    if log.refusal is None:
        return log.reading
    return REFUSES.format(refusal=log.refusal.format(path=f"dirty/{log.name}.dat"))


def main(arguments: Sequence[str] | None = None) -> None:
    """Write all files of `data_files` into the folder named on the command line; others there are left alone."""
    parser = argparse.ArgumentParser(prog="python -m course.datasets", description="Make the logs in data/ anew.")
    parser.add_argument("folder", nargs="?", type=Path, default=REPOSITORY_DATA, help="where to (default: %(default)s)")
    folder = parser.parse_args(arguments).folder
    files = data_files()
    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    print(f"{len(files)} files written to {folder}")


if __name__ == "__main__":
    main()
