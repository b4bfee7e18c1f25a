"""One browser tab's gas: a simulation in a thread of its own, and what the page may ask of it.

Nothing here waits for the engine, except where it says so; orders are carried out between two slices of an
advance.
"""

from __future__ import annotations

import math
import secrets
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from gasbox.app import protocol
from gasbox.app.mailbox import Mailbox
from gasbox.app.motion import Motion
from gasbox.app.pace import SPEED_LIMITS
from gasbox.app.sample import Bin, Followed, Quantity, Sample
from gasbox.app.worker import Worker
from gasbox.errors import Problem, ScenarioError, UsageError
from gasbox.scenario import Scenario

if TYPE_CHECKING:
    from gasbox.run import Simulation

__all__ = ["Session"]

_T = TypeVar("_T")


def _simulate(scenario: Scenario) -> Simulation:
    # Imported here: numba and the kernels come in while the page is already being served.
    from gasbox.run import Simulation

    return Simulation(scenario)


class Session:
    """One tab's gas. It costs nothing until `start`, which the first frame socket calls.

    Parameters
    ----------
    scenario : what to show first
    unwatched : go on also when no browser looks (otherwise time stands still then)
    prepare : called in the worker before the first simulation is made; waits for the kernels
    simulate : makes the simulation of a scenario
    """

    def __init__(
        self,
        scenario: Scenario,
        *,
        unwatched: bool = False,
        prepare: Callable[[], None] | None = None,
        simulate: Callable[[Scenario], Simulation] = _simulate,
    ) -> None:
        self.id = secrets.token_urlsafe(16)
        self.origin = scenario
        """The scenario of the page's first load; `scenario` is what is shown now."""
        self.trouble: str | None = None
        """Why the gas cannot go on, or could not be made."""
        self._scenario = scenario
        self._playing = True
        self._speed = 1.0
        self._version = 0
        self._unwatched = unwatched
        self._prepare = prepare
        self._simulate = simulate
        self._lock = threading.Lock()
        self._worker: Worker | None = None
        self._motion: Motion | None = None
        self._mailbox: Mailbox | None = None
        self._running = False
        self._generation = 0
        self._light: Bin | None = None
        self._followed_id: int | None = None
        self._followed: Followed | None = None
        self._sample: Sample | None = None
        self._sample_wanted = False
        self.created = time.monotonic()
        self.detached = self.created

    # -- what it is ------------------------------------------------------------------------------------------

    @property
    def scenario(self) -> Scenario:
        """What the gas was made from."""
        return self._scenario

    @property
    def playing(self) -> bool:
        """Whether time is meant to run (it stands still all the same while nobody looks)."""
        return self._playing

    @property
    def speed(self) -> float:
        """Speed that is asked for; 1 shows 60 frames of simulated time per second."""
        return self._speed

    @property
    def version(self) -> int:
        """Increases with each load and reset, and from 0 to 1 when the first gas is there."""
        return self._version

    @property
    def started(self) -> bool:
        """Whether there is (or is being made) a gas."""
        return self._worker is not None

    @property
    def watched(self) -> bool:
        """Whether a browser shows the frames: connected, visible, acks arriving."""
        mailbox = self._mailbox
        return mailbox is not None and mailbox.is_watched()

    @property
    def attached(self) -> bool:
        """Whether a frame socket is connected, seen or not."""
        return self._mailbox is not None

    # -- orders ----------------------------------------------------------------------------------------------

    def start(self, simulation: Simulation | None = None) -> None:
        """Begin to work, with a gas that somebody hands over or a new one. Does not wait; once is enough."""
        with self._lock:
            if self._worker is not None:
                return
            self._worker = Worker(self._beat, f"gasbox-{self.id[:6]}")
            self._worker.start()
        self._order(lambda: self._begin(simulation))

    def play(self) -> None:
        """Let time run."""
        self._set_playing(True)

    def pause(self) -> None:
        """Let time stand still."""
        self._set_playing(False)

    def toggle(self) -> None:
        """Play if paused, pause if playing."""
        self._set_playing(not self._playing)

    def set_speed(self, speed: float) -> None:
        """Set the speed, moved into the limits of 0.1 and 100.

        Raises
        ------
        UsageError
            Not a number.
        """
        if not math.isfinite(speed):
            raise UsageError(f"speed: found {speed}; a number from {SPEED_LIMITS[0]} to {SPEED_LIMITS[1]}")
        self._speed = min(max(float(speed), SPEED_LIMITS[0]), SPEED_LIMITS[1])
        self._order(self._new_speed)

    def step(self) -> Future[None]:
        """One frame; pauses first."""
        self._playing = False
        return self._order(self._step)

    def reset(self) -> Future[None]:
        """Back to the start of the same scenario, with the same seed."""
        return self._order(lambda: self._install(self._simulate(self._scenario), self._scenario))

    def load(self, scenario: Scenario) -> None:
        """Replace the gas by that of another scenario or snapshot. Waits: call it outside of an event loop.

        Raises
        ------
        ScenarioError, DynamicsError
            It cannot be made; the old gas goes on untouched.
        """
        _check(scenario)
        if self._prepare is not None:
            self._prepare()
        simulation = self._simulate(scenario)
        self.start()
        self._order(lambda: self._install(simulation, scenario)).result()

    def snapshot(self) -> Scenario:
        """The gas as it is now, to the bit. Waits: call it outside of an event loop."""
        self.start()
        return self._order(lambda: self._moving().simulation.snapshot()).result()

    def settle(self, timeout: float = 30.0) -> None:
        """Wait until every order given so far is carried out."""
        self._order(lambda: None).result(timeout)

    def sample(self) -> Sample | None:
        """The newest copy for charts and readouts; None while the gas is still being made.

        Never waits: a running gas makes a fresh copy after each call, a paused one after each change. So the copy
        is at most as old as the time between two calls.
        """
        self._sample_wanted = True
        return self._sample

    def highlight(self, species: int, low: float, high: float, quantity: Quantity = "speed") -> None:
        """Light up the discs of one species whose speed or energy lies in [low, high)."""
        self._light = Bin(species, low, high, quantity)
        self._order(self._publish)

    def clear_highlight(self) -> None:
        """Light up nothing."""
        if self._light is not None:
            self._light = None
            self._order(self._publish)

    def follow(self, particle_id: int | None) -> None:
        """Follow one disc, or none; an id that does not exist is none."""
        self._followed_id = particle_id
        self._order(self._publish)

    def followed(self) -> Followed | None:
        """The followed disc as last shown."""
        return self._followed

    def id_of_row(self, row: Any) -> int | None:
        """The id of the disc in this row of the frame; None for anything else."""
        sample = self._sample
        if not isinstance(row, int) or sample is None or not 0 <= row < sample.state.count:
            return None
        return int(sample.state.id[row])

    # -- browsers --------------------------------------------------------------------------------------------

    def attach(self, mailbox: Mailbox) -> None:
        """Send frames to this mailbox from now on, and no longer to an earlier one."""
        old, self._mailbox = self._mailbox, mailbox
        if old is not None:
            old.close()
        self._order(self._publish_all)

    def detach(self, mailbox: Mailbox) -> None:
        """This mailbox is gone."""
        mailbox.close()
        if self._mailbox is mailbox:
            self._mailbox = None
            self.detached = time.monotonic()
        self.wake()

    def tell(self, text: str) -> None:
        """Send a text message of the protocol to the browser, if there is one."""
        if self._mailbox is not None:
            self._mailbox.put_text(text)

    def wake(self) -> None:
        """Something has changed about who looks."""
        if self._worker is not None and self.watched != self._running:
            self._worker.wake()

    def hand_over(self, heir: Session) -> None:
        """Give gas, speed and all to another session, and end. For a page that was loaded again. Waits."""
        if self._worker is None:
            return
        simulation = self._order(lambda: self._moving().simulation).result()
        self.close()
        heir._scenario, heir._playing, heir._speed = self._scenario, self._playing, self._speed
        heir._followed_id = self._followed_id
        heir.start(simulation)

    def close(self) -> None:
        """End the thread and let the gas go."""
        if self._worker is not None:
            self._worker.close()
            self._worker.join(5.0)
        if self._mailbox is not None:
            self._mailbox.close()
        self._motion = None

    # -- inside the worker's thread --------------------------------------------------------------------------

    def _order(self, order: Callable[[], _T]) -> Future[_T]:
        if self._worker is None:
            future: Future[Any] = Future()
            future.set_result(None)
            return future
        return self._worker.ask(order)

    def _moving(self) -> Motion:
        if self._motion is None:
            raise UsageError(self.trouble or "there is no gas yet")
        return self._motion

    def _set_playing(self, playing: bool) -> None:
        self._playing = playing
        self._order(self._published_state)

    def _published_state(self) -> None:
        self._running = False
        self._publish()

    def _begin(self, simulation: Simulation | None) -> None:
        try:
            if simulation is None:
                if self._prepare is not None:
                    self._prepare()
                _check(self._scenario)
                simulation = self._simulate(self._scenario)
            self._install(simulation, self._scenario)
        except Exception as error:
            self._fail(error)

    def _install(self, simulation: Simulation, scenario: Scenario) -> None:
        self._motion = Motion(simulation, self._speed)
        self._scenario = scenario
        self._version += 1
        self._light = None
        if self._version > 1:
            self._followed_id = None
        self._running = False
        self.trouble = None
        self._publish_all()

    def _fail(self, error: Exception) -> None:
        self._playing = False
        self.trouble = f"{error}" or type(error).__name__
        self.tell(protocol.notice("trouble", text=self.trouble))

    def _new_speed(self) -> None:
        if self._motion is not None:
            self._motion.speed = self._speed
        self._running = False

    def _step(self) -> None:
        try:
            self._moving().step()
        except Exception as error:
            self._fail(error)
        self._published_state()

    def _beat(self) -> float | None:
        """Between orders: move on if somebody looks. Returns when to be called again."""
        motion = self._motion
        if motion is None or not self._playing or not (self._unwatched or self.watched):
            self._running = False
            return None
        if not self._running:
            self._running = True
            motion.begin()
        try:
            pause = motion.beat()
        except Exception as error:
            self._fail(error)
            return None
        self._publish(sample=self._sample_wanted)
        return pause

    def _publish_all(self) -> None:
        """The table and a frame: for a new gas or a new browser."""
        motion = self._motion
        if motion is None:
            return
        self._generation += 1
        if self._mailbox is not None:
            species = self._scenario.species
            self._mailbox.put_text(
                protocol.table(
                    self._generation,
                    motion.simulation.geometry,
                    [one.name for one in species],
                    [float(one.radius) for one in species],
                    [str(one.color) for one in species],
                ),
                stale=True,
            )
        self._publish()

    def _publish(self, *, sample: bool = True) -> None:
        """A frame for the browser, and a copy for the charts if one is wanted."""
        motion = self._motion
        if motion is None:
            return
        self._followed, row = _find(motion.simulation, self._followed_id)
        if sample:
            self._sample_wanted = False
            self._sample = self._copy(motion)
        if self._mailbox is not None and not self._mailbox.hidden:
            self._mailbox.put_frame(protocol.encode_frame(self._frame(motion, row)))

    def _frame(self, motion: Motion, row: int) -> protocol.WireFrame:
        simulation = motion.simulation
        state, geometry = simulation.state, simulation.geometry
        return protocol.WireFrame(
            generation=self._generation,
            number=simulation.frame,
            time=simulation.time,
            width=geometry.width,
            height=geometry.height,
            playing=self._playing,
            position=state.position,  # type: ignore[arg-type]  # narrowed to float32 when encoded
            species=state.species,  # type: ignore[arg-type]
            highlight=_lit(simulation, self._light),
            followed=self._followed,
            row=row,
        )

    def _copy(self, motion: Motion) -> Sample:
        simulation = motion.simulation
        return Sample(
            version=self._version,
            scenario=self._scenario,
            geometry=simulation.geometry,
            time=simulation.time,
            frame=simulation.frame,
            state=simulation.state.copy(),
            tallies=simulation.dynamics.tallies.copy(),
            playing=self._playing,
            shown_fps=self._mailbox.shown_fps() if self._mailbox is not None else 0.0,
            keeping_up=motion.keeping_up,
            speed_reached=motion.speed_reached,
            warnings=tuple(simulation.warnings),
        )


