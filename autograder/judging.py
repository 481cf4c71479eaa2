"""Judging an answer: draw cases, ask, climb the ladder, recognise the mistake, and say one thing about it.

The judge sees an answer only through an `Interview` of plain data, whoever held it: this process, a notebook or the sandbox.
It never says what was expected, nor which numbers it asked with.
"""

import secrets
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from autograder.exercise import Exercise, GraphExercise, Group, Mistake, Trial, right_values, trial, wrong_reply
from autograder.reference import exercise_named
from course.answers import Interview, Question, Reply, Trouble, interview
from course.explaining import explained_missing, explained_not_axes, explained_trouble, shown
from course.factors import factor_message
from course.figures import is_summary
from course.ladder import Answered, Fault, call_fault, entry_fault, names_of_wrong, numbers_in, raises
from course.language import Text
from course.plain import Odd, Plain, Refusal, numeric
from course.tolerances import RecordTolerance, Tolerance
from course.undisturbed import calm, undisturbed
from course.verdict import Verdict

#: puts questions to an answer, wherever it lives, and brings back plain data
Ask = Callable[[Sequence[Question]], Interview]


def judge(name: str, answer: object, seed: int | None = None) -> Verdict:
    """Judge `answer`, a function or (for graphs) a Matplotlib Axes, as the exercise `name`.

    `seed` repeats a drawing of the cases; None draws afresh. Raises KeyError for an unknown exercise.
    """
    return judged_by_name(name, lambda questions: interview(answer, questions), seed)


def judged_by_name(name: str, ask: Ask, seed: int | None = None) -> Verdict:
    """Judge whatever `ask` reaches as the exercise `name`."""
    return judged(exercise_named(name), ask, seed)


def judged(exercise: Exercise | GraphExercise, ask: Ask, seed: int | None = None, apart: bool = False) -> Verdict:
    """Judge whatever `ask` reaches as `exercise`; `apart` if that is never in this process."""
    quietly = calm if apart else undisturbed
    seed = secrets.randbits(63) if seed is None else seed
    if isinstance(exercise, GraphExercise):
        talk = ask(())
        with quietly():
            return graph_verdict(exercise, talk, seed)
    with quietly():
        drawn = trial(exercise, seed)
    talk = ask(drawn.questions)
    with quietly():
        return verdict(exercise, drawn, talk, seed)


def verdict(exercise: Exercise, drawn: Trial, talk: Interview, seed: int | None = None) -> Verdict:
    """Return the verdict on one interview that put the questions of `drawn`."""
    entry = entry_fault(exercise.answered, talk)
    if entry is not None:
        return Verdict(exercise.name, 0.0, entry.text, rung=entry.rung, seed=seed)
    replies = talk.replies_to(drawn.questions)
    expected, faults, score = _best_rule(exercise, drawn, replies)
    if not any(faults):
        return Verdict(exercise.name, 1.0, _passed_text(drawn, replies), seed=seed)
    # a warning is told only where nothing else is wrong
    broken = min(
        (fault for fault in faults if fault is not None),
        key=lambda fault: (fault.harmless and fault.rung == "runs", fault.height),
    )
    slug, rung, text = _diagnosis(exercise, drawn, replies, expected, faults, broken)
    return Verdict(exercise.name, score, text + _standing(drawn, faults), rung=rung, misconception=slug, seed=seed)


def graph_verdict(exercise: GraphExercise, talk: Interview, seed: int | None = None) -> Verdict:
    """Return the verdict on the summary of a graph."""
    if talk.missing is not None:
        return Verdict(exercise.name, 0.0, explained_missing(exercise.name, talk.missing), rung="defined", seed=seed)
    if talk.figure is None or not is_summary(talk.figure):
        return Verdict(exercise.name, 0.0, explained_not_axes(exercise.name, talk.kind), rung="callable", seed=seed)
    fault = exercise.fault(talk.figure, exercise.shown)
    if fault is None:
        return Verdict(exercise.name, 1.0, _GRAPH_PASSED, seed=seed)
    return Verdict(exercise.name, min(fault.score, 0.99), fault.text, rung=fault.rung, misconception=fault.slug, seed=seed)


def case_faults(exercise: Exercise, drawn: Trial, talk: Interview | None) -> tuple[Sequence[Plain], list[Fault | None]]:
    """Return what was expected in each case, and what is wrong with each reply; None stands for replies that were all right."""
    if talk is None:
        return right_values(exercise.reference, drawn, exercise.refuses), [None] * len(drawn.questions)
    expected, faults, _ = _best_rule(exercise, drawn, talk.replies_to(drawn.questions))
    return expected, faults


