"""Charts of matter with forces: g(r), displacement, phases, the heating curve. No page, no engine."""

from __future__ import annotations

import numpy as np
import pytest
from free_flight import FreeFlight
from surroundings import matter, placed, sample, walled
from test_studies import curves, watched

from gasbox.app.studies_of_matter import Order, Pairs, Wandering
from gasbox.app.studies_over_time import Energy
from gasbox.app.study_of_heating import Heating, turns
from gasbox.app.study_options import filled
from gasbox.state import SetBarostat

ROWS, COLUMNS, SPACING = 14, 14, 1.12


def crystal(**settings: object) -> FreeFlight:
    """A piece of triangular lattice at rest in the middle of the box; two discs are far from it and each other."""
    inside = [
        (20 + SPACING * (i + 0.5 * (j % 2)), 12 + SPACING * np.sqrt(0.75) * j)
        for i in range(COLUMNS)
        for j in range(ROWS)
    ]
    places = [*inside, *((1.0 + 3 * k, 2.0) for k in range(200 - len(inside)))]
    simulation = placed(FreeFlight(matter(**settings)), places)
    simulation.state.velocity[:] = 0.0
    return simulation


def test_phases_and_order_of_a_crystal() -> None:
    picture = watched(Order(), crystal(), 3)
    assert (picture.y.low, picture.y.high) == (0.0, 1.0)
    assert [trace.kind for trace in picture.traces] == ["line", "line", "line", "dashed"]
    found = {name: points[-1, 1] for name, points in curves(picture).items()}
    assert found["gas"] == pytest.approx(0.02)
    assert found["gas"] + found["liquid"] + found["solid"] == pytest.approx(1.0)
    assert found["solid"] > 0.7
    assert found["order"] > 0.8
    assert not Order().suits(sample(FreeFlight(walled())))


def test_pairs_stand_at_the_distance_of_the_lattice() -> None:
    picture = watched(Pairs(), crystal(), 3)
    points = curves(picture)["g(r)"]
    assert points[np.argmax(points[:, 1]), 0] == pytest.approx(SPACING, abs=0.05)
    assert np.all(points[points[:, 0] < 1.0, 1] == 0.0)
    assert picture.x.high == 5.0
    assert picture.fact == "3 samples"


def test_pairs_of_an_ideal_gas_are_there_by_chance() -> None:
    two = FreeFlight(walled((150, 100)))
    found = curves(watched(Pairs(), two, 30))
    assert set(found) == {"kind 0, kind 0", "kind 0, kind 1", "kind 1, kind 1", "by chance"}
    assert np.mean(found["kind 0, kind 1"][:, 1]) == pytest.approx(1.0, abs=0.1)


def test_pairs_forget_what_is_old() -> None:
    study, simulation = Pairs(), crystal()
    watched(study, simulation, 41)
    for beat in range(41, 130):
        simulation.advance(until=1.0 * beat)
        study.take(sample(simulation), None)
    picture = study.picture()
    assert picture is not None
    assert 40 <= int(picture.fact.split()[0]) <= 80


def test_free_flight_goes_with_the_square_of_time() -> None:
    simulation = crystal()
    simulation.state.velocity[:] = (0.3, 0.4)
    points = curves(watched(Wandering(), simulation, 20))["mean"]
    assert points[:, 1] == pytest.approx((0.5 * points[:, 0]) ** 2)


def test_what_goes_half_way_round_the_box_cannot_be_followed() -> None:
    simulation = crystal()
    simulation.state.velocity[:] = (10.0, 0.0)
    picture = watched(Wandering(), simulation, 5)
    assert picture.fact.startswith("too fast")
    assert curves(picture)["mean"][-1, 1] == 0.0


def test_turns_of_heat() -> None:
    heat = np.array([0.0, 1.0, 0.9, 2.0, 3.0, 2.9, 2.0, 1.0, 1.05, 0.5, 1.5, 2.5])
    assert turns(heat, 0.2) == [0, 4, 9, 11]
    assert turns(np.array([0.0, -1.0, -2.0]), 0.2) == [0, 2]
    assert turns(np.zeros(5), 0.2) == [0, 4]


def heated(study: Heating, simulation: FreeFlight, speeds: list[float], begin: int = 0) -> None:
    for beat, speed in enumerate(speeds, begin):
        simulation.state.time = 1.0 * beat
        simulation.state.velocity[:] = (speed, 0.0)
        simulation.state.velocity[::2] *= -1.0
        study.take(sample(simulation), None)


def test_a_curve_of_heating_and_cooling() -> None:
    study, simulation = Heating(), crystal()
    up = np.sqrt(np.linspace(0.0, 2.0, 60)).tolist()
    heated(study, simulation, up)
    picture = study.picture()
    assert picture is not None
    (solid,) = picture.traces
    assert (solid.name, solid.kind, solid.color) == ("solid", "line", "var(--gasbox-solid)")
    known = solid.points[np.isfinite(solid.points).all(axis=1)]
    # All that is added goes into motion: heat is v²/2, and so is T = v²/2 in two dimensions, but for N/(N - 1).
    assert known[-1] == pytest.approx([1.0, 200 / 199])
    heated(study, simulation, up[::-1], begin=60)
    picture = study.picture()
    assert picture is not None
    assert [(trace.name, trace.kind) for trace in picture.traces] == [
        ("solid", "line"),
        ("cooling", "dashed"),
    ]
    assert all(series["data"] for series in filled(picture)["series"])


def test_at_another_pressure_the_curve_begins_anew() -> None:
    study, simulation = Heating(), crystal(barostat={"pressure": 0.02})
    heated(study, simulation, [0.1, 0.2, 0.3])
    simulation.apply(SetBarostat(0.5))
    heated(study, simulation, [0.4], begin=3)
    assert study.picture() is None


def test_which_charts_are_wanted_by_themselves() -> None:
    driven = matter(schedule=[{"at": 5, "thermostat": {"temperature": 2.0, "over": 100}}])
    assert Heating().is_wanted(sample(FreeFlight(driven)))
    assert not Heating().is_wanted(sample(FreeFlight(matter())))
    assert Pairs().is_wanted(sample(FreeFlight(matter())))
    assert not Pairs().is_wanted(sample(FreeFlight(walled())))


def test_energy_of_forces_and_of_what_gives_it() -> None:
    simulation = crystal()
    simulation.state.potential = -500.0
    simulation.dynamics.tallies.heater_heat[0] = 3.0
    found = curves(watched(Energy(), simulation, 3))
    assert set(found) == {"kinetic", "potential", "total", "heating"}
    assert found["total"][-1, 1] == -500.0
