"""LAMMPS on several ranks of MPI, which `mpiexec` starts as processes of their own."""

from __future__ import annotations

import contextlib
import socket
import subprocess
import sys
import time
import weakref
from functools import cache
from multiprocessing.connection import Connection
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gasbox.bench import lammps_rank
from gasbox.bench.lammps_rank import of_mpich

__all__ = ["LammpsRanks", "ranks_start"]

_PATIENCE = 30.0
"""Seconds in which the ranks must have started, or have ended."""


@cache
def ranks_start() -> bool:
    """Whether two ranks start here; tried once."""
    try:
        LammpsRanks(2).close()
    except OSError:
        return False
    return True


class LammpsRanks:
    """As `Lammps`, on several ranks: each order goes to all of them, and the first one's answer counts.

    Raises
    ------
    OSError
        They do not start.
    """

    def __init__(self, count: int) -> None:
        # This one forks and opens no port of the machine.
        mpiexec = of_mpich("mpiexec.gforker") or of_mpich("mpiexec")
        if mpiexec is None:
            raise FileNotFoundError("there is no mpiexec of the package mpich")
        with TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as door:
            address = str(Path(folder) / "orders")
            door.bind(address)
            door.listen(count)
            door.settimeout(0.2)
            command = [str(mpiexec), "-n", str(count), sys.executable, lammps_rank.__file__, address]
            quiet = subprocess.DEVNULL
            process = subprocess.Popen(command, stdin=quiet, stdout=quiet, stderr=quiet)
            self._ranks: list[Connection] = []
            self.close = weakref.finalize(self, _end, process, self._ranks)
            try:
                for _ in range(count):
                    self._ranks.append(_next(door, process))
            except OSError:
                self.close()
                raise
        if self.ranks() != count:
            self.close()
            raise OSError(f"LAMMPS runs on {self.ranks()} ranks instead of {count}")

    def _ask(self, name: str, *arguments: Any) -> Any:
        for rank in self._ranks:
            rank.send((name, arguments))
        first, *_ = [rank.recv() for rank in self._ranks]
        return first

    def ranks(self) -> int:
        """How many work together."""
        return int(self._ask("ranks"))

    def command(self, *lines: str) -> None:
        """Do these commands, one after another."""
        self._ask("command", *lines)

    def value(self, name: str) -> float:
        """What a keyword of `thermo_style` says now."""
        return float(self._ask("value", name))

    def place(
        self, species: NDArray[np.int64], position: NDArray[np.float64], velocity: NDArray[np.float64]
    ) -> None:
        """As `Lammps.place`; each rank keeps the atoms of its part of the box."""
        self._ask("place", species, position, velocity)


def _next(door: socket.socket, process: subprocess.Popen[bytes]) -> Connection:
    """The next rank that comes to the door.

    Raises
    ------
    OSError
        They have ended instead, or nobody comes.
    """
    end = time.monotonic() + _PATIENCE
    while time.monotonic() < end and process.poll() is None:
        with contextlib.suppress(TimeoutError):
            return Connection(door.accept()[0].detach())
    raise OSError("the ranks of LAMMPS do not start")


def _end(process: subprocess.Popen[bytes], ranks: list[Connection]) -> None:
    """Close the sockets, upon which the ranks end by themselves."""
    for rank in ranks:
        rank.close()
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(_PATIENCE)
        return
    process.kill()
    process.wait()
