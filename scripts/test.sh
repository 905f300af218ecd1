#!/usr/bin/env bash
# Builds the project and runs all tests: with the checks of CGAL and of the standard library, and
# with sanitizers.
# Usage: scripts/test.sh
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=$(nproc)

scripts/install_dependencies.sh chromium clang lib3mf-dev libopenmpi-dev libptscotch-dev libvtk9-dev mypy openmpi-bin pybind11-dev python3-dev python3-mypy python3-numpy python3-pytest strace

# One build for the headers, the program, the Python module and the installed package. Clang takes two
# thirds of the time of GCC, with which scripts/main_job.sh and scripts/check_more.sh build. -O1, because the tests are too
# slow without optimization. scripts/check_more.sh builds the benchmarks, because nothing runs them here, and the
# examples and some tests, because they take long to compile.
echo "== With the checks of CGAL and of the standard library"
cmake -S . -B build-checked -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -D_GLIBCXX_ASSERTIONS" \
  -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF -DDSC_SHARE_COMPILATION=ON -DDSC_BUILD_SLOW_TESTS=OFF \
  -DDSC_WITH_MPI=ON -DDSC_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
cmake --build build-checked --parallel "$jobs"

# Sanitizers slow the compilation down, so only the tests with damaged input run with them here; these tests are
# short and need no optimization. scripts/check_more.sh runs all tests with sanitizers. They are one unit, which
# takes one core only, so they are built beside the other tests.
sanitized=(test_fuzzed_readers)
build_sanitized() {
  cmake -S . -B build-sanitized -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O0 -g1" -DDSC_BUILD_COMPILED=OFF \
    -DDSC_SANITIZE=ON -DDSC_BUILD_PYTHON=OFF -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF
  nice cmake --build build-sanitized --parallel 1 --target "${sanitized[@]}"
}
(set -e; build_sanitized) >build-checked/sanitized.log 2>&1 &
built=$!
ctest --test-dir build-checked --output-on-failure --no-tests=error --parallel "$jobs"

echo "== With the address and undefined behaviour sanitizers: damaged files"
wait "$built" || { cat build-checked/sanitized.log; exit 1; }
ctest --test-dir build-sanitized --output-on-failure --no-tests=error --parallel "$jobs" \
  --tests-regex "^($(IFS='|'; echo "${sanitized[*]}"))\."
