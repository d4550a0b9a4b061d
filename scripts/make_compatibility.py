#!/usr/bin/env python3
"""Writes docs/compatibility.md: what becomes of each object and parameter of pbrt-v4.

The objects are those of the registry tables in src/scene (each names all of pbrt-v4's types of its family, the ones that
are not there yet too); their parameters are listed below, as pbrt-v4 reads them. Each is given to the program in a scene of
its own, so that the table says what the program does, not what someone believes.

Usage: make_compatibility.py PROGRAM           writes docs/compatibility.md (PROGRAM: the built vitrine)
       make_compatibility.py PROGRAM --check   fails when the file is not what would be written
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from make_manual import ROOT, read_builders, registry

TARGET = ROOT / "docs" / "compatibility.md"

# Family, its table in src/scene (none: pbrt-v4's types as listed), a scene round an object: {} is its type and parameters.
BEFORE_WORLD = "{directive} {object}\nWorldBegin\nShape \"sphere\"\n"
FAMILIES = {
    "Shape": ("shapeTypes", "WorldBegin\n{directive} {object}\n"),
    "Material": ("materialTypes", 'WorldBegin\nMakeNamedMaterial "a" "string type" "diffuse"\n'
                 'MakeNamedMaterial "b" "string type" "diffuse"\n{directive} {object}\nShape "sphere"\n'),
    "Texture float": ("floatTextureTypes", 'WorldBegin\nTexture "t" "float" {object}\n'),
    "Texture spectrum": ("spectrumTextureTypes", 'WorldBegin\nTexture "t" "spectrum" {object}\n'),
    "LightSource": ("lightTypes", 'WorldBegin\n{directive} {object}\nShape "sphere"\n'),
    "AreaLightSource": ("areaLightTypes", 'WorldBegin\n{directive} {object}\nShape "sphere"\n'),
    "Camera": ("cameraTypes", BEFORE_WORLD),
    "Film": ("filmTypes", BEFORE_WORLD),
    "PixelFilter": ("filterTypes", BEFORE_WORLD),
    "Sampler": (None, BEFORE_WORLD),
    "Integrator": ("integratorTypes", BEFORE_WORLD + 'LightSource "point"\n'),
    "Accelerator": (None, BEFORE_WORLD),
    "MakeNamedMedium": (None, 'MakeNamedMedium "m" "string type" {object}\nWorldBegin\nShape "sphere"\n'),
}

ALPHA = "float alpha=.5"
BUMP = "texture displacement=BUMP; string normalmap=IMAGE"
ROUGH = "float roughness=.1; float uroughness=.1; float vroughness=.1; bool remaproughness=false"
COAT = "float thickness=.02; float g=.1; rgb albedo=.1 .1 .1; integer maxdepth=5; integer nsamples=2"
MAPPING = ("string mapping=planar; float udelta=.1; float vdelta=.1; vector3 v1=1 0 0; vector3 v2=0 1 0 | "
           "string mapping=uv; float uscale=2; float vscale=2 | string mapping=spherical | string mapping=cylindrical")
IMAGEMAP = ("string filename=IMAGE! ; string filter=bilinear; float maxanisotropy=4; string wrap=clamp; "
            "string encoding=linear; bool invert=true; float scale=.5 | string wrap=octahedralsphere | " + MAPPING)
WINDOW = "float frameaspectratio=1; float screenwindow=-1 1 -1 1; float lensradius=.1; float focaldistance=2; " \
         "float shutteropen=0; float shutterclose=.5"
SAMPLES = "integer pixelsamples=4; integer seed=1"
OWENS = SAMPLES + "; string randomization=owen"
FILM = ("integer xresolution=8; integer yresolution=8; string filename=a.exr; float cropwindow=0 1 0 1; "
        "float diagonal=35; bool savefp16=false; float maxcomponentvalue=10; float iso=100; string sensor=cie1931 | "
        "integer pixelbounds=0 4 0 4; float whitebalance=5000; string sensor=canon_eos_100d")
PAIR = "P=0 0 0 1 0 0 0 1 0 1 1 0"

# Parameters by type: "kind name=values"; ! marks what the object cannot do without; | parts sets that exclude one another.
PBRT = {
    "Shape": {
        "sphere": f"float radius=1; float zmin=-.5; float zmax=.5; float phimax=90; {ALPHA}",
        "disk": f"float radius=1; float innerradius=.5; float height=.1; float phimax=90; {ALPHA}",
        "cylinder": f"float radius=1; float zmin=-.5; float zmax=.5; float phimax=90; {ALPHA}",
        "trianglemesh": "integer indices=0 1 2 1 2 3!; point3 P=0 0 0 1 0 0 0 1 0 1 1 0!; point2 uv=0 0 1 0 0 1 1 1; "
                        "normal N=0 0 1 0 0 1 0 0 1 0 0 1; vector3 S=1 0 0 1 0 0 1 0 0 1 0 0; integer faceIndices=0 1; "
                        f"{ALPHA}",
        "bilinearmesh": "integer indices=0 1 2 3!; point3 P=0 0 0 1 0 0 0 1 0 1 1 0!; point2 uv=0 0 1 0 0 1 1 1; "
                        "normal N=0 0 1 0 0 1 0 0 1 0 0 1; integer faceIndices=0; string emissionfilename=IMAGE; "
                        f"{ALPHA}",
        "plymesh": f"string filename=MESH!; texture displacement=BUMP; float edgelength=.1; {ALPHA}",
        "curve": "point3 P=0 0 0 1 0 0 0 1 0 1 1 0!; float width=.1; float width0=.1; float width1=.1; integer degree=3; "
                 f"string basis=bezier; string type=flat; normal N=0 0 1 0 0 1; integer splitdepth=3; {ALPHA}",
        "loopsubdiv": f"integer levels=2; integer indices=0 1 2 1 2 3!; point3 {PAIR}!; string scheme=loop; {ALPHA}",
    },
    "Material": {
        "diffuse": f"rgb reflectance=.5 .5 .5; {BUMP}",
        "conductor": f"spectrum eta=metal-Ag-eta; spectrum k=metal-Ag-k; {ROUGH}; {BUMP} | rgb reflectance=.5 .5 .5",
        "dielectric": f"spectrum eta=glass-BK7; {ROUGH}; {BUMP} | float eta=1.4",
        "thindielectric": f"spectrum eta=glass-BK7; {BUMP} | float eta=1.4",
        "coateddiffuse": f"rgb reflectance=.5 .5 .5; float eta=1.4; {ROUGH}; {COAT}; {BUMP}",
        "coatedconductor": "spectrum conductor.eta=metal-Ag-eta; spectrum conductor.k=metal-Ag-k; "
                           "float interface.eta=1.4; float interface.roughness=.1; float interface.uroughness=.1; "
                           "float interface.vroughness=.1; float conductor.roughness=.1; float conductor.uroughness=.1; "
                           f"float conductor.vroughness=.1; bool remaproughness=false; {COAT}; {BUMP} | "
                           "rgb reflectance=.5 .5 .5",
        "diffusetransmission": f"rgb reflectance=.3 .3 .3; rgb transmittance=.3 .3 .3; float scale=.5; {BUMP}",
        "mix": "string materials=a\" \"b!; float amount=.3",
        "interface": "",
        "hair": "rgb sigma_a=1 1 1; rgb reflectance=.1 .1 .1; rgb color=.1 .1 .1; float eumelanin=1; float pheomelanin=1; "
                "float eta=1.5; float beta_m=.3; float beta_n=.3; float alpha=2",
        "measured": "string filename=a.bsdf!",
        "subsurface": "string name=Skin1; rgb mfp=1 1 1; float eta=1.3; rgb sigma_a=1 1 1; rgb sigma_s=1 1 1; float g=0; "
                      f"float scale=1; rgb reflectance=.5 .5 .5; {ROUGH}",
    },
    "Texture float": {
        "constant": "float value=1",
        "scale": "float tex=1; float scale=1",
        "mix": "float tex1=0; float tex2=1; float amount=.5",
        "directionmix": "float tex1=0; float tex2=1; vector3 dir=0 1 0",
        "bilerp": f"float v00=0; float v01=1; float v10=0; float v11=1; {MAPPING}",
        "checkerboard": f"float tex1=0; float tex2=1; integer dimension=2; {MAPPING} | integer dimension=3",
        "dots": f"float inside=1; float outside=0; {MAPPING}",
        "fbm": "integer octaves=8; float roughness=.5",
        "wrinkled": "integer octaves=8; float roughness=.5",
        "windy": "",
        "imagemap": IMAGEMAP,
        "ptex": "string filename=a.ptx!; string encoding=linear; float scale=1",
    },
    "Texture spectrum": {
        "constant": "rgb value=1 1 1",
        "scale": "rgb tex=1 1 1; float scale=1",
        "mix": "rgb tex1=0 0 0; rgb tex2=1 1 1; float amount=.5",
        "directionmix": "rgb tex1=0 0 0; rgb tex2=1 1 1; vector3 dir=0 1 0",
        "bilerp": f"rgb v00=0 0 0; rgb v01=1 1 1; rgb v10=0 0 0; rgb v11=1 1 1; {MAPPING}",
        "checkerboard": f"rgb tex1=0 0 0; rgb tex2=1 1 1; integer dimension=2; {MAPPING} | integer dimension=3",
        "dots": f"rgb inside=1 1 1; rgb outside=0 0 0; {MAPPING}",
        "marble": "integer octaves=8; float roughness=.5; float scale=1; float variation=.2",
        "imagemap": IMAGEMAP,
        "ptex": "string filename=a.ptx!; string encoding=linear; float scale=1",
    },
    "LightSource": {
        "point": "rgb I=1 1 1; float scale=2; float power=10; point3 from=0 0 3",
        "spot": "rgb I=1 1 1; float scale=2; float power=10; point3 from=0 0 3; point3 to=0 0 0; float coneangle=30; "
                "float conedeltaangle=5",
        "distant": "rgb L=1 1 1; float scale=2; float illuminance=10; point3 from=0 0 3; point3 to=0 0 0",
        "infinite": "rgb L=1 1 1; float scale=2; float illuminance=10 | string filename=IMAGE; float scale=2 | "
                    "point3 portal=0 0 1 1 0 1 1 1 1 0 1 1; string filename=IMAGE",
        "projection": "string filename=IMAGE!; float scale=2; float power=10; float fov=40",
        "goniometric": "string filename=IMAGE!; rgb I=1 1 1; float scale=2; float power=10",
    },
    "AreaLightSource": {
        "diffuse": "rgb L=1 1 1; float scale=2; float power=10; bool twosided=true | blackbody L=3000 | string filename=IMAGE",
    },
    "Camera": {
        "perspective": f"float fov=40; {WINDOW}",
        "orthographic": WINDOW,
        "spherical": "string mapping=equalarea; float shutteropen=0; float shutterclose=.5",
        "realistic": "string lensfile=a.dat!; float aperturediameter=1; float focusdistance=10; string aperture=gaussian",
    },
    "Film": {
        "rgb": FILM,
        "gbuffer": FILM + "; string coordinatesystem=camera",
        "spectral": FILM + "; integer nbuckets=16; float lambdamin=360; float lambdamax=830",
    },
    "PixelFilter": {
        "box": "float xradius=.5; float yradius=.5",
        "gaussian": "float xradius=1.5; float yradius=1.5; float sigma=.5",
        "mitchell": "float xradius=2; float yradius=2; float B=.3; float C=.3",
        "sinc": "float xradius=4; float yradius=4; float tau=3",
        "triangle": "float xradius=2; float yradius=2",
    },
    "Sampler": {
        "independent": SAMPLES,
        "stratified": "integer xsamples=2; integer ysamples=2; bool jitter=true; integer seed=1",
        "halton": OWENS.replace("owen", "permutedigits"),
        "sobol": OWENS,
        "paddedsobol": OWENS,
        "zsobol": OWENS,
        "pmj02bn": SAMPLES,
    },
    "Integrator": {
        "path": "integer maxdepth=5; string lightsampler=bvh; bool regularize=false",
        "volpath": "integer maxdepth=5; string lightsampler=bvh; bool regularize=false",
        "lightpath": "integer maxdepth=5",
        "sppm": "integer maxdepth=5; integer photonsperiteration=100; float radius=.1; integer seed=1",
        "simplepath": "integer maxdepth=5; bool samplelights=true; bool samplebsdf=true",
        "simplevolpath": "integer maxdepth=5",
        "randomwalk": "integer maxdepth=5",
        "bdpt": "integer maxdepth=5; bool visualizestrategies=false; bool visualizeweights=false; bool regularize=false",
        "mlt": "integer maxdepth=5; integer bootstrapsamples=100; integer chains=10; integer mutationsperpixel=10; "
               "float largestepprobability=.3; float sigma=.01; bool regularize=false",
        "ambientocclusion": "bool cossample=true; float maxdistance=1",
        "function": "string function=step; string filename=a; bool skipbad=true; string imagefilename=a.exr",
    },
    "Accelerator": {
        "bvh": "string splitmethod=sah; integer maxnodeprims=4",
        "kdtree": "integer intersectcost=5; integer traversalcost=1; float emptybonus=.5; integer maxprims=1; integer maxdepth=-1",
    },
    "MakeNamedMedium": {
        "homogeneous": "", "uniformgrid": "", "rgbgrid": "", "cloud": "", "nanovdb": "",
    },
}
# What Vitrine has beyond pbrt-v4: in docs/parameters.md.
OWN = {"Shape": {"box", "plane", "revolution", "mesh"}, "Integrator": {"ppm", "vcm", "hybrid"}}

PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
"""


