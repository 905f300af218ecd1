#!/usr/bin/env python3
"""Gives `dsc` random sets of solids that share walls, and compares volumes with those of the input files.

Boxes: two to four boxes in a row, whose faces are divided n x n with random diagonals (n up to 20), mostly turned and moved.
Foams: Voronoi cells, each with its own triangles: edges are divided, and faces are fans around random points.
Prints a line for each wrong or refused set, and the ten sets with the largest errors.

    benchmark/walls.py build/dsc boxes --sets 400
    benchmark/walls.py build/dsc foams --sets 5 --cells 60
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

import numpy as np


def rotation(numbers):
    """Returns a random rotation."""
    q, r = np.linalg.qr(numbers.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q[[1, 0, 2]]


def box(low, high, n, numbers):
    """Returns points and triangles of a box whose faces are divided n x n."""
    points, triangles, known = [], [], {}
    low, high = np.array(low, float), np.array(high, float)

    def index(place):
        if place not in known:
            known[place] = len(points)
            points.append(low + (high - low) * np.array(place) / n)
        return known[place]

    for axis in range(3):
        for end in (0, n):
            for i in range(n):
                for j in range(n):
                    corners = []
                    for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        place = [0, 0, 0]
                        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = end, u, v
                        corners.append(index(tuple(place)))
                    a, b, c, d = corners if end else corners[::-1]
                    triangles += [(a, b, c), (a, c, d)] if numbers.random() < 0.5 else [(a, b, d), (b, c, d)]
    return np.array(points), np.array(triangles)


def boxes(numbers, _):
    """Returns two to four boxes; each shares a wall with the next one, or a part of it."""
    size = numbers.choice([1, 1 / 3, 3 / 7, 2, 0.9], 3)
    bounds = [((0, 0, 0), tuple(size))]
    for _ in range(numbers.choice([1, 1, 1, 2, 3])):
        x, width = bounds[-1][1][0], numbers.choice([1, 1 / 3, 3 / 7, 0.7])
        low, high = [(0, 1), (1 / 3, 5 / 7), (-1 / 3, 5 / 7)][numbers.choice(3, p=[0.5, 0.25, 0.25])]
        bounds.append(((x, low * size[1], low * size[2]), (x + width, high * size[1], high * size[2])))
    turn = rotation(numbers) if numbers.random() < 0.75 else np.eye(3)
    shift = numbers.choice([0, 1 / 3, 2 / 7, 0.1, 10], 3)
    solids = []
    for low, high in bounds:
        points, triangles = box(low, high, numbers.integers(1, 21), numbers)
        solids.append((points @ turn.T + shift, triangles))
    return solids


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
    seeds, turn, solids = numbers.random((cells, 3)), rotation(numbers), []
    corners = np.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)], float)
    sides = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    for seed in seeds:
        faces = [[corners[i] for i in side] for side in sides]
        for other in seeds[np.argsort(((seeds - seed) ** 2).sum(1))][1:]:
            normal = other - seed
            faces = cut(faces, normal, normal @ (seed + other) / 2)
        points, triangles = triangulate(faces, numbers)
        solids.append((points @ turn.T, triangles))
    return solids


def volume(points, triangles):
    """Returns the volume inside an oriented surface."""
    a, b, c = (points[triangles[:, i]] - points.mean(0) for i in range(3))
    return abs(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def run(program, folder, solids, form):
    """Writes the solids, runs the program, and returns the largest relative error of a volume, or a message."""
    paths = []
    for i, (points, triangles) in enumerate(solids):
        paths.append(folder / f"{i}.off")
        with open(paths[-1], "w", encoding="ascii") as file:
            file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
            file.writelines(" ".join(form % x for x in p) + "\n" for p in points)
            file.writelines(f"3 {a} {b} {c}\n" for a, b, c in triangles)
    report = folder / "report.json"
    motion = ["--axis", "0,0,1", "--angle", "5", "--steps", "1", "--quiet", "--report", report]
    command = [program, "rotate", *paths, *motion]
    outcome = subprocess.run(command, capture_output=True, text=True, check=False)
    if outcome.returncode != 0:
        return outcome.stderr.strip()
    labels = {entry["label"]: entry["volume"] for entry in json.loads(report.read_text())["steps"][0]["labels"]}
    return max(abs(labels.get(i + 1, 0) / volume(*solid) - 1) for i, solid in enumerate(solids))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("kind", choices=["boxes", "foams"])
    parser.add_argument("--sets", type=int, default=20)
    parser.add_argument("--cells", type=int, default=60, help="cells of a foam")
    parser.add_argument("--first", type=int, default=0, help="number of the first set")
    parser.add_argument("--format", default="%.17g", help="format of coordinates")
    parser.add_argument("--tolerance", type=float, default=1e-9, help="of volumes")
    arguments = parser.parse_args()
    make = {"boxes": boxes, "foams": foams}[arguments.kind]
    errors, refused = [], 0
    for number in range(arguments.first, arguments.first + arguments.sets):
        solids = make(np.random.default_rng(number), arguments.cells)
        with tempfile.TemporaryDirectory() as folder:
            result = run(arguments.program, pathlib.Path(folder), solids, arguments.format)
        if isinstance(result, str):
            refused += 1
            print(f"set {number}: {result}")
        else:
            errors.append((result, number))
    errors.sort(reverse=True)
    wrong = sum(error > arguments.tolerance for error, _ in errors)
    print(f"{arguments.sets} sets, {refused} refused, {wrong} wrong; largest errors of volumes:")
    for error, number in errors[:10]:
        print(f"  set {number}: {error:.2g}")


if __name__ == "__main__":
    main()
