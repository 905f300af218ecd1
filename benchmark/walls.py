#!/usr/bin/env python3
"""Gives `dsc` random sets of solids that share walls, and compares volumes and centers with those of the solids.

boxes   two to four boxes in a row, whose faces are divided n x n with random diagonals (n up to 20); each shares a wall
        with the next one, or a part of it
file    the same boxes in one file, as objects or as one surface with walls
layers  two to ten layers with plane, tilted or folded walls, each divided in another way
gears   two gears that touch along the flanks of a tooth
nested  a ball in a box in a box, which may share a wall, in separate files, as objects of a file or as one surface
foams   Voronoi cells, each with its own triangles: edges are divided, and faces are fans around random points

Most sets are turned and moved. Prints a line for each set, the ten largest errors, and a row of a table. Ends with status
1 if a set is refused or wrong.

    benchmark/walls.py build/dsc boxes --sets 400
    benchmark/walls.py build/dsc foams --sets 5 --cells 60
"""

import math
import sys

import cad_solids
import numpy as np
import solid_sets


def placed(solids, numbers):
    """Returns solids that are mostly turned and moved."""
    turn = cad_solids.rotation(numbers) if numbers.random() < 0.75 else np.eye(3)
    shift = numbers.choice([0, 1 / 3, 2 / 7, 0.1, 10], 3)
    return [cad_solids.moved(solid, turn, shift) for solid in solids]


def boxes(numbers, _):
    """Returns boxes in a row."""
    size = numbers.choice([1, 1 / 3, 3 / 7, 2, 0.9], 3)
    bounds = [((0, 0, 0), tuple(size))]
    for _ in range(numbers.choice([1, 1, 1, 2, 3])):
        x, width = bounds[-1][1][0], numbers.choice([1, 1 / 3, 3 / 7, 0.7])
        low, high = [(0, 1), (1 / 3, 5 / 7), (-1 / 3, 5 / 7)][numbers.choice(3, p=[0.5, 0.25, 0.25])]
        bounds.append(((x, low * size[1], low * size[2]), (x + width, high * size[1], high * size[2])))
    return solid_sets.separate(placed([cad_solids.divided_box(*b, [numbers.integers(1, 21)] * 3, numbers) for b in bounds],
                                      numbers))  # fmt: skip


def boxes_of_file(numbers, _):
    """Returns boxes in a row, as objects of a file or as one surface."""
    result = boxes(numbers, _)
    result.files = [(numbers.choice(["0.obj", "0.off"]), result.solids())]
    return result


def layers(numbers, _):
    """Returns layers of a unit square; their walls are z = a + b x + c y or z = a + b |x - 1/2| + c y."""
    count = numbers.integers(2, 11)
    kind = numbers.choice(["plane", "tilted", "folded"])
    heights = np.cumsum(numbers.choice([0.03, 0.1, 1 / 3, 1 / 7], count + 1))
    slopes = numbers.uniform(-0.02, 0.02, (count + 1, 2)) if kind != "plane" else np.zeros((count + 1, 2))
    heights += 0.06 * np.arange(count + 1)  # more than the slopes take away
    solids = []
    for k in range(count):
        n = numbers.integers(1, 9, 2)
        points, triangles = cad_solids.divided_box((0, 0, 0), (1, 1, 1), [2 * n[0], n[1], numbers.integers(1, 4)], numbers)
        x, y, z = points.T
        shape = abs(x - 0.5) if kind == "folded" else x
        walls = [heights[i] + slopes[i, 0] * shape + slopes[i, 1] * y for i in (k, k + 1)]
        solids.append((np.stack([x, y, (1 - z) * walls[0] + z * walls[1]], 1), triangles))
    return solid_sets.separate(placed(solids, numbers))


def repeated(tooth, number):
    """Returns the outline of a gear."""
    angles = 2 * math.pi / number * np.arange(number)
    turns = np.array([[np.cos(angles), np.sin(angles)], [-np.sin(angles), np.cos(angles)]])
    return [tuple(p) for p in np.einsum("pk,kin->npi", np.array(tooth), turns).reshape(-1, 2)]


def gears(numbers, _):
    """Returns two gears of module 1. A tooth of the second one fills a gap of the first one, or touches one flank of it."""
    n, m = numbers.integers(16, 25, 2)
    a, b, slope = n / 2, m / 2, math.tan(math.radians(10))
    flank = np.array([(a + h, 0.8 - slope * h) for h in (-0.6, 0.4)])  # of a tooth around the x-axis
    t = math.pi / n  # the first gear has a gap at the x-axis
    turn = np.array([[math.cos(t), math.sin(t)], [-math.sin(t), math.cos(t)]])
    first = repeated([*(flank * [1, -1]) @ turn, *flank[::-1] @ turn], n)
    (x0, y0), (x1, y1) = (flank * [1, -1]) @ turn  # the upper flank of the gap
    play = numbers.choice([0, 0.1, 0.2])
    heights = [y0 + (y1 - y0) * (x - x0) / (x1 - x0) - play for x in (a - 0.4, a + 0.6)]
    tooth = np.array([(b - 0.6, heights[1]), (b + 0.4, heights[0])])
    second = [(-x, -y) for x, y in repeated([*(tooth * [1, -1]), *tooth[::-1]], m)]
    thickness, other, shift = numbers.choice([1, 1 / 3, 3, 2.5], 3)
    solids = [cad_solids.extruded_star(first, thickness), cad_solids.extruded_star(second, other)]
    solids[1] = cad_solids.moved(solids[1], np.eye(3), (a + b, play, numbers.choice([0, -shift / 2 * other])))
    return solid_sets.separate(placed([cad_solids.subdivided(s, numbers.integers(1, 4)) for s in solids], numbers))


