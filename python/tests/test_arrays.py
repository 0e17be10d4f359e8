"""What comes in: every layout and kind of array gives what a plain one does."""

import numpy as np
import pytest

import knotfit

FIXED = {"control_points": (7, 7), "knots": "uniform", "between": False}


@pytest.fixture(scope="module")
def plain(xyz, uv):
    return knotfit.fit(xyz, uv, **FIXED)


def layouts(a):
    wide = np.zeros((len(a), 2 * a.shape[1]))
    wide[:, ::2] = a
    read_only = a.copy()
    read_only.setflags(write=False)
    unaligned = np.frombuffer(b"\0" + a.tobytes(), dtype=np.uint8)[1:].view()
    unaligned = np.ndarray(a.shape, np.float64, buffer=b"\0" + a.tobytes(), offset=1)
    return {"fortran": np.asfortranarray(a), "strided": wide[:, ::2], "reversed": a[::-1][::-1],
            "read-only": read_only, "big-endian": a.astype(">f8"), "unaligned": unaligned, "list": a.tolist(),
            "longdouble": a.astype(np.longdouble)}


@pytest.mark.parametrize("layout", ["fortran", "strided", "reversed", "read-only", "big-endian", "unaligned", "list",
                                    "longdouble"])
def test_every_layout_gives_the_same_bits(layout, xyz, uv, plain):
    fit = knotfit.fit(layouts(xyz)[layout], layouts(uv)[layout], **FIXED)
    assert fit.surface == plain.surface
    assert (fit.errors == plain.errors).all()


def test_float32_is_taken_as_its_own_numbers(xyz, uv):
    narrow = knotfit.fit(xyz.astype(np.float32), uv.astype(np.float32), **FIXED)
    same = knotfit.fit(xyz.astype(np.float32).astype(float), uv.astype(np.float32).astype(float), **FIXED)
    assert narrow.surface == same.surface


@pytest.mark.parametrize("dtype", [np.int8, np.uint16, np.int64, bool])
def test_integers_are_taken_as_numbers(dtype, uv):
    z = (np.arange(len(uv)) % 2).astype(dtype)
    whole = knotfit.fit(z, uv, **FIXED)
    assert whole.surface == knotfit.fit(z.astype(float), uv, **FIXED).surface


@pytest.mark.parametrize("bad", [np.array([1 + 2j] * 9), np.array(["a"] * 9), np.array([object()] * 9),
                                 np.array(["2020-01-01"] * 9, "datetime64[D]")])
def test_what_is_no_number_is_a_type_error_that_names_the_keyword(bad):
    with pytest.raises(TypeError, match="^xyz: holds"):
        knotfit.fit(bad, np.zeros((9, 2)))


def test_arrays_are_left_as_they_were(xyz, uv):
    before = xyz.copy(), uv.copy()
    knotfit.fit(xyz, uv, **FIXED)
    assert (xyz == before[0]).all() and (uv == before[1]).all()


def test_nan_rows_are_refused_by_number_or_omitted(xyz, uv, plain):
    holes = np.insert(xyz, [5, 700], np.nan, axis=0)
    places = np.insert(uv, [5, 700], 0.5, axis=0)
    with pytest.raises(ValueError, match=r"^xyz: row 5 is not finite; nan_policy='omit'"):
        knotfit.fit(holes, places, **FIXED)
    fit = knotfit.fit(holes, places, nan_policy="omit", **FIXED)
    assert fit.surface == plain.surface
    assert np.flatnonzero(np.isnan(fit.errors)).tolist() == [5, 701]
    assert (fit.errors[~np.isnan(fit.errors)] == plain.errors).all()
    assert np.isnan(fit.parameters[5]).all()
    with pytest.raises(ValueError, match="nan_policy: 'drop'"):
        knotfit.fit(holes, places, nan_policy="drop")


def test_nan_in_uv_and_weights_count_too(xyz, uv):
    places = uv.copy()
    places[3, 1] = np.nan
    with pytest.raises(ValueError, match="^uv: row 3 is not finite"):
        knotfit.fit(xyz, places, **FIXED)
    weights = np.ones(len(xyz))
    weights[8] = np.nan
    fit = knotfit.fit(xyz, places, weights=weights, nan_policy="omit", **FIXED)
    assert np.flatnonzero(np.isnan(fit.errors)).tolist() == [3, 8]


def test_an_infinite_row_is_refused_under_both_policies(xyz, uv):
    infinite = xyz.copy()
    infinite[11, 2] = np.inf
    for policy in ("raise", "omit"):
        with pytest.raises(ValueError, match="^xyz: row 11 is"):
            knotfit.fit(infinite, uv, nan_policy=policy, **FIXED)


