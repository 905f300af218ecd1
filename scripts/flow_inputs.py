#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the inputs of scripts/render_flows.sh into a folder: surfaces as OFF files, and points."""

import argparse
import math
import os
import random


class Surface:
    """Triangles, counterclockwise as seen from outside. Equal points are one vertex."""

    def __init__(self):
        self.vertices = {}
        self.triangles = []

    def add(self, *points):
        triangle = [self.vertices.setdefault(p, len(self.vertices)) for p in points]
        if len(set(triangle)) == 3:  # a quadrangle at a pole gives only one triangle
            self.triangles.append(triangle)

    def write(self, path):
        with open(path, "w") as file:
            print("OFF", len(self.vertices), len(self.triangles), 0, file=file)
            for vertex in self.vertices:
                print(*vertex, file=file)
            for triangle in self.triangles:
                print(3, *triangle, file=file)


def add_box(surface, low, high, n=1, place=lambda *point: point):
    """Adds a box of n^2 rectangles on each side. `place` maps the points of the box."""
    for axis in range(3):
        for side in (0, n):

            def point(i, j):
                steps = {axis: side, (axis + 1) % 3: i, (axis + 2) % 3: j}
                return place(*(low[k] + (high[k] - low[k]) * steps[k] / n for k in range(3)))

            for i in range(n):
                for j in range(n):
                    a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
                    for p, q, r in ((a, b, c), (a, c, d)):
                        surface.add(*((p, q, r) if side else (p, r, q)))


def box(low, high):
    surface = Surface()
    add_box(surface, low, high)
    return surface


def two_spheres(distance, n):
    """Returns two unit spheres along the x axis, projected from cubes."""
    surface = Surface()
    for centre in (-distance / 2, distance / 2):

        def blown_up(*point):
            p = [math.tan(math.pi / 4 * x) for x in point]  # rectangles of similar size
            return tuple(c + x / math.hypot(*p) for c, x in zip((centre, 0, 0), p))

        add_box(surface, (-1, -1, -1), (1, 1, 1), n, blown_up)
    return surface


def revolved(profile, n, axis):
    """Returns a surface of revolution. The profile consists of pairs: coordinate along the axis and
    distance from the axis. The inside is on the right of the profile."""

    def point(i, j):
        along, r = profile[i]
        angle = 2 * math.pi * (j % n) / n
        p = (along, r * math.cos(angle), r * math.sin(angle)) if r > 0 else (along, 0.0, 0.0)
        return p[3 - axis:] + p[:3 - axis]

    surface = Surface()
    for i in range(len(profile) - 1):
        for j in range(n):
            a, b, c, d = point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i + 1, j)
            surface.add(a, b, c)
            surface.add(a, c, d)
    return surface


def torus(tube_radius, n):
    """Returns a torus whose tube has the unit circle about the z axis as its center line."""
    circle = []
    for i in range(3 * n):
        angle = 2 * math.pi * i / (3 * n)
        circle.append((tube_radius * math.sin(angle), 1 + tube_radius * math.cos(angle)))
    return revolved(circle + circle[:1], 5 * n, axis=2)


def dumbbell(ball_radius, bar_radius, n):
    """Returns balls about x = -1 and x = 1, connected by a bar."""
    bar_begin = math.asin(bar_radius / ball_radius)
    half = []
    for i in range(2 * n):
        angle = (math.pi - bar_begin) * i / (2 * n)
        half.append((-1 - ball_radius * math.cos(angle), ball_radius * math.sin(angle)))
    bar_length = 1 - ball_radius * math.cos(bar_begin)
    for i in range(n):
        half.append((-bar_length * (n - i) / n, bar_radius))
    other_half = [(-x, r) for x, r in reversed(half)]
    return revolved(half + [(0, bar_radius)] + other_half, 2 * n, axis=0)


