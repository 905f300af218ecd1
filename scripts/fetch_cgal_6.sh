#!/usr/bin/env bash
# Unpacks the headers of CGAL 6 from a later release of Debian into a folder. Installs nothing.
# Usage: scripts/fetch_cgal_6.sh OUTPUT_DIR
# If they are not available, prints a line that begins with "skipped" and does not create the folder.
set -euo pipefail
suite=trixie
output=$(realpath --canonicalize-missing "${1:?the folder to unpack into}")
[ ! -e "$output/usr/include/CGAL/version.h" ] || exit 0

skip() {
  echo "skipped: $1"
  exit 0
}

# The mirror from which this system installs packages; the packages are signed by Debian
command -v apt-get dpkg-deb >/dev/null || skip "no Debian packages here"
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
[ -r "$keyring" ] || skip "the keyring of Debian is not installed"
mirror=$("$(dirname "$0")/debian_mirror.sh") || skip "no mirror of Debian among the sources of apt"

# Separate folders for apt; only its settings are shared with the system
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"/{state/lists/partial,cache/archives/partial,etc,unpacked}
echo "deb [signed-by=$keyring] $mirror $suite main" >"$work/etc/sources.list"
apt=(apt-get --quiet
  -o "Dir::State=$work/state" -o "Dir::State::status=$work/status" -o "Dir::Cache=$work/cache"
  -o "Dir::Etc::sourcelist=$work/etc/sources.list" -o Dir::Etc::sourceparts=-
  -o Dir::Etc::preferencesparts=- -o APT::Sandbox::User=root)
touch "$work/status"
cd "$work"
"${apt[@]}" update --error-on=any >log 2>&1 ||
  skip "the lists of $suite cannot be read: $(grep -m 1 '^[EW]:' log)"
"${apt[@]}" download libcgal-dev >log 2>&1 ||
  skip "the package cannot be read: $(grep -m 1 '^[EW]:' log)"
dpkg-deb --extract libcgal-dev_*.deb unpacked
mkdir -p "$(dirname "$output")"
rm -rf "$output"
mv unpacked "$output"
