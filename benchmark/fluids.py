#!/usr/bin/env python3
"""Compares scenes of `dsc fluid` with exact solutions and prints a row of a table for each.

Usage: benchmark/fluids.py DSC [--data DIR] [PART...]

The part `solvers` also runs `mpirun` if the program dsc-fluid-petsc is built.

The parts are droplets, decay, rest, waves, jets, sessile, sloshing, dam, bubble, breathing, figures,
speed, solvers, subdivision, survival, layers, vortices, spin, floating, stokes, wheel, utube, flux, bubble_2
and marangoni.
Runs all parts by default. The scenes are scenes of the program with the changes that the rows name. The
part `figures` needs the meshes bunny00.off and armadillo.off of CGAL in DIR.
"""

import cmath
import json
import math
import os
import subprocess
import sys
import tempfile


data = "."


def run(dsc, name, change):
    """Returns the reported steps of a scene of the program after `change(scene)`. If the run ends with
    an error, the program prints the error, and the steps before the error are returned."""
    scene = json.loads(subprocess.check_output([dsc, "fluid", "--print", name]))
    change(scene)
    return report_of(dsc, scene, name)["steps"]


def report_of(dsc, scene, name, prefix=(), options=()):
    """Returns the report of a run of `scene`. The words of `prefix` precede the command."""
    with tempfile.TemporaryDirectory() as folder:
        files = [os.path.join(folder, f) for f in ("scene.json", "report.json")]
        with open(files[0], "w") as out:
            json.dump(scene, out)
        folder_of_files = ["--data", data] if '"file"' in json.dumps(scene) else []
        subprocess.run([*prefix, dsc, "fluid", files[0], "--report", files[1], "--quiet"] + folder_of_files +
                       list(options))
        if not os.path.exists(files[1]):
            sys.exit(f"the scene {name} did not begin")
        with open(files[1]) as report:
            return json.load(report)


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
    """Returns the frequency and the decay rate of exp(-g t) cos(w t + phase) + c, by least squares."""

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
    """Returns the exact solution for the free surface of a deep liquid (A. Prosperetti, Phys. Fluids 24,
    1981). Wave length, density and surface tension are 1."""
    k = 2 * math.pi
    square, rate = k ** 3, viscosity * k * k
    coefficients = [1, 0, 2 * rate, 4 * rate ** 1.5, rate * rate + square]
    roots = [complex(math.cos(a), math.sin(a)) * math.sqrt(math.sqrt(square)) for a in (.7, 2.3, 3.9, 5.5)]
    for _ in range(200):  # roots by the method of Weierstrass
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


# Measurements T and Z of J. C. Martin and W. J. Moyce, 1952, for columns twice as high as wide.
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


def greatest(steps, field):
    return max(step[field] for step in steps[1:])


def relative_change(values):
    return max(abs(v / values[0] - 1) for v in values)


def spinning_extents(time):
    """Returns the radii, across and along the axis, of a ball of liquid without surface tension that
    rotates with the angular velocity 1. It becomes an ellipsoid, and its motion is linear in space
    (Dirichlet)."""

    def multiply(a, b):
        return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]

    def inverse(a):
        rows = [solve(a, [float(i == j) for i in range(3)]) for j in range(3)]
        return [[rows[j][i] for j in range(3)] for i in range(3)]

    def acceleration(f, g):  # the smallest acceleration that preserves the determinant
        h = inverse(f)
        hg = multiply(h, g)
        pressure = (sum(multiply(hg, hg)[i][i] for i in range(3)) /
                    sum(h[i][j] ** 2 for i in range(3) for j in range(3)))
        return [[pressure * h[j][i] for j in range(3)] for i in range(3)]

    def moved(a, b, s):
        return [[a[i][j] + s * b[i][j] for j in range(3)] for i in range(3)]

    f = [[float(i == j) for j in range(3)] for i in range(3)]
    g = [[0., -1., 0.], [1., 0., 0.], [0., 0., 0.]]
    n = 1000
    dt = time / n
    for _ in range(n):  # classical Runge-Kutta method
        k1 = g, acceleration(f, g)
        k2 = moved(g, k1[1], dt / 2), acceleration(moved(f, k1[0], dt / 2), moved(g, k1[1], dt / 2))
        k3 = moved(g, k2[1], dt / 2), acceleration(moved(f, k2[0], dt / 2), moved(g, k2[1], dt / 2))
        k4 = moved(g, k3[1], dt), acceleration(moved(f, k3[0], dt), moved(g, k3[1], dt))
        for k, s in ((k1, 1), (k2, 2), (k3, 2), (k4, 1)):
            f, g = moved(f, k[0], s * dt / 6), moved(g, k[1], s * dt / 6)
    return math.hypot(f[0][0], f[0][1]), f[2][2]


