"""Files of public reports, and others of their kind: meshes, CAD files and grids with a pole.

Each row says what a file gives: the values read, or the refusal with the way out.
"""

import json
import math
import struct
import unittest
from pathlib import Path

from harness import BAD, ToolTest

REPORTS = Path(__file__).with_name("reports")
MESH = {"points": 81, "triangles": 128, "parts": 1, "boundary_loops": 1, "euler_characteristic": 1, "disk": True}
SIZE = ("--control-points", "8", "--knots", "uniform", "--between", "off")


def height(x, y):
    """The sheet of the reports' meshes."""
    return 0.4 * math.sin(1.3 * x) * math.cos(y)


def grid(n=8, m=8, places=6):
    """Vertices and triangles of a sheet over [0,4] x [0,3]."""
    vertices = [(4 * i / n, 3 * j / m, round(height(4 * i / n, 3 * j / m), places)) for j in range(m + 1) for i in range(n + 1)]
    faces = []
    for j in range(m):
        for i in range(n):
            a = j * (n + 1) + i
            faces += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
    return vertices, faces


def soup(vertices, faces):
    """Corners of their own for each face."""
    return [vertices[k] for f in faces for k in f], [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(faces))]


def obj(vertices, faces, uv=None):
    lines = ["v {} {} {}".format(*v) for v in vertices]
    lines += ["vt {} {}".format(*t) for t in uv or []]
    face = "f {0}/{0} {1}/{1} {2}/{2}" if uv else "f {} {} {}"
    return "\n".join(lines + [face.format(*(k + 1 for k in f)) for f in faces]) + "\n"


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"] + ["{} {} {}".format(*v) for v in vertices]
    return "\n".join(lines + ["3 {} {} {}".format(*f) for f in faces]) + "\n"


def ply(vertices, faces, uv=None):
    lines = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}"]
    lines += [f"property double {name}" for name in ("xyzst" if uv else "xyz")]
    lines += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(map(repr, v + tuple(t))) for v, t in zip(vertices, uv or [()] * len(vertices))]
    return "\n".join(lines + ["3 {} {} {}".format(*f) for f in faces]) + "\n"


def stl(vertices, faces):
    """Binary, in single precision."""
    out = b"made by hand".ljust(80) + struct.pack("<I", len(faces))
    for f in faces:
        out += struct.pack("<12f", 0, 0, 1, *(x for k in f for x in vertices[k])) + b"\0\0"
    return out


def next_float(x):
    """The next number of single precision."""
    bits, = struct.unpack("<i", struct.pack("<f", x))
    return struct.unpack("<f", struct.pack("<i", bits + 1))[0]


class ReportsTest(ToolTest):
    def info(self, *arguments):
        return self.run_json("info", *arguments)

    def assert_facts(self, info, **facts):
        for name, value in facts.items():
            self.assertEqual(info[name], value, name)

    def assert_note(self, report, *words):
        self.assertTrue(any(all(w in note for w in words) for note in report["notes"]), (words, report["notes"]))

    def assert_no_note(self, report, word):
        self.assertFalse(any(word in note for note in report["notes"]), report["notes"])


