"""Swings, boxes and feet on surfaces whose answer is known."""

import os
import unittest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

import box
import feet
import swings
from splines import Curve, Surface

swings.PLACES = 60_000  # enough for what is tested, in less time


def clamped(degree, interior):
    return np.concatenate([np.zeros(degree + 1), interior, np.ones(degree + 1)])


def sheet(spans=40, dimension=3):
    """u, v, 0 as a surface of so many spans: control points at the Greville abscissae."""
    knots = clamped(3, np.arange(1, spans) / spans)
    g = np.array([knots[i + 1:i + 4].mean() for i in range(spans + 3)])
    net = np.stack(np.broadcast_arrays(g[:, None], g, 0.0), axis=2)
    return Surface((3, 3), knots, knots, net if dimension == 3 else net[:, :, 2:])


SPANS = 200
CENTRE = np.array([0.5, 0.3])
PEAK = (2 / 3) ** 2  # of one control point of height 1, in the middle of its support


def with_needle(height):
    """The sheet with one control point lifted: 0.02 wide, about as far as 2 000 random points are apart."""
    s = sheet(SPANS)
    s.net[tuple(np.rint(CENTRE * SPANS).astype(int) + 1)][2] = height
    return s


def measured(surface, uv, floor, noise=0.0):
    values = sheet()(*uv.T)
    values[:, 2] += noise * np.random.default_rng(5).standard_normal(len(uv))
    errors = np.linalg.norm(surface(*uv.T) - values, axis=1)
    return swings.of_surface(surface, uv, values, errors, floor)


class SwingsOfSurfaces(unittest.TestCase):
    def setUp(self):
        self.uv = np.random.default_rng(1).random((2000, 2))

    def test_a_plane_has_none(self):
        s = measured(sheet(), self.uv, 1e-3)
        self.assertLess(s.largest, 1e-9)  # inside a triangle of data a plane cannot leave their box
        self.assertEqual(s.share_above_3, 0)
        self.assertGreater(s.places, 50_000)

    def away_from_the_needle(self):
        return self.uv[np.abs(self.uv - CENTRE).max(axis=1) > 2 / SPANS]

    def test_a_needle_between_the_points_is_found_at_its_place_and_height(self):
        s = measured(with_needle(1), self.away_from_the_needle(), 1e-3)
        np.testing.assert_allclose(s.where, CENTRE, atol=1 / SPANS)
        self.assertLessEqual(s.largest, PEAK / 1e-3 * (1 + 1e-9))
        self.assertGreater(s.largest, 0.5 * PEAK / 1e-3)
        self.assertAlmostEqual(s.excess, s.largest * 1e-3)
        # The support is 1 / 2 500 of the square, and its rim is low.
        self.assertTrue(1e-4 < s.share_above_3 < 4e-4, s.share_above_3)

    def test_a_needle_that_a_point_sees_is_an_error_and_no_swing(self):
        seen = np.concatenate([self.away_from_the_needle(), [CENTRE]])
        self.assertLess(measured(with_needle(1), seen, 1e-3).largest, 1 + 1e-9)

    def test_its_length_is_the_tolerance(self):
        uv = self.away_from_the_needle()
        fine, coarse = measured(with_needle(0.01), uv, 1e-5), measured(with_needle(0.01), uv, 1e-3)
        self.assertAlmostEqual(fine.largest, 100 * coarse.largest)
        self.assertLess(coarse.largest, 10 * PEAK)

    def test_a_hole_of_the_data_is_not_between_near_points(self):
        uv = self.uv[np.linalg.norm(self.uv - CENTRE, axis=1) > 0.25]
        self.assertLess(measured(with_needle(5), uv, 1e-3).largest, 1e-6)

    def test_repeated_parameters_are_one_place_with_all_its_values(self):
        twice = np.concatenate([self.uv, self.uv])
        a, b = measured(sheet(), twice, 1e-3, 0.01), measured(sheet(), self.uv, 1e-3, 0.01)
        self.assertEqual(a.places, b.places)
        self.assertLess(a.largest, 1)

    def test_points_on_a_line_or_too_few_have_no_places(self):
        line = np.stack([np.linspace(0, 1, 50), np.linspace(0, 1, 50)], axis=1)
        self.assertEqual(measured(sheet(), line, 1e-3).places, 0)
        self.assertEqual(measured(sheet(), self.uv[:3], 1e-3).places, 0)

    def test_the_same_twice(self):
        self.assertEqual(measured(with_needle(1), self.uv, 1e-3), measured(with_needle(1), self.uv, 1e-3))

    def test_an_exact_surface_without_a_tolerance_does_not_divide_by_nothing(self):
        self.assertLess(measured(sheet(), self.uv, 0.0).largest, 1)

    def test_small_triangles_have_edges_of_three_least_spacings(self):
        columns, rows = np.meshgrid(np.arange(30) / 29, np.arange(30) / 29)
        grid = np.stack([columns.ravel(), rows.ravel()], axis=1)
        self.assertEqual(len(swings.small_triangles(grid, swings.cKDTree(grid))), 2 * 29 * 29)
        apart = grid * [1, 13]  # rows 13 times as far apart as their points: the 4th nearest is 4 along at most
        self.assertEqual(len(swings.small_triangles(apart, swings.cKDTree(apart))), 0)


