"""Curves: fits, values, files."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from . import _arrays, _core, _options
from ._arrays import Floats
from ._errors import in_python_words, read_report, translated, with_best
from ._run import ProgressLike, thread_count, watched
from .fit import ErrorSummary, NanPolicy, OnMiss, Tolerance, check_on_miss, settle
from .surface import draw_size, show_picture


class Curve:
    """A B-spline curve C(t) in R^d over [0, 1]; a function y(x) is called with x."""

    __slots__ = ("_document", "__weakref__")
    _document: _core.CurveDocument

    def __init__(self, knots: Any, control_points: Any, degree: int = 3, *, closed: bool = False) -> None:
        """knots  a whole knot vector over [0, 1]; control_points  (n, d) or (n,)"""
        points = _arrays.real(_arrays.plain(control_points, "control_points"), "control_points")
        if points.ndim == 1:
            points = points[:, None]
        net = _arrays.floats(points, "control_points", None, None)
        with translated(rows=False):
            self._document = _core.CurveDocument(int(degree), _arrays.floats(knots, "knots", None), net, closed, False,
                                                 0.0, 1.0)

    @classmethod
    def _of(cls, document: _core.CurveDocument) -> Curve:
        curve = object.__new__(cls)
        curve._document = document
        return curve

    @property
    def knots(self) -> Floats:
        """(n + degree + 1,) over [0, 1]."""
        return self._document.knots

    @property
    def control_points(self) -> Floats:
        """(n, d), or (n,) where d is 1. A copy."""
        points = self._document.control_points
        return points[:, 0] if points.shape[1] == 1 else points

    @property
    def degree(self) -> int:
        return self._document.degree

    @property
    def dimension(self) -> int:
        return int(self._document.control_points.shape[1])

    @property
    def closed(self) -> bool:
        return self._document.closed

    @property
    def function(self) -> bool:
        """It is y over x."""
        return self._document.function

    @property
    def domain(self) -> tuple[float, float]:
        """(0, 1); of a function the range of x."""
        return (self._document.x0, self._document.x1) if self.function else (0.0, 1.0)

    def __call__(self, t: Any, derivative: int = 0) -> Floats:
        """C(t), or its derivative of that order by t (of a function: by x).

        t        any shape, in `domain`; a closed curve goes on, any other is clamped to its ends; NaN gives NaN
        returns  the shape of t, and (d,) behind it where d > 1
        """
        array = np.asarray(_arrays.unmasked(_arrays.real(_arrays.plain(t, "t"), "t"), np.nan), dtype=np.float64)
        if isinstance(derivative, bool) or not hasattr(derivative, "__index__"):
            raise TypeError(f"derivative: takes a whole number, not {type(derivative).__name__}")
        if not 0 <= derivative.__index__() <= 20:
            raise ValueError(f"derivative: {derivative} is no order from 0 to 20")
        first, last = self.domain
        at = (array - first) / (last - first) if self.function else array
        if self.closed:
            at = np.where((at < 0) | (at > 1), at - np.floor(at), at)
        with translated(rows=False):
            values = self._document.values(_arrays.contiguous(at).reshape(-1), int(derivative))
        values /= (last - first) ** derivative
        return values.reshape(array.shape if values.shape[1] == 1 else (*array.shape, values.shape[1]))

    def insert_knots(self, knots: Any) -> Curve:
        """The same curve with more knots of (0, 1)."""
        added = np.sort(_arrays.floats(knots, "knots", None))
        with translated(rows=False):
            return Curve._of(self._document.with_knots(added))

    def to_scipy(self) -> tuple[Floats, Floats, int]:
        """(t, c, k) for scipy.interpolate.BSpline: c is (n, d), or (n,) where d is 1; t in `domain`."""
        first, last = self.domain
        return first + self.knots * (last - first), self.control_points, self.degree

    def to_json(self) -> str:
        """The text of its .json file: numbers round-trip exactly."""
        return self._document.json()

    def save(self, path: str | os.PathLike[str], *, force: bool = False, unit: str = "mm", name: str | None = None,
             step_schema: str = "ap242") -> None:
        """Writes .json, .png .svg .pdf, or .step .stp .igs .iges, whole or not at all."""
        given = _options.changed(_SAVE_USUAL, {"unit": unit, "name": name, "step_schema": step_schema})
        with translated(rows=False):
            self._document.save(os.fspath(path), force, _options.texts("fit-curve", given))

    def draw(self, format: str = "png", *, width: float | None = None, height: float | None = None) -> bytes:
        """The picture: the curve with its knots and control points."""
        with translated(rows=False):
            return _core.draw_curve(self._document, None, "." + format.lstrip("."), *draw_size(width, height))

    def plot(self, ax: Any = None) -> Any:
        """The picture on matplotlib's axes. ImportError: no matplotlib."""
        return show_picture(self.draw("png"), ax)

    def _repr_png_(self) -> bytes | None:
        return self.draw("png", width=1200, height=675) if self.dimension <= 3 else None

    def __repr__(self) -> str:
        kind = "function" if self.function else f"in R^{self.dimension}"
        return (f"<knotfit.Curve {len(self.control_points)} control points, degree {self.degree}, {kind}"
                f"{', closed' if self.closed else ''}>")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Curve):
            return NotImplemented
        return self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[Any, ...]:
        d = self._document
        return d.degree, d.closed, d.function, d.x0, d.x1, d.knots.tobytes(), d.control_points.tobytes()

    def __copy__(self) -> Curve:
        return self  # it never changes

    def __deepcopy__(self, memo: dict[int, Any]) -> Curve:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.to_json(),)


