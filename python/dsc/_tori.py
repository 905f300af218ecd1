"""Complexes on flat tori."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from . import _dsc
from ._complex import Complex, LabelFunction, Progress, _callable, _number, _numbers


class Torus(Complex):
    """Common part of `Torus2` and `Torus3`: complexes on flat tori, which fill all space periodically.

    Points of `cells()` and `interface()` are the vertices, in the box from 0 to the periods, and then
    images of vertices across its sides. Destinations of `deform()` belong to the vertices of the
    interface.
    """

    @classmethod
    def from_function(  # type: ignore[override]
        cls: type[SelfTorus],
        labels: LabelFunction,
        periods: Sequence[float],
        edge: float,
        *,
        progress: Progress | None = None,
    ) -> SelfTorus:
        """Fills a torus with cells whose labels are given by a function, and fits the interface to it.

        labels: a periodic function, called with many points at once
        periods: d lengths
        edge: approximate length of edges
        """
        if cls._class is None:
            raise NotImplementedError("tori are not in this build; set the CMake option DSC_PYTHON_TORI")
        _callable(labels, "labels")
        lengths = _numbers(periods, cls.dimension, "periods")
        return cls(cls._class.from_function(labels, lengths, _number(edge, "edge"), progress))

    @property
    def periods(self) -> tuple[float, ...]:
        """Periods of the torus."""
        return tuple(self._compiled.periods())


SelfTorus = TypeVar("SelfTorus", bound=Torus)


class Torus3(Torus):
    """A complex on a flat torus of three dimensions."""

    dimension = 3
    _class = getattr(_dsc, "Torus3", None)


class Torus2(Torus):
    """A complex on a flat torus of two dimensions."""

    dimension = 2
    _class = getattr(_dsc, "Torus2", None)
