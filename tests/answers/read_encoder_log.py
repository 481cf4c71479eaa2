"""Answers to read_encoder_log(path): right ones in honest styles, wrong ones as students write them."""

import csv
import io
import math
import re

import numpy as np

NAMES = ("time", "counter1", "counter2", "pwm1", "pwm2")


def by_columns(path):
    columns = [[], [], [], [], []]
    with open(path, encoding="utf-8-sig") as file:
        for number, line in enumerate(file, 1):
            fields = line.split("#")[0].replace(",", " ").split()
            if not fields:
                continue
            if len(fields) != 5:
                raise ValueError(f"{len(fields)} columns in line {number}")
            for column, field in zip(columns, fields, strict=True):
                try:
                    column.append(float(field))
                except ValueError as error:
                    raise ValueError(f"line {number}: {error}") from error
                if not math.isfinite(column[-1]):
                    raise ValueError(f"line {number}: {field}")
    if not columns[0]:
        raise ValueError("empty")
    return {name: np.array(column, dtype=np.float64) for name, column in zip(NAMES, columns, strict=True)}


def one_pattern(path):
    value = r"[+-]?\d+\.?\d*(?:[eE][+-]?\d+)?"
    row = re.compile(r"\s*" + r"[\s,]+".join([f"({value})"] * 5) + r"\s*")
    found = []
    for i, line in enumerate(path.read_text("utf-8-sig").split("\n")):
        if re.match(r"\s*(#|$)", line):
            continue
        match = row.fullmatch(line)
        if not match:
            raise ValueError(f"{i + 1}行目が読めません: {line!r}")
        found.append([float(text) for text in match.groups()])
    if not found:
        raise ValueError("データがありません")
    return dict(zip(NAMES, zip(*found, strict=True), strict=True))


class LogFileError(ValueError):
    def __init__(self, number):
        super().__init__(f"log file, line {number}: five finite numbers are needed")


def bytes_and_an_error_of_its_own(path):
    content = path.read_bytes()
    if content.startswith(b"\xef\xbb\xbf"):
        content = content[3:]
    table = []
    for number, raw in enumerate(content.split(b"\n"), start=1):
        line = raw.strip().replace(b",", b" ")
        if line[:1] in (b"", b"#"):
            continue
        try:
            values = np.array(line.split()).astype(float)
        except ValueError:
            raise LogFileError(number) from None
        if values.shape != (5,) or not np.all(np.isfinite(values)):
            raise LogFileError(number)
        table.append(values)
    if not table:
        raise LogFileError(0)
    table = np.vstack(table)
    return {name: table[:, k] for k, name in enumerate(NAMES)}


def loadtxt_after_looking(path):
    lines = path.read_text(encoding="utf-8-sig").splitlines()
    rows = {n: line.replace(",", " ") for n, line in enumerate(lines, 1) if line.strip() and line.strip()[0] != "#"}
    for n, line in rows.items():
        try:
            one = np.loadtxt(io.StringIO(line), ndmin=1, comments=None)
        except ValueError as error:
            raise ValueError(f"line {n}: {error}") from error
        if one.size != 5 or np.isnan(one).any() or np.isinf(one).any():
            raise ValueError(f"line {n}: {line}")
    if not rows:
        raise ValueError("no rows")
    print(len(rows), "rows")
    time, counter1, counter2, pwm1, pwm2 = np.loadtxt(list(rows.values()), ndmin=2, comments=None).T
    return {"time": time, "counter1": counter1, "counter2": counter2, "pwm1": pwm1, "pwm2": pwm2}


