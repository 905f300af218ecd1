#!/usr/bin/env python3
"""Measures how long commands of the program take to end after SIGINT or SIGTERM.

Usage: benchmark/stopping.py PROGRAM [DELAYS]

The input of each command takes about half a minute. Each command is started and stopped DELAYS times
(default: 8), after delays that are spread over its duration. Prints for each command the longest time from
the signal to the end, in milliseconds, and the delay. Ends with status 1 if a time exceeds one second,
or if a command leaves an incomplete file.
"""
import math
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

LONGEST = 1.0  # seconds from the signal to the end
DURATION = 30.0  # seconds: upper bound for the duration of a command


def sphere(n):
    """Returns a sphere of about 4 n^2 triangles as an OFF file."""
    m = 2 * n
    lines = [f"OFF\n{m * (n - 1) + 2} {2 * m * (n - 1)} 0", "0 0 1", "0 0 -1"]
    for i in range(1, n):
        for j in range(m):
            a, b = math.pi * i / n, 2 * math.pi * j / m
            lines.append(f"{math.sin(a) * math.cos(b)} {math.sin(a) * math.sin(b)} {math.cos(a)}")

    def at(i, j):
        return 2 + (i - 1) * m + j % m

    for j in range(m):
        lines.append(f"3 0 {at(1, j)} {at(1, j + 1)}")
        lines.append(f"3 1 {at(n - 1, j + 1)} {at(n - 1, j)}")
        for i in range(1, n - 1):
            lines.append(f"3 {at(i, j)} {at(i + 1, j)} {at(i + 1, j + 1)}")
            lines.append(f"3 {at(i, j)} {at(i + 1, j + 1)} {at(i, j + 1)}")
    return "\n".join(lines) + "\n"


def crossing_spheres(n):
    """Returns two intersecting spheres in one OFF file."""
    lines = sphere(n).split("\n")
    vertices, triangles = (int(word) for word in lines[1].split()[:2])
    points, faces = lines[2 : 2 + vertices], lines[2 + vertices : 2 + vertices + triangles]
    moved = [f"{float(x) + 0.7} {y} {z}" for x, y, z in (p.split() for p in points)]
    shifted = ["3 " + " ".join(str(int(v) + vertices) for v in f.split()[1:]) for f in faces]
    return "\n".join([f"OFF\n{2 * vertices} {2 * triangles} 0"] + points + moved + faces + shifted) + "\n"


def spiral(n):
    """Returns points on a sphere."""
    lines = []
    for i in range(n):
        z = 1 - (2 * i + 1) / n
        r, a = math.sqrt(1 - z * z), 2.399963 * i
        lines.append(f"{r * math.cos(a)} {r * math.sin(a)} {z}")
    return "\n".join(lines) + "\n"


def voxels(n, labels):
    """Returns an image of n^3 voxels with balls around random points."""
    rng = random.Random(1)
    seeds = [[rng.uniform(0, n) for _ in range(3)] for _ in range(labels)]
    radius = 0.4 * n / labels ** (1 / 3)
    header = (
        f"#INRIMAGE-4#{{\nXDIM={n}\nYDIM={n}\nZDIM={n}\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\n"
        "CPU=decm\nVX=1\nVY=1\nVZ=1\n"
    )
    header += "\n" * (252 - len(header)) + "##}\n"
    data = bytearray(n**3)
    for label, (x, y, z) in enumerate(seeds, 1):
        for k in range(max(0, int(z - radius)), min(n, int(z + radius) + 1)):
            for j in range(max(0, int(y - radius)), min(n, int(y + radius) + 1)):
                for i in range(max(0, int(x - radius)), min(n, int(x + radius) + 1)):
                    if (i - x) ** 2 + (j - y) ** 2 + (k - z) ** 2 < radius**2:
                        data[(k * n + j) * n + i] = label % 250 + 1
    return header.encode() + bytes(data)


def pixels(n):
    """Returns a PGM image of n^2 pixels with wavy stripes."""
    rows = bytearray()
    for j in range(n):
        rows += bytes(int(3 + 3 * math.sin((i + 9 * math.sin(j / 37)) / 23)) for i in range(n))
    return f"P5 {n} {n} 255\n".encode() + bytes(rows)


