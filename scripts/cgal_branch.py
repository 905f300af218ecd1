#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies packages into a folder that is laid out as the source repository of CGAL.

Usage: scripts/cgal_branch.py OUTPUT [PACKAGE...]   copies packages, by default those of KERNEL
       scripts/cgal_branch.py check [OUTPUT]        checks the form of such a folder, or of a temporary one;
                                                    status 1 if it is wrong

OUTPUT is a new folder, or the root of a working copy of CGAL. A package gets the folders include, doc,
examples, demo, test and package_info. Its files change as follows:
- Headers get the line "This file is part of CGAL", the keywords $URL$ and $Id$, and the license of their package.
- Of the examples, only those are copied whose headers belong to CGAL or to the copied packages.
- Tests are the programs of test/PACKAGE/cgal, with the helpers of test/support that they include.
- Examples and tests get a CMakeLists.txt as CGAL's scripts make it.
- Manuals lose the text between \\if DSC_PROJECT and \\endif. References to packages that are not copied become plain
  text.
- Headers of licenses go to the package Installation, and the bibliography to the package Documentation.
"""

import pathlib
import re
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
KERNEL = ("Mesh_support", "Deformable_simplicial_complexes")
OWNER = "The deformable simplicial complex authors"
TOP_HEADERS = {  # headers directly in include/CGAL, by the beginning of their names
    "Deformable_simplicial_complex_": "Deformable_simplicial_complexes",
    "Incompressible_fluid_": "Incompressible_fluids_3",
    "Tetgen_tetrahedralizer_": "Complex_construction",
}
BANNER = re.compile(r"\A(?:// Copyright \(c\) (?P<years>[\d, -]+) " + OWNER + r"(?:[^\n]*\n//[^\n]*)*?\n"
                    r"// SPDX-License-Identifier: (?P<license>[^\n]+)\n(?:// Author[^\n]*\n)?)?")
CMAKE = """# This is the CMake script for compiling a set of CGAL applications.

cmake_minimum_required(VERSION 3.12...3.31)

project({package}_{kind})

find_package(CGAL REQUIRED)

# A deformation solves linear systems with Eigen, and uses several threads if TBB is found.
find_package(Eigen3 3.3 QUIET)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  message(STATUS "NOTICE: These programs require Eigen 3.3 or later, and will not be compiled.")
  return()
endif()
find_package(TBB QUIET)
include(CGAL_TBB_support)

