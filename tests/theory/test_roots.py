"""Roots of rising functions: found to the last bits, element by element, and never outside the bounds."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gasbox.theory.roots import rising_root


@given(st.floats(-30.0, 30.0))
def test_an_exponential_where_newton_alone_would_overshoot(level):
    root = rising_root(lambda x: (np.exp(x) - math.exp(level), np.exp(x)), -40.0, 40.0)
    assert root == pytest.approx(level, abs=2e-15 * max(1.0, abs(level)))


@pytest.mark.small
def test_slopes_that_mislead_only_cost_time():
    # The slope is a thousand times too flat, so that every Newton step leaves the bounds.
    assert rising_root(lambda x: (x**3 - 2.0, 0.003 * x * x), 1.0, 2.0) == pytest.approx(
        2 ** (1 / 3), rel=2e-15
    )


@pytest.mark.small
def test_each_element_has_its_own_root():
    squares = np.array([[1.0, 4.0], [9.0, 2.0]])
    roots = rising_root(lambda x: (x * x - squares, 2 * x), 0.5 * np.ones((2, 2)), 4 * np.ones((2, 2)))
    np.testing.assert_allclose(roots, np.sqrt(squares), rtol=1e-15)


@pytest.mark.small
def test_without_a_root_the_nearer_bound():
    assert rising_root(lambda x: (x + 5.0, 1.0), 0.0, 1.0) == pytest.approx(0.0, abs=1e-15)
    assert rising_root(lambda x: (x - 5.0, 1.0), 0.0, 1.0) == 1.0
