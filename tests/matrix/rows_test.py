"""Which rows are run: every pair in the cover, every kind of file and option among the quick ones."""

import itertools
import os
import tempfile
import unittest

import made
import quick
from inputs import CALLS, Input, guessed_call, in_folder, read_calls
from rows import FACTORS, Row, all_pairs, cover, pairs_of, product


def some_inputs():
    return [Input("a.csv", "a.csv", "fit", ()), Input("b.las", "b.las", "fit", ("--height-field",)),
            Input("c.csv", "c.csv", "fit-curve", ("--closed",))]


def given(row):
    return {name: getattr(row, name) for name in ["input", *FACTORS]}


class Cover(unittest.TestCase):
    def test_every_pair_that_is_a_call_meets_in_a_row(self):
        inputs = some_inputs()
        met = set().union(*(pairs_of(given(r)) for r in cover(inputs)))
        self.assertEqual(met, all_pairs({"input": inputs, **FACTORS}))

    def test_the_call_without_options_of_every_input_comes_first(self):
        self.assertEqual([r.call() for r in cover(some_inputs())[:3]], ["(no option)"] * 3)

    def test_the_same_rows_each_time_and_none_twice(self):
        rows = cover(some_inputs())
        self.assertEqual(rows, cover(some_inputs()))
        self.assertEqual(len({r.key for r in rows}), len(rows))

    def test_four_rows_an_input_and_few_more(self):
        many = [Input(str(k), "", "fit", ()) for k in range(40)]
        self.assertLess(len(cover(many)), 40 * 5 + 10)

    def test_no_row_inserts_at_a_fixed_size_or_in_a_curve(self):
        for row in itertools.chain(cover(some_inputs()), product(some_inputs())):
            if row.route == "insert":
                self.assertEqual((row.size, row.input.curve), ("free", False))

    def test_the_product_counts(self):
        surface = 4 * 3 * 3 * 2 * (2 + 3)  # tolerances, measures, methods, stops; two routes or a size of three
        self.assertEqual(sum(1 for _ in product(some_inputs())), 2 * surface + 4 * 3 * 3 * 2 * (1 + 3))


class Calls(unittest.TestCase):
    def test_options_of_the_command_line(self):
        surface, _, curve = some_inputs()
        self.assertEqual(Row(surface).options(), [])
        self.assertEqual(Row(surface, "1%", "99.5%", "insert", "uniform").options(),
                         ["--tol", "1%", "--within", "99.5%", "--refine", "insert", "--knots", "uniform"])
        self.assertEqual(Row(surface, measure="rms", size="20", stop="2 s").call(),
                         "--rms --control-points 20x20 (stopped after 2 s)")
        self.assertEqual(Row(curve, size="20").options(), ["--control-points", "20"])

    def test_a_list_of_calls_names_the_line_it_cannot_use(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "calls")
            with open(path, "w") as file:
                file.write("# a comment\nscan.xyz fit --base plane  # another\nother.csv walk\n")
            with self.assertRaisesRegex(SystemExit, "calls:3: NAME fit"):
                read_calls(path)

    def test_files_that_no_list_names(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in [("a.las", "LASF"), ("b.csv", "X;Y\n0;1\n"), ("c.csv", "x,y,z\n"), ("bad_d.csv", ""),
                               ("README.md", ""), ("e.tif", "")]:
                with open(os.path.join(folder, name), "w") as file:
                    file.write(text)
            found, skipped = in_folder(folder, {})
            self.assertEqual([(i.name, i.command, i.arguments, i.sound) for i in found],
                             [("a.las", "fit", ("--height-field",), False), ("b.csv", "fit-curve", (), False),
                              ("c.csv", "fit", (), False)])
            self.assertEqual(skipped, [("e.tif", "GeoTIFF is not read by this version")])


class Quick(unittest.TestCase):
    def test_twenty_rows_with_every_option_and_kind_of_file(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = quick.rows(folder)
        self.assertEqual(len(rows), 20)
        for name, values in FACTORS.items():
            self.assertEqual({getattr(r, name) for r in rows}, set(values), name)
        kinds = {os.path.splitext(r.input.path)[1] for r in rows}
        self.assertEqual(kinds, {".csv", ".asc", ".npy", ".rows", ".ply", ".obj", ".off", ".stl", ".las", ".pcd"})
        self.assertTrue(any(r.input.curve for r in rows))


class Made(unittest.TestCase):
    def test_the_same_bytes_whatever_else_is_made(self):
        with tempfile.TemporaryDirectory() as a, tempfile.TemporaryDirectory() as b:
            made.write(a, {**made.MADE, **made.SMALL})
            one = {"spiral": made.MADE["spiral"]}
            path = made.write(b, one)["spiral"]
            with open(path, "rb") as first, open(os.path.join(a, os.path.basename(path)), "rb") as second:
                self.assertEqual(first.read(), second.read())

    def test_every_listed_file_has_one_call(self):
        self.assertGreater(len(read_calls(CALLS)), 30)


if __name__ == "__main__":
    unittest.main(verbosity=2)
