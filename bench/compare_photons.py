#!/usr/bin/env python3
"""Photon mapping beside Mitsuba 3's path tracer: time for the same work, and error after the same time.

Needs Python packages that this repository does not install: pip install mitsuba numpy
(and LLVM's shared library: apt install libllvm19).

Part 1, the yardstick: sppm with 64 passes of 65,536 photons at 256 x 256, depth 12, over Mitsuba's llvm_ad_rgb `path`
with 64 samples a pixel of the same picture. pbrt-v4's SPPM takes 5.9 times Mitsuba's time.
Part 2: at 128 x 128, the error of sppm with its default settings (3 pixels, alpha 2/3, as many photons as pixels) after
the processor time that Mitsuba takes for 780 samples a pixel, against the reference.

Both take turns; figures are medians of processor time and of the clock. Processor time is what counts on a machine that
does other things beside. What Mitsuba spends on compiling is not counted, nor is our start-up in the clock's figure.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

try:
    import mitsuba
    import numpy as np
except ImportError as missing:
    sys.exit(f"{missing}. Install what is needed by: pip install mitsuba numpy")

from contenders import Mitsuba, children_cpu, find_llvm  # noqa: E402

MAX_DEPTH = 12
MITSUBA_SPP = 780  # in part 2


def sppm(args, folder, resolution, passes, photons, seed):
    """Returns (seconds of rendering, processor time of the process, of its start-up alone, file)."""
    picture, stats = os.path.join(folder, "ours.exr"), os.path.join(folder, "ours.json")
    start = children_cpu()
    subprocess.run([args.program, "render", args.scene, "-o", picture, "--stats", stats, "--progress", "none",
                    "--integrator", "sppm", "--resolution", f"{resolution}x{resolution}", "--passes", str(passes),
                    "--seed", str(seed), "--nthreads", str(args.threads), "--set", f"maxdepth={MAX_DEPTH}",
                    "--set", f"photonsperiteration={photons}"], check=True)
    cpu = children_cpu() - start
    start = children_cpu()
    subprocess.run([args.program, "--version"], check=True, stdout=subprocess.DEVNULL)
    with open(stats) as file:
        figures = json.load(file)
    return figures["seconds"], cpu, children_cpu() - start, picture, figures["photons"]["seconds"]


def read_picture(path):
    bitmap = mitsuba.Bitmap(path)
    return np.array(bitmap.convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.Float32, srgb_gamma=False))


def relative_errors(picture, reference):
    """relMSE less what the reference's own variance makes of it: of all pixels, and without the worst thousandth."""
    mean, variance = reference["mean"].astype(float), reference["var"].astype(float)
    weight = 1 / (mean ** 2 + 0.01)
    error, noise = (((picture - mean) ** 2 * weight).mean(axis=2).ravel(), (variance * weight).mean(axis=2).ravel())
    kept = len(error) - len(error) // 1000
    return error.mean() - noise.mean(), np.sort(error)[:kept].mean() - np.sort(noise)[:kept].mean()


def mitsuba_settings(resolution, spp):
    return {"resolution": resolution, "spp": spp, "max_depth": MAX_DEPTH, "rr_depth": 5, "sampler": "independent"}


def yardstick(args, theirs, folder):
    ours, phases, rival = [], [], []
    for seed in range(args.rounds):
        rival.append(theirs.render(mitsuba_settings(256, 64), seed))
        *times, _, where = sppm(args, folder, 256, 64, 65536, seed)
        ours.append(times)
        phases.append(where)
    seconds, cpu, start = (statistics.median(x) for x in zip(*ours))
    their_seconds, their_cpu = (statistics.median(p.seconds for p in rival), statistics.median(p.cpu for p in rival))
    ratios = {"clock": seconds / their_seconds, "processor": cpu / their_cpu,
              "processorWithoutStart": (cpu - start) / their_cpu}
    print(f"1. sppm {seconds:.2f} s, processor {cpu:.2f} s (start-up {start:.2f}); Mitsuba {their_seconds:.2f} s, "
          f"processor {their_cpu:.2f} s")
    print("   ours / Mitsuba: " + ", ".join(f"{name} {ratio:.3f}" for name, ratio in ratios.items())
          + "  (bar 1.475, aim 0.74; pbrt-v4 5.9)")
    whole = {name: statistics.median(p[name] for p in phases) for name in phases[0]}
    print("   " + ", ".join(f"{name} {100 * s / sum(whole.values()):.0f} %" for name, s in whole.items()))
    return {"seconds": seconds, "cpu": cpu, "mitsubaSeconds": their_seconds, "mitsubaCpu": their_cpu, "ratios": ratios,
            "phases": whole}


def equal_time(args, theirs, folder):
    reference = np.load(args.reference)
    results = []
    for seed in range(args.rounds):
        rival = theirs.render(mitsuba_settings(128, MITSUBA_SPP), seed)
        trial = 64
        _, cpu, start, _, _ = sppm(args, folder, 128, trial, -1, seed + 100)
        passes = max(1, int((rival.cpu - start) / (cpu - start) * trial))
        _, cpu, _, file, _ = sppm(args, folder, 128, passes, -1, seed)
        all_pixels, trimmed = relative_errors(read_picture(file), reference)
        # pbrt's camera is left-handed: mirrored.
        rival_error = relative_errors(rival.pixels[:, ::-1], reference)
        results.append({"passes": passes, "cpu": cpu, "mitsubaCpu": rival.cpu, "relMSE": all_pixels,
                        "trimmed": trimmed, "mitsubaRelMSE": rival_error[0], "mitsubaTrimmed": rival_error[1]})
        print(f"2. {passes} passes, processor {cpu:.2f} s (Mitsuba {rival.cpu:.2f}): relMSE {all_pixels:.5f}, without the "
              f"worst thousandth {trimmed:.5f}; Mitsuba's {rival_error[0]:.5f}, {rival_error[1]:.5f}"
              "  (bar 0.003, aim 0.001)")
    return results


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    references = os.path.join(ROOT, "tests/images/references")
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/vitrine"))
    parser.add_argument("--scene", default=os.path.join(references, "caustic.pbrt"))
    parser.add_argument("--reference", default=os.path.join(references, "caustic.npz"))
    parser.add_argument("--threads", type=int, default=0, help="0: all processors")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--parts", nargs="+", default=["1", "2"], choices=["1", "2"])
    parser.add_argument("--json", help="write all figures to this file")
    return parser.parse_args()


def main():
    args = arguments()
    sys.stdout.reconfigure(line_buffering=True)
    os.environ.setdefault("DRJIT_LIBLLVM_PATH", find_llvm())
    mitsuba.set_variant("scalar_rgb")
    with open(args.scene) as file:
        theirs = Mitsuba("llvm_ad_rgb", file.read(), args.threads)
    report = {}
    try:
        with tempfile.TemporaryDirectory() as folder:
            for part, run in (("1", yardstick), ("2", equal_time)):
                if part in args.parts:
                    report[part] = run(args, theirs, folder)
    finally:
        theirs.close()
    if args.json:
        with open(args.json, "w") as file:
            json.dump(report, file, indent=2)


if __name__ == "__main__":
    main()
