"""Evaluation against exact values and against SciPy."""

import os
import unittest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np
from scipy.interpolate import BSpline

from splines import Curve, Map, Surface, basis, basis_matrix


def clamped(degree, interior):
    return np.concatenate([np.zeros(degree + 1), interior, np.ones(degree + 1)])


def random_surface(rng, degrees=(3, 2), dimension=3):
    knots = [clamped(d, np.sort(rng.random(5))) for d in degrees]
    return Surface(degrees, *knots, rng.standard_normal([len(k) - d - 1 for k, d in zip(knots, degrees)] + [dimension]))


class Basis(unittest.TestCase):
    def test_bernstein_polynomials_where_there_are_no_knots(self):
        t = np.array([0, 0.25, 1])
        first, values = basis(clamped(2, []), 2, t)
        np.testing.assert_array_equal(first, 0)
        np.testing.assert_allclose(values, np.stack([(1 - t) ** 2, 2 * t * (1 - t), t ** 2], axis=1), atol=1e-16)

    def test_sums_to_1_and_is_not_negative_with_knots_of_any_multiplicity(self):
        rng = np.random.default_rng(1)
        for degree in range(10):
            knots = clamped(degree, np.sort(np.append(rng.random(4), [0.5] * degree)))
            t = np.concatenate([rng.random(100), knots[degree:-degree or None]])
            values = basis(knots, degree, t)[1]
            self.assertGreaterEqual(values.min(), 0)
            np.testing.assert_allclose(values.sum(axis=1), 1, atol=1e-14)

    def test_against_scipy(self):
        rng = np.random.default_rng(2)
        for degree in (1, 3, 9):
            knots = clamped(degree, np.sort(rng.random(6)))
            t = rng.random(50)
            design = BSpline.design_matrix(t, knots, degree).toarray()
            np.testing.assert_allclose(basis_matrix(knots, degree, t), design, atol=1e-13)


class Surfaces(unittest.TestCase):
    def test_a_net_on_a_plane_gives_the_plane(self):
        # Greville abscissae reproduce u and v themselves.
        ku, kv = clamped(3, [0.2, 0.7]), clamped(2, [0.4])
        gu = np.array([ku[i + 1:i + 4].mean() for i in range(6)])
        gv = np.array([kv[j + 1:j + 3].mean() for j in range(4)])
        net = np.stack(np.broadcast_arrays(gu[:, None], gv, 2 * gu[:, None] - gv + 5), axis=2)
        u, v = np.random.default_rng(3).random((2, 100))
        np.testing.assert_allclose(Surface((3, 2), ku, kv, net)(u, v), np.stack([u, v, 2 * u - v + 5], 1), atol=1e-14)

    def test_corners_are_control_points(self):
        s = random_surface(np.random.default_rng(4))
        np.testing.assert_allclose(s([0, 1, 0, 1], [0, 0, 1, 1]), s.net[[0, -1, 0, -1], [0, 0, -1, -1]], atol=1e-15)

    def test_a_grid_has_the_values_of_its_places(self):
        s = random_surface(np.random.default_rng(5))
        u, v = np.linspace(0, 1, 7), np.linspace(0, 1, 9)
        a, b = np.meshgrid(u, v, indexing="ij")
        np.testing.assert_allclose(s.on_grid(u, v).reshape(-1, 3), s(a.ravel(), b.ravel()), atol=1e-14)

    def test_derivatives_against_differences(self):
        s = random_surface(np.random.default_rng(6))
        u, v = np.random.default_rng(7).uniform(0.01, 0.99, (2, 60))
        h = 1e-6
        for axis in (0, 1):
            du, dv = (h, 0) if axis == 0 else (0, h)
            central = (s(u + du, v + dv) - s(u - du, v - dv)) / (2 * h)
            # A second derivative jumps at a knot of the quadratic direction: h times the jump there.
            np.testing.assert_allclose(s.derivative(axis)(u, v), central, atol=2e-3)

    def test_a_curve_against_scipy(self):
        rng = np.random.default_rng(8)
        knots, net, t = clamped(3, np.sort(rng.random(5))), rng.random((9, 2)), rng.random(40)
        np.testing.assert_allclose(Curve(3, knots, net)(t), BSpline(knots, net, 3)(t), atol=1e-14)


class Maps(unittest.TestCase):
    def test_the_users_parameters_come_to_0_and_1(self):
        m = Map({"u0": -1.5, "u1": 2, "v0": 10, "v1": 20})
        np.testing.assert_allclose(m.own([[-1.5, 10], [2, 20], [0.25, 15]]), [[0, 0], [1, 1], [0.5, 0.5]])

    def test_one_outside_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "outside"):
            Map(None).own([[0.5, 1.1]])


if __name__ == "__main__":
    unittest.main(verbosity=2)
