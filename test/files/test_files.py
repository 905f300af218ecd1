"""Reads files that other programs wrote, by `dsc`. Expected values do not come from its readers."""

import json
import os
import pathlib
import random
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

BALL = {"label 0": 2248, "label 1": 312}  # tetrahedra of vtk_grid()


def run(*arguments, **options):
    return subprocess.run(
        [DSC, *map(str, arguments)], capture_output=True, timeout=120, text=True, **options
    )


def info(*arguments):
    """Returns the number of tetrahedra, triangles or voxels of each label, and the whole text."""
    result = run("info", *arguments)
    assert result.returncode == 0, result.stderr
    numbers = {m[1]: int(m[2]) for m in re.finditer(r"(label -?\d+)(?: '.*')?: (\d+)", result.stdout)}
    return numbers, result.stdout


ENCODINGS = [(m, c) for m in ("Ascii", "Binary", "Appended") for c in ("None", "ZLib", "LZ4", "LZMA")]


@pytest.mark.parametrize(("mode", "compressor"), ENCODINGS)
def test_grids_of_paraview(tmp_path, mode, compressor):
    path = tmp_path / "grid.vtu"
    files.write_vtu(path, mode, compressor)
    assert info(path)[0] == BALL


@pytest.mark.parametrize("compressor", ["None", "ZLib", "LZ4"])
def test_raw_grids(tmp_path, compressor):
    path = tmp_path / "grid.vtu"
    files.write_vtu(path, "Appended", compressor, raw=True)
    assert info(path)[0] == BALL


def test_pieces_are_put_together(tmp_path):
    path = tmp_path / "grid.vtu"
    files.write_pieces(path)
    assert info(path)[0] == BALL


