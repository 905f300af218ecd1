"""Fluids in the plane, with sides, and two liquids that slip: exact values, with few vertices."""

from __future__ import annotations

import dsc
import numpy as np
import pytest
from shapes import CUBE_POINTS, CUBE_TRIANGLES, ball, disk, polygon, rectangle, rotation


def droplet(**options):
    return dsc.Fluid(disk(0.15), {1: dsc.Liquid(1.0, 0.05)}, tensions={(0, 1): 0.1}, **options)


def pool(density=2.0, gravity=5.0):
    c = rectangle(6, 6, (1, 1), lambda p: np.where(p[:, 1] < 0.5, 1, 0))
    return dsc.Fluid(c, {1: dsc.Liquid(density)}, gravity=(0, -gravity))


def two_liquids(viscosity=0.0, tension=0.0):
    """Returns a disk of liquid 1 in liquid 0."""
    c = polygon(24, [(-1, -1), (1, 1)], lambda angle: 0.5)
    liquid = dsc.Liquid(1.0, viscosity)
    return dsc.Fluid(c, {0: liquid, 1: liquid}, tensions={(0, 1): tension})


def vertices_of(fluid, label):
    cells = fluid.complex.cells()
    return np.unique(cells.cells[cells.labels == label])


def test_hydrostatic_pressure():
    fluid = pool(density=2.0, gravity=5.0)
    assert fluid.step(0.05, adaptation_interval=0).greatest_velocity < 1e-9
    height = fluid.complex.cells().points[:, 1]
    exact = np.where(height < 0.5, 10 * (0.5 - height), 0)
    assert fluid.pressures == pytest.approx(exact, abs=1e-6)
    assert fluid.pressures_of(1) == pytest.approx(exact, abs=1e-6)


def test_a_moving_side_drags_a_viscous_liquid():
    """In the middle of a long closed box, the flow is parallel, and no liquid passes in total."""
    c = rectangle(24, 6, (4, 1), lambda p: np.where(p[:, 0] < 3.5, 1, 2))
    fluid = dsc.Fluid(c, {1: dsc.Liquid(1.0, 10.0), 2: dsc.Liquid(1.0, 10.0)})
    fluid.set_side("y-")
    fluid.set_side("y+", velocity=(1, 7))  # across the side: no effect
    for _ in range(8):
        fluid.step(0.01, implicitness=1)
    x, y = fluid.complex.cells().points.T
    velocities = fluid.velocities_of(1)
    inner = (x > 0.5) & (x < 3)
    assert velocities[inner & (y == 1)] == pytest.approx(np.tile([1, 0], (np.sum(inner & (y == 1)), 1)))
    assert velocities[inner & (y == 0)] == pytest.approx(0)
    middle = (x > 1) & (x < 2.5)
    assert velocities[middle, 0] == pytest.approx(3 * y[middle] ** 2 - 2 * y[middle], abs=0.1)


def test_a_slip_side_drags_nothing():
    c = rectangle(6, 6, (1, 1), lambda p: np.where(p[:, 1] < 0.5, 1, 2))
    fluid = dsc.Fluid(c, {1: dsc.Liquid(1.0, 1.0), 2: dsc.Liquid(1.0, 1.0)})
    fluid.set_side("y+", velocity=(1, 0))
    fluid.set_side("y+", slip=True)
    assert fluid.step(0.05).greatest_velocity < 1e-9


def test_liquid_leaves_and_enters_through_sides():
    fluid = pool()
    fluid.set_side("x+", slip=True, pressure=lambda p, t: 0 if p[1] < 2 else None)
    fluid.set_side("y-", inflow=lambda p, t: (0, 0.1) if p[0] < 0.6 else None)
    before = fluid.balance.volume
    report = fluid.step(0.02)
    assert report.volume_through_sides.shape == (4,)
    assert report.volume_through_sides[1] < 0 < report.volume_through_sides[2]
    gained = report.volume_through_sides.sum()
    assert report.gained_volume == pytest.approx(gained, abs=1e-12)
    assert report.balance.volume - before == pytest.approx(gained, abs=1e-10)


def test_velocities_of_one_liquid():
    fluid = two_liquids()
    points = fluid.complex.cells().points
    inner = vertices_of(fluid, 1)
    fluid.set_velocities(rotation, label=1)
    assert fluid.velocities_of(1)[inner] == pytest.approx(rotation(points)[inner])
    assert fluid.velocities_of(0) == pytest.approx(0)
    off = np.setdiff1d(np.arange(len(points)), inner)
    assert np.all(fluid.velocities_of(1)[off] == 0)


def test_velocities_of_the_other_liquid_are_kept():
    fluid = two_liquids()
    points = fluid.complex.cells().points
    fluid.set_velocities(np.tile([0.1, 0.2], (len(points), 1)))
    before = fluid.velocities_of(0)
    fluid.set_velocities(rotation(points), label=1)
    assert fluid.velocities_of(0) == pytest.approx(before)
    fluid.set_velocities(0 * points, label=0)
    inner = vertices_of(fluid, 1)
    assert fluid.velocities_of(1)[inner] == pytest.approx(rotation(points)[inner])


