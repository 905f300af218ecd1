#!/usr/bin/env python3
"""Measures the cost of `dsc reconstruct` by the number of points of an open scan.

Usage: benchmark/open_scan.py PROGRAM [SIZES]

The points are random subsets of CGAL's scan of a building, from the documentation of libcgal-dev. SIZES
(default: 12500 25000 50000 100000) are numbers of points. Prints a row of a table for each size:
processor time, peak memory, and the slope relative to the previous row, which is 1 for linear growth.
"""
import math
import os
import random
import subprocess
import sys
import tarfile
import tempfile

ARCHIVE = "/usr/share/doc/libcgal-dev/data.tar.gz"
SCAN = "data/points_3/building.ply"
SIZES = [12500, 25000, 50000, 100000]
SEED = 1
COLUMNS = 6  # coordinates and normals; the last column is the number of a segment


def points_of_scan():
    """Returns the lines of all points."""
    with tarfile.open(ARCHIVE) as archive:
        lines = archive.extractfile(SCAN).read().decode().split("\n")
    lines = lines[lines.index("end_header") + 1 :]
    return [" ".join(line.split()[:COLUMNS]) for line in lines if line.strip()]


def measure(program, points, folder):
    """Returns processor seconds, megabytes, and the output of the program."""
    cloud, surface = os.path.join(folder, "points.xyz"), os.path.join(folder, "surface.off")
    with open(cloud, "w") as file:
        file.write("\n".join(points) + "\n")
    child = subprocess.Popen(
        [program, "reconstruct", cloud, "--open", "-o", surface], stdout=subprocess.PIPE, text=True
    )
    told = child.stdout.read().strip()
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"{program} failed with status {status}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, told


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sizes = [int(word) for word in sys.argv[2:]] or SIZES
    points = points_of_scan()
    random.Random(SEED).shuffle(points)
    print("| points | processor time (s) | slope | memory (MB) | bytes a point | told |")
    print("| --- | --- | --- | --- | --- | --- |")
    last = None
    with tempfile.TemporaryDirectory() as folder:
        for n in sizes:
            seconds, megabytes, told = measure(sys.argv[1], points[:n], folder)
            slope = math.log(seconds / last[1]) / math.log(n / last[0]) if last else None
            print(
                f"| {n} | {seconds:.1f} | {'' if slope is None else f'{slope:.2f}'} | {megabytes:.0f} "
                f"| {megabytes * 1024 * 1024 / n:.0f} | {told} |",
                flush=True,
            )
            last = n, seconds


if __name__ == "__main__":
    main()
