"""Discs that move along a direction: what a ball does that meets one, and that nobody gets through."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gasbox.errors import UsageError
from gasbox.observe import kinetic_energy
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.state import MoveWall

BOX = {"width": 40, "height": 30}
POST = {"shape": "disc", "name": "post", "center": [20, 15], "radius": 4, "direction": [0, 1]}


def ball(position, velocity, post=POST, speed=1.0, kind="event-driven", **more):
    dynamics = {"kind": kind, **({"time_step": 1e-3} if kind == "stepped" else {})}
    moving = {**post, "motion": {"kind": "constant", "speed": speed}} if speed else post
    return Simulation(
        parse(
            {
                "container": BOX,
                "obstacles": [moving],
                "species": [{"name": "ball", "radius": 1, "mass": 3}],
                "particles": [{"species": "ball", "position": position, "velocity": velocity}],
                "dynamics": dynamics,
                "frame_interval": 0.1,
                **more,
            }
        )
    )


def bounced(position, velocity, u, reach=5.0, center=(20.0, 15.0)):
    """Time of contact, and velocity after it: v' = v - 2 ((v - u) n) n."""
    away, rate = np.subtract(position, center), np.subtract(velocity, u)
    b, c, speed2 = away @ rate, away @ away - reach**2, rate @ rate
    time = c / (math.sqrt(b * b - speed2 * c) - b)
    normal = (away + rate * time) / reach
    return time, np.array(velocity) - 2.0 * ((np.array(velocity) - u) @ normal) * normal


CASES = [
    ([10.0, 15.0], [3.0, 0.0], 1.0),
    ([10.0, 17.0], [3.0, 0.2], 1.0),
    ([12.0, 20.0], [2.0, -1.0], 2.0),
    ([20.5, 25.0], [0.0, -0.3], 1.5),
    ([28.0, 13.0], [-2.5, 0.5], -1.0),
    ([19.0, 6.0], [0.1, 0.5], -1.2),
]


@pytest.mark.parametrize("kind", ["event-driven", "stepped"])
@pytest.mark.parametrize(("position", "velocity", "speed"), CASES)
def test_a_ball_bounces_off_a_post_that_moves(kind, position, velocity, speed):
    """The stepped rule notices it up to a step late: within that the same."""
    u = np.array([0.0, speed])
    time, after = bounced(position, velocity, u)
    simulation = ball(position, velocity, speed=speed, kind=kind)
    before = kinetic_energy(simulation.state)
    simulation.advance(until=math.ceil((time + 0.002) * 1000) / 1000)
    exact = kind == "event-driven"
    assert simulation.state.velocity[0] == pytest.approx(
        after, rel=1e-12 if exact else 4e-3, abs=1e-12 if exact else 4e-3
    )
    work = simulation.dynamics.tallies.wall_work.sum()
    assert kinetic_energy(simulation.state) - before == pytest.approx(work, rel=1e-12)
    assert abs(work) > 0.1


@pytest.mark.parametrize("kind", ["event-driven", "stepped"])
def test_a_cap_on_a_side_sweeps_its_wall_and_loses_nobody(kind):
    """A cap whose middle lies far outside goes to and fro from corner to corner, through a crowd."""
    cap = {"shape": "disc", "name": "cap", "center": [-9, 15], "radius": 12, "direction": [0, 2]}
    simulation = Simulation(
        parse(
            {
                "container": BOX,
                "obstacles": [cap],
                "species": [{"name": "gas", "radius": 0.4, "count": 200, "temperature": 1}],
                "dynamics": {"kind": kind, **({"time_step": 0.005} if kind == "stepped" else {})},
                "frame_interval": 0.5,
                "seed": 4,
            }
        )
    )
    half, before = math.sqrt(12**2 - 9**2), kinetic_energy(simulation.state)
    for turn in range(24):
        simulation.apply(MoveWall("cap", (1 if turn % 2 else -1) * (15 - half), 9.0))
        simulation.advance(frames=3)
        here = simulation.geometry.at(simulation.state.wall_displacement)
        slack = 1e-9 if kind == "event-driven" else 0.4
        assert here.holds(simulation.state.position, simulation.state.radius * (1 - slack)).all()
    assert simulation.state.count == 200
    work = simulation.dynamics.tallies.wall_work.sum()
    assert kinetic_energy(simulation.state) - before == pytest.approx(work, rel=1e-9)
    assert work > 0.0


def test_areas_follow_a_post():
    simulation = ball([10.0, 15.0], [0.0, 0.0], speed=0.0)
    place = simulation.geometry
    away = np.array([0.0] * 4 + [13.0])
    assert place.at(away).area == pytest.approx(40 * 30 - (16 * math.pi - _segment(4.0, 2.0)), rel=1e-5)
    assert place.at(away).holds(np.array([[20.0, 15.0], [20.0, 26.0]]), 1.0).tolist() == [True, False]
    assert place.normal(4) == (0.0, 1.0)


def _segment(radius, height):
    """Area of the part of a disc beyond a line so far from its middle."""
    return radius**2 * math.acos(height / radius) - height * math.sqrt(radius**2 - height**2)


def test_a_post_without_a_direction_stands():
    simulation = ball([10.0, 15.0], [0.0, 0.0], post={**POST, "direction": None}, speed=0.0)
    with pytest.raises(UsageError, match="discs with a direction"):
        simulation.apply(MoveWall("post", 1.0, 1.0))
