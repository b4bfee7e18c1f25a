"""The classroom rule, to the digit."""

from __future__ import annotations

import numpy as np
import pytest
from gases import collect, collisions, energy, random_gas, state_of, stepped
from twins import SteppedTwin

from gasbox.geometry import Rectangle

pytestmark = pytest.mark.small
BOX = Rectangle(40, 40)


def test_worked_example():
    state = state_of([[19.9, 20], [21.5, 21.4]], [[0.1, 0], [-0.1, 0]])
    dynamics = stepped(state, BOX, contacts=4, time_step=1.0)
    (contact,) = collect(dynamics, state, 1.0)
    assert state.position == pytest.approx(np.array([[20, 20], [21.4, 21.4]]), abs=1e-14)
    assert state.velocity == pytest.approx(np.array([[0, -0.1], [0, 0.1]]), abs=1e-15)
    assert contact[:4] == (0, 1.0, 0, 1)
    assert contact[4:] == pytest.approx((-0.1, -0.1))
    dynamics.advance(state, 2.0)
    assert state.position == pytest.approx(np.array([[20, 19.9], [21.4, 21.5]]), abs=1e-14)
    assert collisions(dynamics) == 1


@pytest.mark.parametrize(("apart", "meets"), [(2.0, True), (2.0 + 1e-9, False)])
def test_touching_is_enough(apart, meets):
    state = state_of([[10, 10], [10 + apart, 10]], [[0, 0], [-1e-300, 0]])
    dynamics = stepped(state, BOX, time_step=1.0)
    dynamics.advance(state, 1.0)
    assert collisions(dynamics) == int(meets)


@pytest.mark.parametrize(("velocity", "meets"), [(0.1, True), (0.0, False), (-0.1, False)])
def test_only_approaching_pairs_collide(velocity, meets):
    state = state_of([[10, 10], [11.5, 10]], [[velocity, 0], [0, 0]])
    dynamics = stepped(state, BOX, time_step=1.0)
    dynamics.advance(state, 1.0)
    assert collisions(dynamics) == int(meets)
    assert state.velocity[1, 0] == (velocity if meets else 0.0)


@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize(
    ("place", "velocity", "wall"), [(1.0, -0.5, 0), (0.3, -0.5, 0), (39.0, 0.5, 1), (39.9, 0.5, 1)]
)
def test_wall_turns_a_disc_that_moves_towards_it(axis, place, velocity, wall):
    position, moving = np.full((1, 2), 20.0), np.zeros((1, 2))
    position[0, axis], moving[0, axis] = place - velocity, velocity
    state = state_of(position, moving, mass=3.0)
    (contact,) = collect(stepped(state, BOX, contacts=4, time_step=1.0), state, 1.0)
    assert state.velocity[0, axis] == -velocity
    assert state.position[0, axis] == pytest.approx(place, abs=1e-14)
    assert contact[0] == 1
    assert contact[3] == 2 * axis + wall
    assert contact[4 + axis] == -2 * 3.0 * velocity


@pytest.mark.parametrize(
    ("place", "velocity"), [(0.3, 0.1), (39.9, -0.1), (0.3, 0.0), (1.2, -0.1), (38.8, 0.1)]
)
def test_wall_lets_go_a_disc_that_moves_away_or_has_not_come(place, velocity):
    state = state_of([[place, 20]], [[velocity, 0]])
    dynamics = stepped(state, BOX, time_step=1.0)
    dynamics.advance(state, 1.0)
    assert state.velocity[0, 0] == velocity
    assert dynamics.tallies.wall_collisions.sum() == 0


def test_masses():
    state = state_of([[10, 10], [11.9, 10]], [[1, 0], [0, 0]], mass=[3.0, 1.0])
    stepped(state, BOX, time_step=0.01).advance(state, 0.01)
    assert state.velocity == pytest.approx(np.array([[0.5, 0], [1.5, 0]]), abs=1e-15)


