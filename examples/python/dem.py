"""Terrain: a raster with holes, fitted, and its slope anywhere.

python dem.py [FOLDER]   leaves dem.png and dem.asc in FOLDER
"""

import sys
from pathlib import Path

import numpy as np

import knotfit

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
samples = Path(__file__).resolve().parents[2] / "samples"

dem = knotfit.load(samples / "jacksboro.asc")
z, x, y = dem.z[:160, :160].copy(), dem.x[:160], dem.y[:160]
z[40:60, 90:120] = np.nan  # a lake that nobody measured

fit = knotfit.fit_raster(z, x, y, tol="10%", within="99%", knots="error-model")
print(fit.summary())

heights = fit.raster(fill_holes=True)  # the shape of z, without holes
print("of the hole:", np.nanmin(heights[40:60, 90:120]), "to", np.nanmax(heights[40:60, 90:120]))

centre = x[80], y[80]
slope = np.hypot(fit.surface.derivative(1, 0)(*centre), fit.surface.derivative(0, 1)(*centre))
print("slope at the centre, height a degree:", slope)

fit.save(folder / "dem.asc", force=True)
(folder / "dem.png").write_bytes(fit.draw("png", width=1000))
