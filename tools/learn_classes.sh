#!/usr/bin/env bash
# Learns the classes that come with the library, from simulated scenes only (seeds 1 to 999; the
# benchmark draws from 1001). Takes a few minutes. Usage: tools/learn_classes.sh [WORK_FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
tool=build/release/scanfuse
work=${1:-$(mktemp -d)}
mkdir -p "$work"

# simulate SENSOR SCENES SEED_BEFORE_THE_FIRST
recordings=()
simulate() {
  for ((scene = 1; scene <= $2; ++scene)); do
    local file="$work/$1-$scene.mcap"
    [ -s "$file" ] || "$tool" simulate road-users -o "$file" --sensor "$1" --seed $(($3 + scene)) --quiet
    recordings+=("$file")
  done
}
simulate lux 100 0
simulate sick-lms111 20 200
simulate hokuyo-utm30 20 200
simulate vlp16 15 300
"$tool" learn classes "${recordings[@]}" -o scanfuse/pipeline/classes.toml \
  --report "$work/classes.html"
echo "report: $work/classes.html; build again to take the new classes in"
