#!/usr/bin/env bash
# Makes packages of Debian in build/packages: the programs, the headers and the Python module, and the
# program that reads files of other programs through VTK, Gmsh and lib3mf.
# Usage: scripts/make_packages.sh
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh dpkg-dev lib3mf-dev libgmsh-dev libvtk9-dev pybind11-dev python3-dev python3-numpy
cmake -S . -B build-packages -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DDSC_BUILD_TESTS=OFF -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF -DDSC_SHARE_COMPILATION=ON \
  -DDSC_BUILD_PYTHON=ON -DDSC_PYTHON_TORI=ON -DPython_EXECUTABLE=/usr/bin/python3 \
  -DDSC_PYTHON_INSTALL_DIR=lib/python3/dist-packages
cmake --build build-packages --parallel "$(nproc)"
(cd build-packages && cpack)
mkdir -p build/packages
mv build-packages/*.deb build/packages/
ls -l build/packages
