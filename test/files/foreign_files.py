"""Writes files by programs of other people, from which the tests and the table of formats read them."""

import subprocess

import numpy as np

N = 24  # voxels along an axis


def ball_voxels():
    """Returns labels of voxels: 1 in an ellipsoid, 2 in a small box, 0 elsewhere."""
    x = np.linspace(-1, 1, N)
    X, Y, Z = np.meshgrid(x, x, x[: N - 4], indexing="ij")
    labels = (X**2 + 2 * Y**2 + Z**2 < 0.5).astype(np.uint8)
    labels[2:4, 3:9, 4] = 2
    return labels


def gray_voxels():
    """Returns gray values: a bright ball in a dark background."""
    x = np.linspace(-1, 1, N)
    X, Y, Z = np.meshgrid(x, x, x, indexing="ij")
    return np.where(X**2 + Y**2 + Z**2 < 0.4, 180.0, 40.0) + 5 * np.sin(9 * X + 7 * Y)


# VTK


def named(array, name):
    from vtk.util.numpy_support import numpy_to_vtk

    result = numpy_to_vtk(np.ascontiguousarray(array), deep=True)
    result.SetName(name)
    return result


def _centers(data):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    centers = vtk.vtkCellCenters()
    centers.SetInputData(data)
    centers.Update()
    return vtk_to_numpy(centers.GetOutput().GetPoints().GetData())


