"""Placement between walls of any shape: everywhere, clear of everything, or refused with the reason."""

import math

import numpy as np
import pytest
import shapely

from gasbox.errors import ScenarioError
from gasbox.geometry.region import components
from gasbox.initial import populate, separate, worst_overlap
from gasbox.scenario import parse

SQUARE = {"width": 40, "height": 30}
STAR = [
    [
        20 + (20 if k % 2 else 9) * math.cos(math.pi * k / 5),
        20 + (20 if k % 2 else 9) * math.sin(math.pi * k / 5),
    ]
    for k in range(10)
]
WALLED = {
    "circle": ({"shape": "circle", "radius": 20}, []),
    "hexagon": ({"shape": "regular-polygon", "sides": 6, "radius": 20}, []),
    "star": ({"shape": "polygon", "vertices": STAR}, []),
    "two chambers": (SQUARE, [{"shape": "segment", "start": [15, 0], "end": [15, 30]}]),
    "gap": (SQUARE, [{"shape": "segment", "start": [15, 0], "end": [22, 21]}]),
    "post and block": (
        SQUARE,
        [
            {"shape": "disc", "center": [10, 15], "radius": 6},
            {"shape": "polygon", "vertices": [[20, 5], [35, 5], [30, 25]]},
        ],
    ),
    "periodic": (
        {**SQUARE, "periodic": ["x"]},
        [
            {"shape": "disc", "center": [1, 15], "radius": 5},
            {"shape": "segment", "start": [0, 8], "end": [40, 8]},
        ],
    ),
}


def gas(container, obstacles, fraction, radii=(0.5,), **more):
    base = {"container": container, "obstacles": obstacles, "species": [{"name": "a", "radius": 0.1}]}
    area = parse(base).geometry().area * fraction / len(radii)
    species = [
        {"name": str(number), "radius": radius, "count": int(area / (math.pi * radius**2)), "temperature": 1}
        for number, radius in enumerate(radii)
    ]
    return parse({**base, "species": species, **more})


def distances(scenario, state):
    """(n,) distance of each centre from the nearest wall, less the radius; negative beyond one."""
    geometry = scenario.geometry()
    best = np.full(state.count, np.inf)
    points = shapely.points(state.position)
    shape = geometry.container
    if hasattr(shape, "radius"):
        best = shape.radius - np.hypot(*(state.position - shape.center).T)
    elif hasattr(shape, "vertices"):
        ring = shapely.Polygon(shape.vertices)
        best = np.where(shapely.contains(ring, points), 1, -1) * shapely.distance(ring.boundary, points)
    else:
        away = np.stack([state.position, geometry.size - state.position])
        best = np.where(geometry.periodic, np.inf, away).min(axis=(0, 2))
    for entry in scenario.obstacles:
        for turn in (-1, 0, 1) if geometry.periodic_x else (0,):
            by = np.array([turn * geometry.width, 0.0])
            if entry.shape == "disc":
                away = np.hypot(*(state.position - entry.center - by).T) - entry.radius
            elif entry.shape == "segment":
                away = shapely.distance(shapely.LineString(np.array([entry.start, entry.end]) + by), points)
            else:
                away = shapely.distance(shapely.Polygon(np.array(entry.vertices) + by), points)
            best = np.minimum(best, away)
    return best - state.radius


@pytest.mark.parametrize("radii", [(0.5,), (1.2, 0.5, 0.2)])
@pytest.mark.parametrize("fraction", [0.1, 0.497])
@pytest.mark.parametrize("shape", WALLED)
def test_discs_are_placed_in_every_shape(shape, fraction, radii):
    scenario = gas(*WALLED[shape], fraction, radii)
    state = populate(scenario)
    assert state.count == sum(entry.count for entry in scenario.species)
    apart = state.position[:, None] - state.position
    geometry = scenario.geometry()
    apart -= np.where(geometry.periodic, np.round(apart / geometry.size) * geometry.size, 0)
    gap = np.hypot(apart[..., 0], apart[..., 1]) - state.radius[:, None] - state.radius
    np.fill_diagonal(gap, np.inf)
    assert gap.min() > -1e-11
    assert distances(scenario, state).min() > -1e-11
    assert worst_overlap(state, geometry) is None


def test_chambers_are_filled_in_proportion():
    scenario = gas(*WALLED["two chambers"], 0.2)
    state = populate(scenario)
    left, right = (part.area for part in components(scenario.geometry(), 0.5))
    expected = state.count * left / (left + right)
    assert abs((state.position[:, 0] < 15).sum() - expected) < 5 * math.sqrt(expected)


def test_a_region_is_kept_in_a_circle():
    scenario = gas(*WALLED["circle"], 0.1)
    species = [{**scenario.to_dict()["species"][0], "region": {"x": [0, 20]}}]
    state = populate(parse({**scenario.to_dict(), "species": species}))
    assert (state.position[:, 0] <= 19.5).all()


def test_a_rectangle_with_gravity_is_filled_like_a_bare_one():
    bare = gas(SQUARE, [], 0.6)
    heavy = gas(SQUARE, [], 0.6, gravity=[0, -1])
    np.testing.assert_array_equal(populate(bare).position, populate(heavy).position)


@pytest.mark.parametrize("shape", WALLED)
def test_overlaps_with_walls_are_found_and_undone(shape):
    scenario = gas(*WALLED[shape], 0.3)
    state, geometry = populate(scenario), scenario.geometry()
    random = np.random.default_rng(3)
    state.position += random.uniform(-0.2, 0.2, state.position.shape)
    worst = worst_overlap(state, geometry)
    apart = distances(scenario, state)
    if worst.wall is not None:
        assert worst.depth == pytest.approx(-apart.min())
        assert worst.first == apart.argmin()
        assert worst.wall in geometry.wall_names
    else:
        assert worst.depth >= -apart.min()
    separate(state, geometry)
    assert worst_overlap(state, geometry) is None
    assert distances(scenario, state).min() > -1e-9


def test_who_passes_a_membrane_may_lie_in_it():
    membrane = {"shape": "segment", "start": [15, 0], "end": [15, 30], "passes": ["0"], "name": "skin"}
    scenario = gas(SQUARE, [], 0.0)
    found = parse(
        {
            **scenario.to_dict(),
            "species": [{"name": "0", "radius": 0.5}],
            "obstacles": [membrane],
            "particles": [{"species": "0", "position": [15.2, 10]}],
        }
    )
    assert worst_overlap(populate(found), found.geometry()) is None
    del membrane["passes"]
    solid = parse({**found.to_dict(), "obstacles": [membrane]})
    worst = worst_overlap(populate(solid), solid.geometry())
    assert (worst.wall, worst.depth) == ("skin", pytest.approx(0.3))


def test_no_place_is_refused_with_the_reason():
    # Half of the area lies in slits too narrow for them.
    slits = [{"shape": "segment", "start": [x, 0], "end": [x, 30]} for x in range(1, 21)]
    with pytest.raises(ScenarioError, match="area fraction"):
        populate(gas(SQUARE, slits, 0.49, radii=(0.9,)))


@pytest.mark.small
def test_without_the_compiler():
    scenario = gas({"shape": "circle", "radius": 6}, [{"shape": "disc", "center": [6, 6], "radius": 2}], 0.4)
    species = [{**scenario.to_dict()["species"][0], "radius": 1, "count": 12}]
    scenario = parse({**scenario.to_dict(), "species": species})
    assert distances(scenario, populate(scenario)).min() > -1e-11
