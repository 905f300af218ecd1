#!/usr/bin/env bash
# Runs the checks that take too long for scripts/test.sh: the benchmarks, all headers alone, the thread
# sanitizer, the other sanitizers, GCC, CGAL 6, more damaged files, random deformations, all examples, the
# demo, files of all programs that Debian has, the parallel solver, other toolchains, packages on a bare Debian 12, and
# Debian 13.
# Usage: scripts/check_more.sh [benchmarks] [headers] [threads] [sanitizers] [gcc] [cgal_6] [fuzz] [abuse]
#          [examples] [demo] [formats] [petsc] [toolchains] [packages] [debian_13]
# Runs all parts by default. Prints a line for each part; its full output is in build-more/PART.log.
set -euo pipefail
cd "$(dirname "$0")/.."
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(benchmarks headers threads sanitizers gcc cgal_6 fuzz abuse examples demo formats
  petsc toolchains packages debian_13)
jobs=$(nproc)
work=build-more
mkdir -p "$work"
flags=(-std=c++17 -Wall -Wextra -Werror -DCGAL_EIGEN3_ENABLED -DCGAL_USE_GMP -DCGAL_USE_MPFR
  -DCGAL_LINKED_WITH_TBB -frounding-math -isystem /usr/include/eigen3)

scripts/install_dependencies.sh

# Configures a Debug build, which enables the checks of CGAL.
configure() { # FOLDER OPTION...
  cmake -S . -B "$work/$1" -G Ninja -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" -DDSC_SHARE_COMPILATION=ON "${@:2}"
}

build_and_test() { # FOLDER OPTION...
  configure "$@"
  cmake --build "$work/$1" --parallel "$jobs"
  ctest --test-dir "$work/$1" --output-on-failure --no-tests=error --parallel "$jobs"
}

# Only parses the benchmarks; scripts/test.sh leaves them out.
check_benchmarks() {
  cmake -S . -B "$work/benchmarks" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDSC_BUILD_TESTS=OFF \
    -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_EXAMPLES=OFF -DDSC_SHARE_COMPILATION=ON \
    -DDSC_ONLY_PARSE_BENCHMARKS=ON
  cmake --build "$work/benchmarks" --parallel "$jobs" --target parsed_benchmarks
}

check_headers() {
  scripts/install_dependencies.sh petsc-dev libopenmpi-dev libptscotch-dev pkg-config
  local of_petsc
  read -ra of_petsc <<<"$(pkg-config --cflags-only-I PETSc ompi-c)"
  of_petsc+=(-I/usr/include/scotch)
  test/headers_alone.sh '*.h' "$jobs" g++ "${flags[@]}" "${of_petsc[@]/#-I/-isystem}"
}

check_threads() {
  g++ "${flags[@]}" -Iinclude -Itest/thread_sanitizer -Itest/support \
    -O1 -g1 -fsanitize=thread test/Deformable_simplicial_complexes/test_threads.cpp \
    -o "$work/test_threads" -lgtest -lgtest_main -lmpfr -lgmp -pthread
  "$work/test_threads"
}

# scripts/test.sh builds with Clang.
check_gcc() {
  build_and_test gcc -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-Werror
}

