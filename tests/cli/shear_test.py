"""`knotfit fit --shear`: oblique parameters, and every file and command in the user's own x and y."""

import math
import unittest

from harness import ToolTest


def front(u, v):
    """Steep across u + 0.4 v."""
    return math.tanh(20 * (u + 0.4 * v - 0.6))


class Shear(ToolTest):
    def setUp(self):
        super().setUp()
        self.write_heights(count=2500, f=front)

    def fit(self, *arguments):
        return self.run_json("fit", "heights.csv", "--height-field", "--tol", "1%", "--knots", "error-model",
                             *arguments)

    def test_auto_finds_the_front_and_needs_fewer_control_points(self):
        plain, oblique = self.fit(), self.fit("--shear", "auto")
        self.assertNotIn("shear", plain)
        self.assertAlmostEqual(oblique["shear"]["u"], 0.4, delta=0.06)
        self.assertEqual(oblique["shear"]["v"], 0)
        self.assertTrue(oblique["reached"])
        self.assertLess(2 * oblique["control_points"], plain["control_points"])
        self.assertTrue(any("oblique parameters, u +" in note for note in oblique["notes"]), oblique["notes"])

    def test_files_and_commands_speak_of_x_and_y(self):
        report = self.fit("--shear", "u:0.4", "-o", "s.json", "-o", "r.csv", "-o", "z.asc", "--cell", "0.1", "-o", "s.obj",
                          "-o", "s.png")
        tolerance = report["tolerance"]["value"]
        given = self.read_csv((self.folder / "heights.csv").read_text())
        residuals = self.read_csv((self.folder / "r.csv").read_text())
        for a, b in zip(given, residuals):
            for name in "xyz":
                self.assertAlmostEqual(a[name], b[name], delta=1e-12 * 102)
            self.assertLessEqual(abs(b["error"]), tolerance * (1 + 1e-9))
        # eval at the user's places.
        rows = self.read_csv(self.run_tool("eval", "s.json", "--points", "heights.csv").stdout)
        for a, b in zip(given, rows):
            self.assertLessEqual(abs(a["z"] - b["z"]), tolerance * (1 + 1e-9))
        # The grid, away from the data's ragged rim.
        head, cells = self.read_raster("z.asc")
        for r in range(2, len(cells) - 2):
            for c in range(2, len(cells[0]) - 2):
                x = head["xllcorner"] + (c + 0.5) * head["cellsize"]
                y = head["yllcorner"] + (len(cells) - r - 0.5) * head["cellsize"]
                self.assertAlmostEqual(cells[r][c], front((x - 100) / 2, (y - 50) / 3), delta=3 * tolerance)
        text = self.run_tool("info", "s.json").stdout
        self.assertIn("oblique parameters: shear of u = 0.4", text)
        self.assertIn("x 100", text)

    def test_as_the_base_of_a_cloud_it_lies_where_the_data_is(self):
        self.fit("--shear", "u:0.4", "-o", "s.json")
        report = self.run_json("fit", "heights.csv", "--control-points", "8", "--correct", "off", "--base", "s.json", "--fill-holes",
                               "-o", "r.csv")
        self.assertEqual(report["input"]["cloud"]["base"], "surface")
        # u is that of the feet, over the box of all of them; feet are off by the tolerance at most, 0.02 of 2 in x.
        rows = self.read_csv((self.folder / "r.csv").read_text())
        along = [(row["x"] - 100) / 2 + 0.4 * (row["y"] - 50) / 3 for row in rows]
        low, high = min(along), max(along)
        for row, at in zip(rows, along):
            self.assertAlmostEqual(row["u"], (at - low) / (high - low), delta=0.03)

    def test_derivatives_are_by_x_and_y(self):
        for shear, f in (("u:0.4", front), ("v:-0.3", lambda u, v: math.tanh(12 * (v - 0.3 * u - 0.3)))):
            with self.subTest(shear=shear):
                self.write_heights(count=2500, f=f)
                self.run_json("fit", "heights.csv", "--height-field", "--control-points", "14x14", "--knots", "error-model",
                              "--shear", shear, "-o", "s.json", "--force")
                name = "s.json"
                self.assertIn("shear", self.run_json("info", name))
                h = 1e-4

                def z(x, y):
                    return self.read_csv(self.run_tool("eval", name, "--at", f"{x},{y}").stdout)[0]["z"]

                x, y = 101.1, 51.3
                row = self.read_csv(self.run_tool("eval", name, "--at", f"{x},{y}", "--derivatives", "2").stdout)[0]
                self.assertAlmostEqual(row["z_x"], (z(x + h, y) - z(x - h, y)) / (2 * h), delta=1e-4)
                self.assertAlmostEqual(row["z_y"], (z(x, y + h) - z(x, y - h)) / (2 * h), delta=1e-4)
                mixed = (z(x + h, y + h) - z(x + h, y - h) - z(x - h, y + h) + z(x - h, y - h)) / (4 * h * h)
                self.assertAlmostEqual(row["z_xy"], mixed, delta=1e-3 * max(1, abs(mixed)))

    def test_is_repeated_by_options(self):
        self.fit("--shear", "v:0.25", "-o", "s.json")
        again = self.run_json("fit", "heights.csv", "--options", "s.json", "-o", "t.json")
        self.assertEqual(again["options"]["shear"], "v:0.25")
        self.assertEqual((self.folder / "s.json").read_text(), (self.folder / "t.json").read_text())

    def test_outside_of_the_rectangle_is_refused(self):
        self.fit("--shear", "0.4", "-o", "s.json")
        self.refused("eval", "s.json", "--at", "99,50", words=["99,50", "outside"])
        for at in ("101.99,50.01", "100.01,52.99"):  # near the corners that lie inside of the square
            self.run_tool("eval", "s.json", "--at", at)

    def test_bad_input(self):
        self.refused("fit", "heights.csv", "--height-field", "--shear", "2", words=["--shear", "-1 to 1"])
        self.refused("fit", "heights.csv", "--height-field", "--shear", "w:1", words=["--shear"])
        self.write_points()
        self.refused("fit", "points.csv", "--shear", "auto", words=["points.csv", "height fields"])


if __name__ == "__main__":
    unittest.main()
