"""A SciPy user's first fit: scattered points, a tolerance, and the spline back in SciPy.

python first_fit.py [FOLDER]   leaves first_fit.png in FOLDER
"""

import sys
from pathlib import Path

import numpy as np

import knotfit

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

rng = np.random.default_rng(0)
x, y = rng.uniform(-1, 1, (2, 3000))
z = np.exp(-20 * (x - 0.3 * y) ** 2) + 0.3 * np.sin(4 * y)

# SciPy's bivariate splines want the knots, or a smoothing factor to be guessed. Here the tolerance is enough.
fit = knotfit.fit(np.column_stack([x, y, z]), height_field=True, tol=0.01)
print(fit)
print(f"largest error {fit.error.max:.4f}, between the points at most {fit.between:.4f}")

heights = fit.surface([0.0, 0.5], [0.2, -0.4])  # arrays that broadcast
slopes = fit.surface.derivative(1, 0)(0.0, 0.2)  # by x
print(heights, slopes)

# The same spline as SciPy has it.
try:
    from scipy.interpolate import bisplev
except ImportError:
    print("SciPy is not installed")
else:
    print("bisplev gives", bisplev(0.5, -0.4, fit.surface.to_scipy().tck))

(folder / "first_fit.png").write_bytes(fit.draw("png", width=1000))