class SwingsOfCurves(unittest.TestCase):
    def line(self, spans=30):
        knots = clamped(3, np.arange(1, spans) / spans)
        g = np.array([knots[i + 1:i + 4].mean() for i in range(spans + 3)])
        return Curve(3, knots, np.stack([g, 0 * g], axis=1))

    def measured(self, curve, t, floor):
        values = self.line()(t)
        return swings.of_curve(curve, t, values, np.linalg.norm(curve(t) - values, axis=1), floor)

    def test_a_line_has_none_and_a_needle_is_found(self):
        t = np.linspace(0, 1, 41)
        self.assertLess(self.measured(self.line(), t, 1e-3).largest, 1e-9)
        needle = self.line(400)
        needle.net[206, 1] = 1  # between 203/400 and 207/400, the middle of the gap from 20/40 to 21/40
        s = self.measured(needle, t, 1e-3)
        self.assertTrue(600 < s.largest <= 1000 * 2 / 3 + 1e-9, s)
        np.testing.assert_allclose(s.where, 205 / 400, atol=1 / 400)

    def test_a_long_gap_is_a_hole(self):
        needle = self.line(400)
        needle.net[206, 1] = 1
        t = np.linspace(0, 1, 41)
        self.assertLess(self.measured(needle, t[np.abs(t - 0.5) > 0.11], 1e-3).largest, 1e-9)


class Boxes(unittest.TestCase):
    def test_how_far_the_surface_leaves_the_box(self):
        values = sheet()(*np.random.default_rng(1).random((2, 5000)))
        values = np.concatenate([values, [[0, 0, 0], [1, 1, 0]]])
        self.assertLess(box.of_surface(sheet(), values), 1e-15)
        # The middle of a lone control point's support is a break.
        self.assertAlmostEqual(box.of_surface(with_needle(-3), values), 3 * (2 / 3) ** 2, places=12)

    def test_the_diagonal_of_heights_is_their_range(self):
        self.assertEqual(box.diagonal(np.array([[1.0], [5.0], [3.0]])), 4)
        self.assertEqual(box.diagonal(np.array([[0.0, 0, 0], [3, 4, 12]])), 13)


class Feet(unittest.TestCase):
    def test_distances_to_a_bent_sheet(self):
        # z = x^2 as an exact quadratic patch; points above it along its normal.
        knots = clamped(2, [])
        net = np.stack(np.broadcast_arrays(np.array([0, 0.5, 1])[:, None], np.array([0, 0.5, 1]),
                                           np.array([0, 0, 1])[:, None]), axis=2).astype(float)
        s = Surface((2, 2), knots, knots, net)
        u, v = np.random.default_rng(2).uniform(0.2, 0.8, (2, 200))
        normal = np.stack([-2 * u, 0 * u, 1 + 0 * u], axis=1)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        points = s(u, v) + 0.1 * normal  # nearer than the least radius of curvature, 0.5
        starts = np.clip(np.stack([u, v], axis=1) + 0.2, 0, 1)
        np.testing.assert_allclose(feet.distances(s, points, starts, np.full(200, 0.1)), 0.1, atol=1e-9)

    def test_of_two_sheets_that_lie_close_the_nearer_one_is_found(self):
        # A strip folded back over itself at a distance of 1e-3, its samples 5e-3 apart.
        knots, n = clamped(1, np.arange(1, 20) / 20), 21
        along = np.concatenate([np.linspace(0, 2, 11), np.linspace(2, 0, 11)[1:]])
        net = np.zeros((n, 2, 3))
        net[:, :, 0], net[:, 1, 1], net[11:, :, 2] = along[:, None], 2, 1e-3
        s = Surface((1, 1), knots, clamped(1, []), net)
        points = np.array([[0.7177, 0.5, 1.1e-3], [1.1234, 1.5, 1.1e-3]])
        lower = np.stack([points[:, 0] / 4, points[:, 1] / 2], axis=1)
        np.testing.assert_allclose(feet.distances(s, points, lower, np.full(2, 1e-4)), 1e-4, atol=1e-9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
