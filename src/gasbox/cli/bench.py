"""`gasbox bench`: rates on this machine."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

__all__ = ["bench"]


def bench(
    quick: Annotated[bool, typer.Option("--quick", help="Small sizes and short runs only.")] = False,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE.json", help="Keep the results as JSON.")
    ] = None,
) -> None:
    """Measure rates, ours and those of the peers that are installed, in one table."""
    from gasbox.bench import measure, print_table, save

    results = measure(quick)
    print_table(results)
    if output is not None:
        save(results, output)