def rest(dsc):
    print("| scene | what | value |")
    print("| --- " * 3 + "|")

    def droplet_scene(scene):
        scene["relaxation"] = {"time_step": 1, "steps": 150}
        scene["end"] = 1

    def tank_scene(scene):
        scene["liquids"][0]["shape"]["to"] = [1, .5, 1]
        scene["solids"][0]["box"] = [0, 0, 0, 1, .5, 2]
        scene["end"] = .4

    def bowl_scene(scene):
        scene["liquids"][0]["shape"] = {"type": "ball", "center": [0, 0, 0], "radius": 1,
                                        "triangles": 1280}
        scene["surface_tension"] = 0
        scene["gravity"] = [0, 0, -1]
        scene["solids"] = [{"type": "ball", "center": [0, 0, 0], "radius": 1, "liquid": "inside",
                            "sticks": True}]
        scene["end"] = 1

    for name, scene, change in (("relaxed drop", "droplet", droplet_scene),
                                ("filled tank", "dam-break", tank_scene),
                                ("filled bowl, sticking", "droplet", bowl_scene)):
        found = run(dsc, scene, change)
        print(f"| {name} | greatest velocity, {len(found) - 1} steps | "
              f"{greatest(found, 'greatest_velocity'):.1e} |", flush=True)

    def fall(scene):
        scene["surface_tension"], scene["gravity"] = 0, [0, 0, -1]
        scene["liquids"][0]["velocity"] = [.1, 0, 0]
        scene["end"] = 1

    found = run(dsc, "droplet", fall)
    way = [b - a for a, b in zip(found[0]["extent"][1], found[-1]["extent"][1])]
    print(f"| free fall for a time of 1 | error of the way | "
          f"{max(abs(way[0] - .1), abs(way[2] + .5)):.1e} |", flush=True)
    found = run(dsc, "spinning", lambda scene: None)
    across, along = spinning_extents(found[-1]["time"])
    for field in ("momentum", "angular_momentum"):
        drift = max(abs(a - b) for s in found for a, b in zip(s[field], found[1][field]))
        print(f"| spinning drop | change of {field.replace('_', ' ')}, of {found[1]['angular_momentum'][2]:.2f} "
              f"| {drift:.1e} |", flush=True)
    print(f"| | error of its radius across the axis, {across:.4f} | "
          f"{found[-1]['extent'][1][0] / across - 1:.4f} |")
    print(f"| | error of its radius along the axis, {along:.4f} | "
          f"{found[-1]['extent'][1][2] / along - 1:.4f} |", flush=True)


def jets(dsc, cases=((.5, .301558, 20), (.697019, .343339, 16))):
    print("| kR | growth | exact | error (%) | drops and what is between them, volumes |")
    print("| --- " * 5 + "|")
    for k, exact, end in cases:
        length = 2 * math.pi / k

        def change(scene):
            shape = scene["liquids"][0]["shape"]
            shape["to"], shape["wave_length"] = [length, 0, 0], length
            scene["domain"][3] = length + 1
            scene["solids"][1]["point"] = [length, 0, 0]
            scene["end"] = end

        found = run(dsc, "jet", change)

        def amplitude(step):  # the largest radius is sqrt(1 - a^2 / 2) + a
            r = (step["extent"][1][1] - step["extent"][0][1]) / 2
            return (r - math.sqrt(max(0, 1.5 - r * r / 2))) / 1.5

        a = [(s["time"], amplitude(s)) for s in found]
        late = next((t, x) for t, x in a if x > 4 * a[0][1])
        growth = math.acosh(late[1] / a[0][1]) / late[0]
        drops = ", ".join(f"{p['volume']:.2f}" for p in found[-1]["parts"])
        print(f"| {k} | {growth:.4f} | {exact} | {100 * (growth / exact - 1):.1f} | {drops} |",
              flush=True)


def sessile(dsc):
    print("| angle | radius of the sphere over that of the ball | exact | error (%) |")
    print("| --- " * 4 + "|")
    for angle, exact in ((60, 1.856636), (90, 1.259921), (120, 1.058267)):

        def change(scene):
            scene["solids"][0]["contact_angle"] = angle

        found = run(dsc, "sessile", change)
        (x0, y0, _), (x1, y1, z1) = found[-1]["extent"]
        half = (x1 - x0 + y1 - y0) / 4
        # The radius R of the cap with this height h and volume V: V = pi h^2 (R - h / 3).
        volume = found[-1]["volume"]
        radius = volume / math.pi / z1 ** 2 + z1 / 3
        ball = (3 * volume / 4 / math.pi) ** (1 / 3)
        print(f"| {angle} | {radius / ball:.4f} | {exact} | {100 * (radius / ball / exact - 1):.2f} |"
              f" half width {half:.3f}, velocity {found[-1]['greatest_velocity']:.1e}", flush=True)


def bubble(dsc):
    found = run(dsc, "bubble", lambda scene: None)
    part = next(p for p in found[-1]["parts"] if p["label"] == 1)
    (x0, y0, z0), (x1, y1, z1) = part["extent"]
    print("| at a time of 3 | computed | Basilisk, axisymmetric | error (%) |")
    print("| --- " * 4 + "|")
    for name, value, reference in (("lowest", z0, 1.324), ("highest", z1, 1.676),
                                   ("radius", (x1 - x0 + y1 - y0) / 4, .2957)):
        print(f"| {name} | {value:.4f} | {reference} | {100 * (value / reference - 1):.1f} |",
              flush=True)


