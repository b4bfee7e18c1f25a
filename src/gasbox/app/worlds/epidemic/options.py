"""What ECharts is told of an epidemic: stacked stages, reproduction number, two runs over each other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.chart_options import FONT, INK_TEXT, axis_tip, plain_axis
from gasbox.app.worlds.epidemic.course import STAGES, Course, Mark
from gasbox.app.worlds.thinning import thinned

__all__ = ["COLORS", "runs", "runs_now", "spread", "spread_now", "stages", "stages_now"]

COLORS: Final = ("var(--accent)", "var(--heat)")
"""Of run A and run B."""
_TIP: Final = """(shown) => {
  const short = (x) => SHOW;
  const rows = shown.filter((one) => one.value[one.encode.y[0]] != null).map((one) =>
    `<tr><td>${one.marker}${one.seriesName}</td><td>${short(one.value[one.encode.y[0]])}</td></tr>`);
  if (!rows.length) return "";
  return `<table class="tip"><caption>day ${shown[0].value[0].toFixed(1)}</caption>${rows.reverse().join("")}</table>`;
}"""
_WHOLE: Final = 'x.toLocaleString("en").replaceAll(",", "\\u2009")'
_LEFT: Final = 58
_SHORT: Final = {
    "probability_per_day": "infection",
    "distancing_fraction": "distancing of",
    "quarantine_probability": "quarantine",
    "travel_rate": "travel",
    "central_visits": "visits",
    "vaccination_per_day": "vaccination",
}
_SAME_TIME: Final = 0.05
"""Days."""
_MOST_LINES: Final = 12
_FIRST: Final = 2.0
"""Days in which the reproduction number is that of a few people, and sets no scale."""


def stages(names: Sequence[str], colors: Mapping[str, str], people: int) -> dict[str, Any]:
    """Everybody by stage of the disease, stacked; `colors` are those of the species."""
    stacked = [name for name in STAGES if name in names]
    series = [
        {
            "type": "line",
            "name": name,
            "stack": "people",
            "encode": {"x": 0, "y": place + 1},
            "showSymbol": False,
            "silent": True,
            "lineStyle": {"width": 0},
            "areaStyle": {"color": colors[name], "opacity": 0.85},
            "itemStyle": {"color": colors[name]},
        }
        for place, name in enumerate(stacked)
    ]
    return {
        **_frame("People in each stage of the disease over the days, stacked.", _WHOLE, legend=stacked),
        "yAxis": {**_axis("people"), "min": 0, "max": people, **_even(people)},
        "dataset": {"source": []},
        "series": [{**series[0], "markLine": _lines([])}, *series[1:]],
    }


def stages_now(series: Mapping[str, NDArray[np.float64]], said: Sequence[Mark]) -> dict[str, Any]:
    """What is new about it, with lines where measures were changed."""
    names = [name for name in STAGES if name in series]
    chosen = thinned(series["day"].size)
    rows = np.stack([series[name][chosen] for name in ("day", *names)], axis=1)
    return {
        "dataset": {"source": _rows(rows)},
        "legend": {"data": _legend([name for name in names if series[name].any()])},
        "series": [{"markLine": {"data": _at(said)}}],
    }


def spread() -> dict[str, Any]:
    """The reproduction number over the days, with the line where an epidemic neither grows nor shrinks."""
    one = {
        "silent": True,
        "symbol": "none",
        "lineStyle": {"color": "var(--muted)", "width": 1.2, "type": "dashed"},
        "label": {"show": False},
        "data": [{"yAxis": 1}],
    }
    series = [_curve("R now", 1, COLORS[0], dashed=False), _curve("R now, B", 2, COLORS[1], dashed=True)]
    return {
        **_frame("Reproduction number over the days, with a line at 1.", "x.toFixed(2)"),
        "yAxis": {**_axis("infected by each"), "min": 0, "max": 3},
        "dataset": {"source": []},
        "series": [{**series[0], "markLine": one}, series[1]],
    }


def spread_now(first: Course, second: Course | None) -> dict[str, Any]:
    """What is new about it, of one run or of two."""
    rows = _side_by_side((first.days, first.spread), None if second is None else (second.days, second.spread))
    late = [row for row in rows if (row[0] or 0.0) > _FIRST] or rows
    highest = max((value for row in late for value in row[1:] if value is not None), default=0.0)
    top = next(end for end in (2, 3, 4, 6, 8, 10, 20) if end >= min(highest, 20.0))
    return {
        "dataset": {"source": rows},
        "yAxis": {"max": top, "interval": 1 if top < 6 else 2 if top < 10 else top / 2},
    }


def runs() -> dict[str, Any]:
    """Infected people of two runs."""
    percent = '+x.toPrecision(3) + "\\u202f%"'
    return {
        **_frame("Infected people over the days, in per cent of all: A solid, B dashed.", percent),
        "yAxis": {**_axis("infected  (%)"), "min": 0, "axisLabel": _labels("x")},
        "dataset": {"source": []},
        "series": [_curve("A", 1, COLORS[0], dashed=False), _curve("B", 2, COLORS[1], dashed=True)],
    }


def runs_now(first: Course, second: Course) -> dict[str, Any]:
    """What is new about them."""
    both = [(one.days, 100.0 * one.share) for one in (first, second)]
    return {"dataset": {"source": _side_by_side(*both)}}


def _side_by_side(
    first: tuple[NDArray[np.float64], NDArray[np.float64]],
    second: tuple[NDArray[np.float64], NDArray[np.float64]] | None,
) -> list[list[float | None]]:
    """Rows of day, value of the first run, and value of the second on that day."""
    days, values = first
    others, second_values = second or (np.zeros(0), np.zeros(0))
    longer = days if days.size >= others.size else others
    chosen = longer[thinned(longer.size)]
    nothing = np.full(chosen.size, np.nan)
    columns = [
        np.interp(chosen, x, y, left=np.nan, right=np.nan) if x.size else nothing
        for x, y in ((days, values), (others, second_values))
    ]
    return _rows(np.stack([chosen, *columns], axis=1))


def _rows(table: NDArray[np.float64]) -> list[list[float | None]]:
    return [[float(f"{x:.5g}") if np.isfinite(x) else None for x in row] for row in table.tolist()]


def _at(said: Sequence[Mark]) -> list[dict[str, Any]]:
    """One line for what was changed at the same time."""
    lines: list[dict[str, Any]] = []
    for mark in said:
        day, text = round(mark.day, 2), f"{_short(mark.name)} {_value(mark.value)}"
        if lines and day - lines[-1]["xAxis"] < _SAME_TIME:
            text = f"{lines.pop()['name'].removesuffix(' …')} …"
        lines.append({"xAxis": day, "name": text})
    return lines[-_MOST_LINES:]


def _short(name: str) -> str:
    return _SHORT.get(name, name.replace("_", " "))


def _value(value: float | str | bool) -> str:
    return f"{value:.3g}" if isinstance(value, float | int) else str(value)


def _lines(data: list[dict[str, Any]]) -> dict[str, Any]:
    """Thin upright lines with their names along them."""
    return {
        "silent": True,
        "symbol": "none",
        "animation": False,
        "lineStyle": {"color": "var(--ink)", "width": 1, "type": "solid", "opacity": 0.7},
        "label": {
            "show": True,
            "position": "insideEndBottom",
            "formatter": "{b}",
            "color": "var(--ink)",
            "fontSize": 10,
            "distance": 2,
        },
        "data": data,
    }


def _curve(name: str, place: int, color: str, *, dashed: bool) -> dict[str, Any]:
    return {
        "type": "line",
        "name": name,
        "encode": {"x": 0, "y": place},
        "showSymbol": False,
        "silent": True,
        "lineStyle": {"color": color, "width": 2, "type": "dashed" if dashed else "solid"},
        "itemStyle": {"color": color},
    }


def _axis(name: str) -> dict[str, Any]:
    return {**plain_axis(name, 40), "axisLine": {"show": False}, "splitNumber": 4}


def _even(people: int) -> dict[str, Any]:
    """Marks at round numbers of people."""
    power = 10.0 ** np.floor(np.log10(max(people, 10) / 4.0))
    step = max(unit * power for unit in (1.0, 2.0, 2.5, 5.0) if unit * power <= max(people, 10) / 4.0)
    return {"interval": step, "axisLabel": {**_labels(_WHOLE), "showMaxLabel": people % step == 0.0}}


def _legend(names: Sequence[str]) -> list[dict[str, Any]]:
    return [{"name": name, "icon": "roundRect"} for name in names]


def _labels(show: str) -> dict[str, Any]:
    return {**INK_TEXT, "hideOverlap": True, ":formatter": f"(x) => {show}"}


def _frame(description: str, show: str, legend: Sequence[str] = ()) -> dict[str, Any]:
    """What all these charts have in common; `show` writes a number `x` in JavaScript."""
    days = {
        **plain_axis("day", 24),
        "min": 0,
        "max": "dataMax",
        "splitLine": {"show": False},
        "axisLabel": {**INK_TEXT, "hideOverlap": True, "showMaxLabel": False},
    }
    return {
        "animation": False,
        "textStyle": {"fontFamily": FONT},
        "aria": {"enabled": True, "label": {"description": description}},
        "grid": {
            "left": _LEFT,
            "right": 14,
            "top": (42 if len(legend) > 4 else 24) if legend else 10,
            "bottom": 38,
        },
        "xAxis": days,
        "legend": {
            "show": bool(legend),
            "data": _legend(legend),
            "top": 0,
            "left": 8,
            "right": 4,
            "padding": 0,
            "itemWidth": 9,
            "itemHeight": 9,
            "itemGap": 8,
            "textStyle": {**INK_TEXT, "lineHeight": 13},
        },
        "tooltip": axis_tip(_TIP.replace("SHOW", show)),
    }
