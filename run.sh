#!/usr/bin/env bash
# Builds perimpact and runs a case: ./run.sh [CASE [arguments of `perimpact run`]]
# CASE is a folder of cases/ (default: plate_impact), a deck in one (plate_impact/analytic.yaml), or any deck file.
# The results of an earlier run are kept: run it again with --force, continue it with --resume.
set -euo pipefail
cd "$(dirname "$0")"

case_name=plate_impact
if [[ $# -gt 0 && $1 != -* ]]; then
  case_name=$1
  shift
fi
if [[ -f "cases/$case_name/deck.yaml" ]]; then deck="cases/$case_name/deck.yaml"
elif [[ -f "cases/$case_name" ]]; then deck="cases/$case_name"
elif [[ -f "$case_name" ]]; then deck="$case_name"
else
  echo "error: there is no case $case_name; the cases are: $(cd cases && echo *)" >&2
  exit 2
fi

scripts/install_dependencies.sh run
cmake --preset release -DPERIMPACT_TESTS=OFF >/dev/null
cmake --build --preset release
exec build/release/perimpact run "$deck" "$@"
