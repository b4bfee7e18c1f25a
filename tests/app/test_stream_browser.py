"""The frame socket as a real browser uses it: connections that are lost, pages that are hidden or loaded again."""

from __future__ import annotations

import time
from collections.abc import Iterator

import pytest
from frame_server import FrameServer, running
from free_flight import gas
from playwright.sync_api import Browser, Page

from gasbox.app.session import Session

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running() as one:
        yield one


@pytest.fixture
def session(server: FrameServer) -> Iterator[Session]:
    yield server.registry.open(gas())
    server.registry.close()


@pytest.fixture
def page(browser: Browser, server: FrameServer, session: Session) -> Iterator[Page]:
    one = browser.new_page()
    one.goto(server.page(session, "?renderer=cpu"))
    one.wait_for_function("window.gasboxStats?.drawn > 3")
    yield one
    one.close()


def test_frames_arrive_and_move(page: Page) -> None:
    first = page.evaluate("gasboxStats.time")
    page.wait_for_function(f"gasboxStats.time > {first}")
    page.wait_for_timeout(1000)
    stats = page.evaluate(
        "({ fps: gasboxStats.shown(1), errors: gasboxStats.errors, ms: gasboxStats.drawMs })"
    )
    assert stats["fps"] > 5
    assert stats["errors"] == 0
    assert stats["ms"] > 0


def test_a_lost_connection_comes_back_to_the_same_gas(page: Page, session: Session) -> None:
    simulation = session.show.simulation
    drawn, shown = page.evaluate("[gasboxStats.drawn, gasboxStats.time]")
    page.evaluate("lab.socket.socket.close()")
    page.wait_for_function("notices.includes('lost')")
    page.wait_for_function(f"gasboxStats.drawn > {drawn + 5} && gasboxStats.connected")
    assert page.evaluate("gasboxStats.time") >= shown
    assert session.show.simulation is simulation
    assert page.locator(".gasbox-message").is_hidden()


def test_a_page_loaded_again_gets_its_gas_back(page: Page, server: FrameServer, session: Session) -> None:
    session.pause()
    session.step().result(5)
    simulation, stopped = session.show.simulation, session.show.simulation.time
    again = server.registry.open(session.origin)
    page.goto(server.page(again))
    page.wait_for_function("window.gasboxStats?.drawn > 0")
    assert again.show.simulation is simulation
    assert page.evaluate("gasboxStats.time") == stopped
    assert not again.playing


def test_a_page_without_a_session_loads_once_more_and_then_says_so(page: Page, server: FrameServer) -> None:
    loads = []
    page.on("framenavigated", lambda frame: loads.append(frame.url))
    page.goto(f"http://127.0.0.1:{server.port}/lab/guessed")
    page.wait_for_function("window.notices?.includes('gone')")
    page.wait_for_timeout(500)
    assert len(loads) == 2
    assert "load it again" in page.locator(".gasbox-message").inner_text()


def test_a_hidden_tab_costs_nothing(browser: Browser, page: Page, session: Session) -> None:
    page.evaluate("""() => {
      Object.defineProperty(document, "hidden", { configurable: true, get: () => true });
      document.dispatchEvent(new Event("visibilitychange"));
    }""")
    end = time.monotonic() + 5
    while session.show.running:
        assert time.monotonic() < end
        time.sleep(0.02)
    received, stopped = page.evaluate("gasboxStats.received"), session.show.simulation.time
    page.wait_for_timeout(500)
    assert page.evaluate("gasboxStats.received") <= received + 2
    assert session.show.simulation.time == stopped
    page.evaluate("delete document.hidden, document.dispatchEvent(new Event('visibilitychange'))")
    page.wait_for_function(f"gasboxStats.time > {stopped}")


def test_a_frame_that_cannot_be_drawn_is_acknowledged_all_the_same(page: Page) -> None:
    page.evaluate("() => { lab.renderer.draw = () => { throw new Error('on purpose'); }; }")
    received = page.evaluate("gasboxStats.received")
    page.wait_for_function(f"gasboxStats.received > {received + 10} && gasboxStats.errors > 5")


def test_a_full_lab_is_kind_and_lets_in_who_waits(browser: Browser, server: FrameServer) -> None:
    seated = [server.registry.open(gas()) for _ in range(3)]
    for one in seated:
        one.start()
    waiting = server.registry.open(gas())
    page = browser.new_page()
    page.goto(server.page(waiting))
    page.wait_for_function("window.notices?.includes('busy')")
    assert "All 3 places" in page.locator(".gasbox-message").inner_text()
    server.registry._remove(seated[0])
    page.wait_for_function("window.gasboxStats.drawn > 0", timeout=10_000)
    assert page.locator(".gasbox-message").is_hidden()
    page.close()
    server.registry.close()
    seated[0].close()


BACKLOG = """async (arrivals) => {
  const { Backlog } = await import("/core/backlog.js");
  const backlog = new Backlog();
  let next = 0;
  return arrivals.map((count) => {
    for (let k = 0; k < count; k++) backlog.put(next++);
    return backlog.take();
  });
}"""


@pytest.mark.parametrize(
    ("arrivals", "drawn"),
    [
        ([1, 1, 1, 1], [0, 1, 2, 3]),
        ([2, 0, 1, 2, 0], [0, 1, 2, 3, 4]),  # two at once are drawn one after the other
        ([0, 0], [None, None]),
        ([2, 1, 1, 1], [0, 2, 3, 4]),  # but not for ever: who is behind is shown the newest
        ([5, 5, 5], [3, 9, 13]),
    ],
)
def test_frames_that_arrive_together(page: Page, arrivals: list[int], drawn: list[int | None]) -> None:
    assert page.evaluate(BACKLOG, arrivals) == drawn
