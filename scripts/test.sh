#!/usr/bin/env bash
# Sets up as demo.sh does, builds everything, runs every test.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh all
ctest --preset release -j "$(nproc)" "$@"
