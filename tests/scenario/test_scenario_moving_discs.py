"""Discs with a direction in a scenario: what is refused, and where it says so."""

import pytest

from gasbox.errors import ScenarioError
from gasbox.scenario import parse

pytestmark = pytest.mark.small

BOX = {"width": 40, "height": 20}
GAS = {"name": "a", "radius": 0.2, "count": 5, "temperature": 1}
POST = {"shape": "disc", "name": "post", "center": [20, 10], "radius": 3, "direction": [0, 2]}
CONSTANT = {"kind": "constant", "speed": 0.1, "stop": 1}


def made(post=POST, **sections):
    return parse({"container": BOX, "species": [GAS], "obstacles": [post], **sections})


@pytest.mark.parametrize(
    ("post", "sections", "place"),
    [
        ({"direction": [0, 0]}, {}, "obstacles[0].direction"),
        ({"direction": None, "motion": CONSTANT}, {}, "obstacles[0].motion"),
        ({"motion": {"kind": "piston", "mass": 1}}, {}, "obstacles[0].motion"),
        ({}, {"container": {**BOX, "periodic": ["x"]}}, "obstacles[0].direction"),
        ({"center": [-3, 10]}, {}, "obstacles[0]"),
        ({"center": [-1, 10], "direction": None}, {}, "obstacles[0]"),
        ({"direction": None}, {"schedule": [{"at": 1, "wall": "post", "displacement": 1, "speed": 1}]},
         "schedule[0].displacement"),
    ],
)  # fmt: skip
def test_refused(post, sections, place):
    with pytest.raises(ScenarioError) as caught:
        made({key: value for key, value in {**POST, **post}.items() if value is not None}, **sections)
    assert place in {problem.path for problem in caught.value.problems}


def test_a_direction_is_made_a_unit_vector_and_a_cap_may_stick_out():
    scenario = made({**POST, "center": [-2, 10], "motion": CONSTANT})
    assert scenario.geometry().obstacles[0].direction == (0.0, 1.0)
    assert parse(scenario.to_dict()) == scenario
    assert made(schedule=[{"at": 1, "wall": "post", "displacement": 1, "speed": 1}]).schedule
