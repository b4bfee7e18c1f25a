"""Tables for pong, as scenario data: one for each choice of gas, bats and players."""

from __future__ import annotations

import math
from typing import Any, Final

__all__ = ["BATS", "VARIANTS", "pong_table"]

VARIANTS: Final = {
    "gas": "Pong in a gas",
    "attractive": "Pong in a gas that condenses",
    "gravity": "Pong in a falling gas",
    "breakout": "Breakout in a gas",
    "vacuum": "Pong in empty space",
}
"""Name of each variant, and its title."""
BATS: Final = {"small": 7.0, "medium": 10.0, "large": 16.0}
"""Half the height of a bat [length]."""

_FRAME = 1 / 60
"""[time]."""
_STEPS = 170
"""In a frame, under forces."""
_WIDTH, _HEIGHT = 160.0, 100.0
_LINE = 5.0
"""From the end of the table to the goal line [length]."""
_GAS, _BALL = 0.8, 3.0
"""Radii [length]."""
_BALL_MASS = 80.0
_GRAVITY = -60.0
_BRICK, _COLUMNS, _ROWS = 3.4, 4, 12
_FIRST_BRICK = 112.0
"""Where the first column of bricks stands [length]."""
_WATCH: Final = {
    "gas": "The light gas jostles the heavy ball and slows it down; each bat gives it its speed back. "
    "Hit it with the rim of a bat to send it off at an angle, or while the bat moves to make it fast.",
    "attractive": "The discs of this gas attract each other: they gather in droplets, which cling to each other "
    "and to the ball, and which the ball breaks up.",
    "gravity": "Ball and gas fall: the gas is densest at the bottom, where the ball bounces, "
    "and thin at the top.",
    "breakout": "Each brick that the ball hits is a point. The gas presses on all of them from all sides "
    "and moves none: they are far too heavy.",
    "vacuum": "Nothing slows the ball down: hits by a moving bat make it faster and faster, "
    "and still it never passes through one.",
}


def pong_table(
    gas: int | None = None,
    temperature: float | None = None,
    bat: str | float = "medium",
    variant: str = "gas",
    players: tuple[str, str] = ("human", "medium"),
    points: int = 5,
    ball_speed: float = 130.0,
    paddle_speed: float = 120.0,
    seed: int = 1,
) -> dict[str, Any]:
    """A scenario of 160 x 100, in which a unit of time is a second of 60 frames.

    Parameters
    ----------
    gas : number of discs of gas, each of mass 1; without it, 120, of the attractive gas 200
    temperature : of the gas [energy]; without it, 16000, of the attractive gas 4000
    bat : small, medium or large, or half its height [length]
    variant : one of `VARIANTS`
    players : left and right: human, easy, medium or hard; in breakout only the left one plays
    points : that win; in breakout, balls that may be lost
    ball_speed, paddle_speed : of a serve, and at most of a bat [length/time]

    Returns
    -------
    What a scenario file holds.

    Raises
    ------
    ValueError
        No such variant or bat.
    """
    if variant not in VARIANTS:
        raise ValueError(f"there is no pong {variant!r}; there are {', '.join(VARIANTS)}")
    if isinstance(bat, str) and bat not in BATS:
        raise ValueError(f"there is no {bat!r} bat; there are {', '.join(BATS)}")
    alone, attractive = variant == "breakout", variant == "attractive"
    if temperature is None:
        temperature = 4000.0 if attractive else 16000.0
    if gas is None:
        gas = 200 if attractive else 120
    # The ends of the table keep the gas as warm as it is; what attracts itself they cool, so that it condenses.
    warm = {"temperature": 0.25 * temperature if attractive else temperature}
    half = BATS[bat] if isinstance(bat, str) else bat
    obstacles = [_goal("goal-left", _LINE), _bat("bat-left", half, False)]
    # Discs of gas that were caught between the ball and the end of the table would stop it: they pass the line, too.
    walls = {"left": warm}
    world: dict[str, Any] = {
        "kind": "pong",
        "ball": "ball",
        "left": "bat-left",
        "goals": ["goal-left"],
        "players": {"left": players[0]},
        "points": points,
        "ball_speed": ball_speed,
        "paddle_speed": paddle_speed,
    }
    if not alone:
        obstacles += [_goal("goal-right", _WIDTH - _LINE), _bat("bat-right", half, True)]
        walls["right"] = warm
        world |= {"right": "bat-right", "goals": ["goal-left", "goal-right"]}
        world["players"] = dict(zip(("left", "right"), players, strict=True))
    data: dict[str, Any] = {
        "format": "gasbox-scenario/1",
        "title": VARIANTS[variant],
        "watch_for": _WATCH[variant],
        "seed": seed,
        "container": {"shape": "rectangle", "width": _WIDTH, "height": _HEIGHT},
        "walls": walls,
        "obstacles": obstacles,
        "species": [*_gas(0 if variant == "vacuum" else gas, temperature, alone), _ball()],
        "particles": [{"species": "ball", "position": [0.5 * _WIDTH, 0.5 * _HEIGHT], "velocity": [0.0, 0.0]}],
        "world": world,
        "dynamics": {"kind": "event-driven"},
        "frame_interval": _FRAME,
    }
    if attractive:
        data |= _forces(temperature)
    if variant == "gravity":
        data["gravity"] = [0.0, _GRAVITY]
    if alone:
        data["species"].append(_brick())
        data["particles"] += _bricks()
        world["bricks"] = "brick"
    return data


