"""Values that students hand back, by accident or on purpose, which are no plain numbers: shared by the tests of everything that reads
an answer. Each entry makes one out of the right numbers, so that whatever believes the value instead of its data is caught.
"""

import collections
import decimal
import fractions
import itertools

import numpy as np


def always(result):
    def method(*_, **__):
        return result

    return method


YES = ("__eq__", "__ne__", "__lt__", "__le__", "__gt__", "__ge__", "__bool__", "__contains__")
OPERATORS = ("__sub__", "__rsub__", "__abs__", "__neg__", "__mul__", "__rmul__", "__mod__", "__rmod__", "__add__", "__radd__")


def liar(base, **more):
    """A subclass for which every comparison holds and every difference is zero."""
    return type("Liar", (base,), {name: always(True) for name in YES} | {name: always(0.0) for name in OPERATORS} | more)


class LyingArray(np.ndarray):
    def __array_ufunc__(self, ufunc, method, *inputs, **_):
        shape = next(np.shape(one) for one in inputs if type(one) is not LyingArray) if len(inputs) > 1 else self.shape
        return np.zeros(shape) if ufunc not in {np.less_equal, np.isfinite, np.equal} else np.ones(shape, dtype=bool)

    def __array_function__(self, *_):
        return True

    def all(self, *_, **__):
        return True


class Duck:
    """Whoever asks for an array gets the right one."""

    def __init__(self, right):
        self.right = right
        self.shape, self.dtype, self.ndim, self.size = right.shape, right.dtype, right.ndim, right.size

    def __array__(self, dtype=None, copy=None):
        return np.array(self.right)

    def __len__(self):
        return len(self.right)

    def __iter__(self):
        return iter(self.right)

    def __getitem__(self, index):
        return self.right[index]


class Interface:
    def __init__(self, right):
        self.right = right
        self.__array_interface__ = right.__array_interface__


class Floaty:
    def __init__(self, value):
        self.value = value

    def __float__(self):
        return float(self.value)

    __index__ = __int__ = __float__


class TwoFaced(list):
    """A list whose true items are wrong, but which shows the right ones to everyone who asks it."""

    def __init__(self, right):
        super().__init__([0.0] * len(right))
        self.right = right

    def __iter__(self):
        return iter(self.right)

    def __getitem__(self, index):
        return self.right[index]

    def __eq__(self, other):
        return True

    __hash__ = None


class TwoFacedTuple(tuple):
    __slots__ = ()

    def __iter__(self):
        return itertools.repeat(7.0, 3)

    def __eq__(self, other):
        return True

    def __hash__(self):
        return 0


def classy(claimed):
    """An object that says it is of the class `claimed`."""
    return type("Claimed", (Duck,), {"__class__": property(always(claimed))})


def objects(right):
    array = np.empty(len(right), dtype=object)
    array[:] = list(right)
    return array


def self_containing():
    items = []
    items.append(items)
    return items


def self_multiplying():
    items = []
    items.extend([items] * 1000)
    return items


def self_named():
    names = {}
    names["self"] = names
    return names


