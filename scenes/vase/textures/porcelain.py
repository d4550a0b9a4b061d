"""Blue and white ware: cobalt under a glaze, wound round the vase. u goes round, v up along the profile's length."""
import numpy as np

import exact
import motifs
import noise
from drawing import Plane, blurred, bytes_of, fill, line, pigmented, srgb, stroke
from exact import PI, polar

AROUND, UP = 56.0, 36.0  # circumference and length of the profile, in the scene's units
GLAZE = (0.86, 0.90, 0.91)
COBALT = (3.3, 2.3, 0.85)  # absorption of red, green and blue


def rings(plane, field, *heights, radius=0.09):
    for y in heights:
        line(plane, field, [(0, y), (AROUND, y)], radius, 0.9)


def lappets(plane, field, y0, y1, count, down=False):
    """A row of upright panels with pointed heads, a drop hanging in each."""
    step, tall = AROUND / count, y1 - y0
    half = step / 2 - 0.12
    head = [(half, 0), (half, 0.62), (half * 0.86, 0.8), (half * 0.45, 0.9), (0, 1)]
    outline = head + [(-x, t) for x, t in head[-2::-1]]
    for k in range(count):
        middle = (k + 0.5) * step

        def place(x, t):
            return (middle + x, y1 - t * tall if down else y0 + t * tall)

        fill(plane, field, [place(x, t) for x, t in outline], motifs.bands([(0.16, 0.95), (0.30, 0.03), (0.42, 0.8)], 0.08))
        drop = [place(0.36 * half * float(exact.sin(a)), 0.42 - 0.24 * float(exact.cos(a)) * (1 + 0.15 * float(exact.cos(a))))
                for a in [PI * i / 8 for i in range(16)]]
        fill(plane, field, drop, motifs.wash(0.08, 0.5))
        for side in (-1, 1):
            line(plane, field, [place(side * half * 0.42, 0.1), place(side * half * 0.2, 0.24), place(0, 0.12)], 0.06, 0.8)


def collar(plane, field, top, count):
    """Cloud heads that hang from a line, as round the shoulders of a robe."""
    step = AROUND / count
    for k in range(count):
        middle = (k + 0.5) * step
        outline = []
        for i in range(64):
            a = 2 * PI * i / 64
            lobes = 1 + 0.2 * float(exact.cos(3 * a - PI / 2 * 3))
            outline.append((middle + 0.47 * step * lobes * float(exact.cos(a)), top - 1.5 + 1.75 * lobes * float(exact.sin(a))))
        fill(plane, field, outline, motifs.bands([(0.15, 0.95), (0.3, 0.04), (0.4, 0.85)], 0.38))
        for i in range(5):
            at = np.array([middle, top - 1.45]) + polar(0.5, PI / 2 + 2 * PI * i / 5)
            fill(plane, field, motifs.circle(at, 0.36), motifs.bands([(0.09, 0.95)], 0.02))
        fill(plane, field, motifs.circle((middle, top - 1.45), 0.25), lambda d, x, y: 0.95)
        gap = (k * step, top - 1.2)
        line(plane, field, [(gap[0], top), gap], 0.07, 0.85)
        fill(plane, field, motifs.circle(gap, 0.3), lambda d, x, y: 0.85)


def stiff_leaves(plane, field, y0, y1, count):
    """Upright plantain leaves, a lower one behind each gap."""
    step = AROUND / count
    for shift, tall, ground in ((0.0, 0.8, 0.5), (0.5, 1.0, 0.06)):
        for k in range(count):
            root = ((k + shift) * step, y0)
            right = [(0.46, 0), (0.45, 0.3), (0.35, 0.6), (0.16, 0.85), (0, 1)]
            shape = right + [(-x, t) for x, t in right[-2::-1]]
            fill(plane, field, [(root[0] + x * step, y0 + t * tall * (y1 - y0)) for x, t in shape],
                 motifs.bands([(0.13, 0.95)], ground))
            if shift == 0.0:
                continue
            stroke(plane, field, [root, (root[0], y0 + 0.9 * (y1 - y0))], [0.2, 0.05], 0.9)
            for i in range(9):
                y = y0 + (0.06 + 0.085 * i) * (y1 - y0)
                wide = 0.34 * step * (1 - (0.1 * i) ** 2)
                for side in (-1, 1):
                    line(plane, field, [(root[0], y), (root[0] + side * wide, y + 0.5)], 0.045, 0.7)


