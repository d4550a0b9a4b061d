#!/usr/bin/env python3
"""Makes the pictures of scenes/vase/textured.pbrt: the same bytes on every machine.

Usage: make.py [FOLDER] [--scale S] [--only NAME]    writes PNG files into FOLDER (by default beside this file); S times
the usual number of pixels each way.
"""
import argparse
import importlib
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from drawing import write_png

PICTURES = ("landscape", "porcelain", "star_tile", "wood", "rainbow")


def main():
    parser = argparse.ArgumentParser(description="Makes the pictures of scenes/vase/textured.pbrt.")
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).resolve().parent)
    parser.add_argument("--scale", type=float, default=1.0, help="pixels each way, against the usual number")
    parser.add_argument("--only", choices=PICTURES, help="make only this one")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name in [arguments.only] if arguments.only else PICTURES:
        for file, pixels in importlib.import_module(name).make(arguments.scale).items():
            write_png(arguments.folder / file, pixels)
            print(arguments.folder / file)


if __name__ == "__main__":
    main()
