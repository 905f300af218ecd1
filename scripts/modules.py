#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the includes of packages and modules, counts their lines, and draws them.

Usage: scripts/modules.py check               prints each include that breaks a rule; status 1 if any
       scripts/modules.py table [--write]     checks or writes the tables of CONTRIBUTING.md
       scripts/modules.py draw OUTPUT.svg     draws packages, modules and the includes between them

The rules:
- The kernel includes no header of another package. Another package includes the kernel only, and the
  packages that PACKAGES names for it.
- No package includes a header from the folder internal/ of another package.
- A module includes only itself and modules above it in the list of its package.
- A facade is a public header that reads named parameters, except headers of options. An internal header of the kernel includes no
  facade, unless its module comes after LAST_MODULE_BELOW_FACADES.
- Each internal header belongs to a module. A module has at most MAXIMUM_LINES lines.
- Each path in backquotes in CONTRIBUTING.md exists, unless it has a placeholder.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include" / "CGAL"
CONTRIBUTING = ROOT / "CONTRIBUTING.md"
MAXIMUM_LINES = 2000  # upper bound for the lines of a module
LAST_MODULE_BELOW_FACADES = "deformation"
ROUNDED_TO = 100  # precision of line counts in tables, so that small changes do not alter the tables
KERNEL = "Deformable_simplicial_complexes"
# Each package with the packages that it uses besides the kernel
PACKAGES = {
    KERNEL: (),
    "Interface_flows": (),
    "Solid_reconstruction_3": (),
    "Cut_loci_2": (),
    "Incompressible_fluids_3": (),
    "Image_segmentation": (),
}
# The headers directly in include/CGAL that do not belong to the kernel
PACKAGE_OF_TOP_HEADER = {
    "Incompressible_fluid_2.h": "Incompressible_fluids_3",
    "Incompressible_fluid_3.h": "Incompressible_fluids_3",
}
# The modules of each package in the order of the data flow: a module includes those above it.
MODULES = {
    KERNEL: {
        "bookkeeping": "components, measures of labels, failed operations, marks and numbers of a thread",
        "complex": "storage, numbering, exact changes",
        "traversal": "work lists, vertex numbering, rows of sparse matrices",
        "geometry": "facet normals, overlaps, qualities of triangles",
        "interface": "edges and fans of the interface, curvature, midpoints on smooth surfaces",
        "operations": "triangulations of rings and of multi-face cavities, optimal positions",
        "motion": "simultaneous motion, untangling, extension of the displacement, collisions",
        "balance": "contacts, swept volumes, bounds on the volumes that operations move",
        "topology": "links and their labels, relabeling, the log of topology events",
        "improvement": "mesh operations of each dimension, removal of small angles, mesh improvement",
        "remeshing": "remeshing of the interface, detail control, patches",
        "deformation": "the deformation algorithm",
        "soups": "triangle soups: intersections, splits, regions",
        "checks": "checks of input surfaces and cells, with the errors that they throw",
        "building": "boxes, labels of cells, meshes of the domain",
        "fitting": "places where the label given by a function changes, volumes that facets miss",
        "images": "curves between the pixels of an image, triangles between these curves",
        "repair": "repair of surfaces that do not bound solids",
        "conversion": "conversion of labelled images and of meshes of Mesh_3",
        "values": "redistribution of values on cells",
        "text": "files, words, numbers, XML",
        "grids": "VTK and MEDIT files",
        "curves": "files of planar curves",
        "IO": "surface files and checkpoints",
        "ranks": "pieces of complexes on several ranks, messages, components, checkpoints",
        "patches": "patches that are treated in rounds, adaptation of a distributed interface",
        "distributed_motion": "the deformation algorithm on several ranks",
    },
    "Interface_flows": {
        "corners": "corners and edges of fronts: arcs, cylinders, and vertices that corners pass",
        "paths": "paths of interface vertices in velocity fields",
        "curvature": "forces and masses of an interface energy, the system of an implicit step",
    },
    "Solid_reconstruction_3": {
        "clouds": "point clouds: neighbors, local planes, sides",
        "reconstruction": "octree shell, approach to the points, sharp edges, checks of the result",
    },
    "Cut_loci_2": {"geodesics": "geodesics, their intersections, checks of cut loci"},
    "Incompressible_fluids_3": {
        "solvers": "matrices by cells, factorizations, minimal residuals",
        "parallel": "systems of several processes, with PETSc",
        "mesh": "vertices and cells of liquids, their masses, liquids that slip along each other",
        "sides": "flow through sides of the domain, and along them",
        "walls": "contacts with solids, constrained velocities, volume constraints at walls",
        "steps": "the equations and the solution of a time step",
        "fluid": "bookkeeping of liquids and gases, attempts of a step",
    },
    "Image_segmentation": {
        "moments": "integrals of images over cells",
        "segmentation": "costs of cells, motion of the interface, levels of refinement",
    },
}


