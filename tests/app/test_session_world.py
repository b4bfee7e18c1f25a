"""Settings come over the frame socket, what a world shows goes out when it changes, and its table is named."""

import json

import pytest
from free_flight import FreeFlight, gas
from session_steps import open_mailbox

from gasbox.app.session import Session
from gasbox.app.stream import _setting
from gasbox.errors import UsageError
from gasbox.scenario import parse
from gasbox.scenario.pong_table import pong_table
from gasbox.simulation import Simulation
from gasbox.state import SetWorld


class Dial:
    """A world with one number."""

    def __init__(self):
        self.value = 0.0

    def take(self, change):
        if change.name != "dial":
            raise UsageError("there is no such setting")
        self.value = change.value

    def view(self):
        return {"dial": self.value}

    def series(self):
        return {}


class Dialled(FreeFlight):
    def __init__(self, scenario):
        super().__init__(scenario)
        self.world = Dial()

    def apply(self, change):
        self.world.take(change)


@pytest.fixture
def session():
    one = Session(gas(), simulate=Dialled)
    one.pause()
    one.start()
    one.settle()
    yield one
    one.close()


def views(mailbox):
    texts = [json.loads(one) for one in iter(mailbox.take, None) if isinstance(one, str)]
    return [text["view"] for text in texts if text["kind"] == "world"]


def test_a_view_is_told_when_it_changes(session):
    mailbox = open_mailbox(session)
    assert views(mailbox) == [{"dial": 0.0}]
    session.change(_setting("dial", 3)).result(5)
    session.change(_setting("dial", 3)).result(5)
    assert views(mailbox) == [{"dial": 3}]
    assert session.sample().world == {"dial": 3}


def test_a_new_browser_is_told_all(session):
    session.change(SetWorld("dial", 2.0)).result(5)
    assert views(open_mailbox(session)) == [{"dial": 2.0}]


def test_what_is_no_setting_is_refused(session):
    with pytest.raises(UsageError):
        session.change(SetWorld("dail", 1.0)).result(5)
    for name, value in [(3, 1.0), ("dial", [1]), ("dial", None)]:
        with pytest.raises(ValueError, match="setting"):
            _setting(name, value)


def test_a_bat_that_turns_round_needs_no_new_table():
    """A table for each of sixty changes in a second would be too much; the frames say where the bat is."""
    simulation = Simulation(parse(pong_table(gas=5, players=("human", "human"))))
    one = Session(simulation.scenario, simulate=Simulation)
    one.pause()
    one.start(simulation)
    one.settle()
    try:
        mailbox = open_mailbox(one)
        laid = [json.loads(text) for text in iter(mailbox.take, None) if isinstance(text, str)]
        table = next(text for text in laid if text["kind"] == "table")
        assert [wall["motion"] for wall in table["walls"]] == [None] * 5 + ["driven", None, "driven"]
        for push in (1, -1, 1):
            one.change(SetWorld("left_push", push)).result(5)
            one.step().result(5)
            told = [json.loads(text) for text in iter(mailbox.take, None) if isinstance(text, str)]
            assert "table" not in {text["kind"] for text in told}
        assert simulation.state.wall_displacement[5] != 0.0
    finally:
        one.close()
