"""What the tool says of itself: help, lists, the man page and the completions agree."""

import json
import os
import re
import shlex
import shutil
import subprocess
import unittest
from pathlib import Path

from harness import SOURCE, TOOL, ToolTest

COMMANDS = ["fit", "compare", "fit-curve", "parameterize", "eval", "distance", "info", "convert", "methods", "formats"]
COMPLETION = Path(TOOL).resolve().parent / "pages"  # made with the tool
MAN = COMPLETION / "knotfit.1"


def options_of(text):
    """Long options of a help text: those at the start of its lines, by their first names."""
    return set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.M))


def all_names_of(text):
    """The same by every long name."""
    return {name for line in re.findall(r"^  ((?:-\w,)?--[a-z,-]+)", text, re.M) for name in line.split(",")
            if name.startswith("--")}


class Help(ToolTest):
    def help(self, *command):
        """The help with every option."""
        return self.run_tool(*command, "--help-all").stdout

    def test_version(self):
        self.assertRegex(self.run_tool("--version").stdout, r"^knotfit \d+\.\d+\.\d+\n$")

    def test_the_general_help_lists_the_commands_and_the_exit_statuses(self):
        text = self.run_tool("--help").stdout
        for command in COMMANDS:
            self.assertRegex(text, rf"(?m)^  {command} ")
        self.assertIn("130 stopped", text)
        self.assertEqual(self.run_tool("-h").stdout, text)

    def test_lines_fit_a_wide_terminal(self):
        for command in ([], *[[c] for c in COMMANDS]):
            for line in self.help(*command).splitlines() + self.run_tool(*command, "--help").stdout.splitlines():
                self.assertLessEqual(len(line), 110, line)

    def test_the_help_shows_what_most_people_need_and_names_the_rest(self):
        for command in ("fit", "compare", "fit-curve"):
            with self.subTest(command=command):
                short, full = self.run_tool(command, "--help").stdout, self.help(command)
                shown = options_of(short) - {"--help", "--help-all"}
                self.assertEqual(len(shown), 15)
                self.assertLess(shown, options_of(full))
                more = len(options_of(full) - options_of(short))
                self.assertIn(f"{more} more options: knotfit {command} --help-all\n", short)
                self.assertIn(f"  knotfit {command} samples/", short)
                self.assertNotIn("more options", full)
        fit = options_of(self.run_tool("fit", "--help").stdout)
        self.assertLessEqual({"--tol", "--control-points", "--columns", "--height-field", "--output", "--json"}, fit)

    def test_a_short_help_is_the_whole_one(self):
        for command in ("parameterize", "eval", "distance", "info", "convert", "methods", "formats"):
            self.assertEqual(self.run_tool(command, "--help").stdout, self.help(command))

    def test_every_option_of_every_command_in_one_text(self):
        text = self.help()
        for command in COMMANDS:
            self.assertIn(self.help(command), text)

    def test_a_bare_call_prints_the_general_help(self):
        done = self.run_tool()
        self.assertEqual((done.stdout, done.stderr), (self.run_tool("--help").stdout, ""))
        self.assertLess(len(done.stdout.splitlines()), 45)

    def test_the_nearest_name_is_named(self):
        for arguments, words in [
            (["ftt", "a.csv"], ["'ftt'", "did you mean fit?"]), (["fitcurve"], ["did you mean fit-curve?"]),
            (["parametrise"], ["did you mean parameterize?"]), (["Info"], ["did you mean info?"]),
            (["help", "fit"], ["did you mean --help?"]), (["version"], ["did you mean --version?"]),
            (["points.csv"], ["'points.csv'", "knotfit fit points.csv"]),
            (["zzzzz"], ["'zzzzz'", "knotfit --help"]),
            (["fit", "a.csv", "--tolerance", "1%"], ["--tolerance", "did you mean --tol?"]),
            (["fit", "a.csv", "--tolerance=1%"], ["--tolerance", "did you mean --tol?"]),
            (["fit", "a.csv", "--control_points", "5"], ["did you mean --control-points?"]),
            (["fit", "a.csv", "--contol-points", "5"], ["did you mean --control-points?"]),
            (["fit", "--hieght-field", "a.csv"], ["did you mean --height-field?"]),
            (["fit", "a.csv", "--format", "csv"], ["--format", "did you mean --input-format?"]),
            (["fit", "a.csv", "--out", "a.json"], ["did you mean --output?"]),
            (["info", "a.csv", "--jsn"], ["did you mean --json?"]),
            (["eval", "a.json", "--tol", "1%"], ["eval has no option --tol", "fit"]),
            (["fit", "a.csv", "--zzzzzzzz"], ["fit has no option --zzzzzzzz", "--help-all"]),
            (["--tol", "1%"], ["--tol", "comes after a command", "fit"]),
            (["--tol", "1%", "fit", "a.csv"], ["--tol", "comes after a command", "fit"]),
            (["ftt", "fit"], ["'ftt'"]), (["--vresion"], ["did you mean --version?"]),
        ]:
            with self.subTest(arguments=arguments):
                self.refused(*arguments, words=words)
        self.assertNotIn("did you mean", self.refused("fit", "a.csv", "--zzzzzzzz"))
        self.assertNotIn("did you mean", self.refused("zzzzz"))

    def test_every_option_of_the_issue_is_there(self):
        wanted = ("--tol --within --rms --control-points --knots --knots-u --knots-v --knots-from --degree --refine "
                  "--max-control-points --max-fits --time-limit --height-field --spacing --rescale-parameters "
                  "--duplicates --columns --input-format --nodata --skip-lines --classes --returns --feature --feature-file --smoothing --between --cell --fill-holes "
                  "--output --force --threads --quiet --json --options --weld --largest-part --orient --drop-degenerate "
                  "--corners --omega --base --new-parameters --correct --fairness --samples --reflections --unit --name --step-schema "
                  "--cad-safe --cad-tol").split()
        self.assertLessEqual(set(wanted), options_of(self.help("fit")))
        wanted = "--at --points --grid --derivatives --derivative --normals --curvature --clamp --json --output".split()
        self.assertLessEqual(set(wanted), options_of(self.help("eval")))
        self.assertLessEqual({"--cell", "--grid", "--samples", "--output", "--force"}, options_of(self.help("convert")))
        wanted = ("--weld --largest-part --fill-holes --orient --drop-degenerate --corners --omega --map --lines --output --json").split()
        self.assertLessEqual(set(wanted), options_of(self.help("parameterize")))

    def test_methods_of_the_help_are_those_of_the_table(self):
        methods = json.loads(self.run_tool("methods", "--json").stdout)
        names = self.run_tool("methods", "--names").stdout.split()
        self.assertEqual([m["name"] for m in methods], names)
        text = " ".join(self.help("fit").split())
        self.assertIn(", ".join(names), text)
        listed = self.run_tool("methods").stdout
        for method in methods:
            self.assertTrue(method["summary"])
            self.assertIn(method["summary"], listed)

    def test_formats_are_listed_and_every_output_is_among_them(self):
        formats = json.loads(self.run_tool("formats", "--json").stdout)
        written = {e for f in formats if f["writes"] for e in f["extensions"].split()}
        self.assertLessEqual({".json", ".csv", ".asc", ".grd", ".png", ".svg", ".pdf", ".obj", ".ply", ".vts"}, written)
        read = {e for f in formats if f["reads"] for e in f["extensions"].split()}
        self.assertLessEqual({".asc", ".csv", ".txt", ".xyz", ".npy", ".json", ".ply", ".obj", ".off", ".stl"}, read)
        self.assertEqual(self.run_tool("formats", "--names").stdout.split(), [f["name"] for f in formats])
        self.assertIn("ESRI", self.run_tool("formats").stdout)

    def test_the_default_that_the_help_names_is_the_one_in_force(self):
        self.write_points()
        stored = self.run_json("fit", "points.csv", "--control-points", "5")["options"]
        helps = {}
        for block in re.split(r"\n(?=  (?:-\w,)?--)", self.help("fit")):
            helps[block.split()[0].split(",")[-1]] = " ".join(block.split())
        for option in ("--degree", "--shear", "--guard", "--feature", "--smoothing", "--spacing", "--duplicates", "--base",
                       "--correct", "--fairness", "--samples", "--between", "--knots"):
            with self.subTest(option=option):
                value = stored[option[2:]]
                value = value[0] if isinstance(value, list) else {True: "on", False: "off"}[value] \
                    if isinstance(value, bool) else value
                shown = f"{value:g}".replace("e-0", "e-") if isinstance(value, float) else str(value)
                self.assertRegex(helps[option], rf"[Dd]efault {re.escape(shown)}(?![\w-])")
        self.assertIn(f"({stored['refine']}, default)", helps["--refine"])
        self.assertIn(f"{stored['effort']} (default)", helps["--effort"])
        self.assertIn(f"{stored['corners']} (default)", helps["--corners"])

    def test_what_shapes_a_result_is_stored(self):
        """Every option of fit is in the stored options, or is known not to shape a result."""
        self.write_points()
        stored = self.run_json("fit", "points.csv", "--control-points", "5")["options"]
        others = {"--help", "--help-all", "--output", "--force", "--json", "--threads", "--quiet", "--options", "--reflections", "--knots-u",
                  "--knots-v", "--knots-from", "--no-height-field", "--no-rescale-parameters", "--no-fill-holes", "--no-largest-part",
                  "--no-orient", "--no-drop-degenerate", "--no-new-parameters", "--no-cad-safe"}
        names = {"--tol": "tolerance", "--within": "measure", "--rms": "measure"}
        for option in options_of(self.help("fit")) - others:
            self.assertIn(names.get(option, option[2:].replace("-", "_")), stored)


