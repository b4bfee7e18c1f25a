"""Tasks on several cores: all are done, in whatever order, and closing ends them."""

import os
from functools import partial
from itertools import count

import pytest

from gasbox.errors import DynamicsError
from gasbox.sweep import done_together


def power(exponent, base, stopped):
    return base**exponent, os.getpid()


def until_stopped(number, stopped):
    while number and not stopped():
        pass
    return number, os.getpid()


def killed(number, stopped):
    os._exit(3)


def test_every_task_is_done_in_order_by_one():
    found = done_together(partial(power, 2), iter(range(9)))
    assert list(found) == [(base**2, os.getpid()) for base in range(9)]


def test_closing_stops_endless_work():
    found = done_together(until_stopped, count(), 2)
    number, place = next(found)
    assert number == 0
    assert place != os.getpid()
    found.close()


def test_a_worker_that_is_gone_is_told():
    with pytest.raises(DynamicsError, match="ended from outside"):
        list(done_together(killed, range(3), 2))