def _restored(text: str) -> Curve:
    return Curve._of(_core.curve_from_json(text))


_SAVE_USUAL = {"unit": "mm", "name": None, "step_schema": "ap242"}


class CurveFit:
    """A curve, and what is known of it: curve, status, reached, message, error, measured, tolerance, errors (n,), t (n,),
    knots, notes, report (as the tool's fit-curve --json). A closed curve's last point that repeats the first is dropped.
    """

    def __init__(self, outcome: _core.CurveOutcome) -> None:
        self._outcome: _core.CurveOutcome | None = outcome
        self.report: dict[str, Any] = read_report(outcome.report())
        report = self.report
        self.curve: Curve = Curve._of(outcome.document)
        self.status: str = report["status"]
        self.message: str = report["message"]
        self.reached: bool = report["reached"]
        self.measured: float = report["measured"]
        self.tolerance: float | None = report["tolerance"]["value"] if report["tolerance"] else None
        self.errors: Floats = outcome.errors
        self.t: Floats = outcome.t
        self.knots: list[float] = report["knots"]
        self.notes: list[str] = report["notes"]
        e = report["error"]
        p99, p995 = (float(np.quantile(self.errors, q)) for q in (0.99, 0.995))
        self.error = ErrorSummary(e["rms"], e["max"], e["mean"], e["median"], e["p95"], p99, p995)

    def save(self, path: str | os.PathLike[str], *, force: bool = False, unit: str = "mm", name: str | None = None,
             step_schema: str = "ap242") -> None:
        """As Curve.save(), with what the fit found, and .csv: the points with t and error."""
        given = _options.changed(_SAVE_USUAL, {"unit": unit, "name": name, "step_schema": step_schema})
        if self._outcome is None:
            return self.curve.save(path, force=force, **given)
        with translated():
            self._outcome.save(os.fspath(path), force, _options.texts("fit-curve", given))

    def draw(self, format: str = "png", *, width: float | None = None, height: float | None = None) -> bytes:
        """The picture: the curve with its knots, control points and the points it was fitted to."""
        with translated():
            return _core.draw_curve(self.curve._document, self._outcome, "." + format.lstrip("."),
                                    *draw_size(width, height))

    def plot(self, ax: Any = None) -> Any:
        """The picture on matplotlib's axes. ImportError: no matplotlib."""
        return show_picture(self.draw("png"), ax)

    def summary(self) -> str:
        """As the tool prints it."""
        return self.message if self._outcome is None else in_python_words(self._outcome.text())

    def _repr_png_(self) -> bytes:
        return self.draw("png", width=1200, height=675)

    def __repr__(self) -> str:
        return f"<knotfit.CurveFit {self.status}: {self.curve!r}, max {self.error.max:.3g}>"

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_outcome": None}