# create a target per cppfile
file(GLOB cppfiles RELATIVE ${{CMAKE_CURRENT_SOURCE_DIR}} ${{CMAKE_CURRENT_SOURCE_DIR}}/*.cpp)
foreach(cppfile ${{cppfiles}})
  create_single_source_cgal_program("${{cppfile}}" CXX_FEATURES cxx_std_17)
  get_filename_component(target ${{cppfile}} NAME_WE)
  target_link_libraries(${{target}} PRIVATE CGAL::Eigen3_support)
  if(TARGET CGAL::TBB_support)
    target_link_libraries(${{target}} PRIVATE CGAL::TBB_support)
  endif()
endforeach()
"""
DOXYFILE = """@INCLUDE = ${{CGAL_DOC_PACKAGE_DEFAULTS}}

PROJECT_NAME = "CGAL ${{CGAL_DOC_VERSION}} - {title}"

EXTRACT_ALL          = NO
HIDE_UNDOC_CLASSES   = YES
WARN_IF_UNDOCUMENTED = NO
EXCLUDE_SYMBOLS      += *::internal *::internal::*
EXCLUDE_PATTERNS     = */internal/*
INCLUDE_PATH         = ${{CGAL_PACKAGE_INCLUDE_DIR}}
"""


def package_of(include):
    """Returns the package of a header, given as in an #include, or None for a header of CGAL."""
    parts = include.split("/")
    if parts[0] != "CGAL" or len(parts) < 2:
        return None
    if len(parts) == 2:
        return next((p for start, p in TOP_HEADERS.items() if parts[1].startswith(start)), None)
    return parts[1] if (ROOT / "include" / "CGAL" / parts[1]).is_dir() else None


def includes(path):
    return re.findall(r'^#include [<"]([^>"]+)[>"]', path.read_text(), re.MULTILINE)


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def banner(years=None, spdx=None):
    return (f"// Copyright (c) {years or 2026} {OWNER}.\n// All rights reserved.\n//\n"
            "// This file is part of CGAL (www.cgal.org).\n//\n// $URL$\n// $Id$\n"
            f"// SPDX-License-Identifier: {spdx or 'GPL-3.0-or-later'}\n//\n//\n// Author(s)     : {OWNER}\n")


def copy_header(path, output, package):
    """Copies a header with CGAL's banner, and the license of its package after the include guard."""
    text = re.sub(r"^(#ifndef (\w+)\n#define \2\n)", rf"\1\n#include <CGAL/license/{package}.h>\n", path.read_text(), 1,
                  re.MULTILINE)
    found = BANNER.match(text)
    write(output, banner(found["years"], found["license"]) + ("\n" if not found[0] else "") + text[found.end():])


def labels(folder):
    """Returns the names that a reference can have in the manual of a folder."""
    names = set()
    for path in [*folder.rglob("*.txt"), *folder.rglob("*.h")]:
        names.update(re.findall(r"\\(?:anchor|section|subsection|page|defgroup|example) +([\w./]+)", path.read_text()))
        names.update(re.findall(r"\\cgalFigureBegin\{(\w+)|\\cgalPkgDescriptionBegin\{[^,}]*,(\w+)", path.read_text()))
    return {part for name in names for part in ([name] if isinstance(name, str) else name) if part}


def copy_text(path, output, left_out):
    """Copies a text without what concerns only this project. References to `left_out` become plain text, and lists
    of examples lose these."""
    def plain(match):
        if match[1] not in left_out:
            return match[0]
        return match[2] or re.sub(r"^(?:Chapter_|Pkg)", "", match[1]).replace("_", " ")
    text = re.sub(r"\\if DSC_PROJECT\n.*?\\endif\n\n?", "", path.read_text(), flags=re.DOTALL)
    text = re.sub(r"\s+\(\\ref\s+([\w./:]+\w)\)", lambda m: "" if m[1] in left_out else m[0], text)
    text = re.sub(r'\\ref\s+([\w./:]+\w)(?:\s+"([^"]*)")?', plain, text)
    text = re.sub(r"\\example (\S+)\n", lambda m: "" if m[1] in left_out else m[0], text)
    write(output, text)


def copy_manual(package, output, packages):
    folder, target = ROOT / "doc" / package, output / package / "doc" / package
    below = {package, *(folder / "dependencies").read_text().split()}  # CGAL makes a manual for each package
    kept = set().union(*(labels(ROOT / "doc" / p) for p in packages if p in below))
    kept -= {f"{package}/{path.name}" for path in left_out_examples(package, packages)}
    kept -= {name for name in kept if name.endswith(".cpp") and not name.startswith(f"{package}/")}
    everything = labels(ROOT / "doc") | {"Gallery"}
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix in (".txt", ".h") and path.name != "Gallery.txt":
            copy_text(path, target / path.relative_to(folder), everything - kept)
        elif path.is_file() and path.parent.name != "fig" and path.name != "Gallery.txt":
            shutil.copy(path, target / path.relative_to(folder))
    texts = "".join(path.read_text() for path in target.rglob("*.txt"))
    for path in sorted((folder / "fig").glob("*")):
        if path.name in texts:
            (target / "fig").mkdir(exist_ok=True)
            shutil.copy(path, target / "fig")
    title = (ROOT / "package_info" / package / "description.txt").read_text().strip()
    write(target / "Doxyfile.in", DOXYFILE.format(title=title))


def examples(package):
    return sorted((ROOT / "examples" / package).glob("*.cpp"))


def left_out_examples(package, packages):
    return [p for p in examples(package) if any(package_of(i) not in (None, *packages) for i in includes(p))]


def copy_tests(package, output):
    programs = sorted((ROOT / "test" / package / "cgal").glob("*.cpp"))
    target = output / package / "test" / package
    todo = [ROOT / "test" / "support" / i for p in programs for i in includes(p)]
    done = set(programs)
    while todo:
        path = todo.pop()
        if path.is_file() and path not in done:
            done.add(path)
            todo += [path.parent / i for i in includes(path)]
    for path in sorted(done):
        write(target / path.name, path.read_text())
    if programs:
        write(target / "CMakeLists.txt", CMAKE.format(package=package, kind="Tests"))


def write_license(package, output):
    """Writes the header with the license of a package. Headers of the package include it."""
    title = (ROOT / "package_info" / package / "description.txt").read_text().strip()
    guard = f"CGAL_LICENSE_{package.upper()}_H"
    write(output, banner() + f"""
#ifndef {guard}
#define {guard}

// Users who define `CGAL_LICENSE_WARNING` or `CGAL_LICENSE_ERROR` get a warning or an error if they
// include a header of the package.

#include <CGAL/config.h>

#if defined(CGAL_LICENSE_ERROR)
#error "GPL-3.0-or-later applies to the package {title}."
#elif defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("GPL-3.0-or-later applies to the package {title}.")
#endif

#endif // {guard}
""")


def copy_package(package, output, packages):
    top = ROOT / "include" / "CGAL"
    headers = [*sorted((top / package).rglob("*.h")), *(p for p in sorted(top.glob("*.h"))
                                                        if package_of(f"CGAL/{p.name}") == package)]
    for path in headers:
        copy_header(path, output / package / "include" / "CGAL" / path.relative_to(top), package)
    write_license(package, output / "Installation" / "include" / "CGAL" / "license" / f"{package}.h")
    kept = [p for p in examples(package) if p not in left_out_examples(package, packages)]
    for path in kept:
        write(output / package / "examples" / package / path.name, path.read_text())
    if kept:
        write(output / package / "examples" / package / "CMakeLists.txt",
              CMAKE.format(package=package, kind="Examples"))
    copy_tests(package, output)
    if (ROOT / "demo" / package).is_dir():
        shutil.copytree(ROOT / "demo" / package, output / package / "demo" / package, dirs_exist_ok=True)
    copy_manual(package, output, packages)
    shutil.copytree(ROOT / "package_info" / package, output / package / "package_info" / package, dirs_exist_ok=True)
    print(f"{package}: {len(headers)} headers, {len(kept)} of {len(examples(package))} examples")


def copy(output, packages):
    for package in packages:
        copy_package(package, output, packages)
    for path in sorted((ROOT / "doc" / "biblio").glob("*.bib")):
        write(output / "Documentation" / "doc" / "biblio" / path.name, path.read_text())


def check(output):
    """Prints what is wrong with the form of the packages of a folder. Returns the number of faults."""
    faults = []
    for info in sorted(output.glob("*/package_info/*")):
        package, folder = info.name, info.parent.parent
        for name in ("copyright", "dependencies", "description.txt", "license.txt", "long_description.txt", "maintainer"):
            if not (info / name).is_file() or not (info / name).read_text().strip():
                faults.append(f"{package}: package_info/{package}/{name} is missing or empty")
        for path in sorted(folder.rglob("*")):
            if path.is_file() and path.suffix in (".h", ".cpp", ".txt"):
                text = path.read_text(encoding="utf-8")  # also tells of other encodings
                where = path.relative_to(output)
                if re.search(r"\t|[ \t]$|\r", text, re.MULTILINE):
                    faults.append(f"{where}: tabs or spaces at the end of a line")
                if path.stat().st_mode & 0o111:
                    faults.append(f"{where}: may be executed")
                if path.suffix == ".h" and "/include/" in str(path):
                    faults += [f"{where}: {fault}" for fault in header_faults(path, text, package)]
        for kind in ("examples", "demo", "test"):
            for program in sorted(folder.glob(f"{kind}/*/*.cpp")):
                name = {"examples": "Examples", "demo": "Demo", "test": "Tests"}[kind]
                lists = program.parent / "CMakeLists.txt"
                if not lists.is_file() or f"project({package}_{name})" not in lists.read_text():
                    faults.append(f"{lists.relative_to(output)}: is missing or names another project")
                if "int main" not in program.read_text():
                    faults.append(f"{program.relative_to(output)}: has no function main")
    headers = [p.relative_to(p.parents[[q.name for q in p.parents].index("include")])
               for p in output.glob("*/include/**/*.h")]
    lower = [str(p).lower() for p in headers]
    faults += [f"{p}: another header differs only in capitals" for p in headers if lower.count(str(p).lower()) > 1]
    print("\n".join(faults) if faults else "The form of all packages is right.")
    return len(faults)


def header_faults(path, text, package):
    for line in ("// Copyright (c) ", "// This file is part of CGAL (www.cgal.org)", "// $URL$", "// $Id$",
                 "// SPDX-License-Identifier: ", "// Author(s)     : "):
        if f"\n{line}" not in f"\n{text[:1000]}":
            yield f"has no line '{line}'"
    if "The list has no include guard" in text:
        return  # a list that is included several times
    guard = re.search(r"^#ifndef (\w+)\n#define (\w+)$", text, re.MULTILINE)
    parts = path.parts[path.parts.index("include") + 2:]
    if not guard or guard[1] != guard[2] or guard[1] != re.sub(r"\W", "_", "CGAL_" + "_".join(parts)).upper():
        yield "has no include guard with the name of its path"
    if f"#include <CGAL/license/{package}.h>" not in text:
        yield "does not include the license of its package"
    for macro in re.findall(r"^# *define +(\w+)", text, re.MULTILINE):
        if not macro.startswith("CGAL_"):
            yield f"defines the macro {macro}, whose name does not begin with CGAL_"
    code = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)
    prints = "std::cout" in code or ("std::cerr" in code and "verbose" not in code)  # as is_valid() of CGAL does
    if prints or re.search(r"\b(?:abort|exit|assert)\(", code):
        yield "prints, ends the process or uses assert()"


def main():
    arguments = sys.argv[1:]
    if arguments == ["check"]:
        with tempfile.TemporaryDirectory() as folder:
            copy(pathlib.Path(folder), KERNEL)
            return 1 if check(pathlib.Path(folder)) else 0
    if len(arguments) == 2 and arguments[0] == "check":
        return 1 if check(pathlib.Path(arguments[1])) else 0
    if not arguments or arguments[0].startswith("-"):
        print(__doc__)
        return 2
    packages = arguments[1:] or KERNEL
    for package in packages:
        if not (ROOT / "package_info" / package).is_dir():
            print(f"there is no package {package}")
            return 2
    copy(pathlib.Path(arguments[0]), packages)
    return 0


sys.exit(main())
