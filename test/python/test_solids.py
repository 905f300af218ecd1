"""Rigid bodies, solids that move, sources with a flux, gravity and vorticity: exact values."""

from __future__ import annotations

import dsc
import numpy as np
import pytest
from shapes import CUBE_POINTS, CUBE_TRIANGLES, ball, disk, rotation


def circle(radius, edge):
    corners = round(2 * np.pi * radius / edge)
    angles = 2 * np.pi * np.arange(corners) / corners
    return radius * np.c_[np.cos(angles), np.sin(angles)]


def divided(corners, edge):
    """Returns a polygon whose sides are divided into edges."""
    points = []
    for p, q in zip(np.array(corners), np.roll(corners, -1, axis=0)):
        parts = round(np.linalg.norm(q - p) / edge)
        points.extend(p + (q - p) * k / parts for k in range(parts))
    return np.array(points)


def floating_box(draught, **options):
    """Returns a tank of width 2 with a box of width 1 and half the density of the liquid."""
    bottom = 1 - draught
    bay = [(1.5, 1), (1.5, bottom), (0.5, bottom), (0.5, 1)]
    polygon = divided([(0, 0), (2, 0), (2, 1), *bay, (0, 1)], 0.1)
    c = dsc.Complex2.from_polygons([[polygon]], box=[(-0.5, -0.5), (2.5, 2)])
    fluid = dsc.Fluid(c, {1: dsc.Liquid(1.0)}, gravity=(0, -1))
    fluid.add_tank([(0, 0), (2, 2)], is_open=True)
    fluid.add_box((0.5, bottom), (1.5, bottom + 0.6), density=0.5, **options)
    return fluid


def annulus(radius, viscosity):
    """Returns a liquid between a circle and the unit circle."""
    c = dsc.Complex2.from_polygons(
        [[circle(1, 0.1), circle(radius, 0.1)]], box=[(-1.5, -1.5), (1.5, 1.5)]
    )
    return dsc.Fluid(c, {1: dsc.Liquid(1.0, viscosity)})


def droplet(**options):
    return dsc.Fluid(disk(0.15), {1: dsc.Liquid(1.0, 0.05)}, **options)


def test_a_floating_box_rests():
    """The law of Archimedes: the box displaces its own mass."""
    fluid = floating_box(0.3)
    for _ in range(5):
        report = fluid.step(0.05)
    (body,) = fluid.bodies
    assert isinstance(body, dsc.Body)
    assert body.center == pytest.approx([1, 1], abs=1e-9)
    assert body.velocity == pytest.approx([0, 0], abs=1e-9)
    assert abs(body.angular_velocity) < 1e-9 and abs(body.rotation) < 1e-9
    assert body.mass == pytest.approx(0.3, rel=1e-14)
    assert report.forces_on_solids[1] == pytest.approx([0, 0.3], abs=1e-9)
    assert report.torques_on_solids.shape == (2,)
    assert report.torques_on_solids[1] == pytest.approx(0.3, abs=1e-9)  # of a force through (1, y)


def test_a_fixed_body_does_not_move():
    fluid = floating_box(0.2, fixed=("x", "y", "rotation"))
    before = fluid.bodies[0]
    fluid.add_ball((1, 1.9), 0.05, density=3)  # above the liquid
    fluid.step(0.1)
    after, disk = fluid.bodies
    assert disk.mass == pytest.approx(3 * np.pi * 0.05**2)
    assert disk.velocity == pytest.approx([0, -0.1], abs=1e-9)
    assert np.array_equal(after.center, before.center)
    assert np.all(after.velocity == 0) and after.angular_velocity == 0 and after.rotation == 0


@pytest.mark.parametrize(
    "motion", [{"motion": lambda t: ((0, 0), 0.5 * t)}, {"angular_velocity": 0.5}]
)
def test_a_wheel_has_the_torque_of_couette_flow(motion):
    radius = 0.4
    fluid = annulus(radius, viscosity=1)
    fluid.add_ball((0, 0), radius, no_slip=True, separates=False, **motion)
    fluid.add_ball((0, 0), 1, outside=True, no_slip=True, separates=False)
    for _ in range(8):
        report = fluid.step(0.1, implicitness=1)
    exact = 4 * np.pi * 0.5 * radius**2 / (1 - radius**2)
    assert report.torques_on_solids == pytest.approx([-exact, exact], rel=0.08)
    assert fluid.bodies == []


