"""What is raised, and how the library's texts are said in Python's terms."""

from __future__ import annotations

import atexit
import contextlib
import json
import re
from collections.abc import Callable, Iterator
from typing import Any

from . import _core


class KnotfitWarning(UserWarning):
    """A fit that ended below what was asked. Its `fit` says how far."""

    fit: object

    def __init__(self, message: str, fit: object = None) -> None:
        super().__init__(message)
        self.fit = fit


class ToleranceMissed(RuntimeError):
    """As KnotfitWarning, raised where on_miss="raise" was asked for. `fit` is the best that was found."""

    fit: object

    def __init__(self, message: str, fit: object = None) -> None:
        super().__init__(message)
        self.fit = fit

    def __reduce__(self) -> tuple[type, tuple[str, object]]:
        return type(self), (str(self), self.fit)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a fit. `best` is what it had found, or None; where that is not ready yet, it is waited for."""

    def __init__(self, *arguments: object, best: object = None, later: Callable[[], object] | None = None) -> None:
        super().__init__(*arguments)
        self._best = best
        self._later = later
        if later is not None:
            _unfinished.add(self)

    @property
    def best(self) -> object:
        if self._later is not None:
            self._best, self._later = self._later(), None
            _unfinished.discard(self)
        return self._best


def with_best(raised: BaseException, best: object) -> BaseException:
    """The exception with what was found as its attribute `best`."""
    if isinstance(raised, KeyboardInterrupt):
        return Interrupted(*raised.args, best=best)
    raised.best = best  # type: ignore[attr-defined]
    return raised


# Work that was stopped and has not ended: the interpreter does not end before it.
_unfinished: set[Interrupted] = set()


@atexit.register
def _wait_for_the_last() -> None:
    for interrupted in list(_unfinished):
        with contextlib.suppress(Exception, KeyboardInterrupt):
            interrupted.best  # noqa: B018


# A remedy of the library as a keyword of a call; those that are none say what to do.
_REMEDIES = {
    "format": "input_format", "columns": "columns", "nodata": "nodata", "skip_lines": "skip_lines",
    "block": "one block of the file", "classes": "classes", "returns": "returns",
    "height_field": "height_field=True", "rescale": "rescale_parameters=True", "duplicates": "duplicates",
    "base": "base", "fill_holes": "fill_holes=True", "largest_part": "largest_part=True", "orient": "orient=True",
    "drop_degenerate": "drop_degenerate=True", "vertices": "knotfit.fit(vertices)", "degree": "degree",
    "smoothing": "smoothing", "correct": "correct", "corrections": "corrected=True", "closed": "closed=True",
    "force": "force=True",
}

_SWITCHES = {"height_field", "rescale_parameters", "fill_holes", "largest_part", "orient", "drop_degenerate",
             "new_parameters", "rms", "cad_safe", "reflections", "force", "closed", "function", "corrected"}
_RENAMED = {"clamp": 'outside="clamp"', "points": "points"}
_FLAG = re.compile(r"(?<![\w-])--([a-z][a-z-]*)(?: (?=[A-Za-z0-9])(off|on|auto|search|insert)\b)?")
# "line 4", "lines 4, 7 and 9 and 3 more", "point 4 (from 1)": rows from 1, as a file counts.
_ROWS = re.compile(r"(?<!the )\b(line|lines|point|points) (\d+(?:(?:, | and )\d+(?! more))*)(?!\.?\d)(?: \(from 1\))?")
_POINT_AND_LINE = re.compile(r"\bpoint \d+ \(line (\d+)\)")


def _keyword(match: re.Match[str]) -> str:
    name = match[1].replace("-", "_")
    if match[2]:
        return f'{name}="{match[2]}"'
    if name in _RENAMED:
        return _RENAMED[name]
    return f"{name}=True" if name in _SWITCHES else name


def _row(match: re.Match[str]) -> str:
    numbers = re.sub(r"\d+", lambda m: str(int(m[0]) - 1), match[2])
    return ("rows " if match[1].endswith("s") else "row ") + numbers


def read_report(text: str) -> dict[str, Any]:
    """A report of the library, its message and notes in Python's terms."""
    report: dict[str, Any] = json.loads(text)
    report["message"] = in_python_words(report["message"])
    report["notes"] = [in_python_words(note) for note in report["notes"]]
    return report


def in_python_words(text: str, rows: bool = True) -> str:
    """The library's and the tool's text with keywords for options and rows, counted from 0, for lines."""
    for said, name, value in _core.remedies(text):
        words = _REMEDIES.get(name, name)
        if value:
            words = f'{words.split("=")[0]}="{value}"'
        text = text.replace(said, words)
    text = _FLAG.sub(_keyword, text)
    if rows:
        text = _POINT_AND_LINE.sub(lambda m: f"row {int(m[1]) - 1}", text)
        text = _ROWS.sub(_row, text)
    return re.sub(r"^arrays: ", "", text)


@contextlib.contextmanager
def translated(rows: bool = True) -> Iterator[None]:
    """What the library throws, in Python's words: ValueError, FileError (a ValueError), WriteError (an OSError)."""
    try:
        yield
    except _core.InvalidInput as e:
        raise ValueError(in_python_words(str(e), rows)) from None
    except _core.FileError as e:
        raise _core.FileError(in_python_words(str(e), rows=False)) from None
