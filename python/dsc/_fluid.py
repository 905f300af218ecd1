"""Incompressible liquids with free surfaces."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Union

import numpy as np
import numpy.typing as npt

from . import _dsc
from ._complex import (
    Complex2,
    Complex3,
    Progress,
    Topology,
    _callable,
    _given,
    _number,
    _report,
)
from ._labels import ByLabel, Label, _by_label, _integer, _label, _pairs
from ._report import Points, Report
from ._solids import Solids

Side = Literal["x-", "x+", "y-", "y+", "z-", "z+"]
"""A side of the domain: the axis perpendicular to it, - for the smaller coordinate, + for the larger."""

Region = Callable[[Points], Any]
"""Whether points are in a region: booleans of shape (n,) for points of shape (n, d)."""

Field = Callable[[Points], Any]
"""Values of a field: numbers of shape (n,) for points of shape (n, d)."""

Tension = Union[float, Callable[[float], float]]
"""A surface tension: a number, or a function of a value of the field."""

Tensions = Union[
    Mapping[tuple[int, int], Tension], Mapping[tuple[str, str], Tension], Mapping[tuple[Label, Label], Tension]
]
"""Surface tensions by two labels."""

_SIDES = ("x-", "x+", "y-", "y+", "z-", "z+")


@dataclass(frozen=True)
class Liquid:
    """A liquid."""

    density: float
    """Mass of a unit of volume (in the plane, of area), greater than 0."""
    viscosity: float = 0
    """Dynamic viscosity, 0 or more."""
    diffusivity: float = 0
    """Diffusivity of the field, 0 or more."""


@dataclass(frozen=True)
class Gas:
    """A gas."""

    pressure: float
    """Initial pressure, relative to void, 0 or more."""
    exponent: float = 1.4
    """1.4 for air without heat exchange, 1 for a constant temperature, 0 for a constant pressure."""


@dataclass(frozen=True)
class Source:
    """A ball (in the plane, a disk) in which liquid appears, or vanishes."""

    center: Sequence[float]
    radius: float
    rate: float
    """Volume (in the plane, area) in a unit of time, if the ball is full of liquid; negative for a drain."""


@dataclass(frozen=True)
class Balance:
    """Sums over all liquids. In the plane, they are those of a layer of thickness 1."""

    volume: float
    mass: float
    kinetic_energy: float
    potential_energy: float
    surface_energy: float
    gas_energy: float
    energy: float
    field_integral: float
    """Integral of the field that liquids carry."""
    least_field: float
    greatest_field: float
    momentum: Points
    """Momentum, shape (d,)."""
    angular_momentum: Points | float
    """Angular momentum about the origin: shape (3,) in space, a number in the plane."""


@dataclass(frozen=True)
class FluidReport:
    """Report of a time step."""

    dt: float
    """Length of the step."""
    substeps: int
    """Number of parts of the step."""
    balance: Balance
    """Balance after the step."""
    greatest_velocity: float
    greatest_correction: float
    """Greatest change of a velocity that restores momentum."""
    volume_error: float
    """Greatest error of the volume of a component, relative to the volume."""
    gained_volume: float
    """Volume that sources and sides added, less the volume that they removed."""
    volume_through_sides: npt.NDArray[np.float64]
    """Volume that entered through each side of the domain, less the volume that left, shape (2 d,)."""
    work_of_tensions: float
    """Surface energy that the diffusion of the field added, because surface tensions changed."""
    residual: float
    """Relative residual of the linear equations."""
    contacts: int
    """Number of vertices in contact with solids."""
    depth_in_solids: float
    """Depth of the deepest vertex in a solid."""
    forces_on_solids: Points
    """Mean force of liquids on each solid in the step, shape (k, d), in the order of their addition."""
    torques_on_solids: Points
    """Mean torque about the origin on each solid: shape (k, 3) in space, (k,) in the plane."""
    repetitions: int
    """Number of attempts that failed before the step succeeded."""
    deformation: Report
    """Report of the motion of the interface."""


def _constant(value: Any) -> Callable[[Points, float], Any]:
    """Returns a function of a point and a time that always returns the value."""

    def value_at(_point: Points, _time: float) -> Any:
        return value

    return value_at


class Fluid(Solids):
    """Liquids, gases and void: the labels of a complex in space or in the plane.

    complex: the initial state; the fluid works on a copy
    liquids, gases: media by label, or by its name in the complex; all other labels are void
    tensions: surface tension between two labels or names: a number, or a function of a value of the field
    gravity: acceleration, by default 0
    field: the field that liquids carry, see `set_field()`, by default 0

    Points and vectors have d coordinates: 3 in space, 2 in the plane. Two liquids slip along their
    interface. If both are viscous, friction resists the slip.

    The functions that add solids have options for the wall of the solid, and for its motion:

    contact_angle: in the liquid between solid and surface, degrees in [0, 180], by default 90
    no_slip: whether liquid in contact moves with the solid, by default False
    separates: whether liquid may leave the solid, by default True
    velocity: constant velocity of the center, by default 0
    angular_velocity: constant angular velocity about the center, in radians in a unit of time: a vector
        in space, a number in the plane; by default 0
    motion: instead of both, a function of the time that returns the displacement and the rotation, see
        `Motion`. It is called during steps, with times that are not negative, and must always return the
        same values.
    motion_step: time step of the differences of `motion`, which are the velocities of the solid;
        by default 1e-5. Choose it small in comparison with the time in which the velocity changes.

    The shape of a moving solid is given at the time 0. The center of a tank or a box is its middle.

    A box, a ball or a mesh with a density is a body, which gravity and liquids move. In the plane, it has
    the thickness 1. Its velocities are initial velocities, and its center is the center of mass. The cells
    inside a body have the label of the void or of a gas. Bodies and other solids pass through each other.

    density: mass of a unit of volume
    fixed: some of 'x', 'y', 'z' and 'rotation': the body does not move along these axes, or does not
        rotate; by default ()
    """

    label_names: Mapping[int, str]
    """Names of the labels of the initial complex."""

    def __init__(
        self,
        complex: Complex2 | Complex3,
        liquids: ByLabel[Liquid],
        *,
        gases: ByLabel[Gas] = {},  # type: ignore[assignment]
        tensions: Tensions = {},  # type: ignore[assignment]
        gravity: Sequence[float] | None = None,
        field: Field | None = None,
    ) -> None:
        if not isinstance(complex, (Complex2, Complex3)):
            raise TypeError(f"complex must be a Complex2 or a Complex3, not {complex!r}")
        if not all(isinstance(liquid, Liquid) for liquid in liquids.values()):
            raise TypeError("liquids must be values of dsc.Liquid")
        if not all(isinstance(gas, Gas) for gas in gases.values()):
            raise TypeError("gases must be values of dsc.Gas")
        self._dimension = complex.dimension
        self.label_names = names = complex.label_names
        compiled = _dsc.Fluid2 if self._dimension == 2 else _dsc.Fluid3
        self._compiled: Any = compiled(
            complex._compiled,
            {
                label: (liquid.density, liquid.viscosity, liquid.diffusivity)
                for label, liquid in _by_label(liquids, names).items()
            },
            {label: (gas.pressure, gas.exponent) for label, gas in _by_label(gases, names).items()},
            {
                _pairs([labels], names)[0]: tension if callable(tension) else _number(tension, "a surface tension")
                for labels, tension in tensions.items()
            },
            self._coordinates([0] * self._dimension if gravity is None else gravity, "gravity"),
        )
        if field is not None:
            self.set_field(field)

    # Set-up

    def set_side(
        self,
        side: Side,
        *,
        slip: bool | None = None,
        velocity: Sequence[float] | None = None,
        inflow: Sequence[float] | Callable[[Points, float], Any] | None = None,
        pressure: float | Callable[[Points, float], float | None] | None = None,
    ) -> None:
        """Sets the boundary condition at a side of the domain: no-slip, or slip as initially.

        Liquid can pass through the side, with a given velocity or against a given pressure.

        side: 'x-' for the side with the smallest x, 'x+' for the largest x, and so on
        slip: whether liquid slips along the side; by default, only if there is an `inflow` or a `pressure`
            but no `velocity`
        velocity: velocity of a no-slip side, by default 0; the component perpendicular to the side has
            no effect
        inflow: velocity with which liquid enters, or leaves; or a function of a point and the time that
            returns it, or None where the side is a wall
        pressure: pressure outside, relative to void; or a function of a point and the time that returns
            it, or None where the side is a wall. Liquid passes in both directions with a velocity that
            the equations determine. With slip, no force acts along the opening; with no-slip, the
            component along the side is that of `velocity`.

        The condition applies to liquids that are on the side at the beginning. It has no effect if the
        domain is not a box. Then `inflow` and `pressure` raise `Error`.
        """
        sides = _SIDES[: 2 * self._dimension]
        if side not in sides:
            raise ValueError(f"side must be one of {', '.join(sides)}, not {side!r}")
        if slip and velocity is not None:
            raise ValueError("a slip side has no velocity")
        if slip is None:
            slip = velocity is None and not (inflow is None and pressure is None)
        given = [0] * self._dimension if velocity is None else velocity
        axis, is_upper = divmod(sides.index(side), 2)
        if inflow is not None and pressure is not None:
            raise ValueError("a side has an inflow or a pressure, not both")
        if inflow is not None and not callable(inflow):
            inflow = _constant(self._coordinates(inflow, "inflow"))
        if pressure is not None and not callable(pressure):
            pressure = _constant(_number(pressure, "pressure"))
        self._compiled.set_side(
            axis,
            bool(is_upper),
            None if slip else self._coordinates(given, "velocity"),
            inflow,
            pressure,
        )

    def set_gravity(self, gravity: Sequence[float]) -> None:
        """Sets the acceleration of gravity for the next steps."""
        self._compiled.set_gravity(self._coordinates(gravity, "gravity"))

    def add_source(self, is_in: Region, flux: float | Callable[[float], float]) -> None:
        """Adds a source that adds a given volume to the liquids in a region.

        is_in: a function of points that returns whether they are in the region; it is called with the
            barycenters of cells of liquids
        flux: volume (in the plane, area) in a unit of time, negative for a drain: a number, or a function
            of the time, which is called with the middle of each step

        The flux is exact, up to rounding. If no cell is in the region, the source has no effect. A step
        raises `Error` if it is too long for the flux. `set_sources()` does not remove these sources.
        """
        self._compiled.add_source(
            _callable(is_in, "is_in"), flux if callable(flux) else _number(flux, "flux")
        )

    def set_sources(self, sources: Iterable[Source]) -> None:
        """Replaces the sources that are balls."""
        self._compiled.set_sources(
            [(self._coordinates(s.center, "a center"), s.radius, s.rate) for s in sources]
        )

    def set_field(self, field: Field) -> None:
        """Sets the field that liquids carry, such as a temperature or a concentration.

        field: a function that returns the values at points

        A fluid has one field, with one value at each vertex. Vertices carry their values. At the end of each
        step, the field diffuses with the diffusivity of each liquid. Boundaries are insulated where
        `fix_field()` gives no value. `relax()` moves the field, but the field does not diffuse.
        """
        self._compiled.set_field(_callable(field, "field"))

    def fix_field(self, field: Callable[[Points, float], Any]) -> None:
        """Gives values of the field on the boundary.

        field: a function of points and the time that returns the values, and NaN where the boundary is
            insulated. Each step calls it at its end, with vertices of liquids on the sides of the domain and
            on free surfaces, which include facets on solids.
        """
        self._compiled.fix_field(_callable(field, "field"))

    def set_velocities(
        self, velocities: npt.ArrayLike | Callable[[Points], Any], *, label: Label | None = None
    ) -> None:
        """Sets the velocities of all vertices, or of one liquid.

        velocities: shape (n, d), in the order of `complex.cells().points`; or a function that returns
            such an array for these points
        label: a liquid, whose velocities are set; other liquids keep theirs, and slip along it

        The next step begins with the nearest velocities that preserve volumes and enter no wall.
        """
        given = velocities(self.complex.cells().points) if callable(velocities) else velocities
        self._compiled.set_velocities(
            np.asarray(given, dtype=float), None if label is None else _label(label, self.label_names)
        )

    # Access

    @property
    def complex(self) -> Complex2 | Complex3:
        """A copy of the present state of the complex."""
        copy = self._compiled.complex()
        result: Complex2 | Complex3 = Complex2(copy) if self._dimension == 2 else Complex3(copy)
        result.label_names = self.label_names
        return result

    @property
    def time(self) -> float:
        """The time, initially 0."""
        return float(self._compiled.time())

    @property
    def velocities(self) -> Points:
        """Velocities of the vertices, shape (n, d), in the order of `complex.cells().points`.

        Vertices off liquids have the velocity 0.
        """
        velocities: Points = self._compiled.velocities(None)
        return velocities

    @property
    def pressures(self) -> npt.NDArray[np.float64]:
        """Pressures at the vertices in the last step, shape (n,).

        At the interface of two liquids, they are the means of the pressures of both liquids.
        """
        pressures: npt.NDArray[np.float64] = self._compiled.pressures(None)
        return pressures

    def velocities_of(self, label: Label) -> Points:
        """Returns the velocities of a liquid, shape (n, d). Vertices off the liquid have the velocity 0.

        Two liquids with a common vertex may have different velocities there, because they slip.
        """
        velocities: Points = self._compiled.velocities(_label(label, self.label_names))
        return velocities

    def pressures_of(self, label: Label) -> npt.NDArray[np.float64]:
        """Returns the pressures of a liquid in the last step, shape (n,).

        Vertices off the liquid have the pressure 0.
        """
        pressures: npt.NDArray[np.float64] = self._compiled.pressures(_label(label, self.label_names))
        return pressures

    @property
    def field(self) -> npt.NDArray[np.float64]:
        """Field at the vertices, shape (n,). Vertices off liquids have the value 0."""
        field: npt.NDArray[np.float64] = self._compiled.field()
        return field

    @property
    def vorticity(self) -> npt.NDArray[np.float64]:
        """Curl of the velocity in each cell, in the order of `complex.cells().cells`.

        The shape is (m, 3) in space and (m,) in the plane. Cells off liquids have the vorticity 0.
        """
        vorticity: npt.NDArray[np.float64] = self._compiled.vorticity()
        return vorticity

    @property
    def balance(self) -> Balance:
        """Present sums over all liquids."""
        return Balance(**self._compiled.balance())

    def largest_step(self, fraction: float = 0.25) -> float:
        """Returns the longest step in which no vertex moves by more than a fraction of an edge."""
        return float(self._compiled.largest_step(fraction))

    # Motion

    def step(
        self,
        dt: float,
        *,
        implicitness: float | None = None,
        interface_tolerance: float | None = None,
        adaptation_interval: int | None = None,
        topology: Topology | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
        **deformation: Any,
    ) -> FluidReport:
        """Performs a time step, completely or not at all.

        implicitness: .5 preserves energy, 1 damps fast oscillations
        interface_tolerance: largest distance of edges from a smooth surface, in mean edges
        adaptation_interval: number of steps between adaptations of the mesh
        topology, threads, deformation: as for `Complex.deform()`

        Raises `FluidStepError` if no attempt succeeds. The fluid is then as before.
        """
        options = _given(locals(), "dt")
        result = self._compiled.step(_number(dt, "dt"), options, progress)
        result["balance"] = Balance(**result["balance"])
        result["deformation"] = _report(result["deformation"])
        return FluidReport(**result)

    def relax(
        self, dt: float, steps: int, *, progress: Progress | None = None, **options: Any
    ) -> float:
        """Moves the liquids to an equilibrium of forces. Returns the greatest velocity of the last step.

        dt: about the time that a wave takes to cross the liquid
        steps: largest number of steps
        options: those of `step()`
        """
        if _integer(steps, "steps") < 1:
            raise ValueError("steps must be at least 1")
        return float(self._compiled.relax(_number(dt, "dt"), steps, _given({"self": self}, **options), progress))
