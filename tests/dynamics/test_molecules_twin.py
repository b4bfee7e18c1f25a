"""Event-driven molecules have the contacts that a look at every moment finds, in every kind of container."""

from __future__ import annotations

import numpy as np
import pytest
from contact_twin import MoleculeTwin
from enclosures import enclosure
from gases import collect
from molecular_gases import BARBELL, BENT, DISC, DUMBBELL, ROD, engine_of, scattered

from gasbox.geometry import Circle, Post, Rectangle, Segment

BOX = Rectangle(9, 8)
CASES = {
    "periodic": (Rectangle(9, 8, True, True), [DUMBBELL], 8),
    "few images": (Rectangle(4.2, 4.2, True, True), [DUMBBELL, BARBELL], 3),
    "walls": (BOX, [BENT, DISC], 7),
    "rods": (Rectangle(9, 8, periodic_x=True), [ROD], 5),
    "rods in a narrow box": (Rectangle(3.4, 9, periodic_x=True), [ROD], 3),
    "falling": (enclosure(BOX, gravity=(0.1, -0.5)), [DUMBBELL, DISC], 7),
    "circle": (enclosure(Circle(5.0)), [DUMBBELL, BARBELL], 7),
    "falling in a circle": (enclosure(Circle(5.0), gravity=(0.1, -0.5)), [BENT], 6),
    "obstacles": (
        enclosure(Rectangle(9, 8), (Post((3.0, 4.0), 1.0), Segment((6.0, 3.0), (7.0, 5.5)))),
        [DUMBBELL, ROD],
        5,
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_contacts_are_those_of_a_dense_look(name):
    geometry, bodies, count = CASES[name]
    state = scattered(bodies, np.arange(count) % len(bodies), geometry, seed=3)
    twin = MoleculeTwin(state.copy(), geometry)
    twin.run(16)
    engine = engine_of(state, geometry, contacts=200)
    rows = collect(engine, state, twin.time + 1e-6)[:16]
    found = [(kind + 1, first, second) for kind, _, first, second, _, _ in rows]
    assert found == [event[1:] for event in twin.events]
    late = np.array([row[1] for row in rows]) - [event[0] for event in twin.events]
    assert np.abs(late[:6]).max() < 1e-11
    # Differences grow from contact to contact.
    assert np.abs(late).max() < 1e-6
