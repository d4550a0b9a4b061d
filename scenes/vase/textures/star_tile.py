"""A square floor tile: an eight-pointed star, between whose arms crosses meet at the corners. The star is a mirror by
the mask."""
import numpy as np

import exact
import noise
from drawing import Plane, bytes_of, fill, pigmented, srgb
from exact import PI, polar

WHITE = (0.80, 0.78, 0.74)
INK = (1.5, 1.15, 0.75)  # blue-grey
OCHRE = (0.25, 0.6, 1.3)
REACH = 0.47  # of the star's points, of a tile's side 1


def star(centre, reach, inner=0.7654):
    """Two squares turned against each other; inner corners lie at 0.765 of the reach."""
    return [np.asarray(centre) + polar(reach * (inner if i % 2 else 1.0), PI / 8 * i) for i in range(16)]


def make(scale):
    size = round(1024 * scale)
    plane = Plane(1, 1, size, size, wraps=True)
    ink, ochre, mask = plane.field(), plane.field(), plane.field()

    def outline(depth, x, y):
        return np.where(depth < 0.012, 0.9, np.where(depth < 0.02, 0.0, np.where(depth < 0.024, 0.7, 0.0)))

    # the cross: what the star leaves, with a frame and a small star in its middle
    fill(plane, ink, [(0, 0), (1, 0), (1, 1), (0, 1)], lambda d, x, y: np.full(d.shape, 0.10))
    fill(plane, ink, star((0.5, 0.5), REACH + 0.035), lambda d, x, y: np.where(d < 0.008, 0.75, 0.03))
    fill(plane, ink, star((0.5, 0.5), REACH), outline)
    for corner in ((0, 0), (1, 0), (0, 1), (1, 1)):
        fill(plane, ochre, star(corner, 0.13), lambda d, x, y: np.where(d < 0.012, 0.0, 0.9))
        fill(plane, ink, star(corner, 0.15), lambda d, x, y: np.where(d < 0.014, 0.85, 0.02))
        fill(plane, ink, star(corner, 0.055), lambda d, x, y: np.full(d.shape, 0.85))
    for a, b in (((0.5, 0), (0.5, 1)), ((0, 0.5), (1, 0.5))):
        for at in (a, b):
            fill(plane, ink, star(at, 0.018), lambda d, x, y: np.full(d.shape, 0.8))
    fill(plane, mask, [(p - 0.5) * 1.0 + 0.5 for p in star((0.5, 0.5), REACH - 0.028)],
         lambda d, x, y: np.ones(d.shape))
    # stone: clouds, and the joint between tiles
    x, y = plane.coordinates()
    edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    cloud = noise.fbm(41, plane.shape, 5, 5, 5)
    rim = exact.smooth(0.0, 0.15, edge)  # clouds end where the next tile begins
    joint = exact.smooth(0.0035, 0.002, edge)
    ink = ink * (0.85 + 0.3 * cloud) + 0.16 * (cloud - 0.5) * rim + 0.05 + 0.7 * joint
    colour = pigmented(WHITE, [(np.maximum(ink, 0.0), INK), (ochre, OCHRE)])
    return {"star_tile.png": bytes_of(srgb(colour)), "star_mask.png": bytes_of(mask)}
