"""What the colours of discs say, and how often it is found anew."""

from __future__ import annotations

import logging

import numpy as np
import pytest
from free_flight import FakeClock, FreeFlight, gas
from surroundings import placed, walled

from gasbox.app.look import COLORINGS, after, mean_size, size_of
from gasbox.app.shading import MOST_NEIGHBOURS, Shading, of_speed
from gasbox.scenario import Species


def shades(simulation: FreeFlight, coloring: str) -> list[int]:
    shading = Shading()
    shading.begin(simulation)
    found = shading.of(simulation, coloring, exact=True)  # type: ignore[arg-type]
    assert found is not None
    assert found.dtype == np.uint8
    return found.tolist()


def test_ways_of_colouring_go_round() -> None:
    assert [after(one) for one in COLORINGS] == [*COLORINGS[1:], COLORINGS[0]]


def test_the_size_of_a_disc_is_sigma_or_the_diameter() -> None:
    small, large = Species(name="a", radius=0.5), Species(name="b", radius=0.5, sigma=2.0)
    assert (size_of(small), size_of(large)) == (1.0, 2.0)
    assert mean_size([1.0, 2.0], [3, 1]) == 1.25
    assert mean_size([1.0, 2.0], [0, 0]) == 1.5


def test_by_species_needs_no_shades() -> None:
    assert Shading().of(FreeFlight(gas()), "species", exact=True) is None


def test_speed_is_half_way_at_the_root_of_the_mean_square() -> None:
    simulation = FreeFlight(walled((3,)))
    simulation.state.velocity = np.array([[0.0, 0.0], [1.0, 0.0], [1e6, 0.0]])
    assert of_speed(simulation.state, 1.0).tolist() == [0, 128, 255]


def test_neighbours_are_nearer_than_one_and_a_half_diameters() -> None:
    line = [(10.0, 20.0), (11.4, 20.0), (12.8, 20.0), (30.0, 20.0)]
    assert shades(placed(FreeFlight(walled((4,))), line), "neighbours") == [1, 2, 1, 0]
    ring = [(20 + 1.2 * np.cos(a), 20 + 1.2 * np.sin(a)) for a in np.arange(9) * 2 * np.pi / 9]
    assert (
        shades(placed(FreeFlight(walled((10,))), [(20.0, 20.0), *ring]), "neighbours")[0] == MOST_NEIGHBOURS
    )


def test_a_crystal_is_solid_and_a_disc_alone_is_gas() -> None:
    rows = [(20 + 1.1 * (i + 0.5 * (j % 2)), 12 + 1.1 * 0.866 * j) for i in range(12) for j in range(14)]
    found = shades(placed(FreeFlight(walled((169,))), [*rows, (5.0, 5.0)]), "phase")
    assert found[-1] == 0
    assert np.mean(np.array(found[:-1]) == 2) > 0.7


def test_what_takes_long_is_found_anew_only_now_and_then() -> None:
    clock, simulation = FakeClock(), FreeFlight(walled((30,)))
    shading = Shading(clock)
    shading.begin(simulation)
    calls: list[float] = []
    found = shading._found

    def slow(*arguments: object) -> object:
        calls.append(clock.now)
        clock.now += 0.015
        return found(*arguments)  # type: ignore[arg-type]

    shading._found = slow  # type: ignore[method-assign, assignment]
    for frame in range(60):
        simulation.advance(until=0.1 * (frame + 1))
        shading.of(simulation, "neighbours", exact=False)
        clock.now += 1 / 60
    spent = 0.015 * len(calls)
    assert 0.08 < spent / (clock.now - 1000.0) < 0.16
    before = len(calls)
    shading.of(simulation, "neighbours", exact=True)
    shading.of(simulation, "neighbours", exact=True)  # nothing has moved
    assert len(calls) <= before + 1


def test_a_gas_goes_on_though_its_discs_cannot_be_coloured(caplog: pytest.LogCaptureFixture) -> None:
    shading = Shading()

    def broken(*_: object) -> object:
        raise ValueError("no such thing")

    shading._found = broken  # type: ignore[method-assign, assignment]
    with caplog.at_level(logging.ERROR):
        assert shading.of(FreeFlight(gas()), "phase", exact=True) is None
    assert "cannot be coloured by phase" in caplog.text
