#!/usr/bin/env python3
"""Reconstructs random sheets by `dsc reconstruct --open`, and verifies each result.

The verification uses only the written triangles: it counts simplices, components and boundaries, and computes the distances
of all points. Prints a row for each kind of sheet, and one line for each wrong result.

    benchmark/sheets.py build/dsc --points 1600 --noise 0.2 --seeds 5
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

import numpy as np

# Euler characteristic, components and boundaries
EXPECTED = {"hole": (0, 1, 2), "moebius": (0, 1, 1), "cylinder": (0, 1, 2), "two": (2, 2, 2)}
KINDS = ("regular", "random", "jittered", "hole", "moebius", "half_ball", "scan", "roof", "cylinder", "roll", "strip",
         "plane", "graded", "two")  # fmt: skip


def points_of(kind, n, noise, numbers):
    """Returns points of a sheet. The noise is in distances of neighbors."""
    side = round(n**0.5)
    step = 2 / (side - 1)
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-1, 1, side)]), -1).reshape(-1, 2)
    jittered = grid + numbers.uniform(-0.4, 0.4, grid.shape) * step
    free = numbers.uniform(-1, 1, (n, 2))
    waves, phases = numbers.uniform(2, 7, (3, 2)), numbers.uniform(0, 6, 3)

    def hills(xy):
        return np.c_[xy, 0.05 * sum(np.sin(xy @ w + p) for w, p in zip(waves, phases))]

    if kind == "regular":
        points = hills(grid)
    elif kind == "random":
        points = hills(free)
    elif kind == "jittered":
        points = hills(jittered)
    elif kind == "hole":
        middle = numbers.uniform(-0.4, 0.4, 2)
        points = hills(jittered[np.hypot(*(jittered - middle).T) > max(0.25, 4 * step)])
    elif kind == "moebius":
        around = round((n * 2 * np.pi / 0.8) ** 0.5)
        step = 2 * np.pi / around
        u, v = (a.ravel() for a in np.meshgrid(np.arange(around) * step, np.linspace(-0.4, 0.4, n // around)))
        u = u + numbers.uniform(-0.3, 0.3, u.shape) * step
        radius = 1 + v * np.cos(u / 2)
        points = np.c_[radius * np.cos(u), radius * np.sin(u), v * np.sin(u / 2)]
    elif kind == "half_ball":
        normals = numbers.normal(size=(2 * n, 3))
        points = normals[normals[:, 2] > 0] / np.linalg.norm(normals[normals[:, 2] > 0], axis=1)[:, None]
        step = (2 * np.pi / len(points)) ** 0.5
    elif kind == "scan":  # of a ball, from above
        disk = grid[np.hypot(*grid.T) < 0.98]
        points = np.c_[disk, np.sqrt(1 - (disk**2).sum(1))]
    elif kind == "roof":
        points = np.c_[free, 0.8 * np.abs(free[:, 0])]
    elif kind == "cylinder":
        points = np.c_[np.cos(np.pi * free[:, 0]), np.sin(np.pi * free[:, 0]), free[:, 1]]
        step = (4 * np.pi / n) ** 0.5
    elif kind == "roll":
        t = (free[:, 0] + 1) * 1.5 * np.pi
        points = np.c_[(0.25 + 0.12 * t) * np.cos(t), (0.25 + 0.12 * t) * np.sin(t), free[:, 1]]
        step = (4 * 3.3 / n) ** 0.5
    elif kind == "strip":
        points = hills(grid[np.abs(grid[:, 1]) < 4 * step])
    elif kind == "plane":
        points = np.c_[free, free @ [1, 2]]
    elif kind == "graded":  # the density changes by six
        points = hills(np.c_[((jittered[:, 0] + 1.2) / 2.2).clip(0) ** 2.2, jittered[:, 1]])
    else:  # two sheets above each other
        points = hills(jittered)
        points = np.r_[points, points + [0.1 * step, 0, 6 * step]]
    return numbers.permutation(points + noise * step * numbers.normal(size=points.shape))


def squared_distances(p, a, b, c):
    """Returns the squared distances of a point from triangles."""
    best = np.full(len(a), np.inf)
    for u, v in ((a, b), (b, c), (c, a)):
        t = np.clip(((p - u) * (v - u)).sum(1) / ((v - u) ** 2).sum(1), 0, 1)[:, None]
        best = np.minimum(best, ((u + t * (v - u) - p) ** 2).sum(1))
    normal = np.cross(b - a, c - a)
    is_above = np.all([(np.cross(v - u, p - u) * normal).sum(1) >= 0 for u, v in ((a, b), (b, c), (c, a))], axis=0)
    height = ((p - a) * normal).sum(1) ** 2 / (normal**2).sum(1)
    return np.where(is_above, height, best)


def number_of_groups(edges):
    """Returns the number of connected components of a graph."""
    parents = {v: v for e in edges for v in e}

    def find(v):
        while parents[v] != v:
            parents[v] = v = parents[parents[v]]
        return v

    for v, w in edges:
        parents[find(v)] = find(w)
    return sum(find(v) == v for v in parents)


def topology(triangles):
    """Returns the Euler characteristic, the numbers of components and boundaries, and whether edges are manifold."""
    edges = {}
    for t in triangles.tolist():
        for e in zip(t, t[1:] + t[:1]):
            edges[tuple(sorted(e))] = edges.get(tuple(sorted(e)), 0) + 1
    boundary = [e for e, number in edges.items() if number == 1]
    characteristic = len(np.unique(triangles)) - len(edges) + len(triangles)
    return (characteristic, number_of_groups(edges), number_of_groups(boundary)), max(edges.values()) <= 2


def read_off(path):
    rows = [row.split() for row in path.read_text().splitlines() if row.strip() and not row.startswith(("OFF", "#"))]
    number = int(rows[0][0])
    return np.array(rows[1 : number + 1], float), np.array([row[1:4] for row in rows[number + 1 :]], int)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("dsc")
    parser.add_argument("--points", type=int, default=1600)
    parser.add_argument("--noise", type=float, default=0)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--kinds", default=",".join(KINDS))
    options = parser.parse_args()
    folder = pathlib.Path(tempfile.mkdtemp())
    print("| sheet | right | complete | largest distance (sp) | seconds |\n| --- | ---: | ---: | ---: | ---: |")
    for kind in options.kinds.split(","):
        right, complete, farthest, seconds = 0, 0, 0, 0
        for seed in range(options.seeds):
            points = points_of(kind, options.points, options.noise, np.random.default_rng(seed))
            np.savetxt(folder / "a.xyz", points)
            done = subprocess.run([options.dsc, "reconstruct", "--open", "a.xyz", "-o", "a.off", "--report", "a.json"],
                                  cwd=folder, capture_output=True, text=True)  # fmt: skip
            report = json.loads((folder / "a.json").read_text())
            vertices, triangles = read_off(folder / "a.off")
            found, is_manifold = topology(triangles)
            a, b, c = vertices[triangles.T]
            distance = max(squared_distances(p, a, b, c).min() for p in points) ** 0.5 / report["spacing"]
            is_right = found == EXPECTED.get(kind, (1, 1, 1)) and is_manifold
            if not is_right or done.returncode != 0:
                print(f"{kind}, seed {seed}: {found}, {done.stderr.strip()}")
            right, complete = right + is_right, complete + (done.returncode == 0)
            farthest, seconds = max(farthest, distance), seconds + report["seconds"] / options.seeds
        print(f"| {kind} | {right}/{options.seeds} | {complete}/{options.seeds} | {farthest:.2f} | {seconds:.2f} |")


if __name__ == "__main__":
    main()
