"""Files of public reports, and others of their kind: points and curves as text, arrays and scans.

Each row says what a file gives: the values read, or the refusal with the way out.
"""

import math
import random
import struct
import unittest
from pathlib import Path

from harness import ToolTest

REPORTS = Path(__file__).with_name("reports")
LEFT_OUT = "left out"


def profile(n=40):
    """Upper and lower surface of a section, each from the nose to the tail."""
    xs = [(1 - math.cos(math.pi * k / (n - 1))) / 2 for k in range(n)]
    half = [0.3 * (0.3 * math.sqrt(x) - 0.126 * x - 0.174 * x * x) for x in xs]
    camber = [0.05 * math.sin(math.pi * x) for x in xs]
    return [(x, c + h) for x, c, h in zip(xs, camber, half)], [(x, c - h) for x, c, h in zip(xs, camber, half)]


def text_of(points):
    return "".join(" ".join(f"{x:.6f}" for x in p) + "\n" for p in points)


def sheet(n=300, seed=3):
    """x, y, z of a smooth sheet."""
    rng = random.Random(seed)
    out = []
    for _ in range(n):
        x, y = 10 * rng.random(), 8 * rng.random()
        out.append((x, y, 0.5 * math.sin(0.5 * x) + 0.1 * y))
    return out


def npy(rows):
    shape = f"({len(rows)}, {len(rows[0])})"
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}"
    header += " " * (63 - (10 + len(header)) % 64) + "\n"
    return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode()
            + b"".join(struct.pack("<d", x) for row in rows for x in row))


