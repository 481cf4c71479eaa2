"""Judging undisturbed: what a notebook in this process did to Python's and NumPy's functions and warnings is undone meanwhile.

It keeps an accident, such as `np.all = ...` or `np.seterr(all="raise")`, from deciding a verdict. It is no wall against intent: that
is the sandbox, where answer and judge share nothing.
"""

import builtins
import cmath
import contextlib
import math
import warnings
from collections.abc import Iterator
from typing import Any

import numpy as np

#: the names in each module, now and as they were when the course was imported, before any answer ran
_MODULES = [(module.__dict__, dict(module.__dict__)) for module in (builtins, math, cmath, np, np.linalg, np.random)]


class _Originals:
    """Puts back the functions that were replaced; at the end, the replacements. It calls nothing that may have been replaced."""

    def __enter__(self) -> None:
        self._replaced: list[tuple[dict[str, Any], str, Any]] = []
        for names, originals in _MODULES:
            for name in originals:
                now = names.get(name)
                if now is not originals[name]:
                    self._replaced += [(names, name, now)]
                    names[name] = originals[name]

    def __exit__(self, *_: object) -> None:
        for names, name, replacement in self._replaced:
            names[name] = replacement


@contextlib.contextmanager
def undisturbed() -> Iterator[None]:
    """Judge with Python and NumPy as they were imported, with no warning and no floating-point error raised."""
    with _Originals(), calm():
        yield


@contextlib.contextmanager
def calm() -> Iterator[None]:
    """Judge with no warning and no floating-point error raised: enough where no notebook runs in this process."""
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        yield
