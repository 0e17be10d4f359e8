#!/usr/bin/env python3
"""Checks the structure of the sources: structure.py ROOT includes|headers|architecture|length|flags|pages|mirrors.

includes      every #include of src/, tool/ and include/ points to the left in ORDER; a public header
              counts as part of the folder that docs/architecture.md gives it
headers       public headers include the standard library and knotfit/*.h only; no header
              includes another library
architecture  docs/architecture.md and src/CMakeLists.txt tell the same order, and the page lists
              the public headers there are
length        no source file is longer than 600 lines
flags         no message or comment of the library names an option of the tool (knotfit/remedy.h names remedies)
pages         links lead from README.md to every page of docs/, and every link of a page leads to something
mirrors       every .cpp of src/ has its test at the same place of tests/, or a row in tests/mirrors.txt that names another

Prints every breach as path:line and exits with 1 if there is one. See docs/architecture.md.
"""

import re
import sys
from pathlib import Path

# Include order: a file may include from folders of earlier groups and from its own folder.
ORDER = [
    ["base"],
    ["data", "spline"],
    ["formats", "solve", "verify"],
    ["fit"],
    ["nearest"],
    ["parameterize"],
    ["correct"],
    ["measure"],
    ["place"],
    ["search"],
    ["pipeline"],
    ["report"],
    ["tool"],
    ["python"],
]
RANK = {folder: rank for rank, group in enumerate(ORDER) for folder in group}

DOCUMENT = "docs/architecture.md"

STANDARD = set(
    """algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv
    chrono cinttypes climits clocale cmath compare complex concepts condition_variable coroutine
    csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime cuchar cwchar cwctype deque
    exception execution filesystem format forward_list fstream functional future initializer_list
    iomanip ios iosfwd iostream istream iterator latch limits list locale map memory memory_resource
    mutex new numbers numeric optional ostream queue random ranges ratio regex scoped_allocator
    semaphore set shared_mutex source_location span sstream stack stdexcept stop_token streambuf
    string string_view syncstream system_error thread tuple type_traits typeindex typeinfo
    unordered_map unordered_set utility valarray variant vector version""".split()
)

INCLUDE = re.compile(r'^\s*#\s*include\s*(<[^>]+>|"[^"]+")')
MAX_LINES = 600


def sources(root, folders, suffixes=(".h", ".cpp")):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in suffixes and path.is_file():
                yield path


def included(path):
    """(line number, name, in angle brackets) of every #include."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1][1:-1], match[1][0] == "<"


def header_owners(root):
    """Public header -> folder, from the rows `| `src/x/` | ... | `a.h` `b.h` |` of the page's table."""
    text = (root / DOCUMENT).read_text(encoding="utf-8")
    rows = re.findall(r"^\| `src/(\w+)/` \|[^|\n]*\|([^|\n]*)\|$", text, re.M)
    return {header: folder for folder, headers in rows for header in re.findall(r"`(\w+)\.h`", headers)}


def folder_of(root, path, owners):
    """The folder of ORDER that a source file belongs to, or None."""
    parts = path.relative_to(root).parts
    if parts[0] in ("tool", "python"):
        return parts[0]
    if parts[:2] == ("include", "knotfit"):
        return owners.get(path.stem)
    return parts[1] if parts[0] == "src" and len(parts) > 2 else None


def target_of(name, owners):
    """The folder that an include in quotes leads to, or None."""
    parts = name.split("/")
    if len(parts) == 2 and parts[0] == "knotfit":
        return owners.get(Path(parts[1]).stem)
    return parts[0] if len(parts) > 1 and parts[0] in RANK else None


