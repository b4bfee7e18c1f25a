"""Figures from arrays, with matplotlib and without pyplot: they need no screen and leave no global state."""

from gasbox.plots.histograms import HistogramPanel, draw_histograms, histogram_figure, theory_curve
from gasbox.plots.overview import overview_figure
from gasbox.plots.series import draw_series, series_figure

__all__ = [
    "HistogramPanel",
    "draw_histograms",
    "draw_series",
    "histogram_figure",
    "overview_figure",
    "series_figure",
    "theory_curve",
]
