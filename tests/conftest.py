"""Shared by all tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from chromium import advice, find_chromium

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def repository() -> Path:
    """The root of the repository."""
    return ROOT


@pytest.fixture(scope="session")
def chromium_path() -> str:
    """The browser, for Playwright: ``chromium.launch(executable_path=chromium_path, args=ARGUMENTS)``."""
    path = find_chromium()
    if path is None:
        pytest.fail(advice())
    return path
