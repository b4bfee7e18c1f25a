"""Gases that no one would set up on purpose: any sizes, masses and speeds, discs that touch each other and walls."""

from __future__ import annotations

import math

import numpy as np
from gases import separation, state_of

from gasbox.geometry import Rectangle
from gasbox.state import State


def odd_gas(seed: int) -> tuple[State, Rectangle]:
    """2 to 40 discs; sizes up to 1:50, masses over six decades, speeds zero, thermal or ten thousand times that."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(2, 41))
    radius = rng.choice([1.0, 3.0, 50.0]) ** -rng.uniform(0, 1, count)
    radius[0] = 1.0
    mass = 10.0 ** rng.uniform(-3, 3, count)
    geometry = _box(rng, radius)
    position = _places(rng, radius, geometry)
    there = ~np.isnan(position[:, 0])
    radius, mass, position = radius[there], mass[there], position[there]
    speed = rng.choice([0.0, 1.0, 1e4], p=rng.dirichlet([1.0, 4.0, 0.5]), size=radius.size)
    speed[rng.integers(radius.size)] = 1.0
    velocity = (speed / np.sqrt(mass))[:, None] * rng.normal(size=(radius.size, 2))
    if rng.random() < 0.2:
        velocity[:, rng.integers(2)] = 0.0
    time = 0.0 if rng.random() < 0.5 else float(rng.uniform(0, 1000))
    return state_of(position, velocity, radius, mass, time=time), geometry


def _box(rng: np.random.Generator, radius) -> Rectangle:
    fraction = rng.uniform(0.02, 0.5)
    area = math.pi * float((radius**2).sum()) / fraction
    aspect = rng.uniform(0.5, 2.0)
    least = 2.0 * float(radius.max()) * (1.0 if rng.random() < 0.1 else 1.001)
    width = max(math.sqrt(area * aspect), least)
    return Rectangle(width, max(area / width, least), *map(bool, rng.integers(0, 2, 2)))


def _places(rng: np.random.Generator, radius, geometry: Rectangle):
    """Places one after the other, at random or touching a disc or a wall; not-a-number where there was no room."""
    position = np.full((radius.size, 2), np.nan)
    touching = rng.choice([0.0, 0.5, 0.95])
    for i in range(radius.size):
        placed = np.flatnonzero(~np.isnan(position[:, 0]))
        for _ in range(300):
            at = _place(rng, i, radius, position, placed, geometry, rng.random() < touching)
            margin = np.where(geometry.periodic, 0.0, radius[i])
            if np.any(at < margin) or np.any(at > geometry.size - margin):
                continue
            d = separation(at - position[placed], geometry)
            # What touches may overlap by rounding.
            if np.all(np.hypot(d[:, 0], d[:, 1]) >= (radius[i] + radius[placed]) * (1 - 1e-14)):
                position[i] = at
                break
    return position


def _place(rng, i, radius, position, placed, geometry, touching):
    margin = np.where(geometry.periodic, 0.0, radius[i])
    at = rng.uniform(margin, np.maximum(geometry.size - margin, margin))
    if touching and placed.size and rng.random() < 0.8:
        j = rng.choice(placed)
        angle = rng.choice([rng.uniform(0, 2 * math.pi), math.pi / 2 * rng.integers(4)])
        along = np.array([math.cos(angle), math.sin(angle)])
        along[np.abs(along) < 1e-9] = 0.0
        at = position[j] + (radius[i] + radius[j]) * along
        return geometry.wrap(at[None])[0]
    if touching:
        axis = rng.integers(2)
        at[axis] = rng.choice([margin[axis], geometry.size[axis] - margin[axis]])
    return at
