"""Read the logs of the course: encoder logs and IMU logs in the formats of the slides, and their truth files.

One row per line, values separated by commas or white space. Blank lines and lines that begin with # (perhaps after
blanks) may stand anywhere; nothing follows the values of a row. Files are UTF-8, with or without a byte-order mark,
with any line ends.
"""

import math
import os
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from course.language import Text

FloatArray = npt.NDArray[np.float64]
Log = dict[str, FloatArray]

ENCODER_COLUMNS = ("time", "counter1", "counter2", "pwm1", "pwm2")
IMU_COLUMNS = (
    *("time", "gyro x", "gyro y", "gyro z", "accel x", "accel y", "accel z"),
    *("other x", "other y", "other z", "temperature"),
)
TRUTH_COLUMNS = ("time", "x", "y", "theta", "velocity", "yaw_rate")
READERS = {
    len(ENCODER_COLUMNS): Text("an encoder log: use read_encoder_log", "エンコーダのログ。read_encoder_logで読めます"),
    len(IMU_COLUMNS): Text("an IMU log: use read_imu_log", "IMUのログ。read_imu_logで読めます"),
    len(TRUTH_COLUMNS): Text("a truth file: use read_truth", "真値のファイル。read_truthで読めます"),
}

REPOSITORY_DATA = Path(__file__).resolve().parents[1] / "data"
"""The data folder of a full clone, beside the package."""

MISSING = Text(
    "{path}: there is no such file. Is the name spelt right, and is the path seen from the folder you work in?",
    "{path}: ファイルがありません。名前のつづりと、作業フォルダから見たパスを確かめてください。",
)
FOLDER = Text(
    "{path} is a folder, not a log. Add the name of a file in it.",
    "{path}はフォルダで、ログではありません。中のファイル名まで書いてください。",
)
NOT_IN_DATA = Text(
    "There is no log {name!r} in a data folder here or above. {listing}",
    "{name!r}というログは、ここから上のどのdataフォルダにもありません。{listing}",
)
LISTING = Text("There are: {names}.", "あるログ: {names}。")
NO_LISTING = Text("No data folder with logs was found.", "ログの入ったdataフォルダが見つかりません。")
NO_ROWS = Text(
    "{path} holds no data: expected rows of {expected} values ({names}), found {found}.",
    "{path}にデータの行がありません。{expected}個の値({names})の行が必要ですが、{found}でした。",
)
EMPTY = Text("an empty file", "空のファイル")
ONLY_COMMENTS = Text("blank lines and comments only", "空行とコメント行だけ")

LINE = Text("{path}, line {number}: {problem}", "{path}の{number}行目: {problem}")
NOT_UTF8 = Text(
    "found the byte 0x{byte:02x}, which is not UTF-8 text; expected a text file saved as UTF-8.",
    "バイト0x{byte:02x}はUTF-8の文字ではありません。UTF-8で保存したテキストファイルが必要です。",
)
WRONG_COUNT = Text(
    "found {found} value(s) in {line!r}; expected {expected} ({names}).{hint}",
    "値が{found}個です({line!r})。{expected}個の値({names})が必要です。{hint}",
)
CUT_OFF = Text(
    " The file ends in the middle of this line: it seems to be cut off.",
    "ファイルがこの行の途中で終わっています。書き込みが途中で切れたようです。",
)
OTHER_KIND = Text(" That many values belong to {reader}.", "この個数の値なら{reader}。")
NOTHING = Text("", "")
NOT_A_NUMBER = Text(
    "found {value!r} in column {column} ({name}); expected a number.",
    "{column}列目({name})が{value!r}です。数値が必要です。",
)
NO_VALUE = Text(
    "found nothing in column {column} ({name}); expected a number.",
    "{column}列目({name})が空です。数値が必要です。",
)
NOT_FINITE = Text(
    "found {value!r} in column {column} ({name}); expected a finite number.",
    "{column}列目({name})が{value!r}です。有限の数値が必要です。",
)

SEPARATOR = re.compile(r"\s*,\s*|\s+")
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
NO_FINITE_NUMBER = re.compile(r"[+-]?(nan|inf|infinity)", re.ASCII | re.IGNORECASE)
EXCERPT = 60


class LogError(ValueError):
    """A log that cannot be read; the message names file, line, what was found and what was expected."""


def read_encoder_log(path: str | os.PathLike[str]) -> Log:
    """Return the columns of an encoder log: time, counter1, counter2, pwm1, pwm2, each (N,) float64.

    Time [s] is as in the file, often Unix time; the counters are increments since the row before [counts]; the PWM
    columns are not used in the course. Time running back is not an error here.

    Raises LogError, a ValueError, for a row that does not hold five finite numbers, for a file without rows and for
    one that is not UTF-8 text; FileNotFoundError and IsADirectoryError for a path that leads to no file.

    Source: slides 000, practical training with wheel odometry (data format).
    """
    return _columns(_table(Path(path), ENCODER_COLUMNS), ENCODER_COLUMNS)


def read_imu_log(path: str | os.PathLike[str]) -> Log:
    """Return an IMU log: time (N,), gyro (N, 3), accel (N, 3), other (N, 3), temperature (N,), all float64.

    Time [s] is as in the file, gyro in rad/s, accel in g as logged, other is the magnetometer [uT], temperature in
    degrees Celsius. Errors are those of `read_encoder_log`, with eleven numbers to a row.

    Source: slides 000, practical training with the IMU (data format).
    """
    table = _table(Path(path), IMU_COLUMNS)
    return {
        "time": table[:, 0].copy(),
        "gyro": table[:, 1:4].copy(),
        "accel": table[:, 4:7].copy(),
        "other": table[:, 7:10].copy(),
        "temperature": table[:, 10].copy(),
    }


