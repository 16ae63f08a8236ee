#!/usr/bin/env bash
# run_bench.sh OUT: measures accuracy and speed and writes OUT/bench-DATE.md, with the processor,
# the compiler and the commit. SCANFUSE_BENCH_SEEDS: fewer random runs than the benchmarks' own.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:-out}
mkdir -p "$out"
report=$out/bench-$(date -u +%Y-%m-%d).md
seeds=()
[ -z "${SCANFUSE_BENCH_SEEDS:-}" ] || seeds=(--seeds "$SCANFUSE_BENCH_SEEDS")

log=$(mktemp)
part=$report.part
trap 'rm -f "$log" "$part"' EXIT
{ cmake --preset release -DSCANFUSE_BUILD_BENCH=ON &&
  cmake --build --preset release --target scanfuse_cli benchmarks; } > "$log" 2>&1 ||
  { tail -n 40 "$log"; exit 1; }
tool=build/release/scanfuse

block() { printf '```\n'; cat; printf '```\n\n'; }

{
  printf '# Benchmarks of %s\n\n' "$(date -u +%Y-%m-%d)"
  printf '| | |\n|---|---|\n'
  printf '| processor | %s, %s cores |\n' \
    "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)"
  printf '| load before | %s |\n' "$(cut -d' ' -f1-3 /proc/loadavg)"
  printf '| compiler | %s |\n' "$(c++ --version | head -n 1)"
  printf '| commit | %s%s |\n\n' "$(git rev-parse --short HEAD 2> /dev/null || echo unknown)" \
    "$(git diff --quiet HEAD 2> /dev/null || echo ', with changes')"
  for name in segment track real; do
    printf '## scanfuse bench %s\n\n' "$name"
    "$tool" bench "$name" "${seeds[@]}" | block
  done
  for binary in build/release/bench/*_bench; do
    printf '## %s\n\n' "$(basename "$binary")"
    "$binary" --benchmark_min_time=0.2 2> /dev/null | block
  done
} > "$part"
mv "$part" "$report"
echo "wrote $report"
