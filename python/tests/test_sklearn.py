"""The regressor among scikit-learn's own."""

import numpy as np
import pytest

sklearn = pytest.importorskip("sklearn", reason="scikit-learn is not installed")
from sklearn.base import clone  # noqa: E402
from sklearn.model_selection import GridSearchCV, cross_val_score  # noqa: E402
from sklearn.pipeline import make_pipeline  # noqa: E402
from sklearn.preprocessing import StandardScaler  # noqa: E402
from sklearn.utils.estimator_checks import check_estimator  # noqa: E402

from knotfit.sklearn import SplineSurfaceRegressor  # noqa: E402

# Checks of scikit-learn 1.2 that fail, and how many columns they feed where a surface has two.
OTHER_COLUMNS = {
    "check_dict_unchanged": 3,
    "check_dont_overwrite_parameters": 3,
    "check_dtype_object": 10,
    "check_estimators_dtypes": 5,
    "check_estimators_nan_inf": 3,
    "check_estimators_pickle": 3,
    "check_fit2d_predict1d": 3,
    "check_fit_score_takes_y": 3,
    "check_methods_sample_order_invariance": 3,
    "check_methods_subset_invariance": 3,
    "check_pipeline_consistency": 3,
    "check_regressor_data_not_an_array": 10,
    "check_regressors_int": 10,
    "check_regressors_no_decision_function": 4,
    "check_regressors_train": 10,
    "check_sample_weights_list": 3,
    "check_supervised_y_2d": 3,
}


@pytest.fixture(scope="module")
def data():
    X = np.random.default_rng(0).uniform(-1, 3, (600, 2))
    return X, np.sin(X[:, 0]) * np.cos(2 * X[:, 1]) + 0.01 * np.random.default_rng(1).normal(size=600)


def test_a_surface_is_fitted(data):
    X, y = data
    model = SplineSurfaceRegressor(control_points=(8, 9)).fit(X, y)
    assert model.score(X, y) > 0.99 and model.surface_.size == (8, 9)
    assert model.predict(X[:3]).shape == (3,)
    searched = SplineSurfaceRegressor(tol="20%", control_points=None).fit(X, y)
    assert searched.fit_.status == "reached"


def test_pipelines_and_searches(data):
    X, y = data
    model = make_pipeline(StandardScaler(), SplineSurfaceRegressor())
    assert cross_val_score(model, X, y, cv=3).min() > 0.9
    search = GridSearchCV(model, {"splinesurfaceregressor__control_points": [4, 7, 10]}, cv=3).fit(X, y)
    assert search.best_params_["splinesurfaceregressor__control_points"] in (7, 10)
    assert clone(search.best_estimator_).get_params()["splinesurfaceregressor__degree"] == 3


def test_weights_of_zero_leave_rows_out(data):
    X, y = data
    keep = np.arange(600) % 2 == 0
    spoiled = np.where(keep, y, 99.0)
    weighted = SplineSurfaceRegressor().fit(X, spoiled, sample_weight=keep.astype(float))
    assert np.allclose(weighted.predict(X[keep]), SplineSurfaceRegressor().fit(X[keep], y[keep]).predict(X[keep]))


def test_other_numbers_of_columns_are_refused(data):
    X, y = data
    with pytest.raises(ValueError, match="X has 1 feature"):
        SplineSurfaceRegressor().fit(X[:, :1], y)


def test_scikit_learns_own_checks():
    failed = {}
    for estimator, check in check_estimator(SplineSurfaceRegressor(), generate_only=True):
        name = check.func.__name__
        try:
            check(estimator)
        except Exception as e:  # whatever a check raises, its name and reason are listed
            failed.setdefault(name, str(e).splitlines()[0] if str(e) else repr(e))
    reasons = {name: f"X has {columns} feature(s); a surface is over 2 features"
               for name, columns in OTHER_COLUMNS.items()}
    if sklearn.__version__.startswith("1.2."):
        assert failed == reasons
    else:  # names and data of the checks change from version to version
        assert all("a surface is over 2 features" in reason for reason in failed.values()), failed


def test_few_rows_are_fitted_by_a_lower_degree():
    X = np.array([[0, 0], [0, 1], [1, 0], [1, 1], [1, 1]], float)
    model = SplineSurfaceRegressor().fit(X, [0, 1, 2, 3, 5])
    assert model.surface_.degree == (1, 1)
    np.testing.assert_allclose(model.predict(X[:4]), [0, 1, 2, 4], atol=1e-6)
    with pytest.raises(ValueError, match="n_samples = 2"):
        SplineSurfaceRegressor().fit(X[:2], [0, 1])