_OWN = {"t", "weights", "nan_policy", "on_miss", "threads", "progress"}


def fit_curve(points: Any, t: Any = None, *, closed: bool = False, function: bool = False, tol: Tolerance = None,
              within: float | str | None = None, rms: bool = False, control_points: int | None = None,
              knots: Any = "optimal", degree: int = 3, corrected: bool = False, spacing: str = "chord",
              max_control_points: int | None = None, max_fits: int | None = None, time_limit: float | None = None,
              feature: Any = "hessian", evaluations: int = 2000, smoothing: float = 1e-12, weights: Any = None,
              nan_policy: NanPolicy = "raise", on_miss: OnMiss = "warn", threads: int = 0,
              progress: ProgressLike = None) -> CurveFit:
    """Fits one B-spline curve to ordered points, with the fewest control points that hold a tolerance.

    points     (n, d) in the order the curve runs through them, or (n,) values with t
    t          (n,) parameters in [0, 1], of a closed curve in [0, 1); default: by `spacing`
    closed     the last point is followed by the first
    function   points (n, 2) are x, y: y over x, x increases
    tol, within, rms, degree, max_*, time_limit, feature, evaluations, smoothing   as fit() has them
    control_points  a fixed size
    knots      a method, or interior knots in (0, 1)
    corrected  move every parameter to the foot of its point on the curve, and fit again
    spacing    "chord", "centripetal", "uniform"
    """
    check_on_miss(on_miss)
    usual = fit_curve.__kwdefaults__ or {}
    given = _options.changed(usual, {k: v for k, v in locals().items() if k in usual and k not in _OWN})
    values, places, weight = _columns(points, t, weights, nan_policy)
    array, kept = values
    if array.ndim == 1:
        if places is None:
            raise ValueError("points: has shape (n,): values need t")
        array = array[:, None]
    if places is not None and not ((places >= 0) & (places <= 1)).all():
        row = int(np.flatnonzero(~((places >= 0) & (places <= 1)))[0])
        raise ValueError(f"t: row {row} is {places[row]}, outside [0, 1]")
    if not isinstance(knots, str):
        given["knots_t"] = _options.knot_list("knots", given.pop("knots"))
    measure = None
    if not isinstance(feature, str):
        measure = _arrays.floats(given.pop("feature"), "feature", None)
    texts = _options.texts("fit-curve", given)
    with translated(), watched(progress) as tell:
        outcome, raised = _core.fit_curve(np.ascontiguousarray(array), places, weight, kept, texts, measure,
                                          thread_count(threads), tell)
    fit = CurveFit(outcome) if outcome is not None else None
    if raised is not None:
        raise with_best(raised, fit)
    if fit is None:
        raise RuntimeError("the fit was stopped before there was a curve")
    if fit.tolerance is not None:
        settle(fit, on_miss, 3)
    return fit


def _columns(points: Any, t: Any, weights: Any, nan_policy: str) -> Any:
    table = _arrays.table(nan_policy, points=points, t=t, weights=weights)
    values, places, weight = table.columns
    assert values is not None
    if values.ndim not in (1, 2):
        raise ValueError(f"points: has shape {values.shape}, not (n, d)")
    for name, column in (("t", places), ("weights", weight)):
        if column is not None and column.ndim != 1:
            raise ValueError(f"{name}: has shape {column.shape}, not (n,)")
    return (values, table.kept), places, weight
