"""Solids and rigid bodies of fluids."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ._complex import _box, _callable, _given, _number, _numbers
from ._errors import Error
from ._report import Points

Motion = Callable[[float], tuple[Any, Any]]
"""The displacement and the rotation of a solid at a time, relative to the given shape. The displacement
has d coordinates. The rotation is about the center of the given shape, in radians: an angle in the
plane, the axis times the angle in space."""


@dataclass(frozen=True)
class Body:
    """The place and motion of a rigid body."""

    center: Points
    """Center of mass, shape (d,)."""
    velocity: Points
    """Velocity of the center, shape (d,)."""
    angular_velocity: Points | float
    """Radians in a unit of time: shape (3,) in space, a number in the plane."""
    rotation: Points | float
    """Rotation since the body was added. In space, a unit quaternion with its real part first, shape (4,).
    In the plane, an angle in [-pi, pi]."""
    mass: float
    """Mass; in the plane, of a layer of thickness 1."""


class Solids:
    """The functions of `Fluid` for solids. Not for users: use `Fluid`."""

    _dimension: int
    _compiled: Any

    def add_plane(self, point: Sequence[float], normal: Sequence[float], **options: Any) -> None:
        """Adds a solid half space (in the plane, a half plane).

        point, normal: a point of its boundary, and the direction to the side of the liquids
        options: the options of solids, see `Fluid`; the center is the point
        """
        self._compiled.add_plane(
            self._coordinates(point, "point"),
            self._coordinates(normal, "normal"),
            self._options(options),
        )

    def add_tank(self, box: npt.ArrayLike, *, is_open: bool = False, **options: Any) -> None:
        """Adds the walls of a tank around liquids. An open tank has no wall at the top.

        box: two opposite corners, shape (2, d); the top has the largest z, in the plane the largest y
        options: the options of solids, see `Fluid`
        """
        self._compiled.add_tank(_box(box, self._dimension), is_open, self._options(options))

    def add_box(
        self,
        lower: Sequence[float],
        upper: Sequence[float],
        *,
        density: float | None = None,
        fixed: Iterable[str] = (),
        **options: Any,
    ) -> None:
        """Adds a solid box (in the plane, a rectangle), or a body of this shape.

        lower, upper: the corners with the smallest and the largest coordinates
        density, fixed: the options of bodies, see `Fluid`
        options: the options of solids, see `Fluid`
        """
        corners = self._coordinates(lower, "lower"), self._coordinates(upper, "upper")
        self._compiled.add_box(
            corners, self._body(density, fixed, options), self._options(options)
        )

    def add_ball(
        self,
        center: Sequence[float],
        radius: float,
        *,
        outside: bool = False,
        density: float | None = None,
        fixed: Iterable[str] = (),
        **options: Any,
    ) -> None:
        """Adds a solid ball (in the plane, a disk), the solid outside of a ball, or a body.

        density, fixed: the options of bodies, see `Fluid`
        options: the options of solids, see `Fluid`
        """
        self._compiled.add_ball(
            self._coordinates(center, "center"),
            _number(radius, "radius"),
            outside,
            self._body(density, fixed, options, outside),
            self._options(options),
        )

    def add_cylinder(
        self,
        point: Sequence[float],
        axis: Sequence[float],
        radius: float,
        *,
        outside: bool = False,
        **options: Any,
    ) -> None:
        """Adds an infinite solid cylinder, or its outside. Raises `Error` in the plane.

        options: the options of solids, see `Fluid`; the center is the point
        """
        self._require_space("a cylinder")
        self._compiled.add_cylinder(
            self._coordinates(point, "point"),
            self._coordinates(axis, "axis"),
            _number(radius, "radius"),
            outside,
            self._options(options),
        )

    def add_mesh(
        self,
        points: npt.ArrayLike,
        triangles: npt.ArrayLike,
        *,
        outside: bool = False,
        density: float | None = None,
        fixed: Iterable[str] = (),
        **options: Any,
    ) -> None:
        """Adds a solid bounded by a closed surface, its outside, or a body. Raises `Error` in the plane.

        points, triangles: shapes (n, 3) and (m, 3)
        density, fixed: the options of bodies, see `Fluid`
        options: the options of solids, see `Fluid`; the center is the mean of the points
        """
        self._require_space("a closed surface")
        self._compiled.add_mesh(
            np.asarray(points, dtype=float),
            np.asarray(triangles),
            outside,
            self._body(density, fixed, options, outside),
            self._options(options),
        )

    @property
    def bodies(self) -> list[Body]:
        """Present places and motions of the bodies, in the order in which they were added."""
        return [Body(**body) for body in self._compiled.bodies()]

    def _coordinates(self, values: Sequence[float], name: str) -> list[float]:
        return _numbers(values, self._dimension, name)

    def _require_space(self, solid: str) -> None:
        if self._dimension == 2:
            raise Error(f"{solid} is a solid in space: use a plane, a tank, a box or a ball in the plane")

    def _options(self, options: dict[str, Any]) -> dict[str, Any]:
        """Returns the options of a solid for the compiled part. Vectors have three coordinates."""
        result = _given({}, **options)
        step = _number(result.pop("motion_step", 1e-5), "motion_step")
        if not 0 < step < np.inf:
            raise ValueError("motion_step must be positive and finite")
        if "motion_step" in options and "motion" not in result:
            raise ValueError("motion_step has no effect without motion")
        if "motion" in result:
            if "velocity" in result or "angular_velocity" in result:
                raise ValueError("a solid with a motion has no velocity and no angular_velocity")
            motion = _Places(_callable(result["motion"], "motion"), self._dimension)
            motion(float(self._compiled.time()))  # checks the values
            result["motion"] = motion, step
        if "velocity" in result:
            result["velocity"] = _in_space(self._coordinates(result["velocity"], "velocity"))
        if "angular_velocity" in result:
            given = result["angular_velocity"]
            result["angular_velocity"] = _rotation(given, self._dimension, "angular_velocity")
        return result

    def _body(
        self,
        density: float | None,
        fixed: Iterable[str],
        options: dict[str, Any],
        outside: bool = False,
    ) -> tuple[float, list[bool], bool] | None:
        """Returns the density, whether a body moves along each axis, and whether it rotates."""
        names = [fixed] if isinstance(fixed, str) else list(fixed)
        if density is None:
            if names:
                raise ValueError("fixed has no effect without a density")
            return None
        if outside:
            raise ValueError("a body has its liquids outside, so outside must be False")
        if options.get("motion") is not None:
            raise ValueError("a body has no motion: use velocity and angular_velocity")
        axes = ("x", "y", "z")[: self._dimension]
        for name in names:
            if name not in (*axes, "rotation"):
                raise ValueError(f"fixed must be some of {', '.join(axes)} and rotation, not {name!r}")
        translates = [axis not in names for axis in ("x", "y", "z")]
        rotates = "rotation" not in names
        self._require_free(options, translates, rotates)
        return _number(density, "density"), translates, rotates

    def _require_free(self, options: dict[str, Any], translates: list[bool], rotates: bool) -> None:
        """Raises ValueError if the initial motion of a body has a component that is fixed."""
        motion = self._options(options)
        if np.any(motion.get("velocity", np.zeros(3))[~np.array(translates)]):
            raise ValueError("velocity must be 0 in the directions of fixed")
        if not rotates and np.any(motion.get("angular_velocity", 0)):
            raise ValueError("angular_velocity must be 0 because fixed contains rotation")


class _Places:
    """A motion with three coordinates of the displacement and of the rotation."""

    def __init__(self, motion: Motion, dimension: int) -> None:
        self._motion = motion
        self._dimension = dimension

    def __call__(self, t: float) -> tuple[Points, Points]:
        place = self._motion(t)
        if not isinstance(place, (tuple, list)) or len(place) != 2:
            raise ValueError("a motion must return a displacement and a rotation")
        displacement, rotation = place
        return (
            _in_space(_numbers(displacement, self._dimension, "a displacement")),
            _rotation(rotation, self._dimension, "a rotation"),
        )


def _in_space(values: Any) -> Points:
    coordinates = np.zeros(3)
    coordinates[: len(values)] = values
    return coordinates


def _rotation(value: Any, dimension: int, name: str) -> Points:
    """Returns a rotation about the third axis in the plane, or about any axis in space."""
    if dimension == 2:
        return np.array([0, 0, _number(value, name)])
    return np.array(_numbers(value, 3, name))
