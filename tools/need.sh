#!/bin/sh
# Says in one line what this machine lacks: tools/need.sh rust|lint|node|python ...
# `tools/need.sh which-python` prints the first Python that is new enough, or python3.

missing() {
  echo "$1"
  exit 1
}

# at_least 20.19.2 20.19: whether the first version is the second or later
at_least() {
  [ "$(printf '%s\n%s\n' "$2" "${1%%[-+ ]*}" | sort -t. -k1,1n -k2,2n -k3,3n | head -n 1)" = "$2" ]
}

need_rust() {
  command -v cargo >/dev/null || missing "cargo is missing; install Rust from https://rustup.rs"
  needed=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
  found=$(rustc --version 2>/dev/null | cut -d ' ' -f 2)
  [ -n "$found" ] || missing "rustc does not run; set a toolchain: rustup default stable"
  at_least "$found" "$needed" || missing "rustc $found is too old, $needed or newer is needed: rustup update"
  command -v cc >/dev/null || missing "a C linker (cc) is missing; on Debian: apt install gcc"
}

need_lint() {
  cargo clippy --version >/dev/null 2>&1 && cargo fmt --version >/dev/null 2>&1 ||
    missing "clippy or rustfmt is missing; run: rustup component add clippy rustfmt"
}

need_node() {
  command -v node >/dev/null || missing "node is missing; install Node.js 20.19 or newer"
  found=$(node --version | tr -d v)
  at_least "$found" 20.19 || missing "node $found is too old, 20.19 or newer is needed"
  command -v npm >/dev/null || missing "npm is missing; it comes with Node.js"
}

python_is_new() {
  "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1
}

which_python() {
  for candidate in python3 python3.14 python3.13 python3.12 python3.11; do
    python_is_new "$candidate" && break
    candidate=python3
  done
  echo "$candidate"
}

need_python() {
  name=${PYTHON:-$(which_python)}
  command -v "$name" >/dev/null || missing "$name is missing; install Python 3.11 or newer"
  python_is_new "$name" || missing "$("$name" --version 2>&1) is too old, 3.11 or newer is needed"
  uv --version >/dev/null 2>&1 || "$name" -c 'import venv, ensurepip' 2>/dev/null ||
    missing "Python's venv module is missing; on Debian: apt install python3-venv"
}

for what in "$@"; do
  case $what in
    rust | lint | node | python) "need_$what" ;;
    which-python) which_python ;;
    *) missing "tools/need.sh does not know '$what'" ;;
  esac
done
