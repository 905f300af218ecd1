#!/usr/bin/env python3
"""Compares rotations by `dsc` in one step with exact ones.

Usage: benchmark/turns.py DSC [FILE...] [--number N] [--seed N]

Turns the surfaces of the files and N random solids about random axes by random angles, and a ball by a
velocity field. Prints a line for each kind. The vertices between the labels 0 and 1 are compared with
those that numpy turns.
"""

import argparse
import math
import os
import subprocess
import tempfile

import cad_solids
import numpy
from thin_parts import generator, read_mesh


def rotation(axis, angle):
    """Returns the matrix of a rotation about an axis through the origin."""
    x, y, z = numpy.array(axis) / numpy.linalg.norm(axis)
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def error_of_turn(program, arguments, axis, angle, center=None):
    """Returns the largest distance of an interface vertex from its exact place, in sides of the box.

    It is infinite if the program fails or the number of vertices changes.
    """
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, *arguments, "--steps", "1", "--output", folder + "/out"],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print(done.stderr.strip())
            return math.inf
        meshes = [read_mesh(f"{folder}/out/volume_{i:06}.vtu") for i in (0, 1)]
    before, after = (points[numpy.intersect1d(cells[labels == 0], cells[labels == 1])]
                     for points, cells, labels in meshes)
    low, high = meshes[0][0].min(0), meshes[0][0].max(0)
    if center is None:
        center = (low + high) / 2
    exact = (before - center) @ rotation(axis, angle).T + center
    if len(exact) != len(after):
        return math.inf
    nearest = [numpy.linalg.norm(after - p, axis=1).min() for p in exact]
    return max(nearest) / (high - low).max()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("files", nargs="*")
    parser.add_argument("--number", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()

    def worst(surfaces):
        errors = []
        for path, random_ in surfaces:
            axis = [random_.uniform(-1, 1) for _ in range(3)]
            degrees = random_.uniform(0, 2000)
            errors.append((error_of_turn(
                arguments.program,
                ["rotate", path, f"--axis={axis[0]},{axis[1]},{axis[2]}", f"--angle={degrees!r}"],
                axis, math.radians(degrees)), path, degrees))
        return len(errors), max(errors, default=(0.0,))

    def random_solids(folder):
        for index in range(arguments.number):
            random_, thickness = generator(arguments.seed, index)
            surface = (cad_solids.random_blocks(random_, thickness).surface() if random_.random() < 0.5
                       else cad_solids.extruded(*cad_solids.random_plate(random_, thickness)))
            path = os.path.join(folder, f"{index}.off")
            cad_solids.write_off(path, surface)
            yield path, random_

    print("| input | turns | largest error, in sides of the box |")
    print("| --- | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        number, error = worst(random_solids(folder))
        print(f"| random solids, seed {arguments.seed} | {number} | {error[0]:.2g} |")
    for path in arguments.files:
        number, error = worst((path, generator(arguments.seed, i)[0]) for i in range(20))
        print(f"| {os.path.basename(path)} | {number} | {error[0]:.2g} |")
    ball = ["advect", "(x-.4)^2+y^2+z^2<.09", "--domain=-1,-1,-1,1,1,1", "--velocity=-y,x,0", "--dt=2"]
    error = error_of_turn(arguments.program, ball, (0, 0, 1), 2, numpy.zeros(3))
    print(f"| a ball, `advect` by 2 radians | 1 | {error:.2g} |")


if __name__ == "__main__":
    main()
