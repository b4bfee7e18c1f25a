"""Panels of matter: what is drawn, in which colours, under which names."""

import io
import itertools

import numpy as np
import pytest
from matplotlib.collections import EllipseCollection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from gasbox import plots
from gasbox.geometry import Rectangle
from gasbox.observe import Displacements, EnergyBalance, HeatingCourse, PairDistribution
from gasbox.plots.heating import STRETCH_COLORS
from gasbox.plots.matter import PHASE_COLORS
from gasbox.state import State

ONE, TWO = [("gas", "#4c9be8")], [("light", "#4c9be8"), ("heavy", "#7bd67b")]
TIME = np.array([0.0, 1.0, 2.0])

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


def test_one_curve_of_g_for_each_pair_of_species():
    r = np.array([0.5, 1.5])
    one = PairDistribution(r, np.array([[[0.0, 2.0]]]), np.array([0.0, 2.0]), 5)
    axes = drawn(plots.draw_rdf, one, ONE)
    assert axes.lines[0].get_ydata().tolist() == [0.0, 2.0]
    assert axes.get_legend() is None
    assert axes.get_xlabel() == "distance r [length]"
    g = np.ones((2, 2, 2))
    g[1, 1] = np.nan
    axes = drawn(plots.draw_rdf, PairDistribution(r, g, np.ones(2), 5), TWO)
    # There is no second heavy disc.
    assert names(axes) == ["light", "light and heavy", "all"]


def test_displacement_with_the_line_of_diffusion():
    found = Displacements(np.arange(5.0), 2.0 * np.arange(5.0))
    axes = drawn(plots.draw_msd, found, 0.5, 2.0)
    assert names(axes) == ["measured", "4 D t, D = 0.5 from time 2 on"]
    assert axes.lines[1].get_xdata().tolist() == [2.0, 3.0, 4.0]
    assert axes.lines[1].get_ydata().tolist() == pytest.approx([4.0, 6.0, 8.0])
    assert axes.get_ylabel() == "mean squared displacement\n[length²]"
    assert len(drawn(plots.draw_msd, found).lines) == 1


def test_order_and_shares_of_phases_over_time():
    axes = drawn(plots.draw_hexatic, TIME, np.array([0.9, 0.5, 0.1]))
    assert axes.lines[0].get_ydata().tolist() == [0.9, 0.5, 0.1]
    assert axes.get_ylim() == (0.0, 1.05)
    shares = np.array([[0.0, 0.1, 0.9], [0.1, 0.5, 0.4], [0.8, 0.2, 0.0]])
    axes = drawn(plots.draw_shares, TIME, shares)
    assert names(axes) == ["solid", "liquid", "gas"]
    assert axes.lines[0].get_ydata().tolist() == [0.9, 0.4, 0.0]


def test_discs_have_the_colour_of_their_phase():
    state = State(
        time=1.5,
        id=np.arange(4),
        species=np.zeros(4, np.int32),
        mass=np.ones(4),
        radius=np.full(4, 0.5),
        position=np.array([[1.0, 1.0], [3.0, 3.0], [6.0, 2.0], [12.0, 2.0]]),
        velocity=np.zeros((4, 2)),
        wall_displacement=np.array([0.0, 3.0, 0.0, 0.0]),
    )
    phases = np.array([0, 2, 2, 0], np.int8)
    axes = drawn(plots.draw_phases, state, Rectangle(10.0, 5.0, True, True), phases)
    gas, solid = [one for one in axes.collections if isinstance(one, EllipseCollection)]
    assert gas.get_offsets().tolist() == [[1.0, 1.0], [12.0, 2.0]]
    assert [to_hex(one.get_facecolor()[0]) for one in (gas, solid)] == [PHASE_COLORS[0], PHASE_COLORS[2]]
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        "solid 50 %",
        "liquid 0 %",
        "gas 50 %",
    ]
    # The box as large as the barostat has made it.
    assert max(line.get_xdata().max() for line in axes.lines) == 13.0


def course(frames=400, back=False):
    """A curve with both transitions, and back again with a lag."""
    ends, warm = [0.0, 0.4, 0.7, 0.8, 1.6, 2.1], [0.2, 0.4, 0.4, 0.44, 0.44, 0.7]
    heat = np.linspace(0.0, 2.1, frames)
    if back:
        heat = np.concatenate([heat, heat[::-1]])
    solid, gas = np.interp(heat, [0.4, 0.7], [1.0, 0.05]), np.interp(heat, [0.8, 1.6], [0.0, 0.95])
    solid = solid * (1.0 - gas)
    shares = np.stack([gas, 1.0 - solid - gas, solid], axis=1)
    cooling = np.arange(heat.size) >= frames
    temperature = np.interp(heat, ends, warm) - 0.02 * cooling
    return HeatingCourse(np.arange(float(heat.size)), heat, heat, temperature, np.ones(heat.size), shares)


def test_stretches_of_a_heating_curve_are_coloured_and_its_latent_heats_written():
    axes = drawn(plots.draw_heating_curve, course())
    assert names(axes) == ["solid", "melting", "liquid", "boiling", "gas"]
    written = [text.get_text() for text in axes.texts]
    assert written[0].startswith("melting: 0.3 ±")
    assert written[0].endswith("at 0.4")
    assert written[1].startswith("boiling: 0.8 ±")
    thick = [line for line in axes.lines if line.get_linewidth() == 2.6]
    assert [line.get_color() for line in thick] == [STRETCH_COLORS[name] for name in names(axes)]
    # The colours meet.
    for one, other in itertools.pairwise(thick):
        assert one.get_xdata()[-1] == other.get_xdata()[0]
    assert axes.get_xlabel() == "heat added, each disc [mass·length²/time²]"


def test_cooling_back_is_dashed():
    axes = drawn(plots.draw_heating_curve, course(back=True))
    assert "cooling back" in names(axes)
    dashed = [line for line in axes.lines if line.get_linestyle() == "--" and len(line.get_xdata())]
    assert len(dashed) == 5
    # Latent heats are those of heating alone.
    assert len(axes.texts) == 2


def test_heat_of_thermostat_and_heater_and_work_of_a_barostat():
    nothing = np.zeros(3)
    own = ("potential", "work", "heat", "carried", "rest", "changes", "thermostat", "heater", "barostat")
    given = dict.fromkeys(own, nothing) | {"kinetic": np.array([10.0, 12.0, 11.0])}
    given |= {"heater": np.array([0.0, 3.0, 4.0]), "barostat": np.array([0.0, -1.0, -3.0])}
    walls = np.zeros((3, 4))
    axes = drawn(plots.draw_transfers, EnergyBalance(time=TIME, wall_work=walls, wall_heat=walls, **given))
    assert names(axes) == ["heat from heater", "work of barostat", "internal energy"]