def test_velocities_of_a_motion():
    """A liquid that fills a circle moves with it, by the derivative of the displacement."""
    c = dsc.Complex2.from_polygons([[circle(1, 0.2)]], box=[(-2, -2), (2, 2)])
    fluid = dsc.Fluid(c, {1: dsc.Liquid(1.0)})
    times = []

    def motion(t):
        times.append(t)
        return (0.1 * np.sin(t), 0), 0

    fluid.add_ball((0, 0), 1, outside=True, separates=False, motion=motion)
    for _ in range(3):
        fluid.step(0.05)
        balance = fluid.balance
        exact = [0.1 * np.cos(fluid.time), 0]
        assert balance.momentum / balance.mass == pytest.approx(exact, abs=0.002)
    assert min(times) == 0


def test_a_step_of_a_motion_that_changes_no_time():
    fluid = droplet()
    fluid.add_plane((0, -2), (0, 1), motion=still, motion_step=1e-20)
    with pytest.raises(dsc.Error, match="too short"):
        fluid.step(0.1)


def test_bodies_in_space_fall_and_rotate():
    fluid = dsc.Fluid(ball(0.25), {1: dsc.Liquid(1.0)}, gravity=(0, 0, -1))
    points = 0.2 * CUBE_POINTS + 0.7
    fluid.add_box((-0.9, -0.9, -0.9), (-0.7, -0.7, -0.7), density=2, velocity=(0.1, 0, 0))
    fluid.add_mesh(points, CUBE_TRIANGLES, density=2, angular_velocity=(0, 0, 1))
    fluid.add_ball((0.8, -0.8, 0.8), 0.1, density=3, fixed=["z"])
    fluid.set_gravity((0, 0, -2))
    report = fluid.step(0.1)
    box, mesh, sphere = fluid.bodies
    assert box.mass == pytest.approx(0.016) and mesh.mass == pytest.approx(0.016)
    assert sphere.mass == pytest.approx(3 * 4 / 3 * np.pi * 1e-3)
    assert box.velocity == pytest.approx([0.1, 0, -0.2], abs=1e-9)
    assert box.center == pytest.approx([-0.79, -0.8, -0.81], abs=1e-9)
    assert mesh.angular_velocity == pytest.approx([0, 0, 1], abs=1e-9)
    assert mesh.rotation == pytest.approx([np.cos(0.05), 0, 0, np.sin(0.05)], abs=1e-3)
    assert sphere.velocity == pytest.approx([0, 0, 0], abs=1e-12)
    assert report.torques_on_solids.shape == (3, 3)


def test_the_flux_of_a_source_is_exact():
    fluid = droplet()
    expected = fluid.balance.volume
    fluid.add_source(lambda p: np.linalg.norm(p, axis=1) < 0.3, lambda t: 1 + t)
    fluid.add_source(lambda p: p[:, 0] < 0, -0.5)
    fluid.add_source(lambda p: p[:, 0] > 100, 1)  # no cell
    for _ in range(3):
        gained = 0.01 * (0.5 + fluid.time + 0.005)
        report = fluid.step(0.01)
        expected += gained
        assert report.gained_volume == pytest.approx(gained, abs=1e-12)
        assert fluid.balance.volume == pytest.approx(expected, abs=1e-11)


def test_a_source_in_space():
    fluid = dsc.Fluid(ball(0.25), {1: dsc.Liquid(1.0)})
    before = fluid.balance.volume
    fluid.add_source(lambda p: p[:, 2] > 0, 0.1)
    fluid.step(0.1)
    assert fluid.balance.volume - before == pytest.approx(0.01, abs=1e-11)


def test_vorticity_of_a_rigid_rotation():
    fluid = droplet()
    fluid.set_velocities(rotation)
    labels = fluid.complex.cells().labels
    assert fluid.vorticity == pytest.approx(np.where(labels == 1, 2, 0), abs=1e-10)


