"""Panels of molecules: what is drawn, and under which names."""

import io

import numpy as np
import pytest
from matplotlib.figure import Figure

from gasbox import plots
from gasbox.observe import Histogram, ModeSeries, OrientationPairs, TurningCorrelation

TIME = np.array([0.0, 1.0, 2.0])

pytestmark = pytest.mark.small


def drawn(panel, *arguments, **settings):
    """The axes after a panel has drawn itself; drawing to a file must work too."""
    figure = Figure()
    axes = figure.add_subplot()
    panel(axes, *arguments, **settings)
    figure.savefig(io.BytesIO(), format="png", dpi=30)
    return axes


def names(axes):
    return axes.get_legend_handles_labels()[1]


def test_only_energies_that_there_are():
    nothing = np.full(3, np.nan)
    axes = drawn(plots.draw_modes, ModeSeries(TIME, TIME, 2 * TIME, 3 * TIME, nothing), 1.6)
    assert names(axes) == ["flight along x", "flight along y", "rotation", "T/2"]
    assert axes.lines[2].get_ydata().tolist() == [0.0, 3.0, 6.0]
    assert axes.lines[3].get_ydata()[0] == 0.8
    assert "T/2" not in names(drawn(plots.draw_modes, ModeSeries(TIME, TIME, TIME, nothing, nothing)))


def test_a_law_over_a_histogram():
    shown = Histogram.of(np.array([0.5, 1.5, 1.6]), np.array([0.0, 1.0, 2.0]))
    axis = "angular velocity", "angular_velocity"
    axes = drawn(plots.draw_law, shown, np.array([1.2, 1.8]), "#4c9be8", "sticks", axis, "normal law")
    assert names(axes) == ["measured", "normal law"]
    assert axes.lines[0].get_xdata().tolist() == [0.5, 1.5]
    assert axes.get_xlabel() == "angular velocity [rad/time]"
    assert not drawn(plots.draw_law, shown, None, "#4c9be8", "sticks", axis, "normal law").lines


def test_pairs_that_are_too_few_are_left_out():
    found = OrientationPairs(TIME, TIME, -TIME, np.array([10.0, 200.0, 300.0]))
    axes = drawn(plots.draw_orientation, found)
    assert np.isnan(axes.lines[0].get_ydata()).tolist() == [True, False, False]
    assert axes.lines[1].get_ydata()[2] == -2.0


def test_memory_is_drawn_until_it_is_forgotten():
    times = np.arange(50.0)
    found = TurningCorrelation(times, np.exp(-times), np.exp(-4 * times))
    axes = drawn(plots.draw_turning, found, [np.exp(-times), np.exp(-4 * times)])
    assert names(axes) == ["cos of the turn", "free rotors", "cos of twice the turn"]
    # exp(-3) is the first below 0.05.
    assert axes.get_xlim() == (0.0, 9.0)
    assert drawn(plots.draw_turning, TurningCorrelation(TIME, TIME + 1, TIME + 1)).get_xlim()[0] == 0.0


def test_order_beside_chance():
    axes = drawn(plots.draw_order, TIME, 0.1 * TIME, 0.06)
    assert names(axes) == ["measured", "at random"]
    assert axes.lines[1].get_ydata()[0] == 0.06
