#!/usr/bin/env python3
"""Writes docs/parameters.md from the parameter tables in the headers under src/.

A comment that begins with a directive of the scene format, a type in quotes and a colon, as in

    /// Shape "disk": a disk or ring perpendicular to the z axis.
    ///
    /// | name | type | unit | default | meaning |

documents that type (or several: Sampler "sobol", "halton": ...). The comment's text becomes the type's section.
The tables are held against the builders in src/scene: every type that has a builder needs a section, every section
a builder, and the names in a family's tables must be those that its builders ask for.

Usage: make_manual.py           writes docs/parameters.md
       make_manual.py --check   fails when the file is not what would be written
"""

import difflib
import itertools
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MANUAL = ROOT / "docs" / "parameters.md"

# Directive, its table (or tables) of types in src/scene, what the section opens with.
FAMILIES = [
    ("Shape", "shapeTypes",
     "Every shape also takes `alpha`, a `float` or a float texture (default 1): the share of rays, shadow rays too, that "
     "the surface stops at a point. An area light shines with that share of its L; where alpha is 0 throughout, the shape "
     "is not there, but shines whole. Alpha knows no pixel: image textures are looked up at full resolution."),
    ("Material", "materialTypes",
     'The type `""` or `"none"` is another spelling of `"interface"`. A type whose index of refraction or '
     "reflectance is a spectrum takes a single `float` too. Every type but `interface` and `mix` also takes "
     "`displacement`, a float texture (scene units): bump mapping, shaded as if the surface were moved outwards by so much. "
     'Or `"string normalmap"`: an image of normals, red along dpdu and blue along the normal, from -1 to 1 as values go '
     "from 0 to 1, not encoded; it goes before `displacement`."),
    ("Texture", ("floatTextureTypes", "spectrumTextureTypes"),
     'As in `Texture "name" "spectrum" "checkerboard" ...`; types are for `float` and for `spectrum` textures unless they '
     "say otherwise. Those that speak of (s, t) take `\"string mapping\"`, by default `\"uv\"`, and its parameters "
     "(see Mapping); the others lie in the texture's space, which the transformation in front of the directive makes."),
    ("Mapping", None,
     "How a point of a surface gets its (s, t). All but `uv` start from the point in the texture's space, which the "
     "transformation in front of `Texture` makes; it may not move."),
    ("AreaLightSource", "areaLightTypes", 'The type `""` turns area lights off again for the shapes that follow.'),
    ("LightSource", "lightTypes", ""),
    ("Camera", "cameraTypes", "Every camera also takes `shutteropen` and `shutterclose`: see Film."),
    ("Film", "filmTypes", ""),
    ("PixelFilter", "filterTypes", ""),
    ("Sampler", None, ""),
    ("Integrator", "integratorTypes", ""),
]
# Builders' files, and the directives whose tables name what these files ask for.
BUILDERS = [
    (("shape_builder.cpp", "revolution_builder.cpp", "alpha_builder.cpp"), ["Shape"]),
    (("material_builder.cpp", "surface_detail_builder.cpp"), ["Material"]),
    (("texture_builder.cpp", "mapping_builder.cpp", "image_texture_builder.cpp"), ["Texture", "Mapping"]),
    ("light_builder.cpp", ["AreaLightSource", "LightSource"]),
    (("camera_builder.cpp", "film_builder.cpp"), ["Camera", "Film", "PixelFilter", "Sampler"]),
    ("integrator_builder.cpp", ["Integrator"]),
]
# Asked for by all types of a family; stands in its opening sentence instead of each table.
IN_OPENINGS = {("Shape", "alpha"), ("Material", "displacement"), ("Material", "normalmap"), ("Texture", "mapping")}

HEADING = re.compile(r'(%s) ("\w+"(?:, "\w+")*)( \([^)]*\))?: (.*)' % "|".join(f for f, _, _ in FAMILIES))
LOOK_UP = re.compile(r'\b(?:(?:get|find)(?!Builder)[A-Z]\w*(?:<\w+>)?|choice<\w+, \d+>)\((?:[\w.]+, )*"([\w.]+)"|\bemission\((?:[\w.]+, )+"(\w+)"')


class Section:
    def __init__(self, family, types, qualifier, lines):
        self.family, self.types, self.qualifier, self.lines = family, types, qualifier, lines

    def parameters(self):
        rows = [line for line in self.lines if line.startswith("| ")][1:]
        return {name.strip() for row in rows for name in row.split("|")[1].split(",")}

    def markdown(self):
        title = ", ".join(f'"{t}"' for t in self.types) + self.qualifier
        return [f"### {title}", ""] + [tidy(line) for line in self.lines] + [""]


