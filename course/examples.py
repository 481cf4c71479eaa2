"""The public examples: what a check answers from where there is no judge.

`examples.json` is written by `autograder build` from the exercises; it holds only what the notebooks show anyway.
"""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from course.answers import Interview, Question
from course.explaining import explained_missing, explained_not_axes
from course.factors import factor_message
from course.figures import is_summary
from course.given import shown_built
from course.graphs import Structure, structure_fault
from course.ladder import Answered, Fault, call_fault, entry_fault
from course.language import Text
from course.plain import Built, Plain, Refusal, numeric
from course.tolerances import RecordTolerance, Tolerance
from course.undisturbed import undisturbed
from course.verdict import Verdict

FILE = Path(__file__).with_name("examples.json")

_PASSED = Text(
    "{count} public examples are right. The work that you hand in is checked with many more inputs.",
    "公開例 {count} 個はすべて合っています。提出後の採点では、ほかの入力でも確かめます。",
)
_GRAPH_PASSED = Text(
    "The graph has what such a graph needs. Whether it shows the right data is compared when the work is handed in.",
    "グラフとして必要なものはそろっています。データが正しいかどうかは、提出後の採点で比べます。",
)
_WRONG = Text(
    "{name}({args}) gives {given}; the example says {expected}.",
    "{name}({args}) の結果が {given} になっています。公開例では {expected} です。",
)
_WHERE = Text("\nThis happens in the example {name}({args}).", "\n例 {name}({args}) でこうなります。")


def verdict_from_examples(name: str, ask: Callable[[Sequence[Question]], Interview]) -> Verdict:
    """Judge an answer by the public examples alone. Raises KeyError for an unknown exercise, with the names there are."""
    entries = _entries()
    if name not in entries:
        raise KeyError(f"no exercise is called {name!r}; there are: {', '.join(entries)}")
    entry = entries[name]
    if isinstance(entry, Structure):
        talk = ask(())
        with undisturbed():
            return _graph_verdict(name, entry, talk)
    answered, questions, expected = entry
    talk = ask(questions)
    with undisturbed():
        return _verdict(answered, questions, expected, talk)


def shown_value(value: Plain) -> str:
    """Return a value as a reader sees it in an example: short, rounded, without the word array."""
    array = numeric(value)
    if array is not None:
        return np.array2string(array, precision=6, suppress_small=True, separator=", ", threshold=20).replace("\n", "")
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key!r}: {shown_value(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(shown_value, value)) + "]"
    if isinstance(value, Built):
        return shown_built(value)
    return value.error if isinstance(value, Refusal) else repr(value)[:200]


def stored(value: Plain) -> Any:
    """Return plain data as JSON can hold it; `restored` turns it back."""
    if isinstance(value, np.ndarray):
        return {"array": value.tolist(), "dtype": value.dtype.name}
    if isinstance(value, Built):
        return {"built": value.kind, "data": stored(value.data)}
    if isinstance(value, Refusal):
        return {"refusal": value.error, "names": value.names}
    if isinstance(value, dict):
        return {"dict": {key: stored(item) for key, item in value.items()}}
    if isinstance(value, list):
        return [stored(item) for item in value]
    return value


def restored(value: Any) -> Plain:
    """Return the plain data that `stored` wrote."""
    if isinstance(value, dict):
        if "array" in value:
            return np.array(value["array"], dtype=value["dtype"])
        if "built" in value:
            return Built(value["built"], restored(value["data"]))
        if "refusal" in value:
            return Refusal(value["refusal"], value["names"])
        return {key: restored(item) for key, item in value["dict"].items()}
    return [restored(item) for item in value] if isinstance(value, list) else value


def stored_tolerance(tolerance: Tolerance | RecordTolerance) -> dict[str, Any]:
    """Return a tolerance as JSON can hold it."""
    if isinstance(tolerance, RecordTolerance):
        return {"entries": {key: asdict(entry) for key, entry in tolerance.entries}}
    return asdict(tolerance)


def _restored_tolerance(data: dict[str, Any]) -> Tolerance | RecordTolerance:
    if "entries" in data:
        return RecordTolerance(tuple((key, _tolerance(entry)) for key, entry in data["entries"].items()))
    return _tolerance(data)


def _tolerance(data: dict[str, Any]) -> Tolerance:
    return Tolerance(**{**data, "angles": tuple(data["angles"])})


def _verdict(answered: Answered, questions: Sequence[Question], expected: Sequence[Plain], talk: Interview) -> Verdict:
    """Return the verdict on an interview that put the questions of all the examples."""
    name = answered.name
    fault = entry_fault(answered, talk)
    if fault is not None:
        return Verdict(name, 0.0, fault.text, rung=fault.rung, public=True)
    for question, right, reply in zip(questions, expected, talk.replies_to(questions), strict=True):
        fault = call_fault(answered, question, right, reply)
        if fault is not None:
            text = _fault_text(answered, questions, expected, talk, fault)
            shown = {"name": name, "args": ", ".join(map(shown_value, question.args))}
            example = _WRONG.format(given=shown_value(reply.value), expected=shown_value(right), **shown)
            text += example if fault.rung == "value" else _WHERE.format(**shown)
            return Verdict(name, 0.0, text, rung=fault.rung, public=True)
    return Verdict(name, 1.0, _PASSED.format(count=len(questions)), public=True)


def _graph_verdict(name: str, structure: Structure, talk: Interview) -> Verdict:
    """Return the verdict on a graph by its structure alone: there are no data here to compare it with."""
    if talk.missing is not None:
        return Verdict(name, 0.0, explained_missing(name, talk.missing), rung="defined", public=True)
    if talk.figure is None or not is_summary(talk.figure):
        return Verdict(name, 0.0, explained_not_axes(name, talk.kind), rung="callable", public=True)
    fault = structure_fault(structure, talk.figure)
    if fault is not None:
        return Verdict(name, 0.0, fault.text, rung=fault.rung, misconception=fault.slug, public=True)
    return Verdict(name, 1.0, _GRAPH_PASSED, public=True)


def _fault_text(
    answered: Answered, questions: Sequence[Question], expected: Sequence[Plain], talk: Interview, fault: Fault
) -> Text:
    if fault.rung != "value" or isinstance(answered.tolerance, RecordTolerance):
        return fault.text
    given = [numeric(reply.value) for reply in talk.replies_to(questions)]
    right = [numeric(value) for value in expected]
    if any(g is None or r is None or g.shape != r.shape or not np.isfinite(g).all() for g, r in zip(given, right, strict=True)):
        return fault.text
    factor = factor_message(answered, questions, given, right)
    return fault.text if factor is None else factor + Text("\n", "\n")


@cache
def _entries() -> dict[str, Structure | tuple[Answered, list[Question], list[Plain]]]:
    """Return for each exercise what it asks for, the examples' questions, and their results; of a graph its structure."""
    return {name: _entry(name, entry) for name, entry in json.loads(FILE.read_text(encoding="utf-8")).items()}


def _entry(name: str, entry: dict[str, Any]) -> Structure | tuple[Answered, list[Question], list[Plain]]:
    if "graph" in entry:
        return Structure(**{**entry["graph"], "scales": tuple(entry["graph"]["scales"])})
    answered = Answered(
        name,
        tuple(entry["parameters"]),
        _restored_tolerance(entry["tolerance"]),
        tuple(entry["quantities"]),
        warnings_are_faults=entry["warnings_are_faults"],
        gear=entry["gear"],
    )
    questions = [Question(tuple(restored(arg) for arg in example["args"])) for example in entry["examples"]]
    return answered, questions, [restored(example["result"]) for example in entry["examples"]]
