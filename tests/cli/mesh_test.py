"""Meshes from outside: read, repaired, mapped, fitted and written."""

import math
import os
import struct
import unittest
import xml.etree.ElementTree
from pathlib import Path

from harness import BAD, SAMPLES, SOURCE, ToolTest, wave

MASK = SOURCE / "tests" / "data" / "mask.obj"


class MeshTest(ToolTest):
    def write_sheet(self, name="sheet.obj", n=12, hole=False, extra=""):
        """A wavy sheet of n x n cells over [0,1]^2; a hole of two by two cells."""
        lines = [f"v {i / n} {j / n} {0.3 * wave(i / n, j / n)}" for j in range(n + 1) for i in range(n + 1)]
        for j in range(n):
            for i in range(n):
                if hole and 4 <= i < 6 and 4 <= j < 6:
                    continue
                a = j * (n + 1) + i + 1
                lines.append(f"f {a} {a + 1} {a + n + 2} {a + n + 1}")
        return self.write(name, "\n".join(lines) + "\n" + extra)

    def rows(self, name):
        lines = (self.folder / name).read_text().split()
        return lines[0], [[float(x) for x in line.split(",")] for line in lines[1:]]


class Info(MeshTest):
    def test_of_a_mesh(self):
        self.write_sheet()
        info = self.run_json("info", "sheet.obj")
        self.assertEqual((info["content"], info["format"], info["points"]), ("mesh", "obj", 169))
        self.assertEqual((info["triangles"], info["parts"], info["boundary_loops"]), (288, 1, 1))
        self.assertEqual((info["disk"], info["problem"]), (True, None))
        self.assertIn("disk: yes", self.run_tool("info", "sheet.obj").stdout)

    def test_says_why_a_mesh_is_no_disk(self):
        info = self.run_json("info", BAD / "bad_two_loops.obj")
        self.assertFalse(info["disk"])
        self.assertIn("--fill-holes", info["problem"])
        self.assertIn("disk: no: the mesh has 2 boundary loops", self.run_tool("info", BAD / "bad_two_loops.obj").stdout)


class BadMeshes(MeshTest):
    """Every bad mesh: its own message, status 2, no output."""

    WORDS = {
        "bad_two_parts.obj": ["2 parts", "98, 50 faces", "--largest-part"],
        "bad_nonmanifold.obj": ["vertices 28 and 29", "3 faces", "line 164"],
        "bad_bowtie.off": ["vertex 35", "non-manifold"],
        "bad_two_loops.obj": ["32, 8 edges", "--fill-holes"],
        "bad_misoriented.ply": ["face 40", "line 114", "--orient"],
        "bad_degenerate.off": ["vertices 14 and 15", "--drop-degenerate"],
        "bad_truncated.ply": ["144 vertices", "byte 1378, inside vertex 100"],
        "bad_ply_huge.ply": ["4000000000 vertices", "48 bytes"],
        "bad_not_a_mesh.stl": ["PNG"],
        "bad_stl_count.stl": ["3000000000 triangles"],
        "bad_face_index.obj": [":36: ", "vertex 26"],
    }

    def test_are_refused_by_fit_and_parameterize(self):
        for name, words in self.WORDS.items():
            with self.subTest(name):
                for command in ("fit", "parameterize"):
                    message = self.refused(command, BAD / name, "-o", "out.csv", words=[name, *words])
                    self.assertLess(len(message), 500)
                self.assertEqual(self.files(), [])

    def test_each_has_a_message_of_its_own(self):
        said = {self.refused("fit", BAD / name, "-o", "out.csv").split(name, 1)[1] for name in self.WORDS}
        self.assertEqual(len(said), len(self.WORDS))

    def test_a_closed_mesh_is_to_be_cut_open(self):
        closed = Path(os.environ.get("KNOTFIT_DATA", "")) / "bad_closed.off"
        if not closed.is_file():
            self.skipTest("KNOTFIT_DATA has no bad_closed.off")
        for command in ("fit", "parameterize"):
            self.refused(command, closed, "-o", "out.csv", words=["bad_closed.off", "no boundary loop", "cut it open"])
        self.assertEqual(self.files(), [])

    def test_what_the_message_names_mends_them(self):
        for name, option in (("bad_two_parts.obj", "--largest-part"), ("bad_bowtie.off", "--largest-part"),
                             ("bad_two_loops.obj", "--fill-holes"), ("bad_misoriented.ply", "--orient"),
                             ("bad_degenerate.off", "--drop-degenerate")):
            with self.subTest(name):
                report = self.run_json("parameterize", BAD / name, option)
                self.assertEqual(report["map"]["flipped"], 0)


