"""What a demon at a gate can win, and what it must pay.

A gas in two parts, each in equilibrium by itself, has the entropy of two ideal gases in two dimensions,
S = sum_i sum_s N_si [ln(A_si/N_si) + ln T_i + 2 + ln(2 pi m_s/h²)], with h any unit of action: what stands behind T_i
depends on nothing that a demon can change. A demon that lets discs pass by what it sees of them lowers S, and no work
is done. What it saw stands in its memory, a yes or no for each decision, and a memory is finite: to forget one bit at
a temperature T needs at least the heat T ln 2, which puts ln 2 into the surroundings. So the second law holds for gas
and memory together: no demon wins more than ln 2 a bit.

Units: k_B = 1; an entropy in nats, of which ln 2 are a bit.

Source: L. Szilard, Z. Phys. 53, 840 (1929), doi:10.1007/BF01341281; R. Landauer, IBM J. Res. Dev. 5, 183 (1961),
doi:10.1147/rd.53.0183; C. H. Bennett, Int. J. Theor. Phys. 21, 905 (1982), doi:10.1007/BF02084158; C. E. Shannon, Bell
Syst. Tech. J. 27, 379 (1948), doi:10.1002/j.1538-7305.1948.tb01338.x.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

__all__ = ["BIT", "entropy_of_parts", "landauer_heat", "record_information", "work_stored"]

BIT: Final = math.log(2.0)
"""One bit, in nats: ln 2."""


def entropy_of_parts(
    count: NDArray[np.int64], area: NDArray[np.float64], temperature: NDArray[np.float64]
) -> float:
    """Entropy of an ideal gas in parts, sum N_si [ln(A_si/N_si) + ln T_i], without what stays as it is [k_B].

    Parameters
    ----------
    count : (species, parts) numbers N_si
    area : (species, parts) float64 [length²], that centres can reach
    temperature : (parts,) float64 [energy]; minus infinity comes of a part at rest
    """
    warm = np.broadcast_to(temperature, count.shape)
    there = count > 0
    with np.errstate(divide="ignore"):
        each = np.log(area[there] / count[there]) + np.log(warm[there])
    return float(np.sum(count[there] * each))


def record_information(decisions: int, let: int) -> float:
    """Least memory for a record of so many decisions, of which so many let somebody pass, n H(let/n) [nat].

    H(p) = -p ln p - (1 - p) ln(1 - p), at most ln 2: what comes as a surprise once in a while takes less room than a
    bit for each. No further decision makes it less.
    """
    rest = decisions - let
    found = decisions * math.log(decisions) if decisions else 0.0
    for part in (let, rest):
        found -= part * math.log(part) if part else 0.0
    return max(found, 0.0)


def landauer_heat(bits: float, temperature: float) -> float:
    """Heat that comes at least of forgetting so many bits, bits T ln 2 [energy].

    temperature : of the surroundings that take it [energy]
    """
    return bits * temperature * BIT


def work_stored(entropy_change: float, temperature: float) -> float:
    """Work that a gas out of balance gives at most on its way back, -T dS [energy].

    At the same energy, beside a bath: what a difference of temperature, of pressure or of composition is worth.

    Parameters
    ----------
    entropy_change : dS from balance to now [k_B]
    temperature : of the bath, which is that of the gas in balance [energy]
    """
    return -temperature * entropy_change
