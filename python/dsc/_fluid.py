"""Incompressible liquids with free surfaces."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _dsc
from ._complex import Complex3, Progress, Topology, _box, _given, _integer, _number, _report
from ._report import Points, Report


@dataclass(frozen=True)
class Liquid:
    """A liquid."""

    density: float
    """Mass of a unit of volume, greater than 0."""
    viscosity: float = 0
    """Dynamic viscosity, 0 or more."""


@dataclass(frozen=True)
class Gas:
    """A gas."""

    pressure: float
    """Initial pressure, relative to void, 0 or more."""
    exponent: float = 1.4
    """1.4 for air without heat exchange, 1 for a constant temperature, 0 for a constant pressure."""


@dataclass(frozen=True)
class Source:
    """A ball in which liquid appears, or vanishes."""

    center: tuple[float, float, float]
    radius: float
    rate: float
    """Volume in a unit of time, if the ball is full of liquid; negative for a drain."""


@dataclass(frozen=True)
class Balance:
    """Sums over all liquids."""

    volume: float
    mass: float
    kinetic_energy: float
    potential_energy: float
    surface_energy: float
    gas_energy: float
    energy: float
    momentum: Points
    angular_momentum: Points


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
    residual: float
    """Relative residual of the linear equations."""
    contacts: int
    """Number of vertices in contact with solids."""
    depth_in_solids: float
    """Depth of the deepest vertex in a solid."""
    forces_on_solids: Points
    """Force on each solid, shape (k, 3)."""
    repetitions: int
    """Number of attempts that failed before the step succeeded."""
    deformation: Report
    """Report of the motion of the interface."""


class Fluid:
    """Liquids, gases and void: the labels of a complex in space.

    complex: the initial state; the fluid works on a copy
    liquids, gases: media by label; all other labels are void
    tensions: surface tension between two labels
    gravity: acceleration
    """

    def __init__(
        self,
        complex: Complex3,
        liquids: Mapping[int, Liquid],
        *,
        gases: Mapping[int, Gas] = {},
        tensions: Mapping[tuple[int, int], float] = {},
        gravity: tuple[float, float, float] = (0, 0, 0),
    ) -> None:
        if not isinstance(complex, Complex3):
            raise TypeError(f"complex must be a Complex3, not {complex!r}")
        if not all(isinstance(liquid, Liquid) for liquid in liquids.values()):
            raise TypeError("liquids must be values of dsc.Liquid")
        if not all(isinstance(gas, Gas) for gas in gases.values()):
            raise TypeError("gases must be values of dsc.Gas")
        self._compiled = _dsc.Fluid(
            complex._compiled,
            {label: (liquid.density, liquid.viscosity) for label, liquid in liquids.items()},
            {label: (gas.pressure, gas.exponent) for label, gas in gases.items()},
            dict(tensions),
            gravity,
        )

    # Set-up

    def add_plane(
        self,
        point: tuple[float, float, float],
        normal: tuple[float, float, float],
        *,
        contact_angle: float = 90,
        no_slip: bool = False,
        separates: bool = True,
    ) -> None:
        """Adds a solid half space. Liquids are on the side that the normal points to.

        contact_angle: in the liquid between solid and surface, degrees in [0, 180]
        no_slip: whether liquid in contact moves with the solid
        separates: whether liquid may leave the solid
        """
        self._compiled.add_plane(point, normal, contact_angle, no_slip, separates)

    def add_tank(
        self,
        box: npt.ArrayLike,
        *,
        is_open: bool = False,
        contact_angle: float = 90,
        no_slip: bool = False,
        separates: bool = True,
    ) -> None:
        """Adds the walls of a tank around liquids. An open tank has no wall at the top.

        box: two opposite corners, shape (2, 3). Other parameters: see `add_plane()`.
        """
        self._compiled.add_tank(_box(box, 3), is_open, contact_angle, no_slip, separates)

    def add_ball(
        self,
        center: tuple[float, float, float],
        radius: float,
        *,
        outside: bool = False,
        contact_angle: float = 90,
        no_slip: bool = False,
        separates: bool = True,
    ) -> None:
        """Adds a solid ball, or the solid outside of a ball. Other parameters: see `add_plane()`."""
        self._compiled.add_ball(center, radius, outside, contact_angle, no_slip, separates)

    def add_cylinder(
        self,
        point: tuple[float, float, float],
        axis: tuple[float, float, float],
        radius: float,
        *,
        outside: bool = False,
        contact_angle: float = 90,
        no_slip: bool = False,
        separates: bool = True,
    ) -> None:
        """Adds an infinite solid cylinder, or its outside. Other parameters: see `add_plane()`."""
        self._compiled.add_cylinder(point, axis, radius, outside, contact_angle, no_slip, separates)

    def add_mesh(
        self,
        points: npt.ArrayLike,
        triangles: npt.ArrayLike,
        *,
        outside: bool = False,
        contact_angle: float = 90,
        no_slip: bool = False,
        separates: bool = True,
    ) -> None:
        """Adds a solid bounded by a closed surface, (n, 3) and (m, 3), or its outside.

        Other parameters: see `add_plane()`.
        """
        self._compiled.add_mesh(
            np.asarray(points, dtype=float),
            np.asarray(triangles),
            outside,
            contact_angle,
            no_slip,
            separates,
        )

    def set_sources(self, sources: Iterable[Source]) -> None:
        """Replaces the sources."""
        self._compiled.set_sources([(s.center, s.radius, s.rate) for s in sources])

    def set_velocities(self, velocities: npt.ArrayLike) -> None:
        """Sets the velocities of all vertices, shape (n, 3), in the order of `complex.cells().points`.

        The next step begins with the nearest velocities that preserve volumes and enter no wall.
        """
        self._compiled.set_velocities(np.asarray(velocities, dtype=float))

    # Access

    @property
    def complex(self) -> Complex3:
        """A copy of the present state of the complex."""
        return Complex3(self._compiled.complex())

    @property
    def time(self) -> float:
        """The time, initially 0."""
        return float(self._compiled.time())

    @property
    def velocities(self) -> Points:
        """Velocities of the vertices, shape (n, 3), in the order of `complex.cells().points`."""
        velocities: Points = self._compiled.velocities()
        return velocities

    @property
    def pressures(self) -> npt.NDArray[np.float64]:
        """Pressures at the vertices in the last step, shape (n,)."""
        pressures: npt.NDArray[np.float64] = self._compiled.pressures()
        return pressures

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
        topology, threads, deformation: as for `Complex3.deform()`

        Raises `FluidStepError` if no attempt succeeds. The fluid is then as before.
        """
        options = _given(
            implicitness=implicitness,
            interface_tolerance=interface_tolerance,
            adaptation_interval=adaptation_interval,
            topology=topology,
            threads=threads,
            **deformation,
        )
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
        return float(self._compiled.relax(_number(dt, "dt"), steps, _given(**options), progress))
