"""People who walk: how far they come, where they turn round, how they keep apart."""

import numpy as np
import pytest

from gasbox.protocols import Dynamics, Led
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.state import RemoveParticles, SetWalkers
from gasbox.theory.epidemic import share_within


def crowd(people=2000, width=1e4, periodic=(), seed=1, **dynamics):
    return parse(
        {
            "container": {"width": width, "height": width, "periodic": list(periodic)},
            "species": [{"name": "people", "radius": 0.001, "count": people}],
            "dynamics": {"kind": "walk", "time_step": 0.05, "speed": 2.0, "turning": 0.7, **dynamics},
            "seed": seed,
        }
    )


def test_is_a_dynamics_that_is_led():
    dynamics = Simulation(crowd(3)).dynamics
    assert isinstance(dynamics, Dynamics)
    assert isinstance(dynamics, Led)


def test_direction_is_forgotten_and_distance_grows():
    """<cos> = exp(-D t); <r^2> is that of n straight steps of length a, each turned by a mean cosine c from the last.

    It is a^2 (n (1 + c)/(1 - c) - 2 c (1 - c^n)/(1 - c)^2): for short steps 2 (v/D)^2 (D t - 1 + exp(-D t)), as of any
    persistent walk.
    """
    simulation = Simulation(crowd())
    start, heading = simulation.state.position.copy(), simulation.state.velocity.copy()
    for t in (0.5, 2.0, 6.0):
        simulation.advance(until=t)
        cosine = (simulation.state.velocity * heading).sum(axis=1) / 4.0
        assert cosine.mean() == pytest.approx(np.exp(-0.7 * t), abs=4 * cosine.std() / 2000**0.5)
        square = ((simulation.state.position - start) ** 2).sum(axis=1)
        n, c = round(t / 0.05), np.exp(-0.7 * 0.05)
        expected = 0.1**2 * (n * (1 + c) / (1 - c) - 2 * c * (1 - c**n) / (1 - c) ** 2)
        assert square.mean() == pytest.approx(expected, abs=4 * square.std() / 2000**0.5)
    assert np.allclose(np.hypot(*simulation.state.velocity.T), 2.0)


@pytest.mark.parametrize("periodic", [(), ("x", "y")])
def test_a_crowd_stays_evenly_spread(periodic):
    simulation = Simulation(crowd(4000, 10.0, periodic))
    simulation.advance(until=20.0)
    position = simulation.state.position
    assert ((position >= 0) & (position <= 10)).all()
    counts = np.histogram2d(*position.T, bins=5, range=[[0, 10], [0, 10]])[0]
    # Chi squared of 24 degrees of freedom: 51 is exceeded once in a thousand.
    assert ((counts - 160) ** 2 / 160).sum() < 51


def test_rooms_are_not_left():
    rooms = {"columns": 3, "rows": 2, "gap": 0.5, "region": {"y": [1, 9]}}
    simulation = Simulation(crowd(300, 10.0, rooms=rooms))
    place = simulation.dynamics.memory()["walk_place"]
    boxes = simulation.dynamics.settings.places[place]
    for _ in range(20):
        simulation.advance(until=simulation.time + 0.5)
        position = simulation.state.position
        assert ((position >= boxes[:, :2]) & (position <= boxes[:, 2:])).all()
    assert np.bincount(place, minlength=6).min() > 20


def neighbours(simulation, distance):
    apart = simulation.state.position[:, None] - simulation.state.position[None]
    return ((apart**2).sum(axis=2) < distance**2).sum() - simulation.state.count


def keep_apart(simulation, strength):
    ids = simulation.state.id
    simulation.dynamics.lead(simulation.state, SetWalkers(ids, distancing=np.full(ids.size, strength)))