def test_vorticity_in_space():
    fluid = dsc.Fluid(ball(0.25), {1: dsc.Liquid(1.0)})
    fluid.set_velocities(lambda p: np.c_[-p[:, 1], p[:, 0], 0 * p[:, 2]])
    labels = fluid.complex.cells().labels
    exact = np.where((labels == 1)[:, None], [0, 0, 2], 0)
    assert fluid.vorticity == pytest.approx(exact, abs=1e-10)


def still(t):
    return (0, 0), 0


@pytest.mark.parametrize(
    "call",
    [
        lambda f: f.add_box((0, 0, 0), (1, 1, 1)),
        lambda f: f.add_ball((0, 0), 1, outside=True, density=1),
        lambda f: f.add_ball((0, 0), 1, fixed=["x"]),
        lambda f: f.add_ball((0, 0), 1, density=1, fixed=["z"]),
        lambda f: f.add_ball((0, 0), 1, density=1, fixed=["x"], velocity=(1, 0)),
        lambda f: f.add_ball((0, 0), 1, density=1, fixed="rotation", angular_velocity=1),
        lambda f: f.add_ball((0, 0), 1, density=1, motion=still),
        lambda f: f.add_ball((0, 0), 1, velocity=(1, 0), motion=still),
        lambda f: f.add_ball((0, 0), 1, velocity=(1, 0, 0)),
        lambda f: f.add_ball((0, 0), 1, motion=lambda t: (0, 0, 0)),
        lambda f: f.add_ball((0, 0), 1, motion=lambda t: ((0, 0, 0), 0)),
        lambda f: f.add_ball((0, 0), 1, motion=still, motion_step=0),
        lambda f: f.set_gravity((0, 0, 1)),
    ],
)
def test_values_that_do_not_fit(call):
    fluid = droplet()
    with pytest.raises(ValueError):
        call(fluid)
    assert fluid.bodies == []


@pytest.mark.parametrize(
    "call",
    [
        lambda f: f.add_plane((0, -1), (0, 1), density=1),
        lambda f: f.add_ball((0, 0), 1, density="heavy"),
        lambda f: f.add_ball((0, 0), 1, angular_velocity=(0, 0, 1)),
        lambda f: f.add_ball((0, 0), 1, motion=1),
        lambda f: f.add_source(0.3, 1),
        lambda f: f.add_source(lambda p: p[:, 0] > 0, "much"),
    ],
)
def test_wrong_types(call):
    with pytest.raises(TypeError):
        call(droplet())


@pytest.mark.parametrize(
    "call",
    [
        lambda f: f.add_box((0, 0), (1, 0)),
        lambda f: f.add_box((0, 0), (1, 1), density=0),
        lambda f: f.add_ball((0, 0), 1, density=np.inf),
        lambda f: f.add_ball((0, 0), 1, density=1, velocity=(np.nan, 0)),
        lambda f: f.set_gravity((np.nan, 0)),
    ],
)
def test_errors(call):
    with pytest.raises(dsc.Error):
        call(droplet())


def test_messages_name_the_value():
    with pytest.raises(dsc.InvalidSolidError, match="the solid, field 'density': must be finite"):
        droplet().add_ball((0, 0), 1, density=np.inf)
    with pytest.raises(ValueError, match="'fixed': has no effect without the field 'density'"):
        droplet().add_ball((0, 0), 1, fixed=["x"])


def failing(t):
    if t > 0.01:
        raise ZeroDivisionError
    return (0, 0), 0


@pytest.mark.parametrize(
    "set_up, error",
    [
        (lambda f: f.add_source(lambda p: p[:, 0] > 0, 1e6), dsc.Error),
        (lambda f: f.add_source(lambda p: p[:, 0] > 0, lambda t: 1 / 0), ZeroDivisionError),
        (lambda f: f.add_source(lambda p: p[:, 0], 1), TypeError),
        (lambda f: f.add_source(lambda p: p > 0, 1), ValueError),
        (lambda f: f.add_plane((0, -0.6), (0, 1), motion=failing), ZeroDivisionError),
    ],
)
def test_errors_in_a_step(set_up, error):
    fluid = droplet()
    set_up(fluid)
    with pytest.raises(error):
        fluid.step(0.1)
    assert fluid.time == 0 and fluid.complex.is_valid()
