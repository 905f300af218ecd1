#!/usr/bin/env bash
# Installs the Python module by pip into this system, and uses it. scripts/check_more.sh calls it in a new
# Debian 13; Debian 12 has no scikit-build-core.
# Usage: scripts/check_pip.sh
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_dependencies.sh pybind11-dev python3-dev python3-numpy python3-pip python3-scikit-build-core
/usr/bin/python3 -m pip install --no-build-isolation --no-deps --break-system-packages .
cd /
/usr/bin/python3 -c '
import dsc, numpy as np
c = dsc.Complex3.from_function(lambda p: (np.linalg.norm(p, axis=1) < .5).astype(int),
                               box=[(-1, -1, -1), (1, 1, 1)], edge=.2)
assert c.offset(.02).complete and c.is_valid()
print("pip: the module works,", c)'
