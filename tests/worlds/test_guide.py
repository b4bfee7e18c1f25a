"""What a world may do to a run, and that nobody's looking changes it."""

import numpy as np
import pytest
from run_bits import bits

from gasbox.errors import ScenarioError, UsageError
from gasbox.recording import Recorder, open_recording
from gasbox.scenario import ScheduledChange, parse
from gasbox.simulation import Simulation, run
from gasbox.state import ContactKind, MoveWall, RemoveParticles, SetGravity, SetParticles, SetWorld

KINDS = ["event-driven", "stepped", "forced"]
RESCALING = {"kind": "velocity-rescaling", "temperature": 1, "time": 2}
TIME_STEPS = {"stepped": 0.025, "forced": 0.0025}


class Conversion:
    """Whoever is hit by a marked disc becomes one; the gate moves to and fro; some are sent back or removed."""

    reads_contacts = True

    def __init__(self, interval=0.25):
        self.interval, self.turns, self.hits, self.pull = interval, 0, [], 0.0
        self.begun = False

    def start(self, state, geometry):
        self.begun = True
        return [SetParticles(state.id[:2], species=np.ones(2, np.int32))]

    def read(self, contacts):
        rows = contacts.kind[: contacts.count] == ContactKind.PAIR
        self.hits += zip(
            contacts.first[: contacts.count][rows], contacts.second[: contacts.count][rows], strict=True
        )

    def act(self, state, geometry):
        self.turns += 1
        kind = dict(zip(state.id.tolist(), state.species.tolist(), strict=True))
        caught = sorted(
            {
                int(b)
                for pair in self.hits
                for a, b in (pair, pair[::-1])
                if kind.get(int(a)) and not kind.get(int(b), 1)
            }
        )
        self.hits.clear()
        replies = []
        if caught:
            replies.append(SetParticles(np.array(caught), species=np.ones(len(caught), np.int32)))
        if self.turns % 5 == 0:
            replies.append(MoveWall("gate", 2.0 if self.turns % 2 else -2.0, 3.0))
        if self.turns % 7 == 0:
            first = state.id[:1].copy()
            replies.append(SetParticles(first, np.array([[2.0, 2.0]]), np.array([[1.0, 0.5]])))
        if self.turns % 11 == 0:
            replies.append(RemoveParticles(state.id[-1:].copy()))
        if self.pull:
            replies.append(SetGravity((0.0, -self.pull)))
        return replies

    def take(self, change):
        if change.name != "pull":
            raise UsageError(f"there is no setting {change.name}")
        self.pull = change.value

    def memory(self):
        return {"turns": self.turns, "pull": self.pull, "hits": np.array(self.hits, np.int64).reshape(-1, 2)}

    def recall(self, memory):
        self.turns, self.pull = int(memory["turns"]), float(memory["pull"])
        self.hits = [tuple(row) for row in np.asarray(memory["hits"], np.int64).reshape(-1, 2).tolist()]

    def summary(self):
        return {"turns": self.turns}

    def series(self):
        return {}

    def view(self):
        return {}


class Touch(Conversion):
    """Under forces nobody collides: whoever comes near to a marked disc becomes one."""

    def act(self, state, geometry):
        gap = state.position[:, None] - state.position[None]
        near = np.argwhere(np.triu(np.hypot(gap[..., 0], gap[..., 1]) < 0.7, 1))
        self.hits += [(int(a), int(b)) for a, b in state.id[near]]
        return super().act(state, geometry)


def world(kind):
    return Touch() if kind == "forced" else Conversion()


def scenario(kind, **more):
    return parse(
        {
            "container": {"width": 20, "height": 14},
            "obstacles": [{"name": "gate", "shape": "segment", "start": [10, 4], "end": [10, 10]}],
            "species": [
                {"name": "plain", "radius": 0.3, "count": 60, "temperature": 1},
                {"name": "marked", "radius": 0.35, "mass": 2},
            ],
            "dynamics": {"kind": kind, **({"time_step": TIME_STEPS[kind]} if kind in TIME_STEPS else {})},
            **({"thermostat": RESCALING} if kind == "forced" else {}),
            "frame_interval": 0.5,
            "seed": 3,
            **more,
        }
    )


