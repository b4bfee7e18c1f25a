"""The game of pong: goals, serves, bats, players and bricks, and that nothing disturbs it."""

import itertools
import math

import numpy as np
import pytest
from run_bits import bits

from gasbox.errors import UsageError
from gasbox.scenario import ScheduledChange, load, parse
from gasbox.scenario.pong_table import VARIANTS, pong_table
from gasbox.simulation import Simulation
from gasbox.state import SetParticles, SetWorld

IDLE = ("human", "human")


def game(world=None, particles=None, walls=None, **options):
    data = pong_table(**{"players": IDLE, **options})
    data["walls"] = data["walls"] if walls is None else walls
    data["world"] |= world or {}
    if particles is not None:
        data["particles"] = particles
    return Simulation(parse(data))


def ball(simulation):
    row = int(np.flatnonzero(simulation.state.radius == 3.0)[0])
    return simulation.state.position[row], simulation.state.velocity[row]


def tell(simulation, **settings):
    for name, value in settings.items():
        simulation.apply(SetWorld(name, value))


def throw(position, velocity):
    return [{"species": "ball", "position": position, "velocity": velocity}]


def play(simulation, position, velocity):
    """Let the ball fly from there now."""
    world = simulation.world
    tell(simulation, serve=True)
    simulation.advance(frames=1)
    assert world.view()["phase"] == "play"
    change = SetParticles(np.array([world.met.ball]), np.array([position]), np.array([velocity]))
    simulation._guide._follow([change])


def test_idle_bats_let_balls_through_and_keep_the_gas():
    simulation = game(points=3, gas=150)
    scores = []
    while simulation.world.view()["phase"] != "over" and simulation.time < 120:
        simulation.advance(frames=10)
        scores.append(simulation.world.view()["score"])
    view = simulation.world.view()
    assert view["phase"] == "over"
    assert max(view["score"]) == 3
    assert view["winner"] == ("left" if view["score"][0] == 3 else "right")
    assert view["sounds"]["goal"] == sum(view["score"])
    assert all(sum(b) - sum(a) in (0, 1) for a, b in itertools.pairwise(scores))
    gas = simulation.state.radius < 3
    assert gas.sum() == 150
    across = simulation.state.position[gas, 0]
    assert across.min() >= 0.8 * (1 - 1e-9)
    assert across.max() <= 159.2 * (1 + 1e-9)
    simulation.advance(frames=120)
    assert np.hypot(*(ball(simulation)[0] - [80, 50])) < 15
    tell(simulation, restart=True)
    simulation.advance(frames=2)
    assert simulation.world.view()["score"] == [0, 0]
    assert simulation.world.view()["phase"] == "serve"


def test_no_ball_is_too_fast_for_bats_that_close_the_goals():
    """A thousand times the speed of a serve: hundreds of flights in a second, and none gets by."""
    simulation = game(variant="vacuum", bat=50.0)
    play(simulation, [80.0, 50.0], [1e5 * math.cos(0.3), 1e5 * math.sin(0.3)])
    for _ in range(30):
        simulation.advance(frames=1)
        x, y = ball(simulation)[0]
        assert 5 < x < 155
        assert 3 * (1 - 1e-9) <= y <= 97 * (1 + 1e-9)
    view = simulation.world.view()
    assert view["score"] == [0, 0]
    assert view["sounds"]["paddle"] > 200
    assert math.hypot(*ball(simulation)[1]) == pytest.approx(1e5, rel=1e-9)


def test_a_goal_counts_at_any_speed():
    """The ball goes through the line, off the end of the table and back again before the game is asked."""
    simulation = game(variant="vacuum", walls={})
    play(simulation, [80.0, 90.0], [-120 * 127.0, 0.0])
    simulation.advance(frames=1)
    view = simulation.world.view()
    assert (view["score"], view["phase"]) == ([0, 1], "serve")
    assert ball(simulation)[0] == pytest.approx([80, 50])


