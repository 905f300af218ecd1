#!/usr/bin/env bash
# Builds everything and runs all the tests: as users get it, and with CGAL's checks and sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=$(nproc)

scripts/install_dependencies.sh

echo "== Release"
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build build --parallel "$jobs"
ctest --test-dir build --output-on-failure --no-tests=error --parallel "$jobs"

# Only the tests, optimized a little: unoptimized CGAL is too slow to run them.
echo "== Debug, with the address and undefined behaviour sanitizers"
cmake -S . -B build-checked -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" \
  -DDSC_SANITIZE=ON -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF
cmake --build build-checked --parallel "$jobs"
ctest --test-dir build-checked --output-on-failure --no-tests=error --parallel "$jobs"
