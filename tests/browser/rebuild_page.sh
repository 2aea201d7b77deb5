#!/usr/bin/env bash
# Builds the page of the report anew, from report/ as it is, and compares every byte with the one that is committed. Needs npm and its registry;
# where that cannot be reached it says so and ends with 0, for a test compares fingerprints all the same (tests/quality/report_template.py).
set -euo pipefail
cd "$(dirname "$0")/../../report"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r index.html package.json package-lock.json tsconfig.json vite.config.ts src "$work"
cp dist/template.html "$work/committed.html"
cd "$work"

if ! npm ci --no-audit --no-fund --fetch-retries=1 --fetch-timeout=30000 >npm.log 2>&1; then
  if grep -qE "ENOTFOUND|ECONNREFUSED|ECONNRESET|ETIMEDOUT|EAI_AGAIN|ENETUNREACH|EHOSTUNREACH|network" npm.log; then
    echo "npm's registry cannot be reached: the page is not built anew, the committed one is used."
    exit 0
  fi
  cat npm.log >&2
  exit 1
fi
npm run build >build.log 2>&1 || { cat build.log >&2; exit 1; }
if ! cmp dist/template.html committed.html; then
  echo "error: report/dist/template.html is not what its sources give: npm ci && npm run build in report/, and commit it." >&2
  exit 1
fi
echo "the page is what its sources give"
