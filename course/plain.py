"""Plain data: what an answer gives back, stripped of everything that could act.

A value is turned into numbers, text, NumPy arrays of exact type, lists and dictionaries before anyone compares it, so that
subclasses, masks, objects and comparison tricks are gone by then. What cannot be stripped becomes an `Odd`, which equals nothing.
"""

import sys
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

MAX_ELEMENTS = 5_000_000
MAX_TEXT = 20_000
MAX_DEPTH = 8

#: exactly NumPy's own: a subclass could say anything
_NUMPY_SCALARS = frozenset(np.sctypeDict.values())
#: reads a class's true name, whatever its metaclass says
_NAME = type.__dict__["__name__"]

#: None, bool, int, float, str, numpy.ndarray (of kind b, i, u, f), list and dict of these, or Odd
Plain = Any


class Odd(NamedTuple):
    """Something that is not plain data: what kind of thing it is, and the name of its type."""

    kind: str
    type_name: str


class Built(NamedTuple):
    """An input that is no plain data itself: what it is, and the plain data that it is made of (course.given builds it)."""

    kind: str
    data: Plain


class Refusal(NamedTuple):
    """What is expected of an answer whose input is to be refused: the built-in error, and a number that its message must name.

    `names` is "" where any message will do.
    """

    error: str
    names: str = ""


class TimeUp(BaseException):
    """Raised inside an answer that takes too long; not an Exception, so that `except Exception` does not swallow it."""


class _TooMuchError(Exception):
    """There is more in a value than an answer may hold; the argument is the kind of `Odd` that it is."""


class _Room:
    """How many elements a value may still have, all its parts together: a list may hold itself a thousand times."""

    def __init__(self) -> None:
        self.left = MAX_ELEMENTS

    def take(self, count: int) -> None:
        self.left -= count
        if self.left < 0:
            raise _TooMuchError("too_big")


def plain(value: object, depth: int = 0) -> Plain:
    """Return `value` as plain data; rectangular lists and tuples of numbers become arrays."""
    try:
        with np.errstate(all="ignore"):
            return _stripped(value, depth, _Room())
    except _TooMuchError as error:
        return Odd(str(error), type_name(value))


def type_name(value: object) -> str:
    """Return the name of the type of `value`."""
    return class_name(type(value))


def class_name(kind: type) -> str:
    """Return the name of a class, which may be a hostile one."""
    return plain_text(_NAME.__get__(kind), 80)


def plain_text(value: object, longest: int = MAX_TEXT) -> str:
    """Return str(value), shortened, as nothing but text; "" where that fails."""
    try:
        return str.__getitem__(str(value), slice(longest))
    except TimeUp:
        raise
    except BaseException:
        return ""


def _stripped(value: object, depth: int, room: _Room) -> Plain:
    kind = type(value)
    if value is None or kind is bool or kind is float:
        return value
    if kind is int:
        return _whole(value)
    if kind is str:
        return value[:MAX_TEXT]  # type: ignore[index]
    if depth > MAX_DEPTH:
        raise _TooMuchError("too_deep")
    if kind is np.ndarray:
        return _plain_array(value, room)  # type: ignore[arg-type]
    if kind in _NUMPY_SCALARS:
        return _plain_array(np.asarray(value), room)
    # of the type, not isinstance: a value may lie about its class
    if issubclass(kind, list):
        return _plain_sequence(list.__iter__(value), list.__len__(value), depth, room)  # type: ignore[arg-type]
    if issubclass(kind, tuple):
        return _plain_sequence(tuple.__iter__(value), tuple.__len__(value), depth, room)  # type: ignore[arg-type]
    if issubclass(kind, dict):
        return _plain_dict(value, depth, room)  # type: ignore[arg-type]
    return _plain_symbolic(value, depth, room)


def numeric(value: Plain) -> np.ndarray | None:
    """Return plain data as an array if it is numbers or truth values all through, else None."""
    kind = type(value)
    if kind is np.ndarray:
        array: np.ndarray = value
        return array if array.dtype.kind in "biuf" else None
    if kind is bool or kind is float:
        return np.asarray(value)
    if kind is int:
        return np.asarray(_whole(value))
    return None


def fresh(value: Plain) -> Plain:
    """Return a copy that can be written to, so that an answer cannot reach the original."""
    if isinstance(value, np.ndarray):
        return value.copy()
    if isinstance(value, list):
        return [fresh(item) for item in value]
    if isinstance(value, dict):
        return {key: fresh(item) for key, item in value.items()}
    return value


