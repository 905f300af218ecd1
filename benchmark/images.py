#!/usr/bin/env python3
"""Measures the costs of images of voxels by the numbers of labels and of voxels.

Usage: benchmark/images.py DSC

DSC is the program, built in Release. Prints a table with the processor time and the peak memory of one
step of `dsc offset`. The slope is the exponent of the processor time over the number of triangles,
relative to the previous row.
"""

import math
import os
import random
import struct
import subprocess
import sys
import tempfile

HEADER = 256  # bytes


def write_inr(path, side, label_at):
    """Writes an image of side^3 voxels of 32 bits."""
    header = (
        f"#INRIMAGE-4#{{\nXDIM={side}\nYDIM={side}\nZDIM={side}\nVDIM=1\nTYPE=unsigned fixed\n"
        "PIXSIZE=32 bits\nCPU=decm\nVX=1\nVY=1\nVZ=1\n"
    )
    end = "##}\n"
    header += "\n" * (HEADER - len(header) - len(end)) + end
    labels = [label_at(i, j, k) for k in range(side) for j in range(side) for i in range(side)]
    with open(path, "wb") as file:
        file.write(header.encode() + struct.pack(f"<{len(labels)}I", *labels))


def ball(side):
    middle, radius = side / 2 - 0.3, side / 3
    return lambda i, j, k: int(math.dist((i, j, k), (middle, middle, middle)) < radius)


def noise(labels):
    numbers = random.Random(1)
    return lambda i, j, k: numbers.randrange(labels)


def cells(side, labels):
    """Returns the labels of Voronoi cells in a ball."""
    numbers = random.Random(1)
    seeds = [tuple(numbers.uniform(0, side) for _ in range(3)) for _ in range(labels)]
    width = max(1, int(side / labels ** (1 / 3)))
    boxes = {}
    for number, seed in enumerate(seeds):
        boxes.setdefault(tuple(int(x) // width for x in seed), []).append((seed, number + 1))
    middle = side / 2

    def label_at(i, j, k):
        p = (i, j, k)
        if math.dist(p, (middle, middle, middle)) > 0.47 * side:
            return 0
        reach = 1
        while True:
            at = [x // width for x in p]
            near = [
                (math.dist(p, seed), label)
                for x in range(at[0] - reach, at[0] + reach + 1)
                for y in range(at[1] - reach, at[1] + reach + 1)
                for z in range(at[2] - reach, at[2] + reach + 1)
                for seed, label in boxes.get((x, y, z), [])
            ]
            if near and min(near)[0] <= reach * width:
                return min(near)[1]
            reach += 1

    return label_at


def measure(program, path):
    """Returns processor seconds, peak memory in MiB, and the numbers of tetrahedra and triangles."""
    with tempfile.NamedTemporaryFile("w+") as usage:
        text = subprocess.run(
            ["/usr/bin/time", "-o", usage.name, "-f", "%U %M", program, "offset", path]
            + ["--distance=0.05", "--steps", "1", "--threads", "1"],
            check=True, capture_output=True, text=True,
        ).stdout
        seconds, memory = usage.read().split()
    words = text.split()
    return float(seconds), int(memory) / 1024, int(words[words.index("tetrahedra,") - 1]), int(
        words[words.index("interface") - 1]
    )


def main(program):
    rows = [("ball", side, 1, ball(side)) for side in (24, 48, 96, 192)]
    rows += [("noise", side, 5, noise(5)) for side in (8, 12, 16, 24, 32)]
    rows += [("all differ", side, side**3, noise(1 << 30)) for side in (8, 12, 16, 24, 32)]
    rows += [("cells", 64, n, cells(64, n)) for n in (10, 30, 100, 300, 1000)]
    print("| image | voxels | labels | s | MiB | tetrahedra | triangles | slope in triangles |")
    print("|-|-|-|-|-|-|-|-|")
    before = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, side, labels, label_at in rows:
            path = os.path.join(folder, "image.inr")
            write_inr(path, side, label_at)
            seconds, memory, tetrahedra, triangles = measure(program, path)
            slope = ""
            if name in before:
                last_seconds, last_triangles = before[name]
                slope = f"{math.log(seconds / last_seconds) / math.log(triangles / last_triangles):.2f}"
            before[name] = (seconds, triangles)
            print(
                f"| {name} | {side}³ | {labels} | {seconds:.2f} | {memory:.0f} | {tetrahedra} | {triangles} "
                f"| {slope} |",
                flush=True,
            )


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
