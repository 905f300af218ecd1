#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints checksums of the meshes that runs of `dsc` write, to compare two states of the code.

Usage: scripts/checksums.py DSC [NAME...]    all runs, or those of these names

The runs move interfaces in both dimensions, on one and several processes, and use each package.
"""
import hashlib
import os
import pathlib
import random
import subprocess
import sys
import tempfile

MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "3"]
BALL = "x^2+y^2+z^2<.25"
BRICK = "max(abs(x)/.4, max(abs(y)/.3, abs(z)/.2))<1"
BOX = ["--domain=-1,-1,-1,1,1,1", "--edge", ".15"]
MESHES = (".vtu", ".off", ".svg")
# Name of a run: arguments of dsc, the last of which writes a folder or a file
RUNS = {
    "offset": ["offset", BALL, *BOX, "--distance", ".3e", "--steps", "4", "--output", "out"],
    "corners": ["offset", BRICK, *BOX, "--distance", ".2e", "--steps", "2", "--corners", "miter", "--output", "out"],
    "turn": ["rotate", BRICK, *BOX, "--axis", "1,2,3", "--angle", "25", "--steps", "2", "--output", "out"],
    "enright": ["enright", "--triangles", "1500", "--steps", "8", "--output", "out"],
    "curvature": ["mean-curvature", "x^2+4*y^2+9*z^2<.5", *BOX, "--steps", "5", "--output", "out"],
    "touching": ["offset", "(x-.4)^2+y^2+z^2<.1", "(x+.4)^2+y^2+z^2<.1", *BOX, "--distance", ".5e", "--steps", "4", "--output", "out"],
    "adaptive": ["advect", BALL, *BOX, "--velocity", "-y,x,z", "--tolerance", ".05", "--dt", ".1", "--steps", "4", "--output", "out"],
    "vortex_2": ["vortex", "--plane", "--steps", "20", "--output", "out"],
    "curvature_2": ["mean-curvature", "ell.wkt", "--domain=-1,-1,6,5", "--segments", "80", "--steps", "6", "--output", "out"],
    "offset_2": ["offset", "ell.wkt", "--domain=-1,-1,6,5", "--segments", "80", "--distance", ".5e", "--steps", "6", "--output", "out"],
    "grains_2": ["grains", "--number", "40", "--steps", "30", "--output", "out"],
    "grains_3": ["grains", "--number", "12", "--dimension", "3", "--edges", "5", "--steps", "6", "--output", "out"],
    "fluid": ["fluid", "spinning", "--steps", "3", "--output", "out"],
    "fluid_2": ["fluid", "rising-bubble", "--steps", "3", "--output", "out"],
    "segment": ["segment", "image.pgm", "--phases", "2", "-o", "out.vtu"],
    "reconstruct": ["reconstruct", "points.xyz", "-o", "out.off"],
    "cut_locus": ["cut-locus", "--point", "0,0.3", "--spacing", ".15", "-o", "out.svg"],
    "ranks_offset": ["mpirun", "offset", BALL, *BOX, "--distance", ".3e", "--steps", "4", "--output", "out"],
    "ranks_enright": ["mpirun", "enright", "--triangles", "1500", "--steps", "4", "--output", "out"],
}


def write_inputs(folder):
    """Writes an image of a disk with noise, a polygon, and points of a sphere."""
    source = random.Random(1)
    side = 60
    values = [min(255, max(0, int((180 if (x - 30) ** 2 + (y - 28) ** 2 < 300 else 60) + source.gauss(0, 20))))
              for y in range(side) for x in range(side)]
    (folder / "image.pgm").write_bytes(f"P5\n{side} {side}\n255\n".encode() + bytes(values))
    (folder / "ell.wkt").write_text("POLYGON((0 0, 4 0, 4 1, 1.3 1, 1 3, 0 3, 0 0))\n")
    points = []
    while len(points) < 800:
        p = [source.gauss(0, 1) for _ in range(3)]
        length = sum(x * x for x in p)**.5
        points.append(" ".join(repr(x / length) for x in p))
    (folder / "points.xyz").write_text("\n".join(points) + "\n")


def checksum(program, arguments):
    """Returns a checksum of the meshes that a run writes, or what went wrong."""
    command = [program, *arguments]
    if arguments[0] == "mpirun":
        command = [*MPIRUN, program, *arguments[1:]]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_inputs(folder)
        done = subprocess.run([*command, "--quiet"], cwd=folder, capture_output=True, text=True,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        if done.returncode != 0:
            return f"status {done.returncode}: {done.stderr.strip().splitlines()[-1:]}"
        files = sorted(path for path in folder.rglob("*") if path.suffix in MESHES)
        total = hashlib.sha256()
        for path in files:
            total.update(path.name.encode() + path.read_bytes())
        return f"{len(files)} files {total.hexdigest()[:16]}"


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    for name in sys.argv[2:] or RUNS:
        print(f"{name:14} {checksum(program, RUNS[name])}", flush=True)


if __name__ == "__main__":
    main()
