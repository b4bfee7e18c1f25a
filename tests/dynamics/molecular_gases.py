"""Gases of rigid molecules for the tests of hard dynamics, made without any engine."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gasbox.dynamics import EventDriven
from gasbox.geometry import Geometry
from gasbox.state import Contacts, Sites, State, Tallies


@dataclass(frozen=True)
class Body:
    """A kind of molecule: discs at places (k, 2), with radii and masses (k,); moved so that the centre of mass is 0."""

    place: np.ndarray
    radius: np.ndarray
    mass: np.ndarray

    @property
    def reach(self) -> float:
        return float((np.hypot(*self.place.T) + self.radius).max())

    @property
    def inertia(self) -> float:
        away2 = (self.place**2).sum(axis=1)
        return float(self.mass @ (away2 + 0.5 * self.radius**2)) if len(self.mass) > 1 else 0.0


def body(place, radius=0.5, mass=1.0) -> Body:
    place = np.array(place, float).reshape(-1, 2)
    radius, mass = np.broadcast_to(radius, len(place)) * 1.0, np.broadcast_to(mass, len(place)) * 1.0
    return Body(place - mass @ place / mass.sum(), radius, mass)


DISC = body([[0, 0]])
DUMBBELL = body([[0, 0], [1, 0]])
BENT = body([[0, 0], [0.8, 0.4], [-0.8, 0.4]], [0.6, 0.4, 0.4], [4.0, 1.0, 1.0])
ROD = body([[0.3 * k, 0] for k in range(9)], 0.2, 0.3)
BARBELL = body([[0, 0], [2.0, 0]], 0.3, [1.0, 2.0])


def gas_of(bodies, kind, position, velocity, angle=0.0, omega=0.0, time=0.0) -> State:
    """A state of particles of these kinds (n,), at positions and with velocities (n, 2)."""
    kind = np.array(kind, np.int32)
    position = np.array(position, float).reshape(-1, 2)
    n = len(kind)
    chosen = [bodies[k] for k in kind]
    first = np.concatenate([[0], np.cumsum([len(one.mass) for one in chosen])]).astype(np.int64)
    place = np.concatenate([one.place for one in chosen])
    offset = np.concatenate([[0], np.cumsum([len(one.mass) for one in bodies])])
    species = np.concatenate([np.arange(offset[k], offset[k + 1]) for k in kind]).astype(np.int32)
    sites = Sites(
        first,
        species,
        np.concatenate([one.mass for one in chosen]),
        np.concatenate([one.radius for one in chosen]),
        place,
        place.copy(),
        np.zeros_like(place),
        np.zeros(n, np.bool_),
    )
    state = State(
        time,
        np.arange(n, dtype=np.int64),
        kind,
        np.array([one.mass.sum() for one in chosen]),
        np.array([one.reach for one in chosen]),
        position,
        np.array(velocity, float).reshape(-1, 2),
        angle=np.broadcast_to(angle, n) * 1.0,
        angular_velocity=np.broadcast_to(omega, n) * 1.0,
        inertia=np.array([one.inertia for one in chosen]),
        sites=sites,
    )
    state.turn_sites()
    return state


def without(state: State, row: int) -> State:
    """A copy with one particle less, the last."""
    fewer = state.copy()
    fewer.keep(np.arange(state.count) < row)
    return fewer


def overlap(state: State, geometry: Geometry) -> float:
    """Depth of the deepest overlap of discs of different particles, or with a wall, over the smallest radius."""
    sites, owner = state.sites, state.sites.owner
    worst, ways = 0.0, [(-1, 0, 1) if periodic else (0,) for periodic in geometry.periodic]
    apart = sites.position[:, None] - sites.position[None]
    mine = owner[:, None] == owner[None]
    for kx in ways[0]:
        for ky in ways[1]:
            away = np.hypot(*np.moveaxis(apart + geometry.size * (kx, ky), -1, 0))
            depth = sites.radius[:, None] + sites.radius[None] - away
            worst = max(worst, float(np.where(mine, 0.0, depth).max()))
    return worst / float(sites.radius.min())


def scattered(bodies, kind, geometry, seed=1, room=None, warmth=1.0, spin=1.0) -> State:
    """Particles at random places and angles, none in another or in a wall; Maxwell velocities."""
    rng = np.random.default_rng(seed)
    kind, placed = np.array(kind), []
    low, high = (np.zeros(2), geometry.size) if room is None else np.array(room, float)
    while len(placed) < len(kind):
        trial = [*placed, (*(low + rng.random(2) * (high - low)), rng.random() * 2 * np.pi)]
        rows = np.array(trial)
        state = gas_of(bodies, kind[: len(trial)], rows[:, :2], np.zeros((len(trial), 2)), rows[:, 2])
        inside = geometry.wrap(state.sites.position)
        held = geometry.holds(inside, state.sites.radius * (1 + 1e-6))
        if held.all() and overlap(state, geometry) == 0.0:
            placed = trial
    state.velocity[:] = rng.normal(size=(len(kind), 2)) * np.sqrt(warmth / state.mass)[:, None]
    turns = state.inertia > 0
    omega = rng.normal(size=len(kind)) * np.sqrt(spin / np.where(turns, state.inertia, 1.0))
    state.angular_velocity[:] = np.where(turns, omega, 0.0)
    state.turn_sites()
    return state


def engine_of(state, geometry, contacts=0, memory=None, seed=5) -> EventDriven:
    tallies = Tallies.zero(int(state.species.max()) + 1, len(geometry.wall_names))
    return EventDriven(state, geometry, tallies, Contacts.empty(contacts), memory, seed)


def energy(state: State, gravity=(0.0, 0.0)) -> float:
    """Of motion and turning, and of the height."""
    moving = 0.5 * float(state.mass @ (state.velocity**2).sum(axis=1))
    turning = 0.5 * float(state.inertia @ state.angular_velocity**2)
    return moving + turning - float(state.mass @ (state.position @ np.array(gravity)))


def momentum(state: State) -> np.ndarray:
    return state.mass @ state.velocity


def angular_momentum(state: State, about=(0.0, 0.0)) -> float:
    away = state.position - np.array(about)
    orbital = away[:, 0] * state.velocity[:, 1] - away[:, 1] * state.velocity[:, 0]
    return float(state.mass @ orbital + state.inertia @ state.angular_velocity)
