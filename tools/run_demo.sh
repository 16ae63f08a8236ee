#!/usr/bin/env bash
# What `make run` does after building: tracks the second scenario of [Lu2018] and, if one is named,
# a recording, each into tracks (MCAP and CSV) and a page to look at.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:-out}
input=${2:-}
tool=build/release/scanfuse
mkdir -p "$out"

# track NAME INPUT OPTIONS...; exit code 3 says that damaged parts were skipped: still a result.
track() {
  local name=$1 code=0
  "$tool" track "$2" -o "$out/$name.mcap" -o "$out/$name.csv" --report "$out/$name.html" \
    "${@:3}" || code=$?
  [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || exit "$code"
}

"$tool" simulate lu2018-2 -o "$out/lu2018-2-scans.mcap" --seed 7
track lu2018-2 "$out/lu2018-2-scans.mcap"
"$tool" evaluate "$out/lu2018-2.mcap" --truth "$out/lu2018-2-scans.mcap" \
  --min-visible-points 3 --region=-1e6,1e6,-2,5.4 --gospa-c-m 3
shown="$out/lu2018-2-scans.mcap"
if [ -n "$input" ]; then
  track "$(basename "${input%.*}")" "$input" ${TRACK_OPTIONS:-}
  shown="$input ${TRACK_OPTIONS:-}"
fi
echo
echo "Look at $out/lu2018-2.html in a browser; open $out/lu2018-2.mcap in Foxglove."
if [ -t 1 ] && [ -z "${CI:-}" ]; then  # somebody is there: show it until Ctrl-C
  exec "$tool" view $shown
fi
echo "In a browser: $tool view $shown"
