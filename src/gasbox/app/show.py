"""What happens inside a session's thread: the gas moves on and is published. Only that thread calls this."""

from __future__ import annotations

import contextlib
import logging
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from gasbox.app import picture, protocol, reins
from gasbox.app.audience import Audience
from gasbox.app.look import Look
from gasbox.app.motion import Motion
from gasbox.app.sample import Bin, Followed, Sample
from gasbox.app.shading import Shading
from gasbox.app.tandem import Partner
from gasbox.errors import GasboxError, UsageError
from gasbox.geometry import Geometry
from gasbox.state import Change, SetWorld

if TYPE_CHECKING:
    from gasbox.simulation import Simulation

__all__ = ["Show", "Wishes"]


@dataclass
class Wishes:
    """What the page asks for. Written by the page, read by the session's thread."""

    playing: bool = True
    speed: float = 1.0
    light: Bin | None = None
    followed_id: int | None = None
    pointed_id: int | None = None
    hands: dict[int, float] = field(default_factory=dict)
    """Where hands are that have just moved a wall: index of the wall -> displacement [length]."""
    look: Look = field(default_factory=Look)

    def inherit(self, wishes: Wishes) -> None:
        """Take over what was asked for on an earlier load of the page."""
        self.playing, self.speed, self.look = wishes.playing, wishes.speed, wishes.look
        self.followed_id = wishes.followed_id


