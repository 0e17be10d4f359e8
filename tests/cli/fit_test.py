"""`knotfit fit`: exit statuses, the report, options that repeat."""

import json
import math
import unittest

from harness import BAD, SAMPLES, ToolTest, step, wave


class ExitStatus(ToolTest):
    def test_0_where_the_tolerance_is_reached(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--tol", "1%")
        self.assertEqual(report["status"], "reached")
        self.assertTrue(report["reached"])
        self.assertLessEqual(report["measured"], report["tolerance"]["value"])

    def test_0_for_a_fixed_size_without_a_tolerance(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--control-points", "6x5")
        self.assertEqual((report["status"], report["size"]), ("fixed_size", [6, 5]))
        self.assertIsNone(report["tolerance"])

    def test_3_where_a_fixed_size_misses_the_tolerance_and_the_files_are_written(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--control-points", "4x4", "--tol", "0.001%", "-o", "s.json",
                               status=3)
        self.assertEqual((report["status"], report["reached"], report["size"]), ("not_reached", False, [4, 4]))
        self.assertTrue(0 < report["tolerance"]["within"] < 1)
        self.assertEqual(report["outputs"], ["s.json"])
        self.assertEqual(self.load("s.json")["result"]["status"], "not_reached")

    def test_3_where_the_most_control_points_do_not_hold_the_tolerance(self):
        self.write_points(f=step)
        report = self.run_json("fit", "points.csv", "--tol", "0.01%", "--max-control-points", "40", status=3)
        self.assertFalse(report["reached"])
        self.assertLessEqual(report["control_points"], 40)
        self.assertIn(report["status"], ("limit_reached", "data_too_sparse"))

    def test_3_or_0_with_a_budget_of_fits(self):
        self.write_points(count=2000, f=step)
        report = self.run_json("fit", "points.csv", "--tol", "0.05%", "--max-fits", "6", status=3)
        self.assertEqual(report["status"], "limit_reached")

    def test_time_limit_is_named_as_the_status(self):
        self.write_points(count=6000, f=step)
        report = self.run_json("fit", "points.csv", "--tol", "0.02%", "--time-limit", "0.05", "--max-fits", "100000",
                               status=3)
        self.assertEqual(report["status"], "time_limit")

    def test_0_on_a_scan_with_uneven_parameters(self):
        report = self.run_json("fit", SAMPLES / "face.uv.csv", "--tol", "3%", "--between", "off")
        self.assertEqual(report["status"], "reached")
        self.assertLessEqual(report["control_points"], 150)  # 132 measured

    def test_2_for_usage(self):
        self.write_points()
        for arguments, words in [
            (("fit",), ["INPUT"]),
            (("nonsense",), ["nonsense", "--help"]),
            (("fit", "points.csv", "--nonsense"), ["--nonsense", "--help"]),
            (("fit", "points.csv", "--tol"), ["--tol"]),
            (("fit", "points.csv", "--rms", "--within", "99%"), ["--rms", "--within"]),
            (("fit", "points.csv", "--knots", "uniform", "--knots-u", "0.5", "--knots-v", "0.5"), ["--knots"]),
            (("fit", "points.csv", "--knots-u", "0.5"), ["--knots-v"]),
            (("fit", "points.csv", "--control-points", "5x5", "--knots-u", "0.5", "--knots-v", "0.5"),
             ["--control-points"]),
            (("fit", "points.csv", "--control-points", "5x5", "--refine", "insert"), ["--refine"]),
        ]:
            with self.subTest(arguments=arguments):
                self.refused(*arguments, words=words)

    def test_2_for_a_value_that_is_none(self):
        self.write_points()
        for option, value, word in [
            ("--tol", "abc", "tolerance"), ("--tol", "0", "above 0"), ("--tol", "-1", "above 0"),
            ("--tol", "0%", "above 0"), ("--tol", "nan", "tolerance"), ("--tol", "inf%", "tolerance"),
            ("--within", "99.5", "99.5%"), ("--within", "101%", "100%"), ("--within", "0%", "above 0%"),
            ("--control-points", "5y5", "40x30"), ("--control-points", "1x5", "2"),
            ("--control-points", "5x5x5", "40x30"), ("--control-points", "1e9", "40x30"),
            ("--knots", "nonsense", "uniform"), ("--degree", "0", "1 or more"), ("--degree", "10", "1 to 9"),
            ("--degree", "3x", "whole"), ("--refine", "both", "search, insert"),
            ("--max-control-points", "0", "1 or more"), ("--max-fits", "-3", "1 or more"),
            ("--max-fits", "2.5", "whole"), ("--time-limit", "0", "above 0"), ("--feature", "x", "hessian"),
            ("--spacing", "x", "centripetal"), ("--duplicates", "x", "lowest"), ("--between", "maybe", "on, off"),
            ("--columns", "x,q", "'q'"), ("--columns", "x,x,z", "twice"), ("--nodata", "x", "number"),
            ("--smoothing", "-1", "0 or more"), ("--cell", "0", "above 0"), ("--threads", "-1", "0 or more"),
            ("--threads", "99999", "threads"), ("--input-format", "nonsense", "nonsense"),
        ]:
            with self.subTest(option=option, value=value):
                message = self.refused("fit", "points.csv", option, value, words=[word])
                self.assertIn(option if option != "--input-format" else "format", message)
        for knots in ("0.5,0.2", "0,0.5", "0.5,1", "0.5,x", "1.5"):
            with self.subTest(knots=knots):
                self.refused("fit", "points.csv", "--knots-u", knots, "--knots-v", "none", words=["(0,1)"])

    def test_a_size_may_be_one_number_for_both_directions(self):
        self.write_points()
        self.assertEqual(self.run_json("fit", "points.csv", "--control-points", "6")["size"], [6, 6])


class Engine(ToolTest):
    def write_many(self):
        self.write_points("many.csv", 60000, lambda u, v: math.sin(9 * u) * math.exp(-20 * (v - 0.4) ** 2))

    def test_many_points_are_searched_on_a_sample_and_judged_at_all(self):
        self.write_many()
        report = self.run_json("fit", "many.csv", "--tol", "1%", "--effort", "fast", "-o", "s.json", "-o", "s.csv")
        self.assertEqual(report["status"], "reached")
        self.assertGreater(report["sample"], 15000)
        self.assertLess(report["sample"], 30000)
        errors = [row["error"] for row in self.read_csv((self.folder / "s.csv").read_text())]
        self.assertEqual(len(errors), 60000)
        self.assertLessEqual(max(errors), report["tolerance"]["value"])
        self.assertIn("on a sample of", self.run_tool("fit", "many.csv", "--control-points", "6").stdout)

    def test_all_points_are_searched_where_that_is_asked(self):
        self.write_many()
        report = self.run_json("fit", "many.csv", "--control-points", "6", "--engine", "points")
        self.assertEqual(report["sample"], 0)

    def test_the_same_bits_for_any_number_of_threads(self):
        self.write_many()
        surfaces = set()
        for threads in ("1", "2", "7"):
            self.run_tool("fit", "many.csv", "--tol", "1%", "--effort", "fast", "--threads", threads, "-o", f"s{threads}.csv")
            surfaces.add((self.folder / f"s{threads}.csv").read_text())
        self.assertEqual(len(surfaces), 1)


class Report(ToolTest):
    MEMBERS = ["size", "control_points", "degree", "knots", "error", "correction", "between", "bound", "thin", "swings", "tolerance", "measured",
               "reached", "status", "message", "method", "condition", "noise", "fits", "least_squares",
               "fill_points", "sample", "against_uniform", "against_error_model", "seconds", "peak_memory_bytes",
               "input", "options", "columns", "columns_from", "notes", "outputs", "version"]

    def test_json_has_every_member(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--tol", "1%", "--degree", "3x2", "-o", "s.json", "-o", "s.csv")
        self.assertEqual(list(report), self.MEMBERS)
        nu, nv = report["size"]
        self.assertEqual(report["control_points"], nu * nv)
        self.assertEqual(report["degree"], [3, 2])
        self.assertEqual(len(report["knots"]["u"]), nu + 4)
        self.assertEqual(len(report["knots"]["v"]), nv + 3)
        self.assertEqual(report["knots"]["u"], self.load("s.json")["knots_u"])
        error = report["error"]
        self.assertEqual(list(error), ["rms", "max", "mean", "median", "p95", "p99", "p995", "worst"])
        self.assertLessEqual(error["median"], error["p95"])
        self.assertLessEqual(error["p95"], error["p99"])
        self.assertLessEqual(error["p99"], error["p995"])
        self.assertLessEqual(error["p995"], error["max"])
        self.assertEqual(list(report["tolerance"]), ["value", "asked", "measure", "share", "within"])
        self.assertEqual(report["tolerance"]["within"], 1)
        self.assertEqual(report["tolerance"]["asked"], "1%")
        self.assertEqual(report["tolerance"]["measure"], "max")
        self.assertEqual(report["outputs"], ["s.json", "s.csv"])
        self.assertEqual(report["input"]["points"], 600)
        self.assertEqual(report["input"]["format"], "csv")
        self.assertGreater(report["peak_memory_bytes"], 1e6)
        self.assertGreater(report["seconds"], 0)
        self.assertGreaterEqual(report["thin"], 0)
        self.assertLessEqual(report["between"], report["bound"])

    def test_the_worst_point_and_the_errors_are_those_of_the_residuals(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--tol", "1%", "-o", "r.csv")
        rows = self.read_csv((self.folder / "r.csv").read_text())
        self.assertEqual(list(rows[0]), ["x", "y", "z", "u", "v", "error"])
        errors = [row["error"] for row in rows]
        worst = report["error"]["worst"]
        self.assertEqual(max(errors), report["error"]["max"])
        self.assertEqual(errors[worst["index"]], report["error"]["max"])
        self.assertEqual(worst["line"], worst["index"] + 2)  # after the header, from 1
        self.assertEqual((rows[worst["index"]]["u"], rows[worst["index"]]["v"]), (worst["u"], worst["v"]))
        self.assertAlmostEqual(report["error"]["rms"], math.sqrt(sum(e * e for e in errors) / len(errors)), 12)

    def test_relative_tolerance_is_of_the_diagonal_and_of_the_heights_for_a_height_field(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--tol", "2%")
        self.assertAlmostEqual(report["tolerance"]["value"], 0.02 * report["input"]["diagonal"], 14)
        self.assertGreater(report["input"]["diagonal"], 3)
        rows = [line.split(",") for line in self.write_heights().read_text().splitlines()[1:]]
        heights = [float(row[2]) for row in rows]
        report = self.run_json("fit", "heights.csv", "--height-field", "--tol", "2%")
        self.assertAlmostEqual(report["tolerance"]["value"], 0.02 * (max(heights) - min(heights)), 12)

    def test_an_absolute_tolerance_is_taken_as_it_is(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--tol", "0.05")
        self.assertEqual((report["tolerance"]["value"], report["tolerance"]["asked"]), (0.05, "0.05"))

    def test_the_default_tolerance_is_said(self):
        self.write_points(count=3000)
        report = self.run_json("fit", "points.csv")
        self.assertEqual(report["options"]["tolerance"], "0.1%")
        self.assertIn("0.1% (the default)", self.run_tool("fit", "points.csv").stdout)
        self.assertIn("Default, where neither a size nor knots are", self.run_tool("fit", "--help").stdout)

    def test_within_and_rms_count_other_errors(self):
        self.write_points(f=step, count=2000)
        report = self.run_json("fit", "points.csv", "--tol", "3%", "--within", "99.5%")
        self.assertEqual((report["tolerance"]["measure"], report["tolerance"]["share"]), ("percentile", 0.995))
        self.assertEqual(report["measured"], report["error"]["p995"])
        report = self.run_json("fit", "points.csv", "--tol", "3%", "--rms")
        self.assertEqual(report["tolerance"]["measure"], "rms")
        self.assertEqual(report["measured"], report["error"]["rms"])
        report = self.run_json("fit", "points.csv", "--tol", "3%", "--within", "100%", "--max-fits", "50000")
        self.assertEqual(report["tolerance"]["measure"], "max")

    def test_the_summary_says_what_counts(self):
        self.write_points()
        text = self.run_tool("fit", "points.csv", "--tol", "1%", "-o", "s.json").stdout
        for word in ("points.csv: 600 points", "control points", "error: max", "rms", "99.5 %", "tolerance: 1% =",
                     "at every point: reached", "between the points", "bound", "status: reached", "fits", " MB",
                     "wrote s.json", "at line"):
            self.assertIn(word, text)
        text = self.run_tool("fit", "points.csv", "--tol", "0.001%", "--control-points", "5x5", status=3).stdout
        self.assertIn("NOT reached", text)

    def test_quiet_prints_nothing_but_json(self):
        self.write_points()
        self.assertEqual(self.run_tool("fit", "points.csv", "--tol", "1%", "--quiet").stdout, "")
        self.assertTrue(self.run_json("fit", "points.csv", "--tol", "1%", "--quiet")["reached"])

    def test_nothing_but_the_result_is_printed_where_there_is_no_terminal(self):
        self.write_points()
        self.assertEqual(self.run_tool("fit", "points.csv", "--tol", "1%").stderr, "")

    def test_between_off_skips_it(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--tol", "1%", "--between", "off")
        self.assertEqual((report["between"], report["bound"], report["thin"]), (None, None, None))


class Knots(ToolTest):
    def test_given_knots_are_used_as_they_are(self):
        self.write_points()
        report = self.run_json("fit", "points.csv", "--knots-u", "0.2,0.5", "--knots-v", "0.7", "--degree", "2x3")
        self.assertEqual(report["knots"]["u"], [0, 0, 0, 0.2, 0.5, 1, 1, 1])
        self.assertEqual(report["knots"]["v"], [0, 0, 0, 0, 0.7, 1, 1, 1, 1])
        self.assertEqual((report["method"], report["status"]), ("given", "fixed_size"))
        report = self.run_json("fit", "points.csv", "--knots-u", "none", "--knots-v", "none")
        self.assertEqual(report["size"], [4, 4])

    def test_knots_of_a_surface_with_its_degree(self):
        self.write_points()
        self.run_tool("fit", "points.csv", "--knots-u", "0.3", "--knots-v", "0.25,0.5", "--degree", "2", "-o", "a.json")
        report = self.run_json("fit", "points.csv", "--knots-from", "a.json", "--tol", "50%", "-o", "b.json")
        self.assertEqual(report["degree"], [2, 2])
        self.assertEqual(self.load("a.json")["knots_v"], self.load("b.json")["knots_v"])
        self.assertEqual(self.load("a.json")["control_points"], self.load("b.json")["control_points"])
        self.assertEqual(report["status"], "reached")
        report = self.run_json("fit", "points.csv", "--knots-from", "a.json", "--degree", "3")
        self.assertEqual(report["degree"], [3, 3])
        self.refused("fit", "points.csv", "--knots-from", "none.json", words=["none.json"])

    def test_every_method_of_the_table_runs(self):
        self.write_points(count=1500)
        names = self.run_tool("methods", "--names").stdout.split()
        self.assertIn("uniform", names)
        self.assertIn("error-model", names)
        for name in names:
            with self.subTest(method=name):
                report = self.run_json("fit", "points.csv", "--control-points", "9x8", "--knots", name)
                self.assertEqual((report["method"], report["size"]), (name, [9, 8]))

    def test_both_routes_reach_a_tolerance(self):
        self.write_points(count=1500, f=step)
        for route in ("search", "insert"):
            with self.subTest(route=route):
                report = self.run_json("fit", "points.csv", "--tol", "3%", "--refine", route)
                self.assertTrue(report["reached"], report["message"])
                self.assertEqual(report["options"]["refine"], route)

    def test_the_feature_measure_is_passed_on(self):
        self.write_points(count=1500, f=step)
        sizes = [self.run_json("fit", "points.csv", "--control-points", "12", "--knots", "criterion", "--feature", name)
                 for name in ("hessian", "curvature")]
        self.assertNotEqual(sizes[0]["knots"], sizes[1]["knots"])

    def test_smoothing_is_passed_on(self):
        self.write_points()
        rough = self.run_json("fit", "points.csv", "--control-points", "10")["error"]["rms"]
        smooth = self.run_json("fit", "points.csv", "--control-points", "10", "--smoothing", "1e-3")["error"]["rms"]
        self.assertGreater(smooth, rough)


class Input(ToolTest):
    def test_a_raster_is_always_a_height_field(self):
        self.write_raster(hole=lambda r, c: 5 <= r < 9 and 8 <= c < 14)
        report = self.run_json("fit", "terrain.asc", "--tol", "1%", "-o", "s.json")
        self.assertTrue(report["input"]["height_field"])
        self.assertEqual((report["input"]["points"], report["input"]["holes"]), (600 - 24, 24))
        self.assertEqual(report["input"]["grid"], {"columns": 30, "rows": 20, "x0": 10, "y0": 20, "dx": 2, "dy": 3})
        self.assertIn("x", report["error"]["worst"])

    def test_rows_of_points_take_their_parameters_from_the_spacing(self):
        lines = []
        for i in range(12):
            for j in range(15 + i):
                x = (j / (14 + i)) ** 2
                lines.append(f"{x} {i / 11} {wave(x, i / 11)}")
            lines.append("")
        self.write("rows.txt", "\n".join(lines))
        reports = [self.run_json("fit", "rows.txt", "--control-points", "6", "--spacing", s)
                   for s in ("chord", "centripetal", "uniform")]
        errors = [r["error"]["rms"] for r in reports]
        self.assertEqual(len(set(errors)), 3)
        self.assertEqual(reports[0]["input"]["format"], "rows")
        self.assertEqual(self.run_json("fit", "rows.txt", "--control-points", "6")["error"]["rms"], errors[0])
        self.assertTrue(self.run_json("fit", "rows.txt", "--height-field", "--tol", "1%")["input"]["height_field"])

    def test_parameters_outside_0_1_are_refused_or_mapped(self):
        lines = ["x,y,z,u,v"] + [f"{2 * u!r},{v!r},{wave(u, v)!r},{10 + 5 * u!r},{-2 + 4 * v!r}"
                                 for u, v in [(i / 19, j / 19) for i in range(20) for j in range(20)]]
        self.write("far.csv", "\n".join(lines) + "\n")
        self.refused("fit", "far.csv", "--tol", "1%", words=["line 2", "--rescale-parameters"])
        report = self.run_json("fit", "far.csv", "--tol", "1%", "--rescale-parameters", "-o", "s.json")
        self.assertTrue(report["reached"])
        rows = self.read_csv(self.run_tool("eval", "s.json", "--at", "12.5,0").stdout)
        self.assertEqual((rows[0]["u"], rows[0]["v"]), (12.5, 0))
        self.assertAlmostEqual(rows[0]["x"], 1, delta=2 * report["tolerance"]["value"])

    def test_duplicates_are_an_error_only_where_no_surface_can_meet_both(self):
        path = self.write_points()
        text = path.read_text()
        _, _, z, u, v = text.splitlines()[10].split(",")
        x, y = 2 * float(u), 3 * float(v)
        path.write_text(text + f"{x!r},{y!r},{float(z) + 0.5!r},{u},{v}\n")
        self.refused("fit", "points.csv", "--tol", "0.1", words=["11", "602", "--duplicates"])
        self.run_tool("fit", "points.csv", "--tol", "0.3")
        self.run_tool("fit", "points.csv", "--control-points", "8x8")
        self.run_tool("fit", "points.csv", "--tol", "0.1", "--rms")
        for rule in ("mean", "lowest", "highest"):
            with self.subTest(rule=rule):
                report = self.run_json("fit", "points.csv", "--control-points", "8x8", "--duplicates", rule, "-o", f"{rule}.csv")
                self.assertEqual((report["input"]["points"], report["input"]["duplicates"]), (600, 1))
                rows = self.read_csv((self.folder / f"{rule}.csv").read_text())
                self.assertEqual(len(rows), 601)  # a line a point of the input
                self.assertGreaterEqual(max(rows[9]["error"], rows[600]["error"]), 0.25 - 1e-9)
                # Both are points of the input: no surface is within 0.2 of them.
                report = self.run_json("fit", "points.csv", "--tol", "0.2", "--duplicates", rule, status=3)
                self.assertEqual((report["status"], report["reached"]), ("not_reached", False))

    def test_columns_are_named_and_a_format_too(self):
        lines = [f"{u!r};{v!r};7;{2 * u!r};{3 * v!r};{wave(u, v)!r}"
                 for u, v in [(i / 14, j / 14) for i in range(15) for j in range(15)]]
        self.write("points.dat", "\n".join(lines) + "\n")
        report = self.run_json("fit", "points.dat", "--columns", "u,v,-,x,y,z", "--input-format", "csv", "--tol", "1%")
        self.assertEqual((report["input"]["dimension"], report["input"]["points"]), (3, 225))

    def test_nodata_by_option(self):
        self.write_raster(f=lambda u, v: 1 + round(wave(u, v), 1))
        text = (self.folder / "terrain.asc").read_text().replace("NODATA_value -9999\n", "")
        self.write("plain.asc", text)
        holes = sum(line.split().count("1.0") for line in text.splitlines()[6:])
        self.assertGreater(holes, 0)
        report = self.run_json("fit", "plain.asc", "--nodata", "1", "--control-points", "5x5")
        self.assertEqual(report["input"]["holes"], holes)

    def test_huge_coordinates_keep_their_precision(self):
        lines = ["x,y,z"] + [f"{1e8 + 2 * u!r},{1e8 + 3 * v!r},{1e8 + 0.01 * wave(u, v)!r}"
                             for u, v in [(i / 29, j / 29) for i in range(30) for j in range(30)]]
        self.write("far.csv", "\n".join(lines) + "\n")
        self.assertTrue(self.run_json("fit", "far.csv", "--height-field", "--tol", "0.0001")["reached"])

    def test_tiny_coordinates_are_as_good_as_others(self):
        lines = ["x,y,z,u,v"] + [f"{1e-9 * u!r},{1e-9 * v!r},{1e-9 * wave(u, v)!r},{u!r},{v!r}"
                                 for u, v in [(i / 19, j / 19) for i in range(20) for j in range(20)]]
        self.write("tiny.csv", "\n".join(lines) + "\n")
        self.assertTrue(self.run_json("fit", "tiny.csv", "--tol", "0.1%")["reached"])


class BadInput(ToolTest):
    CASES = {
        "bad_nan.csv": ["bad_nan.csv:18: "],
        "bad_columns.csv": ["bad_columns.csv:25: "],
        "bad_number.csv": ["bad_number.csv:11: ", "1.2.3"],
        "bad_collinear.csv": ["bad_collinear.csv", "straight line"],
        "bad_duplicate_uv.csv": ["bad_duplicate_uv.csv", "7", "32", "--duplicates"],
        "bad_outside_uv.csv": ["bad_outside_uv.csv", "line 14", "--rescale-parameters"],
        "bad_few_points.csv": ["bad_few_points.csv", "--degree", "16"],
        "bad_empty.csv": ["bad_empty.csv", "empty"],
        "bad_header_only.csv": ["bad_header_only.csv"],
        "bad_huge_header.npy": ["bad_huge_header.npy"],
        "bad_object.npy": ["bad_object.npy"],
        "bad_shape.npy": ["bad_shape.npy", "4"],
        "bad_short_row.asc": ["bad_short_row.asc:10: "],
        "bad_all_nodata.asc": ["bad_all_nodata.asc"],
        "bad_no_ncols.asc": ["bad_no_ncols.asc", "ncols"],
        "bad_cellsize.asc": ["bad_cellsize.asc:5: "],
        "bad_rows.txt": ["bad_rows.txt:18: ", "abc"],
    }

    def test_every_bad_file_is_refused_with_its_line_and_no_output(self):
        there = {path.name for path in BAD.iterdir() if path.name.startswith("bad_")}
        self.assertLessEqual(set(self.CASES), there)
        for name in sorted(there):
            words = self.CASES.get(name, [name])
            with self.subTest(file=name):
                self.refused("fit", BAD / name, "--tol", "0.1%", "-o", "out.json", "-o", "out.png", words=words)
                self.assertEqual(self.files(), [])

    def test_points_on_one_straight_line_have_no_plane(self):
        self.refused("fit", BAD / "bad_collinear.csv", "--height-field", "--tol", "1%", words=["straight line"])

    def test_other_bad_input(self):
        grid = [(i / 9, j / 9) for i in range(10) for j in range(10)]
        self.write("equal.csv", "x,y,z,u,v\n" + "".join(f"1,2,3,{u},{v}\n" for u, v in grid))
        self.write("line.csv", "x,y,z,u,v\n" + "".join(f"{u},{u},{u},{u},{v}\n" for u, v in grid))
        self.write("weights.csv", "x,y,z,u,v,w\n" + "".join(f"{u},{v},{u * v},{u},{v},{u}\n" for u, v in grid))
        self.write("one.csv", "x,y,z,u,v\n" + "".join(f"{u},{v},{u * v},{u},0.5\n" for u, v in grid))
        self.write_points()
        for name, words in [
            ("missing.csv", ["missing.csv", "no such file"]), (".", ["folder"]),
            ("equal.csv", ["equal.csv", "equal"]), ("line.csv", ["line.csv", "straight line"]),
            ("weights.csv", ["weights.csv", "weight"]), ("one.csv", ["one.csv", "v = 0.5"]),
            ("scan.las", ["scan.las"]),
        ]:
            with self.subTest(name=name):
                self.refused("fit", name, "--tol", "1%", words=words)
        self.refused("fit", "points.csv", "--tol", "1e-300", words=["points.csv", "below"])
        self.refused("fit", "points.csv", "--control-points", "100x100", words=["600 points", "10000"])
        self.refused("fit", "points.csv", "--control-points", "3x3", words=["at least 4 x 4"])

    def test_a_format_that_is_not_read_names_what_converts_it(self):
        self.write("terrain.tif", "II*")
        self.refused("fit", "terrain.tif", "--tol", "1%", words=["terrain.tif", "GeoTIFF", "gdal_translate"])


class Options(ToolTest):
    FIT = ("fit", "points.csv", "--tol", "5%", "--within", "99%", "--degree", "3x2", "--knots", "uniform",
           "--smoothing", "1e-8", "--max-fits", "500")

    def test_every_option_is_stored_and_repeats_the_same_surface(self):
        self.write_points(f=step)
        first = self.run_json(*self.FIT, "-o", "a.json")
        again = self.run_json("fit", "points.csv", "--options", "a.json", "-o", "b.json")
        self.assertEqual(first["options"], again["options"])
        self.assertEqual((self.folder / "a.json").read_bytes(), (self.folder / "b.json").read_bytes())
        self.assertEqual(self.load("a.json")["options"], first["options"])
        stored = first["options"]
        self.assertEqual((stored["tolerance"], stored["measure"], stored["degree"]), ("5%", "99%", [3, 2]))
        self.assertEqual((stored["knots"], stored["smoothing"], stored["max_fits"]), ("uniform", 1e-8, 500))

    def test_options_repeat_from_the_output_of_json_too(self):
        self.write_points(f=step)
        report = self.run_json(*self.FIT)
        self.write("report.json", json.dumps(report))
        again = self.run_json("fit", "points.csv", "--options", "report.json")
        self.assertEqual(report["knots"], again["knots"])

    def test_the_command_line_wins(self):
        self.write_points()
        self.run_json(*self.FIT, "-o", "a.json")
        again = self.run_json("fit", "points.csv", "--options", "a.json", "--tol", "6%", "--degree", "2")
        self.assertEqual((again["options"]["tolerance"], again["degree"]), ("6%", [2, 2]))
        self.assertEqual(again["options"]["knots"], "uniform")

    def test_sizes_and_knots_of_both_do_not_mix(self):
        self.write_points()
        self.run_json("fit", "points.csv", "--knots-u", "0.5", "--knots-v", "0.25,0.5", "-o", "given.json")
        again = self.run_json("fit", "points.csv", "--options", "given.json")
        self.assertEqual((again["method"], again["size"]), ("given", [5, 6]))
        again = self.run_json("fit", "points.csv", "--options", "given.json", "--control-points", "7x7")
        self.assertEqual((again["size"], again["method"]), ([7, 7], "optimal"))
        self.run_json("fit", "points.csv", "--control-points", "6x7", "-o", "size.json")
        again = self.run_json("fit", "points.csv", "--options", "size.json", "--knots-u", "0.5", "--knots-v", "0.5")
        self.assertEqual((again["size"], again["method"]), ([5, 5], "given"))
        again = self.run_json("fit", "points.csv", "--options", "size.json", "--tol", "2%", "--control-points", "search")
        self.assertEqual((again["status"], again["options"]["control_points"]), ("reached", None))

    def test_data_options_repeat(self):
        self.write_heights()
        self.run_json("fit", "heights.csv", "--height-field", "--tol", "5%", "--cell", "0.1x0.2", "-o", "a.json")
        again = self.run_json("fit", "heights.csv", "--options", "a.json", "-o", "a.asc")
        self.assertTrue(again["input"]["height_field"])
        head, _ = self.read_raster("a.asc")
        self.assertEqual((head["dx"], head["dy"]), (0.1, 0.2))
        cloud = self.run_json("fit", "heights.csv", "--options", "a.json", "--no-height-field")
        self.assertIsNotNone(cloud["correction"])  # as a cloud in space

    def test_stored_options_that_are_none_are_refused_by_name(self):
        self.write_points()
        for text, word in [('{"options": {"tolerance": "abc"}}', "tolerance"), ('{"options": {"degree": [3, 30]}}', "degree"),
                           ('{"options": {"degree": "x"}}', "degree"), ('{"options": {"colour": 1}}', "colour"),
                           ('{"options": {"knots": {"u": [0.5]}}}', "knots"), ("{}", "options"), ("[", "JSON"),
                           ('{"options": {"max_fits": 1.5}}', "max_fits")]:
            with self.subTest(text=text):
                self.write("o.json", text)
                self.refused("fit", "points.csv", "--options", "o.json", words=["o.json", word])
        self.refused("fit", "points.csv", "--options", "missing.json", words=["missing.json"])


class Threads(ToolTest):
    def test_outputs_are_the_same_bytes_for_any_number_of_threads(self):
        self.write_points(count=9000, f=step)
        for threads in (1, 2):
            self.run_tool("fit", "points.csv", "--tol", "2%", "--threads", threads, "-o", f"{threads}.json", "-o",
                          f"{threads}.csv", "-o", f"{threads}.svg", "-o", f"{threads}.png")
        for extension in ("json", "csv", "svg", "png"):
            with self.subTest(extension=extension):
                self.assertEqual((self.folder / f"1.{extension}").read_bytes(),
                                 (self.folder / f"2.{extension}").read_bytes())


class Samples(ToolTest):
    def test_a_face_within_five_percent(self):
        report = self.run_json("fit", SAMPLES / "face.uv.csv", "--tol", "5%")
        self.assertTrue(report["reached"], report["message"])



class SeveralTolerances(ToolTest):
    def test_each_is_fitted_as_if_alone(self):
        self.write_points()
        done = self.run_tool("fit", "points.csv", "--tol", "5%,1%,2%", "-o", "s.json", "-o", "e.csv", "--json")
        reports = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([r["tolerance"]["asked"] for r in reports], ["5%", "1%", "2%"])
        self.assertEqual(self.files(), sorted(["points.csv"] + [f"{n}-{k}.{e}" for k in (1, 2, 3) for n, e in (("s", "json"), ("e", "csv"))]))
        for k, tolerance in enumerate(("5%", "1%", "2%"), 1):
            self.run_tool("fit", "points.csv", "--tol", tolerance, "-o", "alone.json", "-o", "alone.csv", "--force")
            for one, alone in ((f"s-{k}.json", "alone.json"), (f"e-{k}.csv", "alone.csv")):
                self.assertEqual((self.folder / one).read_bytes(), (self.folder / alone).read_bytes(), one)
        self.assertEqual(self.run_tool("fit", "points.csv", "--tol", "5%,1%").stdout.count("status: reached"), 2)

    def test_of_a_mesh_too(self):
        n = 12
        lines = [f"v {i / n} {j / n} {0.3 * wave(i / n, j / n)}" for j in range(n + 1) for i in range(n + 1)]
        lines += [f"f {a} {a + 1} {a + n + 2} {a + n + 1}" for j in range(n) for i in range(n) for a in [j * (n + 1) + i + 1]]
        self.write("sheet.obj", "\n".join(lines) + "\n")
        self.run_tool("fit", "sheet.obj", "--tol", "3%,1%", "-o", "s.json")
        self.run_tool("fit", "sheet.obj", "--tol", "1%", "-o", "alone.json")
        self.assertEqual((self.folder / "s-2.json").read_bytes(), (self.folder / "alone.json").read_bytes())

    def test_one_that_is_missed_is_the_exit_status(self):
        self.write_points()
        self.run_tool("fit", "points.csv", "--tol", "5%,1e-9%,2%", "--max-control-points", "40", status=3)

    def test_what_is_refused(self):
        self.write_points()
        self.refused("fit", "points.csv", "--tol", "1%,0.1", words=["--tol", "all of them in %"])
        self.refused("fit", "points.csv", "--tol", "1%,", words=["--tol"])
        self.refused("fit", "points.csv", "--tol", "1%,2%", "-o", "-", words=["-o -", "several tolerances"])
        self.write("s-2.json", "mine")
        self.refused("fit", "points.csv", "--tol", "1%,2%", "-o", "s.json", words=["s-2.json"])
        self.assertEqual(self.files(), ["points.csv", "s-2.json"])
        self.refused("fit-curve", "points.csv", "--tol", "1%,2%", words=["--tol", "one tolerance"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
