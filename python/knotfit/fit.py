"""Fits of surfaces: the call, and what it gives."""

from __future__ import annotations

import contextlib
import copy
import json
import os
import tempfile
import warnings
from collections.abc import Callable, Mapping
from typing import Any, Literal, NamedTuple, Union

import numpy as np

from . import _arrays, _core, _options, _sources
from ._arrays import Floats
from ._errors import Interrupted, KnotfitWarning, ToleranceMissed, in_python_words, read_report, translated, with_best
from ._run import ProgressLike, thread_count, watched
from .surface import Surface, draw_size

Tolerance = Union[float, str, None]
OnMiss = Literal["warn", "raise", "ignore"]
NanPolicy = Literal["raise", "omit"]
Placement = Callable[[Floats, Floats, int, int], tuple[Any, Any]]


class ErrorSummary(NamedTuple):
    """How far a surface is from its points: |S - P|, in the data's unit."""

    rms: float
    max: float
    mean: float
    median: float
    p95: float
    p99: float
    p995: float


class ThinPlace(NamedTuple):
    """A place where the data is too thin to promise anything, in the data's parameters."""

    u: float
    v: float
    error_bar: float
    gap: float


class Fit:
    """A surface, and what is known of it.

    surface     Surface
    status      "reached", "fixed_size", "not_reached", ... (docs/python.md lists them)
    reached     whether the tolerance holds at the points and the surface keeps to them between
    message     the status in a sentence
    error       ErrorSummary: rms, max, mean, median, ...
    measured    float, the error that counts
    tolerance   float in the data's unit, or None
    between     float, the largest distance between the points where the data promises one; None: nowhere, not measured
    bound       float, the same with the error bar; None likewise
    thin        float, share of the domain where nothing is promised; None: not measured
    errors      (n,), a row of the input each, NaN where it was left out; (rows, columns) of a raster or a grid
    parameters  (n, 2) or (rows, columns, 2), in the data's own coordinates; NaN likewise
    thin_places list of ThinPlace
    notes       list of sentences
    options     dict, the options in force; fit(..., options=fit.options) repeats them
    report      dict, as the tool's --json
    """

    def __init__(self, outcome: _core.Outcome, shape: tuple[int, ...] = (), grid: _sources.Grid | None = None) -> None:
        self._outcome: _core.Outcome | None = outcome
        self._shape = shape
        self._grid = grid
        self.report: dict[str, Any] = read_report(outcome.report())
        report = self.report
        self.surface: Surface = Surface._of(outcome.document)
        self.status: str = report["status"]
        self.message: str = report["message"]
        self.reached: bool = report["reached"]
        e = report["error"]
        self.error = ErrorSummary(*(float("nan") if e[k] is None else e[k] for k in ErrorSummary._fields))
        self.measured: float = float("nan") if report["measured"] is None else report["measured"]
        self.tolerance: float | None = report["tolerance"]["value"] if report["tolerance"] else None
        self.between: float | None = report["between"]
        self.bound: float | None = report["bound"]
        self.thin: float | None = report["thin"]
        self.notes: list[str] = report["notes"]
        self.options: dict[str, Any] = report["options"]
        self.thin_places = [ThinPlace(*place) for place in outcome.thin_places]
        self.errors: Floats = self._shaped(outcome.errors)
        self.parameters: Floats = self._shaped(outcome.parameters)

    def _shaped(self, values: Floats) -> Floats:
        if len(self._shape) == 2:
            values = values.reshape(self._shape + values.shape[1:])
        if self._grid is not None:
            values = values[:: -1 if self._grid.flip_y else 1, :: -1 if self._grid.flip_x else 1]
        return np.ascontiguousarray(values)

    def raster(self, fill_holes: bool = False) -> Any:
        """Fitted heights (rows, columns) where the input had them; what was an xarray object comes back as one.

        fill_holes  heights where the input has none, too; else NaN stands there
        ValueError  the fit was not to a raster
        """
        if self._grid is None:
            raise ValueError("raster: the fit was not to a raster; fit.surface.grid(x, y) gives heights anywhere")
        heights = self.surface.grid(self._grid.x, self._grid.y, outside="clamp").T.copy()
        if not fill_holes:
            heights[np.isnan(self.errors)] = np.nan
        template = self._grid.template
        return heights if template is None else template.copy(data=heights)

    def save(self, path: str | os.PathLike[str], *, force: bool = False, cell: Any = None, fill_holes: bool = False,
             samples: int = 4, reflections: bool = False, unit: str = "mm", name: str | None = None,
             step_schema: str = "ap242", cad_safe: bool = False, cad_tol: Tolerance = None) -> None:
        """Writes a file, its kind by the extension, whole or not at all.

        .json the surface, .csv the error of each point, .asc .grd fitted heights, .png .svg .pdf a picture, .obj .ply
        .vts the surface in triangles or as a grid, .step .stp .igs .iges the surface for CAD.

        force        replace a file that exists
        cell, fill_holes                    of .asc .grd: size of a cell; heights where the input has none
        samples                             of .obj .ply .vts: samples a knot span
        reflections                         of pictures: reflection lines
        unit, name, step_schema, cad_safe, cad_tol   of CAD files
        ValueError   no such output; FileError, WriteError: it cannot be written
        """
        given = _options.changed(SAVE_USUAL, {
            "cell": cell, "fill_holes": fill_holes, "samples": samples, "reflections": reflections, "unit": unit,
            "name": name, "step_schema": step_schema, "cad_safe": cad_safe, "cad_tol": cad_tol})
        if self._outcome is None:
            return self.surface.save(path, force=force, **given)
        with translated():
            self._outcome.save(os.fspath(path), force, _options.texts("fit", given))

    def draw(self, format: str = "png", *, width: float | None = None, height: float | None = None,
             reflections: bool = False) -> bytes:
        """The picture: surface with errors, parameter plane beside it. width, height: pixels (png), points (svg, pdf)."""
        if self._outcome is None:
            return self.surface.draw(format, width=width, height=height, reflections=reflections)
        with translated():
            return self._outcome.draw("." + format.lstrip("."), *draw_size(width, height), reflections)

    def plot(self, ax: Any = None, *, width: int = 1600, height: int = 900) -> Any:
        """The picture on matplotlib's axes, made where none are given. Returns them. ImportError: no matplotlib."""
        from .surface import show_picture

        return show_picture(self.draw("png", width=width, height=height), ax)

    def summary(self) -> str:
        """As the tool prints it."""
        if self._outcome is None:
            return self.message
        return in_python_words(self._outcome.text())

    def _repr_png_(self) -> bytes:
        return self.draw("png", width=1200, height=675)

    def _repr_html_(self) -> str:
        from ._notebook import fit_html

        return fit_html(self)

    def __repr__(self) -> str:
        u, v = self.surface.size
        return f"<knotfit.Fit {self.status}: {u} x {v} control points, rms {self.error.rms:.3g}, max {self.error.max:.3g}>"

    def __getstate__(self) -> dict[str, Any]:
        state = dict(self.__dict__)
        state["_outcome"] = None  # what pictures and residuals are made of stays behind
        if self._grid is not None:
            state["_grid"] = self._grid._replace(input=None)
        return state

    def __copy__(self) -> Fit:
        other = object.__new__(Fit)
        other.__dict__.update(self.__dict__)
        return other

    def __deepcopy__(self, memo: dict[int, Any]) -> Fit:
        other = self.__copy__()
        for name in ("report", "notes", "options", "errors", "parameters", "surface"):
            setattr(other, name, copy.deepcopy(getattr(self, name), memo))
        return other


