#!/usr/bin/env python3
"""The structure checks find what they are there to find: small trees with one breach each."""

import tempfile
import unittest
from pathlib import Path

import structure


PAGE = """
| folder | what it does | public headers |
|---|---|---|
| `src/base/` | counts | `index.h` |
| `src/data/` | points | `points.h` |
| `src/spline/` | surfaces | `surface.h` |
| `src/place/` | knots | `place.h` |
| `src/search/` | sizes | `refine.h` |
"""


class Structure(unittest.TestCase):
    def breaches(self, check, files):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in {structure.DOCUMENT: PAGE, **files}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            return list(check(root))

    def one(self, check, files, *words):
        found = self.breaches(check, files)
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_an_arrow_to_the_left_is_right(self):
        self.assertEqual([], self.breaches(structure.check_includes, {
            "src/place/a.cpp": '#include <vector>\n#include "fit/b.h"\n#include "place/c.h"\n'
                               '#include "knotfit/index.h"\n',
            "src/fit/b.h": "", "src/place/c.h": "", "include/knotfit/index.h": ""}))

    def test_an_arrow_to_the_right_is_found(self):
        self.one(structure.check_includes,
                 {"src/fit/a.cpp": '\n#include "place/b.h"\n', "src/place/b.h": ""},
                 "src/fit/a.cpp:2", "fit -> place", "right")

    def test_a_public_header_counts_as_its_folder(self):
        self.one(structure.check_includes,
                 {"src/spline/a.cpp": '#include "knotfit/refine.h"\n', "include/knotfit/refine.h": ""},
                 "spline -> search")

    def test_public_headers_keep_the_order_too(self):
        self.one(structure.check_includes,
                 {"include/knotfit/surface.h": '#include "knotfit/place.h"\n',
                  "include/knotfit/place.h": ""},
                 "include/knotfit/surface.h:1", "spline -> place")

    def test_verify_and_solve_do_not_see_each_other(self):
        for one, other in [("verify", "solve"), ("solve", "verify")]:
            self.one(structure.check_includes,
                     {f"src/{one}/a.cpp": f'#include "{other}/b.h"\n', f"src/{other}/b.h": ""},
                     f"{one} -> {other}", "sideways")

    def test_an_include_that_names_no_folder_is_found(self):
        self.one(structure.check_includes,
                 {"src/fit/a.cpp": '#include "b.h"\n', "src/fit/b.h": ""}, '"b.h"', "neither")

    def test_an_include_of_nothing_is_found(self):
        self.one(structure.check_includes, {"src/fit/a.cpp": '#include "fit/b.h"\n'}, "not there")

    def test_a_public_header_without_a_folder_is_found(self):
        self.one(structure.check_includes, {"include/knotfit/new.h": ""}, "new.h", structure.DOCUMENT)

    def test_other_libraries_stay_out_of_headers(self):
        for folder in ["include/knotfit", "src/fit"]:
            self.one(structure.check_headers,
                     {f"{folder}/a.h": "#pragma once\n#include <Eigen/Core>\n"}, "a.h:2", "Eigen/Core")

    def test_a_public_header_includes_no_internal_one(self):
        self.one(structure.check_headers,
                 {"include/knotfit/points.h": '#pragma once\n#include "base/narrow.h"\n'}, "base/narrow.h")

    def test_the_command_line_parser_stays_in_the_tool(self):
        self.one(structure.check_headers, {"src/fit/a.cpp": "#include <CLI/CLI.hpp>\n"}, "tool/")

    def test_a_long_file_is_found(self):
        self.one(structure.check_length, {"src/fit/a.cpp": "\n" * 601}, "601")
        self.assertEqual([], self.breaches(structure.check_length, {"src/fit/a.cpp": "\n" * 600}))

    def test_an_option_of_the_tool_in_the_library_is_found(self):
        for text in ['throw InvalidInput("\\"a\\": --orient turns it");\n', "/// as in --knots\n",
                     'f("(knotfit convert MESH -o "\n  "points.csv)");\n', "/* one\n   --two */\n"]:
            for path in ("src/data/a.cpp", "include/knotfit/points.h"):
                self.one(structure.check_flags, {path: text}, path, "option of the tool")
        self.one(structure.check_flags, {"src/data/a.cpp": '\n\nf("libreoffice --headless --convert-to csv IN --a");'},
                 "src/data/a.cpp:3", "--a is")
        self.assertEqual([], self.breaches(structure.check_flags, {
            "src/data/a.cpp": "for (; n > 0; --n) x = '\"' - --m;  // n--, a -- b, x--y\nconst int k = 1'000;\n"
                              'f("libreoffice --headless --convert-to csv IN", "`orient`, -1, ---");\n',
            "tool/main.cpp": '"--orient"\n'}))

    def test_a_page_that_nobody_links_is_found(self):
        pages = {"README.md": "[a](docs/a.md)\n", "docs/a.md": "# A\n[b](sub/b.md#the-b-its-own)\n",
                 structure.DOCUMENT: "[back](../README.md)\n", "docs/sub/b.md": "# The `b`, its own\n"}
        self.one(structure.check_pages, pages, structure.DOCUMENT, "no link")
        linked = dict(pages, **{"README.md": f"[a](docs/a.md)\n[x]({structure.DOCUMENT})\n"})
        self.assertEqual([], self.breaches(structure.check_pages, linked))
        # A link in code, or from a page that is not reached itself, is none.
        for text in ["`[x](docs/architecture.md)`\n", "```sh\n[x](docs/architecture.md)\n```\n"]:
            self.one(structure.check_pages, dict(pages, **{"README.md": "[a](docs/a.md)\n" + text}), "no link")

    def test_a_link_that_leads_nowhere_is_found(self):
        pages = {"README.md": f"[x]({structure.DOCUMENT})\n[site](https://example.org/x)\n"}
        self.one(structure.check_pages, dict(pages, **{"CHANGELOG.md": "\n[a](docs/gone.md)\n"}),
                 "CHANGELOG.md:2", "docs/gone.md", "nowhere")
        self.one(structure.check_pages, dict(pages, **{"CHANGELOG.md": f"[a]({structure.DOCUMENT}#gone)\n"}),
                 "#gone", "heading")

    def test_a_source_file_without_a_test_is_found(self):
        mirrored = {"src/fit/a.cpp": "", "tests/fit/a_test.cpp": "",
                    "src/formats/cad/b.cpp": "", "tests/cad/b_test.cpp": ""}
        self.assertEqual([], self.breaches(structure.check_mirrors, mirrored))
        for source, test in [("src/fit/a.cpp", "tests/fit/a_test.cpp"),
                             ("src/formats/cad/b.cpp", "tests/cad/b_test.cpp")]:
            files = {name: text for name, text in mirrored.items() if name != test}
            self.one(structure.check_mirrors, files, f"{source}:1: write {test}", structure.MIRRORS)
        # A test of the same name in another folder is none.
        self.one(structure.check_mirrors, {"src/fit/a.cpp": "", "tests/solve/a_test.cpp": ""}, "tests/fit/a_test.cpp")

    def test_a_row_stands_for_a_test_of_the_same_name(self):
        files = {"src/fit/a.cpp": "", "src/fit/b.cpp": "", "tests/fit/b_test.cpp": ""}
        table = structure.MIRRORS
        self.assertEqual([], self.breaches(structure.check_mirrors, {
            **files, table: "# source  test\n\nfit/a  fit/b_test.cpp\n"}))
        rows = "# source  test\nfit/a  fit/b_test.cpp\n"
        self.one(structure.check_mirrors, {**files, table: rows + "fit/b  fit/b_test.cpp\n"},
                 f"{table}:3", "tests/fit/b_test.cpp", "take the row out")
        self.one(structure.check_mirrors, {**files, table: rows + "fit/gone  fit/b_test.cpp\n"},
                 f"{table}:3", "src/fit/gone.cpp is not there", "take the row out")
        self.one(structure.check_mirrors, {**files, table: rows + "fit/a  fit/b_test.cpp\n"}, f"{table}:3", "sort")
        self.one(structure.check_mirrors, {**files, table: rows + "fit/c\n"}, f"{table}:3", "a row has")
        for test in ["fit/gone_test.cpp", "fit/b.h"]:
            self.one(structure.check_mirrors, {**files, "tests/fit/b.h": "", table: f"fit/a  {test}\n"},
                     f"{table}:1", f"tests/{test}", "name the one")

    def test_a_wrong_order_in_the_documentation_is_found(self):
        root = Path(__file__).resolve().parents[2]
        text = (root / "docs/architecture.md").read_text(encoding="utf-8")
        cmake = (root / "src/CMakeLists.txt").read_text(encoding="utf-8")
        good = {structure.DOCUMENT: text, "src/CMakeLists.txt": cmake, "src/base/a.h": ""}
        good.update((f"include/knotfit/{name}.h", "") for name in structure.header_owners(root))
        self.assertEqual([], self.breaches(structure.check_architecture, good))
        wrong = dict(good, **{structure.DOCUMENT: text.replace("base <", "base < report <", 1)})
        self.one(structure.check_architecture, wrong, "include order")
        wrong = dict(good, **{"src/CMakeLists.txt": cmake.replace("measure place", "place measure")})
        self.one(structure.check_architecture, wrong, "src/CMakeLists.txt")
        wrong = dict(good, **{structure.DOCUMENT: text.replace("`points.h`", "`points.h` `gone.h`", 1)})
        self.one(structure.check_architecture, wrong, "gone.h", "not there")


if __name__ == "__main__":
    unittest.main()
