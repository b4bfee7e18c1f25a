"""Small gases for the tests of the dynamics, made without any engine."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gasbox.dynamics import EventDriven, Forced, ForcedSettings, Stepped, pair_terms
from gasbox.geometry import Rectangle
from gasbox.protocols import Dynamics, Status
from gasbox.scenario import PairLaw
from gasbox.state import Contacts, Memory, State, Tallies

Maker = Callable[..., Dynamics]


def state_of(position, velocity, radius=1.0, mass=1.0, species=None, time=0.0) -> State:
    position = np.array(position, np.float64).reshape(-1, 2)
    n = position.shape[0]
    return State(
        time,
        np.arange(n, dtype=np.int64),
        np.zeros(n, np.int32) if species is None else np.array(species, np.int32),
        np.full(n, mass, np.float64) if np.isscalar(mass) else np.array(mass, np.float64),
        np.full(n, radius, np.float64) if np.isscalar(radius) else np.array(radius, np.float64),
        position,
        np.array(velocity, np.float64).reshape(-1, 2),
    )


def random_gas(seed: int, geometry: Rectangle, radii, masses=None, speed: float = 1.0) -> State:
    """Discs put one by one at random where they don't overlap; Gaussian velocities of unit kT times speed."""
    rng = np.random.default_rng(seed)
    radii = np.asarray(radii, np.float64)
    masses = np.ones(radii.size) if masses is None else np.asarray(masses, np.float64)
    order = np.argsort(-radii, kind="stable")
    position = np.full((radii.size, 2), np.nan)
    placed: list[int] = []
    for i in order:
        for _ in range(20000):
            at = np.empty(2)
            for axis in range(2):
                low, high = (0.0, geometry.size[axis])
                if not geometry.periodic[axis]:
                    low, high = low + radii[i], high - radii[i]
                at[axis] = rng.uniform(low, high)
            d = separation(at - position[placed], geometry)
            if np.all(np.hypot(d[:, 0], d[:, 1]) > (radii[i] + radii[placed]) * (1 + 1e-9)):
                position[i] = at
                placed.append(int(i))
                break
        else:
            raise AssertionError("no room")
    velocity = speed * rng.normal(size=(radii.size, 2)) / np.sqrt(masses)[:, None]
    return state_of(position, velocity, radii, masses)


def separation(difference, geometry: Rectangle):
    """Nearest image of differences (n, 2)."""
    difference = np.array(difference, np.float64).reshape(-1, 2)
    for axis in range(2):
        if geometry.periodic[axis]:
            length = geometry.size[axis]
            difference[:, axis] -= length * np.rint(difference[:, axis] / length)
    return difference


def deepest_overlap(state: State, geometry: Rectangle) -> float:
    """Largest overlap of any two discs, or of a disc and a wall, over the smaller radius; by all pairs."""
    worst = 0.0
    for i in range(state.count - 1):
        d = separation(state.position[i + 1 :] - state.position[i], geometry)
        depth = state.radius[i] + state.radius[i + 1 :] - np.hypot(d[:, 0], d[:, 1])
        worst = max(worst, float((depth / np.minimum(state.radius[i], state.radius[i + 1 :])).max()))
    for axis in range(2):
        if not geometry.periodic[axis]:
            low = state.radius - state.position[:, axis]
            high = state.position[:, axis] + state.radius - geometry.size[axis]
            worst = max(worst, float((low / state.radius).max()), float((high / state.radius).max()))
    return worst


def energy(state: State) -> float:
    return float(0.5 * (state.mass * (state.velocity**2).sum(axis=1)).sum())


def event_driven(state: State, geometry: Rectangle, contacts: int = 0, memory: Memory | None = None):
    return EventDriven(state, geometry, _tallies(state), Contacts.empty(contacts), memory)


def stepped(
    state: State, geometry: Rectangle, contacts: int = 0, memory: Memory | None = None, time_step=0.05
):
    return Stepped(state, geometry, time_step, _tallies(state), Contacts.empty(contacts), memory)


def forced(state: State, geometry: Rectangle, contacts: int = 0, memory: Memory | None = None):
    """Soft discs, whatever their radii."""
    law = PairLaw("wca", 1.0, 0.3, 0.3 * 2 ** (1 / 6), "shifted", 1.5, 0.3)
    settings = ForcedSettings(0.002, pair_terms({(0, 0): law}, 1), 0.3)
    return Forced(state, geometry, settings, _tallies(state), Contacts.empty(contacts), memory)


def _tallies(state: State) -> Tallies:
    return Tallies.zero(int(state.species.max(initial=0)) + 1, len(Rectangle.WALLS))


def collect(
    dynamics: Dynamics, state: State, until: float
) -> list[tuple[int, float, int, int, float, float]]:
    """Advance, and return all contacts on the way as rows (kind, time, first, second, impulse x, y)."""
    rows: list[tuple[int, float, int, int, float, float]] = []
    status = Status.FULL
    while status is Status.FULL:
        status = dynamics.advance(state, until)
        c = dynamics.contacts
        for k in range(c.count):
            rows.append(
                (int(c.kind[k]), float(c.time[k]), int(c.first[k]), int(c.second[k]), *c.impulse[k].tolist())
            )
        c.clear()
    return rows


def collisions(dynamics: Dynamics) -> int:
    return int(dynamics.tallies.pair_collisions.sum())
