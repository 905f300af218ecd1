#!/usr/bin/python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares runs of `dsc` with the same runs of talpa, the program of El Topo.

Usage: benchmark/peers/eltopo.py DSC TALPA enright [--triangles N] [--steps N] [--runs N]
       benchmark/peers/eltopo.py DSC TALPA offset SURFACE [--triangles N] [--steps N] [--runs N]

TALPA is a program built before, without a display; nothing is fetched. `enright` moves a sphere by the flow of Enright
with T = 3, in steps of .01. `offset` moves a closed surface outwards by a quarter of a mean edge in each step. Both programs
start with the same triangles, use one thread, and run in turns. talpa splits edges longer than 1.5 and collapses edges
shorter than .5 mean edges, with its safety against collisions; topology changes only in `offset`. Prints a line for each
program: the median processor time of the process, seconds in steps as the program prints them, the largest memory, and the
final surface.
"""
import argparse
import os
import pathlib
import re
import statistics
import struct
import subprocess
import sys
import tempfile

import numpy

SPHERE_CENTER, SPHERE_RADIUS = (0.35, 0.35, 0.35), 0.15
PERIOD, DT = 3, 0.01
TALPA_SCRIPT = """
relative_output_path out
frame_dt {end}
sim_dt {dt}
end_sim_t {end}
{simulation}
surftrack_parameters
(
   use_fraction 1
   min_edge_length 0.5
   max_edge_length 1.5
   max_volume_change 0.1
   min_curvature_multiplier 1.0
   max_curvature_multiplier 1.0
   merge_proximity 0.001
   repulsion_proximity 0.0001
   friction_coefficient 0.0
   perform_improvement 1
   allow_topology_changes {topology}
   collision_safety 1
   subdivision_scheme butterfly
)
objfile
(
   filepath {surface}
   is_solid 0
)
camera
(
   target [0 0 0]
   distance 1.5
   heading 3.14
   pitch 0.0
)
"""


def sphere(triangles):
    """Returns a triangulated sphere: an octahedron whose sides are divided evenly."""
    n = max(1, round((triangles / 8) ** 0.5))
    points, faces, index = [], [], {}

    def vertex(x, y, z):
        if (x, y, z) not in index:
            index[x, y, z] = len(points)
            direction = numpy.array([x, y, z], float)
            points.append(numpy.array(SPHERE_CENTER) + SPHERE_RADIUS * direction / numpy.linalg.norm(direction))
        return index[x, y, z]

    for sx in (1, -1):
        for sy in (1, -1):
            for sz in (1, -1):
                def at(i, j):
                    return vertex(sx * i, sy * j, sz * (n - i - j))

                for i in range(n):
                    for j in range(n - i):
                        corners = [(at(i, j), at(i + 1, j), at(i, j + 1))]
                        if i + j < n - 1:
                            corners.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
                        faces += corners if sx * sy * sz > 0 else [c[::-1] for c in corners]
    return numpy.array(points), numpy.array(faces)


def write_obj(path, points, faces):
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces.tolist()]
    path.write_text("\n".join(lines) + "\n")


def read_off(path):
    words = path.read_text().split()
    n, m = int(words[1]), int(words[2])
    points = numpy.array(words[4 : 4 + 3 * n], float).reshape(-1, 3)
    return points, numpy.array(words[4 + 3 * n : 4 + 3 * n + 4 * m], int).reshape(-1, 4)[:, 1:]


def read_frame(path):
    """Returns the points and triangles of a frame of talpa: a byte, the time, points, masses, triangles."""
    data, at = path.read_bytes(), 9
    (n,) = struct.unpack_from("<I", data, at)
    points = numpy.frombuffer(data, "<f8", 3 * n, at + 4).reshape(-1, 3)
    at += 4 + 32 * n
    (m,) = struct.unpack_from("<I", data, at)
    return points, numpy.frombuffer(data, "<u4", 3 * m, at + 4).reshape(-1, 3)


def volume(points, faces):
    return abs(numpy.linalg.det((points - points.mean(0))[faces]).sum()) / 6


def mean_edge(points, faces):
    edges = numpy.unique(numpy.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)), axis=0)
    return float(numpy.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1).mean())


def angles(points, faces):
    """Returns the smallest and the largest angle of the triangles in degrees."""
    corners = points[faces]
    result = []
    for i in range(3):
        u, v = corners[:, (i + 1) % 3] - corners[:, i], corners[:, (i + 2) % 3] - corners[:, i]
        result.append(numpy.arctan2(numpy.linalg.norm(numpy.cross(u, v), axis=1), (u * v).sum(1)))
    result = numpy.degrees(result)
    return result.min(), result.max()


def run(command, folder):
    """Returns the output of a program, its seconds of processor time, and its megabytes."""
    with open(folder / "log", "w+", encoding="utf-8") as log:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, cwd=folder)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = status
        log.seek(0)
        text = log.read()
    if status != 0:
        sys.exit(f"{command[0]} ended with status {status}:\n{text[-2000:]}")
    return text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def run_dsc(program, arguments, surface, folder):
    command = [program, *arguments, surface, "--threads", "1", "--every", "1000000", "--output", "out"]
    text, seconds, megabytes = run(command, folder)
    subprocess.run([program, "convert", "out/checkpoint.dsc", "end.off"], cwd=folder, check=True, capture_output=True)
    return seconds, float(re.search(r" (\S+) s\s*$", text).group(1)), megabytes, read_off(folder / "end.off")


def run_talpa(program, script, folder):
    (folder / "script.txt").write_text(script)
    _, seconds, megabytes = run([program, "script.txt", "frames"], folder)
    results = next((folder / "frames/out").iterdir())
    steps = re.search(r"total_sim_time: (\S+)", (results / "aaa-stats.txt").read_text()).group(1)
    return seconds, float(steps), megabytes, read_frame(max(results.glob("frame*.bin")))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("dsc", type=os.path.abspath)
    parser.add_argument("talpa", type=os.path.abspath)
    parser.add_argument("work", choices=("enright", "offset"))
    parser.add_argument("surface", nargs="?")
    parser.add_argument("--triangles", type=int)
    parser.add_argument("--steps", type=int)
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    if (options.work == "offset") != (options.surface is not None):
        parser.error("offset needs a surface, and enright has none")
    outcomes = {"dsc": [], "talpa": []}
    with tempfile.TemporaryDirectory() as place:
        start = pathlib.Path(place) / "start.obj"
        if options.work == "enright":
            points, faces = sphere(options.triangles or 5000)
            steps = options.steps or round(PERIOD / DT)
            arguments = ["enright", "--period", str(PERIOD), "--dt", str(DT), "--steps", str(steps)]
            simulation, dt = "enright_simulation\n(\n)", DT
        else:
            path = pathlib.Path(place) / "start.off"
            source = options.surface
            if options.triangles:  # simplified at the start of a run that stays in place
                simplified = ["--triangles", str(options.triangles), "--output", f"{place}/simplified", "--quiet"]
                subprocess.run([options.dsc, "rotate", source, "--axis", "0,0,1", "--angle", "0", "--steps", "1", *simplified], check=True)
                source = f"{place}/simplified/checkpoint.dsc"
            subprocess.run([options.dsc, "convert", source, path], check=True)
            points, faces = read_off(path)
            steps, dt = options.steps or 10, 1
            speed = mean_edge(points, faces) / 4
            arguments = ["offset", "--distance", repr(speed), "--steps", str(steps)]
            simulation = f"faceoff_simulation\n(\n speed {-speed!r}\n)"  # positive speeds move inwards
        write_obj(start, points, faces)
        script = TALPA_SCRIPT.format(end=steps * dt, dt=dt, simulation=simulation, surface=start, topology=int(options.work == "offset"))
        for turn in range(options.runs):
            for name in outcomes:
                folder = pathlib.Path(place) / f"{name}_{turn}"
                folder.mkdir()
                outcomes[name].append(
                    run_dsc(options.dsc, arguments, start, folder) if name == "dsc" else run_talpa(options.talpa, script, folder)
                )
    before = volume(points, faces)
    print(f"{options.work}, {len(faces)} triangles, {steps} steps, median of {options.runs}\n")
    print("| program | s | s in steps | MB | triangles | change of the volume % | least angle | largest angle |")
    print("| --- |" + " ---: |" * 7)
    for name, results in outcomes.items():
        seconds, in_steps, megabytes = (statistics.median(r[k] for r in results) for k in range(3))
        end = results[-1][3]
        least, largest = angles(*end)
        print(
            f"| {name} | {seconds:.1f} | {in_steps:.1f} | {megabytes:.0f} | {len(end[1])} | "
            f"{100 * (volume(*end) / before - 1):.4f} | {least:.2f} | {largest:.2f} |"
        )


if __name__ == "__main__":
    main()
