"""What a row fails on, each with its words; and that a sound one passes."""

import os
import sys
import tempfile
import unittest
import unittest.mock

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import numpy as np

import child
import truth
import verdict
from outputs import Measured
from swings import Swings

ONE_PERCENT = {"value": 0.01, "measure": "max", "share": 1}


def result(status="reached", errors=(0.001, 0.009), recomputed=None, swings=None, box=0.0, notes=(), disagree=""):
    errors = np.array(errors, float)
    return Measured(status=status, control_points=16, points=len(errors), dimension=1, diagonal=1.0, errors=errors,
                    recomputed=errors if recomputed is None else np.array(recomputed, float), disagree=disagree,
                    swings=swings or Swings(1000, 0.5, 0.0), box=box, notes=list(notes))


class Results(unittest.TestCase):
    def faults(self, *arguments, tolerance=ONE_PERCENT, **keywords):
        return "; ".join(verdict.of_result(result(*arguments, **keywords), tolerance)[0])

    def test_a_sound_one_passes(self):
        self.assertEqual(verdict.of_result(result(), ONE_PERCENT), ([], []))
        self.assertEqual(verdict.of_result(result("not_reached", [0.02]), ONE_PERCENT), ([], []))

    def test_reached_that_the_csv_or_the_surface_denies(self):
        self.assertIn("reached, but the CSV says 2 tolerances", self.faults(errors=[0.001, 0.02]))
        only_json = self.faults(recomputed=[0.001, 0.013])
        self.assertIn("reached, but the JSON says 1.3 tolerances", only_json)
        self.assertNotIn("CSV", only_json)

    def test_not_reached_over_errors_that_hold(self):
        for status in ("not_reached", "data_too_sparse", "limit_reached", "tolerance_below_noise"):
            self.assertIn(f"{status}, but the CSV says 0.9 tolerances", self.faults(status))
        for status in ("swings", "folded", "stopped", "time_limit"):
            self.assertEqual(self.faults(status), "")

    def test_the_error_that_counts(self):
        errors = np.array([3.0, 0, 4, 0])
        self.assertEqual(verdict.measured(errors, "max", 1), 4)
        self.assertEqual(verdict.measured(errors, "rms", 1), 2.5)
        many = np.arange(1, 1001.0)
        self.assertEqual(verdict.measured(many, "percentile", 0.995), 995)

    def test_reached_that_swings(self):
        self.assertIn("swings", self.faults(swings=Swings(1000, 10.1, 0.0)))
        self.assertIn("swings", self.faults(swings=Swings(1000, 4, 1 / 1999)))
        self.assertEqual(self.faults(swings=Swings(1000, 9.9, 1 / 2001)), "")
        self.assertEqual(self.faults("swings", swings=Swings(1000, 500, 0.1)), "")

    def test_a_box_that_no_note_tells_of(self):
        words = "the box is larger"
        self.assertIn(words, self.faults(box=0.21))
        self.assertIn(words, self.faults(box=0.21, notes=["13 knot cells hold no point"]))
        self.assertEqual(self.faults(box=0.21, notes=["the surface leaves the data by 0.2 at u = 0.1"]), "")
        self.assertEqual(verdict.of_result(result(box=0.03), ONE_PERCENT), ([], ["box"]))
        self.assertEqual(verdict.of_result(result(box=0.019), ONE_PERCENT), ([], []))

    def test_points_that_the_csv_lacks(self):
        self.assertEqual(verdict.of_result(result(), ONE_PERCENT, 3)[0],
                         ["the CSV has 2 of the input's 3 points, and no note says so"])
        noted = result(notes=["1 point left out, apart from the others"])
        self.assertEqual(verdict.of_result(noted, ONE_PERCENT, 3), ([], ["the CSV has 2 of the input's 3 points"]))
        self.assertEqual(verdict.of_result(result(), ONE_PERCENT, 2), ([], []))

    def test_two_ways_to_one_error_that_differ(self):
        self.assertEqual(self.faults(disagree="errors differ by 3"), "errors differ by 3")


class Statuses(unittest.TestCase):
    def test_each_status_has_its_exit(self):
        for status, exit_status in [("reached", 0), ("fixed_size", 0), ("stopped", 130), ("time_limit", 3),
                                    ("swings", 3), ("data_too_sparse", 3), ("folded", 3)]:
            self.assertEqual(verdict.of_status(status, exit_status), [])
        self.assertEqual(verdict.of_status("time_limit", 0), ["exit 0 with status time_limit"])
        self.assertIn("none that docs/ knows", verdict.of_status("happy", 0)[0])