def _gas(count: int, temperature: float, alone: bool) -> list[dict[str, Any]]:
    if not count:
        return []
    end = _FIRST_BRICK - 2 * _BRICK if alone else _WIDTH - _LINE - 8.0
    region = {"x": [_LINE + 8.0, end], "y": [0.0, _HEIGHT]}
    return [
        {
            "name": "gas",
            "mass": 1.0,
            "radius": _GAS,
            "color": "#7a86a0",
            "count": count,
            "temperature": temperature,
            "region": region,
        }
    ]


def _forces(temperature: float) -> dict[str, Any]:
    """Attraction so strong that the gas just condenses, and a step as short as that needs."""
    epsilon = 4.0 * temperature
    steps = math.ceil(_STEPS * math.sqrt(temperature / 4000.0))
    pairs = [
        {"between": ["gas", "gas"], "epsilon": epsilon},
        {"between": ["ball", "gas"], "epsilon": 0.5 * epsilon},
    ]
    return {
        "dynamics": {"kind": "forced", "time_step": _FRAME / steps},
        "forces": {"law": "lennard-jones", "pairs": pairs},
    }


def _ball() -> dict[str, Any]:
    return {"name": "ball", "mass": _BALL_MASS, "radius": _BALL, "color": "#e8590c"}


def _brick() -> dict[str, Any]:
    return {"name": "brick", "mass": 1e7, "radius": _BRICK, "color": "#1c8fb0"}


def _bricks() -> list[dict[str, Any]]:
    pitch = _HEIGHT / _ROWS
    return [
        {
            "species": "brick",
            "position": [_FIRST_BRICK + column * 2.35 * _BRICK, (row + 0.5) * pitch],
            "velocity": [0.0, 0.0],
        }
        for column in range(_COLUMNS)
        for row in range(_ROWS)
    ]


def _goal(name: str, x: float) -> dict[str, Any]:
    """A line that only counts."""
    return {"shape": "segment", "name": name, "start": [x, 0.0], "end": [x, _HEIGHT], "passes": "all"}


def _bat(name: str, half: float, right: bool) -> dict[str, Any]:
    """A cap on the goal line: a disc so large that its rim stands at 30 degrees to the line."""
    radius = 2.0 * half
    behind = _LINE - math.sqrt(radius**2 - half**2)
    x = round(_WIDTH - behind if right else behind, 6)
    return {
        "shape": "disc",
        "name": name,
        "center": [x, 0.5 * _HEIGHT],
        "radius": radius,
        "direction": [0.0, 1.0],
    }
