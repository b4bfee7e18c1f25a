"""The classroom rule sees collisions late, and approaches exact dynamics linearly as its step shrinks."""

import math

import pytest
from runs import measure, one_gas, settle

from gasbox.theory import hard_disc, kolafa_rottner

ETA, COUNT, COLLISIONS = 0.1, 256, 150_000
STEPS = (0.05, 0.025)
"""Time steps in units of a diameter over sqrt(T/m)."""


def excess_with(step, seed):
    """Z - 1 by the virial, and its standard error."""
    simulation = one_gas(COUNT, ETA, seed=seed, dynamics={"kind": "stepped", "time_step": step})
    settle(simulation)
    run = measure(simulation, COLLISIONS)
    excess = run.compressibility - 1
    return excess, 1.2 * excess / math.sqrt(run.collisions)


@pytest.fixture(scope="module")
def measured():
    return {step: excess_with(step, seed) for seed, step in enumerate(STEPS)}


def exact():
    return hard_disc.finite_compressibility(ETA, COUNT) - 1


def slope():
    """d ln(Z - 1)/d step, -sqrt(pi) v/sigma d ln(eta chi)/d ln eta.

    A collision is seen half a step late on average, so that discs behave as if smaller, by sqrt(pi)/2 v step.
    """
    z, rise = hard_disc.kolafa_rottner(ETA), kolafa_rottner.compressibility_slope(ETA)
    return -math.sqrt(math.pi) * rise / (z - 1)


def test_bias_is_as_large_as_late_collisions_make_it(measured):
    for step, (excess, error) in measured.items():
        bias = excess / exact() - 1
        expected = slope() * step
        # Second order: about the square of the first.
        assert bias == pytest.approx(expected, abs=3 * error / exact() + expected**2)
        assert bias < -3 * error / exact()


def test_extrapolated_to_no_step_it_is_exact(measured):
    (coarse, coarse_error), (fine, fine_error) = measured[0.05], measured[0.025]
    limit = 2 * fine - coarse
    error = math.hypot(2 * fine_error, coarse_error)
    second_order = (slope() * 0.05) ** 2 / 2 * exact()
    assert limit == pytest.approx(exact(), abs=3 * error + second_order)


def test_event_driven_needs_no_extrapolation():
    simulation = one_gas(COUNT, ETA, seed=2)
    settle(simulation)
    run = measure(simulation, COLLISIONS)
    assert run.compressibility - 1 == pytest.approx(exact(), rel=3 * 1.2 / math.sqrt(run.collisions))