def _best_rule(exercise: Exercise, drawn: Trial, replies: Sequence[Reply]) -> tuple[Sequence[Plain], list[Fault | None], float]:
    """Return (expected values, faults, score) by the right rule that fits best; rules are never mixed.

    Where nothing is right by any rule, that one fits best by which most quantities are right: it is then known what is not.
    """
    best: tuple[Sequence[Plain], list[Fault | None], float] | None = None
    least = np.inf
    for rule in (exercise.reference, *exercise.also_right):
        expected = right_values(rule, drawn, exercise.refuses)
        faults = [
            call_fault(exercise.answered, question, right, reply)
            for question, right, reply in zip(drawn.questions, expected, replies, strict=True)
        ]
        score, wrong = _score(drawn, faults), sum(map(_part_wrong, faults))
        if best is None or score > best[2] or (score == best[2] and wrong < least):
            best, least = (expected, faults, score), wrong
        if score == 1.0:
            break
    assert best is not None
    return best


def _part_wrong(fault: Fault | None) -> float:
    """Return what part of one reply is wrong; a fault beside a right value is none."""
    if fault is None or fault.harmless:
        return 0.0
    return 1.0 if fault.wrong is None else float(np.mean(fault.wrong))


def _failed_groups(drawn: Trial, faults: Sequence[Fault | None]) -> np.ndarray:
    failed = np.zeros(len(drawn.groups), dtype=bool)
    failed[[index for index, fault in zip(drawn.group_of, faults, strict=True) if fault is not None]] = True
    return failed


def _score(drawn: Trial, faults: Sequence[Fault | None]) -> float:
    failed = _failed_groups(drawn, faults)
    return 1.0 if not failed.any() else round(float(drawn.weights[~failed].sum()), 4)


def _diagnosis(  # noqa: PLR0913 - the whole evidence on one answer
    exercise: Exercise,
    drawn: Trial,
    replies: Sequence[Reply],
    expected: Sequence[Plain],
    faults: Sequence[Fault | None],
    broken: Fault,
) -> tuple[str | None, str, Text]:
    """Return (misconception, rung, text): the most useful single thing to say about a wrong answer."""
    unwritten = next((r.trouble for r in replies if r.trouble is not None and r.trouble.builtin == "NotImplementedError"), None)
    if unwritten is not None:
        return None, "runs", explained_trouble(exercise.name, unwritten)
    mistake, whole = _recognised(exercise, drawn, replies, faults)
    if mistake is not None:
        return mistake.slug, broken.rung, mistake.message if whole else _IN_PART + mistake.message
    if broken.rung != "value" or broken.text.en:
        return None, broken.rung, broken.text
    # nothing is compared with an input that had to be refused
    indices = [index for index, value in enumerate(expected) if not isinstance(value, Refusal)]
    questions = [drawn.questions[index] for index in indices]
    given = [_comparable(replies[index].value) for index in indices]
    right = [_comparable(expected[index]) for index in indices]
    factor = factor_message(exercise.answered, questions, given, right)
    if factor is not None:
        return None, "unit", factor
    return None, "value", _value_text(exercise.answered, given, right, [faults[index] for index in indices])


def _comparable(value: Plain) -> Any:
    """Return what is compared by numbers: an array, or the dict of them that a record is."""
    return value if isinstance(value, dict) else numeric(value)


def _recognised(
    exercise: Exercise, drawn: Trial, replies: Sequence[Reply], faults: Sequence[Fault | None]
) -> tuple[Mistake | None, bool]:
    """Return the mistake whose outputs the answer shows, or None; and whether it explains all that was wrong.

    Best is one that agrees in all cases; then one that explains every case that failed; then one that explains a quantity that
    was wrong (two mistakes at once: the first of them is told).
    """
    # a value that may be right is no sign of any mistake
    failing = [index for index, fault in enumerate(faults) if fault is not None and not fault.harmless]
    passing = [index for index in range(len(faults)) if index not in failing]
    if not failing:
        return None, False
    wrong = _wrong_quantities(faults)
    explains_failures, explains_quantity = None, None
    for mistake in exercise.mistakes:
        agreement = _agreement(exercise, mistake, drawn, replies, failing, wrong)
        if agreement is None:
            continue
        if not agreement.all():
            explains_quantity = explains_quantity or mistake
            continue
        elsewhere = _agreement(exercise, mistake, drawn, replies, passing, None)
        if not passing or (elsewhere is not None and elsewhere.all()):
            return mistake, True
        explains_failures = explains_failures or mistake
    return explains_failures or explains_quantity, explains_failures is not None


def _wrong_quantities(faults: Sequence[Fault | None]) -> list[np.ndarray] | None:
    """Return which quantities were wrong in each failing case, (k,) of bool each; None if some case failed before its value."""
    masks = [fault.wrong for fault in faults if fault is not None]
    if any(mask is None or len(mask) != len(masks[0]) for mask in masks):  # type: ignore[arg-type]
        return None
    return masks  # type: ignore[return-value]


