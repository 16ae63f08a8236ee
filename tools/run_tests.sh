#!/usr/bin/env bash
# What `make test` runs: release build with benchmarks and all its tests, style, the installed
# package. Each step is told with the seconds it took.
# SCANFUSE_CHECKS names more of them: asan, fuzz, tsan, tidy.
# Ends with a line that counts the tests.
set -uo pipefail
cd "$(dirname "$0")/.."
passed=0
failed=0
skipped=0

# step NAME COMMAND...: one check that passes or fails as a whole.
step() {
  local name=$1 start=$SECONDS code=0
  shift
  printf '== %s' "$name"
  "$@" > "$log" 2>&1 || code=$?
  echo " ($((SECONDS - start)) s)"
  if [ "$code" -eq 0 ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    tail -n 60 "$log"
    echo "FAILED: $name"
  fi
}

# suite NAME PRESET CTEST-ARGS...: runs ctest and adds its counts.
suite() {
  local name=$1 preset=$2 start=$SECONDS
  shift 2
  printf '== %s' "$name"
  (cd "build/$preset" && ctest --output-on-failure -j "$(nproc)" "$@") > "$log" 2>&1
  echo " ($((SECONDS - start)) s)"
  local bad skip all
  all=$(grep -cE '^ *[0-9]+/[0-9]+ Test +#' "$log")
  skip=$(grep -cE '\*\*\*Skipped' "$log")
  bad=$((all - skip - $(grep -cE ' Passed +[0-9.]+ sec' "$log")))
  if [ "$all" -eq 0 ]; then
    bad=1
    tail -n 40 "$log"
  fi
  [ "$bad" -eq 0 ] || grep -vE ' Passed +[0-9.]+ sec|^ *Start +[0-9]+:' "$log" | tail -n 200
  [ "$skip" -eq 0 ] || echo "$skip skipped (no shared data, or a peer is not installed)"
  passed=$((passed + all - skip - bad))
  failed=$((failed + bad))
  skipped=$((skipped + skip))
}

build() { cmake --preset "$1" "${@:2}" && cmake --build --preset "$1"; }

# Only what uses threads: a whole build for a few tests would take minutes.
build_threaded() {
  cmake --preset tsan && cmake --build --preset tsan \
    --target core_test pipeline_test serve_test drivers_test
}

install_and_consume() {
  local prefix=$PWD/build/install
  rm -rf "$prefix" build/consumer
  cmake --install build/release --prefix "$prefix" &&
    cmake -S tests/consumer -B build/consumer -G Ninja -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_PREFIX_PATH="$prefix" &&
    cmake --build build/consumer && build/consumer/consumer
}

fuzz_all() {
  local seconds=${SCANFUSE_FUZZ_SECONDS:-25} binary name
  export seconds
  for binary in build/asan/fuzz/*_fuzz; do basename "$binary"; done |
    xargs -P "$(nproc)" -I{} bash -c '
      mkdir -p build/fuzz/{}
      build/asan/fuzz/{} -max_total_time=$seconds -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 \
        -artifact_prefix=build/fuzz/ build/fuzz/{} fuzz/corpus/{} > build/fuzz/{}.log 2>&1 ||
        { tail -n 40 build/fuzz/{}.log; exit 255; }'
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT

if [ -f tests/npm/package.json ] && command -v npm > /dev/null && [ ! -d tests/npm/node_modules ]; then
  npm ci --prefix tests/npm --no-audit --no-fund > "$log" 2>&1 || echo "npm packages could not be had"
fi
step "style" tools/check_style.sh
step "build (GCC, release)" build release \
  -DSCANFUSE_BUILD_TESTS=ON -DSCANFUSE_BUILD_BENCH=ON -DSCANFUSE_BUILD_PYTHON=ON \
  ${SCANFUSE_UNITY_BATCH:+"-DSCANFUSE_UNITY_BATCH=$SCANFUSE_UNITY_BATCH"}
suite "tests (GCC, release)" release
step "the viewer: types, tests, the built page, a browser" tools/check_viewer.sh build/release/scanfuse
step "install, then build and run a user's project" install_and_consume
# Asked for, and begun before SCANFUSE_BUDGET_S seconds are gone.
wants() {
  [[ " ${SCANFUSE_CHECKS:-} " == *" $1 "* ]] || return 1
  [ "$SECONDS" -lt "${SCANFUSE_BUDGET_S:-1000000}" ] && return
  echo "== $1 is left out: $SECONDS s are gone"
  skipped=$((skipped + 1))
  return 1
}
asan=no
fuzz=no
wants asan && asan=yes
wants fuzz && fuzz=yes
if [ "$asan$fuzz" != nono ]; then
  step "build (Clang, address and undefined-behaviour sanitizers)" build asan
fi
if [ $asan = yes ]; then suite "tests (sanitizers)" asan -LE slow; fi
if [ $fuzz = yes ]; then step "fuzz every reader for ${SCANFUSE_FUZZ_SECONDS:-25} s" fuzz_all; fi
if wants tsan; then
  step "build (Clang, thread sanitizer)" build_threaded
  suite "tests (thread sanitizer)" tsan -R '^(Parallel|Server|Workbench|ViewerTest|Ros2\.)'
fi
if wants tidy; then step "clang-tidy" tools/check_style.sh --tidy; fi

echo
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
