#!/usr/bin/env bash
# Offsets the Stanford bunny outwards by ten steps and back by ten steps, and renders pictures and a page
# for a browser.
# Usage: scripts/main_job.sh [OUTPUT_DIR]
set -euo pipefail
output=$(realpath --canonicalize-missing "${1:-build/bunny}")
cd "$(dirname "$0")/.."
jobs=$(nproc)

scripts/install_dependencies.sh

cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build build --parallel "$jobs" --target dsc

mkdir -p build/data "$output"
# The program ends with an error if the folder contains a run. In the default folder, the checkpoint of
# an earlier run is removed.
[ $# -gt 0 ] || rm -f "$output/checkpoint.dsc"
tar --extract --gzip --file /usr/share/doc/libcgal-dev/data.tar.gz --directory build/data \
  --strip-components=2 data/meshes/bunny00.off

build/dsc offset build/data/bunny00.off --triangles 14000 --distance 0.25e --steps 10 \
  --threads "$jobs" --output "$output" --report "$output/out.json"
build/dsc offset --resume "$output/checkpoint.dsc" --distance=-0.25e --steps 10 \
  --threads "$jobs" --output "$output" --report "$output/back.json"

build/dsc view "$output" -o "$output/bunny.html"
xvfb-run -a /usr/bin/python3 scripts/render.py "$output"
echo "Pictures in $output:"
find "$output" -name '*.png' | sort