def read_truth(path: str | os.PathLike[str]) -> Log:
    """Return the truth beside a simulated log: time, x, y, theta, velocity, yaw_rate, each (N,) float64.

    Units are s, m, m, rad, m/s and rad/s; `course.simulate` says in which convention. Errors are those of
    `read_encoder_log`, with six numbers to a row.
    """
    return _columns(_table(Path(path), TRUTH_COLUMNS), TRUTH_COLUMNS)


def data_path(name: str) -> Path:
    """Return the path of the log `name`, such as "encoder_straight_5m.dat", wherever the notebook is.

    It is looked for in the `data` folders of the working directory and of every folder above it, nearest first,
    then in the repository that holds this package.

    Raises FileNotFoundError, with the names of the logs that do exist.
    """
    here = Path.cwd()
    folders = [folder / "data" for folder in (here, *here.parents)] + [REPOSITORY_DATA]
    for folder in folders:
        if (folder / name).is_file():
            return folder / name
    names = ", ".join(next(filter(None, map(_log_names, folders)), []))
    listing = LISTING.format(names=names) if names else NO_LISTING
    raise FileNotFoundError(_both(NOT_IN_DATA.format(name=name, listing=listing)))


def _log_names(folder: Path) -> list[str]:
    return sorted(file.name for file in folder.glob("*.dat"))


def _columns(table: FloatArray, names: tuple[str, ...]) -> Log:
    return {name: table[:, index].copy() for index, name in enumerate(names)}


class _Rows(NamedTuple):
    """The rows of a log: their numbers in the file, among all its lines, and the columns that they should have."""

    path: Path
    lines: list[str]
    numbers: list[int]
    names: tuple[str, ...]


def _table(path: Path, names: tuple[str, ...]) -> FloatArray:
    text = _text(path)
    lines = text.split("\n")
    numbers = [number for number, line in enumerate(lines, 1) if (stripped := line.strip()) and stripped[0] != "#"]
    if not numbers:
        raise _no_rows(path, names, ONLY_COMMENTS if text else EMPTY)
    rows = _Rows(path, lines, numbers, names)
    table = _quick_table(rows)
    # Line by line is several times slower, so only a file that needs it pays: one with an error, or mixed separators.
    return np.array([_row(rows, number) for number in numbers]) if table is None else table


def _text(path: Path) -> str:
    if path.is_dir():
        raise IsADirectoryError(_both(FOLDER.format(path=path)))
    try:
        data = path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        raise FileNotFoundError(_both(MISSING.format(path=path))) from None
    data = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    try:
        return data.decode("utf-8").removeprefix("\N{ZERO WIDTH NO-BREAK SPACE}")
    except UnicodeDecodeError as error:
        number = data.count(b"\n", 0, error.start) + 1
        raise _bad_line(path, number, NOT_UTF8.format(byte=data[error.start])) from None


def _quick_table(rows: _Rows) -> FloatArray | None:
    """Return all rows at once, or None if one of them needs a closer look."""
    lines = [rows.lines[number - 1] for number in rows.numbers]
    try:
        table = np.loadtxt(lines, delimiter="," if "," in lines[0] else None, comments=None, ndmin=2)
    except ValueError:
        return None
    return table if table.shape[1] == len(rows.names) and np.isfinite(table).all() else None


def _row(rows: _Rows, number: int) -> list[float]:
    line = rows.lines[number - 1].strip()
    fields = SEPARATOR.split(line)
    if len(fields) != len(rows.names):
        excerpt = line if len(line) <= EXCERPT else line[:EXCERPT] + "..."
        wanted = {"expected": len(rows.names), "names": ", ".join(rows.names)}
        hint = _count_hint(rows, number, len(fields))
        raise _bad_line(rows.path, number, WRONG_COUNT.format(found=len(fields), line=excerpt, hint=hint, **wanted))
    for column, (field, name) in enumerate(zip(fields, rows.names, strict=True), 1):
        problem = _problem(field)
        if problem:
            raise _bad_line(rows.path, number, problem.format(value=field[:EXCERPT], column=column, name=name))
    return [float(field) for field in fields]


def _count_hint(rows: _Rows, number: int, found: int) -> Text:
    if number == rows.numbers[0] and found in READERS:
        return OTHER_KIND.format(reader=READERS[found])
    # A file that ends with a line end has an empty last line, so a row on the last line has none.
    return CUT_OFF if number == len(rows.lines) and found < len(rows.names) else NOTHING


def _problem(field: str) -> Text | None:
    if not field:
        return NO_VALUE
    if NO_FINITE_NUMBER.fullmatch(field):
        return NOT_FINITE
    if not NUMBER.fullmatch(field):
        return NOT_A_NUMBER
    return None if math.isfinite(float(field)) else NOT_FINITE


def _no_rows(path: Path, names: tuple[str, ...], found: Text) -> LogError:
    return LogError(_both(NO_ROWS.format(path=path, expected=len(names), names=", ".join(names), found=found)))


def _bad_line(path: Path, number: int, problem: Text) -> LogError:
    return LogError(_both(LINE.format(path=path, number=number, problem=problem)))


def _both(text: Text) -> str:
    return f"{text.en}\n{text.ja}"