def check_includes(root):
    owners = header_owners(root)
    for path in sources(root, ["src", "tool", "python", "include"]):
        where = path.relative_to(root)
        folder = folder_of(root, path, owners)
        if folder not in RANK:
            table = f"the table of {DOCUMENT}" if where.parts[0] == "include" else "the include order"
            yield f"{where}:1: belongs to no folder of {table}"
            continue
        for number, name, angle in included(path):
            if angle:
                continue
            target = target_of(name, owners)
            if folder in ("tool", "python") and (path.parent / name).is_file():
                continue  # these lie outside src/, so their own headers go by their bare name
            if target is None:
                yield f'{where}:{number}: "{name}" is neither "folder/name.h" nor "knotfit/name.h"'
            elif not any((root / base / name).is_file() for base in ("src", "include", ".")):
                yield f'{where}:{number}: "{name}" is not there'
            elif target != folder and RANK[target] >= RANK[folder]:
                arrow = "right" if RANK[target] > RANK[folder] else "sideways"
                yield f'{where}:{number}: "{name}" points {arrow}: {folder} -> {target}'


def check_headers(root):
    for path in sources(root, ["include", "src", "tool"], (".h",)):
        where = path.relative_to(root)
        public = where.parts[0] == "include"
        if "#pragma once" not in path.read_text(encoding="utf-8"):
            yield f"{where}:1: #pragma once is missing"
        for number, name, angle in included(path):
            if angle and name not in STANDARD:
                yield f"{where}:{number}: <{name}> is not of the standard library: .cpp files only"
            elif public and not angle and not name.startswith("knotfit/"):
                yield f'{where}:{number}: "{name}" in a public header'
    for path in sources(root, ["src"]):
        for number, name, angle in included(path):
            if angle and name.startswith("CLI/"):
                yield f"{path.relative_to(root)}:{number}: <{name}> belongs to tool/"


def documented_order(text):
    """The order in the code block of docs/architecture.md that holds '<' between folders."""
    for block in re.findall(r"```text\n(.*?)```", text, re.S):
        if "base <" in block:
            return [[f.strip() for f in group.split(",")] for group in " ".join(block.split()).split("<")]
    return None


def check_architecture(root):
    text = (root / DOCUMENT).read_text(encoding="utf-8")
    if documented_order(text) != ORDER:
        yield f"{DOCUMENT}:1: include order {documented_order(text)}, tests/structure/structure.py has {ORDER}"
    for header, folder in header_owners(root).items():
        if folder not in RANK:
            yield f"{DOCUMENT}:1: `{header}.h` belongs to src/{folder}/, which is not in the include order"
        if not (root / "include/knotfit" / f"{header}.h").is_file():
            yield f"{DOCUMENT}:1: `{header}.h` is not there"
    cmake = "src/CMakeLists.txt"
    match = re.search(r"foreach\(folder ([^)]*)\)", (root / cmake).read_text(encoding="utf-8"))
    listed = match[1].split() if match else []
    wanted = [f for group in ORDER for f in group if f not in ("tool", "python")]
    if listed != wanted:
        yield f"{cmake}:1: folders {listed}, not in the include order {wanted}"
    for folder in sorted(p.name for p in (root / "src").iterdir() if p.is_dir()):
        if folder not in wanted:
            yield f"src/{folder}: not in the include order"


def check_length(root):
    folders = ["src", "tool", "python", "include", "tests", "bench", "examples", "fuzz", "scripts"]
    for path in sources(root, folders, (".h", ".cpp", ".py", ".cmake")):
        lines = len(path.read_text(encoding="utf-8").splitlines())
        if lines > MAX_LINES:
            yield f"{path.relative_to(root)}:{lines}: longer than {MAX_LINES} lines: two jobs in one file?"


# Commands of other programs, which messages tell a user to run.
OTHERS = ("libreoffice --headless --convert-to csv",)
SAID = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\'', re.S)
FLAG = re.compile(r"(?<![\w-])--[a-z][\w-]*|\bknotfit (?:[\w.-]+ )+-[a-z]\b")


