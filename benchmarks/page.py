"""Frames per second that the page really shows, and the time until its first one.

    python benchmarks/page.py                    all cases
    python benchmarks/page.py default             some of them
    python benchmarks/page.py --json

The server and a Chromium without a window run on this machine. The page counts what it draws
(`window.gasboxStats`) and is asked over the debugging protocol with network events off, because watching a
websocket through that protocol costs more than the frames themselves.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any
from urllib.request import urlopen

from websockets.sync.client import connect

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "scripts"))
from chromium import ARGUMENTS, advice, find_chromium

WARM_UP = 4.0
MEASURED = 10.0
SIZE = (1280, 720)


@dataclass(frozen=True)
class Case:
    """What to open, and what is wanted of it."""

    name: str
    scenario: str
    query: str
    wanted: float


CASES = (
    Case("default", "three-gases", "", 45),
    Case("ten-thousand", "ten-thousand", "", 30),
    Case("hundred-thousand", "hundred-thousand", "?charts=0", 15),
    Case("hundred-thousand-stepped", "hundred-thousand-stepped", "?charts=0", 15),
)


@dataclass(frozen=True)
class Result:
    """Measured for one case."""

    name: str
    fps: float
    wanted: float
    draw_ms: float
    speed: float
    """Frames of simulated time per 1/60 s."""
    server_cpu: float | None
    """Processor time of the server, in cores."""
    browser_cpu: float | None
    """Processor time of all of Chromium's processes, in cores."""
    renderer: str
    first_frame: float
    """Seconds from the command to the first frame, with a browser that is open already."""


def many_discs(kind: str, count: int = 100_000) -> dict[str, Any]:
    """Equal discs at area fraction 0.2."""
    dynamics = {"kind": kind} if kind == "event-driven" else {"kind": kind, "time_step": 0.05}
    return {
        "format": "gasbox-scenario/1",
        "title": "A hundred thousand discs",
        "container": {"shape": "rectangle", "width": 768, "height": 512},
        "species": [{"name": "disc", "radius": 0.5, "count": count, "temperature": 1}],
        "dynamics": dynamics,
        "frame_interval": 0.05,
    }


def scenario_path(name: str, folder: Path) -> str:
    """A shipped name, or a file that is written for the purpose."""
    if not name.startswith("hundred-thousand"):
        return name
    path = folder / f"{name}.json"
    path.write_text(json.dumps(many_discs("stepped" if name.endswith("stepped") else "event-driven")))
    return str(path)


@contextlib.contextmanager
def lab(scenario: str) -> Iterator[tuple[subprocess.Popen[str], str, float]]:
    """A running server, its address, and when the command was given (seconds since the epoch)."""
    command = [sys.executable, "-m", "gasbox", "lab", scenario, "--no-browser", "--port", "0"]
    began = time.time()
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONUNBUFFERED": "1"}
    )
    assert process.stdout is not None
    try:
        lines = (re.search(r"http://\S+/", line) for line in process.stdout)
        yield process, next(found[0] for found in lines if found), began
    finally:
        process.send_signal(signal.SIGINT)
        process.wait(20)
        process.stdout.close()


class Tab:
    """One page of Chromium, asked by `Runtime.evaluate` alone."""

    def __init__(self, url: str) -> None:
        self._socket = connect(url, max_size=None, compression=None, legacy=True)
        self._number = 0

    def ask(self, method: str, **parameters: Any) -> Any:
        self._number += 1
        self._socket.send(json.dumps({"id": self._number, "method": method, "params": parameters}))
        while (answer := json.loads(self._socket.recv(timeout=60))).get("id") != self._number:
            pass
        return answer.get("result")

    def evaluate(self, expression: str) -> Any:
        return self.ask("Runtime.evaluate", expression=expression, returnByValue=True)["result"].get("value")

    def wait(self, expression: str, seconds: float = 120.0) -> Any:
        end = time.monotonic() + seconds
        while not (value := self.evaluate(expression)):
            if time.monotonic() > end:
                raise TimeoutError(expression)
            time.sleep(0.05)
        return value

    def close(self) -> None:
        self._socket.close()


