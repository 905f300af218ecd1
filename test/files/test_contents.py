"""The table "What Files Contain" of the manual: each of its cells is tested with a small file."""

import os
import pathlib
import re
import struct
import subprocess
import zlib

import pytest

import foreign_files

DSC = os.environ["DSC_PROGRAM"]
HAS_VTK = (pathlib.Path(DSC).parent / "dsc-files").exists()
MANUAL = pathlib.Path(__file__).parents[2] / "doc/Dsc_program/Dsc_program.txt"
COLUMNS = ("geometry", "labels", "names", "arrays")
NATIVE = {".off", ".obj", ".ply", ".stl", ".mesh", ".vtu", ".inr", ".wkt", ".poly", ".pgm", ".png", ".svg", ".dsc"}


def table():
    """Returns what the manual says about each format and each kind of content."""
    section = MANUAL.read_text().split("\\subsection Dsc_programContents ")[1].split("\\subsection")[0]
    rows = re.findall(r"^\| `(\.\w+)` \| (.*) \|$", section, re.M)
    return {row[0]: dict(zip(COLUMNS, row[1].split(" | "))) for row in rows}


TABLE = table()
CELLS = [(name, column) for name, row in TABLE.items() for column in row]

FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
NAME = "shell"  # of a label or of the only part
POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]  # a tetrahedron of volume 1/6
CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
TETRAHEDRA = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]


