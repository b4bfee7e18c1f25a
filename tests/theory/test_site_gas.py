"""The second virial coefficient of molecules with forces: discs, the law of random numbers, and hard limits."""

import numpy as np
import pytest
from some_laws import TRUNCATED, Law

from gasbox.theory import hard_bodies, imperfect, pair_laws, site_gas

pytestmark = pytest.mark.small

PLACE = np.array([[-0.35, 0.0], [0.35, 0.0]])


def by(law):
    return lambda i, j, r: pair_laws.potential(law, np.maximum(r, 1e-3))


@pytest.mark.parametrize("temperature", [0.7, 2.0])
def test_one_site_is_a_disc(temperature):
    found = site_gas.second_virial([[0.0, 0.0]], [[0.0, 0.0]], by(TRUNCATED), 2.5, temperature, 4)
    assert found == pytest.approx(imperfect.second_virial(TRUNCATED, temperature), rel=1e-6)


@pytest.mark.parametrize("temperature", [0.9, 3.0])
def test_a_dumbbell_against_random_places(temperature):
    generator, number, end = np.random.default_rng(5), 400_000, 2.5 + 0.7
    distance = end * np.sqrt(generator.uniform(0, 1, number))
    angles = generator.uniform(0, 2 * np.pi, (2, number))
    worth = site_gas.pair_energy(PLACE, PLACE, by(TRUNCATED), distance, *angles)
    mayer = -0.5 * np.pi * end**2 * np.expm1(-worth / temperature)
    found = site_gas.second_virial(PLACE, PLACE, by(TRUNCATED), 2.5, temperature)
    assert found == pytest.approx(mayer.mean(), abs=3.5 * mayer.std() / np.sqrt(number))
    # Quadrature has converged.
    assert found == pytest.approx(
        site_gas.second_virial(PLACE, PLACE, by(TRUNCATED), 2.5, temperature, 96), rel=1e-4
    )


def test_steep_cores_are_hard():
    core = Law("soft-sphere", 1.0, 1.0, 2.5)
    hard = hard_bodies.second_virial([0.5, 0.5], PLACE)
    steep = site_gas.second_virial(
        PLACE, PLACE, lambda i, j, r: np.where(r < 1.0, 1e9, 0.0), 1.0, 1.0, angles=96
    )
    assert steep == pytest.approx(hard, rel=2e-3)
    assert site_gas.second_virial(PLACE, PLACE, by(core), 2.5, 1e-3) > hard


def test_turning_the_frame_changes_nothing():
    turn = np.array([[0.6, 0.8], [-0.8, 0.6]])
    found = site_gas.second_virial(PLACE @ turn, PLACE, by(TRUNCATED), 2.5, 1.0)
    assert found == pytest.approx(site_gas.second_virial(PLACE, PLACE, by(TRUNCATED), 2.5, 1.0), rel=1e-4)


def test_energies_depend_on_the_pair_of_sites():
    worth = site_gas.pair_energy(
        [[0.0, 0.0], [1.0, 0.0]],
        [[0.0, 0.0]],
        lambda i, j, r: (1.0 + i) * r,
        np.array([3.0]),
        np.array([np.pi]),
        np.array([0.0]),
    )
    # The second site of the one is turned to (-1, 0): distances 3 and 4.
    assert worth == pytest.approx([3.0 + 2.0 * 4.0])
