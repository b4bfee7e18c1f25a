"""Pong in a scenario: what it names must be there, and be what it must be."""

import pytest

from gasbox.errors import ScenarioError
from gasbox.scenario import parse
from gasbox.scenario.pong_table import pong_table

pytestmark = pytest.mark.small


def with_obstacle(number, **changes):
    data = pong_table(gas=5)
    data["obstacles"][number] |= changes
    return data


def with_world(**changes):
    data = pong_table(gas=5)
    return {**data, "world": {**data["world"], **changes}}


@pytest.mark.parametrize(
    ("data", "place"),
    [
        (with_world(ball="bowl"), "world.ball"),
        (with_world(ball="gas"), "world.ball"),
        (with_world(bricks="stone"), "world.bricks"),
        (with_world(bricks="ball"), "world.bricks"),
        (with_world(left="bat"), "world.left"),
        (with_world(left="goal-left"), "world.left"),
        (with_world(goals=["goal-left"]), "world.goals"),
        (with_world(goals=["goal-left", "bat-left"]), "world.goals[1]"),
        (with_world(goals=["goal-left", "line"]), "world.goals[1]"),
        (with_world(players={"left": "me"}), "world.players.left"),
        (with_world(points=0), "world.points"),
        (with_obstacle(0, passes=["gas"]), "world.goals[0]"),
        (with_obstacle(1, direction=[1, 0]), "world.left"),
        (with_obstacle(3, temperature=1.0), "world.right"),
        ({**pong_table(gas=5), "frame_interval": None}, "frame_interval"),
        ({**pong_table(gas=5), "schedule": [{"at": 1, "setting": "left", "value": "best"}]}, "schedule[0].value"),
    ],
)  # fmt: skip
def test_refused(data, place):
    with pytest.raises(ScenarioError) as caught:
        parse({key: value for key, value in data.items() if value is not None})
    assert place in {problem.path for problem in caught.value.problems}


def test_what_a_table_can_be():
    with pytest.raises(ValueError, match="there are gas"):
        pong_table(variant="soup")
    with pytest.raises(ValueError, match="there are small"):
        pong_table(bat="huge")
    assert parse(pong_table(bat=50.0, gas=400, temperature=100.0, variant="gravity"))
