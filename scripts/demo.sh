#!/usr/bin/env bash
# From a bare Debian 12 and this checkout to a picture: sets up, builds, renders scenes/vase/vase.pbrt.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh vitrine
mkdir -p out
build/release/vitrine render scenes/vase/vase.pbrt -o out/vase.exr -o out/vase.png --progress bar
echo "Done: $PWD/out/vase.png (to look at) and $PWD/out/vase.exr (linear, float)"