def arrays_of(path):
    """Returns the cells of a grid and its arrays on points and cells, as VTK reads them."""
    from vtk.util.numpy_support import vtk_to_numpy

    reader = vtk.vtkXMLUnstructuredGridReader() if path.suffix == ".vtu" else vtk.vtkUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    points, cells = (
        {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
        for data in (grid.GetPointData(), grid.GetCellData())
    )
    coordinates = vtk_to_numpy(grid.GetPoints().GetData())
    corners = coordinates[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    return coordinates, volumes, points, cells


@pytest.mark.parametrize("compressor", ["None", "ZLib"])
def test_arrays_follow_a_motion_from_vtk_to_vtk(tmp_path, compressor):
    files.write_vtu(tmp_path / "in.vtu", "Appended", compressor, grid=files.three_materials())
    _, volumes, points, cells = arrays_of(tmp_path / "in.vtu")
    assert set(points) == {"temperature", "velocity"} and set(cells) == {"material", "density", "mask", "ids"}
    output = ("--output", tmp_path / "out", "--steps", 2)
    result = run("offset", tmp_path / "in.vtu", "--labels", "material", "--distance", 0.02, *output)
    assert result.returncode == 0, result.stderr
    assert "1 array of cell numbers, which change ('ids')" in result.stderr
    assert run("convert", tmp_path / "out/volume_000002.vtu", tmp_path / "out.vtk").returncode == 0
    for path in tmp_path / "out/volume_000002.vtu", tmp_path / "out.vtk":
        coordinates, new_volumes, new_points, new_cells = arrays_of(path)
        assert set(points) <= set(new_points) and {"material", "density", "mask"} <= set(new_cells)
        assert np.array_equal(new_cells["material"], new_cells["label"])
        assert set(new_cells["material"]) == {0, 1, 2, 3}
        assert set(new_cells["mask"]) == {0, 1}
        for name in "temperature", "velocity", "density", "mask":
            before = {**points, **cells}[name]
            after = {**new_points, **new_cells}[name]
            assert after.dtype == before.dtype and after.shape[1:] == before.shape[1:]
        assert np.dot(new_volumes, new_cells["density"]) == pytest.approx(np.dot(volumes, cells["density"]))
        assert new_points["temperature"].min() >= -1 and new_points["temperature"].max() <= 1
        # The solid is displaced by 0.04 at most, and the values move with it.
        inside = np.abs(coordinates).max(axis=1) < 1
        assert np.abs(new_points["temperature"] - coordinates[:, 0])[inside].max() < 0.1


def test_repeated_points_with_several_values(tmp_path):
    grid = files.three_materials()
    apart = files.with_repeated_points(grid)
    for compressor in "None", "ZLib":
        files.write_vtu(tmp_path / "in.vtu", "Appended", compressor, grid=apart)
        result = run("improve", tmp_path / "in.vtu", "-o", tmp_path / "out.vtu", "--labels", "material")
        assert result.returncode == 0, result.stderr
        assert "1 point array with several values at a point ('several')" in result.stderr
        coordinates, _, points, _ = arrays_of(tmp_path / "out.vtu")
        assert len(coordinates) == grid.GetNumberOfPoints()
        assert points["temperature"] == pytest.approx(coordinates[:, 0], abs=1e-6)


@pytest.mark.parametrize("binary", [False, True])
def test_legacy_grids(tmp_path, binary):
    path = tmp_path / "grid.vtk"
    files.write_legacy(path, binary)
    assert info(path)[0] == BALL


def test_hexahedra_are_divided(tmp_path):
    path = tmp_path / "grid.vtu"
    grid = files.vtk_grid(hexahedra=True)
    files.write_vtu(path, grid=grid)
    inside = sum(grid.GetCellData().GetArray("label").GetTuple1(i) for i in range(512))
    text = info(path)[1]
    assert float(re.search(r"label 1: .* volume ([\d.]+)", text)[1]) == pytest.approx(inside / 64)


def test_triangles_in_the_plane(tmp_path):
    path = tmp_path / "plane.vtu"
    files.write_plane(path)
    text = info(path)[1]
    assert "triangles" in text
    area = float(re.search(r"label 1: .* area ([\d.]+)", text)[1])
    assert area == pytest.approx(np.pi * 0.3**2, rel=0.1)
    assert run("mean-curvature", path, "--steps", 1).returncode == 0
    assert "--domain -0.5,-0.5,0.5,0.5 gives the bounds" in run("info", path).stderr
    report = tmp_path / "report.json"
    box = ["--domain", "-0.5,-0.5,0.5,0.5", "--report", report]
    assert run("mean-curvature", path, "--steps", 1, *box).returncode == 0
    areas = [label["area"] for label in json.loads(report.read_text())["steps"][0]["labels"]]
    assert sum(areas) == pytest.approx(1)


@pytest.mark.parametrize("name", ["sphere.vtp", "sphere.vtk"])
def test_surfaces(tmp_path, name):
    path = tmp_path / name
    if name.endswith("vtp"):
        files.write_vtp(path)
    else:
        files.write_legacy(path, data=files.vtk_sphere())
    result = run("info", path)
    assert "triangles             1080" in result.stdout
    assert "Euler characteristic  2" in result.stdout
    assert "not used: 1 point array (Normals)" in result.stderr
    assert run("offset", path, "--steps", 1, "--distance", "0.1e").returncode == 0


IMAGES = [
    ("ball.vti", "vtkXMLImageDataWriter"),
    ("ball.vtk", "vtkDataSetWriter"),
    ("ball.mha", "vtkMetaImageWriter"),
    ("ball.mhd", "vtkMetaImageWriter"),
    ("ball.nii", "vtkNIFTIImageWriter"),
    ("ball.nii.gz", "vtkNIFTIImageWriter"),
    ("ball.tif", "vtkTIFFWriter"),
]


def number_of_voxels():
    labels, numbers = np.unique(files.ball_voxels(), return_counts=True)
    return {f"label {label}": number for label, number in zip(labels, numbers)}


@pytest.mark.parametrize(("name", "writer"), IMAGES)
def test_images(tmp_path, name, writer):
    path = tmp_path / name
    files.write_image(path, writer)
    numbers, text = info(path)
    assert numbers == number_of_voxels()
    if not name.endswith("tif"):  # which stores no origin
        assert "size of a voxel       0.5 x 0.5 x 1\nfirst voxel           3 4 5" in text


def test_pictures_have_the_same_orientation(tmp_path):
    labels = np.zeros((40, 30, 1), np.uint8)
    labels[5:15, 4:9] = 1  # near the first row of the image
    for name, writer in (("a.png", "vtkPNGWriter"), ("a.tif", "vtkTIFFWriter"), ("a.vti", "vtkXMLImageDataWriter")):
        files.write_image(tmp_path / name, writer, labels)
    regions = []
    for name in "a.png", "a.tif", "a.vti":
        assert run("convert", tmp_path / name, tmp_path / f"{name}.wkt").returncode == 0
        regions.append((tmp_path / f"{name}.wkt").read_text())
    assert regions[0] == regions[1] == regions[2]


@pytest.mark.parametrize(("name", "writer"), IMAGES)
def test_segmentation(tmp_path, name, writer):
    values = files.gray_voxels().astype(np.float32)
    files.write_image(tmp_path / name, writer, values)
    labels = tmp_path / ("labels." + name.split(".", 1)[1].replace("mhd", "mha"))
    result = run("segment", tmp_path / name, "--intensities", "40,180", "-o", labels)
    assert result.returncode == 0, result.stderr
    numbers, _ = info(labels)
    bright = np.count_nonzero(values > 110)
    assert abs(numbers["label 1"] - bright) < 0.05 * bright


def test_image_of_nrrd(tmp_path):
    voxels = files.ball_voxels()
    path = tmp_path / "ball.nrrd"
    sizes = " ".join(map(str, voxels.shape))
    header = f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {sizes}\nspacings: 0.5 0.5 1\nencoding: raw\n\n"
    path.write_bytes(header.encode() + voxels.tobytes(order="F"))
    assert info(path)[0] == number_of_voxels()


def test_gray_images_need_thresholds(tmp_path):
    path = tmp_path / "gray.nii"
    values = files.gray_voxels().astype(np.float32)
    files.write_image(path, "vtkNIFTIImageWriter", values)
    refused = run("info", path)
    assert refused.returncode == 1
    assert "--threshold" in refused.stderr
    inside = int((values >= 100).sum())
    assert info(path, "--threshold", 100)[0]["label 1"] == inside
    assert info(path, "--threshold", "otsu")[0]["label 1"] == inside  # two peaks far apart
    assert sorted(info(path, "--threshold", "otsu:2")[0]) == ["label 0", "label 1", "label 2"]
    assert run("offset", path, "--threshold", "otsu", "--steps", 1, "--distance", ".1e").returncode == 0
    for wrong in "otsu:9", "3,2", "x", "":
        assert run("info", path, "--threshold", wrong).returncode != 0


def test_colors_are_labels(tmp_path):
    path = tmp_path / "disks.png"
    files.write_picture(path)
    result = run("info", path)
    assert "label 0 is the color 0 0 255, label 1 is the color 255 0 0" in result.stderr
    areas = [float(a) for a in re.findall(r"label \d: .* area ([\d.]+)", result.stdout)]
    assert len(areas) == 3
    assert areas[1] == pytest.approx(areas[0], rel=0.05)


def test_labels_return_to_the_grid_of_the_image(tmp_path):
    """The image that is written back agrees with the input except near the interface."""
    nibabel = pytest.importorskip("nibabel")
    path, back = tmp_path / "ball.nii.gz", tmp_path / "back.nii.gz"
    voxels = (files.ball_voxels() == 1).astype(np.uint8)
    files.write_nifti(path, files.AXES, voxels)
    folder = tmp_path / "run"
    made = run("offset", path, "--steps", 1, "--distance", "1e-9", "--output", folder)
    assert made.returncode == 0, made.stderr
    written = run("convert", folder / "checkpoint.dsc", back, "--grid", path)
    assert written.returncode == 0, written.stderr
    result = nibabel.load(back)
    assert np.allclose(result.affine, files.AXES, atol=1e-5)
    assert np.mean(np.asarray(result.dataobj) != voxels) < 0.03


def test_affine_maps_of_images(tmp_path):
    pytest.importorskip("nibabel")
    path = tmp_path / "ball.nii"
    files.write_nifti(path, files.AXES)
    numbers, text = info(path)
    assert numbers == number_of_voxels()
    assert "size of a voxel       0.5 x 0.7 x 1\nfirst voxel           -1.5 -3 -15" in text
    files.write_nifti(path, files.OBLIQUE)
    result = run("info", path)
    assert "rotation of the axes" in result.stderr


@pytest.mark.parametrize(
    ("name", "labels", "options"),
    [
        ("grid.vtu", "label", {}),
        ("grid.vtu", "label", {"compression": "lzma"}),
        ("grid.vtk", "label", {"file_format": "vtk42"}),
        ("grid.mesh", "medit:ref", {}),
        ("grid.meshb", "medit:ref", {}),
        ("grid.msh", "gmsh:physical", {"file_format": "gmsh22"}),
    ],
)
def test_meshes_of_meshio(tmp_path, name, labels, options):
    pytest.importorskip("meshio")
    files.write_meshio(tmp_path / name, labels, **options)
    expected = {"label 1": 2248, "label 2": 312} if name.endswith("msh") else BALL
    if name.endswith("msh"):
        needs_gmsh(tmp_path)
    assert info(tmp_path / name)[0] == expected


def rotated(path, *arguments):
    """Returns names and volumes of the labels of a run, and its messages."""
    report = path.with_suffix(".json")
    result = run("rotate", path, "--axis", "0,0,1", "--angle", "5", "--steps", "1", "--report", report, *arguments)
    assert result.returncode == 0, result.stderr
    labels = json.loads(report.read_text())["steps"][-1]["labels"]
    return {label.get("name"): label["volume"] for label in labels}, result.stderr


def needs_lib3mf(folder):
    (folder / "empty.3mf").write_text("")
    if "built without lib3mf" in run("info", folder / "empty.3mf").stderr:
        pytest.skip("dsc-files is built without lib3mf")


def test_objects_of_3mf_are_labels(tmp_path):
    needs_lib3mf(tmp_path)
    path = tmp_path / "a.3mf"
    # two cubes with a common wall, a component of scale 2, and a support
    files.write_3mf(path, unit="inch")
    volumes, messages = rotated(path)
    expected = {"cube": 2, "large": 8, "object 3": 1}
    assert {name: volumes[name] for name in expected} == pytest.approx(expected)
    assert "not used: 1 support object" in messages
    assert "the coordinates are in inches" in messages
    assert "1 'cube', 2 'large', 3 'object 3'" in run("rotate", path, "--axis", "0,0,1", "--angle", "5", "--steps", "1").stdout
    run("convert", path, tmp_path / "a.obj")
    lines = (tmp_path / "a.obj").read_text().splitlines()
    points = np.array([line.split()[1:] for line in lines if line.startswith("v ")], dtype=float)
    large = points[points[:, 1] > 10]
    assert large.min(axis=0) == pytest.approx([-4, 31, 3])
    assert large.max(axis=0) == pytest.approx([-2, 33, 5])
    whole = path.read_bytes()
    for size in range(0, len(whole), 97):
        path.write_bytes(whole[:size])
        assert run("info", path).returncode == 1


def test_blocks_are_labels(tmp_path):
    files.write_blocks(tmp_path / "surfaces.vtm", ["first", None, "first"])
    volumes, _ = rotated(tmp_path / "surfaces.vtm")
    assert volumes["first"] == pytest.approx(2)
    assert volumes["block 2"] == pytest.approx(1)
    files.write_blocks(tmp_path / "cells.vtm", ["first", "second"], cells=True)
    assert "label 2 'second': " in info(tmp_path / "cells.vtm")[1]
    assert info(tmp_path / "cells.vtm")[0] == {"label 1": 1, "label 2": 1}
    for block in (tmp_path / "surfaces").iterdir():
        block.unlink()
    assert run("info", tmp_path / "surfaces.vtm").returncode == 1


def test_names_of_physical_groups_are_kept(tmp_path):
    needs_gmsh(tmp_path)
    path = tmp_path / "a.msh"
    tetrahedra = "3 4 2 7 1 1 2 3 4\n4 4 2 9 2 2 3 4 5\n"
    path.write_text(
        '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n3 7 "core"\n3 9 "shell"\n2 7 "wall"\n'
        "$EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
        "$Elements\n2\n" + tetrahedra + "$EndElements\n"
    )
    text = info(path)[1]
    assert "label 7 'core': " in text
    assert "label 9 'shell': " in text
    assert "wall" not in text
    run("improve", path, "-o", tmp_path / "a.vtu")
    assert "label 9 'shell': " in info(tmp_path / "a.vtu")[1]


def needs_gmsh(folder):
    (folder / "empty.msh").write_text("")
    if "built without Gmsh" in run("info", folder / "empty.msh").stderr:
        pytest.skip("dsc-files is built without Gmsh")


@pytest.mark.parametrize(
    ("version", "binary"), [("22", "0"), ("22", "1"), ("40", "0"), ("41", "0"), ("41", "1")]
)
def test_meshes_of_gmsh(tmp_path, version, binary):
    needs_gmsh(tmp_path)
    path = tmp_path / "ball.msh"
    try:
        files.write_gmsh(path, "-format", "msh" + version, "-setnumber", "Mesh.Binary", binary)
    except FileNotFoundError:
        pytest.skip("there is no program gmsh")
    text = info(path)[1]
    volume = float(re.search(r"label 7: .* volume ([\d.]+)", text)[1])
    assert volume == pytest.approx(4 / 3 * np.pi * 0.6**3, rel=0.15)


def test_meshes_of_fenics(tmp_path):
    pytest.importorskip("dolfinx")
    path = files.write_dolfinx(tmp_path)
    text = info(path)[1]
    assert float(re.search(r"label 1: .* volume ([\d.]+)", text)[1]) == pytest.approx(0.125)


def cloud(path, nans=0):
    """Writes points of a sphere as a table, or as a file of the Point Cloud Library."""
    p = np.random.default_rng(1).normal(size=(2000, 3))
    p /= np.linalg.norm(p, axis=1)[:, None]
    p[:nans] = np.nan
    if path.suffix == ".csv":
        text = "\n".join(",".join(map(repr, map(float, row))) for row in p)
        path.write_text("X,Y,Z\n" + text)
        return
    header = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
    header += f"WIDTH {len(p)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(p)}\n"
    if path.name.startswith("text"):
        rows = "".join(f"{x} {y} {z} 255\n" for x, y, z in p)
        path.write_text(header + "DATA ascii\n" + rows)
        return
    rows = np.zeros(len(p), dtype=[("p", "<f4", 3), ("rgb", "<u4")])
    rows["p"] = p
    path.write_bytes((header + "DATA binary\n").encode() + rows.tobytes())


@pytest.mark.parametrize("name", ["cloud.csv", "text.pcd", "binary.pcd"])
def test_clouds(tmp_path, name):
    cloud(tmp_path / name, nans=7)
    result = run("reconstruct", tmp_path / name, "-o", tmp_path / "ball.off")
    assert result.returncode == 0, result.stderr
    assert "7 points that are not finite" in result.stderr
    assert name == "cloud.csv" or "column (rgb)" in result.stderr
    assert "1993 points" in result.stdout
    volume = float(re.search(r"volume +([\d.]+)", run("info", tmp_path / "ball.off").stdout)[1])
    assert volume == pytest.approx(4 / 3 * np.pi, rel=0.02)


def test_damaged_clouds(tmp_path):
    path = tmp_path / "binary.pcd"
    cloud(path)
    path.write_bytes(path.read_bytes()[:-100])
    result = run("reconstruct", path, "-o", tmp_path / "a.off")
    assert result.returncode == 1
    assert "truncated" in result.stderr
    for text in "", "a,b,c\n1,2,3\n", "x,y,z\n1,2\n", "x,y,z\n1,2,three\n":
        (tmp_path / "a.csv").write_text(text)
        assert run("reconstruct", tmp_path / "a.csv", "-o", tmp_path / "a.off").returncode == 1


def test_geojson(tmp_path):
    square = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]
    hole = [[1, 1], [1, 2], [2, 2], [2, 1], [1, 1]]
    island = [[10, 0], [11, 0], [11, 1], [10, 1], [10, 0]]
    features = [
        {"type": "Polygon", "coordinates": [square, hole]},
        {"type": "Point", "coordinates": [0, 0]},
        {"type": "MultiPolygon", "coordinates": [[island], [[[x, y + 3] for x, y in island]]]},
    ]
    text = {"type": "FeatureCollection",
            "features": [{"type": "Feature", "properties": {}, "geometry": g} for g in features]}  # fmt: skip
    path = tmp_path / "map.geojson"
    path.write_text(json.dumps(text))
    result = run("info", path)
    assert result.returncode == 0, result.stderr
    assert "1 geometry that is no polygon" in result.stderr
    areas = re.findall(r"label (\d): .* area ([\d.]+).* components (\d)", result.stdout)[1:]
    assert [(int(n), float(a), int(c)) for n, a, c in areas] == [(1, 15, 1), (2, 2, 2)]
    for wrong in "{", "[]", '{"type": "Polygon"}', '{"type": "Polygon", "coordinates": [["a"]]}':
        path.write_text(wrong)
        assert run("info", path).returncode == 1


def test_conversions_keep_the_content(tmp_path):
    files.write_vtp(tmp_path / "a.vtp")
    files.write_legacy(tmp_path / "g.vtk")
    files.write_image(tmp_path / "i.nii", "vtkNIFTIImageWriter")
    steps = {
        "a.vtp": ["a.off", "a.stl", "a.obj", "a.ply", "a.vtk"],
        "g.vtk": ["g.mesh", "g.vtu", "h.vtk"],
        "i.nii": ["i.inr", "i.mha", "i.vti", "i.tif", "i.nii.gz"],
    }
    for first, others in steps.items():
        before = info(tmp_path / first)
        source = first
        for other in others:
            result = run("convert", tmp_path / source, tmp_path / other)
            assert result.returncode == 0, result.stderr
            after = info(tmp_path / other)
            assert after[0] == before[0]
            if first == "a.vtp":
                assert "triangles             1080" in after[1]
            source = other


def test_standard_input_and_output(tmp_path):
    files.write_vtp(tmp_path / "a.vtp")
    stl = subprocess.run([DSC, "convert", tmp_path / "a.vtp", "-", "--to", "stl"], capture_output=True)
    off = subprocess.run([DSC, "convert", "-", "-", "--from", "stl", "--to", "off"],
                         input=stl.stdout, capture_output=True)  # fmt: skip
    assert off.stdout.startswith(b"OFF\n542 1080 0")
    assert run("convert", "-", "-", "--from", "stl").returncode == 2


def test_truncated_files_are_refused(tmp_path):
    """A file of which a part is missing is refused, or means the same as the whole file."""
    writers = {
        "a.vtu": lambda path: files.write_vtu(path, "Appended", "LZ4", raw=True),
        "a.vtk": files.write_legacy,
        "b.vtk": lambda path: files.write_legacy(path, binary=True),
        "c.vtk": lambda path: files.write_image(path, "vtkDataSetWriter"),
        "a.vtp": files.write_vtp,
        "a.mha": lambda path: files.write_image(path, "vtkMetaImageWriter"),
        "a.nii.gz": lambda path: files.write_image(path, "vtkNIFTIImageWriter"),
        "a.tif": lambda path: files.write_image(path, "vtkTIFFWriter"),
        "a.vti": lambda path: files.write_image(path, "vtkXMLImageDataWriter"),
    }
    numbers = random.Random(1)
    for name, write in writers.items():
        path = tmp_path / name
        write(path)
        whole, data = run("info", path), path.read_bytes()
        assert whole.returncode == 0, whole.stderr
        for _ in range(6):
            path.write_bytes(data[: numbers.randrange(1, len(data) - 1)])
            part = run("info", path)
            assert part.returncode == 1 or part.stdout == whole.stdout, name
            assert part.returncode == 0 or part.stderr.count("\n") == 1, part.stderr


def test_errors_name_the_file(tmp_path):
    for name in "no.nii", "no.vtk", "no.msh":
        result = run("info", tmp_path / name)
        assert result.returncode == 1
        assert "cannot open" in result.stderr
        (tmp_path / name).write_text("nothing of the kind\n")
        result = run("info", tmp_path / name)
        assert result.returncode == 1
        assert name in result.stderr
    assert run("info", tmp_path).returncode == 1  # a folder


def test_no_temporary_files_are_left(tmp_path):
    files.write_vtp(tmp_path / "a.vtp")
    folder = tmp_path / "temporary"
    folder.mkdir()
    environment = {**os.environ, "TMPDIR": str(folder)}
    run("info", tmp_path / "a.vtp", env=environment)
    run("offset", tmp_path / "a.vtp", "--steps", 1, "--distance", "1e-3", env=environment)
    assert list(folder.iterdir()) == []


def image_with(direction=None, pieces=None):
    """Returns the text of a .vti file of 10 x 10 x 10 voxels."""
    direction = "" if direction is None else 'Direction="' + " ".join(map(str, direction)) + '"'
    values = " ".join(["1"] * 1000)
    return (
        f'<VTKFile type="ImageData" version="1.0"><ImageData WholeExtent="0 9 0 9 0 9" {direction} '
        f'Origin="0 0 0" Spacing="1 1 1"><Piece Extent="{pieces or "0 9 0 9 0 9"}"><PointData Scalars="a">'
        f'<DataArray type="UInt8" Name="a" format="ascii">{values}</DataArray></PointData></Piece>'
        "</ImageData></VTKFile>"
    )


def test_rotated_images_are_named(tmp_path):
    path = tmp_path / "a.vti"
    for degrees in 30, 46, 90, 135:
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        path.write_text(image_with([c, -s, 0, s, c, 0, 0, 0, 1]))
        result = run("info", path)
        assert result.returncode == 0, result.stderr
        assert "label 1: 1000 voxels" in result.stdout
        assert ("rotation of the axes" in result.stderr) == (degrees != 90)
    header = "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementSpacing = 1 2 3\nOffset = 5 6 7\n"
    for matrix, place in ("0 1 0 1 0 0 0 0 1", "5 6 7"), ("-1 0 0 0 1 0 0 0 1", "2 6 7"):
        mha = tmp_path / "a.mha"
        mha.write_bytes((header + f"TransformMatrix = {matrix}\nElementDataFile = LOCAL\n").encode() + bytes(64))
        text = run("info", mha).stdout
        assert "first voxel           " + place in text
        assert ("size of a voxel       2 x 1 x 3" in text) == matrix.startswith("0")


def test_images_without_all_pieces_are_refused(tmp_path):
    path = tmp_path / "a.vti"
    path.write_text(image_with(pieces="0 5 0 9 0 9"))
    assert run("info", path).returncode == 1


def test_scaled_values_of_nifti(tmp_path):
    nibabel = pytest.importorskip("nibabel")
    image = nibabel.Nifti1Image((10 * files.ball_voxels()).astype(np.int16), np.eye(4))
    image.header.set_slope_inter(0.1, 0)
    nibabel.save(image, tmp_path / "a.nii")
    stored = np.asarray(nibabel.load(tmp_path / "a.nii").dataobj)
    expected = {f"label {k}": n for k, n in enumerate(np.bincount((stored >= 0.5).astype(int).ravel()))}
    assert info(tmp_path / "a.nii", "--threshold", 0.5)[0] == expected


def test_meshes_execute_nothing(tmp_path):
    """Gmsh would execute these files."""
    needs_gmsh(tmp_path)
    proof = tmp_path / "proof"
    script = f'SystemCall "touch {proof}";\n'
    (tmp_path / "a.msh").write_text(script)
    assert run("info", tmp_path / "a.msh").returncode == 1
    try:
        files.write_gmsh(tmp_path / "b.msh", "-format", "msh22")
    except FileNotFoundError:
        pytest.skip("there is no program gmsh")
    (tmp_path / "b.msh.opt").write_text(script)
    assert run("info", tmp_path / "b.msh").returncode == 0
    assert not proof.exists()


def test_points_that_are_not_finite(tmp_path):
    """A point that is not a number is not merged with another one."""
    polydata = files.vtk_sphere()
    polydata.GetPoints().SetPoint(100, float("nan"), 0, 0)
    files.write_legacy(tmp_path / "a.vtk", data=polydata)
    result = run("info", tmp_path / "a.vtk")
    assert result.returncode == 1 or "not finite" in result.stderr


def test_curved_cells(tmp_path):
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    middles = [(corners[a] + corners[b]) / 2 for a, b in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]
    for p in [*corners, *middles]:
        points.InsertNextPoint(p)
    grid.SetPoints(points)
    grid.InsertNextCell(vtk.VTK_QUADRATIC_TETRA, 10, list(range(10)))
    files.write_vtu(tmp_path / "a.vtu", grid=grid)
    result = run("info", tmp_path / "a.vtu", "--labels", "none")
    assert result.returncode == 0, result.stderr
    assert "1 curved cell" in result.stderr
    assert "tetrahedra           1" in result.stdout


def test_tables_with_decimal_commas(tmp_path):
    path = tmp_path / "a.csv"
    p = np.random.default_rng(1).normal(size=(2000, 3))
    p /= np.linalg.norm(p, axis=1)[:, None]
    rows = "".join(";".join(f"{x:.6f}".replace(".", ",") for x in row) + ";\n" for row in p)
    path.write_text("x;y;z;note\n" + rows)
    result = run("reconstruct", path, "-o", tmp_path / "a.off")
    assert result.returncode == 0, result.stderr
    assert "2000 points" in result.stdout
    assert "column (note)" in result.stderr
