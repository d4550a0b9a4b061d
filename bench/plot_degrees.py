#!/usr/bin/env python3
"""Draws the CSV of `bench_revolution_speed --degrees` as SVG: nanoseconds a ray by degree, both logarithmic.

usage: bench_revolution_speed --degrees | bench/plot_degrees.py > docs/revolution_degrees.svg"""
import csv
import math
import sys

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 720, 460, 70, 30, 120, 60
COLOURS = {"camera ns": "#1b6ca8", "random ns": "#c0392b", "surface ns": "#2e8b57"}


def main():
    rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(sys.stdin)]
    degrees = [row["degree"] for row in rows]
    times = [row[name] for row in rows for name in COLOURS]
    low, high = 10 ** math.floor(math.log10(min(times))), max(times) * 8

    def x(degree):
        return LEFT + (WIDTH - LEFT - RIGHT) * math.log(degree / degrees[0]) / math.log(degrees[-1] / degrees[0])

    def y(ns):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * math.log(ns / low) / math.log(high / low)

    def line(points, style):
        path = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in points)
        print(f'<polyline points="{path}" fill="none" {style}/>')

    def text(at_x, at_y, words, style=""):
        print(f'<text x="{at_x:.1f}" y="{at_y:.1f}" {style}>{words}</text>')

    print(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
          'font-size="12"><rect width="100%" height="100%" fill="white"/>')
    for ns in (m * 10**k for k in range(1, 6) for m in (1, 2, 5)):
        if low <= ns <= high:
            line([(degrees[0], ns), (degrees[-1], ns)], 'stroke="#ddd"')
            text(LEFT - 8, y(ns) + 4, f"{ns}", 'text-anchor="end"')
    for degree in (1, 2, 3, 5, 8, 12, 20, 30):
        line([(degree, low), (degree, high)], 'stroke="#ddd"')
        text(x(degree), HEIGHT - BOTTOM + 18, f"{degree}", 'text-anchor="middle"')
    for name, colour in COLOURS.items():
        line([(row["degree"], row[name]) for row in rows], f'stroke="{colour}" stroke-width="2"')
        text(x(degrees[-1]) + 8, y(rows[-1][name]) + 4, name.split()[0], f'fill="{colour}"')
    # What the bar allows: growth with the square, from where the curves stand at degree 3.
    start = next(row for row in rows if row["degree"] == 3)["random ns"]
    bound = [(d, start * (d / 3) ** 2) for d in degrees if d >= 3 and start * (d / 3) ** 2 <= high]
    line(bound, 'stroke="#555" stroke-dasharray="5 4"')
    text(x(bound[-1][0]) + 6, y(bound[-1][1]) + 12, "n²", 'fill="#555"')
    text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 16, "degree of the profile", 'text-anchor="middle"')
    text(14, TOP - 10, "nanoseconds a ray, closest hit, shape alone, one thread")
    print("</svg>")


if __name__ == "__main__":
    main()
