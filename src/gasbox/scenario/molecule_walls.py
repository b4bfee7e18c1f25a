"""Rules on walls that molecules of several discs meet under the stepped rule."""

from __future__ import annotations

from collections.abc import Iterator

from gasbox.errors import Problem
from gasbox.scenario.dynamics import Stepped
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import short
from gasbox.scenario.walls import Surface

__all__ = ["molecule_wall_problems"]


def molecule_wall_problems(parts: Parts) -> Iterator[Problem]:
    """Open walls, through which single discs alone can leave."""
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
