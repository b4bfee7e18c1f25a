"""`gasbox lab`: the live page."""

from __future__ import annotations

from typing import Annotated

import typer

__all__ = ["lab"]


def lab(
    scenario: Annotated[
        str, typer.Argument(metavar="SCENARIO", help="A file, or the name of a shipped scenario.")
    ] = "three-gases",
    host: Annotated[
        str, typer.Option("--host", help="Address to listen on; only this machine unless changed.")
    ] = "127.0.0.1",
    port: Annotated[
        int | None, typer.Option("--port", min=0, max=65535, help="Port; 0 takes any free one.")
    ] = None,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Do not open a browser.")] = False,
    max_sessions: Annotated[
        int, typer.Option("--max-sessions", min=1, help="Most pages with a gas at the same time.")
    ] = 16,
) -> None:
    """Open the live page."""
    from gasbox.scenario import load

    read = load(scenario)
    from gasbox.app.server import serve

    serve(read, host, port, not no_browser, max_sessions)
