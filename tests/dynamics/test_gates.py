"""Gates with a rule for each direction, for hard discs, under the stepped rule and under forces."""

import math

import numpy as np
import pytest
from enclosures import BOX, DIVIDER, enclosure, event_driven
from gases import state_of

from gasbox.dynamics import Stepped, altered
from gasbox.geometry import Gate, Passage, Segment
from gasbox.geometry.conserved import is_solid, lets_everybody_pass
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.state import Contacts, SetGate, Tallies, Way

pytestmark = pytest.mark.small

DEMON = Gate(Passage((0,), least_speed=1.0), Passage(greatest_speed=1.0))


def stepped(state, place, contacts=0):
    tallies = Tallies.zero(2, len(place.walls))
    return Stepped(state, place, 0.01, tallies, Contacts.empty(contacts), None, 1, 5)


ENGINES = [event_driven, stepped]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(
    ("gate", "species", "speed", "is_let"),
    [
        (DEMON, 0, 1.5, True),
        (DEMON, 0, 0.7, False),
        (DEMON, 1, 1.5, False),
        (DEMON, 0, -0.7, True),
        (DEMON, 1, -0.7, True),
        (DEMON, 0, -1.5, False),
        (Gate(None, Passage()), 0, 1.5, False),
        (Gate(None, Passage()), 0, -1.5, True),
        (Gate(), 0, -1.5, False),
    ],
)
def test_each_direction_has_its_rule(engine, gate, species, speed, is_let):
    place = enclosure(BOX, (DIVIDER,), o0={"passes": gate})
    normal = DIVIDER.normal[0]
    begin = 8.0 - 2.0 * normal * np.sign(speed)
    state = state_of([[begin, 6.0]], [[normal * speed, 0.0]], [0.5], [1.0], [species])
    dynamics = engine(state, place)
    dynamics.advance(state, 4.0)
    assert bool(state.velocity[0, 0] == normal * speed) is is_let
    assert bool((state.position[0, 0] - 8.0) * (begin - 8.0) < 0.0) is is_let
    assert dynamics.tallies.wall_passed[4].sum() == is_let


@pytest.mark.parametrize(
    ("species", "speed", "is_let"), [("a", 1.5, True), ("a", 0.7, False), ("b", -0.7, True)]
)
def test_each_direction_has_its_rule_under_forces(species, speed, is_let):
    ways = {"forward": {"species": ["a"], "least_speed": 1.0}, "backward": {"greatest_speed": 1.0}}
    begin = 8.0 - math.copysign(2.0, speed)
    data = {
        "container": {"width": 16, "height": 12},
        "obstacles": [{"shape": "segment", "name": "gate", "start": [8, 0], "end": [8, 12], "passes": ways}],
        "species": [{"name": name, "radius": 0.5} for name in "ab"],
        "particles": [{"species": species, "position": [begin, 6.0], "velocity": [speed, 0.0]}],
        "dynamics": {"kind": "forced", "time_step": 0.01},
    }
    simulation = Simulation(parse(data))
    simulation.advance(until=4.0)
    assert bool((simulation.state.position[0, 0] - 8.0) * (begin - 8.0) < 0.0) is is_let
    assert simulation.dynamics.tallies.wall_passed[4].sum() == is_let


@pytest.mark.parametrize("engine", ENGINES)
def test_a_rule_for_both_directions_is_one_rule(engine):
    bits = set()
    for gate in (Passage((1,), "both", 0.4, 2.0), Gate(*2 * (Passage((1,), "forward", 0.4, 2.0),))):
        place = enclosure(BOX, (DIVIDER,), (0.01, -0.02), o0={"passes": gate})
        state = state_of(
            [[3.0, 2.0 + k] for k in range(8)],
            [[1.0, 0.2 * k] for k in range(8)],
            [0.4] * 8,
            [1.0] * 8,
            [0, 1] * 4,
        )
        engine(state, place).advance(state, 20.0)
        bits.add(state.position.tobytes())
    assert len(bits) == 1


def test_a_gate_is_an_obstacle_unless_it_lets_everybody_pass_both_ways():
    everybody = Passage()
    assert lets_everybody_pass(Gate(everybody, everybody))
    assert not lets_everybody_pass(Gate(everybody, None))
    assert not lets_everybody_pass(Gate(everybody, Passage((1,))))
    assert lets_everybody_pass(Gate(everybody, Passage((1,))), 1)
    for gate, solid in [(Gate(everybody, everybody), False), (Gate(None, everybody), True)]:
        place = enclosure(BOX, (DIVIDER,), o0={"passes": gate})
        assert is_solid(place.walls[4]) is solid
        # A line that all pass takes no room.
        assert (place.accessible_area(0.5) < 15.0 * 11.0) is solid


@pytest.mark.parametrize("engine", ENGINES)
def test_a_gate_that_closes_shuts_in_nobody_who_stands_in_it(engine):
    place = enclosure(BOX, (Segment((8.0, 12.0), (8.0, 0.0)),), o0={"passes": Passage()})
    state = state_of([[7.8, 6.0], [2.0, 3.0]], [[1.0, 0.0], [1.0, 0.0]], [0.5, 0.5], [1.0, 1.0], [0, 0])
    dynamics = engine(state, place)
    dynamics.advance(state, 0.5)
    shut = altered(place, 0.5, SetGate("o0", None, Way((1,), 0.0, 3.0)), place)
    assert shut.walls[4].passes == Gate(None, Passage((1,), "both", 0.0, 3.0))
    dynamics.alter(state, shut)
    dynamics.advance(state, 100.0)
    left, right = state.position[1, 0], state.position[0, 0]
    assert 0.0 < left < 8.0
    assert 0.0 < right < 16.0
