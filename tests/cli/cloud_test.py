"""Point clouds from outside: LAS and PCD, bases, rows of different lengths, corrected parameters."""

import math
import os
import struct
import unittest
from pathlib import Path

from harness import ToolTest, scattered, wave


def las(points, minor=2):
    """LAS of point format 0: (x, y, z, return, of so many, class) each, a scale of 0.001."""
    size = 227
    head = bytearray(size)
    head[0:4], head[24], head[25] = b"LASF", 1, minor
    struct.pack_into("<HI", head, 94, size, size)
    struct.pack_into("<BHI", head, 104, 0, 20, len(points))
    struct.pack_into("<6d", head, 131, 1e-3, 1e-3, 1e-3, 500000, 4600000, 0)
    body = b"".join(struct.pack("<3iHBBbBH", round((x - 500000) * 1000), round((y - 4600000) * 1000), round(z * 1000), 0,
                                number | returns << 3, of_class, 0, 0, 0) for x, y, z, number, returns, of_class in points)
    return bytes(head) + body


class CloudTest(ToolTest):
    def write_bytes(self, name, data):
        (self.folder / name).write_bytes(data)

    def write_scan(self, name="scan.las"):
        """Ground of class 2 with trees of class 5 above a part of it, where the ground is the last of two returns."""
        points = []
        for k, (u, v) in enumerate(scattered(1200)):
            x, y = 500000 + 100 * u, 4600000 + 60 * v
            tree = 0.3 < u < 0.5 and k % 2 == 0
            if tree:
                points.append((x, y, 20 + 8 * v, 1, 2, 5))
            points.append((x, y, 3 * wave(u, v), 2 if tree else 1, 2 if tree else 1, 2))
        self.write_bytes(name, las(points))
        return points

    def write_xyz(self, name, points):
        return self.write(name, "x,y,z\n" + "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in points))


class ManyPoints(CloudTest):
    """Of many points a sample is mapped; the verdict and the table are of all."""

    def write_many(self, count):
        return self.write_xyz("many.csv", [(0.8 * u - 0.6 * wave(u, v), v, 0.6 * u + 0.8 * wave(u, v)) for u, v in scattered(count)])

    def test_a_sample_is_mapped_and_all_are_judged(self):
        self.write_many(22000)
        report = self.run_json("fit", "many.csv", "--engine", "sample", "--tol", "2%", "-o", "s.json", "-o", "errors.csv", "-o", "map.png")
        cloud = report["input"]["cloud"]
        self.assertTrue(5000 < cloud["sample"] <= 20000)
        self.assertEqual(report["sample"], cloud["sample"])
        self.assertEqual((cloud["points"], report["input"]["points"]), (22000, 22000))
        self.assertIn(f"of 22000 points a sample of {cloud['sample']} is mapped", cloud["description"])
        self.assertTrue(report["reached"])
        rows = self.read_csv((self.folder / "errors.csv").read_text())
        self.assertEqual(len(rows), 22000)
        self.assertEqual(max(r["error"] for r in rows), report["error"]["max"])
        self.assertLessEqual(report["error"]["max"], report["tolerance"]["value"])
        far = self.run_json("distance", "s.json", "many.csv")
        self.assertAlmostEqual(far["points_to_surface"]["max"], report["error"]["max"], delta=1e-9)

    def test_methods_are_compared_on_a_sample(self):
        self.write_many(62000)
        report = self.run_json("compare", "many.csv", "--sizes", "6x6", "--methods", "uniform")
        self.assertRegex(report["notes"][0], r"a sample of \d+ of 62000 points is mapped")

    def test_up_to_sixty_thousand_all_are_mapped_unless_asked(self):
        self.write_many(3000)
        for options in ((), ("--engine", "points"), ("--engine", "sample")):
            report = self.run_json("fit", "many.csv", "--control-points", "6", *options)
            self.assertEqual(report["input"]["cloud"]["sample"], 0, options)


class Scans(CloudTest):
    def test_info_lists_classes_and_returns(self):
        points = self.write_scan()
        info = self.run_json("info", "scan.las")
        self.assertEqual((info["format"], info["points"]), ("las", len(points)))
        self.assertEqual(info["notes"][0], f"classes: 2 ground (1200), 5 high vegetation ({len(points) - 1200})")
        self.assertTrue(info["notes"][1].startswith("returns: 1 (1200), 2 ("))
        self.assertIn("2 ground (1200)", self.run_tool("info", "scan.las").stdout)

    def test_classes_and_returns_choose_the_points(self):
        points = self.write_scan()
        trees = len(points) - 1200
        for option, value, count in (("--classes", "2", 1200), ("--classes", "2,5", len(points)), ("--classes", "5", trees),
                                     ("--returns", "last", 1200), ("--returns", "first", 1200), ("--returns", "2", trees)):
            self.assertEqual(self.run_json("info", "scan.las", option, value)["points"], count, (option, value))
        report = self.run_json("fit", "scan.las", "--height-field", "--returns", "last", "--tol", "2%", "-o", "s.json")
        self.assertTrue(report["reached"])
        self.assertEqual(report["input"]["points"], 1200)
        again = self.run_json("fit", "scan.las", "--options", "s.json")
        self.assertEqual(again["error"], report["error"])
        self.refused("fit", "scan.las", "--classes", "6", "--tol", "1%", words=["scan.las", "2 ground (1200)"])
        self.refused("fit", "scan.las", "--classes", "300", "--tol", "1%", words=["--classes", "0 to 255"])
        self.refused("fit", "scan.las", "--returns", "middle", "--tol", "1%", words=["--returns", "middle"])
        self.write_points()
        self.refused("fit", "points.csv", "--classes", "2", "--tol", "1%", words=["points.csv", "only LAS files"])

    def test_coordinates_of_a_map_keep_their_millimetres(self):
        points = self.write_scan()
        self.run_tool("convert", "scan.las", "--classes", "2", "-o", "ground.csv")
        rows = self.read_csv((self.folder / "ground.csv").read_text())
        ground = [p for p in points if p[5] == 2]
        self.assertLess(max(abs(r["y"] - p[1]) for r, p in zip(rows, ground)), 5.1e-4)

    def test_a_grid_of_points_as_pcd(self):
        body = "".join(f"{i / 9} {j / 9} {wave(i / 9, j / 9)}\n" if (i, j) != (4, 4) else "nan nan nan\n"
                       for j in range(10) for i in range(10))
        self.write("grid.pcd", "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 10\nHEIGHT 10\nDATA ascii\n" + body)
        report = self.run_json("fit", "grid.pcd", "--control-points", "6")
        self.assertEqual((report["input"]["points"], report["input"]["holes"]), (99, 1))
        self.assertIsNone(report["correction"])
        corrected = self.run_json("fit", "grid.pcd", "--control-points", "6", "--correct", "5")
        self.assertLess(corrected["error"]["rms"], report["error"]["rms"])


class Bases(CloudTest):
    def test_options_that_repair_meshes_are_no_way_out_for_clouds(self):
        """Points on a regular grid: some three neighbours lie on a line, and --drop-degenerate is for meshes."""
        self.write("grid.csv", "x,y,z\n" + "".join(f"{i},{j},{0.3 * math.sin(0.5 * i) * math.cos(0.4 * j)}\n"
                                                   for j in range(7) for i in range(9)))
        done = self.run_tool("fit", "grid.csv", "--base", "graph", "--control-points", "4", "-q", status=None)
        self.assertNotIn("--drop-degenerate", done.stderr)
        self.assertIn((done.returncode, "--base plane" in done.stderr), [(2, True), (0, False)])
        self.run_tool("fit", "grid.csv", "--base", "plane", "--control-points", "4", "-q")

    def tube(self, turn, count=1500):
        return [((1 + 0.05 * wave(u, v)) * math.cos(turn * u), (1 + 0.05 * wave(u, v)) * math.sin(turn * u), 2 * v)
                for u, v in scattered(count)]

    def test_a_cloud_over_its_plane_is_corrected(self):
        self.write_xyz("cloud.csv", [(2 * u, v, 0.2 * wave(2 * u, 2 * v)) for u, v in scattered(900)])
        plain = self.run_json("fit", "cloud.csv", "--control-points", "6", "--correct", "off")
        report = self.run_json("fit", "cloud.csv", "--control-points", "6", "-o", "s.json", "-o", "r.csv")
        cloud = report["input"]["cloud"]
        self.assertEqual((cloud["base"], cloud["coincident"], cloud["lone"]), ("plane", 0, 0))
        self.assertEqual(report["input"]["points"], 900)
        self.assertLess(report["error"]["rms"], plain["error"]["rms"])
        self.assertEqual(report["correction"]["folds"]["flipped_triangles"], 0)
        rows = self.read_csv((self.folder / "r.csv").read_text())
        self.assertEqual(len(rows), 900)
        distance = self.run_json("distance", "s.json", "cloud.csv")["points_to_surface"]
        self.assertAlmostEqual(distance["rms"], report["error"]["rms"], delta=1e-9)
        text = self.run_tool("fit", "cloud.csv", "--control-points", "6").stdout
        self.assertIn("base: plane with the normal", text)

    def test_normals_of_a_scan_give_the_distance_its_sign(self):
        points = [(2 * u, v, 0.2 * wave(2 * u, 2 * v) + (0.01 if k % 7 == 0 else 0)) for k, (u, v) in enumerate(scattered(700))]
        signed = {}
        for up in (1, -1):
            self.write("scan.csv", "x,y,z,nx,ny,nz\n" + "".join(f"{x},{y},{z},0,0,{up}\n" for x, y, z in points))
            report = self.run_json("fit", "scan.csv", "--control-points", "6", "-o", "r.csv", "--force")
            self.assertEqual(report["input"]["cloud"]["normals"], 700)
            signed[up] = [r["distance"] for r in self.read_csv((self.folder / "r.csv").read_text())]
        raised = [sum(signed[up][::7]) / 100 for up in (1, -1)]
        self.assertGreater(raised[0], 5e-3)  # outside is up
        self.assertLess(raised[1], -5e-3)

    def test_a_cloud_that_folds_is_followed_by_its_neighbours(self):
        self.write_xyz("cloud.csv", self.tube(4.0))
        report = self.run_json("fit", "cloud.csv", "--control-points", "10x8")
        self.assertEqual(report["input"]["cloud"]["base"], "graph")
        self.assertGreater(report["input"]["cloud"]["folded"], 0.1)
        self.assertLess(report["error"]["rms"], 0.01)
        over = self.run_json("fit", "cloud.csv", "--control-points", "10x8", "--base", "cylinder", "-o", "s.json")
        self.assertAlmostEqual(over["input"]["cloud"]["radius"], 1, delta=0.1)
        self.assertLess(over["error"]["rms"], 0.01)
        # Repeated, and on the surface found.
        again = self.run_json("fit", "cloud.csv", "--options", "s.json")
        self.assertEqual(again["error"], over["error"])
        given = self.run_json("fit", "cloud.csv", "--control-points", "10x8", "--base", "s.json")
        self.assertEqual(given["input"]["cloud"]["base"], "surface")
        self.assertLess(given["error"]["rms"], 0.01)

    def test_over_four_boundary_curves(self):
        f = lambda x, y: (x, y, 0.4 * math.sin(x) * math.cos(y))
        self.write_xyz("cloud.csv", [f(3 * u, 2 * v) for u, v in scattered(800)])
        for name, (a, b) in {"a": ((0, 0), (3, 0)), "b": ((3, 2), (3, 0)), "c": ((0, 2), (3, 2)), "d": ((0, 0), (0, 2))}.items():
            self.write_xyz(name + ".xyz", [f(a[0] + (b[0] - a[0]) * k / 30, a[1] + (b[1] - a[1]) * k / 30) for k in range(31)])
        report = self.run_json("fit", "cloud.csv", "--control-points", "8", "--base", "a.xyz,b.xyz,c.xyz,d.xyz")
        self.assertEqual(report["input"]["cloud"]["base"], "surface")
        self.assertLess(report["error"]["rms"], 1e-3)
        self.refused("fit", "cloud.csv", "--control-points", "8", "--base", "a.xyz,b.xyz,c.xyz,a.xyz", words=["closed loop"])
        self.refused("fit", "cloud.csv", "--control-points", "8", "--base", "a.xyz,b.xyz", words=["--base", "four boundary curves"])
        self.refused("fit", "cloud.csv", "--control-points", "8", "--base", "none.json", words=["none.json", "no such file"])

    def test_corners_of_a_cloud_are_found_by_rule(self):
        self.write("cloud.csv", "x,y,z\n" + "".join(f"{i / 9},{j / 9},{i * j / 300}\n" for i in range(10) for j in range(10)))
        for corners in ("1,2,3,4", "0,0,0;1,0,0;1,1,0;0,1,0"):
            self.refused("fit", "cloud.csv", "--control-points", "5", "--corners", corners,
                         words=["--corners " + corners, "by a rule"])

    def test_a_cloud_that_is_no_sheet_says_what_to_do(self):
        self.write_xyz("fog.csv", [(u, v, w) for (u, v), (w, _) in zip(scattered(900), scattered(900, 2))])
        self.refused("fit", "fog.csv", "--tol", "1%", words=["fog.csv", "fold over their plane", "--height-field", "--base plane"])
        self.write("heights.csv", "z\n1\n2\n")
        self.refused("fit", "heights.csv", "--tol", "1%", words=["heights.csv"])

    def test_given_parameters_are_kept_unless_asked(self):
        self.write_points()
        plain = self.run_json("fit", "points.csv", "--control-points", "6")
        self.assertIsNone(plain["correction"])
        corrected = self.run_json("fit", "points.csv", "--control-points", "6", "--correct", "10")
        self.assertEqual(corrected["input"]["cloud"]["base"], "given")
        self.assertGreaterEqual(corrected["correction"]["rounds"], 10)  # more where the knots move too
        # Its parameters are those the shape was made of: little is left to gain.
        self.assertLess(corrected["error"]["rms"], 1.1 * plain["error"]["rms"])
        anew = self.run_json("fit", "points.csv", "--control-points", "6", "--new-parameters")
        self.assertEqual(anew["input"]["cloud"]["base"], "plane")
        self.write("weights.csv", "x,y,z,w\n" + "".join(f"{u},{v},{wave(u, v)},{1 + u}\n" for u, v in scattered(300)))
        self.assertIsNone(self.run_json("fit", "weights.csv", "--control-points", "5")["correction"])
        self.refused("fit", "weights.csv", "--control-points", "5", "--correct", "5", words=["weights"])


class Rows(CloudTest):
    def test_of_different_lengths_are_corrected(self):
        lines = []
        for i in range(16):
            for j in range(20 + i):
                x = (j / (19 + i)) ** 1.5
                lines.append(f"{x} {i / 15} {0.3 * wave(x, i / 15)}")
            lines.append("")
        self.write("rows.txt", "\n".join(lines))
        plain = self.run_json("fit", "rows.txt", "--control-points", "6", "--correct", "off")
        report = self.run_json("fit", "rows.txt", "--control-points", "6")
        self.assertIsNone(plain["correction"])
        self.assertEqual(report["input"]["points"], plain["input"]["points"])
        self.assertGreaterEqual(report["correction"]["rounds"], 30)
        self.assertLess(report["error"]["rms"], plain["error"]["rms"])

    def test_of_a_face_leave_a_stray_row_out_and_hardly_fold(self):
        rows = Path(os.environ.get("KNOTFIT_DATA", "")) / "face_rows.txt"
        if not rows.is_file():
            self.skipTest("KNOTFIT_DATA has no face_rows.txt")
        report = self.run_json("fit", rows, "--control-points", "20", "--knots", "uniform", "--between", "off")
        # Row 31 runs inside the mouth and ends there.
        self.assertEqual(report["input"]["cloud"]["stray_rows"], [31])
        self.assertEqual(report["input"]["cloud"]["lone"], 293)
        self.assertLess(report["error"]["rms"], 1.1e-3 * 0.20601)  # of the diagonal
        self.assertLess(report["correction"]["folds"]["blurred"], 2e-3)
        self.assertEqual(report["correction"]["folds"]["flipped_triangles"], 0)

    def test_points_that_no_triangle_has_belong_to_the_verdict(self):
        rows = [(x, y, 0.2 * wave(x, y)) for x, y in scattered(900)]
        lone = (0.4, 0.5, 3.0)
        self.write("cloud.xyz", "".join(f"{x} {y} {z}\n" for x, y, z in [*rows, lone]))
        ask = ["fit", "cloud.xyz", "--base", "graph", "--tol", "0.05"]
        report = self.run_json(*ask, status=3)
        self.assertEqual(report["input"]["cloud"]["lone"], 1)
        self.assertEqual(report["status"], "not_reached")
        self.assertGreater(report["measured"], 2.5)
        self.assertLess(report["error"]["max"], 0.05)  # of the points fitted
        self.assertRegex(report["message"], r"1 points? of the input .*merged or left out.* farthest is [23]\.\d+ off")
        # The table has it too, at its foot, so that whoever reads the table finds the same.
        self.run_tool(*ask, "-o", "errors.csv", status=3)
        table = self.read_csv((self.folder / "errors.csv").read_text())
        self.assertEqual(len(table), len(rows) + 1)
        self.assertEqual(tuple(table[-1][n] for n in "xyz"), lone)
        self.assertAlmostEqual(max(line["error"] for line in table), report["measured"], places=12)
        # A percentile has room for it.
        self.assertEqual(self.run_json(*ask, "--within", "99%")["status"], "reached")


if __name__ == "__main__":
    unittest.main(verbosity=2)
