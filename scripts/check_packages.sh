#!/usr/bin/env bash
# Installs the packages of scripts/make_packages.sh in this system, and runs the main job with them.
# scripts/check_more.sh calls it in a new, minimal Debian system.
# Usage: scripts/check_packages.sh SURFACE
set -euo pipefail
surface=$(realpath "${1:?a closed surface}")
cd "$(dirname "$0")/.."
export DEBIAN_FRONTEND=noninteractive
apt-get update --quiet >/dev/null
SECONDS=0
apt-get install --yes --quiet --no-install-recommends ./build/packages/deformable-simplicial-complex_*.deb >/dev/null
installed=$SECONDS
apt-get install --yes --quiet --no-install-recommends ./build/packages/python3-deformable-simplicial-complex_*.deb >/dev/null
work=$(mktemp -d)
cd "$work"
SECONDS=0
dsc offset "$surface" --triangles 14000 --distance 0.25e --steps 10 --output run --quiet
dsc offset --resume run/checkpoint.dsc --distance=-0.25e --steps 10 --output run --quiet
dsc view run -o bunny.html
ran=$SECONDS
test -s bunny.html
python3 -c '
import dsc, numpy as np
c = dsc.Complex3.from_function(lambda p: (np.linalg.norm(p, axis=1) < .5).astype(int),
                               box=[(-1, -1, -1), (1, 1, 1)], edge=.2)
assert c.offset(.02).complete and c.is_valid()'
apt-get install --yes --quiet --no-install-recommends python3-pytest >/dev/null
python3 -m pytest -q -p no:cacheprovider "$OLDPWD/test/python/test_tori.py"
apt-get install --yes --quiet --no-install-recommends "$OLDPWD"/build/packages/deformable-simplicial-complex-files_*.deb >/dev/null
dsc convert run/volume_000020.vtu last.vtk && dsc info last.vtk >/dev/null
echo "packages: installed in $installed s, main job in $ran s"
