"""Heat capacity from fluctuations, with k_B = 1, for the whole gas.

At fixed energy the kinetic energy fluctuates the less, the less energy the rest can take up: with f kinetic degrees of
freedom in all, mean K and variance, <dK²>/<K>² = (2/f) (1 - f/(2C)). At fixed temperature, under a thermostat that
samples the canonical ensemble, C = <dE²>/T² of the whole energy.

Means over frames that know of each other need many: the relative error is some sqrt(2/n) for n independent ones, and at
fixed energy that of 1 - f/(2C).

Source: J. L. Lebowitz, J. K. Percus and L. Verlet, Phys. Rev. 153, 250 (1967), doi:10.1103/PhysRev.153.250.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

__all__ = ["capacity_at_fixed_energy", "capacity_at_fixed_temperature"]


def capacity_at_fixed_energy(kinetic: ArrayLike, freedom: float) -> float | None:
    """C of a gas whose whole energy is fixed, from the fluctuations of its kinetic energy.

    Parameters
    ----------
    kinetic : (frames,) kinetic energies [energy], of all degrees of freedom that `freedom` counts
    freedom : as `degrees_of_freedom` counts them; of the motion of centres alone, what is left counts as the rest

    Returns
    -------
    None where the fluctuations are as large as at fixed temperature, or larger: then C is too large to tell.
    """
    energy = np.asarray(kinetic, np.float64)
    if energy.size < 2 or not np.mean(energy) > 0.0:
        return None
    rest = 1.0 - 0.5 * freedom * float(np.var(energy, ddof=1) / np.mean(energy) ** 2)
    return 0.5 * freedom / rest if rest > 0.0 else None


def capacity_at_fixed_temperature(energy: ArrayLike, temperature: float) -> float | None:
    """C of a gas at a fixed temperature [energy], from the fluctuations of its whole energy; None for fewer than two.

    Parameters
    ----------
    energy : (frames,) kinetic and potential energies together [energy]
    """
    whole = np.asarray(energy, np.float64)
    return float(np.var(whole, ddof=1)) / temperature**2 if whole.size > 1 else None
