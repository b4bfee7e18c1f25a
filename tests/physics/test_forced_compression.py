"""Slow work under forces: what a side that moves does to a gas is what mechanics and the second law want.

Expected values: without forces each disc keeps |v_x| times the length of its way (adiabatic invariant), so that the
energy of motion along x grows as the inverse square of that length, and nothing else does. With WCA forces the gas
is nearly one of hard discs of diameter d = integral of 1 - exp(-u/T) over the distance (J. A. Barker and D. Henderson,
J. Chem. Phys. 47, 4714 (1967), doi:10.1063/1.1701689): along an adiabat the entropy of these, with d that falls as T
rises, stays; and slow work is given back when the side goes back.
"""

import math

import numpy as np
import pytest
from fluids import Mean, run_of
from scipy import integrate, optimize

from gasbox import observe
from gasbox.theory.fluid import compressibility, excess_free_energy


def pressed(count, forces, points, time_step=0.005):
    """A gas at rest in a box whose right side follows a path."""
    atom = {"name": "atom", "radius": 0.5, "count": count, "temperature": 1.0}
    walls = {"right": {"motion": {"kind": "path", "points": points}}}
    return run_of([atom], (26.0, 26.0), forces, time_step, periodic=(), walls=walls)


def internal(simulation):
    return observe.internal_energy(simulation.state, simulation.geometry)


def warmth(simulation, begin, end):
    """Mean temperature over a stretch of time."""
    found = []
    for time in np.linspace(begin, end, 60):
        simulation.advance(until=time)
        found.append(simulation.temperature())
    return Mean.of(found)


def test_discs_without_forces_keep_their_adiabatic_invariant():
    simulation = pressed(300, {"law": "none"}, [[0, 0], [400, -10]])
    state = simulation.state
    along, across = (float(np.sum(state.mass * state.velocity[:, axis] ** 2)) for axis in (0, 1))
    simulation.advance(until=400.0)
    assert float(np.sum(state.mass * state.velocity[:, 1] ** 2)) == pytest.approx(across, rel=1e-12)
    # The slowest are not much faster than the side; they have little energy.
    expected = along * (25.0 / 15.0) ** 2
    assert float(np.sum(state.mass * state.velocity[:, 0] ** 2)) == pytest.approx(expected, rel=0.02)
    work = simulation.dynamics.tallies.wall_work[1, 0]
    assert internal(simulation) == pytest.approx(0.5 * (along + across) + work, rel=1e-9)


def diameter(temperature):
    """Of the hard discs that WCA discs resemble [length]."""

    def shut(distance):
        return -math.expm1(-(4.0 * (distance**-12 - distance**-6) + 1.0) / temperature)

    return 0.3 + integrate.quad(shut, 0.3, 2.0 ** (1.0 / 6.0))[0]


def entropy(temperature, area, count):
    """For each disc, but for a constant: minus the derivative of the free energy, diameter included."""
    eta = count * 0.25 * math.pi * diameter(temperature) ** 2 / area
    step = 1e-3
    growth = (
        2.0 * math.log(diameter(temperature * (1 + step)) / diameter(temperature * (1 - step))) / (2 * step)
    )
    excess = excess_free_energy(eta) + (compressibility(eta) - 1.0) * growth
    return math.log(temperature * area) - excess


def test_slow_work_heats_a_gas_and_comes_back():
    count = 250
    points = [[0, 0], [40, 0], [190, -7], [220, -7], [370, 0]]
    simulation = pressed(count, {"law": "wca"}, points, 0.0025)
    simulation.advance(until=10.0)
    start, energy = warmth(simulation, 10.0, 40.0), internal(simulation)
    hot = warmth(simulation, 190.0, 220.0)
    work = simulation.dynamics.tallies.wall_work[1, 0]
    assert internal(simulation) - energy == pytest.approx(work, rel=5e-3)

    same = entropy(start.value, 25.0 * 25.0, count)
    expected = optimize.brentq(lambda t: entropy(t, 18.0 * 25.0, count) - same, 1.0, 6.0)
    assert hot.agrees(expected, start.error * expected / start.value, allowance=0.03 * expected)
    back = warmth(simulation, 370.0, 400.0)
    assert back.agrees(start.value, start.error, allowance=0.02)
    assert abs(simulation.dynamics.tallies.wall_work[1, 0]) < 0.03 * work


def test_fast_work_does_not_come_back():
    """There and back at about the speed of sound: the gas is left warmer."""
    simulation = pressed(250, None, [[0, 0], [40, 0], [45, -10], [50, 0]])
    simulation.advance(until=10.0)
    start = warmth(simulation, 10.0, 40.0)
    end = warmth(simulation, 60.0, 90.0)
    assert end.value > 1.1 * start.value