SAVE_USUAL = {"cell": None, "fill_holes": False, "samples": 4, "reflections": False, "unit": "mm", "name": None,
              "step_schema": "ap242", "cad_safe": False, "cad_tol": None}

# Keywords of fit() that are no options of the tool.
OWN = {"xyz", "uv", "weights", "normals", "nan_policy", "on_miss", "threads", "progress", "options"}


def missed(fit: Any) -> bool:
    """Below what was asked, as the tool's exit status 3 says it."""
    if fit.status in ("fixed_size", "stopped"):
        return False
    return fit.status in ("time_limit", "failed") or not fit.reached


def settle(fit: Any, on_miss: str, stacklevel: int) -> None:
    """A warning or an exception where the fit is below what was asked."""
    if on_miss == "ignore" or not missed(fit):
        return
    text = f"{fit.status}: {fit.message}"
    if on_miss == "raise":
        raise ToleranceMissed(text, fit)
    warnings.warn(KnotfitWarning(text, fit), stacklevel=stacklevel)


def check_on_miss(on_miss: str) -> None:
    if on_miss not in ("warn", "raise", "ignore"):
        raise ValueError(f"on_miss: {on_miss!r} is none of 'warn', 'raise', 'ignore'")


def _spread(given: dict[str, Any], folder: Callable[[], str]) -> dict[str, Any]:
    """Keywords whose values no command line has: knots in arrays, a surface, a measure in an array."""
    spread = dict(given)
    knots = spread.get("knots")
    if isinstance(knots, Surface):
        spread["knots"] = None
        spread["knots_u"], spread["knots_v"] = (_options.knot_list("knots", k) for k in knots._interior)
        spread.setdefault("degree", knots.degree)
    elif knots is not None and not isinstance(knots, str):
        if not isinstance(knots, (tuple, list)) or len(knots) != 2:
            raise TypeError("knots: takes a method's name, two lists of interior knots, a Surface or a callable")
        spread["knots"] = None
        spread["knots_u"], spread["knots_v"] = (_options.knot_list("knots", k) for k in knots)
    base = spread.get("base")
    if isinstance(base, Surface):
        spread["base"] = os.path.join(folder(), "base.json")
        base.save(spread["base"])
    elif base is not None and not isinstance(base, str):
        spread["base"] = os.fspath(base) if hasattr(base, "__fspath__") else ",".join(os.fspath(b) for b in base)
    return spread


