"""Value noise, reproducible: its lattices come from numpy's frozen generator RandomState."""
import numpy as np


def lattice(seed, rows, columns):
    return np.random.RandomState(seed).random_sample((rows, columns)).astype(np.float32)


def _weights(count, cells):
    """Of each pixel's middle: the lattice line before it and the smooth weight of the one after."""
    at = (np.arange(count, dtype=np.float32) + 0.5) * float(cells / count)
    line = np.floor(at)
    t = at - line
    return line.astype(np.int64), t * t * t * (t * (t * 6 - 15) + 10)


def grid(seed, shape, cells_y, cells_x, wraps=False):
    """Noise in [0, 1] over an image; where it wraps, cells_x must be whole, and left and right edge fit together."""
    rows, row_weights = _weights(shape[0], cells_y)
    columns, column_weights = _weights(shape[1], cells_x)
    table = lattice(seed, int(rows[-1]) + 2, int(columns[-1]) + 2)
    if wraps:
        table[:, int(cells_x)] = table[:, 0]
    lines = table[rows] + (table[rows + 1] - table[rows]) * row_weights[:, None]
    left = lines[:, columns]
    return left + (lines[:, columns + 1] - left) * column_weights[None, :]


def fbm(seed, shape, cells_y, cells_x, octaves, gain=0.5, wraps=False):
    """Octaves of grid(), each twice as fine as the one before; in [0, 1] with mean 1/2."""
    total, amplitude, weight = None, 1.0, 0.0
    for octave in range(octaves):
        fine = 2**octave
        layer = grid(seed + 101 * octave, shape, cells_y * fine, cells_x * fine, wraps) * amplitude
        total = layer if total is None else total + layer
        weight += amplitude
        amplitude *= gain
    return total * (1 / weight)


def at(seed, y, x):
    """Noise in [0, 1] at arrays of places, repeating after 256 units."""
    table = lattice(seed, 256, 256)
    line_y, line_x = np.floor(y), np.floor(x)
    ty, tx = y - line_y, x - line_x
    ty, tx = ty * ty * (3 - 2 * ty), tx * tx * (3 - 2 * tx)
    iy, ix = line_y.astype(np.int64) & 255, line_x.astype(np.int64) & 255
    jy, jx = (iy + 1) & 255, (ix + 1) & 255
    near = table[iy, ix] + (table[iy, jx] - table[iy, ix]) * tx
    far = table[jy, ix] + (table[jy, jx] - table[jy, ix]) * tx
    return near + (far - near) * ty
