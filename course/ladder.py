"""The ladder of checks that every answer climbs: defined, callable, runs, inputs, shape, unit, value.

It stops at the first rung that breaks. The judge climbs it with cases drawn afresh, a student's bundle with the public examples.
"""

import builtins
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from course.answers import Interview, Question, Reply, Trouble
from course.explaining import (
    explained_kind,
    explained_mismatch,
    explained_missing,
    explained_none,
    explained_odd,
    explained_trouble,
    shown,
)
from course.language import Text
from course.plain import Odd, Plain, Refusal, identical, numeric
from course.tolerances import ONE_QUANTITY, RecordTolerance, Tolerance
from course.verdict import RUNGS


@dataclass(frozen=True)
class Answered:
    """What an exercise asks for, as far as the ladder needs to know it.

    `quantities` names what lies side by side in the answer, such as x, y, theta; `parameters` are those of the stub;
    `gear` is the index of an argument by which students multiply or divide once too often.
    """

    name: str
    parameters: tuple[str, ...]
    tolerance: Tolerance | RecordTolerance = ONE_QUANTITY
    quantities: tuple[str, ...] = ()
    warnings_are_faults: bool = False
    gear: int | None = None


@dataclass(frozen=True)
class Fault:
    """The rung at which one call broke, what to say of it, and which quantities were wrong ((k,) of bool, if it came that far).

    `harmless`: the value itself may be right, as where inputs were changed or a warning is the whole fault.
    """

    rung: str
    text: Text
    wrong: np.ndarray | None = field(default=None, compare=False)
    harmless: bool = False

    @property
    def height(self) -> int:
        """Return how high on the ladder the fault sits; lower ones are told first."""
        return RUNGS.index(self.rung)


def entry_fault(answered: Answered, interview: Interview) -> Fault | None:
    """Return the fault that keeps an answer from being called at all, or None."""
    name = answered.name
    if interview.missing is not None:
        return Fault("defined", explained_missing(name, interview.missing))
    if interview.kind != "function":
        return Fault("callable", explained_kind(name, interview.kind))
    if interview.mismatch is not None:
        return Fault("callable", explained_mismatch(name, ", ".join(answered.parameters), interview.mismatch))
    return None


def call_fault(answered: Answered, question: Question, expected: Plain, reply: Reply) -> Fault | None:
    """Return the fault of one call, or None if the reply is right."""
    if isinstance(expected, Refusal):
        refusal = _refusal_fault(answered, expected, reply)
        if refusal is not None:
            return refusal
    elif reply.trouble is not None:
        return Fault("runs", explained_trouble(answered.name, reply.trouble))
    if reply.inputs is not question.args and not _same_inputs(question.args, reply.inputs):
        return Fault("inputs", _changed_inputs(answered, question, reply), harmless=True)
    if not isinstance(expected, Refusal):
        fault = _value_fault(answered.tolerance, expected, reply)
        if fault is not None:
            return fault
    if answered.warnings_are_faults and reply.warned:
        return Fault("runs", _WARNED.format(name=answered.name, warning=shown(reply.warned[0])), harmless=True)
    return None


def _refusal_fault(answered: Answered, expected: Refusal, reply: Reply) -> Fault | None:
    """Return what is wrong with a reply to an input that is to be refused, or None."""
    if reply.trouble is None:
        return Fault("shape", _NOT_REFUSED.format(error=expected.error))
    if not raises(reply.trouble, expected.error):
        return Fault("runs", _REFUSED_OTHERWISE.format(error=expected.error) + explained_trouble(answered.name, reply.trouble))
    if expected.names and expected.names not in numbers_in(reply.trouble.message):
        return Fault("value", _NOT_NAMED.format(error=expected.error, message=shown(reply.trouble.message)))
    return None


def raises(trouble: Trouble, error: str) -> bool:
    """Is the trouble that built-in error, or one derived from it?"""
    raised = getattr(builtins, trouble.builtin, None)
    return isinstance(raised, type) and issubclass(raised, getattr(builtins, error))


def numbers_in(message: str) -> list[str]:
    """Return the whole numbers that a message names, as digits."""
    return re.findall(r"(?a:\d+)", message)


def _value_fault(tolerance: Tolerance | RecordTolerance, expected: Plain, reply: Reply) -> Fault | None:
    """Return what is wrong with form or value of a reply, or None."""
    if isinstance(tolerance, RecordTolerance):
        form = _record_fault(tolerance, expected, reply)
        given, right = reply.value, expected
    else:
        form = _form_fault(tolerance, expected, reply)
        given, right = numeric(reply.value), numeric(expected)
    if form is not None:
        return form
    correct = tolerance.quantities_right(given, right)
    return None if correct.all() else Fault("value", Text("", ""), wrong=~correct)


