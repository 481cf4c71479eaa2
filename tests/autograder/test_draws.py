"""Drawn inputs keep clear of the places where right and wrong look alike."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from autograder.draws import heading, magnitudes, pose, until

seeds = st.integers(0, 2**32).map(np.random.default_rng)


@given(seeds, st.floats(0.1, 10), st.floats(0.1, 10), st.integers(0, 50))
def test_magnitudes_keep_clear_of_zero(rng, low, width, size):
    values = magnitudes(rng, low, low + width, size)
    assert values.shape == (size,)
    assert np.all((np.abs(values) >= low) & (np.abs(values) <= low + width))
    single = magnitudes(rng, low, low + width)
    assert type(single) is float
    assert low <= abs(single) <= low + width


def test_magnitudes_have_either_sign():
    values = magnitudes(np.random.default_rng(0), 1.0, 2.0, 1000)
    assert 400 < np.sum(values > 0) < 600


@given(seeds)
def test_headings_keep_clear_of_axes_and_diagonals(rng):
    for _ in range(20):
        theta = heading(rng)
        assert type(theta) is float
        assert abs(theta) <= 2 * np.pi
        eighths = theta / (np.pi / 4)
        assert abs(eighths - round(eighths)) * np.pi / 4 > 0.2


def test_headings_lie_in_every_eighth_of_two_turns():
    rng = np.random.default_rng(0)
    assert {int(np.floor(heading(rng) / (np.pi / 4))) for _ in range(1000)} == set(range(-8, 8))


@given(seeds)
def test_poses_keep_clear_of_the_origin(rng):
    x, y, theta = pose(rng)
    assert 0.5 <= abs(x) <= 3
    assert 0.5 <= abs(y) <= 3
    assert abs(np.sin(2 * theta)) > 0.3


def test_the_same_generator_draws_the_same():
    one, same, other = (pose(np.random.default_rng(seed)) for seed in (1, 1, 2))
    assert np.array_equal(one, same)
    assert not np.array_equal(one, other)


def test_drawing_goes_on_until_it_tells():
    numbers = iter(range(100))
    assert until(lambda: (next(numbers), 1), lambda number, one: number * one > 10) == (11, 1)


def test_drawing_gives_up_in_words():
    drawn = []
    with pytest.raises(RuntimeError, match="no telling inputs in 1000 draws"):
        until(lambda: drawn.append(1) or (1,), lambda _: False)
    assert len(drawn) == 1000