def drilled_block_points(n, hole):
    """Returns random points of a block of side lengths 2, 2 and 1 with a round hole along the z axis."""
    numbers = random.Random(1)
    cover, wall = 4 - math.pi * hole**2, 2 * math.pi * hole
    points = []
    while len(points) < n:
        place = numbers.uniform(0, 2 * cover + 8 + wall)
        u, v = numbers.uniform(-1, 1), numbers.uniform(-1, 1)
        if place < 2 * cover:
            while math.hypot(u, v) < hole:
                u, v = numbers.uniform(-1, 1), numbers.uniform(-1, 1)
            points.append((u, v, 0.5 if place < cover else -0.5))
        elif place < 2 * cover + 8:
            side = int(place - 2 * cover) // 2
            end = 1 if side % 2 == 0 else -1
            points.append((end, u, v / 2) if side < 2 else (u, end, v / 2))
        else:
            points.append((hole * math.cos(math.pi * u), hole * math.sin(math.pi * u), v / 2))
    return points


def gear_points(n, teeth, hole):
    """Returns random points of a gear of root radius 1 and height 0.5 with a round hole along the z axis."""
    numbers = random.Random(2)
    tip, height = 1.25, 0.5
    corners = [(radius, (tooth + part) * 2 * math.pi / teeth) for tooth in range(teeth)
               for radius, part in ((tip, -0.15), (tip, 0.15), (1, 0.25), (1, 0.75))]
    outline = [(r * math.cos(a), r * math.sin(a)) for r, a in corners]
    sides = list(zip(outline, outline[1:] + outline[:1]))
    lengths = [math.dist(a, b) for a, b in sides]

    def covers(x, y):
        if math.hypot(x, y) < hole:
            return False
        crossings = [ax + (y - ay) / (by - ay) * (bx - ax)
                     for (ax, ay), (bx, by) in sides if (ay > y) != (by > y)]
        return sum(crossing > x for crossing in crossings) % 2 == 1

    cover = sum(ax * by - bx * ay for (ax, ay), (bx, by) in sides) / 2 - math.pi * hole**2
    wall, bore = sum(lengths) * height, 2 * math.pi * hole * height
    points = []
    while len(points) < n:
        place = numbers.uniform(0, 2 * cover + wall + bore)
        u, v = numbers.uniform(0, 1), numbers.uniform(0, 1)
        if place < 2 * cover:
            x, y = tip * (2 * u - 1), tip * (2 * v - 1)
            while not covers(x, y):
                x, y = numbers.uniform(-tip, tip), numbers.uniform(-tip, tip)
            points.append((x, y, 0 if place < cover else height))
        elif place < 2 * cover + wall:
            (ax, ay), (bx, by) = numbers.choices(sides, lengths)[0]
            points.append((ax + u * (bx - ax), ay + u * (by - ay), v * height))
        else:
            angle = 2 * math.pi * u
            points.append((hole * math.cos(angle), hole * math.sin(angle), v * height))
    return points


def write_points(path, points):
    with open(path, "w") as file:
        for point in points:
            print(*point, file=file)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="DIR", help="output folder, created if it does not exist")
    folder = parser.parse_args().folder
    os.makedirs(folder, exist_ok=True)
    surfaces = {
        "cube": box((0, 0, 0), (1, 1, 1)),
        "left_cube": box((-1.02, 0, 0), (-0.02, 1, 1)),
        "right_cube": box((0.02, 0, 0), (1.02, 1, 1)),
        "two_spheres": two_spheres(2.4, 10),
        "torus": torus(0.5, 8),
        "dumbbell": dumbbell(0.5, 0.2, 10),
    }
    for name, surface in surfaces.items():
        surface.write(os.path.join(folder, name + ".off"))
    write_points(os.path.join(folder, "drilled_block.xyz"), drilled_block_points(20000, 0.4))
    write_points(os.path.join(folder, "gear.xyz"), gear_points(30000, 12, 0.4))


if __name__ == "__main__":
    main()
