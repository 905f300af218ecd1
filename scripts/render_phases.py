#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders the phases of a mesh (.vtu) with labels, behind a plane through its center.

Label 0 is invisible. Needs VTK 9 for Python (Debian: python3-vtk9). Without a display, run the script
with xvfb-run.
"""

import argparse

import render
import vtk

COLORS = (*render.COLOURS[1:3], (0.93, 0.90, 0.82), render.COLOURS[3])


def phases_behind(grid, axis, largest):
    """Returns the boundary of the positive labels below a plane that is perpendicular to an axis."""
    inside = render.cells_with_labels(grid, 1, largest)
    plane = vtk.vtkPlane()
    plane.SetOrigin(grid.GetCenter())
    plane.SetNormal(*(1 if i == axis else 0 for i in range(3)))
    clip = vtk.vtkClipDataSet()
    clip.SetInputConnection(inside.GetOutputPort())
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    return render.surface_of(clip)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", metavar="MESH.vtu")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("--axis", type=int, choices=range(3), default=2, help="0 for x, 1 for y, 2 for z")
    parser.add_argument("--eye", type=float, nargs=3, default=[0.4, -1, 1.2], help="direction to the camera")
    arguments = parser.parse_args()
    grid, labels = render.read_labels(arguments.mesh)
    if labels.GetRange()[1] < 1:
        raise SystemExit(f"render_phases.py: {arguments.mesh} has no positive labels")
    largest = labels.GetRange()[1]
    table = render.colour_table([COLORS[label % len(COLORS)] for label in range(int(largest))], first=1)
    surface = phases_behind(grid, arguments.axis, largest)
    up = (0, 0, 1) if arguments.axis != 2 else (0, 1, 0)
    actor = render.labeled_actor(surface, table, ambient=0.25)
    camera = render.camera_on(actor.GetBounds(), arguments.eye, up, zoom=1.35)
    render.write(render.render([actor], camera), arguments.picture)


if __name__ == "__main__":
    main()
