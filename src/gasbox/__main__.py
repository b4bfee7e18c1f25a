"""`python -m gasbox` is the `gasbox` command."""

from gasbox.cli import main

main()
