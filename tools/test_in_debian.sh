#!/usr/bin/env bash
# Shows that ./demo and ./test work from nothing: makes a bare Debian 12 in a folder, clones this repository
# into it and runs both inside. Run by hand, as root, with debootstrap installed:
#   tools/test_in_debian.sh FOLDER [MIRROR]     FOLDER must not exist; MIRROR: default, this machine's
set -euo pipefail
root=${1:?usage: tools/test_in_debian.sh FOLDER [MIRROR]}
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck disable=SC2016
mirror=${2:-$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 2>/dev/null | grep -m1 '/debian$' || true)}

[[ $(id -u) -eq 0 ]] || { echo "must be root (chroot)" >&2; exit 1; }
[[ ! -e $root ]] || { echo "$root exists already" >&2; exit 1; }
[[ -n $mirror ]] || { echo "no mirror found in apt's sources; give one" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "debootstrap is missing" >&2; exit 1; }

unmount() { for place in dev/pts dev proc; do mountpoint -q "$root/$place" && umount "$root/$place"; done; true; }
trap unmount EXIT

began=$SECONDS
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { tail "$root.log" >&2; exit 1; }
# How this machine reaches its mirror (proxies, certificates' absence) holds inside as well.
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
echo "deb $mirror bookworm main" >"$root/etc/apt/sources.list"
mount --bind /proc "$root/proc"
mount --bind /dev "$root/dev"
mount --bind /dev/pts "$root/dev/pts"
git clone --quiet --no-local "$repository" "$root/photic"
printf 'bare Debian 12 and a clone of %s: %d s\n' "$(git -C "$repository" log -1 --format=%h)" $((SECONDS - began))

# run NAME: runs ./NAME inside, with a bare environment; its output stays in FOLDER/NAME.log.
run() {
  local name=$1 start=$SECONDS code=0
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    "/photic/$name" >"$root/$name.log" 2>&1 <&- || code=$?
  tail -n 12 "$root/$name.log"
  printf -- '-- ./%s: exit code %d, %d s (log: %s)\n' "$name" "$code" $((SECONDS - start)) "$root/$name.log"
  return $code
}
code=0
run demo || code=1
[[ -s $root/photic/out/ship.nc && -s $root/photic/out/ship.png ]] || { echo "out/ship.nc or out/ship.png is missing" >&2; code=1; }
run test || code=1
exit $code