class Header:
    """A header file with its package, its module and its includes."""

    def __init__(self, path):
        parts = path.relative_to(INCLUDE).parts
        self.name = "/".join(parts)
        if parts[0] == "license":  # license/PACKAGE.h
            self.package = path.stem
        else:
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
                          not self.name.endswith(("_options.h", "Interface_adaptation.h")))


def read_headers():
    return {h.name: h for h in (Header(p) for p in sorted(INCLUDE.rglob("*.h")))}


def broken_rules(headers):
    """Yields a line for each include or header that breaks a rule."""
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


def missing_paths():
    """Yields a line for each path in CONTRIBUTING.md that does not exist."""
    for path in sorted(set(re.findall(r"`([\w.]+/[\w./-]*)[ `]", CONTRIBUTING.read_text()))):
        if re.search(r"\b(NAME|PACKAGE|MODULE|NAME_\w+)\b", path):
            continue
        name = path.replace("KERNEL/", f"include/CGAL/{KERNEL}/")
        if not any((folder / name).exists() for folder in (ROOT, ROOT / "src/compiled/include/CGAL")):
            yield f"{CONTRIBUTING.name} names {path}, which does not exist"


def rounded(lines):
    return f"{max(1, round(lines / ROUNDED_TO)) * ROUNDED_TO:,}".replace(",", " ")


def tables(headers):
    """Returns the generated tables by the names of their markers."""
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


# The picture shows the packages on top, with their modules and the number of kernel headers that they
# include. Below is the kernel with a matrix of its modules. An entry is the number of includes of the
# module of its row from the module of its column. All entries are below the diagonal if the rules hold.
CELL, MARGIN, LABEL = 24, 20, 300
STYLE = ("text{font:13px sans-serif}.t{font-weight:bold;font-size:14px}.n{fill:#555;font-size:11px}"
         ".m{text-anchor:middle;font-size:12px}.p{fill:#eef3f8;stroke:#4878a0}.w{fill:white;stroke:#999}"
         ".d{fill:#888}.g{stroke:#ddd}.a{stroke:#4878a0;stroke-width:2;fill:none;marker-end:url(#h)}")
ARROW = ('<defs><marker id="h" markerWidth="8" markerHeight="8" refX="6" refY="3" orient="auto">'
         '<path d="M0 0L6 3L0 6z" fill="#4878a0"/></marker></defs>')


def text(x, y, words, style=""):
    return f'<text x="{x:.0f}" y="{y:.0f}" class="{style}">{words}</text>'


def box(x, y, width, height, style):
    return f'<rect x="{x:.0f}" y="{y:.0f}" width="{width:.0f}" height="{height:.0f}" class="{style}"/>'


def size_of(chosen):
    return f"{len(chosen)} headers, {rounded(sum(h.lines for h in chosen))} lines"


