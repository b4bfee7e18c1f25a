"""A game as numbers to be remembered, as a summary, and as what a page shows."""

from __future__ import annotations

from typing import Any

import numpy as np

from gasbox.scenario.pong import PLAYERS
from gasbox.state import Memory
from gasbox.worlds.pong.score import NOBODY, PHASES, SERVE, SOUNDS, Score
from gasbox.worlds.pong.standing import Standing
from gasbox.worlds.pong.table import SIDES

__all__ = ["memory", "recall", "summary", "view"]

_SCORE = ("phase", "winner", "last", "to", "serves", "touches")


def memory(game: Standing) -> Memory:
    """Numbers and arrays from which `recall` makes the same game."""
    score, bats = game.score, game.bats
    targets = np.array([bat.target for bat in bats])
    return {
        "ball": game.met.ball,
        "met": game.met.rows.copy(),
        "points": np.array(score.points, np.int64),
        "score": np.array([getattr(score, name) for name in _SCORE], np.int64),
        "since": score.since,
        "sounds": np.array(score.sounds, np.int64),
        "players": np.array([PLAYERS.index(player) for player in game.players], np.int64),
        "looks": np.array(game.looks),
        "spot": game.spot.copy(),
        "settings": np.array([game.points, game.ball_speed, game.paddle_speed]),
        "asked": np.array(list(game.asked.values()), np.int64),
        "bricks": np.array([game.bricks, game.first_bricks], np.int64),
        "has_target": (~np.isnan(targets)).astype(np.int64),
        "targets": np.nan_to_num(targets),
        "pushes": np.array([bat.push for bat in bats], np.int64),
        "aims": np.array([bat.aim for bat in bats]),
        "paces": np.array([bat.pace for bat in bats]),
    }


def recall(game: Standing, memory: Memory) -> None:
    """Make it the game that was remembered."""
    kept = {name: np.asarray(value) for name, value in memory.items()}
    game.met.ball = int(kept["ball"])
    game.met.rows = kept["met"].astype(np.int64).reshape(-1, 2)
    numbers = dict(zip(_SCORE, kept["score"].tolist(), strict=True))
    game.score = Score(
        points=[int(n) for n in kept["points"]],
        since=float(kept["since"]),
        sounds=[int(n) for n in kept["sounds"]],
        **{name: int(number) for name, number in numbers.items()},
    )
    game.players = [PLAYERS[int(number)] for number in kept["players"]]
    game.looks = kept["looks"].astype(float).tolist()
    game.spot = kept["spot"].astype(np.float64)
    points, ball_speed, paddle_speed = kept["settings"].astype(float).tolist()
    game.points, game.ball_speed, game.paddle_speed = round(points), ball_speed, paddle_speed
    game.asked = dict(zip(game.asked, kept["asked"].astype(bool).tolist(), strict=True))
    game.bricks, game.first_bricks = (int(number) for number in kept["bricks"])
    for number, bat in enumerate(game.bats):
        bat.target = float(kept["targets"][number]) if kept["has_target"][number] else float("nan")
        bat.push = int(kept["pushes"][number])
        bat.aim, bat.pace = float(kept["aims"][number]), float(kept["paces"][number])


def _named(side: int) -> str | None:
    return None if side == NOBODY else SIDES[side]


def summary(game: Standing) -> dict[str, Any]:
    """How the game stands, as JSON values."""
    score = game.score
    found: dict[str, Any] = {
        "score": list(score.points),
        "points": game.points,
        "phase": PHASES[score.phase],
        "winner": _named(score.winner),
        "players": _players(game),
        "serves": score.serves,
        "sounds": dict(zip(SOUNDS, score.sounds, strict=True)),
    }
    if game.game.bricks is not None:
        found["bricks"] = game.bricks
    return found


def _players(game: Standing) -> dict[str, str | None]:
    players = [*game.players, None]
    return {"left": players[0], "right": players[1]}


def view(game: Standing) -> dict[str, Any]:
    """As `summary`, with what does not change from frame to frame of the bats."""
    shown = summary(game)
    del shown["serves"]
    shown["bricks"] = shown.get("bricks")
    shown["last"] = _named(game.score.last)
    serving = game.score.phase == SERVE
    shown["serve_at"] = game.score.since + game.game.serve_delay if serving else None
    shown["bats"] = {
        side.name: {
            "x": side.x,
            "start": side.start,
            "radius": side.radius,
            "half": side.half,
            "low": side.low,
            "high": side.high,
            "wall": side.wall,
        }
        for side in game.table.sides
    }
    return shown
