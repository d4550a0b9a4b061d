"""What an ink painter draws: mountains, pines, water, a boat, birds, a seal. Lengths are those of the wall."""
import random

import numpy as np

import exact
import noise
from drawing import fill, line, stroke
from exact import PI, polar


class Painting:
    """Densities of the pigments on a plane of paper."""

    def __init__(self, plane):
        self.plane = plane
        self.ink, self.indigo, self.ochre, self.vermilion = (plane.field() for _ in range(4))

    def hide(self, rows, cover):
        """What is behind the mountain, there: rows from the top of the picture."""
        for field in (self.ink, self.indigo, self.ochre, self.vermilion):
            field[:rows] = field[:rows] * (1 - cover)


def ridge(plane, seed, peaks, base, rough):
    """Height over x of a chain of peaks (x, height, half width)."""
    x = plane.x.astype(np.float32)
    height = np.full(x.shape, float(base), np.float32)
    for middle, top, half in peaks:
        t = (x - float(middle)) * (1 / half)
        t = t + 0.5 * (noise.fbm(seed + int(middle), (1, x.size), 1, 20, 3)[0] - 0.5)
        shape = 0.65 * exact.exp(-t * t) + 0.35 * exact.exp(-t * t * t * t * 3)
        height = np.maximum(height, base + (top - base) * shape)
    crags = noise.fbm(seed, (1, x.size), 1, 40, 6, 0.62)[0] - 0.5
    return height + crags * float(1.5 * rough)


def mountains(painting, seed, peaks, base=0.0, rough=5.0, tone=1.0, blue=0.3, warm=0.0, mist=20.0, strokes=1.0):
    """A chain: dark along its crest, folds and rocks below, fading into mist around the height `mist`. Returns the crest."""
    plane = painting.plane
    crest = ridge(plane, seed, peaks, base, rough)
    rows = min(plane.shape[0], int((plane.height - mist + 6) / plane.height * plane.shape[0]))
    x, y = plane.coordinates()
    y = y[:rows]
    depth = crest[None, :] - y
    cover = np.clip(0.5 + depth * (1 / plane.pixel), 0.0, 1.0)
    drift = noise.fbm(seed + 7, plane.shape, 7, 16, 4)[:rows]
    clear = exact.smooth(mist - 5, mist + 13, y + 16 * (drift - 0.5))
    inner = np.maximum(depth, 0.0)
    # Folds run down the slopes: noise long in the direction of the depth, bent by slower noise.
    bend = 5 * drift
    folds = noise.at(seed + 1, inner * 0.055 + bend * 0.3, x * 0.26 + bend)
    fine = noise.at(seed + 2, inner * 0.2 + bend, x * 1.15 + 1.5 * bend)
    fibre = noise.at(seed + 3, inner * 0.5, x * 3.1 + 2 * bend)
    rock = exact.smooth(0.52, 0.9, 1 - np.abs(2 * fine - 1)) * (0.45 + 0.55 * fibre)
    edge = exact.exp(inner * (-1 / 0.35)) * (0.35 + 0.65 * fibre)
    body = 0.10 + 0.30 * exact.exp(inner * (-1 / 9.0)) + 0.5 * exact.smooth(0.42, 0.8, folds) * exact.exp(inner * (-1 / 26.0))
    density = (body + strokes * (0.75 * rock * exact.smooth(0.3, 0.65, folds + 0.2 * rock) + 0.7 * edge)) * clear * cover
    painting.hide(rows, cover * (0.25 + 0.72 * clear))
    painting.ink[:rows] += density * float(tone)
    painting.indigo[:rows] += cover * clear * (0.35 + 0.65 * (1 - folds)) * float(blue)
    painting.ochre[:rows] += cover * clear * exact.smooth(3.0, 22.0, inner) * folds * float(warm)
    return crest


def small_pine(painting, dice, x, y, size):
    """A tree on a far crest: a trunk and level pads of needles."""
    lean = (dice.random() - 0.5) * 0.4
    top = (x + lean * size, y + size)
    stroke(painting.plane, painting.ink, [(x, y - 0.3), top], [0.11 * size, 0.04 * size], 0.9)
    levels = 5 + int(3 * dice.random())
    for i in range(levels):
        t = 0.28 + 0.72 * i / levels
        at = (x + lean * size * t, y + size * t)
        for side in (-1, 1):
            wide = size * (0.52 - 0.42 * t) * (0.4 + 0.9 * dice.random())
            tip = (at[0] + side * wide, at[1] - 0.05 * size + 0.1 * size * dice.random())
            stroke(painting.plane, painting.ink, [at, tip], [0.085 * size, 0.03 * size], 0.6 + 0.4 * dice.random())


def grove(painting, dice, crest, x0, x1, count, size, mist):
    """Trees on a crest, as far as it stands out of the mist."""
    plane = painting.plane
    for _ in range(count):
        x = x0 + (x1 - x0) * dice.random()
        y = float(crest[min(plane.shape[1] - 1, int(x / plane.pixel))]) - 0.8 * size * dice.random()
        if y > mist + 3:
            small_pine(painting, dice, x, y, size * (0.6 + 0.7 * dice.random()))


def needles(painting, dice, at, size):
    """A fan of needles, dark at its heart."""
    for _ in range(26):
        angle = PI * (-0.12 + 1.24 * dice.random())
        root = np.asarray(at) + np.array([(dice.random() - 0.5) * 1.5 * size, (dice.random() - 0.5) * 0.3 * size])
        tip = root + polar(size * (0.5 + 0.5 * dice.random()), angle) * np.array([1.0, 0.6])
        stroke(painting.plane, painting.ink, [root, tip], [0.09, 0.03], 0.55 + 0.75 * dice.random())


