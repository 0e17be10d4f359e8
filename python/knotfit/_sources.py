"""What a caller gives as what the core takes: points, grids, meshes, files; frames and rasters by duck typing."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _arrays, _core
from ._arrays import Floats


class Input(NamedTuple):
    """How to make the core's source, as often as a call needs it."""

    make: Callable[[], _core.Source]
    shape: tuple[int, ...]  # of the errors; (): a file's points


def is_path(value: Any) -> bool:
    return isinstance(value, (str, os.PathLike))


def file(path: Any) -> Input:
    name = os.fspath(path)
    return Input(lambda: _core.file_source(name), ())


def _frame(frame: Any) -> dict[str, Any] | None:
    """Columns of a data frame by their names; None: it is none."""
    if not (hasattr(frame, "columns") and hasattr(frame, "__getitem__")):
        return None
    names = {str(c).strip().lower(): c for c in frame.columns}
    missing = [c for c in ("z",) if c not in names]
    if missing or ("x" in names) != ("y" in names):
        raise ValueError(f"xyz: the data frame has columns {', '.join(map(str, frame.columns))}; x, y, z are wanted, "
                         "and u, v, w (weights), nx, ny, nz where there are some")
    got: dict[str, Any] = {}
    space = ["x", "y", "z"] if "x" in names else ["z"]
    got["xyz"] = frame[[names[c] for c in space]].to_numpy()
    if "u" in names and "v" in names:
        got["uv"] = frame[[names["u"], names["v"]]].to_numpy()
    if "w" in names:
        got["weights"] = frame[names["w"]].to_numpy()
    if all(c in names for c in ("nx", "ny", "nz")):
        got["normals"] = frame[[names[c] for c in ("nx", "ny", "nz")]].to_numpy()
    return got


def points(xyz: Any, uv: Any, weights: Any, normals: Any, nan_policy: str, mapped: bool) -> Input:
    """Points (n, d), a grid of them (m, n, 3), or a data frame.

    `mapped`: options give the points other parameters than uv, or scale those.
    """
    columns = _frame(xyz)
    if columns is not None:
        xyz = columns["xyz"]
        uv = columns.get("uv") if uv is None else uv
        weights = columns.get("weights") if weights is None else weights
        normals = columns.get("normals") if normals is None else normals
    values = _arrays.plain(xyz, "xyz")
    if values.ndim == 3 and uv is None:
        return _grid(values, weights, normals, nan_policy)
    if uv is not None and values.ndim == 3:
        uv = _arrays.plain(uv, "uv")
        if uv.shape != values.shape[:2] + (2,):
            raise ValueError(f"uv: has shape {uv.shape}, not {values.shape[:2] + (2,)}")
        shape = values.shape[:2]
        values, uv = values.reshape(-1, values.shape[2]), uv.reshape(-1, 2)
        weights = None if weights is None else _arrays.plain(weights, "weights").reshape(-1)
        flat = points(values, uv, weights, normals, nan_policy, mapped)
        return Input(flat.make, shape)
    if values.ndim not in (1, 2) or values.size == 0:
        raise ValueError(f"xyz: has shape {values.shape}, not (n, 3), (m, n, 3), or (n, d) with uv")
    if uv is None and (values.ndim != 2 or values.shape[1] != 3):
        raise ValueError(f"xyz: has shape {values.shape}: without uv it is (n, 3) or (m, n, 3)")
    table = _arrays.table(nan_policy, xyz=values, uv=uv, weights=weights, normals=normals)
    column, places, weight, normal = table.columns
    assert column is not None
    numbers: Floats = column
    if places is not None and (places.ndim != 2 or places.shape[1] != 2):
        raise ValueError(f"uv: has shape {places.shape}, not (n, 2)")
    if normal is not None and (normal.ndim != 2 or normal.shape[1] != 3):
        raise ValueError(f"normals: has shape {normal.shape}, not (n, 3)")
    if weight is not None:
        _check_weights(weight, table)
    dimension = 1 if numbers.ndim == 1 else int(numbers.shape[1])
    if places is not None and not mapped:
        at: Floats = places
        return Input(lambda: _core.points_source(numbers, at, weight, table.kept, table.rows), (table.rows,))
    if dimension not in (1, 3):
        raise ValueError(f"xyz: has {dimension} columns; where parameters are scaled or found it has 3 (or 1, with uv)")
    return Input(lambda: _core.table_source(numbers, places, weight, normal, table.kept, table.rows), (table.rows,))


def _check_weights(weight: Floats, table: _arrays.Table) -> None:
    if weight.ndim != 1:
        raise ValueError(f"weights: has shape {weight.shape}, not (n,)")
    bad = np.flatnonzero(~(weight > 0))
    if bad.size:
        row = int(bad[0] if table.kept is None else table.kept[bad[0]])
        raise ValueError(f"weights: row {row} is {weight[bad[0]]}; weights are above 0")


def _grid(values: Any, weights: Any, normals: Any, nan_policy: str) -> Input:
    if values.shape[2] != 3 or weights is not None or normals is not None:
        raise ValueError("xyz: a grid of points has shape (m, n, 3), and neither weights nor normals")
    if nan_policy not in ("omit", "raise"):
        raise ValueError(f"nan_policy: {nan_policy!r} is neither 'omit' nor 'raise'")
    masked = isinstance(values, np.ma.MaskedArray)
    if masked:
        hole = _arrays.mask_of(values).any(axis=2)
        array = np.ascontiguousarray(_arrays.unmasked(_arrays.real(values, "xyz"), 0.0))
    else:
        hole = np.zeros(values.shape[:2], bool)
        array = _arrays.contiguous(_arrays.real(values, "xyz"), dtype=np.float64)
    lost = ~np.isfinite(array).all(axis=2) & ~hole
    if lost.any():
        i, j = (int(k) for k in np.argwhere(lost)[0])
        if nan_policy == "raise":
            raise ValueError(f"xyz: point [{i}, {j}] is not finite; nan_policy='omit' leaves such points out")
        hole |= lost
    if hole.any():
        array = array.copy()
        array[hole] = np.nan
    return Input(lambda: _core.rows_source(array), values.shape[:2])


