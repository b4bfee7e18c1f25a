"""Who else computes a Lennard-Jones fluid: LAMMPS, on one core or two ranks, and OpenMM if it happens to be there."""

from __future__ import annotations

import importlib
from importlib.util import find_spec
from typing import Any

import numpy as np

from gasbox.bench.contest import Contender
from gasbox.bench.lammps_gas import LammpsGas, lammps_starts
from gasbox.bench.lammps_ranks import ranks_start
from gasbox.initial import populate
from gasbox.scenario import Forced, Scenario

__all__ = ["OpenMMGas", "fluid_peers", "missing_fluid_peers"]


def fluid_peers(scenario: Scenario, threads: int) -> list[Contender]:
    """The peers that start, each with the same fluid, for so many threads or ranks."""
    peers: list[Contender] = []
    if lammps_starts() and (threads == 1 or ranks_start()):
        peers.append(LammpsGas(scenario, threads))
    if find_spec("openmm") is not None:
        peers.append(OpenMMGas(scenario, threads))
    return peers


def missing_fluid_peers() -> list[str]:
    """Names of the packages that are not installed, or do not start, of those that peers need."""
    if not lammps_starts():
        return ["lammps"]
    return [] if ranks_start() else ["mpich"]


class OpenMMGas:
    """The same in OpenMM on the processor: single precision, and a box as deep as it must be, all atoms in one plane.

    Its law is cut off and not shifted, which moves no atom.
    """

    _DEPTH = 6.0
    """At least two cutoffs."""

    def __init__(self, scenario: Scenario, threads: int = 1) -> None:
        assert isinstance(scenario.dynamics, Forced)
        self.name = "OpenMM" if threads == 1 else f"OpenMM, {threads} threads"
        # Not imported by name, for no extra asks for it.
        openmm: Any = importlib.import_module("openmm")
        state, box = populate(scenario), scenario.geometry()
        system, force = openmm.System(), openmm.NonbondedForce()
        system.setDefaultPeriodicBoxVectors(
            (float(box.width), 0, 0), (0, float(box.height), 0), (0, 0, self._DEPTH)
        )
        force.setNonbondedMethod(openmm.NonbondedForce.CutoffPeriodic)
        force.setCutoffDistance(2.5)
        force.setUseDispersionCorrection(False)
        for _ in range(state.count):
            system.addParticle(1.0)
            force.addParticle(0.0, 1.0, 1.0)
        system.addForce(force)
        self._motion = openmm.VerletIntegrator(scenario.dynamics.time_step)
        platform = openmm.Platform.getPlatformByName("CPU")
        self.context = openmm.Context(system, self._motion, platform, {"Threads": str(threads)})
        flat = np.zeros((state.count, 1))
        self.context.setPositions(np.hstack([state.position, flat]))
        self.context.setVelocities(np.hstack([state.velocity, flat]))
        self._particles = state.count

    def work(self, portions: int) -> float:
        """Steps times particles."""
        self._motion.step(portions)
        return float(portions * self._particles)
