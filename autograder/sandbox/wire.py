"""The wire between the judge and the sandbox: framed messages of plain data, nothing that could act.

A frame is two lengths, a JSON text, and the bytes of its arrays. Whoever reads checks every length, type and size before using
it; anything unexpected raises `WireError`, and the other side is not believed any more.
"""

import json
import math
import struct
from collections.abc import Callable, Sequence
from dataclasses import asdict
from itertools import zip_longest
from typing import Any, Protocol

import numpy as np

from autograder.sandbox.limited_json import has_more_parts, limited_json
from course.answers import Interview, Missing, Question, Reply, Trouble
from course.plain import MAX_DEPTH, Built, Odd, Plain, identical

MAX_JSON = 16 * 2**20
MAX_ARRAYS = 64 * 2**20
#: arrays are one each, so that only lists of texts or of other lists come near it
MAX_VALUES = 1_000_000
#: what the warm server is told and tells: a few names and numbers
MAX_CONTROL = 2**16
_HEADER = struct.Struct(">4sII")
_MAGIC = b"DR1\n"
_DTYPES = frozenset(
    ("bool", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "float16", "float32", "float64")
)


class Stream(Protocol):
    """What messages are written to."""

    def write(self, data: bytes, /) -> object:
        """Write all of `data`."""

    def flush(self) -> object:
        """Send what was written."""


class WireError(Exception):
    """The other side sent something that is not a well-formed message."""


def send(stream: Stream, message: dict[str, Any]) -> None:
    """Write one message; its values are plain data (course.plain) in dictionaries and lists."""
    blobs: list[bytes] = []
    text = json.dumps(_packed(message, blobs)).encode()
    arrays = b"".join(blobs)
    if len(text) > MAX_JSON or len(arrays) > MAX_ARRAYS or has_more_parts(text, MAX_VALUES):
        raise WireError("message too large")
    stream.write(_HEADER.pack(_MAGIC, len(text), len(arrays)) + text + arrays)
    stream.flush()


def receive(read: Callable[[int], bytes]) -> dict[str, Any]:
    """Read one message. `read(n)` returns exactly n bytes or raises. Raises WireError for anything malformed."""
    magic, text_size, arrays_size = _HEADER.unpack(read(_HEADER.size))
    if magic != _MAGIC or text_size > MAX_JSON or arrays_size > MAX_ARRAYS:
        raise WireError("not a frame, or one that is too large")
    try:
        packed = limited_json(read(text_size), MAX_VALUES)
    except ValueError as error:
        raise WireError(f"not JSON: {error}") from None
    message = _unpacked(packed, _Arrays(read(arrays_size)), 0)
    if not isinstance(message, dict):
        raise WireError("a message is a dictionary")
    return message