def meander(plane, field, y0, y1, count):
    """Greek and Chinese alike: a line that winds into squares."""
    step, tall = AROUND / count, y1 - y0
    path = [(0, 0), (0, 1), (0.8, 1), (0.8, 0.3), (0.32, 0.3), (0.32, 0.62), (0.55, 0.62)]
    for k in range(count):
        line(plane, field, [((k + x) * step, y0 + y * tall) for x, y in path], 0.1, 0.9)
        line(plane, field, [(k * step, y0), ((k + 1) * step, y0)], 0.1, 0.9)


def running_scroll(plane, field, y0, y1, count):
    """Waves that curl over one after the other."""
    step, middle = AROUND / count, (y0 + y1) / 2
    for k in range(count):
        centre = np.array([(k + 0.5) * step, middle])
        spiral = [centre + polar(0.46 * (y1 - y0) * (1 - i / 30), 2.6 * PI * i / 24 - PI / 2) for i in range(25)]
        stroke(plane, field, [(k * step - 0.3, y0)] + spiral, [0.05] + [0.13 - 0.003 * i for i in range(25)], 0.88)


def lotus_scroll(plane, field, y0, y1):
    """The main band: a stem that winds round four lotus flowers, which look up and down by turns."""
    middle, wave = (y0 + y1) / 2, AROUND / 2
    tall = y1 - y0

    def stem(x):
        return middle - 0.37 * tall * float(exact.cos(2 * PI * x / wave))

    xs = [AROUND * i / 240 for i in range(241)]
    line(plane, field, [(x, stem(x)) for x in xs], 0.15, 0.9)
    for k in range(4):
        up = 1 if k % 2 == 0 else -1
        x = k * wave / 2
        for side in (-1, 1):
            def heading(angle):  # from upright as the flower sees it, towards `side`
                return up * (PI / 2 - side * angle)

            for offset, angle in ((1.4, 2.3), (2.2, 0.9), (9.6, 0.1), (11.2, 2.0)):
                foot = (x + side * offset, stem(x + side * offset))
                motifs.draw_leaf(plane, field, foot, heading(angle), 1.9, 0.75, side * up * 0.8)
            for offset, angle, turn, length in ((7.6, -0.5, 1, 9.5), (4.7, 2.2, 1, 9.0), (6.0, 1.4, -1, 5.5)):
                foot = (x + side * offset, stem(x + side * offset))
                motifs.tendril(plane, field, foot, heading(angle), side * up * turn, length)
        line(plane, field, [(x, stem(x)), (x, stem(x) + up * 0.12 * tall)], 0.14, 0.9)
        motifs.lotus(plane, field, (x, middle - up * 0.13 * tall), 0.43 * tall, up)


def make(scale):
    columns, rows = round(2048 * scale), round(1280 * scale)
    plane = Plane(AROUND, UP, columns, rows, wraps=True)
    field = plane.field()
    rings(plane, field, 0.35, 0.62, 5.0, 5.25, 6.75, 7.0, 18.6, 18.85, 20.35, 20.6, 31.5, 31.75, 33.3, 33.55)
    rings(plane, field, 0.0, UP, radius=0.22)
    lappets(plane, field, 0.8, 4.85, 16)
    running_scroll(plane, field, 5.35, 6.65, 30)
    lotus_scroll(plane, field, 7.1, 18.5)
    meander(plane, field, 19.05, 20.15, 32)
    collar(plane, field, 24.2, 14)
    rings(plane, field, 24.3, 24.55)
    stiff_leaves(plane, field, 24.7, 31.3, 16)
    running_scroll(plane, field, 31.9, 33.15, 30)
    lappets(plane, field, 33.7, 35.7, 24, down=True)

    # Cobalt runs a little in the glaze, and gathers in dark spots.
    soft = blurred(field, max(1, round(1.2 * scale)), wraps=True)
    field = 0.45 * field + 0.55 * soft
    cloud = noise.fbm(11, plane.shape, 24, 40, 4, wraps=True)
    spots = exact.smooth(0.66, 0.8, noise.fbm(12, plane.shape, 110, 180, 2, wraps=True))
    field = field * (0.62 + 0.72 * cloud + 0.3 * spots)
    body = noise.fbm(13, plane.shape, 6, 10, 3, wraps=True) * 0.06
    return {"porcelain.png": bytes_of(srgb(pigmented(GLAZE, [(field, COBALT), (body, (1, 0.8, 0.6))])))}