def breathing(dsc):
    found = run(dsc, "breathing", lambda scene: None)
    volumes = [(s["time"], s["gases"][1]["volume"]) for s in found]
    gas, liquid = found[0]["gases"][1], found[0]["volume"]
    # Oscillation about the volume at the ambient pressure, with the mass of a shell (M. Minnaert, 1933).
    rest = gas["volume"] * gas["pressure"] ** (1 / 1.4)
    r, s = (3 * rest / (4 * math.pi)) ** (1 / 3), (3 * (rest + liquid) / (4 * math.pi)) ** (1 / 3)
    exact = math.sqrt(3 * 1.4 / (r * r * (1 - r / s)))
    w, _ = damped_oscillation([t for t, _ in volumes], [v for _, v in volumes], exact)
    energies = [s["energy"] - found[0]["energy"] for s in found]
    kinetic = greatest(found, "kinetic_energy")
    print("| bubble in a ball | frequency | exact, for small amplitudes | error (%) | energy, greatest change, "
          "of the kinetic one (%) |")
    print("| --- " * 5 + "|")
    print(f"| amplitude {volumes[0][1] / rest - 1:.3f} of the volume | {w:.4f} | {exact:.4f} | "
          f"{100 * (w / exact - 1):.2f} | {100 * max(map(abs, energies)) / kinetic:.2f} |", flush=True)


def figures(dsc):
    print("| scene | steps | time | volume, change | energy, greatest rise in a step (%) | momentum, "
          "change | angular momentum, change | correction of velocities over their change | depth in "
          "solids | changes of topology | vertices | seconds a step |")
    print("| --- " * 12 + "|")
    for name in ("bunny", "collision", "bowl", "crown"):
        found = run(dsc, name, lambda scene: None)
        # The first step remeshes before the flow begins.
        rises = [(b["energy"] - a["energy"]) / abs(found[0]["energy"])
                 for a, b in zip(found[1:], found[2:])]
        drifts = [max(abs(a - b) for s in found for a, b in zip(s[field], found[0][field]))
                  for field in ("momentum", "angular_momentum")]
        seconds = sum(s["seconds_of_solver"] + s["seconds_of_mesh"] for s in found[1:])
        correction = max(s["greatest_correction"] / s["greatest_change_of_velocity"]
                         for s in found[1:])
        print(f"| {name} | {len(found) - 1} | {found[-1]['time']:.3g} | "
              f"{relative_change([s['volume'] for s in found]):.1e} | {100 * max(rises):.3f} | "
              f"{drifts[0]:.1e} | {drifts[1]:.1e} | {correction:.4f} | "
              f"{greatest(found, 'depth_in_solids'):.1e} | {sum(len(s['events']) for s in found[1:])} | "
              f"{max(s['vertices'] for s in found)} | {seconds / (len(found) - 1):.2f} |", flush=True)


def solvers(dsc):
    """Compares the built-in solver and PETSc. All reported numbers of the built-in solver must be the same
    with 1 and 2 threads, except the times."""
    variants = [("built-in, 1 thread", [], ["--threads", "1"]),
                ("built-in, 2 threads", [], ["--threads", "2"])]
    if os.path.exists(os.path.join(os.path.dirname(os.path.realpath(dsc)), "dsc-fluid-petsc")):
        mpirun = ["mpirun", "--oversubscribe", "--allow-run-as-root", "-n"]
        variants += [(f"PETSc, processes: {n}", mpirun + [str(n)], ["--solver", "petsc", "--threads", "1"])
                     for n in (1, 2, 4)]

    def without_times(steps):
        return [{k: v for k, v in step.items() if not k.startswith("seconds_")} for step in steps]

    print("| vertices | solver | iterations a step | seconds a step | of the solver | difference of the "
          "amplitude | of the velocity |")
    print("| --- " * 7 + "|")
    for triangles in (480, 1320, 2800, 5200, 12000):  # 1k, 4k, 12k, 30k and 100k vertices
        scene = json.loads(subprocess.check_output([dsc, "fluid", "--print", "droplet"]))
        scene["liquids"][0]["shape"]["triangles"] = triangles
        scene["time_step"] = 2 / triangles ** .75
        scene["end"] = 4 * scene["time_step"]
        first = None
        for name, prefix, options in variants:
            steps = report_of(dsc, scene, "droplet", prefix, options)["steps"]
            first = first or steps
            if not prefix and without_times(steps) != without_times(first):
                sys.exit(f"the number of threads changes the result for {triangles} triangles")
            timed = steps[2:]  # without the initial state and the first step
            n = len(timed)
            solver = sum(s["seconds_of_solver"] for s in timed) / n
            mesh = sum(s["seconds_of_mesh"] for s in timed) / n
            amplitude = max(abs(a["probes"]["amplitude"] / b["probes"]["amplitude"] - 1)
                            for a, b in zip(steps, first))
            velocity = max(abs(a["greatest_velocity"] / b["greatest_velocity"] - 1)
                           for a, b in zip(steps[1:], first[1:]))
            print(f"| {steps[-1]['vertices']} | {name} | {sum(s['iterations'] for s in timed) // n} | "
                  f"{solver + mesh:.2f} | {solver:.2f} | {amplitude:.1e} | {velocity:.1e} |", flush=True)


