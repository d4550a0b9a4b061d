"""A plank of dark wood, and the depth of its pores. u runs along the grain."""
import numpy as np

import exact
import noise
from drawing import Plane, bytes_of, pigmented, srgb

GROUND = (0.52, 0.27, 0.12)
BROWN = (0.9, 1.35, 1.8)


def make(scale):
    size = round(1024 * scale)
    plane = Plane(30, 30, size, size)
    x, y = plane.coordinates()
    # The board was sawn beside the heart: its rings are cut at a flat angle, and a trunk is never straight.
    bend = 3.0 * noise.fbm(31, plane.shape, 2, 1, 2) + 0.25 * noise.fbm(32, plane.shape, 14, 3, 3)
    across = y - 9 + 2.2 * bend
    depth = 7 + 0.1 * x + 0.8 * bend
    ring = np.sqrt(across * across + depth * depth) * 0.85
    phase = ring - np.floor(ring)
    late = exact.smooth(0.1, 0.85, phase) * exact.smooth(1.0, 0.93, phase)  # grows dark, ends at once
    fibres = noise.fbm(33, plane.shape, 240, 5, 2)
    streaks = noise.fbm(34, plane.shape, 30, 1.5, 3)
    pores = exact.smooth(0.7, 0.82, noise.grid(35, plane.shape, 300, 14)) * (0.35 + 0.65 * late)
    dark = 0.15 + 0.55 * late + 0.5 * (fibres - 0.5) + 0.9 * (streaks - 0.4) + 0.55 * pores
    colour = bytes_of(srgb(pigmented(GROUND, [(np.maximum(dark, 0.0), BROWN)])))
    height = bytes_of(1 - 0.35 * late * fibres - 0.6 * pores)
    return {"wood.png": colour, "wood_height.png": height}
