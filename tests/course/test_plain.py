"""What becomes of a value before anyone compares it: numbers stay numbers, everything else equals nothing."""

import sys
from collections import OrderedDict, namedtuple

import numpy as np
import pytest
import sympy as sp
from hostile import IMPOSTORS, TRAPS, self_containing, self_multiplying
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from course import plain as module
from course.plain import MAX_DEPTH, MAX_TEXT, Odd, as_given, class_name, fresh, identical, numeric, plain, plain_text, type_name

RIGHT = np.array([1.25, -2.5, 3.0])
Pose = namedtuple("Pose", "x y theta")

HONEST = {
    "array": RIGHT,
    "list": [1.25, -2.5, 3.0],
    "list with an int": [1.25, -2.5, 3],
    "tuple": (1.25, -2.5, 3.0),
    "namedtuple": Pose(1.25, -2.5, 3.0),
    "subclass of list": type("Items", (list,), {})([1.25, -2.5, 3.0]),
    "float32": RIGHT.astype(np.float32),
    "float16": RIGHT.astype(np.float16),
    "long double": RIGHT.astype(np.longdouble),
    "big-endian": RIGHT.astype(">f8"),
    "with metadata": RIGHT.astype(np.dtype(float, metadata={"a": 1})),
    "reversed view": RIGHT[::-1].copy()[::-1],
    "column of a matrix": np.stack([RIGHT, RIGHT], axis=1)[:, 0],
    "read-only": np.broadcast_to(RIGHT, (3,)),
    "NumPy scalars": list(RIGHT),
    "mixed scalars": [np.float32(1.25), -2.5, np.int8(3)],
    "0-d arrays": [np.array(value) for value in RIGHT],
    "SymPy numbers": [sp.Rational(5, 4), sp.Float(-2.5), sp.Integer(3)],
    "SymPy column": sp.Matrix([1.25, -2.5, 3]),
}


@pytest.mark.parametrize("value", HONEST.values(), ids=HONEST)
def test_numbers_in_any_dress_are_an_array_of_their_own(value):
    result = plain(value)
    assert type(result) is np.ndarray
    assert result.shape == (3,)
    assert result.dtype.isnative
    assert result.dtype.metadata is None
    assert result.flags.writeable
    assert not np.shares_memory(result, RIGHT)
    assert np.array_equal(result.astype(float), RIGHT)


SCALARS = [True, False, 0, 7, -(2**63), 2**63 - 1, 0.5, -0.0, "", "text", None]


@pytest.mark.parametrize("value", SCALARS, ids=repr)
def test_plain_scalars_stay_as_they_are(value):
    assert plain(value) is value
    assert type(plain(value)) is type(value)


NUMPY_SCALARS = [
    np.float64(0.5),
    np.float32(0.5),
    np.float16(0.5),
    np.longdouble(0.5),
    np.int8(3),
    np.uint64(2**63),
    np.bool(True),
]


@pytest.mark.parametrize("value", [*NUMPY_SCALARS, np.array(0.5)], ids=repr)
def test_numpy_scalars_are_arrays_without_dimension(value):
    assert plain(value).shape == ()
    assert plain(value) == value


def parts(value):
    """Everything that a plain value is made of, lists and dictionaries as well."""
    yield value
    for item in value if type(value) is list else value.values() if type(value) is dict else ():
        yield from parts(item)


def is_plain(value):
    exact = {type(None), bool, int, float, str, Odd, list, dict, np.ndarray}
    return all(type(part) in exact and (type(part) is not np.ndarray or part.dtype.kind in "biuf") for part in parts(value))


@pytest.mark.parametrize("make", IMPOSTORS.values(), ids=IMPOSTORS)
def test_impostors_are_not_the_right_numbers_and_cannot_act(make):
    result = plain(make(RIGHT))
    assert is_plain(result)
    array = numeric(result)
    assert array is None or array.shape != (3,) or array.dtype.kind == "b" or not np.array_equal(array, RIGHT)


