"""What people do in an epidemic, and what is refused."""

import json

import numpy as np
import pytest
from epidemic_towns import discs, town, world

from gasbox.errors import ScenarioError, UsageError
from gasbox.scenario import STAGES, load, parse, places_of, shipped
from gasbox.scenario.epidemic import Epidemic
from gasbox.scenario.epidemic_settings import SETTINGS
from gasbox.simulation import Simulation
from gasbox.state import SetWorld

CALM = {
    "distancing": {},
    "quarantine": {},
    "travel": {},
    "central": {},
    "vaccination": {},
    "symptomatic": 1.0,
    "fatality": 0.0,
}


def inside(position, box):
    return ((position >= box[:2] - 1e-9) & (position <= box[2:] + 1e-9)).all(axis=1)


def advanced(scenario, until):
    simulation = Simulation(scenario)
    simulation.advance(until=until)
    return simulation


def test_a_closed_border_keeps_the_other_town_healthy():
    species = town().to_dict()["species"]
    for entry in species:
        if entry["name"] == "infectious":
            entry["region"] = {"x": [0, 9.5]}
    closed = parse({**town().to_dict(), "species": species, "world": world(**CALM)})
    open_one = closed.to_dict()["world"] | {"travel": {"rate": 0.3}}
    sizes = []
    for scenario in (closed, parse({**closed.to_dict(), "world": open_one})):
        simulation = advanced(scenario, 30.0)
        people, right = simulation.world._people, places_of(scenario).rooms[1]
        home = inside(Simulation(scenario).state.position, right)
        sizes.append(int((people.infected_at[home] >= 0).sum()))
    assert sizes[0] == 0
    assert sizes[1] > 20


def test_travellers_arrive_and_live_where_they_arrive():
    simulation = advanced(town(world=world(**CALM | {"travel": {"rate": 1.0}})), 5.0)
    people, rooms = simulation.world._people, places_of(simulation.scenario).rooms
    moved = people.room != advanced(simulation.scenario, 0.0).world._people.room
    assert moved.sum() > 20
    settled = people.zone >= 0
    for number, room in enumerate(rooms):
        here = settled & (people.room == number)
        assert inside(simulation.state.position[here], room).mean() > 0.97
        # One on the way is at most a step behind the time at which it should have come.


def test_the_found_are_kept_apart_until_it_is_over():
    always = {"probability": 1.0, "delay": 0.25, "box": {"x": [20.5, 23], "y": [4, 8]}}
    simulation = advanced(town(world=world(**CALM | {"quarantine": always})), 3.0)
    people, state = simulation.world._people, simulation.state
    kept = people.errand == 3
    box = places_of(simulation.scenario).quarantine
    long_ago = kept & (people.free_until < state.time - 1.5)
    assert long_ago.sum() > 0
    assert inside(state.position[long_ago], box).all()
    assert (people.stage[kept] == 2).all()
    # Who is found infects nobody any more.
    before = people.passed_on[kept].copy()
    simulation.advance(until=3.5)
    assert np.array_equal(people.passed_on[kept], before)
    simulation.advance(until=40.0)
    assert simulation.world.summary()["over"]
    assert not inside(state.position, box).any()


def test_without_a_box_the_found_stand_still():
    simulation = advanced(town(world=world(**CALM | {"quarantine": {"probability": 1.0, "delay": 0.2}})), 2.0)
    kept = simulation.world._people.errand == 3
    before = simulation.state.position[kept].copy()
    assert kept.any()
    simulation.advance(until=2.2)
    still = (simulation.world._people.errand == 3)[kept]
    assert np.array_equal(simulation.state.position[kept][still], before[still])


def test_visitors_stand_in_the_middle():
    simulation = advanced(town(world=world(**CALM | {"central": {"visits": 1.0, "stay": 1.0}})), 3.0)
    people, state = simulation.world._people, simulation.state
    places = places_of(simulation.scenario)
    arrived = (people.errand == 2) & (people.errand_until < state.time + 0.9)
    assert arrived.sum() > 10
    for number in range(2):
        here = arrived & (people.room == number)
        assert inside(state.position[here], places.central[number]).all()


