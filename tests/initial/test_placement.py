"""Discs are placed without overlap, in bounded time, and the same ones for the same seed."""

import contextlib
import math
import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from placed_gases import assert_in_place, gas

from gasbox.errors import ScenarioError
from gasbox.initial import populate, worst_overlap
from gasbox.scenario import Forced, load, parse, shipped

PERIODIC = [(), ("x",), ("y",), ("x", "y")]


def is_populated(scenario):
    state = populate(scenario)
    assert_in_place(state, scenario.container.geometry())
    return state


@pytest.mark.parametrize("name", shipped())
def test_shipped_scenarios(name):
    scenario = load(name)
    state = populate(scenario)
    overlap = worst_overlap(state, scenario.geometry())
    # Under forces discs are placed with nine tenths of their width: what presses is moved apart before the start.
    allowed = 0.1 * 2.0 * state.radius.max() if isinstance(scenario.dynamics, Forced) else 0.0
    assert overlap is None or overlap.depth <= allowed
    listed = scenario.particles.count if scenario.particles else 0
    assert state.count == listed + sum(kind.count for kind in scenario.kinds)
    assert state.id.tolist() == list(range(state.count))
    assert state.time == 0.0


@pytest.mark.parametrize("periodic", PERIODIC)
@pytest.mark.parametrize("fraction", [0.05, 0.3, 0.36, 0.5, 0.6, 0.7])
@pytest.mark.parametrize("count", [100, 257, 1000])
def test_one_size_up_to_seven_tenths(count, fraction, periodic):
    is_populated(gas([count], [0.7], fraction, 1.5, periodic))


@pytest.mark.parametrize("periodic", PERIODIC)
@pytest.mark.parametrize(
    ("counts", "radii"),
    [
        ([300, 300], [1, 1.1]),
        ([300, 300], [1, 2]),
        ([600, 100], [1, 5]),
        ([5000, 3], [1, 50]),
        ([200, 200, 200, 200], [1, 1.2, 1.5, 2]),
        ([500, 1], [1, 50]),
    ],
)
def test_mixtures_up_to_one_half(counts, radii, periodic):
    scenario = gas(counts, radii, 0.5 * (1 - 1e-12), 1.2, periodic)
    state = populate(scenario)
    assert worst_overlap(state, scenario.container.geometry()) is None


@settings(max_examples=60, deadline=None, derandomize=True)
@given(
    st.lists(st.tuples(st.integers(1, 40), st.floats(0.2, 10)), min_size=1, max_size=4),
    st.floats(0.01, 0.45),
    st.floats(0.4, 2.5),
    st.sampled_from(PERIODIC),
    st.integers(0, 2**63 - 1),
)
def test_any_gas_is_placed_or_refused(kinds, fraction, aspect, periodic, seed):
    counts, radii = zip(*kinds, strict=True)
    began = time.process_time()
    # Few discs of very different sizes may not fit the shape of the box: then a refusal is what is wanted.
    with contextlib.suppress(ScenarioError):
        is_populated(gas(counts, radii, fraction, aspect, periodic, seed))
    assert time.process_time() - began < 20


def test_the_seed_decides():
    scenario = gas([200, 100], [1, 2], 0.4)
    same, other = populate(scenario), populate(gas([200, 100], [1, 2], 0.4, seed=2))
    assert same.position.tobytes() == populate(scenario).position.tobytes()
    assert same.velocity.tobytes() == populate(scenario).velocity.tobytes()
    assert not (same.position == other.position).any()


def test_velocities_do_not_disturb_positions():
    slow, fast = gas([200], [1], 0.3), gas([200], [1], 0.3, temperature=None, speed=2)
    assert populate(slow).position.tobytes() == populate(fast).position.tobytes()


@pytest.mark.parametrize("fraction", [0.2, 0.5])
def test_places_are_uniform_over_the_box(fraction):
    """Quarters of the box, and halves of them by id, hold what they should."""
    scenario = gas([4000], [1], fraction, periodic=("x", "y"))
    state = populate(scenario)
    share = state.position / scenario.container.geometry().size
    # Discs exclude each other, so counts fluctuate less than the binomial sqrt(n p q); five of these is generous.
    for part in (slice(None), slice(0, 2000)):
        place = share[part]
        expected = place.shape[0] / 4
        quarters = np.histogram2d(place[:, 0], place[:, 1], bins=2, range=[[0, 1], [0, 1]])[0]
        assert np.abs(quarters - expected).max() < 5 * math.sqrt(expected * 0.75)


def test_species_of_one_size_are_mixed_on_a_lattice():
    state = populate(gas([2000, 2000], [1, 1], 0.65))
    upper = state.position[:, 1] > np.median(state.position[:, 1])
    assert abs(int(upper[:2000].sum()) - 1000) < 5 * math.sqrt(2000 * 0.25)


def test_the_lattice_is_shaken():
    """Well below freezing the places of a dense start have no rows left."""
    state = populate(gas([1600], [1], 0.4))
    rows = np.unique(np.round(state.position[:, 1], 6))
    assert rows.size > 1500


def test_regions_hold_their_discs():
    scenario = parse(
        {
            "container": {"width": 60, "height": 30, "periodic": ["x"]},
            "species": [
                {"name": "left", "count": 120, "temperature": 1, "region": {"x": [0, 20]}},
                {
                    "name": "right",
                    "count": 40,
                    "radius": 0.5,
                    "temperature": 1,
                    "region": {"x": [40, 60], "y": [5, 15]},
                },
            ],
        }
    )
    state = is_populated(scenario)
    left, right = state.position[:120], state.position[120:]
    assert (left[:, 0] >= 1).all()
    assert (left[:, 0] <= 19).all()
    assert (right >= [40.5, 5.5]).all()
    assert (right <= [59.5, 14.5]).all()


