"""Solids like those of CAD programs, with few large triangles, and their exact volumes.

Each solid is a tuple of points and triangles. `write_off()` writes it to a file.
"""

import functools
import itertools
import math

import numpy


def write_off(path, solid, form="%.17g"):
    points, triangles = solid
    with open(path, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        file.writelines(" ".join(form % x for x in p) + "\n" for p in points)
        file.writelines(f"3 {a} {b} {c}\n" for a, b, c in triangles)


def write_obj(path, solids, form="%.17g"):
    """Writes an object for each solid."""
    first = 1
    with open(path, "w", encoding="ascii") as file:
        for i, (points, triangles) in enumerate(solids):
            file.write(f"o solid_{i + 1}\n")
            file.writelines("v " + " ".join(form % x for x in p) + "\n" for p in points)
            file.writelines(f"f {a + first} {b + first} {c + first}\n" for a, b, c in triangles)
            first += len(points)


def joined(solids):
    """Returns the points and triangles of all solids."""
    firsts = numpy.cumsum([0] + [len(points) for points, _ in solids])
    return (numpy.concatenate([points for points, _ in solids]),
            numpy.concatenate([numpy.asarray(triangles) + first for (_, triangles), first in zip(solids, firsts)]))


def moments(solid):
    """Returns the integrals of 1, x, y and z."""
    points = numpy.asarray(solid[0], float)
    middle = points.mean(0)
    p = (points - middle)[numpy.asarray(solid[1])]
    volumes = numpy.einsum("ij,ij->i", numpy.cross(p[:, 0], p[:, 1]), p[:, 2]) / 6
    total = volumes.sum()
    return numpy.array([total, *(volumes @ p.sum(1) / 4 + total * middle)])


def volume(solid):
    return float(moments(solid)[0])


def area(solid):
    p = numpy.asarray(solid[0], float)[numpy.asarray(solid[1])]
    return float(numpy.linalg.norm(numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum()) / 2


def edge_lengths(solid):
    p = numpy.asarray(solid[0], float)
    edges = {tuple(sorted(e)) for t in solid[1] for e in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    return numpy.array([numpy.linalg.norm(p[a] - p[b]) for a, b in edges])


def turning(solid):
    """Returns the integral of the mean curvature times two: the sum of length times turning angle over all edges.

    Angles at convex edges are positive.
    """
    p = numpy.asarray(solid[0], float)
    opposite = {}
    for t in solid[1]:
        for k in range(3):
            opposite[t[k], t[(k + 1) % 3]] = t
    total = 0.0
    for (a, b), left in opposite.items():
        if a > b:
            continue
        normals = []
        for t in (left, opposite[b, a]):
            n = numpy.cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])
            normals.append(n / numpy.linalg.norm(n))
        length = numpy.linalg.norm(p[b] - p[a])
        sine = numpy.cross(normals[0], normals[1]) @ (p[b] - p[a]) / length
        total += math.atan2(sine, normals[0] @ normals[1]) * length
    return total


def rotation(numbers):
    """Returns a random rotation."""
    q, r = numpy.linalg.qr(numbers.normal(size=(3, 3)))
    q = q * numpy.sign(numpy.diag(r))
    return q if numpy.linalg.det(q) > 0 else q[[1, 0, 2]]


def moved(solid, turn, shift=0):
    return numpy.asarray(solid[0], float) @ turn.T + shift, solid[1]


def subdivided(solid, n):
    """Divides each edge into n parts, and each triangle into n * n."""
    corners, index, triangles = numpy.asarray(solid[0], float), {}, []
    points = []
    for triangle in solid[1]:
        def vertex(i, j, k):
            key = tuple(sorted((v, w) for v, w in zip(triangle, (i, j, k)) if w > 0))
            if key not in index:
                index[key] = len(points)
                points.append(sum(corners[v] * w for v, w in key) / n)
            return index[key]

        for i, j in itertools.product(range(n), repeat=2):
            if i + j < n:
                k = n - 1 - i - j
                triangles.append((vertex(i + 1, j, k), vertex(i, j + 1, k), vertex(i, j, k + 1)))
                if k > 0:
                    triangles.append((vertex(i, j + 1, k), vertex(i + 1, j, k), vertex(i + 1, j + 1, k - 1)))
    return numpy.array(points), triangles


def divided_box(low, high, divisions, numbers):
    """Returns a box whose faces are rectangular grids with random diagonals."""
    points, triangles, known = [], [], {}
    low, high = numpy.array(low, float), numpy.array(high, float)

    def index(place):
        if place not in known:
            known[place] = len(points)
            points.append(low + (high - low) * numpy.array(place) / divisions)
        return known[place]

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end, i, j in itertools.product((0, divisions[axis]), range(divisions[u]), range(divisions[v])):
            corners = []
            for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                place = [0, 0, 0]
                place[axis], place[u], place[v] = end, i + di, j + dj
                corners.append(index(tuple(place)))
            a, b, c, d = corners if end else corners[::-1]
            triangles += [(a, b, c), (a, c, d)] if numbers.random() < 0.5 else [(a, b, d), (b, c, d)]
    return numpy.array(points), triangles


def ball(radius, n):
    """Returns a ball around the origin, divided by n parallels and 2 n meridians."""
    points = [(0.0, 0.0, radius)]
    for i, j in itertools.product(range(1, n), range(2 * n)):
        u, v = math.pi * i / n, math.pi * j / n
        points.append((radius * math.sin(u) * math.cos(v), radius * math.sin(u) * math.sin(v), radius * math.cos(u)))
    points.append((0.0, 0.0, -radius))
    triangles = []
    for j in range(2 * n):
        k = (j + 1) % (2 * n)
        triangles += [(0, 1 + j, 1 + k), (len(points) - 1, len(points) - 1 - 2 * n + k, len(points) - 1 - 2 * n + j)]
        for row in range(1, (n - 2) * 2 * n + 1, 2 * n):
            a, b, c, d = row + j, row + k, row + 2 * n + j, row + 2 * n + k
            triangles += [(a, c, d), (a, d, b)]
    return numpy.array(points), triangles


def from_quads(quads):
    """Returns the solid bounded by quadrilaterals, each given by four points counterclockwise."""
    index, points, triangles = {}, [], []
    for quad in quads:
        corners = []
        for p in quad:
            key = tuple(float(x) for x in p)
            if key not in index:
                index[key] = len(points)
                points.append(key)
            corners.append(index[key])
        triangles += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    return points, triangles


class Blocks:
    """A union of cells of a rectilinear grid: a solid with faces along the axes."""

    def __init__(self, planes, filled):
        self.planes = [numpy.asarray(x, float) for x in planes]
        self.filled = filled

    def volume(self):
        sizes = [numpy.diff(x) for x in self.planes]
        return float(numpy.einsum("i,j,k,ijk->", *sizes, self.filled.astype(float)))

    def surface(self):
        quads = []
        padded = numpy.pad(self.filled, 1)
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for cell in itertools.product(*(range(n) for n in self.filled.shape)):
                if not self.filled[cell]:
                    continue
                for side in (0, 1):
                    beyond = list(c + 1 for c in cell)
                    beyond[axis] += 2 * side - 1
                    if padded[tuple(beyond)]:
                        continue
                    quad = []
                    for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0.0] * 3
                        p[axis] = self.planes[axis][cell[axis] + side]
                        p[u] = self.planes[u][cell[u] + du]
                        p[v] = self.planes[v][cell[v] + dv]
                        quad.append(tuple(p))
                    quads.append(quad if side else quad[::-1])
        return from_quads(quads)

    def is_manifold(self):
        """Returns whether no two cells meet in an edge or a corner only."""
        f = numpy.pad(self.filled, 1).astype(int)
        for axis in range(3):
            g = numpy.moveaxis(f, axis, 0)
            a, b, c, d = g[:, :-1, :-1], g[:, 1:, :-1], g[:, :-1, 1:], g[:, 1:, 1:]
            if ((a == d) & (b == c) & (a != b)).any():
                return False
        # around a corner: filled and empty cells must each be connected by faces
        n = f.shape
        for i, j, k in itertools.product(range(n[0] - 1), range(n[1] - 1), range(n[2] - 1)):
            block = f[i:i + 2, j:j + 2, k:k + 2]
            for value in (0, 1):
                cells = [c for c in itertools.product((0, 1), repeat=3) if block[c] == value]
                if len(cells) < 2:
                    continue
                seen, front = {cells[0]}, [cells[0]]
                while front:
                    c = front.pop()
                    for axis in range(3):
                        e = tuple(x ^ (m == axis) for m, x in enumerate(c))
                        if block[e] == value and e not in seen:
                            seen.add(e)
                            front.append(e)
                if len(seen) < len(cells):
                    return False
        return True

    def offset(self, d):
        """Returns the solid with all faces moved outwards by d: the mitered offset."""
        grow = d > 0
        planes = [numpy.unique(numpy.concatenate([x - abs(d), x + abs(d)])) for x in self.planes]
        filled = numpy.full([len(x) - 1 for x in planes], not grow)
        value = grow
        for cell in itertools.product(*(range(n) for n in self.filled.shape)):
            if bool(self.filled[cell]) == value:
                self._fill(planes, filled, cell, abs(d), value)
        if not grow:  # all that is beyond the grid is empty
            for axis in range(3):
                for edge in (self.planes[axis][0], self.planes[axis][-1]):
                    middle = (planes[axis][:-1] + planes[axis][1:]) / 2
                    cut = [slice(None)] * 3
                    cut[axis] = (middle < self.planes[axis][0] + abs(d)) | (middle > self.planes[axis][-1] - abs(d))
                    filled[tuple(cut)] = False
        return Blocks(planes, filled)

    def _fill(self, planes, filled, cell, d, value):
        ranges = []
        for axis in range(3):
            low, high = self.planes[axis][cell[axis]] - d, self.planes[axis][cell[axis] + 1] + d
            ranges.append(slice(numpy.searchsorted(planes[axis], low - 1e-12 * d),
                                numpy.searchsorted(planes[axis], high - 1e-12 * d)))
        filled[tuple(ranges)] = value


