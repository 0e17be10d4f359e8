"""What is called reached is: between the points, over all points, on every route; and what is not, is named."""

import json
import random
import unittest

import harness
from harness import SAMPLES, ToolTest


class Trust(ToolTest):
    @staticmethod
    def rough():
        """As many points as 12 x 12 control points: random heights over rows that are no grid."""
        generator = random.Random(1)
        lines = ["x,y,z,u,v"]
        for i in range(12):
            for j in range(12):
                u, v, z = i / 11, j / 11, generator.random()
                lines.append(f"{u!r},{v!r},{z!r},{u + 1e-3 * generator.random() * (0 < i < 11)!r},{v!r}")
        return "\n".join(lines) + "\n"

    def test_a_terrain_without_options_ends_in_its_best_surface(self):
        report = self.run_json("fit", SAMPLES / "jacksboro.asc", "--between", "off", "--max-fits", "60", status=3)
        self.assertIn(report["status"], ("limit_reached", "data_too_sparse"))
        self.assertGreater(report["control_points"], 100)

    def test_insertion_works_on_grids(self):
        self.write_raster(columns=60, rows=50)
        report = self.run_json("fit", "terrain.asc", "--tol", "1%", "--refine", "insert")
        self.assertEqual(report["status"], "reached")

    def test_a_surface_that_swings_is_never_reached(self):
        self.write("rough.csv", self.rough())
        ask = ("fit", "rough.csv", "--control-points", "12x12", "--knots", "uniform", "--between", "off")
        tolerance = f"{1.05 * self.run_json(*ask)['error']['max']!r}"
        report = self.run_json(*ask, "--tol", tolerance, "-o", "rough.png", status=3)
        self.assertEqual(report["status"], "swings")
        self.assertFalse(report["reached"])
        self.assertLess(report["measured"], report["tolerance"]["value"])
        self.assertGreater(report["swings"]["largest"], 10)
        for word in ("swings between the points", "u = ", "--correct", "--smoothing"):
            self.assertIn(word, report["notes"][0])
        text = self.run_tool(*ask, "--tol", tolerance, status=3).stdout
        self.assertTrue(text.startswith("the surface swings between the points"), text)
        self.assertIn("held at the points", text)

    def test_a_fixed_size_that_swings_is_held_by_the_datas_own_spacing(self):
        self.write("rough.csv", self.rough())
        report = self.run_json("fit", "rough.csv", "--control-points", "12x12", "--knots", "uniform", "--tol", "30%")
        self.assertEqual(report["status"], "reached")
        self.assertFalse(report["least_squares"])
        self.assertTrue(any("an energy that follows the data's own spacing" in note for note in report["notes"]))

    def test_merged_duplicates_count_in_the_verdict(self):
        lines = ["x,y,z,u,v"]
        for u, v in harness.scattered(400, 1):
            lines.append(f"{u!r},{v!r},{harness.wave(u, v)!r},{u!r},{v!r}")
        lines.append(f"0.5,0.5,{harness.wave(0.5, 0.5)!r},0.5,0.5")
        lines.append(f"0.5,0.5,{harness.wave(0.5, 0.5) + 2!r},0.5,0.5")
        self.write("twice.csv", "\n".join(lines) + "\n")
        report = self.run_json("fit", "twice.csv", "--duplicates", "lowest", "--tol", "0.05", "-o", "out.csv", status=3)
        self.assertEqual(report["status"], "not_reached")
        self.assertFalse(report["reached"])
        self.assertGreater(report["measured"], 1.9)
        self.assertIn("1 points of the input were merged or left out", report["message"])
        worst = max(float(line.split(",")[5]) for line in (self.folder / "out.csv").read_text().splitlines()[1:])
        self.assertAlmostEqual(worst, report["measured"], 9)

    def test_what_was_not_measured_is_null(self):
        self.write_points(count=300)
        report = self.run_json("fit", "points.csv", "--tol", "5%", "--between", "off")
        self.assertIsNone(report["between"])
        self.assertIsNone(report["bound"])
        self.assertIn("between the points: not measured", self.run_tool("fit", "points.csv", "--tol", "5%", "--between", "off").stdout)

    def test_nothing_promised_is_not_0(self):
        lines = ["x,y,z,u,v"] + [f"{i / 5!r},{j / 5!r},{(i * j) / 9!r},{i / 5!r},{j / 5!r}" for i in range(5) for j in range(5)]
        self.write("few.csv", "\n".join(lines) + "\n")
        report = self.run_json("fit", "few.csv", "--control-points", "4x4", "--knots", "uniform")
        self.assertEqual(report["thin"], 1)
        self.assertIsNone(report["between"])
        self.assertIsNone(report["bound"])
        self.assertIn("nothing promised", self.run_tool("fit", "few.csv", "--control-points", "4x4", "--knots", "uniform").stdout)

    def test_crowded_parameters_are_named_with_the_way_out(self):
        report = self.run_json("fit", SAMPLES / "face.uv.csv", "--control-points", "12x12", "--knots", "uniform", "--between", "off")
        self.assertTrue(any("--correct" in note and "squeeze" in note for note in report["notes"]), report["notes"])

    def test_progress_is_in_the_datas_unit(self):
        lines = ["x,y,z,u,v"]
        for u, v in harness.scattered(500, 1):
            lines.append(f"{1000 * u!r},{1000 * v!r},{1000 * harness.wave(u, v)!r},{u!r},{v!r}")
        self.write("large.csv", "\n".join(lines) + "\n")
        report = self.run_json("fit", "large.csv", "--tol", "1%", "-o", "s.json")
        self.assertLessEqual(report["measured"], report["tolerance"]["value"])
        self.assertEqual(json.loads((self.folder / "s.json").read_text())["result"]["swings"]["above_3"], 0)


if __name__ == "__main__":
    unittest.main()
