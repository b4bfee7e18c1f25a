"""`gasbox check`: whether a scenario can be run."""

from __future__ import annotations

from gasbox.cli import options

__all__ = ["check"]


def check(scenario: options.ScenarioName) -> None:
    """Validate a scenario or snapshot, and say all that is wrong with it."""
    from gasbox.cli.inspection import describe, describe_molecules, try_start
    from gasbox.scenario import load

    read = load(scenario)
    try_start(read)
    print(f"{scenario}: {describe(read)}")
    for line in describe_molecules(read):
        print(f"  {line}")
