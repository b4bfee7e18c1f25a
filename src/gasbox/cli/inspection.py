"""What can be said of a scenario without running it."""

from __future__ import annotations

from gasbox.scenario import Scenario, Stepped

__all__ = ["describe", "particle_count", "try_start"]


def particle_count(scenario: Scenario) -> int:
    """Number of particles at the start; in a snapshot the counts are history."""
    listed = 0 if scenario.particles is None else scenario.particles.count
    placed = 0 if scenario.snapshot is not None else sum(species.count for species in scenario.species)
    return listed + placed


def describe(scenario: Scenario) -> str:
    """One line: what the scenario is."""
    box, dynamics = scenario.container, scenario.dynamics
    edges = f", periodic in {' and '.join(box.periodic)}" if box.periodic else ""
    what = (
        "a good scenario"
        if scenario.snapshot is None
        else f"a good snapshot at time {scenario.snapshot.time:g}"
    )
    count, kinds = particle_count(scenario), len(scenario.species)
    return (
        f"{what}: {count} particle{'s' * (count != 1)} of {kinds} species in {box.width:g} x {box.height:g}"
        f"{edges}, {dynamics.kind}"
    )


def try_start(scenario: Scenario) -> None:
    """Start the gas where only that can show that it is good: listed particles may overlap.

    Raises
    ------
    ScenarioError
        Discs overlap, and the dynamics knows no overlaps.
    """
    if scenario.particles is None or scenario.snapshot is not None or isinstance(scenario.dynamics, Stepped):
        return
    from gasbox.cli.progress import compile_first
    from gasbox.cli.report import warn
    from gasbox.simulation import Simulation

    compile_first()
    warn(Simulation(scenario).warnings)
