"""Complexes on flat tori."""

import pickle

import dsc
import numpy as np
import pytest

pytestmark = pytest.mark.skipif(dsc.Torus3._class is None, reason="tori are not in this build")


def periodic_distance(points, center, periods):
    difference = np.abs(points - center)
    return np.linalg.norm(np.minimum(difference, np.asarray(periods) - difference), axis=1)


def ball_at_the_seam(cls, radius=0.3, edge=0.1):
    periods = (1.0, 1.2, 0.9)[: cls.dimension]
    return cls.from_function(
        lambda p: (periodic_distance(np.mod(p, periods), 0, periods) < radius).astype(int), periods, edge
    )


@pytest.mark.parametrize("cls", [dsc.Torus2, dsc.Torus3])
def test_cells_across_the_seam(cls):
    c = ball_at_the_seam(cls)
    d = c.dimension
    cells = c.cells()
    p = cells.points[cells.cells]
    volumes = np.linalg.det(p[:, 1:] - p[:, :1]) / (2 if d == 2 else 6)
    assert np.all(volumes > 0)
    assert volumes.sum() == pytest.approx(np.prod(c.periods))
    assert np.array_equal(cells.vertices[: c.number_of_vertices], np.arange(c.number_of_vertices))
    shifts = (cells.points - cells.points[cells.vertices]) / c.periods
    assert shifts == pytest.approx(np.round(shifts))
    assert len(np.unique(cells.ids)) == len(cells.ids)
    exact = np.pi * 0.3**2 if d == 2 else 4 / 3 * np.pi * 0.3**3
    assert c.volumes[1] == pytest.approx(exact, rel=0.1)
    assert c.components == {0: 1, 1: 1}


@pytest.mark.parametrize("cls", [dsc.Torus2, dsc.Torus3])
def test_motions(cls):
    c = ball_at_the_seam(cls)
    volume = c.volumes[1]
    velocity = np.array([0.7, 0.4, 0.3])[: c.dimension]
    for _ in range(4):
        report = c.advect(lambda p, t: 0 * p + velocity, 0, 0.05)
        assert report.complete
    assert c.volumes[1] == pytest.approx(volume, rel=1e-3)
    assert c.offset(0.01).complete
    c.mean_curvature(1e-4, keep_volumes=True)
    c.improve()
    assert c.is_valid()
    facets = c.interface()
    moved = facets.points[facets.vertices == np.arange(len(facets.vertices))] + 0.001
    assert c.deform(moved).complete


def test_storage_and_values():
    c = ball_at_the_seam(dsc.Torus2)
    c.cell_values["phase"] = c.cells().labels
    c.vertex_values["x"] = np.ones(c.number_of_vertices)
    other = pickle.loads(pickle.dumps(c))
    assert other == c
    assert other.periods == c.periods
    assert np.array_equal(other.cell_values["phase"], c.cells().labels)
    if pytest.importorskip("meshio"):
        assert len(c.to_meshio().point_data["x"]) == len(c.cells().points)
    film = dsc.Film("torus")
    film.add(c)
    c.offset(0.01)
    film.add(c)
    assert "</html>" in film.html()
    with pytest.raises(ValueError):
        c.to_image((3, 3), 0.1, (0, 0))
    with pytest.raises(ValueError):
        dsc.Torus3.from_function(lambda p: np.zeros(len(p), int), (1, 1), 0.1)
    with pytest.raises(dsc.Error):
        dsc.Torus3.from_function(lambda p: np.zeros(len(p), int), (1, -1, 1), 0.1)
