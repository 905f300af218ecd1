#!/usr/bin/env bash
# Builds everything and runs all the tests: as users get it, and with CGAL's checks and sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=$(nproc)

scripts/install_dependencies.sh

# Optimized but a little, to save a third of the time for compilation. Nobody runs the benchmarks
# here, so they are parsed only; scripts/check_more.sh builds them.
echo "== Release: the program, the installed package, examples and benchmarks"
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
  -DDSC_BUILD_UNIT_TESTS=OFF -DDSC_SHARE_COMPILATION=ON -DDSC_ONLY_PARSE_BENCHMARKS=ON
cmake --build build --parallel "$jobs"
ctest --test-dir build --output-on-failure --no-tests=error --parallel "$jobs"

echo "== Inputs that were once lost, misread or refused for a wrong reason"
/usr/bin/python3 scripts/check_inputs.py build/dsc

# Optimized a little, or it would be too slow to run. Sanitizers take two thirds of the time that
# compilation takes with them, so they watch what meets the worst input, which is short and needs no
# optimization; scripts/check_more.sh has them watch everything.
echo "== Debug, with the checks of CGAL and of the standard library: the headers"
cmake -S . -B build-checked -G Ninja -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -D_GLIBCXX_ASSERTIONS" \
  -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF \
  -DDSC_SHARE_COMPILATION=ON
cmake --build build-checked --parallel "$jobs"
ctest --test-dir build-checked --output-on-failure --no-tests=error --parallel "$jobs"

echo "== With the address and undefined behaviour sanitizers: damaged files and random changes"
sanitized=(test_fuzzed_readers test_random_abuse)
cmake -S . -B build-sanitized -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O0 -g1" -DDSC_BUILD_COMPILED=OFF \
  -DDSC_SANITIZE=ON -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF
cmake --build build-sanitized --parallel "$jobs" --target "${sanitized[@]}"
ctest --test-dir build-sanitized --output-on-failure --no-tests=error --parallel "$jobs" \
  --tests-regex "^($(IFS='|'; echo "${sanitized[*]}"))\."