class Grid(NamedTuple):
    """A raster as it was given: how to make it, and how its rows and columns lay."""

    input: Input | None  # None: of a fit that was pickled
    x: Floats
    y: Floats
    flip_x: bool
    flip_y: bool
    template: Any


def _axis(values: Any, name: str, count: int) -> Floats:
    if values is None:
        return np.arange(count, dtype=np.float64)
    axis = _arrays.floats(values, name, None)
    if len(axis) != count:
        raise ValueError(f"{name}: has {len(axis)} values, the raster {count} of them")
    if not np.isfinite(axis).all():
        raise ValueError(f"{name}: a value is not finite")
    steps = np.diff(axis)
    if count > 1:
        step = (axis[-1] - axis[0]) / (count - 1)
        if step == 0 or np.abs(steps - step).max() > 1e-6 * abs(step) + 8 * np.finfo(float).eps * np.abs(axis).max():
            raise ValueError(f"{name}: is not equally spaced; knotfit.fit(points, height_field=True) takes any places")
    return axis


def raster(z: Any, x: Any, y: Any, nodata: float | None, nan_policy: str) -> Grid:
    """Heights (rows, columns); x of the columns, y of the rows, of cell centres."""
    template = None
    if hasattr(z, "dims") and hasattr(z, "coords"):  # xarray's DataArray, by its manners
        template = z
        if len(z.dims) != 2:
            raise ValueError(f"z: has dimensions {', '.join(map(str, z.dims))}; a raster has two")
        rows, columns = z.dims
        x = z.coords[columns].values if x is None and columns in z.coords else x
        y = z.coords[rows].values if y is None and rows in z.coords else y
        nodata = z.attrs.get("_FillValue", nodata) if nodata is None else nodata
        z = z.values
    heights = _arrays.floats(z, "z", None, None)
    if nodata is not None and not np.isnan(nodata):
        heights = np.where(heights == nodata, np.nan, heights)
    if np.isinf(heights).any():
        i, j = (int(k) for k in np.argwhere(np.isinf(heights))[0])
        raise ValueError(f"z: cell [{i}, {j}] is infinite; nodata={heights[i, j]} makes it a hole")
    if nan_policy == "raise" and not isinstance(z, np.ma.MaskedArray) and nodata is None and np.isnan(heights).any():
        i, j = (int(k) for k in np.argwhere(np.isnan(heights))[0])
        raise ValueError(f"z: cell [{i}, {j}] is not finite; nodata=nan or nan_policy='omit' makes it a hole")
    rows, columns = heights.shape
    if rows < 2 or columns < 2:
        raise ValueError(f"z: has shape {heights.shape}; a surface needs 2 rows and columns")
    at_x, at_y = _axis(x, "x", columns), _axis(y, "y", rows)
    flip_x, flip_y = bool(at_x[0] > at_x[-1]), bool(at_y[0] < at_y[-1])  # the first row is north
    north = np.ascontiguousarray(heights[:: -1 if flip_y else 1, :: -1 if flip_x else 1])
    dx, dy = abs(at_x[-1] - at_x[0]) / (columns - 1), abs(at_y[-1] - at_y[0]) / (rows - 1)
    x0, y0 = min(at_x[0], at_x[-1]) - dx / 2, min(at_y[0], at_y[-1]) - dy / 2
    made = Input(lambda: _core.raster_source(north, x0, y0, dx, dy), heights.shape)
    return Grid(made, at_x, at_y, flip_x, flip_y, template)


def mesh(vertices: Any, faces: Any, uv: Any) -> Input:
    """A mesh, with parameters of its vertices or without."""
    places, corners = mesh_arrays(vertices, faces)
    parameters = None if uv is None else _arrays.floats(uv, "uv", len(places), 2)
    return Input(lambda: _core.mesh_source(places, corners, parameters), (len(places),))


def mesh_arrays(vertices: Any, faces: Any) -> tuple[Floats, NDArray[np.int32]]:
    """Arrays, or an object that has vertices and faces as trimesh, meshio or PyVista have them."""
    if faces is None:
        for has, with_ in (("vertices", "faces"), ("points", "cells"), ("points", "faces")):
            if hasattr(vertices, has) and hasattr(vertices, with_):
                found = getattr(vertices, with_)
                vertices, faces = getattr(vertices, has), found() if callable(found) else found
                break
        else:
            raise TypeError(f"faces: is missing, and {type(vertices).__name__} has neither .vertices and .faces nor "
                            ".points and .cells or .faces")
    if isinstance(faces, dict):
        faces = faces.get("triangle", faces.get("quad"))
    elif isinstance(faces, (list, tuple)) and len(faces) and hasattr(faces[0], "data") and hasattr(faces[0], "type"):
        blocks = [block.data for block in faces if block.type in ("triangle", "quad")]
        if not blocks:
            raise ValueError("faces: has no cells that are triangles or quadrilaterals")
        parts = [_arrays.triangles(block, "faces", len(vertices)) for block in blocks]
        faces = np.concatenate(parts)
    places = _arrays.floats(vertices, "vertices", None, 3)
    at = _core.first_not_finite(places)
    if at >= 0:
        raise ValueError(f"vertices: row {at // 3} is not finite")
    return places, _arrays.triangles(faces, "faces", len(places))
