"""`knotfit eval`: values, derivatives and differences, in the user's own coordinates."""

import json
import math
import unittest

from harness import ToolTest, scattered, wave


def cubic(u, v):
    """In every spline space of degree 3: a fit reproduces it."""
    return 1 + 2 * u - 3 * v * v + u * u * u - u * v * v


class Eval(ToolTest):
    def setUp(self):
        super().setUp()
        # x = 2u, y = 3v, z = cubic(u, v) over [0,1]^2.
        self.write_points(f=cubic)
        self.run_tool("fit", "points.csv", "--knots-u", "0.4", "--knots-v", "none", "-o", "space.json")
        # The same heights over x in [10, 20], y in [-1, 3].
        corners = [(0, 0), (1, 1)] + scattered(300, 5)
        lines = [f"{10 + 10 * u!r} {-1 + 4 * v!r} {cubic(u, v)!r}" for u, v in corners]
        self.write("heights.xyz", "\n".join(lines) + "\n")
        self.run_tool("fit", "heights.xyz", "--height-field", "--control-points", "4x4", "-o", "height.json")

    def rows(self, *arguments):
        return self.read_csv(self.run_tool("eval", *arguments).stdout)

    def test_values_at_parameters(self):
        rows = self.rows("space.json", "--at", "0.25,0.5", "--at", "1,0", "--at", "0,1")
        self.assertEqual(list(rows[0]), ["u", "v", "x", "y", "z"])
        for row in rows:
            self.assertAlmostEqual(row["x"], 2 * row["u"], 10)
            self.assertAlmostEqual(row["y"], 3 * row["v"], 10)
            self.assertAlmostEqual(row["z"], cubic(row["u"], row["v"]), 10)

    def test_values_and_derivatives_of_a_height_field_by_x_and_y(self):
        rows = self.rows("height.json", "--at", "12.5,1", "--derivatives", "2")
        self.assertEqual(list(rows[0]), ["x", "y", "z", "z_x", "z_y", "z_xx", "z_xy", "z_yy"])
        u, v = 0.25, 0.5
        row = rows[0]
        self.assertAlmostEqual(row["z"], cubic(u, v), 9)
        self.assertAlmostEqual(row["z_x"], (2 + 3 * u * u - v * v) / 10, 8)  # by the chain rule
        self.assertAlmostEqual(row["z_y"], (-6 * v - 2 * u * v) / 4, 8)
        self.assertAlmostEqual(row["z_xx"], 6 * u / 100, 8)
        self.assertAlmostEqual(row["z_xy"], -2 * v / 40, 8)
        self.assertAlmostEqual(row["z_yy"], (-6 - 2 * u) / 16, 8)

    def test_single_derivatives(self):
        rows = self.rows("space.json", "--at", "0.5,0.5", "--derivative", "1,0", "--derivative", "0,2", "--derivative",
                         "4,0")
        self.assertEqual(list(rows[0])[5:], ["x_u", "y_u", "z_u", "x_vv", "y_vv", "z_vv", "x_uuuu", "y_uuuu", "z_uuuu"])
        self.assertAlmostEqual(rows[0]["x_u"], 2, 9)
        self.assertAlmostEqual(rows[0]["z_vv"], -7, 7)
        self.assertEqual(rows[0]["z_uuuu"], 0)

    def test_normals_and_curvatures(self):
        rows = self.rows("height.json", "--at", "12.5,1", "--normals", "--curvature", "--derivatives", "2")
        row = rows[0]
        p, q, r, s, t = (row[n] for n in ("z_x", "z_y", "z_xx", "z_xy", "z_yy"))
        w = math.sqrt(1 + p * p + q * q)
        self.assertAlmostEqual(row["nx"], -p / w, 10)
        self.assertAlmostEqual(row["ny"], -q / w, 10)
        self.assertAlmostEqual(row["nz"], 1 / w, 10)
        self.assertAlmostEqual(row["gaussian_curvature"], (r * t - s * s) / w**4, 8)
        self.assertAlmostEqual(row["mean_curvature"], ((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * w**3), 8)
        self.assertAlmostEqual(row["k1"] * row["k2"], row["gaussian_curvature"], 10)

    def test_a_grid_reaches_the_borders(self):
        rows = self.rows("height.json", "--grid", "3x5")
        self.assertEqual(len(rows), 15)
        self.assertEqual([(r["x"], r["y"]) for r in rows[:5]], [(10, -1), (10, 0), (10, 1), (10, 2), (10, 3)])
        self.assertEqual((rows[-1]["x"], rows[-1]["y"]), (20, 3))

    def test_places_outside_are_an_error_that_names_them(self):
        self.refused("eval", "space.json", "--at", "0.5,0.5", "--at", "1.25,0.5", words=["1.25,0.5", "--clamp", "[0, 1]"])
        self.refused("eval", "height.json", "--at", "0.5,0.5", words=["0.5,0.5", "x in [10, 20]"])
        self.write("places.csv", "x,y\n12,0\n# a comment\n12,9\n")
        self.refused("eval", "height.json", "--points", "places.csv", words=["places.csv:4", "12,9"])
        rows = self.rows("height.json", "--points", "places.csv", "--clamp")
        self.assertAlmostEqual(rows[1]["z"], cubic(0.2, 1), 9)

    def test_places_of_a_file(self):
        for text in ("u,v\n0.25,0.5\n1,1\n", "0.25 0.5\n1 1\n", "v;name;u\n0.5;7;0.25\n1;7;1\n"):
            with self.subTest(text=text):
                self.write("places.csv", text)
                rows = self.rows("space.json", "--points", "places.csv")
                self.assertEqual([(r["u"], r["v"]) for r in rows], [(0.25, 0.5), (1, 1)])
                self.assertAlmostEqual(rows[0]["z"], cubic(0.25, 0.5), 10)
        self.write("places.csv", "0.5,9,0.25\n")
        rows = self.rows("space.json", "--points", "places.csv", "--columns", "v,-,u")
        self.assertEqual((rows[0]["u"], rows[0]["v"]), (0.25, 0.5))

    def test_places_of_a_bad_file_are_refused_by_line(self):
        for text, words in [("u,v\n0.5,abc\n", [":2:", "abc"]), ("u,v\n0.5,0.5\n0.5\n", [":3:", "columns"]),
                            ("u,v\n0.5,nan\n", [":2:", "finite"]), ("x,y\n1,2\n", ["u, v"]), ("u,v\n", ["no places"]),
                            ("", ["empty"])]:
            with self.subTest(text=text):
                self.write("places.csv", text)
                self.refused("eval", "space.json", "--points", "places.csv", words=["places.csv", *words])
        self.refused("eval", "space.json", "--points", "missing.csv", words=["missing.csv"])

    def test_check_points_give_the_differences(self):
        lines = ["x,y,z,u,v"] + [f"{2 * u!r},{3 * v!r},{cubic(u, v) + 0.5!r},{u!r},{v!r}" for u, v in scattered(50, 9)]
        self.write("check.csv", "\n".join(lines) + "\n")
        done = self.run_tool("eval", "space.json", "--points", "check.csv")
        rows = self.read_csv(done.stdout)
        self.assertEqual(list(rows[0]), ["u", "v", "x", "y", "z", "x_given", "y_given", "z_given", "error"])
        for row in rows:
            self.assertAlmostEqual(row["error"], 0.5, 8)
        self.assertRegex(done.stdout, r"(?m)^# 50 points: difference rms 0\.5, max 0\.5.* at line \d+")
        report = json.loads(self.run_tool("eval", "space.json", "--points", "check.csv", "--json").stdout)
        self.assertAlmostEqual(report["differences"]["rms"], 0.5, 8)
        self.assertEqual(report["differences"]["points"], 50)
        self.assertEqual(len(report["rows"]), 50)
        self.assertEqual(report["columns"], list(rows[0]))

    def test_heights_give_signed_differences_also_from_a_raster(self):
        self.write("check.csv", "x,y,z\n" + "".join(f"{10 + 10 * u!r},{-1 + 4 * v!r},{cubic(u, v) + 2!r}\n"
                                                   for u, v in scattered(20, 3)))
        for row in self.rows("height.json", "--points", "check.csv"):
            self.assertAlmostEqual(row["difference"], -2, 8)
        cells = "\n".join(" ".join("9" for _ in range(4)) for _ in range(3)) + "\n"
        self.write("check.asc", "ncols 4\nnrows 3\nxllcorner 11\nyllcorner 0\ncellsize 1\nNODATA_value -1\n" + cells)
        rows = self.rows("height.json", "--points", "check.asc")
        self.assertEqual(len(rows), 12)
        self.assertEqual((rows[0]["x"], rows[0]["y"]), (11.5, 2.5))
        self.assertAlmostEqual(rows[0]["difference"], cubic(0.15, 3.5 / 4) - 9, 8)
        self.refused("eval", "space.json", "--points", "check.asc", words=["height field"])

    def test_a_file_holds_what_is_printed(self):
        printed = self.run_tool("eval", "space.json", "--grid", "7x9").stdout
        done = self.run_tool("eval", "space.json", "--grid", "7x9", "-o", "grid.csv")
        self.assertEqual((self.folder / "grid.csv").read_text(), printed)
        self.assertEqual(done.stdout, "wrote grid.csv\n")
        self.refused("eval", "space.json", "--grid", "7x9", "-o", "grid.csv", words=["--force"])
        self.refused("eval", "space.json", "--grid", "7x9", "-o", "grid.png", words=["grid.png", "convert"])

    def test_the_residuals_of_a_fit_come_back(self):
        self.write_points("wave.csv", f=wave)
        report = self.run_json("fit", "wave.csv", "--tol", "1%", "-o", "wave.json", "-o", "residuals.csv")
        again = json.loads(self.run_tool("eval", "wave.json", "--points", "residuals.csv", "--json").stdout)
        self.assertAlmostEqual(again["differences"]["max"], report["error"]["max"], 13)
        self.assertAlmostEqual(again["differences"]["rms"], report["error"]["rms"], 13)

    def test_the_same_bits_for_any_number_of_threads(self):
        outputs = {self.run_tool("eval", "space.json", "--grid", "150x90", "--derivatives", "1", "--threads", t).stdout
                   for t in (1, 2)}
        self.assertEqual(len(outputs), 1)

    def test_usage(self):
        self.refused("eval", "space.json", words=["--at", "--points", "--grid"])
        self.refused("eval", "space.json", "--at", "1", words=["--at", "0.25,0.5"])
        self.refused("eval", "space.json", "--at", "1,2", "--grid", "3x3", words=["--grid"])
        self.refused("eval", "space.json", "--grid", "1x3", words=["--grid"])
        self.refused("eval", "space.json", "--at", "0,0", "--derivative", "1", words=["--derivative"])
        self.refused("eval", "space.json", "--at", "0,0", "--derivatives", "-1", words=["--derivatives"])
        self.refused("eval", "points.csv", "--at", "0,0", words=["points.csv"])
        self.refused("eval", "missing.json", "--at", "0,0", words=["missing.json"])

    def test_negative_numbers_are_values(self):
        rows = self.rows("height.json", "--at", "-12.5,-0.5", "--clamp")
        self.assertAlmostEqual(rows[0]["z"], cubic(0, 0.125), 9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
