#!/usr/bin/env bash
# Draws the pictures of solids that share walls or overlap, and of an open sheet: doc/PACKAGE/fig/solids_NAME.png.
# Needs the targets dsc, dsc-full and dsc-reconstruct in BUILD_DIR.
# Usage: scripts/draw_solids.sh [BUILD_DIR]
. "$(dirname "$0")/figures.sh"
doc=$source/doc

"$source/scripts/install_dependencies.sh" python3-numpy
require "$build"/{dsc,dsc-full,dsc-reconstruct}
begin_in "$build/solids"
"$python" - "$source/benchmark" <<'INPUTS'
import sys

sys.path.insert(0, sys.argv[1])
import cad_solids
import numpy
import sheets
import walls


def write(name, solids):
    for i, solid in enumerate(solids):
        cad_solids.write_off(f"{name}_{i:02}.off", solid)


random = numpy.random.default_rng(1)
turn = numpy.eye(3)
boxes = [((0, 0, 0), (0.7, 1, 1), 3), ((0.7, 0, 0), (1.2, 1, 0.8), 5)]
write("walls", [cad_solids.divided_box(low, high, [n, n, n], random) for low, high, n in boxes])
plate = cad_solids.divided_box((-0.2, -0.2, 0), (4.4, 1.2, 0.3), [1, 1, 1], random)
letters = [cad_solids.moved(cad_solids.letter(name, 0.5), turn, (1.1 * i, 0, 0.15)) for i, name in enumerate("ABEO")]
ball = cad_solids.moved(cad_solids.ball(0.7, 12), turn, (2.1, 1.1, 0.3))
write("overlaps", [plate, *letters, ball])
write("foam", walls.foams(random, 20).solids())
numpy.savetxt("sheet.xyz", sheets.points_of("hole", 1600, 0, random))
INPUTS

render() { # NAME ARGUMENT...: renders the solids of the files NAME_*.off
  run "$1" rotate "$1"_*.off --axis 0,0,1 --angle 0
  "${display[@]}" "$python" "$source/scripts/render_grains.py" --solids "${@:2}" "$1/volume_000000.vtu" \
    "$doc/Triangle_soup_repair/fig/solids_$1.png"
}

mkdir -p "$doc/Triangle_soup_repair/fig"
render walls --distance 1.2 --eye 1 -1 0.5
render overlaps --distance 0.4 --eye 0.3 -1 1.3
render foam --distance 0.5
"$build/dsc" reconstruct --open sheet.xyz -o sheet.ply --quiet
"${display[@]}" "$python" "$source/scripts/render_sheet.py" sheet.ply \
  "$doc/Solid_reconstruction_3/fig/solids_sheet.png"
