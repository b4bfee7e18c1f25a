#!/bin/sh
# Prints a Python of version 3.11 or later; PYTHON=... overrides the search.
set -eu

fits() {
    [ "$("$1" -c 'import sys; print(sys.version_info >= (3, 11))' 2>/dev/null)" = True ]
}

if [ -n "${PYTHON:-}" ]; then
    if fits "$PYTHON"; then
        echo "$PYTHON"
        exit 0
    fi
    found=$("$PYTHON" --version 2>&1) || found="nothing that runs"
    echo "gasbox needs Python 3.11 or later; PYTHON=$PYTHON is $found." >&2
    exit 1
fi

for candidate in python3.13 python3.12 python3.11 python3 python; do
    if fits "$candidate"; then
        echo "$candidate"
        exit 0
    fi
done

found=$(python3 --version 2>&1) || found="no python3 at all"
echo "gasbox needs Python 3.11 or later; found $found." >&2
echo "Install one, or name it: make run PYTHON=/path/to/python3.12" >&2
exit 1
