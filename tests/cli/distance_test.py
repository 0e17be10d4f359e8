"""knotfit distance: from points to a surface and from the surface to a mesh."""

import csv
import json
import math
import unittest

from harness import SAMPLES, ToolTest


def plane(z, tilt=0.0):
    """A bilinear surface over [0,2] x [0,1] at height z + tilt x."""
    return {"format": "knotfit-surface", "version": 1, "degree": [1, 1],
            "knots_u": [0, 0, 1, 1], "knots_v": [0, 0, 1, 1],
            "control_points": [[[0, 0, z], [0, 1, z]], [[2, 0, z + 2 * tilt], [2, 1, z + 2 * tilt]]]}


def sheet(cells, z=0.0, x_end=2.0):
    lines = []
    for j in range(cells + 1):
        lines += [f"v {x_end * i / cells} {j / cells} {z}" for i in range(cells + 1)]
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i + 1
            lines += [f"f {a} {a + 1} {a + cells + 2}", f"f {a} {a + cells + 2} {a + cells + 1}"]
    return "\n".join(lines) + "\n"


class Distance(ToolTest):
    def setUp(self):
        super().setUp()
        self.write("plane.json", json.dumps(plane(0.5)))

    def test_points_are_signed_by_the_normal(self):
        self.write("p.csv", "x,y,z\n0.5,0.5,1\n1,0.25,0\n2.3,0.5,0.9\n")
        j = self.run_json("distance", "plane.json", "p.csv", "-o", "d.csv")
        d = j["points_to_surface"]
        self.assertEqual(d["count"], 3)
        self.assertAlmostEqual(d["rms"], 0.5)  # 0.5, -0.5 and 0.3, 0.4 from the border
        self.assertAlmostEqual(d["signed_mean"], 0.5 / 3)
        self.assertIsNone(j["surface_to_mesh"])
        self.assertIsNone(j["share_within"])
        with open(self.folder / "d.csv") as f:
            rows = [{k: float(x) for k, x in row.items()} for row in csv.DictReader(f)]
        for row, (u, v, distance) in zip(rows, [(0.25, 0.5, 0.5), (0.5, 0.25, -0.5), (1, 0.5, 0.5)]):
            self.assertAlmostEqual(row["u"], u)
            self.assertAlmostEqual(row["v"], v)
            self.assertAlmostEqual(row["distance"], distance)

    def test_a_mesh_is_measured_both_ways(self):
        self.write("half.obj", sheet(8, 0.5, x_end=1.0))
        j = self.run_json("distance", "plane.json", "half.obj", "--samples", "100")
        self.assertAlmostEqual(j["points_to_surface"]["max"], 0)
        back = j["surface_to_mesh"]
        self.assertEqual(back["count"], 10000)
        # Half of the surface lies up to 1 beyond the mesh, at its border: rms sqrt(1/6) over all of it, samples at cells' middles.
        self.assertAlmostEqual(back["max"], 1, places=12)
        self.assertAlmostEqual(back["rms"], math.sqrt(1 / 6), places=3)
        self.assertEqual(back["worst"]["at"][0], 1)
        self.assertIsNone(self.run_json("distance", "plane.json", "half.obj", "--samples", "0")["surface_to_mesh"])

    def test_the_summary_says_the_same(self):
        self.write("sheet.obj", sheet(4, 0.25))
        text = self.run_tool("distance", "plane.json", "sheet.obj", "--samples", "20", "--tol", "0.3").stdout
        self.assertIn("25 points to the surface: rms 0.25, max 0.25", text)
        self.assertIn("surface to the mesh, from 400 samples: rms 0.25", text)
        self.assertIn("within 0.3: 100 % of the points", text)
        self.assertIn("signed by the normal: mean -0.25", text)
        self.assertEqual(self.run_tool("distance", "plane.json", "sheet.obj", "--quiet").stdout, "")

    def test_a_tolerance_gives_the_exit_status(self):
        self.write("p.csv", "x,y,z\n0.5,0.5,0.6\n1,0.25,0.5\n0,0,0.5\n2,1,0.5\n")
        self.assertEqual(self.run_json("distance", "plane.json", "p.csv", "--tol", "0.11")["share_within"], 1)
        j = self.run_json("distance", "plane.json", "p.csv", "--tol", "1%", status=3)
        self.assertEqual(j["share_within"], 0.75)
        self.assertAlmostEqual(j["tolerance"], math.sqrt(4 + 1 + 0.01) / 100)

    def test_a_fitted_face_is_nearer_than_its_errors_say(self):
        self.run_tool("fit", SAMPLES / "face.uv.csv", "--control-points", "10", "--between", "off", "-o", "face.json",
                      "-o", "residuals.csv")
        j = self.run_json("distance", "face.json", SAMPLES / "face.uv.csv", "-o", "d.csv")
        with open(self.folder / "residuals.csv") as f, open(self.folder / "d.csv") as g:
            for error, distance in zip(csv.DictReader(f), csv.DictReader(g)):
                self.assertLessEqual(abs(float(distance["distance"])), float(error["error"]) * (1 + 1e-9))
        self.assertLess(j["points_to_surface"]["max"], j["diagonal"])

    def test_a_height_field_is_measured_in_space(self):
        self.run_tool("fit", SAMPLES / "jacksboro.asc", "--control-points", "8", "--between", "off", "-o", "t.json")
        self.write("p.csv", "x,y,z\n-84.2,36.6,5000\n-84.1,36.5,300\n")
        d = self.run_json("distance", "t.json", "p.csv")["points_to_surface"]
        self.assertLess(abs(d["worst"]["at"][0] + 84.2), 0.5)
        self.assertGreater(d["max"], 4000)

    def test_the_same_for_any_number_of_threads(self):
        self.write("sheet.obj", sheet(20, 0.3))
        one, two = (self.run_json("distance", "plane.json", "sheet.obj", "--threads", n) for n in (1, 2))
        self.assertEqual(one, two)

    def test_refusals(self):
        self.write("p.csv", "x,y,z\n0.5,0.5,1\n")
        self.write("uv.csv", "u,v,z\n0.5,0.5,1\n")
        self.refused("distance", "plane.json", "uv.csv", words=["uv.csv: the points have no x", "--columns"])
        self.refused("distance", "plane.json", "none.csv", words=["none.csv"])
        self.refused("distance", "p.csv", "plane.json", words=["p.csv"])
        self.refused("distance", "plane.json", "p.csv", "-o", "d.png", words=["d.png", "writes .csv"])
        self.refused("distance", "plane.json", "p.csv", "-o", "p.csv", words=["p.csv"])
        self.refused("distance", "plane.json", "p.csv", "--samples", "-1", words=["--samples"])
        self.refused("distance", "plane.json", "p.csv", "--tol", "0", words=["--tol"])
        self.refused("distance", "plane.json", words=["DATA"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
