"""STEP and IGES from the command line, and FreeCAD as an outside witness of them."""

import json
import shutil
import subprocess
import unittest

from harness import TIMEOUT, ToolTest

CAD = ["a.step", "a.stp", "a.igs", "a.iges"]
FREECAD = next((p for p in map(shutil.which, ("freecadcmd", "FreeCADCmd", "freecadcmd-python3")) if p), None)

# Run by FreeCAD: what each file holds, as a line of JSON.
WITNESS = """
import json
import Part
found = []
for path in {paths!r}:
    shape = Part.read(path)
    box = shape.optimalBoundingBox() if hasattr(shape, "optimalBoundingBox") else shape.BoundBox
    found.append({{"faces": len(shape.Faces), "valid": shape.isValid() and all(f.isValid() for f in shape.Faces),
                  "surface": [type(f.Surface).__name__ for f in shape.Faces],
                  "box": [box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax],
                  "poles": [[p.x, p.y, p.z] for f in shape.Faces for row in f.Surface.getPoles() for p in row]}})
print("WITNESS " + json.dumps(found))
"""


class CadTest(ToolTest):
    def setUp(self):
        super().setUp()
        formats = json.loads(self.run_tool("formats", "--json").stdout)
        if not any(f["name"] == "step" and f["writes"] for f in formats):
            self.skipTest("built without CAD exchange")

    def fit(self, *more):
        self.write_points()
        return self.run_json("fit", "points.csv", "--control-points", "9x8", "-o", "s.json", *more)

    def assert_same_surface(self, a, b, factor=1, places=13):
        self.assertEqual(a["degree"], b["degree"])
        for knots in ("knots_u", "knots_v"):
            self.assertEqual(len(a[knots]), len(b[knots]))
            for x, y in zip(a[knots], b[knots]):
                self.assertAlmostEqual(x, y, places)
        points = [[x for row in s["control_points"] for p in row for x in p] for s in (a, b)]
        self.assertEqual(len(points[0]), len(points[1]))
        for x, y in zip(*points):
            self.assertAlmostEqual(factor * x, y, places)


