"""People who walk and infect each other, in Mesa."""

from __future__ import annotations

import math
from importlib.util import find_spec
from typing import Any

from gasbox.bench.contest import Contender
from gasbox.initial import populate
from gasbox.scenario import Epidemic, Scenario, Walk
from gasbox.scenario.epidemic import ByCloseness

__all__ = ["MesaCrowd", "crowd_peers", "missing_crowd_peers"]


def crowd_peers(scenario: Scenario) -> list[Contender]:
    """The peers that are installed, each with the same people at the start."""
    return [] if missing_crowd_peers() else [MesaCrowd(scenario)]


def missing_crowd_peers() -> list[str]:
    """Names of the packages that are not installed."""
    return [] if find_spec("mesa") else ["mesa"]


class MesaCrowd:
    """Agents of Mesa in its continuous space: walk, turn by chance, turn round at the walls, infect those nearby.

    Only the infectious look around them; that takes Mesa a look at all agents, in NumPy. Nobody recovers.
    """

    name = "Mesa"

    def __init__(self, scenario: Scenario) -> None:
        import mesa  # type: ignore[import-not-found,import-untyped,unused-ignore]
        from mesa.space import (  # type: ignore[import-not-found,import-untyped,unused-ignore]
            ContinuousSpace,
        )

        walk, world, state = scenario.dynamics, scenario.world, populate(scenario)
        assert isinstance(walk, Walk)
        assert isinstance(world, Epidemic)
        assert isinstance(world.transmission, ByCloseness)
        width, height = scenario.geometry().size.tolist()
        stride, radius = walk.speed * walk.time_step, world.transmission.radius
        chance = world.transmission.probability_per_day * walk.time_step / world.day
        # Of the same width as a Gaussian of this variance.
        swerve = math.sqrt(6.0 * walk.turning * walk.time_step)

        class Person(mesa.Agent):  # type: ignore[misc,unused-ignore]
            """Walks, and infects."""

            def __init__(self, model: Any, is_ill: bool) -> None:
                super().__init__(model)
                self.is_ill, self.heading = is_ill, model.random.uniform(0.0, 2.0 * math.pi)

            def step(self) -> None:
                """Walk on by a step."""
                random, space = self.model.random, self.model.space
                self.heading += random.uniform(-swerve, swerve)
                x = self.pos[0] + stride * math.cos(self.heading)
                y = self.pos[1] + stride * math.sin(self.heading)
                if not 0.0 < x < width:
                    x, self.heading = self.pos[0], math.pi - self.heading
                if not 0.0 < y < height:
                    y, self.heading = self.pos[1], -self.heading
                space.move_agent(self, (x, y))

            def infect(self) -> None:
                """Infect those nearby, with a probability each."""
                if not self.is_ill:
                    return
                for other in self.model.space.get_neighbors(self.pos, radius):
                    if not other.is_ill and self.model.random.random() < chance:
                        other.is_ill = True

        self._model = model = mesa.Model(seed=scenario.seed)
        model.space = ContinuousSpace(width, height, False)
        ill = [entry.name for entry in scenario.species].index("infectious")
        for (x, y), species in zip(state.position.tolist(), state.species.tolist(), strict=True):
            model.space.place_agent(Person(model, species == ill), (x, y))

    def work(self, portions: int) -> float:
        """Steps times people."""
        for _ in range(portions):
            self._model.agents.do("step")
            self._model.agents.do("infect")
        return float(portions * len(self._model.agents))
