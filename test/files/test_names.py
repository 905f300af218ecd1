"""A model of three named materials through a motion: its names, labels and arrays, as VTK reads the results.

The table "A Model through a Motion" of the manual contains what arrives. Volumes are those of boxes, so that the
expected values come from no reader."""

import json
import os
import pathlib
import re
import subprocess

import foreign_files as files
import numpy as np
import pytest

DSC = os.environ["DSC_PROGRAM"]
pytestmark = pytest.mark.skipif(
    not (pathlib.Path(DSC).parent / "dsc-files").exists(), reason="dsc-files is not built: VTK is missing"
)
vtk = pytest.importorskip("vtk")
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402

MANUAL = pathlib.Path(__file__).parents[2] / "doc/Dsc_program/Dsc_program.txt"
TABLE = re.findall(
    r"^\| (`\..*?`) \| (`\..*?`) \| (.*?) \| (.*?) \|$",
    MANUAL.read_text().split("\\subsection Dsc_programModel ")[1].split("\\subsection")[0],
    re.M,
)
CASES = [
    (source, target, names, arrays)
    for sources, targets, names, arrays in TABLE
    for source in re.findall(r"\.\w+", sources)
    for target in re.findall(r"\.\w+", targets)
]
NAMES = ['upper "shell" <&>', "Kern größe #2", "7"]
DISTANCE = 0.05
FACES = np.array([[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3], [0, 4, 6],
                  [0, 6, 2], [1, 3, 7], [1, 7, 5]])  # fmt: skip
# Two boxes with a common wall, and one apart from them.
BOXES = [((0, 0, 0), (1, 1, 1)), ((1, 0, 0), (3, 1, 1)), ((4, 0, 0), (5, 1, 1))]


def run(*arguments):
    return subprocess.run([DSC, *map(str, arguments)], capture_output=True, timeout=300, encoding="utf-8")


def corners(box):
    low, high = map(np.array, box)
    return np.array([np.where([x, y, z], high, low) for z in (0, 1) for y in (0, 1) for x in (0, 1)])


def write_surface(path, names=NAMES, boxes=BOXES):
    """Writes a box for each name."""
    if path.suffix == ".3mf":
        quoted = [n.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;") for n in names]
        objects = "".join(
            f'<object id="{i + 1}" type="model" name="{name}">{files.mesh_3mf(corners(box), FACES)}</object>'
            for i, (name, box) in enumerate(zip(quoted, boxes))
        )
        items = "".join(f'<item objectid="{i + 1}"/>' for i in range(len(boxes)))
        return files.pack_3mf(path, "millimeter", objects, items)
    with path.open("w", encoding="utf-8") as out:
        for i, (name, box) in enumerate(zip(names, boxes)):
            if path.suffix == ".obj":
                out.write(f"o {name}\n")
                out.writelines("v {} {} {}\n".format(*p) for p in corners(box))
                out.writelines("f {} {} {}\n".format(*(8 * i + 1 + f)) for f in FACES)
            else:
                out.write(f"solid {name}\n")
                for face in FACES:
                    vertices = "".join("vertex {} {} {}\n".format(*p) for p in corners(box)[face])
                    out.write(f"facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
                out.write(f"endsolid {name}\n")


def grid_of_boxes():
    """Returns the boxes as tetrahedra, by VTK, with an array on cells and an array on points."""
    append = vtk.vtkAppendFilter()
    append.MergePointsOn()
    for label, (low, high) in enumerate(BOXES, 1):
        image = vtk.vtkImageData()
        size = 4 * (np.array(high) - low) + 1
        image.SetDimensions(*map(int, size))
        image.SetOrigin(*low)
        image.SetSpacing(0.25, 0.25, 0.25)
        tetrahedra = vtk.vtkDataSetTriangleFilter()
        tetrahedra.SetInputData(image)
        tetrahedra.Update()
        part = tetrahedra.GetOutput()
        number = np.arange(part.GetNumberOfCells())
        part.GetCellData().AddArray(files.named(np.full(len(number), label, np.int32), "label"))
        part.GetCellData().AddArray(files.named(1 + number % 5 / 4, "density"))
        append.AddInputData(part)
    append.Update()
    grid = append.GetOutput()
    x = vtk_to_numpy(grid.GetPoints().GetData())[:, 0].astype(float)
    grid.GetPointData().AddArray(files.named(x, "temperature"))
    strings = vtk.vtkStringArray()
    strings.SetName("label_names")
    for name in NAMES:
        strings.InsertNextValue(name)
    grid.GetFieldData().AddArray(files.named(np.array([1, 2, 3], np.int32), "named_labels"))
    grid.GetFieldData().AddArray(strings)
    return grid


def write_cells(path):
    grid = grid_of_boxes()
    if path.suffix == ".vtu":
        files.write_vtu(path, grid=grid)
    elif path.suffix == ".vtk":
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(grid)
        writer.Write()
    elif path.suffix == ".vtm":
        blocks = vtk.vtkMultiBlockDataSet()
        for i, name in enumerate(NAMES):
            part = vtk.vtkThreshold()
            part.SetInputData(grid)
            part.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "label")
            part.SetLowerThreshold(i + 1)
            part.SetUpperThreshold(i + 1)
            part.Update()
            blocks.SetBlock(i, part.GetOutput())
            blocks.GetMetaData(i).Set(vtk.vtkCompositeDataSet.NAME(), name)
        writer = vtk.vtkXMLMultiBlockDataWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(blocks)
        writer.Write()
    else:
        points = vtk_to_numpy(grid.GetPoints().GetData())
        cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4) + 1
        labels = vtk_to_numpy(grid.GetCellData().GetArray("label"))
        names = "".join(f'3 {i} "{name}"\n' for i, name in enumerate(NAMES, 1))
        rows = "".join("{} {} {} {}\n".format(i, *p) for i, p in enumerate(points, 1))
        elements = "".join(
            "{0} 4 2 {1} {1} {2} {3} {4} {5}\n".format(i, label, *cell)
            for i, (label, cell) in enumerate(zip(labels, cells), 1)
        )
        path.write_text(
            f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n{names}$EndPhysicalNames\n"
            f"$Nodes\n{len(points)}\n{rows}$EndNodes\n$Elements\n{len(cells)}\n{elements}$EndElements\n",
            encoding="utf-8",
        )


