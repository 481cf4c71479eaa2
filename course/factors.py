"""Recognise an answer that is right up to a constant factor: degrees, turns, g, the gear, a half that is missing."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from course.answers import Question
from course.ladder import Answered
from course.language import Text
from course.tolerances import RecordTolerance, Tolerance

_G = 9.80665
_CONSTANTS: tuple[tuple[float, Text], ...] = (
    (180 / np.pi, Text("180/π: are these degrees? The course computes in rad", "180/π 倍です。度になっていませんか。この講義では rad で計算します")),
    (np.pi / 180, Text("π/180: was an angle in rad converted once more?", "π/180 倍です。すでに rad の角度をもう一度変換していませんか")),
    (2 * np.pi, Text("2π: is a factor 2π counted twice, or turns taken for rad?", "2π 倍です。2π を余分に掛けたか、回転数と rad を取り違えていませんか")),
    (1 / (2 * np.pi), Text("1/(2π): these are turns; one turn is 2π rad", "1/(2π) 倍です。回転数のままになっています。1 回転は 2π rad です")),
    (np.pi, Text("π: look where π and 2π come in", "π 倍です。π と 2π の使い方を見直しましょう")),
    (1 / np.pi, Text("1/π: look where π and 2π come in", "1/π 倍です。π と 2π の使い方を見直しましょう")),
    (_G, Text("9.80665: was g already converted to m/s^2?", "9.80665 倍です。g から m/s^2 への変換を二重にしていませんか")),
    (1 / _G, Text("1/9.80665: is this in g instead of m/s^2?", "1/9.80665 倍です。m/s^2 ではなく g のままになっていませんか")),
    (-_G, Text("-9.80665: look at the unit and at the direction of z", "-9.80665 倍です。単位と z 軸の向きを見直しましょう")),
    (1000.0, Text("1000: milli (ms, mm) or SI units?", "1000 倍です。ミリ(ms, mm)と SI 単位を取り違えていませんか")),
    (1 / 1000.0, Text("1/1000: milli (ms, mm) or SI units?", "1/1000 倍です。ミリ(ms, mm)と SI 単位を取り違えていませんか")),
    (1e6, Text("1,000,000: is something in ms or mm used twice?", "100 万倍です。ms や mm を二重に使っていませんか")),
    (60.0, Text("60: minutes or seconds?", "60 倍です。分と秒を取り違えていませんか")),
    (1 / 60.0, Text("1/60: minutes or seconds?", "1/60 倍です。分と秒を取り違えていませんか")),
    (3.6, Text("3.6: km/h instead of m/s?", "3.6 倍です。m/s ではなく km/h になっていませんか")),
    (-1.0, Text("-1: the direction is turned round; look at the order of each subtraction", "-1 倍、つまり向きが逆です。引き算の順序を見直しましょう")),
    (2.0, Text("2: is a half missing, or a diameter used as a radius?", "2 倍です。1/2 が抜けているか、直径を半径として使っていませんか")),
    (0.5, Text("1/2: is a half too much in it, or a radius used as a diameter?", "1/2 倍です。1/2 が余分か、半径を直径として使っていませんか")),
    (-2.0, Text("-2: look at the direction, and at a missing half", "-2 倍です。向きと、抜けている 1/2 を見直しましょう")),
    (-0.5, Text("-1/2: look at the direction, and at a half too much", "-1/2 倍です。向きと、余分な 1/2 を見直しましょう")),
    (4.0, Text("4: are pulses and counts (4 to a pulse) mixed up, or a factor 2 used twice?", "4 倍です。パルスとカウント(1 パルス = 4 カウント)の取り違えか、2 を二重に掛けていませんか")),
    (0.25, Text("1/4: are pulses and counts (4 to a pulse) mixed up, or a half used twice?", "1/4 倍です。パルスとカウント(1 パルス = 4 カウント)の取り違えか、1/2 を二重に掛けていませんか")),
)  # fmt: skip
_GEAR = {
    1: Text("the gear ratio: the encoder sits on the motor shaft, which turns faster than the wheel", "ギア比の分だけ大きくなっています。エンコーダはタイヤより速く回るモータ軸に付いています"),
    2: Text("the gear ratio squared: multiply or divide by it once, and in the direction motor to wheel", "ギア比の 2 乗の分だけ大きくなっています。モータからタイヤへ、割るのか掛けるのかを確かめましょう"),
    -1: Text("one over the gear ratio: it is used once too often", "ギア比の分だけ小さくなっています。ギア比で余分に割っていませんか"),
}  # fmt: skip
_MESSAGE = Text(
    "{what} is right up to a constant factor in every case: {factor}.",
    "どの入力でも、{what}が正しい値の定数倍になっています。{factor}。",
)


def factor_message(
    answered: Answered, questions: Sequence[Question], given: Sequence[Any], expected: Sequence[Any]
) -> Text | None:
    """Return what to say if every wrong quantity is a known constant times the right one, in all cases; else None.

    `given` and `expected` hold one array for each question, of the same shapes. Where they hold dicts of arrays, one entry that
    is a constant times the right one is enough: the others follow from it in ways of their own.
    """
    tolerance = answered.tolerance
    if isinstance(tolerance, RecordTolerance):
        parts = ((replace(answered, tolerance=entry, quantities=(key,)), key) for key, entry in tolerance.entries)
        texts = (factor_message(part, questions, _entries(key, given), _entries(key, expected)) for part, key in parts)
        return next((text for text in texts if text is not None), None)
    rows = range(len(tolerance.by_quantity(expected[0])))
    right = np.all([tolerance.quantities_right(g, e) for g, e in zip(given, expected, strict=True)], axis=0)
    if right.all():
        return None
    found = [(row, _factor(answered.gear, tolerance, row, questions, given, expected)) for row in rows if not right[row]]
    if any(text is None for _, text in found):
        return None
    row, text = found[0]
    assert text is not None
    return _MESSAGE.format(what=_what(answered, row), factor=text)


def _entries(key: str, records: Sequence[Any]) -> list[Any]:
    return [record[key] for record in records]


def _what(answered: Answered, row: int) -> Text:
    if row < len(answered.quantities):
        return Text(answered.quantities[row], f" {answered.quantities[row]} ")
    return Text("The result", "結果")


def _factor(  # noqa: PLR0913 - the whole evidence on one quantity
    gear: int | None, tolerance: Tolerance, row: int, questions: Sequence[Question], given: Sequence[Any], expected: Sequence[Any]
) -> Text | None:
    if row in tolerance.angles:
        return None
    pairs = [(tolerance.by_quantity(g)[row], tolerance.by_quantity(e)[row]) for g, e in zip(given, expected, strict=True)]
    for constant, text in _CONSTANTS:
        if _scaled(pairs, [constant] * len(pairs)):
            return text
    if gear is not None:
        gears = [float(question.args[gear]) for question in questions]
        for power, text in _GEAR.items():
            if _scaled(pairs, [ratio**power for ratio in gears]):
                return text
    return None


def _scaled(pairs: Sequence[tuple[np.ndarray, np.ndarray]], factors: Sequence[float]) -> bool:
    """Is every given row its factor times the expected one, and enough of it not zero?"""
    telling = 0
    for (given, expected), factor in zip(pairs, factors, strict=True):
        scale = np.max(np.abs(expected), initial=0.0) * abs(factor)
        if not np.all(np.abs(given - factor * expected) <= 1e-12 + 1e-5 * scale):
            return False
        telling += bool(scale > 0)
    return telling >= 2
