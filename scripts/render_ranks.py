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

COLORS = ((0.30, 0.52, 0.74), (0.89, 0.55, 0.24), (0.42, 0.65, 0.38), (0.79, 0.35, 0.40),
          (0.58, 0.49, 0.72), (0.93, 0.83, 0.45))


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
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(extract.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def actor_of(surface, table, shows_edges):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(table)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("rank")
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetEdgeVisibility(shows_edges)
    actor.GetProperty().SetEdgeColor(0.25, 0.25, 0.25)
    actor.GetProperty().SetLineWidth(0.5)
    return actor


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("volume", metavar="VOLUME.pvtu")
    parser.add_argument("interface", metavar="INTERFACE.pvtu")
    parser.add_argument("picture", metavar="PICTURE.png")
    arguments = parser.parse_args()
    volume, interface = read(arguments.volume), read(arguments.interface)
    ranks = int(volume.GetCellData().GetArray("rank").GetRange()[1]) + 1
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(ranks)
    table.SetTableRange(-0.5, ranks - 0.5)
    for rank in range(ranks):
        table.SetTableValue(rank, *COLORS[rank % len(COLORS)], 1)
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetInputData(interface)
    skin.Update()
    bounds = interface.GetBounds()
    radius = 0.62 * max(bounds[2 * k + 1] - bounds[2 * k] for k in range(3))
    shift = 1.25 * (bounds[1] - bounds[0])
    front = actor_of(skin.GetOutput(), table, True)
    section = actor_of(cells_behind(volume, interface.GetCenter(), radius), table, True)
    section.SetPosition(shift, 0, 0)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in (front, section):
        actor.GetProperty().SetAmbient(0.25)
        renderer.AddActor(actor)
    camera = vtk.vtkCamera()
    camera.SetPosition(0, 0, 1)
    camera.SetViewUp(0, 1, 0)
    renderer.SetActiveCamera(camera)
    renderer.ResetCamera()
    camera.Zoom(2)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1000, 400)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    render.write(image.GetOutput(), arguments.picture)


if __name__ == "__main__":
    main()
