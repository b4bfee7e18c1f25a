"""Compile all kernels into the cache, unless that has been done.

    .venv/bin/python scripts/compile_kernels.py

`make test` calls it before its workers start, which would otherwise compile the same kernels side by side.
"""

from __future__ import annotations

from gasbox.compiling import compile_kernels
from gasbox.jit import was_compiled

if __name__ == "__main__" and not was_compiled():
    compile_kernels(
        lambda done, total, name: print(
            f"Compiling, once: {name} ({done + 1} of {total})" if name else "Compiled.", flush=True
        )
    )
