"""Deformable simplicial complexes: space or the plane, divided into labeled cells."""

from __future__ import annotations

import importlib
import json
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, Literal, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _dsc
from ._errors import VolumeWarning
from ._files import _replace_file
from ._film import Film
from ._images import PlacedImage
from ._labels import ByLabel, Label, _by_label, _integer, _label, _names_of, _pairs
from ._report import Cells, Changes, Grain, Interface, LabelChange, Points, Report, TopologyEvent
from ._values import Values

Progress = Union[Callable[[str], Union[bool, None]], bool]
"""Called about twenty times a second with the name of the current phase. If it returns False, the
function stops. True shows a line on the terminal."""

Velocity = Callable[[Points, float], Any]
"""Velocities at points at a time: array of shape (n, d) for points of shape (n, d)."""

LabelFunction = Callable[[Points], Any]
"""Labels at points: array of integers of shape (n,) for points of shape (n, d)."""

Topology = Union[
    Literal["allow", "forbid"], Sequence[tuple[Label, Label]], Callable[[int, int, Points], bool]
]
"""Changes of topology: all, none, those between pairs of labels, or those that a function of the label,
the new label and the place permits."""

PairFunction = Callable[[int, int], float]
"""Number for each pair of labels, the smaller one first; it depends on the labels only."""

Density = Union[Callable[[int], float], ByLabel[float]]
"""Number for each label; 0 for labels that a dictionary lacks."""

Scheme = Literal["euler", "rk2", "rk4", "adaptive"]
Corners = Literal["miter", "round"]

Self = TypeVar("Self", bound="Complex")


def _given(arguments: dict[str, Any], /, *others: str, **more: Any) -> dict[str, Any]:
    """Returns the options of a function that are not None.

    arguments: its `locals()` at the beginning: options, and `deformation`, which contains further ones
    others: the arguments that are no options, in addition to `self`, `cls` and `progress`
    more: further options, or values that replace those of arguments
    """
    skipped = {"self", "cls", "progress", "deformation", *others}
    options = {name: value for name, value in arguments.items() if name not in skipped}
    options.update(arguments.get("deformation", {}), **more)
    if isinstance(options.get("topology"), (list, tuple)):
        options["topology"] = _pairs(options["topology"], arguments["self"].label_names)
    return {name: value for name, value in options.items() if value is not None}


def _callable(function: Any, name: str) -> Any:
    if not callable(function):
        raise TypeError(f"{name} must be a function, not {function!r}")
    return function


def _number(value: Any, name: str) -> float:
    try:
        if not isinstance(value, str):
            return float(value)
    except (TypeError, ValueError):
        pass
    raise TypeError(f"{name} must be a number, not {value!r}")


def _not_masked(array: Any, name: str) -> None:
    if isinstance(array, np.ma.MaskedArray):
        raise TypeError(f"{name} must not be masked; fill the array or leave out masked rows")


def _numbers(values: Any, number: int, name: str) -> list[float]:
    array = np.asarray(values, dtype=float)
    if array.shape != (number,):
        raise ValueError(f"{name} must be {number} numbers")
    return [float(x) for x in array]


def _report(result: dict[str, Any]) -> Report:
    result["labels"] = [LabelChange(**change) for change in result["labels"]]
    result["events"] = [TopologyEvent(**event) for event in result["events"]]
    return Report(**result)


def _report_with_warnings(result: dict[str, Any], names: Mapping[int, str]) -> Report:
    """Warns if a label vanished, or if its volume changed in an unexplained way."""
    report = _report(result)
    for change in report.labels:
        label = f"label {change.label}" + (f" {names[change.label]!r}" if change.label in names else "")
        if change.components_before > 0 and change.components_after == 0:
            warnings.warn(f"{label} vanished", VolumeWarning, stacklevel=3)
        elif abs(change.volume_unexplained) > 1e-3 * max(change.volume_before, change.volume_after):
            warnings.warn(
                f"the volume of {label} changed by {change.volume_unexplained:.3g} more than the "
                "motion and changes of topology explain: use smaller steps, or a finer interface",
                VolumeWarning,
                stacklevel=3,
            )
    return report


def _warn_of_thin_parts(complex_: Any, edge_per_thickness: float | None) -> Any:
    missing = complex_.missing_facets(3.0 if edge_per_thickness is None else edge_per_thickness)
    if missing > 0:
        warnings.warn(
            f"thin parts of the interface are coarse: about {missing:.2g} more facets would resolve them; "
            "use a larger most_new_facets",
            VolumeWarning,
            stacklevel=3,
        )
    return complex_


