"""The stripes of the big ball: one row of lacquer colours, each with a soft edge and a fine line of ivory between."""
import numpy as np

import exact
from drawing import bytes_of, srgb

# Linear RGB, from the ball's foot up; the picture repeats.
COLOURS = ((0.36, 0.05, 0.22), (0.60, 0.045, 0.045), (0.78, 0.20, 0.03), (0.85, 0.48, 0.06), (0.42, 0.50, 0.08),
           (0.07, 0.36, 0.20), (0.03, 0.30, 0.42), (0.04, 0.12, 0.40), (0.14, 0.06, 0.32))
IVORY = (0.86, 0.80, 0.66)


def make(scale):
    columns, rows = round(2048 * scale), 4
    at = (np.arange(columns) + 0.5) * (len(COLOURS) / columns)
    stripe = np.floor(at).astype(np.int64)
    inside = at - stripe
    edge = np.minimum(inside, 1 - inside)
    table = np.array(COLOURS)
    # Within a stripe the colour leans towards its neighbours'.
    neighbour = table[(stripe + np.where(inside < 0.5, -1, 1)) % len(COLOURS)]
    lean = (0.4 * exact.smooth(0.5, 0.0, edge))[:, None]
    line = exact.smooth(0.055, 0.035, edge)[:, None]
    colour = table[stripe] * (1 - lean) + neighbour * lean
    colour = colour * (1 - line) + np.array(IVORY) * line
    return {"rainbow.png": bytes_of(srgb(np.broadcast_to(colour, (rows, columns, 3))))}