def run(source: _sources.Input, given: Mapping[str, Any], *, options: Any, threads: int, progress: ProgressLike,
        on_miss: str, function: str, grid: _sources.Grid | None = None) -> Fit:
    """The fit of a source by the keywords that are not the defaults."""
    check_on_miss(on_miss)
    count = thread_count(threads)
    if callable(given.get("knots")) and not isinstance(given["knots"], Surface):
        from ._own_placement import fit_with

        found: Fit = fit_with(source, given, options=options, threads=threads, progress=progress, on_miss=on_miss,
                              function=function, grid=grid)
        return found
    call = _options.call_text(function, given)
    with contextlib.ExitStack() as stack:
        def folder() -> str:
            return stack.enter_context(tempfile.TemporaryDirectory(prefix="knotfit"))

        spread = _spread(dict(given), folder)
        feature = spread.get("feature")
        if feature is not None and not isinstance(feature, str):
            feature = _arrays.contiguous(feature, dtype=np.float64)
            if feature.ndim != 2:
                raise ValueError(f"feature: has shape {feature.shape}, not (cells along u, cells along v)")
            spread["feature"] = None
        else:
            feature = None
        stored = ""
        if isinstance(options, Mapping):
            stored = os.path.join(folder(), "options.json")
            with open(stored, "w", encoding="utf-8") as file:
                json.dump({"options": options}, file)
        elif options is not None:
            stored = os.fspath(options)
        texts = _options.texts("fit", spread)
        with translated(), watched(progress) as tell:
            outcome, raised, later = _core.fit(source.make(), texts, stored, feature, count, tell, call)

    def made(found: _core.Outcome | None) -> Fit | None:
        return None if found is None else Fit(found, source.shape, grid)

    if raised is not None and later is not None and isinstance(raised, KeyboardInterrupt):
        waits = later
        raise Interrupted(*raised.args, later=lambda: made(waits())) from None
    if raised is not None:
        raise with_best(raised, made(outcome if later is None else later()))
    fit = made(outcome)
    if fit is None:
        raise RuntimeError("the fit was stopped before there was a surface")
    if isinstance(given.get("base"), Surface):
        fit.options["base"] = "surface"
    settle(fit, on_miss, 4)  # this, the public call, its caller
    return fit


