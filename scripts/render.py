#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders the first, the middle and the last step of a run of `dsc --output DIR`.

Writes for each step interface_NNNNNN.png, the interface, and cut_NNNNNN.png, the tetrahedra behind a
plane through the centre, coloured by label. strip.png shows all pictures in two rows. With --frames,
writes only strip.png, a row of small pictures of the interface. Needs VTK 9 for Python (Debian:
python3-vtk9). Without a display, run the script with xvfb-run.
"""

import argparse
import math
import os
import sys
import xml.etree.ElementTree as ElementTree

import vtk

SIZE = (1200, 900)
# Reduction factor of a picture in the strip of three steps. A strip of N frames is about as wide as a
# single picture.
SHRINKING = 2
# The y axis points up. The view is from the front (+z), slightly from the right and above. The front
# half is cut away.
VIEW_DIRECTION = (-0.4, -0.3, -0.9)
VIEW_UP = (0, 1, 0)
# Half the height of a picture, in multiples of half the diagonal of the interface.
SHOWN_HEIGHT = 0.72
# The margin in a strip of frames; with 1 the interfaces exactly fit.
MARGIN = 1.1
# Radius around the centre in which tetrahedra are shown, in multiples of half the diagonal.
SHOWN_RADIUS = 0.8
# Label 0 is pale. Further labels repeat the colours after the first one.
COLOURS = ((0.90, 0.90, 0.88), (0.30, 0.52, 0.74), (0.89, 0.55, 0.24), (0.42, 0.65, 0.38),
           (0.72, 0.36, 0.42), (0.55, 0.45, 0.68), (0.80, 0.70, 0.30))
EDGE_COLOUR = (0.15, 0.15, 0.18)
BORDER_GREY = 200  # of 255


class Failure(Exception):
    """An error message of one line with advice."""


def read_collection(path):
    """Returns the data files of a ParaView collection, sorted by time."""
    try:
        entries = ElementTree.parse(path).getroot().iter("DataSet")
        folder = os.path.dirname(path)
        series = [(float(e.get("timestep")), os.path.join(folder, e.get("file"))) for e in entries]
    except (OSError, ElementTree.ParseError, TypeError, ValueError) as error:
        raise Failure(f"cannot read {path} ({error}); run dsc with --output first")
    if not series:
        raise Failure(f"{path} lists no step; run dsc with --output first")
    return sorted(series)


def read_grid(path):
    if not os.path.isfile(path):
        raise Failure(f"{path} is missing; write the series again")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    readable = reader.CanReadFile(path)
    reader.Update()
    if not readable or reader.GetErrorCode():
        raise Failure(f"{path} is no VTK unstructured grid; write the series again")
    return reader.GetOutput()


def read_labels(path):
    """Returns a mesh and the array of its labels. Ends the script if they cannot be read."""
    script = os.path.basename(sys.argv[0])
    try:
        grid = read_grid(path)
    except Failure as error:
        raise SystemExit(f"{script}: {error}") from None
    labels = grid.GetCellData().GetArray("label")
    if labels is None:
        raise SystemExit(f"{script}: {path} has no labels")
    return grid, labels


def evenly_spread(series, count):
    last = len(series) - 1
    return [series[i] for i in sorted({k * last // (count - 1) for k in range(count)})]


def colour_index(label):
    return 0 if label == 0 else 1 + (label - 1) % (len(COLOURS) - 1)


def colour_table(colours, first=0):
    """Returns a table of the colours of first, first + 1, ..."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(len(colours))
    table.SetTableRange(first, first + len(colours) - 1)
    for i, colour in enumerate(colours):
        table.SetTableValue(i, *colour, 1)
    return table


