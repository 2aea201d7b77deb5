#!/usr/bin/env bash
# Installs what is missing, with apt: scripts/install_dependencies.sh run|test|ci
# run: what it takes to build and run; test: and to pass the tests; ci: and the checks of .ci/run.
set -euo pipefail

# libfmt, yaml-cpp, UDUNITS-2, CLI11, zlib, HDF5: see README, "What is in the box"
packages=(g++ cmake ninja-build libfmt-dev libyaml-cpp-dev libudunits2-dev libcli11-dev zlib1g-dev libhdf5-dev)
[[ "$1" == run ]] || packages+=(doctest-dev python3 python3-dev pybind11-dev python3-numpy python3-matplotlib gmsh python3-meshio openfoam-examples)
[[ "$1" == ci ]] && packages+=(clang-14 libclang-rt-14-dev libomp-14-dev clang-format-14)

missing=()
for package in "${packages[@]}"; do
  [[ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)" == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then exit 0; fi

as_root=()
if [[ "$(id -u)" != 0 ]]; then as_root=(sudo); fi
echo "Installing with apt: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
