from dataclasses import replace

import numpy as np
import pytest

from gasbox.app.bins import BinChoice, Law, curve, edges_of, expected
from gasbox.app.chart_options import bar_rows, changes, curve_rows, initial, value_axis
from gasbox.scenario import load

pytestmark = pytest.mark.small


def test_bins_are_those_of_the_scenario() -> None:
    scenario = load("three-gases")
    choice = BinChoice.of(scenario)
    edges = edges_of(choice, [3.0, 2.0, 1.0])
    assert [len(one) for one in edges] == [scenario.histograms.bins + 1] * 3
    assert all(one[-1] == scenario.histograms.maximum for one in edges)


def test_automatic_range_is_that_of_the_fastest_or_each_its_own() -> None:
    assert [one[-1] for one in edges_of(BinChoice(), [3.0, 2.0, 1.0])] == [3.0, 3.0, 3.0]
    assert [one[-1] for one in edges_of(BinChoice(own=True), [3.0, 2.0, 1.0])] == [3.0, 2.0, 1.0]


@pytest.mark.parametrize("quantity", ["speed", "energy", "angular-velocity", "rotational-energy"])
def test_the_curve_meets_each_bins_expectation_in_its_middle(quantity: str) -> None:
    edges = np.linspace(-3.0 if quantity == "angular-velocity" else 0.0, 3.0, 31)
    values, counts = curve(edges, quantity, 500, Law(0.4, 2.0), points=601)  # type: ignore[arg-type]
    law = expected(edges, quantity, 500, Law(0.4, 2.0))  # type: ignore[arg-type]
    middles = (edges[1:] + edges[:-1]) / 2
    assert np.interp(middles, values, counts) == pytest.approx(law, rel=1e-6)
    assert law.sum() == pytest.approx(500, rel=1e-3 if quantity == "speed" else 1e-2)


def test_a_bar_knows_its_bin_and_what_theory_expects() -> None:
    rows = bar_rows(np.array([0.0, 0.5, 1.0]), np.array([3.0, 4.25]), np.array([3.333333, 4.0]))
    assert rows == [[0.25, 3.0, 0.0, 0.5, 3.33], [0.75, 4.25, 0.5, 1.0, 4.0]]
    assert bar_rows(np.array([0.0, 1.0]), np.array([3.0]), None) == [[0.5, 3.0, 0.0, 1.0, None]]
    assert curve_rows(np.array([0.123456789]), np.array([1.23456])) == [[0.12346, 1.23]]


def test_angular_velocities_go_both_ways() -> None:
    choice = BinChoice("angular-velocity", 20)
    assert [(one[0], one[10], one[-1]) for one in edges_of(choice, [3.0, 0.0])] == [(-3.0, 0.0, 3.0)] * 2
    assert edges_of(replace(choice, minimum=-1.0, maximum=4.0), [3.0])[0][0] == -1.0
    assert value_axis(-5.0, 5.0, "angular-velocity")["interval"] == 2.5


def test_axes_are_named_with_their_units() -> None:
    assert initial("light", "#123456", "angular-velocity")["xAxis"]["name"] == "angular velocity  (rad/time)"
    options = initial("light", "#123456", "speed")
    assert options["xAxis"]["name"] == "speed  (length/time)"
    assert options["yAxis"]["name"] == "number of particles"
    assert options["animation"] is False
    assert initial("light", "#123456", "energy")["xAxis"]["name"].startswith("energy")


def test_only_what_has_changed_is_sent() -> None:
    shown = initial("light", "#123456", "speed")
    wanted = {"yAxis": {"max": 80}, "series": [{"data": [[0.5, 1.0]]}, {"data": []}]}
    assert changes(shown, wanted) == {"yAxis": {"max": 80}, "series": [{"data": [[0.5, 1.0]]}, {}]}
    assert changes(shown, wanted) == {}
    assert changes(shown, {"series": [{"data": [[0.5, 2.0]]}]}) == {"series": [{"data": [[0.5, 2.0]]}]}


@pytest.mark.parametrize(
    "high", [0.2, 0.8, 1.0, 1.2, 1.5, 2.0, 2.4, 2.5, 3.0, 3.8, 4.0, 5.0, 6.0, 7.31, 8.0, 1e-7, 3e9]
)
def test_the_axis_has_a_few_round_marks(high: float) -> None:
    axis = value_axis(0.0, high, "speed")
    parts = high / axis["interval"]
    assert 4 <= parts < 11
    assert axis["axisLabel"]["showMaxLabel"] == (parts == pytest.approx(round(parts)))
    assert float(f"{axis['interval']:.1e}") == pytest.approx(axis["interval"])
