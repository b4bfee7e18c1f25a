"""What is remembered of the replies of a world."""

import numpy as np

from gasbox.state import MoveWall, SetGate, SetWall, Way
from gasbox.worlds import Replies

NAMES = ("left", "right", "gate", "other")


def test_gates_come_back_from_numbers_alone():
    replies = Replies({}, NAMES)
    replies.note(1.0, SetGate("gate", Way(), None))
    replies.note(1.5, MoveWall("left", 1.0, 2.0, 0.25))
    replies.note(2.0, SetGate("other", Way((0, 3), 0.5, 4.0), Way((2,))))
    replies.note(2.5, SetGate("gate", Way(least_speed=1.3), Way((), 0.0, 1.3)))
    replies.note(2.75, SetWall("other", present=False))
    memory = {name: np.asarray(value).tolist() for name, value in replies.memory().items()}
    assert Replies.recalled(memory, NAMES).entries() == [
        (1.5, MoveWall("left", 1.0, 2.0, 0.25)),
        (2.0, SetGate("other", Way((0, 3), 0.5, 4.0), Way((2,)))),
        (2.5, SetGate("gate", Way(least_speed=1.3), None)),
        (2.75, SetWall("other", present=False)),
    ]


def test_nothing_was_replied():
    memory = {name: np.asarray(value).tolist() for name, value in Replies({}, NAMES).memory().items()}
    assert Replies.recalled(memory, NAMES).entries() == []
