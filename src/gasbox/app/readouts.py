"""The row of numbers under the box."""

from __future__ import annotations

from nicegui import ui

from gasbox.app.figures import Figures
from gasbox.app.sample import Sample
from gasbox.app.wording import number, whole
from gasbox.units import UNIT

__all__ = ["Readouts"]


class _Readout:
    """A name, a value, and (where asked for) a line beside it."""

    def __init__(self, name: str, hint: str, *, wide: bool = False) -> None:
        with ui.element("div").classes("readout wide" if wide else "readout") as root:
            root.tooltip(hint)
            ui.label(name).classes("name")
            self._value = ui.label("–").classes("value number").mark(name.replace(" ", ""))
            self._beside = ui.label("").classes("beside number") if wide else None

    def show(self, value: str, beside: str = "") -> None:
        """Write the value, and only if it has changed."""
        if self._value.text != value:
            self._value.set_text(value)
        if self._beside is not None and self._beside.text != beside:
            self._beside.set_text(beside)


class Readouts:
    """Time, number, temperature, pressure, energy, collisions and frames per second."""

    def __init__(self) -> None:
        with _frame():
            self._time = _Readout("time", "simulated time since the start")
            self._particles = _Readout("particles", "number of particles in the box")
            self._temperature = _Readout("temperature", f"of the whole gas, k_B = 1 ({UNIT['temperature']})")
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
            self._shown = _Readout("frames / s", "frames that this browser really showed per second")

    def show(self, figures: Figures, sample: Sample) -> None:
        """Write all numbers."""
        self._time.show(number(figures.time, 4))
        self._particles.show(whole(figures.particles))
        self._temperature.show(number(figures.temperature))
        self._pressure.show(
            number(figures.pressure),
            f"ideal {number(figures.pressure_ideal)} · discs {number(figures.pressure_discs)}",
        )
        self._energy.show(number(figures.energy, 4))
        self._rate.show(number(figures.collision_rate))
        self._shown.show(f"{sample.shown_fps:.0f}" if sample.playing else "–")


def _frame() -> ui.element:
    """The card that holds all numbers."""
    with ui.element("section").classes("card readings").props('aria-label="Measured numbers"'):
        return ui.element("div").classes("readouts")
