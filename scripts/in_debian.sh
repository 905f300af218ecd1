#!/usr/bin/env bash
# Runs a command in a new, minimal system of a release of Debian, in a copy of this repository.
# Usage: scripts/in_debian.sh SUITE FOLDER COMMAND [ARGUMENT...]
# Makes the system in FOLDER, which must not exist, from the mirror that this system uses, and removes it
# at the end. Files in build/packages are copied, too. If the system cannot be made, prints a line that
# begins with "skipped".
set -euo pipefail
suite=${1:?a release of Debian, such as trixie}
root=$(realpath --canonicalize-missing "${2:?a new folder}")
shift 2
cd "$(dirname "$0")/.."

skip() {
  echo "skipped: $1"
  exit 0
}

[ ! -e "$root" ] || { echo "$root exists already" >&2; exit 1; }
[ "$(id -u)" -eq 0 ] || skip "only root can change the root of the file system"
command -v apt-get >/dev/null || skip "no Debian packages here"
scripts/install_dependencies.sh debootstrap
mirror=$(scripts/debian_mirror.sh) || skip "no mirror of Debian among the sources of apt"

remove_system() {
  umount --recursive "$root/proc" "$root/dev" 2>/dev/null || true
  # Files of this system would be removed through a folder that is still mounted.
  ! grep --quiet " $root/" /proc/self/mounts || { echo "$root is still in use" >&2; return 1; }
  rm -rf "$root"
}

mkdir -p "$(dirname "$root")"
trap remove_system EXIT
if ! debootstrap --variant=minbase --include=ca-certificates "$suite" "$root" "$mirror" >"$root.log" 2>&1; then
  skip "debootstrap cannot make $suite: $(tail -n 1 "$root.log")"
fi
mount --bind /proc "$root/proc" && mount --rbind /dev "$root/dev" || skip "nothing can be mounted here"
mount --make-rslave "$root/dev"
cp /etc/resolv.conf "$root/etc/"

mkdir -p "$root/repository"
{
  git ls-files --cached --others --exclude-standard -z
  [ ! -d build/packages ] || find build/packages -type f -print0
} | tar --create --null --files-from=- | tar --extract --directory "$root/repository"
chroot "$root" /usr/bin/env --chdir=/repository HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
