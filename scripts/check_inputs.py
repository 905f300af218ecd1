#!/usr/bin/env python3
"""Runs the program on inputs that were once lost, misread or rejected for a wrong reason.

Usage: scripts/check_inputs.py PROGRAM [FOLDER]

The inputs are generated in a temporary folder. Files of the same names in FOLDER, at any depth, replace
them. Each command must end with the given exit status, and its output must match a regular expression.
Prints each command that fails, and ends with status 1 if a command fails.
"""
import math
import os
import random
import re
import struct
import subprocess
import sys
import tempfile

LONGEST = 240  # seconds for a command, on a slow and busy machine


def box(x0, y0, z0, x1, y1, z1, n=1):
    """Returns the points and triangles of a box whose faces have n x n squares."""
    points, index, triangles = [], {}, []

    def vertex(p):
        if p not in index:
            index[p] = len(points)
            points.append(tuple(
                a + (b - a) * i / n for a, b, i in zip((x0, y0, z0), (x1, y1, z1), p)))
        return index[p]

    for axis in range(3):
        for side in (0, n):
            for i in range(n):
                for j in range(n):
                    def at(u, v):
                        p = [0, 0, 0]
                        p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side, u, v
                        return vertex(tuple(p))
                    a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
                    faces = [(a, b, c), (a, c, d)]
                    triangles += faces if side else [f[::-1] for f in faces]
    return points, triangles


def off(points, triangles):
    lines = [f"OFF\n{len(points)} {len(triangles)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in points]
    lines += ["3 " + " ".join(map(str, t)) for t in triangles]
    return "\n".join(lines) + "\n"


def two_boxes(gap, n):
    a, s = box(0, 0, 0, 1, 1, 1, n)
    b, t = box(1 + gap, 0, 0, 2 + gap, 1, 1, n)
    return off(a + b, s + [tuple(v + len(a) for v in f) for f in t])


def sphere(n):
    """Returns the points and triangles of a sphere of 4 n (n - 1) triangles."""
    m = 2 * n
    points = [(0, 0, 1), (0, 0, -1)]
    for i in range(1, n):
        for j in range(m):
            a, b = math.pi * i / n, 2 * math.pi * j / m
            points.append((math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)))

    def at(i, j):
        return 2 + (i - 1) * m + j % m

    triangles = []
    for j in range(m):
        triangles += [(0, at(1, j), at(1, j + 1)), (1, at(n - 1, j + 1), at(n - 1, j))]
        for i in range(1, n - 1):
            triangles += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)),
                          (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return points, triangles


def t_junctions():
    """Returns a box with finer triangles on one face, whose vertices are 1e-9 away from the adjacent edges."""
    points, triangles = box(0, 0, 0, 1, 1, 1, 2)
    fine, more = box(0, 0, 0, 1, 1, 1, 4)
    triangles = [t for t in triangles if not all(points[v][2] == 1 for v in t)]
    top = [t for t in more if all(fine[v][2] == 1 for v in t)]
    shift = len(points)
    moved = [(x + 1e-9 * (x in (0.25, 0.75)), y, z) for x, y, z in fine]
    return off(points + moved, triangles + [tuple(v + shift for v in t) for t in top])


def stl(points, triangles, upper):
    def word(text):
        return text.upper() if upper else text
    lines = [word("solid box")]
    for t in triangles:
        lines += [word("facet normal") + " 0 0 0", word("outer loop")]
        lines += [word("vertex") + " " + " ".join(map(repr, points[v])) for v in t]
        lines += [word("endloop"), word("endfacet")]
    return "\n".join(lines + [word("endsolid box")]) + "\n"


def cube_of_tetrahedra(n):
    """Returns the unit cube in n^3 cubes of six tetrahedra each."""
    def at(i, j, k):
        return (k * (n + 1) + j) * (n + 1) + i
    points = [(i / n, j / n, k / n) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    cells = []
    for k in range(n):
        for j in range(n):
            for i in range(n):
                for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)):
                    p = [i, j, k]
                    cell = [at(*p)]
                    for axis in order:
                        p[axis] += 1
                        cell.append(at(*p))
                    cells.append(cell)
    return points, cells


