import numpy as np
import pytest

from gasbox.app.history import History

pytestmark = pytest.mark.small


def test_few_rows_are_all_kept() -> None:
    history = History()
    for time in range(300):
        history.add(float(time), (2.0 * time, 1.0))
    assert np.array_equal(history.column(0), np.stack([np.arange(300), 2.0 * np.arange(300)], axis=1))


def test_many_rows_are_thinned_evenly_and_the_newest_is_there() -> None:
    history = History()
    for time in range(100_003):
        history.add(float(time), (float(time),))
        assert history.time[-1] == time
    assert 150 < len(history.time) <= 400
    assert history.time[0] == 0.0
    gaps = np.diff(history.time[:-1])
    assert gaps.max() <= 2 * np.median(gaps)


def test_a_moment_is_kept_once_and_an_earlier_one_begins_anew() -> None:
    history = History()
    history.add(1.0, (1.0,))
    history.add(1.0, (2.0,))
    assert history.rows == [(1.0,)]
    history.add(2.0, (3.0,))
    history.add(0.5, (4.0,))
    assert (history.time, history.rows) == ([0.5], [(4.0,)])
    history.add(0.6, (5.0, 6.0))
    assert (history.time, history.rows) == ([0.6], [(5.0, 6.0)])
