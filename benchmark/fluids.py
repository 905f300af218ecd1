#!/usr/bin/env python3
"""Compares scenes of `dsc fluid` with exact solutions and prints a row of a table for each.

Usage: fluids.py DSC [PART...], of droplets, decay, waves, sloshing, dam. Scenes are those of the
program with the changes that the rows name.
"""

import cmath
import json
import math
import os
import subprocess
import sys
import tempfile


def run(dsc, name, change):
    """The steps that the program reports of one of its scenes, changed."""
    scene = json.loads(subprocess.check_output([dsc, "fluid", "--print", name]))
    change(scene)
    with tempfile.TemporaryDirectory() as folder:
        files = [os.path.join(folder, f) for f in ("scene.json", "report.json")]
        with open(files[0], "w") as out:
            json.dump(scene, out)
        subprocess.run([dsc, "fluid", files[0], "--report", files[1], "--quiet"], check=True)
        with open(files[1]) as report:
            return json.load(report)["steps"]


def solve(matrix, right):
    n = len(right)
    rows = [list(matrix[i]) + [right[i]] for i in range(n)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(i + 1, n):
            factor = rows[k][i] / rows[i][i]
            rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    x = [0] * n
    for i in reversed(range(n)):
        x[i] = (rows[i][n] - sum(rows[i][j] * x[j] for j in range(i + 1, n))) / rows[i][i]
    return x


def damped_oscillation(times, values, frequency):
    """Frequency and rate of decay of exp(-g t) cos(w t + phase) + c, by least squares."""

    def residual(w, g):
        base = [(math.exp(-g * t) * math.cos(w * t), math.exp(-g * t) * math.sin(w * t), 1)
                for t in times]
        x = solve([[sum(b[i] * b[j] for b in base) for j in range(3)] for i in range(3)],
                  [sum(b[i] * v for b, v in zip(base, values)) for i in range(3)])
        return sum((sum(a * c for a, c in zip(x, b)) - v) ** 2 for b, v in zip(base, values))

    w, g, dw, dg = frequency, 0, frequency / 4, frequency / 20
    while dw > 1e-7 * frequency:
        w, g = min(((w + i * dw / 3, g + j * dg / 3) for i in range(-3, 4) for j in range(-3, 4)),
                   key=lambda x: residual(*x))
        dw, dg = dw * .6, dg * .6
    return w, g


def droplet(dsc, mode, triangles, viscosity, periods, steps):
    frequency = math.sqrt(mode * (mode - 1) * (mode + 2))
    period = 2 * math.pi / frequency

    def change(scene):
        shape = scene["liquids"][0]["shape"]
        shape["mode"], shape["triangles"] = mode, triangles
        scene["liquids"][0]["viscosity"] = viscosity
        scene["probes"][0]["mode"] = mode
        scene["time_step"], scene["end"] = period / steps, periods * period

    found = run(dsc, "droplet", change)
    w, g = damped_oscillation([s["time"] for s in found], [s["probes"]["amplitude"] for s in found],
                              frequency)
    volumes = [s["volume"] for s in found]
    seconds = sum(s.get("seconds_of_solver", 0) + s.get("seconds_of_mesh", 0) for s in found)
    return (frequency, w, g, max(abs(v / volumes[0] - 1) for v in volumes),
            max(s["vertices"] for s in found), seconds / (len(found) - 1))


def droplets(dsc):
    print("| mode | triangles | vertices | frequency | error (%) | amplitude lost a period (%) | "
          "volume | seconds a step |")
    print("| --- " * 8 + "|")
    for mode in (2, 3, 4):
        for triangles in (320, 1280, 5120):
            exact, w, g, volume, vertices, seconds = droplet(dsc, mode, triangles, 0, 3, 45)
            print(f"| {mode} | {triangles} | {vertices} | {w:.5f} | {100 * (w / exact - 1):.2f} | "
                  f"{100 * (1 - math.exp(-g * 2 * math.pi / w)):.2f} | {volume:.1e} | {seconds:.2f} |",
                  flush=True)


def decay(dsc):
    print("| viscosity | rate of decay | exact | error (%) |")
    print("| --- " * 4 + "|")
    for viscosity, exact in ((.01, .0474), (.05, .2187)):  # S. Chandrasekhar
        g = droplet(dsc, 2, 1280, viscosity, 3, 45)[2]
        print(f"| {viscosity} | {g:.4f} | {exact} | {100 * (g / exact - 1):.1f} |", flush=True)


def erfc(z):
    if z.real < 0:
        return 2 - erfc(-z)
    if abs(z) < 4:
        term = total = z
        for n in range(1, 200):
            term *= -z * z / n
            total += term / (2 * n + 1)
        return 1 - 2 / math.sqrt(math.pi) * total
    fraction = 0
    for n in range(100, 0, -1):
        fraction = n / 2 / (z + fraction)
    return cmath.exp(-z * z) / math.sqrt(math.pi) / (z + fraction)


def prosperetti(viscosity, t):
    """A. Prosperetti, Phys. Fluids 24, 1981: a free surface of a deep liquid; wave length, density
    and tension 1."""
    k = 2 * math.pi
    square, rate = k ** 3, viscosity * k * k
    coefficients = [1, 0, 2 * rate, 4 * rate ** 1.5, rate * rate + square]
    roots = [complex(math.cos(a), math.sin(a)) * math.sqrt(math.sqrt(square)) for a in (.7, 2.3, 3.9, 5.5)]
    for _ in range(200):  # by Weierstrass
        for i in range(4):
            value = 0
            for c in coefficients:
                value = value * roots[i] + c
            for j in range(4):
                if j != i:
                    value /= roots[i] - roots[j]
            roots[i] -= value
    result = 4 * rate * rate / (8 * rate * rate + square) * math.erfc(math.sqrt(rate * t))
    for i, z in enumerate(roots):
        others = 1
        for j in range(4):
            if j != i:
                others *= roots[j] - z
        result += (z / others * square / (z * z - rate) *
                   cmath.exp((z * z - rate) * t) * erfc(z * math.sqrt(t))).real
    return result


def waves(dsc):
    print("| viscosity | points a wave | error of the amplitude, RMS | Basilisk's |")
    print("| --- " * 4 + "|")
    for viscosity in (.01, .001):
        for points, basilisk in ((8, .139), (16, .024), (32, .0064)):

            def change(scene):
                edge = 1 / points
                scene["edge"] = edge
                scene["domain"] = [0, 0, 0, .5, edge, 2]
                scene["liquids"][0]["shape"]["level"] = 1.5
                scene["liquids"][0]["shape"]["height"] = "1.5+0.01*cos(2*pi*x)"
                scene["liquids"][0]["viscosity"] = viscosity
                scene["end"] = 25 / (2 * math.pi) ** 1.5
                scene["time_step"] = scene["end"] / (16 * points)

            found = run(dsc, "capillary-wave", change)
            errors = [(s["probes"]["height"] - 1.5) / .01 - prosperetti(viscosity, s["time"])
                      for s in found[1:]]
            error = math.sqrt(sum(e * e for e in errors) / len(errors))
            print(f"| {viscosity} | {points} | {error:.4f} | {basilisk} |", flush=True)


def sloshing(dsc):
    exact = 2 * math.pi / math.sqrt(math.pi * math.tanh(math.pi / 2))
    print("| cubes | period | exact | error (%) |")
    print("| --- " * 4 + "|")
    for n in (12, 24):

        def change(scene):
            scene["edge"] = 1 / n
            scene["time_step"] = exact / 60

        found = run(dsc, "sloshing", change)
        w, _ = damped_oscillation([s["time"] for s in found], [s["probes"]["height"] for s in found],
                                  2 * math.pi / exact)
        period = 2 * math.pi / w
        print(f"| {n}³ | {period:.4f} | {exact:.4f} | {100 * (period / exact - 1):.2f} |", flush=True)


# J. C. Martin and W. J. Moyce, 1952, for columns twice as high as wide: T and Z.
MARTIN_MOYCE = [(1.19, 1.44), (1.43, 1.67), (1.63, 1.89), (1.83, 2.11), (1.98, 2.33), (2.20, 2.56),
                (2.32, 2.78), (2.51, 3.00), (2.65, 3.22), (2.83, 3.44), (2.98, 3.67), (3.11, 3.89),
                (3.33, 4.11)]


def dam(dsc):
    found = run(dsc, "dam-break", lambda scene: None)
    front = [(math.sqrt(2) * s["time"], s["extent"][1][0]) for s in found]

    def between(points, x):
        for (a, fa), (b, fb) in zip(points, points[1:]):
            if a <= x <= b:
                return fa + (fb - fa) * (x - a) / (b - a)
        return math.nan

    shift = MARTIN_MOYCE[0][0] - between([(z, t) for t, z in front], MARTIN_MOYCE[0][1])
    print("| T | front, measured by Martin and Moyce | computed | difference (%) |")
    print("| --- " * 4 + "|")
    for t, z in MARTIN_MOYCE:
        computed = between(front, t - shift)
        print(f"| {t} | {z} | {computed:.3f} | {100 * (computed / z - 1):.1f} |", flush=True)


def main():
    parts = {"droplets": droplets, "decay": decay, "waves": waves, "sloshing": sloshing, "dam": dam}
    for part in sys.argv[2:] or parts:
        parts[part](sys.argv[1])
        print()


if __name__ == "__main__":
    main()
