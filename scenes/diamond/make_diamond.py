#!/usr/bin/env python3
"""Writes brilliant.pbrt: the round brilliant cut of 57 facets, and the index of refraction of diamond.

The proportions are M. Tolkowsky's (Diamond Design, 1919), with the girdle and the half facets of today's stones. The
radius of the girdle is 1, its middle lies at y = 0, and the table is turned up. Run it in its own folder.
"""
from math import cos, pi, radians, sin, sqrt, tan

CROWN = radians(34.5)  # of the bezel facets against the girdle
PAVILION = radians(40.75)  # of the pavilion mains
TABLE = 0.53  # distance of the table's corners from the axis
GIRDLE = 0.05  # height of the girdle where it is highest
STAR = 0.5  # how far the stars reach from the table's edge to the girdle, seen from above
LOWER_HALF = 0.77  # how far the lower girdle facets reach from the girdle to the culet, seen from above
ARC = 4  # sides of the girdle along one girdle facet
STEP = pi / 8  # between neighbouring corners of girdle facets


def at(radius, angle, y):
    return (radius * cos(angle), y, radius * sin(angle))


def height_over(a, b, c, x, z):
    """y at (x, z) of the plane through three points."""
    u = [b[i] - a[i] for i in range(3)]
    v = [c[i] - a[i] for i in range(3)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return a[1] - (n[0] * (x - a[0]) + n[2] * (z - a[2])) / n[1]


def half(sign, slope, inner, axis_radius):
    """The crown (sign 1) or the pavilion (-1): its main facets, its girdle facets and its edge of the girdle."""
    def on_main(radius, off):  # height on a main facet, `off` its axis of symmetry
        return sign * (GIRDLE / 2 + (1 - radius * cos(off)) * tan(slope))

    tips = [at(axis_radius, 2 * k * STEP, on_main(axis_radius, 0)) for k in range(8)]
    sides = [at(inner, (2 * k + 1) * STEP, on_main(inner, STEP)) for k in range(8)]
    corners = [at(1, k * STEP, sign * GIRDLE / 2) for k in range(16)]
    mains = [[tips[k], sides[k - 1], corners[2 * k], sides[k]] for k in range(8)]
    facets, edge = [], []
    for k in range(16):
        ends = (sides[k // 2], corners[k], corners[(k + 1) % 16])
        arc = []
        for i in range(ARC):
            angle = (k + i / ARC) * STEP
            arc.append(at(1, angle, height_over(*ends, cos(angle), sin(angle))))
        facets.append([ends[0]] + arc + [ends[2]])
        edge += arc
    return tips, sides, mains, facets, edge


def facets():
    midpoint = TABLE * cos(STEP)
    table, stars, bezels, upper, rim = half(1, CROWN, midpoint + STAR * (1 - midpoint), TABLE)
    _, _, mains, lower, foot = half(-1, PAVILION, 1 - LOWER_HALF, 0)
    yield table
    for k in range(8):
        yield [table[k], stars[k], table[(k + 1) % 8]]
    yield from bezels + upper + lower + mains
    for k in range(len(rim)):
        yield [rim[k - 1], rim[k], foot[k], foot[k - 1]]


def triangles():
    """Fans of the facets, all with their vertices anticlockwise as seen from outside."""
    for facet in facets():
        middle = [sum(p[i] for p in facet) / len(facet) for i in range(3)]
        for b, c in zip(facet[1:], facet[2:]):
            a = facet[0]
            u = [b[i] - a[i] for i in range(3)]
            v = [c[i] - a[i] for i in range(3)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            yield (a, b, c) if sum(x * m for x, m in zip(n, middle)) > 0 else (a, c, b)


def index(nm):
    """F. Peter, Zeitschrift fuer Physik 15 (1923), p. 358; the wavelength in nanometres."""
    square = (nm / 1000) ** 2
    return sqrt(1 + 0.3306 * square / (square - 0.1750**2) + 4.3356 * square / (square - 0.1060**2))


def wrapped(words, width=116):
    line = "   "
    for word in words:
        if len(line) + 1 + len(word) > width:
            yield line
            line = "   "
        line += " " + word
    yield line


def main():
    numbers, indices = {}, []
    for corners in triangles():
        for corner in corners:
            key = " ".join("%.7g" % (x + 0.0 if abs(x) > 1e-12 else 0) for x in corner)
            indices.append(numbers.setdefault(key, len(numbers)))
    with open("brilliant.pbrt", "w") as out:
        print("# The round brilliant cut, 57 facets and a girdle. Written by make_diamond.py: change it there.", file=out)
        print('Material "dielectric" "spectrum eta" [', file=out)
        print(*wrapped("%d %.4f" % (nm, index(nm)) for nm in range(360, 831, 10)), sep="\n", end=" ]\n", file=out)
        print('Shape "trianglemesh" "point3 P" [', file=out)
        print(*wrapped(numbers), sep="\n", end=" ]\n", file=out)
        print('  "integer indices" [', file=out)
        print(*wrapped(str(i) for i in indices), sep="\n", end=" ]\n", file=out)


if __name__ == "__main__":
    main()
