"""Drawing inputs that can tell right from wrong: every exercise's cases are made of these."""

from collections.abc import Callable

import numpy as np


def magnitudes(rng: np.random.Generator, low: float, high: float, size: int | None = None) -> np.ndarray | float:
    """Return values of either sign whose magnitude lies in [low, high): never near zero."""
    values = rng.uniform(low, high, size) * rng.choice([-1.0, 1.0], size)
    return float(values) if size is None else values


def heading(rng: np.random.Generator) -> float:
    """Return a heading in rad of either sign, at least 0.2 rad from every axis and diagonal, where sin and cos say little."""
    eighth = rng.integers(-8, 8)
    return float((eighth + rng.uniform(0.26, 0.74)) * np.pi / 4)


def pose(rng: np.random.Generator) -> np.ndarray:
    """Return a pose (x, y, theta) away from the origin and from the axes, (3,)."""
    return np.array([magnitudes(rng, 0.5, 3.0), magnitudes(rng, 0.5, 3.0), heading(rng)])


def until(draw: Callable[[], tuple], telling: Callable[..., bool]) -> tuple:
    """Return the first of `draw`'s inputs for which `telling(*inputs)` holds: inputs that separate, not too close to a zero."""
    for _ in range(1000):
        inputs = draw()
        if telling(*inputs):
            return inputs
    raise RuntimeError("no telling inputs in 1000 draws")
