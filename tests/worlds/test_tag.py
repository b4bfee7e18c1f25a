"""The world that the documentation builds: what it says of itself is what happened."""

import importlib.util
from typing import get_args

import numpy as np
import pytest

from gasbox.errors import UsageError
from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.state import ContactKind, Reply, SetWorld


class Hits:
    """All pairs that have met, with their times."""

    reads_contacts = True

    def start(self, state, tallies):
        self.rows = []

    def read(self, contacts):
        rows = np.flatnonzero(contacts.kind[: contacts.count] == ContactKind.PAIR)
        self.rows += [(contacts.time[k], contacts.first[k], contacts.second[k]) for k in rows]

    def observe(self, state, tallies):
        pass


@pytest.fixture
def tag(repository):
    spec = importlib.util.spec_from_file_location("tag_example", repository / "examples" / "tag.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.Tag


def yard(kind="event-driven"):
    return parse(
        {
            "container": {"width": 20, "height": 15},
            "species": [
                {"name": "players", "radius": 0.5, "count": 40, "temperature": 1},
                {"name": "it", "radius": 0.5},
            ],
            "dynamics": {"kind": kind, **({"time_step": 0.02} if kind == "stepped" else {})},
            "seed": 4,
        }
    )


def test_the_page_shows_the_example(repository):
    code = (repository / "examples" / "tag.py").read_text("utf-8")
    assert len(code.splitlines()) <= 60
    assert f"```python\n{code}```" in (repository / "docs" / "worlds.md").read_text("utf-8")


def test_the_page_names_all_that_a_world_may_answer(repository):
    page = (repository / "docs" / "worlds.md").read_text("utf-8")
    assert [each.__name__ for each in get_args(Reply) if f"| `{each.__name__}(" not in page] == []


@pytest.mark.parametrize("kind", ["event-driven", "stepped"])
def test_each_tag_was_a_hit(tag, kind):
    hits = Hits()
    simulation = Simulation(yard(kind), [hits], world=tag())
    simulation.advance(until=30.0)
    it, times = 0, [0.0]
    for time, first, second in hits.rows:
        if it in (first, second) and time >= times[-1] + 0.5:
            it = second if it == first else first
            times.append(time)
    assert simulation.summary()["world"] == {"it": it, "tags": len(times) - 1}
    assert len(times) > 10
    np.testing.assert_array_equal(simulation.world.series()["time"], times)
    # Who became it since the last turn is shown at the next one.
    simulation.advance(until=30.1)
    assert simulation.state.id[simulation.state.species == 1].tolist() == [simulation.world.shown]


def test_it_goes_on_from_a_snapshot(tag, tmp_path):
    whole = Simulation(yard(), world=tag())
    whole.advance(until=4.03)
    whole.apply(SetWorld("pause", 1.0))
    whole.save(tmp_path / "now.json")
    later = Simulation.restore(tmp_path / "now.json", world=tag())
    for each in (whole, later):
        each.advance(until=9.0)
    assert whole.world.memory()["times"].tolist() == later.world.memory()["times"].tolist()
    assert whole.state.velocity.tobytes() == later.state.velocity.tobytes()
    assert whole.summary()["world"]["tags"] > 3


def test_a_setting_that_is_not_there_is_refused(tag):
    with pytest.raises(UsageError, match="no setting pace"):
        Simulation(yard(), world=tag()).apply(SetWorld("pace", 1.0))
