"""Arrays of any kind as float64 in C order, without a copy where they are that."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core

Floats = NDArray[np.float64]


def plain(value: Any, name: str) -> Any:
    """An array as it is: pandas and xarray objects give their values, masked arrays stay."""
    if isinstance(value, np.ndarray):
        return value
    for attribute in ("to_numpy",):
        if hasattr(value, attribute):
            value = getattr(value, attribute)()
            break
    try:
        array = np.asanyarray(value)
    except (ValueError, TypeError) as e:
        raise TypeError(f"{name}: is no array of numbers: {e}") from None
    return array


def real(array: Any, name: str) -> Any:
    """Refuses what holds no real numbers."""
    if array.dtype.kind == "O":
        try:
            array = array.astype(np.float64)
        except (ValueError, TypeError):
            raise TypeError(f"{name}: holds objects that are no numbers") from None
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name}: holds {array.dtype}, not real numbers")
    return array


def contiguous(array: Any, dtype: Any = np.float64) -> Any:
    """In C order and aligned: itself where it is."""
    return np.require(np.ascontiguousarray(array, dtype=dtype), requirements=["C", "A"])


def mask_of(array: Any) -> Any:
    """Of a masked array, of its full shape."""
    return np.broadcast_to(array.mask, array.shape)


def unmasked(array: Any, fill: float) -> Any:
    """A masked array as a plain one; any other as it is."""
    return array.astype(np.float64).filled(fill) if hasattr(array, "filled") else array


def floats(value: Any, name: str, *shape: int | None) -> Floats:
    """float64, C order, of this shape; None: any length. Masked entries become NaN."""
    array = unmasked(real(plain(value, name), name), np.nan)
    if shape and (array.ndim != len(shape) or any(w is not None and w != g for w, g in zip(shape, array.shape))):
        wanted = ", ".join("n" if w is None else str(w) for w in shape) + ("," if len(shape) == 1 else "")
        raise ValueError(f"{name}: has shape {array.shape}, not ({wanted})")
    result: Floats = contiguous(array, dtype=np.float64)
    return result


def triangles(value: Any, name: str, vertices: int) -> NDArray[np.int32]:
    """(m, 3) corners of [0, vertices); polygons of four corners become two triangles."""
    array = plain(value, name)
    if array.dtype.kind not in "iu":
        if array.dtype.kind == "f" and np.all(array == np.floor(array)):
            array = array.astype(np.int64)
        else:
            raise TypeError(f"{name}: holds {array.dtype}, not whole numbers")
    if array.ndim == 1 and array.size and _is_vtk(array):
        array = array.reshape(-1, array[0] + 1)[:, 1:]
    if array.ndim != 2 or array.shape[1] not in (3, 4):
        raise ValueError(f"{name}: has shape {array.shape}, not (m, 3) or (m, 4)")
    if array.shape[1] == 4:
        array = np.concatenate([array[:, [0, 1, 2]], array[:, [0, 2, 3]]])
    bad = (array < 0) | (array >= vertices)
    if bad.any():
        row = int(np.flatnonzero(bad.any(axis=1))[0])
        raise ValueError(f"{name}: row {row} names vertex {array[row][bad[row]][0]}, of {vertices}")
    corners: NDArray[np.int32] = contiguous(array, np.int32)
    return corners


def _is_vtk(array: Any) -> bool:
    """[3, a, b, c, 3, ...], as PyVista has its faces."""
    size = int(array[0]) + 1
    return size in (4, 5) and array.size % size == 0 and bool(np.all(array[::size] == array[0]))


class Table(NamedTuple):
    """Columns of points without the rows that miss a value."""

    columns: tuple[Floats | None, ...]
    kept: NDArray[np.intp] | None  # rows that stay; None: all
    rows: int


def table(nan_policy: str, **named: Any) -> Table:
    """Arrays of one length, by name; a masked row is a hole, one with NaN is omitted or refused."""
    if nan_policy not in ("omit", "raise"):
        raise ValueError(f"nan_policy: {nan_policy!r} is neither 'omit' nor 'raise'")
    rows = -1
    first = ""
    masked: Any = None
    arrays: list[Floats | None] = []
    for name, value in named.items():
        if value is None:
            arrays.append(None)
            continue
        array = plain(value, name)
        if isinstance(array, np.ma.MaskedArray):
            mask = mask_of(array)
            mask = mask.reshape(len(mask), -1).any(axis=1)
            masked = mask if masked is None else masked | mask
            array = unmasked(real(array, name), 0.0)
        array = contiguous(real(array, name), dtype=np.float64)
        if rows >= 0 and len(array) != rows:
            raise ValueError(f"{name}: has {len(array)} rows, {first} has {rows}")
        rows, first = len(array), first or name
        arrays.append(array)
    keep: Any = None if masked is None else ~masked
    for name, array in zip(named, arrays):
        if array is None:
            continue
        at = _core.first_not_finite(array)
        if at < 0:
            continue
        if nan_policy == "raise":
            good = np.isfinite(array).reshape(len(array), -1).all(axis=1)
            if keep is not None:
                good |= ~keep
            if good.all():
                continue
            row = int(np.flatnonzero(~good)[0])
            raise ValueError(f"{name}: row {row} is not finite; nan_policy='omit' leaves such rows out")
        infinite = np.isinf(array).reshape(len(array), -1).any(axis=1)
        if infinite.any():
            raise ValueError(f"{name}: row {int(np.flatnonzero(infinite)[0])} is infinite")
        good = ~np.isnan(array).reshape(len(array), -1).any(axis=1)
        keep = good if keep is None else keep & good
    if keep is None or keep.all():
        return Table(tuple(arrays), None, rows)
    return Table(tuple(None if a is None else np.ascontiguousarray(a[keep]) for a in arrays), np.flatnonzero(keep),
                 rows)