def tidy(line):
    """Table cells without the padding that keeps columns straight in a header."""
    if not line.startswith("|"):
        return line
    cells = [cell.strip() for cell in line.strip("|").split("|")]
    if all(set(cell) == {"-"} for cell in cells):
        return "|---" * len(cells) + "|"
    return "| " + " | ".join(cells) + " |"


def comment_blocks(text):
    """Runs of comment lines, without their slashes."""
    block = []
    for line in text.split("\n") + [""]:
        match = re.match(r"///? ?(.*)", line)
        if match:
            block.append(match.group(1).rstrip())
        elif block:
            yield block
            block = []


def read_sections():
    sections = []
    for header in sorted((ROOT / "src").rglob("*.h")):
        for block in comment_blocks(header.read_text(encoding="utf-8")):
            match = HEADING.match(block[0])
            if not match:
                continue
            family, types, qualifier, first = match.groups()
            # What follows a \throws or \param is for programmers.
            block = list(itertools.takewhile(lambda line: not line.startswith("\\"), block))
            lines = [first[0].upper() + first[1:]] + block[1:]
            sections.append(Section(family, re.findall(r'"(\w+)"', types), qualifier or "", lines))
    return sections


def read_builders():
    return {path.name: path.read_text(encoding="utf-8") for path in (ROOT / "src" / "scene").glob("*_builder.cpp")}


def registry_entries(sources, table):
    for text in sources.values():
        match = re.search(r"RegistryEntry<\w+> %s\[\] = \{(.*?)\};" % table, text, re.S)
        if match:
            return re.findall(r'\{"(\w+)"(, [\w<>]+)?\}', match.group(1))
    sys.exit(f"make_manual: there is no table {table} in src/scene")


def registry(sources, tables):
    """Types of a family in the order of its tables: (supported, known but not yet supported)."""
    entries = [entry for table in tables for entry in registry_entries(sources, table)]
    supported = list(dict.fromkeys(name for name, build in entries if build))
    return supported, list(dict.fromkeys(name for name, build in entries if not build and name not in supported))


def check_types(family, supported, sections):
    documented = {name for section in sections for name in section.types}
    faults = [f'{family} "{name}" has no parameter table in a header' for name in supported if name not in documented]
    faults += [f'{family} "{name}" has a parameter table but no builder'
               for name in sorted(documented) if name not in supported]
    return faults


def check_parameters(files, families, sources, sections):
    names = files if isinstance(files, tuple) else (files,)
    text = "\n".join(sources[name] for name in names)
    asked = {a or b for a, b in LOOK_UP.findall(text)} - {name for family, name in IN_OPENINGS if family in families}
    documented = {p for section in sections if section.family in families for p in section.parameters()}
    where = " and ".join(names)
    return [f'{where}: "{name}" is asked for, but no table of {", ".join(families)} has it'
            for name in sorted(asked - documented)] + \
           [f'{where}: the tables of {", ".join(families)} have "{name}", but nothing asks for it'
            for name in sorted(documented - asked)]


def make_manual():
    sections, sources = read_sections(), read_builders()
    out = ["# Types and their parameters", "",
           "Made by `scripts/make_manual.py` from the headers in `src/`: change it there. How the directives that take",
           "these types are written is told in [scene-format.md](scene-format.md).", ""]
    faults = []
    for family, table, opening in FAMILIES:
        own = [section for section in sections if section.family == family]
        out += [f"## {family}", ""]
        if opening:
            out += [opening, ""]
        if table:
            supported, later = registry(sources, (table,) if isinstance(table, str) else table)
            faults += check_types(family, supported, own)
            own.sort(key=lambda s: min(supported.index(t) if t in supported else 99 for t in s.types))
            if later:
                out += ["Known, and refused as not yet supported: " + ", ".join(f"`{name}`" for name in later) + ".", ""]
        for section in own:
            out += section.markdown()
    for files, families in BUILDERS:
        faults += check_parameters(files, families, sources, sections)
    if faults:
        sys.exit("make_manual: " + "\nmake_manual: ".join(faults))
    return "\n".join(out).rstrip("\n") + "\n"


def main():
    manual = make_manual()
    if sys.argv[1:] == ["--check"]:
        committed = MANUAL.read_text(encoding="utf-8") if MANUAL.exists() else ""
        if committed != manual:
            sys.stdout.writelines(difflib.unified_diff(committed.splitlines(True), manual.splitlines(True),
                                                       "docs/parameters.md", "from the headers"))
            sys.exit("make_manual: docs/parameters.md is out of date: run scripts/make_manual.py")
    elif sys.argv[1:]:
        sys.exit(__doc__)
    else:
        MANUAL.parent.mkdir(exist_ok=True)
        MANUAL.write_text(manual, encoding="utf-8")


if __name__ == "__main__":
    main()
