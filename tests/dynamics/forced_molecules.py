"""Gases of molecules under forces, as the tests want them."""

from __future__ import annotations

import numpy as np
from forced_gases import rectangle

from gasbox import Simulation
from gasbox.scenario import Scenario, parse

ATOM = {"name": "atom", "radius": 0.5}
HEAVY = {"name": "heavy", "radius": 0.4, "mass": 3.0, "epsilon": 0.7}
SMOOTH = {"truncation": "force-shifted"}

DUMBBELL = {
    "name": "dumbbell",
    "atoms": [{"species": "atom", "position": [-0.3, 0]}, {"species": "atom", "position": [0.3, 0]}],
    "bonds": [{"atoms": [0, 1]}],
    "temperature": 1.0,
}
WATER = {
    "name": "water",
    "atoms": [
        {"position": [0, 0], "mass": 16.0, "radius": 0.5, "charge": -2.0},
        {"position": [0.24, 0.19], "radius": 0.2, "epsilon": 0.0, "charge": 1.0},
        {"position": [-0.24, 0.19], "radius": 0.2, "epsilon": 0.0, "charge": 1.0},
    ],
    "bonds": [{"atoms": [0, 1]}, {"atoms": [0, 2]}],
    "temperature": 1.0,
}
TRIMER = {
    "name": "trimer",
    "atoms": [
        {"species": "atom", "position": [-0.9, 0]},
        {"species": "heavy", "position": [0, 0.4]},
        {"species": "atom", "position": [0.9, 0]},
    ],
    "bonds": [{"atoms": [0, 1], "stiffness": 80.0}, {"atoms": [1, 2], "stiffness": 60.0, "length": 1.1}],
    "angles": [{"atoms": [0, 1, 2], "stiffness": 15.0, "angle": 115}],
    "temperature": 1.0,
}
CHAIN = {
    "name": "chain",
    "atoms": [{"species": "atom", "position": [0.8 * k, 0.3 * (k % 2)]} for k in range(5)],
    "bonds": [{"atoms": [k, k + 1], "stiffness": 90.0} for k in range(4)],
    "temperature": 1.0,
}


def gas(counts, width=16.0, height=14.0, molecules=(DUMBBELL,), periodic=("x", "y"), **more) -> Scenario:
    """So many of each molecule; `atoms` single discs among them."""
    atoms = more.pop("atoms", 0)
    data = {
        "format": "gasbox-scenario/1",
        "seed": more.pop("seed", 3),
        "container": more.pop("container", rectangle(width, height, periodic)),
        "species": [{**ATOM, "count": atoms, "temperature": 1.0}, HEAVY],
        "molecules": [
            {**molecule, "count": count} for molecule, count in zip(molecules, counts, strict=True)
        ],
        "dynamics": {"kind": "forced", "time_step": more.pop("time_step", 0.002)},
        **more,
    }
    return parse(data)


def parts_of_energy(simulation: Simulation):
    """Energy of flight, of rotation, and of motion within flexible molecules, at this moment."""
    state = simulation.state
    sites = state.sites
    flight = 0.5 * float(np.sum(state.mass @ state.velocity**2))
    rotation = 0.5 * float(np.sum(state.inertia * state.angular_velocity**2))
    whole = 0.5 * float(np.sum(sites.mass @ sites.velocity**2))
    spinning = ~sites.flexible
    point = sites.position - state.position[sites.owner]
    turned = np.bincount(sites.owner, sites.mass * np.sum(point**2, axis=1)) * state.angular_velocity**2
    # What discs add by spinning about themselves is in the inertia alone.
    within = whole - flight - 0.5 * float(turned[spinning].sum()) - 0.5 * float(turned[~spinning].sum())
    return flight, rotation, within


def energy(simulation: Simulation) -> float:
    """Kinetic and potential."""
    return sum(parts_of_energy(simulation)) + simulation.state.potential


def set_going(simulation: Simulation, seed=1, turning=1.0):
    """Shake the discs of flexible molecules, so that they vibrate from the start."""
    state, rng = simulation.state, np.random.default_rng(seed)
    flexible = state.sites.flexible[state.sites.owner]
    state.sites.position[flexible] += 0.05 * rng.normal(size=(int(flexible.sum()), 2))
    state.sites.velocity[flexible] += turning * rng.normal(size=(int(flexible.sum()), 2))
    simulation.dynamics.resync(state)