def vtu(arrays):
    points, cells = cube_of_tetrahedra(4)
    middles = [[sum(points[v][a] for v in c) / 4 for a in range(3)] for c in cells]
    text = ['<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>',
            f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}"><CellData>']
    for name, kind, value in arrays:
        text.append(f'<DataArray type="{kind}" Name="{name}" format="ascii">'
                    + " ".join(str(value(m)) for m in middles) + "</DataArray>")
    text.append('</CellData><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">'
                + " ".join(repr(x) for p in points for x in p) + "</DataArray></Points><Cells>")
    text.append('<DataArray type="Int64" Name="connectivity" format="ascii">'
                + " ".join(str(v) for c in cells for v in c) + "</DataArray>")
    text.append('<DataArray type="Int64" Name="offsets" format="ascii">'
                + " ".join(str(4 * (i + 1)) for i in range(len(cells))) + "</DataArray>")
    text.append('<DataArray type="UInt8" Name="types" format="ascii">' + " ".join(["10"] * len(cells))
                + "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>")
    return "\n".join(text) + "\n"


def medit(label=2, entities=False):
    points, cells = cube_of_tetrahedra(3)
    lines = ["MeshVersionFormatted 2", "Dimension", "3", "Vertices", str(len(points))]
    lines += [" ".join(map(repr, p)) + " 0" for p in points]
    if entities:
        lines += ["Triangles", "1", "1 2 6 7", "Edges", "1", "1 2 5", "Corners", "1", "1",
                  "RequiredVertices", "1", "2"]
    lines += ["Tetrahedra", str(len(cells))]
    lines += [" ".join(str(v + 1) for v in c) + (f" {label}" if i == 0 else " 1")
              for i, c in enumerate(cells)]
    return "\n".join(lines + ["End"]) + "\n"


def inr(n, value, spacing=1.0, short=0, bits=8):
    header = (f"#INRIMAGE-4#{{\nXDIM={n}\nYDIM={n}\nZDIM={n}\nVDIM=1\nTYPE=unsigned fixed\n"
              f"PIXSIZE={bits} bits\nCPU=decm\nVX={spacing}\nVY={spacing}\nVZ={spacing}\n")
    header += "\n" * (252 - len(header)) + "##}\n"
    values = [value(i, j, k) for k in range(n) for j in range(n) for i in range(n)]
    data = struct.pack(f"<{len(values)}{'B' if bits == 8 else 'H'}", *values)
    return header.encode() + (data[:-short] if short else data)


def ball(n, r):
    c = (n - 1) / 2
    return lambda i, j, k: int((i - c) ** 2 + (j - c) ** 2 + (k - c) ** 2 < r * r)


def salt(i, j, k):
    inside = all(1 <= x < 11 for x in (i, j, k))
    return int(inside and random.Random(1 + i + 12 * (j + 12 * k)).random() < 0.18)


def many_blobs():
    rng = random.Random(4)
    seeds = [[rng.uniform(4, 44) for _ in range(3)] for _ in range(60)]

    def value(i, j, k):
        d, label = min(((i - x) ** 2 + (j - y) ** 2 + (k - z) ** 2, n) for n, (x, y, z) in enumerate(seeds, 1))
        return label if d < 30 else 0
    return inr(48, value, bits=16)


def ring(n, r):
    return [(r * math.cos(2 * math.pi * i / n), r * math.sin(2 * math.pi * i / n)) for i in range(n)]


def poly():
    points = ring(32, 1)
    lines = ["32 2 0 0"] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(points)]
    return "\n".join(lines + ["32 0"] + [f"{i} {i} {(i + 1) % 32}" for i in range(32)] + ["0"]) + "\n"


