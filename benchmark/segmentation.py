#!/usr/bin/env python3
"""Compares segmentations of `dsc segment` with phantoms whose boundaries are known, and with other
methods on photographs. Prints tables.

Usage: benchmark/segmentation.py DSC [PART...]

The parts are phantoms, sizes, torus and images; all by default. Needs numpy, for `images` also
scikit-image (Debian: python3-skimage).
"""

import json
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

intensities = np.array([.1, .4, .65, .95])


class Round:
    """An ellipse or ellipsoid, or a star in the plane."""

    def __init__(self, label, center, radii, waves=0, height=0):
        self.label, self.center, self.radii = label, center, radii
        self.waves, self.height = waves, height

    def level(self, x):
        q = [(a - c) / r for a, c, r in zip(x, self.center, self.radii)]
        rho = np.sqrt(sum(a * a for a in q))
        return rho - 1 - self.height * np.cos(self.waves * np.arctan2(q[1], q[0]))


class Bar:
    """A rectangle with half sides and an angle, in the plane."""

    def __init__(self, label, center, halves, angle):
        self.label, self.center, self.halves = label, center, halves
        self.c, self.s = np.cos(angle), np.sin(angle)

    def level(self, x):
        u, v = x[0] - self.center[0], x[1] - self.center[1]
        return np.maximum(abs(self.c * u + self.s * v) - self.halves[0],
                          abs(-self.s * u + self.c * v) - self.halves[1])


class Ring:
    """A torus around the third axis."""

    def __init__(self, label, center, large, small):
        self.label, self.center, self.large, self.small = label, center, large, small

    def level(self, x):
        u, v, w = (a - c for a, c in zip(x, self.center))
        return np.sqrt((np.sqrt(u * u + v * v) - self.large) ** 2 + w * w) - self.small


def scene(d, n):
    """Returns shapes; later ones cover earlier ones. Sizes are in fractions of the side."""
    if d == 2:
        shapes = [Round(1, (.33, .586), (.215, .254)), Round(2, (.352, .625), (.107, .137)),
                  Round(2, (.703, .293), (.176, .176), 5, .13), Round(3, (.703, .293), (.078, .078)),
                  Bar(3, (.645, .781), (.0176, .195), .6435), Bar(1, (.195, .176), (.117, .068), 0)]
        shapes += [Round(1 + i % 3, c, (r, r)) for i, (c, r) in enumerate(
            [((.84, .586), .0156), ((.898, .664), .0195), ((.84, .742), .0234),
             ((.918, .82), .0273), ((.176, .918), .0313)])]
        for s in shapes:
            s.center = tuple(n * a for a in s.center)
            if isinstance(s, Bar):
                s.halves = tuple(n * a for a in s.halves)
            else:
                s.radii = tuple(n * a for a in s.radii)
        return shapes
    f = n / 128
    shapes = [Round(1, (44, 46, 48), (32,) * 3), Round(3, (44, 46, 48), (22,) * 3),
              Round(2, (44, 46, 48), (12,) * 3), Ring(2, (86, 84, 84), 24, 8.5),
              Round(3, (98, 34, 38), (14, 10, 18)), Round(1, (34, 100, 96), (13,) * 3),
              Round(2, (100, 36, 96), (9,) * 3)]
    for s in shapes:
        s.center = tuple(f * a for a in s.center)
        if isinstance(s, Ring):
            s.large, s.small = f * s.large, f * s.small
        else:
            s.radii = tuple(f * a for a in s.radii)
    return shapes


# Euler characteristics of the boundaries of the phases in space.
euler = {0: 8, 1: 6, 2: 4, 3: 6}


def labels_at(shapes, x):
    result = np.zeros(np.broadcast(*x).shape, np.uint8)
    for s in shapes:
        result[np.broadcast_to(s.level(x) < 0, result.shape)] = s.label
    return result