class Reader:
    """Keeps the line number while it reads."""

    def __call__(self, path):
        self.number = 0
        with path.open(encoding="utf-8-sig", newline=None) as self.file:
            rows = list(self.rows())
        if not rows:
            raise ValueError("the file holds no data")
        return {name: np.asarray(column) for name, column in zip(NAMES, np.transpose(rows), strict=True)}

    def rows(self):
        for line in self.file:
            self.number += 1
            fields = re.findall(r"[^\s,]+", line)
            if fields and not fields[0].startswith("#"):
                yield self.row(fields)

    def row(self, fields):
        try:
            time, *others = map(float, fields)
        except ValueError:
            raise ValueError(f"no number in line {self.number}") from None
        if len(others) != 4 or not math.isfinite(time + sum(others)):
            raise ValueError(f"not five finite numbers in line {self.number}")
        return [time, *others]


RIGHT = {
    "by columns": by_columns,
    "one pattern, tuples, Japanese": one_pattern,
    "bytes, error of its own": bytes_and_an_error_of_its_own,
    "loadtxt line by line, prints": loadtxt_after_looking,
    "object that keeps the line number": Reader(),
}


def read(path, *, fields=None, skipped=None, checked=True, numbers=lambda number, rows: number, encoding="utf-8-sig"):
    """Read a log with one thing changed."""
    fields = fields or (lambda line: line.replace(",", " ").split())
    skipped = skipped or (lambda number, line, rows: not line.strip() or line.strip()[0] == "#")
    rows = []
    with open(path, encoding=encoding) as file:
        for number, line in enumerate(file, 1):
            if skipped(number, line, rows):
                continue
            try:
                row = [float(field) for field in fields(line)]
            except ValueError:
                raise ValueError(f"line {numbers(number, rows)}: not a number") from None
            if len(row) != 5 or (checked and not all(map(math.isfinite, row))):
                raise ValueError(f"line {numbers(number, rows)}: bad row")
            rows.append(row)
    if not rows:
        raise ValueError("no data")
    return dict(zip(NAMES, np.array(rows).T, strict=True))


def commas(path):
    return read(path, fields=lambda line: line.split(","))


def blanks(path):
    return read(path, fields=str.split)


def comma_and_blank(path):
    return read(path, fields=lambda line: line.split(", "))


def semicolons_too_late(path):
    return read(path, fields=lambda line: line.strip().replace("\t", " ").replace(",", " ").split(" "))


def header_skipped_by_count(path):
    return read(path, skipped=lambda number, line, rows: number <= 1 or not line.strip())


def comments_at_the_beginning_of_the_line(path):
    return read(path, skipped=lambda number, line, rows: not line.strip() or line[0] == "#")


def blank_means_empty(path):
    return read(path, skipped=lambda number, line, rows: line == "\n" or line.strip()[:1] == "#")


def lines_that_begin_with_a_digit(path):
    return read(path, skipped=lambda number, line, rows: not line.strip()[:1].isdigit())


def short_lines_skipped(path):
    return read(path, skipped=lambda number, line, rows: len(line.replace(",", " ").split()) < 5 or line.strip()[0] == "#")


def nan_taken(path):
    return read(path, checked=False)


def rows_counted(path):
    return read(path, numbers=lambda number, rows: len(rows) + 1)


def lines_counted_from_zero(path):
    return read(path, numbers=lambda number, rows: number - 1)


def same_line_always(path):
    return read(path, numbers=lambda number, rows: 1)


def plain_utf_8(path):
    return read(path, encoding="utf-8")


def loadtxt_alone(path):
    table = np.loadtxt(path, delimiter=",", ndmin=2, encoding="utf-8-sig")
    return dict(zip(NAMES, table.T, strict=True))


def genfromtxt_alone(path):
    table = np.genfromtxt(path, delimiter=",", encoding="utf-8-sig", ndmin=2)
    return {name: table[:, k] for k, name in enumerate(NAMES)}


def csv_alone(path):
    with open(path, encoding="utf-8-sig", newline="") as file:
        rows = [[float(field) for field in row] for row in csv.reader(file) if row and not row[0].startswith("#")]
    return dict(zip(NAMES, np.array(rows).T, strict=True))


