#!/bin/sh
# Runs bootstrap.sh in a bare Debian of another release, as root:
#   sh tests/platforms.sh [SUITE [COMMAND]]
# SUITE is a Debian release (trixie), COMMAND a command of bootstrap.sh (test). The last commit is
# tested. debootstrap installs the root folder build-platforms/SUITE, which is kept for incremental
# builds. Only apt uses the network, with the Debian mirror of this system unless LAVER_MIRROR names
# another.
set -eu

suite=${1:-trixie}
command=${2:-test}
tree=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
root=${LAVER_PLATFORMS:-$tree/build-platforms}/$suite

fail() {
  echo "platforms.sh: $1" >&2
  exit 1
}

mirrorOfApt() {
  # shellcheck disable=SC2016 # apt replaces the variable
  apt-get indextargets --format '$(REPO_URI)' 'Identifier: Packages' 'Origin: Debian' \
    'Label: Debian' | sort -u | head -n 1
}

# An incomplete root has no mark and is installed again.
makeRoot() {
  [ ! -e "$root/platform-ready" ] || return 0
  command -v debootstrap >/dev/null || fail 'the package debootstrap is missing'
  mirror=${LAVER_MIRROR:-$(mirrorOfApt)}
  [ -n "$mirror" ] || fail 'apt has no Debian mirror here; set LAVER_MIRROR'
  rm -rf --one-file-system "$root"
  mkdir -p "$root"
  debootstrap --variant=minbase "$suite" "$root" "$mirror"
  touch "$root/platform-ready"
}

# Unchanged files keep their times, so that they are not compiled again.
copyTree() {
  copy=$root/laver
  [ -d "$copy/.git" ] || git init -q "$copy"
  git -C "$copy" fetch -q --no-tags "$tree" HEAD
  git -C "$copy" reset -q --hard FETCH_HEAD
  git -C "$copy" log -1 --format="Debian $suite: bootstrap.sh $command of %h, %s"
}

# /dev and /proc are mounted in a separate namespace, which ends with the command.
runBootstrap() {
  # shellcheck disable=SC2016 # for the inner shell
  unshare --mount sh -eu -c '
    mount --rbind /dev "$1/dev"
    mount -t proc proc "$1/proc"
    cp /etc/resolv.conf "$1/etc/resolv.conf"
    exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
      sh /laver/cmake/bootstrap.sh "$2"' sh "$root" "$command"
}

[ "$(id -u)" -eq 0 ] || fail 'run as root: debootstrap and chroot need it'
makeRoot
copyTree
runBootstrap
