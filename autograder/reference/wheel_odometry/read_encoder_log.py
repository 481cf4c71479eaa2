"""read_encoder_log(path): the columns of a log in the slides' format, or an error that names the line (slides 000, practical training)."""

import math
import re

import numpy as np

from autograder.exercise import Exercise, Group, Mistake
from course.given import built_file
from course.language import Text
from course.tolerances import STAMPS, RecordTolerance, Tolerance

NAMES = ("time", "counter1", "counter2", "pwm1", "pwm2")
HEADER = "# Time [s], Encoder Counter1 (incremental difference), Encoder Counter2 (incremental difference), PWM1, PWM2"
BOM = b"\xef\xbb\xbf"
NUMBER = re.compile(r"[+-]?\d+(\.\d*)?(e[+-]?\d+)?", re.ASCII | re.IGNORECASE)


def reference(path):
    """Return the columns by name; a line that is no row of five numbers is refused with its number."""
    columns = {name: [] for name in NAMES}
    for number, line in enumerate(path.read_bytes().removeprefix(BOM).decode().split("\n"), start=1):
        fields = re.findall(r"[^\s,]+", line)
        if not fields or fields[0][0] == "#":
            continue
        if len(fields) != len(NAMES) or not all(map(NUMBER.fullmatch, fields)):
            raise ValueError(number)
        for column, field in zip(columns.values(), fields, strict=True):
            column.append(float(field))
    if not columns["time"]:
        raise ValueError
    return {name: np.array(column) for name, column in columns.items()}


def cases(rng):
    """Draw small files of every kind that is to be read or refused.

    Where a line is to be refused its number has two digits, and no number in the rows is like it or its neighbours: messages
    may quote the line.
    """

    def rows(count):
        time = rng.uniform(1.6e9, 1.8e9) + rng.uniform(0.004, 0.9, count).cumsum()
        counters = rng.integers(100, 900, (count, 2)) * rng.choice([-1, 1], (count, 2))
        pwm = rng.integers(100, 900, (count, 2))
        return [(f"{t:.6f}", str(a), str(b), str(c), str(d)) for t, (a, b), (c, d) in zip(time, counters, pwm, strict=True)]

    def lines(count, separator=",", comments=()):
        """Return the lines of a file, `comments` scattered among its rows, the first one above them."""
        made = [separator.join(row) for row in rows(count)]
        for index, comment in enumerate(comments):
            made.insert(rng.integers(1, len(made)) if index else 0, comment)
        return made

    def file(made, end="\n", last=None):
        return (built_file(end.join([*made, ""] if last is None else made).encode()),)

    def refused(spoil):
        """Return a file in which one row, far down and behind comments, blank lines and other rows, is spoilt."""
        top = [HEADER, *rng.permutation(["", "#", "# log", " ", "", "", ""]).tolist()]
        made = [",".join(row) for row in rows(8)]
        made[2:2] = rng.permutation(["", "# turn", "  # left"]).tolist()
        bad = rng.integers(6, 9)
        fields = made[bad].split(",")
        spoil(fields)
        made[bad] = ",".join(fields)
        return file(top + made)

    def without(fields):
        del fields[rng.integers(1, 5)]

    def with_another(fields):
        fields.insert(rng.integers(1, 5), "300")

    def text_for_one(text, column=None):
        return lambda fields: fields.__setitem__(rng.integers(1, 5) if column is None else column, text)

    notes = ["# 777,777,777,777,777", "", "  # turn left", "   ", "\t", "#"]
    odd = [("0.0", "0", "-0", "0", "0"), ("0.25", "-1.25e2", "+3", "2E1", "-0.5"), ("0.5", "7.", "-130", "1e-2", "12")]
    shuffled = rng.permutation(["nan", "NaN"]).tolist(), rng.permutation(["inf", "-inf", "Infinity"]).tolist()
    return [
        Group(Text("commas", "コンマ区切り"), 2, [file([HEADER, *lines(4)]), file(lines(5, ", "))]),
        Group(
            Text("blanks and tabs", "空白とタブ区切り"),
            2,
            [file([HEADER, *lines(3, " ")]), file(lines(3, "   ")), file(lines(4, "\t"))],
        ),
        Group(
            Text("comments and blank lines anywhere", "途中のコメントと空行"),
            2,
            [file([*lines(6, ",", [HEADER, *rng.permutation(notes)]), "", "# end"])],
        ),
        Group(
            Text("a byte-order mark", "BOM付き"),
            1,
            [(built_file(BOM + "\n".join([*head, *lines(3), ""]).encode()),) for head in ([HEADER], [])],
        ),
        Group(Text("line ends of Windows", "Windowsの改行"), 1, [file([HEADER, *lines(4), ""], "\r\n")]),
        Group(Text("one row", "1行だけ"), 1, [file([HEADER, *lines(1)], last=""), file(lines(1, " "))]),
        Group(Text("signs, decimals and exponents", "符号・小数・指数"), 1, [file([",".join(row) for row in odd])]),
        Group(Text("too few or too many columns", "列の過不足"), 2, [refused(without), refused(with_another)]),
        Group(
            Text("text in a number", "数値でない文字"),
            1,
            [refused(text_for_one(rng.choice(["abc", "--", "12O"]))), refused(text_for_one("x", 0))],
        ),
        Group(Text("nan and inf", "nanとinf"), 1, [refused(text_for_one(kind[0])) for kind in shuffled]),
        Group(Text("no data", "データなし"), 1, [file([], last=""), file([HEADER, "", "# nothing"])]),
    ]


