"""- as a file: standard input and standard output. -q and --overwrite are second names."""

import json
import subprocess
import unittest

from harness import TIMEOUT, TOOL, ToolTest, default_signals

SIZE = ("--control-points", "5x5", "--between", "off")


class Streams(ToolTest):
    def piped(self, data, *arguments, status=0):
        if isinstance(data, str):
            data = data.encode()
        done = subprocess.run([TOOL, *map(str, arguments)], input=data, cwd=self.folder, capture_output=True,
                              timeout=TIMEOUT, preexec_fn=default_signals)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout.decode(), done.stderr.decode()

    def surface(self):
        self.write_raster()
        self.run_tool("fit", "terrain.asc", *SIZE, "-q", "-o", "s.json")
        return (self.folder / "s.json").read_text()

    def test_a_fit_from_standard_input_is_that_of_the_file(self):
        text = self.write_raster().read_text()
        from_file = self.run_json("fit", "terrain.asc", *SIZE)
        from_pipe = json.loads(self.piped(text, "fit", "-", *SIZE, "--json")[0])
        for member in ("size", "error", "knots"):
            self.assertEqual(from_pipe[member], from_file[member])
        self.assertEqual(from_pipe["input"]["path"], "-")

    def test_the_format_is_told_by_content_or_named(self):
        points = "x,y,z\n" + "".join(f"{i},{j},{i * j}\n" for i in range(6) for j in range(6))
        out, _ = self.piped(points, "info", "-", "--input-format", "csv", "--json")
        self.assertEqual((json.loads(out)["points"], json.loads(out)["format"]), (36, "csv"))
        _, said = self.piped(points, "info", "-", status=2)
        self.assertIn("standard input: ", said)
        self.assertIn("--input-format", said)
        out, _ = self.piped("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "info", "-", "--json")
        self.assertEqual(json.loads(out)["counts" if "counts" in json.loads(out) else "triangles"], 1)

    def test_a_mesh_is_welded(self):
        soup = "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n"
        for words, facts in (((), (4, 2, 1)), (("--weld", "off"), (6, 0, 2))):
            info = json.loads(self.piped(soup, "info", "-", "--json", *words)[0])
            self.assertEqual((info["points"], info["welded"], info["parts"]), facts)

    def test_messages_name_standard_input(self):
        _, said = self.piped("x,y,z\n1,2,a\n", "fit", "-", "--input-format", "csv", status=2)
        self.assertTrue(said.startswith("knotfit: standard input:2: "), said)
        _, said = self.piped("", "fit", "-", "--input-format", "csv", status=2)
        self.assertIn("standard input: is empty", said)
        _, said = self.piped("ncols 2\n", "fit", "-", "--base", "plane", status=2)
        self.assertIn("standard input", said)

    def test_the_surface_goes_to_standard_output_and_the_summary_elsewhere(self):
        wanted = self.surface()
        done = self.run_tool("fit", "terrain.asc", *SIZE, "-o", "-")
        written, stored = json.loads(done.stdout), json.loads(wanted)
        for member in ("control_points", "knots_u", "knots_v", "degree", "parameter_map", "options"):
            self.assertEqual(written[member], stored[member])
        self.assertIn("25 control points", done.stderr)
        self.assertNotIn("wrote", done.stderr)
        done = self.run_tool("fit", "terrain.asc", *SIZE, "-q", "-o", "-", "-o", "b.csv")
        self.assertEqual(done.stderr, "")
        self.assertEqual(json.loads(done.stdout)["control_points"], stored["control_points"])
        self.assertIn("b.csv", self.files())

    def test_surfaces_come_through_a_pipe(self):
        text = self.surface()
        at = ("--at", "30,40", "--json")
        from_file = self.run_tool("eval", "s.json", *at).stdout
        self.assertEqual(self.piped(text, "eval", "-", *at)[0], from_file)
        info = json.loads(self.piped("  \n" + text, "info", "-", "--json")[0])
        self.assertEqual((info["kind"], info["size"]), ("surface", [5, 5]))
        self.assertEqual(self.piped(text, "convert", "-", "-o", "-")[0], self.run_tool("convert", "s.json", "-o", "-").stdout)
        out = json.loads(self.piped(text, "distance", "-", "terrain.asc", "--json")[0])
        self.assertEqual(out["points_to_surface"]["count"], 600)
        again = json.loads(self.piped(text, "fit", "terrain.asc", "--options", "-", "-o", "-", "-q")[0])
        self.assertEqual(again["control_points"], json.loads(text)["control_points"])
        given = json.loads(self.piped(text, "fit", "terrain.asc", "--knots-from", "-", "-o", "-", "-q")[0])
        self.assertEqual(given["knots_u"], json.loads(text)["knots_u"])

    def test_a_json_surface_by_another_name(self):
        self.write("surface.txt", self.surface())
        info = self.run_json("info", "surface.txt", "--input-format", "knotfit-json")
        self.assertEqual(info["size"], [5, 5])

    def test_places_to_evaluate_at_come_through_a_pipe(self):
        self.surface()
        out, _ = self.piped("x,y\n30,40\n31,41\n", "eval", "s.json", "--points", "-", "--input-format", "csv")
        self.assertEqual(len(self.read_csv(out)), 2)
        self.assertEqual(self.read_csv(out)[0], self.read_csv(self.run_tool("eval", "s.json", "--at", "30,40").stdout)[0])

    def test_o_dash_is_the_json_of_commands_that_write_no_surface(self):
        self.surface()
        for command in (("eval", "s.json", "--at", "30,40"), ("distance", "s.json", "terrain.asc")):
            with self.subTest(command=command):
                self.assertEqual(self.run_tool(*command, "-o", "-").stdout, self.run_tool(*command, "--json").stdout)
        out = self.run_tool("compare", "terrain.asc", "--sizes", "5x5", "--methods", "uniform", "-o", "-").stdout
        self.assertEqual(len(json.loads(out)["rows"]), 1)

    def test_a_curve_and_data(self):
        curve = "".join(f"{k} {k * k}\n" for k in range(20))
        out, said = self.piped(curve, "fit-curve", "-", "--input-format", "csv", "--columns", "x,y", "--control-points",
                               "5", "-o", "-")
        self.assertEqual(json.loads(out)["format"], "knotfit-curve")
        self.assertEqual(len(json.loads(out)["control_points"]), 5)
        self.assertIn("standard input: 20 points", said)
        text = self.write_raster(columns=3, rows=2).read_text()
        out, _ = self.piped(text, "convert", "-", "-o", "-")
        self.assertEqual([(r["x"], r["y"]) for r in self.read_csv(out)],
                         [(11, 24.5), (13, 24.5), (15, 24.5), (11, 21.5), (13, 21.5), (15, 21.5)])

    def test_what_cannot_be(self):
        text = self.surface()
        for arguments, word in [(("distance", "-", "-"), "one file only"), (("eval", "-", "--points", "-"), "one file only"),
                                (("fit", "-", "--options", "-"), "one file only"),
                                (("fit", "terrain.asc", "--json", "-o", "-"), "--json"),
                                (("fit", "terrain.asc", "-o", "-", "-o", "-"), "twice")]:
            with self.subTest(arguments=arguments):
                out, said = self.piped(text, *arguments, status=2)
                self.assertEqual(out, "")
                self.assertIn(word, said)

    def test_a_full_standard_output_is_1(self):
        self.write_raster()
        with open("/dev/full", "w") as full:
            done = subprocess.run([TOOL, "fit", "terrain.asc", *SIZE, "-o", "-"], cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=TIMEOUT)
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output", done.stderr)

    def test_a_file_named_dash_has_a_folder(self):
        self.write_raster("-")
        self.assertEqual(self.run_json("info", "./-")["format"], "esri-ascii")

    def test_second_names(self):
        self.write_raster()
        self.assertEqual(self.run_tool("fit", "terrain.asc", *SIZE, "-q", "-o", "a.json").stdout, "")
        self.refused("fit", "terrain.asc", *SIZE, "-o", "a.json", words=["--force"])
        self.run_tool("fit", "terrain.asc", *SIZE, "-q", "-o", "a.json", "--overwrite")
        self.run_tool("eval", "a.json", "--at", "30,40", "-o", "e.csv")
        self.run_tool("eval", "a.json", "--at", "30,40", "-o", "e.csv", "--overwrite")


if __name__ == "__main__":
    unittest.main(verbosity=2)