def as_given(value: object) -> Plain:
    """Return an input as it stands, lists as lists, so that it can be compared with what was handed over."""
    try:
        return _standing(value, 0, _Room())
    except _TooMuchError as error:
        return Odd(str(error), type_name(value))


def _standing(value: object, depth: int, room: _Room) -> Plain:
    if depth > MAX_DEPTH:
        raise _TooMuchError("too_deep")
    if type(value) is list:
        room.take(1 + len(value))
        return [_standing(item, depth + 1, room) for item in value]
    if type(value) is dict and all(type(key) is str for key in value):
        room.take(1 + len(value))
        return {key: _standing(item, depth + 1, room) for key, item in value.items()}
    return _stripped(value, depth, room)


def identical(a: Plain, b: Plain) -> bool:
    """Are the two plain values the same to the bit, types and shapes included?"""
    if type(a) is not type(b):
        return False
    if isinstance(a, Built):
        return a.kind == b.kind and identical(a.data, b.data)
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, list):
        return len(a) == len(b) and all(map(identical, a, b))
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(identical(a[key], b[key]) for key in a)
    if isinstance(a, float):
        # NaN is not equal to itself, but it has not changed
        return a.hex() == b.hex()
    return bool(a == b)


def _whole(value: Any) -> int | float:
    """Return a Python integer; one beyond 64 bits as the nearest float."""
    if -(2**63) <= value < 2**63:
        return int(value)
    try:
        return float(value)
    except OverflowError:
        return float("inf")


def _plain_array(array: np.ndarray, room: _Room) -> Plain:
    if array.dtype.kind == "O":
        return Odd("object_array", "ndarray")
    if array.dtype.kind == "c":
        return Odd("complex", "complex")
    if array.dtype.kind not in "biuf":
        return Odd("array_of", str(array.dtype)[:80])
    room.take(array.size)
    # a long double: eight bytes are what crosses; by its character, which leaves byte order and metadata behind
    dtype = np.float64 if array.dtype.char == "g" else np.dtype(array.dtype.char)
    copy = np.empty(array.shape, dtype)
    copy[...] = array
    return copy


def _plain_sequence(items: Iterable[object], length: int, depth: int, room: _Room) -> Plain:
    room.take(1 + length)
    values = list(items)
    kinds = set(map(type, values))
    if kinds <= {float, int} or kinds == {bool}:
        return _array_of_scalars(values)
    parts = [_stripped(value, depth + 1, room) for value in values]
    arrays = [numeric(part) for part in parts]
    if all(array is not None for array in arrays) and len({array.shape for array in arrays}) == 1:  # type: ignore[union-attr]
        return np.stack(arrays)  # type: ignore[arg-type]
    return parts


def _array_of_scalars(values: list[Any]) -> np.ndarray:
    if not values:
        return np.zeros(0)
    array = np.array(values)
    # integers beyond 64 bits make an object array
    return np.array([float(_whole(value)) for value in values]) if array.dtype.kind == "O" else array


def _plain_dict(value: dict[Any, Any], depth: int, room: _Room) -> Plain:
    items = list(dict.items(value))
    room.take(1 + len(items))
    if not all(type(key) is str for key, _ in items):
        return Odd("dict_keys", type_name(value))
    return {key[:MAX_TEXT]: _stripped(item, depth + 1, room) for key, item in items}


def _plain_symbolic(value: Any, depth: int, room: _Room) -> Plain:
    """SymPy's numbers count as numbers, its columns as tuples; everything else is odd."""
    sympy, kind = sys.modules.get("sympy"), type(value)
    if sympy is not None and issubclass(kind, sympy.MatrixBase):
        rows = value.tolist()
        return _stripped([row[0] for row in rows] if value.shape[1] == 1 else rows, depth + 1, room)
    if sympy is not None and issubclass(kind, sympy.Expr):
        return _symbolic_number(value)
    return Odd(_kind_of(value), type_name(value))


def _symbolic_number(expression: Any) -> Plain:
    if expression.free_symbols:
        return Odd("symbols", ", ".join(sorted(str(symbol) for symbol in expression.free_symbols))[:80])
    try:
        return float(expression)
    except (TypeError, ValueError, OverflowError):
        return Odd("symbolic", type_name(expression))


def _kind_of(value: object) -> str:
    kind = type(value)
    if issubclass(kind, np.ma.MaskedArray):
        return "masked"
    if issubclass(kind, np.ndarray):
        return "array_subclass"
    if issubclass(kind, complex):
        return "complex"
    if issubclass(kind, type):
        return "class"
    if callable(value):
        return "function"
    if hasattr(kind, "__next__"):
        return "iterator"
    return "other"
