"""Rates of the engines, and of the peers that are installed, in one run on one machine."""

from gasbox.bench.cases import measure
from gasbox.bench.contest import Contender, Result, contest
from gasbox.bench.results import print_table, save

__all__ = ["Contender", "Result", "contest", "measure", "print_table", "save"]