def _record_fault(tolerance: RecordTolerance, expected: Mapping[str, Plain], reply: Reply) -> Fault | None:
    """Return what is wrong with the form of a reply that is to be a dict, or None."""
    value, keys = reply.value, [key for key, _ in tolerance.entries]
    if not isinstance(value, dict):
        if value is None:
            return Fault("shape", explained_none(reply.printed))
        return Fault("shape", explained_odd(value) if isinstance(value, Odd) else _NOT_A_DICT.format(keys=", ".join(keys)))
    missing = [key for key in keys if key not in value]
    if missing:
        given = shown(", ".join(value)) or "-"
        return Fault("shape", _NO_ENTRY.format(missing=", ".join(missing), given=given))
    for key, entry in tolerance.entries:
        fault = _form_fault(entry, expected[key], Reply(Odd("none", "NoneType") if value[key] is None else value[key]))
        if fault is not None:
            return Fault(fault.rung, _IN_ENTRY.format(key=key) + fault.text)
    return None


def _same_inputs(asked: Sequence[Plain], after: Sequence[Plain]) -> bool:
    return len(asked) == len(after) and all(map(identical, asked, after))


def stands_for_truth(expected: Plain) -> bool:
    """Is the expected answer True or False? 0 and 1 are the same to a student."""
    return isinstance(expected, bool) or (isinstance(expected, np.ndarray) and expected.dtype.kind == "b")


def _form_fault(tolerance: Tolerance, expected: Plain, reply: Reply) -> Fault | None:
    """Return what is wrong with type, shape or finiteness of a reply, or None."""
    value, right = reply.value, numeric(expected)
    assert right is not None, "an exercise expects numbers"
    given = numeric(value)
    if value is None:
        return Fault("shape", explained_none(reply.printed))
    if isinstance(value, Odd):
        return Fault("shape", explained_odd(value))
    if isinstance(value, str):
        return Fault("shape", explained_odd(Odd("text", "str")))
    if given is None:
        return Fault("shape", _unlike_numbers(value, right))
    if given.dtype.kind == "b" and not stands_for_truth(expected):
        return Fault("shape", _TRUTH)
    if given.shape != right.shape:
        return Fault("shape", _SHAPE.format(given=shape_in_words(given.shape), wanted=shape_in_words(right.shape)))
    if not np.all(np.isfinite(given[tolerance.skip :] if tolerance.skip else given)):
        return Fault("shape", _NOT_FINITE.format(what=_not_finite(given)))
    if tolerance.double and given.dtype != np.float64:
        return Fault("shape", _NOT_DOUBLE.format(dtype=given.dtype.name))
    return None


def shape_in_words(shape: tuple[int, ...]) -> Text:
    """Return a shape as a reader says it: one number, 3 numbers, shape (4, 3)."""
    if shape == ():
        return Text("a single number", "数値1個")
    if len(shape) == 1:
        return Text(f"shape ({shape[0]},)", f"形状 ({shape[0]},)")
    return Text(f"shape {shape}", f"形状 {shape}")


def _unlike_numbers(value: Plain, right: np.ndarray) -> Text:
    if isinstance(value, Mapping):
        return explained_odd(Odd("dict", "dict"))
    odd = _first_odd(value)
    if odd is not None:
        return explained_odd(odd)
    return _RAGGED.format(wanted=shape_in_words(right.shape))


def _first_odd(value: Plain) -> Odd | None:
    """Return the first thing in nested lists that is no number, or None if they are merely of different lengths."""
    if isinstance(value, Odd):
        return value
    if value is None or isinstance(value, str):
        return Odd("none" if value is None else "text", type(value).__name__)
    if isinstance(value, list):
        return next((odd for odd in map(_first_odd, value) if odd is not None), None)
    return None


def _not_finite(given: np.ndarray) -> str:
    return "NaN" if np.isnan(given).any() else "inf"


def _changed_inputs(answered: Answered, question: Question, reply: Reply) -> Text:
    pairs = list(zip(answered.parameters, question.args, reply.inputs, strict=False))
    changed = [name for name, before, after in pairs if not identical(before, after)]
    text = _CHANGED_DICT if any(isinstance(before, dict) for name, before, _ in pairs if name in changed) else _CHANGED
    return text.format(names=", ".join(changed) or "?")


def names_of_wrong(answered: Answered, faults: Sequence[Fault]) -> tuple[list[str], list[str]]:
    """Return (wrong, right): the quantities that were wrong in some case, and those that were right in all."""
    masks = [fault.wrong for fault in faults if fault.wrong is not None and len(fault.wrong) == len(answered.quantities)]
    if not masks:
        return [], []
    wrong = np.any(masks, axis=0)
    names = np.array(answered.quantities, dtype=object)
    return list(names[wrong]), list(names[~wrong])


