#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders a complex of several processes: the interface and the tetrahedra behind a plane.

Each color is a process. Needs VTK 9 for Python (Debian: python3-vtk9). Without a display, run the script
with xvfb-run.
"""

import argparse

import render
import vtk

COLORS = render.COLOURS[1:]


def read(path):
    """Returns the grid of a list of pieces (.pvtu)."""
    reader = vtk.vtkXMLPUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetNumberOfCells() == 0 or grid.GetCellData().GetArray("rank") is None:
        raise SystemExit(f"render_ranks.py: {path} has no cells with the array 'rank'")
    grid.GetCellData().SetActiveScalars("rank")
    return grid


def cells_behind(grid, center, radius):
    """Returns the surface of the cells near a center that lie behind its plane y = constant."""
    ball = vtk.vtkSphere()
    ball.SetCenter(*center)
    ball.SetRadius(radius)
    plane = vtk.vtkPlane()
    plane.SetOrigin(*center)
    plane.SetNormal(0, 0, 1)
    both = vtk.vtkImplicitBoolean()
    both.SetOperationTypeToIntersection()
    both.AddFunction(ball)
    both.AddFunction(plane)
    extract = vtk.vtkExtractGeometry()
    extract.SetInputData(grid)
    extract.SetImplicitFunction(both)
    return render.surface_of(extract)


def actor_of(surface, table):
    return render.edged(render.labeled_actor(surface, table, 0.25, "rank"), (0.25, 0.25, 0.25), 0.5)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("volume", metavar="VOLUME.pvtu")
    parser.add_argument("interface", metavar="INTERFACE.pvtu")
    parser.add_argument("picture", metavar="PICTURE.png")
    arguments = parser.parse_args()
    volume, interface = read(arguments.volume), read(arguments.interface)
    ranks = int(volume.GetCellData().GetArray("rank").GetRange()[1]) + 1
    table = render.colour_table([COLORS[rank % len(COLORS)] for rank in range(ranks)])
    source = vtk.vtkTrivialProducer()
    source.SetOutput(interface)
    bounds = interface.GetBounds()
    radius = 0.62 * max(bounds[2 * k + 1] - bounds[2 * k] for k in range(3))
    shift = 1.25 * (bounds[1] - bounds[0])
    front = actor_of(render.surface_of(source), table)
    section = actor_of(cells_behind(volume, interface.GetCenter(), radius), table)
    section.SetPosition(shift, 0, 0)
    shown = vtk.vtkBoundingBox(front.GetBounds())
    shown.AddBounds(section.GetBounds())
    both = [0.0] * 6
    shown.GetBounds(both)
    camera = render.camera_on(both, (0, 0, 1), (0, 1, 0), zoom=2)
    render.write(render.render([front, section], camera, size=(1000, 400)), arguments.picture)


if __name__ == "__main__":
    main()
