"""The built tool from outside: runs it, and makes small data to fit.

KNOTFIT is the program, KNOTFIT_SOURCE the project's root; ctest sets both.
"""

import json
import math
import os
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

TOOL = os.environ["KNOTFIT"]
SOURCE = Path(os.environ["KNOTFIT_SOURCE"])
BAD = SOURCE / "tests" / "data" / "bad"
SAMPLES = SOURCE / "samples"
TIMEOUT = 300

# Fontconfig keeps a kilobyte of patterns until the process ends; the leak checker need not say so.
os.environ.setdefault("LSAN_OPTIONS",
                      f"suppressions={Path(__file__).with_name('leaks.txt')}:print_suppressions=0")


def default_signals():
    # A test runner in the background hands ignored signals down; a Ctrl-C must arrive.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def small_files_only(limit):
    """Files may grow to `limit` bytes: what a full disk looks like to a writer."""

    def apply():
        default_signals()
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return apply


def wave(u, v):
    return math.sin(3 * u) * math.cos(2 * v) + 0.3 * u * v


def step(u, v):
    """Needs many control points: a search that takes a while."""
    return math.tanh(40 * (u + 0.2 * v - 0.6)) + 0.3 * math.sin(9 * u * v)


def scattered(count, seed=1):
    rng = random.Random(seed)
    return [(rng.random(), rng.random()) for _ in range(count)]


class ToolTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="knotfit-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    # Running.

    def run_tool(self, *arguments, status=0, preexec=default_signals, **keywords):
        done = subprocess.run([TOOL, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                              timeout=TIMEOUT, preexec_fn=preexec, **keywords)
        if status is not None:
            self.assertEqual(done.returncode, status,
                             f"knotfit {' '.join(map(str, arguments))}\n{done.stdout}\n{done.stderr}")
        return done

    def run_json(self, *arguments, status=0):
        done = self.run_tool(*arguments, "--json", status=status)
        self.assertEqual(done.stdout.count("\n"), 1, "one object on one line")
        return json.loads(done.stdout)

    def refused(self, *arguments, words=(), status=2):
        """Exit status `status`, a message with `words` on standard error, nothing on standard output."""
        done = self.run_tool(*arguments, status=status)
        self.assertEqual(done.stdout, "")
        self.assertTrue(done.stderr.startswith("knotfit: "), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        return done.stderr

    def files(self):
        return sorted(p.name for p in self.folder.iterdir())

    def load(self, name):
        return json.loads((self.folder / name).read_text())

    # Data.

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def write_points(self, name="points.csv", count=600, f=wave, seed=1):
        """x,y,z,u,v of a surface in space."""
        lines = ["x,y,z,u,v"]
        for u, v in scattered(count, seed):
            lines.append(f"{2 * u!r},{3 * v!r},{f(u, v)!r},{u!r},{v!r}")
        return self.write(name, "\n".join(lines) + "\n")

    def write_heights(self, name="heights.csv", count=600, f=wave, seed=1):
        """x,y,z over [100,102] x [50,53]."""
        lines = ["x,y,z"]
        for u, v in scattered(count, seed):
            lines.append(f"{100 + 2 * u!r},{50 + 3 * v!r},{f(u, v)!r}")
        return self.write(name, "\n".join(lines) + "\n")

    def write_raster(self, name="terrain.asc", columns=30, rows=20, f=wave, hole=None):
        """Cells of 2 x 3 with the corner at (10, 20); `hole(row, column)` cells are nodata."""
        lines = [f"ncols {columns}", f"nrows {rows}", "xllcorner 10", "yllcorner 20", "dx 2", "dy 3",
                 "NODATA_value -9999"]
        for r in range(rows):
            v = 1 - r / (rows - 1)
            cells = []
            for c in range(columns):
                u = c / (columns - 1)
                cells.append("-9999" if hole and hole(r, c) else repr(f(u, v)))
            lines.append(" ".join(cells))
        return self.write(name, "\n".join(lines) + "\n")

    def read_csv(self, text):
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        names = lines[0].split(",")
        return [dict(zip(names, map(float, line.split(",")))) for line in lines[1:]]

    def read_raster(self, name):
        head, cells = {}, []
        for line in (self.folder / name).read_text().splitlines():
            words = line.split()
            if words[0][0].isalpha() and words[0].lower() != "nan":
                head[words[0].lower()] = float(words[1])
            else:
                cells.append([float(w) for w in words])
        return head, cells