def changed(**entries):
    return lambda path: (log := read(path)) | {key: change(log) for key, change in entries.items()}


def as_rows(path):
    return list(zip(*read(path).values(), strict=True))


def exit_on_errors(path):
    try:
        return read(path)
    except ValueError as error:
        raise SystemExit(str(error)) from None


def errors_printed(path):
    try:
        return read(path)
    except ValueError as error:
        print(error)
        return None


def errors_as_text(path):
    try:
        return read(path)
    except ValueError as error:
        return str(error)


def missing_file_for_empty(path):
    try:
        return read(path)
    except ValueError as error:
        if "no data" in str(error):
            raise FileNotFoundError(path) from None
        raise


def file_emptied(path):
    log = read(path)
    return {**log, "pwm1": log["pwm1"] * 0}


WRONG = {
    "commas only": (commas, "blanks are refused", "plain"),
    "blanks only": (blanks, "commas are refused", "plain"),
    "comma and blank": (comma_and_blank, "only ', ' separates", "subtle"),
    "split at each blank": (semicolons_too_late, "two blanks make an empty field", "subtle"),
    "header by count": (header_skipped_by_count, "skiprows=1", "subtle"),
    "comments in column 0": (comments_at_the_beginning_of_the_line, "indented comments are rows", "subtle"),
    "blank means empty": (blank_means_empty, "lines of blanks are rows", "subtle"),
    "digits first": (lines_that_begin_with_a_digit, "text in the first column is skipped, so is a negative time", "subtle"),
    "short lines skipped": (short_lines_skipped, "cut lines are silently left out", "subtle"),
    "nan taken": (nan_taken, "float('nan')", "plain"),
    "rows counted": (rows_counted, "not the line in the file", "plain"),
    "lines from 0": (lines_counted_from_zero, "one too small", "plain"),
    "always line 1": (same_line_always, "number of the first line", "subtle"),
    "utf-8": (plain_utf_8, "BOM stays", "plain"),
    "loadtxt": (loadtxt_alone, "commas only, nan, rows for lines", "subtle"),
    "genfromtxt": (genfromtxt_alone, "NaN for text", "subtle"),
    "csv": (csv_alone, "no lines named", "subtle"),
    "float32": (changed(time=lambda log: log["time"].astype(np.float32)), "time in float32", "plain"),
    "from zero": (changed(time=lambda log: log["time"] - log["time"][0]), "first stamp subtracted", "plain"),
    "milliseconds": (changed(time=lambda log: 1000 * log["time"]), "time in ms", "plain"),
    "whole time": (changed(time=lambda log: np.floor(log["time"])), "int(float(...))", "subtle"),
    "whole counters": (changed(counter1=lambda log: log["counter1"].astype(int)), "integers", "plain"),
    "counters exchanged": (
        changed(counter1=lambda log: log["counter2"], counter2=lambda log: log["counter1"]),
        "1 and 2",
        "plain",
    ),
    "PWM for counters": (
        changed(counter1=lambda log: log["pwm1"], counter2=lambda log: log["pwm2"]),
        "columns 4 and 5",
        "subtle",
    ),
    "one row as numbers": (
        lambda path: {key: np.squeeze(values) for key, values in read(path).items()},
        "shape () for one row",
        "plain",
    ),
    "columns as (N, 1)": (lambda path: {key: values[:, None] for key, values in read(path).items()}, "shape (N, 1)", "plain"),
    "rows": (as_rows, "no dict", "plain"),
    "upper case": (lambda path: {key.title(): values for key, values in read(path).items()}, "other keys", "plain"),
    "exits": (exit_on_errors, "SystemExit", "plain"),
    "prints errors": (errors_printed, "None for bad files", "plain"),
    "errors as text": (errors_as_text, "a text for bad files", "plain"),
    "FileNotFoundError": (missing_file_for_empty, "for an empty file", "subtle"),
    "PWM left out": (file_emptied, "zeros for pwm1", "subtle"),
}
