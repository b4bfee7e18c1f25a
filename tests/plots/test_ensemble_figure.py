"""Figures of many runs: fans over time and histograms, with labels, units and room for the legend."""

import math

import numpy as np

from gasbox.plots import Fan, Mark, Pile, ensemble_figure

TIME = np.linspace(0.0, 10.0, 21)


def fan(name="sick", runs=40):
    rng = np.random.default_rng(5)
    return Fan(name, "#c2410c", rng.poisson(20.0, (runs, 1)) * np.exp(-0.1 * TIME))


def test_a_fan_shows_the_median_where_most_runs_lie_and_some_of_them():
    shown = fan()
    axes = ensemble_figure(TIME, [("sick people", [shown])], []).axes[0]
    (median,) = [line for line in axes.lines if line.get_label() == "sick, median"]
    np.testing.assert_allclose(median.get_ydata(), np.median(shown.values, axis=0))
    assert len([line for line in axes.lines if len(line.get_xdata()) == TIME.size]) == 7
    top = axes.collections[0].get_paths()[0].vertices[:, 1].max()
    assert top == np.quantile(shown.values[:, 0], 0.95)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time [time]", "sick people")


def test_a_pile_holds_all_runs_that_have_a_value():
    values = np.array([1.0, 2.0, 2.0, 5.0, math.nan])
    axes = ensemble_figure(TIME, [], [Pile("hits", "", values), Pile("pressure", "mass/time²", values)]).axes
    assert [each.get_xlabel() for each in axes] == ["hits", "pressure [mass/time²]"]
    counts, edges, _ = axes[0].patches[0].get_data()
    assert counts.sum() == 4
    # Whole numbers stand in the middle of their bars.
    assert edges[0] == 0.5
    assert np.all(np.diff(edges) == 1.0)


def test_values_that_come_in_steps_make_no_comb():
    rng = np.random.default_rng(2)
    for step, jitter in ((1.0, 0.0), (0.75, 0.01), (1 / 995, 0.0)):
        values = step * (200 + rng.binomial(120, 0.5, 1000)) + rng.choice([0.0, jitter], 1000)
        counts, edges, _ = ensemble_figure(TIME, [], [Pile("a", "", values)]).axes[0].patches[0].get_data()
        assert counts.sum() == 1000
        held = np.diff(edges) / step
        np.testing.assert_allclose(held, np.round(held), atol=0.01)
    smooth = rng.normal(size=1000)
    _, edges, _ = ensemble_figure(TIME, [], [Pile("a", "", smooth)]).axes[0].patches[0].get_data()
    assert edges.size == 41


def test_marks_have_names_and_the_legend_covers_no_bar():
    pile = Pile("size", "", np.linspace(0.7, 0.9, 50), [Mark("theory", 0.8, 0.02), Mark("mean", 0.81)])
    axes = ensemble_figure(TIME, [], [pile]).axes[0]
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        "theory",
        "± its standard deviation",
        "mean",
    ]
    highest = axes.patches[0].get_data().values.max()
    assert axes.get_ylim()[1] > (1.0 + 3 * 0.1) * highest


def test_numbers_that_never_differ_or_are_not_there_are_drawn_too(tmp_path):
    piles = [Pile("same", "", np.full(9, 3.25)), Pile("none", "", np.full(9, np.nan))]
    gaps = fan(runs=1)
    gaps.values[:, 3] = np.nan
    ensemble_figure(TIME, [("a", [gaps])], piles, "One run").savefig(tmp_path / "a.png")
