"""A placement method in Python: knots=callable."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _core, _options, _sources
from ._errors import translated
from ._run import ProgressLike

_GROWTH = 1.3


def _degrees(given: Mapping[str, Any]) -> tuple[int, int]:
    degree = given.get("degree", 3)
    if isinstance(degree, str):
        raise ValueError("degree: a number goes with knots=callable, not 'auto'")
    p, q = np.broadcast_to(np.asarray(degree), 2)
    return int(p), int(q)


def _tolerance_given(given: Mapping[str, Any], options: Any) -> bool:
    return "tol" in given or (isinstance(options, Mapping) and options.get("tolerance") is not None)


def fit_with(source: _sources.Input, given: Mapping[str, Any], *, options: Any, threads: int, progress: ProgressLike,
             on_miss: str, function: str, grid: _sources.Grid | None) -> Any:
    """One fit with a fixed size; else sizes grown until the tolerance holds, then halved between.

    Both directions get the same number of control points. A step from one size to the next is 1.3 fold.
    """
    from .fit import run, settle

    place = given["knots"]
    mapping = {k: v for k, v in given.items()
               if k in ("height_field", "rescale_parameters", "duplicates", "base", "fill_holes", "tol")}
    with translated():
        mapped, raised = _core.parameterize(source.make(), _options.texts("fit", mapping), 0, None)
    if raised is not None:
        raise raised
    uv, values = mapped.points()
    p, q = _degrees(given)
    rest = {k: v for k, v in given.items() if k not in ("knots", "control_points", "max_control_points")}

    def attempt(size: tuple[int, int], final: bool = False) -> Any:
        u, v = place(uv, values, size[0] - p - 1, size[1] - q - 1)
        # Steps of the search need no numbers between the points.
        extra = {} if final or given.get("between") is False else {"between": False}
        return run(source, {**rest, **extra, "knots": (u, v)}, options=options, threads=threads, progress=progress,
                   on_miss="ignore", function=function, grid=grid)

    if "control_points" in given:
        a, b = np.broadcast_to(np.asarray(given["control_points"]), 2)
        best = attempt((int(a), int(b)), True)
        settle(best, on_miss, 5)
        return best
    if not _tolerance_given(given, options):
        rest["tol"] = "0.1%"
    least, n = max(p, q) + 1, len(uv)
    most = max(least, int(np.sqrt(given.get("max_control_points") or n / 2)))
    below, size = least - 1, least + 2
    best, best_size = None, 0
    while True:
        size = min(size, most)
        found = attempt((size, size))
        if best is None or found.measured < best.measured or found.reached:
            best, best_size = found, size
        if found.reached or size == most:
            break
        below, size = size, max(size + 1, int(np.ceil(size * _GROWTH)))
    above = best_size
    while best.reached and above - below > 1:
        middle = (above + below) // 2
        found = attempt((middle, middle))
        if found.reached:
            above, best, best_size = middle, found, middle
        else:
            below = middle
    best = attempt((best_size, best_size), True)
    settle(best, on_miss, 5)
    return best
