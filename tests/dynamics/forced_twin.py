"""The slow twin of the forced rule: all pairs and all periodic images, in plain NumPy, nothing of the engine."""

from __future__ import annotations

import itertools
import math

import numpy as np

from gasbox.scenario import Scenario, pair_laws
from gasbox.state import State


def _powers(r, law, core, well):
    twelfth, sixth = (law.sigma / r) ** 12, (law.sigma / r) ** 6
    energy = law.epsilon * (core * twelfth - well * sixth)
    return energy, law.epsilon * (12 * core * twelfth - 6 * well * sixth) / r


def _yukawa(r, law):
    energy = law.epsilon * law.sigma / r * np.exp((law.sigma - r) / law.screening_length)
    return energy, energy / r + energy / law.screening_length


def _square_well(r, law):
    core = (law.sigma / r) ** 36
    rise = np.exp(40.0 * (r / law.sigma - law.reach))
    energy = law.epsilon * (core - 1.0 / (1.0 + rise))
    return energy, law.epsilon * (36.0 * core / r - 40.0 / law.sigma * rise / (1.0 + rise) ** 2)


LAWS = {
    "lennard-jones": lambda r, law: _powers(r, law, 4.0, 4.0),
    "wca": lambda r, law: _powers(r, law, 4.0, 4.0),
    "soft-sphere": lambda r, law: _powers(r, law, 1.0, 0.0),
    "square-well": _square_well,
    "yukawa": _yukawa,
    "none": lambda r, law: (0.0 * r, 0.0 * r),
}
"""Energy, and force (repulsive > 0), of each law at a distance, without an end."""


def cut_off(whole, r, cutoff, shifts_force):
    """Energy and force at distances r of a law that ends at a cutoff."""
    energy, force = whole(r)
    at_end, pull = (float(value) for value in whole(np.float64(cutoff)))
    energy = energy - at_end
    if shifts_force:
        energy, force = energy + pull * (r - cutoff), force - pull
    return np.where(r < cutoff, energy, 0.0), np.where(r < cutoff, force, 0.0)


class Twin:
    """Forces of a scenario between discs of a state, in a box that is `size` large."""

    def __init__(self, scenario: Scenario, state: State, size=None) -> None:
        geometry = scenario.geometry()
        self.laws = pair_laws(scenario)
        self.charges = scenario.forces.charges if scenario.forces else None
        self.charge = np.array([entry.charge or 0.0 for entry in scenario.site_kinds])
        self.species = state.species
        self.mass = state.mass[:, None]
        self.size = np.array(geometry.size if size is None else size)
        self.periodic = geometry.periodic
        self.reach = max(law.cutoff for law in self.laws.values())
        if self.charges is not None:
            self.reach = max(self.reach, self.charges.cutoff)

    def _images(self, position):
        """Shifts of all images that may matter."""
        times = [math.ceil(self.reach / self.size[axis]) + 1 if self.periodic[axis] else 0 for axis in (0, 1)]
        return itertools.product(*(range(-count, count + 1) for count in times))

    def push(self, position):
        """Forces (n, 2), potential energy, and virial of discs at these places."""
        n = position.shape[0]
        forces, potential, virial = np.zeros((n, 2)), 0.0, 0.0
        for image in self._images(position):
            d = position[:, None] - position[None, :] + np.array(image) * self.size
            r = np.hypot(d[..., 0], d[..., 1])
            if image == (0, 0):
                np.fill_diagonal(r, np.inf)
            near = r < self.reach
            if not near.any():
                continue
            rows, others = np.nonzero(near)
            energy, force = self._pairs(rows, others, r[near])
            np.add.at(forces, rows, d[near] * (force / r[near])[:, None])
            potential += 0.5 * math.fsum(energy)
            virial += 0.5 * math.fsum(force * r[near])
        return forces, potential, virial

    def _pairs(self, rows, others, r):
        low = np.minimum(self.species[rows], self.species[others])
        high = np.maximum(self.species[rows], self.species[others])
        energy, force = np.zeros(r.size), np.zeros(r.size)
        for (a, b), law in self.laws.items():
            those = (low == a) & (high == b)
            if law.law != "none":
                u, f = cut_off(
                    lambda x, law=law: LAWS[law.law](x, law),
                    r[those],
                    law.cutoff,
                    law.truncation == "force-shifted",
                )
                energy[those], force[those] = energy[those] + u, force[those] + f
            if self.charges is not None:
                strength = self.charges.strength * self.charge[a] * self.charge[b]
                length = self.charges.screening_length

                def screened(x, strength=strength, length=length):
                    u = strength * np.exp(-x / length) / x
                    return u, u * (1.0 / x + 1.0 / length)

                u, f = cut_off(screened, r[those], self.charges.cutoff, True)
                energy[those], force[those] = energy[those] + u, force[those] + f
        return energy, force

    def steps(self, position, velocity, time_step, count):
        """Places, not brought back into the box, and velocities after some steps of velocity Verlet."""
        position, velocity = position.copy(), velocity.copy()
        forces = self.push(position)[0]
        for _ in range(count):
            velocity += 0.5 * time_step * forces / self.mass
            position += time_step * velocity
            forces = self.push(position)[0]
            velocity += 0.5 * time_step * forces / self.mass
        return position, velocity
