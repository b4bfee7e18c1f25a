"""A kinetic-gas laboratory: watch a two-dimensional gas live, and measure it exactly.

>>> import gasbox
>>> simulation = gasbox.Simulation(gasbox.load("two-discs"))
>>> simulation.advance(frames=1)
>>> simulation.state.velocity.tolist()
[[0.0, -0.1], [0.0, 0.1]]
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gasbox.errors import DynamicsError, FileError, GasboxError, ScenarioError, UsageError
from gasbox.version import __version__

if TYPE_CHECKING:
    from gasbox.scenario import Scenario
    from gasbox.scenario.reading import load, shipped
    from gasbox.simulation import Simulation, run

__all__ = [
    "DynamicsError",
    "FileError",
    "GasboxError",
    "Scenario",
    "ScenarioError",
    "Simulation",
    "UsageError",
    "__version__",
    "load",
    "run",
    "shipped",
]

_HOME = {
    "Scenario": "scenario",
    "load": "scenario",
    "shipped": "scenario",
    "Simulation": "simulation",
    "run": "simulation",
}


def __getattr__(name: str) -> Any:
    """Import the engines only when they are asked for: `gasbox --help` should not wait for a compiler."""
    if name in _HOME:
        import importlib

        value = getattr(importlib.import_module(f"gasbox.{_HOME[name]}"), name)
        globals()[name] = value
        return value
    raise AttributeError(f"module 'gasbox' has no attribute {name!r}")
