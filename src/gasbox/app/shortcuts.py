"""The keys of the page, in one table."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["SHORTCUTS", "Shortcut", "action_of"]


@dataclass(frozen=True)
class Shortcut:
    """One row of the list of keys: the action, the browser's names of its keys, and how people read them.

    A row without keys is only shown: the box itself listens to them. One that `holds` something acts while its key is
    down.
    """

    action: str
    keys: tuple[str, ...]
    shown: tuple[str, ...]
    meaning: str
    holds: str = ""


SHORTCUTS: tuple[Shortcut, ...] = (
    Shortcut("toggle", (" ", "p", "P"), ("Space", "P"), "play or pause"),
    Shortcut("step", ("ArrowRight",), ("→",), "one frame"),
    Shortcut("faster", ("ArrowUp", "+", "="), ("↑", "+"), "faster"),
    Shortcut("slower", ("ArrowDown", "-"), ("↓", "−"), "slower"),
    Shortcut("reset", ("r", "R"), ("R",), "back to the start"),
    Shortcut("save", ("s", "S"), ("S",), "save a snapshot"),
    Shortcut("open", ("o", "O"), ("O",), "open a file"),
    Shortcut("edit", ("e", "E"), ("E",), "edit the gas"),
    Shortcut("theory", ("t", "T"), ("T",), "theory curves on or off"),
    Shortcut("gravity", ("g", "G"), ("G",), "gravity on or off"),
    Shortcut("heat", ("h", "H"), ("H",), "heat, while it is held down (matter with forces)", "heat"),
    Shortcut("cool", ("f", "F"), ("F",), "cool, while it is held down", "cool"),
    Shortcut("divider", ("d", "D"), ("D",), "take the first divider away, or put it back"),
    Shortcut("coloring", ("c", "C"), ("C",), "colour discs by species, phase, neighbours or speed"),
    Shortcut("bonds", ("b", "B"), ("B",), "join neighbours by lines, or not"),
    Shortcut("unfollow", ("Escape",), ("Esc",), "stop following a particle"),
    Shortcut("whole", (), ("0",), "see the whole box again (or double click)"),
    Shortcut("bat", (), ("W", "S", "↑", "↓"), "move a bat (pong, while it is played)"),
    Shortcut("serve", (), ("Space", "Enter"), "serve at once, or begin a new game (pong)"),
    Shortcut("sound", (), ("M",), "sound on or off (pong)"),
    Shortcut("keys", ("?",), ("?",), "this list"),
)
"""All keys; `page.js` gets the browser's names from here."""


def action_of(key: str) -> str | None:
    """The action of a key by the browser's name, or None."""
    return next((one.action for one in SHORTCUTS if key in one.keys), None)