def draw_package(headers, name, x, y, width, height):
    """Yields the box of a package other than the kernel, and its arrow to the kernel."""
    mine = [h for h in headers.values() if h.package == name]
    yield box(x, y, width, height, "p") + text(x + 10, y + 22, name, "t")
    yield text(x + 10, y + 42, "public: " + size_of([h for h in mine if not h.is_internal]), "n")
    for i, module in enumerate(MODULES[name]):
        top = y + 56 + 46 * i
        yield box(x + 10, top, width - 20, 40, "w") + text(x + 20, top + 17, module)
        yield text(x + 20, top + 33, size_of([h for h in mine if h.module == module]), "n")
    used = {other for h in mine for other in h.includes
            if other in headers and headers[other].package == KERNEL}
    yield f'<path d="M{x + 30} {y + height}v44" class="a"/>'
    yield text(x + 40, y + height + 27, f"uses {len(used)} public headers", "n")


def draw_kernel(headers, x, y, width):
    """Yields the box of the kernel with the matrix of its modules."""
    mine = [h for h in headers.values() if h.package == KERNEL]
    modules = list(MODULES[KERNEL])
    top, left = y + 106, x + 10 + LABEL
    yield box(x, y, width, 106 + CELL * len(modules) + 44, "p")
    yield text(x + 10, y + 22, f"{KERNEL} (the kernel)", "t")
    yield box(x + 10, y + 34, width - 20, 30, "w")
    yield text(x + 20, y + 54, "public: " + size_of([h for h in mine if not h.is_internal]))
    yield text(x + 10, top - 8, "internal modules, in the order of the data flow", "n")
    for i, module in enumerate(modules):
        row, of_module = top + CELL * i, [h for h in mine if h.module == module]
        yield box(x + 10, row, LABEL + CELL * len(modules), CELL, "w")
        yield text(x + 16, row + 17, f"{i + 1}&#160;&#160;{module}")
        yield text(x + 140, row + 17, size_of(of_module), "n")
        yield text(left + CELL * (i + .5), top - 8, i + 1, "m") + box(left + CELL * i, row, CELL, CELL, "d")
        yield f'<path d="M{left + CELL * i} {top}v{CELL * len(modules)}" class="g"/>'
        for j, other in enumerate(modules):
            n = sum(name in headers and headers[name].package == KERNEL and headers[name].module == other
                    for h in of_module for name in h.includes)
            if n and i != j:
                fill = "#e06060" if j > i else f"rgb({max(120, 215 - 8 * n)},{max(170, 228 - 5 * n)},240)"
                yield (f'<rect x="{left + CELL * j}" y="{row}" width="{CELL}" height="{CELL}" fill="{fill}"/>'
                       + text(left + CELL * (j + .5), row + 17, n, "m"))
    broken = len(list(broken_rules(headers)))
    yield text(x + 10, top + CELL * len(modules) + 28,
               "A number counts the includes of the module of the row from the module of the column. "
               f"Includes that break a rule: {broken}.", "n")


def draw(headers, path):
    others = [name for name in PACKAGES if name != KERNEL]
    width = LABEL + CELL * len(MODULES[KERNEL]) + 20
    of_package = (width - 12 * (len(others) - 1)) / len(others)
    height = 60 + 46 * max(len(MODULES[name]) for name in others)
    parts = [part for i, name in enumerate(others) for part in draw_package(
        headers, name, round(MARGIN + i * (of_package + 12)), MARGIN, round(of_package), height)]
    parts += draw_kernel(headers, MARGIN, MARGIN + height + 50, width)
    total = 2 * MARGIN + height + 50 + 150 + CELL * len(MODULES[KERNEL])
    pathlib.Path(path).write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width + 2 * MARGIN}" height="{total}">\n'
        f'<style>{STYLE}</style>{ARROW}\n<rect width="100%" height="100%" fill="white"/>\n'
        + "\n".join(parts) + "\n</svg>\n")


def main():
    headers = read_headers()
    command = sys.argv[1] if len(sys.argv) > 1 else ""
    if command == "check":
        broken = [*broken_rules(headers), *missing_paths()]
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