def errors(program, folder, scene):
    """The messages of the program's errors about a scene; none when it is right."""
    bump = 'Texture "bump" "float" "constant" "float value" 0\n'
    text = scene.replace("WorldBegin\n", "WorldBegin\n" + bump, 1)
    (folder / "scene.pbrt").write_text(text)
    run = subprocess.run([program, "info", "scene.pbrt"], cwd=folder, capture_output=True, text=True)
    if run.returncode not in (0, 1):
        sys.exit(f"{program} info ended with {run.returncode}:\n{text}\n{run.stderr}")
    return re.findall(r"error: (.*)", run.stderr)


def written(parameter, folder):
    """A parameter as scene text. "string filename=IMAGE!" -> "string filename" "image.ppm" """
    declaration, value = parameter.strip().rstrip("! ").split("=", 1)
    for word, meant in {"IMAGE": "image.ppm", "MESH": "mesh.ply", "BUMP": "bump"}.items():
        value = value.replace(word, meant)
    kind = declaration.split()[0]
    quoted = kind in ("string", "texture") or (kind == "spectrum" and not value[0].isdigit())
    return f'"{declaration}" ' + (f'[ "{value}" ]' if quoted else f"[ {value} ]")


def states(program, folder, family, name):
    """(whether there is such an object or why not, parameters accepted, parameters refused with the reason)"""
    scene = FAMILIES[family][1]
    sets = [[p for p in part.split(";") if p.strip()] for part in PBRT[family][name].split("|")]
    needed = [p for p in sets[0] if p.strip().endswith("!")]

    def tell(parameters):
        text = " ".join([f'"{name}"'] + [written(p, folder) for p in parameters])
        return errors(program, folder, scene.format(directive=family.split()[0], object=text))

    def label(parameter):
        return parameter.strip().split("=")[0].split(" ", 1)[1]

    def about(parameter, messages):
        value = parameter.strip().rstrip("! ").split("=", 1)[1]
        words = [f'{label(parameter)}"'] + ([f'"{value}"'] if parameter.strip().startswith(("string", "spectrum")) else [])
        return next((m for m in messages if any(word in m for word in words)), None)

    accepted, refused = [], []
    for index, part in enumerate(sets):
        messages = tell(part if index == 0 else needed + part)
        if index == 0:
            gone = [m for m in messages if "not yet supported" in m and (f'"{name}"' in m or '"' not in m)]
            gone += [m for m in messages if m.startswith("unknown") and f'"{name}"' in m]
            if gone:
                return gone[0], [], []
        for parameter in part:
            message = about(parameter, messages)
            if message:
                refused.append((parameter.strip().rstrip("! ") if "string" in parameter else label(parameter), message))
                messages = [m for m in messages if m != message]
            elif label(parameter) not in accepted:
                accepted.append(label(parameter))
        if messages:
            sys.exit(f"{family} {name}: what is this about? {messages}")
    return None, accepted, refused


