#!/usr/bin/env python3
"""Peak memory of loading a large PLY beside what Embree itself needs for the same triangles.

Makes a binary PLY of ten million triangles in a temporary folder, loads it by `vitrine info`, and builds the same mesh
with nothing but Embree (bench_embree_alone; same flags and build quality). Exits with 1 when we take more than --bar
times as much.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

SCENE = """LookAt 0 -3 2  0 0 0  0 0 1
Camera "perspective"
Film "rgb" "integer xresolution" [ 64 ] "integer yresolution" [ 64 ] "string filename" "hills.exr"
WorldBegin
LightSource "infinite"
Shape "plymesh" "string filename" "hills.ply"
"""


def run(command):
    """(standard output, peak resident bytes, seconds) of a program."""
    start = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(command)} failed")
    return output, usage.ru_maxrss * 1024, time.perf_counter() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build/release"), help="folder of the programs")
    parser.add_argument("--side", type=int, default=2237, help="cells a side; triangles are twice its square")
    parser.add_argument("--bar", type=float, default=2)
    parser.add_argument("--json", help="write all figures to this file")
    args = parser.parse_args()
    alone, vitrine = (os.path.join(args.build, name) for name in ("bench_embree_alone", "vitrine"))

    with tempfile.TemporaryDirectory() as folder:
        ply, scene = os.path.join(folder, "hills.ply"), os.path.join(folder, "hills.pbrt")
        run([alone, str(args.side), "--write", ply])
        with open(scene, "w") as file:
            file.write(SCENE)
        output, peak, seconds = run([vitrine, "info", scene, "--json"])
        info = json.loads(output)
        output, alone_peak, alone_seconds = run([alone, str(args.side)])
        embree = json.loads(output)
    if info["primitives"] != embree["triangles"]:
        sys.exit(f"{info['primitives']} primitives were loaded, not {embree['triangles']}")

    figures = {"triangles": embree["triangles"], "peakBytes": peak, "seconds": seconds,
               "casterBytes": info["casterBytes"], "ratio": peak / alone_peak,
               "embreeAlone": dict(embree, peakMemoryBytes=alone_peak, seconds=alone_seconds)}
    print(f"{embree['triangles']} triangles")
    print(f"vitrine info    peak {peak / 1e6:7.0f} MB, {seconds:.1f} s")
    own, building, buffers = (embree[key] / 1e6 for key in ("embreeBytes", "embreePeakBytes", "bufferBytes"))
    print(f"Embree alone    peak {alone_peak / 1e6:7.0f} MB, {alone_seconds:.1f} s: {buffers:.0f} MB of vertices and "
          f"indices, {own:.0f} MB Embree's own, {building:.0f} MB while it builds")
    print(f"ratio           {figures['ratio']:.2f} (bar: {args.bar:g})")
    if args.json:
        with open(args.json, "w") as file:
            json.dump(figures, file, indent=2)
    if figures["ratio"] > args.bar:
        sys.exit("More memory than the bar allows.")


if __name__ == "__main__":
    main()
