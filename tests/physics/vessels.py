"""Gases in vessels of any shape, for the tests of walls and gravity: points or discs of mass 1 at temperature 1."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree
from scipy.stats import t as student

from gasbox.dynamics import EventDriven
from gasbox.geometry import Circle, Enclosure, Wall, side_names
from gasbox.protocols import Status
from gasbox.state import Contacts, State, Tallies

Sampler = Callable[[np.random.Generator, int], np.ndarray]


def vessel(container, obstacles=(), gravity=(0.0, 0.0), **walls) -> Enclosure:
    """Obstacles are called o0, o1, ...; `walls`: name (with _ for -) -> properties."""
    names = [*side_names(container), *(f"o{k}" for k in range(len(obstacles)))]
    properties = {name.replace("_", "-"): entry for name, entry in walls.items()}
    assert set(properties) <= set(names)
    found = tuple(Wall(name, **properties.get(name, {})) for name in names)
    return Enclosure(container, tuple(obstacles), found, gravity)


def _overlapping(position: np.ndarray, radius: np.ndarray, place: Enclosure) -> np.ndarray:
    """(n,) bool: who lies on somebody of a lower number."""
    bad = np.zeros(len(position), np.bool_)
    images = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    shifts = [s for s in images if (not s[0] or place.periodic_x) and (not s[1] or place.periodic_y)]
    for shift in shifts:
        tree = cKDTree(position + np.array(shift) * place.size)
        for k, near in enumerate(tree.query_ball_point(position, radius + radius.max())):
            for other in near:
                apart = np.hypot(*(position[k] - tree.data[other]))
                bad[k] |= other < k and apart < (radius[k] + radius[other]) * (1 + 1e-9)
    return bad


def gas(
    place: Enclosure, counts, radii, masses=None, *, temperature=1.0, seed=1, sampler: Sampler | None = None
) -> State:
    """Discs of some species at random places clear of walls and of each other, with a kinetic energy of N T.

    In a circle they don't rotate as a whole.
    `sampler` draws places (n, 2) from another density than the even one. In the order of species.
    """
    rng = np.random.default_rng(seed)
    species = np.repeat(np.arange(len(counts)), counts)
    radius = np.asarray(radii, np.float64)[species]
    mass = np.ones(species.size) if masses is None else np.asarray(masses, np.float64)[species]
    draw = sampler or (lambda generator, number: generator.random((number, 2)) * place.size)
    position, wanting = np.full((species.size, 2), -1.0), np.ones(species.size, np.bool_)
    while wanting.any():
        position[wanting] = draw(rng, int(wanting.sum()))
        wanting = ~place.holds(position, radius * (1 + 1e-9))
        wanting |= _overlapping(position, radius, place)
    velocity = rng.normal(size=(species.size, 2)) / np.sqrt(mass)[:, None]
    if isinstance(place.container, Circle) and not place.obstacles and not any(place.gravity):
        velocity -= rotation(position, velocity, mass, place)
    scale = math.sqrt(species.size * temperature / (0.5 * np.sum(mass[:, None] * velocity**2)))
    ids = np.arange(species.size, dtype=np.int64)
    return State(0.0, ids, species.astype(np.int32), mass, radius, position, velocity * scale)


def rotation(position, velocity, mass, place: Enclosure) -> np.ndarray:
    """(n, 2): velocities of a rigid body with the angular momentum that the gas has about the middle."""
    arm = position - place.size / 2
    spin = mass @ (arm[:, 0] * velocity[:, 1] - arm[:, 1] * velocity[:, 0])
    return spin / (mass @ np.sum(arm**2, axis=1)) * np.stack([-arm[:, 1], arm[:, 0]], axis=1)


def kinetic_energy(state: State) -> float:
    return 0.5 * float(np.sum(state.mass[:, None] * state.velocity**2))


@dataclass
class Run:
    """A gas on its way."""

    place: Enclosure
    state: State
    engine: EventDriven

    def advance(self, duration: float) -> Tallies:
        """Go on, and return what was added to the tallies."""
        before = self.engine.tallies.copy()
        assert self.engine.advance(self.state, self.state.time + duration) is Status.DONE
        return self.engine.tallies - before

    def collect(self, duration: float) -> Contacts:
        """Go on, and return all contacts."""
        until, parts = self.state.time + duration, []
        self.engine.contacts = contacts = Contacts.empty(1 << 14)
        status = Status.FULL
        while status is Status.FULL:
            status = self.engine.advance(self.state, until)
            names = ("kind", "time", "first", "second", "impulse")
            parts.append([getattr(contacts, name)[: contacts.count].copy() for name in names])
            contacts.clear()
        columns = [np.concatenate(column) for column in zip(*parts, strict=True)]
        self.engine.contacts = Contacts.empty(0)
        return Contacts(len(columns[0]), *columns)

    @property
    def temperature(self) -> float:
        """K/N."""
        return kinetic_energy(self.state) / self.state.count


def run(place: Enclosure, state: State, seed: int = 5) -> Run:
    """By the event-driven dynamics."""
    species = int(state.species.max()) + 1
    tallies = Tallies.zero(species, len(place.walls))
    return Run(place, state, EventDriven(state, place, tallies, Contacts.empty(0), None, seed))


def mean_and_error(values) -> tuple[np.ndarray, np.ndarray]:
    """Mean of independent values (n, ...) and its standard error."""
    array = np.asarray(values, np.float64)
    return array.mean(axis=0), array.std(axis=0, ddof=1) / math.sqrt(len(array))


def agrees(values, expected, bias=0.0, least: float = 0.0) -> None:
    """Assert that the mean of independent values is `expected`.

    Parameters
    ----------
    values : (n, ...), from blocks or seeds
    bias : how far the expected value may be off
    least : standard errors must be below this part of the expected value, or the test tells nothing; 0 for no such
    """
    mean, error = mean_and_error(values)
    # Student's t of n - 1 degrees of freedom, at the level of four and a half Gaussian standard errors, 7e-6.
    reach = float(student.isf(3.4e-6, len(values) - 1))
    report = f"{mean} +- {error}, expected {expected}"
    print(report)  # pytest shows it if the test fails
    assert np.all(np.abs(mean - expected) <= reach * error + bias), report
    if least:
        assert np.all(error < least * np.abs(expected)), report
