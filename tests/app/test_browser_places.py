"""A lab with one place: the second visitor is told so."""

from __future__ import annotations

import pytest
from lab_server import Server
from playwright.sync_api import Browser, expect

pytestmark = pytest.mark.browser


def test_a_full_lab_says_so(browser: Browser) -> None:
    server = Server("two-discs", max_sessions=1)
    try:
        server.wait()
        first, second = browser.new_page(), browser.new_page()
        first.goto(server.address)
        first.wait_for_function("window.gasboxStats && gasboxStats.drawn > 3", timeout=180_000)
        second.goto(server.address)
        expect(second.get_by_text("The lab is full")).to_be_visible()
        expect(second.get_by_role("button", name="Try again")).to_be_visible()
        expect(second.get_by_text("Its only place is taken.")).to_be_visible()
        expect(first.get_by_text("The lab is full")).to_be_hidden()
        first.close()
        second.close()
    finally:
        server.close()


def test_a_lost_connection_is_said(browser: Browser) -> None:
    server = Server("two-discs")
    try:
        server.wait()
        page = browser.new_page()
        page.goto(server.address)
        page.wait_for_function("window.gasboxStats && gasboxStats.drawn > 3", timeout=180_000)
        server.close()
        expect(page.get_by_text("Connection lost")).to_be_visible()
        page.close()
    finally:
        server.close()
