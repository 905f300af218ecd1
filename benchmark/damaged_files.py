#!/usr/bin/env python3
"""Gives damaged and malicious files to `dsc`, and measures how it refuses them.

Usage: benchmark/damaged_files.py bombs PROGRAM [WORDS]
       benchmark/damaged_files.py mutations PROGRAM NUMBER [WORDS]

Bombs are small files that promise up to 1e18 items, whose content is compressed a thousandfold, that name
other files, or that contain words of 100 kB. Mutations are small valid files of each format with random
changes, the same for the same NUMBER; contents behind checksums are changed before the checksums are
computed. WORDS choose files by parts of their names. Prints a table: for each bomb the seconds and the peak
memory of the largest process, for each format the numbers of files that were read, that were refused in
one line, and that were not. JOBS in the environment is the number of processes (default: 2).
"""
import collections
import concurrent.futures
import gzip
import json
import math
import os
import pathlib
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
import zlib

LIMIT = 10  # seconds of processor time until a run counts as hanging
MEMORY = 16 << 30  # bytes of address space, for the safety of the machine
UNCLEAR = re.compile(
    rb"std::|cannot execute|bad_alloc|Sanitizer|runtime error|[Aa]ssert|CGAL|0x[0-9a-f]{4}|unknown error|[\x00-\x08\x0b-\x1f\x7f]|basic_string|"
    rb"vector::|json\.exception|filesystem error"
)
HUGE = 10**12
WORD = b"\x1b[31m\x07" + b"w" * 100000


# Files of each format


def inr(size=(3, 3, 3), values=None, extra=b""):
    x, y, z = size
    lines = f"XDIM={x}\nYDIM={y}\nZDIM={z}\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\n".encode()
    return b"#INRIMAGE-4#{\n" + lines + extra + b"##}\n" + (box(size) if values is None else values)


def box(size):
    """Returns voxels with label 1 inside and 0 at the boundary; for large images only a few."""
    x, y, z = size
    if x * y * z > 10**6:
        return bytes(1000)
    inside = lambda i, n: n == 1 or 0 < i < n - 1
    return bytes(
        inside(i, x) and inside(j, y) and inside(k, z) for k in range(z) for j in range(y) for i in range(x)
    )


def nii(size=(5, 5, 5), values=None, kind=2, bits=8):
    dims = struct.pack("<8h", 3, *size, 1, 1, 1, 1)
    header = struct.pack("<i36x", 348) + dims + struct.pack("<14xhhh", kind, bits, 0)
    header += struct.pack("<8f f f f", 1, 1, 1, 1, 1, 1, 1, 1, 352, 1, 0)
    header = header.ljust(344, b"\0") + b"n+1\0" + b"\0" * 4
    return header + (box(size) if values is None else values)


def mha(size=(5, 5, 5), values=None, data="LOCAL", extra=""):
    text = f"ObjectType = Image\nNDims = 3\nDimSize = {size[0]} {size[1]} {size[2]}\nElementType = MET_UCHAR\n"
    return (text + extra + f"ElementDataFile = {data}\n").encode() + (
        box(size) if values is None else values
    )


def nrrd(size=(12, 4, 4), values=None, encoding="raw", extra=""):
    text = f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {size[0]} {size[1]} {size[2]}\nencoding: {encoding}\nspacings: 1 1 1\n"
    return (text + extra + "\n").encode() + (box(size) if values is None else values)


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(size=(8, 8), colors=0, data=None, depth=8, interlaced=0):
    w, h = size
    channels = {0: 1, 2: 3, 6: 4}[colors]
    if data is None:
        pixels = box((w, h, 1))
        rows = (bytes(c for v in pixels[w * y : w * y + w] for c in [v] * channels) for y in range(h))
        data = zlib.compress(b"\0" + b"\0".join(rows))
    header = struct.pack(">IIBBBBB", w, h, depth, colors, 0, 0, interlaced)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data)
        + chunk(b"IEND", b"")
    )


def png_chunks(data):
    """Returns a picture whose checksums are corrected."""
    result, at = data[:8], 8
    while at + 8 <= len(data):
        n = struct.unpack(">I", data[at : at + 4])[0]
        content = data[at + 8 : at + 8 + n]
        result += data[at : at + 8] + content + struct.pack(">I", zlib.crc32(data[at + 4 : at + 8] + content))
        at += 12 + n
    return result


def tiff(size=(8, 8), data=None, compression=1, rows=None):
    w, h = size
    data = box((w, h, 1)) if data is None else data
    entries = [(256, 4, w), (257, 4, h), (258, 3, 8), (259, 3, compression), (262, 3, 1), (273, 4, 8), (277, 3, 1)]
    entries += [(278, 4, h if rows is None else rows), (279, 4, len(data))]
    text = b"II*\0" + struct.pack("<I", 8 + len(data)) + data + struct.pack("<H", len(entries))
    return text + b"".join(struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in entries) + b"\0" * 4


