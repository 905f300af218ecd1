#!/usr/bin/env bash
# Builds and runs the tests of the kernel with other compilers, standards and libraries:
#   libc++        Clang with the standard library of LLVM
#   gcc_20        GCC with C++20, and more warnings
#   clang_20      Clang with C++20, and more warnings
#   mingw         GCC for Windows (MinGW-w64); Wine runs the tests. CGAL uses the numbers of Boost, not GMP.
# Usage: scripts/check_toolchains.sh [libc++] [gcc_20] [clang_20] [mingw]
# Uses all toolchains by default. Prints a line for each; its full output is in build-more/toolchains/NAME.log.
set -euo pipefail
cd "$(dirname "$0")/.."
toolchains=("$@")
[ ${#toolchains[@]} -gt 0 ] || toolchains=(libc++ gcc_20 clang_20 mingw)
jobs=${DSC_JOBS:-$(nproc)}
work=$PWD/build-more/toolchains
mkdir -p "$work"

scripts/install_dependencies.sh googletest

# GoogleTest is built with the same library. Warnings of our headers are errors; other code may warn.
build_and_test() { # NAME OPTION...
  local name=$1 prefix=$work/$1-prefix
  shift
  local options=(-G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1 "$@")
  cmake -S /usr/src/googletest -B "$work/$name-googletest" -DBUILD_GMOCK=OFF \
    -DCMAKE_INSTALL_PREFIX="$prefix" "${options[@]}"
  cmake --build "$work/$name-googletest" --parallel "$jobs" --target install
  cmake -S . -B "$work/$name" -DGTest_DIR="$prefix/lib/cmake/GTest" -DDSC_WITH_TBB=OFF -DDSC_WITH_TETGEN=OFF \
    -DDSC_BUILD_COMPILED=OFF -DDSC_BUILD_PROGRAM=OFF -DDSC_BUILD_PYTHON=OFF -DDSC_BUILD_EXAMPLES=OFF \
    -DDSC_BUILD_BENCHMARKS=OFF "${options[@]}"
  cmake --build "$work/$name" --parallel "$jobs" --target "${programs[@]}" | tee "$work/$name-build.log"
  if grep 'include/CGAL/.* warning: ' "$work/$name-build.log" | grep --invert-match '/usr/include/' | sort -u; then
    echo "headers have warnings"
    return 1
  fi
  ctest --test-dir "$work/$name" --output-on-failure --no-tests=error --parallel "$jobs" \
    --tests-regex "^($(IFS='|'; echo "${programs[*]}"))(\.|$)" --exclude-regex "$left_out"
}

left_out='^$' # regular expression of tests

# The programs with the tests of the kernel: one for each folder and each other file, and those in the form of CGAL.
programs=()
for path in test/Deformable_simplicial_complexes/{*.cpp,*/}; do
  name=$(basename "$path" .cpp)
  [ "$name" = cgal ] || programs+=("test_${name#test_}")
done
for path in test/Deformable_simplicial_complexes/cgal/*.cpp; do
  programs+=("cgal_$(basename "$path" .cpp)")
done

check_libc++() {
  scripts/install_dependencies.sh clang libc++-dev libc++abi-dev
  build_and_test libc++ -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS=-stdlib=libc++ -DCGAL_DISABLE_GMP=ON
}

# -Wconversion of Clang also warns of indices of type int, that of GCC does not.
more_warnings="-Wconversion -Wno-sign-conversion -Wshadow -Wpedantic"

check_gcc_20() {
  build_and_test gcc_20 -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_STANDARD=20 -DCMAKE_CXX_FLAGS="$more_warnings"
}

check_clang_20() {
  scripts/install_dependencies.sh clang
  build_and_test clang_20 -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_STANDARD=20 -DCMAKE_CXX_FLAGS="$more_warnings"
}

check_mingw() {
  scripts/install_dependencies.sh g++-mingw-w64-x86-64-posix wine wine64
  # The headers of CGAL, Boost and Eigen without those of Linux.
  local root=$work/mingw-prefix
  mkdir -p "$root/include" "$root/lib/cmake" "$root/share/eigen3"
  ln -sfn -t "$root/include" /usr/include/{CGAL,boost,eigen3}
  ln -sfn -t "$root/lib/cmake" /usr/lib/*/cmake/CGAL
  ln -sfn -t "$root/share/eigen3" /usr/share/eigen3/cmake
  # Programs in which threads with thread_local vectors end crash (https://gcc.gnu.org/bugzilla/show_bug.cgi?id=80816).
  local left_out='^test_threads\.Threads\.(queries_of_one_complex|whole_flows_with_threads_of_their_own)$'
  export WINEPREFIX=$work/wine WINEDEBUG=-all
  build_and_test mingw -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/mingw-w64.cmake" -DCMAKE_FIND_ROOT_PATH="$root" \
    -DCGAL_DISABLE_GMP=ON
}

failed=0
for toolchain in "${toolchains[@]}"; do
  SECONDS=0
  log=$work/$toolchain.log
  # Runs in a subshell: `set -e` has no effect in a function whose status is tested.
  set +e
  (set -e; "check_$toolchain") >"$log" 2>&1
  status=$?
  set -e
  outcome=$(grep --extended-regexp 'tests passed.* out of [0-9]+' "$log" | tail -n 1 || true)
  if [ $status -ne 0 ]; then
    outcome="FAILED, see $log${outcome:+ ($outcome)}"
    failed=1
  fi
  echo "$toolchain: $SECONDS s, $outcome"
done
exit $failed
