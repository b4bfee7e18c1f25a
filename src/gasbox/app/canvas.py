"""The box on the page: an element that shows a session's frames. All drawing is in ``frontend/``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from nicegui.element import Element
from nicegui.events import GenericEventArguments

from gasbox.app.session import Session

__all__ = ["LabCanvas"]


class LabCanvas(Element, component="frontend/lab_canvas.js", esm={"gasbox-core": "frontend/core"}):
    """Draws a session's gas, and lets the reader zoom, pan and pick a disc.

    Parameters
    ----------
    session : whose frames to show; its gas starts when the browser opens the frame socket
    renderer : ``gl``, ``cpu``, or chosen by a probe of the browser; ``?renderer=`` in the address wins
    guest : whether it is only a second box beside the one that the page is about
    on_pick : called with the id of the disc that was clicked, or None for a click beside all discs
    on_notice : called with what the server has to say: a dict with ``kind`` ``preparing`` (``done``,
        ``total``, ``name``), ``ready``, ``busy`` (``text``), ``trouble``
        (``text``), ``lost`` or ``connected``
    """

    def __init__(
        self,
        session: Session,
        *,
        renderer: Literal["auto", "cpu", "gl"] = "auto",
        guest: bool = False,
        on_pick: Callable[[int | None], None] | None = None,
        on_notice: Callable[[dict[str, Any]], None] | None = None,
    ) -> None:
        super().__init__()
        self._session = session
        self._props["session"] = session.id
        self._props["renderer"] = renderer
        self._props["guest"] = guest
        if on_pick is not None:
            pick = on_pick
            self.on("pick", lambda event: pick(self._id(event)))
        if on_notice is not None:
            heard = on_notice
            self.on("notice", lambda event: heard(dict(event.args)))

    def reset_view(self) -> None:
        """Show the whole box again."""
        self.run_method("resetView")

    def _id(self, event: GenericEventArguments) -> int | None:
        return self._session.id_of_row(event.args)
