"""What ECharts is told of a study: the options of an empty chart, and what a picture makes of it."""

from __future__ import annotations

from typing import Any

import numpy as np

from gasbox.app.chart_options import FONT, INK_TEXT, axis_tip, plain_axis
from gasbox.app.study import PALETTE, Axis, Picture, Trace

__all__ = ["filled", "layout"]

_TOOLTIP = """(shown) => {
  const short = (x) => String(+x.toPrecision(3));
  const rows = shown.filter((one) => !one.seriesName.endsWith(" ±") && one.value[1] !== null).map((one) => {
    const [, value, error] = one.value;
    const about = error ? ` ± ${short(error)}` : "";
    return `<tr><td>${one.marker}${one.seriesName}</td><td>${short(value)}${about}</td></tr>`;
  });
  const at = BARS ? shown[0].axisValueLabel : `X ${short(shown[0].value[0])}`;
  return `<table class="tip"><caption>${at}</caption>${rows.join("")}</table>`;
}"""
_NUMBER = """(x) => {
  const text = Math.abs(x) >= 1e4 ? x.toLocaleString("en").replaceAll(",", "\\u2009") : String(+x.toPrecision(9));
  return text.replace("-", "\\u2212");
}"""
_ICON = {
    "line": "path://M0,3h14v2h-14z",
    "dashed": "path://M0,3h4v2h-4zM5,3h4v2h-4zM10,3h4v2h-4z",
    "theory": "path://M0,3h4v2h-4zM5,3h4v2h-4zM10,3h4v2h-4z",
    "level": "path://M0,3h4v2h-4zM5,3h4v2h-4zM10,3h4v2h-4z",
    "points": "circle",
    "bars": "roundRect",
}
_WHISKER = """(params, api) => {
  const [x, value, error] = [api.value(0), api.value(1), api.value(2)];
  const [px, low] = api.coord([x, value - error]);
  const high = api.coord([x, value + error])[1];
  const style = { stroke: WHISKER_COLOR, lineWidth: 1, fill: null };
  const line = (x1, y1, x2, y2) => ({ type: "line", shape: { x1, y1, x2, y2 }, style });
  const cap = CAP;
  const caps = [low, high].map((y) => line(px - cap, y, px + cap, y));
  return { type: "group", children: [line(px, low, px, high), ...caps] };
}"""

_LEVEL = """(params, api) => {
  if (params.dataIndex > 0) return null;
  const y = api.coord([0, api.value(1)])[1];
  const { x, width } = params.coordSys;
  const style = { stroke: "COLOR", lineWidth: 1.6, lineDash: [5, 4], fill: null };
  return { type: "line", shape: { x1: x, y1: y, x2: x + width, y2: y }, style, transition: ["shape"] };
}"""
_BARS = (60.0, 84.0)
"""Per cent of its place that a bar takes, and that several side by side take together."""
_GLIDE = {
    "animation": True,
    "animationDuration": 0,
    "animationDurationUpdate": 480,
    "animationEasingUpdate": "linear",
}
"""Milliseconds: nearly as long as until the next update."""


def layout(picture: Picture, description: str) -> dict[str, Any]:
    """The options of a chart of this kind, with its first picture in it."""
    bars = bool(picture.x.labels)
    legend = len(picture.traces) > 1
    tip = _TOOLTIP.replace("BARS", "true" if bars else "false").replace(
        "X ", f"{picture.x.name.partition('  (')[0]} "
    )
    shape: dict[str, Any] = {
        **(_GLIDE if picture.gliding else {"animation": False}),
        "textStyle": {"fontFamily": FONT},
        "aria": {"enabled": True, "label": {"description": description}},
        "grid": {
            "left": 70,
            "right": 16,
            "top": 26 if legend else 10,
            "bottom": 42 if picture.x.name else 24,
        },
        "xAxis": {**plain_axis(picture.x.name, 26), "splitLine": {"show": False}},
        "yAxis": {**plain_axis(_upright(picture.y.name), 40), "axisLine": {"show": False}},
        "legend": {
            "show": legend,
            "data": [{"name": trace.name, "icon": _ICON[trace.kind]} for trace in picture.traces],
            "type": "scroll",
            "top": 0,
            "left": 66,
            "right": 12,
            "itemWidth": 14,
            "itemHeight": 8,
            "itemGap": 10,
            "textStyle": {**INK_TEXT, "lineHeight": 14},
            "pageTextStyle": INK_TEXT,
            "pageIconSize": 10,
            "pageIconColor": "var(--muted)",
            "pageIconInactiveColor": "var(--line-strong)",
        },
        "tooltip": axis_tip(tip),
        "series": [],
    }
    if bars:
        shape["xAxis"] |= {"type": "category", "axisTick": {"show": False}}
    if bars and picture.gliding:  # these few have room, in small letters
        size = 9 if len(picture.x.labels) > 3 else 11
        shape["xAxis"]["axisLabel"] = {**INK_TEXT, "fontSize": size, "interval": 0}
    shape["yAxis"]["nameTextStyle"] = {**INK_TEXT, "lineHeight": 13}
    said = filled(picture)
    shape["xAxis"] |= said["xAxis"]
    shape["yAxis"] |= said["yAxis"]
    shape["series"] = said["series"]
    return shape


