"""Every option that a message or a page names is one that the tool has."""

import re
import unittest

from harness import SOURCE, ToolTest
from help_test import COMMANDS, all_names_of

# Options of other programs and of the project's scripts, which pages and messages name too.
OTHERS = {
    "--preset", "--build", "--install", "--component", "--prefix", "--target", "--test-dir",  # cmake, ctest
    "--headless", "--convert-to",  # libreoffice, in messages about spreadsheets
    "--cflags", "--libs", "--static",  # pkg-config
    "--no-build-isolation", "--no-deps",  # of pip
    "--span-ratio", "--span-ration",  # the exercise of docs/how-to-add-an-option.md
}
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*[a-z](?![\w-])")
PAGES = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md"]


def words_of_code(text):
    """The string literals of C++ code, joined where they follow each other."""
    text = re.sub(r"//[^\n]*", "", text)
    return " ".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', re.sub(r'"\s*\n\s*"', "", text)))


class Said(ToolTest):
    def known(self):
        names = {"--version"}
        for command in COMMANDS:
            names |= all_names_of(self.run_tool(command, "--help-all").stdout)
        return names

    def check(self, paths, words_of):
        known = self.known() | OTHERS
        for script in (SOURCE / "scripts").iterdir():
            known |= set(OPTION.findall(script.read_text(encoding="utf-8")))
        for program in (SOURCE / "tests").rglob("*.py"):  # the matrix, which scripts/matrix starts
            known |= set(re.findall(r'add_argument\("(--[a-z-]+)"', program.read_text(encoding="utf-8")))
        found = 0
        for path in paths:
            for option in OPTION.findall(words_of(path.read_text(encoding="utf-8"))):
                found += 1
                self.assertIn(option, known, f"{path.relative_to(SOURCE)} names {option}")
        self.assertGreater(found, 20)

    def test_by_pages(self):
        pages = [SOURCE / page for page in PAGES] + sorted((SOURCE / "docs").rglob("*.md"))
        self.check(pages, lambda text: text)

    def test_by_messages(self):
        paths = [p for folder in ("src", "tool", "include") for p in sorted((SOURCE / folder).rglob("*.cpp"))
                 if p.name != "applicable_options.cpp"]  # names an option only where it was given
        self.check(paths, words_of_code)

    def test_every_remedy_of_the_library_has_words_of_the_tool(self):
        header = (SOURCE / "include" / "knotfit" / "remedy.h").read_text(encoding="utf-8")
        remedies = re.findall(r"^  (\w+),? +///<", re.search(r"enum class Remedy \{(.*?)\};", header, re.S)[1], re.M)
        code = (SOURCE / "tool" / "remedy_words.cpp").read_text(encoding="utf-8")
        words = dict(re.findall(r'\{Remedy::(\w+), "([^"]+)"\}', code))
        self.assertEqual(list(words), remedies)
        self.assertGreater(len(remedies), 20)
        known = self.known()
        for remedy, said in words.items():
            with self.subTest(remedy=remedy):
                if said.startswith("--"):
                    self.assertIn(said, known)
                else:
                    _, command, *others = said.split()
                    self.assertIn(command, COMMANDS)
                    options = self.run_tool(command, "--help-all").stdout
                    for option in (word for word in others if word.startswith("-")):
                        self.assertRegex(options, rf"(?m)^  {option},")

    def test_the_check_sees_what_is_wrong(self):
        self.assertEqual(words_of_code('f("a --b"\n   "ad c"); // "--no"'), "a --bad c")
        self.assertEqual(OPTION.findall("`--format csv`, a -- b, x--y, --input-format=csv --tol"),
                         ["--format", "--input-format", "--tol"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
