#!/usr/bin/env bash
# Checks the rooms of the package: no file includes one of a room above its own, nor a facade, and no
# room has more than 2 000 lines. The order of the list tells what is above what.
# Usage: test/rooms.sh INCLUDE_DIR
set -euo pipefail
cd "$1/CGAL"

rooms=(accounts complex traversal geometry interface operations parameters topology motion improvement
  remeshing deformation soups building octrees images repair conversion clouds reconstruction geodesics values solvers flow fluids text
  grids curves IO)
maximum_lines=2000

rank_of() { # ROOM
  local i
  for i in "${!rooms[@]}"; do
    [ "${rooms[$i]}" != "$1" ] || { echo "$i"; return; }
  done
  echo "there is a room that this list does not know: $1" >&2
  exit 1
}

failures=0
declare -A lines
while read -r file; do
  room=$(basename "$(dirname "$file")")
  if [ "$room" = internal ]; then
    echo "$file is in no room"
    failures=$((failures + 1))
    continue
  fi
  rank=$(rank_of "$room")
  lines[$room]=$((${lines[$room]:-0} + $(wc -l <"$file")))
  while read -r included; do
    if [ "$(rank_of "$(basename "$(dirname "$included")")")" -gt "$rank" ]; then
      echo "$file, in the room $room, includes $included above it"
      failures=$((failures + 1))
    fi
  done < <(sed -n 's|^#include <CGAL/\(.*/internal/.*\.h\)>|\1|p' "$file")
  # Facades: functions that users call.
  while read -r included; do
    if [ -e "$included" ]; then
      echo "$file includes the facade $included above it"
      failures=$((failures + 1))
    fi
  done < <(sed -n 's|^#include <CGAL/\([a-z][^/]*\.h\)>|\1|p' "$file")
done < <(find . -path '*/internal/*' -name '*.h' | sort)

for room in "${!lines[@]}"; do
  if [ "${lines[$room]}" -gt "$maximum_lines" ]; then
    echo "the room $room has ${lines[$room]} lines, more than $maximum_lines"
    failures=$((failures + 1))
  fi
done
[ "$failures" -eq 0 ]