def _check(scenario: Scenario) -> None:
    if len(scenario.species) > protocol.MAX_SPECIES:
        found, allowed = f"{len(scenario.species)} species", f"at most {protocol.MAX_SPECIES} on the page"
        raise ScenarioError([Problem("species", found, allowed)])


def _find(simulation: Simulation, particle_id: int | None) -> tuple[Followed | None, int]:
    """The disc with this id and its row, or (None, 0)."""
    state = simulation.state
    if particle_id is None:
        return None, 0
    row = int(np.searchsorted(state.id, particle_id))
    if row >= state.count or state.id[row] != particle_id:
        return None, 0
    (x, y), (vx, vy) = state.position[row].tolist(), state.velocity[row].tolist()
    return Followed(particle_id, int(state.species[row]), (x, y), (vx, vy)), row


def _lit(simulation: Simulation, light: Bin | None) -> NDArray[np.bool_] | None:
    """(n,) bool: which discs lie in the bin; None if no bin is chosen."""
    if light is None:
        return None
    state = simulation.state
    value = np.einsum("ij,ij->i", state.velocity, state.velocity)
    value = 0.5 * state.mass * value if light.quantity == "energy" else np.sqrt(value)
    lit: NDArray[np.bool_] = (state.species == light.species) & (light.low <= value) & (value < light.high)
    return lit