class _Arrays:
    """The array bytes of a frame, handed out once and in order."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._start = 0

    def take(self, dtype: str, shape: list[int]) -> np.ndarray:
        if dtype not in _DTYPES or len(shape) > MAX_DEPTH or any(type(n) is not int or not 0 <= n <= MAX_ARRAYS for n in shape):
            raise WireError("no such array")
        count = math.prod(shape)
        size = np.dtype(dtype).itemsize * count
        if size > len(self._data) - self._start:
            raise WireError("array longer than its frame")
        flat = np.frombuffer(self._data, dtype, count, self._start) if count else np.empty(0, dtype)
        self._start += size
        if dtype == "bool" and flat.view(np.uint8).max(initial=0) > 1:
            raise WireError("neither true nor false")
        try:
            return flat.reshape(shape).copy()
        except ValueError:
            raise WireError("an empty array of an impossible shape") from None


def _packed(value: Plain, blobs: list[bytes]) -> Any:
    if isinstance(value, np.ndarray):
        blobs.append(value.tobytes())
        return {"@": "array", "dtype": value.dtype.name, "shape": list(value.shape)}
    if isinstance(value, Odd):
        return {"@": "odd", "kind": value.kind, "type_name": value.type_name}
    if isinstance(value, Built):
        return {"@": "built", "kind": value.kind, "data": _packed(value.data, blobs)}
    if isinstance(value, dict):
        return {"@": "dict", "items": [[str(key), _packed(item, blobs)] for key, item in value.items()]}
    if isinstance(value, list | tuple):
        return [_packed(item, blobs) for item in value]
    return value


def _unpacked(value: Any, arrays: _Arrays, depth: int) -> Plain:
    if depth > 4 * MAX_DEPTH:
        raise WireError("nested too deeply")
    if isinstance(value, list):
        return [_unpacked(item, arrays, depth + 1) for item in value]
    if isinstance(value, str):
        return _encodable(value)
    if type(value) is int and not -(2**63) <= value < 2**64:
        raise WireError("a number of more than 64 bits")
    if not isinstance(value, dict):
        return value
    match value:
        case {"@": "array", "dtype": str(dtype), "shape": list(shape)}:
            return arrays.take(dtype, shape)
        case {"@": "odd", "kind": str(kind), "type_name": str(type_name)}:
            return Odd(_encodable(kind[:80]), _encodable(type_name[:80]))
        case {"@": "built", "kind": str(kind), "data": data}:
            return Built(_encodable(kind[:80]), _unpacked(data, arrays, depth + 1))
        case {"@": "dict", "items": list(items)}:
            return dict(_item(item, arrays, depth) for item in items)
    raise WireError("no such kind of value")


def _item(item: Any, arrays: _Arrays, depth: int) -> tuple[str, Plain]:
    match item:
        case [str(key), inner]:
            return _encodable(key), _unpacked(inner, arrays, depth + 1)
    raise WireError("a dictionary's item is a name and a value")


def _encodable(text: str) -> str:
    r"""Return text in which halves of surrogate pairs, which no file and no database takes, are written out as \ud800."""
    return text if text.isascii() else text.encode(errors="backslashreplace").decode()


def packed_questions(questions: tuple[Question, ...]) -> list[dict[str, Plain]]:
    """Return questions as plain data."""
    return [{"args": list(question.args)} | ({"symbols": True} if question.symbols else {}) for question in questions]


def unpacked_questions(data: list[dict[str, Plain]]) -> tuple[Question, ...]:
    """Return the questions that `packed_questions` packed."""
    return tuple(Question(tuple(item["args"]), item.get("symbols", False)) for item in data)


def packed_interview(talk: Interview, questions: Sequence[Question] = ()) -> dict[str, Plain]:
    """Return an interview as plain data.

    Inputs that stand as they were asked in `questions` are left out: whoever unpacks it with the same questions knows them.
    """
    asked = [*questions, *[None] * len(talk.replies)]
    return {
        "missing": None if talk.missing is None else asdict(talk.missing),
        "kind": talk.kind,
        "mismatch": None if talk.mismatch is None else list(talk.mismatch),
        "figure": None if talk.figure is None else dict(talk.figure),
        "replies": [_packed_reply(reply, question) for question, reply in zip(asked, talk.replies, strict=False)],
    }


def _packed_reply(reply: Reply, question: Question | None) -> dict[str, Plain]:
    """Return a reply as plain data. What goes without saying is left out: most replies are a value and nothing else."""
    packed: dict[str, Plain] = {"value": reply.value}
    if reply.trouble is not None:
        packed["trouble"] = asdict(reply.trouble)
    if question is None or not _unchanged(question, reply):
        packed["inputs"] = list(reply.inputs)
    if reply.printed:
        packed["printed"] = reply.printed
    if reply.warned:
        packed["warned"] = list(reply.warned)
    return packed


def _unchanged(question: Question, reply: Reply) -> bool:
    return len(question.args) == len(reply.inputs) and all(map(identical, question.args, reply.inputs))


def unpacked_interview(data: Plain, questions: Sequence[Question] = ()) -> Interview:
    """Return the interview in a message from the sandbox, which was asked `questions`; WireError if it is not one."""
    match data:
        case {"missing": missing, "kind": str(kind), "mismatch": mismatch, "figure": figure, "replies": list(replies)}:
            return Interview(
                missing=_missing(missing),
                kind=kind[:80],
                mismatch=_mismatch(mismatch),
                replies=tuple(_reply(reply, question) for reply, question in zip_longest(replies, questions[: len(replies)])),
                figure=_figure(figure),
            )
    raise WireError("not an interview")


def _figure(data: Plain) -> dict[str, Plain] | None:
    """Return the summary of a graph, as course.figures.axes_summary makes it."""
    match data:
        case None:
            return None
        case {
            "lines": list(lines), "points": list(points), "labels": [str(_), str(_)], "title": str(_), "scales": [str(_), str(_)],
            "limits": np.ndarray(shape=(4,), dtype=np.dtypes.Float64DType()), "aspect": float(_), "legend": list(legend),
        } if all(map(_is_series, [*lines, *points])) and all(isinstance(text, str) for text in legend):  # fmt: skip
            return data
    raise WireError("not the summary of a graph")


def _is_series(data: Plain) -> bool:
    match data:
        case {"xy": np.ndarray(shape=(_, 2), dtype=np.dtypes.Float64DType()), "label": str(_), "visible": bool(_)}:
            return True
    return False


def _missing(data: Plain) -> Missing | None:
    match data:
        case None:
            return None
        case {"reason": str(reason), "where": str(where), "trouble": trouble}:
            return Missing(reason[:80], where[:80], _trouble(trouble))
    raise WireError("not a reason for missing")


def _mismatch(data: Plain) -> tuple[int, str] | None:
    match data:
        case None:
            return None
        case [int(count), str(signature)]:
            return count, signature[:200]
    raise WireError("not a mismatch")


def _trouble(data: Plain) -> Trouble | None:
    match data:
        case None:
            return None
        case {"type": str(a), "builtin": str(b), "message": str(c), "line": str(d), "line_number": int(e), "function": str(f)}:
            return Trouble(a[:80], b[:80], c[:500], d[:500], e, f[:80])
    raise WireError("not a trouble")


_REPLY = {"value", "trouble", "inputs", "printed", "warned"}


def _reply(data: Plain, question: Question | None) -> Reply:
    if not isinstance(data, dict) or not data.keys() <= _REPLY:
        raise WireError("not a reply")
    printed, warned = data.get("printed", ""), data.get("warned", [])
    if not isinstance(printed, str) or not isinstance(warned, list):
        raise WireError("not a reply")
    texts = tuple(text[:500] for text in warned[:5] if isinstance(text, str))
    return Reply(data.get("value"), _trouble(data.get("trouble")), _inputs(data.get("inputs"), question), printed[:2000], texts)


def _inputs(data: Plain, question: Question | None) -> tuple[Plain, ...]:
    if isinstance(data, list):
        return tuple(data)
    if data is None and question is not None:
        return question.args
    raise WireError("no inputs")
