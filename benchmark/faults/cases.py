"""Small runs of each command of the program: inputs, results of an earlier run, and the run that a fault meets."""
import dataclasses
import json
import math
import pathlib

EDGES = "--edge-per-thickness 0 --threads 1 --quiet"


@dataclasses.dataclass
class Case:
    name: str
    run: str  # arguments of the run
    before: list = dataclasses.field(default_factory=list)  # runs whose results exist before the run
    prefix: list = dataclasses.field(default_factory=list)  # such as mpirun
    python: bool = False  # `run` is a Python program
    slow: bool = False  # it takes a second, so that it meets fewer faults


def write_inputs(folder):
    """Writes the inputs of all cases."""
    folder = pathlib.Path(folder)
    spiral = []
    for i in range(120):
        z = 1 - (2 * i + 1) / 120
        r, a = math.sqrt(1 - z * z), 2.399963 * i
        spiral.append(f"{r * math.cos(a)} {r * math.sin(a)} {z}\n")
    disk = bytes(200 if (x - 12) ** 2 + (y - 12) ** 2 < 40 else 50 for y in range(24) for x in range(24))
    ball = bytes(
        int((x - 6) ** 2 + (y - 6) ** 2 + (z - 6) ** 2 < 14) for z in range(12) for y in range(12) for x in range(12)
    )
    header = "#INRIMAGE-4#{\nXDIM=12\nYDIM=12\nZDIM=12\nVDIM=1\nVX=1\nVY=1\nVZ=1\n"
    header += "TYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\n"
    scene = {"density": 1}, {"surface_tension": 1, "interface_tolerance": 0, "time_step": 0.01, "end": 1}
    texts = {
        **many_solids(),
        "tet.off": "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
        "octahedron.off": "OFF\n6 8 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n"
        + "".join(f"3 {i} {(i + 1) % 4} 4\n3 {(i + 1) % 4} {i} 5\n" for i in range(4)),
        "square.wkt": "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n",
        "many.xyz": "".join(f"{i} {j} {0.1 * math.sin(i * j)}\n" for i in range(25) for j in range(25)),
        "many.wkt": "".join(f"POLYGON (({i} 0, {i}.5 0, {i}.5 1, {i} 1, {i} 0))\n" for i in range(400)),
        "many.pgm": b"P5\n160 160\n255\n" + bytes(1 + (x // 40) % 2 for y in range(160) for x in range(160)),
        "points.xyz": "".join(spiral),
        "sheet.xyz": "".join(f"{i} {j} {0.1 * math.sin(i * j)}\n" for i in range(8) for j in range(8)),
        "disk.pgm": b"P5\n24 24\n255\n" + disk,
        "ball.inr": (header + "\n" * (252 - len(header)) + "##}\n").encode() + ball,
    }
    for dimension, edge, more in (2, 0.6, {}), (3, 1, {"triangles": 80}):
        shape = {"type": "ball", "center": [0] * dimension, "radius": 1, **more}
        texts[f"drop{dimension}.json"] = json.dumps(
            {
                "title": "a drop",
                "domain": [-2] * dimension + [2] * dimension,
                "edge": edge,
                "liquids": [{"shape": shape, **scene[0]}],
                **scene[1],
            }
        )
    for name, text in texts.items():
        (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())


def flow(name, arguments, options="", resumed=True):
    """Returns cases of a new run and of a run that continues it in its folder."""
    results, options = f"--output o {options}", options.replace("--subdivide 1", "")
    new = f"{name} {arguments} --steps 2 {results} {EDGES}"
    cases = [Case(name, new, [f"{name} {arguments} --steps 1 {options} {EDGES}"] if options else [])]
    if resumed:
        again = f"{name} --resume o/checkpoint.dsc --steps 1 {results} --threads 1 --quiet"
        cases.append(Case(f"{name} --resume", again, [new]))
    return cases


def one(name, run, older=None):
    """Returns a case that replaces the results of a similar run."""
    return Case(name, run, [older or run])


def slow(case):
    return dataclasses.replace(case, slow=True)


def many_solids():
    """Returns 300 tetrahedra as OFF, OBJ and STL. They exceed the buffers of streams."""
    points, facets = [], []
    for i in range(300):
        points += [(2 * i, 0, 0), (2 * i + 1, 0, 0), (2 * i, 1, 0), (2 * i, 0, 1)]
        facets += [tuple(4 * i + j for j in f) for f in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))]
    lines = [" ".join(map(str, p)) for p in points]
    corners = "\n".join("3 " + " ".join(map(str, f)) for f in facets)
    counts = f"element vertex {len(points)}\n" + "".join(f"property double {c}\n" for c in "xyz")
    counts += f"element face {len(facets)}\nproperty list uchar int vertex_indices\nend_header\n"
    return {
        "many.off": f"OFF\n{len(points)} {len(facets)} 0\n" + "\n".join(lines) + f"\n{corners}\n",
        "many.ply": "ply\nformat ascii 1.0\n" + counts + "\n".join(lines) + f"\n{corners}\n",
        "many.obj": "".join(f"v {p}\n" for p in lines)
        + "".join("f " + " ".join(str(v + 1) for v in f) + "\n" for f in facets),
        "many.stl": "solid a\n"
        + "".join(
            "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {lines[v]}\n" for v in f) + "endloop\nendfacet\n"
            for f in facets
        )
        + "endsolid a\n",
    }


