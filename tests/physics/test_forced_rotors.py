"""Molecules under forces, as statistical mechanics wants them: shares of energy, heat baths, pressure, areas."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gasbox import Simulation
from gasbox.scenario import parse

ATOM = {"name": "atom", "radius": 0.5}
DUMBBELL = {
    "name": "dumbbell",
    "atoms": [{"species": "atom", "position": [-0.3, 0]}, {"species": "atom", "position": [0.3, 0]}],
}
BENT = {
    "name": "bent",
    "atoms": [{"species": "atom", "position": place} for place in ([-0.8, 0], [0, 0.5], [0.8, 0])],
    "bonds": [{"atoms": [k, k + 1], "stiffness": 60.0} for k in (0, 1)],
    "angles": [{"atoms": [0, 1, 2], "stiffness": 10.0}],
}
LANGEVIN = {"kind": "langevin", "temperature": 1.3, "time": 0.5}
RESCALING = {"kind": "velocity-rescaling", "temperature": 1.3, "time": 0.5}
NONE = {"law": "none"}
SMOOTH = {"truncation": "force-shifted"}


def gas(molecule, count, area, periodic=("x", "y"), **more):
    """Molecules in a square, at a temperature of 1 unless they say otherwise."""
    side = math.sqrt(area)
    return parse(
        {
            "seed": more.pop("seed", 1),
            "container": {"width": side, "height": side, "periodic": list(periodic)},
            "species": [ATOM],
            "molecules": [{"temperature": 1.0, **molecule, "count": count}],
            "dynamics": {"kind": "forced", "time_step": more.pop("time_step", 0.004)},
            **more,
        }
    )


def energies(simulation, pieces, step):
    """Mean energies of flight, rotation and vibration over pieces of a run (pieces, 3)."""
    found = []
    for _ in range(pieces):
        before = simulation.dynamics.tallies.copy()
        simulation.advance(until=simulation.time + step)
        change = simulation.dynamics.tallies - before
        sums = [change.kinetic_time[0], change.rotational_time[0], change.vibrational_time[0]]
        found.append(np.array(sums) / change.measured_time[0])
    return np.array(found)


def degrees(simulation):
    """Degrees of freedom of flight, rotation and vibration in a periodic box."""
    state = simulation.state
    discs = np.diff(state.sites.first)
    vibrating = int((2 * discs - 3)[state.sites.flexible].sum())
    return np.array([2 * state.count - 2, int((state.inertia > 0).sum()), vibrating])


def agrees(values, expected, sigmas=4.0, allowance=0.0):
    """Whether independent values (pieces, ..) have this mean."""
    error = values.std(axis=0, ddof=1) / math.sqrt(len(values))
    return np.abs(values.mean(axis=0) - expected) <= sigmas * error + allowance


@pytest.mark.parametrize("thermostat", [LANGEVIN, RESCALING], ids=["langevin", "rescaling"])
@pytest.mark.parametrize("molecule", [DUMBBELL, BENT], ids=["rigid", "flexible"])
def test_each_kind_of_motion_has_the_temperature_of_the_bath(molecule, thermostat):
    simulation = Simulation(gas(molecule, 40, 120.0, thermostat=thermostat, forces=SMOOTH))
    simulation.advance(until=15.0)
    found, freedom = energies(simulation, 30, 4.0), degrees(simulation)
    error = found.std(axis=0, ddof=1) / math.sqrt(30)
    here = freedom > 0
    assert (error[here] < 0.03 * 0.65 * freedom[here]).all()
    # Of the order of (w dt)²/4, w the frequency of the bonds.
    assert agrees(found, 0.65 * freedom, allowance=0.002 * freedom).all()


@pytest.mark.parametrize("thermostat", [LANGEVIN, RESCALING], ids=["langevin", "rescaling"])
def test_kinetic_energy_is_canonical(thermostat):
    """Without forces between molecules each look at K is a Gamma distribution of shape f/2, here of f = 2N - 2 + N."""
    more = {"thermostat": {**thermostat, "time": 0.05}, "forces": NONE, "time_step": 0.05}
    simulation = Simulation(gas({**DUMBBELL, "temperature": 1.3}, 12, 400.0, **more))
    drifts = thermostat is LANGEVIN
    found = []
    for _ in range(3000):
        simulation.advance(until=simulation.time + 0.3)
        state = simulation.state
        drift = 0.0 if drifts else np.sum((state.mass @ state.velocity) ** 2) / (2 * state.mass.sum())
        turning = state.inertia @ state.angular_velocity**2
        found.append(0.5 * (np.sum(state.mass @ state.velocity**2) + turning) - drift)
    freedom = 36 if drifts else 34
    mean, variance = 1.3 * freedom / 2, 1.3**2 * freedom / 2
    assert np.mean(found) == pytest.approx(mean, abs=4.5 * math.sqrt(variance / 3000))
    assert np.var(found) == pytest.approx(variance, rel=4.5 * math.sqrt((2 + 12 / freedom) / 3000))


@pytest.mark.parametrize("start", ["rotation", "flight"])
def test_energy_is_shared_evenly_from_any_start(start):
    """Each of two velocities and the angular velocity has the same share of what there is, without a bath."""
    hot = {"temperature": 0.0, "rotational_temperature": 4.0}
    if start == "flight":
        hot = {"temperature": 2.0, "rotational_temperature": 0.0}
    simulation = Simulation(gas({**DUMBBELL, **hot}, 100, 300.0, forces={"law": "wca"}, seed=2))
    first = energies(simulation, 1, 0.04)[0] / degrees(simulation)[:3].clip(1)
    assert abs(first[0] - first[1]) > 0.5 * first.max()
    simulation.advance(until=40.0)
    found = energies(simulation, 30, 4.0)[:, :2] / degrees(simulation)[:2]
    assert agrees(found[:, 0] - found[:, 1], 0.0)
    assert found.std(axis=0).max() / math.sqrt(30) < 0.01


def test_a_barostat_gives_the_area_of_an_ideal_gas():
    """A Gamma distribution of shape N + 1: molecules count once, whatever their atoms."""
    more = {"thermostat": RESCALING, "forces": NONE, "barostat": {"pressure": 0.65, "time": 2.0}}
    simulation = Simulation(gas({**DUMBBELL, "temperature": 1.3}, 80, 162.0, time_step=0.02, **more))
    found = []
    for _ in range(500):
        simulation.advance(until=simulation.time + 4.0)
        found.append(math.prod(simulation.dynamics.memory()["box"]))
    mean, variance = 81 * 2.0, 81 * 4.0
    assert np.mean(found) == pytest.approx(mean, abs=4.5 * math.sqrt(1.3 * variance / 500))
    # Steps of a tenth of its time widen it by a twentieth.
    assert np.var(found) == pytest.approx(variance, rel=4.5 * math.sqrt(2.6 / 500) + 0.05)


def test_a_barostat_holds_the_pressure_of_a_fluid_of_dumbbells():
    """The area that it finds, without it, has the pressure: virial and flight of molecules are those of its scale."""
    bath = {"thermostat": {**LANGEVIN, "time": 0.3}, "forces": SMOOTH, "seed": 5}
    simulation = Simulation(gas(DUMBBELL, 100, 400.0, barostat={"pressure": 1.0, "time": 2.0}, **bath))
    simulation.advance(until=20.0)
    areas = []
    for _ in range(40):
        before = simulation.dynamics.tallies.copy()
        simulation.advance(until=simulation.time + 3.0)
        change = simulation.dynamics.tallies - before
        areas.append(change.area_time[0] / change.measured_time[0])
    area, error = np.mean(areas), np.std(areas, ddof=1) / math.sqrt(40)
    still = Simulation(gas(DUMBBELL, 100, float(area), **bath))
    still.advance(until=20.0)
    pressures = pressure(still, 40, 3.0, 1.3)
    scatter = pressures.std(ddof=1) / math.sqrt(40)
    # What a wrong area does: of this dense gas dP/dA = -P/A, times three at most.
    assert abs(pressures.mean() - 1.0) < 4 * math.hypot(scatter, 3 * error / area) + 0.01
    assert math.hypot(scatter, 3 * error / area) < 0.05


def pressure(simulation, pieces, step, temperature):
    """(N T + W/2)/A over pieces of a run."""
    found, area = [], simulation.geometry.area
    for _ in range(pieces):
        before = simulation.dynamics.tallies.copy()
        simulation.advance(until=simulation.time + step)
        change = simulation.dynamics.tallies - before
        virial = change.pair_virial[0] / change.measured_time[0]
        found.append((simulation.state.count * temperature + 0.5 * virial) / area)
    return np.array(found)


def second_coefficient(temperature, half=0.3, cutoff=2.5):
    """B2 of dumbbells of Lennard-Jones discs with the energy shifted, by quadrature over distance and two angles."""
    turn = (np.arange(24) + 0.5) * math.pi / 24
    one, other = np.meshgrid(turn, turn, indexing="ij")
    distance = np.linspace(0.0, cutoff + 2 * half, 801)[1:]
    total = np.zeros((distance.size, 24, 24))
    for a in (-half, half):
        for b in (-half, half):
            x = distance[:, None, None] + b * np.cos(other) - a * np.cos(one)
            square = x**2 + (b * np.sin(other) - a * np.sin(one)) ** 2
            sixth = 1.0 / np.maximum(square, 1e-3) ** 3
            shift = 4.0 * (cutoff**-12 - cutoff**-6)
            total = total + np.where(square < cutoff**2, 4.0 * (sixth**2 - sixth) - shift, 0.0)
    mayer = np.mean(np.expm1(-np.minimum(total / temperature, 700.0)), axis=(1, 2))
    return -math.pi * float(np.sum(mayer * distance) * (distance[1] - distance[0]))


def found_coefficient(temperature, density, count, pieces, step):
    """B2 and its error from the pressure at one density, B3 left in."""
    bath = {"kind": "langevin", "temperature": temperature, "time": 2.0}
    simulation = Simulation(gas(DUMBBELL, count, count / density, thermostat=bath, time_step=0.005))
    simulation.advance(until=20.0)
    excess = pressure(simulation, pieces, step, temperature) / (density * temperature) - 1.0
    return excess.mean() / density, excess.std(ddof=1) / math.sqrt(pieces) / density


def test_dilute_pressure_of_dumbbells():
    expected = second_coefficient(2.0)
    found, error = found_coefficient(2.0, 0.02, 200, 25, 12.0)
    assert error < 0.35
    # A third coefficient of about B2² of the core, 10.
    assert abs(found - expected) < 4 * error + 10 * 0.02


@pytest.mark.validate
@pytest.mark.parametrize("temperature", [1.5, 4.0])
def test_second_virial_coefficient_of_dumbbells(temperature):
    expected = second_coefficient(temperature)
    dilute, error = found_coefficient(temperature, 0.01, 600, 40, 30.0)
    dense, more = found_coefficient(temperature, 0.02, 600, 40, 30.0)
    both = math.hypot(2 * error, more)
    print(f"T = {temperature}: B2 = {2 * dilute - dense:.3f}({both:.3f}), quadrature {expected:.3f}")
    assert both < 0.25
    assert abs(2 * dilute - dense - expected) < 3.5 * both + 0.02
