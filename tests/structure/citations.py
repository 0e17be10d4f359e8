#!/usr/bin/env python3
"""Checks that what comments and pages cite is there: citations.py ROOT.

[METHOD 4.3]    names a section of docs/method.md, always in this form; several: [METHOD 3.1, 8.5]
[Golub73 2.1]   names an entry of its Sources, a name and two digits of the year; what follows is free
docs/method.md  says "section 4" of itself only where there is one, and names files that there are;
                every entry of its Sources is cited somewhere

Of C++ sources the comments are read, of everything else the whole text. Prints every breach as path:line and exits
with 1 if there is one.
"""

import re
import sys
from pathlib import Path

PAGE = "docs/method.md"
FOLDERS = ["include", "src", "tool", "python", "tests", "bench", "examples", "fuzz", "scripts", "docs"]
SUFFIXES = (".h", ".cpp", ".py", ".md", ".txt", ".cmake", "")
LONGEST = 400  # of what stands in brackets

LITERAL_OR_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\[^\n\']+|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/', re.S)
BRACKETS = re.compile(r"\[([^\[\]]*)\]")
SOURCE = re.compile(r"\b(?:[A-Z]|d[eo][A-Z])[a-z]{2,}\d\d\b")
SECTIONS = re.compile(r"\s+(\d+(?:\.\d+)?(?:,\s+\d+(?:\.\d+)?)*)(?=\s*(?:;|$))")
OTHER_FORM = re.compile(r"\bMETHOD,? +\d|\b[Mm]ethod(?:\.md\)?)?,? +(?:section +)?\d")


def blank(text):
    return re.sub(r"[^\n]", " ", text)


def comments(text):
    """The text with everything blank but its comments; places stay."""

    def keep(match):
        part = match[0]
        return re.sub(r"^(//+<?|/\*+)", lambda m: " " * len(m[0]), part) if part[0] == "/" else blank(part)

    result, end = [], 0
    for match in LITERAL_OR_COMMENT.finditer(text):
        result += [blank(text[end:match.start()]), keep(match)]
        end = match.end()
    return "".join(result) + blank(text[end:])


def files(root):
    this = Path(__file__).resolve().parent
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            mine = path.name.startswith("citations") and path.resolve().parent == this  # they cite what is not there
            if path.is_file() and path.suffix in SUFFIXES and "build" not in path.parts and not mine:
                yield path
    yield from sorted(root.glob("*.md"))


def read(path):
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:  # data
        return ""
    return comments(text) if path.suffix in (".h", ".cpp") else text


def line_of(text, place):
    return text.count("\n", 0, place) + 1


class Page:
    """What docs/method.md has to be cited."""

    def __init__(self, root):
        self.text = (root / PAGE).read_text(encoding="utf-8")
        self.body, _, listed = self.text.partition("\n## Sources\n")
        self.sections = set(re.findall(r"^##+ (\d+(?:\.\d+)?)\.? ", self.body, re.M))
        first = len(self.text) - len(listed)
        self.sources = {}  # name -> line
        for entry in re.finditer(r"^- \*\*.*?(?=: )", listed, re.M):
            for name in re.findall(r"\*\*(\w+)\*\*", entry[0]):
                self.sources[name] = line_of(self.text, first + entry.start())


def check_text(where, text, page, cited):
    """Breaches of one text; adds to the names cited."""
    outside = text
    for match in BRACKETS.finditer(text):
        inside = match[1]
        if len(inside) > LONGEST:
            continue
        line = line_of(text, match.start())
        for name in SOURCE.findall(inside):
            cited.add(name)
            if name not in page.sources:
                yield f"{where}:{line}: [{name}] is not among the Sources of {PAGE}"
        for method in re.finditer(r"\bMETHOD\b", inside):
            numbers = SECTIONS.match(inside, method.end())
            if not numbers:
                yield f"{where}:{line}: [{' '.join(inside.split())}] should name sections by number, as in [METHOD 4.3]"
                continue
            for number in re.split(r",\s+", numbers[1]):
                if number not in page.sections:
                    yield f"{where}:{line}: {PAGE} has no section {number}"
        if "METHOD" in inside:
            outside = outside[:match.start()] + blank(match[0]) + outside[match.end():]
    for match in OTHER_FORM.finditer(outside):
        form = " ".join(match[0].split())
        yield f'{where}:{line_of(outside, match.start())}: "{form}" should be written as in [METHOD 4.3]'


def check_page(root, page):
    """What the page says of itself and of the sources' files."""
    for match in re.finditer(r"\bsections?\s+(\d+(?:\.\d+)?)(?:\s+and\s+(\d+(?:\.\d+)?))?", page.body):
        for number in filter(None, match.groups()):
            if number not in page.sections:
                yield f"{PAGE}:{line_of(page.body, match.start())}: there is no section {number}"
    names = {path.name for folder in FOLDERS for path in (root / folder).rglob("*")}
    for match in re.finditer(r"`(\w+\.(?:h|cpp))`", page.body):
        if match[1] not in names:
            yield f"{PAGE}:{line_of(page.body, match.start())}: `{match[1]}` is not there"


def check(root):
    page = Page(root)
    cited = set()
    for path in files(root):
        where = path.relative_to(root).as_posix()
        yield from check_text(where, page.body if where == PAGE else read(path), page, cited)
    yield from check_page(root, page)
    for name, line in page.sources.items():
        if name not in cited:
            yield f"{PAGE}:{line}: {name} is cited nowhere"


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    breaches = list(check(Path(arguments[0])))
    print("\n".join(breaches) if breaches else "nothing wrong")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
