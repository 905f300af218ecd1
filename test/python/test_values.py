"""Values on vertices and cells that follow the mesh."""

import copy
import pickle

import dsc
import numpy as np
import pytest
from shapes import ball, disk


def in_unit(c):
    return c.cells().points


@pytest.mark.parametrize("make", [ball, disk])
def test_linear_functions_are_kept_by_remeshing(make):
    c = make()
    d = c.dimension
    factors = np.arange(1.0, d + 1)
    c.vertex_values["linear"] = in_unit(c) @ factors
    c.vertex_values["place"] = in_unit(c)
    assert list(c.vertex_values) == ["linear", "place"]
    before = c.number_of_vertices
    c.control_detail(split_length=0.7, change_interface=True)
    c.improve()
    assert c.number_of_vertices != before
    assert c.vertex_values["linear"] == pytest.approx(in_unit(c) @ factors, abs=1e-9)
    assert c.vertex_values["place"] == pytest.approx(in_unit(c), abs=1e-9)


def cell_volumes(c):
    cells = c.cells()
    p = cells.points[cells.cells]
    return np.abs(np.linalg.det(p[:, 1:] - p[:, :1])) / [0, 0, 2, 6][c.dimension]


@pytest.mark.parametrize("make", [ball, disk])
def test_integrals_over_cells_are_kept_by_all_motions(make):
    c = make()
    c.cell_values["density"] = 1.0 + c.cells().labels
    c.cell_values["pair"] = np.c_[c.cells().labels, 2 * c.cells().labels]
    before = c.cell_values["density"] @ cell_volumes(c)
    velocity = np.eye(c.dimension)[0]
    c.advect(lambda p, t: 0 * p + velocity, 0, 0.05)
    c.offset(0.01)
    c.mean_curvature(1e-3)
    c.improve_interface()
    assert c.cell_values["density"] @ cell_volumes(c) == pytest.approx(before)
    assert c.cell_values["pair"].shape == (c.number_of_cells, 2)
    assert c.cell_values["pair"][:, 1] == pytest.approx(2 * c.cell_values["pair"][:, 0])


def test_values_on_the_interface_move_with_it():
    c = ball()
    ids = c.interface().ids
    c.vertex_values["marker"] = np.isin(c.cells().ids, ids)
    c.offset(0.005)
    marker = dict(zip(c.cells().ids.tolist(), c.vertex_values["marker"]))
    assert all(marker[i] == 1 for i in c.interface().ids.tolist() if i in ids)


def test_names():
    c = ball()
    n, m = c.number_of_vertices, c.number_of_cells
    for name in "a", "b", "c":
        c.vertex_values[name] = np.full(n, float(ord(name)))
    c.vertex_values["b"] = np.zeros((n, 3))
    del c.vertex_values["a"]
    assert sorted(c.vertex_values) == ["b", "c"]
    assert np.all(c.vertex_values["c"] == ord("c"))
    assert c.vertex_values["b"].shape == (n, 3)
    assert len(c.cell_values) == 0
    c.cell_values["ä b"] = np.arange(m)
    assert repr(c.cell_values) == "<values on cells: ä b>"
    with pytest.raises(KeyError):
        c.vertex_values["a"]
    with pytest.raises(KeyError):
        del c.vertex_values["a"]
    with pytest.raises(TypeError):
        c.vertex_values[3] = np.zeros(n)
    with pytest.raises(TypeError):
        c.vertex_values["x"] = ["text"] * n
    with pytest.raises(TypeError):
        c.vertex_values["x"] = np.ma.masked_array(np.zeros(n), np.ones(n, bool))
    with pytest.raises(ValueError):
        c.cell_values["label"] = np.zeros(m)
    for wrong in np.zeros(n + 1), np.zeros((n, 1, 1)), 3.0:
        with pytest.raises(ValueError):
            c.vertex_values["x"] = wrong
    assert "x" not in c.vertex_values


def test_copies_have_the_values():
    c = ball()
    c.vertex_values["x"] = in_unit(c)[:, 0]
    c.cell_values["phase"] = c.cells().labels
    for other in c.copy(), copy.deepcopy(c), pickle.loads(pickle.dumps(c)):
        assert np.array_equal(other.vertex_values["x"], c.vertex_values["x"])
        assert np.array_equal(other.cell_values["phase"], c.cell_values["phase"])
        other.vertex_values["x"] = np.zeros(c.number_of_vertices)
        assert c.vertex_values["x"].any()


def test_values_do_not_change_the_motion():
    plain, carrying = ball(), ball()
    carrying.vertex_values["x"] = in_unit(carrying)[:, 0]
    carrying.cell_values["y"] = carrying.qualities
    for c in plain, carrying:
        c.offset(0.02)
        c.improve()
    assert plain == carrying


def test_values_survive_an_interrupt():
    c = ball()
    c.cell_values["density"] = np.ones(c.number_of_cells)
    with pytest.raises(dsc.Interrupted):
        c.improve(quality_threshold=0.6, progress=lambda phase: False)
    assert c.is_valid()
    assert c.cell_values["density"] == pytest.approx(np.ones(c.number_of_cells))


def test_values_cannot_be_set_during_a_change():
    c = ball()

    def velocity(points, t):
        c.vertex_values["x"] = np.zeros(c.number_of_vertices)
        return 0 * points

    with pytest.raises(dsc.BusyError):
        c.advect(velocity, 0, 1)
