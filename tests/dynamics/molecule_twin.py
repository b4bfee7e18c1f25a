"""The slow twin of molecules under forces: all pairs of discs and all images, bonds and angles, in plain NumPy."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
from forced_twin import Twin

from gasbox.scenario import Scenario
from gasbox.state import State


def rotated(place, angle):
    """Places in a molecule (k, 2), turned."""
    cos, sin = math.cos(angle), math.sin(angle)
    return place @ np.array([[cos, sin], [-sin, cos]])


class MoleculeTwin:
    """Forces on discs, energy, and the virial of molecules, of a state of a scenario."""

    def __init__(self, scenario: Scenario, state: State, size=None) -> None:
        sites = state.sites
        discs = replace(state, species=sites.species, mass=sites.mass)
        self.pairs = Twin(scenario, discs, size)
        self.owner, self.mass = sites.owner, sites.mass
        self.kinds = [scenario.kinds[k] for k in state.species]
        self.first = sites.first
        self.count = state.count
        self.free = self._free()

    def _free(self):
        """(m, m) bool: discs that feel each other's pair force although they are of one molecule."""
        free = np.zeros((self.owner.size, self.owner.size), bool)
        for row, kind in enumerate(self.kinds):
            if not kind.flexible:
                continue
            tied = [set(bond.atoms) for bond in kind.bonds]
            tied += [{bend.atoms[0], bend.atoms[2]} for bend in kind.angles]
            for one, other in itertools.permutations(range(len(kind.sites)), 2):
                free[self.first[row] + one, self.first[row] + other] = {one, other} not in tied
        return free

    def centres(self, position):
        """Centres of mass (n, 2) of molecules whose discs stand at these places (m, 2)."""
        whole = np.bincount(self.owner, self.mass)
        return (
            np.stack([np.bincount(self.owner, self.mass * column) for column in position.T], axis=1)
            / whole[:, None]
        )

    def push(self, position):
        """Forces (m, 2), potential energy, and virial, of discs (m, 2) that stand beside their molecules."""
        twin, m = self.pairs, len(position)
        forces, potential, virial = np.zeros((m, 2)), 0.0, 0.0
        centre = self.centres(position)[self.owner]
        for image in twin._images(position):
            shift = np.array(image) * twin.size
            d = position[:, None] - position[None, :] + shift
            r = np.hypot(d[..., 0], d[..., 1])
            apart = centre[:, None] - centre[None, :] + shift
            if image == (0, 0):
                r[(self.owner[:, None] == self.owner[None, :]) & ~self.free] = np.inf
            rows, others = np.nonzero(r < twin.reach)
            energy, force = twin._pairs(rows, others, r[rows, others])
            vectors = d[rows, others] * (force / r[rows, others])[:, None]
            np.add.at(forces, rows, vectors)
            potential += 0.5 * math.fsum(energy)
            virial += 0.5 * math.fsum(np.sum(vectors * apart[rows, others], axis=1))
        inner, energy = self._inner(position)
        return forces + inner, potential + energy, virial

    def _inner(self, position):
        """Forces and energy of bonds and angles."""
        forces, potential = np.zeros(position.shape), 0.0
        for row, kind in enumerate(self.kinds):
            first = self.first[row]
            if not kind.flexible:
                continue
            for bond in kind.bonds:
                a, b = (first + atom for atom in bond.atoms)
                d = position[a] - position[b]
                r = np.hypot(*d)
                potential += 0.5 * bond.stiffness * (r - bond.length) ** 2
                forces[a] -= bond.stiffness * (r - bond.length) * d / r
                forces[b] += bond.stiffness * (r - bond.length) * d / r
            for bend in kind.angles:
                a, b, c = (first + atom for atom in bend.atoms)
                one, other = position[a] - position[b], position[c] - position[b]
                r, s = np.hypot(*one), np.hypot(*other)
                cosine = one @ other / (r * s)
                angle = math.acos(cosine)
                wider = angle - math.radians(bend.angle)
                potential += 0.5 * bend.stiffness * wider**2
                slope = bend.stiffness * wider / math.sin(angle)
                of_one = slope * (other / (r * s) - cosine * one / r**2)
                of_other = slope * (one / (r * s) - cosine * other / s**2)
                forces[a] += of_one
                forces[c] += of_other
                forces[b] -= of_one + of_other
        return forces, potential

    def torques(self, position, forces):
        """Force (n, 2) and torque (n,) on each molecule."""
        arm = position - self.centres(position)[self.owner]
        moment = arm[:, 0] * forces[:, 1] - arm[:, 1] * forces[:, 0]
        whole = [np.bincount(self.owner, column) for column in (*forces.T, moment)]
        return np.stack(whole[:2], axis=1), whole[2]
