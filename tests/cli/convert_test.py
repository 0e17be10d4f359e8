"""`knotfit info` and `knotfit convert`."""

import json
import math
import struct
import unittest

from harness import BAD, ToolTest, wave


class Info(ToolTest):
    def test_of_a_surface(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--tol", "1%", "-o", "s.json")
        info = self.run_json("info", "s.json")
        self.assertEqual((info["kind"], info["size"], info["degree"]), ("surface", report["size"], [3, 3]))
        self.assertEqual((info["dimension"], info["height_field"]), (3, False))
        self.assertEqual(info["knots"], report["knots"])
        self.assertEqual(info["options"], report["options"])
        self.assertEqual(info["result"]["error"], report["error"])
        self.assertEqual(len(info["net_bounds"]), 3)
        text = self.run_tool("info", "s.json").stdout
        for word in ("control points", "degree 3 x 3", "interior knots", "domain: u 0 to 1", "points.csv", "reached"):
            self.assertIn(word, text)

    def test_of_a_surface_by_another_program(self):
        self.write("s.json", json.dumps({"degree": [1, 1], "knots_u": [0, 0, 1, 1], "knots_v": [0, 0, 1, 1],
                                         "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 5]]]}))
        info = self.run_json("info", "s.json")
        self.assertEqual((info["size"], info["options"], info["result"]), ([2, 2], None, None))
        self.assertEqual(info["net_bounds"], [[0, 1], [0, 1], [0, 5]])
        self.run_tool("info", "s.json")

    def test_of_data(self):
        self.write_points()
        info = self.run_json("info", "points.csv")
        self.assertEqual((info["kind"], info["content"], info["points"]), ("data", "points", 600))
        self.assertEqual(list(info["ranges"]), ["x", "y", "z", "u", "v"])
        self.assertIn("parameters u, v", info["read_as"])
        self.write_heights()
        self.assertIn("--height-field", self.run_tool("info", "heights.csv").stdout)
        self.write_raster(hole=lambda r, c: r == 0)
        info = self.run_json("info", "terrain.asc")
        self.assertEqual((info["columns"], info["rows"], info["holes"], info["points"]), (30, 20, 30, 570))
        self.assertEqual((info["cell"], info["ranges"]["x"], info["ranges"]["y"]), ([2, 3], [11, 69], [21.5, 78.5]))
        text = self.run_tool("info", "terrain.asc").stdout
        for word in ("raster of heights", "holes: 30", "cell: 2 x 3", "x: 11 to 69"):
            self.assertIn(word, text)
        self.write("rows.txt", "0 0 0\n1 0 0\n2 0 1\n\n0 1 0\n1 1 0\n2 1 1\n")
        info = self.run_json("info", "rows.txt")
        self.assertEqual((info["content"], info["rows"], info["points_a_row"]), ("grid of points", 2, 3))

    def test_of_a_file_that_is_none(self):
        self.refused("info", BAD / "bad_columns.csv", words=["bad_columns.csv:25: "])
        self.refused("info", "missing.csv", words=["missing.csv"])
        self.write("broken.json", '{"degree": [3, 3]')
        self.refused("info", "broken.json", words=["broken.json"])


class Convert(ToolTest):
    def fit_terrain(self):
        self.write_raster()
        self.run_tool("fit", "terrain.asc", "--tol", "1%", "-o", "s.json", "-o", "fitted.asc")

    def test_a_surface_to_itself(self):
        self.fit_terrain()
        self.run_tool("convert", "s.json", "-o", "t.json")
        self.assertEqual((self.folder / "s.json").read_bytes(), (self.folder / "t.json").read_bytes())

    def test_a_surface_to_heights(self):
        self.fit_terrain()
        self.run_tool("convert", "s.json", "-o", "own.asc", "-o", "own.grd")
        self.assertEqual((self.folder / "own.asc").read_bytes(), (self.folder / "fitted.asc").read_bytes())
        self.run_tool("convert", "s.json", "--cell", "4x6", "-o", "coarse.asc")
        head, cells = self.read_raster("coarse.asc")
        self.assertEqual((head["ncols"], head["nrows"], head["dx"], head["dy"]), (15, 10, 4, 6))
        _, fitted = self.read_raster("fitted.asc")
        for r in range(10):
            for c in range(15):
                self.assertAlmostEqual(cells[r][c], fitted[2 * r + 1][2 * c], 12)
        self.run_tool("convert", "s.json", "--cell", "4", "-o", "square.asc")
        self.assertEqual(self.read_raster("square.asc")[0]["nrows"], 15)

    def test_scattered_heights_need_a_cell(self):
        self.write_heights()
        self.run_tool("fit", "heights.csv", "--height-field", "--tol", "1%", "-o", "s.json")
        self.refused("convert", "s.json", "-o", "a.asc", words=["--cell"])
        self.run_tool("convert", "s.json", "--cell", "0.1", "-o", "a.asc")
        self.refused("convert", "s.json", "--cell", "1e-12", "-o", "b.asc", words=["--cell"])

    def test_a_surface_to_pictures_and_samples(self):
        self.fit_terrain()
        self.run_tool("convert", "s.json", "-o", "a.png", "-o", "a.svg", "-o", "a.pdf", "-o", "a.csv")
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG"))
        rows = self.read_csv((self.folder / "a.csv").read_text())
        self.assertEqual(len(rows), 100 * 100)
        self.run_tool("convert", "s.json", "--grid", "4x3", "-o", "b.csv")
        rows = self.read_csv((self.folder / "b.csv").read_text())
        self.assertEqual((len(rows), list(rows[0]), rows[-1]["x"], rows[-1]["y"]), (12, ["x", "y", "z"], 69, 78.5))

    def test_a_surface_in_space_has_no_heights(self):
        self.write_points()
        self.run_tool("fit", "points.csv", "--control-points", "5", "-o", "s.json")
        self.refused("convert", "s.json", "--cell", "0.1", "-o", "a.asc", words=["height field"])
        self.run_tool("convert", "s.json", "-o", "a.svg")

    def test_a_raster_to_points_and_back(self):
        self.write_raster(hole=lambda r, c: (r, c) == (3, 4))
        self.run_tool("convert", "terrain.asc", "-o", "points.csv")
        rows = self.read_csv((self.folder / "points.csv").read_text())
        self.assertEqual((len(rows), list(rows[0]), rows[0]["x"], rows[0]["y"]), (599, ["x", "y", "z"], 11, 78.5))
        self.run_tool("convert", "points.csv", "-o", "back.asc")
        head, cells = self.read_raster("back.asc")
        head_given, given = self.read_raster("terrain.asc")
        for name in ("ncols", "nrows", "xllcorner", "yllcorner", "dx", "dy"):
            self.assertAlmostEqual(head[name], head_given[name], 12)
        self.assertEqual(cells, given)

    def test_points_on_no_grid_become_no_raster(self):
        self.write_heights()
        self.refused("convert", "heights.csv", "-o", "a.asc", words=["grid", "--cell"])
        self.write("twice.csv", "x,y,z\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n1,1,2\n")
        self.refused("convert", "twice.csv", "-o", "a.asc", words=["line 6", "second point"])
        self.write("line.csv", "x,y,z\n0,0,1\n1,0,1\n2,0,1\n")
        self.refused("convert", "line.csv", "-o", "a.asc", words=["all are equal"])

    def test_an_array_to_a_raster_and_to_points(self):
        header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }"
        header += b" " * (63 - (10 + len(header)) % 64) + b"\n"
        values = struct.pack("<12d", *range(11), math.nan)
        (self.folder / "a.npy").write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + values)
        self.run_tool("convert", "a.npy", "-o", "a.asc", "-o", "a.csv")
        head, cells = self.read_raster("a.asc")
        self.assertEqual(cells, [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, head["nodata_value"]]])
        self.assertEqual(len(self.read_csv((self.folder / "a.csv").read_text())), 11)

    def test_points_keep_their_columns(self):
        self.write("p.xyz", "x y z u v w\n0 1 2 0 0 1\n1 1 2 1 0.5 2\n")
        self.run_tool("convert", "p.xyz", "-o", "p.csv")
        self.assertEqual((self.folder / "p.csv").read_text(), "x,y,z,u,v,w\n0,1,2,0,0,1\n1,1,2,1,0.5,2\n")

    def test_what_makes_no_sense_is_refused(self):
        self.write_raster()
        self.refused("convert", "terrain.asc", words=["--output"])
        self.refused("convert", "terrain.asc", "-o", "a.png", words=["a.png", "knotfit fit"])
        self.refused("convert", "terrain.asc", "-o", "a.json", words=["a.json", "knotfit fit"])
        self.refused("convert", "terrain.asc", "-o", "a.step", words=["a.step", "knotfit fit"])
        self.refused("convert", "terrain.asc", "-o", "a.tif", words=["not supported by this version"])
        self.refused("convert", "terrain.asc", "-o", "terrain.asc", "--force", words=["is the input"])
        self.refused("convert", "terrain.asc", "-o", "missing/a.csv", words=["missing"])
        self.write("cloud.vtp", "<VTKFile>")
        self.refused("convert", "cloud.vtp", "-o", "a.csv", words=["VTK", "meshio convert cloud.vtp cloud.ply"])
        self.assertEqual(self.files(), ["cloud.vtp", "terrain.asc"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
