#!/usr/bin/env bash
# The page of `scanfuse view`: types, unit tests, that web/dist is what the sources give, and, with
# a tool named, a browser that drives it (pictures go to build/viewer-pictures).
#   tools/check_viewer.sh [TOOL]
set -euo pipefail
cd "$(dirname "$0")/.."

if [ ! -d web/node_modules ] && ! npm ci --prefix web --no-audit --no-fund; then
  echo "skipped: npm packages could not be had"
  exit 0
fi
cd web
npx tsc --noEmit
npx vitest run
built=$(mktemp -d)
trap 'rm -rf "$built"' EXIT
npx vite build --outDir "$built" --emptyOutDir --logLevel warn
if ! diff -rq "$built" dist; then
  echo "web/dist is not what the sources give: run 'npm run build' in web/ and commit it" >&2
  exit 1
fi
long=$(find src tests -name '*.ts' -exec awk 'END { if (NR > 300) print FILENAME ": " NR " lines; split past 300" }' {} \;)
[ -z "$long" ] || { echo "$long" >&2; exit 1; }
echo "the page is what its sources give"
cd ..
if [ -n "${1:-}" ]; then
  node web/browser/drive.mjs "$1" build/viewer-pictures ../shared/data
fi
