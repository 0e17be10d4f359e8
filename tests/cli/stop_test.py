"""Ctrl-C and the terminal: stopping keeps the best surface, progress is for people only."""

import json
import os
import pty
import re
import select
import signal
import subprocess
import time
import unittest

from harness import TIMEOUT, TOOL, ToolTest, default_signals, step

# A search that would take minutes: ended by the signal.
LONG = ("fit", "points.csv", "--tol", "1e-7%", "--knots", "optimal", "--control-points", "60x60")


class Stop(ToolTest):
    def start(self, *arguments):
        return subprocess.Popen([TOOL, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, preexec_fn=default_signals)

    def stop_after(self, seconds, sent, *arguments):
        process = self.start(*arguments)
        self.addCleanup(process.kill)
        time.sleep(seconds)
        self.assertIsNone(process.poll(), "it ended before it could be stopped")
        process.send_signal(sent)
        begin = time.monotonic()
        out, err = process.communicate(timeout=TIMEOUT)
        return process.returncode, out, err, time.monotonic() - begin

    def test_ctrl_c_keeps_the_best_surface_so_far(self):
        self.write_points(count=12000, f=step)
        for sent in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=sent.name):
                status, out, err, seconds = self.stop_after(3, sent, *LONG, "--json", "-o", f"{sent.name}.json", "-o",
                                                            f"{sent.name}.csv")
                self.assertEqual((status, err), (130, ""))
                self.assertLess(seconds, 20)
                report = json.loads(out)
                self.assertEqual(report["status"], "stopped")
                self.assertEqual(report["outputs"], [f"{sent.name}.json", f"{sent.name}.csv"])
                surface = self.load(f"{sent.name}.json")
                self.assertEqual(surface["result"]["status"], "stopped")
                self.assertEqual(len(surface["control_points"]), report["size"][0])
                self.assertGreater(report["error"]["max"], 0)

    def test_a_second_ctrl_c_ends_it_at_once(self):
        self.write_points(count=12000, f=step)
        process = self.start(*LONG, "-o", "a.json")
        self.addCleanup(process.kill)
        time.sleep(2)
        begin = time.monotonic()
        while process.poll() is None and time.monotonic() - begin < 30:
            process.send_signal(signal.SIGINT)
            time.sleep(0.02)
        self.assertEqual(process.wait(timeout=30), 130)
        process.communicate(timeout=30)
        self.assertLess(time.monotonic() - begin, 5)
        if "a.json" in self.files():  # the first may have been enough
            self.load("a.json")

    def test_other_commands_end_by_the_signal(self):
        self.write("slow.csv", "")
        os.remove(self.folder / "slow.csv")
        os.mkfifo(self.folder / "slow.csv")
        process = self.start("info", "slow.csv")
        self.addCleanup(process.kill)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)
        self.assertEqual(process.returncode, -signal.SIGINT)


class Terminal(ToolTest):
    def on_terminal(self, *arguments):
        """Standard error on a terminal of its own. Returns (status, standard output, what it showed)."""
        leader, follower = pty.openpty()
        process = subprocess.Popen([TOOL, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=follower,
                                   text=True, preexec_fn=default_signals)
        os.close(follower)
        shown = b""
        deadline = time.monotonic() + TIMEOUT
        while time.monotonic() < deadline:
            if select.select([leader], [], [], 0.1)[0]:
                try:
                    piece = os.read(leader, 65536)
                except OSError:  # the last writer is gone
                    break
                if not piece:
                    break
                shown += piece
        out, _ = process.communicate(timeout=30)
        os.close(leader)
        return process.returncode, out, shown.decode()

    def test_progress_is_shown_on_a_terminal_and_wiped(self):
        self.write_points(count=6000, f=step)
        status, out, shown = self.on_terminal("fit", "points.csv", "--tol", "0.5%", "--json")
        self.assertIn(status, (0, 3))
        json.loads(out)
        self.assertIn("read", shown)
        self.assertRegex(shown, r"\d+ x \d+ control points")
        self.assertIn("error", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"), repr(shown[-80:]))
        for line in re.split(r"\r\x1b\[K", shown):
            self.assertLess(len(line), 80)

    def test_quiet_is_silent_on_a_terminal(self):
        self.write_points()
        self.assertEqual(self.on_terminal("fit", "points.csv", "--tol", "1%", "--quiet"), (0, "", ""))

    def test_nothing_is_shown_where_standard_error_is_a_file(self):
        self.write_points()
        self.assertEqual(self.run_tool("fit", "points.csv", "--tol", "1%", "--json").stderr, "")

    def test_a_time_limit_says_how_much_is_left(self):
        self.write_points(count=12000, f=step)
        status, _, shown = self.on_terminal(*LONG, "--time-limit", "3", "--json")
        self.assertIn(status, (0, 3))  # what it cut short may hold the tolerance already
        self.assertIn("left", shown)


if __name__ == "__main__":
    unittest.main(verbosity=2)