def fit(xyz: Any, uv: Any = None, *, tol: Tolerance = None, within: float | str | None = None, rms: bool = False,
        control_points: int | tuple[int, int] | None = None, knots: Any = "optimal",
        degree: int | tuple[int, int] | str = 3, shear: Any = "off", refine: str = "search", effort: str = "balanced",
        guard: bool = True, engine: str = "auto", max_control_points: int | None = None, max_fits: int | None = None,
        time_limit: float | None = None, feature: Any = "hessian", evaluations: int = 2000, smoothing: float = 1e-9,
        between: bool = True, weights: Any = None, normals: Any = None, height_field: bool = False,
        spacing: str = "chord", rescale_parameters: bool = False, duplicates: str = "fail", base: Any = "auto",
        corners: Any = "auto", omega: float | None = None, correct: int | str | bool = "auto", fairness: float = 1,
        new_parameters: bool = False, fill_holes: bool = False, largest_part: bool = False, orient: bool = False,
        drop_degenerate: bool = False, weld: Any = "auto", input_format: str | None = None, columns: Any = None,
        nodata: float | None = None, skip_lines: int | None = None, classes: Any = None, returns: Any = None,
        options: Any = None, nan_policy: NanPolicy = "raise", on_miss: OnMiss = "warn", threads: int = 0,
        progress: ProgressLike = None) -> Fit:
    """Fits one B-spline surface to points, with the fewest control points that hold a tolerance.

    xyz  (n, 3) points; with uv (n, d) or (n,) values of any dimension; (m, n, 3) rows of points; a data frame with
         columns x, y, z (u, v, w, nx, ny, nz); a file that the tool reads
    uv   (n, 2) parameters in [0, 1]; without, points are laid over a base, or are a height field

    Tolerance and size
    tol             largest error: a number in the data's unit, or "0.1%" of the diagonal of the data (height fields: of
                    the range of heights). None: "0.1%" where neither a size nor knots are given
    within          share of the points that must hold it: 0.995 or "99.5%"; None: all
    rms             the root mean square error counts
    control_points  a fixed size, (along u, along v)
    degree          1 to 9, two of them, or "auto"
    max_control_points, max_fits, time_limit (seconds)   where a search ends

    Knots
    knots           a method (knotfit.methods()), (interior u, interior v) in (0, 1), a Surface whose knots and degree
                    are used, or a callable: place(uv, values, interior_u, interior_v) gives two lists of
                    interior knots
    refine          "search" or "insert"
    effort          "fast", "balanced", "best"
    guard, engine   hold a search between the points; "auto", "points", "sample"
    feature         "hessian", "curvature", "derivative", "residual", or an array (cells along u, cells along v) >= 0
    evaluations, smoothing   of evolutionary searches; floor of the least squares, >= 0
    shear           "off", "auto", A in [-1, 1] or ("v", A): oblique parameters of a height field

    Data
    weights         (n,), above 0
    normals         (n, 3), of points without parameters
    height_field    z over x, y
    base            "auto", "plane", "cylinder", "graph", a Surface, or the file of one: what points are laid over
    spacing         of rows: "chord", "centripetal", "uniform"
    rescale_parameters   map the range of uv to [0, 1]
    duplicates      "fail", "mean", "lowest", "highest": of equal parameters
    correct         "auto", False, or rounds: parameters move with the surface; errors are then distances
    corners, omega, fairness, new_parameters, fill_holes, largest_part, orient, drop_degenerate, weld
                    of meshes, and of points that become one (docs/python.md)
    input_format, columns, nodata, skip_lines, classes, returns     of files
    options         those of another fit (Fit.options, or a file that has them) where no keyword is given

    Running
    between         measure the surface between the points
    nan_policy      "raise": a row that is not finite is a ValueError; "omit": it is left out. Masked rows always are
    on_miss         "warn": a KnotfitWarning where the tolerance is not met; "raise": ToleranceMissed; "ignore"
    threads         of this call; 0: as many as there are cores. Results do not depend on it
    progress        True, or a callable that takes a knotfit.Progress; one that returns False stops the fit

    KeyboardInterrupt (knotfit.Interrupted), and what `progress` raises, has the best so far as its attribute `best`, or
    None.
    ValueError, TypeError: a keyword or a row is wrong, which the message names.
    """
    given = _options.changed(USUAL, {k: v for k, v in locals().items() if k in USUAL})
    if _sources.is_path(xyz):
        if uv is not None or weights is not None or normals is not None:
            raise ValueError("uv, weights, normals: are columns of a file; give arrays in its place")
        source = _sources.file(xyz)
        return run(source, given, options=options, threads=threads, progress=progress, on_miss=on_miss, function="fit")
    if hasattr(xyz, "dims") and hasattr(xyz, "coords") and len(xyz.dims) == 2 and uv is None:
        grid = _sources.raster(xyz, None, None, nodata, "omit")
        given.pop("nodata", None)
        assert grid.input is not None
        return run(grid.input, given, options=options, threads=threads, progress=progress, on_miss=on_miss,
                   function="fit", grid=grid)
    for name in ("input_format", "columns", "skip_lines", "classes", "returns", "nodata"):
        if name in given:
            raise ValueError(f"{name}: is for files" + ("; nan_policy and masked arrays are for arrays"
                                                        if name == "nodata" else ""))
    repeated = options if isinstance(options, Mapping) else {}
    moved = (rescale_parameters or new_parameters or height_field or base != "auto" or correct not in ("auto", False, 0)
             or repeated.get("rescale_parameters") or repeated.get("new_parameters") or repeated.get("height_field")
             or repeated.get("base", "auto") != "auto" or options is not None and not isinstance(options, Mapping)
             or repeated.get("correct", "auto") not in ("auto", "off"))
    source = _sources.points(xyz, uv, weights, normals, nan_policy, bool(moved))
    return run(source, given, options=options, threads=threads, progress=progress, on_miss=on_miss, function="fit")


# Defaults of the options, from the signature.
USUAL: dict[str, Any] = {
    name: value for name, value in (fit.__kwdefaults__ or {}).items() if name not in OWN
}