def zeros(n, wrap="zlib"):
    """Returns compressed zeros, a sequence of equal compressed pieces."""
    piece = bytes(1 << 24)
    number, rest = divmod(n, len(piece))
    make, end = (zlib.compressobj(9, zlib.DEFLATED, -15) for _ in range(2))
    data = (make.compress(piece) + make.flush(zlib.Z_FULL_FLUSH)) * number + end.compress(bytes(rest)) + end.flush()
    if wrap == "zlib":
        return b"\x78\xda" + data + struct.pack(">I", n % 65521 << 16 | 1)
    crc = 0
    for _ in range(number):
        crc = zlib.crc32(piece, crc)
    return gzip.compress(b"")[:10] + data + struct.pack("<II", zlib.crc32(bytes(rest), crc), n % (1 << 32))


def zip_of_zeros(path, name, begin, piece, number):
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED, compresslevel=9) as package:
        with package.open(name, "w", force_zip64=True) as file:
            file.write(begin)
            for _ in range(number):
                file.write(piece)


def block(data, block_size=1 << 15):
    """Returns an array as the compressed blocks of VTK."""
    pieces = [zlib.compress(data[i : i + block_size]) for i in range(0, len(data), block_size)]
    last = len(data) % block_size
    return struct.pack(f"<{3 + len(pieces)}Q", len(pieces), block_size, last, *map(len, pieces)) + b"".join(pieces)