class Reports(ToolTest):
    """The table of the files as they were reported: what fit, fit-curve and info say of each."""

    # file: points, columns, where they are from, sums of the coordinates' ranges, notes
    READ = {
        "count_first.pts": (400, "x y z intensity r g b", "guess", ["line 1 left out, the number of points: \"400\""]),
        "xyz_normals.xyz": (400, "x y z nx ny nz", "guess", []),
        "time_column.csv": (400, "x y z time", "header", []),
        "n4_intensity.npy": (300, "x y z intensity", "guess", []),
        "fewer_claimed.las": (250, "x y z intensity return class time", "header", ["the header claims 250 points, which are read, but 150 more follow them"]),
    }

    def test_what_is_read(self):
        for name, (points, columns, source, notes) in self.READ.items():
            with self.subTest(file=name):
                j = self.run_json("info", REPORTS / name)
                self.assertEqual(j["points"], points)
                self.assertEqual(j.get("columns"), columns.split() if columns else None)
                self.assertEqual(j.get("columns_from"), source)
                for note in notes:
                    self.assertTrue(any(note in n for n in j["notes"]), j["notes"])

    def test_what_is_fitted(self):
        """All these sheets are z over x, y: a size that holds them, and the summary's line."""
        for name in self.READ:
            with self.subTest(file=name):
                j = self.run_json("fit", REPORTS / name, "--height-field", "--control-points", "10x8", "--knots",
                                  "uniform", "--between", "off")
                points, columns, source, notes = self.READ[name]
                self.assertEqual(j["input"]["points"], points)
                self.assertEqual(j.get("columns"), columns.split() if columns else None)
                self.assertLess(j["error"]["rms"], 0.02 * j["input"]["diagonal"])
                for note in notes:
                    self.assertTrue(any(note in n for n in j["notes"]), j["notes"])
        text = self.run_tool("fit", REPORTS / "count_first.pts", "--height-field", "--control-points", "6", "--knots",
                             "uniform").stdout
        self.assertIn("columns: x y z intensity r g b (guessed; left out: intensity r g b)\n", text)
        self.assertIn("note: line 1 left out, the number of points: \"400\"\n", text)

    def test_normals_are_used_and_may_be_named(self):
        for option in ([], ["--columns", "x,y,z,nx,ny,nz"]):
            j = self.run_json("fit", REPORTS / "xyz_normals.xyz", "--control-points", "5", "--correct", "off", *option)
            self.assertEqual(j["input"]["cloud"]["normals"], 400)
        rows = self.converted(REPORTS / "xyz_normals.xyz")
        self.assertEqual(rows[0], {"x": 8.050029, "y": 0.998108, "z": 0.386247, "nx": 0.129241, "ny": 0.024394,
                                   "nz": 0.991313})

    def converted(self, path, *options):
        self.run_tool("convert", path, "-o", "out.csv", "--force", *options)
        return self.read_csv((self.folder / "out.csv").read_text())

    def test_columns_that_stay_open_are_refused_with_each_reading(self):
        words = ["6 columns and no header line", "--columns x,y,z,u,v,w or --columns x,y,z,r,g,b"]
        for command in ("fit", "info", "fit-curve"):
            self.refused(command, REPORTS / "xyz_rgb_unit.xyz", words=["xyz_rgb_unit.xyz:1:", *words])
        colours = self.converted(REPORTS / "xyz_rgb_unit.xyz", "--columns", "x,y,z,r,g,b")
        self.assertEqual(sorted(colours[0]), ["x", "y", "z"])
        weights = self.converted(REPORTS / "xyz_rgb_unit.xyz", "--columns", "x,y,z,u,v,w")
        self.assertEqual(weights[0]["u"], 0.709804)

    def test_missing_values(self):
        for name, what in (("nan_cells.csv", '"nan" is not a finite number'), ("empty_cells.csv", "is empty")):
            with self.subTest(file=name):
                self.refused("fit", REPORTS / name,
                             words=[f"{name}:9: column 3 (z)", what, "--nodata nan leaves out the points"])
                for word in ("nan", "NA", "null", "empty"):
                    j = self.run_json("info", REPORTS / name, "--nodata", word)
                    self.assertEqual((j["points"], j["holes"]), (392, 8))
                j = self.run_json("fit", REPORTS / name, "--nodata", "nan", "--control-points", "6", "--correct", "off",
                                  "-o", "s.json")
                self.assertEqual((j["input"]["points"], j["input"]["holes"]), (392, 8))
                self.assertIn("8 points left out: a value is missing (--nodata nan)", j["notes"])
                self.assertEqual(j["options"]["nodata"], "nan")
                again = self.run_json("fit", REPORTS / name, "--options", "s.json")
                self.assertEqual(again["error"], j["error"])
                (self.folder / "s.json").unlink()

    def test_a_stray_is_named_with_its_line(self):
        words = ["outlier.xyz: line 501: (0.5, 0.5, 1000000) stands more than 1000 times as far", "leave it out"]
        message = self.refused("fit", REPORTS / "outlier.xyz", words=words)
        self.assertNotIn("straight line", message)
        self.refused("fit", REPORTS / "outlier.xyz", "--base", "cylinder", words=words)
        j = self.run_json("fit", REPORTS / "outlier.xyz", "--nodata", "1e6", "--control-points", "6", "--correct", "off")
        self.assertEqual(j["input"]["points"], 500)
        self.assertLess(j["input"]["diagonal"], 2)
        j = self.run_json("fit", REPORTS / "outlier.xyz", "--height-field", "--control-points", "4", "--between", "off")
        self.assertTrue(any(n.startswith("line 501 stands more than 1000 times") for n in j["notes"]), j["notes"])

    def test_airfoils(self):
        selig = self.run_json("fit-curve", REPORTS / "selig_no_name.dat", "--tol", "0.001", "-o", "a.csv")
        self.assertEqual((selig["points"], selig["columns"], selig["columns_from"]), (79, ["x", "y"], "guess"))
        lednicer = self.run_json("fit-curve", REPORTS / "lednicer.dat", "--tol", "0.001", "-o", "b.csv")
        self.assertEqual(lednicer["points"], 79)
        self.assertTrue(any("joined to one profile" in n for n in lednicer["notes"]), lednicer["notes"])
        places = lambda name: [(r["x"], r["y"]) for r in self.read_csv((self.folder / name).read_text())]
        self.assertEqual(places("a.csv"), places("b.csv"))
        self.assertEqual(selig["error"]["max"], lednicer["error"]["max"])
        upper = self.run_json("fit-curve", REPORTS / "lednicer.dat", "--block", "1", "--control-points", "6")
        self.assertEqual(upper["points"], 40)


