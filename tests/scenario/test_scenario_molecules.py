"""Molecules in scenarios: what is read, what follows from their atoms, and what is refused."""

import itertools
import json
import math
from copy import deepcopy

import numpy as np
import pytest
from molecule_scenarios import FLEXIBLE, FULL_OF_MOLECULES
from test_scenario_colors import EYES, contrast, lab, linear

from gasbox.errors import ScenarioError
from gasbox.scenario import parse, schema, with_settings
from gasbox.scenario.molecule_models import MODELS, model_atoms
from gasbox.scenario.molecules import Molecule

pytestmark = pytest.mark.small

BOX = {"width": 40, "height": 30}
PAIR = {
    "name": "pair",
    "atoms": [{"position": [0, 0]}, {"position": [1.5, 0]}],
    "bonds": [{"atoms": [0, 1]}],
    "count": 3,
    "temperature": 1,
}
SPRING = {**PAIR, "bonds": [{"atoms": [0, 1], "stiffness": 10}]}
FORCED = {"kind": "forced", "time_step": 0.01}


def refused(**changes):
    with pytest.raises(ScenarioError) as caught:
        parse({"container": BOX, "molecules": [PAIR], **changes})
    return {problem.path: problem for problem in caught.value.problems}


def of(**changes):
    """What is wrong with one molecule."""
    return refused(molecules=[{**PAIR, **changes}])


@pytest.mark.parametrize("data", [FULL_OF_MOLECULES, FLEXIBLE])
def test_everything_comes_back(data):
    scenario = parse(data)
    assert parse(scenario.to_json()) == scenario
    assert parse(json.dumps(data)).hash() == scenario.hash()


def test_kinds_follow_from_the_atoms():
    argon, nitrogen, bent, stick = parse(FULL_OF_MOLECULES).kinds
    assert (argon.name, argon.inertia, argon.sites, argon.is_molecule) == ("argon", 0.0, (0,), False)
    assert nitrogen.mass == pytest.approx(28.014)
    assert nitrogen.place == pytest.approx(np.array([[-1, 0], [1, 0]]) * 1.0977 / 4)
    assert nitrogen.radius == pytest.approx(1.55 / 2 + 1.0977 / 4)
    arm, radius = 1.0977 / 4, 1.55 / 2
    assert nitrogen.inertia == pytest.approx(28.014 * (arm**2 + radius**2 / 2))
    assert (bent.inertia, bent.mass, bent.sites) == (2.5, 5.0, (2, 3, 0))
    assert pytest.approx([0, 0], abs=1e-15) == bent.place.T @ [3, 1, 1]
    assert [bond.length for bond in bent.bonds] == [0.9, pytest.approx(math.hypot(0.7, 0.5))]
    # Three unit discs side by side: the outer ones cover a lens of the middle one, twice.
    lens = 2 * math.pi / 3 - math.sqrt(3) / 2
    assert stick.area == pytest.approx(3 * math.pi - 2 * lens)
    assert stick.half_width == pytest.approx(1 + 2 / math.pi, rel=1e-5)


def test_angles_at_rest_are_those_of_the_atoms():
    data = deepcopy(FLEXIBLE)
    del data["molecules"][0]["angles"][0]["angle"]
    (water,) = parse(data).kinds
    assert water.flexible
    assert water.angles[0].angle == pytest.approx(104.51)
    assert [bond.length for bond in water.bonds] == [pytest.approx(0.9575), 1.0]


def test_discs_of_a_kind_are_known_once():
    scenario = parse(FULL_OF_MOLECULES)
    assert [disc.name for disc in scenario.site_kinds] == [
        "argon",
        "nitrogen:1",
        "bent:1",
        "bent:2",
        "stick:1",
    ]
    assert scenario.site_kinds[2].color == "#112233"
    assert scenario.site_kinds[3].color == "#445566"


@pytest.mark.parametrize("model", MODELS)
def test_models_are_those_of_chemistry(model):
    atoms, bonds = model_atoms(model, 1.0)
    assert len(bonds) == len(atoms) - 1
    charge = sum(atom.charge or 0.0 for atom in atoms)
    assert charge == pytest.approx(0.0, abs=1e-12)
    weights = {"hydrogen": 2.016, "nitrogen": 28.014, "oxygen": 31.998, "water": 18.015}
    weights |= {"carbon-dioxide": 44.009, "methane": 16.043}
    assert sum(atom.mass for atom in atoms) == pytest.approx(weights[model], abs=2e-3)
    twice = model_atoms(model, 2.0)[0]
    assert [atom.radius for atom in twice] == [2 * atom.radius for atom in atoms]
    assert set(MODELS) == set(Molecule.model_json_schema()["properties"]["model"]["anyOf"][0]["enum"])