def distances(shapes, points):
    """Returns the distances from the nearest boundary, to first order."""
    h, best = 1e-3, None
    for s in shapes:
        x = [points[:, i] for i in range(points.shape[1])]
        level = s.level(x)
        squared = 0
        for i in range(len(x)):
            y = list(x)
            y[i] = x[i] + h
            squared = squared + ((s.level(y) - level) / h) ** 2
        distance = abs(level) / np.sqrt(squared)
        best = distance if best is None else np.minimum(best, distance)
    return best


def phantom(d, n, sigma, seed):
    """Returns values, averaged over the pixels, with noise, and the labels of their centers."""
    shapes, m = scene(d, n), 4 if d == 2 else 3
    places = np.arange(n)
    axes = [None, slice(None)] if d == 2 else [None, None, slice(None)]
    values = np.zeros((n,) * d, np.float32)
    for offset in np.ndindex(*(m,) * d):
        x = [(places + (offset[i] + .5) / m)[tuple(slice(None) if k == d - 1 - i else None
                                                   for k in range(d))] for i in range(d)]
        values += intensities[labels_at(shapes, x)].astype(np.float32)
    values /= m ** d
    x = [(places + .5)[tuple(slice(None) if k == d - 1 - i else None for k in range(d))]
         for i in range(d)]
    noise = np.random.default_rng(seed).standard_normal(values.shape)
    return (values + sigma * noise).astype(np.float32), labels_at(shapes, x)


def write_mha(path, values):
    size = list(values.shape[::-1]) + [1] * (3 - values.ndim)
    kind = {"float32": "MET_FLOAT", "uint8": "MET_UCHAR"}[str(values.dtype)]
    with open(path, "wb") as out:
        out.write(f"ObjectType = Image\nNDims = 3\nDimSize = {size[0]} {size[1]} {size[2]}\n"
                  f"ElementSpacing = 1 1 1\nOffset = .5 .5 .5\nElementType = {kind}\n"
                  "ElementByteOrderMSB = False\nElementDataFile = LOCAL\n".encode())
        out.write(values.tobytes())


def read_mha(path):
    with open(path, "rb") as file:
        content = file.read()
    end = content.index(b"LOCAL\n") + 6
    header = dict(line.split(" = ", 1) for line in content[:end].decode().splitlines())
    size = [int(x) for x in header["DimSize"].split()][::-1]
    kind = {"MET_USHORT": np.uint16, "MET_INT": np.int32, "MET_UCHAR": np.uint8}
    data = content[end:]
    if header.get("CompressedData", "False") == "True":
        import zlib
        data = zlib.decompress(data)
    return np.frombuffer(data, kind[header["ElementType"]]).reshape(size).squeeze()


def segment(dsc, folder, values, options, outputs=()):
    """Returns the report, the labels of pixels, and the seconds of the program."""
    image, report, labels = (os.path.join(folder, f) for f in ("image.mha", "report.json", "labels.mha"))
    write_mha(image, values)
    begin = time.monotonic()
    subprocess.run([dsc, "segment", image, "--report", report, "--quiet", *options,
                    *[x for o in outputs for x in ("-o", o)]], check=True)
    seconds = time.monotonic() - begin
    subprocess.run([dsc, "segment", image, "--quiet", *options, "-o", labels], check=True)
    with open(report) as file:
        return json.load(file), read_mha(labels), seconds


def dice(truth, labels, label):
    a, b = truth == label, labels == label
    return 2 * np.count_nonzero(a & b) / (np.count_nonzero(a) + np.count_nonzero(b))


def points_of_polygons(path, n):
    """Returns points on the polygons of a WKT file, off the sides of the image."""
    import re
    result = []
    for ring in re.findall(r"\(([^()]+)\)", open(path).read()):
        p = np.array([[float(x) for x in q.split()[:2]] for q in ring.split(",")])
        for t in (.125, .375, .625, .875):
            q = (1 - t) * p[:-1] + t * p[1:]
            on_side = (abs(q) < 1e-6) | (abs(q - n) < 1e-6)
            result.append(q[~on_side.any(axis=1)])
    return np.concatenate(result)


