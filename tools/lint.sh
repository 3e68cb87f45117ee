#!/bin/sh
# Formats, clippy, ruff, mypy and TypeScript; all of them run, and any failure makes the exit code 1.
failed=0
check() {
  echo "lint: $*"
  "$@" || failed=1
}
check cargo fmt --all --check
check cargo clippy --quiet --locked --workspace --all-targets --all-features -- -D warnings
check .venv/bin/ruff check
check .venv/bin/ruff format --check
check .venv/bin/mypy
check .venv/bin/python tools/notices.py --check
check npm --prefix web exec --no -- tsc --noEmit --project web
exit $failed
