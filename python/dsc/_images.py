"""Images of other packages: arrays of voxels with a place in space."""

from __future__ import annotations

import importlib
from typing import Any

import numpy as np
import numpy.typing as npt

_rounding = 1e-4
"""Deviation of a direction from an axis that files with numbers of 32 bits cause."""


class PlacedImage:
    """Voxels and the affine map of their indices to space."""

    def __init__(self, voxels: npt.NDArray[Any], affine: npt.NDArray[np.float64]) -> None:
        self.voxels = voxels
        self.affine = affine

    @classmethod
    def of(cls, image: Any) -> PlacedImage | None:
        """Returns an image of nibabel or SimpleITK; None for an array."""
        if hasattr(image, "affine") and hasattr(image, "dataobj"):
            return cls(np.asanyarray(image.dataobj), np.asarray(image.affine, dtype=float))
        if hasattr(image, "GetSpacing") and hasattr(image, "GetDirection"):
            voxels = importlib.import_module("SimpleITK").GetArrayFromImage(image)
            d = voxels.ndim
            affine = np.eye(d + 1)
            affine[:d, :d] = np.reshape(image.GetDirection(), (d, d)) * np.asarray(image.GetSpacing())
            affine[:d, d] = image.GetOrigin()
            return cls(voxels.T, affine)
        return None

    @property
    def is_oblique(self) -> bool:
        """Whether an axis of the image is not an axis of space."""
        return bool(np.any(np.count_nonzero(self._directions(), axis=0) != 1))

    @property
    def spacing(self) -> npt.NDArray[np.float64]:
        """Sides of a voxel, along the axes of the image."""
        d = len(self.affine) - 1
        spacing: npt.NDArray[np.float64] = np.linalg.norm(self.affine[:d, :d], axis=0)
        if not np.all(spacing > 0):
            raise ValueError("the affine map of the image is singular")
        return spacing

    def _directions(self) -> npt.NDArray[np.float64]:
        d = len(self.affine) - 1
        directions: npt.NDArray[np.float64] = self.affine[:d, :d] / self.spacing
        return np.where(np.abs(directions) > _rounding, directions, 0)

    def along_axes_of_space(self) -> PlacedImage:
        """Returns the image with axes that are permuted and reversed to the axes of space."""
        d = len(self.affine) - 1
        directions = self._directions()
        order = np.argmax(np.abs(directions), axis=1)
        voxels = np.transpose(self.voxels, order)
        affine = np.eye(d + 1)
        affine[:d, :d] = np.diag(self.spacing[order])
        affine[:d, d] = self.affine[:d, d]
        for axis in range(d):
            if directions[axis, order[axis]] < 0:
                voxels = np.flip(voxels, axis)
                affine[axis, d] -= affine[axis, axis] * (voxels.shape[axis] - 1)
        return PlacedImage(voxels, affine)

    def as_stored(self, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
        """Returns values along the axes of space in the order of the voxels of this image."""
        directions = self._directions()
        order = np.argmax(np.abs(directions), axis=1)
        for axis in range(values.ndim):
            if directions[axis, order[axis]] < 0:
                values = np.flip(values, axis)
        return np.transpose(values, np.argsort(order))
