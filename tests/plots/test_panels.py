"""Panels of what walls, obstacles and gravity add: what is drawn, at which places, under which names."""

import io

import numpy as np
import pytest
from matplotlib.collections import EllipseCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle as Round
from matplotlib.patches import Polygon as Filled

from gasbox import plots
from gasbox.cli.sticks import bonds_between
from gasbox.geometry import Block, Circle, Enclosure, Polygon, Post, Rectangle, Segment, Wall, side_names
from gasbox.initial import populate
from gasbox.observe import CenterSeries, EnergyBalance, IndicatorSeries, Line, Profile, Profiles, SideSeries
from gasbox.plots.balance import MOST_POINTS
from gasbox.scenario import parse
from gasbox.state import State

TIME = np.array([0.0, 1.0, 2.0])
ONE, TWO = [("gas", "#4c9be8")], [("light", "#4c9be8"), ("heavy", "#7bd67b")]

pytestmark = pytest.mark.small


def drawn(panel, *arguments, **settings):
    """The axes after a panel has drawn itself; drawing to a file must work too."""
    figure = Figure()
    axes = figure.add_subplot()
    panel(axes, *arguments, **settings)
    figure.savefig(io.BytesIO(), format="png", dpi=30)
    return axes


def names(axes):
    return axes.get_legend_handles_labels()[1]


def line(axes, name):
    """Values of the line of this name."""
    (found,) = [one for one in axes.lines if one.get_label() == name]
    return found.get_ydata().tolist()


def book(**columns):
    own = ("potential", "work", "heat", "carried", "rest", "changes", "thermostat", "heater", "barostat")
    given = {name: np.zeros(3) for name in own}
    given |= {"kinetic": np.array([10.0, 12.0, 11.0])} | columns
    return EnergyBalance(time=TIME, wall_work=np.zeros((3, 4)), wall_heat=np.zeros((3, 4)), **given)


def test_energies_are_three_lines_only_in_gravity():
    axes = drawn(plots.draw_energies, book())
    assert names(axes) == ["internal"]
    assert axes.get_ylabel() == "energy\n[mass·length²/time²]"
    axes = drawn(plots.draw_energies, book(potential=np.array([5.0, 3.0, 4.0])))
    assert names(axes) == ["kinetic", "potential", "internal"]
    assert line(axes, "internal") == [15.0, 15.0, 15.0]


def test_transfers_show_only_what_was_given():
    axes = drawn(
        plots.draw_transfers, book(work=np.array([0.0, 3.0, 4.0]), carried=np.array([0.0, 1.0, 3.0]))
    )
    assert names(axes) == ["work of walls", "carried away", "internal energy"]
    assert line(axes, "carried away") == [0.0, -1.0, -3.0]
    assert line(axes, "internal energy") == [0.0, 2.0, 1.0]


def diagram(areas, pressures, windows):
    time = np.concatenate([[0.0], np.cumsum(windows)])
    area = np.concatenate([[areas[0]], areas])
    nothing = np.zeros(time.size)
    return IndicatorSeries(
        time, area, nothing, np.concatenate([[np.nan], pressures]), area.copy(), nothing, nothing
    )


def test_pressure_and_area_of_a_few_windows_stand_as_they_are():
    axes = drawn(plots.draw_indicator, diagram([10.0, 9.0, 8.0], [1.0, 2.0, np.nan], [1.0, 1.0, 1.0]))
    assert axes.collections[0].get_offsets().tolist() == [[10.0, 1.0], [9.0, 2.0]]
    assert axes.get_xlabel() == "area [length²]"
    assert axes.get_ylabel() == "pressure [mass/time²]"


def test_many_windows_are_put_together_by_their_duration():
    pairs = MOST_POINTS
    areas, pressures = np.tile([10.0, 14.0], pairs), np.tile([1.0, 5.0], pairs)
    axes = drawn(plots.draw_indicator, diagram(areas, pressures, np.tile([3.0, 1.0], pairs)))
    offsets = np.asarray(axes.collections[0].get_offsets())
    assert offsets.shape == (MOST_POINTS, 2)
    np.testing.assert_allclose(offsets, np.tile([11.0, 2.0], (MOST_POINTS, 1)))
    curve = ("theory", np.array([8.0, 10.0]), np.array([2.0, 1.0]))
    assert names(drawn(plots.draw_indicator, diagram([9.0], [1.0], [1.0]), [curve])) == [
        "on the wall",
        "theory",
    ]