class OfTheSameKind(ToolTest):
    def test_names_of_airfoils(self):
        upper, lower = profile()
        section = text_of(upper[::-1] + lower[1:])
        plain = None
        for name in ("", "NACA 2412\n", "CLARK Y\n", "RAF 15 AIRFOIL\n\n", "EPPLER 205\nfrom the wind tunnel of 1998\n", "79\n",
                     "# x y\n", "x y\n", "//X Y\n79\n"):
            with self.subTest(name=name):
                self.write("a.dat", name + section)
                j = self.run_json("fit-curve", "a.dat", "--control-points", "12")
                self.assertEqual(j["points"], 79)
                plain = plain or j
                self.assertEqual(j["error"]["max"], plain["error"]["max"])
                self.assertEqual(j["columns"], ["x", "y"])

    def test_lednicer_with_and_without_blank_lines(self):
        upper, lower = profile(33)
        lower = lower[:30] + [(1, 0)]
        for gap in ("\n", ""):
            self.write("a.dat", "SECTION 7 A\n 33. 31.\n" + gap + text_of(upper) + gap + text_of(lower))
            j = self.run_json("fit-curve", "a.dat", "--control-points", "12", "-o", "a.csv", "--force")
            rows = self.read_csv((self.folder / "a.csv").read_text())
            self.assertEqual((rows[0]["x"], rows[32]["x"], rows[-1]["x"]), (1, 0, 1))
            self.assertEqual(j["points"], 63)
        text = self.run_tool("fit-curve", "a.dat", "--control-points", "12").stdout
        self.assertIn("note: an airfoil in Lednicer's form: 33 points", text)

    def test_blocks(self):
        upper, lower = profile(20)
        for name in ("a.dat", "a.csv", "a.txt"):
            self.write(name, text_of(upper) + "\n" + text_of(lower))
            self.refused("fit-curve", name, words=["2 blocks of points", "20 from line 1, 20 from line 22", "--block N"])
            for block, points in ((1, upper), (2, lower)):
                self.run_tool("fit-curve", name, "--block", block, "--control-points", "6", "-o", "b.csv", "--force")
                rows = self.read_csv((self.folder / "b.csv").read_text())
                self.assertEqual(rows[3]["y"], float(f"{points[3][1]:.6f}"))
            self.refused("fit-curve", name, "--block", "3", words=["block 3 is asked for, but there are 2"])
        self.write("space.xyz", text_of([(*p, 0) for p in upper]) + "\n\n" + text_of([(*p, 1) for p in lower]))
        self.refused("fit-curve", "space.xyz", words=["2 blocks", "--block N"])
        self.assertEqual(self.run_json("fit-curve", "space.xyz", "--block", "2", "--control-points", "6")["dimension"], 3)

    def test_arrays_of_a_curve(self):
        upper, _ = profile()
        for name, rows in (("n2.npy", upper), ("2n.npy", list(zip(*upper)))):
            (self.folder / name).write_bytes(npy(rows))
            j = self.run_json("fit-curve", name, "--control-points", "9")
            self.assertEqual((j["points"], j["dimension"], j["columns"]), (40, 2, ["x", "y"]))
        self.refused("fit", "n2.npy", words=["fit-curve as the x, y of a curve"])

    def test_arrays_of_points(self):
        points = sheet()
        rng = random.Random(5)
        colour = [[rng.randrange(256) for _ in range(3)] for _ in points]
        normal = [(0.6, 0.0, 0.8) if k % 2 else (0.0, -0.6, 0.8) for k in range(len(points))]
        kinds = {
            "x y z": [p for p in points],
            "x y z intensity": [(*p, 7.5 * p[0]) for p in points],
            "x y z r g b": [(*p, *c) for p, c in zip(points, colour)],
            "x y z nx ny nz": [(*p, *n) for p, n in zip(points, normal)],
            "x y z intensity r g b": [(*p, -9.5, *c) for p, c in zip(points, colour)],
            "x y z r g b nx ny nz": [(*p, *c, *n) for p, c, n in zip(points, colour, normal)],
            "x y z nx ny nz r g b": [(*p, *n, *c) for p, c, n in zip(points, colour, normal)],
        }
        for columns, rows in kinds.items():
            (self.folder / "a.npy").write_bytes(npy(rows))
            (self.folder / "t.npy").write_bytes(npy(list(zip(*rows))))
            self.write("a.xyz", "".join(" ".join(map(repr, row)) + "\n" for row in rows))
            for name in ("a.npy", "a.xyz") + (("t.npy",) if columns == "x y z" else ()):
                with self.subTest(columns=columns, name=name):
                    j = self.run_json("info", name)
                    self.assertEqual((j["columns"], j["content"], j["points"]), (columns.split(), "points", 300))
                    self.assertAlmostEqual(j["ranges"]["z"][1], max(p[2] for p in points), delta=1e-12)
        self.refused("info", "t.npy", words=["shape 9 x 300", "--input-format npy-grid"])

    def test_columns_by_any_name_of_a_header(self):
        points = sheet(60)
        self.write("a.xyz", "".join(f"9 200 3 {x!r} {y!r} {z!r} 12.5 0.5\n" for x, y, z in points))
        j = self.run_json("info", "a.xyz", "--columns", "r,g,b,x,y,z,t,intensity")
        self.assertEqual(j["columns"], ["r", "g", "b", "x", "y", "z", "time", "intensity"])
        self.assertEqual(j["ranges"]["x"][0], min(p[0] for p in points))
        self.refused("info", "a.xyz", "--columns", "r,g,b,x,y,z,t,what", words=["--columns", "'what'"])
        self.refused("info", "a.xyz", "--columns", "x,x,b,x,y,z,t,-", words=["given twice"])

    def test_skip_lines(self):
        points = sheet(60)
        self.write("a.xyz", "one two three\n7 7 7\n" + text_of(points))
        self.refused("info", "a.xyz", words=["a.xyz:1", "--skip-lines 1"])
        j = self.run_json("fit", "a.xyz", "--skip-lines", "2", "--height-field", "--control-points", "5", "--between", "off")
        self.assertEqual(j["input"]["points"], 60)
        self.assertEqual(j["options"]["skip_lines"], 2)
        self.assertLessEqual(j["error"]["worst"]["line"], 62)
        self.assertGreaterEqual(j["error"]["worst"]["line"], 3)

    def test_missing_values_in_every_format(self):
        points = sheet(80)
        missing = {5, 17, 40}
        z = lambda k, word: word if k in missing else repr(points[k][2])
        lines = lambda word, mark: [mark.join((repr(x), repr(y), z(k, word))) for k, (x, y, _) in enumerate(points)]
        for word in ("nan", "-9999"):
            number = float(word)
            rows = [(x, y, number if k in missing else h) for k, (x, y, h) in enumerate(points)]
            flat = b"".join(struct.pack("<ddd", *row) for row in rows)
            files = {
                "a.csv": "\n".join(["x,y,z", *lines(word, ",")]).encode(),
                "a.xyz": "\n".join(lines(word, " ")).encode(),
                "a.ply": ("ply\nformat ascii 1.0\nelement vertex 80\nproperty double x\nproperty double y\n"
                          "property double z\nend_header\n" + "\n".join(lines(word, " ")) + "\n").encode(),
                "b.ply": (b"ply\nformat binary_little_endian 1.0\nelement vertex 80\nproperty double x\n"
                          b"property double y\nproperty double z\nend_header\n" + flat),
                "a.obj": "\n".join("v " + line for line in lines(word, " ")).encode(),
                "a.npy": npy(rows),
                "a.pcd": ("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 80\nHEIGHT 1\n"
                          "POINTS 80\nDATA ascii\n" + "\n".join(lines(word, " ")) + "\n").encode(),
            }
            for name, content in files.items():
                with self.subTest(name=name, word=word):
                    (self.folder / name).write_bytes(content)
                    if word == "nan":
                        self.refused("fit", name, words=[name, "z" if name != "a.obj" else "vertex",
                                                         "--nodata nan leaves out the points that miss a value"])
                    j = self.run_json("info", name, "--nodata", word)
                    self.assertEqual((j["points"], j["holes"]), (77, 3))
                    self.assertTrue(any(n.startswith("3 points left out") for n in j["notes"]), j["notes"])
                    self.assertEqual(j["ranges"]["z"][0], min(p[2] for k, p in enumerate(points) if k not in missing))

    def test_places_of_a_map_projection_are_found(self):
        points = [(371000.25 + 50 * x, 5806023.25 + 50 * y, z + (8 if k == 77 else 0))
                  for k, (x, y, z) in enumerate(sheet(200))]
        self.write("utm.csv", "x,y,z\n" + "".join(f"{x:.2f},{y:.2f},{z:.4f}\n" for x, y, z in points))
        text = self.run_tool("fit", "utm.csv", "--height-field", "--control-points", "5", "-o", "s.json").stdout
        self.assertIn(f"at line 79, x = {points[77][0]:.2f}".rstrip("0"), text)
        self.assertIn(f"y = {points[77][1]:.2f}".rstrip("0"), text)
        self.assertNotIn("e+06", text)
        j = self.load("s.json")["result"]
        self.assertAlmostEqual(j["error"]["worst"]["y"], points[77][1], delta=0.006)
        ring = [(371000 + 40 * math.cos(0.7 * k), 5806023.25 + 40 * math.sin(0.7 * k), 0.5 * (k % 60)) for k in range(900)]
        self.write("ring.xyz", "".join(f"{x:.3f} {y:.3f} {z:.3f}\n" for x, y, z in ring))
        text = self.run_tool("fit", "ring.xyz", "--base", "cylinder", "--control-points", "6", "--correct", "off").stdout
        self.assertRegex(text, r"through \(371000(\.\d+)?|370999\.\d+, 58060\d\d\.\d+")
        self.assertNotIn("e+06", text.split("base:")[1].splitlines()[0])

    def test_strays_of_other_kinds(self):
        points = sheet(100)
        points[30] = (1e7, 3, 0.2)
        self.write("a.xyz", "#\n" + "".join(f"{x} {y} {z}\n" for x, y, z in points))
        self.refused("fit", "a.xyz", words=["line 32: (10000000, 3, 0.2) stands more than 1000 times"])
        self.refused("fit", "a.xyz", "--height-field", words=["line 32: (10000000, 3) stands more than 1000 times"])
        same = [(1, 2, 3)] * 40 + [(4, 5, 6)]
        self.write("b.xyz", "".join(f"{x} {y} {z}\n" for x, y, z in same))
        self.refused("fit", "b.xyz", words=["line 41: (4, 5, 6)"])


if __name__ == "__main__":
    unittest.main()
