"""Curves."""

import copy
import json
import pickle
import subprocess

import numpy as np
import pytest
from scipy.interpolate import BSpline

import knotfit


@pytest.fixture(scope="module")
def blade(samples):
    return np.genfromtxt(samples / "blade_profile.csv", delimiter=",", names=True).view((float, 2))


@pytest.mark.parametrize("options, keywords", [
    (["--closed", "--tol", "0.1%"], {"closed": True, "tol": "0.1%"}),
    (["--control-points", "20", "--knots", "error-model", "--degree", "4", "--spacing", "centripetal"],
     {"control_points": 20, "knots": "error-model", "degree": 4, "spacing": "centripetal"}),
])
def test_arrays_give_the_bits_of_the_tool(tool, samples, blade, tmp_path, options, keywords):
    out = tmp_path / "a.json"
    done = subprocess.run([tool, "fit-curve", samples / "blade_profile.csv", *options, "--json", "-o", out],
                          capture_output=True, text=True, check=False)
    theirs = json.loads(done.stdout)
    ours = knotfit.fit_curve(blade, on_miss="ignore", **keywords)
    for name in ("control_points", "knots", "measured", "status", "fits", "noise"):
        assert ours.report[name] == theirs[name], name
    assert knotfit.load(out) == ours.curve


def test_what_a_curve_says(blade):
    fit = knotfit.fit_curve(blade, closed=True, tol="0.1%")
    assert fit.reached and fit.curve.closed and fit.measured == fit.errors.max()
    np.testing.assert_allclose(np.linalg.norm(fit.curve(fit.t) - blade[:len(fit.t)], axis=1), fit.errors, atol=1e-12)
    np.testing.assert_allclose(fit.curve(1.25), fit.curve(0.25))
    t, c, k = fit.curve.to_scipy()
    np.testing.assert_allclose(BSpline(t, c, k)(fit.t), fit.curve(fit.t), atol=1e-14 * np.abs(blade).max())
    np.testing.assert_allclose(BSpline(t, c, k).derivative()(0.3), fit.curve(0.3, 1), rtol=1e-12)
    more = fit.curve.insert_knots([0.51, 0.11])
    np.testing.assert_allclose(more(fit.t), fit.curve(fit.t), atol=1e-14 * np.abs(blade).max())
    assert fit.draw("svg").count(b"<svg") == 1 and "CurveFit reached" in repr(fit) and "status" in fit.summary()


def test_functions():
    x = np.linspace(2, 5, 200)
    fit = knotfit.fit_curve(np.column_stack([x, np.sin(3 * x)]), function=True, tol=1e-3)
    assert fit.curve.function and fit.curve.domain == (2, 5) and fit.curve(3.0).shape == ()
    np.testing.assert_allclose(fit.curve(x), np.sin(3 * x), atol=1.1e-3)
    np.testing.assert_allclose(fit.curve(x[5:-5], 1), 3 * np.cos(3 * x[5:-5]), atol=0.05)
    t, c, k = fit.curve.to_scipy()
    np.testing.assert_allclose(BSpline(t, c, k)(x), fit.curve(x), atol=1e-13)
    with pytest.raises(ValueError):
        knotfit.fit_curve(np.column_stack([x[::-1], x]), function=True)


def test_any_dimension_with_parameters_of_your_own():
    t = np.linspace(0, 1, 150)
    values = np.column_stack([np.sin(k * t) for k in range(1, 5)])
    fit = knotfit.fit_curve(values, t, tol="0.1%")
    assert fit.curve.dimension == 4 and (fit.t == t).all()
    assert knotfit.fit_curve(values[:, 0], t, tol="0.1%").curve(0.5).shape == ()
    knots = knotfit.fit_curve(values, t, knots=[0.3, 0.6])
    assert knots.curve.knots.tolist() == [0] * 4 + [0.3, 0.6] + [1] * 4 and knots.status == "fixed_size"


def test_files_pickles_copies(blade, tmp_path):
    fit = knotfit.fit_curve(blade, control_points=15, knots="uniform", closed=True)
    for name in ("a.json", "a.csv", "a.png", "a.svg", "a.pdf", "a.step", "a.igs"):
        fit.save(tmp_path / name)
        if name != "a.csv":
            fit.curve.save(tmp_path / ("b" + name))
    assert knotfit.load(tmp_path / "a.json") == fit.curve == knotfit.load(tmp_path / "ba.json")
    with pytest.raises(ValueError, match="no curve is written as"):
        fit.save(tmp_path / "a.obj")
    again = pickle.loads(pickle.dumps(fit))
    assert again.curve == fit.curve == copy.deepcopy(fit.curve) and (again.errors == fit.errors).all()
    assert again.draw().startswith(b"\x89PNG")


def test_mistakes_of_curves(blade):
    for arguments, keywords, error, words in [
            ((blade[:, :1].ravel(),), {}, ValueError, r"^points: has shape \(n,\): values need t"),
            ((blade, np.linspace(0, 2, len(blade))), {}, ValueError, "^t: row .* outside"),
            ((blade,), {"degree": 11}, ValueError, "^degree: "),
            ((blade,), {"knots": [0.5, 0.4]}, ValueError, "^knots_t: "),
            ((np.where(np.arange(len(blade))[:, None] == 3, np.nan, blade),), {}, ValueError, "^points: row 3 is")]:
        with pytest.raises(error, match=words):
            knotfit.fit_curve(*arguments, **keywords)
    with pytest.warns(knotfit.KnotfitWarning) as heard:
        knotfit.fit_curve(blade, tol=1e-9, control_points=5)
    assert heard[0].filename == __file__
    with pytest.raises(knotfit.ToleranceMissed):
        knotfit.fit_curve(blade, tol=1e-9, control_points=5, on_miss="raise")
