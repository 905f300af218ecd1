#!/usr/bin/env bash
# Runs the scenes of `dsc fluid` that the manual shows and renders their pictures:
# doc/Incompressible_fluids_3/fig/fluid_NAME.png. Uses the program BUILD_DIR/dsc and the folder
# BUILD_DIR/fluids. Takes a quarter of an hour and 1.2 GB of disk space.
# Usage: scripts/render_fluids.sh [BUILD_DIR]
. "$(dirname "$0")/figures.sh"
figures=$source/doc/Incompressible_fluids_3/fig

check_needs() {
  require "$build/dsc"
  require_data
  command -v povray >/dev/null ||
    fail "povray is missing; run scripts/install_dependencies.sh povray python3-numpy"
  "$python" -c 'import numpy' 2>/dev/null ||
    fail "NumPy is missing; run scripts/install_dependencies.sh povray python3-numpy"
}

fluid() { # NAME END EVERY OPTION_OF_RENDER_SCENE...
  echo "dsc fluid $1 --end $2"
  "$build/dsc" fluid "$1" --end "$2" --every "$3" --subdivide 1 --quiet --output "$1"
  "$python" "$source/scripts/render_scene.py" "$1" "$figures/fluid_$1.png" "${@:4}"
}

check_needs
begin_in "$build/fluids"
tar --extract --gzip --file "$data" --strip-components=2 data/meshes/bunny00.off

fluid bunny 10 10 --up y --times 0,0.05,0.15,10
fluid collision 1.5 5 --up y --eye 0.3,-1,0.3 --times 0,0.45,0.9,1.5
fluid jet 18 5 --eye 0.1,-1,0.3 --times 0,12,15,18
