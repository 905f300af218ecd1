"""Growth of grains, and energies of interfaces that depend on labels."""

import dsc
import numpy as np
import pytest

needs_tori = pytest.mark.skipif(dsc.Torus3._class is None, reason="tori are not in this build")


def box_of_grains(number=12, edges=6, scale=1.0):
    labels = dsc.Voronoi(number, (1, 1), periodic=False)
    c = dsc.Complex2.from_function(
        lambda p: labels(p / scale), [(0, 0), (scale, scale)], scale / edges / np.sqrt(number)
    )
    c.keep_largest_components()
    return c


def slope(c, growth, steps):
    """Measured rates of growth over those of the law."""
    xx = xy = 0
    for k in range(steps):
        before = c.grains()
        dt = growth.advance().dt
        after = {grain.label: grain for grain in c.grains()}
        for grain in before:
            now = after.get(grain.label)
            if k > 5 and now and (now.corners, now.right_angles) == (grain.corners, grain.right_angles):
                xx += grain.growth**2
                xy += grain.growth * (now.measure - grain.measure) / dt
    return xy / xx


def test_grains_grow_by_the_law_in_a_box():
    c = box_of_grains()
    assert len(c.labels) == 12
    assert slope(c, dsc.GrainGrowth(c, edges=6, step=0.3), 30) == pytest.approx(1, abs=0.06)
    assert c.is_valid()


@needs_tori
@pytest.mark.parametrize("cls, number", [(dsc.Torus2, 12), (dsc.Torus3, 6)])
def test_grains_grow_on_tori(cls, number):
    d = cls.dimension
    c = cls.from_function(dsc.Voronoi(number, (1,) * d), (1,) * d, number ** (-1 / d) / 5)
    c.keep_largest_components()
    grains = c.grains()
    assert len(grains) == number
    assert sum(grain.measure for grain in grains) == pytest.approx(1)
    growth = dsc.GrainGrowth(c, edges=5, step=0.3)
    step = growth.advance()
    assert step.report.complete
    assert step.removed == []
    assert growth.time == step.time == step.dt > 0
    copy, other = c.copy(), dsc.GrainGrowth(c.copy(), edges=5, step=0.3, time=growth.time)
    del copy
    growth.advance()
    other.advance()
    assert other.complex == c
    assert other.time == growth.time


def test_units_do_not_matter():
    small, large = box_of_grains(), box_of_grains(scale=1000.0)
    a, b = (dsc.GrainGrowth(c, edges=6, density={1: 3.0 / s}) for c, s in ((small, 1.0), (large, 1000.0)))
    for _ in range(3):
        a.advance()
        b.advance()
    assert b.time == pytest.approx(a.time * 1e6)
    for x, y in zip(small.grains(), large.grains()):
        assert y.measure == pytest.approx(x.measure * 1e6)
        assert y.boundary == pytest.approx(x.boundary * 1e3)
        assert y.growth == pytest.approx(x.growth)


def test_energies_depend_on_labels():
    # A disk of radius r with the tension s and the mobility m: r' = m (g - s / r)
    r, s, m, g, dt = 0.3, 0.5, 2.0, 3.0, 0.002
    c = dsc.Complex2.from_function(lambda p: np.linalg.norm(p, axis=1) < r, [(-1, -1), (1, 1)], 0.03)
    c.mean_curvature(0.001)  # rounds the steps of the grid
    area = c.volumes[1]
    asked = []

    def tension(a, b):
        asked.append((a, b))
        return s

    c.mean_curvature(dt, tension=tension, mobility=m, density={1: -g})
    assert asked == [(0, 1)]  # once
    r = np.sqrt(area / np.pi)
    exact = r + dt * m * (g - s / r)
    assert np.sqrt(c.volumes[1] / np.pi) == pytest.approx(exact, abs=2e-4)
    before = c.interface().points
    c.mean_curvature(dt, mobility=lambda a, b: 0)
    assert np.array_equal(c.interface().points, before)


def test_values_follow_grains():
    c = box_of_grains()
    c.vertex_values["x"] = c.cells().points[:, 0]
    growth = dsc.GrainGrowth(c, edges=6, step=0.2)
    for _ in range(5):
        growth.advance()
    assert c.vertex_values["x"] == pytest.approx(c.cells().points[:, 0], abs=0.05)


def test_particles_keep_their_place():
    center, radius = (0.5, 0.5), 0.2
    labels = dsc.Voronoi(8, (1, 1), periodic=False)
    c = dsc.Complex2.from_function(
        lambda p: np.where(np.linalg.norm(p - center, axis=1) < radius, 0, labels(p)),
        [(0, 0), (1, 1)],
        0.05,
    )
    area = c.volumes[0]
    growth = dsc.GrainGrowth(c, mobility=lambda a, b: float(a > 0), longest_edge=0.06, step=0.3)
    for _ in range(60):
        growth.advance()
    assert c.volumes[0] == pytest.approx(area, rel=0.02)
    facets = c.interface()
    on_particle = np.unique(facets.facets[(facets.labels == 0).any(axis=1)])
    distances = np.linalg.norm(facets.points[on_particle] - center, axis=1)
    assert distances == pytest.approx(radius, abs=0.01)


def test_misorientations():
    orientations = dsc.Orientations(20, 2)
    angles = [orientations.misorientation(1, k) for k in range(1, 21)]
    assert angles[0] == pytest.approx(0, abs=1e-5)
    assert 40 < max(angles) <= 45 + 1e-9
    tension = orientations.read_shockley(30)
    assert tension(1, 1) == 0.05
    assert all(tension(1, k + 1) == pytest.approx(1) for k in range(20) if angles[k] > 30)
    assert max(dsc.Orientations(50, 3).misorientation(1, k) for k in range(1, 51)) > 50


def test_wrong_arguments():
    c = box_of_grains()
    with pytest.raises(TypeError):
        dsc.GrainGrowth(3)
    with pytest.raises(TypeError):
        dsc.GrainGrowth(c, tension="high")
    with pytest.raises(dsc.Error):
        dsc.GrainGrowth(c, edges=-1)
    with pytest.raises(dsc.Error):
        dsc.GrainGrowth(c, tension=lambda a, b: -1).advance()
    with pytest.raises(TypeError):
        dsc.GrainGrowth(c, tension=lambda a, b: "high").advance()
    with pytest.raises(ZeroDivisionError):
        c.mean_curvature(1e-4, density=lambda label: 1 / 0)
    with pytest.raises(ValueError):
        dsc.Voronoi(5, (1,))
    with pytest.raises(dsc.Error):
        dsc.Voronoi(0, (1, 1))
    with pytest.raises(ValueError):
        dsc.Voronoi(5, (1, 1))([(0.5, np.nan)])
    with pytest.raises(ValueError):
        dsc.Orientations(5, 4)
    assert c.is_valid()
