#!/usr/bin/env python3
"""Path tracing beside Mitsuba 3: paths a second, variance, and efficiency = 1 / (time x variance).

Needs Python packages that this repository does not install: pip install mitsuba numpy
(for the variant llvm_ad_rgb also LLVM's shared library: apt install libllvm19).

Part 1 gives both programs the same settings: independent sampler, same depth, same roulette depth. Part 2 looks for the
best sampler and roulette depth of each, then measures these. All contenders take turns, picture by picture, so that
what else the machine does falls on all alike; times are medians. What Mitsuba spends on compiling is not counted.
"""

import argparse
import itertools
import json
import os
import platform
import statistics
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

try:
    import mitsuba
    import numpy as np
except ImportError as missing:
    sys.exit(f"{missing}. Install what is needed by: pip install mitsuba numpy")

from contenders import Mitsuba, Vitrine, find_llvm  # noqa: E402

ROULETTE_DEPTHS = (1, 2, 3, 5, 8, 12)
SEARCH_SEED = 1000  # what looked best by luck is measured again by other seeds
DROPPED = 0.01  # share of pixels that the robust variance leaves out


def variances(pictures):
    """Of one picture: mean of (a-b)^2/2 over pixels, channels and all pairs of seeds; and the robust one, for which
    each pair's 1 % of pixels with the largest difference are dropped (fireflies of the caustic rule the plain one)."""
    plain, robust = [], []
    for a, b in itertools.combinations(pictures, 2):
        each = np.sort(((a - b) ** 2).mean(axis=2).ravel()) / 2
        plain.append(each.mean())
        robust.append(each[:len(each) - int(DROPPED * len(each))].mean())
    return float(np.mean(plain)), float(np.mean(robust))