_NOT_REFUSED = Text(
    "This input must be refused: the docstring asks for raise {error}(...). Your function returned something instead. Which line "
    "would notice that the input is of no use?",
    "この入力は受け付けてはいけません。docstringにあるとおり{error}をraiseする必要がありますが、値が返ってきました。"
    "使えない入力だと気づくのはどの行でしょうか。",
)
_REFUSED_OTHERWISE = Text(
    "This input must be refused with {error}, and another error came. ",
    "この入力は{error}で断る必要がありますが、別の例外になりました。",
)
_NOT_NAMED = Text(
    "{error} is raised, as it should be, but its message does not name the right line of the file: {message}. Lines are counted "
    "from 1, and every line of the file counts, comments and blank ones too.",
    "{error}が出るのは正しいのですが、メッセージにファイルの正しい行番号がありません: {message}。"
    "行は1から数え、コメント行や空行も1行と数えます。",
)
_NOT_A_DICT = Text(
    "A dict with the entries {keys} is asked for, and something else came back. Look at what the last line returns.",
    "{keys}という項目をもつdictを返す課題ですが、別の種類の値が返っています。returnの行を確かめてください。",
)
_NO_ENTRY = Text(
    "The dict that comes back has no entry {missing}; it has: {given}. Compare the names with those in the docstring, letter by letter.",
    "返ってきたdictに項目{missing}がありません。あるのは{given}です。docstringにある名前と1文字ずつ見比べてみましょう。",
)
_IN_ENTRY = Text("In the entry '{key}': ", "項目'{key}'について: ")
_NOT_DOUBLE = Text(
    "The numbers are {dtype}. Arrays of float64 are asked for: float32 keeps only seven digits, too few for a time stamp, and "
    "whole numbers overflow or cut off later.",
    "数値の型が{dtype}になっています。float64の配列が必要です。float32は7桁しか保てないので時刻に足りず、整数型では後の計算であふれたり切り捨てられたりします。",
)
_WARNED = Text(
    "{name} gives the right numbers but warns: {warning}. In this exercise a warning is a fault. If it speaks of a division or an "
    "invalid value, something was computed and thrown away: choose the formula before computing, not afterwards.",
    "{name} の値は正しいのですが、警告が出ました: {warning}。この課題では警告も誤りとします。割り算や invalid value の警告なら、"
    "計算してから捨てている値があります。計算する前に式を選びましょう。",
)
_CHANGED = Text(
    "Your function changes its input ({names}). Whoever calls it still needs the old values, and a second run of the cell gives "
    "something else. Work on a copy, for example np.array({names}, dtype=float), instead of += on the argument.",
    "関数が引数({names})を書き換えています。呼び出した側では元の値がまだ必要ですし、セルを再実行すると結果が変わってしまいます。"
    "引数に直接 += などをせず、np.array({names}, dtype=float) のようにコピーしてから計算しましょう。",
)
_CHANGED_DICT = Text(
    "Your function changes its input ({names}). Whoever calls it still needs the old values, and a second run of the cell gives "
    "something else. Put the results into a new dict, for example dict({names}), and change none of the old arrays with += either.",
    "関数が引数({names})を書き換えています。呼び出した側では元の値がまだ必要ですし、セルを再実行すると結果が変わってしまいます。"
    "結果は dict({names}) などの新しい dict に入れ、元の配列も += などで書き換えないようにしましょう。",
)
_TRUTH = Text(
    "Your function returns True or False where a number is asked for. Look at what the last line returns: is it a comparison?",
    "数値を返すところで True / False が返っています。return の行が比較式になっていないか確かめてください。",
)
_SHAPE = Text(
    "Your function returns {given}, but {wanted} is asked for with these inputs. Look at the shape in the docstring, and print "
    "np.shape(...) of what you return.",
    "戻り値が{given}になっています。この入力では{wanted}が必要です。docstring の形状を見て、戻り値の np.shape(...) を表示してみましょう。",
)
_RAGGED = Text(
    "The parts of what your function returns have different lengths, so that they do not form {wanted}. Print the shape of each part.",
    "戻り値の各部分の長さがそろっていないため、{wanted}になりません。それぞれの shape を表示して確かめましょう。",
)
_NOT_FINITE = Text(
    "The result contains {what} for some inputs. Look for a division by zero, or a square root or logarithm outside its range.",
    "入力によって結果に {what} が含まれます。0 での割り算や、定義域の外の平方根・対数がないか調べましょう。",
)
