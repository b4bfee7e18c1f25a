"""Forces, thermostat, barostat, heating: what a scenario says of them, and what is refused."""

import pytest
from forced_scenarios import ATOM, BOX, FULL

from gasbox.errors import ScenarioError
from gasbox.scenario import ScheduledChange, parse, starting_temperature, with_settings
from gasbox.state import SetBarostat, SetGravity, SetHeating, SetThermostat

pytestmark = pytest.mark.small

WALLED = {"width": 20, "height": 20}
FORCED = {"kind": "forced"}
SEGMENT = {"shape": "segment", "name": "shelf", "start": [5, 5], "end": [9, 5]}


def problems(**sections):
    with pytest.raises(ScenarioError) as caught:
        parse({"container": BOX, "species": [ATOM], "dynamics": FORCED, **sections})
    return {problem.path: problem for problem in caught.value.problems}


def test_everything_reads_back_as_the_same():
    scenario = parse(FULL)
    assert parse(scenario.to_json()) == scenario
    assert with_settings(scenario, {}) == scenario
    assert with_settings(scenario, {"thermostat.temperature": "0.5"}).thermostat.temperature == 0.5


def test_what_is_not_said_is_not_written():
    said = parse({"container": BOX, "species": [ATOM]}).to_dict()
    assert not {"forces", "thermostat", "barostat", "heating", "units"} & set(said)
    assert not {"epsilon", "sigma", "charge", "lattice"} & set(said["species"][0])


def test_changes_and_entries_of_a_schedule_say_the_same():
    changes = [entry.change() for entry in parse(FULL).schedule]
    assert changes == [
        SetThermostat(0.3, 500),
        SetThermostat(None),
        SetBarostat(0.03, 0),
        SetBarostat(None),
        SetHeating(-0.001),
    ]
    for change in [*changes, SetGravity((0, 1))]:
        entry = ScheduledChange.of(3.0, change)
        assert entry.change() == change
        text = entry.model_dump_json(exclude_none=True)
        assert ScheduledChange.model_validate_json(text) == entry