def test_masked_rows_are_holes(xyz, uv, plain):
    masked = np.ma.MaskedArray(np.insert(xyz, 5, 1e9, axis=0), mask=False)
    masked[5, 1] = np.ma.masked
    fit = knotfit.fit(masked, np.insert(uv, 5, 0.5, axis=0), **FIXED)
    assert fit.surface == plain.surface
    assert np.flatnonzero(np.isnan(fit.errors)).tolist() == [5]


def test_masked_rows_may_be_beside_nan_ones(xyz, uv):
    masked = np.ma.MaskedArray(xyz.copy(), mask=False)
    masked[5] = np.ma.masked
    masked.data[5] = np.nan
    assert np.isnan(knotfit.fit(masked, uv, **FIXED).errors[5])


def test_pandas_frames_give_their_columns(xyz, uv, plain):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"v": uv[:, 1], "X": xyz[:, 0], "y": xyz[:, 1], "z": xyz[:, 2], "u": uv[:, 0]})
    assert knotfit.fit(frame, **FIXED).surface == plain.surface
    assert knotfit.fit(pandas.DataFrame(xyz).to_numpy(), pandas.DataFrame(uv), **FIXED).surface == plain.surface
    with pytest.raises(ValueError, match="the data frame has columns a, b"):
        knotfit.fit(pandas.DataFrame({"a": [1.0], "b": [2.0]}))


def test_xarray_rasters_come_back_as_they_were():
    xarray = pytest.importorskip("xarray")
    y, x = np.linspace(46, 47, 21), np.linspace(10, 12, 31)
    z = np.sin(3 * x) + np.cos(5 * y)[:, None]
    z[4, 7] = np.nan
    raster = xarray.DataArray(z, coords={"lat": y, "lon": x}, dims=("lat", "lon"), name="height")
    fit = knotfit.fit_raster(raster, tol="2%")
    again = fit.raster()
    assert isinstance(again, xarray.DataArray) and again.dims == raster.dims
    assert (again.lat == raster.lat).all() and (again.lon == raster.lon).all()
    np.testing.assert_allclose(np.abs(again - raster).values, fit.errors, atol=1e-12)
    assert np.isnan(again.values[4, 7]) and np.isnan(fit.errors[4, 7])
    assert knotfit.fit(raster, tol="2%").surface == fit.surface
    turned = knotfit.fit_raster(raster[::-1, ::-1], tol="2%")
    assert turned.surface == fit.surface
    assert np.array_equal(turned.errors[::-1, ::-1], fit.errors, equal_nan=True)


def test_shapes_are_checked_by_name(xyz, uv):
    for arguments, words in [((xyz[:, :2],), "xyz: has shape .900, 2.: without uv"),
                             ((xyz, uv[:10]), "uv: has 10 rows, xyz has 900"),
                             ((xyz, uv[:, :1]), "uv: has shape .900, 1., not .n, 2."),
                             ((np.zeros((2, 2, 2, 2)),), "xyz: has shape"),
                             ((np.zeros((0, 3)),), "xyz: has shape .0, 3.")]:
        with pytest.raises(ValueError, match=words):
            knotfit.fit(*arguments)
    with pytest.raises(ValueError, match="weights: row 4 is -1.0"):
        knotfit.fit(xyz, uv, weights=np.where(np.arange(len(xyz)) == 4, -1.0, 1.0))


def test_grids_of_points(plain):
    a, b = np.meshgrid(np.linspace(0, 1, 20), np.linspace(0, 2, 15), indexing="ij")
    grid = np.stack([a, b, np.sin(3 * a * b)], axis=2)
    fit = knotfit.fit(grid, tol="1%")
    assert fit.errors.shape == (20, 15) and fit.parameters.shape == (20, 15, 2)
    holed = np.ma.MaskedArray(grid.copy(), mask=False)
    holed[3, 4, 0] = np.ma.masked
    assert np.argwhere(np.isnan(knotfit.fit(holed, tol="1%").errors)).tolist() == [[3, 4]]
    lost = grid.copy()
    lost[3, 4, 1] = np.nan
    with pytest.raises(ValueError, match=r"point \[3, 4\] is not finite"):
        knotfit.fit(lost)
    assert np.isnan(knotfit.fit(lost, tol="1%", nan_policy="omit").errors[3, 4])


def test_any_dimension_at_given_parameters(uv):
    values = np.column_stack([np.sin(k * uv[:, 0] + uv[:, 1]) for k in range(1, 6)])
    fit = knotfit.fit(values, uv, control_points=8, knots="uniform")
    assert fit.surface.dimension == 5 and fit.surface.control_points.shape == (8, 8, 5)
    np.testing.assert_allclose(np.linalg.norm(fit.surface(*uv.T) - values, axis=1), fit.errors, atol=1e-12)
