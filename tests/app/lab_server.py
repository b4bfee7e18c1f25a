"""The lab in a process of its own, on a free port of this machine."""

from __future__ import annotations

import re
import subprocess
import sys
import threading
from pathlib import Path


class Server:
    """`serve_lab.py`, started and ended by its process id."""

    def __init__(self, scenario: str = "three-gases", max_sessions: int = 8) -> None:
        script = Path(__file__).parent / "serve_lab.py"
        self.lines: list[str] = []
        self._process = subprocess.Popen(
            [sys.executable, str(script), scenario, str(max_sessions)],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._listening = threading.Event()
        self.address = ""
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self.lines.append(line)
            found = re.search(r"http://127\.0\.0\.1:\d+/", line)
            if found:
                self.address = found[0]
                self._listening.set()
        self._listening.set()

    def wait(self) -> Server:
        self._listening.wait(60)
        assert self.address, "".join(self.lines)
        return self

    def close(self) -> None:
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait(10)
        self._reader.join(5)
        if self._process.stdout is not None:
            self._process.stdout.close()