def box(a, b, c):
    return Blocks([[0, a], [0, b], [0, c]], numpy.ones((1, 1, 1), bool))


def random_blocks(random, thickness):
    """Returns a plate with ribs, pockets and holes along the axes."""
    while True:
        cuts = [sorted(random.uniform(0, 1) for _ in range(random.randint(0, 3))) for _ in range(2)]
        planes = [[0, *(10 * x for x in c), 10 * random.uniform(1.02, 1.6)] for c in cuts]
        layers = random.randint(1, 3)
        planes.append([0, *itertools.accumulate(thickness * random.uniform(0.3, 2) for _ in range(layers))])
        if min(min(numpy.diff(x)) for x in planes[:2]) < 0.3:
            continue
        shape = [len(x) - 1 for x in planes]
        filled = numpy.zeros(shape, bool)
        filled[:, :, 0] = True
        for cell in itertools.product(range(shape[0]), range(shape[1])):
            kind = random.random()
            if kind < 0.2 and shape[0] * shape[1] > 4:
                filled[cell] = False  # a hole
            elif kind < 0.6:
                filled[cell][: random.randint(1, layers)] = True
        solid = Blocks(planes, filled)
        if filled.any() and solid.is_manifold() and is_connected(filled):
            return solid


def is_connected(filled):
    cells = {tuple(c) for c in numpy.argwhere(filled)}
    front = [cells.pop()]
    while front:
        c = front.pop()
        for axis, step in itertools.product(range(3), (-1, 1)):
            e = tuple(x + step * (m == axis) for m, x in enumerate(c))
            if e in cells:
                cells.remove(e)
                front.append(e)
    return not cells


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def triangulate(outline, holes):
    """Triangulates a polygon with holes by clipping ears. Returns all points and the triangles."""
    points = [*outline, *itertools.chain.from_iterable(holes)]
    ring, first = list(range(len(outline))), len(outline)
    starts = []
    for hole in holes:  # clockwise
        starts.append(list(range(first, first + len(hole))))
        first += len(hole)
    for hole in sorted(starts, key=lambda h: -max(points[i][0] for i in h)):
        k = max(range(len(hole)), key=lambda m: points[hole[m]][0])
        hole = hole[k:] + hole[:k]
        p = points[hole[0]]
        edges = [(ring[i], ring[(i + 1) % len(ring)]) for i in range(len(ring))]
        edges += [(h[i], h[(i + 1) % len(h)]) for h in starts for i in range(len(h))]

        def sees(q):
            for a, b in edges:
                if points[a] in (p, q) or points[b] in (p, q):
                    continue
                if cross(p, q, points[a]) * cross(p, q, points[b]) <= 0 and \
                        cross(points[a], points[b], p) * cross(points[a], points[b], q) <= 0:
                    return False
            return True

        candidates = []
        for m, i in enumerate(ring):
            before, q, after = points[ring[m - 1]], points[i], points[ring[(m + 1) % len(ring)]]
            inside = cross(before, q, p) > 0 and cross(q, after, p) > 0 if cross(before, q, after) > 0 else \
                not (cross(before, q, p) <= 0 and cross(q, after, p) <= 0)
            if q[0] > p[0] and inside and sees(q):
                candidates.append((math.dist(p, q), m))
        m = min(candidates)[1]
        ring = ring[: m + 1] + hole + [hole[0]] + ring[m:]
    triangles = []
    while len(ring) > 3:
        best = None
        for m in range(len(ring)):
            a, b, c = ring[m - 1], ring[m], ring[(m + 1) % len(ring)]
            size = cross(points[a], points[b], points[c])
            if size <= 0:
                continue
            empty = all(i in (a, b, c) or points[i] in (points[a], points[b], points[c]) or not (
                cross(points[a], points[b], points[i]) >= 0 and cross(points[b], points[c], points[i]) >= 0 and
                cross(points[c], points[a], points[i]) >= 0) for i in ring)
            if empty:
                longest = math.dist(points[a], points[c])
                if best is None or longest < best[0]:
                    best = (longest, m)
        m = best[1]
        triangles.append((ring[m - 1], ring[m], ring[(m + 1) % len(ring)]))
        del ring[m]
    triangles.append(tuple(ring))
    return points, triangles


