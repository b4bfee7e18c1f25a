"""Energy and pressure of Lennard-Jones fluids and crystals at given density and temperature.

Expected values: Metropolis Monte Carlo of 400 discs by an independent code (standard errors in units of the last
digit), and virial coefficients by quadrature (B3 with a code that gives the exact one of hard discs to 1e-5). Both for
the law truncated at 2.5 and shifted, and for the full law.
"""

import math

import numpy as np
import pytest
from fluids import Mean, course, crystal, fluid, rescaling

from gasbox.theory.lennard_jones import energy_tail, pressure_tail

# Density, temperature; energy of each disc and its error; pressure and its error.
TRUNCATED = [
    (0.05, 1.0, -0.1483, 0.0001, 0.0483, 0.0001),
    (0.10, 1.0, -0.2874, 0.0002, 0.0941, 0.0001),
    (0.30, 1.0, -0.7795, 0.0008, 0.2866, 0.0006),
    (0.60, 1.0, -1.4997, 0.0006, 0.9979, 0.0024),
    (0.70, 1.0, -1.7644, 0.0009, 1.8102, 0.0043),
    (0.80, 1.0, -1.9899, 0.0016, 3.676, 0.012),
    (0.50, 2.0, -1.0386, 0.0006, 1.8333, 0.0026),
    (0.75, 0.7, -2.0317, 0.0005, 1.348, 0.007),
    (0.02, 0.5, -0.1290, 0.0007, 0.0090, 0.0001),
    (0.75, 0.5, -2.1446, 0.0011, 0.458, 0.007),
    (0.90, 0.2, -2.9514, 0.0003, 0.132, 0.002),
    (0.88, 0.3, -2.8205, 0.0005, 0.198, 0.004),
]
FULL = [
    (0.10, 1.0, -0.3183, 0.0009, 0.0915, 0.0002),
    (0.30, 1.0, -0.8587, 0.0014, 0.2669, 0.0007),
    (0.70, 1.0, -1.9249, 0.0009, 1.6855, 0.0070),
    (0.75, 0.7, -2.2070, 0.0008, 1.193, 0.007),
]
SHORT = [(0.10, 1.0), (0.60, 1.0), (0.75, 0.5), (0.88, 0.3)]
SOLID = 0.85
LONG_CUTOFF = 5.0
# Temperature; second and third virial coefficient of the truncated law.
VIRIAL = [
    (0.6, -3.4445, 5.485),
    (0.7, -2.3588, 4.507),
    (0.8, -1.6589, 3.527),
    (1.0, -0.8180, 2.336),
    (1.5, 0.0920, 1.408),
    (2.0, 0.4675, 1.222),
    (3.0, 0.7901, 1.174),
    (5.0, 1.0000, 1.180),
]


def run_at(density, temperature, duration, seed, **more):
    """400 discs held at a temperature, after a time to settle."""
    start = crystal if density > SOLID else fluid
    simulation = start(400, density, temperature, seed=seed, thermostat=rescaling(temperature, 0.2), **more)
    simulation.advance(until=min(40.0, 0.5 * duration) if density > 0.1 else 100.0)
    return course(simulation, duration)


def check(found, state, energy=0.0, pressure=0.0):
    """Compare with a line of the tables; energy, pressure : what the run leaves out."""
    density, _, u, u_error, p, p_error = state
    # Allowed beyond three standard errors of both: what a time step of 0.005 and other details make.
    allowed = 0.01 * p if density <= 0.1 else 0.02
    assert Mean.of(found.potential + energy).agrees(u, u_error, allowance=0.005, sigmas=3.0)
    assert Mean.of(found.pressure + pressure).agrees(p, p_error, allowance=allowed, sigmas=3.0)


@pytest.mark.parametrize("state", [state for state in TRUNCATED if state[:2] in SHORT], ids=str)
def test_state_points(state):
    check(run_at(*state[:2], duration=160.0, seed=1), state)


@pytest.mark.validate
@pytest.mark.parametrize("state", TRUNCATED, ids=str)
def test_all_state_points(state):
    check(run_at(*state[:2], duration=1500.0, seed=2), state)


@pytest.mark.validate
@pytest.mark.parametrize("state", FULL, ids=str)
def test_state_points_of_the_full_law(state):
    density, cut = state[0], LONG_CUTOFF
    found = run_at(*state[:2], duration=600.0, seed=3, forces={"cutoff": cut})
    # The shift that pairs within the cutoff lack, at their mean number, and what is beyond it.
    shift = 0.5 * math.pi * cut**2 * density * 4.0 * (cut**-12 - cut**-6)
    check(found, state, energy=shift + energy_tail(density, cut), pressure=pressure_tail(density, cut))


def second_coefficient(temperature, third, density, duration, seed, count=400):
    """B2 from the virial of a dilute gas, less the share of B3; and its error."""
    simulation = fluid(count, density, temperature, seed=seed, thermostat=rescaling(temperature, 0.2))
    simulation.advance(until=40.0)
    found = course(simulation, duration)
    # The first correction for a finite number is that each disc meets count - 1 others.
    scale = 1.0 / (temperature * density * (1.0 - 1.0 / count))
    return Mean.of(0.5 * found.virial * scale - third * density)


@pytest.mark.parametrize(
    ("temperature", "second", "third"), [row for row in VIRIAL if row[0] in (0.7, 1.0, 2.0)]
)
def test_dilute_pressure_is_that_of_the_second_virial_coefficient(temperature, second, third):
    density = 0.04
    found = second_coefficient(temperature, third, density, 300.0, seed=4)
    # The fourth coefficient, of order 5, is left out.
    assert found.error < 0.06
    assert found.agrees(second, allowance=5.0 * density**2, sigmas=3.5)


@pytest.mark.validate
@pytest.mark.parametrize(("temperature", "second", "third"), VIRIAL)
def test_second_virial_coefficient(temperature, second, third):
    density = 0.02
    found = second_coefficient(temperature, third, density, 4000.0, seed=5)
    assert found.error < (0.04 if temperature > 0.9 else 0.08)
    assert found.agrees(second, allowance=(20.0 if temperature < 0.7 else 5.0) * density**2, sigmas=3.5)


def test_the_temperature_of_a_run_follows_from_energy_alone():
    # Without a thermostat: the fluid keeps the energy that it has at 0.7 and 1, so it must come to that temperature.
    from gasbox.state import SetThermostat

    density, temperature, u, u_error, _, _ = TRUNCATED[4]
    simulation = fluid(400, density, temperature, seed=6, thermostat=rescaling(temperature, 0.2))
    simulation.advance(until=30.0)
    simulation.apply(SetThermostat(None))
    wanted = 400 * u + 399 * temperature
    state = simulation.state
    state.velocity *= math.sqrt((wanted - state.potential) / simulation.energy())
    simulation.dynamics.resync(state)
    found = course(simulation, 160.0)
    # dT/dE = 1/(N C) with C = 1.6 for each disc: the error of the energy, and 0.3 % for the step.
    assert Mean.of(found.temperature).agrees(temperature, u_error / 1.6, allowance=0.003)
    assert Mean.of(found.potential + found.temperature * 399 / 400).value == pytest.approx(
        wanted / 400, abs=1e-3
    )
    assert np.ptp(found.potential) > 0.02