def points_of_surface(path):
    """Returns the corners and points inside the triangles of an OFF file, equally dense."""
    with open(path) as file:
        words = file.read().split()
    v, f = int(words[1]), int(words[2])
    p = np.array(words[4:4 + 3 * v], float).reshape(v, 3)
    t = np.array([words[4 + 3 * v + 4 * i + 1:4 + 3 * v + 4 * i + 4] for i in range(f)], int)
    weights = [(1, 1, 1), (4, 1, 1), (1, 4, 1), (1, 1, 4)]
    return np.concatenate([sum(w * p[t[:, i]] for i, w in enumerate(ws)) / sum(ws) for ws in weights])


def phantoms(dsc):
    print("| phantom | Dice of the phases | by thresholds | distance from the boundary: mean, root mean square, "
          "largest (pixels) | estimated uncertainty | components | Euler characteristics | cells | seconds |")
    print("| --- " * 9 + "|")
    for d, n, sigma, seed in ((2, 512, .1, 21), (2, 512, .25, 22), (3, 128, .1, 23), (3, 128, .25, 24)):
        values, truth = phantom(d, n, sigma, seed)
        with tempfile.TemporaryDirectory() as folder:
            boundary = os.path.join(folder, "boundary." + ("wkt" if d == 2 else "off"))
            report, labels, seconds = segment(dsc, folder, values, ["--phases", "4"], [boundary])
            points = points_of_polygons(boundary, n) if d == 2 else points_of_surface(boundary)
        off = distances(scene(d, n), points)
        thresholds = np.searchsorted((intensities[1:] + intensities[:-1]) / 2, values)
        of_labels = report["statistics"]["labels"]
        found = {x["label"]: x["euler_characteristic"] for x in of_labels}
        size = "length" if d == 2 else "area"
        weights = [b[size] for b in report["boundaries"]]
        uncertainty = np.sqrt(np.average([b["uncertainty"] ** 2 for b in report["boundaries"]], weights=weights))
        print(f"| {n}{'²' if d == 2 else '³'}, σ = {sigma} | "
              + " ".join(f"{dice(truth, labels, k):.4f}" for k in range(4)) + " | "
              + " ".join(f"{dice(truth, thresholds, k):.3f}" for k in range(4))
              + f" | {off.mean():.3f}, {np.sqrt((off ** 2).mean()):.3f}, {off.max():.2f} | {uncertainty:.3f} | "
              + " ".join(str(p["components"]) for p in report["phases"]) + " | "
              + ("" if d == 2 else "right" if found == euler else f"wrong: {found}")
              + f" | {report['statistics']['triangles' if d == 2 else 'tetrahedra']} | {seconds:.2f} |", flush=True)


def sizes(dsc):
    print("\n| image, σ = .1 | threads | seconds | cells | Dice |")
    print("| --- " * 5 + "|")
    for d, n in ((2, 512), (2, 2048), (3, 128), (3, 256)):
        values, truth = phantom(d, n, .1, 25)
        for threads in ("1", "2"):
            with tempfile.TemporaryDirectory() as folder:
                report, labels, seconds = segment(dsc, folder, values, ["--phases", "4", "--threads", threads])
            print(f"| {n}{'²' if d == 2 else '³'} | {threads} | {seconds:.2f} | "
                  f"{report['statistics']['triangles' if d == 2 else 'tetrahedra']} | "
                  + " ".join(f"{dice(truth, labels, k):.4f}" for k in range(4)) + " |", flush=True)


