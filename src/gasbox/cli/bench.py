"""`gasbox bench`: rates on this machine."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

__all__ = ["bench"]


def bench(
    quick: Annotated[bool, typer.Option("--quick", help="Small sizes and short rounds only.")] = False,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="PATH", help="Keep the results as JSON: a file or a folder."),
    ] = None,
) -> None:
    """Measure rates, ours and those of the peers that are installed, in one table."""
    import sys

    from gasbox.bench import measure, print_table, save
    from gasbox.cli.progress import compile_first

    compile_first()
    results = measure(quick, lambda line: print(line, file=sys.stderr))
    print_table(results)
    if output is not None:
        print(f"results in {save(results, output)}")