def terrain():
    return "".join(f"{i / 40} {j / 40} {0.1 * math.sin(i / 5) * math.cos(j / 7)!r}\n"
                   for i in range(41) for j in range(41))


INPUTS = {
    "fields.vtu": lambda: vtu([("temperature", "Float64", lambda m: m[0]),
                               ("material", "Int32", lambda m: int(m[0] > 0.5))]),
    "material.vtu": lambda: vtu([("material", "Int32", lambda m: int(m[0] > 0.5))]),
    "jit.mesh": lambda: medit(entities=True),
    "onevoxel.inr": lambda: inr(20, lambda *p: int(p == (10, 10, 10))),
    "two_singles.inr": lambda: inr(20, lambda *p: int(p == (6, 10, 10)) + 2 * int(p == (13, 10, 10))),
    "salt3.inr": lambda: inr(12, salt),
    "vox1.inr": lambda: inr(20, ball(20, 7)),
    "vox0.001.inr": lambda: inr(20, ball(20, 7), 0.001),
    "vox0.00001.inr": lambda: inr(20, ball(20, 7), 0.00001),
    "bom.off": lambda: "\ufeff" + off(*sphere(8)),
    "modelnet.off": lambda: off(*sphere(8)).replace("OFF\n", "OFF", 1),
    "noedges.off": lambda: "OFF\n4 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
    "upper.stl": lambda: stl(*sphere(8), True),
    "m_biglabel64.mesh": lambda: medit(label=3000000000),
    "trunc.inr": lambda: inr(20, ball(20, 7), short=3000),
    "tri0.poly": poly,
    "terrain.xyz": terrain,
    "tjunc.off": t_junctions,
    "v60_s16.inr": many_blobs,
    "sphere.off": lambda: off(*sphere(8)),
    "g4_0.001.off": lambda: two_boxes(1e-3, 4),
    "g4_1e-06.off": lambda: two_boxes(1e-6, 4),
    "g5_1e-05.off": lambda: two_boxes(1e-5, 5),
    "crossing.off": lambda: off(*(lambda a, b: (a[0] + b[0], a[1] + [tuple(v + 8 for v in t) for t in b[1]]))(
        box(0, 0, 0, 1, 1, 1), box(0.5, 0.25, 0.25, 1.5, 0.75, 0.75))),
    "hole.wkt": lambda: "POLYGON((0 0,1 0,1 1,0 1,0 0),(2 2,3 2,3 3,2 2))\n",
    "repeated.json": lambda: '{"domain":[0,0,0,1,1,1],"edge":0.1,"edge":0.2}\n',
    "misspelt.json": lambda: '{"domain":[0,0,0,1,1,1],"edge":0.2,"time_step":0.1,"end":1,"gravitiy":[0,0,-1],'
                             '"liquids":[{"density":1,"shape":{"type":"pool","level":0.5}}]}\n',
    "unknown.json": lambda: '{"domain":[0,0,0,1,1,1],"edge":0.2,"time_step":0.1,"end":1,'
                            '"surface_tension":[{"labels":[0,7],"value":1}],'
                            '"liquids":[{"density":1,"shape":{"type":"pool","level":0.5}}]}\n',
}

