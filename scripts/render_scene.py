#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders steps that `dsc fluid --output DIR` wrote, side by side, as water on a tiled floor.

DSC fills the space around the liquids of a step, if need be, and subdivides their surface, which
makes it smooth; POV-Ray (Debian: povray) traces the rays. The z axis points up. Needs NumPy.
"""

import argparse
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy

FRAMES = 4
SIZE = 480  # pixels, along either axis
# Seen from the front (-y), from the right and above, as in the pictures that dsc draws.
TO_EYE = (0.55, -1, 0.5)
ANGLE = 30  # of the view, in degrees
# The surfaces would just fit with 1.
MARGIN = 1.15
# How far below the liquid the floor is, in multiples of the distance of the eye: they must not
# coincide.
GAP = 0.001
# How long the tiles of the floor are, and how far light goes in the liquid until half is left, in
# the same unit.
TILE, CLARITY = 0.06, 0.12

SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 20 }}
camera {{
  location {eye} right -x up y angle {angle} sky z look_at {centre}
}}
light_source {{
  {centre} + {distance} * <-0.6, -0.5, 2> rgb 1.1
  area_light {distance} * 0.3 * x, {distance} * 0.3 * y, 5, 5 adaptive 1 circular orient
}}
sky_sphere {{ pigment {{ gradient z color_map {{ [0 rgb <0.9, 0.94, 1>] [1 rgb <0.4, 0.62, 0.92>] }} }} }}
plane {{
  z, {floor}
  pigment {{ checker rgb <0.84, 0.83, 0.8> rgb <0.7, 0.7, 0.69> scale {tile} }}
  finish {{ ambient 0 emission 0.15 diffuse 0.7 }}
}}
mesh2 {{
  vertex_vectors {{ {points} }}
  normal_vectors {{ {normals} }}
  face_indices {{ {triangles} }}
  inside_vector z
  pigment {{ rgbf <0.9, 0.97, 1, 0.95> }}
  finish {{
    ambient 0 diffuse 0.1 specular 0.8 roughness 0.004
    reflection {{ 0.03, 1 fresnel on }} conserve_energy
  }}
  interior {{
    ior 1.33 caustics 0.6
    fade_power 1001 fade_distance {clarity} fade_color <0.1, 0.45, 0.75>
  }}
}}
"""


class Failure(Exception):
    """What is wrong and what to do, in one line."""


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode:
        lines = (done.stderr or done.stdout).strip().splitlines() or ["it tells nothing"]
        raise Failure(f"{command[0]} failed: {lines[-1]}")


def steps_in(folder):
    if not os.path.isdir(folder):
        raise Failure(f"{folder} is no folder; run dsc fluid with --output first")
    names = (re.fullmatch(r"volume_(\d+)\.vtu", name) for name in os.listdir(folder))
    steps = sorted(int(name[1]) for name in names if name)
    if not steps:
        raise Failure(f"{folder} contains no step; run dsc fluid with --output first")
    return steps


