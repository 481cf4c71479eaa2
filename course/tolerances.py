"""How close is right. Every tolerance of the course lives in this module."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

RELATIVE = 1e-5
ABSOLUTE = 1e-9
ANGLE = 1e-5


@dataclass(frozen=True)
class Tolerance:
    """|error| <= absolute + relative * (largest expected magnitude of the same quantity).

    `axis` is the axis of the answer along which different quantities lie side by side (x, y and theta of a pose); None: all
    entries are one quantity. The entries `angles` along that axis are compared modulo 2 pi, within 1e-5 rad. The first `skip`
    rows of a sequence are not compared at all. `double`: an array must be of float64.
    """

    axis: int | None = None
    angles: tuple[int, ...] = ()
    absolute: float = ABSOLUTE
    relative: float = RELATIVE
    skip: int = 0
    double: bool = False

    def quantities_right(self, given: np.ndarray, expected: np.ndarray) -> np.ndarray:
        """Return for each quantity whether all of it is right, (k,) of bool."""
        return np.all(self.entries_right(given, expected), axis=1)

    def entries_right(self, given: np.ndarray, expected: np.ndarray) -> np.ndarray:
        """Return for each entry whether it is right, (k, n) of bool. Both arrays have the same shape; NaN is never right."""
        right = self.by_quantity(expected)
        errors = np.abs(self.by_quantity(given) - right)
        limits = self.absolute + self.relative * np.abs(right).max(axis=1, initial=0.0, keepdims=True)
        # answers of too few quantities are compared too, with mistakes that leave out as many
        for row in (angle for angle in self.angles if angle < len(errors)):
            errors[row] = np.minimum(errors[row] % (2 * np.pi), -errors[row] % (2 * np.pi))
            limits[row] = ANGLE
        errors[:, : self.skip] = 0
        return errors <= limits

    def by_quantity(self, values: np.ndarray) -> np.ndarray:
        """Return the values as (k, n) of float64: a row for each quantity."""
        values = np.asarray(values, dtype=np.float64)
        if self.axis is None or values.ndim == 0:
            return values.reshape(1, -1)
        if self.axis == -1:
            # the number of rows is written out: -1 stands for none where a row is empty
            return values.reshape(math.prod(values.shape[:-1]), values.shape[-1]).T
        rows = np.moveaxis(values, self.axis, 0)
        return rows.reshape(rows.shape[0], -1)


@dataclass(frozen=True)
class RecordTolerance:
    """For an answer that is a dict: the tolerance of each of its entries. Entries that are not named here are not looked at."""

    entries: tuple[tuple[str, Tolerance], ...]

    def quantities_right(self, given: Mapping[str, Any], expected: Mapping[str, Any]) -> np.ndarray:
        """Return for each entry whether all of it is right, (k,) of bool. The entries have the expected shapes."""
        return np.array([tolerance.quantities_right(given[key], expected[key]).all() for key, tolerance in self.entries])


#: numbers, or a sequence, of one quantity
ONE_QUANTITY = Tolerance()
#: (k,) or (N, k): a pose, a trajectory, a matrix by its columns
LAST_AXIS = Tolerance(axis=-1)
#: (k,) or (k, N): a pair of numbers or of arrays, such as (V, omega)
FIRST_AXIS = Tolerance(axis=0)
#: time stamps [s]: Unix seconds in float32 are wrong by a minute
STAMPS = Tolerance(absolute=1e-6, relative=0.0)