def vtk_grid(hexahedra=False):
    """Returns a cube of tetrahedra, or of hexahedra, with label 1 in a ball."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    image = vtk.vtkImageData()
    image.SetDimensions(9, 9, 9)
    image.SetSpacing(0.25, 0.25, 0.25)
    image.SetOrigin(-1, -1, -1)
    grid = vtk.vtkAppendFilter() if hexahedra else vtk.vtkDataSetTriangleFilter()
    grid.SetInputData(image)
    grid.Update()
    result = grid.GetOutput()
    labels = (np.linalg.norm(_centers(result), axis=1) < 0.6).astype(np.int32)
    result.GetCellData().AddArray(named(labels, "label"))
    x = vtk_to_numpy(result.GetPoints().GetData())[:, 0]
    result.GetPointData().AddArray(named(x, "temperature"))
    return result


def three_materials():
    """Returns a cube of tetrahedra of three materials, with arrays of several types."""
    from vtk.util.numpy_support import vtk_to_numpy

    result = vtk_grid()
    result.GetCellData().RemoveArray("label")
    centers = _centers(result)
    number = np.arange(len(centers))
    arrays = {
        "material": (1 + (centers[:, 2] > 0) + (centers[:, 2] > 0.5)).astype(np.int32),
        "density": 1 + number % 5 / 4,
        "mask": (number % 2).astype(np.uint8),
        "ids": number[::-1].astype(np.int64),
    }
    for name, values in arrays.items():
        result.GetCellData().AddArray(named(values, name))
    points = vtk_to_numpy(result.GetPoints().GetData()).astype(np.float64)
    result.GetPointData().AddArray(named(np.roll(points, 1, axis=1), "velocity"))
    return result


def with_repeated_points(grid):
    """Returns a grid of tetrahedra whose cells have points of their own, and an array that differs there."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    result = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetData(named(vtk_to_numpy(grid.GetPoints().GetData())[corners], "points"))
    result.SetPoints(points)
    for i in range(0, len(corners), 4):
        result.InsertNextCell(vtk.VTK_TETRA, 4, [i, i + 1, i + 2, i + 3])
    result.GetCellData().ShallowCopy(grid.GetCellData())
    temperature = vtk_to_numpy(grid.GetPointData().GetArray("temperature"))
    result.GetPointData().AddArray(named(temperature[corners], "temperature"))
    result.GetPointData().AddArray(named(np.arange(len(corners)) // 4 % 3, "several"))
    return result


def write_vtu(path, mode="Appended", compressor="ZLib", raw=False, grid=None):
    import vtk

    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(vtk_grid() if grid is None else grid)
    getattr(writer, f"SetDataModeTo{mode}")()
    getattr(writer, f"SetCompressorTypeTo{compressor}")()
    writer.SetEncodeAppendedData(not raw)
    writer.Write()


def write_pieces(path):
    """Writes a grid in two pieces, which repeat the points of their common boundary."""
    import vtk

    grid = vtk_grid()
    left = _centers(grid)[:, 0] < 0
    texts = []
    for half in left, ~left:
        cells = vtk.vtkIdList()
        for i in np.flatnonzero(half):
            cells.InsertNextId(int(i))
        extracted = vtk.vtkExtractCells()
        extracted.SetInputData(grid)
        extracted.SetCellList(cells)
        extracted.Update()
        write_vtu(path, "Ascii", "None", grid=extracted.GetOutput())
        texts.append(path.read_text())
    end = "</Piece>"
    piece = texts[1][texts[1].index("<Piece") : texts[1].index(end) + len(end)]
    path.write_text(texts[0].replace(end, end + piece))


def write_legacy(path, binary=False, data=None):
    import vtk

    writer = vtk.vtkDataSetWriter()
    writer.SetInputData(vtk_grid() if data is None else data)
    writer.SetFileName(str(path))
    if binary:
        writer.SetFileTypeToBinary()
    writer.Write()


def write_plane(path):
    """Writes labeled triangles in the plane."""
    import vtk

    plane = vtk.vtkPlaneSource()
    plane.SetResolution(10, 10)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(plane.GetOutputPort())
    triangles.Update()
    data = triangles.GetOutput()
    c = _centers(data)
    labels = (np.hypot(c[:, 0], c[:, 1]) < 0.3).astype(np.int32)
    data.GetCellData().AddArray(named(labels, "label"))
    grid = vtk.vtkAppendFilter()
    grid.AddInputData(data)
    grid.Update()
    write_vtu(path, grid=grid.GetOutput())


def vtk_sphere():
    import vtk

    sphere = vtk.vtkSphereSource()
    sphere.SetThetaResolution(30)
    sphere.SetPhiResolution(20)
    sphere.Update()
    return sphere.GetOutput()


def write_vtp(path):
    import vtk

    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(vtk_sphere())
    writer.SetFileName(str(path))
    writer.Write()


def vtk_image(values, spacing=(0.5, 0.5, 1.0), origin=(3.0, 4.0, 5.0)):
    import vtk

    image = vtk.vtkImageData()
    image.SetDimensions(*values.shape)
    image.SetSpacing(*spacing)
    image.SetOrigin(*origin)
    image.GetPointData().SetScalars(named(values.ravel(order="F"), "values"))
    return image


def write_image(path, writer, values=None):
    """Writes an image by a class of VTK."""
    import vtk

    writer = getattr(vtk, writer)()
    writer.SetInputData(vtk_image(ball_voxels() if values is None else values))
    writer.SetFileName(str(path))
    writer.Write()


def write_picture(path):
    """Writes a picture of two disks with the colors red and blue on white."""
    import vtk

    x = np.linspace(-1, 1, 60)
    X, Y = np.meshgrid(x, x, indexing="ij")
    colors = np.full((60, 60, 3), 255, np.uint8)
    colors[np.hypot(X - 0.4, Y) < 0.3] = (255, 0, 0)
    colors[np.hypot(X + 0.4, Y) < 0.3] = (0, 0, 255)
    image = vtk.vtkImageData()
    image.SetDimensions(60, 60, 1)
    image.GetPointData().SetScalars(named(colors.transpose(1, 0, 2).reshape(-1, 3), "colors"))
    writer = vtk.vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()


def write_blocks(path, names, cells=False):
    """Writes the surfaces of cubes, or tetrahedra, as blocks. Neighbors have a common side."""
    import vtk

    blocks = vtk.vtkMultiBlockDataSet()
    for i, name in enumerate(names):
        if cells:
            points = vtk.vtkPoints()
            for p in ((i, i, i), (1, 0, 0), (0, 1, 0), (0, 0, 1)):
                points.InsertNextPoint(p)
            block = vtk.vtkUnstructuredGrid()
            block.SetPoints(points)
            block.InsertNextCell(vtk.VTK_TETRA, 4, range(4))
        else:
            image = vtk.vtkImageData()
            image.SetDimensions(2, 2, 2)
            image.SetOrigin(i, 0, 0)
            surface = vtk.vtkDataSetSurfaceFilter()
            surface.SetInputData(image)
            surface.Update()
            block = surface.GetOutput()
        blocks.SetBlock(i, block)
        if name is not None:
            blocks.GetMetaData(i).Set(vtk.vtkCompositeDataSet.NAME(), name)
    writer = vtk.vtkXMLMultiBlockDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(blocks)
    writer.Write()


# 3MF: a package of files, written from the text of its specification


def mesh_3mf(points, facets):
    vertices = "".join('<vertex x="{}" y="{}" z="{}"/>'.format(*p) for p in points)
    triangles = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*f) for f in facets)
    return f"<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>"


