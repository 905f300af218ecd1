"""Reconstruction from points and cut loci, against exact values."""

import dsc
import numpy as np
import pytest


def points_of_torus(n=2960):
    numbers = np.random.default_rng(1)
    u, v, w = numbers.uniform(0, 2 * np.pi, (3, 3 * n))
    u, v = (a[w / 2 / np.pi * 3 < 2 + np.cos(v)][:n] for a in (u, v))  # uniform on the surface
    normals = np.c_[np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)]
    return np.c_[2 * np.cos(u), 2 * np.sin(u), 0 * u] + normals, normals


@pytest.mark.parametrize("with_normals", [False, True])
def test_reconstruction_of_a_torus(with_normals):
    points, normals = points_of_torus()
    result = dsc.reconstruct(points, normals if with_normals else None)
    assert result.complete
    assert result.complex.is_valid()
    assert result.complex.components == {0: 1, 1: 1}
    assert result.complex.volumes[1] == pytest.approx(4 * np.pi**2, rel=0.02)
    facets = result.complex.interface()
    edges = {tuple(sorted(e)) for t in facets.facets.tolist() for e in zip(t, t[1:] + t[:1])}
    assert len(facets.points) - len(edges) + len(facets.facets) == 0  # Euler characteristic
    assert result.used_points + result.duplicates + result.outliers == len(points)
    assert 0 < result.root_mean_square < result.maximum_distance < result.spacing
    assert len(result.doubtful_places) == 0


def test_open_sheets():
    points, _ = points_of_torus()
    half = points[points[:, 2] > 0]
    with pytest.raises(dsc.InvalidPointsError):
        dsc.reconstruct(half)
    sheet = dsc.reconstruct_sheet(half)
    assert sheet.complete and sheet.orientable
    assert (sheet.components, sheet.euler_characteristic, sheet.boundaries) == (1, 0, 2)
    edges = {tuple(sorted(e)) for t in sheet.triangles.tolist() for e in zip(t, t[1:] + t[:1])}
    assert len(sheet.points) - len(edges) + len(sheet.triangles) == 0
    assert sheet.boundary_length == pytest.approx(8 * np.pi, rel=0.2)
    middles = sheet.points[sheet.triangles].mean(axis=1)
    assert np.max(np.abs(np.hypot(np.hypot(*middles.T[:2]) - 2, middles[:, 2]) - 1)) < 0.05
    assert sheet.maximum_distance < 0.5 * sheet.spacing
    with pytest.raises(dsc.InvalidPointsError):
        dsc.reconstruct_sheet(np.arange(30.0).reshape(10, 3))  # on a line


def test_reconstruction_refuses_bad_points():
    for points in np.zeros((3, 3)), np.full((9, 3), np.nan), np.zeros((0, 3)):
        with pytest.raises(dsc.InvalidPointsError):
            dsc.reconstruct(points)
    for points in np.zeros((9, 2)), np.zeros(9):
        with pytest.raises(ValueError):
            dsc.reconstruct(points)
    with pytest.raises(ValueError):
        dsc.reconstruct(np.zeros((9, 3)), np.zeros((8, 3)))
    with pytest.raises(dsc.Error):
        dsc.reconstruct(np.zeros((9, 3)), tolerance=0)


def test_reconstruction_stops():
    points, _ = points_of_torus()
    with pytest.raises(dsc.Interrupted):
        dsc.reconstruct(points, progress=lambda phase: False)


TORUS = "(2+cos(v))*cos(u), (2+cos(v))*sin(u), sin(v)"


def test_cut_locus_of_an_ellipsoid():
    """The cut locus of a pole is an arc in the plane of the longest and the shortest axis. Its middle is
    the opposite pole, at half of the shorter meridian."""
    locus = dsc.cut_locus("x, 0.8*y, 0.6*z", (0, 0, 1), spacing=0.2)
    assert locus.complete
    assert len(locus.doubtful) == 0
    assert len(locus.arcs) == 1
    assert locus.points[:, 1] == pytest.approx(0, abs=1e-6)
    assert (locus.points**2 / np.array([1, 0.64, 0.36])).sum(axis=1) == pytest.approx(1)
    angle = (np.arange(20000) + 0.5) * np.pi / 20000
    meridian = np.mean(np.hypot(0.8 * np.cos(angle), 0.6 * np.sin(angle))) * np.pi
    assert locus.distances.max() == pytest.approx(meridian, rel=1e-3)
    ends = locus.arcs[0][[0, -1]]
    assert locus.multiplicities[ends].tolist() == [1, 1]
    assert np.all(np.delete(locus.multiplicities, ends) == 2)


def test_functions_get_many_points():
    class Stop(Exception):
        pass

    shapes = []

    def sphere(points):
        shapes.append(points.shape)
        assert np.linalg.norm(points, axis=1) == pytest.approx(1)
        if len(shapes) == 40:
            raise Stop
        return points * [1, 0.8, 0.6]

    with pytest.raises(Stop):
        dsc.cut_locus(sphere, (0, 0, 1))
    assert all(shape[0] > 1 and shape[1] == 3 for shape in shapes)


def test_cut_locus_refuses_bad_surfaces():
    def sphere(n):
        return n

    with pytest.raises(TypeError):
        dsc.cut_locus(3, (0, 0, 1))
    for point in (0,), (0, 0, 0, 1), "ab":
        with pytest.raises(ValueError):
            dsc.cut_locus(sphere, point)
    with pytest.raises(dsc.Error):
        dsc.cut_locus(sphere, (0, 0, 0))
    with pytest.raises(dsc.Error):
        dsc.cut_locus(lambda n: 0 * n, (0, 0, 1))
    with pytest.raises(ValueError):
        dsc.cut_locus(lambda n: n[:1], (0, 0, 1))
    with pytest.raises(ValueError):
        dsc.cut_locus(lambda n: n[:, :2], (0, 0, 1))
    with pytest.raises(ValueError):
        dsc.cut_locus(sphere, (0, 0, 1), spacing=-1)
    for text in "x,y", "u,v,x", "1,2,3", "x,y,z+", "x,y,q":
        with pytest.raises(ValueError):
            dsc.cut_locus(text, (0, 0, 1))
    with pytest.raises(ValueError):
        dsc.cut_locus("x,y,z", (0, 1))
    with pytest.raises(ValueError):
        dsc.cut_locus(TORUS, (0, 0, 1))
    with pytest.raises(dsc.Error):
        dsc.cut_locus(TORUS, (0, 0.3), periods=(1, 1))  # not periodic
    with pytest.raises(TypeError):
        dsc.reconstruct(np.ma.masked_array(np.zeros((9, 3))))
    with pytest.raises(ZeroDivisionError):
        dsc.cut_locus(lambda n: 1 // 0, (0, 0, 1))
    with pytest.raises(dsc.Interrupted):
        dsc.cut_locus("x, 0.8*y, 0.6*z", (1, 0.3, 0), progress=lambda phase: False)
