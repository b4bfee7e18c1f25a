"""Figures: what they show, with which labels, and that they need no screen."""

import io
import subprocess
import sys

import numpy as np
import pytest
from matplotlib.colors import to_rgba

from gasbox.observe import Histogram, Series
from gasbox.plots import HistogramPanel, histogram_figure, overview_figure, series_figure, theory_curve
from gasbox.theory import maxwell


def panel(name="light", color="#4c9be8", mass=1.0, temperature=0.02, count=400):
    edges = np.linspace(0.0, 0.8, 31)
    counts = maxwell.expected_speed_counts(edges, count, mass, temperature or 0.02)
    return HistogramPanel(name, color, Histogram(edges, counts, 0.0, count - counts.sum()), mass, temperature)


def series(frames=20, species=2):
    time = np.arange(frames) * 0.5
    flat = np.ones(frames)
    pressure = np.where(time > 0, 0.3, np.nan)
    return Series(time, 5 * flat, flat, np.ones((frames, species)), pressure, pressure)


def test_one_panel_for_each_species_with_units():
    figure = histogram_figure([panel("light"), panel("heavy", "#7bd67b", 16.0)], title="Two gases")
    assert [axes.get_title() for axes in figure.axes] == ["light", "heavy"]
    for axes in figure.axes:
        assert axes.get_xlabel() == "speed [length/time]"
        assert axes.get_ylabel() == "particles per bin"
    assert figure.get_suptitle() == "Two gases"


def test_energy_axis():
    figure = histogram_figure([panel()], "energy")
    assert figure.axes[0].get_xlabel() == "kinetic energy [mass·length²/time²]"


def test_bars_have_the_colour_of_the_species_and_the_counts():
    shown = panel(color="#f2a33a")
    bars = histogram_figure([shown]).axes[0].patches[0]
    assert bars.get_facecolor()[:3] == to_rgba("#f2a33a")[:3]
    np.testing.assert_array_equal(bars.get_data().values, shown.histogram.counts)


def test_curve_agrees_with_the_expected_counts_in_the_middle_of_each_bin():
    for quantity in ("speed", "energy"):
        one = panel()
        middles, curve = theory_curve(one, quantity, points=61)
        edges = one.histogram.edges
        if quantity == "speed":
            expected = maxwell.expected_speed_counts(edges, 400, one.mass, one.temperature)
        else:
            expected = maxwell.expected_energy_counts(edges, 400, one.temperature)
        np.testing.assert_allclose(middles[1::2], 0.5 * (edges[1:] + edges[:-1]))
        np.testing.assert_allclose(curve[1::2], expected, atol=1e-9)


def test_no_curve_without_a_temperature():
    figure = histogram_figure([panel(temperature=None)])
    assert len(figure.axes[0].lines) == 0
    assert theory_curve(panel(temperature=0.0), "speed") is None


def test_particles_outside_the_axis_are_mentioned():
    edges = np.array([0.0, 0.1])
    figure = histogram_figure(
        [HistogramPanel("a", "red", Histogram(edges, np.array([3.0]), 0.0, 7.0), 1.0, None)]
    )
    assert [text.get_text() for text in figure.axes[0].texts] == ["7 outside"]


def test_series_labels_and_lines():
    figure = series_figure(series(), [("light", "#4c9be8"), ("heavy", "#7bd67b")], 0.28, 0.31)
    energy, heat, pressure = figure.axes
    assert energy.get_ylabel() == "energy\n[mass·length²/time²]"
    assert heat.get_ylabel() == "temperature\n[mass·length²/time²]"
    assert pressure.get_ylabel() == "pressure\n[mass/time²]"
    assert pressure.get_xlabel() == "time [time]"
    assert heat.get_legend_handles_labels()[1] == ["light", "heavy", "whole gas"]
    names = ["at the walls", "from the virial", "ideal gas", "hard discs (theory)"]
    assert pressure.get_legend_handles_labels()[1] == names


def test_what_was_not_measured_is_not_drawn():
    one = series(species=1)
    absent = Series(
        one.time, one.energy, one.temperature, one.species_temperature, one.time * np.nan, one.virial_pressure
    )
    figure = series_figure(absent, [("gas", "#4c9be8")])
    assert figure.axes[2].get_legend_handles_labels()[1] == ["from the virial"]
    assert figure.axes[1].get_legend_handles_labels()[1] == ["whole gas"]


def test_rounding_errors_do_not_fill_the_energy_axis():
    quiet = series()
    quiet.energy[3] *= 1 + 1e-14
    low, high = series_figure(quiet).axes[0].get_ylim()
    assert low < 4.91
    assert high > 5.09


@pytest.mark.parametrize("count", [1, 2, 3, 4, 6])
def test_everything_in_one_picture(count):
    panels = [panel(f"gas {i}") for i in range(count)]
    figure = overview_figure(panels, series(species=count), ideal_pressure=0.28, title="All")
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=40)
    assert file.getvalue()[:8] == b"\x89PNG\r\n\x1a\n"
    assert len(figure.axes) == count + 3


def test_an_empty_series_can_be_drawn():
    nothing = Series(*(np.zeros(0) for _ in range(3)), np.zeros((0, 1)), np.zeros(0), np.zeros(0))
    file = io.BytesIO()
    series_figure(nothing, [("gas", "#4c9be8")]).savefig(file, format="png", dpi=40)
    assert file.getvalue()


def test_pyplot_stays_away():
    code = "import sys, gasbox.plots; assert 'matplotlib.pyplot' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