def test_walls_that_are_no_gauge_have_no_row():
    axes = drawn(
        plots.draw_wall_pressures,
        ["left", "gate", "top"],
        np.array([1.0, np.nan, 2.0]),
        np.array([0.1, np.nan, np.nan]),
    )
    assert [text.get_text() for text in axes.get_yticklabels()] == ["left", "top"]
    assert axes.lines[0].get_xdata().tolist() == [1.0, 2.0]
    bar = axes.collections[0].get_segments()[0]
    assert bar[:, 0].tolist() == pytest.approx([0.9, 1.1])


def test_who_passed_counts_forwards_less_backwards():
    passed = np.zeros((3, 1, 2, 2), int)
    passed[:, 0, 0] = [[0, 0], [5, 2], [9, 4]]
    axes = drawn(plots.draw_passed, TIME, passed, ["membrane"], TWO)
    assert line(axes, "light") == [0, 3, 5]
    assert axes.get_title() == "passed membrane"
    assert axes.get_ylabel() == "discs, forwards less backwards"
    # Each way by itself as well; nothing of a species that stays.
    assert len(axes.lines) == 3


def test_who_leaves_counts_upwards():
    passed = np.zeros((3, 2, 1, 2), int)
    passed[:, 0, 0, 1] = [0, 2, 7]
    passed[:, 1, 0, 0] = [0, 1, 1]
    axes = drawn(plots.draw_passed, TIME, passed, ["slit", "door"], ONE)
    assert line(axes, "slit") == [0, 2, 7]
    assert line(axes, "door") == [0, 1, 1]
    assert axes.get_ylabel() == "discs"


def profiles(species):
    one = Profile(np.array([2.0, 1.0, np.nan]), np.array([0.1, np.nan, np.nan]))
    return Profiles("y", np.array([0.0, 1.0, 2.0, 3.0]), 3, (one,) * species, (one,) * species, one, one)


def test_density_with_what_theory_says():
    curve = (np.array([0.0, 3.0]), np.array([2.5, 0.5]))
    axes = drawn(plots.draw_density, profiles(2), TWO, [curve, curve], [curve])
    assert names(axes) == ["barometric law", "hard discs (theory)", "light", "heavy"]
    assert axes.get_xlabel() == "height y [length]"
    assert axes.get_ylabel() == "discs per area [1/length²]"
    assert axes.get_xlim() == (0.0, 3.0)
    assert names(drawn(plots.draw_density, profiles(1), ONE)) == ["gas"]


def test_temperature_along_the_height_starts_at_zero():
    axes = drawn(plots.draw_temperature_profile, profiles(1), ONE, 1.5)
    assert names(axes) == ["whole gas", "gas"]
    # The strip that is known to a fifth, 2.0 ± 0.1, sets the scale.
    assert axes.get_ylim() == (0.0, 3.0)


def sides():
    counts = np.array([[[4, 0], [0, 2]], [[3, 1], [1, 1]], [[2, 2], [1, 1]]])
    return SideSeries(Line((5.0, 0.0), (1.0, 0.0)), TIME, counts, np.zeros(3), np.array([0.0, 0.5, 1.0]))


def test_both_sides_of_a_divider_and_how_mixed_they_are():
    axes = drawn(plots.draw_sides, sides(), TWO)
    assert names(axes) == ["light, left", "light, right", "heavy, left", "heavy, right"]
    assert line(axes, "light, right") == [0, 1, 2]
    assert axes.get_ylabel() == "discs"
    axes = drawn(plots.draw_mixing, sides())
    assert axes.lines[0].get_ydata().tolist() == [0.0, 0.5, 1.0]
    assert axes.get_ylim() == (0.0, 1.05)


def test_centres_of_mass_along_either_axis():
    species = np.arange(12.0).reshape(3, 2, 2)
    series = CenterSeries(TIME, species.mean(axis=1), species)
    axes = drawn(plots.draw_centers, series, TWO, "x")
    assert line(axes, "heavy") == [2.0, 6.0, 10.0]
    assert line(axes, "all") == [1.0, 5.0, 9.0]
    assert axes.get_ylabel() == "x [length]"
    axes = drawn(plots.draw_centers, CenterSeries(TIME, series.whole, species[:, :1]), ONE)
    assert line(axes, "gas") == [1.0, 5.0, 9.0]
    assert axes.get_legend() is None


