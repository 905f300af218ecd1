"""Tests whether a file is whole. Shares no code with the program."""
import gzip
import json
import re
import struct
import xml.etree.ElementTree as ET
import zlib


class Incomplete(Exception):
    pass


def require(condition, text):
    if not condition:
        raise Incomplete(text)


def whole_json(data):
    require(isinstance(json.loads(data), dict), "is not an object")


def whole_png(data):
    require(data[:8] == b"\x89PNG\r\n\x1a\n", "has no header")
    at, kind, pixels = 8, b"", b""
    while at < len(data):
        require(kind != b"IEND", "goes on after its end")
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        checksum = struct.pack(">I", zlib.crc32(kind + body))
        require(data[at + 8 + size : at + 12 + size] == checksum, "has a wrong checksum")
        pixels += body if kind == b"IDAT" else b""
        at += 12 + size
    require(kind == b"IEND", "has no end")
    zlib.decompress(pixels)


def _xml(data):
    """Returns the root and the appended data."""
    begin = data.find(b'<AppendedData encoding="raw">')
    if begin < 0:
        return ET.fromstring(data), b""
    begin = data.index(b"_", begin) + 1
    end = data.rindex(b"</AppendedData>")
    return ET.fromstring(data[:begin] + data[end:]), data[begin:end].rstrip(b" \n")


def whole_vtk_xml(data):
    root, appended = _xml(data)
    require(root.tag == "VTKFile", "is not a file of VTK")
    kind = "<Q" if root.get("header_type") == "UInt64" else "<I"
    width = struct.calcsize(kind)

    def number(at):
        require(at + width <= len(appended), "is cut")
        return struct.unpack(kind, appended[at : at + width])[0]

    for array in root.iter("DataArray"):
        if array.get("format") == "appended":
            at = int(array.get("offset"))
            if not appended:
                return  # it is encoded as text, which the parser has read to its end
            if root.get("compressor"):
                blocks = number(at)
                size = (3 + blocks) * width + sum(number(at + (3 + i) * width) for i in range(blocks))
            else:
                size = width + number(at)
            # White space at the end was removed from the data, and may belong to it.
            require(at + size <= len(data), "is cut")


def files_of_collection(data):
    """Returns the names that a collection (.pvd) or a parallel file (.pvtu) lists."""
    root = ET.fromstring(data)
    pieces = [e.get("Source") for e in root.iter("Piece") if e.get("Source")]
    return [e.get("file") for e in root.iter("DataSet")] + pieces


def whole_svg(data):
    require(ET.fromstring(data).tag.endswith("svg"), "is not a picture")


def whole_page(data):
    require(data.rstrip().endswith(b"</html>"), "has no end")
    (film,) = re.findall(rb'<script id="film" type="application/json">(.*?)</script>', data, re.S)
    json.loads(film)


def whole_checkpoint(data):
    require(data[:3] == b"\x89DS" and len(data) > 24, "is not a checkpoint")
    at = 8
    while at < len(data):  # a block for each process
        checksum, size = struct.unpack("<IQ", data[at + 4 : at + 16])
        block = data[at + 16 : at + 16 + size]
        require(len(block) == size and zlib.crc32(block) == checksum, "is cut or damaged")
        at += 16 + size


def whole_off(data):
    words = data.split()
    points, facets = int(words[1]), int(words[2])
    lines = [line for line in data.splitlines()[1:] if line.strip() and not line.startswith(b"#")]
    require(len(lines) == 1 + points + facets and data.endswith(b"\n"), "is cut")


def whole_obj(data):
    points = data.count(b"\nv ") + data.startswith(b"v ")
    corners = [int(w.split(b"/")[0]) for line in data.splitlines() if line.startswith(b"f ") for w in line.split()[1:]]
    require(corners and max(corners) <= points and data.endswith(b"\n"), "is cut")


def whole_ply(data):
    head, body = data.split(b"end_header\n", 1)
    counts = {name: int(n) for name, n in re.findall(rb"element (\w+) (\d+)", head)}
    if b"format ascii" in head:
        require(len(body.splitlines()) == sum(counts.values()) and body.endswith(b"\n"), "is cut")
        return
    sizes = {b"double": 8, b"float": 4, b"int": 4, b"uint": 4, b"uchar": 1, b"float32": 4, b"float64": 8, b"int32": 4}
    at = 0
    for name, n in re.findall(rb"element (\w+) (\d+)", head):
        part = head.split(b"element " + name)[1].split(b"element ")[0]
        for _ in range(int(n)):
            for words in (line.split() for line in part.splitlines() if line.startswith(b"property")):
                if words[1] == b"list":
                    at += sizes[words[2]] + sizes[words[3]] * int.from_bytes(body[at : at + sizes[words[2]]], "little")
                else:
                    at += sizes[words[1]]
    require(at == len(body), "is cut")


def whole_stl(data):
    if data.startswith(b"solid"):
        require(data.rstrip().splitlines()[-1].startswith(b"endsolid"), "has no end")
    else:
        require(len(data) == 84 + 50 * struct.unpack("<I", data[80:84])[0], "is cut")


def whole_mesh(data):
    require(data.split()[-1] == b"End", "has no end")


def whole_wkt(data):
    require(data.count(b"(") == data.count(b")") > 0 and data.rstrip().endswith(b")"), "is cut")


def whole_nifti(data):
    data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
    sizes = struct.unpack("<8h", data[40:56])
    voxels = 1
    for n in sizes[1 : 1 + sizes[0]]:
        voxels *= n
    bits, start = struct.unpack("<h", data[72:74])[0], int(struct.unpack("<f", data[108:112])[0])
    require(len(data) == start + voxels * bits // 8, "is cut")


def whole_inr(data):
    head = data[: data.index(b"##}\n") + 4].decode()
    size = int(re.search(r"PIXSIZE=(\d+)", head)[1]) // 8
    for axis in "XYZ":
        size *= int(re.search(rf"{axis}DIM=(\d+)", head)[1])
    require(len(data) == len(head) + size, "is cut")


BY_EXTENSION = {
    ".json": whole_json, ".png": whole_png, ".vtu": whole_vtk_xml, ".vtp": whole_vtk_xml, ".vti": whole_vtk_xml,
    ".pvtu": whole_vtk_xml, ".pvd": files_of_collection, ".svg": whole_svg, ".html": whole_page,
    ".dsc": whole_checkpoint, ".off": whole_off, ".obj": whole_obj, ".ply": whole_ply, ".stl": whole_stl,
    ".mesh": whole_mesh, ".wkt": whole_wkt, ".nii": whole_nifti, ".gz": whole_nifti, ".inr": whole_inr,
}  # fmt: skip


def fault_of(name, data):
    """Returns why a file is not whole, or None. Files of other formats count as not whole."""
    for extension, check in BY_EXTENSION.items():
        if name.endswith(extension):
            try:
                check(data)
            except Incomplete as error:
                return str(error)
            except Exception as error:  # of a parser
                return f"cannot be read ({type(error).__name__})"
            return None
    return "is neither the old nor the new file"