class Parameterize(MeshTest):
    def test_gives_every_vertex_parameters(self):
        self.write_sheet()
        report = self.run_json("parameterize", "sheet.obj", "-o", "uv.csv", "-o", "uv.obj", "-o", "uv.ply")
        self.assertEqual(report["map"]["flipped"], 0)
        self.assertLess(report["map"]["stretch"], 1.5)
        header, rows = self.rows("uv.csv")
        self.assertEqual((header, len(rows)), ("x,y,z,u,v", 169))
        for column in (3, 4):
            self.assertEqual((min(r[column] for r in rows), max(r[column] for r in rows)), (0, 1))
        for name in ("uv.obj", "uv.ply"):
            info = self.run_json("info", name)
            self.assertEqual((info["triangles"], info["ranges"]["u"], info["ranges"]["v"]), (288, [0, 1], [0, 1]))
        # A mesh with parameters is fitted at them, like the points.
        by_mesh = self.run_json("fit", "uv.obj", "--control-points", "6")
        by_points = self.run_json("fit", "uv.csv", "--control-points", "6")
        self.assertEqual(by_mesh["error"]["rms"], by_points["error"]["rms"])
        self.assertIsNone(by_mesh["input"]["mesh"]["map"])

    def test_takes_corners_by_number_and_by_place(self):
        self.write_sheet()
        numbers = self.run_json("parameterize", "sheet.obj", "--corners", "1,13,169,157", "-o", "a.csv")
        places = self.run_json("parameterize", "sheet.obj", "--corners", "0,0,0;1,0,0;1,1,0;0,1,0", "-o", "b.csv")
        self.assertEqual(numbers["map"]["corners"], [1, 13, 169, 157])
        self.assertEqual(places["map"]["corners"], [1, 13, 169, 157])
        self.assertEqual((self.folder / "a.csv").read_text(), (self.folder / "b.csv").read_text())
        _, rows = self.rows("a.csv")
        self.assertEqual([rows[k][3:] for k in (0, 12, 168, 156)], [[0, 0], [1, 0], [1, 1], [0, 1]])

    def test_refuses_corners_that_are_none(self):
        self.write_sheet()
        self.refused("parameterize", "sheet.obj", "--corners", "1,2,3", words=["--corners", "four vertices"])
        self.refused("parameterize", "sheet.obj", "--corners", "1,13,169,999", words=["there is no vertex 999"])
        self.refused("parameterize", "sheet.obj", "--corners", "roundest", words=["--corners"])

    def test_refuses_what_is_no_mesh_and_other_outputs(self):
        self.write_points()
        self.refused("parameterize", "points.csv", words=["points.csv: holds no mesh"])
        self.write_sheet()
        for name in ("a.json", "a.vts", "a.asc"):
            self.refused("parameterize", "sheet.obj", "-o", name, words=[name, ".csv, .obj or .ply"])
        self.assertEqual(self.files(), ["points.csv", "sheet.obj"])


    def test_draws_its_lines_on_the_mesh(self):
        self.write_sheet()
        report = self.run_json("parameterize", "sheet.obj", "-o", "a.png", "-o", "a.svg", "-o", "a.pdf", "--lines", "8")
        self.assertEqual(report["outputs"], ["a.png", "a.svg", "a.pdf"])
        self.assertEqual((self.folder / "a.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        svg = xml.etree.ElementTree.parse(self.folder / "a.svg").getroot()  # its text is drawn as outlines
        self.assertTrue(svg.tag.endswith("svg"))
        self.assertGreater(sum(1 for e in svg.iter() if e.tag.endswith("path")), 16)
        self.assertEqual((self.folder / "a.pdf").read_bytes()[:4], b"%PDF")
        for lines in ("0", "201", "many"):
            self.refused("parameterize", "sheet.obj", "-o", "b.png", "--lines", lines, words=["--lines", lines])
        self.refused("parameterize", "sheet.obj", "-o", "a.png", words=["a.png", "--force"])

    def test_by_mean_values_alone(self):
        self.write_sheet()
        least = self.run_json("parameterize", "sheet.obj", "--omega", "0", "--corners", "sharpest")
        start = self.run_json("parameterize", "sheet.obj", "--omega", "0", "--corners", "sharpest", "--map", "mean-value")
        self.assertLess(least["map"]["stretch"], start["map"]["stretch"])
        self.assertEqual(start["map"]["flipped"], 0)
        self.refused("parameterize", "sheet.obj", "--map", "best", words=["--map", "best", "newton"])


class Fit(MeshTest):
    def test_of_a_mesh(self):
        report = self.run_json("fit", MASK, "--control-points", "20", "--knots", "uniform", "--correct", "off",
                               "-o", "mask.json", "-o", "r.csv")
        self.assertIsNone(report["correction"])
        mesh = report["input"]["mesh"]
        self.assertEqual((mesh["vertices"], mesh["triangles"], mesh["map"]["flipped"]), (1590, 3000, 0))
        # The map's own trial is this fit.
        trial = mesh["map"]["trial_error"]
        # (held between the points, where its least squares alone swing)
        self.assertAlmostEqual(report["error"]["rms"] / report["input"]["diagonal"], trial, delta=2e-2 * trial)
        self.assertEqual(len(self.rows("r.csv")[1]), 1590)
        text = self.run_tool("fit", MASK, "--control-points", "8").stdout
        for word in ("mesh: 1590 vertices", "map: L2 stretch", "0 flipped", "corners: vertices", "counted from 1"):
            self.assertIn(word, text)

    def test_parameters_are_corrected_at_a_fixed_size(self):
        size = ("--control-points", "14", "--knots", "uniform")
        plain = self.run_json("fit", MASK, *size, "--correct", "off")
        report = self.run_json("fit", MASK, *size, "-o", "s.json", "-o", "r.csv", "-o", "s.svg", "-o", "s.ply")
        correction = report["correction"]
        self.assertLess(report["error"]["rms"], 0.5 * plain["error"]["rms"])
        self.assertEqual(correction["rounds"], 30)
        self.assertEqual(correction["folds"]["flipped_triangles"], 0)
        self.assertLessEqual(correction["folds"]["raw"], 0.005)
        self.assertLess(correction["surface_to_mesh"]["rms"], plain["error"]["rms"])
        self.assertGreaterEqual(correction["error_at_parameters"]["rms"], report["error"]["rms"])
        # The table, the report and knotfit distance say the same.
        header, rows = self.rows("r.csv")
        names = header.split(",")
        columns = {name: [float(row[k]) for row in rows] for k, name in enumerate(names)}
        self.assertEqual(len(rows), 1590)
        for error, distance, held in zip(columns["error"], columns["distance"], columns["error_at_parameters"]):
            self.assertEqual(error, abs(distance))
            self.assertGreaterEqual(held, error * (1 - 1e-9) - 1e-12)  # rounding of coordinates about 1
        self.assertAlmostEqual(max(columns["error"]), report["error"]["max"], places=12)
        distance = self.run_json("distance", "s.json", MASK, "--samples", "0")["points_to_surface"]
        self.assertAlmostEqual(distance["rms"], report["error"]["rms"], delta=1e-9)
        self.assertAlmostEqual(distance["max"], report["error"]["max"], delta=1e-9)
        self.assertAlmostEqual(distance["signed_mean"], correction["signed_mean"], delta=1e-9)
        # Stored, repeated, undone.
        again = self.run_json("fit", MASK, "--options", "s.json", "--correct", "3", "-o", "t.json")
        self.assertEqual(again["correction"]["rounds"], 3)
        self.assertEqual(self.run_json("fit", MASK, "--options", "t.json")["options"]["correct"], "3")

    def test_fairness_and_reflection_lines(self):
        size = ("--control-points", "8", "--knots", "uniform", "--correct", "6", "--between", "off", "--force")
        none, fair = [self.run_json("fit", MASK, *size, "--fairness", x, "-o", "s.json", "-o", "s.png")["correction"]
                      for x in ("0", "100")]
        self.assertLess(fair["folds"]["normal_angle"], none["folds"]["normal_angle"])
        plain = (self.folder / "s.png").read_bytes()
        self.run_tool("fit", MASK, "--options", "s.json", "-o", "s.png", "--reflections", "--force")
        self.assertNotEqual((self.folder / "s.png").read_bytes(), plain)
        self.run_tool("convert", "s.json", "-o", "a.png")
        self.run_tool("convert", "s.json", "-o", "b.png", "--reflections")
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.refused("fit", MASK, *size, "--fairness", "-1", words=["--fairness", "-1"])
        self.refused("fit", MASK, "--control-points", "8", "--correct", "off", "--fairness", "2",
                     words=["--fairness 2", "--correct"])

    def test_a_correction_is_judged_by_the_distance(self):
        size = ("--control-points", "14", "--knots", "uniform", "--tol", "0.5%")
        self.run_json("fit", MASK, *size, "--correct", "off", status=3)
        report = self.run_json("fit", MASK, *size)
        self.assertTrue(report["reached"])
        text = self.run_tool("fit", MASK, *size).stdout
        for word in ("corrected in 30 rounds", "surface to mesh: max", "folds: 0 %", ": reached"):
            self.assertIn(word, text)

    def test_a_search_corrects_at_every_size(self):
        ask = ("--tol", "0.5%", "--knots", "uniform", "--threads", "1")
        report = self.run_json("fit", MASK, *ask, "-o", "s.json")
        self.assertEqual(report["status"], "reached")
        self.run_json("fit", MASK, *ask, "--correct", "off", "--max-control-points",
                      str(2 * report["control_points"]), status=3)
        self.assertLessEqual(report["error"]["max"], report["tolerance"]["value"])
        self.assertLessEqual(report["correction"]["folds"]["blurred"], 1e-3)
        distance = self.run_json("distance", "s.json", MASK, "--samples", "0")["points_to_surface"]
        self.assertAlmostEqual(distance["max"], report["error"]["max"], delta=1e-9)
        # A share of the points asks for less; the limit on control points is kept, and said.
        most = self.run_json("fit", MASK, *ask, "--within", "95%")
        self.assertLessEqual(most["control_points"], report["control_points"])
        few = self.run_json("fit", MASK, *ask, "--max-control-points", "40", status=3)
        self.assertEqual(few["status"], "limit_reached")
        self.assertLessEqual(few["control_points"], 40)

    def test_a_size_that_folds_is_corrected_from_the_map_again(self):
        head = Path(os.environ.get("KNOTFIT_DATA", "")) / "cowhead.obj"
        if not head.is_file():
            self.skipTest("KNOTFIT_DATA has no cowhead.obj")
        report = self.run_json("fit", head, "--tol", "1%", "--knots", "uniform", "--max-control-points", "400")
        self.assertEqual(report["status"], "reached")
        self.assertLessEqual(report["control_points"], 256)
        self.assertLessEqual(report["correction"]["folds"]["blurred"], 1e-3)
        self.assertEqual(report["correction"]["folds"]["flipped_triangles"], 0)

    def test_what_cannot_be_corrected_is_refused(self):
        self.write_sheet()
        self.refused("fit", "sheet.obj", "--correct", "5", "--tol", "1%", "--refine", "insert", words=["--refine search"])
        self.refused("fit", "sheet.obj", "--correct", "many", "--control-points", "6", words=["--correct", "whole number"])
        self.write_heights()
        self.refused("fit", "heights.csv", "--height-field", "--correct", "5", "--control-points", "6",
                     words=["height fields keep their parameters"])

    def test_holes_are_filled_and_are_no_data(self):
        self.write_sheet(hole=True)
        self.refused("fit", "sheet.obj", words=["--fill-holes"])
        report = self.run_json("fit", "sheet.obj", "--fill-holes", "--control-points", "6", "-o", "s.json")
        self.assertEqual(report["input"]["mesh"]["filled_holes"], 1)
        self.assertEqual(report["input"]["points"], 168)  # the vertex inside the hole is used by no face
        again = self.run_json("fit", "sheet.obj", "--options", "s.json")
        self.assertEqual(again["error"], report["error"])
        self.refused("fit", "sheet.obj", "--options", "s.json", "--no-fill-holes", words=["--fill-holes"])

    def test_as_a_height_field(self):
        self.write_sheet()
        report = self.run_json("fit", "sheet.obj", "--height-field", "--tol", "1%")
        self.assertTrue(report["reached"])
        self.assertTrue(report["input"]["height_field"])

    def test_new_parameters_in_place_of_those_of_the_file(self):
        self.write_sheet()
        self.run_tool("parameterize", "sheet.obj", "--corners", "2,13,169,157", "-o", "uv.ply")
        given = self.run_json("fit", "uv.ply", "--control-points", "6")
        new = self.run_json("fit", "uv.ply", "--control-points", "6", "--new-parameters")
        self.assertIsNone(given["input"]["mesh"]["map"])
        self.assertEqual(new["input"]["mesh"]["map"]["flipped"], 0)


class ManyVertices(MeshTest):
    def test_a_sample_is_mapped_and_every_vertex_is_judged(self):
        self.write_sheet(n=150)
        self.write("sheet.obj", (self.folder / "sheet.obj").read_text() + "v 0.5 0.5 3\n")  # without a face
        report = self.run_json("fit", "sheet.obj", "--engine", "sample", "--tol", "2%", "-o", "s.json", "-o", "errors.csv", "-o", "map.png",
                               status=3)
        mesh = report["input"]["mesh"]
        self.assertEqual((mesh["vertices"], mesh["triangles"]), (151 * 151, 2 * 150 * 150))
        self.assertTrue(5000 < mesh["sample"] < 21000)
        self.assertEqual(report["input"]["points"], 151 * 151)
        self.assertEqual(report["sample"], mesh["sample"])
        self.assertEqual(report["status"], "not_reached")  # the loose vertex counts
        self.assertLessEqual(report["error"]["max"], report["tolerance"]["value"])
        rows = self.read_csv((self.folder / "errors.csv").read_text())
        self.assertEqual(len(rows), 151 * 151 + 1)
        self.assertEqual(max(r["error"] for r in rows[:-1]), report["error"]["max"])
        self.assertGreater(rows[-1]["error"], 2)
        back = self.run_json("distance", "s.json", "sheet.obj")["surface_to_mesh"]
        self.assertAlmostEqual(back["max"], report["correction"]["surface_to_mesh"]["max"], delta=0.05 * back["max"])

    def test_what_is_given_stays_whole(self):
        self.write_sheet(n=30)
        report = self.run_json("fit", "sheet.obj", "--engine", "sample", "--control-points", "6")
        self.assertEqual(report["input"]["mesh"]["sample"], 0)


class Outputs(MeshTest):
    def test_surfaces_as_meshes(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--control-points", "7x6", "-o", "s.json", "-o", "s.obj", "-o",
                               "s.ply", "-o", "s.vts", "--samples", "3")
        self.assertEqual(report["outputs"], ["s.json", "s.obj", "s.ply", "s.vts"])
        # 4 x 3 spans of 3 samples.
        for name in ("s.obj", "s.ply"):
            info = self.run_json("info", name)
            self.assertEqual((info["points"], info["triangles"], info["disk"]), (13 * 10, 2 * 12 * 9, True))
            self.assertEqual(info["ranges"]["u"], [0, 1])
        grid = (self.folder / "s.vts").read_text()
        self.assertIn('WholeExtent="0 12 0 9 0 0"', grid)
        for name in ("error", "normal", "mean_curvature", "gaussian_curvature"):
            self.assertIn(f'Name="{name}"', grid)
        # The same surface later, without errors.
        self.run_tool("convert", "s.json", "-o", "t.obj", "-o", "t.ply", "-o", "t.vts", "--samples", "3")
        self.assertEqual((self.folder / "s.obj").read_text(), (self.folder / "t.obj").read_text())
        self.assertNotIn('Name="error"', (self.folder / "t.vts").read_text())

    def test_the_largest_error_is_in_the_mesh(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--control-points", "5", "-o", "s.ply")
        data = (self.folder / "s.ply").read_bytes()
        header, body = data.split(b"end_header\n")
        names = [line.split()[2].decode() for line in header.splitlines() if line.startswith(b"property double")]
        count = int(next(line for line in header.splitlines() if line.startswith(b"element vertex")).split()[2])
        rows = list(struct.iter_unpack(f"<{len(names)}d", body[:8 * len(names) * count]))
        errors = [row[names.index("error")] for row in rows]
        self.assertEqual(max(e for e in errors if not math.isnan(e)), report["error"]["max"])

    def test_height_fields_stand_in_space(self):
        self.write_raster()
        self.run_tool("fit", "terrain.asc", "--control-points", "6", "-o", "s.obj")
        ranges = self.run_json("info", "s.obj")["ranges"]
        for got, wanted in zip(ranges["x"] + ranges["y"], [11, 69, 21.5, 78.5]):
            self.assertAlmostEqual(got, wanted, delta=1e-12 * wanted)

    def test_meshes_become_other_meshes_and_tables(self):
        self.write_sheet()
        self.run_tool("convert", "sheet.obj", "-o", "a.ply", "-o", "a.csv")
        self.run_tool("convert", "a.ply", "-o", "b.obj")
        self.assertEqual(self.run_json("info", "b.obj")["triangles"], 288)
        self.assertEqual(len(self.rows("a.csv")[1]), 169)
        self.refused("convert", "sheet.obj", "-o", "a.vts", words=["a .vts holds a fitted surface"])
        self.refused("convert", "a.csv", "-o", "c.ply", words=["a .ply holds a mesh or a surface"])
        self.assertEqual(self.files(), ["a.csv", "a.ply", "b.obj", "sheet.obj"])

    def test_a_mesh_has_places_to_check_a_surface_at(self):
        self.write_sheet()
        self.run_tool("parameterize", "sheet.obj", "-o", "uv.obj")
        self.run_tool("fit", "uv.obj", "--tol", "1%", "-o", "s.json")
        summary = self.run_tool("eval", "s.json", "--points", "uv.obj", "--json").stdout
        self.assertIn('"rows"', summary)


class Samples(MeshTest):
    def test_the_face_is_a_disk(self):
        info = self.run_json("info", SAMPLES / "face.obj")
        self.assertEqual((info["points"], info["triangles"], info["disk"]), (17157, 34144, True))


if __name__ == "__main__":
    unittest.main(verbosity=2)
