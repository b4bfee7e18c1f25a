"""Rules on demons: what is refused, and where it says so."""

import pytest

from gasbox.errors import ScenarioError
from gasbox.scenario import Demon, parse

pytestmark = pytest.mark.small

GATE = {"shape": "segment", "name": "gate", "start": [20, 0], "end": [20, 20]}
DATA = {
    "container": {"width": 40, "height": 20},
    "obstacles": [GATE],
    "species": [{"name": "a", "radius": 0.3, "count": 20, "temperature": 1}, {"name": "b", "radius": 0.3}],
    "world": {"kind": "demon", "gate": "gate"},
}
POST = {"shape": "disc", "name": "gate", "center": [20, 10], "radius": 1}
MOVES = {"kind": "sinusoid", "amplitude": 1, "period": 5}


def demon(**more):
    return {**DATA["world"], **more}


@pytest.mark.parametrize(
    ("sections", "place"),
    [
        ({"world": {"kind": "demon"}}, "world.gate"),
        ({"world": demon(gate="gaet")}, "world.gate"),
        ({"world": demon(gate="left")}, "world.gate"),
        ({"obstacles": [POST]}, "world.gate"),
        ({"obstacles": [{**GATE, "open": True}]}, "world.gate"),
        ({"obstacles": [{**GATE, "present": False}]}, "world.gate"),
        ({"obstacles": [{**GATE, "motion": MOVES}]}, "world.gate"),
        ({"world": demon(rule="colour")}, "world.rule"),
        ({"world": demon(threshold=0)}, "world.threshold"),
        ({"world": demon(species="c")}, "world.species"),
        ({"dynamics": {"kind": "stepped", "time_step": 0.1}}, "world.interval"),
        ({"dynamics": {"kind": "forced", "time_step": 0.005}}, "dynamics.kind"),
        ({"schedule": [{"at": 1, "setting": "species", "value": "c"}]}, "schedule[0].value"),
        ({"schedule": [{"at": 1, "setting": "rule", "value": "colour"}]}, "schedule[0].value"),
        ({"schedule": [{"at": 1, "setting": "threshold", "value": -1}]}, "schedule[0].value"),
        ({"schedule": [{"at": 1, "setting": "colour", "value": 1}]}, "schedule[0].setting"),
    ],
)
def test_what_is_refused(sections, place):
    with pytest.raises(ScenarioError) as caught:
        parse({**DATA, **sections})
    assert place in {problem.path for problem in caught.value.problems}


def test_a_misspelt_gate_is_recognised():
    with pytest.raises(ScenarioError, match='"gate"'):
        parse({**DATA, "world": demon(gate="gaet")})


def test_what_is_accepted():
    plan = [
        {"at": 1, "setting": "species", "value": "b"},
        {"at": 2, "setting": "rule", "value": "direction"},
        {"at": 2, "setting": "reversed", "value": True},
    ]
    found = parse({**DATA, "world": demon(species="b", rule="none"), "schedule": plan}).world
    assert found == Demon(gate="gate", species="b", rule="none")
