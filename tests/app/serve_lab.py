"""Serves the lab on a free port of this machine, for tests that drive a browser."""

from __future__ import annotations

import functools
import sys

from gasbox.app.server import serve
from gasbox.scenario import load

if __name__ == "__main__":
    serve(
        load(sys.argv[1]),
        port=0,
        show=False,
        max_sessions=int(sys.argv[2]),
        tell=functools.partial(print, flush=True),
    )
