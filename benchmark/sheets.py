#!/usr/bin/env python3
"""Reconstructs random sheets by `dsc reconstruct --open`, and verifies each result.

The verification uses only the written triangles. It counts simplices, components and boundaries. It computes the distances of
all points from the triangles, and those of the points and of the vertices from the true surface. Prints a row for each kind of
sheet, and one line for each wrong result. With --peer, the program `reconstruction` of the benchmarks measures CGAL's advancing
front.

    benchmark/sheets.py build/dsc --noise 0.2 --seeds 5 --peer build/reconstruction
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


def hills(numbers):
    """Returns a map of the plane to random hills."""
    waves, phases = numbers.uniform(2, 7, (3, 2)), numbers.uniform(0, 6, 3)
    return lambda uv: np.c_[uv, 0.05 * np.sin(uv @ waves.T + phases).sum(1)]


def cap(uv):
    """Maps a disk to half a ball without changing the ratio of areas."""
    square = (uv**2).sum(1)
    return np.c_[uv * np.sqrt(2 - square)[:, None], 1 - square]


def moebius(uv):
    u, v = uv.T
    radius = 1 + v * np.cos(u / 2)
    return np.c_[radius * np.cos(u), radius * np.sin(u), v * np.sin(u / 2)]


def roll(uv):
    t = (uv[:, 0] + 1) * 1.5 * np.pi
    return np.c_[(0.25 + 0.12 * t) * np.cos(t), (0.25 + 0.12 * t) * np.sin(t), uv[:, 1]]


def sheet_of(kind, n, numbers):
    """Returns parameters of points, the map of parameters to the surface, and the distance of neighbors."""
    side = round(n**0.5)
    step = 2 / (side - 1)
    grid = np.stack(np.meshgrid(*2 * [np.linspace(-1, 1, side)]), -1).reshape(-1, 2)
    jittered = grid + numbers.uniform(-0.4, 0.4, grid.shape) * step
    free = numbers.uniform(-1, 1, (n, 2))
    surface = hills(numbers)
    if kind == "regular":
        return grid, surface, step
    if kind == "random":
        return free, surface, step
    if kind == "hole":
        middle = numbers.uniform(-0.4, 0.4, 2)
        return jittered[np.hypot(*(jittered - middle).T) > max(0.25, 4 * step)], surface, step
    if kind == "moebius":
        around = round((n * 2 * np.pi / 0.8) ** 0.5)
        step = 2 * np.pi / around
        uv = np.stack(np.meshgrid(np.arange(around) * step, np.linspace(-0.4, 0.4, n // around)), -1).reshape(-1, 2)
        return uv + numbers.uniform(-0.3, 0.3, uv.shape) * [step, 0], moebius, step
    if kind == "half_ball":
        wide = numbers.uniform(-1, 1, (2 * n, 2))
        disk = wide[np.hypot(*wide.T) < 1]
        return disk, cap, (2 * np.pi / len(disk)) ** 0.5
    if kind == "scan":  # of a ball, from above
        disk = grid[np.hypot(*grid.T) < 0.98]
        return disk, lambda uv: np.c_[uv, np.sqrt(np.maximum(1 - (uv**2).sum(1), 0))], step
    if kind == "roof":
        return free, lambda uv: np.c_[uv, 0.8 * np.abs(uv[:, 0])], step
    if kind == "cylinder":
        around = lambda uv: np.c_[np.cos(np.pi * uv[:, 0]), np.sin(np.pi * uv[:, 0]), uv[:, 1]]  # noqa: E731
        return free, around, (4 * np.pi / n) ** 0.5
    if kind == "roll":
        return free, roll, (4 * 3.3 / n) ** 0.5
    if kind == "strip":
        return grid[np.abs(grid[:, 1]) < 4 * step], surface, step
    if kind == "plane":
        return free, lambda uv: np.c_[uv, uv @ [1, 2]], step
    if kind == "graded":  # the density changes by six
        return np.c_[((jittered[:, 0] + 1.2) / 2.2).clip(0) ** 2.2, jittered[:, 1]], surface, step
    return jittered, surface, step  # also of two sheets


def points_of(kind, n, noise, numbers):
    """Returns points with noise in distances of neighbors, their parameters, and the map of parameters to the surface."""
    uv, surface, step = sheet_of(kind, n, numbers)
    if kind == "two":  # above each other; the upper sheet has other parameters
        lower = surface
        surface = lambda uv: lower(uv - (uv > 5) * 10) + (uv[:, :1] > 5) * [0, 0, 6 * step]  # noqa: E731
        uv = np.r_[uv, uv + [10 + 0.1 * step, 0]]
    uv = numbers.permutation(uv)
    points = surface(uv)
    return points + noise * step * numbers.normal(size=points.shape), uv, surface


def heights(points, uv, surface):
    """Returns the distances of points from a surface. The parameters are those of points near them."""
    tiny = 1e-6
    for _ in range(5):  # steps of Newton's method
        foot = surface(uv)
        du, dv = ((surface(uv + d) - surface(uv - d)) / (2 * tiny) for d in ([tiny, 0], [0, tiny]))
        away = points - foot
        uu, uw, ww = (du * du).sum(1), (du * dv).sum(1), (dv * dv).sum(1)
        au, aw, det = (away * du).sum(1), (away * dv).sum(1), uu * ww - uw**2
        uv = uv + np.c_[(ww * au - uw * aw) / det, (uu * aw - uw * au) / det]
    normal = np.cross(du, dv)
    return np.abs((away * normal).sum(1)) / np.linalg.norm(normal, axis=1)


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


def root_mean_square(values):
    return float(np.mean(np.square(values)) ** 0.5)


def seconds_of_peer(program, points):
    """Returns the wall-clock time of CGAL's advancing front, in seconds."""
    done = subprocess.run([program, points, "--open", "--peers"], capture_output=True, text=True, check=True)
    row = next(row for row in done.stdout.splitlines() if "| advancing front |" in row)
    return float(row.split("|")[-3])