def _upright(name: str) -> str:
    """The name of a vertical axis, with its unit on a line of its own: small charts have no room for both."""
    return name.replace("  (", "\n(")


def filled(picture: Picture) -> dict[str, Any]:
    """The parts of the options that follow a picture: ends of the axes, and all series."""
    series: list[dict[str, Any]] = []
    rows_of_bars = sum(trace.kind == "bars" for trace in picture.traces)
    for number, trace in enumerate(picture.traces):
        color = trace.color or PALETTE[number % len(PALETTE)]
        series.append(_series(trace, color, rows_of_bars))
        if trace.error is not None and rows_of_bars < 2:  # else they stand side by side
            series.append(_whiskers(trace, color))
    return {
        "xAxis": {"data": list(picture.x.labels)} if picture.x.labels else _ends(picture.x, tight=True),
        "yAxis": {**_ends(picture.y, tight=False), "name": _upright(picture.y.name)},
        "series": series,
    }


def _ends(axis: Axis, *, tight: bool) -> dict[str, Any]:
    """Ends that are said; otherwise those of the values, or round ones around them."""
    free = tight and axis.low is None
    return {
        "name": axis.name,
        "scale": axis.low is None,
        "axisLabel": {
            **INK_TEXT,
            "hideOverlap": True,
            ":formatter": _NUMBER,
            "showMinLabel": not free,
            "showMaxLabel": not free,
        },
        "min": "dataMin" if free else axis.low,
        "max": "dataMax" if free else axis.high,
    }


_TYPES = {"bars": "bar", "points": "scatter", "level": "custom"}


def _series(trace: Trace, color: str, rows_of_bars: int) -> dict[str, Any]:
    series: dict[str, Any] = {
        "type": _TYPES.get(trace.kind, "line"),
        "name": trace.name,
        "itemStyle": {"color": color},
        "data": _rows(trace),
    }
    match trace.kind:
        case "bars":
            series |= {"barWidth": f"{_BARS[rows_of_bars > 1] / rows_of_bars:.3g}%", "barGap": "0%"}
            series["itemStyle"] = {"color": color, "opacity": 0.85}
        case "level":
            series |= {":renderItem": _LEVEL.replace("COLOR", color), "z": 4}
        case "points":
            series["symbolSize"] = 5
        case _:
            thin = trace.kind == "theory"
            dashed = thin or trace.kind == "dashed"
            line = {"color": color, "width": 1.4 if thin else 1.8, "type": "dashed" if dashed else "solid"}
            series |= {"showSymbol": False, "lineStyle": line, "z": 1 if thin else 3}
    return series


def _whiskers(trace: Trace, color: str) -> dict[str, Any]:
    bars = trace.kind == "bars"
    draw = _WHISKER.replace("WHISKER_COLOR", "'var(--ink)'" if bars else f"'{color}'")
    return {
        "type": "custom",
        "name": f"{trace.name} ±",
        ":renderItem": draw.replace("CAP", "6" if bars else "0"),
        "data": _rows(trace),
        "silent": True,
        "tooltip": {"show": False},
        "z": 4 if bars else 2,
    }


def _rows(trace: Trace) -> list[list[float | None]]:
    """x, y and, where there is one, the error; five digits are more than a screen shows."""
    points = trace.points if trace.error is None else np.column_stack([trace.points, trace.error])
    return [
        [float(f"{value:.5g}") if np.isfinite(value) else None for value in row] for row in points.tolist()
    ]
