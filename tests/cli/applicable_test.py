"""Every option on every kind of input: it acts, or it is refused by name. Nothing is ignored in silence."""

import math
import unittest

from harness import ToolTest
from help_test import options_of

QUICK = ("--control-points", "4x4", "--between", "off")

# Kinds of input for fit, and what else stands on the command line with each.
KINDS = {
    "raster": ("raster.asc",),
    "array": ("heights.npy",),  # H x W heights
    "points": ("points.csv",),  # x, y, z with u, v
    "values": ("values.csv",),  # z with u, v
    "cloud": ("cloud.csv",),  # x, y, z
    "grid": ("grid.rows",),
    "rows": ("ragged.rows",),
    "mesh": ("mesh.obj",),
    "textured": ("textured.obj",),  # a mesh with vt
    "heights": ("cloud.csv", "--height-field"),
    "anew": ("points.csv", "--new-parameters"),
    "textured anew": ("textured.obj", "--new-parameters"),
    "over plane": ("cloud.csv", "--base", "plane"),
    "over graph": ("cloud.csv", "--base", "graph"),
}
ALL = set(KINDS)
MAPPED = {"cloud", "rows", "mesh", "anew", "textured anew", "over graph"}
MESHES = {"mesh", "textured", "textured anew"}
TEXT = ALL - {"raster", "array"} - MESHES

# Option -> (its value or None, kinds that it acts on). Every other kind refuses it by name.
BY_INPUT = {
    "--columns": (None, set()),  # see below: the names differ
    "--classes": ("2", set()),
    "--returns": ("first", set()),
    "--spacing": ("uniform", {"grid", "rows"}),
    "--rescale-parameters": (None, {"points", "values", "textured"}),
    "--duplicates": ("mean", ALL - {"raster", "array"}),
    "--base": ("plane", {"points", "values", "cloud", "grid", "rows", "anew"}),
    "--largest-part": (None, MESHES),
    "--orient": (None, MESHES),
    "--drop-degenerate": (None, MESHES),
    "--corners": ("sharpest", MAPPED),
    "--omega": ("0", MAPPED),
    "--fill-holes": (None, MAPPED | {"raster", "array", "textured", "heights", "over plane"}),
    "--new-parameters": (None, {"points", "cloud", "grid", "rows", "mesh", "textured", "over plane", "over graph"}),
    "--weld": ("off", MESHES),
    "--shear": ("0.1", {"raster", "array", "heights"}),
    "--skip-lines": ("1", TEXT),
}
# Options whose work does not depend on what the input is; those on outputs are refused without such an output.
ANY_INPUT = set("""--tol --within --rms --control-points --degree --max-control-points --max-fits --time-limit
    --knots --knots-u --knots-v --knots-from --refine --effort --guard --engine --feature --feature-file --evaluations --smoothing
    --input-format --nodata --height-field --correct --fairness --output --force --json --between --threads --quiet
    --options --no-height-field --no-rescale-parameters --no-fill-holes --no-largest-part --no-orient --no-drop-degenerate
    --no-new-parameters --no-cad-safe --help --help-all""".split())
BY_OUTPUT = {
    "--cell": ("2", ".asc"), "--samples": ("3", ".obj"), "--reflections": (None, ".png"), "--unit": ("m", "STEP"),
    "--name": ("part", "STEP"), "--step-schema": ("ap214", "STEP"), "--cad-safe": (None, "STEP"),
    "--cad-tol": ("0.1%", "STEP"),
}


def npy(rows, columns, values):
    import struct
    head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {columns}), }}"
    head += " " * (63 - (10 + len(head)) % 64) + "\n"
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(head)) + head.encode() + struct.pack(f"<{len(values)}d", *values)


