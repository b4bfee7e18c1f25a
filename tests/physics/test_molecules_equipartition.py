"""Hard molecules share their energy evenly between flight along x, along y, and rotation, from whatever start."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gasbox.build import build
from gasbox.scenario import parse

COUNT = 150
SAMPLES = 40
DUMBBELL = {"atoms": [{"position": [0, 0], "radius": 0.5}, {"position": [1, 0], "radius": 0.5}]}
BENT = {
    "atoms": [
        {"position": [0, 0], "radius": 0.6, "mass": 4},
        {"position": [0.8, 0.4], "radius": 0.4},
        {"position": [-0.8, 0.4], "radius": 0.4},
    ]
}


def gas_of(shape, start, **more):
    molecule = {"name": "molecule", "count": COUNT, **shape, **start}
    box = {"width": 48, "height": 48, "periodic": ["x", "y"]}
    return parse(
        {"seed": 3, "container": box, "molecules": [molecule], "dynamics": {"kind": "event-driven"}, **more}
    )


def shares(state):
    """Energies of flight along x and y, and of rotation."""
    along = 0.5 * state.mass @ state.velocity**2
    return np.array([*along, 0.5 * state.inertia @ state.angular_velocity**2])


@pytest.mark.parametrize(
    ("shape", "start"),
    [
        (DUMBBELL, {"speed": 0, "angular_speed": 2}),
        (DUMBBELL, {"temperature": 1, "angular_speed": 0}),
        (BENT, {"speed": 0, "rotational_temperature": 1}),
    ],
)
def test_one_to_one_to_one_from_any_start(shape, start):
    """In a periodic box at rest flight has 2N - 2 degrees of freedom; a share of the energy is a Beta variable."""
    parts = build(gas_of(shape, start))
    state, engine = parts.state, parts.dynamics
    total = shares(state).sum()
    assert shares(state).min() < 1e-20 * total
    apart = 3 * COUNT  # collisions: six of each molecule
    found = []
    while len(found) < SAMPLES:
        before = engine.tallies.pair_collisions.sum()
        goal = before + (4 if not found else 1) * apart
        while engine.tallies.pair_collisions.sum() < goal:
            engine.advance(state, state.time + 2.0 / math.sqrt(total / COUNT))
        found.append(shares(state) / total)
    freedom = np.array([COUNT - 1, COUNT - 1, COUNT])
    expected = freedom / freedom.sum()
    spread = np.sqrt(expected * (1 - expected) / (0.5 * freedom.sum() + 1) / SAMPLES)
    assert (np.abs(np.mean(found, axis=0) - expected) < 4 * spread).all()


def test_warm_walls_keep_flight_and_rotation_in_equilibrium():
    """Between walls of one temperature every degree of freedom has that temperature, from a cold start."""
    warm = {"temperature": 2}
    gas = gas_of(
        DUMBBELL,
        {"temperature": 0.5, "angular_speed": 0},
        container={"width": 30, "height": 30},
        walls=dict.fromkeys(("left", "right", "bottom", "top"), warm),
    )
    parts = build(gas)
    state, engine = parts.state, parts.dynamics
    hits, found = engine.tallies.wall_collisions, []
    engine.advance(state, 100.0)
    while len(found) < SAMPLES:
        goal = hits.sum() + 2 * COUNT
        while hits.sum() < goal:
            engine.advance(state, state.time + 2.0)
        found.append(shares(state) / (0.5 * COUNT))
    assert (np.abs(np.mean(found, axis=0) / 2.0 - 1.0) < 4 * math.sqrt(2.0 / COUNT / SAMPLES)).all()
