"""knotfit fit-curve: open, closed, in space and y over x; its files; what it refuses."""

import json
import math
import random
import unittest
import xml.dom.minidom

from harness import SAMPLES, ToolTest


class FitCurve(ToolTest):
    def circle(self, n=120, name="circle.csv"):
        lines = ["x,y"]
        for k in range(n):
            a = 2 * math.pi * (k / n + 0.05 * math.sin(2 * math.pi * k / n))
            lines.append(f"{3 * math.cos(a)!r},{2 * math.sin(a)!r}")
        return self.write(name, "\n".join(lines) + "\n")

    def graph(self, n=200):
        lines = ["x,y"]
        for k in range(n):
            x = 10 + 20 * k / (n - 1)
            lines.append(f"{x!r},{math.tanh(3 * (x - 16))!r}")
        return self.write("graph.csv", "\n".join(lines) + "\n")

    def test_a_closed_curve_to_a_tolerance_with_every_output(self):
        self.circle()
        j = self.run_json("fit-curve", "circle.csv", "--closed", "--tol", "0.001", "-o", "c.json", "-o", "c.csv",
                          "-o", "c.svg", "-o", "c.png", "-o", "c.step", "-o", "c.igs")
        self.assertTrue(j["reached"])
        self.assertTrue(j["closed"])
        self.assertLessEqual(j["error"]["max"], 0.001)
        self.assertEqual(j["control_points"], len(j["knots"]) + 1)
        self.assertEqual(j["outputs"], ["c.json", "c.csv", "c.svg", "c.png", "c.step", "c.igs"])
        document = self.load("c.json")
        self.assertEqual(document["format"], "knotfit-curve")
        self.assertEqual(document["control_points"][0], document["control_points"][-1])
        rows = self.read_csv((self.folder / "c.csv").read_text())
        self.assertEqual(len(rows), 120)
        self.assertAlmostEqual(max(r["error"] for r in rows), j["error"]["max"], delta=1e-15)
        self.assertAlmostEqual(math.sqrt(sum(r["error"] ** 2 for r in rows) / 120), j["error"]["rms"], delta=1e-12)
        xml.dom.minidom.parse(str(self.folder / "c.svg"))
        self.assertIn("B_SPLINE_CURVE_WITH_KNOTS", (self.folder / "c.step").read_text())

    def test_y_over_x(self):
        self.graph()
        j = self.run_json("fit-curve", "graph.csv", "--function", "--control-points", "9", "-o", "g.json", "-o", "g.csv")
        self.assertEqual(j["dimension"], 1)
        self.assertEqual(j["status"], "fixed_size")
        document = self.load("g.json")
        self.assertEqual((document["x0"], document["x1"]), (10, 30))
        rows = self.read_csv((self.folder / "g.csv").read_text())
        self.assertAlmostEqual(rows[50]["x"], 10 + 20 * 50 / 199, delta=1e-12)

    def test_in_space_and_corrected(self):
        lines = ["x,y,z"]
        for k in range(150):
            t = (k / 149) ** 2
            lines.append(f"{math.cos(6 * t)!r},{math.sin(6 * t)!r},{t!r}")
        self.write("helix.csv", "\n".join(lines) + "\n")
        plain = self.run_json("fit-curve", "helix.csv", "--control-points", "8", "--spacing", "uniform")
        self.assertEqual(plain["dimension"], 3)
        better = self.run_json("fit-curve", "helix.csv", "--control-points", "8", "--spacing", "uniform", "--corrected",
                               "-o", "h.step")
        self.assertLess(better["error"]["rms"], plain["error"]["rms"])

    def test_knots_given_come_back(self):
        self.graph()
        j = self.run_json("fit-curve", "graph.csv", "--function", "--knots-t", "0.2,0.3,0.5")
        self.assertEqual(j["knots"], [0.2, 0.3, 0.5])
        self.assertEqual(j["method"], "given")
        self.circle()
        j = self.run_json("fit-curve", "circle.csv", "--closed", "--knots-t", "0.2,0.3,0.5,0.8")
        self.assertEqual(j["knots"], [0.2, 0.3, 0.5, 0.8])
        self.assertEqual(j["control_points"], 5)

    def test_a_feature_measure_of_ones_own(self):
        self.graph()
        # All of it where x is near 24, where the curve itself is flat.
        band = lambda x: 1.0 if abs(x - 24) < 2 else 0.01
        self.write("band.csv", "x,f\n" + "".join(f"{10 + k / 10},{band(10 + k / 10)}\n" for k in range(201)))
        ask = ["fit-curve", "graph.csv", "--function", "--control-points", "12", "--knots", "criterion"]
        inside = lambda row: sum(abs(10 + 20 * t - 24) < 2 for t in row["knots"])
        given, plain = self.run_json(*ask, "--feature-file", "band.csv"), self.run_json(*ask)
        self.assertGreaterEqual(inside(given), 6)
        self.assertLessEqual(inside(plain), 3)
        # The same by t of a curve that is no function, and without a header.
        self.write("line.csv", "x,y\n" + "".join(f"{k},{k / 2}\n" for k in range(101)))
        self.write("t.csv", "".join(f"{k / 200} {band(10 + k / 10)}\n" for k in range(201)))
        line = self.run_json("fit-curve", "line.csv", "--control-points", "12", "--knots", "criterion", "--feature-file",
                             "t.csv")
        for a, b in zip(given["knots"], line["knots"]):
            self.assertAlmostEqual(a, b, delta=1e-12)
        # A table: the measure given is one of its own, and a measure by name is not it.
        table = ["fit-curve", "graph.csv", "--function", "--control-points", "12"]
        rows = self.run_json(*table, "--compare", "criterion:given,criterion:hessian", "--feature-file", "band.csv")["rows"]
        self.assertEqual(rows[0]["rms"], given["error"]["rms"])
        self.assertEqual(rows[1]["rms"], plain["error"]["rms"])
        names = [r["method"] for r in self.run_json(*table, "--compare", "all", "--feature-file", "band.csv",
                                                    "--evaluations", "20")["rows"]]
        self.assertIn("criterion:given", names)

    def test_a_feature_measure_that_is_none(self):
        self.graph()
        ask = ["fit-curve", "graph.csv", "--function", "--control-points", "9"]
        self.refused(*ask, "--compare", "criterion:given", words=["criterion:given", "needs a feature measure"])
        self.refused(*ask, "--feature-file", "missing.csv", words=["missing.csv"])
        self.write("f.csv", "x,f\n12,1\n13,-2\n")
        self.refused(*ask, "--feature-file", "f.csv", words=["f.csv:3", "-2", "at least 0"])
        self.write("f.csv", "x,f\n0.2,1\n")
        self.refused(*ask, "--feature-file", "f.csv", words=["f.csv", "no value over the curve, x in [10, 30]"])
        self.write("f.csv", "0.2,1,4\n")
        self.refused(*ask, "--feature-file", "f.csv", words=["f.csv:1", "3 columns"])
        self.refused(*ask, "--feature-file", SAMPLES / "face.obj", words=["face.obj", "two columns: x and the measure"])
        self.circle()
        self.refused("fit-curve", "circle.csv", "--feature-file", SAMPLES / "face.obj", words=["two columns: t, from 0"])

    def test_a_time_limit_keeps_the_best_so_far(self):
        self.graph()
        ask = ["fit-curve", "graph.csv", "--function", "--tol", "1e-9", "--max-control-points", "190"]
        j = self.run_json(*ask, "--time-limit", "1e-6", status=3)
        self.assertEqual(j["status"], "time_limit")
        self.assertEqual(len(j["tried"]), 1)
        self.assertIn("time limit", j["message"])
        self.assertGreater(j["control_points"], 0)
        self.refused(*ask, "--time-limit", "0", words=["--time-limit"])

    def test_optimal_is_the_best_of_the_table(self):
        rows = self.run_json("fit-curve", SAMPLES / "blade_profile.csv", "--closed", "--control-points", "20",
                             "--compare", "all", "--evaluations", "300")["rows"]
        names = self.run_tool("methods", "--names").stdout.split()
        self.assertEqual(len(rows), len(names) + 3)
        best = next(r["rms"] for r in rows if r["method"] == "optimal")
        for row in rows:
            self.assertLessEqual(best, row["rms"] * 1.001, row["method"])
        table = self.run_tool("fit-curve", SAMPLES / "blade_profile.csv", "--closed", "--control-points", "20",
                              "--compare", "nktp,dominant").stdout
        self.assertEqual(len(table.splitlines()), 4)
        self.assertEqual(table.splitlines()[-1], "columns: x y (by the header)")

    def test_a_table_says_what_was_read(self):
        text = "a profile\n" + "".join(f"{math.cos(k / 20)} {math.sin(k / 20)}\n" for k in range(60))
        self.write("arc.dat", text)
        ask = ["fit-curve", "arc.dat", "--control-points", "8"]
        table = ["--compare", "uniform,averaging"]
        j, one = self.run_json(*ask, *table), self.run_json(*ask)
        self.assertEqual((j["columns"], j["columns_from"]), (["x", "y"], "guess"))
        self.assertEqual(j["notes"], [n for n in one["notes"] if "left out" in n])
        self.assertEqual(len(j["notes"]), 1)
        lines = self.run_tool(*ask, *table).stdout.splitlines()
        self.assertEqual(lines[3:], ["columns: x y (guessed)", "note: " + j["notes"][0]])

    def test_a_curve_is_kept_to_its_data(self):
        # A step on uniform knots: least squares through the few points on it swing by diagonals.
        t = [k / 299 for k in range(300)]
        self.write("step.csv", "x,y\n" + "".join(f"{x},{(x > 0.5) + 0.01 * math.sin(20 * x)}\n" for x in t))
        j = self.run_json("fit-curve", "step.csv", "--tol", "0.1%", "--knots", "uniform", "-o", "step.json",
                          status=None)
        self.assertFalse(j["status"] == "reached" and j["swings"]["largest"] > 10)
        self.assertLess(j["swings"]["beyond_box"], 0.1)
        self.assertEqual(set(j["swings"]), {"largest", "distance", "t", "in_gap", "places", "above_3", "beyond_box"})

    def test_a_size_that_swings_says_so_first(self):
        self.write("peak.csv", "x,y\n" + "".join(f"{k},{5 if k == 50 else 0}\n" for k in range(101)))
        ask = ["fit-curve", "peak.csv", "--function", "--control-points", "20", "--tol", "0.1%"]
        j = self.run_json(*ask, status=3)
        self.assertEqual((j["status"], j["reached"]), ("swings", False))
        self.assertGreater(j["swings"]["largest"], 10)
        self.assertIn("between them the curve swings", j["message"])
        text = self.run_tool(*ask, status=3).stdout
        self.assertTrue(text.startswith("the curve swings between the points: at x = "), text)
        self.assertIn("NOT reached (held at the points; the curve swings between them)", text)

    def test_noise_is_not_followed(self):
        rng = random.Random(3)
        self.write("noisy.csv", "x,y\n" + "".join(
            f"{k / 400},{math.sin(9 * k / 400) + rng.gauss(0, 0.02)}\n" for k in range(401)))
        j = self.run_json("fit-curve", "noisy.csv", "--function", "--tol", "0.1%", status=3)
        self.assertEqual(j["status"], "tolerance_below_noise")
        self.assertAlmostEqual(j["noise"], 0.02, delta=0.004)
        self.assertIn("more control points would only follow the noise", j["message"])

    def test_statuses(self):
        self.graph()
        j = self.run_json("fit-curve", "graph.csv", "--function", "--control-points", "5", "--tol", "1e-6", status=3)
        self.assertEqual(j["status"], "not_reached")
        text = self.run_tool("fit-curve", "graph.csv", "--function").stdout
        self.assertIn("reached", text)

    def test_refusals(self):
        self.circle()
        self.graph()
        self.refused("fit-curve", "missing.csv", words=["missing.csv"])
        self.refused("fit-curve", "circle.csv", "--function", words=["circle.csv", "x must increase"])
        self.refused("fit-curve", "circle.csv", "--closed", "--function", words=["--closed"])
        self.refused("fit-curve", "circle.csv", "--control-points", "200", words=["120 points are fewer than 200"])
        self.refused("fit-curve", "circle.csv", "--knots", "best", words=["no placement method 'best'"])
        self.refused("fit-curve", "circle.csv", "--degree", "10", words=["--degree"])
        self.refused("fit-curve", "circle.csv", "-o", "c.asc", words=["c.asc", "no curve"])
        self.refused("fit-curve", "circle.csv", "-o", "c.obj", words=["c.obj", "no curve"])
        self.refused("fit-curve", "circle.csv", "--compare", "all", "-o", "c.json", words=["--compare"])
        self.refused("fit-curve", "circle.csv", "--tol", "0", words=["--tol"])
        self.write_raster()
        self.refused("fit-curve", "terrain.asc", words=["no curve"])
        self.write("one.csv", "x,y\n1,2\n")
        self.refused("fit-curve", "one.csv", words=["one.csv", "at least 2"])

    def test_a_file_that_is_there_is_kept(self):
        self.circle()
        self.run_tool("fit-curve", "circle.csv", "--control-points", "8", "-o", "c.json")
        self.refused("fit-curve", "circle.csv", "--control-points", "8", "-o", "c.json", words=["c.json"])
        before = (self.folder / "c.json").read_text()
        self.run_tool("fit-curve", "circle.csv", "--control-points", "8", "-o", "c.json", "--force")
        self.assertEqual(before, (self.folder / "c.json").read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
