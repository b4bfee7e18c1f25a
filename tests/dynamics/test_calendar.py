"""The calendar queue alone: whatever the times, all events come out, in order."""

from __future__ import annotations

import importlib
import math

import numpy as np
import pytest

from gasbox.kernels.event_driven import queue
from gasbox.kernels.event_driven.tables import BUCKETS_PER_TIME, HORIZON, T_CROSS, T_EVENT, tables

# The package exports the function of that name.
columns = importlib.import_module("gasbox.kernels.event_driven.tables")
RATE = 3.7


class Calendar:
    """Times of particles, filed and taken out one by one."""

    def __init__(self, n: int, current: int = 0) -> None:
        ones = np.ones(n)
        self.tables = tables(0.1 * ones, ones, np.zeros(n, np.int32), (10.0, 10.0), (True, True))
        self.tables.number[BUCKETS_PER_TIME] = RATE
        self.tables.number[HORIZON] = 1e9
        self.tables.flight[:, T_CROSS] = math.inf
        queue.empty(self.tables.ring, self.tables.counter, current)

    def insert(self, i: int, time: float) -> None:
        t = self.tables
        t.flight[i, T_EVENT] = time
        queue.insert(t.flight, t.link, t.ring, t.heap, t.counter, t.number, i)

    def remove(self, i: int) -> None:
        t = self.tables
        queue.remove(t.flight, t.link, t.ring, t.heap, t.counter, i)

    def pop(self) -> float | None:
        t = self.tables
        if np.all(t.link[:, columns.PLACE] == columns.NOWHERE):
            return None
        i = queue.earliest(t.flight, t.link, t.ring, t.heap, t.counter, t.number, 1e6)
        assert i >= 0
        self.remove(i)
        return float(t.flight[i, T_EVENT])


def drained(calendar: Calendar) -> list[float]:
    found = []
    while (time := calendar.pop()) is not None:
        found.append(time)
    return found


def edges(first: int, last: int) -> list[float]:
    """Bucket edges, and the numbers right before and after."""
    middle = [k / RATE for k in range(first, last)]
    return [t for m in middle for t in (np.nextafter(m, 0), m, np.nextafter(m, math.inf))]


@pytest.mark.small
@pytest.mark.parametrize("first", [1, 1000, 10**6])
def test_events_at_the_edges_of_buckets(first):
    times = edges(first, first + 20)
    calendar = Calendar(len(times), first - 1)
    for i in np.random.default_rng(first).permutation(len(times)):
        calendar.insert(int(i), times[i])
    assert drained(calendar) == sorted(times)


@pytest.mark.small
def test_an_event_that_falls_into_a_past_bucket_comes_next():
    calendar = Calendar(4)
    calendar.insert(0, 100 / RATE)
    assert calendar.pop() == 100 / RATE  # the calendar has moved on to bucket 100
    calendar.insert(1, 102.5 / RATE)
    calendar.insert(2, np.nextafter(100 / RATE, 0))  # by rounding a hair earlier: bucket 99
    calendar.insert(3, 60.5 / RATE)
    assert drained(calendar) == [60.5 / RATE, np.nextafter(100 / RATE, 0), 102.5 / RATE]


@pytest.mark.small
def test_more_events_in_a_bucket_than_its_row_holds():
    calendar = Calendar(40)
    times = [5.5 / RATE + 1e-3 * i for i in range(40)]
    for i in range(40):
        calendar.insert(i, times[i])
    for i in range(0, 40, 3):
        calendar.remove(i)
    assert drained(calendar) == [times[i] for i in range(40) if i % 3]


@pytest.mark.small
def test_far_beyond_the_ring_and_filed_anew_many_times():
    rng = np.random.default_rng(4)
    calendar, n = Calendar(50), 50
    times = {i: float(t) for i, t in enumerate(rng.exponential(100, n))}
    for i, time in times.items():
        calendar.insert(i, time)
    now = 0.0
    for _ in range(400):
        expected = min(times.values())
        found = calendar.pop()
        assert found == expected >= now
        now = found
        i = next(i for i, t in times.items() if t == found)
        others = [i, *(int(k) for k in rng.integers(0, n, 2))]
        for k in dict.fromkeys(others):
            if k != i:
                calendar.remove(k)
            # Soon, at an edge, or far away.
            later = rng.choice([rng.exponential(0.3), rng.exponential(80)])
            times[k] = now + later if rng.random() < 0.7 else math.ceil((now + later) * RATE) / RATE
            calendar.insert(k, times[k])
