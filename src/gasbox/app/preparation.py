"""Before a gas moves: compiling the kernels in the background, while the page is already there, and making the gas."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from gasbox.errors import DynamicsError
from gasbox.scenario import Scenario

if TYPE_CHECKING:
    from gasbox.simulation import Simulation

__all__ = ["Preparation", "simulate"]

Progress = Callable[[int, int, str], None]


def _compile(progress: Progress | None) -> Any:
    from gasbox.compiling import compile_kernels

    return compile_kernels(progress)


def simulate(scenario: Scenario) -> Simulation:
    """The gas of a scenario; once the kernels are compiled."""
    # Imported here: numba and the kernels come in while the page is already being served.
    from gasbox.simulation import Simulation

    # One thread: the other processors are for the frames, the charts and the browser.
    return Simulation(scenario, threads=1)


class Preparation:
    """Runs `compile_kernels` once in a thread; sessions wait for its end before they make a gas.

    Parameters
    ----------
    tell : called in the thread with (done, total, name) for each kernel
    compile_kernels : the work itself
    """

    def __init__(self, tell: Progress, compile_kernels: Callable[[Progress | None], Any] = _compile) -> None:
        self._tell = tell
        self._compile = compile_kernels
        self._finished = threading.Event()
        self._error: Exception | None = None
        self._thread = threading.Thread(target=self._work, name="gasbox-kernels", daemon=True)

    def start(self) -> None:
        """Begin, in the background."""
        self._thread.start()

    def wait(self) -> None:
        """Wait for the end.

        Raises
        ------
        DynamicsError
            The kernels could not be compiled.
        """
        self._finished.wait()
        if self._error is not None:
            raise DynamicsError(f"the kernels could not be compiled: {self._error}") from self._error

    @property
    def finished(self) -> bool:
        """Whether a gas can be made now."""
        return self._finished.is_set()

    def _work(self) -> None:
        try:
            self._compile(self._tell)
        except Exception as error:
            self._error = error
        finally:
            self._finished.set()