BALL = ["x^2+y^2+z^2<.5", "--domain", "-1,-1,-1,1,1,1"]
COMMANDS = {
    "inequality": ["offset", *BALL, "--edge", ".012", "--distance", ".001"],
    "surface": ["offset", "large.off", "--distance", ".001"],
    "surface, refined": ["rotate", "small.off", "--triangles", "400000", "--axis", "0,0,1", "--angle", "1"],
    "repair": ["offset", "crossing.off", "--repair", "--distance", ".001"],
    "offset": ["offset", "medium.off", "--distance", ".02", "--steps", "1000", "--output", "OUT"],
    "curvature": ["mean-curvature", "medium.off", "--steps", "1000", "--improve-interface"],
    "enright": ["enright", "--period", "3", "--dt", ".05", "--steps", "1000", "--report", "OUT.json"],
    "image": ["offset", "voxels.inr", "--distance", ".01"],
    "pixels": ["mean-curvature", "pixels.pgm", "--dt", ".1"],
    "reconstruct": ["reconstruct", "points.xyz", "-o", "OUT.off"],
    "improve": ["improve", "mesh.vtu", "--aggressive", "-o", "OUT.vtu"],
    "cut locus": ["cut-locus", "--point", ".4,.3", "--spacing", ".04", "-o", "OUT.svg"],
    "fluid": ["fluid", "bunny", "--data", ".", "--output", "OUT"],
    "dam break": ["fluid", "dam-break", "--output", "OUT"],
    "convert": ["convert", "mesh/checkpoint.dsc", "OUT.ply", "--subdivide", "5"],
    "info": ["info", "large.off"],
}


def main():
    program = os.path.abspath(sys.argv[1])
    delays = int(sys.argv[2]) if len(sys.argv) > 2 else 8
    rng = random.Random(7)
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        def write(name, data):
            with open(os.path.join(folder, name), "wb") as out:
                out.write(data if isinstance(data, bytes) else data.encode())

        write("large.off", sphere(350))
        write("medium.off", sphere(100))
        write("small.off", sphere(20))
        write("crossing.off", crossing_spheres(150))
        write("points.xyz", spiral(200000))
        write("voxels.inr", voxels(128, 60))
        write("pixels.pgm", pixels(3000))
        os.system(
            "tar xzf /usr/share/doc/libcgal-dev/data.tar.gz -C '%s' --strip-components=2 "
            "data/meshes/bunny00.off" % folder
        )
        run = lambda *words: subprocess.run([program, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        run("offset", *BALL, "--edge", ".035", "--distance", ".001", "--steps", "1", "--output", "mesh")
        run("convert", "mesh/checkpoint.dsc", "mesh.vtu")
        print("| command | longest from signal to end (ms) | signal after (s) | took without (s) |\n| --- | --- | --- | --- |")
        for name, words in COMMANDS.items():
            longest, moment, duration = 0.0, 0.0, DURATION
            for k in range(delays):
                delay = duration * (k + rng.random()) / delays
                before = set(os.listdir(folder))
                words_now = [w.replace("OUT", f"out{k}") for w in words]
                start = time.monotonic()
                child = subprocess.Popen([program, *words_now], cwd=folder, stdout=subprocess.DEVNULL,
                                         stderr=subprocess.PIPE)
                try:
                    child.wait(delay)
                    duration = min(duration, time.monotonic() - start)
                except subprocess.TimeoutExpired:
                    asked = time.monotonic()
                    child.send_signal(rng.choice([signal.SIGINT, signal.SIGTERM]))
                    child.wait()
                    took = time.monotonic() - asked
                    if took > longest:
                        longest, moment = took, delay
                    if child.returncode not in (130, 0):
                        print(f"{name}: status {child.returncode}: {child.stderr.read().decode()}")
                        failed = True
                child.stderr.close()
                for made in set(os.listdir(folder)) - before:
                    if "partial" in made:
                        print(f"{name}: left {made}")
                        failed = True
                    os.system(f"rm -rf '{os.path.join(folder, made)}'")
            failed = failed or longest > LONGEST
            print(f"| {name} | {1000 * longest:.0f} | {moment:.1f} | "
                  f"{'more than 30' if duration == DURATION else f'{duration:.1f}'} |", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
