"""One look at all people: whose stage is over, and who infects how much. Symbols: i person."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel
from gasbox.kernels.epidemic.stages import ASYMPTOMATIC, INFECTIOUS

__all__ = ["look"]


@bare_kernel
def look(
    stage: NDArray[np.int8],
    until: NDArray[np.float64],
    free_until: NDArray[np.float64],
    counted: NDArray[np.float64],
    time: float,
    weaker: float,
    who: NDArray[np.int64],
    weight: NDArray[np.float64],
    over: NDArray[np.int64],
    count: NDArray[np.int64],
) -> None:
    """Find those who infect others, for how long since the last look, and those whose stage is over.

    Parameters
    ----------
    stage : (n,) int8
    until : (n,) float64 [time], end of the present stage
    free_until : (n,) float64 [time], from when on one who is kept apart infects nobody
    counted : (n,) float64 [time], up to which the infectious time was counted; moved on
    time : now [time]
    weaker : infectiousness of those without symptoms
    who : (n,) int64, written: rows of those who infect, ascending
    weight : (n,) float64 [time], written for each of these: infectious time since the last look, times infectiousness
    over : (n,) int64, written: rows of those whose infectious time is over, ascending
    count : (3,) int64, written: of `who`, of `over`, of those with symptoms
    """
    infectious, ended, cases = 0, 0, 0
    for i in range(stage.shape[0]):
        if stage[i] != INFECTIOUS and stage[i] != ASYMPTOMATIC:
            continue
        cases += stage[i] == INFECTIOUS
        end = min(time, until[i], free_until[i])
        if end > counted[i]:
            who[infectious] = i
            weight[infectious] = (end - counted[i]) * (weaker if stage[i] == ASYMPTOMATIC else 1.0)
            infectious += 1
            counted[i] = end
        if until[i] <= time:
            over[ended] = i
            ended += 1
    count[0], count[1], count[2] = infectious, ended, cases
