"""Many tiles in parallel with Dask: the GIL is released, so threads will do.

python tiles_with_dask.py
"""

from pathlib import Path

import dask
import numpy as np

import knotfit

samples = Path(__file__).resolve().parents[2] / "samples"
dem = knotfit.load(samples / "jacksboro.asc")


@dask.delayed
def fit_tile(i, j, size=64):
    rows, columns = slice(i * size, (i + 1) * size + 1), slice(j * size, (j + 1) * size + 1)
    # One thread a tile: Dask has the others busy. Results do not depend on it.
    return knotfit.fit_raster(dem.z[rows, columns], dem.x[columns], dem.y[rows], control_points=16, knots="error-model",
                              between=False, threads=1)


fits = dask.compute(*(fit_tile(i, j) for i in range(3) for j in range(3)), scheduler="threads")
print(f"{len(fits)} tiles, {sum(np.prod(f.surface.size) for f in fits)} control points, "
      f"largest rms {max(f.error.rms for f in fits):.2f}")
for fit in fits[:3]:
    print(fit.surface.domain[0], fit)
