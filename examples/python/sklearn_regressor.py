"""A surface as a regressor of scikit-learn.

python sklearn_regressor.py
"""

import numpy as np
from sklearn.model_selection import GridSearchCV
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

from knotfit.sklearn import SplineSurfaceRegressor

rng = np.random.default_rng(0)
X = rng.uniform(0, 10, (800, 2))
y = np.sin(X[:, 0]) + 0.1 * X[:, 1] ** 1.5 + rng.normal(0, 0.05, 800)

model = make_pipeline(StandardScaler(), SplineSurfaceRegressor())
search = GridSearchCV(model, {"splinesurfaceregressor__control_points": [4, 6, 8, 12]}, cv=4)
search.fit(X[:600], y[:600])
print(search.best_params_, f"R2 on new points {search.score(X[600:], y[600:]):.4f}")
