"""Figures from arrays, with matplotlib and without pyplot: they need no screen and leave no global state."""

from gasbox.plots.balance import draw_energies, draw_indicator, draw_transfers
from gasbox.plots.gas import draw_gas
from gasbox.plots.histograms import HistogramPanel, draw_histograms, histogram_figure, theory_curve
from gasbox.plots.overview import overview_figure
from gasbox.plots.panels import Panel, draw_panels, panels_figure
from gasbox.plots.profiles import draw_density, draw_temperature_profile
from gasbox.plots.series import draw_series, series_figure
from gasbox.plots.sides import draw_centers, draw_mixing, draw_sides
from gasbox.plots.walls import draw_passed, draw_wall_pressures

__all__ = [
    "HistogramPanel",
    "Panel",
    "draw_centers",
    "draw_density",
    "draw_energies",
    "draw_gas",
    "draw_histograms",
    "draw_indicator",
    "draw_mixing",
    "draw_panels",
    "draw_passed",
    "draw_series",
    "draw_sides",
    "draw_temperature_profile",
    "draw_transfers",
    "draw_wall_pressures",
    "histogram_figure",
    "overview_figure",
    "panels_figure",
    "series_figure",
    "theory_curve",
]
