"""Flat models of well-known molecules.

Bond lengths and angles are the experimental ones of the gas (CRC Handbook of Chemistry and Physics), radii those of
van der Waals (Bondi 1964; hydrogen: Rowland and Taylor 1996), masses the standard atomic weights. Charges of water are
those of the SPC model (Berendsen et al. 1981). Methane is a cross of four hydrogens in the plane.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from gasbox.scenario.molecules import Atom, Bond

__all__ = ["MODELS", "model_atoms"]


class _Element(NamedTuple):
    mass: float
    radius: float
    color: str


_ELEMENTS: Final = {
    "H": _Element(1.008, 1.10, "#8a96a1"),
    "C": _Element(12.011, 1.70, "#686764"),
    "N": _Element(14.007, 1.55, "#4c7be8"),
    "O": _Element(15.999, 1.52, "#e2504a"),
}

_Part = tuple[str, float, float, float]
"""Element, x and y [ångström], and charge [of the electron]."""


def _water() -> tuple[_Part, ...]:
    half = math.radians(104.51 / 2)
    x, y = 0.9575 * math.sin(half), 0.9575 * math.cos(half)
    return ("O", 0.0, 0.0, -0.82), ("H", -x, -y, 0.41), ("H", x, -y, 0.41)


def _pair(element: str, length: float) -> tuple[_Part, ...]:
    return (element, -length / 2, 0.0, 0.0), (element, length / 2, 0.0, 0.0)


MODELS: Final[dict[str, tuple[_Part, ...]]] = {
    "hydrogen": _pair("H", 0.7414),
    "nitrogen": _pair("N", 1.0977),
    "oxygen": _pair("O", 1.2075),
    "water": _water(),
    "carbon-dioxide": (("C", 0.0, 0.0, 0.0), ("O", -1.1600, 0.0, 0.0), ("O", 1.1600, 0.0, 0.0)),
    "methane": (
        ("C", 0.0, 0.0, 0.0),
        ("H", 1.0870, 0.0, 0.0),
        ("H", 0.0, 1.0870, 0.0),
        ("H", -1.0870, 0.0, 0.0),
        ("H", 0.0, -1.0870, 0.0),
    ),
}
"""Name -> its atoms; in those of more than two the first is bonded to all others."""


def model_atoms(model: str, scale: float) -> tuple[tuple[Atom, ...], tuple[Bond, ...]]:
    """Atoms and bonds of a model, lengths in ångström times `scale`."""
    atoms = []
    for element, x, y, charge in MODELS[model]:
        mass, radius, color = _ELEMENTS[element]
        atoms.append(
            Atom(
                position=(scale * x, scale * y),
                mass=mass,
                radius=scale * radius,
                color=color,
                charge=charge or None,
            )
        )
    return tuple(atoms), tuple(Bond(atoms=(0, other)) for other in range(1, len(atoms)))
