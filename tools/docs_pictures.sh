#!/bin/sh
# The pictures of docs/job, made by the program and the app. Needs .venv (`make develop`), the app (`make web`) and Chromium.
set -eu
cd "$(dirname "$0")/../docs/job"
kingpost=${KINGPOST:-../../.venv/bin/kingpost}
run=$(mktemp --suffix=.nc)
trap 'rm -f "$run"' EXIT
$kingpost run lift.yaml -o "$run" > /dev/null
$kingpost plot "$run" -o lift.png \
  --channels hoist_rope.rope_offlead hoist_rope.rope_sidelead hoist_rope.rope_daf manifold.position.z

# The load over the side, as the app shows it.
address=$(mktemp)
$kingpost serve lift.yaml > "$address" &
server=$!
trap 'rm -f "$run" "$address"; kill "$server"' EXIT
until grep -q http "$address"; do sleep 1; done
node ../../web/scripts/job.mjs "$(grep -o 'http://[^ ]*' "$address" | head -n 1)" over_the_side.jpeg
