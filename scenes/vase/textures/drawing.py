"""A plane of pixels with lengths of its own, strokes and polygons on it, and PNG files."""
import struct
import zlib

import numpy as np

import exact


class Plane:
    """The rectangle [0, width] x [0, height], y up, as an image; what is drawn over one side comes in at the other if
    it wraps."""

    def __init__(self, width, height, columns, rows, wraps=False):
        self.width, self.height, self.wraps = float(width), float(height), wraps
        self.shape = (rows, columns)
        self.pixel = float(width / columns)
        self.x = (np.arange(columns) + 0.5) * (self.width / columns)
        self.y = self.height - (np.arange(rows) + 0.5) * (self.height / rows)

    def field(self, value=0.0):
        return np.full(self.shape, value, np.float32)

    def coordinates(self):
        """x as a row and y as a column, in single precision."""
        return self.x.astype(np.float32)[None, :], self.y.astype(np.float32)[:, None]

    def windows(self, x0, y0, x1, y1):
        """Parts of the image under a rectangle: index, x as a row, y as a column."""
        rows, columns = self.shape
        down = rows / self.height
        top = max(0, int((self.height - y1) * down) - 1)
        bottom = min(rows, int((self.height - y0) * down) + 2)
        for shift in (-self.width, 0.0, self.width) if self.wraps else (0.0,):
            left = max(0, int((x0 + shift) / self.pixel) - 1)
            right = min(columns, int((x1 + shift) / self.pixel) + 2)
            if left < right and top < bottom:
                yield np.s_[top:bottom, left:right], self.x[None, left:right] - shift, self.y[top:bottom, None]


def stroke(plane, field, points, radii, value=1.0):
    """A line of changing thickness with round ends; darkens what is lighter."""
    for i in range(len(points) - 1):
        (ax, ay), (bx, by) = (float(c) for c in points[i]), (float(c) for c in points[i + 1])
        ra, rb = float(radii[i]), float(radii[i + 1])
        reach = max(ra, rb) + plane.pixel
        dx, dy = bx - ax, by - ay
        length2 = max(dx * dx + dy * dy, 1e-12)
        for index, x, y in plane.windows(min(ax, bx) - reach, min(ay, by) - reach, max(ax, bx) + reach,
                                         max(ay, by) + reach):
            t = np.clip(((x - ax) * dx + (y - ay) * dy) * (1 / length2), 0.0, 1.0)
            ex, ey = x - ax - t * dx, y - ay - t * dy
            distance = np.sqrt(ex * ex + ey * ey) - (ra + (rb - ra) * t)
            cover = np.clip(0.5 - distance * (1 / plane.pixel), 0.0, 1.0) * value
            field[index] = np.maximum(field[index], cover)


def line(plane, field, points, radius, value=1.0):
    stroke(plane, field, points, [radius] * len(points), value)


def polygon_distance(points, x, y):
    """Signed distance to a closed polygon, negative inside."""
    nearest = np.full(np.broadcast(x, y).shape, 1e30)
    inside = np.zeros(nearest.shape, bool)
    for i, (bx, by) in enumerate(points):
        ax, ay = points[i - 1]
        dx, dy = bx - ax, by - ay
        length2 = max(dx * dx + dy * dy, 1e-18)
        t = np.clip(((x - ax) * dx + (y - ay) * dy) * (1 / length2), 0.0, 1.0)
        ex, ey = x - ax - t * dx, y - ay - t * dy
        nearest = np.minimum(nearest, ex * ex + ey * ey)
        if ay != by:
            inside ^= ((y < ay) != (y < by)) & (x < ax + (y - ay) * (dx / dy))
    return np.where(inside, -1.0, 1.0) * np.sqrt(nearest)


def fill(plane, field, points, shade):
    """Paints a polygon over what is there; shade(depth, x, y) is its value, `depth` the distance to its edge."""
    points = [(float(px), float(py)) for px, py in points]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    for index, x, y in plane.windows(min(xs), min(ys), max(xs), max(ys)):
        distance = polygon_distance(points, x, y)
        cover = np.clip(0.5 - distance * (1 / plane.pixel), 0.0, 1.0)
        field[index] = field[index] + (shade(-distance, x, y) - field[index]) * cover


def blurred(field, reach, wraps=False):
    """Means over squares of 2 reach + 1 pixels, twice: nearly a Gaussian."""
    for _ in range(2):
        for axis in (0, 1):
            pad = [(0, 0), (0, 0)]
            pad[axis] = (reach, reach)
            padded = np.pad(field, pad, mode="wrap" if wraps and axis == 1 else "edge")
            size = field.shape[axis]
            total = np.zeros_like(field)
            for shift in range(2 * reach + 1):
                total += padded[shift:shift + size] if axis == 0 else padded[:, shift:shift + size]
            field = total * (1 / (2 * reach + 1))
    return field


def pigmented(ground, layers):
    """Linear RGB of a ground under pigments, each a field of densities and its absorption of red, green and blue."""
    channels = []
    for c in range(3):
        depth = sum(field * float(absorption[c]) for field, absorption in layers)
        channels.append(exact.exp(-depth) * ground[c])
    return np.stack(channels, axis=-1)


def srgb(linear):
    """sRGB's curve: x^(1 / 2.4) is the cube root of x^(5 / 4)."""
    x = np.clip(linear, 0.0, 1.0)
    root = exact.cube_root(np.maximum(x * np.sqrt(np.sqrt(x)), 1e-9))
    return np.where(x < 0.0031308, 12.92 * x, 1.055 * root - 0.055)


def bytes_of(values):
    return (np.clip(values, 0.0, 1.0) * 255 + 0.5).astype(np.uint8)


def write_png(path, pixels):
    """Eight bits, one channel or three; rows are filtered by their differences to the row above."""
    rows = pixels.reshape(pixels.shape[0], -1)
    above = np.vstack([np.zeros_like(rows[:1]), rows[:-1]])
    lines = np.empty((rows.shape[0], rows.shape[1] + 1), np.uint8)
    lines[:, 0] = 2
    lines[:, 1:] = rows - above

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    colour = 2 if pixels.ndim == 3 else 0
    header = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, colour, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines.tobytes(), 3)) +
                     chunk(b"IEND", b""))
