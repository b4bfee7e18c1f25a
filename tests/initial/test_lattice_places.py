"""Discs that start on a triangular lattice."""

import math

import numpy as np
import pytest
from placed_gases import assert_in_place

from gasbox.errors import ScenarioError
from gasbox.initial import populate
from gasbox.scenario import parse

pytestmark = pytest.mark.small

ROW = math.sqrt(3) / 2
SPACING = 1.1132
"""Of the Lennard-Jones lattice at rest, in two dimensions."""
ALL = ["x", "y"]


def scenario(container, *species, kind="forced", **sections):
    usual = {"radius": 0.5, "temperature": 0.3, "lattice": SPACING}
    named = [{"name": str(number), **usual, **entry} for number, entry in enumerate(species)]
    return parse({"container": container, "species": named, "dynamics": {"kind": kind}, **sections})


def distances(state, geometry):
    difference = state.position[:, None] - state.position[None]
    difference -= np.where(geometry.periodic, np.round(difference / geometry.size) * geometry.size, 0)
    distance = np.hypot(difference[..., 0], difference[..., 1])
    np.fill_diagonal(distance, np.inf)
    return distance


def refusal(*arguments, **sections):
    with pytest.raises(ScenarioError) as caught:
        scenario(*arguments, **sections)
    (problem,) = caught.value.problems
    return problem


@pytest.mark.parametrize("rounded", [0, 3])
@pytest.mark.parametrize("turned", [False, True])
def test_a_commensurate_box_is_filled_without_a_seam(rounded, turned):
    sides = (12 * SPACING, 8 * ROW * SPACING)[:: -1 if turned else 1]
    width, height = (round(side, rounded) if rounded else side for side in sides)
    gas = scenario({"width": width, "height": height, "periodic": ALL}, {"count": 96})
    nearest = np.sort(distances(populate(gas), gas.geometry()), axis=1)[:, :7]
    assert nearest[:, :6] == pytest.approx(SPACING, rel=1e-3)
    assert (nearest[:, 6] > 1.7 * SPACING).all()


@pytest.mark.parametrize("periodic", [[], ["x"], ["y"], ALL])
def test_a_crystal_stands_in_the_middle(periodic):
    gas = scenario({"width": 40, "height": 30, "periodic": periodic}, {"count": 200})
    state = populate(gas)
    assert state.position.mean(axis=0) == pytest.approx([20, 15], abs=0.1)
    assert distances(state, gas.geometry()).min() == pytest.approx(SPACING)
    away = np.hypot(*(state.position - [20, 15]).T)
    assert away.max() == pytest.approx(SPACING * math.sqrt(200 * ROW / math.pi), rel=0.05)


@pytest.mark.parametrize("kind", ["event-driven", "stepped", "forced"])
def test_every_rule_of_motion_takes_lattices(kind):
    gas = scenario({"width": 40, "height": 30}, {"count": 200}, kind=kind)
    assert_in_place(populate(gas), gas.geometry())


def test_a_region_holds_its_crystal():
    region = {"x": [0, 10], "y": [5, 12]}
    gas = scenario({"width": 40, "height": 30, "periodic": ["x"]}, {"count": 40, "region": region})
    position = populate(gas).position
    assert (position >= [0.5, 5.5]).all()
    assert (position <= [9.5, 11.5]).all()
    assert position.mean(axis=0) == pytest.approx([5, 8.5], abs=0.2)


@pytest.mark.parametrize(
    "sections",
    [
        {"container": {"shape": "circle", "radius": 12}},
        {"container": {"shape": "regular-polygon", "sides": 6, "radius": 12}},
        {"container": {"width": 24, "height": 24}, "gravity": [0, -1]},
        {
            "container": {"width": 24, "height": 24, "periodic": ["x"]},
            "obstacles": [{"shape": "disc", "center": [0, 12], "radius": 3}],
        },
    ],
)
def test_walls_of_any_shape_are_kept_clear(sections):
    gas = scenario(sections.pop("container"), {"count": 200}, **sections)
    assert_in_place(populate(gas), gas.geometry())