class Show:
    """A gas in motion and its newest copies.

    Other threads may read the attributes (each is replaced as a whole, never changed) and set `sample_wanted`;
    all methods belong to the session's thread.

    Parameters
    ----------
    wishes : what the page asks for
    audience : who gets the frames
    unwatched : go on also when no browser looks
    """

    def __init__(self, wishes: Wishes, audience: Audience, unwatched: bool) -> None:
        self.sample: Sample | None = None
        self.sample_wanted = False
        self.followed: Followed | None = None
        self.trouble: str | None = None
        self.version = 0
        self.running = False
        self.partner: Partner | None = None
        """Another gas that runs in step with this one."""
        self._wishes = wishes
        self._audience = audience
        self._unwatched = unwatched
        self._motion: Motion | None = None
        self._generation = 0
        self._geometry: Geometry | None = None
        self._table = ""
        self._shading = Shading()
        self._view: dict[str, Any] = {}

    @property
    def gas(self) -> Simulation | None:
        """The gas itself, if there is one."""
        motion = self._motion
        return None if motion is None else motion.simulation

    @property
    def simulation(self) -> Simulation:
        """The gas itself, which there must be.

        Raises
        ------
        UsageError
            There is none, with the reason.
        """
        if self._motion is None:
            raise UsageError(self.trouble or "there is no gas yet")
        return self._motion.simulation

    def install(self, simulation: Simulation) -> None:
        """Show this gas from now on."""
        self._motion = Motion(simulation, self._wishes.speed)
        self._shading.begin(simulation)
        self.version += 1
        self.running = False
        self.trouble = None
        self.publish_all()
        if self.partner is not None:
            self.partner.renewed(simulation)

    def attempt(self, make: Callable[[], Simulation]) -> None:
        """Show the gas that `make` returns, or say why there is none."""
        try:
            self.install(make())
        except Exception as error:
            self.fail(error)

    def let_go(self) -> None:
        """Keep nothing."""
        self._motion = None

    def beat(self) -> float | None:
        """Move on if somebody looks. Returns the seconds until the next beat; None: not before a change."""
        motion = self._motion
        if motion is None or not self._wishes.playing or not (self._unwatched or self._audience.watching):
            self.running = False
            return None
        try:
            if not self.running:
                self.running = True
                motion.begin(self._wishes.speed)
            pause = motion.beat(math.inf if self.partner is None else self.partner.limit())
        except Exception as error:
            self.fail(error)
            return None
        if motion.moved:
            self.publish(sample=self.sample_wanted)
        return pause

    def step(self) -> None:
        """One whole frame."""
        if self._motion is not None:
            try:
                self._motion.step()
            except Exception as error:
                self.fail(error)
        if self.partner is not None:
            self.partner.stepped()
        self.changed()

    def reach(self, time: float) -> None:
        """On to this time [time], if it is not reached, however long it takes."""
        if self._motion is not None and self._motion.simulation.time < time:
            self._motion.simulation.advance(until=time)
            self.changed()

    def change(self, change: Change) -> None:
        """Change gravity, a wall or a setting, and show it.

        Raises
        ------
        UsageError, DynamicsError
            It cannot be done; nothing has changed.
        """
        self.simulation.apply(change)
        # A setting of a world that runs is seen with the next frame, when the world has acted.
        if not (self.running and isinstance(change, SetWorld)):
            self.publish()

    def follow_hands(self) -> None:
        """Move walls on to where hands have moved; all but the newest places were overtaken."""
        hands, self._wishes.hands = self._wishes.hands, {}
        if self._motion is None:
            return
        simulation = self._motion.simulation
        for wall, place in hands.items():
            self._try(
                reins.guided(simulation.geometry, simulation.state, wall, place, simulation.frame_interval)
            )

    def let_loose(self, wall: int) -> None:
        """A hand lets go of a wall."""
        self.follow_hands()
        if self._motion is not None:
            self._try(reins.released(self._motion.simulation.scenario.geometry(), wall))

    def _try(self, change: Change | None) -> None:
        """A change from a hand, which nobody waits for: if it cannot be done, it is not."""
        if change is None:
            return
        try:
            with contextlib.suppress(UsageError):
                self.change(change)
        except Exception as error:
            self.fail(error)

    def changed(self) -> None:
        """A wish has changed: count time anew, and show it."""
        self.running = False
        self.publish()
        if self.partner is not None:
            self.partner.changed()

    def fail(self, error: Exception) -> None:
        """The gas cannot go on, or could not be made: stand still and say why."""
        self._wishes.playing = False
        self.trouble = str(error) or type(error).__name__
        if not isinstance(error, GasboxError):
            logging.getLogger("gasbox").error("the gas cannot go on", exc_info=error)
        self._audience.tell(protocol.notice("trouble", text=self.trouble))

    def publish_all(self) -> None:
        """The table and a frame: for a new gas or a new browser."""
        if self._motion is None:
            if self.trouble is not None:
                self._audience.tell(protocol.notice("trouble", text=self.trouble))
            return
        self._lay_table(self._motion.simulation)
        self._view = {}
        self.publish()

    def _lay_table(self, simulation: Simulation) -> None:
        self._generation += 1
        self._geometry = simulation.geometry
        self._table = picture.table(simulation, self._generation)
        self._audience.tell(self._table, stale=True)

    def _see_geometry(self, simulation: Simulation) -> None:
        """Lay another table if the one that was laid no longer holds; a wall that turns round changes nothing in it."""
        self._geometry = simulation.geometry
        if picture.table(simulation, self._generation) != self._table:
            self._lay_table(simulation)

    def publish(self, *, sample: bool = True) -> None:
        """A frame for the browser, and a copy for the charts."""
        motion, wishes = self._motion, self._wishes
        if motion is None:
            return
        simulation = motion.simulation
        # By a change, by the scenario's schedule, or by a world.
        if simulation.geometry is not self._geometry:
            self._see_geometry(simulation)
        self._tell_of_world(simulation)
        self.followed, _ = picture.find(simulation, wishes.followed_id)
        if sample:
            self.sample_wanted = False
            self.sample = self._copy(motion)
        if self._audience.wants_frames():
            self._audience.show(
                picture.frame(
                    simulation,
                    generation=self._generation,
                    number=motion.frame,
                    playing=wishes.playing,
                    light=wishes.light,
                    followed_id=wishes.followed_id,
                    pointed_id=wishes.pointed_id,
                    look=wishes.look,
                    shades=self._shading.of(simulation, wishes.look.coloring, exact=not wishes.playing),
                )
            )

    def _tell_of_world(self, simulation: Simulation) -> None:
        """What there is to show of the world beside its particles, if it has changed."""
        view = {} if simulation.world is None else simulation.world.view()
        if view != self._view:
            self._view = view
            self._audience.view(protocol.notice("world", view=view))

    def _copy(self, motion: Motion) -> Sample:
        simulation = motion.simulation
        world = simulation.world
        return Sample(
            version=self.version,
            scenario=simulation.scenario,
            geometry=simulation.geometry,
            time=simulation.time,
            frame=motion.frame,
            state=simulation.state.copy(),
            tallies=simulation.dynamics.tallies.copy(),
            playing=self._wishes.playing,
            shown_fps=self._audience.shown_fps,
            keeping_up=motion.keeping_up,
            speed_reached=motion.speed_reached,
            warnings=tuple(simulation.warnings),
            changes=tuple(simulation.changes),
            frame_interval=simulation.frame_interval,
            world={} if world is None else world.view(),
            series={} if world is None else world.series(),
        )
