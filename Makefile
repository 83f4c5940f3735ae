# On a machine with Python 3.11 or later and make, each target sets up what it needs, once.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
DOCS_READY := $(VENV)/.docs
PIP := -m pip install --quiet --disable-pip-version-check
PINNED := $(PIP) --only-binary :all: --require-hashes
COVEY := $(PIP) --no-deps --no-build-isolation --editable .

.DEFAULT_GOAL := help
.PHONY: help install paper test test-lowest lint format docs wheel check-package bench accounting soak fuzz faults mutants pins clean

help: ## Show this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1\t/p' Makefile | expand -t 24

install: $(READY) ## Set up .venv (the other targets do it by themselves)

# The stamp comes last, so a set-up that was broken off is started again.
$(READY): pyproject.toml requirements/develop.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "covey needs Python 3.11 or later, and $(PYTHON) is " + sys.version.split()[0] + ". Name another: make PYTHON=python3.12")'
	@echo "Setting up $(VENV): about a minute, and only when pyproject.toml or requirements/ has changed"
	@$(PYTHON) -m venv $(VENV)
	@$(BIN)/python $(PINNED) -r requirements/develop.txt
	@$(BIN)/python $(COVEY)
	@touch $@

paper: $(READY) ## Reproduce the paper's tables and figures in results/
	@$(BIN)/python -m covey warmup
	$(BIN)/python -m covey reproduce --output results

# Each worker loads the compiled kernels anew, so more than eight cost more than they bring.
test: $(READY) ## Run the tests on all cores (ARGS='-k name' for some of them)
	@$(BIN)/python -m covey warmup
	$(BIN)/python -m pytest -n auto --maxprocesses 8 $(ARGS)

# The lowest versions have wheels for Python 3.11, but not all for later ones.
test-lowest: ## Run the tests with the lowest versions that pyproject.toml allows (ARGS='-k name')
	@$(PYTHON) -m venv --clear build/lowest
	@build/lowest/bin/python $(PINNED) -r requirements/lowest.txt
	@build/lowest/bin/python $(COVEY)
	@build/lowest/bin/python -m covey warmup
	build/lowest/bin/python -m pytest -n auto --maxprocesses 8 $(ARGS)

lint: $(READY) ## Check format, style, types and who imports whom
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-logo

format: $(READY) ## Format the code and mend what can be mended by rule
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

# A warning is an error: a link that leads nowhere, a program that fails, a name that nobody documents.
docs: $(DOCS_READY) ## Build the documentation in build/docs (DOCS=folder for another)
	@$(BIN)/python -m covey warmup
	@rm -rf docs/generated
	$(BIN)/python -m sphinx -b html -d build/doctrees -E -W --keep-going -q docs $(or $(DOCS),build/docs)

$(DOCS_READY): $(READY) requirements/docs.txt
	@$(BIN)/python $(PINNED) -r requirements/docs.txt
	@touch $@

wheel: $(READY) ## Build a wheel with the compiled kernels inside (PLATFORM=all for every platform)
	@$(BIN)/python $(PINNED) -r requirements/wheel.txt
	$(BIN)/python packaging/wheels.py $(PLATFORM)

mutants: $(READY) ## Plant bugs, one at a time, and say which test catches each (ARGS='--room views')
	$(BIN)/python -m mutants $(ARGS)

bench: $(READY) ## Measure speed; never a part of the tests
	$(BIN)/python -m pytest benchmarks --ignore benchmarks/bench_accounting.py --benchmark-only $(ARGS)

accounting: $(READY) ## Show where the time of a plan goes, kernel by kernel
	COVEY_JIT=1 $(BIN)/python -m pytest benchmarks/bench_accounting.py --benchmark-only $(ARGS)

soak: $(READY) ## Play random games against the rules (HOURS=1; SEED=... repeats a failure; ARGS='--workers 1')
	@$(BIN)/python -m covey warmup
	$(BIN)/python -m soak $(if $(SEED),--seed $(SEED),--hours $(or $(HOURS),1)) $(ARGS)

faults: $(READY) ## Kill, interrupt, fill up and cut, at random moments, and compare (ARGS='--seed 1')
	$(BIN)/python -m faults $(ARGS)

fuzz: $(READY) ## Search for inputs that break covey (MINUTES=10, SEED= to repeat, CASE=file)
	@$(BIN)/python -m covey warmup
	PYTHONPATH=tests $(BIN)/python -m fuzz $(if $(MINUTES),--minutes $(MINUTES)) $(if $(SEED),--seed $(SEED)) $(if $(CASE),--case $(CASE))

check-package: $(READY) ## Build the package, install it in an empty environment and use it there
	$(BIN)/python packaging/check_installed.py

# Versions that still fit stay as they are, but the lowest, which follow from pyproject.toml.
COMPILE := build/pins/bin/uv pip compile --universal --generate-hashes --no-annotate --quiet --custom-compile-command 'make pins'
pins: ## Write requirements/, the versions and hashes that are installed (ARGS=--upgrade for the newest)
	@$(PYTHON) -m venv --clear build/pins
	@build/pins/bin/python $(PINNED) -r requirements/pins.txt
	$(COMPILE) pyproject.toml --extra all --group dev $(ARGS) --output-file requirements/develop.txt
	$(COMPILE) pyproject.toml --extra all --group dev --resolution lowest-direct --upgrade --output-file requirements/lowest.txt
	$(COMPILE) --group docs --constraints requirements/develop.txt $(ARGS) --output-file requirements/docs.txt
	$(COMPILE) --group wheel $(ARGS) --output-file requirements/wheel.txt
	$(COMPILE) --group pins $(ARGS) --output-file requirements/pins.txt

clean: ## Remove the environment and all caches, but no results
	rm -rf $(VENV) build dist docs/generated fuzz/findings .benchmarks .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	find src tests benchmarks soak fuzz faults -name __pycache__ -type d -prune -exec rm -rf {} + 2>/dev/null || true