def text(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def array(kind, name, rows, components=1):
    return (
        f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">'
        f"{text(rows)}</DataArray>"
    )


def vtp():
    return (
        '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
        '<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4">'
        + f"<PointData>{array('Float64', 'heat', [(7,)] * 4)}</PointData>"
        + f"<Points>{array('Float64', 'Points', POINTS, 3)}</Points><Polys>"
        + array("Int64", "connectivity", FACES)
        + array("Int64", "offsets", [(3,), (6,), (9,), (12,)])
        + "</Polys></Piece></PolyData></VTKFile>"
    )


def vtu():
    return (
        '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid><FieldData>'
        '<DataArray type="Int32" Name="named_labels" NumberOfTuples="1" format="ascii">3</DataArray>'
        '<Array type="String" Name="label_names" NumberOfTuples="1" format="ascii">'
        + f"{text([NAME.encode() + bytes(1)])}</Array></FieldData>"
        '<Piece NumberOfPoints="8" NumberOfCells="6"><PointData>'
        + array("Float64", "heat", [(p[0],) for p in CUBE])
        + "</PointData><CellData>"
        + array("Int32", "label", [(3,)] * 6)
        + array("Float64", "density", [(1.5,)] * 6)
        + "</CellData><Points>"
        + array("Float64", "Points", CUBE, 3)
        + "</Points><Cells>"
        + array("Int64", "connectivity", TETRAHEDRA)
        + array("Int64", "offsets", [(4 * i,) for i in range(1, 7)])
        + array("UInt8", "types", [(10,)] * 6)
        + "</Cells></Piece></UnstructuredGrid></VTKFile>"
    )


def inr():
    header = "#INRIMAGE-4#{\nXDIM=4\nYDIM=4\nZDIM=4\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\nVX=1\nVY=1\nVZ=1\n"
    return (header.ljust(252, "\n") + "##}\n").encode() + VOXELS


def png():
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + PIXELS[4 * y : 4 * y + 4] for y in range(4))
    header = struct.pack(">2I5B", 4, 4, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def meshb():
    """Returns the cube in version 2 of the format: each section begins with the place of the next one."""
    vertices = b"".join(struct.pack("<3di", *p, 0) for p in CUBE)
    cells = b"".join(struct.pack("<5i", *(v + 1 for v in t), 3) for t in TETRAHEDRA)
    result = struct.pack("<2i3i", 1, 2, 3, 20, 3)
    for keyword, number, data in (4, 8, vertices), (8, 6, cells):
        result += struct.pack("<3i", keyword, len(result) + 12 + len(data), number) + data
    return result + struct.pack("<2i", 54, 0)


TITLE = "(?: '.*')?"  # the name of a label, if it has one
VOXELS = bytes(9 if {x, y, z} <= {1, 2} else 0 for z in range(4) for y in range(4) for x in range(4))
PIXELS = bytes(5 if 4 < i < 11 and i % 4 in (1, 2) else 0 for i in range(16))
STL = "".join(
    "facet normal 0 0 0\nouter loop\n"
    + "".join("vertex {} {} {}\n".format(*POINTS[v]) for v in face)
    + "endloop\nendfacet\n"
    for face in FACES
)
POLYGON = "[[0,0],[1,0],[1,1],[0,1],[0,0]]"
SAMPLES = {
    ".off": "COFF\n4 4 0\n" + text(p + (255, 0, 0) for p in POINTS) + text((3,) + f for f in FACES),
    ".obj": f"o {NAME}\n" + text(("v",) + p for p in POINTS) + text(("f",) + tuple(v + 1 for v in f) for f in FACES),
    ".ply": "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property float heat\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    + text(p + (7,) for p in POINTS)
    + text((3,) + f for f in FACES),
    ".stl": f"solid {NAME}\n{STL}endsolid {NAME}\n",
    ".mesh": "MeshVersionFormatted 2\nDimension 3\nVertices 8\n"
    + text(p + (0,) for p in CUBE)
    + "Tetrahedra 6\n"
    + text(tuple(v + 1 for v in t) + (3,) for t in TETRAHEDRA)
    + "End\n",
    ".vtu": vtu(),
    ".inr": inr(),
    ".wkt": "POLYGON((0 0,1 0,1 1,0 1,0 0))\n",
    ".poly": "4 2 1 0\n0 0 0 3.5\n1 1 0 3.5\n2 1 1 3.5\n3 0 1 3.5\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n1\n0 .5 .5 4\n",
    ".pgm": b"P5 4 4 255\n" + PIXELS,
    ".ppm": b"P6\n4 4\n255\n" + bytes(x for pixel in PIXELS for x in (pixel, pixel, 0)),
    ".png": png(),
    ".vtp": vtp(),
    ".meshb": meshb(),
    ".nrrd": b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 12 4 4\nspacings: 1 1 1\nencoding: raw\n\n"
    + b"".join(VOXELS[4 * i : 4 * i + 4] + bytes(8) for i in range(16)),
    ".msh": "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n"
    f'3 3 "{NAME}"\n$EndPhysicalNames\n$Nodes\n8\n'
    + text((i + 1,) + p for i, p in enumerate(CUBE))
    + "$EndNodes\n$Elements\n6\n"
    + text((i + 1, 4, 2, 3, 1) + tuple(v + 1 for v in t) for i, t in enumerate(TETRAHEDRA))
    + '$EndElements\n$ElementData\n1\n"density"\n1\n0.0\n3\n0\n1\n1\n1 2.5\n$EndElementData\n',
    ".pcd": "VERSION .7\nFIELDS x y z heat\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\n"
    "POINTS 3\nDATA ascii\n0 0 0 4\n1 0 0 4\n0 1 0 4\n",
    ".csv": "x,y,z,heat\n0,0,0,4\n1,0,0,4\n0,1,0,4\n",
    ".vtm": '<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian"><vtkMultiBlockDataSet>'
    f'<DataSet index="0" name="{NAME}" file="sample.vtu"/></vtkMultiBlockDataSet></VTKFile>',
    ".geojson": '{"type":"FeatureCollection","features":[{"type":"Feature","properties":{"heat":3},'
    f'"geometry":{{"type":"Polygon","coordinates":[{POLYGON}]}}}}]}}',
}
VOXEL_IMAGES = (".inr", ".vti", ".nii", ".mha", ".tif", ".nrrd")
CELL_FORMATS = (".mesh", ".vtu", ".vtk", ".dsc", ".meshb", ".msh")
LABELS = dict.fromkeys(VOXEL_IMAGES, 9) | dict.fromkeys(CELL_FORMATS, 3)
LABELS |= {".vtm": 1, ".poly": 4, ".pgm": 5, ".png": 5, ".ppm": 1}  # .ppm: the colors in their order
VOLUMES = dict.fromkeys((".off", ".obj", ".ply", ".stl", ".vtp", ".3mf"), 1 / 6) | dict.fromkeys(VOXEL_IMAGES, 8)
VOLUMES |= dict.fromkeys((".pgm", ".png", ".ppm"), 4)
# What the program names if it does not use the arrays of a format
NAMED = {
    ".off": "4 colors of points",
    ".ply": "4 values 'heat' of points",
    ".poly": "4 point attributes",
    ".csv": "1 column (heat)",
    ".pcd": "1 column (heat)",
    ".vtp": "1 point array (heat)",
    ".msh": "1 view with values",
    ".geojson": "1 properties of features",
}
# The formats from which the program writes the samples of other formats
SOURCES = {".vtk": ".vtu", ".vti": ".inr", ".nii": ".inr", ".mha": ".inr", ".tif": ".inr"}


def run(*arguments):
    return subprocess.run([DSC, *map(str, arguments)], capture_output=True, timeout=120, text=True)


def need(name):
    if name not in NATIVE and not HAS_VTK:
        pytest.skip("dsc-files is not built: VTK is missing")


@pytest.fixture(scope="module")
def sample(tmp_path_factory):
    """Returns a function that returns a file of a format, which the program may have written."""
    folder = tmp_path_factory.mktemp("contents")

    def make(name):
        need(name)
        path = folder / f"sample{name}"
        if path.exists():
            return path
        if name == ".vtm":
            make(".vtu")  # its block
        if name == ".3mf":
            mesh = foreign_files.mesh_3mf(POINTS, FACES)
            part = f'<object id="1" type="model" name="{NAME}">{mesh}</object>'
            foreign_files.pack_3mf(path, "millimeter", part, '<item objectid="1"/>')
        elif name in SAMPLES:
            content = SAMPLES[name]
            path.write_bytes(content if isinstance(content, bytes) else content.encode())
        elif name == ".dsc":
            arguments = ("--axis", "0,0,1", "--angle", 360, "--steps", 1, "--output", folder / "out")
            assert run("rotate", make(".vtu"), *arguments).returncode == 0
            (folder / "out/checkpoint.dsc").rename(path)
        else:
            assert run("convert", make(SOURCES[name]), path).returncode == 0
        return path

    return make


def info(path):
    result = run("info", path)
    assert result.returncode == 0, result.stderr
    return result.stdout


def measure(path):
    """Returns the volume or area inside: of all labels but 0."""
    output = info(path)
    voxels = re.search(r"voxels of size|^label -?\d+: (\d+) voxels", output, re.M)
    if voxels:
        return sum(int(n) for n in re.findall(r"^label [1-9]\d*: (\d+) voxels", output, re.M))
    of_labels = re.findall(rf"^label [1-9]\d*{TITLE}: .*? (?:volume|area) ([\d.e+-]+)", output, re.M)
    return sum(map(float, of_labels or re.findall(r"^volume +([\d.e+-]+)", output, re.M)))


def has_arrays(path, tmp_path):
    """Returns whether the arrays `heat` and `density` reach a grid."""
    grid = tmp_path / "arrays.vtu"
    assert run("convert", path, grid).returncode == 0
    content = grid.read_bytes()
    return b'Name="heat"' in content and b'Name="density"' in content


def require(column, name, path, tmp_path):
    if column == "geometry":
        assert measure(path) == pytest.approx(VOLUMES.get(name, 1), rel=1e-5)
    elif column == "labels":
        assert re.search(f"^label {LABELS[name]}{TITLE}:", info(path), re.M)
    elif column == "names":
        assert f"'{NAME}': " in info(path)
    else:
        assert has_arrays(path, tmp_path)


@pytest.mark.parametrize(("name", "column"), CELLS)
def test_what_is_read(name, column, sample, tmp_path):
    cell = TABLE[name][column]
    if "read" not in TABLE[name]["geometry"]:
        return
    path = sample(name)
    if name == ".msh" and "without Gmsh" in run("info", path).stderr:
        pytest.skip("Gmsh is missing")
    if name == ".3mf" and "without lib3mf" in run("info", path).stderr:
        pytest.skip("lib3mf is missing")
    if name in (".csv", ".pcd"):  # points only
        output = run("reconstruct", path, "-o", tmp_path / "out.off")
        assert (NAMED[name] if column == "arrays" else "points") in output.stderr
        return
    if "read" in cell:
        require(column, name, path, tmp_path)
    elif cell == "named":
        assert NAMED[name] in run("info", path).stderr
    else:
        assert cell == "–"
        assert column != "arrays" or "not used" not in run("info", path).stderr


@pytest.mark.parametrize(("name", "column"), [c for c in CELLS if "written" in TABLE[c[0]][c[1]]])
def test_what_is_written(name, column, sample, tmp_path):
    need(name)
    path = tmp_path / f"written{name}"
    if name == ".dsc":
        return require(column, name, sample(name), tmp_path)
    in_plane, is_image = name in (".wkt", ".poly", ".svg"), name in VOXEL_IMAGES
    source = ".poly" if in_plane else ".inr" if is_image else {".vtk": ".vtu", ".vtp": ".off"}.get(name, ".dsc")
    assert run("convert", sample(source), path).returncode == 0
    if name in (".svg", ".png"):
        assert path.stat().st_size > 500
    elif column == "geometry" and name in (".off", ".obj", ".ply", ".stl"):
        assert measure(path) == pytest.approx(1, rel=1e-5)  # the cube
    else:
        require(column, name, path, tmp_path)


def test_formats_without_arrays_and_names_tell_what_they_lose(sample, tmp_path):
    for source, name in (".dsc", ".mesh"), (".dsc", ".off"), (".vtu", ".mesh"):
        message = run("convert", sample(source), tmp_path / f"out{name}").stderr
        assert "heat" in message and "density" in message and f"3 '{NAME}'" in message
