# Set-up is part of every target: type `make demo` or `make test` in a fresh clone and wait.

PYTHON ?= python3
BIN := .venv/bin
export PATH := $(CURDIR)/$(BIN):$(PATH)
export MPLBACKEND ?= Agg

.PHONY: help demo test slow quick lab build gallery data environment bench lint sandbox chromium postgresql clean

help:            ## what there is to type
	@grep -E '^[a-z]+:.*##' Makefile | sed -E 's/:.*##/\t/'

demo: .venv/.ready sandbox    ## make a sample class, grade it, compare with what each should get
	$(BIN)/autograder demo

test: .venv/.ready sandbox chromium postgresql    ## all tests, with the browser, and as many of the slow ones as there is time for
	$(BIN)/pytest -n 2 --dist loadgroup --no-loadscope-reorder --slow-until 360

slow: .venv/.ready sandbox    ## the long sweeps, every one of them
	$(BIN)/pytest -n 2 --dist loadgroup -m slow

quick: .venv/.ready sandbox    ## the tests without long sweeps and without a browser
	$(BIN)/pytest -n 2 --dist loadgroup -m "not slow and not browser"

lab: .venv/.ready    ## open JupyterLab on a copy of the student notebooks, in build/lab/; what you write there stays
	@mkdir -p build/lab && cp -R --no-clobber release/. build/lab/
	$(BIN)/jupyter lab --notebook-dir build/lab

build: .venv/.ready    ## make release/ and the public examples from source/
	$(BIN)/autograder build

gallery: .venv/.ready    ## a page in each language with every drawing, view and film, in build/gallery/
	$(BIN)/autograder gallery

data: .venv/.ready    ## make the logs in data/ anew
	$(BIN)/python -m course.datasets data

bench: .venv/.ready sandbox    ## what a check costs, and what grading a class costs, beside stock nbgrader
	$(BIN)/python bench/check.py
	PYTHONPATH=. $(BIN)/python bench/grading.py

lint: .venv/.ready
	$(BIN)/ruff check . && $(BIN)/ruff format --check . && $(BIN)/mypy

environment: .venv/.ready    ## pin all packages anew, from the ranges in pyproject.toml
	$(BIN)/uv pip compile pyproject.toml --group dev --generate-hashes --universal --python-version 3.11 --upgrade -o environment.txt

# uv itself comes from the pinned list too, hashes and all
.venv/.ready: environment.txt pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "Python 3.11 or newer is needed; type: make PYTHON=python3.11 $(MAKECMDGOALS)"; exit 1; }
	@test -x $(BIN)/pip || $(PYTHON) -m venv --clear .venv || { echo "Python cannot make a virtual environment; type: apt-get install python3-venv"; exit 1; }
	sed -n '/^uv==/,/[^\\]$$/p' environment.txt > .venv/uv.txt
	$(BIN)/pip install --quiet --disable-pip-version-check --require-hashes -r .venv/uv.txt
	$(BIN)/uv pip install --quiet --compile-bytecode --require-hashes -r environment.txt
	$(BIN)/uv pip install --quiet --no-deps --no-build-isolation -e .
	@touch $@

# libseccomp is not needed, but makes the sandbox tighter
sandbox:
	@{ command -v bwrap && /sbin/ldconfig -p | grep libseccomp.so.2; } >/dev/null || { $(call apt,bubblewrap libseccomp2) } || command -v bwrap >/dev/null || { echo "Grading needs bubblewrap; type: sudo apt-get install bubblewrap"; exit 1; }

chromium:
	@command -v chromium >/dev/null || { $(call apt,chromium) } || echo "No Chromium, so the browser tests are left out; to have them type: sudo apt-get install chromium"

postgresql:
	@ls /usr/lib/postgresql/*/bin/initdb >/dev/null 2>&1 || { $(call apt,postgresql) } || echo "No PostgreSQL, so its tests are left out; to have them type: sudo apt-get install postgresql"

# installs a Debian package if this user may, silently; fails otherwise
apt = (test "$$(id -u)" = 0 && apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $(1) >/dev/null 2>&1) || (command -v sudo >/dev/null && sudo -n true 2>/dev/null && sudo -n apt-get update -qq && sudo -n apt-get install -y -qq $(1) >/dev/null 2>&1);

clean:           ## remove what was generated here; not what a class handed in, nor what you wrote in build/lab/
	rm -rf build/demo .pytest_cache .mypy_cache .ruff_cache .hypothesis