@pytest.mark.parametrize("kind", KINDS)
def test_looking_changes_nothing(kind):
    one, other = (Simulation(scenario(kind), world=world(kind)) for _ in range(2))
    one.advance(until=20.0)
    for time in [0.1, 0.25, 0.3, 1.0, 1.0, 7.3, 12.25, 20.0]:
        other.advance(until=time)
    assert bits(one) == bits(other)
    assert one.state.count < 60
    assert one.state.species.sum() > 10
    assert one.summary()["world"] == {"turns": 80}
    marked = one.state.species == 1
    assert (one.state.mass[marked] == 2).all()
    assert (one.state.radius[~marked] == 0.3).all()


@pytest.mark.parametrize("kind", KINDS)
def test_a_snapshot_goes_on_with_the_same_bits(kind, tmp_path):
    whole = Simulation(scenario(kind), world=world(kind))
    whole.advance(until=6.0)
    whole.apply(SetWorld("pull", 0.2))
    whole.advance(until=7.25)
    whole.save(tmp_path / "now.json")
    later = Simulation.restore(tmp_path / "now.json", world=world(kind))
    assert not later.world.begun
    for each in (whole, later):
        each.advance(until=15.0)
    assert bits(whole) == bits(later)
    assert whole.geometry == later.geometry


@pytest.mark.parametrize("kind", KINDS)
def test_what_was_asked_of_a_world_repeats_as_a_schedule(kind):
    live = Simulation(scenario(kind), world=world(kind))
    for time, pull in [(3.0, 0.1), (4.1, 0.4), (7.5, 0.0)]:
        live.advance(until=time)
        live.apply(SetWorld("pull", pull))
    live.advance(until=12.0)
    assert [change for _, change in live.changes] == [SetWorld("pull", pull) for pull in (0.1, 0.4, 0.0)]
    again = Simulation(scenario(kind), world=world(kind))
    again._plan = [ScheduledChange.of(*entry) for entry in live.changes][::-1]
    again.advance(until=12.0)
    assert bits(live) == bits(again)


def test_without_a_world_nothing_can_be_set():
    with pytest.raises(UsageError, match="no world"):
        Simulation(scenario("event-driven")).apply(SetWorld("pull", 1.0))
    with pytest.raises(UsageError, match="no setting"):
        Simulation(scenario("event-driven"), world=Conversion()).apply(SetWorld("push", 1.0))


@pytest.mark.parametrize("kind", KINDS)
def test_a_recorded_frame_goes_on_with_the_same_bits(kind, tmp_path):
    simulation = Simulation(scenario(kind), world=world(kind))
    with Recorder(tmp_path / "run.h5", simulation.scenario_in_use) as recorder:
        for frame in run(simulation, frames=24):
            recorder.write(frame, {}, simulation.changes)
    with open_recording(tmp_path / "run.h5") as recording:
        middle = Simulation(recording.scenario_at(13), world=world(kind))
    middle.advance(until=12.0)
    assert bits(middle) == bits(simulation)


@pytest.mark.parametrize(
    "broken",
    [{"world_hits": 3}, {"world_turns": None}, {"replies": [[1, 99, 0, 0, 1, 0]]}, {"replies": [[1, 2, 3]]}],
)
def test_a_memory_that_makes_no_sense_is_refused_with_a_sentence(broken):
    simulation = Simulation(scenario("event-driven"), world=Conversion())
    simulation.advance(until=3.0)
    data = simulation.snapshot().to_dict()
    memory = {**data["snapshot"]["memory"], **broken}
    data["snapshot"]["memory"] = {name: value for name, value in memory.items() if value is not None}
    with pytest.raises(ScenarioError, match=r"snapshot\.memory"):
        Simulation.restore(parse(data), world=Conversion())
