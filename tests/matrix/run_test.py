"""Whole rows, with a stand-in for the program that lies in a known way."""

import json
import os
import sys
import tempfile
import unittest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

import run_row
import swings
from inputs import Input
from rows import Row
from splines import Surface

swings.PLACES = 30_000  # enough here, in less time

# Copies the files that lie beside it, prints its report and ends with the status it is told.
STAND_IN = """#!{python}
import json, pathlib, shutil, sys
here = pathlib.Path(__file__).parent
for name in ("out.json", "out.csv"):
    if (here / name).exists():
        shutil.copy(here / name, name)
told = json.loads((here / "told.json").read_text())
print(told["out"], end="")
print(told["err"], end="", file=sys.stderr)
sys.exit(told["exit"])
"""


class Rows(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.tool = self.write("tool", STAND_IN.format(python=sys.executable))
        os.chmod(self.tool, 0o755)
        self.uv = np.random.default_rng(1).random((1500, 2))
        knots = np.concatenate([[0, 0], np.linspace(0, 1, 41), [1, 1]])[1:-1]
        self.surface = Surface((1, 1), knots, knots, np.zeros((41, 41, 1)))
        self.values = 1e-4 * np.random.default_rng(2).standard_normal(1500) + self.uv[:, 0]
        self.surface.net[:, :, 0] = np.linspace(0, 1, 41)[:, None]

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w") as file:
            file.write(text)
        return path

    def errors(self):
        return np.abs(self.surface(*self.uv.T)[:, 0] - self.values)

    def table(self, **columns):
        data = np.column_stack(list(columns.values()))
        return "\n".join([",".join(columns)] + [",".join(map(repr, map(float, r))) for r in data]) + "\n"

    def run_row(self, status="reached", exit_status=0, errors=None, tolerance=0.001, notes=(), **row):
        """A row over z,u,v of a plane in u with a little noise."""
        errors = self.errors() if errors is None else errors
        own = {"degree": [1, 1], "knots_u": self.surface.knots[0].tolist(), "knots_v": self.surface.knots[1].tolist(),
               "control_points": self.surface.net.tolist()}
        self.write("out.json", json.dumps(own))
        self.write("out.csv", self.table(z=self.values, u=self.uv[:, 0], v=self.uv[:, 1], error=errors))
        report = {"status": status, "message": "", "notes": list(notes), "input": {"duplicates": 0},
                  "error": {"max": float(errors.max()), "rms": float(np.sqrt(np.mean(errors ** 2)))},
                  "tolerance": {"value": tolerance, "measure": "max", "share": 1} if tolerance else None}
        self.write("told.json", json.dumps({"out": json.dumps(report), "err": "", "exit": exit_status}))
        data = self.write("data.csv", self.table(z=self.values, u=self.uv[:, 0], v=self.uv[:, 1]))
        return run_row.run(self.tool, Row(Input("data.csv", data, "fit", ()), **row), os.path.join(self.folder, "kept"))

    def needle(self):
        """A control point that no point near it sees, lifted."""
        centre = np.array([20, 20]) / 40
        self.uv = self.uv[np.abs(self.uv - centre).max(axis=1) > 1 / 40]
        self.values = self.uv[:, 0].copy()
        self.surface.net[20, 20] += 0.5

    def test_an_honest_one_passes_and_is_measured(self):
        r = self.run_row()
        self.assertEqual((r.faults, r.status, r.control_points, r.exit), ([], "reached", 41 * 41, 0))
        self.assertAlmostEqual(r.error, self.errors().max() / 0.001)
        self.assertLess(r.swing, 1)
        self.assertGreater(r.places, 10_000)
        self.assertTrue(0 < r.memory < 200)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "kept")))

    def test_a_needle_between_the_points(self):
        self.needle()
        r = self.run_row()
        self.assertEqual(r.faults, ["reached, but it swings"])
        self.assertGreater(r.swing, 100)
        np.testing.assert_allclose(r.swing_at, [0.5, 0.5], atol=0.02)
        self.assertEqual(os.listdir(os.path.join(self.folder, "kept")), ["data.csv_no_option_"])
        self.assertEqual(self.run_row("swings", 3).faults, [])
        self.assertEqual(self.run_row("fixed_size", 0, tolerance=0, size="40").remarks,
                         ["swings, and no note says so"])  # the plane is higher elsewhere

    def test_errors_that_are_not_the_surfaces(self):
        r = self.run_row(errors=0.5 * self.errors())
        self.assertRegex(r.faults[0], r"^errors \(JSON and CSV\) differ by")

    def test_reached_over_a_tolerance_that_does_not_hold(self):
        r = self.run_row(tolerance=1e-5)
        self.assertTrue(any("reached, but the CSV says" in f for f in r.faults), r.faults)
        self.assertEqual(self.run_row("not_reached", 3, tolerance=1e-5).faults, [])

    def test_a_surface_out_of_its_box(self):
        self.uv[self.uv > 0.8] *= 0.5
        self.values = self.uv[:, 0].copy()
        self.surface.net[36:] += 40
        self.assertEqual(self.run_row().faults, ["the box is larger than the data's, and no note says so"])
        self.assertEqual(self.run_row(notes=["the surface leaves the data at u = 0.9"]).faults, [])

    def test_an_exit_status_of_another_status(self):
        self.assertEqual(self.run_row("time_limit", 0).faults, ["exit 0 with status time_limit"])

    def test_refusals(self):
        def refused(words, sound=True, **row):
            self.write("told.json", json.dumps({"out": "", "err": "knotfit: " + words, "exit": 2}))
            return run_row.run(self.tool, Row(Input("data.csv", "data.csv", "fit", (), sound), **row))

        few = "a.csv: 20 points are fewer than 8 x 8 = 64 control points; ask for fewer"
        self.assertEqual(refused(few, size="8").faults, [])
        self.assertEqual(refused(few).faults, ["refused: " + few])
        self.assertEqual(refused("100 points are fewer than 8 x 8 = 64 control points", size="8").status, "refused")
        self.assertNotEqual(refused("100 points are fewer than 8 x 8 = 64 control points", size="8").faults, [])
        self.assertEqual(refused("a.csv: no", sound=False).faults, [])
        self.assertEqual(refused("a.csv: no", sound=False).remarks, ["refused: a.csv: no"])

    def test_stopped_before_there_was_a_surface(self):
        self.write("told.json", json.dumps({"out": "", "err": "stopped", "exit": 130}))
        row = Row(Input("data.csv", "data.csv", "fit", ()), stop="2 s")
        r = run_row.run(self.tool, row)
        self.assertEqual((r.faults, r.remarks), ([], ["stopped before there was a surface"]))

    def test_outputs_that_cannot_be_read(self):
        self.run_row()
        self.write("out.csv", "z,u,v,error\n1,2\n")
        r = run_row.run(self.tool, Row(Input("data.csv", os.path.join(self.folder, "data.csv"), "fit", ())))
        self.assertIn("cannot be measured", r.faults[0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
