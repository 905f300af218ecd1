#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the includes of packages and modules, counts their lines, and draws them.

Usage: scripts/modules.py check               prints each include that breaks a rule; status 1 if any
       scripts/modules.py table [--write]     checks or writes the tables of CONTRIBUTING.md
       scripts/modules.py draw OUTPUT.svg     draws packages, modules and the includes between them

The rules:
- A package includes only itself and the packages that PACKAGES names for it.
- A header in a folder internal/ belongs to its package. Other packages, the program, the Python module
  and the benchmarks include it only if SEAM names it.
- A module includes only itself and modules above it in the list of its package.
- The kernel consists of three parts: complex, operations, deformation. PART_OF_MODULE and
  PART_OF_HEADER name the part of each header. A part includes only itself and parts above it.
- A facade is a public header that reads named parameters, except headers of options. An internal header of
  the kernel includes no facade.
- Each internal header belongs to a module. A module has at most MAXIMUM_LINES lines.
- All packages share the namespace internal, so a class has its name in one package only.
- Each path in backquotes in CONTRIBUTING.md exists, unless it has a placeholder.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include" / "CGAL"
CONTRIBUTING = ROOT / "CONTRIBUTING.md"
MAXIMUM_LINES = 2000  # upper bound for the lines of a module
ROUNDED_TO = 100  # precision of line counts in tables, so that small changes do not alter the tables
KERNEL = "Deformable_simplicial_complexes"
SUPPORT = "Mesh_support"
# The packages in order, each with the packages that it uses
PACKAGES = {
    SUPPORT: (),
    KERNEL: (SUPPORT,),
    "Interface_remeshing": (SUPPORT, KERNEL),
    "Triangle_soup_repair": (SUPPORT,),
    "Complex_construction": (SUPPORT, KERNEL, "Interface_remeshing", "Triangle_soup_repair"),
    "Mesh_files": (SUPPORT, KERNEL, "Interface_remeshing", "Triangle_soup_repair", "Complex_construction"),
    "Interface_flows": (SUPPORT, KERNEL, "Interface_remeshing", "Complex_construction"),
    "Distributed_complexes": (SUPPORT, KERNEL, "Interface_remeshing", "Mesh_files", "Interface_flows"),
    "Solid_reconstruction_3": (SUPPORT, KERNEL, "Interface_remeshing", "Complex_construction"),
    "Cut_loci_2": (SUPPORT, KERNEL, "Interface_remeshing", "Complex_construction", "Mesh_files"),
    "Incompressible_fluids_3": (SUPPORT, KERNEL, "Interface_remeshing"),
    "Image_segmentation": (SUPPORT, KERNEL, "Interface_remeshing", "Complex_construction"),
}
# The headers directly in include/CGAL that do not belong to the kernel
PACKAGE_OF_TOP_HEADER = {
    "Conforming_tetrahedralizer_3.h": "Complex_construction",
    "Tetgen_tetrahedralizer_3.h": "Complex_construction",
    "Incompressible_fluid_2.h": "Incompressible_fluids_3",
    "Incompressible_fluid_3.h": "Incompressible_fluids_3",
}
# The modules of each package in the order of the data flow: a module includes those above it.
MODULES = {
    SUPPORT: {
        "cgal": "differences between versions of CGAL",
        "sets": "disjoint sets",
        "numbers": "extents, rows of sparse matrices, conjugate gradients",
        "threads": "tables of a thread, checks of progress, times, sorting that can be stopped",
    },
    KERNEL: {
        "arguments": "checks of the template arguments of a complex",
        "bookkeeping": "numbers of items and vertices, measures of labels, failed operations, marks of a thread",
        "components": "connected components of labels",
        "complex": "storage, numbering, exact changes",
        "parts": "complexes of given cells whose union has any shape",
        "traversal": "work lists, corners of cells, unions of stars, local lengths, finite elements",
        "operations": "triangulations of rings, optimal positions, qualities of triangles",
        "interface": "edges and fans of the interface, changes of its facets",
        "destinations": "destinations, contacts, bounds on the volumes that operations move",
        "proposals": "mesh operations: proposals and their commits",
        "improvement": "mesh operations of each dimension, mesh improvement",
        "motion": "simultaneous motion, extension of the displacement, collisions, swept volumes",
        "topology": "links and their labels, relabeling, the log of topology events",
        "deformation": "the deformation algorithm, removal of small angles",
    },
    "Interface_remeshing": {
        "interface": "curvature, bends, midpoints on smooth surfaces",
        "remeshing": "remeshing of the interface, detail control",
        "patches": "aggressive improvement of patches of cells",
        "extraction": "triangles of the interface, subdivision",
        "values": "redistribution of values on cells",
    },
    "Triangle_soup_repair": {
        "soups": "triangle soups: intersections, bisection, regions",
        "checks": "checks of input surfaces, with the errors that they throw",
        "arrangement": "solids that touch or overlap: welds, splits, the solids around each region",
        "repair": "repair of surfaces that do not bound solids",
    },
    "Complex_construction": {
        "thin_parts": "thicknesses, improvement of new meshes",
        "building": "boxes, labels of cells, meshes of the domain",
        "fitting": "places where the label given by a function changes, volumes that facets miss",
        "images": "curves between the pixels of an image, triangles between these curves",
        "conversion": "conversion of labeled images and of meshes of Mesh_3",
    },
    "Mesh_files": {
        "text": "files, words, numbers, XML",
        "pictures": "colors of labels and of numbers",
        "grids": "VTK and MEDIT files",
        "curves": "files of planar curves",
        "surfaces": "surface files",
        "checkpoints": "checkpoints",
    },
    "Distributed_complexes": {
        "ranks": "pieces of complexes on several ranks, messages, components",
        "patches": "patches that are treated in rounds, adaptation of a distributed interface",
        "motion": "the deformation algorithm on several ranks",
    },
    "Interface_flows": {
        "corners": "corners and edges of fronts: arcs, cylinders, and vertices that corners pass",
        "paths": "paths of interface vertices in velocity fields",
        "curvature": "forces and masses of an interface energy, the system of an implicit step",
    },
    "Solid_reconstruction_3": {
        "clouds": "point clouds: neighbors, local planes, sides",
        "reconstruction": "octree shell, approach to the points, sharp edges, checks of the result",
        "sheets": "advancing front, seams and checks of sheets",
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
# The internal headers that other packages, the program, the Python module and the benchmarks may include
SEAM = {
    KERNEL: """
        destinations/Destinations destinations/Interface_tolerance bookkeeping/Failure_memory bookkeeping/Label_totals
        bookkeeping/Vertex_numbers traversal/Linear_element traversal/star_union
        complex/apply_to_corners complex/assemble_triangulation
        complex/hilbert_order bookkeeping/sort_by_time_stamp improvement/Mesh_improver
        improvement/Mesh_operations interface/Changed_facets
        interface/Interface_fan motion/Harmonic_extension operations/triangle_quality parts/assign_part
        topology/Manifold_relabeling
        traversal/Domain_box bookkeeping/Marks
        traversal/Work_list traversal/cell_corners traversal/local_edge_length""",
    "Interface_remeshing": """
        extraction/Extracted_facets interface/Curvature_lengths
        remeshing/Detail_controller values/overlap_measure""",
    "Triangle_soup_repair": """
        checks/check_surfaces_3 soups/Soup_bisector_3 soups/Soup_regions_3 soups/Triangle_soup_3
        soups/soup_intersections_3""",
    "Complex_construction": "building/points_in_space_3",
    "Mesh_files": """
        checkpoints/checkpoint_file grids/Vtu_document grids/Written_vertices grids/read_vtu_tetrahedra grids/write_vtu pictures/colors text/Xml_element
        text/files text/number_of_word""",
    "Interface_flows": """
        curvature/Interface_forces paths/interface_paths paths/velocity_properties""",
}
# The parts of the kernel in order, with their modules and public headers
PARTS = ("complex", "operations", "deformation")
PART_OF_MODULE = {
    "arguments": "complex", "bookkeeping": "complex", "components": "complex", "complex": "complex", "parts": "complex", "traversal": "complex",
    "interface": "operations", "operations": "operations", "destinations": "operations", "proposals": "operations", "improvement": "operations",
    "motion": "deformation", "topology": "deformation", "deformation": "deformation",
}
PUBLIC_OF_PART = {
    "complex": """
        Cavity Deformable_simplicial_complex_2 Deformable_simplicial_complex_3 Deformation_visitor Interface_snapshot
        Labeled_complex domains quality_measures simplex_bases State""",
    "operations": "Deformation_report Interface_energy mesh_operations",
    "deformation": "Deformation_options deform_interface",
}


class Header:
    """A header file with its package, its module and its includes."""

    def __init__(self, path):
        parts = path.relative_to(INCLUDE).parts
        self.name = "/".join(parts)
        self.package = parts[0] if len(parts) > 1 else PACKAGE_OF_TOP_HEADER.get(self.name, KERNEL)
        self.is_internal = "internal" in parts
        after = parts[parts.index("internal") + 1:] if self.is_internal else ()
        self.module = after[0] if len(after) > 1 else None
        self.is_open = not self.is_internal or self.package == SUPPORT or "/".join(after)[:-2] in SEAM.get(
            self.package, "").split()
        text = path.read_text()
        self.lines = text.count("\n")
        self.includes = includes_of(text)
        self.is_facade = (not self.is_internal and
                          f"{SUPPORT}/named_parameters.h" in self.includes and
                          not self.name.endswith(("_options.h", "Interface_adaptation.h")))

    def part(self):
        """Returns the part of a header of the kernel; None if it has none."""
        if self.is_internal:
            return PART_OF_MODULE.get(self.module)
        name = self.name.rsplit("/", 1)[-1][:-2]
        return next((part for part in PARTS if name in PUBLIC_OF_PART[part].split()), None)


def includes_of(text):
    return re.findall(r'^\s*#\s*include\s*[<"]CGAL/([^>"]+)[>"]', text, re.M)


def read_headers():
    return {h.name: h for h in (Header(p) for p in sorted(INCLUDE.rglob("*.h")))}


def broken_by(h, other):
    """Yields a line for each rule that the include of another header breaks."""
    if other.package != h.package:
        if other.package not in PACKAGES[h.package]:
            yield f"{h.name} includes {other.name} of a package that it must not use"
        if not other.is_open:
            yield f"{h.name} includes {other.name}, which is internal to its package"
    elif h.package == KERNEL:
        if other.part() and PARTS.index(other.part()) > PARTS.index(h.part()):
            yield f"{h.name}, part {h.part()}, includes {other.name}, part {other.part()}"
    if other.package == h.package and h.is_internal and other.is_internal:
        modules = list(MODULES[h.package])
        if other.module in modules and modules.index(other.module) > modules.index(h.module):
            yield f"{h.name} includes {other.name} of a later module"
    if h.package == KERNEL and h.is_internal and other.is_facade:
        yield f"{h.name} includes the facade {other.name}"


def broken_rules(headers):
    """Yields a line for each include or header that breaks a rule."""
    size = {}
    for h in headers.values():
        if h.package not in PACKAGES:
            yield f"{h.name} belongs to no known package"
            continue
        if h.is_internal:
            if h.module not in MODULES[h.package]:
                yield f"{h.name} belongs to no known module"
                continue
            size[h.package, h.module] = size.get((h.package, h.module), 0) + h.lines
        if h.package == KERNEL and h.part() is None:
            yield f"{h.name} belongs to no part of the kernel"
            continue
        for name in h.includes:
            if name in headers:
                yield from broken_by(h, headers[name])
    for (package, module), lines in size.items():
        if lines > MAXIMUM_LINES:
            yield f"the module {module} of {package} has {lines} lines, more than {MAXIMUM_LINES}"
    for package, names in SEAM.items():
        for name in names.split():
            if f"{package}/internal/{name}.h" not in headers:
                yield f"SEAM names {package}/internal/{name}.h, which does not exist"
    for folder in ("src", "python", "benchmark", "examples"):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp") or "compiled" in path.parts:  # the component is a part of the library
                continue
            for name in includes_of(path.read_text()):
                if name in headers and not headers[name].is_open:
                    yield f"{path.relative_to(ROOT)} includes {name}, which is internal to its package"


def shared_names():
    """Yields a line for each class that two packages define: programs with both would be undefined."""
    owners = {}
    for path in sorted(INCLUDE.rglob("*.h")):
        package = path.relative_to(INCLUDE).parts[0]
        for name in re.findall(r"^(?:template <[^{;]*?>\s*)?(?:class|struct|enum class) (\w+)[^;{]*\{",
                               path.read_text(), re.M):
            owners.setdefault(name, set()).add(package)
    for name, packages in sorted(owners.items()):
        if len(packages) > 1:
            yield f"{name} is a class of the packages {', '.join(sorted(packages))}"


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
        for part in PARTS if name == KERNEL else ():
            n, lines = count(lambda h: h.package == KERNEL and not h.is_internal and h.part() == part)
            m, more = count(lambda h: h.package == KERNEL and h.is_internal and h.part() == part)
            packages.append(f"| – {part} | {n} | {lines} | {m} | {more} |")
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


# The picture shows a matrix of the packages, and below it a matrix of the modules of the kernel. An entry is
# the number of includes of the headers of its row from those of its column. All entries are below the
# diagonal if the rules hold.
CELL, MARGIN, LABEL = 24, 20, 400
STYLE = ("text{font:13px sans-serif}.t{font-weight:bold;font-size:14px}.n{fill:#555;font-size:11px}"
         ".m{text-anchor:middle;font-size:12px}.p{fill:#eef3f8;stroke:#4878a0}.w{fill:white;stroke:#999}"
         ".d{fill:#888}.g{stroke:#ddd}")


def text(x, y, words, style=""):
    return f'<text x="{x:.0f}" y="{y:.0f}" class="{style}">{words}</text>'


def box(x, y, width, height, style):
    return f'<rect x="{x:.0f}" y="{y:.0f}" width="{width:.0f}" height="{height:.0f}" class="{style}"/>'


def size_of(chosen):
    return f"{len(chosen)} headers, {rounded(sum(h.lines for h in chosen))} lines"


def draw_matrix(title, groups, x, y, width):
    """Yields the matrix of groups of headers, given by their names."""
    group_of = {h.name: name for name, chosen in groups.items() for h in chosen}
    top, left = y + 60, x + 10 + LABEL
    yield box(x, y, width, 70 + CELL * len(groups), "p")
    yield text(x + 10, y + 22, title, "t")
    for i, (name, chosen) in enumerate(groups.items()):
        row = top + CELL * i
        yield box(x + 10, row, LABEL + CELL * len(groups), CELL, "w")
        yield text(x + 16, row + 17, f"{i + 1}&#160;&#160;{name}")
        yield text(x + 260, row + 17, size_of(chosen), "n")
        yield text(left + CELL * (i + .5), top - 8, i + 1, "m") + box(left + CELL * i, row, CELL, CELL, "d")
        yield f'<path d="M{left + CELL * i} {top}v{CELL * len(groups)}" class="g"/>'
        for j, other in enumerate(groups):
            n = sum(group_of.get(include) == other for h in chosen for include in h.includes)
            if n and i != j:
                fill = "#e06060" if j > i else f"rgb({max(120, 215 - 8 * n)},{max(170, 228 - 5 * n)},240)"
                yield (f'<rect x="{left + CELL * j}" y="{row}" width="{CELL}" height="{CELL}" fill="{fill}"/>'
                       + text(left + CELL * (j + .5), row + 17, n, "m"))


def draw(headers, path):
    packages = {name: [h for h in headers.values() if h.package == name]
                for name in PACKAGES}
    modules = {name: [h for h in packages[KERNEL] if h.module == name] for name in MODULES[KERNEL]}
    width = 20 + LABEL + CELL * max(len(packages), len(modules))
    below = MARGIN + 90 + CELL * len(packages)
    end = below + 110 + CELL * len(modules)
    parts = [*draw_matrix("Packages", packages, MARGIN, MARGIN, width),
             *draw_matrix(f"Internal modules of the kernel, {KERNEL}", modules, MARGIN, below, width),
             text(MARGIN, end - MARGIN,
                  "A number counts the includes of the headers of the row from those of the column. "
                  f"Includes that break a rule: {len(list(broken_rules(headers)))}.", "n")]
    pathlib.Path(path).write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width + 2 * MARGIN}" height="{end}">\n'
        f'<style>{STYLE}</style>\n<rect width="100%" height="100%" fill="white"/>\n'
        + "\n".join(parts) + "\n</svg>\n")


def main():
    headers = read_headers()
    command = sys.argv[1] if len(sys.argv) > 1 else ""
    if command == "check":
        broken = [*broken_rules(headers), *shared_names(), *missing_paths()]
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