check_cgal_6() {
  scripts/fetch_cgal_6.sh "$work/cgal-6"
  [ -d "$work/cgal-6" ] || return 0
  # The test project for the installed package also reads CGAL_DIR.
  CGAL_DIR=$(realpath "$work"/cgal-6/usr/lib/*/cmake/CGAL)
  export CGAL_DIR
  build_and_test with-cgal-6 -DCGAL_DIR="$CGAL_DIR"
}

# Runs the unit tests with sanitizers; scripts/test.sh runs them without.
check_sanitizers() {
  build_and_test sanitized -DDSC_SANITIZE=ON -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_EXAMPLES=OFF \
    -DDSC_BUILD_BENCHMARKS=OFF
}

build_checked() { # TARGET
  configure checked -DDSC_SANITIZE=ON
  cmake --build "$work/checked" --parallel "$jobs" --target "$1"
}

check_fuzz() {
  build_checked test_fuzzed_readers
  DSC_FUZZ_MUTATIONS=100000 "$work/checked/test/test_fuzzed_readers"
}

check_abuse() {
  build_checked benchmark_random_abuse
  "$work/checked/benchmark/random_abuse" --seed 2
}

# scripts/test.sh leaves out the examples.
check_examples() {
  cmake -S . -B "$work/examples" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDSC_BUILD_TESTS=OFF \
    -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_BENCHMARKS=OFF -DDSC_BUILD_PYTHON=OFF -DDSC_SHARE_COMPILATION=ON
  cmake --build "$work/examples" --parallel "$jobs"
  ctest --test-dir "$work/examples" --output-on-failure --no-tests=error --parallel "$jobs"
}

# Builds the demo as a user does, with an installed package, and takes a picture of its first window.
check_demo() {
  scripts/install_dependencies.sh libcgal-qt5-dev qtbase5-dev libqt5opengl5-dev libqt5svg5-dev imagemagick
  cmake -S . -B "$work/installed" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDSC_BUILD_COMPILED=OFF \
    -DDSC_BUILD_TESTS=OFF -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF \
    -DDSC_BUILD_PYTHON=OFF
  cmake --build "$work/installed" --parallel "$jobs"
  cmake --install "$work/installed" --prefix "$work/prefix"
  cmake -S demo/Deformable_simplicial_complexes -B "$work/demo" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$PWD/$work/prefix"
  cmake --build "$work/demo"
  xvfb-run -a bash -c '"$1" & sleep 10; import -window root "$2"; kill $!' demo "$work/demo/merging_cubes" "$work/demo.png"
  [ "$(identify -format %k "$work/demo.png")" -gt 2 ] # colors: more than an empty screen has
}

# Reads files that Gmsh, meshio, nibabel and FEniCS write. scripts/test.sh reads only those of VTK.
check_formats() {
  scripts/install_dependencies.sh gmsh lib3mf-dev libgmsh-dev libvtk9-dev python3-dolfinx python3-meshio \
    python3-nibabel python3-pytest
  cmake -S . -B "$work/formats" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDSC_BUILD_TESTS=OFF \
    -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF -DDSC_BUILD_PYTHON=OFF
  cmake --build "$work/formats" --parallel "$jobs" --target dsc dsc-full dsc-files
  DSC_PROGRAM=$(realpath "$work/formats/dsc") /usr/bin/python3 -m pytest -rs -p no:cacheprovider test/files
}

# Solves fluids with PETSc in several processes. scripts/test.sh builds without PETSc.
check_petsc() {
  scripts/install_dependencies.sh petsc-dev libopenmpi-dev openmpi-bin pkg-config
  cmake -S . -B "$work/petsc" -G Ninja -DCMAKE_BUILD_TYPE=Release -DDSC_WITH_PETSC=ON \
    -DDSC_BUILD_EXAMPLES=OFF -DDSC_BUILD_BENCHMARKS=OFF -DDSC_BUILD_PYTHON=OFF
  cmake --build "$work/petsc" --parallel "$jobs" --target dsc dsc-fluid dsc-fluid-petsc test_petsc \
    test_petsc_program
  ctest --test-dir "$work/petsc" --output-on-failure --no-tests=error --tests-regex '^test_petsc'
}

# Tests the kernel with libc++, with C++20, and on Windows.
check_toolchains() {
  scripts/check_toolchains.sh
}

check_packages() {
  scripts/make_packages.sh
  tar --extract --gzip --file /usr/share/doc/libcgal-dev/data.tar.gz --directory build/packages \
    --strip-components=2 data/meshes/bunny00.off
  scripts/in_debian.sh bookworm "$work/bare" scripts/check_packages.sh build/packages/bunny00.off
}

check_debian_13() {
  scripts/in_debian.sh trixie "$work/debian-13" bash -c 'scripts/main_job.sh && scripts/test.sh && scripts/check_pip.sh'
}

failed=0
for part in "${parts[@]}"; do
  SECONDS=0
  log=$work/$part.log
  # Runs in a subshell: `set -e` has no effect in a function whose status is tested.
  set +e
  (set -e; "check_$part") >"$log" 2>&1
  status=$?
  set -e
  outcome=$(grep --only-matching --extended-regexp \
    '^skipped: .*|^packages: .*|[0-9]+ passed.*|[0-9]+ headers compile alone|PASSED  \] [0-9]+ tests|tests passed.* out of [0-9]+|^Every state was valid' \
    "$log" | tail -n 1 || true)
  if [ $status -ne 0 ]; then
    outcome="FAILED, see $log"
    failed=1
  fi
  echo "$part: $SECONDS s, $outcome"
done
exit $failed
