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
    sudo=()
    if [ "$(id -u)" -ne 0 ]; then
        sudo=(sudo)
        command -v sudo >/dev/null || { echo "Installing packages needs root or sudo. Missing: ${missing[*]}" >&2; exit 1; }
        sudo -v
    fi
    mkdir -p build
    echo "Installing packages, which takes some minutes (log: build/packages.log): ${missing[*]}"
    if ! { "${sudo[@]}" apt-get update -q &&
        "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"; } \
        </dev/null >build/packages.log 2>&1; then
        tail -n 20 build/packages.log >&2
        echo "The packages could not be installed: see build/packages.log" >&2
        exit 1
    fi
fi

# The default instruction set needs AVX2 (any PC processor since 2015); others get the baseline.
arch=x86-64-v3
grep -qw avx2 /proc/cpuinfo || arch=x86-64
echo "Building"
cmake --preset release -DVITRINE_ARCH="$arch" --log-level=WARNING
cmake --build --preset release --target "$@"
