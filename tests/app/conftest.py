"""A real browser for the tests that are marked `browser`."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, sync_playwright

from chromium import ARGUMENTS


@pytest.fixture(scope="module")
def browser(chromium_path: str) -> Iterator[Browser]:
    """Chromium, for one module only: a running Playwright gets in the way of tests that are coroutines."""
    with sync_playwright() as playwright:
        one = playwright.chromium.launch(executable_path=chromium_path, args=list(ARGUMENTS))
        yield one
        one.close()
