"""What the page says of molecules: their energies, what levels out, the sticks between atoms."""

from __future__ import annotations

import math

import numpy as np
import pytest
from free_flight import gas
from free_rotors import DUMBBELL, SPRING, FreeRotors, rotors
from surroundings import sample

from gasbox.app import picture
from gasbox.app.bodies import sticks
from gasbox.app.look import Look, sizes_of
from gasbox.app.molecule_numbers import Energies, energies_of
from gasbox.app.protocol import decode_frame
from gasbox.app.sample import Sample
from gasbox.app.study_of_degrees import Degrees, bond_energies, degree_energies
from gasbox.scenario import Kind, parse

pytestmark = pytest.mark.small
FORCED = {"kind": "forced"}
ARGON = {"name": "argon", "radius": 1.0, "mass": 3.0, "count": 5, "temperature": 1}


def kind(*places: tuple[float, float], bonds: tuple[tuple[int, int], ...] = ()) -> Kind:
    made = {
        "name": "made",
        "atoms": [{"position": list(place), "radius": 0.5} for place in places],
        "bonds": [{"atoms": list(pair)} for pair in bonds],
    }
    return parse({"container": {"width": 100, "height": 100}, "molecules": [made]}).kinds[0]


def test_sticks_are_the_bonds_or_join_neighbours() -> None:
    around = [(math.cos(k * math.pi / 3), math.sin(k * math.pi / 3)) for k in range(6)]
    ring = [(0, 1), (0, 5), (1, 2), (2, 3), (3, 4), (4, 5)]
    assert sticks(kind((0, 0), (2, 0), (1, 1), bonds=((0, 2), (2, 1)))) == [(0, 2), (2, 1)]
    assert sticks(kind((0, 0), (0.5, 0), (1, 0), (1.5, 0))) == [(0, 1), (1, 2), (2, 3)]
    assert sticks(kind((1, 0), (0, 0), (0, 3))) == [(0, 1), (1, 2)]
    assert sticks(kind(*around)) == ring
    assert sticks(kind((0, 0))) == []


def test_energies_of_one_particle() -> None:
    simulation = FreeRotors(rotors(DUMBBELL, SPRING, species=(ARGON,), dynamics=FORCED))
    state = simulation.state
    assert state.sites is not None
    disc, rigid, soft = 0, 5, 25
    state.velocity[[disc, rigid, soft]] = (3.0, 4.0)
    state.angular_velocity[rigid] = -2.0
    inertia = 2 * (2.0**2 + 0.5 * 1.5**2)
    assert energies_of(state, disc) == Energies(0.5 * 3.0 * 25)
    assert energies_of(state, rigid) == Energies(25.0, 0.5 * inertia * 4.0, None, -2.0)
    # Two points 3 apart, that turn at 2 and part at 1 each.
    first = int(state.sites.first[soft])
    middle = state.position[soft]
    state.sites.position[first : first + 2] = middle + np.array([[-1.5, 0.0], [1.5, 0.0]])
    state.sites.velocity[first : first + 2] = np.array([[3.0 - 1.0, 4.0 - 3.0], [3.0 + 1.0, 4.0 + 3.0]])
    found = energies_of(state, soft)
    assert found.translational == 25.0
    assert (found.rotational, found.vibrational, found.angular_velocity) == pytest.approx((9.0, 1.0, 2.0))


def test_a_frame_has_angles_as_they_are_after_many_turns_and_the_places_of_what_bends() -> None:
    simulation = FreeRotors(rotors(DUMBBELL, SPRING, dynamics=FORCED))
    state = simulation.state
    assert state.sites is not None
    state.angle[0] = 1.0 + 2 * math.pi * 100_000
    state.angle[1] = -3.0
    message = picture.frame(
        simulation,  # type: ignore[arg-type]
        generation=1,
        number=1,
        playing=True,
        light=None,
        followed_id=None,
        pointed_id=7,
        look=Look(),
        shades=None,
    )
    back = decode_frame(message)
    assert back.angle is not None
    assert back.places is not None
    assert back.angle[:2] == pytest.approx([1.0, -3.0], abs=1e-6)
    assert np.abs(back.angle).max() <= np.float32(np.pi)
    np.testing.assert_array_equal(back.places, state.sites.position[40:].astype(np.float32))


