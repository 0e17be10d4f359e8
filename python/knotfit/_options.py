"""Keywords as the texts of the tool's options, from whose rows names, defaults and words come."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from . import _core

Texts = list[tuple[str, str]]

# Written N x M where two numbers are given.
_PAIRS = {"control_points", "degree", "cell", "grid"}
_LISTS = {"columns", "classes", "returns"}


@functools.cache
def rows(command: str) -> dict[str, dict[str, Any]]:
    """Keyword -> row of a command's option."""
    return {row["keyword"]: row for row in _core.options(command) if not row["keyword"].startswith("no_")}


def _number(name: str, value: Any) -> str:
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name}: takes a number, not {value}")
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    raise TypeError(f"{name}: takes a number or a text, not {type(value).__name__}")


def _list(name: str, value: Any) -> list[str]:
    return [item if isinstance(item, str) else _number(name, item) for item in value]


def _shear(value: Any) -> str:
    if isinstance(value, (tuple, list)) and len(value) == 2 and value[0] in ("u", "v"):
        return f"{value[0]}:{_number('shear', value[1])}"
    return value if isinstance(value, str) else _number("shear", value)


def _corners(value: Any) -> str:
    array = np.asarray(value)
    if array.shape == (4, 3):
        return ";".join(",".join(repr(float(x)) for x in place) for place in array)
    return ",".join(_list("corners", array.tolist()))


def text_of(name: str, value: Any, row: Mapping[str, Any]) -> str | None:
    """The value as a command line gives it; None: a switch that is off."""
    if isinstance(value, (bool, np.bool_)):
        if row["value"] == "":
            return "on" if value else None
        if name == "correct" and not value:
            return "off"
        if "on|off" in row["value"]:
            return "on" if value else "off"
        raise TypeError(f"{name}: takes {row['value']}, not {value}")
    if row["value"] == "":
        raise TypeError(f"{name}: takes True or False, not {type(value).__name__}")
    if isinstance(value, str):
        return value
    if name == "within" and isinstance(value, (float, int)) and not isinstance(value, bool):
        if not 0 < value <= 1:
            raise ValueError(f"within: {value} is no share of the points in (0, 1]; a text such as '99.5%' is taken too")
        return f"{100 * value!r}%"
    if name == "shear":
        return _shear(value)
    if name == "corners":
        return _corners(value)
    if name == "nodata" and isinstance(value, float) and math.isnan(value):
        return "nan"
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, Sequence) and name in _PAIRS | _LISTS:
        if name in _PAIRS and len(value) != 2:
            raise ValueError(f"{name}: takes one number or two, not {len(value)}")
        return ("x" if name in _PAIRS else ",").join(_list(name, value))
    return _number(name, value)


def knot_list(name: str, value: Any) -> str:
    array = np.asarray(value, dtype=np.float64)
    if array.ndim != 1:
        raise ValueError(f"{name}: has shape {array.shape}; interior knots are a list of numbers")
    return ",".join(repr(float(x)) for x in array) if array.size else "none"


def texts(command: str, given: Mapping[str, Any]) -> Texts:
    """Of every keyword that has a value."""
    table = rows(command)
    found: Texts = []
    for name, value in given.items():
        if value is None:
            continue
        text = text_of(name, value, table[name])
        if text is not None:
            found.append((name, text))
    return found


def changed(usual: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """The keywords whose value is not the default."""

    def same(a: Any, b: Any) -> bool:
        return a is b or (type(a) is type(b) and isinstance(a, (bool, int, float, str)) and bool(a == b))

    return {name: value for name, value in given.items() if not same(value, usual.get(name))}


def call_text(function: str, given: Mapping[str, Any]) -> str:
    """The call under a picture: `knotfit.fit(tol='1%', rms=True)`."""

    def short(value: Any) -> str:
        text = repr(value)
        return text if len(text) <= 40 and "\n" not in text else "..."

    return f"knotfit.{function}(" + ", ".join(f"{n}={short(v)}" for n, v in given.items()) + ")"
