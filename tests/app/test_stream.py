"""The frame socket over a real connection."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator

import pytest
from frame_server import FrameServer, running
from free_flight import gas
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from gasbox.app.protocol import WireFrame, decode_frame
from gasbox.app.session import Session


@pytest.fixture(scope="module")
def server() -> Iterator[FrameServer]:
    with running() as one:
        yield one


@pytest.fixture(autouse=True)
def _all_sessions_end(server: FrameServer) -> Iterator[None]:
    yield
    server.registry.close()


@pytest.fixture
def session(server: FrameServer) -> Session:
    return server.registry.open(gas())


def hear(client: ClientConnection) -> str | WireFrame:
    message = client.recv(timeout=5)
    return message if isinstance(message, str) else decode_frame(message)


def next_frame(client: ClientConnection) -> WireFrame:
    while not isinstance(message := hear(client), WireFrame):
        pass
    return message


def ack(client: ClientConnection, received: int) -> None:
    client.send(json.dumps({"ack": received, "drawn": received}))


def read_to_the_end(client: ClientConnection) -> int | None:
    """The close code."""
    try:
        while True:
            client.recv(timeout=5)
    except ConnectionClosed as closed:
        return closed.rcvd.code if closed.rcvd else None


def wait_for_end(session: Session) -> None:
    end = time.monotonic() + 5
    while session.audience.attached:
        assert time.monotonic() < end
        time.sleep(0.01)


def test_the_gas_is_made_when_the_socket_connects(server: FrameServer, session: Session) -> None:
    assert not session.started
    with connect(server.url(session)) as client:
        assert session.started
        first, frame = hear(client), next_frame(client)
    assert isinstance(first, str)
    assert json.loads(first)["kind"] == "table"
    assert frame.position.shape == (50, 2)


def test_frames_keep_coming_and_move(server: FrameServer, session: Session) -> None:
    with connect(server.url(session)) as client:
        times = []
        for received in range(1, 31):
            times.append(next_frame(client).time)
            ack(client, received)
    assert times == sorted(times)
    assert times[-1] > times[0]


def test_without_acks_two_frames_are_all(server: FrameServer, session: Session) -> None:
    with connect(server.url(session)) as client:
        next_frame(client)
        next_frame(client)
        with pytest.raises(TimeoutError):
            client.recv(timeout=0.3)
        ack(client, 2)
        assert next_frame(client).time > 0


def test_a_slow_reader_gets_new_frames_and_costs_no_memory(server: FrameServer, session: Session) -> None:
    with connect(server.url(session)) as client:
        for received in range(1, 5):
            frame = next_frame(client)
            time.sleep(0.3)
            ack(client, received)
        assert frame.time > 0.3 * 60 * 0.5  # not the fourth frame of the gas, but a recent one
        mailbox = session.audience._mailbox
        assert mailbox is not None
        assert mailbox.dropped > 20
        assert mailbox._sent <= 4 + 2


def test_pause_stops_the_frames(server: FrameServer, session: Session) -> None:
    with connect(server.url(session)) as client:
        ack(client, 1) if next_frame(client) else None
        session.pause()
        session.settle()
        received = 1
        while True:
            try:
                frame = next_frame(client)
            except TimeoutError:
                break
            received += 1
            ack(client, received)
            if not frame.playing:
                with pytest.raises(TimeoutError):
                    client.recv(timeout=0.3)
                break
        assert not frame.playing


def test_hidden_stops_the_frames_and_visible_starts_them(server: FrameServer, session: Session) -> None:
    with connect(server.url(session)) as client:
        next_frame(client)
        client.send(json.dumps({"hidden": True}))
        ack(client, 1)
        time.sleep(0.3)
        hidden = session.show.simulation.time
        time.sleep(0.3)
        assert session.show.simulation.time == hidden
        client.send(json.dumps({"hidden": False}))
        ack(client, 2)
        time.sleep(0.3)
        assert session.show.simulation.time > hidden


def test_a_lost_connection_leaves_the_gas_where_it_is(server: FrameServer, session: Session) -> None:
    with connect(server.url(session)) as client:
        for received in range(1, 11):
            last = next_frame(client)
            ack(client, received)
    wait_for_end(session)
    time.sleep(0.1)  # the beat at hand may still end
    stopped = session.show.simulation.time
    time.sleep(0.2)
    assert session.show.simulation.time == stopped
    with connect(server.url(session)) as client:
        assert next_frame(client).time >= last.time
        assert session.version == 1


def test_a_page_loaded_again_goes_on_with_its_gas(server: FrameServer) -> None:
    scenario = gas()
    old, new = server.registry.open(scenario), server.registry.open(scenario)
    with connect(server.url(old)) as client:
        for received in range(1, 11):
            last = next_frame(client)
            ack(client, received)
    wait_for_end(old)
    with connect(server.url(new, f"?previous={old.id}")) as client:
        assert next_frame(client).time >= last.time
    assert server.registry.find(old.id) is None


def test_the_old_socket_may_close_after_the_new_one_has_opened(server: FrameServer) -> None:
    scenario = gas()
    old, new = server.registry.open(scenario), server.registry.open(scenario)
    with connect(server.url(old)) as leaving:
        last = next_frame(leaving)
        simulation = old.show.simulation
        with connect(server.url(new, f"?previous={old.id}")) as client:
            time.sleep(0.1)
            leaving.close()
            assert next_frame(client).time >= last.time
            assert new.show.simulation is simulation


def test_a_guessed_id_is_turned_away(server: FrameServer) -> None:
    with connect(f"ws://127.0.0.1:{server.port}/gasbox/frames/guessed") as client:
        assert json.loads(str(client.recv(timeout=5)))["kind"] == "gone"
        assert read_to_the_end(client) == 4404


def test_a_full_lab_says_so_kindly(server: FrameServer) -> None:
    sessions = [server.registry.open(gas()) for _ in range(4)]
    for session in sessions[:3]:
        session.start()
    with connect(server.url(sessions[3])) as client:
        message = json.loads(str(client.recv(timeout=5)))
        assert (message["kind"], message["places"]) == ("busy", 3)
        assert read_to_the_end(client) == 4503
    assert not sessions[3].started


@pytest.mark.parametrize("nonsense", ["[", "[]", '{"ack": "many"}', '{"ack": null}', "9" * 2000, "{}" * 9000])
def test_nonsense_ends_the_socket_and_nothing_else(
    server: FrameServer, session: Session, nonsense: str
) -> None:
    with connect(server.url(session)) as client:
        next_frame(client)
        client.send(nonsense)
        read_to_the_end(client)
    wait_for_end(session)
    with connect(server.url(session)) as client:
        assert next_frame(client).position.shape == (50, 2)


def test_the_newest_socket_of_a_session_wins(server: FrameServer, session: Session) -> None:
    with connect(server.url(session)) as first:
        next_frame(first)
        with connect(server.url(session)) as second:
            next_frame(second)
            assert read_to_the_end(first) == 4409
            ack(second, 1)
            next_frame(second)


def test_sockets_leave_no_threads_behind(server: FrameServer) -> None:
    session = server.registry.open(gas())
    with connect(server.url(session)) as client:
        next_frame(client)
    wait_for_end(session)
    before = threading.active_count()
    for _ in range(5):
        with connect(server.url(session)) as client:
            next_frame(client)
        wait_for_end(session)
    assert threading.active_count() <= before