def test_triggers_wait_for_cases():
    simulation = advanced(town(), 0.5)
    assert simulation.world.view()["active"] == {"distancing": False, "quarantine": True, "travel": False}
    simulation.advance(until=8.0)
    assert simulation.world.view()["active"]["distancing"]
    simulation.apply(SetWorld("distancing_trigger", 1e5))
    simulation.advance(until=8.1)
    assert not simulation.world.view()["active"]["distancing"]
    assert not simulation.dynamics.memory()["walk_distancing"].any()


def test_view_is_small_json():
    simulation = advanced(town(people=3000, ill=1500, container={"width": 235, "height": 120}), 0.4)
    view = simulation.world.view()
    assert len(json.dumps(view)) < 15_000
    assert len(view["rings"]) <= 300
    assert set(view["counts"]) == set(STAGES)
    assert view["settings"].keys() == SETTINGS.keys() - {"probability"}
    contact = advanced(discs(), 1.0).world.view()
    assert contact["radius"] is None
    assert "radius" not in contact["settings"]
    assert "distancing" not in contact["settings"]


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("hygiene", 2.0, "from 0 to 1"),
        ("hygien", 1.0, "no setting"),
        ("probability", 0.5, 'transmission by "contact"'),
        ("exposed_days", True, "number"),
    ],
)
def test_settings_that_are_refused(name, value, said):
    simulation = Simulation(town())
    with pytest.raises(UsageError, match=said):
        simulation.apply(SetWorld(name, value))
    assert simulation.changes == []


def test_settings_that_need_a_species():
    simulation = Simulation(discs())
    for name in ("vaccination_per_day", "distancing", "radius", "exposed_days", "fatality"):
        with pytest.raises(UsageError, match="needs"):
            simulation.apply(SetWorld(name, 0.5))
    with pytest.raises(UsageError, match="no gravity"):
        Simulation(town()).dynamics.alter(None, None)


def problems(**more):
    with pytest.raises(ScenarioError) as caught:
        parse({**town().to_dict(), **more})
    return {problem.path for problem in caught.value.problems}


def test_scenarios_that_are_refused():
    few = [entry for entry in town().to_dict()["species"] if entry["name"] not in ("dead", "recovered")]
    assert problems(species=few) == {"species"}
    assert problems(species=[*town().to_dict()["species"], {"name": "immune"}]) == {"species[7].name"}
    assert problems(obstacles=[{"shape": "disc", "center": [3, 3], "radius": 1}]) >= {"obstacles"}
    assert problems(gravity=[0, -1]) == {"gravity"}
    assert problems(container={"width": 23.5, "height": 12, "periodic": ["x"]}) == {"dynamics.rooms"}
    assert problems(schedule=[{"at": 1, "setting": "probability", "value": 0.1}]) == {"schedule[0].setting"}
    assert problems(world=world(transmission={"by": "contact"})) == {"world.transmission.by"}
    assert problems(world=world(interval=0.07)) == {"world.interval"}
    box = {"quarantine": {"box": {"x": [18, 23], "y": [4, 8]}}}
    assert problems(world=world(**box)) == {"world.quarantine.box"}
    assert problems(dynamics={"kind": "stepped"}) >= {"world.distancing", "world.travel"}
    assert problems(world=world(infectious={"law": "normal"})) == {"world.infectious.law"}


def test_every_setting_has_its_value():
    both = {**Epidemic().values(), **discs().world.values()}
    assert both.keys() == SETTINGS.keys()
    for name, value in both.items():
        assert SETTINGS[name].check(value) == value


@pytest.mark.parametrize("name", [name for name in shipped() if name.startswith("epidemic")])
def test_shipped_epidemics_spread(name):
    scenario = load(name)
    summary = advanced(scenario, (6 if name.endswith("contact") else 25) * scenario.world.day).world.summary()
    assert summary["total"] == summary["people"]
    assert summary["final_size"] > 15
