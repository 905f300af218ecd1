#!/usr/bin/env python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares offsets of polygons by `dsc offset` with buffers of Shapely.

    plane_corners.py DSC [--random N --seed S]

DSC is the program `dsc`. Prints a table of known shapes, or with --random the worst of N random shapes.
Needs the Debian package python3-shapely.
"""
import argparse
import math
import random
import subprocess
import tempfile
from pathlib import Path

import shapely.affinity
import shapely.ops
import shapely.wkt
from shapely.geometry import LineString, MultiPolygon, Point, Polygon, box

QUAD = 64  # segments of Shapely's quarter circles
MITER_LIMIT = 4  # the default of the program


def star(tips=5, inner=0.4):
    return Polygon([((1, inner)[i % 2] * math.cos(math.pi * i / tips), (1, inner)[i % 2] * math.sin(math.pi * i / tips))
                    for i in range(2 * tips)])


def koch(level):
    points = [(0, 0), (0.5, math.sqrt(3) / 2), (1, 0)]
    for _ in range(level):
        finer = []
        for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
            dx, dy = (bx - ax) / 3, (by - ay) / 3
            tip = (ax + 1.5 * dx - math.sqrt(3) / 2 * dy, ay + 1.5 * dy + math.sqrt(3) / 2 * dx)
            finer += [(ax, ay), (ax + dx, ay + dy), tip, (ax + 2 * dx, ay + 2 * dy)]
        points = finer
    return Polygon(points)


def comb(teeth=8):
    return shapely.ops.unary_union([box(0, 0, 2 * teeth - 1, 1)] + [box(2 * i, 0, 2 * i + 1, 4) for i in range(teeth)])


def glyphs():
    """Letters with holes, corners and curves."""
    stroke = 0.22
    a = LineString([(0, 0), (0.5, 1.4), (1, 0)]).buffer(stroke / 2, cap_style=2, join_style=2)
    a = a.union(LineString([(0.2, 0.45), (0.8, 0.45)]).buffer(stroke / 2, cap_style=2))
    b = box(1.5, 0, 1.5 + stroke, 1.4)
    for middle, radius in ((0.4, 0.4), (1.05, 0.35)):
        bow = Point(1.7, middle).buffer(radius, 12).difference(Point(1.7, middle).buffer(radius - stroke, 12))
        b = b.union(bow.intersection(box(1.6, -1, 3, 3)))
    e = box(2.7, 0, 2.7 + stroke, 1.4)
    for y in (0, 0.6, 1.4 - stroke):
        e = e.union(box(2.7, y, 3.5, y + stroke))
    o = Point(4.5, 0.7).buffer(0.7, 16).difference(Point(4.5, 0.7).buffer(0.7 - stroke, 16))
    x = LineString([(5.5, 0), (6.5, 1.4)]).buffer(stroke / 2, cap_style=2)
    x = x.union(LineString([(5.5, 1.4), (6.5, 0)]).buffer(stroke / 2, cap_style=2))
    return shapely.ops.unary_union([a, b, e, o, x])


def circles(number=200, seed=1):
    """Circles that may overlap."""
    rng = random.Random(seed)
    return shapely.ops.unary_union([Point(10 * rng.random(), 10 * rng.random()).buffer(0.15 + 0.3 * rng.random(), 8)
                                    for _ in range(number)])


def random_shape(rng):
    """Unions and differences of rectangles, triangles, stars, circles and strokes, turned by any angle."""
    result = Polygon()
    for i in range(rng.randint(1, 7)):
        kind = rng.randrange(5)
        if kind == 0:
            part = box(0, 0, 0.2 + 2 * rng.random(), 0.2 + 2 * rng.random())
        elif kind == 1:
            part = Polygon([(0, 0), (0.3 + 2 * rng.random(), 0), (2 * rng.random(), 0.3 + 2 * rng.random())])
        elif kind == 2:
            part = star(rng.randint(3, 9), 0.25 + 0.6 * rng.random())
        elif kind == 3:
            part = Point(0, 0).buffer(0.2 + rng.random(), rng.randint(3, 20))
        else:
            part = LineString([(2 * rng.random(), 2 * rng.random()) for _ in range(3)])
            part = part.buffer(0.1 + 0.2 * rng.random(), cap_style=2, join_style=2)
        part = shapely.affinity.rotate(part, 360 * rng.random(), origin=(0, 0))
        part = shapely.affinity.translate(part, 3 * rng.random(), 3 * rng.random())
        result = result.difference(part) if i > 1 and rng.random() < 0.3 else result.union(part)
    # parts that nearly touch themselves are another test
    clean = result.buffer(-0.02, join_style=2).buffer(0.02, join_style=2)
    return clean if not clean.is_empty else box(0, 0, 1, 1)


def polygons(shape):
    return list(shape.geoms) if isinstance(shape, MultiPolygon) else [] if shape.is_empty else [shape]


def sharpest(shape, sign):
    """Largest ratio of a mitered vertex's displacement and the distance, at corners from which the front moves away."""
    result = 1
    for p in polygons(shape):
        for ring, side in [(p.exterior, 1)] + [(r, -1) for r in p.interiors]:
            c = list(ring.coords)[:-1]
            turn_left = 1 if ring.is_ccw else -1
            for a, b, d in zip(c[-1:] + c[:-1], c, c[1:] + c[:1]):
                u, v = (b[0] - a[0], b[1] - a[1]), (d[0] - b[0], d[1] - b[1])
                turn = math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]) * turn_left * side * sign
                if turn > 0:
                    result = max(result, 1 / max(math.cos(turn / 2), 1e-9))
    return result