def _energy(
    tension: float | PairFunction | None,
    mobility: float | PairFunction | None,
    density: Density | None,
    names: Mapping[int, str],
) -> dict[str, Any]:
    for name, value in (("tension", tension), ("mobility", mobility)):
        if value is not None and not callable(value):
            _number(value, name)
    if isinstance(density, Mapping):
        values = {label: _number(x, "a density") for label, x in _by_label(density, names).items()}
        return {"tension": tension, "mobility": mobility, "density": lambda label: values.get(label, 0.0)}
    return {
        "tension": tension,
        "mobility": mobility,
        "density": None if density is None else _callable(density, "density"),
    }


def _labels(labels: Iterable[int] | None, number: int) -> list[int]:
    given = range(1, number + 1) if labels is None else labels
    result = [_integer(label, "a label") for label in given]
    if len(result) != number:
        raise ValueError(f"there are {len(result)} labels for {number} regions")
    return result


def _parts(parts: Any) -> tuple[list[str], list[Any]]:
    """Returns the names and the values of a dictionary, or the values of a list."""
    return (list(parts), list(parts.values())) if isinstance(parts, Mapping) else ([], list(parts))


def _box(box: npt.ArrayLike, dimension: int) -> tuple[list[float], list[float]]:
    corners = np.asarray(box, dtype=float)
    if corners.shape != (2, dimension):
        raise ValueError(f"box must be two corners, of shape (2, {dimension})")
    return _numbers(corners[0], dimension, "box"), _numbers(corners[1], dimension, "box")