KINDS = [
    ("ndarray subclass", "array_subclass", "LyingArray"),
    ("masked array", "masked", "MaskedArray"),
    ("matrix", "array_subclass", "matrix"),
    ("object array", "object_array", "ndarray"),
    ("complex array", "complex", "complex"),
    ("times", "array_of", "datetime64[s]"),
    ("array of text", "array_of", "<U4"),
    ("dict by number", "dict_keys", "dict"),
    ("generator", "iterator", "generator"),
    ("function", "function", "function"),
    ("class", "class", "type"),
    ("set", "other", "set"),
    ("duck with __array__", "other", "Duck"),
    ("claims to be an array", "other", "Claimed"),
    ("too big to copy", "too_big", "ndarray"),
    ("many that are too big together", "too_big", "list"),
    ("contains itself", "too_deep", "list"),
    ("contains itself a thousand times", "too_deep", "list"),
    ("contains itself in a dict", "too_deep", "dict"),
]


@pytest.mark.parametrize(("label", "kind", "name"), KINDS)
def test_what_is_no_plain_data_is_called_by_its_kind(label, kind, name):
    assert plain(IMPOSTORS[label](RIGHT)) == Odd(kind, name)


ODD_PARTS = [
    ([1.0, "a"], [1.0, "a"]),
    ([1.0, None], [1.0, None]),
    ([1.0, 2j], [1.0, Odd("complex", "complex")]),
    (sp.Symbol("x") + sp.Symbol("y"), Odd("symbols", "x, y")),
    (sp.oo * sp.I, Odd("symbolic", "Mul")),
    ({1, 2}, Odd("other", "set")),
    (np.float64, Odd("class", "type")),
    (10**400, float("inf")),
    (2**64, float(2**64)),
]


@pytest.mark.parametrize(("value", "expected"), ODD_PARTS, ids=repr)
def test_odd_parts_stay_visible(value, expected):
    assert identical(plain(value), expected)


def test_ragged_lists_stay_lists_and_rectangular_ones_become_arrays():
    ragged = plain([[1.0, 2.0], [3.0]])
    assert [part.tolist() for part in ragged] == [[1.0, 2.0], [3.0]]
    assert plain([(1, 2), np.array([3.5, 4.0])]).tolist() == [[1.0, 2.0], [3.5, 4.0]]
    assert plain([]).shape == (0,)
    assert plain([[], []]).shape == (2, 0)


def test_dictionaries_keep_their_order_and_lose_their_class():
    result = plain(OrderedDict(y=(1, 2), x=np.float64(0.5)))
    assert type(result) is dict
    assert list(result) == ["y", "x"]
    assert result["y"].tolist() == [1, 2]


def test_texts_are_cut():
    assert len(plain("a" * (MAX_TEXT + 1))) == MAX_TEXT


def nested(depth):
    return [nested(depth - 1)] if depth else [1.0]


def test_depth_has_an_end():
    assert plain(nested(MAX_DEPTH)).shape == (1,) * (MAX_DEPTH + 1)
    assert plain(nested(MAX_DEPTH + 1)) == Odd("too_deep", "list")
    assert plain({"a": 1.0, "b": nested(MAX_DEPTH)}) == Odd("too_deep", "dict")
    assert as_given(nested(MAX_DEPTH + 1)) == Odd("too_deep", "list")


def test_all_parts_together_have_to_fit(monkeypatch):
    monkeypatch.setattr(module, "MAX_ELEMENTS", 100)
    assert plain(np.zeros((10, 10))).shape == (10, 10)
    assert plain(np.zeros((10, 11))) == Odd("too_big", "ndarray")
    assert plain([np.zeros(40), np.zeros(41)])[1].shape == (41,)
    assert plain([np.zeros(40), np.zeros(41), np.zeros(42)]) == Odd("too_big", "list")
    assert plain({"a": [0.0] * 60, "b": [0.0] * 60}) == Odd("too_big", "dict")
    assert as_given([[0.0] * 60, [0.0] * 60]) == Odd("too_big", "list")


NAMED = [label for label in TRAPS if "loops" not in label]


@pytest.mark.parametrize("label", NAMED)
def test_a_trap_has_a_name_and_no_text(label):
    trap = TRAPS[label](RIGHT)
    assert type(type_name(trap)) is str
    assert type(class_name(type(trap))) is str


def test_names_and_texts_are_nothing_but_text():
    sly = type("Sly", (str,), {"__getitem__": lambda *_: 7, "__len__": lambda _: 0, "__str__": lambda self: self})
    assert type(plain_text(sly("abc"))) is str
    assert plain_text(sly("abc"), 2) == "ab"
    assert plain_text(type("Mute", (), {"__str__": lambda self: 1 / 0})()) == ""
    sly_name = type("C", (), {})
    sly_name.__name__ = sly("Name")
    assert type(type_name(sly_name())) is str
    assert len(type_name(type("N" * 500, (), {})())) == 80