EXAMPLE = (
    f"{HEADER}\n1713147300.25, 0, 0, 0, 0\n1713147300.255, 12, -11, 20, -20\n\n# turn left\n1713147300.26, 13, -9, 20, -18\n"
)
EXAMPLE_BLANKS = "# t c1 c2 p1 p2\n0.5 3 -4 10 -10\n"
EXAMPLE_CUT = "# Time [s], Counter1, Counter2, PWM1, PWM2\n0.0, 0, 0, 0, 0\n\n0.1, 120, -1\n"


def commas_only(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.split(",")]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def blanks_only(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def single_blanks_only(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.strip().replace(",", " ").split(" ")]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def commas_or_single_blanks(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [
                float(field)
                for field in " ".join(part for part in line.strip("\n").replace(",", " ").split(" ") if part).split(" ")
            ]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def first_line_skipped(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if number == 1 or not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def comments_only_at_the_top(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or (not rows and line.strip().startswith("#")):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def comments_after_blanks_not_seen(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def blank_lines_taken_for_rows(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def lines_of_blanks_taken_for_rows(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if line in ("\n", "") or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def comments_not_known(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip():
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def mark_of_byte_order_not_removed(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def last_character_cut_off(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line[:-1].replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def line_number_from_zero(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=0):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def line_number_one_too_large(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=2):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def rows_counted_for_lines(path):
    rows = []
    for line in path.read_text(encoding="utf-8-sig").splitlines(keepends=True):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"row {len(rows) + 1}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"row {len(rows) + 1}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def rows_counted_from_zero(path):
    rows = []
    for line in path.read_text(encoding="utf-8-sig").splitlines(keepends=True):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"row {len(rows)}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"row {len(rows)}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def blank_lines_not_counted(path):
    rows = []
    for number, line in enumerate(filter(str.strip, path.read_text(encoding="utf-8-sig").splitlines(keepends=True)), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def comments_not_counted(path):
    rows = []
    for number, line in enumerate(
        (s for s in path.read_text(encoding="utf-8-sig").splitlines(keepends=True) if not s.strip().startswith("#")), start=1
    ):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def no_line_named(path):
    rows = []
    for line in path.read_text(encoding="utf-8-sig").splitlines(keepends=True):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError("bad line") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError("bad line")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def assertion_raised(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise AssertionError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise AssertionError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def bad_lines_skipped(path):
    rows = []
    for line in path.read_text(encoding="utf-8-sig").splitlines(keepends=True):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            continue
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            continue
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def stops_at_a_bad_line(path):
    rows = []
    for line in path.read_text(encoding="utf-8-sig").splitlines(keepends=True):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            break
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            break
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def missing_columns_filled_with_zeros(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
            row += [0.0] * (5 - len(row))
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def missing_columns_filled_with_nan(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
            row += [math.nan] * (5 - len(row))
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or any(math.isinf(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def further_columns_ignored(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()][:5]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def number_of_columns_not_checked(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(
        zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array([(row + [0.0] * 5)[:5] for row in rows]).T, strict=True)
    )


def nan_and_inf_accepted(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5:
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def inf_accepted(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or any(math.isnan(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def nan_accepted(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or any(abs(value) == math.inf for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def text_read_as_nan(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            row = [
                float(field) if field.lstrip("+-")[:1].isdigit() and field[-1] != "O" else math.nan
                for field in line.replace(",", " ").split()
            ]
            rows.append(row)
            continue
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def text_read_as_zero(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            row = [
                float(field) if field.lstrip("+-")[:1].isdigit() and field[-1] != "O" else 0.0
                for field in line.replace(",", " ").split()
            ]
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def empty_file_accepted(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).reshape(-1, 5).T, strict=True))


def empty_file_gives_none(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        return None
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def empty_file_ends_in_an_index_error(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise IndexError("too many indices for array")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def one_row_gives_numbers(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.squeeze(np.array(rows).T), strict=True))


def time_from_zero(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    table = np.array(rows)
    table[:, 0] -= table[0, 0]
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), table.T, strict=True))


def stamps_in_float32(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows, dtype=np.float32).T, strict=True))


def whole_counters(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    table = np.array(rows)
    return {"time": table[:, 0], **dict(zip(("counter1", "counter2", "pwm1", "pwm2"), table[:, 1:].astype(int).T, strict=True))}


def all_cut_to_whole_numbers(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).astype(int).T, strict=True))


def counters_and_pwm_exchanged(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "pwm1", "pwm2", "counter1", "counter2"), np.array(rows).T, strict=True))


def columns_by_motor(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "pwm1", "counter2", "pwm2"), np.array(rows).T, strict=True))


def counters_exchanged(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter2", "counter1", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def counters_without_sign(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [abs(float(field)) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True))


def counters_summed_up(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    table = np.array(rows)
    table[:, 1:3] = np.cumsum(table[:, 1:3], axis=0)
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), table.T, strict=True))


def first_row_lost(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows)[1:].T, strict=True))


def last_row_lost(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows)[:-1].T, strict=True))


def table_for_dict(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return np.array(rows)


def columns_for_dict(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return tuple(np.array(rows).T)


def rows_as_dicts(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return [dict(zip(("time", "counter1", "counter2", "pwm1", "pwm2"), row, strict=True)) for row in rows]


def texts_for_numbers(path):
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(keepends=True), start=1):
        if not line.strip() or line.strip().startswith("#"):
            continue
        try:
            row = [float(field) for field in line.replace(",", " ").split()]
        except ValueError:
            raise ValueError(f"line {number}") from None
        if len(row) != 5 or not all(math.isfinite(value) for value in row):
            raise ValueError(f"line {number}")
        rows.append(row)
    if not rows:
        raise ValueError("no data")
    return {
        name: [str(value) for value in column]
        for name, column in zip(("time", "counter1", "counter2", "pwm1", "pwm2"), np.array(rows).T, strict=True)
    }


EXERCISE = Exercise(
    name="read_encoder_log",
    notebook="odometry/wheel_odometry",
    points=10,
    parameters=("path",),
    reference=reference,
    cases=cases,
    examples=tuple((built_file(content.encode()),) for content in (EXAMPLE, EXAMPLE_BLANKS, EXAMPLE_CUT)),
    tolerance=RecordTolerance(
        (
            ("time", Tolerance(absolute=STAMPS.absolute, relative=0.0, double=True)),
            *((name, Tolerance(double=True)) for name in NAMES[1:]),
        )
    ),
    quantities=NAMES,
    refuses=(ValueError,),
    mistakes=(
        Mistake(
            commas_only,
            Text(
                "Only commas separate the columns here. Files with blanks or tabs between the values are logs too: look at what separates the values before you split.",
                "コンマ区切りしか読めません。空白やタブで区切ったログもあります。値を分ける文字が何かを、分ける前に確かめましょう。",
            ),
        ),
        Mistake(
            blanks_only,
            Text(
                "Only white space separates the columns here, so that a file with commas is refused. The slides' logs have commas: allow both.",
                "空白区切りしか読めず、コンマ区切りのファイルがエラーになります。スライドのログはコンマ区切りです。両方を読めるようにしましょう。",
            ),
        ),
        Mistake(
            single_blanks_only,
            Text(
                "The line is split at every single blank. Two blanks in a row, or a tab, then give empty or joined fields: split() without an argument takes any amount of white space.",
                "空白1個ごとに分けています。空白が続いたりタブがあったりすると、空の欄やつながった欄ができます。引数なしのsplit()なら空白がいくつあってもかまいません。",
            ),
        ),
        Mistake(
            commas_or_single_blanks,
            Text(
                "Tabs do not separate the columns here. White space means tabs too.",
                "タブ区切りが読めません。空白類にはタブも含まれます。",
            ),
        ),
        Mistake(
            first_line_skipped,
            Text(
                "The first line is skipped whatever it holds. Some logs have no header: then the first row is lost. Skip a line because it begins with #, not because of its place.",
                "1行目を内容によらず飛ばしています。ヘッダのないログでは最初のデータが失われます。位置ではなく、#で始まるかどうかで判断しましょう。",
            ),
        ),
        Mistake(
            comments_only_at_the_top,
            Text(
                "Comments are skipped at the top of the file only. A line that begins with # may stand anywhere, between rows and at the end too.",
                "コメントを読み飛ばすのがファイルの先頭だけです。#で始まる行は、データの間や末尾にもあります。",
            ),
        ),
        Mistake(
            comments_after_blanks_not_seen,
            Text(
                "A comment that is indented is taken for a row. There may be blanks before the #: strip the line first.",
                "字下げしたコメントをデータとみなしています。#の前に空白があることもあるので、先にstripしましょう。",
            ),
        ),
        Mistake(
            blank_lines_taken_for_rows,
            Text(
                "A blank line is taken for a row and refused. Blank lines may stand anywhere: skip them.",
                "空行をデータとみなしてエラーにしています。空行はどこにあってもよいので、読み飛ばしましょう。",
            ),
        ),
        Mistake(
            lines_of_blanks_taken_for_rows,
            Text(
                "A line that holds only blanks or a tab is taken for a row and refused. It is a blank line too: strip it before you look.",
                "空白やタブだけの行をデータとみなしてエラーにしています。これも空行です。stripしてから調べましょう。",
            ),
        ),
        Mistake(
            comments_not_known,
            Text(
                "Lines that begin with # are taken for rows. They are comments: skip them, wherever they stand.",
                "#で始まる行をデータとみなしています。コメントなので、どこにあっても読み飛ばしましょう。",
            ),
        ),
        Mistake(
            mark_of_byte_order_not_removed,
            Text(
                "A file with a byte-order mark is not read. Editors of Windows put this invisible character in front: the encoding utf-8-sig takes it away.",
                "BOM付きのファイルが読めません。Windowsのエディタは先頭に見えない文字を付けることがあります。encodingをutf-8-sigにすると取り除けます。",
            ),
        ),
        Mistake(
            last_character_cut_off,
            Text(
                "The last character of each line is cut off. That is meant for the line end, but the last line may have none, and then a digit is lost: use strip().",
                "各行の最後の1文字を切り落としています。改行のつもりでも、最終行に改行がなければ数字が消えます。strip()を使いましょう。",
            ),
        ),
        Mistake(
            line_number_from_zero,
            Text(
                "The lines are counted from 0, so that the number in the message is one too small. An editor counts them from 1.",
                "行を0から数えているので、メッセージの行番号が1小さくなっています。エディタと同じく1から数えましょう。",
            ),
        ),
        Mistake(
            line_number_one_too_large,
            Text(
                "The number in the message is one too large: it seems that enumerate starts at 1 and 1 is added once more.",
                "メッセージの行番号が1大きくなっています。enumerateを1から始めたうえに、さらに1を足していませんか。",
            ),
        ),
        Mistake(
            rows_counted_for_lines,
            Text(
                "The number in the message counts the rows of data. A reader looks for the line in the file, where comments and blank lines count too.",
                "メッセージの番号がデータ行だけを数えたものです。読む人はファイルの行を探すので、コメントや空行も数えましょう。",
            ),
        ),
        Mistake(
            rows_counted_from_zero,
            Text(
                "The number in the message counts the rows of data, from 0. A reader looks for the line in the file, counted from 1, comments and blank lines included.",
                "メッセージの番号がデータ行だけを0から数えたものです。コメントや空行も含め、ファイルの行を1から数えましょう。",
            ),
        ),
        Mistake(
            blank_lines_not_counted,
            Text(
                "The number in the message leaves out the blank lines. Every line of the file counts.",
                "メッセージの行番号に空行が数えられていません。ファイルのすべての行を数えましょう。",
            ),
        ),
        Mistake(
            comments_not_counted,
            Text(
                "The number in the message leaves out the comments. Every line of the file counts.",
                "メッセージの行番号にコメント行が数えられていません。ファイルのすべての行を数えましょう。",
            ),
        ),
        Mistake(
            no_line_named,
            Text(
                "The ValueError does not name the line that is wrong. With 20000 lines a reader needs its number: count the lines while you read, and put the number into the message.",
                "ValueErrorのメッセージに、誤りのある行の番号がありません。2万行のファイルから探せるよう、行を数えながら読み、番号をメッセージに入れましょう。",
            ),
        ),
        Mistake(
            assertion_raised,
            Text(
                "A bad line ends in an AssertionError. assert is for one's own mistakes; for a file that cannot be used raise ValueError.",
                "不正な行でAssertionErrorになります。assertは自分の間違いを見つけるためのものです。使えないファイルにはValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            bad_lines_skipped,
            Text(
                "Lines that are no rows are silently left out. A gap in the log then looks like a jump of the robot: raise ValueError with the number of the line.",
                "不正な行を黙って読み飛ばしています。抜けたデータはロボットの跳躍に見えてしまいます。行番号を付けてValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            stops_at_a_bad_line,
            Text(
                "Reading ends at the first bad line, and what came before is returned as if it were all. Raise ValueError with the number of the line.",
                "不正な行で読むのをやめ、それまでの分を全体のように返しています。行番号を付けてValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            missing_columns_filled_with_zeros,
            Text(
                "A line with too few values is filled up with zeros. Nobody knows which value is missing: refuse it.",
                "値の足りない行を0で埋めています。どの値が欠けたのかは分からないので、エラーにしましょう。",
            ),
        ),
        Mistake(
            missing_columns_filled_with_nan,
            Text(
                "A line with too few values is filled up with NaN. It then spoils every pose after it: refuse it.",
                "値の足りない行をNaNで埋めています。その後の姿勢がすべて使えなくなるので、エラーにしましょう。",
            ),
        ),
        Mistake(
            further_columns_ignored,
            Text(
                "A line with too many values is cut off after five. Which of them are right nobody knows: refuse it.",
                "値の多い行を5個で打ち切っています。どれが正しい値かは分からないので、エラーにしましょう。",
            ),
        ),
        Mistake(
            number_of_columns_not_checked,
            Text(
                "A line with too few or too many values ends in the wrong error, or in none. Compare the number of columns with 5 in each line.",
                "列が足りない、または多い行で、別のエラーになるか、エラーになりません。行ごとに列の数が5かどうか調べましょう。",
            ),
        ),
        Mistake(
            nan_and_inf_accepted,
            Text(
                "nan and inf are read as numbers: float() takes both. One NaN makes every later pose NaN; refuse what is not finite.",
                "nanやinfを数値として読んでいます。float()はどちらも受け付けます。NaNが1つでもあると以後の姿勢がすべてNaNになるので、有限でない値はエラーにしましょう。",
            ),
        ),
        Mistake(
            inf_accepted,
            Text(
                "nan is refused, but inf is read as a number. math.isfinite and np.isfinite are False for both.",
                "nanはエラーにしていますが、infを数値として読んでいます。math.isfiniteやnp.isfiniteなら両方を見分けられます。",
            ),
        ),
        Mistake(
            nan_accepted,
            Text(
                "inf is refused, but nan is read as a number. Comparisons with NaN are False; math.isfinite and np.isfinite see both.",
                "infはエラーにしていますが、nanを数値として読んでいます。NaNとの比較は偽になります。math.isfiniteやnp.isfiniteなら両方を見分けられます。",
            ),
        ),
        Mistake(
            text_read_as_nan,
            Text(
                "Text in a number becomes NaN, as with genfromtxt, instead of an error. Raise ValueError with the number of the line.",
                "数値でない文字が、genfromtxtのようにNaNになっています。行番号を付けてValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            text_read_as_zero,
            Text(
                "Text in a number becomes 0 instead of an error. A wheel that seems to stand still for a moment bends the path: raise ValueError with the number of the line.",
                "数値でない文字を0にしています。一瞬止まったように見えて経路が曲がります。行番号を付けてValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            empty_file_accepted,
            Text(
                "A file without rows gives empty arrays. Nothing can be computed from them: raise ValueError.",
                "データの行がないファイルで空の配列が返っています。これでは何も計算できないので、ValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            empty_file_gives_none,
            Text(
                "A file without rows gives None. Raise ValueError, so that whoever calls the function notices.",
                "データの行がないファイルでNoneが返っています。呼び出した側が気づけるよう、ValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            empty_file_ends_in_an_index_error,
            Text(
                "A file without rows ends in an IndexError, where a column of nothing is taken. Look whether there are rows, and raise ValueError if not.",
                "データの行がないファイルでは、空の表から列を取ろうとしてIndexErrorになります。行があるか調べ、なければValueErrorをraiseしましょう。",
            ),
        ),
        Mistake(
            one_row_gives_numbers,
            Text(
                "A log of one row gives numbers instead of arrays of length 1, as np.loadtxt and np.squeeze do. np.loadtxt(..., ndmin=2) or np.atleast_2d keeps the table a table.",
                "1行だけのログで、長さ1の配列ではなく数値が返っています。np.loadtxtやnp.squeezeではそうなります。ndmin=2やnp.atleast_2dで表の形を保ちましょう。",
            ),
        ),
        Mistake(
            time_from_zero,
            Text(
                "The first stamp is subtracted from time. A reader gives time as it is in the file; the program subtracts later.",
                "timeから最初の時刻を引いています。読み込む関数はファイルの時刻をそのまま返し、引くのは後のプログラムで行います。",
            ),
        ),
        Mistake(
            stamps_in_float32,
            Text(
                "The numbers are float32. It has seven digits, and Unix seconds with microseconds need sixteen: take float64, NumPy's default.",
                "数値がfloat32になっています。有効桁数は7桁ですが、マイクロ秒までのUnix時間には16桁必要です。NumPyの標準のfloat64を使いましょう。",
            ),
        ),
        Mistake(
            whole_counters,
            Text(
                "The counters and PWM are arrays of whole numbers. All five columns are to be float64, so that later divisions and NaN work alike.",
                "カウンタとPWMが整数の配列になっています。後の計算で同じように扱えるよう、5列ともfloat64にしましょう。",
            ),
        ),
        Mistake(
            all_cut_to_whole_numbers,
            Text(
                "All numbers are cut to whole ones, the time too. Stamps are milliseconds apart: float64 is needed.",
                "時刻も含めてすべて整数に切り捨てています。時刻の間隔はミリ秒なので、float64が必要です。",
            ),
        ),
        Mistake(
            counters_and_pwm_exchanged,
            Text(
                "The columns are exchanged: the second and third are counter1 and counter2, the fourth and fifth the PWM values.",
                "列が入れ替わっています。2列目と3列目がcounter1とcounter2、4列目と5列目がPWMです。",
            ),
        ),
        Mistake(
            columns_by_motor,
            Text(
                "The columns are taken by motor: counter, PWM, counter, PWM. The file has both counters first, then both PWM values.",
                "列をモータごと(カウンタ、PWM、カウンタ、PWM)に読んでいます。ファイルではカウンタが2列、続いてPWMが2列です。",
            ),
        ),
        Mistake(
            counters_exchanged,
            Text(
                "counter1 and counter2 are exchanged. counter1 is the second column of the file.",
                "counter1とcounter2が入れ替わっています。counter1はファイルの2列目です。",
            ),
        ),
        Mistake(
            counters_without_sign,
            Text(
                "The counters have lost their signs. A wheel that turns back has negative increments.",
                "カウンタの符号が失われています。逆に回る車輪の増分は負です。",
            ),
        ),
        Mistake(
            counters_summed_up,
            Text(
                "The counters are summed up. The reader gives what is in the file: increments.",
                "カウンタを累積しています。読み込む関数はファイルの値(増分)をそのまま返します。",
            ),
        ),
        Mistake(
            first_row_lost,
            Text(
                "The first row of data is missing: it seems to be taken for a header.",
                "最初のデータ行がありません。ヘッダとみなしていませんか。",
            ),
        ),
        Mistake(
            last_row_lost,
            Text(
                "The last row of data is missing. Where does the loop end?",
                "最後のデータ行がありません。ループはどこで終わっていますか。",
            ),
        ),
        Mistake(
            table_for_dict,
            Text(
                "A table of all rows comes back. Asked for is a dict, so that the columns have names: time, counter1, counter2, pwm1, pwm2.",
                "全行の表が返っています。time、counter1、counter2、pwm1、pwm2という名前の付いたdictを返しましょう。",
            ),
        ),
        Mistake(
            columns_for_dict,
            Text(
                "The columns come back without names. Asked for is a dict: time, counter1, counter2, pwm1, pwm2.",
                "列が名前なしで返っています。time、counter1、counter2、pwm1、pwm2を項目とするdictを返しましょう。",
            ),
        ),
        Mistake(
            rows_as_dicts,
            Text(
                "A list with a dict for each row comes back. Asked for is the other way round: one dict with an array for each column.",
                "行ごとのdictのリストが返っています。逆に、列ごとの配列をもつdictを1つ返しましょう。",
            ),
        ),
        Mistake(
            texts_for_numbers,
            Text(
                "The values are still text. Arithmetic needs numbers: float() of each field.",
                "値が文字列のままです。計算できるように、各欄をfloat()で数値にしましょう。",
            ),
        ),
    ),
)