def _agreement(  # noqa: PLR0913 - the evidence, and how much of it must agree
    exercise: Exercise,
    mistake: Mistake,
    drawn: Trial,
    replies: Sequence[Reply],
    indices: Sequence[int],
    wrong: Sequence[np.ndarray] | None,
) -> np.ndarray | None:
    """Return for each quantity whether the mistake gives what the answer gave in all these cases, (k,) of bool.

    None as soon as there is a case of which it explains nothing: no quantity that is wrong there agrees in all cases. If `wrong`
    is None, all quantities must agree.
    """
    agreement: np.ndarray | None = None
    for index in indices:
        same = _same_reply(exercise, wrong_reply(mistake.wrong, drawn, index), replies[index])
        agreement = same if agreement is None else _both(agreement, same)
        if not agreement.all() and not _explains(agreement, wrong):
            return None
    return agreement


def _explains(agreement: np.ndarray, wrong: Sequence[np.ndarray] | None) -> bool:
    """Is in every failing case something wrong of which the mistake gives the same?"""
    return wrong is not None and all(len(mask) == len(agreement) and bool((agreement & mask).any()) for mask in wrong)


def _both(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return where both agree; (1,) stands for all quantities, and so do replies of which the quantities do not correspond."""
    return a & b if len(a) == len(b) or 1 in (len(a), len(b)) else np.array([a.all() and b.all()])


_NEVER, _ALWAYS = np.array([False]), np.array([True])


def _same_reply(exercise: Exercise, a: Reply, b: Reply) -> np.ndarray:
    """Return for each quantity whether two replies are alike, (k,) of bool; (1,) where they cannot be told apart by quantity."""
    if a.trouble is not None or b.trouble is not None:
        alike = a.trouble is not None and b.trouble is not None and _same_trouble(exercise, a.trouble, b.trouble)
        return _ALWAYS if alike else _NEVER
    if isinstance(exercise.tolerance, RecordTolerance) and isinstance(a.value, dict) and isinstance(b.value, dict):
        return np.array([_same_entry(entry, a.value.get(key), b.value.get(key)) for key, entry in exercise.tolerance.entries])
    return _same_value(exercise.tolerance, a.value, b.value)


def _same_trouble(exercise: Exercise, a: Trouble, b: Trouble) -> bool:
    """Did two answers end in the same error? Where inputs are to be refused, the numbers that the message names count too."""
    refused = next((error.__name__ for error in exercise.refuses if raises(a, error.__name__)), None)
    if refused is None:
        return a.builtin == b.builtin
    return raises(b, refused) and set(numbers_in(a.message)) <= set(numbers_in(b.message))


def _same_entry(tolerance: Tolerance, a: Plain, b: Plain) -> bool:
    return bool(_same_value(tolerance, a, b).all())


def _same_value(tolerance: Tolerance | RecordTolerance, a: Plain, b: Plain) -> np.ndarray:
    first, second = numeric(a), numeric(b)
    if first is None or second is None or isinstance(tolerance, RecordTolerance):
        return _ALWAYS if _same_part(a, b) else _NEVER
    if first.shape != second.shape or (tolerance.double and first.dtype != second.dtype):
        return _NEVER
    finite = np.isfinite(first)
    if finite.all():
        return tolerance.quantities_right(second, first)
    if not np.array_equal(finite, np.isfinite(second)):
        return _NEVER
    return tolerance.quantities_right(np.where(finite, second, 0.0), np.where(finite, first, 0.0))


def _same_oddity(a: Plain, b: Plain) -> bool:
    """Do two values that are no numbers go wrong in the same way?"""
    if isinstance(a, Odd) or isinstance(b, Odd):
        return isinstance(a, Odd) and isinstance(b, Odd) and a.kind == b.kind
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(_same_part(x, y) for x, y in zip(a, b, strict=True))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_same_part(a[key], b[key]) for key in a)
    return type(a) is type(b) and bool(a == b)


def _same_part(a: Plain, b: Plain) -> bool:
    first, second = numeric(a), numeric(b)
    if first is None or second is None:
        return _same_oddity(a, b)
    return first.shape == second.shape and bool(np.allclose(first, second, rtol=1e-5, atol=1e-9, equal_nan=True))


def _names(groups: Sequence[Group]) -> Text:
    return Text("; ".join(group.name.en for group in groups), "、".join(group.name.ja for group in groups))


def _passed_text(drawn: Trial, replies: Sequence[Reply]) -> Text:
    text = _PASSED.format(groups=_names(drawn.groups))
    if any(reply.printed for reply in replies):
        text += _PRINTS
    warned = next((reply.warned[0] for reply in replies if reply.warned), None)
    return text if warned is None else text + _WARNS.format(warning=shown(warned))


def _standing(drawn: Trial, faults: Sequence[Fault | None]) -> Text:
    """Return which kinds of input are right and which are not, if there are both."""
    failed = _failed_groups(drawn, faults)
    if failed.all():
        return Text("", "")
    right = [group for group, bad in zip(drawn.groups, failed, strict=True) if not bad]
    wrong = [group for group, bad in zip(drawn.groups, failed, strict=True) if bad]
    return _STANDING.format(right=_names(right), wrong=_names(wrong))


def _value_text(answered: Answered, given: Sequence[Any], right: Sequence[Any], faults: Sequence[Fault | None]) -> Text:
    """Return what can be said of wrong numbers without giving the right ones: which quantities, and where in a sequence."""
    names = names_of_wrong(answered, [fault for fault in faults if fault is not None])
    wrong, fine = (Text(", ".join(part), "、".join(part)) for part in names)
    if fine.en:
        text = _SOME_QUANTITIES.format(wrong=wrong, right=fine)
    elif wrong.en:
        text = _ALL_QUANTITIES.format(wrong=wrong)
    else:
        text = _NUMBERS
    first = next(index for index, fault in enumerate(faults) if fault is not None)
    return text + _place(_entries_right(answered.tolerance, given[first], right[first]))


def _entries_right(tolerance: Tolerance | RecordTolerance, given: Any, right: Any) -> np.ndarray:
    """Return which entries are right, (k, n) of bool; of a record, those of its longest quantities."""
    if not isinstance(tolerance, RecordTolerance):
        return tolerance.entries_right(given, right)
    rows = [entry.entries_right(given[key], right[key]) for key, entry in tolerance.entries]
    longest = max(row.shape[1] for row in rows)
    return np.concatenate([row for row in rows if row.shape[1] == longest])


def _place(entries: np.ndarray) -> Text:
    """Return where along a sequence the numbers go wrong, if that is telling."""
    wrong = np.flatnonzero(~entries.all(axis=0))
    count = entries.shape[1]
    if count < 3:
        return Text("", "")
    if len(wrong) == 1 and wrong[0] in (0, count - 1):
        return _ONLY_FIRST if wrong[0] == 0 else _ONLY_LAST
    if wrong[0] == 0:
        return Text("", "")
    return _FROM_ENTRY.format(index=int(wrong[0]))


_IN_PART = Text("Part of what is wrong looks like this: ", "違いの一部は、次の間違いに当てはまります: ")
_PASSED = Text("Tried with: {groups}.", "確かめた入力: {groups}。")
_GRAPH_PASSED = Text(
    "The graph shows the right data, and its axes are labelled.", "グラフのデータも軸ラベルも正しく描けています。"
)
_PRINTS = Text(
    "\nIt also prints something; that costs nothing, but print() is best left out of a finished function.",
    "\n関数の中で print() をしています。減点はありませんが、完成した関数からは消しておくとよいでしょう。",
)
_WARNS = Text(
    "\nIt warned on the way ({warning}); that costs nothing, but is worth a look.",
    "\n途中で警告({warning})が出ています。減点はありませんが、一度確認しておきましょう。",
)
_STANDING = Text("\nRight already: {right}. Not yet: {wrong}.", "\nできている入力: {right}。まだの入力: {wrong}。")
_SOME_QUANTITIES = Text(
    "{wrong} is not right; {right} is. Compare the line that computes {wrong} with the formula, symbol by symbol.",
    "{wrong} の値が正しくありません({right} は合っています)。{wrong} を計算している行を、式と 1 文字ずつ見比べてみましょう。",
)
_ALL_QUANTITIES = Text(
    "The numbers for {wrong} are not right. Take the first example from the text or the docstring, compute it by hand, and compare step by step.",
    "{wrong} の値が正しくありません。本文またはdocstringの最初の例を手で計算して、途中の値を 1 つずつ比べてみましょう。",
)
_NUMBERS = Text(
    "The numbers are not right. Take the first example from the text or the docstring, compute it by hand, and compare step by step.",
    "値が正しくありません。本文またはdocstringの最初の例を手で計算して、途中の値を 1 つずつ比べてみましょう。",
)
_ONLY_FIRST = Text(" Only the first entry is wrong.", "違っているのは最初の要素だけです。")
_ONLY_LAST = Text(" Only the last entry is wrong.", "違っているのは最後の要素だけです。")
_FROM_ENTRY = Text(
    " The first wrong entry is number {index} (counted from 0); those before it are right.",
    "最初に違うのは {index} 番目(0 から数えて)の要素で、それより前は合っています。",
)
