"""SciPy as an outside witness: evaluation, and least squares for given knots.

KNOTFIT is the program. Ends with 77 where this Python has no SciPy (ctest: skipped).
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
    from scipy.interpolate import BSpline, LSQBivariateSpline, bisplev
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

TOOL = os.environ["KNOTFIT"]


def clamped(degree, interior):
    return np.concatenate([np.zeros(degree + 1), interior, np.ones(degree + 1)])


class Witness(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="knotfit-witness-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_tool(self, *arguments):
        done = subprocess.run([TOOL, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def write_surface(self, ku, kv, mu, mv, net):
        (self.folder / "s.json").write_text(json.dumps(
            {"degree": [mu, mv], "knots_u": ku.tolist(), "knots_v": kv.tolist(), "control_points": net.tolist()}))

    def write_table(self, name, **columns):
        table = np.column_stack(list(columns.values()))
        lines = [",".join(columns)] + [",".join(map(repr, map(float, row))) for row in table]
        (self.folder / name).write_text("\n".join(lines) + "\n")

    def evaluate(self, u, v, *options):
        self.write_table("places.csv", u=u, v=v)
        report = json.loads(self.run_tool("eval", "s.json", "--points", "places.csv", "--json", *options))
        return report["columns"], np.array(report["rows"], float)


class Evaluation(Witness):
    def test_values_and_derivatives_against_bspline(self):
        """Tensor products of SciPy's BSpline, knots of any multiplicity, to 1e-12 of the scale."""
        rng = np.random.default_rng(1)
        for mu, mv in [(1, 1), (2, 3), (3, 3), (4, 2), (5, 5), (9, 7)]:
            with self.subTest(degrees=(mu, mv)):
                ku = clamped(mu, np.sort(np.append(rng.random(5), [0.5] * mu)))
                kv = clamped(mv, np.sort(rng.random(4)))
                nu, nv = len(ku) - mu - 1, len(kv) - mv - 1
                net = rng.normal(size=(nu, nv, 3))
                self.write_surface(ku, kv, mu, mv, net)
                u = np.concatenate([rng.random(300), [0, 1, 0, 1, 0.25]])
                v = np.concatenate([rng.random(300), [0, 0, 1, 1, 1]])
                for a, b in [(0, 0), (1, 0), (0, 1), (1, 1)]:
                    _, rows = self.evaluate(u, v, "--derivative", f"{a},{b}")
                    bu = self.basis(ku, mu, u, a)
                    bv = self.basis(kv, mv, v, b)
                    expected = np.einsum("ki,kj,ijd->kd", bu, bv, net)
                    scale = np.einsum("ki,kj,ij->k", abs(bu), abs(bv), abs(net).max(axis=2)).max()
                    np.testing.assert_allclose(rows[:, 5:8], expected, rtol=0, atol=1e-12 * scale)

    @staticmethod
    def basis(knots, degree, x, derivative):
        count = len(knots) - degree - 1
        out = np.empty((len(x), count))
        for i in range(count):
            spline = BSpline(knots, np.eye(count)[i], degree)
            out[:, i] = spline(x, nu=derivative)
        return out

    def test_values_against_bisplev(self):
        rng = np.random.default_rng(2)
        for mu, mv in [(3, 3), (2, 4), (5, 1)]:
            with self.subTest(degrees=(mu, mv)):
                ku, kv = clamped(mu, np.sort(rng.random(6))), clamped(mv, np.sort(rng.random(9)))
                nu, nv = len(ku) - mu - 1, len(kv) - mv - 1
                net = rng.normal(size=(nu, nv, 1))
                self.write_surface(ku, kv, mu, mv, net)
                u, v = rng.random(200), rng.random(200)
                _, rows = self.evaluate(u, v)
                expected = [bisplev(a, b, (ku, kv, net.ravel(), mu, mv)) for a, b in zip(u, v)]
                np.testing.assert_allclose(rows[:, 2], expected, rtol=0, atol=1e-12 * abs(net).max())

    def test_height_field_derivatives_by_the_user_s_coordinates(self):
        """Fitted over [500, 502] x [-3, 1]: the chain rule of the map, against BSpline on those knots."""
        rng = np.random.default_rng(3)
        x = np.concatenate([[500, 502, 500, 502], 500 + 2 * rng.random(400)])
        y = np.concatenate([[-3, -3, 1, 1], -3 + 4 * rng.random(400)])
        self.write_table("heights.csv", x=x, y=y, z=np.sin(3 * x) * np.cos(y))
        self.run_tool("fit", "heights.csv", "--height-field", "--control-points", "8x7", "--between", "off", "-o", "s.json")
        surface = json.loads((self.folder / "s.json").read_text())
        kx, ky = 500 + 2 * np.array(surface["knots_u"]), -3 + 4 * np.array(surface["knots_v"])
        net = np.array(surface["control_points"])[:, :, 0]
        self.write_table("places.csv", x=x[4:100], y=y[4:100])
        report = json.loads(self.run_tool("eval", "s.json", "--points", "places.csv", "--json", "--derivative", "1,1"))
        self.assertEqual(report["columns"], ["x", "y", "z", "z_xy"])
        expected = np.einsum("ki,kj,ij->k", self.basis(kx, 3, x[4:100], 1), self.basis(ky, 3, y[4:100], 1), net)
        np.testing.assert_allclose(np.array(report["rows"])[:, 3], expected, rtol=0, atol=1e-9 * abs(expected).max())


class LeastSquares(Witness):
    def test_control_points_for_given_knots(self):
        """LSQBivariateSpline on random scattered data, to 1e-8 of the largest control point."""
        rng = np.random.default_rng(4)
        for mu, mv, weighted in [(3, 3, False), (3, 3, True), (2, 4, False), (1, 3, False), (5, 5, False)]:
            with self.subTest(degrees=(mu, mv), weighted=weighted):
                n = 4000
                u, v = rng.random(n), rng.random(n)
                u[:4], v[:4] = [0, 0, 1, 1], [0, 1, 0, 1]
                z = np.sin(5 * u) * np.cos(4 * v) + 0.3 * u * v + 0.05 * rng.normal(size=n)
                w = 0.5 + rng.random(n) if weighted else np.ones(n)
                tu, tv = np.sort(0.1 + 0.8 * rng.random(4)), np.array([0.25, 0.4, 0.8])
                self.write_table("points.csv", z=z, u=u, v=v, w=w)
                self.run_tool("fit", "points.csv", "--degree", f"{mu}x{mv}", "--knots-u", ",".join(map(repr, tu.tolist())),
                              "--knots-v", ",".join(map(repr, tv.tolist())), "--between", "off", "-o", "s.json")
                surface = json.loads((self.folder / "s.json").read_text())
                net = np.array(surface["control_points"])[:, :, 0]
                # SciPy minimises sum (w (z - s))^2, knotfit sum w (z - s)^2.
                witness = LSQBivariateSpline(u, v, z, tu, tv, w=np.sqrt(w), bbox=[0, 1, 0, 1], kx=mu, ky=mv, eps=1e-15)
                expected = witness.get_coeffs().reshape(net.shape)
                np.testing.assert_allclose(net, expected, rtol=0, atol=1e-8 * abs(expected).max())
                (self.folder / "s.json").unlink()


if __name__ == "__main__":
    unittest.main(verbosity=2)
