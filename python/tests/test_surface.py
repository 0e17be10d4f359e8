"""Surfaces: values, geometry, knots, other libraries' forms."""

import copy
import importlib.util
import inspect
import pickle

import numpy as np
import pytest
import scipy
from scipy import interpolate

import knotfit

EPS = np.finfo(float).eps


@pytest.fixture(scope="module")
def height(xyz):
    return knotfit.fit(xyz, height_field=True, control_points=(9, 7), degree=(3, 4), knots="uniform").surface


def test_values_are_those_of_bisplev(fixed):
    surface = fixed.surface
    u = v = np.linspace(0, 1, 101)
    tcks = surface.to_scipy().tck
    assert len(tcks) == 3
    grid = surface.grid(u, v)
    for d, tck in enumerate(tcks):
        theirs = interpolate.bisplev(u, v, tck)
        assert np.abs(grid[:, :, d] - theirs).max() <= 1e-14 * np.abs(surface.control_points).max()
    assert np.array_equal(grid, surface(u[:, None], v))


def test_heights_are_those_of_bisplev_in_their_own_coordinates(height):
    (a, b), (c, d) = height.domain
    x, y = np.linspace(a, b, 80), np.linspace(c, d, 60)
    theirs = interpolate.bisplev(x, y, height.to_scipy().tck)
    assert np.abs(height.grid(x, y) - theirs).max() <= 1e-14 * np.abs(height.control_points).max()
    for du, dv in [(1, 0), (0, 1), (2, 1)]:
        theirs = interpolate.bisplev(x, y, height.to_scipy().tck, dx=du, dy=dv)
        ours = height.derivative(du, dv)(x[:, None], y)
        np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-12 * np.abs(theirs).max())


def test_ndbspline_where_it_exists(fixed):
    if not hasattr(interpolate, "NdBSpline"):
        pytest.skip(f"SciPy {scipy.__version__} has no NdBSpline: 1.12 does")
    t, c, k = fixed.surface.to_scipy().nd
    places = np.random.default_rng(0).random((200, 2))
    np.testing.assert_allclose(interpolate.NdBSpline(t, c, k)(places), fixed.surface(*places.T), atol=1e-14)


def test_broadcasting(fixed, height):
    surface = fixed.surface
    assert surface(0.5, 0.5).shape == (3,)
    assert surface([0.1, 0.2], 0.5).shape == (2, 3)
    assert surface(np.zeros((4, 1)), np.zeros(5)).shape == (4, 5, 3)
    assert surface([], []).shape == (0, 3)
    assert height(0.5, 0.5).shape == () and height(np.full((2, 3), 0.5), 0.5).shape == (2, 3)
    assert surface(np.float32(0.5), 1).dtype == np.float64
    with pytest.raises(ValueError, match=r"shapes \(3,\) and \(2,\) do not broadcast"):
        surface([0, 0, 0], [0, 0])
    with pytest.raises(TypeError, match="^u: holds"):
        surface("a", 0)


def test_outside_and_nan(height):
    (a, b), (c, d) = height.domain
    with pytest.raises(ValueError, match="is outside the domain.*outside=.clamp."):
        height(b + 1, c)
    assert height(b + 1, c, outside="clamp") == height(b, c)
    assert np.isnan(height(b + 1, c, outside="nan"))
    assert np.isnan(height(np.nan, c)) and np.isfinite(height([np.nan, a], [c, c])).tolist() == [False, True]
    assert height(np.ma.masked_invalid([np.nan, a]), c).shape == (2,)
    with pytest.raises(ValueError, match="^outside: 'wrap'"):
        height(a, c, outside="wrap")


def test_derivatives_agree_with_differences(fixed):
    surface, h = fixed.surface, 1e-6
    u, v = np.random.default_rng(3).uniform(0.1, 0.9, (2, 50))
    np.testing.assert_allclose(surface.derivative(1, 0)(u, v), (surface(u + h, v) - surface(u - h, v)) / (2 * h),
                               atol=1e-7)
    np.testing.assert_allclose(surface(u, v, dv=1), (surface(u, v + h) - surface(u, v - h)) / (2 * h), atol=1e-7)
    for bad, error in [(-1, ValueError), (1.0, TypeError), (True, TypeError)]:
        with pytest.raises(error, match="^du: "):
            surface.derivative(bad, 0)


def test_normals_and_curvature_of_a_sphere():
    a = np.linspace(-0.6, 0.6, 40)
    x, y = (g.ravel() for g in np.meshgrid(a, a))
    points = np.column_stack([x, y, np.sqrt(4 - x**2 - y**2)])
    surface = knotfit.fit(points, height_field=True, tol="0.001%").surface
    at = np.array([0.1, -0.2]), np.array([0.3, 0.1])
    normals = surface.normals(*at)
    wanted = np.stack([at[0], at[1], np.sqrt(4 - at[0]**2 - at[1]**2)], axis=-1) / 2
    np.testing.assert_allclose(normals, wanted, atol=1e-4)
    bent = surface.curvature(*at)
    np.testing.assert_allclose(np.abs(bent.mean), 0.5, rtol=1e-2)
    np.testing.assert_allclose(bent.gaussian, 0.25, rtol=2e-2)
    assert (bent.k1 >= bent.k2).all() and bent.mean.shape == (2,)
    with pytest.raises(ValueError, match="surface in space or a height field"):
        knotfit.Surface([0, 0, 1, 1], [0, 0, 1, 1], np.zeros((2, 2, 2)), 1).normals(0, 0)


