"""What was asked of a game while it runs."""

from __future__ import annotations

import math

from gasbox.errors import UsageError
from gasbox.scenario import Pong
from gasbox.state import SetWorld
from gasbox.worlds.pong.standing import Standing
from gasbox.worlds.pong.table import SIDES

__all__ = ["take"]


def take(game: Standing, change: SetWorld) -> None:
    """Give a setting another value; it acts at the next turn.

    Raises
    ------
    UsageError
        There is no such setting, or it cannot have this value.
    """
    name, value = change.name, change.value
    if name not in Pong.SETTINGS:
        raise UsageError(f"pong has no setting {name!r}; there are {', '.join(Pong.SETTINGS)}")
    try:
        Pong.SETTINGS[name].check(value)
    except ValueError as error:
        raise UsageError(f"{name}: {error}") from None
    side, _, what = name.partition("_")
    if side in SIDES:
        _tell(game, SIDES.index(side), what, value)
    elif name in game.asked:
        game.asked[name] = bool(value)
    elif name == "points":
        game.points = round(float(value))
    else:
        setattr(game, name, float(value))


def _tell(game: Standing, number: int, what: str, value: float | str | bool) -> None:
    """Who plays on a side, or where its bat is to go; nobody tells the computer."""
    if number >= len(game.bats):
        raise UsageError(f"nobody plays on the {SIDES[number]}: there is no bat")
    bat = game.bats[number]
    if not what:
        game.players[number] = str(value)
        bat.rest()
        game.looks[number] = 0.0
    elif game.players[number] == "human" and what == "push":
        bat.push, bat.target = round(float(value)), math.nan
    elif game.players[number] == "human":
        bat.target, bat.push = float(value), 0
