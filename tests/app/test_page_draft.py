import dataclasses

import pytest
from free_rotors import DUMBBELL, rotors

from gasbox.app.draft import Draft
from gasbox.errors import ScenarioError
from gasbox.scenario import Scenario, load, parse, shipped
from gasbox.simulation import Simulation

pytestmark = pytest.mark.small


@pytest.mark.parametrize("name", shipped())
def test_a_draft_that_nobody_touched_is_the_scenario_itself(name: str) -> None:
    scenario = load(name)
    assert parse(Draft.of(scenario).to_dict()).hash() == scenario.hash()


def test_edits_reach_the_scenario() -> None:
    draft = Draft.of(load("three-gases"))
    draft.species[1].count = "12"
    draft.species[1].radius = " 0.75 "
    draft.species[2].start, draft.species[2].warmth = "speed", "0.3"
    draft.seed, draft.kind, draft.time_step = "99", "stepped", "0.5"
    draft.container.periodic_y = True
    scenario = parse(draft.to_dict())
    assert scenario.species[1].count == 12
    assert scenario.species[1].radius == 0.75
    assert (scenario.species[2].speed, scenario.species[2].temperature) == (0.3, None)
    assert scenario.seed == 99
    assert scenario.container.periodic == ("y",)
    assert scenario.dynamics.kind == "stepped"
    assert scenario.dynamics.time_step == 0.5


def test_matter_with_forces_keeps_what_the_panel_does_not_show() -> None:
    atom = {
        "name": "atom",
        "radius": 0.5,
        "count": 9,
        "temperature": 0.5,
        "lattice": 1.1,
        "epsilon": 2,
        "sigma": 0.9,
    }
    scenario = parse(
        {
            "format": "gasbox-scenario/1",
            "title": "Matter",
            "container": {"shape": "rectangle", "width": 20, "height": 20, "periodic": ["x", "y"]},
            "species": [atom],
            "dynamics": {"kind": "forced", "time_step": 0.004},
            "forces": {"law": "wca"},
            "thermostat": {"kind": "langevin"},
        }
    )
    draft = Draft.of(scenario)
    assert parse(draft.to_dict()).hash() == scenario.hash()
    assert draft.step == "0.004"
    draft.kind = "stepped"
    assert draft.step == "1"
    other = parse(draft.to_dict())
    assert (other.dynamics.kind, other.forces, other.thermostat) == ("stepped", None, None)
    draft.kind, draft.step = "forced", "0.002"
    draft.kind = "forced"
    assert draft.step == "0.002"
    assert parse(draft.to_dict()).forces == scenario.forces


def test_what_makes_no_sense_is_reported_with_its_path_and_as_typed() -> None:
    draft = Draft.of(load("three-gases"))
    draft.species[0].mass = "heavy"
    draft.species[1].radius = "-1"
    draft.species[2].count = ""
    draft.container.width = "NaN"
    with pytest.raises(ScenarioError) as caught:
        parse(draft.to_dict())
    found = {problem.path: problem.found for problem in caught.value.problems}
    assert "heavy" in found["species[0].mass"]
    assert "-1" in found["species[1].radius"]
    assert "container.width" in found


def test_a_new_species_has_a_name_and_a_colour_of_its_own() -> None:
    draft = Draft.of(load("one-gas"))
    for _ in range(5):
        draft.add_species()
    scenario = parse(draft.to_dict())
    assert len({species.name for species in scenario.species}) == 6
    assert len({species.color for species in scenario.species}) == 6


def test_of_a_snapshot_the_start_is_edited() -> None:
    draft = Draft.of(Simulation(load("one-gas")).snapshot())
    assert "snapshot" not in draft.to_dict()
    assert "particles" not in draft.to_dict()


def test_listed_velocities_are_kept_until_another_start_is_chosen() -> None:
    data = load("one-gas").to_dict()
    species = data["species"][0]
    species.pop("temperature", None)
    species.update(count=2, velocities=[[0.1, 0.0], [-0.1, 0.0]])
    draft = Draft.of(parse(data))
    assert draft.species[0].start == "velocities"
    assert parse(draft.to_dict()).species[0].velocities == ((0.1, 0.0), (-0.1, 0.0))
    chosen = dataclasses.replace(draft.species[0], start="temperature", warmth="0.2").to_dict()
    assert "velocities" not in chosen
    assert chosen["temperature"] == 0.2


def surrounded(**changes: object) -> Scenario:
    return parse(
        {
            "format": "gasbox-scenario/1",
            "container": {"shape": "rectangle", "width": 40, "height": 30},
            "species": [{"name": "a", "radius": 0.5, "count": 20, "temperature": 1}],
            "dynamics": {"kind": "event-driven"},
            **changes,
        }
    )


@pytest.mark.parametrize(
    "container",
    [
        {"shape": "rectangle", "width": 40.0, "height": 30.0, "periodic": ["x"]},
        {"shape": "circle", "radius": 20.0},
        {"shape": "polygon", "vertices": [[0.0, 0.0], [40.0, 0.0], [20.0, 30.0]]},
        {"shape": "regular-polygon", "sides": 5, "radius": 20.0, "rotation": 0.5},
    ],
)
def test_surroundings_are_kept(container: dict[str, object]) -> None:
    scenario = surrounded(
        container=container,
        gravity=[0.0, -0.25],
        obstacles=[{"shape": "segment", "start": [15, 10], "end": [15, 20], "name": "divider"}],
        schedule=[{"at": 3.0, "wall": "divider", "present": False}],
    )
    assert parse(Draft.of(scenario).to_dict()).hash() == scenario.hash()


def test_another_shape_takes_the_size_of_the_box_and_leaves_the_walls_of_the_old_one() -> None:
    scenario = surrounded(walls={"left": {"temperature": 2.0}})
    draft = Draft.of(scenario)
    assert parse(draft.to_dict()).walls["left"].temperature == 2.0
    draft.container.shape = "circle"
    draft.gravity_y = "−0.5"
    changed = parse(draft.to_dict())
    assert (changed.container.shape, changed.container.radius) == ("circle", 15.0)
    assert changed.walls == {}
    assert changed.gravity == (0.0, -0.5)


def test_molecules_can_be_edited_and_everything_else_about_them_is_kept() -> None:
    scenario = rotors(
        {
            "model": "water",
            "name": "steam",
            "scale": 1.5,
            "rotational_temperature": 3,
            "region": {"x": [0, 30]},
        },
        {**DUMBBELL, "temperature": None, "speed": 2, "inertia": 9},
    )
    draft = Draft.of(scenario)
    assert parse(draft.to_dict()).hash() == scenario.hash()
    assert (draft.kinds, draft.species) == (2, [])
    steam, other = draft.molecules
    assert (steam.count, steam.warmth, steam.turning) == ("20", "1", "3")
    assert (other.start, other.warmth, other.turning) == ("speed", "2", "")
    steam.count, steam.turning, other.name = "12", "", "pair"
    other.start, other.warmth = "temperature", "0.5"
    changed = parse(draft.to_dict())
    assert (changed.molecules[0].count, changed.molecules[0].rotational_temperature) == (12, None)
    assert (changed.molecules[0].scale, changed.molecules[0].region) == (1.5, scenario.molecules[0].region)
    assert (changed.molecules[1].name, changed.molecules[1].inertia) == ("pair", 9)
    assert (changed.molecules[1].temperature, changed.molecules[1].speed) == (0.5, None)
    draft.add_species()
    assert parse(draft.to_dict()).species[0].count == 100