def chosen(steps, wanted):
    if wanted is None:
        last = len(steps) - 1
        return [steps[i] for i in sorted({k * last // (FRAMES - 1) for k in range(FRAMES)})]
    for step in wanted:
        if step not in steps:
            raise Failure(f"there is no step {step}; there are {', '.join(map(str, steps))}")
    return wanted


def smooth_surface(dsc, volume, subdivisions, scratch):
    """Points and triangles of the surface of the liquids."""
    run_folder = os.path.join(scratch, "run")
    surface = os.path.join(scratch, "surface.off")
    # Only checkpoints are converted; a turn by no angle makes one of the tetrahedra.
    run(dsc, "rotate", volume, "--axis", "0,0,1", "--angle", "0", "--steps", "1", "--quiet",
        "--output", run_folder)
    run(dsc, "convert", os.path.join(run_folder, "checkpoint.dsc"), surface, "--quiet",
        *(["--subdivide", str(subdivisions)] if subdivisions else []))
    shutil.rmtree(run_folder)
    with open(surface, encoding="ascii") as file:
        numbers = numpy.array(file.read().split()[1:], float)
    end = 3 + 3 * int(numbers[0])
    return numbers[3:end].reshape(-1, 3), numbers[end:].reshape(-1, 4)[:, 1:].astype(int)


def vertex_normals(points, triangles):
    """The averages of the normals of the triangles around, by area."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    of_triangles = numpy.cross(b - a, c - a)
    normals = numpy.zeros_like(points)
    for k in range(3):
        numpy.add.at(normals, triangles[:, k], of_triangles)
    lengths = numpy.linalg.norm(normals, axis=1, keepdims=True)
    return numpy.divide(normals, lengths, out=normals, where=lengths > 0)


def camera_for(points):
    """The centre of the view of all points, and the least distance from which it shows them."""
    eye = numpy.array(TO_EYE) / numpy.linalg.norm(TO_EYE)
    right = numpy.cross((0, 0, 1), eye)
    right /= numpy.linalg.norm(right)
    axes = numpy.array((right, numpy.cross(eye, right), eye))
    seen = points @ axes.T
    centre = (seen.min(axis=0) + seen.max(axis=0)) / 2
    shift = seen - centre
    slope = numpy.tan(numpy.radians(ANGLE / 2)) / MARGIN
    distance = (numpy.abs(shift[:, :2]).max(axis=1) / slope + shift[:, 2]).max()
    return centre @ axes, distance, eye


def vector(v):
    return f"<{','.join(format(x, '.9g') for x in v)}>"


def array(vectors):
    return ",\n".join([str(len(vectors)), *map(vector, vectors)])


def scene(points, triangles, view, floor):
    centre, distance, eye = view
    return SCENE.format(eye=vector(centre + distance * eye), centre=vector(centre), angle=ANGLE,
                        distance=distance, floor=floor - GAP * distance, tile=TILE * distance,
                        clarity=CLARITY * distance, points=array(points),
                        normals=array(vertex_normals(points, triangles)),
                        triangles=array(triangles))


def render(text, scratch):
    path = os.path.join(scratch, "frame.pov")
    picture = os.path.join(scratch, "frame.ppm")
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    run("povray", f"+I{path}", f"+O{picture}", f"+W{SIZE}", f"+H{SIZE}", "+FP", "+A0.1", "-J", "-D",
        "-V", "File_Gamma=sRGB")
    with open(picture, "rb") as file:
        pixels = file.read()[-3 * SIZE * SIZE:]
    return numpy.frombuffer(pixels, numpy.uint8).reshape(SIZE, SIZE, 3)


def write_png(path, image):
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    height, width, _ = image.shape
    rows = b"".join(b"\0" + row.tobytes() for row in image)  # 0: not filtered
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" +
                   chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def step_numbers(text):
    return [int(step) for step in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dsc", metavar="DSC", help="the program")
    parser.add_argument("folder", metavar="DIR", help="what dsc fluid --output wrote")
    parser.add_argument("picture", metavar="PICTURE.png", help="what to write")
    parser.add_argument("--steps", metavar="K,K,...", type=step_numbers,
                        help=f"which steps; default: {FRAMES}, from the first to the last")
    parser.add_argument("--subdivide", metavar="N", type=int, choices=range(6), default=1,
                        help="how often each triangle is divided into four, 0 to 5; default: 1")
    arguments = parser.parse_args()
    for program in (arguments.dsc, "povray"):
        if not shutil.which(program):
            raise Failure(f"there is no program {program}; build dsc, and run "
                          "scripts/install_dependencies.sh for povray")

    steps = chosen(steps_in(arguments.folder), arguments.steps)
    volumes = [os.path.join(arguments.folder, f"volume_{step:06}.vtu") for step in steps]
    with tempfile.TemporaryDirectory() as scratch:
        surfaces = [smooth_surface(arguments.dsc, volume, arguments.subdivide, scratch)
                    for volume in volumes]
        every_point = numpy.concatenate([points for points, _ in surfaces])
        view = camera_for(every_point)
        floor = every_point[:, 2].min()
        frames = [render(scene(*surface, view, floor), scratch) for surface in surfaces]
    write_png(arguments.picture, numpy.concatenate(frames, axis=1))


if __name__ == "__main__":
    try:
        main()
    except (Failure, OSError) as failure:
        sys.exit(f"render_scene.py: {failure}")
