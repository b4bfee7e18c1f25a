"""The `gasbox` command: its options before any command, and how errors become sentences and exit statuses."""

from __future__ import annotations

import signal
import sys
from collections.abc import Sequence
from types import FrameType
from typing import Annotated, NoReturn

import typer

from gasbox.cli.bench import bench
from gasbox.cli.check import check
from gasbox.cli.ensemble import ensemble
from gasbox.cli.lab import lab
from gasbox.cli.phase_diagram import phase_diagram
from gasbox.cli.plot import plot
from gasbox.cli.resume import resume
from gasbox.cli.run import run
from gasbox.cli.scenarios import scenarios
from gasbox.cli.schema import schema
from gasbox.errors import DynamicsError, GasboxError
from gasbox.version import __version__

__all__ = ["INTERRUPTED", "app", "main"]

INTERRUPTED = 130
"""Exit status after Ctrl-C or SIGTERM."""

app = typer.Typer(
    help="A kinetic-gas laboratory. Without a command it opens the live page, as `gasbox lab` does.",
    context_settings={"help_option_names": ["-h", "--help"]},
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
for command in (lab, run, resume, check, schema, scenarios, plot, ensemble, phase_diagram, bench):
    app.command()(command)


def _print_version(wanted: bool) -> None:
    if wanted:
        print(f"gasbox {__version__}")
        raise typer.Exit


@app.callback(invoke_without_command=True)
def _before(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", help="Show the version.", callback=_print_version, is_eager=True)
    ] = False,
) -> None:
    if context.invoked_subcommand is None:
        lab()


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run the command line and exit.

    Exit status: 0 done; 2 bad usage, file or scenario; 1 anything else; 130 interrupted.
    """
    signal.signal(signal.SIGTERM, _interrupt)
    # Also where a script has started it in the background, which makes it deaf to Ctrl-C.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        app(arguments, prog_name="gasbox")
    except GasboxError as error:
        print(f"Error: {error}", file=sys.stderr)
        sys.exit(1 if isinstance(error, DynamicsError) else 2)
    except KeyboardInterrupt:
        print("Interrupted.", file=sys.stderr)
        sys.exit(INTERRUPTED)
    except MemoryError:
        print("Error: there is not enough memory for this.", file=sys.stderr)
        sys.exit(1)
    sys.exit(0)


def _interrupt(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt
