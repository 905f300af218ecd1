#!/usr/bin/env bash
# Installs the Debian 12 packages that the build needs, and further packages that are given. Does
# nothing if all of them are installed.
# Usage: scripts/install_dependencies.sh [PACKAGE...]
set -euo pipefail

packages=(
  g++ cmake ninja-build
  libcgal-dev libcgal-demo libeigen3-dev libboost-dev libtbb-dev libtet1.5-dev
  libcli11-dev nlohmann-json3-dev libmuparser-dev libpng-dev zlib1g-dev
  libgtest-dev libbenchmark-dev
  python3-vtk9 xvfb xauth libgl1-mesa-dri
  "$@"
)

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() {
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends "$@"
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

# Fetches the package lists only if the installation fails, because they may be absent or too old.
if ! install_packages "${missing[@]}"; then
  as_root apt-get update --quiet
  install_packages "${missing[@]}"
fi
