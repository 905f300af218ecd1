#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders a surface with boundaries (.ply) from both sides: the front is blue, the back is orange.

Needs VTK 9 for Python (Debian: python3-vtk9). Without a display, run the script with xvfb-run.
"""

import argparse

import render
import vtk


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", metavar="SURFACE.ply")
    parser.add_argument("picture", metavar="PICTURE.png")
    parser.add_argument("--eye", type=float, nargs=3, default=[0.5, -1, 0.8], help="direction to the camera")
    arguments = parser.parse_args()
    reader = vtk.vtkPLYReader()
    reader.SetFileName(arguments.surface)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    back = vtk.vtkProperty()
    for look, color in ((actor.GetProperty(), render.COLOURS[1]), (back, render.COLOURS[2])):
        look.SetColor(*color)
        look.SetInterpolationToFlat()
        look.SetAmbient(0.25)
    actor.SetBackfaceProperty(back)
    camera = render.camera_on(actor.GetBounds(), arguments.eye, (0, 0, 1), zoom=1.15)
    image = render.render([render.edged(actor, render.EDGE_COLOUR, 1)], camera)
    render.write(render.cropped(image, 640), arguments.picture)


if __name__ == "__main__":
    main()
