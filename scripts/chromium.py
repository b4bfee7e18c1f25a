"""Find the Chromium or Chrome that the browser tests and the screenshots drive.

    python scripts/chromium.py              print its path, or fail with the command to run
    python scripts/chromium.py --install    on Debian, install it by apt if there is none

The environment variable GASBOX_CHROMIUM names another one.
"""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge")
MAC_APPLICATIONS = ("Google Chrome", "Chromium", "Microsoft Edge")
ARGUMENTS = (
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
"""For Playwright's `launch(args=...)`: no sandbox, which containers often lack, and no traffic of its own."""


def _candidates() -> list[str]:
    named = [os.environ["GASBOX_CHROMIUM"]] if os.environ.get("GASBOX_CHROMIUM") else []
    applications = [
        f"{home}/Applications/{name}.app/Contents/MacOS/{name}"
        for home in ("", str(Path.home()))
        for name in MAC_APPLICATIONS
    ]
    cache = Path(os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache"))) / "ms-playwright"
    downloaded = sorted(map(str, cache.glob("chromium-*/chrome-linux*/chrome")), reverse=True)
    return [*named, *NAMES, *applications, *downloaded]


def find_chromium() -> str | None:
    """The path of a Chromium or Chrome, or None."""
    return next((path for path in map(shutil.which, _candidates()) if path), None)


def _is_debian() -> bool:
    try:
        system = platform.freedesktop_os_release()
    except OSError:
        return False
    # Ubuntu's package named chromium only points to a snap, which containers cannot run.
    return system.get("ID") != "ubuntu" and "debian" in [system.get("ID"), *system.get("ID_LIKE", "").split()]


def _as_root() -> list[str] | None:
    """What to put before a command so that it runs as root without asking, or None."""
    if os.geteuid() == 0:
        return []
    sudo = shutil.which("sudo")
    asks = sudo is None or subprocess.run([sudo, "-n", "true"], capture_output=True).returncode != 0
    return None if asks else [str(sudo), "-n"]


def install_chromium() -> bool:
    """Install Debian's package; False where that is not possible without asking."""
    if not (hasattr(os, "geteuid") and _is_debian() and shutil.which("apt-get")):
        return False
    prefix = _as_root()
    if prefix is None:
        return False
    print("Installing Debian's chromium for the browser tests ...", flush=True)
    apt = [*prefix, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-qq"]
    wanted = ["chromium", "fonts-dejavu-core"]
    quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL}
    subprocess.run([*apt, "update"], check=False, **quiet)
    done = subprocess.run([*apt, "install", "-y", "--no-install-recommends", *wanted], check=False, **quiet)
    return done.returncode == 0


def advice() -> str:
    """What to do where no browser was found."""
    if _is_debian():
        command = "sudo apt-get install chromium"
    elif sys.platform == "darwin":
        command = "brew install --cask google-chrome"
    else:
        command = ".venv/bin/playwright install --with-deps chromium"
    return (
        "The browser tests need Chromium or Chrome, and none was found. Install one:\n"
        f"    {command}\n"
        "or name one:  GASBOX_CHROMIUM=/path/to/chrome make test\n"
        "or leave those tests out:  make test ARGS=\"-m 'not browser and not validate'\" CHROMIUM=no"
    )


if __name__ == "__main__":
    if find_chromium() is None and "--install" in sys.argv[1:]:
        install_chromium()
    path = find_chromium()
    if path is None:
        sys.exit(advice())
    print(path)
