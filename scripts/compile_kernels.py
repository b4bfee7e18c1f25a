"""Compile all kernels into the cache, unless that has been done; two processes begin at the two ends of the list.

    .venv/bin/python scripts/compile_kernels.py

`make test` calls it before its workers start, which would otherwise compile the same kernels side by side.
"""

from __future__ import annotations

import multiprocessing
import sys

from gasbox.compiling import compile_kernels
from gasbox.jit import was_compiled


def main() -> int:
    """Compile what is missing; the exit status."""
    if was_compiled():
        return 0
    print("Compiling the kernels (a minute or two, once) ...", flush=True)
    spawn = multiprocessing.get_context("spawn")
    other = spawn.Process(target=compile_kernels, kwargs={"backwards": True})
    other.start()
    compile_kernels()
    other.join()
    return other.exitcode or 0


if __name__ == "__main__":
    sys.exit(main())
