"""What holds for every rule of motion: one test, run against each."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from gases import (
    collect,
    collisions,
    deepest_overlap,
    energy,
    event_driven,
    forced,
    random_gas,
    state_of,
    stepped,
)
from hypothesis import given, settings
from hypothesis import strategies as st

from gasbox.geometry import Rectangle
from gasbox.protocols import Dynamics, Status

DYNAMICS = {"stepped": stepped, "event-driven": event_driven}
FORCED = {**DYNAMICS, "forced": forced}
WALLED, PERIODIC, SLAB = Rectangle(16, 12), Rectangle(16, 12, True, True), Rectangle(16, 12, True, False)
RADII = [1.2, 0.9] + [0.4] * 20 + [0.15] * 12
MASSES = [20.0, 7.0] + [1.0] * 20 + [0.2] * 12

every = pytest.mark.parametrize("make", DYNAMICS.values(), ids=DYNAMICS.keys())
forced_too = pytest.mark.parametrize("make", FORCED.values(), ids=FORCED.keys())
boxes = pytest.mark.parametrize("geometry", [WALLED, PERIODIC, SLAB], ids=["walled", "periodic", "slab"])


def bits(state, dynamics) -> str:
    digest = hashlib.sha256()
    tallies = dynamics.tallies
    arrays = [
        state.position,
        state.velocity,
        tallies.pair_virial,
        tallies.pair_collisions,
        tallies.wall_impulse,
    ]
    for name, value in sorted(dynamics.memory().items()):
        arrays.append(np.asarray(value))
        digest.update(name.encode())
    for array in arrays:
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


@forced_too
@boxes
@pytest.mark.small
def test_is_a_dynamics(make, geometry):
    state = random_gas(1, geometry, [0.5] * 4)
    assert isinstance(make(state, geometry), Dynamics)


@forced_too
@boxes
@pytest.mark.small
def test_looking_never_disturbs(make, geometry):
    """In one go; in many odd pieces; with a tiny buffer of contacts; and resumed from memory: the same bits."""
    start = random_gas(7, geometry, RADII, MASSES)
    until = 0.2 if make is forced else 40.0
    whole = start.copy()
    dynamics = make(whole, geometry)
    dynamics.advance(whole, until)
    expected = bits(whole, dynamics)
    assert collisions(dynamics) > 50 or make is forced

    pieces = start.copy()
    dynamics = make(pieces, geometry)
    for time in np.sort(np.random.default_rng(1).uniform(0, until, 37)):
        dynamics.advance(pieces, time)
    dynamics.advance(pieces, until)
    assert bits(pieces, dynamics) == expected

    watched = start.copy()
    dynamics = make(watched, geometry, contacts=3)
    rows = collect(dynamics, watched, until)
    assert len(rows) == collisions(dynamics) + dynamics.tallies.wall_collisions.sum()
    assert bits(watched, dynamics) == expected

    stopped = start.copy()
    first = make(stopped, geometry)
    for share in (0.0, 0.2825, 0.2825, 0.67625):
        first.advance(stopped, share * until)
        resumed = stopped.copy()
        second = make(resumed, geometry, memory=first.memory())
        second.tallies = first.tallies.copy()
        first, stopped = second, resumed
    first.advance(stopped, until)
    assert bits(stopped, first) == expected


@boxes
@pytest.mark.small
def test_tuning_changes_no_bit(geometry):
    """Rows sorted after every few events, or never: the same bits."""
    found = set()
    for sort_after in (0, 1, 10**9):
        state = random_gas(7, geometry, RADII, MASSES)
        dynamics = event_driven(state, geometry)
        dynamics.sort_after = sort_after
        dynamics.resync(state)
        dynamics.advance(state, 3.0)
        found.add(bits(state, dynamics))
    assert len(found) == 1


@forced_too
def test_any_number_of_threads(make):
    """The bits don't depend on how many threads numba may use, nor on the process."""
    name = next(key for key, value in FORCED.items() if value is make)
    code = (
        "import test_every_dynamics as t; "
        f"s = t.random_gas(7, t.WALLED, t.RADII, t.MASSES); d = t.FORCED[{name!r}](s, t.WALLED); "
        "d.advance(s, 20.0); print(t.bits(s, d))"
    )
    found = {
        subprocess.run(
            [sys.executable, "-c", code],
            cwd=Path(__file__).parent,
            env={**os.environ, "NUMBA_NUM_THREADS": threads},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for threads in ("1", "2")
    }
    assert len(found) == 1


@every
@boxes
@pytest.mark.small
def test_contacts_account_for_every_change(make, geometry):
    """The impulses of all contacts of a particle add up to its change of momentum, and to the tallies."""
    state = random_gas(2, geometry, RADII, MASSES)
    momentum = state.mass[:, None] * state.velocity
    dynamics = make(state, geometry, contacts=64)
    rows = collect(dynamics, state, 10.0)
    assert len(rows) > 20
    for kind, _, first, second, jx, jy in rows:
        momentum[first] += (jx, jy)
        if kind == 0:
            assert first < second
            momentum[second] -= (jx, jy)
    assert np.allclose(momentum, state.mass[:, None] * state.velocity, rtol=0, atol=1e-11)
    on_walls = sum(abs(jx) + abs(jy) for kind, _, _, _, jx, jy in rows if kind == 1)
    assert dynamics.tallies.wall_impulse.sum() == pytest.approx(on_walls, rel=1e-12)
    times = [row[1] for row in rows]
    assert times == sorted(times)
    assert times[0] >= 0.0
    assert times[-1] <= 10.0


@every
@pytest.mark.small
@settings(max_examples=15, deadline=None)
@given(
    seed=st.integers(0, 10**6),
    count=st.integers(2, 30),
    spread=st.floats(0, 3),
    geometry=st.sampled_from([WALLED, PERIODIC, SLAB]),
)
def test_conservation(make, seed, count, spread, geometry):
    """Energy always; momentum along periodic directions; nobody leaves; for masses over up to six decades."""
    rng = np.random.default_rng(seed)
    masses = 10.0 ** rng.uniform(-spread, spread, count)
    state = random_gas(seed, geometry, rng.uniform(0.1, 0.8, count), masses)
    before, momentum = energy(state), (state.mass[:, None] * state.velocity).sum(axis=0)
    scale = (state.mass * np.hypot(*state.velocity.T)).sum()
    dynamics = make(state, geometry)
    dynamics.advance(state, 10.0)
    executed = 10 + collisions(dynamics)
    assert energy(state) == pytest.approx(before, rel=executed * 4.4e-16)
    drift = np.abs((state.mass[:, None] * state.velocity).sum(axis=0) - momentum)
    assert np.all(drift[geometry.periodic] <= scale * executed * 4.4e-16)
    if make is event_driven:
        assert deepest_overlap(state, geometry) < 1e-9


@every
@boxes
@pytest.mark.small
def test_permutation(make, geometry):
    """Which disc has which number makes no difference, to the bit (unless three meet at one moment)."""
    state = random_gas(3, geometry, RADII, MASSES)
    if make is stepped:  # the classroom rule goes through touching pairs by number: keep to few discs
        state = random_gas(3, geometry, RADII[:12], MASSES[:12])
    order = np.random.default_rng(0).permutation(state.count)
    other = state_of(state.position[order], state.velocity[order], state.radius[order], state.mass[order])
    for gas in (state, other):
        make(gas, geometry).advance(gas, 5.0)
    assert np.array_equal(state.position[order], other.position)
    assert np.array_equal(state.velocity[order], other.velocity)


@every
@pytest.mark.parametrize("periodic", [(False, False), (True, True)])
@pytest.mark.small
def test_exchange_of_the_axes(make, periodic):
    """The gas mirrored at the diagonal goes through the mirrored bits."""
    geometry, turned = Rectangle(16, 12, *periodic), Rectangle(12, 16, *periodic)
    state = random_gas(5, geometry, [0.5] * 24)
    other = state_of(state.position[:, ::-1], state.velocity[:, ::-1], 0.5)
    make(state, geometry).advance(state, 12.0)
    make(other, turned).advance(other, 12.0)
    assert np.array_equal(state.position, other.position[:, ::-1])


@every
@pytest.mark.small
def test_mirror(make):
    """The gas mirrored left to right does the same, until rounding is amplified."""
    state = random_gas(6, WALLED, [0.6] * 20)
    other = state_of(state.position * [-1, 1] + [16, 0], state.velocity * [-1, 1], 0.6)
    dynamics = make(state, WALLED)
    dynamics.advance(state, 3.0)
    make(other, WALLED).advance(other, 3.0)
    assert collisions(dynamics) > 5
    # Rounding of 1e-15 grows by at most some 25 in each of a handful of collisions a disc.
    assert np.abs(other.position * [-1, 1] + [16, 0] - state.position).max() < 1e-8


@every
@pytest.mark.small
def test_galilean_symmetry(make):
    """In a periodic box a common velocity changes nothing but the place."""
    state = random_gas(8, PERIODIC, [0.6] * 20)
    common = np.array([0.75, -0.5])
    other = state_of(state.position, state.velocity + common, 0.6)
    dynamics = make(state, PERIODIC)
    dynamics.advance(state, 3.0)
    make(other, PERIODIC).advance(other, 3.0)
    assert collisions(dynamics) > 5
    back = other.position - common * 3.0 - state.position
    back -= PERIODIC.size * np.rint(back / PERIODIC.size)
    assert np.abs(back).max() < 1e-8


@pytest.mark.small
def test_event_driven_reverses():
    """At area fraction 0.3, four collisions a disc and back: to 1e-10 (errors grow some 3.5 times a collision)."""
    geometry = Rectangle(13, 13, True, True)
    state = random_gas(9, geometry, [0.5] * 64)
    start = state.position.copy()
    dynamics = event_driven(state, geometry)
    until = 1.5
    dynamics.advance(state, until)
    assert 3.0 < 2 * collisions(dynamics) / 64 < 6.0
    state.velocity *= -1
    state.time = 0.0
    back = event_driven(state, geometry)
    assert back.advance(state, until) is Status.DONE
    difference = state.position - start
    difference -= geometry.size * np.rint(difference / geometry.size)
    assert np.abs(difference).max() < 1e-10


def test_a_million_collisions_keep_energy_and_distance():
    geometry = Rectangle(40, 40)
    state = random_gas(10, geometry, [0.5] * 500 + [1.5] * 20, [1.0] * 500 + [9.0] * 20)
    before = energy(state)
    dynamics = event_driven(state, geometry)
    while collisions(dynamics) < 1_000_000:
        dynamics.advance(state, state.time + 100.0)
    assert energy(state) == pytest.approx(before, rel=1e-12)
    assert deepest_overlap(state, geometry) < 1e-9


def test_size_ratio_fifty():
    geometry = Rectangle(60, 60)
    state = random_gas(11, geometry, [10.0] + [0.2] * 600, [2500.0] + [1.0] * 600)
    before = energy(state)
    dynamics = event_driven(state, geometry)
    for _ in range(10):
        dynamics.advance(state, state.time + 10.0)
        assert deepest_overlap(state, geometry) < 1e-9
    effort = dynamics.effort()
    assert energy(state) == pytest.approx(before, rel=1e-12)
    # All pairs would be 600 tests an event.
    assert effort["pair_tests"] < 100 * effort["events"]