def subdivision(dsc):
    print("| ball | subdivided | triangles | distance from the sphere, rms over the radius | volume over "
          "that of the sphere |")
    print("| --- " * 5 + "|")

    def one_step(scene):  # a very short step, which gives a complex of the ball
        scene["liquids"][0]["shape"]["amplitude"] = 0
        scene["liquids"][0]["shape"]["triangles"] = triangles
        scene["surface_tension"] = 0
        scene["time_step"] = scene["end"] = 1e-3
        scene["adaptation_interval"] = 0

    for triangles in (320, 1280):
        scene = json.loads(subprocess.check_output([dsc, "fluid", "--print", "droplet"]))
        one_step(scene)
        with tempfile.TemporaryDirectory() as folder:
            file, out = os.path.join(folder, "scene.json"), os.path.join(folder, "run")
            with open(file, "w") as stream:
                json.dump(scene, stream)
            subprocess.run([dsc, "fluid", file, "--quiet", "--output", out], check=True)
            for n in range(3):
                surface = os.path.join(folder, f"ball{n}.off")
                subprocess.run([dsc, "convert", "--quiet", os.path.join(out, "checkpoint.dsc"), surface] +
                               (["--subdivide", str(n)] if n else []), check=True)
                with open(surface) as stream:
                    words = stream.read().split()[1:]
                v, f = int(words[0]), int(words[1])
                points = [tuple(map(float, words[3 + 3 * i:6 + 3 * i])) for i in range(v)]
                first = 3 + 3 * v
                facets = [[points[int(w)] for w in words[first + 4 * i + 1:first + 4 * i + 4]]
                          for i in range(f)]
                volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                             a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in facets) / 6
                error = math.sqrt(sum((math.dist(p, (0, 0, 0)) - 1) ** 2 for p in points) / v)
                print(f"| {triangles} | {n} times | {f} | {error:.5f} | "
                      f"{abs(volume) / (4 / 3 * math.pi):.5f} |", flush=True)