def test_a_bat_that_moves_gives_its_velocity():
    simulation = game({"keep_speed": False, "least_speed": 0}, variant="vacuum")
    play(simulation, [8.0, 20.0], [-1.0, 0.0])
    tell(simulation, left_push=-1)
    for _ in range(60):
        before = ball(simulation)[1].copy()
        simulation.advance(frames=1)
        if simulation.world.view()["last"] == "left":
            break
    after = ball(simulation)[1]
    normal = (after - before) / np.hypot(*(after - before))
    assert normal[1] < 0 < normal[0]
    assert after == pytest.approx(before - 2 * ((before - [0, -120.0]) @ normal) * normal, rel=1e-9)
    assert simulation.dynamics.tallies.wall_work.sum() > 0


def test_a_bat_is_where_it_was_told_to_be_two_frames_later():
    simulation = game()
    simulation.advance(frames=4)
    wall = simulation.geometry.wall_names.index("bat-left")
    for there in (51.5, 49.0, 50.25, 200.0):
        before = simulation.state.wall_displacement[wall] if simulation.state.wall_displacement.size else 0.0
        tell(simulation, left_target=there)
        simulation.advance(frames=1)
        now = simulation.state.wall_displacement[wall]
        assert now != before
        simulation.advance(frames=1)
        reached = simulation.state.wall_displacement[wall]
        if there < 100:
            assert 50 + reached == pytest.approx(there, abs=1e-9)
    assert 50 + reached <= 50.25 + 2 * 120 / 60 + 1e-9
    simulation.advance(frames=60)
    assert 50 + simulation.state.wall_displacement[wall] == pytest.approx(90.0)


def test_keys_push_a_bat_until_they_are_let_go():
    simulation = game()
    tell(simulation, right_push=1)
    simulation.advance(frames=10)
    tell(simulation, right_push=0)
    simulation.advance(frames=2)
    wall = simulation.geometry.wall_names.index("bat-right")
    place = simulation.state.wall_displacement[wall]
    assert 120 * 9 / 60 <= place <= 120 * 11 / 60
    simulation.advance(frames=5)
    assert simulation.state.wall_displacement[wall] == place


def test_a_serve_waits_and_goes_to_who_lost_the_point():
    simulation = game(variant="vacuum")
    simulation.advance(frames=58)
    assert simulation.world.view()["phase"] == "serve"
    simulation.advance(frames=4)
    assert simulation.world.view()["phase"] == "play"
    assert math.hypot(*ball(simulation)[1]) == pytest.approx(130)
    for side, way in ((150.0, 500.0), (10.0, -500.0)):
        play(simulation, [side, 95.0], [way, 0.0])
        simulation.advance(frames=4)
        tell(simulation, serve=True)
        simulation.advance(frames=1)
        assert ball(simulation)[1][0] * way > 0
    assert simulation.world.view()["score"] == [1, 1]


def test_a_slow_ball_is_driven_on_and_a_lost_one_served_again():
    simulation = game({"patience": 2.0}, gas=60)
    play(simulation, [80.0, 50.0], [0.0, 30.0])
    simulation.advance(frames=1)
    assert math.hypot(*ball(simulation)[1]) >= 77
    simulation.advance(frames=125)
    assert simulation.world.view()["phase"] == "serve"
    assert simulation.world.view()["score"] == [0, 0]


def test_the_computer_plays_the_better_the_higher_its_level():
    points = np.zeros(2)
    for seed in range(4):
        simulation = game(players=("easy", "hard"), seed=seed, points=99)
        simulation.advance(until=70.0)
        points += simulation.world.summary()["score"]
    # If both were as good, each of n points would be anybody's: the difference would have the variance n.
    assert points[1] - points[0] > 3 * points.sum() ** 0.5


