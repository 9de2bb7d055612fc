#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/change-of-program.svg from the speeds of a folder; see change-of-program.md."""
import csv
import pathlib
import sys

PANELS = [
    ("250-faster", "250 mm, 60 to 120 bags/min"),
    ("250-to-460", "250 to 460 mm, both at their fastest rate"),
    ("460-to-100", "460 to 100 mm, both at their fastest rate"),
]
WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 1000, 260, 70, 40, 40
SERIES = [("knife_mm_per_s", "#9aa7b5", 1, "knife tip"), ("film_mm_per_s", "#0b62a4", 2.5, "film")]


def panel(folder, name, title, top):
    with open(folder / f"{name}.csv", newline="") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    end = rows[-1]["time_s"]
    most = max(max(row["film_mm_per_s"], row["knife_mm_per_s"]) for row in rows)
    most = 500 * -(-most // 500)
    height = HEIGHT - TOP - BOTTOM

    def at(row, key):
        x = LEFT + row["time_s"] / end * (WIDTH - LEFT - 20)
        return f"{x:.1f},{top + TOP + height * (1 - row[key] / most):.1f}"

    yield f'<text x="{LEFT}" y="{top + 24}" font-size="17" font-weight="600">{title}</text>'
    for step in range(5):
        y = top + TOP + height * (1 - step / 4)
        yield f'<path d="M{LEFT} {y:.1f}H{WIDTH - 20}" stroke="#d7dce2"/>'
        yield f'<text x="{LEFT - 8}" y="{y + 5:.1f}" font-size="13" text-anchor="end">{most * step / 4:.0f}</text>'
    for second in range(int(end) + 1):
        x = LEFT + second / end * (WIDTH - LEFT - 20)
        yield f'<text x="{x:.1f}" y="{top + HEIGHT - 18}" font-size="13" text-anchor="middle">{second} s</text>'
    for key, color, width, _ in SERIES:
        points = " ".join(at(row, key) for row in rows)
        yield f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="{width}"/>'


def main():
    folder = pathlib.Path(sys.argv[1])
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT * len(PANELS)}" '
          'font-family="sans-serif" fill="#20262d">')
    print('<rect width="100%" height="100%" fill="white"/>')
    for index, (name, title) in enumerate(PANELS):
        print("\n".join(panel(folder, name, title, index * HEIGHT)))
    for index, (_, color, _, label) in enumerate(SERIES):
        x = WIDTH - 190 + 95 * index
        print(f'<text x="{x}" y="24" font-size="15" fill="{color}">{label}, mm/s</text>')
    print("</svg>")


main()
