"""The files that the matrix runs on, and how each is called."""

import os
from dataclasses import dataclass

import made

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CALLS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "calls.txt")
# Endings that are no data of this version, and the word for it.
SKIPPED = {".tif": "GeoTIFF is not read by this version", ".md": "no data", "": "no data"}


@dataclass(frozen=True)
class Input:
    name: str
    path: str
    command: str  # fit or fit-curve
    arguments: tuple  # beside those a row varies
    sound: bool = True  # known to be: a refusal is a failure

    @property
    def curve(self):
        return self.command == "fit-curve"


def read_calls(path):
    """Name -> (command, arguments)."""
    calls = {}
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            words = line.partition("#")[0].split()
            if not words:
                continue
            if len(words) < 2 or words[1] not in ("fit", "fit-curve"):
                raise SystemExit(f"{path}:{number}: NAME fit|fit-curve [ARGUMENTS] is expected")
            calls[words[0]] = (words[1], tuple(words[2:]))
    return calls


def guessed_call(path):
    """Of a file that no list names."""
    if path.lower().endswith(".las"):
        return "fit", ("--height-field",)
    with open(path, encoding="utf-8", errors="replace") as file:
        names = [n.strip().lower() for n in file.readline(1000).replace(";", ",").split(",")]
    return ("fit-curve" if names == ["x", "y"] else "fit"), ()


def in_folder(folder, calls):
    """(inputs, [(name, why it is skipped)]); bad_* are not sound."""
    found, skipped = [], []
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        ending = os.path.splitext(name)[1].lower()
        if not os.path.isfile(path) or name.startswith(("bad_", "LICENSE")) or ending in (".md", ""):
            continue
        if ending in SKIPPED:
            skipped.append((name, SKIPPED[ending]))
            continue
        command, arguments = calls.get(name) or guessed_call(path)
        found.append(Input(name, path, command, tuple(arguments), name in calls))
    return found, skipped


def of_made(folder, which):
    paths = made.write(folder, which)
    return [Input("made:" + name, paths[name], command, tuple(arguments))
            for name, (_, command, arguments) in which.items()]


def collect(made_folder, data, more_calls=""):
    """Samples, the folder KNOTFIT_DATA and the made inputs; equal names once. (inputs, skipped)."""
    calls = read_calls(CALLS)
    if more_calls:
        calls.update(read_calls(more_calls))
    found, skipped = in_folder(os.path.join(ROOT, "samples"), calls)
    if data:
        more, left = in_folder(data, calls)
        there = {i.name for i in found}
        found += [i for i in more if i.name not in there]
        skipped += left
    else:
        there = {i.name for i in found}
        skipped += [(name, "KNOTFIT_DATA is not set") for name in calls if name not in there]
    return found + of_made(made_folder, made.MADE), skipped
