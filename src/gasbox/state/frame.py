"""One frame of a run: what the loop hands to files, pictures and readers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gasbox.state.state import State
from gasbox.state.tallies import Tallies

__all__ = ["Frame", "Memory"]

Memory = dict[str, Any]
"""What a dynamics must know, beside the state, to go on with the same bits: name -> numpy array or number.

Event-driven: ``epoch`` (int), ``position`` (n, 2), ``velocity`` (n, 2), ``time`` (n,): the references.
Stepped: ``step`` (int).
"""


@dataclass(frozen=True)
class Frame:
    """The gas at a frame boundary. The arrays are the simulation's own: copy what is to be kept.

    Attributes
    ----------
    number : frames since the start of this run, 0 for the start itself
    state : the particles
    tallies : sums since the start of the scenario
    memory : what makes the run resumable from here, to the bit
    """

    number: int
    state: State
    tallies: Tallies
    memory: Memory