def test_inserted_knots_change_nothing(fixed):
    surface = fixed.surface
    more = surface.insert_knots(u=[0.7, 0.15, 0.15], v=[0.5])
    assert more.size == (surface.size[0] + 3, surface.size[1] + 1)
    u, v = np.random.default_rng(0).random((2, 300))
    # Convex combinations of control points: a rounding a step.
    assert np.abs(more(u, v) - surface(u, v)).max() <= 32 * EPS * np.abs(surface.control_points).max()
    with pytest.raises(ValueError):
        surface.insert_knots(u=[1.5])


def test_closest_points_and_distances(fixed, disk):
    surface = fixed.surface
    found = surface.closest_points([[0.5, 0.5, 2.0], [0.2, 0.2, 0.0]])
    np.testing.assert_allclose(surface(*found.parameters.T), found.points, atol=1e-12)
    assert found.distances.shape == (2,) and surface.closest_points([0.5, 0.5, 2]).points.shape == (1, 3)
    places = np.random.default_rng(0).random((4000, 2))
    for point, distance in zip([[0.5, 0.5, 2.0], [0.2, 0.2, 0.0]], found.distances):
        assert distance <= np.linalg.norm(surface(*places.T) - point, axis=1).min()
    vertices, faces = disk
    both = surface.distance_to(vertices, faces, samples=50)
    np.testing.assert_allclose(np.abs(both.signed), surface.closest_points(vertices).distances, atol=1e-12)
    assert both.to_mesh["count"] > 0 and both.to_surface["max"] == np.abs(both.signed).max()
    assert surface.distance_to(vertices).to_mesh is None
    with pytest.raises(ValueError, match="^points: has shape"):
        surface.closest_points([[1, 2]])


def test_made_of_knots_and_control_points(fixed, height):
    for surface in (fixed.surface, height):
        again = knotfit.Surface(surface.knots_u, surface.knots_v, surface.control_points, surface.degree,
                                domain=surface.domain, height_field=surface.height_field)
        assert again == surface and hash(again) == hash(surface)
    flat = knotfit.Surface([2, 2, 4, 4], [0, 0, 1, 1], [[0, 0], [1, 1]], 1)
    assert flat.domain == ((2, 4), (0, 1)) and flat(3, 0.5) == 0.5
    for knots, net, words in [([0, 0, 1], [[0]], "^knots_u: 3 knots are too few"),
                              ([1, 1, 0, 0], [[0, 0], [1, 1]], "^knots_u: |not be less|less than|decreas|domain"),
                              ([0, 0, 1, 1], [[0, 0]], "control points?|net"),
                              ([0, 0, 1, 1], [0, 0], "^control_points: has shape"),
                              ([0, 0, 1, 1], [[0, np.nan], [0, 0]], "finite")]:
        with pytest.raises(ValueError, match=words):
            knotfit.Surface(knots, [0, 0, 1, 1], net, 1)


def test_equal_copied_pickled(fixed, height):
    assert fixed.surface == fixed.surface and fixed.surface != height and fixed.surface != 3
    for surface in (fixed.surface, height):
        for other in (copy.copy(surface), copy.deepcopy(surface), pickle.loads(pickle.dumps(surface)),
                      knotfit.Surface.from_json(surface.to_json())):
            assert other == surface
    assert fixed.surface.insert_knots(u=[0.3]) != fixed.surface


def test_control_points_are_a_copy(fixed):
    net = fixed.surface.control_points
    net[:] = 7
    assert (fixed.surface.control_points != 7).any()


class Geomdl:
    """What from_geomdl looks at, as geomdl's surfaces have it."""

    def __init__(self, surface, weights=None):
        self.degree_u, self.degree_v = surface.degree
        self.knotvector_u, self.knotvector_v = surface.knots_u.tolist(), surface.knots_v.tolist()
        self.ctrlpts_size_u, self.ctrlpts_size_v = surface.size
        self.ctrlpts = surface.control_points.reshape(-1, 3).tolist()
        self.rational, self.weights = weights is not None, weights


def test_from_geomdl_by_its_attributes(fixed):
    assert knotfit.Surface.from_geomdl(Geomdl(fixed.surface)) == fixed.surface
    assert knotfit.Surface.from_geomdl(Geomdl(fixed.surface, [1, 1])) == fixed.surface
    with pytest.raises(ValueError, match="rational"):
        knotfit.Surface.from_geomdl(Geomdl(fixed.surface, [1, 2]))


def test_geomdl_there_and_back(fixed):
    pytest.importorskip("geomdl", reason="geomdl is not installed")
    theirs = fixed.surface.to_geomdl()
    np.testing.assert_allclose(theirs.evaluate_single((0.3, 0.7)), fixed.surface(0.3, 0.7), atol=1e-12)
    assert knotfit.Surface.from_geomdl(theirs) == fixed.surface


def test_splinepy(fixed):
    pytest.importorskip("splinepy", reason="splinepy is not installed")
    np.testing.assert_allclose(fixed.surface.to_splinepy().evaluate([[0.3, 0.7]])[0], fixed.surface(0.3, 0.7),
                               atol=1e-12)


@pytest.mark.parametrize("name", ["geomdl", "splinepy"])
def test_a_library_that_is_missing_is_an_import_error(name, fixed):
    if importlib.util.find_spec(name):
        pytest.skip(f"{name} is installed")
    with pytest.raises(ImportError, match=name):
        getattr(fixed.surface, f"to_{name}")()


def test_step_text(fixed):
    text = fixed.surface.to_step(unit="m")
    assert text.startswith("ISO-10303-21;") and "B_SPLINE_SURFACE_WITH_KNOTS" in text


def test_every_public_name_says_what_it_takes():
    for name in knotfit.__all__:
        thing = getattr(knotfit, name)
        if inspect.isclass(thing) or inspect.isfunction(thing):
            assert thing.__doc__, name