def test_pressures_of_two_liquids():
    """The law of Laplace: the pressures differ by sigma / r."""
    fluid = two_liquids(viscosity=0.1, tension=0.1)
    fluid.step(0.01)
    both = np.intersect1d(vertices_of(fluid, 0), vertices_of(fluid, 1))
    inside, outside = fluid.pressures_of(1)[both], fluid.pressures_of(0)[both]
    assert np.mean(inside - outside) == pytest.approx(0.1 / 0.5, rel=0.1)
    assert fluid.pressures[both] == pytest.approx((inside + outside) / 2)


@pytest.mark.parametrize(
    "call",
    [
        lambda: dsc.Fluid(disk(0.3), {1: dsc.Liquid(1.0)}, gravity=(0, 0, -1)),
        lambda: dsc.Fluid(ball(0.4), {1: dsc.Liquid(1.0)}, gravity=(0, -1)),
        lambda: droplet().add_plane((0, 0, 0), (0, 0, 1)),
        lambda: droplet().add_ball((0, 0, 0), 1),
        lambda: droplet().add_tank([(0, 0, 0), (1, 1, 1)]),
        lambda: droplet().set_sources([dsc.Source((0, 0, 0), 0.3, 0.02)]),
        lambda: droplet().set_velocities(np.zeros((3, 2))),
        lambda: droplet().set_velocities(lambda p: np.zeros((len(p), 3))),
        lambda: droplet().set_velocities(lambda p: 0 * p, label=0),
        lambda: droplet().velocities_of(7),
        lambda: droplet().pressures_of(0),
        lambda: droplet().set_side("z-"),
        lambda: droplet().set_side("y"),
        lambda: droplet().set_side("y-", velocity=(0, 0, 1)),
        lambda: droplet().set_side("y-", velocity=(1, 0), slip=True),
        lambda: droplet().set_side("y-", inflow=(0, 1), pressure=0),
        lambda: droplet().set_side("y-", inflow=(0, 0, 1)),
    ],
)
def test_values_that_do_not_fit(call):
    with pytest.raises(ValueError):
        call()


@pytest.mark.parametrize(
    "call",
    [
        lambda: droplet().add_cylinder((0, 0), (1, 0), 1),
        lambda: droplet().add_mesh(CUBE_POINTS, CUBE_TRIANGLES),
        lambda: droplet().add_plane((0, 0), (0, 0)),
        lambda: droplet().add_ball((0, 0), 1, contact_angle=200),
        lambda: droplet().add_tank([(0, 0), (1, 0)]),
        lambda: droplet().set_side("y-", velocity=(np.nan, 0)),
        lambda: droplet().set_velocities(lambda p: np.nan * p),
    ],
)
def test_errors_in_the_plane(call):
    with pytest.raises(dsc.Error):
        call()


def test_unknown_options_of_walls():
    with pytest.raises(TypeError, match="unknown option 'angle'"):
        droplet().add_plane((0, -1), (0, 1), angle=90)
    with pytest.raises(TypeError, match="contact_angle"):
        droplet().add_plane((0, -1), (0, 1), contact_angle="flat")


def test_sides_in_space():
    fluid = dsc.Fluid(ball(0.4), {0: dsc.Liquid(1.0, 1.0), 1: dsc.Liquid(1.0, 1.0)})
    fluid.set_side("z+", velocity=(1, 0, 0))
    fluid.step(0.01)
    points = fluid.complex.cells().points
    on_side = (points[:, 2] == 1) & (np.abs(points[:, :2]).max(axis=1) < 1)
    assert np.any(on_side)
    assert fluid.velocities_of(0)[on_side] == pytest.approx(np.tile([1, 0, 0], (np.sum(on_side), 1)))


def test_a_drop_moves_to_smaller_tensions():
    c = polygon(24, [(-1, -1), (1, 1)], lambda angle: 0.4)
    liquid = dsc.Liquid(1.0, 0.1, diffusivity=0.1)
    fluid = dsc.Fluid(
        c,
        {0: liquid, 1: liquid},
        tensions={(0, 1): lambda t: 1 - 0.2 * t},
        field=lambda points: points[:, 1],
    )
    assert fluid.balance.greatest_field == pytest.approx(1)
    fluid.fix_field(lambda points, t: np.where(points[:, 1] > 0.99, 1, np.nan))
    for _ in range(5):
        report = fluid.step(0.05)
    assert report.balance.field_integral == pytest.approx(0, abs=0.1)
    points = fluid.complex.cells().points
    assert fluid.field[points[:, 1] > 0.99] == pytest.approx(1)
    heights = points[vertices_of(fluid, 1), 1]
    assert (heights.min() + heights.max()) / 2 > 0.002  # 0 at the beginning


def test_wrong_fields():
    with pytest.raises(TypeError, match="field must be a function"):
        droplet(field=1)
    with pytest.raises(TypeError, match="one number for each point"):
        droplet(field=lambda points: "a")
    with pytest.raises(dsc.Error, match="not finite"):
        droplet(field=lambda points: np.full(len(points), np.nan))
    with pytest.raises(TypeError, match="a surface tension must be a number"):
        dsc.Fluid(disk(0.15), {1: dsc.Liquid(1.0)}, tensions={(0, 1): "c"})
