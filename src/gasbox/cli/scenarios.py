"""`gasbox scenarios`: what comes with gasbox."""

from __future__ import annotations

__all__ = ["scenarios"]


def scenarios() -> None:
    """List the shipped scenarios, and what to watch for in each."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    from gasbox.cli.inspection import particle_count
    from gasbox.scenario import load, shipped

    table = Table("name", "particles", "what to watch for", show_lines=True)
    for name in shipped():
        scenario = load(name)
        text = f"[bold]{escape(scenario.title)}[/bold]\n{escape(scenario.watch_for)}"
        table.add_row(name, str(particle_count(scenario)), text)
    Console(highlight=False).print(table)
