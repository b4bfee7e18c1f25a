"""Thermostats: the canonical distribution of the kinetic energy, its memory, and the motion of single discs.

Expected values: K is Gamma distributed with shape f/2 and scale T, f = 2N - 2 for velocity rescaling in a periodic box
(momentum stays zero) and 2N for Langevin; its correlations decay as exp(-t/time) and exp(-2t/time) where no forces
act (G. Bussi, D. Donadio and M. Parrinello, J. Chem. Phys. 126, 014101 (2007), doi:10.1063/1.2408420). Free discs
under Langevin are Ornstein-Uhlenbeck processes: velocities correlate as exp(-t/time), and spread with D = T time/m
(G. E. Uhlenbeck and L. S. Ornstein, Phys. Rev. 36, 823 (1930), doi:10.1103/PhysRev.36.823).
"""

import math

import numpy as np
import pytest
from fluids import Mean, course, fluid, langevin, rescaling, run_of
from scipy import stats

from gasbox import observe
from gasbox.state import SetThermostat

FREE = {"law": "none"}
KINDS = {"velocity-rescaling": rescaling, "langevin": langevin}


def kinetic_energies(simulation, every, number, between=lambda: None):
    """Thermal kinetic energy at equal times apart; `between` is done before each is read."""
    begin, found = simulation.time, []
    for turn in range(1, number + 1):
        simulation.advance(until=begin + turn * every)
        between()
        found.append(observe.kinetic_energy(simulation.state))
    return np.array(found)


def complaint(energies, freedom, temperature, correlation):
    """What does not fit the canonical distribution, beyond four standard errors; "" if all does.

    correlation : of two samples that follow each other, decaying geometrically
    """
    memory = (1.0 + correlation) / (1.0 - correlation)
    squared = (1.0 + correlation**2) / (1.0 - correlation**2)
    number = energies.size
    mean, variance = 0.5 * freedom * temperature, 0.5 * freedom * temperature**2
    off = (energies.mean() - mean) / math.sqrt(variance * memory / number)
    # The kurtosis of a Gamma distribution of shape f/2 exceeds that of a Gaussian by 12/f.
    spread = (energies.var() / variance - 1.0) / math.sqrt((2.0 + 12.0 / freedom) * squared / number)
    if abs(off) > 4.0:
        return f"mean off by {off:.1f} standard errors"
    if abs(spread) > 4.0:
        return f"variance off by {spread:.1f} standard errors"
    distance = stats.kstest(energies, stats.gamma(0.5 * freedom, scale=temperature).cdf).statistic
    if distance > 1.95 * math.sqrt(memory / number):
        return f"distance of the distributions {distance:.3f}"
    return ""


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("count", [2, 50])
def test_kinetic_energy_of_free_discs_is_canonical(kind, count):
    time = 0.1
    simulation = fluid(
        count, 0.01, 1.5, forces=FREE, time_step=0.01, seed=count, thermostat=KINDS[kind](1.5, time)
    )
    simulation.advance(until=1.0)
    every = 3.0 * time if kind == "velocity-rescaling" else 1.5 * time
    energies = kinetic_energies(simulation, every, 4000)
    freedom = 2 * count - 2 if kind == "velocity-rescaling" else 2 * count
    assert complaint(energies, freedom, 1.5, math.exp(-3.0)) == ""
    assert complaint(energies, freedom, 1.5 * (1.0 + 8.0 / math.sqrt(freedom * 2000)), math.exp(-3.0)) != ""


@pytest.mark.parametrize("kind", KINDS)
def test_kinetic_energy_forgets_at_the_right_rate(kind):
    time = 0.5
    simulation = fluid(20, 0.01, 1.0, forces=FREE, time_step=0.02, seed=4, thermostat=KINDS[kind](1.0, time))
    simulation.advance(until=4.0)
    energies = kinetic_energies(simulation, 0.1, 8000)
    off = energies - energies.mean()
    rate = (1.0 if kind == "velocity-rescaling" else 2.0) / time
    for lag in (1, 3, 6):
        # M. S. Bartlett's standard error of a correlation that decays geometrically.
        expected, square = math.exp(-rate * 0.1 * lag), math.exp(-rate * 0.2)
        scatter = (1.0 + square) * (1.0 - expected**2) / (1.0 - square) - 2.0 * lag * expected**2
        error = math.sqrt(scatter / energies.size)
        found = float(np.mean(off[lag:] * off[:-lag]) / np.mean(off**2))
        assert found == pytest.approx(expected, abs=4.0 * error)


