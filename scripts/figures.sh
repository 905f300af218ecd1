# Folders and functions of the scripts that draw the figures of the manuals. These scripts source this file.
# Their first argument is the build folder.
set -euo pipefail
source=$(realpath "$(dirname "$0")/..")
build=$(realpath --canonicalize-missing "${1:-$source/build}")
data=/usr/share/doc/libcgal-dev/data.tar.gz
python=/usr/bin/python3
display=()
[ -n "${DISPLAY:-}" ] || display=(xvfb-run -a)

fail() { # MESSAGE
  echo "$(basename "$0"): $1" >&2
  exit 1
}

require() { # PROGRAM...
  local program
  for program in "$@"; do
    [ -x "$program" ] || fail "$program is missing; build the project, or give its build folder"
  done
}

require_data() {
  [ -f "$data" ] || fail "$data is missing; run scripts/install_dependencies.sh"
}

begin_in() { # FOLDER: empties the folder and makes it the working directory
  rm -rf "$1"
  mkdir -p "$1"
  cd "$1"
}

begin_in_temporary_folder() {
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  cd "$work"
}

run() { # NAME COMMAND ARGUMENT...
  echo "dsc ${*:2}"
  "$build/dsc" "${@:2}" --quiet --output "$1"
}
