"""Where walls are at any time, as far as that is known beforehand: by their motion and by the schedule."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from gasbox.geometry import Enclosure, Path, Sinusoid
from gasbox.geometry.wall import Motion
from gasbox.scenario.schedule import ScheduledChange

__all__ = ["Track", "tracks"]

_PERIODS = 1
"""After so many periods a sinusoid brings nothing new."""


@dataclass(frozen=True)
class Track:
    """The displacement of one wall, by one motion after the other.

    Attributes
    ----------
    begins : when each motion takes over, the first at minus infinity [time]
    motions : the motions; None at rest
    """

    begins: tuple[float, ...]
    motions: tuple[Motion | None, ...]

    @property
    def moves(self) -> bool:
        """Whether it ever moves."""
        return any(motion is not None for motion in self.motions)

    def displacement(self, time: float) -> float:
        """Where the wall is at a time [length]."""
        number = sum(begin <= time for begin in self.begins) - 1
        match self.motions[number]:
            case Path() as path:
                return path.piece(time)[0]
            case Sinusoid(amplitude=amplitude, phase=phase) as wave:
                return amplitude * (math.sin(wave.frequency * time + phase) - math.sin(phase))
            case _:
                return 0.0

    def corners(self) -> list[float]:
        """Times between which the wall goes one way [time]; the last motion may go on for ever."""
        found = [begin for begin in self.begins if math.isfinite(begin)]
        for motion in self.motions:
            if isinstance(motion, Path):
                found += motion.times
            elif isinstance(motion, Sinusoid):
                turns = (math.pi / 2 - motion.phase) / math.pi
                found += [(math.ceil(turns) - turns + n) * motion.period / 2 for n in range(2 * _PERIODS)]
        return found

    @property
    def last_speed(self) -> float:
        """Speed with which it goes on for ever [length/time]."""
        last = self.motions[-1]
        return last.speeds[-1] if isinstance(last, Path) else 0.0


def tracks(enclosure: Enclosure, schedule: Sequence[ScheduledChange]) -> list[Track]:
    """One track for each wall."""
    found = [Track((-math.inf,), (wall.motion,)) for wall in enclosure.walls]
    for entry in sorted(schedule, key=lambda entry: entry.at):
        if entry.wall is None or (entry.displacement is None and entry.free is None):
            continue
        number = enclosure.wall_names.index(entry.wall)
        track = found[number]
        if entry.displacement is None:
            motion: Motion | None = enclosure.walls[number].motion
        else:
            origin = track.displacement(entry.at)
            duration = abs(entry.displacement - origin) / (entry.speed or 1.0)
            motion = Path(
                (entry.at, entry.at + duration),
                (origin, entry.displacement),
                ((entry.displacement - origin) / duration if duration else 0.0, 0.0),
            )
        found[number] = Track((*track.begins, entry.at), (*track.motions, motion))
    return found