class ManPage(ToolTest):
    def test_names_every_command_and_option(self):
        text = MAN.read_text().replace("\\-", "-")
        for command in COMMANDS:
            self.assertIn(f"knotfit {command}", text)
            for option in all_names_of(self.run_tool(command, "--help-all").stdout):
                self.assertRegex(text, re.escape(option) + r"(?![a-z-])", f"{command} {option}")

    def test_names_no_option_that_is_none(self):
        known = {"--version"}
        for command in COMMANDS:
            known |= all_names_of(self.run_tool(command, "--help-all").stdout)
        self.assertLessEqual(set(re.findall(r"--[a-z][a-z-]*", MAN.read_text().replace("\\-", "-"))), known)

    def test_is_of_this_version(self):
        self.assertIn(self.run_tool("--version").stdout.split()[1], MAN.read_text().splitlines()[1])

    def test_can_be_set(self):
        if not shutil.which("man"):
            self.skipTest("there is no man")
        done = subprocess.run(["man", "--warnings", "-l", str(MAN)], capture_output=True, text=True, timeout=60,
                              env={**os.environ, "MANWIDTH": "100", "LC_ALL": "C.UTF-8"})
        if "minimized" in done.stdout + done.stderr:
            self.skipTest("this system has no manual pages")
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class Pages(ToolTest):
    """The program that makes the pages refuses a man page that would leave an option out."""

    def make(self, template):
        self.write("page.in", template)
        return subprocess.run([COMPLETION.parent / "knotfit_pages", "page.in", "."], cwd=self.folder, capture_output=True,
                              text=True, timeout=60)

    def test_every_option_has_its_line(self):
        template = (SOURCE / "tool" / "man" / "knotfit.1.in").read_text()
        self.assertEqual(self.make(template).returncode, 0)
        self.assertEqual((self.folder / "knotfit.1").read_text(), MAN.read_text())
        for without, word in [('.\\" @options fit Knots\n', "--evaluations"), ('.\\" @options methods\n', "--names")]:
            self.assertIn(without, template)
            done = self.make(template.replace(without, ""))
            self.assertEqual(done.returncode, 1)
            self.assertIn("no line of the man page has --", done.stderr)

    def test_a_line_names_a_command_and_a_group_with_options(self):
        for line in ("nothing", "fit Nonsense", "eval Knots"):
            done = self.make(f'.\\" @options {line}\n')
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"there is no option for the line .\\\" @options {line}", done.stderr)

    def test_a_template_that_is_not_there(self):
        done = subprocess.run([COMPLETION.parent / "knotfit_pages", "none.in", "."], cwd=self.folder, capture_output=True,
                              text=True)
        self.assertEqual((done.returncode, self.files()), (1, []))
        self.assertIn("none.in: cannot be read", done.stderr)


