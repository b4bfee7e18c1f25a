#!/bin/sh
# Prints a Python of version 3.11 or later; PYTHON=... overrides the search.
set -eu

new_enough() {
    [ "$("$1" -c 'import sys; print(sys.version_info >= (3, 11))' 2>/dev/null)" = True ]
}

complete() { # Debian's python3 comes without ensurepip, and then cannot make a virtual environment
    "$1" -c 'import ensurepip, venv' >/dev/null 2>&1
}

version() {
    if command -v "$1" >/dev/null; then "$1" --version 2>&1 | head -n 1; else echo "not there"; fi
}

if [ -n "${PYTHON:-}" ]; then
    if new_enough "$PYTHON"; then
        echo "$PYTHON"
        exit 0
    fi
    echo "gasbox needs Python 3.11 or later; PYTHON=$PYTHON is $(version "$PYTHON")." >&2
    exit 1
fi

second_best=""
for candidate in python3.13 python3.12 python3.11 python3 python; do
    if new_enough "$candidate"; then
        if complete "$candidate"; then
            echo "$candidate"
            exit 0
        fi
        second_best=${second_best:-$candidate}
    fi
done

if [ -n "$second_best" ]; then # set_up.py says what it lacks
    echo "$second_best"
    exit 0
fi
echo "gasbox needs Python 3.11 or later; python3 is $(version python3)." >&2
echo "Install one, or name it:  make run PYTHON=/path/to/python3.12" >&2
exit 1
