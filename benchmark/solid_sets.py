"""Gives sets of solids to `dsc`, and compares volumes and centers of its labels with expected ones.

Volumes and centers are computed from the tetrahedra of the written file.
"""

import argparse
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time

import cad_solids
import numpy
from thin_parts import read_mesh

class Set:
    """Files, each with one or more solids, and the expected moments of the labels 1, 2, ...

    A file `.off` contains its solids as one surface, a file `.obj` as objects.
    """

    def __init__(self, files, expected=None):
        self.files = files  # pairs of a name and solids
        self.expected = expected

    def solids(self):
        return [solid for _, solids in self.files for solid in solids]

    def write(self, folder, form):
        paths = []
        for name, solids in self.files:
            paths.append(folder / name)
            if name.endswith(".obj"):
                cad_solids.write_obj(paths[-1], solids, form)
            else:
                cad_solids.write_off(paths[-1], cad_solids.joined(solids), form)
        return paths

    def rounding(self, form):
        """Returns the relative change of the smallest volume if the last digits of coordinates change by one."""
        largest = max(numpy.abs(points).max() for points, _ in self.solids())
        area = max(cad_solids.area(solid) for solid in self.solids())
        digits = int(form[2:-1])
        unit = 10.0 ** (numpy.floor(numpy.log10(largest)) + 1 - digits)
        return unit * area / min(m[0] for m in self.expected if m[0] > 0)


def separate(solids):
    """Returns a set with a file for each solid. Each solid keeps its volume."""
    return Set([(f"{i}.off", [solid]) for i, solid in enumerate(solids)], [cad_solids.moments(s) for s in solids])


def moments_of_labels(path):
    """Returns the integrals of 1, x, y and z over each positive label, or `None` if a tetrahedron is inverted."""
    points, cells, labels = read_mesh(path)
    middle = points.mean(0)
    corners = points[cells] - middle
    volumes = numpy.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    if not (volumes > 0).all():
        return None
    result = {}
    for label in numpy.unique(labels[labels > 0]):
        v, c = volumes[labels == label], corners[labels == label].mean(1)
        result[int(label)] = numpy.array([v.sum(), *(v @ c + v.sum() * middle)])
    return result


def error(found, expected):
    """Returns the larger one of the relative errors of the volume and of the center."""
    size = abs(expected[0]) ** (1 / 3)
    center = found[1:] / found[0] - expected[1:] / expected[0]
    return max(abs(found[0] / expected[0] - 1), float(numpy.linalg.norm(center)) / size)


def run_program(command, seconds):
    """Returns the message of a program that failed, or an empty string."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          start_new_session=True) as process:  # fmt: skip
        try:
            _, message = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return f"not done in {seconds} s"
    return "" if process.returncode == 0 else message.strip() or f"status {process.returncode}"


def compare(solid_set, folder, arguments):
    """Runs the program, and returns the largest error, or a message."""
    out = folder / "out"
    motion = ["--axis", "0,0,1", "--angle", "5", "--steps", "1", "--quiet", "--output", out]
    paths = solid_set.write(folder, arguments.format)
    message = run_program([arguments.program, "rotate", *paths, *motion], arguments.seconds)
    if message:
        return "refused: " + message
    found = moments_of_labels(out / "volume_000000.vtu")
    if found is None:
        return "wrong: inverted tetrahedra"
    wanted = {i + 1: m for i, m in enumerate(solid_set.expected) if m[0] > 0}
    if set(found) != set(wanted):
        return f"wrong: labels {sorted(found)} instead of {sorted(wanted)}"
    return max(error(found[label], wanted[label]) for label in wanted)


def parser(description):
    result = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("program", help="the program dsc")
    result.add_argument("--sets", type=int, default=20, help="number of sets")
    result.add_argument("--first", type=int, default=0, help="number of the first set, the seed of its random numbers")
    result.add_argument("--format", default="%.17g", help="format of coordinates")
    result.add_argument("--tolerance", type=float, default=1e-9,
                        help="largest error, besides that of the last digits of coordinates")  # fmt: skip
    result.add_argument("--seconds", type=float, default=300, help="time limit of a run")
    result.add_argument("--keep", type=pathlib.Path, help="folder for the files of refused and wrong sets")
    return result


def check(name, make, arguments):
    """Checks sets and prints a line for each, the ten worst and a row of a table. Returns whether all are right.

    \\param make returns the set of a number, or `None` if the peer fails
    """
    errors, refused, wrong, seconds = [], 0, 0, []
    for number in range(arguments.first, arguments.first + arguments.sets):
        solid_set = make(number)
        if solid_set is None:
            print(f"{name} {number}: skipped, the peer fails", flush=True)
            continue
        with tempfile.TemporaryDirectory() as folder:
            begin = time.monotonic()
            result = compare(solid_set, pathlib.Path(folder), arguments)
            seconds.append(time.monotonic() - begin)
            if not isinstance(result, str):
                errors.append((result, number))
                if result > arguments.tolerance + solid_set.rounding(arguments.format):
                    result = f"wrong: {result:.2g}"
            refused += isinstance(result, str) and result.startswith("refused")
            wrong += isinstance(result, str) and result.startswith("wrong")
            if isinstance(result, str) and arguments.keep:
                shutil.copytree(folder, arguments.keep / f"{name}_{number}_{arguments.format[1:]}", dirs_exist_ok=True)
        text = result if isinstance(result, str) else f"{result:.2g}"
        triangles = sum(len(t) for _, t in solid_set.solids())
        print(f"{name} {number}: {len(solid_set.solids())} solids, {triangles} triangles, {seconds[-1]:.1f} s, {text}",
              flush=True)  # fmt: skip
    errors.sort(reverse=True)
    print("largest errors: " + ", ".join(f"{e:.2g} ({number})" for e, number in errors[:10]))
    print("| sets | coordinates | number | refused | wrong | largest error | seconds, mean | maximum |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    print(f"| {name} | `{arguments.format}` | {len(seconds)} | {refused} | {wrong} | {max(errors, default=[0])[0]:.1g} | "
          f"{numpy.mean(seconds):.1f} | {max(seconds):.1f} |")  # fmt: skip
    return refused + wrong == 0
