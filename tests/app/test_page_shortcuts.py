import pytest

from gasbox.app.shortcuts import SHORTCUTS, action_of

pytestmark = pytest.mark.small


def test_each_key_means_one_thing() -> None:
    keys = [key for shortcut in SHORTCUTS for key in shortcut.keys]
    assert len(keys) == len(set(keys))


@pytest.mark.parametrize(
    ("key", "action"),
    [
        (" ", "toggle"),
        ("ArrowRight", "step"),
        ("ArrowUp", "faster"),
        ("+", "faster"),
        ("ArrowDown", "slower"),
        ("-", "slower"),
        ("r", "reset"),
        ("S", "save"),
        ("?", "keys"),
        ("Escape", "unfollow"),
        ("g", "gravity"),
        ("D", "divider"),
        ("c", "coloring"),
        ("B", "bonds"),
        ("h", "heat"),
        ("F", "cool"),
        ("x", None),
    ],
)
def test_keys(key: str, action: str | None) -> None:
    assert action_of(key) == action
