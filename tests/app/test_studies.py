"""What the charts beside the histograms take from samples, and what they picture. No page, no engine."""

from __future__ import annotations

import json

import numpy as np
import pytest
from free_flight import FreeFlight
from free_rotors import DUMBBELL, FreeRotors, rotors
from surroundings import DIVIDER, matter, placed, sample, walled

from gasbox.app.directions import axis_of
from gasbox.app.studies import STUDIES
from gasbox.app.studies_of_profiles import Density, Temperature
from gasbox.app.studies_of_walls import Pressures, Work
from gasbox.app.studies_over_time import Centers, Energy, Flow, Mixing, Sides
from gasbox.app.study import Picture, Study
from gasbox.app.study_options import filled, layout
from gasbox.app.window import SlidingWindow
from gasbox.state import SetGravity
from gasbox.theory import adiabat, mixture

pytestmark = pytest.mark.small
MEMBRANE = {"shape": "segment", "start": [30, 0], "end": [30, 40], "passes": ["kind 0"], "name": "membrane"}
PISTON = {"right": {"motion": {"kind": "piston", "mass": 50, "pressure": 0.3}}}


def watched(study: Study, simulation: FreeFlight, times: int = 30) -> Picture:
    """The picture after some samples, a quarter of a second apart."""
    window = SlidingWindow()
    for beat in range(times):
        simulation.advance(until=1.0 * beat)
        one = sample(simulation)
        assert study.suits(one)
        lately = window.take(0.25 * beat, one.version, one.time, one.tallies, one.state.wall_displacement)
        study.take(one, lately)
    picture = study.picture()
    assert picture is not None
    return picture


def curves(picture: Picture) -> dict[str, np.ndarray]:
    return {trace.name: trace.points for trace in picture.traces}


def test_names_are_different_and_all_can_be_pictured() -> None:
    everything = walled(
        (40, 30), walls=PISTON | {"left": {"temperature": 1.0}}, obstacles=[MEMBRANE], gravity=[0, -0.1]
    )
    assert len({study.name for study in STUDIES}) == len(STUDIES)
    for make in STUDIES:
        gases = (FreeFlight(everything), FreeFlight(matter()), FreeRotors(rotors(DUMBBELL)))
        simulation = next(gas for gas in gases if make().suits(sample(gas)))
        simulation.dynamics.tallies.wall_collisions[:] = 1
        picture = watched(make(), simulation)
        text = json.dumps(layout(picture, "a chart"), allow_nan=False, ensure_ascii=False)
        assert "(" in picture.y.name or picture.y.name in ("number of particles", "share of all discs")
        assert all(series["name"] in text for series in filled(picture)["series"])


def test_a_study_of_another_gas_begins_anew() -> None:
    study, simulation = Sides(), FreeFlight(walled(obstacles=[DIVIDER]))
    watched(study, simulation)
    study.take(sample(FreeFlight(walled(obstacles=[DIVIDER])), version=2), None)
    assert len(study.history.time) == 1


def test_discs_on_both_sides_of_a_divider_and_how_they_mix() -> None:
    scenario = walled((2, 2), obstacles=[DIVIDER])
    parted = [(10.0, 10.0), (10.0, 20.0), (50.0, 10.0), (50.0, 20.0)]
    simulation = placed(FreeFlight(scenario), parted)
    simulation.state.velocity[:] = 0.0
    sides, mixing = watched(Sides(), simulation), watched(Mixing(), placed(FreeFlight(scenario), parted), 2)
    assert {name: points[-1, 1] for name, points in curves(sides).items()} == {
        "kind 0, left": 2, "kind 0, right": 0, "kind 1, left": 0, "kind 1, right": 2,
    }  # fmt: skip
    found = curves(mixing)
    assert found["entropy"][0, 1] == 0.0
    assert found["fully mixed"][0, 1] == pytest.approx(4 * np.log(2))


def test_energy_of_walls_is_shown_where_there_is_any() -> None:
    simulation = FreeFlight(walled(walls=PISTON))
    assert set(curves(watched(Energy(), simulation))) == {"kinetic"}
    simulation.dynamics.tallies.wall_work[1, 0] = 3.0
    found = curves(watched(Energy(), simulation, 60))
    assert set(found) == {"kinetic", "work of walls"}
    assert found["work of walls"][-1, 1] == 3.0


def test_centres_of_mass_along_gravity() -> None:
    simulation = placed(FreeFlight(walled((2,), gravity=[0, -0.1])), [(10.0, 10.0), (10.0, 30.0)])
    simulation.state.velocity[:] = 0.0
    picture = watched(Centers(), simulation, 3)
    assert picture.y.name.startswith("y ")
    assert curves(picture)["kind 0"][-1, 1] == 20.0


