#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/line-encoder.svg from the file of test_master_lag; see line-encoder.md."""
import csv
import sys

WIDTH, LEFT, RIGHT = 1000, 70, 980
SPEED_TOP, SPEED_HEIGHT = 40, 120
LAG_TOP, LAG_HEIGHT = 220, 240
LAG_STEP = 0.1
SERIES = [("without_mm", "#9aa7b5", "without the lead"), ("with_mm", "#0b62a4", "with it")]


def grid(y, label):
    yield f'<path d="M{LEFT} {y:.1f}H{RIGHT}" stroke="#d7dce2"/>'
    yield f'<text x="{LEFT - 8}" y="{y + 5:.1f}" font-size="13" text-anchor="end">{label}</text>'


def curve(rows, end, color, width, place):
    points = " ".join(f"{LEFT + row['time_s'] / end * (RIGHT - LEFT):.1f},{place(row):.1f}" for row in rows)
    return f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="{width}"/>'


def speed_panel(rows, end):
    most = 500 * -(-max(row["line_mm_per_s"] for row in rows) // 500)
    yield f'<text x="{LEFT}" y="24" font-size="17" font-weight="600">Speed of the line, mm/s</text>'
    for step in range(4):
        yield from grid(SPEED_TOP + SPEED_HEIGHT * (1 - step / 3), f"{most * step / 3:.0f}")
    yield curve(rows, end, "#20262d", 1.5, lambda row: SPEED_TOP + SPEED_HEIGHT * (1 - row["line_mm_per_s"] / most))


def lag_panel(rows, end):
    values = [row[key] for row in rows for key, _, _ in SERIES]
    low, high = int(min(values) // LAG_STEP), int(-(-max(values) // LAG_STEP))

    def place(value):
        return LAG_TOP + LAG_HEIGHT * (high - value / LAG_STEP) / (high - low)

    yield f'<text x="{LEFT}" y="{LAG_TOP - 16}" font-size="17" font-weight="600">Line ahead of the knife, mm</text>'
    for step in range(low, high + 1):
        yield from grid(place(step * LAG_STEP), f"{step * LAG_STEP:.1f}")
    for index, (key, color, label) in enumerate(SERIES):
        yield curve(rows, end, color, 1.5, lambda row, key=key: place(row[key]))
        yield f'<text x="{RIGHT - 260 + 160 * index}" y="{LAG_TOP - 16}" font-size="15" fill="{color}">{label}</text>'


def main():
    with open(sys.argv[1], newline="") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    end = rows[-1]["time_s"]
    height = LAG_TOP + LAG_HEIGHT + 40
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
          'font-family="sans-serif" fill="#20262d">')
    print('<rect width="100%" height="100%" fill="white"/>')
    print("\n".join([*speed_panel(rows, end), *lag_panel(rows, end)]))
    for half in range(int(2 * end) + 1):
        x = LEFT + half / 2 / end * (RIGHT - LEFT)
        print(f'<text x="{x:.1f}" y="{height - 14}" font-size="13" text-anchor="middle">{half / 2:g} s</text>')
    print("</svg>")


main()
