"""Write constraints.txt: the versions that are installed here, of everything gasbox needs, and nothing else.

    .venv/bin/python scripts/lock.py

Names and versions only: no hashes, no platform, no place to download from. A line for a package that some
platform does not need does no harm, for a constraint installs nothing.
"""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path

from packaging.requirements import Requirement

TARGET = Path(__file__).resolve().parent.parent / "constraints.txt"
HEAD = "# Versions known to work together; written by `make lock`. The ranges are in pyproject.toml.\n"
EXTRAS = ("", "bench", "dev")


def normal(name: str) -> str:
    """The name as package indexes compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def closure(package: str, extras: tuple[str, ...]) -> dict[str, str]:
    """Name -> version of everything that `package` with `extras` needs, directly or not."""
    pinned: dict[str, str] = {}
    queue = [(package, extra) for extra in extras]
    seen = set(queue)
    while queue:
        name, extra = queue.pop()
        try:
            pinned[name] = version(name)
        except PackageNotFoundError:
            continue
        for need in map(Requirement, requires(name) or ()):
            if need.marker is not None and not need.marker.evaluate({"extra": extra}):
                continue
            found = {(normal(need.name), wanted) for wanted in ("", *need.extras)} - seen
            seen |= found
            queue.extend(found)
    del pinned[package]
    return pinned


if __name__ == "__main__":
    pins = sorted(closure("gasbox", EXTRAS).items())
    TARGET.write_text(HEAD + "".join(f"{name}=={number}\n" for name, number in pins), "utf-8")
    print(f"{TARGET.name}: {len(pins)} packages")
