"""The law of each pair of species: mixed, or as the pair says."""

import math

import pytest

from gasbox.scenario import PairLaw, pair_laws, parse

pytestmark = pytest.mark.small

A = {"name": "a", "radius": 0.5, "epsilon": 1.0}
B = {"name": "b", "radius": 0.5, "epsilon": 4.0, "sigma": 1.4}


def laws(species, forces=None):
    data = {"container": {"width": 40, "height": 40}, "species": species, "dynamics": {"kind": "forced"}}
    return pair_laws(parse({**data, **({} if forces is None else {"forces": forces})}))


def test_without_a_word_it_is_lennard_jones():
    usual = PairLaw("lennard-jones", 1.0, 3.0, 7.5, "shifted", 1.5, 3.0)
    assert laws([{"name": "a", "radius": 1.5}]) == {(0, 0): usual} == laws([{"name": "a", "radius": 1.5}], {})


def test_lorentz_and_berthelot():
    found = laws([A, B])
    assert list(found) == [(0, 0), (0, 1), (1, 1)]
    assert [found[pair].sigma for pair in found] == pytest.approx([1.0, 1.2, 1.4])
    assert [found[pair].epsilon for pair in found] == pytest.approx([1.0, 2.0, 4.0])
    assert [found[pair].cutoff for pair in found] == pytest.approx([2.5, 3.0, 3.5])


def test_of_one_species_epsilon_is_its_own_to_the_bit():
    assert laws([{**A, "epsilon": 0.1}])[0, 0].epsilon == 0.1


def test_no_attraction_to_those_without():
    assert laws([{**A, "epsilon": 0}, B])[0, 1].epsilon == 0.0


@pytest.mark.parametrize(
    ("law", "cutoff"),
    [
        ("lennard-jones", 2.5),
        ("wca", 2 ** (1 / 6)),
        ("soft-sphere", 2.5),
        ("square-well", 1.9),
        ("yukawa", 6.0),
        ("none", 0.0),
    ],
)
def test_every_law_has_its_own_cutoff(law, cutoff):
    assert laws([B], {"law": law})[0, 0].cutoff == pytest.approx(1.4 * cutoff)


def test_wca_ends_where_it_ends():
    forces = {"law": "wca", "cutoff": 3, "truncation": "force-shifted"}
    found = laws([A], forces)[0, 0]
    assert (found.cutoff, found.truncation) == (pytest.approx(2 ** (1 / 6)), "shifted")
    # At the minimum of Lennard-Jones, where the force is zero: nothing jumps there.
    assert 12 * found.cutoff**-13 == pytest.approx(6 * found.cutoff**-7)


@pytest.mark.parametrize("between", [["a", "b"], ["b", "a"]])
def test_a_pair_says_what_is_different(between):
    pair = {"between": between, "epsilon": 0.5, "cutoff": 3.0, "truncation": "force-shifted"}
    found = laws([A, B], {"cutoff": 4.0, "pairs": [pair]})
    assert found[0, 1] == PairLaw(
        "lennard-jones", 0.5, pytest.approx(1.2), pytest.approx(3.6), "force-shifted", 1.5, pytest.approx(1.2)
    )
    assert (found[0, 0].cutoff, found[1, 1].cutoff) == (4.0, pytest.approx(5.6))
    assert found[0, 0].truncation == "shifted"


def test_another_law_of_a_pair_does_not_take_the_cutoff_of_all():
    pair = {"between": ["a", "b"], "law": "yukawa", "sigma": 2.0, "screening_length": 0.7}
    found = laws([A, B], {"cutoff": 4.0, "pairs": [pair]})[0, 1]
    assert (found.law, found.sigma, found.cutoff, found.screening_length) == ("yukawa", 2.0, 12.0, 0.7)
    assert found.epsilon == pytest.approx(math.sqrt(4))


def test_reach_and_screening_of_all_hold_for_pairs():
    pair = {"between": ["a", "a"], "law": "yukawa"}
    found = laws([A, B], {"law": "square-well", "reach": 1.3, "screening_length": 2.0, "pairs": [pair]})
    assert (found[0, 0].screening_length, found[0, 1].reach) == (2.0, 1.3)
