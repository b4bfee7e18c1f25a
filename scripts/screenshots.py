"""Take the pictures of the page that the README and the documentation show.

    python scripts/screenshots.py           lab-light.png, lab-dark.png and lab-phone.png in docs/images

Starts the lab on a free port, lets the histograms settle, and ends it again.
"""

from __future__ import annotations

import contextlib
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, TimeoutError, sync_playwright

from chromium import ARGUMENTS, advice, find_chromium

IMAGES = Path(__file__).resolve().parent.parent / "docs" / "images"
SHOTS: tuple[tuple[str, dict[str, Any]], ...] = (
    ("lab-light.png", {"viewport": {"width": 1280, "height": 800}, "color_scheme": "light"}),
    ("lab-dark.png", {"viewport": {"width": 1280, "height": 800}, "color_scheme": "dark"}),
    (
        "lab-phone.png",
        {
            "viewport": {"width": 390, "height": 844},
            "color_scheme": "light",
            "device_scale_factor": 2,
            "is_mobile": True,
            "has_touch": True,
        },
    ),
)
SERVE = (
    "import functools; from gasbox.app.server import serve; from gasbox.scenario import load;"
    "serve(load('three-gases'), port=0, show=False, tell=functools.partial(print, flush=True))"
)
SETTLE = 150.0
"""Simulated time [time] after which the histograms have forgotten their start."""
CALM = (
    "[...document.querySelectorAll('.readout')].some((one) => one.innerText.startsWith('frames')"
    " && Number(one.innerText.split('\\n')[1]) >= 45) && !document.querySelector('.behind').innerText"
)
"""The page reaches its usual rate."""
LARGEST = 400_000
"""Bytes of a picture in the repository."""


def address_of(server: subprocess.Popen[str]) -> str:
    """Wait until the server says where it is."""
    assert server.stdout is not None
    for line in server.stdout:
        found = re.search(r"http://127\.0\.0\.1:\d+/", line)
        if found:
            return found[0]
    raise SystemExit("The lab did not start.")


def shoot(browser: Browser, address: str, name: str, settings: dict[str, Any]) -> None:
    context = browser.new_context(reduced_motion="reduce", **settings)
    page = context.new_page()
    page.goto(address)
    page.wait_for_function(f"window.gasboxStats && gasboxStats.time > {SETTLE}", timeout=300_000)
    page.get_by_label("Average over").click()
    page.get_by_role("option", name="5 s").click()
    page.mouse.move(1, 1)
    page.wait_for_timeout(6_000)
    with contextlib.suppress(TimeoutError):  # on a busy machine the picture shows what there is
        page.wait_for_function(CALM, timeout=60_000)
    page.screenshot(path=IMAGES / name)
    context.close()
    size = (IMAGES / name).stat().st_size
    print(f"{name}: {size // 1000} kB")
    if size > LARGEST:
        raise SystemExit(f"{name} is larger than {LARGEST // 1000} kB")


def main() -> None:
    chromium = find_chromium()
    if chromium is None:
        raise SystemExit(advice())
    IMAGES.mkdir(parents=True, exist_ok=True)
    server = subprocess.Popen([sys.executable, "-c", SERVE], stdout=subprocess.PIPE, text=True)
    try:
        address = address_of(server)
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=chromium, args=list(ARGUMENTS))
            for name, settings in SHOTS:
                shoot(browser, address, name, settings)
            browser.close()
    finally:
        server.terminate()
        server.wait(10)


if __name__ == "__main__":
    main()