def still(simulation: FreeRotors) -> Sample:
    simulation.state.velocity[:] = 0.0
    simulation.state.angular_velocity[:] = 0.0
    return sample(simulation)  # type: ignore[arg-type]


def test_energies_of_degrees_of_freedom_with_their_errors() -> None:
    simulation = FreeRotors(rotors(DUMBBELL, species=(ARGON,), container={"width": 60, "height": 40}))
    one = still(simulation)
    state = one.state
    state.velocity[5:] = (0.5, 2.0)
    state.angular_velocity[5:] = 1.0
    found = degree_energies(one, 1)
    inertia = 2 * (2.0**2 + 0.5 * 1.5**2)
    assert found[:3, 0] == pytest.approx([0.25, 4.0, 0.5 * inertia])
    assert found[:3, 1] == pytest.approx(found[:3, 0] * math.sqrt(2 / 20))
    assert np.all(np.isnan(found[3:]))
    argon = degree_energies(one, 0)
    assert argon[:2, 0] == pytest.approx([0.0, 0.0])
    assert np.isnan(argon[2, 0])


def test_what_bonds_and_angles_hold() -> None:
    bent = {
        "atoms": [{"position": place} for place in ([-1, 0], [0, 0], [0, 1])],
        "bonds": [{"atoms": [0, 1], "stiffness": 8.0}, {"atoms": [1, 2], "stiffness": 8.0}],
        "angles": [{"atoms": [0, 1, 2], "stiffness": 2.0}],
        "count": 2,
    }
    scenario = rotors(bent, dynamics=FORCED)
    state = FreeRotors(scenario).state
    assert state.sites is not None
    np.testing.assert_allclose(bond_energies(state, scenario.kinds[0], 0), 0.0, atol=1e-12)
    place = state.sites.position
    place[3:6] = [(-1.5, 0.0), (0.0, 0.0), (1.0, 0.0)]
    held = bond_energies(state, scenario.kinds[0], 0)
    assert held is not None
    assert held[1] == pytest.approx(4.0 * 0.25 + 1.0 * (math.pi / 2) ** 2)


def test_bars_level_out_around_the_line() -> None:
    simulation = FreeRotors(rotors(DUMBBELL, SPRING, species=(ARGON,), dynamics=FORCED))
    study = Degrees()
    assert study.suits(sample(simulation))  # type: ignore[arg-type]
    study.take(sample(simulation), None)  # type: ignore[arg-type]
    shown = study.picture()
    assert shown is not None
    assert shown.x.labels == ("x", "y", "rotation", "vibration", "bonds")
    assert [trace.name for trace in shown.traces] == ["T/2", "argon", "molecule 0", "molecule 1"]
    level = shown.traces[0].points[:, 1]
    assert np.all(level == level[0])
    assert shown.y.high is not None
    assert shown.y.high > max(np.nanmax(trace.points[:, 1]) for trace in shown.traces)


def test_discs_alone_have_no_such_bars() -> None:
    from free_flight import FreeFlight

    assert not Degrees().suits(sample(FreeFlight(gas())))


def test_sizes_of_molecules_are_means_over_all_directions() -> None:
    rigid, soft = sizes_of(rotors(DUMBBELL, SPRING, dynamics=FORCED))
    # Cauchy: of a convex body the mean width is its perimeter over pi.
    assert rigid == pytest.approx((2 * 4.0 + 2 * math.pi * 1.5) / math.pi, rel=1e-4)
    assert soft == pytest.approx((2 * 3.0 + 2 * math.pi * 1.0) / math.pi, rel=1e-4)
