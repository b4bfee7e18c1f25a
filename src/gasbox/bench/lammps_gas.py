"""The fluid of `gasbox.bench.scenarios.fluid` in LAMMPS, the fastest that it can be there."""

from __future__ import annotations

import time
from functools import cache
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray

from gasbox.bench.lammps_rank import Lammps
from gasbox.bench.lammps_ranks import LammpsRanks
from gasbox.initial import populate
from gasbox.scenario import Forced, Scenario

__all__ = ["LammpsGas", "lammps_starts", "lennard_jones", "periodic_box"]

_LISTS: Final = ((0.2, 0), (0.3, 0), (0.3, 5), (0.4, 5), (0.5, 5))
"""Skins of the list of neighbours [length], with steps in which nobody asks whether it is still good."""
_TRIALS = 2
_FEWEST_STEPS, _MOST_STEPS, _TRIED_STEPS = 40, 300, 300_000


class Program(Protocol):
    """What `Lammps` and `LammpsRanks` have in common."""

    def command(self, *lines: str) -> None:
        """Do these commands."""
        ...

    def value(self, name: str) -> float:
        """What a keyword of `thermo_style` says now."""
        ...

    def place(
        self, species: NDArray[np.int64], position: NDArray[np.float64], velocity: NDArray[np.float64]
    ) -> None:
        """Make atoms."""
        ...


@cache
def lammps_starts() -> bool:
    """Whether LAMMPS is installed and finds an MPI."""
    try:
        Lammps().close()
    except (ImportError, OSError):
        return False
    return True


def periodic_box(width: float, height: float, types: int = 1, style: str = "atomic") -> list[str]:
    """The commands for an empty flat periodic box [length], for atoms of so many types, in a style of LAMMPS."""
    return [
        "units lj",
        "dimension 2",
        f"atom_style {style}",
        "boundary p p p",
        f"region box block 0 {width!r} 0 {height!r} -0.5 0.5",
        f"create_box {types} box",
    ]


def lennard_jones(scenario: Scenario) -> list[str]:
    """The commands for the law of the fluids, and for the time step of a scenario."""
    assert isinstance(scenario.dynamics, Forced)
    return [
        "pair_style lj/cut 2.5",
        "pair_coeff 1 1 1.0 1.0",
        "pair_modify shift yes",
        f"timestep {scenario.dynamics.time_step!r}",
        # Otherwise the last step of each run would add up energies for nobody.
        "thermo_style custom step",
    ]


class LammpsGas:
    """Truncated and shifted Lennard-Jones (`lj/cut`), velocity Verlet (`fix nve`), in double precision.

    Of `_LISTS` it keeps the list of neighbours that is fastest in a trial and never found that it came too late.

    Attributes
    ----------
    skin : of the list of neighbours [length]
    delay : steps in which a new list is not asked whether it is still good
    """

    def __init__(self, scenario: Scenario, ranks: int = 1) -> None:
        self.name = "LAMMPS" if ranks == 1 else f"LAMMPS, {ranks} ranks"
        self.program: Program = Lammps() if ranks == 1 else LammpsRanks(ranks)
        self._particles = self._set_up(scenario)
        self.skin, self.delay = self._fastest_list()
        self._use_list(self.skin, self.delay)

    def _set_up(self, scenario: Scenario) -> int:
        """Make the fluid; how many particles it has."""
        state, box = populate(scenario), scenario.geometry()
        self.program.command(*periodic_box(float(box.width), float(box.height)))
        self.program.place(np.ones(state.count, np.int64), state.position, state.velocity)
        self.program.command("mass 1 1.0", *lennard_jones(scenario), "fix motion all nve")
        return state.count

    def work(self, portions: int) -> float:
        """Steps times particles."""
        self.program.command(f"run {portions} pre no post no")
        return float(portions * self._particles)

    def late_lists(self) -> int:
        """How often the list of neighbours in use may have come too late."""
        return round(self.program.value("ndanger"))

    def _use_list(self, skin: float, delay: int) -> None:
        self.program.command(
            f"neighbor {skin} bin", f"neigh_modify every 1 delay {delay} check yes", "run 0 post no"
        )

    def _fastest_list(self) -> tuple[float, int]:
        steps = min(max(_FEWEST_STEPS, _TRIED_STEPS // self._particles), _MOST_STEPS)
        least = dict.fromkeys(_LISTS, float("inf"))
        for _ in range(_TRIALS):
            for skin, delay in _LISTS:
                self._use_list(skin, delay)
                begin = time.perf_counter()
                self.work(steps)
                spent = time.perf_counter() - begin
                least[skin, delay] = min(
                    least[skin, delay], spent if self.late_lists() == 0 else float("inf")
                )
        return min(least, key=least.__getitem__)
