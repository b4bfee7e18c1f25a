"""The settings of an epidemic as they are now."""

from __future__ import annotations

from gasbox.errors import UsageError
from gasbox.scenario import Epidemic, Scenario, Walk, lacking, reason_against
from gasbox.state import Memory, SetWorld

__all__ = ["Dials"]


class Dials:
    """Name of a setting -> its present value, and which the scenario can have.

    Parameters
    ----------
    scenario : with an epidemic
    """

    def __init__(self, scenario: Scenario) -> None:
        assert isinstance(scenario.world, Epidemic)
        self._by = scenario.world.transmission.by
        self._walks = isinstance(scenario.dynamics, Walk)
        self._species = frozenset(entry.name for entry in scenario.species)
        self.value = {
            name: value for name, value in scenario.world.values().items() if self._reason(name) is None
        }

    def _reason(self, name: str) -> str | None:
        return reason_against(name, self._by, self._walks, self._species)

    def __getitem__(self, name: str) -> float:
        return self.value[name]

    def get(self, name: str, otherwise: float = 0.0) -> float:
        """A setting, or what stands for one that this scenario does not have."""
        return self.value.get(name, otherwise)

    def take(self, change: SetWorld) -> None:
        """Give a setting another value.

        Raises
        ------
        UsageError
            There is no such setting, or it cannot have this value.
        """
        known = Epidemic.SETTINGS
        if change.name not in known:
            raise UsageError(f"there is no setting {change.name!r}; there are {', '.join(known)}")
        reason = self._reason(change.name) or lacking(change.name, change.value, self._species)
        if reason is not None:
            raise UsageError(f"{change.name}: {reason}")
        try:
            self.value[change.name] = float(known[change.name].check(change.value))
        except ValueError as error:
            raise UsageError(f"{change.name} {error}") from None

    def memory(self) -> Memory:
        """As numbers."""
        return {f"set_{name}": value for name, value in self.value.items()}

    def recall(self, memory: Memory) -> None:
        """Go on from what `memory` gave."""
        for name in self.value:
            self.value[name] = float(memory[f"set_{name}"])
