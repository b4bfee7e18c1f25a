import dataclasses

import pytest

from gasbox.app.draft import Draft
from gasbox.errors import ScenarioError
from gasbox.scenario import load, parse, shipped
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
    draft.seed, draft.kind, draft.time_step, draft.periodic_y = "99", "stepped", "0.5", True
    scenario = parse(draft.to_dict())
    assert scenario.species[1].count == 12
    assert scenario.species[1].radius == 0.75
    assert (scenario.species[2].speed, scenario.species[2].temperature) == (0.3, None)
    assert scenario.seed == 99
    assert scenario.container.periodic == ("y",)
    assert scenario.dynamics.kind == "stepped"
    assert scenario.dynamics.time_step == 0.5


def test_what_makes_no_sense_is_reported_with_its_path_and_as_typed() -> None:
    draft = Draft.of(load("three-gases"))
    draft.species[0].mass = "heavy"
    draft.species[1].radius = "-1"
    draft.species[2].count = ""
    draft.width = "NaN"
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
