"""Numbers in real units, where a scenario says what its units are; nothing where it does not."""

from __future__ import annotations

import math
from typing import Final

from gasbox.app.wording import number
from gasbox.scenario import Units

__all__ = ["density", "energy", "pressure", "temperature", "time"]

_PREFIXES: Final = {
    -15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T",
}  # fmt: skip
_AVOGADRO: Final = 6.02214076e23
"""[1/mol], exact since 2019."""


def temperature(units: Units | None, value: float | None) -> str:
    """Of a temperature [energy], in kelvin."""
    return "" if units is None or value is None else f"{number(value * units.temperature)} K"


def pressure(units: Units | None, value: float | None) -> str:
    """Of a pressure [mass/time²], in newton per metre."""
    return "" if units is None or value is None else _prefixed(value * units.pressure, "N/m")


def time(units: Units | None, value: float | None) -> str:
    """Of a time [time], in seconds."""
    return "" if units is None or value is None else _prefixed(value * units.time, "s")


def energy(units: Units | None, value: float | None) -> str:
    """Of the energy of one disc [energy], in kilojoule per mole of them."""
    return (
        "" if units is None or value is None else f"{number(value * units.energy * _AVOGADRO / 1e3)} kJ/mol"
    )


def density(units: Units | None, value: float | None) -> str:
    """Of a number per area [1/length²], per square nanometre."""
    return "" if units is None or value is None else f"{number(value * 1e-18 / units.length**2)}/nm²"


def _prefixed(value: float, unit: str) -> str:
    """With the prefix that leaves one to three digits before the point."""
    if value == 0.0 or not math.isfinite(value):
        return f"{number(value)} {unit}"
    power = 3 * math.floor(math.log10(abs(value) * (1 + 1e-9)) / 3)
    power = min(max(power, min(_PREFIXES)), max(_PREFIXES))
    return f"{number(value / 10.0**power)} {_PREFIXES[power]}{unit}"
