"""Epidemics in a well-mixed crowd follow Kermack and McKendrick; where people mix slowly, fewer fall ill."""

import numpy as np
import pytest
from well_mixed import SHORT, attack_rate, fixed_time_course, mixed, slow, stirred, to_the_end

from gasbox.scenario import parse
from gasbox.simulation import Simulation
from gasbox.theory.epidemic import (
    epidemic_curve,
    extinction_probability,
    final_size,
    final_size_deviation,
    final_size_mean,
    share_within,
)

VARIATION = {"exponential": 1.0, "fixed": 0.0}


def error(values):
    """Standard error of the mean."""
    return np.std(values, axis=0, ddof=1) / len(values) ** 0.5


def assert_below(low, high):
    """The means of independent runs differ by more than four standard errors."""
    assert np.mean(high) - np.mean(low) > 4 * np.hypot(error(low), error(high))


def outbreaks(r0, law, people, seeds):
    """Final sizes of major outbreaks, and the part of all that stayed small."""
    sizes = np.array([attack_rate(mixed(r0, law, people, seed)) for seed in range(seeds)])
    major = sizes > 0.2
    return sizes[major], 1.0 - major.mean()


def check(r0, law, people, seeds, tolerance):
    sizes, small = outbreaks(r0, law, people, seeds)
    r0, others = stirred(r0, people), people - 1
    q = extinction_probability(r0, law)
    assert abs(small - q) < tolerance * np.sqrt(q * (1 - q) / seeds)
    spread = final_size_deviation(r0, others, VARIATION[law])
    assert abs(sizes.mean() - final_size_mean(r0, others, law)) < tolerance * spread / np.sqrt(sizes.size)
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
    people, ill, runs = 2000, 200, 12
    days = np.array([0.5, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0])
    part = np.empty((runs, days.size))
    for seed in range(runs):
        simulation = Simulation(mixed(2.5, law, people, seed, ill, interval=0.05))
        for number, day in enumerate(days):
            simulation.advance(until=day)
            part[seed, number] = simulation.world.summary()["counts"]["infectious"] / people
    r0, seeds = stirred(2.5, people, 0.05), ill / people
    curve = epidemic_curve(r0, 1.0, 6.0, seeds=seeds)
    expected = np.interp(days, curve.time, curve.infectious)
    if law == "fixed":
        expected = fixed_time_course(r0, seeds, days)
    assert (np.abs(part.mean(axis=0) - expected) < 4 * error(part)).all()


def test_stages_in_a_row_stand_for_a_fixed_time():
    """The sum of 60 scatters by 1/sqrt(60), sqrt(2/pi) of that in the mean: so long are too many or too few ill."""
    days = np.arange(1.6, 6.0, 0.1)  # the seeds, who all recover in one moment, have done so
    curve = epidemic_curve(2.5, 1.0, 6.0, seeds=0.1, law="fixed")
    new = -np.gradient(curve.susceptible, curve.time).min()
    found = np.interp(days, curve.time, curve.infectious) - fixed_time_course(2.5, 0.1, days)
    assert np.abs(found).max() < new * (2 / 60 / np.pi) ** 0.5


def test_growth_of_a_mixed_crowd():
    """While few are immune the number of the infected grows at the rate (R0 - 1)/duration."""
    people, ill = 12_000, 60
    rates = [
        to_the_end(mixed(2.0, "exponential", people, seed, ill, radius=0.5), 4.0).world.summary()[
            "growth_per_day"
        ]
        for seed in range(12)
    ]
    # As the world does it: a line through the logarithm, while 1 to 10 % have been infected.
    curve = epidemic_curve(stirred(2.0, people, radius=0.5), 1.0, 5.0, seeds=ill / people)
    rows = (curve.susceptible < 0.99) & (curve.susceptible > 0.9)
    expected = np.polyfit(curve.time[rows], np.log(curve.infectious[rows]), 1)[0]
    assert np.mean(rates) == pytest.approx(expected, abs=4 * error(rates))


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
        [attack_rate(slow(300, seed, speed, 0.08)) for seed in range(runs)]
        for speed, runs in ((20.0, 32), (0.02, 12))
    )
    # Near the walls there are fewer to meet.
    r0 = 299 * share_within(0.8, 10, 10) * 0.08 * 5
    assert np.mean(fast) == pytest.approx(
        final_size(r0, 290 / 300, 10 / 300) / (290 / 300),
        abs=4 * final_size_deviation(r0, 300, 0.0) / 32**0.5,
    )
    assert_below(crawling, fast)


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