def check_flags(root):
    for path in sources(root, ["src", "include"]):
        text = path.read_text(encoding="utf-8")
        for said in SAID.finditer(text):
            words = said[0]
            for command in OTHERS:
                words = words.replace(command, " " * len(command))
            for flag in FLAG.finditer(words):
                line = text.count("\n", 0, said.start() + flag.start()) + 1
                yield f"{path.relative_to(root)}:{line}: {flag[0]} is an option of the tool: say it by knotfit/remedy.h"


LINK = re.compile(r"\]\(([^)\s]+)\)")
README = "README.md"


def anchors(page):
    """What `#...` may follow a page's name: its headings, small, without marks, with - for spaces."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


def links(page):
    """(line number, target) of every link that stays in the project, code left out."""
    code = re.sub(r"```.*?```|`[^`\n]*`", lambda m: re.sub(r"[^\n]", " ", m[0]), page.read_text(encoding="utf-8"),
                  flags=re.S)
    for match in LINK.finditer(code):
        if not re.match(r"[a-z]+:", match[1]):
            yield code.count("\n", 0, match.start()) + 1, match[1]


def check_pages(root):
    pages = sorted((root / "docs").rglob("*.md"))
    linked = {}
    for page in [*sorted(root.glob("*.md")), *pages]:
        where = page.relative_to(root)
        for line, link in links(page):
            name, _, anchor = link.partition("#")
            target = (page.parent / name).resolve() if name else page.resolve()
            if not target.exists():
                yield f"{where}:{line}: {link} leads nowhere"
                continue
            if anchor and target.suffix == ".md" and anchor not in anchors(target):
                yield f"{where}:{line}: {link}: there is no such heading"
            linked.setdefault(page.resolve(), set()).add(target)
    reached, ahead = set(), [(root / README).resolve()]
    while ahead:
        page = ahead.pop()
        if page not in reached:
            reached.add(page)
            ahead += linked.get(page, ())
    for page in pages:
        if page.resolve() not in reached:
            yield f"{page.relative_to(root)}:1: no link leads from {README} to this page"


MIRRORS = "tests/mirrors.txt"


def mirror(name):
    """Where the test of src/<name>.cpp stands. The CAD formats, which a build may lack, have a folder of their own."""
    return f"tests/{name.replace('formats/cad/', 'cad/', 1)}_test.cpp"


def check_mirrors(root):
    table = root / MIRRORS
    rows = []
    lines = table.read_text(encoding="utf-8").splitlines() if table.is_file() else []
    for number, line in enumerate(lines, 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        where = f"{MIRRORS}:{number}"
        if len(words) != 2:
            yield f"{where}: a row has a file of src/ and a test of tests/, parted by blanks"
            continue
        name, test = words
        if rows and name <= rows[-1]:
            yield f"{where}: {name} comes after {rows[-1]}: sort the rows, each file once"
        rows.append(name)
        if not (root / "src" / f"{name}.cpp").is_file():
            yield f"{where}: src/{name}.cpp is not there: take the row out"
        elif (root / mirror(name)).is_file():
            yield f"{where}: {name} has {mirror(name)}: take the row out"
        if not test.endswith(("_test.cpp", "_test.py")) or not (root / "tests" / test).is_file():
            yield f"{where}: tests/{test} is no test that is there: name the one that exercises {name}"
    for path in sources(root, ["src"], (".cpp",)):
        name = path.relative_to(root / "src").with_suffix("").as_posix()
        if name not in rows and not (root / mirror(name)).is_file():
            yield f"src/{name}.cpp:1: write {mirror(name)}, or name the test that exercises it in {MIRRORS}"


CHECKS = {
    "includes": check_includes,
    "headers": check_headers,
    "architecture": check_architecture,
    "length": check_length,
    "flags": check_flags,
    "pages": check_pages,
    "mirrors": check_mirrors,
}


def main(arguments):
    if len(arguments) != 2 or arguments[1] not in CHECKS:
        print(__doc__)
        return 2
    breaches = list(CHECKS[arguments[1]](Path(arguments[0])))
    print("\n".join(breaches) if breaches else "nothing wrong")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
