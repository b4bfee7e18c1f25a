"""The menu that lays another table of pong: a new game begins on it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

from nicegui import run, ui

from gasbox.app.session import Session
from gasbox.errors import GasboxError
from gasbox.scenario import Scenario, parse
from gasbox.scenario.obstacles import PostObstacle
from gasbox.scenario.pong import Pong
from gasbox.scenario.pong_table import BATS, VARIANTS, pong_table

__all__ = ["Laid", "TableMenu"]

_FIELD: Final = "dense outlined hide-bottom-space options-dense"


@dataclass(frozen=True)
class Laid:
    """What a table was laid with, as far as its scenario tells; None where it does not."""

    variant: str
    gas: int | None
    temperature: float | None
    bat: str

    @classmethod
    def of(cls, scenario: Scenario) -> Laid:
        """Read it off a scenario with a game of pong."""
        world = scenario.world
        assert isinstance(world, Pong)
        gas = [one for one in scenario.species if one.name not in (world.ball, world.bricks)]
        warm = [one.temperature for one in gas if one.temperature is not None]
        return cls(
            next((name for name, title in VARIANTS.items() if title == scenario.title), "gas"),
            sum(one.count for one in gas) or None,
            warm[0] if warm else None,
            _bat(scenario, world),
        )


def _bat(scenario: Scenario, world: Pong) -> str:
    """The size that the left bat is nearest to."""
    radius = next(
        one.radius for one in scenario.obstacles if isinstance(one, PostObstacle) and one.name == world.left
    )
    # A bat is a cap, half as high as the disc.
    return min(BATS, key=lambda name: abs(2.0 * BATS[name] - radius))


class TableMenu:
    """A button with a form.

    Parameters
    ----------
    kept : gives what goes on in the new game: arguments of `pong_table`
    """

    def __init__(self, session: Session, kept: Callable[[], dict[str, Any]]) -> None:
        self._session, self._kept = session, kept
        laid = Laid.of(session.scenario)
        with (
            ui.button("Table", color=None).props("flat dense no-caps icon-right=expand_less") as button,
            ui.menu().props('aria-label="Table"') as self._menu,
            ui.element("div").classes("bins-form"),
        ):
            self._variant = ui.select(
                dict(VARIANTS), label="game", value=laid.variant, on_change=self._suggest
            )
            self._variant.props(_FIELD).mark("pong-variant")
            self._gas = ui.number("particles of gas", min=0, max=2000, step=10, value=laid.gas)
            self._gas.props(_FIELD).mark("pong-gas")
            self._temperature = ui.number("temperature of the gas", min=0, value=laid.temperature)
            self._temperature.props(_FIELD).mark("pong-temperature")
            self._bat = ui.select(list(BATS), label="bats", value=laid.bat)
            self._bat.props(_FIELD).mark("pong-bat")
            self._problem = ui.label().classes("problems").props('role="alert"').mark("pong-problem")
            lay = ui.button("New game on this table", on_click=self._lay)
            lay.props("unelevated no-caps color=primary").mark("pong-lay")
        button.classes("quiet").mark("pong-table").tooltip("Kind of game, gas and bats")

    def _suggest(self) -> None:
        """Each kind of game has its own usual gas."""
        usual = Laid.of(parse(pong_table(variant=self._variant.value)))
        self._gas.set_value(usual.gas)
        self._temperature.set_value(usual.temperature)

    def _arguments(self) -> dict[str, Any]:
        given = {
            "variant": self._variant.value,
            "gas": None if self._gas.value is None else int(self._gas.value),
            "temperature": self._temperature.value,
            "bat": self._bat.value,
        }
        return {**self._kept(), **{name: value for name, value in given.items() if value is not None}}

    async def _lay(self) -> None:
        arguments = self._arguments()
        try:
            await run.io_bound(lambda: self._session.load(parse(pong_table(**arguments))))
        except GasboxError as error:
            self._problem.set_text(str(error))
        else:
            self._menu.close()