def branch(painting, dice, root, heading, length, thick, order):
    """Crooked, with smaller ones to both sides; the smallest carry needles."""
    points, steps = [np.asarray(root, float)], 9
    for i in range(steps):
        heading += (dice.random() - 0.5) * 0.75
        points.append(points[-1] + polar(length / steps, heading))
    radii = [thick * (1 - 0.75 * i / steps) for i in range(steps + 1)]
    stroke(painting.plane, painting.ink, points, radii, 0.95)
    # light falls on the upper side of the bark
    for i in range(0, steps, 2):
        if radii[i] > 0.35:
            spot = points[i] + polar(radii[i] * 0.35, PI / 2)
            fill(painting.plane, painting.ink, [spot + polar(radii[i] * (0.35 + 0.2 * dice.random()), 2 * PI * k / 7) for k in range(7)],
                 lambda d, x, y: np.full(d.shape, 0.45))
    if order == 0:
        for i in (4, 7, 9):
            needles(painting, dice, points[i] + np.array([0, 0.25]), 1.5 + 0.7 * dice.random())
        return
    for i in range(3, steps + 1, 2):
        side = 1 if (i // 2) % 2 else -1
        spread = side * (0.55 + 0.4 * dice.random())
        branch(painting, dice, points[i], heading * 0.6 + spread * (1 if order > 1 else 0.7), length * 0.42, radii[i] * 0.7, order - 1)
    needles(painting, dice, points[-1], 1.8)


def water(painting, dice, x0, x1, y0, y1, count):
    """Short level strokes, thinner and closer together far away (above)."""
    for _ in range(count):
        t = dice.random()
        y = y0 + (y1 - y0) * t
        x = x0 + (x1 - x0) * dice.random()
        long = (7 - 4.5 * t) * (0.4 + dice.random())
        thick = 0.10 - 0.06 * t
        points = [(x + long * k / 6, y + 0.12 * (1 - t) * float(exact.sin(k * 1.1 + x))) for k in range(7)]
        stroke(painting.plane, painting.ink, points, [thick * float(exact.sin(PI * (k + 0.3) / 6.6)) for k in range(7)],
               0.16 + 0.25 * dice.random())


def boat(painting, x, y, size):
    plane, ink = painting.plane, painting.ink
    hull = [(-1.0, 0.22), (-0.6, 0.02), (0.0, -0.03), (0.6, 0.02), (1.05, 0.25)]
    stroke(plane, ink, [(x + a * size, y + b * size) for a, b in hull], [c * size for c in (0.02, 0.09, 0.1, 0.09, 0.02)], 1.1)
    roof = [(-0.35 + 0.1 * i, 0.08 + 0.3 * float(exact.sin(PI * i / 7))) for i in range(8)]
    fill(plane, ink, [(x + a * size, y + b * size) for a, b in roof], lambda d, px, py: np.where(d < 0.1, 1.0, 0.4))
    stroke(plane, ink, [(x + 0.62 * size, y + 0.05 * size), (x + 0.6 * size, y + 0.5 * size)], [0.09 * size, 0.05 * size], 1.0)
    line(plane, ink, [(x + 0.4 * size, y + 0.47 * size), (x + 0.8 * size, y + 0.5 * size)], 0.035 * size, 1.0)
    line(plane, ink, [(x + 0.5 * size, y + 0.4 * size), (x + 1.5 * size, y - 0.2 * size)], 0.02 * size, 0.9)
    line(plane, ink, [(x - size, y - 0.18 * size), (x + 1.1 * size, y - 0.18 * size)], 0.04 * size, 0.25)


def birds(painting, dice, x, y, count):
    for i in range(count):
        at = np.array([x + 2.6 * i + dice.random(), y + 0.5 * i - 1.2 * (i % 3) + dice.random()])
        span = 0.75 + 0.35 * dice.random()
        wings = [at + np.array(p) * span for p in ((-1, 0.35), (-0.45, 0.42), (0, 0), (0.4, 0.5), (1, 0.5))]
        stroke(painting.plane, painting.ink, wings, [0.03, 0.08, 0.11, 0.08, 0.03], 0.9)


def seal(painting, dice, x, y, size):
    """White lines in vermilion: four signs in the manner of old seals, which mean nothing."""
    plane, red = painting.plane, painting.vermilion
    corners = [(x + a * size + (dice.random() - 0.5) * 0.05 * size, y + b * size) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    fill(plane, red, corners, lambda d, px, py: np.full(d.shape, 1.0))
    white = plane.field()
    cell = 0.43 * size
    for column in range(2):
        for row in range(2):
            left, low = x + (0.06 + 0.46 * column) * size, y + (0.06 + 0.46 * row) * size
            levels = [0.12 + 0.19 * k for k in range(5)]
            for k, level in enumerate(levels):
                a, b = (0.1, 0.9) if dice.random() < 0.6 else ((0.1, 0.42), (0.58, 0.9))[dice.randrange(2)]
                line(plane, white, [(left + a * cell, low + level * cell), (left + b * cell, low + level * cell)], 0.022 * size)
                if k and dice.random() < 0.8:
                    at = left + dice.choice((0.1, 0.5, 0.9)) * cell
                    line(plane, white, [(at, low + levels[k - 1] * cell), (at, low + level * cell)], 0.022 * size)
    red *= 1 - white


def sun(painting, x, y, radius):
    ring = [np.array([x, y]) + polar(radius, 2 * PI * i / 48) for i in range(48)]
    fill(painting.plane, painting.vermilion, ring, lambda d, px, py: 0.75 - 0.35 * exact.smooth(0.0, 2.2 * radius, y + radius - py + 0 * px))


def dice(seed):
    return random.Random(seed)
