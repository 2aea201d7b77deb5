#!/usr/bin/env bash
# Installs what is missing, with apt: scripts/install_dependencies.sh run|test|ci|docs|package
# run: what it takes to build and run; test: and to pass the tests; ci: and the checks of .ci/run.
# docs: what builds the documentation, and nothing else; package: what builds the Debian package, with the documentation.
set -euo pipefail

# libfmt, yaml-cpp, UDUNITS-2, CLI11, zlib, HDF5: what the program links (docs/guide/cluster.md)
build=(g++ cmake ninja-build libfmt-dev libyaml-cpp-dev libudunits2-dev libcli11-dev zlib1g-dev libhdf5-dev)
# runs of several processes; the build goes without if it is missing
mpi=(libopenmpi-dev openmpi-bin)
tests=(doctest-dev gfortran pkg-config python3 python3-dev pybind11-dev python3-numpy python3-h5py python3-matplotlib python3-yaml python3-jsonschema gmsh python3-meshio openfoam-examples python3-lammps liblammps-dev python3-mpi4py python3-pysph python3-scipy python3-dolfinx)
checks=(clang-14 libclang-rt-14-dev libomp-14-dev clang-format-14 chromium firefox-esr xvfb poppler-utils zsh fish man-db)
[[ -n "$(type -P npm)" ]] || checks+=(nodejs npm)
docs=(python3 python3-sphinx python3-myst-parser furo doxygen)
case "${1:-}" in
  run) packages=("${build[@]}") ;;
  test) packages=("${build[@]}" "${mpi[@]}" "${tests[@]}") ;;
  ci) packages=("${build[@]}" "${mpi[@]}" "${tests[@]}" "${checks[@]}" "${docs[@]}") ;;
  docs) packages=("${docs[@]}") ;;
  package) packages=("${build[@]}" "${mpi[@]}" "${docs[@]}" python3-dev pybind11-dev python3-numpy dpkg-dev file) ;;
  *) echo "error: scripts/install_dependencies.sh run|test|ci|docs|package" >&2; exit 2 ;;
esac

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