def test_discs_never_stick():
    """Two discs that start deep in each other, and one deep in a wall, come apart and stay apart."""
    state = state_of([[10, 10], [10.2, 10.1], [0.1, 30]], [[0.3, 0], [-0.3, 0.1], [-0.2, 0]])
    dynamics = stepped(state, BOX, time_step=0.1)
    dynamics.advance(state, 8.0)
    assert np.hypot(*(state.position[1] - state.position[0])) > 2.0
    assert state.position[2, 0] > 1.0
    assert collisions(dynamics) == 1
    assert dynamics.tallies.wall_collisions.sum() == 1


@pytest.mark.parametrize(
    "geometry",
    [
        Rectangle(16, 12),
        Rectangle(16, 12, True, True),
        Rectangle(16, 12, False, True),
        Rectangle(5, 40, True, False),
    ],
)
@pytest.mark.parametrize("radii", [[0.5] * 30, [1.6, 0.2, 0.9] + [0.1] * 20 + [0.5] * 8])
def test_equals_the_slow_twin_to_the_bit(geometry, radii):
    state = random_gas(3, geometry, radii, masses=np.linspace(1, 5, len(radii)))
    twin = SteppedTwin(state.copy(), geometry, 0.05)
    dynamics = stepped(state, geometry, contacts=3, time_step=0.05)
    for _ in range(80):
        twin.step()
    collect(dynamics, state, 80 * 0.05)
    assert collisions(dynamics) > 10
    assert np.array_equal(state.position, twin.state.position)
    assert np.array_equal(state.velocity, twin.state.velocity)


def test_undone_by_colliding_before_drifting():
    """Backwards: turn all velocities, let what touches collide, then drift; exact while no touching pair lingers."""
    geometry = Rectangle(17, 17)
    rng = np.random.default_rng(10)
    grid = np.stack(np.meshgrid(np.arange(5) * 3 + 2.5, np.arange(5) * 3 + 2.5), -1).reshape(-1, 2)
    state = state_of(grid, rng.normal(size=(25, 2)), 0.5)
    start = state.copy()
    dt, steps = 2.0**-7, 400
    twin = SteppedTwin(state.copy(), geometry, dt)
    for _ in range(steps):
        twin.step()
    dynamics = stepped(state, geometry, time_step=dt)
    dynamics.advance(state, steps * dt)
    assert collisions(dynamics) >= 5
    assert twin.lingering == 0
    back = SteppedTwin(state, geometry, dt)
    state.velocity *= -1
    for _ in range(steps):
        # A step of no duration executes the collisions at the present place; then drift.
        back.time_step = 0.0
        back.step()
        state.position = state.position + state.velocity * dt
    # Errors of 1e-15 grow some 25 times in each of a handful of collisions a disc.
    assert np.abs(state.position - start.position).max() < 1e-8
    assert np.abs(-state.velocity - start.velocity).max() < 1e-8


def test_energy_and_momentum_are_exact_per_collision():
    state = random_gas(1, Rectangle(20, 20, True, True), [0.7] * 60, masses=np.geomspace(0.01, 100, 60))
    before, momentum = energy(state), (state.mass[:, None] * state.velocity).sum(axis=0)
    scale = (state.mass * np.hypot(*state.velocity.T)).sum()
    dynamics = stepped(state, Rectangle(20, 20, True, True), time_step=0.01)
    dynamics.advance(state, 20.0)
    done = collisions(dynamics)
    assert done > 1000
    # Each collision rounds a few times by 1.1e-16; the errors add like a random walk at worst linearly.
    assert energy(state) == pytest.approx(before, rel=done * 4.4e-16)
    after = (state.mass[:, None] * state.velocity).sum(axis=0)
    assert np.abs(after - momentum).max() < scale * done * 4.4e-16


def test_a_heap_of_discs_has_more_touching_pairs_than_room_was_made_for():
    rng = np.random.default_rng(2)
    state = state_of(20 + rng.uniform(-1, 1, (40, 2)), rng.normal(size=(40, 2)))
    twin = SteppedTwin(state.copy(), BOX, 0.05)
    for _ in range(10):
        twin.step()
    dynamics = stepped(state, BOX, contacts=5)
    collect(dynamics, state, 0.5)
    assert twin.lingering > 10 * (2 * 40 + 64)  # far more pairs touch in a step than the first list holds
    assert collisions(dynamics) > 50
    assert np.array_equal(state.velocity, twin.state.velocity)