def test_changes_stand_in_snapshots():
    snapshot = {"version": "1", "time": 9, "memory": {}, "changes": FULL["schedule"]}
    snapshot["tallies"] = {
        "pair_virial": [-0.5],
        "pair_collisions": [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
        "wall_impulse": [[0, 0]] * 4,
        "wall_collisions": [[0, 0]] * 4,
    }
    snapshot["tallies"]["pair_collisions"] = [[0, 0], [0, 0]]
    listed = [{"species": "atom", "position": [1, 1]}]
    scenario = parse({**FULL, "particles": listed, "snapshot": snapshot})
    assert parse(scenario.to_json()) == scenario
    assert scenario.snapshot.changes == parse(FULL).schedule


def test_real_units():
    argon = parse(FULL).units
    # kT = 1.654e-21 J; tau = sigma sqrt(m/epsilon), 2.16 ps for argon in every textbook.
    assert argon.temperature == pytest.approx(119.8, rel=1e-3)
    assert argon.time == pytest.approx(2.156e-12, rel=1e-3)
    assert argon.pressure == pytest.approx(1.654e-21 / 3.405e-10**2, rel=1e-12)


def test_the_temperature_of_the_start_is_a_mean_over_discs():
    assert starting_temperature(parse(FULL).species) == pytest.approx((40 * 0.45 + 5 * 0.3) / 45)
    assert starting_temperature(parse({"container": BOX, "species": [{"name": "a"}]}).species) is None


@pytest.mark.parametrize("kind", ["event-driven", "stepped"])
@pytest.mark.parametrize("key", ["forces", "thermostat", "barostat", "heating"])
def test_forces_need_their_own_rule_of_motion(kind, key):
    found = problems(dynamics={"kind": kind}, **{key: FULL[key] if key != "forces" else {}})
    assert str(found[key]) == f'{key}: found dynamics of kind "{kind}"; {key} needs dynamics kind "forced"'


@pytest.mark.parametrize(
    "entry", [{"thermostat": "off"}, {"barostat": {"pressure": 1}}, {"heating": {"power": 1}}]
)
def test_scheduled_baths_need_forces(entry):
    found = problems(dynamics={"kind": "event-driven"}, schedule=[{"at": 1, **entry}])
    assert f"schedule[0].{next(iter(entry))}" in found


@pytest.mark.parametrize(
    ("forces", "place", "sentence"),
    [
        ({"law": "lennard"}, "forces.law", '"lennard-jones"'),
        ({"cutof": 3}, "forces.cutof", 'did you mean "cutoff"?'),
        ({"charges": {"strenght": 3}}, "forces.charges.strenght", 'did you mean "strength"?'),
        ({"pairs": [{"between": ["atom", "atom"], "sgima": 1}]}, "forces.pairs[0].sgima", '"sigma"'),
        ({"pairs": [{"between": ["atom", "atm"]}]}, "forces.pairs[0].between", 'did you mean "atom"?'),
        ({"pairs": [{"between": ["atom", "atom"]}] * 2}, "forces.pairs[1].between", "forces.pairs[0] has it"),
        ({"pairs": [{"between": ["atom"]}]}, "forces.pairs[0].between[1]", "is required"),
        ({"reach": 1.5}, "forces.reach", '"square-well" only'),
        ({"screening_length": 2}, "forces.screening_length", '"yukawa" only'),
        (
            {"law": "yukawa", "pairs": [{"between": ["atom", "atom"], "law": "wca", "screening_length": 1}]},
            "forces.pairs[0].screening_length",
            '"yukawa" only',
        ),
        ({"cutoff": 70}, "container.width", "at least 23.43: forces reach 70.3 far"),
        ({"charges": {"cutoff": 60}}, "container.height", "at least 20.1"),
    ],
)
def test_forces_that_are_refused(forces, place, sentence):
    assert sentence in problems(forces=forces)[place].allowed


def test_a_pair_stands_once_whichever_way_round():
    pairs = [{"between": ["atom", "ion"]}, {"between": ["ion", "atom"]}]
    assert "forces.pairs[1].between" in problems(species=[ATOM, {"name": "ion"}], forces={"pairs": pairs})


def test_a_law_of_one_pair_has_its_own_keys():
    pairs = [{"between": ["atom", "atom"], "law": "square-well"}]
    parse({"container": BOX, "species": [ATOM], "dynamics": FORCED, "forces": {"reach": 1.3, "pairs": pairs}})


def test_a_long_cutoff_between_walls_is_fine():
    sections = {"container": WALLED, "species": [ATOM], "dynamics": FORCED, "forces": {"cutoff": 70}}
    parse(sections)


def test_charges_need_to_be_told_how_they_act():
    found = problems(species=[{**ATOM, "charge": -1}], forces={})
    assert "forces.charges" in found["species[0].charge"].allowed


@pytest.mark.parametrize(
    ("sections", "place"),
    [
        ({"walls": {"left": {"motion": {"kind": "piston", "mass": 1}}}}, "walls.left.motion"),
        (
            {
                "walls": {"left": {"motion": {"kind": "piston", "mass": 1}}},
                "schedule": [{"at": 1, "wall": "left", "free": True}],
            },
            "schedule[0].free",
        ),
    ],
)
def test_walls_that_forces_do_not_know(sections, place):
    assert problems(container=WALLED, **sections)[place].allowed.startswith("not available under forces")


NOT_SMOOTH = [
    ({"walls": {"left": {"open": True}}}, "walls.left.open"),
    ({"obstacles": [{**SEGMENT, "passes": "all"}]}, "obstacles[0].passes"),
    (
        {"obstacles": [SEGMENT], "schedule": [{"at": 1, "wall": "shelf", "present": False}]},
        "schedule[0].present",
    ),
]
FOR_DISCS = [
    *NOT_SMOOTH,
    ({"walls": {"left": {"motion": {"kind": "constant", "speed": 0.1, "stop": 1}}}}, "walls.left.motion"),
    ({"schedule": [{"at": 1, "wall": "left", "displacement": 1}]}, "schedule[0].displacement"),
]


@pytest.mark.parametrize(("sections", "place"), NOT_SMOOTH)
def test_walls_that_push_back_smoothly_let_nobody_through(sections, place):
    parse({"container": WALLED, "species": [ATOM], "dynamics": FORCED, **sections})
    found = problems(container=WALLED, forces={"walls": "repulsive"}, **sections)
    assert found[place].allowed == 'forces.walls "reflecting"'


@pytest.mark.parametrize(("sections", "place"), FOR_DISCS)
def test_walls_that_molecules_under_forces_do_not_know(sections, place):
    water = {"name": "water", "model": "water", "count": 3, "temperature": 1}
    found = problems(container=WALLED, molecules=[water], **sections)
    assert found[place].allowed == "not available for molecules under forces"


def test_warm_walls_must_turn_discs_round():
    found = problems(container=WALLED, walls={"left": {"temperature": 1}}, forces={"walls": "repulsive"})
    assert found["walls.left.temperature"].allowed == 'forces.walls "reflecting"'


@pytest.mark.parametrize(
    ("container", "more", "found"),
    [
        (WALLED, {}, "a container with walls"),
        ({**BOX, "periodic": ["x"]}, {}, "a container with walls"),
        ({"shape": "circle", "radius": 12}, {}, "a container of shape circle"),
        (BOX, {"obstacles": [SEGMENT]}, "obstacles"),
    ],
)
def test_a_barostat_needs_a_plain_periodic_box(container, more, found):
    said = problems(container=container, barostat={"pressure": 1}, **more)["barostat"]
    assert (said.found, said.allowed[:39]) == (found, "needs a rectangle that is periodic in x")
    entries = [{"at": 1, "barostat": {"pressure": 1}}, {"at": 2, "barostat": "off"}]
    assert set(problems(container=container, schedule=entries, **more)) == {"schedule[0].barostat"}


@pytest.mark.parametrize(
    ("sections", "place", "sentence"),
    [
        ({"thermostat": {"temperature": 1}}, "thermostat.kind", '"langevin", "velocity-rescaling"'),
        ({"thermostat": {"kind": "berendsen"}}, "thermostat.kind", '"velocity-rescaling"'),
        ({"thermostat": {"kind": "langevin", "temperture": 1}}, "thermostat.temperture", '"temperature"'),
        ({"barostat": {"pressure": 1, "tmie": 1}}, "barostat.tmie", '"time"'),
        ({"barostat": {}}, "barostat.pressure", "is required"),
        ({"heating": {"power": 1, "tiem": 1}}, "heating.tiem", "known: power"),
        ({"units": {"name": "argon"}}, "units.length", "is required"),
        (
            {"schedule": [{"at": 1, "thermostat": {"temprature": 1}}]},
            "schedule[0].thermostat.temprature",
            '"temperature"',
        ),
        (
            {"schedule": [{"at": 1, "thermostat": {"over": 1}}]},
            "schedule[0].thermostat.temperature",
            "is required",
        ),
        ({"schedule": [{"at": 1, "thermostat": "of"}]}, "schedule[0].thermostat", 'must be "off"'),
        ({"schedule": [{"at": 1, "barostat": 3}]}, "schedule[0].barostat", "must be an object"),
        ({"schedule": [{"at": 1, "thermostat": "off", "barostat": "off"}]}, "schedule[0]", "names one of"),
        ({"schedule": [{"at": 1, "thermostat": "off", "temperature": 1}]}, "schedule[0]", "needs a wall"),
        ({"dynamics": {"kind": "forced", "time_stp": 1}}, "dynamics.time_stp", '"time_step"'),
        ({"frame_interval": 0.012}, "frame_interval", "whole multiple of dynamics.time_step, 0.005"),
        ({"gravity": [0, -1]}, "gravity", "must be 0 along y, which is periodic"),
    ],
)
def test_baths_that_are_refused(sections, place, sentence):
    assert sentence in problems(**sections)[place].allowed


def test_a_thermostat_needs_a_temperature_from_somewhere():
    bath = {"kind": "velocity-rescaling"}
    assert "thermostat.temperature" in problems(species=[{**ATOM, "count": 0}], thermostat=bath)
    for warm in ({"temperature": 1}, {"temperature": None, "speed": 1}):
        parse({"container": BOX, "species": [{**ATOM, **warm}], "dynamics": FORCED, "thermostat": bath})


def test_a_lattice_too_fine_to_resolve():
    assert "species[0].lattice" in problems(species=[{**ATOM, "lattice": 1e-12}])