def test_colours_of_atoms_show_on_light_and_dark_pages():
    colors = {atom.color for model in MODELS for atom in model_atoms(model, 1.0)[0]}
    assert all(contrast(color, page) >= 3 for color in colors for page in ("#ffffff", "#14171c"))
    for eye in EYES.values():
        seen = [lab(np.array(eye) @ linear(color)) for color in colors]
        assert min(np.linalg.norm(one - other) for one, other in itertools.combinations(seen, 2)) > 15


def test_a_species_or_a_molecule_is_required():
    assert (
        str(refused(molecules=[])["species"])
        == "species: found nothing; is required, unless there are molecules"
    )


def test_names_are_told_apart():
    found = refused(
        species=[{"name": "pair"}], molecules=[PAIR, {**PAIR, "name": "a"}, {**PAIR, "name": "a"}]
    )
    assert found["molecules[0].name"].allowed == "each molecule needs its own name; species[0] has it already"
    assert (
        found["molecules[2].name"].allowed == "each molecule needs its own name; molecules[1] has it already"
    )


def test_atoms_are_given_once():
    assert of(atoms=[])["molecules[0].atoms"].allowed == "is required: give atoms, or a model"
    assert of(model="water")["molecules[0].atoms"].found == "atoms beside a model"
    assert of(scale=2)["molecules[0].scale"].allowed == "goes with a model only"
    assert "hydrogen" in of(model="ozone", atoms=[])["molecules[0].model"].allowed


def test_an_atom_of_a_species_has_nothing_of_its_own():
    found = of(atoms=[{"position": [0, 0], "species": "argom", "mass": 2}, {"position": [1, 0]}])
    assert found["molecules[0].atoms[0].species"].found == '"argom"'
    assert found["molecules[0].atoms[0].mass"].allowed == "the species says it already"


@pytest.mark.parametrize("members", [[0, 0], [0, 2], [7, 1]])
def test_bonds_join_different_atoms(members):
    found = of(bonds=[{"atoms": members}])["molecules[0].bonds[0].atoms"]
    assert found.allowed == "must be different atoms, from 0 to 1"


def test_bonds_are_there_once():
    found = of(bonds=[{"atoms": [0, 1]}, {"atoms": [1, 0]}])
    assert (
        found["molecules[0].bonds[1].atoms"].allowed
        == "each only once; molecules[0].bonds[0].atoms has it already"
    )


def test_elastic_bonds_hold_everything_under_forces_alone():
    found = refused(molecules=[SPRING])
    assert found["molecules[0].bonds"].allowed == 'elastic bonds need dynamics kind "forced"'
    three = [*PAIR["atoms"], {"position": [3, 0]}]
    bad = {**SPRING, "atoms": three, "inertia": 3}
    found = refused(molecules=[bad], dynamics=FORCED)
    assert found["molecules[0].bonds"].found == "atoms that no bond holds"
    assert found["molecules[0].inertia"].found == "3"
    bad = {**SPRING, "atoms": three, "bonds": [*SPRING["bonds"], {"atoms": [1, 2]}]}
    assert refused(molecules=[bad], dynamics=FORCED)["molecules[0].bonds[1].stiffness"].found == "nothing"
    bad = {**SPRING, "atoms": [{"position": [1, 1]}] * 2}
    found = refused(molecules=[bad], dynamics=FORCED)["molecules[0].bonds[0].atoms"]
    assert found.allowed == "atoms that a bond holds apart stand at different places"


def test_angles_need_elastic_bonds():
    found = of(atoms=[*PAIR["atoms"], {"position": [3, 1]}], angles=[{"atoms": [0, 1, 2], "stiffness": 1}])
    assert found["molecules[0].angles"].found == "angles of a rigid molecule"


def test_velocities_come_from_one_source():
    assert of(temperature=None)["molecules[0]"].found == "none of them"
    assert of(speed=1)["molecules[0]"].allowed == "only one of temperature, speed"
    found = of(rotational_temperature=1, angular_speed=1)["molecules[0]"]
    assert found.allowed == "only one of rotational_temperature, angular_speed"


@pytest.mark.parametrize("key", ["rotational_temperature", "angular_speed", "inertia"])
def test_an_atom_alone_does_not_rotate(key):
    found = of(atoms=[{"position": [1, 2]}], bonds=[], **{key: 2})[f"molecules[0].{key}"]
    assert (found.found, found.allowed) == ("2", "goes with molecules of more than one atom, which rotate")


