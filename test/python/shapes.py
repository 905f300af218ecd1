"""Small complexes for tests."""

from __future__ import annotations

import functools
from collections.abc import Callable

import dsc
import numpy as np
import numpy.typing as npt


def is_in_balls(points: npt.NDArray[np.float64], *balls: tuple[list[float], float]) -> npt.NDArray[np.int64]:
    """Returns 1 in the balls (centers, radii) and 0 elsewhere."""
    inside = np.zeros(len(points), dtype=bool)
    for center, radius in balls:
        inside |= np.linalg.norm(points - np.array(center), axis=1) < radius
    return inside.astype(np.int64)


def ball(edge: float = 0.2) -> dsc.Complex3:
    """Returns a ball of radius .5 in the cube (-1, 1)³."""
    return _ball(edge).copy()


def disk(edge: float = 0.1) -> dsc.Complex2:
    """Returns a disk of radius .5 in the square (-1, 1)²."""
    return _disk(edge).copy()


# The functions of labels are slow, so each complex is built once.


@functools.cache
def _ball(edge: float) -> dsc.Complex3:
    return dsc.Complex3.from_function(
        lambda points: is_in_balls(points, ([0, 0, 0], 0.5)), box=[(-1, -1, -1), (1, 1, 1)], edge=edge
    )


@functools.cache
def _disk(edge: float) -> dsc.Complex2:
    return dsc.Complex2.from_function(
        lambda points: is_in_balls(points, ([0, 0], 0.5)), box=[(-1, -1), (1, 1)], edge=edge
    )


def polygon(corners: int, box: npt.ArrayLike, radius: Callable[[float], float]) -> dsc.Complex2:
    """Returns a polygon around the origin in a box. The radius is a function of the angle."""
    angles = 2 * np.pi * np.arange(corners) / corners
    radii = np.array([radius(angle) for angle in angles])
    ring = np.c_[radii * np.cos(angles), radii * np.sin(angles)]
    return dsc.Complex2.from_polygons([[ring]], box=box)


def rectangle(
    columns: int,
    rows: int,
    corner: tuple[float, float],
    labels: Callable[[npt.NDArray[np.float64]], npt.NDArray[np.int64]],
) -> dsc.Complex2:
    """Returns the rectangle from (0, 0) to a corner. Labels are those of the barycenters of triangles."""
    x, y = np.meshgrid(
        np.linspace(0, corner[0], columns + 1), np.linspace(0, corner[1], rows + 1), indexing="ij"
    )
    points = np.c_[x.ravel(), y.ravel()]
    first = ((rows + 1) * np.arange(columns)[:, None] + np.arange(rows)).ravel()
    right = first + rows + 1
    triangles = np.r_[np.c_[first, right, right + 1], np.c_[first, right + 1, first + 1]]
    return dsc.Complex2.from_triangles(points, triangles, labels(points[triangles].mean(axis=1)))


def rotation(points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Returns velocities of a rigid rotation of the plane with the angular velocity 1."""
    return np.c_[-points[:, 1], points[:, 0]]


CUBE_POINTS = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
CUBE_TRIANGLES = np.array(
    [
        [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
        [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
    ]
)  # fmt: skip
