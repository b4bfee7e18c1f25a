"""A slow piston heats molecules less than discs: part of the work goes into rotation."""

import math

import numpy as np
import pytest
from rotor_gases import LENGTH, PLACE, RADIUS, SECOND
from vessels import agrees

from gasbox import observe
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.theory import adiabat, hard_bodies

COUNT, SPEED = 100, 0.02
WIDTH, HEIGHT = 160.0, 40.0


def compressed(seed, way=0.5 * WIDTH):
    """T'/T after the right wall has moved in by half of the width, and the theory of it."""
    half = RADIUS + LENGTH / math.pi
    simulation = Simulation(
        parse(
            {
                "seed": seed,
                "container": {"shape": "rectangle", "width": WIDTH, "height": HEIGHT, "periodic": ["y"]},
                "molecules": [
                    {
                        "name": "dumbbells",
                        "atoms": [{"position": p, "radius": RADIUS, "mass": 0.5} for p in PLACE],
                        "count": COUNT,
                        "temperature": 1.0,
                    }
                ],
                "walls": {"right": {"motion": {"kind": "path", "points": [[0, 0], [way / SPEED, -way]]}}},
                "dynamics": {"kind": "event-driven"},
                "frame_interval": 100.0,
            }
        )
    )
    before, energy = simulation.temperature(), simulation.energy()
    simulation.advance(until=way / SPEED)
    work = simulation.dynamics.tallies.wall_work.sum()
    assert work == pytest.approx(simulation.energy() - energy, abs=1e-8)
    area, new = (WIDTH - 2 * half) * HEIGHT, (WIDTH - way - 2 * half) * HEIGHT
    # Along y momentum is conserved.
    freedom = observe.degrees_of_freedom(simulation.state, simulation.geometry) / COUNT
    expected = hard_bodies.dilute_temperature(new, 1.0, COUNT, SECOND, area, freedom)
    ideal = [float(adiabat.ideal_temperature(new, 1.0, area, f)) for f in (2.0, 3.0)]
    return simulation.temperature() / before, float(expected), ideal


def test_a_slow_piston_and_molecules_that_rotate():
    runs = [compressed(seed) for seed in range(3)]
    ratios = [found / expected for found, expected, _ in runs]
    agrees(ratios, 1.0, bias=0.015, least=0.01)
    # T A of discs is refuted; and with it that rotation takes up nothing.
    discs, rotors = runs[0][2]
    assert np.mean([found for found, _, _ in runs]) < 0.9 * discs
    assert np.mean([found for found, _, _ in runs]) == pytest.approx(rotors, rel=0.08)
