"""Knots placed without a search."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _arrays, _core, _options, _sources
from ._arrays import Floats
from ._errors import translated
from ._run import thread_count
from .fit import USUAL, NanPolicy


class Knots(NamedTuple):
    """Interior knots of both directions in (0, 1), and what should be known of them."""

    u: Floats
    v: Floats
    notes: list[str]


def methods() -> list[dict[str, str]]:
    """Every placement method: name, summary, source."""
    return _core.methods()


def place_knots(xyz: Any, uv: Any = None, *, control_points: int | tuple[int, int] = 12, method: str = "error-model",
                degree: int | tuple[int, int] = 3, feature: Any = "hessian", engine: str = "auto",
                evaluations: int = 2000, smoothing: float = 1e-9, weights: Any = None, height_field: bool = False,
                rescale_parameters: bool = False, nan_policy: NanPolicy = "raise", threads: int = 0) -> Knots:
    """Interior knots for a fit of a given size, such as SciPy's LSQBivariateSpline wants them.

    xyz, uv         as fit() takes them
    control_points  (along u, along v): interior knots are these less degree + 1
    method          a name of knotfit.methods()
    ValueError      fewer control points than degree + 1; an unknown method
    """
    given = _options.changed(USUAL, {k: v for k, v in locals().items() if k in USUAL and k != "control_points"})
    sizes = np.broadcast_to(np.asarray(control_points), 2)
    degrees = np.broadcast_to(np.asarray(degree), 2)
    interior = [int(s) - int(d) - 1 for s, d in zip(sizes, degrees)]
    if min(interior) < 0:
        raise ValueError(f"control_points: {control_points} is fewer than degree + 1 along a direction")
    measure = None
    if not isinstance(feature, str):
        measure = _arrays.contiguous(feature, dtype=np.float64)
        given.pop("feature")
    if _sources.is_path(xyz):
        source = _sources.file(xyz)
    else:
        source = _sources.points(xyz, uv, weights, None, nan_policy, height_field or rescale_parameters)
    with translated():
        u, v, notes, raised = _core.place_knots(source.make(), method, _options.texts("fit", given), measure,
                                                interior[0], interior[1], thread_count(threads))
    if raised is not None:
        raise raised
    return Knots(u, v, notes)
