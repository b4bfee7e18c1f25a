"""What can be said of a scenario without running it."""

from __future__ import annotations

from gasbox.scenario import Scenario, Stepped
from gasbox.scenario.container import CircleContainer, PolygonContainer, RectangleContainer

__all__ = ["describe", "particle_count", "try_start"]


def particle_count(scenario: Scenario) -> int:
    """Number of particles at the start; in a snapshot the counts are history."""
    listed = 0 if scenario.particles is None else scenario.particles.count
    placed = 0 if scenario.snapshot is not None else sum(kind.count for kind in scenario.kinds)
    return listed + placed


def describe(scenario: Scenario) -> str:
    """One line: what the scenario is."""
    what = (
        "a good scenario"
        if scenario.snapshot is None
        else f"a good snapshot at time {scenario.snapshot.time:g}"
    )
    count, kinds = particle_count(scenario), len(scenario.species)
    return (
        f"{what}: {count} particle{'s' * (count != 1)} of {kinds} species in {_surroundings(scenario)}, "
        f"{scenario.dynamics.kind}"
    )


def _surroundings(scenario: Scenario) -> str:
    """What the gas is in: the container, and what is in it or special about it."""
    parts = [_container(scenario)]
    moving = sum(entry.motion is not None for entry in (*scenario.walls.values(), *scenario.obstacles))
    for number, name in (
        (len(scenario.obstacles), "obstacle"),
        (moving, "moving wall"),
        (len(scenario.schedule), "scheduled change"),
    ):
        if number:
            parts.append(f"{number} {name}{'s' * (number != 1)}")
    if any(scenario.gravity):
        parts.append("gravity {:g} {:g}".format(*scenario.gravity))
    return ", ".join(parts)


def _container(scenario: Scenario) -> str:
    match scenario.container:
        case RectangleContainer(width=width, height=height, periodic=periodic):
            edges = f", periodic in {' and '.join(periodic)}" if periodic else ""
            return f"{width:g} x {height:g}{edges}"
        case CircleContainer(radius=radius):
            return f"a circle of radius {radius:g}"
        case PolygonContainer(vertices=vertices):
            return f"a polygon of {len(vertices)} sides"
        case container:
            return f"a regular polygon of {container.sides} sides, radius {container.radius:g}"


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
