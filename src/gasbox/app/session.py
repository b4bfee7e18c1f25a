"""One browser tab's gas: a simulation in a thread of its own, and what the page may ask of it.

Nothing here waits for the engine, except where it says so; orders are carried out between two beats.
"""

from __future__ import annotations

import math
import secrets
import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import TYPE_CHECKING, Any, TypeVar

from gasbox.app.audience import Audience
from gasbox.app.look import Look
from gasbox.app.mailbox import Mailbox
from gasbox.app.pace import SPEED_LIMITS
from gasbox.app.preparation import simulate
from gasbox.app.sample import Bin, Followed, Quantity, Sample
from gasbox.app.show import Show, Wishes
from gasbox.app.tandem import Home
from gasbox.app.worker import Worker, outcome
from gasbox.errors import UsageError
from gasbox.scenario import Scenario
from gasbox.state import Change

if TYPE_CHECKING:
    from gasbox.simulation import Simulation

__all__ = ["Session"]

_T = TypeVar("_T")


class Session:
    """One tab's gas. It costs nothing until `start`, which the first frame socket calls.

    Parameters
    ----------
    scenario : what to show first
    unwatched : go on also when no browser looks (otherwise time stands still then)
    prepare : called in the thread before a simulation is made; waits for the kernels
    admit : called before the thread is made; raises if there is no room
    simulate : makes the simulation of a scenario
    """

    def __init__(
        self,
        scenario: Scenario,
        *,
        unwatched: bool = False,
        prepare: Callable[[], None] = lambda: None,
        admit: Callable[[Session], None] = lambda _: None,
        simulate: Callable[[Scenario], Simulation] = simulate,
    ) -> None:
        self.id = secrets.token_urlsafe(16)
        self.origin = scenario
        """What the page showed when it was loaded; `scenario` is what it shows now."""
        self.audience = Audience()
        """The browser that looks."""
        self.charts: frozenset[str] | None = None
        """Names of the charts that were chosen beside the histograms; None: nobody has chosen."""
        self._scenario, self._wishes = scenario, Wishes()
        self._prepare, self._admit, self._simulate = prepare, admit, simulate
        self.show = Show(self._wishes, self.audience, unwatched)  # its methods are called through `ask`
        self.home: Home | None = None  # where there may be other sessions beside this one
        self._worker: Worker | None = None
        self._lock = threading.Lock()

    @property
    def scenario(self) -> Scenario:
        """What the gas was made from."""
        return self._scenario

    @property
    def playing(self) -> bool:
        """Whether time is meant to run (it stands still all the same while nobody looks)."""
        return self._wishes.playing

    @property
    def speed(self) -> float:
        """Speed that is asked for; 1 shows 60 frames of simulated time per second."""
        return self._wishes.speed

    @property
    def version(self) -> int:
        """Increases with each load and reset; 0 while the first gas is still being made."""
        return self.show.version

    @property
    def trouble(self) -> str | None:
        """Why the gas cannot go on, or could not be made."""
        return self.show.trouble

    @property
    def started(self) -> bool:
        """Whether there is (or is being made) a gas."""
        return self._worker is not None

    @property
    def watched(self) -> bool:
        """Whether a browser shows the frames: connected, visible, acks arriving."""
        return self.audience.watching

    @property
    def look(self) -> Look:
        """How discs are shown."""
        return self._wishes.look

    def start(self, simulation: Simulation | None = None) -> None:
        """Begin to work, with a gas that is at hand or a new one. Does not wait; once is enough.

        Raises
        ------
        BusyError
            There is no room (from `admit`).
        """
        if self._worker is not None:
            return
        self._admit(self)
        with self._lock:
            if self._worker is not None:
                return
            self._worker = Worker(self.show.beat, f"gasbox-{self.id[:6]}")
            self._worker.start()
            self.ask(lambda: self._begin(simulation))

    def play(self, playing: bool = True) -> None:
        """Let time run."""
        self._wishes.playing = playing
        self.ask(self.show.changed)

    def pause(self) -> None:
        """Let time stand still."""
        self.play(False)

    def toggle(self) -> None:
        """Play if paused, pause if playing."""
        self.play(not self.playing)

    def set_speed(self, speed: float) -> None:
        """Set the speed, moved into the limits of 0.1 and 100.

        Raises
        ------
        UsageError
            Not a number.
        """
        if not math.isfinite(speed):
            raise UsageError(f"speed: found {speed}; a number from {SPEED_LIMITS[0]} to {SPEED_LIMITS[1]}")
        self._wishes.speed = min(max(float(speed), SPEED_LIMITS[0]), SPEED_LIMITS[1])
        self.ask(self.show.changed)

    def step(self) -> Future[Any]:
        """One frame; pauses first."""
        self._wishes.playing = False
        return self.ask(self.show.step)

    def reset(self) -> Future[Any]:
        """Back to the start of the same scenario, with the same seed."""
        return self.ask(lambda: self.show.attempt(lambda: self._simulate(self._scenario)))

    def load(self, scenario: Scenario) -> None:
        """Replace the gas by that of another scenario or snapshot. Waits: call it outside of an event loop.

        Raises
        ------
        ScenarioError, DynamicsError
            It cannot be made; the old gas goes on untouched.
        UsageError
            The session has ended.
        """
        self._prepare()
        simulation = self._simulate(scenario)
        if self.started:
            outcome(self.ask(lambda: self._install(simulation, scenario)))
        else:
            self._scenario = scenario
            self.start(simulation)
            self.settle()

    def snapshot(self) -> Scenario:
        """The gas as it is now, to the bit. Waits: call it outside of an event loop.

        Raises
        ------
        UsageError
            There is no gas.
        """
        self.start()
        return outcome(self.ask(lambda: self.show.simulation.snapshot()))

    def settle(self, timeout: float = 30.0) -> None:
        """Wait until every order given so far is carried out."""
        outcome(self.ask(lambda: None), timeout)

    def sample(self) -> Sample | None:
        """The newest copy for charts and readouts; None while the gas is still being made.

        Never waits: a running gas makes a fresh copy after each call, a paused one after each change. So the
        copy is at most as old as the time between two calls.
        """
        self.show.sample_wanted = True
        return self.show.sample

    def highlight(self, species: int, low: float, high: float, quantity: Quantity = "speed") -> None:
        """Light up the discs of one species whose speed or energy lies in [low, high)."""
        self._wishes.light = Bin(species, low, high, quantity)
        self.ask(self.show.publish)

    def clear_highlight(self) -> None:
        """Light up nothing."""
        self._wishes.light = None
        self.ask(self.show.publish)

    def dress(self, look: Look) -> None:
        """Show discs in another way."""
        self._wishes.look = look
        self.ask(self.show.publish)

    def follow(self, particle_id: int | None) -> None:
        """Follow one particle, or none; an id that does not exist is none."""
        self._wishes.followed_id = particle_id
        self.ask(self.show.publish)

    def point(self, row: Any) -> None:
        """Tell about the particle in this row with each frame; about none for anything that is no row."""
        self._wishes.pointed_id = self.id_of_row(row)
        self.ask(self.show.publish)

    def followed(self) -> Followed | None:
        """The followed disc as last shown."""
        return self.show.followed

    def change(self, change: Change) -> Future[None]:
        """Change gravity, a wall or a setting, between two beats; what cannot be done comes out of the future."""
        return self.ask(lambda: self.show.change(change))

    def drag(self, wall: int, displacement: float) -> None:
        """Let a wall follow a hand, with bounded speed; the newest place counts."""
        self._wishes.hands = {**self._wishes.hands, wall: displacement}
        self.ask(self.show.follow_hands)

    def drop(self, wall: int) -> None:
        """The hand lets go of a wall."""
        self.ask(lambda: self.show.let_loose(wall))

    def id_of_row(self, row: Any) -> int | None:
        """The id of the disc in this row of the frame; None for anything else."""
        sample = self.show.sample
        if not isinstance(row, int) or sample is None or not 0 <= row < sample.state.count:
            return None
        return int(sample.state.id[row])

    def attach(self, mailbox: Mailbox) -> None:
        """Send frames to this mailbox from now on, and no longer to an earlier one."""
        self.audience.attach(mailbox)
        self.ask(self.show.publish_all)

    def wake(self) -> None:
        """Something may have changed about who looks."""
        if self._worker is not None and self.playing and self.watched and not self.show.running:
            self._worker.wake()

    def hand_over(self, heir: Session) -> None:
        """Give gas, speed and all to another session, and end. For a page that was loaded again. Waits."""
        simulation = outcome(self.ask(lambda: self.show.simulation))
        self.close()
        heir._scenario, heir.charts = self._scenario, self.charts
        heir._wishes.inherit(self._wishes)
        heir.start(simulation)

    def close(self) -> None:
        """End the thread and let the gas go. Waits for the beat at hand."""
        self.audience.dismiss()
        if self._worker is not None:
            self._worker.close()
            self._worker.join(5.0)
            self.show.let_go()

    def ask(self, order: Callable[[], _T]) -> Future[_T]:
        """Have something done in its thread, between two beats."""
        if self._worker is not None:
            return self._worker.ask(order)
        nothing: Future[Any] = Future()  # nobody is there yet to be asked; wishes are kept
        nothing.set_result(None)
        return nothing

    def _begin(self, simulation: Simulation | None) -> None:
        def make() -> Simulation:
            self._prepare()
            return self._simulate(self._scenario)

        self.show.attempt(make if simulation is None else lambda: simulation)

    def _install(self, simulation: Simulation, scenario: Scenario) -> None:
        self._scenario = scenario
        self._wishes.light = self._wishes.followed_id = self._wishes.pointed_id = None
        self.show.install(simulation)