def extruded(outline, holes, height):
    """Returns a plate: a polygon with holes, of a thickness."""
    return plate(*triangulate(outline, holes), (outline, *holes), height)


def extruded_star(outline, height):
    """Returns a plate of a polygon whose points all see the origin."""
    n = len(outline)
    return plate([*outline, (0.0, 0.0)], [(i, (i + 1) % n, n) for i in range(n)], (outline,), height)


def plate(points, triangles, rings, height):
    """Returns a plate whose bottom and top have given triangles; the points begin with those of the rings."""
    n = len(points)
    solid = [(x, y, 0.0) for x, y in points] + [(x, y, height) for x, y in points]
    faces = [(c, b, a) for a, b, c in triangles] + [(a + n, b + n, c + n) for a, b, c in triangles]
    first = 0
    for ring in rings:
        for i in range(len(ring)):
            a, b = first + i, first + (i + 1) % len(ring)
            faces += [(a, b, b + n), (a, b + n, a + n)]
        first += len(ring)
    return solid, faces


def circle(x, y, radius, number, clockwise=False):
    sign = -1 if clockwise else 1
    return [(x + radius * math.cos(sign * 2 * math.pi * i / number), y + radius * math.sin(sign * 2 * math.pi * i / number))
            for i in range(number)]


def arc(x, y, radius, begin, end, number):
    """Returns the points of an arc; angles are in degrees."""
    angles = numpy.radians(numpy.linspace(begin, end, number))
    return [(x + radius * math.cos(t), y + radius * math.sin(t)) for t in angles]


