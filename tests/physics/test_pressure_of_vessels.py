"""The same gas in vessels of every shape: one pressure on all walls, hits by area and perimeter, momentum.

Discs of radius 0.1 at 0.1 a unit of accessible area: of area fraction 0.003, so that layers at walls and corners, of
the order of the area fraction in Z - 1, stay below 1e-3 of the pressure: `LAYERS`.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from vessels import agrees, gas, kinetic_energy, mean_and_error, run, vessel

from gasbox import observe
from gasbox.geometry import (
    Block,
    Circle,
    Piston,
    Polygon,
    Post,
    Rectangle,
    Segment,
    Sinusoid,
    regular_polygon,
)
from gasbox.state import ContactKind
from gasbox.theory import finite, walls

RADIUS, DENSITY, LAYERS, BLOCKS = 0.1, 0.1, 1e-3, 12
BOX = Rectangle(20, 20)
L_SHAPE = Polygon(((0, 0), (28, 0), (28, 12), (12, 12), (12, 24), (0, 24)))
POSTS = (
    Post((5.0, 5.0), 2.0),
    Block(((4.0, 13.0), (8.0, 14.0), (5.0, 18.0))),
    Segment((10.0, 0.0), (10.0, 7.0)),
    Segment((10.0, 20.0), (10.0, 12.0)),
    Segment((13.0, 6.0), (17.0, 11.0)),
)


def star() -> Polygon:
    angle = np.pi / 2 + np.arange(10) * np.pi / 5
    reach = np.where(np.arange(10) % 2 == 0, 16.0, 8.0)
    corner = np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=1)
    return Polygon(tuple(map(tuple, (corner - corner.min(axis=0)).tolist())))


SHAPES = {
    "square": vessel(BOX),
    "hexagon": vessel(Polygon(regular_polygon(6, 12.0, 0.2))),
    "L": vessel(L_SHAPE),
    "star": vessel(star()),
    "circle": vessel(Circle(12.0)),
    "posts and dividers": vessel(BOX, POSTS),
}


@dataclasses.dataclass
class Blocks:
    """What blocks of a run gave."""

    place: object
    count: int
    energy: float
    duration: float
    changes: list

    @property
    def virial_pressure(self) -> float:
        """P A = K + the virial of pairs: exact. Of a circle, which keeps L = 0, K is half a T less than N T."""
        virial = sum(change.pair_virial[0] for change in self.changes) / (2 * BLOCKS * self.duration)
        return (self.energy + virial) / self.area

    @property
    def area(self) -> float:
        return self.place.accessible_area(RADIUS)

    @property
    def length(self) -> np.ndarray:
        return np.array([self.place.accessible_length(wall, RADIUS) for wall in range(len(self.place.walls))])


@pytest.fixture(scope="module", params=SHAPES)
def blocks(request) -> Blocks:
    place = SHAPES[request.param]
    count = round(DENSITY * place.accessible_area(RADIUS))
    at = run(place, gas(place, [count], [RADIUS]))
    at.advance(200.0)
    return Blocks(place, count, kinetic_energy(at.state), 2500.0, [at.advance(2500.0) for _ in range(BLOCKS)])


def test_pressure_is_the_same_on_every_wall(blocks):
    # Of all walls of all six shapes, some forty, none is off by more than the level of 4.5 standard errors.
    pressure = [change.wall_impulse[:, 0] / (blocks.duration * blocks.length) for change in blocks.changes]
    agrees(pressure, blocks.virial_pressure, LAYERS * blocks.virial_pressure, least=0.03)


def test_pressure_on_all_walls_is_the_virial_pressure(blocks):
    whole = blocks.length.sum()
    pressure = [change.wall_impulse.sum() / (blocks.duration * whole) for change in blocks.changes]
    agrees(pressure, blocks.virial_pressure, LAYERS * blocks.virial_pressure, least=0.005)


def test_pressure_does_not_depend_on_the_shape(blocks):
    # P A/K = 1 + B_2 n (1 - 1/N), B_2 = pi sigma²/2: the same 1.0061 for all, of the accessible area.
    second = 0.5 * math.pi * (2 * RADIUS) ** 2 * DENSITY * (1 - 1 / blocks.count)
    unit = blocks.duration * blocks.length.sum() * blocks.energy / blocks.area
    agrees([change.wall_impulse.sum() / unit for change in blocks.changes], 1 + second, LAYERS, least=0.005)


def test_hits_by_area_and_perimeter(blocks):
    # N vbar P/(pi A) with the density at the wall, P/T, and times 1 + 1/(4 f) because the energy is fixed.
    freedom = observe.degrees_of_freedom(blocks.count, blocks.place)
    temperature = 2 * blocks.energy / freedom
    count = blocks.virial_pressure * blocks.area / temperature
    rate = walls.wall_hit_rate(count, 1.0, temperature, blocks.length.sum(), blocks.area)
    rate *= finite.rate_factor(freedom)
    hits = [change.wall_collisions.sum() / blocks.duration for change in blocks.changes]
    agrees(hits, rate, LAYERS * rate, least=0.006)


PUSHED = SHAPES | {
    "circle falling": vessel(Circle(12.0), gravity=(0.03, -0.1)),
    "star falling": vessel(star(), gravity=(0.03, -0.1)),
    "posts and dividers falling": vessel(BOX, POSTS, (0.0, -0.1)),
    "warm walls": vessel(BOX, POSTS, (0.0, -0.1), left={"temperature": 2.0}, o0={"temperature": 0.5}),
    "shaken": vessel(BOX, top={"motion": Sinusoid(0.7, 9.0)}, gravity=(0.0, -0.1)),
    "lid": vessel(BOX, top={"motion": Piston(20.0, 0.1)}, gravity=(0.0, -0.1)),
}


@pytest.mark.parametrize("place", PUSHED.values(), ids=PUSHED.keys())
def test_walls_and_weight_make_up_the_change_of_momentum(place):
    # Newton's second law for the whole gas: impulses of all walls, plus N m g t; exact.
    state = gas(place, [25, 15], [RADIUS, 0.2], [1.0, 3.0])
    before = state.mass @ state.velocity
    at = run(place, state)
    contacts = at.collect(200.0)
    hits = contacts.kind == ContactKind.WALL
    assert hits.sum() > 200
    pushed = contacts.impulse[hits].sum(axis=0)
    weight = state.mass.sum() * np.array(place.gravity) * 200.0
    change = state.mass @ state.velocity - before
    assert change == pytest.approx(pushed + weight, abs=1e-12 * np.abs(contacts.impulse[hits]).sum())
    # Impulses by wall are those of the tallies.
    for wall in range(len(place.walls)):
        mine = contacts.impulse[hits & (contacts.second == wall)]
        total = at.engine.tallies.wall_impulse[wall].sum()
        assert np.hypot(*mine.T).sum() >= total * (1 - 1e-12)
        if place.walls[wall].temperature is None:
            assert np.hypot(*mine.T).sum() == pytest.approx(total, rel=1e-12)


def test_blocks_are_independent():
    # Their scatter is that of independent hits, sqrt(4/(pi hits)), within its own error of 1/sqrt(2 blocks).
    place = SHAPES["square"]
    at = run(place, gas(place, [37], [RADIUS], seed=2))
    at.advance(200.0)
    changes = [at.advance(2500.0) for _ in range(2 * BLOCKS)]
    pressure = [change.wall_impulse[:2].sum() for change in changes]
    mean, error = mean_and_error(pressure)
    hits = sum(change.wall_collisions[:2].sum() for change in changes)
    assert error / mean < math.sqrt(4 / math.pi / hits) * (1 + 4 / math.sqrt(4 * BLOCKS))
