"""The classes of complexes, against exact values and against each other."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import dsc
import numpy as np
import pytest
from shapes import CUBE_POINTS, CUBE_TRIANGLES, ball, disk

@pytest.fixture(params=[2, 3])
def round_complex(request):
    return disk() if request.param == 2 else ball()


def exact_volume(dimension, radius):
    return np.pi * radius**2 if dimension == 2 else 4 / 3 * np.pi * radius**3


# Creation


def test_labels_of_a_function(round_complex):
    assert round_complex.is_valid()
    assert round_complex.labels == [0, 1]
    assert round_complex.components == {0: 1, 1: 1}
    d = round_complex.dimension
    assert round_complex.volumes[1] == pytest.approx(exact_volume(d, 0.5), rel=0.12)  # chords
    assert sum(round_complex.volumes.values()) == pytest.approx(2.0**d, rel=1e-12)


def test_the_function_of_labels_is_called_with_arrays():
    shapes = []

    def labels(points):
        shapes.append(points.shape)
        return (points[:, 0] > 0.1).astype(np.uint8)

    c = dsc.Complex2.from_function(labels, box=[(-1, -1), (1, 1)], edge=0.3)
    assert c.volumes[1] == pytest.approx(1.8, abs=0.05)
    assert len(shapes) < 200 and all(shape[1] == 2 for shape in shapes)


def test_a_cube_from_its_surface():
    c = dsc.Complex3.from_surfaces([(CUBE_POINTS, CUBE_TRIANGLES)], box=[(-1, -1, -1), (2, 2, 2)])
    assert c.volumes == pytest.approx({0: 26.0, 1: 1.0})
    facets = c.interface()
    assert len(facets.points) == 8 and len(facets.facets) == 12


def test_labels_of_surfaces():
    surfaces = [(CUBE_POINTS, CUBE_TRIANGLES), (CUBE_POINTS + [2, 0, 0], CUBE_TRIANGLES)]
    c = dsc.Complex3.from_surfaces(surfaces, [1, 7], improve=False)
    assert c.labels == [0, 1, 7]
    assert c.volumes[1] == pytest.approx(1) and c.volumes[7] == pytest.approx(1)


def test_cells_make_the_same_complex(round_complex):
    cells = round_complex.cells()
    make = dsc.Complex2.from_triangles if round_complex.dimension == 2 else dsc.Complex3.from_tetrahedra
    again = make(cells.points, cells.cells, cells.labels, improve=False)
    assert again.volumes == pytest.approx(round_complex.volumes, rel=1e-12)
    assert again.number_of_cells == round_complex.number_of_cells


@pytest.mark.parametrize("shape", ["triangles", "tetrahedra"])
def test_points_repeated_for_each_cell_are_merged(shape):
    if shape == "triangles":
        points, cells = np.array([(0, 0), (1, 0), (0, 1), (1, 1)]), np.array([(0, 1, 2), (1, 3, 2)])
    else:
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)])
        cells = np.array([(0, 1, 2, 3), (1, 2, 3, 4)])
    make = getattr(dsc.Complex2 if shape == "triangles" else dsc.Complex3, "from_" + shape)
    repeated = np.arange(cells.size).reshape(cells.shape)
    c = make(points[cells].reshape(-1, points.shape[1]).astype(float), repeated, [1, 2], improve=False)
    assert c.number_of_vertices == len(points)
    assert c.number_of_cells == 2


def test_space_around_tetrahedra_is_filled():
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    c = dsc.Complex3.from_tetrahedra(points, [[0, 1, 2, 3]], [4], surround=True)
    assert c.labels == [0, 4]
    assert c.volumes[4] == pytest.approx(1 / 6)


def test_polygons_with_holes():
    outer = [(0, 0), (4, 0), (4, 4), (0, 4)]
    hole = [(1, 1), (2, 1), (2, 2), (1, 2)]
    c = dsc.Complex2.from_polygons([[outer, hole]])
    assert c.volumes[1] == pytest.approx(15)
    assert c.components == {0: 2, 1: 1}


def test_labels_of_polygons():
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    c = dsc.Complex2.from_polygons([[square], [square + [2, 0]]], [3, 5])
    assert c.labels == [0, 3, 5]


def test_voxels():
    x, y, z = np.meshgrid(np.arange(20), np.arange(24), np.arange(28), indexing="ij")
    inside = (x - 9.5) ** 2 + (y - 11.5) ** 2 + (z - 13.5) ** 2 < 36
    spacing, origin = (0.5, 0.5, 0.25), (10, 20, 30)
    c = dsc.Complex3.from_image(inside.astype(np.uint8), spacing, origin)
    assert c.labels == [0, 1] and c.is_valid()
    assert c.volumes[1] == pytest.approx(inside.sum() / 16, rel=1e-3)
    center = c.interface().points.mean(axis=0)
    assert center == pytest.approx([10 + 9.5 / 2, 20 + 11.5 / 2, 30 + 13.5 / 4], abs=0.1)
    before = c.volumes[1]
    c.offset(0.1)  # in the unit of the user, although the complex has another origin
    area = (c.volumes[1] - before) / 0.1
    assert area == pytest.approx(4 * np.pi * (36 * 0.5**2) ** 0.5 * 2, rel=0.5)


def test_voxels_that_fill_the_domain():
    labels = np.zeros((8, 8, 8), dtype=int)
    labels[4:] = 3
    c = dsc.Complex3.from_image(labels)
    assert c.volumes == pytest.approx({0: 256, 3: 256}, rel=1e-3)
    assert dsc.Complex3.from_image(labels - 2).labels == [-2, 1]


def test_voxels_in_a_larger_box():
    c = dsc.Complex3.from_image(np.full((4, 4, 4), 3), 1, (10, 10, 10), box=[(7, 7, 7), (17, 17, 17)])
    assert c.volumes == pytest.approx({0: 936, 3: 64}, rel=1e-3)
    points = c.cells().points
    assert points.min(axis=0) == pytest.approx([7, 7, 7]) and points.max(axis=0) == pytest.approx([17, 17, 17])


def test_pixels():
    labels = np.zeros((30, 20), dtype=np.int16)
    labels[5:10, 8:14] = 2
    c = dsc.Complex2.from_image(labels, 0.5, (3, 4))
    assert c.labels == [0, 2]
    assert c.volumes[2] == pytest.approx(30 / 4, rel=1e-6)
    assert sum(c.volumes.values()) == pytest.approx(600 / 4)
    center = c.interface().points.mean(axis=0)
    assert center == pytest.approx([3 + 7 / 2, 4 + 10.5 / 2], abs=0.2)


@pytest.mark.parametrize("labels", [np.zeros((4, 4, 4)), np.full((4, 4, 4), 0.5), np.array(["a"])])
def test_images_must_be_of_integers(labels):
    with pytest.raises((TypeError, ValueError)):
        dsc.Complex3.from_image(labels)


# Access


def test_cells_are_positively_oriented(round_complex):
    cells = round_complex.cells()
    edges = cells.points[cells.cells[:, 1:]] - cells.points[cells.cells[:, :1]]
    measures = np.linalg.det(edges) / (2 if round_complex.dimension == 2 else 6)
    assert measures.min() > 0
    for label, volume in round_complex.volumes.items():
        assert measures[cells.labels == label].sum() == pytest.approx(volume, rel=1e-10)


def test_facets_separate_labels(round_complex):
    facets = round_complex.interface()
    assert (facets.labels == [1, 0]).all()
    if round_complex.dimension == 3:  # the divergence theorem: normals point out of the larger label
        a, b, c = (facets.points[facets.facets[:, i]] for i in range(3))
        volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6
    else:  # the larger label is on the left
        a, b = (facets.points[facets.facets[:, i]] for i in range(2))
        volume = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2
    assert volume == pytest.approx(round_complex.volumes[1], rel=1e-10)


def test_qualities(round_complex):
    qualities = round_complex.qualities
    assert qualities.shape == (round_complex.number_of_cells,)
    assert 0.01 < qualities.min() and qualities.max() <= 1 + 1e-12


def test_ids_follow_vertices(round_complex):
    before = round_complex.interface()
    round_complex.deform(before.points * 1.02)
    after = round_complex.interface()
    kept, i, j = np.intersect1d(before.ids, after.ids, return_indices=True)
    assert len(kept) > 0.9 * len(before.ids)
    assert np.allclose(after.points[j], before.points[i] * 1.02, atol=0.01)


def test_numbers(round_complex):
    cells = round_complex.cells()
    assert round_complex.number_of_vertices == len(cells.points) == len(cells.ids)
    assert round_complex.number_of_cells == len(cells.cells) == len(cells.labels)
    assert 0.03 < round_complex.mean_interface_edge < 0.5
    assert f"{round_complex.number_of_cells} cells" in repr(round_complex)


# Storage


def test_a_copy_is_equal_and_independent(round_complex):
    for other in (round_complex.copy(), copy.copy(round_complex), copy.deepcopy(round_complex)):
        assert other == round_complex
        other.offset(0.01)
        assert other != round_complex


def test_pickle(round_complex):
    other = pickle.loads(pickle.dumps(round_complex))
    assert type(other) is type(round_complex) and other == round_complex
    assert other.offset(0.01).passes == round_complex.offset(0.01).passes
    assert other == round_complex


def test_a_checkpoint_file(round_complex, tmp_path: Path):
    path = tmp_path / "checkpoint.dsc"
    round_complex.save(path)
    assert [p.name for p in tmp_path.iterdir()] == ["checkpoint.dsc"]
    assert type(round_complex).read(path) == round_complex


def test_damaged_bytes_are_rejected(round_complex):
    data = round_complex.to_bytes()
    for damaged in (b"", data[:10], data[:-1], data[:100] + b"x" + data[101:], data + b"x"):
        with pytest.raises(dsc.FileError) as error:
            type(round_complex).from_bytes(damaged)
        assert error.value.path == "the checkpoint"


def test_bytes_of_the_other_dimension_are_rejected():
    with pytest.raises(dsc.FileError):
        dsc.Complex2.from_bytes(ball().to_bytes())


def test_complexes_are_not_hashable(round_complex):
    with pytest.raises(TypeError):
        hash(round_complex)
    assert round_complex != 3


# Motion


def test_round_corners_of_an_offset():
    square = dsc.Complex2.from_polygons([[np.array([(0, 0), (1, 0), (1, 1), (0, 1)])]])
    sharp = square.copy()
    assert square.offset(0.05, corners="round").complete
    assert square.volumes[1] == pytest.approx(1.2 + 0.0025 * np.pi, rel=1e-3)
    sharp.offset(0.05)
    assert sharp.volumes[1] == pytest.approx(1.21)
    with pytest.raises(ValueError, match="'miter', 'round'"):
        sharp.offset(0.05, corners="sharp")


def test_offset(round_complex):
    before = round_complex.volumes[1]
    report = round_complex.offset(0.02)
    assert report.complete and report.passes > 0 and len(report.unfinished_points) == 0
    d = round_complex.dimension
    radius = 0.5
    growth = exact_volume(d, radius + 0.02) / exact_volume(d, radius)
    assert round_complex.volumes[1] / before == pytest.approx(growth, rel=0.01)
    (change,) = [c for c in report.labels if c.label == 1]
    assert change.volume_before == pytest.approx(before)
    assert change.volume_after == pytest.approx(round_complex.volumes[1])


def test_a_rotation_changes_nothing_but_positions(round_complex):
    before = round_complex.interface()

    def rotation(points, t):
        return np.c_[-points[:, 1], points[:, 0], 0 * points[:, 2:]]

    for i in range(4):
        report = round_complex.advect(rotation, i * 0.05, 0.05, scheme="rk4")
        assert report.complete
    after = round_complex.interface()
    c, s = np.cos(0.2), np.sin(0.2)
    turn = np.eye(round_complex.dimension)
    turn[:2, :2] = [[c, -s], [s, c]]
    assert np.allclose(after.points, before.points @ turn.T, atol=1e-7)


def test_velocities_also_move_space():
    """A shear of the whole space: without it, vertices off the interface would stay behind."""
    c = ball()
    shear = np.array([[0, 0.3, 0], [0, 0, 0], [0, 0, 0]])
    calls = []

    def velocity(points, t):
        calls.append(len(points))
        return points @ shear.T

    interface_vertices = len(c.interface().points)
    assert c.advect(velocity, 0, 0.1).complete
    assert max(calls) > interface_vertices  # free vertices, too
    assert len(calls) < 20


@pytest.mark.parametrize("scheme, order", [("euler", 1), ("rk2", 2), ("rk4", 4), ("adaptive", 4)])
def test_schemes_of_integration(scheme, order):
    """A rotation about a distant center; the error of a step is of order dt^(order + 1)."""
    errors = []
    for dt in (0.2, 0.1):
        c = dsc.Complex2.from_polygons([[[(0, 0), (0.1, 0), (0.1, 0.1), (0, 0.1)]]], box=[(-1, -1), (1, 1)])
        start = c.interface().points
        c.advect(lambda p, t: np.c_[-p[:, 1], p[:, 0] + 0.5], 0, dt, scheme=scheme, topology="forbid")
        center = np.array([-0.5, 0])
        turn = np.array([[np.cos(dt), -np.sin(dt)], [np.sin(dt), np.cos(dt)]])
        errors.append(np.abs(c.interface().points - ((start - center) @ turn.T + center)).max())
    if scheme == "adaptive":
        assert max(errors) < 1e-4
    else:
        assert errors[0] / errors[1] > 2 ** (order + 0.5)


def test_mean_curvature(round_complex):
    """A sphere of radius r shrinks by dr/dt = -2/r, a circle by -1/r."""
    d = round_complex.dimension
    volume = round_complex.volumes[1]
    steps, dt = 5, 0.002
    for _ in range(steps):
        round_complex.mean_curvature(dt)
    radius = (volume / exact_volume(d, 1)) ** (1 / d)
    expected = np.sqrt(radius**2 - 2 * (d - 1) * steps * dt)
    assert round_complex.volumes[1] == pytest.approx(exact_volume(d, expected), rel=0.02)


def test_mean_curvature_keeps_volumes(round_complex):
    before = round_complex.volumes
    round_complex.mean_curvature(0.001, keep_volumes=True)
    assert round_complex.volumes == pytest.approx(before, rel=2e-3)


def test_mean_curvature_cannot_go_back(round_complex):
    with pytest.raises(dsc.Error):
        round_complex.mean_curvature(-0.1)


def test_deform(round_complex):
    points = round_complex.interface().points
    report = round_complex.deform(points + 0.01, maximum_passes=20, minimum_angle=2)
    assert report.complete
    assert np.allclose(round_complex.interface().points, points + 0.01)


def test_restore_volumes(round_complex):
    target = round_complex.volumes[1] * 1.05
    assert round_complex.restore_volumes({1: target})
    assert round_complex.volumes[1] == pytest.approx(target, rel=1e-4)


def test_adaptive_advection():
    c = disk()
    for i in range(3):
        report = c.advect(lambda p, t: np.c_[p[:, 0], -p[:, 1]], i * 0.1, 0.1, adapt=True, adaptation_interval=1)
    assert report.complete and c.is_valid()
    assert c.volumes[1] == pytest.approx(np.pi / 4, rel=0.02)


# Topology


def two_disks():
    return dsc.Complex2.from_polygons(
        [
            [[(np.cos(a) * 0.3 + x, np.sin(a) * 0.3) for a in np.arange(24) * np.pi / 12]]
            for x in (-0.35, 0.35)
        ],
        box=[(-1, -1), (1, 1)],
    )


def one_label(c):
    cells = c.cells()
    return dsc.Complex2.from_triangles(cells.points, cells.cells, np.minimum(cells.labels, 1))


def grow(c, **options):
    events = []
    for _ in range(10):
        events += c.offset(0.015, **options).events
    return events


def test_disks_merge():
    c = one_label(two_disks())
    assert c.components[1] == 2
    # A merge that is undone in the same pass is reported as two events.
    event = [e for e in grow(c) if e.kind == "merged" and e.label == 1][-1]
    assert len(event.volumes_before) == 2 and len(event.volumes_after) == 1
    assert event.where.shape == (2,) and abs(event.where[0]) < 0.1
    assert c.components[1] == 1


@pytest.mark.parametrize("topology", ["forbid", [], [(2, 3)], lambda label, new, point: False])
def test_disks_do_not_merge(topology):
    c = one_label(two_disks())
    assert grow(c, topology=topology) == []
    assert c.components[1] == 2 and c.is_valid()


@pytest.mark.parametrize("topology", ["allow", [(1, 0)], lambda label, new, point: {label, new} == {0, 1}])
def test_merging_is_permitted(topology):
    c = one_label(two_disks())
    grow(c, topology=topology)
    assert c.components[1] == 1


def test_a_topology_function_sees_labels_and_places():
    seen = []

    def control(label, new_label, point):
        seen.append((label, new_label, point.shape))
        return True

    grow(one_label(two_disks()), topology=control)
    assert seen and all({a, b} == {0, 1} and shape == (2,) for a, b, shape in seen)


# Remeshing


def test_improve(round_complex):
    interface = round_complex.interface()
    changes = round_complex.improve(quality_threshold=0.9)
    assert changes.smoothed_vertices + changes.flipped > 0
    assert np.array_equal(round_complex.interface().points, interface.points)
    assert round_complex.is_valid()


def test_improve_interface(round_complex):
    before = round_complex.volumes[1]
    round_complex.improve_interface(number_of_iterations=2, aggressiveness=0.1)
    assert round_complex.volumes[1] == pytest.approx(before, rel=0.02)
    assert round_complex.is_valid()


def test_control_detail_splits():
    c = ball(0.4)  # with edges inside between vertices of the interface
    before = c.number_of_cells
    changes = c.control_detail(split_length=0.6, collapse_length=0)
    assert changes.split_edges > 0 and c.number_of_cells > before
    assert c.is_valid()


def test_control_detail_collapses(round_complex):
    before = round_complex.number_of_cells
    changes = round_complex.control_detail(collapse_length=3)
    assert changes.collapsed_edges > 0 and round_complex.number_of_cells < before
    assert round_complex.is_valid()


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_threads_do_not_change_the_result(round_complex, threads):
    other = round_complex.copy()
    for c, number in ((round_complex, 1), (other, threads)):
        c.offset(0.02, threads=number)
        c.improve(threads=number)
    assert other == round_complex


# Domains and thin parts


def test_domain_grows_with_a_motion():
    c = ball()
    volume, box = c.volumes[1], sum(c.volumes.values())
    report = c.advect(lambda p, t: np.broadcast_to([0.8, 0, 0], p.shape), 0.0, 1.0)
    assert report.stopped_at_boundary == 0
    assert c.volumes[1] == pytest.approx(volume, rel=0.01)
    assert sum(c.volumes.values()) > 1.5 * box
    c = ball()
    with pytest.raises(dsc.InvalidDestinationError):
        c.offset(2.0, domain="refuse", largest_displacement=0)
    assert c.offset(2.0, domain="stop").stopped_at_boundary > 0


def test_thin_parts_are_resolved():
    plate = np.array([(x, y, z) for z in (0, 1) for y in (0, 60) for x in (0, 60)], dtype=float)
    triangles = np.array(
        [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4)]
        + [(2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    )
    c = dsc.Complex3.from_surfaces([(plate, triangles)])
    assert len(c.interface().facets) > 1000
    assert c.volumes[1] == pytest.approx(3600)
    c = dsc.Complex3.from_surfaces([(plate, triangles)], edge_per_thickness=0)
    assert len(c.interface().facets) == 12
    with pytest.warns(dsc.VolumeWarning, match="more facets would resolve them"):
        dsc.Complex3.from_surfaces([(plate, triangles)], most_new_facets=100)
