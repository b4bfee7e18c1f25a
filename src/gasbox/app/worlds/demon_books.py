"""What a demon's books say on the page: numbers, and pictures over time. Without any page."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.study import INK, PALETTE, Axis, Picture, Trace
from gasbox.app.wording import number, whole
from gasbox.app.worlds.thinning import thinned
from gasbox.units import UNIT

__all__ = ["BOOKS", "PICTURES", "written"]

Series = Mapping[str, NDArray[np.float64]]

BOOKS: Final = {
    "bits": ("bits written", "one for each decision: let pass, or not. In brackets the least that would do"),
    "heat": (
        "heat to forget",
        "T ln 2 for each bit at least: Landauer's bound, at the mean temperature",
    ),
    "work": ("work to gain", "from the gas as it is now, beside a bath at its mean temperature"),
    "share": (
        "gained of paid",
        "entropy that the gas has lost, over ln 2 for each bit: never more than 1",
    ),
}
"""Name -> how it is called, and what it is."""
_TIME: Final = Axis(f"time  ({UNIT['time']})")
_MOST: Final = 300
"""Points of a curve."""


def written(view: Mapping[str, Any]) -> dict[str, str]:
    """Each number of the books as it is written; `view` as the world shows it."""
    bits, entropy, work = view["decisions"], view.get("entropy_of_gas"), view.get("work_stored")
    heat = view.get("heat_of_forgetting")
    paid = view["information_written"]
    return {
        "bits": f"{whole(bits)} ({whole(math.ceil(view['information'] / math.log(2.0)))})",
        "heat": number(heat),
        "work": number(None if work is None else max(work, 0.0)),
        "share": "–" if entropy is None or paid <= 0.0 else f"{max(-entropy, 0.0) / paid:.0%}",
    }


def _thin(series: Series, name: str) -> NDArray[np.float64]:
    """(n, 2) float64: time and a number of the series, not too many of them."""
    rows = thinned(series["time"].size, _MOST)
    return np.stack([series["time"][rows], series[name][rows]], axis=1)


def _sides(view: Mapping[str, Any], series: Series, what: str) -> list[Trace]:
    return [
        Trace(name, _thin(series, f"{what}_{name}"), color=color)
        for name, color in zip(view["sides"], PALETTE, strict=False)
    ]


def _temperatures(view: Mapping[str, Any], series: Series) -> Picture | None:
    if not series or series["time"].size < 2:
        return None
    last = [view[name]["temperature"] if name in view else math.nan for name in view["sides"]]
    return Picture(
        _TIME,
        Axis(f"temperature  ({UNIT['energy']})", 0.0),
        _sides(view, series, "temperature"),
        " and ".join(map(number, last)),
    )


def _counts(view: Mapping[str, Any], series: Series) -> Picture | None:
    if not series or series["time"].size < 2:
        return None
    last = [whole(view[name]["discs"]) if name in view else "–" for name in view["sides"]]
    return Picture(_TIME, Axis("discs", 0.0), _sides(view, series, "count"), " and ".join(last))


def _entropy(view: Mapping[str, Any], series: Series) -> Picture | None:
    if not series or series["time"].size < 2:
        return None
    curves = (
        ("gas", "entropy", "line", PALETTE[2]),
        ("bits written", "written", "line", PALETTE[3]),
        ("least memory", "information", "dashed", PALETTE[3]),
        ("gas and bits", "balance", "line", INK),
    )
    traces = [Trace(name, _thin(series, key), kind, color=color) for name, key, kind, color in curves]  # type: ignore[arg-type]
    last = view.get("entropy_of_gas")
    fact = "" if last is None else f"gas {number(last)}, bits {number(view['information_written'])}"
    return Picture(_TIME, Axis("entropy since the start  (k_B)"), traces, fact)


PICTURES: Final[Mapping[str, tuple[str, Callable[[Mapping[str, Any], Series], Picture | None]]]] = {
    "temperature": ("Temperature of both sides", _temperatures),
    "entropy": ("Entropy of gas and bits", _entropy),
    "count": ("Discs on both sides", _counts),
}
"""Name -> title, and what makes a picture of what the world shows and has counted."""