def torus(dsc):
    """A torus in strong noise: with free topology, and from a thin torus whose topology stays."""
    print("\n| noise over contrast | options | components, Euler characteristic of the boundary | Dice | seconds |")
    print("| --- " * 5 + "|")
    n = 64
    x = np.arange(n) + .5
    axes = [x[None, None, :], x[None, :, None], x[:, None, None]]
    truth = Ring(1, (32, 32, 32), 18, 7).level(axes) < 0
    with tempfile.TemporaryDirectory() as folder:
        start, thin = os.path.join(folder, "start.dsc"), os.path.join(folder, "thin.mha")
        write_mha(thin, (Ring(1, (32, 32, 32), 18, 4).level(axes) < 0).astype(np.float32))
        subprocess.run([dsc, "segment", thin, "--quiet", "-o", start], check=True)
        for sigma in (.5, 1, 2, 3):
            values = (truth + sigma * np.random.default_rng(31).standard_normal(truth.shape)).astype(np.float32)
            for options in ([], ["--intensities", "0,1"],
                            ["--intensities", "0,1", "--start", start, "--keep-topology"]):
                report, labels, seconds = segment(dsc, folder, values, options)
                found = {x["label"]: x for x in report["statistics"]["labels"]}.get(1)
                words = " ".join(o for o in options if o != start).replace("--start", "--start thin.dsc")
                topology = f"{found['components']}, {found['euler_characteristic']}" if found else "vanished"
                print(f"| {sigma} | {words} | {topology} | {dice(truth, labels, 1):.4f} | {seconds:.2f} |", flush=True)


def energy_of_labels(values, labels, smoothing, noise):
    """Returns the energy of labels of pixels, with boundaries smoothed by marching squares."""
    from skimage import measure
    energy = sum(((values[labels == k] - values[labels == k].mean()) ** 2).sum() for k in np.unique(labels)) / noise ** 2
    length = sum(np.linalg.norm(np.diff(c, axis=0), axis=1).sum()
                 for k in np.unique(labels)[1:] for c in measure.find_contours((labels >= k).astype(float), .5))
    return energy, length, energy + smoothing * length


def images(dsc):
    """Photographs of scikit-image, beside its methods. `segmentation.cpp` does the same for volumes."""
    import skimage.data
    from skimage import filters, segmentation as methods
    print("\n| image | method | deviations | length | energy | seconds |")
    print("| --- " * 6 + "|")
    for name, phases in (("coins", 2), ("cell", 2), ("camera", 3)):
        values = getattr(skimage.data, name)()[::-1].astype(np.float32)
        with tempfile.TemporaryDirectory() as folder:
            report, labels, seconds = segment(dsc, folder, values, ["--phases", str(phases), "--threads", "1"])
        noise, smoothing = report["parameters"]["noise"][0], report["parameters"]["smoothing"]
        length = sum(b["length"] for b in report["boundaries"])
        energy = report["energies"][-1]
        rows = [("dsc segment", (energy - smoothing * length, length, energy), seconds),
                ("the same, as pixels", energy_of_labels(values, labels, smoothing, noise), seconds)]
        begin = time.monotonic()
        found = np.digitize(values, filters.threshold_multiotsu(values, phases))
        rows.append(("thresholds of Otsu", energy_of_labels(values, found, smoothing, noise), time.monotonic() - begin))
        if phases == 2:
            scale = np.ptp(values)
            begin = time.monotonic()
            # Its energy is mu * length + sum of squared deviations of values in [0, 1].
            found = methods.chan_vese((values - values.min()) / scale, mu=smoothing * (noise / scale) ** 2,
                                      max_num_iter=500).astype(int)
            rows.append(("Chan and Vese", energy_of_labels(values, found, smoothing, noise), time.monotonic() - begin))
        for method, (deviations, size, total), t in rows:
            print(f"| {name} | {method} | {deviations:.0f} | {size:.0f} | {total:.0f} | {t:.2f} |", flush=True)


def main(arguments):
    known = {"phantoms": phantoms, "sizes": sizes, "torus": torus, "images": images}
    if not arguments or not set(arguments[1:]) <= set(known):
        sys.exit(__doc__)
    for part in arguments[1:] or known:
        known[part](arguments[0])


if __name__ == "__main__":
    main(sys.argv[1:])
