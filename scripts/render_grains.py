#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders the labels of a mesh (.vtu), such as the grains of a polycrystal, moved apart.

Needs VTK 9 for Python (Debian: python3-vtk9). Without a display, run the script with xvfb-run.
"""

import argparse
import colorsys

import render
import vtk


def color(label):
    """Returns the color of a label. The hues of successive labels are far apart."""
    golden = 0.618034
    return colorsys.hls_to_rgb(golden * label % 1, (0.68, 0.78, 0.6)[label % 3], 0.5)


def moved_apart(grid, labels, distance):
    """Returns the surfaces of all labels, away from the center of the mesh."""
    result = vtk.vtkAppendPolyData()
    center = grid.GetCenter()
    for label in labels:
        surface = render.surface_of(render.cells_with_labels(grid, label, label))
        middle = vtk.vtkCenterOfMass()
        middle.SetInputData(surface)
        middle.Update()
        motion = vtk.vtkTransform()
        motion.Translate(*(distance * (a - b) for a, b in zip(middle.GetCenter(), center)))
        moved = vtk.vtkTransformPolyDataFilter()
        moved.SetTransform(motion)
        moved.SetInputData(surface)
        moved.Update()
        result.AddInputData(moved.GetOutput())
    result.Update()
    return result.GetOutput()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", metavar="MESH.vtu")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("--distance", type=float, default=0.45, help="motion, in distances from the center")
    parser.add_argument("--eye", type=float, nargs=3, default=[0.5, -1, 0.6], help="direction to the camera")
    parser.add_argument("--solids", action="store_true", help="draw edges, no label 0 and no margins")
    arguments = parser.parse_args()
    grid, array = render.read_labels(arguments.mesh)
    hidden = {0} if arguments.solids else set()
    labels = sorted({int(array.GetValue(i)) for i in range(array.GetNumberOfTuples())} - hidden)
    # A table with gaps would be drawn transparent.
    table = render.colour_table([color(label) for label in range(labels[-1] + 1)])
    actor = render.labeled_actor(moved_apart(grid, labels, arguments.distance), table, ambient=0.2)
    camera = render.camera_on(actor.GetBounds(), arguments.eye, (0, 0, 1), zoom=1.15)
    if arguments.solids:
        render.edged(actor, render.EDGE_COLOUR, 1)
    image = render.render([actor], camera)
    render.write(render.cropped(image, 640) if arguments.solids else image, arguments.picture)


if __name__ == "__main__":
    main()
