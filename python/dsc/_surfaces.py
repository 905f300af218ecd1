"""Reconstruction of solids and sheets from points, and cut loci of surfaces."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _dsc
from ._complex import Complex3, Progress, _callable, _given, _not_masked, _number, _numbers
from ._report import Indices, Points


@dataclass(frozen=True)
class _FromPoints:
    """Properties of a surface that was reconstructed from points, an interface or a sheet."""

    used_points: int
    """Number of points without duplicates and outliers."""
    duplicates: int
    """Number of points that are equal to others."""
    outliers: int
    """Number of points that were not used, since they do not lie on the surface."""
    spacing: float
    """Mean distance of the points from their six nearest neighbors."""
    noise: float
    """Median distance of the points from quadrics through their neighbors."""
    root_mean_square: float
    """Root mean square of the distances of the points from the surface."""
    maximum_distance: float
    """Largest distance of a point from the surface."""
    doubtful_places: Points
    """Places where the surface contradicts the points, shape (k, 3)."""


@dataclass(frozen=True)
class Reconstruction(_FromPoints):
    """Result of `reconstruct()`. Lengths are in the unit of the points."""

    complex: Complex3
    """The solid, with label 1 inside and label 0 in a box around it."""
    complete: bool
    """Whether the interface converged. `doubtful_places` is then empty."""
    steps: int
    """Number of steps of the interface."""
    unfit_points: Indices
    """Points that are farther from the interface than a spacing and four times the noise."""
    facets_without_points: Indices
    """Facets of `complex.interface()` that close holes of the points."""


def reconstruct(
    points: npt.ArrayLike,
    normals: npt.ArrayLike | None = None,
    *,
    tolerance: float | None = None,
    maximum_steps: int | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Reconstruction:
    """Reconstructs a solid from points on its surface.

    points: shape (n, 3)
    normals: of any length and sign, shape (n, 3); normals that are 0 or not finite are estimated. By
        default, all normals are estimated.
    tolerance: of the interface to the points, in spacings; default 0.03
    maximum_steps: largest number of steps
    threads: number of threads; the result does not depend on it

    Raises `InvalidPointsError` if the points are not finite, enclose no solid or sample an open sheet.
    """
    options = _given(locals(), "points", "normals")
    _not_masked(points, "points")
    positions = np.asarray(points, dtype=float)
    directions = None if normals is None else np.asarray(normals, dtype=float)
    compiled, report = _dsc.reconstruct(positions, directions, options, progress)
    return Reconstruction(complex=Complex3(compiled), **report)


@dataclass(frozen=True)
class Sheet(_FromPoints):
    """Result of `reconstruct_sheet()`. Lengths are in the unit of the points."""

    points: Points
    """Vertices of the sheet, shape (n, 3)."""
    triangles: Indices
    """Triangles of the sheet as indices into `points`, shape (m, 3)."""
    complete: bool
    """Whether there are no `unfit_points` and no `doubtful_places`."""
    components: int
    """Number of connected components of the sheet."""
    euler_characteristic: int
    """Euler characteristic of the sheet."""
    boundaries: int
    """Number of connected components of the boundary."""
    boundary_length: float
    """Length of all boundaries."""
    orientable: bool
    """Whether the sheet has two sides."""
    unfit_points: Indices
    """Points that are farther from the sheet than half a spacing and six times the noise."""


def reconstruct_sheet(
    points: npt.ArrayLike,
    *,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Sheet:
    """Reconstructs a surface with boundaries from points on it, such as a terrain.

    points: shape (n, 3)
    threads: number of threads; the result does not depend on it

    Raises `InvalidPointsError` if the points are not finite or sample no surface.
    """
    options = _given(locals(), "points")
    _not_masked(points, "points")
    return Sheet(**_dsc.reconstruct_sheet(np.asarray(points, dtype=float), options, progress))


@dataclass(frozen=True)
class CutLocus:
    """Result of `cut_locus()`."""

    points: Points
    """Vertices of the cut locus in space, shape (n, 3)."""
    parameters: Points
    """The vertices in the chart, shape (n, 2). The chart of the image of a sphere is stereographic."""
    distances: npt.NDArray[np.float64]
    """Lengths of the shortest geodesics to the vertices, shape (n,)."""
    multiplicities: Indices
    """Number of shortest geodesics to each vertex, shape (n,). End vertices have multiplicity 1."""
    arcs: list[Indices]
    """Chains of vertices, from one vertex with a multiplicity other than 2 to the next."""
    complete: bool
    """Whether the cut locus has passed all verifications."""
    doubtful: Indices
    """Vertices that failed the verification by other geodesics."""
    spacing: float
    """Spacing of the computation, in the chart."""
    step: float
    """Step of the computation, on the surface."""


def cut_locus(
    surface: str | Callable[[Points], Any],
    point: Sequence[float],
    *,
    periods: Sequence[float] = (2 * np.pi, 2 * np.pi),
    spacing: float | None = None,
    step: float | None = None,
    progress: Progress | None = None,
) -> CutLocus:
    """Computes the cut locus of a point of a closed surface.

    surface: three expressions like '(2+cos(v))*cos(u), (2+cos(v))*sin(u), sin(v)' in u and v for a
        periodic surface, or like 'x, 0.8*y, 0.6*z' in the coordinates x, y and z of the unit sphere.
        Or a function that returns points in space, shape (n, 3), for u and v, shape (n, 2), or for
        unit vectors, shape (n, 3). It is called millions of times, so expressions are much faster.
    point: the source: u and v; or x, y, z of its direction
    periods: of u and v
    spacing: length of edges in the chart; by default as small as needed
    step: step of the geodesics on the surface; by default half of the spacing

    Raises `Error` if the surface is not regular.
    """
    if not isinstance(surface, str):
        _callable(surface, "surface")
    source = np.asarray(point, dtype=float)
    if source.shape not in ((2,), (3,)):
        raise ValueError("point must be two numbers, u and v, or three numbers, a direction")
    result = _dsc.cut_locus(
        surface,
        source.tolist(),
        _numbers(periods, 2, "periods"),
        0.0 if spacing is None else _positive(spacing, "spacing"),
        0.0 if step is None else _positive(step, "step"),
        progress,
    )
    return CutLocus(**result)


def _positive(value: float, name: str) -> float:
    number = _number(value, name)
    if not number > 0:
        raise ValueError(f"{name} must be positive")
    return number