def test_discs_are_not_turned():
    listed = [{"species": name, "position": [20, 20], "angle": 0.5} for name in ("pair", "disc")]
    found = refused(species=[{"name": "disc"}], particles=listed)
    assert set(found) == {"particles[1].angle"}
    columns = {"species": ["disc"], "position": [[1, 1]], "angular_velocity": [3]}
    found = refused(species=[{"name": "disc"}], particles=columns)
    assert found["particles.angular_velocity[0]"].found == "3"


def test_charges_need_a_law():
    charged = [{"position": [0, 0], "charge": 1}, {"position": [1, 0], "charge": -1}]
    found = refused(molecules=[{**PAIR, "atoms": charged}], dynamics=FORCED)
    assert {"molecules[0].atoms[0].charge", "molecules[0].atoms[1].charge"} <= set(found)


def test_a_molecule_fits_between_the_walls():
    stick = {**PAIR, "atoms": [{"position": [k, 0]} for k in range(35)]}
    parse({"container": BOX, "molecules": [{**stick, "count": 1}]})
    assert refused(container={"width": 30, "height": 20}, molecules=[stick])["molecules[0].atoms"].found == (
        "a molecule 36 long and 2 wide"
    )
    found = refused(container={**BOX, "periodic": ["x"]}, molecules=[stick])["molecules[0].atoms"]
    assert found.found == "atoms that reach 18 from the centre of mass"
    assert found.allowed.startswith("at most a quarter of the container's width, 10, where it is periodic")


def test_a_molecule_fits_into_its_region():
    def region(x, y):
        return of(region={"x": x, "y": y})

    assert region([5, 8], [5, 7.4])["molecules[0].region"].found == "[5, 8] x [5, 7.4]"
    assert region([5, 4], [5, 7])["molecules[0].region.x"].allowed.startswith("must be [lower end")
    assert (
        region([5, 9], [5, 70])["molecules[0].region.y"].allowed == "must lie inside the container, [0, 30]"
    )
    parse({"container": BOX, "molecules": [{**PAIR, "count": 0, "region": {"x": [5, 8.5], "y": [5, 7]}}]})


def test_atoms_too_small_to_resolve_and_too_large_to_fit():
    atoms = [{"position": [0, 0], "radius": 1e-9}, {"position": [1, 0]}]
    assert of(atoms=atoms)["molecules[0].atoms"].found == "an atom of radius 1e-09"
    circle = {"shape": "circle", "radius": 5}
    found = refused(
        container=circle, molecules=[{**PAIR, "atoms": [{"position": [0, 0], "radius": 6}], "bonds": []}]
    )
    assert "radii up to about 5" in found["molecules[0].atoms"].allowed


def test_all_problems_at_once():
    found = refused(
        species=[{"name": "a", "radius": 50}],
        molecules=[
            {**PAIR, "name": "a"},
            {**PAIR, "name": "b", "atoms": [], "speed": 1},
            {**PAIR, "name": 3},
        ],
        particles=[{"species": "c", "position": [1, 1], "angle": "x"}],
    )
    assert {
        "species[0].radius",
        "molecules[0].name",
        "molecules[1].atoms",
        "molecules[2].name",
        "particles[0].angle",
    } <= set(found)


def test_walls_let_molecules_pass_by_name():
    divider = {"shape": "segment", "start": [20, 0], "end": [20, 30], "passes": ["pair"]}
    parse({"container": BOX, "molecules": [PAIR], "obstacles": [divider]})
    found = refused(obstacles=[{**divider, "passes": ["pear"]}])["obstacles[0].passes.species"]
    assert found.allowed == 'must be one of "pair" (did you mean "pair"?)'


def test_fields_are_set_from_the_command_line():
    scenario = parse(FULL_OF_MOLECULES)
    settings = {"molecules.0.count": "7", "molecules[1].atoms.0.mass": "4"}
    changed = with_settings(scenario, settings)
    assert (changed.molecules[0].count, changed.kinds[2].mass) == (7, 6.0)


def test_unknown_keys_are_named():
    found = of(atom=[], bonds=[{"atoms": [0, 1], "k": 3}])
    assert 'did you mean "atoms"' in found["molecules[0].atom"].allowed
    assert "stiffness" in found["molecules[0].bonds[0].k"].allowed


def test_the_schema_describes_every_field():
    described = schema()["$defs"]
    for name in ("Molecule", "Atom", "Bond", "Bend"):
        assert described[name]["additionalProperties"] is False
        assert all("description" in field for field in described[name]["properties"].values()), name
