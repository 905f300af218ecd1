"""Solids and rigid bodies of fluids."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ._complex import _box, _callable, _given, _number, _numbers
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
        point, normal = self._coordinates(point, "point"), self._coordinates(normal, "normal")
        self._add({"type": "plane", "point": point, "normal": normal}, options)

    def add_tank(self, box: npt.ArrayLike, *, is_open: bool = False, **options: Any) -> None:
        """Adds the walls of a tank around liquids. An open tank has no wall at the top.

        box: two opposite corners, shape (2, d); the top has the largest z, in the plane the largest y
        options: the options of solids, see `Fluid`
        """
        lower, upper = _box(box, self._dimension)
        tank = {"type": "tank", "box": lower + upper, "open": _flag(is_open, "is_open")}
        self._add(tank, options)

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
        lower, upper = self._coordinates(lower, "lower"), self._coordinates(upper, "upper")
        self._add({"type": "box", "from": lower, "to": upper, **_body(density, fixed)}, options)

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
        center, radius = self._coordinates(center, "center"), _number(radius, "radius")
        ball = {"type": "ball", "center": center, "radius": radius, **_side(outside)}
        self._add({**ball, **_body(density, fixed)}, options)

    def add_cylinder(
        self,
        point: Sequence[float],
        axis: Sequence[float],
        radius: float,
        *,
        outside: bool = False,
        **options: Any,
    ) -> None:
        """Adds an infinite solid cylinder, or its outside. Raises `InvalidSolidError` in the plane.

        options: the options of solids, see `Fluid`; the center is the point
        """
        point, axis = self._coordinates(point, "point"), self._coordinates(axis, "axis")
        cylinder = {"type": "cylinder", "point": point, "axis": axis, **_side(outside)}
        self._add({**cylinder, "radius": _number(radius, "radius")}, options)

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
        """Adds a solid bounded by a closed surface, its outside, or a body.

        Raises `InvalidSolidError` in the plane.

        points, triangles: shapes (n, 3) and (m, 3)
        density, fixed: the options of bodies, see `Fluid`
        options: the options of solids, see `Fluid`; the center is the mean of the points
        """
        mesh = np.asarray(points, dtype=float), np.asarray(triangles)
        body = _body(density, fixed)
        self._add({"type": "mesh", "file": "", **_side(outside), **body}, options, mesh)

    @property
    def bodies(self) -> list[Body]:
        """Present places and motions of the bodies, in the order in which they were added."""
        return [Body(**body) for body in self._compiled.bodies()]

    def _coordinates(self, values: Sequence[float], name: str) -> list[float]:
        return _numbers(values, self._dimension, name)

    def _add(self, solid: dict[str, Any], options: dict[str, Any], mesh: Any = None) -> None:
        """Adds a solid, which is described as in a scene of the program, with the options of solids.

        The compiled part checks the description.
        """
        given = _given(options)
        motion = self._motion(given.pop("motion", None), given.pop("motion_step", None))
        for name, value in given.items():
            if name == "contact_angle":
                solid[name] = _number(value, name)
            elif name in ("no_slip", "separates"):
                solid["sticks" if name == "no_slip" else name] = _flag(value, name)
            elif name == "velocity":
                solid[name] = self._coordinates(value, name)
            elif name == "angular_velocity":
                solid[name] = _rotation(value, self._dimension, name)
            else:
                raise TypeError(f"unknown option {name!r}")
        for name in ("density", "velocity", "angular_velocity"):
            if motion and name in solid:
                raise ValueError(f"motion cannot be combined with {name}; remove one of them")
        self._compiled.add_solid(solid, mesh, motion)

    def _motion(self, motion: Motion | None, step: Any) -> tuple[_Places, float] | None:
        if motion is None:
            if step is not None:
                raise ValueError("motion_step has no effect without motion")
            return None
        step = 1e-5 if step is None else _number(step, "motion_step")
        if not 0 < step < np.inf:
            raise ValueError("motion_step must be positive and finite")
        places = _Places(_callable(motion, "motion"), self._dimension)
        places(float(self._compiled.time()))  # checks the values
        return places, step


class _Places:
    """A motion with three coordinates of the displacement and of the rotation."""

    def __init__(self, motion: Motion, dimension: int) -> None:
        self._motion = motion
        self._dimension = dimension

    def __call__(self, t: float) -> tuple[list[float], list[float]]:
        place = self._motion(t)
        if not isinstance(place, (tuple, list)) or len(place) != 2:
            raise ValueError("a motion must return a displacement and a rotation")
        displacement = _numbers(place[0], self._dimension, "a displacement")
        rotation = _rotation(place[1], self._dimension, "a rotation")
        if isinstance(rotation, float):
            return [*displacement, 0], [0, 0, rotation]
        return displacement, rotation


def _rotation(value: Any, dimension: int, name: str) -> float | list[float]:
    """Returns an angle in the plane, or a vector in space."""
    return _number(value, name) if dimension == 2 else _numbers(value, 3, name)


def _flag(value: Any, name: str) -> bool:
    if isinstance(value, str):
        raise TypeError(f"{name} must be True or False, not {value!r}")
    return bool(value)


def _side(outside: bool) -> dict[str, str]:
    """Returns where the liquids are, if the solid is inside or outside of a surface."""
    return {"liquid": "inside" if _flag(outside, "outside") else "outside"}


def _body(density: float | None, fixed: Iterable[str]) -> dict[str, Any]:
    names = [fixed] if isinstance(fixed, str) else [str(name) for name in dict.fromkeys(fixed)]
    given = None if density is None else _number(density, "density")
    return _given({}, density=given, fixed=names or None)
