#!/usr/bin/env bash
# Draws the picture of files of other programs in the manual: a gray image in the NIfTI format, written by
# VTK, and its interface after some steps of mean curvature flow.
# Usage: scripts/draw_formats.sh [BUILD_DIR]
. "$(dirname "$0")/figures.sh"
require "$build/dsc"
begin_in_temporary_folder

"$python" - <<'END'
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

n = 72
x, y, z = np.meshgrid(*3 * [np.linspace(-1, 1, n)], indexing="ij")
gyroid = np.sin(6 * x) * np.cos(6 * y) + np.sin(6 * y) * np.cos(6 * z) + np.sin(6 * z) * np.cos(6 * x)
inside = (np.abs(gyroid) < 0.5) & (x**2 + y**2 + z**2 < 0.85)
gray = np.where(inside, 160, 60) + np.random.default_rng(1).normal(0, 8, inside.shape)
image = vtk.vtkImageData()
image.SetDimensions(n, n, n)
image.SetSpacing(*3 * [2 / n])
image.GetPointData().SetScalars(numpy_to_vtk(gray.ravel(order="F").astype(np.int16), deep=True))
writer = vtk.vtkNIFTIImageWriter()
writer.SetInputData(image)
writer.SetFileName("gyroid.nii.gz")
writer.Write()
END
"$build/dsc" mean-curvature gyroid.nii.gz --threshold otsu --steps 5 --picture picture.png --quiet
mv picture.png "$source/doc/Dsc_program/fig/gray_image.png"
