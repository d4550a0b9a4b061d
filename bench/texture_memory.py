#!/usr/bin/env python3
"""Peak memory of rendering an image texture of 16k x 16k texels within a texture cache of 512 MB.

Makes the image in a temporary folder (a PNG, the hardest case: it cannot be read by tiles), renders a scene whose photons and
eye paths look it up all over, and the same scene with an image of one texel. Also renders with other sizes of the cache
and numbers of threads: the pictures must be the same bytes. Exits with 1 when they are not, or when the large image takes
more than --bar times the cache's size on top of the small one's peak.
"""

import argparse
import json
import os
import random
import struct
import subprocess
import sys
import tempfile
import time
import zlib

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

SCENE = """LookAt 0 2.6 0.01  0 0 0  0 0 1
Camera "perspective" "float fov" 45
Film "rgb" "integer xresolution" [ 400 ] "integer yresolution" [ 400 ]
Sampler "zsobol" "integer pixelsamples" 2
Integrator "sppm" "integer maxdepth" 4 "integer photonsperiteration" 400000 "float radius" .01
WorldBegin
LightSource "point" "rgb I" [ 1 1 1 ] "point3 from" [ 0 1 0 ]
Texture "large" "spectrum" "imagemap" "string filename" "image.png" "string filter" "FILTER"
Material "diffuse" "texture reflectance" "large"
Shape "bilinearmesh" "point3 P" [ -1 0 -1  1 0 -1  -1 0 1  1 0 1 ]
"""


def write_png(path, side):
    """RGB of 8 bits: rows of one random row each shifted by its number, so that all tiles differ and it compresses."""
    row = random.Random(1).randbytes(3 * side)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)))
        deflate = zlib.compressobj(1)
        for y in range(side):
            # Neighbours in columns are alike for 16 rows: filter 2 (up) makes them zeros.
            if y % 16 == 0:
                shift = 3 * (997 * (y // 16) % side)
                line = b"\x00" + row[shift:] + row[:shift]
            else:
                line = b"\x02" + bytes(3 * side)
            if data := deflate.compress(line):
                out.write(chunk(b"IDAT", data))
        out.write(chunk(b"IDAT", deflate.flush()) + chunk(b"IEND", b""))


def render(vitrine, folder, output, megabytes, threads):
    """(bytes of the picture, peak resident bytes, seconds, seconds of rendering)"""
    command = [vitrine, "render", "scene.pbrt", "-o", output, "--progress", "none", "--stats", "stats.json",
               "--texture-cache", str(megabytes), "--nthreads", str(threads)]
    start = time.perf_counter()
    process = subprocess.Popen(command, cwd=folder, env={**os.environ, "TMPDIR": folder})
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(command)} failed")
    seconds = time.perf_counter() - start
    with open(os.path.join(folder, output), "rb") as picture, open(os.path.join(folder, "stats.json")) as stats:
        return picture.read(), usage.ru_maxrss * 1024, seconds, json.load(stats).get("seconds", float("nan"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--vitrine", default=os.path.join(ROOT, "build/release/vitrine"))
    parser.add_argument("--side", type=int, default=16384, help="texels along a side")
    parser.add_argument("--cache", type=int, default=512, help="megabytes")
    parser.add_argument("--filter", default="bilinear", help="of the texture")
    parser.add_argument("--folder", help="for temporary files (3.5 GB) [the system's]")
    parser.add_argument("--bar", type=float, default=1.25)
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory(dir=arguments.folder) as folder:
        with open(os.path.join(folder, "scene.pbrt"), "w") as scene:
            scene.write(SCENE.replace("FILTER", arguments.filter))
        image = os.path.join(folder, "image.png")
        write_png(image, 1)
        _, small, _, _ = render(arguments.vitrine, folder, "small.exr", arguments.cache, 2)
        print(f"one texel: {small / 2**20:.0f} MB at most")
        write_png(image, arguments.side)
        print(f"{arguments.side} x {arguments.side}: a file of {os.path.getsize(image) / 1e6:.0f} MB")
        pictures, extra = set(), 0
        for megabytes, threads in [(arguments.cache, 2), (arguments.cache // 4, 1), (4096, 2)]:
            picture, peak, seconds, rendering = render(arguments.vitrine, folder, "large.exr", megabytes, threads)
            pictures.add(picture)
            if megabytes == arguments.cache:
                extra = peak - small
            print(f"cache of {megabytes} MB, {threads} threads: {peak / 2**20:.0f} MB at most, {seconds:.1f} s, "
                  f"of which rendering {rendering:.1f} s")
    ratio = extra / 2**20 / arguments.cache
    print(f"on top of one texel {extra / 2**20:.0f} MB, {ratio:.2f} of the cache's size (bar {arguments.bar})")
    print("the same bytes" if len(pictures) == 1 else "DIFFERENT PICTURES")
    return 1 if ratio > arguments.bar or len(pictures) > 1 else 0


if __name__ == "__main__":
    sys.exit(main())
