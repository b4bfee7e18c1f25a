"""Round ends for the axes of histograms."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gasbox.theory import maxwell
from gasbox.theory.ranges import histogram_maximum, rounded_up


@pytest.mark.small
@pytest.mark.parametrize(
    ("value", "end"),
    [(1.0, 1.0), (1.01, 1.2), (0.3, 0.3), (0.31, 0.4), (81.0, 100.0), (7e-5, 8e-5), (999.0, 1000.0)],
)
def test_round_numbers(value, end):
    assert rounded_up(value) == end


@given(st.floats(1e-12, 1e12))
def test_a_round_number_is_just_above(value):
    assert value <= rounded_up(value) <= 4 / 3 * value * (1 + 1e-12)
    assert rounded_up(rounded_up(value)) == rounded_up(value)


@given(st.floats(0.01, 100.0), st.floats(0.001, 100.0), st.sampled_from(["speed", "energy"]))
def test_the_axis_holds_nearly_all_particles(mass, temperature, quantity):
    end = histogram_maximum(mass, temperature, quantity)
    beyond = (
        maxwell.speed_survival(end, mass, temperature)
        if quantity == "speed"
        else maxwell.energy_survival(end, temperature)
    )
    assert 0.0 < beyond <= 0.001 * (1 + 1e-9)


@pytest.mark.small
def test_a_cold_gas_has_no_theoretical_end():
    assert histogram_maximum(1.0, 0.0) is None