@contextlib.contextmanager
def chromium(path: str) -> Iterator[tuple[int, Tab]]:
    """A browser without a window, with one tab: its process and the tab."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        size = f"--window-size={SIZE[0]},{SIZE[1]}"
        command = [
            path,
            "--headless=new",
            "--remote-debugging-port=0",
            f"--user-data-dir={profile}",
            size,
            *ARGUMENTS,
        ]
        process = subprocess.Popen([*command, "about:blank"], stderr=subprocess.DEVNULL)
        try:
            note = Path(profile) / "DevToolsActivePort"
            while not (note.exists() and note.read_text().strip()):
                time.sleep(0.05)
            port = note.read_text().split()[0]
            pages = json.load(urlopen(f"http://127.0.0.1:{port}/json/list"))
            tab = Tab(next(page["webSocketDebuggerUrl"] for page in pages if page["type"] == "page"))
            yield process.pid, tab
            tab.close()
        finally:
            process.terminate()
            process.wait(20)


def processor_seconds(root: int) -> float | None:
    """Processor time that a process and all below it have used so far; None where the system does not tell."""
    parents, used = {}, {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            fields = stat.read_text().rsplit(")", 1)[1].split()
            number = int(stat.parent.name)
            parents[number] = int(fields[1])
            used[number] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    family = {root}
    while more := {one for one, parent in parents.items() if parent in family} - family:
        family |= more
    return sum(used.get(one, 0.0) for one in family) if root in used else None


def cores(before: float | None, after: float | None, seconds: float) -> float | None:
    """Mean number of busy cores."""
    return None if before is None or after is None else (after - before) / seconds


def measure(case: Case, browser: int, tab: Tab, folder: Path) -> Result:
    """Open the case's page and count for a while."""
    with lab(scenario_path(case.scenario, folder)) as (process, address, began):
        tab.ask("Page.navigate", url=address + case.query)
        first = tab.wait("window.gasboxStats?.firstFrame && performance.timeOrigin + gasboxStats.firstFrame")
        time.sleep(WARM_UP)
        look = "[performance.now(), gasboxStats.drawn, gasboxStats.number, gasboxStats.drawMs, gasboxStats.renderer]"
        used, before = (processor_seconds(process.pid), processor_seconds(browser)), tab.evaluate(look)
        time.sleep(MEASURED)
        after, used_then = tab.evaluate(look), (processor_seconds(process.pid), processor_seconds(browser))
        seconds = (after[0] - before[0]) / 1000
        tab.ask("Page.navigate", url="about:blank")
    return Result(
        case.name,
        (after[1] - before[1]) / seconds,
        case.wanted,
        after[3],
        (after[2] - before[2]) / seconds / 60,
        cores(used[0], used_then[0], seconds),
        cores(used[1], used_then[1], seconds),
        after[4],
        first / 1000 - began,
    )


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("cases", nargs="*", help=", ".join(case.name for case in CASES))
    parser.add_argument("--json", action="store_true", help="print one JSON object for each case")
    arguments = parser.parse_args()
    path = find_chromium()
    if path is None:
        print(advice(), file=sys.stderr)
        return 1
    # Only a start with compiled kernels is measured.
    subprocess.run(
        [sys.executable, "-c", "from gasbox.build import compile_kernels; compile_kernels()"], check=True
    )
    reached = True
    with tempfile.TemporaryDirectory() as folder:
        for case in CASES:
            if arguments.cases and case.name not in arguments.cases:
                continue
            with chromium(path) as (browser, tab):
                result = measure(case, browser, tab, Path(folder))
            reached &= result.fps >= result.wanted
            print(json.dumps(asdict(result)) if arguments.json else sentence(result), flush=True)
    return 0 if reached else 1


def sentence(result: Result) -> str:
    cpu = ""
    if result.server_cpu is not None and result.browser_cpu is not None:
        cpu = f", server {result.server_cpu:.2f} cores, browser {result.browser_cpu:.2f}"
    return (
        f"{result.name}: {result.fps:.1f} frames/s (wanted {result.wanted:g}), at speed {result.speed:.2f}x; "
        f"drawing {result.draw_ms:.1f} ms by {result.renderer}{cpu}; "
        f"first frame {result.first_frame:.1f} s after the command"
    )


if __name__ == "__main__":
    sys.exit(main())
