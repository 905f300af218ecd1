"""Named values on vertices and cells."""

from __future__ import annotations

from collections.abc import Iterator, MutableMapping
from typing import Any

import numpy as np
import numpy.typing as npt


class Values(MutableMapping[str, npt.NDArray[np.float64]]):
    """Named arrays of numbers on the vertices or the cells of a complex, of shape (n,) or (n, k).

    The rows are in the order of `Complex.cells()`. When the mesh changes, values on vertices are
    interpolated, and values on cells are averages whose integrals are conserved. A vertex that a motion
    moves keeps its value. An array that is read is a copy; assign it to change the values. Checkpoint
    files do not contain the values.
    """

    def __init__(self, compiled: Any, on_cells: bool) -> None:
        """Not for users. Use `Complex.vertex_values` and `Complex.cell_values`."""
        self._compiled = compiled
        self._on_cells = on_cells

    def __getitem__(self, name: str) -> npt.NDArray[np.float64]:
        values: npt.NDArray[np.float64] = self._compiled.get_values(self._on_cells, _name(name))
        return values

    def __setitem__(self, name: str, values: npt.ArrayLike) -> None:
        if self._on_cells and name in ("label", "quality"):
            raise ValueError(f"{name!r} is the name of an array of every mesh; choose another name")
        if isinstance(values, np.ma.MaskedArray):
            raise TypeError("values must not be masked; fill the array")
        array = np.asarray(values)
        if array.dtype.kind not in "biuf":
            raise TypeError("values must be real numbers")
        self._compiled.set_values(self._on_cells, _name(name), array)

    def __delitem__(self, name: str) -> None:
        if not self._compiled.remove_values(self._on_cells, _name(name)):
            raise KeyError(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._compiled.value_names(self._on_cells))

    def __len__(self) -> int:
        return len(self._compiled.value_names(self._on_cells))

    def __repr__(self) -> str:
        return f"<values on {'cells' if self._on_cells else 'vertices'}: {', '.join(self) or 'none'}>"


def _name(name: Any) -> str:
    if not isinstance(name, str):
        raise TypeError(f"a name must be a string, not {name!r}")
    return name