LETTERS = {  # outline and holes, in the unit square
    "A": ([(0, 0), (0.2, 0), (0.32, 0.3), (0.68, 0.3), (0.8, 0), (1, 0), (0.6, 1), (0.4, 1)],
          [[(0.4, 0.45), (0.5, 0.7), (0.6, 0.45)]]),
    "B": ([(0, 0), *arc(0.35, 0.25, 0.25, -90, 60, 10), *arc(0.3, 0.75, 0.25, -50, 90, 10), (0, 1)],
          [[*arc(0.35, 0.25, 0.12, 90, -90, 6), (0.13, 0.13), (0.13, 0.37)],
           [*arc(0.3, 0.75, 0.12, 90, -90, 6), (0.13, 0.63), (0.13, 0.87)]]),
    "E": ([(0, 0), (0.7, 0), (0.7, 0.18), (0.2, 0.18), (0.2, 0.42), (0.6, 0.42), (0.6, 0.58), (0.2, 0.58), (0.2, 0.82),
           (0.7, 0.82), (0.7, 1), (0, 1)], []),
    "O": (circle(0.5, 0.5, 0.5, 24), [circle(0.5, 0.5, 0.3, 18, clockwise=True)]),
}


@functools.lru_cache
def letter(name, height):
    """Returns a letter of height 1 in the plane, extruded."""
    return extruded(*LETTERS[name], height)


