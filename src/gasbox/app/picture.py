"""From a simulation to what goes out: wire frames for the browser, copies for the charts. Plain functions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from gasbox.app import protocol
from gasbox.app.aims import walls_move
from gasbox.app.look import Look
from gasbox.app.molecule_numbers import energies_of
from gasbox.app.sample import Bin, Followed
from gasbox.geometry import Enclosure
from gasbox.observe import temperature
from gasbox.observe.histograms import values
from gasbox.scenario import Demon
from gasbox.state import Sites

if TYPE_CHECKING:
    from gasbox.simulation import Simulation

__all__ = ["find", "frame", "lit", "table"]


def table(simulation: Simulation, generation: int) -> str:
    """The text message with the surroundings and the species."""
    scenario = simulation.scenario
    # Beside a demon walls stay where they are.
    handles = walls_move(scenario) and not isinstance(scenario.world, Demon)
    return protocol.table(generation, simulation.geometry, scenario, handles=handles)


def frame(
    simulation: Simulation,
    *,
    generation: int,
    number: int,
    playing: bool,
    light: Bin | None,
    followed_id: int | None,
    pointed_id: int | None,
    look: Look,
    shades: NDArray[np.uint8] | None,
) -> bytes:
    """The binary message with all particles as they are now; `shades` (n,) are what `look` asks for."""
    state, geometry = simulation.state, simulation.geometry
    followed, row = find(simulation, followed_id)
    pointed, pointed_row = find(simulation, pointed_id)
    return protocol.encode_frame(
        protocol.WireFrame(
            generation=generation,
            number=number,
            time=simulation.time,
            width=geometry.width,
            height=geometry.height,
            playing=playing,
            position=state.position.astype(np.float32),
            species=state.species.astype(np.uint8),
            highlight=None if light is None else lit(simulation, light),
            followed=followed,
            row=row,
            temperature=_warmth(simulation),
            displacement=state.wall_displacement.astype(np.float32),
            coloring=look.coloring,
            shades=shades,
            bonds=look.bonds,
            angle=None if state.sites is None else _angles(state.angle),
            places=None if state.sites is None else _soft_places(state.sites),
            pointed=pointed,
            pointed_row=pointed_row,
        )
    )


def _angles(angle: NDArray[np.float64]) -> NDArray[np.float32]:
    """(n,) float32 [rad], the same directions from -pi to pi, so that no digits are lost after many turns."""
    return np.remainder(angle + np.pi, 2.0 * np.pi).astype(np.float32) - np.float32(np.pi)


def _soft_places(sites: Sites) -> NDArray[np.float32]:
    """(m, 2) float32 [length]: where the discs of flexible molecules are."""
    return sites.position[sites.flexible[sites.owner]].astype(np.float32)


def _warmth(simulation: Simulation) -> float:
    """Temperature of the gas [energy], where a thermal wall is coloured by it; else, or if there is none, 0."""
    geometry = simulation.geometry
    if not isinstance(geometry, Enclosure) or all(wall.temperature is None for wall in geometry.walls):
        return 0.0
    return temperature(simulation.state, geometry) or 0.0


def find(simulation: Simulation, particle_id: int | None) -> tuple[Followed | None, int]:
    """The particle with this id and its row, or (None, 0)."""
    state = simulation.state
    if particle_id is None:
        return None, 0
    row = int(np.searchsorted(state.id, particle_id))
    if row >= state.count or state.id[row] != particle_id:
        return None, 0
    (x, y), (vx, vy) = state.position[row].tolist(), state.velocity[row].tolist()
    energies = energies_of(state, row)
    return Followed(int(state.id[row]), int(state.species[row]), (x, y), (vx, vy), energies), row


def lit(simulation: Simulation, light: Bin) -> NDArray[np.bool_]:
    """(n,) bool: which particles lie in the bin."""
    state = simulation.state
    mine: NDArray[np.bool_] = state.species == light.species
    value = values(state, light.species, light.quantity)
    if value.size == np.count_nonzero(mine):  # else they do not turn, and have nothing of it
        mine[mine] = (light.low <= value) & (value < light.high)
        return mine
    return np.zeros(state.count, np.bool_)
