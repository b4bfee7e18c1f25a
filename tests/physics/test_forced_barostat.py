"""The barostat: which areas it visits, and that a fluid finds its density under the pressure of its equation of state.

The rule d ln A = [(P - P0) A + T]/(N T time) dt + sqrt(2/(N time)) dW, P A = K + T + W/2, with places multiplied and
velocities divided by the same factor, has a mobility that does not depend on A, and K + U depends on ln A at fixed
scaled places and momenta with the slope -(P A - T): it leaves A² exp[-(K + U + P0 A)/T] d(ln A) over scaled phase space
invariant. At total momentum zero that holds 2N - 2 momenta, whose integral is proportional to A^(N-1). An ideal gas
therefore visits areas with the density A^N exp(-P0 A/T), that of the isothermal-isobaric ensemble: a Gamma distribution
of shape N + 1 and scale T/P0, with the mean (N + 1) T/P0 and the variance (N + 1) (T/P0)²; and N T/A is P0 on average.

Source of the rule: M. Bernetti and G. Bussi, J. Chem. Phys. 153, 114107 (2020), doi:10.1063/5.0020514.
"""

import math

import numpy as np
import pytest
from fluids import Mean, course, fluid, rescaling
from scipy import stats

from gasbox import observe
from gasbox.state import SetBarostat, SetHeating, SetThermostat

FREE = {"law": "none"}


def areas(simulation, every, number):
    """Areas at equal times apart."""
    begin, found = simulation.time, []
    for turn in range(1, number + 1):
        simulation.advance(until=begin + turn * every)
        found.append(simulation.geometry.at(simulation.state.wall_displacement).area)
    return np.array(found)


@pytest.mark.parametrize(("count", "temperature", "time"), [(12, 1.0, 30.0), (40, 2.0, 9.0)])
def test_areas_of_an_ideal_gas_are_gamma_distributed(count, temperature, time):
    # Times so long that the largest change at once, 5 %, is three standard deviations of the noise.
    simulation = fluid(
        count,
        1.0,
        temperature,
        forces=FREE,
        seed=count,
        thermostat=rescaling(temperature, 0.2),
        barostat={"pressure": temperature, "time": time},
    )
    simulation.advance(until=3.0 * time)
    found = areas(simulation, time, 700)
    memory, squared = _memory(math.exp(-1.0)), _memory(math.exp(-2.0))
    law = stats.gamma(count + 1.0)
    assert Mean(found.mean(), law.std() * math.sqrt(memory / found.size)).agrees(law.mean())
    noise = math.sqrt((2.0 + 6.0 / (count + 1.0)) * squared / found.size)
    assert Mean(found.var() / law.var(), noise).agrees(1.0)
    assert stats.kstest(found, law.cdf).statistic < 1.95 * math.sqrt(memory / found.size)
    # Without the share of the centre of mass and of the measure dA, the shape would be another.
    other = stats.gamma(count - 1.0)
    assert stats.kstest(found, other.cdf).statistic > 1.95 * math.sqrt(memory / found.size)


def _memory(correlation):
    """By how much samples with this correlation of neighbours count less."""
    return (1.0 + correlation) / (1.0 - correlation)


def test_area_of_an_ideal_gas_relaxes_at_the_given_time():
    count, time = 400, 4.0
    simulation = fluid(
        count,
        0.02,
        1.0,
        forces=FREE,
        time_step=0.01,
        seed=3,
        thermostat=rescaling(1.0, 0.2),
        barostat={"pressure": 0.01, "time": time},
    )
    # From half the area that it ends at: d ln A/dt = (1 - P0 A/(N T))/time, so 1/A - 1/A_end decays as exp(-t/time).
    found = areas(simulation, 1.0, 8)
    end = (count + 1.0) / 0.01
    expected = end / (1.0 + np.exp(-np.arange(1, 9) / time))
    # Chance adds to ln A what is left of 2/(N time) per time.
    assert found == pytest.approx(expected, rel=4.0 / math.sqrt(count))


def check_density(density, pressure, error, time, seed, duration):
    """From a tenth below it, under the pressure that Monte Carlo found for 400 discs at this density, at T = 1."""
    simulation = fluid(
        400,
        0.9 * density,
        1.0,
        seed=seed,
        thermostat=rescaling(1.0, 0.2),
        barostat={"pressure": pressure, "time": time},
    )
    simulation.advance(until=50.0)
    found = course(simulation, duration)
    # dP/d(density): 13.2 at 0.7, 1.4 at 0.3 (differences of the table).
    slope = 13.2 if density > 0.5 else 1.4
    mean = Mean.of(400.0 / found.area)
    assert mean.agrees(density, error / slope, allowance=0.001 * density)
    assert mean.error < 0.012 * density
    assert Mean.of(found.pressure).agrees(pressure, allowance=0.003 * pressure)


