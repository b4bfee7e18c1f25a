"""Enclosures of every kind, and gases in them, made without any engine."""

from __future__ import annotations

import dataclasses

import numpy as np
from gases import separation, state_of

from gasbox.dynamics import EventDriven
from gasbox.geometry import (
    Block,
    Circle,
    Enclosure,
    Passage,
    Path,
    Piston,
    Polygon,
    Post,
    Rectangle,
    Segment,
    Sinusoid,
    Wall,
    regular_polygon,
    side_names,
)
from gasbox.state import Contacts, State, Tallies

DOWN = (0.03, -0.2)


def enclosure(container, obstacles=(), gravity=(0.0, 0.0), **walls) -> Enclosure:
    """Obstacles are called o0, o1, ...; `walls`: name (with _ for -) -> properties."""
    names = [*side_names(container), *(f"o{k}" for k in range(len(obstacles)))]
    properties = {name.replace("_", "-"): entry for name, entry in walls.items()}
    assert set(properties) <= set(names)
    found = tuple(Wall(name, **properties.get(name, {})) for name in names)
    return Enclosure(container, tuple(obstacles), found, gravity)


def star(points: int = 5, outer: float = 10.0, inner: float = 4.5) -> Polygon:
    angle = np.pi / 2 + np.arange(2 * points) * np.pi / points
    reach = np.where(np.arange(2 * points) % 2 == 0, outer, inner)
    corner = np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=1)
    corner -= corner.min(axis=0)
    return Polygon(tuple(map(tuple, corner.tolist())))


BOX = Rectangle(16, 12)
POSTS = (
    Post((4.0, 4.0), 1.5),
    Block(((9.0, 3.0), (13.0, 4.0), (10.0, 7.0))),
    Segment((2.0, 8.0), (7.0, 9.5)),
)
DIVIDER = Segment((8.0, 0.0), (8.0, 12.0))
GAP = (Segment((8.0, 0.0), (8.0, 4.5)), Segment((8.0, 12.0), (8.0, 7.0)))

AT_REST = {
    "hexagon": enclosure(Polygon(regular_polygon(6, 8.0, 0.2))),
    "circle": enclosure(Circle(8.0)),
    "circle falling": enclosure(Circle(8.0), gravity=DOWN),
    "star": enclosure(star()),
    "star falling": enclosure(star(), gravity=DOWN),
    "box falling": enclosure(BOX, gravity=DOWN),
    "obstacles": enclosure(BOX, POSTS),
    "obstacles falling": enclosure(BOX, POSTS, DOWN),
    "slab": enclosure(
        Rectangle(16, 12, True), (Post((15.5, 6.0), 1.5), Segment((0.0, 3.0), (5.0, 3.5))), (0.0, -0.2)
    ),
    "periodic": enclosure(
        Rectangle(16, 12, True, True), (Post((1.0, 0.5), 1.5), Segment((5.0, 12.0), (9.0, 11.0)))
    ),
    "gap": enclosure(BOX, GAP),
}
ACTIVE = {
    "warm": enclosure(BOX, left={"temperature": 2.0}, right={"temperature": 0.5}),
    "warm circle": enclosure(Circle(8.0), gravity=DOWN, rim={"temperature": 1.0}),
    "compressed": enclosure(BOX, right={"motion": Path((3.0, 20.0), (0.0, -3.4), (-0.2, 0.0))}),
    "shaken": enclosure(BOX, top={"motion": Sinusoid(0.7, 9.0, 0.4)}, gravity=DOWN),
    "swinging bar": enclosure(
        BOX, (Segment((8.0, 3.0), (8.0, 9.0)),), DOWN, o0={"motion": Sinusoid(1.5, 15.0)}
    ),
    "moving bar": enclosure(
        BOX, (Segment((6.0, 3.0), (8.0, 9.0)),), o0={"motion": Path((0.0, 10.0), (0.0, 2.0), (0.2, -0.1))}
    ),
    "moving post": enclosure(
        BOX,
        (Post((5.0, 4.0), 1.5, (0.0, 1.0)),),
        o0={"motion": Path((0.0, 8.0, 14.0), (0.0, 4.0, 1.0), (0.5, -0.5, 0.1))},
    ),
    "swinging cap": enclosure(
        BOX, (Post((-3.0, 6.0), 5.0, (0.0, 1.0)),), DOWN, o0={"motion": Sinusoid(1.5, 15.0)}
    ),
    "lid": enclosure(BOX, gravity=(0.0, -0.05), top={"motion": Piston(10.0, 0.3)}),
    "two chambers": enclosure(BOX, (DIVIDER,), o0={"motion": Piston(5.0)}),
    "membrane": enclosure(BOX, (DIVIDER,), o0={"passes": Passage((1,))}),
    "gate": enclosure(BOX, (DIVIDER,), DOWN, o0={"passes": Passage(None, "forward", 0.5, 2.0)}),
    "warm piston": enclosure(
        BOX, right={"motion": Piston(8.0, 0.4), "temperature": None}, left={"temperature": 1.0}
    ),
}
ALL = AT_REST | ACTIVE


def fill(place: Enclosure, count: int = 24, seed: int = 1, sizes=(0.5, 0.3), masses=(1.0, 3.0)) -> State:
    """Discs of two species in turn, at random places clear of walls and of each other."""
    rng = np.random.default_rng(seed)
    species = np.arange(count) % 2
    radius, mass = np.array(sizes)[species], np.array(masses)[species]
    position = np.zeros((0, 2))
    while len(position) < count:
        at, r = rng.random(2) * place.size, radius[len(position)]
        away = separation(at - position, place)
        near = np.hypot(away[:, 0], away[:, 1]) < (r + radius[: len(position)]) * (1 + 1e-9)
        if place.holds(at[None], np.array([r * (1 + 1e-9)]))[0] and not near.any():
            position = np.concatenate([position, at[None]])
    velocity = rng.normal(size=(count, 2)) / np.sqrt(mass)[:, None]
    return state_of(position, velocity, radius, mass, species)


def event_driven(state: State, place: Enclosure, contacts: int = 0, memory=None) -> EventDriven:
    tallies = Tallies.zero(2, len(place.walls))
    return EventDriven(state, place, tallies, Contacts.empty(contacts), memory, seed=5)


def internal_energy(state: State, place: Enclosure) -> float:
    """Kinetic and potential."""
    kinetic = 0.5 * (state.mass * (state.velocity**2).sum(axis=1)).sum()
    return float(kinetic - (state.mass * (state.position @ np.array(place.gravity))).sum())


def deepest(state: State, place: Enclosure) -> float:
    """Largest overlap of two discs over the smaller radius; by all pairs."""
    worst = 0.0
    for i in range(state.count - 1):
        away = separation(state.position[i + 1 :] - state.position[i], place)
        depth = state.radius[i] + state.radius[i + 1 :] - np.hypot(away[:, 0], away[:, 1])
        worst = max(worst, float((depth / np.minimum(state.radius[i], state.radius[i + 1 :])).max()))
    return worst


def still(place: Enclosure) -> Enclosure:
    """Without motion of its walls."""
    return dataclasses.replace(
        place, walls=tuple(dataclasses.replace(wall, motion=None) for wall in place.walls)
    )


def angular_momentum(state: State, center) -> float:
    away = state.position - np.array(center)
    return float((state.mass * (away[:, 0] * state.velocity[:, 1] - away[:, 1] * state.velocity[:, 0])).sum())
