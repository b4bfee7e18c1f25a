"""Rates of the engines, of plain ones, and of the peers that are installed, in one run on one machine."""

from gasbox.bench.cases import measure
from gasbox.bench.chart import draw_rates, save_chart
from gasbox.bench.contest import Contender, Result, contest
from gasbox.bench.peers import missing_peers
from gasbox.bench.results import Earlier, machine, newest, save
from gasbox.bench.table import print_table

__all__ = [
    "Contender",
    "Earlier",
    "Result",
    "contest",
    "draw_rates",
    "machine",
    "measure",
    "missing_peers",
    "newest",
    "print_table",
    "save",
    "save_chart",
]
