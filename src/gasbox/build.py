"""Make the parts of a simulation from a scenario: the only file that knows every kind."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gasbox import dynamics as rules
from gasbox.errors import Problem, ScenarioError
from gasbox.geometry import Enclosure, Geometry
from gasbox.initial import Overlap, populate, recall_walls, separate, worst_overlap
from gasbox.kernels.forced.bath import T_TO
from gasbox.observe import temperature
from gasbox.protocols import Dynamics, World
from gasbox.scenario import (
    Demon,
    Epidemic,
    EventDriven,
    Forced,
    Forces,
    Pong,
    Scenario,
    Snapshot,
    Stepped,
    Walk,
    pair_laws,
    starting_temperature,
)
from gasbox.state import (
    Change,
    Contacts,
    Memory,
    MoveWall,
    SetGate,
    SetGravity,
    SetWall,
    State,
    Surrounding,
    Tallies,
)
from gasbox.worlds import MaxwellsDemon, Outbreak, PongGame, Replies

__all__ = ["Parts", "build"]

_FRAMES_ACROSS = 240
"""Frames in which a disc of typical speed crosses the shorter side of the box, where no interval is given."""

_STEPS_A_FRAME = 10
"""Of forced dynamics: as many as lie between two measurements of the energy."""


@dataclass
class Parts:
    """What a simulation is made of."""

    state: State
    geometry: Geometry
    dynamics: Dynamics
    frame_interval: float
    warnings: tuple[str, ...]
    changes: list[tuple[float, Change]]
    world: World | None


def build(scenario: Scenario, threads: int | None = None, world: World | None = None) -> Parts:
    """All parts for a scenario or a snapshot; `threads` and `world` as for `Simulation`.

    Raises
    ------
    ScenarioError
        Particles that cannot be placed, or overlap where that is not allowed.
    """
    start = scenario.geometry()
    changes = _changes(scenario)
    world = world if world is not None else _world(scenario)
    geometry = start
    for time, change in sorted([*changes, *_replies(scenario, start)], key=lambda entry: entry[0]):
        if isinstance(change, SetGravity | SetWall | MoveWall | SetGate):
            geometry = rules.altered(geometry, time, change, start)
    state = populate(scenario)
    warnings: list[str] = []
    memory = _memory(scenario)
    if scenario.snapshot is not None and memory is None:
        _refuse_another_box(geometry, scenario.snapshot)
        recall_walls(state, geometry, scenario.snapshot)
    if isinstance(scenario.dynamics, EventDriven) and memory is None:
        _part(state, geometry, scenario, warnings)
    if isinstance(scenario.dynamics, Forced) and memory is None:
        warnings += _calm(state, geometry, scenario)
    if isinstance(scenario.dynamics, Stepped):
        _refuse_discs_outside(state, geometry)
    dynamics = _dynamics(scenario, state, geometry, memory, threads)
    if isinstance(scenario.dynamics, Stepped):
        warnings += _tunnelling(state, scenario.dynamics.time_step)
    return Parts(
        state, geometry, dynamics, _frame_interval(scenario, state, geometry), tuple(warnings), changes, world
    )


def _refuse_another_box(geometry: Geometry, snapshot: Snapshot) -> None:
    """Raise ScenarioError for a gas whose box a barostat has changed, under a dynamics that knows nothing of that."""
    box = np.asarray(snapshot.memory.get("box", geometry.size), np.float64)
    if np.array_equal(box, geometry.size):
        return
    found = (
        f"{geometry.width:g} x {geometry.height:g}, but a barostat has made it {box[0]:.6g} x {box[1]:.6g}"
    )
    raise ScenarioError(
        [Problem("container", found, 'the present width and height, or dynamics kind "forced"')]
    )


def _changes(scenario: Scenario) -> list[tuple[float, Change]]:
    """What was changed before the snapshot that the scenario is."""
    if scenario.snapshot is None:
        return []
    return [(entry.at, entry.change()) for entry in scenario.snapshot.changes]


def _replies(scenario: Scenario, geometry: Geometry) -> list[tuple[float, Surrounding]]:
    """What the world had made of gravity and walls until the snapshot that the scenario is."""
    if scenario.snapshot is None:
        return []
    return Replies.recalled(scenario.snapshot.memory, geometry.wall_names).entries()


def _world(scenario: Scenario) -> World | None:
    """The rules on top of the gas."""
    match scenario.world:
        case None:
            return None
        case Pong():
            return PongGame(scenario)
        case Epidemic():
            return Outbreak(scenario)
        case Demon():
            return MaxwellsDemon(scenario)


def _memory(scenario: Scenario) -> Memory | None:
    """What the snapshot remembers, if it was made by the dynamics that is asked for."""
    if scenario.snapshot is None:
        return None
    memory = scenario.snapshot.memory
    match scenario.dynamics:
        case Stepped():
            return memory if "step" in memory else None
        case EventDriven():
            return memory if "epoch" in memory else None
        case Forced():
            return memory if "forced_step" in memory else None
        case Walk():
            return memory if "walk_step" in memory else None


def _dynamics(
    scenario: Scenario, state: State, geometry: Geometry, memory: Memory | None, threads: int | None
) -> Dynamics:
    tallies = _tallies(scenario.snapshot, len(scenario.kinds), len(geometry.wall_names))
    contacts = Contacts.empty(0)
    match scenario.dynamics:
        case Stepped(time_step=time_step):
            return rules.Stepped(
                state, geometry, time_step, tallies, contacts, memory, threads, scenario.seed
            )
        case EventDriven():
            return rules.EventDriven(state, geometry, tallies, contacts, memory, scenario.seed)
        case Forced():
            settings = _forced_settings(scenario, state)
            return rules.Forced(state, geometry, settings, tallies, contacts, memory, threads, scenario.seed)
        case Walk():
            way = rules.walk_settings(scenario)
            return rules.Walk(state, geometry, way, tallies, contacts, memory, scenario.seed)


def _calm(state: State, geometry: Geometry, scenario: Scenario) -> list[str]:
    """Move apart discs whose forces are extreme, and say so; say so too if the time step is long."""
    warnings = []
    settings = _forced_settings(scenario, state)
    moved = rules.relax(state, geometry, settings, settings.strength, scenario.seed)
    if moved is not None:
        warnings.append(f"discs that overlapped were moved apart before the start, by at most {moved:.3g}")
    long = rules.step_warning(state, settings, settings.strength)
    return warnings if long is None else [*warnings, long]


def _forced_settings(scenario: Scenario, state: State) -> rules.ForcedSettings:
    """Forces and baths; a thermostat without a temperature takes that of the start."""
    assert isinstance(scenario.dynamics, Forced)
    forces = scenario.forces or Forces()
    laws = pair_laws(scenario)
    thermostat = scenario.thermostat
    if thermostat is not None and thermostat.temperature is None:
        warm = starting_temperature(scenario.kinds)
        said = scenario.snapshot.memory.get("drive_said") if scenario.snapshot is not None else None
        if warm is None and said is not None:
            warm = float(said[T_TO])
        if warm is None:
            warm = temperature(state, scenario.geometry()) or 0.0
        thermostat = thermostat.model_copy(update={"temperature": warm})
    charge = [entry.charge or 0.0 for entry in scenario.site_kinds]
    sigma, strength = min(law.sigma for law in laws.values()), max(law.epsilon for law in laws.values())
    if strength == 0.0 and forces.charges is not None:
        strength = forces.charges.strength * max(map(abs, charge)) ** 2 / sigma
    return rules.ForcedSettings(
        scenario.dynamics.time_step,
        rules.pair_terms(laws, len(scenario.site_kinds), forces.charges, charge),
        sigma,
        max(law.epsilon for law in laws.values()) if forces.walls == "repulsive" else 0.0,
        thermostat,
        scenario.barostat,
        scenario.heating,
        scenario.kinds,
        strength,
    )


def _tallies(snapshot: Snapshot | None, species: int, walls: int) -> Tallies:
    tallies = Tallies.zero(species, walls)
    if snapshot is not None:
        for name, values in snapshot.tallies.items():
            getattr(tallies, name)[...] = np.asarray(values).reshape(getattr(tallies, name).shape)
    return tallies


def _part(state: State, geometry: Geometry, scenario: Scenario, warnings: list[str]) -> None:
    """See to it that no discs overlap: refuse a start with overlaps, separate those left by the stepped rule."""
    geometry = geometry.at(state.wall_displacement)
    overlap = worst_overlap(state, geometry)
    if overlap is None:
        return
    if scenario.snapshot is None:
        raise ScenarioError([_overlap_problem(overlap)])
    moved = separate(state, geometry)
    warnings.append(
        f"{'molecules' if scenario.molecules else 'discs'} that overlapped were moved apart, by at most {moved:.3g}: "
        "event-driven dynamics knows no overlaps"
    )


def _overlap_problem(overlap: Overlap) -> Problem:
    return Problem(
        "particles",
        str(overlap),
        'particles that do not overlap each other or a wall (touching is fine), or dynamics kind "stepped"',
    )


def _tunnelling(state: State, time_step: float) -> list[str]:
    if not state.count:
        return []
    speed = np.sqrt((state.velocity**2).sum(axis=1))
    if state.sites is not None:
        speed += np.abs(state.angular_velocity) * state.radius
    fastest = float(speed.max())
    smallest = float((state.radius if state.sites is None else state.sites.radius).min())
    if fastest * time_step <= smallest:
        return []
    moves = "moves" if state.sites is None else "moves, with its rotation at the rim,"
    return [
        f"discs can pass through each other: the fastest {moves} {fastest * time_step:.3g} in a step, "
        f"the smallest radius is {smallest:.3g}; shorten dynamics.time_step to at most {smallest / fastest:.2g}, "
        'or use dynamics kind "event-driven"'
    ]


def _refuse_discs_outside(state: State, geometry: Geometry) -> None:
    """Raise ScenarioError for molecules with discs whose centres lie beyond a wall: they would never return."""
    if state.sites is None or not isinstance(geometry, Enclosure):
        return
    outside = ~geometry.at(state.wall_displacement).holds(geometry.wrap(state.sites.position), 0.0)
    rows = np.unique(state.sites.owner[outside])
    if rows.size:
        ids = ", ".join(str(state.id[row]) for row in rows[:5]) + (", ..." if rows.size > 5 else "")
        found = f"molecules {ids} with discs whose centres lie beyond a wall"
        raise ScenarioError([Problem("particles", found, "all centres must lie inside the container")])


def _frame_interval(scenario: Scenario, state: State, geometry: Geometry) -> float:
    """The scenario's own, else one step, else so that the motion is pleasant to watch (rounded to 1, 2 or 5)."""
    if scenario.frame_interval is not None:
        return scenario.frame_interval
    if isinstance(scenario.dynamics, Stepped | Walk):
        return scenario.dynamics.time_step
    if isinstance(scenario.dynamics, Forced):
        return _STEPS_A_FRAME * scenario.dynamics.time_step
    speed = math.sqrt(float((state.velocity**2).sum(axis=1).mean())) if state.count else 0.0
    if speed == 0.0:
        return 1.0
    wanted = min(geometry.width, geometry.height) / speed / _FRAMES_ACROSS
    power = 10.0 ** math.floor(math.log10(wanted))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= wanted * (1 + 1e-9))
