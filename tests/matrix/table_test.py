"""The table: written, read back, compared."""

import os
import tempfile
import unittest

import table
from run_row import Result, from_record, as_record


def row(name, status="reached", points=100, **more):
    return Result(name, "--tol 1%", status=status, control_points=points, tolerance=0.1, **more)


class Table(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "table.md")

    def test_reads_back_what_it_wrote(self):
        rows = [row("b.csv", faults=["a | b"]), row("a.csv", "not_reached", 40), row("c.csv", "none", 0)]
        table.write(self.path, rows, "3 rows.")
        self.assertEqual(table.read(self.path), {("a.csv", "--tol 1%"): ("not_reached", 40),
                                                 ("b.csv", "--tol 1%"): ("reached", 100),
                                                 ("c.csv", "--tol 1%"): ("none", 0)})
        with open(self.path) as file:
            self.assertIn("a \\| b", file.read())

    def test_what_stands_above_the_mark_stays(self):
        with open(self.path, "w") as file:
            file.write("# A page\n" + table.MARK + "\nold rows\n")
        table.write(self.path, [row("a.csv")], "1 rows.")
        table.write(self.path, [row("a.csv")], "1 rows.")
        with open(self.path) as file:
            text = file.read()
        self.assertTrue(text.startswith("# A page\n" + table.MARK))
        self.assertEqual((text.count("a.csv"), text.count("old rows")), (1, 0))

    def test_what_is_worse_than_before(self):
        table.write(self.path, [row("a"), row("b"), row("c"), row("d", "time_limit"), row("e", "not_reached")], "")
        now = [row("a", "swings"), row("b", points=111), row("c", points=109), row("d", "time_limit", 300),
               row("e", "reached", 900), row("new")]
        self.assertEqual(table.worse(table.read(self.path), now),
                         ["a --tol 1%: reached -> swings", "b --tol 1%: 100 -> 111 control points"])

    def test_a_result_survives_being_kept(self):
        kept = row("a", swing=3.5, faults=["x"], swing_at=[0.1, 0.2])
        self.assertEqual(from_record(as_record(kept)), kept)


if __name__ == "__main__":
    unittest.main(verbosity=2)
