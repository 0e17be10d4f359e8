"""An xarray raster in, one out, with its coordinates.

python xarray_raster.py
"""

import numpy as np
import xarray

import knotfit

lat, lon = np.linspace(46, 47, 61), np.linspace(7, 8.5, 81)
height = 800 + 300 * np.sin(4 * lon) * np.cos(5 * lat)[:, None]
height[10:14, 30:40] = np.nan
raster = xarray.DataArray(height, coords={"lat": lat, "lon": lon}, dims=("lat", "lon"), attrs={"units": "m"})

fit = knotfit.fit(raster, tol=2.0)
smooth = fit.raster(fill_holes=True)
print(smooth.isel(lat=slice(10, 13), lon=slice(30, 33)))
print(fit, float(abs(smooth - raster).max()))