def test_flow_has_a_direction_and_what_leaves_has_none() -> None:
    slit = {"shape": "segment", "start": [50, 10], "end": [50, 30], "open": True, "name": "slit"}
    simulation = FreeFlight(walled(obstacles=[MEMBRANE, slit]))
    passed = simulation.dynamics.tallies.wall_passed
    study, window = Flow(), SlidingWindow()
    for beat in range(9):
        simulation.advance(until=1.0 * beat)
        passed[4, 0] += [3, 1]
        passed[5, 1] += [1, 1]
        one = sample(simulation)
        study.take(one, window.take(0.25 * beat, 1, one.time, one.tallies))
    picture = study.picture()
    assert picture is not None
    rates = {name: points[-1, 1] for name, points in curves(picture).items()}
    along = "right" if simulation.geometry.normal(4)[0] > 0 else "left"
    against = "left" if along == "right" else "right"
    assert rates == {f"membrane, to the {along}": 3, f"membrane, to the {against}": 1, "slit, leaving": 2}
    assert not study.suits(sample(FreeFlight(walled())))


def test_the_barometric_law_is_drawn_where_it_holds() -> None:
    simulation = FreeFlight(walled((400,), gravity=[0, -0.1]))
    simulation.state.velocity *= 15.0  # a scale height of about half the box
    found = curves(watched(Density(), simulation, 3))
    law = found["kind 0, hard discs"]
    assert law[0, 0] == 0.5
    assert law[-1, 0] == 39.5
    assert np.all(np.diff(law[:, 1]) < 0)
    assert np.trapezoid(law[:, 1], law[:, 0]) * 59.0 == pytest.approx(400, rel=0.01)
    assert found["kind 0"].shape[0] > 20
    two = curves(watched(Density(), FreeFlight(walled((20, 30), gravity=[0, -0.1])), 3))
    assert {"kind 0, ideal", "kind 1, ideal"} < set(two)
    tilted = FreeFlight(walled((20,), gravity=[0.05, -0.1]))
    assert set(curves(watched(Density(), tilted, 3))) == {"kind 0"}


def test_profiles_begin_anew_when_gravity_changes() -> None:
    simulation, study = FreeFlight(walled((20,))), Temperature()
    watched(study, simulation, 10)
    simulation.apply(SetGravity((0.0, -0.1)))
    assert axis_of(sample(simulation)) == "y"
    study.take(sample(simulation), None)
    picture = study.picture()
    assert picture is not None
    assert picture.x.name.startswith("y ")


def test_pressure_of_each_wall_with_its_error() -> None:
    simulation = FreeFlight(walled((20,)))
    study, window = Pressures(), SlidingWindow()
    for beat in range(5):
        simulation.advance(until=1.0 * beat)
        simulation.dynamics.tallies.wall_impulse[:, 0] += 39.0
        simulation.dynamics.tallies.wall_collisions[:, 0] += 25
        one = sample(simulation)
        study.take(one, window.take(0.25 * beat, 1, one.time, one.tallies))
    picture = study.picture()
    assert picture is not None
    (bars,) = picture.traces
    assert picture.x.labels == ("left", "right", "bottom", "top")
    assert bars.points[:, 1] == pytest.approx([1.0, 1.0, 39 / 59, 39 / 59])
    assert bars.error is not None
    assert bars.error[0] == pytest.approx(np.sqrt(4 / np.pi / 100))


@pytest.mark.parametrize("warm", [False, True])
def test_pressure_and_area_with_what_a_slow_change_would_give(warm: bool) -> None:
    walls = PISTON | ({"left": {"temperature": 2.0}} if warm else {})
    simulation = FreeFlight(walled((200,), walls=walls))
    warmth = float((0.5 * simulation.state.mass * (simulation.state.velocity**2).sum(axis=1)).mean())
    study, window = Work(), SlidingWindow()
    for beat in range(40):
        simulation.advance(until=1.0 * beat)
        simulation.state.wall_displacement[1] = -0.2 * beat
        simulation.dynamics.tallies.wall_impulse[1, 0] += 39.0 * 7.0
        one = sample(simulation)
        study.take(one, window.take(0.25 * beat, 1, one.time, one.tallies, one.state.wall_displacement))
    picture = study.picture()
    assert picture is not None
    found = curves(picture)
    # Measured over the last ten beats, in the middle of which the wall was one length further out.
    assert found["pressure"][-1] == pytest.approx([40 * (60 - 0.2 * 34), 7.0])
    law = found["slow, isothermal" if warm else "slow, without heat"]
    if warm:
        gas = mixture.Mixture.of(np.array([200]), [1.0], np.array([0.5]), law[0, 0])
        assert law[0, 1] == pytest.approx(mixture.pressure(gas, 2.0))
    else:
        assert law[0, 1] == pytest.approx(adiabat.adiabatic_pressure(law[0, 0], warmth, 200, 0.5, 2400.0))