def measure(entries, rounds, first_seed=0):
    """entries: [(contender, settings)]. Renders them in turn; returns a dictionary of figures an entry."""
    taken = [[] for _ in entries]
    for seed in range(first_seed, first_seed + rounds):
        for i, (contender, settings) in enumerate(entries):
            taken[i].append(contender.render(settings, seed))
            print(".", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    results = []
    for (contender, settings), pictures in zip(entries, taken):
        seconds = statistics.median(p.seconds for p in pictures)
        plain, robust = variances([p.pixels for p in pictures])
        results.append({
            "program": contender.name, "sampler": settings["sampler"], "rrdepth": settings["rr_depth"],
            "paths": pictures[0].paths, "seconds": seconds, "allSeconds": [p.seconds for p in pictures],
            "wallSeconds": statistics.median(p.wall for p in pictures),
            "cpuSeconds": statistics.median(p.cpu for p in pictures), "pathsPerSecond": pictures[0].paths / seconds,
            "variance": plain, "robustVariance": robust,
            "efficiency": 1 / (seconds * plain), "robustEfficiency": 1 / (seconds * robust),
            "picture": np.mean([p.pixels for p in pictures], axis=0)})
    return results


def best_settings(contender, base, rounds):
    """First the best roulette depth with the program's usual sampler, then the best sampler, then the depth again.

    Processor time and the robust variance decide: a few pictures do not tell the others apart, least of all on a
    machine that does other things beside.
    """
    tried = {}

    def cost(figures):
        return figures["cpuSeconds"] * figures["robustVariance"]

    def best(candidates):
        new = [s for s in candidates if (s["sampler"], s["rr_depth"]) not in tried]
        for settings, figures in zip(new, measure([(contender, s) for s in new], rounds, SEARCH_SEED) if new else []):
            tried[settings["sampler"], settings["rr_depth"]] = figures
        return min(candidates, key=lambda s: cost(tried[s["sampler"], s["rr_depth"]]))

    chosen = best([dict(base, rr_depth=depth) for depth in ROULETTE_DEPTHS])
    chosen = best([dict(chosen, sampler=sampler) for sampler in contender.samplers])
    chosen = best([dict(chosen, rr_depth=depth) for depth in ROULETTE_DEPTHS])
    return chosen, [without_picture(figures) for figures in tried.values()]


def without_picture(figures):
    return {key: value for key, value in figures.items() if key != "picture"}


def show(title, results):
    print(f"\n{title}")
    print(f"{'program':<14}{'sampler':<13}{'rr':>3}{'seconds':>9}{'wall':>8}{'cpu':>8}{'Mpaths/s':>10}{'variance':>11}"
          f"{'robust':>11}{'efficiency':>12}{'robust':>10}")
    for r in results:
        print(f"{r['program']:<14}{r['sampler']:<13}{r['rrdepth']:>3}{r['seconds']:>9.3f}{r['wallSeconds']:>8.3f}"
              f"{r['cpuSeconds']:>8.3f}{r['pathsPerSecond'] / 1e6:>10.3f}{r['variance']:>11.5f}"
              f"{r['robustVariance']:>11.3e}{r['efficiency']:>12.3f}{r['robustEfficiency']:>10.2f}")


def ratios(results):
    """Ours by each of Mitsuba's."""
    ours, keys = results[0], ("pathsPerSecond", "cpuSeconds", "variance", "robustVariance", "efficiency",
                              "robustEfficiency")
    return {r["program"]: {key: ours[key] / r[key] for key in keys} for r in results[1:]}


def show_ratios(by_program):
    for program, r in by_program.items():
        print(f"vitrine / {program}: speed {r['pathsPerSecond']:.2f} (processor time {r['cpuSeconds']:.2f}), variance "
              f"{r['variance']:.2f} (robust {r['robustVariance']:.2f}), efficiency {r['efficiency']:.2f} "
              f"(robust {r['robustEfficiency']:.2f})")


def check_agreement(results, tolerance=0.02, block=16):
    """Both programs must have rendered the same thing. The metal's and the walls' colours are RGB for one and spectra
    for the other: hence the tolerance, to which four standard errors come. Blocks tell that the pictures are mirrored
    and otherwise alike."""
    def standard_error(r):
        """Of a channel's mean over all pictures taken, relative."""
        values = r["picture"].size / 3 * len(r["allSeconds"])
        return (r["variance"] / values) ** 0.5 / r["picture"].mean()

    ours, ours_error = results[0]["picture"], standard_error(results[0])
    agreement = {}
    for r in results[1:]:
        theirs = r["picture"][:, ::-1]
        ratio = theirs.mean(axis=(0, 1)) / ours.mean(axis=(0, 1))
        side = ours.shape[0] // block

        def blocks(picture):
            return picture[:side * block, :side * block].reshape(side, block, side, block, 3).mean(axis=(1, 3))

        difference = float(np.median(np.abs(blocks(theirs) / blocks(ours) - 1)))
        agreement[r["program"]] = {"meanRatio": ratio.tolist(), "medianBlockDifference": difference}
        print(f"{r['program']} against vitrine: means {' '.join(f'{x:.4f}' for x in ratio)}, median difference of "
              f"{block} x {block} blocks {100 * difference:.1f} %")
        error = (ours_error ** 2 + standard_error(r) ** 2) ** 0.5
        if abs(ratio - 1).max() > tolerance + 4 * error or difference > 0.1:
            sys.exit("The pictures differ: this is no comparison.")
    return agreement


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/vitrine"))
    parser.add_argument("--scene", default=os.path.join(ROOT, "tests/images/references/caustic.pbrt"))
    parser.add_argument("--variants", nargs="+", default=["llvm_ad_rgb", "scalar_rgb"])
    parser.add_argument("--resolution", type=int, default=256)
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--maxdepth", type=int, default=12, help="scattering events, as pbrt counts")
    parser.add_argument("--rrdepth", type=int, default=5, help="scattering events before the roulette, as pbrt counts")
    parser.add_argument("--threads", type=int, default=0, help="0: all processors")
    parser.add_argument("--rounds", type=int, default=8, help="pictures (seeds) of each in a measurement")
    parser.add_argument("--search-rounds", type=int, default=2,
                        help="pictures of each setting tried in part 2; 0: no part 2")
    parser.add_argument("--json", help="write all figures to this file")
    return parser.parse_args()


def run(args, contenders):
    base = {"resolution": args.resolution, "spp": args.spp, "max_depth": args.maxdepth, "rr_depth": args.rrdepth,
            "sampler": "independent"}
    report = {"machine": platform.processor() or platform.machine(), "processors": os.cpu_count(),
              "load": os.getloadavg()[0], "mitsuba": mitsuba.__version__, "settings": base}
    same = measure([(c, base) for c in contenders], args.rounds)
    show("1. Same settings", same)
    report["same"] = {"figures": [without_picture(r) for r in same], "ratios": ratios(same)}
    show_ratios(report["same"]["ratios"])
    report["agreement"] = check_agreement(same)
    if args.search_rounds:
        found = [best_settings(c, dict(base, sampler=c.samplers[-1]), args.search_rounds) for c in contenders]
        best = measure([(c, settings) for c, (settings, _) in zip(contenders, found)], args.rounds)
        show("2. Each at its best", best)
        report["best"] = {"figures": [without_picture(r) for r in best], "ratios": ratios(best),
                          "tried": [figures for _, tried in found for figures in tried]}
        show_ratios(report["best"]["ratios"])
    if args.json:
        with open(args.json, "w") as file:
            json.dump(report, file, indent=2)


def main():
    args = arguments()
    sys.stdout.reconfigure(line_buffering=True)
    if args.rounds < 2 or args.search_rounds == 1:
        sys.exit("A variance needs two seeds: --rounds and --search-rounds must be at least 2 (or --search-rounds 0).")
    if any(variant.startswith("llvm") for variant in args.variants):
        os.environ.setdefault("DRJIT_LIBLLVM_PATH", find_llvm())
    mitsuba.set_variant("scalar_rgb")
    with open(args.scene) as file:
        text = file.read()

    def read_image(path):
        bitmap = mitsuba.Bitmap(path)
        return np.array(bitmap.convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.Float32, srgb_gamma=False))

    with tempfile.TemporaryDirectory() as folder:
        contenders = [Vitrine(args.program, args.scene, text, args.threads, folder, read_image)]
        contenders += [Mitsuba(variant, text, args.threads) for variant in args.variants]
        try:
            run(args, contenders)
        finally:
            for contender in contenders:
                contender.close()


if __name__ == "__main__":
    main()