class Completions(ToolTest):
    def test_every_shell_knows_every_option(self):
        for name in ("knotfit.bash", "_knotfit", "knotfit.fish"):
            text = (COMPLETION / name).read_text()
            for command in COMMANDS:
                self.assertIn(command, text)
                for option in all_names_of(self.run_tool(command, "--help-all").stdout):
                    wanted = f"-l {option[2:]}" if name.endswith("fish") else option
                    self.assertRegex(text, re.escape(wanted) + r"(?![a-z-])", f"{name}: {command} {option}")

    def complete(self, *words):
        """What bash offers for the last word."""
        script = f"""
          source {shlex.quote(str(COMPLETION / 'knotfit.bash'))}
          COMP_WORDS=({' '.join(shlex.quote(w) for w in words)}); COMP_CWORD={len(words) - 1}
          _knotfit; printf '%s\\n' "${{COMPREPLY[@]}}"
        """
        path = f"{os.path.dirname(os.path.abspath(TOOL))}:{os.environ['PATH']}"
        done = subprocess.run(["bash", "--norc", "-c", script], cwd=self.folder, capture_output=True, text=True,
                              env={**os.environ, "PATH": path}, timeout=60)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_bash_offers_the_options_of_the_command(self):
        for command in COMMANDS:
            with self.subTest(command=command):
                there = all_names_of(self.run_tool(command, "--help-all").stdout)
                self.assertEqual(set(self.complete("knotfit", command, "--")), there)

    def test_values_by_name_are_offered(self):
        for command, option, values in [
            ("fit", "--feature", "hessian curvature derivative residual"), ("fit", "--guard", "on off"),
            ("fit", "--shear", "auto off"), ("fit", "--returns", "first last"), ("convert", "--unit", "mm m inch"),
            ("compare", "--duplicates", "fail mean lowest highest"), ("fit", "--tol", ""), ("fit", "--columns", ""),
            ("eval", "--at", ""), ("fit", "--control-points", ""), ("parameterize", "--map", "newton mean-value"),
        ]:
            with self.subTest(option=option):
                self.assertEqual(self.complete("knotfit", command, option, ""), values.split())
        self.write("s.json", "")
        self.assertEqual(self.complete("knotfit", "fit", "--base", ""), "auto plane cylinder graph s.json".split())
        self.assertEqual(self.complete("knotfit", "compare", "--methods", "al"), ["all"])
        self.assertEqual(self.complete("knotfit", "fit", "--input-format", "npy-"), ["npy-grid"])

    def test_bash_completes(self):
        self.assertEqual(self.complete("knotfit", "con"), ["convert"])
        self.assertEqual(self.complete("knotfit", "fit", "--knots-f"), ["--knots-from"])
        self.assertEqual(self.complete("knotfit", "fit", "--refine", "s"), ["search"])
        methods = self.run_tool("methods", "--names").stdout.split()
        self.assertEqual(self.complete("knotfit", "fit", "--knots", ""), methods)
        self.write("points.csv", "")
        self.write("s.json", "")
        self.assertEqual(self.complete("knotfit", "fit", "po"), ["points.csv"])
        self.assertEqual(self.complete("knotfit", "parameterize", "--corners", "sh"), ["sharpest"])
        self.assertEqual(self.complete("knotfit", "eval", "s"), ["s.json"])

    def test_shells_that_are_there_take_their_file(self):
        for shell, name, arguments in [("zsh", "_knotfit", ["-n"]), ("fish", "knotfit.fish", ["--no-execute"]),
                                       ("bash", "knotfit.bash", ["-n"])]:
            if shutil.which(shell):
                with self.subTest(shell=shell):
                    done = subprocess.run([shell, *arguments, str(COMPLETION / name)], capture_output=True, text=True)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main(verbosity=2)