def surface_of(source):
    """Returns the boundary faces of the cells that a filter produces."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(source.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def cells_with_labels(grid, lowest, highest):
    """Returns a filter that produces the cells whose labels are in a range."""
    cells = vtk.vtkThreshold()
    cells.SetInputData(grid)
    cells.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "label")
    cells.SetLowerThreshold(lowest)
    cells.SetUpperThreshold(highest)
    cells.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_BETWEEN)
    return cells


def surface_actor(grid, label_array):
    """Returns the boundary faces of the cells with the colours of the labels, and edges."""
    labels = grid.GetCellData().GetArray(label_array)
    colours = vtk.vtkIntArray()
    colours.SetName("colour")
    for cell in range(grid.GetNumberOfCells()):
        colours.InsertNextValue(colour_index(int(labels.GetComponent(cell, 0))))
    grid.GetCellData().AddArray(colours)
    source = vtk.vtkTrivialProducer()
    source.SetOutput(grid)
    return edged(labeled_actor(surface_of(source), colour_table(COLOURS), 0.25, "colour"), EDGE_COLOUR, 1)


def edged(actor, colour, width):
    look = actor.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(*colour)
    look.SetLineWidth(width)
    return actor


def labeled_actor(surface, table, ambient, array="label"):
    """Returns a surface with flat shading, in the colours that a table gives to the values of an array."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(array)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(ambient)
    actor.GetProperty().SetDiffuse(1 - ambient)
    return actor


def camera_on(bounds, eye, up, zoom):
    """Returns a camera in the direction of the eye that shows the bounds."""
    camera = vtk.vtkCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*eye)
    camera.SetViewUp(*up)
    renderer = vtk.vtkRenderer()
    renderer.SetActiveCamera(camera)
    renderer.ResetCamera(bounds)
    camera.Zoom(zoom)
    return camera


def interface_actor(path):
    return surface_actor(read_grid(path), "label_pair")


def cut_actor(path, centre, radius):
    """Returns the tetrahedra near the centre whose barycentre is behind the plane through the centre."""
    grid = read_grid(path)
    centres = vtk.vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()
    barycentres = centres.GetOutput().GetPoints()
    ids = vtk.vtkIdTypeArray()
    for cell in range(grid.GetNumberOfCells()):
        shift = [b - c for b, c in zip(barycentres.GetPoint(cell), centre)]
        if shift[2] <= 0 and math.hypot(*shift) <= SHOWN_RADIUS * radius:
            ids.InsertNextValue(cell)
    node = vtk.vtkSelectionNode()
    node.SetFieldType(vtk.vtkSelectionNode.CELL)
    node.SetContentType(vtk.vtkSelectionNode.INDICES)
    node.SetSelectionList(ids)
    selection = vtk.vtkSelection()
    selection.AddNode(node)
    extract = vtk.vtkExtractSelection()
    extract.SetInputData(0, grid)
    extract.SetInputData(1, selection)
    extract.Update()
    return surface_actor(extract.GetOutput(), "label")


def bounds_of(grids):
    """The bounds of all of them together, and their centre."""
    bounds = vtk.vtkBoundingBox()
    for grid in grids:
        bounds.AddBounds(grid.GetBounds())
    if not bounds.IsValid():
        raise Failure("there is no interface in any of the steps; nothing can be shown")
    centre = [0.0, 0.0, 0.0]
    bounds.GetCenter(centre)
    return bounds, centre


def view_of(paths):
    """Returns the centre and half the diagonal of the bounding box of all these interfaces."""
    bounds, centre = bounds_of(read_grid(path) for path in paths)
    return centre, bounds.GetDiagonalLength() / 2


def camera_at(centre, height):
    """Returns a camera that looks at the centre; the height of the view is twice `height`."""
    camera = vtk.vtkCamera()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(c - 10 * height * d for c, d in zip(centre, VIEW_DIRECTION)))
    camera.SetViewUp(*VIEW_UP)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(height)
    return camera


def transformed(grid, transform):
    apply = vtk.vtkTransformFilter()
    apply.SetInputData(grid)
    apply.SetTransform(transform)
    apply.Update()
    return apply.GetOutput()


def closest_camera(paths):
    """Returns the camera with the smallest view that contains all these interfaces."""
    to_view = vtk.vtkTransform()
    to_view.SetMatrix(camera_at((0, 0, 0), 1).GetViewTransformMatrix())
    bounds, centre = bounds_of(transformed(read_grid(path), to_view) for path in paths)
    width, height = bounds.GetLength(0), bounds.GetLength(1)
    return camera_at(to_view.GetInverse().TransformPoint(centre),
                     MARGIN * max(height, width * SIZE[1] / SIZE[0]) / 2)


def render(actors, camera, size=SIZE):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    renderer.SetActiveCamera(camera)
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return grab.GetOutput()


