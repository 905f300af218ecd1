"""Results of the functions that change a complex."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]
Labels = npt.NDArray[np.int32]
Ids = npt.NDArray[np.uint64]


@dataclass(frozen=True)
class Interface:
    """Facets between cells of different labels: triangles in space, segments in the plane."""

    points: Points
    """Positions of the vertices, shape (n, d)."""
    facets: Indices
    """Vertices of the facets, shape (m, d): counterclockwise seen from the side of the smaller label."""
    labels: Labels
    """Larger and smaller label at each facet, shape (m, 2)."""
    ids: Ids
    """Numbers that identify the points while their vertices exist, shape (n,)."""
    vertices: Indices
    """Vertex of each point, shape (n,): the points 0, 1, ..., and on a torus also their images."""


@dataclass(frozen=True)
class Cells:
    """All cells: tetrahedra in space, triangles in the plane."""

    points: Points
    """Positions of the vertices, shape (n, d)."""
    cells: Indices
    """Vertices of the cells, shape (m, d + 1), positively oriented."""
    labels: Labels
    """Labels of the cells, shape (m,)."""
    ids: Ids
    """Numbers that identify the points while their vertices exist, shape (n,)."""
    vertices: Indices
    """Vertex of each point, shape (n,): the points 0, 1, ..., and on a torus also their images."""


@dataclass(frozen=True)
class TopologyEvent:
    """A change of connected components of a label."""

    kind: str
    """'merged', 'split', 'vanished' or 'appeared'."""
    label: int
    """Label of the components."""
    volumes_before: list[float]
    """Volumes of the components before; empty if a component appeared."""
    volumes_after: list[float]
    """Volumes of the components after; empty if a component vanished."""
    where: Points
    """A place of the change, shape (d,)."""
    pass_number: int
    """Pass of the deformation; the first one is 1."""


@dataclass(frozen=True)
class LabelChange:
    """Components and volume of a label before and after a deformation."""

    label: int
    components_before: int
    components_after: int
    merged: int
    split: int
    vanished: int
    appeared: int
    volume_before: float
    volume_after: float
    volume_swept: float
    """Volume that the interface sweeps if all vertices move along straight lines to their destinations."""
    volume_of_overlaps: float
    """Volume that changes of topology explain: the swept volume counts overlaps of the interface twice."""
    volume_unexplained: float
    """Rest of the change of the volume."""


@dataclass(frozen=True)
class Changes:
    """Numbers of changes of the mesh."""

    split_edges: int
    collapsed_edges: int
    flipped: int
    smoothed_vertices: int
    inserted_vertices: int


@dataclass(frozen=True)
class Report(Changes):
    """Report of a deformation. It names everything that was not reached or was lost."""

    complete: bool
    """Whether all vertices have reached their destinations, except where parts of the interface met, and the
    unexplained volume of each label is at most a thousandth of its volume."""
    unfinished_points: Points
    """Positions of the vertices that did not reach their destinations, shape (k, d)."""
    unfinished_distances: npt.NDArray[np.float64]
    """Their remaining distances, shape (k,)."""
    flat_cells: int
    """Number of cells whose quality is below 1e-3."""
    vanished_vertices: int
    """Number of vertices that a collapse removed before they arrived."""
    merged_vertices: int
    """Number of vertices that left the interface before they arrived, because parts of the interface met."""
    estimated_error: float
    """Estimated error of a vertex due to the length of the time step; 0 if the motion has no estimate."""
    stopped_at_boundary: int
    """Number of vertices with destinations outside the domain."""
    steps: int
    """Number of parts into which a long time step was divided; 1 if it was not."""
    passes: int
    """Number of executions of the main loop."""
    relocated_vertices: int
    """Number of vertices that were moved from their destinations to remove small angles."""
    relabeled_cells: int
    """Number of cells that changed their label."""
    labels: list[LabelChange]
    """Changes of each label."""
    events: list[TopologyEvent]
    """Changes of components."""


@dataclass(frozen=True)
class Grain:
    """Measures of a label, such as a grain of a polycrystal."""

    label: int
    """The label."""
    measure: float
    """Volume, in the plane area."""
    boundary: float
    """Area of the interface, in the plane length."""
    neighbors: int
    """Number of labels with a common interface."""
    corners: int
    """Number of vertices where three labels or more meet (plane only)."""
    right_angles: int
    """Number of right angles at the boundary of a box (plane only)."""
    triple_lines: float
    """Length of the lines where three labels or more meet (space only)."""
    mean_width: float
    """Mean width of MacPherson and Srolovitz: 4 r for a ball (space only)."""
    growth: float
    """Rate of growth by the law of von Neumann and Mullins, in space of MacPherson and Srolovitz."""