def test_regions_that_overlap():
    scenario = parse(
        {
            "container": {"width": 60, "height": 30},
            "species": [
                {"name": "everywhere", "count": 100, "temperature": 1},
                {"name": "left", "count": 60, "temperature": 1, "region": {"x": [0, 20]}},
            ],
        }
    )
    assert (is_populated(scenario).position[100:, 0] <= 19).all()


@pytest.mark.parametrize("fraction", [0.3, 0.6])
def test_listed_discs_stay_where_they_are(fraction):
    plain = gas([300], [1], fraction).to_dict()
    listed = [
        {"species": "0", "position": [5, 5]},
        {"species": "1", "position": [9.5, 5], "velocity": [1, 0]},
    ]
    species = [{**plain["species"][0], "count": 280}, {"name": "1", "radius": 3}]
    if fraction > 0.5:
        species[1]["radius"], listed[1]["position"] = 1, [7, 5]
    scenario = parse({**plain, "species": species, "particles": listed})
    state = is_populated(scenario)
    assert state.position[:2].tolist() == [entry["position"] for entry in listed]
    assert state.velocity[:2].tolist() == [[0, 0], [1, 0]]
    assert state.species.tolist() == [0, 1] + [0] * 280


def test_listed_discs_stay_when_others_are_squeezed_in():
    plain = gas([400, 400], [1, 1.1], 0.49).to_dict()
    places = [[x + 5.5, y + 5.5] for x in range(0, 30, 6) for y in range(0, 30, 6)]
    listed = {"species": ["0", "1"] * 12 + ["0"], "position": places}
    species = [{**entry, "count": 388} for entry in plain["species"]]
    state = is_populated(parse({**plain, "species": species, "particles": listed}))
    assert state.position[:25].tolist() == places


@pytest.mark.parametrize("unit", [1e-40, 1e-10, 1e30])
def test_any_unit_of_length(unit):
    plain, scaled = (
        gas([100, 20], [1, 3], 0.4, periodic=("x",)),
        gas([100, 20], [unit, 3 * unit], 0.4, periodic=("x",)),
    )
    assert populate(scaled).position / unit == pytest.approx(populate(plain).position, rel=1e-6)


def test_listed_discs_may_overlap_and_are_wrapped():
    scenario = parse(
        {
            "container": {"width": 10, "height": 10, "periodic": ["x"]},
            "species": [{"name": "a"}],
            "particles": [{"species": "a", "position": [10, 5]}, {"species": "a", "position": [0.5, 5]}],
        }
    )
    assert populate(scenario).position.tolist() == [[0, 5], [0.5, 5]]


def test_a_snapshot_is_taken_as_it_is():
    tallies = {
        "pair_virial": [0],
        "pair_collisions": [[0]],
        "wall_impulse": [[0]] * 4,
        "wall_collisions": [[0]] * 4,
    }
    scenario = parse(
        {
            "container": {"width": 10, "height": 10, "periodic": ["x"]},
            "species": [{"name": "a", "count": 5, "temperature": 1}],
            "particles": [{"species": "a", "position": [10, -0.25]}],
            "snapshot": {"version": "1", "time": 2.5, "memory": {}, "tallies": tallies},
        }
    )
    state = populate(scenario)
    assert state.position.tolist() == [[10, -0.25]]
    assert state.time == 2.5


@pytest.mark.parametrize("count", [2, 3, 5, 7])
def test_what_cannot_fit_is_refused_with_what_would(count):
    with pytest.raises(ScenarioError) as caught:
        populate(gas([count], [1], 0.7))
    (problem,) = caught.value.problems
    assert problem.path == "species[0].count"
    assert problem.found == f"{count} discs at an area fraction of 0.7"
    assert f"rows and columns hold at most {count - 1} " in problem.allowed


def test_exact_fits():
    """One disc that touches all walls, and four in a square."""
    one = {"container": {"width": 3, "height": 2}, "species": [{"name": "a", "count": 1, "temperature": 1}]}
    assert populate(parse(one)).position[0, 1] == 1.0
    corridor = {
        "container": {"width": 9, "height": 2},
        "species": [{"name": "a", "count": 4, "temperature": 1}],
    }
    is_populated(parse(corridor))


def test_no_particles_at_all():
    assert populate(parse({"container": {"width": 3, "height": 2}, "species": [{"name": "a"}]})).count == 0


@pytest.mark.small
def test_without_the_compiler():
    is_populated(gas([6], [1], 0.6))
    is_populated(gas([5, 3], [1, 2], 0.45))
    is_populated(gas([10, 3], [1, 2], 0.2, periodic=("x", "y")))


@pytest.mark.parametrize(
    ("fraction", "radii"), [(0.3, [1]), (0.6, [1]), (0.7, [1]), (0.5, [1, 1.1]), (0.5, [1, 50])]
)
def test_a_hundred_thousand_take_a_second_or_two(fraction, radii):
    populate(gas([100] * len(radii), radii, fraction))
    scenario = gas([100_000 // len(radii)] * len(radii), radii, fraction)
    began = time.process_time()
    state = populate(scenario)
    # A million must be ready within 10 s, and the work is linear.
    assert time.process_time() - began < 2
    assert worst_overlap(state, scenario.container.geometry()) is None