def random_plate(random, thickness):
    """Returns the outline, the holes and the thickness of an L-shaped or rectangular plate with round holes."""
    a, b = 10 * random.uniform(0.5, 1.5), 10 * random.uniform(0.5, 1.5)
    outline = [(0.0, 0.0), (a, 0.0), (a, b), (0.0, b)]
    boxes = [(0, 0, a, b)]
    if random.random() < 0.5:
        c, d = a * random.uniform(0.3, 0.7), b * random.uniform(0.3, 0.7)
        outline = [(0.0, 0.0), (a, 0.0), (a, d), (c, d), (c, b), (0.0, b)]
        boxes = [(0, 0, a, d), (0, d, c, b)]
    holes = []
    for x0, y0, x1, y1 in boxes:
        for _ in range(random.randint(0, 1)):
            radius = random.uniform(0.1, 0.35) * min(x1 - x0, y1 - y0)
            holes.append(circle(random.uniform(x0 + 1.1 * radius, x1 - 1.1 * radius),
                                random.uniform(y0 + 1.1 * radius, y1 - 1.1 * radius), radius,
                                random.randint(6, 32), clockwise=True))
    return outline, holes, thickness


def polygon_area(ring):
    return sum(ring[i - 1][0] * ring[i][1] - ring[i][0] * ring[i - 1][1] for i in range(len(ring))) / 2


def moved_lines(ring, d):
    """Returns the polygon with all edges moved to the right by d: outwards if counterclockwise."""
    result = []
    for i in range(len(ring)):
        p, q, r = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
        u = ((q[1] - p[1]) / math.dist(p, q), (p[0] - q[0]) / math.dist(p, q))
        v = ((r[1] - q[1]) / math.dist(q, r), (q[0] - r[0]) / math.dist(q, r))
        factor = d / (1 + u[0] * v[0] + u[1] * v[1])
        result.append((q[0] + factor * (u[0] + v[0]), q[1] + factor * (u[1] + v[1])))
    return result


def plate_volume(outline, holes, height, d=0.0):
    """Returns the volume of a plate with all faces moved outwards by d."""
    return sum(polygon_area(moved_lines(r, d)) for r in (outline, *holes)) * (height + 2 * d)


def cylinder(radius, height, sides):
    """Returns the outline of a cylinder without holes, for `extruded()`."""
    return circle(0, 0, radius, sides), [], height


def wedge(size, degrees):
    """Returns a wedge of a square base and a small angle at one edge."""
    h = size * math.tan(math.radians(degrees))
    a, b, c, d = (0, 0, 0), (size, 0, 0), (size, size, 0), (0, size, 0)
    e, f = (size, 0, h), (size, size, h)
    points = [a, b, c, d, e, f]
    return points, [(0, 2, 1), (0, 3, 2), (0, 4, 5), (0, 5, 3), (1, 2, 5), (1, 5, 4), (0, 1, 4), (3, 5, 2)]
