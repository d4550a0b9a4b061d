"""The programs that compare_mitsuba.py sets against each other: each renders a picture of given settings and seed."""

import dataclasses
import glob
import json
import multiprocessing
import os
import re
import resource
import subprocess
import sys
import time

import numpy as np
import pbrt_to_mitsuba

NEWEST_LLVM = 19  # Dr.Jit cannot say which later ones it gets on with


def find_llvm():
    """The newest libLLVM that Dr.Jit can use, where Linux distributions put it."""
    found = {}
    for folder in ("/usr/lib/*-linux-gnu", "/usr/lib64", "/usr/lib", "/usr/lib/llvm-*/lib", "/usr/local/lib"):
        for path in glob.glob(f"{folder}/libLLVM*.so*"):
            version = re.search(r"libLLVM[-.](?:so\.)?(\d+)", os.path.basename(path))
            if version and int(version[1]) <= NEWEST_LLVM:
                found.setdefault(int(version[1]), path)
    if not found:
        sys.exit("No libLLVM found: install one (Debian: apt install libllvm19) or set DRJIT_LIBLLVM_PATH.")
    return found[max(found)]


@dataclasses.dataclass
class Picture:
    pixels: np.ndarray
    seconds: float  # of rendering
    wall: float  # of the whole program where it is one, else the same
    cpu: float  # of all threads
    paths: int


def serve_mitsuba(variant, threads, pipe):
    """Renders what comes down the pipe until told to end. One process a variant: they share no threads or caches."""
    import drjit
    import mitsuba

    mitsuba.set_variant(variant)
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    if threads:
        drjit.set_thread_count(threads)
    scenes = {}
    while (job := pipe.recv()) is not None:
        text, settings, seed = job
        key = tuple(sorted(settings.items()))
        if key not in scenes:
            scenes.clear()
            scenes[key] = mitsuba.load_dict(pbrt_to_mitsuba.scene_dict(text, mi=mitsuba, **settings))
            if variant.startswith("llvm"):
                np.array(mitsuba.render(scenes[key], seed=0))  # compiles: not counted
        start, start_cpu = time.perf_counter(), time.process_time()
        pixels = np.array(mitsuba.render(scenes[key], seed=seed))
        seconds, cpu = time.perf_counter() - start, time.process_time() - start_cpu
        spp = scenes[key].sensors()[0].sampler().sample_count()  # some samplers round it
        pipe.send(Picture(pixels, seconds, seconds, cpu, pixels.shape[0] * pixels.shape[1] * spp))


class Mitsuba:
    samplers = ("independent", "stratified", "multijitter", "orthogonal", "ldsampler")

    def __init__(self, variant, text, threads):
        self.name, self.text = variant, text
        context = multiprocessing.get_context("spawn")
        self.pipe, other = context.Pipe()
        self.process = context.Process(target=serve_mitsuba, args=(variant, threads, other), daemon=True)
        self.process.start()
        other.close()

    def render(self, settings, seed):
        self.pipe.send((self.text, settings, seed))
        return self.pipe.recv()

    def close(self):
        self.pipe.send(None)
        self.process.join()


def children_cpu():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class Vitrine:
    name = "vitrine"
    samplers = ("independent", "stratified", "zsobol")

    def __init__(self, program, scene, text, threads, folder, read_image):
        self.program, self.text, self.threads, self.folder = program, text, threads, folder
        self.read_image = read_image
        self.scene = os.path.join(folder, os.path.basename(scene))

    def render(self, settings, seed):
        self.write_scene(settings["sampler"], settings["spp"])
        picture, stats = os.path.join(self.folder, "ours.exr"), os.path.join(self.folder, "ours.json")
        size = settings["resolution"]
        start, start_cpu = time.perf_counter(), children_cpu()
        subprocess.run([self.program, "render", self.scene, "-o", picture, "--stats", stats, "--progress", "none",
                        "--resolution", f"{size}x{size}", "--spp", str(settings["spp"]), "--seed", str(seed),
                        "--nthreads", str(self.threads), "--set", f"maxdepth={settings['max_depth']}",
                        "--set", f"rrdepth={settings['rr_depth']}"], check=True)
        wall, cpu = time.perf_counter() - start, children_cpu() - start_cpu
        with open(stats) as file:
            figures = json.load(file)
        return Picture(self.read_image(picture), figures["seconds"], wall, cpu, figures["samples"])

    def write_scene(self, sampler, spp):
        """The scene with another sampler: the command line cannot change its type."""
        written = f'Sampler "{sampler}"'
        if sampler == "stratified":
            side = int(round(spp ** 0.5))
            written += f' "integer xsamples" [ {side} ] "integer ysamples" [ {spp // side} ]'
        text, count = re.subn(r"(?m)^Sampler .*$", written, self.text)
        if count != 1:
            raise ValueError("the scene must have its Sampler on a line of its own")
        with open(self.scene, "w") as file:
            file.write(text)

    def close(self):
        pass
