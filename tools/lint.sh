#!/bin/sh
# Formats, clippy, ruff, mypy and TypeScript; all of them run, and any failure makes the exit code 1.
failed=0
check() {
  echo "lint: $*"
  "$@" || failed=1
}
check cargo fmt --all --check
# By the profile of the tests: what expands derives is compiled once for both.
check cargo clippy --quiet --locked --profile proof --workspace --all-targets --all-features -- -D warnings
check .venv/bin/ruff check
check .venv/bin/ruff format --check
check .venv/bin/mypy
check .venv/bin/python tools/notices.py --check
check npm --prefix web exec --no -- tsc --noEmit --project web
exit $failed
