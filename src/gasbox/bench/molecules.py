"""Gases of dumbbells, in our engines and as bodies of two circles in pymunk."""

from __future__ import annotations

import importlib.util
import math
from typing import Any

from gasbox.bench.contest import Contender
from gasbox.bench.gases import ForcedGas, SteppedGas
from gasbox.bench.peers import corners
from gasbox.initial import populate
from gasbox.scenario import Scenario, parse

__all__ = ["PymunkDumbbells", "dumbbells", "hard_dumbbells", "soft_dumbbells"]

_SEED = 12
_DENSITY = 0.25
"""Molecules for each area of a square over a diameter of a disc."""


def dumbbells(molecules: int, kind: str) -> Scenario:
    """Two discs of mass 1 that touch, in each molecule; hard ones between walls, soft ones in a periodic square.

    Hard (`kind` "stepped"): radius 1, area fraction 0.2, and a disc moves a tenth of its radius in a step of 1.
    Soft (`kind` "forced"): Lennard-Jones sites, a density of 0.25 and a temperature of 2, in a step of 0.005.
    """
    soft = kind == "forced"
    radius, temperature = (0.5, 2.0) if soft else (1.0, 0.01)
    area = molecules / _DENSITY if soft else molecules * 2 * math.pi / 0.2
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


class PymunkDumbbells:
    """The hard dumbbells in pymunk (Chipmunk): elastic, without friction or slop, ten iterations."""

    name = "pymunk"

    def __init__(self, scenario: Scenario) -> None:
        import pymunk

        self._space = space = pymunk.Space()
        space.iterations, space.collision_slop, space.damping = 10, 0.0, 1.0
        for start, end in corners(scenario.geometry().size):
            self._add(pymunk.Segment(space.static_body, start, end, 0.0))
        state = populate(scenario)
        assert state.sites is not None
        sites = state.sites
        for row in range(state.count):
            body = pymunk.Body(float(state.mass[row]), float(state.inertia[row]))
            body.position, body.velocity = (
                tuple(state.position[row].tolist()),
                tuple(state.velocity[row].tolist()),
            )
            body.angle = float(state.angle[row])
            body.angular_velocity = float(state.angular_velocity[row])
            space.add(body)
            for site in range(sites.first[row], sites.first[row + 1]):
                self._add(pymunk.Circle(body, float(sites.radius[site]), tuple(sites.place[site].tolist())))
        self._molecules = state.count

    def _add(self, shape: Any) -> None:
        shape.elasticity, shape.friction = 1.0, 0.0
        self._space.add(shape)

    def energy(self) -> float:
        """Kinetic energy [energy]."""
        return float(sum(body.kinetic_energy for body in self._space.bodies)) / 2.0

    def work(self, portions: int) -> float:
        """Steps times molecules."""
        for _ in range(portions):
            self._space.step(1.0)
        return float(portions * self._molecules)


def hard_dumbbells(molecules: int) -> list[Contender]:
    """Ours under the stepped rule, and pymunk if it is installed."""
    scenario = dumbbells(molecules, "stepped")
    ours: list[Contender] = [SteppedGas(scenario)]
    return ours + ([PymunkDumbbells(scenario)] if importlib.util.find_spec("pymunk") else [])


def soft_dumbbells(molecules: int) -> list[Contender]:
    """Ours with forces; no peer."""
    return [ForcedGas(dumbbells(molecules, "forced"), 1)]
