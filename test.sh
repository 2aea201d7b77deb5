#!/usr/bin/env bash
# Builds perimpact and passes all its tests but the long ones, with one run of the plate at full size: ./test.sh [arguments of ctest]
set -euo pipefail
cd "$(dirname "$0")"

scripts/install_dependencies.sh test
cmake --preset release -DPERIMPACT_TESTS=ON -DPERIMPACT_PYTHON=ON >/dev/null
cmake --build --preset release
exec ctest --preset release "$@"
