"""Every placement method on the same data."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from typing import Any

import numpy as np

from . import _arrays, _core, _options, _sources
from ._errors import in_python_words, translated, with_best
from ._run import ProgressLike, thread_count, watched
from .fit import NanPolicy
from .surface import Surface, draw_size


class Comparison(list[dict[str, Any]]):
    """Rows, a dict each, in the order they were run; pandas.DataFrame(comparison) is its table.

    A row has method, asked, size, control_points, rms, max, between, bound, thin, status, reached, knots, notes, fits,
    seconds; one of a method that failed has `failure` in place of the figures.
    """

    def __init__(self, rows: _core.Rows) -> None:
        self._rows = rows
        table = json.loads(rows.json())["rows"]
        for row in table:
            row.pop("surface", None)
            if "failure" in row:
                row["failure"] = in_python_words(row["failure"])
            row["notes"] = [in_python_words(note) for note in row.get("notes", [])]
        super().__init__(table)

    def surface(self, row: int) -> Surface:
        """The surface of a row. ValueError: the method failed."""
        if "failure" in self[row]:
            raise ValueError(f"row {row}: {self[row]['failure']}")
        return Surface._of(self._rows.document(row % len(self)))

    def to_dataframe(self) -> Any:
        """pandas' DataFrame. ImportError: no pandas."""
        import pandas

        return pandas.DataFrame(list(self))

    def draw(self, format: str = "png", *, asked: str | None = None, width: float | None = None,
             height: float | None = None) -> bytes:
        """The picture: RMS errors against control points.

        format         "png", "svg" or "pdf"
        asked          "12x12" or "1%": in its place the knots of every method over its errors, at this size or tolerance
        width, height  pixels (png), points (svg, pdf): a column of a paper is about 252 wide
        """
        size = draw_size(width, height)
        with translated():
            if asked is None:
                return self._rows.draw_errors("." + format.lstrip("."), *size)
            return self._rows.draw_maps(asked, "." + format.lstrip("."), *size)

    def save(self, folder: str | os.PathLike[str], *, force: bool = False) -> None:
        """Tables (CSV, JSON), every surface, and pictures (SVG, PNG) as files of a folder."""
        with translated():
            self._rows.save(os.fspath(folder), force)

    def _repr_html_(self) -> str:
        from ._notebook import comparison_html

        return comparison_html(self)


def _size(size: Any) -> str:
    a, b = np.broadcast_to(np.asarray(size), 2)
    return f"{int(a)}x{int(b)}"


def compare(xyz: Any, uv: Any = None, *, methods: str | Iterable[str] = "all", sizes: Any = (), tolerances: Any = (),
            within: float | str | None = None, rms: bool = False, degree: int | tuple[int, int] = 3,
            max_control_points: int | None = None, max_fits: int | None = None, feature: Any = "hessian",
            evaluations: int = 2000, smoothing: float = 1e-9, between: bool = True, weights: Any = None,
            normals: Any = None, height_field: bool = False, rescale_parameters: bool = False,
            duplicates: str = "fail", base: str = "auto", nan_policy: NanPolicy = "raise", threads: int = 0,
            progress: ProgressLike = None) -> Comparison:
    """Fits the same data with knots of every method, each checked like any fit.

    xyz, uv     as fit() takes them
    methods     names of knotfit.methods(), "criterion:curvature" for a feature measure; "all"
    sizes       of control points: (12, 20) or [(8, 8), (12, 12)]; a number stands for both directions
    tolerances  sizes are searched to each, as fit()'s tol
    ValueError  neither a size nor a tolerance; an unknown method

    KeyboardInterrupt has the rows that ended as its attribute `best`.
    """
    usual = compare.__kwdefaults__ or {}
    own = {"methods", "sizes", "tolerances", "weights", "normals", "nan_policy", "threads", "progress"}
    given = _options.changed(usual, {k: v for k, v in locals().items() if k in usual and k not in own})
    measure = None
    if not isinstance(feature, str):
        measure = _arrays.contiguous(feature, dtype=np.float64)
        given.pop("feature")
    texts = _options.texts("compare", given)
    if methods != "all":
        texts.append(("methods", methods if isinstance(methods, str) else ",".join(methods)))
    sizes = [sizes] if isinstance(sizes, (int, np.integer)) else list(sizes)
    if len(sizes) == 2 and all(isinstance(s, (int, np.integer)) for s in sizes):
        sizes = [tuple(sizes)]
    if sizes:
        texts.append(("sizes", ",".join(_size(s) for s in sizes)))
    tolerances = [tolerances] if isinstance(tolerances, (str, float, int)) else list(tolerances)
    if tolerances:
        texts.append(("tolerances", ",".join(t if isinstance(t, str) else repr(float(t)) for t in tolerances)))
    if _sources.is_path(xyz):
        source = _sources.file(xyz)
    elif hasattr(xyz, "dims") and hasattr(xyz, "coords"):
        found = _sources.raster(xyz, None, None, None, "omit").input
        assert found is not None
        source = found
    else:
        moved = height_field or rescale_parameters or base != "auto"
        source = _sources.points(xyz, uv, weights, normals, nan_policy, moved)
    with translated(), watched(progress) as tell:
        rows, raised = _core.compare(source.make(), texts, measure, thread_count(threads), tell)
    made = Comparison(rows)
    if raised is not None:
        raise with_best(raised, made)
    return made
