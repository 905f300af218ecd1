#!/usr/bin/env bash
# Compiles headers of the package alone, without making code: each includes what it needs.
# Usage: test/headers_alone.sh NAMES JOBS COMPILER FLAGS...
# NAMES is a pattern, '*.h' for all.
set -euo pipefail
names=$1 jobs=$2
shift 2
cd "$(dirname "$0")/../include"
# What has no guard is a part of another header.
mapfile -t headers < <(grep --recursive --files-with-matches --include="$names" \
  '^#ifndef CGAL_.*_H$' CGAL | sort)
[ ${#headers[@]} -gt 0 ] || { echo "no header is called $names"; exit 1; }

compile_alone() {
  # Included by a file, as compilers warn of headers that are the main file.
  echo "#include <$1>" | "${@:2}" -I. -fsyntax-only -x c++ - || { echo "not alone: $1"; return 1; }
}
export -f compile_alone
printf '%s\n' "${headers[@]}" |
  xargs -P "$jobs" -I '{}' bash -c 'compile_alone "$@"' _ '{}' "$@" ||
  { echo "not all of ${#headers[@]} headers compile alone"; exit 1; }
echo "${#headers[@]} headers compile alone"
