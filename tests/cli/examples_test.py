"""The examples of every help text, run as they are printed."""

import os
import shlex
import shutil
import subprocess
import unittest

from harness import SAMPLES, TOOL, ToolTest


class Examples(ToolTest):
    def test_examples_work_as_printed(self):
        (self.folder / "samples").symlink_to(SAMPLES)
        path = f"{os.path.dirname(os.path.abspath(TOOL))}:{os.environ['PATH']}"
        for command in ([], ["fit"], ["compare"], ["fit-curve"], ["parameterize"], ["eval"], ["distance"], ["info"], ["convert"]):
            text = self.run_tool(*command, "--help").stdout
            lines = [line.strip() for line in text.splitlines() if line.startswith("  knotfit ")]
            self.assertGreaterEqual(len(lines), 2, text)
            for line in lines:
                with self.subTest(example=line):
                    done = subprocess.run(shlex.split(line), cwd=self.folder, capture_output=True, text=True,
                                          env={**os.environ, "PATH": path}, timeout=300)
                    self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
            for path_made in self.folder.iterdir():
                if path_made.is_symlink():
                    continue
                shutil.rmtree(path_made) if path_made.is_dir() else path_made.unlink()


if __name__ == "__main__":
    unittest.main(verbosity=2)
