#!/usr/bin/env python3
"""Compares volumes of balls given by inequalities, and of offsets of right-angled prisms, with exact ones.

Usage: benchmark/round_solids.py DSC

Prints the tables of round_solids.md. The volumes are computed from the written files.
"""

import math
import os
import subprocess
import sys
import tempfile

import cad_solids
from thin_parts import read_volumes

HEIGHT = 1.0
SHAPES = {  # cross sections with right angles, counterclockwise
    "cube": [(0, 0), (1, 0), (1, 1), (0, 1)],
    "L-shape": [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)],
    "bracket": [(0, 0), (4, 0), (4, 3), (3.4, 3), (3.4, 0.6), (0.6, 0.6), (0.6, 3), (0, 3)],
}


def run(program, arguments):
    """Returns the volumes of label 1 before and after a run, and what the program printed."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        done = subprocess.run(
            [program, *arguments, "--output", out], capture_output=True, text=True, timeout=600, check=True
        )
        files = sorted(f for f in os.listdir(out) if f.startswith("volume_"))
        volumes = [read_volumes(os.path.join(out, f))[1] for f in (files[0], files[-1])]
        lines = [line for line in done.stdout.splitlines() if "unexplained" in line or "explain" in line]
        return *volumes, "; ".join(lines)


def prism(section):
    """Returns the triangles of a prism whose section is a fan around its first corner or a bracket."""
    n = len(section)
    points = [(x, y, z) for z in (0.0, HEIGHT) for x, y in section]
    fans = {4: [(0, 1, 2), (0, 2, 3)], 6: [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]}
    bracket = [(0, 1, 4), (0, 4, 5), (1, 2, 4), (2, 3, 4), (0, 5, 7), (5, 6, 7)]
    triangles = []
    for a, b, c in fans.get(n, bracket):
        triangles += [(a, c, b), (a + n, b + n, c + n)]
    for i in range(n):
        j = (i + 1) % n
        triangles += [(i, j, j + n), (i, j + n, i + n)]
    return points, triangles


def area(section, r, is_round):
    """Returns the area of a right-angled section after an offset by r, which may be negative."""
    n, total, length = len(section), 0.0, 0.0
    for (x, y), (u, v) in zip(section, section[1:] + section[:1]):
        total += (x * v - u * y) / 2
        length += math.hypot(u - x, v - y)
    convex = (n + 4) // 2
    away, towards = (convex, n - convex) if r > 0 else (n - convex, convex)
    return total + length * r + (away * (math.pi / 4 if is_round else 1) - towards) * r * r * (1 if r > 0 else -1)


def volume(section, d, is_round):
    if d < 0 or not is_round:
        return area(section, d, is_round) * (HEIGHT + 2 * d)
    parts = 20000
    caps = sum(
        area(section, math.sqrt(d * d - ((k + 0.5) / parts * d) ** 2), True) * d / parts for k in range(parts)
    )
    return area(section, d, True) * HEIGHT + 2 * caps


def main():
    program = sys.argv[1]
    print("| ball, radius in edges | shift | volume | exact | difference |\n| --- | --- | ---: | ---: | ---: |")
    for edges in (2, 3, 5, 8):
        for shift in (0.0, 0.137):
            ball = f"(x-{shift})^2+(y-{shift / 2})^2+(z+{shift / 3})^2<1"
            domain = ["--domain", "-2,-2,-2,2,2,2", "--edge", str(1 / edges)]
            before, _, _ = run(program, ["advect", ball, "--velocity", "0,0,0", "--steps", "1", *domain])
            exact = 4 / 3 * math.pi
            print(f"| {edges} | {shift} | {before:.6g} | {exact:.6g} | {100 * (before / exact - 1):+.4f} % |")
    print("\n| solid | distance | rule | steps | volume | exact | difference | message |")
    print("| --- | --- | --- | --- | ---: | ---: | ---: | --- |")
    for name, section in SHAPES.items():
        for d in (0.05, 0.1, -0.1):
            for rule in ("round", "miter"):
                for steps in (1, 5):
                    with tempfile.TemporaryDirectory() as folder:
                        path = os.path.join(folder, "solid.off")
                        cad_solids.write_off(path, prism(section))
                        _, after, message = run(
                            program,
                            ["offset", path, f"--distance={d / steps}", f"--steps={steps}", "--corners", rule],
                        )
                    exact = volume(section, d, rule == "round")
                    print(
                        f"| {name} | {d} | {rule} | {steps} | {after:.6g} | {exact:.6g} "
                        f"| {100 * (after / exact - 1):+.3f} % | {message} |"
                    )


if __name__ == "__main__":
    main()