def readers():
    """Returns cases that read files which exceed the buffers of streams."""
    cases = [Case(f"info many.{e}", f"info many.{e}") for e in ("off", "obj", "ply", "stl", "wkt", "pgm")]
    offset = "offset ball.inr --distance 0.1 --steps 1 --output many --threads 1 --quiet"
    cases += [Case(f"info {name}", f"info many/{name}", [offset]) for name in ("checkpoint.dsc", "volume_000000.vtu")]
    cases.append(Case("reconstruct many.xyz", "reconstruct many.xyz --open -o k.ply --quiet"))
    return cases


def conversions():
    make = f"offset tet.off --distance 0.01 --steps 1 --output made {EDGES}"
    cells = "convert made/checkpoint.dsc cells.vtu --quiet"
    planar = f"mean-curvature square.wkt --dt 0.001 --steps 1 --output plane {EDGES}"
    cases = []
    for source, first, extensions in (
        ("made/checkpoint.dsc", [make], ["off", "obj", "ply", "stl", "vtu", "mesh", "png"]),
        ("plane/checkpoint.dsc", [planar], ["wkt", "poly", "svg"]),
        ("cells.vtu", [make, cells], ["vtk"]),
        ("tet.off", [], ["vtp"]),
        ("ball.inr", [], ["nii.gz", "vti", "mha", "tif", "inr"]),
    ):
        for extension in extensions:
            run = f"convert {source} result.{extension} --quiet"
            cases.append(Case(f"convert {extension}", run, [*first, run], slow=extension == "png"))
    translated = "convert ball.inr ball.nii.gz --quiet"
    cases += [
        Case("info", "info made/checkpoint.dsc", [make]),
        Case("info nii.gz", "info ball.nii.gz", [translated]),
        Case("convert from nii.gz", "convert ball.nii.gz result.inr --quiet", [translated]),
        *readers(),
        Case("improve", "improve cells.vtu -o better.mesh --report better.json --threads 1 --quiet",
             [make, cells, "improve cells.vtu -o better.mesh --report better.json --threads 1 --quiet"]),
        Case("improve in place", "improve cells.vtu -o cells.vtu --threads 1 --quiet", [make, cells]),
        Case("view", "view made -o page.html --quiet", [make, "view made -o page.html --surface --quiet"]),
    ]
    return cases


def all_cases(python=None):
    """Returns the cases; those of the Python module only if `python` is its folder."""
    offset = "tet.off --distance 0.01"
    segment = "-o s.vtu -o s.dsc --threads 1 --quiet"
    grains, pictures = "--edges 5 --threads 1 --quiet", "--picture p.svg --plot d.svg"
    cut = "cut-locus --point 0,0.3 --spacing 0.3"
    reconstruct = "reconstruct points.xyz -o k.off --report k.json --threads 1 --quiet"
    cases = [
        *flow("offset", offset, "--report r.json"),
        *flow("mean-curvature", "square.wkt --dt 0.001", "--report r.json"),
        *flow("advect", f"{offset[:7]} --velocity=-y,x,0", "--subdivide 1 --report r.json"),
        slow(*flow("rotate", "tet.off --angle 10 --axis 0,0,1", "--picture p.png", resumed=False)),
        *flow("zalesak", "", resumed=False),
        *conversions(),
        one("segment", f"segment disk.pgm -o s.png -o s.svg --picture p.png --report r.json {segment}"),
        one("segment in space", f"segment ball.inr -o s.off -o s.nii.gz --mesh m.vtu {segment}"),
        Case("grains", f"grains --number 8 --steps 2 --every 1 --output o {pictures} --report r.json {grains}",
             [f"grains --number 8 --steps 1 {pictures} --report r.json {grains}"]),
        Case("grains --resume", "grains --resume o/checkpoint.dsc --steps 1 --output o2 --threads 1 --quiet",
             [f"grains --number 8 --steps 2 --output o {grains}"]),
        slow(one("cut-locus", f"{cut} -o c.svg --report c.json --quiet")),
        one("cut-locus --radius", f"{cut} --radius 3 -o c.vtu --quiet"),
        Case("reconstruct", reconstruct + " --output o", [reconstruct]),
        one("reconstruct --open", "reconstruct sheet.xyz --open -o k.ply --report k.json --quiet"),
    ]
    for dimension, picture in (2, "--picture p.svg"), (3, ""):
        options = f"--output o --report r.json {picture} --threads 1 --quiet"
        first = f"fluid drop{dimension}.json --steps 2 {options}"
        cases += [
            Case(f"fluid {dimension}", first, [first.replace("--output o ", "").replace("--steps 2", "--steps 1")]),
            Case(f"fluid {dimension} --resume", f"fluid --resume o/checkpoint.dsc --steps 1 {options}", [first]),
        ]
    mpirun = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2"]
    of_two = f"offset {offset} --steps 1 --output o --report r.json {EDGES}"
    cases.append(Case("offset of 2 processes", of_two, prefix=mpirun))
    if python:
        cases += python_cases()
    return cases


def python_cases():
    make = """
import dsc
c = dsc.Complex2.from_polygons([[[(0, 0), (1, 0), (1, {0}), (0, 1)]]], box=[(-1, -1), (2, 2)])
film = dsc.Film()
film.add(c)
c.save('c.dsc')
film.save('page.html')
"""
    return [Case("Python: save", make.format(1), [make.format(0.5)], python=True, slow=True)]