def page(program):
    lines = [
        "# Vitrine and pbrt-v4's scene format",
        "",
        "Made by `scripts/make_compatibility.py`, which gives each object and parameter of pbrt-v4 to the program. What is",
        "refused is an error that names it, never passed over. What Vitrine has beyond pbrt-v4 is in",
        "[parameters.md](parameters.md).",
    ]
    sources = read_builders()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "image.ppm").write_bytes(b"P6\n2 2\n255\n" + bytes(range(100, 112)))
        (folder / "mesh.ply").write_text(PLY)
        for family, (table, _) in FAMILIES.items():
            if table:
                supported, later = registry(sources, [table])
                known = set(supported) | set(later)
                known -= OWN.get(family, set())
                if known != set(PBRT[family]):
                    sys.exit(f"{table} and the list here differ by {sorted(known ^ set(PBRT[family]))}")
            lines += ["", f"## {family}", "", "| type | state | parameters read | refused |", "|---|---|---|---|"]
            for object_name in PBRT[family]:
                why, accepted, refused = states(program, folder, family, object_name)
                state = "yes" if why is None else "refused: " + why.replace("|", "\\|")
                reasons = "; ".join(f"`{label}`: {reason}".replace("|", "\\|") for label, reason in refused)
                lines.append(f"| `{object_name}` | {state} | {', '.join(f'`{a}`' for a in accepted)} | {reasons} |")
    return "\n".join(lines) + "\n"


def main():
    program = str(Path(sys.argv[1]).resolve())
    text = page(program)
    if "--check" in sys.argv[2:]:
        if TARGET.read_text() != text:
            sys.exit(f"{TARGET.name} is not current: run scripts/make_compatibility.py {sys.argv[1]}")
        return
    TARGET.write_text(text)


if __name__ == "__main__":
    main()
