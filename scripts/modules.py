#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The packages and modules of the headers: checks their includes, counts their lines, draws them.

Usage: scripts/modules.py check               prints each include that breaks a rule; status 1 if any
       scripts/modules.py table [--write]     checks the tables of CONTRIBUTING.md, or writes them anew
       scripts/modules.py draw OUTPUT.svg     draws packages, modules and the includes between them

The rules:
- The kernel includes no header of another package. Another package includes the kernel only, and the
  packages that PACKAGES names for it.
- No package includes a header from the folder internal/ of another package.
- A module includes only itself and modules above it in the list of its package.
- An internal header of the kernel includes no facade, which is a public header that reads named
  parameters, unless its module comes after LAST_MODULE_BELOW_FACADES.
- Each internal header belongs to a module. A module has at most MAXIMUM_LINES lines.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include" / "CGAL"
CONTRIBUTING = ROOT / "CONTRIBUTING.md"
MAXIMUM_LINES = 2000  # a module that one can read in an afternoon
LAST_MODULE_BELOW_FACADES = "deformation"
ROUNDED_TO = 100  # lines in tables, so that small changes do not alter the tables
KERNEL = "Deformable_simplicial_complexes"
# Package: the other packages that it uses besides the kernel
PACKAGES = {
    KERNEL: (),
    "Interface_flows": (),
    "Solid_reconstruction_3": (),
    "Cut_loci_2": (),
    "Incompressible_fluids_3": (),
}
# The headers at the top of the tree that do not belong to the kernel
PACKAGE_OF_TOP_HEADER = {"Incompressible_fluid_3.h": "Incompressible_fluids_3"}
# The modules of each package in the order of the data flow: a module includes those above it.
MODULES = {
    KERNEL: {
        "bookkeeping": "components, measures of labels, failed operations, marks and numbers of a thread",
        "complex": "storage, numbering, exact changes",
        "traversal": "work lists, vertex numbering, rows of sparse matrices",
        "geometry": "facet normals, overlaps, qualities of triangles",
        "interface": "edges and fans of the interface, curvature, midpoints on smooth surfaces",
        "operations": "triangulations of rings, sandwiches, optimal positions",
        "topology": "links and their labels, relabeling, the log of topology events",
        "motion": "simultaneous motion, untangling, extension of the displacement, collisions",
        "improvement": "mesh operations of each dimension, removal of small angles, mesh improvement",
        "remeshing": "remeshing of the interface, detail control, patches",
        "deformation": "the deformation algorithm",
        "soups": "triangle soups: intersections, splits, regions",
        "checks": "checks of input surfaces and cells, with the errors that they throw",
        "building": "boxes, labels of cells, meshes of the domain",
        "images": "curves between the pixels of an image, triangles between these curves",
        "repair": "repair of surfaces that do not bound solids",
        "conversion": "conversion of labelled images and of meshes of Mesh_3",
        "values": "redistribution of values on cells",
        "text": "files, words, numbers, XML",
        "grids": "VTK and MEDIT files",
        "curves": "files of planar curves",
        "IO": "surface files and checkpoints",
    },
    "Interface_flows": {"paths": "paths of interface vertices in velocity fields"},
    "Solid_reconstruction_3": {
        "clouds": "point clouds: neighbors, local planes, sides",
        "reconstruction": "octree shell, approach to the points, sharp edges, certificate",
    },
    "Cut_loci_2": {"geodesics": "geodesics, their intersections, certificates"},
    "Incompressible_fluids_3": {
        "solvers": "matrices by cells, factorizations, minimal residuals",
        "steps": "mesh, equations, contacts and masses of a time step",
        "fluid": "bookkeeping of liquids and gases, attempts of a step",
    },
}


class Header:
    """A header file, its place among packages and modules, and what it includes."""

    def __init__(self, path):
        parts = path.relative_to(INCLUDE).parts
        self.name = "/".join(parts)
        self.package = (parts[0] if len(parts) > 1 else
                        PACKAGE_OF_TOP_HEADER.get(self.name, KERNEL))
        self.is_internal = "internal" in parts
        after = parts[parts.index("internal") + 1:] if self.is_internal else ()
        self.module = after[0] if len(after) > 1 else None
        text = path.read_text()
        self.lines = text.count("\n")
        self.includes = re.findall(r'^\s*#\s*include\s*[<"]CGAL/([^>"]+)[>"]', text, re.M)
        self.is_facade = (not self.is_internal and
                          f"{KERNEL}/parameter_values.h" in self.includes and
                          not self.name.endswith("Interface_adaptation.h"))


def read_headers():
    return {h.name: h for h in (Header(p) for p in sorted(INCLUDE.rglob("*.h")))}


def broken_rules(headers):
    """One line for each include or header that breaks a rule."""
    size = {}
    for h in headers.values():
        if h.package not in PACKAGES:
            yield f"{h.name} belongs to no known package"
            continue
        modules = list(MODULES[h.package])
        if h.is_internal:
            if h.module not in modules:
                yield f"{h.name} belongs to no known module"
                continue
            size[h.package, h.module] = size.get((h.package, h.module), 0) + h.lines
        for other in (headers[name] for name in h.includes if name in headers):
            if other.package != h.package:
                if other.package not in (KERNEL, *PACKAGES[h.package]) or h.package == KERNEL:
                    yield f"{h.name} includes {other.name} of a package that it must not use"
                if other.is_internal:
                    yield f"{h.name} includes {other.name}, which is internal to its package"
            elif h.is_internal and other.is_internal:
                if other.module in modules and modules.index(other.module) > modules.index(h.module):
                    yield f"{h.name} includes {other.name} of a later module"
            is_below_facades = (h.package == KERNEL and h.is_internal and modules.index(h.module) <=
                                modules.index(LAST_MODULE_BELOW_FACADES))
            if is_below_facades and other.is_facade:
                yield f"{h.name} includes the facade {other.name}"
    for (package, module), lines in size.items():
        if lines > MAXIMUM_LINES:
            yield f"the module {module} of {package} has {lines} lines, more than {MAXIMUM_LINES}"


