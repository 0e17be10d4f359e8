"""Surfaces as a regressor of scikit-learn, which this module alone imports."""

from __future__ import annotations

from typing import Any

import numpy as np
from sklearn.base import BaseEstimator, RegressorMixin
from sklearn.utils.validation import _check_sample_weight, check_is_fitted

from .fit import fit as fit_surface


class SplineSurfaceRegressor(RegressorMixin, BaseEstimator):
    """y over two features by one B-spline surface whose knots are placed by the data.

    tol             as fit() has it; None with control_points: a fixed size
    control_points  (along the first feature, along the second), or None: searched to the tolerance
    knots, degree, smoothing, rms, within, effort, duplicates, threads   as fit() has them
    outside         "clamp" or "nan": of places outside the features' range in fit()

    surface_  the Surface after fit(); fit_  the Fit. Where the rows are few, size and degree are lower than asked
    """

    def __init__(self, tol: Any = None, *, control_points: Any = (8, 8), knots: Any = "error-model", degree: Any = 3,
                 smoothing: float = 1e-9, rms: bool = False, within: Any = None, effort: str = "balanced",
                 duplicates: str = "mean", outside: str = "clamp", threads: int = 0) -> None:
        self.tol = tol
        self.control_points = control_points
        self.knots = knots
        self.degree = degree
        self.smoothing = smoothing
        self.rms = rms
        self.within = within
        self.effort = effort
        self.duplicates = duplicates
        self.outside = outside
        self.threads = threads

    def _fitting(self, rows: int) -> tuple[Any, tuple[int, int]]:
        """Size and degree, both made lower where the rows are too few for them."""
        p, q = (int(d) for d in np.broadcast_to(np.asarray(self.degree), 2))
        while (p + 1) * (q + 1) > rows and max(p, q) > 1:
            p, q = (p - 1, q) if p >= q else (p, q - 1)
        if self.control_points is None:
            return None, (p, q)
        m, n = (int(s) for s in np.broadcast_to(np.asarray(self.control_points), 2))
        m, n = max(m, p + 1), max(n, q + 1)
        while m * n > rows and (m > p + 1 or n > q + 1):
            m, n = (m - 1, n) if m - p >= n - q else (m, n - 1)
        return (m, n), (p, q)

    def fit(self, X: Any, y: Any, sample_weight: Any = None) -> SplineSurfaceRegressor:
        """X (n, 2), y (n,), sample_weight (n,) >= 0: rows of weight 0 are left out."""
        X, y = self._validate_data(X, y, y_numeric=True, dtype=np.float64, ensure_min_samples=2)
        if X.shape[1] != 2:
            raise ValueError(f"X has {X.shape[1]} feature(s); a surface is over 2 features")
        weights = None
        if sample_weight is not None:
            weights = _check_sample_weight(sample_weight, X, dtype=np.float64)
            if (weights < 0).any():
                raise ValueError("sample_weight: a weight is negative")
            used = weights > 0
            X, y, weights = X[used], y[used], weights[used]
        places = len(np.unique(X, axis=0))
        if places < 4:
            raise ValueError(f"n_samples = {len(X)} at {places} different places are too few: a surface needs 4")
        size, degree = self._fitting(places)
        self.fit_ = fit_surface(np.column_stack([X, y]), height_field=True, tol=self.tol, control_points=size,
                                knots=self.knots, degree=degree, smoothing=self.smoothing, rms=self.rms,
                                within=self.within, effort=self.effort, duplicates=self.duplicates, weights=weights,
                                between=False, threads=self.threads, on_miss="ignore")
        self.surface_ = self.fit_.surface
        return self

    def predict(self, X: Any) -> Any:
        """(n,) heights at X (n, 2)."""
        check_is_fitted(self, "surface_")
        X = self._validate_data(X, reset=False, dtype=np.float64)
        outside: Any = self.outside
        return self.surface_(X[:, 0], X[:, 1], outside=outside)

    def _more_tags(self) -> dict[str, Any]:
        # The checks' own data is noise over many columns.
        return {"poor_score": True}
