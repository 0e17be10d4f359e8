"""Files that hold surfaces, curves and data."""

from __future__ import annotations

import os
from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Floats
from ._errors import translated
from .curve import Curve
from .surface import Surface


class RasterData(NamedTuple):
    """z (rows, columns), NaN is a hole; x (columns,) and y (rows,) of the cells' centres: fit_raster(*data)."""

    z: Floats
    x: Floats
    y: Floats


class PointData(NamedTuple):
    """xyz (n, 3), or (n, 1) where there is z alone; uv (n, 2) or None; weights (n,) or None."""

    xyz: Floats
    uv: Floats | None
    weights: Floats | None


class MeshData(NamedTuple):
    """vertices (n, 3), faces (m, 3), uv (n, 2) or None: fit_mesh(*data)."""

    vertices: Floats
    faces: NDArray[np.int32]
    uv: Floats | None


Loaded = Union[Surface, Curve, RasterData, PointData, MeshData]


def _is_curve(path: str) -> bool:
    with open(path, encoding="utf-8", errors="replace") as file:
        return '"knotfit-curve"' in file.read(400)


def load(path: str | os.PathLike[str], *, face: int | None = None, unit: str | None = None) -> Any:
    """What a file holds: a Surface or Curve (.json, .step, .iges), a raster, points or a mesh.

    face        which surface of a STEP or IGES file, from 1; needed where there are several
    unit        "mm", "m", "inch": in which the coordinates of such a file are wanted
    FileError   it cannot be read; ValueError: a picture, which holds no numbers
    """
    name = os.fspath(path)
    extension = os.path.splitext(name)[1].lower()
    if extension in (".png", ".svg", ".pdf", ".vts"):
        raise ValueError(f"{name}: {extension} is written, not read; .json keeps a surface exactly")
    with translated(rows=False):
        if extension == ".json":
            if os.path.isfile(name) and _is_curve(name):
                return Curve._of(_core.read_curve(name))
            return Surface._of(_core.read_surface(name, face, unit or ""))
        if extension in (".step", ".stp", ".igs", ".iges"):
            return Surface._of(_core.read_surface(name, face, unit or ""))
        kind, *parts = _core.read_data(name)
    if kind == "raster":
        z, x0, y0, dx, dy = parts
        rows, columns = z.shape
        return RasterData(z, x0 + (np.arange(columns) + 0.5) * dx, y0 + (rows - np.arange(rows) - 0.5) * dy)
    if kind == "mesh":
        return MeshData(*parts)
    if kind == "points":
        return PointData(*parts)
    xyz, starts = parts
    lengths = np.diff(starts)
    if (lengths == lengths[0]).all():
        return PointData(xyz.reshape(len(lengths), int(lengths[0]), 3), None, None)
    return PointData(xyz, None, None)
