"""Shipped scenarios with forces do what their names say, within a minute of the page or less."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from gasbox import Simulation, load, observe
from gasbox.observe import Phase
from gasbox.observe.stretches import latent_heats, stretches
from gasbox.scenario import with_settings

MINUTE = 3600
"""Frames of a minute at speed 1."""


def begun(name: str) -> Simulation:
    return Simulation(load(name), threads=1)


def shares(simulation: Simulation) -> NDArray[np.float64]:
    """Of discs in gas, liquid and solid."""
    state = simulation.frame_view().state
    return observe.phase_shares(observe.phases(state, simulation.geometry))


def test_phases_condenses() -> None:
    simulation = begun("phases")
    assert shares(simulation)[Phase.GAS] > 0.8
    simulation.advance(frames=MINUTE // 4)
    assert shares(simulation)[Phase.GAS] < 0.3


def test_droplet_is_liquid_beside_its_vapour() -> None:
    simulation = begun("droplet")
    simulation.advance(frames=MINUTE // 2)
    gas, liquid, solid = shares(simulation)
    assert liquid > 0.5
    assert 0.0 < gas < 0.3
    assert solid < 0.4


def test_melting_melts() -> None:
    simulation = begun("melting")
    simulation.advance(frames=MINUTE // 10)
    assert shares(simulation)[Phase.SOLID] > 0.8
    simulation.advance(frames=MINUTE - MINUTE // 10)
    gas, liquid, solid = shares(simulation)
    assert solid < 0.25
    assert liquid > 0.6
    assert gas < 0.3


def test_boiling_boils_away() -> None:
    less = {"species.0.count": "250", "container.width": "20", "container.height": "18"}
    simulation = Simulation(with_settings(load("boiling"), less), threads=1)
    simulation.advance(frames=200)
    assert shares(simulation)[Phase.LIQUID] > 0.8
    area = simulation.geometry.at(simulation.state.wall_displacement).area
    simulation.advance(frames=MINUTE - 200)
    assert shares(simulation)[Phase.GAS] > 0.8
    assert simulation.geometry.at(simulation.state.wall_displacement).area > 5 * area


def test_condensation_under_gravity_fills_the_floor() -> None:
    simulation = begun("condensation-under-gravity")
    simulation.advance(frames=MINUTE // 2)
    height = simulation.state.position[:, 1]
    top = simulation.geometry.height
    # The liquid, and a thin vapour over it.
    assert np.mean(height < 0.55 * top) > 0.9
    assert shares(simulation)[Phase.GAS] < 0.2


def test_a_mixture_separates() -> None:
    simulation = begun("mixture-that-separates")

    def strangers() -> float:
        """Share of neighbours that are of the other kind."""
        state = simulation.frame_view().state
        found = observe.neighbours(state, simulation.geometry, 1.5)
        one = np.repeat(state.species, found.counts)
        return float(np.mean(one != state.species[found.other]))

    before = strangers()
    simulation.advance(frames=MINUTE // 2)
    assert before > 0.4
    assert strangers() < 0.15


def test_heating_curve_has_two_plateaus() -> None:
    small = with_settings(
        load("heating-curve"),
        {
            "species.0.count": "224",
            "container.width": "15.68",
            "container.height": "15.52",
            "heating.power": "0.002",
            "schedule": "[]",
            "frame_interval": "2",
        },
    )
    simulation = Simulation(small, threads=1)
    assert small.barostat is not None
    curve = observe.HeatingCurve(simulation.geometry, small.barostat.pressure)
    frame = simulation.frame_view()
    curve.start(frame.state, frame.tallies)
    for _ in range(1000):
        simulation.advance(frames=1)
        frame = simulation.frame_view()
        curve.observe(frame.state, frame.tallies)
    course = curve.value()
    names = [stretch.name for stretch in stretches(course)]
    assert names == ["solid", "melting", "liquid", "boiling", "gas"]
    melting, boiling = latent_heats(course)
    # Few discs and much power: 4012 of them gave 0.42 and 0.36, and 0.50 and 1.8.
    assert 0.36 < melting.temperature < 0.46
    assert 0.2 < melting.heat < 0.6
    assert 0.44 < boiling.temperature < 0.56
    assert 1.2 < boiling.heat < 2.4
    # What was added is what the heating gave.
    assert course.heat[-1] == pytest.approx(frame.tallies.heater_heat[0] / 224, rel=0.02)