TETRAHEDRA = [(0, 1, 2, 3), (1, 2, 3, 4)]
POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def vtu(encoding="raw", compressed=False, points=None, counts=(5, 2), arrays=None, name="label"):
    """Returns two tetrahedra; `arrays` replaces encoded arrays by name."""
    import base64

    data = {
        "points": ("Float32", 3, struct.pack("<15f", *[x for p in POINTS for x in p])),
        "connectivity": ("Int64", 1, struct.pack("<8q", *[v for t in TETRAHEDRA for v in t])),
        "offsets": ("Int64", 1, struct.pack("<2q", 4, 8)),
        "types": ("UInt8", 1, bytes([10, 10])),
        name: ("Int32", 1, struct.pack("<2i", 1, 2)),
    }
    appended, texts = b"", {}
    for key, (kind, components, content) in data.items():
        encoded = (arrays or {}).get(key)
        if encoded is None:
            encoded = block(content) if compressed else struct.pack("<Q", len(content)) + content
        attributes = f'<DataArray type="{kind}" Name="{key}" NumberOfComponents="{components}" format='
        if encoding == "raw":
            texts[key] = attributes + f'"appended" offset="{len(appended)}"/>'
            appended += encoded
        elif encoding == "base64":
            n = 8 * (3 + struct.unpack("<Q", encoded[:8])[0]) if compressed else 8
            words = base64.b64encode(encoded[:n]) + base64.b64encode(encoded[n:]) if compressed else base64.b64encode(encoded)
            texts[key] = attributes + '"binary">' + words.decode() + "</DataArray>"
        else:
            numbers = struct.unpack("<%d%s" % (len(content) // struct.calcsize(f := {"Float32": "f", "Int64": "q", "UInt8": "B", "Int32": "i"}[kind]), f), content)
            texts[key] = attributes + '"ascii">' + " ".join(map(str, numbers)) + "</DataArray>"
    compressor = ' compressor="vtkZLibDataCompressor"' if compressed else ""
    text = (
        f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
        f'header_type="UInt64"{compressor}>\n<UnstructuredGrid><Piece NumberOfPoints="{counts[0]}" NumberOfCells="{counts[1]}">\n'
        f"<Points>{texts['points']}</Points>\n<Cells>{texts['connectivity']}\n{texts['offsets']}\n{texts['types']}</Cells>\n"
        f"<CellData>{texts[name]}</CellData>\n</Piece></UnstructuredGrid>\n"
    )
    if encoding == "raw":
        return text.encode() + b'<AppendedData encoding="raw">\n_' + appended + b"\n</AppendedData>\n</VTKFile>\n"
    return (text + "</VTKFile>\n").encode()


def vti(extent="0 4 0 4 0 4", data=None, compressed=False):
    content = box((5, 5, 5))
    encoded = data or (block(content) if compressed else struct.pack("<Q", len(content)) + content)
    compressor = ' compressor="vtkZLibDataCompressor"' if compressed else ""
    return (
        f'<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64"{compressor}>\n'
        f'<ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="{extent}">\n<PointData Scalars="l">'
        '<DataArray type="UInt8" Name="l" format="appended" offset="0"/></PointData></Piece></ImageData>\n'
        '<AppendedData encoding="raw">\n_'
    ).encode() + encoded + b"\n</AppendedData>\n</VTKFile>\n"


def vtp(points=5, polys=4, compressed=False):
    xyz = " ".join(str(x) for p in POINTS for x in p)
    return (
        f'<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="{points}" '
        f'NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{polys}">\n<Points><DataArray type="Float32" '
        f'NumberOfComponents="3" format="ascii">{xyz}</DataArray></Points>\n<Polys><DataArray type="Int64" Name="connectivity" '
        f'format="ascii">{" ".join(str(v) for f in FACES for v in f)}</DataArray>\n<DataArray type="Int64" Name="offsets" '
        'format="ascii">3 6 9 12</DataArray></Polys></Piece></PolyData></VTKFile>\n'
    ).encode()


def lists(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def off(points=5, faces=4):
    return f"OFF\n{points} {faces} 0\n".encode() + lists(POINTS + [(3, *f) for f in FACES]).encode()


def obj(name="part"):
    return (f"o {name}\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in POINTS)).encode() + "".join(
        f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES
    ).encode()


def stl(name="part"):
    text = f"solid {name}\n"
    for face in FACES:
        text += "facet normal 0 0 0\nouter loop\n" + "".join("vertex %d %d %d\n" % POINTS[v] for v in face) + "endloop\nendfacet\n"
    return (text + "endsolid\n").encode()


def binary_stl(number=4):
    facets = b"".join(bytes(12) + b"".join(struct.pack("<3f", *POINTS[v]) for v in f) + b"\0\0" for f in FACES)
    return b"binary".ljust(80) + struct.pack("<I", number) + facets


def ply(points=5, faces=4, binary=False, extra=""):
    header = (
        f"ply\nformat {'binary_little_endian' if binary else 'ascii'} 1.0\nelement vertex {points}\nproperty float x\n"
        f"property float y\nproperty float z\nelement face {faces}\nproperty list uchar int vertex_indices\n{extra}end_header\n"
    ).encode()
    if not binary:
        return header + lists(POINTS + [(3, *f) for f in FACES]).encode()
    return header + b"".join(struct.pack("<3f", *p) for p in POINTS) + b"".join(struct.pack("<B3i", 3, *f) for f in FACES)


def medit(points=5, cells=2):
    text = f"MeshVersionFormatted 2\nDimension 3\nVertices\n{points}\n" + lists((*p, 0) for p in POINTS)
    text += f"Tetrahedra\n{cells}\n" + lists((*(v + 1 for v in t), i) for i, t in enumerate(TETRAHEDRA, 1)) + "End\n"
    return text.encode()


def meshb(points=5, cells=2):
    vertices = struct.pack("<i", points) + b"".join(struct.pack("<3di", *p, 0) for p in POINTS)
    tetrahedra = struct.pack("<i", cells) + b"".join(struct.pack("<5i", *(v + 1 for v in t), 1) for t in TETRAHEDRA)
    result = struct.pack("<ii", 1, 2)
    for key, data in (3, struct.pack("<i", 3)), (4, vertices), (8, tetrahedra):
        result += struct.pack("<ii", key, len(result) + 8 + len(data)) + data
    return result + struct.pack("<ii", 54, 0)


def msh(points=5, cells=2, name="solid"):
    text = f'$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 "{name}"\n$EndPhysicalNames\n$Nodes\n{points}\n'
    text += lists((i, *p) for i, p in enumerate(POINTS, 1)) + f"$EndNodes\n$Elements\n{cells}\n"
    return (text + lists((i, 4, 2, 1, 1, *(v + 1 for v in t)) for i, t in enumerate(TETRAHEDRA, 1)) + "$EndElements\n").encode()


def legacy(points=5, cells=2, binary=False, name="label"):
    text = f"# vtk DataFile Version 3.0\nt\n{'BINARY' if binary else 'ASCII'}\nDATASET UNSTRUCTURED_GRID\nPOINTS {points} float\n".encode()
    numbers = [(4, *t) for t in TETRAHEDRA]
    pack = lambda form, rows: b"".join(struct.pack(">" + form, *row) for row in rows) + b"\n" if binary else lists(rows).encode()
    text += pack("3f", POINTS) + f"CELLS {cells} {5 * cells}\n".encode() + pack("5i", numbers)
    text += f"CELL_TYPES {cells}\n".encode() + pack("i", [(10,), (10,)])
    return text + f"CELL_DATA 2\nSCALARS {name} int 1\nLOOKUP_TABLE default\n".encode() + pack("i", [(1,), (2,)])


def legacy_image(size=(5, 5, 5)):
    n = size[0] * size[1] * size[2]
    text = "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS %d %d %d\n" % size
    return (text + f"ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA {n}\nSCALARS l unsigned_char 1\nLOOKUP_TABLE default\n").encode() + box((5, 5, 5))


def pcd(points=5, data="ascii", rows=POINTS):
    text = f"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {points}\nHEIGHT 1\nPOINTS {points}\nDATA {data}\n"
    return text.encode() + (lists(rows).encode() if data == "ascii" else b"".join(struct.pack("<3f", *p) for p in rows))


def model_3mf(name="cube"):
    vertices = "".join('<vertex x="%d" y="%d" z="%d"/>' % p for p in POINTS)
    triangles = "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % f for f in FACES)
    return (
        '<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" xml:lang="en-US" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
        f'<object id="1" type="model" name="{name}"><mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles>'
        '</mesh></object></resources><build><item objectid="1"/></build></model>'
    ).encode()


def write_3mf(path, model, others=()):
    kind = "http://schemas.openxmlformats.org/package/2006/"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as package:
        package.writestr(
            "[Content_Types].xml",
            f'<?xml version="1.0" encoding="UTF-8"?><Types xmlns="{kind}content-types"><Default Extension="rels" '
            'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" '
            'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
        )
        package.writestr(
            "_rels/.rels",
            f'<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="{kind}relationships"><Relationship '
            'Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
        )
        if model is not None:
            package.writestr("3D/3dmodel.model", model)


def packed_3mf(model):
    with tempfile.TemporaryDirectory() as folder:
        write_3mf(pathlib.Path(folder) / "m.3mf", model)
        return (pathlib.Path(folder) / "m.3mf").read_bytes()


def pvtu(source="grid.vtu"):
    return (
        '<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PUnstructuredGrid '
        'GhostLevel="0"><PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints><PCellData><PDataArray '
        f'type="Int32" Name="label"/></PCellData><Piece Source="{source}"/></PUnstructuredGrid></VTKFile>\n'
    ).encode()


def vtm(file="m/grid.vtu", name="part"):
    return (
        '<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian" header_type="UInt64">'
        f'<vtkMultiBlockDataSet><DataSet index="0" name="{name}" file="{file}"/></vtkMultiBlockDataSet></VTKFile>\n'
    ).encode()


def geojson(kind="Polygon"):
    polygon = {"type": kind, "coordinates": [[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]}
    return json.dumps({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"a": 1}, "geometry": polygon}]}).encode()


SPHERE = [  # spirals
    (round(math.sqrt(1 - z * z) * math.cos(2.4 * i), 2), round(math.sqrt(1 - z * z) * math.sin(2.4 * i), 2), z)
    for i, z in enumerate(i / 10 - 0.95 for i in range(20))
]
POLY = b"4 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 1\n4 0 1 1\n4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n1\n1 .5 .5 3\n"
WKT = b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (.5 .5, .5 1, 1 1, 1 .5, .5 .5))\nMULTIPOLYGON (((3 0, 4 0, 4 1, 3 0)))\n"
PGM = b"P5\n8 8\n255\n" + box((8, 8, 1))
SCENE = json.dumps(
    {
        "title": "water", "domain": [0, 0, 0, 1, 1, 1], "edge": 0.3, "gravity": [0, 0, -1], "time_step": 0.02, "end": 0.02,
        "liquids": [{"shape": {"type": "box", "from": [0.2, 0.2, 0.2], "to": [0.8, 0.8, 0.6]}, "density": 1}],
    }
).encode()


