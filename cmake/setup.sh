#!/bin/sh
# Makes this machine ready to build Lixel: installs the Debian packages of cmake/packages.txt that
# are missing, and configures build/. Does nothing where all of this is done already.
#
#     sh cmake/setup.sh
#
# demo.sh and test.sh begin with it. Packages are installed as root, or with sudo where it asks for
# no password; otherwise the command to run is printed.
set -eu
cd "$(dirname "$0")/.."

say() { printf '== %s\n' "$*"; }
fail() {
    printf '%s\n' "$@" >&2
    exit 1
}

command -v dpkg-query >/dev/null || fail \
    "This script knows Debian 12 only. Elsewhere install what cmake/packages.txt lists, and build:" \
    "    cmake -S . -B build -G Ninja && cmake --build build"

wanted=$(sed 's/#.*//' cmake/packages.txt)
# Fails where it does not know a package: that one is missing, too.
# shellcheck disable=SC2086
installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null || true)
missing=
for package in $wanted; do
    printf '%s\n' "$installed" | grep -qxF "$package installed" || missing="$missing $package"
done

if [ -n "$missing" ]; then
    install="apt-get install -y --no-install-recommends$missing"
    if [ "$(id -u)" = 0 ]; then
        root=
    elif sudo -n true 2>/dev/null; then
        root="sudo -n"
    else
        fail "Packages are missing. Install them with this line, then run this script again:" \
            "    sudo apt-get update && sudo $install"
    fi
    say "Installing missing packages:$missing"
    $root apt-get -q update
    # Through env, because sudo drops the environment.
    # shellcheck disable=SC2086
    $root env DEBIAN_FRONTEND=noninteractive $install -q -o DPkg::Lock::Timeout=120
fi

if [ ! -f build/build.ninja ]; then
    say "Configuring build/"
    # Files are compiled in batches: from nothing that takes a third of the time.
    cmake -S . -B build -G Ninja -DCMAKE_UNITY_BUILD=ON
fi
