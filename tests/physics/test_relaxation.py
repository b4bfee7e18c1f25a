"""How a gas comes to equilibrium: from equal speeds, and from two temperatures."""

import math

import numpy as np
import pytest
from runs import distance, gas, one_gas, theory_of
from scipy.integrate import solve_ivp

from gasbox import observe
from gasbox.observe.motion import speeds
from gasbox.theory import kinetic, maxwell
from gasbox.theory.mixture import contact_values

# Fourth moment <v⁴>/(2 <v²>²) - 1 and distance from Maxwell's law (Kolmogorov) of a dilute gas that starts with equal
# speeds, against the time in units of the mean time between the collisions of a disc in equilibrium. The start, -1/2,
# and its slope, 0.14448, are exact; the rest by direct simulation of Boltzmann's equation (2e6 particles).
MOMENT = {0.4: -0.4438, 0.8: -0.3916, 1.2: -0.3434, 2.0: -0.2603, 2.8: -0.1941, 4.0: -0.1222, 6.0: -0.0548}
DISTANCE = {0.8: 0.338, 1.2: 0.256, 2.0: 0.155, 2.8: 0.100, 4.0: 0.054, 6.0: 0.021}
FINITE_DENSITY = 0.005
"""How far a gas at an area fraction of 0.01 was seen to stray from the dilute limit."""


@pytest.fixture(scope="module")
def relaxing():
    """Speeds of four gases of 20 000 at each time of the table, in units of sqrt(T/m)."""
    found = {time: [] for time in [0.0, *MOMENT]}
    for seed in range(4):
        simulation = gas([{"count": 20_000, "speed": math.sqrt(2.0)}], 0.01, seed=seed)
        rate = kinetic.collision_rates(theory_of(simulation), simulation.temperature())[0, 0]
        for time, values in found.items():
            simulation.advance(until=time / rate)
            values.append(speeds(simulation.state) / math.sqrt(simulation.temperature()))
    return {time: np.concatenate(values) for time, values in found.items()}


def fourth_moment(values):
    return float(np.mean(values**4) / (2 * np.mean(values**2) ** 2) - 1)


def test_equal_speeds_at_the_start(relaxing):
    assert fourth_moment(relaxing[0.0]) == pytest.approx(-0.5, abs=1e-3)
    assert np.ptp(relaxing[0.0]) < 0.1


@pytest.mark.parametrize("time", MOMENT)
def test_fourth_moment_relaxes(relaxing, time):
    values = relaxing[time]
    assert fourth_moment(values) == pytest.approx(
        MOMENT[time], abs=3 * 2 / math.sqrt(values.size) + FINITE_DENSITY
    )


@pytest.mark.parametrize("time", DISTANCE)
def test_speeds_come_close_to_maxwell_after_six_collisions(relaxing, time):
    values = relaxing[time]
    found = distance(values, lambda v: maxwell.speed_cdf(v, 1.0, 1.0))
    # A sample's distance from its own law is at most 1.95/sqrt(n) in 999 cases of 1000.
    assert found == pytest.approx(DISTANCE[time], abs=1.95 / math.sqrt(values.size) + FINITE_DENSITY)


def test_initial_slope_of_the_fourth_moment():
    simulation = gas([{"count": 50_000, "speed": 1.0}], 0.005, seed=9)
    rate = kinetic.collision_rates(theory_of(simulation), simulation.temperature())[0, 0]
    simulation.advance(until=0.1 / rate)
    # From the table: the slope falls by some 6 % within a time of 0.4; every tenth particle has collided.
    rise = fourth_moment(speeds(simulation.state)) + 0.5
    assert rise == pytest.approx(0.014448, abs=0.0002 + 3 * 0.35 * math.sqrt(0.1 / 50_000))


def test_two_species_come_to_one_temperature():
    # d(T1 - T2)/dt = -4 m1 m2/(m1 + m2)² (omega_12 + omega_21)(T1 - T2), each Maxwellian at its own temperature.
    count, eta = 10_000, 0.02
    simulation = gas(
        [
            {"count": count, "mass": 1.0, "temperature": 1.5},
            {"count": count, "mass": 4.0, "temperature": 0.5},
        ],
        eta,
        seed=4,
    )
    mixture = theory_of(simulation)
    chi = contact_values(mixture)[0, 1]
    exchange = 4 * 1.0 * 4.0 / 5.0**2

    def slope(_, heat):
        meeting = kinetic.relative_speed(1.0, 4.0, heat[0], heat[1])
        rate = 2 * mixture.density[0] * mixture.contact_distance[0, 1] * chi * meeting
        flow = exchange * rate * (heat[1] - heat[0])
        return [flow, -flow]

    near = kinetic.equalisation_rate(mixture, 1.0)
    times = np.array([0.5, 1.0, 1.5, 2.5]) / near
    solution = solve_ivp(slope, (0, times[-1]), [1.5, 0.5], t_eval=times, rtol=1e-8)
    for time, (hot, cold) in zip(times, solution.y.T, strict=True):
        simulation.advance(until=float(time))
        found = [observe.species_temperature(simulation.state, simulation.geometry, s) for s in range(2)]
        assert sum(found) == pytest.approx(2.0, rel=1e-3)
        # Half of the difference is what scatters, by T/sqrt(2 count) at most; the ansatz is good to some 2 %.
        tolerance = 2 * 3 / math.sqrt(2 * count) + 0.02 * (hot - cold)
        assert found[0] - found[1] == pytest.approx(hot - cold, abs=tolerance)
    # Near the end the difference falls as the linear rate says.
    assert slope(0, [1.001, 0.999])[0] * 2 == pytest.approx(-near * 0.002, rel=1e-3)


def test_a_gas_in_equilibrium_stays_there():
    simulation = one_gas(2000, 0.05, seed=2)
    before = fourth_moment(speeds(simulation.state))
    assert abs(before) < 3 * 2 / math.sqrt(2000)
    simulation.advance(until=50.0)
    assert abs(fourth_moment(speeds(simulation.state))) < 3 * 2 / math.sqrt(2000)