class Written(CadTest):
    def test_by_fit_and_read_back_by_convert(self):
        report = self.fit(*(word for name in CAD for word in ("-o", name)))
        self.assertEqual(report["outputs"], ["s.json", *CAD])
        for name in CAD:
            self.run_tool("convert", name, "-o", "back.json", "--force")
            self.assert_same_surface(self.load("s.json"), self.load("back.json"))

    def test_height_fields_in_space(self):
        self.write_heights()
        self.run_tool("fit", "heights.csv", "--height-field", "--control-points", "7x6", "-o", "h.json", "-o", "h.step")
        info = self.run_json("info", "h.step")
        self.assertEqual((info["dimension"], info["size"]), (3, [7, 6]))
        domain = self.load("h.json")["parameter_map"]
        wanted = [domain[k] for k in ("u0", "u1", "v0", "v1")]
        for x, y in zip(wanted, [*info["net_bounds"][0], *info["net_bounds"][1]]):
            self.assertAlmostEqual(x, y, 12)

    def test_units_name_and_schema(self):
        self.fit()
        self.run_tool("convert", "s.json", "-o", "a.step", "--unit", "inch", "--name", "Left wing", "--step-schema", "ap214")
        text = (self.folder / "a.step").read_text()
        for word in ("AUTOMOTIVE_DESIGN", "PRODUCT('Left wing','Left wing'", "CONVERSION_BASED_UNIT('INCH'"):
            self.assertIn(word, text)
        for unit, factor in (("inch", 1), ("mm", 25.4), ("m", 0.0254)):
            self.run_tool("convert", "a.step", "--unit", unit, "-o", "back.json", "--force")
            self.assert_same_surface(self.load("s.json"), self.load("back.json"), factor, 12)
        self.run_tool("convert", "s.json", "-o", "wing.stp", "-o", "wing.igs")
        self.assertIn("PRODUCT('wing','wing'", (self.folder / "wing.stp").read_text())
        self.assertIn("AP242", (self.folder / "wing.stp").read_text())
        self.refused("convert", "s.json", "-o", "b.step", "--unit", "foot", words=["--unit", "mm, m, inch"])
        self.refused("convert", "s.json", "-o", "b.step", "--step-schema", "ap203", words=["--step-schema"])

    def test_stored_options_repeat_them(self):
        self.fit("--unit", "m", "--name", "part", "--cad-safe", "--cad-tol", "0.01%", "--step-schema", "ap214")
        report = self.run_json("fit", "points.csv", "--options", "s.json", "-o", "again.step")
        self.assertEqual([report["options"][k] for k in ("unit", "name", "cad_safe", "cad_tol", "step_schema")],
                         ["m", "part", True, "0.01%", "ap214"])
        text = (self.folder / "again.step").read_text()
        self.assertIn("PRODUCT('part'", text)
        self.assertIn("SI_UNIT($,.METRE.)", text)
        report = self.run_json("fit", "points.csv", "--options", "s.json", "--no-cad-safe", "-o", "b.step")
        self.assertFalse(report["options"]["cad_safe"])

    def test_cad_safe_lowers_the_degree_and_splits(self):
        self.write_points()
        self.run_tool("fit", "points.csv", "--control-points", "9x8", "--degree", "5x2", "-o", "s.json", "-o", "a.step",
                      "--cad-safe", "--cad-tol", "0.1%")
        self.assertEqual(self.run_json("info", "a.step")["degree"], [3, 3])
        # Two knots nearly at one place, which a zigzag needs.
        self.write("near.json", json.dumps({"degree": [2, 1], "knots_u": [0, 0, 0, 0.5, 0.5 + 1e-9, 1, 1, 1],
                                            "knots_v": [0, 0, 1, 1],
                                            "control_points": [[[i, j, i % 2] for j in (0, 5)] for i in range(5)]}))
        self.refused("convert", "near.json", "-o", "b.step", "--cad-safe", "--cad-tol", "1e-12",
                     words=["b.step: the knots 0.5 and 0.5", "merging them may move the surface by"])
        self.assertNotIn("b.step", self.files())
        # A roof: two faces.
        self.write("roof.json", json.dumps({"degree": 1, "knots_u": [0, 0, 0.5, 1, 1], "knots_v": [0, 0, 1, 1],
                                            "control_points": [0, 0, 0, 0, 5, 0, 1, 0, 2, 1, 5, 2, 2, 0, 0, 2, 5, 0]}))
        self.run_tool("convert", "roof.json", "-o", "roof.step", "-o", "roof.igs", "--cad-safe")
        for name in ("roof.step", "roof.igs"):
            info = self.run_json("info", name)
            self.assertEqual((info["kind"], len(info["surfaces"])), ("surfaces", 2))
            self.assertIn(f"{name}, face 2: B-spline surface", self.run_tool("info", name).stdout)
            self.refused("convert", name, "-o", "none.json", words=["holds 2 surfaces; choose one with --face 1 to 2"])
            self.refused("eval", name, "--at", "0,0", "--face", "3", words=["--face 3: there are 2 surfaces"])
            self.run_tool("convert", name, "--face", "1", "-o", "x.json", "--force")
            self.assertEqual(self.load("x.json")["parameter_map"]["u1"], 0.5)

    def test_the_same_bytes_every_time(self):
        self.fit()
        self.run_tool("convert", "s.json", "-o", "a.step", "-o", "a.igs")
        first = [(self.folder / name).read_bytes() for name in ("a.step", "a.igs")]
        self.run_tool("convert", "s.json", "-o", "a.step", "-o", "a.igs", "--force")
        self.assertEqual(first, [(self.folder / name).read_bytes() for name in ("a.step", "a.igs")])

    def test_what_no_cad_file_holds_is_refused_before_the_fit(self):
        self.write("uvz.csv", "z,u,v\n" + "".join(f"{u * v},{u},{v}\n" for u in (0, 0.5, 1) for v in (0, 0.5, 1)))
        self.refused("fit", "uvz.csv", "--control-points", "3", "--degree", "2", "-o", "a.step",
                     words=["a.step: holds a surface in space"])
        self.write_points()
        self.refused("convert", "points.csv", "-o", "a.step", words=["a .step needs a surface"])
        self.assertNotIn("a.step", self.files())