POINTS = [(0.7, 1.8102, 0.0043, 20.0), (0.3, 0.2866, 0.0006, 4.0)]


@pytest.mark.parametrize(("density", "pressure", "error", "time"), POINTS)
def test_fluid_finds_its_density(density, pressure, error, time):
    check_density(density, pressure, error, time, seed=5, duration=250.0)


@pytest.mark.validate
@pytest.mark.parametrize(("density", "pressure", "error", "time"), POINTS)
def test_fluid_finds_its_density_in_long_runs(density, pressure, error, time):
    check_density(density, pressure, error, time, seed=6, duration=2000.0)


def test_without_a_thermostat_the_enthalpy_rises_by_the_heat():
    pressure, power, count, duration = 0.5, 0.01, 400, 100.0
    simulation = fluid(
        count,
        0.55,
        0.8,
        forces={"truncation": "force-shifted"},
        time_step=0.004,
        seed=2,
        thermostat=rescaling(0.8, 0.2),
        barostat={"pressure": pressure, "time": 20.0},
    )
    simulation.advance(until=40.0)
    simulation.apply(SetThermostat(None))

    def moment():
        """Energy, enthalpy and area."""
        state, geometry = simulation.state, simulation.geometry
        energy = observe.internal_energy(state, geometry)
        return energy, observe.enthalpy(state, geometry, pressure), geometry.at(state.wall_displacement).area

    def go_on():
        """For a time, and return what moments and tallies have changed by."""
        first, tallies = moment(), simulation.dynamics.tallies.copy()
        simulation.advance(until=simulation.time + duration)
        return np.subtract(moment(), first), simulation.dynamics.tallies - tallies

    # What Verlet loses: the wobble of two moments, stirred by 2500 changes of the area.
    wobble = 0.003 * count
    (energy, enthalpy, area), change = go_on()
    assert enthalpy == pytest.approx(0.0, abs=wobble)
    assert abs(area) > 0.0
    simulation.apply(SetHeating(power))
    (energy, enthalpy, area), change = go_on()
    given = count * power * duration
    assert change.thermostat_heat[0] == 0.0
    assert change.heater_heat[0] == pytest.approx(given, rel=1e-12)
    assert enthalpy == pytest.approx(given, abs=wobble)
    # The rest of the heat went into work against the pressure outside.
    assert area > 50.0
    assert change.barostat_work[0] == pytest.approx(-pressure * area, abs=wobble)
    assert energy == pytest.approx(given + change.barostat_work[0], abs=wobble)


def test_fluctuations_without_a_thermostat_are_those_at_constant_enthalpy():
    # <dT²> = T² (1/C_K - 1/C_P)/N: narrower than with a bath, 1/C_K = 1, by as much as all else holds heat.
    pressure, count = 0.5, 100
    spread = []
    for alone in (False, True):
        simulation = fluid(
            count,
            0.55,
            0.8,
            forces={"truncation": "force-shifted"},
            seed=4,
            thermostat=rescaling(0.8, 0.2),
            barostat={"pressure": pressure, "time": 20.0},
        )
        simulation.advance(until=40.0)
        if alone:
            simulation.apply(SetThermostat(None))
        begin, found = simulation.time, []
        for turn in range(1, 601):
            simulation.advance(until=begin + 0.5 * turn)
            found.append(simulation.temperature())
        spread.append(np.var(found) / np.mean(found) ** 2 * (count - 1))
    # 600 moments, of which some 300 are independent: relative error of a variance sqrt(2/300).
    assert spread[0] == pytest.approx(1.0, abs=4.0 * math.sqrt(2.0 / 300))
    # C_P lies between 2 and 5 for each disc in this fluid.
    assert 0.4 < spread[1] < 0.9


def test_area_stays_when_the_barostat_is_off():
    simulation = fluid(100, 0.5, 1.0, thermostat=rescaling(1.0), barostat={"pressure": 1.0, "time": 5.0})
    simulation.advance(until=5.0)
    simulation.apply(SetBarostat(None))
    found = areas(simulation, 0.5, 4)
    assert np.ptp(found) == 0.0
    assert found[0] != 200.0