def state(*displacement):
    return State(
        time=1.5,
        id=np.arange(3),
        species=np.array([0, 1, 1], np.int32),
        mass=np.ones(3),
        radius=np.array([0.5, 1.0, 1.0]),
        position=np.array([[1.0, 1.0], [3.0, 3.0], [6.0, 2.0]]),
        velocity=np.zeros((3, 2)),
        wall_displacement=np.array(displacement),
        wall_velocity=np.zeros(len(displacement)),
    )


def hall(container, *obstacles, **settings):
    sides = [*side_names(container), *(f"obstacle_{k + 1}" for k in range(len(obstacles)))]
    return Enclosure(container, obstacles, tuple(Wall(name, **settings.get(name, {})) for name in sides))


def test_the_gas_has_discs_of_true_size():
    axes = drawn(plots.draw_gas, state(), Rectangle(10.0, 5.0), TWO)
    light, heavy = [one for one in axes.collections if isinstance(one, EllipseCollection)]
    assert light.get_offsets().tolist() == [[1.0, 1.0]]
    assert heavy.get_widths().tolist() == [2.0, 2.0]
    assert axes.get_title() == "time 1.5"
    assert axes.get_aspect() == 1.0
    assert len(axes.lines) == 4


def test_a_piston_and_a_divider_stand_where_they_have_moved():
    box = hall(Rectangle(10.0, 5.0), Segment((4.0, 5.0), (4.0, 0.0)))
    axes = drawn(plots.draw_gas, state(0.0, -2.0, 0.0, 0.0, 1.0), box, TWO)
    ends = [sorted(one.get_xdata().tolist()) for one in axes.lines]
    # Left, right, bottom, top, and the divider, whose normal points to the left.
    assert ends == [[0.0, 0.0], [8.0, 8.0], [0.0, 8.0], [0.0, 8.0], [3.0, 3.0]]


@pytest.mark.parametrize(
    ("container", "lines", "patches"),
    [(Circle(5.0), 0, 1), (Polygon(((0.0, 0.0), (9.0, 0.0), (4.0, 6.0))), 3, 0)],
)
def test_containers_of_any_shape_with_what_stands_in_them(container, lines, patches):
    things = (Block(((4.0, 1.0), (5.0, 1.0), (4.5, 2.0))), Post((4.0, 4.0), 0.5), Segment((3, 1), (3, 2)))
    axes = drawn(plots.draw_gas, state(), hall(container, *things), TWO)
    assert len(axes.lines) == lines + 1
    assert sum(isinstance(one, Round) for one in axes.patches) == patches + 1
    assert sum(isinstance(one, Filled) for one in axes.patches) == 1
    gone = {f"obstacle_{k}": {"present": False} for k in (1, 2, 3)}
    axes = drawn(plots.draw_gas, state(), hall(container, *things, **gone), TWO)
    assert (len(axes.lines), len(axes.patches)) == (lines, patches)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_panels_stand_two_side_by_side(count):
    figure = plots.panels_figure([lambda axes: axes.plot([0, 1])] * count, "Title")
    assert len(figure.axes) == count
    assert figure.get_suptitle() == "Title"
    columns = {round(axes.get_subplotspec().colspan.start) for axes in figure.axes}
    assert columns == ({0} if count == 1 else {0, 1})


def test_molecules_are_drawn_atom_by_atom() -> None:
    pair = {
        "atoms": [{"position": [0, 0]}, {"position": [3, 0], "color": "#112233"}],
        "bonds": [{"atoms": [0, 1]}],
    }
    scenario = parse(
        {
            "container": {"width": 60, "height": 60},
            "species": [{"name": "disc", "count": 2, "temperature": 1}],
            "molecules": [{"name": "pair", "count": 3, "temperature": 1, **pair}],
        }
    )
    state = populate(scenario)
    axes = Figure().subplots()
    colors = [(disc.name, disc.color) for disc in scenario.site_kinds]
    sticks = bonds_between(scenario, state)
    plots.draw_gas(axes, state, scenario.geometry(), colors, sticks=sticks)
    bonds, *discs = axes.collections
    assert [len(found.get_offsets()) for found in discs] == [2, 3, 3]
    assert np.array(bonds.get_segments()) == pytest.approx(state.sites.position[[[2, 3], [4, 5], [6, 7]]])
    assert np.concatenate([found.get_offsets() for found in discs]) == pytest.approx(
        state.sites.position[[0, 1, 2, 4, 6, 3, 5, 7]]
    )
    plots.draw_gas(Figure().subplots(), state, scenario.geometry(), colors[:2], groups=np.zeros(5, np.int8))
