"""A page of its own for the box, whose pixels are read."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import matplotlib.image
import numpy as np
import pytest
from frame_server import FrameServer
from free_flight import gas
from numpy.typing import NDArray
from playwright.sync_api import Browser, Page

from gasbox.app.session import Session
from gasbox.scenario import Scenario

BOTH = pytest.mark.parametrize("renderer", ["cpu", "gl"])
RED, GREEN, BLUE = (255, 0, 0), (0, 160, 0), (0, 0, 255)
LIGHT_BOX, DARK_BOX = (255, 255, 255), (18, 22, 29)


@dataclass
class Box:
    """A page with a box of 60 x 40, in which listed discs stand still."""

    page: Page
    session: Session
    ratio: float

    def screenshot(self) -> NDArray[np.int_]:
        """(height, width, 3) device pixels, 0 to 255."""
        png = self.page.locator("#box").screenshot()
        return np.round(matplotlib.image.imread(io.BytesIO(png))[:, :, :3] * 255).astype(int)

    def place(self, x: float, y: float) -> tuple[float, float]:
        """Device pixels of a point of the box."""
        view = self.page.evaluate("(({ scale, originX, originY }) => [scale, originX, originY])(lab.view)")
        return view[1] + x * view[0], view[2] - y * view[0]

    def color_at(self, x: float, y: float) -> tuple[int, ...]:
        px, py = self.place(x, y)
        return tuple(self.screenshot()[int(py), int(px)].tolist())

    def scale(self) -> float:
        return float(self.page.evaluate("lab.view.scale"))

    def wait(self, condition: str) -> None:
        self.page.wait_for_function(condition, timeout=10_000)

    def redrawn(self) -> None:
        """Wait for a frame that is drawn from now on."""
        self.session.settle()
        drawn = self.page.evaluate("gasboxStats.drawn")
        self.session.step().result(5)
        self.wait(f"gasboxStats.drawn > {drawn}")


@contextmanager
def boxes(browser: Browser, server: FrameServer) -> Iterator[Callable[..., Box]]:
    contexts = []

    def opened(
        renderer: str, discs: list[tuple[int, float, float]], ratio: float = 1.0, **settings: Any
    ) -> Box:
        listed = [{"species": f"kind {kind}", "position": [x, y], "velocity": [0, 0]} for kind, x, y in discs]
        return shown(renderer, gas((0, 0, 0), particles=listed, **settings), len(discs), ratio)

    def shown(renderer: str, scenario: Scenario, count: int, ratio: float = 1.0) -> Box:
        session = server.registry.open(scenario)
        session.pause()
        session.start()
        session.settle()
        state = session.show.simulation.state
        assert state.count == count
        context = browser.new_context(
            viewport={"width": 640, "height": 480}, device_scale_factor=ratio, color_scheme="light"
        )
        contexts.append(context)
        page = context.new_page()
        page.goto(server.page(session, f"?renderer={renderer}"))
        box = Box(page, session, ratio)
        box.wait("window.gasboxStats?.drawn > 0")
        assert page.evaluate("gasboxStats.renderer") == renderer
        return box

    opened.shown = shown  # type: ignore[attr-defined]
    yield opened
    for context in contexts:
        context.close()
    server.registry.close()


def area(image: NDArray[np.int_], color: tuple[int, int, int], ground: tuple[int, int, int]) -> float:
    """Pixels that are covered by this colour, with the partly covered ones at the edge."""
    span = np.array(color) - np.array(ground)
    share = ((image - np.array(ground)) @ span) / (span @ span)
    on_line = np.abs(image - np.array(ground) - share[..., None] * span).max(axis=2) < 6
    return float(np.where(on_line, share, 0).clip(0, 1).sum())
