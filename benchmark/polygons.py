#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how `dsc` fills the plane around polygons of many segments.

Usage: benchmark/polygons.py DSC [SEGMENTS]

Prints a row for each polygon: its segments, triangles for each segment, processor time and memory of reading, filling and
one small step. The kinds: a circle, a star with waves, a circle with noise of half a segment, and a snowflake of Koch.
"""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy


def on_circle(radius):
    """Returns the points with the given radii at equal angles."""
    angles = 2 * numpy.pi * numpy.arange(len(radius)) / len(radius)
    return radius * numpy.exp(1j * angles)


def polygons(number):
    """Returns the corners of each polygon as complex numbers."""
    angles = 2 * numpy.pi * numpy.arange(number) / number
    noise = numpy.random.default_rng(1).uniform(-1, 1, number)
    snowflake = numpy.array([0, numpy.exp(1j * numpy.pi / 3), 1])
    while 4 * len(snowflake) <= 2 * number:
        third = (numpy.roll(snowflake, -1) - snowflake) / 3
        parts = [0 * third, third, third * (1 + numpy.exp(1j * numpy.pi / 3)), 2 * third]
        snowflake = numpy.stack([snowflake + part for part in parts], 1).ravel()
    return {
        "circle": on_circle(numpy.ones(number)),
        "star": on_circle(1 + 0.3 * numpy.sin(5 * angles) + 0.1 * numpy.sin(97 * angles)),
        "noisy circle": on_circle(1 + numpy.pi / number * noise),
        "snowflake": snowflake,
    }


def measure(dsc, points, folder):
    """Returns the triangles, the processor time in seconds and the memory in bytes of a run."""
    path, report = folder / "polygon.wkt", folder / "report.json"
    corners = ", ".join(f"{p.real:.17g} {p.imag:.17g}" for p in [*points, points[0]])
    path.write_text(f"POLYGON (({corners}))\n")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [dsc, "offset", path, "--distance", "1e-9", "--steps", "1", "--quiet", "--report", report, "--output", folder / "out"],
        check=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads(report.read_text())["steps"][-1]["triangles"], seconds, 1024 * after.ru_maxrss


def main():
    dsc, number = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 100000
    print("| polygon | segments | triangles for each | processor time (s) | largest memory so far (MB) |")
    print("| --- | ---: | ---: | ---: | ---: |")
    for name, points in polygons(number).items():
        with tempfile.TemporaryDirectory() as folder:
            triangles, seconds, memory = measure(dsc, points, pathlib.Path(folder))
        print(f"| {name} | {len(points)} | {triangles / len(points):.1f} | {seconds:.1f} | {memory / 1e6:.0f} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main()
