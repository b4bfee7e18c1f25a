"""Dumbbells under the stepped rule come to equipartition: from flight alone, from rotation alone, and at warm walls."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gasbox import Simulation
from gasbox.scenario import parse

COUNT = 150


def dumbbells(count: int, fraction: float, temperature: float, rotation: float, periodic=("x", "y"), **more):
    """Discs of radius 0.5 at a distance of 0.8: an area of 1.48 each."""
    side = math.sqrt(count * 1.48 / fraction)
    atoms = [{"position": [0, 0], "radius": 0.5}, {"position": [0.8, 0], "radius": 0.5}]
    return parse(
        {
            "seed": 11,
            "container": {"width": side, "height": side, "periodic": list(periodic)},
            "molecules": [
                {
                    "name": "dumbbell",
                    "atoms": atoms,
                    "count": count,
                    "temperature": temperature,
                    "rotational_temperature": rotation,
                }
            ],
            "dynamics": {"kind": "stepped", "time_step": 0.03},
            **more,
        }
    )


def temperatures(simulation: Simulation) -> list[float]:
    """Twice the mean energy of each degree of freedom: flight along x, along y, rotation."""
    state = simulation.state
    flight = (state.mass[:, None] * state.velocity**2).mean(axis=0)
    return [*flight.tolist(), float((state.inertia * state.angular_velocity**2).mean())]


@pytest.mark.parametrize(("flight", "rotation"), [(1.5, 0.0), (0.0, 3.0)], ids=["flight", "rotation"])
def test_equal_shares_from_any_start(flight, rotation):
    """1 : 1 : 1, less what the momentum of the whole, zero here, takes from flight."""
    simulation = Simulation(dumbbells(COUNT, 0.2, flight, rotation))
    total, samples = sum(temperatures(simulation)), []
    simulation.advance(until=60.0)
    for sample in range(200):
        simulation.advance(until=63.0 + 3.0 * sample)
        samples.append(temperatures(simulation))
    share = (1.0 - 1.0 / COUNT) / (3.0 - 2.0 / COUNT)
    expected = total * np.array([share, share, 1.0 - 2.0 * share])
    # Of one sample T √(4/3N), as all have one sum; samples that are 1.5 collisions apart count half.
    error = total / 3.0 * math.sqrt(4.0 / (3.0 * COUNT)) / math.sqrt(100)
    assert np.abs(np.mean(samples, axis=0) - expected).max() < 4.0 * error
    assert simulation.summary()["warnings"] == []


def test_warm_walls_warm_flight_and_rotation_alike():
    warm = {side: {"temperature": 2.0} for side in ("left", "right", "bottom", "top")}
    simulation = Simulation(dumbbells(40, 0.25, 1.0, 1.0, (), walls=warm))
    simulation.advance(until=150.0)
    samples = []
    for sample in range(150):
        simulation.advance(until=165.0 + 15.0 * sample)
        samples.append(temperatures(simulation))
    # Of one sample T √(2/N); blocks of six tell how many count.
    blocks = np.mean(np.reshape(samples, (25, 6, 3)), axis=1)
    error = blocks.std(axis=0, ddof=1) / math.sqrt(len(blocks))
    assert (error < 2.0 * 2.0 * math.sqrt(2 / 40) / math.sqrt(150)).all()
    assert (np.abs(blocks.mean(axis=0) - 2.0) < 4.0 * error).all()
