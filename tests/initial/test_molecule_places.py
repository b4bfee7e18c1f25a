"""Molecules are placed without overlap, turned every way, or refused with the reason."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from molecule_gases import BENT, DUMBBELL, assert_molecules_in_place, deepest, gas, molecule, rod

from gasbox.errors import ScenarioError
from gasbox.initial import populate
from gasbox.scenario import parse

OTHER = {"name": "disc", "radius": 0.7, "count": 30, "temperature": 1}


@settings(max_examples=25, deadline=None, derandomize=True)
@given(
    st.sampled_from([DUMBBELL, BENT, rod(4), rod(10)]),
    st.sampled_from([(), ("x",), ("y",), ("x", "y")]),
    st.floats(0.05, 0.5),
    st.sampled_from([1.0, 3.0]),
    st.integers(0, 2**40),
)
def test_no_two_overlap(shape, periodic, fraction, aspect, seed):
    scenario = gas(shape, 80, fraction, periodic, aspect, seed)
    state = populate(scenario)
    assert state.count == 80
    assert_molecules_in_place(state, scenario.geometry())


def test_many_are_turned_every_way():
    """Mean cosines of the angle and of its double vanish, each with the variance 1/2N; bodies lie everywhere."""
    scenario = gas(DUMBBELL, 10_000, 0.3)
    state = populate(scenario)
    for times in (1, 2, 4):
        mean = np.exp(1j * times * state.angle).mean()
        assert abs(mean) < 4 / np.sqrt(state.count)
    quarters = np.histogram2d(*(state.position / scenario.geometry().size).T, bins=4)[0]
    # Fewer than of independent places, because bodies keep off each other.
    assert np.abs(quarters - 625).max() < 4 * np.sqrt(625)


def test_rods_at_a_quarter_of_the_area():
    scenario = gas(rod(10), 500, 0.25)
    state = populate(scenario)
    assert_molecules_in_place(state, scenario.geometry())
    assert abs(np.exp(2j * state.angle).mean()) < 0.25


def test_beside_discs_and_beside_those_that_are_listed():
    listed = [
        {"species": "molecule", "position": [10, 10], "angle": 0.7, "angular_velocity": -2},
        {"species": "disc", "position": [5, 5]},
    ]
    scenario = gas(BENT, 60, 0.2, species=[OTHER], particles=listed)
    state = populate(scenario)
    assert (state.angle[0], state.angular_velocity[0]) == (0.7, -2)
    assert (state.angle[state.species == 0] == 0).all()
    assert_molecules_in_place(state, scenario.geometry())


@pytest.mark.parametrize(
    "surroundings",
    [
        {"container": {"shape": "circle", "radius": 12}},
        {
            "container": {
                "shape": "polygon",
                "vertices": [[0, 0], [30, 0], [30, 10], [12, 12], [10, 28], [0, 28]],
            }
        },
        {
            "container": {"width": 24, "height": 20, "periodic": ["y"]},
            "obstacles": [
                {"shape": "segment", "start": [8, 0], "end": [8, 20]},
                {"shape": "disc", "center": [16, 0.5], "radius": 2},
                {"shape": "polygon", "vertices": [[12, 8], [18, 8], [15, 13]]},
            ],
        },
    ],
)
def test_between_walls_of_any_shape(surroundings):
    scenario = parse({**surroundings, "species": [OTHER], "molecules": [molecule(BENT, 40)]})
    state = populate(scenario)
    assert_molecules_in_place(state, scenario.geometry())


def test_nobody_stands_astride_a_wall():
    """Two atoms far apart, between which a divider would find room."""
    shape = {"atoms": [{"position": [0, 0], "radius": 0.2}, {"position": [3, 0], "radius": 0.2}]}
    wall = {"shape": "segment", "start": [6, 0], "end": [6, 12]}
    scenario = parse(
        {"container": {"width": 12, "height": 12}, "obstacles": [wall], "molecules": [molecule(shape, 40)]}
    )
    sites = populate(scenario).sites
    left = sites.position[:, 0] < 6
    assert (left[::2] == left[1::2]).all()
    assert left[::2].any()
    assert not left[::2].all()


def test_regions_hold_whole_molecules():
    region = {"x": [5, 20], "y": [10, 14]}
    scenario = parse(
        {"container": {"width": 60, "height": 40}, "molecules": [molecule(rod(6), 4, region=region)]}
    )
    state = populate(scenario)
    reach = np.repeat(state.sites.radius[:, None], 2, axis=1)
    assert (state.sites.position - reach >= [5, 10]).all()
    assert (state.sites.position + reach <= [20, 14]).all()


def test_rods_in_a_channel_lie_along_it():
    scenario = gas(rod(8), 12, 0.45, (), aspect=80)
    assert scenario.container.height < scenario.kinds[0].radius
    state = populate(scenario)
    assert_molecules_in_place(state, scenario.geometry())
    assert np.abs(np.sin(state.angle)).max() < 0.3


def test_an_atom_alone_is_placed_as_a_disc_is():
    disc = {"name": "one", "radius": 0.5, "count": 50, "temperature": 1}
    box = {"width": 20, "height": 20}
    atom = molecule({"atoms": [{"position": [3, 4], "radius": 0.5}]}, 50)
    one = populate(parse({"container": box, "species": [disc]}))
    other = populate(parse({"container": box, "molecules": [atom]}))
    assert (one.position == other.position).all()
    assert (one.velocity == other.velocity).all()
    assert (other.sites.position == other.position).all()


def test_under_forces_sites_keep_most_of_sigma_apart():
    forced = {"dynamics": {"kind": "forced", "time_step": 0.001}}
    scenario = gas(DUMBBELL, 400, 0.5, **forced)
    state = populate(scenario)
    # Radii are 0.45 sigma, and sigma the diameter.
    assert deepest(state, scenario.geometry()) <= 0.1 + 1e-9


def test_a_box_that_is_too_full_is_refused_with_numbers():
    with pytest.raises(ScenarioError) as caught:
        gas(DUMBBELL, 100, 0.51)
    (problem,) = caught.value.problems
    assert str(problem) == (
        "molecules[0].count: found an area fraction of 0.51; "
        "at most 0.5 for molecules; use fewer or smaller molecules or a larger box"
    )


def test_what_finds_no_place_is_refused_with_numbers():
    """Rings that leave most of their bounds empty, and so find no room long before the area is used up."""
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    ring = {"atoms": [{"position": [3 * np.cos(a), 3 * np.sin(a)], "radius": 0.3} for a in angle.tolist()]}
    with pytest.raises(ScenarioError) as caught:
        populate(gas(ring, 12, 0.45, ()))
    (problem,) = caught.value.problems
    assert problem.path == "molecules[0].count"
    assert problem.found.startswith("12 particles at an area fraction of 0.45")
    assert "rows of them, all turned one way, hold at most " in problem.allowed


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.lists(st.tuples(st.floats(-2, 2), st.floats(-2, 2), st.floats(0.1, 1.5)), min_size=1, max_size=7))
@pytest.mark.small
def test_the_area_is_that_of_the_union(discs):
    atoms = [{"position": [x, y], "radius": r} for x, y, r in discs]
    kind = parse({"container": {"width": 99, "height": 99}, "molecules": [molecule({"atoms": atoms})]}).kinds[
        0
    ]
    shapes = [shapely.Point(x, y).buffer(r, quad_segs=512) for x, y, r in discs]
    assert kind.area == pytest.approx(shapely.union_all(shapes).area, rel=1e-5)
    assert kind.half_width == pytest.approx(
        shapely.union_all(shapes).convex_hull.length / (2 * np.pi), rel=1e-4
    )
