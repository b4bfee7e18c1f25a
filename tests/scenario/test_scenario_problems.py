"""A bad scenario is refused with every problem: the path, what was found, what is allowed."""

import json

import pytest

from gasbox.errors import ScenarioError
from gasbox.scenario import Scenario, parse

pytestmark = pytest.mark.small

BOX = {"width": 40, "height": 30}
GAS = {"name": "gas", "count": 3, "temperature": 1}


def problems(data, **changes):
    base = {"container": BOX, "species": [GAS]}
    with pytest.raises(ScenarioError) as caught:
        parse({**base, **changes} if data is None else data)
    return {problem.path: problem for problem in caught.value.problems}


def test_all_problems_of_a_file_at_once():
    found = problems(
        {
            "format": "gasbox-scenario/2",
            "seed": -1,
            "world": {"kind": "chess"},
            "colour": "blue",
            "container": {"width": 10, "height": 10},
            "species": [
                {"name": "a", "radius": -1},
                {"name": "b", "radius": 8, "count": 5, "temperature": 1, "speed": 1},
                {"name": "b", "count": 4},
                {"name": "c", "region": {"x": [5, 20], "y": [4, 3]}},
            ],
            "particles": [{"species": "b", "position": [1, 20]}],
            "dynamics": {"kind": "stepped", "time_step": 0.3},
            "frame_interval": 1,
            "histograms": {"minimum": 2, "maximum": 1},
        }
    )
    assert set(found) == {
        "format",
        "seed",
        "world.kind",
        "colour",
        "species[0].radius",
        "species[1]",
        "species[1].radius",
        "species[2].name",
        "species[2]",
        "species[3].region.x",
        "species[3].region.y",
        "particles[0].position",
        "frame_interval",
        "histograms.maximum",
    }
    assert (
        str(found["species[0].radius"])
        == "species[0].radius: found -1; must be greater than 0 (at least 1e-50)"
    )
    assert found["format"].allowed == 'must be "gasbox-scenario/1"'


@pytest.mark.parametrize("source", ["temperature", "speed", "velocities"])
def test_one_source_of_velocities_is_enough(source):
    value = [[0, 1]] * 3 if source == "velocities" else 1
    parse({"container": BOX, "species": [{"name": "a", "count": 3, source: value}]})


def test_a_counted_species_needs_velocities():
    found = problems(None, species=[{"name": "a", "count": 3}])
    assert found["species[0]"].found == "none of them"
    assert "temperature, speed, velocities" in found["species[0]"].allowed


def test_as_many_velocities_as_discs():
    found = problems(None, species=[{"name": "a", "count": 3, "velocities": [[0, 1]]}])
    assert found["species[0].velocities"].found == "1 velocities"


def test_unknown_keys_name_their_near_relatives():
    found = problems(None, species=[{**GAS, "raduis": 1}])
    assert 'did you mean "radius"?' in found["species[0].raduis"].allowed
    found = problems(None, container={**BOX, "depth": 3})
    assert "width, height" in found["container.depth"].allowed


def test_unknown_species_of_listed_particles():
    found = problems(None, particles={"species": ["gas", "gsa", "gsa"], "position": [[1, 1]] * 3})
    assert found["particles.species[1]"].found == '"gsa" (2 times)'
    assert 'must be one of "gas" (did you mean "gas"?)' in found["particles.species[1]"].allowed


@pytest.mark.parametrize("position", [[-1, 5], [5, 31], [41, 5]])
def test_listed_centres_lie_inside(position):
    found = problems(None, particles=[{"species": "gas", "position": position}])
    assert "[0, 40] x [0, 30]" in found["particles[0].position"].allowed


@pytest.mark.parametrize(
    "particles",
    [
        [1],
        {"species": "gas", "position": [1, 1]},
        [{"species": "gas", "position": [1, 2, 3]}],
        [{"species": "gas", "position": [1, "2"]}],
        [{"species": "gas", "position": [1, True]}],
        [{"species": "gas", "position": [1, float("inf")]}],
        [{"species": "gas", "position": [1, 10**400]}],
        [{"species": 3, "position": [1, 1]}],
        [{"species": ["gas"], "position": [1, 1]}],
        [{"position": [1, 1]}],
        [{"species": "gas"}],
        [{"species": "gas", "position": [1, 1], "mass": 2}],
        {"species": ["gas"], "position": [[1, 1], [2, 2]]},
        {"species": ["gas", "gas"], "position": [1, 1]},
        {"species": ["gas"], "position": [[1, float("nan")]]},
        7,
    ],
)
def test_bad_listed_particles(particles):
    found = problems(None, particles=particles)
    assert all(path.startswith("particles") for path in found)


