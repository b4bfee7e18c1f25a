"""Small gases with forces, as the tests of the forced rule want them."""

from __future__ import annotations

import hashlib

import numpy as np
from gases import random_gas

from gasbox import Simulation
from gasbox.geometry import Rectangle
from gasbox.scenario import Scenario, parse

ATOM = {"name": "atom", "radius": 0.5}


def rectangle(width, height, periodic=("x", "y")):
    """A container."""
    return {"shape": "rectangle", "width": width, "height": height, "periodic": list(periodic)}


def scenario(container, position=None, velocity=None, names=None, species=(ATOM,), **more) -> Scenario:
    """Discs at given places, or those that the species count."""
    data = {
        "format": "gasbox-scenario/1",
        "seed": 3,
        "container": container,
        "species": list(species),
        "dynamics": {"kind": "forced", "time_step": more.pop("time_step", 0.005)},
        **more,
    }
    if position is not None:
        position = np.asarray(position, np.float64).reshape(-1, 2)
        velocity = np.zeros(position.shape) if velocity is None else np.asarray(velocity)
        data["particles"] = {
            "species": ["atom"] * len(position) if names is None else list(names),
            "position": position.tolist(),
            "velocity": velocity.tolist(),
        }
    return parse(data)


def scattered(seed, width, height, count, gap=0.9, periodic=(True, True), speed=1.0):
    """Places no two of which are nearer than `gap`, one for all or one for each, and velocities that add up to 0."""
    radii = 0.5 * np.broadcast_to(gap, count)
    gas = random_gas(seed, Rectangle(width, height, *periodic), radii, speed=speed)
    return gas.position, gas.velocity - (gas.velocity.mean(axis=0) if count else 0.0)


def lattice(columns, rows, spacing):
    """A container that a triangular lattice fills, and its places; `rows` is even."""
    step = spacing * np.sqrt(0.75)
    column, row = np.meshgrid(np.arange(columns), np.arange(rows))
    places = np.stack([(column + 0.5 * (row % 2) + 0.25) * spacing, (row + 0.5) * step], axis=-1)
    return rectangle(columns * spacing, rows * step), places.reshape(-1, 2)


def energy(simulation: Simulation) -> float:
    """Kinetic and potential."""
    return simulation.energy() + simulation.state.potential


def apart(one, other, geometry):
    """Largest distance of places along any direction, by the nearest image."""
    gap = np.asarray(one) - np.asarray(other)
    size = np.where(geometry.periodic, geometry.size, np.inf)
    gap -= np.where(
        geometry.periodic, np.rint(gap / size) * np.where(geometry.periodic, geometry.size, 0), 0.0
    )
    return float(np.abs(gap).max()) if gap.size else 0.0


def bits(simulation: Simulation) -> str:
    """All that a run is, tallies and memory too."""
    state, dynamics = simulation.state, simulation.dynamics
    digest = hashlib.sha256()
    arrays = [state.position, state.velocity, state.wall_displacement, *vars(dynamics.tallies).values()]
    arrays += [np.array([state.time, state.potential, state.virial]), state.angle, state.angular_velocity]
    arrays += [] if state.sites is None else [state.sites.position, state.sites.velocity]
    for name, value in sorted(dynamics.memory().items()):
        digest.update(name.encode())
        arrays.append(np.asarray(value))
    for array in arrays:
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()
