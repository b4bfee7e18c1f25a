"""Molecules under the stepped rule over many steps: nobody leaves, nothing sticks, overlaps stay small; warnings."""

from __future__ import annotations

import numpy as np
import pytest
from stepped_molecules import (
    BOX,
    CIRCLE,
    DUMBBELL,
    ROD,
    angular_momentum,
    internal,
    kinetic,
    molecules,
    overlaps,
    parts_of,
    run,
)

from gasbox import ScenarioError, Simulation
from gasbox.scenario import parse

STAR = {
    "container": {
        "shape": "polygon",
        "vertices": [[0, 0], [9, 4], [18, 0], [14, 9], [18, 18], [9, 14], [0, 18], [4, 9]],
    }
}
OBSTACLES = {
    **BOX,
    "obstacles": [
        {"shape": "segment", "start": [4, 0], "end": [6, 5]},
        {"shape": "disc", "center": [10, 8], "radius": 1.2},
        {"shape": "polygon", "vertices": [[2, 8], [4, 8], [3, 10]]},
    ],
    "gravity": [0, -0.5],
}
LIDDED = {
    **BOX,
    "walls": {
        "top": {"motion": {"kind": "piston", "mass": 30, "pressure": 1.5}},
        "left": {"temperature": 2},
        "right": {"motion": {"kind": "sinusoid", "amplitude": 0.3, "period": 4}},
    },
}
GROUNDS = {"circle": CIRCLE, "star": STAR, "obstacles": OBSTACLES, "lidded": LIDDED}


@pytest.mark.parametrize("time_step", [0.05, 0.6], ids=["short steps", "steps that are far too long"])
@pytest.mark.parametrize("place", GROUNDS.values(), ids=GROUNDS.keys())
def test_nobody_leaves_and_the_books_balance(place, time_step):
    parts = parts_of(molecules(place, time_step, dumbbells=8, triangles=4, rods=1))
    state, tallies = parts.state, parts.dynamics.tallies
    start = internal(parts)
    for round in range(1, 11):
        run(parts, round * 150 * time_step)
        place_now = parts.geometry.at(state.wall_displacement)
        assert place_now.holds(state.sites.position, 0.0).all()
        assert place_now.holds(state.position, 0.0).all()
        gained = tallies.wall_work.sum() + tallies.wall_heat.sum() + tallies.rest_energy[0]
        scale = start + np.abs(tallies.wall_work).sum() + np.abs(tallies.wall_heat).sum()
        assert internal(parts) - start == pytest.approx(gained, abs=1e-10 * scale)
    assert tallies.wall_collisions.sum() > 150


def test_angular_momentum_in_a_circle_stays():
    parts = parts_of(molecules(CIRCLE, 0.05))
    state, middle = parts.state, (7.5, 7.5)
    start = angular_momentum(state, middle)
    scale = float(state.mass @ np.hypot(*(state.position - middle).T))
    run(parts, 100.0)
    assert parts.dynamics.tallies.wall_collisions.sum() > 200
    assert angular_momentum(state, middle) == pytest.approx(start, abs=1e-12 * scale)


DENSE = {"container": {"width": 14, "height": 13, "periodic": ["x", "y"]}}


def test_overlaps_do_not_grow_and_nothing_sticks():
    """Ten thousand steps of a dense gas (area fraction 0.4), a tenth of a radius each at the mean speed."""
    parts = parts_of(molecules(DENSE, 0.04, dumbbells=24, triangles=10, rods=4, discs=24), contacts=5000)
    state, energy = parts.state, kinetic(parts.state)
    deepest, longest, since = [], 0, {}
    for step in range(1, 10_001):
        met = {(first, second) for _, _, first, second, *_ in run(parts, 0.04 * step)}
        # Since when each pair has collided in every step.
        since = {pair: since.get(pair, step) for pair in met}
        longest = max(longest, max((step - first for first in since.values()), default=0))
        if step % 100 == 0:
            deepest.append(overlaps(state, parts.geometry).max())
    assert parts.dynamics.tallies.pair_collisions.sum() > 20_000
    assert kinetic(state) == pytest.approx(energy, rel=1e-11)
    assert parts.dynamics.warnings() == ()
    assert max(deepest) < 0.6
    early, late = np.mean(deepest[:30]), np.mean(deepest[-30:])
    assert late < early + 4 * np.std(deepest) / np.sqrt(30)
    assert longest < 20


def test_a_step_that_is_too_long_is_told_at_the_start_and_in_the_summary():
    simulation = Simulation(molecules(CIRCLE, 0.6))
    assert any("with its rotation at the rim" in warning for warning in simulation.warnings)
    simulation.advance(frames=100)
    told = " ".join(simulation.summary()["warnings"])
    assert "in one another by more than the smaller radius" in told
    assert "held back" in told
    assert Simulation(molecules(CIRCLE, 0.05)).summary()["warnings"] == []


def test_spin_alone_can_make_a_step_too_long():
    still = {"species": "dumbbell", "position": [7, 6], "velocity": [0, 0], "angular_velocity": 30.0}
    gas = {
        **BOX,
        "dynamics": {"kind": "stepped", "time_step": 0.05},
        "molecules": [{"name": "dumbbell", **DUMBBELL}],
    }
    assert Simulation(parse({**gas, "particles": [still]})).warnings
    assert not Simulation(parse({**gas, "particles": [{**still, "angular_velocity": 3.0}]})).warnings


@pytest.mark.small
@pytest.mark.parametrize(
    ("more", "path"),
    [
        ({"walls": {"left": {"open": True}}}, "walls.left.open"),
        (
            {
                "obstacles": [
                    {"shape": "segment", "start": [5, 0], "end": [5, 9], "passes": {"direction": "forward"}}
                ]
            },
            r"obstacles\[0\].passes",
        ),
    ],
)
def test_walls_that_molecules_cannot_pass_are_refused(more, path):
    with pytest.raises(ScenarioError, match=path):
        molecules(BOX, **more)


def test_a_molecule_through_a_wall_is_refused():
    rod = {"species": "rod", "position": [1.0, 6], "velocity": [0, 0], "angle": 0.0}
    gas = {**BOX, "gravity": [0, -1], "molecules": [{"name": "rod", **ROD}], "particles": [rod]}
    with pytest.raises(ScenarioError, match="molecules 0 with discs whose centres lie beyond a wall"):
        Simulation(parse({**gas, "dynamics": {"kind": "stepped"}}))


def test_a_line_counts_centres_of_mass():
    line = {"shape": "segment", "start": [7, 0], "end": [7, 12], "passes": "all"}
    parts = parts_of(molecules(BOX, 0.05, obstacles=[line]))
    state, passed = parts.state, parts.dynamics.tallies.wall_passed
    right = np.bincount(state.species[state.position[:, 0] > 7.0], minlength=4)
    run(parts, 100.0)
    # The normal of a segment points to the right of its way: this one goes up.
    assert (passed[4] > 1).all()
    now = np.bincount(state.species[state.position[:, 0] > 7.0], minlength=4)
    assert np.array_equal(passed[4, :, 0] - passed[4, :, 1], now - right)
    assert parts.dynamics.tallies.wall_collisions[4].sum() == 0