def test_dynamics_need_a_known_kind():
    assert problems(None, dynamics={"kind": "quick"})["dynamics.kind"].found == '"quick"'
    assert problems(None, dynamics={})["dynamics.kind"].found == "nothing"
    assert "dynamics.time_step" in problems(None, dynamics={"kind": "event-driven", "time_step": 1})
    assert problems(None, dynamics={"kind": "stepped", "time_step": 0})["dynamics.time_step"].found == "0"


@pytest.mark.parametrize(
    ("step", "interval", "good"), [(0.1, 0.3, True), (1, 1, True), (1, 0.5, False), (0.3, 1, False)]
)
def test_a_frame_is_a_whole_number_of_steps(step, interval, good):
    changes = {"dynamics": {"kind": "stepped", "time_step": step}, "frame_interval": interval}
    if good:
        parse({"container": BOX, "species": [GAS], **changes})
    else:
        assert "whole multiple of dynamics.time_step" in problems(None, **changes)["frame_interval"].allowed


@pytest.mark.parametrize("periodic", [[], ["x"], ["y"], ["x", "y"]])
def test_a_diameter_fits_into_the_box(periodic):
    box = {"width": 40, "height": 30, "periodic": periodic}
    parse({"container": box, "species": [{"name": "a", "radius": 15}]})
    found = problems(None, container=box, species=[{"name": "a", "radius": 15.1}])
    assert "at most half the container's height, 15" in found["species[0].radius"].allowed


@pytest.mark.parametrize(
    ("species", "allowed"),
    [
        ([{"name": "a", "count": 268, "temperature": 1}], "at most 0.7 for discs of one size"),
        (
            [
                {"name": "a", "count": 2, "temperature": 1, "radius": 8.8},
                {"name": "b", "count": 50, "temperature": 1},
            ],
            "at most 0.5 for discs of several sizes",
        ),
    ],
)
def test_impossible_densities(species, allowed):
    (found,) = problems(None, species=species).values()
    assert found.found.startswith("an area fraction of ")
    assert allowed in found.allowed


def test_density_counts_listed_discs_and_regions():
    small = {"name": "a", "count": 60, "temperature": 1, "region": {"x": [0, 10], "y": [0, 20]}}
    assert "of the region of 0.9425" in problems(None, species=[small])["species[0].count"].found
    parse({"container": BOX, "species": [{**small, "count": 44}]})
    listed = [{"species": "a", "position": [5, 5]}]
    assert (
        "0.7069"
        in problems(None, species=[{**small, "count": 44}], particles=listed)["species[0].count"].found
    )


@pytest.mark.parametrize("literal", ["NaN", "Infinity", "-Infinity"])
def test_no_literals_beyond_json(literal):
    assert problems(f'{{"seed": {literal}}}')[""].found == literal


@pytest.mark.parametrize("value", [float("nan"), float("inf"), 1e51, 10**400, -1, True, "1", None, [1]])
def test_numbers_out_of_range(value):
    assert "container.width" in problems(None, container={"width": value, "height": 10})


@pytest.mark.parametrize("count", [-1, 0.5, 10_000_001, 10**30, "5", True])
def test_counts_out_of_range(count):
    assert "species[0].count" in problems(None, species=[{**GAS, "count": count}])


def test_whole_numbers_may_be_written_with_a_point():
    assert parse({"container": BOX, "species": [{**GAS, "count": 3.0}]}).species[0].count == 3


def test_too_many_particles_in_all():
    tiny = {"radius": 1e-6, "count": 6_000_000, "temperature": 1}
    found = problems(None, species=[{"name": "a", **tiny}, {"name": "b", **tiny}])
    assert found["species"].found == "12000000 particles in all"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("", "at line 1, column 1"),
        ('{"seed": 1,}', "at line 1"),
        (b"\xff\xfe\x00", "bytes that are no text"),
        ('{"seed": 1, "seed": 2}', 'the key "seed" twice'),
        ("[" * 100_000, "lists in lists"),
        ("1" * 5000, "Exceeds the limit"),
        ("[]", "[]"),
        ("3", "3"),
    ],
)
def test_text_that_is_no_scenario(text, found):
    assert found in problems(text)[""].found


def test_python_gets_the_same_error():
    with pytest.raises(ScenarioError, match=r"container\.width"):
        Scenario(container={"width": -1, "height": 1}, species=[{"name": "a"}])
    with pytest.raises(ScenarioError, match="one JSON object"):
        Scenario.model_validate([])


def test_many_problems_are_counted():
    species = [{"name": f"s{number}", "radius": -1, "mass": -1} for number in range(200)]
    with pytest.raises(ScenarioError) as caught:
        parse({"container": BOX, "species": species})
    assert len(caught.value.problems) == 201
    assert str(caught.value.problems[-1]) == "and 200 more problems"


def test_messages_hold_no_control_characters():
    found = problems(json.dumps({"container": BOX, "species": [{"name": "a", "\x1b[31m\n": 1}]}))
    assert all(str(problem).isprintable() for problem in found.values())
