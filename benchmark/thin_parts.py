#!/usr/bin/env python3
"""Checks that motions of solids with few large triangles lose no volume in silence.

Usage: benchmark/thin_parts.py DSC [--random N] [--seed N] [--worst N]

Without --random, prints the table of plates, bars, cylinders and wedges. With --random, moves N random
solids by six motions each and prints silent losses and the worst motions. The volumes are computed from
the written files, not from the report of the program. A loss is silent if the program ends with status 0,
prints nothing about it, and the volume differs from the exact one by more than a hundredth.
"""

import argparse
import itertools
import math
import os
import random
import re
import subprocess
import sys
import tempfile

import cad_solids
import numpy

ALLOWED = 0.01  # relative difference of volumes
SECONDS = 120  # limit of a run


def read_mesh(path):
    """Returns the points, the tetrahedra and the labels of a file written by `dsc`."""
    with open(path, "rb") as file:
        data = file.read()
    begin = data.index(b"_", data.index(b"<AppendedData")) + 1
    types = {"Float64": "<f8", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}

    def array(name):
        found = re.search(rb'type="(\w+)" Name="' + name + rb'"[^>]*offset="(\d+)"', data)
        at = begin + int(found.group(2))
        size = int.from_bytes(data[at : at + 8], "little")
        return numpy.frombuffer(data[at + 8 : at + 8 + size], types[found.group(1).decode()])

    return array(b"points").reshape(-1, 3), array(b"connectivity").reshape(-1, 4), array(b"label")


def read_volumes(path):
    """Returns the volumes of the labels of a file written by `dsc`."""
    points, cells, labels = read_mesh(path)
    corners = points[cells]
    volumes = numpy.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    if not (volumes > 0).all():
        return None
    return {int(label): float(volumes[labels == label].sum()) for label in numpy.unique(labels)}


class Result:
    """What a run did: `before` and `after` are volumes of label 1."""

    def __init__(self, program, surface, arguments, steps=1):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "solid.off")
            cad_solids.write_off(path, surface)
            out = os.path.join(folder, "out")
            try:
                done = subprocess.run(
                    [program, *arguments, path, "--steps", str(steps), "--threads", "1", "--output", out,
                     "--every", str(steps)],
                    capture_output=True, text=True, timeout=SECONDS, check=False)
            except subprocess.TimeoutExpired:
                self.status, self.message, self.before, self.after = -1, f"not done in {SECONDS} s", 0, 0
                return
            self.status = done.returncode
            lines = (done.stdout + done.stderr).splitlines()
            self.message = " ".join(x for x in lines if not re.match(r"dsc: step \d+, time", x))
            self.before = self.after = 0.0
            if self.status == 0:
                volumes = [read_volumes(os.path.join(out, f"volume_{i:06}.vtu")) for i in (0, steps)]
                if None in volumes:
                    self.status = "inverted cells"
                else:
                    self.before, self.after = (v.get(1, 0.0) for v in volumes)


def motions(solid_volume, offset_volume, turning, thickness, size, random_):
    """Returns names, arguments and exact volumes of six motions; `None` if only a bound is known."""
    d = thickness * random_.choice((0.01, 0.05, 0.1))
    angle = random_.uniform(1, 60)
    rate = random_.uniform(0.05, 0.5)
    dt = 0.01 * solid_volume / abs(turning)
    return [
        ("offset out", ["offset", f"--distance={d!r}"], offset_volume(d)),
        ("offset in", ["offset", f"--distance={-d!r}"], offset_volume(-d)),
        ("rotate", ["rotate", "--axis=.3,.2,1", f"--angle={angle!r}"], solid_volume),
        ("translate", ["advect", f"--velocity={size * rate!r},{size * rate / 3!r},{-size * rate / 7!r}", "--dt=0.1"],
         solid_volume),
        ("shear", ["advect", f"--velocity={rate!r}*y,0,{rate / 2!r}*x", "--dt=0.1"], solid_volume),
        ("curvature", ["mean-curvature", f"--dt={dt!r}"], solid_volume - dt * turning),
    ]


def deviation(result, exact):
    return abs(result.after - exact) / exact