def test_species_with_one_lattice_share_it():
    box = {"width": 12 * SPACING, "height": 8 * ROW * SPACING, "periodic": ALL}
    gas = scenario(box, {"count": 48}, {"count": 48, "radius": 0.4})
    state = populate(gas)
    distance = distances(state, gas.geometry())
    assert distance.min() == pytest.approx(SPACING)
    # Who stands where is drawn: of six neighbours about three are of one's own kind.
    near = distance < 1.1 * SPACING
    assert 2 < near[:48, :48].sum() / 48 < 4
    other = populate(parse({**gas.to_dict(), "seed": 5}))
    assert not np.array_equal(state.position, other.position)


def test_others_are_placed_around_a_crystal():
    box = {"width": 40, "height": 30, "periodic": ALL}
    around = {"count": 100, "lattice": None, "sigma": 1.0}
    gas = scenario(box, {"count": 200}, around)
    state = populate(gas)
    distance = distances(state, gas.geometry())
    assert distance[:200, :200].min() == pytest.approx(SPACING)
    assert distance[200:].min() > 0.9
    assert np.array_equal(state.position[:200], populate(scenario(box, {"count": 200})).position)


def test_a_lattice_keeps_hard_discs_apart():
    said = refusal({"width": 40, "height": 30}, {"count": 9, "lattice": 0.99}, kind="event-driven")
    assert (said.path, said.found) == ("species[0].lattice", "0.99")
    assert "at least a diameter, 1:" in said.allowed
    scenario({"width": 40, "height": 30}, {"count": 9, "lattice": 1.0}, kind="event-driven")
    scenario({"width": 40, "height": 30}, {"count": 9, "lattice": 0.9})


def test_touching_discs_are_not_pressed_into_a_box():
    box = {"width": 11.999, "height": 8 * ROW, "periodic": ALL}
    assert "at most 88 " in refusal(box, {"count": 96, "lattice": 1.0}, kind="event-driven").allowed
    assert populate(scenario(box, {"count": 96, "lattice": 1.0})).count == 96


def test_too_many_are_refused_with_what_would_fit():
    said = refusal({"width": 20, "height": 10}, {"count": 200})
    assert said.found == "200 discs on a lattice of spacing 1.1132"
    most = int(said.allowed.removeprefix("at most ").split()[0])
    assert 150 < most < 180
    state = populate(scenario({"width": 20, "height": 10}, {"count": most}))
    assert state.count == most
    assert "have room" in refusal({"width": 20, "height": 10}, {"count": most + 1}).allowed


def test_a_seam_is_better_than_a_refusal():
    # Rows along y would go round without a seam, but of those only every second one has a place here.
    corridor = {"width": 12 * ROW * SPACING, "height": 1.0, "periodic": ["x"]}
    state = populate(scenario(corridor, {"count": 10}))
    assert (state.position[:, 1] == 0.5).all()


@pytest.mark.parametrize("periodic", [[], ["x"], ["y"], ALL])
@pytest.mark.parametrize("width", [12, 12.6, 13.4])
@pytest.mark.parametrize("rows", [7, 7.5, 9])
def test_neighbours_keep_their_distance_round_the_box(periodic, width, rows):
    box = {"width": width * SPACING, "height": rows * ROW * SPACING, "periodic": periodic}
    most = int(refusal(box, {"count": 1000}).allowed.removeprefix("at most ").split()[0])
    gas = scenario(box, {"count": most})
    assert distances(populate(gas), gas.geometry()).min() > SPACING * (1 - 1.1e-3)


def test_a_fine_lattice_in_a_large_box_takes_no_time():
    box = {"width": 1000, "height": 1000, "periodic": ALL}
    gas = scenario(box, {"count": 400, "lattice": 1e-3, "radius": 1e-4}, kind="event-driven")
    assert np.ptp(populate(gas).position) < 0.1
