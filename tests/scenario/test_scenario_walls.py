"""Rules on containers, obstacles, walls, motions and schedules: what is refused, and where it says so."""

import json

import pytest

from gasbox.errors import ScenarioError
from gasbox.geometry import Gate, Passage
from gasbox.scenario import parse

pytestmark = pytest.mark.small

BOX = {"width": 40, "height": 20}
GAS = {"name": "a", "count": 20, "temperature": 1}
DIVIDER = {"shape": "segment", "start": [20, 0], "end": [20, 20], "name": "divider"}
PERIODIC = {**BOX, "periodic": ["x"]}
SHELF = {"shape": "segment", "start": [0, 10], "end": [40, 10], "name": "shelf"}
CONSTANT = {"kind": "constant", "speed": 0.1}


def problems(**sections):
    with pytest.raises(ScenarioError) as caught:
        parse({"container": BOX, "species": [GAS], **sections})
    return {problem.path: problem for problem in caught.value.problems}


def polygon(*vertices):
    return {"shape": "polygon", "vertices": [list(corner) for corner in vertices]}


def path(*points):
    return {"left": {"motion": {"kind": "path", "points": [list(point) for point in points]}}}


def moving(**motion):
    return {"left": {"motion": motion}}


@pytest.mark.parametrize(
    ("sections", "place"),
    [
        ({"container": polygon((0, 0), (20, 20), (20, 0), (0, 20))}, "container.vertices"),
        ({"container": polygon((0, 0), (20, 0), (20, 0), (0, 20))}, "container.vertices[2]"),
        ({"container": polygon((-5, 0), (20, 0), (20, 20))}, "container.vertices"),
        ({"obstacles": [{**DIVIDER, "end": [20, 21]}]}, "obstacles[0]"),
        ({"obstacles": [{**DIVIDER, "end": [20, 0]}]}, "obstacles[0].end"),
        ({"obstacles": [polygon((1, 1), (3, 3), (3, 1), (1, 3))]}, "obstacles[0].vertices"),
        ({"walls": {"lefft": {}}}, "walls.lefft"),
        ({"container": {**BOX, "periodic": ["x"]}, "walls": {"left": {}}}, "walls.left"),
        ({"obstacles": [DIVIDER, DIVIDER]}, "obstacles[1].name"),
        ({"obstacles": [{**DIVIDER, "passes": ["b"]}]}, "obstacles[0].passes.species"),
        ({"walls": {"left": {"passes": "all"}}}, "walls.left.passes"),
        ({"obstacles": [{**DIVIDER, "passes": {"forward": {"species": ["b"]}}}]},
         "obstacles[0].passes.forward.species"),
        ({"obstacles": [{**DIVIDER, "passes": {"backward": {"least_speed": 2, "greatest_speed": 1}}}]},
         "obstacles[0].passes.backward.least_speed"),
        ({"obstacles": [{**DIVIDER, "passes": {"backward": {"direction": "forward"}}}]},
         "obstacles[0].passes.backward.direction"),
        ({"obstacles": [{**DIVIDER, "passes": {"forward": {}, "direction": "forward"}}]}, "obstacles[0].passes"),
        ({"obstacles": [{**DIVIDER, "passes": {"forward": None, "backward": None}}]}, "obstacles[0].passes"),
        (
            {"obstacles": [{**DIVIDER, "passes": {"least_speed": 2, "greatest_speed": 1}}]},
            "obstacles[0].passes.least_speed",
        ),
        ({"walls": {"left": {"open": True, "temperature": 1}}}, "walls.left"),
        (
            {"obstacles": [{"shape": "disc", "center": [9, 9], "radius": 1, "motion": CONSTANT}]},
            "obstacles[0].motion",
        ),
        ({"container": {"shape": "circle", "radius": 20}, "walls": {"rim": {"motion": CONSTANT}}}, "walls.rim.motion"),
        ({"walls": path((0, 1), (1, 2))}, "walls.left.motion.points[0]"),
        ({"walls": path((0, 0), (2, 1), (1, 2))}, "walls.left.motion.points[2]"),
        ({"walls": moving(**CONSTANT, start=3, stop=2)}, "walls.left.motion.stop"),
        ({"walls": moving(kind="piston", mass=1, stops=[1, 2])}, "walls.left.motion.stops"),
        ({"walls": moving(**CONSTANT)}, "walls.left.motion"),
        ({"obstacles": [{**DIVIDER, "end": [25, 20], "motion": CONSTANT}]}, "obstacles[0].motion"),
        ({"container": PERIODIC, "gravity": [1, 0]}, "gravity"),
        ({"container": PERIODIC, "schedule": [{"at": 1, "gravity": [1, 0]}]}, "schedule[0].gravity"),
        ({"container": PERIODIC, "obstacles": [{**DIVIDER, "motion": CONSTANT}]},
         "obstacles[0].motion"),
        ({"container": PERIODIC, "obstacles": [{**SHELF, "start": [5, 10], "motion": CONSTANT}]},
         "obstacles[0].motion"),
        ({"container": PERIODIC, "obstacles": [{**SHELF, "start": [5, 10]}],
          "schedule": [{"at": 1, "wall": "shelf", "displacement": 2}]}, "obstacles[0]"),
        ({"schedule": [{"at": 1}]}, "schedule[0]"),
        ({"schedule": [{"at": 1, "wall": "dvider", "present": False}], "obstacles": [DIVIDER]}, "schedule[0].wall"),
        ({"schedule": [{"at": 1, "wall": "left", "present": False}]}, "schedule[0].present"),
        ({"schedule": [{"at": 1, "wall": "left", "displacement": 39, "speed": 1}]}, "schedule[0]"),
        ({"species": [{**GAS, "radius": 6}], "obstacles": [{**DIVIDER, "end": [20, 20]},
          {**DIVIDER, "name": "b", "start": [10, 0], "end": [10, 20]},
          {**DIVIDER, "name": "c", "start": [30, 0], "end": [30, 20]}]}, "species[0].radius"),
        ({"particles": [{"species": "a", "position": [9, 9]}],
          "obstacles": [{"shape": "disc", "center": [9, 9], "radius": 1}]}, "particles[0].position"),
    ],
)  # fmt: skip
def test_what_is_refused(sections, place):
    assert place in problems(**sections)