def table(program):
    rows = []

    def add(name, surface, arguments, exact, steps=1):
        result = Result(program, surface, arguments, steps)
        value = f"{result.after:.6g}" if result.status == 0 else f"status {result.status}"
        change = f"{100 * (result.after / exact - 1):+.3f} %" if result.status == 0 else ""
        rows.append((name, " ".join(arguments), value, f"{exact:.6g}", change, result.message))
        print("| " + " | ".join(rows[-1]) + " |", flush=True)

    print("| solid | command | volume | exact | difference | message |")
    print("| --- | --- | ---: | ---: | ---: | --- |")
    for length in (1, 10, 50, 100, 200):
        for name, solid in ((f"plate {length} x {length} x 1", cad_solids.box(length, length, 1)),
                            (f"bar {length} x 1 x 1", cad_solids.box(length, 1, 1))):
            if name.startswith("bar 1 "):
                continue
            surface, volume = solid.surface(), solid.volume()
            for d in (0.001, -0.001, 0.05, -0.05, 0.2, -0.2):
                add(name, surface, ["offset", f"--distance={d}"], solid.offset(d).volume())
            turning = cad_solids.turning(surface)
            dt = 0.001 * volume / turning
            add(name, surface, ["mean-curvature", f"--dt={dt:.4g}"], volume - dt * turning)
            add(name, surface, ["advect", "--velocity=.3*y+.1*z,0,.1*x", "--dt=0.1"], volume)
            add(name, surface, ["rotate", "--axis=.3,.2,1", "--angle=30"], volume)
    for sides, height in itertools.product((12, 24, 60), (1, 20, 100)):
        plate = cad_solids.cylinder(0.5, height, sides)
        for d in (0.02, -0.02, 0.1, -0.1):
            add(f"cylinder r .5, h {height}, {sides} sides", cad_solids.extruded(*plate),
                ["offset", f"--distance={d}"], cad_solids.plate_volume(*plate, d=d))
    for degrees in (10, 1, 0.1):
        surface = cad_solids.wedge(10, degrees)
        volume = cad_solids.volume(surface)
        add(f"wedge {degrees} degrees", surface, ["advect", "--velocity=.3*y+.1*z,0,.1*x", "--dt=0.1"], volume)
        add(f"wedge {degrees} degrees", surface, ["rotate", "--axis=.3,.2,1", "--angle=30"], volume)


def generator(seed, index):
    """Returns the random numbers of a solid, and its thickness."""
    random_ = random.Random(seed * 1000003 + index)
    return random_, 10 ** random_.uniform(-0.7, 1)


def random_solids(program, number, seed, worst):
    results = []
    failed = runs = 0
    for index in range(number):
        random_, thickness = generator(seed, index)
        if random_.random() < 0.5:
            solid = cad_solids.random_blocks(random_, thickness)
            surface, volume = solid.surface(), solid.volume()
            thinnest = min(float(numpy.diff(x).min()) for x in solid.planes)
            offset = lambda d, s=solid: s.offset(d).volume()
        else:
            plate = cad_solids.random_plate(random_, thickness)
            surface, volume = cad_solids.extruded(*plate), cad_solids.plate_volume(*plate)
            thinnest = min(thickness, *(math.dist(r[i - 1], r[i]) for r in (plate[0], *plate[1]) for i in range(len(r))))
            offset = lambda d, p=plate: cad_solids.plate_volume(*p, d=d)
        for name, arguments, exact in motions(volume, offset, cad_solids.turning(surface), thinnest, 10, random_):
            result = Result(program, surface, arguments)
            runs += 1
            difference = deviation(result, exact) if result.status == 0 else math.inf
            failed += result.status != 0
            results.append((difference, index, name, " ".join(arguments), result.after, exact, result.status,
                            len(surface[1]), result.message))
    results.sort(key=lambda r: -r[0])
    silent = [r for r in results if r[6] == 0 and r[0] > ALLOWED and not r[8]]
    print(f"{runs} motions of {number} solids: {len(silent)} silent losses, {failed} failures")
    for r in silent + [r for r in results[:worst] if r not in silent]:
        print(f"solid {r[1]} ({r[7]} triangles), {r[3]}: {r[4]:.6g}, exact {r[5]:.6g} ({100 * r[0]:.3g} %), "
              f"status {r[6]} {r[8]}")
    return not silent


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--random", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--worst", type=int, default=10)
    arguments = parser.parse_args()
    if arguments.random:
        sys.exit(not random_solids(arguments.program, arguments.random, arguments.seed, arguments.worst))
    table(arguments.program)


if __name__ == "__main__":
    main()
