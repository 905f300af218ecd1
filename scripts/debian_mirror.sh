#!/usr/bin/env bash
# Prints the mirror of Debian from which this system installs packages. Ends with an error if there is none.
# Usage: scripts/debian_mirror.sh
set -euo pipefail
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
  awk -v release="$release" '$2 == release && !found { print $1; found = 1 } END { exit !found }'
