#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders steps of a run of `dsc fluid --output DIR --subdivide N` in one picture.

The picture shows opaque liquids above a pale floor, rendered by POV-Ray (Debian: povray). The frames are
side by side; wide frames are in rows of two. Needs NumPy (Debian: python3-numpy).
"""

import argparse
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import draw_icons
import numpy

FRAMES = 4
WIDTH = 1200  # of the picture, in pixels
BROAD = 2  # Frames are wide if the ratio of width to height is larger.
BORDER_GREY = 200  # of 255
ANGLE = 30  # horizontal angle of view, in degrees
# The margin; with 1 the surfaces exactly fit.
MARGIN = 1.15
# Distance of the floor from the liquid, in multiples of the distance of the eye. It is positive, so
# that the floor and the liquid do not coincide.
GAP = 0.001

SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 8 }}
camera {{
  location {eye} right -{aspect} * x up y angle {angle} sky z look_at {centre}
}}
light_source {{
  {centre} + {distance} * <-0.6, -0.5, 2> rgb 0.85
  area_light {distance} * 0.5 * x, {distance} * 0.5 * y, 9, 9 adaptive 1 circular orient
}}
light_source {{ {eye} rgb 0.3 shadowless }}
sky_sphere {{ pigment {{ gradient z color_map {{ [0 rgb 0.45] [0.6 rgb 1] }} }} }}
plane {{
  z, {floor}
  pigment {{ rgb 1 }}
  finish {{ ambient 0 emission 0.45 diffuse 0.6 }}
}}
mesh2 {{
  vertex_vectors {{ {points} }}
  normal_vectors {{ {normals} }}
  face_indices {{ {triangles} }}
  pigment {{ rgb <0.08, 0.3, 0.6> }}
  finish {{
    ambient 0 emission 0.15 diffuse 0.75 specular 0.6 roughness 0.005
    reflection {{ 0.02, 0.6 fresnel on }}
  }}
  interior {{ ior 1.5 }}
}}
"""


class Failure(Exception):
    """An error message of one line with advice."""


def smooth_surfaces(folder):
    """Returns the files of the steps with their times."""
    try:
        entries = ElementTree.parse(os.path.join(folder, "interface.pvd")).getroot().iter("DataSet")
        names = [(float(e.get("timestep")), os.path.splitext(e.get("file"))[0]) for e in entries]
    except (OSError, ElementTree.ParseError, TypeError, ValueError) as error:
        raise Failure(f"{folder} has no steps ({error}); run dsc fluid with --output first")
    if not names:
        raise Failure(f"{folder} has no steps; run dsc fluid with --output first")
    return [(time, os.path.join(folder, f"{name.replace('interface', 'smooth')}.ply"))
            for time, name in names]