def test_bricks_go_when_the_ball_hits_them():
    simulation = game(variant="breakout", points=2)
    bricks = int((simulation.state.mass > 1e6).sum())
    play(simulation, [95.0, 46.0], [400.0, 0.0])
    simulation.advance(frames=10)
    view = simulation.world.view()
    left = int((simulation.state.mass > 1e6).sum())
    assert left == view["bricks"] == bricks - view["score"][0] < bricks
    assert view["sounds"]["brick"] == view["score"][0]
    assert view["players"] == {"left": "human", "right": None}
    for _ in range(2):
        play(simulation, [15.0, 90.0], [-500.0, 0.0])
        simulation.advance(frames=3)
    assert simulation.world.view()["winner"] == "right"


def test_the_last_brick_wins():
    particles = [*throw([80, 50], [0, 0]), {"species": "brick", "position": [100, 50], "velocity": [0, 0]}]
    simulation = game(variant="breakout", particles=particles, gas=5)
    play(simulation, [85.0, 50.0], [100.0, 0.0])
    simulation.advance(frames=20)
    assert simulation.world.view()["winner"] == "left"


@pytest.mark.parametrize("variant", VARIANTS)
def test_looking_changes_nothing_and_a_snapshot_goes_on(variant, tmp_path):
    options = {"variant": variant, "players": ("hard", "easy")}
    whole, pieces = game(**options), game(**options)
    whole.advance(until=6.0)
    for time in np.sort(np.random.default_rng(2).uniform(0, 4.2, 30)):
        pieces.advance(until=time)
    pieces.save(tmp_path / "now.json")
    later = Simulation.restore(tmp_path / "now.json")
    assert bits(later) == bits(pieces)
    later.advance(until=6.0)
    pieces.advance(until=6.0)
    assert bits(later) == bits(pieces) == bits(whole)


def test_a_ball_is_put_where_there_is_room():
    """Under forces, a ball put upon another disc would blow the gas apart."""
    simulation = game(variant="attractive", gas=400, seed=3)
    for place in (151.0, 9.0, 151.0, 9.0):
        play(simulation, [place, 95.0], [20.0 * (place - 80.0), 0.0])
        while simulation.world.view()["phase"] == "play":
            simulation.advance(frames=1)
        at = ball(simulation)[0]
        others = simulation.state.radius < 3
        gaps = np.hypot(*(simulation.state.position[others] - at).T)
        assert gaps.min() > 3.8 * (1 - 1e-9)
        assert np.hypot(*(at - [80, 50])) < 22
    assert np.hypot(*simulation.state.velocity.T).max() < 1500
    assert simulation.world.view()["score"] == [2, 2]


def test_what_players_did_can_be_played_again():
    live = game()
    rng = np.random.default_rng(3)
    for frame in range(240):
        if frame % 3 == 0:
            tell(live, left_target=float(rng.uniform(0, 100)))
        if frame % 40 == 0:
            tell(live, right_push=int(rng.integers(-1, 2)))
        live.advance(frames=1)
    again = game()
    again._plan = [ScheduledChange.of(*entry) for entry in live.changes][::-1]
    again.advance(until=live.time)
    assert bits(live) == bits(again)
    assert live.state.wall_displacement.any()


def test_settings_that_cannot_be():
    simulation = game(variant="breakout")
    for name, value in [("left", "best"), ("right", "easy"), ("right_push", 1), ("up", 1), ("points", 0)]:
        with pytest.raises(UsageError):
            tell(simulation, **{name: value})
    tell(simulation, points=9, ball_speed=50.0, paddle_speed=10.0, left="hard", left_target=3.0)
    assert simulation.world.bats[0].target != 3.0


@pytest.mark.parametrize(
    ("name", "variant"),
    [
        ("pong", "gas"),
        ("pong-attractive", "attractive"),
        ("pong-gravity", "gravity"),
        ("breakout", "breakout"),
    ],
)
def test_shipped_tables_are_those_of_the_page(name, variant):
    assert load(name) == parse(pong_table(variant=variant))
