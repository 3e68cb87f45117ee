#!/bin/sh
# The pictures of docs/job and of the tutorial, made by the program. Needs .venv (`make develop`).
set -eu
cd "$(dirname "$0")/../docs/job"
kingpost=${KINGPOST:-../../.venv/bin/kingpost}
run=$(mktemp --suffix=.nc)
trap 'rm -f "$run"' EXIT
$kingpost run lift.yaml -o "$run" > /dev/null
$kingpost plot "$run" -o lift.png \
  --channels hoist_rope.rope_offlead hoist_rope.rope_sidelead hoist_rope.rope_daf manifold.position.z
