"""A calendar of coming events: buckets of equal time in a ring, of which the current one is kept as a heap.

A bucket is a row of memory. Filing an event touches this row alone, and an event that is taken out stays in it, to be
passed over when the bucket is opened (its particle is filed elsewhere then); what finds a row full is chained to it.

The bucket of a time is its whole number of bucket widths. This is a monotone function also in floating point, so an
earlier event is never filed behind a later one; what belongs to the current bucket or (by rounding) to a past one goes
into the heap.

Source: G. Paul, J. Comput. Phys. 221, 615 (2007), doi:10.1016/j.jcp.2006.06.042.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.event_driven.tables import (
    BUCKETS_PER_TIME,
    CHAIN,
    CURRENT,
    FILED,
    FIRST_ENTRY,
    HEAP,
    HORIZON,
    LABEL,
    LATER,
    NOWHERE,
    PARTNER,
    PLACE,
    Q_NEXT,
    Q_PREV,
    RING_AT,
    STALE,
    T_CROSS,
    T_EVENT,
)

__all__ = ["earliest", "empty", "insert", "pair_before", "remove", "rise"]

_Flight = NDArray[np.float64]
_Ints = NDArray[np.int32]


@inlined_kernel
def pair_before(link: _Ints, i: int, j: int, k: int, other: int) -> bool:
    """Whether the pair (i, j) ranks before the pair (k, other) at the same time: by lower, then higher label."""
    low, high = min(link[i, LABEL], link[j, LABEL]), max(link[i, LABEL], link[j, LABEL])
    low_other = min(link[k, LABEL], link[other, LABEL])
    return low < low_other or (low == low_other and high < max(link[k, LABEL], link[other, LABEL]))


@inlined_kernel
def _key(flight: _Flight, link: _Ints, i: int) -> tuple[float, int, int, int]:
    """Order of events: time; then what only finds events, pairs, walls; then ids."""
    event, crossing = flight[i, T_EVENT], flight[i, T_CROSS]
    partner, label = link[i, PARTNER], link[i, LABEL]
    if crossing <= event:
        return crossing, 0, label, 0
    if partner >= 0:
        other = link[partner, LABEL]
        return event, 1, min(label, other), max(label, other)
    if partner == STALE:
        return event, 0, label, 0
    return event, 2, label, -partner


@inlined_kernel
def _before(flight: _Flight, link: _Ints, i: int, j: int) -> bool:
    t_i = min(flight[i, T_EVENT], flight[i, T_CROSS])
    t_j = min(flight[j, T_EVENT], flight[j, T_CROSS])
    if t_i != t_j:
        return t_i < t_j
    return _key(flight, link, i) < _key(flight, link, j)


@inlined_kernel
def _rise(flight: _Flight, link: _Ints, heap: _Ints, place: int, base: int) -> None:
    i = heap[place]
    while place > 0:
        parent = (place - 1) // 2
        j = heap[parent]
        if not _before(flight, link, i, j):
            break
        heap[place] = j
        link[j, PLACE] = base + place
        place = parent
    heap[place] = i
    link[i, PLACE] = base + place


@inlined_kernel
def _sink(flight: _Flight, link: _Ints, heap: _Ints, place: int, size: int, base: int) -> None:
    i = heap[place]
    while True:
        child = 2 * place + 1
        if child >= size:
            break
        if child + 1 < size and _before(flight, link, heap[child + 1], heap[child]):
            child += 1
        j = heap[child]
        if not _before(flight, link, j, i):
            break
        heap[place] = j
        link[j, PLACE] = base + place
        place = child
    heap[place] = i
    link[i, PLACE] = base + place


@inlined_kernel
def remove(
    flight: _Flight, link: _Ints, ring: _Ints, heap: _Ints, counter: NDArray[np.int64], i: int
) -> None:
    """Take particle `i` out of the queue, before its times change (of a heap the order may be stale at `i` only).

    In the row of a bucket its entry stays, and will be passed over.
    """
    place, buckets = link[i, PLACE], ring.shape[0]
    if place >= 2 * buckets:
        place -= 2 * buckets
        size = counter[HEAP] - 1
        counter[HEAP] = size
        if place < size:
            last = heap[size]
            heap[place] = last
            link[last, PLACE] = 2 * buckets + place
            _sink(flight, link, heap, place, size, 2 * buckets)
            _rise(flight, link, heap, link[last, PLACE] - 2 * buckets, 2 * buckets)
    elif place >= buckets:
        before, after = link[i, Q_PREV], link[i, Q_NEXT]
        if before >= 0:
            link[before, Q_NEXT] = after
        else:
            ring[place - buckets, CHAIN] = after
        if after >= 0:
            link[after, Q_PREV] = before
    link[i, PLACE] = NOWHERE


@inlined_kernel
def rise(flight: _Flight, link: _Ints, ring: _Ints, heap: _Ints, i: int) -> None:
    """Restore the order after the event of particle `i` has come to rank earlier at the same time."""
    place = link[i, PLACE]
    base = 2 * ring.shape[0]
    if place >= base:
        _rise(flight, link, heap, place - base, base)


@inlined_kernel
def insert(
    flight: _Flight,
    link: _Ints,
    ring: _Ints,
    heap: _Ints,
    counter: NDArray[np.int64],
    number: NDArray[np.float64],
    i: int,
) -> None:
    """File particle `i` by the time of its next event; events beyond the epoch are not filed at all."""
    time = min(flight[i, T_EVENT], flight[i, T_CROSS])
    if time > number[HORIZON]:
        link[i, PLACE] = NOWHERE
        return
    bucket, buckets = int(time * number[BUCKETS_PER_TIME]), ring.shape[0]
    ahead = bucket - counter[CURRENT]
    if ahead <= 0:
        place = counter[HEAP]
        counter[HEAP] = place + 1
        heap[place] = i
        _rise(flight, link, heap, place, 2 * buckets)
    elif ahead >= buckets:
        link[i, PLACE] = LATER
    else:
        place = counter[RING_AT] + ahead
        if place >= buckets:
            place -= buckets
        filed = ring[place, FILED]
        if filed < ring.shape[1]:
            ring[place, filed] = i
            ring[place, FILED] = filed + 1
            link[i, PLACE] = place
        else:
            _chain(link, ring, place, i)


@bare_kernel
def _chain(link: _Ints, ring: _Ints, place: int, i: int) -> None:
    """File particle `i` in a bucket whose row is full."""
    after = ring[place, CHAIN]
    link[i, Q_PREV] = -1
    link[i, Q_NEXT] = after
    if after >= 0:
        link[after, Q_PREV] = i
    ring[place, CHAIN] = i
    link[i, PLACE] = ring.shape[0] + place


@bare_kernel
def empty(ring: _Ints, counter: NDArray[np.int64], current: int) -> None:
    """An empty queue, at bucket `current`."""
    ring[:, FILED] = FIRST_ENTRY
    ring[:, CHAIN] = -1
    counter[HEAP] = 0
    counter[CURRENT] = current
    counter[RING_AT] = 0


@inlined_kernel
def _open(
    flight: _Flight,
    link: _Ints,
    ring: _Ints,
    heap: _Ints,
    counter: NDArray[np.int64],
    number: NDArray[np.float64],
    place: int,
) -> None:
    """Move all that is filed in a bucket into the heap."""
    filed, i = ring[place, FILED], ring[place, CHAIN]
    ring[place, FILED] = FIRST_ENTRY
    ring[place, CHAIN] = -1
    for entry in range(FIRST_ENTRY, filed):
        member = ring[place, entry]
        if link[member, PLACE] == place:
            insert(flight, link, ring, heap, counter, number, member)
    while i >= 0:
        after = link[i, Q_NEXT]
        insert(flight, link, ring, heap, counter, number, i)
        i = after


@bare_kernel
def earliest(
    flight: _Flight,
    link: _Ints,
    ring: _Ints,
    heap: _Ints,
    counter: NDArray[np.int64],
    number: NDArray[np.float64],
    until: float,
) -> int:
    """The particle with the next event, or -1 if none is due in the bucket of `until` or before."""
    last = int(min(until, number[HORIZON]) * number[BUCKETS_PER_TIME])
    while counter[HEAP] == 0:
        if counter[CURRENT] >= last:
            return -1
        counter[CURRENT] += 1
        counter[RING_AT] += 1
        if counter[RING_AT] == ring.shape[0]:
            counter[RING_AT] = 0
            for i in range(link.shape[0]):
                if link[i, PLACE] == LATER:
                    insert(flight, link, ring, heap, counter, number, i)
        _open(flight, link, ring, heap, counter, number, counter[RING_AT])
    return heap[0]
