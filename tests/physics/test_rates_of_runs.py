"""Collision rates and free paths of event-driven runs against Enskog."""

import math

import numpy as np
import pytest
from runs import gas, measure, one_gas, settle, theory_of, time_for

from gasbox import observe
from gasbox.theory import finite, hard_disc, kinetic


@pytest.mark.parametrize(("eta", "collisions"), [(0.02, 60_000), (0.1, 150_000), (0.3, 200_000)])
def test_collision_rate(eta, collisions):
    # omega = (4/sigma)(Z - 1) sqrt(T/(pi m)), with Z and the mean relative speed of 256 discs at fixed energy.
    simulation = one_gas(256, eta)
    settle(simulation)
    run = measure(simulation, collisions)
    found = observe.collision_rates(run.change, run.duration).per_particle(run.counts)[0, 0]
    excess = hard_disc.finite_compressibility(eta, 256) - 1
    expected = 4 * excess / math.sqrt(math.pi) * finite.rate_factor(510)
    # The number of collisions scatters less than the virial, 1/sqrt(collisions).
    assert found == pytest.approx(expected, rel=3 / math.sqrt(run.collisions))
    bulk = kinetic.collision_rates(theory_of(simulation), 1.0)[0, 0]
    assert found == pytest.approx(bulk, rel=3 / math.sqrt(run.collisions) + 2 / 256)


def test_mean_free_path():
    simulation = one_gas(256, 0.1, seed=2)
    settle(simulation)
    before, begin = simulation.dynamics.tallies.copy(), simulation.time
    frames, mean_speeds = 200, []
    step = time_for(simulation, 100_000) / frames
    for _ in range(frames):
        simulation.advance(until=simulation.time + step)
        mean_speeds.append(observe.mean_speed(simulation.state))
    change, duration = simulation.dynamics.tallies - before, simulation.time - begin
    path = observe.mean_free_path(change, np.array([256]), np.array([np.mean(mean_speeds)]), duration)
    excess = hard_disc.finite_compressibility(0.1, 256) - 1
    # 1/(2 sqrt(2) n sigma chi) with 2 eta chi = Z - 1; a disc has the share 1 - 1/N of the heat, sqrt of it in speed.
    expected = math.pi / (4 * math.sqrt(2)) / excess * math.sqrt(1 - 1 / 256)
    collisions = change.pair_collisions.sum()
    speed_error = np.std(mean_speeds) / np.mean(mean_speeds) / math.sqrt(frames / 4)
    assert path == pytest.approx(expected, rel=3 * math.hypot(1 / math.sqrt(collisions), speed_error))
    assert path == pytest.approx(kinetic.mean_free_path(theory_of(simulation), 1.0), rel=0.02)


def test_each_pair_of_species_in_a_mixture():
    simulation = gas(
        [
            {"count": 300, "mass": 1.0},
            {"count": 200, "mass": 4.0, "radius": 0.75},
            {"count": 80, "mass": 16.0, "radius": 1.25},
        ],
        0.1,
        seed=6,
    )
    settle(simulation, 30)
    run = measure(simulation, 300_000)
    expected = kinetic.pair_rates(theory_of(simulation), simulation.temperature()) * run.duration
    found = run.change.pair_collisions
    pairs = np.triu_indices(3)
    # Contact values of mixtures are good to half a per cent here; 2/580 for the finite number.
    tolerance = 3 / np.sqrt(found[pairs]) + 0.005 + 2 / 580
    assert np.all(np.abs(found[pairs] / expected[pairs] - 1) < tolerance)
    assert found[1, 0] == found[2, 0] == found[2, 1] == 0


def test_observers_count_what_the_tallies_count():
    simulation = gas([{"count": 60, "mass": 1.0}, {"count": 40, "mass": 4.0}], 0.2, periodic=False)
    counter, log = observe.ContactCounter(2, 4), observe.ContactLog()
    for observer in (counter, log):
        simulation.attach(observer)
    simulation.advance(frames=40)
    tallies, rates = simulation.dynamics.tallies, counter.rates()
    np.testing.assert_allclose(rates.per_pair * simulation.time, tallies.pair_collisions)
    np.testing.assert_allclose(rates.per_wall * simulation.time, tallies.wall_collisions)
    assert counter.per_particle.sum() == 2 * tallies.pair_collisions.sum()
    kept = log.contacts()
    assert kept.count == tallies.pair_collisions.sum() + tallies.wall_collisions.sum()
    assert np.all(np.diff(kept.time) >= 0)
    walls = kept.kind == 1
    impulse = np.abs(kept.impulse[walls]).sum(axis=1)
    for wall in range(4):
        total = impulse[kept.second[walls] == wall].sum()
        assert total == pytest.approx(tallies.wall_impulse[wall].sum(), rel=1e-10)


def test_time_series_of_a_run():
    simulation = gas(
        [{"count": 60, "mass": 1.0}, {"count": 40, "mass": 4.0, "radius": 0.8}], 0.2, periodic=False
    )
    observer = observe.TimeSeries(simulation.geometry, np.array([0.5, 0.8]))
    simulation.attach(observer)
    simulation.advance(frames=50)
    series = observer.series()
    np.testing.assert_allclose(series.time, np.arange(51) * simulation.frame_interval, rtol=1e-12)
    np.testing.assert_allclose(series.energy, simulation.energy(), rtol=1e-12)
    np.testing.assert_allclose(series.species_temperature @ [0.6, 0.4], series.temperature, rtol=1e-12)
    # Frames are equally long, so that the mean over them is the pressure of the whole run.
    assert np.mean(series.wall_pressure[1:]) == pytest.approx(simulation.pressure(), rel=1e-12)
    assert observer.series(window=50).wall_pressure[-1] == pytest.approx(simulation.pressure(), rel=1e-12)
    virial = simulation.summary()["pressure_virial"]
    assert np.mean(series.virial_pressure[1:]) == pytest.approx(virial, rel=1e-12)


def test_hits_on_the_walls_of_a_dilute_gas():
    simulation = one_gas(400, 0.004, periodic=False, seed=8)
    settle(simulation, 5)
    run = measure(simulation, 8_000)
    geometry = simulation.geometry
    perimeter = sum(geometry.accessible_length(wall, 0.5) for wall in range(4))
    flux = kinetic.wall_flux(400, 1.0, geometry.accessible_area(0.5), simulation.temperature())
    # The density at the wall is P/T, Z times the mean one.
    expected = flux * perimeter * run.duration * (1 + 2 * 0.004)
    hits = run.change.wall_collisions.sum()
    assert hits == pytest.approx(expected, rel=3 / math.sqrt(expected))
