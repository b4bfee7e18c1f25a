"""Energies and temperatures of molecules that can be reckoned in the head."""

import numpy as np
import pytest
from hand_made import gas, hall
from molecules_by_hand import dumbbell_and_disc, sites, spring

from gasbox import observe
from gasbox.geometry import Circle, Rectangle
from gasbox.state import Tallies

WALLS = Rectangle(10.0, 20.0)
TORUS = Rectangle(10.0, 20.0, periodic_x=True, periodic_y=True)
ROUND = Circle(10.0)

pytestmark = pytest.mark.small


def test_a_dumbbell_has_three_degrees_of_freedom_and_a_disc_two():
    state = dumbbell_and_disc()
    assert observe.degrees_of_freedom(state, WALLS) == 5
    assert observe.degrees_of_freedom(state, TORUS) == 3
    assert observe.degrees_of_freedom(state.count, WALLS) == 4
    assert observe.kinetic_energy(state) == 10.0 + 36.0 + 9.0
    assert observe.temperature(state, WALLS) == 2 * 55.0 / 5
    assert observe.translational_temperature(state, WALLS) == 2 * 19.0 / 4
    assert observe.rotational_temperature(state, WALLS) == 2 * 36.0
    assert observe.rotational_temperature(state, WALLS, 0) is None
    assert observe.species_temperature(state, WALLS, 1) == 10.0
    assert observe.vibrational_temperature(state) is None


def test_a_drift_is_no_heat_but_rotation_is():
    state = dumbbell_and_disc()
    # The centre of mass moves with (5/3, 4/3): 0.5 * 6 * 41/9 is taken off.
    assert observe.thermal_energy(state, TORUS) == pytest.approx(55.0 - 41.0 / 3)
    assert observe.translational_temperature(state, TORUS) == pytest.approx(2 * (19.0 - 41.0 / 3) / 2)


def test_a_single_molecule_in_a_periodic_box_is_as_warm_as_it_spins():
    state = dumbbell_and_disc()
    state.keep(np.array([True, False]))
    assert observe.degrees_of_freedom(state, TORUS) == 1
    assert observe.temperature(state, TORUS) == pytest.approx(2 * 36.0)
    assert observe.translational_temperature(state, TORUS) is None
    assert observe.species_temperature(state, TORUS, 1) is None


def test_what_turns_like_a_rigid_body_is_cold():
    state = dumbbell_and_disc(position=[[13.0, 10.0], [10.0, 6.0]], spin=0.7)
    arm = state.position - 10.0
    state.velocity = 0.7 * np.stack([-arm[:, 1], arm[:, 0]], axis=1)
    state.turn_sites()
    # L = 0.7 (4 * 9 + 2 * 16 + 8).
    assert observe.angular_momentum(state, (10.0, 10.0)) == pytest.approx(0.7 * 76.0)
    assert observe.temperature(state, hall(ROUND)) == pytest.approx(0.0, abs=1e-12)
    assert observe.rotational_temperature(state, hall(ROUND)) == pytest.approx(0.0, abs=1e-12)
    state.angular_velocity[0] += 1.0
    # The frame turns faster by 8/76; what is left is 0.5 * (8 - 64/76).
    assert observe.thermal_energy(state, hall(ROUND)) == pytest.approx(0.5 * (8.0 - 64.0 / 76.0))
    assert observe.degrees_of_freedom(state, hall(ROUND)) == 4


def test_a_spring_rotates_and_vibrates():
    state = spring()
    assert observe.degrees_of_freedom(state, WALLS) == 4
    assert observe.kinetic_energy(state) == pytest.approx(10.0 + 12.0)
    assert observe.rotational_energies(state) == pytest.approx([6.0])
    assert observe.vibrational_energies(state) == pytest.approx([6.0])
    assert observe.angular_momentum(state, (3.0, 0.0)) == pytest.approx(12.0)
    assert observe.temperature(state, WALLS) == pytest.approx(2 * 22.0 / 4)
    assert observe.vibrational_temperature(state) == pytest.approx(12.0)


