"""Discs with forces between them, by velocity Verlet."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.baths import Drive, degrees_of_freedom, drive_of
from gasbox.dynamics.changes import as_enclosure
from gasbox.dynamics.forced_discs import bodies_of, discs_of, gas_of, held, kinetic_energy, of_particles
from gasbox.dynamics.forced_memory import as_listed, put_back, remembered
from gasbox.dynamics.forced_room import Tables
from gasbox.dynamics.team import Team, fitting_threads
from gasbox.errors import DynamicsError, UsageError
from gasbox.geometry import Geometry
from gasbox.geometry.conserved import conserved_momentum
from gasbox.kernels import arguments, forced
from gasbox.kernels.hall import hall
from gasbox.protocols import Status
from gasbox.scenario import Barostat, Heating, Kind, Thermostat
from gasbox.state import Contacts, Control, Memory, State, Tallies

__all__ = ["Forced", "ForcedSettings"]

_SKIN = 0.4
"""By which lists reach beyond the largest cutoff, in units of the smallest sigma."""
_MOST = 0.25
"""Way in one step, in units of the smallest sigma, that no sensible step makes."""
# Without the JIT, NumPy would warn where kernels divide by zero in lanes that are then not chosen.
_plain = np.errstate(divide="ignore", over="ignore", invalid="ignore")


@dataclass(frozen=True)
class ForcedSettings:
    """What a forced dynamics is told.

    Attributes
    ----------
    time_step : [time]
    terms : the table of pair laws
    sigma : smallest range of a force [length]
    wall_strength : of walls that push back smoothly [energy]; 0 for walls at which discs turn round
    thermostat, barostat, heating : as the scenario has them; a thermostat has a temperature
    kinds : all kinds of particle, for what acts within molecules; may be left out without flexible ones
    """

    time_step: float
    terms: forced.Terms
    sigma: float
    wall_strength: float = 0.0
    thermostat: Thermostat | None = None
    barostat: Barostat | None = None
    heating: Heating | None = None
    kinds: tuple[Kind, ...] = ()


class Forced:
    """Velocity Verlet under forces between all discs, with thermostat, heating and barostat.

    Time exists in whole steps only: `advance` goes to the last step at or before the time asked for. Potential energy
    and virial of the present moment stand in the state, their time integrals in the tallies.

    Parameters
    ----------
    state : the particles; its arrays are changed in place
    geometry : the box, or the enclosure
    settings : forces and baths
    tallies, contacts : where energies, and collisions with walls, are booked
    memory : as `memory` gave it, for going on from a snapshot
    threads : how many work together; None takes as many as there are processors if there are many particles.
        It changes no bit.
    seed : of the random numbers of thermostats, barostat and thermal walls

    Raises
    ------
    UsageError
        Walls that move, open walls, or walls that some pass.
    """

    def __init__(
        self,
        state: State,
        geometry: Geometry,
        settings: ForcedSettings,
        tallies: Tallies,
        contacts: Contacts,
        memory: Memory | None = None,
        threads: int | None = None,
        seed: int = 0,
    ) -> None:
        self.settings = settings
        self.time_step = settings.time_step
        self.tallies = tallies
        self.contacts = contacts
        self._threads = threads
        self._seed = seed
        self._team: Team | None = None
        # Of a snapshot that goes on with another time step, only the time still holds.
        step = round(state.time / self.time_step)
        if memory and abs(int(memory["forced_step"]) * self.time_step - state.time) < 0.5 * self.time_step:
            step = int(memory["forced_step"])
        self._clock = np.array([step], np.int64)
        state.time = self._time
        self._size = geometry.size if memory is None else np.asarray(memory["box"], np.float64)
        self._said = drive_of(settings.thermostat, settings.barostat, settings.heating)
        self._drive = Drive(self._said.copy())
        if memory and np.array_equal(self._said, memory["drive_said"]):
            # Otherwise who goes on has asked for other baths.
            self._drive.values[:] = np.asarray(memory["drive"], np.float64)
        self._enter(state, geometry)
        self._begin(state, memory)

    # -- what others change ----------------------------------------------------------------------------

    def alter(self, state: State, geometry: Geometry) -> None:
        """Take over another geometry at the time of the state."""
        self._enter(state, geometry)
        self._begin(state)

    def resync(self, state: State) -> None:
        """Take over the particles of `state`."""
        self._begin(state)

    def control(self, state: State, change: Control) -> None:
        """Set thermostat, barostat or heating to something new."""
        if not self._bath.drifts_x & self._bath.drifts_y:
            self._drive.refuse_barostat(change)
        self._drive.change(change, self._time, self._temperature(state))
        # A Langevin thermostat that is switched off leaves no heat of its last step behind, to be booked again.
        self._tables.crowd.room.sums[:] = 0.0
        if self._tables.crowd.bodies is not None:
            self._tables.crowd.bodies.sums[:] = 0.0

    def _temperature(self, state: State) -> float:
        drifts = np.array([self._bath.drifts_x, self._bath.drifts_y])
        common = np.where(drifts, state.mass @ state.velocity / max(float(state.mass.sum()), 1e-300), 0.0)
        return 2.0 * kinetic_energy(state, common) / self._bath.freedom if self._bath.freedom else 0.0

    def _enter(self, state: State, geometry: Geometry) -> None:
        """Take over a geometry."""
        enclosure = as_enclosure(geometry)
        if enclosure.moves or any(wall.open or wall.passes is not None for wall in enclosure.walls):
            raise UsageError("under forces no wall moves, is open or lets some pass")
        self._geometry = geometry
        self._hall = hall(enclosure, self.tallies.pair_collisions.shape[0], self._seed)
        drifts = conserved_momentum(geometry)
        self._bath = forced.Bath(
            self._drive.values,
            np.array([self._seed & 0xFFFFFFFF, self._seed >> 32], np.int64),
            state.count,
            degrees_of_freedom(state, geometry),
            bool(drifts[0]),
            bool(drifts[1]),
        )
        gravity = np.where(geometry.periodic, 0.0, geometry.gravity)
        self._rule = forced.Rule(
            self.time_step,
            _SKIN * self.settings.sigma,
            _MOST * self.settings.sigma,
            bool(geometry.periodic_x),
            bool(geometry.periodic_y),
            float(gravity[0]),
            float(gravity[1]),
        )

    # -- tables ----------------------------------------------------------------------------------------

    def _begin(self, state: State, memory: Memory | None = None) -> None:
        """Make all tables for the particles of `state`, or as they were when `memory` was taken."""
        self._bath = self._bath._replace(
            particles=state.count, freedom=degrees_of_freedom(state, self._geometry)
        )
        discs = discs_of(state)
        threads = self._threads or fitting_threads(discs.count)
        if self._team is None or self._team.wanted != threads:
            self._team = Team(threads)
        state.turn_sites()
        bodies = bodies_of(state, self.settings.kinds)
        self._tables = Tables(
            discs if memory is None else as_listed(discs, bodies, memory),
            held(state),
            bodies,
            (float(self._size[0]), float(self._size[1])),
            (self._rule.periodic_x, self._rule.periodic_y),
            self.settings.terms.reach + self._rule.skin,
            self._team.threads,
            self._hall,
            self.settings.wall_strength,
        )
        self._books = forced.books(self.tallies)
        self._tables.crowd.room.stage[0] = forced.LIST_FIRST
        self._go(state, int(self._clock[0]))
        if memory is not None:
            put_back(self._tables, memory)
        self._go(state, int(self._clock[0]))
        self._show(state)

    # -- motion ----------------------------------------------------------------------------------------

    @property
    def _time(self) -> float:
        return float(self._clock[0]) * self.time_step

    def step_at(self, time: float) -> int:
        """The last step at or before `time`, forgiving a billionth of a step."""
        return math.floor(time / self.time_step + 1e-9)

    def advance(self, state: State, until: float) -> Status:
        """Take whole steps up to the last one at or before `until` [time]."""
        status = self._go(state, self.step_at(until))
        if status == forced.TOO_FAR:
            self._explain(state)
        state.time = self._time
        if status == arguments.FULL:
            return Status.FULL
        self._show(state)
        return Status.DONE

    def _go(self, state: State, target: int) -> int:
        """Let the kernel go on to a step, or to where it needs something other than room."""
        while (status := self._take_steps(state, target)) == forced.GROW:
            self._tables.grow()
        return status

    @_plain
    def _take_steps(self, state: State, target: int) -> int:
        """Let the kernel go on to a step, or to where it needs something."""
        assert self._team is not None
        count, gas = np.array([self.contacts.count], np.int64), gas_of(state)
        # Whoever goes on with a run may have given it other tallies.
        self._books = forced.books(self.tallies)._replace(now=self._books.now)
        status = self._team.run(
            forced.advance,
            self._tables.crowd,
            self.settings.terms,
            self._rule,
            self._bath,
            gas,
            self._tables.walls,
            arguments.ledger(self.tallies, self.contacts, count, state)._replace(id=gas.id),
            self._books,
            self._clock,
            target,
        )
        self.contacts.count = int(count[0])
        return status

    def _explain(self, state: State) -> None:
        """Say that the step is too long, before numbers turn into nonsense.

        Raises
        ------
        DynamicsError
            Always.
        """
        speed = math.sqrt(2.0 * self._books.now[2] / max(float(state.mass.sum()), 1e-300))
        raise DynamicsError(
            f"at time {self._time:g} a disc flew further than {self._rule.most:.3g} in one step of "
            f"{self.time_step:g}: the time step is too long for these forces and speeds (rms speed {speed:.3g} at "
            f"the last measurement); shorten dynamics.time_step, say to {self.time_step / 4:.2g}"
        )

    def _show(self, state: State) -> None:
        """Energies, and the size of a box that a barostat has changed."""
        if state.sites is not None and self._tables.crowd.bodies is None:
            state.sites.position[:], state.sites.velocity[:] = state.position, state.velocity
        state.potential, state.virial = float(self._books.now[0]), float(self._books.now[1])
        self._size = np.array(self._tables.size)
        if self._drive.has_barostat or np.any(self._size != self._geometry.size):
            change = self._size - self._geometry.size
            state.wall_displacement = np.array([0.0, change[0], 0.0, change[1]])
            state.wall_velocity = np.zeros(4)

    def forces(self, state: State) -> NDArray[np.float64]:
        """(n, 2) float64 [mass·length/time²]: force on each particle now, in the order of the state."""
        return self.forces_and_torques(state)[0]

    def forces_and_torques(self, state: State) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The same, and (n,) float64 [energy]: torque on each about its centre of mass."""
        atoms = self._tables.crowd.atoms
        return of_particles(state, self._tables.by_row(atoms.fx, atoms.fy))

    def memory(self) -> Memory:
        """What goes on with the same bits.

        ``forced_step``: steps done; places, as `gasbox.dynamics.forced_memory.remembered` has them; ``box`` (2,): its
        size; ``drive``: aims of thermostat and barostat; ``drive_said``: those that the scenario says.
        """
        return {
            "forced_step": int(self._clock[0]),
            **remembered(self._tables),
            "box": self._size.copy(),
            "drive": self._drive.values.copy(),
            "drive_said": self._said.copy(),
        }
