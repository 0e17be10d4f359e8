"""knotfit compare: a row a method and size, tables and pictures that agree, nothing lost where one fails or is stopped."""

import csv
import io
import json
import os
import signal
import subprocess
import time
import unittest
import xml.dom.minidom

from harness import SAMPLES, TOOL, ToolTest, default_signals, step


class Compare(ToolTest):
    def rows(self, *arguments, status=0):
        return self.run_json("compare", "points.csv", *arguments, status=status)["rows"]

    def test_every_method_is_a_row(self):
        self.write_points(count=300)
        names = self.run_tool("methods", "--names").stdout.split()
        rows = self.rows("--sizes", "5x6", "--evaluations", "30", "--between", "off")
        expected = []
        for name in names:
            expected += [f"criterion:{m}" for m in ("hessian", "curvature", "derivative", "residual")] \
                if name == "criterion" else [name]
        self.assertEqual([r["method"] for r in rows], expected)
        best = min(r["rms"] for r in rows)
        for row in rows:
            self.assertEqual(row["size"], [5, 6])
            self.assertEqual(row["control_points"], 30)
            self.assertLessEqual(row["rms"], row["max"])
            self.assertIsNone(row["between"])
            self.assertGreaterEqual(row["seconds"], 0)
            if row["method"] == "optimal":
                self.assertLessEqual(row["rms"], best * 1.01)

    def test_it_says_what_the_columns_were_taken_for(self):
        self.write("p.csv", "x,y,z,u,v,intensity\n" + "".join(
            f"{i},{j},{step(i / 9, j / 9)},{i / 9},{j / 9},7\n" for i in range(10) for j in range(10)))
        ask = ["p.csv", "--sizes", "5x5", "--methods", "uniform,averaging", "--between", "off"]
        wanted = "columns: x y z u v intensity (by the header; left out: intensity)"
        self.assertEqual(self.run_tool("compare", *ask).stdout.splitlines()[3:], [wanted])
        j = self.run_json("compare", *ask)
        self.assertEqual((j["columns"], j["columns_from"]), (["x", "y", "z", "u", "v", "intensity"], "header"))
        self.assertIn(wanted + "\n", self.run_tool("fit", "p.csv", "--control-points", "5").stdout)
        # Points of other formats have columns too.
        self.write("p.ply", "ply\nformat ascii 1.0\nelement vertex 100\n" + "".join(
            f"property float {c}\n" for c in ("x", "y", "z", "red", "green", "blue", "u", "v")) + "end_header\n" +
            "".join(f"{i} {j} {step(i / 9, j / 9)} 1 2 3 {i / 9} {j / 9}\n" for i in range(10) for j in range(10)))
        for command in ("compare", "fit", "info"):
            with self.subTest(command=command):
                options = ask[1:] if command == "compare" else ["--control-points", "5"] if command == "fit" else []
                self.assertIn("columns: x y z r g b u v (by the header; left out: r g b)\n",
                              self.run_tool(command, "p.ply", *options).stdout)

    def test_a_row_is_what_fit_says(self):
        self.write_points(count=300)
        row = self.rows("--sizes", "6x7", "--methods", "dominant")[0]
        fit = self.run_json("fit", "points.csv", "--knots", "dominant", "--control-points", "6x7")
        self.assertEqual(row["rms"], fit["error"]["rms"])
        self.assertEqual(row["max"], fit["error"]["max"])
        self.assertEqual(row["between"], fit["between"])
        self.assertEqual(row["fits"], fit["fits"])
        self.assertTrue(any("resampled" in note for note in row["notes"]))

    def test_the_folder_holds_tables_surfaces_and_pictures(self):
        self.write_points(count=300)
        text = self.run_tool("compare", "points.csv", "--sizes", "5x5,7x6", "--methods",
                             "uniform,criterion:curvature", "--tolerances", "5%", "-o", "report").stdout
        report = self.folder / "report"
        table = json.loads((report / "table.json").read_text())
        self.assertFalse(table["stopped"])
        rows = list(csv.DictReader(io.StringIO((report / "table.csv").read_text())))
        self.assertEqual([(r["method"], r["asked"]) for r in rows],
                         [(r["method"], r["asked"]) for r in table["rows"]])
        self.assertEqual([(r["method"], r["asked"]) for r in rows],
                         [(m, s) for s in ("5x5", "7x6", "5%") for m in ("uniform", "criterion:curvature")])
        for line, row, plain in zip(rows, table["rows"], text.splitlines()[1:]):
            self.assertEqual(float(line["rms"]), row["rms"])
            self.assertEqual(int(line["control_points"]), row["size"][0] * row["size"][1])
            self.assertIn(row["method"], plain)
            # Anybody can check a row: the surface is there, and evaluates to the same error.
            surface = report / row["surface"]
            check = self.run_json("eval", surface, "--points", "points.csv")
            differences = check["differences"] if "differences" in check else check
            self.assertAlmostEqual(differences["rms"], row["rms"], delta=1e-9 * row["rms"] + 1e-15)
        for name in ("errors", "maps-5x5", "maps-7x6", "maps-5", "maps/uniform-5x5", "maps/criterion-curvature-7x6"):
            self.assertEqual((report / f"{name}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n", name)
            xml.dom.minidom.parse(str(report / f"{name}.svg"))

    def test_a_method_that_fails_is_a_row_that_says_why(self):
        self.write_points(count=60)
        rows = self.rows("--sizes", "5x5,9x9", "--methods", "uniform,nktp")
        self.assertEqual([r["status"] for r in rows], ["fixed_size", "fixed_size", "failed", "failed"])
        self.assertIn("60 points are fewer than 9 x 9", rows[2]["failure"])
        text = self.run_tool("compare", "points.csv", "--sizes", "9x9", "--methods", "uniform", "-o", "r").stdout
        self.assertIn("failed: 60 points are fewer", text)
        self.assertTrue((self.folder / "r" / "table.csv").exists())

    def test_a_feature_measure_of_ones_own(self):
        self.write_points(count=400)
        # All of it in a band along v, where u is near 0.7: the criterion's knots gather there.
        self.write("band.csv", "u,v,z\n" + "".join(
            f"{(i + 0.5) / 60},{(j + 0.5) / 10},{1.0 if abs((i + 0.5) / 60 - 0.7) < 0.1 else 0.01}\n"
            for i in range(60) for j in range(10)))
        rows = self.rows("--sizes", "10x5", "--methods", "criterion:given,criterion:hessian,centroid", "--feature-file",
                         "band.csv", "--between", "off")
        plain = self.rows("--sizes", "10x5", "--methods", "criterion:hessian,centroid", "--between", "off")
        inside = lambda row: sum(abs(t - 0.7) < 0.11 for t in row["knots"]["u"])
        self.assertGreaterEqual(inside(rows[0]), 4)
        self.assertEqual(rows[1]["knots"], plain[0]["knots"])  # a measure by name is not the one given
        self.assertNotEqual(rows[2]["knots"], plain[1]["knots"])
        fit = self.run_json("fit", "points.csv", "--knots", "criterion", "--control-points", "10x5", "--feature-file",
                            "band.csv", "-o", "s.json")
        self.assertEqual(fit["error"]["rms"], rows[0]["rms"])
        again = self.run_json("fit", "points.csv", "--options", "s.json")
        self.assertEqual(again["error"], fit["error"])
        names = [r["method"] for r in self.rows("--sizes", "5", "--feature-file", "band.csv", "--evaluations", "20",
                                                "--between", "off")]
        self.assertIn("criterion:given", names)
        # A grid in the coordinates of a height field; what lies outside is left out.
        self.write_heights()
        self.write("grid.asc", "ncols 12\nnrows 12\nxllcorner 98\nyllcorner 48\ncellsize 0.5\n" +
                   ("1 " * 12 + "\n") * 12)
        ask = ["fit", "heights.csv", "--height-field", "--knots", "criterion", "--control-points", "6", "--feature-file",
               "grid.asc"]
        self.run_tool(*ask)
        self.refused(*ask, "--shear", "auto", words=["--feature-file", "--shear"])

    def test_a_feature_measure_that_is_none(self):
        self.write_points(count=60)
        ask = ["compare", "points.csv", "--sizes", "5", "--methods", "criterion:given"]
        self.refused(*ask, words=["criterion:given", "needs a feature measure"])
        self.refused(*ask, "--feature-file", "missing.csv", words=["missing.csv"])
        self.write("f.csv", "u,v,z\n0.1,0.2,1\n0.3,0.4,-2\n")
        self.refused(*ask, "--feature-file", "f.csv", words=["f.csv:3", "-2", "at least 0"])
        self.write("f.csv", "u,v,z\n3,0.2,1\n")
        self.refused(*ask, "--feature-file", "f.csv", words=["f.csv", "no value over the data, u in [0, 1]"])
        self.refused(*ask, "--feature-file", SAMPLES / "face.obj", words=["face.obj", "is a mesh"])

    def test_what_cannot_be_asked(self):
        self.write_points(count=60)
        self.refused("compare", "points.csv", words=["sizes or tolerances"])
        self.refused("compare", "points.csv", "--sizes", "5", "--methods", "best", words=["no placement method 'best'", "nktp"])
        self.refused("compare", "points.csv", "--sizes", "5", "--methods", "criterion:colour", words=["feature measure 'colour'"])
        self.refused("compare", "points.csv", "--sizes", "5y5", words=["--sizes", "5y5"])
        self.refused("compare", "points.csv", "--sizes", "5x5,3x9", words=["3 x 9", "degree 3x3 needs at least 4 x 4"])
        self.refused("compare", "missing.csv", "--sizes", "5x5", "--degree", "3x5", words=["needs at least 4 x 6"])
        self.refused("compare", "points.csv", "--sizes", "5", "-o", "points.csv", words=["points.csv", "folder"])
        self.refused("compare", "points.csv", "--sizes", "5", "-o", "a/b", words=["a/b", "folder"])
        self.refused("compare", "missing.csv", "--sizes", "5", words=["missing.csv"])

    def test_a_comparison_that_is_there_is_kept(self):
        self.write_points(count=60)
        arguments = ["compare", "points.csv", "--sizes", "5", "--methods", "uniform", "-o", "report"]
        self.run_tool(*arguments)
        self.refused(*arguments, words=["table.json", "--force"])
        self.run_tool(*arguments, "--force")

    def test_a_stop_keeps_what_is_done(self):
        self.write_points(count=6000, f=step)
        run = subprocess.Popen([TOOL, "compare", "points.csv", "--sizes", "6x6,25x25", "--methods", "uniform,optimal",
                                "--between", "off", "-o", "report"], cwd=self.folder, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, preexec_fn=default_signals)
        table = self.folder / "report" / "table.csv"
        deadline = time.time() + 60
        while time.time() < deadline and (not table.exists() or len(table.read_text().splitlines()) < 3):
            time.sleep(0.02)
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=120)
        if run.returncode == 0:
            self.skipTest("it was done before the signal came")
        self.assertEqual(run.returncode, 130, err)
        self.assertIn("stopped", err)
        rows = json.loads((self.folder / "report" / "table.json").read_text())
        self.assertTrue(rows["stopped"])
        self.assertGreaterEqual(len(rows["rows"]), 2)
        self.assertTrue((self.folder / "report" / "errors.svg").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
