#!/usr/bin/env python3
"""What many lights cost, and what choosing among them by a tree brings.

    python3 bench/many_lights.py [--program build/release/vitrine] [--rounds 5]

A hall of balls under 1,000 small triangles. The time when all of them shine (one mesh), when but one does, and when that one
is all there is, at equal samples, by turns, as the ratio of medians of user time without start-up; and the relMSE of 1,000
lamps chosen by power and by the tree ("bvh"), against the same scene at many samples.
"""
import argparse
import json
import pathlib
import random
import resource
import statistics
import subprocess
import tempfile

HALL = """Sampler "independent" "integer pixelsamples" {spp}
Integrator "path" "integer maxdepth" 5 "string lightsampler" "{choice}"
Film "rgb" "integer xresolution" 128 "integer yresolution" 96
LookAt 0 7 -11  0 0 0  0 1 0
Camera "perspective" "float fov" 55
WorldBegin
Material "diffuse" "rgb reflectance" [0.6 0.6 0.6]
Shape "bilinearmesh" "point3 P" [-10 0 -10  -10 0 10  10 0 -10  10 0 10]
"""


def balls():
    numbers = random.Random(2)
    kinds = ['"diffuse" "rgb reflectance" [0.7 0.5 0.3]', '"conductor" "float roughness" 0.1', '"dielectric"']
    text = ""
    for i in range(60):
        x, z, r = numbers.uniform(-9, 9), numbers.uniform(-9, 9), numbers.uniform(0.1, 0.4)
        text += f'AttributeBegin\nMaterial {kinds[i % 3]}\nTranslate {x:.4f} {r:.4f} {z:.4f}\n'
        text += f'Shape "sphere" "float radius" {r:.4f}\nAttributeEnd\n'
    return text


def triangles(shining, all_of_them):
    """They face downwards; the first ones shine."""
    numbers = random.Random(1)
    places = [(numbers.uniform(-9, 9), numbers.uniform(0.9, 1.5), numbers.uniform(-9, 9)) for _ in range(all_of_them)]

    def mesh(part):
        side = 0.14
        flat = " ".join(f"{x:.5f} {y:.5f} {z:.5f} {x + side:.5f} {y:.5f} {z:.5f} {x:.5f} {y:.5f} {z + side:.5f}"
                        for x, y, z in part)
        return (f'Shape "trianglemesh" "point3 P" [{flat}] "integer indices" '
                f'[{" ".join(str(i) for i in range(3 * len(part)))}]\n')

    lamps = 'AttributeBegin\nAreaLightSource "diffuse" "rgb L" [3 3 3]\n' + mesh(places[:shining]) + "AttributeEnd\n"
    return lamps + (mesh(places[shining:]) if shining < all_of_them else "")


def render(program, folder, case, spp, seed=0):
    """The picture's path and the user time in seconds, on one thread."""
    shining, all_of_them, choice = case
    scene, picture = folder / "hall.pbrt", folder / f"{shining}-{choice}-{spp}.exr"
    scene.write_text(HALL.format(spp=spp, choice=choice) + balls() + triangles(shining, all_of_them))
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([program, "render", scene, "-o", picture, "--seed", str(seed), "--nthreads", "1", "--progress", "none"],
                   check=True)
    return picture, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="build/release/vitrine")
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    cases = [(1, 1000, "power"), (1000, 1000, "bvh"), (1000, 1000, "power"), (1, 1, "power")]
    times = {case: [] for case in cases}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        start = {case: render(arguments.program, folder, case, 1)[1] for case in cases}
        for _ in range(arguments.rounds):
            for case in cases:
                times[case].append(render(arguments.program, folder, case, 257)[1] - start[case])
        medians = {case: statistics.median(values) for case, values in times.items()}
        for case, seconds in medians.items():
            shining, all_of_them, choice = case
            print(f"{shining} of {all_of_them} shine, {choice}: {seconds:.2f} s, {seconds / medians[cases[0]]:.2f} x the first")
        reference, _ = render(arguments.program, folder, cases[1], 4096, seed=9)
        errors = {}
        for case in cases[1:3]:
            picture, _ = render(arguments.program, folder, case, 64, seed=1)
            compared = subprocess.run([arguments.program, "diff", picture, reference, "--json"], check=True,
                                      capture_output=True, text=True)
            errors[case[2]] = json.loads(compared.stdout)["relMSE"]
            print(f"relMSE of 64 samples a pixel, {case[2]}: {errors[case[2]]:.4g}")
        print(f"ratio {errors['power'] / errors['bvh']:.2f}")


if __name__ == "__main__":
    main()
