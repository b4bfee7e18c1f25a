"""The keys of the page, in one table."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["SHORTCUTS", "Shortcut", "action_of"]


@dataclass(frozen=True)
class Shortcut:
    """One row of the list of keys: the action, the browser's names of its keys, and how people read them.

    A row without keys is only shown: the box itself listens to them.
    """

    action: str
    keys: tuple[str, ...]
    shown: tuple[str, ...]
    meaning: str


SHORTCUTS: tuple[Shortcut, ...] = (
    Shortcut("toggle", (" ",), ("Space",), "play or pause"),
    Shortcut("step", ("ArrowRight",), ("→",), "one frame"),
    Shortcut("faster", ("ArrowUp", "+", "="), ("↑", "+"), "faster"),
    Shortcut("slower", ("ArrowDown", "-"), ("↓", "−"), "slower"),
    Shortcut("reset", ("r", "R"), ("R",), "back to the start"),
    Shortcut("save", ("s", "S"), ("S",), "save a snapshot"),
    Shortcut("open", ("o", "O"), ("O",), "open a file"),
    Shortcut("edit", ("e", "E"), ("E",), "edit the gas"),
    Shortcut("theory", ("t", "T"), ("T",), "theory curves on or off"),
    Shortcut("gravity", ("g", "G"), ("G",), "gravity on or off"),
    Shortcut("divider", ("d", "D"), ("D",), "take the first divider away, or put it back"),
    Shortcut("unfollow", ("Escape",), ("Esc",), "stop following a particle"),
    Shortcut("whole", (), ("0",), "see the whole box again (or double click)"),
    Shortcut("keys", ("?",), ("?",), "this list"),
)
"""All keys; `page.js` gets the browser's names from here."""


def action_of(key: str) -> str | None:
    """The action of a key by the browser's name, or None."""
    return next((shortcut.action for shortcut in SHORTCUTS if key in shortcut.keys), None)