def drop_on_plane(contact_angle, viscosity, tilt=0):
    """Returns the scene of a drop that falls onto a plane, which is tilted by `tilt` degrees."""
    gravity = [2 * math.sin(math.radians(tilt)), 0, -2 * math.cos(math.radians(tilt))]
    plane = {"type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "contact_angle": contact_angle}
    return {"domain": [-1.5, -1.5, -1.5, 4, 1.5, 1.5], "edge": .14,
            "liquids": [{"shape": {"type": "ball", "center": [0, 0, .55], "radius": .5},
                         "density": 1.3, "viscosity": viscosity}],
            "surface_tension": .5, "gravity": gravity, "solids": [plane],
            "time_step": .03, "cfl": .5, "end": 1.2}


def heavy_above_light():
    """Returns the scene of two viscous liquids; the upper one has three times the density."""
    return {"domain": [0, 0, 0, 1, .25, 1.2], "edge": .0625,
            "liquids": [{"shape": {"type": "pool", "level": .5, "height": "0.5+0.004*cos(2*pi*x)"},
                         "density": 1, "viscosity": .003},
                        {"shape": {"type": "surroundings"}, "density": 3, "viscosity": .009}],
            "gravity": [0, 0, -1], "time_step": .077, "end": 4.5}


def vortices(cells):
    """Returns the scene of Taylor-Green vortices with `cells` edges per unit of length."""
    velocity = "sin(pi*x)*cos(pi*z),0,-cos(pi*x)*sin(pi*z)"
    liquid = {"density": 1, "viscosity": 0, "velocity": velocity}
    return {"domain": [0, 0, 0, 1, 3 / cells, 2], "edge": 1 / cells,
            "liquids": [dict(liquid, shape={"type": "pool", "level": 1}),
                        dict(liquid, shape={"type": "surroundings"})],
            "time_step": .48 / cells, "cfl": .4, "end": 1}


def two_layers(cells, density, amplitude, steps_per_time, end):
    """Returns the scene of two liquids in a box, with a wave on their interface. The lower liquid has the
    density 1. There are `cells` edges per unit of length, which is also the length of the wave."""
    depth = max(.25, 2 / cells)
    return {"domain": [0, 0, 0, 1, depth, 1.2], "edge": 1 / cells,
            "liquids": [{"shape": {"type": "pool", "level": .5, "height": f"0.5+{amplitude}*cos(2*pi*x)"},
                         "density": 1},
                        {"shape": {"type": "surroundings"}, "density": density}],
            "gravity": [0, 0, -1], "interface_tolerance": 0,
            "probes": [{"name": "crest", "height_at": [0, depth / 2]},
                       {"name": "trough", "height_at": [.5, depth / 2]}],
            "time_step": 1 / steps_per_time, "end": end}


def layers(dsc):
    """Prints the frequencies and growth rates of waves between two liquids. They are those of layers of
    heights .5 and .7: omega^2 (rho coth(k h) + rho' coth(k h')) = g k (rho - rho')."""
    print("| density above | cells | vertices | rate | exact | error (%) |")
    print("| --- " * 6 + "|")
    k = 2 * math.pi
    for density in (.5, .001, 3):
        square = k * (1 - density) / (1 / math.tanh(k * .5) + density / math.tanh(k * .7))
        exact = math.sqrt(abs(square))
        for cells in (8, 16, 32):
            periods = 3.2 * 2 * math.pi / exact
            scene = (two_layers(cells, density, .004, 15 * exact, periods) if square > 0 else
                     two_layers(cells, density, .001, 12, 2.2 / exact))
            found = report_of(dsc, scene, f"two layers, {density}")["steps"]
            times = [s["time"] for s in found]
            heights = [(s["probes"]["crest"] - s["probes"]["trough"]) / 2 for s in found]
            rate = (damped_oscillation(times, heights, exact)[0] if square > 0 else
                    math.acosh(heights[-1] / heights[0]) / times[-1])
            print(f"| {density} | {cells} | {found[-1]['vertices']} | {rate:.4f} | {exact:.4f} | "
                  f"{100 * (rate / exact - 1):.2f} |", flush=True)


def decay_of_vortices(dsc):
    """Prints the energy of Taylor-Green vortices after the first step and at the time 1."""
    print("| viscosity | cells | vertices | energy over the exact one | error (%) |")
    print("| --- " * 5 + "|")
    for viscosity in (0, .01):
        for cells in (12, 24):
            scene = vortices(cells)
            for liquid in scene["liquids"]:
                liquid["viscosity"] = viscosity
            found = report_of(dsc, scene, "vortices")["steps"]
            exact = math.exp(-4 * math.pi ** 2 * viscosity * (found[-1]["time"] - found[1]["time"]))
            ratio = found[-1]["kinetic_energy"] / found[1]["kinetic_energy"] / exact
            print(f"| {viscosity} | {cells} | {found[-1]['vertices']} | {ratio:.4f} | "
                  f"{100 * (ratio - 1):.2f} |", flush=True)


def spin(dsc):
    """Prints the changes of angular momentum at slip walls, and velocities at rest."""
    print("| scene | time step | what | value |")
    print("| --- " * 4 + "|")
    cylinder = {"type": "cylinder", "point": [0, 0, 0], "axis": [0, 0, 1], "radius": .5, "liquid": "inside",
                "separates": False}
    floor = {"type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "separates": False}
    for dt in (.02, .005):
        scene = {"domain": [-.8, -.8, -.2, .8, .8, 1.2], "edge": .1,
                 "liquids": [{"shape": {"type": "cylinder", "from": [0, 0, 0], "to": [0, 0, .5],
                                        "radius": .5},
                              "density": 1, "velocity": "-2*y,2*x,0"}],
                 "gravity": [0, 0, -2], "solids": [cylinder, floor], "time_step": dt, "end": .6}
        found = report_of(dsc, scene, "cylinder")["steps"]
        change = found[-1]["angular_momentum"][2] / found[1]["angular_momentum"][2] - 1
        print(f"| cylinder | {dt} | angular momentum, change in .6 | {change:.1e} |", flush=True)
    bowl = {"type": "ball", "center": [0, 0, 0], "radius": 1, "liquid": "inside", "separates": False}
    for gravity, velocity in ((-1, "0,0,0"), (0, "-y,x,0")):
        scene = {"domain": [-1.5, -1.5, -1.5, 1.5, 1.5, 1.5], "edge": .17,
                 "liquids": [{"shape": {"type": "ball", "center": [0, 0, 0], "radius": 1, "triangles": 1280},
                              "density": 1, "velocity": velocity}],
                 "gravity": [0, 0, gravity], "solids": [bowl], "time_step": .02, "end": .6}
        found = report_of(dsc, scene, "bowl")["steps"]
        if gravity:
            print(f"| full bowl | .02 | greatest velocity under gravity | "
                  f"{greatest(found, 'greatest_velocity'):.1e} |", flush=True)
        else:
            change = found[-1]["angular_momentum"][2] / found[1]["angular_momentum"][2] - 1
            print(f"| full bowl | .02 | angular momentum, change in .6 | {change:.1e} |", flush=True)


def heave_period(n):
    """Returns the period of the slowest symmetric wave in a tank of width 2 and depth 1, with a box in its
    middle. The box has the width 1, the density .5 and the draught .3, and moves up and down. Gravity is 1.

    Bilinear finite elements on square cells of size 1/`n` discretize the potential in half of the tank. `n`
    is a multiple of 10. The unknowns of the waves are the displacements of the surface and of the box. The
    inverse iteration solves K q' = M q, with the potential energy K and the kinetic energy M."""
    left, bottom, rows = n // 2, 7 * n // 10, n + 1
    size, band = rows * rows, n + 3
    matrix = [[0.] * band for _ in range(size)]  # the lower half; the last entry is on the diagonal
    for i in range(n):
        for j in range(n):
            if i >= left or j < bottom:
                corners = [(i + a) * rows + j + b for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                for a in range(4):
                    for b in range(4):
                        if corners[b] <= corners[a]:
                            value = (2 / 3, -1 / 6, -1 / 3, -1 / 6)[(a - b) % 4]
                            matrix[corners[a]][band - 1 + corners[b] - corners[a]] += value
    matrix[0][-1] += 1  # determines the constant of the potential
    for k, row in enumerate(matrix):  # Cholesky factorization
        row[-1] = row[-1] or 1  # a point in the box
        for c in range(max(0, k - band + 1), k + 1):
            d = band - 1 + c - k
            value = row[d] - sum(map(float.__mul__, row[:d], matrix[c][band - 1 - d:-1]))
            row[d] = math.sqrt(value) if c == k else value / matrix[c][-1]

    def potential(flux):
        x = list(flux)
        for k, row in enumerate(matrix):
            first = max(0, k - band + 1)
            x[k] = (x[k] - sum(map(float.__mul__, row[band - 1 + first - k:-1], x[first:k]))) / row[-1]
        for k in reversed(range(size)):
            row, first = matrix[k], max(0, k - band + 1)
            x[k] /= row[-1]
            for c in range(first, k):
                x[c] -= row[band - 1 + c - k] * x[k]
        return x

    surface = [i * rows + n for i in range(left, n + 1)]
    below = [i * rows + bottom for i in range(left + 1)]
    lengths = [(.5 if k in (0, left) else 1.) / n for k in range(left + 1)]
    mass, width, box, waves = .15, .5, 1., [-1.] * (left + 1)
    for _ in range(40):
        flux = [0.] * size
        for k in range(left + 1):
            flux[surface[k]] += sum((2 if i == k else .5) * waves[i] / 3 / n * (
                1 if i != k or 0 < k < left else .5) for i in (k - 1, k, k + 1) if 0 <= i <= left)
            flux[below[k]] += box * lengths[k]
        p = potential(flux)
        heave = (sum(p[v] * l for v, l in zip(below, lengths)) + mass * box) / width
        lift = [p[v] for v in surface]
        mean = heave * width + sum(a * l for a, l in zip(lift, lengths))  # volumes are preserved
        inverse = (heave - mean) / box
        box, waves = 1., [(a - mean) / (heave - mean) for a in lift]
    return 2 * math.pi * math.sqrt(inverse)


def floating(dsc):
    """Prints the draught of a floating box and its period."""
    coarse, fine = heave_period(20), heave_period(40)
    # The potential has a singularity at the corners of the box: eigenvalues have the order 4/3.
    exact = fine - (coarse - fine) / (2 ** (4 / 3) - 1)
    print("| edge | vertices | at rest: drift of the box in a period | draught, mean of a period | of "
          "Archimedes | error (%) | period | linear waves | error (%) |")
    print("| --- " * 9 + "|")
    for edge in (.1, .05, .025):

        def steps_of(draught, periods):
            def change(scene):
                scene["domain"], scene["edge"] = [0, 0, 2, 2], edge
                scene["solids"][0].update({"from": [.5, 1 - draught], "to": [1.5, 1.6 - draught]})
                scene["time_step"], scene["cfl"], scene["end"] = exact / 60, 0, periods * exact
                scene["probes"] = []

            return run(dsc, "floating-box", change)

        def heights(found):
            return [s["bodies"][0]["center"][1] for s in found]

        at_rest = heights(steps_of(.3, 1))
        drift = max(abs(y - at_rest[0]) for y in at_rest)
        found = steps_of(.28, 3)
        y = heights(found)
        w, _ = damped_oscillation([s["time"] for s in found], y, 2 * math.pi / exact)
        period = 2 * math.pi / w
        # Below the mean level, the tank of width 2 contains the liquid, of area 1.72, and the wetted part of
        # the box of width 1, the draught. The level is the bottom of the box plus the draught.
        last = y[-60:]
        draught = 1.72 - 2 * (sum(last) / len(last) - .3)
        print(f"| {edge} | {found[-1]['vertices']} | {drift:.1e} | {draught:.5f} | .3 | "
              f"{100 * (draught / .3 - 1):.2f} | {period:.4f} | {exact:.4f} | "
              f"{100 * (period / exact - 1):.2f} |", flush=True)


def wall_factor(ratio):
    """Returns the drag of a ball on the axis of a cylinder over that of a ball far from walls, for slow flow
    (W. L. Haberman and R. M. Sayre, 1958). `ratio` is the radius of the ball over that of the cylinder."""
    return ((1 - .75857 * ratio ** 5) /
            (1 - 2.1050 * ratio + 2.0865 * ratio ** 3 - 1.7068 * ratio ** 5 + .72603 * ratio ** 6))


def stokes(dsc, edges=(.2, .13, .1)):
    """Prints the velocity of a ball that sinks in a viscous liquid."""
    exact = 2 / 9 * (2 - 1) * 10 * .3 ** 2 / 1 / wall_factor(.3)
    print("| edge | vertices | velocity at a time of .5 | at 1 | Stokes, Haberman and Sayre | error at 1 (%) |")
    print("| --- " * 6 + "|")
    for edge in edges:

        def change(scene):
            scene["edge"], scene["end"] = edge, 1

        found = run(dsc, "falling-ball", change)

        def velocity(time):
            step = min(found, key=lambda s: abs(s["time"] - time))
            return -step["bodies"][0]["velocity"][2]

        print(f"| {edge} | {found[-1]['vertices']} | {velocity(.5):.5f} | {velocity(1):.5f} | "
              f"{exact:.5f} | {100 * (velocity(1) / exact - 1):.1f} |", flush=True)


def wheel(dsc):
    """Prints the torques of Couette flow on a tank of radius 1 and on a wheel of radius .5 in it."""
    exact = 4 * math.pi * .5 ** 2 / (1 - .5 ** 2)
    print("| edge | vertices | torque on the tank | on the wheel | Couette | errors (%) |")
    print("| --- " * 6 + "|")
    for edge in (.1, .05):

        def change(scene):
            scene["edge"] = edge

        found = run(dsc, "wheel", change)
        torques = [torque[2] for torque in found[-1]["torques_on_solids"]]
        print(f"| {edge} | {found[-1]['vertices']} | {torques[0]:.4f} | {torques[1]:.4f} | {exact:.4f} | "
              f"{100 * (torques[0] / exact - 1):.2f}, {100 * (-torques[1] / exact - 1):.2f} |", flush=True)


def utube(dsc):
    """Prints the period of water in a tube of width .2 with two arms. A straight part of the tube has the
    inertia of its length. By conformal mapping, the potential flow through a square corner has the inertia
    of 1 - 2 log(2) / pi widths of the tube."""
    width, level, gap, rise = .2, 2, .6, .01
    length = 2 * (level - width) + gap + 2 * width * (1 - 2 * math.log(2) / math.pi)
    exact = 2 * math.pi * math.sqrt(length / 2)
    print("| edge | vertices | period | potential flow | error (%) | amplitude lost a period (%) |")
    print("| --- " * 6 + "|")
    for edge in (.1, .05, .025):

        def change(scene):
            right = width + gap
            scene["domain"], scene["edge"] = [-.5, -.5, right + width + .5, 4], edge
            for liquid, corners in zip(scene["liquids"], (
                    ([0, width], [width, level + rise]), ([0, 0], [right + width, width]),
                    ([right, width], [right + width, level - rise]))):
                liquid["shape"].update({"from": corners[0], "to": corners[1]})
            scene["solids"][0]["box"] = [0, 0, right + width, 3.5]
            scene["solids"][1].update({"from": [width, width], "to": [right, 3.5]})
            scene["probes"] = [{"name": "left", "height_at": width / 2},
                               {"name": "right", "height_at": right + width / 2}]
            scene["time_step"], scene["cfl"], scene["end"] = exact / 60, 0, 2 * exact

        found = run(dsc, "u-tube", change)
        heights = [s["probes"]["left"] - s["probes"]["right"] for s in found]
        w, g = damped_oscillation([s["time"] for s in found], heights, 2 * math.pi / exact)
        period = 2 * math.pi / w
        print(f"| {edge} | {found[-1]['vertices']} | {period:.4f} | {exact:.4f} | "
              f"{100 * (period / exact - 1):.2f} | {100 * (1 - math.exp(-g * period)):.2f} |", flush=True)


def flux(dsc):
    """Prints the error of the volume that a source adds. The flux acts at the midpoint of each step."""
    found = run(dsc, "filling", lambda scene: None)
    volume, error = found[0]["volume"], 0
    for step in found[1:]:
        volume += step["dt"] * .2 * (1 - math.cos(math.pi * (step["time"] - step["dt"] / 2)))
        error = max(error, abs(step["volume"] / volume - 1))
    print("| steps | volume, first and last | error of the volume, greatest of all steps, relative |")
    print("| --- " * 3 + "|")
    print(f"| {len(found) - 1} | {found[0]['volume']:.4f}, {found[-1]['volume']:.4f} | {error:.1e} |", flush=True)


def bubble_2(dsc):
    """Prints the first benchmark of S. Hysing and others, with the values of TP2D and edges of 1/320."""
    print("| edge | time step | vertices | least circularity, time | error (%) | greatest velocity, time | "
          "error (%) | center at 3 | error (%) |")
    print("| --- " * 9 + "|")
    for edge, time_step in ((.05, .02), (.025, .01)):

        def change(scene):
            scene["edge"], scene["time_step"] = edge, time_step

        found = run(dsc, "rising-bubble", change)
        roundness, when_round = min((s["probes"]["circularity"], s["time"]) for s in found)
        speed, when_fast = max((s["probes"]["velocity"][1], s["time"]) for s in found)
        center = found[-1]["probes"]["center"][1]
        print(f"| {edge} | {time_step} | {found[-1]['vertices']} | {roundness:.4f}, {when_round:.2f} | "
              f"{100 * (roundness / .9013 - 1):.2f} | {speed:.4f}, {when_fast:.2f} | "
              f"{100 * (speed / .2417 - 1):.2f} | {center:.4f} | {100 * (center / 1.0813 - 1):.2f} |",
              flush=True)


def filaments(dsc):
    """Prints the second benchmark of S. Hysing and others. The codes of the benchmark find greatest
    velocities of .250 to .252 and centers of 1.125 to 1.138. They disagree once filaments break."""
    print("| edge | time step | end | vertices | greatest velocity, time | center at the end | parts of the bubble | "
          "area, change | steps repeated | seconds |")
    print("| --- " * 10 + "|")
    for edge, time_step in ((.05, .02), (.025, .01)):
        scene = json.loads(subprocess.check_output([dsc, "fluid", "--print", "rising-bubble"]))
        scene["edge"], scene["time_step"], scene["surface_tension"] = edge, time_step, 1.96
        scene["liquids"][0].update({"density": 1, "viscosity": .1})
        report = report_of(dsc, scene, "rising-bubble")
        steps = report["steps"]
        speed, when = max((s["probes"]["velocity"][1], s["time"]) for s in steps)
        parts = [part["volume"] for part in steps[-1]["parts"] if part["label"] == 1]
        first = sum(part["volume"] for part in steps[0]["parts"] if part["label"] == 1)
        seconds = sum(s["seconds_of_solver"] + s["seconds_of_mesh"] for s in steps[1:])
        print(f"| {edge} | {time_step} | {steps[-1]['time']:.4g} of {scene['end']} | {steps[-1]['vertices']} | "
              f"{speed:.4f}, {when:.2f} | {steps[-1]['probes']['center'][1]:.4f} | {len(parts)} | "
              f"{abs(sum(parts) / first - 1):.1e} | {report['repeated']['steps']} | {seconds:.0f} |", flush=True)


def marangoni_drop(edge, half_side):
    """Returns a scene of a drop of radius 1 in a liquid of the same viscosity and diffusivity, with a
    gradient of the temperature of 1. Inertia is small."""
    box = [-half_side] * 3 + [half_side] * 3
    liquid = {"density": 1, "viscosity": 10}
    return {"domain": box, "edge": edge,
            "liquids": [{"shape": {"type": "ball", "center": [0, 0, 0], "radius": 1}, **liquid},
                        {"shape": {"type": "surroundings"}, **liquid}],
            "surface_tension": "20-c", "probes": [{"name": "velocity", "velocity_of": 1}],
            "field": {"initial": "z", "diffusivity": 100,
                      "fixed": {"z-": -half_side, "z+": half_side}},
            "time_step": .1, "end": 1, "implicitness": 1}


def marangoni(dsc):
    """Prints the velocity of a drop that moves to larger temperatures (N. O. Young, J. S. Goldstein and
    M. J. Block, J. Fluid Mech. 6, 1959), in an unbounded liquid 2 / (15 viscosity)."""
    print("| edge | half side of the domain | vertices | velocity | exact, unbounded | error (%) | "
          "velocity across, greatest |")
    print("| --- " * 7 + "|")
    exact = 2 / 150
    for edge, half_side in ((.5, 4), (.5, 3), (.4, 3), (.3, 3)):
        found = report_of(dsc, marangoni_drop(edge, half_side), "marangoni")["steps"]
        x, y, z = found[-1]["probes"]["velocity"]
        print(f"| {edge} | {half_side} | {found[-1]['vertices']} | {z:.5f} | {exact:.5f} | "
              f"{100 * (z / exact - 1):.1f} | {max(abs(x), abs(y)):.1e} |", flush=True)


def survival(dsc):
    scenes = [(f"drop, contact angle {angle}, viscosity {viscosity}", drop_on_plane(angle, viscosity))
              for angle in (70, 80, 90, 100, 110, 120, 140) for viscosity in (0, .02, .1)]
    scenes += [(f"drop on an incline of {tilt} degrees", drop_on_plane(100, .05, tilt))
               for tilt in (10, 20, 30, 45, 60)]
    scenes += [("Rayleigh-Taylor, viscous", heavy_above_light())]
    scenes += [(f"Taylor-Green, {cells} cells", vortices(cells)) for cells in (12, 24)]
    print("| scene | steps | end | steps repeated | attempts undone | energy, greatest rise in a step: "
          "motion (%) | and remeshing (%) | volume, change | greatest residual | flat cells | seconds |")
    print("| --- " * 11 + "|")
    for name, scene in scenes:
        report = report_of(dsc, scene, name)
        steps = report["steps"]
        scale = max(abs(step["energy"]) for step in steps)
        moved = max((s["energy_moved"] - s["energy_before"]) / scale for s in steps[1:])
        whole = max((b["energy"] - a["energy"]) / scale for a, b in zip(steps[1:], steps[2:]))
        undone = ", ".join(f"{n} {cause}" for cause, n in report["repeated"]["attempts"].items())
        seconds = sum(s["seconds_of_solver"] + s["seconds_of_mesh"] for s in steps[1:])
        print(f"| {name} | {len(steps) - 1} | {steps[-1]['time']:.4g} of {scene['end']} | "
              f"{report['repeated']['steps']} | {undone or '-'} | {100 * moved:.3f} | {100 * whole:.3f} | "
              f"{relative_change([s['volume'] for s in steps]):.1e} | "
              f"{greatest(steps, 'residual'):.0e} | {greatest(steps, 'flat_cells')} | {seconds:.0f} |",
              flush=True)


def main():
    global data
    parts = {"droplets": droplets, "decay": decay, "rest": rest, "waves": waves, "jets": jets,
             "sessile": sessile, "sloshing": sloshing, "dam": dam, "bubble": bubble, "breathing": breathing,
             "figures": figures, "solvers": solvers, "subdivision": subdivision, "survival": survival,
             "layers": layers, "vortices": decay_of_vortices, "spin": spin, "floating": floating,
             "stokes": stokes, "wheel": wheel, "utube": utube, "flux": flux, "bubble_2": bubble_2,
             "filaments": filaments, "marangoni": marangoni}
    dsc, *wanted = sys.argv[1:]
    if wanted and wanted[0] == "--data":
        data, wanted = wanted[1], wanted[2:]
    for part in wanted or parts:
        parts[part](dsc)
        print()


if __name__ == "__main__":
    main()
