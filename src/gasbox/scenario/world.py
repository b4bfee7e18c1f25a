"""Rules on top of a gas: which there are."""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import Field

from gasbox.scenario.demon import Demon
from gasbox.scenario.epidemic import Epidemic
from gasbox.scenario.pong import Pong

__all__ = ["WORLDS", "World"]

WORLDS: Final[dict[str, type[Pong] | type[Epidemic] | type[Demon]]] = {
    "pong": Pong,
    "epidemic": Epidemic,
    "demon": Demon,
}

World = Annotated[Pong | Epidemic | Demon, Field(discriminator="kind")]
