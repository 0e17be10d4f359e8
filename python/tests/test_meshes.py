"""Meshes, parameters, placement, comparison."""

import types

import numpy as np
import pytest

import knotfit


def test_meshes_of_every_manner(disk):
    vertices, faces = disk
    keywords = {"control_points": 7, "knots": "uniform", "correct": 2}
    plain = knotfit.fit_mesh(vertices, faces, **keywords)
    flat = np.column_stack([np.full(len(faces), 3), faces]).ravel()
    for thing in (types.SimpleNamespace(vertices=vertices, faces=faces),
                  types.SimpleNamespace(points=vertices, faces=flat),
                  types.SimpleNamespace(points=vertices, cells={"triangle": faces}),
                  types.SimpleNamespace(points=vertices,
                                        cells=[types.SimpleNamespace(type="triangle", data=faces[:50]),
                                               types.SimpleNamespace(type="line", data=faces[:2, :2]),
                                               types.SimpleNamespace(type="triangle", data=faces[50:])])):
        assert knotfit.fit_mesh(thing, **keywords).surface == plain.surface
    assert knotfit.fit_mesh(np.asfortranarray(vertices), faces.astype(np.uint64), **keywords).surface == plain.surface
    assert plain.errors.shape == (144,) and np.isfinite(plain.errors).all()
    np.testing.assert_allclose(plain.surface.closest_points(vertices).distances, plain.errors, atol=1e-12)


def test_quadrilaterals_are_two_triangles():
    n = 6
    k = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    quads = np.column_stack([k, k + n, k + n + 1, k + 1])
    a, b = (g.ravel() for g in np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n), indexing="ij"))
    fit = knotfit.fit_mesh(np.column_stack([a, b, a * b]), quads, control_points=4)
    assert fit.report["input"]["mesh"]["triangles"] == 50


def test_mistakes_of_meshes(disk):
    vertices, faces = disk
    for arguments, error, words in [((vertices,), TypeError, "^faces: is missing, and ndarray has neither"),
                                    ((vertices, faces + 1), ValueError, "^faces: row .* names vertex 144, of 144"),
                                    ((vertices, faces[:, :2]), ValueError, "^faces: has shape"),
                                    ((vertices, faces + 0.5), TypeError, "^faces: holds float64"),
                                    ((vertices[:, :2], faces), ValueError, "^vertices: has shape"),
                                    ((np.where(vertices == vertices[9], np.nan, vertices), faces), ValueError,
                                     "^vertices: row ")]:
        with pytest.raises(error, match=words):
            knotfit.fit_mesh(*arguments)
    with pytest.raises(ValueError, match="fill_holes=True"):
        knotfit.fit_mesh(vertices, np.delete(faces, [60], axis=0))
    assert knotfit.fit_mesh(vertices, np.delete(faces, [60], axis=0), fill_holes=True, control_points=6,
                            correct=False).report["input"]["mesh"]["filled_holes"] == 1
    with pytest.raises(TypeError, match="unexpected keyword argument 'colour'"):
        knotfit.fit_mesh(vertices, faces, colour=1)


def test_corners_by_number_and_place(disk):
    vertices, faces = disk
    numbers = [0, 132, 143, 11]
    by_number = knotfit.parameterize(vertices, faces, corners=numbers)
    assert (by_number.uv[numbers] == [[0, 0], [1, 0], [1, 1], [0, 1]]).all()
    by_place = knotfit.parameterize(vertices, faces, corners=vertices[numbers])
    assert (by_place.uv == by_number.uv).all()


def test_parameters_of_meshes_and_clouds(disk):
    vertices, faces = disk
    mapped = knotfit.parameterize(vertices, faces)
    assert mapped.uv.shape == (144, 2) and mapped.uv.min() == 0 and mapped.uv.max() == 1
    assert mapped.report["map"]["flipped"] == 0 and mapped.report["map"]["stretch"] >= 1
    cloud = knotfit.parameterize(vertices, base="plane")
    assert cloud.uv.shape == (144, 2) and cloud.report["base"] == "plane"
    with pytest.raises(TypeError, match="unexpected keyword argument 'tol'"):
        knotfit.parameterize(vertices, faces, tol=1)


def test_parameters_of_a_mesh_are_used(disk):
    vertices, faces = disk
    own = vertices[:, :2]
    fit = knotfit.fit_mesh(vertices, faces, own, control_points=7, knots="uniform")
    assert np.array_equal(fit.parameters, own)
    assert fit.surface == knotfit.fit(vertices, own, control_points=7, knots="uniform").surface


def test_knots_for_scipy(xyz, uv):
    from scipy.interpolate import LSQBivariateSpline

    knots = knotfit.place_knots(xyz, uv, control_points=(10, 8))
    assert knots.u.shape == (6,) and knots.v.shape == (4,) and (np.diff(knots.u) > 0).all()
    theirs = LSQBivariateSpline(*uv.T, xyz[:, 2], knots.u, knots.v, bbox=[0, 1, 0, 1])
    fit = knotfit.fit(xyz[:, 2], uv, knots=(knots.u, knots.v))
    np.testing.assert_allclose(theirs(*uv.T, grid=False), fit.surface(*uv.T), atol=1e-4)
    assert {"optimal", "error-model", "uniform"} <= {m["name"] for m in knotfit.methods()}
    with pytest.raises(ValueError, match="there are optimal, "):
        knotfit.place_knots(xyz, uv, method="best")
    with pytest.raises(ValueError, match="^control_points: 3 is fewer"):
        knotfit.place_knots(xyz, uv, control_points=3)


def test_comparison_is_a_table(xyz, uv, tmp_path):
    table = knotfit.compare(xyz, uv, methods=["uniform", "error-model"], sizes=[7, (8, 9)], tolerances="5%")
    assert [row["asked"] for row in table] == ["7x7", "7x7", "8x9", "8x9", "5%", "5%"]
    same = knotfit.fit(xyz, uv, control_points=7, knots="uniform")
    assert table[0]["rms"] == same.error.rms and table.surface(0) == same.surface
    assert table.draw("pdf", width=252).startswith(b"%PDF") and table.draw("png", asked="8x9").startswith(b"\x89PNG")
    with pytest.raises(ValueError, match="^asked: no surface"):
        table.draw(asked="3x3")
    table.save(tmp_path / "report")
    assert (tmp_path / "report" / "table.csv").read_text().count("\n") == 7
    assert table._repr_html_().count("<tr>") == 7
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(table)
    assert frame.shape[0] == 6 and (frame.rms > 0).all() and frame.equals(table.to_dataframe())


def test_comparison_mistakes(xyz, uv):
    with pytest.raises(ValueError, match="size|tolerance"):
        knotfit.compare(xyz, uv)
    with pytest.raises(ValueError, match="unknown|no method|there are"):
        knotfit.compare(xyz, uv, methods="best", sizes=8)
    with pytest.raises(ValueError, match="^degree: "):
        knotfit.compare(xyz, uv, degree=12, sizes=8)
