"""Choosing knots for SciPy's LSQBivariateSpline, which leaves them to its user.

python knots_for_scipy.py
"""

import numpy as np
from scipy.interpolate import LSQBivariateSpline

import knotfit

rng = np.random.default_rng(0)
u, v = rng.random((2, 4000))
z = np.tanh(25 * (u - 0.7)) + 0.2 * np.sin(6 * v)
points, uv = z, np.column_stack([u, v])

box = {"bbox": [0, 1, 0, 1]}
even = np.linspace(0, 1, 10)[1:-1]
uniform = LSQBivariateSpline(u, v, z, even, even, **box)
print(f"{'uniform':12} rms {np.sqrt(np.mean((uniform(u, v, grid=False) - z) ** 2)):.2e}")

for method in ("error-model", "optimal"):
    knots = knotfit.place_knots(points, uv, control_points=(12, 12), method=method)
    spline = LSQBivariateSpline(u, v, z, knots.u, knots.v, **box)
    print(f"{method:12} rms {np.sqrt(np.mean((spline(u, v, grid=False) - z) ** 2)):.2e}, knots along u "
          f"{np.array2string(knots.u, precision=2)}")
