#!/usr/bin/env bash
# Builds the Debian packages, build/package/perimpact_*.deb, perimpact-mpi_*.deb, python3-perimpact_*.deb, libfccda-dev_*.deb
# and perimpact-doc_*.deb.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh package
scripts/build_docs.sh
cmake --preset package >/dev/null
cmake --build --preset package
(cd build/package && cpack -G DEB >/dev/null)
ls -1 build/package/*.deb
