"""Rules on walls that molecules of several discs meet: which of these know what to do with them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from gasbox.errors import Problem
from gasbox.scenario.dynamics import Stepped
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import short
from gasbox.scenario.walls import Passes, Surface

__all__ = ["molecule_wall_problems"]

_GATE: Final = (
    "a gate under the stepped rule judges single discs: let the molecules not pass, or all speeds both ways"
)


def molecule_wall_problems(parts: Parts) -> Iterator[Problem]:
    """Walls that judge a disc by its way and would have to judge each disc of a molecule."""
    large = [kind.name for kind in parts.kinds() if len(kind.sites) > 1]
    if not large or not isinstance(parts.dynamics, Stepped):
        return
    surfaces: list[tuple[str, Surface | None]] = [
        *((f"walls.{short(side, bare=True)}", settings) for side, settings in parts.walls.items()),
        *((f"obstacles[{number}]", obstacle) for number, obstacle in enumerate(parts.obstacles)),
    ]
    for path, surface in surfaces:
        if surface is not None and surface.open:
            allowed = "an open wall under the stepped rule lets single discs leave, but no molecules"
            yield Problem(f"{path}.open", f"molecules of several discs ({short(large[0])})", allowed)
        passes = None if surface is None else surface.passes
        if passes is None or not _judges(passes):
            continue
        for name in large:
            if passes.species is None or name in passes.species:
                yield Problem(f"{path}.passes", f"a gate for {short(name)}", _GATE)


def _judges(passes: Passes) -> bool:
    """Whether it depends on its way whether a disc passes."""
    return passes.direction != "both" or passes.least_speed > 0.0 or passes.greatest_speed is not None
