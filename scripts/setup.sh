#!/usr/bin/env bash
# Installs the packages of packages.txt that are missing (Debian 12) and builds the release preset.
# Called by demo.sh and test.sh; usage: setup.sh TARGET...
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t packages < <(grep -vE '^[[:space:]]*(#|$)' scripts/packages.txt)
missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if [ "${#missing[@]}" -gt 0 ]; then
    echo "Installing: ${missing[*]}"
    sudo=
    [ "$(id -u)" -eq 0 ] || sudo=sudo
    $sudo apt-get update -q
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
fi

# The default instruction set needs AVX2 (any PC processor since 2015); others get the baseline.
arch=x86-64-v3
grep -qw avx2 /proc/cpuinfo || arch=x86-64
cmake --preset release -DVITRINE_ARCH="$arch" --log-level=WARNING
cmake --build --preset release --target "$@"
