"""Forces, energy and virial of every law against the slow twin, and against theory."""

from __future__ import annotations

from types import SimpleNamespace
from typing import get_args

import numpy as np
import pytest
from forced_gases import apart, rectangle, scattered, scenario
from forced_twin import LAWS, Twin, cut_off

from gasbox import Simulation
from gasbox.dynamics import pair_terms
from gasbox.kernels.forced.laws import law_at
from gasbox.kernels.forced.tables import CUT2, F_CUT, U_CUT
from gasbox.scenario import PairLaw
from gasbox.scenario.forces import LawName, Truncation
from gasbox.theory import pair_laws as theory

every_law = pytest.mark.parametrize("law", get_args(LawName))
every_truncation = pytest.mark.parametrize("truncation", get_args(Truncation))
LARGE = {"name": "large", "radius": 1.5, "mass": 9.0, "epsilon": 0.7}
SALT = [
    {"name": "atom", "radius": 0.5, "charge": 1.0},
    {"name": "anion", "radius": 0.4, "mass": 2.0, "charge": -1.5, "epsilon": 0.5},
    {"name": "large", "radius": 1.5, "mass": 9.0, "sigma": 2.8},
]


def agree(scene, tolerance=1e-12, threads=1, steps=0):
    """The engine and its twin, now and after some steps."""
    simulation = Simulation(scene, threads=threads)
    assert simulation.warnings == ()
    state, twin = simulation.state, Twin(scene, simulation.state)
    forces, potential, virial = twin.push(state.position)
    scale = max(np.abs(forces).max(), 1.0) if state.count else 1.0
    assert np.abs(simulation.dynamics.forces(state) - forces).max(initial=0.0) <= tolerance * scale
    # Energies of both signs cancel.
    assert state.potential == pytest.approx(potential, rel=tolerance, abs=tolerance * scale)
    assert state.virial == pytest.approx(virial, rel=tolerance, abs=tolerance * scale * state.count)
    if steps:
        position, velocity = twin.steps(state.position, state.velocity, scene.dynamics.time_step, steps)
        simulation.advance(until=steps * scene.dynamics.time_step)
        assert apart(state.position, position, simulation.geometry) < 1e-11
        assert np.abs(state.velocity - velocity).max(initial=0.0) < 1e-11
    return simulation


@every_law
@every_truncation
@pytest.mark.small
def test_a_law_in_a_box_smaller_than_its_reach(law, truncation):
    position, velocity = scattered(1, 5.0, 4.4, 11, gap=0.97)
    forces = {"law": law, "truncation": truncation}
    agree(scenario(rectangle(5.0, 4.4), position, velocity, forces=forces))


@every_law
@every_truncation
def test_twenty_steps(law, truncation):
    position, velocity = scattered(2, 13.0, 12.0, 70, gap=0.97)
    forces = {"law": law, "truncation": truncation}
    simulation = agree(
        scenario(rectangle(13.0, 12.0), position, velocity, forces=forces, time_step=0.001), steps=20
    )
    assert (simulation.state.potential != 0.0) == (law != "none")


@every_law
@every_truncation
def test_a_mixture_of_sizes_with_charges(law, truncation):
    """Sizes 1:3, mixed by rule; cutoffs, wells and screening of their own; and charges on two of three species."""
    position, velocity = scattered(3, 18.0, 17.0, 60, gap=[0.97, 0.78, 2.72] * 20)
    names = ["atom", "anion", "large"] * 20
    forces = {"law": law, "truncation": truncation, "charges": {"strength": 1.3, "cutoff": 4.1}}
    scene = scenario(rectangle(18.0, 17.0), position, velocity, names, SALT, forces=forces, time_step=0.002)
    agree(scene, threads=2, steps=20)