# Running the program


def measure(command, folder, is_repeated=False):
    """Returns the status, the output, seconds of processor time and megabytes of the largest process.

    A run that got hardly any processor time until it was stopped is repeated once.
    """
    limits = ["prlimit", f"--as={MEMORY}", f"--cpu={LIMIT}", "--"]
    with open(folder / "out", "wb") as out, open(folder / "err", "wb") as err:
        child = subprocess.Popen(limits + command, stdin=subprocess.DEVNULL, stdout=out, stderr=err, cwd=folder, start_new_session=True)
        begun = time.monotonic()
        is_hanging = threading.Timer(LIMIT * 2, lambda: os.killpg(child.pid, signal.SIGKILL))
        is_hanging.start()
        _, status, usage = os.wait4(child.pid, 0)
        is_hanging.cancel()
        child.returncode = status
    seconds, elapsed = usage.ru_utime + usage.ru_stime, time.monotonic() - begun
    if elapsed > 2 * LIMIT - 1 and seconds < 0.1 * LIMIT and not is_repeated:
        return measure(command, folder, is_repeated=True)
    return status, (folder / "err").read_bytes(), (folder / "out").read_bytes(), seconds, usage.ru_maxrss / 1024, elapsed


def verdict(status, err, out, seconds, elapsed):
    """Returns a word for what the program did, and the reason of a fault."""
    lines = err.decode(errors="replace").splitlines()
    text = lines[-1] if lines else ""
    if seconds > LIMIT - .5 or elapsed > 2 * LIMIT - 1:
        return "hang", text
    if os.WIFSIGNALED(status):
        return "crash", f"signal {os.WTERMSIG(status)} {text}"
    if re.search(rb"Sanitizer|runtime error:|[Aa]ssertion", err):
        return "crash", text
    if UNCLEAR.search(err) or UNCLEAR.search(out):
        return "unclear", text
    if status == 0:
        return "read", ""
    if len(err) > 1700:
        return "unclear", f"{len(err)} bytes"
    if "crashes its reader" in text:
        return "reader crashed", text
    if any(re.match(r"dsc: \S+: ", line) is None for line in lines[:-1]):  # a note on the content before the error
        return "lines", " / ".join(lines)
    if not text.startswith("dsc: ") or not re.search("[;:,?]", text[5:]):
        return "unclear", text
    return "refused", text


# Bombs