def test_who_keeps_a_distance_has_fewer_nearby():
    found = np.zeros((2, 8))
    for seed in range(8):
        for row, strength in enumerate((0.0, 4.0)):
            simulation = Simulation(crowd(100, 10.0, seed=seed, reach=1.2, speed=1.0))
            keep_apart(simulation, strength)
            for _ in range(20):
                simulation.advance(until=simulation.time + 1.0)
                found[row, seed] += neighbours(simulation, 0.7) / 20
    free, apart = found.mean(axis=1)
    errors = found.std(axis=1, ddof=1) / 8**0.5
    assert free == pytest.approx(100 * 99 * share_within(0.7, 10.0, 10.0), abs=4 * errors[0])
    assert free - apart > 4 * np.hypot(*errors)


def test_two_alone_never_come_nearer_than_where_the_push_is_their_speed():
    """Each is pushed by strength v (1 - d/reach): that is v at d = reach (1 - 1/strength), here 0.9."""
    simulation = Simulation(crowd(2, 4.0, ("x", "y"), reach=1.2, speed=1.0))
    simulation.state.position[:] = [[1.0, 2.0], [3.0, 2.0]]
    simulation.dynamics.resync(simulation.state)
    keep_apart(simulation, 4.0)
    gaps = []
    for _ in range(2000):
        simulation.advance(until=simulation.time + 0.05)
        way = np.subtract(*simulation.state.position)
        gaps.append(np.hypot(*(way - 4.0 * np.round(way / 4.0))))
    assert 0.9 * (1 - 1e-9) < min(gaps) < 1.2


def test_walkers_go_where_they_are_sent():
    simulation = Simulation(crowd(10, 10.0))
    state, dynamics = simulation.state, simulation.dynamics
    ids, target = np.array([2, 5]), np.array([[1.0, 1.0], [9.0, 2.0]])
    far = np.hypot(*(target - state.position[ids]).T)
    dynamics.lead(state, SetWalkers(ids, target=target, pace=np.array([1.0, 0.5])))
    simulation.advance(until=float(far[0] / 6.0) + 0.1)
    assert dynamics.memory()["walk_going"][2] == 0
    simulation.advance(until=float(far[1] / 3.0) + 0.1)
    assert not dynamics.memory()["walk_going"].any()
    dynamics.lead(state, SetWalkers(ids, pace=np.zeros(2)))
    before = state.position[ids].copy()
    simulation.advance(until=simulation.time + 3.0)
    assert np.array_equal(state.position[ids], before)


def test_a_walker_draws_the_same_whoever_has_left():
    whole, fewer = Simulation(crowd(50)), Simulation(crowd(50))
    for each in (whole, fewer):
        each.advance(until=1.0)
    fewer.state.keep(~np.isin(fewer.state.id, RemoveParticles(np.arange(0, 50, 3)).ids))
    fewer.dynamics.resync(fewer.state)
    for each in (whole, fewer):
        each.advance(until=3.0)
    assert np.array_equal(whole.state.position[fewer.state.id], fewer.state.position)


def test_pushes_are_those_of_a_plain_loop():
    simulation = Simulation(crowd(60, 10.0, ("x",), reach=2.0, turning=0.0, time_step=0.01))
    state, dynamics = simulation.state, simulation.dynamics
    dynamics.lead(state, SetWalkers(state.id, distancing=np.full(60, 0.1)))
    before, heading = state.position.copy(), state.velocity.copy()
    simulation.advance(until=0.01)
    way = before[:, None] - before[None]
    way[..., 0] -= 10.0 * np.round(way[..., 0] / 10.0)
    far = np.sqrt((way**2).sum(axis=2))
    share = np.where((far > 0) & (far < 2.0), 1 / np.maximum(far, 1e-12) - 1 / 2.0, 0.0)
    velocity = heading + 0.1 * 2.0 * (share[..., None] * way).sum(axis=1)
    fast = np.hypot(*velocity.T)[:, None]
    velocity *= np.minimum(1.0, 4.0 / fast)
    moved = state.position - before
    moved[:, 0] -= 10.0 * np.round(moved[:, 0] / 10.0)
    inner = (before[:, 1] > 0.1) & (before[:, 1] < 9.9)
    assert np.allclose(moved[inner], 0.01 * velocity[inner], atol=1e-12)
