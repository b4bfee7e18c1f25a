"""Forces, energy and virial of every law against LAMMPS, on the same configuration."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from gasbox.bench.lammps_gas import lammps_starts, periodic_box
from gasbox.bench.lammps_rank import Lammps
from gasbox.scenario import parse
from gasbox.simulation import Simulation

pytestmark = pytest.mark.validate

SIDE = 40.0
SMALL = {"name": "small", "radius": 0.48, "sigma": 1.0, "epsilon": 1.0, "charge": 1.5, "count": 500}
LARGE = {"name": "large", "radius": 0.8, "sigma": 1.7, "epsilon": 0.35, "charge": -1.0, "count": 150}
TRUNCATIONS = ("shifted", "force-shifted")
LAWS = {
    "lennard-jones": ("4*epsilon*((sigma/r)^12-(sigma/r)^6)", 2.5),
    "wca": ("4*epsilon*((sigma/r)^12-(sigma/r)^6)", 2 ** (1 / 6)),
    "soft-sphere": ("epsilon*(sigma/r)^12", 2.5),
    "square-well": ("epsilon*((sigma/r)^36-1/(1+exp(40*(r/sigma-1.4))))", 1.9),
    "yukawa": ("epsilon*(sigma/r)*exp(-(r-sigma)/0.8)", 4.0),
}
"""The energy as LAMMPS reads it, and the cutoff in units of sigma."""
Said = tuple[NDArray[np.float64], float, float]


def said_by_lammps(simulation: Simulation, *commands: str) -> Said:
    """Forces (n, 2), potential energy and virial by these laws."""
    if not lammps_starts():
        pytest.skip("LAMMPS is not installed")
    program, state = Lammps(), simulation.state
    program.command(*periodic_box(SIDE, SIDE, types=2))
    program.place(state.species.astype(np.int64) + 1, state.position, state.velocity)
    program.command("mass * 1.0", *commands, "compute pairs all pressure NULL virial")
    program.command("thermo_style custom step pe c_pairs", "thermo_modify norm no", "run 0 post no")
    # In two dimensions the pressure of pairs is their virial over twice the area.
    answer = program.rows("f"), program.value("pe"), program.value("c_pairs") * 2 * SIDE**2
    program.close()
    return answer


def compare(forces: dict[str, Any], commands: Callable[[Simulation], list[str]]) -> None:
    """Both must agree to 1e-10."""
    species: list[dict[str, Any]] = [dict(SMALL), dict(LARGE)]
    if "charges" not in forces:
        for one in species:
            del one["charge"]
    scenario = {
        "seed": 3,
        "container": {"shape": "rectangle", "width": SIDE, "height": SIDE, "periodic": ["x", "y"]},
        "species": [{**one, "temperature": 1.0} for one in species],
        "dynamics": {"kind": "forced"},
        "forces": forces,
    }
    simulation = Simulation(parse(scenario), threads=1)
    wanted, potential, virial = said_by_lammps(simulation, *commands(simulation))
    found, state = simulation.dynamics.forces(simulation.state), simulation.state
    assert np.abs(found - wanted).max() < 1e-10 * np.sqrt(np.mean(wanted**2))
    assert state.potential == pytest.approx(potential, rel=1e-10)
    assert state.virial == pytest.approx(virial, rel=1e-10)


def pair(one: dict[str, Any], other: dict[str, Any]) -> tuple[float, float]:
    """Strength and range by the rule of Lorentz and Berthelot."""
    return float(np.sqrt(one["epsilon"] * other["epsilon"])), 0.5 * (one["sigma"] + other["sigma"])


def cut(energy: str, cutoff: float, truncation: str, **values: float) -> str:
    """An energy with what is taken off at the cutoff, in LAMMPS's words."""
    python, numbers = energy.replace("^", "**"), {**values, "exp": np.exp}
    at = float(eval(python, {"r": cutoff, **numbers}))
    slope = float(np.imag(eval(python, {"r": cutoff + 1e-30j, **numbers}))) / 1e-30
    if truncation == "shifted":
        slope = 0.0
    given = "".join(f"; {name}={value!r}" for name, value in values.items())
    return f"{energy}-({at!r})-({slope!r})*(r-{cutoff!r}){given}"


def lepton(law: Callable[[dict[str, Any], dict[str, Any]], tuple[str, float]]) -> list[str]:
    """Commands for the energies and cutoffs of all three pairs of species, as formulae."""
    lines = ["pair_style lepton 8.0"]
    for i, j, one, other in ((1, 1, SMALL, SMALL), (1, 2, SMALL, LARGE), (2, 2, LARGE, LARGE)):
        energy, cutoff = law(one, other)
        lines.append(f'pair_coeff {i} {j} "{energy}" {cutoff!r}')
    return lines


@pytest.mark.parametrize("truncation", TRUNCATIONS)
def test_lennard_jones_mixed_by_lammps(truncation: str) -> None:
    style = "lj/cut 2.5" if truncation == "shifted" else "lj/smooth/linear 2.5"
    lines = [f"pair_style {style}", "pair_modify mix arithmetic"]
    if truncation == "shifted":
        lines.append("pair_modify shift yes")
    for number, one in ((1, SMALL), (2, LARGE)):
        epsilon, sigma = one["epsilon"], one["sigma"]
        lines.append(f"pair_coeff {number} {number} {epsilon!r} {sigma!r} {2.5 * sigma!r}")
    compare({"law": "lennard-jones", "cutoff": 2.5, "truncation": truncation}, lambda _: lines)


@pytest.mark.parametrize("truncation", TRUNCATIONS)
@pytest.mark.parametrize("law", LAWS)
def test_every_law(law: str, truncation: str) -> None:
    energy, cutoff = LAWS[law]

    def formula(one: dict[str, Any], other: dict[str, Any]) -> tuple[str, float]:
        epsilon, sigma = pair(one, other)
        return cut(energy, cutoff * sigma, truncation, epsilon=epsilon, sigma=sigma), cutoff * sigma

    forces: dict[str, Any] = {"law": law, "truncation": truncation}
    match law:
        case "square-well":
            forces |= {"reach": 1.4}
        case "yukawa":
            forces |= {"screening_length": 0.8, "cutoff": cutoff}
    compare(forces, lambda _: lepton(formula))


def test_charges_alone() -> None:
    def formula(one: dict[str, Any], other: dict[str, Any]) -> tuple[str, float]:
        product = 0.7 * one["charge"] * other["charge"]
        return cut("product*exp(-r/1.3)/r", 6.0, "force-shifted", product=product), 6.0

    charges = {"strength": 0.7, "screening_length": 1.3, "cutoff": 6.0}
    compare({"law": "none", "charges": charges}, lambda _: lepton(formula))


def test_one_pair_of_its_own() -> None:
    def formula(one: dict[str, Any], other: dict[str, Any]) -> tuple[str, float]:
        epsilon, sigma = pair(one, other)
        energy, cutoff = LAWS["lennard-jones"]
        if one is not other:
            epsilon, sigma, cutoff = 2.0, 1.2, 3.0
        return cut(energy, cutoff * sigma, "shifted", epsilon=epsilon, sigma=sigma), cutoff * sigma

    own = {"between": ["small", "large"], "epsilon": 2.0, "sigma": 1.2, "cutoff": 3.0}
    compare({"pairs": [own]}, lambda _: lepton(formula))