def count(shape):
    """Numbers of components and holes."""
    parts = polygons(shape)
    return len(parts), sum(len(p.interiors) for p in parts)


def rings(shape):
    return [ring for p in polygons(shape) for ring in (p.exterior, *p.interiors)]


def mean_edge(shape):
    edges = [math.dist(a, b) for r in rings(shape) for a, b in zip(r.coords, r.coords[1:])]
    return sum(edges) / len(edges)


def hausdorff(a, b, step):
    """Distance of the boundaries, both ways, at points of a distance `step`."""
    def one_way(of, to):
        line = shapely.geometry.MultiLineString(rings(to))
        return max((line.distance(r.interpolate(step * k)) for r in rings(of) for k in range(int(r.length / step) + 1)),
                   default=0)
    if a.is_empty or b.is_empty:
        return 0 if a.is_empty and b.is_empty else math.inf
    return max(one_way(a, b), one_way(b, a))


def buffer(shape, distance, corners):
    if corners == "round":
        return shape.buffer(distance, QUAD)
    return shape.buffer(distance, join_style=2, mitre_limit=MITER_LIMIT)


def offset(dsc, shape, distance, steps, segments, corners, *options):
    """Returns the input as `dsc` divided it, the result, and what the program printed."""
    with tempfile.TemporaryDirectory() as folder:
        wkt = Path(folder, "shape.wkt")
        wkt.write_text(shapely.wkt.dumps(shape, rounding_precision=16))
        command = [dsc, "offset", wkt, f"--distance={distance / steps!r}", "--steps", str(steps), "--corners", corners,
                   "--output", Path(folder, "out"), "--every", str(steps), *options]
        if segments:
            command += ["--segments", str(segments)]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            return None, f"status {run.returncode}: {run.stderr.strip().splitlines()[-1] if run.stderr else ''}"
        result = Path(folder, "result.wkt")
        subprocess.run([dsc, "convert", Path(folder, "out", "checkpoint.dsc"), result, "--quiet"], check=True)
        text = result.read_text().strip()
        found = shapely.wkt.loads(text) if text else Polygon()
        notes = [line.removeprefix("dsc: ") for line in run.stdout.splitlines() + run.stderr.splitlines()
                 if "explain" in line or "vanish" in line]
        return found, "; ".join(notes)


class Row:
    def __init__(self, dsc, name, shape, distance, steps, segments, corners):
        self.name = f"{name} by {distance:g}, {corners}, {steps} steps"
        exact = buffer(shape, distance, corners)
        self.exact, self.exact_count = exact.area, count(exact)
        found, self.note = offset(dsc, shape, distance, steps, segments, corners)
        self.failed = found is None
        if self.failed:
            self.area = self.distance = math.nan
            self.count = (0, 0)
            return
        self.area, self.count = found.area, count(found)
        edge = shape.length / segments if segments else mean_edge(shape)
        self.distance = hausdorff(found, exact, edge / 8) / edge

    @property
    def error(self):
        return 100 * (self.area / self.exact - 1) if self.exact else math.inf if self.area else 0

    @property
    def is_bad(self):
        return self.failed or abs(self.error) > 0.1 or self.distance > 0.5 or self.count != self.exact_count

    def __str__(self):
        return (f"| {self.name} | {self.area:.6g} | {self.exact:.6g} | {self.error:+.3f} % | {self.distance:.2f} | "
                f"{self.count[0]}, {self.count[1]} | {self.exact_count[0]}, {self.exact_count[1]} | {self.note} |")


HEAD = """| shape | area | Shapely | difference | Hausdorff distance in edges | components, holes | Shapely | message |
| --- | ---: | ---: | ---: | ---: | --- | --- | --- |"""


def known(dsc):
    shapes = [("star", star(), 250, 0.1), ("Koch 3", koch(3), 768, 0.01), ("Koch 4", koch(4), 3072, 0.004),
              ("comb", comb(), 800, 0.2), ("glyphs", glyphs(), 900, 0.05), ("200 circles", circles(), 6000, 0.05)]
    print(HEAD)
    for name, shape, segments, distance in shapes:
        for corners in ("round", "miter"):
            for signed in (distance, -distance):
                for steps in (1, 10):
                    print(Row(dsc, name, shape, signed, steps, segments, corners), flush=True)


def several(dsc, number, seed):
    rows = []
    for i in range(number):
        rng = random.Random(1000 * seed + i)
        shape = random_shape(rng)
        distance = (0.02 + 0.2 * rng.random()) * rng.choice((-1, 1))
        corners = rng.choice(("round", "miter"))
        while sharpest(shape, math.copysign(1, distance)) > MITER_LIMIT:  # Shapely cuts off such corners otherwise
            shape = random_shape(rng)
        segments = rng.choice((0, 200, 600, 1500))
        rows.append(Row(dsc, f"{i}, {segments} segments", shape, distance, rng.choice((1, 3, 10)), segments,
                        corners))
    bad = [row for row in rows if row.is_bad]
    print(f"{number} offsets of random shapes, seed {seed}: {len(bad)} miss a bound, "
          f"{sum(not row.note for row in bad)} of them without a message")
    print(HEAD)
    for row in sorted(rows, key=lambda r: (not r.failed, r.count == r.exact_count, -abs(r.error)))[:30]:
        print(row)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dsc")
    parser.add_argument("--random", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    if arguments.random:
        several(arguments.dsc, arguments.random, arguments.seed)
    else:
        known(arguments.dsc)
