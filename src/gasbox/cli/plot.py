"""`gasbox plot`: the standard figures of a recording."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

__all__ = ["plot"]


def plot(
    recording: Annotated[Path, typer.Argument(metavar="RECORDING", help="An HDF5 file of gasbox run.")],
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FILE.png", help="Figure to write: .png, .svg or .pdf.")
    ],
    last: Annotated[
        int | None,
        typer.Option("--last", min=1, metavar="N", help="Average histograms over the last N frames [half]."),
    ] = None,
) -> None:
    """Draw speed histograms with theory, and energy, temperature and pressure over time."""
    from gasbox.cli.figures import draw
    from gasbox.cli.outputs import check_figure

    check_figure(output)
    draw(recording, output, last)
    print(f"figure in {output}")
