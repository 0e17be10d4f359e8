"""Your own placement method in Python beside the built-in ones.

python own_placement.py
"""

import numpy as np

import knotfit

rng = np.random.default_rng(0)
uv = rng.random((2000, 2))
z = np.tanh(20 * (uv[:, 0] - 0.5)) + 0.1 * np.sin(5 * uv[:, 1])


def steep(uv, values, interior_u, interior_v):
    """Equal shares of the absolute slope along u, uniform along v: uv is (n, 2) in [0, 1], values (n, d)."""
    order = np.argsort(uv[:, 0])
    bins = np.linspace(0, 1, 41)
    mean = np.array([values[order, 0][(uv[order, 0] >= a) & (uv[order, 0] < b)].mean() for a, b in zip(bins, bins[1:])])
    share = np.concatenate([[0], np.cumsum(np.abs(np.gradient(mean)) + 0.02)])
    knots_u = np.interp(np.linspace(0, share[-1], interior_u + 2)[1:-1], share, bins)
    return knots_u, np.linspace(0, 1, interior_v + 2)[1:-1]


for knots in ("uniform", steep, "error-model", "optimal"):
    name = knots if isinstance(knots, str) else knots.__name__
    fit = knotfit.fit(z, uv, knots=knots, control_points=(12, 6), between=False)
    print(f"{name:12} rms {fit.error.rms:.2e}")

fit = knotfit.fit(z, uv, knots=steep, tol="2%")
print("to 2 %:", fit)