def cropped(image, size):
    """Cuts off the white margins; the larger extent becomes `size` pixels."""
    width, height, _ = image.GetDimensions()
    scalars = image.GetPointData().GetScalars()
    shown = [i for i in range(width * height) if scalars.GetTuple(i) != (255, 255, 255)]
    columns, rows = {i % width for i in shown}, {i // width for i in shown}
    part = vtk.vtkExtractVOI()
    part.SetInputData(image)
    part.SetVOI(min(columns), max(columns), min(rows), max(rows), 0, 0)
    part.Update()
    extents = part.GetOutput().GetDimensions()[:2]
    resized = vtk.vtkImageResize()
    resized.SetInputConnection(part.GetOutputPort())
    resized.SetOutputDimensions(*(round(size * n / max(extents)) for n in extents), 1)
    resized.Update()
    return resized.GetOutput()


def write(image, path):
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()
    if writer.GetErrorCode():
        raise Failure(f"cannot write {path}; check that the folder may be written to")


def appended(images, axis):
    append = vtk.vtkImageAppend()
    append.SetAppendAxis(axis)
    for image in images:
        append.AddInputData(image)
    append.Update()
    return append.GetOutput()


def tile(image, shrinking):
    shrink = vtk.vtkImageShrink3D()
    shrink.SetInputData(image)
    shrink.SetShrinkFactors(shrinking, shrinking, 1)
    shrink.Update()
    return shrink.GetOutput()


def with_border(image):
    """Adds a line on the right that separates a frame from the next one."""
    width, height, _ = image.GetDimensions()
    pad = vtk.vtkImageConstantPad()
    pad.SetInputData(image)
    pad.SetOutputWholeExtent(0, width, 0, height - 1, 0, 0)
    pad.SetConstant(BORDER_GREY)
    pad.Update()
    return pad.GetOutput()


def render_frames(series, count, out):
    interfaces = [path for _, path in evenly_spread(series, count)]
    camera = closest_camera(interfaces)
    row = [tile(render([interface_actor(path)], camera), count) for path in interfaces]
    row = [with_border(image) for image in row[:-1]] + row[-1:]
    write(appended(row, axis=0), os.path.join(out, "strip.png"))


def render_three_steps(series, volumes, out):
    interfaces = evenly_spread(series, 3)
    centre, radius = view_of([path for _, path in interfaces])
    camera = camera_at(centre, SHOWN_HEIGHT * radius)
    rows = ([], [])
    for time, path in interfaces:
        if time not in volumes:
            raise Failure(f"volume.pvd lacks time {time:g} of interface.pvd; "
                          "write the series again")
        number = os.path.splitext(os.path.basename(path))[0].rpartition("_")[2]
        actors = (interface_actor(path), cut_actor(volumes[time], centre, radius))
        for row, name, actor in zip(rows, ("interface", "cut"), actors):
            image = render([actor], camera)
            write(image, os.path.join(out, f"{name}_{number}.png"))
            row.append(tile(image, SHRINKING))
    # The rows of VTK images go upwards.
    strip = appended([appended(row, axis=0) for row in reversed(rows)], axis=1)
    write(strip, os.path.join(out, "strip.png"))


def number_of_frames(text):
    count = int(text)
    if count < 2:
        raise argparse.ArgumentTypeError("a strip needs at least two frames")
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="DIR", help="folder of a run: the DIR of dsc --output DIR")
    parser.add_argument("--out", metavar="DIR", help="folder for the images; default: the folder of the run")
    parser.add_argument("--frames", metavar="N", type=number_of_frames,
                        help="write only a strip of the interface at N steps, from the first to the last")
    arguments = parser.parse_args()
    out = arguments.out or arguments.folder
    vtk.vtkObject.GlobalWarningDisplayOff()  # errors are printed in one line

    series = read_collection(os.path.join(arguments.folder, "interface.pvd"))
    os.makedirs(out, exist_ok=True)
    if arguments.frames:
        render_frames(series, arguments.frames, out)
    else:
        volumes = dict(read_collection(os.path.join(arguments.folder, "volume.pvd")))
        render_three_steps(series, volumes, out)


if __name__ == "__main__":
    try:
        main()
    except (Failure, OSError) as failure:
        sys.exit(f"render.py: {failure}")