def test_a_side_that_is_misspelt_is_recognised():
    assert '"left"' in problems(walls={"lefft": {}})["walls.lefft"].allowed


def test_crowding_says_when():
    # 20 discs of radius 1 fill 0.9 of 20 x 3.49: the left wall has come so far at time 365.
    found = problems(walls=moving(**CONSTANT))["walls.left.motion"].found
    assert "at time 365.09" in found


@pytest.mark.parametrize(
    "sections",
    [
        {"walls": moving(**CONSTANT, stop=100)},
        {"walls": moving(kind="piston", mass=50, pressure=0.3)},
        {"obstacles": [{**DIVIDER, "motion": {"kind": "sinusoid", "amplitude": 3, "period": 9}}]},
        {"obstacles": [{**DIVIDER, "passes": ["a"]}], "gravity": [0, -0.1]},
        {"schedule": [{"at": 1, "wall": "divider", "present": False}], "obstacles": [DIVIDER]},
        {
            "container": PERIODIC,
            "gravity": [0, -1],
            "obstacles": [{**SHELF, "motion": {**CONSTANT, "stop": 3}}],
        },
        {"container": {"shape": "circle", "radius": 20}, "dynamics": {"kind": "stepped"}},
    ],
)
def test_what_is_accepted(sections):
    scenario = parse({"container": BOX, "species": [GAS], **sections})
    assert parse(scenario.to_dict()) == scenario


def test_a_gate_may_have_a_rule_for_each_direction():
    gate = {
        **DIVIDER,
        "passes": {"forward": {"least_speed": 1.5}, "backward": {"species": ["a"], "greatest_speed": 1.5}},
    }
    scenario = parse({"container": BOX, "species": [GAS], "obstacles": [gate]})
    expected = Gate(Passage(least_speed=1.5), Passage((0,), greatest_speed=1.5))
    assert scenario.geometry().walls[4].passes == expected
    assert parse(json.loads(scenario.to_json())).geometry() == scenario.geometry()
    gate["passes"] = {"backward": {}}
    one_way = parse({"container": BOX, "species": [GAS], "obstacles": [gate]})
    assert one_way.geometry().walls[4].passes == Gate(None, Passage())
