#!/usr/bin/env bash
# Learns the classes that come with the library, from simulated scenes only (seeds 1 to 999; the
# benchmark draws from 1001). Takes about half an hour of one core and 3 GB of disk.
# Usage: tools/learn_classes.sh [WORK_FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
tool=build/release/scanfuse
work=${1:-$(mktemp -d)}
mkdir -p "$work"

# simulate SCENARIO SENSOR SCENES SEED_BEFORE_THE_FIRST [HEIGHTS_M]: mounted at each height in turn
recordings=()
simulate() {
  local heights=(${5:-0})
  for ((scene = 1; scene <= $3; ++scene)); do
    local seed=$(($4 + scene))
    local file="$work/$1-$2-$seed.mcap"
    [ -s "$file" ] || "$tool" simulate "$1" -o "$file" --sensor "$2" --seed $seed \
      --set simulate.height_m="${heights[scene % ${#heights[@]}]}" --quiet
    recordings+=("$file")
  done
}
simulate among-people hokuyo-utm30 30 600 "0.35 0.2 0.5 0.3 0.6 0.4"
simulate among-people sick-lms111 15 640 "0.3 0.5 0.2 0.6"
simulate among-people rplidar-a2 10 660 "0.2 0.35 0.5"
simulate among-people lux 15 680 "0.5 0.3 0.7"
simulate among-people vlp16 8 700 "0.5 0.8 1.1"
simulate road-users lux 80 0
simulate mixed-streets lux 100 400 "0.55 0.3 0.8 1.2 0.55 1.7"
simulate mixed-streets sick-lms291 20 500 "0.4 0.7 1.0"
simulate mixed-streets sick-lms111 20 520 "0.3 0.6 1.0"
simulate mixed-streets hokuyo-utm30 20 540 "0.3 0.6 1.0"
simulate mixed-streets vlp16 15 560 "0.8 1.73 1.3"
simulate road-users sick-lms111 10 200
simulate road-users hokuyo-utm30 10 200
simulate road-users vlp16 10 300
simulate mixed-streets hdl32 5 580
simulate mixed-streets hdl64 5 590
simulate mixed-streets hdl64 4 720 "1.5 1.73 2.0"
"$tool" learn classes "${recordings[@]}" --vary -o scanfuse/pipeline/classes.toml \
  --report "$work/classes.html"
echo "report: $work/classes.html; build again to take the new classes in"
