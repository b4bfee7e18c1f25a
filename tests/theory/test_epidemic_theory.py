"""Kermack and McKendrick's numbers, and those of small outbreaks."""

import math

import numpy as np
import pytest

from gasbox.theory.epidemic import (
    contact_reproduction,
    epidemic_curve,
    epidemic_growth,
    extinction_probability,
    final_size,
    final_size_deviation,
    final_size_mean,
    herd_threshold,
    peak_infected,
    share_within,
    well_mixed_reproduction,
)

pytestmark = pytest.mark.small

# R0: final size, peak, sd sqrt(N) exponential and fixed, extinction likewise, growth for a fixed time
TABLE = {
    1.2: (0.3137, 0.0147, 3.71, 2.63, 0.833, 0.686, 0.376),
    1.5: (0.5828, 0.0630, 1.84, 1.32, 0.667, 0.417, 0.874),
    2.0: (0.7968, 0.1534, 0.913, 0.678, 0.500, 0.203, 1.594),
    2.5: (0.8926, 0.2335, 0.547, 0.423, 0.400, 0.107, 2.232),
    3.0: (0.9405, 0.3005, 0.357, 0.288, 0.333, 0.060, 2.821),
    4.0: (0.9802, 0.4034, 0.174, 0.151, 0.250, 0.020, 3.921),
    5.0: (0.9930, 0.4781, 0.093, 0.086, 0.200, 0.007, 4.965),
}


@pytest.mark.parametrize("r0", TABLE)
def test_numbers_of_the_table(r0):
    z, peak, exponential, fixed, q_exponential, q_fixed, growth = TABLE[r0]
    assert final_size(r0) == pytest.approx(z, abs=6e-5)
    assert peak_infected(r0) == pytest.approx(peak, abs=6e-5)
    assert final_size_deviation(r0, 1, 1.0) == pytest.approx(exponential, rel=6e-3)
    assert final_size_deviation(r0, 1, 0.0) == pytest.approx(fixed, rel=6e-3)
    assert extinction_probability(r0, "exponential") == pytest.approx(q_exponential, abs=6e-4)
    assert extinction_probability(r0, "fixed") == pytest.approx(q_fixed, abs=6e-4)
    assert epidemic_growth(r0, 1.0, "exponential") == pytest.approx(r0 - 1.0)
    assert epidemic_growth(r0, 1.0, "fixed") == pytest.approx(growth, abs=6e-4)


def test_a_gamma_time_lies_between():
    assert epidemic_growth(2.0, 3.0, "gamma", 1.0) == pytest.approx(1.0 / 3.0)
    between = epidemic_growth(2.0, 1.0, "gamma", 4.0)
    assert 1.0 < between < epidemic_growth(2.0, 1.0, "fixed")
    assert epidemic_growth(2.0, 1.0, "gamma", 1e6) == pytest.approx(1.594, abs=1e-3)
    assert extinction_probability(2.0, "gamma", 3, 1.0) == pytest.approx(0.125)
    # SEIR with exponential times: (1 + r a)(1 + r b) = R0.
    rate = epidemic_growth(3.0, 5.0, "exponential", exposed=(2.0, "exponential", 1.0))
    assert (1 + 2 * rate) * (1 + 5 * rate) == pytest.approx(3.0)


def test_below_one_nothing_spreads():
    assert final_size(0.9) == 0.0
    assert final_size(3.0, susceptible=1 / 3) == 0.0
    assert peak_infected(3.0, 1 / 3) == 0.0
    assert extinction_probability(0.99, "fixed") == 1.0
    assert herd_threshold(0.5) == 0.0
    assert herd_threshold(4.0) == 0.75
    # Three seeds of which each infects half a person, who ... : 3/(1 - 0.5) in all, seeds included.
    assert 1e4 * final_size(0.5, seeds=3e-4) == pytest.approx(3.0, rel=1e-3)
    with pytest.raises(ValueError, match="above 1"):
        epidemic_growth(1.0, 1.0, "fixed")


@pytest.mark.parametrize("law", ["exponential", "fixed"])
def test_curve_ends_at_the_final_size(law):
    curve = epidemic_curve(2.0, 5.0, 200.0, law=law, exposed=2.0)
    whole = curve.susceptible + curve.exposed + curve.infectious + curve.recovered
    assert np.allclose(whole, 1.0, atol=1e-12)
    assert curve.recovered[-1] - 0.001 == pytest.approx(final_size(2.0, 0.999, 0.001), abs=1e-5)


def test_curve_of_sir_peaks_and_grows_as_the_formulas_say():
    curve = epidemic_curve(2.0, 1.0, 40.0, seeds=1e-6, steps=4000)
    assert curve.infectious.max() == pytest.approx(peak_infected(2.0), abs=1e-5)
    early = (curve.time > 2) & (curve.time < 6)
    assert np.polyfit(curve.time[early], np.log(curve.infectious[early]), 1)[0] == pytest.approx(
        1.0, abs=2e-3
    )


def test_reproduction_numbers():
    # A town of 7 x 7 with 100 people, radius 0.75, 0.2 a day, 5 days.
    assert well_mixed_reproduction(0.2, 100 / 49, 0.75, 5) == pytest.approx(3.61, abs=0.005)
    assert contact_reproduction(0.1, 4.0, 5.0) == 2.0
    assert math.isclose(well_mixed_reproduction(0.2, 1000 / 49, 0.25, 5), 4.01, abs_tol=0.005)


def sellke(r0, law, people, seeds, runs):
    """Final sizes (runs,), parts of the people: each falls ill once all infectious time is beyond a threshold."""
    rng = np.random.default_rng(5)
    thresholds = np.sort(rng.exponential(size=(runs, people)), axis=1)
    times = {
        "fixed": lambda size: np.ones(size),
        "exponential": lambda size: rng.exponential(size=size),
        "gamma": lambda size: rng.gamma(4.0, 0.25, size=size),
    }[law]((runs, people + seeds))
    pressure = r0 / people * np.cumsum(times, axis=1)[:, seeds - 1 : -1]
    return np.where((short := thresholds > pressure).any(axis=1), short.argmax(axis=1), people) / people


@pytest.mark.parametrize(("law", "seeds"), [("exponential", 1), ("fixed", 1), ("gamma", 2), ("fixed", 5)])
def test_mean_of_a_finite_crowd(law, seeds):
    sizes = sellke(2.0, law, 300, seeds, 10_000)
    sizes = sizes[sizes > 0.25]
    expected = final_size_mean(2.0, 300, law, seeds, 4.0)
    assert sizes.mean() == pytest.approx(expected, abs=4 * sizes.std() / sizes.size**0.5)


def test_share_of_the_others_who_are_near():
    rng = np.random.default_rng(1)
    apart = np.abs(rng.random((200_000, 2)) - rng.random((200_000, 2))) * [3.0, 2.0]
    for radius in (0.3, 2.0):
        share = share_within(radius, 3.0, 2.0)
        near = (np.hypot(*apart.T) < radius).mean()
        assert near == pytest.approx(share, abs=4 * (share * (1 - share) / 200_000) ** 0.5)
    assert share_within(0.01, 3.0, 2.0) == pytest.approx(
        well_mixed_reproduction(1.0, 1 / 6, 0.01, 1.0), rel=0.01
    )
    with pytest.raises(ValueError, match="shorter side"):
        share_within(2.1, 3.0, 2.0)
