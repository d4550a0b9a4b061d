"""Builds a Mitsuba scene by load_dict from the numbers of a pbrt-v4 scene file.

Knows just the directives and types that tests/images/references/caustic.pbrt has, and refuses all others: it is part of
a benchmark, not an importer. pbrt's camera is left-handed, so Mitsuba's picture is the mirror image of pbrt's.
"""

import shlex

import numpy as np

SETTINGS = ("Sampler", "Integrator", "PixelFilter", "Film")  # both programs are told these on their own


def directives(text):
    """Yields (name, positional words, {parameter: values}); shlex keeps quotes with posix=False."""
    tokens = []
    for line in text.splitlines():
        tokens += shlex.split(line.split("#")[0].replace("[", " [ ").replace("]", " ] "), posix=False)
    i = 0
    while i < len(tokens):
        name, words, parameters = tokens[i], [], {}
        i += 1
        while i < len(tokens) and not tokens[i].isalpha():
            if not tokens[i].startswith('"') or " " not in tokens[i]:
                words.append(value(tokens[i]))
                i += 1
                continue
            parameter = tokens[i].strip('"').split()[1]
            end = tokens.index("]", i) if tokens[i + 1] == "[" else i + 1
            parameters[parameter] = [value(t) for t in tokens[i + 1:end + 1] if t not in "[]"]
            i = end + 1
        yield name, words, parameters


def value(token):
    return token.strip('"') if token.startswith('"') else float(token)


def rgb(values):
    return {"type": "rgb", "value": list(values)}


def material(kind, p):
    if kind == "diffuse":
        return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(p["reflectance"])}}
    if kind == "dielectric":
        return {"type": "dielectric", "int_ior": p["eta"][0], "ext_ior": 1.0}
    if kind == "conductor" and p == {"eta": ["metal-Ag-eta"], "k": ["metal-Ag-k"]}:
        return {"type": "conductor", "material": "Ag"}
    raise ValueError(f'material "{kind}" {p} is not of the benchmark')


def parallelogram(corners, mi):
    """to_world of Mitsuba's rectangle, which is [-1,1]^2 with its normal along z; pbrt's corners are 00 10 01 11."""
    p00, p10, p01, p11 = np.array(corners).reshape(4, 3)
    if not np.allclose(p00 + p11, p10 + p01):
        raise ValueError("only parallelograms are of the benchmark")
    du, dv = (p10 - p00) / 2, (p01 - p00) / 2
    normal = np.cross(du, dv)
    matrix = np.eye(4)
    matrix[:3, :] = np.stack([du, dv, normal / np.linalg.norm(normal), (p00 + p11) / 2], axis=1)
    return mi.ScalarTransform4f(matrix)


def shape(kind, p, offset, mi):
    if kind == "sphere" and list(p) == ["radius"]:
        return {"type": "sphere", "center": offset.tolist(), "radius": p["radius"][0]}
    if kind == "bilinearmesh" and list(p) == ["P"] and not offset.any():
        return {"type": "rectangle", "to_world": parallelogram(p["P"], mi)}
    raise ValueError(f'shape "{kind}" {list(p)} is not of the benchmark')


def sensor(look_at, fov, resolution, sampler, spp, mi):
    origin, target, up = look_at[0:3], look_at[3:6], look_at[6:9]
    return {"type": "perspective", "fov": fov, "fov_axis": "smaller",
            "to_world": mi.ScalarTransform4f().look_at(origin=origin, target=target, up=up),
            "film": {"type": "hdrfilm", "width": resolution, "height": resolution, "rfilter": {"type": "box"},
                     "pixel_format": "rgb", "component_format": "float32"},
            "sampler": {"type": sampler, "sample_count": spp}}


def scene_dict(text, resolution, sampler, spp, max_depth, rr_depth, mi):
    """max_depth and rr_depth count as pbrt does: scattering events, and those after which the roulette begins.

    Mitsuba's max_depth counts the edges of the path to the light, its rr_depth is the first bounce with roulette: both
    are one more.
    """
    scene = {"type": "scene", "integrator": {"type": "path", "max_depth": max_depth + 1, "rr_depth": rr_depth + 1}}
    state, saved, look_at = {"bsdf": None, "light": None, "offset": np.zeros(3)}, [], None
    for name, words, p in directives(text):
        if name == "LookAt":
            look_at = words
        elif name == "Camera" and words == ["perspective"] and list(p) == ["fov"]:
            scene["sensor"] = sensor(look_at, p["fov"][0], resolution, sampler, spp, mi)
        elif name == "AttributeBegin":
            saved.append(dict(state))
        elif name == "AttributeEnd":
            state = saved.pop()
        elif name == "Translate":
            state["offset"] = state["offset"] + np.array(words)
        elif name == "Material":
            state["bsdf"] = material(words[0], p)
        elif name == "AreaLightSource" and words == ["diffuse"] and list(p) == ["L"]:
            state["light"] = {"type": "area", "radiance": rgb(p["L"])}
        elif name == "Shape":
            entry = shape(words[0], p, state["offset"], mi)
            entry["bsdf"] = state["bsdf"]
            if state["light"]:
                entry["emitter"] = state["light"]
            scene[f"shape{len(scene)}"] = entry
        elif name not in SETTINGS + ("WorldBegin",):
            raise ValueError(f"{name} {words} is not of the benchmark")
    return scene
