"""Exceptions: their classes, offending simplices, and what holds afterwards."""

from __future__ import annotations

import dsc
import numpy as np
import pytest
from shapes import CUBE_POINTS, CUBE_TRIANGLES, ball, disk


def test_an_open_surface():
    with pytest.raises(dsc.InvalidSurfaceError, match="not closed") as error:
        dsc.Complex3.from_surfaces([(CUBE_POINTS, CUBE_TRIANGLES[:-1])])
    assert error.value.surface == 0
    assert len(error.value.facets) > 0 and error.value.facets.dtype == np.int64
    assert len(error.value.vertices) == 6  # ends of three edges


def test_a_surface_that_intersects_itself():
    points = np.concatenate([CUBE_POINTS, CUBE_POINTS + 0.5])
    triangles = np.concatenate([CUBE_TRIANGLES, np.asarray(CUBE_TRIANGLES) + len(CUBE_POINTS)])
    with pytest.raises(dsc.InvalidSurfaceError) as error:
        dsc.Complex3.from_surfaces([(points, triangles)])
    assert {error.value.surface, error.value.other_surface} == {0}
    assert len(error.value.facets) % 2 == 0 and len(error.value.facets) > 0


def test_flat_cells():
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
    with pytest.raises(dsc.InvalidCellsError) as error:
        dsc.Complex3.from_tetrahedra(points, [[0, 1, 2, 3]], [1])
    assert error.value.cells.tolist() == [0]


def test_crossing_polygons():
    with pytest.raises(dsc.InvalidSurfaceError):
        dsc.Complex2.from_polygons([[[(0, 0), (1, 1), (1, 0), (0, 1)]]])


def test_velocities_that_are_not_finite():
    c = disk()
    before = c.copy()
    with pytest.raises(dsc.InvalidDestinationError) as error:
        c.advect(lambda p, t: np.full_like(p, np.nan), 0, 0.1)
    assert len(error.value.vertices) == len(before.interface().points)
    assert c == before


def test_destinations_of_a_wrong_number():
    c = disk()
    with pytest.raises(dsc.Error):
        c.deform(c.interface().points[:-1])


@pytest.mark.parametrize("wrong", [lambda p, t: p[:, :1], lambda p, t: p[:-1]])
def test_velocities_of_a_wrong_shape(wrong):
    c = disk()
    before = c.copy()
    with pytest.raises(ValueError):
        c.advect(wrong, 0, 0.1)
    assert c == before


@pytest.mark.parametrize("wrong", [lambda p, t: "text", lambda p, t: p * 1j, lambda p, t: None])
def test_velocities_that_are_no_numbers(wrong):
    with pytest.raises(TypeError):
        disk().advect(wrong, 0, 0.1)


def test_an_exception_of_the_velocity_passes_through():
    c = ball()
    before = c.copy()

    def velocity(points, t):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        c.advect(velocity, 0, 0.1)
    assert c == before
    c.offset(0.01)  # the complex can be changed again


def test_an_exception_of_the_topology_function_passes_through():
    from test_complex import grow, one_label, two_disks

    def control(label, new_label, point):
        raise KeyError("mine")

    c = one_label(two_disks())
    with pytest.raises(KeyError, match="mine"):
        grow(c, topology=control)
    assert c.is_valid()


@pytest.mark.parametrize("labels", [[0.0], [1.5], ["a"], [2**40]])
def test_labels_that_are_not_integers(labels):
    points = [[0, 0], [1, 0], [0, 1]]
    with pytest.raises((TypeError, ValueError)):
        dsc.Complex2.from_triangles(points, [[0, 1, 2]], labels)


@pytest.mark.parametrize("triangles", [[[0.0, 1, 2]], [[0, 1]], [[0, 1, -1]], [0, 1, 2]])
def test_triangles_of_a_wrong_form(triangles):
    with pytest.raises((TypeError, ValueError)):
        dsc.Complex2.from_triangles([[0, 0], [1, 0], [0, 1]], triangles, [1])


def test_an_index_out_of_range():
    with pytest.raises(dsc.InvalidCellsError):
        dsc.Complex2.from_triangles([[0, 0], [1, 0], [0, 1]], [[0, 1, 3]], [1])


@pytest.mark.parametrize(
    "options, error",
    [
        ({"unknown": 1}, TypeError),
        ({"topology": "perhaps"}, ValueError),
        ({"topology": 3}, TypeError),
        ({"scheme": "rk9"}, ValueError),
        ({"minimum_angle": 80}, dsc.Error),
        ({"quality_threshold": 2.0}, dsc.Error),
        ({"threads": "two"}, TypeError),
        ({"threads": -1}, TypeError),
    ],
)
def test_wrong_options(options, error):
    c = disk()
    before = c.copy()
    with pytest.raises(error):
        c.advect(lambda p, t: p, 0, 0.01, **options)
    assert c == before