class Complex:
    """Common part of `Complex2` and `Complex3`. Use one of these classes.

    All lengths are in the unit of the input. Functions that change a complex release the lock of the
    interpreter, and stop within a fraction of a second after Ctrl-C. The complex is then valid. While
    a thread changes a complex, other threads get a `BusyError`.
    """

    dimension: int
    """2 or 3."""
    _class: Any

    def __init__(self, compiled: Any) -> None:
        """Not for users. Make a complex by one of the class methods."""
        if not isinstance(compiled, self._class):
            raise TypeError(f"make a {type(self).__name__} by one of its class methods, from_...")
        self._compiled = compiled
        self._label_names: dict[int, str] = {}

    # Creation

    @classmethod
    def from_function(
        cls: type[Self],
        labels: LabelFunction,
        box: npt.ArrayLike,
        edge: float,
        *,
        progress: Progress | None = None,
    ) -> Self:
        """Fills a box with cells whose labels are given by a function, and fits the interface to it.

        labels: the function, called with many points at once
        box: two opposite corners, shape (2, d)
        edge: approximate length of edges

        Warns if a label of the function is in no cell, because its regions are smaller than the edges.
        """
        _callable(labels, "labels")
        seen: set[int] = set()

        def recorded(points: Points) -> Any:
            result = np.asarray(labels(points))
            seen.update(np.unique(result).tolist())
            return result

        corners = _box(box, cls.dimension)
        result = cls(cls._class.from_function(recorded, corners, _number(edge, "edge"), progress))
        lost = sorted(seen.difference(result.labels))
        if lost:
            warnings.warn(f"labels {lost} occur only in regions that are smaller than the edges; they are "
                          "not in the complex", stacklevel=2)  # fmt: skip
        return result

    @classmethod
    def from_bytes(cls: type[Self], data: bytes, *, progress: Progress | None = None) -> Self:
        """Returns the complex of a result of `to_bytes()`, or of the bytes of a checkpoint file.

        Raises `FileError` if the bytes are of another version or dimension, or damaged.
        """
        compiled, metadata = cls._class.from_bytes(data, progress)
        return cls(compiled)._named(_names_of(metadata))

    @classmethod
    def read(cls: type[Self], path: str | os.PathLike[str]) -> Self:
        """Reads a checkpoint (.dsc), as `save()` or the program dsc writes it."""
        with open(path, "rb") as file:
            return cls.from_bytes(file.read())

    # Access

    @property
    def number_of_vertices(self) -> int:
        """Number of vertices."""
        return int(self._compiled.number_of_vertices())

    @property
    def number_of_cells(self) -> int:
        """Number of cells: tetrahedra in space, triangles in the plane."""
        return int(self._compiled.number_of_cells())

    @property
    def labels(self) -> list[int]:
        """Labels that occur, increasing."""
        return list(self._compiled.labels())

    @property
    def label_names(self) -> Mapping[int, str]:
        """Names of labels, by their numbers. Assign a dictionary to change them.

        Functions take names instead of numbers of labels. Checkpoint files, films, and grids of VTK and meshio
        contain the names. Names are not empty, and differ.
        """
        return MappingProxyType(self._label_names)

    @label_names.setter
    def label_names(self, names: Mapping[int, str]) -> None:
        checked = {_integer(label, "a label"): name for label, name in names.items()}
        if not all(isinstance(name, str) and name.strip() and not {"\n", "\r"} & set(name) for name in checked.values()):
            raise ValueError("names of labels must be texts of one line that are not empty")
        if len(set(checked.values())) < len(checked):
            raise ValueError("two labels have the same name")
        self._label_names = checked

    def _named(self: Self, names: Mapping[int, str]) -> Self:
        self._label_names = dict(names)
        return self

    @property
    def volumes(self) -> dict[int, float]:
        """Volume of each label; in the plane, the area."""
        return dict(self._compiled.volumes())

    @property
    def components(self) -> dict[int, int]:
        """Number of connected components of each label."""
        return dict(self._compiled.components())

    @property
    def mean_interface_edge(self) -> float:
        """Mean length of the interface edges when the complex was made; 0 without an interface."""
        return float(self._compiled.mean_interface_edge())

    @property
    def qualities(self) -> npt.NDArray[np.float64]:
        """Quality of each cell, in the order of `cells()`: 1 for a regular cell, 0 for a flat one."""
        qualities: npt.NDArray[np.float64] = self._compiled.qualities()
        return qualities

    def interface(self) -> Interface:
        """Returns the facets between cells of different labels."""
        return Interface(*self._compiled.interface())

    def cells(self) -> Cells:
        """Returns all cells."""
        return Cells(*self._compiled.cells())

    @property
    def vertex_values(self) -> Values:
        """Named values on the vertices, which are interpolated when the mesh changes."""
        return Values(self._compiled, False)

    @property
    def cell_values(self) -> Values:
        """Named averages over the cells, whose integrals are conserved when the mesh changes."""
        return Values(self._compiled, True)

    def is_valid(self) -> bool:
        """Returns whether all cells are positively oriented and the complex is consistent. Slow."""
        return bool(self._compiled.is_valid())

    # Other packages

    def to_meshio(self) -> Any:
        """Returns the cells, labels, qualities and values as a `meshio.Mesh`."""
        meshio = importlib.import_module("meshio")
        state = self.copy()  # which no other thread changes
        cells = state.cells()
        data = {"label": cells.labels, "quality": state.qualities, **state.cell_values}
        return meshio.Mesh(
            cells.points,
            [("tetra" if self.dimension == 3 else "triangle", cells.cells)],
            point_data={n: values[cells.vertices] for n, values in state.vertex_values.items()},
            cell_data={name: [values] for name, values in data.items()},
            field_data={
                name: np.array([label, self.dimension]) for label, name in state.label_names.items()
            },
        )

    def to_vtk(self) -> Any:
        """Returns the cells, labels, qualities and values as a `vtkUnstructuredGrid`."""
        vtk = importlib.import_module("vtk")
        support = importlib.import_module("vtk.util.numpy_support")
        state = self.copy()  # which no other thread changes
        cells = state.cells()
        in_space = np.zeros((len(cells.points), 3))
        in_space[:, : self.dimension] = cells.points
        points = vtk.vtkPoints()
        points.SetData(support.numpy_to_vtk(in_space, deep=True))
        connectivity = vtk.vtkCellArray()
        offsets = np.arange(len(cells.cells) + 1) * (self.dimension + 1)
        connectivity.SetData(
            support.numpy_to_vtkIdTypeArray(offsets, deep=True),
            support.numpy_to_vtkIdTypeArray(cells.cells.ravel(), deep=True),
        )
        grid = vtk.vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.SetCells(vtk.VTK_TETRA if self.dimension == 3 else vtk.VTK_TRIANGLE, connectivity)
        data: dict[str, npt.NDArray[Any]] = {"label": cells.labels, "quality": state.qualities}
        data.update(state.cell_values)
        of_points: dict[str, npt.NDArray[Any]] = {
            name: values[cells.vertices] for name, values in state.vertex_values.items()
        }
        for attributes, arrays in (grid.GetCellData(), data), (grid.GetPointData(), of_points):
            for name, values in arrays.items():
                array = support.numpy_to_vtk(values, deep=True)
                array.SetName(name)
                attributes.AddArray(array)
        if state.label_names:
            labels, names = vtk.vtkIntArray(), vtk.vtkStringArray()
            labels.SetName("named_labels")
            names.SetName("label_names")
            for label, name in state.label_names.items():
                labels.InsertNextValue(label)
                names.InsertNextValue(name)
            grid.GetFieldData().AddArray(labels)
            grid.GetFieldData().AddArray(names)
        return grid

    def to_pyvista(self) -> Any:
        """Returns the same as `to_vtk()`, as a `pyvista.UnstructuredGrid`."""
        return importlib.import_module("pyvista").wrap(self.to_vtk())

    def to_image(
        self,
        shape: Sequence[int],
        spacing: float | Sequence[float],
        origin: Sequence[float],
        *,
        outside: int = 0,
        progress: Progress | None = None,
    ) -> npt.NDArray[np.int32]:
        """Returns the labels at the centers of voxels or pixels, as an array of the given shape.

        shape: number of voxels along x, y and z
        spacing: sides of a voxel
        origin: center of the first voxel
        outside: label of voxels outside the domain
        """
        d = self.dimension
        size = [_integer(n, "shape") for n in shape]
        if len(size) != d or min(size) < 1:
            raise ValueError(f"shape must be {d} positive integers")
        sides = np.broadcast_to(np.asarray(spacing, dtype=float), d)
        place = _numbers(origin, d, "origin")
        labels: npt.NDArray[np.int32] = self._compiled.sample(
            size, _numbers(sides, d, "spacing"), place, _integer(outside, "outside"), progress
        )
        return labels.reshape(size, order="F")

    # Storage

    def to_bytes(self) -> bytes:
        """Returns everything needed to continue with bitwise equal results."""
        names = [{"label": label, "name": name} for label, name in sorted(self._label_names.items())]
        return bytes(self._compiled.to_bytes(json.dumps({"labels": names}) if names else ""))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a checkpoint (.dsc). The file is complete or unchanged."""
        _replace_file(path, self.to_bytes())

    def copy(self: Self) -> Self:
        """Returns a copy, also of the values. Both give bitwise equal results."""
        return type(self)(self._compiled.copy())._named(self._label_names)

    def __copy__(self: Self) -> Self:
        return self.copy()

    def __deepcopy__(self: Self, memo: dict[int, Any]) -> Self:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        state = self.copy()  # which no other thread changes
        values = dict(state.vertex_values), dict(state.cell_values)
        return _restored, (type(self), state.to_bytes(), *values)

    def __eq__(self, other: object) -> bool:
        """Returns whether both complexes will give bitwise equal results. Values are not compared."""
        if type(self) is not type(other) or not isinstance(other, Complex):
            return NotImplemented
        return bool(self._compiled.equals(other._compiled))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return (
            f"<{type(self).__name__}: {self.number_of_cells} cells, "
            f"{self.number_of_vertices} vertices, labels {self.labels}>"
        )

    def _repr_html_(self) -> str:
        film = Film(repr(self))
        film.add(self)
        return film._repr_html_()

    # Motion

    def advect(
        self,
        velocity: Velocity,
        t: float,
        dt: float,
        *,
        scheme: Scheme | None = None,
        integration_tolerance: float | None = None,
        largest_displacement: float | None = None,
        adapt: bool = False,
        interface_tolerance: float | None = None,
        adaptation_interval: int | None = None,
        topology: Topology | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
        **deformation: Any,
    ) -> Report:
        """Moves the interface with a velocity field for one time step.

        Vertices near the interface move with the field, too.

        velocity: `velocity(points, t)` returns velocities of shape (n, d) for points of shape (n, d)
        t, dt: time and length of the step
        scheme: integration of paths; default 'rk2', with `adapt` 'rk4'
        integration_tolerance: for 'adaptive', in mean edges of the first interface
        largest_displacement: longest displacement of a vertex relative to its neighbors in one deformation,
            in local edge lengths; longer steps are divided. 0 divides no step. Default 0.5
        adapt: whether the interface gets facets as small as its curvature requires, for long runs of
            flows that stretch it
        interface_tolerance: largest distance from the smooth surface, in mean edges (with `adapt`)
        adaptation_interval: number of steps between adaptations (with `adapt`)
        topology: changes of topology; default 'allow'
        threads: number of threads; the result does not depend on it
        deformation: further options, as for `deform()`

        Raises `InvalidDestinationError` if a velocity is not finite; nothing has moved then.
        """
        options = _given(locals(), "velocity", "t", "dt")
        return _report_with_warnings(
            self._compiled.advect(
                _callable(velocity, "velocity"), _number(t, "t"), _number(dt, "dt"), options, progress
            ),
            self._label_names,
        )

    def offset(
        self,
        distance: float,
        *,
        corners: Corners = "miter",
        adapt: bool = False,
        topology: Topology | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
        **deformation: Any,
    ) -> Report:
        """Moves the boundary of label 0 along its normals, outwards if the distance is positive.

        corners: 'miter' moves faces and keeps corners sharp; 'round' makes arcs of the corners from which
            the boundary moves away, in the plane only

        A distance of several edges is divided into parts. Other parameters are those of `advect()`.
        """
        options = _given(locals(), "distance")
        return _report_with_warnings(
            self._compiled.offset(_number(distance, "distance"), options, progress), self._label_names
        )

    def mean_curvature(
        self,
        dt: float,
        *,
        tension: float | PairFunction | None = None,
        mobility: float | PairFunction | None = None,
        density: Density | None = None,
        keep_volumes: bool = False,
        adapt: bool = False,
        topology: Topology | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
        **deformation: Any,
    ) -> Report:
        """Moves the interface by its mean curvature (in the plane, its curvature) for a time step.

        The interface between the labels a and b moves with the velocity mobility * (tension * curvature
        + difference of the densities). A label with a lower density grows.

        dt: at least 0, about the square of an edge
        tension: energy per area, in the plane per length: a positive number, or a function of two labels;
            default 1
        mobility: at least 0: a number, or a function of two labels; default 1. An interface of mobility 0
            does not move, and the ends of other interfaces slide along it.
        density: energy per volume, in the plane per area: a function of a label, or a dictionary whose keys
            are labels or their names; default 0
        keep_volumes: whether the volume of each label stays the same
        Other parameters are those of `advect()`.
        """
        options = _given(locals(), "dt", "keep_volumes", **_energy(tension, mobility, density, self.label_names))
        return _report_with_warnings(
            self._compiled.mean_curvature(_number(dt, "dt"), bool(keep_volumes), options, progress),
            self._label_names,
        )

    def grains(self) -> list[Grain]:
        """Measures of all labels, by increasing label: sizes, neighbors, mean widths."""
        return [Grain(**grain) for grain in self._compiled.grains()]

    def keep_largest_components(self, *, progress: Progress | None = None) -> list[int]:
        """Gives all components of each label except the largest one to their neighbors.

        Returns the labels of the components that were removed.
        """
        return list(self._compiled.keep_largest_components(progress))

    def deform(
        self,
        destinations: npt.ArrayLike,
        *,
        topology: Topology | None = None,
        threads: int | None = None,
        maximum_passes: int | None = None,
        quality_threshold: float | None = None,
        relabeling_threshold: float | None = None,
        minimum_angle: float | None = None,
        minimum_facet_angle: float | None = None,
        manifold_interface: bool | None = None,
        collision_order: bool | None = None,
        domain: str | None = None,
        progress: Progress | None = None,
    ) -> Report:
        """Moves the vertices of the interface to destinations.

        destinations: shape (n, d), in the order of `interface().points`
        topology, threads: as for `advect()`
        maximum_passes: largest number of executions of the main loop
        quality_threshold: moved cells of lower quality are improved, in [0, 1]
        relabeling_threshold: trapped cells of lower quality may be relabeled, in [0, 1]
        minimum_angle: moved cells with a smaller angle are removed, degrees in [0, 30]
        minimum_facet_angle: facets with a smaller angle are removed, degrees in [0, 30]
        manifold_interface: whether the boundary of each label stays a manifold
        collision_order: whether vertices are moved in the order of their first collision
        domain: 'refuse' raises an error if a destination is outside the box, 'stop' lets vertices stop
            at its sides, which an interface that touches the sides always does; default 'stop'.
            Motions with a velocity also know 'grow', which enlarges the box. It is their default,
            and 'refuse' if the complex has values

        Raises `InvalidDestinationError` if a destination is not finite or not permitted; nothing has
        moved then.
        """
        options = _given(locals(), "destinations")
        points = np.asarray(destinations, dtype=float)
        return _report_with_warnings(self._compiled.deform(points, options, progress), self._label_names)

    def restore_volumes(
        self,
        volumes: ByLabel[float],
        *,
        volume_tolerance: float | None = None,
        number_of_iterations: int | None = None,
        progress: Progress | None = None,
        **deformation: Any,
    ) -> bool:
        """Moves the interface so that labels get given volumes. Returns whether they are reached.

        volume_tolerance: relative
        """
        options = _given(locals(), "volumes")
        targets = {k: _number(v, "a volume") for k, v in _by_label(volumes, self.label_names).items()}
        return bool(self._compiled.restore_volumes(targets, options, progress))

    # Remeshing

    def improve(
        self,
        *,
        quality_threshold: float | None = None,
        number_of_iterations: int | None = None,
        aggressive: bool | None = None,
        smooth_interface: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Changes:
        """Optimizes the cells. The interface stays the same.

        quality_threshold: cells of lower quality are improved, in [0, 1]
        number_of_iterations: largest number of rounds
        aggressive: whether the worst cells are improved with much more effort, in space
        smooth_interface: whether vertices may move where the interface is flat, in space
        """
        return Changes(**self._compiled.improve(_given(locals()), progress))

    def improve_interface(
        self,
        *,
        number_of_iterations: int | None = None,
        aggressiveness: float | None = None,
        split_length: float | None = None,
        collapse_length: float | None = None,
        feature_angle: float | None = None,
        flip_angle: float | None = None,
        swept_volume: float | None = None,
        minimum_facet_angle: float | None = None,
        quality_threshold: float | None = None,
        curved_splits: bool | None = None,
        split_junctions: bool | None = None,
        progress: Progress | None = None,
    ) -> Changes:
        """Optimizes the facets of the interface, which changes its shape a little.

        aggressiveness: amount of smoothing, in [0, 1)
        split_length, collapse_length: longer edges are split and shorter ones collapsed, in mean edges
        feature_angle: edges are sharp if normals differ by more, degrees in [0, 180]
        flip_angle: edges can be flipped if normals differ by less, degrees in [0, 90]
        swept_volume: bound on the volume that an operation sweeps, in cubes of the mean edge
        minimum_facet_angle: facets with a smaller angle are removed, degrees in [0, 30]
        curved_splits: whether new vertices are placed on the smooth surface
        split_junctions: whether junctions of more than three labels are split, in the plane
        """
        return Changes(**self._compiled.improve_interface(_given(locals()), progress))

    def control_detail(
        self,
        *,
        split_length: float | None = None,
        collapse_length: float | None = None,
        collapse_quality: float | None = None,
        change_interface: bool | None = None,
        interface_split_length: float | None = None,
        interface_collapse_length: float | None = None,
        number_of_iterations: int | None = None,
        progress: Progress | None = None,
    ) -> Changes:
        """Splits long edges and collapses short ones.

        split_length, collapse_length: of edges off the interface, in mean edges of the interface
        collapse_quality: no collapse makes a cell of lower quality, in [0, 1]
        change_interface: whether edges of the interface are changed, too
        interface_split_length, interface_collapse_length: of edges of the interface
        """
        return Changes(**self._compiled.control_detail(_given(locals()), progress))


def _restored(
    cls: type[Self], data: bytes, vertex_values: dict[str, Any], cell_values: dict[str, Any]
) -> Self:
    result = cls.from_bytes(data)
    result.vertex_values.update(vertex_values)
    result.cell_values.update(cell_values)
    return result


class Complex3(Complex):
    """A complex in space: labeled tetrahedra, and the triangles between different labels."""

    dimension = 3
    _class = _dsc.Complex3

    @classmethod
    def from_surfaces(
        cls,
        surfaces: Iterable[tuple[npt.ArrayLike, npt.ArrayLike]]
        | Mapping[str, tuple[npt.ArrayLike, npt.ArrayLike]],
        labels: Iterable[int] | None = None,
        *,
        box: npt.ArrayLike | None = None,
        box_subdivision: int | None = None,
        improve: bool | None = None,
        edge_per_thickness: float | None = None,
        most_new_facets: int | None = None,
        progress: Progress | None = None,
    ) -> Complex3:
        """Fills a box around closed surfaces with tetrahedra.

        Surfaces may share walls, be nested, touch and overlap; where they overlap, the innermost one
        determines the label and, if neither contains the other, the later one.

        surfaces: points (n, 3) and triangles (m, 3) of each surface; in a dictionary, by the names of labels
        labels: labels of the solids; by default 1, 2, ... Label 0 is the outside.
        box: two opposite corners, shape (2, 3); by default a cube around the surfaces
        box_subdivision: number of pieces of each edge of the box
        improve: whether the tetrahedra are improved at the end
        edge_per_thickness: longest edge of the interface in thicknesses of the part or the gap at it;
            longer ones are split. 0 splits none. Default 3
        most_new_facets: largest number of facets that are added in this way, default 10 000

        Raises `InvalidSurfaceError` if a surface is open or intersects itself, and
        `TetrahedralizationError` if TetGen fails.
        """
        options = _given(locals(), "surfaces", "labels", box=None if box is None else _box(box, 3))
        names, regions = _parts(surfaces)
        soups = [(np.asarray(p, dtype=float), np.asarray(t)) for p, t in regions]
        numbers = _labels(labels, len(soups))
        labeled = [(p, t, label) for (p, t), label in zip(soups, numbers)]
        compiled = _dsc.Complex3.from_surfaces(labeled, options, progress)
        result = cls(_warn_of_thin_parts(compiled, edge_per_thickness))
        result.label_names = dict(zip(numbers, names))
        return result

    @classmethod
    def from_tetrahedra(
        cls,
        points: npt.ArrayLike,
        tetrahedra: npt.ArrayLike,
        labels: npt.ArrayLike,
        *,
        surround: bool = False,
        box: npt.ArrayLike | None = None,
        improve: bool | None = None,
        edge_per_thickness: float | None = None,
        most_new_facets: int | None = None,
        progress: Progress | None = None,
    ) -> Complex3:
        """Makes a complex of labeled tetrahedra, of shapes (n, 3), (m, 4) and (m,).
        Equal points are merged.

        surround: whether the space around the tetrahedra is filled with tetrahedra of label 0, up to a
            box; otherwise, the tetrahedra are the domain
        box: two opposite corners, shape (2, 3) (with `surround`)
        improve: whether the tetrahedra are improved at the end
        edge_per_thickness: longest edge of the interface in thicknesses of the part or the gap at it;
            longer ones are split. 0 splits none. Default 3
        most_new_facets: largest number of facets that are added in this way, default 10 000

        Raises `InvalidCellsError` if the tetrahedra are no valid mesh.
        """
        options = _given(
            locals(), "points", "tetrahedra", "labels", "surround",
            box=None if box is None else _box(box, 3),
        )  # fmt: skip
        compiled = _dsc.Complex3.from_tetrahedra(
            np.asarray(points, dtype=float),
            np.asarray(tetrahedra),
            np.asarray(labels),
            not surround,
            options,
            progress,
        )
        return cls(_warn_of_thin_parts(compiled, edge_per_thickness))


    @classmethod
    def from_image(
        cls,
        labels: Any,
        spacing: float | Sequence[float] | None = None,
        origin: Sequence[float] | None = None,
        *,
        edge: float | None = None,
        box: npt.ArrayLike | None = None,
        improve: bool | None = None,
        progress: Progress | None = None,
    ) -> Complex3:
        """Makes a complex from labeled voxels, which fill the domain. The interface is smooth and keeps
        the volumes of labels.

        labels: integers of shape (nx, ny, nz), with axes x, y, z; or an image of nibabel or SimpleITK,
            whose affine map places the voxels in space. If its axes are rotated, the boundary is fixed
        spacing: sides of a voxel; by default 1
        origin: center of the voxel (0, 0, 0); by default 0
        edge: approximate length of interface edges; by default 2.5 times the longest side of a voxel
        box: two opposite corners, shape (2, 3), of a larger domain; the space around the voxels gets
            label 0
        improve: whether the tetrahedra are improved at the end

        Raises `Error` if voxels with labels other than 0 reach the box.
        """
        _not_masked(labels, "labels")
        placed = PlacedImage.of(labels)
        if placed is not None:
            if spacing is not None or origin is not None:
                raise TypeError("an image has a spacing and an origin; leave them out")
            return cls._from_placed_image(
                placed, edge=edge, box=box, improve=improve, progress=progress
            )
        voxels = np.asarray(labels)
        sides = _numbers(np.broadcast_to(1.0 if spacing is None else spacing, 3), 3, "spacing")
        if voxels.ndim != 3:
            raise ValueError("labels must have three axes")
        if edge is not None and not edge >= min(sides):
            raise ValueError("edge must be at least the shortest side of a voxel")
        return cls(
            _dsc.complex_from_image_3(
                voxels.ravel(order="F"),
                voxels.shape,
                sides,
                _numbers((0, 0, 0) if origin is None else origin, 3, "origin"),
                0.0 if edge is None else _number(edge, "edge"),
                _given({}, improve=improve, box=None if box is None else _box(box, 3)),
                progress,
            )
        )

    @classmethod
    def _from_placed_image(cls, image: PlacedImage, **options: Any) -> Complex3:
        if image.voxels.ndim != 3:
            raise ValueError("the image must have three axes")
        if not image.is_oblique:
            straight = image.along_axes_of_space()
            return cls.from_image(
                straight.voxels,
                _numbers(straight.spacing, 3, "spacing"),
                _numbers(straight.affine[:3, 3], 3, "origin"),
                **options,
            )
        if options["box"] is not None:
            raise ValueError("the axes of the image are rotated, so no box contains it; leave out the box")
        # The complex is made along the axes of the image, and then placed in space.
        spacing = image.spacing
        sides = _numbers(spacing, 3, "spacing")
        cells = cls.from_image(image.voxels, sides, **options).cells()
        points = cells.points / spacing @ image.affine[:3, :3].T + image.affine[:3, 3]
        tetrahedra = cells.cells
        if np.linalg.det(image.affine[:3, :3]) < 0:
            tetrahedra = tetrahedra[:, [1, 0, 2, 3]]
        return cls.from_tetrahedra(points, tetrahedra, cells.labels, improve=False)


class Complex2(Complex):
    """A complex in the plane: labeled triangles, and the segments between different labels."""

    dimension = 2
    _class = _dsc.Complex2

    @classmethod
    def from_polygons(
        cls,
        polygons: Iterable[Sequence[npt.ArrayLike]] | Mapping[str, Sequence[npt.ArrayLike]],
        labels: Iterable[int] | None = None,
        *,
        box: npt.ArrayLike | None = None,
        improve: bool | None = None,
        spacing_per_segment: float | None = None,
        edge_per_thickness: float | None = None,
        most_new_facets: int | None = None,
        progress: Progress | None = None,
    ) -> Complex2:
        """Fills a rectangle around polygons with triangles.

        polygons: for each region a list of closed polylines of shape (n, 2): the outer boundary and
            holes, in any order; in a dictionary, by the names of labels
        labels: labels of the regions; by default 1, 2, ... Label 0 is the outside.
        box: two opposite corners, shape (2, 2); by default a square around the polygons
        improve: whether the triangles are improved at the end
        spacing_per_segment: spacing of additional vertices beside a polygon, in lengths of its nearest
            segment, in [.5, 10], default 3; fluids need about 1.2
        edge_per_thickness: longest edge of the interface in thicknesses of the part or the gap at it;
            longer ones are split. 0 splits none. Default 3
        most_new_facets: largest number of facets that are added in this way, default 10 000

        Raises `InvalidSurfaceError` if polygons intersect themselves or each other.
        """
        options = _given(locals(), "polygons", "labels", box=None if box is None else _box(box, 2))
        names, outlines = _parts(polygons)
        regions = [[np.asarray(ring, dtype=float) for ring in rings] for rings in outlines]
        numbers = _labels(labels, len(regions))
        compiled = _dsc.Complex2.from_polygons(list(zip(regions, numbers)), options, progress)
        result = cls(_warn_of_thin_parts(compiled, edge_per_thickness))
        result.label_names = dict(zip(numbers, names))
        return result

    @classmethod
    def from_triangles(
        cls,
        points: npt.ArrayLike,
        triangles: npt.ArrayLike,
        labels: npt.ArrayLike,
        *,
        improve: bool | None = None,
        edge_per_thickness: float | None = None,
        most_new_facets: int | None = None,
        progress: Progress | None = None,
    ) -> Complex2:
        """Makes a complex of labeled triangles, of shapes (n, 2), (m, 3) and (m,), which are the domain.
        Equal points are merged.

        improve: whether the triangles are improved at the end
        edge_per_thickness: longest edge of the interface in thicknesses of the part or the gap at it;
            longer ones are split. 0 splits none. Default 3
        most_new_facets: largest number of facets that are added in this way, default 10 000

        Raises `InvalidCellsError` if the triangles are no valid mesh.
        """
        options = _given(locals(), "points", "triangles", "labels")
        compiled = _dsc.Complex2.from_triangles(
            np.asarray(points, dtype=float),
            np.asarray(triangles),
            np.asarray(labels),
            options,
            progress,
        )
        return cls(_warn_of_thin_parts(compiled, edge_per_thickness))

    @classmethod
    def from_image(
        cls,
        labels: npt.ArrayLike,
        spacing: float = 1.0,
        origin: Sequence[float] = (0, 0),
        *,
        edge: float | None = None,
        progress: Progress | None = None,
    ) -> Complex2:
        """Makes a complex from labeled pixels, which fill the domain. The labels keep their areas.

        labels: integers of shape (nx, ny), with axes x and y; for a picture of rows from top to bottom,
            use `picture[::-1].T`
        spacing: side of a pixel
        origin: center of the pixel (0, 0)
        edge: approximate length of the segments of the interface; by default 2.5 pixels
        """
        pixels = np.asarray(labels)
        side = _number(spacing, "spacing")
        if pixels.ndim != 2:
            raise ValueError("labels must have two axes")
        return cls(
            _dsc.Complex2.from_image(
                pixels[:, ::-1].T.ravel(),
                *pixels.shape,
                side,
                _numbers(origin, 2, "origin"),
                2.5 * side if edge is None else _number(edge, "edge"),
                progress,
            )
        )
