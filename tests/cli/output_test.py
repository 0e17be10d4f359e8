"""Output files: by extension, whole or not at all, never one that exists unless asked."""

import json
import os
import subprocess
import unittest
import xml.etree.ElementTree as ET

from harness import TOOL, ToolTest, default_signals, small_files_only, step, wave

SIZE = ("--control-points", "6x6", "--between", "off")


class Outputs(ToolTest):
    def test_the_extension_chooses_the_format(self):
        self.write_raster()
        names = ["a.json", "a.csv", "a.asc", "a.grd", "a.png", "a.svg", "a.PDF"]
        arguments = [word for name in names for word in ("-o", name)]
        report = self.run_json("fit", "terrain.asc", *SIZE, *arguments)
        self.assertEqual(report["outputs"], names)
        self.assertEqual(self.files(), sorted(names + ["terrain.asc"]))
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG\r\n"))
        self.assertTrue((self.folder / "a.PDF").read_bytes().startswith(b"%PDF-"))
        self.assertTrue(ET.parse(self.folder / "a.svg").getroot().tag.endswith("svg"))
        self.assertEqual((self.folder / "a.asc").read_bytes(), (self.folder / "a.grd").read_bytes())

    def test_an_unknown_extension_lists_those_there_are(self):
        self.write_points()
        for name in ("surface", "surface.txt", "surface.xls"):
            with self.subTest(name=name):
                self.refused("fit", "points.csv", *SIZE, "-o", name,
                             words=[name, ".json", ".csv", ".asc", ".grd", ".png", ".svg", ".pdf"])
        for name in ("s.stl", "s.vtk"):
            with self.subTest(name=name):
                self.refused("fit", "points.csv", *SIZE, "-o", name, words=["not supported by this version"])

    def test_outputs_are_checked_before_the_input_is_read(self):
        for output, words in [("missing/a.json", ["missing", "does not exist"]), ("a.xyz", [".json"])]:
            with self.subTest(output=output):
                message = self.refused("fit", "no-such-input.csv", *SIZE, "-o", output, words=words)
                self.assertNotIn("no-such-input", message)

    def test_an_existing_file_stays_without_force(self):
        self.write_points()
        self.write("a.json", "mine")
        self.refused("fit", "points.csv", *SIZE, "-o", "b.csv", "-o", "a.json", words=["a.json", "--force"])
        self.assertEqual((self.folder / "a.json").read_text(), "mine")
        self.assertEqual(self.files(), ["a.json", "points.csv"])
        self.run_tool("fit", "points.csv", *SIZE, "-o", "a.json", "--force")
        self.assertEqual(self.load("a.json")["degree"], [3, 3])

    def test_the_input_is_never_replaced(self):
        text = self.write_points().read_text()
        self.refused("fit", "points.csv", *SIZE, "-o", "./points.csv", "--force", words=["is the input"])
        self.assertEqual((self.folder / "points.csv").read_text(), text)

    def test_one_file_cannot_be_two_outputs(self):
        self.write_points()
        self.refused("fit", "points.csv", *SIZE, "-o", "a.json", "-o", "./a.json", words=["twice"])

    def test_a_folder_that_cannot_be_written_to(self):
        self.write_points()
        self.folder.chmod(0o755)
        locked = self.folder / "locked"
        locked.mkdir(mode=0o555)
        preexec = default_signals
        if os.geteuid() == 0:  # to root no folder is locked
            nobody = 65534
            try:
                subprocess.run([TOOL, "--version"], capture_output=True, user=nobody, cwd="/", check=True)
            except (OSError, subprocess.CalledProcessError):
                self.skipTest("running as root, and nobody else may run the tool")
            preexec = lambda: os.setuid(nobody)
        done = self.run_tool("fit", "points.csv", *SIZE, "-o", "locked/a.json", status=2, preexec=preexec)
        self.assertIn("locked", done.stderr)
        self.assertEqual(list(locked.iterdir()), [])

    def test_an_output_that_is_a_folder(self):
        self.write_points()
        (self.folder / "a.json").mkdir()
        self.refused("fit", "points.csv", *SIZE, "-o", "a.json", "--force", words=["a.json", "folder"])

    def test_a_bad_fit_leaves_no_file(self):
        self.write("points.csv", "x,y,z,u,v\n0,0,0,0,0\n")
        self.refused("fit", "points.csv", "--tol", "1%", "-o", "a.json", "-o", "a.png")
        self.assertEqual(self.files(), ["points.csv"])

    def test_a_full_disk_is_1_and_leaves_nothing_half(self):
        self.write_points()
        done = self.run_tool("fit", "points.csv", *SIZE, "-o", "a.csv", status=1, preexec=small_files_only(4096),
                             restore_signals=True)
        self.assertIn("a.csv", done.stderr)
        self.assertTrue(done.stderr.startswith("knotfit: "))
        self.assertEqual(self.files(), ["points.csv"])

    def test_a_full_device_is_1(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        self.write_points()
        (self.folder / "full.json").symlink_to("/dev/full")
        done = self.run_tool("fit", "points.csv", *SIZE, "-o", "full.json", status=1)
        self.assertIn("No space left", done.stderr)

    def test_one_full_disk_does_not_cost_the_other_outputs(self):
        self.write_points()
        done = self.run_tool("fit", "points.csv", *SIZE, "--json", "-o", "big.csv", "-o", "small.json", status=1,
                             preexec=small_files_only(16384))
        self.assertIn("big.csv", done.stderr)
        self.assertEqual(json.loads(done.stdout)["outputs"], ["small.json"])
        self.assertEqual(self.load("small.json")["degree"], [3, 3])

    def test_a_full_standard_output_is_1(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        with open("/dev/full", "w") as full:
            done = subprocess.run([TOOL, "methods"], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("standard output", done.stderr)


class Heights(ToolTest):
    HOLE = staticmethod(lambda r, c: 5 <= r < 9 and 8 <= c < 14)

    def test_the_raster_s_own_grid_with_its_holes(self):
        self.write_raster(hole=self.HOLE)
        self.run_tool("fit", "terrain.asc", "--tol", "1%", "-o", "a.asc")
        (head, given), (head_out, fitted) = self.read_raster("terrain.asc"), self.read_raster("a.asc")
        for name in ("ncols", "nrows", "xllcorner", "yllcorner", "dx", "dy", "nodata_value"):
            self.assertEqual(head[name], head_out[name])
        heights = [z for row in given for z in row if z != -9999]
        tolerance = 0.01 * (max(heights) - min(heights))
        for r, (row, row_out) in enumerate(zip(given, fitted)):
            for c, (z, z_out) in enumerate(zip(row, row_out)):
                if self.HOLE(r, c):
                    self.assertEqual(z_out, -9999)
                else:
                    self.assertAlmostEqual(z, z_out, delta=tolerance * (1 + 1e-9))

    def test_fill_holes(self):
        self.write_raster(hole=self.HOLE)
        self.run_tool("fit", "terrain.asc", "--tol", "1%", "--fill-holes", "-o", "a.asc")
        _, fitted = self.read_raster("a.asc")
        self.assertNotIn(-9999, [z for row in fitted for z in row])
        for r in range(5, 9):
            for c in range(8, 14):
                self.assertAlmostEqual(fitted[r][c], wave(c / 29, 1 - r / 19), delta=0.1)

    def test_another_cell_keeps_the_holes_where_they_are(self):
        self.write_raster(hole=self.HOLE)
        self.run_tool("fit", "terrain.asc", "--tol", "1%", "--cell", "1x1.5", "-o", "a.asc")
        head, fitted = self.read_raster("a.asc")
        self.assertEqual((head["ncols"], head["nrows"]), (59, 39))  # first to last centre
        self.assertEqual((head["xllcorner"] + 0.5, head["yllcorner"] + 0.75), (11, 21.5))
        for r, row in enumerate(fitted):
            for c, z in enumerate(row):
                x, y = 11 + c, 21.5 + 1.5 * (38 - r)
                inside_r, inside_c = 19 - int((y - 20) // 3), int((x - 10) // 2)
                self.assertEqual(z == -9999, self.HOLE(inside_r, inside_c), (r, c))

    def test_a_fitted_height_is_never_taken_for_nodata(self):
        self.write_raster(f=lambda u, v: 0.0 if v > 0.5 else 1.0 * u)
        text = (self.folder / "terrain.asc").read_text().replace("-9999", "0.5")
        self.write("half.asc", text)
        self.run_tool("fit", "half.asc", "--degree", "1", "--control-points", "2x2", "-o", "a.asc")
        head, fitted = self.read_raster("a.asc")
        self.assertNotIn(head["nodata_value"], [z for row in fitted for z in row])

    def test_scattered_heights_need_a_cell(self):
        self.write_heights()
        self.refused("fit", "heights.csv", "--height-field", *SIZE, "-o", "a.asc", words=["--cell"])
        self.run_tool("fit", "heights.csv", "--height-field", "--tol", "1%", "--cell", "0.1", "-o", "a.asc")
        head, fitted = self.read_raster("a.asc")
        self.assertNotIn(head["nodata_value"], [z for row in fitted for z in row])
        rows = [line.split(",") for line in (self.folder / "heights.csv").read_text().splitlines()[1:]]
        low = min(float(row[0]) for row in rows)
        self.assertAlmostEqual(head["xllcorner"] + 0.05, low, 12)

    def test_a_surface_in_space_has_no_heights(self):
        self.write_points()
        self.refused("fit", "points.csv", *SIZE, "-o", "a.asc", words=["--height-field"])
        self.assertEqual(self.files(), ["points.csv"])

    def test_too_many_cells_are_refused_before_the_fit(self):
        self.write_heights(f=step)
        self.refused("fit", "heights.csv", "--height-field", "--tol", "0.001%", "--cell", "1e-9", "-o", "a.asc",
                     words=["--cell"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
