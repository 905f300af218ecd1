"""Fluids: conservation laws and exact values, with few vertices."""

from __future__ import annotations

import dsc
import numpy as np
import pytest
from shapes import CUBE_POINTS, CUBE_TRIANGLES, ball, disk


def droplet(tension=0.1, d=3, **options):
    c = ball(0.25) if d == 3 else disk(0.15)
    return dsc.Fluid(c, {1: dsc.Liquid(1.0, 0.05)}, tensions={(0, 1): tension}, **options)


@pytest.mark.parametrize("d", [2, 3])
def test_free_fall(d):
    gravity = -np.eye(d)[d - 1]
    fluid = droplet(tension=0, d=d, gravity=gravity)
    assert isinstance(fluid.complex, dsc.Complex2 if d == 2 else dsc.Complex3)
    volume = fluid.balance.volume
    for _ in range(3):
        report = fluid.step(0.05)
    assert fluid.time == pytest.approx(0.15)
    balance = fluid.balance
    assert balance.momentum == pytest.approx(0.15 * balance.mass * gravity, abs=1e-9)
    assert balance.volume == pytest.approx(volume, rel=1e-9)
    assert d == 3 or balance.mass == pytest.approx(np.pi / 4, rel=0.05)
    assert isinstance(balance.angular_momentum, float) == (d == 2)
    assert report.dt == 0.05 and report.repetitions == 0 and report.volume_error < 1e-9
    assert report.deformation.complete
    assert report.greatest_velocity == pytest.approx(0.15, rel=0.1)
    assert report.forces_on_solids.shape == (0, d)
    assert fluid.velocities.shape == fluid.complex.cells().points.shape


def test_the_fluid_works_on_a_copy():
    c = ball(0.25)
    before = c.copy()
    fluid = dsc.Fluid(c, {1: dsc.Liquid(1.0)}, gravity=(0, 0, -1))
    fluid.step(0.1)
    assert c == before and fluid.complex != before
    assert fluid.complex.is_valid()


def test_pressure_of_a_drop():
    """The law of Laplace: the pressure inside a ball is 2 sigma / r."""
    fluid = droplet()
    fluid.relax(0.5, 3)
    fluid.step(0.01)
    cells = fluid.complex.cells()
    inside = np.setdiff1d(cells.cells[cells.labels == 1], cells.cells[cells.labels == 0])
    assert np.mean(fluid.pressures[inside]) == pytest.approx(2 * 0.1 / 0.5, rel=0.1)


def test_velocities():
    fluid = droplet(tension=0)
    points = fluid.complex.cells().points
    fluid.set_velocities(np.tile([0.3, 0, 0], (len(points), 1)))
    fluid.step(0.05)
    assert fluid.balance.momentum[0] == pytest.approx(0.3 * fluid.balance.mass, rel=1e-6)
    speeds = np.linalg.norm(fluid.velocities, axis=1)
    assert speeds.shape == (len(fluid.complex.cells().points),)
    assert speeds.max() == pytest.approx(0.3, rel=0.05)
    assert 0 < fluid.largest_step() < 1


@pytest.mark.parametrize(
    "d, add",
    [
        (2, lambda f: f.add_plane((0, -0.55), (0, 1), no_slip=True)),
        (2, lambda f: f.add_ball((0, -1), 0.45, contact_angle=120)),
        (2, lambda f: f.add_tank([(-0.9, -0.55), (0.9, 0.5)], is_open=True, separates=False)),
        (3, lambda f: f.add_plane((0, 0, -0.55), (0, 0, 1), no_slip=True)),
        (3, lambda f: f.add_ball((0, 0, -1), 0.45, contact_angle=120)),
        (3, lambda f: f.add_tank([(-0.9, -0.9, -0.55), (0.9, 0.9, 0.5)], is_open=True)),
        (3, lambda f: f.add_cylinder((0, 0, -1), (1, 0, 0), 0.45)),
        (3, lambda f: f.add_mesh(CUBE_POINTS - [0.5, 0.5, 1.55], CUBE_TRIANGLES)),
    ],
)
def test_a_drop_lands_on_solids(d, add):
    fluid = droplet(d=d, gravity=-2 * np.eye(d)[d - 1])
    add(fluid)
    for _ in range(5):
        report = fluid.step(0.1)
    assert report.forces_on_solids.shape == (1, d)
    assert report.contacts > 0 and report.depth_in_solids < 0.05


@pytest.mark.parametrize("d", [2, 3])
def test_a_source(d):
    fluid = droplet(d=d)
    before = fluid.balance.volume
    fluid.set_sources([dsc.Source([0] * d, 0.3, 0.02)])
    fluid.step(0.1)
    assert fluid.balance.volume - before == pytest.approx(0.002, rel=0.6)  # few cells are in the ball


def test_errors():
    c = ball(0.25)
    with pytest.raises(dsc.Error, match="liquid"):
        dsc.Fluid(c, {5: dsc.Liquid(1.0)})
    with pytest.raises(dsc.Error, match="density"):
        dsc.Fluid(c, {1: dsc.Liquid(-1.0)})
    with pytest.raises(dsc.Error, match="already"):
        dsc.Fluid(c, {1: dsc.Liquid(1.0)}, gases={1: dsc.Gas(1.0)})
    fluid = droplet()
    with pytest.raises(dsc.Error):
        fluid.step(-1)
    with pytest.raises(dsc.Error):
        fluid.add_ball((0, 0, 0), -1)
    with pytest.raises(TypeError, match="unknown option"):
        fluid.step(0.1, unknown=1)
    with pytest.raises(ValueError):
        fluid.set_velocities([[0, 0, 0]])
    with pytest.raises(IndexError):
        fluid.add_mesh(CUBE_POINTS[:3], CUBE_TRIANGLES)


@pytest.mark.parametrize("source", [((0, 0, 0), 0, 1), ((0, 0, 0), 1, np.inf), ((np.nan, 0, 0), 1, 1)])
def test_wrong_sources(source):
    with pytest.raises(ValueError, match="source"):
        droplet().set_sources([dsc.Source(*source)])


def test_a_tension_given_twice():
    with pytest.raises(ValueError, match="twice"):
        dsc.Fluid(ball(0.25), {1: dsc.Liquid(1.0)}, tensions={(0, 1): 1, (1, 0): 2})


def test_a_step_can_be_interrupted():
    fluid = droplet(gravity=(0, 0, -1))
    with pytest.raises(dsc.Interrupted):
        for _ in range(1000):
            fluid.step(0.001, progress=lambda phase: False)
    assert fluid.complex.is_valid()


def test_gases():
    c = ball(0.25)
    fluid = dsc.Fluid(c, {0: dsc.Liquid(1.0, 0.1)}, gases={1: dsc.Gas(1.0)})
    fluid.step(0.02)
    assert fluid.balance.gas_energy != 0
