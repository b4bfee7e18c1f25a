"""What ECharts is told: the options of one histogram, and the changes that follow them."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gasbox.units import UNIT

__all__ = [
    "FONT",
    "INK_TEXT",
    "axis_tip",
    "bar_rows",
    "changes",
    "curve_rows",
    "initial",
    "plain_axis",
    "value_axis",
    "words",
]

INK_TEXT = {"color": "var(--muted)", "fontSize": 11}
FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, sans-serif'
_WHOLE = '(value) => value.toLocaleString("en").replaceAll(",", "\\u2009")'
_UNITS = {
    "speed": UNIT["speed"],
    "energy": UNIT["energy"],
    "angular-velocity": UNIT["angular_velocity"],
    "rotational-energy": UNIT["energy"],
}
_ROUND = ((1.0, 2.0, 5.0), (2.5, 3.0, 4.0), (1.5, 6.0, 8.0))
"""Leading digits of the distance of marks, the easiest to read first."""
_TOOLTIP = """(shown) => {
  const [, count, low, high, expected] = shown[0].value;
  const short = (x) => String(+x.toPrecision(3)).replace("-", "\u2212");
  const row = (name, value) => `<tr><td>${name}</td><td>${value}</td></tr>`;
  return `<table class="tip"><caption>QUANTITY ${short(low)} – ${short(high)}</caption>`
    + row("particles", Number.isInteger(count) ? count : count.toFixed(1))
    + row("theory expects", expected === null ? "–" : expected.toFixed(1)) + "</table>";
}"""


def bar_rows(
    edges: NDArray[np.float64], counts: NDArray[np.float64], expected: NDArray[np.float64] | None
) -> list[list[float | None]]:
    """One row per bin: middle, count, low end, high end, count that theory expects."""
    return [
        [
            _short((low + high) / 2),
            _short(count),
            _short(low),
            _short(high),
            None if wanted is None else round(wanted, 2),
        ]
        for low, high, count, wanted in zip(
            edges[:-1].tolist(),
            edges[1:].tolist(),
            counts.tolist(),
            [None] * len(counts) if expected is None else expected.tolist(),
            strict=True,
        )
    ]


def curve_rows(values: NDArray[np.float64], expected: NDArray[np.float64]) -> list[list[float]]:
    """The points of the theory curve."""
    return [[_short(x), round(y, 2)] for x, y in zip(values.tolist(), expected.tolist(), strict=True)]


def _short(value: float) -> float:
    """Five digits are more than a screen shows, and shorter to send."""
    return float(f"{value:.5g}")


def initial(name: str, color: str, quantity: str) -> dict[str, Any]:
    """The options of an empty histogram; colours of text and lines come from the style sheet."""
    return {
        "animation": False,
        "textStyle": {"fontFamily": FONT},
        "aria": {"enabled": True, "label": {"description": _description(name, quantity)}},
        "grid": {"left": 58, "right": 14, "top": 10, "bottom": 42},
        "xAxis": {
            **plain_axis(axis_name(quantity), 26),
            **value_axis(0.0, 1.0, quantity),
            "splitLine": {"show": False},
        },
        "yAxis": {
            **plain_axis("number of particles", 40),
            "min": 0,
            "max": 10,
            "interval": 5,
            "axisLine": {"show": False},
            "axisLabel": {**INK_TEXT, ":formatter": _WHOLE},
        },
        "tooltip": axis_tip(_TOOLTIP.replace("QUANTITY", words(quantity)), snap=True),
        "series": [_bars(color), _curve()],
    }


def value_axis(low: float, high: float, quantity: str) -> dict[str, Any]:
    """What changes about the horizontal axis: its ends, its name, and round marks."""
    step, fits = _marks(high - low, even=low == -high)
    return {
        "min": low,
        "max": high,
        "name": axis_name(quantity),
        "interval": step,
        "axisLabel": {**INK_TEXT, "hideOverlap": True, "showMaxLabel": fits},
    }


def _marks(length: float, *, even: bool) -> tuple[float, bool]:
    """A round distance of marks, four to eight of them, and whether they divide the axis; `even`: one in the middle."""
    for digits, parts in itertools.product(_ROUND, (6, 4, 8) if even else (6, 5, 4, 8, 7)):
        step = float(f"{length / parts:.9g}")
        if float(f"{step:e}".partition("e")[0]) in digits:
            return step, True
    power = 10.0 ** math.floor(math.log10(length / 4))
    return max(unit * power for unit in (1.0, 2.0, 5.0) if unit * power <= length / 4), False


def _description(name: str, quantity: str) -> str:
    return f"Histogram of the {words(quantity)} of {name}: number of particles in each bin, with the curve of theory."


def axis_name(quantity: str) -> str:
    """The name of the horizontal axis, with its unit."""
    return f"{words(quantity)}  ({_UNITS[quantity]})"


def words(quantity: str) -> str:
    """What a quantity is called."""
    return quantity.replace("-", " ")


def axis_tip(formatter: str, **pointer: Any) -> dict[str, Any]:
    """What is told of the place that is pointed at; `formatter` is JavaScript, `pointer` more of the line there."""
    return {
        "trigger": "axis",
        "confine": True,
        "transitionDuration": 0,
        "className": "chart-tip",
        "axisPointer": {
            "type": "line",
            "animation": False,
            "lineStyle": {"color": "var(--muted)"},
            **pointer,
        },
        ":formatter": formatter,
    }


def plain_axis(name: str, gap: int) -> dict[str, Any]:
    """An axis of numbers with its name in the middle, so many pixels away."""
    return {
        "type": "value",
        "name": name,
        "nameLocation": "middle",
        "nameGap": gap,
        "nameTextStyle": INK_TEXT,
        "axisLabel": {**INK_TEXT, "hideOverlap": True},
        "axisLine": {"show": True, "lineStyle": {"color": "var(--line-strong)"}},
        "axisTick": {"lineStyle": {"color": "var(--line-strong)"}},
        "splitLine": {"lineStyle": {"color": "var(--line)"}},
    }


def _bars(color: str) -> dict[str, Any]:
    return {
        "type": "bar",
        "name": "particles",
        "data": [],
        "barWidth": "94%",
        "itemStyle": {"color": color, "opacity": 0.85},
        "emphasis": {
            "itemStyle": {"color": color, "opacity": 1, "borderColor": "var(--ink)", "borderWidth": 1.5}
        },
    }


def _curve() -> dict[str, Any]:
    return {
        "type": "line",
        "name": "theory",
        "data": [],
        "silent": True,
        "showSymbol": False,
        "z": 3,
        "tooltip": {"show": False},
        "lineStyle": {"color": "var(--ink)", "width": 1.8},
        "itemStyle": {"color": "var(--ink)"},
    }


def changes(shown: dict[str, Any], wanted: dict[str, Any]) -> dict[str, Any]:
    """The smallest option that turns what is `shown` into what is `wanted`; `shown` is brought up to date.

    Both hold ``xAxis`` and ``yAxis`` (dicts) and ``series`` (a list of dicts); `wanted` may hold a part of each.
    """
    option: dict[str, Any] = {}
    for axis in ("xAxis", "yAxis"):
        new = {key: value for key, value in wanted.get(axis, {}).items() if shown[axis].get(key) != value}
        if new:
            option[axis] = new
            shown[axis].update(new)
    series = [
        {key: value for key, value in part.items() if old.get(key) != value}
        for old, part in zip(shown["series"], wanted.get("series", []), strict=False)
    ]
    if any(series):
        option["series"] = series
        for old, part in zip(shown["series"], series, strict=False):
            old.update(part)
    return option
