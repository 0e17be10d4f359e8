"""Inputs of public reports with openings: a tube and a plate as clouds, a tube as a mesh; heights of clouds; curves with gaps."""

import math
import unittest

from harness import SOURCE, ToolTest, scattered, wave

REPORTS = SOURCE / "tests" / "cli" / "reports"


class ReportedInputs(ToolTest):
    def test_a_tube_as_a_cloud(self):
        tube = REPORTS / "tube.xyz"
        self.refused("fit", tube, "--tol", "1%", words=["tube.xyz", "1 opening beside the rim, at (", "--fill-holes", "--base cylinder",
                                                        "of radius 1 about (", "1)"])
        self.refused("fit", tube, "--tol", "1%", "--base", "graph", words=["1 opening beside the rim", "--fill-holes"])
        over = self.run_json("fit", tube, "--tol", "1%", "--base", "cylinder")
        self.assertAlmostEqual(over["input"]["cloud"]["radius"], 1, delta=1e-4)
        self.assertEqual(over["input"]["cloud"]["holes"], [])
        self.assertGreater(over["input"]["cloud"]["covered"], 0.94)
        self.assertTrue(over["reached"])
        filled = self.run_json("fit", tube, "--control-points", "8", "--fill-holes", "-o", "s.json")
        holes = filled["input"]["cloud"]["holes"]
        self.assertEqual(len(holes), 1)
        # One end of the tube: about (0, 0, 0) or (0, 0, 3), 2 pi around, by a rim that goes from point to point.
        x, y, z = holes[0]["place"]
        self.assertLess(math.hypot(x, y), 0.1)
        self.assertLess(min(z, 3 - z), 0.2)
        self.assertGreater(holes[0]["length"], 2 * math.pi)
        self.assertLess(holes[0]["length"], 1.3 * 2 * math.pi)
        self.assertAlmostEqual(filled["input"]["cloud"]["covered"], 1 - holes[0]["share_of_square"], delta=1e-9)
        self.assertEqual(filled["input"]["mesh"]["holes"], holes)
        text = self.run_tool("fit", tube, "--control-points", "8", "--fill-holes").stdout
        self.assertIn("1 opening closed by triangles that are no data", text)
        self.assertIn("holes: 1 without data, ", text)
        again = self.run_json("fit", tube, "--options", "s.json")
        self.assertEqual(again["error"], filled["error"])

    def test_a_plate_with_a_hole_as_a_cloud(self):
        plate = REPORTS / "plate_with_hole.xyz"
        self.refused("fit", plate, "--tol", "1%", words=["plate_with_hole.xyz", "1 opening beside the rim, at (0.5", "--fill-holes",
                                                         "--height-field"])
        self.refused("compare", plate, "--sizes", "6x6", "--methods", "uniform", words=["1 opening beside the rim", "--fill-holes"])
        self.run_tool("compare", plate, "--sizes", "6x6", "--methods", "uniform", "--fill-holes")
        filled = self.run_json("fit", plate, "--tol", "1%", "--fill-holes", "-o", "s.svg", "-o", "s.json")
        (hole,) = filled["input"]["cloud"]["holes"]
        for k, at in enumerate((0.5, 0.5)):
            self.assertAlmostEqual(hole["place"][k], at, delta=0.03)
        # Radius 0.33; the rim goes to and fro between points at random, 1/30 apart.
        self.assertGreater(hole["length"], 2 * math.pi * 0.33)
        self.assertLess(hole["length"], 1.9 * 2 * math.pi * 0.33)
        self.assertTrue(filled["reached"])
        self.assertAlmostEqual(filled["input"]["cloud"]["covered"], 1 - hole["share_of_square"], delta=1e-9)
        over = self.run_json("fit", plate, "--control-points", "8", "--fill-holes", "--base", "plane")
        self.assertAlmostEqual(over["input"]["cloud"]["holes"][0]["share_of_square"], math.pi * 0.33 ** 2, delta=0.03)
        self.assertEqual(self.load("s.json")["result"]["input"]["cloud"]["holes"], [hole])
        self.assertEqual((self.folder / "s.svg").read_bytes()[:5], b"<?xml")

    def test_a_tube_as_a_mesh(self):
        tube = REPORTS / "tube_mesh.ply"
        words = ["2 boundary loops, of 40, 40 edges", "1 opening beside its rim, at (", "6.28 around", "--fill-holes", "knotfit convert",
                 "--base cylinder"]
        self.refused("fit", tube, "--tol", "1%", words=words)
        self.run_tool("convert", tube, "-o", "points.csv")
        over = self.run_json("fit", "points.csv", "--base", "cylinder", "--tol", "1%")
        self.assertAlmostEqual(over["input"]["cloud"]["radius"], 1, delta=1e-4)
        self.assertTrue(over["reached"])
        filled = self.run_json("fit", tube, "--control-points", "8", "--fill-holes")
        (hole,) = filled["input"]["mesh"]["holes"]
        self.assertAlmostEqual(hole["length"], 40 * 2 * math.sin(math.pi / 40), delta=1e-3)
        self.assertAlmostEqual(min(hole["place"][2], 3 - hole["place"][2]), 0, delta=1e-9)
        self.assertAlmostEqual(filled["input"]["mesh"]["covered"], 1 - hole["share_of_square"], delta=1e-9)
        self.assertIn("holes: 1 without data, ", self.run_tool("fit", tube, "--control-points", "8", "--fill-holes").stdout)

    def test_a_sheet_with_a_window_as_a_mesh_names_no_cylinder(self):
        message = self.refused("fit", SOURCE / "tests" / "data" / "bad" / "bad_two_loops.obj", "--tol", "1%",
                               words=["2 boundary loops, of 32, 8 edges", "1 opening beside its rim"])
        self.assertNotIn("cylinder", message)


