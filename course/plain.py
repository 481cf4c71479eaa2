"""Plain data: what an answer gives back, stripped of everything that could act.

A value is turned into numbers, text, NumPy arrays of exact type, lists and dictionaries before anyone compares it, so that
subclasses, masks, objects and comparison tricks are gone by then. What cannot be stripped becomes an `Odd`, which equals nothing.
"""

import sys
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

MAX_ELEMENTS = 5_000_000
MAX_TEXT = 20_000
MAX_DEPTH = 8

#: None, bool, int, float, str, numpy.ndarray (of kind b, i, u, f), list and dict of these, or Odd
Plain = Any


class Odd(NamedTuple):
    """Something that is not plain data: what kind of thing it is, and the name of its type."""

    kind: str
    type_name: str


def plain(value: object, depth: int = 0) -> Plain:
    """Return `value` as plain data; rectangular lists and tuples of numbers become arrays."""
    kind = type(value)
    if value is None or kind is bool or kind is float:
        return value
    if kind is int:
        return value if -(2**63) <= value < 2**63 else _huge(value)  # type: ignore[operator]
    if kind is str:
        return value[:MAX_TEXT]  # type: ignore[index]
    if depth > MAX_DEPTH:
        return Odd("too_deep", _type_name(value))
    if kind is np.ndarray:
        return _plain_array(value)  # type: ignore[arg-type]
    if isinstance(value, np.generic) and kind.__module__ == "numpy":
        return _plain_array(np.asarray(value))
    if isinstance(value, list):
        return _plain_sequence(list.__iter__(value), list.__len__(value), depth)
    if isinstance(value, tuple):
        return _plain_sequence(tuple.__iter__(value), tuple.__len__(value), depth)
    if isinstance(value, dict):
        return _plain_dict(value, depth)
    return _plain_symbolic(value, depth)


def numeric(value: Plain) -> np.ndarray | None:
    """Return plain data as an array if it is numbers or truth values all through, else None."""
    if isinstance(value, np.ndarray):
        return value
    if isinstance(value, bool | int | float):
        return np.asarray(value)
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
    if isinstance(value, list):
        return [as_given(item) for item in value]
    if isinstance(value, dict):
        return {str(key): as_given(item) for key, item in value.items()}
    return plain(value)


def identical(a: Plain, b: Plain) -> bool:
    """Are the two plain values the same to the bit, types and shapes included?"""
    if type(a) is not type(b):
        return False
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, list):
        return len(a) == len(b) and all(map(identical, a, b))
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(identical(a[key], b[key]) for key in a)
    return bool(a == b)


def _type_name(value: object) -> str:
    return type(value).__name__[:80]


def _huge(value: object) -> Plain:
    try:
        return float(value)  # type: ignore[arg-type]
    except OverflowError:
        return float("inf")


def _plain_array(array: np.ndarray) -> Plain:
    if array.dtype.kind == "O":
        return Odd("object_array", "ndarray")
    if array.dtype.kind == "c":
        return Odd("complex", "complex")
    if array.dtype.kind not in "biuf":
        return Odd("array_of", str(array.dtype)[:80])
    if array.size > MAX_ELEMENTS:
        return Odd("too_big", "ndarray")
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:  # a long double: eight bytes are what crosses
        array = array.astype(np.float64)
    return np.array(array, dtype=array.dtype.newbyteorder("="), order="C", copy=True)


def _plain_sequence(items: Iterable[object], length: int, depth: int) -> Plain:
    if length > MAX_ELEMENTS:
        return Odd("too_big", "list")
    values = list(items)
    kinds = set(map(type, values))
    if kinds <= {float} or kinds in ({int}, {bool}):
        return _array_of_scalars(values)
    parts = [plain(value, depth + 1) for value in values]
    arrays = [numeric(part) for part in parts]
    if all(array is not None for array in arrays) and len({array.shape for array in arrays}) == 1:  # type: ignore[union-attr]
        return np.stack(arrays)  # type: ignore[arg-type]
    return parts


def _array_of_scalars(values: list[Any]) -> np.ndarray:
    if not values:
        return np.zeros(0)
    array = np.array(values)
    # integers beyond 64 bits make an object array
    return np.array([_huge(value) for value in values]) if array.dtype.kind == "O" else array


def _plain_dict(value: Mapping[Any, Any], depth: int) -> Plain:
    items: Iterable[tuple[Any, Any]] = list(dict.items(value))  # type: ignore[arg-type]
    if not all(type(key) is str for key, _ in items):
        return Odd("dict_keys", _type_name(value))
    return {key[:MAX_TEXT]: plain(item, depth + 1) for key, item in items}


def _plain_symbolic(value: object, depth: int) -> Plain:
    """SymPy's numbers count as numbers, its columns as tuples; everything else is odd."""
    sympy = sys.modules.get("sympy")
    if sympy is not None and isinstance(value, sympy.MatrixBase):
        rows = value.tolist()
        return plain([row[0] for row in rows] if value.shape[1] == 1 else rows, depth + 1)
    if sympy is not None and isinstance(value, sympy.Expr):
        return _symbolic_number(value)
    return Odd(_kind_of(value), _type_name(value))


def _symbolic_number(expression: Any) -> Plain:
    if expression.free_symbols:
        return Odd("symbols", ", ".join(sorted(str(symbol) for symbol in expression.free_symbols))[:80])
    try:
        return float(expression)
    except (TypeError, ValueError, OverflowError):
        return Odd("symbolic", _type_name(expression))


def _kind_of(value: object) -> str:
    if isinstance(value, np.ma.MaskedArray):
        return "masked"
    if isinstance(value, np.ndarray):
        return "array_subclass"
    if isinstance(value, complex):
        return "complex"
    if isinstance(value, type):
        return "class"
    if callable(value):
        return "function"
    if hasattr(type(value), "__next__"):
        return "iterator"
    return "other"
