"""The `gasbox` command in a process of its own."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

__all__ = ["environment", "gasbox", "start"]


def environment() -> dict[str, str]:
    """Without colours and at one width, wherever the tests run."""
    return {**os.environ, "COLUMNS": "100", "NO_COLOR": "1", "TERM": "dumb", "PYTHONWARNINGS": "error"}


def gasbox(*arguments: object, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run the command to its end."""
    return subprocess.run(
        [sys.executable, "-m", "gasbox", *map(str, arguments)],
        capture_output=True,
        text=True,
        cwd=folder,
        env=environment(),
        timeout=300,
        check=False,
    )


def start(*arguments: object) -> subprocess.Popen[str]:
    """Start the command, to be stopped by the caller."""
    return subprocess.Popen(
        [sys.executable, "-m", "gasbox", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment(),
    )
