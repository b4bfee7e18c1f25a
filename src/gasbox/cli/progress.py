"""Progress on standard error, for people only: nothing is drawn where nobody looks."""

from __future__ import annotations

import math
import time
from types import TracebackType

from rich.console import Console
from rich.progress import BarColumn, TaskProgressColumn, TextColumn, TimeElapsedColumn, TimeRemainingColumn
from rich.progress import Progress as Bar

__all__ = ["Progress", "compile_first"]

_SECONDS = 0.1


class Progress:
    """A bar over simulated time; use it as a context manager.

    Parameters
    ----------
    start, end : of the run [time]; an infinite end is that of Ctrl-C
    what : is counted, if not simulated time
    per_second : whether to show how many there are in a second, too
    """

    def __init__(self, start: float, end: float, what: str = "time", per_second: bool = False) -> None:
        self._start, self._drawn_at, self._begun_at = start, 0.0, time.monotonic()
        console = Console(stderr=True)
        self._bar = Bar(
            TextColumn(what + " {task.fields[time]:g}"),
            BarColumn(),
            TaskProgressColumn(),
            *([TextColumn("{task.fields[rate]:.3g} a second")] if per_second else []),
            TimeElapsedColumn(),
            TextColumn("left"),
            TimeRemainingColumn(),
            console=console,
            transient=True,
            disable=not console.is_terminal,
        )
        total = end - start if math.isfinite(end) else None
        self._task = self._bar.add_task("run", total=total, time=start, rate=0.0)

    def __enter__(self) -> Progress:
        self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._bar.stop()

    def show(self, now: float) -> None:
        """Draw the simulated time, unless that was just done."""
        moment = time.monotonic()
        if moment - self._drawn_at >= _SECONDS:
            self._drawn_at = moment
            rate = (now - self._start) / max(moment - self._begun_at, _SECONDS)
            self._bar.update(self._task, completed=now - self._start, time=now, rate=rate)


def compile_first() -> None:
    """Compile or load the kernels, so that a run is not held up; says so when it takes long."""
    from gasbox.compiling import compile_kernels
    from gasbox.jit import was_compiled

    if was_compiled():
        compile_kernels()
        return
    console = Console(stderr=True)
    console.print("Compiling kernels for this machine: at the first start only, some minutes.")
    with Bar(console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task("", total=None)
        compile_kernels(
            lambda done, total, name: bar.update(task, completed=done, total=total, description=name)
        )
