"""Discs with forces between them, by velocity Verlet."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.baths import Drive, degrees_of_freedom, drive_of
from gasbox.dynamics.forced_discs import bodies_of, discs_of, gas_of, held, kinetic_energy, of_particles
from gasbox.dynamics.forced_memory import as_listed, listed_walls, put_back, remembered
from gasbox.dynamics.forced_room import Tables
from gasbox.dynamics.forced_surroundings import surroundings
from gasbox.dynamics.halls import turn_paths
from gasbox.dynamics.mishaps import step_too_long
from gasbox.dynamics.team import Team, fitting_threads
from gasbox.errors import DynamicsError
from gasbox.geometry import Geometry
from gasbox.kernels import arguments, forced
from gasbox.protocols import Status
from gasbox.scenario import Barostat, Heating, Kind, Thermostat
from gasbox.state import Contacts, Control, Memory, State, Tallies

__all__ = ["Forced", "ForcedSettings"]

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
    strength : largest epsilon of all pairs [energy], by which forces are measured that are extreme
    """

    time_step: float
    terms: forced.Terms
    sigma: float
    wall_strength: float = 0.0
    thermostat: Thermostat | None = None
    barostat: Barostat | None = None
    heating: Heating | None = None
    kinds: tuple[Kind, ...] = ()
    strength: float = 0.0


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
        Walls that forces have no answer to: pistons, and some more where there are molecules or smooth walls.
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
        self._enter(state, geometry, memory)
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

    def _enter(self, state: State, geometry: Geometry, memory: Memory | None = None) -> None:
        """Take over a geometry; walls that move go on as remembered, or from where the state has them."""
        rows = memory.get("walls") if memory else None
        self._geometry = geometry
        self._around = surroundings(
            state,
            geometry,
            self.time_step,
            self.settings.sigma,
            self.settings.wall_strength > 0.0,
            self._drive.values,
            self.tallies.pair_collisions.shape[0],
            self._seed,
            None if rows is None else np.asarray(rows, np.float64),
        )
        self._bath, self._rule = self._around.bath, self._around.rule

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
            self._around.hall,
            self.settings.wall_strength,
        )
        if self._geometry.moves:
            self._tables.stand(self._time, listed_walls(memory))
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
        if status in (forced.TOO_FAR, forced.WALL_TOO_FAR):
            self._explain(status == forced.WALL_TOO_FAR)
        state.time = self._time
        if status == arguments.FULL:
            return Status.FULL
        self._show(state)
        return Status.DONE

    def _go(self, state: State, target: int) -> int:
        """Let the kernel go on to a step, or to where it needs what only others can give."""
        while True:
            step, stop = int(self._clock[0]), target
            if step < target:
                stop = min(stop, turn_paths(self._around.hall, self._around.enclosure, step, self.time_step))
            status = self._take_steps(state, stop)
            if status == forced.GROW:
                self._tables.grow()
            elif status == forced.LEFT:
                state.keep(self._tables.walls.gone == 0)
                self._begin(state)
            elif status != arguments.DONE or self._clock[0] >= target:
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

    def _explain(self, by_wall: bool) -> None:
        """Say that the step is too long, before numbers turn into nonsense.

        Raises
        ------
        DynamicsError
            Always.
        """
        mass = float(self._tables.crowd.atoms.mass.sum())
        speed = math.sqrt(2.0 * self._books.now[2] / max(mass, 1e-300))
        raise DynamicsError(step_too_long(self._time, self.time_step, self._rule.most, speed, by_wall))

    def _show(self, state: State) -> None:
        """Energies, and the size of a box that a barostat has changed."""
        if state.sites is not None and self._tables.crowd.bodies is None:
            state.sites.position[:], state.sites.velocity[:] = state.position, state.velocity
        state.potential, state.virial = float(self._books.now[0]), float(self._books.now[1])
        if self._geometry.moves:
            state.wall_displacement = self._tables.walls.place.copy()
            state.wall_velocity = self._tables.walls.rate.copy()
            return
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
            **remembered(self._tables, self._geometry.moves),
            "box": self._size.copy(),
            "drive": self._drive.values.copy(),
            "drive_said": self._said.copy(),
        }
