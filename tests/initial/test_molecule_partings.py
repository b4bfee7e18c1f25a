"""Overlaps of molecules are found as all pairs find them, and undone by moving and turning rigid bodies."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from molecule_gases import BENT, DUMBBELL, assert_molecules_in_place, deepest, gas, molecule, rod

from gasbox.errors import ScenarioError
from gasbox.initial import populate, separate, worst_overlap
from gasbox.scenario import parse


def jolted(state, geometry, size, seed):
    """Everybody moved and turned a little, as if nobody were in the way."""
    random = np.random.default_rng(seed)
    state.position += size * random.standard_normal(state.position.shape)
    state.position[:] = geometry.wrap(state.position)
    state.angle += size * random.standard_normal(state.count)
    state.turn_sites()
    return state


@settings(max_examples=30, deadline=None, derandomize=True)
@given(
    st.sampled_from([DUMBBELL, BENT, rod(5)]),
    st.sampled_from([(), ("x",), ("x", "y")]),
    st.integers(0, 2**32),
)
def test_the_worst_pair_is_that_of_all_pairs(shape, periodic, seed):
    scenario = gas(shape, 40, 0.3, periodic)
    geometry = scenario.geometry()
    state = jolted(populate(scenario), geometry, 0.2, seed)
    state.id *= 3
    expected, found = deepest(state, geometry), worst_overlap(state, geometry)
    if found is None:
        assert expected <= 1e-9
    elif found.wall is None:
        assert found.depth == pytest.approx(expected, rel=1e-10)
        assert found.first < found.second
        assert {found.first % 3, found.second % 3} == {0}
    else:
        assert found.depth >= expected


@settings(max_examples=25, deadline=None, derandomize=True)
@given(
    st.sampled_from([DUMBBELL, BENT, rod(5)]),
    st.sampled_from([(), ("x",), ("x", "y")]),
    st.floats(0.01, 0.2),
    st.integers(0, 2**32),
)
def test_what_overlaps_is_parted(shape, periodic, size, seed):
    scenario = gas(shape, 60, 0.35, periodic)
    geometry = scenario.geometry()
    state = jolted(populate(scenario), geometry, size, seed)
    worst = worst_overlap(state, geometry)
    moved = separate(state, geometry)
    assert_molecules_in_place(state, geometry)
    assert worst_overlap(state, geometry) is None
    assert (moved > 0) == (worst is not None)
    assert moved < 3


def test_between_posts_and_sloping_walls():
    scenario = parse(
        {
            "container": {"shape": "polygon", "vertices": [[0, 0], [26, 0], [20, 20], [0, 16]]},
            "obstacles": [
                {"shape": "disc", "center": [8, 8], "radius": 2},
                {"shape": "segment", "start": [14, 4], "end": [14, 12]},
            ],
            "molecules": [molecule(BENT, 40)],
        }
    )
    geometry = scenario.geometry()
    state = jolted(populate(scenario), geometry, 0.3, 5)
    assert worst_overlap(state, geometry) is not None
    separate(state, geometry)
    assert_molecules_in_place(state, geometry)


def test_the_centre_of_mass_of_a_pair_stays():
    pair = [{"species": "molecule", "position": [10, 10 + y], "angle": y} for y in (0, 0.7)]
    box = {"width": 20, "height": 20}
    scenario = parse({"container": box, "molecules": [molecule(BENT)], "particles": pair})
    state = populate(scenario)
    before = state.mass @ state.position
    separate(state, scenario.geometry())
    assert state.mass @ state.position == pytest.approx(before, rel=1e-14)
    assert (state.angle != [0, 0.7]).all()


def test_sticks_that_lie_across_each_other_are_refused_or_parted():
    """Two sticks that cross in the middle have a way out, twenty in a small box have none."""
    cross = [{"species": "molecule", "position": [10, 10], "angle": a} for a in (0, 1.5)]
    box = {"width": 20, "height": 20}
    scenario = parse({"container": box, "molecules": [molecule(rod(5))], "particles": cross})
    state = populate(scenario)
    assert str(worst_overlap(state, scenario.geometry())).startswith("particle 0 and particle 1 overlap by ")
    separate(state, scenario.geometry())
    assert_molecules_in_place(state, scenario.geometry())
    many = [{"species": "molecule", "position": [3, 3], "angle": a} for a in range(20)]
    small = {"width": 6, "height": 6}
    full = parse({"container": small, "molecules": [molecule(rod(5))], "particles": many})
    with pytest.raises(ScenarioError, match=r"overlapping molecules.*larger box"):
        separate(populate(full), full.geometry())


def test_walls_are_named():
    scenario = parse(
        {
            "container": {"width": 20, "height": 20},
            "molecules": [molecule(rod(5))],
            "particles": [{"species": "molecule", "position": [1, 10]}],
        }
    )
    found = worst_overlap(populate(scenario), scenario.geometry())
    assert str(found) == "particle 0 and the left wall overlap by 1.5"
