"""The whole server as a process: its address, its door, and its end."""

from __future__ import annotations

import re
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field

import httpx
import pytest
from websockets.sync.client import connect

from gasbox.app.security import MAX_BODY
from gasbox.app.server import DEFAULT_PORT, _address, _bind, _greeting, _listen
from gasbox.errors import UsageError

START = """
from gasbox.app.server import serve
from gasbox.scenario import load
serve(load("two-discs"), show=False, {arguments})
"""


@dataclass
class Served:
    """A running server and what it has said so far."""

    process: subprocess.Popen[str]
    lines: list[str] = field(default_factory=list)
    address: str = ""
    listener: threading.Thread | None = None

    @classmethod
    def start(cls, arguments: str = "port=0") -> Served:
        command = [sys.executable, "-W", "error", "-c", START.format(arguments=arguments)]
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        served = cls(subprocess.Popen(command, text=True, **streams))
        assert served.process.stdout is not None
        for line in served.process.stdout:
            served.lines.append(line)
            if found := re.search(r"http://\S+", line):
                served.address = found[0]
                break
        served.listener = threading.Thread(target=served.listen, daemon=True)
        served.listener.start()
        return served

    def listen(self) -> None:
        assert self.process.stdout is not None
        self.lines.extend(self.process.stdout)

    def end(self) -> tuple[int, str]:
        """Ctrl-C; the exit status and all that was said."""
        self.process.send_signal(signal.SIGINT)
        status = self.process.wait(20)
        assert self.listener is not None
        assert self.process.stdout is not None
        self.listener.join(5)
        self.process.stdout.close()
        return status, "".join(self.lines)


@pytest.fixture(scope="module")
def served() -> Iterator[Served]:
    one = Served.start()
    yield one
    if one.process.poll() is None:
        one.end()


def test_the_page_is_there_when_the_address_is_told(served: Served) -> None:
    assert served.address.startswith("http://127.0.0.1:")
    answer = httpx.get(served.address)
    assert answer.status_code == 200
    assert "gasbox-core" in answer.text
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert "frame-ancestors" in answer.headers["content-security-policy"]


@pytest.mark.parametrize("path", ["", "_nicegui_ws/socket.io/?EIO=4&transport=polling", "gasbox/frames/x"])
def test_other_sites_are_turned_away_everywhere(served: Served, path: str) -> None:
    url = served.address + path
    assert httpx.get(url, headers={"host": "evil.example"}).status_code == 400
    refused = httpx.get(url, headers={"origin": "http://evil.example"})
    assert refused.status_code == 403
    assert "access-control-allow-origin" not in refused.headers


def test_the_channel_of_the_controls_is_guarded_as_a_websocket_too(served: Served) -> None:
    url = served.address.replace("http", "ws") + "_nicegui_ws/socket.io/?EIO=4&transport=websocket"
    with pytest.raises(Exception, match="403"), connect(url, additional_headers={"Origin": "null"}):
        pass


def test_an_upload_that_is_too_large_is_refused_before_it_is_read(served: Served) -> None:
    url = httpx.URL(served.address)
    head = f"POST /_nicegui/client/x/upload/1 HTTP/1.1\r\nHost: {url.host}\r\nContent-Length: {MAX_BODY + 1}\r\n\r\n"
    with socket.create_connection((url.host, url.port or 80), 5) as client:
        client.sendall(head.encode())
        answer = client.recv(1000)
    assert answer.startswith(b"HTTP/1.1 413 ")


def test_frames_are_not_compressed(served: Served) -> None:
    url = served.address.replace("http", "ws") + "gasbox/frames/guessed"
    with connect(url, compression="deflate") as client:
        assert client.response is not None
        assert "sec-websocket-extensions" not in client.response.headers


def test_nothing_of_the_programming_interface_is_shown(served: Served) -> None:
    for path in ("docs", "redoc", "openapi.json"):
        assert httpx.get(served.address + path).status_code == 404


def test_ctrl_c_ends_it_cleanly() -> None:
    served = Served.start()
    answer = httpx.get(served.address)
    status, said = served.end()
    assert answer.status_code == 200
    assert status == 0
    assert "Traceback" not in said
    assert "has ended" in said


def test_a_network_address_is_warned_of() -> None:
    assert len(_greeting("127.0.0.1", "http://127.0.0.1:1/")) == 1
    assert "Warning: listening on 0.0.0.0" in _greeting("0.0.0.0", "http://127.0.0.1:1/")[1]


def test_a_taken_port_that_was_asked_for_is_an_error() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(UsageError, match=f"--port {port}"):
            _listen("127.0.0.1", port, print)


def test_a_default_port_that_is_taken_gives_way_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        monkeypatch.setattr("gasbox.app.server.DEFAULT_PORT", port)
        with _listen("127.0.0.1", None, said.append) as listener:
            other = listener.getsockname()[1]
    assert other != port
    assert said == [f"Port {port} is taken; using {other} instead."]
    assert DEFAULT_PORT == 8765


def test_a_host_that_does_not_exist_is_an_error() -> None:
    with pytest.raises(UsageError, match="--host"):
        _listen("no-such-host.invalid", None, print)


def test_the_port_answers_as_soon_as_it_is_bound() -> None:
    with (
        _bind("127.0.0.1", 0) as listener,
        socket.create_connection(("127.0.0.1", listener.getsockname()[1]), 5),
    ):
        pass


@pytest.mark.parametrize(
    ("host", "shown"),
    [("127.0.0.1", "127.0.0.1"), ("0.0.0.0", "127.0.0.1"), ("::1", "[::1]"), ("lab", "lab")],
)
def test_addresses_for_the_browser(host: str, shown: str) -> None:
    assert _address(host, 80) == f"http://{shown}:80/"
