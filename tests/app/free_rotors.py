"""Molecules that fly and turn through each other in a periodic box, for tests that need no engine."""

from __future__ import annotations

from typing import Any

import numpy as np
from free_flight import FakeClock, FreeFlight

from gasbox.scenario import Scenario, parse
from gasbox.scenario.sites import sites_of
from gasbox.state import State, Tallies

DUMBBELL = {
    "atoms": [
        {"position": [-2, 0], "radius": 1.5, "color": "#0000ff"},
        {"position": [2, 0], "radius": 1.5, "color": "#00a000"},
    ],
    "color": "#0000ff",
}
SPRING = {
    "atoms": [{"position": [-1.5, 0]}, {"position": [1.5, 0]}],
    "bonds": [{"atoms": [0, 1], "stiffness": 10.0}],
    "color": "#c86dd7",
}


class FreeRotors(FreeFlight):
    """Like `FreeFlight`, with molecules; flexible ones are stretched as they start."""

    def __init__(
        self, scenario: Scenario, clock: FakeClock | None = None, cost: float = 0.0, overhead: float = 0.0
    ) -> None:
        super().__init__(scenario.model_copy(update={"particles": None}), clock, cost, overhead)
        self.scenario = scenario
        kinds = scenario.kinds
        drawn = np.repeat(np.arange(len(kinds), dtype=np.int32), [kind.count for kind in kinds])
        random = np.random.default_rng(scenario.seed)
        place = random.random((len(drawn), 2)) * self.geometry.size
        angle = random.random(len(drawn)) * 6.0
        flight, turning = random.normal(size=(len(drawn), 2)), random.normal(size=len(drawn))
        if scenario.particles is not None:
            listed, place, flight = scenario.particles.arrays([kind.name for kind in kinds])
            angle, turning = scenario.particles.rotation()
            drawn = listed
        inertia = np.array([kind.inertia for kind in kinds])[drawn]
        self.state = State(
            time=0.0,
            id=np.arange(len(drawn)),
            species=drawn,
            mass=np.array([kind.mass for kind in kinds])[drawn],
            radius=np.array([kind.radius for kind in kinds])[drawn],
            position=place,
            velocity=flight,
            angle=angle,
            angular_velocity=turning * (inertia > 0),
            inertia=inertia,
            sites=sites_of(scenario, drawn) if scenario.molecules else None,
        )
        self.dynamics.tallies = Tallies.zero(len(kinds), len(self.geometry.wall_names))
        self._turn()

    def advance(self, *, until: float) -> None:
        self.state.angle = self.state.angle + self.state.angular_velocity * (until - self.time)
        super().advance(until=until)
        self._turn()

    def _turn(self) -> None:
        sites = self.state.sites
        if sites is not None:
            soft, sites.flexible = sites.flexible, np.zeros_like(sites.flexible)
            self.state.turn_sites()
            sites.flexible = soft


def rotors(*molecules: dict[str, Any], species: tuple[dict[str, Any], ...] = (), **settings: Any) -> Scenario:
    """A small periodic box with these molecules."""
    return parse(
        {
            "format": "gasbox-scenario/1",
            "title": "Molecules for tests",
            "container": {"shape": "rectangle", "width": 60, "height": 40, "periodic": ["x", "y"]},
            "species": list(species),
            "molecules": [
                {"name": f"molecule {number}", "count": 20, "temperature": 1, **one}
                for number, one in enumerate(molecules)
            ],
            "frame_interval": 0.5,
            **settings,
        }
    )
