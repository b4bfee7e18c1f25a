"""Gases of rigid molecules for the tests of the stepped rule."""

from __future__ import annotations

import hashlib

import numpy as np

from gasbox.build import Parts, build
from gasbox.protocols import Status
from gasbox.scenario import Scenario, parse
from gasbox.state import Contacts, State

DUMBBELL = {"atoms": [{"position": [0, 0], "radius": 0.5}, {"position": [0.8, 0], "radius": 0.5}]}
TRIANGLE = {
    "atoms": [
        {"position": [0, 0], "radius": 0.6, "mass": 4},
        {"position": [0.8, 0.4], "radius": 0.4},
        {"position": [-0.8, 0.4], "radius": 0.4},
    ]
}
ROD = {"atoms": [{"position": [0.5 * k, 0.3], "radius": 0.4} for k in range(7)]}
PERIODIC = {"container": {"width": 14, "height": 12, "periodic": ["x", "y"]}}
BOX = {"container": {"width": 14, "height": 12}}
CIRCLE = {"container": {"shape": "circle", "radius": 7.5}}
FALLING = {**BOX, "gravity": [0.05, -0.4]}
FALLING_CIRCLE = {**CIRCLE, "gravity": [0, -0.4]}
PLACES = {
    "periodic": PERIODIC,
    "box": BOX,
    "slab": {"container": {"width": 14, "height": 12, "periodic": ["x"]}, "gravity": [0, -0.3]},
    "circle": CIRCLE,
    "falling": FALLING,
    "falling circle": FALLING_CIRCLE,
}


def molecules(place, time_step=0.02, seed=1, dumbbells=6, triangles=4, rods=3, discs=8, **more) -> Scenario:
    """Dumbbells, triangles, rods and discs, each kind at a temperature of 1."""
    shapes = {"dumbbell": (DUMBBELL, dumbbells), "triangle": (TRIANGLE, triangles), "rod": (ROD, rods)}
    return parse(
        {
            "seed": seed,
            "species": [{"name": "disc", "radius": 0.4, "count": discs, "temperature": 1}],
            "molecules": [
                {"name": name, "count": count, "temperature": 1, **shape}
                for name, (shape, count) in shapes.items()
            ],
            "dynamics": {"kind": "stepped", "time_step": time_step},
            **place,
            **more,
        }
    )


def parts_of(scenario: Scenario, contacts: int = 0, threads: int = 1) -> Parts:
    parts = build(scenario, threads)
    parts.dynamics.contacts = Contacts.empty(contacts)
    return parts


def run(parts: Parts, until: float) -> list[tuple[int, float, int, int, float, float]]:
    """Advance; the contacts on the way, as rows (kind, time, first, second, impulse x, y)."""
    rows, contacts = [], parts.dynamics.contacts
    while True:
        status = parts.dynamics.advance(parts.state, until)
        rows += [
            (
                int(contacts.kind[k]),
                float(contacts.time[k]),
                int(contacts.first[k]),
                int(contacts.second[k]),
                *contacts.impulse[k].tolist(),
            )
            for k in range(contacts.count)
        ]
        contacts.clear()
        if status is Status.DONE:
            return rows


def kinetic(state: State) -> float:
    flight = state.mass @ (state.velocity**2).sum(axis=1)
    return float(0.5 * (flight + state.inertia @ state.angular_velocity**2))


def internal(parts: Parts) -> float:
    """Kinetic and potential energy."""
    gravity = np.array(getattr(parts.geometry, "gravity", (0.0, 0.0)))
    return kinetic(parts.state) - float(parts.state.mass @ (parts.state.position @ gravity))


def angular_momentum(state: State, about=(0.0, 0.0)) -> float:
    away = state.position - np.array(about)
    cross = away[:, 0] * state.velocity[:, 1] - away[:, 1] * state.velocity[:, 0]
    return float(state.mass @ cross + state.inertia @ state.angular_velocity)


def bits(parts: Parts) -> str:
    """All that an engine leaves in the state and in the tallies."""
    state, sites = parts.state, parts.state.sites
    arrays = [state.id, state.position, state.velocity, state.angle, state.angular_velocity]
    arrays += [sites.position, sites.velocity, *vars(parts.dynamics.tallies).values()]
    return hashlib.sha256(b"".join(np.ascontiguousarray(array).tobytes() for array in arrays)).hexdigest()


def apart(position, geometry):
    """(k, k, 2) differences of places, to the nearest image."""
    away = position[:, None] - position[None]
    for axis in range(2):
        if geometry.periodic[axis]:
            away[..., axis] -= geometry.size[axis] * np.rint(away[..., axis] / geometry.size[axis])
    return away


def overlaps(state: State, geometry):
    """(k, k) depth of each pair of sites over the smaller radius; of pairs of one particle, minus infinity."""
    sites, owner = state.sites, state.sites.owner
    reach = sites.radius[:, None] + sites.radius[None]
    depth = reach - np.linalg.norm(apart(sites.position, geometry), axis=2)
    depth /= np.minimum(sites.radius[:, None], sites.radius[None])
    depth[owner[:, None] == owner[None]] = -np.inf
    return depth
