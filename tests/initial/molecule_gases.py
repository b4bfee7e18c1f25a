"""Small gases of molecules, and the plain answer to whether their discs overlap, by a tree."""

import math

import numpy as np
from scipy.spatial import KDTree

from gasbox.scenario import parse

DUMBBELL = {"atoms": [{"position": [0, 0], "radius": 0.5}, {"position": [1, 0], "radius": 0.5}]}
BENT = {
    "atoms": [
        {"position": [0, 0], "radius": 0.6, "mass": 4},
        {"position": [0.8, 0.4], "radius": 0.4},
        {"position": [-0.8, 0.4], "radius": 0.4},
    ]
}


def rod(aspect, radius=0.5):
    """A stick of discs at a distance of one radius."""
    return {
        "atoms": [{"position": [radius * k, 0.3], "radius": radius} for k in range(round(2 * aspect) - 1)]
    }


def molecule(shape, count=0, **more):
    return {"name": "molecule", "count": count, "temperature": 1, **shape, **more}


def gas(shape, count, fraction, periodic=("x", "y"), aspect=1.0, seed=1, **more):
    """A rectangle of which `count` molecules fill a fraction."""
    one = parse({"container": {"width": 1000, "height": 1000}, "molecules": [molecule(shape)]}).kinds[0]
    area = count * one.area / fraction
    width = math.sqrt(area * aspect)
    box = {"width": width, "height": area / width, "periodic": list(periodic)}
    return parse({"seed": seed, "container": box, "molecules": [molecule(shape, count)], **more})


def deepest(state, geometry):
    """Depth [length] of the deepest overlap of two discs of different particles; 0 if there is none."""
    sites, owner = state.sites, state.sites.owner
    # A copy of everything round each period, so that no tree needs to know of periods.
    shifts = [geometry.size * (x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    shifts = [shift for shift in shifts if not shift[~geometry.periodic].any()]
    inside = geometry.wrap(sites.position)
    every = np.concatenate([inside + shift for shift in shifts])
    near = KDTree(inside).query_ball_tree(KDTree(every), 2 * sites.radius.max())
    first = np.repeat(np.arange(sites.count), [len(found) for found in near])
    image = np.concatenate([np.array(found, int) for found in near])
    second = image % sites.count
    apart = np.hypot(*(inside[first] - every[image]).T)
    depth = (sites.radius[first] + sites.radius[second] - apart)[owner[first] != owner[second]]
    return depth.max(initial=0.0)


def assert_molecules_in_place(state, geometry):
    """No two molecules overlap beyond rounding, and all their discs lie inside the walls."""
    sites = state.sites
    assert deepest(state, geometry) <= 1e-10 * sites.radius.min()
    inside = geometry.wrap(sites.position)
    assert geometry.holds(inside, sites.radius * (1 - 1e-10)).all()
    assert ((state.position >= 0) & (state.position <= geometry.size)).all()
