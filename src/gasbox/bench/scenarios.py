"""The gases that rates are measured on, as scenarios. In a frame, a disc (a small one) moves about its radius."""

from __future__ import annotations

import math
from typing import Any

from gasbox.scenario import Scenario, parse

__all__ = ["ENCLOSURES", "crowd", "dumbbells", "enclosed", "exact_gas", "fluid", "mixture", "stepped_gas"]

_SEED = 12
_DUMBBELLS = 0.25
"""Soft dumbbells for each square of side 1."""

ENCLOSURES = ("rectangle", "100-sided polygon", "circle", "gravity", "piston")
"""What `enclosed` knows: shapes of one area with walls at rest; a rectangle under gravity; one with a free piston."""


def exact_gas(particles: int, area_fraction: float) -> Scenario:
    """Equal discs of diameter, mass and temperature 1 in a periodic square, event-driven."""
    return _exact([_discs("discs", 0.5, particles)], area_fraction)


def mixture(particles: int, size_ratio: float, area_fraction: float) -> Scenario:
    """As `exact_gas`, and large discs of the same material and the same area in all, `size_ratio` times as wide."""
    large = max(1, round(particles / size_ratio**2))
    species = [_discs("small", 0.5, particles), _discs("large", 0.5 * size_ratio, large)]
    return _exact(species, area_fraction)


def stepped_gas(particles: int, area_fraction: float = 0.2, speed: float = 0.1) -> Scenario:
    """Equal discs of radius and mass 1 between walls; each moves `speed` [length] in a step on average."""
    side = math.sqrt(particles * math.pi / area_fraction)
    return parse(
        {
            "seed": _SEED,
            "container": {"shape": "rectangle", "width": side, "height": side},
            # The rms speed is sqrt(2 T/m).
            "species": [{"name": "discs", "radius": 1, "count": particles, "temperature": speed**2 / 2}],
            "dynamics": {"kind": "stepped", "time_step": 1},
            "frame_interval": round(1 / speed),
        }
    )


def crowd(people: int) -> Scenario:
    """People who walk between walls; a tenth are infectious and remain so, three others are near each of them.

    Hardly anybody is infected, so that there is as much to do in each step.
    """
    side, ill = 2.0 * math.sqrt(people), people // 10
    return parse(
        {
            "seed": _SEED,
            "container": {"shape": "rectangle", "width": side, "height": side},
            "species": [
                {"name": "susceptible", "radius": 0.1, "count": people - ill},
                {"name": "infectious", "radius": 0.1, "count": ill},
                {"name": "recovered", "radius": 0.1},
            ],
            "dynamics": {"kind": "walk", "time_step": 1, "speed": 0.2, "turning": 0.05},
            "world": {
                "kind": "epidemic",
                "day": 20,
                "transmission": {"by": "closeness", "radius": 2, "probability_per_day": 1e-6},
                "infectious": {"law": "exponential", "mean": 1e6},
            },
        }
    )


def fluid(particles: int, thermostat: bool = False) -> Scenario:
    """Lennard-Jones at density 0.7 and temperature 1 in a periodic square, cut off at 2.5, in units of the law.

    With a thermostat it is there to be melted (`gasbox.bench.gases.melted`), without to be measured.
    """
    side = math.sqrt(particles / 0.7)
    bath: dict[str, Any] = {"thermostat": {"kind": "velocity-rescaling", "temperature": 1, "time": 0.2}}
    return parse(
        {
            "seed": _SEED,
            "container": {"shape": "rectangle", "width": side, "height": side, "periodic": ["x", "y"]},
            "species": [{"name": "atoms", "radius": 0.5, "count": particles, "temperature": 1}],
            "dynamics": {"kind": "forced", "time_step": 0.005},
            "forces": {"law": "lennard-jones", "cutoff": 2.5, "truncation": "shifted"},
            "frame_interval": 0.05,
            **(bath if thermostat else {}),
        }
    )


def dumbbells(molecules: int, kind: str) -> Scenario:
    """Two discs of mass 1 that touch, in each molecule; hard ones between walls, soft ones in a periodic square.

    Hard (`kind` "stepped"): radius 1, area fraction 0.2, and a disc moves a tenth of its radius in a step of 1.
    Soft (`kind` "forced"): Lennard-Jones sites, a density of 0.25 and a temperature of 2, in a step of 0.005.
    """
    soft = kind == "forced"
    radius, temperature = (0.5, 2.0) if soft else (1.0, 0.01)
    area = molecules / _DUMBBELLS if soft else molecules * 2 * math.pi / 0.2
    box: dict[str, Any] = {"shape": "rectangle", "width": math.sqrt(area), "height": math.sqrt(area)}
    atoms = [{"position": [x, 0], "radius": radius} for x in (-radius, radius)]
    return parse(
        {
            "seed": _SEED,
            "container": {**box, "periodic": ["x", "y"]} if soft else box,
            "molecules": [
                {"name": "dumbbells", "count": molecules, "temperature": temperature, "atoms": atoms}
            ],
            "dynamics": {"kind": kind, "time_step": 0.005 if soft else 1},
            "frame_interval": 0.05 if soft else 10,
        }
    )


def enclosed(scenario: Scenario, what: str) -> Scenario:
    """The gas of a scenario between the walls of one of `ENCLOSURES`, at the same area fraction."""
    geometry = scenario.geometry()
    side = math.sqrt(geometry.area)
    box: dict[str, Any] = {"shape": "rectangle", "width": side, "height": side}
    data = {**scenario.to_dict(), "container": box}
    match what:
        case "100-sided polygon":
            radius = side / math.sqrt(50 * math.sin(math.pi / 50))
            data["container"] = {"shape": "regular-polygon", "sides": 100, "radius": radius}
        case "circle":
            data["container"] = {"shape": "circle", "radius": side / math.sqrt(math.pi)}
        case "gravity":
            # Over the height of the box the density changes by a tenth.
            data["gravity"] = [0, -0.1 * _temperature(scenario) / side]
        case "piston":
            count = scenario.species[0].count
            pressure = count * _temperature(scenario) / geometry.area
            motion = {
                "kind": "piston",
                "mass": 0.1 * count,
                "pressure": 2 * pressure,
                "stops": [0, 0.1 * side],
            }
            data["walls"] = {"right": {"motion": motion}}
    return parse(data)


def _temperature(scenario: Scenario) -> float:
    return scenario.species[0].temperature or 0.0


def _discs(name: str, radius: float, count: int) -> dict[str, Any]:
    """A species at temperature 1; a disc of diameter 1 has mass 1."""
    return {"name": name, "radius": radius, "mass": 4 * radius**2, "count": count, "temperature": 1}


def _exact(species: list[dict[str, Any]], area_fraction: float) -> Scenario:
    area = math.pi * sum(one["count"] * one["radius"] ** 2 for one in species)
    side = math.sqrt(area / area_fraction)
    return parse(
        {
            "seed": _SEED,
            "container": {"shape": "rectangle", "width": side, "height": side, "periodic": ["x", "y"]},
            "species": species,
            "dynamics": {"kind": "event-driven"},
            "frame_interval": 0.5 / math.sqrt(2),
        }
    )
