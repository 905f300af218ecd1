#!/usr/bin/env bash
# Checks that each header of the package compiles alone, without code generation.
# Usage: test/headers_alone.sh NAMES JOBS COMPILER FLAGS...
# NAMES is a pattern of file names, for example '*.h' for all headers.
set -euo pipefail
names=$1 jobs=$2
shift 2
cd "$(dirname "$0")/../include"
# A header without include guard is a part of another header.
mapfile -t headers < <(grep --recursive --files-with-matches --include="$names" \
  '^#ifndef CGAL_.*_H$' CGAL | sort)
[ ${#headers[@]} -gt 0 ] || { echo "no header is called $names"; exit 1; }

compile_alone() {
  # The header is included by a file, because compilers warn if a header is the main file.
  echo "#include <$1>" | "${@:2}" -I. -fsyntax-only -x c++ - || { echo "not alone: $1"; return 1; }
}
export -f compile_alone
printf '%s\n' "${headers[@]}" |
  xargs -P "$jobs" -I '{}' bash -c 'compile_alone "$@"' _ '{}' "$@" ||
  { echo "not all of ${#headers[@]} headers compile alone"; exit 1; }
echo "${#headers[@]} headers compile alone"
