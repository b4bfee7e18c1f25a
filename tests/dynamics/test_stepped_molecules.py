"""Molecules under the stepped rule: against a slow twin, the laws of each collision, and the same bits."""

from __future__ import annotations

import numpy as np
import pytest
from stepped_molecules import (
    BOX,
    DUMBBELL,
    PERIODIC,
    PLACES,
    angular_momentum,
    bits,
    kinetic,
    molecules,
    parts_of,
    run,
)
from stepped_molecules_twin import MoleculesTwin

from gasbox import Simulation
from gasbox.build import build
from gasbox.geometry import Enclosure
from gasbox.scenario import parse


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_equals_the_slow_twin(place):
    parts = parts_of(molecules(place))
    twin = MoleculesTwin(parts.state.copy(), parts.geometry, 0.02)
    run(parts, 5.0)
    twin.run(250)
    tallies = parts.dynamics.tallies
    assert tallies.pair_collisions.sum() > 20
    assert tallies.wall_collisions.sum() > 10 or place is PERIODIC
    assert twin.sweeps >= 1
    # In an enclosure the twin writes a bounce differently, and rounding grows.
    tolerance = 1e-9 if isinstance(parts.geometry, Enclosure) else 0.0
    for name in ("position", "velocity", "angle", "angular_velocity"):
        assert np.allclose(getattr(parts.state, name), getattr(twin.state, name), rtol=0, atol=tolerance), (
            name
        )
    # These are turned by another library's sine.
    tolerance += 1e-12
    assert np.allclose(parts.state.sites.position, twin.state.sites.position, rtol=0, atol=tolerance)
    assert np.allclose(parts.state.sites.velocity, twin.state.sites.velocity, rtol=0, atol=tolerance)


def test_energy_and_momentum_of_each_step():
    parts = parts_of(molecules(PERIODIC, 0.05))
    state, tallies = parts.state, parts.dynamics.tallies
    state.velocity += (0.3, -0.1)
    parts.dynamics.resync(state)
    energy, momentum = kinetic(state), state.mass @ state.velocity
    scale = np.abs(state.mass[:, None] * state.velocity).sum()
    for step in range(1, 401):
        run(parts, 0.05 * step)
        assert kinetic(state) == pytest.approx(energy, rel=1e-12)
        assert np.abs(state.mass @ state.velocity - momentum).max() < 1e-13 * scale
    assert tallies.pair_collisions.sum() > 100


def two(rng, place=None, **more):
    """Two molecules, turned and spinning at random, one beside the other and meeting about half-way."""
    away = rng.normal(size=2)
    away *= 3.0 / np.hypot(*away)
    rows = [
        {
            "species": name,
            "position": (np.array([20.0, 20.0]) + sign * away).tolist(),
            "velocity": (-sign * away / 3.0 + 0.2 * rng.normal(size=2)).tolist(),
            "angle": float(rng.uniform(0, 6)),
            "angular_velocity": float(rng.normal()),
        }
        for name, sign in (("one", -1), ("other", 1))
    ]
    other = {"atoms": [{"position": [0, 0], "mass": 3}, {"position": [1.5, 0.4], "radius": 0.6}]}
    box = {"container": {"width": 40, "height": 40, "periodic": ["x", "y"]}}
    return parse(
        {
            **(place or box),
            "molecules": [{"name": "one", **DUMBBELL}, {"name": "other", **other}],
            "particles": rows,
            "dynamics": {"kind": "stepped", "time_step": 0.02},
            **more,
        }
    )


def test_each_collision_keeps_energy_momentum_and_angular_momentum():
    rng, hits = np.random.default_rng(3), 0
    for _ in range(40):
        parts = parts_of(two(rng), contacts=100)
        state = parts.state
        for step in range(150):
            before = kinetic(state), *(state.mass @ state.velocity), angular_momentum(state, (20, 20))
            if run(parts, 0.02 * (step + 1)):
                after = kinetic(state), *(state.mass @ state.velocity), angular_momentum(state, (20, 20))
                assert np.allclose(before, after, rtol=0, atol=1e-13)
                hits += 1
    assert hits > 25


def test_the_impulse_lies_along_the_line_of_centres_and_is_booked_with_its_virial():
    rng = np.random.default_rng(5)
    parts = parts_of(two(rng), contacts=100)
    state, tallies = parts.state, parts.dynamics.tallies
    for step in range(1, 200):
        old = state.copy()
        rows = run(parts, 0.02 * step)
        if rows:
            break
    assert len(rows) == 1
    given = np.array(rows[0][4:])
    assert np.allclose(state.mass[0] * (state.velocity[0] - old.velocity[0]), given, rtol=1e-12)
    assert tallies.pair_virial[0] == pytest.approx(given @ (state.position[0] - state.position[1]), rel=1e-12)
    x = state.sites.position
    first, second = min(
        ((p, q) for p in (0, 1) for q in (2, 3)), key=lambda pq: np.hypot(*(x[pq[0]] - x[pq[1]]))
    )
    along = x[first] - x[second]
    assert abs(given[0] * along[1] - given[1] * along[0]) < 1e-12 * np.hypot(*given) * np.hypot(*along)


