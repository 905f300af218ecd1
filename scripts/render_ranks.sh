#!/usr/bin/env bash
# Makes the picture of a complex on four processes for the manual. Needs the program, built with
# -DDSC_WITH_MPI=ON in the folder build.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_dependencies.sh libopenmpi-dev openmpi-bin
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar --extract --gzip --file /usr/share/doc/libcgal-dev/data.tar.gz --directory "$work" \
  --strip-components=2 data/meshes/bunny00.off
options=()
[ "$(id -u)" -ne 0 ] || options+=(--allow-run-as-root)
mpirun --oversubscribe "${options[@]}" -n 4 build/dsc offset "$work/bunny00.off" --triangles 6000 \
  --distance 0.25e --steps 2 --output "$work/run"
xvfb-run -a /usr/bin/python3 scripts/render_ranks.py "$work/run/volume_000002.pvtu" \
  "$work/run/interface_000002.pvtu" doc/Deformable_simplicial_complexes/fig/distributed_bunny.png
