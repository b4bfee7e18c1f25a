"""`gasbox plot`: the figures of a recording."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

__all__ = ["Picture", "plot"]


class Picture(StrEnum):
    """Names of figures. All but the first three show what only some gases have."""

    OVERVIEW = "overview"
    HISTOGRAMS = "histograms"
    SERIES = "series"
    GAS = "gas"
    PROFILES = "profiles"
    ENERGY = "energy"
    WALLS = "walls"
    PV = "pv"
    SIDES = "sides"
    CENTERS = "centers"
    FLOW = "flow"
    RDF = "rdf"
    MSD = "msd"
    HEXATIC = "hexatic"
    HEATING_CURVE = "heating-curve"
    PHASES = "phases"
    MODES = "modes"
    ROTATION = "rotation"
    ORIENTATION = "orientation"


def plot(
    recording: Annotated[Path, typer.Argument(metavar="RECORDING", help="An HDF5 file of gasbox run.")],
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FILE.png", help="Figure to write: .png, .svg or .pdf.")
    ],
    last: Annotated[
        int | None,
        typer.Option(
            "--last",
            min=1,
            metavar="N",
            help="Average histograms and profiles over the last N frames [half].",
        ),
    ] = None,
    figure: Annotated[
        Picture,
        typer.Option(
            "--figure",
            help="All in one (overview), or one part: speeds (histograms), numbers over time (series), the last frame "
            "(gas), density and temperature along gravity (profiles), energy, work and heat (energy), pressure on "
            "each wall (walls), pressure and area behind a moving wall (pv), both sides of a divider (sides), "
            "centres of mass (centers), who passed openings and membranes (flow), g(r) (rdf), "
            "mean squared displacement (msd), hexatic order and phases over time (hexatic), temperature against heat "
            "added (heating-curve), the last frame with discs coloured by phase (phases); of molecules, energy of each "
            "degree of freedom (modes), angular velocities and whole energies (rotation), how they are turned to "
            "each other and how long they remember (orientation).",
        ),
    ] = Picture.OVERVIEW,
) -> None:
    """Draw speed histograms with theory, numbers over time, and what walls, obstacles and gravity add to them."""
    from gasbox.cli.figures import draw
    from gasbox.cli.outputs import check_figure

    check_figure(output)
    draw(recording, output, last, figure.value)
    print(f"figure in {output}")
