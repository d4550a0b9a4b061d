#!/usr/bin/env python3
"""POV-Ray's lathe beside the exact turned profile, by the same camera: what a ray costs.

POV-Ray tells no time a ray, so it renders each subject and a sphere of the same size (ambient light only: one ray a pixel),
in turns; the difference of the two user times, over the pixels, is what the lathe costs more than the sphere. Ours, from the same
camera, is the shape's own closest-hit call: all of it, and less that of a sphere; and the whole call of the ray caster.
Needs `povray` (Debian's package) and build/release/bench_revolution_speed."""
import argparse
import json
import os
import resource
import statistics
import subprocess
import tempfile


def user_seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def povray_command(scene, side):
    return ["povray", f"+I{scene}.pov", f"+O{scene}.png", f"+W{side}", f"+H{side}", "+WT1", "-D", "-A", "+Q1", "-GA"]


def our_nanoseconds(program, rounds, folder):
    """Camera rays a subject, by the shape alone and by the caster; no meshes, so it takes seconds."""
    out = os.path.join(folder, "ours.json")
    subprocess.run([program, "--rounds", str(rounds), "--triangles", "5000", "--json", out], check=True,
                   stdout=subprocess.DEVNULL)
    with open(out, encoding="utf-8") as file:
        rows = json.load(file)
    return {(row["subject"], row["contender"]): row["ns"] for row in rows if row["rays"] == "camera"}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    here = os.path.dirname(os.path.abspath(__file__))
    parser.add_argument("--program", default=os.path.join(here, "../build/release/bench_revolution_speed"))
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--side", type=int, default=1024, help="of POV-Ray's pictures, in pixels")
    parser.add_argument("--keep", help="leave scenes and pictures in this folder, to be looked at")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.abspath(options.keep or folder)
        os.makedirs(folder, exist_ok=True)
        subprocess.run([program, "--povray", folder], check=True)
        lathe, ours = {}, {}
        for _ in range(options.rounds):
            for subject in ("goblet", "vase"):
                both = [user_seconds(povray_command(scene, options.side), folder)
                        for scene in (subject, subject + "_sphere")]
                lathe.setdefault(subject, []).append((both[0] - both[1]) * 1e9 / options.side**2)
            for key, ns in our_nanoseconds(program, 3, folder).items():
                ours.setdefault(key, []).append(ns)
        print(f"{'camera rays':12} {'lathe less sphere':>18} {'exact':>8} {'ratio':>6} {'less sphere':>12} {'ratio':>6} "
              f"{'by caster':>10} {'ratio':>6}")
        for subject, differences in lathe.items():
            alone = ours[subject, "exact, shape alone"]
            sphere = ours[subject, "sphere, shape alone"]
            columns = []
            for own in (alone, [a - b for a, b in zip(alone, sphere)], ours[subject, "exact, caster"]):
                ratio = statistics.median(a / b for a, b in zip(differences, own))
                columns.append(f"{statistics.median(own):5.0f} ns {ratio:6.1f}")
            print(f"{subject:12} {statistics.median(differences):15.0f} ns " + "    ".join(columns))


if __name__ == "__main__":
    main()