def test_the_sum_over_sites_is_the_kinetic_energy_of_a_flexible_gas():
    generator = np.random.default_rng(4)
    first = [0, 2, 5, 6, 10]
    count, mass = first[-1], generator.uniform(1, 3, 10)
    velocity, position = generator.normal(size=(count, 2)), generator.normal(size=(count, 2))
    whole = np.add.reduceat(mass, first[:-1])
    centre = np.add.reduceat(mass[:, None] * velocity, first[:-1]) / whole[:, None]
    state = gas(centre, mass=whole)
    state.angle = state.angular_velocity = np.zeros(4)
    state.inertia = np.array([1.0, 1.0, 0.0, 1.0])
    state.sites = sites(first, mass, position, None, velocity, [True, True, False, True])
    assert observe.kinetic_energy(state) == pytest.approx(0.5 * np.sum(mass @ velocity**2))
    assert observe.degrees_of_freedom(state, WALLS) == 2 * count


def test_energies_of_each_degree_of_freedom():
    state = dumbbell_and_disc()
    whole = observe.mode_energies(state, WALLS)
    assert (whole.x, whole.y, whole.rotation, whole.vibration) == ((2.0 + 9.0) / 2, 4.0, 36.0, None)
    disc = observe.mode_energies(state, WALLS, 0)
    assert (disc.x, disc.y, disc.rotation, disc.vibration) == (9.0, 0.0, None, None)
    assert observe.mode_energies(state, WALLS, 7) is None
    flexible = observe.mode_energies(spring(), WALLS)
    assert (flexible.rotation, flexible.vibration) == (pytest.approx(6.0), pytest.approx(6.0))
    discs = observe.mode_energies(gas([[1.0, 2.0]]), WALLS)
    assert (discs.x, discs.y, discs.rotation) == (0.5, 2.0, None)


def test_energies_over_time():
    modes, tallies = observe.Modes(WALLS), Tallies.zero(2, 4)
    state = dumbbell_and_disc()
    modes.start(state, tallies)
    modes.observe(state, tallies)
    state.time, state.angular_velocity = 1.0, np.array([1.0, 0.0])
    modes.observe(state, tallies)
    series = modes.series()
    assert series.time.tolist() == [0.0, 1.0]
    assert series.rotation.tolist() == [36.0, 4.0]
    assert np.isnan(series.vibration).all()


def test_the_book_of_energy_and_the_heating_curve_know_rotation():
    book, tallies = observe.Balance(WALLS, np.array([2.0, 4.0])), Tallies.zero(2, 4)
    book.start(dumbbell_and_disc(), tallies)
    assert book.series().kinetic.tolist() == [55.0]
    curve = observe.HeatingCurve(WALLS)
    curve.start(dumbbell_and_disc(), tallies)
    later, state = tallies.copy(), dumbbell_and_disc()
    state.time = 2.0
    later.measured_time[0], later.kinetic_time[0], later.rotational_time[0] = 2.0, 2 * 19.0, 2 * 36.0
    curve.observe(state, later)
    assert curve.value().temperature == pytest.approx([22.0, 22.0])


def test_molecules_press_with_the_motion_of_their_centres():
    series = observe.TimeSeries(TORUS, np.array([1.0, 1.0]))
    state, tallies = dumbbell_and_disc(), Tallies.zero(2, 4)
    series.start(state, tallies)
    state.time = 1.0
    series.observe(state, tallies)
    flight = observe.translational_temperature(state, TORUS)
    assert series.series().virial_pressure[1] == pytest.approx(2 * flight / 200.0)


def test_histograms_of_molecules():
    state = dumbbell_and_disc()
    edges = np.linspace(0.0, 60.0, 4)
    counts = {
        what: observe.histogram(state, None, edges, what).counts.tolist()
        for what in ("energy", "rotational-energy", "whole-energy", "angular-velocity")
    }
    # Flight 10 and 9; rotation 36 of the dumbbell alone.
    assert counts == {
        "energy": [2.0, 0.0, 0.0],
        "rotational-energy": [0.0, 1.0, 0.0],
        "whole-energy": [1.0, 0.0, 1.0],
        "angular-velocity": [1.0, 0.0, 0.0],
    }
    assert observe.histogram(state, 0, edges, "rotational-energy").total == 0
    assert observe.histogram(spring(), 0, edges, "whole-energy").counts.tolist() == [0.0, 1.0, 0.0]
    average = observe.HistogramAverage([edges, edges], "rotational-energy")
    average.observe(state, Tallies.zero(2, 4))
    assert [one.total for one in average.histograms()] == [0.0, 1.0]
