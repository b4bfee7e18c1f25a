"""Takes data that are no scenario apart, into what is valid by itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final, TypeVar, cast

from pydantic import ValidationError

from gasbox.scenario.baths import Barostat, Heating, Langevin, VelocityRescaling
from gasbox.scenario.container import SHAPES
from gasbox.scenario.dynamics import KINDS, EventDriven
from gasbox.scenario.forces import Forces
from gasbox.scenario.histograms import Histograms
from gasbox.scenario.molecules import Molecule
from gasbox.scenario.obstacles import STANDING
from gasbox.scenario.particles import Particles
from gasbox.scenario.parts import Parts
from gasbox.scenario.schedule import ScheduledChange
from gasbox.scenario.snapshot import Snapshot
from gasbox.scenario.species import Species
from gasbox.scenario.values import GREATEST, LEAST, Section
from gasbox.scenario.walls import WallSettings
from gasbox.scenario.world import WORLDS

__all__ = ["valid_parts"]

_Section = TypeVar("_Section", bound=Section)
_THERMOSTATS: Final[dict[str, type[Langevin] | type[VelocityRescaling]]] = {
    "langevin": Langevin,
    "velocity-rescaling": VelocityRescaling,
}


def valid_parts(data: Mapping[str, Any], particles: Particles | None) -> Parts:
    """What is valid by itself, so that the rules between fields can be tried beside other problems."""
    interval = data.get("frame_interval")
    dynamics = data.get("dynamics")
    return Parts(
        _of_kind("shape", SHAPES, data.get("container"), "rectangle"),
        tuple(_one(Species, entry) for entry in _list(data.get("species"))),
        particles,
        EventDriven() if dynamics is None else _of_kind("kind", KINDS, dynamics),
        interval if isinstance(interval, float | int) and LEAST <= interval <= GREATEST else None,
        _one(Histograms, data.get("histograms", {})),
        _one(Snapshot, data.get("snapshot")),
        {str(name): _one(WallSettings, entry) for name, entry in _object(data.get("walls")).items()},
        tuple(_of_kind("shape", STANDING, entry) for entry in _list(data.get("obstacles"))),
        _gravity(data.get("gravity", (0.0, 0.0))),
        tuple(_one(ScheduledChange, entry) for entry in _list(data.get("schedule"))),
        _one(Forces, data.get("forces")),
        _of_kind("kind", _THERMOSTATS, data.get("thermostat")),
        _one(Barostat, data.get("barostat")),
        _one(Heating, data.get("heating")),
        tuple(_one(Molecule, entry) for entry in _list(data.get("molecules"))),
        _of_kind("kind", WORLDS, data.get("world")),
    )


def _of_kind(
    key: str, kinds: Mapping[str, type[_Section]], data: Any, usual: str | None = None
) -> _Section | None:
    """A section of which `key` says the class."""
    if type(data) in kinds.values():
        return cast("_Section", data)
    kind = data.get(key, usual) if isinstance(data, dict) else None
    return _one(kinds[kind], data) if isinstance(kind, str) and kind in kinds else None


def _list(data: Any) -> Sequence[Any]:
    return data if isinstance(data, list | tuple) else ()


def _object(data: Any) -> Mapping[Any, Any]:
    return data if isinstance(data, dict) else {}


def _gravity(data: Any) -> tuple[float, float] | None:
    change = _one(ScheduledChange, {"at": 0, "gravity": data})
    return None if change is None else change.gravity


def _one(section: type[_Section], data: Any) -> _Section | None:
    try:
        return section.model_validate(data)
    except ValidationError:
        return None
