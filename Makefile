# On a machine with Python 3.11 or later and make, each target sets up what it needs, once.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt

.DEFAULT_GOAL := help
.PHONY: help install paper test lint format wheel check-package mutants bench accounting clean

help: ## Show this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1\t/p' Makefile | expand -t 24

install: $(READY) ## Set up .venv (the other targets do it by themselves)

# The stamp comes last, so a set-up that was broken off is started again. pip knows --group since 25.1.
$(READY): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "covey needs Python 3.11 or later, and $(PYTHON) is " + sys.version.split()[0] + ". Name another: make PYTHON=python3.12")'
	@echo "Setting up $(VENV): about a minute, and only when pyproject.toml or constraints.txt has changed"
	@$(PYTHON) -m venv $(VENV)
	@$(PIP) --upgrade 'pip>=25.1'
	@$(PIP) -e '.[all]' --group dev
	@touch $@

paper: $(READY) ## Reproduce the paper's tables and figures in results/
	@$(BIN)/python -m covey warmup
	$(BIN)/python -m covey reproduce --output results

# Each worker loads the compiled kernels anew, so more than eight cost more than they bring.
test: $(READY) ## Run the tests on all cores (ARGS='-k name' for some of them)
	@$(BIN)/python -m covey warmup
	$(BIN)/python -m pytest -n auto --maxprocesses 8 $(ARGS)

lint: $(READY) ## Check format, style, types and who imports whom
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-logo

format: $(READY) ## Format the code and mend what can be mended by rule
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

wheel: $(READY) ## Build a wheel with the compiled kernels inside (PLATFORM=all for every platform)
	@$(PIP) -e '.[build]'
	$(BIN)/python packaging/wheels.py $(PLATFORM)

mutants: $(READY) ## Plant bugs, one at a time, and say which test catches each (ARGS='--room views')
	$(BIN)/python mutants/run.py $(ARGS)

bench: $(READY) ## Measure speed; never a part of the tests
	$(BIN)/python -m pytest benchmarks --ignore benchmarks/bench_accounting.py --benchmark-only $(ARGS)

accounting: $(READY) ## Show where the time of a plan goes, kernel by kernel
	COVEY_JIT=1 $(BIN)/python -m pytest benchmarks/bench_accounting.py --benchmark-only $(ARGS)

check-package: $(READY) ## Build the package, install it in an empty environment and use it there
	$(BIN)/python packaging/check_installed.py

clean: ## Remove the environment and all caches, but no results
	rm -rf $(VENV) build dist .benchmarks .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	find src tests benchmarks -name __pycache__ -type d -prune -exec rm -rf {} + 2>/dev/null || true
