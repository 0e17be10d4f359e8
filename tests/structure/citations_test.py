#!/usr/bin/env python3
"""The citation check finds what it is there to find: small trees with one breach each."""

import tempfile
import unittest
from pathlib import Path

import citations

PAGE = """# The method

## 1. Fits

### 1.1 The problem

After [Golub73 2.1], in `fit.cpp`, as section 1 says.

## 2. Knots

## Sources

- **Golub73**: G. Golub, V. Pereyra, 1973.
- **Bowyer81**, **Watson81**: two of them
  on two lines.
"""
GOOD = {"src/fit/fit.cpp": "// Circles [Bowyer81, Watson81; METHOD 1.1, 2].\n"}


class Citations(unittest.TestCase):
    def breaches(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in {citations.PAGE: PAGE, **GOOD, **files}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            return list(citations.check(root))

    def one(self, files, *words):
        found = self.breaches(files)
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_what_is_there_is_right(self):
        self.assertEqual([], self.breaches({}))
        self.assertEqual([], self.breaches({
            "include/knotfit/a.h": "/// On [0,1] by their [Golub73 2.1,\n///   page 3; METHOD\n/// 1.1]: x[i] in\nint a;\n",
            "docs/a.md": "See [METHOD 2] and the [page](method.md), [Golub73; Watson81].\n",
            "tests/a_test.py": "# [METHOD 1]\n"}))

    def test_a_source_without_an_entry_is_found(self):
        for name in ["src/a.h", "tests/a_test.cpp", "tool/a.cpp"]:
            self.one({name: "\n\n// By steps [Golub73; Jupp78].\n"}, f"{name}:3", "Jupp78", "Sources")
        self.one({"docs/a.md": "By steps [Jupp78].\n"}, "docs/a.md:1", "Jupp78")
        self.one({"src/a.cpp": "/// From here on [Golub73 2.1,\n/// Jupp78].\n"}, "src/a.cpp:1", "Jupp78")
        self.one({"src/a.cpp": "int a = 200'000;  // [doCarmo76 3.3], not 300'000\n"}, "doCarmo76")

    def test_a_section_that_is_not_there_is_found(self):
        self.one({"src/a.cpp": "int a;  ///< [METHOD 1.2]\n"}, "src/a.cpp:1", "no section 1.2")
        self.one({"README.md": "[METHOD 1.1, 7]\n"}, "README.md:1", "no section 7")
        self.one({"src/a.cpp": "// [Golub73; METHOD 3]\n"}, "no section 3")

    def test_another_form_is_found(self):
        for text in ["[METHOD 1, \"the problem\"]", "[METHOD, \"insertion\"]", "[Golub73, METHOD]", "[METHOD 1 and 2]",
                     "METHOD 1.1: all of it", "(method 1.1)", "method.md, section 1", "[method.md](method.md), section 1"]:
            self.one({"docs/a.md": text + "\n"}, "docs/a.md:1", "as in [METHOD 4.3]")
        self.one({"src/a.cpp": "\n// the constants of METHOD 1.1\n"}, "src/a.cpp:2", "as in [METHOD 4.3]")

    def test_code_cites_nothing(self):
        self.assertEqual([], self.breaches({
            "src/a.cpp": 'const char* s = "[Jupp78] METHOD 9 // [Jupp78]";\nint x = sizes[Base64 + METHOD];\n'}))

    def test_a_source_that_nobody_cites_is_found(self):
        self.one({"src/fit/fit.cpp": "// Circles [Bowyer81].\n"}, f"{citations.PAGE}:14", "Watson81", "nowhere")

    def test_the_page_speaks_of_what_it_has(self):
        self.one({citations.PAGE: PAGE.replace("section 1 says", "section 3 says")}, "no section 3")
        self.one({citations.PAGE: PAGE.replace("`fit.cpp`", "`gone.cpp`")}, f"{citations.PAGE}:7", "gone.cpp")


if __name__ == "__main__":
    unittest.main()
