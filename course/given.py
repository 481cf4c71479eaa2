"""Inputs that are no plain data themselves: robots, files, integrands.

They cross as what they are made of, and are built where the answer is called.
"""

import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from course.plain import Built, Plain, fresh
from course.robots import Robot

#: a folder in memory, where the system has one: making and removing files on a busy disk takes longer than reading them
_IN_MEMORY = "/dev/shm"  # noqa: S108 - each file gets a private folder in it


def built_robot(robot: Robot) -> Built:
    """Return a robot as an input."""
    return Built("robot", asdict(robot))


def built_file(content: bytes, name: str = "log.dat") -> Built:
    """Return a file as an input: the answer gets the path of a file with this content."""
    return Built("file", {"name": name, "content": np.frombuffer(content, np.uint8)})


def built_integrand(powers: Sequence[float], waves: Sequence[tuple[float, float, float]] = ()) -> Built:
    """Return a function f as an input: f(x) = sum of powers[k] x^k + sum of a sin(b x + c) over the waves (a, b, c)."""
    return Built("integrand", {"powers": np.array(powers, float), "waves": np.array(waves, float).reshape(-1, 3)})


class Integrand:
    """A function of one variable; numbers give a number, arrays an array of their shape."""

    def __init__(self, powers: np.ndarray, waves: np.ndarray) -> None:
        """See `built_integrand`."""
        self._powers, self._waves = powers, waves

    def __call__(self, x: Any) -> Any:
        """Return f(x)."""
        at = np.asarray(x, dtype=float)
        value = np.zeros_like(at)
        for power in self._powers[::-1]:
            value = value * at + power
        for amplitude, rate, phase in self._waves:
            value = value + amplitude * np.sin(rate * at + phase)
        return value if isinstance(x, np.ndarray) else float(value) if at.ndim == 0 else value

    def __repr__(self) -> str:
        terms = [f"{power:.6g}" + ("", " x", f" x^{k}")[min(k, 2)] for k, power in enumerate(self._powers) if power]
        terms += [f"{a:.6g} sin({b:.6g} x + {c:.6g})" for a, b, c in self._waves]
        return "f(x) = " + (" + ".join(terms) or "0")


@contextmanager
def handed_over(args: Sequence[Plain]) -> Iterator[list[Any]]:
    """Hand over what an answer is called with: copies that it may write to, and what is to be built. Files are gone afterwards."""
    with ExitStack() as stack:
        yield [_built(arg.kind, arg.data, stack) if isinstance(arg, Built) else fresh(arg) for arg in args]


def _built(kind: str, data: Mapping[str, Plain], stack: ExitStack) -> object:
    if kind == "robot":
        return Robot(**data)
    if kind == "integrand":
        return Integrand(data["powers"].copy(), data["waves"].copy())
    if kind == "file":
        # one that cannot be removed any more, because the answer did something odd with it, is no reason to fail
        where = _IN_MEMORY if os.access(_IN_MEMORY, os.W_OK) else None
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="given-", dir=where, ignore_cleanup_errors=True))
        path = Path(folder) / data["name"]
        path.write_bytes(data["content"].tobytes())
        return path
    raise ValueError(f"nothing is built as {kind!r}")


def shown_built(built: Built) -> str:
    """Return in one line what is handed over, for a reader."""
    if built.kind == "integrand":
        return repr(Integrand(**built.data))
    if built.kind == "file":
        text = built.data["content"].tobytes().decode(errors="replace")
        lines = text.splitlines()
        return (
            f"a file of {len(lines)} lines: " + " | ".join(line[:60] for line in lines[:4]) + (" | …" if len(lines) > 4 else "")
        )
    return f"{built.kind} {built.data}"
