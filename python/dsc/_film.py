"""Films: runs as one HTML file that a browser shows without a network."""

from __future__ import annotations

import html
import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from . import _dsc
from ._files import _replace_file
from ._labels import Label, _integer, _label
from ._report import Report

if TYPE_CHECKING:
    from ._complex import Complex


class Film:
    """Collects states of a complex, and shows them in a browser or a notebook.

    surface: whether only the interface is stored, which takes less space
    hidden: labels, by number or name, that are not shown until the user shows them
    """

    def __init__(self, title: str = "", *, surface: bool = False, hidden: Iterable[Label] = (0,)) -> None:
        self._title = str(title)
        self._surface = surface
        self._hidden: list[Label] = [
            label if isinstance(label, str) else _integer(label, "a label") for label in hidden
        ]
        self._dimension = 0
        self._compiled: _dsc.Film | None = None

    def add(
        self,
        complex: Complex,
        time: float | None = None,
        report: Report | None = None,
        fields: Mapping[str, npt.ArrayLike] = {},
    ) -> None:
        """Adds the present state of a complex.

        time: time of the state; by default its number
        report: report of the step that led to it; its events are shown
        fields: named values that are shown as colors. Scalars have shape (n,), vectors (n, d). They are
            on vertices if n is the number of points, otherwise on cells (with `surface`, on facets).
        """
        if self._compiled is None:
            self._dimension = complex.dimension
            self._compiled = _dsc.Film(self._title, complex.dimension, not self._surface)
            for label in self._hidden:
                self._compiled.hide(_label(label, complex.label_names))
        elif complex.dimension != self._dimension:
            raise ValueError("the complex has another dimension than the film")
        step = self._compiled.number_of_frames()
        at = float(step) if time is None else float(time)
        if self._surface:
            facets = complex.interface()
            points, simplices, labels, ids = facets.points, facets.facets, facets.labels, facets.ids
        else:
            cells = complex.cells()
            points, simplices, labels, ids = cells.points, cells.cells, cells.labels, cells.ids
        for label, name in complex.label_names.items():
            self._compiled.set_name(label, name)
        values = {name: np.asarray(field) for name, field in fields.items()}
        for name, field in values.items():
            if field.ndim not in (1, 2) or field.dtype.kind not in "biuf":
                raise ValueError(f"the field {name!r} must be an array of numbers of shape (n,) or (n, d)")
        self._compiled.add(
            step,
            at,
            points,
            simplices,
            labels,
            ids,
            {name: (len(field) == len(points), field) for name, field in values.items()},
        )
        for event in report.events if report is not None else []:
            self._compiled.add_event(at, f"label {event.label}: components {event.kind}")

    def __len__(self) -> int:
        """Returns the number of states."""
        return 0 if self._compiled is None else int(self._compiled.number_of_frames())

    def html(self) -> str:
        """Returns the page. Raises ValueError if there is no state."""
        if self._compiled is None:
            raise ValueError("the film has no state; call add() first")
        return str(self._compiled.html())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the page into a file (.html). The file is complete or unchanged."""
        _replace_file(path, self.html().encode("utf-8"))

    def _repr_html_(self) -> str:
        page = html.escape(self.html(), quote=True)
        return (
            f'<iframe srcdoc="{page}" style="width: 100%; height: 640px; border: 0" '
            'sandbox="allow-scripts allow-downloads"></iframe>'
        )