def nested(numbers, _):
    """Returns a ball in a box in a box. As one surface, they bound one solid with a cavity."""
    kind = numbers.choice(["files", "objects", "surface"])
    wall = 0 if numbers.random() < 0.5 and kind != "surface" else numbers.choice([0.1, 1 / 7])
    outer = cad_solids.divided_box((0, 0, 0), (1, 1.2, 1.4), numbers.integers(1, 8, 3), numbers)
    inner = cad_solids.divided_box((wall, 0.2, 0.2), (0.8, 1, 1), numbers.integers(1, 8, 3), numbers)
    ball = cad_solids.moved(cad_solids.ball(0.25, numbers.integers(3, 13)), cad_solids.rotation(numbers), (0.45, 0.6, 0.6))
    solids = placed([outer, inner, ball], numbers)
    whole = [cad_solids.moments(s) for s in solids]
    if kind == "surface":
        return solid_sets.Set([("0.off", solids)], [whole[0] - whole[1] + whole[2]])
    parts = [whole[0] - whole[1], whole[1] - whole[2], whole[2]]
    order = numbers.permutation(3)
    solids, parts = [solids[i] for i in order], [parts[i] for i in order]
    if kind == "objects":
        return solid_sets.Set([("0.obj", solids)], parts)
    return solid_sets.Set([(f"{i}.off", [s]) for i, s in enumerate(solids)], parts)


def cut(faces, normal, offset):
    """Cuts a convex polyhedron by the half-space normal * x <= offset."""
    result, on_plane = [], []
    for face in faces:
        heights = [normal @ p - offset for p in face]
        kept = []
        for i, p in enumerate(face):
            q, h, k = face[(i + 1) % len(face)], heights[i], heights[(i + 1) % len(face)]
            if h <= 0:
                kept.append(p)
            if h * k < 0:
                kept.append(p + (q - p) * (h / (h - k)))
                on_plane.append(kept[-1])
        if len(kept) >= 3:
            result.append(kept)
    if len(on_plane) >= 3:
        middle = np.mean(on_plane, 0)
        first = on_plane[0] - middle
        other = np.cross(normal, first)
        angles = [np.arctan2((p - middle) @ other / np.linalg.norm(normal), (p - middle) @ first) for p in on_plane]
        cap = [on_plane[i] for i in np.argsort(angles)]
        result.append([p for i, p in enumerate(cap) if np.linalg.norm(p - cap[i - 1]) > 1e-12])
    return result


def triangulate(faces, numbers):
    """Divides the edges of a convex polyhedron, and returns fans around random points of its faces."""
    points, triangles, edges, n = [], [], {}, numbers.integers(1, 5)

    def index(p):
        for i, q in enumerate(points):
            if np.linalg.norm(p - q) < 1e-11:
                return i
        points.append(p)
        return len(points) - 1

    for face in faces:
        corners = [index(p) for p in face]
        corners = [c for i, c in enumerate(corners) if c != corners[i - 1]]
        if len(corners) < 3:
            continue
        ring = []
        for i, a in enumerate(corners):
            b = corners[(i + 1) % len(corners)]
            key = (min(a, b), max(a, b))
            if key not in edges:
                p, q = points[key[0]], points[key[1]]
                edges[key] = list(range(len(points), len(points) + n - 1))
                points.extend(p + (q - p) * k / n for k in range(1, n))
            ring += [a] + (edges[key] if a < b else edges[key][::-1])
        weights = numbers.random(len(corners)) + 0.2
        points.append(weights @ np.array([points[c] for c in corners]) / weights.sum())
        triangles += [(len(points) - 1, a, ring[(i + 1) % len(ring)]) for i, a in enumerate(ring)]
    points, triangles = np.array(points), np.array(triangles)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    is_inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), a - points.mean(0)) < 0
    triangles[is_inward] = triangles[is_inward][:, ::-1]
    return points, triangles


def foams(numbers, cells):
    """Returns the Voronoi cells of random points in a cube."""
    seeds, solids = numbers.random((cells, 3)), []
    corners = np.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)], float)
    sides = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    for seed in seeds:
        faces = [[corners[i] for i in side] for side in sides]
        for other in seeds[np.argsort(((seeds - seed) ** 2).sum(1))][1:]:
            normal = other - seed
            faces = cut(faces, normal, normal @ (seed + other) / 2)
        solids.append(triangulate(faces, numbers))
    return solid_sets.separate(placed(solids, numbers))


def main():
    kinds = {"boxes": boxes, "file": boxes_of_file, "layers": layers, "gears": gears, "nested": nested, "foams": foams}
    parser = solid_sets.parser(__doc__)
    parser.add_argument("kind", choices=kinds)
    parser.add_argument("--cells", type=int, default=60, help="cells of a foam")
    arguments = parser.parse_args()
    make = lambda number: kinds[arguments.kind](np.random.default_rng(number), arguments.cells)
    sys.exit(not solid_sets.check(arguments.kind, make, arguments))


if __name__ == "__main__":
    main()