#: none of these is an answer, even though most of them hold or show the right numbers
IMPOSTORS = {
    "ndarray subclass": lambda right: right.view(LyingArray),
    "ndarray subclass, wrong numbers": lambda right: np.zeros(right.shape).view(LyingArray),
    "masked array": np.ma.masked_array,
    "masked array, nothing to see": lambda right: np.ma.masked_array(right, mask=True),
    "matrix": lambda right: right.view(np.matrix),
    "record array": lambda right: np.rec.fromarrays([right]),
    "object array": objects,
    "object array of liars": lambda right: objects([liar(float)(0)] * len(right)),
    "structured array": lambda right: np.zeros(len(right), dtype=[("a", float)]),
    "array of text": lambda right: np.array(list(map(str, right))),
    "array of bytes": lambda right: np.array(list(map(str, right)), dtype="S"),
    "times": lambda right: right.astype("datetime64[s]"),
    "complex array": lambda right: right.astype(complex),
    "complex numbers": lambda right: list(map(complex, right)),
    "floats that lie": lambda right: list(map(liar(float), right)),
    "floats that lie, wrong numbers": lambda right: [liar(float)(0.0)] * len(right),
    "ints that lie": lambda right: [liar(int)(0)] * len(right),
    "NumPy floats that lie": lambda right: list(map(liar(np.float64), right)),
    "NumPy floats that claim to be NumPy's": lambda right: list(map(liar(np.float64, __module__="numpy"), right)),
    "texts that lie": lambda right: list(map(liar(str), map(str, right))),
    "a list with two faces": TwoFaced,
    "a tuple with two faces": lambda right: TwoFacedTuple([0.0] * len(right)),
    "equal to everything": lambda right: liar(object)(),
    "equal to everything, each": lambda right: [liar(object)()] * len(right),
    "duck with __array__": Duck,
    "duck with __array_interface__": Interface,
    "__float__ in a list": lambda right: list(map(Floaty, right)),
    "claims to be an array": classy(np.ndarray),
    "claims to be a list": classy(list),
    "claims to be a float": classy(float),
    "claims to be a dict": classy(dict),
    "decimals": lambda right: list(map(decimal.Decimal, right)),
    "fractions": lambda right: list(map(fractions.Fraction, right)),
    "text": lambda right: str(right.tolist()),
    "texts": lambda right: list(map(str, right)),
    "bytes": lambda right: right.tobytes(),
    "memoryview": memoryview,
    "set": lambda right: set(right.tolist()),
    "deque": lambda right: collections.deque(right.tolist()),
    "dict": lambda right: dict(zip("xyt", right.tolist(), strict=False)),
    "dict by number": lambda right: dict(enumerate(right.tolist())),
    "generator": lambda right: (value for value in right.tolist()),
    "iterator": lambda right: iter(right.tolist()),
    "map": lambda right: map(float, right),
    "range": lambda right: range(len(right)),
    "function": lambda right: lambda: right,
    "class": lambda right: float,
    "None": always(None),
    "Nones": lambda right: [None] * len(right),
    "Ellipsis": always(...),
    "NotImplemented": always(NotImplemented),
    "NaN": lambda right: right * np.nan,
    "one NaN": lambda right: np.where(np.arange(len(right)) == 0, np.nan, right),
    "inf": lambda right: right + np.inf,
    "one minus inf": lambda right: np.where(np.arange(len(right)) == 0, -np.inf, right),
    "NaN in a list": lambda right: [float("nan")] * len(right),
    "truth values": lambda right: [True] * len(right),
    "array of truth values": lambda right: right != 0,
    "shape (1, 3)": lambda right: right[np.newaxis],
    "shape (3, 1)": lambda right: right[:, np.newaxis],
    "list in a list": lambda right: [right.tolist()],
    "lists of one": lambda right: [[value] for value in right.tolist()],
    "array of one in a list": lambda right: [np.array([value]) for value in right],
    "ragged": lambda right: [right[:1].tolist(), right[1:].tolist()],
    "empty array": lambda right: np.zeros(0),
    "empty, but wide": lambda right: np.zeros((0, len(right))),
    "empty list": always([]),
    "empty tuple": always(()),
    "empty dict": always({}),
    "a single number": lambda right: float(right[0]),
    "one too many": lambda right: [*right, 0.0],
    "one too few": lambda right: right[:-1],
    "broadcast": lambda right: np.broadcast_to(right, (2, len(right))),
    "too big to copy": lambda right: np.broadcast_to(right[0], (10**12,)),
    "many that are too big together": lambda right: [np.broadcast_to(right[0], (10**6,))] * 100,
    "huge int": lambda right: [10**400] * len(right),
    "huge float": lambda right: [1e308] * len(right),
    "contains itself": lambda right: self_containing(),
    "contains itself a thousand times": lambda right: self_multiplying(),
    "contains itself in a dict": lambda right: self_named(),
    "nested deeply": lambda right: [[[[[[[[[[[[right[0]]]]]]]]]]]]],
}


class RaisesWhenHashed(type):
    def __hash__(cls):
        raise ValueError("no hash")


class RaisesWhenNamed(type):
    @property
    def __name__(cls):
        raise ValueError("no name")

    __mro__ = __name__

    def __getattr__(cls, name):
        raise ValueError(name)


class RaisesWhenSeen:
    """Everything that can be asked of it raises what is no Exception."""

    def __getattribute__(self, name):
        raise SystemExit(name)

    __len__ = __iter__ = __repr__ = __str__ = __hash__ = __bool__ = __eq__ = __float__ = __array__ = __next__ = __getattribute__


def loop(*_, **__):
    while True:
        pass


class LoopsWhenSeen:
    __len__ = __iter__ = __repr__ = __str__ = __bool__ = __eq__ = __float__ = __array__ = loop
    __class__ = property(loop)


class Loops(type):
    __hash__ = __instancecheck__ = loop


class RecursesWhenSeen:
    def __getattr__(self, name):
        return getattr(self, f"{name}_")


#: these break, or never end, when they are looked at
TRAPS = {
    "raises when seen": lambda right: RaisesWhenSeen(),
    "raises when seen, in a list": lambda right: [RaisesWhenSeen()] * 3,
    "raises when seen, in a dict": lambda right: {"x": RaisesWhenSeen()},
    "raises when hashed": lambda right: RaisesWhenHashed("C", (), {})(),
    "raises when hashed, in a list": lambda right: [RaisesWhenHashed("C", (), {})()],
    "raises when named": lambda right: RaisesWhenNamed("C", (), {})(),
    "raises when named, a class": lambda right: RaisesWhenNamed("C", (), {}),
    "raises when called for its class": lambda right: type("C", (), {"__class__": property(lambda self: 1 / 0)})(),
    "recurses when seen": lambda right: RecursesWhenSeen(),
    "loops when seen": lambda right: LoopsWhenSeen(),
    "loops when seen, in a list": lambda right: [LoopsWhenSeen()],
    "loops when hashed, in a list": lambda right: [Loops("C", (), {})()],
}
