#!/usr/bin/env bash
# Layers, file lengths, citations, format; with --tidy also clang-tidy over every source file.
set -euo pipefail
cd "$(dirname "$0")/.."

python3 tools/check_layers.py
git ls-files '*.hpp' '*.cpp' | xargs clang-format-19 --dry-run --Werror
echo "format is fine"

if [ "${1:-}" = --tidy ]; then
  cmake --preset tidy > /dev/null
  # The unity batches, not file by file: Eigen's and fmt's headers are then read once for six.
  sed -n 's/^  "file": "\(.*\)",\{0,1\}$/\1/p' build/tidy/compile_commands.json |
    grep -E '\.(cpp|cxx)$' |
    xargs -P "$(nproc)" -n 1 clang-tidy-19 -p build/tidy --quiet 2> /dev/null
  echo "clang-tidy is fine"
fi