@pytest.mark.parametrize("box", [[(0, 0)], [(0, 0, 0), (1, 1, 1)], 3])
def test_a_wrong_box(box):
    with pytest.raises(ValueError):
        dsc.Complex2.from_function(lambda p: np.zeros(len(p), dtype=int), box=box, edge=0.1)


def test_an_empty_box():
    with pytest.raises(dsc.Error):
        dsc.Complex2.from_function(lambda p: np.zeros(len(p), dtype=int), box=[(0, 0), (0, 1)], edge=0.1)


@pytest.mark.parametrize("edge", [0, -1, float("nan"), float("inf"), 1e-9])
@pytest.mark.parametrize("make", [dsc.Complex2, dsc.Complex3])
def test_a_wrong_edge(make, edge):
    d = make.dimension
    with pytest.raises(dsc.Error):
        make.from_function(lambda p: np.zeros(len(p), dtype=int), box=[[0] * d, [1] * d], edge=edge)


@pytest.mark.parametrize(
    "call",
    [
        lambda: disk().advect(3, 0, 0.1),
        lambda: disk().advect(lambda p, t: p, 0, "a"),
        lambda: disk().offset("far"),
        lambda: disk().offset(0.01, progress=3),
        lambda: disk().restore_volumes({1: "much"}),
        lambda: dsc.Complex2.from_function(3, [(0, 0), (1, 1)], 0.1),
        lambda: dsc.Complex2.from_polygons([[[(0, 0), (1, 0), (1, 1)]]], [1.5]),
        lambda: dsc.Complex2.from_image(np.eye(4, dtype=int), (1, 1)),
        lambda: dsc.Fluid(3, {1: dsc.Liquid(1.0)}),
        lambda: dsc.Fluid(ball(), {1: 1000}),
        lambda: dsc.Film(hidden=[1.5]),
    ],
)
def test_arguments_of_wrong_types(call):
    with pytest.raises(TypeError) as error:
        call()
    assert "\n" not in str(error.value)


def test_labels_that_are_lost_are_told():
    """A layer that is thinner than the cells is met only between their barycenters."""
    with pytest.warns(UserWarning, match=r"labels \[3\]"):
        dsc.Complex2.from_function(
            lambda p: np.select([p[:, 0] < 0.501, p[:, 0] > 0.503], [1, 2], 3), [(0, 0), (1, 1)], 0.2
        )


@pytest.mark.parametrize("labels", [np.array([2**64 - 1], dtype=np.uint64), np.array([2**31])])
def test_labels_that_are_too_large(labels):
    with pytest.raises(ValueError):
        dsc.Complex2.from_triangles([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], labels)


@pytest.mark.parametrize("dt", [float("inf"), float("nan")])
@pytest.mark.parametrize("scheme", ["euler", "adaptive"])
def test_a_time_step_that_is_not_finite(scheme, dt):
    with pytest.raises(dsc.Error):
        disk().advect(lambda p, t: p, 0, dt, scheme=scheme)


def test_a_complex_without_interface_can_be_advected():
    c = dsc.Complex2.from_function(lambda p: np.zeros(len(p), dtype=int), [(0, 0), (1, 1)], 0.3)
    assert c.advect(lambda p, t: p / p.max(), 0, 0.1).complete


@pytest.mark.parametrize("origin", [(np.nan, 0), (np.inf, 0)])
def test_an_origin_that_is_not_finite(origin):
    with pytest.raises(ValueError, match="origin"):
        dsc.Complex2.from_image(np.eye(8, dtype=int), 1.0, origin)


def test_an_image_of_one_label():
    assert dsc.Complex3.from_image(np.ones((4, 4, 4), dtype=int)).volumes == pytest.approx({1: 64})


def test_too_few_labels():
    with pytest.raises(ValueError):
        dsc.Complex2.from_function(lambda p: np.zeros(1, dtype=int), box=[(0, 0), (1, 1)], edge=0.3)


def test_the_constructor_is_not_for_users():
    with pytest.raises(TypeError, match="class methods"):
        dsc.Complex3(3)


def test_all_errors_have_a_common_base():
    for name in ("InvalidSurfaceError", "InvalidCellsError", "InvalidPointsError", "FileError",
                 "InvalidDestinationError", "InvalidSolidError", "TetrahedralizationError"):  # fmt: skip
        assert issubclass(getattr(dsc, name), dsc.Error)
    assert not issubclass(dsc.Interrupted, dsc.Error)
