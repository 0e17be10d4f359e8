"""Meshes: fits, and parameters alone."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

from . import _core, _options, _sources
from ._arrays import Floats
from ._errors import translated
from ._run import ProgressLike, thread_count, watched
from .fit import USUAL, Fit, NanPolicy, OnMiss, run

_MAPPING = {"base", "corners", "omega", "fill_holes", "largest_part", "orient", "drop_degenerate", "weld"}


def _checked(function: str, keywords: dict[str, Any], known: Any) -> dict[str, Any]:
    for name in keywords:
        if name not in known:
            raise TypeError(f"{function}() got an unexpected keyword argument {name!r}")
    return _options.changed(USUAL, keywords)


def fit_mesh(vertices: Any, faces: Any = None, uv: Any = None, *, options: Any = None, on_miss: OnMiss = "warn",
             threads: int = 0, progress: ProgressLike = None, **keywords: Any) -> Fit:
    """Fits a surface to a triangle mesh that is a disk: mapped over the square, corrected, measured both ways.

    vertices  (n, 3), or an object with .vertices and .faces, .points and .cells, or .points and .faces
    faces     (m, 3) corners counted from 0, counter-clockwise from outside; (m, 4) become two triangles each
    uv        (n, 2) parameters of the vertices, used where they are one-to-one
    keywords  as fit() has them

    Fit.errors are the distances of the vertices to the surface, NaN for those that are no data.
    """
    source = _sources.mesh(vertices, faces, uv)
    return run(source, _checked("fit_mesh", keywords, USUAL), options=options, threads=threads, progress=progress,
               on_miss=on_miss, function="fit_mesh")


class Parameterization(NamedTuple):
    """Parameters in the unit square.

    uv      (n, 2) in [0, 1], a vertex or point each; NaN where it was left out
    report  dict: stretch, worst angle, flipped triangles, holes
    """

    uv: Floats
    report: dict[str, Any]


def parameterize(points: Any, faces: Any = None, *, nan_policy: NanPolicy = "raise", threads: int = 0,
                 progress: ProgressLike = None, **keywords: Any) -> Parameterization:
    """Parameters of a mesh, or of points over a base.

    points    (n, 3) vertices or points, or a mesh as fit_mesh() takes it
    faces     (m, 3); none: the points are laid over `base`
    keywords  base, corners, omega, fill_holes, largest_part, orient, drop_degenerate, weld, as fit() has them
    """
    given = _checked("parameterize", keywords, _MAPPING)
    is_mesh = faces is not None or not hasattr(points, "__array__") and hasattr(points, "faces")
    if is_mesh or hasattr(points, "cells"):
        source = _sources.mesh(points, faces, None)
        given["new_parameters"] = True
    else:
        source = _sources.points(points, None, None, None, nan_policy, True)
    with translated(), watched(progress) as tell:
        mapped, raised = _core.parameterize(source.make(), _options.texts("fit", given), thread_count(threads), tell)
    if raised is not None:
        raise raised
    report = json.loads(mapped.json())
    cloud = json.loads(mapped.cloud_json())
    return Parameterization(mapped.parameters, {**cloud, **report} if cloud else report)
