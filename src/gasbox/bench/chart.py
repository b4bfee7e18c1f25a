"""Draws measured rates against the number of particles."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from gasbox.bench.contest import OURS, PLAIN, Result
from gasbox.errors import FileError
from gasbox.plots.style import INK, QUIET, dress, new_figure

__all__ = ["draw_rates", "save_chart"]

_COLORS = ("#0b6bcb", "#0f8a5f", "#c2410c", "#7c3aed", "#b45309", "#be185d")
_MARKERS = "osD^vP"


def save_chart(results: Sequence[Result], path: Path, caption: str = "") -> Path:
    """Write `draw_rates` as PNG.

    Raises
    ------
    FileError
        The file cannot be written.
    """
    try:
        draw_rates(results, caption).savefig(path)
    except OSError as error:
        raise FileError(f"cannot write {path}: {error.strerror}") from None
    return path


def draw_rates(results: Sequence[Result], caption: str = "") -> Figure:
    """Rate against number of discs, both logarithmic: one panel for each kind of dynamics.

    Parameters
    ----------
    caption : small print, such as date and machine
    """
    figure = new_figure(14.4, 4.9)
    exact, stepped, forced = figure.subplots(1, 3)
    _draw_exact(exact, [result for result in results if result.task.startswith("event-driven")])
    scanned = [result for result in results if result.task.startswith("stepped") and _filled(result.task)]
    _draw_programs(stepped, scanned, "Stepped")
    _draw_programs(forced, [result for result in results if result.task.startswith("forced")], "Forced")
    if caption:
        figure.supxlabel(caption, color=QUIET, fontsize=7.5)
    return figure


def _filled(task: str) -> float | None:
    """The area fraction that a task is named after, if it is."""
    try:
        return float(task.partition(",")[2])
    except ValueError:
        return None


def _draw_exact(axes: Axes, results: Sequence[Result]) -> None:
    """One colour for each area fraction; ours drawn through, plain loops dashed."""
    scanned = [result for result in results if _filled(result.task) is not None]
    tasks = sorted({result.task for result in scanned})
    for program in dict.fromkeys(result.program for result in scanned):
        for task, color, marker in zip(tasks, _COLORS, _MARKERS, strict=False):
            line = [result for result in scanned if (result.task, result.program) == (task, program)]
            _draw_line(axes, line, f"{program}, {_filled(task):g} filled", color, marker, program)
    _label(axes, "Event-driven", "million collisions a second")


def _draw_programs(axes: Axes, results: Sequence[Result], title: str) -> None:
    """One colour for each program; ours in ink and thick."""
    programs = sorted(dict.fromkeys(result.program for result in results), key=lambda name: OURS not in name)
    for index, program in enumerate(programs):
        line = [result for result in results if result.program == program]
        color = INK if program == OURS else _COLORS[(index - 1) % len(_COLORS)]
        _draw_line(axes, line, program, color, _MARKERS[index % len(_MARKERS)], program)
    _label(axes, title, "million particle steps a second")


def _draw_line(
    axes: Axes, results: Sequence[Result], name: str, color: str, marker: str, program: str
) -> None:
    plain = program == PLAIN
    axes.loglog(
        [result.particles for result in results],
        [result.median / 1e6 for result in results],
        label=name,
        color=color,
        linewidth=1.4 if plain else 1.9,
        linestyle="--" if plain else "-",
        marker=marker,
        markersize=5,
        markerfacecolor="white" if plain else color,
    )


def _label(axes: Axes, title: str, rate: str) -> None:
    axes.set_title(title)
    axes.set_xlabel("number of discs")
    axes.set_ylabel(rate)
    axes.margins(x=0.06, y=0.12)
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter(NullFormatter())
    dress(axes)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(
            loc="upper center",
            bbox_to_anchor=(0.5, -0.16),
            ncols=2,
            fontsize=8,
            frameon=False,
            labelcolor=INK,
        )
