"""The score of a game, and what has happened in it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

__all__ = ["NOBODY", "OVER", "PHASES", "PLAY", "SERVE", "SOUNDS", "Score"]

SERVE, PLAY, OVER = range(3)
PHASES: Final = ("serve", "play", "over")
SOUNDS: Final = ("paddle", "wall", "brick", "goal")
"""What can be heard."""
NOBODY: Final = -1


@dataclass
class Score:
    """How the game stands.

    Attributes
    ----------
    points : of left and right; of one who plays alone, bricks hit and balls lost
    phase : SERVE, PLAY or OVER
    since : when the phase began, or a bat last hit the ball [time]
    winner, last : who has won, and who hit the ball last: 0 left, 1 right, NOBODY
    to : to whom the next ball is served; NOBODY lets the lot decide
    serves, touches : how many so far; the lot goes by them
    sounds : how often each of `SOUNDS` was to be heard
    """

    points: list[int] = field(default_factory=lambda: [0, 0])
    phase: int = SERVE
    since: float = 0.0
    winner: int = NOBODY
    last: int = NOBODY
    to: int = NOBODY
    serves: int = 0
    touches: int = 0
    sounds: list[int] = field(default_factory=lambda: [0] * len(SOUNDS))

    def hear(self, sound: str) -> None:
        """One more of it."""
        self.sounds[SOUNDS.index(sound)] += 1

    def enter(self, phase: int, time: float) -> None:
        """Another phase begins."""
        self.phase, self.since = phase, time

    def end(self, time: float, winner: int) -> None:
        """The game is over."""
        self.winner = winner
        self.enter(OVER, time)
