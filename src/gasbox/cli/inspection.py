"""What can be said of a scenario without running it."""

from __future__ import annotations

from gasbox.scenario import Kind, Scenario, Stepped, Walk
from gasbox.scenario.container import CircleContainer, PolygonContainer, RectangleContainer

__all__ = ["describe", "describe_molecules", "particle_count", "try_start"]


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
    count = particle_count(scenario)
    return (
        f"{what}: {count} particle{'s' * (count != 1)} of {_kinds(scenario)} in {_surroundings(scenario)}, "
        f"{scenario.dynamics.kind}"
    )


def _kinds(scenario: Scenario) -> str:
    discs, molecules = len(scenario.species), len(scenario.molecules)
    if not molecules:
        return f"{discs} species"
    kinds = f"{molecules} kind{'s' * (molecules != 1)} of molecule"
    return f"{discs} species and {kinds}" if discs else kinds


def describe_molecules(scenario: Scenario) -> list[str]:
    """One line for each kind of molecule: its atoms, and what follows from them."""
    return [_molecule(kind) for kind in scenario.kinds if kind.is_molecule]


def _molecule(kind: Kind) -> str:
    atoms = len(kind.sites)
    said = [f"{atoms} atom{'s' * (atoms != 1)}", f"mass {kind.mass:g}", f"area {kind.area:.4g}"]
    said.append(f"reaches {kind.radius:.4g} from its centre of mass")
    freedom = 2
    if kind.inertia > 0.0:
        said.append(f"moment of inertia {kind.inertia:.4g}")
        freedom = 2 * atoms if kind.flexible else 3
    shape = "flexible, " if kind.flexible else "rigid, " if kind.inertia > 0.0 else ""
    return f"{kind.name}: {', '.join(said)}; {shape}{freedom} degrees of freedom"


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
    """Start the gas where only that can show that it is good: listed particles may overlap, molecules find no room.

    Raises
    ------
    ScenarioError
        Discs overlap, and the dynamics knows no overlaps; or there is no room for so many molecules.
    """
    listed = scenario.particles is not None and not isinstance(scenario.dynamics, Stepped | Walk)
    if scenario.snapshot is not None or not (listed or scenario.molecules):
        return
    from gasbox.cli.progress import compile_first
    from gasbox.cli.report import warn
    from gasbox.simulation import Simulation

    compile_first()
    warn(Simulation(scenario).warnings)