class Inputs(ToolTest):
    def setUp(self):
        super().setUp()
        n, m = 9, 7

        def z(i, j):
            return 0.3 * math.sin(0.5 * i) * math.cos(0.4 * j)

        grid = [(i, j) for j in range(m) for i in range(n)]
        self.write("raster.asc", f"ncols {n}\nnrows {m}\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                   + "\n".join(" ".join(repr(z(i, j)) for i in range(n)) for j in reversed(range(m))) + "\n")
        (self.folder / "heights.npy").write_bytes(npy(m, n, [z(i, j) for j in range(m) for i in range(n)]))
        self.write("points.csv", "x,y,z,u,v\n" + "".join(f"{i},{j},{z(i, j)},{i / 8},{j / 6}\n" for i, j in grid))
        self.write("values.csv", "u,v,z\n" + "".join(f"{i / 8},{j / 6},{z(i, j)}\n" for i, j in grid))
        # Off the grid, so that no three neighbours lie on a line.
        self.write("cloud.csv", "x,y,z\n" + "".join(
            f"{i + 0.2 * math.sin(5 * i + 3 * j)},{j + 0.2 * math.cos(4 * i - 7 * j)},{z(i, j)}\n" for i, j in grid))
        self.write("grid.rows", "\n".join("".join(f"{i} {j} {z(i, j)}\n" for i in range(n)) for j in range(m)))
        self.write("ragged.rows", "\n".join("".join(f"{i} {j} {z(i, j)}\n" for i in range(n - j % 2))
                                            for j in range(m)))
        vertices = "".join(f"v {i} {j} {z(i, j)}\n" for i, j in grid)
        faces = [(n * j + i + 1, n * j + i + 2, n * (j + 1) + i + 2, n * (j + 1) + i + 1)
                 for j in range(m - 1) for i in range(n - 1)]
        self.write("mesh.obj", vertices + "".join("f {} {} {} {}\n".format(*f) for f in faces))
        self.write("textured.obj", vertices + "".join(f"vt {i / 8} {j / 6}\n" for i, j in grid)
                   + "".join("f " + " ".join(f"{k}/{k}" for k in f) + "\n" for f in faces))


class FitOptions(Inputs):
    def test_every_option_of_fit_is_in_the_table(self):
        there = options_of(self.run_tool("fit", "--help-all").stdout)
        self.assertEqual(there - ANY_INPUT - set(BY_INPUT) - set(BY_OUTPUT), set())
        of_compare = options_of(self.run_tool("compare", "--help-all").stdout)
        self.assertEqual(of_compare - there, {"--sizes", "--tolerances", "--methods"})

    def test_every_option_on_every_kind_of_input(self):
        there = options_of(self.run_tool("fit", "--help-all").stdout)
        for kind, (name, *more) in KINDS.items():
            for option, (value, acts) in BY_INPUT.items():
                if option not in there or option in more or option == "--columns":
                    continue
                if option == "--base" and "--base" in more or option == "--skip-lines" and kind in acts:
                    continue
                with self.subTest(kind=kind, option=option):
                    words = [option] if value is None else [option, value]
                    if kind in acts:
                        # Rows of different lengths are mapped where they are corrected.
                        mapped = kind == "rows" and option in ("--corners", "--omega", "--fill-holes")
                        fast = [] if mapped else ["--correct", "off"]
                        done = self.run_tool("fit", name, *more, *QUICK, *words, *fast, "-q", status=None)
                        if kind == "values" and option == "--base":  # needs x, y
                            self.assertIn("without x, y", done.stderr)
                        else:
                            self.assertEqual((done.returncode, done.stderr), (0, ""))
                    else:
                        said = [] if option in ("--classes", "--returns") else ["does not apply to"]
                        self.refused("fit", name, *more, *QUICK, *words, words=[name, option[2:], *said])

    def test_columns_are_those_of_text_and_arrays(self):
        for kind, (name, *more) in KINDS.items():
            names = {"points.csv": "x,y,z,u,v", "values.csv": "u,v,z"}.get(name, "x,y,z")
            with self.subTest(kind=kind):
                if kind in TEXT:
                    self.run_tool("fit", name, *more, "--columns", names, *QUICK, "--correct", "off", "-q")
                else:
                    self.refused("fit", name, *more, "--columns", names, *QUICK, words=[name, "columns"])  # of an array: too few

    def test_options_on_outputs_need_such_an_output(self):
        for option, (value, output) in BY_OUTPUT.items():
            with self.subTest(option=option):
                words = [option] if value is None else [option, value]
                self.refused("fit", "raster.asc", *QUICK, *words, "-o", "a.csv", words=[option, output])
                if option != "--reflections":  # the others are stored, to be repeated with such an output
                    stored = self.run_json("fit", "raster.asc", *QUICK, *words)["options"]
                    self.assertIsNotNone(stored[option[2:].replace("-", "_")])
        self.refused("fit", "raster.asc", *QUICK, "--reflections", "-o", "a.json", words=["--reflections"])
        self.assertNotIn("a.csv", self.files())
        self.run_tool("fit", "raster.asc", *QUICK, "--cell", "2", "-o", "a.asc")
        self.run_tool("fit", "raster.asc", *QUICK, "--samples", "2", "-o", "a.obj")
        self.assertEqual(self.read_raster("a.asc")[0]["cellsize"], 2)

    def test_a_refusal_says_what_the_input_is_and_what_the_option_is_for(self):
        for words, said in [
            (["raster.asc", "--base", "plane"], ["a raster of heights", "points without parameters are projected"]),
            (["mesh.obj", "--base", "plane"], ["to a mesh:"]),
            (["cloud.csv", "--height-field", "--base", "plane"], ["points fitted as a height field (--height-field)"]),
            (["textured.obj", "--omega", "0"], ["a mesh with parameters of their own"]),
            (["cloud.csv", "--base", "cylinder", "--omega", "0"], ["points over a base (--base cylinder)"]),
            (["grid.rows", "--base", "plane", "--spacing", "uniform"], ["rows of points over a base"]),
        ]:
            with self.subTest(words=words):
                self.refused("fit", *words, *QUICK, words=said)

    def test_what_stored_options_repeat_is_used_where_it_applies(self):
        self.run_tool("fit", "mesh.obj", *QUICK, "--correct", "off", "--omega", "0", "--corners", "sharpest", "-o", "a.json")
        self.run_tool("fit", "raster.asc", "--options", "a.json", "-q")

    def test_compare_refuses_the_same(self):
        size = ("--sizes", "4x4", "--methods", "uniform", "--between", "off")
        there = options_of(self.run_tool("compare", "--help-all").stdout)
        for kind, (name, *more) in KINDS.items():
            for option, (value, acts) in BY_INPUT.items():
                if option in there and option not in more and kind not in acts and option != "--columns":
                    if kind in ("raster", "points", "textured", "heights"):
                        with self.subTest(kind=kind, option=option):
                            words = [option] if value is None else [option, value]
                            self.refused("compare", name, *more, *size, *words, words=[option[2:]])


# Options of the other commands that act whatever the input is. Those of REFUSED are refused by some inputs or outputs.
ALWAYS = {
    "fit-curve": """--tol --within --rms --control-points --degree --max-control-points --max-fits --time-limit --knots
        --knots-t --compare --feature --feature-file --evaluations --smoothing --input-format --closed --function --spacing
        --corrected --output --force --json --threads --quiet""",
    "parameterize": """--largest-part --orient --drop-degenerate --corners --omega --fill-holes --map --input-format --output
        --force --json --threads --quiet --weld""",
    "distance": "--face --input-format --tol --output --force --json --threads --quiet",
    "eval": "--face --at --points --grid --clamp --derivatives --derivative --normals --curvature --output --force --json --threads",
    "info": "--input-format --json",
    "convert": "--input-format --output --force",
}
POINTS = ("--columns", "x,y")
REFUSED = [  # command line, the option that is refused, other words of the message
    (("fit-curve", "curve.csv", *POINTS, "--control-points", "6", "--unit", "m"), "--unit", ["STEP"]),
    (("fit-curve", "curve.csv", *POINTS, "--control-points", "6", "--name", "a"), "--name", ["STEP"]),
    (("fit-curve", "curve.csv", *POINTS, "--control-points", "6", "--step-schema", "ap214"), "--step-schema", ["STEP"]),
    (("fit-curve", "curve.csv", *POINTS, "--classes", "2"), "--classes", ["LAS"]),
    (("fit-curve", "curve.csv", *POINTS, "--returns", "last"), "--returns", ["LAS"]),
    (("fit-curve", "mesh.obj", *POINTS), "--columns", ["does not apply"]),
    (("fit-curve", "mesh.off", "--nodata", "0"), "--nodata", ["does not apply"]),
    (("fit-curve", "raster.asc", "--block", "1"), "--block", ["does not apply"]),
    (("fit-curve", "raster.asc", "--skip-lines", "1"), "--skip-lines", ["does not apply"]),
    (("parameterize", "mesh.obj", "--lines", "5"), "--lines", [".png"]),
    (("parameterize", "mesh.obj", "--lines", "5", "-o", "a.csv"), "--lines", [".png"]),
    (("distance", "s.json", "cloud.csv", "--samples", "9"), "--samples", ["mesh"]),
    (("distance", "s.json", "cloud.csv", "--unit", "m"), "--unit", ["JSON"]),
    (("distance", "s.json", "mesh.obj", "--columns", "x,y,z"), "--columns", ["obj"]),
    (("distance", "s.json", "mesh.off", "--nodata", "0"), "--nodata", ["off"]),
    (("distance", "s.json", "cloud.csv", "--classes", "2"), "--classes", ["LAS"]),
    (("distance", "s.json", "cloud.csv", "--returns", "1"), "--returns", ["LAS"]),
    (("distance", "s.json", "cloud.csv", "--weld", "off"), "--weld", []),
    (("distance", "s.json", "heights.npy", "--skip-lines", "1"), "--skip-lines", []),
    (("eval", "s.json", "--at", "1,1", "--columns", "x,y"), "--columns", ["--points"]),
    (("eval", "s.json", "--at", "1,1", "--nodata", "-1"), "--nodata", ["--points"]),
    (("eval", "s.json", "--at", "1,1", "--classes", "2"), "--classes", ["--points"]),
    (("eval", "s.json", "--at", "1,1", "--returns", "1"), "--returns", ["--points"]),
    (("eval", "s.json", "--at", "1,1", "--skip-lines", "1"), "--skip-lines", ["--points"]),
    (("eval", "s.json", "--grid", "3x3", "--input-format", "csv"), "--input-format", ["--points"]),
    (("eval", "s.json", "--at", "1,1", "--unit", "m"), "--unit", ["JSON"]),
    (("eval", "s.json", "--points", "raster.asc", "--columns", "x,y"), "--columns", ["raster"]),
    *[(("info", "s.json", option, value), option, ["surface"]) for option, value in (
        ("--columns", "x,y,z"), ("--nodata", "0"), ("--classes", "2"), ("--returns", "1"), ("--skip-lines", "1"),
        ("--weld", "off"))],
    (("info", "s.json", "--unit", "m"), "--unit", ["JSON"]),
    (("info", "cloud.csv", "--face", "1"), "--face", ["data"]),
    (("info", "cloud.csv", "--unit", "m"), "--unit", ["data"]),
    (("info", "raster.asc", "--columns", "x,y,z"), "--columns", ["raster"]),
    *[(("convert", "s.json", "-o", "a.csv", option, value), option, ["surface"]) for option, value in (
        ("--columns", "x,y,z"), ("--nodata", "0"), ("--classes", "2"), ("--returns", "1"), ("--skip-lines", "1"),
        ("--weld", "off"))],
    (("convert", "s.json", "-o", "a.csv", "--cell", "1"), "--cell", [".asc"]),
    (("convert", "s.json", "-o", "a.asc", "--grid", "3x3"), "--grid", [".csv"]),
    (("convert", "s.json", "-o", "a.csv", "--samples", "3"), "--samples", [".obj"]),
    (("convert", "s.json", "-o", "a.csv", "--reflections"), "--reflections", [".png"]),
    (("convert", "s.json", "-o", "a.csv", "--cad-safe"), "--cad-safe", ["STEP"]),
    (("convert", "s.json", "-o", "a.csv", "--unit", "m"), "--unit", ["STEP"]),
    *[(("convert", "raster.asc", "-o", "a.csv", *option), option[0], ["data"]) for option in (
        ("--face", "1"), ("--cell", "1"), ("--samples", "3"), ("--reflections",), ("--grid", "3x3"), ("--unit", "m"),
        ("--name", "a"), ("--step-schema", "ap214"), ("--cad-safe",), ("--cad-tol", "1%"))],
]


class OtherCommands(Inputs):
    def setUp(self):
        super().setUp()
        self.write("curve.csv", "".join(f"{math.cos(k / 9)},{math.sin(k / 9)}\n" for k in range(30)))
        self.write("mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.run_tool("fit", "raster.asc", *QUICK, "-o", "s.json", "-q")

    def test_every_option_is_in_the_table(self):
        for command, always in ALWAYS.items():
            with self.subTest(command=command):
                there = options_of(self.run_tool(command, "--help-all").stdout) - {"--help", "--help-all"}
                refused = {option for line, option, _ in REFUSED if line[0] == command}
                self.assertEqual(there - set(always.split()) - refused, set())
                self.assertEqual(set(always.split()) & refused - {"--input-format"}, set())

    def test_what_does_not_apply_is_refused_by_name(self):
        there = {command: options_of(self.run_tool(command, "--help-all").stdout) for command in ALWAYS}
        before = self.files()
        for line, option, words in REFUSED:
            if option in there[line[0]]:
                with self.subTest(line=line):
                    self.refused(*line, words=[option, *words])
        self.assertEqual(self.files(), before)

    def test_where_they_apply_they_act(self):
        self.run_tool("parameterize", "mesh.obj", "--lines", "5", "-o", "a.svg", "-q")
        self.run_tool("distance", "s.json", "mesh.obj", "--samples", "9")
        self.run_tool("convert", "s.json", "-o", "a.csv", "--grid", "3x3")
        self.assertEqual(len((self.folder / "a.csv").read_text().splitlines()), 10)
        out = self.run_tool("eval", "s.json", "--points", "cloud.csv", "--columns", "x,y,z", "--clamp").stdout
        self.assertEqual(len(self.read_csv(out)), 63)


if __name__ == "__main__":
    unittest.main(verbosity=2)
