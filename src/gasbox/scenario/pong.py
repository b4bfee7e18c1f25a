"""A game of pong in a gas."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, ClassVar, Final, Literal

from pydantic import ConfigDict, Field, Strict

from gasbox.scenario.setting import Setting
from gasbox.scenario.values import WHOLE, NotNegative, Positive, Section

__all__ = ["PLAYERS", "Players", "Pong"]

PLAYERS: Final = ("human", "easy", "medium", "hard")
"""Who may play: somebody at the keyboard, or the computer, by its skill."""

Player = Literal["human", "easy", "medium", "hard"]

_FASTEST: Final = 1e9


def _settings() -> dict[str, Setting]:
    found: dict[str, Setting] = {}
    for side in ("left", "right"):
        found[side] = Setting(f"who plays on the {side}", words=PLAYERS)
        found[f"{side}_target"] = Setting(f"where the {side} bat is to go, upwards", unit="[length]")
        found[f"{side}_push"] = Setting(f"where the {side} bat is pushed: 1 up, -1 down, 0 nowhere", -1, 1)
    return {
        **found,
        "points": Setting("points that win", 1, 99),
        "ball_speed": Setting("speed of a serve", 1e-9, _FASTEST, "[length/time]"),
        "paddle_speed": Setting("greatest speed of a bat", 1e-9, _FASTEST, "[length/time]"),
        "serve": Setting("serve now", is_switch=True),
        "restart": Setting("begin again", is_switch=True),
    }


class Players(Section):
    """Who plays."""

    left: Player = "human"
    """On the left: human, or the computer at one of three levels, easy, medium or hard."""
    right: Player = "medium"
    """On the right."""


class Pong(Section):
    """A game of pong in a gas: bats that move, a ball, and lines that it must not pass."""

    model_config = ConfigDict(
        json_schema_extra={"required": ["kind", "ball", "left", "goals", "ball_speed", "paddle_speed"]}
    )
    SETTINGS: ClassVar[Mapping[str, Setting]] = _settings()
    """What can be set while it runs, by a schedule or on the page."""

    kind: Literal["pong"] = "pong"
    """Kind of world."""
    ball: str
    """Name of the species whose one disc is the ball."""
    left: str
    """Name of the left bat: an obstacle of shape disc with the direction [0, 1]."""
    right: str | None = None
    """Name of the right bat; without it, the left one plays alone."""
    goals: Annotated[tuple[str, ...], Field(min_length=1, max_length=2)]
    """Names of the lines behind the left and the right bat: upright segments that the ball passes."""
    players: Players = Players()
    """Who plays at the start."""
    points: Annotated[int, Strict(), Field(ge=1, le=99), WHOLE] = 5
    """So many points win; of one who plays alone, so many balls may be lost."""
    ball_speed: Positive
    """Speed of a serve [length/time]."""
    keep_speed: bool = True
    """Whether a bat gives the ball at least `ball_speed`: the gas slows it down on its way."""
    least_speed: NotNegative | None = None
    """A ball that has become slower is driven on with this speed, the way it flies; 0 leaves it to the gas, and without
    it, it is 0.6 `ball_speed` [length/time]."""
    paddle_speed: Positive
    """Greatest speed of a bat [length/time]."""
    serve_delay: NotNegative = 1.0
    """How long the ball is held before a serve [time]."""
    patience: Positive | None = None
    """A ball that no bat has hit for so long is served again; without it, the time of ten flights from one end to the
    other at `ball_speed` [time]."""
    bricks: str | None = None
    """Name of a species whose discs the ball takes away when it hits them, a point each."""