def bombs(at):
    """Writes the bombs. Returns their names and commands."""
    link = lambda name, target: (at / name).symlink_to(target)
    result = []

    def add(name, content, command="info {}"):
        if content is not None:
            (at / name).write_bytes(content)
        result.append((name, command))

    big = 1 << 30
    flat = zeros(30000 * 30001)
    add("promise.png", png((60000, 60000), data=zeros(10**6)))
    add("large.png", png((30000, 30000), data=flat))
    add("wide.png", png((30000, 30000), data=flat, depth=16))
    add("interlaced.png", png((30000, 30000), data=flat, interlaced=1))
    add("colors.png", png((10000, 30000), colors=2, data=flat))
    add("otsu.png", png((30000, 30000), data=flat), "info {} --threshold otsu")
    add("segment.png", png((30000, 30000), data=flat), "segment {} -o s.wkt")
    add("promise.tif", tiff((10**6, 10**6)))
    add("promise_strips.tif", tiff((10**6, 10**6), rows=1))
    add("large.tif", tiff((30000, 30000), data=zeros(30000 * 30000), compression=8))
    add("promise.nii", nii((32767, 32767, 32767)))
    add("promise_double.nii", nii((10000, 10000, 10000), kind=64, bits=64))
    add("promise.nii.gz", gzip.compress(nii((32767, 32767, 32767))))
    honest = zeros(1000**3, "gzip")
    add("large.nii.gz", gzip.compress(nii((1000, 1000, 1000), b"")) + honest)
    add("tail.nii.gz", gzip.compress(nii()) + honest)
    add("segment.nii.gz", gzip.compress(nii((1000, 1000, 1000), b"")) + honest, "segment {} -o s.ply")
    add("promise.inr", inr((10000, 10000, 10000)))
    add("promise.inr.gz", gzip.compress(inr((10000, 10000, 10000))))
    add("large.inr.gz", gzip.compress(inr((1000, 1000, 1000), b"")) + honest)
    add("tail.inr.gz", gzip.compress(inr()) + honest * 10)
    add("large_offset.inr.gz", gzip.compress(inr((1000, 1000, 1000), b"")) + honest, "offset {} --distance .05 --steps 1")
    add("promise.mha", mha((10000, 10000, 10000)))
    add("promise_compressed.mha", mha((10000, 10000, 10000), zeros(1000), extra="CompressedData = True\n"))
    add("large.mha", mha((1000, 1000, 1000), zeros(1000**3), extra="CompressedData = True\n"))
    add("promise.nrrd", nrrd((10000, 10000, 10000)))
    add("large.nrrd", nrrd((1000, 1000, 1000), honest, "gzip"))
    for encoding in "ascii", "base64", "raw":
        for packed in (False, True)[: 1 if encoding == "ascii" else 2]:
            add(f"promise_{encoding}{'_z' * packed}.vtu", vtu(encoding, packed, counts=(HUGE, HUGE)))
            add(f"promise_points_{encoding}{'_z' * packed}.vtu", vtu(encoding, packed, counts=(HUGE, 2)))
    n = 80 * 10**6  # points
    packed = zlib.compress(bytes(1 << 24), 9)
    number, rest = divmod(12 * n, 1 << 24)
    zipped = struct.pack(f"<{3 + number + 1}Q", number + 1, 1 << 24, rest, *[len(packed)] * number, len(last := zlib.compress(bytes(rest))))
    zipped += packed * number + last
    add("large.vtu", vtu(compressed=True, counts=(n, 2), arrays={"points": zipped}))
    add("large_offset.vtu", vtu(compressed=True, counts=(n, 2), arrays={"points": zipped}), "offset {} --distance .05 --steps 1")
    add("connectivity.vtu", vtu(compressed=True, arrays={"connectivity": zipped, "offsets": block(struct.pack("<2q", 4, n))}))
    add("offsets.vtu", vtu(arrays={"offsets": struct.pack("<3q", 16, 4, HUGE)}))
    add("offsets_z.vtu", vtu(compressed=True, arrays={"offsets": block(struct.pack("<2q", 4, HUGE))}))
    add("blocks.vtu", vtu(compressed=True, arrays={"points": struct.pack("<4Q", HUGE, HUGE, 0, 1)}))
    add("block_size.vtu", vtu(compressed=True, arrays={"points": struct.pack("<4Q", 1, HUGE, 0, 10) + b"x" * 10}))
    add("entities.vtu", b'<!DOCTYPE a [<!ENTITY a0 "aaaaaaaaaa">' + b"".join(b'<!ENTITY a%d "%s">' % (i, b"&a%d;" % (i - 1) * 10) for i in range(1, 12)) + b"]>" + vtu("ascii", True).replace(b"label", b"&a11;").replace(b'<?xml version="1.0"?>', b""))
    add("promise.vti", vti("0 9999 0 9999 0 9999"))
    zip_of_voxels = struct.pack("<60Q", 57, 1 << 24, 0, *[len(packed)] * 57) + packed * 57
    add("large.vti", vti("0 999 0 999 0 955", zip_of_voxels, compressed=True))
    add("promise.vtp", vtp(HUGE, HUGE))
    add("promise.vtk", legacy(HUGE, 2))
    add("promise_cells.vtk", legacy(5, HUGE))
    add("promise_binary.vtk", legacy(HUGE, HUGE, binary=True))
    add("promise_2e9.vtk", legacy(2 * 10**9, 2, binary=True))
    add("promise_image.vtk", legacy_image((10000, 10000, 10000)))
    add("promise.msh", msh(HUGE, HUGE))
    add("promise_2e9.msh", msh(2 * 10**9, 2 * 10**9))
    add("promise.ply", ply(HUGE, HUGE))
    add("promise_binary.ply", ply(HUGE, HUGE, binary=True))
    add("empty_elements.ply", ply().replace(b"element vertex", b"element nothing 1000000000000\nelement vertex"))
    add("list.ply", ply().replace(b"list uchar", b"list uint").replace(b"\n3 0 2 1", b"\n4000000000 0 2 1"))
    add("promise_points.ply", ply(HUGE, HUGE, binary=True), "reconstruct {} -o r.off")
    add("promise.off", off(HUGE, HUGE))
    add("polygon.off", off().replace(b"\n3 0 2 1", b"\n1000000000000 0 2 1"))
    add("promise.obj", obj() + b"f 1 1000000000000 2\n")
    add("promise.stl", binary_stl(4 * 10**9))
    add("promise.mesh", medit(HUGE, HUGE))
    add("index.mesh", medit().replace(b"\n1 2 3 4 1", b"\n1 2 3 1000000000000 1"))
    add("promise.meshb", meshb(2 * 10**9, 2 * 10**9))
    add("promise.pcd", pcd(HUGE), "reconstruct {} -o r.off")
    add("promise_binary.pcd", pcd(HUGE, "binary"), "reconstruct {} -o r.off")
    add("columns.pcd", pcd(HUGE, "binary").replace(b"COUNT 1 1 1", b"COUNT 1 1 1024"), "reconstruct {} -o r.off")
    add("promise.xyz", b"1000000000000\n0 0 0\n", "reconstruct {} -o r.off")
    add("promise.pgm", b"P5\n1000000 1000000\n255\nxxx")
    add("promise.ppm", b"P6\n1000000 1000000\n255\nxxx", "segment {} -o s.wkt")
    add("promise.poly", POLY.replace(b"4 2 0 1", b"1000000000000 2 0 1"))
    add("depth.wkt", b"(" * 10**6)
    add("depth.geojson", b"[" * 10**6)
    add("depth_geometry.geojson", b'{"type":"GeometryCollection","geometries":[' * 10**5 + b"]}" * 10**5)
    add("depth.json", b"[" * 10**6, "fluid {} --output o")
    add("edge.json", SCENE.replace(b"0.3", b"1e-9"), "fluid {} --output o")
    for name in "off", "nii", "nii.gz", "inr", "inr.gz", "dsc", "png", "pgm", "vtu", "mha", "msh", "3mf", "stl", "vtk", "csv":
        link(f"device.{name}", "/dev/zero")
        add(f"device.{name}", None)
        os.mkfifo(at / f"fifo.{name}")
        add(f"fifo.{name}", None)
    link("device.json", "/dev/zero")
    add("device.json", None, "fluid {} --output o")
    write_3mf(at / "large.3mf", None)
    begin, end = model_3mf().split(b"<vertices>")
    zip_of_zeros(at / "large.3mf", "3D/3dmodel.model", begin + b"<vertices>", b'<vertex x="0" y="0" z="0"/>' * 40000, 300)
    add("large.3mf", None)
    write_3mf(at / "spaces.3mf", None)
    zip_of_zeros(at / "spaces.3mf", "3D/3dmodel.model", begin, b" " * (1 << 20), 300)
    add("spaces.3mf", None)
    for name in "/etc/passwd", "/dev/zero", "../other.raw", "list/%03d.raw", "no.raw":
        short = re.sub(r"\W+", "_", name)
        add(f"named{short}.mhd", mha(data=name, values=b""))
        add(f"named{short}.nhdr", nrrd(values=b"", extra=f"data file: {name}\n"))
        add(f"named{short}.pvtu", pvtu(name))
        add(f"named{short}.vtm", vtm(name))
    add("named_itself.vtm", vtm("named_itself.vtm"))
    add("named_itself.pvtu", pvtu("named_itself.pvtu"))
    word = WORD.decode()
    for name, content in {
        "off": off().replace(b"0 0 0", WORD), "obj": obj(word), "stl": stl(word), "ply": ply(extra=f"property float {word}\n"),
        "vtu": vtu(name="n" + "w" * 100000), "mesh": medit().replace(b"Tetrahedra", WORD), "inr": inr(extra=b"A" + WORD[:4000] + b"=1\n"),
        "mha": mha(extra=f"{word} = 1\n"), "mhd": mha(data=word, values=b""), "nrrd": nrrd(extra=f"{word}: 1\n"), "csv": b"x,y,z,a\n1,2,%s,1\n" % WORD,
        "3mf": packed_3mf(model_3mf("n" * 100000)), "geojson": geojson(word), "msh": msh(name=word), "vtk": legacy(name=word),
        "poly": POLY.replace(b"1 0 0 1", WORD), "wkt": WKT.replace(b"POLYGON", WORD), "pcd": pcd(data=word), "vtm": vtm(name=word),
        "png": png(data=WORD), "tif": tiff().replace(b"II", b"MM"), "pgm": PGM.replace(b"8 8", WORD),
    }.items():
        add(f"words.{name}", content, "reconstruct {} -o r.off" if name in ("csv", "pcd") else "info {}")
    add("words.json", SCENE.replace(b"water", WORD.replace(b"\x1b", b"\\u001b").replace(b"\x07", b"\\n")), "fluid {} --output o")
    add("field.json", SCENE.replace(b'"edge"', b'"' + WORD[5:] + b'"'), "fluid {} --output o")
    for name in "named", "m":
        (at / name).mkdir()
    return result


