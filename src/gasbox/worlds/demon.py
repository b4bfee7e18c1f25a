"""Maxwell's demon: it decides who passes a gate, and keeps the books of the gas and of its own memory."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, get_args

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import UsageError
from gasbox.geometry import Geometry
from gasbox.scenario import Demon, Scenario
from gasbox.scenario.demon import DemonRule
from gasbox.state import Contacts, Memory, Reply, SetGate, SetWorld, State, Way
from gasbox.theory.demon import BIT, landauer_heat, record_information, work_stored
from gasbox.worlds.gate_record import GateRecord
from gasbox.worlds.gate_sides import Census, GateSides

__all__ = ["MaxwellsDemon"]

_RULES: Final = get_args(DemonRule)
_DECIDING: Final = ("speed", "species", "direction")
"""Rules that look at a disc; with the others nothing is decided, and nothing written."""
_KEPT: Final = 4096
"""Rows of the series; if there are more, every second one is forgotten."""


@dataclass(frozen=True)
class _Orders:
    """What the demon goes by."""

    rule: str
    threshold: float
    species: int
    reversed: bool

    def ways(self, kinds: int) -> tuple[Way | None, Way | None]:
        """Who passes to the right, and to the left."""
        others = tuple(kind for kind in range(kinds) if kind != self.species)
        right, left = {
            "speed": (Way(least_speed=self.threshold), Way(greatest_speed=self.threshold)),
            "species": (Way((self.species,)), Way(others)),
            "direction": (Way(), None),
            "none": (Way(), Way()),
            "closed": (None, None),
        }[self.rule]
        return (left, right) if self.reversed else (right, left)

    def numbers(self) -> list[float]:
        return [_RULES.index(self.rule), self.threshold, self.species, self.reversed]

    @classmethod
    def of(cls, numbers: Sequence[float]) -> _Orders:
        return cls(_RULES[int(numbers[0])], float(numbers[1]), int(numbers[2]), bool(numbers[3]))


class MaxwellsDemon:
    """A demon at the gate that its scenario names.

    Parameters
    ----------
    scenario : with a world of this kind

    Attributes
    ----------
    sides : of the gate
    record : of all that came to it
    """

    reads_contacts = True

    def __init__(self, scenario: Scenario) -> None:
        settings = scenario.world
        assert isinstance(settings, Demon)
        self.interval = settings.interval
        self._kinds = [kind.name for kind in scenario.kinds]
        radii = np.array([kind.radius for kind in scenario.kinds], np.float64)
        self.sides = GateSides(scenario.geometry(), settings.gate, radii)
        self.record = GateRecord(self.sides.wall, self.sides.normal)
        self._gate = settings.gate
        self._own_threshold = settings.threshold
        species = 0 if settings.species is None else self._kinds.index(settings.species)
        self._orders = _Orders(settings.rule, settings.threshold or 1.0, species, settings.reversed)
        self._in_force = self._orders
        self._start_entropy = 0.0
        self._census: Census | None = None
        self._rows: list[tuple[float, ...]] = []
        self._turns, self._stride = 0, 1

    # -- as every world --------------------------------------------------------------------------------

    def start(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """See `gasbox.protocols.World`."""
        speed = np.sqrt(np.sum(state.velocity**2, axis=1))
        if self._own_threshold is None and speed.any():
            self._orders = replace(self._orders, threshold=float(np.median(speed)) or float(speed.mean()))
        self._look(state, geometry)
        self._start_entropy = self._now.entropy
        self._note(state.time)
        return [self._ask()]

    def read(self, contacts: Contacts) -> None:
        """See `gasbox.protocols.World`."""
        self.record.read(contacts, self._in_force.rule in _DECIDING)

    def act(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """See `gasbox.protocols.World`."""
        self._look(state, geometry)
        self._note(state.time)
        return [self._ask()] if self._orders != self._in_force else []

    def take(self, change: SetWorld) -> None:
        """See `gasbox.protocols.World`."""
        if change.name not in Demon.SETTINGS:
            known = ", ".join(Demon.SETTINGS)
            raise UsageError(f"a demon has no setting {change.name!r}; it has {known}")
        try:
            value: Any = Demon.SETTINGS[change.name].check(change.value)
        except ValueError as error:
            raise UsageError(f"{change.name} of a demon {error}") from None
        if change.name == "species":
            if value not in self._kinds:
                raise UsageError(f"there is no species {value!r}; there are {', '.join(self._kinds)}")
            value = self._kinds.index(value)
        self._orders = replace(self._orders, **{change.name: value})

    def memory(self) -> Memory:
        """See `gasbox.protocols.World`."""
        record = self.record
        return {
            "orders": np.array([self._orders.numbers(), self._in_force.numbers()], np.float64),
            "met": np.array([record.passed, record.refused], np.int64),
            "decided": np.array([record.decisions, record.let], np.int64),
            "start_entropy": self._start_entropy,
        }

    def recall(self, memory: Memory) -> None:
        """See `gasbox.protocols.World`."""
        wanted, in_force = np.asarray(memory["orders"], np.float64).tolist()
        self._orders, self._in_force = _Orders.of(wanted), _Orders.of(in_force)
        self.record.passed, self.record.refused = np.array(memory["met"], np.int64)
        self.record.decisions, self.record.let = np.asarray(memory["decided"], np.int64).tolist()
        self._start_entropy = float(memory["start_entropy"])

    def summary(self) -> dict[str, Any]:
        """See `gasbox.protocols.World`."""
        return {**self._settings(), **self._books()}

    def series(self) -> dict[str, NDArray[np.float64]]:
        """Rows since this run began, see `gasbox.protocols.World`.

        ``temperature_`` [energy] and ``count_`` of each side, ``entropy`` of the gas since the start, ``bits`` and
        ``information`` written, ``balance`` of the first two, all [k_B] but the bits.
        """
        left, right = self.sides.names
        names = (
            "time",
            f"count_{left}",
            f"count_{right}",
            f"temperature_{left}",
            f"temperature_{right}",
            "entropy",
            "decisions",
            "information",
            "written",
            "balance",
        )
        columns = np.array(self._rows, np.float64).reshape(-1, len(names)).T
        return dict(zip(names, columns, strict=True))

    def view(self) -> dict[str, Any]:
        """See `gasbox.protocols.World`."""
        return {
            "wall": self.sides.wall,
            "line": [list(end) for end in self.sides.ends],
            "sides": list(self.sides.names),
            **self._settings(),
            **self._books(),
        }

    # -- inside ----------------------------------------------------------------------------------------

    @property
    def _now(self) -> Census:
        assert self._census is not None
        return self._census

    def _entropy_of_gas(self) -> float:
        """Since the start [k_B]; not a number if a side was or is at rest."""
        entropy = self._now.entropy - self._start_entropy
        return entropy if math.isfinite(entropy) else math.nan

    def _look(self, state: State, geometry: Geometry) -> None:
        self._census = self.sides.census(state, geometry)

    def _ask(self) -> SetGate:
        """The gate as the orders want it."""
        self._in_force = self._orders
        ways = self._orders.ways(len(self._kinds))
        return SetGate(self._gate, *(ways[::-1] if self.sides.turned else ways))

    def _note(self, time: float) -> None:
        """Keep a row of the series."""
        self._turns += 1
        if (self._turns - 1) % self._stride:
            return
        now, record = self._now, self.record
        entropy = self._entropy_of_gas()
        written = BIT * record.decisions
        self._rows.append(
            (
                time,
                *now.total.tolist(),
                *now.temperature.tolist(),
                entropy,
                float(record.decisions),
                record_information(record.decisions, record.let),
                written,
                entropy + written,
            )
        )
        if len(self._rows) > _KEPT:
            self._rows = self._rows[::2]
            self._stride *= 2

    def _settings(self) -> dict[str, Any]:
        orders = self._orders
        return {
            "rule": orders.rule,
            "threshold": orders.threshold,
            "species": self._kinds[orders.species] if self._kinds else None,
            "reversed": orders.reversed,
        }

    def _books(self) -> dict[str, Any]:
        """All that was counted; what belongs to a side stands under its name."""
        record, now = self.record, self._census
        found: dict[str, Any] = {
            "decisions": record.decisions,
            "information": record_information(record.decisions, record.let),
            "information_written": BIT * record.decisions,
        }
        for side, name in enumerate(self.sides.names):
            found[f"from_{name}"] = {
                "passed": int(record.passed[side]),
                "refused": int(record.refused[side]),
            }
        if now is None:
            return found
        entropy = self._entropy_of_gas()
        warm = now.mean_temperature
        known = math.isfinite(entropy)
        found |= {
            "entropy_of_gas": entropy if known else None,
            "entropy_with_memory": entropy + BIT * record.decisions if known else None,
            "heat_of_forgetting": landauer_heat(record.decisions, warm),
            "work_stored": work_stored(entropy, warm) if known else None,
        }
        for side, name in enumerate(self.sides.names):
            found[name] = {
                "discs": int(now.total[side]),
                "temperature": float(now.temperature[side]),
                "pressure": float(now.pressure[side]),
            }
        return found
