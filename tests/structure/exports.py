#!/usr/bin/env python3
"""Holds what a shared library exports to the public headers: exports.py LIBRARY ROOT.

Every symbol that the library defines for others belongs to a function or class that include/knotfit/*.h declares with a body
or a semicolon of its own; nothing of the standard library or of the libraries that knotfit is made with is among them. Prints
every breach and exits with 1 if there is one."""

import re
import subprocess
import sys
from pathlib import Path

PREFIX = re.compile(r"^(?:typeinfo (?:name )?for |vtable for |guard variable for )?(.*)$")
CLASS = re.compile(r"\b(?:class|struct|enum class|enum)\s+(\w+)[^;{}()]*\{")
FUNCTION = re.compile(r"\b(\w+)\s*\(")


def declared(root):
    names = set()
    for header in sorted((root / "include" / "knotfit").glob("*.h")):
        text = re.sub(r"//[^\n]*", "", header.read_text(encoding="utf-8"))
        names.update(CLASS.findall(text))
        names.update(FUNCTION.findall(text))
    return names


def exported(library):
    """Demangled names of the symbols that the library defines for others."""
    done = subprocess.run(["nm", "-D", "-C", "--defined-only", str(library)], check=True, capture_output=True, text=True)
    return [line.split(None, 2)[2] for line in done.stdout.splitlines() if len(line.split(None, 2)) == 3]


def breaches(symbols, names):
    for symbol in symbols:
        subject = PREFIX.match(symbol)[1]
        match = re.match(r"knotfit::(\w+)", subject)
        if not match:
            yield f"{symbol}: is not knotfit's"
        elif match[1] not in names:
            yield f"{symbol}: no public header declares {match[1]}"
    if not any(symbol.startswith("knotfit::fit_surface(") for symbol in symbols):
        yield "fit_surface() is not exported"


def main():
    library, root = Path(sys.argv[1]), Path(sys.argv[2])
    symbols = exported(library)
    found = list(breaches(symbols, declared(root)))
    print("\n".join(found) if found else f"{len(symbols)} symbols, all of public headers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