class Processes(unittest.TestCase):
    """Real ones: Python in place of the program."""

    def run_python(self, code, limit=60, stop_after=0):
        with tempfile.TemporaryDirectory() as folder:
            return child.run([sys.executable, "-S", "-c", code], folder, limit, stop_after)

    def test_exit_status_and_words(self):
        done = self.run_python("import sys; print('out'); print('knotfit: why', file=sys.stderr); sys.exit(2)")
        self.assertEqual((done.exit, done.out), (2, "out\n"))
        self.assertEqual(verdict.of_process(done, 0), ["refused: why"])
        self.assertEqual(verdict.of_process(self.run_python("raise SystemExit(1)"), 0), ["exit 1: no message"])
        self.assertEqual(verdict.of_process(self.run_python("raise SystemExit(3)"), 0), [])

    def test_a_crash(self):
        done = self.run_python("import os, signal; os.kill(os.getpid(), signal.SIGSEGV)")
        self.assertEqual(verdict.of_process(done, 0), ["ended by signal 11"])

    def test_a_stop_arrives_and_its_seconds_count(self):
        code = """
import signal, sys, time
signal.signal(signal.SIGINT, lambda *a: (time.sleep(0.3), sys.exit(130)))
time.sleep(40)"""
        for stop_after in (0.5, 4, 20):  # later where a busy machine lets Python begin late
            done = self.run_python(code, stop_after=stop_after)
            if done.exit == 130:
                break
        self.assertEqual(done.exit, 130)
        self.assertGreater(done.after_stop, 0.25)
        self.assertEqual(verdict.of_process(done, stop_after), [])
        self.assertIn("nobody stopped it", verdict.of_process(done, 0)[0])

    def test_a_stop_before_the_program_listens_is_no_crash(self):
        code = "import os, signal, time; signal.signal(signal.SIGINT, signal.SIG_DFL); time.sleep(20)"
        done = self.run_python(code, stop_after=1)
        self.assertEqual(done.exit, -2)
        self.assertEqual(verdict.of_process(done, 1), [])
        self.assertEqual(verdict.of_process(done, 0), ["ended by signal 2"])
        self.assertEqual(verdict.of_process(done._replace(processor=1.5), 1), ["ended by signal 2"])

    def test_memory_is_the_programs_own(self):
        held = np.ones(40 << 20)  # 320 MiB here
        small, large = self.run_python("pass"), self.run_python("x = b'x' * (200 << 20)")
        self.assertLess(small.memory, 60 << 20)
        self.assertGreater(large.memory, 200 << 20)
        self.assertEqual(len(held), 40 << 20)
        self.assertIn("MiB of memory", verdict.of_process(large._replace(memory=2 << 30), 0)[0])

    def test_a_time_limit_overrun(self):
        done = self.run_python("pass")._replace(seconds=71, processor=120)
        self.assertEqual(verdict.of_clock(done, 60), (["71 s with a time limit of 60 s"], []))
        self.assertEqual(verdict.of_clock(done._replace(seconds=69), 60), ([], []))
        self.assertEqual(verdict.of_clock(done._replace(seconds=13, after_stop=11), 60),
                         (["ended 11 s after it was stopped"], []))

    def test_a_starved_program_is_not_late(self):
        done = self.run_python("pass")._replace(seconds=71, processor=1)
        with unittest.mock.patch("os.getloadavg", return_value=(50, 50, 50)):
            self.assertEqual(verdict.of_clock(done, 60),
                             ([], ["71 s with a time limit of 60 s: a busy machine, 1.0 s of a processor"]))
        with unittest.mock.patch("os.getloadavg", return_value=(0, 0, 0)):  # it slept
            self.assertEqual(len(verdict.of_clock(done, 60)[0]), 1)


class Truth(unittest.TestCase):
    def write(self, name, text):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, name)
        with open(path, "w") as file:
            file.write(text)
        return path

    def test_a_grid_gives_its_cells_from_the_north(self):
        path = self.write("a.asc", "NCOLS 3\nNROWS 2\nXLLCORNER 10\nYLLCORNER 20\nCELLSIZE 2\nNODATA_value -1\n"
                                   "1 2 -1\n4 5 6\n")
        data = truth.read(path)
        self.assertEqual([*zip(*(data[n] for n in "xyz"))],
                         [(11, 23, 1), (13, 23, 2), (11, 21, 4), (13, 21, 5), (15, 21, 6)])

    def test_points_are_counted(self):
        for name, text in [("a.rows", "0 0 1\n1 0 1\n\n0 1 1\nnan nan nan\n"),
                           ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n"),
                           ("a.off", "OFF # a comment\n3 1 0\n0 0 0\n"),
                           ("a.ply", "ply\nelement vertex 3\n")]:
            self.assertEqual(truth.count(self.write(name, text)), 3, name)
        path = self.write("a.npy", "")
        np.save(path, np.array([[[0, 0, 1], [np.nan] * 3], [[1, 1, 1], [2, 2, 2.0]]]))
        self.assertEqual(truth.count(path), 3)
        self.assertIsNone(truth.count(self.write("a.las", "LASF")))

    def test_residuals_of_other_points_are_found(self):
        path = self.write("a.csv", "x,y,z,u,v\n1,2,3,0,0\n4,5,6,1,1\n")
        table = {n: np.array(c, float) for n, c in zip("xyz", [[1, 4], [2, 5], [3, 6]])}
        self.assertEqual(truth.denied(path, table), "")
        self.assertIn("1 points, the input 2", truth.denied(path, {n: c[:1] for n, c in table.items()}))
        table["z"] = np.array([3, 6.5])
        self.assertIn("z of the CSV", truth.denied(path, table))


if __name__ == "__main__":
    unittest.main(verbosity=2)
