#!/usr/bin/env bash
# Makes the pictures that scenes/vase/textured*.pbrt show, the same bytes on every machine; takes some seconds.
# Usage: make_textures.sh [FOLDER] [--scale S] [--only NAME]; without FOLDER they go beside their scripts.
set -euo pipefail
exec python3 "$(dirname "$0")/../scenes/vase/textures/make.py" "$@"
