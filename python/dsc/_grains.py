"""Growth of the grains of a polycrystal."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _dsc
from ._complex import Complex, Density, PairFunction, Progress, _energy, _given, _number, _numbers, _report
from ._labels import _integer
from ._report import Report


@dataclass(frozen=True)
class GrainStep:
    """Report of a step of `GrainGrowth`."""

    time: float
    """Time at the end of the step."""
    dt: float
    """Length of the step."""
    removed: list[int]
    """Labels of grains that would have vanished in the step, and were removed as a whole."""
    report: Report
    """Report of the motion."""


class GrainGrowth:
    """Growth of grains: all labels of a complex are grains, whose interfaces move by an energy.

    Edges become longer as grains grow. At the sides of a box, interfaces end at right angles.

        labels = dsc.Voronoi(100, (1, 1))
        torus = dsc.Torus2.from_function(labels, (1, 1), .01)
        torus.keep_largest_components()
        growth = dsc.GrainGrowth(torus)
        while len(torus.labels) > 50:
            growth.advance()
    """

    def __init__(
        self,
        complex: Complex,
        *,
        tension: float | PairFunction | None = None,
        mobility: float | PairFunction | None = None,
        density: Density | None = None,
        edges: float = 10,
        step: float = 0.1,
        fastest: float = 1,
        longest_edge: float | None = None,
        time: float = 0,
        threads: int | None = None,
    ) -> None:
        """Makes the growth of the grains of a complex, which changes in each step.

        tension, mobility, density: the energy, see `Complex.mean_curvature()`
        edges: edges of the interface in the diameter of a mean grain
        step: time step in squares of an edge, divided by `fastest`
        fastest: greatest product of a tension and a mobility
        longest_edge: greatest length of edges, such as half the radius of particles. Particles are the
            labels whose interfaces all have the mobility 0 now; they keep their place.
        time: present time, for example of a complex without particles that was read from a file
        threads: number of threads; the result does not depend on it
        """
        if not isinstance(complex, Complex):
            raise TypeError("complex must be a complex of this package")
        options = _given(
            {},
            **_energy(tension, mobility, density, complex.label_names),
            edges=_number(edges, "edges"),
            step=_number(step, "step"),
            fastest=_number(fastest, "fastest"),
            longest_edge=None if longest_edge is None else _number(longest_edge, "longest_edge"),
            threads=None if threads is None else _integer(threads, "threads"),
        )
        self.complex = complex
        compiled = getattr(_dsc, f"GrainGrowth{type(complex._compiled).__name__}")
        self._compiled = compiled(complex._compiled, options)
        self._compiled.set_time(_number(time, "time"))

    @property
    def time(self) -> float:
        """Present time, in units of an area."""
        return float(self._compiled.time())

    def advance(self, *, progress: Progress | None = None) -> GrainStep:
        """Performs a time step. Only advances the time if there is no interface.

        If the step fails, the complex is valid, but its mesh may have changed.
        """
        result = self._compiled.advance(progress)
        result["report"] = _report(result["report"])
        return GrainStep(**result)


class Voronoi:
    """Labels of a Voronoi diagram of random seeds in a box from the origin, for `from_function()`.

    Labels are 1, 2, 3 and so on. They depend on the arguments only.
    """

    def __init__(
        self,
        number: int,
        sides: Sequence[float],
        *,
        periodic: bool = True,
        seed: int = 1,
        distance: float = 0.6,
    ) -> None:
        """Chooses the seeds.

        number: number of seeds
        sides: 2 or 3 sides of the box
        periodic: whether the box is a torus
        seed: number of the random sequence
        distance: least distance of seeds, in sides of a cube (in the plane, a square) of the mean size of
            a grain; 0 to 0.7
        """
        dimension = len(sides)
        if dimension not in (2, 3):
            raise ValueError("sides must be two or three lengths")
        self._compiled = getattr(_dsc, f"Voronoi{dimension}")(
            _integer(number, "number"),
            _numbers(sides, dimension, "sides"),
            bool(periodic),
            _integer(seed, "seed"),
            _number(distance, "distance"),
        )

    def __call__(self, points: npt.ArrayLike) -> npt.NDArray[np.int32]:
        """Returns the labels of points of shape (n, d), which must be in the box."""
        labels: npt.NDArray[np.int32] = self._compiled(np.asarray(points, dtype=float))
        return labels


class Orientations:
    """Random orientations of cubic crystals, one for each label from 1 on.

    In the plane, crystals are rotated about the normal of the plane.
    """

    def __init__(self, number: int, dimension: int, *, seed: int = 1) -> None:
        """Chooses the orientations of a number of grains."""
        if dimension not in (2, 3):
            raise ValueError("dimension must be 2 or 3")
        self._compiled = getattr(_dsc, f"Orientations{dimension}")(
            _integer(number, "number"), _integer(seed, "seed")
        )

    def misorientation(self, a: int, b: int) -> float:
        """Returns the least angle, in degrees, of a rotation from the lattice of a to that of b."""
        return float(np.degrees(self._compiled.misorientation(_integer(a, "a"), _integer(b, "b"))))

    def read_shockley(self, largest_angle: float = 15, least: float = 0.05) -> Callable[[int, int], float]:
        """Returns the tension of Read and Shockley as a function of two labels, for `GrainGrowth`.

        largest_angle: angle in degrees from which on the tension is 1
        least: smallest tension
        """
        largest = float(np.radians(_number(largest_angle, "largest_angle")))
        smallest = _number(least, "least")

        def tension(a: int, b: int) -> float:
            angle: Any = self._compiled.misorientation(a, b)
            return float(_dsc.read_shockley_energy(angle, largest, smallest))

        return tension
