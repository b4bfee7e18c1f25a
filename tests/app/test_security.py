"""Other sites and other names are turned away, on every kind of connection; bodies have a limit."""

from __future__ import annotations

from collections.abc import Iterator

import httpx
import pytest
from frame_server import FrameServer, running
from free_flight import gas
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from gasbox.app.security import Guard, is_loopback

LIMIT = 10_000


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running(max_body=LIMIT) as one:
        yield one


def get(server: FrameServer, **headers: str) -> httpx.Response:
    return httpx.get(f"http://127.0.0.1:{server.port}/", headers=headers)


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost", "LOCALHOST", "[::1]"])
@pytest.mark.parametrize("port", ["", ":8765", ":1"])
def test_names_of_this_machine_are_good(server: FrameServer, name: str, port: str) -> None:
    assert get(server, host=f"{name}{port}").status_code == 200


@pytest.mark.parametrize(
    "host",
    [
        "evil.example",
        "evil.example:8765",
        "127.0.0.1.evil.example",
        "localhost.evil.example",
        "127.0.0.1.",
        "",
        "[",
        "192.168.0.7",
    ],
)
def test_other_names_are_refused(server: FrameServer, host: str) -> None:
    assert get(server, host=host).status_code == 400


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example",
        "null",
        "http://127.0.0.1",
        "http://localhost:{port}",
        "http://127.0.0.1:1",
        "file://127.0.0.1:{port}",
        "http://evil.example:{port}",
        "chrome-extension://abc",
    ],
)
def test_other_origins_are_refused(server: FrameServer, origin: str) -> None:
    given = origin.format(port=server.port)
    assert get(server, origin=given).status_code == 403
    posted = httpx.post(f"http://127.0.0.1:{server.port}/size", headers={"origin": given}, content=b"x")
    assert posted.status_code == 403


def test_the_page_itself_is_answered(server: FrameServer) -> None:
    assert get(server).status_code == 200
    assert get(server, origin=f"http://127.0.0.1:{server.port}").status_code == 200


@pytest.mark.parametrize(
    ("headers", "status"),
    [({"Origin": "http://evil.example"}, 403), ({"Origin": "null"}, 403), ({"Host": "evil.example"}, 400)],
)
def test_the_frame_socket_is_guarded_too(server: FrameServer, headers: dict[str, str], status: int) -> None:
    session = server.registry.open(gas())
    with (
        pytest.raises(InvalidStatus) as refused,
        connect(server.url(session), additional_headers=headers),
    ):
        pass
    assert refused.value.response.status_code == status
    assert not session.started


def test_a_page_of_this_server_may_open_the_frame_socket(server: FrameServer) -> None:
    session = server.registry.open(gas())
    origin = f"http://127.0.0.1:{server.port}"
    with connect(server.url(session), additional_headers={"Origin": origin}) as client:
        assert "table" in str(client.recv(timeout=5))
    server.registry.close()


def test_a_body_up_to_the_limit_is_taken(server: FrameServer) -> None:
    answer = httpx.post(f"http://127.0.0.1:{server.port}/size", content=b"x" * LIMIT)
    assert (answer.status_code, answer.text) == (200, str(LIMIT))


def test_a_body_over_the_limit_is_refused(server: FrameServer) -> None:
    answer = httpx.post(f"http://127.0.0.1:{server.port}/size", content=b"x" * (LIMIT + 1))
    assert answer.status_code == 413
    assert "too large" in answer.text


def test_a_body_of_unknown_length_is_counted(server: FrameServer) -> None:
    pieces = (b"x" * 1000 for _ in range(LIMIT // 1000 + 1))
    answer = httpx.post(f"http://127.0.0.1:{server.port}/size", content=pieces)
    assert answer.status_code == 413


def test_headers_that_every_answer_carries(server: FrameServer) -> None:
    for answer in (get(server), get(server, host="evil.example")):
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert "frame-ancestors 'self'" in answer.headers["content-security-policy"]


def test_addresses_are_good_where_others_are_let_in() -> None:
    async def app(*_: object) -> None: ...

    closed, opened = Guard(app), Guard(app, "0.0.0.0")
    assert not closed._is_good_host("192.168.0.7:8765")
    assert opened._is_good_host("192.168.0.7:8765")
    assert opened._is_good_host("[fe80::1]:8765")
    assert not opened._is_good_host("evil.example:8765")
    assert Guard(app, "lab.example")._is_good_host("lab.example:8765")


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost", "::1", "[::1]", "127.3.2.1"])
def test_only_this_machine_reaches(host: str) -> None:
    assert is_loopback(host)


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "192.168.0.7", "lab.example", "localhost.example"])
def test_others_may_reach(host: str) -> None:
    assert not is_loopback(host)
