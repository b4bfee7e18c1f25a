"""The style sheet: text can be read in light and dark (WCAG 2.2, contrast of level AA)."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gasbox.app

pytestmark = pytest.mark.small

STYLE = (Path(gasbox.app.__file__).parent / "assets" / "page.css").read_text()


def tokens(selector: str) -> dict[str, str]:
    block = STYLE[STYLE.index(f"{selector} {{") :].partition("}")[0]
    return dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6});", block))


def luminance(color: str) -> float:
    parts = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("theme", [":root", "body.body--dark"])
@pytest.mark.parametrize(
    ("text", "ground"),
    [
        ("ink", "paper"),
        ("ink", "card"),
        ("muted", "paper"),
        ("muted", "card"),
        ("accent", "card"),
        ("accent", "paper"),
        ("danger", "card"),
        ("warning", "warning-paper"),
    ],
)
def test_text_can_be_read(theme: str, text: str, ground: str) -> None:
    colors = tokens(theme)
    assert contrast(colors[text], colors[ground]) >= 4.5


def test_both_themes_have_the_same_colours() -> None:
    assert tokens(":root").keys() == tokens("body.body--dark").keys()


def test_nothing_is_fetched_from_elsewhere() -> None:
    assert "http" not in STYLE
    assert "@import" not in STYLE


def test_motion_is_left_out_for_those_who_asked() -> None:
    assert "prefers-reduced-motion: reduce" in STYLE