def cells_of(grid):
    """Returns the points, the cells and their volumes."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    p = points[cells]
    return points, cells, np.linalg.det(p[:, 1:] - p[:, :1]) / 6


def read_grid(path):
    """Returns a grid, and for each name whether a cell has its label, as VTK reads them."""
    reader = vtk.vtkXMLUnstructuredGridReader() if path.suffix == ".vtu" else vtk.vtkUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    labels = vtk_to_numpy(grid.GetCellData().GetArray("label"))
    strings = grid.GetFieldData().GetAbstractArray("label_names")
    numbers = vtk_to_numpy(grid.GetFieldData().GetArray("named_labels"))
    return grid, {strings.GetValue(i): labels == label for i, label in enumerate(numbers)}


def read_surface(path):
    """Returns the volume inside the triangles of each name. STL files of VTK have the solids as numbers."""
    text = path.read_text(encoding="utf-8")
    names = re.findall(r"^(?:o|solid) (.*)$", text, re.M)
    if path.suffix == ".stl":
        reader = vtk.vtkSTLReader()
        reader.ScalarTagsOn()
        reader.SetFileName(str(path))
        reader.Update()
        surface = reader.GetOutput()
        part = vtk_to_numpy(surface.GetCellData().GetArray(0)).astype(int)
        points = vtk_to_numpy(surface.GetPoints().GetData())
        triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    else:  # VTK has no names of objects
        points = np.array([line.split()[1:] for line in re.findall("^v .*$", text, re.M)], float)
        objects = re.split("^o .*$", text, flags=re.M)[1:]
        faces = [re.findall(r"^f (\d+) (\d+) (\d+)$", lines, re.M) for lines in objects]
        triangles = np.concatenate([np.array(f, int) - 1 for f in faces])
        part = np.repeat(np.arange(len(faces)), [len(f) for f in faces])
    volumes = np.linalg.det(points[triangles].astype(float)) / 6
    return {name: volumes[part == i].sum() for i, name in enumerate(names)}


def expected_volumes():
    """Each part of the boundary moves by the distance. The common wall stays."""
    d = DISTANCE
    sizes = [(1 + d) * (1 + 2 * d) ** 2, (2 + d) * (1 + 2 * d) ** 2, (1 + 2 * d) ** 3]
    return dict(zip(NAMES, sizes))


def skip_if_missing(path):
    message = run("info", path).stderr
    if "without Gmsh" in message or "without lib3mf" in message:
        pytest.skip("the library of this format is missing")


@pytest.mark.parametrize(("source", "target", "names", "arrays"), CASES)
def test_model_through_a_motion(source, target, names, arrays, tmp_path):
    path = tmp_path / f"model{source}"
    (write_surface if source in (".stl", ".obj", ".3mf") else write_cells)(path)
    skip_if_missing(path)
    moved = run("offset", path, "--distance", DISTANCE, "--steps", 1, "--output", tmp_path / "run")
    assert moved.returncode == 0, moved.stderr
    result = tmp_path / f"result{target}"
    written = "checkpoint.dsc" if target in (".stl", ".obj") else "volume_000001.vtu"
    converted = run("convert", tmp_path / "run" / written, result)
    assert converted.returncode == 0, converted.stderr
    assert names == "kept"
    expected = expected_volumes()
    if target in (".stl", ".obj"):
        assert read_surface(result) == pytest.approx(expected, rel=1e-6)
        return
    grid, of_names = read_grid(result)
    points, tetrahedra, volumes = cells_of(grid)
    assert {name: volumes[cells].sum() for name, cells in of_names.items()} == pytest.approx(expected, rel=1e-6)
    assert (arrays == "kept") == bool(grid.GetCellData().HasArray("density"))
    if arrays != "kept":
        return
    before = grid_of_boxes()
    density = vtk_to_numpy(grid.GetCellData().GetArray("density"))
    old_mass = cells_of(before)[2] * vtk_to_numpy(before.GetCellData().GetArray("density"))
    old_labels = vtk_to_numpy(before.GetCellData().GetArray("label"))
    for label, cells in enumerate(of_names.values(), 1):
        assert np.dot(volumes[cells], density[cells]) == pytest.approx(old_mass[old_labels == label].sum(), rel=1e-6)
    temperature = vtk_to_numpy(grid.GetPointData().GetArray("temperature"))
    inside = np.unique(tetrahedra[np.any(list(of_names.values()), axis=0)])
    assert np.abs(temperature - points[:, 0])[inside].max() < 2 * DISTANCE


ODD = ["a  b", "ring", "ring", "ring (2)", "", "it's", "x" * 300, "-1", "a,b", "solid", "é\u00a0\u200b"]


@pytest.mark.parametrize("suffix", [".obj", ".stl", ".vtu"])
def test_odd_names_stay_apart(suffix, tmp_path):
    """Names are equal, empty, long or numbers. Parts with equal names of surfaces are one part."""
    boxes = [((2 * i, 0, 0), (2 * i + 1, 1, 1)) for i in range(len(ODD))]
    write_surface(tmp_path / "a.obj", ODD, boxes)
    assert run("rotate", tmp_path / "a.obj", "--axis", "0,0,1", "--angle", 360, "--steps", 1, "--output",
               tmp_path / "run").returncode == 0  # fmt: skip
    result = tmp_path / f"b{suffix}"
    assert run("convert", tmp_path / "run/checkpoint.dsc", result).returncode == 0
    again = run("rotate", result, "--axis", "0,0,1", "--angle", 360, "--steps", 1, "--report", tmp_path / "r.json")
    assert again.returncode == 0, again.stderr
    labels = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))["steps"][-1]["labels"]
    volumes = {label.get("name", ""): label["volume"] for label in labels if label["label"] != 0}
    assert sum(volumes.values()) == pytest.approx(len(ODD))
    assert volumes["ring"] == pytest.approx(2)
    for name in "a b", "ring (2)", "it's", "x" * 300, "-1", "a,b", "solid", "é\u00a0\u200b":
        assert volumes[name] == pytest.approx(1)


def test_equal_names_of_labels_become_different(tmp_path):
    grid = grid_of_boxes()
    strings = grid.GetFieldData().GetAbstractArray("label_names")
    strings.SetValue(1, strings.GetValue(0) + "  ")
    strings.SetValue(2, " \n")
    files.write_vtu(tmp_path / "a.vtu", grid=grid)
    text = run("info", tmp_path / "a.vtu").stdout
    assert f"label 1 '{NAMES[0]}': " in text
    assert f"label 2 '{NAMES[0]} (2)': " in text
    assert "label 3: " in text


def test_thousands_of_parts(tmp_path):
    names = [f"part {i}" for i in range(2000)]
    boxes = [((2 * (i % 50), 2 * (i // 50), 0), (2 * (i % 50) + 1, 2 * (i // 50) + 1, 1)) for i in range(2000)]
    write_surface(tmp_path / "a.obj", names, boxes)
    result = run("convert", tmp_path / "a.obj", tmp_path / "a.stl")
    assert result.returncode == 0, result.stderr
    volumes = read_surface(tmp_path / "a.stl")
    assert list(volumes) == names
    assert list(volumes.values()) == pytest.approx([1] * 2000)