@pytest.mark.small
def test_pairs_of_their_own():
    """One law between equals, others between species, one pair without any: each as it says."""
    position, velocity = scattered(4, 9.0, 8.0, 12, gap=1.8)
    names = ["atom", "large", "atom"] * 4
    pairs = [
        {
            "between": ["atom", "large"],
            "law": "yukawa",
            "screening_length": 0.7,
            "epsilon": 2.0,
            "cutoff": 2.2,
        },
        {
            "between": ["large", "large"],
            "law": "square-well",
            "sigma": 1.9,
            "reach": 1.3,
            "truncation": "shifted",
        },
    ]
    forces = {"law": "lennard-jones", "truncation": "force-shifted", "cutoff": 3.0, "pairs": pairs}
    species = [{"name": "atom", "radius": 0.5}, LARGE]
    agree(scenario(rectangle(9.0, 8.0), position, velocity, names, species, forces=forces))
    forces["pairs"] = [{"between": ["large", "atom"], "law": "none"}]
    agree(scenario(rectangle(9.0, 8.0), position, velocity, names, species, forces=forces))


def test_nothing_acts_on_a_species_without_strength():
    """An epsilon of zero switches the species' forces off, those with others too."""
    position, velocity = scattered(5, 9.0, 8.0, 20)
    species = [{"name": "atom", "radius": 0.5}, {"name": "ghost", "radius": 0.5, "epsilon": 0.0}]
    names = ["atom", "ghost"] * 10
    simulation = agree(scenario(rectangle(9.0, 8.0), position, velocity, names, species), steps=20)
    forces = simulation.dynamics.forces(simulation.state)
    assert not forces[1::2].any()
    assert forces[::2].any()


@every_law
@every_truncation
@pytest.mark.small
def test_theory_says_the_same(law, truncation):
    pair = PairLaw(law, 1.3, 0.9, 2.0, truncation, 1.4, 0.6)
    if law == "wca":
        pair = PairLaw(law, 1.3, 0.9, 2 ** (1 / 6) * 0.9, "shifted", 1.4, 0.6)
    r = np.concatenate([np.linspace(0.75, 1.999, 40), [2.0, 2.5]])
    u, f = cut_off(lambda x: LAWS[law](x, pair), r, pair.cutoff, pair.truncation == "force-shifted")
    scale = 1e-12 * max(1.0, np.abs(u).max())
    assert np.allclose(theory.potential(pair, r), u, rtol=1e-12, atol=scale)
    assert np.allclose(theory.force(pair, r), f, rtol=1e-12, atol=scale * 40)


@every_law
@every_truncation
@pytest.mark.small
def test_the_force_is_the_slope_of_the_potential(law, truncation):
    pair = PairLaw(law, 1.3, 0.9, 2 ** (1 / 6) * 0.9 if law == "wca" else 2.0, truncation, 1.4, 0.6)
    terms = pair_terms({(0, 0): pair}, 1)
    if law == "none":
        assert terms.law.size == 0
        return
    value = terms.value[0, :, 0]
    parameters = [float(x) for x in value[:4]]
    assert value[CUT2] == pair.cutoff**2
    u, f = law_at(int(terms.law[0]), pair.cutoff, *parameters)
    assert (u, f) == (value[U_CUT], value[F_CUT])
    for r in np.linspace(0.8, 1.9, 12):
        low, high = (law_at(int(terms.law[0]), r + by, *parameters)[0] for by in (-1e-5, 1e-5))
        force = law_at(int(terms.law[0]), r, *parameters)[1]
        assert (low - high) / 2e-5 == pytest.approx(force, rel=1e-5, abs=1e-5)
    assert terms.shifted[0] == (truncation == "force-shifted")


def test_a_new_law_has_a_twin():
    assert set(LAWS) == set(get_args(LawName))
    for law in LAWS.values():
        u, f = law(np.float64(1.1), SimpleNamespace(epsilon=1.0, sigma=1.0, reach=1.5, screening_length=1.0))
        assert np.isfinite(u)
        assert np.isfinite(f)
