"""Under forces discs start about as close as their forces let them, whatever their radius on the screen."""

import math

import numpy as np
import pytest
from placed_gases import deepest_by_hand

from gasbox.errors import ScenarioError
from gasbox.initial import populate
from gasbox.scenario import parse

CORE = 0.9


def gas(fraction, *species, container=None, **sections):
    """A gas whose cores, 0.9 sigma wide, fill `fraction` of a periodic box, a fixed circle or anything else."""
    area = sum(entry["count"] * math.pi / 4 * (CORE * entry.get("sigma", 1.0)) ** 2 for entry in species)
    width = math.sqrt(area / fraction)
    if container == "circle":
        container = {"shape": "circle", "radius": width / math.sqrt(math.pi)}
    usual = {"radius": 0.5, "temperature": 1.0}
    return parse(
        {
            "container": container or {"width": width, "height": width, "periodic": ["x", "y"]},
            "species": [{"name": str(number), **usual, **entry} for number, entry in enumerate(species)],
            "dynamics": {"kind": "forced"},
            **sections,
        }
    )


def closest(state, geometry):
    """Least distance [length] of two centres."""
    return float((2 * state.radius.max() - deepest_by_hand(state, geometry)).min())


@pytest.mark.parametrize("fraction", [0.1, 0.34, 0.5, 0.7])
@pytest.mark.parametrize("radius", [0.3, 0.5, 0.7])
def test_one_kind_up_to_seven_tenths(fraction, radius):
    scenario = gas(fraction, {"count": 600, "sigma": 1.0, "radius": radius})
    state = populate(scenario)
    assert closest(state, scenario.geometry()) >= CORE * (1 - 1e-9)


@pytest.mark.parametrize("container", [None, "circle"])
@pytest.mark.parametrize("fraction", [0.4, 0.55, 0.7])
def test_several_kinds_up_to_seven_tenths(container, fraction):
    kinds = {"count": 300, "sigma": 1.0}, {"count": 200, "sigma": 1.3, "radius": 0.6}
    scenario = gas(fraction, *kinds, container=container)
    state = populate(scenario)
    small = state.species == 0
    position = state.position[small]
    difference = position[:, None] - position[None]
    size = scenario.geometry().size
    difference -= np.where(scenario.geometry().periodic, np.round(difference / size) * size, 0)
    distance = np.hypot(difference[..., 0], difference[..., 1]) + 9 * np.eye(len(position))
    assert distance.min() > 0.55 * CORE
    assert scenario.geometry().holds(state.position, state.radius * (1 - 1e-9)).all()


def test_walls_are_one_radius_away():
    box = {"width": 30, "height": 20}
    scenario = gas(0.5, {"count": 300, "sigma": 1.0, "radius": 0.8}, container=box, gravity=[0, -1])
    position = populate(scenario).position
    assert (position >= 0.8 - 1e-12).all()
    assert (position <= np.array([29.2, 19.2]) + 1e-12).all()


def test_a_density_beyond_that_is_refused():
    with pytest.raises(ScenarioError) as caught:
        gas(0.72, {"count": 600})
    (problem,) = caught.value.problems
    assert (problem.path, problem.found) == ("species[0].count", "an area fraction of 0.72")
    assert problem.allowed.startswith("at most 0.7 for discs 0.9 sigma wide")


def test_listed_discs_may_overlap():
    listed = [{"species": "0", "position": [5, 5]}, {"species": "0", "position": [5.2, 5]}]
    state = populate(gas(0.3, {"count": 50}, particles=listed))
    assert state.position[:2].tolist() == [[5, 5], [5.2, 5]]
    away = np.hypot(*(state.position[2:] - [5, 5]).T)
    assert away.min() >= CORE * (1 - 1e-9)


@pytest.mark.small
def test_without_the_compiler():
    scenario = gas(0.6, {"count": 12})
    assert closest(populate(scenario), scenario.geometry()) >= CORE * (1 - 1e-9)