def run_bombs(program, words):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "in").mkdir()
        print("| file | s | MB | status | line |\n| --- | --- | --- | --- | --- |")
        faults = 0
        for name, command in bombs(folder / "in"):
            if words and not any(word in name for word in words):
                continue
            arguments = [program, *command.format(folder / "in" / name).split()]
            status, err, out, seconds, memory, elapsed = measure(arguments, folder)
            kind, why = verdict(status, err, out, seconds, elapsed)
            is_fault = kind != "refused" and not (kind == "read" and name.startswith(("words", "tail", "empty"))) or seconds > 2 or memory > 1024
            faults += is_fault
            line = err.decode(errors="replace").replace(str(folder / "in") + "/", "").strip()
            print(f"| {name} | {seconds:.2f} | {memory:.0f} | {kind}{' **' if is_fault else ''} | {line[:170]!r} |", flush=True)
        print(f"{faults} faults")


# Mutations


def signed_checkpoint(data):
    if len(data) < 24:
        return data
    return data[:12] + struct.pack("<IQ", zlib.crc32(data[24:]), len(data) - 24) + data[24:]


def seeds(program):
    """Returns for each format the name of a file, its content, what wraps a changed content, other files, commands."""
    same = lambda data: data
    surface, image, grid = ["info {}", "offset {} --distance .05 --steps 1 --edge .3 --domain -1,-1,-1,2,2,2", "convert {} r.ply", "reconstruct {} -o r.off"], ["info {}", "convert {} r.vti", "segment {} -o r.ply"], ["info {}", "convert {} r.vtu"]
    plane = ["info {}", "offset {} --distance .05 --steps 1", "segment {} -o r.wkt"]
    points, cloud = ["reconstruct {} -o r.off"], lists(SPHERE).encode()
    result = {
        "off": ("a.off", off(), same, surface), "obj": ("a.obj", obj(), same, surface), "stl": ("a.stl", stl(), same, surface),
        "stl_binary": ("a.stl", binary_stl(), same, surface), "ply": ("a.ply", ply(), same, surface), "ply_binary": ("a.ply", ply(binary=True), same, surface),
        "inr": ("a.inr", inr(), same, image), "inr_gz": ("a.inr.gz", inr(), gzip.compress, image), "nii": ("a.nii", nii(), same, image),
        "nii_gz": ("a.nii.gz", nii(), gzip.compress, image), "mha": ("a.mha", mha(), same, image),
        "mha_z": ("a.mha", mha(values=zlib.compress(box((5, 5, 5))), extra="CompressedData = True\n"), same, image),
        "mhd": ("a.mhd", mha(values=b"", data="a.raw"), same, image), "nrrd": ("a.nrrd", nrrd(), same, image),
        "nrrd_gz": ("a.nrrd", nrrd(values=gzip.compress(box((12, 4, 4))), encoding="gzip"), same, image),
        "nhdr": ("a.nhdr", nrrd(values=b"", extra="data file: a.raw\n"), same, image),
        "png": ("a.png", png(), png_chunks, plane), "png_colors": ("a.png", png(colors=2), png_chunks, plane), "tif": ("a.tif", tiff(), same, plane),
        "tif_z": ("a.tif", tiff(data=zlib.compress(box((8, 8, 1))), compression=8), same, plane), "pgm": ("a.pgm", PGM, same, plane),
        "ppm": ("a.ppm", PGM.replace(b"P5\n8 8", b"P6\n4 5") + b"xxxx", same, ["segment {} -o r.wkt"]),
        "vtu_ascii": ("a.vtu", vtu("ascii"), same, grid), "vtu_base64": ("a.vtu", vtu("base64"), same, grid), "vtu_raw": ("a.vtu", vtu(), same, grid),
        "vtu_z": ("a.vtu", vtu(compressed=True), same, grid), "vtu_base64_z": ("a.vtu", vtu("base64", True), same, grid),
        "vti": ("a.vti", vti(), same, image), "vti_z": ("a.vti", vti(compressed=True), same, image), "vtp": ("a.vtp", vtp(), same, surface),
        "pvtu": ("a.pvtu", pvtu("grid.vtu"), same, grid), "vtm": ("a.vtm", vtm("grid.vtu"), same, grid),
        "vtk": ("a.vtk", legacy(), same, grid), "vtk_binary": ("a.vtk", legacy(binary=True), same, grid), "vtk_image": ("a.vtk", legacy_image(), same, image),
        "medit": ("a.mesh", medit(), same, grid), "meshb": ("a.meshb", meshb(), same, grid), "msh": ("a.msh", msh(), same, grid),
        "3mf": ("a.3mf", model_3mf(), packed_3mf, surface), "csv": ("a.csv", b"x,y,z\n" + cloud.replace(b" ", b","), same, points),
        "pcd": ("a.pcd", pcd(20, "ascii", SPHERE), same, points), "pcd_binary": ("a.pcd", pcd(20, "binary", SPHERE), same, points), "xyz": ("a.xyz", b"20\n" + cloud, same, points),
        "poly": ("a.poly", POLY, same, plane[:2]), "wkt": ("a.wkt", WKT, same, plane[:2]), "geojson": ("a.geojson", geojson(), same, plane[:2]),
        "scene": ("a.json", SCENE, same, ["fluid {} --output o --steps 1"]),
    }
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "a.wkt").write_bytes(WKT)
        for name, start in {"dsc": ["x^2+y^2+z^2<1", "--domain=-2,-2,-2,2,2,2", "--edge", "1"], "dsc_2": [folder / "a.wkt"]}.items():
            subprocess.run([program, "offset", *start, "--distance", ".05", "--steps", "1", "--output", folder / name], check=True, capture_output=True)
            file = next((folder / name).glob("*.dsc"))
            result[name] = ("a.dsc", file.read_bytes(), signed_checkpoint, ["info {}", "convert {} r.vtu"])
    return result


