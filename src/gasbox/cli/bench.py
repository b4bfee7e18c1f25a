"""`gasbox bench`: rates on this machine."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from gasbox.bench import Result

__all__ = ["bench"]

_INTERRUPTED = 130


def bench(
    quick: Annotated[bool, typer.Option("--quick", help="Small sizes and short rounds only.")] = False,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="PATH",
            help="Keep the results as JSON in a file; in a folder, with a chart, and compared with the last run there.",
        ),
    ] = None,
) -> None:
    """Measure rates, ours beside plain loops and the peers that are installed, in one table."""
    from gasbox.bench import missing_peers, newest, print_table
    from gasbox.cli.progress import compile_first

    compile_first()
    earlier = newest(output, quick) if output is not None and output.is_dir() else None
    results, complete = _measured(quick)
    if results:
        print_table(results, earlier, missing_peers())
    if not complete:
        print("Interrupted: what was measured is shown, and not kept.")
        raise typer.Exit(_INTERRUPTED)
    if output is not None:
        _keep(results, output, quick)


def _measured(quick: bool) -> tuple[list[Result], bool]:
    """What was measured, and whether that is all of it."""
    import sys
    import time

    from gasbox.bench import measure

    begin = time.monotonic()
    results: list[Result] = []
    try:
        for part in measure(
            quick, lambda task: print(f"{time.monotonic() - begin:4.0f} s  {task}", file=sys.stderr)
        ):
            results += part
    except KeyboardInterrupt:
        return results, False
    return results, True


def _keep(results: list[Result], output: Path, quick: bool) -> None:
    import datetime

    from gasbox.bench import machine, save, save_chart
    from gasbox.version import __version__

    path = save(results, output, quick)
    print(f"results in {path}")
    if output.is_dir():
        here, today = machine(), datetime.datetime.now(datetime.UTC)
        caption = f"gasbox {__version__}, {today:%Y-%m-%d}, {here['processor']}, {here['cores']} cores"
        print(f"chart in {save_chart(results, path.with_suffix('.png'), caption)}")
