"""How a game stands: all of it that changes, and the table that it is played on."""

from __future__ import annotations

import numpy as np

from gasbox.scenario import EventDriven, Pong, Scenario
from gasbox.worlds.pong.bat import Bat
from gasbox.worlds.pong.meetings import Meetings
from gasbox.worlds.pong.score import Score
from gasbox.worlds.pong.table import table_of

__all__ = ["Standing"]


class Standing:
    """A game before its first turn.

    Parameters
    ----------
    scenario : whose world is a `Pong`
    """

    def __init__(self, scenario: Scenario) -> None:
        game = scenario.world
        assert isinstance(game, Pong)
        self.game, self.seed = game, scenario.seed
        self.table = table_of(scenario, game)
        self.frame = scenario.frame_interval or self.table.width / game.ball_speed
        # Between two frames, so that what was asked for at the last one is seen at the next one.
        self.interval = 0.5 * self.frame if isinstance(scenario.dynamics, EventDriven) else self.frame
        self.bats = [Bat(side) for side in self.table.sides]
        self.players = [str(player) for player in (game.players.left, game.players.right)][: len(self.bats)]
        self.points, self.ball_speed, self.paddle_speed = game.points, game.ball_speed, game.paddle_speed
        self.score, self.met = Score(), Meetings()
        self.looks = [0.0] * len(self.bats)
        self.asked = {"serve": False, "restart": False}
        self.spot = np.array(self.table.center)
        self.bricks = 0
        self.first_bricks = 0
