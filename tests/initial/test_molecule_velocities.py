"""How molecules fly and turn at the start."""

import numpy as np
import pytest
from molecule_gases import BENT, DUMBBELL, molecule
from scipy import stats

from gasbox.initial import populate
from gasbox.scenario import parse

BOX = {"width": 1000, "height": 1000, "periodic": ["x"]}


def gas(*molecules, species=()):
    named = [{**entry, "name": f"kind {number}"} for number, entry in enumerate(molecules)]
    return parse({"container": BOX, "species": list(species), "molecules": named})


def rotation(state, kind):
    mine = state.species == kind
    return 0.5 * state.inertia[mine] * state.angular_velocity[mine] ** 2


def test_rotation_has_exactly_its_temperature():
    disc = {"name": "disc", "count": 30, "temperature": 3}
    scenario = gas(
        molecule(DUMBBELL, 50, temperature=2),
        molecule(BENT, 20, temperature=0, rotational_temperature=1.5),
        species=[disc],
    )
    state = populate(scenario)
    assert (state.angular_velocity[state.species == 0] == 0).all()
    assert rotation(state, 1).mean() == pytest.approx(1, rel=1e-13)
    assert rotation(state, 2).mean() == pytest.approx(0.75, rel=1e-13)
    assert (state.velocity[state.species == 2] != 0).sum() <= 40
    flight = 0.5 * state.mass * np.square(state.velocity).sum(axis=1)
    counts, masses, warm = np.array([30, 50, 20]), np.array([1, 2, 6]), np.array([3, 2, 0])
    expected = counts * warm * (1 - 0.5 * masses / (counts @ masses))
    assert np.bincount(state.species, flight)[:2] == pytest.approx(expected[:2], rel=1e-10)
    momentum = state.mass @ state.velocity
    assert abs(momentum[0]) < 1e-11 < abs(momentum[1])


def test_angular_velocities_are_normal():
    state = populate(gas(molecule(DUMBBELL, 4000, temperature=2)))
    found = state.angular_velocity * np.sqrt(state.inertia / 2)
    assert stats.kstest(found, "norm").pvalue > 1e-3
    # Which way one turns says nothing of where it flies or how it stands.
    for other in (state.velocity[:, 0], state.velocity[:, 1], np.cos(state.angle), np.sin(state.angle)):
        assert abs(np.corrcoef(found, other)[0, 1]) < 4 / np.sqrt(state.count)


def test_one_angular_speed_either_way_round():
    state = populate(gas(molecule(BENT, 400, temperature=None, speed=2, angular_speed=3)))
    assert np.hypot(*state.velocity.T) == pytest.approx(2, rel=1e-12)
    assert set(state.angular_velocity) == {-3.0, 3.0}
    assert abs((state.angular_velocity > 0).sum() - 200) < 4 * 10


def test_atoms_move_with_their_molecule():
    state = populate(gas(molecule(BENT, 10, temperature=1)))
    sites = state.sites
    arm, turning = sites.position - state.position[sites.owner], state.angular_velocity[sites.owner]
    around = turning[:, None] * np.stack([-arm[:, 1], arm[:, 0]], axis=1)
    assert sites.velocity == pytest.approx(state.velocity[sites.owner] + around, rel=1e-12)
    energy = 0.5 * sites.mass @ np.square(sites.velocity).sum(axis=1)
    spin = 0.25 * sites.mass * sites.radius**2 @ turning**2
    whole = 0.5 * state.mass @ np.square(state.velocity).sum(axis=1) + rotation(state, 0).sum()
    assert energy + spin == pytest.approx(whole, rel=1e-12)
