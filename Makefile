# Everything runs inside .venv, which the first target that needs it makes. `make help` lists the targets.
# PYTHON=python3.12 chooses the Python; ARGS="..." is passed on to the command behind a target.

SHELL := /bin/sh
BIN := .venv/bin
PYTEST = $(BIN)/python -m pytest
ARGS ?=
# Processes that share the tests; they take each other's from the end, so files stay together. 0 for --pdb.
WORKERS ?= 2
PYTHON ?=
export PYTHON
# The Python that makes .venv, searched for only when a target needs it.
SET_UP = python=$$(sh scripts/find_python.sh) && "$$python" scripts/set_up.py

.PHONY: help run test setup lint format bench validate screenshots lock clean ready-to-run ready-to-develop chromium
.DEFAULT_GOAL := help

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1@\2/p' Makefile | awk -F@ '{printf "%-18s %s\n", $$1, $$2}'

run: ready-to-run ## open the lab in the browser (ARGS="brownian" for another scenario)
	@$(BIN)/gasbox lab $(ARGS)

test: ready-to-develop chromium ## all tests, the browser's too (ARGS="-k name" for some)
ifeq ($(strip $(ARGS)),)
	@$(BIN)/python scripts/compile_kernels.py
endif
	@$(PYTEST) -n $(WORKERS) --dist worksteal $(ARGS)

setup: ready-to-develop ## make .venv with everything that developing needs

lint: ready-to-develop ## ruff, mypy --strict, import-linter: what CI checks
	@$(BIN)/ruff check .
	@$(BIN)/ruff format --check .
	@$(BIN)/mypy
	@$(BIN)/lint-imports

format: ready-to-develop ## let ruff put the code in shape
	@$(BIN)/ruff check --fix-only .
	@$(BIN)/ruff format .

bench: ready-to-develop ## rates on this machine, against the peers, kept in benchmarks/results (ARGS=--quick)
	@$(BIN)/gasbox bench -o benchmarks/results $(ARGS)

validate: ready-to-develop ## long comparisons with published numbers
	@$(PYTEST) -m validate $(ARGS)

screenshots: ready-to-develop chromium ## the pictures of the page in docs/images, from the real page
	@$(BIN)/python scripts/screenshots.py $(ARGS)

lock: ready-to-develop ## write constraints.txt from what is installed in .venv
	@$(BIN)/python scripts/lock.py

clean: ## remove .venv and all caches in the repository
	rm -rf .venv .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache .nicegui build dist out
	find src tests scripts benchmarks -name __pycache__ -type d -prune -exec rm -rf {} +

ready-to-run:
	@$(SET_UP)

ready-to-develop:
	@$(SET_UP) dev bench

# CHROMIUM=no: the caller leaves the browser tests out.
chromium: ready-to-develop
ifneq ($(CHROMIUM),no)
	@$(BIN)/python scripts/chromium.py --install >/dev/null
endif