def write_3mf(path, unit):
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    facets = "0 2 3", "0 3 1", "4 5 7", "4 7 6", "0 1 5", "0 5 4", "2 6 7", "2 7 3", "0 4 6", "0 6 2", "1 3 7", "1 7 5"
    mesh = mesh_3mf(corners, [f.split() for f in facets])
    objects = (
        f'<object id="1" type="model" name="cube">{mesh}</object>'
        f'<object id="2" type="model" name="large">{mesh}</object>'
        f'<object id="4" type="model">{mesh}</object><object id="5" type="support">{mesh}</object>'
        '<object id="6" type="model"><components><component objectid="2" transform="2 0 0 0 2 0 0 0 2 1 2 3"/>'
        "</components></object>"
    )
    items = (
        '<item objectid="1"/><item objectid="6" transform="0 1 0 -1 0 0 0 0 1 0 30 0"/>'
        '<item objectid="4" transform="1 0 0 0 1 0 0 0 1 1 0 0"/><item objectid="5"/>'
        '<item objectid="1" transform="1 0 0 0 1 0 0 0 1 -9 0 0"/>'
    )
    pack_3mf(path, unit, objects, items)


def pack_3mf(path, unit, objects, items):
    import zipfile

    model = (
        f'<?xml version="1.0" encoding="UTF-8"?><model unit="{unit}" xml:lang="en-US" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
        f"<resources>{objects}</resources><build>{items}</build></model>"
    )
    with zipfile.ZipFile(path, "w") as package:
        package.writestr(
            "[Content_Types].xml",
            '<?xml version="1.0" encoding="UTF-8"?>'
            '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
            '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
            '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
        )
        package.writestr(
            "_rels/.rels",
            '<?xml version="1.0" encoding="UTF-8"?>'
            '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
            '<Relationship Target="/3D/3dmodel.model" Id="rel0" '
            'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
        )
        package.writestr("3D/3dmodel.model", model)


# meshio


def write_meshio(path, name="label", **options):
    import meshio
    from vtk.util.numpy_support import vtk_to_numpy

    grid = vtk_grid()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    labels = vtk_to_numpy(grid.GetCellData().GetArray("label"))
    if name == "gmsh:physical":  # groups begin with 1
        labels = labels + 1
    data = {name: [labels]}
    if name == "gmsh:physical":
        data["gmsh:geometrical"] = [labels]
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    meshio.write(path, meshio.Mesh(points, [("tetra", cells)], cell_data=data), **options)


# Gmsh


def write_gmsh(path, *arguments):
    geometry = path.with_suffix(".geo")
    geometry.write_text(
        'SetFactory("OpenCASCADE"); Box(1) = {-1, -1, -1, 2, 2, 2}; Sphere(2) = {0, 0, 0, 0.6};\n'
        "BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n"
        'Physical Volume("ball", 7) = {2}; Physical Volume("rest", 3) = {3};\n'
        "Mesh.MeshSizeMax = 0.35;\n"
    )
    subprocess.run(
        ["gmsh", "-3", str(geometry), "-v", "1", "-o", str(path), *arguments],
        check=True,
        capture_output=True,
    )


# nibabel


def write_nifti(path, affine, values=None):
    import nibabel

    nibabel.save(nibabel.Nifti1Image(ball_voxels() if values is None else values, affine), path)


AXES = np.array([[0, -0.5, 0, 10], [0.7, 0, 0, -3], [0, 0, -1, 4], [0, 0, 0, 1.0]])
"""Affine map of an image whose axes are permuted and reversed."""

OBLIQUE = np.array(
    [[np.cos(0.3), -np.sin(0.3), 0, 0], [np.sin(0.3), np.cos(0.3), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]]
)


# FEniCS


def write_dolfinx(folder):
    """Writes a cube with label 1 in a smaller cube. Returns the file."""
    import dolfinx
    from mpi4py import MPI

    mesh = dolfinx.mesh.create_unit_cube(MPI.COMM_WORLD, 4, 4, 4)
    label = dolfinx.fem.Function(dolfinx.fem.FunctionSpace(mesh, ("DG", 0)))
    label.name = "label"
    inside = dolfinx.mesh.locate_entities(mesh, 3, lambda x: np.abs(x - 0.5).max(axis=0) < 0.3)
    label.x.array[inside] = 1
    with dolfinx.io.VTKFile(MPI.COMM_WORLD, str(folder / "cube.pvd"), "w") as file:
        file.write_function(label)
    return folder / "cube_p0_000000.vtu"