OFFSET = "--distance=.01e --steps 1"
# Command, exit status, regular expression for standard output and standard error together. The status None
# allows 0, 1 and 2.
CHECKS = [
    ("improve fields.vtu -o fields.vtu", 1, r"material.*--labels"),
    ("improve fields.vtu -o out.vtu --labels material", 0, r""),
    ("info out.vtu", 0, r"label 1:"),
    ("offset material.vtu " + OFFSET, 1, r"material.*--labels"),
    ("offset material.vtu --labels material " + OFFSET, 0, r""),
    ("improve jit.mesh -o out.mesh", 0, r""),
    ("offset onevoxel.inr " + OFFSET, None, r"tetrahedra|label"),
    ("offset two_singles.inr " + OFFSET, None, r"tetrahedra|label"),
    ("offset salt3.inr " + OFFSET, None, r"tetrahedra|label"),
    ("offset vox1.inr " + OFFSET, 0, r"tetrahedra"),
    ("offset vox0.001.inr " + OFFSET, 0, r"tetrahedra"),
    ("offset vox0.00001.inr " + OFFSET, 0, r"tetrahedra"),
    ("offset bom.off " + OFFSET, 0, r"tetrahedra"),
    ("offset modelnet.off " + OFFSET, 0, r"tetrahedra"),
    ("info noedges.off", 0, r"triangles +4"),
    ("offset upper.stl " + OFFSET, 0, r"tetrahedra"),
    ("improve m_biglabel64.mesh -o out.mesh", 1, r"3000000000.*2147483647|2147483647.*3000000000|range"),
    ("offset trunc.inr " + OFFSET, 1, r"trunc.inr.*bytes"),
    ("offset tri0.poly " + OFFSET, 0, r"[1-9]\d* interface segments"),
    ("reconstruct terrain.xyz -o out.off", 1, r"open sheet.*--open"),
    ("reconstruct terrain.xyz --open -o out.off", 0, r"triangles"),
    ("offset tjunc.off " + OFFSET, 0, r"tetrahedra"),
    ("offset tjunc.off --repair " + OFFSET, 0, r"tetrahedra"),
    ("offset v60_s16.inr " + OFFSET, 0, r"tetrahedra"),
    ("offset sphere.off " + OFFSET, 0, r"tetrahedra"),
    ("offset g4_0.001.off " + OFFSET, 0, r"tetrahedra"),
    ("offset g4_1e-06.off " + OFFSET, 0, r"tetrahedra"),
    ("offset g5_1e-05.off " + OFFSET, 0, r"tetrahedra"),
    ("offset crossing.off " + OFFSET, 1, r"--repair"),
    ("offset crossing.off --repair " + OFFSET, 0, r"united"),
    ("offset hole.wkt " + OFFSET, 1, r"hole"),
    ("offset '0.2<x<0.8 && 0.2<y<0.8 && 0.2<z<0.8' --domain 0,0,0,1,1,1 --edge .1 " + OFFSET, 0, r"tetrahedra"),
    ("offset 'x=1' --domain 0,0,0,1,1,1 --edge .1 " + OFFSET, 2, r"=="),
    ("advect sphere.off --velocity='x=-y,y=x,z=0' --steps 1", 2, r"=="),
    ("offset 'x^2+y^2+z^2<.0001' --domain -1,-1,-1,1,1,1 --edge .1 " + OFFSET, 1, r"--edge"),
    ("fluid repeated.json", None, r"edge.*twice|twice.*edge|repeated|duplicate"),
    ("fluid misspelt.json", 2, r"gravity"),
    ("fluid unknown.json", None, r"7"),
    ("info sphere.off > /dev/full", 1, r"standard output"),
]


def main():
    program = os.path.abspath(sys.argv[1])
    given = {}
    if len(sys.argv) > 2:
        for place, _, names in os.walk(os.path.abspath(sys.argv[2])):
            given.update({name: os.path.join(place, name) for name in names})
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, make in INPUTS.items():
            data = open(given[name], "rb").read() if name in given else make()
            with open(os.path.join(folder, name), "wb") as out:
                out.write(data if isinstance(data, bytes) else data.encode())
        for words, status, pattern in CHECKS:
            try:
                done = subprocess.run(f"'{program}' {words}", shell=True, cwd=folder, timeout=LONGEST,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                is_right = (done.returncode == status if status is not None
                            else done.returncode in (0, 1, 2)) and re.search(pattern, done.stdout)
                result = f"status {done.returncode}: {done.stdout.strip()}"
            except subprocess.TimeoutExpired:
                is_right, result = False, f"does not end in {LONGEST} s"
            if not is_right:
                failed += 1
                print(f"dsc {words}\n  {result}")
    print(f"{len(CHECKS) - failed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
