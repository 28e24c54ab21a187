#!/usr/bin/env bash
# Tries the Debian package where nothing else is: installs it in a bare Debian 12, runs the pendulum there as an ordinary
# user, builds the example against the package for programs, and removes both without a rest. Takes some minutes.
#   tests/package.sh build/deb
# Ends with 0 and its reason where it cannot be tried: not root, no debootstrap, no chroot, or no mirror.
set -euo pipefail
packages=$(cd "$1" && pwd)
example=$(cd "$(dirname "$0")/installed" && pwd)
mirror=${PLUMB_MIRROR:-$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources} 2>/dev/null |
  awk '/^(deb|URIs:) / { for (i = 2; i <= NF; ++i) if ($i ~ /^http/) { print $i; exit } }' || true)}

skip() {
  echo "package: skipped: $1"
  exit 0
}
[ "$(id -u)" -eq 0 ] || skip "only root may make a chroot"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"

root=$(mktemp -d)
chmod 755 "$root"
finish() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$root" "$root".{log,before,after}
}
trap finish EXIT
echo "package: a bare Debian 12 from $mirror"
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 ||
  skip "debootstrap: $(tail -n 1 "$root.log")"
chroot "$root" true 2>/dev/null || skip "chroot is not allowed here"
mount -t proc proc "$root/proc" 2>/dev/null || skip "proc cannot be mounted here"
in_root() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
# Proxies and mirrors that this machine has set up for apt serve there too.
cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
files() { in_root find / -xdev \( -path /proc -o -path /home -o -path /var -o -path /tmp \) -prune -o -print | sort; }

mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
in_root apt-get update -q >"$root.log"
in_root useradd --create-home engineer
files >"$root.before"

echo "package: installing plumb"
in_root sh -c 'apt-get install -q -y --no-install-recommends /packages/plumb_*.deb' >"$root.log" 2>&1 || {
  tail "$root.log"
  exit 1
}
in_root su engineer -c 'cd && plumb run pendulum && test -s output/pendulum/index.html && plumb doctor >doctor.txt'
in_root apt-get purge -q -y plumb >"$root.log"
in_root apt-get autoremove -q -y --purge >"$root.log"
files >"$root.after"
if rest=$(comm -13 "$root.before" "$root.after" | grep -i plumb); then
  echo "package: left behind: $rest"
  exit 1
fi

echo "package: building the example against libplumb-dev"
in_root sh -c 'apt-get install -q -y --no-install-recommends /packages/libplumb-dev_*.deb cmake g++ ninja-build' >"$root.log" 2>&1 || {
  tail "$root.log"
  exit 1
}
cp -r "$example" "$root/home/engineer/example"
in_root sh -c 'cmake -G Ninja -S /home/engineer/example -B /tmp/example >/tmp/log && cmake --build /tmp/example >>/tmp/log &&
  /tmp/example/hanging_cable || { cat /tmp/log; exit 1; }'
in_root apt-get purge -q -y libplumb-dev >"$root.log"
echo "package: installed, run, removed"
