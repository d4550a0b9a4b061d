"""Functions whose bits are the same on every machine.

Pictures made here are compared by checksum. Sums, products, quotients and square roots are exact to the last bit by
IEEE 754; sine, exponential and powers of mathematical libraries are not, so they are made of the former here. All work
on numbers and on arrays; numbers must be Python's own, which leave arrays of single precision in single precision.
"""
import numpy as np

PI = 3.141592653589793


def sin(x):
    """Taylor's series after reduction to [-pi/2, pi/2]; error below 1e-8."""
    turns = np.floor(x * (1 / PI) + 0.5)
    r = x - turns * PI
    r2 = r * r
    series = r * (1 + r2 * (-1 / 6 + r2 * (1 / 120 + r2 * (-1 / 5040 + r2 * (1 / 362880 - r2 * (1 / 39916800))))))
    return series * (1 - 2 * (turns - 2 * np.floor(turns * 0.5)))


def cos(x):
    return sin(x + PI / 2)


def exp(x):
    """(1 + y + ... + y^5 / 120)^64 with y = x / 64, for x from -60 to 10; below it is 0. Relative error below 1e-3."""
    y = np.maximum(x, -60.0) * (1 / 64)
    power = 1 + y * (1 + y * (1 / 2 + y * (1 / 6 + y * (1 / 24 + y * (1 / 120)))))
    for _ in range(6):
        power = power * power
    return power


def cube_root(x):
    """Newton's iteration, for x in [0, 1]."""
    root = 0.35 + 0.65 * x
    for _ in range(12):
        root = root - (root - x / (root * root)) * (1 / 3)
    return root


def smooth(low, high, x):
    """0 below low, 1 above high, smooth between; high may be the lower."""
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3 - 2 * t)


def polar(radius, angle):
    return np.array([radius * float(cos(angle)), radius * float(sin(angle))])