@pytest.mark.parametrize("kind", KINDS)
def test_kinetic_energy_of_a_fluid_is_canonical(kind):
    simulation = fluid(64, 0.6, 1.0, seed=3, thermostat=KINDS[kind](1.0, 0.1))
    simulation.advance(until=10.0)
    energies = kinetic_energies(simulation, 0.3, 1500)
    freedom = 126 if kind == "velocity-rescaling" else 128
    # Memory of the kinetic energy of a fluid, which exchanges it with the potential one: from the samples.
    assert complaint(energies, freedom, 1.0, correlation(energies)) == ""


def test_rescaling_without_chance_is_not_canonical():
    # H. J. C. Berendsen et al., J. Chem. Phys. 81, 3684 (1984): rescaled towards the aim, without noise.
    time, every = 0.1, 0.05
    simulation = fluid(64, 0.6, 1.0, seed=3, thermostat=rescaling(1.0))
    simulation.advance(until=10.0)
    simulation.apply(SetThermostat(None))

    def rescale():
        temperature = simulation.temperature()
        simulation.state.velocity *= math.sqrt(1.0 + every / time * (1.0 / temperature - 1.0))
        simulation.dynamics.resync(simulation.state)

    energies = kinetic_energies(simulation, every, 3000, rescale)[::3]
    assert "variance off by -" in complaint(energies, 126, 1.0, correlation(energies))


def correlation(values):
    """Of neighbouring samples, from 0 to 0.9."""
    off = values - values.mean()
    return min(max(float(np.mean(off[1:] * off[:-1]) / np.mean(off**2)), 0.0), 0.9)


def test_velocities_of_free_discs_under_langevin():
    count, time = 2000, 0.5
    simulation = fluid(count, 0.001, 2.0, forces=FREE, time_step=0.01, seed=9, thermostat=langevin(2.0, time))
    simulation.advance(until=5.0)
    shares, origins = (0.2, 0.5, 1.0, 2.0), 25
    found = np.zeros((origins, 4))
    for origin in range(origins):
        first, begin = simulation.state.velocity.copy(), simulation.time
        for column, share in enumerate(shares):
            simulation.advance(until=begin + share * time)
            found[origin, column] = np.mean(first * simulation.state.velocity) / 2.0
    for column, share in enumerate(shares):
        expected = math.exp(-share)
        # Of a product of two Gaussian numbers that correlate so; from one origin to the next, e^-4 of it is left.
        error = math.sqrt((1.0 + expected**2) / (2 * count * origins))
        assert Mean(found[:, column].mean(), error).agrees(expected)


@pytest.mark.parametrize(("mass", "time"), [(1.0, 0.5), (4.0, 2.0)])
def test_free_discs_under_langevin_diffuse(mass, time):
    count, temperature = 2000, 1.3
    heavy = {"name": "atom", "radius": 0.5, "mass": mass, "count": count, "temperature": temperature}
    simulation = run_of(
        [heavy],
        (1400.0, 1400.0),
        FREE,
        0.02,
        seed=10,
        thermostat=langevin(temperature, time),
        frame_interval=time,
    )
    way = observe.MeanSquaredDisplacement(simulation.geometry)
    simulation.attach(way)
    simulation.advance(frames=20)
    found = way.value()
    times, squared = found.times, found.msd
    diffusion = temperature * time / mass
    expected = 4.0 * diffusion * (times - time * (1.0 - np.exp(-times / time)))
    assert times[-1] == pytest.approx(20.0 * time)
    # The square of a way in two dimensions is exponentially distributed: relative error 1/sqrt(count).
    for row in (1, 3, 10, 20):
        assert squared[row] == pytest.approx(expected[row], rel=4.0 / math.sqrt(count))


def test_both_thermostats_give_the_same_energy():
    found = []
    for thermostat in (rescaling(1.0, 0.2), langevin(1.0, 1.0)):
        simulation = fluid(256, 0.6, 1.0, seed=5, thermostat=thermostat)
        simulation.advance(until=30.0)
        found.append(Mean.of(course(simulation, 200.0).potential))
    # Verlet's step makes the one 0.1 % warm in places, and the other cold in velocities: 0.001 in energy.
    assert found[0].agrees(found[1].value, found[1].error, allowance=0.002)
    assert found[0].error < 0.004


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("start", [0.5, 2.0])
def test_warmed_and_cooled_to_the_same_temperature(kind, start):
    simulation = fluid(256, 0.3, start, seed=8, thermostat=KINDS[kind](1.0, 0.5))
    simulation.advance(until=20.0)
    found = course(simulation, 150.0)
    # The second law in small: whoever came from above or below has the temperature, and the energy, of the table.
    assert Mean.of(found.temperature).agrees(1.0, allowance=0.002)
    assert Mean.of(found.potential).agrees(-0.7795, 0.0008, allowance=0.005)