class HeightsOfAPointCloud(ToolTest):
    def write_ring(self):
        points = [(10 * u, 10 * v) for u, v in scattered(4000)]
        points = [(x, y) for x, y in points if math.hypot(x - 5, y - 5) > 2 and x < 8]
        self.write("ring.csv", "x,y,z\n" + "".join(f"{x},{y},{wave(x / 10, y / 10)}\n" for x, y in points))

    def test_are_nodata_where_there_is_no_data(self):
        self.write_ring()
        report = self.run_json("fit", "ring.csv", "--height-field", "--control-points", "12", "-o", "a.asc", "--cell", "0.1")
        head, cells = self.read_raster("a.asc")
        nodata = head["nodata_value"]
        holes = 0
        for r, row in enumerate(cells):
            y = head["yllcorner"] + (len(cells) - 1 - r + 0.5) * 0.1
            for c, z in enumerate(row):
                x = head["xllcorner"] + (c + 0.5) * 0.1
                holes += z == nodata
                if math.hypot(x - 5, y - 5) < 1.8:
                    self.assertEqual(z, nodata)
                elif math.hypot(x - 5, y - 5) > 2.5 and 0.3 < x < 7.7 and 0.3 < y < 9.7:
                    self.assertAlmostEqual(z, wave(x / 10, y / 10), delta=2e-3)
        self.assertGreater(holes, 900)
        (note,) = [n for n in report["notes"] if "heights written" in n]
        self.assertTrue(note.startswith(f"{holes} of the {len(cells) * len(cells[0])} heights written"), note)
        self.assertIn("--fill-holes", note)

    def test_are_written_everywhere_where_asked(self):
        self.write_ring()
        report = self.run_json("fit", "ring.csv", "--height-field", "--control-points", "12", "-o", "a.asc", "--cell", "0.1",
                               "--fill-holes")
        head, cells = self.read_raster("a.asc")
        self.assertNotIn(head.get("nodata_value", -9999), [z for row in cells for z in row])
        self.assertFalse([n for n in report["notes"] if "heights written" in n])


class CurvesWithGaps(ToolTest):
    def arc(self, name, turn, count=100):
        return self.write(name, "x,y\n" + "".join(
            f"{math.cos(turn * k / (count - 1))},{math.sin(turn * k / (count - 1))}\n" for k in range(count)))

    def test_closed_over_half_the_length_is_said(self):
        self.arc("half.csv", math.pi)
        report = self.run_json("fit-curve", "half.csv", "--closed", "--control-points", "12")
        (note,) = [n for n in report["notes"] if "hold no data" in n]
        # The way back is at least the chord: 2 of pi + 2.
        self.assertGreater(float(note.split(" % ")[0]), 38)
        self.assertIn("without --closed", note)
        self.assertIn("note: " + note.split(",")[0], self.run_tool("fit-curve", "half.csv", "--closed", "--control-points", "12").stdout)

    def test_one_that_goes_round_has_no_such_note(self):
        self.arc("round.csv", 2 * math.pi * 0.99)
        report = self.run_json("fit-curve", "round.csv", "--closed", "--control-points", "12")
        self.assertFalse([n for n in report["notes"] if "hold no data" in n])
        self.arc("few.csv", 2 * math.pi * 0.8, 6)
        report = self.run_json("fit-curve", "few.csv", "--closed", "--control-points", "5")
        self.assertFalse([n for n in report["notes"] if "hold no data" in n])

    def test_equal_ends_are_offered_closed(self):
        self.write("loop.csv", "x,y\n" + "".join(
            f"{math.cos(2 * math.pi * (k % 50) / 50)!r},{math.sin(2 * math.pi * (k % 50) / 50)!r}\n" for k in range(51)))
        report = self.run_json("fit-curve", "loop.csv", "--control-points", "12")
        self.assertTrue([n for n in report["notes"] if "--closed" in n and "first and the last point are equal" in n])
        report = self.run_json("fit-curve", "loop.csv", "--control-points", "12", "--closed")
        self.assertFalse([n for n in report["notes"] if "first and the last point" in n])


if __name__ == "__main__":
    unittest.main(verbosity=2)
