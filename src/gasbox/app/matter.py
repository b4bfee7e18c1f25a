"""The row under the box for matter with forces: temperature, heat and pressure."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from nicegui import ui

from gasbox.app import real_units
from gasbox.app.aim_control import AimControl, Kind
from gasbox.app.aims import Aim, Aims, aims_of, can_have_barostat, has_forces, power_unit
from gasbox.app.figures import Figures
from gasbox.app.heat_control import HeatControl
from gasbox.app.sample import Sample
from gasbox.state import Change, SetBarostat, SetHeating, SetThermostat

__all__ = ["Matter"]

_TEMPERATURE: Final = Kind("temperature", "thermostat", "thermostat", "T", "energy")
_PRESSURE: Final = Kind("pressure", "barostat", "compress", "p", "mass/time²")


class Matter:
    """Live controls, for gases with forces alone.

    Parameters
    ----------
    send : takes each change
    """

    def __init__(self, send: Callable[[Change], None]) -> None:
        self._version = -1
        with ui.element("section").classes("card matter") as self._root:
            self._root.props('aria-label="Temperature, heat and pressure"').mark("matter")
            self.temperature = AimControl(_TEMPERATURE, lambda goal, over: send(SetThermostat(goal, over)))
            self.heat = HeatControl(lambda power: send(SetHeating(power)))
            self.pressure = AimControl(_PRESSURE, lambda goal, over: send(SetBarostat(goal, over)))
        self._root.set_visibility(False)

    @property
    def visible(self) -> bool:
        """Whether the row is shown."""
        return bool(self._root.visible)

    def show(self, sample: Sample, figures: Figures) -> None:
        """Show what the gas is held at; nothing at all if it knows no forces."""
        forced = has_forces(sample.scenario)
        if forced != self.visible:
            self._root.set_visibility(forced)
        if not forced:
            return
        aims = aims_of(sample.scenario, sample.changes)
        if sample.version != self._version:
            self._begin(sample, aims, figures)
        self.temperature.show(aims.temperature, sample.time, figures.temperature)
        self.pressure.show(aims.pressure, sample.time, figures.pressure)
        self.heat.show(aims.power)

    def _begin(self, sample: Sample, aims: Aims, figures: Figures) -> None:
        self._version = sample.version
        units = sample.scenario.units
        self.temperature.begin(
            _goal(aims.temperature) or figures.temperature, lambda value: real_units.temperature(units, value)
        )
        self.pressure.begin(
            _goal(aims.pressure) or figures.pressure_ideal, lambda value: real_units.pressure(units, value)
        )
        self.pressure.root.set_visibility(can_have_barostat(sample.scenario, sample.geometry))
        self.heat.begin(power_unit(sample))

    def hold(self, name: str) -> None:
        """Heat or cool while something is held down."""
        if self.visible:
            self.heat.hold(name)


def _goal(aim: Aim | None) -> float | None:
    return None if aim is None else aim.goal
