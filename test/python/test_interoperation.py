"""Meshes and images of other packages."""

import io
import sys
import types

import dsc
import numpy as np
import pytest
from shapes import ball, disk


@pytest.mark.parametrize("make", [ball, disk])
def test_meshio(make):
    pytest.importorskip("meshio")
    c = make()
    c.vertex_values["x"] = c.cells().points[:, 0]
    c.cell_values["pair"] = np.c_[c.qualities, c.qualities]
    mesh = c.to_meshio()
    assert np.array_equal(mesh.points, c.cells().points)
    assert np.array_equal(mesh.cells[0].data, c.cells().cells)
    assert np.array_equal(mesh.cell_data["label"][0], c.cells().labels)
    assert mesh.point_data["x"].shape == (c.number_of_vertices,)
    assert mesh.cell_data["pair"][0].shape == (c.number_of_cells, 2)


@pytest.mark.parametrize("make", [ball, disk])
def test_vtk(make):
    vtk = pytest.importorskip("vtk")
    c = make()
    c.cell_values["pair"] = np.c_[c.qualities, c.qualities]
    c.vertex_values["x"] = c.cells().points[:, 0]
    grid = c.to_vtk()
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    values = sizes.GetOutput().GetCellData()
    of_label = values.GetArray("Volume" if c.dimension == 3 else "Area")
    volume = sum(
        of_label.GetTuple1(i)
        for i in range(c.number_of_cells)
        if values.GetArray("label").GetTuple1(i) == 1
    )
    assert volume == pytest.approx(c.volumes[1])
    assert values.GetArray("pair").GetNumberOfComponents() == 2
    assert grid.GetPointData().GetArray("x").GetNumberOfTuples() == c.number_of_vertices


def test_pyvista():
    pyvista = pytest.importorskip("pyvista")
    assert isinstance(ball().to_pyvista(), pyvista.UnstructuredGrid)


def voxels():
    x = np.linspace(-1, 1, 24)
    X, Y, Z = np.meshgrid(x, x, x[:20], indexing="ij")
    return (X**2 + 2 * Y**2 + (Z + 0.1) ** 2 < 0.4).astype(np.uint8)


AFFINES = {
    "scaled": np.diag([0.5, 0.5, 1.0, 1.0]),
    "permuted": np.array([[0, -0.5, 0, 10], [0.7, 0, 0, -3], [0, 0, -1, 4], [0, 0, 0, 1.0]]),
    "oblique": np.array([[0.8, -0.3, 0, 1], [0.6, 0.4, 0, 2], [0, 0, -1.0, 3], [0, 0, 0, 1]]),
}


@pytest.mark.parametrize("name", AFFINES)
def test_images_of_nibabel(name):
    nibabel = pytest.importorskip("nibabel")
    affine = AFFINES[name]
    labels = voxels()
    c = dsc.Complex3.from_image(nibabel.Nifti1Image(labels, affine))
    assert c.is_valid()
    assert c.volumes[1] == pytest.approx(labels.sum() * abs(np.linalg.det(affine)), rel=1e-6)
    center = np.argwhere(labels == 1).mean(axis=0) @ affine[:3, :3].T + affine[:3, 3]
    cells = c.cells()
    p = cells.points[cells.cells[cells.labels == 1]]
    weights = np.abs(np.linalg.det(p[:, 1:] - p[:, :1]))
    assert np.average(p.mean(axis=1), axis=0, weights=weights) == pytest.approx(center, abs=0.1)
    with pytest.raises(TypeError):
        dsc.Complex3.from_image(nibabel.Nifti1Image(labels, affine), 2.0)


def test_images_of_simpleitk(monkeypatch):
    """SimpleITK is not in Debian. The test uses an image with the same functions."""
    labels = voxels()

    class Image:
        def GetSpacing(self):
            return (0.5, 0.7, 1.0)

        def GetOrigin(self):
            return (3.0, 4.0, 5.0)

        def GetDirection(self):
            return (1.0, 0, 0, 0, 1.0, 0, 0, 0, 1.0)

    module = types.ModuleType("SimpleITK")
    module.GetArrayFromImage = lambda image: labels.T
    monkeypatch.setitem(sys.modules, "SimpleITK", module)
    c = dsc.Complex3.from_image(Image())
    assert c == dsc.Complex3.from_image(labels, (0.5, 0.7, 1.0), (3, 4, 5))


def test_labels_at_voxels():
    """Away from the interface, the labels are those of the function."""
    c = dsc.Complex3.from_function(lambda p: (np.linalg.norm(p, axis=1) < 0.5).astype(int),
                                   [(-1, -1, -1), (1, 1, 1)], 0.1)  # fmt: skip
    image = c.to_image((21, 11, 24), (0.1, 0.2, 0.1), (-1, -1, -1.2), outside=7)
    assert image.shape == (21, 11, 24)
    x, y, z = np.meshgrid(-1 + 0.1 * np.arange(21), -1 + 0.2 * np.arange(11),
                          -1.2 + 0.1 * np.arange(24), indexing="ij")  # fmt: skip
    r = np.sqrt(x**2 + y**2 + z**2)
    assert np.all(image[r < 0.45] == 1)
    assert np.all(image[(r > 0.55) & (np.abs(z) < 0.99)] == 0)
    assert np.all(image[np.abs(z) > 1.01] == 7)
    for wrong in (3, 3), (3, 3, 0), (2**31, 2**31, 1):
        with pytest.raises(ValueError):
            c.to_image(wrong, 1, (0, 0, 0))
    with pytest.raises(dsc.Error):
        c.to_image((3, 3, 3), -1, (0, 0, 0))
    with pytest.raises(dsc.Interrupted):
        c.to_image((300, 300, 300), 0.01, (-1, -1, -1), progress=lambda phase: False)


def test_labels_at_pixels():
    c = disk()
    image = c.to_image((400, 400), 0.01, (-2, -2))
    assert image.sum() * 1e-4 == pytest.approx(c.volumes[1], rel=0.02)


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_progress_line(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(dsc.ProgressLine, "_delay", 0.0)
    ball().improve(quality_threshold=0.6, progress=True)
    text = terminal.getvalue()
    assert " s" in text
    assert text.endswith("\r")
    monkeypatch.setattr(sys, "stderr", io.StringIO())  # no terminal
    ball().improve(progress=True)
    assert sys.stderr.getvalue() == ""
    ball().improve(progress=False)
    with pytest.raises(TypeError):
        ball().improve(progress=3)
