"""Small scenarios, and the plain all-pairs answer to where discs overlap."""

import math

import numpy as np

from gasbox.scenario import parse


def gas(counts, radii, fraction, aspect=1.0, periodic=(), seed=1, **species):
    """A scenario whose discs fill `fraction` of a rectangle."""
    area = sum(count * math.pi * radius**2 for count, radius in zip(counts, radii, strict=True)) / fraction
    width = math.sqrt(area * aspect)
    return parse(
        {
            "seed": seed,
            "container": {"width": width, "height": area / width, "periodic": list(periodic)},
            "species": [
                {"name": str(number), "radius": radius, "count": count, "temperature": 1, **species}
                for number, (count, radius) in enumerate(zip(counts, radii, strict=True))
            ],
        }
    )


def deepest_by_hand(state, geometry):
    """Depth [length] of the deepest overlap of two discs, by all pairs; negative if there is none."""
    difference = state.position[:, None] - state.position[None]
    difference -= np.where(geometry.periodic, np.round(difference / geometry.size) * geometry.size, 0)
    depth = state.radius[:, None] + state.radius[None] - np.sqrt(np.square(difference).sum(axis=2))
    np.fill_diagonal(depth, -np.inf)
    return depth


def assert_in_place(state, geometry):
    """No two discs overlap beyond rounding, and all lie inside the walls."""
    if state.count > 1:
        assert deepest_by_hand(state, geometry).max() <= 1e-11 * state.radius.min()
    assert geometry.holds(state.position, state.radius).all()
    assert ((state.position >= 0) & (state.position <= geometry.size)).all()