class Welding(ReportsTest):
    def test_of_the_report(self):
        path = REPORTS / "split_corners.obj"
        info = self.info(path)
        self.assert_facts(info, **MESH, welded=175, problem=None)
        self.assert_note(info, "welded: 175 vertices", "--weld off")
        report = self.run_json("fit", path, *SIZE)
        self.assertEqual((report["input"]["points"], report["input"]["welded"]), (81, 175))
        self.assertEqual(report["input"]["mesh"]["triangles"], 128)
        self.assert_note(report, "welded: 175 vertices")
        self.assertLess(report["error"]["max"], 0.005)
        # The same as without copies, whose file has a vertex a place in the same order of first use.
        self.assertIn("note: welded: 175 vertices", self.run_tool("fit", path, *SIZE).stdout)
        self.refused("fit", path, *SIZE, "--weld", "off", words=["64 parts", "--weld 1e-05% makes one part of them"])
        self.assert_facts(self.info(path, "--weld", "off"), points=256, parts=64, welded=0, disk=False)
        again = self.run_json("fit", path, *SIZE, "--weld", "0.01%", "-o", "s.json")
        self.assertEqual(again["error"], report["error"])
        self.assertEqual(again["options"]["weld"], "0.01%")
        self.assertEqual(self.run_json("fit", path, "--options", "s.json")["error"], report["error"])

    def test_in_every_format_and_command(self):
        vertices, faces = grid()
        copies = soup(vertices, faces)
        self.write("a.obj", obj(*copies))
        self.write("a.off", off(*copies))
        self.write("a.ply", ply(*copies))
        (self.folder / "a.stl").write_bytes(stl(*copies))
        for name in ("a.obj", "a.off", "a.ply"):
            self.assert_facts(self.info(name), **MESH, welded=384 - 81)
            self.assertEqual(self.run_json("parameterize", name, "--omega", "0", "--corners", "sharpest")["welded"], 303)
        self.assert_facts(self.info("a.stl"), **MESH)  # equal corners of an STL are one vertex anyway
        self.run_tool("fit", "a.obj", *SIZE, "-o", "s.json")
        distance = self.run_json("distance", "s.json", "a.off", "--samples", "0")
        self.assertEqual(distance["points_to_surface"]["count"], 81)
        self.assert_note(distance, "welded: 303")
        said = self.run_tool("convert", "a.obj", "-o", "b.ply").stdout
        self.assertIn("note: welded: 303 vertices", said)
        self.assert_facts(self.info("b.ply"), **MESH, welded=0)
        self.run_tool("convert", "a.obj", "-o", "c.ply", "--weld", "off")
        self.assert_facts(self.info("c.ply", "--weld", "off"), points=384, parts=128)
        # Corners are named by the file's own numbers.
        self.run_json("parameterize", "a.off", "--corners", "0,0,0;4,0,0;4,3,0;0,3,0", "-o", "uv.csv")
        rows = self.read_csv((self.folder / "uv.csv").read_text())
        corner = {(r["x"], r["y"]): (r["u"], r["v"]) for r in rows}
        self.assertEqual([corner[p] for p in ((0, 0), (4, 0), (4, 3), (0, 3))], [(0, 0), (1, 0), (1, 1), (0, 1)])

    def test_copies_that_differ_in_the_last_bit(self):
        vertices, faces = grid()
        for shift in (0, 1000):
            at = [struct.unpack("<3f", struct.pack("<3f", x + shift, y + shift, z + shift)) for x, y, z in vertices]
            copies = [tuple(next_float(c) if (k + d) % 2 else c for d, c in enumerate(v))
                      for k, v in enumerate(soup(at, faces)[0])]
            cells = soup(at, faces)[1]
            (self.folder / "a.stl").write_bytes(stl(copies, cells))
            self.write("a.obj", obj([tuple(map(repr, v)) for v in copies], cells))
            text = "".join(" facet normal 0 0 1\n  outer loop\n" + "".join("   vertex {!r} {!r} {!r}\n".format(*copies[k]) for k in f) +
                           "  endloop\n endfacet\n" for f in cells)
            self.write("text.stl", "solid a\n" + text + "endsolid a\n")
            for name in ("a.stl", "text.stl", "a.obj"):
                with self.subTest(name=name, shift=shift):
                    info = self.info(name)
                    self.assert_facts(info, **MESH)
                    self.assertGreater(info["welded"], 0)

    def test_never_across_a_slit_that_is_wider(self):
        vertices, faces = grid()
        left = [f for k, f in enumerate(faces) if k // 2 % 8 < 4]
        right = [f for k, f in enumerate(faces) if k // 2 % 8 >= 4]
        for width, parts in ((0, 1), (1e-7, 1), (1e-6, 2), (1e-3, 2)):  # the diagonal is 5.06
            other = [(x + width, y, z) for x, y, z in vertices]
            both = left + [tuple(k + 81 for k in f) for f in right]
            self.write("a.obj", obj([tuple(map(repr, v)) for v in vertices + other], both))
            with self.subTest(width=width):
                self.assertEqual(self.info("a.obj")["parts"], parts)
        self.refused("fit", "a.obj", *SIZE, words=["2 parts", "--weld 0.1% makes one part of them"])
        self.assertIn("--weld 0.1% makes one part of them", self.info("a.obj")["problem"])
        self.assertEqual(self.info("a.obj", "--weld", "0.002")["parts"], 1)
        self.assertEqual(self.info("a.obj", "--weld", "0.1%")["parts"], 1)
        self.refused("info", "a.obj", "--weld", "2%", words=["--weld", "at most 1 %"])
        for text in ("-1", "many", "nan", "1e999"):
            self.refused("info", "a.obj", "--weld", text, words=["--weld", text])
        self.write_points()
        self.refused("fit", "points.csv", "--weld", "0.1", words=["points.csv: --weld does not apply to a file of format csv: it joins the vertices of meshes"])

    def test_a_tube_that_was_cut_open_stays_a_disk(self):
        n, m = 16, 5
        vertices = [(math.cos(2 * math.pi * (i % n) / n), math.sin(2 * math.pi * (i % n) / n), j / m)
                    for j in range(m + 1) for i in range(n + 1)]
        faces = [f for j in range(m) for i in range(n) for a in [j * (n + 1) + i]
                 for f in ((a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1))]
        self.write("tube.obj", obj(vertices, faces))
        info = self.info("tube.obj")
        self.assert_facts(info, points=(n + 1) * (m + 1), boundary_loops=1, disk=True, welded=0)
        self.assert_note(info, "6 vertices", "left apart", "cut open")
        # As the outline of a map it has 4 corners at the cut.
        self.assertEqual(self.run_json("parameterize", "tube.obj")["map"]["flipped"], 0)

    def test_degenerate_faces_stay_what_they_are(self):
        self.refused("fit", BAD / "bad_degenerate.off", words=["vertices 14 and 15 are at the same place", "--drop-degenerate"])
        vertices, faces = grid()
        copies, cells = soup(vertices, faces)
        first = len(copies)
        copies += [vertices[0], vertices[1], vertices[1]]
        cells += [(first, first + 1, first + 2)]
        self.write("a.off", off(copies, cells))
        self.refused("fit", "a.off", *SIZE, words=["no area", "its corner twice", "--drop-degenerate"])
        report = self.run_json("fit", "a.off", *SIZE, "--drop-degenerate")
        self.assertEqual((report["input"]["points"], report["input"]["mesh"]["dropped_faces"]), (81, 1))


class TwoSided(ReportsTest):
    def test_in_every_format_and_command(self):
        vertices, faces = grid()
        front = len(faces)
        both = faces + [tuple(reversed(f)) for f in faces]
        self.write("one.obj", obj(vertices, faces))
        self.write("m.obj", obj(vertices, both))
        self.write("m.off", off(vertices, both))
        self.write("m.ply", ply(vertices, both))
        (self.folder / "m.stl").write_bytes(stl(vertices, both))
        self.write("soup.obj", obj(*soup(vertices, both)))
        ask = ["--control-points", "6", "--knots", "uniform", "--correct", "off"]
        one = self.run_json("fit", "one.obj", *ask)
        for name in ("m.obj", "m.off", "m.ply", "m.stl", "soup.obj"):
            with self.subTest(file=name):
                info = self.info(name)
                self.assert_facts(info, vertices=len(vertices), triangles=front, parts=1, boundary_loops=1, disk=True)
                note = f"{front} faces are there a second time, with the same corners in the opposite order"
                self.assert_note(info, note, "one of each is kept")
                fit = self.run_json("fit", name, *ask)
                self.assert_note(fit, note)
                self.assertEqual(fit["input"]["points"], len(vertices))
                if name != "m.stl":  # single precision
                    self.assertAlmostEqual(fit["error"]["rms"], one["error"]["rms"], delta=1e-9)
        self.assert_no_note(self.info("one.obj"), "second time")


class TextureCoordinates(ReportsTest):
    def fit(self, name):
        return self.run_json("fit", name, *SIZE)

    def assert_mapped(self, name, why, points=81):
        """The mesh is mapped, the reason told, and --duplicates not advised."""
        report = self.fit(name)
        mesh = report["input"]["mesh"]
        self.assertEqual((report["input"]["points"], mesh["parameters"], mesh["map"]["flipped"]), (points, "map", 0))
        self.assertLess(report["error"]["max"], 0.01)
        self.assert_note(report, "texture coordinates", "left aside", why)
        self.assertNotIn("--duplicates", json.dumps(report["notes"]))
        self.assertIn("left aside", self.run_tool("fit", name, *SIZE).stdout)
        info = self.info(name)
        self.assertIn("map of the mesh", info["read_as"])
        self.assertIn(why, info["read_as"] + " ".join(info["notes"]))

    def test_of_the_reports(self):
        self.assert_mapped(REPORTS / "one_vt_for_all.obj", "equal at all vertices, u = 0 and v = 0")
        self.assert_mapped(REPORTS / "vt_mirrored.obj", "64 of 128 triangles are mirrored")

    def test_that_are_no_parameters(self):
        vertices, faces = grid()
        kinds = {"on a line": lambda x, y: (x / 4, 0.25), "they lie on a line": lambda x, y: (x / 4, 1 - x / 4),
                 "mirrored": lambda x, y: (abs(x / 2 - 1), y / 3),
                 "those of another vertex": None,
                 "of the vertices have none": lambda x, y: ("nan", y / 3) if x == 4 else (x / 4, y / 3),
                 "cover each other": lambda x, y: (0.5 + 0.1 * (1 + y) * math.cos(1.95 * x), 0.5 + 0.1 * (1 + y) * math.sin(1.95 * x))}
        for why, f in kinds.items():
            with self.subTest(why):
                if f is None:
                    # Two charts, one over the other, split where they meet.
                    left = [t for k, t in enumerate(faces) if k // 2 % 8 < 4]
                    right = [tuple(v + 81 for v in t) for k, t in enumerate(faces) if k // 2 % 8 >= 4]
                    places = vertices + vertices
                    uv = [(x / 2 % 1.0001, y / 3) for x, y, _ in vertices] + [(x / 2 - 1, y / 3) for x, y, _ in vertices]
                    self.write("a.ply", ply(places, left + right, uv))
                    report = self.fit("a.ply")
                    self.assertEqual((report["input"]["points"], report["input"]["welded"]), (81, 9))
                    self.assert_note(report, "texture coordinates", "left aside", "seam")
                    continue
                self.write("a.obj", obj(vertices, faces, [f(x, y) for x, y, _ in vertices]))
                self.assert_mapped("a.obj", why)

    def test_a_seam_and_missing_ones_are_said(self):
        vertices, faces = grid()
        text = obj(vertices, faces, [(x / 4, y / 3) for x, y, _ in vertices])
        self.write("seam.obj", text.replace("f 1/1 2/2", "f 1/5 2/2", 1))
        self.assert_mapped("seam.obj", "a seam between charts")
        self.write("bare.obj", text.replace("f 1/1 11/11 10/10", "f 1/1 11/11 10").replace("/10 ", " ").replace("/10\n", "\n"))
        self.assert_mapped("bare.obj", "of the vertices ha")
        self.write("wrong.obj", text.replace("f 1/1 2/2", "f 1/500 2/2", 1))
        self.assert_mapped("wrong.obj", "names texture vertex 500")

    def test_are_used_where_they_are_one_to_one(self):
        vertices, faces = grid()
        copies, cells = soup(vertices, faces)
        uv = [((x / 4) ** 2 / 2 + x / 8, 1 - y / 3) for x, y, _ in vertices]
        self.write("a.obj", obj(vertices, faces, uv))
        self.write("a.ply", ply(copies, cells, soup(uv, faces)[0]))
        for name in ("a.obj", "a.ply"):
            report = self.fit(name)
            mesh = report["input"]["mesh"]
            self.assertEqual((report["input"]["points"], mesh["parameters"], mesh["left_aside"], mesh["map"]),
                             (81, "file", None, None))
            self.assert_no_note(report, "left aside")
            self.assertIn("parameters: the file's own (texture coordinates), one-to-one", self.run_tool("fit", name, *SIZE).stdout)
        self.write("large.obj", obj(vertices, faces, [(x, y) for x, y, _ in vertices]))
        self.refused("fit", "large.obj", words=["outside [0,1]", "--rescale-parameters", "--new-parameters"])
        self.assertEqual(self.run_json("fit", "large.obj", *SIZE, "--rescale-parameters")["input"]["mesh"]["parameters"], "file")

    def test_left_aside_where_the_mesh_cannot_be_mapped_says_both(self):
        vertices, faces = grid()
        hole = [f for k, f in enumerate(faces) if k // 2 not in (27, 28)]
        self.write("a.obj", obj(vertices, hole, [(0.5, 0.5)] * 81))
        self.refused("fit", "a.obj", *SIZE, words=["texture coordinates", "equal at all vertices", "2 boundary loops"])

    def test_options_of_the_map_apply_where_they_are_left_aside(self):
        vertices, faces = grid()
        self.write("a.obj", obj(vertices, faces, [(abs(x / 2 - 1), y / 3) for x, y, _ in vertices]))
        report = self.run_json("fit", "a.obj", *SIZE, "--omega", "0", "--corners", "sharpest")
        self.assertEqual((report["input"]["mesh"]["parameters"], report["input"]["mesh"]["map"]["omega"]), ("map", 0))
        self.refused("fit", "a.obj", *SIZE, "--rescale-parameters", words=["--rescale-parameters does not apply to a mesh"])
        self.write("b.obj", obj(vertices, faces, [(x / 4, y / 3) for x, y, _ in vertices]))
        self.refused("fit", "b.obj", *SIZE, "--omega", "0", words=["--omega does not apply", "parameters of their own"])

    def test_conversion_keeps_them(self):
        vertices, faces = grid()
        self.write("a.obj", obj(vertices, faces, [(abs(x / 2 - 1), y / 3) for x, y, _ in vertices]))
        self.run_tool("convert", "a.obj", "-o", "b.ply")
        self.assertEqual(self.info("b.ply")["ranges"]["u"], [0, 1])


class WhatIsIgnored(ReportsTest):
    """Stops nothing: the same mesh comes of all of them."""

    def assert_sheet(self, name, *note):
        info = self.info(name)
        self.assert_facts(info, **MESH)
        self.assertEqual((info["ranges"]["x"], info["ranges"]["y"]), ([0, 4], [0, 3]))
        if note:
            self.assert_note(info, *note)
        else:
            self.assertEqual(info["notes"], [])
        report = self.run_json("fit", name, *SIZE)
        self.assertEqual(report["input"]["points"], 81)
        self.assertLess(report["error"]["max"], 0.01)
        if note:
            self.assert_note(report, *note)

    def test_of_the_reports(self):
        for name in ("nan_colour.obj", "lower_case.off", "end_loop.stl"):
            with self.subTest(name):
                self.assert_sheet(REPORTS / name)

    def test_off_in_other_dialects(self):
        text = (REPORTS / "lower_case.off").read_text()
        body = text.split("\n", 2)[2]
        for head in ("OFF81 128 5\n", "OFF 81 128\n", "OFF\n81\n128\n0\n", "Off\n# by hand\n81 128 0\n"):
            self.write("a.off", head + body)
            self.assert_sheet("a.off")
        self.write("a.off", ("off 81 128 0 " + body).replace("\n", " "))
        self.assert_sheet("a.off")
        self.write("a.off", text + "3 0 1 2\n")
        self.assert_sheet("a.off", "a line after the last of 128 faces", "left out")

    def test_stl_in_other_dialects(self):
        text = (REPORTS / "end_loop.stl").read_text()
        for other in (text.replace("end loop", "END LOOP").replace("endfacet", "end facet").replace("endsolid", "end solid"),
                      text.replace("facet normal 0 0 1", "facet normal nan nan nan"), text.replace("\n", " "), text.upper()):
            self.write("a.stl", other)
            self.assert_sheet("a.stl")

    def test_bytes_after_a_binary_stl(self):
        vertices, faces = grid()
        for more in (b"\0", b"\r\n", b"by some program" * 9):
            (self.folder / "a.stl").write_bytes(stl(vertices, faces) + more)
            self.assert_sheet("a.stl", f"{len(more)} bytes follow the last of the 128 triangles")

    def test_words_that_obj_does_not_know(self):
        vertices, faces = grid()
        self.write("a.obj", "vc 1 0 0\n" + obj(vertices, faces))
        self.assert_sheet("a.obj", "line 1", "\"vc\"", "left out")


class Faces(ReportsTest):
    """Of CAD files: one that is not usable does not hide the others."""

    def setUp(self):
        super().setUp()
        formats = json.loads(self.run_tool("formats", "--json").stdout)
        if not any(f["name"] == "step" and f["writes"] for f in formats):
            self.skipTest("built without CAD exchange")

    def test_of_the_report(self):
        path = REPORTS / "two_faces_first_rational.igs"
        info = self.info(path)
        self.assertEqual(info["kind"], "surfaces")
        self.assertEqual([(f["face"], f["kind"], f["usable"]) for f in info["faces"]],
                         [(1, "rational B-spline surface", False), (2, "B-spline surface", True)])
        self.assertIn("weights", info["faces"][0]["why_not"])
        self.assertIsNone(info["faces"][1]["why_not"])
        self.assertEqual([s["face"] for s in info["surfaces"]], [2])
        text = self.run_tool("info", path).stdout
        for word in ("2 faces, 1 usable", "face 1: rational B-spline surface, not usable: ", "face 2: B-spline surface"):
            self.assertIn(word, text)
        self.run_tool("convert", path, "--face", "2", "-o", "two.json")
        self.run_tool("convert", path, "-o", "only.json")
        self.assertEqual(self.load("two.json"), self.load("only.json"))
        self.assertEqual(self.run_json("info", path, "--face", "2")["size"], info["surfaces"][0]["size"])
        self.refused("convert", path, "--face", "1", "-o", "x.json", words=["--face 1", "rational", "--face 2 is usable"])
        self.refused("convert", path, "--face", "3", "-o", "x.json", words=["--face 3: there are 2 surfaces"])
        # The weights are all that is wrong with the first face: the points lie on the second's own surface.
        rows = self.read_csv(self.run_tool("eval", path, "--face", "2", "--grid", "3x3").stdout)
        self.assertEqual(len(rows), 9)

    def roof(self):
        self.write("roof.json", json.dumps({"degree": 1, "knots_u": [0, 0, 0.5, 1, 1], "knots_v": [0, 0, 1, 1],
                                            "control_points": [0, 0, 0, 0, 5, 0, 1, 0, 2, 1, 5, 2, 2, 0, 0, 2, 5, 0]}))
        self.run_tool("convert", "roof.json", "-o", "roof.step", "--cad-safe", "--step-schema", "ap214")
        return (self.folder / "roof.step").read_text()

    def test_step_with_a_rational_face(self):
        text = self.roof()
        # The first surface gets weights, one of them 2.
        at = text.index("= B_SPLINE_SURFACE_WITH_KNOTS('',")
        end = text.index(";", at)
        inside = " ".join(text[at:end].split())[len("= B_SPLINE_SURFACE_WITH_KNOTS('',"):-1]
        depth, parts = 0, [""]
        for c in inside:
            depth += (c == "(") - (c == ")")
            if c == "," and depth == 0:
                parts.append("")
            else:
                parts[-1] += c
        p, q, net, form, u_closed, v_closed, own, mu, mv, ku, kv, spec = [part.strip() for part in parts]
        rows = net.count("(") - 1
        columns = net.count("#") // rows
        weights = ",".join("(" + ",".join("2." if (i, j) == (0, 0) else "1." for j in range(columns)) + ")" for i in range(rows))
        rational = (f"= ( BOUNDED_SURFACE() B_SPLINE_SURFACE({p},{q},{net},{form},{u_closed},{v_closed},{own}) "
                    f"B_SPLINE_SURFACE_WITH_KNOTS({mu},{mv},{ku},{kv},{spec}) GEOMETRIC_REPRESENTATION_ITEM() "
                    f"RATIONAL_B_SPLINE_SURFACE(({weights})) REPRESENTATION_ITEM('') SURFACE() )")
        self.write("r.step", text[:at] + rational + text[end:])
        info = self.info("r.step")
        self.assertEqual(sorted((f["kind"], f["usable"]) for f in info["faces"]),
                         [("B-spline surface", True), ("rational B-spline surface", False)])
        usable = next(f["face"] for f in info["faces"] if f["usable"])
        self.run_tool("convert", "r.step", "--face", usable, "-o", "a.json")
        self.run_tool("convert", "roof.step", "--face", usable, "-o", "b.json")
        self.assertEqual(self.load("a.json")["control_points"], self.load("b.json")["control_points"])
        self.refused("convert", "r.step", "--face", 3 - usable, "-o", "x.json", words=["rational"])

    def test_trimmed_faces_are_told(self):
        self.roof()
        info = self.info("roof.step")
        self.assertEqual([(f["usable"], f["trimmed"]) for f in info["faces"]], [(True, False), (True, False)])


class Poles(ReportsTest):
    def test_of_the_report(self):
        path = REPORTS / "collapsed_row.rows"
        report = self.run_json("fit", path, "--tol", "0.1%", "-o", "s.json", "-o", "r.csv")
        self.assertTrue(report["reached"])
        self.assertEqual(report["input"]["points"], 168)
        rows = self.read_csv((self.folder / "r.csv").read_text())
        first, second = rows[:14], rows[14:28]
        self.assertEqual({(r["x"], r["y"], r["z"]) for r in first}, {(0, 0, 1)})
        # The pole's points have the parameters of the row beside it.
        self.assertEqual([r["u"] for r in first], [r["u"] for r in second])
        self.assertEqual({r["v"] for r in first}, {0})
        self.assertEqual([first[0]["u"], first[-1]["u"]], [0, 1])
        for spacing in ("chord", "centripetal", "uniform"):
            self.run_json("fit", path, *SIZE, "--spacing", spacing)

    def cap(self, n=10, m=7, column=False, noise=0.0):
        """Rows of a cap about its pole: the first row, or column, is the pole."""
        def at(i, j):
            a, b = 1.5 * i / n, 1.2 * j / m
            r = math.sin(b) if j > 0 else noise
            return f"{r * math.cos(a)!r} {r * math.sin(a)!r} {math.cos(b)!r}"
        if column:
            return "\n\n".join("\n".join(at(i, j) for j in range(m + 1)) for i in range(n + 1)) + "\n"
        return "\n\n".join("\n".join(at(i, j) for i in range(n + 1)) for j in range(m + 1)) + "\n"

    def test_as_a_row_as_a_column_and_nearly(self):
        for column in (False, True):
            for noise in (0.0, 6e-17, 4e-8):
                with self.subTest(column=column, noise=noise):
                    self.write("a.rows", self.cap(column=column, noise=noise))
                    report = self.run_json("fit", "a.rows", "--control-points", "6", "--knots", "uniform", "-o", "r.csv", "--force")
                    self.assertLess(report["error"]["max"], 1e-4)
                    rows = self.read_csv((self.folder / "r.csv").read_text())
                    along = sorted({round(r["v" if column else "u"], 9) for r in rows})
                    self.assertEqual(along, [round(i / 10, 9) for i in range(11)])

    def test_written_once(self):
        whole = self.cap().split("\n\n")
        self.write("once.rows", "\n\n".join([whole[0].split("\n")[0]] + whole[1:]))
        self.write("whole.rows", self.cap())
        once, full = (self.run_json("fit", name, "--control-points", "6", "--knots", "uniform") for name in ("once.rows", "whole.rows"))
        self.assertEqual(once["error"]["rms"], full["error"]["rms"])
        self.assert_note(once, "the first row is one point (line 1)", "all 11 points")


if __name__ == "__main__":
    unittest.main()
