#!/usr/bin/env bash
# Runs scenes of `dsc fluid`, in BUILD_DIR/fluids, and renders the manual's pictures of them anew, by
# ray tracing: doc/Deformable_simplicial_complex_3/fig/fluid_NAME.png. All take about an hour.
# Usage: scripts/render_fluids.sh BUILD_DIR [SCENE...]
set -euo pipefail
source=$(realpath "$(dirname "$0")/..")
[ $# -gt 0 ] || { echo "usage: render_fluids.sh BUILD_DIR [SCENE...]" >&2; exit 2; }
build=$(realpath --canonicalize-missing "$1")
shift
scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=(bunny collision bowl crown dam-break)
figures=$source/doc/Deformable_simplicial_complex_3/fig
data=/usr/share/doc/libcgal-dev/data.tar.gz

fail() { # MESSAGE
  echo "render_fluids.sh: $1" >&2
  exit 1
}

[ -x "$build/dsc" ] || fail "$build/dsc is missing; build the target dsc, or name its folder"
[ -f "$data" ] || fail "$data is missing; run scripts/install_dependencies.sh"
command -v povray >/dev/null || fail "povray is missing; run scripts/install_dependencies.sh povray python3-numpy"

mkdir -p "$build/fluids/data"
cd "$build/fluids"
tar --extract --gzip --file "$data" --directory data --strip-components=2 \
  data/meshes/bunny00.off data/meshes/armadillo.off
for scene in "${scenes[@]}"; do
  echo "dsc fluid $scene"
  rm -rf "$scene"
  "$build/dsc" fluid "$scene" --quiet --data data --output "$scene"
  "$source/scripts/render_scene.py" "$build/dsc" "$scene" "$figures/fluid_$scene.png"
done
