"""Compiles all kernels before they are needed, each by a gas that is so small that it takes no time."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Callable
from typing import Any, Final

from gasbox.build import build
from gasbox.initial import populate, separate, worst_overlap
from gasbox.jit import mark_compiled, was_compiled
from gasbox.protocols import Led
from gasbox.scenario import Scenario, parse
from gasbox.state import Contacts, SetWalkers

__all__ = ["compile_kernels", "compile_parts"]


_HELPER: Final = "from gasbox.compiling import help_to_compile; help_to_compile()"


def compile_kernels(progress: Callable[[int, int, str], None] | None = None) -> None:
    """Compile all kernels (first start after an installation) or load them from the cache.

    Where there is another processor, a second process begins at the other end of the list: what it has compiled by
    then is only loaded here.

    Parameters
    ----------
    progress : called before each part and at the end with (parts done, parts in all, name of the next part)
    """
    if was_compiled() or (os.cpu_count() or 1) < 2:
        compile_parts(progress)
        return
    helper = subprocess.Popen(
        [sys.executable, "-c", _HELPER],
        stdin=subprocess.PIPE,  # never written to: it ends when this process does
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        compile_parts(progress)
    finally:
        helper.kill()
        helper.communicate()


def help_to_compile() -> None:
    """Compile all kernels from the last part backwards; ends when the process that asked for it ends."""

    def end_with_parent() -> None:
        sys.stdin.read()
        os._exit(1)

    threading.Thread(target=end_with_parent, daemon=True).start()
    compile_parts(backwards=True)


def compile_parts(progress: Callable[[int, int, str], None] | None = None, backwards: bool = False) -> None:
    """Compile or load all kernels in this process, from the first part to the last or backwards.

    Parameters
    ----------
    progress : as of `compile_kernels`
    """
    parts: list[tuple[str, Callable[[], object]]] = [
        ("placing discs", lambda: populate(_tiny("stepped"))),
        ("placing molecules", _place_tiny_molecules),
        ("finding overlaps", _part_tiny),
        ("finding overlaps of molecules", _part_tiny_molecules),
        ("stepped dynamics", lambda: _run_tiny("stepped")),
        ("finding events", lambda: build(_tiny("event-driven"))),
        ("event-driven dynamics", lambda: _run_tiny("event-driven")),
        ("forced dynamics", lambda: _run_tiny("forced")),
        ("forced dynamics, molecules", _push_tiny_molecules),
        ("stepped dynamics, walls of any shape", lambda: _run_tiny("stepped", enclosed=True)),
        ("event-driven dynamics, walls of any shape", lambda: _run_tiny("event-driven", enclosed=True)),
        ("stepped molecules", lambda: _run_tiny("stepped", molecules=True)),
        ("stepped molecules, walls of any shape", lambda: _run_tiny("stepped", True, True)),
        ("event-driven molecules", lambda: _run_tiny("event-driven", True, True)),
        ("people who walk", _infect_tiny),
    ]
    for done, (name, compile_part) in enumerate(reversed(parts) if backwards else parts):
        if progress is not None:
            progress(done, len(parts), name)
        compile_part()
    if progress is not None:
        progress(len(parts), len(parts), "")
    mark_compiled()


_ENCLOSED: Final[dict[str, Any]] = {
    "gravity": [0, -0.1],
    "walls": {"top": {"motion": {"kind": "piston", "mass": 10, "pressure": 1}}, "left": {"temperature": 1}},
    "obstacles": [{"shape": "segment", "start": [10, 0], "end": [10, 5], "passes": ["small"]}],
}


_POST: Final[dict[str, Any]] = {"shape": "disc", "center": [5, 5], "radius": 1}


_MOLECULES: Final[dict[str, Any]] = {
    "molecules": [{"name": "hydrogen", "model": "hydrogen", "count": 4, "temperature": 1}]
}


def _tiny(kind: str, enclosed: bool = False, molecules: bool = False) -> Scenario:
    return parse(
        {
            **(_ENCLOSED if enclosed else {}),
            **(_MOLECULES if molecules else {}),
            "format": "gasbox-scenario/1",
            "container": {"shape": "rectangle", "width": 20, "height": 20},
            "species": [
                {"name": "small", "radius": 0.3, "count": 12, "temperature": 1},
                {"name": "large", "radius": 2, "count": 2, "temperature": 1},
            ],
            "dynamics": {"kind": kind},
        }
    )


def _place_tiny_molecules() -> None:
    for obstacles in ([], [_POST]):
        populate(_tiny_molecules(obstacles))


def _part_tiny_molecules() -> None:
    for obstacles in ([], [_POST]):
        scenario = _tiny_molecules(obstacles)
        state, geometry = populate(scenario), scenario.geometry()
        state.position[1] = state.position[0] + 0.01
        state.turn_sites()
        worst_overlap(state, geometry)
        separate(state, geometry)


def _tiny_molecules(obstacles: list[dict[str, Any]]) -> Scenario:
    atoms = [{"position": [k, 0]} for k in range(3)]
    stick = {"name": "stick", "atoms": atoms, "count": 20, "temperature": 1}
    box = {"container": {"width": 40, "height": 40}, "obstacles": obstacles}
    return parse({**box, "molecules": [stick]})


def _push_tiny_molecules() -> None:
    box = {"container": {"width": 20, "height": 20, "periodic": ["x", "y"]}, "dynamics": {"kind": "forced"}}
    pair = {"atoms": [{"position": [0, 0]}, {"position": [1, 0]}], "name": "pair"}
    parts = build(parse({**box, "molecules": [{**pair, "count": 4, "temperature": 1}]}))
    parts.dynamics.contacts = Contacts.empty(8)
    parts.dynamics.advance(parts.state, 0.1)


_EPIDEMIC: Final[dict[str, Any]] = {
    "container": {"width": 20, "height": 20},
    "species": [
        *({"name": name, "radius": 0.1, "count": 9, "speed": 1} for name in ("susceptible", "infectious")),
        *({"name": name, "radius": 0.1} for name in ("recovered", "vaccinated")),
    ],
}


def _infect_tiny() -> None:
    """People who walk, keep apart, visit and infect each other; then discs that collide."""
    course = {"kind": "epidemic", "infectious": {"law": "gamma", "mean": 1}, "vaccination": {"per_day": 1}}
    near = {"transmission": {"by": "closeness", "radius": 4, "probability_per_day": 9}}
    walk = {"distancing": {"strength": 1}, "central": {"visits": 9}}
    for kind, world in (
        ("walk", {**course, **near, **walk}),
        ("stepped", {**course, "transmission": {"by": "contact"}}),
    ):
        parts = build(parse({**_EPIDEMIC, "dynamics": {"kind": kind}, "world": world}))
        assert parts.world is not None
        for reply in parts.world.start(parts.state, parts.geometry):
            if isinstance(reply, SetWalkers) and isinstance(parts.dynamics, Led):
                parts.dynamics.lead(parts.state, reply)
        parts.dynamics.advance(parts.state, 1.0)
        if parts.world.reads_contacts:
            parts.world.read(Contacts.empty(1))
        parts.world.act(parts.state, parts.geometry)


def _part_tiny() -> None:
    scenario = _tiny("stepped")
    state, geometry = populate(scenario), scenario.geometry()
    state.position[1] = state.position[0] + 0.01
    worst_overlap(state, geometry)
    separate(state, geometry)


def _run_tiny(kind: str, enclosed: bool = False, molecules: bool = False) -> None:
    parts = build(_tiny(kind, enclosed, molecules))
    parts.dynamics.contacts = Contacts.empty(8)
    parts.dynamics.advance(parts.state, 2.0)