def test_a_collision_is_undone_by_reversal():
    rng, undone = np.random.default_rng(8), 0
    for _ in range(30):
        parts = parts_of(two(rng), contacts=100)
        state, start = parts.state, parts.state.copy()
        forth = run(parts, 3.0)
        state.velocity *= -1
        state.angular_velocity *= -1
        parts.dynamics.resync(state)
        back = run(parts, 6.02)
        # Who is still in contact a step after the collision meets once more on the way back.
        if len(forth) != 1 or len(back) != 1:
            continue
        undone += 1
        assert np.allclose(state.velocity, -start.velocity, rtol=0, atol=1e-12)
        assert np.allclose(state.angular_velocity, -start.angular_velocity, rtol=0, atol=1e-12)
    assert undone >= 10


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_threads_pieces_buffers_and_resuming_change_no_bit(place):
    scenario = molecules(place, 0.05)
    parts = parts_of(scenario)
    run(parts, 10.0)
    expected = bits(parts)
    assert parts.dynamics.tallies.pair_collisions.sum() > 40
    for threads, contacts in ((2, 0), (3, 1), (1, 2)):
        other = parts_of(scenario, contacts, threads)
        rows = run(other, 10.0)
        assert bits(other) == expected
        assert not contacts or len(rows) == sum(
            int(entry.sum())
            for entry in (other.dynamics.tallies.pair_collisions, other.dynamics.tallies.wall_collisions)
        )
    pieces = Simulation(scenario)
    for until in (0.4, 3.0, 3.05, 7.6):
        pieces.advance(until=until)
    again = Simulation.restore(pieces.snapshot())
    again.advance(until=10.0)
    assert bits(build_parts(again)) == expected


def build_parts(simulation):
    """The parts of a simulation, as `bits` wants them."""
    parts = build(simulation.scenario)
    parts.state, parts.dynamics = simulation.state, simulation.dynamics
    return parts


DISCS = {
    "periodic": PERIODIC,
    "box": BOX,
    "falling circle": PLACES["falling circle"],
    "parted": {
        **BOX,
        "obstacles": [{"shape": "segment", "start": [9, 0], "end": [9, 12], "passes": ["small"]}],
    },
}


def disc_gas(place, molecule: bool):
    """Discs of two species, as species or as molecules of one atom; perhaps with a molecule that rests in a corner."""
    rng = np.random.default_rng(4)
    x, y = np.meshgrid(np.arange(2.5, 9.0, 1.3), np.arange(2.5, 8.0, 1.3))
    places = np.stack([x.ravel(), y.ravel()], axis=1)
    rows = [
        {
            "species": ("small", "large")[k % 2],
            "position": at.tolist(),
            "velocity": rng.normal(size=2).tolist(),
        }
        for k, at in enumerate(places)
    ]
    alone = [{"species": "dumbbell", "position": [7.5, 11.4], "velocity": [0, 0], "angle": 0.0}]
    small = {"name": "small", "radius": 0.3}
    large = {"name": "large", "radius": 0.6, "mass": 3}
    atoms = [{"name": disc["name"], "atoms": [{"position": [1, 1], **disc}]} for disc in (small, large)]
    for entry in atoms:
        del entry["atoms"][0]["name"]
    return parse(
        {
            **place,
            "species": [] if molecule is None else [small, large],
            "molecules": (atoms if molecule is None else [])
            + ([{"name": "dumbbell", **DUMBBELL}] if molecule else []),
            "particles": rows + (alone if molecule else []),
            "dynamics": {"kind": "stepped", "time_step": 0.05},
        }
    )


@pytest.mark.parametrize("place", DISCS.values(), ids=DISCS.keys())
def test_discs_and_molecules_of_one_atom_go_as_in_a_gas_of_discs(place):
    discs, atoms, beside = (parts_of(disc_gas(place, kind), 50) for kind in (False, None, True))
    rows = [run(parts, 1.0) for parts in (discs, atoms, beside)]
    n = discs.state.count
    assert not (beside.dynamics.tallies.pair_collisions[:, 2]).any()
    assert discs.dynamics.tallies.pair_collisions.sum() > 10
    assert rows[0] == rows[1]
    assert rows[0] == [row for row in rows[2] if row[2] != n]
    for parts in (atoms, beside):
        assert np.array_equal(parts.state.position[:n], discs.state.position)
        assert np.array_equal(parts.state.velocity[:n], discs.state.velocity)
        assert np.array_equal(parts.state.sites.position[:n], discs.state.position)
        assert np.array_equal(parts.state.sites.velocity[:n], discs.state.velocity)
