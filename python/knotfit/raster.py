"""Fits of rasters."""

from __future__ import annotations

from typing import Any

from . import _options, _sources
from ._run import ProgressLike
from .fit import USUAL, Fit, NanPolicy, OnMiss, run


def fit_raster(z: Any, x: Any = None, y: Any = None, nodata: float | None = None, *, options: Any = None,
               nan_policy: NanPolicy = "omit", on_miss: OnMiss = "warn", threads: int = 0,
               progress: ProgressLike = None, **keywords: Any) -> Fit:
    """Fits a height field to a raster.

    z       (rows, columns) heights; NaN, masked and `nodata` cells are holes. An xarray DataArray brings x and y
    x, y    (columns,) and (rows,), of the cells' centres, equally spaced, rising or falling; default 0, 1, 2, ...
    nodata  a height that stands for a hole
    keywords as fit() has them; those of points and meshes do nothing for a raster and are refused

    Fit.raster() gives the fitted heights back in the form of z, Fit.errors has the shape of z.
    """
    unknown = [name for name in keywords if name not in USUAL]
    if unknown:
        raise TypeError(f"fit_raster() got an unexpected keyword argument {unknown[0]!r}")
    if nan_policy not in ("omit", "raise"):
        raise ValueError(f"nan_policy: {nan_policy!r} is neither 'omit' nor 'raise'")
    grid = _sources.raster(z, x, y, nodata, nan_policy)
    given = _options.changed(USUAL, keywords)
    assert grid.input is not None
    return run(grid.input, given, options=options, threads=threads, progress=progress, on_miss=on_miss,
               function="fit_raster", grid=grid)
