"""Noisy points: a tolerance above the noise, the noise that was found, and where the data promises nothing.

python noisy.py [FOLDER]   leaves noisy.png in FOLDER
"""

import sys
from pathlib import Path

import numpy as np

import knotfit

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

rng = np.random.default_rng(0)
uv = rng.random((2500, 2))
uv = uv[np.hypot(uv[:, 0] - 0.6, uv[:, 1] - 0.4) > 0.18]  # a gap
truth = np.sin(5 * uv[:, 0]) * np.cos(4 * uv[:, 1])
z = truth + rng.normal(0, 0.02, len(truth))

fit = knotfit.fit(z, uv, tol=0.022, rms=True, knots="error-model")
print(fit)
print(f"noise found: {fit.report['noise']:.3f} (0.020 was added)")
print(f"off the truth: rms {np.sqrt(np.mean((fit.surface(*uv.T) - truth) ** 2)):.4f}")
print(f"promised between the points: {fit.between:.3f}, with error bars {fit.bound:.3f}; "
      f"{100 * fit.thin:.1f} % of the square is too thin to say")
for place in sorted(fit.thin_places, key=lambda place: -place.gap)[:3]:
    print(f"  thin at ({place.u:.2f}, {place.v:.2f}): error bar {place.error_bar:.3f}")

(folder / "noisy.png").write_bytes(fit.draw("png", width=1000))