numbers = st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=5))
arrays = hnp.arrays(st.sampled_from([float, np.float32, int, bool, np.uint8]), hnp.array_shapes(min_dims=0, max_side=3))
values = st.recursive(
    numbers | arrays,
    lambda inner: st.lists(inner, max_size=4) | st.tuples(inner, inner) | st.dictionaries(st.text(max_size=3), inner, max_size=3),
    max_leaves=12,
)


@given(values)
def test_plain_data_is_plain_and_stays_as_it_is(value):
    once = plain(value)
    assert is_plain(once)
    if not any(isinstance(part, Odd) for part in parts(once)):
        assert identical(plain(once), once)
    array = numeric(once)
    if array is not None and array.dtype.kind == "f" and not isinstance(value, dict):
        assert np.allclose(array, np.array(value, dtype=float), equal_nan=True, rtol=1e-6)


@given(values.map(plain))
def test_a_fresh_copy_is_identical_and_apart(value):
    copy = fresh(value)
    assert identical(copy, value)
    for one, other in zip(parts(copy), parts(value), strict=True):
        if isinstance(one, np.ndarray):
            assert not np.shares_memory(one, other)
            assert one.flags.writeable
        if isinstance(one, list | dict):
            assert one is not other


@given(values.map(plain))
def test_an_untouched_input_stands_as_it_was(value):
    assert identical(as_given(fresh(value)), as_given(value))


CHANGES = [
    (1.0, 1.0 + 1e-15),
    (1.0, 1),
    (1, True),
    (0.0, None),
    ("1", 1),
    ([1.0, 2.0], [1.0]),
    ([1.0, 2.0], [1.0, 2.5]),
    ([1.0, 2.0], np.array([1.0, 2.0])),
    (np.array([1.0, 2.0]), np.array([1.0, 2.0], dtype=np.float32)),
    (np.array([1.0, 2.0]), np.array([[1.0, 2.0]])),
    (np.array([1, 2]), np.array([1, 3])),
    ({"t": [1.0]}, {"t": [2.0]}),
    ({"t": [1.0]}, {"t": [1.0], "u": 0}),
    ({"t": 1.0}, {"u": 1.0}),
]


@pytest.mark.parametrize(("before", "after"), CHANGES, ids=repr)
def test_every_change_shows(before, after):
    assert not identical(as_given(before), as_given(after))
    assert not identical(as_given(after), as_given(before))


SAME = [float("nan"), [float("nan"), 1.0], np.array([np.nan, np.inf]), {"t": np.arange(3), "n": 3, "of": [None, "a"]}]


@pytest.mark.parametrize("value", SAME, ids=repr)
def test_what_did_not_change_is_identical(value):
    assert identical(as_given(value), as_given(fresh(value)))


SPOILT = {
    "contains itself": self_containing(),
    "contains itself a thousand times": self_multiplying(),
    "keys that are no text": {1: 2.0},
    "a function": [1.0, print],
    "a subclass": type("Items", (list,), {})([1.0]),
}


@pytest.mark.parametrize("spoilt", SPOILT.values(), ids=SPOILT)
def test_an_input_that_was_spoilt_is_read_to_an_end(spoilt):
    assert is_plain(as_given(spoilt))
    assert not identical(as_given([1.0]), as_given(spoilt))


@pytest.mark.parametrize("value", [10**400, -(2**63) - 1, "1", None, [1.0], {}, Odd("other", "C"), np.array([None])])
def test_numeric_takes_numbers_only(value):
    array = numeric(value)
    assert (array is not None) == (type(value) is int)
    assert array is None or array.dtype.kind == "f"


@pytest.mark.parametrize("value", [3, -7, 2**63 - 1, 0.5, True, np.arange(3), np.array(2)])
def test_numeric_takes_all_numbers(value):
    assert np.array_equal(numeric(value), value)
    assert numeric(value).dtype == np.asarray(value).dtype


def test_numeric_believes_no_subclass():
    assert numeric(IMPOSTORS["ndarray subclass"](RIGHT)) is None
    assert numeric(IMPOSTORS["masked array"](RIGHT)) is None


def test_symbols_are_not_looked_for_where_sympy_is_not_loaded(monkeypatch):
    monkeypatch.delitem(sys.modules, "sympy")
    assert plain(sp.Symbol("x")) == Odd("other", "Symbol")