NUMBERS = [str(x) for x in (0, 1, -1, 255, 256, 65536, 2**31 - 1, 2**31, 2**32, HUGE, 2**63 - 1, 2**64, 10**20, 1e999, 1e-400, -1e308, 0.5)] + ["nan", "inf", "x", "", "<", '"']
BYTES = [0, 1, 0x7F, 0x80, 0xFF, 0x7FFF, 0xFFFF, 2**31 - 1, 2**31, 2**32 - 1, 0x7F800000, 0x7FC00000, 0x7FF0 << 48, 2**63 - 1, 2**64 - 1, HUGE]


def mutated(data, chance):
    """Returns a content after some changes."""
    data = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 4))):
        if not data:
            break
        at, length = chance.randrange(len(data)), chance.choice((1, 4, 8, 30, 300))
        to = chance.randrange(len(data) + 1)
        numbers = [m.span() for m in re.finditer(rb"-?[0-9]+(\.[0-9]+)?", data)]
        kind = chance.randrange(9 if numbers else 6)
        if kind == 0:
            data[at] ^= 1 << chance.randrange(8)
        elif kind == 1:
            number = struct.pack("<Q", chance.choice(BYTES))[: chance.choice((1, 2, 4, 8))]
            data[at : at + len(number)] = number[:: chance.choice((1, -1))]
        elif kind == 2:
            del data[at if chance.randrange(2) else -length :]
        elif kind == 3:
            del data[at : at + length]
        elif kind == 4:
            data[to:to] = data[at : at + length] * chance.choice((1, 1, 2, 100))
        elif kind == 5:
            data[to : to + length] = data[at : at + length]
        else:
            begin, end = chance.choice(numbers)
            data[begin:end] = chance.choice(NUMBERS).encode()
    return bytes(data)


