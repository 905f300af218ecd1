"""Segmentation of images."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _dsc
from ._complex import Complex2, Complex3, Progress, _given, _number, _numbers
from ._images import PlacedImage
from ._labels import Label, _integer, _label


@dataclass(frozen=True)
class Phase:
    """A phase of a segmentation."""

    label: int
    """Its label in the complex."""
    intensities: list[float]
    """Mean value of each channel, or the given value."""
    pixels: float
    """Area or volume, in pixels."""
    components: int
    """Number of connected components."""


@dataclass(frozen=True)
class Boundary:
    """The boundary between two phases of a segmentation. Lengths are in sides of pixels."""

    labels: tuple[int, int]
    """The labels of the phases, increasing."""
    measure: float
    """Length or area."""
    uncertainty: float
    """Standard deviation of the position by the noise."""


@dataclass(frozen=True)
class Segmentation:
    """Result of `segment()`."""

    complex: Complex2 | Complex3
    """The pixels as a mesh. Labels are the indices of `phases`."""
    phases: list[Phase]
    """The phases, by increasing labels. A phase that vanished has no components."""
    boundaries: list[Boundary]
    """The boundaries between phases."""
    noise: list[float]
    """Standard deviation of the noise of each channel."""
    smoothing: float
    """Energy of the interface, see `segment()`."""
    energies: list[float]
    """The energy after every fifth motion of the interface, and at the end."""
    residual: float
    """Mean squared deviation of pixels from their phases, in units of the noise."""
    converged: bool
    """Whether the energies after the last two motions differ by less than 2 % of that of the interface."""


def segment(
    image: Any,
    phases: int | None = None,
    *,
    intensities: npt.ArrayLike | None = None,
    spacing: float | Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
    mask: npt.ArrayLike | None = None,
    channel_axis: int | None = None,
    noise: float | Sequence[float] | None = None,
    smoothing: float | None = None,
    longest_edge: float | None = None,
    shortest_edge: float | None = None,
    start: Complex2 | Complex3 | None = None,
    keep_topology: bool | None = None,
    connected: Iterable[Label] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Segmentation:
    """Divides an image into phases of constant intensity, and meshes them.

    image: numbers of shape (nx, ny) or (nx, ny, nz), with axes x, y, z; for a picture of rows from top
        to bottom, use `picture[::-1].T`. Or an image of nibabel or SimpleITK whose axes are axes of
        space.
    phases: number of phases; default 2
    intensities: intensities of the phases, shape (k,) or (k, channels), instead of their number. Labels
        are their indices.
    spacing: sides of a pixel; by default 1
    origin: center of the first pixel; by default 0
    mask: false for pixels that are ignored, of the shape of the image
    channel_axis: axis of `image` with several channels; by default there is one channel
    noise: standard deviation of the noise; by default estimated
    smoothing: energy of the interface per side of a pixel, in squares of the noise; by default, it
        depends on the smallest contrast of two phases
    longest_edge, shortest_edge: edges at the beginning, and of the interface at the end, in pixels
    start: complex to begin with, whose labels are indices of phases; it does not change, and the result has
        the names of its labels
    keep_topology: whether the topology of `start`, or of the labels of the first mesh, stays
    connected: labels, by number or by a name of `start`, of which only the largest component stays
    threads: number of threads; the result does not depend on it
    progress: called with the name of the present phase; the function ends if it returns false

    Raises `Error` if there are fewer separate classes of values than phases, a value is not finite, or an
    option is out of its range; `TypeError` or `ValueError` if types or shapes do not fit; `Interrupted`
    if `progress` returned false.
    """
    values, mask, place = _placed(image, spacing, origin, mask, channel_axis)
    channels = [values] if channel_axis is None else list(np.moveaxis(values, channel_axis, 0))
    if not channels or channels[0].ndim not in (2, 3):
        raise ValueError("image must have two or three axes, and the channels")
    d = channels[0].ndim
    shape = channels[0].shape
    if start is not None and not isinstance(start, Complex2 if d == 2 else Complex3):
        raise TypeError(f"start must be a Complex{d}")
    names = {} if start is None else start.label_names
    options = _given(
        {},
        phases=None if phases is None else _integer(phases, "phases"),
        intensities=_intensities(intensities, phases, len(channels)),
        noise=None if noise is None else _repeated(noise, len(channels), "noise"),
        smoothing=None if smoothing is None else _number(smoothing, "smoothing"),
        longest_edge=None if longest_edge is None else _number(longest_edge, "longest_edge"),
        shortest_edge=None if shortest_edge is None else _number(shortest_edge, "shortest_edge"),
        keep_topology=keep_topology,
        connected=None if connected is None else [_label(x, names) for x in connected],
        threads=threads,
    )
    compiled, report = (_dsc.segment_2 if d == 2 else _dsc.segment_3)(
        [channel.astype(np.float32).ravel(order="F") for channel in channels],
        _mask(mask, shape).ravel(order="F"),
        shape,
        _repeated(place[0], d, "spacing"),
        _repeated(place[1], d, "origin"),
        None if start is None else start._compiled,
        options,
        progress,
    )
    report["phases"] = [Phase(**phase) for phase in report["phases"]]
    report["boundaries"] = [Boundary(**boundary) for boundary in report["boundaries"]]
    result: Complex2 | Complex3 = Complex2(compiled) if d == 2 else Complex3(compiled)
    result.label_names = names
    return Segmentation(result, **report)


def _placed(
    image: Any, spacing: Any, origin: Any, mask: Any, channel_axis: int | None
) -> tuple[npt.NDArray[Any], Any, tuple[Any, Any]]:
    """Returns the values, the mask, and the spacing and the origin of an image of any kind."""
    placed = PlacedImage.of(image)
    if placed is not None:
        if spacing is not None or origin is not None or channel_axis is not None:
            raise TypeError("an image has a spacing and an origin; leave the arguments out")
        if placed.is_oblique:
            raise ValueError("the axes of the image are not axes of space: resample it")
        if placed.voxels.ndim != len(placed.affine) - 1:
            raise ValueError("image must have two or three axes")
        straight = placed.along_axes_of_space()
        if mask is not None:
            if np.shape(mask) != placed.voxels.shape:
                raise ValueError("mask must have the shape of the image")
            mask = PlacedImage(np.asarray(mask), placed.affine).along_axes_of_space().voxels
        d = straight.voxels.ndim
        image, spacing, origin = straight.voxels, straight.spacing, straight.affine[:d, d]
    elif isinstance(image, np.ma.MaskedArray):
        if mask is not None or channel_axis is not None:
            raise TypeError("the image is masked already: leave out mask and channel_axis")
        mask = ~np.ma.getmaskarray(image)  # type: ignore[no-untyped-call]
        image = image.filled(0)  # type: ignore[no-untyped-call]
    values = np.asarray(image)
    if values.dtype.kind not in "biuf":
        raise TypeError("image must contain real numbers")
    return values, mask, (1.0 if spacing is None else spacing, 0.0 if origin is None else origin)


def _mask(mask: Any, shape: tuple[int, ...]) -> npt.NDArray[np.uint8]:
    if mask is None:
        return np.ones(0, np.uint8)
    array = np.asarray(mask)
    if array.dtype.kind not in "biuf":
        raise TypeError("mask must contain truth values")
    if array.shape != shape:
        raise ValueError("mask must have the shape of the image")
    result: npt.NDArray[np.uint8] = ((array != 0) & ~np.isnan(array)).astype(np.uint8)
    return result


def _intensities(intensities: Any, phases: int | None, channels: int) -> list[list[float]] | None:
    if intensities is None:
        return None
    array = np.asarray(intensities, dtype=float)
    if array.ndim == 1:
        array = array[:, None]
    if array.ndim != 2 or array.shape[1] != channels:
        raise ValueError("intensities must have the shape (k,) or (k, channels)")
    if phases is not None and phases != len(array):
        raise ValueError("phases and the number of intensities differ: leave out phases")
    result: list[list[float]] = array.tolist()
    return result


def _repeated(value: Any, number: int, name: str) -> list[float]:
    """Returns several numbers, which can be given as one."""
    array = np.asarray(value, dtype=float)
    return _numbers(np.full(number, array) if array.ndim == 0 else array, number, name)