class Read(CadTest):
    def test_a_dos_file_may_end_with_ctrl_z(self):
        self.write_points()
        self.run_tool("fit", "points.csv", "--control-points", "5", "--between", "off", "-q", "-o", "a.step", "-o", "a.igs")
        for name in ("a.step", "a.igs"):
            for end in (b"\x1a", b"\r\n\x1a\r\n", b"\x1a\0\0"):
                (self.folder / f"dos.{name}").write_bytes((self.folder / name).read_bytes() + end)
                plain, dos = (self.run_json("info", path) for path in (name, f"dos.{name}"))
                self.assertEqual((dos["knots"], dos["net_bounds"]), (plain["knots"], plain["net_bounds"]))

    def test_other_files_by_the_name_of_one(self):
        (self.folder / "a.step").write_bytes(b"PK\x03\x04" + bytes(22) + b"\x13\0\0\0" + b"3D/3dmodel.model...")
        self.refused("info", "a.step", words=["a.step", "3MF", "assimp export"])

    def test_eval_and_info(self):
        self.fit("-o", "a.step", "-o", "a.igs")
        wanted = self.run_tool("eval", "s.json", "--grid", "5x4", "--normals").stdout
        for name in ("a.step", "a.igs"):
            self.assertEqual(self.run_tool("eval", name, "--grid", "5x4", "--normals").stdout, wanted)
            info = self.run_json("info", name)
            self.assertEqual((info["kind"], info["size"], info["unit"]), ("surface", [9, 8], "mm"))
            self.assertIn("unit: mm", self.run_tool("info", name).stdout)
        self.run_tool("fit", "points.csv", "--knots-from", "a.step", "-o", "again.json")
        self.assertEqual(self.load("again.json")["knots_u"], self.load("s.json")["knots_u"])

    def test_parameters_of_the_file_are_kept(self):
        self.write("s.json", json.dumps({"degree": [1, 1], "knots_u": [2, 2, 6, 6], "knots_v": [-1, -1, 0, 0],
                                         "control_points": [[[0, 0, 0], [0, 1, 0]], [[4, 0, 0], [4, 1, 0]]]}))
        row, = self.read_csv(self.run_tool("eval", "s.json", "--at=3,-0.5").stdout)
        self.assertEqual((row["x"], row["y"]), (1, 0.5))
        info = self.run_json("info", "s.json")
        self.assertEqual(info["domain"], {"u": [2, 6], "v": [-1, 0]})

    def test_data_is_not_read_from_a_surface(self):
        self.fit("-o", "a.step")
        self.refused("fit", "a.step", words=["a.step: ", "not points"])

    def test_bad_files(self):
        self.fit("-o", "a.step", "-o", "a.igs")
        step = (self.folder / "a.step").read_text()
        self.write("cut.step", step[:2000])
        self.refused("info", "cut.step", words=["cut.step: the STEP file is cut off"])
        self.write("cut.igs", (self.folder / "a.igs").read_text()[:810])
        self.refused("info", "cut.igs", words=["cut.igs: the IGES file is cut off"])
        self.write("none.step", "no CAD file\n")
        self.refused("eval", "none.step", "--at", "0,0", words=["none.step: is neither STEP"])
        self.write("loose.step", step.replace("#34 = ", "#99934 = ", 1))
        self.refused("convert", "loose.step", "-o", "x.json", words=["loose.step:", "entity #34 is not there"])
        self.assertNotIn("x.json", self.files())


@unittest.skipIf(FREECAD is None, "FreeCAD's command line (freecadcmd) is not installed")
class FreeCad(CadTest):
    def witnessed(self, names):
        script = self.write("witness.py", WITNESS.format(paths=[str(self.folder / n) for n in names]))
        done = subprocess.run([FREECAD, str(script)], capture_output=True, text=True, timeout=TIMEOUT,
                              cwd=self.folder, stdin=subprocess.DEVNULL)
        line = next((line for line in done.stdout.splitlines() if "WITNESS " in line), None)
        self.assertIsNotNone(line, done.stdout + done.stderr)
        return dict(zip(names, json.loads(line.split("WITNESS ", 1)[1])))

    def test_opens_each_and_finds_one_valid_face_in_the_right_box(self):
        self.fit("-o", "a.step", "-o", "a.igs", "--step-schema", "ap214")
        self.run_tool("convert", "s.json", "-o", "b.stp")
        self.run_tool("convert", "s.json", "-o", "inch.step", "-o", "inch.igs", "--unit", "inch")
        self.run_tool("convert", "s.json", "-o", "m.step", "-o", "m.igs", "--unit", "m")
        factors = {"a.step": 1, "b.stp": 1, "a.igs": 1, "inch.step": 25.4, "inch.igs": 25.4, "m.step": 1000,
                   "m.igs": 1000}
        grid = self.read_csv(self.run_tool("eval", "s.json", "--grid", "201x201").stdout)
        corners = [low(row[c] for row in grid) for low in (min, max) for c in "xyz"]
        poles = [x for row in self.load("s.json")["control_points"] for p in row for x in p]
        for name, found in self.witnessed(list(factors)).items():
            with self.subTest(file=name):
                factor = factors[name]
                self.assertEqual((found["faces"], found["valid"], found["surface"]), (1, True, ["BSplineSurface"]))
                # A grid of 201 x 201 misses an extremum by little; the box has CAD's tolerance.
                for wanted, got in zip(corners, found["box"]):
                    self.assertAlmostEqual(factor * wanted, got, delta=1e-3 * factor)
                read = [x for p in found["poles"] for x in p]
                self.assertEqual(len(read), len(poles))
                for wanted, got in zip(poles, read):
                    self.assertAlmostEqual(factor * wanted, got, delta=1e-11 * factor)

    def test_opens_the_faces_of_a_cad_safe_surface(self):
        self.write("roof.json", json.dumps({"degree": 1, "knots_u": [0, 0, 0.5, 1, 1], "knots_v": [0, 0, 1, 1],
                                            "control_points": [0, 0, 0, 0, 5, 0, 1, 0, 2, 1, 5, 2, 2, 0, 0, 2, 5, 0]}))
        self.run_tool("convert", "roof.json", "-o", "roof.step", "-o", "roof.igs", "--cad-safe")
        for name, found in self.witnessed(["roof.step", "roof.igs"]).items():
            with self.subTest(file=name):
                self.assertEqual((found["faces"], found["valid"]), (2, True))
                for wanted, got in zip([0, 0, 0, 2, 5, 2], found["box"]):
                    self.assertAlmostEqual(wanted, got, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