def run_mutations(program, number, words):
    kinds = ["read", "refused", "reader crashed", "crash", "hang", "lines", "unclear"]
    print("| format | files | " + " | ".join(kinds) + " | s | MB |\n" + "| --- " * (len(kinds) + 4) + "|")
    examples = collections.Counter()

    def run(format, seed, index):
        name, content, wrap, commands = seed
        chance = random.Random(f"{format} {index}")
        data = mutated(content, chance)
        data = wrap(data) if chance.randrange(4) else mutated(wrap(content), chance)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / name).write_bytes(data)
            (folder / "a.raw").write_bytes(box((12, 4, 4)))
            (folder / "grid.vtu").write_bytes(vtu())
            command = commands[0] if chance.randrange(3) else chance.choice(commands)
            status, err, out, seconds, memory, elapsed = measure([program, *command.format(name).split()], folder)
            kind, why = verdict(status, err, out, seconds, elapsed)
            if kind not in ("read", "refused") or seconds > 5 or memory > 1024:
                if keep := os.environ.get("KEEP"):
                    place = pathlib.Path(keep) / f"{format}_{index}"
                    shutil.rmtree(place, ignore_errors=True)
                    shutil.copytree(folder, place)
                    (place / "command").write_text(f"{command.format(name)}\n{kind} {seconds:.1f} s {memory:.0f} MB\n")
                return kind, seconds, memory, f"{format} {index}: {kind} {seconds:.1f} s {memory:.0f} MB: {command}: {why[:200]!r}"
            return kind, seconds, memory, ""

    for format, seed in seeds(program).items():
        if words and not any(word in format for word in words):
            continue
        with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", 2))) as pool:
            results = list(pool.map(lambda i: run(format, seed, i), range(number)))
        count = collections.Counter(r[0] for r in results)
        print(
            f"| {format} | {number} | " + " | ".join(str(count[k]) for k in kinds)
            + f" | {max(r[1] for r in results):.1f} | {max(r[2] for r in results):.0f} |", flush=True,
        )
        for result in results:
            if result[3]:
                print(result[3], file=sys.stderr, flush=True)


def main():
    if len(sys.argv) < 3 or sys.argv[1] not in ("bombs", "mutations"):
        sys.exit(__doc__)
    if sys.argv[1] == "bombs":
        run_bombs(sys.argv[2], sys.argv[3:])
    else:
        run_mutations(sys.argv[2], int(sys.argv[3]), sys.argv[4:])


if __name__ == "__main__":
    main()
