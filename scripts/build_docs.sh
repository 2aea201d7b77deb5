#!/usr/bin/env bash
# Builds the documentation, build/docs/index.html: static pages that need no network. Warnings are errors, and every link inside is
# tried. build/docs/cpp is the C++ reference.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh docs
rm -rf build/docs
/usr/bin/python3 -m sphinx -q -E -W --keep-going -b html -d build/docs_cache -c docs/site . build/docs
/usr/bin/python3 docs/site/cpp_reference.py build/docs/cpp
/usr/bin/python3 tests/quality/site_links.py build/docs
echo "Documentation: build/docs/index.html"
