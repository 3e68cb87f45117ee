# From a fresh clone: rustup, a C linker, Python >= 3.11, Node >= 20.19 and make. The rest comes by
# itself, the Python side into .venv.

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
# Two at a time: the engine for the browser beside the one for Python, since a compiler is on one core for a third of its time.
MAKEFLAGS += --no-builtin-rules --no-print-directory --jobs=2

export PYTHON ?= $(shell sh tools/need.sh which-python)
export UV_PYTHON ?= $(PYTHON)
export UV_PYTHON_DOWNLOADS ?= never
# Python keeps what it compiles, whatever the machine says: hundreds of starts use it.
export PYTHONDONTWRITEBYTECODE :=
BIN := .venv/bin
DONE := target/make

# What is built, and from what.
WASM := web/src/engine/pkg/kingpost_wasm_bg.wasm
APP := web/dist/index.html
NODE_MODULES := web/node_modules/.package-lock.json
GALLERY := $(wildcard scenarios/*.yaml scenarios/parts/*.yaml scenarios/hydro/*.json)
sources = $(shell find $(1) -type f -not -path '*/pkg/*' -not -path '*/__pycache__/*' 2>/dev/null)
ENGINE := Cargo.toml Cargo.lock $(call sources,crates/kingpost/src crates/kingpost/Cargo.toml crates/kingpost-derive)

# Two lanes of tests. The default one compiles the engine once, by the profile `proof`, for its own tests and for Python. The
# thorough one runs Python's tests on the wheel's engine, and the engine's own with checks of overflow and debug assertions.
LANE := $(or $(KINGPOST_LANE),default)
# kingpost-py, which has no tests in Rust, is chosen beside it: with other crates the features of their libraries differ, and
# cargo compiles the engine once more.
TESTED := --package kingpost --package kingpost-py --all-features $(if $(filter thorough,$(LANE)),,--profile proof)
TESTS_OF_LANE := $(if $(filter thorough,$(LANE)),--include-ignored)
DEVELOP := $(DONE)/$(if $(filter thorough,$(LANE)),wheel-develop,develop)

# In the thorough lane Python compares the wheel's engine, bit by bit, with one that is hardly optimised.
PLAIN := $(if $(filter thorough,$(LANE)),PYO3_BUILD_EXTENSION_MODULE=1 cargo build --quiet --locked --package kingpost-py --all-features,@true)

# The wheel's engine is built for this processor. AVX2 changes no bit: it makes the registers wider.
THIS_PROCESSOR = $(if $(shell rustc --print cfg -C target-cpu=native | grep '"avx2"'),-C target-feature=+avx2)

# uv: the one at hand, else this one from PyPI.
UV_VERSION := 0.13.9
UV := $(shell uv --version >/dev/null 2>&1 && echo uv || echo $(DONE)/uv/bin/uv)
UV_FILE := $(filter-out uv,$(UV))
PYTHON_SIDE := pyproject.toml uv.lock $(ENGINE) $(call sources,crates/kingpost-py) $(UV_FILE)

.PHONY: help demo compile compile-tests test test-thorough bench wasm web wheel develop docs schema notices lint format clean
.PHONY: test-rust test-web test-browser test-python need-rust need-node need-python need-lint

help: ## list what there is
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

demo: need-rust need-node need-python $(APP) $(DONE)/run ## run the paper's crane ship, then serve the app
	$(BIN)/kingpost paper
	$(BIN)/kingpost serve $(if $(filter true 1,$(CI)),--check)

compile: need-rust need-node need-python $(WASM) $(DEVELOP) compile-tests ## all that is compiled: the engine for the browser, for Python and for its tests

# After the Python module, so that what is compiled beside it is the engine for the browser: the longest first.
compile-tests: | need-rust $(DEVELOP)
	cargo test --locked $(TESTED) --no-run
	$(PLAIN)

test: need-rust need-node need-python need-lint ## one proof of every kind of truth, and a summary
	@$(PYTHON) tools/test.py

test-thorough: ## every test there is, of the wheel's engine, and of one that checks each sum for overflow
	@KINGPOST_LANE=thorough $(MAKE) test

test-rust: need-rust ## the engine's tests
	cargo test --locked $(TESTED) --no-fail-fast --lib --bins --tests -- $(TESTS_OF_LANE)
	cargo test --locked $(TESTED) --no-fail-fast --doc

test-web: $(NODE_MODULES) $(WASM) ## the app's tests without a browser
	cd web && npm test

test-browser: $(APP) ## the app's tests in Chromium; skipped where there is none
	cd web && npm run test:browser

test-python: $(DEVELOP) $(APP) ## the Python package's tests
	$(PLAIN)
	$(BIN)/pytest --numprocesses auto --maxprocesses 4 --dist loadfile --no-loadscope-reorder

bench: need-rust need-node need-python $(DONE)/wheel-develop $(WASM) ## compare speed with other engines
	$(BIN)/python benches/run.py
	$(BIN)/python benches/control.py
	$(BIN)/python benches/lines.py

wasm: $(WASM) ## the engine for the browser

web: $(APP) ## the browser app, in web/dist

wheel: $(APP) $(UV_FILE) | need-python need-rust ## a Python wheel with the app and the gallery, in dist/
	$(PYTHON) tools/wheel.py $(UV) build --quiet --wheel --out-dir dist
	@ls -1 dist/*.whl

develop: $(DONE)/develop ## .venv with the package as it stands here, by the tests' engine, and what its tests need

docs: $(DONE)/docs ## the documentation site, in target/site
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --quiet
	@echo target/site/index.html

schema: $(NODE_MODULES) | need-rust ## the scenario's JSON schema and TypeScript types, from the Rust types
	cargo run --quiet --locked --package kingpost --features schema --example write_schema
	cd web && npm run --silent types

notices: $(NODE_MODULES) | need-python need-rust ## THIRD_PARTY_NOTICES.txt: whose work is linked in, and its terms
	$(PYTHON) tools/notices.py

lint: $(NODE_MODULES) $(WASM) $(DEVELOP) | need-lint ## formats, clippy, ruff, mypy, notices, TypeScript
	tools/lint.sh

format: $(DONE)/develop ## format the Rust and the Python
	cargo fmt --all
	$(BIN)/ruff format

clean: ## remove what was built
	rm -rf target .venv dist web/dist web/node_modules $(dir $(WASM)) paper-results

need-rust need-node need-python need-lint: need-%:
	$(eval lacks := $(shell sh tools/need.sh $*))$(if $(lacks),$(error $(lacks)))@:

$(DONE)/uv/bin/uv: | need-python
	$(PYTHON) -m venv $(DONE)/uv
	$(DONE)/uv/bin/pip install --quiet --disable-pip-version-check uv==$(UV_VERSION)

# What a run needs, by the wheel's engine. One engine at a time is in .venv: the other's mark is removed.
$(DONE)/run: $(PYTHON_SIDE) | need-python need-rust
	RUSTFLAGS="$(THIS_PROCESSOR)" $(UV) sync --locked --inexact --no-default-groups --reinstall-package kingpost
	@rm -rf python/kingpost/avx2 $(DONE)/develop
	@mkdir -p $(DONE) && touch $@

# What the tests need besides.
$(DONE)/wheel-develop: $(DONE)/run
	RUSTFLAGS="$(THIS_PROCESSOR)" $(UV) sync --locked
	@touch $@

# The same by the engine that its own tests use.
$(DONE)/develop: $(PYTHON_SIDE) | need-python need-rust
	MATURIN_PEP517_ARGS="--profile proof --all-features" $(UV) sync --locked --reinstall-package kingpost
	@rm -rf python/kingpost/avx2 $(DONE)/run $(DONE)/wheel-develop $(DONE)/docs
	@mkdir -p $(DONE) && touch $@

# What the site needs besides: it asks the command line what it says of itself.
$(DONE)/docs: $(DONE)/run
	RUSTFLAGS="$(THIS_PROCESSOR)" $(UV) sync --locked --inexact --no-default-groups --group docs
	@touch $@

$(NODE_MODULES): web/package.json web/package-lock.json | need-node
	cd web && npm ci --no-audit --no-fund
	@touch $@

$(WASM): $(ENGINE) $(call sources,crates/kingpost-wasm xtask) | need-rust
	cargo xtask wasm

$(APP): $(NODE_MODULES) $(WASM) $(GALLERY) $(call sources,web/src web/public web/vite web/figure/src) \
    python/kingpost/paper/equations.json \
    $(wildcard web/*.html web/*.json web/*.ts web/figure/*.ts)
	cd web && npm run build
	@touch $@