def chosen(surfaces, times):
    """Returns the files nearest to the times, or FRAMES files from the first to the last."""
    if times is None:
        last = len(surfaces) - 1
        return [surfaces[i][1] for i in sorted({k * last // (FRAMES - 1) for k in range(FRAMES)})]
    return [min(surfaces, key=lambda surface: abs(surface[0] - time))[1] for time in times]


def read_surface(path, up):
    """Returns the points, with the third axis upwards, and the triangles."""
    try:
        with open(path, encoding="ascii") as file:
            words = file.read().split()
        counts = [int(words[words.index(kind) + 1]) for kind in ("vertex", "face")]
        values = numpy.array(words[words.index("end_header") + 1:], float)
    except (OSError, ValueError) as error:
        raise Failure(f"cannot read {path} ({error}); run dsc fluid with --subdivide first")
    end = 3 * counts[0]
    points = values[:end].reshape(-1, 3)
    if up == "y":
        points = points[:, (0, 2, 1)] * (1, -1, 1)
    return points, values[end:].reshape(counts[1], 4)[:, 1:].astype(int)


def vertex_normals(points, triangles):
    """Returns the mean normals of the incident triangles, weighted by area."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    of_triangles = numpy.cross(b - a, c - a)
    normals = numpy.zeros_like(points)
    for k in range(3):
        numpy.add.at(normals, triangles[:, k], of_triangles)
    lengths = numpy.linalg.norm(normals, axis=1, keepdims=True)
    return numpy.divide(normals, lengths, out=normals, where=lengths > 0)


def camera_for(points, to_eye):
    """Returns the camera that shows all points: the centre of the view, the smallest distance of the
    eye, the direction to the eye, and the ratio of width to height."""
    eye = numpy.array(to_eye) / numpy.linalg.norm(to_eye)
    right = numpy.cross((0, 0, 1), eye)
    right /= numpy.linalg.norm(right)
    axes = numpy.array((right, numpy.cross(eye, right), eye))
    seen = points @ axes.T
    centre = (seen.min(axis=0) + seen.max(axis=0)) / 2
    shift = numpy.abs(seen - centre)
    width, height = shift[:, :2].max(axis=0)
    aspect = width / height
    slope = numpy.tan(numpy.radians(ANGLE / 2)) / MARGIN
    distance = (numpy.maximum(shift[:, 0], aspect * shift[:, 1]) / slope +
                (seen - centre)[:, 2]).max()
    return centre @ axes, distance, eye, aspect


def vector(v):
    return f"<{','.join(format(x, '.9g') for x in v)}>"


def array(vectors):
    return ",\n".join([str(len(vectors)), *map(vector, vectors)])


def scene(points, triangles, view, floor):
    centre, distance, eye, aspect = view
    return SCENE.format(eye=vector(centre + distance * eye), centre=vector(centre), angle=ANGLE,
                        aspect=aspect, distance=distance, floor=floor - GAP * distance,
                        points=array(points), normals=array(vertex_normals(points, triangles)),
                        triangles=array(triangles))


def render(text, width, height, scratch):
    path = os.path.join(scratch, "frame.pov")
    picture = os.path.join(scratch, "frame.ppm")
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    try:
        subprocess.run(["povray", f"+I{path}", f"+O{picture}", f"+W{width}", f"+H{height}", "+FP",
                        "+A0.1", "-J", "-D", "-V", "File_Gamma=sRGB"],
                       capture_output=True, text=True, errors="replace", check=True)
    except FileNotFoundError:
        raise Failure("povray is missing; run scripts/install_dependencies.sh povray")
    except subprocess.CalledProcessError as error:
        lines = error.stderr.strip().splitlines() or ["no message"]
        raise Failure(f"povray failed: {lines[-1]}")
    with open(picture, "rb") as file:
        pixels = file.read()[-3 * width * height:]
    return numpy.frombuffer(pixels, numpy.uint8).reshape(height, width, 3)


def in_rows(frames, columns):
    blank = numpy.full_like(frames[0], 255)
    frames = frames + [blank] * (-len(frames) % columns)
    rows = [joined(frames[i:i + columns], 1) for i in range(0, len(frames), columns)]
    return joined(rows, 0)


def joined(frames, axis):
    """Returns the frames, separated by lines of one pixel."""
    shape = list(frames[0].shape)
    shape[axis] = 1
    line = numpy.full(shape, BORDER_GREY, numpy.uint8)
    parts = [part for frame in frames for part in (line, frame)]
    return numpy.concatenate(parts[1:], axis=axis)


def numbers(text):
    return [float(number) for number in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="DIR", help="folder of a run of dsc fluid with --output and --subdivide")
    parser.add_argument("picture", metavar="PICTURE.png", help="the output file")
    parser.add_argument("--times", metavar="T,T,...", type=numbers,
                        help=f"times of the steps; default: {FRAMES} steps from the first to the last")
    parser.add_argument("--up", choices="yz", default="z", help="the upward axis; default: z")
    parser.add_argument("--eye", metavar="X,Y,Z", type=numbers, default=[0.55, -1, 0.5],
                        help="the direction to the eye: to the right, backwards and upwards; "
                             "default: 0.55,-1,0.5")
    arguments = parser.parse_args()

    paths = chosen(smooth_surfaces(arguments.folder), arguments.times)
    surfaces = [read_surface(path, arguments.up) for path in paths]
    every_point = numpy.concatenate([points for points, _ in surfaces])
    view = camera_for(every_point, arguments.eye)
    floor = every_point[:, 2].min()
    aspect = view[-1]
    columns = min(len(surfaces), 2) if aspect > BROAD else len(surfaces)
    width = WIDTH // columns
    with tempfile.TemporaryDirectory() as scratch:
        frames = [render(scene(*surface, view, floor), width, round(width / aspect), scratch)
                  for surface in surfaces]
    image = in_rows(frames, columns)
    draw_icons.write_png(arguments.picture, image.reshape(len(image), -1))


if __name__ == "__main__":
    try:
        main()
    except (Failure, OSError) as failure:
        sys.exit(f"render_scene.py: {failure}")
