"""Exceptions of the package. Their messages state the cause and what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Indices = npt.NDArray[np.int64]


class Error(RuntimeError):
    """Base class of the exceptions for unusable input."""


class InvalidSurfaceError(Error):
    """A surface (in the plane, a curve) does not bound a solid."""

    surface: int
    """Index of the surface."""
    other_surface: int
    """Index of a second surface, if there is one; otherwise `surface`."""
    facets: Indices
    """Offending facets. Facets that intersect come in pairs."""
    vertices: Indices
    """Offending vertices. Ends of edges come in pairs."""


class InvalidCellsError(Error):
    """Cells do not form a valid mesh of the domain."""

    cells: Indices
    """Offending cells."""
    vertices: Indices
    """Offending vertices."""


class InvalidPointsError(Error):
    """Points do not bound a solid."""

    points: Indices
    """Offending points; empty if all points are equally involved."""


class InvalidDestinationError(Error):
    """A velocity or a destination is not finite, or their number is wrong. Nothing has moved."""

    vertices: Indices
    """Offending vertices, in the order of `Complex.interface().points`."""


class InvalidSolidError(Error, ValueError):
    """A value of a solid of a fluid is out of range, or cannot be combined with another value."""


class TetrahedralizationError(Error):
    """The space around surfaces could not be filled with tetrahedra."""

    code: int
    """Code of TetGen; 0 if it crashed or was stopped."""


class FileError(Error):
    """A file cannot be opened, read, written or understood."""

    path: str
    """The file."""


class FluidStepError(Error):
    """A time step of a fluid failed, also in short parts. The fluid is as before the step."""

    step: int
    """Number of the step; the first one is 1."""


class BusyError(RuntimeError):
    """The complex is being changed by another thread, or by the function that calls this one."""


class VolumeWarning(UserWarning):
    """A label vanished, its volume changed in a way that its motion does not explain, or thin parts of the
    interface are coarse, so that volumes may change."""


class Interrupted(Exception):
    """A progress callback returned False. A complex that was being changed is valid."""
