#!/usr/bin/env python3
"""Gives `dsc` random sets of overlapping solids, and compares volumes and centers with those of Boolean operations.

solids  two to thirty balls, cylinders, gears, boxes and letters at random places, mostly turned
text    a plate with letters that stand on it, are sunk into it, go through it, or lie in it; their volumes are known

The peer of `solids` is the program `boolean_volumes` of this folder: corefinement with exact numbers. Sets for which it
fails are skipped. Prints a line for each set, the ten largest errors, and a row of a table. Ends with status 1 if a set is
refused or wrong.

    benchmark/overlaps.py build/dsc solids --peer build/benchmark/boolean_volumes --sets 25
"""

import math
import pathlib
import subprocess
import sys
import tempfile

import cad_solids
import numpy as np
import solid_sets


def solid(numbers):
    """Returns a solid with an extent of about one."""
    kind = numbers.choice(["ball", "cylinder", "gear", "box", "letter"])
    if kind == "ball":
        return cad_solids.ball(numbers.uniform(0.5, 0.7), numbers.integers(4, 11))
    if kind == "box":
        return cad_solids.divided_box((-0.4, -0.4, -0.4), (0.45, 0.5, 0.6), numbers.integers(1, 5, 3), numbers)
    if kind == "letter":
        return cad_solids.letter(numbers.choice(list(cad_solids.LETTERS)), 0.4)
    sides = numbers.integers(6, 25) if kind == "cylinder" else 2 * numbers.integers(5, 11)
    radii = np.full(sides, 0.4) if kind == "cylinder" else np.tile([0.6, 0.75], sides // 2)
    angles = 2 * math.pi / sides * np.arange(sides)
    outline = list(zip(radii * np.cos(angles), radii * np.sin(angles)))
    return cad_solids.extruded_star(outline, 1.2 if kind == "cylinder" else 0.3)


def solids(numbers):
    """Returns solids at random places that are not too near to each other."""
    count = numbers.choice([2, 3, 4, 8, 15, 30])
    centers, result = [], []
    while len(result) < count:
        center = numbers.uniform(0, count ** (1 / 3), 3)
        if all(np.linalg.norm(center - c) > 0.45 for c in centers):
            centers.append(center)
            points, triangles = solid(numbers)
            turn = cad_solids.rotation(numbers) if numbers.random() < 0.7 else np.eye(3)
            result.append(cad_solids.moved((points - np.mean(points, 0), triangles), turn, center))
    return result


def text(numbers):
    """Returns a plate and letters in a row, in random order."""
    count, thickness = numbers.integers(1, 9), 0.3
    depth = numbers.choice([0, 0.1, 1 / 7, 0.3, 0.4])  # of the letters in the plate
    height = numbers.choice([0.2, 0.3, 0.5]) if depth < 0.4 else 0.5
    turn = cad_solids.rotation(numbers) if numbers.random() < 0.5 else np.eye(3)
    plate = cad_solids.divided_box((-0.2, -0.2, 0), (1.1 * count + 0.2, 1.2, thickness), numbers.integers(1, 7, 3), numbers)
    result, common = [cad_solids.moved(plate, turn)], [None]
    for i, name in enumerate(numbers.choice(list(cad_solids.LETTERS), count)):
        low, high = max(0, thickness - depth), min(thickness, thickness - depth + height)
        place, place_of_common = (1.1 * i, 0, thickness - depth), (1.1 * i, 0, low)
        result.append(cad_solids.moved(cad_solids.letter(name, height), turn, turn @ place))
        inside = cad_solids.moved(cad_solids.letter(name, max(high - low, 0)), turn, turn @ place_of_common)
        common.append(cad_solids.moments(inside))
    moments, order = [cad_solids.moments(s) for s in result], numbers.permutation(count + 1).tolist()
    for i in range(1, count + 1):
        is_inside = common[i][0] > 0.999 * moments[i][0]
        moments[0 if is_inside or order.index(i) > order.index(0) else i] -= common[i]
    return solid_sets.Set([(f"{k}.off", [result[i]]) for k, i in enumerate(order)], [moments[i] for i in order])


def expected(peer, form, solid_set):
    """Returns a set with the moments that the peer computes for its files, or `None`."""
    with tempfile.TemporaryDirectory() as folder:
        paths = solid_set.write(pathlib.Path(folder), form)
        done = subprocess.run([peer, *paths], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None
    solid_set.expected = [np.array(line.split(), float) for line in done.stdout.splitlines()]
    return solid_set


def main():
    parser = solid_sets.parser(__doc__)
    parser.add_argument("kind", choices=["solids", "text"])
    parser.add_argument("--peer", help="the program boolean_volumes, for solids")
    arguments = parser.parse_args()
    if arguments.kind == "solids" and not arguments.peer:
        parser.error("solids need a --peer")

    def make(number):
        numbers = np.random.default_rng(number)
        if arguments.kind == "text":
            return text(numbers)
        return expected(arguments.peer, arguments.format, solid_sets.separate(solids(numbers)))

    sys.exit(not solid_sets.check(arguments.kind, make, arguments))


if __name__ == "__main__":
    main()
