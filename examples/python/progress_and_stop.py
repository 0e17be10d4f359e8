"""Progress, and three ways to stop: a limit, a callable, Ctrl-C.

python progress_and_stop.py
"""

import numpy as np

import knotfit

rng = np.random.default_rng(0)
uv = rng.random((8000, 2))
z = np.sign(uv[:, 0] - 0.37 * uv[:, 1] - 0.3)  # a step: no small surface holds a small tolerance


def enough(progress):
    """Returns False to stop."""
    print(progress)
    return progress.fits < 200


fit = knotfit.fit(z, uv, tol="0.1%", progress=enough)
print(fit.status, fit)

fit = knotfit.fit(z, uv, tol="0.1%", time_limit=1, on_miss="ignore")
print(fit.status, fit)

try:
    knotfit.fit(z, uv, tol="0.1%", max_fits=150, on_miss="raise", progress=True)
except KeyboardInterrupt as stopped:  # Ctrl-C: the best so far is not lost
    print("stopped with", stopped.best)
except knotfit.ToleranceMissed as missed:
    print(missed.fit.status, missed.fit)
