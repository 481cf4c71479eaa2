"""Logs that went wrong, or that look odd and are fine: what a reader meets in a laboratory, with what it should say.

Each is made from the text of one short, clean log by a single change.
"""

from collections.abc import Callable
from dataclasses import dataclass

from course.language import Text

Change = Callable[[str], str]

SAME_ROWS = Text("reads it; the rows are those of the clean log", "読めます。値は元のログと同じです")


@dataclass(frozen=True)
class DirtyLog:
    """A log made from a clean one: `data/dirty/NAME.dat`.

    - `change`: makes its text from that of the clean log
    - `oddity`: what is odd about it
    - `refusal`: what `course.logs` says when it refuses it, with a place for the path; None if it is to be read
    - `reading`: what a reader makes of it that reads it
    """

    name: str
    change: Change
    oddity: Text
    refusal: Text | None = None
    reading: Text = SAME_ROWS


def _lines_changed(change: Callable[[int, str], str]) -> Change:
    """Return a change that gives each row's number in the file, from 1, and its text to `change`; comments stay."""

    def changed(text: str) -> str:
        lines = enumerate(text.splitlines(), 1)
        return "".join((line if line[0] == "#" else change(number, line)) + "\n" for number, line in lines)

    return changed


def _with_field(line: int, column: int, value: str) -> Change:
    """Return a change that puts `value` into one column, from 1, of one line."""

    def changed(number: int, row: str) -> str:
        fields = row.split(",")
        return ",".join([*fields[: column - 1], value, *fields[column:]]) if number == line else row

    return _lines_changed(changed)


def _with_clock_set_back(line: int, seconds: float) -> Change:
    """Return a change that makes all stamps from `line` on smaller."""

    def changed(number: int, row: str) -> str:
        time, rest = row.split(",", 1)
        return f"{float(time) - seconds:.6f},{rest}" if number >= line else row

    return _lines_changed(changed)


def _cut_off(text: str) -> str:
    return text[: text.rindex("\n", 0, -1)] + "\n" + text.splitlines()[-1][:10]


DIRTY_LOGS = (
    DirtyLog(
        name="missing_column",
        change=_lines_changed(lambda number, row: row.rpartition(",")[0]),
        oddity=Text("The last column is missing in every row.", "どの行にも最後の列がない。"),
        refusal=Text(
            "{path}, line 2: found 4 value(s) in '0.000000,0,0,2'; expected 5 (time, counter1, counter2, pwm1, pwm2).",
            "{path}の2行目: 値が4個です('0.000000,0,0,2')。5個の値(time, counter1, counter2, pwm1, pwm2)が必要です。",
        ),
    ),
    DirtyLog(
        name="nan",
        change=_with_field(12, 3, "nan"),
        oddity=Text("One counter value is nan.", "カウンタの値の一つがnanである。"),
        refusal=Text(
            "{path}, line 12: found 'nan' in column 3 (counter2); expected a finite number.",
            "{path}の12行目: 3列目(counter2)が'nan'です。有限の数値が必要です。",
        ),
    ),
    DirtyLog(
        name="text_in_number",
        change=_with_field(20, 2, "155O"),
        oddity=Text("One counter value holds a letter O for a zero.", "カウンタの値の一つで、0が英字のOになっている。"),
        refusal=Text(
            "{path}, line 20: found '155O' in column 2 (counter1); expected a number.",
            "{path}の20行目: 2列目(counter1)が'155O'です。数値が必要です。",
        ),
    ),
    DirtyLog(
        name="cut_off",
        change=_cut_off,
        oddity=Text(
            "The last line is cut off, as when the battery dies while a row is written.",
            "最後の行が途中で切れている(書き込み中に電池が切れた場合など)。",
        ),
        refusal=Text(
            "{path}, line 42: found 2 value(s) in '2.000000,0'; expected 5 (time, counter1, counter2, pwm1, pwm2). "
            "The file ends in the middle of this line: it seems to be cut off.",
            "{path}の42行目: 値が2個です('2.000000,0')。5個の値(time, counter1, counter2, pwm1, pwm2)が必要です。"
            "ファイルがこの行の途中で終わっています。書き込みが途中で切れたようです。",
        ),
    ),
    DirtyLog(
        name="time_running_back",
        change=_with_clock_set_back(22, 0.3),
        oddity=Text("The clock is set back by 0.3 s in mid-drive.", "走行の途中で時計が0.3 s戻る。"),
        reading=Text(
            "reads it, stamps as they are; the step of -0.25 s at line 22 is for the program to find",
            "時刻もそのまま読みます。22行目で時刻が0.25 s戻ることには、プログラムの側で気付く必要があります",
        ),
    ),
    DirtyLog(
        name="empty",
        change=lambda text: "",
        oddity=Text("The file has no bytes at all.", "ファイルの大きさが0バイトである。"),
        refusal=Text(
            "{path} holds no data: expected rows of 5 values (time, counter1, counter2, pwm1, pwm2), found an empty file.",
            "{path}にデータの行がありません。5個の値(time, counter1, counter2, pwm1, pwm2)の行が必要ですが、空のファイルでした。",
        ),
    ),
    DirtyLog(
        name="only_comments",
        change=lambda text: text.splitlines()[0] + "\n\n# the motors were never started\n",
        oddity=Text("There are comments and a blank line, but no row.", "コメント行と空行だけで、データの行がない。"),
        refusal=Text(
            "{path} holds no data: expected rows of 5 values (time, counter1, counter2, pwm1, pwm2), found blank lines and "
            "comments only.",
            "{path}にデータの行がありません。5個の値(time, counter1, counter2, pwm1, pwm2)の行が必要ですが、"
            "空行とコメント行だけでした。",
        ),
    ),
    DirtyLog(
        name="byte_order_mark",
        change=lambda text: "\N{ZERO WIDTH NO-BREAK SPACE}" + text,
        oddity=Text(
            "A byte-order mark stands before the first character, as some Windows editors put it there.",
            "先頭にBOM(バイト順マーク)がある。Windowsの一部のエディタが付ける。",
        ),
    ),
    DirtyLog(
        name="windows_line_ends",
        change=lambda text: text.replace("\n", "\r\n"),
        oddity=Text("Lines end with CR LF, as on Windows.", "改行がWindowsのCR LFである。"),
    ),
    DirtyLog(
        name="commas_and_blanks",
        change=_lines_changed(lambda number, row: row.replace(",", ", ")),
        oddity=Text("Values are separated by a comma and a blank.", "区切りがカンマと空白である。"),
    ),
    DirtyLog(
        name="white_space",
        change=_lines_changed(lambda number, row: "  " + row.replace(",", "\t", 1).replace(",", "  ")),
        oddity=Text(
            "Values are separated by tabs and blanks, without commas; rows begin with blanks.",
            "区切りがカンマではなくタブと空白で、行頭にも空白がある。",
        ),
    ),
    DirtyLog(
        name="blank_lines",
        change=_lines_changed(lambda number, row: row + ("\n" if number % 5 else "\n \t\n  # still driving\n")),
        oddity=Text(
            "Blank lines follow every row, and comments stand after blanks in the middle of the data.",
            "行ごとに空行が入り、データの途中に空白で始まるコメント行がある。",
        ),
    ),
)
