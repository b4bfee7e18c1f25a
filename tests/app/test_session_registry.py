"""How many sessions there may be, and how long they last."""

from __future__ import annotations

import functools
from collections.abc import Iterator

import pytest
from free_flight import FreeFlight, gas

from gasbox.app.mailbox import Mailbox
from gasbox.app.registry import KEEP, BusyError, Registry
from gasbox.app.session import Session

make = functools.partial(Session, simulate=FreeFlight)


@pytest.fixture
def later() -> list[float]:
    return [0.0]


@pytest.fixture
def registry(later: list[float]) -> Iterator[Registry]:
    import time

    one = Registry(2, make, clock=lambda: time.monotonic() + later[0])
    yield one
    one.close()


def test_ids_are_secret_and_different(registry: Registry) -> None:
    ids = {registry.open(gas()).id for _ in range(20)}
    assert len(ids) == 20
    assert all(len(one) >= 22 for one in ids)
    assert registry.find("guessed") is None


def test_only_so_many_gases(registry: Registry) -> None:
    scenario = gas()
    sessions = [registry.open(scenario) for _ in range(3)]
    sessions[0].start()
    sessions[1].start()
    sessions[0].start()
    with pytest.raises(BusyError, match="2 places"):
        sessions[2].start()
    assert not sessions[2].started
    assert registry.seated == 2


def test_pages_without_a_socket_take_no_place(registry: Registry) -> None:
    for _ in range(50):
        registry.open(gas())
    registry.open(gas()).start()
    assert registry.seated == 1


def test_a_session_outlives_its_browser_for_a_while(registry: Registry, later: list[float]) -> None:
    session = registry.open(gas())
    session.start()
    mailbox = Mailbox(ring=lambda: None)
    session.attach(mailbox)
    later[0] = 10 * KEEP
    registry.sweep()
    assert registry.find(session.id) is session
    later[0] = 0.0
    session.audience.detach(mailbox)
    registry.sweep()
    assert registry.find(session.id) is session
    later[0] = KEEP + 1
    registry.sweep()
    assert registry.find(session.id) is None
    assert registry.seated == 0


def test_a_page_loaded_again_gets_its_gas_back(registry: Registry) -> None:
    scenario = gas()
    old, new = registry.open(scenario), registry.open(scenario)
    old.start()
    old.settle()
    simulation = old.show.simulation
    assert registry.inherit(new, old.id)
    new.settle()
    assert new.show.simulation is simulation
    assert registry.find(old.id) is None
    assert registry.seated == 1


def test_a_duplicated_tab_gets_a_gas_of_its_own(registry: Registry) -> None:
    scenario = gas()
    old, new = registry.open(scenario), registry.open(scenario)
    old.start()
    old.settle()
    old.attach(Mailbox(ring=lambda: None))
    assert not registry.inherit(new, old.id)
    assert not registry.inherit(new, "guessed")
    assert not registry.inherit(new, new.id)


def test_another_start_is_not_inherited(registry: Registry) -> None:
    old, new = registry.open(gas()), registry.open(gas())
    old.start()
    old.settle()
    assert not registry.inherit(new, old.id)


def test_announcements_reach_those_who_are_there(registry: Registry) -> None:
    session = registry.open(gas())
    mailbox = Mailbox(ring=lambda: None)
    session.attach(mailbox)
    registry.announce("soon")
    assert mailbox.take() == "soon"
    assert registry.announcement == "soon"
    registry.announce(None)
    assert mailbox.take() is None
