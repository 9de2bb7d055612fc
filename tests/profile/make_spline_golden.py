#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Makes spline_golden.txt with scipy's CubicSpline, for test_spline.cpp, which needs no scipy itself:
#   python3 make_spline_golden.py > spline_golden.txt
# A case: "case NAME ENDS START_SLOPE END_SLOPE KNOTS POINTS", its knots (x y), its points (x s s' s'' s''').
import math
import random

from scipy.interpolate import CubicSpline

random.seed(20240801)


def spline(ends, xs, ys, slopes):
    if ends == "natural":
        return [CubicSpline(xs, ys, bc_type="natural").derivative(k) for k in range(4)]
    if ends == "clamped":
        return [CubicSpline(xs, ys, bc_type=((1, slopes[0]), (1, slopes[1]))).derivative(k) for k in range(4)]
    # scipy knows closed curves only: the net advance is taken off as a straight line and put back.
    advance = (ys[-1] - ys[0]) / (xs[-1] - xs[0])
    flat = [y - advance * (x - xs[0]) for x, y in zip(xs, ys)]
    flat[-1] = flat[0]
    closed = CubicSpline(xs, flat, bc_type="periodic")
    line = [lambda x: advance * (x - xs[0]), lambda x: advance, lambda x: 0.0, lambda x: 0.0]
    return [lambda x, k=k: float(closed(x, k)) + line[k](x) for k in range(4)]


def random_knots(count, is_closed):
    gaps = [0.2 + random.random() ** 3 for _ in range(count - 1)]
    scale = 360 / sum(gaps)
    xs = [0.0]
    for gap in gaps[:-1]:
        xs.append(round(xs[-1] + gap * scale, 4))
    xs.append(360.0)
    ys = [round(50 * math.sin(x / 40) + random.uniform(-2, 2), 3) for x in xs]
    if is_closed:
        ys[-1] = ys[0]
    return xs, ys


def show(name, ends, xs, ys, slopes=(0.0, 0.0), points=20):
    curves = spline(ends, xs, ys, slopes)
    print("case", name, ends, repr(slopes[0]), repr(slopes[1]), len(xs), points)
    for x, y in zip(xs, ys):
        print(repr(x), repr(y))
    for i in range(points):
        x = xs[0] + (xs[-1] - xs[0]) * (i + 0.37) / points
        print(repr(x), *(repr(float(curve(x))) for curve in curves))


five = ([0.0, 90.0, 180.0, 270.0, 360.0], [0.0, 20.0, 50.0, 20.0, 0.0])
knife = ([0.0, 60.0, 150.0, 200.0, 290.0, 360.0], [0.0, 80.0, 140.0, 230.0, 300.0, 376.991])
for ends in ("natural", "clamped", "periodic"):
    show("five-" + ends, ends, *five)
    show("knife-" + ends, ends, *knife)
    show("hundred-" + ends, ends, *random_knots(100, ends == "periodic"), points=50)
show("slopes-clamped", "clamped", *knife, slopes=(1.5, -0.25))
show("advance-periodic", "periodic", *random_knots(40, False), points=60)
