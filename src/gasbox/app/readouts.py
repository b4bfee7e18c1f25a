"""The row of numbers under the box."""

from __future__ import annotations

from nicegui import ui

from gasbox.app import real_units
from gasbox.app.aims import has_forces
from gasbox.app.figures import Figures
from gasbox.app.sample import Sample
from gasbox.app.wording import number, whole
from gasbox.scenario import Scenario
from gasbox.units import UNIT

__all__ = ["Readouts"]


class _Readout:
    """A name, a value, and (where asked for) a line beside it."""

    def __init__(self, name: str, hint: str, *, wide: bool = False, beside: bool = False) -> None:
        with ui.element("div").classes("readout wide" if wide else "readout") as root:
            root.tooltip(hint)
            ui.label(name).classes("name")
            self._value = ui.label("–").classes("value number").mark(name.replace(" ", ""))
            self._beside = ui.label("").classes("beside number") if wide or beside else None

    def show(self, value: str, beside: str = "") -> None:
        """Write the value, and only if it has changed."""
        if self._value.text != value:
            self._value.set_text(value)
        if self._beside is not None and self._beside.text != beside:
            self._beside.set_text(beside)


class Readouts:
    """The numbers: of a gas of hard discs, or of matter with forces."""

    def __init__(self, scenario: Scenario) -> None:
        self._frame = _frame()
        self._numbers = self._fitting(scenario)

    def _fitting(self, scenario: Scenario) -> _HardDiscs | _Matter:
        with self._frame:
            return _Matter() if has_forces(scenario) else _HardDiscs()

    def show(self, figures: Figures, sample: Sample) -> None:
        """Write all numbers."""
        if isinstance(self._numbers, _Matter) != has_forces(sample.scenario):
            self._frame.clear()
            self._numbers = self._fitting(sample.scenario)
        self._numbers.show(figures, sample)


class _Always:
    """Time, number, frames per second."""

    def __init__(self, *, real: bool) -> None:
        self._time = _Readout("time", "simulated time since the start", beside=real)
        self._particles = _Readout("particles", "number of particles in the box")
        self._temperature = _Readout(
            "temperature", f"of the whole gas, k_B = 1 ({UNIT['temperature']})", beside=real
        )
        self._fill()
        self._shown = _Readout("frames / s", "frames that this browser really showed per second")

    def _fill(self) -> None:
        """The numbers between."""
        raise NotImplementedError

    def show(self, figures: Figures, sample: Sample) -> None:
        """Write all numbers."""
        units = sample.scenario.units
        self._time.show(number(figures.time, 4), real_units.time(units, figures.time))
        self._particles.show(whole(figures.particles))
        warmth = figures.temperature
        self._temperature.show(number(warmth), real_units.temperature(units, warmth))
        self._shown.show(f"{sample.shown_fps:.0f}" if sample.playing else "–")


class _HardDiscs(_Always):
    """And energy, pressure with what theory expects, collisions."""

    def __init__(self) -> None:
        super().__init__(real=False)

    def _fill(self) -> None:
        self._energy = _Readout("energy", f"kinetic energy of all particles ({UNIT['energy']})")
        self._pressure = _Readout(
            "pressure",
            f"measured over ten seconds ({UNIT['pressure']}), and what theory expects of points and of discs",
            wide=True,
        )
        self._rate = _Readout(
            "collisions / time",
            "pairs that collided per unit of simulated time, over the last ten seconds",
        )

    def show(self, figures: Figures, sample: Sample) -> None:
        """Write all numbers."""
        super().show(figures, sample)
        # Of molecules there is no theory of their own size.
        discs = "" if sample.scenario.molecules else f" · discs {number(figures.pressure_discs)}"
        self._pressure.show(
            number(figures.pressure),
            f"ideal {number(figures.pressure_ideal)}{discs}",
        )
        self._energy.show(number(figures.energy, 4))
        self._rate.show(number(figures.collision_rate))


class _Matter(_Always):
    """And the energies of a disc, pressure, density; below them in real units, where the scenario has any."""

    def __init__(self) -> None:
        super().__init__(real=True)

    def _fill(self) -> None:
        self._kinetic = _Readout(
            "kinetic", f"mean kinetic energy of a particle ({UNIT['energy']})", beside=True
        )
        self._potential = _Readout(
            "potential",
            f"potential energy of all forces, for each particle ({UNIT['energy']})",
            beside=True,
        )
        self._pressure = _Readout(
            "pressure", f"measured over ten seconds ({UNIT['pressure']}), and of an ideal gas", beside=True
        )
        self._density = _Readout("density", f"particles per area (1/{UNIT['area']})", beside=True)

    def show(self, figures: Figures, sample: Sample) -> None:
        """Write all numbers."""
        super().show(figures, sample)
        units = sample.scenario.units
        count = max(figures.particles, 1)
        kinetic, potential = figures.energy / count, figures.potential / count
        self._kinetic.show(number(kinetic), real_units.energy(units, kinetic))
        self._potential.show(number(potential), real_units.energy(units, potential))
        ideal = f"ideal {number(figures.pressure_ideal)}"
        self._pressure.show(
            number(figures.pressure), real_units.pressure(units, figures.pressure) if units else ideal
        )
        self._density.show(number(figures.density), real_units.density(units, figures.density))


def _frame() -> ui.element:
    """The card that holds all numbers."""
    with ui.element("section").classes("card readings").props('aria-label="Measured numbers"'):
        return ui.element("div").classes("readouts")
