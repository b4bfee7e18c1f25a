"""Epidemics in a well-mixed crowd follow Kermack and McKendrick; where people mix slowly, fewer fall ill."""

import numpy as np
import pytest
from well_mixed import attack_rate, mixed, slow, to_the_end

from gasbox.simulation import Simulation
from gasbox.theory.epidemic import (
    epidemic_curve,
    extinction_probability,
    final_size,
    final_size_deviation,
)

VARIATION = {"exponential": 1.0, "fixed": 0.0}


def outbreaks(r0, law, people, seeds):
    """Final sizes of major outbreaks, and the part of all that stayed small."""
    sizes = np.array([attack_rate(mixed(r0, law, people, seed)) for seed in range(seeds)])
    major = sizes > 0.2
    return sizes[major], 1.0 - major.mean()


def check(r0, law, people, seeds, tolerance):
    sizes, small = outbreaks(r0, law, people, seeds)
    q = extinction_probability(r0, law)
    assert abs(small - q) < tolerance * np.sqrt(q * (1 - q) / seeds)
    spread = final_size_deviation(r0, people, VARIATION[law])
    assert abs(sizes.mean() - final_size(r0)) < tolerance * spread / np.sqrt(sizes.size)
    # The standard deviation of a sample of the normal distribution is known to 1/sqrt(2 n).
    assert sizes.std(ddof=1) / spread == pytest.approx(1.0, abs=tolerance / np.sqrt(2 * sizes.size))


@pytest.mark.parametrize("law", VARIATION)
def test_final_size_and_extinction_of_a_mixed_crowd(law):
    check(2.0, law, 400, 120, 3.5)


@pytest.mark.validate
@pytest.mark.parametrize("law", VARIATION)
@pytest.mark.parametrize("r0", [1.5, 2.0, 3.0])
def test_final_sizes_of_many_large_crowds(r0, law):
    check(r0, law, 2000, 400, 3.5)


@pytest.mark.parametrize("law", VARIATION)
def test_course_of_a_mixed_crowd(law):
    """With many seeds nothing is left to chance at first: rise, peak and fall are those of the equations."""
    people, ill, runs = 2000, 40, 8
    days = np.arange(1.0, 11.0)
    part = np.empty((runs, days.size))
    for seed in range(runs):
        simulation = Simulation(mixed(2.5, law, people, seed, ill, interval=0.05))
        for number, day in enumerate(days):
            simulation.advance(until=day)
            part[seed, number] = simulation.world.summary()["counts"]["infectious"] / people
    curve = epidemic_curve(2.5, 1.0, 10.0, seeds=ill / people, law=law)
    # Seeds are infected at time 0: under a fixed law they recover together, after one day.
    expected = np.interp(days, curve.time, curve.infectious)
    error = part.std(axis=0, ddof=1) / np.sqrt(runs)
    # A step of 0.05 and 60 stages for a fixed time shift the curve by a few thousandths of the people.
    assert (np.abs(part.mean(axis=0) - expected) < 4.0 * error + 0.006)[1:].all()
    assert part.mean(axis=0).max() == pytest.approx(expected.max(), rel=0.05)


def test_growth_of_a_mixed_crowd():
    """While few are immune the number of the infected grows at the rate (R0 - 1)/duration."""
    rates = [
        to_the_end(mixed(3.0, "exponential", 3000, seed, 15, 0.05), 4.0).world.summary()["growth_per_day"]
        for seed in range(5)
    ]
    # Between 1 and 10 % infected, the mean susceptible part is 0.95: the rate is 3 * 0.95 - 1.
    assert np.mean(rates) == pytest.approx(1.85, abs=4 * np.std(rates, ddof=1) / np.sqrt(5) + 0.05)


def test_reproduction_is_estimated_while_it_goes_on():
    """Both estimates are R0 times the part that can still be infected."""
    people, ill, runs = 2000, 100, 6
    live, cohort = [], []
    for seed in range(runs):
        simulation = Simulation(mixed(2.5, "fixed", people, seed, ill, 0.05))
        simulation.advance(until=0.75)
        live.append(simulation.world.view()["r"])
        # By now the infectious time of the seeds is over, and nobody else's.
        simulation.advance(until=1.0)
        cohort.append(simulation.world.view()["r_cohort"])
    curve = epidemic_curve(2.5, 1.0, 1.0, seeds=ill / people, law="fixed")
    early = curve.susceptible[curve.time <= 0.75].mean()
    # Poisson numbers: variance R0 for each of the seeds, more for those who have just begun.
    assert np.mean(cohort) == pytest.approx(2.5 * curve.susceptible.mean(), abs=4 * (2.5 / ill / runs) ** 0.5)
    assert np.mean(live) == pytest.approx(2.5 * early, abs=4 * (2.5 / 0.3 / ill / runs) ** 0.5)