@pytest.mark.parametrize(("before", "runs"), [(0.9, 16), (0.4, 24)])
def test_vaccination_beyond_the_herd_threshold_stops_it(before, runs):
    """0.9 * 0.9 = 0.81 > 2/3 are immune: it dies out. With 0.36, 3 * 0.64 > 1, and most of the others fall ill."""
    people, ill, left = 1000, 5, 1 - 0.9 * before
    given = {"stages": (*SHORT, "vaccinated"), "vaccination": {"before": before, "efficacy": 0.9}}
    found = [attack_rate(mixed(3.0, "exponential", people, seed, ill, **given)) for seed in range(runs)]
    r0 = 3.0 * left
    if r0 < 1:
        # Each seed begins a family: its size has the variance of the numbers infected, R0 (1 + R0), over (1 - R0)^3.
        spread = np.sqrt(ill * r0 * (1 + r0) / (1 - r0) ** 3) / (left * people)
    else:
        # And the number of the immune is left to chance.
        more, fewer = (final_size(3.0, left + way) / (left + way) for way in (0.01, -0.01))
        immune = (more - fewer) / 0.02 * np.sqrt(left * (1 - left) / people)
        spread = np.hypot(final_size_deviation(r0, round(left * people)), immune)
    expected = final_size(3.0, left, ill / people) / left
    assert np.mean(found) == pytest.approx(expected, abs=4 * spread / np.sqrt(runs))


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
        [attack_rate(slow(100, seed, 1.0, 0.3, **more)) for seed in range(8)] for more in ({}, world)
    )
    assert_below(helped, plain)


def test_collisions_infect_as_kinetic_theory_says():
    """R0 = p omega duration, where omega is the number of collisions of one disc in a time.

    Nobody recovers: the infected part x follows the logistic law with the rate p omega. Its variance V grows by
    dV/dt = 2 p omega (1 - 2 x) V + p omega x (1 - x)/N, which is V = (x (1 - x))^2/N times the integral of
    dx/(x (1 - x))^2; while few are infected that of Yule's process. Who has just collided may do so again, which is
    wasted if it infected the first time: less than the part p of the new infections.
    """
    people, ill, probability, until, runs = 400, 80, 0.02, 60.0, 24
    counts = {"susceptible": people - ill, "infectious": ill, "recovered": 0}
    infected, rates = [], []
    for seed in range(runs):
        simulation = Simulation(
            parse(
                {
                    "container": {"width": 60, "height": 60, "periodic": ["x", "y"]},
                    "species": [
                        {"name": name, "radius": 0.5, "count": count, "temperature": 1 if count else None}
                        for name, count in counts.items()
                    ],
                    "dynamics": {"kind": "event-driven"},
                    "world": {
                        "kind": "epidemic",
                        "day": 10,
                        "interval": 0.5,
                        "transmission": {"by": "contact", "probability": probability},
                        "infectious": {"law": "fixed", "mean": 1e3},
                    },
                    "seed": seed,
                }
            )
        )
        simulation.advance(until=until)
        summary = simulation.summary()
        assert summary["world"]["total"] == people
        infected.append(summary["world"]["final_size"] / people)
        rates.append(summary["collision_rates"]["pairs"] * 2 / people)
    first = ill / people
    x = 1 / (1 + (1 / first - 1) * np.exp(-probability * np.mean(rates) * until))
    grown = np.diff([2 * np.log(y / (1 - y)) - 1 / y + 1 / (1 - y) for y in (first, x)])[0]
    spread = x * (1 - x) * np.sqrt(grown / people)
    assert np.mean(infected) == pytest.approx(x, abs=4 * spread / np.sqrt(runs))