def rounded(lines):
    return f"{max(1, round(lines / ROUNDED_TO)) * ROUNDED_TO:,}".replace(",", " ")


def tables(headers):
    """The generated tables, by the name of their marker."""
    def count(select):
        chosen = [h for h in headers.values() if select(h)]
        return len(chosen), rounded(sum(h.lines for h in chosen))

    packages = ["| Package | public headers | lines | internal headers | lines |",
                "| --- | ---: | ---: | ---: | ---: |"]
    for name in PACKAGES:
        n, lines = count(lambda h: h.package == name and not h.is_internal)
        m, more = count(lambda h: h.package == name and h.is_internal)
        packages.append(f"| `{name}` | {n} | {lines} | {m} | {more} |")
    modules = ["| Module | lines | content |", "| --- | ---: | --- |"]
    for package, of_package in MODULES.items():
        modules.append(f"| **{package}** | | |")
        for module, content in of_package.items():
            _, lines = count(lambda h: (h.package, h.module) == (package, module))
            modules.append(f"| `{module}` | {lines} | {content} |")
    return {"packages": packages, "modules": modules}


def with_tables(text, headers):
    for name, lines in tables(headers).items():
        marker = re.compile(rf"(<!-- {name} -->\n).*?(<!-- end -->)", re.S)
        if not marker.search(text):
            sys.exit(f"{CONTRIBUTING.name} has no marker <!-- {name} -->")
        text = marker.sub(lambda m: m.group(1) + "\n".join(lines) + "\n" + m.group(2), text)
    return text


def check_tables(headers, write):
    old = CONTRIBUTING.read_text()
    new = with_tables(old, headers)
    if write:
        CONTRIBUTING.write_text(new)
    elif old != new:
        sys.exit(f"the tables of {CONTRIBUTING.name} are out of date: run scripts/modules.py table --write")


# The picture: a column a package, a box a module, as high as its lines need; an arc for each pair of
# modules with includes between them, an arrow from a package to the public headers of the kernel.
COLUMN, BOX, LINE_HEIGHT, GAP, TOP = 300, 190, 18, 8, 60


def draw(headers, path):
    place, parts = {}, []
    for column, (package, modules) in enumerate(MODULES.items()):
        x, y = 20 + column * COLUMN, TOP
        parts.append(f'<text x="{x}" y="{TOP - 20}" class="t">{package}</text>')
        for module in ("public headers", *modules):
            of_module = [h for h in headers.values() if h.package == package and
                         (h.module == module or module == "public headers" and not h.is_internal)]
            lines = sum(h.lines for h in of_module)
            height = LINE_HEIGHT * 2
            fill = "#d8e4f0" if module == "public headers" else "#f0ece0"
            parts.append(f'<rect x="{x}" y="{y}" width="{BOX}" height="{height}" fill="{fill}" stroke="#666"/>'
                         f'<text x="{x + 8}" y="{y + 15}">{module}</text>'
                         f'<text x="{x + 8}" y="{y + 30}" class="n">{len(of_module)} headers, {rounded(lines)} lines</text>')
            place[package, module] = (x, y + height / 2)
            y += height + GAP
    arcs = {}
    for h in headers.values():
        for other in (headers[name] for name in h.includes if name in headers):
            a = (h.package, h.module or "public headers")
            b = (other.package, other.module or "public headers")
            if a != b and a in place and b in place and "public headers" not in (a[1],):
                arcs[a, b] = arcs.get((a, b), 0) + 1
    broken = len(list(broken_rules(headers)))
    for (a, b), n in sorted(arcs.items()):
        (xa, ya), (xb, yb) = place[a], place[b]
        width = min(4, .5 + n / 5)
        if xa == xb and b[1] != "public headers":
            bow = min(90, abs(ya - yb) / 4 + 10)
            parts.append(f'<path d="M{xa + BOX} {ya} C{xa + BOX + bow} {ya} {xb + BOX + bow} {yb} {xb + BOX} {yb}" '
                         f'class="a" stroke-width="{width:.1f}"/>')
        elif xa != xb:
            parts.append(f'<path d="M{xa} {ya} C{xa - 60} {ya} {xb + BOX + 60} {yb} {xb + BOX} {yb}" '
                         f'class="k" stroke-width="{width:.1f}"/>')
    height = max(y for _, y in place.values()) + 60
    width = COLUMN * len(MODULES) + 20
    style = ("text{font:12px sans-serif}.t{font:bold 13px sans-serif}.n{fill:#666;font-size:10px}"
             ".a{fill:none;stroke:#999}.k{fill:none;stroke:#4878b0;opacity:.5}")
    pathlib.Path(path).write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height:.0f}"><style>{style}</style>'
        f'<rect width="100%" height="100%" fill="white"/>{"".join(parts)}'
        f'<text x="20" y="{height - 14:.0f}">{sum(arcs.values())} includes between modules, '
        f'{broken} break a rule. Grey: within a package, upwards. Blue: of the kernel\'s public headers.</text></svg>\n')


def main():
    headers = read_headers()
    command = sys.argv[1] if len(sys.argv) > 1 else ""
    if command == "check":
        broken = list(broken_rules(headers))
        print("\n".join(broken), end="\n" if broken else "")
        sys.exit(bool(broken))
    elif command == "table":
        check_tables(headers, "--write" in sys.argv)
    elif command == "draw" and len(sys.argv) == 3:
        draw(headers, sys.argv[2])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