def test_who_does_not_mix_infects_fewer():
    fast, crawling = (
        np.mean([attack_rate(slow(300, seed, speed, 0.08)) for seed in range(6)]) for speed in (20.0, 0.02)
    )
    well_mixed = final_size(0.08 * 3.0 * np.pi * 0.64 * 5, 290 / 300, 10 / 300) / (290 / 300)
    # Near the walls there are fewer to meet, so that even those who run stay below.
    assert crawling < 0.8 * fast
    assert fast < well_mixed + 0.03


def test_nobody_is_lost_and_books_agree():
    world = {"symptomatic": 0.7, "fatality": 0.2, "vaccination": {"per_day": 0.01}, "exposed": {"mean": 1}}
    simulation = to_the_end(slow(300, 3, 5.0, **world))
    summary, counts = simulation.world.summary(), simulation.world.summary()["counts"]
    assert summary["total"] == sum(counts.values()) == simulation.state.count == 300
    assert counts["dead"] > 5
    assert counts["vaccinated"] > 5
    # Whoever was infected, but for the seeds, was infected by somebody.
    people = simulation.world._people
    assert people.passed_on.sum() == summary["final_size"] - 10 == counts["recovered"] + counts["dead"] - 10
    species = np.bincount(simulation.state.species, minlength=7)
    assert species.tolist() == [counts[name] for name in counts]
    series = simulation.world.series()
    assert (sum(series[name] for name in counts) == 300).all()


def test_vaccination_beyond_the_herd_threshold_stops_it():
    stages = ("susceptible", "infectious", "recovered", "vaccinated")
    sizes = [
        attack_rate(
            mixed(
                3.0,
                "exponential",
                1000,
                seed,
                5,
                stages=stages,
                vaccination={"before": share, "efficacy": 0.9},
            )
        )
        for share in (0.9, 0.4)
        for seed in range(4)
    ]
    # 0.9 * 0.9 = 0.81 > 2/3 are immune: five seeds infect some 5 * 0.57/(1 - 0.57) = 7 of 190. With 0.36, 3 * 0.64 > 1.
    assert max(sizes[:4]) < 0.3
    expected = final_size(3.0, 0.64, 0.005) / 0.64
    assert np.mean(sizes[4:]) == pytest.approx(expected, abs=0.08)


@pytest.mark.parametrize(
    "world",
    [
        {"hygiene": 0.2},
        {"distancing": {"strength": 4}},
        {"quarantine": {"probability": 1.0, "delay": 0.5}},
    ],
    ids=lambda world: next(iter(world)),
)
def test_measures_help(world):
    plain, helped = (
        np.mean([attack_rate(slow(100, seed, 1.0, 0.3, **more)) for seed in range(6)]) for more in ({}, world)
    )
    assert helped < 0.6 * plain


def test_collisions_infect_as_kinetic_theory_says():
    """R0 = p omega duration, where omega is the number of collisions of one disc in a time."""
    from gasbox.scenario import parse

    scenario = parse(
        {
            "container": {"width": 60, "height": 60, "periodic": ["x", "y"]},
            "species": [
                {"name": name, "radius": 0.5, "count": count, "temperature": 1 if count else None}
                for name, count in (("susceptible", 380), ("infectious", 20), ("recovered", 0))
            ],
            "dynamics": {"kind": "event-driven"},
            "world": {
                "kind": "epidemic",
                "day": 10,
                "interval": 0.5,
                "transmission": {"by": "contact", "probability": 0.05},
                "infectious": {"law": "fixed", "mean": 1e3},
            },
        }
    )
    simulation = Simulation(scenario)
    simulation.advance(until=15.0)
    summary = simulation.summary()
    infected, rate = summary["world"]["final_size"], summary["collision_rates"]["pairs"] * 2 / 400
    # Nobody recovers: the infected part follows the logistic law with the rate p omega.
    expected = 1 / (1 + 19 * np.exp(-0.05 * rate * 15.0))
    assert infected / 400 == pytest.approx(
        expected, abs=4 * np.sqrt(expected * (1 - expected) / 20) * expected
    )
    assert summary["world"]["total"] == 400
