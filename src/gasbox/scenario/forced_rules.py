"""Rules on dynamics `forced`: what belongs to it alone, and what it has no answer to."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.dynamics import Forced
from gasbox.scenario.forces import Forces
from gasbox.scenario.kinds import anatomy, site_kinds_of
from gasbox.scenario.mixing import laws_of
from gasbox.scenario.motions import PistonMotion
from gasbox.scenario.obstacles import Obstacle
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import near, short
from gasbox.scenario.walls import WallSettings

__all__ = ["forced_problems"]

_HARD: Final = 'forces.walls "reflecting"'
_NO_MOLECULES: Final = "not available for molecules under forces"
_FOR_DISCS: Final = (
    ("open", "an open wall"),
    ("passes", "a wall that discs pass"),
    ("motion", "a wall that moves"),
)
_LATER_FOR_DISCS: Final = (
    ("displacement", "a wall that moves"),
    ("present", "a wall that comes or goes"),
)

_ITS_OWN: Final = ("forces", "thermostat", "barostat", "heating")
_SCHEDULED: Final = _ITS_OWN[1:]
_OF_LAWS: Final = {"reach": "square-well", "screening_length": "yukawa"}
"""Keys that one law alone knows."""
_SKIN: Final = 0.3
"""How much farther than the cutoff, in units of sigma, engines look for neighbours."""
_MOST_IMAGES: Final = 3
"""Of a periodic box, on each side."""


def forced_problems(parts: Parts) -> Iterator[Problem]:
    """All that is wrong with forces, and with what else dynamics `forced` is asked for."""
    if parts.dynamics is not None and not isinstance(parts.dynamics, Forced):
        yield from _homeless(parts, parts.dynamics.kind)
        return
    if parts.forces is not None:
        yield from _pairs(parts, parts.forces)
        yield from _keys_of_laws(parts.forces)
    if parts.dynamics is None:
        return
    yield from _charges(parts)
    yield from _walls(parts)
    yield from _thermostat(parts)
    yield from _barostat(parts)
    yield from _images(parts)


def _homeless(parts: Parts, kind: str) -> Iterator[Problem]:
    """What only forces know, under another rule of motion."""
    found = f"dynamics of kind {short(kind)}"
    for key in _ITS_OWN:
        if getattr(parts, key) is not None:
            yield Problem(key, found, f'{key} needs dynamics kind "forced"')
    for number, entry in enumerate(parts.schedule):
        for key in _SCHEDULED:
            if entry is not None and getattr(entry, key) is not None:
                yield Problem(f"schedule[{number}].{key}", found, f'{key} needs dynamics kind "forced"')


def _pairs(parts: Parts, forces: Forces) -> Iterator[Problem]:
    """Names that do not exist, and pairs that are there twice."""
    first: dict[frozenset[str], int] = {}
    names = [entry.name for entry in parts.species if entry is not None]
    for number, pair in enumerate(forces.pairs):
        path = f"forces.pairs[{number}].between"
        for name in dict.fromkeys(pair.between):
            if all(parts.species) and name not in names:
                known = ", ".join(map(short, dict.fromkeys(names)))
                yield Problem(path, short(name), f"must be one of {known}{near(name, names)}")
        both = frozenset(pair.between)
        if both in first:
            allowed = f"each pair only once; forces.pairs[{first[both]}] has it already"
            yield Problem(path, short(list(pair.between)), allowed)
        first.setdefault(both, number)


def _keys_of_laws(forces: Forces) -> Iterator[Problem]:
    """Keys that mean nothing to the laws in use."""
    every = {forces.law, *(pair.law or forces.law for pair in forces.pairs)}
    said = [("forces", forces, every)]
    sections = [(f"forces.pairs[{n}]", pair, {pair.law or forces.law}) for n, pair in enumerate(forces.pairs)]
    for path, section, laws in [*said, *sections]:
        for key, law in _OF_LAWS.items():
            value = getattr(section, key)
            if value is not None and law not in laws:
                yield Problem(f"{path}.{key}", f"{value:g}", f"goes with the law {short(law)} only")


def _charges(parts: Parts) -> Iterator[Problem]:
    if parts.forces is not None and parts.forces.charges is not None:
        return
    for number, entry in enumerate(parts.species):
        if entry is not None and entry.charge:
            allowed = "a charge acts only where a section forces.charges says how"
            yield Problem(f"species[{number}].charge", f"{entry.charge:g}", allowed)


def _walls(parts: Parts) -> Iterator[Problem]:
    """Walls that are more than walls, now or later."""
    surfaces: list[tuple[str, WallSettings | Obstacle | None]] = [
        (f"walls.{short(side, bare=True)}", settings) for side, settings in parts.walls.items()
    ]
    surfaces += [(f"obstacles[{number}]", obstacle) for number, obstacle in enumerate(parts.obstacles)]
    smooth = parts.forces is not None and parts.forces.walls == "repulsive"
    large = any(entry is not None and len(anatomy(entry)[0]) > 1 for entry in parts.molecules)
    for path, surface in surfaces:
        if surface is None:
            continue
        if isinstance(surface.motion, PistonMotion):
            allowed = "not available under forces: another kind of motion"
            yield Problem(f"{path}.motion", "a wall that moves freely", allowed)
        for key, found in (("open", "an open wall"), ("passes", "a wall that discs pass")):
            if getattr(surface, key) and smooth:
                yield Problem(f"{path}.{key}", f"{found} that pushes back smoothly", _HARD)
        if smooth and surface.temperature is not None:
            yield Problem(f"{path}.temperature", "a warm wall that pushes back smoothly", _HARD)
        for key, found in _FOR_DISCS:
            if large and getattr(surface, key):
                yield Problem(f"{path}.{key}", found, _NO_MOLECULES)
    for number, entry in enumerate(parts.schedule):
        if entry is None:
            continue
        path = f"schedule[{number}]"
        if entry.free is not None:
            yield Problem(f"{path}.free", "a wall that moves freely", "not available under forces")
        if entry.present is not None and smooth:
            yield Problem(f"{path}.present", "a wall that comes or goes and pushes back smoothly", _HARD)
        for key, found in _LATER_FOR_DISCS:
            if large and getattr(entry, key) is not None:
                yield Problem(f"{path}.{key}", found, _NO_MOLECULES)


def _thermostat(parts: Parts) -> Iterator[Problem]:
    """A thermostat that is to keep the temperature of the start, where nothing moves."""
    if parts.thermostat is None or parts.thermostat.temperature is not None or parts.names is None:
        return
    counted = [entry for entry in parts.kinds() if entry.count]
    warm = any(entry.temperature is not None or entry.speed or entry.velocities for entry in counted)
    if not warm and parts.particles is None:
        allowed = "is required: nothing starts with a temperature that it could keep"
        yield Problem("thermostat.temperature", "nothing", allowed)


def _barostat(parts: Parts) -> Iterator[Problem]:
    """A barostat, now or later, in a container that cannot be rescaled."""
    paths = ["barostat"] if parts.barostat is not None else []
    paths += [
        f"schedule[{number}].barostat"
        for number, entry in enumerate(parts.schedule)
        if entry is not None and entry.barostat not in (None, "off")
    ]
    if parts.container is None:
        return
    shape = parts.container.geometry()
    found = None
    if not isinstance(shape, Rectangle):
        found = f"a container of shape {parts.container.shape}"
    elif not shape.periodic.all():
        found = "a container with walls"
    elif parts.obstacles:
        found = "obstacles"
    for path in paths if found else []:
        yield Problem(path, found or "", "needs a rectangle that is periodic in x and y, with nothing in it")


def _images(parts: Parts) -> Iterator[Problem]:
    """Forces that reach more than a few times round a periodic box."""
    shape = parts.container.geometry() if parts.container is not None else None
    if not isinstance(shape, Rectangle) or parts.names is None:
        return
    species = site_kinds_of(
        [entry for entry in parts.species if entry], [entry for entry in parts.molecules if entry]
    )
    forces = parts.forces or Forces()
    laws = laws_of(species, forces).values()
    farthest = max((law.cutoff + _SKIN * law.sigma for law in laws if law.cutoff), default=0.0)
    if forces.charges is not None:
        farthest = max(
            farthest, forces.charges.cutoff + _SKIN * max((law.sigma for law in laws), default=0.0)
        )
    for side, length, periodic in (
        ("width", shape.width, shape.periodic_x),
        ("height", shape.height, shape.periodic_y),
    ):
        if periodic and farthest > _MOST_IMAGES * length:
            allowed = f"at least {farthest / _MOST_IMAGES:.4g}: forces reach {farthest:.4g} far, "
            allowed += f"and may go round a periodic box {_MOST_IMAGES} times"
            yield Problem(f"container.{side}", f"{length:g}", allowed)
