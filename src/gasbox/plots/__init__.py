"""Figures from arrays, with matplotlib and without pyplot: they need no screen and leave no global state."""

from gasbox.plots.balance import draw_energies, draw_indicator, draw_transfers
from gasbox.plots.ensemble import Fan, Mark, Pile, draw_fans, draw_pile, ensemble_figure
from gasbox.plots.gas import draw_gas
from gasbox.plots.heating import draw_heating_curve
from gasbox.plots.histograms import HistogramPanel, draw_histograms, histogram_figure, theory_curve
from gasbox.plots.matter import draw_hexatic, draw_msd, draw_phases, draw_rdf, draw_shares
from gasbox.plots.molecules import draw_law, draw_modes, draw_order, draw_orientation, draw_turning
from gasbox.plots.overview import overview_figure
from gasbox.plots.panels import Panel, draw_panels, panels_figure
from gasbox.plots.phase_diagram import phase_diagram_figure
from gasbox.plots.profiles import draw_density, draw_temperature_profile
from gasbox.plots.series import draw_series, series_figure
from gasbox.plots.sides import draw_centers, draw_mixing, draw_sides
from gasbox.plots.walls import draw_passed, draw_wall_pressures

__all__ = [
    "Fan",
    "HistogramPanel",
    "Mark",
    "Panel",
    "Pile",
    "draw_centers",
    "draw_density",
    "draw_energies",
    "draw_fans",
    "draw_gas",
    "draw_heating_curve",
    "draw_hexatic",
    "draw_histograms",
    "draw_indicator",
    "draw_law",
    "draw_mixing",
    "draw_modes",
    "draw_msd",
    "draw_order",
    "draw_orientation",
    "draw_panels",
    "draw_passed",
    "draw_phases",
    "draw_pile",
    "draw_rdf",
    "draw_series",
    "draw_shares",
    "draw_sides",
    "draw_temperature_profile",
    "draw_transfers",
    "draw_turning",
    "draw_wall_pressures",
    "ensemble_figure",
    "histogram_figure",
    "overview_figure",
    "panels_figure",
    "phase_diagram_figure",
    "series_figure",
    "theory_curve",
]
