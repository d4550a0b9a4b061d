"""Flowers, leaves and tendrils of the blue and white decor."""
import numpy as np

import exact
from drawing import fill, stroke
from exact import PI, polar


def bands(edges, ground):
    """Lines along a shape's edge: up to each depth its value, then the ground."""
    def shade(depth, x, y):
        value = np.full(depth.shape, float(ground))
        for limit, density in reversed(edges):
            value = np.where(depth < limit, float(density), value)
        return value
    return shade


def wash(outline, reach, light=0.14, dark=0.62):
    """An outline, and a wash that fades from it inwards."""
    def shade(depth, x, y):
        return np.where(depth < outline, 0.95, light + (dark - light) * exact.exp(depth * (-1 / reach)))
    return shade


def circle(centre, radius):
    return [np.asarray(centre) + polar(radius, 2 * PI * i / 24) for i in range(24)]


def petal(root, heading, length, width):
    """Pointed, broadest beyond its middle."""
    along, across = polar(1.0, heading), polar(1.0, heading + PI / 2)
    profile = [(0, 0.25), (0.15, 0.5), (0.35, 0.85), (0.55, 1), (0.72, 0.9), (0.85, 0.6), (0.94, 0.26), (1, 0)]
    right = [np.asarray(root) + along * (t * length) + across * (w * width / 2) for t, w in profile]
    left = [np.asarray(root) + along * (t * length) - across * (w * width / 2) for t, w in profile[-2::-1]]
    return right + left


def leaf(root, heading, length, width, bend):
    """Curved, with a long tip; `bend` is the angle it turns by. Its outline and its middle line."""
    at, right, left, middle = np.asarray(root, float), [], [], []
    steps = 12
    for i in range(steps + 1):
        t = i / steps
        half = width / 2 * float(exact.sin(PI * min(1.0, t * 1.0))) * (1.25 - 0.75 * t) + 0.01
        side = polar(half, heading + PI / 2)
        right.append(at + side)
        left.append(at - side)
        middle.append(at)
        at = at + polar(length / steps, heading)
        heading += bend / steps
    return right + left[::-1], middle


def draw_leaf(plane, field, root, heading, length, width, bend):
    outline, middle = leaf(root, heading, length, width, bend)
    fill(plane, field, outline, wash(0.09, 0.3, 0.45, 0.8))
    stroke(plane, field, middle[1:9], [0.06] * 8, 0.98)


def tendril(plane, field, root, heading, turn, length):
    """Winds up more and more, with leaves to both sides by turns and a bud at its end."""
    points, headings = [np.asarray(root, float)], [heading]
    steps = 36
    for i in range(steps):
        t = i / steps
        heading += turn * (0.03 + 0.28 * t * t)
        points.append(points[-1] + polar(length / steps * (1.25 - 0.5 * t), heading))
        headings.append(heading)
    for i, side in ((5, -1), (10, 1), (15, -1), (20, 1), (25, -1)):
        size = 1.9 if side > 0 else 1.5
        draw_leaf(plane, field, points[i], headings[i] - side * turn / abs(turn) * 0.75, size, 0.8,
                  -side * turn / abs(turn) * -1.1)
    stroke(plane, field, points, [0.13 - 0.05 * i / steps for i in range(steps + 1)], 0.9)
    fill(plane, field, circle(points[-1], 0.2), lambda d, x, y: np.full(d.shape, 0.9))


def lotus(plane, field, centre, size, up):
    """Seen from the side: three rings of petals, the nearer over the farther, and a heart with seeds."""
    upright = PI / 2 * up
    for side in (-1, 1):
        for angle, long in ((2.15, 0.5), (2.6, 0.42)):
            draw_leaf(plane, field, centre, upright + side * angle, long * size, 0.2 * size, -side * 0.9)
    for count, spread, length, width in ((9, 1.75, 1.0, 0.42), (7, 1.35, 0.78, 0.36), (5, 0.95, 0.55, 0.28)):
        order = sorted(range(count), key=lambda i: -abs(i - (count - 1) / 2))
        for i in order:
            angle = spread * (2 * i / (count - 1) - 1)
            stretch = 1 - 0.22 * abs(angle) / spread
            fill(plane, field, petal(centre, upright + angle, length * size * stretch, width * size),
                 wash(0.1, 0.1 * size, 0.06, 0.6))
            tip = np.asarray(centre) + polar(length * size * stretch * 0.9, upright + angle)
            vein = np.asarray(centre) + polar(length * size * stretch * 0.68, upright + angle)
            stroke(plane, field, [vein, tip], [0.03, 0.09], 0.85)
    heart = np.asarray(centre) + polar(0.1 * size, upright)
    fill(plane, field, circle(heart, 0.19 * size), bands([(0.1, 0.95)], 0.1))
    for i in range(6):
        fill(plane, field, circle(heart + polar(0.1 * size, PI / 3 * i), 0.035 * size),
             lambda d, x, y: np.full(d.shape, 0.9))
