"""The fit: same bits as the tool, outcomes, mistakes in Python's terms."""

import copy
import inspect
import json
import pickle
import subprocess
import warnings

import numpy as np
import pytest

import knotfit
from knotfit import _core, _options
from knotfit.fit import OWN, SAVE_USUAL, USUAL


def run(tool, *arguments):
    done = subprocess.run([tool, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 3), done.stderr
    return json.loads(done.stdout)


# Members that a second run changes, and what says where the data came from.
PASSING = {"seconds", "peak_memory_bytes", "outputs", "input", "options", "columns", "columns_from", "message", "notes"}


def without(report, *more):
    return {k: v for k, v in report.items() if k not in PASSING | set(more)}


@pytest.mark.parametrize("arguments, keywords", [
    (["face.uv.csv", "--tol", "1%", "--rms"], {"tol": "1%", "rms": True}),
    (["face.uv.csv", "--control-points", "12x9", "--knots", "error-model", "--degree", "2x4"],
     {"control_points": (12, 9), "knots": "error-model", "degree": (2, 4)}),
    (["face.uv.csv", "--tol", "0.5", "--within", "99%", "--effort", "fast"],
     {"tol": 0.5, "within": 0.99, "effort": "fast"}),
    (["jacksboro.asc", "--control-points", "30x30", "--knots", "uniform", "--between", "off"],
     {"control_points": 30, "knots": "uniform", "between": False}),
])
def test_a_file_gives_the_bits_of_the_tool(tool, samples, tmp_path, arguments, keywords):
    out = tmp_path / "tool.json"
    theirs = run(tool, "fit", samples / arguments[0], *arguments[1:], "--json", "-o", out)
    ours = knotfit.fit(samples / arguments[0], on_miss="ignore", **keywords)
    assert without(ours.report) == without(theirs)
    assert ours.options == theirs["options"]
    assert json.loads(ours.surface.to_json())["control_points"] == json.loads(out.read_text())["control_points"]
    assert knotfit.load(out) == ours.surface


def test_arrays_give_the_bits_of_the_tool(tool, samples, tmp_path):
    theirs = run(tool, "fit", samples / "face.uv.csv", "--tol", "1%", "--rms", "--json", "-o", tmp_path / "a.json")
    data = knotfit.load(samples / "face.uv.csv")
    ours = knotfit.fit(data.xyz, data.uv, tol="1%", rms=True)
    assert without(ours.report, "error") == without(theirs, "error")
    worst, theirs_worst = ours.report["error"].pop("worst"), theirs["error"].pop("worst")
    assert ours.report["error"] == theirs["error"] and worst["index"] == theirs_worst["index"]
    assert knotfit.load(tmp_path / "a.json") == ours.surface
    saved = json.loads((tmp_path / "a.json").read_text())
    net = np.array(saved["control_points"]).reshape(ours.surface.control_points.shape)
    assert (net == ours.surface.control_points).all()


def test_a_raster_gives_the_bits_of_the_tool(tool, samples, tmp_path):
    options = ["--control-points", "24x24", "--knots", "quantile", "--between", "off"]
    theirs = run(tool, "fit", samples / "jacksboro.asc", *options, "--json", "-o", tmp_path / "a.json")
    data = knotfit.load(samples / "jacksboro.asc")
    ours = knotfit.fit_raster(*data, control_points=24, knots="quantile", between=False)
    assert ours.report["error"]["rms"] == theirs["error"]["rms"]
    assert ours.report["knots"] == theirs["knots"]
    assert (ours.surface.control_points == knotfit.load(tmp_path / "a.json").control_points).all()
    assert ours.errors.shape == data.z.shape


def test_a_mesh_gives_the_bits_of_the_tool(tool, samples, tmp_path):
    options = ["--control-points", "10x10", "--knots", "uniform", "--correct", "6"]
    theirs = run(tool, "fit", samples / "face.obj", *options, "--json", "-o", tmp_path / "a.json")
    ours = knotfit.fit_mesh(*knotfit.load(samples / "face.obj"), control_points=10, knots="uniform", correct=6)
    assert without(ours.report, "error") == without(theirs, "error")
    assert ours.report["error"]["rms"] == theirs["error"]["rms"]
    assert knotfit.load(tmp_path / "a.json") == ours.surface


def test_options_and_defaults_are_those_of_the_tools_rows():
    rows = _options.rows("fit")
    # Rows that are no keyword of fit(): of outputs (keywords of save), of the command line, of other keywords.
    output = {"cell", "samples", "reflections", "unit", "name", "step_schema", "cad_safe", "cad_tol"}
    elsewhere = {"output": "Fit.save", "force": "Fit.save", "json": "Fit.report", "quiet": "progress",
                 "threads": "own", "options": "own", "knots_u": "knots", "knots_v": "knots", "knots_from": "knots",
                 "feature_file": "feature"}
    assert set(USUAL) == set(rows) - output - set(elsewhere)
    assert set(SAVE_USUAL) == output | {"fill_holes"}
    signature = inspect.signature(knotfit.fit)
    assert set(signature.parameters) == OWN | set(USUAL) | {"xyz", "uv"}
    for name, usual in {**SAVE_USUAL, **USUAL}.items():
        row = rows[name]
        text = None if usual is None else _options.text_of(name, usual, row)
        if row["usual"]:
            wanted = row["usual"]
        elif row["value"] == "":
            wanted = "off"
        else:
            wanted = None
        if name == "within":  # None: every point
            assert (usual, wanted) == (None, "max")
        elif row["value"] == "":
            assert (usual, wanted) == (False, "off")
        elif name == "degree":
            assert wanted in (text, f"{text}x{text}")
        elif name in ("fairness", "smoothing"):
            assert float(text) == float(wanted)
        else:
            assert (text or "") == (wanted or ""), name


@pytest.mark.parametrize("function, command", [(knotfit.compare, "compare"), (knotfit.fit_curve, "fit-curve")])
def test_other_calls_have_options_of_their_commands(function, command):
    rows = _options.rows(command)
    own = {"weights", "normals", "nan_policy", "on_miss", "threads", "progress", "time_limit"}
    for name, parameter in inspect.signature(function).parameters.items():
        if name in own or parameter.kind is not parameter.KEYWORD_ONLY:
            continue
        assert name in rows, name
        usual = rows[name]["usual"]
        if usual and parameter.default is not None and name not in ("smoothing", "degree"):
            assert _options.text_of(name, parameter.default, rows[name]) in (usual, None if usual == "off" else usual)


def test_the_defaults_written_out_change_nothing(xyz, uv):
    plain = knotfit.fit(xyz, uv, tol="2%")
    said = knotfit.fit(xyz, uv, tol="2%", **{k: v for k, v in USUAL.items() if k != "tol"})
    assert said.surface == plain.surface and said.options == plain.options


def test_a_fit_repeats_by_its_options(xyz, uv, tmp_path):
    first = knotfit.fit(xyz, uv, tol="3%", rms=True, degree=2, knots="error-model")
    again = knotfit.fit(xyz, uv, options=first.options)
    assert again.surface == first.surface and again.options == first.options
    first.save(tmp_path / "a.json")
    assert knotfit.fit(xyz, uv, options=tmp_path / "a.json").surface == first.surface
    assert knotfit.fit(xyz, uv, options=first.options, degree=4).surface.degree == (4, 4)


def test_what_a_fit_says(xyz, uv):
    fit = knotfit.fit(xyz, uv, tol="1%")
    assert fit.status == "reached" and fit.reached
    assert fit.measured == fit.error.max == fit.errors.max() <= fit.tolerance
    assert fit.errors.shape == (900,) and fit.parameters.shape == (900, 2)
    np.testing.assert_allclose(fit.error.rms, np.sqrt((fit.errors**2).mean()), rtol=1e-12)
    np.testing.assert_allclose(fit.errors, np.linalg.norm(fit.surface(*uv.T) - xyz, axis=1), atol=1e-13)
    assert fit.between is not None and fit.bound >= fit.between
    assert fit.options["tolerance"] == "1%" and isinstance(fit.notes, list)
    assert "control points" in fit.summary() and "reached" in repr(fit)


def test_tolerances_as_numbers_and_texts(xyz, uv):
    relative = knotfit.fit(xyz, uv, tol="1%")
    assert knotfit.fit(xyz, uv, tol=relative.tolerance).surface == relative.surface
    assert knotfit.fit(xyz, uv, tol=np.float64(relative.tolerance)).surface == relative.surface
    assert knotfit.fit(xyz, uv, tol="3%", within="99%").surface == knotfit.fit(xyz, uv, tol="3%", within=0.99).surface


def test_a_missed_tolerance_warns_raises_or_is_ignored(xyz, uv):
    ask = {"tol": 1e-9, "control_points": 5, "knots": "uniform"}
    with pytest.warns(knotfit.KnotfitWarning, match="^not_reached: ") as heard:
        fit = knotfit.fit(xyz, uv, **ask)
    assert heard[0].filename == __file__
    assert heard[0].message.fit is fit and fit.status == "not_reached" and not fit.reached
    with pytest.raises(knotfit.ToleranceMissed) as raised:
        knotfit.fit(xyz, uv, on_miss="raise", **ask)
    assert raised.value.fit.surface == fit.surface
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert knotfit.fit(xyz, uv, on_miss="ignore", **ask).surface == fit.surface
    with pytest.raises(ValueError, match="^on_miss: 'no'"):
        knotfit.fit(xyz, uv, on_miss="no")


def test_a_time_limit_is_a_status_that_warns(xyz):
    rng = np.random.default_rng(2)
    uv = rng.random((20000, 2))
    points = np.column_stack([uv, np.sign(uv[:, 0] - 0.37 * uv[:, 1] - 0.3)])
    with pytest.warns(knotfit.KnotfitWarning, match="^time_limit: "):
        assert knotfit.fit(points, uv, tol="0.01%", time_limit=0.5).status == "time_limit"


@pytest.mark.parametrize("keywords, error, words", [
    ({"tol": "much"}, ValueError, "^tol: "),
    ({"tol": -1}, ValueError, "^tol: "),
    ({"tol": [1]}, TypeError, "^tol: takes a number or a text, not list"),
    ({"tol": True}, TypeError, "^tol: "),
    ({"tol": object()}, TypeError, "^tol: takes a number or a text, not object"),
    ({"within": 99.5}, ValueError, "^within: 99.5 is no share"),
    ({"rms": "yes"}, TypeError, "^rms: takes True or False, not str"),
    ({"control_points": (3, 4, 5)}, ValueError, "^control_points: takes one number or two, not 3"),
    ({"control_points": 2.5}, ValueError, "^control_points: "),
    ({"knots": "best"}, ValueError, "^knots: there is no method 'best'; there are optimal, "),
    ({"knots": 7}, TypeError, "^knots: takes a method's name"),
    ({"knots": ([0.5, 0.2], [])}, ValueError, "^knots_u: "),
    ({"degree": 12}, ValueError, "^degree: "),
    ({"effort": "huge"}, ValueError, "^effort: .*fast, balanced, best"),
    ({"guard": "maybe"}, ValueError, "^guard: "),
    ({"feature": "colour"}, ValueError, "^feature: .*hessian"),
    ({"feature": np.zeros(3)}, ValueError, "^feature: has shape .3,., not"),
    ({"threads": -1}, ValueError, "^threads: -1"),
    ({"threads": 1.5}, TypeError, "^threads: takes a number, not float"),
    ({"progress": 3}, TypeError, "^progress: takes True, False or a callable, not int"),
    ({"nodata": 3}, ValueError, "^nodata: is for files"),
    ({"columns": "x"}, ValueError, "^columns: is for files"),
    ({"spacing": "uniform"}, ValueError, "^spacing does not apply to points with parameters of their own"),
    ({"correct": 3, "weights": np.ones(900)}, ValueError, "^correct knows no weights"),
    ({"options": {"colour": 1}}, ValueError, "colour.* is not an option"),
])
def test_mistakes_name_the_keyword(xyz, uv, keywords, error, words):
    with pytest.raises(error, match=words):
        knotfit.fit(xyz, uv, **keywords)


def test_messages_have_no_words_of_the_command_line(xyz, uv):
    outside = uv.copy()
    outside[7, 1] = 1.5
    with pytest.raises(ValueError, match=r"^row 7: v = 1.5 is outside \[0,1\]; rescale_parameters=True maps"):
        knotfit.fit(xyz, outside)
    twice, places = np.vstack([xyz, xyz[4] + 1]), np.vstack([uv, uv[4]])
    with pytest.raises(ValueError, match="rows 4 and 900 .*duplicates"):
        knotfit.fit(twice, places)
    assert knotfit.fit(twice, places, duplicates="mean", on_miss="ignore").errors.shape == (901,)
    line = np.column_stack([uv[:, 0], uv[:, 0]])
    with pytest.raises(ValueError, match="they lie on one straight line"):
        knotfit.fit(xyz, line)


def test_rows_are_counted_from_0_and_figures_stay():
    from knotfit._errors import in_python_words

    for text, wanted in [("line 4: u = 2", "row 3: u = 2"), ("points 1, 7 and 9", "rows 0, 6 and 8"),
                         ("lines 3, 5 and 12 more", "rows 2, 4 and 12 more"), ("point 8 (line 9) is", "row 8 is"),
                         ("point 3 (from 1)", "row 2"), ("error of 99 % of the points 57.23, tolerance 58",) * 2,
                         ("of the points 57, tolerance",) * 2, ("2000 points, line 12.5",) * 2,
                         ("--nodata 3 and --weld off", 'nodata 3 and weld="off"'), ("a `fill_holes`", "a fill_holes=True")]:
        assert in_python_words(text) == wanted


def test_every_remedy_of_the_library_has_words():
    from knotfit._errors import _REMEDIES

    assert set(_REMEDIES) == set(_core.all_remedies())


def test_knots_of_every_form(xyz, uv, fixed):
    given = knotfit.fit(xyz, uv, knots=fixed.surface, between=False)
    assert given.surface == fixed.surface
    u, v = fixed.surface._interior
    assert knotfit.fit(xyz, uv, knots=(u, v), between=False).surface == fixed.surface
    assert knotfit.fit(xyz, uv, knots=([], []), degree=5).surface.size == (6, 6)
    cubic = knotfit.fit(xyz, uv, control_points=9, degree=2, knots="uniform")
    assert knotfit.fit(xyz, uv, knots=cubic.surface).surface.degree == (2, 2)


def test_your_own_placement(xyz, uv):
    asked = []

    def even(places, values, interior_u, interior_v):
        assert places.shape == (900, 2) and values.shape == (900, 3)
        asked.append((interior_u, interior_v))
        return tuple(np.linspace(0, 1, n + 2)[1:-1] for n in (interior_u, interior_v))

    one = knotfit.fit(xyz, uv, knots=even, control_points=(9, 8), between=False)
    # (k / n) by NumPy and by the library's uniform rule may differ in the last digit.
    np.testing.assert_allclose(one.surface.control_points, knotfit.fit(
        xyz, uv, knots="uniform", control_points=(9, 8)).surface.control_points, atol=1e-9)
    assert asked == [(5, 4)]
    found = knotfit.fit(xyz, uv, knots=even, tol="2%")
    assert found.reached and found.surface.size[0] == found.surface.size[1]
    smaller = found.surface.size[0] - 1
    assert not knotfit.fit(xyz, uv, knots=even, tol="2%", control_points=smaller, on_miss="ignore").reached
    with pytest.raises(ZeroDivisionError):
        knotfit.fit(xyz, uv, knots=lambda *_: 1 / 0, control_points=8)


def test_a_feature_measure_of_your_own(xyz, uv):
    ridge = np.ones((40, 30))
    ridge[30:] = 100
    fit = knotfit.fit(xyz, uv, control_points=12, knots="criterion", feature=ridge)
    assert np.median(fit.surface._interior[0]) > 0.6
    with pytest.raises(ValueError, match=r"cell \(0, 0\) is -1: it must be"):
        knotfit.fit(xyz, uv, control_points=12, knots="criterion", feature=-ridge)


def test_clouds_over_a_base(disk, fixed):
    points = disk[0]
    cloud = knotfit.fit(points, control_points=7, base="plane", correct=5)
    assert cloud.errors.shape == (144,) and cloud.report["correction"]["rounds"] >= 5
    flat = knotfit.fit(points * [1, 1, 0], control_points=4, base="plane", correct=False)
    over = knotfit.fit(points, control_points=7, base=flat.surface, correct=False)
    assert over.options["base"] == "surface" and over.error.max < 0.1


def test_weights_pull(uv):
    z = np.where(uv[:, 0] < 0.5, 0.0, 1.0)
    even = knotfit.fit(z, uv, control_points=5, knots="uniform").errors
    pulled = knotfit.fit(z, uv, control_points=5, knots="uniform", weights=np.where(z > 0, 100.0, 1.0)).errors
    assert pulled[z > 0].mean() < even[z > 0].mean()


def test_height_fields(xyz):
    fit = knotfit.fit(xyz + [100, 200, 0], height_field=True, tol="2%")
    assert fit.surface.height_field
    (a, b), (c, d) = fit.surface.domain
    assert (a, b) == ((xyz[:, 0] + 100).min(), (xyz[:, 0] + 100).max()) and c > 199 and d < 202
    np.testing.assert_allclose(np.abs(fit.surface(xyz[:, 0] + 100, xyz[:, 1] + 200) - xyz[:, 2]), fit.errors, atol=1e-9)
    x, y = xyz[:, 0], xyz[:, 1]
    oblique = np.column_stack([x, y, np.tanh(8 * (x + 0.5 * y - 0.7))])
    sheared = knotfit.fit(oblique, height_field=True, control_points=(20, 4), shear=0.5, knots="uniform")
    assert sheared.surface.shear == (0.5, 0.0)
    np.testing.assert_allclose(np.abs(sheared.surface(x, y) - oblique[:, 2]), sheared.errors, atol=1e-9)
    slope = sheared.surface.derivative(1, 0)(0.5, 0.5)
    step = (sheared.surface(0.5 + 1e-6, 0.5) - sheared.surface(0.5 - 1e-6, 0.5)) / 2e-6
    np.testing.assert_allclose(slope, step, rtol=1e-6)
    with pytest.raises(ValueError, match="^shear: "):
        sheared.surface.to_scipy()


def test_save_and_load_every_format(xyz, uv, tmp_path):
    fit = knotfit.fit(xyz, height_field=True, control_points=9, knots="uniform")
    for name, options in [("a.json", {}), ("a.csv", {}), ("a.asc", {"cell": 0.05}), ("a.png", {"reflections": True}),
                          ("a.svg", {}), ("a.pdf", {}), ("a.obj", {"samples": 2}), ("a.ply", {}), ("a.vts", {}),
                          ("a.step", {"unit": "m", "name": "part"}), ("a.igs", {})]:
        fit.save(tmp_path / name, **options)
        with pytest.raises(knotfit.FileError, match="force=True"):
            fit.save(tmp_path / name, **options)
        fit.save(tmp_path / name, force=True, **options)
        fit.surface.save(tmp_path / ("b" + name), **options)
    assert knotfit.load(tmp_path / "a.json") == fit.surface
    space = knotfit.load(tmp_path / "a.step", unit="m")
    np.testing.assert_allclose(space.control_points, fit.surface.in_space().control_points, atol=1e-9)
    assert knotfit.load(tmp_path / "a.asc").z.shape[1] == 20
    assert knotfit.load(tmp_path / "a.obj").faces.shape[1] == 3
    assert knotfit.load(tmp_path / "a.csv").xyz.shape[0] == 900
    for bad, error, words in [("a.xyz", ValueError, "no output has the extension"), ("no/a.json", ValueError, ""),
                              ("a.json/b.json", ValueError, "")]:
        with pytest.raises(error, match=words):
            fit.save(tmp_path / bad)
    with pytest.raises(ValueError, match="^cell is for .asc or .grd outputs"):
        fit.save(tmp_path / "c.json", cell=3)
    with pytest.raises(ValueError, match="is written, not read"):
        knotfit.load(tmp_path / "a.png")
    with pytest.raises(knotfit.FileError):
        knotfit.load(tmp_path / "missing.json")


def test_fits_are_pickled_and_copied(xyz, uv, tmp_path):
    fit = knotfit.fit(xyz, uv, control_points=7, knots="uniform")
    again = pickle.loads(pickle.dumps(fit))
    assert again.surface == fit.surface and (again.errors == fit.errors).all() and again.report == fit.report
    again.save(tmp_path / "a.json")
    assert again.draw().startswith(b"\x89PNG")
    deep = copy.deepcopy(fit)
    deep.errors[0] = 9
    deep.options["tolerance"] = "9%"
    assert fit.errors[0] != 9 and fit.options["tolerance"] is None
    assert copy.copy(fit).surface is fit.surface


def test_pictures_and_notebooks(xyz, uv):
    fit = knotfit.fit(xyz, uv, tol="2%")
    assert fit.draw("png").startswith(b"\x89PNG") and fit.draw("pdf", width=252).startswith(b"%PDF")
    assert b"<svg" in fit.draw("svg")
    assert b"knotfit.fit(tol=" in fit.draw("svg") or len(fit.draw("svg")) > 1000  # letters may be outlines
    html = fit._repr_html_()
    assert html.count("<table>") == 1 and html.count("<img") == 1 and "reached" in html
    assert fit.surface._repr_html_().count("<table>") == 1
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    assert fit.plot().images and fit.surface.plot().images
    with pytest.raises(ValueError, match="extension"):
        fit.draw("bmp")


def test_rasters_in_every_orientation(samples):
    x, y = np.linspace(3, 5, 25), np.linspace(-1, 1, 20)
    z = np.sin(2 * x) * np.exp(y)[:, None]
    fit = knotfit.fit_raster(z, x, y, tol="1%")
    np.testing.assert_allclose(np.abs(fit.surface(x, y[:, None]) - z), fit.errors, atol=1e-12)
    np.testing.assert_allclose(fit.raster(), fit.surface.grid(x, y).T)
    north = knotfit.fit_raster(z[::-1], x, y[::-1], tol="1%")
    assert north.surface == fit.surface and (north.errors[::-1] == fit.errors).all()
    assert knotfit.fit_raster(z, tol="1%").surface.domain == ((0, 24), (0, 19))
    holed = np.where(z > 2, -9999, z)
    with_nodata = knotfit.fit_raster(holed, x, y, nodata=-9999, tol="1%")
    assert (np.isnan(with_nodata.errors) == (holed == -9999)).all()
    assert np.isnan(with_nodata.raster()).any() and np.isfinite(with_nodata.raster(fill_holes=True)).all()
    masked = np.ma.masked_where(holed == -9999, holed)
    assert knotfit.fit_raster(masked, x, y, tol="1%").surface == with_nodata.surface
    with pytest.raises(ValueError, match=r"cell \[0, 0\] is not finite"):
        knotfit.fit_raster(np.full((4, 4), np.nan), nan_policy="raise")
    with pytest.raises(ValueError, match="x: is not equally spaced"):
        knotfit.fit_raster(z, x**2, y)
    with pytest.raises(ValueError, match="y: has 3 values, the raster 20"):
        knotfit.fit_raster(z, x, y[:3])
    with pytest.raises(TypeError, match="unexpected keyword argument 'tolerance'"):
        knotfit.fit_raster(z, tolerance=1)
    with pytest.raises(ValueError, match="^base does not apply to a raster"):
        knotfit.fit_raster(z, base="plane")
    with pytest.raises(ValueError, match="raster: the fit was not to a raster"):
        knotfit.fit(np.random.default_rng(0).random((99, 3)), height_field=True, control_points=5,
                    knots="uniform").raster()


def test_one_fit_holds_one_tolerance():
    with pytest.raises(ValueError, match="tol: '5%,1%' is several tolerances"):
        knotfit.fit(np.zeros((20, 3)), height_field=True, tol="5%,1%")
