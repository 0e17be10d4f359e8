"""A measured section as a closed curve.

python blade.py [FOLDER]   leaves blade.svg, blade.png and blade.step in FOLDER
"""

import sys
from pathlib import Path

import numpy as np

import knotfit

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
samples = Path(__file__).resolve().parents[2] / "samples"

points = np.genfromtxt(samples / "blade_profile.csv", delimiter=",", skip_header=1)
fit = knotfit.fit_curve(points, closed=True, tol="0.1%")
print(fit)
print("tangent at t = 0.25:", fit.curve(0.25, derivative=1))

fit.save(folder / "blade.svg", force=True)
fit.save(folder / "blade.step", force=True)
(folder / "blade.png").write_bytes(fit.draw("png", width=1000))