def verify(options, folder, kind, seed):
    """Returns whether a result is right and complete, and its measures in spacings and seconds."""
    points, uv, surface = points_of(kind, options.points, options.noise, np.random.default_rng(seed))
    np.savetxt(folder / "a.xyz", points)
    done = subprocess.run([options.dsc, "reconstruct", "--open", "a.xyz", "-o", "a.off", "--report", "a.json"],
                          cwd=folder, capture_output=True, text=True)  # fmt: skip
    report = json.loads((folder / "a.json").read_text())
    vertices, triangles = read_off(folder / "a.off")
    found, is_manifold = topology(triangles)
    a, b, c = vertices[triangles.T]
    farthest = max(squared_distances(p, a, b, c).min() for p in points) ** 0.5
    nearest = np.array([((points - v) ** 2).sum(1).argmin() for v in vertices])
    of_points, of_vertices = heights(points, uv, surface), heights(vertices, uv[nearest], surface)
    is_right = found == EXPECTED.get(kind, (1, 1, 1)) and is_manifold
    if not is_right or done.returncode != 0:
        print(f"{kind}, seed {seed}: {found}, {done.stderr.strip()}")
    spacing = report["spacing"]
    peer = seconds_of_peer(options.peer, folder / "a.xyz") if options.peer else float("nan")
    return (is_right, done.returncode == 0, farthest / spacing, root_mean_square(of_points) / spacing,
            root_mean_square(of_vertices) / spacing, of_vertices.max() / spacing, report["seconds"], peer)  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("dsc")
    parser.add_argument("--peer", help="the program `reconstruction` of the benchmarks")
    parser.add_argument("--points", type=int, default=1600)
    parser.add_argument("--noise", type=float, default=0)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--kinds", default=",".join(KINDS))
    options = parser.parse_args()
    folder = pathlib.Path(tempfile.mkdtemp())
    print("| sheet | right | complete | farthest point (sp) | points to truth, rms (sp) | sheet to truth, rms (sp) "
          "| sheet to truth, maximum (sp) | seconds | advancing front, seconds |\n" + "| --- " + 8 * "| ---: " + "|")
    for kind in options.kinds.split(","):
        rows = np.array([verify(options, folder, kind, options.first + k) for k in range(options.seeds)], float)
        (right, complete), mean, largest = rows[:, :2].sum(0).astype(int), rows.mean(0), rows.max(0)
        print(f"| {kind} | {right}/{len(rows)} | {complete}/{len(rows)} | {largest[2]:.2f} | {mean[3]:.3f} "
              f"| {mean[4]:.3f} | {largest[5]:.2f} | {mean[6]:.2f} | {mean[7]:.2f} |", flush=True)


if __name__ == "__main__":
    main()
